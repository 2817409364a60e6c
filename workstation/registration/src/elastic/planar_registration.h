#pragma once

#include <functional>
#include <vector>

#include "elastic/planar_equations.h"
#include "elastic/planar_image.h"
#include "elastic/planar_spline.h"
#include "ew/core/progress.h"
#include "ew/registration/verdict.h"

/// The engine of the two-dimensional registration: Gauss-Newton on one level of the pyramid.
namespace ew::registration {

/// One level of the pyramid.
struct PlanarLevel {
  double scale = 1.0;     ///< its pixels in pixels of the input, >= 1
  double node_mm = 6.0;   ///< distance of the lattice's nodes
  double firmness = 0.4;  ///< stiffness if all speckle were shared; it grows with 1 / (its correlation)^2
  double leastStiffness = 0.6;
  double mostStiffness = 15.0;
};

/// Lengths and weights, tuned on pairs of known truth that the published figures do not use; resources/docs/science/registration.md
/// explains them.
struct PlanarSettings {
  double window_mm = 6.0;    ///< deviation of the Gaussian window of the local normalisation
  float floor_grey = 12.0F;  ///< added to the local deviation
  double slope_mm = 0.4;     ///< at stiffness 1 a slope over this length weighs as much as the evidence
  double bending_mm = 3.0;   ///< the same of a curvature
  double brightness_mm = 6.0;
  double brightnessRidge = 0.05;
  double leastJacobian = 0.1;
  bool brightnessTerm = true;
  double stiffness = 0.0;  ///< 0: by the level and the speckle
  int iterations = 12;
  int threads = 1;
};

/// A pair of images at one level, comparable.
struct PlanarPair {
  PlanarImage fixed;
  PlanarImage moving;
};
[[nodiscard]] PlanarPair planarPair(const PlanarImage& fixed, const PlanarImage& moving, double scale, const PlanarSettings& settings);

/// Correlation of values, weighted; and how many independent samples there are behind it.
struct PlanarAgreement {
  double correlation = 0.0;
  double weight = 0.0;       ///< sum of the weights
  double independent = 0.0;  ///< samples left when neighbours' likeness is taken into account
};
[[nodiscard]] PlanarAgreement planarAgreement(const PlanarPair& pair, const std::vector<float>& ux, const std::vector<float>& uy);

/// The whole-pixel shift of this level with the highest correlation, not farther than `reach_mm`; {0, 0} when nothing stands out.
[[nodiscard]] glm::dvec2 commonShift_mm(const PlanarPair& pair, double reach_mm);

struct PlanarState {
  SplineAxis x;
  SplineAxis y;
  PlanarField field;
  double coherence = 0.5;  ///< of the gradients, at the last iteration: 1 the same speckle, 0 nothing in common
  double stiffness = 0.0;
  double cost = 0.0;  ///< mean robust squared residual and energy, of the last iteration
  double residualRms = 0.0;
  double smallestJacobian = 1.0;
  int iterations = 0;
  StopReason stop = StopReason::notRun;
};

/// @return false when cancelled
bool refinePlanar(const PlanarPair& pair, const PlanarLevel& level, const PlanarSettings& settings, PlanarState& state, Progress& progress);

/// Smallest determinant over the cells between samples, exact for the bilinear field through them.
[[nodiscard]] double smallestJacobian(const std::vector<float>& ux, const std::vector<float>& uy, int width, int height, double pixelX_mm,
                                      double pixelY_mm);

}  // namespace ew::registration
