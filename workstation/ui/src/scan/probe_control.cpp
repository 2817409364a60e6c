#include "scan/probe_control.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace ew::ui {
namespace {

constexpr int kLookEvery_ms = 100;
constexpr double kHandMayTake_s = 1.0;  // of a loss: a marker that is covered for a moment is no reason to change hands

}  // namespace

/// What a tracker's threads hold of a session's probe, which may be gone before they are.
struct ProbeControl::News {
  std::mutex guard;
  ProbeControl* probe = nullptr;
  bool isWaiting = false;  ///< told, and not taken yet: a flood of readings is one event
};

ProbeControl::ProbeControl(ScanContents& scan, FrameTimer& frames) : scan_(scan), frames_(frames) {
  connect(&trackerTimer_, &QTimer::timeout, this, &ProbeControl::lookAtTracker);
}

ProbeControl::~ProbeControl() {
  if (!news_) return;
  const std::lock_guard lock(news_->guard);
  news_->probe = nullptr;
}

std::function<void()> ProbeControl::newsOfTracker() {
  if (!news_) {
    news_ = std::make_shared<News>();
    news_->probe = this;
  }
  return [news = news_] {
    const std::lock_guard lock(news->guard);
    if (news->probe == nullptr || std::exchange(news->isWaiting, true)) return;
    QMetaObject::invokeMethod(
        news->probe, [probe = news->probe] { probe->takeNews(); }, Qt::QueuedConnection);
  };
}

void ProbeControl::takeNews() {
  {
    const std::lock_guard lock(news_->guard);
    news_->isWaiting = false;
  }
  if (!tracked_ || source_) return;
  if (mover() == Mover::handMeanwhile) return lookAtTracker();
  if (mover() != Mover::tracker || !frames_.isWatched() || !scan_.isLive() || !scan_.subject() || frames_.isAsked()) return;
  // A reading that comes too soon waits for no image: the next one, which is newer, has it.
  if (!frames_.isTooSoonForTracked()) frames_.askNow();
}

const PoseSource& ProbeControl::poses() const {
  if (source_) return *source_;
  if (mover() == Mover::tracker) return *tracked_;
  return hand_;
}

Pose ProbeControl::pose() const { return scan_.played ? scan_.played->pose : poseAt(frames_.now_s()); }

/// A free pose may be in the air, also in a case that was made for a hand which never leaves the skin. Who switched contact off in a case
/// that has it wants to see without.
Scene ProbeControl::scene() const {
  Scene scene = scan_.live.scene;
  if (mover() == Mover::tracker && !scene.contact && scan_.subject() && !scan_.subject()->scene.contact) scene.contact.emplace();
  return scene;
}

bool ProbeControl::movesAfter(double time_s) const { return mover() == Mover::tracker || (source_ && source_->movesAfter(time_s)); }

void ProbeControl::setSkin(std::shared_ptr<const Skin> skin) {
  skin_ = std::move(skin);
  if (scan_.live.scene.contact) frames_.ask();
  Q_EMIT holdChanged();
}

void ProbeControl::setHold(const Hold& hold) {
  const bool moves = !(hold == hand_.hold());
  hand_.setHold(hold);
  if (moves && isLost() && isHandReady_) takeBackByHand();
  if (!scan_.frozen && moves && mover() != Mover::tracker) frames_.noteMove();
  frames_.ask();
  Q_EMIT holdChanged();
}

void ProbeControl::pressAsUsual(const Probe& probe) {
  Hold pressed = hand_.hold();
  pressed.press_mm = usualPress_mm(probe);
  hand_.setHold(pressed);
}

void ProbeControl::follow(std::shared_ptr<const PoseSource> source) {
  if (source == source_) return;
  source_ = std::move(source);
  frames_.ask();
  Q_EMIT holdChanged();
  if (tracked_) Q_EMIT trackingChanged();
}

void ProbeControl::setTracked(std::shared_ptr<const TrackedProbe> probe) {
  if (probe == tracked_) return;
  if (mover() == Mover::tracker) putHandAtTracked();
  tracked_ = std::move(probe);
  base_ = Mover::tracker;
  isMouseChosen_ = isHandReady_ = false;
  lastTracked_.reset();
  lost_.reset();
  frames_.forgetLatency();
  frames_.forgetPace();
  newest_s_ = 0.0;
  tracking_ = tracked_ ? tracked_->report(frames_.now_s()) : TrackingReport{};
  tracked_ ? trackerTimer_.start(kLookEvery_ms) : trackerTimer_.stop();
  frames_.ask();
  Q_EMIT holdChanged();
  Q_EMIT trackingChanged();
}

