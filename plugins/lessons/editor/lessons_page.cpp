#include "editor/lessons_page.h"

#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/order_list.h"
#include "ew/library/templates.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/lesson_list.h"

namespace ew::lessons {

std::string writtenLanguage() { return QLocale().language() == QLocale::German ? "de" : "en"; }

LessonsPage::LessonsPage(LessonDocument& document, QWidget* parent) : QWidget(parent), document_(document) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  column->setSpacing(kGrid_px);
  column->addWidget(headingLabel(tr("Lessons of this case")));
  none_ = quietLabel(tr("There is none yet. Begin with the usual outline, or with an empty lesson."));
  column->addWidget(none_);
  addList(*column);

  auto* makeRow = new QHBoxLayout;
  makeRow->setSpacing(kGrid_px);
  auto* addButton = smallButton(tr("New lesson"), "addLesson", tr("Make a lesson: empty, or with the steps that a lesson usually has"));
  auto* menu = new QMenu(addButton);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
  addButton->setMenu(menu);
  makeRow->addWidget(addButton);
  makeRow->addStretch(1);
  column->addLayout(makeRow);

  some_ = new QWidget;
  auto* some = new QVBoxLayout(some_);
  some->setContentsMargins(0, 0, 0, 0);
  some->setSpacing(kGrid_px);
  some->addLayout(makeChosenRow());
  some->addLayout(makeOrderRow());
  column->addWidget(some_);
  addUnusedRow(*column);
  column->addStretch(1);
}

void LessonsPage::addList(QVBoxLayout& column) {
  list_ = new OrderList;
  list_->setObjectName(QStringLiteral("editedLessons"));
  list_->setAccessibleName(tr("Lessons of this case"));
  list_->setToolTip(tr("Enter edits a lesson, Alt+Up and Alt+Down move it, Del removes it"));
  connect(list_, &OrderList::removeAsked, this, [this](const QString& id) { remove(id.toStdString()); });
  connect(list_, &OrderList::openAsked, this, &LessonsPage::openAsked);
  connect(list_, &OrderList::moveAsked, this, [this](const QString& id, int place) {
    edit(tr("Move a lesson"),
         [id = id.toStdString(), place](Lessons all) { return withMoved(std::move(all), id, static_cast<std::size_t>(place)); });
  });
  column.addWidget(list_);
}

QHBoxLayout* LessonsPage::makeChosenRow() {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  auto* open = smallButton(tr("Edit"), "editLesson", tr("Edit the chosen lesson and its steps"));
  setLook(open, Look::primary);
  auto* copy = smallButton(tr("Duplicate"), "copyLesson", tr("Put a copy behind the chosen lesson"));
  auto* removeChosen = smallButton(tr("Remove"), "removeLesson", tr("Remove the chosen lesson; undo brings it back"));
  row->addWidget(open);
  row->addWidget(copy);
  row->addWidget(removeChosen);
  row->addStretch(1);
  connect(open, &QPushButton::clicked, this, [this] { Q_EMIT openAsked(words(list_->chosen())); });
  connect(copy, &QPushButton::clicked, this, [this] {
    const Lesson* lesson = lessonIn(document_.lessons(), list_->chosen());
    if (lesson == nullptr) return;
    const std::string title = tr("%1 (copy)").arg(words(lesson->title)).left(200).toStdString();
    edit(tr("Duplicate a lesson"), [id = lesson->id, title](Lessons all) { return withCopyOf(std::move(all), id, title); });
  });
  connect(removeChosen, &QPushButton::clicked, this, [this] { remove(list_->chosen()); });
  return row;
}

QHBoxLayout* LessonsPage::makeOrderRow() {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  auto* up = smallButton(QStringLiteral("\u2191"), "lessonUp", tr("Move the chosen lesson up (Alt+Up)"));
  auto* down = smallButton(QStringLiteral("\u2193"), "lessonDown", tr("Move the chosen lesson down (Alt+Down)"));
  row->addWidget(up);
  row->addWidget(down);
  row->addStretch(1);
  words_ = smallButton({}, "lessonWords", tr("Write what trainees read in another language"));
  row->addWidget(words_);
  connect(up, &QPushButton::clicked, this, [this] { list_->moveChosen(-1); });
  connect(down, &QPushButton::clicked, this, [this] { list_->moveChosen(1); });
  connect(words_, &QPushButton::clicked, this, &LessonsPage::wordsAsked);
  return row;
}

