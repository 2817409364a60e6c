#include "ew/imaging/orientation_marker.h"

#include <gtest/gtest.h>

namespace ew::orientation_marker_test {
namespace {

Probe linear() {
  Probe probe;
  probe.kind = ProbeKind::linear;
  probe.width_mm = 40.0;
  return probe;
}

DisplayGeometry fan() {
  DisplayGeometry geometry;
  geometry.width = 300;
  geometry.height = 200;
  geometry.pixel_mm = 0.5;
  geometry.face_px = {150.0, 40.0};
  geometry.depth_mm = 60.0;
  return geometry;
}

TEST(OrientationMarker, StandsAtTheSideOfTheProbesMarkerOffTheFace) {
  DisplayGeometry geometry = fan();
  EXPECT_EQ(markerPlace_px(linear(), geometry, 12.0, 6.0), glm::dvec2(150.0 - 40.0, 40.0 - 12.0));
  geometry.markerLeft = false;
  EXPECT_EQ(markerPlace_px(linear(), geometry, 12.0, 6.0), glm::dvec2(150.0 + 40.0, 40.0 - 12.0));
  geometry.upsideDown = true;
  geometry.face_px.y = 160.0;
  EXPECT_EQ(markerPlace_px(linear(), geometry, 12.0, 6.0), glm::dvec2(190.0, 172.0));
}

TEST(OrientationMarker, StaysOnTheImage) {
  DisplayGeometry geometry = fan();
  geometry.face_px = {10.0, 0.0};  // zoomed
  EXPECT_EQ(markerPlace_px(linear(), geometry, 12.0, 6.0), glm::dvec2(6.0, 6.0));
  GreyImage image(300, 200);
  for (int y = 0; y < 200; ++y) std::fill_n(viewOf(image).row(y), 300, std::uint8_t{90});
  burnMarker(viewOf(image), linear(), geometry);
  int white = 0, changed = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      white += viewOf(image).at(x, y) == 255 ? 1 : 0;
      changed += viewOf(image).at(x, y) != 90 ? 1 : 0;
    }
  EXPECT_NEAR(white, 79, 6);
  EXPECT_LT(changed, 250);
}

TEST(OrientationMarker, IsTheSameOnGreyAndColour) {
  GreyImage grey(300, 200);
  RgbImage colour(300, 200);
  for (int y = 0; y < 200; ++y) {
    std::fill_n(viewOf(grey).row(y), 300, std::uint8_t{90});
    std::fill_n(viewOf(colour).row(y), 300, Rgb(std::uint8_t{90}));
  }
  burnMarker(viewOf(grey), linear(), fan());
  burnMarker(viewOf(colour), linear(), fan());
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) ASSERT_EQ(viewOf(colour).at(x, y), Rgb(viewOf(grey).at(x, y)));
}

}  // namespace
}  // namespace ew::orientation_marker_test
