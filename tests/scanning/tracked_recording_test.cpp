// What a tracked probe scanned, recorded, and played again.
#include <gtest/gtest.h>

#include "ew/scanning/cine.h"
#include "ew/scanning/contact.h"
#include "ew/scanning/recording.h"
#include "ew/scanning/replay.h"
#include "library/temporary_folder.h"
#include "scanning/small_scan.h"
#include "scanning/tracked_scan.h"
#include "tracking/skins.h"

namespace ew::tracked_recording_test {
namespace {

constexpr glm::ivec2 kSize_px{150, 120};

/// Down on the plane z = 0, sliding, rocking, lifted off for a moment and put on again.
Transform<frame::World, frame::Probe> inHand(double t) {
  const double rock = 0.2 * std::sin(1.1 * t), lift_mm = -1.0 + (t > 2.0 && t < 2.6 ? 9.0 : 0.0);
  glm::dmat4 pose(1.0);
  pose[0] = {std::cos(rock), 0.0, -std::sin(rock), 0.0};
  pose[1] = {-std::sin(rock), 0.0, -std::cos(rock), 0.0};
  pose[2] = {0.0, 1.0, 0.0, 0.0};
  pose[3] = {6.0 * std::sin(0.9 * t), 5.0 * std::sin(1.7 * t), lift_mm, 1.0};
  return {pose};
}

std::vector<std::uint8_t> pixelsOf(ImageView<const std::uint8_t> image) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < image.height; ++y) pixels.insert(pixels.end(), image.row(y), image.row(y) + image.width);
  return pixels;
}

struct Scanned {
  ScanRecording recording;
  std::vector<std::vector<std::uint8_t>> images;  ///< of each frame with a pose; empty where it was missed
  std::vector<std::vector<std::uint8_t>> strips;
};

/// As the window does it: what is missed is not made, and forgotten before; the recording has a frame for it.
Scanned scanned(const test::TrackedScan& how, DisplayMode mode) {
  Scanned made;
  made.recording.title = "waves";
  made.recording.size_px = kSize_px;
  Scanner scanner(2);
  scanner.show(test::waveSubject());
  bool isLost = false;
  std::uint64_t number = 0;
  test::scanTracked(how, inHand, [&](double time_s, const Pose& pose) {
    ScanState state;
    state.probe = test::smallProbe();
    state.knobs.persistence = 0.5;
    state.knobs.mode = mode;
    state.scene.gainAndDgc = true;
    state.scene.noise.emplace();
    state.scene.contact.emplace();
    state.pose = pose;
    state.time_s = time_s;
    state.number = ++number;
    if (pose.status == PoseStatus::ok) {
      state.gaps_mm = gapsToSkin_mm(state.probe, pose, test::PlaneSkin());
      made.images.push_back(pixelsOf(scanner.make(state, kSize_px.x, kSize_px.y).grey));
      made.strips.push_back(pixelsOf(scanner.strip()));
    } else {
      if (made.images.empty()) return;
      if (!isLost) scanner.forget();
      made.images.emplace_back();
      made.strips.emplace_back();
    }
    isLost = pose.status != PoseStatus::ok;
    made.recording.log.addFrame(state);
  });
  return made;
}

class TrackedRecording : public ::testing::TestWithParam<double> {
 protected:
  test::TemporaryFolder folder_;
};

TEST_P(TrackedRecording, ReplaysToTheSamePixelsThroughGaps) {
  for (const DisplayMode mode : {DisplayMode::bMode, DisplayMode::both}) {
    test::TrackedScan how;
    how.rate_hz = GetParam();
    how.seconds = 5.0;
    how.noise_mm = 0.05;
    how.stateAt = [](double t) {
      if (t > 1.0 && t < 1.6) return TrackingState::outOfView;
      if (t > 3.5 && t < 3.9) return TrackingState::invalid;
      return TrackingState::live;
    };
    const Scanned made = scanned(how, mode);
    std::size_t missed = 0;
    for (const auto& image : made.images) missed += image.empty() ? 1 : 0;
    EXPECT_GT(missed, 10u);
    EXPECT_GT(made.images.size() - missed, 80u);

    const auto file = folder_ / "tracked.seq.mha";
    const auto written = writeRecording(made.recording, file, noProgress());
    ASSERT_TRUE(written) << written.error();
    const auto read = readRecording(file, noProgress());
    ASSERT_TRUE(read) << read.error();
    ASSERT_EQ(read->log.frameCount(), made.images.size());
    Replay replay(read->log, test::waveSubject(), 1);
    for (std::size_t n = 0; n < made.images.size(); ++n) {
      EXPECT_EQ(read->log.frame(n).pose.status, made.recording.log.frame(n).pose.status) << n;
      const auto pixels = pixelsOf(replay.make(n, kSize_px.x, kSize_px.y).grey);
      if (made.images[n].empty()) {
        EXPECT_TRUE(std::all_of(pixels.begin(), pixels.end(), [](std::uint8_t grey) { return grey == 0; })) << n;
        continue;
      }
      ASSERT_EQ(pixels, made.images[n]) << "frame " << n << " at " << GetParam();
      ASSERT_EQ(pixelsOf(replay.scanner().strip()), made.strips[n]) << "strip of frame " << n;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rates, TrackedRecording, ::testing::Values(30.0, 60.0, 100.0));

TEST(TrackingPace, MakesAnImageOfEveryReadingOfACameraAndOfEverySecondAndThirdOfFasterTrackers) {
  for (const auto& [rate_hz, images_hz] : {std::pair(30.0, 30.0), std::pair(60.0, 30.0), std::pair(100.0, 33.3)}) {
    int count = 0;
    double oldest_s = 0.0;
    test::TrackedScan how;
    how.rate_hz = rate_hz;
    how.jitter_s = 0.0;
    test::scanTracked(how, inHand, [&](double time_s, const Pose& pose) {
      ++count;
      if (count > 1) oldest_s = std::max(oldest_s, time_s - pose.time_s);
    });
    EXPECT_NEAR(count / how.seconds, images_hz, 1.0) << rate_hz;
    // 12 ms on the way, and never a reading that waits for the next image while there is time to make one of it.
    EXPECT_LT(oldest_s, 0.012 + 0.003) << rate_hz;
  }
  EXPECT_EQ(trackedPace(10.0, 0.005), (TrackingPace{10.0 + 0.025, 10.0 + 0.045}));
  EXPECT_EQ(trackedPace(10.0, 0.03125), (TrackingPace{10.0625, 10.0625})) << "half of the time is left";
  EXPECT_EQ(trackedPace(10.0, 0.5), (TrackingPace{10.5 + 0.2, 10.5 + 0.2}));
}

}  // namespace
}  // namespace ew::tracked_recording_test
