// Recipes that extend others, parameters and expressions.
#include <cmath>
#include <map>

#include "ew/phantom/flow.h"
#include "recipes.h"

namespace ew::recipe_test {
namespace {

using testing::Folder;
using testing::patientRecipe;

/// A ball of skin, a base with two organs and a parameter, and recipes beside it.
class Family : public ::testing::Test {
 protected:
  Family() {
    folder_.write("ball.json", testing::bodyRecipe(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}})"));
    folder_.write("base.json", patientRecipe(R"(
      {"name": "inner", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": ["=size_mm / 2", "=size_mm / 2", "=size_mm / 2"]}}},
      {"name": "outer", "tissue": "smooth", "border": {"echo_level": 9, "width_mm": 1}, "shape": {"of": "wide"}})",
                                             R"("parameters": {"size_mm": {"default": 20, "lowest": 4, "highest": 40, "unit": "mm"}},
      "shapes": [{"name": "wide", "grown": {"of": "skin surface", "by_mm": -20}}],)"));
  }
  Result<std::shared_ptr<const Patient>> extended(const std::string& fields, const ParameterValues& values = {}) {
    return readPatient(folder_.write("patient.json", R"({"format": 1, "name": "child", "extends": "base.json")" + fields + "}"), {},
                       values);
  }
  static std::string organsIn(const Patient& patient) {
    std::string names;
    for (const OrganName& each : organsOf(patient)) names += (names.empty() ? "" : ", ") + each.name;
    return names;
  }
  static double radiusOf(const Patient& patient, const std::string& organ) { return -signedDistance_mm(patient, organ, {0, 0, 0}).value(); }

  Folder folder_;
};

TEST_F(Family, OfARecipeThatAddsNothingIsTheBase) {
  const auto child = extended("");
  ASSERT_TRUE(child) << child.error();
  EXPECT_EQ(organsIn(**child), "inner, outer");
  EXPECT_EQ(radiusOf(**child, "inner"), 10.0);
}

TEST_F(Family, PutsNewOrgansWhereTheyAreAskedToGo) {
  const std::string ball = R"("tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, 5]}}})";
  const auto child = extended(R"(, "organs": [{"name": "first", "before": "inner", )" + ball +
                              R"(, {"name": "middle", "after": "inner", )" + ball + R"(, {"name": "last", )" + ball + "]");
  ASSERT_TRUE(child) << child.error();
  EXPECT_EQ(organsIn(**child), "first, inner, middle, outer, last");
  EXPECT_EQ(labelAt(**child, {0, 0, 0}), 1) << "the first organ that contains a point owns it";
}

TEST_F(Family, ChangesOnlyTheFieldsThatAreGiven) {
  const auto child = extended(R"(, "organs": [{"name": "outer", "tissue": "even", "border": null, "before": "inner"}],
    "tissues": [{"name": "even", "impedance_mrayl": 2}, {"name": "new", "echo_level": 7, "speckle": 1, "scatterers_per_mm3": 3}],
    "shapes": [{"name": "wide", "grown": {"of": "skin surface", "by_mm": -30}}])");
  ASSERT_TRUE(child) << child.error();
  EXPECT_EQ(organsIn(**child), "outer, inner");
  EXPECT_NEAR(radiusOf(**child, "outer"), 30.0, 0.2);
  const auto tissues = readLabelTissues(folder_.path() / "patient.json");
  ASSERT_TRUE(tissues) << tissues.error();
  EXPECT_EQ((*tissues)[1].tissue.name, "even");
  EXPECT_EQ((*tissues)[1].tissue.echoLevel, 100.0);
  EXPECT_EQ((*tissues)[1].tissue.impedance_mrayl, 2.0);
}

TEST_F(Family, RemovesWhatItNames) {
  const auto child = extended(R"(, "remove": {"organs": ["inner"]})");
  ASSERT_TRUE(child) << child.error();
  EXPECT_EQ(organsIn(**child), "outer");
}

