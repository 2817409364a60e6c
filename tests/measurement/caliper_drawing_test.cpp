#include "ew/measurement/caliper_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ew::measurement {
namespace {

using Press = CaliperDrawing::Press;
constexpr double kReach_mm = 2.0;

Press click(CaliperDrawing& drawing, glm::dvec2 at) {
  drawing.moveTo(at, kReach_mm);
  const Press pressed = drawing.press(at, kReach_mm);
  drawing.release(at, kReach_mm);
  return pressed;
}

void drag(CaliperDrawing& drawing, glm::dvec2 from, glm::dvec2 to) {
  drawing.press(from, kReach_mm);
  drawing.moveTo(0.5 * (from + to), kReach_mm);
  drawing.moveTo(to, kReach_mm);
  drawing.release(to, kReach_mm);
}

const std::vector<glm::dvec2>& pointsOf(const CaliperDrawing& drawing, int number) {
  return drawing.shown().find(number)->caliper.parts[0].points;
}

TEST(CaliperDrawing, TwoClicksMakeADistanceAndTheToolStaysForTheNext) {
  CaliperDrawing drawing;
  EXPECT_EQ(click(drawing, {0.0, 0.0}), Press::nothing);
  drawing.take(CaliperKind::distance);
  EXPECT_EQ(click(drawing, {0.0, 10.0}), Press::point);
  EXPECT_EQ(drawing.unfinished()->parts[0].points.size(), 1U);
  drawing.moveTo({30.0, 50.0}, kReach_mm);
  EXPECT_EQ(drawing.unfinished()->parts[0].points.back(), glm::dvec2(30.0, 50.0));
  EXPECT_TRUE(drawing.shown().all.empty());
  EXPECT_EQ(click(drawing, {30.0, 50.0}), Press::finished);
  ASSERT_EQ(drawing.shown().all.size(), 1U);
  EXPECT_NEAR(measure(drawing.shown().all[0].caliper)->figures[0].quantity.value, 50.0, 1e-12);
  EXPECT_EQ(drawing.selected(), 1);
  EXPECT_EQ(drawing.tool(), CaliperKind::distance);
  EXPECT_FALSE(drawing.unfinished());
}

TEST(CaliperDrawing, ADragSetsBothEndsAndASecondClickInOnePlaceNone) {
  CaliperDrawing drawing;
  drawing.take(CaliperKind::distance);
  drag(drawing, {0.0, 10.0}, {0.0, 40.0});
  EXPECT_EQ(pointsOf(drawing, 1), (std::vector<glm::dvec2>{{0.0, 10.0}, {0.0, 40.0}}));
  click(drawing, {50.0, 10.0});
  EXPECT_EQ(click(drawing, {50.0, 10.0}), Press::nothing);
  EXPECT_EQ(drawing.points().size(), 1U);
}

TEST(CaliperDrawing, OutlinesEndWhereTheyBeganAtASecondClickOrWhenAsked) {
  for (int way = 0; way < 3; ++way) {
    CaliperDrawing drawing;
    drawing.take(CaliperKind::trace);
    for (const glm::dvec2 at : {glm::dvec2(0.0, 0.0), glm::dvec2(20.0, 0.0), glm::dvec2(20.0, 30.0)})
      EXPECT_EQ(click(drawing, at), Press::point);
    const bool isWhole = way == 0   ? click(drawing, {0.5, 0.5}) == Press::finished
                         : way == 1 ? click(drawing, {20.0, 30.0}) == Press::finished
                                    : drawing.finish();
    EXPECT_TRUE(isWhole) << way;
    ASSERT_EQ(drawing.shown().all.size(), 1U) << way;
    EXPECT_NEAR(measure(drawing.shown().all[0].caliper)->figure(FigureKind::area)->quantity.value, 300.0, 1e-9);
  }
  CaliperDrawing few;
  few.take(CaliperKind::trace);
  click(few, {0.0, 0.0});
  click(few, {20.0, 0.0});
  EXPECT_FALSE(few.finish());
  EXPECT_EQ(few.points().size(), 2U);
}

TEST(CaliperDrawing, AnOutlineIsDrawnWithTheButtonDown) {
  CaliperDrawing drawing;
  drawing.take(CaliperKind::trace);
  const auto at = [](double turn) { return glm::dvec2(25.0 * std::cos(turn), 60.0 + 25.0 * std::sin(turn)); };
  drawing.press(at(0.0), kReach_mm);
  for (double turn = 0.02; turn < 6.28; turn += 0.02) drawing.moveTo(at(turn), kReach_mm);
  drawing.release(at(6.28), kReach_mm);
  ASSERT_EQ(drawing.shown().all.size(), 1U);
  EXPECT_NEAR(measure(drawing.shown().all[0].caliper)->figure(FigureKind::area)->quantity.value, std::numbers::pi * 625.0, 5.0);
}

TEST(CaliperDrawing, AThirdClickOpensTheEllipseToBothSides) {
  CaliperDrawing drawing;
  drawing.take(CaliperKind::ellipse);
  click(drawing, {-30.0, 50.0});
  click(drawing, {30.0, 50.0});
  drawing.moveTo({3.0, 60.0}, kReach_mm);
  EXPECT_EQ(drawing.unfinished()->parts[0].points.size(), 4U);
  EXPECT_EQ(click(drawing, {3.0, 70.0}), Press::finished);
  EXPECT_EQ(pointsOf(drawing, 1)[2], glm::dvec2(0.0, 70.0));
  EXPECT_EQ(pointsOf(drawing, 1)[3], glm::dvec2(0.0, 30.0));
  // Its axes stay square to each other whichever end is dragged.
  drag(drawing, {30.0, 50.0}, {-30.0, 130.0});
  const auto turned = pointsOf(drawing, 1);
  EXPECT_NEAR(glm::distance(turned[2], turned[3]), 40.0, 1e-9);
  EXPECT_NEAR(glm::dot(turned[1] - turned[0], turned[3] - turned[2]), 0.0, 1e-9);
  EXPECT_EQ(0.5 * (turned[2] + turned[3]), glm::dvec2(-30.0, 90.0));
  drag(drawing, turned[3], {-30.0 + 25.0, 95.0});
  EXPECT_NEAR(glm::distance(pointsOf(drawing, 1)[2], pointsOf(drawing, 1)[3]), 50.0, 1e-9);
}

TEST(CaliperDrawing, ADraggedHandleIsOneStepBack) {
  CaliperDrawing drawing;
  drawing.take(CaliperKind::distance);
  drag(drawing, {0.0, 10.0}, {0.0, 40.0});
  EXPECT_EQ(drawing.press({0.5, 40.5}, kReach_mm), Press::handle);
  for (double y = 41.0; y <= 60.0; y += 1.0) drawing.moveTo({0.0, y}, kReach_mm);
  drawing.release({0.0, 60.0}, kReach_mm);
  EXPECT_EQ(pointsOf(drawing, 1)[1], glm::dvec2(0.0, 60.0));
  EXPECT_TRUE(drawing.undo());
  EXPECT_EQ(pointsOf(drawing, 1)[1], glm::dvec2(0.0, 40.0));
  EXPECT_TRUE(drawing.redo());
  EXPECT_EQ(pointsOf(drawing, 1)[1], glm::dvec2(0.0, 60.0));
  // A handle that is only clicked is no step at all.
  click(drawing, {0.0, 60.0});
  EXPECT_FALSE(drawing.canRedo());
  EXPECT_TRUE(drawing.undo());
  EXPECT_EQ(pointsOf(drawing, 1)[1], glm::dvec2(0.0, 40.0));
}

TEST(CaliperDrawing, NeighboursOfATracedPointFollowItSmoothly) {
  Caliper trace{CaliperKind::trace, {{0, {}}}};
  for (int n = 0; n < 200; ++n) trace.parts[0].points.emplace_back(30.0 * std::cos(0.0314159 * n), 30.0 * std::sin(0.0314159 * n));
  const auto moved = withHandleAt(trace, {0, 50}, trace.parts[0].points[50] + glm::dvec2(0.0, 5.0)).parts[0].points;
  EXPECT_NEAR(moved[50].y - trace.parts[0].points[50].y, 5.0, 1e-12);
  EXPECT_GT(moved[52].y - trace.parts[0].points[52].y, 4.0);
  EXPECT_NEAR(moved[52].y - trace.parts[0].points[52].y, moved[48].y - trace.parts[0].points[48].y, 1e-9);
  EXPECT_EQ(moved[150], trace.parts[0].points[150]);
}

TEST(CaliperDrawing, BackAndEscapeGoStepByStep) {
  CaliperDrawing drawing;
  drawing.take(CaliperKind::distance);
  drag(drawing, {0.0, 10.0}, {0.0, 40.0});
  drawing.take(CaliperKind::angle);
  click(drawing, {40.0, 10.0});
  click(drawing, {60.0, 10.0});
  EXPECT_TRUE(drawing.takeBack());
  EXPECT_EQ(drawing.points().size(), 1U);
  EXPECT_TRUE(drawing.undo());
  EXPECT_TRUE(drawing.points().empty());
  EXPECT_EQ(drawing.shown().all.size(), 1U);
  click(drawing, {40.0, 10.0});
  EXPECT_TRUE(drawing.cancel());  // the point
  EXPECT_TRUE(drawing.cancel());  // the tool
  EXPECT_FALSE(drawing.tool());
  EXPECT_FALSE(drawing.cancel());
  drawing.select(1);
  EXPECT_TRUE(drawing.cancel());  // the selection
  EXPECT_FALSE(drawing.cancel());
  EXPECT_TRUE(drawing.takeBack());
  EXPECT_TRUE(drawing.isEmpty());
  EXPECT_FALSE(drawing.takeBack());
  EXPECT_TRUE(drawing.undo());
  EXPECT_EQ(drawing.shown().all.size(), 1U);
  EXPECT_TRUE(drawing.clear());
  EXPECT_TRUE(drawing.isEmpty());
  EXPECT_TRUE(drawing.undo());
  EXPECT_EQ(drawing.shown().all[0].number, 1);
}

TEST(CaliperDrawing, HeartRatesTakeTheBeatsThatAreSetAndGoBackByAStep) {
  CaliperDrawing drawing;
  drawing.setScale({80.0, 1.0});  // a second is as wide as 80 mm
  drawing.setCycles(2);
  drawing.take(CaliperKind::heartRate);
  click(drawing, {1.0, 30.0});
  EXPECT_EQ(click(drawing, {2.0, 30.0}), Press::finished);
  const auto rate = [&] { return measure(drawing.shown().all[0].caliper)->figures[0].quantity.value; };
  EXPECT_DOUBLE_EQ(rate(), 120.0);
  EXPECT_TRUE(drawing.setCyclesOf(1, 3));
  EXPECT_FALSE(drawing.setCyclesOf(1, 3));
  EXPECT_DOUBLE_EQ(rate(), 180.0);
  EXPECT_TRUE(drawing.undo());
  EXPECT_DOUBLE_EQ(rate(), 120.0);
  // 0.02 s are 1.6 mm: within reach of the handle; 0.1 s are not.
  EXPECT_TRUE(drawing.isNearHandle({2.02, 30.5}, kReach_mm));
  EXPECT_FALSE(drawing.isNearHandle({2.1, 30.5}, kReach_mm));
}

TEST(CaliperDrawing, DiscsAreAnAxisAndAnOutlineThatEndsWhereItBegan) {
  CaliperDrawing drawing;
  drawing.take(CaliperKind::discs);
  for (const glm::dvec2 at : {glm::dvec2(0, 0), glm::dvec2(60, 0), glm::dvec2(0, -10), glm::dvec2(60, -10), glm::dvec2(60, 10)})
    EXPECT_EQ(click(drawing, at), Press::point);
  EXPECT_EQ(click(drawing, {0, 10}), Press::point);
  EXPECT_EQ(click(drawing, {0.5, -10.5}), Press::finished);
  EXPECT_NEAR(measure(drawing.shown().all[0].caliper)->figures[0].quantity.value, std::numbers::pi * 100.0 * 60.0 * 1e-3, 1e-9);
}

}  // namespace
}  // namespace ew::measurement
