#include "elastic/wide_start.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ew/core/parallel.h"

namespace ew::registration {
namespace {

constexpr double kWindow_mm = 8.0;  // standard deviation of the local correlation's window
constexpr double kIndependent_mm3 =
    300.0;  // volume of an independent residual at 4 mm: measured on speckle, see resources/docs/registration.md

/// Gaussian blur of an image without continuation, in place.
void blurLines(std::vector<float>& image, const glm::ivec3& dims, int axis, const std::vector<float>& weight, std::vector<float>& line) {
  const int n = dims[axis], reach = static_cast<int>(weight.size()) - 1;
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(dims.x),
                                          static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y)};
  const std::size_t step = stride[static_cast<std::size_t>(axis)], whole = step * static_cast<std::size_t>(n);
  line.resize(whole);
  for (std::size_t start = 0; start < image.size(); start += whole) {
    std::fill(line.begin(), line.end(), 0.0F);
    for (int i = 0; i < n; ++i) {
      float* to = line.data() + static_cast<std::size_t>(i) * step;
      for (int m = std::max(0, i - reach); m <= std::min(n - 1, i + reach); ++m) {
        const float w = weight[static_cast<std::size_t>(std::abs(i - m))];
        const float* from = image.data() + start + static_cast<std::size_t>(m) * step;
        for (std::size_t s = 0; s < step; ++s) to[s] += w * from[s];
      }
    }
    std::copy(line.begin(), line.end(), image.begin() + static_cast<std::ptrdiff_t>(start));
  }
}

}  // namespace

