#pragma once

#include "run/command.h"

namespace ew::cli {

/// `case files` lists what lies in a case's folder and what uses it; `case withdraw-file` moves aside what nothing uses.
void addCaseFiles(CLI::App& group, Selection& selection);

}  // namespace ew::cli
