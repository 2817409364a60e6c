#pragma once

#include <filesystem>
#include <memory>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/io/sequence.h"
#include "ew/library/case.h"

namespace ew {

/// The recorded images that a case keeps beside its volume (CaseVolume::frames), as they lie in the file.
/// @error as fileOfCase and readSequence; badField: an image without a place, turned otherwise than MF, without pixels
[[nodiscard]] Result<Sequence> readFrames(const Case& opened, Progress& progress);

/// The same among the voxels of the volume that was made of them.
/// @param own grid of the volume in its own file @error as readFrames and FrameStack::make
[[nodiscard]] Result<std::shared_ptr<const FrameStack>> readFrameStack(const Case& opened, const Grid& own, Progress& progress);

}  // namespace ew
