#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/deidentify.h"
#include "ew/io/orientation.h"
#include "ew/io/volume_file.h"

namespace ew {

/// What images in the order of time come from.
enum class CineKind {
  film,       ///< .mp4, .avi, .mov, .mkv, .mpg, .wmv, .ts, by content
  dicomFilm,  ///< MPEG-2, H.264 or HEVC inside DICOM
  dicom,      ///< other DICOM stills and cines
  pages,      ///< a TIFF, its pages one after the other
  sequence,   ///< .igs.mha, .igs.nrrd ... with images
  images      ///< a folder of images, or one of several numbered images
};
[[nodiscard]] const char* nameOf(CineKind kind);

/// One image of a cine.
struct CineFrame {
  GreyImage level;                          ///< luminance (ITU-R BT.601) of colours, other levels as stored
  std::vector<std::uint8_t> coloured = {};  ///< like level.pixels: 1 where red, green and blue differ by more than 24; empty: nowhere
  RgbImage colour = {};                     ///< with `coloured`, the image as it was; else empty
  double time_s = 0.0;                      ///< from the first frame on, never running backwards
};

/// A part of the frames, and how large its pixels are by the file itself.
struct PixelScale {
  PixelRect rect = {};
  glm::dvec2 pixel_mm{0.0};  ///< of the frames that are given both are alike
  bool operator==(const PixelScale&) const = default;
};

struct CineInfo {
  CineKind kind = CineKind::film;
  int width_px = 0;  ///< of the frames that are given: upright, with square pixels
  int height_px = 0;
  Orientation orientation = {};         ///< that the file states
  double pixelAspect = 1.0;             ///< how much wider than high the file says a stored pixel is
  std::uint64_t frames = 0;             ///< that the file promises or lets guess; 0: it does not say
  bool framesGuessed = false;           ///< from duration and rate: of a film of varying rate `frames` may be far off
  double rate_hz = 0.0;                 ///< that the file promises; 0: it does not say
  bool timesKnown = false;              ///< false: frames are counted at rate_hz, or 25 a second
  double assumedRate_hz = 0.0;          ///< at which frames are counted because nothing states their times, as a note says; 0: none
  std::vector<PixelScale> scales = {};  ///< calibrated parts: the B-mode regions of DICOM, or the whole by its Pixel Spacing
  Removed removed = {};                 ///< fields left behind
  std::vector<Message> notes = {};
};

/// Whether the file is a film or a TIFF, by its beginning: what readers of volumes and DICOM know nothing of.
[[nodiscard]] bool isFilm(const std::filesystem::path& file);
[[nodiscard]] bool isTiff(const std::filesystem::path& file);
/// Whether the file is DICOM whose frames are a film (MPEG-2, H.264 or HEVC).
[[nodiscard]] bool isDicomFilm(const std::filesystem::path& file);

/// The one way to the frames of a recorded cine or screen: one after another, with one frame in memory at a time (but for a sequence, a
/// folder's list and a DICOM file, which are held whole, packed as they are). Frames of films come from FFmpeg, which a program loads when
/// it meets the first.
///
/// Frames come upright, as the file says that they are to be seen (the matrix of a film's track, Exif of a JPEG, the tag of a TIFF), and
/// with square pixels: where the file says that they are not square, images are stretched along the side that is short of them.
///
/// A file that is damaged further on gives what comes before that; brokenOff() then says in one sentence how far it went. What a decoder
/// hides (a film's damaged macro blocks) is not seen.
class CineReader {
 public:
  /// @param asked to turn and mirror the images on top of what the file says
  /// @param rate_hz of the frames, instead of what the file says or what is assumed
  /// @error notFound, notReadable, badHeader (nothing of it can be read), truncated, tooLarge, unsupported, cancelled
  [[nodiscard]] static Result<CineReader> open(const std::filesystem::path& file, Progress& progress = noProgress(),
                                               const ReaderLimits& limits = {}, const Orientation& asked = {},
                                               const std::optional<double>& rate_hz = {});
  ~CineReader();
  CineReader(CineReader&&) noexcept;
  CineReader& operator=(CineReader&&) noexcept;

  [[nodiscard]] const CineInfo& info() const;

  /// The next frame, into memory that `frame` already has where it fits. @return false: there is none
  /// @error cancelled; before the first frame also as open()
  [[nodiscard]] Result<bool> next(CineFrame& frame, const Progress& progress = noProgress());
  /// Frames given since the start or the last rewind().
  [[nodiscard]] std::uint64_t given() const;
  /// Why there were fewer frames than promised; empty while there is nothing to complain of.
  [[nodiscard]] const std::optional<Error>& brokenOff() const;

  /// The next frame is the first again. @error as open(); notReadable (a film that was changed since; then next() has no frame either)
  [[nodiscard]] Result<void> rewind();

  struct Source;  ///< of the implementation

 private:
  explicit CineReader(std::unique_ptr<Source> source);
  std::unique_ptr<Source> source_;
};

}  // namespace ew
