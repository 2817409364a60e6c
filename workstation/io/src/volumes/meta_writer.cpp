#include "volumes/meta_writer.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <ostream>

#include "ew/core/numbers.h"
#include "ew/io/rest_in_file.h"
#include "ew/io/safe_file.h"
#include "files/grey_samples.h"
#include "files/image_header.h"
#include "files/staging_file.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;

constexpr std::size_t kWriteChunk = 512u << 10;
constexpr std::size_t kWorthAPage_bytes = 1u << 20;

std::string vectorText(const glm::dvec3& values, std::size_t count) {
  std::string text;
  for (std::size_t axis = 0; axis < count; ++axis) text += (axis == 0 ? "" : " ") + textOf(values[static_cast<int>(axis)]);
  return text;
}

/// The lines up to ElementDataFile. The compressed size is not known yet: room is left for it at the place given back.
std::string headerText(const MetaText& meta, bool compressed, std::size_t* sizeAt) {
  const std::size_t n = meta.sizes.size();
  const std::size_t spatial = std::min<std::size_t>(n, 3);
  std::string text = "ObjectType = Image\nNDims = " + std::to_string(n) + "\nBinaryData = True\nBinaryDataByteOrderMSB = False\n";
  text += std::string("CompressedData = ") + (compressed ? "True" : "False") + "\n";
  if (compressed) {
    text += "CompressedDataSize = ";
    *sizeAt = text.size();
    text += std::string(20, ' ') + "\n";
  }
  std::string matrix;
  for (std::size_t axis = 0; axis < spatial; ++axis)
    matrix += (axis == 0 ? "" : " ") + vectorText(meta.geometry.directions[static_cast<int>(axis)], spatial);
  text += "TransformMatrix = " + matrix + "\n";
  text += "Offset = " + vectorText(meta.geometry.origin_mm, spatial) + "\n";
  text += "CenterOfRotation =" + std::string(n == 2 ? " 0 0" : " 0 0 0") + "\n";
  // In words as the matrix says it in numbers; oblique axes have no such words.
  if (const std::string letters = anatomicalOrientation(meta.geometry.directions); n == 3 && !letters.empty())
    text += "AnatomicalOrientation = " + letters + "\n";
  text += "ElementSpacing = " + vectorText(meta.geometry.spacing_mm, spatial) + "\n";
  std::string sizes;
  for (const std::uint64_t size : meta.sizes) sizes += " " + std::to_string(size);
  text += "DimSize =" + sizes + "\n";
  if (!meta.kinds.empty()) text += "Kinds = " + meta.kinds + "\n";
  if (meta.channels > 1) text += "ElementNumberOfChannels = " + std::to_string(meta.channels) + "\n";
  text += std::string("ElementType = ") +
          (!meta.samples ? "MET_OTHER"
           : meta.real   ? "MET_FLOAT"
           : meta.wide   ? "MET_USHORT"
                         : "MET_UCHAR") +
          "\n";
  for (const auto& [key, value] : meta.fields) text += key + " = " + value + "\n";
  return text;
}

/// A header with blanks at the ends of its first lines, so that samples behind it begin within a page where large vectors do (restInFile).
/// Others read what is left of a line into 500 bytes and nothing behind a longer one (MetaIO, which ITK and 3D Slicer have).
std::string paddedHeader(std::string text) {
  constexpr std::size_t kPage = 4096, kMostOfLine = 400;  // eleven lines have room for a page
  std::size_t missing = (kPage + kBlockBegin_bytes - text.size() % kPage) % kPage;
  for (std::size_t at = text.find('\n'); missing > 0 && at != std::string::npos;) {
    const std::size_t blanks = std::min(missing, kMostOfLine);
    text.insert(at, blanks, ' ');
    missing -= blanks;
    at = text.find('\n', at + blanks + 1);
  }
  return text;
}

Result<void> checkFields(const fs::path& file, const MetaText& meta) {
  for (const auto& [key, value] : meta.fields) {
    const bool keyFits = !key.empty() && trimmed(key) == key && key.find_first_of("=\n\r\0", 0, 4) == std::string::npos;
    const bool valueFits = trimmed(value) == value && value.find_first_of("\n\r\0", 0, 3) == std::string::npos;
    if (!keyFits || !valueFits)
      return badField(file, key.empty() ? say<"a field without a name">() : verbatim(key), verbatim(value),
                      say<"text on one line, without blanks around it,">());
  }
  return {};
}

Result<void> writeRaw(std::ostream& out, const fs::path& file, std::span<const std::uint8_t> samples, const Message& what,
                      Progress& progress) {
  for (std::size_t at = 0; at < samples.size(); at += kWriteChunk) {
    if (progress.cancelRequested()) return stopped(file);
    const auto part = samples.subspan(at, std::min(kWriteChunk, samples.size() - at));
    out.write(reinterpret_cast<const char*>(part.data()), static_cast<std::streamsize>(part.size()));
    if (!out) return notWritable(file, say<"the medium is full or gone">());
    progress.report(what, static_cast<double>(at + part.size()) / static_cast<double>(samples.size()));
  }
  return {};
}

