#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ew/core/capsule.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/phantom/patient.h"

namespace ew {

/// Labels and maps of tissue of a part of a patient.
struct TissuePart {
  std::vector<std::uint8_t> labels;  ///< on the maps' grid
  TissueMaps maps;                   ///< on the grid of the whole (voxelGridOf)
};

struct TissuePartOptions {
  double spacing_mm = 1.0;
  int threads = 0;
  std::uint64_t maxBytes = kLargestVolume_bytes;
};

/// The share of a patient's voxels that tissueWithin paints for these capsules, 0..1: what it costs, beside voxelise.
/// @param box of the patient (boxOf, readPatientBox)
/// @param spacing_mm > 0
[[nodiscard]] double shareWithin(const Bounds& box, double spacing_mm, std::span<const Capsule> capsules);

/// What voxelise makes with maps, without echoes, and no more of it than some capsules ask for: within them every voxel has the label,
/// level and surface that it has in the whole, at the same place of the same grid; beside them some have, and all others are 0, as outside
/// the body. `surfaces` names only the surfaces that were met, so their numbers are others than those of the whole.
/// @param capsules in the patient's own frame
/// @error badField (spacing), tooLarge (with the forecast), cancelled (within 0.1 s)
[[nodiscard]] Result<TissuePart> tissueWithin(const Patient& patient, std::span<const Capsule> capsules, const TissuePartOptions& options,
                                              Progress& progress);

}  // namespace ew