void LessonsPage::addUnusedRow(QVBoxLayout& column) {
  unusedRow_ = new QWidget;
  auto* row = new QVBoxLayout(unusedRow_);
  row->setContentsMargins(0, kGrid_px, 0, 0);
  row->setSpacing(kGrid_px / 2);
  unused_ = quietLabel({});
  unused_->setObjectName(QStringLiteral("unusedLessonFiles"));
  auto* clean = smallButton(tr("Remove them"), "removeUnusedLessonFiles",
                            tr("Remove scans and images that no lesson names; undo cannot bring them back"));
  connect(clean, &QPushButton::clicked, this, &LessonsPage::removeUnused);
  row->addWidget(unused_);
  row->addWidget(clean, 0, Qt::AlignLeft);
  column.addWidget(unusedRow_);
}

void LessonsPage::remove(const std::string& id) {
  edit(tr("Remove a lesson"), [id](Lessons all) { return without(std::move(all), id); });
}

void LessonsPage::fillMenu(QMenu& menu) {
  if (!menu.isEmpty()) return;
  const std::string language = writtenLanguage();
  menu.addAction(tr("Empty"), this, [this, language] { add(newLesson(tr("New lesson").toStdString(), language)); });
  menu.addAction(tr("With the usual steps"), this, [this, language] {
    const auto step = [](const char* kind, const QString& title) {
      return std::pair<std::string_view, std::string>(kind, title.toStdString());
    };
    add(newLesson(tr("New lesson").toStdString(), language,
                  {step("read", tr("Before you begin")), step("settings", tr("Set up the machine")), step("watch", tr("Watch the expert")),
                   step("plane", tr("Find the plane")), step("sweep", tr("Sweep through the organ")), step("measure", tr("Measure")),
                   step("answer", tr("What do you see?")), step("free", tr("Scan on your own"))}));
  });
  auto* templates = menu.addMenu(tr("From a template"));
  const std::string window = QLocale().name().toStdString();
  for (const CaseTemplate& each : listTemplates().templates)
    for (const Lesson& lesson : each.lessons)
      templates->addAction(QStringLiteral("%1: %2").arg(words(each.title.in(window)), words(lesson.title)), this,
                           [this, lesson] { add(lesson); });
  templates->setEnabled(!templates->isEmpty());
}

void LessonsPage::add(Lesson lesson) {
  const std::string after = list_->chosen();
  std::vector<std::string> before;
  for (const Lesson& one : document_.lessons()) before.push_back(one.id);
  edit(tr("Add a lesson"), [&](Lessons all) { return withLesson(std::move(all), lesson, after); });
  for (const Lesson& one : document_.lessons())
    if (std::find(before.begin(), before.end(), one.id) == before.end()) {
      list_->choose(one.id);
      Q_EMIT openAsked(words(one.id));
      return;
    }
}

void LessonsPage::edit(const QString& what, const LessonDocument::Edit& edit) {
  const auto done = document_.edit(what, {}, edit);
  Q_EMIT failed(done ? QString() : words(done.error()));
}

void LessonsPage::showLessons() {
  std::vector<OrderEntry> entries;
  for (const Lesson& lesson : document_.lessons()) {
    const auto problems = document_.problemsOf(lesson).size();
    const QString size = lesson.steps.size() == 1 ? tr("1 step") : tr("%1 steps").arg(lesson.steps.size());
    const QString state = problems == 0 ? tr("ready") : problems == 1 ? tr("1 thing missing") : tr("%1 things missing").arg(problems);
    entries.push_back(
        {lesson.id, words(lesson.title), QStringLiteral("%1, %2, %3").arg(levelText(lesson.level), size, state), problems > 0});
  }
  list_->showEntries(entries);
  const bool isEmpty = entries.empty();
  list_->setVisible(!isEmpty);
  some_->setVisible(!isEmpty);
  none_->setVisible(isEmpty);
  words_->setText(tr("Translations…"));
  const auto unused = document_.home() ? unusedLessonFiles(*document_.home()) : std::vector<std::string>{};
  unusedRow_->setVisible(!unused.empty() && !document_.host().cases().hasUnsavedChanges());
  unused_->setText(unused.size() == 1
                       ? tr("One file of the lessons, %1, is named by none of them.").arg(words(unused.empty() ? "" : unused.front()))
                       : tr("%1 files of the lessons are named by none of them.").arg(unused.size()));
}

void LessonsPage::removeUnused() {
  if (!document_.home() || document_.host().cases().hasUnsavedChanges()) return;
  if (QMessageBox::question(
          this, tr("Remove files"),
          tr("Scans and images that no lesson names are removed from the case folder. Undoing an earlier edit cannot bring "
             "them back."),
          QMessageBox::Ok | QMessageBox::Cancel) != QMessageBox::Ok)
    return;
  std::error_code problem;
  for (const std::string& each : unusedLessonFiles(*document_.home())) std::filesystem::remove(document_.folder() / each, problem);
  Q_EMIT failed(problem ? tr("Not every file could be removed (%1).").arg(words(problem.message())) : QString());
  showLessons();
}

}  // namespace ew::lessons
