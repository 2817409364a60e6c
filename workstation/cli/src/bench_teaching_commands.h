#pragma once

#include <string>
#include <vector>

#include "command.h"
#include "ew/library/case.h"

namespace ew::cli {

/// The benchmarks of what teaches, below `bench`.
void addTeachingBenches(CLI::App& group, Selection& selection);

/// The cases that were named, or every shipped one. @error as findCase, shippedCasesFolder
[[nodiscard]] Result<std::vector<Case>> namedOrShipped(const std::vector<std::string>& names);

}  // namespace ew::cli
