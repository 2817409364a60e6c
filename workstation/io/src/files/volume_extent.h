#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "files/image_header.h"

namespace ew::detail {

/// The grid of the first three axes, and how many such volumes the file holds.
struct VolumeExtent {
  Grid grid;
  std::uint64_t voxels = 0;
  std::uint64_t promised = 0;  ///< samples of all volumes in the file
  std::uint64_t volumes = 1;   ///< one after the other, or woven into each other
};

/// What a header says about its volume, checked before any sample is looked at; what was decided is appended to `notes`.
/// @error unsupported (a recorded sweep), emptyVolume, tooLarge, badField (spacing or directions)
[[nodiscard]] Result<VolumeExtent> volumeExtentOf(const ImageHeader& header, std::vector<Message>& notes);

/// Of a file with several volumes: that the first was read.
[[nodiscard]] Message firstOfSeveral(const ImageHeader& header, std::uint64_t volumes);

/// That a file with `volumes` volumes has no such one.
[[nodiscard]] Message noSuchVolume(const std::filesystem::path& file, std::uint64_t volumes, std::int64_t asked);

}  // namespace ew::detail
