#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "alignment_words.h"
#include "ew/tracking/alignment.h"
#include "rigid_fit.h"

namespace ew {
namespace {

using Eigen::Vector3d;
using Twist = Eigen::Matrix<double, 6, 1>;  // translation, then rotation about the centre of the points times its lever, mm
using Information = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t kFewestTraced = 30;
constexpr std::size_t kMostTraced = 1500;
constexpr double kWidest_mm = 15.0;  // scale of the loss at first, while the start may be tens of millimetres off
constexpr double kCell_mm = 20.0;    // points closer than this err alike: skin of cloth, a mannequin that differs from its model
constexpr double kOpen_mm = 4.0;     // a freedom that is known no better is open
constexpr double kWorstRms_mm = 6.0;
constexpr double kFewestInliers = 0.6;

struct Traced {
  std::vector<Vector3d> tracker;
  Vector3d centre = Vector3d::Zero();  ///< in the tracker's frame
  double lever_mm = 1.0;               ///< root mean square distance from it
  double cells = 0.0;                  ///< places that are apart
};

Traced thinned(std::span<const glm::dvec3> points) {
  Traced traced;
  const double step = std::max(1.0, static_cast<double>(points.size()) / kMostTraced);
  for (double at = 0.0; at < static_cast<double>(points.size()); at += step)
    traced.tracker.push_back(eigenOf(points[static_cast<std::size_t>(at)]));
  for (const Vector3d& p : traced.tracker) traced.centre += p;
  traced.centre /= static_cast<double>(traced.tracker.size());
  double squares = 0.0;
  std::set<std::array<int, 3>> cells;
  for (const Vector3d& p : traced.tracker) {
    squares += (p - traced.centre).squaredNorm();
    const Vector3d c = (p / kCell_mm).array().floor();
    cells.insert({static_cast<int>(c.x()), static_cast<int>(c.y()), static_cast<int>(c.z())});
  }
  traced.lever_mm = std::max(1.0, std::sqrt(squares / static_cast<double>(traced.tracker.size())));
  traced.cells = static_cast<double>(cells.size());
  return traced;
}

/// The equations of one step: distances along the normals, each with its weight.
struct SurfaceEquations {
  Information information = Information::Zero();
  Twist right = Twist::Zero();
  std::vector<double> residual_mm;
  double weights = 0.0;
  double weightedSquares = 0.0;
};

/// Chen and Medioni 1992: a point slides freely along the surface, so only its distance along the normal counts. Weight of Geman and
/// McClure: (s^2 / (s^2 + r^2))^2.
SurfaceEquations equationsAt(const Traced& traced, const Skin& skin, const RigidFit& at, double scale_mm) {
  SurfaceEquations made;
  const Vector3d centre = at(traced.centre);
  for (const Vector3d& point : traced.tracker) {
    const Vector3d p = at(point);
    const Skin::Contact foot = skin.nearest(glmOf(p));
    const Vector3d away = p - eigenOf(foot.point_mm), outward = eigenOf(foot.outward);
    // The direction to the nearest point is the exact normal; the smoothed one says which side, and stands in where the point lies on the
    // skin.
    const double side = away.dot(outward) < 0.0 ? -1.0 : 1.0;
    const double r = side * away.norm();
    const Vector3d normal = away.norm() > 0.5 ? Vector3d(side * away.normalized()) : outward;
    const double ratio = scale_mm * scale_mm / (scale_mm * scale_mm + r * r), weight = ratio * ratio;
    Twist row;
    row << normal, (p - centre).cross(normal) / traced.lever_mm;
    made.information += weight * row * row.transpose();
    made.right -= weight * r * row;
    made.weights += weight;
    made.weightedSquares += weight * r * r;
    made.residual_mm.push_back(r);
  }
  return made;
}

/// Directions of the six freedoms, and which are open: those along which the points' distances hardly change.
struct Freedoms {
  Information axes = Information::Identity();  // columns
  Twist deviation_mm = Twist::Zero();
};

Freedoms freedomsOf(const SurfaceEquations& equations, const Traced& traced, double error_mm) {
  const Eigen::SelfAdjointEigenSolver<Information> solver(equations.information / std::max(equations.weights, 1e-9));
  Freedoms found{solver.eigenvectors(), Twist::Zero()};
  for (int k = 0; k < 6; ++k) found.deviation_mm[k] = error_mm / std::sqrt(std::max(solver.eigenvalues()[k], 1e-12) * traced.cells);
  return found;
}

/// One step that leaves open freedoms as they are.
Twist stepOf(const SurfaceEquations& equations, const Freedoms& freedoms) {
  Twist step = Twist::Zero();
  for (int k = 0; k < 6; ++k) {
    if (freedoms.deviation_mm[k] > kOpen_mm) continue;
    const Twist axis = freedoms.axes.col(k);
    step += axis * (axis.dot(equations.right) / axis.dot(equations.information * axis));
  }
  return step;
}

RigidFit twistedBy(const RigidFit& at, const Twist& step, const Traced& traced) {
  const Vector3d turn = step.tail<3>() / traced.lever_mm, centre = at(traced.centre);
  const double angle = turn.norm();
  const Eigen::Matrix3d by = angle > 0.0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
  RigidFit next;
  next.turn = by * at.turn;
  next.shift = by * (at.shift - centre) + centre + step.head<3>();
  return next;
}

/// An open freedom in words, by what it mostly is. World: patient left, posterior, superior.
Message wordsOf(const Twist& axis) {
  const bool isTurn = axis.tail<3>().norm() > axis.head<3>().norm();
  Eigen::Index most = 0;
  (isTurn ? Vector3d(axis.tail<3>()) : Vector3d(axis.head<3>())).cwiseAbs().maxCoeff(&most);
  if (isTurn) {
    if (most == 0) return say<"tipping towards the feet or the head">();
    if (most == 1) return say<"turning in the plane of the couch">();
    return say<"rolling onto one side">();
  }
  if (most == 0) return say<"shifting to the left or right">();
  if (most == 1) return say<"shifting up or down">();
  return say<"shifting towards the feet or the head">();
}

void judgeSurface(const SurfaceEquations& last, const Traced& traced, const AlignmentOptions& options, Alignment& found) {
  std::size_t inliers = 0;
  double squares = 0.0;
  for (const double r : last.residual_mm) {
    found.residual_mm.push_back(std::abs(r));
    if (std::abs(r) > 3.0 * options.trace_mm) continue;
    ++inliers;
    squares += r * r;
  }
  found.used = static_cast<int>(inliers);
  found.rms_mm = inliers > 0 ? std::sqrt(squares / static_cast<double>(inliers)) : 0.0;
  const Freedoms freedoms = freedomsOf(last, traced, std::max(found.rms_mm, options.touch_mm));
  double shift2 = 0.0, turn2 = 0.0;
  for (int k = 0; k < 6; ++k) {
    const Twist axis = freedoms.axes.col(k);
    if (freedoms.deviation_mm[k] > kOpen_mm) {
      found.open.push_back(wordsOf(axis));
      continue;
    }
    const double variance = freedoms.deviation_mm[k] * freedoms.deviation_mm[k];
    shift2 += variance * axis.head<3>().squaredNorm();
    turn2 += variance * axis.tail<3>().squaredNorm() / (traced.lever_mm * traced.lever_mm);
  }
  found.spread_mm = std::sqrt(shift2);
  found.spread_rad = std::sqrt(turn2);
  const double away_mm = (eigenOf(options.target_mm) - eigenOf(carried(found.trackerToWorld, glmOf(traced.centre)))).norm();
  found.expected_mm = std::sqrt(shift2 + turn2 * away_mm * away_mm * 2.0 / 3.0);
  const double share = static_cast<double>(inliers) / static_cast<double>(last.residual_mm.size());
  if (found.rms_mm > kWorstRms_mm || share < kFewestInliers) {
    found.verdict = AlignmentVerdict::notAligned;
    found.sentence =
        say<"Only %1 % of the traced points lie on the skin. Touch the landmarks again, then trace with the probe always on the skin.">(
            static_cast<int>(std::lround(100.0 * share)));
  } else if (!found.open.empty()) {
    found.verdict = AlignmentVerdict::aligned;
    found.sentence = say<
        "The traced points lie on the skin within %1 mm, but leave open: %2. That stays as the landmarks have it; trace over more sides to "
        "settle it.">(tenths(found.rms_mm), joined(found.open, ", "));
  } else {
    found.verdict = AlignmentVerdict::aligned;
    found.sentence = say<"The traced points lie on the skin within %1 mm; the probe is expected to be right within %2 mm.">(
        tenths(found.rms_mm), tenths(found.expected_mm));
  }
}

}  // namespace

Result<Alignment> alignBySurface(std::span<const glm::dvec3> traced, const Skin& skin, const Transform<frame::World, frame::Tracker>& start,
                                 const AlignmentOptions& options) {
  if (auto rigid = checkRigid(start); !rigid) return passOn(rigid.error());
  if (traced.size() < kFewestTraced)
    return failure(ErrorCode::badField,
                   say<"%1 traced points are too few; slide the probe over the skin for at least ten seconds.">(traced.size()),
                   {{"points", std::to_string(traced.size())}});
  for (const glm::dvec3& p : traced)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return failure(ErrorCode::badField, say<"A traced point is no number; trace again.">(), {{"field", "traced"}});
  const Traced points = thinned(traced);
  RigidFit at;
  at.turn = turnOf(start.matrix);
  at.shift = eigenOf(glm::dvec3(start.matrix[3]));
  double scale_mm = kWidest_mm;
  for (int iteration = 0; iteration < 80; ++iteration) {
    const SurfaceEquations equations = equationsAt(points, skin, at, scale_mm);
    const double error_mm = std::max(options.touch_mm, std::sqrt(equations.weightedSquares / std::max(equations.weights, 1e-9)));
    const Twist step = stepOf(equations, freedomsOf(equations, points, std::min(error_mm, options.trace_mm)));
    at = twistedBy(at, step, points);
    if (step.norm() < 1e-4 && scale_mm <= options.trace_mm) break;
    if (step.norm() < 1.0) scale_mm = std::max(options.trace_mm, 0.7 * scale_mm);
  }
  Alignment found;
  found.trackerToWorld.matrix = matrixOf(at.turn, at.shift);
  judgeSurface(equationsAt(points, skin, at, options.trace_mm), points, options, found);
  return found;
}

}  // namespace ew
