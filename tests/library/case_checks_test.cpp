#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "ew/library/case.h"
#include "library/temporary_folder.h"

namespace ew::case_checks_test {
namespace {

using test::TemporaryFolder;

/// A case that uses every field that has a limit.
Case whole() {
  Case made;
  made.id = "knee";
  made.title = "Knee";
  made.patient = {"Anna", "female", 40};
  made.previousExaminations = {{"in May", "ultrasound", "a cyst", {"media/a.png"}}};
  made.laboratory = {{"in May", "CRP 3"}};
  made.findings = {"A cyst."};
  made.difficulty = 2;
  made.tags = {"knee"};
  made.targets = {{CaseTarget::Kind::point, "cyst", glm::dvec3(1.0), 5.0}};
  CaseMeasurement measured;
  measured.name = "length";
  measured.value = 3.0;
  measured.kind = "distance";
  measured.unit = "mm";
  measured.points_mm = {glm::dvec3(0.0), glm::dvec3(3.0, 0.0, 0.0)};
  made.measurements = {measured};
  made.volume.file = "volumes/knee.mha";
  made.probes = {"linear-12"};
  made.scene.noise.emplace();
  made.otherFields = {{"presets", {"abdomen-convex-3.5"}}, {"volume", {{"licence", "CC0"}}}, {"unknown", 4}};
  return made;
}

std::vector<std::string> sentencesOf(const std::vector<Error>& problems) {
  std::vector<std::string> all;
  for (const Error& each : problems) {
    std::string line = each.sentence();
    for (const auto& [name, value] : each.context) line += " | " + name + ": " + value;
    all.push_back(std::move(line));
  }
  return all;
}

TEST(CaseChecks, FindNothingWrongWithAGoodCase) {
  EXPECT_EQ(sentencesOf(checkCase(whole())), std::vector<std::string>());
  EXPECT_EQ(*caseFromManifest(manifestOf(whole()), {}), whole());
}

struct Wrong {
  const char* field;
  std::function<void(Case&)> spoil;
};

const std::vector<Wrong>& wrongOnes() {
  const std::string longText(300, 'x');
  static const std::vector<Wrong> all = {
      {"id", [](Case& c) { c.id = "no id"; }},
      {"id", [](Case& c) { c.id.clear(); }},
      {"id", [](Case& c) { c.id = std::string(50000, 'a'); }},
      {"title", [](Case& c) { c.title.clear(); }},
      {"title", [longText](Case& c) { c.title = longText; }},
      {"title_for_trainees", [longText](Case& c) { c.titleForTrainees = longText; }},
      {"region", [longText](Case& c) { c.region = longText; }},
      {"patient.name", [longText](Case& c) { c.patient.name = longText; }},
      {"patient.sex", [](Case& c) { c.patient.sex = "unknown"; }},
      {"patient.age_years", [](Case& c) { c.patient.age_years = 131; }},
      {"patient.age_years", [](Case& c) { c.patient.age_years = -1; }},
      {"previous_examinations", [](Case& c) { c.previousExaminations.resize(101); }},
      {"previous_examinations[0].pictures[0]", [](Case& c) { c.previousExaminations[0].images = {""}; }},
      {"previous_examinations[0].pictures", [](Case& c) { c.previousExaminations[0].images = {"../a.png"}; }},
      {"laboratory", [](Case& c) { c.laboratory.resize(101); }},
      {"findings", [](Case& c) { c.findings.resize(101); }},
      {"differential", [](Case& c) { c.differential.resize(101); }},
      {"difficulty", [](Case& c) { c.difficulty = 6; }},
      {"tags[1]",
       [](Case& c) {
         c.tags = {"a", ""};
       }},
      {"targets[0].name", [](Case& c) { c.targets[0].name.clear(); }},
      {"targets[0].tolerance_mm", [](Case& c) { c.targets[0].tolerance_mm = 0.0; }},
      {"targets[0].at_mm", [](Case& c) { c.targets[0].at_mm.reset(); }},
      {"targets[0].label", [](Case& c) { c.targets[0] = {.kind = CaseTarget::Kind::structure, .name = "a", .label = 300}; }},
      {"targets[0].label", [](Case& c) { c.targets[0] = {.kind = CaseTarget::Kind::structure, .name = "a", .label = 3}; }},
      {"targets[0]", [](Case& c) { c.targets[0] = {.kind = CaseTarget::Kind::structure, .name = "a", .organ = "liver"}; }},
      {"targets[0]", [](Case& c) { c.targets[0] = {.kind = CaseTarget::Kind::plane, .name = "a"}; }},
      {"targets[0].probe_to_world",
       [](Case& c) {
         c.targets[0] = {.kind = CaseTarget::Kind::plane, .name = "a"};
         c.targets[0].probeToFile.emplace().matrix = glm::dmat4(2.0);
       }},
      {"measurements[0].name", [](Case& c) { c.measurements[0].name.clear(); }},
      {"measurements[0].tolerance", [](Case& c) { c.measurements[0].tolerance = 0.0; }},
      {"measurements[0].kind", [](Case& c) { c.measurements[0].kind = "colour"; }},
      {"measurements[0].unit", [](Case& c) { c.measurements[0].unit = "inch"; }},
      {"measurements[0].value", [](Case& c) { c.measurements[0].value.reset(); }},
      {"measurements[0].points_mm", [](Case& c) { c.measurements[0].points_mm.resize(1001); }},
      {"volume.recipe_spacing_mm", [](Case& c) { c.volume.recipeSpacing_mm = 11.0; }},
      {"volume.sweeps", [](Case& c) { c.volume.sweeps = {"sweeps/a.json"}; }},
      {"volume.file", [](Case& c) { c.volume.file = "/a.mha"; }},
      {"volume.frames",
       [](Case& c) {
         c.volume.frames = "a.igs.mha";
         c.volume.file.clear();
       }},
      {"volume.file_to_world", [](Case& c) { c.volume.fileToWorld.matrix[0] *= -1.0; }},
      {"volume.licence", [longText](Case& c) { c.otherFields["volume"]["licence"] = longText; }},
      {"start_pose", [](Case& c) { c.startPose.emplace().probeToWorld.matrix[1] *= 3.0; }},
      {"mannequin", [](Case& c) { c.mannequin = "../adult.json"; }},
      {"probes[0]", [](Case& c) { c.probes = {""}; }},
      {"scene.noise.at_face_db", [](Case& c) { c.scene.noise->atFace_db = 500.0; }},
      {"scene.tissues[0].name",
       [longText](Case& c) {
         c.scene.tissues = {{1, longText}};
       }},
      {"presets", [](Case& c) { c.otherFields["presets"] = "abdomen-convex-3.5"; }},
      {"parts.lessons", [](Case& c) { c.otherFields["parts"]["lessons"] = 3; }},
      {"echoes", [](Case& c) { c.otherFields["echoes"] = nlohmann::json::object(); }},
      {"sealed.sha256",
       [](Case& c) {
         c.sealed = {"answers.sealed", "abc"};
       }},
  };
  return all;
}

TEST(CaseChecks, RefuseAValueInTheSentencesThatItsManifestIsRefusedIn) {
  for (const Wrong& each : wrongOnes()) {
    Case spoilt = whole();
    each.spoil(spoilt);
    const auto problems = checkCase(spoilt);
    ASSERT_EQ(problems.size(), 1u) << each.field;
    EXPECT_EQ(problems.front().context.front().second, each.field);
    EXPECT_EQ(sentencesOf(problems), sentencesOf(checkManifest(manifestOf(spoilt), {}))) << each.field;
  }
}

TEST(CaseChecks, RefuseNumbersThatAreNone) {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Wrong> none = {
      {"targets[0].at_mm", [](Case& c) { c.targets[0].at_mm->y = kNone; }},
      {"measurements[0].value", [](Case& c) { c.measurements[0].value = kNone; }},
      {"measurements[0].points_mm[1]", [](Case& c) { c.measurements[0].points_mm[1].z = kNone; }},
      {"volume.recipe_spacing_mm", [](Case& c) { c.volume.recipeSpacing_mm = kNone; }},
  };
  for (const Wrong& each : none) {
    Case spoilt = whole();
    each.spoil(spoilt);
    const auto problems = checkCase(spoilt);
    ASSERT_EQ(problems.size(), 1u) << each.field;
    EXPECT_EQ(problems.front().context.front().second, each.field);
    EXPECT_NE(problems.front().sentence().find("not a number"), std::string::npos) << problems.front();
  }
}

TEST(CaseChecks, RefuseAFileBesideARecipeAndAnotherTissueOfOneLabel) {
  Case both = whole();
  both.volume.recipe = "patient.json";
  ASSERT_EQ(checkCase(both).size(), 1u);
  EXPECT_EQ(checkCase(both).front().context.front().second, "volume");
  Case twice = whole();
  twice.scene.tissues = {{1, "a"}, {1, "b"}};
  ASSERT_EQ(checkCase(twice).size(), 1u);
  EXPECT_EQ(checkCase(twice).front().context.front().second, "scene.tissues[1].label");
}

TEST(CaseChecks, LookForFilesInTheFolderOfTheCaseAlone) {
  const TemporaryFolder folder;
  Case made = whole();
  EXPECT_TRUE(checkCase(made).empty()) << "a case without a folder names what will be there";
  made.folder = folder.path();
  made.previousExaminations.clear();
  ASSERT_EQ(checkCase(made).size(), 1u);
  EXPECT_EQ(checkCase(made).front().code, ErrorCode::notFound);
  EXPECT_EQ(checkCase(made).front().context.front().second, "volume.file");
}

}  // namespace
}  // namespace ew::case_checks_test
