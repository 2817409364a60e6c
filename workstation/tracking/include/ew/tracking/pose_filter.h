#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "ew/core/frames.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

enum class FilterKind { automatic, none, kalman, oneEuro };

struct PoseFilterOptions {
  FilterKind kind = FilterKind::automatic;
  bool predict = true;         ///< beyond the latest reading, by at most one period of the tracker
  double longestGap_s = 0.25;  ///< after a longer one, and after more than four periods, the filter begins anew
  bool operator==(const PoseFilterOptions&) const = default;
};

struct PoseFilterReport {
  FilterKind used = FilterKind::none;
  double period_s = 0.0;   ///< median interval of the readings; 0: not known yet
  double noise_mm = 0.0;   ///< of the readings, standard deviation along one axis, measured; 0: not known yet
  double noise_rad = 0.0;  ///< the same about one axis
  double left_mm = 0.0;    ///< of that noise, what the filter leaves
  double left_rad = 0.0;
  double delay_s = 0.0;          ///< that the filter adds to a motion of constant speed, as it is set now
  std::uint64_t outliers = 0;    ///< readings that none of their neighbours confirmed
  std::uint64_t beginnings = 0;  ///< how often it began: at first, after a gap, after a jump
};

/// Smooths the poses of a transducer's face and carries them to a moment. Three ways:
/// - `kalman`: a Kalman filter with constant velocity, on position and rotation (error state on SO(3)), whose process noise follows its
///   innovations: small while the probe rests, large while it is thrown about. No delay in a steady slide.
/// - `oneEuro`: a low pass whose cut-off grows with speed (Casiez, Roussel, Vogel, CHI 2012), on position and rotation.
/// - `none`: the reading itself.
/// `automatic` measures the noise of the readings and takes `none` where it cannot be seen in an image, else the filter that leaves the
/// least error on paths of a hand; resources/docs/technician/trackers.md has the figures. All are isotropic: the frames of a tracker have
/// no special axis. The readings' noise is measured as the distance of each from the cubic through its two neighbours on either side, which
/// the smooth motion of a hand does not reach; the lower quartile of the last readings counts, so that fast moments do not look like noise.
class PoseFilter {
 public:
  enum class Taken {
    used,
    heldBack,  ///< further away than a hand can come: it waits for a second one that confirms it; without that it is an outlier
    refused,   ///< not finite, or older than the latest one
  };
  explicit PoseFilter(const PoseFilterOptions& options = {});
  PoseFilter(const PoseFilter&);
  PoseFilter& operator=(const PoseFilter&);
  ~PoseFilter();

  /// @param time_s    when it was measured; the same time again counts as a second measurement of that moment
  /// @param spread_mm as the tracker judges this reading against its others; 0: it does not say
  Taken add(double time_s, const Transform<frame::Tracker, frame::Probe>& reading, double spread_mm = 0.0);
  [[nodiscard]] bool empty() const;
  /// Of the latest reading that was used. Not to be asked while empty().
  [[nodiscard]] double latest_s() const;
  /// The pose at a moment: between readings of the last half second interpolated, before them the first of these; after the latest carried
  /// on by at most one period and 50 ms, as far as the speed is more than noise. Not to be asked while empty().
  [[nodiscard]] Transform<frame::Tracker, frame::Probe> at(double time_s) const;
  /// How far at() would carry on.
  [[nodiscard]] double ahead_s(double time_s) const;
  [[nodiscard]] PoseFilterReport report() const;
  /// Forgets the path; what is known of the tracker's noise stays.
  void reset();
  void setOptions(const PoseFilterOptions& options);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ew
