#pragma once

#include <string>
#include <vector>

#include "ew/library/case.h"
#include "run/command.h"

namespace ew::cli {

/// The benchmarks of what teaches, below `bench`.
void addTeachingBenches(CLI::App& group, Selection& selection);

/// The cases that were named, or every shipped one. @error as findCase, shippedCasesFolder
[[nodiscard]] Result<std::vector<Case>> namedOrShipped(const std::vector<std::string>& names);

}  // namespace ew::cli
