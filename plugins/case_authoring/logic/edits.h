#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/library/new_case.h"
#include "ew/sdk/host.h"

namespace ew::case_authoring {

/// A field of a case as a form shows and edits it: everything else of the case stays as it is.
template <class Value>
struct CaseField {
  std::function<Value(const Case&)> of;
  std::function<Case(Case, Value)> with;
};
using CaseText = CaseField<std::string>;
using CaseTexts = CaseField<std::vector<std::string>>;

[[nodiscard]] CaseText fieldAt(std::string Case::*text);
[[nodiscard]] CaseText fieldAt(std::string CasePatient::*text);
[[nodiscard]] CaseText fieldAt(std::string RecordingRights::*text);
[[nodiscard]] CaseTexts fieldAt(std::vector<std::string> Case::*texts);

/// Ids with one among them or not; the others keep their order, for the first is the one at the start, and a new one comes last.
[[nodiscard]] std::vector<std::string> withListed(std::vector<std::string> ids, const std::string& id, bool listed);

/// A list of texts as lines, and back: lines without words are left out.
[[nodiscard]] std::string linesOf(const std::vector<std::string>& texts);
[[nodiscard]] std::vector<std::string> textsIn(const std::string& lines);

/// Where the probe stands at the start; empty: the program chooses.
[[nodiscard]] Case withStartPose(Case edited, const std::optional<Transform<frame::World, frame::Probe>>& probeToWorld);

/// What giving a volume (giveVolume) changed, on the case as it is by now.
[[nodiscard]] Case withVolumeGiven(Case present, const Case& given);

/// Whether any part of the image lies within the volume when the probe of `scan` stands at `probeToWorld`. The image is looked at every
/// 4 mm of depth and in 17 lines: a volume that is smaller may be missed.
[[nodiscard]] bool seesVolume(const sdk::Cases::Scan& scan, const Transform<frame::World, frame::Probe>& probeToWorld);

/// The field a problem is about ("patient.age_years"), from its context; empty when it names none. An index is cut off: "start_pose[3]"
/// is about "start_pose".
[[nodiscard]] std::string fieldOf(const Error& problem);

}  // namespace ew::case_authoring
