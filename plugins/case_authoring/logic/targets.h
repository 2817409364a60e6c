#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/volume.h"

// The targets of a manifest: what a trainee is to find. Points and planes are in the frame of the case's file, before it is placed.
namespace ew::case_authoring {

[[nodiscard]] std::size_t targetCount(const nlohmann::json& manifest);
/// Null when there is no such target.
[[nodiscard]] nlohmann::json targetAt(const nlohmann::json& manifest, std::size_t number);
[[nodiscard]] std::string kindOf(const nlohmann::json& target);  ///< "point", "plane", "structure"

/// A target as it begins.
[[nodiscard]] nlohmann::json pointTarget(const std::string& name, const glm::dvec3& at_mm);
[[nodiscard]] nlohmann::json planeTarget(const std::string& name, const Transform<frame::File, frame::Probe>& probeToFile);
[[nodiscard]] nlohmann::json structureTarget(const std::string& name, int label);
[[nodiscard]] nlohmann::json organTarget(const std::string& name, const std::string& organ);

/// Edits of a manifest; everything they do not name stays as it is.
[[nodiscard]] nlohmann::json withTargetAdded(nlohmann::json manifest, const nlohmann::json& target);
[[nodiscard]] nlohmann::json withTarget(nlohmann::json manifest, std::size_t number, const nlohmann::json& target);
[[nodiscard]] nlohmann::json withoutTarget(nlohmann::json manifest, std::size_t number);
[[nodiscard]] nlohmann::json withTargetMoved(nlohmann::json manifest, std::size_t from, std::size_t to);
/// Steps of the case's own lessons that name the target by its old name name it by the new one.
[[nodiscard]] nlohmann::json withTargetRenamed(nlohmann::json manifest, std::size_t number, const std::string& name);

/// How many steps of the case's own lessons name a target.
[[nodiscard]] std::size_t stepsNaming(const nlohmann::json& manifest, const std::string& target);
/// `wished`, or with a number behind it when a target has that name already.
[[nodiscard]] std::string freeTargetName(const nlohmann::json& manifest, const std::string& wished);

[[nodiscard]] std::optional<glm::dvec3> pointOf(const nlohmann::json& target);
[[nodiscard]] std::optional<Transform<frame::File, frame::Probe>> planeOf(const nlohmann::json& target);
[[nodiscard]] std::optional<int> labelOf(const nlohmann::json& target);
[[nodiscard]] double numberOf(const nlohmann::json& target, const char* key, double otherwise);

/// Whether a target of the manifest has this label.
[[nodiscard]] bool isLabelled(const nlohmann::json& manifest, int label);
/// Whether the patient of the case is virtual: its structures are the patient's organs.
[[nodiscard]] bool hasPatient(const nlohmann::json& manifest);
/// A number from 1 that neither a target nor a tissue of the manifest nor a voxel has; 0: all are taken.
/// @param labels null: none yet
[[nodiscard]] int freeLabel(const nlohmann::json& manifest, const Volume* labels);

}  // namespace ew::case_authoring
