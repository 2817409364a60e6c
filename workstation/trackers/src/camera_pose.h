#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/trackers/marker_body.h"

namespace ew {

/// A marker of a body and where its corners were seen.
struct MarkerObservation {
  const Marker* marker = nullptr;
  std::array<glm::dvec2, 4> rays{};      ///< (X/Z, Y/Z)
  std::array<glm::dvec2, 4> perBleed{};  ///< MarkerCorners::perBleed
  double spread_px = 0.0;                ///< standard deviation of a corner as measured
};

/// How far the sides of black squares seem to lie inside of where they were printed, in spreads of their edges: ink that runs, light that
/// blooms, grey levels that do not add up as light does. The same for a camera, its light and a printer; of one marker alone it cannot
/// be told from being further away (0.4 pixel are 4 mm at 600 mm), so it is carried on from where several markers tell it.
struct MarkerBleed {
  double value = 0.0;
  double deviation = 0.15;
};

/// One explanation of what is seen.
struct BodyHypothesis {
  glm::dmat4 bodyToCamera{1.0};
  double bleed = 0.0;
  std::vector<double> bulges_mm;  ///< of each face seen, outwards
  double misfit = 0.0;            ///< squares of the residuals over the corners' variances, each at most kMostMisfit
  double rms_px = 0.0;            ///< of the markers in use
};

struct BodyEstimate {
  BodyHypothesis best;
  std::optional<BodyHypothesis> other;  ///< another minimum, turned by more than a degree against the best
  double otherAngle_rad = 0.0;
  /// By how much the other fits worse, in units of the variance the best leaves: a difference of log-likelihoods, doubled.
  double evidence = 0.0;
  std::vector<double> residuals_px;          ///< of every observation, root mean square, to the best
  std::vector<bool> used;                    ///< observations that agree with the best
  int markers = 0;                           ///< of those
  double spread_mm = 0.0, spread_rad = 0.0;  ///< at the point asked for
  MarkerBleed bleed;                         ///< as it is known now
};

/// The pose of a body from corners of its markers, by the image alone.
/// @param focal_px     what turns rays to pixels
/// @param at_body      where the spread is asked for, mm
/// @param before       the last pose, one more place to begin from
/// @param bleed        as it is known before
/// Empty where nothing is seen or no start leads to a pose in front of the camera with every marker in use facing it.
[[nodiscard]] std::optional<BodyEstimate> estimateBody(const std::vector<MarkerObservation>& seen, double focal_px,
                                                       const glm::dvec3& at_body, const std::optional<glm::dmat4>& before,
                                                       const MarkerBleed& bleed);

/// Angle of the rotation between two poses.
[[nodiscard]] double angleBetween(const glm::dmat4& a, const glm::dmat4& b);
/// Outwards from the paper, unit.
[[nodiscard]] glm::dvec3 outwardOf(const Marker& marker);
[[nodiscard]] glm::dvec3 middleOf(const Marker& marker);

}  // namespace ew
