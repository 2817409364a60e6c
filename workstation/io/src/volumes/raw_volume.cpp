#include "ew/io/raw_volume.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "ew/core/numbers.h"
#include "files/grey_samples.h"
#include "files/image_header.h"
#include "files/volume_extent.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

struct TypeName {
  RawType type;
  const char* name;
  SampleType sample;
};
constexpr std::array kRawTypes{TypeName{RawType::u8, "u8", SampleType::u8},    TypeName{RawType::i8, "i8", SampleType::i8},
                               TypeName{RawType::u16, "u16", SampleType::u16}, TypeName{RawType::i16, "i16", SampleType::i16},
                               TypeName{RawType::u32, "u32", SampleType::u32}, TypeName{RawType::i32, "i32", SampleType::i32},
                               TypeName{RawType::f32, "f32", SampleType::f32}, TypeName{RawType::f64, "f64", SampleType::f64}};

const TypeName& entryOf(RawType type) {
  return *std::find_if(kRawTypes.begin(), kRawTypes.end(), [&](const TypeName& one) { return one.type == type; });
}

std::vector<std::string_view> split(std::string_view text, char by) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(by, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

Result<ImageHeader> headerOf(const fs::path& file, const RawLayout& layout) {
  if (const auto status = checkIsFile(file); !status) return passOn(status.error());
  for (int axis = 0; axis < 3; ++axis) {
    if (layout.dims[axis] < 1)
      return failure(ErrorCode::badUsage, say<"The volume needs at least one sample along each axis; give its dimensions.">(),
                     {{"ask", "raw"}});
    if (!std::isfinite(layout.spacing_mm[axis]) || !(layout.spacing_mm[axis] > 0.0))
      return failure(ErrorCode::missingCalibration, say<"The spacing of raw samples is not in the file; give it in mm, above 0.">(),
                     {{"file", file.string()}, {"ask", "spacing"}});
  }
  ImageHeader header;
  header.file = file;
  header.dataFile = file;
  header.dataOffset = layout.offset;
  header.type = entryOf(layout.type).sample;
  header.bigEndian = layout.bigEndian;
  for (int axis = 0; axis < 3; ++axis) header.sizes.push_back(static_cast<std::uint64_t>(layout.dims[axis]));
  header.geometry.spacing_mm = layout.spacing_mm;
  header.geometry.directions = layout.directions;
  header.hasGeometry = true;
  return header;
}

/// One sample as a number.
double valueAt(const std::uint8_t* bytes, RawType type, bool bigEndian) {
  const std::size_t size = bytesOf(type);
  std::array<std::uint8_t, 8> copy{};
  std::memcpy(copy.data(), bytes, size);
  if (bigEndian != (std::endian::native == std::endian::big)) std::reverse(copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(size));
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, copy.data(), sizeof(T));
    return static_cast<double>(value);
  };
  switch (type) {
    case RawType::u8:
      return as(std::uint8_t{});
    case RawType::i8:
      return as(std::int8_t{});
    case RawType::u16:
      return as(std::uint16_t{});
    case RawType::i16:
      return as(std::int16_t{});
    case RawType::u32:
      return as(std::uint32_t{});
    case RawType::i32:
      return as(std::int32_t{});
    case RawType::f32:
      return as(float{});
    case RawType::f64:
      return as(double{});
  }
  return 0.0;
}

}  // namespace

const char* nameOf(RawType type) { return entryOf(type).name; }
std::uint64_t bytesOf(RawType type) { return detail::bytesOf(entryOf(type).sample); }

