#pragma once

#include <filesystem>

#include "ew/core/result.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"

namespace ew::cli {

/// Knobs and scenes from files, in the form of ew/imaging/settings_json.h; what is not named stays at its default.
/// @error notFound, notReadable, badHeader (not a JSON object), badField (unknown key, wrong type, out of range: named with what was found)
[[nodiscard]] Result<Knobs> readKnobs(const std::filesystem::path& file);
[[nodiscard]] Result<Scene> readScene(const std::filesystem::path& file);

/// Why a probe cannot be set so, or success. @error badField (depth outside the probe's range)
[[nodiscard]] Result<void> checkDepth(const Knobs& knobs, const Probe& probe);

}  // namespace ew::cli
