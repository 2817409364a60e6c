#include "ew/stitching/equalise_views.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cells.h"
#include "ew/core/depth_curves.h"
#include "ew/core/parallel.h"
#include "joiner.h"
#include "seam_measure.h"

namespace ew::stitching {
namespace {

constexpr int kLooksPerSide = 4;       // a cell is looked at in so many places along each axis
constexpr double kFewestLooks = 24.0;  // of 64
constexpr double kClippedShare = 0.02;
constexpr double kTrustedShare = 0.5;

/// What a view shows in a cube of the world.
struct Cell {
  float looks = 0.0F;
  float clipped = 0.0F;
  float grey = 0.0F;
  float depth_mm = 0.0F;
};
struct Seen {
  CellBox box;
  std::vector<Cell> cells;
};

/// The world in steps of a quarter of a cell, around all views.
Result<Grid> worldOf(std::span<const View> views, double step_mm) {
  std::vector<GridPlacement> grids;
  for (const View& view : views) grids.push_back({view.volume->grid, view.toWorld, view.name});
  StitchOptions how;
  how.spacing_mm = step_mm;
  how.axes = GridAxes::world;
  how.featherWidth_mm = 0.0;
  how.maxBytes = UINT64_MAX;
  auto forecast = forecastStitch(grids, how);
  if (!forecast) return passOn(forecast.error());
  return forecast->grid;
}

Result<Seen> look(const View& view, const Grid& world, int threads, Progress& progress) {
  View raw = view;  // what is compared has no correction yet
  raw.correction.grey.clear();
  const ViewSampler sampler(raw, world, 1.0);
  const auto [lowest, highest] = sampler.reach();
  Seen seen;
  seen.box.begin = glm::clamp(lowest, glm::ivec3(0), world.dims) / kLooksPerSide;
  seen.box.end = (glm::clamp(highest + 1, glm::ivec3(0), world.dims) + kLooksPerSide - 1) / kLooksPerSide;
  seen.box.end = glm::max(seen.box.end, seen.box.begin);
  seen.cells.resize(seen.box.count());
  const auto voxelToOwn = view.volume->grid.voxelToWorld();
  const std::optional<Beams>& beams = view.correction.beams;
  const bool whole = forEachTask(seen.box.size().z, threads, progress, say<"Comparing views">(), [&](int slice, int, const auto& stopped) {
    const int ck = seen.box.begin.z + slice;
    for (int k = ck * kLooksPerSide; k < (ck + 1) * kLooksPerSide && !stopped(); ++k)
      for (int j = seen.box.begin.y * kLooksPerSide; j < seen.box.end.y * kLooksPerSide; ++j)
        sampler.alongRow(j, k, seen.box.begin.x * kLooksPerSide, seen.box.end.x * kLooksPerSide, [&](int i, const glm::dvec3& where) {
          const ViewSample sample = sampler.nearestTo(where);
          if (sample.quality <= 0.0 || sample.confidence < kTrustedShare) return;
          Cell& cell = seen.cells[seen.box.indexOf(i / kLooksPerSide, j / kLooksPerSide, ck)];
          cell.looks += 1.0F;
          cell.clipped += sample.level <= 0.0 || sample.level >= 255.0 ? 1.0F : 0.0F;
          cell.grey += static_cast<float>(sample.level);
          if (beams) cell.depth_mm += static_cast<float>(beams->depth_mm((voxelToOwn * Point<frame::Voxel>{where}).at));
        });
  });
  if (!whole || progress.cancelRequested()) return stitchingCancelled();
  for (Cell& cell : seen.cells) {
    if (static_cast<double>(cell.looks) < kFewestLooks ||
        static_cast<double>(cell.clipped) > kClippedShare * static_cast<double>(cell.looks)) {
      cell.looks = 0.0F;
      continue;
    }
    cell.grey /= cell.looks;
    cell.depth_mm /= cell.looks;
  }
  return seen;
}

std::vector<DepthDifference> differencesOf(const Seen& a, const Seen& b, std::size_t first, std::size_t second) {
  std::vector<DepthDifference> found;
  const glm::ivec3 begin = glm::max(a.box.begin, b.box.begin);
  const glm::ivec3 end = glm::min(a.box.end, b.box.end);
  for (int k = begin.z; k < end.z; ++k)
    for (int j = begin.y; j < end.y; ++j)
      for (int i = begin.x; i < end.x; ++i) {
        const Cell& one = a.cells[a.box.indexOf(i, j, k)];
        const Cell& other = b.cells[b.box.indexOf(i, j, k)];
        if (one.looks <= 0.0F || other.looks <= 0.0F) continue;
        found.push_back({first, second, static_cast<double>(one.depth_mm), static_cast<double>(other.depth_mm),
                         static_cast<double>(one.grey - other.grey), std::sqrt(static_cast<double>(std::min(one.looks, other.looks)))});
      }
  return found;
}

/// Names the groups of views that hang together, and gives each view its group.
std::vector<int> groupsOf(const std::vector<DepthDifference>& pairs, std::size_t views, int& groups) {
  std::vector<int> group(views);
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&](int n) {
    while (group[static_cast<std::size_t>(n)] != n) n = group[static_cast<std::size_t>(n)];
    return n;
  };
  for (const DepthDifference& pair : pairs) {
    const int a = root(static_cast<int>(pair.first));
    const int b = root(static_cast<int>(pair.second));
    group[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  std::vector<int> numbered(views, -1);
  groups = 0;
  for (std::size_t n = 0; n < views; ++n) {
    const auto own = static_cast<std::size_t>(root(static_cast<int>(n)));
    if (own == n) numbered[n] = groups++;
    numbered[n] = numbered[own];
  }
  return numbered;
}

}  // namespace

Result<ViewEqualisation> equaliseViews(std::span<const View> views, const EqualiseViewsOptions& options, Progress& progress) {
  if (auto good = checkViews(views); !good) return passOn(good.error());
  const bool sound = options.cell_mm > 0.0 && options.cell_mm < 1e3 && options.knot_mm > 0.5 && options.knot_mm < 1e3 &&
                     options.smoothness >= 0.0 && options.smoothness < 1e3 && options.common >= 0.0 && options.common < 1e6 &&
                     options.fewestCells >= 1;
  if (!sound)
    return failure(ErrorCode::badField, say<"The options of the equalisation are out of range; use cells and knots above 0.">(),
                   {{"field", "equalise"}});
  const auto world = worldOf(views, options.cell_mm / kLooksPerSide);
  if (!world) return passOn(world.error());
  std::vector<Seen> seen;
  std::vector<double> shallowest_mm(views.size(), 0.0);
  for (const View& view : views) {
    const auto n = static_cast<double>(seen.size());
    const auto all = static_cast<double>(views.size());
    PartOfProgress part(progress, 0.8 * n / all, 0.8 * (n + 1.0) / all);
    auto one = look(view, *world, options.threads, part);
    if (!one) return passOn(one.error());
    seen.push_back(std::move(*one));
  }

  ViewEqualisation result;
  std::vector<DepthDifference> pairs;
  for (std::size_t a = 0; a < views.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (progress.cancelRequested()) return stitchingCancelled();
      const auto found = differencesOf(seen[a], seen[b], a, b);
      if (found.size() >= static_cast<std::size_t>(options.fewestCells)) pairs.insert(pairs.end(), found.begin(), found.end());
    }
  // Each curve begins where its view was first compared.
  std::vector<bool> compared(views.size(), false);
  for (const DepthDifference& pair : pairs)
    for (const auto& [view, depth_mm] : {std::pair{pair.first, pair.firstDepth_mm}, std::pair{pair.second, pair.secondDepth_mm}}) {
      shallowest_mm[view] = compared[view] ? std::min(shallowest_mm[view], depth_mm) : depth_mm;
      compared[view] = true;
    }
  for (DepthDifference& pair : pairs) {
    pair.firstDepth_mm -= shallowest_mm[pair.first];
    pair.secondDepth_mm -= shallowest_mm[pair.second];
  }
  DepthCurves curves;
  if (!fitDepthCurves(pairs, views.size(), {options.knot_mm, options.smoothness, options.common}, progress, curves))
    return stitchingCancelled();
  result.disagreementBefore_db = curves.medianBefore * kDbPerGrey;
  result.disagreementAfter_db = curves.medianAfter * kDbPerGrey;
  for (std::size_t n = 0; n < views.size(); ++n) {
    GreyCorrection correction;
    correction.beams = views[n].correction.beams;
    correction.firstKnot_mm = shallowest_mm[n];
    correction.knot_mm = options.knot_mm;
    if (compared[n]) correction.grey = std::move(curves.grey[n]);
    result.corrections.push_back(std::move(correction));
  }
  const std::vector<int> groups = groupsOf(pairs, views.size(), result.groups);
  for (int group = 0; group < result.groups && result.groups > 1; ++group) {
    std::vector<Message> names;
    for (std::size_t n = 0; n < views.size(); ++n)
      if (groups[n] == group) names.push_back(verbatim(views[n].name));
    result.notes.push_back(say<"Part %1 of %2, which overlaps no other: %3.">(group + 1, result.groups, joined(std::move(names), ", ")));
  }
  return result;
}

}  // namespace ew::stitching
