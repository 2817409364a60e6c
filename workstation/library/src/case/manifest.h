#pragma once

#include <nlohmann/json.hpp>

#include "ew/library/case.h"

namespace ew {

inline constexpr const char* kManifestName = "case.json";

/// The manifest in the order people read it.
nlohmann::ordered_json orderedManifestOf(const Case& edited);

/// What a template fills in, as caseFromManifest reads a case. On any thread: a template is a page of the program's own.
[[nodiscard]] Result<Case> valuesOfTemplate(const nlohmann::json& manifest);

/// A manifest in the format of today, whatever format it was written in; anything that is no manifest comes back as it is.
[[nodiscard]] nlohmann::json ofToday(const nlohmann::json& manifest);

/// How sentences call the scene of a case, and a problem of one in the terms of its case: "scene.noise", and not "noise".
[[nodiscard]] Message sceneName();
[[nodiscard]] Error inScene(Error problem);

/// What no field shows by itself: fields that do not go together, matrices that place nothing, files that are not there (looked for in
/// `opened.folder`; empty: no file is looked for).
[[nodiscard]] std::vector<Error> problemsBetweenFields(const Case& opened);

/// fileOfCase for a volume. A header may keep its samples in another file (.mhd, .nhdr): that one lies in the case folder, too.
/// @error as fileOfCase
[[nodiscard]] Result<std::filesystem::path> volumeOfCase(const std::filesystem::path& folder, const std::string& relative,
                                                         const std::string& field);

/// What is wrong with a case although it can be opened: probes that the program does not have, a start pose from which nothing is seen.
[[nodiscard]] std::vector<Error> problemsInUse(const Case& opened);

}  // namespace ew
