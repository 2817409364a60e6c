#pragma once

#include <filesystem>
#include <vector>

#include "ew/core/result.h"

namespace ew::cli {

/// A file that is read and every file that is read because of it, as far as they are there: the samples of a header, what a JSON file
/// (case, project, patient, sweep) names beside itself and what those name in turn, the manifest of a case folder, the images of another
/// folder.
[[nodiscard]] std::vector<std::filesystem::path> filesBehind(const std::filesystem::path& input);

/// Of an output X.mhd: that X.raw is not there, or belongs to the X.mhd that is replaced.
/// @error badUsage
[[nodiscard]] Result<void> checkSamplesAreItsOwn(const std::filesystem::path& output);

}  // namespace ew::cli
