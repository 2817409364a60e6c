#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "echo_motion.h"
#include "ew/imaging/beam_grid.h"
#include "label_blend.h"

namespace ew::detail {

/// The lines of a frame in voxels of a map, number by number, so that a vector takes neighbouring lines.
struct LineWays {
  std::array<std::vector<float>, 3> start;  ///< on the face
  std::array<std::vector<float>, 3> perMm;

  void resize(std::size_t lines);
  void lay(const BeamGrid& grid, const glm::dmat4& probeToVoxel);
  void set(std::size_t line, const glm::vec3& from, const glm::vec3& step) {
    for (int axis = 0; axis < 3; ++axis) {
      start[static_cast<std::size_t>(axis)][line] = from[axis];
      perMm[static_cast<std::size_t>(axis)][line] = step[axis];
    }
  }
  [[nodiscard]] glm::vec3 startOf(int line) const { return of(start, line); }
  [[nodiscard]] glm::vec3 perMmOf(int line) const { return of(perMm, line); }

 private:
  [[nodiscard]] static glm::vec3 of(const std::array<std::vector<float>, 3>& numbers, int line) {
    const auto n = static_cast<std::size_t>(line);
    return {numbers[0][n], numbers[1][n], numbers[2][n]};
  }
};

/// A depth of all lines.
struct RowOfPlaces {
  const LineWays& ways;
  glm::vec3 offset_voxel{0.0F};
  float range_mm = 0.0F;
  float ahead_mm = 0.0F;        ///< so far below it, voxels are asked for already
  EchoMotion::RowsAround back;  ///< in voxels
};

/// LabelBlend::at of `count` lines from `first` on, at
///   start + offset + range perMm + what rests there,
/// added up in this order. The same bits on every instruction set.
/// @param ownAt, reflectionAt of the first of them
void blendRow(const LabelBlend& blend, const RowOfPlaces& places, int first, int count, float* ownAt, float* reflectionAt);

}  // namespace ew::detail
