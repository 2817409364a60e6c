#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/sdk/host.h"

namespace ew::case_authoring {

/// The value of a dotted field ("patient.name") of a manifest; null when a part of the path is missing.
[[nodiscard]] nlohmann::json fieldOf(const nlohmann::json& manifest, const std::string& path);

/// The manifest with one field set; everything else, unknown fields included, stays as it is. An absent value removes the field, and an
/// object that thereby becomes empty goes too.
[[nodiscard]] nlohmann::json withField(nlohmann::json manifest, const std::string& path, const std::optional<nlohmann::json>& value);

/// Text as the form holds it: an empty text removes the field, unless the manifest cannot be without it (id, title).
[[nodiscard]] nlohmann::json withText(nlohmann::json manifest, const std::string& path, const std::string& text);

/// The text of a field; empty when it is missing or not a text.
[[nodiscard]] std::string textOf(const nlohmann::json& manifest, const std::string& path);

/// Whether the scene has an effect ("scene.noise"): true or an object of its parameters. Gain and DGC are there unless switched off.
[[nodiscard]] bool hasEffect(const nlohmann::json& manifest, const std::string& path);
/// The manifest with an effect of the scene on, at its usual strength, or off. One that is on already keeps its parameters.
[[nodiscard]] nlohmann::json withEffect(nlohmann::json manifest, const std::string& path, bool on);

/// Where the volume lies: volume.file_to_world, the identity when the manifest gives none.
/// @error badField when it is not 16 numbers
[[nodiscard]] Result<Transform<frame::World, frame::File>> placeOf(const nlohmann::json& manifest);
[[nodiscard]] nlohmann::json withPlace(nlohmann::json manifest, const Transform<frame::World, frame::File>& fileToWorld);

/// Whether the case lists a probe. One that lists none allows all.
[[nodiscard]] bool listsProbe(const nlohmann::json& manifest, const std::string& id);
/// The manifest with a probe in its list or not; the others keep their order, for the first is the one at the start, and a new one comes
/// last. A list that becomes empty goes.
[[nodiscard]] nlohmann::json withProbe(nlohmann::json manifest, const std::string& id, bool listed);
/// The probes that are listed, in order.
[[nodiscard]] std::vector<std::string> probesOf(const nlohmann::json& manifest);

/// A list of texts as lines, and back: lines without words are left out, a list without lines goes.
[[nodiscard]] std::string linesOf(const nlohmann::json& manifest, const std::string& path);
[[nodiscard]] nlohmann::json withLines(nlohmann::json manifest, const std::string& path, const std::string& lines);

/// Where the probe stands at the start, probe to world; empty when the case leaves it to the program, or when it is not 16 numbers.
[[nodiscard]] std::optional<Transform<frame::World, frame::Probe>> startPoseOf(const nlohmann::json& manifest);
[[nodiscard]] nlohmann::json withStartPose(nlohmann::json manifest,
                                           const std::optional<Transform<frame::World, frame::Probe>>& probeToWorld);

/// Whether any part of the picture lies within the volume when the probe of `scan` stands at `probeToWorld`. The picture is looked at every
/// 4 mm of depth and in 17 lines: a volume that is smaller may be missed.
[[nodiscard]] bool seesVolume(const sdk::Cases::Scan& scan, const Transform<frame::World, frame::Probe>& probeToWorld);

/// The field a problem is about ("patient.age_years"), from its context; empty when it names none. An index is cut off: "start_pose[3]"
/// is about "start_pose".
[[nodiscard]] std::string fieldOf(const Error& problem);

}  // namespace ew::case_authoring
