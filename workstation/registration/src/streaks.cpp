#include "streaks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "ew/core/parallel.h"

namespace ew::registration {
namespace {

constexpr int kDirections = 300;  // over half the sphere: 8 degrees apart
constexpr double kNearby_deg = 12.0;
constexpr double kApart_deg = 30.0;
constexpr double kNearlyAsGood = 0.75;
constexpr double kAlike = 0.15;                 // correlation along streaks; tissue without any stays below
constexpr double kLeastCompared_mm3 = 50000.0;  // per direction
constexpr double kMostRows = 40000.0;           // voxels looked at per distance

struct Tap {
  glm::ivec3 step;
  float weight;
};

/// The line through a voxel, read by linear interpolation: the same steps for every voxel.
std::vector<Tap> tapsAlong(const glm::dvec3& direction, const glm::dvec3& voxel_mm, double sigma_mm) {
  const double between_mm = std::max(std::min({voxel_mm.x, voxel_mm.y, voxel_mm.z}), 0.25 * sigma_mm);
  const int reach = static_cast<int>(std::ceil(2.5 * sigma_mm / between_mm));
  std::map<std::tuple<int, int, int>, double> taps;
  for (int t = -reach; t <= reach; ++t) {
    const double along_mm = t * between_mm;
    const double g = std::exp(-0.5 * along_mm * along_mm / (sigma_mm * sigma_mm));
    const glm::dvec3 at = direction * along_mm / voxel_mm;
    const glm::dvec3 low = glm::floor(at);
    const glm::dvec3 share = at - low;
    for (int c = 0; c < 8; ++c) {
      const glm::ivec3 up(c & 1, (c >> 1) & 1, c >> 2);
      double w = g;
      for (int a = 0; a < 3; ++a) w *= up[a] != 0 ? share[a] : 1.0 - share[a];
      const glm::ivec3 step = glm::ivec3(low) + up;
      if (w > 1e-6) taps[{step.z, step.y, step.x}] += w;
    }
  }
  std::vector<Tap> out;
  for (const auto& [step, w] : taps) out.push_back({{std::get<2>(step), std::get<1>(step), std::get<0>(step)}, static_cast<float>(w)});
  return out;
}

/// The direction of a beam on the grid's axes in steps of a 32nd, about 2 degrees: neighbours share the steps of their lines.
using Rounded = std::tuple<int, int, int>;
constexpr double kPerStep = 32.0;
Rounded roundedBeam(const Beams& beams, const glm::dmat3& toAxes, const glm::dmat4& toFrame, const glm::ivec3& voxel) {
  const glm::dvec3 beam = toAxes * beams.at(glm::dvec3(toFrame * glm::dvec4(glm::dvec3(voxel), 1.0)));
  const glm::ivec3 steps(glm::round(kPerStep * beam));
  return {steps.x, steps.y, steps.z};
}
glm::dvec3 directionOf(const Rounded& steps) {
  return glm::normalize(glm::dvec3(std::get<0>(steps), std::get<1>(steps), std::get<2>(steps)));
}

/// Correlation of the image with itself `step` voxels further on.
struct Alike {
  double both = 0.0;
  double here = 0.0;
  double there = 0.0;
  double count = 0.0;
};
void addAlike(const ComparableImage& image, const glm::ivec3& step, int stride, Alike& alike) {
  const glm::ivec3 dims = image.grid.dims;
  const glm::ivec3 begin = glm::max(glm::ivec3(0), -step);
  const glm::ivec3 end = glm::min(dims, dims - step);
  for (int k = begin.z; k < end.z; k += stride) {
    for (int j = begin.y; j < end.y; j += stride) {
      const std::size_t here = image.grid.indexOf(0, j, k);
      const std::size_t there = image.grid.indexOf(0, j + step.y, k + step.z);
      for (int i = begin.x; i < end.x; ++i) {
        if (image.weight[here + i] == 0 || image.weight[there + i + step.x] == 0) continue;
        const double x = image.value[here + i];
        const double y = image.value[there + i + step.x];
        alike.both += x * y;
        alike.here += x * x;
        alike.there += y * y;
        alike.count += 1.0;
      }
    }
  }
}

}  // namespace

bool takeOutAlong(const Grid& grid, const RowLayout& rows, const Beams& beams, double sigma_mm, const std::vector<float>& weight,
                  std::vector<float>& sum, int threads, Progress& progress) {
  const glm::dvec3 voxel_mm = grid.spacing_mm;
  const auto rowOf = [&](int j, int k) {
    return rows.first + (static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.dims.y) + static_cast<std::size_t>(j)) * rows.stride;
  };
  const bool weighted = !weight.empty();
  const glm::dmat3 toAxes = glm::transpose(grid.directions);
  const glm::ivec3 dims = grid.dims;
  std::vector<float> out(sum.size());
  const std::vector<Tap> everywhere = beams.fan ? std::vector<Tap>() : tapsAlong(toAxes * beams.at(grid.origin_mm), voxel_mm, sigma_mm);
  const glm::dmat4 toFrame = grid.voxelToWorld().matrix;
  const bool done = forEachTask(dims.z, threads, progress, say<"Preparing images">(), [&](int k) {
    std::vector<float> echo(dims.x);
    std::vector<float> share(dims.x);
    std::map<Rounded, std::vector<Tap>> found;
    // Voxels [first, last) of a row have the same steps.
    const auto add = [&](int j, int first, int last, const std::vector<Tap>& taps) {
      for (const Tap& tap : taps) {
        const int y = j + tap.step.y;
        const int z = k + tap.step.z;
        if (y < 0 || y >= dims.y || z < 0 || z >= dims.z) continue;
        const int begin = std::max(first, -tap.step.x);
        const int end = std::min(last, dims.x - tap.step.x);
        const std::size_t row = rowOf(y, z);
        for (int i = begin; i < end; ++i) {
          echo[i] += tap.weight * sum[row + i + tap.step.x];
          share[i] += tap.weight * (weighted ? weight[row + i + tap.step.x] : 1.0F);
        }
      }
    };
    for (int j = 0; j < dims.y; ++j) {
      std::fill(echo.begin(), echo.end(), 0.0F);
      std::fill(share.begin(), share.end(), 0.0F);
      if (!beams.fan) {
        add(j, 0, dims.x, everywhere);
      } else {
        int first = 0;
        Rounded here = roundedBeam(beams, toAxes, toFrame, {0, j, k});
        for (int i = 1; i <= dims.x; ++i) {
          const Rounded next = i < dims.x ? roundedBeam(beams, toAxes, toFrame, {i, j, k}) : Rounded{};
          if (i < dims.x && next == here) continue;
          auto& taps = found[here];
          if (taps.empty()) taps = tapsAlong(directionOf(here), voxel_mm, sigma_mm);
          add(j, first, i, taps);
          first = i;
          here = next;
        }
      }
      const std::size_t at = rowOf(j, k);
      for (int i = 0; i < dims.x; ++i) {
        const float here = weighted ? weight[at + i] : 1.0F;
        out[at + i] = share[i] > 1e-6F ? sum[at + i] - here * echo[i] / share[i] : 0.0F;
      }
    }
  });
  if (done) sum = std::move(out);
  return done;
}

