#include "ew/assessment/judging.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace ew {
namespace {

TEST(Score, IsPassingWithinToleranceAndNowhereElse) {
  EXPECT_EQ(scoreAt(0.0), 1.0);
  EXPECT_EQ(scoreAt(1.0), kPassScore);
  EXPECT_LT(scoreAt(std::nextafter(1.0, 2.0)), kPassScore);
  EXPECT_DOUBLE_EQ(scoreAt(2.0), 0.35);
  EXPECT_EQ(scoreAt(3.0), 0.0);
  EXPECT_EQ(scoreAt(1e9), 0.0);
  for (double share = 0.0; share < 4.0; share += 0.01) EXPECT_GE(scoreAt(share), scoreAt(share + 0.01));
}

TEST(Tolerance, BelongsToWhatItAllowsInEveryDecimal) {
  for (const double tolerance : {0.1, 0.2, 0.3, 0.7, 1.1, 2.5})
    for (int tenths = -500; tenths <= 500; ++tenths) {
      const double expected = tenths / 10.0, count = std::lround(10.0 * tolerance);
      for (const double value : {(tenths + count) / 10.0, (tenths - count) / 10.0}) {
        ASSERT_TRUE(isWithinTolerance(value, expected, tolerance)) << value << " of " << expected << " +- " << tolerance;
        ASSERT_LE(shareOfTolerance(value, expected, tolerance), 1.0);
      }
      for (const double value : {(tenths + count) / 10.0 + 1e-6, (tenths - count) / 10.0 - 1e-6}) {
        ASSERT_FALSE(isWithinTolerance(value, expected, tolerance)) << value << " of " << expected << " +- " << tolerance;
        ASSERT_GT(shareOfTolerance(value, expected, tolerance), 1.0);
      }
    }
  EXPECT_TRUE(isWithinTolerance(1e6 + 0.1, 1e6, 0.1)) << "binary fractions are coarser there";
  EXPECT_TRUE(isWithinTolerance(3.0, 3.0, 0.0));
  EXPECT_FALSE(isWithinTolerance(3.0000001, 3.0, 0.0));
  EXPECT_FALSE(isWithinTolerance(std::numeric_limits<double>::infinity(), 0.0, 5.0));
  EXPECT_FALSE(isWithinTolerance(std::numeric_limits<double>::quiet_NaN(), 0.0, 5.0));
  EXPECT_TRUE(isWithinRange(0.1 + 0.2, 0.0, 0.3));
  EXPECT_TRUE(reachesLevel((0.7 + 0.7 + 0.7) / 3.0, 0.7));
  EXPECT_FALSE(reachesLevel(0.6999999, 0.7));
}

TEST(Tolerance, IsKeptByCalipersPointsAndSweeps) {
  ReferenceMeasurement expected;
  expected.value = 12.3;
  expected.unit = "mm";
  for (const double value : {12.1, 12.5}) {
    const StepResult judged = judgeMeasurement(expected, value, {}, 0.2);
    EXPECT_TRUE(judged.passed()) << value;
    EXPECT_GE(judged.score, kPassScore) << value;
    ASSERT_EQ(judged.remarks.size(), 1u);
    EXPECT_TRUE(judged.remarks.front().good);
  }
  EXPECT_FALSE(judgeMeasurement(expected, 12.09, {}, 0.2).passed());
  ReferencePoint point;
  point.at_mm = {0.3, 0.0, 0.0};
  point.tolerance_mm = 0.1;
  EXPECT_TRUE(judgePointing(point, {0.4, 0.0, 0.0}).passed());
  EXPECT_FALSE(judgePointing(point, {0.401, 0.0, 0.0}).passed());
  EXPECT_TRUE(judgeSweep(0.1 * 3.0 + 0.6, 0.9).passed());
}

PlaneTarget target() { return {{}, {0.0, 50.0}}; }

Pose moved(const glm::dmat4& matrix) {
  Pose pose;
  pose.probeToWorld.matrix = matrix;
  return pose;
}

TEST(JudgePlane, PassesWithinToleranceAndSaysWhatWasMissed) {
  EXPECT_TRUE(judgePlane(target(), {5.0, 10.0}, moved(glm::translate(glm::dmat4(1.0), {0.0, 0.0, 4.9}))).passed());
  const StepResult off = judgePlane(target(), {5.0, 10.0}, moved(glm::translate(glm::dmat4(1.0), {0.0, 0.0, 7.5})));
  EXPECT_FALSE(off.passed());
  EXPECT_DOUBLE_EQ(off.score, scoreAt(1.5));
  ASSERT_EQ(off.remarks.size(), 1U);
  EXPECT_EQ(off.remarks.front().text.english(), "The plane passes 7.5 mm beside the target; 5 mm are allowed.");
}

TEST(JudgePlane, TellsARotationFromATilt) {
  const auto remark = [](const glm::dvec3& axis, double angle_deg) {
    const StepResult judged = judgePlane(target(), {500.0, 10.0}, moved(glm::rotate(glm::dmat4(1.0), glm::radians(angle_deg), axis)));
    return judged.remarks.empty() ? std::string() : judged.remarks.front().text.english();
  };
  EXPECT_EQ(remark({0.0, 1.0, 0.0}, 80.0),
            "The plane is 80 degrees off, the probe above all rotated about its beam; 10 degrees are allowed.");
  EXPECT_EQ(remark({1.0, 0.0, 0.0}, 30.0), "The plane is 30 degrees off, the probe above all tilted; 10 degrees are allowed.");
}

TEST(JudgePlane, DoesNotPassAMarkerOnTheWrongSide) {
  const StepResult mirrored = judgePlane(target(), {}, moved(glm::rotate(glm::dmat4(1.0), 3.14159265358979, glm::dvec3(0.0, 1.0, 0.0))));
  EXPECT_FALSE(mirrored.passed());
  EXPECT_EQ(mirrored.score, 0.5);
  ASSERT_EQ(mirrored.remarks.size(), 1U);
  EXPECT_EQ(mirrored.remarks.front().text.english(), "The marker points the wrong way; left and right are exchanged.");
}

TEST(JudgePlane, FailsAProbeThatWasNotSeen) {
  Pose pose;
  pose.status = PoseStatus::missing;
  EXPECT_EQ(judgePlane(target(), {}, pose).score, 0.0);
}

ReferenceMeasurement diameter() {
  ReferenceMeasurement expected;
  expected.value = 30.0;
  expected.unit = "mm";
  expected.tolerance = 2.0;
  expected.points_mm = {{0.0, 0.0, 0.0}, {30.0, 0.0, 0.0}};
  return expected;
}

TEST(JudgeMeasurement, WantsTheValueAndThePlace) {
  const auto judged = [](double value, const std::vector<glm::dvec3>& points) { return judgeMeasurement(diameter(), value, points, 2.0); };
  EXPECT_TRUE(judged(31.9, {{0.0, 0.0, 0.0}, {31.9, 0.0, 0.0}}).passed());
  EXPECT_TRUE(judged(30.0, {{30.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}).passed()) << "from the other end";
  EXPECT_FALSE(judged(32.1, {{0.0, 0.0, 0.0}, {32.1, 0.0, 0.0}}).passed());
  const StepResult elsewhere = judged(30.0, {{0.0, 20.0, 0.0}, {30.0, 20.0, 0.0}});
  EXPECT_FALSE(elsewhere.passed()) << "the right number in the wrong place";
  EXPECT_EQ(elsewhere.remarks.back().text.english(), "The calipers stand 20 mm from where they belong.");
  EXPECT_TRUE(judged(30.0, {}).passed()) << "typed in: nothing is known of its place";
}

TEST(JudgeMeasurement, ReadsCalipers) {
  EXPECT_EQ(readingOf({{0.0, 0.0, 0.0}, {3.0, 4.0, 0.0}}), 5.0);
  EXPECT_NEAR(*readingOf({{-10.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {0.0, -10.0, 0.0}, {0.0, 10.0, 0.0}}), 62.83185307, 1e-6);
  EXPECT_FALSE(readingOf({{0.0, 0.0, 0.0}}));
}

TEST(JudgeSweep, PassesFromWhatIsNeeded) {
  EXPECT_TRUE(judgeSweep(0.9, 0.9).passed());
  EXPECT_DOUBLE_EQ(judgeSweep(0.9, 0.9).score, kPassScore);
  EXPECT_EQ(judgeSweep(1.0, 0.9).score, 1.0);
  EXPECT_FALSE(judgeSweep(0.89, 0.9).passed());
  EXPECT_LT(judgeSweep(0.8999999999, 0.9).score, kPassScore);
  EXPECT_EQ(judgeSweep(0.0, 0.9).score, 0.0);
}

TEST(JudgePointing, IsWithinTheOrganOrItsMargin) {
  Volume labels;
  labels.grid.dims = glm::ivec3(11);
  labels.echo.assign(labels.grid.voxelCount(), 0);
  labels.echo[labels.grid.indexOf(5, 5, 5)] = 1;
  const OrganVoxels organ(labels, 1);
  EXPECT_EQ(judgePointing(organ, {5.3, 5.0, 5.0}, 0.0).score, 1.0);
  EXPECT_FALSE(judgePointing(organ, {5.7, 5.0, 5.0}, 0.0).passed());
  EXPECT_TRUE(judgePointing(organ, {6.4, 5.0, 5.0}, 1.0).passed());
  EXPECT_FALSE(judgePointing(organ, {6.6, 5.0, 5.0}, 1.0).passed());
  ReferencePoint point;
  point.tolerance_mm = 4.0;
  EXPECT_TRUE(judgePointing(point, {3.9, 0.0, 0.0}).passed());
  EXPECT_FALSE(judgePointing(point, {4.1, 0.0, 0.0}).passed());
}

}  // namespace
}  // namespace ew
