#pragma once

#include <filesystem>
#include <utility>

#include "ew/core/result.h"
#include "ew/io/file_lock.h"

namespace ew::assessment {

/// Makes a folder and takes its lock, for writes that last milliseconds: waits at most 3 s for another window.
/// @error notWritable
[[nodiscard]] inline Result<FileLock> lockFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return failure(ErrorCode::notWritable,
                   say<"The folder '%1' cannot be made (%2); free some space, or choose a library you may write to.">(
                       folder, verbatim(error.message())),
                   {{"file", folder.string()}});
  auto taken = FileLock::tryTakeSoon(folder / ".lock");
  if (!taken) return passOn(taken.error());
  if (*taken) return std::move(**taken);
  return failure(ErrorCode::notWritable, say<"Another window is writing into '%1'; try again in a moment.">(folder),
                 {{"file", folder.string()}});
}

}  // namespace ew::assessment