std::vector<glm::dvec3> findStreaks(const ComparableImage& image, int threads, Progress& progress) {
  const glm::dvec3 voxel_mm = image.grid.spacing_mm;
  const int stride = std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(image.grid.voxelCount()) / kMostRows))));
  std::vector<glm::dvec3> directions(kDirections);
  std::vector<double> alike(kDirections, 0.0);
  for (int d = 0; d < kDirections; ++d) {  // evenly, by the golden angle
    const double z = 1.0 - (d + 0.5) / kDirections;
    const double r = std::sqrt(1.0 - z * z);
    const double angle = d * std::numbers::pi * (3.0 - std::sqrt(5.0));
    directions[d] = {r * std::cos(angle), r * std::sin(angle), z};
  }
  const bool done = forEachTask(kDirections, threads, progress, say<"Looking for shadows">(), [&](int d) {
    Alike sums;
    for (const double along_mm : {18.0, 24.0, 30.0, 36.0}) {
      addAlike(image, glm::ivec3(glm::round(directions[d] * along_mm / voxel_mm)), stride, sums);
    }
    const double compared_mm3 = sums.count * stride * stride * voxel_mm.x * voxel_mm.y * voxel_mm.z;
    if (compared_mm3 >= kLeastCompared_mm3 && sums.here > 0.0 && sums.there > 0.0) {
      alike[d] = sums.both / std::sqrt(sums.here * sums.there);
    }
  });
  if (!done) return {};
  std::vector<glm::dvec3> found;
  double first = 0.0;
  while (found.size() < 2) {
    const auto best = std::max_element(alike.begin(), alike.end());
    if (*best < std::max(kAlike, kNearlyAsGood * first)) break;
    if (found.empty()) first = *best;
    // The middle of the peak.
    const glm::dvec3 peak = directions[best - alike.begin()];
    const double least = 0.7 * *best;
    glm::dvec3 middle(0.0);
    for (int d = 0; d < kDirections; ++d) {
      const double along = glm::dot(directions[d], peak);
      if (std::abs(along) > std::cos(kNearby_deg * std::numbers::pi / 180.0)) {
        middle += std::max(0.0, alike[d] - least) * (along < 0.0 ? -1.0 : 1.0) * directions[d];
      }
      if (std::abs(along) > std::cos(kApart_deg * std::numbers::pi / 180.0)) alike[d] = 0.0;
    }
    found.push_back(image.grid.directions * glm::normalize(middle));
  }
  return found;
}

}  // namespace ew::registration
