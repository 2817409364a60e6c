#pragma once

#include <string>
#include <vector>

#include "ew/library/case.h"

namespace ew {

// How an examination of a case begins, beside probe and pose: fields of case.json that only the console reads. They stand in
// Case::otherFields.

/// Ids of the console's presets that the case offers ("presets"); it starts with the first. Empty: the console stays as it is.
[[nodiscard]] std::vector<std::string> presetsOf(const Case& opened);
/// Those that the program brings with it. The id of somebody's own preset may name what a trainee shall find.
[[nodiscard]] std::vector<std::string> shippedPresetsOf(const Case& opened);
/// Ids of the body marks that are offered first ("body_marks"). Empty: those of the region.
[[nodiscard]] std::vector<std::string> bodyMarksOf(const Case& opened);
[[nodiscard]] Case withPresets(Case edited, const std::vector<std::string>& ids);
[[nodiscard]] Case withBodyMarks(Case edited, const std::vector<std::string>& ids);

}  // namespace ew
