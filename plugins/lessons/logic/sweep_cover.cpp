#include "logic/sweep_cover.h"

#include <algorithm>
#include <cmath>

#include "ew/imaging/display.h"
#include "ew/imaging/probe.h"

namespace ew::lessons {
namespace {

constexpr std::size_t kMostPoints = 20'000;  // a quarter of a millisecond an image
constexpr double kLeastHalfSlice_mm = 1.5;

}  // namespace

SweepCover::SweepCover(const sdk::Scanned& scanned, int label) {
  if (!scanned.labels) return;
  const auto& echo = scanned.labels->echo;
  const auto count = static_cast<std::size_t>(std::count(echo.begin(), echo.end(), static_cast<std::uint8_t>(label)));
  const std::size_t stride = std::max<std::size_t>(1, (count + kMostPoints - 1) / kMostPoints);
  const auto voxelToWorld = scanned.placedLabels.voxelToWorld();
  const glm::ivec3 dims = scanned.placedLabels.dims;
  std::size_t at = 0, found = 0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i, ++at) {
        if (echo[at] != label || found++ % stride != 0) continue;
        points_mm_.push_back((voxelToWorld * Point<frame::Voxel>{{i, j, k}}).at);
      }
  seen_.assign(points_mm_.size(), 0);
  const glm::dvec3& spacing_mm = scanned.placedLabels.spacing_mm;
  half_mm_ = std::max(kLeastHalfSlice_mm, 0.75 * std::max({spacing_mm.x, spacing_mm.y, spacing_mm.z}));
}

void SweepCover::add(const ScanState& image) {
  if (image.pose.status != PoseStatus::ok || seenCount_ == seen_.size()) return;
  const auto worldToProbe = inverse(image.pose.probeToWorld);
  const double depth_mm = resolvedDepth_mm(image.probe, image.knobs);
  const bool sector = isSector(image.probe.kind);
  const double halfFace_mm = faceHalfWidth_mm(image.probe);
  const double radius_mm = image.probe.radius_mm;  // from where the lines meet to the face
  for (std::size_t n = 0; n < points_mm_.size(); ++n) {
    if (seen_[n] != 0) continue;
    const glm::dvec3 at = (worldToProbe * Point<frame::World>{points_mm_[n]}).at;
    if (std::abs(at.z) > half_mm_ || at.y < 0.0) continue;
    bool inside = at.y <= depth_mm && std::abs(at.x) <= halfFace_mm;
    if (sector) {
      const double fromApex_mm = std::hypot(at.x, at.y + radius_mm);
      inside = fromApex_mm <= radius_mm + depth_mm && std::abs(std::atan2(at.x, at.y + radius_mm)) <= image.probe.halfAngle_rad;
    }
    if (!inside) continue;
    seen_[n] = 1;
    ++seenCount_;
  }
}

double SweepCover::share() const { return seen_.empty() ? 0.0 : static_cast<double>(seenCount_) / static_cast<double>(seen_.size()); }

}  // namespace ew::lessons
