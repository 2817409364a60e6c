#include "elastic/planar_equations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ew/core/parallel.h"

namespace ew::registration {
namespace {

constexpr int kSpan = 7;                ///< nodes a spline shares cells with, along an axis
constexpr int kLine = 8;                ///< floats for them, filled up to whole vectors with a zero
constexpr int kAround = kSpan * kLine;  ///< in the plane
constexpr int kOwn = 3 * kLine + 3;     ///< where a node's coupling to itself stands
constexpr int kNumbers = 6;             ///< of a symmetric 3 x 3 block
constexpr int kPairs = 10;              ///< of two of a cell's four splines, without order
constexpr int kPadded = 12;             ///< pairs, filled up to whole vectors
constexpr std::array<std::array<int, 4>, 4> kPairOf{{{0, 1, 2, 3}, {1, 4, 5, 6}, {2, 5, 7, 8}, {3, 6, 8, 9}}};

/// Sums over the samples of one row that lie in one cell.
struct PlanarRowSums {
  std::array<std::array<float, kPadded>, kNumbers> pairs{};
  std::array<std::array<float, 4>, 3> right{};
};
/// And over all samples of the cell.
struct CellSums {
  std::array<std::array<std::array<float, kPadded>, kPairs>, kNumbers> pairs{};
  std::array<std::array<std::array<float, 4>, 4>, 3> right{};
};

/// pairs * values, summed over [begin, end).
template <int width>
void sumOver(const float* pairs, const float* values, int begin, int end, float* out) {
  std::array<float, width> sum{};
  for (int n = begin; n < end; ++n) {
    const float v = values[n];
    const float* p = pairs + static_cast<std::ptrdiff_t>(n) * width;
    for (int k = 0; k < width; ++k) sum[static_cast<std::size_t>(k)] += p[k] * v;
  }
  for (int k = 0; k < width; ++k) out[k] = sum[static_cast<std::size_t>(k)];
}

/// The weights of an axis with those of a sample side by side, as sums over samples want them.
struct SideBySide {
  std::vector<float> pairs;    // kPadded a sample
  std::vector<float> weights;  // 4 a sample

  explicit SideBySide(const SplineAxis& x)
      : pairs(static_cast<std::size_t>(x.samples) * kPadded, 0.0F), weights(static_cast<std::size_t>(x.samples) * 4) {
    for (std::size_t n = 0; n < static_cast<std::size_t>(x.samples); ++n) {
      for (std::size_t p = 0; p < kPairs; ++p) pairs[n * kPadded + p] = x.pair[p][n];
      for (std::size_t a = 0; a < 4; ++a) weights[n * 4 + a] = x.weight[a][n];
    }
  }
};

/// Of one row of samples, weighted: products of gradient and 1 (xx xy yy xb yb bb), then these times the residual (x y b).
struct RowProducts {
  std::size_t width;
  std::vector<float> values;

  explicit RowProducts(std::size_t samples) : width(samples), values(samples * 9) {}
  [[nodiscard]] float* list(std::size_t k) { return values.data() + k * width; }
  void fill(const Linearised& data, std::size_t start, float area) {
    const float *gx = data.gradientX.data() + start, *gy = data.gradientY.data() + start;
    const float *r = data.residual.data() + start, *w = data.weight.data() + start;
    float *xx = list(0), *xy = list(1), *yy = list(2), *xb = list(3), *yb = list(4), *bb = list(5), *xr = list(6), *yr = list(7),
          *br = list(8);
    for (std::size_t n = 0; n < width; ++n) {
      const float weight = w[n] * area, ax = weight * gx[n], ay = weight * gy[n];
      xx[n] = ax * gx[n];
      xy[n] = ax * gy[n];
      yy[n] = ay * gy[n];
      xb[n] = ax;
      yb[n] = ay;
      bb[n] = weight;
      xr[n] = ax * r[n];
      yr[n] = ay * r[n];
      br[n] = weight * r[n];
    }
  }
};

/// The weights of one row of samples along y.
struct RowWeights {
  std::array<float, 4> single{};
  std::array<float, kPairs> pair{};

