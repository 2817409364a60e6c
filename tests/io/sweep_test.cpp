#include "ew/io/sweep.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "files.h"

namespace ew::sweep_test {
namespace {
using namespace test;

glm::dmat4 moved(double x, double angle) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(x, 2, 3)) * glm::rotate(glm::dmat4(1.0), angle, glm::normalize(glm::dvec3(1, 2, -1)));
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
  double worst = 0.0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) worst = std::max(worst, std::abs(a[column][row] - b[column][row]));
  return worst;
}

const glm::dmat4 kImageToProbe = moved(15, 0.4) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.08, 0.07, 0.075));

DeviceSet calibration() {
  DeviceSet set;
  set.transforms = {{"Image", "Probe", kImageToProbe, PoseStatus::ok}, {"Phantom", "Reference", moved(1, 0.1), PoseStatus::ok}};
  return set;
}

/// Frames with a tracked probe and reference, and a stylus nobody uses that is INVALID throughout.
Sequence tracked(int frames) {
  Sequence sequence;
  for (int i = 0; i < frames; ++i) {
    SequenceFrame frame;
    frame.time_s = 0.1 * i;
    frame.imageStatus = PoseStatus::ok;
    frame.transforms = {{"Probe", "Tracker", moved(i, 0.2 + 0.01 * i), PoseStatus::ok},
                        {"Reference", "Tracker", moved(-5, -0.3), PoseStatus::ok},
                        {"Stylus", "Tracker", glm::dmat4(0.0), PoseStatus::invalid}};
    sequence.frames.push_back(frame);
  }
  return sequence;
}

TEST(Chain, GoesForwardsAndBackwards) {
  const auto sequence = tracked(1);
  auto all = sequence.frames[0].transforms;
  all.push_back({"Image", "Probe", kImageToProbe, PoseStatus::ok});
  const auto found = chain(all, "Image", "Reference");
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(difference(*found, glm::inverse(moved(-5, -0.3)) * moved(0, 0.2) * kImageToProbe), 1e-12);
  EXPECT_EQ(chain(all, "Image", "Image"), glm::dmat4(1.0));
  EXPECT_FALSE(chain(all, "Image", "Stylus").has_value());
  EXPECT_FALSE(chain(all, "Nobody", "Image").has_value());
  EXPECT_EQ(reachableFrom(all, "Image"), (std::vector<std::string>{"Probe", "Tracker", "Reference"}));
}

TEST(Chain, TakesTheShortestWay) {
  const std::vector<FrameTransform> all{{"Image", "Probe", moved(1, 0), PoseStatus::ok},
                                        {"Probe", "Reference", moved(1, 0), PoseStatus::ok},
                                        {"Image", "Reference", moved(9, 0), PoseStatus::ok}};
  EXPECT_EQ(chain(all, "Image", "Reference"), moved(9, 0));
}

RC_GTEST_PROP(Chain, ThereAndBackIsWhereItStarted, ()) {
  // A random tree of frames: between any two of them there is exactly one way.
  const int count = *rc::gen::inRange(2, 12);
  std::vector<FrameTransform> all;
  const auto angle = [] { return *rc::gen::inRange(-300, 300) / 100.0; };
  for (int i = 1; i < count; ++i) {
    const std::string older = "F" + std::to_string(*rc::gen::inRange(0, i));
    const std::string newer = "F" + std::to_string(i);
    const glm::dmat4 matrix = moved(angle(), angle());
    if (*rc::gen::arbitrary<bool>())
      all.push_back({older, newer, matrix, PoseStatus::ok});
    else
      all.push_back({newer, older, matrix, PoseStatus::ok});
  }
  const std::string a = "F" + std::to_string(*rc::gen::inRange(0, count));
  const std::string b = "F" + std::to_string(*rc::gen::inRange(0, count));
  const auto there = chain(all, a, b);
  const auto back = chain(all, b, a);
  RC_ASSERT(there.has_value());
  RC_ASSERT(back.has_value());
  RC_ASSERT(difference(*back * *there, glm::dmat4(1.0)) < 1e-9);
  RC_ASSERT(reachableFrom(all, a).size() == static_cast<std::size_t>(count - 1));
}

