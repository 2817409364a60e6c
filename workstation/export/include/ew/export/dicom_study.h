#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "ew/library/case.h"

namespace ew {

/// The words that every object which leaves the program carries as a whole sentence, beside those burnt into its images.
inline constexpr const char* kSimulation = "Simulation, not for diagnosis.";

/// A unique identifier of DICOM: "2.25." and a random UUID as a decimal number (PS3.5, B.2). At most 44 characters.
[[nodiscard]] std::string newDicomUid();
/// Of 128 bits, high half first; the bits of a UUID that say it is random are set. For tests: newDicomUid() gives it random ones.
[[nodiscard]] std::string dicomUidOf(std::uint64_t high, std::uint64_t low);
/// Digits and single points, no leading zeros, at most 64 characters (PS3.5, 9.1).
[[nodiscard]] bool isDicomUid(std::string_view text);

/// The invented patient that images and reports name.
struct PatientIdentity {
  std::string name;  ///< as people write it: "Maren Achterberg"
  std::string id;    ///< unique among all patients of all archives it may get to
  std::string sex;   ///< "female", "male", "other", ""
  std::optional<int> age_years;
  bool operator==(const PatientIdentity&) const = default;
};

/// One examination (a study of DICOM): what images and reports that belong together have in common.
struct DicomStudy {
  PatientIdentity patient;
  std::string title;      ///< as a trainee may read it
  std::string region;     ///< "upper abdomen"; or empty
  std::string operators;  ///< who scanned; or empty
  std::string studyUid;
  std::string imagesUid;   ///< series of the images
  std::string reportsUid;  ///< series of the reports
  std::chrono::sys_seconds begun{};
  bool operator==(const DicomStudy&) const = default;
};

/// An examination of a case that begins now, with identifiers of its own. The patient is the case's; the id is made from the case's.
[[nodiscard]] DicomStudy beginStudy(const Case& examined, std::chrono::sys_seconds now);
/// The same of a volume that belongs to no case: its patient is called "Simulation". @param title of what was scanned
[[nodiscard]] DicomStudy beginStudy(const std::string& title, std::chrono::sys_seconds now);

/// What an archive finds an object by.
struct DicomReference {
  std::string classUid;
  std::string instanceUid;
  bool operator==(const DicomReference&) const = default;
};

}  // namespace ew
