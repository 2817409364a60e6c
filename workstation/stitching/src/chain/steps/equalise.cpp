#include "chain/chain_json.h"
#include "chain/chain_memory.h"
#include "chain/steps/steps.h"
#include "ew/core/message_json.h"

namespace ew::stitching {

using nlohmann::json;
using nlohmann::ordered_json;

Result<void> equaliseStep(ChainRun& run, Progress& progress) {
  if (auto fits = checkMemory(run, Step::equalise); !fits) return fits;
  const std::string& key = run.keys[Step::equalise];
  auto& corrections = run.state.corrections;
  corrections.assign(run.inputs.size(), {});
  auto found = readBack<std::vector<GreyCorrection>>(run.store.find(nameOf(Step::equalise), key), [](const json& data) {
    std::vector<GreyCorrection> read;
    for (const auto& each : data.at("corrections")) read.push_back(correctionFrom(each));
    return read;
  });
  if (found && found->size() != run.inputs.size()) found.reset();
  run.outcomeOf(Step::equalise).reused = found.has_value();
  if (found) {
    corrections = std::move(*found);
    return {};
  }
  ordered_json data = {{"corrections", ordered_json::array()}};
  if (run.settings.equalise && run.included.size() > 1) {
    auto views = run.views(progress);
    if (!views) return passOn(views.error());
    EqualiseViewsOptions options;
    options.threads = run.options.threads;
    auto equalised = equaliseViews(*views, options, progress);
    if (!equalised) return passOn(equalised.error());
    for (std::size_t n = 0; n < run.included.size(); ++n) corrections[run.included[n]] = equalised->corrections[n];
    data["groups"] = equalised->groups;
    data["disagreement_before_db"] = equalised->disagreementBefore_db;
    data["disagreement_after_db"] = equalised->disagreementAfter_db;
    data["notes"] = equalised->notes;
  }
  for (const auto& correction : corrections) data["corrections"].push_back(jsonOf(correction));
  return run.store.keep(nameOf(Step::equalise), key, std::move(data));
}

}  // namespace ew::stitching
