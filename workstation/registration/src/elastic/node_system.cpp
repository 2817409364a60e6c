#include "elastic/node_system.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "elastic/rows.h"
#include "ew/core/contract.h"
#include "ew/core/parallel.h"

namespace ew::registration {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kWorthThreads = 4000;  // nodes: below it a product takes less than waking somebody
constexpr std::size_t kPieces = 4;           // of a product for each thread, so that all end together

/// Calls work(first, last) for pieces of 0 .. items, which must not depend on one another.
template <class Work>
void inPieces(std::size_t items, int threads, const Work& work) {
  if (threads <= 1) return work(std::size_t{0}, items);
  const std::size_t pieces = std::min(items, kPieces * static_cast<std::size_t>(threads));
  std::atomic<std::size_t> next{0};
  callOnThreads(static_cast<int>(pieces), threads, [&](int) {
    const std::size_t piece = next++;
    work(piece * items / pieces, (piece + 1) * items / pieces);
  });
}

/// Adds the forces of squared differences to `out`, for a row of nodes at once.
class RowForces {
 public:
  RowForces(const NodeGrid& grid, const NodeValues& values, NodeValues& out)
      : values_(values.data()), out_(out.data()), forces_(4 * static_cast<std::size_t>(grid.dims.x)) {}

  /// @param first node of the row's first difference
  /// @param offset of the others from it, as many as `factor` has
  /// @param count differences, from node to node along x
  /// @param weight of a squared difference of each component
  template <std::size_t kNodes>
  void add(std::size_t first, const std::array<std::size_t, kNodes>& offset, const std::array<float, kNodes>& factor, int count,
           const std::array<float, 4>& weight) {
    float* __restrict forces = forces_.data();
    if (count <= 0) return;
    const std::size_t floats = 4 * static_cast<std::size_t>(count);
    std::array<const float*, kNodes> from;
    for (std::size_t n = 0; n < kNodes; ++n) from[n] = values_ + 4 * (first + offset[n]);
    for (std::size_t s = 0; s < floats; s += 4) {
      for (std::size_t c = 0; c < 4; ++c) {
        float sum = 0.0F;
        for (std::size_t n = 0; n < kNodes; ++n) sum += factor[n] * from[n][s + c];
        forces[s + c] = weight[c] * sum;
      }
    }
    for (std::size_t n = 0; n < kNodes; ++n) {
      float* __restrict to = out_ + 4 * (first + offset[n]);
      for (std::size_t s = 0; s < floats; ++s) to[s] += factor[n] * forces[s];
    }
  }

