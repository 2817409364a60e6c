#pragma once

#include <filesystem>
#include <memory>

#include "ew/core/image.h"
#include "ew/core/result.h"

namespace ew {

/// Writes a film, image after image at an even rate: .avi (Motion JPEG, which every player reads) or .mp4 (H.264, which browsers play;
/// MPEG-4 part 2 where the installed FFmpeg cannot write that). A film that is not finished is of no use: whoever stops removes the file.
class ClipWriter {
 public:
  /// @param width_px, height_px of every image; an odd size grows by a pixel that repeats the last one, because players ask for even ones
  /// @error unsupported (ending), notWritable, badField (smaller than 2 x 2)
  [[nodiscard]] static Result<ClipWriter> open(const std::filesystem::path& file, int width_px, int height_px, double rate_hz);
  ~ClipWriter();
  ClipWriter(ClipWriter&&) noexcept;
  ClipWriter& operator=(ClipWriter&&) noexcept;

  /// Expects an image of the size that was named. @error notWritable
  [[nodiscard]] Result<void> add(const RgbImage& image);
  /// Writes the end of the film; nothing is added after it.
  /// @error notWritable when not all of the film is in its file (the disk was full): no player may show anything of it
  [[nodiscard]] Result<void> finish();

 private:
  struct Parts;
  explicit ClipWriter(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

[[nodiscard]] bool isClipFile(const std::filesystem::path& file);

}  // namespace ew
