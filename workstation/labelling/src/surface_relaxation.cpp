#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "ew/core/large_pages.h"
#include "ew/core/parallel.h"
#include "surface_net.h"

namespace ew::labelling {
namespace {

constexpr std::int32_t kPointsOfTask = 1 << 14;
// Steps after the filter, in turns towards the mean of the neighbours and away from it, which hold points in their cells: they take the
// creases away that the filter leaves where its points had to be brought back. Nearly equal, so that nothing shrinks (Taubin).
constexpr int kSettlingSteps = 4;
constexpr float kTowards = 0.6F, kAway = -0.6036F;

/// What a point's neighbours are, in one look: by pullSides.
struct Pull {
  CellOffset cells;    ///< sum of the ways to the neighbours' cells, in voxels
  float share = 0.0F;  ///< one over their number; 0 when there are none
};

std::array<Pull, 64> pullsBySides() {
  std::array<Pull, 64> pulls;
  for (unsigned sides = 0; sides < 64; ++sides) {
    for (unsigned axis = 0; axis < 3; ++axis)
      pulls[sides].cells.at[axis] =
          static_cast<float>(static_cast<int>(sides >> (2 * axis + 1) & 1) - static_cast<int>(sides >> (2 * axis) & 1));
    if (sides != 0) pulls[sides].share = 1.0F / static_cast<float>(std::popcount(sides));
  }
  return pulls;
}

/// How many steps a filter needs: more of them change it no more.
int stepsFor(double shortestWave_voxel) { return static_cast<int>(std::lround(3.0 * shortestWave_voxel)); }

/// Weights of the Chebyshev polynomials T0, T1 ... of the mean over neighbours. That mean keeps 1 - k of a wave of the surface, 0 <= k <=
/// 2; the filter is to keep exp(-ln 2 (k / kHalf)^3): one half at the shortest wave, and to second order all of long ones. With the square
/// thin structures lose more (a ball of 2 voxels 46 instead of 35 %), with the fourth power edges ring and more steps are needed.
std::vector<float> filterFor(double shortestWave_voxel) {
  constexpr int kSamples = 1024;
  const double half = 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi / shortestWave_voxel));  // of a wave along one axis of a flat sheet
  std::vector<double> weights(static_cast<std::size_t>(stepsFor(shortestWave_voxel)) + 1, 0.0);
  double sum = 0.0;
  for (std::size_t n = 0; n < weights.size(); ++n) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const double angle = std::numbers::pi * (sample + 0.5) / kSamples, k = (1.0 - std::cos(angle)) / half;
      weights[n] += (n == 0 ? 1.0 : 2.0) / kSamples * std::exp(-std::numbers::ln2 * k * k * k) * std::cos(static_cast<double>(n) * angle);
    }
    sum += weights[n];
  }
  std::vector<float> filter;
  for (const double weight : weights) filter.push_back(static_cast<float>(weight / sum));  // what does not wave stays where it is
  return filter;
}

/// Smooths a net step by step; a step reads the points of the one before, so it does not matter who does which first.
class Relaxation {
 public:
  Relaxation(SurfaceNet& net, int threads) : net_(net), threads_(threads), bySides_(pullsBySides()) {}

  /// @return false when cancelled, as all of these
  [[nodiscard]] bool begin(const Progress& progress) { return growInLargePages(other_, net_.points(), progress); }

