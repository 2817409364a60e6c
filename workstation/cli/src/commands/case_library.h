#pragma once

#include "run/command.h"

namespace ew::cli {

/// Commands of `case` that hand cases on and keep them: export, import, verify, publish.
void addCaseLibrary(CLI::App& group, Selection& selection);
/// Adds `case unseal`.
void addCaseUnseal(CLI::App& group, Selection& selection);

}  // namespace ew::cli
