#include "chain/chain_run.h"

#include <algorithm>

#include "ew/core/parallel.h"
#include "ew/stitching/places.h"

namespace ew::stitching {

ChainRun::ChainRun(const StitchProject& asked, const std::filesystem::path& into, const ChainOptions& how, StepStore& stepStore)
    : project(asked), settings(asked.settings), folder(into), options(how), store(stepStore), inputs(asked, how, stepStore) {
  for (const Step step : kSteps) state.steps.push_back({.step = step});
}

Transform<frame::Moving, frame::Fixed> ChainRun::startOf(std::size_t fixed, std::size_t moving) const {
  return fixedToMovingOf(poseOf(fixed), poseOf(moving));
}

Result<std::vector<View>> ChainRun::views(Progress& progress) {
  std::vector<View> views;
  for (const std::size_t v : included) {
    auto loaded = inputs.load(v, progress);
    if (!loaded) return passOn(loaded.error());
    View view;
    view.volume = (*loaded)->volume.get();
    view.confidence = (*loaded)->confidence;
    view.toWorld = poseOf(v);
    if (v < state.warps.size() && !state.warps[v].displacement_mm.empty()) view.warp = &state.warps[v];
    if (v < state.corrections.size()) view.correction = state.corrections[v];
    view.correction.beams = (*loaded)->beams;
    view.name = (*loaded)->name;
    views.push_back(std::move(view));
  }
  return views;
}

std::vector<GridPlacement> ChainRun::placedGrids() const {
  std::vector<GridPlacement> grids;
  for (const std::size_t v : included) grids.push_back({inputs[v].grid, poseOf(v), project.volumes[v].name});
  if (included.empty())
    for (std::size_t v = 0; v < inputs.size(); ++v) grids.push_back({inputs[v].grid, project.volumes[v].toWorld, project.volumes[v].name});
  return grids;
}

Result<Grid> ChainRun::resultGrid() const {
  auto forecast = forecastJoin(placedGrids(), joinOptions());
  if (!forecast) return passOn(forecast.error());
  return forecast->grid;
}

JoinOptions ChainRun::joinOptions() const {
  JoinOptions join = settings.join;
  join.grid.threads = join.seam.threads = options.threads;
  join.grid.maxBytes = options.maxBytes;
  std::vector<SeamStroke> strokes;
  for (SeamStroke stroke : join.seam.strokes) {
    const auto at = std::find(included.begin(), included.end(), stroke.view);
    if (at == included.end()) continue;
    stroke.view = static_cast<std::size_t>(at - included.begin());
    strokes.push_back(stroke);
  }
  join.seam.strokes = std::move(strokes);
  return join;
}

registration::ElasticOptions ChainRun::elasticOptions(std::size_t fixed, std::size_t moving) const {
  registration::ElasticOptions elastic;
  elastic.effort = effortOf(project, fixed, moving);
  elastic.threads = options.threads;
  return elastic;
}

registration::OnLevel ChainRun::levelsOf(std::size_t fixed, std::size_t moving) {
  if (!options.onLevel) return {};
  return [this, fixed, moving](const registration::Level& level) {
    const std::lock_guard lock(onLevelGuard_);
    options.onLevel(fixed, moving, level);
  };
}

int ChainRun::threadsOfEach(int atOnce) const { return std::max(1, threadCount(options.threads) / atOnce); }

tl::unexpected<Error> cancelledChain() {
  return failure(ErrorCode::cancelled, say<"The stitching was cancelled; what was finished is kept.">());
}

}  // namespace ew::stitching
