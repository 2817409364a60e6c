#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/imaging/display.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/slicing.h"
#include "ew/scanning/subject.h"

namespace ew {

/// Where a subject has data: within its voxels, and there where its coverage says so. Black tissue is data, and the air around a drawn
/// patient; what no sweep reached is not.
/// A value that shares the voxels.
class Recorded {
 public:
  Recorded() = default;  ///< nothing anywhere
  explicit Recorded(const ScanSubject& subject);
  [[nodiscard]] bool at(const glm::dvec3& p_world_mm) const {
    const glm::dvec3 p_voxel = glm::dvec3(worldToVoxel_ * glm::dvec4(p_world_mm, 1.0)) + 0.5;
    if (!(glm::all(glm::greaterThanEqual(p_voxel, glm::dvec3(0.0))) && glm::all(glm::lessThan(p_voxel, glm::dvec3(dims_))))) return false;
    return coverage_ == nullptr || coverage_[index(glm::ivec3(p_voxel))] != static_cast<std::uint8_t>(Coverage::absent);
  }
  /// A box that holds all of it.
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

 private:
  [[nodiscard]] std::size_t index(const glm::ivec3& voxel) const { return sampleIndex(dims_, voxel.x, voxel.y, voxel.z); }

  std::shared_ptr<const Volume> volume_;
  const std::uint8_t* coverage_ = nullptr;  ///< of volume_; null: every voxel counts
  glm::dmat4 worldToVoxel_{1.0};
  glm::ivec3 dims_{0};
  Bounds bounds_;
};

/// How much of what lies below the skin was recorded, 0..1 for each of its points: of the first 40 mm straight in.
[[nodiscard]] std::vector<float> coverageOfSkin(const Recorded& recorded, std::span<const glm::vec3> points_mm,
                                                std::span<const glm::vec3> outward);

/// For each point of gapsToSkin_mm whether anything was recorded in the first 30 mm in front of the face there.
[[nodiscard]] std::vector<bool> dataInFrontOf(const Recorded& recorded, const Probe& probe, const Pose& pose);

/// What of an image's fan looks at nothing that was recorded, on every so manieth pixel.
struct RecordingGap {
  int every_px = 1;
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t>
      outside;         ///< (rows x columns), 1 where the fan lies beyond the data; of pixel (every_px * column, every_px * row)
  double share = 0.0;  ///< of the fan, 0..1
  /// Where the data on the beam through the middle of the face end, when it is above the fan's depth by more than 2 mm; empty also when
  /// there are none.
  std::optional<double> end_mm;
};
[[nodiscard]] RecordingGap unrecordedPart(const Recorded& recorded, const DisplayGeometry& geometry, const Spans& fan, const Pose& pose,
                                          double depth_mm, int every_px);

}  // namespace ew
