#include "scan/frame_timer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/core/order_statistics.h"
#include "ew/imaging/resolved.h"

namespace ew::ui {
namespace {

constexpr std::size_t kRememberedFrames = 25;
constexpr double kFramePeriod_ms = 36.0;  // about 28 frames a second, as a machine shows of a deep abdomen

}  // namespace

FrameTimer::FrameTimer(const ScanContents& scan) : scan_(scan) {
  clock_.start();
  nextFrame_.setSingleShot(true);
  nextFrame_.setTimerType(Qt::PreciseTimer);
  connect(&nextFrame_, &QTimer::timeout, this, &FrameTimer::elapsed);
}

/// By a posted event: one of a timer of 0 ms comes last of all, after every timer that is due.
void FrameTimer::ask() {
  if (isAsked_) return;
  isAsked_ = true;
  QMetaObject::invokeMethod(this, &FrameTimer::asked, Qt::QueuedConnection);
}

void FrameTimer::askNow() {
  isAsked_ = true;
  Q_EMIT asked();
}

bool FrameTimer::takeAsked() { return std::exchange(isAsked_, false); }

void FrameTimer::setWatched(bool watched) {
  isWatched_ = watched;
  if (watched) ask();
}

void FrameTimer::comeAsAMachine(double made_s) {
  // What the image's viewers spend counts as well: at least as long as frame and drawing took, the window is free for the hand.
  const double spent_ms = 1000.0 * (now_s() - made_s);
  // While a hand moves, its next move brings the next frame: one that came by itself just before would only be in its way.
  const double period_ms = showsMove_ ? 2.0 * kFramePeriod_ms : kFramePeriod_ms;
  nextFrame_.start(static_cast<int>(std::lround(std::max(period_ms - spent_ms, std::min(spent_ms, 200.0)))));
}

void FrameTimer::comeAsTracked() {
  const double now = now_s();
  pace_ = trackedPace(frameBegan_s_, now - frameBegan_s_);
  nextFrame_.start(static_cast<int>(std::lround(1000.0 * std::max(0.0, pace_.latest_s - now))));
}

void FrameTimer::setAdaptive(bool adaptive) {
  if (adaptive == isAdaptive_) return;
  isAdaptive_ = adaptive;
  adaptive_.reset();
  ask();
  Q_EMIT adaptiveChanged(adaptive);
}

Knobs FrameTimer::affordableKnobs(const ScanState& next) {
  if (!isAdaptive_) return next.knobs;
  return adaptive_.step(next.knobs, next.pose, next.time_s, lastFrame_ms_, !formsEchoes(next.scene));
}

void FrameTimer::askInFull() {
  if (adaptive_.isLowered()) isAsked_ = true;
  adaptive_.reset();
}

void FrameTimer::noteMove() {
  if (!movedAt_s_) movedAt_s_ = now_s();
}

double FrameTimer::begin() { return frameBegan_s_ = now_s(); }

double FrameTimer::finish(bool isLive) {
  ++framesMade_;
  const double end_s = now_s();
  lastFrame_ms_ = 1000.0 * (end_s - frameBegan_s_);
  showsMove_ = movedAt_s_ && isLive;
  if (showsMove_) latency_.add(1e6 * (end_s - *movedAt_s_));
  movedAt_s_.reset();
  return end_s;
}

void FrameTimer::countFormed(std::optional<double> frame_ms) {
  if (frame_ms) lastFrame_ms_ = *frame_ms;
  ++framesMade_;
}

void FrameTimer::keepTimes(const std::vector<StepTime>& times) {
  recent_.push_back(times);
  if (recent_.size() > kRememberedFrames) recent_.erase(recent_.begin());
}

std::vector<StepTime> FrameTimer::stepTimes() const {
  std::vector<StepTime> medians;
  for (const Step& step : scan_.scanner.plan().steps) {
    std::vector<double> seen;
    for (const auto& frame : recent_) {
      for (const StepTime& time : frame) {
        if (time.kind == step.kind) seen.push_back(time.measured_us);
      }
    }
    if (seen.empty()) continue;
    medians.push_back({step.kind, upperMedianOf(seen)});
  }
  return medians;
}

}  // namespace ew::ui
