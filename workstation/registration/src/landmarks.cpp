#include "ew/registration/landmarks.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "ew/core/frames.h"

namespace ew::registration {
namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

constexpr double kMedianOfNorm = 1.5382;    // of three independent unit normal numbers
constexpr double kOutlyingAt = 4.03;        // standard deviations: one good pair of a thousand lies farther away (chi square, 3 degrees)
constexpr double kTukey = 7.45;             // so that the weight falls to 1/2 at kOutlyingAt
constexpr double kAsLikely = 3.0;           // less than this much less likely (log) is as likely
constexpr double kLargestScale = 3.0;       // tissue deforms: residuals up to so many times the pick error are still the same tissue
constexpr double kFreeTurn_rad = 0.25;      // a turn that is known worse than this about the line of the places is free
constexpr std::size_t kMostTriples = 4000;  // tried in full up to 29 pairs, by fixed draws above

struct Points {
  std::vector<Vector> fixed;
  std::vector<Vector> moving;
  [[nodiscard]] std::size_t size() const { return fixed.size(); }
};

struct LandmarkRigid {
  Matrix turn = Matrix::Identity();
  Vector shift = Vector::Zero();
  [[nodiscard]] Vector operator()(const Vector& p) const { return turn * p + shift; }
};

struct Scatter {
  Vector centre = Vector::Zero();
  Matrix axes = Matrix::Identity();   // columns: principal axes, widest first
  Vector deviation = Vector::Zero();  // rms along each
};

Scatter scatterOf(std::span<const Vector> places, std::span<const double> weight) {
  Scatter found;
  double sum = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    found.centre += weight[i] * places[i];
    sum += weight[i];
  }
  if (sum <= 0.0) return found;
  found.centre /= sum;
  Matrix second = Matrix::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector d = places[i] - found.centre;
    second += weight[i] * d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(second / sum);
  for (int k = 0; k < 3; ++k) {
    found.axes.col(k) = solver.eigenvectors().col(2 - k);
    found.deviation[k] = std::sqrt(std::max(0.0, solver.eigenvalues()[2 - k]));
  }
  return found;
}

/// The smallest turn that takes one direction onto another.
Matrix smallestRotation(const Vector& from, const Vector& to) { return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix(); }

/// Arun, Huang and Blostein 1987: with H = sum w (f - F)(m - M)^T = U S V^T the turn is V diag(1, 1, det(V U^T)) U^T; the determinant is
/// Umeyama's guard. `mirrored` asks for the best mirror instead. Places on one line leave a turn free: then the smallest turn is taken.
LandmarkRigid closedForm(const Points& points, std::span<const double> weight, bool mirrored = false) {
  Vector fixedCentre = Vector::Zero();
  Vector movingCentre = Vector::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    fixedCentre += weight[i] * points.fixed[i];
    movingCentre += weight[i] * points.moving[i];
    sum += weight[i];
  }
  LandmarkRigid found;
  if (sum <= 0.0) return found;
  fixedCentre /= sum;
  movingCentre /= sum;
  Matrix h = Matrix::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    h += weight[i] * (points.fixed[i] - fixedCentre) * (points.moving[i] - movingCentre).transpose();
  const Eigen::JacobiSVD<Matrix> svd(h, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector& s = svd.singularValues();
  if (s[0] <= 0.0) {
    found.turn = Matrix::Identity();
  } else if (s[1] < 1e-9 * s[0]) {
    found.turn = smallestRotation(svd.matrixU().col(0), svd.matrixV().col(0));
  } else {
    const double sign = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    found.turn = svd.matrixV() * Vector(1.0, 1.0, mirrored ? -sign : sign).asDiagonal() * svd.matrixU().transpose();
  }
  found.shift = movingCentre - found.turn * fixedCentre;
  return found;
}

