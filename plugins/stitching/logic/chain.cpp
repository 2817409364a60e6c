#include "logic/chain.h"

#include "logic/output.h"

namespace ew::stitching {

const char* nameOf(Step step) {
  switch (step) {
    case Step::reconstruct:
      return "reconstruct";
    case Step::equalise:
      return "equalise";
    case Step::rigid:
      return "rigid";
    case Step::graph:
      return "graph";
    case Step::elastic:
      return "elastic";
    case Step::seam:
      return "seam";
    case Step::volume:
      return "volume";
  }
  return "volume";
}

Result<ChainForecast> forecastChain(const StitchProject&, const std::filesystem::path&, const ChainOptions&, sdk::Volumes&, sdk::Files&) {
  ChainForecast forecast;
  for (const Step step : kSteps) forecast.steps.push_back({.step = step});
  return forecast;
}

Result<ChainState> runChain(const StitchProject& project, const std::filesystem::path& folder, const ChainOptions& options,
                            sdk::Volumes& volumes, sdk::Files& files, Progress& progress) {
  ChainState state;
  for (const Step step : kSteps) state.steps.push_back({.step = step});
  StitchOptions how = project.settings.join.grid;
  how.threads = options.threads;
  how.maxBytes = options.maxBytes;
  PartOfProgress reading(progress, 0.0, 0.3);
  auto inputs = readVolumes(project, volumes, reading);
  if (!inputs) return passOn(inputs.error());
  PartOfProgress blending(progress, 0.3, 0.8);
  auto result = stitch(*inputs, how, blending);
  if (!result) return passOn(result.error());
  PartOfProgress writing(progress, 0.8, 1.0);
  auto written = writeStitch(*result, project, folder, volumes, files, writing);
  if (!written) return passOn(written.error());
  for (auto& input : *inputs) state.volumes.push_back(std::make_shared<const Volume>(std::move(input.volume)));
  state.report = JoinReport{.grid = result->volume.grid,
                            .contributions = result->contributions,
                            .seam = {},
                            .overlapShare = result->overlapShare,
                            .disagreementRms = result->disagreementRms,
                            .notes = result->notes,
                            .seconds = result->seconds};
  state.volume = written->volume;
  state.coverage = written->coverage;
  state.source = written->source;
  state.provenance = written->provenance;
  for (const Step step : {Step::reconstruct, Step::volume}) state.steps[static_cast<std::size_t>(step)].done = true;
  return state;
}

}  // namespace ew::stitching
