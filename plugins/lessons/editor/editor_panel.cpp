#include "editor/editor_panel.h"

#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

#include "editor/lesson_page.h"
#include "editor/lessons_page.h"
#include "editor/order_list.h"
#include "editor/step_editor.h"
#include "editor/words_page.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/lesson_player.h"

namespace ew::lessons {

namespace {

enum EditorPage { kNoCase, kLessonsPage, kLessonPage, kStepPage, kWordsPage, kTryPage };

}  // namespace

EditorPanel::EditorPanel(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host), take_(host), document_(host) {
  setObjectName(QStringLiteral("lessonEditor"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("lessonEditorProblem"));
  problem_->setMargin(2 * kGrid_px);
  column->addWidget(problem_);
  pages_ = new QStackedWidget;
  pages_->addWidget(
      emptyState(tr("No case is open"), tr("Open a case from the start page or the File menu. Then its lessons are made here.")));
  lessons_ = new LessonsPage(document_);
  lesson_ = new LessonPage(document_);
  step_ = new StepEditor(document_, take_);
  words_ = new WordsPage(document_);
  for (QWidget* page : std::initializer_list<QWidget*>{lessons_, lesson_, step_, words_}) pages_->addWidget(page);
  pages_->addWidget(makePreview());
  column->addWidget(pages_, 1);
  connectPages();
  showCase();
}

EditorPanel::~EditorPanel() = default;

QWidget* EditorPanel::makePreview() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, kGrid_px);
  top->setSpacing(kGrid_px);
  auto* back = smallButton(tr("Back to editing"), "endTry", tr("Leave the trial; nothing of it is kept"));
  top->addWidget(back);
  auto* remark = quietLabel(tr("As a trainee sees it; nothing is kept."));
  remark->setObjectName(QStringLiteral("tryRemark"));
  top->addWidget(remark, 1);
  column->addLayout(top);
  player_ = new LessonPlayer(host_);
  player_->setObjectName(QStringLiteral("triedLesson"));
  column->addWidget(player_, 1);
  connect(back, &QPushButton::clicked, this, [this] {
    if (player_->run() != nullptr)
      player_->leave();
    else
      endTry();
  });
  connect(player_, &LessonPlayer::ended, this, &EditorPanel::endTry);
  connect(player_, &LessonPlayer::drivenOut, this, [this] {
    tried_.reset();
    pages_->setCurrentIndex(kNoCase);
    showCase();
  });
  connect(player_, &LessonPlayer::failed, this, &EditorPanel::say);
  connect(player_, &LessonPlayer::problemGone, this, [this] { say({}); });
  return page;
}

void EditorPanel::connectPages() {
  connect(lessons_, &LessonsPage::openAsked, this, [this](const QString& id) { showLesson(id.toStdString()); });
  connect(lessons_, &LessonsPage::wordsAsked, this, &EditorPanel::showWords);
  connect(lessons_, &LessonsPage::failed, this, &EditorPanel::say);
  connect(lesson_, &LessonPage::backAsked, this, &EditorPanel::showLessons);
  connect(lesson_, &LessonPage::openAsked, this, [this](const QString& id) { showStep(id.toStdString()); });
  connect(lesson_, &LessonPage::tryAsked, this, [this] { tryLesson(false); });
  connect(lesson_, &LessonPage::failed, this, &EditorPanel::say);
  connect(step_, &StepEditor::backAsked, this, [this] { showLesson(lessonId_); });
  connect(step_, &StepEditor::stepAsked, this, [this](const QString& id) { showStep(id.toStdString()); });
  connect(step_, &StepEditor::tryAsked, this, [this] { tryLesson(true); });
  connect(words_, &WordsPage::backAsked, this, &EditorPanel::showLessons);
  connect(words_, &WordsPage::failed, this, &EditorPanel::say);
  connect(&document_, &LessonDocument::opened, this, &EditorPanel::showCase);
  connect(&document_, &LessonDocument::changed, this, &EditorPanel::takeChanges);
}

