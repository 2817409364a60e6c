#pragma once

#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Memory of reverberate between frames.
struct ReverberationScratch {
  std::vector<int> interface;  ///< per line: sample of the first strong interface, or -1
  std::vector<float> level;
  std::vector<float> column;
};

/// Echoes that bounce between the face and a strong interface come back once more at each multiple of its depth, weaker by a bounce; and
/// beyond a strong smooth interface the tissue before it appears once more, mirrored. Added as powers (echoes do not interfere).
/// Nothing is written where no line has a strong interface.
/// @return lines that have one
int reverberate(const ReverberationEffect& effect, double greyPerDb, ImageView<float> echoes, ReverberationScratch& scratch);

}  // namespace ew
