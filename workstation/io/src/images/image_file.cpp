#include "ew/io/image_file.h"

#include <png.h>

#include <new>

#include "ew/core/contract.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "files/image_header.h"
#include "images/png_pixels.h"
#include "volumes/meta_writer.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

constexpr std::size_t kLargestPng = 256u << 20;
constexpr std::uint64_t kMostPixels = 1ull << 28;

template <class Pixel>
constexpr int kChannels = sizeof(Pixel);

template <class Pixel>
Result<void> writePng(const Image<Pixel>& image, const fs::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = kChannels<Pixel> == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), image.width * kChannels<Pixel>, nullptr) == 0)
    return failure(ErrorCode::internal, say<"%1 could not be packed as PNG; try another size.">(quoted(file)),
                   {{"file", file.string()}, {"reason", png.message}});
  bytes.resize(size);
  return writeFileSafely(file, bytes);
}

Result<GreyImage> readPng(const fs::path& file) {
  const auto bytes = readTextFile(file, kLargestPng);
  if (!bytes) return passOn(bytes.error());
  auto png = readPngPixels({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()}, file, kMostPixels);
  if (!png) return passOn(png.error());
  GreyImage image;
  image.width = png->width;
  image.height = png->height;
  if (!png->inColour) {
    image.pixels = std::move(png->samples);
    return image;
  }
  image.pixels.resize(png->samples.size() / 3);
  for (std::size_t n = 0; n < image.pixels.size(); ++n)
    image.pixels[n] = luminanceOf(png->samples[3 * n], png->samples[3 * n + 1], png->samples[3 * n + 2]);
  return image;
}

template <class Pixel>
Result<void> writePixels(ImageView<const Pixel> image, double pixel_mm, const fs::path& file) {
  const std::string ending = lowerCase(file.extension().string());
  if (ending != ".png" && ending != ".mha")
    return failure(ErrorCode::unsupported, say<"%1 has an ending that is not written; end its name in .png or .mha.">(quoted(file)),
                   {{"file", file.string()}});
  EW_EXPECTS(image.width > 0 && image.height > 0);
  if (image.width <= 0 || image.height <= 0)
    return failure(ErrorCode::internal, say<"The image has no pixels, so %1 was not written.">(quoted(file)));
  Image<Pixel> packed(image.width, image.height);
  for (int y = 0; y < image.height; ++y) std::copy_n(image.row(y), image.width, viewOf(packed).row(y));
  if (ending == ".png") return writePng(packed, file);
  EW_EXPECTS(pixel_mm > 0.0);
  MetaText text{.sizes = {static_cast<std::uint64_t>(image.width), static_cast<std::uint64_t>(image.height)},
                .geometry = {},
                .kinds = {},
                .samples = true,
                .channels = kChannels<Pixel>,
                .fields = {}};
  text.geometry.spacing_mm = glm::dvec3(pixel_mm);
  const std::span<const std::uint8_t> samples(reinterpret_cast<const std::uint8_t*>(packed.pixels.data()),
                                              packed.pixels.size() * sizeof(Pixel));
  return writeMetaFile(file, text, samples, false, say<"Writing image">(), noProgress());
}

}  // namespace

Result<void> writeImage(ImageView<const std::uint8_t> image, double pixel_mm, const fs::path& file) {
  return writePixels(image, pixel_mm, file);
}

Result<void> writeImage(ImageView<const Rgb> image, double pixel_mm, const fs::path& file) { return writePixels(image, pixel_mm, file); }

Result<GreyImage> readImage(const fs::path& file) try {
  if (const auto status = checkIsFile(file); !status) return passOn(status.error());
  if (lowerCase(file.extension().string()) == ".png") return readPng(file);
  auto loaded = readVolume(file);
  if (!loaded) return passOn(loaded.error());
  const Grid& grid = loaded->volume.grid;
  if (grid.dims.z != 1)
    return failure(ErrorCode::unsupported,
                   say<"%1 is a volume of %2 slices, not an image; open it as a volume.">(quoted(file), grid.dims.z),
                   {{"file", file.string()}});
  GreyImage image;
  image.width = grid.dims.x;
  image.height = grid.dims.y;
  image.pixels = std::move(loaded->volume.echo);
  return image;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace ew
