#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "ew/core/volume.h"
#include "ew/library/case_values.h"

// The targets of a case: what a trainee is to find. Points and planes are in the frame of the case's file, before it is placed.
namespace ew::case_authoring {

/// Null when there is no such target.
[[nodiscard]] const CaseTarget* targetAt(const Case& shown, std::size_t number);

/// A target as it begins.
[[nodiscard]] CaseTarget pointTarget(const std::string& name, const glm::dvec3& at_mm);
[[nodiscard]] CaseTarget planeTarget(const std::string& name, const Transform<frame::File, frame::Probe>& probeToFile);
[[nodiscard]] CaseTarget structureTarget(const std::string& name, int label);
[[nodiscard]] CaseTarget organTarget(const std::string& name, const std::string& organ);

/// Edits of a case; everything they do not name stays as it is, and so does a case without such a target.
[[nodiscard]] Case withTargetAdded(Case edited, CaseTarget target);
[[nodiscard]] Case withTarget(Case edited, std::size_t number, const std::function<void(CaseTarget&)>& change);
[[nodiscard]] Case withoutTarget(Case edited, std::size_t number);
[[nodiscard]] Case withTargetMoved(Case edited, std::size_t from, std::size_t to);
/// Steps of the case's own lessons that name the target by its old name name it by the new one.
[[nodiscard]] Case withTargetRenamed(Case edited, std::size_t number, const std::string& name);

/// How many steps of the case's own lessons name a target.
[[nodiscard]] std::size_t stepsNaming(const Case& shown, const std::string& target);
/// `wished`, or with a number behind it when a target has that name already.
[[nodiscard]] std::string freeTargetName(const Case& shown, const std::string& wished);

/// Whether a target of the case has this label.
[[nodiscard]] bool isLabelled(const Case& shown, int label);
/// Whether the patient of the case is virtual: its structures are the patient's organs.
[[nodiscard]] bool hasPatient(const Case& shown);
/// A number from 1 that neither a target nor a tissue of the case nor a voxel has; 0: all are taken.
/// @param labels null: none yet
[[nodiscard]] int freeLabel(const Case& shown, const Volume* labels);

}  // namespace ew::case_authoring