  RowWeights(const SplineAxis& y, std::size_t sample) {
    for (std::size_t a = 0; a < 4; ++a) single[a] = y.weight[a][sample];
    for (std::size_t p = 0; p < kPairs; ++p) pair[p] = y.pair[p][sample];
  }
};

/// Adds one row's part of a cell: its sums along x, spread over the row's weights along y.
void addRowTo(CellSums& cell, const PlanarRowSums& row, const RowWeights& across, std::size_t numbers, std::size_t rights) {
  for (std::size_t k = 0; k < numbers; ++k)
    for (std::size_t p = 0; p < kPairs; ++p)
      for (std::size_t q = 0; q < kPadded; ++q) cell.pairs[k][p][q] += across.pair[p] * row.pairs[k][q];
  for (std::size_t k = 0; k < rights; ++k)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b) cell.right[k][a][b] += across.single[a] * row.right[k][b];
}

/// The cells of one row of cells, each over its own samples alone: splines are products of one in x and one in y, so that a cell's 16 x 16
/// couplings are sums of 10 x 10 products of pairs.
std::vector<CellSums> sumsOfCells(const Linearised& data, const SplineAxis& x, const SplineAxis& y, const SideBySide& along, int cellY,
                                  bool withBrightness) {
  const std::size_t numbers = withBrightness ? kNumbers : 3, rights = withBrightness ? 3 : 2;
  const float area = static_cast<float>(x.sample_mm * y.sample_mm);
  std::vector<CellSums> cells(static_cast<std::size_t>(x.cells));
  RowProducts products(static_cast<std::size_t>(x.samples));
  for (int sy = y.cellBegin[static_cast<std::size_t>(cellY)]; sy < y.cellBegin[static_cast<std::size_t>(cellY) + 1]; ++sy) {
    products.fill(data, static_cast<std::size_t>(sy) * products.width, area);
    const RowWeights across(y, static_cast<std::size_t>(sy));
    for (int cellX = 0; cellX < x.cells; ++cellX) {
      const int begin = x.cellBegin[static_cast<std::size_t>(cellX)], end = x.cellBegin[static_cast<std::size_t>(cellX) + 1];
      PlanarRowSums row;
      for (std::size_t k = 0; k < numbers; ++k) sumOver<kPadded>(along.pairs.data(), products.list(k), begin, end, row.pairs[k].data());
      for (std::size_t k = 0; k < rights; ++k) sumOver<4>(along.weights.data(), products.list(6 + k), begin, end, row.right[k].data());
      addRowTo(cells[static_cast<std::size_t>(cellX)], row, across, numbers, rights);
    }
  }
  return cells;
}

/// Gives a cell's sums to the nodes of its 4 x 4 splines.
/// @param nodesAlong x
void addCell(const CellSums& cell, int cellX, int cellY, int nodesAlong, std::vector<float>& coupling, std::vector<float>& right) {
  for (int a = 0; a < 4; ++a) {
    for (int i = 0; i < 4; ++i) {
      const std::size_t node =
          static_cast<std::size_t>(cellY + a) * static_cast<std::size_t>(nodesAlong) + static_cast<std::size_t>(cellX + i);
      for (std::size_t k = 0; k < kNumbers; ++k) {
        float* to = coupling.data() + (node * kNumbers + k) * kAround;
        for (int b = 0; b < 4; ++b) {
          const auto& from = cell.pairs[k][static_cast<std::size_t>(kPairOf[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)])];
          float* line = to + (b - a + 3) * std::ptrdiff_t{kLine} + 3 - i;
          for (int j = 0; j < 4; ++j)
            line[j] += from[static_cast<std::size_t>(kPairOf[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)])];
        }
      }
      for (std::size_t k = 0; k < 3; ++k) right[node * 3 + k] += cell.right[k][static_cast<std::size_t>(a)][static_cast<std::size_t>(i)];
    }
  }
}

}  // namespace

PlanarEquations::PlanarEquations(const SplineAxis& x, const SplineAxis& y, bool withBrightness)
    : x_(x),
      y_(y),
      withBrightness_(withBrightness),
      nodes_(x.nodes() * y.nodes()),
      coupling_(static_cast<std::size_t>(nodes_) * kNumbers * kAround),
      right_(static_cast<std::size_t>(nodes_) * 3) {}

