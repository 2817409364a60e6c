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
  const std::size_t width = static_cast<std::size_t>(x_.samples);
  // The weights of a sample side by side, as the sums want them.
  std::vector<float> pairs(width * kPadded, 0.0F), weights(width * 4);
  for (std::size_t n = 0; n < width; ++n) {
    for (std::size_t p = 0; p < kPairs; ++p) pairs[n * kPadded + p] = x_.pair[p][n];
    for (std::size_t a = 0; a < 4; ++a) weights[n * 4 + a] = x_.weight[a][n];
  }
  const float area = static_cast<float>(x_.sample_mm * y_.sample_mm);

  const auto addCells = [&](int cellY) {
    std::vector<CellSums> cells(static_cast<std::size_t>(x_.cells));
    std::vector<float> product(width * 9);
    const auto list = [&](std::size_t k) { return product.data() + k * width; };
    for (int sy = y_.cellBegin[static_cast<std::size_t>(cellY)]; sy < y_.cellBegin[static_cast<std::size_t>(cellY) + 1]; ++sy) {
      const std::size_t start = static_cast<std::size_t>(sy) * width;
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
      std::array<float, 4> wy{};
      std::array<float, kPairs> pairY{};
      for (std::size_t a = 0; a < 4; ++a) wy[a] = y_.weight[a][static_cast<std::size_t>(sy)];
      for (std::size_t p = 0; p < kPairs; ++p) pairY[p] = y_.pair[p][static_cast<std::size_t>(sy)];
      const std::size_t numbers = withBrightness_ ? kNumbers : 3, rights = withBrightness_ ? 3 : 2;
      for (int cellX = 0; cellX < x_.cells; ++cellX) {
        const int begin = x_.cellBegin[static_cast<std::size_t>(cellX)], end = x_.cellBegin[static_cast<std::size_t>(cellX) + 1];
        PlanarRowSums row;
        for (std::size_t k = 0; k < numbers; ++k) sumOver<kPadded>(pairs.data(), list(k), begin, end, row.pairs[k].data());
        for (std::size_t k = 0; k < rights; ++k) sumOver<4>(weights.data(), list(6 + k), begin, end, row.right[k].data());
        CellSums& cell = cells[static_cast<std::size_t>(cellX)];
        for (std::size_t k = 0; k < numbers; ++k)
          for (std::size_t p = 0; p < kPairs; ++p)
            for (std::size_t q = 0; q < kPadded; ++q) cell.pairs[k][p][q] += pairY[p] * row.pairs[k][q];
        for (std::size_t k = 0; k < rights; ++k)
          for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b) cell.right[k][a][b] += wy[a] * row.right[k][b];
      }
    }
    for (int cellX = 0; cellX < x_.cells; ++cellX) {
      const CellSums& cell = cells[static_cast<std::size_t>(cellX)];
      for (int a = 0; a < 4; ++a) {
        for (int i = 0; i < 4; ++i) {
          const std::size_t node =
              static_cast<std::size_t>(cellY + a) * static_cast<std::size_t>(x_.nodes()) + static_cast<std::size_t>(cellX + i);
          for (std::size_t k = 0; k < kNumbers; ++k) {
            float* to = coupling_.data() + (node * kNumbers + k) * kAround;
            for (int b = 0; b < 4; ++b) {
              const auto& from = cell.pairs[k][static_cast<std::size_t>(kPairOf[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)])];
              float* line = to + (b - a + 3) * kLine + 3 - i;
              for (int j = 0; j < 4; ++j)
                line[j] += from[static_cast<std::size_t>(kPairOf[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)])];
            }
          }
          for (std::size_t k = 0; k < 3; ++k)
            right_[node * 3 + k] += cell.right[k][static_cast<std::size_t>(a)][static_cast<std::size_t>(i)];
        }
      }
    }
  };
  // Rows of cells four apart share no node: each of four rounds may run in any order, and every node is added to in the order of the
  // rounds.
  for (int round = 0; round < 4 && round < y_.cells; ++round) {
    const int tasks = (y_.cells - round + 3) / 4;
    if (!forEachTask(tasks, threads, progress, "Comparing", [&](int task) { addCells(round + 4 * task); })) return false;
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
        const float* line = c + b * kLine;
        for (std::size_t a = 0; a < kLine; ++a) {
          sx[a] += line[a] * px[a] + line[kAround + a] * py[a] + line[3 * kAround + a] * pb[a];
          sy[a] += line[kAround + a] * px[a] + line[2 * kAround + a] * py[a] + line[4 * kAround + a] * pb[a];
          sb[a] += line[3 * kAround + a] * px[a] + line[4 * kAround + a] * py[a] + line[5 * kAround + a] * pb[a];
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
