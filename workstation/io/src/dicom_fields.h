#pragma once

#include <optional>
#include <vector>

#include "dicom_dataset.h"
#include "dicom_pixels.h"
#include "ew/io/dicom.h"

namespace ew::detail {

constexpr const char* kEnhancedUsVolume = "1.2.840.10008.5.1.4.1.1.6.2";

/// Names of what is in the file and can identify someone, in file order, and the count of private fields; sequences are looked into.
[[nodiscard]] Removed identifyingFields(const DicomItem& data);

/// The regions with what is wrong with each.
[[nodiscard]] std::vector<UltrasoundRegion> regionsOf(const DicomItem& data, std::uint64_t columns, std::uint64_t rows);

/// Times of the frames by the field that the file names, or by the one that is there; empty when there is none.
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
