#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "acquisition/screens.h"
#include "ew/acquisition/screen.h"
#include "ew/acquisition/screen_recording.h"
#include "io/files.h"

namespace ew::test::screen_geometry_test {
namespace {

FanOutline rectangleOf(double left, double top, double right, double bottom) {
  FanOutline outline;
  outline.corners_px = {glm::dvec2(left, top), glm::dvec2(right, top), glm::dvec2(right, bottom), glm::dvec2(left, bottom)};
  return outline;
}

TEST(Screen, CorrectionsReplaceAddAndRemove) {
  ScreenAnalysis found;
  found.width_px = 200;
  found.height_px = 150;
  found.outline = rectangleOf(20, 10, 180, 140);
  found.parts = {
      {{30, 30, 40, 12}, ScreenPartKind::text}, {{100, 60, 30, 12}, ScreenPartKind::text}, {{5, 5, 10, 10}, ScreenPartKind::outside}};
  found.ticks = DepthTicks{.x_px = 190, .first_px = 10, .spacing_px = 26, .count = 6};
  ScreenCorrection correction;
  correction.removed = {{28, 28, 44, 16}};
  correction.added = {{120, 65, 40, 20}, {-5, 100, 30, 10}};
  correction.tick_mm = 10.0;
  const auto geometry = corrected(found, correction);
  ASSERT_TRUE(geometry) << geometry.error();
  EXPECT_EQ(geometry->text, (std::vector<PixelRect>{{100, 60, 60, 25}, {0, 100, 25, 10}}));
  EXPECT_NEAR(*geometry->pixel_mm, 10.0 / 26.0, 1e-12);
  correction.depth_mm = 65.0;
  const auto deep = corrected(found, correction);
  ASSERT_TRUE(deep);
  EXPECT_NEAR(*deep->pixel_mm, 0.5, 1e-12);
  EXPECT_EQ(deep->notes.size(), 1u) << "the ticks disagree";
  correction.depth_mm = -1.0;
  EXPECT_EQ(corrected(found, correction).error().code, ErrorCode::badField);
  found.ticks.reset();
  EXPECT_EQ(corrected(found, {.tick_mm = 5.0}).error().code, ErrorCode::badField);
}

TEST(Screen, TheRecordingsOwnScaleIsUsedAndHeldAgainstWhatIsStated) {
  ScreenAnalysis found;
  found.width_px = 400;
  found.height_px = 200;
  FanOutline right;
  right.shape = FanShape::linear;
  right.corners_px = {glm::dvec2(220, 20), glm::dvec2(380, 20), glm::dvec2(380, 180), glm::dvec2(220, 180)};
  found.outline = right;
  found.scales = {{{0, 0, 200, 200}, glm::dvec2(0.5)}, {{200, 0, 200, 200}, glm::dvec2(0.25)}};
  const auto own = corrected(found, {});
  ASSERT_TRUE(own.has_value());
  EXPECT_EQ(own->pixel_mm, 0.25) << "of the part that holds the scan";
  ScreenCorrection stated;
  stated.depth_mm = 80.0;
  const auto other = corrected(found, stated);
  ASSERT_TRUE(other.has_value());
  EXPECT_NEAR(*other->pixel_mm, 0.5, 1e-12);
  EXPECT_TRUE(std::any_of(other->notes.begin(), other->notes.end(), [](const Message& note) {
    return note.english().find("By the recording's own scale a pixel has 0.25 mm") != std::string::npos;
  }));
  stated.depth_mm = 40.0;
  EXPECT_TRUE(corrected(found, stated)->notes.empty()) << "they agree";
}

bool says(const ScreenGeometry& geometry, const char* words) {
  return std::any_of(geometry.notes.begin(), geometry.notes.end(),
                     [&](const Message& note) { return note.english().find(words) != std::string::npos; });
}

TEST(Screen, WhichOfSeveralScalesWasTakenIsSaid) {
  ScreenAnalysis found;
  found.width_px = 400;
  found.height_px = 200;
  found.outline = rectangleOf(220, 20, 380, 180);
  found.scales = {{{0, 0, 200, 200}, glm::dvec2(0.5)}, {{200, 0, 200, 200}, glm::dvec2(0.3)}};
  const auto right = corrected(found, {});
  ASSERT_TRUE(right);
  EXPECT_EQ(right->pixel_mm, 0.3);
  EXPECT_TRUE(says(*right, "0.3 mm at (200, 0), 200 x 200 pixels. The others: 0.5 mm at (0, 0)"));
  found.outline = rectangleOf(20, 20, 380, 180);
  const auto both = corrected(found, {});
  ASSERT_TRUE(both);
  EXPECT_FALSE(both->pixel_mm);
  EXPECT_TRUE(says(*both, "put the outline around one part, or state the depth"));
  const auto stated = corrected(found, {.depth_mm = 80.0});
  ASSERT_TRUE(stated);
  EXPECT_NEAR(*stated->pixel_mm, 0.5, 1e-12);
  EXPECT_TRUE(stated->notes.empty());
  found.scales[1].pixel_mm = found.scales[0].pixel_mm;
  EXPECT_EQ(corrected(found, {})->pixel_mm, 0.5) << "one scale in two parts";
}

TEST(Screen, AScanThatLiesBesideTheStatedPartIsNamed) {
  ScreenAnalysis found;
  found.width_px = 400;
  found.height_px = 200;
  found.outline = rectangleOf(220, 20, 380, 180);
  found.scales = {{{0, 0, 200, 200}, glm::dvec2(0.5)}};
  const auto beside = corrected(found, {});
  ASSERT_TRUE(beside);
  EXPECT_FALSE(beside->pixel_mm);
  EXPECT_TRUE(
      says(*beside,
           "The recording states the size of a pixel for a part alone (0.5 mm at (0, 0), 200 x 200 pixels), but the scan as outlined, at "
           "(220, 20), 160 x 160 pixels, lies beside it, so that this size does not count; check the outline."));
  EXPECT_TRUE(says(*corrected(found, {.depth_mm = 80.0}), "lies beside it")) << "also where the depth is stated";
  found.scales = {{{0, 0, 260, 200}, glm::dvec2(0.5)}};
  EXPECT_TRUE(says(*corrected(found, {}), "but only 25 % of the scan as outlined"));
  found.scales = {{{240, 90, 60, 20}, glm::dvec2(0.5)}};
  found.outline = rectangleOf(200, 20, 380, 180);
  const auto partly = corrected(found, {});
  ASSERT_TRUE(partly);
  EXPECT_EQ(partly->pixel_mm, 0.5);
  EXPECT_TRUE(says(*partly, "Only 4 % of the scan as outlined, at (200, 20), 180 x 160 pixels, lies in the part"));
  found.scales = {{{180, 0, 220, 200}, glm::dvec2(0.5)}};
  EXPECT_FALSE(says(*corrected(found, {}), "as outlined"));
}

TEST(Screen, TheDepthIsAskedForOnlyWhereNothingSaysIt) {
  ScreenAnalysis found;
  found.width_px = 400;
  found.height_px = 200;
  found.outline = rectangleOf(20, 20, 380, 180);
  constexpr const char* kAsks = "the depth has to be stated";
  EXPECT_TRUE(says(*corrected(found, {}), kAsks));
  EXPECT_FALSE(says(*corrected(found, {.depth_mm = 80.0}), kAsks));
  found.scales = {{{0, 0, 400, 200}, glm::dvec2(0.5)}};
  EXPECT_FALSE(says(*corrected(found, {}), kAsks));
}

TEST(Screen, TheFileOfAScreenGivesTheCorrectionBack) {
  const auto file = std::filesystem::temp_directory_path() / ("ew-screen-" + std::to_string(getpid()) + ".screen.json");
  ScreenCorrection correction;
  FanOutline fan;
  fan.shape = FanShape::sector;
  fan.apex_px = {123.456, -7.25};
  fan.left_rad = -0.7123;
  fan.right_rad = 0.6;
  fan.near_px = 3.0;
  fan.far_px = 400.125;
  correction.outline = fan;
  correction.depth_mm = 160.0;
  correction.added = {{1, 2, 3, 4}};
  ScreenAnalysis found;
  found.width_px = 640;
  found.height_px = 480;
  ASSERT_TRUE(writeScreen(found, correction, file));
  const auto again = readScreenCorrection(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, correction);
  EXPECT_EQ(screenFileBeside("a/liver.igs.mha"), std::filesystem::path("a/liver.screen.json"));
  EXPECT_EQ(screenFileBeside("a/liver.mha"), std::filesystem::path("a/liver.screen.json"));
  EXPECT_EQ(screenFileBeside("a/liver.1.igs.mha"), std::filesystem::path("a/liver.1.screen.json")) << "liver.2 has one of its own";
}

TEST(Screen, FilledTextIsBetweenWhatLiesAround) {
  ScreenGeometry geometry;
  geometry.width_px = 80;
  geometry.height_px = 60;
  geometry.outline = rectangleOf(0, 0, 79, 59);
  geometry.text = {{30, 20, 20, 10}};
  GreyImage image(80, 60), clean;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) viewOf(image).at(x, y) = static_cast<std::uint8_t>(50 + x + y);
  GreyImage written = image;
  for (int y = 22; y < 28; ++y)
    for (int x = 32; x < 48; ++x) viewOf(written).at(x, y) = 255;
  ScreenCleaner(geometry, {}).clean(written, clean);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) EXPECT_NEAR(viewOf(clean).at(x, y), viewOf(image).at(x, y), 3) << x << " " << y;
  ScreenCleaner(geometry, {.fill = TextFill::black}).clean(written, clean);
  EXPECT_EQ(viewOf(clean).at(40, 25), 0);
  EXPECT_EQ(viewOf(clean).at(29, 25), viewOf(image).at(29, 25));
}

}  // namespace
}  // namespace ew::test::screen_geometry_test
