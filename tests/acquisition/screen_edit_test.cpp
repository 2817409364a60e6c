#include "ew/acquisition/screen_edit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "acquisition/outline_overlap.h"
#include "even_sweep.h"
#include "ew/acquisition/screen_frames.h"
#include "ew/io/sequence.h"

namespace ew::test::screen_edit_test {
namespace {

FanOutline fan() {
  FanOutline fan;
  fan.shape = FanShape::convex;
  fan.apex_px = {400.0, -60.0};
  fan.left_rad = -0.5;
  fan.right_rad = 0.5;
  fan.near_px = 150.0;
  fan.far_px = 600.0;
  return fan;
}

glm::dvec2 cornerOf(const FanOutline& fan, double angle_rad) {
  return fan.apex_px + fan.far_px * glm::dvec2(std::sin(angle_rad), std::cos(angle_rad));
}

glm::dvec2 placeOf(const FanOutline& outline, OutlineGrip grip) {
  for (const GripPosition& each : gripsOf(outline))
    if (each.grip == grip) return each.at_px;
  ADD_FAILURE() << "no such grip";
  return {};
}

ScreenAnalysis found() {
  ScreenAnalysis screen;
  screen.width_px = 800;
  screen.height_px = 600;
  screen.outline = fan();
  screen.parts = {
      {{300, 200, 40, 12}, ScreenPartKind::text}, {{310, 300, 60, 12}, ScreenPartKind::text}, {{5, 5, 80, 20}, ScreenPartKind::outside}};
  return screen;
}

TEST(OutlineGrips, EachIsWhereItIsPut) {
  const FanOutline before = fan();
  const std::vector<GripPosition> grips = gripsOf(before);
  ASSERT_EQ(grips.size(), 6u);
  for (const GripPosition& each : grips) {
    EXPECT_LT(glm::distance(placeOf(withGripAt(before, each.grip, each.at_px), each.grip), each.at_px), 1e-9);
    EXPECT_GT(overlapOf(withGripAt(before, each.grip, each.at_px), before, 800, 600), 0.999);
  }
  const glm::dvec2 near = placeOf(before, OutlineGrip::nearEdge) + glm::dvec2(0.0, 30.0);
  EXPECT_LT(glm::distance(placeOf(withGripAt(before, OutlineGrip::nearEdge, near), OutlineGrip::nearEdge), near), 1e-9);
  EXPECT_NEAR(withGripAt(before, OutlineGrip::left, {400.0 - 100.0, -60.0 + 100.0}).left_rad, -std::atan(1.0), 1e-12);
}

TEST(OutlineGrips, AnApexMovesUnderItsFarCorners) {
  const FanOutline before = fan();
  const FanOutline moved = withGripAt(before, OutlineGrip::apex, before.apex_px + glm::dvec2(0.0, -40.0));
  EXPECT_LT(glm::distance(cornerOf(moved, moved.left_rad), cornerOf(before, before.left_rad)), 1e-9);
  EXPECT_LT(glm::distance(cornerOf(moved, moved.right_rad), cornerOf(before, before.right_rad)), 1e-9);
  EXPECT_NEAR(moved.near_px, before.near_px + 40.0, 1e-9);
  EXPECT_LT(moved.right_rad, before.right_rad);
  // To the side both corners cannot keep their places, but none is far from it.
  const FanOutline aside = withGripAt(before, OutlineGrip::apex, before.apex_px + glm::dvec2(10.0, 0.0));
  EXPECT_LT(glm::distance(cornerOf(aside, aside.left_rad), cornerOf(before, before.left_rad)), 6.0);
  EXPECT_EQ(aside.apex_px, before.apex_px + glm::dvec2(10.0, 0.0));
}

TEST(OutlineGrips, AFanStaysAFan) {
  const FanOutline before = fan();
  EXPECT_EQ(withGripAt(before, OutlineGrip::apex, {400.0, 900.0}), before);
  EXPECT_GT(withGripAt(before, OutlineGrip::left, {900.0, 0.0}).right_rad, withGripAt(before, OutlineGrip::left, {900.0, 0.0}).left_rad);
  EXPECT_LT(withGripAt(before, OutlineGrip::nearEdge, {400.0, 2000.0}).near_px, before.far_px);
  EXPECT_EQ(withGripAt(before, OutlineGrip::nearEdge, {400.0, -60.0}).shape, FanShape::sector);
}

TEST(OutlineGrips, StraightSidesMoveWithoutTurning) {
  FanOutline box;
  box.corners_px = {glm::dvec2(100.0, 50.0), glm::dvec2(500.0, 50.0), glm::dvec2(540.0, 450.0), glm::dvec2(140.0, 450.0)};
  const FanOutline left = withGripAt(box, OutlineGrip::left, {90.0, 777.0});
  EXPECT_EQ(left.corners_px[0], glm::dvec2(70.0, 50.0));
  EXPECT_EQ(left.corners_px[3], glm::dvec2(110.0, 450.0));
  EXPECT_EQ(left.corners_px[1], box.corners_px[1]);
  EXPECT_EQ(withGripAt(box, OutlineGrip::lowerRight, {600.0, 500.0}).corners_px[2], glm::dvec2(600.0, 500.0));
  const glm::dvec2 middle = placeOf(box, OutlineGrip::whole);
  EXPECT_EQ(withGripAt(box, OutlineGrip::whole, middle + glm::dvec2(3.0, -4.0)), box.movedBy({3.0, -4.0}));
}

TEST(OutlineGrips, AnotherShapeFillsTheSamePart) {
  const FanOutline straight = withShape(fan(), FanShape::linear);
  EXPECT_EQ(straight.bounds_px(), fan().bounds_px());
  const auto round = withShape(straight, FanShape::convex).bounds_px();
  EXPECT_NEAR(round[1].y, straight.bounds_px()[1].y, 1e-9);
  EXPECT_NEAR(round[0].y, straight.bounds_px()[0].y, 1e-9);
  EXPECT_EQ(withShape(fan(), FanShape::sector), fan());
  for (const FanShape shape : {FanShape::convex, FanShape::linear})
    EXPECT_TRUE(corrected({.width_px = 800, .height_px = 600}, {.outline = outlineToBeginWith(shape, 800, 600)}));
}

TEST(ScreenEdit, ABoxIsTakenAndLeftByTheSameClick) {
  ScreenEdit edit(found());
  ASSERT_EQ(edit.boxes().size(), 2u);
  EXPECT_FALSE(edit.toggleBoxAt({20.0, 10.0}));  // beside the scan: no text over it
  EXPECT_TRUE(edit.toggleBoxAt({320.0, 205.0}));
  EXPECT_FALSE(edit.boxes()[0].counts);
  EXPECT_EQ(edit.geometry()->text.size(), 1u);
  EXPECT_TRUE(edit.toggleBoxAt({320.0, 205.0}));
  EXPECT_EQ(edit.correction(), ScreenCorrection());
  edit.addBox({315, 198, 10, 10});
  edit.addBox({0, 0, 0, 10});
  EXPECT_EQ(edit.boxes().size(), 3u);
  EXPECT_TRUE(edit.toggleBoxAt({320.0, 205.0}));  // the smaller one
  EXPECT_EQ(edit.correction(), ScreenCorrection());
}

TEST(ScreenEdit, DepthStaysWhenTheRestGoesBackToWhatWasFound) {
  ScreenEdit edit(found());
  edit.setDepth_mm(150.0);
  edit.setOutline(withGripAt(fan(), OutlineGrip::farEdge, {400.0, 500.0}));
  edit.addBox({1, 2, 3, 4});
  EXPECT_NEAR(*edit.geometry()->pixel_mm, 150.0 / (560.0 - 150.0), 1e-12);
  edit.backToFound();
  EXPECT_EQ(edit.outline(), std::optional(fan()));
  EXPECT_NEAR(*edit.geometry()->pixel_mm, 150.0 / 450.0, 1e-12);
  EXPECT_EQ(edit.boxes().size(), 2u);
}

TEST(ScreenFrames, AnyFrameIsTheSameInAnyOrder) {
  const auto file = std::filesystem::temp_directory_path() / ("ew-frames-" + std::to_string(getpid()) + ".igs.mha");
  ASSERT_TRUE(writeSequence(evenSweep({40, 30, 24, "Image", "Reference"}, [](int n, int) { return 10 + 8 * n; }), file));
  auto reader = CineReader::open(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(reader) << reader.error();
  ScreenFrames frames(3 * 40 * 30);  // room for three
  for (const std::size_t n : {0u, 23u, 22u, 5u, 6u, 4u, 23u, 0u}) {
    const auto frame = frames.at(*reader, n);
    ASSERT_TRUE(frame) << frame.error();
    EXPECT_EQ((*frame)->pixels.front(), 10 + 8 * n);
  }
  ASSERT_TRUE(frames.at(*reader, 10));
  const auto given = reader->given();
  ASSERT_TRUE(frames.at(*reader, 9));
  EXPECT_EQ(reader->given(), given);  // kept: nothing is read again
  CineFrame other;
  ASSERT_TRUE(reader->rewind());
  ASSERT_TRUE(reader->next(other));
  EXPECT_EQ((*frames.at(*reader, 15))->pixels.front(), 10 + 8 * 15);
  const auto beyond = frames.at(*reader, 24);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, ErrorCode::truncated);
  ASSERT_TRUE(frames.at(*reader, 1));
}

TEST(ScreenEdit, ABoxThatMayBeTextCountsOnceItIsConfirmed) {
  ScreenAnalysis still = found();
  still.parts[1].kind = ScreenPartKind::possibleText;
  ScreenEdit edit(still);
  ASSERT_EQ(edit.boxes().size(), 2u);
  EXPECT_TRUE(edit.boxes()[0].counts);
  EXPECT_FALSE(edit.boxes()[1].counts);
  EXPECT_TRUE(edit.boxes()[1].isPossible);
  EXPECT_EQ(edit.geometry()->text.size(), 1u);
  EXPECT_TRUE(edit.toggleBoxAt({320.0, 305.0}));
  ASSERT_EQ(edit.boxes().size(), 2u);
  EXPECT_TRUE(edit.boxes()[1].counts);
  EXPECT_EQ(edit.geometry()->text.size(), 2u);
  EXPECT_TRUE(edit.toggleBoxAt({320.0, 305.0}));
  EXPECT_FALSE(edit.boxes()[1].counts);
  EXPECT_TRUE(edit.correction().added.empty());
}

TEST(ScreenEdit, TurnedImagesTakeBackWhatWasSaidInTheirPixels) {
  ScreenEdit edit(found());
  edit.setDepth_mm(150.0);
  EXPECT_FALSE(edit.setTurned({1, false})) << "nothing had been corrected";
  edit.addBox({10, 10, 20, 20});
  FanOutline moved = fan();
  moved.apex_px.x += 5.0;
  edit.setOutline(moved);
  EXPECT_TRUE(edit.setTurned({2, true}));
  EXPECT_EQ(edit.correction().turned, (Orientation{2, true}));
  EXPECT_FALSE(edit.correction().outline);
  EXPECT_TRUE(edit.correction().added.empty());
  EXPECT_EQ(edit.correction().depth_mm, 150.0);
}

}  // namespace
}  // namespace ew::test::screen_edit_test
