#pragma once

#include <filesystem>
#include <utility>

#include "ew/core/result.h"
#include "ew/imaging/display_image.h"
#include "ew/io/clip_file.h"

namespace ew {

/// The only way in which a scan image leaves the program. A .png carries "simulation, not for diagnosis" along its lower edge, burnt in
/// over grey and colour alike; a .mha is for measuring: the bare levels with the pixel size, one channel, or three when there are colours.
/// Complete or not at all.
/// @error notWritable, unsupported (ending), badField (a .png too small for the words: see checkRoomForWarning)
[[nodiscard]] Result<void> writeDisplayImage(const DisplayImage& image, double pixel_mm, const std::filesystem::path& file);
[[nodiscard]] Result<void> writeDisplayImage(const RgbImage& image, double pixel_mm, const std::filesystem::path& file);

/// Whether an image of this size in this file has room for the words it must carry; to be asked before hours of work.
/// @error badField
[[nodiscard]] Result<void> checkRoomForWarning(int width_px, int height_px, const std::filesystem::path& file);

/// A film of scan images, .avi or .mp4: every image carries the words.
class ImageClip {
 public:
  /// @error as ClipWriter::open; badField (too small for the words)
  [[nodiscard]] static Result<ImageClip> open(const std::filesystem::path& file, int width_px, int height_px, double rate_hz);
  /// Expects an image of the size that was named. @error notWritable
  [[nodiscard]] Result<void> add(const DisplayImage& image);
  /// @error notWritable
  [[nodiscard]] Result<void> finish() { return clip_.finish(); }

 private:
  explicit ImageClip(ClipWriter clip) : clip_(std::move(clip)) {}
  ClipWriter clip_;
};

}  // namespace ew
