#include "ew/imaging/layout_times.h"

#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "ew/imaging/slicing.h"

namespace ew {
namespace {

using ImageToVoxel = Transform<frame::Voxel, frame::Image>;

constexpr int kSide_px = 200;
constexpr int kPoses = 8;
constexpr double kEnough_us = 1e5;
constexpr std::array kQualities = {Quality::weave, Quality::linear, Quality::cubic};

/// Of the calling thread: what other programs take from it meanwhile does not count.
double processorTime_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Planes through the middle: half of them turned any way, half near one another like those of a hand.
ImageToVoxel planeOf(const glm::ivec3& dims, int pose) {
  const auto t = static_cast<double>(pose);
  const bool smooth = pose % 2 == 1;
  const glm::dvec3 axis =
      smooth ? glm::dvec3(0.8, 0.3, 0.5) : glm::dvec3(std::sin(2.4 * t + 0.3), std::cos(1.7 * t), std::sin(3.1 * t + 1.0));
  const glm::dmat3 axes = glm::mat3_cast(glm::angleAxis(smooth ? 0.5 + 0.05 * t : 0.7 + 0.9 * t, glm::normalize(axis)));
  ImageToVoxel plane;
  for (int a = 0; a < 3; ++a) plane.matrix[a] = glm::dvec4(axes[a], 0.0);
  plane.matrix[3] = glm::dvec4(0.5 * glm::dvec3(dims - 1) - 0.5 * (kSide_px - 1) * (axes[0] + axes[1]), 1.0);
  return plane;
}

}  // namespace

LayoutTimes timeLayouts(const VolumeView<const std::uint8_t>& volume, const BrickedVolume& bricks) {
  const std::array<SliceSource, 2> sources = {SliceSource(volume), bricks.source(volume.grid)};
  constexpr std::size_t kCases = kQualities.size() * kPoses;
  std::array<std::array<double, kCases>, 2> least_us;
  for (auto& row : least_us) row.fill(std::numeric_limits<double>::infinity());
  SliceScratch scratch;
  GreyImage image(kSide_px, kSide_px);
  const double begun_us = processorTime_us();
  // Once round warms up; two more at least, so that a disturbance does not decide.
  for (int round = 0; round < 3 || processorTime_us() - begun_us < kEnough_us; ++round)
    for (std::size_t n = 0; n < kCases; ++n)
      for (std::size_t layout = 0; layout < sources.size(); ++layout) {
        const double start_us = processorTime_us();
        slice(kQualities[n / kPoses], sources[layout], planeOf(volume.grid.dims, static_cast<int>(n % kPoses)), viewOf(image), scratch);
        if (round > 0) least_us[layout][n] = std::min(least_us[layout][n], std::max(processorTime_us() - start_us, 0.1));
      }
  const auto mean_us = [&](std::size_t layout) {
    double sum = 0.0;
    for (const double time_us : least_us[layout]) sum += std::log(time_us);
    return std::exp(sum / kCases);
  };
  return {mean_us(0), mean_us(1)};
}

}  // namespace ew
