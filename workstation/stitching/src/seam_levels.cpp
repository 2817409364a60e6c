#include "seam_levels.h"

#include <algorithm>
#include <cmath>

#include "cells.h"
#include "joiner.h"

namespace ew::stitching {
namespace {

constexpr float kLeast = 1e-3F;  // of a weight: a view at its border, where there is no other

/// The cells of a box in their order: take(cell of the box, cell of the whole).
template <class Take>
void forEachCell(const CellBox& box, const Grid& cells, const Take& take) {
  std::size_t own = 0;
  for (int k = box.begin.z; k < box.end.z; ++k)
    for (int j = box.begin.y; j < box.end.y; ++j) {
      std::size_t cell = cells.indexOf(box.begin.x, j, k);
      for (int i = box.begin.x; i < box.end.x; ++i) take(own++, cell++);
    }
}

}  // namespace

Result<void> levelSeams(std::span<const ViewSurvey> surveys, const SeamOptions& options, SeamMap& map, Progress& progress) {
  map.levels.assign(surveys.size(), {});
  const double reach_mm = options.levelBlend_mm;
  const glm::dvec3 reach_cells = glm::max(reach_mm / map.cells.spacing_mm - 0.5, glm::dvec3(0.0));
  const auto all = static_cast<double>(surveys.size());
  // How far inside its border each view is, and the one that is shown: 0 where the blend with its neighbours may be, 255 from reach_mm on.
  std::vector<std::vector<std::uint8_t>> inside(surveys.size());
  std::vector<std::uint8_t> shownInside(map.view.size(), 0), shownTrust(map.view.size(), 0);
  for (std::size_t v = 0; v < surveys.size(); ++v) {
    if (surveys[v].box.count() == 0) continue;
    PartOfProgress part(progress, 0.5 * static_cast<double>(v) / all, 0.5 * static_cast<double>(v + 1) / all);
    auto distance = surveys[v].distanceFromBorder_mm(map.cells, options.blend_mm + reach_mm, options.threads, part);
    if (!distance) return passOn(distance.error());
    inside[v].resize(distance->size());
    forEachCell(surveys[v].box, map.cells, [&](std::size_t own, std::size_t cell) {
      const double within_mm = static_cast<double>((*distance)[own]) - options.blend_mm;
      inside[v][own] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(within_mm / reach_mm, 0.0, 1.0)));
      if (map.view[cell] != v + 1) return;
      shownInside[cell] = inside[v][own];
      shownTrust[cell] = surveys[v].trust[own];
    });
  }
  std::vector<float> weight(map.view.size(), 0.0F), level(map.view.size(), 0.0F), around, scratch;
  std::vector<std::vector<std::uint8_t>> near(surveys.size());
  for (std::size_t v = 0; v < surveys.size(); ++v) {
    if (progress.cancelRequested()) return stitchingCancelled();
    const ViewSurvey& survey = surveys[v];
    around.assign(survey.box.count(), 0.0F);
    forEachCell(survey.box, map.cells, [&](std::size_t own, std::size_t cell) { around[own] = map.view[cell] == v + 1 ? 1.0F : 0.0F; });
    boxSum(around, survey.box, reach_cells, scratch);
    near[v].assign(around.size(), 0);
    forEachCell(survey.box, map.cells, [&](std::size_t own, std::size_t cell) {
      if (around[own] <= 0.0F || !survey.covers(own)) return;
      near[v][own] = 1;
      const float ends = std::max(0.0F, 1.0F - 2.0F * static_cast<float>(shownInside[cell]) / 255.0F);
      // A third of the trust of the view that is shown is next to none: the darkness of a shadow must not creep back into what fills it.
      const float trust = static_cast<float>(survey.trust[own]) / std::max(1.0F, static_cast<float>(shownTrust[cell]));
      const float believed = map.view[cell] == v + 1 ? 1.0F : std::max(std::min(1.0F, trust * trust * trust), ends);
      const float w = around[own] * std::max(kLeast, static_cast<float>(inside[v][own]) / 255.0F) * std::max(kLeast, believed);
      weight[cell] += w;
      level[cell] += w * static_cast<float>(survey.level[own] * ViewSurvey::kLevelUnit);
    });
  }
  for (std::size_t v = 0; v < surveys.size(); ++v) {
    if (progress.cancelRequested()) return stitchingCancelled();
    const ViewSurvey& survey = surveys[v];
    SeamMap::Levels& levels = map.levels[v];
    levels.begin = survey.box.begin;
    levels.size = survey.box.size();
    levels.offset.assign(survey.box.count(), 0);
    forEachCell(survey.box, map.cells, [&](std::size_t own, std::size_t cell) {
      if (near[v][own] == 0 || weight[cell] <= 0.0F) return;
      const double offset =
          static_cast<double>(level[cell]) / static_cast<double>(weight[cell]) - survey.level[own] * ViewSurvey::kLevelUnit;
      levels.offset[own] = static_cast<std::int16_t>(std::lround(offset / SeamMap::kOffsetUnit));
    });
    // Voxels at the border lie between cells of which one is not covered: that has the mean of its neighbours.
    const CellBox& box = survey.box;
    for (int k = box.begin.z; k < box.end.z; ++k)
      for (int j = box.begin.y; j < box.end.y; ++j)
        for (int i = box.begin.x; i < box.end.x; ++i) {
          const std::size_t own = box.indexOf(i, j, k);
          if (near[v][own] != 0) continue;
          int sum = 0, count = 0;
          for (int side = 0; side < 27; ++side) {
            const glm::ivec3 at(i + side % 3 - 1, j + side / 3 % 3 - 1, k + side / 9 - 1);
            if (!box.contains(at.x, at.y, at.z)) continue;
            const std::size_t beside = box.indexOf(at.x, at.y, at.z);
            if (near[v][beside] == 0) continue;
            sum += levels.offset[beside];
            ++count;
          }
          if (count > 0) levels.offset[own] = static_cast<std::int16_t>(sum / count);
        }
  }
  return {};
}

}  // namespace ew::stitching
