// The probe of a session in a tracker: who moves it, and what is shown while nobody knows where it is.
#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr int kLookEvery_ms = 100;
constexpr double kHandMayTake_s = 1.0;  // of a loss: a marker that is covered for a moment is no reason to change hands

}  // namespace

/// What a tracker's threads hold of a session, which may be gone before they are.
struct Session::News {
  std::mutex guard;
  Session* session = nullptr;
  bool isWaiting = false;  ///< told, and not taken yet: a flood of readings is one event
};

Session::~Session() {
  if (!news_) return;
  const std::lock_guard lock(news_->guard);
  news_->session = nullptr;
}

std::function<void()> Session::newsOfTracker() {
  if (!news_) {
    news_ = std::make_shared<News>();
    news_->session = this;
  }
  return [news = news_] {
    const std::lock_guard lock(news->guard);
    if (news->session == nullptr || std::exchange(news->isWaiting, true)) return;
    QMetaObject::invokeMethod(
        news->session, [session = news->session] { session->takeNews(); }, Qt::QueuedConnection);
  };
}

void Session::takeNews() {
  {
    const std::lock_guard lock(news_->guard);
    news_->isWaiting = false;
  }
  if (!tracked_ || source_) return;
  if (mover() == Mover::handMeanwhile) return lookAtTracker();
  if (mover() != Mover::tracker || !isWatched_ || frozen_ || played_ || !subject() || due_) return;
  // A reading that comes too soon waits for no picture: the next one, which is newer, has it.
  if (now_s() < pace_.earliest_s) return;
  due_ = true;
  makePictureNow();
}

const PoseSource& Session::poses() const {
  if (source_) return *source_;
  if (mover() == Mover::tracker) return *tracked_;
  return hand_;
}

/// A free pose may be in the air, also in a case that was made for a hand which never leaves the skin. Who switched contact off in a case
/// that has it wants to see without.
Scene Session::sceneOf(Mover mover) const {
  Scene scene = live_.scene;
  if (mover == Mover::tracker && !scene.contact && subject() && !subject()->scene.contact) scene.contact.emplace();
  return scene;
}

void Session::setTracked(std::shared_ptr<const TrackedProbe> probe) {
  if (probe == tracked_) return;
  if (mover() == Mover::tracker) putHandAtTracked();
  tracked_ = std::move(probe);
  base_ = Mover::tracker;
  isMouseChosen_ = isHandReady_ = false;
  lastTracked_.reset();
  lost_.reset();
  latency_.clear();
  pace_ = {};
  newest_s_ = 0.0;
  tracking_ = tracked_ ? tracked_->report(now_s()) : TrackingReport{};
  tracked_ ? trackerTimer_.start(kLookEvery_ms) : trackerTimer_.stop();
  due();
  Q_EMIT holdChanged();
  Q_EMIT trackingChanged();
}

void Session::chooseMouse(bool mouse) {
  if (!tracked_ || mouse == isMouseChosen_) return;
  if (mouse && mover() == Mover::tracker) putHandAtTracked();
  isMouseChosen_ = mouse;
  base_ = Mover::tracker;
  isHandReady_ = false;
  lost_.reset();
  due();
  Q_EMIT holdChanged();
  Q_EMIT trackingChanged();
}

bool Session::handRests() const { return frozen_ || played_ || source_ || (mover() == Mover::tracker && !(isLost() && isHandReady_)); }

std::optional<FaceReport> Session::face() const {
  if (mover() != Mover::tracker || frozen_ || played_ || isLost() || shown_.gaps_mm.empty()) return std::nullopt;
  return faceOnSkin(shown_.gaps_mm);
}

void Session::putHandAtTracked() {
  if (!lastTracked_ || !skin_) return;
  Hold there = holdFor(*lastTracked_, *skin_);
  there.press_mm = std::max(there.press_mm, usualPress_mm(live_.probe));  // a hand stays on the skin
  hand_.setHold(there);
}

void Session::takeBackByHand() {
  base_ = Mover::handMeanwhile;
  isHandReady_ = false;
  lost_.reset();
  due();
  Q_EMIT holdChanged();
  Q_EMIT trackingChanged();
}

void Session::lookAtTracker() {
  if (!tracked_) return;
  const double now = now_s();
  const TrackingReport before = std::exchange(tracking_, tracked_->report(now));
  const bool isKnown = tracked_->poseAt(now).status == PoseStatus::ok;
  if (mover() == Mover::handMeanwhile && isKnown && !frozen_) {
    base_ = Mover::tracker;
    movedAt_s_.reset();
    due();
    Q_EMIT holdChanged();
    return Q_EMIT trackingChanged();
  }
  if (mover() == Mover::tracker && isWatched_ && !isKnown && !lost_) due();
  if (isLost() && !isHandReady_ && now - *lost_ >= kHandMayTake_s) {
    putHandAtTracked();
    isHandReady_ = true;
    Q_EMIT holdChanged();
  }
  if (before.state != tracking_.state || (isLost() && std::floor(before.since_s) != std::floor(tracking_.since_s)))
    Q_EMIT trackingChanged();
}

/// Instead of a picture: there is no pose to make it from. What shows of earlier pictures in later ones is forgotten here, and where a
/// recording is played again (Scanner::make), so that both go on alike.
void Session::miss(ScanState next) {
  const TrackingReport before = std::exchange(tracking_, tracked_->report(next.time_s));
  if (!isOfThisScan_ || picture_.isEmpty()) {
    putHandAtTracked();
    return takeBackByHand();
  }
  const bool begins = !lost_;
  if (begins) {
    lost_ = next.time_s;
    isHandReady_ = false;
    adaptive_.reset();
    movedAt_s_.reset();
    unsettledFrames_ = 0;
    scanner_.forget();
    cine_.forget();
  }
  const bool isAnotherSize = picture_.width() != width_ || picture_.height() != height_;
  if (isAnotherSize) {
    picture_ = scanner_.make(shown_, width_, height_);
    forming_.reset();
    scanner_.forget();
  }
  next.number = ++live_.number;
  next.gaps_mm.clear();
  missed_ = std::move(next);
  if (begins || before.state != tracking_.state) Q_EMIT trackingChanged();
  if (isAnotherSize) Q_EMIT pictureChanged();
  Q_EMIT poseMissed();
  keepComing();
}

void Session::measureLatency() {
  const double measured_s = shown_.pose.time_s;
  if (!(measured_s > newest_s_)) return;
  newest_s_ = measured_s;
  latency_.add(1e6 * (now_s() - measured_s));
}

}  // namespace ew::ui
