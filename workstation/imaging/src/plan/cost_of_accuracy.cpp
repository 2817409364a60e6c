#include "ew/imaging/cost_of_accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "cost_parts.h"
#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr int kLobes = 5;
constexpr int kTaps = 2 * kLobes;
constexpr int kMostPerPose = 20'000;  // points compared for each pose: 1000 multiplications each

double sinc(double x) { return x == 0.0 ? 1.0 : std::sin(glm::pi<double>() * x) / (glm::pi<double>() * x); }

/// Weights of the taps around `fraction` in [0, 1): tap t lies at t - kLobes + 1.
std::array<double, kTaps> lanczosWeights(double fraction) {
  std::array<double, kTaps> weights{};
  double sum = 0.0;
  for (int t = 0; t < kTaps; ++t) {
    const double x = t - kLobes + 1 - fraction;
    weights[static_cast<std::size_t>(t)] = std::abs(x) < kLobes ? sinc(x) * sinc(x / kLobes) : 0.0;
    sum += weights[static_cast<std::size_t>(t)];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Where slices are compared, and what the reference says there.
struct Exact {
  struct Point {
    int x, y;
    double level;
  };
  std::vector<std::vector<Point>> ofPose;
};

}  // namespace

double sampledExactly(const SliceSource& echo, const glm::dvec3& p_voxel) {
  EW_EXPECTS(echo.layout == VoxelLayout::linear);
  const glm::dvec3 lowest = glm::floor(p_voxel);
  // Compared before it becomes a whole number, which has no room for a point far away; NaN compares false.
  for (int axis = 0; axis < 3; ++axis) {
    if (!(lowest[axis] >= kLobes - 1 && lowest[axis] < echo.grid.dims[axis] - kLobes)) return -1.0;
  }
  const glm::ivec3 base(lowest);
  const glm::dvec3 fraction = p_voxel - glm::dvec3(base);
  const auto alongI = lanczosWeights(fraction.x);
  const auto alongJ = lanczosWeights(fraction.y);
  const auto alongK = lanczosWeights(fraction.z);
  double level = 0.0;
  for (int k = 0; k < kTaps; ++k) {
    double plane = 0.0;
    for (int j = 0; j < kTaps; ++j) {
      const std::uint8_t* row = echo.voxels + echo.grid.indexOf(base.x - kLobes + 1, base.y - kLobes + 1 + j, base.z - kLobes + 1 + k);
      double line = 0.0;
      for (int i = 0; i < kTaps; ++i) line += alongI[static_cast<std::size_t>(i)] * row[i];
      plane += alongJ[static_cast<std::size_t>(j)] * line;
    }
    level += alongK[static_cast<std::size_t>(k)] * plane;
  }
  return std::clamp(level, 0.0, 255.0);
}

const CostPoint* fastestWithin(const std::vector<CostPoint>& points, double psnr_db) {
  const CostPoint* best = nullptr;
  for (const CostPoint& point : points) {
    if (point.psnr_db >= psnr_db && (best == nullptr || point.frame_ms < best->frame_ms)) best = &point;
  }
  return best;
}

namespace {

/// One measurement: the reference first, then each quality and each number of planes against it. What can be cancelled returns false then.
class CostMeasurement {
 public:
  CostMeasurement(const SliceSource& echo, const Probe& probe, const Knobs& asked, const Scene& scene, const Pose& pose, int width,
                  int height, const CostOptions& options, Progress& progress)
      : echo_(echo),
        asked_(asked),
        neutral_(detail::neutralOf(asked)),
        quiet_(detail::quietOf(scene)),
        poses_(detail::posesAround(pose, options.poses)),
        input_{.echo = echo},
        bench_{input_, probe, quiet_, poses_, width, height, options},
        geometry_(fitDisplay(probe, neutral_, width, height)),
        fan_(fanSpans(probe, neutral_, geometry_)),
        progress_(progress) {
    result.poses = options.poses;
  }

  [[nodiscard]] bool computeExact();
  [[nodiscard]] bool timeQualities();
  [[nodiscard]] bool timePlanes();

  CostOfAccuracy result;

 private:
  [[nodiscard]] bool compareSlices(Quality quality, detail::Difference& difference);

  const SliceSource& echo_;
  const Knobs& asked_;
  Knobs neutral_;
  Scene quiet_;
  std::vector<Pose> poses_;
  FrameInput input_;
  detail::CostBench bench_;
  DisplayGeometry geometry_;
  Spans fan_;
  Progress& progress_;
  Exact exact_;
};

/// On at most kMostPerPose points of each image: a grid of them, so that all depths count alike.
bool CostMeasurement::computeExact() {
  progress_.report(say<"Computing the exact slices">(), 0.0);
  const int every = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(bench_.width) * bench_.height / kMostPerPose))));
  for (const Pose& one : poses_) {
    auto& points = exact_.ofPose.emplace_back();
    const glm::dmat4 imageToVoxel = (echo_.grid.worldToVoxel() * one.probeToWorld * geometry_.imageToProbe()).matrix;
    for (int y = 0; y < bench_.height; y += every) {
      if (progress_.cancelRequested()) return false;
      for (const RowSpan& run : fan_[static_cast<std::size_t>(y)]) {
        for (int x = (run.begin + every - 1) / every * every; x < run.end; x += every) {
          const double level = sampledExactly(echo_, glm::dvec3(imageToVoxel * glm::dvec4(x, y, 0.0, 1.0)));
          if (level >= 0.0) points.push_back({x, y, level});
        }
      }
    }
    result.comparedPixels += points.size();
    progress_.report(say<"Computing the exact slices">(),
                     0.5 * static_cast<double>(exact_.ofPose.size()) / static_cast<double>(poses_.size()));
  }
  return true;
}

