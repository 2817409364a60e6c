#pragma once

#include <glm/glm.hpp>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>

#include "ew/core/beams.h"
#include "ew/core/volume.h"

/// Registration finds how the coordinates of one subvolume (fixed) go over into those of another (moving). Throughout:
/// fixedToMoving takes a point in the mm of the fixed volume's grid (LPS) to the mm of the moving volume's grid.
namespace ew::registration {

/// What may be believed about a result. An outcome of the numerics, never an Error.
enum class Verdict {
  aligned,     ///< the evidence supports this transform and no other
  notAligned,  ///< the evidence speaks against it: no common tissue, or the images contradict the transform
  cannotTell   ///< too little evidence either way; the reason says of what
};
const char* nameOf(Verdict verdict);  ///< "aligned", "not aligned", "cannot tell": as in reports

enum class StopReason { notRun, converged, iterationLimit, timeLimit, noImprovement, singular, noOverlap, cancelled };
const char* nameOf(StopReason reason);

/// One side of a registration: echo levels with coverage, and how far each voxel's echo may be trusted.
struct Input {
  const Volume* volume = nullptr;  ///< never null; lives as long as the call
  /// voxelCount() values in 0..1; empty: 1 wherever covered. Where less than half a per cent of what is covered is believed above 0.05, as
  /// in a recording that is black nearly throughout (wires in water), it tells of no shadow and counts as empty.
  std::span<const float> confidence = {};
  /// The view's beams, where known. What runs along them, as shadows do, is then no evidence for rigid registration, and none for warps
  /// when the views agree better without it; where they are not known, streaks are looked for.
  std::optional<Beams> beams = {};
};

/// Agreement of the images at a transform, over the voxels both sides cover. Correlations are of images made comparable
/// (speckle suppressed, local mean and deviation taken out), so that gain and depth gain do not count.
struct Agreement {
  double correlation = 0.0;   ///< -1..1
  double overlapShare = 0.0;  ///< voxels both cover, of the smaller side's covered voxels
  double chance = 0.0;        ///< correlation that unrelated tissue of this overlap reaches by chance, 95th percentile
  bool operator==(const Agreement&) const = default;
};

}  // namespace ew::registration
