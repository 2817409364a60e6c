#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ew/core/capsule.h"
#include "ew/core/pose.h"
#include "ew/library/case.h"

namespace ew {

/// What of a case some images of live echoes look at, made for them alone.
struct CasePart {
  CaseEcho echo;       ///< labels and tissue as those of the whole where they were asked for, else 0; the volume holds no echo at all
  double share = 0.0;  ///< of the case's voxels
};

/// The part of a case that comes as a recipe without sweeps, is not prepared yet and takes its time, as long as most of it can be left out:
/// it comes within seconds, and nothing is kept. Empty: the whole is there, is there as soon, or is asked for.
/// @param seen_probe what images look at (reachOfFrame), in the probe's frame
/// @param poses of the images; those at which nothing can be seen ask for nothing
/// @error as loadCaseVolume
[[nodiscard]] Result<std::optional<CasePart>> loadCasePart(const Case& opened, std::vector<Capsule> seen_probe, std::span<const Pose> poses,
                                                           Progress& progress, const PreparationOptions& options = {});

}  // namespace ew
