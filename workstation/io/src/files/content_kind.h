#pragma once

#include <filesystem>

#include "ew/core/result.h"

namespace ew::detail {

/// Whether a file can be what its ending says, by its first bytes: a volume with a header (.mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz) or an
/// image (.png, .jpg, .jpeg, .pgm). Other endings, and bytes of no kind that is known here, are left to whoever reads them.
/// @error badHeader (it is empty, or of a kind with another ending: the sentence says which)
[[nodiscard]] Result<void> checkContent(const std::filesystem::path& file);

}  // namespace ew::detail
