#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <optional>
#include <vector>

#include "ew/imaging/adaptive_quality.h"
#include "ew/imaging/latency.h"
#include "ew/scanning/tracking_pace.h"
#include "scan/scan_contents.h"

namespace ew::ui {

/// When a frame is due, and how good it may be: the scan's clock, the next frame, the quality that falls while the probe moves fast, and
/// what frames took. Makes no image.
class FrameTimer final : public QObject {
  Q_OBJECT

 public:
  /// @param scan must live longer
  explicit FrameTimer(const ScanContents& scan);

  /// On the scan's clock.
  [[nodiscard]] double now_s() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }
  /// Asks for a new image, also where nothing changed. What is asked for in one turn of the event loop is one image.
  void ask();
  /// Likewise, but without waiting for the turn's end.
  void askNow();
  [[nodiscard]] bool isAsked() const { return isAsked_; }
  /// Whether an image was asked for; none is any more.
  bool takeAsked();

  /// Whether anybody sees the image; nobody: no frames come by themselves.
  void setWatched(bool watched);
  [[nodiscard]] bool isWatched() const { return isWatched_; }
  /// The next frame comes by itself, as a machine shows them; later, where a hand is about to bring it. @param made_s when the present one
  /// was begun
  void comeAsAMachine(double made_s);
  /// The next frame comes by itself at the pace of a tracked probe, unless a reading brings it earlier.
  void comeAsTracked();
  void stop() { nextFrame_.stop(); }
  /// A reading that comes now comes too soon for an image of its own.
  [[nodiscard]] bool isTooSoonForTracked() const { return now_s() < pace_.earliest_s; }
  void forgetPace() { pace_ = {}; }

  /// Whether quality may fall while the probe moves fast (imaging/adaptive_quality.h). A frozen image is always made in full.
  void setAdaptive(bool adaptive);
  [[nodiscard]] bool isAdaptive() const { return isAdaptive_; }
  /// Whether the present image was made with less than the console asks for.
  [[nodiscard]] bool isLowered() const { return isAdaptive_ && scan_.isLive() && adaptive_.isLowered(); }
  /// Replaces the limits of the adaptive quality (tests make every frame count as slow).
  void setAdaptiveOptions(const AdaptiveQuality::Options& options) { adaptive_ = AdaptiveQuality(options); }
  /// What the next image can be made with in time. @param next with what the console asks for
  [[nodiscard]] Knobs affordableKnobs(const ScanState& next);
  /// The next image is made in full, and is asked for where the present one was not; it comes when somebody takes it.
  void askInFull();
  void forgetLowering() { adaptive_.reset(); }

  /// The hand moved: the next image is the one that shows it.
  void noteMove();
  void forgetMove() { movedAt_s_.reset(); }
  /// A frame begins now. @returns now_s()
  double begin();
  /// The frame that was begun is there. @param isLive it shows the move that was noted
  /// @returns now_s()
  double finish(bool isLive);
  /// Frames of the loop were formed again, of which the last one is seen. @param frame_ms what each took; empty: none was formed
  void countFormed(std::optional<double> frame_ms);
  void keepTimes(const std::vector<StepTime>& times);
  void forgetTimes() { recent_.clear(); }
  [[nodiscard]] double lastFrame_ms() const { return lastFrame_ms_; }
  /// From a change of the hold to the image that shows it; of a tracked probe from the measurement to the image.
  [[nodiscard]] const LatencyHistogram& latency() const { return latency_; }
  void addLatencySince(double measured_s) { latency_.add(1e6 * (now_s() - measured_s)); }
  void forgetLatency() { latency_.clear(); }
  /// Frames made since the start; they come by themselves only while something changes by itself.
  [[nodiscard]] std::uint64_t framesMade() const { return framesMade_; }
  /// Median time of each step over the last frames, in the plan's order.
  [[nodiscard]] std::vector<StepTime> stepTimes() const;

 Q_SIGNALS:
  void adaptiveChanged(bool adaptive);
  void asked();    ///< the turn is over, or askNow(): takeAsked() tells whether an image is still to be made
  void elapsed();  ///< the time of a frame that comes by itself

 private:
  const ScanContents& scan_;
  QElapsedTimer clock_;
  QTimer nextFrame_;
  bool isAsked_ = false;
  bool isWatched_ = true;
  TrackingPace pace_;
  AdaptiveQuality adaptive_;
  bool isAdaptive_ = true;
  bool showsMove_ = false;  ///< the present image, of a hand
  double frameBegan_s_ = 0.0;
  double lastFrame_ms_ = 0.0;
  std::uint64_t framesMade_ = 0;
  std::optional<double> movedAt_s_;
  LatencyHistogram latency_;
  std::vector<std::vector<StepTime>> recent_;
};

}  // namespace ew::ui
