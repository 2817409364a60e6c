// Recipes that are small to read and endless to work out, and bases that are not what they should be.
#include <atomic>

#include "ew/phantom/label_grid.h"
#include "ew/phantom/truth.h"
#include "phantom/recipes.h"

namespace ew::phantom_limits_test {
namespace {

using testing::bodyRecipe;
using testing::Folder;
using testing::patientRecipe;

const std::string kBall = R"("shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, 5]}})";
const std::string kEgg = R"({"name": "egg", "tissue": "dark", )" + kBall + "}";

std::string parameter(const std::string& value) { return R"({"default": )" + value + R"(, "lowest": 0, "highest": 9, "unit": "mm"})"; }

/// p0 rests on p1, which rests on p2 ... : `count` of them in a row.
std::string chainOf(int count, bool lastFirst = false) {
  const auto nameOf = [&](int n) {
    std::string digits = std::to_string(lastFirst ? count - 1 - n : n);
    return "p" + std::string(6 - digits.size(), '0') + digits;
  };
  std::string parameters;
  for (int n = 0; n < count; ++n)
    parameters += (n == 0 ? "" : ", ") + ("\"" + nameOf(n) + "\": ") + parameter(n + 1 < count ? "\"=" + nameOf(n + 1) + "\"" : "3");
  return "\"parameters\": {" + parameters + "},";
}

class HardLimits : public ::testing::Test {
 protected:
  HardLimits() { folder_.write("ball.json", bodyRecipe(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}})")); }
  /// The sentence that refuses a recipe; empty when it is read. Whoever looks at it without building it gets the same one.
  std::string refusal(const std::string& recipe, Progress& progress = noProgress()) {
    const auto file = folder_.write("patient.json", recipe);
    const auto patient = readPatient(file, {}, {}, progress);
    return patient ? "" : patient.error().sentence();
  }
  std::string fingerprintRefusal() {
    const auto print = fingerprintOfPatient(folder_.path() / "patient.json");
    return print ? "" : print.error().sentence();
  }
  static bool names(const std::string& sentence, const std::string& words) { return sentence.find(words) != std::string::npos; }

  Folder folder_;
};

TEST_F(HardLimits, ParametersThatRestOnOneAnotherInALongRowAreRefusedWhoeverIsAskedFirst) {
  EXPECT_EQ(refusal(patientRecipe(kEgg, chainOf(20))), "");
  EXPECT_EQ(refusal(patientRecipe(kEgg, chainOf(20, true))), "");
  for (const bool lastFirst : {false, true}) {
    EXPECT_TRUE(names(refusal(patientRecipe(kEgg, chainOf(21, lastFirst))), "at most 20 rest on one another"));
    EXPECT_TRUE(names(fingerprintRefusal(), "at most 20 rest on one another"));
  }
  EXPECT_TRUE(names(refusal(patientRecipe(kEgg, chainOf(900))), "at most 20 rest on one another"));
}

TEST_F(HardLimits, ParametersThatRestOnOneAnotherThroughNestedExpressionsAreRefusedToo) {
  std::string parameters;
  for (int n = 0; n < 900; ++n)
    parameters += "\"p" + std::to_string(n) + "\": " +
                  parameter("\"=" + std::string(45, '(') + "min(p" + std::to_string(n + 1) + ", 4)" + std::string(45, ')') + "\"") + ", ";
  parameters += "\"p900\": " + parameter("3");
  EXPECT_TRUE(names(refusal(patientRecipe(kEgg, "\"parameters\": {" + parameters + "},")), "it must be"));
}

TEST_F(HardLimits, TensOfThousandsOfParametersOrEntriesAreRefusedByTheirNumber) {
  EXPECT_TRUE(names(refusal(patientRecipe(kEgg, chainOf(20000))), "at most 1000 entries"));
  std::string tissues;
  for (int n = 0; n < 100000; ++n) tissues += ", {\"name\": \"t" + std::to_string(n) + "\"}";
  std::string recipe = patientRecipe(kEgg);
  recipe.insert(recipe.find("}],") + 1, tissues);
  EXPECT_TRUE(names(refusal(recipe), "at most 1000 entries"));
}

TEST_F(HardLimits, ChainsThroughRecipesThatExtendOneAnotherAreAsLongAsInOne) {
  folder_.write("base.json", patientRecipe(kEgg, chainOf(20)));
  std::string child = R"({"format": 1, "name": "child", "extends": "base.json", "parameters": {"p000019": {"default": "=q"}, "q": )" +
                      parameter("2") + "}}";
  EXPECT_TRUE(names(refusal(child), "at most 20 rest on one another"));
}

