#pragma once

#include <optional>
#include <string>

#include "ew/acquisition/import.h"
#include "run/command.h"

namespace ew::cli {

/// What `reconstruct` knows beyond a tracked sweep at rest: motors, delays, phases.
struct AcquisitionArguments {
  std::string motor;
  std::string timeOffset;  ///< seconds, or "estimate"
  std::optional<int> phases;
  std::string gate = "automatic";
  std::string rhythm = "heart";
};

/// Checks the words and puts them into the import's options.
/// @error badUsage
[[nodiscard]] Result<void> applyTo(SweepImportOptions& options, const AcquisitionArguments& arguments, Run& run);

/// Whether the delay was asked for and cannot be told: then the command says so and ends with kVerdict.
[[nodiscard]] bool delayUntold(const ImportPlan& plan, Run& run);

/// Names the files of the phases, of the volumes and, unless `coverage` is empty, of their coverage.
[[nodiscard]] Result<void> announcePhases(Run& run, const std::string& output, const std::string& coverage, int phases);

/// Gates the sweep and writes one volume per phase.
[[nodiscard]] Result<int> writePhases(const SweepInput& opened, const AcquisitionArguments& arguments, const std::string& output,
                                      const std::string& coverage, Run& run, Progress& progress);

}  // namespace ew::cli
