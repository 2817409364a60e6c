#include "ew/assessment/motion.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <glm/gtc/quaternion.hpp>
#include <unsupported/Eigen/FFT>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr int kDegree = 5;  // what a movement of minimum jerk is: a lower one would shorten its jerk

glm::dvec3 rotationVector(const glm::dmat3& rotation) {
  glm::dquat q = glm::normalize(glm::quat_cast(rotation));
  if (q.w < 0.0) q = -q;
  const glm::dvec3 axis(q.x, q.y, q.z);
  const double sine = glm::length(axis);
  return sine < 1e-12 ? 2.0 * axis : axis * (2.0 * std::atan2(sine, q.w) / sine);
}

/// Angular velocity about the body's own axes of a rotation vector w that changes by `rate` (right Jacobian, to third order: w is small).
glm::dvec3 bodyRate(const glm::dvec3& w, const glm::dvec3& rate) {
  const glm::dvec3 once = glm::cross(w, rate);
  return rate - 0.5 * once + glm::cross(w, once) / 6.0;
}

/// Value and first three derivatives at 0 of the polynomials that fit columns of values over times best.
struct Fit {
  std::array<glm::dvec3, 4> position{}, rotation{};
};

Fit fitted(std::span<const Pose> poses, double at_s, const glm::dmat3& reference, double scale_s) {
  const auto count = static_cast<Eigen::Index>(poses.size());
  const auto terms = std::min<Eigen::Index>(kDegree + 1, count);
  Eigen::MatrixXd powers(count, terms), values(count, 6);
  for (Eigen::Index row = 0; row < count; ++row) {
    const Pose& pose = poses[static_cast<std::size_t>(row)];
    const double t = (pose.time_s - at_s) / scale_s;
    double power = 1.0;
    for (Eigen::Index n = 0; n < terms; ++n, power *= t) powers(row, n) = power;
    const glm::dvec3 p(pose.probeToWorld.matrix[3]);
    const glm::dvec3 w = rotationVector(glm::transpose(reference) * glm::dmat3(pose.probeToWorld.matrix));
    for (int axis = 0; axis < 3; ++axis) {
      values(row, axis) = p[axis];
      values(row, 3 + axis) = w[axis];
    }
  }
  const Eigen::MatrixXd found = powers.householderQr().solve(values);
  Fit fit;
  double factor = 1.0;
  for (Eigen::Index n = 0; n < std::min<Eigen::Index>(4, terms); ++n) {
    if (n > 0) factor *= static_cast<double>(n) / scale_s;
    for (int axis = 0; axis < 3; ++axis) {
      fit.position[static_cast<std::size_t>(n)][axis] = factor * found(n, axis);
      fit.rotation[static_cast<std::size_t>(n)][axis] = factor * found(n, 3 + axis);
    }
  }
  return fit;
}

MotionStretch stretchOf(std::span<const Pose> poses, const MotionOptions& options) {
  const double begin_s = poses.front().time_s, seconds = poses.back().time_s - begin_s, half_s = 0.5 * options.window_s;
  const auto steps = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(seconds / options.step_s - 1e-9)));
  MotionStretch stretch{seconds / static_cast<double>(steps), {}};
  std::size_t first = 0, end = 0, nearest = 0;
  for (std::size_t n = 0; n <= steps; ++n) {
    const double at_s = begin_s + stretch.step_s * static_cast<double>(n);
    while (end < poses.size() && poses[end].time_s <= at_s + half_s + 1e-9) ++end;
    while (poses[first].time_s < at_s - half_s - 1e-9) ++first;
    while (nearest + 1 < poses.size() && std::abs(poses[nearest + 1].time_s - at_s) <= std::abs(poses[nearest].time_s - at_s)) ++nearest;
    // Few poses a second: the next ones outside count, too, else there would be no jerk.
    std::size_t low = first, high = end;
    while (high - low < static_cast<std::size_t>(kDegree + 2) && high - low < poses.size()) {
      if (low > 0) --low;
      if (high < poses.size()) ++high;
    }
    const glm::dmat3 reference(poses[nearest].probeToWorld.matrix);
    const Fit fit = fitted(poses.subspan(low, high - low), at_s, reference, half_s);
    stretch.moments.push_back({at_s, fit.position[1], fit.position[3], bodyRate(fit.rotation[0], fit.rotation[1])});
  }
  return stretch;
}

/// Trapezoids over even moments.
template <class Value>
double integral(std::span<const MotionMoment> moments, double step_s, const Value& valueOf) {
  double sum = 0.0;
  for (std::size_t n = 0; n < moments.size(); ++n) sum += (n == 0 || n + 1 == moments.size() ? 0.5 : 1.0) * valueOf(moments[n]);
  return sum * step_s;
}

double speedOf(const MotionMoment& moment) { return glm::length(moment.velocity_mmPerS); }
double turnOf(const MotionMoment& moment) { return glm::degrees(glm::length(moment.angularVelocity_radPerS)); }

/// A mean by weights.
class Mean {
 public:
  void add(const std::optional<double>& value, double weight) {
    if (!value) return;
    sum_ += *value * weight;
    weight_ += weight;
  }
  [[nodiscard]] std::optional<double> value() const { return weight_ > 0.0 ? std::optional(sum_ / weight_) : std::nullopt; }

 private:
  double sum_ = 0.0, weight_ = 0.0;
};

}  // namespace

