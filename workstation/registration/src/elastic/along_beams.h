#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "elastic/level_pair.h"
#include "ew/core/beams.h"
#include "ew/registration/verdict.h"

namespace ew::registration {

/// Along which beams each side's images hold what is no tissue: shadows and enhancement, which turn with the probe.
struct BeamPair {
  Beams fixed;
  Beams moving;
};

/// Makes the images of a level; null: nothing is taken out. false when cancelled.
using MakeLevels = std::function<bool(const BeamPair*, LevelImage& fixed, LevelImage& moving)>;

/// Whether two views agree better, where they are placed, without what runs along their beams; most scenes do not. Tried are the known
/// beams or, of a side whose beams are not known, the directions along which it is streaky, and those of the other side: what is taken out
/// of both alike spares the tissue. On return the images are those of the answer.
/// @param fixed,moving images of a coarse level as they are
/// @return nothing when none agrees better; check for cancelling afterwards
[[nodiscard]] std::optional<BeamPair> beamsToTakeOut(const Input& fixedInput, const Input& movingInput,
                                                     const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                                                     const AxesTransform& transform, const NodeGrid& nodes, const MakeLevels& make,
                                                     int threads, Progress& progress, LevelImage& fixed, LevelImage& moving);

}  // namespace ew::registration
