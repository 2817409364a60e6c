#include "panel/outcome_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/scroll_rows.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/lesson_run.h"

namespace ew::lessons {

OutcomePage::OutcomePage(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  column->setSpacing(kGrid_px);
  heading_ = headingLabel({});
  heading_->setObjectName(QStringLiteral("outcomeHeading"));
  heading_->setWordWrap(true);
  column->addWidget(heading_);
  figure_ = quietLabel({});
  figure_->setObjectName(QStringLiteral("outcomeScore"));
  column->addWidget(figure_);
  toSystem_ = new QLabel;
  toSystem_->setObjectName(QStringLiteral("outcomeToSystem"));
  toSystem_->setTextFormat(Qt::PlainText);
  toSystem_->setWordWrap(true);
  toSystem_->hide();
  column->addWidget(toSystem_);
  remarks_ = new ScrollRows;
  column->addWidget(remarks_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  again_ = new QPushButton(tr("Try again"));
  again_->setObjectName(QStringLiteral("tryAgain"));
  connect(again_, &QPushButton::clicked, this, &OutcomePage::againAsked);
  next_ = new QPushButton;
  next_->setObjectName(QStringLiteral("nextStep"));
  setLook(next_, Look::primary);
  connect(next_, &QPushButton::clicked, this, &OutcomePage::nextAsked);
  buttons->addWidget(again_);
  buttons->addStretch(1);
  buttons->addWidget(next_);
  column->addLayout(buttons);
}

/// A step at the end of a lesson; one that was not passed can be tried again from here.
void OutcomePage::addStep(int number, bool good, const QString& title, bool canRepeat) {
  addRemark(good, title);
  if (good || !canRepeat) return;
  auto* again = new QPushButton(tr("Try this step again"));
  again->setObjectName(QStringLiteral("repeatStep"));
  again->setAccessibleName(tr("Try again: %1").arg(title));
  setLook(again, Look::small);
  connect(again, &QPushButton::clicked, this, [this, number] { Q_EMIT stepAsked(number); });
  remarks_->rows()->addWidget(again, 0, Qt::AlignLeft);
}

/// What one would do next has colour and focus.
void OutcomePage::offer(bool nextFirst) {
  setLook(again_, Look::primary, !nextFirst);
  setLook(next_, Look::primary, nextFirst);
  guard_.begin({again_, next_}, nextFirst ? next_ : again_);
}

void OutcomePage::addRemark(bool good, const QString& text) {
  // The sign says it as well as the words: colour alone would not do.
  auto* row = new QLabel((good ? QStringLiteral("\u2713  ") : QStringLiteral("\u2717  ")) + text);
  row->setObjectName(good ? QStringLiteral("remarkGood") : QStringLiteral("remarkMissed"));
  row->setTextFormat(Qt::PlainText);
  row->setWordWrap(true);
  if (!good) row->setForegroundRole(QPalette::BrightText);
  remarks_->rows()->addWidget(row);
}

void OutcomePage::showStep(const LessonStep& step, const StepOutcome& outcome, bool isLast) {
  remarks_->clear();
  toSystem_->hide();
  const bool passed = outcome.verdict == StepVerdict::passed, handedIn = outcome.verdict == StepVerdict::handedIn;
  const bool isReading = std::holds_alternative<ReadingTask>(step.task);
  heading_->setText(handedIn                                  ? tr("Handed in: %1").arg(words(step.title))
                    : passed && isReading                     ? words(step.title)  // who reads passes nothing
                    : passed                                  ? tr("Passed: %1").arg(words(step.title))
                    : outcome.verdict == StepVerdict::skipped ? tr("Skipped: %1").arg(words(step.title))
                                                              : tr("Not passed yet: %1").arg(words(step.title)));
  const bool hasPoints = !isReading && !std::holds_alternative<WatchTask>(step.task);
  figure_->setText(
      outcome.verdict == StepVerdict::skipped || (!hasPoints && !handedIn) ? QString()
      : handedIn                                                           ? tr("An instructor judges it afterwards.")
                 : tr("%1 of 100 points, %2 needed").arg(std::lround(100.0 * outcome.score)).arg(std::lround(100.0 * step.passLevel)));
  for (const AttemptRemark& remark : outcome.remarks) addRemark(remark.good, words(remark.text));
  if (!step.after.empty()) {
    auto* after = new QLabel(words(step.after));
    after->setObjectName(QStringLiteral("afterStep"));
    after->setTextFormat(Qt::PlainText);
    after->setWordWrap(true);
    remarks_->rows()->addWidget(after);
  }
  remarks_->rows()->addStretch(1);
  again_->setVisible(!handedIn);  // what was handed in is handed in
  again_->setText(isReading ? tr("Read again") : tr("Try again"));
  next_->setText(isLast ? tr("Finish") : tr("Next step"));
  offer(passed || handedIn);
}

void OutcomePage::showExercise(const LessonStep& step, const StepOutcome& outcome, const QString& then) {
  showStep(step, outcome, false);
  const bool passed = outcome.verdict == StepVerdict::passed;
  heading_->setText((passed ? tr("Right: %1") : tr("Not right yet: %1")).arg(words(step.title)));
  auto* comesAgain = quietLabel(then);
  comesAgain->setObjectName(QStringLiteral("comesAgain"));
  remarks_->rows()->insertWidget(remarks_->rows()->count() - 1, comesAgain);
  again_->setText(tr("Stop"));
  next_->setText(tr("Next exercise"));
  offer(true);
}

void OutcomePage::showLesson(const LessonRun& run, const AttemptResult& result) {
  remarks_->clear();
  const auto& steps = run.lesson().steps;
  for (const LessonStep& step : steps) {
    const StepOutcome* outcome = run.outcomeOf(step.id);
    const StepScore* scored = result.counted.of(step.id);
    const bool isHandedIn = outcome != nullptr && outcome->verdict == StepVerdict::handedIn;
    const bool good = outcome != nullptr && scored != nullptr && scored->verdict == StepVerdict::passed;
    addStep(static_cast<int>(&step - steps.data()), good || isHandedIn, words(step.title), result.stepsHandedIn == 0);
  }
  remarks_->rows()->addStretch(1);
  heading_->setText(result.passed().value_or(false) ? tr("Lesson passed: %1").arg(words(run.lesson().title))
                                                    : tr("Lesson finished: %1").arg(words(run.lesson().title)));
  figure_->setText(tr("%1 of %2 steps passed").arg(result.stepsPassed).arg(result.stepsJudged));
  const Message toSystem = systemVerdictRemark(result, result.masteryScore);
  toSystem_->setText(words(toSystem));
  toSystem_->setVisible(!toSystem.empty());
  if (!result.passed()) {
    heading_->setText(tr("Examination handed in: %1").arg(words(run.lesson().title)));
    const auto isEnded = [&](const LessonStep& step) {
      const StepOutcome* outcome = run.outcomeOf(step.id);
      return outcome != nullptr && (outcome->verdict == StepVerdict::handedIn || outcome->verdict == StepVerdict::passed);
    };
    figure_->setText(tr("%1 of %2 steps handed in; an instructor judges them afterwards.")
                         .arg(std::count_if(steps.begin(), steps.end(), isEnded))
                         .arg(steps.size()));
  }
  again_->setVisible(false);
  next_->setText(tr("Back to the lessons"));
  offer(true);
}

}  // namespace ew::lessons
