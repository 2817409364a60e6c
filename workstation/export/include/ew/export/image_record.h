#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ew/export/dicom_image.h"

namespace ew {

/// What is kept beside the pixels of an image that was stored in an examination, so that it can leave the program another day as the same
/// object.
struct ImageRecord {
  DicomImageOptions options;
  std::vector<RegionCalibration> regions;
  std::string caption;   ///< for people: probe, depth and when
  bool hasLeft = false;  ///< it was saved as a file or handed to the outbox of an archive
  DicomStudy study;      ///< the examination it belongs to
};

inline constexpr int kStoredImageFormat = 1;

[[nodiscard]] nlohmann::json toJson(const ImageRecord& image);
/// storedImageFromJson(toJson(i)) is i. @param where how sentences name the document @error badField, newerFormat
[[nodiscard]] Result<ImageRecord> storedImageFromJson(const nlohmann::json& document, const Message& where);

}  // namespace ew
