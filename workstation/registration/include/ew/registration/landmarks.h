#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/registration/remark.h"
#include "ew/registration/verdict.h"

namespace ew::registration {

/// The same anatomical place seen in both subvolumes.
struct LandmarkPair {
  std::string name;
  glm::dvec3 fixed_mm{0.0};
  glm::dvec3 moving_mm{0.0};
  bool operator==(const LandmarkPair&) const = default;
};

struct LandmarkOptions {
  double pickError_mm = 1.0;  ///< how well a person hits the place, per point and axis, > 0: sets what counts as outlying
  bool robust = true;         ///< weigh outlying pairs down after the closed form; false: closed form alone
};

struct LandmarkResult {
  Verdict verdict = Verdict::cannotTell;
  Message reason;  ///< names collinear, coincident, too few or outlying pairs, by their names: messageOf(remarks)
  std::vector<Remark> remarks;
  Transform<frame::Moving, frame::Fixed> fixedToMoving = {};  ///< rigid, no mirror; meaningful unless the verdict is cannotTell
  std::vector<double> residual_mm;                            ///< one per pair, at the transform
  std::vector<double> weight;                                 ///< one per pair, 0..1; below 1/2 it is outlying
  std::vector<std::size_t> outlying;                          ///< indices
  std::vector<std::size_t> coincident;                        ///< indices of pairs that repeat another one's place
  bool collinear = false;                                     ///< all places on one line: the turn about it is free
  double rms_mm = 0.0;                                        ///< over pairs that are not outlying
  double expectedError_mm = 0.0;  ///< target registration error at the centroid's far side, from pickError_mm (or the residuals when they
                                  ///< say more) and the pairs' spread; infinite when the turn is free
  double conditioning = 0.0;      ///< second singular value over the first of the scattered places: 0 collinear, 1 round
  StopReason stop = StopReason::notRun;
};

/// Rigid transform from pairs of landmarks: closed form, then reweighted by a robust loss.
/// Source: Arun, Huang, Blostein, IEEE PAMI 9(5), 1987, with Umeyama's (1991) guard against mirrors; expected error after Fitzpatrick,
/// West, Maurer, IEEE TMI 17(5), 1998, equation 46.
/// @error badField (a coordinate that is not finite, pickError_mm not > 0)
[[nodiscard]] Result<LandmarkResult> registerLandmarks(std::span<const LandmarkPair> pairs, const LandmarkOptions& options = {});

}  // namespace ew::registration
