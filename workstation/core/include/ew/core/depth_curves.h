#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ew/core/progress.h"

namespace ew {

/// Value at a depth of a curve that is straight between knots `knot_mm` apart, the first at depth 0; level before the first and after the
/// last. An empty curve is 0 everywhere.
[[nodiscard]] double atDepth(std::span<const double> curve, double knot_mm, double depth_mm);

/// Something that two owners saw, each at its own depth: grey of the first less that of the second.
struct DepthDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double firstDepth_mm = 0.0;
  double secondDepth_mm = 0.0;
  double difference = 0.0;
  double weight = 1.0;
};

struct DepthCurveOptions {
  double knot_mm = 10.0;
  double smoothness = 0.02;  ///< how stiff a curve is where nothing says otherwise, as a share of the data's weight
  /// How much the curve that all owners of a group have in common is held at 0, as a share of the data's weight. It shows only where depths
  /// differ, so that a difference of another kind (a beam at the edge of a fan is weaker) may pass for it.
  double common = 0.0;
};

struct DepthCurves {
  std::size_t knots = 0;                  ///< of every curve
  std::vector<std::vector<double>> grey;  ///< one per owner: what is to be added to it
  double medianBefore = 0.0;              ///< size of the differences
  double medianAfter = 0.0;               ///< size of what is left of them
};

/// One smooth curve per owner, so that the sums of value and curve agree: least squares over all differences, each weighed down by its
/// residual (first Cauchy, then Geman and McClure), second differences of the curves kept small. What no difference tells, above all the
/// curve common to all owners, is taken as small as it can be. The longest curve is 1000 mm.
/// Cost: a dense symmetric system of owners x knots, a dozen times.
/// @return false when cancelled
[[nodiscard]] bool fitDepthCurves(std::span<const DepthDifference> differences, std::size_t owners, const DepthCurveOptions& options,
                                  const Progress& progress, DepthCurves& curves);

}  // namespace ew
