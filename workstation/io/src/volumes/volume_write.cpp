#include <algorithm>
#include <bit>

#include "ew/core/contract.h"
#include "ew/io/volume_file.h"
#include "files/image_header.h"
#include "files/volume_extent.h"
#include "volumes/meta_writer.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

/// @param samples the bytes of the voxels, two for each when `wide`
Result<void> writeSamples(const Grid& grid, std::span<const std::uint8_t> samples, const fs::path& file, const Message& what,
                          Progress& progress, const WriteOptions& options, bool wide = false) {
  if (auto usable = checkGrid(grid); !usable) return usable;
  const std::size_t bytes = grid.voxelCount() * (wide ? 2 : 1);
  EW_EXPECTS(samples.size() == bytes);
  if (samples.size() != bytes)
    return failure(ErrorCode::internal,
                   say<"The volume has %1 bytes of voxels, but its grid %2; it was not written.">(samples.size(), grid.voxelCount()));
  const MetaText text{
      .sizes = {static_cast<std::uint64_t>(grid.dims.x), static_cast<std::uint64_t>(grid.dims.y), static_cast<std::uint64_t>(grid.dims.z)},
      .geometry = grid,
      .kinds = {},
      .samples = true,
      .wide = wide,
      .fields = {}};
  const std::string ending = lowerCase(file.extension().string());
  if (ending == ".mha") return writeMetaFile(file, text, samples, options.compress, what, progress);
  if (ending == ".mhd") return writeMetaPair(file, text, samples, what, progress);
  return failure(ErrorCode::unsupported, say<"%1 has an ending that is not written; end its name in .mha or .mhd.">(quoted(file)),
                 {{"file", file.string()}});
}

/// The samples of a file that lies on the grid of a volume.
/// @param samples   what its samples must be
/// @param otherGrid what to say when it lies on another grid
Result<std::vector<std::uint8_t>> readBeside(const Grid& expected, const fs::path& file, const Message& samples, const Message& otherGrid,
                                             Progress& progress) {
  auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  if (header->type != SampleType::u8) return badField(file, say<"the sample type">(), nameOf(header->type), samples);
  auto loaded = readVolume(file, progress);
  if (!loaded) return passOn(loaded.error());
  const Grid& found = loaded->volume.grid;
  const double nearly_mm = 1e-3;
  const auto farthest = [](const glm::dvec3& difference) {
    return std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
  };
  // Compared where the corners lie, so that six written digits are enough however far the origin is.
  bool same = found.dims == expected.dims;
  for (int corner = 0; same && corner < 8; ++corner) {
    const Point<frame::Voxel> p_voxel{glm::dvec3((corner & 1) * (expected.dims.x - 1), ((corner >> 1) & 1) * (expected.dims.y - 1),
                                                 (corner >> 2) * (expected.dims.z - 1))};
    same = farthest((found.voxelToWorld() * p_voxel).at - (expected.voxelToWorld() * p_voxel).at) <= nearly_mm;
  }
  if (!same) return failure(ErrorCode::badField, otherGrid, {{"file", file.string()}});
  return std::move(loaded->volume.echo);
}

}  // namespace

Result<VolumeHeader> readVolumeHeader(const fs::path& file) {
  const auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  VolumeHeader found;
  found.files = {header->file};
  if (header->dataFile != header->file) found.files.push_back(header->dataFile);
  found.sequence = describesSequence(*header);
  if (found.sequence) return found;
  std::vector<Message> ignored;
  const auto extent = volumeExtentOf(*header, ignored);
  if (!extent) return passOn(extent.error());
  found.grid = extent->grid;
  return found;
}

Result<void> writeVolume(const Volume& volume, const fs::path& file, Progress& progress, const WriteOptions& options) {
  return writeSamples(volume.grid, volume.echo, file, say<"Writing voxels">(), progress, options);
}

Result<void> writeCoverage(const Volume& volume, const fs::path& file, Progress& progress, const WriteOptions& options) {
  if (!volume.coverage.empty()) return writeSamples(volume.grid, volume.coverage, file, say<"Writing coverage">(), progress, options);
  if (auto usable = checkGrid(volume.grid); !usable) return usable;
  const std::vector<std::uint8_t> measured(volume.grid.voxelCount(), static_cast<std::uint8_t>(Coverage::measured));
  return writeSamples(volume.grid, measured, file, say<"Writing coverage">(), progress, options);
}

Result<void> writeSources(const Grid& grid, std::span<const std::uint16_t> sources, const fs::path& file, Progress& progress,
                          const WriteOptions& options) {
  static_assert(std::endian::native == std::endian::little, "the file has the low byte first");
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(sources.data()), sources.size_bytes());
  return writeSamples(grid, bytes, file, say<"Writing sources">(), progress, options, true);
}

Result<void> writeConfidence(const Grid& grid, std::span<const std::uint8_t> confidence, const fs::path& file, Progress& progress,
                             const WriteOptions& options) {
  return writeSamples(grid, confidence, file, say<"Writing confidence">(), progress, options);
}

Result<void> readCoverageInto(Volume& volume, const fs::path& file, Progress& progress) {
  auto values = readBeside(
      volume.grid, file, say<"8 bit unsigned (0 absent, 1 interpolated, 2 measured)">(),
      say<"The coverage in %1 lies on another grid than its volume; give the coverage made with this volume.">(quoted(file)), progress);
  if (!values) return passOn(values.error());
  if (const auto beyond = std::find_if(values->begin(), values->end(), [](std::uint8_t value) { return value > 2; });
      beyond != values->end())
    return badField(file, say<"a coverage value">(), verbatim(std::to_string(*beyond)),
                    say<"0 (absent), 1 (interpolated) or 2 (measured)">());
  volume.coverage = std::move(*values);
  return {};
}

Result<std::vector<std::uint8_t>> readConfidence(const Grid& grid, const fs::path& file, Progress& progress) {
  return readBeside(
      grid, file, say<"8 bit unsigned (0 to 255 for 0 to 1)">(),
      say<"The confidence in %1 lies on another grid than its volume; give the confidence made with this volume.">(quoted(file)), progress);
}

}  // namespace ew
