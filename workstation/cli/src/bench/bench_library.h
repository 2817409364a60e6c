#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "run/command.h"

namespace ew {

/// What `echoweave bench library` measures; the defaults take half a minute.
struct LibraryBenchOptions {
  int cases = 10000;  ///< synthetic case folders, 1..1000000, each with three lessons
  int queries = 200;  ///< typed letter by letter, 1..100000
  int changed = 10;   ///< manifests that are written anew before the third refresh, at most `cases`
  std::uint64_t seed = 1;
};

/// Makes case folders in a temporary folder and indexes them, by the clock on the wall: what a person waits for.
/// The result: {"machine", "cases", "first_index_s", "warm_open_ms" (open, find all, read the first 50 rows), "unchanged_refresh_ms",
/// "changed_refresh_ms", "changed_read" (manifests), "queries", "letters", "search_median_ms", "search_p99_ms", "search_worst_ms" (find and
/// the first 50 rows, after each letter; for trainees), "most_found", "index_mib"}.
/// @error notWritable, cancelled
[[nodiscard]] Result<nlohmann::json> benchLibrary(const LibraryBenchOptions& options, Progress& progress);

namespace cli {

void addLibraryBench(CLI::App& group, Selection& selection);

}  // namespace cli
}  // namespace ew
