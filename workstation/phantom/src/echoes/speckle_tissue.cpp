#include "ew/phantom/speckle_tissue.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ew/core/parallel.h"
#include "ew/phantom/speckle.h"

namespace ew {
namespace {

constexpr double kScatterer_mm = 0.53;  // between scatterers; the beam reaches over three of them
constexpr double kMiddle_grey = 150.0;

/// In [0, 1), three numbers of one hash.
glm::dvec3 evenOf(std::uint64_t hash) {
  return {static_cast<double>(hash & 0x1FFFFF) * 0x1p-21, static_cast<double>((hash >> 21) & 0x1FFFFF) * 0x1p-21,
          static_cast<double>(hash >> 42) * 0x1p-22};
}

/// A complex scatterer, each part nearly normal with deviation 1: the bits that are set among 32, less their mean, over their deviation.
glm::dvec2 scattererOf(std::uint64_t hash) {
  constexpr double kDeviation = 2.8284271247461903;  // of 32 fair bits: sqrt(32) / 2
  return glm::dvec2(std::popcount(hash & 0xFFFFFFFFu) - 16, std::popcount(hash >> 32) - 16) / kDeviation;
}

/// Quadratic B-spline weights of the three places around x, of which `first` is the lowest.
void weightsAt(double x, std::int64_t& first, double weight[3]) {
  const double nearest = std::floor(x + 0.5);
  const double t = x - nearest;
  first = static_cast<std::int64_t>(nearest) - 1;
  weight[0] = 0.5 * (0.5 - t) * (0.5 - t);
  weight[1] = 0.75 - t * t;
  weight[2] = 0.5 * (0.5 + t) * (0.5 + t);
}

}  // namespace

double SpeckleTissue::echo_db(const glm::dvec3& p_mm) const {
  // Layers that undulate, textures of two sizes, and one organ, cyst or vessel a cell.
  double db = 5.0 * valueNoise(seed_ + 11, p_mm / 9.0) + 2.5 * valueNoise(seed_ + 12, p_mm / 4.0);
  const double depth = p_mm.y + 4.0 * valueNoise(seed_ + 13, p_mm / 30.0);
  db += 3.0 * std::sin(depth / 6.0 + 1.5 * std::sin(depth / 17.0));
  const glm::dvec3 cell = p_mm / organ_mm_;
  const glm::dvec3 base = glm::floor(cell);
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const glm::dvec3 at = base + glm::dvec3(i, j, k);
        const std::uint64_t hash =
            hashOfPlace(seed_ + 14, static_cast<std::int64_t>(at.x), static_cast<std::int64_t>(at.y), static_cast<std::int64_t>(at.z));
        const glm::dvec3 shape = evenOf(hash);
        const glm::dvec3 middle = (at + 0.2 + 0.6 * evenOf(hash * 0x9E3779B97F4A7C15ull)) * organ_mm_;
        const glm::dvec3 half = organ_mm_ * (0.15 + 0.3 * glm::dvec3(shape.y, shape.z, shape.x));
        const double distance = glm::length((p_mm - middle) / half);
        if (distance >= 1.15) continue;
        const double inside = std::clamp((1.15 - distance) / 0.3, 0.0, 1.0);
        const double echo = shape.x < 0.3 ? -22.0 : shape.x < 0.65 ? -8.0 : 8.0;
        db += echo * inside * inside * (3.0 - 2.0 * inside);
      }
  return db;
}

glm::dvec2 SpeckleTissue::field(const glm::dvec3& p_mm, std::uint64_t view) const {
  const glm::dvec3 at = p_mm / kScatterer_mm;
  std::int64_t first[3];
  double weight[3][3];
  double squares = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    weightsAt(at[axis], first[axis], weight[axis]);
    squares *= weight[axis][0] * weight[axis][0] + weight[axis][1] * weight[axis][1] + weight[axis][2] * weight[axis][2];
  }
  glm::dvec2 sum(0.0);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j) {
      const double outer = weight[2][k] * weight[1][j];
      for (int i = 0; i < 3; ++i)
        sum += outer * weight[0][i] * scattererOf(hashOfPlace(seed_ + 1000 * view + 15, first[0] + i, first[1] + j, first[2] + k));
    }
  return sum / std::sqrt(2.0 * squares);  // the same power between scatterers as on them
}

Result<Volume> imageOf(const SpeckleTissue& tissue, const TissueView& view, int threads, Progress& progress) {
  if (auto usable = checkGrid(view.grid); !usable) return passOn(usable.error());
  Volume made;
  made.grid = view.grid;
  made.echo.resize(view.grid.voxelCount());
  const auto voxelToWorld = view.grid.voxelToWorld();
  const double own = std::sqrt(1.0 - view.shared * view.shared);
  const double perDb = 255.0 / view.dynamicRange_db;
  const glm::ivec3 dims = view.grid.dims;
  const bool finished = forEachTask(dims.z, threads, progress, say<"Imaging tissue">(), [&](int k) {
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        const glm::dvec3 here = (voxelToWorld * Point<frame::Voxel>{{i, j, k}}).at;
        const glm::dvec3 p = view.toTissue ? view.toTissue(here) : here;
        glm::dvec2 speckle = view.shared > 0.0 ? view.shared * tissue.field(p, 0) : glm::dvec2(0.0);
        if (own > 0.0) speckle += own * tissue.field(p, view.view);
        double db = tissue.echo_db(p) + view.gain_db + 10.0 * std::log10(std::max(1e-6, glm::dot(speckle, speckle)));
        if (view.shadow) {
          const double across = (i - 0.68 * dims.x) / (0.08 * dims.x);
          const double below = std::clamp((j - 0.35 * dims.y) / (0.1 * dims.y), 0.0, 1.0);
          db -= 25.0 * below * std::exp(-across * across);
        }
        made.echo[made.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(std::clamp(kMiddle_grey + perDb * db, 0.0, 255.0) + 0.5);
      }
  });
  if (!finished) return failure(ErrorCode::cancelled, say<"Imaging the tissue was stopped.">());
  return made;
}

}  // namespace ew
