#pragma once

#include "command.h"

namespace ew::cli {

/// The benchmarks of what teaches, below `bench`.
void addTeachingBenches(CLI::App& group, Selection& selection);

}  // namespace ew::cli
