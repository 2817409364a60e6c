#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "ew/tracking/alignment.h"

namespace ew {
namespace {

std::array<std::size_t, 4> largestTetrahedron(std::span<const glm::dvec3> at) {
  std::array<std::size_t, 4> best{0, 1, 2, 3};
  double most = -1.0;
  for (std::size_t a = 0; a < at.size(); ++a)
    for (std::size_t b = a + 1; b < at.size(); ++b)
      for (std::size_t c = b + 1; c < at.size(); ++c)
        for (std::size_t d = c + 1; d < at.size(); ++d) {
          const double volume = std::abs(glm::dot(glm::cross(at[b] - at[a], at[c] - at[a]), at[d] - at[a]));
          if (volume <= most) continue;
          most = volume;
          best = {a, b, c, d};
        }
  return best;
}

}  // namespace

std::vector<std::size_t> landmarkOrder(std::span<const glm::dvec3> world_mm) {
  std::vector<std::size_t> order(world_mm.size());
  std::iota(order.begin(), order.end(), 0);
  if (world_mm.size() <= 4) return order;
  const auto first = largestTetrahedron(world_mm);
  for (std::size_t n = 0; n < first.size(); ++n)
    std::iter_swap(order.begin() + static_cast<std::ptrdiff_t>(n), std::find(order.begin(), order.end(), first[n]));
  for (std::size_t done = first.size(); done + 1 < order.size(); ++done) {
    const auto near = [&](std::size_t index) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t n = 0; n < done; ++n) least = std::min(least, glm::distance(world_mm[index], world_mm[order[n]]));
      return least;
    };
    const auto farthest = std::max_element(order.begin() + static_cast<std::ptrdiff_t>(done), order.end(),
                                           [&](std::size_t a, std::size_t b) { return near(a) < near(b); });
    std::iter_swap(order.begin() + static_cast<std::ptrdiff_t>(done), farthest);
  }
  return order;
}

}  // namespace ew
