#include "ew/scanning/recorded.h"

#include <algorithm>
#include <array>

#include "ew/core/contract.h"
#include "ew/scanning/contact.h"

namespace ew {

Recorded::Recorded(const ScanSubject& subject)
    : volume_(subject.voxels.volume()),
      worldToVoxel_(subject.placedGrid.worldToVoxel().matrix),
      dims_(subject.placedGrid.dims),
      bounds_(boundsOf(subject.placedGrid)) {
  // A drawn patient is known as a whole; what is no body is air, and which of it a pressed face brings before itself no voxel says.
  if (subject.tissue && !subject.tissue->isRecorded) return;
  if (volume_ && volume_->coverage.size() == volume_->grid.voxelCount()) coverage_ = volume_->coverage.data();
}

std::vector<float> coverageOfSkin(const Recorded& recorded, std::span<const glm::vec3> points_mm, std::span<const glm::vec3> outward) {
  EW_EXPECTS(points_mm.size() == outward.size());
  constexpr int kDepths = 8;
  constexpr double kApart_mm = 5.0;
  std::vector<float> shares(points_mm.size(), 0.0F);
  const glm::dvec3 lowest = recorded.bounds().lowest_mm - kDepths * kApart_mm, highest = recorded.bounds().highest_mm + kDepths * kApart_mm;
  for (std::size_t n = 0; n < points_mm.size(); ++n) {
    const glm::dvec3 on(points_mm[n]), inwards(-outward[n]);
    if (glm::any(glm::lessThan(on, lowest)) || glm::any(glm::greaterThan(on, highest))) continue;
    int found = 0;
    for (int depth = 0; depth < kDepths; ++depth) found += recorded.at(on + (depth + 0.5) * kApart_mm * inwards) ? 1 : 0;
    shares[n] = static_cast<float>(found) / kDepths;
  }
  return shares;
}

std::vector<bool> dataInFrontOf(const Recorded& recorded, const Probe& probe, const Pose& pose) {
  const std::vector<glm::dvec3> face = facePoints_mm(probe, kPointsOfFace);
  std::vector<bool> seen;
  for (std::size_t n = 0; n < face.size(); ++n) {
    // Square to the face within its plane, away from the probe.
    const glm::dvec3 along = face[std::min(n + 1, face.size() - 1)] - face[n > 0 ? n - 1 : 0];
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(-along.y, along.x, 0.0));
    const auto at = [&](double depth_mm) { return recorded.at((pose.probeToWorld * Point<frame::Probe>{face[n] + depth_mm * ahead}).at); };
    constexpr std::array<double, 5> kDepths_mm{3.0, 8.0, 14.0, 21.0, 30.0};
    seen.push_back(std::any_of(kDepths_mm.begin(), kDepths_mm.end(), at));
  }
  return seen;
}

RecordingGap unrecordedPart(const Recorded& recorded, const DisplayGeometry& geometry, const Spans& fan, const Pose& pose, double depth_mm,
                            int every_px) {
  EW_EXPECTS(every_px > 0);
  RecordingGap part;
  part.every_px = every_px;
  if (pose.status != PoseStatus::ok || fan.empty()) return part;
  part.columns = (geometry.width + every_px - 1) / every_px;
  part.rows = (static_cast<int>(fan.size()) + every_px - 1) / every_px;
  part.outside.assign(static_cast<std::size_t>(part.columns) * static_cast<std::size_t>(part.rows), 0);
  const glm::dmat4 imageToWorld = (pose.probeToWorld * geometry.imageToProbe()).matrix;
  std::size_t inFan = 0, outside = 0;
  for (int row = 0; row < part.rows; ++row) {
    for (const RowSpan& run : fan[static_cast<std::size_t>(row * every_px)]) {
      for (int column = (run.begin + every_px - 1) / every_px; column * every_px < run.end; ++column) {
        const bool here = recorded.at(glm::dvec3(imageToWorld * glm::dvec4(column * every_px, row * every_px, 0.0, 1.0)));
        part.outside[static_cast<std::size_t>(row) * static_cast<std::size_t>(part.columns) + static_cast<std::size_t>(column)] =
            here ? 0 : 1;
        ++inFan;
        outside += here ? 0 : 1;
      }
    }
  }
  part.share = inFan > 0 ? static_cast<double>(outside) / static_cast<double>(inFan) : 0.0;
  const auto onMiddleBeam = [&](double at_mm) { return recorded.at((pose.probeToWorld * Point<frame::Probe>{{0.0, at_mm, 0.0}}).at); };
  constexpr double kStep_mm = 0.5, kWorthAMark_mm = 2.0;
  double end_mm = depth_mm;
  while (end_mm > 0.0 && !onMiddleBeam(end_mm)) end_mm -= kStep_mm;
  if (end_mm > 0.0 && end_mm < depth_mm - kWorthAMark_mm) part.end_mm = end_mm;
  return part;
}

}  // namespace ew
