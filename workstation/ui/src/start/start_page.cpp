#include "start/start_page.h"

#include <QAction>
#include <QDesktopServices>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QUrl>
#include <QVBoxLayout>

#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "keys/key_tips.h"
#include "start/card_view.h"
#include "start/case_filters.h"
#include "start/case_lessons.h"
#include "start/course_strip.h"
#include "start/recent_strip.h"

namespace ew::ui {
namespace {

constexpr int kMostAtAGlance = 24;

QLabel* quietLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  setLook(label, Look::quiet);
  label->setWordWrap(true);
  return label;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("startPage"));
  setAttribute(Qt::WA_StyledBackground);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(32, 24, 32, 16);
  rows->setSpacing(12);
  makeHead();
  filters_ = new CaseFilters;
  rows->addWidget(filters_);
  course_ = new CourseStrip;
  rows->addWidget(course_);
  makeList();
  recent_ = new RecentStrip;
  rows->addWidget(recent_);
  hint_ = quietLabel("startHint");
  setLook(hint_, Look::small);
  rows->addWidget(hint_);
  connect(filters_, &CaseFilters::changed, this, &StartPage::find);
  connect(filters_, &CaseFilters::clearRequested, this, &StartPage::clearSearch);
  connect(recent_, &RecentStrip::chosen, this, &StartPage::fileChosen);
  connect(course_, &CourseStrip::lessonChosen, this, &StartPage::lessonChosen);
  QWidget* before = search_;
  for (QWidget* next : filters_->inOrder()) {
    setTabOrder(before, next);
    before = next;
  }
  for (QWidget* next : course_->inOrder()) {
    setTabOrder(before, next);
    before = next;
  }
  setTabOrder(before, cards_);
  setForAuthors(false);
  find();
}

void StartPage::makeHead() {
  auto* head = head_ = new QHBoxLayout;
  head->setSpacing(kGrid_px);
  static_cast<QVBoxLayout*>(layout())->addLayout(head);
  auto* title = new QLabel(tr("Cases"));
  setLook(title, Look::heading);
  head->addWidget(title);
  head->addSpacing(kGrid_px);
  search_ = new QLineEdit;
  search_->setObjectName(QStringLiteral("caseSearch"));
  search_->setAccessibleName(tr("Search the cases"));
  search_->setToolTip(tipWithKeys(tr("Each word is looked for at the beginning of the words of a case (%1)"), "search"));
  search_->setClearButtonEnabled(true);
  search_->setMinimumWidth(200);
  search_->setMaximumWidth(scaled(560));
  search_->setMaxLength(10000);
  search_->installEventFilter(this);
  head->addWidget(search_, 3);
  head->addStretch(1);
  back_ = new QPushButton;
  back_->setObjectName(QStringLiteral("startBack"));
  back_->setToolTip(tr("Back to what is open (Escape)"));
  back_->hide();
  head->addWidget(back_);
  open_ = new QPushButton(icon(QStringLiteral("open"), currentTheme().onAccent), tr("Open…"));
  open_->setObjectName(QStringLiteral("startOpen"));
  setLook(open_, Look::primary);
  open_->setToolTip(tipWithKeys(tr("Open a case, a volume or a sweep (%1)"), "open"));
  head->addWidget(open_);
  connect(search_, &QLineEdit::textChanged, this, &StartPage::find);
  connect(open_, &QPushButton::clicked, this, &StartPage::openRequested);
  connect(back_, &QPushButton::clicked, this, &StartPage::backRequested);
}

