#pragma once

#include <optional>
#include <vector>

#include "ew/core/capsule.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Where a frame of live echoes looks at drawn tissue that rests, whatever its pose: capsules in the probe frame that hold every voxel of
/// maps and labels on which a pixel depends. They hold the lines of all directions and what lies beside them as far as beams, pulse and the
/// press of the face reach; maps and labels that are equal there give equal images. A body that moves is looked at elsewhere. Empty: the
/// scene forms no echoes.
[[nodiscard]] std::vector<Capsule> reachOfFrame(const Probe& probe, const Knobs& knobs, const Scene& scene);

}  // namespace ew
