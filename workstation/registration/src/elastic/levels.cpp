#include "elastic/levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elastic/lattice.h"
#include "ew/core/quiet_progress.h"

namespace ew::registration {
namespace {

/// For r of a normal distribution and c = 3 deviations: variance over the robustly weighted mean of r^2.
constexpr double kRobustBias = 1.38;

/// The last iteration in which noise and stiffness are measured: after it the energy is one, so that steps can be compared.
constexpr int kMeasured = 2;

double priorEnergy(const NodeGrid& grid, const Prior& prior, const NodeValues& values) {
  NodeValues stiff;
  applyPrior(grid, prior, values, stiff);
  double sum = 0.0;
  for (std::size_t n = 0; n < values.size(); ++n) sum += static_cast<double>(values[n]) * static_cast<double>(stiff[n]);
  return 0.5 * sum;
}

Prior scaled(Prior prior, double by) {
  prior.membrane *= by;
  prior.bending *= by;
  return prior;
}

/// Displacement components the images decide rather than the prior: the trace of (H + P)^-1 H, by the answer to one vector of signs.
double decidedByData(const NodeSystem& system, double dataWeight, const Prior& prior, double tolerance, int atMost, int threads) {
  NodeValues signs(4 * system.grid.count(), 0.0F), seen(signs.size(), 0.0F);
  std::uint32_t random = 0x9E3779B9U;
  for (std::size_t n = 0; n < signs.size(); ++n) {
    random ^= random << 13;
    random ^= random >> 17;
    random ^= random << 5;
    if (n % 4 != 3) signs[n] = (random & 1024U) != 0 ? 1.0F : -1.0F;
  }
  multiplyData(system, dataWeight, signs, seen);
  const Solution answer = solve(system, dataWeight, prior, seen, tolerance, atMost, threads);
  double sum = 0.0;
  for (std::size_t n = 0; n < signs.size(); ++n) sum += static_cast<double>(signs[n]) * static_cast<double>(answer.values[n]);
  return sum;
}

/// What share of a bump around each node the prior decides: its energy over the prior's and the data's together. A bump of one
/// displacement component: 1 at the node, 1/2 at its neighbours along an axis, and so on.
std::vector<float> uncertaintyOf(const NodeSystem& system, double dataWeight, const Prior& prior) {
  const NodeGrid& grid = system.grid;
  constexpr double kBump[3] = {0.5, 1.0, 0.5};
  // The prior's energy of a bump far from any border.
  NodeGrid inside = grid;
  for (int axis = 0; axis < 3; ++axis) inside.dims[axis] = grid.dims[axis] > 1 ? 7 : 1;
  NodeValues bump(4 * inside.count(), 0.0F);
  const auto forEachNear = [&](const glm::ivec3& dims, const glm::ivec3& at, const auto& near) {
    for (int z = std::max(at.z - 1, 0); z <= std::min(at.z + 1, dims.z - 1); ++z) {
      for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, dims.y - 1); ++y) {
        for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, dims.x - 1); ++x)
          near(x, y, z, kBump[x - at.x + 1] * kBump[y - at.y + 1] * kBump[z - at.z + 1]);
      }
    }
  };
  forEachNear(inside.dims, inside.dims / 2,
              [&](int x, int y, int z, double weight) { bump[4 * inside.indexOf(x, y, z)] = static_cast<float>(weight); });
  const double stiff = 2.0 * priorEnergy(inside, prior, bump);
  std::vector<float> uncertainty(grid.count(), 1.0F), weight(grid.count(), 0.0F);
  for (int k = 0; k < grid.dims.z; ++k) {
    for (int j = 0; j < grid.dims.y; ++j) {
      for (int i = 0; i < grid.dims.x; ++i) {
        const glm::ivec3 at(i, j, k);
        forEachNear(grid.dims, at, [&](int x, int y, int z, double w) { weight[grid.indexOf(x, y, z)] = static_cast<float>(w); });
        double data = 0.0;
        forEachNear(grid.dims, at, [&](int x, int y, int z, double w) {
          const std::size_t node = grid.indexOf(x, y, z);
          for (std::size_t n = system.first[node]; n < system.first[node + 1]; ++n) {
            const float other = weight[system.neighbour[n]];
            if (other == 0.0F) continue;
            const float* block = system.blocks.data() + 16 * n;
            data += w * static_cast<double>(other) * static_cast<double>(block[0] + block[5] + block[10]) / 3.0;
          }
        });
        forEachNear(grid.dims, at, [&](int x, int y, int z, double) { weight[grid.indexOf(x, y, z)] = 0.0F; });
        uncertainty[grid.indexOf(i, j, k)] = static_cast<float>(stiff / (stiff + dataWeight * std::max(data, 0.0)));
      }
    }
  }
  return uncertainty;
}

