#include "chain/chain_memory.h"

#include <algorithm>
#include <utility>

#include "chain/overlap.h"
#include "ew/core/depth_curves.h"
#include "ew/core/parallel.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/mapped_volume.h"
#include "ew/stitching/places.h"

namespace ew::stitching {
namespace {

/// A seventh more, for what is too small to be counted and what the allocator keeps within a step: measured, the six sweeps of
/// tests/stitching/six_subvolumes take up to 1.07 times what is counted.
std::uint64_t withMargin_bytes(std::uint64_t counted) { return counted + counted / 7; }

std::uint64_t ofReconstruct(const ChainRun& run) {
  std::uint64_t bytes = 0;
  for (std::size_t v = 0; v < run.inputs.size(); ++v) bytes = std::max(bytes, run.inputs[v].sweepBytes);
  return bytes;
}

std::uint64_t ofRigid(const ChainRun& run) {
  std::vector<std::uint64_t> each;
  for (const Candidate& pair : run.candidates)
    if (pair.decision != Decision::rejected)
      each.push_back(forecastPair_bytes(run.inputs[pair.fixed].grid, run.inputs[pair.moving].grid, pair.task));
  return besideEachOther_bytes(run, std::move(each)).bytes;
}

/// Differences of the cells that two views share, in a list that grows by doubling.
std::uint64_t ofEqualise(const ChainRun& run) {
  if (!run.settings.equalise) return 0;
  const double cell_mm = EqualiseViewsOptions{}.cell_mm;
  const auto all = run.placedGrids();
  std::uint64_t bytes = 0;
  for (std::size_t f = 0; f < all.size(); ++f)
    for (std::size_t m = f + 1; m < all.size(); ++m) {
      const VoxelBox shared = sharedBoxes(all[f].grid, all[m].grid, fixedToMovingOf(all[f].toWorld, all[m].toWorld), 0.0).first;
      const glm::dvec3 size = glm::dvec3(shared.size()) * all[f].grid.spacing_mm / cell_mm;
      bytes += static_cast<std::uint64_t>(1.5 * sizeof(DepthDifference) * size.x * size.y * size.z);
    }
  return bytes;
}

std::uint64_t ofElastic(const ChainRun& run) {
  if (!run.settings.elastic) return 0;
  std::vector<Grid> grids;
  std::vector<std::uint64_t> each;
  const auto all = run.placedGrids();
  for (const auto& one : all) grids.push_back(placed(one.grid, one.toWorld));
  const auto number = [&](std::size_t n) { return run.included.empty() ? n : run.included[n]; };
  for (std::size_t f = 0; f < grids.size(); ++f)
    for (std::size_t m = f + 1; m < grids.size(); ++m)
      if (boxesMeet(grids[f], grids[m], 0.0))
        each.push_back(
            warpBytes(all[f].grid, all[m].grid, fixedToMovingOf(all[f].toWorld, all[m].toWorld), run.elasticOptions(number(f), number(m))));
  return std::max(besideEachOther_bytes(run, std::move(each)).bytes,
                  forecastWarps_bytes(grids, grids.size() * (grids.size() - 1) / 2, run.warpOptions()));
}

std::uint64_t ofJoining(const ChainRun& run, bool resultInMemory) {
  JoinOptions unlimited = run.joinOptions();
  unlimited.grid.maxBytes = ~std::uint64_t{0};
  const auto forecast = forecastJoin(run.placedGrids(), unlimited);
  if (!forecast) return 0;  // the step itself says why
  const std::uint64_t voxels = forecast->grid.voxelCount();
  if (!resultInMemory) return forecast->bytes;
  // The level comes once all is joined.
  const std::uint64_t level = levelForecast_bytes(forecast->grid, {.threads = run.options.threads, .maxBytes = run.options.maxBytes});
  const bool isHeld = voxels <= run.options.streamAbove_voxels;
  const std::uint64_t mapped = 2 * std::min<std::uint64_t>(voxels, MapOptions{}.residentBudget_bytes);  // volume and coverage, read back
  return std::max(forecast->bytes + (isHeld ? 3 * voxels : 0), level + (isHeld ? 4 * voxels : mapped));
}

/// At the peak of a step, the inputs not counted.
std::uint64_t forecastOf(const ChainRun& run, Step step) {
  switch (step) {
    case Step::reconstruct:
      return ofReconstruct(run);
    case Step::rigid:
      return ofRigid(run);
    case Step::graph:
      return 0;
    case Step::equalise:
      return ofEqualise(run);
    case Step::elastic:
      return ofElastic(run);
    case Step::seam:
      return ofJoining(run, false);
    case Step::volume:
      return ofJoining(run, true);
  }
  return 0;
}

}  // namespace

Beside besideEachOther_bytes(const ChainRun& run, std::vector<std::uint64_t> each) {
  std::sort(each.rbegin(), each.rend());
  Beside beside;
  const auto threads = static_cast<std::size_t>(threadCount(run.options.threads));
  const std::uint64_t held = run.inputs.heldBytes();
  for (std::size_t n = 0; n < each.size() && n < threads; ++n) {
    if (n > 0 && withMargin_bytes(held + beside.bytes + each[n]) > run.options.maxBytes) break;
    beside.bytes += each[n];
    beside.pairs = static_cast<int>(n + 1);
  }
  return beside;
}

std::uint64_t warpBytes(const Grid& fixed, const Grid& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                        const registration::ElasticOptions& options) {
  const auto [in, there] = sharedBoxes(fixed, moving, fixedToMoving, kAroundOverlap_mm);
  if (in.size() == glm::ivec3(0)) return 0;
  const Grid own = gridOf(fixed, in), other = gridOf(moving, there);
  return registration::forecastElastic_bytes(own, other, options) + 6 * (own.voxelCount() + other.voxelCount());
}

std::uint64_t peakOf(const ChainRun& run, Step step) { return withMargin_bytes(run.inputs.heldBytes() + forecastOf(run, step)); }

Result<void> checkMemory(ChainRun& run, Step step) {
  StepOutcome& outcome = run.outcomeOf(step);
  outcome.forecast_bytes = peakOf(run, step);
  if (outcome.forecast_bytes <= run.options.maxBytes) return {};
  return failure(ErrorCode::tooLarge,
                 say<"The step %1 would need %2 MiB of memory, more than the %3 MiB allowed; use a coarser spacing_mm or fewer volumes at "
                     "a time.">(verbatim(nameOf(step)), outcome.forecast_bytes >> 20, run.options.maxBytes >> 20),
                 {{"step", nameOf(step)}, {"forecast_bytes", std::to_string(outcome.forecast_bytes)}});
}

}  // namespace ew::stitching