void StartPage::makeList() {
  pages_ = new QStackedWidget;
  cards_ = new CardView(list_);
  pages_->addWidget(cards_);
  auto* emptyPage = new QWidget;
  auto* rows = new QVBoxLayout(emptyPage);
  rows->setSpacing(16);
  empty_ = quietLabel("startEmpty");
  empty_->setAlignment(Qt::AlignCenter);
  emptyButton_ = new QPushButton;
  emptyButton_->setObjectName(QStringLiteral("startEmptyButton"));
  rows->addStretch(2);
  rows->addWidget(empty_);
  emptyButtons_ = new QHBoxLayout;
  emptyButtons_->setSpacing(kGrid_px);
  emptyButtons_->addStretch(1);
  emptyButtons_->addWidget(emptyButton_);
  emptyButtons_->addStretch(1);
  rows->addLayout(emptyButtons_);
  rows->addStretch(3);
  pages_->addWidget(emptyPage);
  static_cast<QVBoxLayout*>(layout())->addWidget(pages_, 1);
  connect(cards_, &CardView::chosen, this, &StartPage::caseChosen);
  connect(cards_, &CardView::lessonsAsked, this, &StartPage::showLessonsOf);
  connect(cards_, &CardView::menuAsked, this, &StartPage::showMenuOf);
  connect(cards_, &CardView::sightChanged, this, &StartPage::sightChanged);
  connect(cards_, &CardView::leftUpwards, this, &StartPage::focusSearch);
  connect(cards_, &CardView::typed, this, [this](const QString& text) {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->setText(search_->text() + text);
  });
  connect(emptyButton_, &QPushButton::clicked, this, [this] {
    if (search_->text().isEmpty() && !filters_->isNarrowing()) return openRequested();
    clearSearch();
    focusSearch();
  });
}

void StartPage::addBeginning(QAction* action) {
  const auto make = [this, action](QHBoxLayout& into, int at) {
    auto* button = new QPushButton(action->text().remove(QLatin1Char('&')));
    button->setObjectName(QStringLiteral("startBeginning"));
    into.insertWidget(at, button);
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    connect(action, &QObject::destroyed, button, &QObject::deleteLater);
    return QPointer<QPushButton>(button);
  };
  beginnings_.push_back(make(*head_, head_->indexOf(open_)));
  emptyBeginnings_.push_back(make(*emptyButtons_, emptyButtons_->indexOf(emptyButton_)));
  setTabOrder(back_, beginnings_.back());
  setForAuthors(forAuthors_);
  showEmpty();
}

bool StartPage::choose(const QString& folder) {
  if (!search_->text().isEmpty() || filters_->isNarrowing()) clearSearch();
  for (int n = 0; n < list_.rowCount(); ++n) {
    const CaseRow* row = list_.row(n);
    if (row == nullptr || wordsOf(row->folder) != folder) continue;
    cards_->setCurrentIndex(list_.index(n));
    cards_->scrollTo(list_.index(n));
    cards_->setFocus(Qt::OtherFocusReason);
    return true;
  }
  return false;
}

void StartPage::setIndex(LibraryIndex* index) {
  index_ = index;
  list_.setIndex(index);
  showFound();
}

void StartPage::showFound() {
  if (index_ != nullptr)
    if (const auto choices = index_->choices()) filters_->setChoices(*choices);
  find();
}

CaseQuery StartPage::query() const {
  CaseQuery query;
  query.words = search_->text().toStdString();
  query.forTrainees = !forAuthors_;
  filters_->fill(query);
  return query;
}

void StartPage::find() {
  if (const auto refused = list_.find(query())) Q_EMIT problem(*refused);
  showEmpty();
  Q_EMIT listed();
}

void StartPage::showEmpty() {
  const int count = list_.rowCount();
  const bool isNarrowed = !search_->text().isEmpty() || filters_->isNarrowing();
  filters_->setClearable(isNarrowed && count > 0);  // else the empty page has the button
  filters_->setCount(count == 0 ? QString() : count == 1 ? tr("1 case") : tr("%1 cases").arg(locale().toString(count)));
  pages_->setCurrentIndex(count > 0 ? 0 : 1);
  showCourse();
  if (count > 0) return;
  emptyButton_->setVisible(isNarrowed || !reading_);
  for (const auto& button : emptyBeginnings_)
    if (button) button->setVisible(!isNarrowed && !reading_);
  if (isNarrowed) {
    empty_->setText(tr("No case has all of this. Leave out a word or a filter."));
    emptyButton_->setText(tr("Show all cases"));
    return;
  }
  emptyButton_->setText(tr("Open…"));
  empty_->setText(!problem_.isEmpty() ? problem_
                  : reading_          ? tr("The cases of the library are being read.")
                                      : tr("There are no cases here yet. Open a case folder, a volume or a sweep to begin."));
}

void StartPage::showLearning(std::shared_ptr<const Learning::Known> known) {
  known_ = std::move(known);
  list_.setStandings({known_, &known_->standings});
  showCourse();
}

