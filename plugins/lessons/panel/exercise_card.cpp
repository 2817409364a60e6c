#include "panel/exercise_card.h"

#include <QCheckBox>
#include <QDateTime>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ew/sdk/person.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::lessons {

namespace {

std::chrono::sys_seconds present() { return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()); }

QString dayOf(std::chrono::sys_seconds moment) {
  return QLocale().toString(QDateTime::fromSecsSinceEpoch(moment.time_since_epoch().count()).date(), QLocale::ShortFormat);
}

}  // namespace

ExerciseCard::ExerciseCard(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("exerciseCard"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, kGrid_px);
  column->setSpacing(kGrid_px);
  exercises_ = new QWidget;
  auto* rows = new QVBoxLayout(exercises_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid_px / 2);
  rows->addWidget(headingLabel(tr("Teach yourself")));
  state_ = quietLabel({});
  state_->setObjectName(QStringLiteral("exerciseState"));
  rows->addWidget(state_);
  for (auto* label : {&weakest_, &strongest_}) {
    *label = new QLabel;
    (*label)->setTextFormat(Qt::PlainText);
    (*label)->setWordWrap(true);
    rows->addWidget(*label);
  }
  weakest_->setObjectName(QStringLiteral("exerciseWeakest"));
  strongest_->setObjectName(QStringLiteral("exerciseStrongest"));
  findings_ = new QCheckBox(tr("Ask for findings, too"));
  findings_->setObjectName(QStringLiteral("exerciseFindings"));
  findings_->setToolTip(tr("Some exercises give away what this case has. They come by themselves once its lessons are finished."));
  rows->addWidget(findings_);
  start_ = new QPushButton;
  start_->setObjectName(QStringLiteral("startExercises"));
  connect(start_, &QPushButton::clicked, this, &ExerciseCard::startAsked);
  rows->addWidget(start_, 0, Qt::AlignLeading);
  column->addWidget(exercises_);

  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  person_ = new QLineEdit(words(sdk::personWhoLearns()));
  person_->setObjectName(QStringLiteral("personWhoLearns"));
  person_->setMaxLength(sdk::kLongestPersonName);
  person_->setPlaceholderText(tr("Your name, if you like"));
  person_->setToolTip(tr("Kept with your attempts, so that several people can learn at one workstation. It may stay empty."));
  form->addRow(tr("Learning as"), person_);
  column->addLayout(form);
  connect(person_, &QLineEdit::editingFinished, this, [this] {
    if (person_->text().simplified() == words(sdk::personWhoLearns())) return;
    sdk::setPersonWhoLearns(person_->text());
    Q_EMIT personChanged();
  });
}

bool ExerciseCard::couldAsk(const Case& opened) { return !opened.targets.empty() || !opened.measurements.empty(); }

bool ExerciseCard::withFindings() const { return findings_->isHidden() || findings_->isChecked(); }

void ExerciseCard::showCase(const Case& opened, const CaseWords& caseWords, const std::vector<RepetitionState>& states,
                            bool allLessonsFinished) {
  exercises_->setVisible(couldAsk(opened));
  bool reveals = false;
  for (const CaseTarget& each : opened.targets) reveals = reveals || each.revealsFinding;
  for (const CaseMeasurement& each : opened.measurements) reveals = reveals || each.revealsFinding;
  findings_->setVisible(reveals && !allLessonsFinished);
  if (const QString folder = words(opened.folder.string()); std::exchange(folder_, folder) != folder) findings_->setChecked(false);
  const ExerciseOverview overview = overviewOf(states, opened.id, present());
  QString state;
  if (overview.tried == 0)
    state = tr("The program asks you for planes, organs and measurements of this case, and again for what was hard.");
  else if (overview.due > 0)
    state = overview.due == 1 ? tr("Of %1 exercises tried, one is due.").arg(overview.tried)
                              : tr("Of %1 exercises tried, %2 are due.").arg(overview.tried).arg(overview.due);
  else
    state = tr("Of %1 exercises tried, none is due before %2. There may be new ones.").arg(overview.tried).arg(dayOf(*overview.nextDue));
  state_->setText(state);
  const auto named = [&](const Exercise& exercise) { return words(titleOf(exercise, caseWords.of(exercise.target))); };
  weakest_->setVisible(overview.weakest.has_value());
  if (overview.weakest) weakest_->setText(tr("Still hard: %1").arg(named(*overview.weakest)));
  strongest_->setVisible(overview.strongest.has_value());
  if (overview.strongest) strongest_->setText(tr("Known well: %1").arg(named(*overview.strongest)));
  start_->setText(overview.tried == 0 ? tr("Start exercises") : tr("Go on with exercises"));
}

}  // namespace ew::lessons
