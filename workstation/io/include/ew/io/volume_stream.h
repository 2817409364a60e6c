#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

/// A volume of 8 bit values that is written block by block, in any order, and need not fit into memory: an uncompressed .mha, so that
/// mapVolume can open it. It is made aside; the target is untouched until finish(), and without it nothing is left.
class VolumeStream {
 public:
  /// Takes the room on the medium at once, so that a full one is noticed before hours of work.
  /// @error emptyVolume, badField, tooLarge (the grid), unsupported (another ending than .mha), notWritable
  [[nodiscard]] static Result<VolumeStream> create(const Grid& grid, const std::filesystem::path& file);

  /// @param corner first voxel of the block; block and grid are in the same order, i fastest
  /// @param values size.x * size.y * size.z of them
  void put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values);

  /// Everything is on the medium and the file has its name. Voxels nobody wrote are 0.
  /// @error notWritable, cancelled (then nothing is left)
  [[nodiscard]] Result<void> finish(Progress& progress = noProgress());

  ~VolumeStream();
  VolumeStream(VolumeStream&&) noexcept;
  VolumeStream& operator=(VolumeStream&&) noexcept;

 private:
  struct Parts;
  explicit VolumeStream(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew
