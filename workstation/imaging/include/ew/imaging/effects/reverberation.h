#pragma once

#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Memory of reverberate between frames.
struct ReverberationScratch {
  std::vector<int> interfaces;  ///< per line: sample of the first strong interface, or -1
  std::vector<int> ends;        ///< per line: last sample of its echo
  std::vector<int> smooth;      ///< per line: 1 where it mirrors
};

/// Echoes that bounce between the face and a strong interface come back once more at each multiple of its depth, weaker by a bounce; and
/// beyond a strong smooth interface the tissue before it appears once more, mirrored. Added as powers (echoes do not interfere).
/// Nothing is written where no line has a strong interface.
/// @param firstSample where an interface may lie at the earliest: behind the near field
/// @param echoes      all lines of the grid: whether an interface is smooth shows beside it
/// @return lines that have one
int reverberate(const ReverberationEffect& effect, double greyPerDb, int firstSample, ImageView<float> echoes,
                ReverberationScratch& scratch);

}  // namespace ew
