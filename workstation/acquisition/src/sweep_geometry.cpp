#include "ew/acquisition/sweep_geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ew/core/contract.h"
#include "ew/core/order_statistics.h"

namespace ew {
namespace {

constexpr double kFinestCarried_mm = 0.3;
constexpr double kCoarsestCarried_mm = 1.0;

Beams::Fan wayOfApex(std::span<const TrackedFrame> frames, const glm::dvec2& apex_px) {
  std::vector<glm::dvec3> places;
  for (const TrackedFrame& frame : frames) places.emplace_back(frame.imageToWorld.matrix * glm::dvec4(apex_px, 0.0, 1.0));
  const auto farthestFrom = [&](const glm::dvec3& from) {
    return *std::max_element(places.begin(), places.end(),
                             [&](const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(from, a) < glm::distance(from, b); });
  };
  const glm::dvec3 one = farthestFrom(places.front());
  return {one, farthestFrom(one)};
}

}  // namespace

double frameDistance_mm(std::span<const TrackedFrame> frames) {
  const auto middleOf = [](const TrackedFrame& frame) {
    return glm::dvec3(frame.imageToWorld.matrix * glm::dvec4(0.5 * (frame.pixels.width - 1), 0.5 * (frame.pixels.height - 1), 0.0, 1.0));
  };
  std::vector<double> distances_mm;
  for (std::size_t n = 1; n < frames.size(); ++n) distances_mm.push_back(glm::distance(middleOf(frames[n - 1]), middleOf(frames[n])));
  return distances_mm.empty() ? 0.0 : upperMedianOf(distances_mm);
}

double carriedSpacing_mm(std::span<const TrackedFrame> frames) {
  if (frames.empty()) return kCoarsestCarried_mm;
  const glm::dmat4& matrix = frames.front().imageToWorld.matrix;
  const double pixel_mm = std::max(glm::length(glm::dvec3(matrix[0])), glm::length(glm::dvec3(matrix[1])));
  const double carried_mm = std::max(2.0 * pixel_mm, 0.6 * frameDistance_mm(frames));
  return std::round(20.0 * std::clamp(carried_mm, kFinestCarried_mm, kCoarsestCarried_mm)) / 20.0;
}

double usualFillReach_mm(std::span<const TrackedFrame> frames, double spacing_mm) {
  return std::max(3.0 * spacing_mm, 2.5 * frameDistance_mm(frames));
}

std::optional<Beams> beamsOf(std::span<const TrackedFrame> frames, const Clip& clip) {
  EW_EXPECTS(!frames.empty());
  glm::dvec3 sum(0.0);
  for (const TrackedFrame& frame : frames) {
    const glm::dvec3 down(frame.imageToWorld.matrix[1]);
    if (glm::length(down) > 0.0) sum += glm::normalize(down);
  }
  if (!(glm::length(sum) > 1e-3 * static_cast<double>(frames.size()))) return std::nullopt;
  Beams beams{glm::normalize(sum)};
  if (clip.fan) beams.fan = wayOfApex(frames, clip.fan->origin_px);
  return beams;
}

}  // namespace ew
