#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/case.h"

namespace ew {

/// What `echoweave bench compass` measures.
struct CompassBenchOptions {
  std::vector<Case> cases;
  int starts = 100;  ///< for each plane, 1..10000
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores; the result does not depend on it
};

/// Hands that follow nothing but the compass, from random starts on the skin that each case can be scanned from, to every plane that it
/// expects. The result: {"results": [{"name" (case), "planes", "starts", "reached", "share", "median_s", "p95_s", "changes" (median),
/// "failed" (names of planes with hands that gave up)}], "planes": [{"case", "name", "position_mm", "angle_deg", "reachable", "reached",
/// "starts", "median_s", "p95_s", "worst_s"}], "share", "steps": []}.
/// @error as loadCaseTruth, readBodySkin, readProbes; badField (no skin to start on); cancelled
[[nodiscard]] Result<nlohmann::json> benchCompass(const CompassBenchOptions& options, Progress& progress);

/// What `echoweave bench exercises` measures.
struct ExerciseBenchOptions {
  std::vector<Case> cases;
  int draws = 20;  ///< of each exercise and level, 1..10000
  std::uint64_t seed = 1;
  int threads = 0;
};

/// Every exercise that cases give by themselves, at levels 1, 3 and 5, by a scripted expert (the hand that follows the compass; the middle
/// of an organ's section; the truth's caliper points; clicks up to 0.5 mm beside) and by chance (random poses, pixels and calipers). The
/// result: {"results": [{"name" (case), "offered", "withheld", "draws", "expert", "chance"}], "exercises": [{"id", "level", "draws",
/// "expert", "chance"}] with how many passed, "withheld": [{"id", "why"}]}.
/// @error as teachingCaseOf; cancelled
[[nodiscard]] Result<nlohmann::json> benchExercises(const ExerciseBenchOptions& options, Progress& progress);

}  // namespace ew
