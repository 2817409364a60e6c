#include "ew/stitching/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/core/contract.h"
#include "ew/core/parallel.h"

namespace ew::stitching {
namespace {

/// Scratch of one line: the parabolas of the lower envelope.
struct Envelope {
  std::vector<double> height;  ///< squared distance so far, with one absent sample before and after the line
  std::vector<int> vertex;
  std::vector<double> begin;

  explicit Envelope(int length) : height(static_cast<std::size_t>(length) + 2), vertex(height.size()), begin(height.size() + 1) {}
};

/// Replaces the squared distances of one line by min over q of (p - q)^2 step^2 + line[q], including the absent ends.
void transformLine(float* line, std::ptrdiff_t stride, int length, double step_mm, double limit2, Envelope& scratch) {
  const int n = length + 2;
  const double step2 = step_mm * step_mm;
  scratch.height.front() = 0.0;
  scratch.height[static_cast<std::size_t>(n - 1)] = 0.0;
  for (int i = 0; i < length; ++i) scratch.height[static_cast<std::size_t>(i + 1)] = static_cast<double>(line[i * stride]);

  const auto f = [&](int q) { return scratch.height[static_cast<std::size_t>(q)]; };
  int last = 0;
  scratch.vertex[0] = 0;
  scratch.begin[0] = -std::numeric_limits<double>::infinity();
  scratch.begin[1] = std::numeric_limits<double>::infinity();
  for (int q = 1; q < n; ++q) {
    if (f(q) >= limit2) continue;  // a parabola this high changes nothing below the limit
    const auto meets = [&](int v) { return ((f(q) + step2 * q * q) - (f(v) + step2 * v * v)) / (2.0 * step2 * (q - v)); };
    double at = meets(scratch.vertex[static_cast<std::size_t>(last)]);
    while (at <= scratch.begin[static_cast<std::size_t>(last)]) at = meets(scratch.vertex[static_cast<std::size_t>(--last)]);
    ++last;
    scratch.vertex[static_cast<std::size_t>(last)] = q;
    scratch.begin[static_cast<std::size_t>(last)] = at;
    scratch.begin[static_cast<std::size_t>(last) + 1] = std::numeric_limits<double>::infinity();
  }
  int k = 0;
  for (int p = 1; p <= length; ++p) {
    while (scratch.begin[static_cast<std::size_t>(k) + 1] < p) ++k;
    const int v = scratch.vertex[static_cast<std::size_t>(k)];
    line[(p - 1) * stride] = static_cast<float>(std::min(limit2, step2 * (p - v) * (p - v) + f(v)));
  }
}

}  // namespace

Result<std::vector<float>> distanceFromBorder_mm(const Volume& volume, double limit_mm, int threads, Progress& progress) {
  EW_EXPECTS(limit_mm > 0.0);
  const Grid& grid = volume.grid;
  const double limit2 = limit_mm * limit_mm;
  std::vector<float> squared(grid.voxelCount());
  for (std::size_t i = 0; i < squared.size(); ++i)
    squared[i] = volume.coverageAt(i) == Coverage::absent ? 0.0F : static_cast<float>(limit2);

  const glm::ivec3 dims = grid.dims;
  const std::ptrdiff_t row = dims.x;
  const std::ptrdiff_t slice = row * dims.y;
  const Message what = say<"Measuring distances from the border">();
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"The stitching was cancelled.">()); };
  PartOfProgress alongX(progress, 0.0, 0.4);
  PartOfProgress alongZ(progress, 0.4, 1.0);
  const bool first = forEachTask(dims.z, threads, alongX, what, [&](int k) {
    float* plane = squared.data() + k * slice;
    Envelope x(dims.x);
    for (int j = 0; j < dims.y; ++j) transformLine(plane + j * row, 1, dims.x, grid.spacing_mm.x, limit2, x);
    Envelope y(dims.y);
    for (int i = 0; i < dims.x; ++i) transformLine(plane + i, row, dims.y, grid.spacing_mm.y, limit2, y);
  });
  if (!first) return cancelled();
  const bool second = forEachTask(dims.y, threads, alongZ, what, [&](int j) {
    Envelope z(dims.z);
    for (int i = 0; i < dims.x; ++i) {
      float* line = squared.data() + j * row + i;
      transformLine(line, slice, dims.z, grid.spacing_mm.z, limit2, z);
      for (int k = 0; k < dims.z; ++k) line[k * slice] = std::sqrt(line[k * slice]);
    }
  });
  if (!second) return cancelled();
  return squared;
}

}  // namespace ew::stitching
