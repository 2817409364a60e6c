#pragma once

#include "run/command.h"

namespace ew::cli {

/// `case card`: the image that a case shows before it is prepared.
void addCaseCard(CLI::App& group, Selection& selection);

}  // namespace ew::cli