CellCorners cornersOf(const NodeGrid& nodes, const NodeValues& values, int i, int j, int k) {
  CellCorners corner;
  for (int n = 0; n < 8; ++n) {
    const glm::ivec3 of(n & 1, n >> 1 & 1, n >> 2 & 1), at = glm::min(glm::ivec3(i, j, k) + of, nodes.dims - 1);
    const float* v = values.data() + 4 * nodes.indexOf(at.x, at.y, at.z);
    corner[static_cast<std::size_t>(n)] = glm::dvec3(of) * nodes.spacing_mm + glm::dvec3(v[0], v[1], v[2]);
  }
  return corner;
}

/// Whether the edges are so little changed that the determinant cannot fall below `least`: each column of the Jacobian differs from a
/// unit vector by at most e, so the determinant is at least 1 - 3e - 3e^2 - e^3.
bool plainlyAbove(const NodeGrid& nodes, const CellCorners& corner, double least) {
  double most = 0.0;
  constexpr int kEdges[12][3] = {{0, 1, 0}, {2, 3, 0}, {4, 5, 0}, {6, 7, 0}, {0, 2, 1}, {1, 3, 1},
                                 {4, 6, 1}, {5, 7, 1}, {0, 4, 2}, {1, 5, 2}, {2, 6, 2}, {3, 7, 2}};
  for (const auto& edge : kEdges) {
    glm::dvec3 e = corner[static_cast<std::size_t>(edge[1])] - corner[static_cast<std::size_t>(edge[0])];
    e[edge[2]] -= nodes.spacing_mm[edge[2]];
    const double relative = 1.0 / nodes.spacing_mm[edge[2]];
    most = std::max(most, glm::dot(e, e) * relative * relative);
  }
  const double e = std::sqrt(most);
  return 1.0 - e * (3.0 + e * (3.0 + e)) >= least;
}

template <class Cell>
void forEachCell(const NodeGrid& nodes, const Cell& cell) {
  const glm::ivec3 cells = nodes.cells();
  for (int k = 0; k < cells.z; ++k) {
    for (int j = 0; j < cells.y; ++j) {
      for (int i = 0; i < cells.x; ++i) cell(i, j, k);
    }
  }
}

bool allAbove(const NodeGrid& nodes, const NodeValues& values, double least) {
  const double scale = 1.0 / nodes.cellVolume_mm3();
  bool all = true;
  forEachCell(nodes, [&](int i, int j, int k) {
    if (!all) return;
    const CellCorners corner = cornersOf(nodes, values, i, j, k);
    all = plainlyAbove(nodes, corner, least) || determinantBound(corner, scale) >= least;
  });
  return all;
}

}  // namespace

NodeGrid nodesFor(const Grid& fixed, double node_mm) {
  NodeGrid nodes;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = fixed.dims[axis] * fixed.spacing_mm[axis];
    if (fixed.dims[axis] == 1) {
      nodes.dims[axis] = 1;
      nodes.spacing_mm[axis] = std::max(node_mm, extent);
      nodes.first_mm[axis] = 0.0;
      continue;
    }
    const int cells = std::max(1, static_cast<int>(std::lround(extent / node_mm)));
    nodes.dims[axis] = cells + 1;
    nodes.spacing_mm[axis] = extent / cells;
    nodes.first_mm[axis] = -0.5 * fixed.spacing_mm[axis];
  }
  return nodes;
}

