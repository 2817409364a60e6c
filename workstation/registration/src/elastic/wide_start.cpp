#include "elastic/wide_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "ew/core/parallel.h"

namespace ew::registration {
namespace {

constexpr double kWindow_mm = 8.0;  // standard deviation of the local correlation's window
// Of an independent residual at 4 mm: measured on speckle, resources/docs/science/registration.md.
constexpr double kIndependent_mm3 = 300.0;

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

/// All shifts of whole samples within `reach_mm`.
std::vector<glm::dvec3> shiftsWithin(const LevelImage& fixed, double reach_mm) {
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
  return shifts;
}

/// One half of the window of the local correlation, from its middle on, per axis.
std::array<std::vector<float>, 3> windowOf(const glm::dvec3& step) {
  std::array<std::vector<float>, 3> weight;
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = kWindow_mm / step[axis];
    for (int n = 0; n <= static_cast<int>(std::ceil(2.5 * sigma)); ++n)
      weight[static_cast<std::size_t>(axis)].push_back(static_cast<float>(std::exp(-0.5 * n * n / (sigma * sigma))));
  }
  return weight;
}

/// The sample nearest to each node, x fastest.
std::vector<std::size_t> samplesAtNodes(const NodeGrid& nodes, const LevelImage& fixed) {
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
  return sampleOf;
}

NodeValues constantField(const NodeGrid& nodes, const glm::dvec3& shift) {
  NodeValues values(4 * nodes.count(), 0.0F);
  for (std::size_t n = 0; n < values.size(); n += 4) {
    for (std::size_t c = 0; c < 3; ++c) values[n + c] = static_cast<float>(shift[static_cast<int>(c)]);
  }
  return values;
}

/// Both images under every shift: how likely each is, of all and around each node.
struct ShiftLikelihoods {
  const LevelImage& fixed;
  const LevelImage& moving;
  const AxesTransform& transform;
  const NodeGrid& nodes;
  std::vector<glm::dvec3> shifts;
  std::array<std::vector<float>, 3> window;
  std::vector<std::size_t> sampleOf;  // of a node
  std::vector<std::vector<float>> ofNode;
  std::vector<double> overall;

  using Products = std::array<std::vector<float>, 4>;  // per sample weight, ff, ww, fw: the images have no local mean left
  using Sums = std::array<double, 4>;

  ShiftLikelihoods(const LevelImage& fixedImage, const LevelImage& movingImage, const AxesTransform& fixedToMoving,
                   const NodeGrid& nodeGrid, double reach_mm)
      : fixed(fixedImage),
        moving(movingImage),
        transform(fixedToMoving),
        nodes(nodeGrid),
        shifts(shiftsWithin(fixedImage, reach_mm)),
        window(windowOf(fixedImage.spacing_mm)),
        sampleOf(samplesAtNodes(nodeGrid, fixedImage)),
        ofNode(shifts.size()),
        overall(shifts.size()) {}

