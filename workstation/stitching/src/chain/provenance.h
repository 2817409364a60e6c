#pragma once

#include <string>
#include <vector>

#include "ew/stitching/chain.h"
#include "ew/stitching/result_files.h"

namespace ew::stitching {

/// What was joined and how, as JSON without times or facts of the machine: the same inputs give the same text.
/// @param key that names the result
/// @param volumes of the result, which lie beside it
[[nodiscard]] std::string provenanceText(const StitchProject& project, const ChainState& state, const std::string& key,
                                         std::vector<ResultFile> volumes);

}  // namespace ew::stitching
