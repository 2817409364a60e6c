#include "images/png_pixels.h"

#include <png.h>

#include <cmath>
#include <cstring>
#include <string_view>

#include "files/image_header.h"

namespace ew::detail {
namespace {

constexpr std::size_t kSignature = 8;
constexpr std::size_t kChunkFrame = 12;  // length, type and checksum of a chunk

std::size_t bigEndianAt(Bytes png, std::size_t at) {
  return std::size_t{png[at]} << 24 | std::size_t{png[at + 1]} << 16 | std::size_t{png[at + 2]} << 8 | png[at + 3];
}

bool isAboutScreens(const std::uint8_t* type) {
  for (const char* each : {"gAMA", "sRGB", "cHRM", "iCCP"})
    if (std::memcmp(type, each, 4) == 0) return true;
  return false;
}

/// The file without what would distort its numbers: libpng makes 8 bit samples for a screen, not for a measurement.
std::vector<std::uint8_t> withoutScreens(Bytes png) {
  std::vector<std::uint8_t> kept(png.begin(), png.begin() + static_cast<std::ptrdiff_t>(std::min(png.size(), kSignature)));
  std::size_t at = kept.size();
  while (png.size() - at >= kChunkFrame) {
    const std::size_t length = bigEndianAt(png, at);
    if (length > png.size() - at - kChunkFrame) break;
    const Bytes chunk = png.subspan(at, kChunkFrame + length);
    if (!isAboutScreens(chunk.data() + 4)) kept.insert(kept.end(), chunk.begin(), chunk.end());
    at += chunk.size();
  }
  kept.insert(kept.end(), png.begin() + static_cast<std::ptrdiff_t>(at), png.end());
  return kept;
}

}  // namespace

double pixelAspectOfPng(Bytes png) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
  if (png.size() < kSignature || std::memcmp(png.data(), signature.data(), kSignature) != 0) return 1.0;
  for (std::size_t at = kSignature; png.size() - at >= kChunkFrame;) {
    const std::size_t length = bigEndianAt(png, at);
    const auto is = [&](const char* type) { return std::memcmp(png.data() + at + 4, type, 4) == 0; };
    if (length > png.size() - at - kChunkFrame || is("IDAT")) break;
    if (is("pHYs") && length == 9) {
      // Pixels in a length: the more of them, the smaller.
      const auto across = static_cast<double>(bigEndianAt(png, at + 8)), down = static_cast<double>(bigEndianAt(png, at + 12));
      const double aspect = across > 0.0 ? down / across : 1.0;
      return aspect > 0.125 && aspect < 8.0 ? aspect : 1.0;
    }
    at += kChunkFrame + length;
  }
  return 1.0;
}

std::uint8_t luminanceOf(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  return static_cast<std::uint8_t>(std::lround(0.299 * red + 0.587 * green + 0.114 * blue));
}

Result<PngPixels> readPngPixels(Bytes bytes, const std::filesystem::path& file, std::uint64_t mostPixels) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto refuse = [&] {
    const std::string why = png.message;
    png_image_free(&png);
    return failure(ErrorCode::badHeader, say<"%1 is not a PNG that can be read (%2); save the image again.">(quoted(file), verbatim(why)),
                   {{"file", file.string()}, {"reason", why}});
  };
  const std::vector<std::uint8_t> plain = withoutScreens(bytes);
  if (png_image_begin_read_from_memory(&png, plain.data(), plain.size()) == 0) return refuse();
  if (const std::uint64_t pixels = std::uint64_t{png.width} * png.height; pixels > mostPixels) {
    png_image_free(&png);
    return failure(ErrorCode::tooLarge,
                   say<"%1 promises %2 pixels, but the limit is %3; save a smaller image.">(quoted(file), pixels, mostPixels),
                   {{"file", file.string()}, {"pixels", std::to_string(pixels)}, {"limit", std::to_string(mostPixels)}});
  }
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // or 16 bits would count as linear light and get a screen's curve
  PngPixels image;
  image.width = static_cast<int>(png.width);
  image.height = static_cast<int>(png.height);
  image.inColour = (png.format & PNG_FORMAT_FLAG_COLOR) != 0;
  png.format = image.inColour ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  image.samples.resize(std::size_t{png.width} * png.height * (image.inColour ? 3 : 1));
  const png_color black{0, 0, 0};
  if (png_image_finish_read(&png, &black, image.samples.data(), 0, nullptr) == 0) return refuse();
  return image;
}

}  // namespace ew::detail