Result<RawLayout> parseRawLayout(std::string_view text) {
  const auto refuse = [&](const Message& what) {
    return failure(ErrorCode::badUsage,
                   say<"'%1' does not describe raw samples (%2); write DIMS:TYPE:SPACING[:OFFSET], as in 256x256x180:u8:0.5,0.5,1.2:512.">(
                       std::string(text), what));
  };
  const auto parts = split(text, ':');
  if (parts.size() < 3 || parts.size() > 4) return refuse(say<"three or four parts are needed">());
  RawLayout layout;
  const auto dims = split(parts[0], 'x');
  if (dims.size() != 3) return refuse(say<"three dimensions are needed">());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = parseIntegers(dims[axis]);
    if (!value || value->size() != 1 || value->front() < 1 || value->front() > (1 << 30)) return refuse(say<"a dimension is no count">());
    layout.dims[static_cast<int>(axis)] = static_cast<int>(value->front());
  }
  std::string type = lowerCase(parts[1]);
  if (type.ends_with("be") || type.ends_with("le")) {
    layout.bigEndian = type.ends_with("be");
    type.resize(type.size() - 2);
  }
  const auto* const known = std::find_if(kRawTypes.begin(), kRawTypes.end(), [&](const TypeName& one) { return type == one.name; });
  if (known == kRawTypes.end()) return refuse(say<"the type is not known">());
  layout.type = known->type;
  const auto spacing = split(parts[2], ',');
  if (spacing.size() != 1 && spacing.size() != 3) return refuse(say<"one or three spacings are needed">());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = parseNumber(spacing[spacing.size() == 1 ? 0 : axis]);
    if (!value || !(*value > 0.0) || !std::isfinite(*value)) return refuse(say<"a spacing is not above 0 mm">());
    layout.spacing_mm[static_cast<int>(axis)] = *value;
  }
  if (parts.size() == 4) {
    const auto offset = parseIntegers(parts[3]);
    if (!offset || offset->size() != 1 || offset->front() < 0) return refuse(say<"the offset is no count of bytes">());
    layout.offset = static_cast<std::uint64_t>(offset->front());
  }
  return layout;
}

std::string textOf(const RawLayout& layout) {
  std::string text = std::to_string(layout.dims.x) + "x" + std::to_string(layout.dims.y) + "x" + std::to_string(layout.dims.z) + ":" +
                     nameOf(layout.type) + (bytesOf(layout.type) > 1 ? (layout.bigEndian ? "be" : "le") : "") + ":" +
                     textOf(layout.spacing_mm.x) + "," + textOf(layout.spacing_mm.y) + "," + textOf(layout.spacing_mm.z);
  if (layout.offset > 0) text += ":" + std::to_string(layout.offset);
  return text;
}

Result<VolumeReadResult> readRawVolume(const fs::path& file, const RawLayout& layout, Progress& progress, const ReaderLimits& limits) {
  const auto header = headerOf(file, layout);
  if (!header) return passOn(header.error());
  VolumeReadResult loaded;
  const auto extent = volumeExtentOf(*header, loaded.notes);
  if (!extent) return passOn(extent.error());
  auto echo = readGrey(*header, {.pixels = extent->voxels, .promised = extent->promised, .what = say<"Reading voxels">()}, limits, progress,
                       loaded.notes, &loaded.warnings);
  if (!echo) return passOn(echo.error());
  loaded.volume.grid = extent->grid;
  loaded.volume.echo = *std::move(echo);
  loaded.notes.push_back(
      say<"Read as %1, as you said; the origin is the first voxel, and which way the axes lie in the patient is not in the file.">(
          textOf(layout)));
  return loaded;
}

std::vector<RawLayout> guessRawLayouts(std::uint64_t fileBytes, std::size_t most) {
  constexpr std::array<std::uint64_t, 10> offsets{0, 128, 256, 352, 512, 1024, 2048, 4096, 8192, 16384};
  constexpr std::array<int, 24> usual{64,  96,  100, 128, 150, 160, 176, 192, 200, 224, 240, 256,
                                      288, 300, 320, 352, 384, 400, 448, 480, 512, 600, 640, 1024};
  struct Ranked {
    RawLayout layout;
    double cost = 0.0;
  };
  std::vector<Ranked> ranked;
  for (const RawType type : {RawType::u8, RawType::u16, RawType::f32})
    for (std::size_t o = 0; o < offsets.size(); ++o) {
      if (offsets[o] >= fileBytes || (fileBytes - offsets[o]) % bytesOf(type) != 0) continue;
      const std::uint64_t samples = (fileBytes - offsets[o]) / bytesOf(type);
      for (const int x : usual)
        for (const int y : usual) {
          const std::uint64_t plane = static_cast<std::uint64_t>(x) * static_cast<std::uint64_t>(y);
          if (samples % plane != 0) continue;
          const std::uint64_t z = samples / plane;
          if (z < 16 || z > 2048) continue;
          RawLayout layout;
          layout.dims = {x, y, static_cast<int>(z)};
          layout.type = type;
          layout.offset = offsets[o];
          // Cubes without a header of 8 bits first; each step away from that costs.
          const double shape =
              std::abs(std::log(static_cast<double>(x) / y)) + std::abs(std::log(static_cast<double>(y) / static_cast<double>(z)));
          ranked.push_back({layout, shape + 0.7 * static_cast<double>(o) + (type == RawType::u8 ? 0.0 : type == RawType::u16 ? 0.8 : 1.2)});
        }
    }
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) { return a.cost < b.cost; });
  std::vector<RawLayout> guesses;
  for (std::size_t n = 0; n < std::min(most, ranked.size()); ++n) guesses.push_back(ranked[n].layout);
  return guesses;
}

