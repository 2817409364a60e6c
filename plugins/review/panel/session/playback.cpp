#include "panel/session/playback.h"

#include <algorithm>
#include <optional>

#include "ew/sdk/window.h"
#include "ew/widgets/words.h"

namespace ew::review {

Playback::Playback(sdk::Host& host, const ScanPair& scans) : host_(host), scans_(scans) {
  timer_.setInterval(33);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Playback::tick);
}

double Playback::time_s(Side side) const { return side == kReviewed ? times_.inFirst_s(clock_.at_s()) : times_.inSecond_s(clock_.at_s()); }

double Playback::onClock_s(Side side, double time_s) const {
  return side == kReviewed ? times_.fromFirst_s(time_s) : times_.fromSecond_s(time_s);
}

std::size_t Playback::frame(Side side) const { return scans_.opened(side)->scan->recording.log.frameAt(time_s(side)); }

void Playback::setRange() {
  Part range = times_.range();
  if (scans_.opened(kReviewed) == nullptr && scans_.opened(kCompared) != nullptr) range = {0.0, times_.second().length_s()};
  if (scans_.opened(kCompared) == nullptr) range = {0.0, times_.first().length_s()};
  clock_.setRange(range.begin_s, range.end_s);
}

void Playback::takeScans() {
  alignment_.reset();
  offset_s_ = 0.0;
  const ReviewScan *first = scans_.opened(kReviewed), *second = scans_.opened(kCompared);
  times_ = TwoScans(first != nullptr ? first->scan->part : Part{}, second != nullptr ? second->scan->part : Part{});
  clock_ = ReviewClock();
  setRange();
  clock_.seek(0.0);
}

void Playback::setTracks(const std::vector<ReviewComment>& comments) {
  for (const Side side : kSides) {
    tracks_[side].clear();
    if (scans_.opened(side) == nullptr) continue;
    const ScanExcerpt& scan = *scans_.opened(side)->scan;
    const StepOutcome* outcome = scan.choice.outcome ? &*scan.choice.outcome : nullptr;
    tracks_[side] =
        tracksOf(scan.recording.log, scan.part, {outcome, scan.marks(), side == kReviewed ? comments : std::vector<ReviewComment>()});
  }
}

void Playback::play() {
  if (scans_.opened(kReviewed) == nullptr && scans_.opened(kCompared) == nullptr) return;
  clock_.play();
  passed_.start();
  timer_.start();
  Q_EMIT clockChanged();
  Q_EMIT timeChanged();
}

void Playback::pause() {
  const bool was = clock_.isPlaying();
  clock_.pause();
  timer_.stop();
  if (was) Q_EMIT clockChanged();
}

void Playback::tick() {
  clock_.advance(static_cast<double>(passed_.restart()) / 1000.0);
  if (!clock_.isPlaying()) {
    timer_.stop();
    Q_EMIT clockChanged();
  }
  Q_EMIT timeChanged();
}

void Playback::setSpeed(double speed) {
  clock_.setSpeed(speed);
  Q_EMIT clockChanged();
}

void Playback::setAtEnd(AtEnd end) {
  clock_.setAtEnd(end);
  Q_EMIT clockChanged();
}

void Playback::seek(double clock_s) {
  clock_.seek(clock_s);
  Q_EMIT timeChanged();
}

void Playback::stepFrame(int frames) {
  const Side side = scans_.opened(kReviewed) != nullptr ? kReviewed : kCompared;
  if (scans_.opened(side) == nullptr) return;
  pause();
  const ScanLog& log = scans_.opened(side)->scan->recording.log;
  const auto next = static_cast<std::ptrdiff_t>(frame(side)) + frames;
  const auto n = std::clamp<std::ptrdiff_t>(next, 0, static_cast<std::ptrdiff_t>(log.frameCount()) - 1);
  seek(onClock_s(side, log.frameTime_s(static_cast<std::size_t>(n))));
}

void Playback::jump(bool forward) {
  std::vector<double> events_s;
  for (const Side side : kSides)
    for (const double event_s : eventsOf(tracks_[side])) events_s.push_back(onClock_s(side, event_s));
  pause();
  clock_.jump(events_s, forward);
  Q_EMIT timeChanged();
}

void Playback::markLoop(bool begin) {
  if (begin)
    clock_.markBegin();
  else
    clock_.markEnd();
  Q_EMIT clockChanged();
}

void Playback::setOffset(double offset_s) {
  offset_s_ = offset_s;
  if (times_.isAligned()) return;
  times_.setOneClock(offset_s);
  setRange();
  Q_EMIT clockChanged();
  Q_EMIT timeChanged();
}

void Playback::setAligned(bool aligned) {
  if (!aligned) {
    times_.setOneClock(offset_s_);
    setRange();
  } else if (alignment_) {
    times_.setAligned(alignment_);
    setRange();
  } else {
    align();
  }
  Q_EMIT clockChanged();
  Q_EMIT timeChanged();
}

void Playback::align() {
  if (aligning_ || scans_.opened(kReviewed) == nullptr || scans_.opened(kCompared) == nullptr) return;
  aligning_ = true;
  auto made = std::make_shared<std::optional<Alignment>>();
  const auto first = scans_.opened(kReviewed)->scan, second = scans_.opened(kCompared)->scan;
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
        const bool isSame = scans_.opened(kReviewed) != nullptr && scans_.opened(kReviewed)->scan == first &&
                            scans_.opened(kCompared) != nullptr && scans_.opened(kCompared)->scan == second;
        if (done && isSame) {
          alignment_ = std::make_shared<const Alignment>(std::move(**made));
          times_.setAligned(alignment_);
          setRange();
        } else if (!done && done.error().code != ErrorCode::cancelled) {
          host_.window().warn(words(done.error()).toStdString(), "review align");
        }
        Q_EMIT clockChanged();
        Q_EMIT timeChanged();
      });
}

}  // namespace ew::review
