#include "files/volume_extent.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ew::detail {

Result<VolumeExtent> volumeExtentOf(const ImageHeader& header, std::vector<Message>& notes) {
  if (describesSequence(header))
    return failure(ErrorCode::unsupported, say<"%1 is a recorded sweep, not a volume; reconstruct it first.">(quoted(header.file)),
                   {{"file", header.file.string()}});
  VolumeExtent extent;
  extent.grid = header.geometry;
  std::array<std::uint64_t, 3> sizes{1, 1, 1};
  std::copy_n(header.sizes.begin(), std::min<std::size_t>(header.sizes.size(), 3), sizes.begin());
  const auto voxels = productOf(sizes);
  const auto promised = productOf(header.sizes);
  if (voxels == std::optional<std::uint64_t>(0) || promised == std::optional<std::uint64_t>(0))
    return failure(ErrorCode::emptyVolume,
                   say<"%1 holds no voxels (%2); choose a file with samples in it.">(quoted(header.file), sizesText(header.sizes)),
                   {{"file", header.file.string()}, {"sizes", sizesText(header.sizes)}});
  constexpr std::uint64_t longestAxis = 1u << 30;
  if (!promised || std::any_of(sizes.begin(), sizes.end(), [](std::uint64_t size) { return size > longestAxis; }))
    return failure(ErrorCode::tooLarge,
                   say<"The header of %1 promises %2 samples, but an axis may have %3 at most; check that the file is undamaged.">(
                       quoted(header.file), sizesText(header.sizes), longestAxis),
                   {{"file", header.file.string()}, {"promised", sizesText(header.sizes)}, {"limit", std::to_string(longestAxis)}});
  for (std::size_t axis = 0; axis < 3; ++axis) extent.grid.dims[static_cast<int>(axis)] = static_cast<int>(sizes[axis]);
  extent.voxels = *voxels;
  extent.promised = *promised;
  extent.volumes = header.wantedChannel ? header.channels : extent.promised / extent.voxels;
  if (header.wantedChannel && extent.promised > extent.voxels)
    return failure(ErrorCode::unsupported,
                   say<"%1 has more axes than three of space and one of time (%2); export one of its volumes.">(quoted(header.file),
                                                                                                                sizesText(header.sizes)),
                   {{"file", header.file.string()}, {"sizes", sizesText(header.sizes)}});
  if (extent.volumes > 1) notes.push_back(firstOfSeveral(header, extent.volumes));
  if (auto usable = checkGrid(extent.grid); !usable) {
    Error error = usable.error();
    error.message = say<"%1: %2">(quoted(header.file), error.message);
    error.context.emplace_back("file", header.file.string());
    return passOn(std::move(error));
  }
  if (!header.spacingProblem.empty())
    notes.push_back(header.spacingProblem);
  else if (!header.hasGeometry)
    notes.push_back(say<"Spacing is 1 x 1 x 1 mm with the origin at 0 and no rotation: the true spacing is probably unknown.">());
  const glm::dmat3& axes = extent.grid.directions;
  const double shear =
      std::max({std::abs(glm::dot(axes[0], axes[1])), std::abs(glm::dot(axes[0], axes[2])), std::abs(glm::dot(axes[1], axes[2]))});
  if (shear > 0.01) notes.push_back(say<"The axes are not at right angles to each other; they were kept as they are.">());
  return extent;
}

Message firstOfSeveral(const ImageHeader& header, std::uint64_t volumes) {
  return say<"%1 holds %2 volumes one after the other; the first was read.">(quoted(header.file), volumes);
}

Message noSuchVolume(const std::filesystem::path& file, std::uint64_t volumes, std::int64_t asked) {
  return counted<"%2 holds %1 volume, no number %3; choose one that is there.",
                 "%2 holds %1 volumes, no number %3; choose one that is there.">(volumes, quoted(file), asked);
}

}  // namespace ew::detail
