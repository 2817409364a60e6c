#pragma once

#include <memory>
#include <string>

#include "ew/phantom/patient.h"
#include "run/command.h"

namespace ew::cli {

/// What `phantom` is asked about a sweep; files that are not wanted are empty.
struct SweepArguments {
  std::string sweep;
  std::string output;
  std::string truePoses;
  std::string deviceSet;
};

/// Announces the sweep's inputs and outputs.
/// @error badUsage (an output without a sweep, a sweep without an output), as OutputSet::announce
[[nodiscard]] Result<void> announceSweep(const SweepArguments& arguments, Run& run);

/// Records the sweep and writes it, its true poses and its device set.
[[nodiscard]] Result<void> makeSweep(const SweepArguments& arguments, const std::shared_ptr<const Patient>& patient, int threads, Run& run,
                                     Progress& progress);

}  // namespace ew::cli
