#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "ew/assessment/review_comment.h"
#include "ew/sdk/host.h"
#include "logic/alignment.h"
#include "logic/review_clock.h"
#include "logic/review_tracks.h"
#include "panel/session/review_scan.h"
#include "panel/session/scan_pair.h"

namespace ew::review {

/// The clock of a review as it runs, and how both scans follow it; what happened along it, and the jumps there.
class Playback final : public QObject {
  Q_OBJECT

 public:
  Playback(sdk::Host& host, const ScanPair& scans);

  [[nodiscard]] const ReviewClock& clock() const { return clock_; }
  [[nodiscard]] const TwoScans& times() const { return times_; }
  [[nodiscard]] double time_s(Side side) const;                    ///< on the recording's own clock
  [[nodiscard]] double onClock_s(Side side, double time_s) const;  ///< of a recording's moment, on the review's
  [[nodiscard]] std::size_t frame(Side side) const;                ///< expects an opened scan
  void play();
  void pause();
  void setSpeed(double speed);
  void setAtEnd(AtEnd end);
  void seek(double clock_s);
  void stepFrame(int frames);  ///< of the reviewed scan
  void jump(bool forward);
  void markLoop(bool begin);
  void setOffset(double offset_s);
  void setAligned(bool aligned);  ///< worked out in a job the first time
  [[nodiscard]] bool isAligning() const { return aligning_; }
  /// The scans that are open now, from their beginning, on one clock. It tells nobody: ReviewSession does, when the rest has followed.
  void takeScans();

  [[nodiscard]] const std::vector<Track>& tracks(Side side) const { return tracks_[side]; }
  /// Of the scans that are open. @param comments on the reviewed one
  void setTracks(const std::vector<ReviewComment>& comments);

 Q_SIGNALS:
  void timeChanged();
  void clockChanged();  ///< speed, loop, mode, playing

 private:
  void setRange();
  void align();
  void tick();

  sdk::Host& host_;
  const ScanPair& scans_;
  ReviewClock clock_;
  TwoScans times_;
  std::shared_ptr<const Alignment> alignment_;  ///< of the two scans that are open; null: not worked out
  double offset_s_ = 0.0;
  bool aligning_ = false;
  std::array<std::vector<Track>, 2> tracks_;
  QTimer timer_;
  QElapsedTimer passed_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace ew::review