bool PlanarEquations::assemble(const Linearised& data, int threads, Progress& progress) {
  std::fill(coupling_.begin(), coupling_.end(), 0.0F);
  std::fill(right_.begin(), right_.end(), 0.0F);
  const SideBySide along(x_);
  // Rows of cells four apart share no node: each of four rounds may run in any order, and every node is added to in the order of the
  // rounds.
  for (int round = 0; round < 4 && round < y_.cells; ++round) {
    const int tasks = (y_.cells - round + 3) / 4;
    if (!forEachTask(tasks, threads, progress, say<"Comparing">(), [&](int task) {
          const int cellY = round + 4 * task;
          const std::vector<CellSums> cells = sumsOfCells(data, x_, y_, along, cellY, withBrightness_);
          for (int cellX = 0; cellX < x_.cells; ++cellX)
            addCell(cells[static_cast<std::size_t>(cellX)], cellX, cellY, x_.nodes(), coupling_, right_);
        }))
      return false;
  }
  return true;
}

void PlanarEquations::regularise(const Regulariser& energy, const PlanarField& field) {
  const int nx = x_.nodes(), ny = y_.nodes();
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const std::size_t node = static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
      std::array<double, 3> pull{};
      for (int dj = -3; dj <= 3; ++dj) {
        if (j + dj < 0 || j + dj >= ny) continue;
        const auto gy = [&](std::size_t order) { return y_.gram[order][static_cast<std::size_t>(j)][static_cast<std::size_t>(dj + 3)]; };
        for (int di = -3; di <= 3; ++di) {
          if (i + di < 0 || i + di >= nx) continue;
          const auto gx = [&](std::size_t order) { return x_.gram[order][static_cast<std::size_t>(i)][static_cast<std::size_t>(di + 3)]; };
          const double slope = gx(1) * gy(0) + gx(0) * gy(1);
          const double curvature = gx(2) * gy(0) + 2.0 * gx(1) * gy(1) + gx(0) * gy(2);
          const double ofMotion = energy.membrane * slope + energy.bending * curvature;
          const double ofBrightness =
              withBrightness_ ? energy.brightness * slope + energy.ridge * gx(0) * gy(0) : (di == 0 && dj == 0 ? 1.0 : 0.0);
          const std::size_t at = static_cast<std::size_t>((dj + 3) * kLine + di + 3);
          coupling_[(node * kNumbers + 0) * kAround + at] += static_cast<float>(ofMotion);
          coupling_[(node * kNumbers + 2) * kAround + at] += static_cast<float>(ofMotion);
          coupling_[(node * kNumbers + 5) * kAround + at] += static_cast<float>(ofBrightness);
          const std::size_t other = static_cast<std::size_t>(j + dj) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i + di);
          pull[0] += ofMotion * static_cast<double>(field.part[0][other]);
          pull[1] += ofMotion * static_cast<double>(field.part[1][other]);
          if (withBrightness_) pull[2] += ofBrightness * static_cast<double>(field.part[2][other]);
        }
      }
      for (std::size_t k = 0; k < 3; ++k) right_[node * 3 + k] -= static_cast<float>(pull[k]);
    }
  }
}

void PlanarEquations::multiply(const std::vector<float>& in, std::vector<float>& out) const {
  const int nx = x_.nodes(), ny = y_.nodes();
  // The vector as three planes with a border of three zeros, so that no coupling needs a test. A line reads one float further: a zero's.
  const std::size_t stride = static_cast<std::size_t>(nx) + 6, plane = stride * (static_cast<std::size_t>(ny) + 6);
  std::vector<float> padded(3 * plane + kLine, 0.0F);
  for (std::size_t j = 0; j < static_cast<std::size_t>(ny); ++j)
    for (std::size_t i = 0; i < static_cast<std::size_t>(nx); ++i)
      for (std::size_t k = 0; k < 3; ++k) padded[k * plane + (j + 3) * stride + i + 3] = in[(j * static_cast<std::size_t>(nx) + i) * 3 + k];
  out.resize(in.size());
  const auto total = [](const std::array<float, kLine>& v) { return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7])); };
  std::size_t node = 0;
  for (std::size_t j = 0; j < static_cast<std::size_t>(ny); ++j) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(nx); ++i, ++node) {
      const float* c = coupling_.data() + node * kNumbers * kAround;
      std::array<float, kLine> sx{}, sy{}, sb{};
      for (std::size_t b = 0; b < kSpan; ++b) {
        const float* px = padded.data() + (j + b) * stride + i;
        const float *py = px + plane, *pb = py + plane;
        const float *xx = c + b * kLine, *xy = xx + kAround, *yy = xy + kAround, *xb = yy + kAround, *yb = xb + kAround, *bb = yb + kAround;
        for (std::size_t a = 0; a < kLine; ++a) {
          sx[a] += xx[a] * px[a] + xy[a] * py[a] + xb[a] * pb[a];
          sy[a] += xy[a] * px[a] + yy[a] * py[a] + yb[a] * pb[a];
          sb[a] += xb[a] * px[a] + yb[a] * py[a] + bb[a] * pb[a];
        }
      }
      out[node * 3] = total(sx);
      out[node * 3 + 1] = total(sy);
      out[node * 3 + 2] = total(sb);
    }
  }
}

