#pragma once

#include <optional>
#include <span>
#include <string>

#include "ew/core/translatable.h"
#include "ew/library/case_values.h"

namespace ew::case_authoring {

/// A tissue that a structure of a recorded volume may be said to consist of. The numbers are those of our virtual patients' anatomy
/// (resources/anatomy), where their sources stand; `reflection_db` is what makes a shadow's edge.
struct TissueChoice {
  const char* name;               ///< translatable in the context kTissueTexts
  double attenuation_dbPerCmMhz;  ///< one way
  double reflection_db;
  double impedance_mrayl;
};
inline constexpr const char* kTissueTexts = "ew::case_authoring::TissueChoice";
[[nodiscard]] std::span<const TissueChoice> namedTissues();

/// The named tissue that the case gives a label; empty when it gives none, or other numbers than any of them has (see hasTissue).
[[nodiscard]] std::optional<std::size_t> tissueOf(const Case& shown, int label);
[[nodiscard]] bool hasTissue(const Case& shown, int label);

/// The case with a label's tissue; empty: grey levels decide what sound loses there. A tissue needs the scene's shadows: they are
/// switched on with it.
/// @param name of the structure, for those who read the scene
[[nodiscard]] Case withTissue(Case edited, int label, const std::string& name, std::optional<std::size_t> tissue);

}  // namespace ew::case_authoring
