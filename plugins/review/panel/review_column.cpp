#include "panel/review_column.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QTabWidget>
#include <QTimeZone>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "ew/reports/report_document.h"
#include "ew/sdk/person.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/flow_layout.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/comments_page.h"
#include "panel/rating_page.h"
#include "panel/scores_page.h"
#include "panel/session/review_session.h"

namespace ew::review {

namespace {

constexpr int kFileEntry = -2, kNothingEntry = -1;

QString when(std::chrono::sys_seconds moment) {
  const QDateTime local = QDateTime::fromSecsSinceEpoch(moment.time_since_epoch().count());
  return QLocale().toString(local.date(), QLocale::ShortFormat) + local.time().toString(QStringLiteral(" HH:mm"));
}

QComboBox* choice(const char* name, const QString& spoken) {
  auto* made = new QComboBox;
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(spoken);
  made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  made->setMinimumContentsLength(12);
  return made;
}

}  // namespace

ScansPage::ScansPage(ReviewSession& session, QWidget* parent)
    : QWidget(parent), session_(session), selection_(session.selection()), reviewer_(session.reviewer()), scores_(session.scores()) {
  setObjectName(QStringLiteral("reviewScans"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  rows->setSpacing(kGrid_px / 2);
  const auto field = [&](const QString& title, QWidget* editor, int stretch = 0) {
    auto* label = quietLabel(title);
    label->setBuddy(editor);
    rows->addWidget(label);
    rows->addWidget(editor, stretch);
    rows->addSpacing(kGrid_px / 2);
  };
  lesson_ = choice("reviewLesson", tr("Lesson"));
  connect(lesson_, qOverload<int>(&QComboBox::activated), this, [this](int n) { session_.chooseLesson(static_cast<std::size_t>(n)); });
  field(tr("Lesson"), lesson_);
  attempts_ = new QListWidget;
  attempts_->setObjectName(QStringLiteral("reviewAttempts"));
  attempts_->setAccessibleName(tr("Attempts"));
  attempts_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  holdLeastHeight(*attempts_, 96);
  connect(attempts_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!showing_ && row >= 0) session_.chooseAttempt(static_cast<std::size_t>(row));
  });
  field(tr("Attempts"), attempts_, 1);
  names_ = new QCheckBox(tr("Show names"));
  names_->setObjectName(QStringLiteral("reviewNames"));
  names_->setToolTip(tr("Off: people are called by codes, so that you judge what you see and not whom you know"));
  connect(names_, &QCheckBox::toggled, this, [this](bool on) {
    if (!showing_) reviewer_.setShowsNames(on);
  });
  rows->addWidget(names_);
  rows->addSpacing(kGrid_px / 2);
  step_ = choice("reviewStep", tr("Step"));
  connect(step_, qOverload<int>(&QComboBox::activated), this,
          [this](int n) { session_.chooseStep(step_->itemData(n).toString().toStdString()); });
  field(tr("Step"), step_);
  compared_ = choice("reviewCompared", tr("Compared with"));
  connect(compared_, qOverload<int>(&QComboBox::activated), this, [this](int n) {
    const int entry = compared_->itemData(n).toInt();
    if (entry == kFileEntry) {
      askForFile(kCompared);
      showComparisons();
    } else {
      session_.compareWith(entry == kNothingEntry ? std::nullopt : std::optional(static_cast<std::size_t>(entry)));
    }
  });
  field(tr("Compared with"), compared_);
  makeButtons(*rows);
  connect(&selection_, &ReviewSelection::shelfChanged, this, &ScansPage::refresh);
  connect(&selection_, &ReviewSelection::changed, this, &ScansPage::refresh);
  connect(&scores_, &LessonScores::changed, this, &ScansPage::refresh);
  connect(&session_, &ReviewSession::pageChanged, this, [this] { class_->setChecked(session_.showsClass()); });
  refresh();
}

void ScansPage::makeButtons(QVBoxLayout& rows) {
  note_ = quietLabel({});
  note_->setObjectName(QStringLiteral("reviewNote"));
  rows.addWidget(note_);
  auto* buttons = new QHBoxLayout;
  class_ = new QPushButton(tr("Class overview"));
  class_->setObjectName(QStringLiteral("reviewClass"));
  class_->setCheckable(true);
  class_->setToolTip(tr("How all attempts at this lesson went, step by step"));
  connect(class_, &QPushButton::clicked, this, [this](bool on) { session_.setShowsClass(on); });
  buttons->addWidget(class_, 1);
  auto* file = new QPushButton(tr("Open a recording …"));
  file->setObjectName(QStringLiteral("reviewFile"));
  file->setToolTip(tr("Reviews the recording of a scan from a file, in place of an attempt's"));
  connect(file, &QPushButton::clicked, this, [this] { askForFile(kReviewed); });
  auto* again = new QPushButton(tr("Find new attempts"));
  again->setObjectName(QStringLiteral("reviewRefresh"));
  again->setToolTip(tr("Looks for attempts that were made meanwhile"));
  connect(again, &QPushButton::clicked, this, [this] { session_.readShelf(); });
  rows.addLayout(buttons);
  auto* more = new QWidget;
  auto* flow = new FlowLayout(kGrid_px);
  more->setLayout(flow);
  for (QPushButton* each : {file, again}) {
    each->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    flow->addWidget(each);
  }
  rows.addWidget(more);
}

void ScansPage::refresh() {
  showing_ = true;
  lesson_->clear();
  const ScanShelf& shelf = selection_.shelf();
  std::set<std::string> cases;
  for (const LessonAttempts& each : shelf.lessons) cases.insert(each.home.id);
  for (const LessonAttempts& each : shelf.lessons) {
    const QString lesson = words(each.words.of(each.lesson.title)), home = words(each.words.of(each.home.title));
    lesson_->addItem(cases.size() < 2 ? lesson : tr("%1 – %2", "case – lesson").arg(home, lesson));
    lesson_->setItemData(lesson_->count() - 1, home + QStringLiteral(" – ") + lesson, Qt::ToolTipRole);
  }
  lesson_->setCurrentIndex(selection_.lessonNumber() ? static_cast<int>(*selection_.lessonNumber()) : -1);
  lesson_->setEnabled(lesson_->count() > 0);
  names_->setChecked(reviewer_.showsNames());
  showAttempts();
  showSteps();
  showComparisons();
  class_->setEnabled(selection_.lesson() != nullptr);
  note_->setVisible(shelf.strayAttempts > 0);
  note_->setText(shelf.strayAttempts == 1 ? tr("One attempt belongs to a lesson that is not in this library.")
                                          : tr("%1 attempts belong to lessons that are not in this library.").arg(shelf.strayAttempts));
  showing_ = false;
}

void ScansPage::showAttempts() {
  attempts_->clear();
  const LessonAttempts* of = selection_.lesson();
  if (of == nullptr || of->attempts.empty()) {
    auto* none = new QListWidgetItem(selection_.isReading() ? tr("Looking …")
                                     : of == nullptr        ? tr("No attempts yet")
                                                            : tr("Nobody has tried it yet"),
                                     attempts_);
    none->setFlags(Qt::NoItemFlags);
    return;
  }
  for (std::size_t n = 0; n < of->attempts.size(); ++n) {
    const Attempt& tried = of->attempts[n].second;
    const AttemptResult result = scores_.resultOf(n);
    QStringList said = {reviewer_.personOf(tried)};
    if (tried.finishedAt) {
      if (const auto score = result.score()) said.push_back(percent(*score));
      said.push_back(words(verdictWord(result)));
    }
    const QString state = tried.finishedAt ? tr("%1 of %2 passed").arg(result.stepsPassed).arg(result.stepsJudged) : tr("not finished");
    auto* item = new QListWidgetItem(
        said.join(QStringLiteral(" · ")) + QLatin1Char('\n') + when(tried.startedAt) + QStringLiteral(" · ") + state, attempts_);
    const Message toSystem = systemVerdictRemark(result, result.masteryScore);
    item->setToolTip(tr("%1, %2 on the steps", "attempt, time").arg(item->text(), words(durationText(result.worked_s))) +
                     (toSystem.empty() ? QString() : QLatin1Char('\n') + words(toSystem)));
  }
  attempts_->setCurrentRow(selection_.attemptNumber() ? static_cast<int>(*selection_.attemptNumber()) : -1);
}

void ScansPage::showSteps() {
  step_->clear();
  const LessonAttempts* of = selection_.lesson();
  step_->setEnabled(of != nullptr);
  if (of == nullptr) return;
  for (const LessonStep& step : of->lesson.steps) {
    const auto* tried = selection_.attempt();
    const bool isRecorded = tried != nullptr && scanOfStep(tried->first, tried->second, step).has_value();
    const QString title = words(of->words.of(step.title));
    step_->addItem(isRecorded ? title : tr("%1 (not recorded)").arg(title), words(step.id));
  }
  step_->setCurrentIndex(selection_.step() != nullptr ? step_->findData(words(selection_.step()->id)) : -1);
}

void ScansPage::showComparisons() {
  compared_->clear();
  compared_->addItem(tr("nothing"), kNothingEntry);
  const LessonAttempts* of = selection_.lesson();
  for (std::size_t n = 0; n < selection_.comparisons().size(); ++n) {
    const ScanChoice& scan = selection_.comparisons()[n];
    QString text = words(of != nullptr ? of->words.of(scan.title) : scan.title);
    if (scan.watch) text = tr("Expert: %1").arg(text);
    for (std::size_t a = 0; of != nullptr && a < of->attempts.size(); ++a)
      if (of->attempts[a].first == scan.attempt)
        text = tr("%1, %2", "person, when").arg(reviewer_.personOf(of->attempts[a].second), when(of->attempts[a].second.startedAt));
    compared_->addItem(text, static_cast<int>(n));
  }
  compared_->addItem(tr("A recording from a file …"), kFileEntry);
  compared_->setCurrentIndex(selection_.comparison() ? compared_->findData(static_cast<int>(*selection_.comparison())) : 0);
}

void ScansPage::askForFile(Side side) {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a recording of a scan"), {},
                                                    tr("Recordings of scans (*.seq.mha *.igs.mha *.mha);;All files (*)"));
  if (!file.isEmpty()) session_.openFile(side, file.toStdString());
}

