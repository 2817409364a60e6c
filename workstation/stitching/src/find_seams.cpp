#include <algorithm>
#include <cmath>

#include "cells.h"
#include "ew/core/parallel.h"
#include "ew/stitching/distance.h"
#include "joiner.h"
#include "seam_cut.h"
#include "seam_levels.h"

namespace ew::stitching {
namespace {

constexpr double kFar_mm = 1e4;

/// Where a hand painted, the view that was asked for, if it covers the cell. The last stroke wins, as paint does.
void paint(const Grid& cells, std::span<const SeamStroke> strokes, std::span<const ViewSurvey> surveys, std::vector<std::uint8_t>& forced) {
  if (strokes.empty()) return;
  forced.assign(cells.voxelCount(), 0);
  const auto worldToCell = cells.worldToVoxel();
  for (const SeamStroke& stroke : strokes) {
    const ViewSurvey& survey = surveys[stroke.view];
    const glm::dvec3 centre = (worldToCell * Point<frame::World>{stroke.at_mm}).at;
    // Oblique axes: a ball reaches farther along them than its radius.
    glm::dvec3 reach(0.0);
    for (int axis = 0; axis < 3; ++axis)
      reach[axis] =
          stroke.radius_mm * glm::length(glm::dvec3(worldToCell.matrix[0][axis], worldToCell.matrix[1][axis], worldToCell.matrix[2][axis]));
    const glm::dvec3 low = glm::max(glm::dvec3(survey.box.begin), glm::ceil(centre - reach));
    const glm::dvec3 high = glm::min(glm::dvec3(survey.box.end - 1), glm::floor(centre + reach));
    for (int k = static_cast<int>(low.z); k <= high.z; ++k)
      for (int j = static_cast<int>(low.y); j <= high.y; ++j)
        for (int i = static_cast<int>(low.x); i <= high.x; ++i) {
          const glm::dvec3 p_mm = (cells.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at;
          if (glm::distance(p_mm, stroke.at_mm) <= stroke.radius_mm && survey.covers(survey.box.indexOf(i, j, k)))
            forced[cells.indexOf(i, j, k)] = static_cast<std::uint8_t>(stroke.view + 1);
        }
  }
}

/// Each cell to the view in whose inside it lies deepest; of equals to the first.
Result<void> nearest(std::span<const ViewSurvey> surveys, std::span<const std::uint8_t> forced, const SeamOptions& options, SeamMap& map,
                     Progress& progress) {
  std::vector<float> deepest(map.view.size(), 0.0F);
  for (std::size_t n = 0; n < surveys.size(); ++n) {
    const ViewSurvey& survey = surveys[n];
    if (survey.box.count() == 0) continue;
    PartOfProgress part(progress, static_cast<double>(n) / static_cast<double>(surveys.size()),
                        static_cast<double>(n + 1) / static_cast<double>(surveys.size()));
    auto distance = survey.distanceFromBorder_mm(map.cells, kFar_mm, options.threads, part);
    if (!distance) return passOn(distance.error());
    std::size_t from = 0;
    for (int k = survey.box.begin.z; k < survey.box.end.z; ++k)
      for (int j = survey.box.begin.y; j < survey.box.end.y; ++j) {
        std::size_t to = map.cells.indexOf(survey.box.begin.x, j, k);
        for (int i = survey.box.begin.x; i < survey.box.end.x; ++i, ++from, ++to) {
          if (!survey.covers(from)) continue;
          // Cells that a view covers only in part are its border; they are kept for want of better.
          const float depth = std::max((*distance)[from], 1e-3F * static_cast<float>(survey.share[from]));
          if (depth > deepest[to]) {
            deepest[to] = depth;
            map.view[to] = static_cast<std::uint8_t>(n + 1);
          }
        }
      }
  }
  for (std::size_t c = 0; c < forced.size(); ++c)
    if (forced[c] != 0) map.view[c] = forced[c];
  return {};
}

/// How much the views differ where one passes to the other: for the report, and to compare methods.
void weighSeam(std::span<const ViewSurvey> surveys, SeamMap& map) {
  const Grid& cells = map.cells;
  double sum = 0.0;
  std::size_t judged = 0;
  const auto differenceAt = [&](int i, int j, int k, std::uint8_t a, std::uint8_t b) {
    const auto one = surveys[a - 1u].levelAt(i, j, k);
    const auto other = surveys[b - 1u].levelAt(i, j, k);
    if (!one || !other) return;
    sum += std::abs(*one - *other);
    ++judged;
  };
  for (int k = 0; k < cells.dims.z; ++k)
    for (int j = 0; j < cells.dims.y; ++j)
      for (int i = 0; i < cells.dims.x; ++i) {
        const std::uint8_t own = map.view[cells.indexOf(i, j, k)];
        if (own == 0) continue;
        for (int axis = 0; axis < 3; ++axis) {
          glm::ivec3 next(i, j, k);
          if (++next[axis] >= cells.dims[axis]) continue;
          const std::uint8_t other = map.view[cells.indexOf(next.x, next.y, next.z)];
          if (other == 0 || other == own) continue;
          ++map.seamFaces;
          differenceAt(i, j, k, own, other);
          differenceAt(next.x, next.y, next.z, own, other);
        }
      }
  if (judged > 0) map.cutCost = sum / static_cast<double>(judged);
}

}  // namespace

Result<SeamMap> findSeams(std::span<const View> views, const Grid& result, const SeamOptions& options, Progress& progress) {
  if (auto good = checkViews(views); !good) return passOn(good.error());
  if (auto good = checkGrid(result); !good) return passOn(good.error());
  if (auto good = checkSeamOptions(options, views.size()); !good) return passOn(good.error());
  SeamMap map;
  const glm::ivec3 ratio = cellRatio(result, options.cell_mm);
  map.cells = cellGrid(result, ratio);
  if (options.method == SeamMethod::feather) {
    map.cells.dims = glm::ivec3(0);  // there is no seam
    return map;
  }
  map.view.assign(map.cells.voxelCount(), 0);
  PartOfProgress looking(progress, 0.0, 0.4);
  auto surveys = surveyViews(views, result, ratio, options, looking);
  if (!surveys) return passOn(surveys.error());

  std::vector<std::uint8_t> forced;
  paint(map.cells, options.strokes, *surveys, forced);
  PartOfProgress choosing(progress, 0.4, 0.9);
  const auto chosen = options.method == SeamMethod::nearest ? nearest(*surveys, forced, options, map, choosing)
                                                            : cutSeams(*surveys, forced, options, map, choosing);
  if (!chosen) return passOn(chosen.error());
  weighSeam(*surveys, map);
  if (options.method == SeamMethod::graphCut && options.blend_mm > 0.0 && options.levelBlend_mm > 0.0 && views.size() > 1) {
    PartOfProgress levelling(progress, 0.9, 1.0);
    if (auto levelled = levelSeams(*surveys, options, map, levelling); !levelled) return passOn(levelled.error());
  }
  return map;
}

}  // namespace ew::stitching
