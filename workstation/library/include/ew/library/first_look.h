#pragma once

#include <optional>
#include <span>
#include <string>

#include "ew/core/pose.h"
#include "ew/imaging/probe.h"
#include "ew/library/placing.h"
#include "ew/library/voxel_source.h"

namespace ew {

/// How a volume of which no case says anything is seen whole at first.
struct FirstLook {
  std::string probe;      ///< its id
  double depth_mm = 0.0;  ///< of the image, within the probe's own limits, in steps of 5 mm
};

/// How deep the points of a volume reach behind its near face, along its beams, mm: a tenth less than it all. 0: it has none.
[[nodiscard]] double depthOf_mm(const PlacingShape& shape);

/// Whether an image of that depth shows a volume neither as a stamp nor cut off: two fifths of it at least, and no more than 1.4 times it.
[[nodiscard]] bool showsWhole(const PlacingShape& shape, double depth_mm);

/// The probe for the body's surface whose depth at start, face and kind of image (straight or fanning out) come nearest to the volume's.
/// @return empty where there is no such probe, or no volume
[[nodiscard]] std::optional<FirstLook> firstLookAt(const PlacingShape& shape, std::span<const Probe> probes);

/// Where a volume that was just reconstructed is put, and how it is looked at there: as its recording's probe saw it.
struct FirstPlace {
  PlacingShape shape;
  Transform<frame::World, frame::File> fileToWorld;
  Pose start;  ///< in the middle of the near face, in the plane of a frame
};
/// @return empty where the frames' directions cancel out
[[nodiscard]] std::optional<FirstPlace> firstPlaceOf(const Volume& volume, const Provenance& recorded, const Skin& skin,
                                                     const PlacingSite& site);

}  // namespace ew
