#include "ew/io/vector_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>

#include "ew/core/contract.h"
#include "files/byte_source.h"
#include "files/image_header.h"
#include "files/volume_extent.h"
#include "volumes/meta_writer.h"

namespace ew {
using namespace detail;
namespace fs = std::filesystem;

Result<void> writeVectorField(const Grid& grid, int components, const fs::path& file, const VectorSlices& slices, Progress& progress) {
  static_assert(std::endian::native == std::endian::little, "the file has the low byte first");
  if (auto usable = checkGrid(grid); !usable) return usable;
  const bool flat = components == 2 && grid.dims.z == 1;
  EW_EXPECTS(components == 3 || flat);
  if (components != 3 && !flat)
    return failure(ErrorCode::internal, say<"A field of two components lies in one slice; %1 was not written.">(quoted(file)));
  if (lowerCase(file.extension().string()) != ".mha")
    return failure(ErrorCode::unsupported, say<"%1 has an ending that is not written; end its name in .mha.">(quoted(file)),
                   {{"file", file.string()}});
  MetaText text{.sizes = {static_cast<std::uint64_t>(grid.dims.x), static_cast<std::uint64_t>(grid.dims.y)},
                .geometry = grid,
                .kinds = {},
                .samples = true,
                .fields = {{"ElementNumberOfChannels", std::to_string(components)}}};
  text.real = true;
  if (!flat) text.sizes.push_back(static_cast<std::uint64_t>(grid.dims.z));
  const std::size_t perSlice = static_cast<std::size_t>(grid.dims.x) * static_cast<std::size_t>(grid.dims.y);
  // About four megabytes at a time: slices enough for every thread, small beside anything else.
  constexpr std::size_t kAtOnce = 1u << 20;
  const int count = static_cast<int>(std::clamp<std::size_t>(kAtOnce / (perSlice * 3), 1, static_cast<std::size_t>(grid.dims.z)));
  std::vector<float> some(static_cast<std::size_t>(count) * perSlice * static_cast<std::size_t>(components));
  int next = 0;
  const auto more = [&]() -> Result<std::span<const std::uint8_t>> {
    if (next >= grid.dims.z) return std::span<const std::uint8_t>();
    const int now = std::min(count, grid.dims.z - next);
    const std::span<float> part(some.data(), static_cast<std::size_t>(now) * perSlice * static_cast<std::size_t>(components));
    if (auto filled = slices(next, now, part); !filled) return passOn(filled.error());
    next += now;
    progress.report(say<"Writing vectors">(), static_cast<double>(next) / grid.dims.z);
    return std::span(reinterpret_cast<const std::uint8_t*>(part.data()), part.size_bytes());
  };
  return writeMetaStream(file, text, more, progress);
}

Result<VectorField> readVectorField(const fs::path& file, const ReaderLimits& limits) try {
  auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  if (header->type != SampleType::f32 && header->type != SampleType::f64)
    return badField(file, say<"the sample type">(), nameOf(header->type), say<"32 or 64 bit floating point">());
  // MetaImage and NRRD tell channels apart from axes; NIfTI has them as the fifth axis and is not read here.
  if (header->channels != 2 && header->channels != 3)
    return badField(file, say<"the number of components">(), verbatim(std::to_string(header->channels)), say<"2 or 3">());
  if (header->packing == Packing::text)
    return failure(ErrorCode::unsupported, say<"%1 holds its vectors as text, which is not read; write it as binary.">(quoted(file)),
                   {{"file", file.string()}});
  VectorField field;
  field.components = static_cast<int>(header->channels);
  std::vector<Message> notes;
  const auto extent = volumeExtentOf(*header, notes);
  if (!extent) return passOn(extent.error());
  field.grid = extent->grid;
  const std::uint64_t count = extent->voxels * header->channels;
  const std::uint64_t bytes = count * bytesOf(header->type);
  if (bytes > limits.maxBytes)
    return failure(ErrorCode::tooLarge, say<"%1 holds more than may be read at once.">(quoted(file)), {{"file", file.string()}});
  auto opened = openSamples(*header, bytes, noProgress());
  if (!opened) return passOn(opened.error());
  if (const auto held = checkAgainstFile(*header, bytes, count, opened->packedBytes); !held) return passOn(held.error());
  std::vector<std::uint8_t> raw(static_cast<std::size_t>(bytes));
  std::size_t got = 0;
  while (got < raw.size()) {
    const auto part = opened->source->read(std::span(raw).subspan(got));
    if (!part) return passOn(part.error());
    if (*part == 0)
      return failure(ErrorCode::truncated, say<"%1 ends before its header says so; copy it again.">(quoted(file)),
                     {{"file", file.string()}});
    got += *part;
  }
  const std::size_t size = bytesOf(header->type);
  if (header->bigEndian)
    for (std::size_t at = 0; at < raw.size(); at += size) std::reverse(raw.data() + at, raw.data() + at + size);
  field.values.resize(static_cast<std::size_t>(count));
  if (header->type == SampleType::f32) {
    std::memcpy(field.values.data(), raw.data(), raw.size());
  } else {
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      double value = 0.0;
      std::memcpy(&value, raw.data() + i * size, size);
      field.values[i] = static_cast<float>(value);
    }
  }
  return field;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace ew
