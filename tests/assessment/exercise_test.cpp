#include "ew/assessment/exercise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../tracking/skins.h"
#include "ew/scanning/contact.h"

namespace ew {
namespace {

/// A trunk of 120 mm with a ball, an organ that fills half of everything, and one that no voxel has.
class ExercisesOfATrunk : public testing::Test {
 protected:
  ExercisesOfATrunk() {
    auto labels = std::make_shared<Volume>();
    labels->grid.dims = {120, 60, 100};
    labels->grid.spacing_mm = glm::dvec3(2.0);
    labels->grid.origin_mm = {-119.0, -129.0, -99.0};
    labels->echo.assign(labels->grid.voxelCount(), 0);
    for (int k = 0; k < 100; ++k)
      for (int j = 0; j < 60; ++j)
        for (int i = 0; i < 120; ++i) {
          const glm::dvec3 p = carried(labels->grid.voxelToWorld(), glm::dvec3(i, j, k));
          std::uint8_t& label = labels->echo[labels->grid.indexOf(i, j, k)];
          if (std::hypot(p.x, p.y) > 118.0) continue;
          label = p.x > 0.0 ? 2 : 0;
          if (glm::distance(p, glm::dvec3(-30.0, -70.0, 20.0)) < 12.0) label = 1;
        }
    ground_.skin = std::make_shared<test::CylinderSkin>(120.0);
    ground_.labels = labels;
    ground_.region.placedGrid = labels->grid;
    ground_.probe.kind = ProbeKind::convex;
    ground_.probe.radius_mm = 60.0;
    ground_.probe.halfAngle_rad = 0.54;
    ground_.probe.defaultDepth_mm = 100.0;
    Hold hold;
    hold.contact = ground_.skin->nearest({-30.0, -500.0, 20.0});
    hold.press_mm = usualPress_mm(ground_.probe);
    ReferencePlane plane;
    plane.name = "across the ball";
    plane.probeToWorld = poseOf(hold).probeToWorld;
    ReferencePlane inside = plane;
    inside.name = "from within";
    inside.probeToWorld.matrix[3] = glm::dvec4(0.0, -20.0, 0.0, 1.0);
    ground_.truth.planes = {plane, inside};
    ground_.truth.structures = {{"ball", "ball", 1}, {"half", "half", 2}, {"nothing", "nothing", 3}};
    ReferenceMeasurement width{"ball, width", "diameter", 24.0, "mm", 2.0, {{-42.0, -70.0, 20.0}, {-18.0, -70.0, 20.0}}, plane.name};
    ReferenceMeasurement fine = width;
    fine.name = "wall";
    fine.tolerance = 0.3;
    ReferenceMeasurement volume{"ball, volume", "volume", 7.2, "ml", 1.0, {}, {}};
    ReferenceMeasurement other = width;
    other.name = "what its points do not read";
    other.value = 20.0;
    ground_.truth.measurements = {width, fine, volume, other};
    edited_.id = "trunk";
    CaseTarget target;
    target.name = "ball";
    target.revealsFinding = true;
    edited_.targets = {target};
  }

  [[nodiscard]] Exercise offered(const std::string& target) const {
    const auto list = exercisesOf(edited_, ground_);
    for (const Exercise& each : list.offered)
      if (each.target == target) return each;
    ADD_FAILURE() << target << " is not offered";
    return {};
  }

  Case edited_;
  ExerciseGround ground_;
};

TEST_F(ExercisesOfATrunk, AreThoseThatCanBeSolvedAndNotByChance) {
  const auto list = exercisesOf(edited_, ground_);
  std::vector<std::string> ids;
  for (const Exercise& each : list.offered) ids.push_back(each.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"trunk/plane/across the ball", "trunk/point/ball", "trunk/measure/ball, width"}));
  std::vector<std::string> why;
  for (const WithheldExercise& each : list.withheld) why.push_back(each.exercise.target + ": " + each.why.english());
  EXPECT_EQ(why, (std::vector<std::string>{
                     "from within: The plane cannot be reached from the skin.",
                     "half: It fills so much of most images that pointing at random would do.", "nothing: The case has no voxels of it.",
                     "wall: Its tolerance is finer than calipers can be set.", "ball, volume: Calipers alone cannot measure it.",
                     "what its points do not read: Its points do not read its value."}));
}

TEST_F(ExercisesOfATrunk, KeepBackWhatGivesAFindingAway) {
  EXPECT_TRUE(offered("ball").revealsFinding);
  EXPECT_FALSE(offered("across the ball").revealsFinding);
}