void ProbeControl::chooseMouse(bool mouse) {
  if (!tracked_ || mouse == isMouseChosen_) return;
  if (mouse && mover() == Mover::tracker) putHandAtTracked();
  isMouseChosen_ = mouse;
  base_ = Mover::tracker;
  isHandReady_ = false;
  lost_.reset();
  frames_.ask();
  Q_EMIT holdChanged();
  Q_EMIT trackingChanged();
}

bool ProbeControl::handRests() const { return !scan_.isLive() || source_ || (mover() == Mover::tracker && !(isLost() && isHandReady_)); }

std::optional<FaceReport> ProbeControl::face() const {
  if (mover() != Mover::tracker || !scan_.isLive() || isLost() || scan_.shown.gaps_mm.empty()) return std::nullopt;
  return faceOnSkin(scan_.shown.gaps_mm);
}

void ProbeControl::putHandAtTracked() {
  if (!lastTracked_ || !skin_) return;
  Hold there = holdFor(*lastTracked_, *skin_);
  there.press_mm = std::max(there.press_mm, usualPress_mm(scan_.live.probe));  // a hand stays on the skin
  hand_.setHold(there);
}

void ProbeControl::takeBackByHand() {
  base_ = Mover::handMeanwhile;
  isHandReady_ = false;
  lost_.reset();
  frames_.ask();
  Q_EMIT holdChanged();
  Q_EMIT trackingChanged();
}

void ProbeControl::lookAtTracker() {
  if (!tracked_) return;
  const double now = frames_.now_s();
  const TrackingReport before = std::exchange(tracking_, tracked_->report(now));
  const bool isKnown = tracked_->poseAt(now).status == PoseStatus::ok;
  if (mover() == Mover::handMeanwhile && isKnown && !scan_.frozen) {
    base_ = Mover::tracker;
    frames_.forgetMove();
    frames_.ask();
    Q_EMIT holdChanged();
    return Q_EMIT trackingChanged();
  }
  if (mover() == Mover::tracker && frames_.isWatched() && !isKnown && !lost_) frames_.ask();
  if (isLost() && !isHandReady_ && now - *lost_ >= kHandMayTake_s) {
    putHandAtTracked();
    isHandReady_ = true;
    Q_EMIT holdChanged();
  }
  if (before.state != tracking_.state || (isLost() && std::floor(before.since_s) != std::floor(tracking_.since_s)))
    Q_EMIT trackingChanged();
}

/// What shows of earlier images in later ones is forgotten here, and where a recording is played again (Scanner::make), so that both go
/// on alike.
bool ProbeControl::miss(ScanState next) {
  const TrackingReport before = std::exchange(tracking_, tracked_->report(next.time_s));
  if (!scan_.isOfThisScan || scan_.image.isEmpty()) {
    putHandAtTracked();
    takeBackByHand();
    return false;
  }
  const bool begins = !lost_;
  if (begins) {
    lost_ = next.time_s;
    isHandReady_ = false;
    frames_.forgetLowering();
    frames_.forgetMove();
    scan_.unsettledFrames = 0;
    scan_.scanner.forget();
    scan_.cine.forget();
  }
  const bool isAnotherSize = !scan_.isOfSize();
  if (isAnotherSize) {
    scan_.image = scan_.scanner.make(scan_.shown, scan_.width_px, scan_.height_px);
    scan_.forming.reset();
    scan_.scanner.forget();
  }
  next.number = ++scan_.live.number;
  next.gaps_mm.clear();
  missed_ = std::move(next);
  if (begins || before.state != tracking_.state) Q_EMIT trackingChanged();
  if (isAnotherSize) Q_EMIT lastImageMade();
  Q_EMIT poseMissed();
  return true;
}

bool ProbeControl::endLoss() { return std::exchange(lost_, std::nullopt).has_value(); }

void ProbeControl::tellFound(double time_s) {
  if (tracked_) tracking_ = tracked_->report(time_s);
  Q_EMIT trackingChanged();
}

void ProbeControl::measureLatency() {
  const double measured_s = scan_.shown.pose.time_s;
  if (!(measured_s > newest_s_)) return;
  newest_s_ = measured_s;
  frames_.addLatencySince(measured_s);
}

}  // namespace ew::ui