Result<std::uint64_t> writeDeflated(std::ostream& out, const fs::path& file, std::span<const std::uint8_t> samples, const Message& what,
                                    Progress& progress) {
  z_stream stream{};
  // Speckle hardly packs better at higher levels, which take three times as long.
  constexpr int level = 2;
  if (deflateInit(&stream, level) != Z_OK)
    return failure(ErrorCode::internal, say<"The compressor could not be started; free some memory and try again.">());
  std::vector<std::uint8_t> packed(kWriteChunk);
  std::uint64_t written = 0;
  Result<std::uint64_t> result = 0;
  for (std::size_t at = 0;;) {
    if (progress.cancelRequested()) {
      result = stopped(file);
      break;
    }
    const auto part = samples.subspan(at, std::min(kWriteChunk, samples.size() - at));
    at += part.size();
    const bool last = at == samples.size();
    stream.next_in = const_cast<Bytef*>(part.data());  // zlib reads it only, but its old interface does not say so
    stream.avail_in = static_cast<uInt>(part.size());
    do {
      stream.next_out = packed.data();
      stream.avail_out = static_cast<uInt>(packed.size());
      deflate(&stream, last ? Z_FINISH : Z_NO_FLUSH);
      const std::size_t got = packed.size() - stream.avail_out;
      out.write(reinterpret_cast<const char*>(packed.data()), static_cast<std::streamsize>(got));
      written += got;
    } while (stream.avail_out == 0);
    if (!out) {
      result = notWritable(file, say<"the medium is full or gone">());
      break;
    }
    progress.report(what, static_cast<double>(at) / static_cast<double>(std::max<std::size_t>(samples.size(), 1)));
    if (last) {
      result = written;
      break;
    }
  }
  deflateEnd(&stream);
  return result;
}

}  // namespace

Result<void> writeMetaFile(const fs::path& file, const MetaText& meta, std::span<const std::uint8_t> samples, bool compress,
                           const Message& what, Progress& progress) {
  if (auto fits = checkFields(file, meta); !fits) return fits;
  compress = compress && !samples.empty();
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    std::size_t sizeAt = 0;
    const std::string header = headerText(meta, compress, &sizeAt) + "ElementDataFile = LOCAL\n";
    out << (compress || samples.size() < kWorthAPage_bytes ? header : paddedHeader(header));
    if (!compress) return writeRaw(out, file, samples, what, progress);
    const auto packedBytes = writeDeflated(out, file, samples, what, progress);
    if (!packedBytes) return passOn(packedBytes.error());
    out.seekp(static_cast<std::streamoff>(sizeAt));
    out << std::to_string(*packedBytes);
    return {};
  });
}

std::string plainVolumeHeader(const Grid& grid) {
  MetaText meta;
  meta.sizes = {static_cast<std::uint64_t>(grid.dims.x), static_cast<std::uint64_t>(grid.dims.y), static_cast<std::uint64_t>(grid.dims.z)};
  meta.geometry = grid;
  return headerText(meta, false, nullptr) + "ElementDataFile = LOCAL\n";
}

Result<void> writeMetaStream(const fs::path& file, const MetaText& meta, const std::function<Result<std::span<const std::uint8_t>>()>& more,
                             Progress& progress) {
  if (auto fits = checkFields(file, meta); !fits) return fits;
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    std::size_t sizeAt = 0;
    out << headerText(meta, false, &sizeAt) << "ElementDataFile = LOCAL\n";
    while (true) {
      if (progress.cancelRequested()) return stopped(file);
      const auto part = more();
      if (!part) return passOn(part.error());
      if (part->empty()) return {};
      out.write(reinterpret_cast<const char*>(part->data()), static_cast<std::streamsize>(part->size()));
      if (!out) return notWritable(file, say<"the medium is full or gone">());
    }
  });
}

Result<void> writeMetaPair(const fs::path& file, const MetaText& meta, std::span<const std::uint8_t> samples, const Message& what,
                           Progress& progress) {
  if (auto fits = checkFields(file, meta); !fits) return fits;
  OutputSet outputs(LateFile::replace);
  if (auto announced = outputs.announce(file, ".mhd"); !announced) return announced;
  const fs::path rawFile = filesNamedBy(file).front();
  std::ofstream raw(outputs.staged(rawFile), std::ios::binary), header(outputs.staged(file), std::ios::binary);
  if (auto written = writeRaw(raw, rawFile, samples, what, progress); !written) return written;
  // Aside as in place, the samples lie beside the header: of a link, beside what it points to.
  header << headerText(meta, false, nullptr) << "ElementDataFile = " << outputs.staged(rawFile).filename().string() << "\n";
  if (auto finished = finishStream(raw, rawFile); !finished) return finished;
  if (auto finished = finishStream(header, file); !finished) return finished;
  return outputs.commit();
}

}  // namespace ew::detail
