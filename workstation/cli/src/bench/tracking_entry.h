#pragma once

#include "run/command.h"

namespace ew::cli {

void addTrackingBench(CLI::App& group, Selection& selection);

}  // namespace ew::cli
