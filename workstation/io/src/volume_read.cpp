#include <algorithm>
#include <array>
#include <cmath>

#include "ew/io/volume_file.h"
#include "grey_samples.h"
#include "image_header.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

/// The grid of the first three axes, and how many such volumes the file holds.
struct Extent {
  Grid grid;
  std::uint64_t voxels = 0;
  std::uint64_t promised = 0;
};

Result<Extent> extentOf(const ImageHeader& header, std::vector<std::string>& notes) {
  Extent extent;
  extent.grid = header.geometry;
  std::array<std::uint64_t, 3> sizes{1, 1, 1};
  std::copy_n(header.sizes.begin(), std::min<std::size_t>(header.sizes.size(), 3), sizes.begin());
  const auto voxels = productOf(sizes);
  const auto promised = productOf(header.sizes);
  if (voxels == std::optional<std::uint64_t>(0) || promised == std::optional<std::uint64_t>(0))
    return failure(ErrorCode::emptyVolume,
                   quoted(header.file) + " holds no voxels (" + sizesText(header.sizes) + "); choose a file with samples in it.",
                   {{"file", header.file.string()}, {"sizes", sizesText(header.sizes)}});
  constexpr std::uint64_t longestAxis = 1u << 30;
  if (!promised || std::any_of(sizes.begin(), sizes.end(), [](std::uint64_t size) { return size > longestAxis; }))
    return failure(ErrorCode::tooLarge,
                   "The header of " + quoted(header.file) + " promises " + sizesText(header.sizes) + " samples, but an axis may have " +
                       std::to_string(longestAxis) + " at most; check that the file is undamaged.",
                   {{"file", header.file.string()}, {"promised", sizesText(header.sizes)}, {"limit", std::to_string(longestAxis)}});
  for (std::size_t axis = 0; axis < 3; ++axis) extent.grid.dims[static_cast<int>(axis)] = static_cast<int>(sizes[axis]);
  extent.voxels = *voxels;
  extent.promised = *promised;
  if (extent.promised > extent.voxels)
    notes.push_back(quoted(header.file) + " holds " + std::to_string(extent.promised / extent.voxels) +
                    " volumes one after the other; the first was read.");
  return extent;
}

}  // namespace

Result<LoadedVolume> readVolume(const fs::path& file, Progress& progress, const ReadLimits& limits) {
  auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  if (describesSequence(*header))
    return failure(ErrorCode::unsupported, quoted(file) + " is a recorded sweep, not a volume; reconstruct it first.",
                   {{"file", file.string()}});
  LoadedVolume loaded;
  loaded.notes = header->notes;
  auto extent = extentOf(*header, loaded.notes);
  if (!extent) return passOn(extent.error());
  if (auto usable = checkGrid(extent->grid); !usable) {
    Error error = usable.error();
    error.sentence = quoted(file) + ": " + error.sentence;
    error.context.emplace_back("file", file.string());
    return passOn(std::move(error));
  }
  if (!header->hasGeometry)
    loaded.notes.push_back("Spacing is 1 x 1 x 1 mm with the origin at 0 and no rotation: the true spacing is probably unknown.");
  const glm::dmat3& axes = extent->grid.directions;
  const double shear =
      std::max({std::abs(glm::dot(axes[0], axes[1])), std::abs(glm::dot(axes[0], axes[2])), std::abs(glm::dot(axes[1], axes[2]))});
  if (shear > 0.01) loaded.notes.push_back("The axes are not at right angles to each other; they were kept as they are.");
  auto echo =
      readGrey(*header, {.pixels = extent->voxels, .promised = extent->promised, .what = "Reading voxels"}, limits, progress, loaded.notes);
  if (!echo) return passOn(echo.error());
  loaded.volume.grid = extent->grid;
  loaded.volume.echo = *std::move(echo);
  progress.report("Reading voxels", 1.0);
  return loaded;
}

Result<LoadedVolume> readLabelVolume(const fs::path& file, Progress& progress, const ReadLimits& limits) {
  const auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  const bool rescaled = header->slope != 1.0 || header->intercept != 0.0;
  if (header->type != SampleType::u8 || header->channels != 1 || rescaled) {
    const std::string found = std::to_string(header->channels) + " x " + nameOf(header->type) + (rescaled ? ", rescaled" : "");
    return failure(ErrorCode::unsupported,
                   quoted(file) + " holds " + found + " samples, but labels are one 8 bit unsigned number a voxel; export them as such.",
                   {{"file", file.string()}, {"found", found}, {"expected", "1 x 8 bit unsigned"}});
  }
  return readVolume(file, progress, limits);
}

}  // namespace ew