TEST_F(Family, GivesParametersFromTheBaseTheChildAndTheUserTheLastOneCounting) {
  EXPECT_EQ(radiusOf(**extended(""), "inner"), 10.0);
  EXPECT_EQ(radiusOf(**extended(R"(, "parameters": {"size_mm": 12})"), "inner"), 6.0);
  const auto child = extended(R"(, "parameters": {"size_mm": 12})", {{"size_mm", 30.0}});
  EXPECT_EQ(radiusOf(**child, "inner"), 15.0);
  ASSERT_EQ(parametersOf(**child).size(), 1u);
  EXPECT_EQ(parametersOf(**child)[0], (PatientParameter{"size_mm", 30.0, 4.0, 40.0, "mm", ""}));
}

TEST_F(Family, LetsAParameterFollowFromOthers) {
  const std::string derived = R"j(, "parameters": {"wall_mm": {"default": 2, "lowest": 0, "highest": 9, "unit": "mm"},
    "size_mm": "=2 * (wall_mm + 7)"})j";
  EXPECT_EQ(radiusOf(**extended(derived), "inner"), 9.0);
  EXPECT_EQ(radiusOf(**extended(derived, {{"wall_mm", 4.0}}), "inner"), 11.0);
}

TEST_F(Family, OfThreeGenerationsIsMergedFromTheOldestOn) {
  folder_.write("parent.json", R"({"format": 1, "name": "parent", "extends": "base.json", "parameters": {"size_mm": 30}})");
  const auto child = readPatient(folder_.write("patient.json", R"({"format": 1, "name": "child", "extends": "parent.json",
    "organs": [{"name": "outer", "tissue": "even"}]})"));
  ASSERT_TRUE(child) << child.error();
  EXPECT_EQ(radiusOf(**child, "inner"), 15.0);
}

TEST_F(Family, ChangesTheFingerprintWithEveryFileAndParameter) {
  const auto file = folder_.write("patient.json", R"({"format": 1, "name": "child", "extends": "base.json"})");
  const auto first = fingerprintOfPatient(file);
  ASSERT_TRUE(first) << first.error();
  EXPECT_EQ(*fingerprintOfPatient(file), *first);
  EXPECT_EQ(*fingerprintOfPatient(file, {}, {{"size_mm", 20.0}}), *first) << "what is the default anyway";
  EXPECT_NE(*fingerprintOfPatient(file, {}, {{"size_mm", 21.0}}), *first);
  folder_.write("base.json", patientRecipe(R"({"name": "inner", "tissue": "dark", "shape": {"of": "skin surface"}})"));
  EXPECT_NE(*fingerprintOfPatient(file), *first);
}

/// The radius that an expression gives, or the sentence that refuses it.
std::string worked(const std::string& expression) {
  const auto patient = testing::patientOf(patientRecipe(
      R"({"name": "egg", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [")" + expression +
          R"(", 50, 50]}}})",
      R"("parameters": {"a": {"default": 8, "lowest": 0, "highest": 9, "unit": "mm"}, "b_2": {"default": "=a / 4", "lowest": 0, "highest": 9, "unit": "mm"}},)"));
  if (!patient) return patient.error().sentence();
  return std::to_string(-signedDistance_mm(**patient, "egg", {0, 0, 0}).value());
}

TEST_F(Family, ChangesStreamsOfBloodByTheirNames) {
  folder_.write("base.json",
                patientRecipe(R"({"name": "vessel", "tissue": "dark", "shape": {"tube": {"points": [[0, 0, -20, 3], [0, 0, 20, 3]]}}})",
                              R"("flow": {"viscosity_mpa_s": 4, "streams": [
                                             {"name": "a", "of": "vessel", "flow_ml_per_min": 100}, {"name": "b", "of": "vessel", "flow_ml_per_min": 50}]},)"));
  const auto child = extended(R"(, "flow": {"viscosity_mpa_s": null, "streams": [{"name": "b", "flow_ml_per_min": 60}]})");
  ASSERT_TRUE(child) << child.error();
  const FlowField& field = flowOf(**child);
  ASSERT_EQ(field.streams.size(), 2u);
  EXPECT_NEAR(field.streams[0].flow_mm3PerS, 100e3 / 60.0, 1e-9);
  EXPECT_NEAR(field.streams[1].flow_mm3PerS, 60e3 / 60.0, 1e-9);
  EXPECT_EQ(field.viscosity_mPaS, 3.5) << "null takes a field away";
}

