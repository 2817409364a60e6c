#pragma once

#include <optional>
#include <string>

#include "ew/io/cine_reader.h"

namespace ew {

namespace detail {

/// What becomes of stored images on their way out: pixels that are not square are stretched along one side, then all is put upright.
class FrameShaper {
 public:
  /// @param stored width_px, height_px, pixelAspect and orientation count
  FrameShaper(const CineInfo& stored, const Orientation& asked);
  [[nodiscard]] int width_px() const { return orientation_.swapsSides() ? tall_ : wide_; }
  [[nodiscard]] int height_px() const { return orientation_.swapsSides() ? wide_ : tall_; }
  [[nodiscard]] int squareWidth_px() const { return wide_; }
  [[nodiscard]] int squareHeight_px() const { return tall_; }
  [[nodiscard]] bool stretches() const { return stretches_; }
  void shape(CineFrame& frame);
  /// Where a part of stored images lies in those that are given.
  [[nodiscard]] PixelRect shaped(const PixelRect& stored) const;

 private:
  int storedWide_, storedTall_;
  int wide_, tall_;  ///< with square pixels, before it is turned
  bool stretches_ = false;
  Orientation orientation_;
  CineFrame work_;
};

}  // namespace detail

/// Where the frames of a CineReader come from.
struct CineReader::Source {
  virtual ~Source();
  /// Fills everything of the frame but what finish() makes. @return false: there is none, and `brokenOff` may say why
  virtual Result<bool> read(CineFrame& frame, const Progress& progress) = 0;
  virtual Result<void> rewind() = 0;

  CineInfo info;        ///< of images as they are stored
  CineInfo shown = {};  ///< of images as they are given
  std::optional<detail::FrameShaper> shaper = {};
  std::optional<double> statedRate_hz = {};  ///< of the frames, by a person
  std::uint64_t given = 0;
  std::optional<Error> brokenOff;
};

namespace detail {

/// The one way in which a film's bytes may be taken, in FFmpeg's names.
struct FilmStream {
  const char* container = "";  ///< of its demuxer; empty: the bytes are no film of the kind
  const char* codecs = "";     ///< parted by commas; empty: any
  std::string says = {};       ///< what promised them: "H.264"; empty: nothing did
};

/// Films and TIFF, through the module that knows them.
/// @param shown the file that sentences name; `file` is where its bytes are
[[nodiscard]] Result<std::unique_ptr<CineReader::Source>> openFilm(const std::filesystem::path& file, const std::filesystem::path& shown,
                                                                   CineKind kind, const FilmStream& stream, const ReaderLimits& limits);

}  // namespace detail
}  // namespace ew
