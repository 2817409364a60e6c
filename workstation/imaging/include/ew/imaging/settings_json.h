#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ew/core/result.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Knobs and scenes as JSON: one form for knob files, scene files, cases and recordings. Keys are snake_case with their unit, angles in
/// degrees (`steering_deg`), `focus_mm` a number or a list of up to four, an effect `true`, `false` or an object of its parameters, a
/// tissue an object with its `label`. A missing key keeps the default; a missing `gain_law` is that of the values given (`gain`, `dgc`:
/// the paper's; `gain_db`, `tgc_db`: decibels), so that files from before there was a choice mean what they meant.
/// @param where how error sentences call the document: verbatim("knobs.json"), say<"the scene of case.json">()
/// @param unknown when given, keys that are not known are put there, in objects as they were found in (a tissue's with its label), and
///                are no errors
/// @error badField (key, value found, value expected; also unknown keys, with those that are known, and a label named twice), badHeader
///        (not an object)
[[nodiscard]] Result<Knobs> knobsFromJson(const nlohmann::json& document, const Message& where, nlohmann::json* unknown = nullptr);
[[nodiscard]] Result<Scene> sceneFromJson(const nlohmann::json& document, const Message& where, nlohmann::json* unknown = nullptr);

/// The whole setting: knobsFromJson(toJson(k)) == k for knobs within their limits; an angle that no number of degrees gives comes back
/// within one rounding.
[[nodiscard]] nlohmann::json toJson(const Knobs& knobs);
/// Gain and DGC, what else differs from the default, and every effect and tissue that is there.
/// @param unknown what sceneFromJson did not know: put back where it was, if its effect or tissue is still there
[[nodiscard]] nlohmann::json toJson(const Scene& scene, const nlohmann::json* unknown = nullptr);

/// A probe as its file has it. @param id of the probe: a file's is its name without ending @param where how sentences call the file
/// @error badHeader (not an object), badField (name, value found, value expected), newerFormat
[[nodiscard]] Result<Probe> probeFromJson(const nlohmann::json& object, const std::string& id, const Message& where);
/// Without the id: probeFromJson(toJson(p), p.id, where) == p for a probe that was read from a file.
[[nodiscard]] nlohmann::json toJson(const Probe& probe);

/// Everything that a knobs file or a scene file may hold, one line a key with what it may be: what help texts show.
[[nodiscard]] std::string knobsManual();
[[nodiscard]] std::string sceneManual();

}  // namespace ew
