#pragma once

#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/sdk/host.h"

namespace ew::stitching {

/// `echoweave stitch PROJECT.json -o DIR [--until STEP] [--threads N] [--prune]`
[[nodiscard]] Result<sdk::Commands::Outcome> runStitchCommand(const std::vector<std::string>& args, Progress& progress);
inline constexpr const char* kStitchUsage = "stitch PROJECT.json -o DIR [--until STEP] [--threads N] [--prune]";
/// What `--help` says after the usage: how a project is written and what lies in DIR afterwards.
extern const char* const kStitchHelp;

}  // namespace ew::stitching