double leastJacobianOf(const NodeGrid& nodes, const NodeValues& values) {
  const double scale = 1.0 / nodes.cellVolume_mm3();
  double least = std::numeric_limits<double>::infinity();
  forEachCell(nodes, [&](int i, int j, int k) { least = std::min(least, determinantBound(cornersOf(nodes, values, i, j, k), scale)); });
  return least;
}

bool unfold(const NodeGrid& nodes, double least, NodeValues& values) {
  const double scale = 1.0 / nodes.cellVolume_mm3();
  std::vector<char> touched(nodes.count());
  NodeValues before;
  for (int round = 0; round < 60; ++round) {
    std::fill(touched.begin(), touched.end(), 0);
    bool any = false;
    forEachCell(nodes, [&](int i, int j, int k) {
      const CellCorners corner = cornersOf(nodes, values, i, j, k);
      if (plainlyAbove(nodes, corner, least) || determinantBound(corner, scale) >= least) return;
      any = true;
      for (int n = 0; n < 8; ++n) {
        const glm::ivec3 at = glm::min(glm::ivec3(i, j, k) + glm::ivec3(n & 1, n >> 1 & 1, n >> 2 & 1), nodes.dims - 1);
        touched[nodes.indexOf(at.x, at.y, at.z)] = 1;
      }
    });
    if (!any) return true;
    before = values;
    for (int k = 0; k < nodes.dims.z; ++k) {
      for (int j = 0; j < nodes.dims.y; ++j) {
        for (int i = 0; i < nodes.dims.x; ++i) {
          const std::size_t at = nodes.indexOf(i, j, k);
          if (touched[at] == 0) continue;
          float sum[3] = {0.0F, 0.0F, 0.0F};
          int count = 0;
          const auto add = [&](int x, int y, int z) {
            if (x < 0 || y < 0 || z < 0 || x >= nodes.dims.x || y >= nodes.dims.y || z >= nodes.dims.z) return;
            const float* v = before.data() + 4 * nodes.indexOf(x, y, z);
            for (int c = 0; c < 3; ++c) sum[c] += v[c];
            ++count;
          };
          add(i - 1, j, k), add(i + 1, j, k), add(i, j - 1, k), add(i, j + 1, k), add(i, j, k - 1), add(i, j, k + 1);
          if (count == 0) continue;
          for (std::size_t c = 0; c < 3; ++c) values[4 * at + c] = 0.5F * (before[4 * at + c] + sum[c] / static_cast<float>(count));
        }
      }
    }
  }
  return allAbove(nodes, values, least);
}

namespace {

/// Gauss-Newton on one level. resources/docs/science/registration.md, "Elastic, three-dimensional", says what its energy is and why.
class LevelDescent {
 public:
  LevelDescent(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform, int iterations, Placed placed,
               const ElasticSettings& settings, int threads, const std::function<bool()>& outOfTime, ElasticState& state,
               Progress& progress);
  [[nodiscard]] LevelOutcome run();

 private:
  enum class Next {
    iterate,
    finish,
    giveUp  ///< without a field worth finishing: cancelled, or nothing to go by
  };

  [[nodiscard]] Next iterate(int iteration);
  [[nodiscard]] bool compare(int iteration, PairSums& sums);
  void measure(int iteration, const PairSums& sums);
  [[nodiscard]] Next takeHalfTheStep();
  void followEvidence();
  [[nodiscard]] Next takeStep();
  void finish();
  [[nodiscard]] Next cancelled();

