#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/export/dicom_image.h"
#include "ew/export/dicom_study.h"
#include "ew/measurement/worksheet.h"
#include "ew/scanning/events.h"

namespace ew {

/// What an examination leaves behind and an archive takes: stored images and filled worksheets. Whoever writes it twice writes the same
/// objects, so that an archive has none of them twice.
struct ExaminationFiles {
  struct StillRecord {
    Still still;
    DicomImageOptions options;
  };
  struct Report {
    measurement::Worksheet worksheet;
    std::string instanceUid;
    std::chrono::sys_seconds made{};
  };
  DicomStudy study;
  std::vector<StillRecord> images;
  std::vector<Report> reports;

  [[nodiscard]] std::size_t count() const { return images.size() + reports.size(); }
};

/// Writes picture_001.dcm …, and the report of each worksheet as PACKAGE.dcm, which refers to the images, into a folder that is there.
/// @return the files
/// @error as writeDicomImage and writeMeasurementReport; cancelled
[[nodiscard]] Result<std::vector<std::filesystem::path>> writeExamination(const ExaminationFiles& examination,
                                                                          const std::filesystem::path& folder,
                                                                          Progress& progress = noProgress());

/// Writes images of a recorded scan as one DICOM clip, each with the time at which it was seen.
/// @param frames of the log, rising; at least one
/// @param make forms the n-th of them and says where it lies
/// @error as writeDicomClip; badField: depth, zoom or orientation change in between, for an object has one scale for all its images
[[nodiscard]] Result<DicomReference> writeDicomScan(
    const ScanLog& log, const std::vector<std::size_t>& frames,
    const std::function<Result<std::pair<DisplayImage, DisplayGeometry>>(std::size_t n)>& make, const DicomStudy& study,
    const std::filesystem::path& file, Progress& progress = noProgress());

}  // namespace ew
