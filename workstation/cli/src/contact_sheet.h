#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/pose.h"
#include "ew/imaging/frame.h"

namespace ew::cli {

/// What a contact sheet is made of.
struct SheetSource {
  SliceSource echo;
  SliceSource labels;  ///< empty: effects go by grey level
  Scene scene;         ///< recorded range and tissues of every tile; its effects are those of "as the case asks" and of the probes' tiles
  Probe probe;         ///< of the tiles of effects
  std::vector<Probe> probes;
  Pose pose;
  Pose interfacePose;  ///< of the tiles of reverberation: where a strong smooth interface lies in view
};

/// One picture of many: every effect off and on, side by side, then every probe with the scene's effects. Each tile has its name below it,
/// the whole carries the words that every exported picture carries.
/// @param tile_px size of a tile without its name, at least 160 x 120
[[nodiscard]] GreyImage contactSheet(const SheetSource& source, const glm::ivec2& tile_px);

}  // namespace ew::cli
