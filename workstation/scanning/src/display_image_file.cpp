#include "ew/scanning/display_image_file.h"

#include <algorithm>
#include <string>

#include "ew/core/ending.h"
#include "ew/imaging/caption.h"
#include "ew/io/image_file.h"

namespace ew {
namespace {

bool carriesWords(const std::filesystem::path& file) { return !hasEnding(file, ".mha"); }

}  // namespace

Result<void> checkRoomForWarning(int width_px, int height_px, const std::filesystem::path& file) {
  if (!carriesWords(file) || (width_px >= kCaptionMinWidth_px && height_px >= kCaptionMinHeight_px)) return {};
  return failure(ErrorCode::badField,
                 say<"An image of %1 x %2 pixels is too small for the words it must carry; give at least %3x%4, or write .mha.">(
                     width_px, height_px, kCaptionMinWidth_px, kCaptionMinHeight_px),
                 {{"file", file.string()}});
}

Result<void> writeDisplayImage(const DisplayImage& image, double pixel_mm, const std::filesystem::path& file) {
  if (image.hasColour()) return writeDisplayImage(composed(image), pixel_mm, file);
  if (auto fits = checkRoomForWarning(image.width(), image.height(), file); !fits) return fits;
  if (!carriesWords(file)) return writeImage(image.grey, pixel_mm, file);
  GreyImage marked = copyOf(image.grey);
  burnCaption(viewOf(marked), kNotForDiagnosis);
  return writeImage(viewOf(std::as_const(marked)), pixel_mm, file);
}

Result<void> writeDisplayImage(const RgbImage& image, double pixel_mm, const std::filesystem::path& file) {
  if (auto fits = checkRoomForWarning(image.width, image.height, file); !fits) return fits;
  if (!carriesWords(file)) return writeImage(viewOf(image), pixel_mm, file);
  RgbImage marked = image;
  burnCaption(viewOf(marked), kNotForDiagnosis);
  return writeImage(viewOf(std::as_const(marked)), pixel_mm, file);
}

Result<ImageClip> ImageClip::open(const std::filesystem::path& file, int width_px, int height_px, double rate_hz) {
  if (auto fits = checkRoomForWarning(width_px, height_px, file); !fits) return passOn(fits.error());
  auto clip = ClipWriter::open(file, width_px, height_px, rate_hz);
  if (!clip) return passOn(clip.error());
  return ImageClip(std::move(*clip));
}

Result<void> ImageClip::add(const DisplayImage& image) {
  RgbImage marked = composed(image);
  burnCaption(viewOf(marked), kNotForDiagnosis);
  return clip_.add(marked);
}

}  // namespace ew
