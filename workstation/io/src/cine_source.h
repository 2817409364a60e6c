#pragma once

#include "ew/io/cine_reader.h"

namespace ew {

/// Where the frames of a CineReader come from.
struct CineReader::Source {
  virtual ~Source();
  /// Fills everything of the frame but what finish() makes. @return false: there is none, and `brokenOff` may say why
  virtual Result<bool> read(CineFrame& frame, const Progress& progress) = 0;
  virtual Result<void> rewind() = 0;

  CineInfo info;
  std::uint64_t given = 0;
  std::optional<Error> brokenOff;
};

namespace detail {

/// Films and TIFF, through the module that knows them.
/// @param shown the file that sentences name; `file` is where its bytes are
[[nodiscard]] Result<std::unique_ptr<CineReader::Source>> openFilm(const std::filesystem::path& file, const std::filesystem::path& shown,
                                                                   CineKind kind, const ReadLimits& limits);

}  // namespace detail
}  // namespace ew
