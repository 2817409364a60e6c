#include "ew/imaging/cost_of_accuracy.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "ew/core/volume.h"

namespace ew::cost_of_accuracy_test {
namespace {

Probe smallProbe() {
  Probe probe;
  probe.kind = ProbeKind::linear;
  probe.width_mm = 40.0;
  probe.minDepth_mm = 20.0;
  probe.maxDepth_mm = 60.0;
  probe.defaultDepth_mm = 40.0;
  return probe;
}

/// A field far below the grid's limit, so that a windowed sinc takes it as it is: 127 + sum of three slow waves.
double fieldAt(const glm::dvec3& p) { return 127.0 + 30.0 * std::sin(0.31 * p.x) + 30.0 * std::cos(0.27 * p.y + 0.3 * p.z); }

struct Field {
  Grid grid;
  std::vector<std::uint8_t> voxels;
};

Field makeField(int size) {
  Field field;
  field.grid.dims = glm::ivec3(size);
  field.grid.origin_mm = glm::dvec3(-size / 2.0, -10.0, -size / 2.0);
  field.voxels.resize(field.grid.voxelCount());
  for (int k = 0; k < size; ++k) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        field.voxels[field.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(std::lround(fieldAt({i, j, k})));
      }
    }
  }
  return field;
}

SliceSource sourceOf(const Field& field) { return VolumeView<const std::uint8_t>{field.voxels.data(), field.grid}; }

Pose okPose() {
  Pose pose;
  pose.status = PoseStatus::ok;
  return pose;
}

class CancelAfter final : public Progress {
 public:
  explicit CancelAfter(int questions) : left_(questions) {}
  void report(const Message&, double fraction) override {
    EXPECT_GE(fraction, last_);
    last_ = fraction;
  }
  [[nodiscard]] bool cancelRequested() const override { return --left_ < 0; }

 private:
  mutable std::atomic<int> left_;
  double last_ = 0.0;
};

TEST(CostOfAccuracy, TheReferenceKeepsConstantsAndTakesASlowFieldWithinItsRounding) {
  Field field = makeField(48);
  for (const glm::dvec3 p : {glm::dvec3(20.25, 21.5, 22.75), glm::dvec3(11.1, 30.9, 17.3), glm::dvec3(24.0, 24.0, 24.0)}) {
    EXPECT_NEAR(sampledExactly(sourceOf(field), p), fieldAt(p), 0.6);
  }
  std::fill(field.voxels.begin(), field.voxels.end(), std::uint8_t{93});
  EXPECT_NEAR(sampledExactly(sourceOf(field), {20.3, 19.7, 25.1}), 93.0, 1e-9);
}

TEST(CostOfAccuracy, TheReferenceRefusesPointsWhoseNeighboursAreNotAllThere) {
  const Field field = makeField(32);
  EXPECT_EQ(sampledExactly(sourceOf(field), {3.9, 16.0, 16.0}), -1.0);
  EXPECT_GE(sampledExactly(sourceOf(field), {4.0, 16.0, 16.0}), 0.0);
  EXPECT_GE(sampledExactly(sourceOf(field), {26.9, 16.0, 16.0}), 0.0);
  EXPECT_EQ(sampledExactly(sourceOf(field), {27.0, 16.0, 16.0}), -1.0);
  for (const double away : {-2147483648.0, 2147483647.0, -1e300, 1e300, std::nan("")})
    EXPECT_EQ(sampledExactly(sourceOf(field), {16.0, away, 16.0}), -1.0) << away;
}