bool CostMeasurement::timeQualities() {
  for (const Quality quality : {Quality::weave, Quality::linear, Quality::cubic}) {
    CostPoint point;
    point.knobs = asked_;
    point.knobs.quality = quality;
    Knobs knobs = neutral_;
    knobs.quality = quality;
    progress_.report(say<"Timing the qualities">(), 0.5 + 0.1 * static_cast<double>(result.qualities.size()));
    point.frame_ms = bench_.time_ms(knobs, progress_, [](const Pose&, const ImageView<const std::uint8_t>&, const FrameMaker&) {});
    if (point.frame_ms < 0.0) return false;
    detail::Difference difference;
    if (!compareSlices(quality, difference)) return false;
    difference.putInto(point);
    result.qualities.push_back(point);
  }
  return true;
}

/// Slices of a quality against the exact ones.
bool CostMeasurement::compareSlices(Quality quality, detail::Difference& difference) {
  GreyImage image(bench_.width, bench_.height);
  SliceScratch scratch;
  for (std::size_t n = 0; n < poses_.size(); ++n) {
    if (progress_.cancelRequested()) return false;
    slice(quality, echo_, echo_.grid.worldToVoxel() * poses_[n].probeToWorld * geometry_.imageToProbe(), fan_, viewOf(image), scratch);
    for (const Exact::Point& p : exact_.ofPose[n]) difference.add(viewOf(image).at(p.x, p.y) - p.level);
  }
  return true;
}

/// Fewer planes across the slice against the most.
bool CostMeasurement::timePlanes() {
  constexpr int kMost = 9;
  std::vector<GreyImage> finest;
  for (int planes = kMost; planes >= 3; planes -= 2) {
    CostPoint point;
    point.knobs = asked_;
    point.knobs.elevationPlanes = planes;
    Knobs knobs = neutral_;
    knobs.elevationPlanes = planes;
    progress_.report(say<"Timing the slice thickness">(), 0.8 + 0.05 * static_cast<double>(result.planes.size()));
    detail::Difference difference;
    std::size_t n = 0;
    point.frame_ms =
        bench_.time_ms(knobs, progress_, [&](const Pose&, const ImageView<const std::uint8_t>& image, const FrameMaker& maker) {
          if (planes == kMost) {
            GreyImage& kept = finest.emplace_back(image.width, image.height);
            for (int y = 0; y < image.height; ++y) std::copy_n(image.row(y), image.width, viewOf(kept).row(y));
          }
          for (int y = 0; y < image.height; ++y) {
            for (const RowSpan& run : maker.spans()[static_cast<std::size_t>(y)]) {
              for (int x = run.begin; x < run.end; ++x) difference.add(static_cast<double>(image.at(x, y)) - viewOf(finest[n]).at(x, y));
            }
          }
          ++n;
        });
    if (point.frame_ms < 0.0) return false;
    difference.putInto(point);
    result.planes.insert(result.planes.begin(), point);
  }
  return true;
}

}  // namespace

Result<CostOfAccuracy> measureCostOfAccuracy(const SliceSource& echo, const Probe& probe, const Knobs& asked, const Scene& scene,
                                             const Pose& pose, int width, int height, const CostOptions& options, Progress& progress) {
  EW_EXPECTS(width >= 1 && height >= 1 && options.poses >= 1 && options.repeats >= 1);
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"The measurement was cancelled.">()); };
  if (auto usable = detail::checkUsable(pose); !usable) return passOn(usable.error());
  if (echo.empty()) return failure(ErrorCode::emptyVolume, say<"There is no volume to measure with; open one first.">());

  CostMeasurement measurement(echo, probe, asked, scene, pose, width, height, options, progress);
  if (!measurement.computeExact()) return cancelled();
  if (measurement.result.comparedPixels < detail::kFewestCompared) {
    return failure(ErrorCode::emptyVolume,
                   say<"The probe sees too little of the volume to compare; slide it over the volume and measure again.">());
  }
  if (!measurement.timeQualities()) return cancelled();
  if (scene.sliceThickness && !measurement.timePlanes()) return cancelled();
  progress.report(scene.sliceThickness ? say<"Timing the slice thickness">() : say<"Timing the qualities">(), 1.0);
  return std::move(measurement.result);
}

}  // namespace ew