PlanarField PlanarEquations::solve(int iterations, double tolerance) const {
  const std::size_t count = right_.size();
  // Inverse of each node's own block; a block without evidence or stiffness leaves its node where it is.
  std::vector<std::array<double, 6>> inverse(static_cast<std::size_t>(nodes_));
  for (std::size_t node = 0; node < inverse.size(); ++node) {
    std::array<double, 6> m{};
    for (std::size_t k = 0; k < kNumbers; ++k) m[k] = static_cast<double>(coupling_[(node * kNumbers + k) * kAround + kOwn]);
    const double xx = m[0], xy = m[1], yy = m[2], xb = m[3], yb = m[4], bb = m[5];
    const double determinant = xx * (yy * bb - yb * yb) - xy * (xy * bb - yb * xb) + xb * (xy * yb - yy * xb);
    if (!(determinant > 1e-12 * xx * yy * bb) || !(xx > 0.0)) {
      inverse[node] = {xx > 0.0 ? 1.0 / xx : 0.0, 0.0, yy > 0.0 ? 1.0 / yy : 0.0, 0.0, 0.0, bb > 0.0 ? 1.0 / bb : 0.0};
      continue;
    }
    inverse[node] = {(yy * bb - yb * yb) / determinant, (xb * yb - xy * bb) / determinant, (xx * bb - xb * xb) / determinant,
                     (xy * yb - xb * yy) / determinant, (xy * xb - xx * yb) / determinant, (xx * yy - xy * xy) / determinant};
  }
  const auto precondition = [&](const std::vector<float>& in, std::vector<float>& out) {
    for (std::size_t node = 0; node < inverse.size(); ++node) {
      const auto& m = inverse[node];
      const double a = static_cast<double>(in[node * 3]), b = static_cast<double>(in[node * 3 + 1]),
                   c = static_cast<double>(in[node * 3 + 2]);
      out[node * 3] = static_cast<float>(m[0] * a + m[1] * b + m[3] * c);
      out[node * 3 + 1] = static_cast<float>(m[1] * a + m[2] * b + m[4] * c);
      out[node * 3 + 2] = static_cast<float>(m[3] * a + m[4] * b + m[5] * c);
    }
  };
  const auto dot = [&](const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t n = 0; n < count; ++n) sum += static_cast<double>(a[n]) * static_cast<double>(b[n]);
    return sum;
  };
  std::vector<float> x(count, 0.0F), r = right_, z(count), p(count), ap(count);
  precondition(r, z);
  p = z;
  double rz = dot(r, z);
  const double goal = tolerance * tolerance * rz;
  for (int n = 0; n < iterations && rz > goal && rz > 0.0; ++n) {
    multiply(p, ap);
    const double curvature = dot(p, ap);
    if (!(curvature > 0.0)) break;
    const float alpha = static_cast<float>(rz / curvature);
    for (std::size_t k = 0; k < count; ++k) {
      x[k] += alpha * p[k];
      r[k] -= alpha * ap[k];
    }
    precondition(r, z);
    const double next = dot(r, z);
    const float beta = static_cast<float>(next / rz);
    for (std::size_t k = 0; k < count; ++k) p[k] = z[k] + beta * p[k];
    rz = next;
  }
  PlanarField step;
  for (std::size_t k = 0; k < 3; ++k) {
    step.part[k].resize(static_cast<std::size_t>(nodes_));
    for (std::size_t node = 0; node < step.part[k].size(); ++node) step.part[k][node] = x[node * 3 + k];
  }
  return step;
}

}  // namespace ew::registration