/// For trainees, as long as nothing is searched for.
void StartPage::showCourse() {
  if (forAuthors_ || !search_->text().isEmpty() || filters_->isNarrowing()) return course_->hide();
  course_->show(*known_);
}

void StartPage::showLessonsOf(int row, const QRect& card_global) {
  const CaseRow* shown = list_.row(row);
  if (shown == nullptr) return;
  auto* lessons = new CaseLessons(*shown, list_.standings(), this);
  connect(lessons, &CaseLessons::lessonChosen, this, &StartPage::lessonChosen);
  connect(lessons, &CaseLessons::caseChosen, this, &StartPage::caseChosen);
  lessons->showAt(card_global);
}

void StartPage::showMenuOf(int row, const QRect& card_global, const QPoint& at_global) {
  const CaseRow* shown = list_.row(row);
  if (shown == nullptr) return;
  if (!forAuthors_) {
    if (!shown->lessons.empty()) showLessonsOf(row, card_global);
    return;
  }
  const QString folder = QString::fromStdString(shown->folder.string());
  const QString title = QString::fromStdString(shown->title);
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("caseMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (!shown->lessons.empty()) menu->addAction(tr("Lessons…"), this, [this, row, card_global] { showLessonsOf(row, card_global); });
  menu->addAction(tr("Open"), this, [this, folder] { Q_EMIT caseChosen(folder); });
  menu->addAction(tr("Show its folder"), this, [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
  auto* withdraw =
      menu->addAction(tr("Take it out of the library…"), this, [this, folder, title] { Q_EMIT withdrawRequested(folder, title); });
  withdraw->setObjectName(QStringLiteral("withdrawCase"));
  withdraw->setEnabled(shown->kind != LibraryKind::shipped);
  menu->popup(at_global);
}

void StartPage::clearSearch() {
  filters_->clear();
  search_->clear();
  find();
}

void StartPage::setReading(bool reading) {
  reading_ = reading;
  showEmpty();
}

void StartPage::setProblem(const QString& problem) {
  problem_ = problem;
  showEmpty();
}

void StartPage::setForAuthors(bool forAuthors) {
  const bool changes = forAuthors_ != forAuthors;
  forAuthors_ = forAuthors;
  search_->setPlaceholderText(forAuthors ? tr("Search by title, region, finding, tag…") : tr("Search by title, region, lesson, tag…"));
  hint_->setText(forAuthors
                     ? tr("A sweep (.igs.mha), a volume (.mha, .mhd, .nrrd, .nii) or a case folder can also be dropped on this window.")
                     : tr("A case folder can also be dropped on this window."));
  for (const auto& button : beginnings_)
    if (button) button->setVisible(forAuthors);
  if (changes) find();
  showCourse();
}

void StartPage::setOpenCase(const QString& name) {
  back_->setVisible(!name.isEmpty());
  back_->setText(tr("Back to the scan"));
  back_->setAccessibleName(tr("Back to %1").arg(name));
}

void StartPage::showRecent(const std::vector<RecentFile>& files) { recent_->show(files); }

void StartPage::setThumbnail(const QString& folder, const QImage& image) { list_.setImage(folder, image); }

void StartPage::setState(const QString& folder, const QString& state, double fraction) { list_.setState(folder, {state, fraction}); }

void StartPage::focusSearch() {
  search_->setFocus(Qt::ShortcutFocusReason);
  search_->selectAll();
}

QStringList StartPage::foldersInSight() const { return pages_->currentIndex() == 0 ? cards_->foldersInSight() : QStringList(); }

QStringList StartPage::foldersAtAGlance() const {
  QStringList folders;
  if (list_.rowCount() > kMostAtAGlance) return folders;
  for (int n = 0; n < list_.rowCount(); ++n)
    if (const CaseRow* row = list_.row(n)) folders << wordsOf(row->folder);
  return folders;
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched != search_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool goesDown = key->key() == Qt::Key_Down || key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (goesDown && list_.rowCount() > 0) {
    cards_->setFocus(Qt::TabFocusReason);
    return true;
  }
  if (key->key() == Qt::Key_Escape && !search_->text().isEmpty()) {
    search_->clear();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace ew::ui
