#pragma once

#include "ew/labelling/labels.h"

namespace ew::labelling {

/// Part of an image plane, mm.
struct PlaneArea {
  double left_mm = -50.0, right_mm = 50.0;
  double top_mm = 0.0, bottom_mm = 100.0;
  double step_mm = 1.0;  ///< of the grid that the outline is found on, > 0
};

/// Where a plane cuts a label: closed outlines, at one half of the label's share between voxels (trilinear), by marching squares. Outlines
/// that leave the area are closed along its border. Ambiguous cells keep the inside apart.
/// @param planeToVoxel of the labels' grid, wherever that lies
[[nodiscard]] std::vector<std::vector<glm::dvec2>> outlinesOf(const Volume& labels, std::uint8_t label,
                                                              const Transform<frame::Voxel, frame::Probe>& planeToVoxel,
                                                              const PlaneArea& area);

}  // namespace ew::labelling
