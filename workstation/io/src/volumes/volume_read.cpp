#include "ew/io/volume_file.h"
#include "files/grey_samples.h"
#include "files/image_header.h"
#include "files/volume_extent.h"

namespace ew {
using namespace detail;
namespace fs = std::filesystem;

namespace {

/// Lets the header begin at a later one of its volumes.
Result<void> skipTo(std::uint64_t timeStep, ImageHeader& header, VolumeExtent& extent, std::vector<Message>& notes) {
  const std::uint64_t steps = extent.volumes;
  if (timeStep < 1 || timeStep > steps)
    return failure(ErrorCode::badUsage, noSuchVolume(header.file, steps, static_cast<std::int64_t>(timeStep)),
                   {{"file", header.file.string()}, {"ask", "time-step"}});
  if (timeStep == 1) return {};
  const auto tell = [&] {
    std::erase(notes, firstOfSeveral(header, steps));
    notes.push_back(say<"%1 holds %2 volumes one after the other; number %3 was read.">(quoted(header.file), steps, timeStep));
  };
  if (header.wantedChannel) {
    header.wantedChannel = timeStep - 1;
    tell();
    return {};
  }
  if (header.packing == Packing::text || header.dataAtEnd)
    return failure(
        ErrorCode::unsupported,
        say<"Of %1 the first volume alone can be read, because of how it is stored; convert it to .nii or .mha.">(quoted(header.file)),
        {{"file", header.file.string()}});
  const std::uint64_t skipped = (timeStep - 1) * extent.voxels;
  (header.packing == Packing::deflated ? header.skipUnpacked : header.dataOffset) += skipped * header.channels * bytesOf(header.type);
  extent.promised -= skipped;
  tell();
  return {};
}

}  // namespace

Result<VolumeReadResult> readVolume(const fs::path& file, Progress& progress, const ReaderLimits& limits,
                                    const VolumeReadOptions& options) {
  auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  VolumeReadResult loaded;
  loaded.notes = header->notes;
  auto extent = volumeExtentOf(*header, loaded.notes);
  if (!extent) return passOn(extent.error());
  loaded.spacingKnown = header->hasGeometry && header->spacingProblem.empty();
  loaded.spacingProblem = header->spacingProblem;
  loaded.timeSteps = extent->volumes;
  if (auto there = skipTo(options.timeStep, *header, *extent, loaded.notes); !there) return passOn(there.error());
  auto echo = readGrey(*header, {.pixels = extent->voxels, .promised = extent->promised, .what = say<"Reading voxels">()}, limits, progress,
                       loaded.notes, &loaded.warnings);
  if (!echo) return passOn(echo.error());
  loaded.volume.grid = extent->grid;
  loaded.volume.echo = *std::move(echo);
  progress.report(say<"Reading voxels">(), 1.0);
  return loaded;
}

Result<VolumeReadResult> readLabelVolume(const fs::path& file, Progress& progress, const ReaderLimits& limits) {
  const auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  const bool rescaled = header->slope != 1.0 || header->intercept != 0.0;
  if (header->type != SampleType::u8 || header->channels != 1 || rescaled) {
    const Message found = rescaled ? say<"%1 x %2, rescaled">(header->channels, nameOf(header->type))
                                   : say<"%1 x %2">(header->channels, nameOf(header->type));
    return failure(ErrorCode::unsupported,
                   say<"%1 holds %2 samples, but labels are one 8 bit unsigned number a voxel; export them as such.">(quoted(file), found),
                   {{"file", file.string()}, {"found", found.english()}, {"expected", "1 x 8 bit unsigned"}});
  }
  return readVolume(file, progress, limits);
}

}  // namespace ew
