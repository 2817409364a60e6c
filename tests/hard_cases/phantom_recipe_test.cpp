// Recipes that extend others and parameters, at the edges.
#include "phantom/recipes.h"

namespace ew::phantom_recipe_test {
namespace {

using testing::Folder;
using testing::patientRecipe;

const char* const kBall = R"("tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, 5]}})";

std::string child(const std::string& base, const std::string& more = "") {
  return R"({"format": 1, "name": "child", "extends": ")" + base + "\"" + more + "}";
}

class HardFamilies : public ::testing::Test {
 protected:
  HardFamilies() {
    folder_.write("ball.json", testing::bodyRecipe(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}})"));
    folder_.write("base.json", patientRecipe(std::string(R"({"name": "egg", )") + kBall + "}"));
  }
  /// The sentence that refuses a recipe; empty when it is read.
  std::string refusal(const std::string& recipe, ErrorCode code = ErrorCode::badField, const ParameterValues& values = {}) {
    const auto file = folder_.write("patient.json", recipe);
    const auto patient = readPatient(file, {}, values);
    if (patient) return "";
    EXPECT_EQ(patient.error().code, code) << patient.error();
    return patient.error().sentence();
  }
  static bool names(const std::string& sentence, const std::string& words) { return sentence.find(words) != std::string::npos; }

  Folder folder_;
};

TEST_F(HardFamilies, ThatGoRoundInACircleAreRefused) {
  folder_.write("a.json", child("patient.json"));
  EXPECT_TRUE(names(refusal(child("a.json")), "does not extend this one in turn"));
  EXPECT_TRUE(names(refusal(child("patient.json")), "does not extend this one in turn"));
}

TEST_F(HardFamilies, OfMoreThanEightGenerationsAreRefused) {
  folder_.write("g1.json", child("base.json"));
  for (int n = 2; n <= 9; ++n) folder_.write("g" + std::to_string(n) + ".json", child("g" + std::to_string(n - 1) + ".json"));
  EXPECT_EQ(refusal(child("g6.json")), "");
  EXPECT_TRUE(names(refusal(child("g7.json")), "at most 8 recipes"));
}

TEST_F(HardFamilies, WhoseBaseIsMissingOrInAnotherFolderSaySo) {
  EXPECT_TRUE(names(refusal(child("none.json"), ErrorCode::notFound), "extends none.json"));
  for (const char* elsewhere : {"../base.json", "/etc/passwd", "sub/base.json"})
    EXPECT_TRUE(names(refusal(child(elsewhere)), "without a folder")) << elsewhere;
}

TEST_F(HardFamilies, ThatChangeWhatIsNotThereSaySo) {
  EXPECT_TRUE(names(refusal(child("base.json", R"(, "remove": {"organs": ["liver"]})")), "remove.organs"));
  EXPECT_TRUE(names(refusal(child("base.json", R"(, "remove": {"ribs": ["liver"]})")), "remove.ribs"));
  EXPECT_TRUE(names(refusal(child("base.json", std::string(R"(, "organs": [{"name": "new", "before": "liver", )") + kBall + "}]")),
                    "organs[0].before"));
  EXPECT_TRUE(
      names(refusal(child("base.json", std::string(R"(, "organs": [{"name": "new", "before": "egg", "after": "egg", )") + kBall + "}]")),
            "one of them"));
  EXPECT_TRUE(
      names(refusal(child("base.json", std::string(R"(, "organs": [{"name": "egg", "before": "egg", )") + kBall + "}]")), "another"));
  EXPECT_TRUE(names(refusal(child("base.json", R"(, "parameters": {"size_mm": 3})")), "parameters.size_mm"));
  EXPECT_TRUE(names(refusal(child("base.json", R"(, "organs": {"egg": 1})")), "a list"));
  EXPECT_TRUE(names(refusal(child("base.json", R"(, "organs": [3])")), "organs[0]"));
  EXPECT_TRUE(names(refusal(patientRecipe(std::string(R"({"name": "egg", "before": "egg", )") + kBall + "}")), "before"));
  EXPECT_TRUE(names(refusal(patientRecipe(std::string(R"({"name": "egg", )") + kBall + "}", R"("remove": {},)")), "remove"));
}

TEST_F(HardFamilies, ThatRemoveEveryOrganAreRefused) {
  EXPECT_TRUE(names(refusal(child("base.json", R"(, "remove": {"organs": ["egg"]})")), "organs"));
}