TEST_F(Family, RefusesAFlowThatIsNone) {
  for (const char* flow : {"5", "[]", R"({"streams": {"name": "a"}})", R"({"waves": 3})"}) {
    folder_.write("base.json",
                  patientRecipe(R"({"name": "vessel", "tissue": "dark", "shape": {"tube": {"points": [[0, 0, -20, 3], [0, 0, 20, 3]]}}})",
                                std::string("\"flow\": ") + flow + ","));
    const auto child = extended(R"(, "flow": {"streams": [{"name": "b", "of": "vessel", "flow_ml_per_min": 60}]})");
    ASSERT_FALSE(child) << flow;
    EXPECT_EQ(child.error().code, ErrorCode::badField) << flow;
  }
}

TEST(Expressions, FollowTheRulesOfArithmetic) {
  const std::map<std::string, double> right{{"=3", 3.0},
                                            {"= 2 + 3 * 4 ", 14.0},
                                            {"=(2 + 3) * 4", 20.0},
                                            {"=20 - 5 - 3", 12.0},
                                            {"=48 / 4 / 2", 6.0},
                                            {"=-3 + 10", 7.0},
                                            {"=2 * -3 + 8", 2.0},
                                            {"=--5", 5.0},
                                            {"=.5e1", 5.0},
                                            {"=a / 2", 4.0},
                                            {"=a*b_2", 16.0},
                                            {"=min(a, b_2, 7)", 2.0},
                                            {"=max(a, 3) + min(1)", 9.0},
                                            {"=max(1, min(a, 5) * 2)", 10.0}};
  for (const auto& [expression, value] : right) EXPECT_EQ(worked(expression), std::to_string(value)) << expression;
}

TEST(Expressions, SayWhatIsWrongAndWhere) {
  const std::map<std::string, std::string> wrong{{"=1 / 0", "a divisor that is not 0"},
                                                 {"=1 / (a - 8)", "a divisor that is not 0"},
                                                 {"=c + 1", "the name of a parameter in place of \"c\" at character 1"},
                                                 {"=1 +", "a number, a name or an opening parenthesis"},
                                                 {"=(1", "a closing parenthesis"},
                                                 {"=1 2", "an operator in place of \"2\""},
                                                 {"=min(1, 2", "a comma or a closing parenthesis"},
                                                 {"=min", "the name of a parameter"},
                                                 {"=1e300 * 1e300", "a result that is finite"},
                                                 {"=1e999", "a number"},
                                                 {"=", "a number, a name"},
                                                 {"=-200", "three radii"},
                                                 {"a / 2", "three numbers"}};
  for (const auto& [expression, expected] : wrong) {
    const std::string said = worked(expression);
    EXPECT_NE(said.find(expected), std::string::npos) << expression << ": " << said;
    EXPECT_NE(said.find("radii_mm"), std::string::npos) << expression << ": " << said;
  }
}

TEST(ShippedPatient, HasAStoneAsLargeAsItsParameterSays) {
  const auto width = [](const Patient& patient) {
    double low = 0.0, high = 0.0;
    const auto inside = [&](double x) { return signedDistance_mm(patient, "gall stone", {-51.4 + x, -24.4, -55.2}).value() < 0.0; };
    while (inside(low)) low -= 0.01;
    while (inside(high)) high += 0.01;
    return high - low;
  };
  EXPECT_NEAR(width(testing::shipped()), 12.0, 0.03);
  const auto larger = readPatient(testing::shippedPatient(), {}, {{"stone_diameter_mm", 12.4}});
  ASSERT_TRUE(larger) << larger.error();
  EXPECT_NEAR(width(**larger), 12.4, 0.05);
}

}  // namespace
}  // namespace ew::recipe_test