std::vector<NodeValues> wideStarts(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform, const NodeGrid& nodes,
                                   double reach_mm, int threads, Progress& progress) {
  const glm::dvec3 step = fixed.spacing_mm;
  glm::ivec3 reach;
  for (int axis = 0; axis < 3; ++axis) reach[axis] = fixed.dims[axis] > 1 ? static_cast<int>(reach_mm / step[axis]) : 0;
  std::vector<glm::dvec3> shifts;
  for (int k = -reach.z; k <= reach.z; ++k) {
    for (int j = -reach.y; j <= reach.y; ++j) {
      for (int i = -reach.x; i <= reach.x; ++i) {
        const glm::dvec3 shift = glm::dvec3(i, j, k) * step;
        if (glm::length(shift) <= reach_mm + 1e-9) shifts.push_back(shift);
      }
    }
  }
  std::array<std::vector<float>, 3> weight;
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = kWindow_mm / step[axis];
    for (int n = 0; n <= static_cast<int>(std::ceil(2.5 * sigma)); ++n)
      weight[static_cast<std::size_t>(axis)].push_back(static_cast<float>(std::exp(-0.5 * n * n / (sigma * sigma))));
  }
  // Where the nodes lie among the samples.
  std::vector<std::size_t> sampleOf;
  for (int k = 0; k < nodes.dims.z; ++k) {
    for (int j = 0; j < nodes.dims.y; ++j) {
      for (int i = 0; i < nodes.dims.x; ++i) {
        const glm::dvec3 at = (nodes.first_mm + glm::dvec3(i, j, k) * nodes.spacing_mm - fixed.first_mm) / fixed.spacing_mm;
        const glm::ivec3 near = glm::clamp(glm::ivec3(glm::round(at)), glm::ivec3(0), fixed.dims - 1);
        sampleOf.push_back((static_cast<std::size_t>(near.z) * static_cast<std::size_t>(fixed.dims.y) + static_cast<std::size_t>(near.y)) *
                               static_cast<std::size_t>(fixed.dims.x) +
                           static_cast<std::size_t>(near.x));
      }
    }
  }
  const std::size_t samples =
      static_cast<std::size_t>(fixed.dims.x) * static_cast<std::size_t>(fixed.dims.y) * static_cast<std::size_t>(fixed.dims.z);
  const double sampleVolume = step.x * step.y * step.z;
  std::vector<std::vector<float>> likelihood(shifts.size());
  std::vector<double> overall(shifts.size());
  if (!forEachTask(static_cast<int>(shifts.size()), threads, progress, "Looking for large motion", [&](int task) {
        const auto s = static_cast<std::size_t>(task);
        LevelPair pair(fixed, moving, transform, nodes, 1);
        NodeValues constant(4 * nodes.count(), 0.0F);
        for (std::size_t n = 0; n < constant.size(); n += 4) {
          for (std::size_t c = 0; c < 3; ++c) constant[n + c] = static_cast<float>(shifts[s][static_cast<int>(c)]);
        }
        if (!pair.warp(constant, noProgress())) return;
        std::array<std::vector<float>, 4> maps;  // weight, ff, ww, fw: the images have no local mean left
        for (auto& map : maps) map.resize(samples);
        double sums[6] = {};
        std::size_t n = 0;
        for (int k = 0; k < fixed.dims.z; ++k) {
          for (int j = 0; j < fixed.dims.y; ++j) {
            const std::size_t row = fixed.rowOf(j, k);
            for (std::size_t i = row; i < row + static_cast<std::size_t>(fixed.dims.x); ++i, ++n) {
              const float both = pair.movedWeights()[i] * (fixed.weights.empty() ? 1.0F : fixed.weights[i]);
              const float f = fixed.values[i], w = pair.moved()[i];
              maps[0][n] = both;
              maps[1][n] = both * f * f;
              maps[2][n] = both * w * w;
              maps[3][n] = both * f * w;
              for (std::size_t m = 0; m < 4; ++m) sums[m] += static_cast<double>(maps[m][n]);
            }
          }
        }
        const auto worth = [&](double volume, double ff, double ww, double fw) {
          if (!(ff > 1e-6 && ww > 1e-6)) return 0.0;
          const double correlation = std::clamp(fw / std::sqrt(ff * ww), 0.0, 0.999);
          return -0.5 * volume * sampleVolume / kIndependent_mm3 * std::log(1.0 - correlation * correlation);
        };
        overall[s] = worth(sums[0], sums[1], sums[2], sums[3]);
        std::vector<float> line;
        for (auto& map : maps) {
          for (int axis = 0; axis < 3; ++axis) blurLines(map, fixed.dims, axis, weight[static_cast<std::size_t>(axis)], line);
        }
        likelihood[s].resize(nodes.count());
        for (std::size_t node = 0; node < nodes.count(); ++node) {
          const std::size_t at = sampleOf[node];
          likelihood[s][node] = static_cast<float>(worth(static_cast<double>(maps[0][at]), static_cast<double>(maps[1][at]),
                                                         static_cast<double>(maps[2][at]), static_cast<double>(maps[3][at])));
        }
      }))
    return {};
  const std::size_t best = static_cast<std::size_t>(std::max_element(overall.begin(), overall.end()) - overall.begin());
  std::vector<NodeValues> starts(2, NodeValues(4 * nodes.count(), 0.0F));
  for (std::size_t n = 0; n < nodes.count(); ++n) {
    for (std::size_t c = 0; c < 3; ++c) starts[0][4 * n + c] = static_cast<float>(shifts[best][static_cast<int>(c)]);
  }
  // Neighbours' mean, weighted like a Gaussian of one and a half nodes; ends are continued.
  std::vector<glm::vec3> chosen(nodes.count(), glm::vec3(shifts[best])), mean(chosen), scratch(chosen);
  const auto smooth = [&] {
    mean = chosen;
    constexpr float kWeight[4] = {1.0F, 0.8F, 0.41F, 0.135F};
    for (int axis = 0; axis < 3; ++axis) {
      const int n = nodes.dims[axis];
      if (n == 1) continue;
      for (int k = 0; k < nodes.dims.z; ++k) {
        for (int j = 0; j < nodes.dims.y; ++j) {
          for (int i = 0; i < nodes.dims.x; ++i) {
            glm::vec3 sum(0.0F);
            float total = 0.0F;
            for (int d = -3; d <= 3; ++d) {
              glm::ivec3 at(i, j, k);
              at[axis] = std::clamp(at[axis] + d, 0, n - 1);
              sum += kWeight[std::abs(d)] * mean[nodes.indexOf(at.x, at.y, at.z)];
              total += kWeight[std::abs(d)];
            }
            scratch[nodes.indexOf(i, j, k)] = sum / total;
          }
        }
      }
      mean.swap(scratch);
    }
  };
  smooth();
  // From a coupling that a shift of 20 mm hardly feels to one that allows a voxel.
  for (const double coupling : {0.01, 0.03, 0.1, 0.3, 1.0}) {
    for (int turn = 0; turn < 2; ++turn) {
      for (std::size_t n = 0; n < chosen.size(); ++n) {
        double least = 1e30;
        for (std::size_t s = 0; s < shifts.size(); ++s) {
          const glm::dvec3 off = shifts[s] - glm::dvec3(mean[n]);
          const double cost = 0.5 * coupling * glm::dot(off, off) - static_cast<double>(likelihood[s][n]);
          if (cost < least) {
            least = cost;
            chosen[n] = glm::vec3(shifts[s]);
          }
        }
      }
      smooth();
    }
  }
  for (std::size_t n = 0; n < nodes.count(); ++n) {
    for (int c = 0; c < 3; ++c) starts[1][4 * n + static_cast<std::size_t>(c)] = mean[n][c];
  }
  return starts;
}

}  // namespace ew::registration
