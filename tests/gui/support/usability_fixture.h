#pragma once

#include <QDropEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTranslator>
#include <filesystem>
#include <fstream>

#include "ew/library/case.h"
#include "ew/library/lesson.h"
#include "ew/ui_test_door/console.h"
#include "ew/ui_test_door/window.h"
#include "ew/ui_test_door/worksheets.h"
#include "ew/widgets/apply_theme.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/usability_walk.h"
#include "gui/support/window_fixture.h"

/// Outside of any namespace, as the macro demands.
inline void initUsabilityTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

/// A window in a language and a size of text, which is led through its pages and dialogs.
class UsabilityFixture : public WindowFixture {
 protected:
  QString case_;
  std::unique_ptr<QTranslator> words_;

  /// The usual test case with a lesson, so that trainees have a panel.
  [[nodiscard]] QString writeTaught() const {
    const QString folder = files_.writeCase(QStringLiteral("taught"));
    auto opened = loadCaseAside(folder.toStdString());
    if (!opened) return {};
    Lesson lesson;
    lesson.id = "first";
    lesson.title = "The ball";
    lesson.aim = "A ball is found and measured.";
    for (const char* id : {"read", "free"}) {
      LessonStep step;
      step.id = id;
      step.title = std::string("Title of ") + id;
      step.text = "What to do in this step.";
      if (std::string_view(id) == "read")
        step.task = ReadingTask{};
      else
        step.task = FreeTask{0.0, {}};
      lesson.steps.push_back(step);
    }
    opened->otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson});
    return saveCase(*opened, folder.toStdString()) ? folder : QString();
  }

  void speak(const QString& language) {
    QLocale::setDefault(language == QLatin1String("de") ? QLocale(QStringLiteral("de_DE")) : QLocale::c());
    if (language == kPseudoLanguage) {
      words_ = std::make_unique<PseudoTranslator>();
      QApplication::setLayoutDirection(Qt::RightToLeft);
    } else if (language == QLatin1String("de")) {
      words_ = std::make_unique<QTranslator>();
      QVERIFY(words_->load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    }
    if (words_) QVERIFY(QApplication::installTranslator(words_.get()));
  }
  void beSilent() {
    window_.reset();
    if (words_) QApplication::removeTranslator(words_.get());
    words_.reset();
    QLocale::setDefault(QLocale::c());
    QApplication::setLayoutDirection(Qt::LeftToRight);
    QSettings().clear();
    setTextSize(100);
  }

  /// One row for each language and size of text, named by them after what stands before.
  static void addLanguagesAndSizes(
      const QString& before = {}, const std::function<void(QTestData&)>& more = [](QTestData&) {}) {
    for (const char* language : {"en", "de"})
      for (const int percent : {100, 150, 200}) {
        QTestData& row = QTest::newRow(qPrintable(QStringLiteral("%1%2 %3 %").arg(before, QLatin1String(language)).arg(percent)))
                         << QString::fromLatin1(language) << percent;
        more(row);
      }
  }

  void showWindow(const QString& language, int text_percent = 100, const QSize& size = {1440, 900}) {
    speak(language);
    QSettings().setValue(QStringLiteral("textSize"), text_percent);
    if (case_.isEmpty()) case_ = writeTaught();
    QVERIFY(!case_.isEmpty());
    showWindowWithCase(case_);
    window_->openPlugins();
    for (const char* panel : {"panel_case_authoring", "panel_stitching", "panel_lessons"}) QVERIFY2(find<QWidget>(panel) != nullptr, panel);
    window_->resize(size);
    window_->setWorkspace(Workspace::explore);
    Case changed = *window_->document().current();
    changed.history = "Pain.";
    QVERIFY(window_->document().edit(changed, "Edit the history of the patient and all that belongs to it", "history").has_value());
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    QTest::qWait(50);
  }

  /// A shipped case with everything but fine voxels, so that it opens at once.
  [[nodiscard]] QString coarseCopyOf(const std::filesystem::path& shipped) const {
    const std::filesystem::path folder =
        files_.path(QStringLiteral("shipped-") + QString::fromStdString(shipped.filename().string())).toStdString();
    std::filesystem::copy(shipped, folder, std::filesystem::copy_options::recursive | std::filesystem::copy_options::skip_existing);
    std::ifstream from(shipped / "case.json");
    nlohmann::json manifest = nlohmann::json::parse(from);
    if (manifest["volume"].contains("recipe")) {
      for (const char* fine : {"sweeps", "reconstruct"}) manifest["volume"].erase(fine);
      manifest["volume"]["recipe_spacing_mm"] = 9.0;
    }
    std::ofstream(folder / "case.json") << manifest.dump(2);
    return QString::fromStdString(folder.string());
  }

  /// Presses the tab of a column that is not in front. @param source its title in English
  void bringToFront(const char* source) {
    QStringList titles{Columns::tr(source)};
    for (QTabWidget* tabs : window_->findChildren<QTabWidget*>())  // of the panel that is alone in its column
      if (tabs->objectName() == QLatin1String("explorePanel") && QLatin1String(source) == QLatin1String("Lessons") && tabs->count() > 0)
        titles << tabs->tabText(0);
    for (ColumnTabs* tabs : window_->findChildren<ColumnTabs*>()) {
      for (int n = 0; tabs->isVisible() && n < tabs->count(); ++n) {
        if (!titles.contains(tabs->tabText(n)) || tabs->currentIndex() == n) continue;
        QTest::mouseClick(tabs, Qt::LeftButton, Qt::NoModifier, tabs->tabRect(n).center());
        QTest::qWait(20);
        return;
      }
    }
  }

  [[nodiscard]] QPushButton* visibleButton(const char* name) const {
    for (QPushButton* each : window_->findChildren<QPushButton*>(QLatin1String(name)))
      if (each->isVisible()) return each;
    return nullptr;
  }
  /// Once what has just changed, as a clock does, has its room.
  [[nodiscard]] QStringList textsStillCut() {
    static_cast<void>(waitUntil([this] { return cutTexts(*window_).isEmpty(); }, 1000.0));
    return cutTexts(*window_);
  }

  /// Whether it can be pressed: whole in the window, once its page is scrolled to it.
  [[nodiscard]] bool isReachedByMouse(const QWidget* widget) const {
    if (widget == nullptr) return false;
    for (QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget())
      if (auto* scroll = qobject_cast<QScrollArea*>(up)) scroll->ensureWidgetVisible(const_cast<QWidget*>(widget), 0, 0);
    QCoreApplication::processEvents();
    const QRect place(widget->mapTo(window_.get(), QPoint()), widget->size());
    return widget->isVisible() && window_->rect().contains(place) && widget->visibleRegion().boundingRect() == widget->rect();
  }

  /// Gain, depth, freeze, presets, probe and the calipers; and what of their words is cut.
  [[nodiscard]] QStringList whatIsNotReachedOnTheConsole() {
    QStringList missing;
    bringToFront("Console");
    if (!window_->console().isVisible()) return {QStringLiteral("there is no console")};
    const auto look = [&](const char* name) {
      if (!isReachedByMouse(find<QWidget>(name))) missing << QStringLiteral("%1 is not reached").arg(QLatin1String(name));
    };
    for (const char* always : {"gain", "depth", "freeze"}) look(always);
    auto* pages = find<QTabWidget>("consolePages");
    const QTabBar& bar = *pages->tabBar();
    for (int n = 0; n < pages->count(); ++n) {
      if (!bar.rect().contains(bar.tabRect(n))) missing << QStringLiteral("the tab '%1' is not seen").arg(pages->tabText(n));
      pages->setCurrentIndex(n);
      QTest::qWait(10);
      if (n == 0)
        for (const char* first : {"presets", "focus", "modeB", "flip"}) look(first);
      if (n == 3) look("probe");
      if (n == 4) look("caliper-distance");
      for (const QString& each : textsStillCut()) missing << QStringLiteral("page %1: ").arg(n + 1) + each;
    }
    pages->setCurrentIndex(0);
    return missing;
  }

  /// What of console, lesson and body is not reached, or cut, at each size a laptop's window has.
  [[nodiscard]] QStringList whatIsNotReachedAtAnySize(const QString& name, bool inLesson) {
    QStringList wrong;
    for (const QSize& size : {QSize(1440, 900), QSize(1366, 768), QSize(1280, 720), QSize(1024, 640)}) {
      window_->resize(size);
      QTest::qWait(20);
      const QString where =
          QStringLiteral("%1 x %2%3").arg(size.width()).arg(size.height()).arg(inLesson ? QStringLiteral(", in a lesson") : QString());
      const auto keep = [&](const char* what) {
        keepScreenshot(*window_,
                       qPrintable(QStringLiteral("%1-%2-%3%4").arg(name).arg(size.width()).arg(QLatin1String(what)).arg(inLesson ? 1 : 0)));
      };
      if (window_->size() != size) wrong << QStringLiteral("%1 became %2 x %3").arg(where).arg(window_->width()).arg(window_->height());
      bringToFront("Lessons");
      if (!isReachedByMouse(visibleButton(inLesson ? "leaveLesson" : "startLesson")))
        wrong << where + QStringLiteral(": the lesson is not reached");
      for (const QString& each : textsStillCut()) wrong << where + QStringLiteral(", lesson: ") + each;
      keep("lesson");
      for (const QString& each : whatIsNotReachedOnTheConsole()) wrong << where + QStringLiteral(": ") + each;
      bringToFront("Body");
      if (!window_->view3d().isVisible()) wrong << where + QStringLiteral(": the body is not reached");
      for (const QString& each : textsStillCut()) wrong << where + QStringLiteral(", body: ") + each;
      keep("body");
    }
    return wrong;
  }

  /// Before a lesson and in it.
  [[nodiscard]] QStringList whatIsNotReachedBeforeAndInALesson(const QString& name) {
    bringToFront("Lessons");  // a panel is made when it is first seen
    if (!waitUntil([this] { return visibleButton("startLesson") != nullptr; })) return {QStringLiteral("no lesson can be started")};
    QStringList wrong = whatIsNotReachedAtAnySize(name, false);
    bringToFront("Lessons");
    visibleButton("startLesson")->click();
    if (!waitUntil([this] { return visibleButton("leaveLesson") != nullptr && window_->isSettled(); }))
      return wrong << QStringLiteral("the lesson did not start");
    wrong << whatIsNotReachedAtAnySize(name, true);
    wrong.removeDuplicates();
    return wrong;
  }

  [[nodiscard]] QAction* action(const char* source) const {
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text() == MainWindow::tr(source)) return each;
    return nullptr;
  }
  void showTab(const QString& panel) {
    auto* page = window_->findChild<QWidget*>(panel);
    QVERIFY2(page, qPrintable(panel));
    for (QWidget* up = page; up != nullptr; up = up->parentWidget())
      if (auto* tabs = qobject_cast<QTabWidget*>(up)) tabs->setCurrentWidget(page);
    QTest::qWait(50);
  }

  /// Two volumes, so that list, graph, views and inspector have something to show.
  void addToStitch() {
    auto* panel = window_->findChild<QWidget*>(QStringLiteral("stitchPanel"));
    QVERIFY(panel);
    QMimeData data;
    QList<QUrl> urls;
    for (const char* name : {"/one with a long name.mha", "/two.mha"}) {
      QFile::copy(case_ + QStringLiteral("/volume.mha"), case_ + QLatin1String(name));
      urls << QUrl::fromLocalFile(case_ + QLatin1String(name));
    }
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(panel, &enter);
    QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(panel, &event);
    QTest::qWait(300);
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
    QTest::qWait(200);
  }

  /// Calls `look` with each page of the window in front.
  void walkPages(const std::function<void(const QString&)>& look) {
    auto* consolePages = find<QTabWidget>("consolePages");
    for (int n = 0; n < consolePages->count(); ++n) {
      consolePages->setCurrentIndex(n);
      QTest::qWait(20);
      look(QStringLiteral("explore, page %1 of the console").arg(n + 1));
    }
    consolePages->setCurrentIndex(0);
    if (auto* start = find<QPushButton>("startLesson"); start != nullptr && start->isVisible()) {
      start->click();
      QVERIFY(waitUntil([this] { return window_->isSettled(); }));
      QTest::qWait(100);
      look(QStringLiteral("explore, in a lesson"));
      if (auto* leaves = find<QPushButton>("leaveLesson"); leaves != nullptr && leaves->isVisible()) leaves->click();
    }
    session().setFrozen(true);
    QTest::qWait(50);
    look(QStringLiteral("explore, frozen"));
    session().setFrozen(false);
    window_->setWorkspace(Workspace::author);
    for (QTabWidget* tabs : window_->findChildren<QTabWidget*>()) {
      if (!tabs->property("panels").toBool() || !tabs->isVisible()) continue;
      for (int n = 0; n < tabs->count(); ++n) {
        if (!tabs->isTabVisible(n)) continue;
        tabs->setCurrentIndex(n);
        QTest::qWait(400);  // panels look at the case when events have been handled
        look(QStringLiteral("author, %1").arg(tabs->widget(n)->objectName()));
        if (tabs->widget(n)->objectName() != QLatin1String("panel_stitching")) continue;
        addToStitch();
        look(QStringLiteral("author, two volumes to be stitched"));
      }
      tabs->setCurrentIndex(0);
      break;
    }
    window_->setWorkspace(Workspace::explore);
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    QTest::qWait(400);
    look(QStringLiteral("start page"));
    find<QLineEdit>("caseSearch")->setText(QStringLiteral("nothing is called so"));
    QTest::qWait(50);
    look(QStringLiteral("start page, nothing found"));
    find<QLineEdit>("caseSearch")->clear();
    window_->setWorkspace(Workspace::explore);
  }

  /// Calls `look` with each dialog that the menus open without asking for a file.
  void walkDialogs(const std::function<void(const QString&, QWidget&)>& look) {
    window_->setWorkspace(Workspace::explore);
    QVERIFY(!window_->worksheets().packages().empty());
    window_->worksheets().choose(window_->worksheets().packages().front()->id);
    const std::pair<const char*, const char*> menus[] = {{"Keys and &controls…", "keysDialog"},
                                                         {"&Performance…", "costPanel"},
                                                         {"&Tracker…", "trackerPage"},
                                                         {"&Worksheet…", "worksheetDialog"},
                                                         {"&Examination and archive…", "examinationDialog"}};
    for (const auto& [text, name] : menus) {
      QAction* entry = action(text);
      QVERIFY2(entry, text);
      entry->trigger();
      QTest::qWait(50);
      QDialog* shown = nullptr;
      for (QDialog* each : window_->findChildren<QDialog*>())
        if (each->isVisible()) shown = each;
      QVERIFY2(shown, text);
      QTest::qWait(80);
      look(QString::fromLatin1(name), *shown);
      shown->close();
      QTest::qWait(20);
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
    }
    window_->open(files_.writeSweep(QStringLiteral("sweep.igs.mha")));
    QDialog* import = nullptr;
    QVERIFY(waitUntil([&] {
      import = find<QDialog>("importDialog");
      return import != nullptr && import->isVisible() && !window_->jobs().isRunning();
    }));
    QTest::qWait(50);
    look(QStringLiteral("importDialog"), *import);
    import->reject();
    QTest::qWait(20);
  }
};

}  // namespace ew::ui::testing
