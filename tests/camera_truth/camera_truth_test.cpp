#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>

#include "camera_truth/truth_trial.h"

namespace ew::camera_truth {
namespace {

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double each : values) sum += each / static_cast<double>(values.size());
  return sum;
}

class CameraTruth : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no display here to draw the paper bodies on";
  }
  /// Webcam, paper that bulges by 0.2 mm, light from a side, noise.
  static TrialOptions usual() {
    TrialOptions options;
    options.paper.gamma = 2.2;
    options.paper.curl_mm = 0.2;
    options.sequences = 12;
    options.framesEach = 2;
    return options;
  }
};

TEST_F(CameraTruth, AStillProbeIsFoundWithinHalfAMillimetreAndHalfADegreeWhereThePeerIsSeveralOff) {
  TrialOptions options = usual();
  options.plainEvery = 1;
  const TrialResult found = runTrial(options);
  EXPECT_GT(found.live, 20) << textOf(found);
  EXPECT_LT(percentile(found.toCamera.place_mm, 0.5), 0.5) << textOf(found);
  EXPECT_LT(percentile(found.toCamera.turn_deg, 0.5), 0.5);
  EXPECT_LT(percentile(found.toBoard.place_mm, 0.5), 0.5);
  EXPECT_LT(percentile(found.toBoard.turn_deg, 0.5), 0.5);
  EXPECT_GT(percentile(found.plain.place_mm, 0.5), 2.0 * percentile(found.toCamera.place_mm, 0.5));
  EXPECT_EQ(found.toCamera.flipped + found.boardToCamera.flipped, 0);
}

TEST_F(CameraTruth, AMovingProbeIsFoundWithinTwoMillimetres) {
  TrialOptions options = usual();
  options.motion.moves_mm = 80.0;
  options.motion.turns_rad = 0.5;
  options.exposure_s = 0.012;
  options.subFrames = 4;
  options.paper.superSampling = 1;
  options.sequences = 3;
  options.framesEach = 12;
  const TrialResult found = runTrial(options);
  EXPECT_GT(found.live, 30) << textOf(found);
  EXPECT_LT(percentile(found.toCamera.place_mm, 0.95), 2.0) << textOf(found);
  EXPECT_LT(percentile(found.toCamera.turn_deg, 0.95), 1.5);
  EXPECT_LT(percentile(found.toBoard.place_mm, 0.95), 2.0);
}

TEST_F(CameraTruth, CornersLieWhereTheyWerePrintedWhateverTheEncoding) {
  for (const double gamma : {1.0, 2.2}) {
    TrialOptions options = usual();
    options.paper.curl_mm = 0.0;
    options.paper.gamma = options.tracking.gamma = gamma;
    options.sequences = 6;
    options.framesEach = 1;
    const TrialResult found = runTrial(options);
    EXPECT_LT(percentile(found.corners_px, 0.5), 0.05) << textOf(found);
    EXPECT_LT(std::abs(mean(found.outwards_px)), 0.02) << textOf(found);
  }
}

TEST_F(CameraTruth, AnEncodingThatIsNotKnownIsToldFromADistance) {
  TrialOptions options = usual();
  options.paper.curl_mm = 0.0;
  options.paper.gamma = 1.0;  // taken for 2.2
  const TrialResult found = runTrial(options);
  EXPECT_GT(std::abs(mean(found.outwards_px)), 0.3) << "black squares seem larger than they are";
  EXPECT_LT(percentile(found.toCamera.place_mm, 0.5), 0.5) << textOf(found);
}

TEST_F(CameraTruth, NoFlippedPoseIsShownWhereOneFaceIsSeenStraightOn) {
  for (const std::uint64_t seed : {94000u, 7u}) {  // of the first a frame was once off by 13 degrees
    TrialOptions options = usual();
    options.paper.room = false;
    options.paper.superSampling = 1;
    options.paper.gamma = 1.6;
    options.board = false;
    options.motion.straightOn = true;
    options.motion.far_mm = 1000.0;
    options.motion.moves_mm = 60.0;
    options.motion.turns_rad = 0.6;
    options.covered = 0.25;
    options.seed = seed;
    options.sequences = 10;
    options.framesEach = 20;
    const TrialResult found = runTrial(options);
    EXPECT_GT(found.live, 50) << textOf(found);
    EXPECT_EQ(found.toCamera.flipped, 0) << textOf(found);
    EXPECT_LT(percentile(found.toCamera.turn_deg, 1.0), 7.0) << textOf(found);
  }
}

TEST_F(CameraTruth, AThumbOverAMarkerDoesNotMoveTheProbe) {
  TrialOptions options = usual();
  options.covered = 1.0;
  const TrialResult found = runTrial(options);
  EXPECT_LT(percentile(found.toCamera.place_mm, 0.5), 0.7) << textOf(found);
  EXPECT_EQ(found.toCamera.flipped, 0);
}

}  // namespace
}  // namespace ew::camera_truth
