// The clock of a review and how both scans follow it.
#include <algorithm>

#include "ew/sdk/window.h"
#include "ew/sdk/words.h"
#include "panel/review_session.h"

namespace ew::review {

using sdk::words;

double ReviewSession::time_s(Side side) const {
  return side == kReviewed ? scans_.inFirst_s(clock_.at_s()) : scans_.inSecond_s(clock_.at_s());
}

double ReviewSession::onClock_s(Side side, double time_s) const {
  return side == kReviewed ? scans_.fromFirst_s(time_s) : scans_.fromSecond_s(time_s);
}

std::size_t ReviewSession::frame(Side side) const { return opened(side)->scan->recording.log.frameAt(time_s(side)); }

void ReviewSession::setRange() {
  Part range = scans_.range();
  if (opened(kReviewed) == nullptr && opened(kCompared) != nullptr) range = {0.0, scans_.second().length_s()};
  if (opened(kCompared) == nullptr) range = {0.0, scans_.first().length_s()};
  clock_.setRange(range.begin_s, range.end_s);
}

void ReviewSession::setTracks() {
  for (const Side side : kSides) {
    tracks_[side].clear();
    if (opened(side) == nullptr) continue;
    const ScanExcerpt& scan = *opened(side)->scan;
    const StepOutcome* outcome = scan.choice.outcome ? &*scan.choice.outcome : nullptr;
    std::vector<ReviewComment> comments;
    if (side == kReviewed) {
      comments = commentsHere();
      for (const CommentFile& file : others_)
        for (const ReviewComment& each : file.comments)
          if (outcome != nullptr && each.stepId == scan.choice.stepId && each.recording == outcome->recording) comments.push_back(each);
    }
    tracks_[side] = tracksOf(scan.recording.log, scan.part, {outcome, scan.marks(), std::move(comments)});
  }
}

void ReviewSession::play() {
  if (opened(kReviewed) == nullptr && opened(kCompared) == nullptr) return;
  clock_.play();
  passed_.start();
  timer_.start();
  Q_EMIT clockChanged();
  Q_EMIT timeChanged();
}

void ReviewSession::pause() {
  const bool was = clock_.isPlaying();
  clock_.pause();
  timer_.stop();
  if (was) Q_EMIT clockChanged();
}

void ReviewSession::tick() {
  clock_.advance(static_cast<double>(passed_.restart()) / 1000.0);
  if (!clock_.isPlaying()) {
    timer_.stop();
    Q_EMIT clockChanged();
  }
  Q_EMIT timeChanged();
}

void ReviewSession::setSpeed(double speed) {
  clock_.setSpeed(speed);
  Q_EMIT clockChanged();
}

void ReviewSession::setAtEnd(AtEnd end) {
  clock_.setAtEnd(end);
  Q_EMIT clockChanged();
}

void ReviewSession::seek(double clock_s) {
  clock_.seek(clock_s);
  Q_EMIT timeChanged();
}

void ReviewSession::stepFrame(int frames) {
  const Side side = opened(kReviewed) != nullptr ? kReviewed : kCompared;
  if (opened(side) == nullptr) return;
  pause();
  const ScanLog& log = opened(side)->scan->recording.log;
  const auto next = static_cast<std::ptrdiff_t>(frame(side)) + frames;
  const auto n = std::clamp<std::ptrdiff_t>(next, 0, static_cast<std::ptrdiff_t>(log.frameCount()) - 1);
  seek(onClock_s(side, log.frameTime_s(static_cast<std::size_t>(n))));
}

void ReviewSession::jump(bool forward) {
  std::vector<double> events_s;
  for (const Side side : kSides)
    for (const double event_s : eventsOf(tracks_[side])) events_s.push_back(onClock_s(side, event_s));
  pause();
  clock_.jump(events_s, forward);
  Q_EMIT timeChanged();
}

void ReviewSession::markLoop(bool begin) {
  if (begin)
    clock_.markBegin();
  else
    clock_.markEnd();
  Q_EMIT clockChanged();
}

void ReviewSession::clearLoop() {
  clock_.setLoop({}, {});
  Q_EMIT clockChanged();
}

void ReviewSession::setOffset(double offset_s) {
  offset_s_ = offset_s;
  if (scans_.isAligned()) return;
  scans_.setOneClock(offset_s);
  setRange();
  Q_EMIT clockChanged();
  Q_EMIT timeChanged();
}

void ReviewSession::setAligned(bool aligned) {
  if (!aligned) {
    scans_.setOneClock(offset_s_);
    setRange();
  } else if (alignment_) {
    scans_.setAligned(alignment_);
    setRange();
  } else {
    align();
  }
  Q_EMIT clockChanged();
  Q_EMIT timeChanged();
}

void ReviewSession::align() {
  if (aligning_ || opened(kReviewed) == nullptr || opened(kCompared) == nullptr) return;
  aligning_ = true;
  auto made = std::make_shared<std::optional<Alignment>>();
  const auto first = opened_[kReviewed]->scan, second = opened_[kCompared]->scan;
  host_.jobs().start(
      tr("Aligning the scans").toStdString(),
      [made, first, second](Progress& progress) -> Result<void> {
        auto found = Alignment::of(first->recording.log, first->part, second->recording.log, second->part, progress);
        if (!found) return passOn(found.error());
        *made = std::move(*found);
        return {};
      },
      [this, made, first, second, alive = std::weak_ptr(alive_)](const Result<void>& done) {
        if (alive.expired()) return;
        aligning_ = false;
        const bool isSame = opened(kReviewed) != nullptr && opened(kReviewed)->scan == first && opened(kCompared) != nullptr &&
                            opened(kCompared)->scan == second;
        if (done && isSame) {
          alignment_ = std::make_shared<const Alignment>(std::move(**made));
          scans_.setAligned(alignment_);
          setRange();
        } else if (!done && done.error().code != ErrorCode::cancelled) {
          host_.window().warn(words(done.error()).toStdString(), "review align");
        }
        Q_EMIT clockChanged();
        Q_EMIT timeChanged();
      });
}

}  // namespace ew::review
