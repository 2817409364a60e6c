#pragma once

#include "run/command.h"

namespace ew::cli {

/// Every bench that needs nothing but this machine, on one page.
void addAllBenches(CLI::App& group, Selection& selection);

}  // namespace ew::cli