TEST(CostOfAccuracy, LinearIsCloserThanWeaveAndCubicCloserThanLinear) {
  const Field field = makeField(72);
  const auto measured = measureCostOfAccuracy(sourceOf(field), smallProbe(), {}, {}, okPose(), 160, 160, {3, 1, 1}, noProgress());
  ASSERT_TRUE(measured.has_value());
  ASSERT_EQ(measured->qualities.size(), 3u);
  const auto& [weave, linear, cubic] = std::tie(measured->qualities[0], measured->qualities[1], measured->qualities[2]);
  EXPECT_EQ(weave.knobs.quality, Quality::weave);
  EXPECT_EQ(cubic.knobs.quality, Quality::cubic);
  EXPECT_GT(linear.psnr_db, weave.psnr_db + 3.0);
  EXPECT_GT(cubic.psnr_db, linear.psnr_db);
  EXPECT_GT(cubic.psnr_db, 50.0);
  for (const CostPoint& point : measured->qualities) {
    EXPECT_GT(point.frame_ms, 0.0);
    EXPECT_GE(point.worst_grey, point.rms_grey);
    EXPECT_NEAR(point.psnr_db, 20.0 * std::log10(255.0 / point.rms_grey), 1e-9);
  }
  EXPECT_TRUE(measured->planes.empty());
}

TEST(CostOfAccuracy, MeasuringTwiceGivesTheSameErrors) {
  const Field field = makeField(64);
  const auto first = measureCostOfAccuracy(sourceOf(field), smallProbe(), {}, {}, okPose(), 96, 96, {2, 1, 1}, noProgress());
  const auto second = measureCostOfAccuracy(sourceOf(field), smallProbe(), {}, {}, okPose(), 96, 96, {2, 1, 1}, noProgress());
  ASSERT_TRUE(first.has_value() && second.has_value());
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(first->qualities[i].rms_grey, second->qualities[i].rms_grey);
  EXPECT_EQ(first->comparedPixels, second->comparedPixels);
}

TEST(CostOfAccuracy, EndsSoonAfterItIsCancelled) {
  const Field field = makeField(64);
  for (const int questions : {0, 5, 200, 201, 204, 205}) {
    CancelAfter progress(questions);
    const auto measured = measureCostOfAccuracy(sourceOf(field), smallProbe(), {}, {}, okPose(), 96, 96, {2, 3, 1}, progress);
    if (measured) continue;  // done before it was asked that often
    EXPECT_EQ(measured.error().code, ErrorCode::cancelled);
  }
}

TEST(CostOfAccuracy, SaysWhyThereIsNothingToCompare) {
  const Field field = makeField(48);
  Pose far = okPose();
  far.probeToWorld.matrix[3] = glm::dvec4(5000.0, 0.0, 0.0, 1.0);
  const auto beside = measureCostOfAccuracy(sourceOf(field), smallProbe(), {}, {}, far, 64, 64, {1, 1, 1}, noProgress());
  ASSERT_FALSE(beside.has_value());
  EXPECT_EQ(beside.error().code, ErrorCode::emptyVolume);
  Pose lost;
  lost.status = PoseStatus::missing;
  EXPECT_FALSE(measureCostOfAccuracy(sourceOf(field), smallProbe(), {}, {}, lost, 64, 64, {1, 1, 1}, noProgress()).has_value());
  Pose broken = okPose();
  broken.probeToWorld.matrix[0] = glm::dvec4(std::nan(""), 0.0, 0.0, 0.0);
  EXPECT_FALSE(measureCostOfAccuracy(sourceOf(field), smallProbe(), {}, {}, broken, 64, 64, {1, 1, 1}, noProgress()).has_value());
}

TEST(CostOfAccuracy, TheFastestThatMeetsAWishIsFound) {
  std::vector<CostPoint> points(3);
  points[0].frame_ms = 1.0;
  points[0].psnr_db = 30.0;
  points[1].frame_ms = 3.0;
  points[1].psnr_db = 50.0;
  points[2].frame_ms = 2.0;
  points[2].psnr_db = 45.0;
  EXPECT_EQ(fastestWithin(points, 20.0), &points[0]);
  EXPECT_EQ(fastestWithin(points, 30.0), &points[0]);
  EXPECT_EQ(fastestWithin(points, 40.0), &points[2]);
  EXPECT_EQ(fastestWithin(points, 48.0), &points[1]);
  EXPECT_EQ(fastestWithin(points, 60.0), nullptr);
}

}  // namespace
}  // namespace ew::cost_of_accuracy_test