  const LevelImage& fixed_;
  int iterations_;
  Placed placed_;
  const ElasticSettings& settings_;
  int threads_;
  const std::function<bool()>& outOfTime_;
  ElasticState& state_;
  Progress& progress_;
  QuietProgress quiet_;
  LevelPair pair_;
  double sampleVolume_;
  double finest_;
  double coarsest_;
  CostOptions cost_;
  double referenceWeight_ = 0.0;  ///< of the first iteration: what leaves the overlap must not make the energy smaller
  double dataWeight_ = 0.0;
  double lastEnergy_ = std::numeric_limits<double>::infinity();
  NodeValues lastValues_;
  NodeValues step_;
  NodeValues gradient_;
  Prior prior_;
  NodeSystem system_;
  NodeSystem evidence_;  ///< the system that was solved last
  bool evident_ = false;
  double stepScale_ = 1.0;
  int halvings_ = 0;
  LevelOutcome outcome_;
};

LevelDescent::LevelDescent(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform, int iterations, Placed placed,
                           const ElasticSettings& settings, int threads, const std::function<bool()>& outOfTime, ElasticState& state,
                           Progress& progress)
    : fixed_(fixed),
      iterations_(iterations),
      placed_(placed),
      settings_(settings),
      threads_(threads),
      outOfTime_(outOfTime),
      state_(state),
      progress_(progress),
      quiet_(progress),
      pair_(fixed, moving, transform, state.nodes, threads),
      sampleVolume_(fixed.spacing_mm.x * fixed.spacing_mm.y * fixed.spacing_mm.z),
      finest_(std::min({fixed.dims.x > 1 ? fixed.spacing_mm.x : 1e9, fixed.dims.y > 1 ? fixed.spacing_mm.y : 1e9,
                        fixed.dims.z > 1 ? fixed.spacing_mm.z : 1e9})),
      coarsest_(std::max({fixed.spacing_mm.x, fixed.spacing_mm.y, fixed.spacing_mm.z})),
      step_(state.values.size()),
      prior_(scaled(settings.prior, state.stiffness)),
      system_(state.nodes),
      evidence_(state.nodes) {
  cost_.scale = settings.robust * std::sqrt(state.noise);
  cost_.leastCommon = settings.leastCommon;
}

LevelOutcome LevelDescent::run() {
  for (int iteration = 0; iteration <= iterations_; ++iteration) {
    progress_.report(say<"Registering">(), static_cast<double>(iteration) / (iterations_ + 1));
    const Next next = iterate(iteration);
    if (next == Next::giveUp) return std::move(outcome_);
    if (next == Next::finish) break;
  }
  finish();
  return std::move(outcome_);
}

LevelDescent::Next LevelDescent::iterate(int iteration) {
  PairSums sums;
  if (!compare(iteration, sums)) return cancelled();
  if (!(sums.weight() > 0.0)) {
    outcome_.noOverlap = true;
    return Next::giveUp;
  }
  measure(iteration, sums);
  const double energy = 0.5 * dataWeight_ * referenceWeight_ * sums.meanCost() + priorEnergy(state_.nodes, prior_, state_.values);
  if (iteration > 3 && energy > lastEnergy_ * (1.0 + 1e-6)) return takeHalfTheStep();
  if (iteration == iterations_) return Next::finish;
  if (iteration > 3 && lastEnergy_ - energy < settings_.converged) return Next::finish;
  halvings_ = 0;
  stepScale_ = 1.0;
  lastEnergy_ = energy;
  lastValues_ = state_.values;
  if (outOfTime_()) {
    outcome_.timeUp = true;
    return Next::finish;
  }
  // Rounding alone gives the gradients some energy; structure of a hundredth of the window's deviation has a thousand times that.
  if (sums.at[12] < 1e-6 * sums.at[13]) {
    outcome_.singular = true;
    return Next::giveUp;
  }
  if (settings_.measureStiffness && iteration > 0 && iteration <= kMeasured) followEvidence();
  return takeStep();
}

/// The moving image as the field has it now, against the fixed one; in the last iteration only sums are wanted.
/// @return false when cancelled
bool LevelDescent::compare(int iteration, PairSums& sums) {
  if (!pair_.warp(state_.values, quiet_)) return false;
  if (iteration == 0 && placed_ == Placed::closely && !pair_.doubtShadows(state_.values, quiet_)) return false;
  if (iteration == 0 && placed_ != Placed::roughly && settings_.trustWindow_mm > 0.0 &&
      !pair_.trustAgreement(settings_.trustWindow_mm, settings_.trustLeast, settings_.trustPower, quiet_))
    return false;
  system_.clear();
  return pair_.assemble(cost_, iteration == iterations_ ? nullptr : &system_, sums, quiet_);
}

void LevelDescent::measure(int iteration, const PairSums& sums) {
  if (iteration == 0) {
    outcome_.correlationBefore = sums.correlation();
    referenceWeight_ = sums.weight();
  }
  outcome_.correlationAfter = sums.correlation();
  if (iteration > kMeasured || iteration == iterations_) return;
  if (sums.at[13] > 0.0) state_.noise = std::max(1e-4, kRobustBias * sums.at[14] / sums.at[13]);
  state_.independent_mm3 = sums.residualVolume(fixed_.dims) * sampleVolume_;
  dataWeight_ = settings_.evidence * sampleVolume_ / (state_.noise * state_.independent_mm3);
}

/// The last step went too far.
LevelDescent::Next LevelDescent::takeHalfTheStep() {
  if (++halvings_ > 2) {
    state_.values = lastValues_;
    return Next::finish;
  }
  stepScale_ *= 0.5;
  for (std::size_t n = 0; n < step_.size(); ++n) state_.values[n] = lastValues_[n] + static_cast<float>(stepScale_) * step_[n];
  if (!unfold(state_.nodes, settings_.leastJacobian, state_.values)) state_.values = lastValues_;
  return Next::iterate;
}

/// The stiffness under which the field found is as warped as the images' part of it should be.
void LevelDescent::followEvidence() {
  const double warped = 2.0 * priorEnergy(state_.nodes, {settings_.prior.membrane, settings_.prior.bending, 0.0, 0.0}, state_.values);
  outcome_.decided = decidedByData(system_, dataWeight_, prior_, settings_.solveTolerance, settings_.solveIterations, threads_);
  if (warped > 0.0 && outcome_.decided > 1.0)
    state_.stiffness = std::clamp(std::sqrt(state_.stiffness * outcome_.decided / warped), 0.1, 30.0);
  prior_ = scaled(settings_.prior, state_.stiffness);
}

LevelDescent::Next LevelDescent::takeStep() {
  applyPrior(state_.nodes, prior_, state_.values, gradient_);
  for (std::size_t n = 0; n < gradient_.size(); ++n) gradient_[n] = static_cast<float>(dataWeight_) * system_.right[n] - gradient_[n];
  const Solution solution = solve(system_, dataWeight_, prior_, gradient_, settings_.solveTolerance, settings_.solveIterations, threads_);
  if (solution.singular) {
    outcome_.singular = true;
    return Next::finish;
  }
  step_ = solution.values;
  std::swap(evidence_, system_);
  evident_ = true;
  double longest = 0.0;
  for (std::size_t n = 0; n < step_.size(); n += 4)
    longest = std::max(longest, static_cast<double>(step_[n] * step_[n] + step_[n + 1] * step_[n + 1] + step_[n + 2] * step_[n + 2]));
  longest = std::sqrt(longest);
  const double limit = settings_.longestStep_voxels * coarsest_;
  if (longest > limit) {
    for (float& s : step_) s *= static_cast<float>(limit / longest);
  }
  for (std::size_t n = 0; n < step_.size(); ++n) state_.values[n] += step_[n];
  // Half of a step may fold where neither the whole one nor none does, so every candidate is looked at.
  if (!unfold(state_.nodes, settings_.leastJacobian, state_.values)) state_.values = lastValues_;
  for (std::size_t n = 0; n < step_.size(); ++n) step_[n] = state_.values[n] - lastValues_[n];
  ++outcome_.iterations;
  return longest < 0.01 * finest_ ? Next::finish : Next::iterate;
}

void LevelDescent::finish() {
  if (evident_) outcome_.uncertainty = uncertaintyOf(evidence_, dataWeight_, prior_);
  const double correlation = std::clamp(outcome_.correlationAfter, 0.0, 0.999);
  outcome_.worth = -0.5 * referenceWeight_ * sampleVolume_ / state_.independent_mm3 * std::log(1.0 - correlation * correlation) -
                   priorEnergy(state_.nodes, settings_.prior, state_.values);
}

LevelDescent::Next LevelDescent::cancelled() {
  outcome_.cancelled = true;
  return Next::giveUp;
}

}  // namespace

LevelOutcome refineLevel(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform, int iterations, Placed placed,
                         const ElasticSettings& settings, int threads, const std::function<bool()>& outOfTime, ElasticState& state,
                         Progress& progress) {
  return LevelDescent(fixed, moving, transform, iterations, placed, settings, threads, outOfTime, state, progress).run();
}

}  // namespace ew::registration
