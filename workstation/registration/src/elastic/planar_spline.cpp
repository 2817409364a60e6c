#include "elastic/planar_spline.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ew::registration {
namespace {

std::array<double, 4> splines(double t) {
  const double s = 1.0 - t;
  return {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, t * t * t / 6.0};
}
std::array<double, 4> slopes(double t) {
  const double s = 1.0 - t;
  return {-s * s / 2.0, (3.0 * t * t - 4.0 * t) / 2.0, -(3.0 * s * s - 4.0 * s) / 2.0, t * t / 2.0};
}
std::array<double, 4> curvatures(double t) { return {1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t}; }

/// Rows: places spread evenly over the extent; columns: nodes.
Eigen::MatrixXd shapes(const SplineAxis& axis, int places) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(places, axis.nodes());
  for (int p = 0; p < places; ++p) {
    const double at = (p + 0.5) * axis.cells / places;
    const int cell = std::clamp(static_cast<int>(at), 0, axis.cells - 1);
    const auto w = splines(at - cell);
    for (int a = 0; a < 4; ++a) matrix(p, cell + a) = w[static_cast<std::size_t>(a)];
  }
  return matrix;
}

Eigen::MatrixXd carry(const SplineAxis& from, const SplineAxis& to) {
  const int places = 4 * std::max(from.cells, to.cells) + 8;
  const Eigen::MatrixXd a = shapes(to, places);
  return (a.transpose() * a).ldlt().solve(a.transpose() * shapes(from, places));
}

}  // namespace

SplineAxis splineAxis(double extent_mm, double node_mm, double sample_mm, int samples) {
  SplineAxis axis;
  axis.extent_mm = extent_mm;
  axis.cells = std::max(1, static_cast<int>(std::ceil(extent_mm / node_mm - 1e-9)));
  axis.node_mm = extent_mm / axis.cells;
  axis.sample_mm = sample_mm;
  axis.samples = samples;
  axis.cellBegin.assign(static_cast<std::size_t>(axis.cells) + 1, samples);
  for (auto& list : axis.weight) list.resize(static_cast<std::size_t>(samples));
  for (auto& list : axis.pair) list.resize(static_cast<std::size_t>(samples));
  int known = 0;  // cells whose begin is set
  for (int n = 0; n < samples; ++n) {
    const double at = (n + 0.5) * sample_mm / axis.node_mm;
    const int cell = std::clamp(static_cast<int>(at), 0, axis.cells - 1);
    while (known <= cell) axis.cellBegin[static_cast<std::size_t>(known++)] = n;
    const auto w = splines(at - cell);
    std::size_t p = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      axis.weight[a][static_cast<std::size_t>(n)] = static_cast<float>(w[a]);
      for (std::size_t b = a; b < 4; ++b) axis.pair[p++][static_cast<std::size_t>(n)] = static_cast<float>(w[a] * w[b]);
    }
  }
  for (auto& list : axis.gram) list.assign(static_cast<std::size_t>(axis.nodes()), {});
  // Products of cubics are of degree six: four places of Gauss and Legendre are exact.
  constexpr std::array<double, 4> kPlace{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
  constexpr std::array<double, 4> kShare{0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  for (int cell = 0; cell < axis.cells; ++cell) {
    for (std::size_t q = 0; q < 4; ++q) {
      const double t = 0.5 * (1.0 + kPlace[q]);
      const std::array<std::array<double, 4>, 3> shape{splines(t), slopes(t), curvatures(t)};
      for (std::size_t order = 0; order < 3; ++order) {
        const double scale = 0.5 * kShare[q] * axis.node_mm / std::pow(axis.node_mm, 2.0 * static_cast<double>(order));
        for (std::size_t a = 0; a < 4; ++a)
          for (std::size_t b = 0; b < 4; ++b)
            axis.gram[order][static_cast<std::size_t>(cell) + a][b + 3 - a] += scale * shape[order][a] * shape[order][b];
      }
    }
  }
  return axis;
}

void evaluate(const SplineAxis& x, const SplineAxis& y, const Coefficients& coefficients, std::vector<float>& values) {
  values.resize(static_cast<std::size_t>(x.samples) * static_cast<std::size_t>(y.samples));
  std::vector<float> row(static_cast<std::size_t>(x.nodes()));
  for (int cellY = 0; cellY < y.cells; ++cellY) {
    const float* lattice = coefficients.data() + static_cast<std::ptrdiff_t>(cellY) * x.nodes();
    for (int sy = y.cellBegin[static_cast<std::size_t>(cellY)]; sy < y.cellBegin[static_cast<std::size_t>(cellY) + 1]; ++sy) {
      std::array<float, 4> w{};
      for (std::size_t a = 0; a < 4; ++a) w[a] = y.weight[a][static_cast<std::size_t>(sy)];
      for (int n = 0; n < x.nodes(); ++n)
        row[static_cast<std::size_t>(n)] =
            w[0] * lattice[n] + w[1] * lattice[n + x.nodes()] + w[2] * lattice[n + 2 * x.nodes()] + w[3] * lattice[n + 3 * x.nodes()];
      float* out = values.data() + static_cast<std::ptrdiff_t>(sy) * x.samples;
      for (int cellX = 0; cellX < x.cells; ++cellX) {
        const float* c = row.data() + cellX;
        const float c0 = c[0], c1 = c[1], c2 = c[2], c3 = c[3];
        const int end = x.cellBegin[static_cast<std::size_t>(cellX) + 1];
        const float *w0 = x.weight[0].data(), *w1 = x.weight[1].data(), *w2 = x.weight[2].data(), *w3 = x.weight[3].data();
        for (int sx = x.cellBegin[static_cast<std::size_t>(cellX)]; sx < end; ++sx)
          out[sx] = c0 * w0[sx] + c1 * w1[sx] + c2 * w2[sx] + c3 * w3[sx];
      }
    }
  }
}

Coefficients carriedOver(const SplineAxis& fromX, const SplineAxis& fromY, const Coefficients& coefficients, const SplineAxis& toX,
                         const SplineAxis& toY) {
  using Lattice = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Lattice> from(coefficients.data(), fromY.nodes(), fromX.nodes());
  const Eigen::MatrixXd to = carry(fromY, toY) * from.cast<double>() * carry(fromX, toX).transpose();
  Coefficients out(static_cast<std::size_t>(toX.nodes()) * static_cast<std::size_t>(toY.nodes()));
  Eigen::Map<Lattice>(out.data(), toY.nodes(), toX.nodes()) = to.cast<float>();
  return out;
}

}  // namespace ew::registration
