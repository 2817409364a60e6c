// Who stands where at a step, and what pass level that suggests.
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "ew/sdk/panel.h"
#include "panel/class_page.h"
#include "panel/class_table.h"
#include "panel/look.h"

namespace ew::review {

using sdk::kGap_px;
using sdk::words;

void ClassPage::showAttempts() {
  attempts_->clear();
  const ShelvedLesson* of = session_.lesson();
  if (of == nullptr) return;
  const std::vector<AttemptResult> all = results();
  const LessonStep* told = lessonStep(stepId_);
  const double level = told != nullptr ? passLevelOf(*told, session_.plan()) : 0.0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const auto here =
        std::find_if(all[n].steps.begin(), all[n].steps.end(), [&](const StepResult& each) { return each.stepId == stepId_; });
    if (here == all[n].steps.end()) continue;
    auto* item = new SortedItem(attempts_);
    const QString who = session_.personOf(of->attempts[n].second);
    item->setText(kWho, who);
    item->set(kScore, here->isSkipped ? QStringLiteral("–") : percentBeside(here->score, level), here->isSkipped ? -1.0 : here->score);
    item->setText(kVerdict, here->isSkipped ? QStringLiteral("–") : here->isPassed ? tr("yes") : tr("no"));
    item->setToolTip(kVerdict, words(verdictWord(here->isSkipped  ? StepVerdict::skipped
                                                 : here->isPassed ? StepVerdict::passed
                                                                  : StepVerdict::failed)));
    item->setTextAlignment(kVerdict, Qt::AlignRight | Qt::AlignVCenter);
    auto* stands = new QComboBox;
    stands->setProperty("small", true);
    stands->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    stands->setObjectName(QStringLiteral("classStanding"));
    stands->setAccessibleName(tr("How %1 stands").arg(who));
    stands->addItem(tr("unknown"));
    stands->addItem(tr("not yet"));
    stands->addItem(tr("competent"));
    stands->setCurrentIndex(static_cast<int>(standings_[all[n].attemptId]));
    connect(stands, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, id = all[n].attemptId](int chosen) {
      standings_[id] = static_cast<Standing>(chosen);
      showSuggestion();
    });
    item->setSizeHint(kStanding, stands->sizeHint() + QSize(kGap_px, kGap_px));
    attempts_->setItemWidget(item, kStanding, stands);
  }
  showSuggestion();
}

void ClassPage::showSuggestion() {
  const std::vector<AttemptResult> all = results();
  std::vector<Standing> standings;
  std::size_t competent = 0, notYet = 0;
  for (const AttemptResult& each : all) {
    const auto known = standings_.find(each.attemptId);
    standings.push_back(known == standings_.end() ? Standing::unknown : known->second);
    competent += standings.back() == Standing::competent ? 1 : 0;
    notYet += standings.back() == Standing::notYet ? 1 : 0;
  }
  const auto level = suggestedPassLevel(all, standings, stepId_);
  suggested_ = level ? std::optional(level->value) : std::nullopt;
  take_->setVisible(suggested_.has_value());
  if (level)
    suggestion_->setText(
        tr("The two groups part at %1 (95 % interval %2 to %3).").arg(percent(level->value), percent(level->low), percent(level->high)));
  else if (competent >= 2 && notYet >= 2)
    suggestion_->setText(tr("These two groups do not suggest a level: those who should pass do not score higher, or no score differs."));
  else
    suggestion_->setText(tr("Two of each group at least are needed: %1 competent, %2 not yet.").arg(competent).arg(notYet));
}

void ClassPage::keepLevel(double level) {
  AssessmentPlan plan = session_.plan();
  plan.at(stepId_).passLevel = std::clamp(level, 0.0, 1.0);
  session_.keepPlan(std::move(plan));
}

}  // namespace ew::review