TEST_F(HardLimits, TextsAndNamesOfMegabytesAreRefused) {
  const std::string long_ = std::string(1 << 20, 'a');
  EXPECT_TRUE(names(refusal(patientRecipe(R"({"name": ")" + long_ + R"(", "tissue": "dark", )" + kBall + "}")), "it must be"));
  EXPECT_TRUE(names(refusal(patientRecipe(kEgg, R"("note": ")" + long_ + R"(",)")), "at most 10000"));
  const std::string sentence = refusal(patientRecipe(kEgg, "\"" + long_ + "\": [[[[1, 2, 3]]]],"));
  EXPECT_TRUE(names(sentence, "at most 200"));
  EXPECT_LT(sentence.size(), 1000u);
}

TEST_F(HardLimits, BasesThatAreNotWhatTheyShouldBeAreSentences) {
  const std::string tail = R"(, "organs": [)" + kEgg + "]}";
  for (const char* base : {R"({"format": 1, "name": "b", "parameters": {"a": 1}})", R"({"format": 1, "name": "b", "parameters": [1]})",
                           R"({"format": 1, "name": "b", "parameters": {"a": [1]}})", R"({"format": 1, "name": "b", "parameters": "a"})",
                           R"({"format": 1, "name": "b", "organs": {"egg": 1}})", R"({"format": 1, "name": "b", "organs": "egg"})",
                           R"({"format": 1, "name": "b", "organs": 3})", R"({"format": 1, "name": "b", "organs": [3, "egg", null]})",
                           R"({"format": 1, "name": "b", "tissues": true})", R"({"format": 1, "name": "b", "shapes": {"name": "egg"}})",
                           R"({"format": 1, "name": "b", "motion": 3})", R"({"format": 1, "name": "b", "organs": [{"name": 3}]})"}) {
    folder_.write("base.json", base);
    for (const char* more :
         {R"("parameters": {"a": 2})", R"("parameters": {"a": {"default": 2}})", R"("remove": {"organs": ["egg"]})",
          R"("remove": {"organs": ["egg"], "tissues": ["egg"]})", R"("organs": [{"name": "egg", "before": "egg"}])",
          R"("shapes": [{"name": "egg", "after": "egg"}])", R"("motion": {"breathing": {"period_s": 4}})", R"("remove": 3)"}) {
      std::string sentence;
      EXPECT_NO_THROW(sentence = refusal(std::string(R"({"format": 1, "name": "c", "extends": "base.json", )") + more + "}"))
          << base << " with " << more;
      EXPECT_NE(sentence, "") << base << " with " << more;
      EXPECT_NO_THROW(fingerprintRefusal()) << base << " with " << more;
    }
  }
}

/// s1 is s0 with itself, s2 is s1 with itself ...
std::string doubled(int times, const std::string& how) {
  std::string shapes = R"({"name": "s0", "ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, 5]}})";
  for (int n = 1; n <= times; ++n) {
    const std::string before = R"({"of": "s)" + std::to_string(n - 1) + R"("})";
    shapes += R"(, {"name": "s)" + std::to_string(n) + R"(", ")" + how + R"(": [)" + before + ", " + before + "]}";
  }
  return "\"shapes\": [" + shapes + "],";
}

TEST_F(HardLimits, ShapesThatUseOneAnotherTwiceAreRefusedBeforeTheyAreEvaluated) {
  const std::string organ = R"({"name": "egg", "tissue": "dark", "shape": {"of": "s4"}})";
  for (const char* how : {"union", "intersection", "difference"}) {
    EXPECT_EQ(refusal(patientRecipe(organ, doubled(4, how))), "") << how;
    EXPECT_TRUE(names(refusal(patientRecipe(organ, doubled(36, how))), "at most 20000 solids")) << how;
    EXPECT_TRUE(names(refusal(patientRecipe(organ, doubled(190, how))), "at most 20000 solids")) << how;
  }
}

TEST_F(HardLimits, ShapesThatUseOneAnotherInALongRowAreRefusedBeforeTheStackIsUsedUp) {
  std::string shapes = R"({"name": "s0", "ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, 5]}})";
  for (int n = 1; n < 190; ++n)
    shapes += R"(, {"name": "s)" + std::to_string(n) + R"(", "grown": {"of": "s)" + std::to_string(n - 1) + R"(", "by_mm": 0.1}})";
  EXPECT_TRUE(
      names(refusal(patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"of": "s189"}})", "\"shapes\": [" + shapes + "],")),
            "100 shapes inside one another"));
}

