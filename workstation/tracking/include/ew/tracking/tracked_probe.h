#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ew/core/message.h"
#include "ew/tracking/pose_filter.h"
#include "ew/tracking/pose_source.h"
#include "ew/tracking/tracker_calibration.h"
#include "ew/tracking/tracker_device.h"

namespace ew {

struct TrackedProbeOptions {
  std::string tool{};       ///< that carries the probe; empty: the first that is heard of and is not the reference
  std::string reference{};  ///< that the mannequin is fixed to; empty: the tracker stands still
  FilterKind filter = FilterKind::automatic;
  bool predict = true;            ///< ahead to the moment of the image, by at most one period of the tracker
  double staleAfter_s = 0.5;      ///< without news from then on
  double wellMeasured_mm = 10.0;  ///< a reading whose own spread at the transducer face is above is outOfRange
  bool operator==(const TrackedProbeOptions&) const = default;
};

/// How a tracked probe does, for the page and the image.
struct TrackingReport {
  TrackingState state = TrackingState::off;
  Message sentence;           ///< the state in words, and what to do
  double since_s = 0.0;       ///< how long the state has been that
  double rate_hz = 0.0;       ///< of new poses, over the last two seconds
  double delay_s = 0.0;       ///< from the measurement to here, median of the last two seconds; not a number: the tracker stamps nothing
  double jitterTime_s = 0.0;  ///< spread of the intervals between poses
  double noise_mm = 0.0;      ///< of the face as it is read, standard deviation along one axis
  double noise_rad = 0.0;
  double left_mm = 0.0;  ///< of that, what the filter leaves
  double left_rad = 0.0;
  double filterDelay_s = 0.0;            ///< that the filter adds for a steady motion
  double predicted_s = 0.0;              ///< how far the last pose was carried ahead
  double drift_ppm = 0.0;                ///< of the tracker's clock against ours
  FilterKind filter = FilterKind::none;  ///< that is used
  std::string tool, reference;           ///< that are used
};

/// A probe that a tracker follows: readings become poses on the scan's clock. A free pose stays free. While it is not live, poseAt() gives
/// the last good place with a status that is not ok (invalid: it is measured badly, or again and again the same; missing: it is not
/// measured); who shows an image shows that it is none of now. A pose's time is when the reading it rests on was measured, on the scan's
/// clock. A single reading that is missing or bad is bridged, by at most one period. The clock is the caller's: times are arguments, and
/// the readings' arrivals are compared with them. Safe from several threads.
class TrackedProbe final : public PoseSource {
 public:
  /// @param device started and stopped by whoever made it
  /// @param steadyMinusScan_s what steadyNow_s() is ahead of the scan's clock
  TrackedProbe(std::shared_ptr<TrackerDevice> device, const TrackedProbeOptions& options, TrackerCalibration calibration,
               double steadyMinusScan_s);
  ~TrackedProbe() override;

  [[nodiscard]] Pose poseAt(double time_s) const override;
  [[nodiscard]] bool movesAfter(double time_s) const override;

  [[nodiscard]] TrackingReport report(double time_s) const;
  /// The tool in the tracker's frame (in the reference's, where one is chosen) as it was read last, unfiltered: for calibrating.
  [[nodiscard]] std::optional<ToolReading> reading(double time_s) const;

  void setOptions(const TrackedProbeOptions& options);
  [[nodiscard]] TrackedProbeOptions options() const;
  void setCalibration(const TrackerCalibration& calibration);
  [[nodiscard]] TrackerCalibration calibration() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ew
