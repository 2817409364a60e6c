#include "bench/images/echo_entry.h"

#include <memory>
#include <utility>

#include "bench/tools/bench_options.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

/// The drawn ones among the shipped cases, or those that were named.
Result<std::vector<Case>> echoCases(const std::vector<std::string>& names) {
  auto cases = namedOrShipped(names);
  if (!cases) return cases;
  if (names.empty()) std::erase_if(*cases, [](const Case& each) { return each.volume.recipe.empty() || !each.volume.sweeps.empty(); });
  return cases;
}

}  // namespace

void EchoEntry::addOptions(CLI::App& app) {
  addFrameSize(app, size_px);
  addCount(app, "--poses", options.poses, 1, 1000, "Poses of each case (3)");
  addOwnOptions(app);
  addDrawSeed(app, options.seed);
}

void EchoEntry::addOwnOptions(CLI::App& app) {
  app.add_option("--case", cases, "A drawn case whose live echoes are compared; may be given several times (every shipped one)")
      ->type_name("CASE");
  addCount(app, "--timed", options.frames, 5, 10000, "Frames of live echoes timed for each quality and number of threads (40)");
}

Result<void> EchoEntry::measure(Run& run, BenchResults& results, Progress& progress) {
  auto found = echoCases(cases);
  if (!found) return passOn(found.error());
  EchoBenchOptions asked = options;
  asked.cases = *std::move(found);
  asked.width_px = size_px.x;
  asked.height_px = size_px.y;
  nlohmann::json ids = nlohmann::json::array();
  for (const Case& each : asked.cases) ids.push_back(each.id);
  run.report.options["echoes"] = {{"cases", std::move(ids)},
                                  {"poses", asked.poses},
                                  {"frames", asked.frames},
                                  {"size", {asked.width_px, asked.height_px}},
                                  {"seed", asked.seed}};
  run.report.seed = asked.seed;
  return results.take("echoes", benchEchoes(asked, progress), echoSections);
}

void addEchoBench(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection,
                {"echoes",
                 "Live echoes of every quality against the forward model of the same patients, and what their frames take",
                 {"bench echoes", "bench echoes --poses 50 --timed 300 --html bench --report bench.json",
                  "bench echoes --case neck-carotid-thyroid"}},
                std::make_shared<EchoEntry>());
}

}  // namespace ew::cli
