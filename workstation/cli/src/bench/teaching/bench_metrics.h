#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/case.h"

namespace ew {

/// What `echoweave bench metrics` asks.
struct MetricsBenchOptions {
  std::vector<Case> cases;
  int people = 30;  ///< of each level, 3..1000; the same people in every lesson
  std::uint64_t seed = 1;
  int threads = 0;
  int draws = 2000;                 ///< of the intervals
  std::filesystem::path keep = {};  ///< where every attempt is written as the window keeps it; empty: nowhere
};

/// An area under the curve from which a metric is on by default.
inline constexpr double kLeastArea = 0.7;

/// Simulated novices, intermediates and experts work through every lesson of the cases; every metric of every step is worked out, and how
/// far it tells the levels apart. What is compared with an expert's scan is compared with the median expert's, who is none of those tested.
/// The result: {"people", "seed", "draws", "program", "simd", "lessons" (names), "attempts", "rows": [{"scope": "all" | "kind" | "lesson",
/// "name" (empty, kind of step, or "case/lesson"), "metric", "version", "unit", "better": "less" | "more", "steps", "n", "auc" and "g" of
/// novices and experts ({"value", "low", "high"}), "auc_novice_intermediate", "auc_intermediate_expert", "on"}]}. The metric "task_score"
/// is the score of the step itself, which is no metric, for comparison.
/// @error as teachingCaseOf, TraineeCase::of, keepSimulatedAttempt; cancelled
[[nodiscard]] Result<nlohmann::json> benchMetrics(const MetricsBenchOptions& options, Progress& progress);

/// The tables as Markdown.
[[nodiscard]] std::string metricsSection(const nlohmann::json& measured);
/// `page` with the part between the markers put anew, or a whole page where it has none.
[[nodiscard]] std::string withMetricsSection(const std::string& page, const std::string& section);
/// resources/assessment/default-metrics.json: {"format": 1, "study": {...}, "metrics": {ID: {"version", "on", "auc", "low", "high",
/// "kinds": {KIND: {"on", "auc", "low", "high"}}}}}.
[[nodiscard]] nlohmann::json defaultMetrics(const nlohmann::json& measured);

/// What `echoweave bench attempts` writes.
struct AttemptsBenchOptions {
  std::vector<Case> cases;
  int count = 100;
  double minutes = 5.0;  ///< scanned in each attempt, 0..60
  std::uint64_t seed = 1;
  int threads = 0;
  std::filesystem::path folder;
};
/// Attempts of varied people at the lessons of the cases in turn. The result: {"attempts", "seconds" (scanned, all together), "images",
/// "mib"}. @error as benchMetrics
[[nodiscard]] Result<nlohmann::json> benchAttempts(const AttemptsBenchOptions& options, Progress& progress);

}  // namespace ew
