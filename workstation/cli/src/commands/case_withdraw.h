#pragma once

#include "run/command.h"

namespace ew::cli {

/// `case withdraw`: a case is moved out of the library, and nothing is deleted.
void addCaseWithdraw(CLI::App& group, Selection& selection);

}  // namespace ew::cli
