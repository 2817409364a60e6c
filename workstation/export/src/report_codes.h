#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ew/measurement/quantity.h"
#include "ew/measurement/worksheet.h"

namespace ew::exporting {

/// A coded concept of DICOM: value, scheme, meaning.
struct Code {
  std::string value;
  std::string scheme;
  std::string meaning;
};

[[nodiscard]] Code ucumOf(measurement::Unit unit);

/// Name of what a row measures: a code of LOINC (PS3.16, CID 12004, 12005, 12009), or a private one.
[[nodiscard]] Code nameOf(const std::string& package, const measurement::WorksheetRow& row);

/// The code of a formula (CID 12013, 12014); empty when no code says exactly this formula.
[[nodiscard]] std::optional<Code> equationOf(const std::string& package, std::string_view label);

/// The code of an answer.
[[nodiscard]] Code answerOf(const std::string& package, const measurement::WorksheetRow& row);

/// "Right", "Left" of SNOMED CT (CID 244); empty of neither.
[[nodiscard]] std::optional<Code> lateralityOf(std::string_view side);

}  // namespace ew::exporting
