#pragma once

#include <string>

#include "logic/chain.h"

namespace ew::stitching {

/// What was joined and how, as JSON without times or facts of the machine: the same inputs give the same text.
/// @param key that names the result
[[nodiscard]] std::string provenanceText(const StitchProject& project, const ChainState& state, const std::string& key);

}  // namespace ew::stitching
