#pragma once

#include <filesystem>
#include <utility>

#include "ew/core/result.h"
#include "ew/imaging/picture.h"
#include "ew/io/clip_file.h"

namespace ew {

/// The only way in which a scan picture leaves the program. A .png carries "simulation, not for diagnosis" along its lower edge, burnt in
/// over grey and colour alike; a .mha is for measuring: the bare levels with the pixel size, one channel, or three when there are colours.
/// Complete or not at all.
/// @error notWritable, unsupported (ending), badField (a .png too small for the words: see checkRoomForWarning)
[[nodiscard]] Result<void> writePicture(const Picture& picture, double pixel_mm, const std::filesystem::path& file);
[[nodiscard]] Result<void> writePicture(const RgbImage& picture, double pixel_mm, const std::filesystem::path& file);

/// Whether a picture of this size in this file has room for the words it must carry; to be asked before hours of work.
/// @error badField
[[nodiscard]] Result<void> checkRoomForWarning(int width_px, int height_px, const std::filesystem::path& file);

/// A film of scan pictures, .avi or .mp4: every picture carries the words.
class PictureClip {
 public:
  /// @error as ClipWriter::open; badField (too small for the words)
  [[nodiscard]] static Result<PictureClip> open(const std::filesystem::path& file, int width_px, int height_px, double rate_hz);
  /// Expects a picture of the size that was named. @error notWritable
  [[nodiscard]] Result<void> add(const Picture& picture);
  /// @error notWritable
  [[nodiscard]] Result<void> finish() { return clip_.finish(); }

 private:
  explicit PictureClip(ClipWriter clip) : clip_(std::move(clip)) {}
  ClipWriter clip_;
};

}  // namespace ew