void EditorPanel::showCase() {
  // A lesson that is tried opens the cases of its steps by itself; the editor waits until it comes back.
  if (pages_->currentIndex() == kTryPage && player_->run() != nullptr) return;
  if (!document_.home()) {
    step_->close();
    say(document_.problem() ? words(*document_.problem()) : QString());
    return pages_->setCurrentIndex(kNoCase);
  }
  // Back in the case of a recording, or of a lesson that was tried: where one was.
  if (take_.isRecording() && take_.isFor(take_.lessonId(), take_.stepId())) {
    showLesson(take_.lessonId());
    return showStep(take_.stepId());
  }
  if (tried_ && host_.cases().currentFolder() == tried_->folder) return comeBackTo(*std::exchange(tried_, std::nullopt));
  showLessons();
}

void EditorPanel::takeChanges() {
  if (pages_->currentIndex() == kTryPage) return;
  if (!document_.home()) return showCase();
  if (document_.problem()) say(words(*document_.problem()));
  const Lesson* lesson = lessonIn(document_.lessons(), lessonId_);
  switch (pages_->currentIndex()) {
    case kLessonsPage:
      return lessons_->showLessons();
    case kLessonPage:
      return lesson == nullptr ? showLessons() : lesson_->refresh();
    case kStepPage:
      if (lesson == nullptr) return showLessons();
      return stepIn(*lesson, stepId_) == nullptr ? showLesson(lessonId_) : step_->refresh();
    case kWordsPage:
      return words_->showTexts();
    default:
      return showLessons();
  }
}

void EditorPanel::showLessons() {
  step_->close();
  stepId_.clear();
  say(document_.problem() ? words(*document_.problem()) : QString());
  lessons_->showLessons();
  pages_->setCurrentIndex(kLessonsPage);
}

void EditorPanel::showLesson(const std::string& lessonId) {
  if (lessonIn(document_.lessons(), lessonId) == nullptr) return showLessons();
  const std::string cameFrom = stepId_;
  step_->close();
  lessonId_ = lessonId;
  stepId_.clear();
  say({});
  lesson_->showLesson(lessonId_);
  if (!cameFrom.empty()) lesson_->chooseStep(cameFrom);
  pages_->setCurrentIndex(kLessonPage);
}

void EditorPanel::showStep(const std::string& stepId) {
  const Lesson* lesson = lessonIn(document_.lessons(), lessonId_);
  if (lesson == nullptr || stepIn(*lesson, stepId) == nullptr) return;
  stepId_ = stepId;
  say({});
  pages_->setCurrentIndex(kStepPage);
  step_->showStep(lessonId_, stepId_);
}

void EditorPanel::showWords() {
  say({});
  words_->showTexts();
  pages_->setCurrentIndex(kWordsPage);
}

void EditorPanel::tryLesson(bool onlyStep) {
  const Lesson* lesson = lessonIn(document_.lessons(), lessonId_);
  if (lesson == nullptr || !document_.home()) return;
  if (take_.isRecording()) return say(tr("The expert's scan is being recorded; stop it first."));
  Lesson tried = *lesson;
  if (onlyStep) std::erase_if(tried.steps, [&](const LessonStep& step) { return step.id != stepId_; });
  tried_ = Tried{host_.cases().currentFolder(), lessonId_, onlyStep ? stepId_ : std::string()};
  const Case home = *document_.home();
  step_->close();
  pages_->setCurrentIndex(kTryPage);
  player_->play(LessonRun(std::move(tried), std::nullopt), home, wordsOf(home.folder, QLocale().name().toStdString()));
}

void EditorPanel::endTry() {
  if (pages_->currentIndex() != kTryPage || !tried_) return;
  const QString problem = problem_->text();
  if (host_.cases().currentFolder() == tried_->folder) {
    comeBackTo(*std::exchange(tried_, std::nullopt));
  } else {  // a step had opened another case; the lesson's own comes back, and with it the page where one was
    const auto opening = host_.cases().open(tried_->folder);
    showLessons();
    if (!opening) say(words(opening.error()));
  }
  if (!problem.isEmpty()) say(problem);
}

void EditorPanel::comeBackTo(const Tried& tried) {
  showLesson(tried.lessonId);
  if (!tried.stepId.empty()) showStep(tried.stepId);
}

void EditorPanel::say(const QString& problem) { setProblem(problem_, problem); }

}  // namespace ew::lessons
