#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "ew/core/frames.h"
#include "ew/tracking/tool_reading.h"

namespace ew::tracking {

/// A pose as filters calculate with it.
struct PlaceAndTurn {
  glm::dvec3 place_mm{0.0};
  glm::dquat turn{1.0, 0.0, 0.0, 0.0};
};

template <class Body>
PlaceAndTurn placeOf(const Transform<frame::Tracker, Body>& t) {
  return {glm::dvec3(t.matrix[3]), glm::normalize(glm::quat_cast(glm::dmat3(t.matrix)))};
}
template <class Body>
Transform<frame::Tracker, Body> transformOf(const PlaceAndTurn& p) {
  Transform<frame::Tracker, Body> t{glm::dmat4(glm::mat3_cast(p.turn))};
  t.matrix[3] = glm::dvec4(p.place_mm, 1.0);
  return t;
}

/// Rotation vector of a unit quaternion, the short way: at most pi long.
inline glm::dvec3 logOf(const glm::dquat& turn) {
  const glm::dvec3 v(turn.x, turn.y, turn.z);
  const double sine = glm::length(v);
  const double sign = turn.w < 0.0 ? -1.0 : 1.0;
  if (sine < 1e-9) return 2.0 * sign * v;
  return 2.0 * sign * std::atan2(sine, std::abs(turn.w)) / sine * v;
}

inline glm::dquat expOf(const glm::dvec3& v_rad) {
  const double angle = glm::length(v_rad);
  const double factor = angle < 1e-6 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  return glm::normalize(glm::dquat(std::cos(0.5 * angle), factor * v_rad.x, factor * v_rad.y, factor * v_rad.z));
}

/// On the way from a to b, the short way round.
inline PlaceAndTurn between(const PlaceAndTurn& a, const PlaceAndTurn& b, double share) {
  return {glm::mix(a.place_mm, b.place_mm, share), glm::normalize(a.turn * expOf(share * logOf(glm::conjugate(a.turn) * b.turn)))};
}

/// What position and rotation have in common: variance of value and rate along each of three equal axes, and how much rate noise is
/// allowed.
struct ConstantVelocity {
  struct Limits {
    double calm = 0.0;     ///< power of the acceleration while nothing moves, unit^2/s^3
    double wild = 0.0;     ///< while it is thrown about
    double rate = 0.0;     ///< standard deviation of a rate of which nothing is known, unit/s
    double fastest = 0.0;  ///< acceleration that no hand reaches, unit/s^2
    double near = 0.0;     ///< a reading no further off than that is no outlier, however quiet the others are
  };
  Limits limits;
  double vv = 0.0, vr = 0.0, rr = 0.0;  ///< covariance of value and rate
  double power = 0.0;
  double surprise = 1.0;  ///< squared innovations against what they should be, smoothed

  void begin(double noise);
  void predict(double dt_s);
  /// How far an innovation may go before a reading is held back.
  [[nodiscard]] double gate(double noise, double dt_s) const;
  /// A rate, less as it is smaller than what is not known of it, and no larger than a hand's.
  [[nodiscard]] glm::dvec3 trust(const glm::dvec3& rate) const {
    const double size = glm::length(rate);
    if (!(size > 0.0)) return rate;
    return rate * std::min(size * size / (size * size + 3.0 * rr), 5.0 * limits.rate / size);
  }
  struct Gain {
    double value = 0.0, rate = 0.0;
  };
  /// Updates the covariance for a reading. @param innovation its length
  Gain update(double innovation, double noise, double dt_s);
};

/// Kalman filter with constant velocity; the rotation is held as a quaternion, its error and rate in the body's axes.
class KalmanPose {
 public:
  KalmanPose();
  void begin(const PlaceAndTurn& reading, double noise_mm, double noise_rad);
  void predict(double dt_s);
  /// Whether a reading is as near to the prediction as a hand can bring it.
  [[nodiscard]] bool accepts(const PlaceAndTurn& reading, double noise_mm, double noise_rad, double dt_s) const;
  void update(const PlaceAndTurn& reading, double noise_mm, double noise_rad, double dt_s);

  [[nodiscard]] const PlaceAndTurn& now() const { return now_; }
  /// As far as they can be told from noise: what prediction goes by.
  [[nodiscard]] glm::dvec3 trustedSpeed_mmPerS() const { return place_.trust(speed_); }
  [[nodiscard]] glm::dvec3 trustedTurning_radPerS() const { return rotation_.trust(turning_); }
  [[nodiscard]] double left_mm() const { return std::sqrt(place_.vv); }
  [[nodiscard]] double left_rad() const { return std::sqrt(rotation_.vv); }

 private:
  PlaceAndTurn now_;
  glm::dvec3 speed_{0.0}, turning_{0.0};
  ConstantVelocity place_, rotation_;
};

/// `p` carried on with constant speed and rotation about its own axes.
[[nodiscard]] PlaceAndTurn carriedOn(const PlaceAndTurn& p, const glm::dvec3& speed, const glm::dvec3& turning, double dt_s);

/// One Euro filter. Rotation: the low pass goes along the shortest way from the filtered to the read rotation.
class OneEuroPose {
 public:
  void begin(const PlaceAndTurn& reading);
  void update(const PlaceAndTurn& reading, double dt_s);
  [[nodiscard]] const PlaceAndTurn& now() const { return now_; }
  /// Share of the standard deviation of white noise that the low pass leaves, and its delay at constant speed.
  [[nodiscard]] double leftOfPlace() const { return leftBy(placeShare_); }
  [[nodiscard]] double leftOfTurn() const { return leftBy(turnShare_); }
  [[nodiscard]] double delay_s() const { return period_s_ * (1.0 - placeShare_) / placeShare_; }

 private:
  static double leftBy(double share) { return std::sqrt(share / (2.0 - share)); }
  PlaceAndTurn now_, reading_;
  glm::dvec3 speed_{0.0}, turning_{0.0};
  double placeShare_ = 1.0, turnShare_ = 1.0, period_s_ = 0.0;
};

/// Measures period and noise of readings.
class ReadingNoise {
 public:
  void add(double time_s, const PlaceAndTurn& reading);
  /// The next reading has no neighbours before it.
  void gap() { recent_.clear(); }
  [[nodiscard]] bool isKnown() const { return isKnown_; }
  [[nodiscard]] double noise_mm() const { return noise_mm_; }
  [[nodiscard]] double noise_rad() const { return noise_rad_; }
  [[nodiscard]] double period_s() const { return period_s_; }

 private:
  static constexpr std::size_t kFewest = 20, kMost = 120;
  struct Timed {
    double time_s;
    PlaceAndTurn pose;
  };
  void measure();
  std::deque<Timed> recent_;                                       ///< at most five
  std::deque<double> placeResiduals_, turnResiduals_, intervals_;  ///< squared, and scaled to variance times a chi-square of three
  int sinceMeasured_ = 0;
  bool isKnown_ = false;
  double noise_mm_ = 0.0, noise_rad_ = 0.0, period_s_ = 0.0;
};

}  // namespace ew::tracking