TEST_F(ExercisesOfATrunk, NeverBeginSolved) {
  const Exercise plane = offered("across the ball"), point = offered("ball");
  for (int level = 1; level <= kExerciseLevels; ++level)
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto atPlane = startOf(plane, ground_, level, seed);
      ASSERT_TRUE(atPlane);
      EXPECT_TRUE(isScannable(ground_.region, atPlane->contact));
      ExerciseAnswer answer;
      answer.pose = poseOf(*atPlane);
      EXPECT_FALSE(judgeExercise(plane, ground_, level, answer).passed());
      const auto atPoint = startOf(point, ground_, level, seed);
      ASSERT_TRUE(atPoint);
      EXPECT_EQ(sectionOf(*ground_.labels, 1, ground_.fan(), poseOf(*atPoint)).area_mm2, 0.0);
      EXPECT_EQ(startOf(plane, ground_, level, seed), atPlane) << "the same for the same seed";
    }
}

TEST_F(ExercisesOfATrunk, BeginNearerOnLowerLevels) {
  const Exercise plane = offered("across the ball");
  const glm::dvec3 at(ground_.truth.planes.front().probeToWorld.matrix[3]);
  double first = 0.0, last = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const double near_mm = glm::distance(startOf(plane, ground_, 1, seed)->contact.point_mm, at);
    EXPECT_LT(near_mm, 65.0);
    first += near_mm;
    last += glm::distance(startOf(plane, ground_, 5, seed)->contact.point_mm, at);
  }
  EXPECT_LT(first, 0.7 * last);
}

TEST_F(ExercisesOfATrunk, ArePassedByWhoKnows) {
  for (int level = 1; level <= kExerciseLevels; ++level) {
    ExerciseAnswer answer;
    answer.pose.probeToWorld = ground_.truth.planes.front().probeToWorld;
    EXPECT_TRUE(judgeExercise(offered("across the ball"), ground_, level, answer).passed());
    const auto view = viewOfOrgan(ground_, 1);
    ASSERT_TRUE(view);
    const OrganSection section = sectionOf(*ground_.labels, 1, ground_.fan(), poseOf(*view));
    EXPECT_GT(section.area_mm2, 300.0);
    answer.points_mm = {carried(poseOf(*view).probeToWorld, glm::dvec3(section.inside_mm, 0.0))};
    EXPECT_TRUE(judgeExercise(offered("ball"), ground_, level, answer).passed());
    answer.points_mm = ground_.truth.measurements.front().points_mm;
    EXPECT_TRUE(judgeExercise(offered("ball, width"), ground_, level, answer).passed());
  }
}

TEST_F(ExercisesOfATrunk, FailAnswersOfTheWrongKindWithASentence) {
  const StepResult nothing = judgeExercise(offered("ball"), ground_, 1, {});
  EXPECT_FALSE(nothing.passed());
  EXPECT_EQ(nothing.remarks.front().text.english(), "No point was set; click in the image.");
  Exercise gone = offered("ball");
  gone.target = "what was there once";
  ExerciseAnswer answer;
  answer.points_mm = {glm::dvec3(0.0)};
  EXPECT_FALSE(judgeExercise(gone, ground_, 1, answer).passed());
  EXPECT_FALSE(startOf(gone, ground_, 1, 1));
  answer.points_mm = {glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(2.0)};
  EXPECT_EQ(judgeExercise(offered("ball, width"), ground_, 1, answer).remarks.front().text.english(),
            "These points read nothing; set the calipers that the measurement needs.");
}

TEST(ScannableRegion, RandomHoldsLieOnItsSkin) {
  const test::CylinderSkin skin(120.0);
  ScannableRegion region;
  region.placedGrid.dims = {60, 40, 50};
  region.placedGrid.spacing_mm = glm::dvec3(2.0);
  region.placedGrid.origin_mm = {-59.0, -125.0, -49.0};
  std::set<int> sides;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto hold = randomHold(region, skin, seed);
    ASSERT_TRUE(hold);
    EXPECT_TRUE(isScannable(region, hold->contact));
    EXPECT_EQ(randomHold(region, skin, seed), hold);
    sides.insert((hold->contact.point_mm.x > 0.0 ? 1 : 0) + (hold->contact.point_mm.z > 0.0 ? 2 : 0));
  }
  EXPECT_EQ(sides.size(), 4U);
  region.placedGrid.origin_mm.y = 500.0;
  EXPECT_FALSE(randomHold(region, skin, 1)) << "no skin over the data";
}

}  // namespace
}  // namespace ew