  /// @return false when cancelled
  bool measure(int threads, Progress& progress) {
    return forEachTask(static_cast<int>(shifts.size()), threads, progress, say<"Searching for large motion">(),
                       [&](int task) { measure(static_cast<std::size_t>(task)); });
  }
  void measure(std::size_t s);
  void multiply(const LevelPair& pair, Products& products, Sums& sums) const;
  /// The log-likelihood of a correlation.
  [[nodiscard]] double worth(double samples, double ff, double ww, double fw) const {
    if (!(ff > 1e-6 && ww > 1e-6)) return 0.0;
    const double correlation = std::clamp(fw / std::sqrt(ff * ww), 0.0, 0.999);
    const double sampleVolume = fixed.spacing_mm.x * fixed.spacing_mm.y * fixed.spacing_mm.z;
    return -0.5 * samples * sampleVolume / kIndependent_mm3 * std::log(1.0 - correlation * correlation);
  }
  [[nodiscard]] const glm::dvec3& best() const {
    return shifts[static_cast<std::size_t>(std::max_element(overall.begin(), overall.end()) - overall.begin())];
  }
};

void ShiftLikelihoods::measure(std::size_t s) {
  LevelPair pair(fixed, moving, transform, nodes, 1);
  if (!pair.warp(constantField(nodes, shifts[s]), noProgress())) return;
  Products products;
  Sums sums{};
  multiply(pair, products, sums);
  overall[s] = worth(sums[0], sums[1], sums[2], sums[3]);
  std::vector<float> line;
  for (auto& map : products) {
    for (int axis = 0; axis < 3; ++axis) blurLines(map, fixed.dims, axis, window[static_cast<std::size_t>(axis)], line);
  }
  ofNode[s].resize(nodes.count());
  for (std::size_t node = 0; node < nodes.count(); ++node) {
    const std::size_t at = sampleOf[node];
    ofNode[s][node] = static_cast<float>(worth(static_cast<double>(products[0][at]), static_cast<double>(products[1][at]),
                                               static_cast<double>(products[2][at]), static_cast<double>(products[3][at])));
  }
}

void ShiftLikelihoods::multiply(const LevelPair& pair, Products& products, Sums& sums) const {
  const std::size_t samples =
      static_cast<std::size_t>(fixed.dims.x) * static_cast<std::size_t>(fixed.dims.y) * static_cast<std::size_t>(fixed.dims.z);
  for (auto& map : products) map.resize(samples);
  std::size_t n = 0;
  for (int k = 0; k < fixed.dims.z; ++k) {
    for (int j = 0; j < fixed.dims.y; ++j) {
      const std::size_t row = fixed.rowOf(j, k);
      for (std::size_t i = row; i < row + static_cast<std::size_t>(fixed.dims.x); ++i, ++n) {
        const float both = pair.movedWeights()[i] * (fixed.weights.empty() ? 1.0F : fixed.weights[i]);
        const float f = fixed.values[i], w = pair.moved()[i];
        products[0][n] = both;
        products[1][n] = both * f * f;
        products[2][n] = both * w * w;
        products[3][n] = both * f * w;
        for (std::size_t m = 0; m < 4; ++m) sums[m] += static_cast<double>(products[m][n]);
      }
    }
  }
}

/// Neighbours' mean, weighted like a Gaussian of one and a half nodes; ends are continued.
std::vector<glm::vec3> meanAround(const NodeGrid& nodes, const std::vector<glm::vec3>& chosen) {
  std::vector<glm::vec3> mean = chosen, scratch(chosen.size());
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
  return mean;
}

/// By turns the best shift of each node near its neighbours' mean, and that mean, from a coupling that a shift of 20 mm hardly feels to one
/// that allows a voxel.
std::vector<glm::vec3> coupledShifts(const ShiftLikelihoods& likelihoods) {
  const std::vector<glm::dvec3>& shifts = likelihoods.shifts;
  std::vector<glm::vec3> chosen(likelihoods.nodes.count(), glm::vec3(likelihoods.best())), mean = meanAround(likelihoods.nodes, chosen);
  for (const double coupling : {0.01, 0.03, 0.1, 0.3, 1.0}) {
    for (int turn = 0; turn < 2; ++turn) {
      for (std::size_t n = 0; n < chosen.size(); ++n) {
        double least = 1e30;
        for (std::size_t s = 0; s < shifts.size(); ++s) {
          const glm::dvec3 off = shifts[s] - glm::dvec3(mean[n]);
          const double cost = 0.5 * coupling * glm::dot(off, off) - static_cast<double>(likelihoods.ofNode[s][n]);
          if (cost < least) {
            least = cost;
            chosen[n] = glm::vec3(shifts[s]);
          }
        }
      }
      mean = meanAround(likelihoods.nodes, chosen);
    }
  }
  return mean;
}

}  // namespace

std::vector<NodeValues> wideStarts(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform, const NodeGrid& nodes,
                                   double reach_mm, int threads, Progress& progress) {
  ShiftLikelihoods likelihoods(fixed, moving, transform, nodes, reach_mm);
  if (!likelihoods.measure(threads, progress)) return {};
  const std::vector<glm::vec3> coupled = coupledShifts(likelihoods);
  NodeValues varying(4 * nodes.count(), 0.0F);
  for (std::size_t n = 0; n < nodes.count(); ++n) {
    for (int c = 0; c < 3; ++c) varying[4 * n + static_cast<std::size_t>(c)] = coupled[n][c];
  }
  return {constantField(nodes, likelihoods.best()), std::move(varying)};
}

}  // namespace ew::registration
