#include "scan/cine/replay_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/time_line.h"
#include "keys/key_tips.h"
#include "scan/cine/bar_parts.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

/// The tenth that has begun, as clocks have it.
QString clockOf(double time_s) { return clockText(std::floor(time_s * 10.0 + 1e-6) / 10.0); }

}  // namespace

ReplayBar::ReplayBar(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("replayBar"));
  setLayoutDirection(Qt::LeftToRight);  // as on every player: what comes later stands to the right
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 4, 16, 4);
  row->setSpacing(8);
  play_ = smallButton("replayPlay", QString());
  line_ = new TimeLine;
  line_->setObjectName(QStringLiteral("replayLine"));
  time_ = new QLabel;
  time_->setObjectName(QStringLiteral("replayTime"));
  setLook(time_, Look::small);
  speed_ = new QComboBox;
  speed_->setObjectName(QStringLiteral("replaySpeed"));
  speed_->setToolTip(tr("Speed"));
  speed_->setAccessibleName(tr("Speed"));
  for (const double speed : {0.25, 0.5, 1.0, 2.0, 4.0}) speed_->addItem(tr("%1 ×").arg(speed), speed);
  speed_->setCurrentIndex(2);
  loop_ = smallButton("replayLoop", tr("Begin again at the end"));
  loop_->setCheckable(true);
  save_ = smallButton("replaySave", tr("Save the recording"));
  save_->setText(tr("Save…"));
  close_ = smallButton("replayClose", tr("Close the recording and scan on (Escape)"));
  row->addWidget(play_);
  row->addWidget(line_, 1);
  row->addWidget(time_);
  row->addWidget(speed_);
  row->addWidget(loop_);
  row->addWidget(save_);
  row->addWidget(close_);
  hide();

  tick_.setInterval(kBarTick_ms);
  tick_.setTimerType(Qt::PreciseTimer);
  connect(&tick_, &QTimer::timeout, this, &ReplayBar::advance);
  connect(play_, &QPushButton::clicked, this, [this] { setPlaying(!isPlaying()); });
  connect(line_, &TimeLine::moved, this, [this](double position_s) { seek(position_s); });
  connect(save_, &QPushButton::clicked, this, &ReplayBar::saveAsked);
  connect(close_, &QPushButton::clicked, this, &ReplayBar::closeAsked);
  connect(&session_, &Session::subjectReplaced, this, [this] { setPlaying(false); });
  refreshIcons();
}

double ReplayBar::length_s() const {
  if (!recording_) return 0.0;
  const ScanLog& log = recording_->log;
  return log.end_s() - log.frameTime_s(0);
}

void ReplayBar::load(std::shared_ptr<const ScanRecording> recording) {
  unload();
  recording_ = std::move(recording);
  const double begin_s = recording_->log.frameTime_s(0);
  std::vector<TimeLine::Span> frozen;
  std::vector<double> marks_s;
  for (const ScanEvent& event : recording_->log.events()) {
    if (const auto* change = std::get_if<FreezeChanged>(&event.what)) {
      if (change->isFrozen)
        frozen.push_back({event.time_s - begin_s, length_s()});
      else if (!frozen.empty())
        frozen.back().end_s = event.time_s - begin_s;
    }
    if (std::holds_alternative<Note>(event.what)) marks_s.push_back(event.time_s - begin_s);
  }
  line_->setLength(length_s(), std::move(frozen), std::move(marks_s));
  show();
  seek(0.0);
}

void ReplayBar::unload() {
  setPlaying(false);
  recording_.reset();
  frame_.reset();
  hide();
  session_.play({});
}

void ReplayBar::setPlaying(bool playing) {
  if (playing == isPlaying() || (playing && !recording_)) return;
  if (playing) {
    if (position_s_ >= length_s()) seek(0.0);
    sinceTick_.start();
    tick_.start();
  } else {
    tick_.stop();
  }
  showState();
}

void ReplayBar::advance() {
  const double passed_s = static_cast<double>(sinceTick_.nsecsElapsed()) * 1e-9 * speed_->currentData().toDouble();
  sinceTick_.restart();
  position_s_ += passed_s;
  if (position_s_ >= length_s()) {
    if (loop_->isChecked()) {
      // What went by beyond the end counts: a recording shorter than a tick would stand still at its beginning.
      position_s_ = length_s() > 0.0 ? std::fmod(position_s_, length_s()) : 0.0;
    } else {
      position_s_ = length_s();
      setPlaying(false);
    }
  }
  showFrame();
}

void ReplayBar::seek(double position_s) {
  if (!recording_) return;
  position_s_ = std::clamp(position_s, 0.0, length_s());
  showFrame();
}

void ReplayBar::showFrame() {
  const ScanLog& log = recording_->log;
  const std::size_t frame = log.frameAt(log.frameTime_s(0) + position_s_);
  if (frame_ != frame || !session_.isPlaying()) {
    if (frame_ && frame < *frame_) session_.forgetImages();
    session_.play(log.frame(frame));
    frame_ = frame;
  }
  line_->setPosition(position_s_);
  showState();
}

void ReplayBar::showState() {
  const QString tip = isPlaying() ? tipWithKeys(tr("Pause (%1)"), "freeze") : tipWithKeys(tr("Play (%1)"), "freeze");
  play_->setAccessibleName(tip);
  play_->setToolTip(tip);
  play_->setIcon(icon(isPlaying() ? QStringLiteral("pause") : QStringLiteral("play")));
  time_->setText(tr("%1 of %2").arg(clockOf(position_s_), clockOf(length_s())));
}

void ReplayBar::setSaved(bool saved) { save_->setEnabled(!saved); }

void ReplayBar::refreshIcons() {
  loop_->setIcon(icon(QStringLiteral("loop")));
  close_->setIcon(icon(QStringLiteral("close")));
  showState();
}

}  // namespace ew::ui
