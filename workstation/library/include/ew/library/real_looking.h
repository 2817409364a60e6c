#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/message.h"
#include "ew/library/case.h"

namespace ew {

/// Something in a text of a case that looks as if it came from a real person's record.
struct RealLooking {
  std::string field;  ///< of case.json: "patient.name", "history", "previous_examinations[0].findings"
  std::string found;  ///< the words themselves
  Message text;       ///< a warning that names them and says what to write instead
  bool operator==(const RealLooking&) const = default;
};

/// Looks through one text for a date with day and month, a telephone, insurance, patient or accession number, an e-mail or web address, a
/// title with a name ("Dr. Weber"), a hospital by name, a street, one of the commonest given names with one of
/// the commonest family names. It warns and never refuses.
[[nodiscard]] std::vector<RealLooking> realLookingIn(std::string_view text, const std::string& field);

/// The same for all texts of a case and its lessons, but for sources, attribution and licence.
[[nodiscard]] std::vector<RealLooking> realLooking(const Case& opened);

/// The name of nobody: put together from syllables, the same for the same seed.
/// @param language "de": German endings; else English
/// @param sex      as CasePatient::sex
[[nodiscard]] std::string inventedName(std::uint64_t seed, std::string_view language, std::string_view sex);

}  // namespace ew
