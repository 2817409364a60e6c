#include "doubts.h"

#include <Eigen/Dense>
#include <algorithm>

#include "translations.h"

namespace ew::registration {
namespace {

constexpr double kSlide_mm = 10.0;
constexpr double kLoose = 0.88;    // of the correlation, left after sliding
constexpr double kAsAlike = 0.85;  // of the correlation that a rival shows, and
constexpr double kAsSure = 0.6;    // of the significance
constexpr double kNearer = 2.0;    // times as far from the start as what was found, and
constexpr double kAnyway_mm = 4.0;
constexpr double kApart_mm = 4.0;  // nearer ones are the same
constexpr int kRivals = 12;

/// The largest share of the correlation that is left kSlide_mm along an axis of the normal equations, whichever way less is.
bool looseness(const PairLevels& pair, const Transform<frame::Moving, frame::Fixed>& found, const Evidence& evidence, int threads,
               Progress& progress, double& left) {
  const std::size_t at = pair.agreement;
  PoseSums sums;
  glm::dvec3 middle(0.0);
  if (!sumOverPair(pair.fixed[at], pair.packedMoving[at], found, middle, {0.0, 0, -1, false, false}, threads, progress, sums)) return false;
  left = 0.0;
  if (sums.count <= 0.0) return true;
  const double lever_mm = std::max(5.0, 0.5 * glm::length(sums.highest - sums.lowest) * pair.fixed[at].grid.spacing_mm.x);
  middle = carried(pair.fixed[at].grid.voxelTo<frame::Fixed>(), 0.5 * (sums.lowest + sums.highest));
  PassOptions pass;
  pass.derivatives = true;
  if (!sumOverPair(pair.fixed[at], pair.packedMoving[at], found, middle, pass, threads, progress, sums)) return false;
  Eigen::Matrix<double, 6, 6> normal;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) normal(r, c) = sums.normal[6 * r + c] / ((r < 3 ? 1.0 : lever_mm) * (c < 3 ? 1.0 : lever_mm));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(normal);
  for (int axis = 0; axis < 6; ++axis) {
    const Eigen::Matrix<double, 6, 1> step = kSlide_mm * eigen.eigenvectors().col(axis);
    double least = 1e9;
    for (const double way : {1.0, -1.0}) {
      const glm::dvec3 shift = way * glm::dvec3(step[0], step[1], step[2]);
      const glm::dvec3 turn = way / lever_mm * glm::dvec3(step[3], step[4], step[5]);
      Evidence there;
      if (!evidenceAt(pair, at, found * motionAbout(middle, shift, turn), pair.voxelsPerSample, threads, progress, there)) return false;
      least = std::min(least, there.agreement.correlation / evidence.agreement.correlation);
    }
    left = std::max(left, least);
  }
  return true;
}

}  // namespace

bool doubtsAbout(const PairLevels& pair, const Transform<frame::Moving, frame::Fixed>& start,
                 const Transform<frame::Moving, frame::Fixed>& found, const Evidence& evidence, int threads, Progress& progress,
                 std::optional<Remark>& doubt) {
  doubt.reset();
  double left = 0.0;
  if (!looseness(pair, found, evidence, threads, progress, left)) return false;
  if (left > kLoose) {
    doubt = Remark{RemarkCode::poseNotHeld, {std::min(1.0, left), kSlide_mm}};
    return true;
  }

  const std::size_t level = 0;
  const double voxel_mm = pair.fixed[level].grid.spacing_mm.x;
  const double perSample = voxelsPerSample(pair.fixed[level], pair.moving[level]);
  const glm::dvec3 middle = carried(pair.fixed[level].grid.voxelTo<frame::Fixed>(), 0.5 * glm::dvec3(pair.fixed[level].grid.dims - 1));
  Evidence here;
  if (!evidenceAt(pair, level, found, perSample, threads, progress, here)) return false;
  const auto peaks = correlateOverTranslations(pair.fixed[level], pair.moving[level], {glm::dvec3(0.0)},
                                               {0.08, kRivals, threads, glm::dmat3(found.matrix)}, progress);
  if (progress.cancelRequested()) return false;
  const double went_mm = differenceOf(start, found, middle).shift_mm;
  for (const Coarse& peak : peaks) {
    DescentOptions options;
    options.iterations = 12;
    options.stop_mm = 0.03 * voxel_mm;
    options.limit_mm = 2.0 * voxel_mm;
    const Descent rival = descend(pair.fixed[level], pair.packedMoving[level], peak.fixedToMoving, options, threads, progress);
    if (rival.stop == StopReason::cancelled) return false;
    Evidence there;
    if (!evidenceAt(pair, level, rival.fixedToMoving, perSample, threads, progress, there)) return false;
    const double apart_mm = differenceOf(found, rival.fixedToMoving, middle).shift_mm;
    const double off_mm = differenceOf(start, rival.fixedToMoving, middle).shift_mm;
    if (apart_mm < kApart_mm || off_mm > kNearer * went_mm + kAnyway_mm) continue;
    if (there.agreement.correlation > kAsAlike * here.agreement.correlation && there.significance > kAsSure * here.significance) {
      doubt = remarkWith(RemarkCode::twoPosesAlike, {here.significance / there.significance}, evidence);
      return true;
    }
  }
  return true;
}

}  // namespace ew::registration