TEST_F(HardLimits, OrgansThatAreTooMuchTogetherAreRefused) {
  std::string organs;
  for (int n = 0; n < 100; ++n)
    organs += (n == 0 ? "" : ", ") + (R"({"name": "o)" + std::to_string(n)) + R"(", "tissue": "dark", "shape": {"of": "s9"}})";
  EXPECT_TRUE(names(refusal(patientRecipe(organs, doubled(9, "union"))), "at most 50000"));
}

TEST_F(HardLimits, ABodyIsHeldToTheSameLimits) {
  std::string shape = R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}})";
  std::string many = shape;
  for (int n = 0; n < 200; ++n) many += ", " + shape;
  many = R"({"union": [)" + many + "]}";
  std::string all = many;
  for (int n = 0; n < 120; ++n) all += ", " + many;
  const auto body = readBodyShape(folder_.write("body.json", bodyRecipe(R"({"union": [)" + all + "]}")));
  ASSERT_FALSE(body);
  EXPECT_TRUE(names(body.error().sentence(), "at most 20000 solids")) << body.error();
}

TEST_F(HardLimits, ABoxLargerThanACubicMetreIsRefused) {
  std::string recipe = patientRecipe(kEgg);
  recipe.replace(recipe.find("[-40, -40, -40]"), 15, "[-1000, -1000, -1000]");
  EXPECT_TRUE(names(refusal(recipe), "larger than a cubic metre"));
}

/// Counts how often it is asked whether to stop, and says so from the given time on.
class Asked final : public Progress {
 public:
  explicit Asked(int stopAt = 1 << 30) : stopAt_(stopAt) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return ++times_ > stopAt_; }
  [[nodiscard]] int times() const { return times_; }

 private:
  int stopAt_;
  mutable std::atomic<int> times_{0};
};

// An anatomy within the limits may take a millisecond for one point: who waits for the end of a task waits for minutes.
TEST_F(HardLimits, WhoeverVoxelisesLooksAtTheWishToStopAtEveryRowOfABlock) {
  const auto patient = readPatient(folder_.write("patient.json", patientRecipe(kEgg)));
  ASSERT_TRUE(patient) << patient.error();
  Asked asked;
  ASSERT_TRUE(voxelise(**patient, {.spacing_mm = 10.0, .threads = 1}, asked));
  EXPECT_GT(asked.times(), 81) << "9 x 9 rows of voxels";
  Asked soon(20);
  const auto made = voxelise(**patient, {.spacing_mm = 10.0, .threads = 1}, soon);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::cancelled);
  EXPECT_LT(soon.times(), 60);
}

TEST_F(HardLimits, WhoeverLabelsReadsOrMeasuresLooksAtTheWishToStopAllAlong) {
  const std::string measured = R"("measurements": [{"name": "size", "kind": "extent", "of": "egg", "direction": [1, 0, 0]},
    {"name": "ml", "kind": "volume", "of": "egg"}, {"name": "around", "kind": "circumference", "of": "egg", "at_mm": [0, 0, 0]}],)";
  const std::string recipe = patientRecipe(
      kEgg, measured + R"("motion": {"breathing": {"displacement_mm": [0, 0, -10], "held_depth_mm": 5, "free_depth_mm": 30}},)");
  EXPECT_EQ(refusal(recipe), "");
  for (const int stopAt : {0, 1, 40, 300}) {
    Asked reading(stopAt);
    EXPECT_TRUE(names(refusal(recipe, reading), "stopped")) << stopAt;
  }
  const auto patient = readPatient(folder_.path() / "patient.json");
  ASSERT_TRUE(patient) << patient.error();
  const auto cancelled = [](const auto& result) { return !result && result.error().code == ErrorCode::cancelled; };
  for (const int stopAt : {0, 5, 40}) {
    Asked measuring(stopAt), drawing(stopAt);
    EXPECT_TRUE(cancelled(measurementsOf(**patient, {}, measuring))) << stopAt;
    EXPECT_TRUE(cancelled(surfaceOf(**patient, "egg", 0.5, drawing))) << stopAt;
    Asked labelling(stopAt);
    Grid grid;
    grid.dims = glm::ivec3(40);
    grid.spacing_mm = glm::dvec3(1.0);
    grid.origin_mm = glm::dvec3(-20.0);
    EXPECT_TRUE(cancelled(labelsOn(**patient, grid, 1, labelling, 1u << 30))) << stopAt;
  }
}

TEST_F(HardLimits, ALineThatWouldBeWalkedForHoursIsRefused) {
  EXPECT_TRUE(names(refusal(patientRecipe(kEgg, R"("measurements": [{"name": "far", "kind": "distance", "of": "egg",
    "from_mm": [-100000, 0, 0], "to_mm": [100000, 0, 0]}],)")),
                    "at most 5000 mm apart"));
}

}  // namespace
}  // namespace ew::phantom_limits_test
