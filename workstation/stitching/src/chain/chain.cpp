#include "ew/stitching/chain.h"

#include <algorithm>
#include <chrono>

#include "chain/chain_memory.h"
#include "chain/chain_run.h"
#include "chain/steps/steps.h"
#include "ew/core/elapsed.h"
#include "ew/core/freed_memory.h"
#include "ew/core/word_table.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

/// Where each step begins in the whole, from what they took on six virtual subvolumes.
constexpr std::array kShares = {0.0, 0.15, 0.40, 0.42, 0.46, 0.80, 0.88, 1.0};

using Body = Result<void> (*)(ChainRun&, Progress&);
constexpr std::array<Body, kSteps.size()> kBodies = {reconstructStep, rigidStep, graphStep, equaliseStep,
                                                     elasticStep,     seamStep,  volumeStep};

class Clock {
 public:
  [[nodiscard]] double seconds() const { return secondsSince(started_); }

 private:
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

/// What lies where the result will, when all of it may be written over.
Result<ResultFiles> checkedResultFiles(const StitchProject& project, const fs::path& folder, const ChainOptions& options,
                                       const Progress& progress) {
  if (auto free = checkNoInputIsOutput(project, folder); !free) return passOn(free.error());
  auto seen = ResultFiles::look(folder, resultFilesIn(StepStore::peek(folder, stepFolders())), progress);
  if (!seen || options.isFolderOwn) return seen;
  if (auto own = seen->checkOwn(); !own) return passOn(own.error());
  return seen;
}

constexpr WordTable<Step, 7> kStepWords{{{"reconstruct", Step::reconstruct},
                                         {"equalise", Step::equalise},
                                         {"rigid", Step::rigid},
                                         {"graph", Step::graph},
                                         {"elastic", Step::elastic},
                                         {"seam", Step::seam},
                                         {"volume", Step::volume}}};

}  // namespace

const char* nameOf(Step step) { return wordIn(kStepWords, step); }

const std::vector<std::string>& stepFolders() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = {"pairs", "bends"};
    for (const Step step : kSteps) all.emplace_back(nameOf(step));
    return all;
  }();
  return names;
}

Result<ChainForecast> forecastChain(const StitchProject& project, const fs::path& folder, const ChainOptions& options) {
  StepStore store = StepStore::peek(folder, stepFolders());
  ChainRun run(project, folder, options, store);
  if (auto looked = run.inputs.identify(noProgress(), true); !looked) return passOn(looked.error());
  run.candidates = candidatesOf(project, run.inputs);
  run.keys = keysOf(project, options, run.inputs, run.candidates);
  bool before = true;
  ChainForecast forecast;
  for (const Step step : kSteps) {
    StepOutcome outcome{.step = step};
    before = before && store.find(nameOf(step), run.keys[step]).has_value() && (step != Step::volume || resultIsThere(run, run.keys[step]));
    outcome.done = outcome.reused = before;
    outcome.forecast_bytes = before ? 0 : peakOf(run, step);
    forecast.peak_bytes = std::max(forecast.peak_bytes, outcome.forecast_bytes);
    forecast.steps.push_back(outcome);
  }
  return forecast;
}

Result<ChainState> runChain(const StitchProject& project, const fs::path& folder, const ChainOptions& options, Progress& progress) {
  if (project.volumes.empty()) return failure(ErrorCode::emptyVolume, say<"The stitch project has no volumes; add some.">());
  std::optional<ResultFiles> resultFiles;
  if (options.until == Step::volume) {  // before anything is made, and before minutes of work
    auto seen = checkedResultFiles(project, folder, options, progress);
    if (!seen) return passOn(seen.error());
    resultFiles = std::move(*seen);
  }
  auto opened = StepStore::open(folder, stepFolders());
  if (!opened) return passOn(opened.error());
  const auto store = std::make_shared<StepStore>(std::move(*opened));
  ChainRun run(project, folder, options, *store);
  run.resultFiles = std::move(resultFiles);
  for (std::size_t n = 0; n < kSteps.size() && kSteps[n] <= options.until; ++n) {
    if (progress.cancelRequested()) return cancelledChain();
    PartOfProgress part(progress, kShares[n], kShares[n + 1]);
    const Clock clock;
    if (auto done = kBodies[n](run, part); !done) return passOn(done.error());
    if (run.result && !options.putInPlaceLater)
      if (auto put = putInPlace(*run.result, *store); !put) return passOn(put.error());
    StepOutcome& outcome = run.state.steps[n];
    outcome.done = true;
    outcome.seconds = clock.seconds();
    if (!outcome.reused) giveFreedMemoryBack();  // so that no step begins on top of the peak of the one before
    if (options.onStep) options.onStep(outcome);
  }
  if (run.result && options.putInPlaceLater) run.state.putInPlace = [store, result = *run.result] { return putInPlace(result, *store); };
  if (options.until == Step::volume) run.state.pruned_bytes = store->prune(options.keepBytes);
  if (options.keepVolumes) {
    for (std::size_t v = 0; v < run.inputs.size(); ++v) {
      auto view = run.inputs.load(v, progress);
      if (!view) return passOn(view.error());
      run.state.volumes.push_back((*view)->volume);
    }
  }
  run.state.notes = run.inputs.notes();
  return std::move(run.state);
}

}  // namespace ew::stitching
