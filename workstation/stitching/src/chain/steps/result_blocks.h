#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <vector>

#include "ew/io/volume_stream.h"
#include "ew/stitching/join.h"

namespace ew::stitching {

/// Puts the values of a block where they belong in a volume.
inline void copyBlock(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values, Volume& volume) {
  const auto row = static_cast<std::size_t>(size.x);
  std::size_t from = 0;
  for (int k = 0; k < size.z; ++k)
    for (int j = 0; j < size.y; ++j, from += row)
      std::memcpy(volume.echo.data() + volume.grid.indexOf(corner.x, corner.y + j, corner.z + k), values.data() + from, row);
}

/// Takes the blocks of a result (echo, coverage, source) and names sources by their numbers in the project.
class ResultBlocks : public BlockSink {
 public:
  /// @param included the volumes that go into the result; joining counts among these
  explicit ResultBlocks(const std::vector<std::size_t>& included) {
    for (std::size_t n = 0; n < included.size(); ++n) number_[n + 1] = static_cast<std::uint8_t>(included[n] + 1);
  }
  Result<void> put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> echo,
                   std::span<const std::uint8_t> coverage, std::span<const std::uint8_t> source) final {
    named_.resize(source.size());
    std::transform(source.begin(), source.end(), named_.begin(), [this](std::uint8_t n) { return number_[n]; });
    place(0, corner, size, echo);
    place(1, corner, size, coverage);
    place(2, corner, size, named_);
    return {};
  }

 protected:
  virtual void place(std::size_t which, const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) = 0;

 private:
  std::array<std::uint8_t, 256> number_{};
  std::vector<std::uint8_t> named_;
};

/// Into three volumes.
class MemoryBlocks final : public ResultBlocks {
 public:
  MemoryBlocks(const std::vector<std::size_t>& included, const Grid& grid) : ResultBlocks(included) {
    for (auto& volume : made) volume = {grid, std::vector<std::uint8_t>(grid.voxelCount(), 0), {}};
  }
  std::array<Volume, 3> made;

 private:
  void place(std::size_t which, const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) override {
    copyBlock(corner, size, values, made[which]);
  }
};

/// Into three files, so that the result need not fit into memory.
class FileBlocks final : public ResultBlocks {
 public:
  using ResultBlocks::ResultBlocks;
  std::vector<VolumeStream> writers;  ///< of echo, coverage and source

 private:
  void place(std::size_t which, const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) override {
    writers[which].put(corner, size, values);
  }
};

}  // namespace ew::stitching