ReviewColumn::ReviewColumn(ReviewSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("reviewColumn"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addLayout(makeReviewer());
  tabs_ = new QTabWidget;
  tabs_->setObjectName(QStringLiteral("reviewTabs"));
  setLook(tabs_, Look::lowPanels);
  tabs_->setDocumentMode(true);
  tabs_->addTab(new ScansPage(session_), tr("Scans"));
  tabs_->addTab(new CommentsPage(session_), tr("Comments"));
  tabs_->addTab(new ScoresPage(session_), tr("Scores"));
  tabs_->addTab(new RatingPage(session_), tr("Rating"));
  tabs_->tabBar()->setUsesScrollButtons(false);
  tabs_->tabBar()->setElideMode(Qt::ElideRight);
  rows->addWidget(tabs_);
}

/// Comments, ratings and plans are kept under this name, so it stands above all pages.
QHBoxLayout* ReviewColumn::makeReviewer() {
  const Reviewer& reviewer = session_.reviewer();
  auto* row = new QHBoxLayout;
  row->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, kGrid_px);
  auto* title = quietLabel(tr("You are"));
  title->setWordWrap(false);
  reviewer_ = new QLineEdit(reviewer.name());
  reviewer_->setObjectName(QStringLiteral("reviewReviewer"));
  reviewer_->setMaxLength(sdk::kLongestPersonName);
  reviewer_->setPlaceholderText(tr("your name, as others read it"));
  reviewer_->setAccessibleName(tr("Your name"));
  title->setBuddy(reviewer_);
  connect(reviewer_, &QLineEdit::editingFinished, this, [this] { session_.setReviewer(reviewer_->text()); });
  connect(&reviewer, &Reviewer::changed, this, [this, &reviewer] { reviewer_->setText(reviewer.name()); });
  connect(&session_.comments(), &AttemptComments::reviewerWanted, this, [this, &reviewer] {
    session_.setReviewer(reviewer_->text());
    if (reviewer.name().isEmpty()) reviewer_->setFocus();
  });
  row->addWidget(title);
  row->addWidget(reviewer_, 1);
  return row;
}

void ReviewColumn::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (const ReviewSelection& selection = session_.selection(); !selection.hasShelf() && !selection.isReading()) session_.readShelf();
}

}  // namespace ew::review
