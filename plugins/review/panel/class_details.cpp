// Who stands where at a step, and what pass level that suggests.
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "ew/widgets/figures.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/class_page.h"
#include "panel/class_table.h"
#include "panel/review_words.h"
#include "panel/session/review_session.h"

namespace ew::review {

void ClassPage::showAttempts() {
  attempts_->clear();
  const LessonAttempts* of = selection_.lesson();
  if (of == nullptr) return;
  const LessonStep* told = lessonStep(stepId_);
  for (std::size_t n = 0; n < std::min(class_.size(), of->attempts.size()); ++n) {
    const StepScore* here = class_[n].judged(stepId_);
    if (here == nullptr) continue;
    const double level = told != nullptr ? passLevelOf(*told, scores_.plan()) : here->passLevel;
    const bool isSkipped = here->verdict == StepVerdict::skipped, isPassed = here->verdict == StepVerdict::passed;
    auto* item = new SortableItem(attempts_);
    item->setText(kWho, reviewer_.personOf(of->attempts[n].second));
    item->set(kScore, isSkipped ? QStringLiteral("–") : percentBeside(here->score, level), isSkipped ? -1.0 : here->score);
    item->setText(kVerdict, isSkipped ? QStringLiteral("–") : isPassed ? tr("yes") : tr("no"));
    item->setToolTip(kVerdict, words(verdictWord(here->verdict)));
    item->setTextAlignment(kVerdict, Qt::AlignRight | Qt::AlignVCenter);
    QComboBox* stands = standingBox(n);
    stands->setAccessibleName(tr("How %1 stands").arg(item->text(kWho)));
    item->setSizeHint(kStanding, stands->sizeHint() + QSize(kGrid_px, kGrid_px));
    attempts_->setItemWidget(item, kStanding, stands);
  }
  showSuggestion();
}

/// What may be said of whoever made an attempt, and what was.
QComboBox* ClassPage::standingBox(std::size_t attempt) {
  auto* box = new QComboBox;
  setLook(box, Look::small);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  box->setObjectName(QStringLiteral("classStanding"));
  box->setToolTip(tr("What you say here is kept in the library and counts before what raters say"));
  box->addItem(wordByRaters(attempt), static_cast<int>(Standing::unknown));
  box->addItem(tr("should not"), static_cast<int>(Standing::shouldFail));
  box->addItem(tr("should pass"), static_cast<int>(Standing::shouldPass));
  box->setCurrentIndex(box->findData(static_cast<int>(class_[attempt].said)));
  connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, box, attempt] { keepStanding(*box, attempt); });
  return box;
}

/// What counts while nothing is said. Who still has to rate an attempt is not told what others say of it.
QString ClassPage::wordByRaters(std::size_t attempt) const {
  const Standing byRaters = class_[attempt].byRaters;
  const LessonAttempts* of = selection_.lesson();
  const bool isOpen = of != nullptr && attempt < of->attempts.size() && scores_.mayReadRaters(of->attempts[attempt].first);
  if (byRaters != Standing::unknown && !isOpen) return tr("as raters say");
  switch (byRaters) {
    case Standing::shouldPass:
      return tr("should pass, by raters");
    case Standing::shouldFail:
      return tr("should not, by raters");
    case Standing::unknown:
      break;
  }
  return tr("unknown");
}

/// The box stays as it is while its choice is kept: the list is not made anew.
void ClassPage::keepStanding(QComboBox& box, std::size_t attempt) {
  if (attempt >= class_.size()) return;
  if (scores_.keepStanding(class_[attempt].id, static_cast<Standing>(box.currentData().toInt()))) {
    workOut();
    showSuggestion();
    return;
  }
  const QSignalBlocker blocked(&box);
  box.setCurrentIndex(box.findData(static_cast<int>(class_[attempt].said)));
}

void ClassPage::showSuggestion() {
  const ClassStep* step = shownStep();
  if (step == nullptr) return;
  suggested_ = step->suggested ? std::optional(step->suggested->value) : std::nullopt;
  take_->setVisible(suggested_.has_value() && lessonStep(stepId_) != nullptr);
  if (step->suggested)
    suggestion_->setText(tr("The two groups part at %1 (95 % interval %2 to %3).")
                             .arg(percent(step->suggested->value), percent(step->suggested->low), percent(step->suggested->high)));
  else if (step->weight <= 0.0)
    suggestion_->setText(tr("This step does not count in the score, so no level is suggested."));
  else if (step->shouldPass >= 2 && step->shouldFail >= 2)
    suggestion_->setText(
        tr("These two groups do not suggest a level: those who should pass do not score higher, or all of a group have one score."));
  else
    suggestion_->setText(
        tr("Two of each group at least are needed: %1 should pass, %2 should not.").arg(step->shouldPass).arg(step->shouldFail));
}

void ClassPage::keepLevel(double level) {
  AssessmentPlan plan = scores_.plan();
  plan.at(stepId_).passLevel = std::clamp(level, 0.0, 1.0);
  scores_.keepPlan(std::move(plan));
}

}  // namespace ew::review
