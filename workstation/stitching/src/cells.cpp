#include "cells.h"

#include <algorithm>
#include <cmath>

namespace ew::stitching {

glm::ivec3 cellRatio(const Grid& result, double cell_mm) {
  glm::ivec3 ratio{1};
  for (int axis = 0; axis < 3; ++axis)
    ratio[axis] = static_cast<int>(std::clamp(std::round(cell_mm / result.spacing_mm[axis]), 1.0, 1000.0));
  return ratio;
}

Grid cellGrid(const Grid& result, const glm::ivec3& ratio) {
  Grid cells = result;
  cells.dims = (result.dims + ratio - 1) / ratio;
  cells.spacing_mm = result.spacing_mm * glm::dvec3(ratio);
  cells.origin_mm = (result.voxelToWorld() * Point<frame::Voxel>{0.5 * glm::dvec3(ratio - 1)}).at;
  return cells;
}

std::optional<glm::ivec3> ratioOf(const Grid& cells, const Grid& result) {
  glm::ivec3 ratio{1};
  for (int axis = 0; axis < 3; ++axis) {
    const double times = cells.spacing_mm[axis] / result.spacing_mm[axis];
    if (!(times > 0.5 && times < 1e4)) return std::nullopt;
    ratio[axis] = static_cast<int>(std::round(times));
  }
  const Grid expected = cellGrid(result, ratio);
  const double tolerance_mm = 1e-3 * glm::length(result.spacing_mm);
  if (cells.dims != expected.dims || glm::length(cells.origin_mm - expected.origin_mm) > tolerance_mm) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis) {
    const double farEnd_mm = tolerance_mm / std::max(1.0, cells.spacing_mm[axis] * cells.dims[axis]);
    if (std::abs(cells.spacing_mm[axis] - expected.spacing_mm[axis]) * cells.dims[axis] > tolerance_mm) return std::nullopt;
    if (glm::length(cells.directions[axis] - expected.directions[axis]) > farEnd_mm) return std::nullopt;
  }
  return ratio;
}

void lookAlongCells(const ViewSampler& view, const glm::ivec3& ratio, int j, int k, int begin, int end, CellLook* looks) {
  std::fill(looks, looks + (end - begin), CellLook{});
  const auto places = [](int r) { return std::pair{r / 4, r - 1 - r / 4}; };
  const auto [x0, x1] = places(ratio.x);
  const auto [y0, y1] = places(ratio.y);
  const auto [z0, z1] = places(ratio.z);
  for (int z = z0;; z = z1) {
    for (int y = y0;; y = y1) {
      view.alongRow(j * ratio.y + y, k * ratio.z + z, begin * ratio.x, end * ratio.x, [&, x0 = x0, x1 = x1](int i, const glm::dvec3& at) {
        const int within = i % ratio.x;
        if (within != x0 && within != x1) return;
        const ViewSample sample = view.nearestTo(at);
        if (sample.quality <= 0.0) return;
        CellLook& look = looks[i / ratio.x - begin];
        look.share += 1.0F;
        look.level += static_cast<float>(sample.level);
        look.trust += static_cast<float>(sample.confidence * (sample.measured ? 1.0 : 0.75));
      });
      if (y == y1) break;
    }
    if (z == z1) break;
  }
  const auto all = static_cast<float>((x0 == x1 ? 1 : 2) * (y0 == y1 ? 1 : 2) * (z0 == z1 ? 1 : 2));
  for (CellLook* look = looks; look != looks + (end - begin); ++look) {
    if (look->share <= 0.0F) continue;
    look->level /= look->share;
    look->share /= all;
    look->trust /= all;
  }
}

void boxSum(std::vector<float>& values, const CellBox& box, const glm::dvec3& reach_cells, std::vector<float>& scratch) {
  const glm::ivec3 size = box.size();
  const std::ptrdiff_t strides[3] = {1, size.x, static_cast<std::ptrdiff_t>(size.x) * size.y};
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = reach_cells[axis];
    const int taps = static_cast<int>(std::ceil(std::max(0.0, reach - 0.5)));
    if (taps == 0) continue;
    const auto last = static_cast<float>(reach + 0.5 - taps);  // how much of the outermost cell the box covers
    const int length = size[axis];
    const std::ptrdiff_t stride = strides[axis];
    scratch.resize(static_cast<std::size_t>(length));
    const int a = axis == 0 ? 1 : 0;
    const int b = axis == 2 ? 1 : 2;
    for (int v = 0; v < size[b]; ++v)
      for (int u = 0; u < size[a]; ++u) {
        float* line = values.data() + u * strides[a] + v * strides[b];
        for (int n = 0; n < length; ++n) {
          float sum = 0.0F;
          for (int t = -taps; t <= taps; ++t) {
            if (n + t < 0 || n + t >= length) continue;
            sum += (t == -taps || t == taps ? last : 1.0F) * line[(n + t) * stride];
          }
          scratch[static_cast<std::size_t>(n)] = sum;
        }
        for (int n = 0; n < length; ++n) line[n * stride] = scratch[static_cast<std::size_t>(n)];
      }
  }
}

}  // namespace ew::stitching
