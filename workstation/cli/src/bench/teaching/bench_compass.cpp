#include <algorithm>

#include "bench/teaching/bench_teaching.h"
#include "bench/tools/bench_parts.h"
#include "ew/core/parallel.h"
#include "ew/scanning/contact.h"
#include "ew/simulated_people/simulated_hand.h"
#include "ew/simulated_people/teaching_case.h"

namespace ew {
namespace {

using nlohmann::json;

struct PlaneRuns {
  CompassTarget target;
  std::vector<HandRun> runs;
  std::vector<bool> started;  ///< not: no skin was found to start on
};

/// One start after another, each with a seed of its own.
Result<PlaneRuns> runsTo(const ReferencePlane& plane, const TeachingCase& teaching, const CompassBenchOptions& options,
                         Progress& progress) {
  PlaneRuns made;
  made.target = compassTargetOf(targetOf(plane, teaching.truth, teaching.probe.defaultDepth_mm), toleranceOf(plane), *teaching.skin);
  made.runs.resize(static_cast<std::size_t>(options.starts));
  std::vector<std::uint8_t> started(made.runs.size(), 0);
  RandomHold freely;
  freely.press_mm = usualPress_mm(teaching.probe);
  const bool done = forEachTask(options.starts, options.threads, progress, say<"Hands follow the compass to %1">(plane.name), [&](int n) {
    const auto index = static_cast<std::size_t>(n);
    const std::uint64_t seed = options.seed * 1000003 + static_cast<std::uint64_t>(n);
    const auto start = randomHold(teaching.region, *teaching.skin, seed, freely);
    if (!start) return;
    started[index] = 1;
    made.runs[index] = followCompass(made.target, *start, *teaching.skin, seed + 1);
  });
  if (!done) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
  if (std::find(started.begin(), started.end(), 0) != started.end())
    return failure(ErrorCode::badField, say<"%1 has no skin over its data to start on; look at its box.">(teaching.opened.id),
                   {{"case", teaching.opened.id}});
  return made;
}

json rowOf(const std::string& caseId, const ReferencePlane& plane, const PlaneRuns& made) {
  std::vector<double> times_s;
  for (const HandRun& run : made.runs)
    if (run.reached) times_s.push_back(run.time_s);
  return {{"case", caseId},
          {"name", plane.name},
          {"position_mm", plane.positionTolerance_mm},
          {"angle_deg", plane.angleTolerance_deg},
          {"reachable", made.target.reachable},
          {"left_deg", made.target.left.angle_deg},
          {"left_mm", made.target.left.distance_mm},
          {"starts", made.runs.size()},
          {"reached", times_s.size()},
          {"median_s", shareOf(times_s, 0.5)},
          {"p95_s", shareOf(times_s, 0.95)},
          {"worst_s", shareOf(times_s, 1.0)}};
}

}  // namespace

Result<json> benchCompass(const CompassBenchOptions& options, Progress& progress) {
  json report = {{"machine", machineName()}, {"seed", options.seed},    {"starts", options.starts},
                 {"results", json::array()}, {"planes", json::array()}, {"steps", json::array()}};
  std::size_t all = 0, allReached = 0;
  for (std::size_t n = 0; n < options.cases.size(); ++n) {
    const Case& each = options.cases[n];
    PartOfProgress part(progress, static_cast<double>(n) / static_cast<double>(options.cases.size()),
                        static_cast<double>(n + 1) / static_cast<double>(options.cases.size()));
    const auto teaching = teachingCaseOf(each, false, options.threads, part);
    if (!teaching) return passOn(teaching.error());
    std::vector<double> times_s, changes;
    std::size_t starts = 0;
    json failed = json::array();
    for (const ReferencePlane& plane : teaching->truth.planes) {
      const auto made = runsTo(plane, *teaching, options, part);
      if (!made) return passOn(made.error());
      std::size_t reached = 0;
      for (const HandRun& run : made->runs) {
        changes.push_back(run.changesOfAdvice);
        if (!run.reached) continue;
        times_s.push_back(run.time_s);
        ++reached;
      }
      starts += made->runs.size();
      if (reached < made->runs.size()) failed.push_back(plane.name);
      report["planes"].push_back(rowOf(each.id, plane, *made));
    }
    all += starts;
    allReached += times_s.size();
    json row = {
        {"name", each.id}, {"planes", teaching->truth.planes.size()}, {"starts", starts}, {"reached", times_s.size()}, {"failed", failed}};
    if (starts > 0) {
      row["share"] = static_cast<double>(times_s.size()) / static_cast<double>(starts);
      row["median_s"] = shareOf(times_s, 0.5);
      row["p95_s"] = shareOf(times_s, 0.95);
      row["changes"] = shareOf(changes, 0.5);
    }
    report["results"].push_back(std::move(row));
  }
  report["share"] = all > 0 ? static_cast<double>(allReached) / static_cast<double>(all) : 0.0;
  return report;
}

}  // namespace ew