std::vector<double> residualsOf(const Points& points, const LandmarkRigid& at) {
  std::vector<double> residual(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) residual[i] = (at(points.fixed[i]) - points.moving[i]).norm();
  return residual;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  // Of four and five pairs one may be wrong: the lower one of two in the middle is that of the good ones.
  return n % 2 == 1 || n < 6 ? values[(n - 1) / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

double tukeyWeight(double residual, double scale) {
  const double u = residual / (kTukey * scale);
  return u >= 1.0 ? 0.0 : (1.0 - u * u) * (1.0 - u * u);
}

/// How unlikely the residuals are, each either of a good pair with this deviation or of a wrong one: -log of normal density, up to a
/// constant, capped. A larger deviation has to pay for itself, or everything would agree with everything.
double costOf(std::span<const double> residual, double scale, double pick_mm) {
  constexpr double kWrong = 0.5 * kOutlyingAt * kOutlyingAt;
  const double wider = 3.0 * std::log(scale / (std::sqrt(2.0) * pick_mm));
  double sum = 0.0;
  for (const double r : residual) sum += std::min(kWrong, 0.5 * r * r / (scale * scale) + wider);
  return sum;
}

struct LandmarkFit {
  LandmarkRigid at;
  std::vector<double> residual;
  std::vector<double> weight;
  double scale = 1.0;
  double cost = std::numeric_limits<double>::infinity();
  std::size_t agreeing = 0;
  StopReason stop = StopReason::iterationLimit;
};

/// What a residual may be expected to be: at least the pick error of both ends, and more when most pairs say so.
double scaleOf(std::span<const double> residual, double pick_mm) {
  const double least = std::sqrt(2.0) * pick_mm;
  const auto n = static_cast<double>(residual.size());
  const double shrunk = n > 3.0 ? std::sqrt(1.0 - 2.0 / n) : 1.0;  // what six fitted numbers took away
  return std::clamp(median({residual.begin(), residual.end()}) / (kMedianOfNorm * shrunk), least, kLargestScale * least);
}

LandmarkFit reweighted(const Points& points, LandmarkFit fit, double pick_mm) {
  fit.residual = residualsOf(points, fit.at);
  for (int iteration = 0; iteration < 100; ++iteration) {
    fit.scale = scaleOf(fit.residual, pick_mm);
    fit.weight.assign(points.size(), 0.0);
    std::size_t used = 0;
    for (std::size_t i = 0; i < points.size(); ++i) used += (fit.weight[i] = tukeyWeight(fit.residual[i], fit.scale)) > 0.0 ? 1 : 0;
    if (used < 3) break;
    const LandmarkRigid next = closedForm(points, fit.weight);
    double moved = 0.0;
    for (const Vector& p : points.fixed) moved = std::max(moved, (next(p) - fit.at(p)).norm());
    fit.at = next;
    fit.residual = residualsOf(points, fit.at);
    if (moved < 1e-9 * pick_mm) {
      fit.stop = StopReason::converged;
      break;
    }
  }
  fit.scale = scaleOf(fit.residual, pick_mm);
  fit.cost = costOf(fit.residual, fit.scale, pick_mm);
  fit.weight.assign(points.size(), 0.0);
  fit.agreeing = 0;
  for (std::size_t i = 0; i < points.size(); ++i) fit.agreeing += (fit.weight[i] = tukeyWeight(fit.residual[i], fit.scale)) >= 0.5 ? 1 : 0;
  return fit;
}

double apart(const Points& points, const LandmarkRigid& a, const LandmarkRigid& b) {
  double most = 0.0;
  for (const Vector& p : points.fixed) most = std::max(most, (a(p) - b(p)).norm());
  return most;
}

/// Fits from triples, so that one wrong pair cannot spoil the start, each then reweighted; best first, each a different place.
std::vector<LandmarkFit> consensus(const Points& points, double pick_mm) {
  const std::size_t n = points.size();
  std::vector<std::array<std::size_t, 3>> triples;
  if (n <= 29) {
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b)
        for (std::size_t c = b + 1; c < n; ++c) triples.push_back({a, b, c});
  } else {
    std::mt19937_64 draw(1);
    while (triples.size() < kMostTriples) {
      const std::array<std::size_t, 3> t{draw() % n, draw() % n, draw() % n};
      if (t[0] != t[1] && t[1] != t[2] && t[0] != t[2]) triples.push_back(t);
    }
  }
  const double scale = kLargestScale * std::sqrt(2.0) * pick_mm;
  std::vector<std::pair<double, LandmarkRigid>> starts;
  const std::vector<double> all(n, 1.0);
  const LandmarkRigid plain = closedForm(points, all);
  starts.emplace_back(costOf(residualsOf(points, plain), scale, pick_mm), plain);
  const std::vector<double> three(3, 1.0);
  for (const auto& t : triples) {
    Points some;
    for (const std::size_t i : t) {
      some.fixed.push_back(points.fixed[i]);
      some.moving.push_back(points.moving[i]);
    }
    if (scatterOf(some.fixed, three).deviation[1] < 0.5 * pick_mm) continue;  // says nothing about the turn
    const LandmarkRigid at = closedForm(some, three);
    starts.emplace_back(costOf(residualsOf(points, at), scale, pick_mm), at);
  }
  std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<LandmarkFit> fits;
  for (std::size_t i = 0; i < std::min<std::size_t>(starts.size(), 40); ++i)
    fits.push_back(reweighted(points, {.at = starts[i].second, .residual = {}, .weight = {}}, pick_mm));
  fits.push_back(reweighted(points, {.at = plain, .residual = {}, .weight = {}}, pick_mm));
  std::stable_sort(fits.begin(), fits.end(), [](const LandmarkFit& a, const LandmarkFit& b) { return a.cost < b.cost; });
  std::vector<LandmarkFit> different;
  for (LandmarkFit& fit : fits)
    if (std::none_of(different.begin(), different.end(),
                     [&](const LandmarkFit& other) { return apart(points, other.at, fit.at) < 3.0 * pick_mm; }))
      different.push_back(std::move(fit));
  return different;
}

/// Fitzpatrick, West and Maurer 1998, equation 46: TRE^2(r) = FLE^2 / N (1 + (1/3) sum_k d_k^2 / f_k^2), with d_k the target's distance
/// from principal axis k of the places and f_k their own rms distance from it. The worst target at distance R lies along the axis with the
/// largest f.
double expectedError_mm(const Scatter& places, double fle2, double pairs, double reach_mm) {
  double inverse = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double f2 = places.deviation.squaredNorm() - places.deviation[k] * places.deviation[k];
    if (f2 <= 0.0) return std::numeric_limits<double>::infinity();
    inverse += 1.0 / f2;
    least = std::min(least, 1.0 / f2);
  }
  return std::sqrt(fle2 / pairs * (1.0 + reach_mm * reach_mm * (inverse - least) / 3.0));
}

