#pragma once

#include <filesystem>
#include <fstream>

#include "ew/core/result.h"

namespace ew::detail {

/// A file written beside its target and moved over it at the end. Until `commit`, the target is untouched; without it, nothing is left.
class StagedFile {
 public:
  /// @error notWritable (no such folder, no permission, or the target is no regular file)
  [[nodiscard]] static Result<StagedFile> create(const std::filesystem::path& target);

  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  [[nodiscard]] std::ofstream& stream() { return out_; }
  [[nodiscard]] const std::filesystem::path& aside() const { return aside_; }

  /// Everything written is on the medium. @error notWritable
  [[nodiscard]] Result<void> finish();

  /// Moves the finished file over its target. @error notWritable
  [[nodiscard]] Result<void> commit();

  /// Takes a commit back: the earlier target returns, or the new one goes. Only for the first of several files that belong together.
  void undo();

  /// Keeps the earlier target aside until this object ends, so that `undo` can bring it back. Call before `commit`.
  [[nodiscard]] Result<void> keepEarlier();

 private:
  StagedFile() = default;
  std::filesystem::path target_;
  std::filesystem::path aside_;
  std::filesystem::path earlier_;
  std::ofstream out_;
  bool committed_ = false;
};

[[nodiscard]] tl::unexpected<Error> notWritable(const std::filesystem::path& file, const std::string& reason);

}  // namespace ew::detail
