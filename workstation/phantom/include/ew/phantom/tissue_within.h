#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/core/capsule.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/phantom/patient.h"

namespace ew {

/// What some images look at: the same capsules, in the frame of the probe, seen from one place after another.
struct ViewPlaces {
  std::vector<Capsule> capsules;
  std::vector<glm::dmat4> toPatient;  ///< rigid: from the probe's frame to the patient's own
};

/// Blocks of a patient's voxels.
struct VoxelBlocks {
  Grid grid;                        ///< of all voxels (voxelGridOf)
  std::vector<glm::ivec3> first{};  ///< of each its first voxel, in their order in the volume
  double share = 0.0;               ///< of all, 0..1: what they cost, beside voxelise
};

/// The blocks that tissueWithin has to paint for some places.
/// @param box of the patient (boxOf, readPatientBox)
/// @param mostShare nothing is returned as soon as they are more
/// @error badField (spacing), cancelled (within 0.1 s)
[[nodiscard]] Result<std::optional<VoxelBlocks>> voxelBlocksAt(const ViewPlaces& seen, const Bounds& box, double spacing_mm,
                                                               double mostShare, Progress& progress);

struct TissuePartOptions {
  int threads = 0;
  std::uint64_t maxBytes = kLargestVolume_bytes;
};

/// What voxelise makes with maps, and no more of it than some places ask for: within their capsules every voxel has the label, level and
/// surface that it has in the whole, at the same place of the same grid; beside them some have, and all others are 0, as outside the body.
/// No voxel has an echo or coverage. Surfaces are numbered among those that were met; of a patient with more than 255 kinds of them, the
/// whole drops its faintest, the part none or fewer.
/// @param blocks of this patient
/// @error badField (a grid that cannot be), tooLarge (with the forecast), cancelled (within 0.1 s)
[[nodiscard]] Result<VoxelPatient> tissueWithin(const Patient& patient, const VoxelBlocks& blocks, const TissuePartOptions& options,
                                                Progress& progress);

}  // namespace ew
