#pragma once

#include <filesystem>

#include "ew/core/result.h"
#include "ew/library/bundle.h"

namespace ew {

/// @error badUsage: the file is that of an examination, and stays
[[nodiscard]] inline Result<void> keepsExamination(const std::filesystem::path& file) {
  if (!holdsExamination(file)) return {};
  return failure(ErrorCode::badUsage,
                 say<"\"%1\" is the file of an examination and is never replaced, for attempts at it are judged with it alone; choose "
                     "another name.">(file),
                 {{"file", file.string()}});
}

}  // namespace ew
