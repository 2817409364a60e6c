#include "random_walk.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ew {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Keeps the graph in one piece where an edge is so strong that its weight is nothing.
constexpr double kLeastWeight = 1e-6;

}  // namespace

struct RandomWalk::System {
  int width = 0;
  int height = 0;
  std::vector<Eigen::Triplet<double>> entries;
  Matrix laplacian;
  Eigen::VectorXd right;
  Eigen::SimplicialLDLT<Matrix> solver;
};

RandomWalk::RandomWalk() : system_(std::make_unique<System>()) {}
RandomWalk::~RandomWalk() = default;

bool RandomWalk::solve(const Image<float>& levels, const Weights& weights, Image<float>& probability) {
  System& system = *system_;
  const int width = levels.width, height = levels.height;
  const int unknownRows = height - 2;
  std::vector<double> attenuated(levels.pixels.size());
  for (int y = 0; y < height; ++y) {
    const double kept = std::exp(-weights.alpha * y / (height - 1));
    for (int x = 0; x < width; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      attenuated[at] = kept * static_cast<double>(levels.pixels[at]);
    }
  }
  const auto levelAt = [&](int x, int y) {
    return attenuated[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  };
  const auto unknownAt = [&](int x, int y) { return (y - 1) * width + x; };
  const int unknowns = unknownRows * width;
  std::vector<double> diagonal(static_cast<std::size_t>(unknowns), 0.0);
  system.right = Eigen::VectorXd::Zero(unknowns);
  system.entries.clear();
  const auto join = [&](int x, int y, int toX, int toY, double leaving) {
    const double weight = kLeastWeight + std::exp(-weights.beta * (std::abs(levelAt(x, y) - levelAt(toX, toY)) + leaving));
    const auto inside = [&](int row) { return row > 0 && row < height - 1; };
    if (inside(y)) diagonal[static_cast<std::size_t>(unknownAt(x, y))] += weight;
    if (inside(toY)) diagonal[static_cast<std::size_t>(unknownAt(toX, toY))] += weight;
    if (inside(y) && inside(toY)) {
      const int a = unknownAt(x, y), b = unknownAt(toX, toY);
      system.entries.emplace_back(std::max(a, b), std::min(a, b), -weight);
    } else if (y == 0 && inside(toY)) {
      system.right[unknownAt(toX, toY)] += weight;
    }
  };
  const double across = weights.gamma, between = std::numbers::sqrt2 * weights.gamma;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width && y > 0 && y < height - 1) join(x, y, x + 1, y, across);
      if (y + 1 == height) continue;
      join(x, y, x, y + 1, 0.0);
      if (x + 1 < width) join(x, y, x + 1, y + 1, between);
      if (x > 0) join(x, y, x - 1, y + 1, between);
    }
  }
  for (int n = 0; n < unknowns; ++n) system.entries.emplace_back(n, n, diagonal[static_cast<std::size_t>(n)]);
  system.laplacian.resize(unknowns, unknowns);
  system.laplacian.setFromTriplets(system.entries.begin(), system.entries.end());
  if (system.width != width || system.height != height) {
    system.solver.analyzePattern(system.laplacian);
    system.width = width;
    system.height = height;
  }
  system.solver.factorize(system.laplacian);
  if (system.solver.info() != Eigen::Success) return false;
  const Eigen::VectorXd found = system.solver.solve(system.right);
  if (system.solver.info() != Eigen::Success || !found.allFinite()) return false;

  probability.width = width;
  probability.height = height;
  probability.pixels.assign(levels.pixels.size(), 0.0F);
  std::fill_n(probability.pixels.begin(), width, 1.0F);
  for (int n = 0; n < unknowns; ++n)
    probability.pixels[static_cast<std::size_t>(n + width)] = static_cast<float>(std::clamp(found[n], 0.0, 1.0));
  return true;
}

}  // namespace ew
