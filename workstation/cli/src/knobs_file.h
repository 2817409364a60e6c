#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "ew/core/result.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

namespace ew::cli {

/// Knobs from a JSON object: gain, dgc (8 factors, near to far), depth_mm, focus_mm, zoom, quality ("weave" or "linear"), marker_left;
/// what is not named stays neutral.
/// @error notFound, notReadable, badHeader (not a JSON object), badField (unknown key, wrong type, out of range: named with what was found)
[[nodiscard]] Result<Knobs> readKnobs(const std::filesystem::path& file);

/// A scene from a JSON object: gain_and_dgc (true or false). Errors as readKnobs.
[[nodiscard]] Result<Scene> readScene(const std::filesystem::path& file);

/// Why a probe cannot be set so, or success. @error badField (depth outside the probe's range)
[[nodiscard]] Result<void> checkDepth(const Knobs& knobs, const Probe& probe);

[[nodiscard]] nlohmann::json toJson(const Knobs& knobs);

}  // namespace ew::cli
