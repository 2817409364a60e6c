#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ew/core/result.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Knobs and scenes as JSON: one form for knob files, scene files, cases and recordings. Keys are snake_case with their unit, angles in
/// degrees (`steering_deg`), `focus_mm` a number or a list of up to four, an effect `true`, `false` or an object of its parameters.
/// A missing key keeps the default.
/// @param where how error sentences call the document ("knobs.json", "scene")
/// @error badField (key, value found, value expected; also unknown keys, with those that are known), badHeader (not an object)
[[nodiscard]] Result<Knobs> knobsFromJson(const nlohmann::json& document, const std::string& where);
[[nodiscard]] Result<Scene> sceneFromJson(const nlohmann::json& document, const std::string& where);

/// The whole setting: knobsFromJson(toJson(k)) == k.
[[nodiscard]] nlohmann::json toJson(const Knobs& knobs);
/// What differs from the default, and every effect that is there.
[[nodiscard]] nlohmann::json toJson(const Scene& scene);

}  // namespace ew
