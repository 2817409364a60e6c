#include "ew/tracking/face_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "made_tools.h"

namespace ew::face_calibration_test {
namespace {

using test::Dice;

constexpr double kDegree = std::numbers::pi / 180.0;
const glm::dvec3 kTip(3.0, -91.0, 7.0);

glm::dmat4 turnAbout(const glm::dvec3& axis, double angle) { return glm::mat4_cast(glm::angleAxis(angle, glm::normalize(axis))); }

/// A tool whose tip stays at `point`, turned by `turn`.
Transform<frame::Tracker, frame::Tool> about(const glm::dvec3& point, const glm::dmat4& turn) {
  Transform<frame::Tracker, frame::Tool> made{turn};
  made.matrix[3] = glm::dvec4(point - glm::dmat3(turn) * kTip, 1.0);
  return made;
}

std::vector<ToolReading> pivoting(Dice& dice, double sideways_deg, double forwards_deg, double noise_mm, int count = 200) {
  const glm::dmat4 how = turnAbout({1.0, 2.0, -1.0}, 0.7);
  std::vector<ToolReading> readings;
  for (int n = 0; n < count; ++n) {
    const double a = sideways_deg * kDegree * std::sin(0.11 * n), b = forwards_deg * kDegree * std::sin(0.173 * n + 1.0);
    const glm::dmat4 turn = how * turnAbout({0.0, 0.0, 1.0}, a) * turnAbout({1.0, 0.0, 0.0}, b);
    readings.push_back(test::readingAt(test::shaken(about({50.0, -20.0, 400.0}, turn), dice, noise_mm, 0.0), n / 30.0));
  }
  return readings;
}

TEST(Pivoting, FindsTheTipExactlyAndSaysHowWellItIsKnown) {
  Dice dice(3);
  const auto exact = pivotOf(pivoting(dice, 30.0, 30.0, 0.0));
  ASSERT_TRUE(exact);
  EXPECT_TRUE(exact->isKnown) << exact->sentence;
  EXPECT_NEAR(glm::distance(exact->tip_tool_mm, kTip), 0.0, 1e-6);
  EXPECT_NEAR(glm::distance(exact->point_tracker_mm, glm::dvec3(50.0, -20.0, 400.0)), 0.0, 1e-6);
  double squares = 0.0, said2 = 0.0;
  for (int n = 0; n < 60; ++n) {
    const auto noisy = pivotOf(pivoting(dice, 30.0, 30.0, 0.5));
    ASSERT_TRUE(noisy);
    squares += std::pow(glm::distance(noisy->tip_tool_mm, kTip), 2);
    said2 += std::pow(noisy->spread_mm, 2);
  }
  EXPECT_LT(std::sqrt(squares / 60.0), 0.3);
  const double ratio = std::sqrt(squares / said2);  // spread_mm is that of the worst direction alone
  EXPECT_GT(ratio, 0.8);
  EXPECT_LT(ratio, 1.8);
}

TEST(Pivoting, MomentsWhenTheTipSlippedDoNotCount) {
  Dice dice(5);
  auto readings = pivoting(dice, 30.0, 30.0, 0.3);
  for (std::size_t n = 60; n < 90; ++n) readings[n].toolToTracker.matrix[3] += glm::dvec4(15.0, 8.0, 0.0, 0.0);
  for (std::size_t n = 100; n < 105; ++n) readings[n].state = TrackingState::outOfView;
  const auto found = pivotOf(readings);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->isKnown) << found->sentence;
  EXPECT_GE(found->slipped, 28);
  EXPECT_LT(glm::distance(found->tip_tool_mm, kTip), 0.5);
}

TEST(Pivoting, AMotionThatLeavesTheTipOpenIsNamed) {
  Dice dice(7);
  for (const auto& [sideways, forwards] : {std::pair{30.0, 1.0}, std::pair{1.0, 30.0}, std::pair{3.0, 3.0}, std::pair{0.0, 0.0}}) {
    const auto found = pivotOf(pivoting(dice, sideways, forwards, 0.3));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->isKnown) << sideways << " " << forwards << ": " << found->sentence;
    EXPECT_NE(found->sentence.english().find("both ways"), std::string::npos) << found->sentence;
  }
  auto sliding = pivoting(dice, 30.0, 30.0, 0.3);
  for (ToolReading& reading : sliding) reading.toolToTracker.matrix[3] += glm::dvec4(dice.normal3(12.0), 0.0);
  const auto slid = pivotOf(sliding);
  ASSERT_TRUE(slid);
  EXPECT_FALSE(slid->isKnown) << slid->sentence;
  EXPECT_FALSE(pivotOf(std::span(sliding).first(10)));
}