Result<RawPreview> previewRawVolume(const fs::path& file, const RawLayout& layout, Progress& progress) {
  RawLayout spaced = layout;
  for (int axis = 0; axis < 3; ++axis)
    if (!(spaced.spacing_mm[axis] > 0.0)) spaced.spacing_mm[axis] = 1.0;  // the images do not depend on it
  const auto header = headerOf(file, spaced);
  if (!header) return passOn(header.error());
  const std::uint64_t x = header->sizes[0], y = header->sizes[1], z = header->sizes[2], size = bytesOf(layout.type);
  const auto samples = productOf(header->sizes);
  std::error_code ec;
  const std::uint64_t bytes = fs::file_size(file, ec);
  const std::array<std::uint64_t, 3> images{x * y, x * z, y * z};
  if (*std::max_element(images.begin(), images.end()) > (64u << 20))
    return failure(ErrorCode::tooLarge,
                   say<"Slices of %1 samples are too large for a preview; check the dimensions.">(sizesText(header->sizes)));
  if (ec || !samples || *samples > bytes / size || layout.offset > bytes - *samples * size)
    return failure(ErrorCode::truncated,
                   say<"%1 has %2 bytes, fewer than %3 samples of %4 after %5 need; correct the dimensions.">(
                       quoted(file), bytes, sizesText(header->sizes), size, layout.offset),
                   {{"file", file.string()}});
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> row(x * size);
  std::array<std::vector<double>, 3> values;
  for (std::size_t n = 0; n < 3; ++n) values[n].reserve(images[n]);
  const auto readRow = [&](std::uint64_t j, std::uint64_t k) {
    in.seekg(static_cast<std::streamoff>(layout.offset + (k * y + j) * x * size));
    return static_cast<bool>(in.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(row.size())));
  };
  const auto unreadable = [&] {
    return failure(ErrorCode::notReadable, say<"%1 cannot be read; check its permissions.">(quoted(file)), {{"file", file.string()}});
  };
  const auto stopped = [] { return failure(ErrorCode::cancelled, say<"Reading the slices was stopped.">()); };
  const auto value = [&](std::uint64_t i) { return valueAt(row.data() + i * size, layout.type, layout.bigEndian); };
  for (std::uint64_t j = 0; j < y; ++j) {
    if (progress.cancelRequested()) return stopped();
    if (!readRow(j, z / 2)) return unreadable();
    for (std::uint64_t i = 0; i < x; ++i) values[0].push_back(value(i));
  }
  const Message reading = say<"Reading the slices">();
  for (std::uint64_t k = 0; k < z; ++k) {
    progress.report(reading, static_cast<double>(k) / static_cast<double>(z));
    if (!readRow(y / 2, k)) return unreadable();
    for (std::uint64_t i = 0; i < x; ++i) values[1].push_back(value(i));
    for (std::uint64_t j = 0; j < y; ++j) {
      if (progress.cancelRequested()) return stopped();
      in.seekg(static_cast<std::streamoff>(layout.offset + ((k * y + j) * x + x / 2) * size));
      if (!in.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(size))) return unreadable();
      values[2].push_back(value(0));
    }
  }
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const auto& image : values)
    for (const double one : image)
      if (std::isfinite(one)) {
        lowest = std::min(lowest, one);
        highest = std::max(highest, one);
      }
  if (layout.type == RawType::u8) lowest = 0.0, highest = 255.0;
  const auto grey = [&](const std::vector<double>& image) {
    std::vector<std::uint8_t> levels;
    levels.reserve(image.size());
    const double width = highest * 0.5 - lowest * 0.5;
    for (const double one : image) {
      const double share = std::isfinite(one) && width > 0.0 ? (one * 0.5 - lowest * 0.5) / width : 0.0;
      levels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0))));
    }
    return levels;
  };
  return RawPreview{grey(values[0]), grey(values[1]), grey(values[2])};
}

}  // namespace ew