TEST_F(HardFamilies, WithAParameterOutOfItsRangeSayTheRange) {
  const std::string recipe = patientRecipe(std::string(R"({"name": "egg", )") + kBall + "}",
                                           R"("parameters": {"size_mm": {"default": 20, "lowest": 4, "highest": 40, "unit": "mm"}},)");
  EXPECT_EQ(refusal(recipe, ErrorCode::badField, {{"size_mm", 40.0}}), "");
  for (const double value : {3.9, 41.0, -1e9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(names(refusal(recipe, ErrorCode::badField, {{"size_mm", value}}), "a number from 4 to 40")) << value;
  EXPECT_TRUE(names(refusal(recipe, ErrorCode::badField, {{"width_mm", 5.0}}), "one of size_mm"));
}

TEST_F(HardFamilies, WithParametersThatDependOnOneAnotherInACircleAreRefused) {
  const std::string recipe = patientRecipe(std::string(R"({"name": "egg", )") + kBall + "}",
                                           R"("parameters": {"a": {"default": "=b + 1", "lowest": 0, "highest": 9, "unit": "mm"},
                                              "b": {"default": "=a - 1", "lowest": 0, "highest": 9, "unit": "mm"}},)");
  EXPECT_TRUE(names(refusal(recipe), "in a circle"));
}

TEST_F(HardFamilies, WithParametersThatAreNotDescribedInFullAreRefused) {
  for (const char* parameters : {R"({"a": 3})", R"({"a": {"default": 3}})", R"({"a": {"lowest": 0, "highest": 1, "unit": "mm"}})",
                                 R"({"A b": {"default": 3, "lowest": 0, "highest": 9, "unit": "mm"}})",
                                 R"({"min": {"default": 3, "lowest": 0, "highest": 9, "unit": "mm"}})",
                                 R"({"a": {"default": [], "lowest": 0, "highest": 9, "unit": "mm"}})", R"([1, 2])"})
    EXPECT_TRUE(
        names(refusal(patientRecipe(std::string(R"({"name": "egg", )") + kBall + "}", std::string(R"("parameters": )") + parameters + ",")),
              "parameters"))
        << parameters;
}

TEST_F(HardFamilies, WithAnExpressionOfAThousandParenthesesAreRefused) {
  const std::string deep = "=" + std::string(450, '(') + "1" + std::string(450, ')');
  const std::string longer = "=" + std::string(100000, '-') + "1";
  for (const std::string& expression : {deep, longer})
    EXPECT_TRUE(names(
        refusal(patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, ")" +
                              expression + "\"]}}}")),
        "it must be"));
}

TEST_F(HardFamilies, WhoseMotionWouldFoldTissueAreRefused) {
  const auto moving = [](const std::string& motion) {
    return patientRecipe(R"({"name": "pipe", "tissue": "dark", "shape": {"tube": {"points": [[0, 0, -30, 4], [0, 0, 30, 4]]}}},
                            {"name": "bow", "tissue": "dark", "shape": {"tube": {"points": [[0, 20, -10, 2], [0, 20, 20, 2], [0, 25, 0, 2]]}}})",
                         R"("motion": )" + motion + ",");
  };
  EXPECT_EQ(refusal(moving(R"({"breathing": {"displacement_mm": [0, 0, -10], "held_depth_mm": 5, "free_depth_mm": 30}})")), "");
  for (const char* motion :
       {R"({"breathing": {"displacement_mm": [0, 0, -30], "held_depth_mm": 5, "free_depth_mm": 15}})",
        R"({"breathing": {"displacement_mm": [0, 0, 30], "grows_along_z_mm": [10, 20]}})",
        R"({"breathing": {"displacement_mm": [0, 0, -61]}})", R"({"breathing": {"displacement_mm": [0, 0, -3], "held_by": ["liver"]}})",
        R"({"breathing": {"displacement_mm": [0, 0, -3], "held_depth_mm": 9, "free_depth_mm": 9}})",
        R"({"pulse": {"vessels": [{"of": "pipe", "diameter_growth_mm": 12, "reach_mm": 3}]}})",
        R"({"pulse": {"vessels": [{"of": "bow", "diameter_growth_mm": 0.1}]}})",
        R"({"pulse": {"vessels": [{"of": "skin surface", "diameter_growth_mm": 0.1}]}})", R"({"pulse": {"vessels": []}})",
        R"({"pulse": {"beats_per_minute": 0, "vessels": [{"of": "pipe", "diameter_growth_mm": 1}]}})"})
    EXPECT_TRUE(names(refusal(moving(motion)), "motion")) << motion;
}

}  // namespace
}  // namespace ew::phantom_recipe_test