Motion motionOf(std::span<const Pose> poses, const MotionOptions& options) {
  EW_EXPECTS(options.window_s > 0.0 && options.step_s > 0.0 && options.longestGap_s > 0.0);
  Motion motion;
  if (poses.empty()) return motion;
  motion.seconds = poses.back().time_s - poses.front().time_s;
  std::vector<Pose> valid;
  for (const Pose& each : poses)
    if (each.status == PoseStatus::ok) valid.push_back(each);
  motion.validShare = static_cast<double>(valid.size()) / static_cast<double>(poses.size());
  const auto isOfOneTime = [](const Pose& a, const Pose& b) { return b.time_s <= a.time_s; };
  valid.erase(std::unique(valid.begin(), valid.end(), isOfOneTime), valid.end());
  for (std::size_t first = 0; first < valid.size();) {
    std::size_t end = first + 1;
    while (end < valid.size() && valid[end].time_s - valid[end - 1].time_s <= options.longestGap_s) ++end;
    if (end - first >= 2) motion.stretches.push_back(stretchOf(std::span(valid).subspan(first, end - first), options));
    first = end;
  }
  return motion;
}

std::vector<Pose> posesOf(const ScanLog& log, double from_s, double to_s) {
  std::vector<Pose> poses;
  for (const ScanEvent& each : log.events()) {
    const auto* made = std::get_if<FrameMade>(&each.what);
    if (made == nullptr || each.time_s < from_s || each.time_s > to_s) continue;
    poses.push_back(made->pose);
    poses.back().time_s = each.time_s;
  }
  return poses;
}

MotionFigures figuresOf(const Motion& motion, const MotionOptions& options) {
  constexpr double kShortestSpectrum_s = 1.0, kShortestMovement_s = 0.3;
  MotionFigures figures;
  figures.seconds = motion.seconds;
  figures.validShare = motion.validShare;
  const auto rests = [&](const MotionMoment& each) { return speedOf(each) < options.still_mmPerS && turnOf(each) < options.still_degPerS; };
  double idle_s = 0.0;
  Mean arc, jerk;
  for (const MotionStretch& stretch : motion.stretches) {
    const std::span<const MotionMoment> all(stretch.moments);
    const double seconds = stretch.seconds();
    figures.known_s += seconds;
    figures.path_mm += integral(all, stretch.step_s, speedOf);
    figures.angularPath_deg += integral(all, stretch.step_s, turnOf);
    idle_s += integral(all, stretch.step_s, [&](const MotionMoment& each) { return rests(each) ? 1.0 : 0.0; });
    if (seconds >= kShortestSpectrum_s) {
      std::vector<double> speed;
      for (const MotionMoment& each : all) speed.push_back(speedOf(each));
      arc.add(spectralArcLength(speed, stretch.step_s), seconds);
    }
    for (std::size_t first = 0; first < all.size();) {
      std::size_t end = first;
      while (end < all.size() && !rests(all[end])) ++end;
      const double lasts_s = end > first ? stretch.step_s * static_cast<double>(end - first - 1) : 0.0;
      if (lasts_s >= kShortestMovement_s) jerk.add(logDimensionlessJerk(all.subspan(first, end - first), stretch.step_s), lasts_s);
      first = end + 1;
    }
  }
  if (figures.known_s > 0.0) figures.idleShare = idle_s / figures.known_s;
  figures.spectralArcLength = arc.value();
  figures.logDimensionlessJerk = jerk.value();
  return figures;
}

std::optional<double> spectralArcLength(std::span<const double> speed, double step_s) {
  constexpr double kHighest_hz = 10.0, kLeastAmplitude = 0.05;
  constexpr int kPadding = 4;  // powers of two
  if (speed.size() < 4) return std::nullopt;
  std::size_t size = 1;
  while (size < speed.size()) size *= 2;
  size <<= kPadding;
  std::vector<double> padded(speed.begin(), speed.end());
  padded.resize(size, 0.0);
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  fft.fwd(spectrum, padded);
  const double between_hz = 1.0 / (step_s * static_cast<double>(size)), whole = std::abs(spectrum.front());
  if (!(whole > 0.0)) return std::nullopt;
  std::vector<double> amplitude;
  std::size_t last = 0;
  for (std::size_t n = 0; n < spectrum.size() && static_cast<double>(n) * between_hz <= kHighest_hz; ++n) {
    amplitude.push_back(std::abs(spectrum[n]) / whole);
    if (amplitude.back() >= kLeastAmplitude) last = n;
  }
  if (last == 0) return std::nullopt;
  double length = 0.0;
  for (std::size_t n = 0; n < last; ++n) length += std::hypot(1.0 / static_cast<double>(last), amplitude[n + 1] - amplitude[n]);
  return -length;
}

std::optional<double> logDimensionlessJerk(std::span<const MotionMoment> movement, double step_s) {
  if (movement.size() < 2) return std::nullopt;
  double fastest = 0.0;
  for (const MotionMoment& each : movement) fastest = std::max(fastest, speedOf(each));
  const double seconds = step_s * static_cast<double>(movement.size() - 1);
  const double squared =
      integral(movement, step_s, [](const MotionMoment& each) { return glm::dot(each.jerk_mmPerS3, each.jerk_mmPerS3); });
  if (!(fastest > 0.0) || !(squared > 0.0)) return std::nullopt;
  return -std::log(seconds * seconds * seconds / (fastest * fastest) * squared);
}

}  // namespace ew
