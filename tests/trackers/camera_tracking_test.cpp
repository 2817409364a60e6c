#include "ew/trackers/camera_tracking.h"

#include <gtest/gtest.h>

#include "trackers/camera_frames.h"

namespace ew {
namespace {

using test::imageOf;
using test::poseAt;
using test::smallBoard;
using test::smallCamera;

CameraTrackingOptions inLight() {
  CameraTrackingOptions options;
  options.gamma = 1.0;  // the images of these tests are light itself
  return options;
}

CameraTracker trackerOf(std::vector<MarkerBody> bodies, const CameraTrackingOptions& options = inLight()) {
  auto tracker = CameraTracker::make(smallCamera(), std::move(bodies), options);
  if (!tracker) throw std::runtime_error(tracker.error().sentence());
  return *std::move(tracker);
}

double largestDifference(const glm::dmat4& a, const glm::dmat4& b) {
  double most = 0.0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) most = std::max(most, std::abs(a[c][r] - b[c][r]) * (c == 3 ? 1.0 : 100.0));
  return most;
}

TEST(CameraTracking, FindsABoardWhereItIs) {
  CameraTracker tracker = trackerOf({smallBoard()});
  for (const double tilt : {0.35, 0.6, -0.5}) {
    const glm::dmat4 truth = poseAt({20.0, -15.0, 380.0}, tilt);
    tracker.forget();
    const auto sight = tracker.track(viewOf(imageOf(smallCamera(), smallBoard(), truth)), 0.0);
    ASSERT_EQ(sight.bodies[0].state, TrackingState::live) << tilt;
    EXPECT_EQ(sight.bodies[0].markers, 4);
    EXPECT_LT(largestDifference(sight.bodies[0].bodyToCamera.matrix, truth), 0.3) << sight.bodies[0].bodyToCamera;
    EXPECT_LT(sight.bodies[0].rms_px, 0.1);
    EXPECT_FALSE(sight.bodies[0].ambiguous);
  }
}

TEST(CameraTracking, LooksAroundTheLastPlaceAndFindsTheSame) {
  CameraTracker following = trackerOf({smallBoard()});
  CameraTrackingOptions everywhere = inLight();
  everywhere.followsRegions = false;
  CameraTracker searching = trackerOf({smallBoard()}, everywhere);
  for (int n = 0; n < 4; ++n) {
    const auto image = imageOf(smallCamera(), smallBoard(), poseAt({20.0 + 3.0 * n, -15.0, 380.0}, 0.5));
    const auto near = following.track(viewOf(image), n / 30.0), whole = searching.track(viewOf(image), n / 30.0);
    EXPECT_EQ(near.searchedWhole, n == 0);
    EXPECT_TRUE(whole.searchedWhole);
    ASSERT_EQ(near.bodies[0].state, TrackingState::live);
    EXPECT_LT(largestDifference(near.bodies[0].bodyToCamera.matrix, whole.bodies[0].bodyToCamera.matrix), 0.1);
    if (n > 0) {
      EXPECT_NEAR(near.bodies[0].speed_pxPerS, 3.0 * 30.0 * smallCamera().fx / 380.0, 40.0);
    }
  }
}

TEST(CameraTracking, ABodyThatIsNotThereIsOutOfView) {
  CameraTracker tracker = trackerOf({smallBoard(30), smallBoard(60)});
  const auto sight = tracker.track(viewOf(imageOf(smallCamera(), smallBoard(30), poseAt({0, 0, 380}, 0.5))), 0.0);
  EXPECT_EQ(sight.bodies[0].state, TrackingState::live);
  EXPECT_EQ(sight.bodies[1].state, TrackingState::outOfView);
  GreyImage nothing(640, 480, 128);
  EXPECT_EQ(tracker.track(viewOf(nothing), 0.1).bodies[0].state, TrackingState::outOfView);
}

TEST(CameraTracking, AMarkerThatDisagreesIsLeftOut) {
  MarkerBody wrong = smallBoard();
  for (auto& corner : wrong.markers[3].corners_mm) corner += glm::dvec3(6.0, 4.0, 0.0);  // glued on beside its place
  CameraTracker tracker = trackerOf({wrong});
  const glm::dmat4 truth = poseAt({20.0, -15.0, 380.0}, 0.5);
  const auto sight = tracker.track(viewOf(imageOf(smallCamera(), smallBoard(), truth)), 0.0);
  ASSERT_EQ(sight.bodies[0].state, TrackingState::live);
  EXPECT_EQ(sight.bodies[0].markers, 3);
  for (const MarkerSight& marker : sight.markers) EXPECT_EQ(marker.used, marker.id != 33) << marker.id;
  EXPECT_LT(largestDifference(sight.bodies[0].bodyToCamera.matrix, truth), 0.6);
}

TEST(CameraTracking, ASmallFlatMarkerSeenFromAfarIsNotShownAsIfItWereSure) {
  MarkerBody one = smallBoard();
  one.markers.resize(1);
  CameraTracker tracker = trackerOf({one});
  // Straight on and far away two tilts explain the image alike, and neither is known.
  const auto sight = tracker.track(viewOf(imageOf(smallCamera(), smallBoard(), poseAt({0, 0, 1100}, 0.12))), 0.0);
  EXPECT_NE(sight.bodies[0].state, TrackingState::live);
}

TEST(CameraTracking, OneMarkerThatIsReadAsAnotherTurnsNoProbe) {
  // Two faces of a body, a third of a turn apart; the camera sees one of them, and for one image a thumb makes it look like the other.
  MarkerBody body = smallBoard(30);
  body.markers.resize(2);
  const glm::dmat3 third(glm::rotate(glm::dmat4(1.0), glm::radians(120.0), glm::dvec3(0.0, 1.0, 0.0)));
  for (std::size_t n = 0; n < 4; ++n) body.markers[1].corners_mm[n] = third * body.markers[0].corners_mm[n];
  MarkerBody seen = smallBoard(30), misread = smallBoard(31);
  seen.markers.resize(1);
  misread.markers.resize(1);
  const glm::dmat4 truth = poseAt({20.0, -15.0, 330.0}, 0.6);
  const auto right = imageOf(smallCamera(), seen, truth), wrong = imageOf(smallCamera(), misread, truth);
  CameraTracker tracker = trackerOf({body});
  ASSERT_EQ(tracker.track(viewOf(right), 0.0).bodies[0].state, TrackingState::live);
  const auto jumped = tracker.track(viewOf(wrong), 1.0 / 30.0);
  EXPECT_EQ(jumped.bodies[0].markers, 1);
  EXPECT_EQ(jumped.bodies[0].state, TrackingState::outOfRange);
  const auto again = tracker.track(viewOf(right), 2.0 / 30.0);
  ASSERT_EQ(again.bodies[0].state, TrackingState::live);
  EXPECT_LT(largestDifference(again.bodies[0].bodyToCamera.matrix, truth), 0.6);
  EXPECT_EQ(tracker.track(viewOf(wrong), 2.0).bodies[0].state, TrackingState::live) << "in two seconds a hand turns a probe round";
}

TEST(CameraTracking, UsesNoMoreMarkersThanAskedFor) {
  CameraTrackingOptions options = inLight();
  options.mostMarkers = 2;
  CameraTracker tracker = trackerOf({smallBoard()}, options);
  const auto sight = tracker.track(viewOf(imageOf(smallCamera(), smallBoard(), poseAt({0, 0, 380}, 0.5))), 0.0);
  EXPECT_EQ(sight.bodies[0].markers, 2);
}

TEST(CameraTracking, RefusesBodiesThatCannotBe) {
  const auto refusal = [](std::vector<MarkerBody> bodies) {
    const auto made = CameraTracker::make(smallCamera(), std::move(bodies));
    return made ? std::string("made") : made.error().sentence();
  };
  MarkerBody body = smallBoard();
  EXPECT_NE(refusal({body, body}).find("Marker 30 is used twice"), std::string::npos);
  body.dictionary = "runes";
  EXPECT_NE(refusal({body}).find("runes"), std::string::npos);
  body = smallBoard();
  body.markers[1].corners_mm[2].z += 9.0;
  EXPECT_NE(refusal({body}).find("Marker 31"), std::string::npos);
}

}  // namespace
}  // namespace ew
