#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/pose.h"
#include "ew/imaging/probe.h"
#include "ew/scanning/subject.h"

namespace ew::cli {

/// What a contact sheet is made of.
struct SheetSource {
  ScanSubject subject;  ///< its scene: recorded range and tissues of every tile, effects of "as the case asks" and of the probes' tiles
  Probe probe;          ///< of the tiles of effects
  std::vector<Probe> probes;
  Pose pose;
  Pose interfacePose;  ///< of the tiles of reverberation: where a strong smooth interface lies in view
};

/// One image of many: every effect off and on, side by side, then every probe with the scene's effects. Each tile has its name below it;
/// along the lower edge of the whole is room for the words that every exported image carries.
/// @param tile_px size of a tile without its name, at least 160 x 120
[[nodiscard]] RgbImage contactSheet(const SheetSource& source, const glm::ivec2& tile_px);

}  // namespace ew::cli
