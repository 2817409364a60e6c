#pragma once

#include <nlohmann/json.hpp>

#include "ew/library/case.h"

namespace ew {

inline constexpr const char* kManifestName = "case.json";

/// The manifest in the order people read it.
nlohmann::ordered_json orderedManifestOf(const Case& edited);

}  // namespace ew
