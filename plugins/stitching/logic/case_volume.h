#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew::stitching {

/// A case as it is with another volume.
struct CaseWithVolume {
  nlohmann::json manifest;
  std::size_t targets = 0;       ///< left out: only the patient of the recipe, which is no longer there, knew where they are
  std::size_t measurements = 0;  ///< the same of these
  std::vector<Error> problems;   ///< that stay
};

/// @param manifest of a case that is valid
/// @param file of the volume, relative to the case's folder; it need not be there yet
/// @param level the same of its level (imaging/tissue_level.h); empty: it has none
/// @param check everything that is wrong with a manifest, with the "field" in its context (sdk::Cases::check)
[[nodiscard]] CaseWithVolume caseWithVolume(nlohmann::json manifest, const std::string& file, const std::string& level,
                                            const std::function<std::vector<Error>(const nlohmann::json&)>& check);

}  // namespace ew::stitching
