#pragma once

#include "run/command.h"

namespace ew::cli {

/// `case new`: a case of a volume, a recording, a stitched result, or of nothing yet.
void addCaseNew(CLI::App& group, Selection& selection);

}  // namespace ew::cli