  /// The sum of weighted polynomials by Clenshaw's recurrence from the last to the first, which needs two generations and no sum: b(n) =
  /// weight(n) x + 2 mean b(n + 1) - b(n + 2), and mean b(1) - b(2) + weight(0) x in the end. A b is so many times the middle of the cell
  /// and an offset; x is the middle alone. Points may leave their cells on the way, not at its end.
  [[nodiscard]] bool filter(const std::vector<float>& weights, Progress& progress) {
    float middles = weights.back(), middlesBefore = 0.0F;  // of b(n + 1), b(n + 2)
    for (std::size_t n = weights.size() - 1; n-- > 0;) {
      const float twice = n > 0 ? 2.0F : 1.0F;
      if (!step(1.0 - static_cast<double>(n) / static_cast<double>(weights.size()), progress, [&](std::size_t p) {
            const CellOffset mean = meanAround(p, middles);
            for (int i = 0; i < 4; ++i) other_[p].at[i] = twice * mean.at[i] - other_[p].at[i];
          }))
        return false;
      middlesBefore = std::exchange(middles, weights[n] + twice * middles - middlesBefore);
    }
    for (CellOffset& each : net_.offsets)
      for (float& at : each.at) at = held(at);
    return true;
  }

  [[nodiscard]] bool settle(Progress& progress) {
    for (int n = 0; n < kSettlingSteps; ++n) {
      const float share = n % 2 == 0 ? kTowards : kAway;
      if (!step(static_cast<double>(n + 1) / kSettlingSteps, progress, [&](std::size_t p) {
            const CellOffset mean = meanAround(p, 1.0F);
            const float* const own = net_.offsets[p].at;
            for (int i = 0; i < 4; ++i) other_[p].at[i] = held(own[i] + share * (mean.at[i] - own[i]));
          }))
        return false;
    }
    return true;
  }

 private:
  static float held(float offset) { return std::min(std::max(offset, -kOffsetLimit), kOffsetLimit); }

  /// The mean of the neighbours, beside the middle of the point's own cell, where ways between cells count `middles` times.
  [[nodiscard]] CellOffset meanAround(std::size_t p, float middles) const {
    const CellOffset* const from = net_.offsets.data();
    const unsigned sides = net_.pullSides[p];
    const Pull& pull = bySides_[sides];
    const auto& at = net_.pulls[p];
    // Where there is no neighbour the point stands in for it, which adds nothing to the sum of differences.
    const CellOffset *const own = from + p, *const beforeI = own - (sides & kBefore_i), *const afterI = own + (sides >> 1 & 1);
    const CellOffset *const beforeJ = from + at[0], *const afterJ = from + at[1], *const beforeK = from + at[2],
                            *const afterK = from + at[3];
    CellOffset mean;
    for (int i = 0; i < 4; ++i) {
      const float sum = (beforeI->at[i] + afterI->at[i]) + (beforeJ->at[i] + afterJ->at[i]) + (beforeK->at[i] + afterK->at[i]);
      mean.at[i] = own->at[i] + pull.share * (sum - 6.0F * own->at[i] + middles * pull.cells.at[i]);
    }
    return mean;
  }

  /// Moves all points by `move`, which writes into other_. @param done of the work when it ends
  template <class Move>
  bool step(double done, Progress& progress, const Move& move) {
    const auto points = static_cast<std::int32_t>(net_.points());
    PartOfProgress part(progress, done, done);
    const bool finished = forEachTask((points - 1) / kPointsOfTask + 1, threads_, part, say<"Smoothing surfaces">(), [&](int task) {
      const std::int32_t first = task * kPointsOfTask;
      const auto end = static_cast<std::size_t>(first + std::min(kPointsOfTask, points - first));
      for (auto p = static_cast<std::size_t>(first); p < end; ++p) move(p);
    });
    std::swap(net_.offsets, other_);
    return finished;
  }

  SurfaceNet& net_;
  int threads_;
  std::array<Pull, 64> bySides_;
  std::vector<CellOffset> other_;
};

}  // namespace

bool relaxNet(SurfaceNet& net, double shortestWave_voxel, int threads, Progress& progress) {
  if (shortestWave_voxel == 0.0 || net.points() == 0) return true;
  PartOfProgress filtering(progress, 0.0, 0.8), settling(progress, 0.8, 1.0);
  Relaxation relaxation(net, threads);
  return relaxation.begin(progress) && relaxation.filter(filterFor(shortestWave_voxel), filtering) && relaxation.settle(settling);
}

}  // namespace ew::labelling
