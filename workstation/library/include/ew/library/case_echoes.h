#pragma once

#include <string>
#include <vector>

#include "ew/library/case.h"

namespace ew {

// What forms the echoes of tissue that was drawn, for a case whose volume is a file: beside its level the surfaces between tissues, the
// body's motion and its blood, as examinations of virtual patients have them. "echoes" of case.json, which stands in Case::otherFields;
// loadCaseVolume reads it. Without it a level is that of a recorded volume.

/// The files that it names, relative to the case folder; none when the case has no such field.
[[nodiscard]] std::vector<std::string> echoFilesOf(const Case& opened);

}  // namespace ew
