#include "ew/io/volume_file.h"
#include "grey_samples.h"
#include "image_header.h"
#include "volume_extent.h"

namespace ew {
using namespace detail;
namespace fs = std::filesystem;

namespace {

/// Lets the header begin at a later one of its volumes.
Result<void> skipTo(std::uint64_t timeStep, ImageHeader& header, VolumeExtent& extent, std::vector<Message>& notes) {
  const std::uint64_t steps = extent.promised / extent.voxels;
  if (timeStep < 1 || timeStep > steps)
    return failure(ErrorCode::badUsage,
                   quoted(header.file) + " holds " + counted(steps, "volume", "volumes") + ", no number " + std::to_string(timeStep) +
                       "; choose one that is there.",
                   {{"file", header.file.string()}, {"ask", "time-step"}});
  if (timeStep == 1) return {};
  if (header.packing == Packing::text || header.dataAtEnd)
    return failure(
        ErrorCode::unsupported,
        "Of " + quoted(header.file) + " the first volume alone can be read, because of how it is stored; convert it to .nii or .mha.",
        {{"file", header.file.string()}});
  const std::uint64_t skipped = (timeStep - 1) * extent.voxels;
  (header.packing == Packing::deflated ? header.skipUnpacked : header.dataOffset) += skipped * header.channels * bytesOf(header.type);
  extent.promised -= skipped;
  std::erase_if(notes, [](const Message& note) { return note.english().ends_with("the first was read."); });
  notes.push_back(quoted(header.file) + " holds " + std::to_string(steps) + " volumes one after the other; number " +
                  std::to_string(timeStep) + " was read.");
  return {};
}

}  // namespace

Result<LoadedVolume> readVolume(const fs::path& file, Progress& progress, const ReadLimits& limits, const VolumeReadOptions& options) {
  auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  LoadedVolume loaded;
  loaded.notes = header->notes;
  auto extent = volumeExtentOf(*header, loaded.notes);
  if (!extent) return passOn(extent.error());
  loaded.spacingKnown = header->hasGeometry;
  loaded.timeSteps = extent->promised / extent->voxels;
  if (auto there = skipTo(options.timeStep, *header, *extent, loaded.notes); !there) return passOn(there.error());
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
