#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "ew/core/result.h"

namespace ew::detail {

/// Lines of a text header that binary samples may follow. A line, and all of them together, have a limit, so that a file of another kind
/// is found out before much of it is read.
class LineReader {
 public:
  explicit LineReader(const std::filesystem::path& file);

  /// The next line without its break (LF or CR LF); empty at the end of the file. The last line may lack its break.
  /// @error notReadable, badHeader (a NUL byte or a line beyond 1 MiB), tooLarge (more than 512 MiB of header)
  [[nodiscard]] Result<std::optional<std::string>> next();

  /// Bytes up to and including the break of the last line given.
  [[nodiscard]] std::uint64_t consumed() const { return consumed_; }

 private:
  std::filesystem::path file_;
  std::ifstream in_;
  int problem_ = 0;  ///< errno, where it could not be opened
  std::string buffer_;
  std::size_t at_ = 0;
  std::uint64_t consumed_ = 0;
};

}  // namespace ew::detail
