#include "ew/io/volume_file.h"
#include "grey_samples.h"
#include "image_header.h"
#include "volume_extent.h"

namespace ew {
using namespace detail;
namespace fs = std::filesystem;

Result<LoadedVolume> readVolume(const fs::path& file, Progress& progress, const ReadLimits& limits) {
  auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  LoadedVolume loaded;
  loaded.notes = header->notes;
  auto extent = volumeExtentOf(*header, loaded.notes);
  if (!extent) return passOn(extent.error());
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
