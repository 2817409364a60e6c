#pragma once

#include "ew/acquisition/import.h"
#include "ew/core/result.h"
#include "ew/io/sequence.h"

namespace ew {

/// Names of the one transform that each of the images has.
inline constexpr const char* kImageFrame = "Image";
inline constexpr const char* kReferenceFrame = "Reference";

/// The images of a sweep as they are kept beside the volume made of it: every `every`th that has a pose, cut to what is image, black
/// outside of its fan, each with its way into the world and with nothing else the recording says (times, devices, persons).
/// @param every >= 1 @return orientation MF @error badField (a clip that does not fit, no image with a pose)
[[nodiscard]] Result<Sequence> recordedImages(const SweepInput& opened, int every);

}  // namespace ew
