#include "chain/chain_memory.h"
#include "chain/steps/steps.h"

namespace ew::stitching {

Result<void> reconstructStep(ChainRun& run, Progress& progress) {
  if (auto known = run.inputs.identify(progress, false); !known) return known;
  run.inputs.rememberContents();
  const std::size_t count = run.inputs.size();
  for (std::size_t v = 0; v < count; ++v) {
    if (!run.inputs.isToBeMade(v)) continue;
    PartOfProgress part(progress, static_cast<double>(v) / static_cast<double>(count),
                        static_cast<double>(v + 1) / static_cast<double>(count));
    if (auto planned = run.inputs.plan(v, part); !planned) return planned;
    if (auto fits = checkMemory(run, Step::reconstruct); !fits) return fits;
    if (auto made = run.inputs.make(v, part); !made) return made;
  }
  if (auto fits = checkMemory(run, Step::reconstruct); !fits) return fits;
  run.candidates = candidatesOf(run.project, run.inputs);
  run.keys = keysOf(run.project, run.options, run.inputs, run.candidates);
  StepOutcome& outcome = run.outcomeOf(Step::reconstruct);
  outcome.reused = run.store.find(nameOf(Step::reconstruct), run.keys[Step::reconstruct]).has_value();
  if (outcome.reused) return {};
  for (std::size_t v = 0; v < count; ++v)  // coverage of another grid and the like are said now, not after an hour
    if (auto view = run.inputs.load(v, progress); !view) return passOn(view.error());
  return run.store.keep(nameOf(Step::reconstruct), run.keys[Step::reconstruct], {{"inputs", count}});
}

}  // namespace ew::stitching
