#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dicom/pixel_layout.h"
#include "ew/core/image.h"
#include "ew/core/progress.h"

namespace ew::detail {

/// The frames of a file as grey levels, one after the other.
class FrameReader {
 public:
  /// Reads palettes and finds where each frame lies.
  /// @error badField, truncated
  [[nodiscard]] static Result<FrameReader> open(const DicomFile& dicom, const PixelLayout& layout);

  /// Luminance of one frame (ITU-R BT.601) as stored values; `coloured` gets 1 where red, green and blue differ by more than
  /// kColourStep. Values of colours are 0..255, of grey frames whatever is stored.
  /// @error badHeader (a frame that cannot be unpacked), truncated, cancelled
  /// @param colour where it is given, gets red, green and blue of each pixel of a frame in colour; nothing of a grey one
  [[nodiscard]] Result<void> read(std::uint64_t frame, std::vector<std::int32_t>& level, std::vector<std::uint8_t>& coloured,
                                  const Progress& progress, std::vector<Rgb>* colour = nullptr) const;

  static constexpr int kColourStep = 24;  ///< JPEG leaves up to 16 between the colours of what was grey

 private:
  FrameReader(const DicomFile& dicom, PixelLayout layout) : dicom_(&dicom), layout_(std::move(layout)) {}
  Result<void> samplesOf(std::uint64_t frame, std::vector<std::int32_t>& samples, bool& planar, bool& lumaChroma,
                         const Progress& progress) const;

  const DicomFile* dicom_;
  PixelLayout layout_;
  std::vector<std::vector<Bytes>> packed_;  ///< per frame its fragments; empty when not encapsulated
  std::vector<std::array<std::uint8_t, 3>> palette_ = {};
  int paletteFirst_ = 0;
};

/// Levels of a whole recording as 8 bit grey: 8 bit ones as they are, others linearly from smallest..largest; MONOCHROME1 turned over.
/// `coloured` is one byte a pixel, or empty when nothing is coloured.
struct GreyFrames {
  std::vector<std::uint8_t> level;
  std::vector<std::uint8_t> coloured;
};
/// @error as FrameReader::read; cancelled, tooLarge
[[nodiscard]] Result<GreyFrames> readGreyFrames(const DicomFile& dicom, const PixelLayout& layout, const std::vector<std::uint64_t>& which,
                                                const ReaderLimits& limits, Progress& progress, std::vector<Message>& notes);

/// A JPEG file in memory as 8 bit grey. @error badHeader, unsupported, tooLarge (more than mostPixels), cancelled
struct JpegGrey {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> level;
  std::vector<std::uint8_t> coloured;  ///< empty when it has one component
};
[[nodiscard]] Result<JpegGrey> readJpeg(Bytes bytes, const std::filesystem::path& file, std::uint64_t mostPixels, const Progress& progress);

}  // namespace ew::detail
