#pragma once

#include <cstdint>
#include <deque>
#include <glm/glm.hpp>

namespace ew {

/// Maps the stamps of a tracker's own clock to ours (steadyNow_s()). What comes late says nothing about the clock: delays only add, so that
/// the line below all of (stamp, arrival - stamp) is offset and drift, but for the shortest delay on the way, which nobody can know. The
/// line is the edge of the lower convex hull above the middle of the last minute (Moon, Skelly, Towsley, INFOCOM 1999: it is the one below
/// all points with the least sum of distances). The hull is made of the earliest arrival of each quarter second.
class TrackerClock {
 public:
  /// When a reading was measured, on our clock, at most `arrival_s`.
  /// @param device_s  its stamp; not a number: the tracker stamps nothing, and the arrival counts
  /// @param arrival_s when it came here; never falls
  double steadyOf(double device_s, double arrival_s);

  [[nodiscard]] bool isStamped() const { return isStamped_; }
  /// How much faster the tracker's clock runs than ours, in parts of a million; 0 in the first five seconds.
  [[nodiscard]] double drift_ppm() const { return -1e6 * slope_; }
  /// The tracker stamps with this computer's own steady clock (a camera does): then its stamps are taken as they are, delay and all.
  [[nodiscard]] bool isOurs() const { return isOurs_; }
  /// How often the tracker's clock jumped: it was restarted or set.
  [[nodiscard]] std::uint64_t jumps() const { return jumps_; }
  void reset() { *this = {}; }

 private:
  void begin(double device_s, double arrival_s);
  void jump(double arrival_s);
  bool hasJumped(double device_s, double arrival_s);
  void collect(double device_s, double arrival_s);
  void fit(double arrival_s);
  [[nodiscard]] double lineAt(double device_s) const { return offset_s_ + slope_ * (device_s - from_.x); }

  /// x: stamp, y: arrival - stamp, both less those of the first reading, so that a clock of years keeps its microseconds.
  std::deque<glm::dvec2> earliest_;
  glm::dvec2 from_{0.0};
  double offset_s_ = 0.0;  ///< of the line at the first stamp
  double slope_ = 0.0;
  double lowered_s_ = 0.0;  ///< how far the line was lowered since it was fitted
  double begun_s_ = 0.0;    ///< arrival of the first reading of this map
  double bucketEnds_s_ = 0.0;
  double latestDevice_s_ = 0.0;
  double lateSince_s_ = 0.0;  ///< arrival of the first of the readings that all lie far above the line
  int late_ = 0;
  bool begun_ = false, isStamped_ = false, isOurs_ = false;
  std::uint64_t jumps_ = 0;
};

}  // namespace ew