Transform<frame::Moving, frame::Fixed> transformOf(const LandmarkRigid& rigid) {
  const Matrix turn = Eigen::Quaterniond(rigid.turn).normalized().toRotationMatrix();
  Transform<frame::Moving, frame::Fixed> fixedToMoving;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) fixedToMoving.matrix[c][r] = turn(r, c);
  for (int r = 0; r < 3; ++r) fixedToMoving.matrix[3][r] = rigid.shift[r];
  return fixedToMoving;
}

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Pairs that repeat the place of an earlier one in both volumes.
std::vector<std::size_t> repeated(const Points& points, double pick_mm) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((points.fixed[i] - points.fixed[j]).norm() <= pick_mm && (points.moving[i] - points.moving[j]).norm() <= pick_mm) {
        found.push_back(i);
        break;
      }
  return found;
}

/// How well the turn about the line of the places is known.
double rotationError_rad(const Scatter& places, double pairs, double fle_mm) {
  return places.deviation[1] > 0.0 ? fle_mm / (places.deviation[1] * std::sqrt(pairs)) : std::numeric_limits<double>::infinity();
}

void judge(LandmarkResult& result, std::span<const LandmarkPair> pairs, const Points& points, const LandmarkOptions& options,
           const std::vector<LandmarkFit>& fits) {
  const std::size_t n = pairs.size();
  const std::size_t distinct = n - result.coincident.size();
  /// A remark that names places goes by their numbers where they have no name.
  const auto naming = [&](RemarkCode what, std::vector<double> figures, const std::vector<std::size_t>& which) {
    Remark remark{what, std::move(figures)};
    for (const std::size_t i : which) {
      remark.figures.push_back(static_cast<double>(i + 1));
      remark.names.push_back(pairs[i].name);
    }
    return remark;
  };
  const auto sayRepeats = [&] {
    if (!result.coincident.empty()) result.remarks.push_back(naming(RemarkCode::placesRepeat, {}, result.coincident));
  };
  if (distinct < 3) {
    result.remarks = {{RemarkCode::tooFewPlaces, {static_cast<double>(distinct)}}};
    return sayRepeats();
  }
  if (result.collinear) {
    result.remarks = {{RemarkCode::placesOnALine}};
    return sayRepeats();
  }
  const LandmarkFit& best = fits.front();
  const std::vector<double> all(n, 1.0);
  if (best.agreeing < n) {
    const LandmarkRigid mirror = closedForm(points, all, true);
    const auto residual = residualsOf(points, mirror);
    const double largest = *std::max_element(residual.begin(), residual.end());
    if (n >= 4 && largest < kOutlyingAt * std::sqrt(2.0) * options.pickError_mm) {
      result.verdict = Verdict::notAligned;
      result.remarks = {{RemarkCode::placesMirrored}};
      return;
    }
  }
  std::vector<std::size_t> places;  // distinct ones that agree
  for (std::size_t i = 0; i < n; ++i)
    if (best.weight[i] >= 0.5 && std::find(result.coincident.begin(), result.coincident.end(), i) == result.coincident.end())
      places.push_back(i);
  // Unrelated places agree by chance when much is forgiven: a coarse hand has to be borne out by more pairs.
  const bool coarse = best.scale > 1.5 * std::sqrt(2.0) * options.pickError_mm;
  if (places.size() < 3 || 2 * best.agreeing <= n || (coarse && 4 * best.agreeing < 3 * n)) {
    if (n == 3) {
      result.remarks = {{RemarkCode::threePlacesDisagree, {*std::max_element(best.residual.begin(), best.residual.end())}}};
    } else {
      result.verdict = Verdict::notAligned;
      result.remarks = {{RemarkCode::placesDisagree, {static_cast<double>(best.agreeing), static_cast<double>(n)}}};
    }
    return;
  }
  if (fits.size() > 1 && fits[1].cost < best.cost + kAsLikely && best.agreeing < n) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < n; ++i)
      if (fits[1].weight[i] < 0.5) others.push_back(i);
    std::vector<std::size_t> both = result.outlying;
    both.insert(both.end(), others.begin(), others.end());
    result.remarks = {naming(RemarkCode::twoReadings, {static_cast<double>(result.outlying.size())}, both)};
    return;
  }
  result.verdict = Verdict::aligned;
  const auto agreeing = static_cast<double>(best.agreeing);
  if (result.outlying.empty())
    result.remarks = {{RemarkCode::placesAgree, {agreeing, result.rms_mm}}};
  else
    result.remarks = {
        naming(RemarkCode::placesAgreeBut, {agreeing, result.rms_mm, best.residual[result.outlying.front()]}, result.outlying)};
  sayRepeats();
}

}  // namespace

