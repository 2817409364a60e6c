#include "ew/core/depth_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ew/core/order_statistics.h"

namespace ew {
namespace {

constexpr int kRounds = 12;
constexpr double kLongestCurve_mm = 1000.0;

/// A depth's two knots and the share of the second.
struct Knots {
  std::size_t at = 0;
  double share = 0.0;
};
Knots knotsOf(double depth_mm, double knot_mm, std::size_t count) {
  const double along = std::clamp(depth_mm / knot_mm, 0.0, static_cast<double>(count - 1));
  const auto at = std::min(static_cast<std::size_t>(along), count - 2);
  return {at, along - static_cast<double>(at)};
}

double medianOrZero(std::vector<double> values) { return values.empty() ? 0.0 : medianOf(std::move(values)); }

/// A symmetric, positive definite system, lower half by rows. Solved in place by Cholesky's factors.
class Normal {
 public:
  explicit Normal(std::size_t size) : size_(size), lower_(size * (size + 1) / 2, 0.0), right_(size, 0.0) {}
  double& at(std::size_t row, std::size_t column) { return lower_[row * (row + 1) / 2 + column]; }
  void add(std::size_t row, std::size_t column, double value) {
    if (row >= column) at(row, column) += value;
  }
  double& right(std::size_t row) { return right_[row]; }

  std::vector<double> solved() {
    for (std::size_t i = 0; i < size_; ++i) {
      double* const own = &at(i, 0);
      for (std::size_t j = 0; j <= i; ++j) {
        const double* const other = &at(j, 0);
        double sum = own[j];
        for (std::size_t k = 0; k < j; ++k) sum -= own[k] * other[k];
        own[j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / other[j];
      }
    }
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t k = 0; k < i; ++k) right_[i] -= at(i, k) * right_[k];
      right_[i] /= at(i, i);
    }
    for (std::size_t i = size_; i-- > 0;) {
      for (std::size_t k = i + 1; k < size_; ++k) right_[i] -= at(k, i) * right_[k];
      right_[i] /= at(i, i);
    }
    return right_;
  }

 private:
  std::size_t size_;
  std::vector<double> lower_;
  std::vector<double> right_;
};

/// Each owner's group: the lowest owner it is joined to by differences.
std::vector<std::size_t> groupsOf(std::span<const DepthDifference> differences, std::size_t owners) {
  std::vector<std::size_t> group(owners);
  for (std::size_t n = 0; n < owners; ++n) group[n] = n;
  const auto root = [&](std::size_t n) {
    while (group[n] != n) n = group[n];
    return n;
  };
  for (const DepthDifference& pair : differences) {
    const std::size_t a = root(pair.first), b = root(pair.second);
    group[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t n = 0; n < owners; ++n) group[n] = root(n);
  return group;
}

/// Least squares: unknown (owner, knot) is column owner * knots + knot.
std::vector<double> solved(std::span<const DepthDifference> differences, const std::vector<double>& weights, std::size_t owners,
                           std::size_t knots, const std::vector<std::size_t>& group, const DepthCurveOptions& options) {
  Normal normal(owners * knots);
  double total = 0.0;
  for (std::size_t n = 0; n < differences.size(); ++n) {
    const DepthDifference& pair = differences[n];
    const Knots a = knotsOf(pair.firstDepth_mm, options.knot_mm, knots), b = knotsOf(pair.secondDepth_mm, options.knot_mm, knots);
    const std::array<std::pair<std::size_t, double>, 4> row = {{{pair.first * knots + a.at, 1.0 - a.share},
                                                                {pair.first * knots + a.at + 1, a.share},
                                                                {pair.second * knots + b.at, b.share - 1.0},
                                                                {pair.second * knots + b.at + 1, -b.share}}};
    for (const auto& [i, u] : row) {
      normal.right(i) -= weights[n] * u * pair.difference;
      for (const auto& [j, v] : row) normal.add(i, j, weights[n] * u * v);
    }
    total += weights[n];
  }
  const double share = total / static_cast<double>(owners * knots);
  for (std::size_t s = 0; s < owners; ++s)
    for (std::size_t k = 1; k + 1 < knots; ++k) {
      const std::size_t at = s * knots + k - 1;
      constexpr std::array<double, 3> curvature{1.0, -2.0, 1.0};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) normal.add(at + i, at + j, options.smoothness * share * curvature[i] * curvature[j]);
    }
  if (options.common > 0.0) {
    std::vector<double> size(owners, 0.0);
    for (const std::size_t own : group) size[own] += 1.0;
    for (std::size_t s = 0; s < owners; ++s)
      for (std::size_t t = 0; t <= s; ++t)
        for (std::size_t k = 0; k < knots && group[s] == group[t]; ++k)
          normal.add(s * knots + k, t * knots + k, options.common * share / size[group[s]]);
  }
  // The gauge: of all curves that agree as well, the smallest.
  for (std::size_t i = 0; i < owners * knots; ++i) normal.add(i, i, 1e-5 * share + 1e-12);
  return normal.solved();
}

}  // namespace

