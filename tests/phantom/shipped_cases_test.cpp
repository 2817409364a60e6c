#include <cmath>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "places.h"
#include "recipes.h"

namespace ew::shipped_cases_test {
namespace {

nlohmann::json jsonOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  auto json = nlohmann::json::parse(in, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << file;
  return json;
}

bool conforms(const nlohmann::json& recipe, std::string* why = nullptr, const std::string& kind = "patient") {
  const std::filesystem::path schemas = std::string(EW_SOURCE_DIR) + "/resources/schemas";
  const nlohmann::json text = jsonOf(schemas / (kind + ".schema.json"));
  valijson::Schema schema;
  valijson::SchemaParser parser;
  const valijson::adapters::NlohmannJsonAdapter schemaAdapter(text);
  parser.populateSchema<valijson::adapters::NlohmannJsonAdapter>(
      schemaAdapter, schema, [&](const std::string& name) { return new nlohmann::json(jsonOf(schemas / name)); },
      [](const nlohmann::json* fetched) { delete fetched; });
  valijson::Validator validator;
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter target(recipe);
  const bool good = validator.validate(schema, target, &results);
  valijson::ValidationResults::Error error;
  while (why && results.popError(error)) {
    for (const std::string& step : error.context) *why += step;
    *why += ": " + error.description + "\n";
  }
  return good;
}

class ShippedCase : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static nlohmann::json manifest() {
    return jsonOf(std::filesystem::path(EW_SOURCE_DIR) / "cases" / GetParam() / "case.json");
  }
  [[nodiscard]] static glm::dmat4 startPose() { return matrixFromRows(manifest().at("start_pose").get<std::array<double, 16>>()); }
};

TEST_P(ShippedCase, HasAPatientThatFollowsTheSchema) {
  std::string why;
  EXPECT_TRUE(conforms(jsonOf(testing::shippedPatient(GetParam())), &why)) << why;
}

TEST_P(ShippedCase, StartsWithTheProbeOnTheSkinLookingIn) {
  const glm::dmat4 pose = startPose();
  ASSERT_TRUE(checkRigid(pose));
  const auto body = readBodyShape(testing::shippedMannequin());
  ASSERT_TRUE(body) << body.error();
  const glm::dvec3 face(pose[3]);
  EXPECT_NEAR((*body)->signedDistance_mm(face), -8.0, 1.0) << "pressed on so far that the sides of its curved face touch";
  EXPECT_LT(glm::dot(outwardNormal(**body, face), glm::dvec3(pose[1])), -std::cos(0.5)) << "within 30 degrees of the normal";
}

INSTANTIATE_TEST_SUITE_P(Cases, ShippedCase, ::testing::Values("upper-abdomen-gall-stone", "upper-abdomen-normal"), [](const auto& found) {
  std::string name = found.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(ShippedMannequins, AndTemplatesOfCasesHaveDataThatFollowTheirSchemas) {
  const std::filesystem::path resources = std::string(EW_SOURCE_DIR) + "/resources";
  for (const auto& [folder, kind, count] : {std::tuple{"mannequin/landmarks", "landmarks", 4}, std::tuple{"templates", "template", 6}}) {
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(resources / folder)) {
      std::string why;
      EXPECT_TRUE(conforms(jsonOf(entry.path()), &why, kind)) << entry.path() << ": " << why;
      ++found;
    }
    EXPECT_GE(found, count);
  }
  nlohmann::json wrong = jsonOf(resources / "templates/upper-abdomen.json");
  wrong["difficulty"] = 9;
  EXPECT_FALSE(conforms(wrong, nullptr, "template"));
}

TEST(ShippedMannequins, FollowTheirSchemaAndCanBeRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(testing::shippedMannequin().parent_path())) {
    if (entry.is_directory()) continue;  // their landmarks
    std::string why;
    EXPECT_TRUE(conforms(jsonOf(entry.path()), &why, "mannequin")) << entry.path() << ": " << why;
    EXPECT_TRUE(readBodyShape(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 4);
  nlohmann::json wrong = jsonOf(testing::shippedMannequin());
  wrong["body"]["relief"][0]["height_mm"] = 20;
  EXPECT_FALSE(conforms(wrong, nullptr, "mannequin"));
}

TEST_P(ShippedCase, StartsWithTheMarkerTowardsThePatientsRightOrHead) {
  const glm::dvec3 marked(startPose()[0]);
  EXPECT_GT(std::max(-marked.x, marked.z), 0.7) << "so that the image, marker at the left, has right or head at the left";
}

TEST(GallStoneCase, HasTheStoneAndTheLongGallBladderInTheExpertsImage) {
  const auto manifest = jsonOf(std::string(EW_SOURCE_DIR) + "/cases/upper-abdomen-gall-stone/case.json");
  const glm::dmat4 worldToProbe = glm::inverse(matrixFromRows(manifest.at("expert_pose").get<std::array<double, 16>>()));
  const auto inProbe = [&](const glm::dvec3& p_world) { return glm::dvec3(worldToProbe * glm::dvec4(p_world, 1.0)); };
  const glm::dvec3 stone = inProbe({-51.4, -24.4, -55.2});
  EXPECT_LT(std::abs(stone.z), 3.0) << "the plane cuts the stone near its middle";
  EXPECT_LT(std::abs(stone.x), 15.0);
  EXPECT_NEAR(stone.y, 65.0, 15.0) << "depth";
  for (const glm::dvec3& onAxis : {glm::dvec3(-42, -10, -40), glm::dvec3(-55, -38, -60), glm::dvec3(-63, -55, -71)})
    EXPECT_LT(std::abs(inProbe(onAxis).z), 4.0) << "neck, body and fundus lie in one image";
}

/// A trainee is to look for the finding: nothing that is shown before the examination names it, and the probe does not stand on it.
TEST(ShippedCases, GiveATraineeNoAnswerAway) {
  int cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(EW_SOURCE_DIR) + "/cases")) {
    if (!std::filesystem::exists(entry.path() / "case.json")) continue;
    const auto manifest = jsonOf(entry.path() / "case.json");
    ++cases;
    ASSERT_TRUE(manifest.contains("title_for_trainees")) << entry;
    ASSERT_TRUE(manifest.contains("expert_pose")) << entry;
    std::string shown = manifest["title_for_trainees"];
    for (const char* list : {"targets", "measurements"}) {
      for (const auto& each : manifest.value(list, nlohmann::json::array()))
        if (!each.value("reveals_finding", false)) shown += ", " + each["name"].get<std::string>();
    }
    for (const char* answer : {"aneurysm", "stone", "thrombus", "free fluid", "normal", "nodule", "plaque"}) {
      EXPECT_EQ(shown.find(answer), std::string::npos) << entry << " says " << answer << " in: " << shown;
    }
    const glm::dmat4 start = matrixFromRows(manifest.at("start_pose").get<std::array<double, 16>>());
    EXPECT_TRUE(checkRigid(start)) << entry;
    const glm::dmat4 expert = matrixFromRows(manifest.at("expert_pose").get<std::array<double, 16>>());
    if (manifest["volume"].contains("recipe")) {
      EXPECT_GT(-start[0].x, 0.99) << "transverse, the marker to the patient's right: " << entry;
      EXPECT_LT(std::abs(start[3].x), 1.0) << "in the midline: " << entry;
      EXPECT_NE(start, expert) << entry;
    } else {  // a recording reaches no farther than the probe did: it cannot begin in the midline, but away from the finding
      EXPECT_GT(-start[0].x, 0.7) << "the marker to the patient's right: " << entry;
      const double turned_deg = glm::degrees(std::acos(glm::dot(glm::dvec3(start[2]), glm::dvec3(expert[2]))));
      EXPECT_GT(turned_deg, 15.0) << "another plane than the expert's: " << entry;
    }
  }
  EXPECT_EQ(cases, 7);
}

TEST(PatientSchema, HoldsForEveryRecipeOfTheCasesAndAnatomies) {
  int recipes = 0;
  const auto check = [&](const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return;
    ++recipes;
    std::string why;
    EXPECT_TRUE(conforms(jsonOf(file), &why)) << file << "\n" << why;
  };
  for (const auto& entry : std::filesystem::directory_iterator(std::string(EW_SOURCE_DIR) + "/cases")) check(entry.path() / "patient.json");
  for (const auto& entry : std::filesystem::directory_iterator(std::string(EW_SOURCE_DIR) + "/resources/anatomy")) check(entry.path());
  EXPECT_GE(recipes, 5);
}

TEST(PatientSchema, RefusesWhatTheReaderRefuses) {
  const std::string ball = R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, 5]}})";
  const auto recipeWith = [](const std::string& organ) { return nlohmann::json::parse(testing::patientRecipe(organ)); };
  EXPECT_TRUE(conforms(recipeWith(R"({"name": "egg", "tissue": "dark", "shape": )" + ball + "}")));
  for (const std::string& organ :
       {R"({"name": "egg", "tissue": "dark", "colour": 3, "shape": )" + ball + "}", std::string(R"({"name": "egg", "tissue": "dark"})"),
        std::string(R"({"name": "egg", "tissue": "dark", "shape": {}})"),
        std::string(R"({"name": "egg", "tissue": "dark", "shape": {"of": "a", "grown": {"of": "a", "by_mm": 1}}})"),
        R"({"name": "egg", "tissue": "dark", "border": {"echo_level": 300, "width_mm": 1}, "shape": )" + ball + "}"}) {
    EXPECT_FALSE(conforms(recipeWith(organ))) << organ;
    EXPECT_FALSE(testing::patientOf(testing::patientRecipe(organ))) << organ;
  }
}

}  // namespace
}  // namespace ew::shipped_cases_test