 private:
  const float* values_;
  float* out_;
  std::vector<float> forces_;
};

/// Diagonalises the prior as if the second differences were those of a free membrane's Laplacian squared: exact for the membrane, near
/// for the bending term.
class Preconditioner {
 public:
  Preconditioner(const NodeGrid& grid, const Prior& prior, const std::array<double, 4>& data) : dims_(grid.dims) {
    std::array<std::vector<double>, 3> eigen;
    for (int axis = 0; axis < 3; ++axis) {
      const int n = dims_[axis];
      std::vector<float>& basis = basis_[static_cast<std::size_t>(axis)];
      basis.resize(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
      for (int m = 0; m < n; ++m) {
        for (int x = 0; x < n; ++x)
          basis[static_cast<std::size_t>(m * n + x)] =
              static_cast<float>(std::sqrt((m == 0 ? 1.0 : 2.0) / n) * std::cos(kPi * m * (x + 0.5) / n));
        eigen[static_cast<std::size_t>(axis)].push_back((2.0 - 2.0 * std::cos(kPi * m / n)) /
                                                        (grid.spacing_mm[axis] * grid.spacing_mm[axis]));
      }
    }
    const double volume = grid.cellVolume_mm3();
    for (std::size_t k = 0; k < eigen[2].size(); ++k) {
      for (std::size_t j = 0; j < eigen[1].size(); ++j) {
        for (std::size_t i = 0; i < eigen[0].size(); ++i) {
          const double laplace = eigen[0][i] + eigen[1][j] + eigen[2][k];
          const double stiff = volume * (prior.membrane * laplace + prior.bending * laplace * laplace);
          for (std::size_t c = 0; c < 3; ++c) inverse_.push_back(static_cast<float>(1.0 / (data[c] + stiff)));
          inverse_.push_back(static_cast<float>(1.0 / (data[3] + volume * (prior.brightnessMembrane * laplace + prior.brightness))));
        }
      }
    }
  }

  void apply(const NodeValues& in, int threads, NodeValues& out) const {
    out = in;
    for (int axis = 0; axis < 3; ++axis) transform(axis, false, threads, out);
    for (std::size_t n = 0; n < out.size(); ++n) out[n] *= inverse_[n];
    for (int axis = 0; axis < 3; ++axis) transform(axis, true, threads, out);
  }

 private:
  void transform(int axis, bool back, int threads, NodeValues& values) const {
    const auto n = static_cast<std::size_t>(dims_[axis]);
    if (n == 1) return;
    const std::size_t inner = 4 * static_cast<std::size_t>(axis == 0 ? 1 : axis == 1 ? dims_.x : dims_.x * dims_.y);
    // Columns of kWide floats, and of the 4 of one node where an odd number is left.
    const std::size_t wide = inner / kWide, columns = wide + (inner - wide * kWide) / 4, slabs = values.size() / (inner * n);
    inPieces(slabs * columns, threads, [&](std::size_t first, std::size_t last) {
      std::vector<float> made(kWide * n);
      for (std::size_t column = first; column < last; ++column) {
        const std::size_t at = column % columns;
        float* slab = values.data() + column / columns * inner * n;
        if (at < wide)
          transformColumn<kWide>(axis, back, slab + at * kWide, inner, made.data());
        else
          transformColumn<4>(axis, back, slab + wide * kWide + 4 * (at - wide), inner, made.data());
      }
    });
  }

  /// `kFloats` beside each other, whose rows along the axis are `stride` apart: their sums stay in registers.
  /// @param made scratch memory for all of them
  template <std::size_t kFloats>
  void transformColumn(int axis, bool back, float* __restrict column, std::size_t stride, float* __restrict made) const {
    const auto n = static_cast<std::size_t>(dims_[axis]);
    const float* const basis = basis_[static_cast<std::size_t>(axis)].data();
    const std::size_t perRow = back ? 1 : n, perColumn = back ? n : 1;
    for (std::size_t m = 0; m < n; ++m) {
      float sums[kFloats] = {};
      for (std::size_t x = 0; x < n; ++x) {
        const float factor = basis[m * perRow + x * perColumn];
        for (std::size_t f = 0; f < kFloats; ++f) sums[f] += factor * column[x * stride + f];
      }
      for (std::size_t f = 0; f < kFloats; ++f) made[m * kFloats + f] = sums[f];
    }
    for (std::size_t m = 0; m < n; ++m)
      for (std::size_t f = 0; f < kFloats; ++f) column[m * stride + f] = made[m * kFloats + f];
  }

  static constexpr std::size_t kWide = 16;
  glm::ivec3 dims_;
  std::array<std::vector<float>, 3> basis_;
  std::vector<float> inverse_;
};

/// One row of 4 x 4 blocks times x.
void multiplyBlocks(const float* blocks, const std::size_t* nodes, std::size_t count, const float* x, float* out) {
  float sums[16] = {};
  for (std::size_t n = 0; n < count; ++n, blocks += 16) {
    const float* v = x + 4 * nodes[n];
    for (std::size_t m = 0; m < 16; ++m) sums[m] += blocks[m] * v[m / 4];
  }
  for (std::size_t c = 0; c < 4; ++c) out[c] = (sums[c] + sums[4 + c]) + (sums[8 + c] + sums[12 + c]);
}

void multiplyRows(const NodeSystem& system, float factor, const NodeValues& in, std::size_t first, std::size_t last, NodeValues& out) {
  for (std::size_t n = first; n < last; ++n) {
    float sum[4];
    multiplyBlocks(system.blocks.data() + 16 * system.first[n], system.neighbour.data() + system.first[n],
                   system.first[n + 1] - system.first[n], in.data(), sum);
    for (std::size_t c = 0; c < 4; ++c) out[4 * n + c] = factor * sum[c];
  }
}

double dot(const NodeValues& a, const NodeValues& b) {
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += static_cast<double>(a[n]) * static_cast<double>(b[n]);
  return sum;
}

}  // namespace

void applyPrior(const NodeGrid& grid, const Prior& prior, const NodeValues& values, NodeValues& out) {
  out.assign(values.size(), 0.0F);
  RowForces forces(grid, values, out);
  const std::array<std::size_t, 3> step{1, static_cast<std::size_t>(grid.dims.x),
                                        static_cast<std::size_t>(grid.dims.x) * static_cast<std::size_t>(grid.dims.y)};
  const double volume = grid.cellVolume_mm3();
  const glm::dvec3 perSpacing2 = 1.0 / (grid.spacing_mm * grid.spacing_mm);
  const auto weights = [&](double displacement, double brightness, double per) {
    const auto u = static_cast<float>(volume * displacement * per), b = static_cast<float>(volume * brightness * per);
    return std::array<float, 4>{u, u, u, b};
  };
  for (int k = 0; k < grid.dims.z; ++k) {
    for (int j = 0; j < grid.dims.y; ++j) {
      const std::size_t row = grid.indexOf(0, j, k);
      /// Differences of the row that reach `far` nodes along each axis; below 1: none.
      const auto count = [&](const glm::ivec3& far) {
        return j + far.y < grid.dims.y && k + far.z < grid.dims.z ? grid.dims.x - far.x : 0;
      };
      for (int a = 0; a < 3; ++a) {
        glm::ivec3 reach(0);
        reach[a] = 1;
        const std::size_t along = step[static_cast<std::size_t>(a)];
        forces.add<2>(row, {0, along}, {-1.0F, 1.0F}, count(reach), weights(prior.membrane, prior.brightnessMembrane, perSpacing2[a]));
        if (prior.bending <= 0.0) continue;
        forces.add<3>(row, {0, along, 2 * along}, {1.0F, -2.0F, 1.0F}, count(2 * reach),
                      weights(prior.bending, 0.0, perSpacing2[a] * perSpacing2[a]));
        for (int b = a + 1; b < 3; ++b) {
          glm::ivec3 both = reach;
          both[b] = 1;
          const std::size_t across = step[static_cast<std::size_t>(b)];
          forces.add<4>(row, {0, along, across, along + across}, {1.0F, -1.0F, -1.0F, 1.0F}, count(both),
                        weights(2.0 * prior.bending, 0.0, perSpacing2[a] * perSpacing2[b]));
        }
      }
    }
  }
  const auto own = static_cast<float>(prior.brightness * volume);
  for (std::size_t n = 3; n < values.size(); n += 4) out[n] += own * values[n];
}

NodeSystem::NodeSystem(const NodeGrid& nodes) : grid(nodes) {
  first.push_back(0);
  for (int k = 0; k < grid.dims.z; ++k) {
    for (int j = 0; j < grid.dims.y; ++j) {
      for (int i = 0; i < grid.dims.x; ++i) {
        for (int z = std::max(k - 1, 0); z <= std::min(k + 1, grid.dims.z - 1); ++z) {
          for (int y = std::max(j - 1, 0); y <= std::min(j + 1, grid.dims.y - 1); ++y) {
            for (int x = std::max(i - 1, 0); x <= std::min(i + 1, grid.dims.x - 1); ++x) neighbour.push_back(grid.indexOf(x, y, z));
          }
        }
        first.push_back(neighbour.size());
      }
    }
  }
  blocks.assign(16 * neighbour.size(), 0.0F);
  right.assign(4 * grid.count(), 0.0F);
}

void NodeSystem::clear() {
  std::fill(blocks.begin(), blocks.end(), 0.0F);
  std::fill(right.begin(), right.end(), 0.0F);
}

void NodeSystem::addCell(const glm::ivec3& cell, const float* products, const float* rights, float scale) {
  const float root = std::sqrt(scale);
  // What two corners share depends on how many of them lie on the upper side along each axis: 27 blocks for 64 pairs.
  std::array<std::array<float, 16>, 27> shared;
  for (std::size_t kind = 0; kind < shared.size(); ++kind) {
    const float* p = products + kind * kProducts;
    const float xx = scale * p[0], xy = scale * p[1], xz = scale * p[2], x1 = root * p[3], yy = scale * p[4], yz = scale * p[5],
                y1 = root * p[6], zz = scale * p[7], z1 = root * p[8], one = p[9];
    shared[kind] = {xx, xy, xz, x1, xy, yy, yz, y1, xz, yz, zz, z1, x1, y1, z1, one};
  }
  // An axis with one node has no upper corner.
  const glm::ivec3 corners = glm::min(grid.dims, glm::ivec3(2));
  for (int a = 0; a < 8; ++a) {
    const glm::ivec3 of(a & 1, a >> 1 & 1, a >> 2 & 1);
    if (of.x >= corners.x || of.y >= corners.y || of.z >= corners.z) continue;
    const glm::ivec3 at = cell + of;
    const std::size_t node = grid.indexOf(at.x, at.y, at.z);
    const float* sum = rights + 4 * static_cast<std::ptrdiff_t>((of.x * 2 + of.y) * 2 + of.z);
    for (std::size_t c = 0; c < 4; ++c) right[4 * node + c] += sum[c];
    // Where the neighbours of this node start and how many it has along x and y.
    const glm::ivec3 low = glm::max(at - 1, glm::ivec3(0)), high = glm::min(at + 1, grid.dims - 1);
    const int wide = high.x - low.x + 1, tall = high.y - low.y + 1;
    for (int b = 0; b < 8; ++b) {
      const glm::ivec3 to(b & 1, b >> 1 & 1, b >> 2 & 1);
      if (to.x >= corners.x || to.y >= corners.y || to.z >= corners.z) continue;
      const glm::ivec3 other = cell + to - low;
      float* __restrict block = blocks.data() + 16 * (first[node] + static_cast<std::size_t>((other.z * tall + other.y) * wide + other.x));
      const glm::ivec3 kind = of + to;
      const std::array<float, 16>& whole = shared[static_cast<std::size_t>((kind.x * 3 + kind.y) * 3 + kind.z)];
      for (std::size_t n = 0; n < 16; ++n) block[n] += whole[n];
    }
  }
}

void multiplyData(const NodeSystem& system, double weight, const NodeValues& in, NodeValues& out) {
  multiplyRows(system, static_cast<float>(weight), in, 0, system.grid.count(), out);
}

Solution solve(const NodeSystem& system, double dataWeight, const Prior& prior, const NodeValues& right, double tolerance, int atMost,
               int threads) {
  const std::size_t nodes = system.grid.count();
  EW_EXPECTS(right.size() == 4 * nodes);
  if (nodes < kWorthThreads) threads = 1;
  Solution solution;
  solution.values.assign(right.size(), 0.0F);
  // A smooth field sees all blocks of a node at once: their sum stands for the data in the preconditioner.
  std::array<double, 4> data{};
  for (std::size_t n = 0; n < system.blocks.size(); n += 16) {
    for (std::size_t c = 0; c < 4; ++c) data[c] += static_cast<double>(system.blocks[n + 5 * c]);
  }
  const double mean = (data[0] + data[1] + data[2]) * dataWeight / (3.0 * static_cast<double>(nodes));
  for (double& d : data) d *= dataWeight / static_cast<double>(nodes);
  for (std::size_t c = 0; c < 3; ++c) data[c] = std::max(data[c], 1e-3 * mean);
  if (!(mean > 0.0) || !std::isfinite(mean)) {
    solution.singular = true;
    return solution;
  }
  if (!(data[3] + prior.brightness > 0.0)) data[3] = 1.0;
  const Preconditioner preconditioner(system.grid, prior, data);
  NodeValues residual = right, direction, product(right.size()), stiff, preconditioned;
  const auto multiply = [&](const NodeValues& x) {
    // The prior is one piece, the rows of the data are the others.
    const std::size_t pieces = threads <= 1 ? 1 : kPieces * static_cast<std::size_t>(threads);
    inPieces(pieces + 1, threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t piece = first; piece < last; ++piece) {
        if (piece == 0)
          applyPrior(system.grid, prior, x, stiff);
        else
          multiplyRows(system, static_cast<float>(dataWeight), x, (piece - 1) * nodes / pieces, piece * nodes / pieces, product);
      }
    });
    for (std::size_t n = 0; n < stiff.size(); ++n) product[n] += stiff[n];
  };
  preconditioner.apply(residual, threads, preconditioned);
  direction = preconditioned;
  double rho = dot(residual, preconditioned);
  const double start = rho;
  if (!(start > 0.0)) return solution;
  for (; solution.iterations < atMost; ++solution.iterations) {
    multiply(direction);
    const double curvature = dot(direction, product);
    if (!(curvature > 0.0)) {
      solution.singular = true;
      break;
    }
    const auto step = static_cast<float>(rho / curvature);
    for (std::size_t n = 0; n < residual.size(); ++n) {
      solution.values[n] += step * direction[n];
      residual[n] -= step * product[n];
    }
    preconditioner.apply(residual, threads, preconditioned);
    const double next = dot(residual, preconditioned);
    solution.residual = std::sqrt(std::max(next, 0.0) / start);
    if (solution.residual < tolerance) {
      ++solution.iterations;
      break;
    }
    const auto turn = static_cast<float>(next / rho);
    rho = next;
    for (std::size_t n = 0; n < direction.size(); ++n) direction[n] = preconditioned[n] + turn * direction[n];
  }
  return solution;
}

}  // namespace ew::registration