TEST(Chain, MatricesThatCannotBeInvertedOrAreNotFiniteAreNoWay) {
  glm::dmat4 flat(1.0);
  flat[2] = glm::dvec4(0.0);
  glm::dmat4 projective(1.0);
  projective[0][3] = 0.5;
  glm::dmat4 broken(1.0);
  broken[3][0] = std::numeric_limits<double>::quiet_NaN();
  for (const glm::dmat4& matrix : {flat, projective, broken, glm::dmat4(0.0)}) {
    const std::vector<FrameTransform> all{{"Image", "Reference", matrix, PoseStatus::ok}};
    EXPECT_FALSE(chain(all, "Image", "Reference").has_value());
    EXPECT_TRUE(reachableFrom(all, "Image").empty());
  }
  // A fine calibration has small axes: that is not flat.
  const std::vector<FrameTransform> fine{{"Image", "Reference", glm::scale(glm::dmat4(1.0), glm::dvec3(1e-6)), PoseStatus::ok}};
  EXPECT_TRUE(chain(fine, "Image", "Reference").has_value());
}

TEST(SweepPoses, FollowTheChainOfEachFrame) {
  const auto set = calibration();
  const auto poses = sweepPoses(tracked(5), &set);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->toFrame, "Reference");
  EXPECT_EQ(poses->usable, 5u);
  EXPECT_EQ(poses->invalid + poses->missing, 0u);
  for (int i = 0; i < 5; ++i) {
    const glm::dmat4 expected = glm::inverse(moved(-5, -0.3)) * moved(i, 0.2 + 0.01 * i) * kImageToProbe;
    EXPECT_LT(difference(poses->imageToWorld[static_cast<std::size_t>(i)]->matrix, expected), 1e-12) << i;
  }
  EXPECT_TRUE(contains(poses->notes, "frame Reference"));
}

TEST(SweepPoses, TheTargetFrameCanBeChosen) {
  const auto set = calibration();
  const auto tracker = sweepPoses(tracked(2), &set, "Tracker");
  ASSERT_TRUE(succeeded(tracker));
  EXPECT_LT(difference(tracker->imageToWorld[1]->matrix, moved(1, 0.21) * kImageToProbe), 1e-12);
  const auto phantom = sweepPoses(tracked(2), &set, "Phantom");
  ASSERT_TRUE(succeeded(phantom));
  EXPECT_LT(difference(phantom->imageToWorld[0]->matrix,
                       glm::inverse(moved(1, 0.1)) * glm::inverse(moved(-5, -0.3)) * moved(0, 0.2) * kImageToProbe),
            1e-12);
}

TEST(SweepPoses, WithoutAReferenceTheTrackerIsUsedAndSaid) {
  auto sequence = tracked(2);
  for (auto& frame : sequence.frames) frame.transforms.erase(frame.transforms.begin() + 1);
  const auto set = calibration();
  const auto poses = sweepPoses(sequence, &set);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->toFrame, "Tracker");
  EXPECT_TRUE(contains(poses->notes, "frame Tracker"));
  // The same when the reference is named but never valid.
  sequence = tracked(2);
  for (auto& frame : sequence.frames) frame.transforms[1].status = PoseStatus::invalid;
  const auto lost = sweepPoses(sequence, &set);
  ASSERT_TRUE(succeeded(lost));
  EXPECT_EQ(lost->toFrame, "Tracker");
  EXPECT_TRUE(contains(lost->notes, "No frame has a valid way to Reference"));
}