/// Flat on a table whose normal is `down`, turned about it from `from` to `to` degrees, leaning by noise.
std::vector<ToolReading> onATable(Dice& dice, const glm::dmat3& probeToTool, double from_deg, double to_deg, double lean_rad) {
  const glm::dmat4 table = turnAbout({1.0, -1.0, 0.3}, 1.1);  // y of the table goes into it
  std::vector<ToolReading> readings;
  for (int n = 0; n < 150; ++n) {
    const glm::dmat4 probe = table * turnAbout({0.0, 1.0, 0.0}, (from_deg + (to_deg - from_deg) * n / 149.0) * kDegree);
    Transform<frame::Tracker, frame::Tool> tool{probe * glm::dmat4(glm::transpose(probeToTool))};
    tool.matrix[3] = glm::dvec4(3.0 * n, 20.0 * std::sin(0.1 * n), 300.0, 1.0);
    readings.push_back(test::readingAt(test::shaken(tool, dice, 0.3, lean_rad), n / 30.0));
  }
  return readings;
}

TEST(FlatFaceOnATable, GivesTheDirectionOutOfTheFace) {
  Dice dice(11);
  const glm::dmat3 probeToTool(turnAbout({0.2, 1.0, 0.5}, 2.0));
  const auto found = flatFaceOf(onATable(dice, probeToTool, 0.0, 200.0, 0.5 * kDegree), probeToTool[1] + 0.4 * probeToTool[0]);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->isKnown) << found->sentence;
  EXPECT_LT(std::acos(glm::dot(found->axial_tool, probeToTool[1])), 0.3 * kDegree);
  const auto other = flatFaceOf(onATable(dice, probeToTool, 0.0, 200.0, 0.5 * kDegree), -probeToTool[1]);
  ASSERT_TRUE(other);
  EXPECT_LT(glm::dot(other->axial_tool, probeToTool[1]), -0.999) << "the tip decides which way is out";
  const auto little = flatFaceOf(onATable(dice, probeToTool, 0.0, 30.0, 0.5 * kDegree), probeToTool[1]);
  ASSERT_TRUE(little);
  EXPECT_FALSE(little->isKnown);
  EXPECT_NE(little->sentence.english().find("quarter"), std::string::npos);
  const auto wobbling = flatFaceOf(onATable(dice, probeToTool, 0.0, 200.0, 9.0 * kDegree), probeToTool[1]);
  ASSERT_TRUE(wobbling);
  EXPECT_FALSE(wobbling->isKnown) << wobbling->sentence;
}

std::vector<ToolReading> sliding(Dice& dice, const glm::dmat3& probeToTool, double length_mm, double bend_mm, double twist_rad) {
  const glm::dmat4 how = turnAbout({1.0, -1.0, 0.3}, 1.1);
  std::vector<ToolReading> readings;
  for (int n = 0; n < 100; ++n) {
    const double share = n / 99.0;
    Transform<frame::Tracker, frame::Tool> tool{how * turnAbout({0.0, 1.0, 0.0}, twist_rad * share) *
                                                glm::dmat4(glm::transpose(probeToTool))};
    tool.matrix[3] = glm::dvec4(
        glm::dmat3(how) * glm::dvec3(length_mm * share, 0.0, bend_mm * std::sin(3.1 * share)) + glm::dvec3(10.0, 20.0, 500.0), 1.0);
    readings.push_back(test::readingAt(test::shaken(tool, dice, 0.3, 0.004), n / 30.0));
  }
  return readings;
}

TEST(SlideAlongARuler, GivesTheLateralDirectionAndRefusesWhatIsNoSlide) {
  Dice dice(13);
  const glm::dmat3 probeToTool(turnAbout({0.2, 1.0, 0.5}, 2.0));
  const auto found = lateralOf(sliding(dice, probeToTool, 150.0, 0.0, 0.0));
  ASSERT_TRUE(found) << found.error();
  EXPECT_LT(std::acos(glm::dot(*found, probeToTool[0])), 0.5 * kDegree);
  EXPECT_FALSE(lateralOf(sliding(dice, probeToTool, 20.0, 0.0, 0.0))) << "too short";
  EXPECT_FALSE(lateralOf(sliding(dice, probeToTool, 150.0, 40.0, 0.0))) << "a bow";
  EXPECT_FALSE(lateralOf(sliding(dice, probeToTool, 150.0, 0.0, 0.8))) << "turned on the way";
}

TEST(FaceOfAProbe, IsPutTogetherFromTipAxisAndSlide) {
  const glm::dmat3 truth(turnAbout({0.2, 1.0, 0.5}, 2.0));
  const auto face = faceFrom(kTip, truth[1], glm::normalize(truth[0] + 0.1 * truth[1]));
  ASSERT_TRUE(face) << face.error();
  EXPECT_TRUE(checkRigid(face->probeToTool, 1e-9));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(glm::distance(glm::dvec3(face->probeToTool.matrix[c]), truth[c]), 0.0, 1e-9);
  EXPECT_NEAR(glm::distance(glm::dvec3(face->probeToTool.matrix[3]), kTip), 0.0, 1e-12);
  EXPECT_FALSE(faceFrom(kTip, truth[1], glm::normalize(truth[0] + 2.0 * truth[1])));
}

}  // namespace
}  // namespace ew::face_calibration_test
