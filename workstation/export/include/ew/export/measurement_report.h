#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/export/dicom_study.h"
#include "ew/measurement/worksheet.h"

namespace ew {

struct MeasurementReportOptions {
  std::string instanceUid;  ///< of this object: newDicomUid()
  int number = 1;           ///< in its series, from 1
  std::chrono::sys_seconds made{};
  std::vector<DicomReference> images = {};  ///< stored images of the same examination that the report goes with
};

inline constexpr const char* kComprehensiveSrClass = "1.2.840.10008.5.1.4.1.1.88.33";

/// What the codes are called that no standard has: their values are "package.LABEL" of measurement packages.
inline constexpr const char* kPrivateCodingScheme = "99ECHOWEAVE";

/// Writes a worksheet as a DICOM structured report (Comprehensive SR, complete and unverified): the package "obstetric" as an OB-GYN
/// Ultrasound Procedure Report (PS3.16, TID 5000), every other as an Imaging Measurement Report (TID 1500). Each value with its unit
/// (UCUM), its standard uncertainty, the measurements it was chosen from, the formula with its source and what went into it, percentiles,
/// usual ranges and remarks. Names are LOINC, SNOMED CT and DICOM codes where the standard has one, else of kPrivateCodingScheme. English.
/// Complete or not at all.
/// @error notWritable; badField (no identifier; a worksheet without a row); internal (what DCMTK refused)
[[nodiscard]] Result<DicomReference> writeMeasurementReport(const measurement::Worksheet& worksheet,
                                                            const MeasurementReportOptions& options, const DicomStudy& study,
                                                            const std::filesystem::path& file);

}  // namespace ew
