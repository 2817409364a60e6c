// Looking at the expert's scan: the part that is shown, its marks, playing it.
#include "editor/watch_form.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/time_line.h"
#include "ew/widgets/words.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/expert_take.h"
#include "editor/order_list.h"
#include "ew/sdk/scan.h"
#include "panel/expert_player.h"

namespace ew::lessons {

QWidget* WatchForm::makePlayPart() {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  line_ = new TimeLine(TimeLine::Use::edited);
  line_->setObjectName(QStringLiteral("timeLine"));
  column->addWidget(line_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  play_ = smallButton(tr("Play"), "playTake", tr("Play the part that trainees see; the probe follows it"));
  speed_ = new QComboBox;
  speed_->setObjectName(QStringLiteral("playSpeed"));
  speed_->setAccessibleName(tr("Speed"));
  for (const double speed : {0.5, 1.0, 2.0, 4.0}) speed_->addItem(QStringLiteral("%1\u00d7").arg(QLocale().toString(speed)), speed);
  speed_->setCurrentIndex(1);
  place_ = quietLabel({});
  place_->setObjectName(QStringLiteral("playPlace"));
  place_->setWordWrap(false);
  row->addWidget(play_);
  row->addWidget(speed_);
  row->addWidget(place_, 1, Qt::AlignRight);
  column->addLayout(row);
  auto* ends = new QHBoxLayout;
  ends->setSpacing(kGrid_px);
  auto* begin = smallButton(tr("Begin here"), "beginHere", tr("Trainees see the scan from here on ([)"));
  auto* end = smallButton(tr("End here"), "endHere", tr("Trainees see the scan up to here (])"));
  ends->addWidget(begin);
  ends->addWidget(end);
  ends->addStretch(1);
  column->addLayout(ends);
  column->addWidget(quietLabel(tr("Marks: the trainee's view rests there and shows the sentence.")));
  marks_ = new QVBoxLayout;
  marks_->setSpacing(kGrid_px);
  column->addLayout(marks_);
  auto* add = smallButton(tr("Mark this moment"), "markMoment", tr("Put a mark where the time line stands"));
  column->addWidget(add, 0, Qt::AlignLeft);
  connect(play_, &QPushButton::clicked, this, &WatchForm::play);
  connect(speed_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    if (player_) player_->setSpeed(speed_->currentData().toDouble());
  });
  connect(begin, &QPushButton::clicked, this, [this] {
    setPart(line_->position_s(), edited().task<WatchTask>().end_s.value_or(1e9));
    showTask(false);
  });
  connect(end, &QPushButton::clicked, this, [this] {
    setPart(edited().task<WatchTask>().begin_s.value_or(-1e9), line_->position_s());
    showTask(false);
  });
  connect(add, &QPushButton::clicked, this, &WatchForm::addMark);
  connect(line_, &TimeLine::moved, this, &WatchForm::lookAt);
  connect(line_, &TimeLine::rangeAsked, this, &WatchForm::setPart);
  connect(line_, &TimeLine::markAsked, this, [this](int number, double time_s) {
    // The order of marks is that of their times: one that is dragged past another would change its number under the hand.
    change(tr("Move a mark"), "mark time " + std::to_string(number), [&](WatchTask& task) {
      const auto n = static_cast<std::size_t>(number);
      if (n >= task.marks.size()) return;
      const double after_s = n > 0 ? task.marks[n - 1].time_s : -1e9;
      const double before_s = n + 1 < task.marks.size() ? task.marks[n + 1].time_s : 1e9;
      task.marks[n].time_s = std::clamp(time_s, after_s, before_s);
    });
    showRecording();
  });
  connect(line_, &TimeLine::released, this, [this] { showTask(false); });
  return part;
}

void WatchForm::showMarks(const WatchTask& task) {
  while (QLayoutItem* item = marks_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  for (std::size_t n = 0; n < task.marks.size(); ++n) marks_->addWidget(makeMark(n, task.marks[n]));
}

QWidget* WatchForm::makeMark(std::size_t number, const ExpertMark& mark) {
  auto* row = new QWidget;
  auto* column = new QVBoxLayout(row);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px / 2);
  auto* head = new QHBoxLayout;
  head->setSpacing(kGrid_px);
  auto* jump = smallButton(clockText(mark.time_s), "", tr("Look at this moment"));
  jump->setObjectName(QStringLiteral("jumpToMark_%1").arg(number));
  auto* here = smallButton(tr("Move here"), "", tr("Move the mark to where the time line stands"));
  here->setObjectName(QStringLiteral("moveMark_%1").arg(number));
  auto* remove = smallButton(tr("Remove"), "", tr("Remove this mark"));
  remove->setObjectName(QStringLiteral("removeMark_%1").arg(number));
  for (QWidget* each : {jump, here, remove}) head->addWidget(each);
  head->addStretch(1);
  column->addLayout(head);
  auto* form = new FieldForm;
  const StepEdit at = edited();
  form->addText(("markText_" + std::to_string(number)).c_str(), {},
                {[at, number] {
                   const WatchTask task = at.task<WatchTask>();
                   return number < task.marks.size() ? words(task.marks[number].text) : QString();
                 },
                 [at, number](const QString& typed) {
                   return at.changeTask<WatchTask>(tr("Change a mark"), "mark " + std::to_string(number), [&](WatchTask& task) {
                     if (number < task.marks.size()) task.marks[number].text = typed.toStdString();
                   });
                 }},
                2);
  form->showValues();
  column->addWidget(form);
  connect(jump, &QPushButton::clicked, this, [this, time_s = mark.time_s] { lookAt(time_s); });
  connect(here, &QPushButton::clicked, this, [this, number] {
    change(tr("Move a mark"), {}, [&](WatchTask& task) {
      if (number >= task.marks.size()) return;
      ExpertMark moved = task.marks[number];
      moved.time_s = line_->position_s();
      task = withMark(withoutMark(std::move(task), number), std::move(moved));
    });
    showTask(false);
  });
  connect(remove, &QPushButton::clicked, this, [this, number] {
    change(tr("Remove a mark"), {}, [&](WatchTask& task) { task = withoutMark(std::move(task), number); });
    showTask(false);
  });
  return row;
}

ExpertPlayer* WatchForm::player() {
  if (!recording_ || take_.isRecording()) return nullptr;
  if (player_) return player_.get();
  if (auto live = edited().document.host().scan().setFrozen(false); !live) {
    say(live);
    return nullptr;
  }
  player_ = std::make_unique<ExpertPlayer>(edited().document.host(), *recording_, WatchTask{});
  player_->setSpeed(speed_->currentData().toDouble());
  connect(player_.get(), &ExpertPlayer::changed, this, &WatchForm::showPlace);
  connect(player_.get(), &ExpertPlayer::takenBack, this, &WatchForm::release, Qt::QueuedConnection);
  return player_.get();
}

void WatchForm::release() {
  player_.reset();
  play_->setText(tr("Play"));
}

void WatchForm::play() {
  ExpertPlayer* playing = player();
  if (playing == nullptr) return;
  if (playing->isPlaying()) return playing->rest();
  const WatchTask task = edited().task<WatchTask>();
  const double begin_s = task.begin_s.value_or(recording_->log.begin_s()), end_s = task.end_s.value_or(recording_->log.end_s());
  const double at_s = line_->position_s();
  playing->jumpTo(at_s < begin_s || at_s >= end_s - 0.05 ? begin_s : at_s);
  playing->play();
}

void WatchForm::lookAt(double time_s) {
  line_->setPosition(time_s);
  if (ExpertPlayer* playing = player()) playing->jumpTo(time_s);
  showPlace();
}

void WatchForm::showPlace() {
  if (player_) {
    line_->setPosition(player_->at_s());
    const auto end_s = edited().task<WatchTask>().end_s;
    if (player_->isPlaying() && end_s && player_->at_s() >= *end_s) return player_->jumpTo(*end_s);
  }
  play_->setText(player_ && player_->isPlaying() ? tr("Pause") : tr("Play"));
  place_->setText(clockText(line_->position_s()));
}

void WatchForm::setPart(double begin_s, double end_s) {
  if (!recording_) return;
  change(tr("Choose the part that is shown"), "part",
         [&](WatchTask& task) { task = trimmed(std::move(task), begin_s, end_s, recording_->log.begin_s(), recording_->log.end_s()); });
  showRecording();
}

void WatchForm::addMark() {
  if (!recording_) return;
  const double at_s = line_->position_s();
  change(tr("Mark a moment"), {}, [&](WatchTask& task) {
    const std::string name = tr("Mark %1").arg(task.marks.size() + 1).toStdString();
    task = withMark(std::move(task), {at_s, name});
  });
  showTask(false);
}

}  // namespace ew::lessons