Result<LandmarkResult> registerLandmarks(std::span<const LandmarkPair> pairs, const LandmarkOptions& options) {
  if (!std::isfinite(options.pickError_mm) || options.pickError_mm <= 0.0)
    return failure(ErrorCode::badField, say<"The pick error of landmarks must be a length above 0 mm.">(), {{"field", "pickError_mm"}});
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (!finite(pairs[i].fixed_mm) || !finite(pairs[i].moving_mm))
      return failure(ErrorCode::badField,
                     say<"The landmark %1 has a coordinate that is not a number; correct or remove it.">(
                         pairs[i].name.empty() ? say<"number %1">(i + 1) : say<"'%1'">(pairs[i].name)),
                     {{"field", pairs[i].name}});
  Points points;
  for (const LandmarkPair& pair : pairs) {
    points.fixed.emplace_back(pair.fixed_mm.x, pair.fixed_mm.y, pair.fixed_mm.z);
    points.moving.emplace_back(pair.moving_mm.x, pair.moving_mm.y, pair.moving_mm.z);
  }
  const std::size_t n = pairs.size();
  LandmarkResult result;
  result.coincident = repeated(points, options.pickError_mm);
  result.weight.assign(n, 1.0);
  if (n == 0) {
    judge(result, pairs, points, options, {});
    result.reason = messageOf(result.remarks);
    return result;
  }

  // Places on a line are found in both volumes: a wrong pair may lie beside the line in one of them, but says nothing about the turn.
  const double fle_mm = std::sqrt(2.0) * options.pickError_mm;
  std::vector<LandmarkFit> fits;
  if (options.robust && n > 3) {
    fits = consensus(points, options.pickError_mm);
  } else {
    LandmarkFit plain{.at = closedForm(points, result.weight), .residual = {}, .weight = {}};
    plain.residual = residualsOf(points, plain.at);
    plain.scale = scaleOf(plain.residual, options.pickError_mm);
    plain.weight.assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) plain.agreeing += (plain.weight[i] = tukeyWeight(plain.residual[i], plain.scale)) >= 0.5 ? 1 : 0;
    plain.stop = StopReason::converged;
    fits.push_back(std::move(plain));
  }
  const LandmarkFit& best = fits.front();
  result.fixedToMoving = transformOf(best.at);
  result.residual_mm = best.residual;
  result.stop = best.stop;
  if (options.robust) result.weight = best.weight;
  std::vector<double> agrees(n, 0.0);
  double sum = 0.0;
  double reach_mm = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    if (best.weight[i] < 0.5) {
      result.outlying.push_back(i);
      continue;
    }
    agrees[i] = 1.0;
    sum += best.residual[i] * best.residual[i];
  }
  if (best.agreeing < 3) std::fill(agrees.begin(), agrees.end(), 1.0);  // nothing agrees: the geometry is that of all
  const auto used = static_cast<double>(best.agreeing < 3 ? n : best.agreeing);
  result.rms_mm = best.agreeing > 0 ? std::sqrt(sum / static_cast<double>(best.agreeing)) : 0.0;
  const Scatter fixedPlaces = scatterOf(points.fixed, agrees);
  const Scatter movingPlaces = scatterOf(points.moving, agrees);
  const Scatter& narrower = fixedPlaces.deviation[1] <= movingPlaces.deviation[1] ? fixedPlaces : movingPlaces;
  result.conditioning = narrower.deviation[0] > 0.0 ? narrower.deviation[1] / narrower.deviation[0] : 0.0;
  result.collinear = n >= 2 && rotationError_rad(narrower, used, fle_mm) > kFreeTurn_rad;
  for (std::size_t i = 0; i < n; ++i)
    if (agrees[i] > 0.0) reach_mm = std::max(reach_mm, (points.fixed[i] - fixedPlaces.centre).norm());
  // FLE from what was said, or from the residuals when they say more: E(FRE^2) = (1 - 2 / N) FLE^2.
  double fle2 = 3.0 * fle_mm * fle_mm;
  if (used > 2.0) fle2 = std::max(fle2, result.rms_mm * result.rms_mm / (1.0 - 2.0 / used));
  result.expectedError_mm =
      n - result.coincident.size() >= 3 ? expectedError_mm(fixedPlaces, fle2, used, reach_mm) : std::numeric_limits<double>::infinity();
  if (result.collinear) {
    result.expectedError_mm = std::numeric_limits<double>::infinity();
    if (result.stop == StopReason::converged) result.stop = StopReason::singular;
  }
  judge(result, pairs, points, options, fits);
  result.reason = messageOf(result.remarks);
  return result;
}

}  // namespace ew::registration
