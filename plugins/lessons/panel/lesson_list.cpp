#include "panel/lesson_list.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/scroll_rows.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/step_kinds.h"

namespace ew::lessons {

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
  rows_ = new ScrollRows(2 * kGrid_px);
  column->addWidget(rows_);
}

void LessonList::showLessons(const std::vector<Lesson>& lessons, const std::vector<LessonStanding>& standings) {
  rows_->clear();
  std::size_t next = 0;  // the first that is not passed; one that was stopped in the middle goes before
  while (next < lessons.size() && standings[next].isPassed(lessons[next].steps.size())) ++next;
  for (std::size_t n = lessons.size(); n-- > 0;)
    if (standings[n].interrupted) next = n;
  for (std::size_t n = 0; n < lessons.size(); ++n) {
    const Lesson& lesson = lessons[n];
    const LessonStanding& stands = standings[n];
    auto* card = new QWidget;
    card->setObjectName(QStringLiteral("lesson_") + words(lesson.id));
    auto* rows = new QVBoxLayout(card);
    rows->setContentsMargins(0, 0, 0, 2 * kGrid_px);
    rows->setSpacing(kGrid_px / 2);
    auto* title = headingLabel(words(lesson.title));
    title->setWordWrap(true);
    rows->addWidget(title);
    rows->addWidget(quietLabel(tr("%1, about %2 min").arg(levelText(lesson.level)).arg(lesson.minutes)));
    if (!lesson.aim.empty()) {
      auto* aim = new QLabel(words(lesson.aim));
      aim->setWordWrap(true);
      aim->setTextFormat(Qt::PlainText);
      rows->addWidget(aim);
    }
    if (stands.attempts > 0) {
      auto* done = quietLabel(tr("%1 of %2 steps passed").arg(stands.bestPassed).arg(stands.counting(lesson.steps.size())));
      done->setObjectName(QStringLiteral("lessonProgress"));
      rows->addWidget(done);
    }
    if (n == next) addSteps(lesson, *rows);
    auto* buttons = new QVBoxLayout;  // beside each other their words are wider than the column in large type
    buttons->setSpacing(kGrid_px);
    const QString id = words(lesson.id);
    if (stands.interrupted) {
      auto* goOn = new QPushButton(tr("Go on at step %1").arg(std::min(stands.interruptedAt + 1, lesson.steps.size())));
      goOn->setObjectName(QStringLiteral("goOnWithLesson"));
      setLook(goOn, Look::primary);
      connect(goOn, &QPushButton::clicked, this, [this, id] { Q_EMIT goOnAsked(id); });
      buttons->addWidget(goOn, 0, Qt::AlignLeft);
    }
    auto* start = new QPushButton(stands.interrupted ? tr("Begin again") : tr("Start"));
    start->setObjectName(QStringLiteral("startLesson"));
    setLook(start, Look::primary, !stands.interrupted);
    start->setAccessibleName(tr("%1: %2").arg(start->text(), words(lesson.title)));
    start->setEnabled(!lesson.steps.empty());
    connect(start, &QPushButton::clicked, this, [this, id] { Q_EMIT startAsked(id); });
    buttons->addWidget(start, 0, Qt::AlignLeft);
    rows->addLayout(buttons);
    rows_->rows()->addWidget(card);
  }
  rows_->rows()->addStretch(1);
}

void LessonList::addSteps(const Lesson& lesson, QVBoxLayout& rows) {
  if (lesson.steps.empty()) return;
  QStringList lines;
  for (const LessonStep& step : lesson.steps) lines << QStringLiteral("%1.  %2").arg(lines.size() + 1).arg(kindTitle(taskWord(step.task)));
  auto* steps = quietLabel(lines.join(QLatin1Char('\n')));
  steps->setObjectName(QStringLiteral("lessonSteps"));
  rows.addWidget(steps);
}

}  // namespace ew::lessons
