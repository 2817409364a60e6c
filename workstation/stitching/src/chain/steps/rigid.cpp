#include "chain/chain_json.h"
#include "chain/chain_memory.h"
#include "chain/concurrent.h"
#include "chain/steps/steps.h"
#include "chain/thread_clock.h"

namespace ew::stitching {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kPairStep = "pairs";

std::optional<PairOutcome> findPair(const ChainRun& run, const Candidate& pair) {
  auto found = readBack<PairOutcome>(run.store.find(kPairStep, pair.key), [](const json& data) { return pairFrom(data.at("outcome")); });
  if (found) {
    found->fixed = pair.fixed;
    found->moving = pair.moving;
  }
  return found;
}

/// Both views are loaded.
Result<PairOutcome> match(ChainRun& run, const Candidate& pair, int threads, Progress& progress) {
  const ViewData &fixed = *run.inputs[pair.fixed].view, &moving = *run.inputs[pair.moving].view;
  progress.report(say<"Registering %1 and %2">(fixed.name, moving.name), 0.0);
  const ThreadClock clock;
  auto made = matchPair(fixed, moving, pair.task, threads, progress, run.levelsOf(pair.fixed, pair.moving));
  if (!made) return passOn(made.error());
  made->fixed = pair.fixed;
  made->moving = pair.moving;
  made->processor_s = clock.seconds();
  ordered_json data = {{"fixed", fixed.name}, {"moving", moving.name}, {"outcome", jsonOf(*made)}};
  if (auto kept = run.store.keep(kPairStep, pair.key, std::move(data)); !kept) return passOn(kept.error());
  return made;
}

}  // namespace

Result<void> rigidStep(ChainRun& run, Progress& progress) {
  if (auto fits = checkMemory(run, Step::rigid); !fits) return fits;
  StepOutcome& outcome = run.outcomeOf(Step::rigid);
  outcome.reused = run.store.find(nameOf(Step::rigid), run.keys[Step::rigid]).has_value();
  std::vector<std::optional<PairOutcome>> found;
  std::vector<std::size_t> missing;
  std::vector<std::uint64_t> bytes;
  for (std::size_t n = 0; n < run.candidates.size(); ++n) {
    const Candidate& pair = run.candidates[n];
    found.push_back(findPair(run, pair));
    if (found.back() || pair.decision == Decision::rejected) continue;
    missing.push_back(n);
    bytes.push_back(forecastPair_bytes(run.inputs[pair.fixed].grid, run.inputs[pair.moving].grid, pair.task));
  }
  if (!missing.empty()) {
    outcome.reused = false;
    for (const std::size_t n : missing)
      for (const std::size_t v : {run.candidates[n].fixed, run.candidates[n].moving})
        if (auto view = run.inputs.load(v, progress); !view) return passOn(view.error());
    const int atOnce = besideEachOther_bytes(run, bytes).pairs;
    auto matched = runConcurrently(missing.size(), atOnce, progress, [&](std::size_t n, Progress& part) -> Result<void> {
      auto made = match(run, run.candidates[missing[n]], run.threadsOfEach(atOnce), part);
      if (!made) return passOn(made.error());
      found[missing[n]] = std::move(*made);
      return {};
    });
    if (!matched) return matched;
  }
  for (std::size_t n = 0; n < run.candidates.size(); ++n) {
    if (!found[n]) continue;
    run.state.pairs.push_back(std::move(*found[n]));
    run.decisions.push_back(run.candidates[n].decision);
  }
  if (outcome.reused) return {};
  return run.store.keep(nameOf(Step::rigid), run.keys[Step::rigid], {{"pairs", run.state.pairs.size()}});
}

}  // namespace ew::stitching