TEST(SweepPoses, InvalidAndMissingFramesAreDroppedAndCounted) {
  auto sequence = tracked(6);
  sequence.frames[1].transforms[0].status = PoseStatus::invalid;
  sequence.frames[2].transforms.clear();
  sequence.frames[3].imageStatus = PoseStatus::invalid;
  sequence.frames[4].transforms[1].status = PoseStatus::missing;
  const auto set = calibration();
  const auto poses = sweepPoses(sequence, &set);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->usable, 2u);
  EXPECT_EQ(poses->invalid, 2u);
  EXPECT_EQ(poses->missing, 2u);
  ASSERT_EQ(poses->imageToWorld.size(), 6u);
  EXPECT_TRUE(poses->imageToWorld[0] && poses->imageToWorld[5]);
  for (const std::size_t dropped : {1u, 2u, 3u, 4u}) EXPECT_FALSE(poses->imageToWorld[dropped]) << dropped;
  EXPECT_TRUE(contains(poses->notes, "2 frames with an INVALID and 2 with a missing pose"));
}

TEST(SweepPoses, AMissingCalibrationNamesWhatIsThereAndWhatToGive) {
  const auto none = sweepPoses(tracked(3), nullptr);
  EXPECT_TRUE(failedWith(none, ErrorCode::missingCalibration));
  EXPECT_TRUE(says(none, "Probe, Reference, Stylus and Tracker"));
  EXPECT_TRUE(says(none, "device set"));
  EXPECT_TRUE(says(none, "from Image to Probe"));
  DeviceSet other;
  other.transforms = {{"Image", "TransducerOriginPixel", glm::dmat4(1.0), PoseStatus::ok}};
  const auto elsewhere = sweepPoses(tracked(3), &other);
  EXPECT_TRUE(failedWith(elsewhere, ErrorCode::missingCalibration));
  EXPECT_TRUE(says(elsewhere, "TransducerOriginPixel can be reached"));
  Sequence untracked;
  untracked.frames.resize(3);
  const auto nothing = sweepPoses(untracked, nullptr);
  EXPECT_TRUE(failedWith(nothing, ErrorCode::missingCalibration));
  EXPECT_TRUE(says(nothing, "no tracked poses"));
}

TEST(SweepPoses, WithoutOneValidPoseBothCountsAreSaid) {
  auto sequence = tracked(5);
  for (auto& frame : sequence.frames) frame.transforms[0].status = PoseStatus::invalid;
  sequence.frames[2].transforms.clear();
  const auto set = calibration();
  const auto poses = sweepPoses(sequence, &set);
  EXPECT_TRUE(failedWith(poses, ErrorCode::noValidPose));
  EXPECT_TRUE(says(poses, "4 are INVALID and 1 missing"));
}

TEST(SweepPoses, ADeviceSetStandsInForTheFilesOwnCalibration) {
  auto sequence = tracked(2);
  for (auto& frame : sequence.frames) frame.transforms.push_back({"Image", "Probe", glm::dmat4(1.0), PoseStatus::ok});
  const auto own = sweepPoses(sequence, nullptr, "Probe");
  ASSERT_TRUE(succeeded(own));
  EXPECT_EQ(own->imageToWorld[0]->matrix, glm::dmat4(1.0));
  const auto set = calibration();
  const auto given = sweepPoses(sequence, &set, "Probe");
  ASSERT_TRUE(succeeded(given));
  EXPECT_EQ(given->imageToWorld[0]->matrix, kImageToProbe);
  EXPECT_TRUE(contains(given->notes, "the device set was used"));
}

TEST(SweepPoses, OddCalibrationsAreKeptAndNoted) {
  DeviceSet set = calibration();
  set.transforms[0].matrix[1] += 0.048 * set.transforms[0].matrix[0];
  const auto skewed = sweepPoses(tracked(1), &set, "Probe");
  ASSERT_TRUE(succeeded(skewed));
  EXPECT_EQ(skewed->imageToWorld[0]->matrix, set.transforms[0].matrix);
  EXPECT_TRUE(contains(skewed->notes, "off the right angle"));
  set = calibration();
  set.transforms[0].matrix[2] *= -1.0;
  const auto mirrored = sweepPoses(tracked(1), &set, "Probe");
  ASSERT_TRUE(succeeded(mirrored));
  EXPECT_TRUE(contains(mirrored->notes, "mirrored"));
}

}  // namespace
}  // namespace ew::sweep_test
