#include "bench/images/flow_entry.h"

#include <memory>
#include <utility>

#include "bench/tools/bench_options.h"
#include "ew/phantom/flow.h"
#include "ew/phantom/patient.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

/// Whether its recipe describes blood.
bool knowsBlood(const Case& each) {
  if (each.volume.recipe.empty() || !each.volume.sweeps.empty()) return false;
  const auto file = fileOfCase(each.folder, each.volume.recipe, "volume.recipe");
  if (!file) return false;
  const auto patient = readPatient(*file);
  return patient && !flowOf(**patient).streams.empty();
}

Result<std::vector<Case>> flowCases(const std::vector<std::string>& names) {
  auto cases = namedOrShipped(names);
  if (cases && names.empty()) std::erase_if(*cases, [](const Case& each) { return !knowsBlood(each); });
  return cases;
}

}  // namespace

void FlowEntry::addOptions(CLI::App& app) {
  addFrameSize(app, size_px);
  app.add_option("--case", cases, "A case whose blood is known; may be given several times (every such shipped one)")->type_name("CASE");
  addCount(app, "--timed", options.frames, 5, 10000, "Frames timed for each setting and number of threads (120)");
  addCount(app, "--packets", options.packets, 100, 100000, "Packets of which a mean and a deviation are taken (1500)");
}

Result<void> FlowEntry::measure(Run& run, BenchResults& results, Progress& progress) {
  auto found = flowCases(cases);
  if (!found) return passOn(found.error());
  FlowBenchOptions asked = options;
  asked.cases = *std::move(found);
  asked.width_px = size_px.x;
  asked.height_px = size_px.y;
  nlohmann::json ids = nlohmann::json::array();
  for (const Case& each : asked.cases) ids.push_back(each.id);
  run.report.options["flow"] = {
      {"cases", std::move(ids)}, {"frames", asked.frames}, {"packets", asked.packets}, {"size", {asked.width_px, asked.height_px}}};
  return results.take("flow", benchFlow(asked, progress), flowSections);
}

void addFlowBench(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection,
                {"flow",
                 "Colour and spectral Doppler: what they add to a frame, and how near they come to the truth",
                 {"bench flow", "bench flow --case neck-carotid-thyroid --html bench --report bench.json"}},
                std::make_shared<FlowEntry>());
}

}  // namespace ew::cli
