#pragma once

#include <array>
#include <vector>

/// Displacement and brightness on a lattice of cubic B-splines in the plane. Barber's nodes are joined by straight lines; the smoother
/// spline follows a warped tissue with half the nodes.
namespace ew::registration {

/// One axis: `cells` cells of the same length fill [0, extent_mm]; four splines reach into each.
struct SplineAxis {
  double extent_mm = 0.0;
  double node_mm = 1.0;
  double sample_mm = 1.0;
  int samples = 0;
  int cells = 0;
  std::vector<int> cellBegin;                ///< first sample of a cell, cells + 1 values
  std::array<std::vector<float>, 4> weight;  ///< of the cell's four splines at each sample
  std::array<std::vector<float>, 10> pair;   ///< products of two weights, (0,0) (0,1) .. (0,3) (1,1) .. (3,3)
  /// Integrals over the extent of products of splines (0), slopes (1) and curvatures (2): spline n with n - 3 .. n + 3.
  std::array<std::vector<std::array<double, 7>>, 3> gram;

  [[nodiscard]] int nodes() const { return cells + 3; }
};
/// @param node_mm wished for; the cells are made to fill the extent
[[nodiscard]] SplineAxis splineAxis(double extent_mm, double node_mm, double sample_mm, int samples);

/// Coefficients on a lattice of x.nodes() by y.nodes(), x fastest.
using Coefficients = std::vector<float>;

/// Values at all samples, x fastest.
void evaluate(const SplineAxis& x, const SplineAxis& y, const Coefficients& coefficients, std::vector<float>& values);

/// The least-squares fit of another lattice to what the first shows, over the same extent; exact when nodes are halved.
[[nodiscard]] Coefficients carriedOver(const SplineAxis& fromX, const SplineAxis& fromY, const Coefficients& coefficients,
                                       const SplineAxis& toX, const SplineAxis& toY);

}  // namespace ew::registration
