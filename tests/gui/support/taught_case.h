#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>

#include "ew/library/case.h"
#include "ew/library/learning_progress.h"
#include "ew/library/lesson.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/case_aside.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

inline LessonStep stepOf(const char* id, LessonTask task) {
  LessonStep made;
  made.id = id;
  made.title = std::string("Title of ") + id;
  made.text = "What to do in this step.";
  made.task = std::move(task);
  return made;
}

/// A question whose first option is right and whose second is wrong.
inline LessonStep questionOf(const char* id) {
  return stepOf(id, AnswerTask{{{"A ball", true, "It is round."}, {"A cube", false, "It has no corners."}}, {}, 0.0, ""});
}

inline Lesson lessonOf(const char* id, std::vector<LessonStep> steps) {
  Lesson made;
  made.id = id;
  made.title = std::string("Lesson ") + id;
  made.aim = "You know a ball when you see one.";
  made.steps = std::move(steps);
  return made;
}

/// "first" and "second" of two steps, "third" of three.
inline std::vector<Lesson> threeLessons() {
  return {lessonOf("first", {stepOf("read", ReadingTask{}), questionOf("answer")}),
          lessonOf("second", {stepOf("read", ReadingTask{}), questionOf("answer")}),
          lessonOf("third", {stepOf("read", ReadingTask{}), questionOf("answer"), stepOf("last", ReadingTask{})})};
}

/// Gives a case that lies in a folder these lessons, an id and a title. @return whether it could be written
inline bool teach(const QString& folder, const std::string& id, const std::string& title, const std::vector<Lesson>& lessons) {
  auto opened = loadCaseAside(folder.toStdString());
  if (!opened) return false;
  opened->id = id;
  opened->title = title;
  opened->otherFields["parts"]["lessons"] = jsonOf(lessons);
  return saveCase(*opened, folder.toStdString()).has_value();
}

/// A test in which a trainee chooses lessons on the start page and works through them.
class LearnerFixture : public WindowFixture {
 protected:
  [[nodiscard]] QWidget* player() const { return find<QWidget>("lessonPlayer"); }
  [[nodiscard]] QString text(const char* name) const {
    if (player() == nullptr) return {};
    for (const QLabel* label : player()->findChildren<QLabel*>(QLatin1String(name)))
      if (label->isVisible()) return label->text();
    return {};
  }
  template <class Widget = QPushButton>
  [[nodiscard]] Widget* seen(const char* name) const {
    for (Widget* each : window_->findChildren<Widget*>(QLatin1String(name)))
      if (each->isVisible()) return each;
    return nullptr;
  }
  void press(const char* name) {
    QVERIFY2(waitUntil([&] { return seen(name) != nullptr && seen(name)->isEnabled(); }), name);
    QTest::mouseClick(seen(name), Qt::LeftButton);
  }
  /// Whether the window said so, perhaps below other messages, which are dismissed.
  [[nodiscard]] bool said(const char* words) const {
    while (window_->messages().count() > 0) {
      if (window_->messages().text().contains(QLatin1String(words))) return true;
      window_->messages().dismiss();
    }
    return false;
  }
  void waitForStep(const char* id) {
    QVERIFY2(waitUntil([&] { return text("stepTitle") == QStringLiteral("Title of ") + QLatin1String(id); }),
             qPrintable(QLatin1String(id) + QStringLiteral(" is not shown but ") + text("stepTitle") + window_->messages().text()));
  }
  void waitForOutcome(const QString& begin) {
    QVERIFY2(waitUntil([&] { return text("outcomeHeading").startsWith(begin); }),
             qPrintable(text("outcomeHeading") + text("lessonProblem")));
  }
  /// @param option 0: the right one
  void answer(int option) {
    QVERIFY(waitUntil([this] { return seen<QAbstractButton>("answerOption") != nullptr; }));
    int n = 0;
    for (auto* each : window_->findChildren<QAbstractButton*>(QStringLiteral("answerOption")))
      if (each->isVisible() && n++ == option) QTest::mouseClick(each, Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    press("stepDone");
  }

  void makeWindow(const QSize& size = {1280, 720}) {
    window_ = std::make_unique<MainWindow>();
    window_->resize(size);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    session().frames().setAdaptive(false);
    window_->openPlugins();
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }
  [[nodiscard]] QAbstractItemView* cards() const { return find<QAbstractItemView>("caseCards"); }
  [[nodiscard]] QModelIndex cardOf(const QString& title) const {
    for (int row = 0; row < cards()->model()->rowCount(); ++row)
      if (const QModelIndex index = cards()->model()->index(row, 0); index.data().toString() == title) return index;
    return {};
  }
  [[nodiscard]] QString spokenOf(const QString& title) const { return cardOf(title).data(Qt::AccessibleTextRole).toString(); }
  /// The list of a case's lessons, opened with a click on its card; null when there is none.
  [[nodiscard]] QWidget* openLessonsOf(const QString& title) const {
    const QModelIndex card = cardOf(title);
    const auto* list = qobject_cast<const CaseCatalogue*>(cards()->model());
    const CaseRow* row = list != nullptr ? list->row(card.row()) : nullptr;
    if (row == nullptr) return nullptr;
    cards()->scrollTo(card);
    const QRect where = lessonsRect(cards()->visualRect(card), *row, cards()->layoutDirection());
    QTest::mouseClick(cards()->viewport(), Qt::LeftButton, Qt::NoModifier, where.center());
    if (!waitUntil([this] { return lessonsShown() != nullptr; })) return nullptr;
    return lessonsShown();
  }
  [[nodiscard]] QWidget* lessonsShown() const {
    for (auto* button : window_->findChildren<QPushButton*>(QStringLiteral("startLessonOfCase")))
      if (button->isVisible()) return button->window();
    return nullptr;
  }
  /// Begins a lesson of a case from its card.
  void startFromCard(const QString& title, int lesson) {
    QWidget* lessons = openLessonsOf(title);
    QVERIFY2(lessons, "the card shows its lessons");
    const auto buttons = lessons->findChildren<QPushButton*>(QStringLiteral("startLessonOfCase"));
    QVERIFY(lesson < buttons.size());
    QTest::mouseClick(buttons.at(lesson), Qt::LeftButton);
  }
};

}  // namespace ew::ui::testing
