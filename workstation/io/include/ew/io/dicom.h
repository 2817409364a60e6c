#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/deidentify.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"

namespace ew {

/// One item of the Sequence of Ultrasound Regions (DICOM PS3.3, C.8.5.5), as written.
struct UltrasoundRegion {
  PixelRect rect;           ///< as the file gives it, corners included; may lie outside the image when it is stale
  int spatialFormat = 0;    ///< 1: two-dimensional image, 2: M-mode, 3: spectrum, 4: wave form, 5: graphics
  int dataType = 0;         ///< 1: tissue, 2: colour flow, ..., 13: grey bar, 14: colour bar
  std::uint32_t flags = 0;  ///< bit 0: the region is transparent
  int unitsX = 0;           ///< 3: cm
  int unitsY = 0;
  double deltaX = 0.0;  ///< per pixel, in the units
  double deltaY = 0.0;
  std::optional<glm::dvec2> referencePixel;  ///< counted from the region's corner
  glm::dvec2 referenceValue{0.0};            ///< what the units are at the reference pixel
  Message problem;                           ///< why it cannot be used as a calibrated image; empty: it can
  bool stale = false;                        ///< it reaches beyond the image: made for another size
  [[nodiscard]] bool isBMode() const { return spatialFormat == 1 && dataType == 1; }
  [[nodiscard]] bool usable() const { return problem.empty(); }
  [[nodiscard]] glm::dvec2 pixel_mm() const { return {10.0 * deltaX, 10.0 * deltaY}; }
  /// "1: tissue, 511 x 384 pixels at (84, 31), 0.5105 x 0.5105 mm a pixel": for lists a person chooses from.
  [[nodiscard]] Message describe(std::size_t number) const;
};

enum class DicomKind {
  images,          ///< still or cine: images without places
  enhancedVolume,  ///< Enhanced US Volume: images with places in a volume
  kretz            ///< a GE Kretz file inside a private field
};

/// What a DICOM file holds, found without unpacking its images.
struct DicomSummary {
  DicomKind kind = DicomKind::images;
  int columns = 0;
  int rows = 0;
  std::uint64_t frames = 1;
  std::string photometric;
  std::string codec;  ///< "uncompressed", "JPEG", "JPEG-LS", "JPEG 2000", "RLE"
  std::vector<UltrasoundRegion> regions;
  std::optional<glm::dvec2> spacing_mm = {};  ///< Pixel Spacing, where there are no regions
  std::optional<bool> burnedInText;           ///< what the file says of text in the images; empty: nothing
  std::vector<double> timeSteps_s;            ///< of an Enhanced US Volume, when it holds several volumes
  Removed identifying;                        ///< what an import leaves out
};

/// Whether the file is DICOM, by its beginning.
[[nodiscard]] bool isDicom(const std::filesystem::path& file);

/// @error notFound, notReadable, tooLarge, badHeader, badField, truncated, unsupported
[[nodiscard]] Result<DicomSummary> inspectDicom(const std::filesystem::path& file, const ReaderLimits& limits = {});

/// What becomes of coloured pixels (Doppler, tinted greys), which an echo level cannot show.
enum class ColourRule {
  ask,        ///< coloured images are refused, with the share of coloured pixels
  keepGrey,   ///< their luminance becomes the echo level; the mask tells where they are
  dropColour  ///< they become black; the mask tells where they are
};

struct CineOptions {
  std::optional<int> region;           ///< number in the file's list, from 1; 0: the whole image; empty: the only calibrated one
  std::optional<glm::dvec2> pixel_mm;  ///< replaces what the region or Pixel Spacing says; needed where neither does
  std::optional<double> rate_hz = {};  ///< frames a second, > 0; replaces what the file says of their times
  ColourRule colour = ColourRule::ask;
  std::vector<PixelRect> blank;  ///< of the whole image, made black before it is cut
  bool keepText = false;         ///< take the whole image although the file says that text is burned in
  std::uint64_t mostFrames = 0;  ///< of the first ones, to look at; 0: all
  bool acceptsSmall = false;     ///< a region with less than a tenth of the image is taken (Retention)
};

/// A still or a cine: images in the order of time with the size of a pixel and no pose.
struct Cine {
  Sequence sequence;  ///< per frame its time where the file gives one, and "Image" to "Picture": mm from the upper left pixel
  glm::dvec2 pixel_mm{0.0};
  std::vector<std::uint8_t> coloured;  ///< like sequence.pixels: 1 where the source was coloured; empty: nowhere
  double colouredShare = 0.0;          ///< of the pixels that were kept
  Removed removed;
  std::vector<Message> notes;
};

/// Reads a DICOM still or cine as grey images, cut to one region. A context entry ("ask", "region" | "pixel-mm" | "colour" | "blank")
/// names the option whose answer is missing.
/// @error as inspectDicom; missingCalibration (several regions, stale ones or none and no Pixel Spacing: asked), unsupported (coloured and
/// not
///        told what to do, burned-in text), too little kept (asked), cancelled
[[nodiscard]] Result<Cine> readDicomCine(const std::filesystem::path& file, const CineOptions& options = {},
                                         Progress& progress = noProgress(), const ReaderLimits& limits = {});

struct DicomVolumeOptions {
  std::optional<int> timeStep;  ///< from 1; needed when the file holds several volumes
};

struct DicomVolume {
  Volume volume;
  Removed removed;
  std::vector<Message> notes;
};

/// Reads an Enhanced US Volume onto a regular grid in the file's own volume frame of reference (mm). Planes at uneven distances are
/// resampled linearly along their normal; planes that are not parallel are refused (readDicomPlanes gives them one by one).
/// @error as inspectDicom; badField (geometry), unsupported (no Enhanced US Volume, planes not parallel), missingCalibration (several
///        time steps, none chosen), cancelled
[[nodiscard]] Result<DicomVolume> readDicomVolume(const std::filesystem::path& file, const DicomVolumeOptions& options = {},
                                                  Progress& progress = noProgress(), const ReaderLimits& limits = {});

/// The planes of an Enhanced US Volume as a sequence with a pose each ("Image" to "Reference"), whatever way they lie.
[[nodiscard]] Result<Cine> readDicomPlanes(const std::filesystem::path& file, const DicomVolumeOptions& options = {},
                                           Progress& progress = noProgress(), const ReaderLimits& limits = {});

}  // namespace ew
