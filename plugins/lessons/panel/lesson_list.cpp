#include "panel/lesson_list.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/sdk/panel.h"

namespace ew::lessons {

using sdk::kGap_px;
using sdk::words;

LessonProgress progressOf(const Lesson& lesson, const std::string& caseId, const AttemptList& attempts) {
  LessonProgress progress;
  for (const auto& [folder, attempt] : attempts.attempts) {
    if (attempt.lessonId != lesson.id || attempt.caseId != caseId) continue;
    if (!attempt.finishedAt) {
      if (!progress.interrupted && progress.attempts == 0) {
        progress.interrupted = folder;
        progress.interruptedAt = attempt.outcomes.size();
      }
      continue;
    }
    ++progress.attempts;
    std::size_t passed = 0;
    for (const LessonStep& step : lesson.steps) {
      const StepOutcome* outcome = attempt.outcomeOf(step.id);
      passed += outcome != nullptr && outcome->verdict == StepVerdict::passed ? 1 : 0;
    }
    progress.bestPassed = std::max(progress.bestPassed, passed);
  }
  return progress;
}

QString levelText(int level) {
  switch (level) {
    case 1:
      return LessonList::tr("First steps");
    case 2:
      return LessonList::tr("Basic");
    case 3:
      return LessonList::tr("Intermediate");
    case 4:
      return LessonList::tr("Advanced");
    default:
      return LessonList::tr("Examination");
  }
}

LessonList::LessonList(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  body_ = new QWidget;
  rows_ = new QVBoxLayout(body_);
  rows_->setContentsMargins(2 * kGap_px, 2 * kGap_px, 2 * kGap_px, 2 * kGap_px);
  rows_->setSpacing(kGap_px);
  scroll->setWidget(body_);
  column->addWidget(scroll);
}

void LessonList::showLessons(const std::vector<Lesson>& lessons, const std::vector<LessonProgress>& progress) {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  for (std::size_t n = 0; n < lessons.size(); ++n) {
    const Lesson& lesson = lessons[n];
    const LessonProgress& stands = progress[n];
    auto* card = new QWidget;
    card->setObjectName(QStringLiteral("lesson_") + words(lesson.id));
    auto* rows = new QVBoxLayout(card);
    rows->setContentsMargins(0, 0, 0, 2 * kGap_px);
    rows->setSpacing(kGap_px / 2);
    auto* title = sdk::headingLabel(words(lesson.title));
    title->setWordWrap(true);
    rows->addWidget(title);
    rows->addWidget(sdk::quietLabel(tr("%1, about %2 min").arg(levelText(lesson.level)).arg(lesson.minutes)));
    if (!lesson.aim.empty()) {
      auto* aim = new QLabel(words(lesson.aim));
      aim->setWordWrap(true);
      aim->setTextFormat(Qt::PlainText);
      rows->addWidget(aim);
    }
    if (stands.attempts > 0) {
      auto* done = sdk::quietLabel(tr("%1 of %2 steps passed").arg(stands.bestPassed).arg(lesson.steps.size()));
      done->setObjectName(QStringLiteral("lessonProgress"));
      rows->addWidget(done);
    }
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kGap_px);
    const QString id = words(lesson.id);
    if (stands.interrupted) {
      auto* goOn = new QPushButton(tr("Go on at step %1").arg(std::min(stands.interruptedAt + 1, lesson.steps.size())));
      goOn->setObjectName(QStringLiteral("goOnWithLesson"));
      goOn->setProperty("primary", true);
      connect(goOn, &QPushButton::clicked, this, [this, id] { Q_EMIT goOnAsked(id); });
      buttons->addWidget(goOn);
    }
    auto* start = new QPushButton(stands.interrupted ? tr("Begin again") : tr("Start"));
    start->setObjectName(QStringLiteral("startLesson"));
    start->setProperty("primary", !stands.interrupted);
    start->setAccessibleName(tr("%1: %2").arg(start->text(), words(lesson.title)));
    start->setEnabled(!lesson.steps.empty());
    connect(start, &QPushButton::clicked, this, [this, id] { Q_EMIT startAsked(id); });
    buttons->addWidget(start);
    buttons->addStretch(1);
    rows->addLayout(buttons);
    rows_->addWidget(card);
  }
  rows_->addStretch(1);
}

}  // namespace ew::lessons
