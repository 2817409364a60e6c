#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/volume.h"

namespace ew::detail {

/// Everything a MetaImage file says besides its samples.
struct MetaText {
  std::vector<std::uint64_t> sizes;
  Grid geometry;        ///< spacing, origin, directions; the first sizes.size() axes count
  std::string kinds;    ///< "domain domain list"; empty for none
  bool samples = true;  ///< false for MET_OTHER
  bool wide = false;    ///< samples of 16 bits without sign, low byte first
  bool real = false;    ///< samples of 32 bits, floating point, low byte first
  int channels = 1;     ///< samples of each pixel, one after another
  std::vector<std::pair<std::string, std::string>> fields;
};

/// A single file, header and samples.
[[nodiscard]] Result<void> writeMetaFile(const std::filesystem::path& file, const MetaText& text, std::span<const std::uint8_t> samples,
                                         bool compress, const Message& what, Progress& progress);

/// The header of a single file of uncompressed 8 bit voxels: what comes before the first of them.
[[nodiscard]] std::string plainVolumeHeader(const Grid& grid);

/// A single file whose samples are made while it is written: `more` gives the next piece, an empty one at the end.
[[nodiscard]] Result<void> writeMetaStream(const std::filesystem::path& file, const MetaText& text,
                                           const std::function<Result<std::span<const std::uint8_t>>()>& more, Progress& progress);

/// A header and a raw file of the same name beside it: both are complete, or both are as before.
[[nodiscard]] Result<void> writeMetaPair(const std::filesystem::path& file, const MetaText& text, std::span<const std::uint8_t> samples,
                                         const Message& what, Progress& progress);

}  // namespace ew::detail
