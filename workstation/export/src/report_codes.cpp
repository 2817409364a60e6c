#include "report_codes.h"

#include <algorithm>
#include <array>

#include "ew/export/measurement_report.h"

namespace ew::exporting {
namespace {
using measurement::Unit;
using measurement::WorksheetRow;

struct Named {
  std::string_view label;
  const char* value;
  const char* meaning;
};

// LOINC codes and meanings as PS3.16 lists them in CID 12005 (biometry), 12009 (early gestation) and 12004 (ratios). Diameters outer to
// outer have no code there: a code for the usual convention would hide the difference.
constexpr std::array kObstetricNames{Named{"CRL", "11957-8", "Crown Rump Length"},
                                     Named{"BPD", "11820-8", "Biparietal Diameter"},
                                     Named{"OFD", "11851-3", "Occipital-Frontal Diameter"},
                                     Named{"HC", "11984-2", "Head Circumference"},
                                     Named{"APAD", "11818-2", "Anterior-Posterior Abdominal Diameter"},
                                     Named{"TAD", "11862-0", "Transverse Abdominal Diameter"},
                                     Named{"AC", "11979-2", "Abdominal Circumference"},
                                     Named{"FL", "11963-6", "Femur Length"},
                                     Named{"CI", "11823-2", "Cephalic Index"}};

// CID 12013 (gestational age) and 12014 (weight).
constexpr std::array kObstetricEquations{Named{"GA_BPD", "11902-4", "BPD, Hadlock 1984"},
                                         Named{"GA_HC", "11932-1", "HC, Hadlock 1984"},
                                         Named{"GA_AC", "11892-7", "AC, Hadlock 1984"},
                                         Named{"GA_FL", "11920-6", "FL, Hadlock 1984"},
                                         Named{"GA_CRL_HADLOCK", "11910-7", "CRL, Hadlock 1992"},
                                         Named{"GA_CRL_ROBINSON", "11914-9", "CRL, Robinson 1975"},
                                         Named{"EFW_HADLOCK_AC_FL", "11751-5", "EFW by AC, FL, Hadlock 1985"},
                                         Named{"EFW_HADLOCK_BPD_AC_FL", "11735-8", "EFW by AC, BPD, FL, Hadlock 1985"},
                                         Named{"EFW_HADLOCK_HC_AC_FL", "11746-5", "EFW by AC, FL, HC, Hadlock 1985"},
                                         Named{"EFW_HADLOCK_BPD_HC_AC_FL", "11732-5", "EFW by AC, BPD, FL, HC, Hadlock 1985"}};

template <std::size_t N>
std::optional<Code> found(const std::array<Named, N>& list, std::string_view label) {
  const auto at = std::find_if(list.begin(), list.end(), [&](const Named& named) { return named.label == label; });
  if (at == list.end()) return std::nullopt;
  return Code{at->value, "LN", at->meaning};
}

}  // namespace

Code ucumOf(Unit unit) {
  switch (unit) {
    case Unit::one:
      return {"1", "UCUM", "no units"};
    case Unit::percent:
      return {"%", "UCUM", "Percent"};
    case Unit::mm:
      return {"mm", "UCUM", "millimeter"};
    case Unit::cm:
      return {"cm", "UCUM", "centimeter"};
    case Unit::mm2:
      return {"mm2", "UCUM", "square millimeter"};
    case Unit::cm2:
      return {"cm2", "UCUM", "square centimeter"};
    case Unit::ml:
      return {"ml", "UCUM", "milliliter"};
    case Unit::g:
      return {"g", "UCUM", "gram"};
    case Unit::kg:
      return {"kg", "UCUM", "kilogram"};
    case Unit::degree:
      return {"deg", "UCUM", "degree"};
    case Unit::s:
      return {"s", "UCUM", "second"};
    case Unit::ms:
      return {"ms", "UCUM", "millisecond"};
    case Unit::perMinute:
      return {"/min", "UCUM", "per minute"};
    case Unit::mmPerS:
      return {"mm/s", "UCUM", "millimeter per second"};
    case Unit::cmPerS:
      return {"cm/s", "UCUM", "centimeter per second"};
    case Unit::cmPerS2:
      return {"cm/s2", "UCUM", "centimeter per square second"};
    case Unit::mlPerMinute:
      return {"ml/min", "UCUM", "milliliter per minute"};
    case Unit::mmHg:
      return {"mm[Hg]", "UCUM", "millimeter of mercury"};
    case Unit::weeks:
      return {"wk", "UCUM", "week"};
    case Unit::days:
      return {"d", "UCUM", "day"};
  }
  return {"1", "UCUM", "no units"};
}

Code nameOf(const std::string& package, const WorksheetRow& row) {
  if (package == "obstetric")
    if (auto known = found(kObstetricNames, row.label)) return *known;
  return {package + "." + row.label, kPrivateCodingScheme, row.title.english};
}

std::optional<Code> equationOf(const std::string& package, std::string_view label) {
  return package == "obstetric" ? found(kObstetricEquations, label) : std::nullopt;
}

Code answerOf(const std::string& package, const WorksheetRow& row) {
  return {package + "." + row.choice, kPrivateCodingScheme, row.choiceTitle.english};
}

std::optional<Code> lateralityOf(std::string_view side) {
  if (side == "right") return Code{"24028007", "SCT", "Right"};
  if (side == "left") return Code{"7771000", "SCT", "Left"};
  return std::nullopt;
}

}  // namespace ew::exporting
