#pragma once

#include <optional>
#include <vector>

#include "dicom/dicom_dataset.h"
#include "dicom/dicom_pixels.h"
#include "ew/io/dicom.h"

namespace ew::detail {

constexpr const char* kEnhancedUsVolume = "1.2.840.10008.5.1.4.1.1.6.2";

/// Names of what is in the file and can identify someone, in file order, and the count of private fields; sequences are looked into.
[[nodiscard]] Removed identifyingFields(const DicomItem& data);

/// The regions with what is wrong with each; one that is there twice with the same place and scale counts once.
[[nodiscard]] std::vector<UltrasoundRegion> regionsOf(const DicomItem& data, std::uint64_t columns, std::uint64_t rows);

/// What a DICOM file says about the size of its pixels: the one answer for an import and for a recorded screen.
struct DicomScale {
  std::vector<UltrasoundRegion> regions;
  std::optional<std::size_t> onlyRegion;  ///< the one calibrated B-mode region there is, none being stale
  std::vector<std::size_t> bModes;        ///< all calibrated B-mode regions
  std::optional<glm::dvec2> spacing_mm;   ///< Pixel Spacing of the whole image, where no region says anything
  std::optional<double> heightByWidth;    ///< of a pixel, by Pixel Aspect Ratio
  std::vector<Message> hints;             ///< other fields that speak of it and prove nothing, as in "Imager Pixel Spacing 0.1\0.1"
  std::vector<Message> notes;             ///< what was read in another way than it is written
};
[[nodiscard]] DicomScale scaleOf(const DicomItem& data, std::uint64_t columns, std::uint64_t rows);

/// What a file states and no reader here uses although it touches geometry, levels, time or count, in sentences; what is neutral (a
/// rescaling by 1, a window as wide as the levels) states nothing.
/// @param pixel_mm of the images as they were read; a Pixel Spacing or Pixel Aspect Ratio that says the same is used
/// @param placed   whether position and orientation are used
[[nodiscard]] std::vector<Message> unusedFields(const DicomItem& data, const std::optional<glm::dvec2>& pixel_mm, bool placed = false);

/// Times of the frames by the field that the file names, else by those that are there: Frame Time, Frame Time Vector, Cine Rate,
/// Recommended Display Frame Rate, Actual Frame Duration, Effective Duration, Acquisition Duration; empty when none can be used, with a
/// note that tells what was found. A field of other times than those taken is told: from 1 % on, an Acquisition Duration from 10 % on.
[[nodiscard]] std::vector<double> frameTimes(const DicomItem& data, std::uint64_t frames, std::vector<Message>& notes);

/// The Kretz file inside a private field, or empty bytes.
[[nodiscard]] Bytes kretzInside(const DicomItem& data);

/// Where the frames of an Enhanced US Volume lie; pixel (column, row) of a frame lies at origin + column * across + row * down.
struct VolumePlane {
  std::uint64_t frame = 0;
  glm::dvec3 origin_mm{0.0};
  glm::dvec3 across_mm{0.0};
  glm::dvec3 down_mm{0.0};
  double time_s = 0.0;
  bool isTissue = true;
};
/// @error badField (a frame without place, orientation or pixel size)
[[nodiscard]] Result<std::vector<VolumePlane>> volumePlanesOf(const DicomFile& dicom, const PixelLayout& layout);

/// Times of the volumes of a file, ascending; one entry when it holds one.
[[nodiscard]] std::vector<double> timeStepsOf(const std::vector<VolumePlane>& planes);

}  // namespace ew::detail
