#pragma once

#include <array>
#include <vector>

#include "elastic/planar_spline.h"
#include "ew/core/progress.h"

namespace ew::registration {

/// One linearised comparison per sample: weight * (residual - gradient . du - db)^2, with du, db the change of displacement and brightness.
struct Linearised {
  std::vector<float> gradientX;  ///< per mm
  std::vector<float> gradientY;
  std::vector<float> residual;
  std::vector<float> weight;  ///< 0: no evidence
};

/// Energies of the whole displacement and brightness, per mm^2 of the plane.
struct Regulariser {
  double membrane = 0.0;    ///< times |slope of u|^2 (u in mm)
  double bending = 0.0;     ///< times |curvature of u|^2
  double brightness = 0.0;  ///< times |slope of b|^2
  double ridge = 0.0;       ///< times |b|^2
};

/// Displacement (0, 1; mm) and brightness (2) on one lattice.
struct PlanarField {
  std::array<Coefficients, 3> part;
};

/// Normal equations of one Gauss-Newton step on a lattice. For each node the couplings to the 7 x 7 nodes around it, in six numbers:
/// xx, xy, yy, xb, yb, bb.
class PlanarEquations {
 public:
  PlanarEquations(const SplineAxis& x, const SplineAxis& y, bool withBrightness);

  /// Sums the comparisons; the same bits for every number of threads.
  /// @return false when cancelled
  bool assemble(const Linearised& data, int threads, Progress& progress);
  /// Adds the energies of field + step, quadratic in the step.
  void regularise(const Regulariser& energy, const PlanarField& field);
  /// Conjugate gradients, each node's own 3 x 3 block as preconditioner.
  /// @return the step; zeros where the equations say nothing
  [[nodiscard]] PlanarField solve(int iterations, double tolerance) const;

  void multiply(const std::vector<float>& in, std::vector<float>& out) const;
  [[nodiscard]] const std::vector<float>& rightSide() const { return right_; }

 private:
  const SplineAxis& x_;
  const SplineAxis& y_;
  bool withBrightness_;
  int nodes_;
  std::vector<float> coupling_;  ///< [node][number][7][8]
  std::vector<float> right_;     ///< [node][3]
};

}  // namespace ew::registration
