#include "gaussian.h"

#include <algorithm>
#include <cmath>

namespace ew::labelling {
namespace {

/// @param stride between neighbours along the axis
void blurLine(float* line, int length, std::size_t stride, const std::vector<float>& weights, std::vector<float>& copy) {
  const int reach = static_cast<int>(weights.size()) - 1;
  copy.resize(static_cast<std::size_t>(length));
  for (int n = 0; n < length; ++n) copy[static_cast<std::size_t>(n)] = line[static_cast<std::size_t>(n) * stride];
  for (int n = 0; n < length; ++n) {
    float sum = 0.0F, total = 0.0F;
    for (int m = std::max(0, n - reach); m <= std::min(length - 1, n + reach); ++m) {
      const float weight = weights[static_cast<std::size_t>(std::abs(m - n))];
      sum += weight * copy[static_cast<std::size_t>(m)];
      total += weight;
    }
    line[static_cast<std::size_t>(n) * stride] = sum / total;
  }
}

}  // namespace

bool blur(Block<float>& values, const glm::dvec3& sigma, Progress& progress) {
  const glm::ivec3 size = values.size();
  const std::size_t strides[3] = {1, static_cast<std::size_t>(size.x), static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)};
  std::vector<float> copy;
  for (int axis = 0; axis < 3; ++axis) {
    if (sigma[axis] < 0.2) continue;  // less than a grey level of any neighbour
    std::vector<float> weights;
    for (int n = 0; n <= static_cast<int>(std::ceil(3.0 * sigma[axis])); ++n)
      weights.push_back(static_cast<float>(std::exp(-0.5 * n * n / (sigma[axis] * sigma[axis]))));
    const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
    for (int y = 0; y < size[b]; ++y) {
      if (progress.cancelRequested()) return false;
      for (int x = 0; x < size[a]; ++x)
        blurLine(values.values().data() + static_cast<std::size_t>(x) * strides[a] + static_cast<std::size_t>(y) * strides[b], size[axis],
                 strides[axis], weights, copy);
    }
  }
  return true;
}

}  // namespace ew::labelling