double atDepth(std::span<const double> curve, double knot_mm, double depth_mm) {
  if (curve.empty()) return 0.0;
  if (curve.size() == 1) return curve.front();
  const Knots knots = knotsOf(depth_mm, knot_mm, curve.size());
  return (1.0 - knots.share) * curve[knots.at] + knots.share * curve[knots.at + 1];
}

bool fitDepthCurves(std::span<const DepthDifference> differences, std::size_t owners, const DepthCurveOptions& options,
                    const Progress& progress, DepthCurves& curves) {
  double deepest_mm = options.knot_mm;
  for (const DepthDifference& pair : differences) deepest_mm = std::max({deepest_mm, pair.firstDepth_mm, pair.secondDepth_mm});
  const std::size_t knots = static_cast<std::size_t>(std::ceil(std::min(deepest_mm, kLongestCurve_mm) / options.knot_mm)) + 1;
  std::vector<double> weights, sizes;
  for (const DepthDifference& pair : differences) {
    weights.push_back(pair.weight);
    sizes.push_back(std::abs(pair.difference));
  }
  curves.knots = knots;
  curves.medianBefore = medianOrZero(sizes);
  std::vector<double> all(owners * knots, 0.0);
  const std::vector<std::size_t> group = groupsOf(differences, owners);
  const auto curveOf = [&](std::size_t owner) { return std::span<const double>(all).subspan(owner * knots, knots); };
  for (int round = 0; round < kRounds && !differences.empty(); ++round) {
    if (progress.cancelRequested()) return false;
    all = solved(differences, weights, owners, knots, group, options);
    for (std::size_t n = 0; n < differences.size(); ++n) {
      const DepthDifference& pair = differences[n];
      sizes[n] = std::abs(pair.difference + atDepth(curveOf(pair.first), options.knot_mm, pair.firstDepth_mm) -
                          atDepth(curveOf(pair.second), options.knot_mm, pair.secondDepth_mm));
    }
    // Below half a grey level residuals are rounding, and the scale must not follow them to 0.
    const double scale = std::max(0.5, 1.4826 * medianOrZero(sizes));
    for (std::size_t n = 0; n < differences.size(); ++n) {
      const double far = sizes[n] / (2.385 * scale);
      // First Cauchy's weights, which find the way from anywhere, then Geman and McClure's, which forget what is far.
      const double cauchy = 1.0 / (1.0 + far * far);
      weights[n] = differences[n].weight * (round < kRounds / 2 ? cauchy : cauchy * cauchy);
    }
  }
  curves.medianAfter = medianOrZero(sizes);
  curves.grey.clear();
  for (std::size_t owner = 0; owner < owners; ++owner) {
    const auto curve = curveOf(owner);
    curves.grey.emplace_back(curve.begin(), curve.end());
  }
  return true;
}

}  // namespace ew
