#include "ew/tracking/alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment_words.h"
#include "chance.h"
#include "rigid_fit.h"

namespace ew {
namespace {

using Eigen::Vector3d;

constexpr double kFreeTurn_rad = 0.05;     // known worse than this about the line of the places, a turn is free: 5 mm at 100 mm
constexpr double kWorstExpected_mm = 8.0;  // beyond, a standard plane can be missed by more than its tolerance
constexpr double kUnlikely = 1e-4;         // residuals so large are none of touching
constexpr double kNoisiest = 3.0;          // times touch_mm: a soft mannequin, an unsteady hand
constexpr double kNoisyRatio = 30.0;       // where the hand was unsteady: mean square of what one landmark adds over that of the rest; of
                                           // 500 times that six were touched with 2.5 mm of noise it accuses one in 32
constexpr double kAsGood = 9.2;            // likelihoods less than a hundred times apart: -2 log(1 / 100)

struct Touches {
  std::vector<Vector3d> tracker, world;
  [[nodiscard]] int size() const { return static_cast<int>(world.size()); }
};

double squaresAt(const Touches& touches, const RigidFit& fit, int without) {
  double sum = 0.0;
  for (int n = 0; n < touches.size(); ++n) {
    const auto i = static_cast<std::size_t>(n);
    if (n != without) sum += (fit(touches.tracker[i]) - touches.world[i]).squaredNorm();
  }
  return sum;
}

/// How well the turn about the line of the places is known.
double freeTurn_rad(const Touches& touches, int without, double touch_mm) {
  const double count = touches.size() - (without >= 0 ? 1 : 0);
  const double beside = spreadOf(touches.world, without).deviation[1];
  return beside > 0.0 ? touch_mm / (beside * std::sqrt(count)) : std::numeric_limits<double>::infinity();
}

/// What leaving out each landmark leaves of the sum of squares, and the best two to leave out.
struct LeaveOneOut {
  std::vector<double> squares;
  int best = -1;
  int second = -1;
};

LeaveOneOut leaveOut(const Touches& touches) {
  LeaveOneOut left;
  for (int n = 0; n < touches.size(); ++n) left.squares.push_back(squaresAt(touches, fitRigid(touches.tracker, touches.world, n), n));
  const auto at = [&](int n) { return n < 0 ? std::numeric_limits<double>::infinity() : left.squares[static_cast<std::size_t>(n)]; };
  for (int n = 0; n < touches.size(); ++n) {
    if (at(n) < at(left.best)) {
      left.second = left.best;
      left.best = n;
    } else if (at(n) < at(left.second)) {
      left.second = n;
    }
  }
  return left;
}

/// Fitzpatrick, West and Maurer 1998, equation 46: TRE^2 = FLE^2 / N (1 + (1/3) sum_k d_k^2 / f_k^2); d_k and f_k are distances of the
/// target and of the places (root mean square) from principal axis k.
double expectedAt(const Touches& touches, int without, const Vector3d& target, double variance) {
  const Spread spread = spreadOf(touches.world, without);
  const Vector3d away = spread.axes.transpose() * (target - spread.centre);
  double lever = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double f2 = spread.deviation.squaredNorm() - spread.deviation[k] * spread.deviation[k];
    if (!(f2 > 0.0)) return std::numeric_limits<double>::infinity();
    lever += (away.squaredNorm() - away[k] * away[k]) / f2;
  }
  const double count = touches.size() - (without >= 0 ? 1 : 0);
  return std::sqrt(3.0 * variance / count * (1.0 + lever / 3.0));
}

void takeFit(const Touches& touches, int without, const AlignmentOptions& options, Alignment& found) {
  const RigidFit fit = fitRigid(touches.tracker, touches.world, without);
  found.trackerToWorld.matrix = matrixOf(fit.turn, fit.shift);
  found.residual_mm.clear();
  for (std::size_t n = 0; n < touches.world.size(); ++n) found.residual_mm.push_back((fit(touches.tracker[n]) - touches.world[n]).norm());
  found.used = touches.size() - (without >= 0 ? 1 : 0);
  const double squares = squaresAt(touches, fit, without);
  found.rms_mm = std::sqrt(squares / found.used);
  const double variance = std::max(options.touch_mm * options.touch_mm, squares / (3.0 * found.used - 6.0));
  found.expected_mm = expectedAt(touches, without, eigenOf(options.target_mm), variance);
  found.spread_mm = std::sqrt(variance);
  if (without >= 0) found.wrong = static_cast<std::size_t>(without);
}

/// The variance that decides what is chance: that of touching, or more where even the best explanation leaves more.
double varianceFor(double leftSquares, int freedoms, double touch_mm) {
  const double touch2 = touch_mm * touch_mm;
  if (chanceAbove(leftSquares / touch2, freedoms) > 0.02) return touch2;
  return std::min(leftSquares / freedoms, kNoisiest * kNoisiest * touch2);
}

Message quoted(const LandmarkTouch& landmark, std::size_t number) {
  return landmark.name.empty() ? say<"landmark %1">(number + 1) : verbatim("'" + landmark.name + "'");
}

/// Of four and more: the one that has to be left out, nobody, or a contradiction.
void judgeMany(std::span<const LandmarkTouch> touched, const Touches& touches, const AlignmentOptions& options, Alignment& found) {
  const int n = touches.size();
  const double all = squaresAt(touches, fitRigid(touches.tracker, touches.world), -1);
  const LeaveOneOut left = leaveOut(touches);
  const double best = left.squares[static_cast<std::size_t>(left.best)], second = left.squares[static_cast<std::size_t>(left.second)];
  const int freedoms = 3 * n - 9;
  const double variance = varianceFor(best, freedoms, options.touch_mm);
  const bool isNoisy = variance > 1.01 * options.touch_mm * options.touch_mm;
  const bool oneIsWrong =
      chanceAbove((all - best) / variance, 3) * n < options.falseAlarm && (!isNoisy || all - best > 3.0 * kNoisyRatio * best / freedoms);
  if (!oneIsWrong) {
    takeFit(touches, -1, options, found);
    if (chanceAbove(all / (kNoisiest * kNoisiest * options.touch_mm * options.touch_mm), 3 * n - 6) < kUnlikely) {
      found.verdict = AlignmentVerdict::notAligned;
      found.sentence =
          say<"The landmarks contradict each other by %1 mm, and not one of them alone is to blame. Check that the mannequin on the screen "
              "is the "
              "one in front of you, and touch all of them again.">(tenths(found.rms_mm));
    }
    return;
  }
  takeFit(touches, left.best, options, found);
  const std::size_t wrong = *found.wrong;
  if (chanceAbove(best / (kNoisiest * kNoisiest * options.touch_mm * options.touch_mm), freedoms) < kUnlikely) {
    found.verdict = AlignmentVerdict::notAligned;
    found.wrong.reset();
    found.sentence =
        say<"More than one landmark is in the wrong place; the worst is %1. Touch all of them again, in the order that is asked for.">(
            quoted(touched[wrong], wrong));
    return;
  }
  if ((second - best) / variance < kAsGood) {
    found.verdict = AlignmentVerdict::notAligned;
    found.wrong.reset();
    const auto other = static_cast<std::size_t>(left.second);
    found.sentence =
        say<"Either %1 or %2 is in the wrong place, and the others cannot tell which. Touch both again, or one more landmark.">(
            quoted(touched[wrong], wrong), quoted(touched[other], other));
    return;
  }
  found.sentence = say<"%1 is in the wrong place by %2 mm and was left out; touch it again if you can.">(quoted(touched[wrong], wrong),
                                                                                                         tenths(found.residual_mm[wrong]));
}

bool isTouchable(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

Result<Alignment> alignByLandmarks(std::span<const LandmarkTouch> touched, const AlignmentOptions& options) {
  if (!(options.touch_mm > 0.0) || !std::isfinite(options.touch_mm))
    return failure(ErrorCode::badField, say<"The precision of touching must be a number above 0 mm.">(), {{"field", "touch_mm"}});
  Touches touches;
  for (std::size_t n = 0; n < touched.size(); ++n) {
    if (!isTouchable(touched[n].world_mm) || !isTouchable(touched[n].tracker_mm))
      return failure(ErrorCode::badField, say<"The place of %1 is no number; touch it again.">(quoted(touched[n], n)),
                     {{"field", touched[n].name}});
    touches.tracker.push_back(eigenOf(touched[n].tracker_mm));
    touches.world.push_back(eigenOf(touched[n].world_mm));
  }
  Alignment found;
  const int n = touches.size();
  if (n < 3) {
    found.sentence = say<"%1 landmarks are not enough: touch at least three, better four that lie far apart.">(n);
    return found;
  }
  if (freeTurn_rad(touches, -1, options.touch_mm) > kFreeTurn_rad) {
    takeFit(touches, -1, options, found);
    found.sentence =
        say<"The landmarks lie almost on one line or too close together, so that the mannequin could be turned about it; touch one more to "
            "the side.">();
    return found;
  }
  found.verdict = AlignmentVerdict::aligned;
  if (n == 3) {
    takeFit(touches, -1, options, found);
    if (chanceAbove(3.0 * found.rms_mm * found.rms_mm / (kNoisiest * kNoisiest * options.touch_mm * options.touch_mm), 3) < kUnlikely) {
      found.verdict = AlignmentVerdict::notAligned;
      found.sentence = say<"The three landmarks contradict each other by %1 mm, and three cannot tell which is wrong. Touch a fourth one.">(
          tenths(found.rms_mm));
      return found;
    }
  } else {
    judgeMany(touched, touches, options, found);
    if (found.verdict != AlignmentVerdict::aligned) return found;
    if (found.wrong && freeTurn_rad(touches, static_cast<int>(*found.wrong), options.touch_mm) > kFreeTurn_rad) {
      found.verdict = AlignmentVerdict::cannotTell;
      found.sentence = say<"%1 is in the wrong place, and the others lie almost on one line; touch it again.">(
          quoted(touched[*found.wrong], *found.wrong));
      return found;
    }
  }
  if (found.expected_mm > kWorstExpected_mm) {
    found.verdict = AlignmentVerdict::cannotTell;
    Message close = say<"The landmarks lie too close together: the image could be off by %1 mm. Touch more of them, farther apart.">(
        tenths(found.expected_mm));
    found.sentence = found.sentence.empty() ? close : joined({found.sentence, close});
  } else if (found.sentence.empty()) {
    found.sentence = say<"The landmarks agree within %1 mm; where you scan, the probe is expected to be right within %2 mm.">(
        tenths(found.rms_mm), tenths(found.expected_mm));
  }
  return found;
}

}  // namespace ew
