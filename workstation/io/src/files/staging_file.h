#pragma once

#include <filesystem>
#include <fstream>

#include "ew/core/file_errors.h"
#include "ew/core/output_set.h"
#include "ew/core/result.h"

namespace ew::detail {

/// One file written aside and moved over its target at the end (OutputSet). Until `commit`, the target is untouched; without it, nothing
/// is left.
class StagingFile {
 public:
  /// @error notWritable (no such folder, no permission, or the target is no regular file)
  [[nodiscard]] static Result<StagingFile> create(const std::filesystem::path& target);

  [[nodiscard]] std::ofstream& stream() { return out_; }
  [[nodiscard]] const std::filesystem::path& aside() const { return aside_; }

  /// Everything written has left the stream. @error notWritable
  [[nodiscard]] Result<void> finish();

  /// Brings the finished file onto the medium and moves it over its target. @error notWritable
  [[nodiscard]] Result<void> commit();

 private:
  StagingFile() = default;
  OutputSet outputs_{LateFile::replace};  // caches are written by several programs at once; the last one is as good as the first
  std::filesystem::path target_;
  std::filesystem::path aside_;
  std::ofstream out_;
};

/// Closes a stream. @error notWritable (something did not reach the file): `target` is what the user calls it
[[nodiscard]] Result<void> finishStream(std::ofstream& out, const std::filesystem::path& target);

}  // namespace ew::detail
