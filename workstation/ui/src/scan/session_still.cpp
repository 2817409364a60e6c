// What a session shows that does not run: the frozen image, the cine loop before it, a wide image.
#include <utility>

#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr double kFormedAtOnce_ms = 40.0;  // of images of the ring; what takes longer goes on between other events
constexpr std::size_t kFormedAtOnce = 4;   // images, whatever they take: playing at any speed needs no more
constexpr double kFormedInATurn_ms = 12.0;

}  // namespace

void Session::setFrozen(bool frozen) {
  if (frozen == isFrozen() || (frozen && played_)) return;
  const bool wasProcessed = consoleWhileFrozen_.has_value();
  if (frozen) {
    // What is frozen is what the console and the hand say at this moment, as well as they can say it.
    if (adaptive_.isLowered()) due_ = true;
    adaptive_.reset();
    isFreezing_ = true;
    makePictureNow();
    isFreezing_ = false;
    ScanState kept = live_;
    // A probe that somebody else moves is where it was in the picture, and after a loss it was there last.
    kept.pose = mover() == Mover::hand || mover() == Mover::handMeanwhile || picture_.isEmpty() ? pose() : shown_.pose;
    kept.scene = mover() == Mover::tracker && isOfThisScan_ ? shown_.scene : kept.scene;
    kept.gaps_mm = shown_.gaps_mm;
    kept.time_s = shown_.time_s;
    kept.number = shown_.number;
    kept.body = shown_.body;
    asScanned_ = kept;
    frozen_ = std::move(kept);
    if (!cine_.empty()) cineFrame_ = cine_.frameCount() - 1;
  } else {
    frozen_.reset();
    processing_ = {};
    consoleWhileFrozen_.reset();
    isProcessedAnew_ = false;
    formOn_.stop();
    cineFrame_.reset();
    cine_.beginAnew();  // as a machine does: the next loop is of the next scan
    due();
  }
  Q_EMIT frozenChanged(frozen);
  if (wasProcessed) Q_EMIT knobsChanged();
}

bool Session::refuses() {
  if (!frozen_) return false;
  Q_EMIT knobsChanged();
  Q_EMIT changeRefused();
  return true;
}

void Session::forgetCine() {
  cine_.clear();
  formOn_.stop();
  if (!std::exchange(cineFrame_, std::nullopt)) return;
  Q_EMIT cineChanged();
}

void Session::showCine(std::size_t frame) {
  if (!frozen_ || !cineFrame_ || frame >= cine_.frameCount() || frame == *cineFrame_) return;
  cineFrame_ = frame;
  formCine();
  Q_EMIT cineChanged();
}

void Session::formCine() {
  if (!subject() || width_ <= 0 || height_ <= 0) return;
  if (!forming_) forming_ = std::make_unique<Forming>(Forming{{CineForming(*subject(), 0), CineForming(*subject(), 0)}});
  const glm::ivec2 size_px(width_, height_);
  const auto isQuick = [this](std::size_t left) {
    return left <= kFormedAtOnce || static_cast<double>(left) * lastFrame_ms_ <= kFormedAtOnce_ms;
  };
  const std::size_t shown = forming_->shown, other = 1 - shown;
  if (isQuick(forming_->two[shown].aim(cine_, *cineFrame_, size_px, processing_))) return showFormed(shown);
  if (isQuick(forming_->two[other].aim(cine_, *cineFrame_, size_px, processing_))) return showFormed(other);
  formOn_.start(0);
}

void Session::formOn() {
  CineForming& there = forming_->two[1 - forming_->shown];
  const double until_s = now_s() + 0.001 * kFormedInATurn_ms;
  do there.makeNext(cine_);
  while (there.left() > 0 && now_s() < until_s);
  if (there.left() == 0) showFormed(1 - forming_->shown);
}

void Session::showFormed(std::size_t which) {
  formOn_.stop();
  CineForming& here = forming_->two[which];
  const double begin_s = now_s();
  const std::size_t left = here.left();
  while (here.left() > 0) here.makeNext(cine_);
  if (left > 0) lastFrame_ms_ = 1000.0 * (now_s() - begin_s) / static_cast<double>(left);
  forming_->shown = which;
  forming_->isSeen = true;
  asScanned_ = cine_.frame(*cineFrame_);
  frozen_ = processed(asScanned_, processing_);
  shown_ = *frozen_;
  picture_ = here.picture();
  ++framesMade_;
  Q_EMIT pictureChanged();
}

void Session::process(const Knobs& asked, const Pan& part) {
  processing_ = withChange(processing_, console(), asked, part);
  consoleWhileFrozen_ = processed(live_, processing_);
  frozen_ = processed(asScanned_, processing_);
  isProcessedAnew_ = true;
  due();
  Q_EMIT knobsChanged();
}

void Session::setKnobsOfWide(Knobs asked) {
  Knobs sameZoom = asked;
  sameZoom.zoom = knobs().zoom;
  if (sameZoom == knobs()) return setDetail(asked.zoom, asked.zoom > 1.0 ? pan() : Pan{});
  if (refuses()) return;
  asked.zoom = live_.knobs.zoom;
  live_.knobs = asked;
  showWideSettings();
  due();
  Q_EMIT knobsChanged();
}

void Session::showWide(std::optional<Wide> wide) {
  const bool wasShown = wide_.has_value();
  if (!wide && !wasShown) return;
  const Detail before = wasShown ? wide_->shown.detail : Detail{};
  wide_.reset();
  if (wide) {
    wide_.emplace();
    wide_->shown = std::move(*wide);
    wide_->picture.grey = viewOf(std::as_const(wide_->shown.grey));
    showWideSettings();
  }
  if (wasShown != wide_.has_value() || !(before == wide_->shown.detail)) Q_EMIT knobsChanged();
  Q_EMIT pictureChanged();
}

void Session::showWideSettings() {
  wide_->state = frozen_ ? *frozen_ : live_;
  wide_->state.knobs.zoom = wide_->shown.detail.zoom;
  wide_->state.pan = wide_->shown.detail.pan;
}

}  // namespace ew::ui
