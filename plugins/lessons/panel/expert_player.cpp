#include "panel/expert_player.h"

#include <algorithm>

namespace ew::lessons {

/// The recorded poses on a clock that runs and rests. Read by the scan, moved by the player, both on the window's thread.
struct ExpertPlayer::Path final : public PoseSource {
  const ScanLog* log = nullptr;
  double begin_s = 0.0, end_s = 0.0;  ///< of the shown part, on the recording's clock
  double at_s = 0.0;                  ///< where it rests, or where it was at `since_s`
  double since_s = 0.0;               ///< on the scan's clock
  bool running = false;
  double speed = 1.0;

  [[nodiscard]] double recordedTime(double time_s) const {
    return running ? std::min(end_s, at_s + speed * std::max(0.0, time_s - since_s)) : at_s;
  }
  [[nodiscard]] Pose poseAt(double time_s) const override { return log->frame(log->frameAt(recordedTime(time_s))).pose; }
  [[nodiscard]] bool movesAfter(double time_s) const override { return running && recordedTime(time_s) < end_s; }
};

ExpertPlayer::ExpertPlayer(sdk::Host& host, ScanRecording recording, WatchTask task, QObject* parent)
    : QObject(parent), host_(host), recording_(std::move(recording)), task_(std::move(task)), path_(std::make_shared<Path>()) {
  path_->log = &recording_.log;
  path_->begin_s = std::max(recording_.log.begin_s(), task_.begin_s.value_or(recording_.log.begin_s()));
  path_->end_s = std::max(path_->begin_s, std::min(recording_.log.end_s(), task_.end_s.value_or(recording_.log.end_s())));
  path_->at_s = path_->begin_s;
  timer_.setInterval(50);
  connect(&timer_, &QTimer::timeout, this, &ExpertPlayer::tick);
  settings_ = host_.scan().keepSettings();
  applySettings();
  drive_ = host_.scan().drive(path_, [this] {
    rest();
    Q_EMIT takenBack();
  });
}

ExpertPlayer::~ExpertPlayer() {
  drive_.reset();
  settings_.reset();
}

void ExpertPlayer::play() {
  if (ended_) {
    path_->at_s = path_->begin_s;
    nextMark_ = 0;
    ended_ = false;
  }
  atMark_.reset();
  playing_ = true;
  path_->since_s = host_.scan().now_s();
  path_->running = true;
  timer_.start();
  tick();
}

void ExpertPlayer::rest() {
  path_->at_s = path_->recordedTime(host_.scan().now_s());
  path_->running = false;
  playing_ = false;
  timer_.stop();
  Q_EMIT changed();
}

const ExpertMark* ExpertPlayer::mark() const { return atMark_ ? &task_.marks[*atMark_] : nullptr; }

double ExpertPlayer::at_s() const { return path_->recordedTime(host_.scan().now_s()); }

void ExpertPlayer::jumpTo(double time_s) {
  path_->running = false;
  playing_ = false;
  timer_.stop();
  path_->at_s = std::clamp(time_s, path_->begin_s, path_->end_s);
  ended_ = false;
  atMark_.reset();
  nextMark_ = 0;
  while (nextMark_ < task_.marks.size() && task_.marks[nextMark_].time_s < path_->at_s) ++nextMark_;
  applySettings();
  Q_EMIT changed();
}

void ExpertPlayer::setSpeed(double speed) {
  const double now_s = host_.scan().now_s();
  path_->at_s = path_->recordedTime(now_s);
  path_->since_s = now_s;
  path_->speed = speed;
}

void ExpertPlayer::tick() {
  const double at_s = path_->recordedTime(host_.scan().now_s());
  applySettings();
  if (nextMark_ < task_.marks.size() && task_.marks[nextMark_].time_s <= at_s) {
    path_->at_s = std::max(path_->begin_s, task_.marks[nextMark_].time_s);
    path_->running = false;
    atMark_ = nextMark_++;
    playing_ = false;
    timer_.stop();
  } else if (at_s >= path_->end_s) {
    path_->at_s = path_->end_s;
    path_->running = false;
    playing_ = false;
    ended_ = true;
    timer_.stop();
  }
  Q_EMIT changed();
}

void ExpertPlayer::applySettings() {
  const ScanLog& log = recording_.log;
  const ScanState then = log.frame(log.frameAt(path_->recordedTime(host_.scan().now_s())));
  if (!applied_) static_cast<void>(host_.scan().chooseProbe(then.probe.id));  // another one shows the same places less well
  if (applied_ && *applied_ == then.knobs) return;
  if (host_.scan().apply(then.knobs)) applied_ = then.knobs;
}

}  // namespace ew::lessons
