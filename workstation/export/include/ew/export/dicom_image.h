#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/export/dicom_study.h"
#include "ew/imaging/display.h"
#include "ew/imaging/display_image.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/io/deidentify.h"

namespace ew {

/// A part of an image in which pixels have a size: one item of the Sequence of Ultrasound Regions (DICOM PS3.3, C.8.5.5).
struct RegionCalibration {
  enum class Kind {
    image,    ///< both axes in cm: x to the right of the image, y down it
    strip,    ///< M-mode: x in s, y in cm
    colour,   ///< the box of colour Doppler, axes as of the image around it
    spectrum  ///< of a sample volume: x in s, y in cm/s, corrected by the angle, towards the probe positive
  };
  /// How Doppler was set.
  struct Doppler {
    double prf_hz = 0.0, carrier_hz = 0.0, steering_deg = 0.0;
    double angle_deg = 0.0;                              ///< of the correction; of a spectrum
    std::optional<glm::ivec2> volume_px = std::nullopt;  ///< where the sample volume lies in the image of the same picture
    bool operator==(const Doppler&) const = default;
  };
  Kind kind = Kind::image;
  PixelRect rect;
  glm::dvec2 delta{0.0};           ///< from one pixel to the next, in the units of the axes
  glm::ivec2 reference_px{0};      ///< counted from the region's corner; may lie outside of it
  glm::dvec2 referenceValue{0.0};  ///< what the axes are at the centre of that pixel; of an image, 0 at the middle of the probe's face
  std::optional<Doppler> doppler = std::nullopt;  ///< of colour and spectrum
  bool operator==(const RegionCalibration&) const = default;
};

/// The region of a scan image that stands at `corner_px`: all of it.
[[nodiscard]] RegionCalibration regionOf(const DisplayGeometry& geometry, glm::ivec2 corner_px = glm::ivec2(0));
/// Of the strip of the M-mode. @param sweep_s across it @param depth_mm from its upper to its lower edge, from the probe's face
[[nodiscard]] RegionCalibration regionOfStrip(glm::ivec2 size_px, double sweep_s, double depth_mm, glm::ivec2 corner_px = glm::ivec2(0));

/// Of the colour box in the image that stands at `corner_px`: the smallest rectangle around it; none where the knobs have no box, or none
/// of it lies in the image. It comes behind the image's own: readers that take one region in cm take the first.
[[nodiscard]] std::optional<RegionCalibration> regionOfColour(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry,
                                                              glm::ivec2 corner_px = glm::ivec2(0));
/// Of the spectrum. @param knobs with spectral @param image_px where the image of the same picture stands
[[nodiscard]] RegionCalibration regionOfSpectrum(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry,
                                                 glm::ivec2 size_px, double sweep_s, glm::ivec2 corner_px, glm::ivec2 image_px);

/// What a person sees of a scan at one moment, as it is to be stored: grey, or colours.
struct Still {
  std::variant<GreyImage, RgbImage> pixels;
  std::vector<RegionCalibration> regions;

  [[nodiscard]] bool isColour() const { return std::holds_alternative<RgbImage>(pixels); }
  [[nodiscard]] glm::ivec2 size_px() const;
};

/// The image, the strip of the M-mode or the spectrum, or one above the other, as `knobs.mode` says. Without a strip the image alone.
/// @param strip as wide and high as the image; width 0: there is none
[[nodiscard]] Still stillOf(const DisplayImage& image, ImageView<const std::uint8_t> strip, const DisplayGeometry& geometry,
                            const Probe& probe, const Knobs& knobs);

/// What a stored image says of how it was made.
struct DicomImageOptions {
  std::string instanceUid;  ///< of this object: newDicomUid()
  int number = 1;           ///< in its series, from 1
  Probe probe;
  double carrier_hz = 0.0;  ///< 0: the probe's own
  double depth_mm = 0.0;    ///< of the image; 0: not said
  std::string label;        ///< what a person called it; or empty
  std::chrono::sys_seconds taken{};
};

/// The options of an image of a scan that was made in this state. @param number in its series
[[nodiscard]] DicomImageOptions imageOptions(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry, int number,
                                             std::chrono::sys_seconds taken);

inline constexpr const char* kUsImageClass = "1.2.840.10008.5.1.4.1.1.6.1";
inline constexpr const char* kUsMultiframeClass = "1.2.840.10008.5.1.4.1.1.3.1";

/// Writes a DICOM Ultrasound Image (uncompressed, explicit little endian; MONOCHROME2 or RGB as the image is) with its calibrated
/// regions, the invented patient, and "simulation, not for diagnosis" burnt into its lower edge and said in its attributes: Image Comments,
/// Derivation Description, Patient Comments; Quality Control Image is YES, as of a phantom, and so is Burned In Annotation, for there are
/// words in the pixels. Complete or not at all.
/// @return what an archive finds it by
/// @error notWritable; badField: an image too small for the words, or larger than DICOM allows (65535 pixels either way); no identifier
[[nodiscard]] Result<DicomReference> writeDicomImage(const Still& still, const DicomImageOptions& options, const DicomStudy& study,
                                                     const std::filesystem::path& file);

/// A clip to be written.
struct DicomClip {
  glm::ivec2 size_px{0};
  bool isColour = false;  ///< grey stills become colours, too
  std::vector<RegionCalibration> regions;
  std::vector<double> times_s;  ///< of each image, rising: the frame time vector is made from these
  /// The n-th image; called for each in order. Its size is size_px; a coloured one in a grey clip is an error.
  std::function<Result<Still>(std::size_t n)> still;
};

/// The same as a DICOM Ultrasound Multi-frame Image with the time of each frame; one image is in memory at a time.
/// @error as writeDicomImage; also badField: no image, times that fall, more images than a frame time vector holds (8000), or more
///        pixels than one object can (2^32 bytes); cancelled; whatever `still` gives
[[nodiscard]] Result<DicomReference> writeDicomClip(const DicomClip& clip, const DicomImageOptions& options, const DicomStudy& study,
                                                    const std::filesystem::path& file, Progress& progress = noProgress());

}  // namespace ew
