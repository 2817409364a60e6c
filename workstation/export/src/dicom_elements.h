#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

// DCMTK asks to be read before everything else of the system's.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "ew/core/result.h"
#include "ew/export/dicom_study.h"

namespace ew::exporting {

[[nodiscard]] Message quoted(const std::filesystem::path& file);

/// DCMTK writes warnings of its own to the error stream; what matters comes back as a condition.
void quietDcmtk();

/// A text that fits an element: no control characters, no backslash where it parts values, cut behind the last whole letter within `most`
/// bytes (the standard counts characters, many archives bytes).
[[nodiscard]] std::string fitting(std::string_view text, std::size_t most, bool isParted = true);
/// "Maren Achterberg" as "Achterberg^Maren".
[[nodiscard]] std::string personName(std::string_view name);
[[nodiscard]] std::string dicomDate(std::chrono::sys_seconds time);
[[nodiscard]] std::string dicomTime(std::chrono::sys_seconds time);
/// A number of at most 16 characters, as decimal strings have them.
[[nodiscard]] std::string decimalString(double value);

/// Fills elements of a data set; the first that DCMTK refuses is remembered.
class Elements {
 public:
  explicit Elements(DcmItem& item) : item_(item) {}
  void text(const DcmTag& tag, const std::string& value);
  void whole(const DcmTag& tag, std::uint32_t value);       ///< US, UL
  void signedWhole(const DcmTag& tag, std::int32_t value);  ///< SL
  void real(const DcmTag& tag, double value);               ///< FD
  void attribute(const DcmTag& tag, const DcmTagKey& names);
  void keep(const OFCondition& condition, const char* what);
  [[nodiscard]] DcmItem& item() { return item_; }
  /// @error internal (which element, what DCMTK said)
  [[nodiscard]] Result<void> check() const;

 private:
  DcmItem& item_;
  std::string refused_;
};

/// Patient, study, equipment and SOP Common; and of the series what is no image's or report's own.
struct ObjectHead {
  std::string classUid;
  std::string instanceUid;
  std::string seriesUid;
  std::string modality;  ///< "US", "SR"
  int seriesNumber = 1;
  int number = 1;
  std::string seriesTitle;
  std::chrono::sys_seconds made{};
};
void putPatientAndStudy(Elements& elements, const DicomStudy& study);
void putSeriesAndEquipment(Elements& elements, const DicomStudy& study, const ObjectHead& head);

/// @error badField (an identifier that is none, with which)
[[nodiscard]] Result<void> checkIdentifiers(const DicomStudy& study, const std::string& seriesUid, const std::string& instanceUid);

/// A file as it begins on disk, preamble and file meta information included: explicit little endian. Pixels may follow.
/// @error internal
[[nodiscard]] Result<std::vector<char>> bytesOf(DcmFileFormat& file);

}  // namespace ew::exporting
