// An author in the real window: makes a lesson with a step of each kind, records the expert's scan in place, trims and marks it, tries the
// steps as a trainee, takes edits back, translates, saves, and finds all of it again.
#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>

#include "ew/library/attempt.h"
#include "ew/library/case.h"
#include "ew/library/case_words.h"
#include "ew/library/lesson_links.h"
#include "ew/scanning/recording.h"
#include "gui/support/answers.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class LessonEditorTest : public WindowFixture {
  Q_OBJECT

  QString folder_;

  /// The usual test case with a plane, a labelled structure and a measurement to ask for. @return whether its editor is in front
  [[nodiscard]] bool openAuthor(const QString& name) {
    folder_ = files_.writeCase(name);
    Volume labels;
    labels.grid.dims = {24, 20, 22};
    labels.grid.spacing_mm = glm::dvec3(8.0);
    labels.grid.origin_mm = {-92.0, -107.0, -97.0};
    labels.echo.assign(labels.grid.voxelCount(), 0);
    for (int n = 0; n < 400; ++n) labels.echo[labels.grid.indexOf(n % 20, n / 20 % 20, 11)] = 3;
    auto opened = loadCaseAside(folder_.toStdString());
    if (!opened || !writeVolume(labels, folder_.toStdString() + "/labels.mha")) return false;
    opened->volume.labels = "labels.mha";
    opened->titleForTrainees = "An upper abdomen";
    opened->targets = {{.kind = CaseTarget::Kind::plane,
                        .name = "liver lengthwise",
                        .probeToFile = Transform<frame::File, frame::Probe>{},
                        .positionTolerance_mm = 6.0,
                        .angleTolerance_deg = 10.0},
                       {.kind = CaseTarget::Kind::structure, .name = "liver", .label = 3}};
    opened->measurements = {{.name = "aorta, across", .tolerance = 2.0, .value = 18.0, .kind = "distance", .unit = "mm"}};
    if (const auto saved = saveCase(*opened, folder_.toStdString()); !saved) {
      qWarning("%s", saved.error().sentence().c_str());
      return false;
    }
    showWindowWithCase(folder_);
    if (QTest::currentTestFailed()) return false;
    window_->openPlugins();
    window_->showWorkspace("author");
    auto* panel = find<QWidget>("panel_lesson_editor");
    if (panel == nullptr) return false;
    for (QWidget* up = panel; up != nullptr; up = up->parentWidget())
      if (auto* tabs = qobject_cast<QTabWidget*>(up)) tabs->setCurrentWidget(panel);
    return waitUntil([this] { return editor() != nullptr && editor()->isVisible(); });
  }

  [[nodiscard]] QWidget* editor() const { return find<QWidget>("lessonEditor"); }
  template <class Widget>
  [[nodiscard]] Widget* seen(const QString& name) const {
    for (Widget* each : editor()->findChildren<Widget*>(name))
      if (each->isVisible()) return each;
    return nullptr;
  }
  void press(const char* name) {
    QAbstractButton* button = nullptr;
    QVERIFY2(waitUntil([&] { return (button = seen<QAbstractButton>(QLatin1String(name))) != nullptr; }), name);
    QVERIFY2(button->isEnabled(), name);
    button->click();
    QCoreApplication::processEvents();
  }
  void type(const char* name, const QString& text) {
    if (auto* line = seen<QLineEdit>(QLatin1String(name))) {
      line->selectAll();
      QTest::keyClicks(line, text);
      return;
    }
    auto* field = seen<QPlainTextEdit>(QLatin1String(name));
    QVERIFY2(field, name);
    field->selectAll();
    QTest::keyClicks(field, text);
  }
  void choose(const char* name, const QString& text) {
    auto* choice = seen<QComboBox>(QLatin1String(name));
    QVERIFY2(choice, name);
    const int at = choice->findText(text);
    QVERIFY2(at >= 0, qPrintable(text));
    choice->setCurrentIndex(at);
    Q_EMIT choice->activated(at);
    QCoreApplication::processEvents();  // rows that were added show themselves
  }
  void set(const char* name, double value) {
    auto* field = seen<QDoubleSpinBox>(QLatin1String(name));
    QVERIFY2(field, name);
    field->setValue(value);
  }
  [[nodiscard]] QString text(const char* name) const {
    const auto* label = seen<QLabel>(QLatin1String(name));
    return label == nullptr ? QString() : label->text();
  }
  void addLesson(int entry) {
    auto* button = seen<QPushButton>(QStringLiteral("addLesson"));
    QVERIFY(button && button->menu());
    Q_EMIT button->menu()->aboutToShow();
    QVERIFY(button->menu()->actions().size() > entry);
    button->menu()->actions()[entry]->trigger();
  }
  void addStep(const char* kind) {
    auto* button = seen<QPushButton>(QStringLiteral("addStep"));
    QVERIFY2(button && button->menu(), kind);
    for (QAction* action : button->menu()->actions())
      if (action->objectName() == QStringLiteral("addStep_") + QLatin1String(kind)) {
        action->trigger();
        QVERIFY(waitUntil([this] { return seen<QLineEdit>(QStringLiteral("stepTitle")) != nullptr; }));
        return;
      }
    QFAIL(kind);
  }
  void back() {
    press("backToSteps");
    QVERIFY(waitUntil([this] { return seen<QListWidget>(QStringLiteral("editedSteps")) != nullptr; }));
  }
  [[nodiscard]] std::vector<Lesson> lessons() const {
    const auto read = lessonsOf(*window_->document().current());
    return read ? *read : std::vector<Lesson>{};
  }
  [[nodiscard]] LessonStep stepOf(const char* kind) const {
    const std::vector<Lesson> all = lessons();
    for (const LessonStep& step : all.front().steps)
      if (taskWord(step.task) == kind) return step;
    return {};
  }
  void undo() { window_->document().undo(); }

  /// Moves the probe along the skin while images are made.
  void scan(int images) {
    for (int n = 0; n < images; ++n) {
      session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, 1.0));
      session().makeImageNow();
      QTest::qWait(20);
    }
  }
  void record(int images) {
    press("recordExpert");
    QVERIFY(waitUntil([this] { return seen<QPushButton>(QStringLiteral("stopRecording")) != nullptr; }));
    scan(images);
    press("markWhileRecording");
    scan(images);
    keepScreenshot(*window_, "lesson-editor-05-recording");
    press("stopRecording");
    QVERIFY(waitUntil([this] { return seen<QWidget>(QStringLiteral("timeLine")) != nullptr && window_->isSettled(); }));
  }

 private Q_SLOTS:
  void cleanup() { window_.reset(); }

  void aLessonWithAStepOfEachKindIsMadeSavedAndFoundAgain() {
    QVERIFY(openAuthor(QStringLiteral("authored")));
    keepScreenshot(*window_, "lesson-editor-01-empty");
    addLesson(0);
    QVERIFY(waitUntil([this] { return seen<QLineEdit>(QStringLiteral("lessonTitle")) != nullptr; }));
    type("lessonTitle", QStringLiteral("First look at the liver"));
    type("lessonAim", QStringLiteral("You find the liver."));
    QCOMPARE(lessons().front().title, std::string("First look at the liver"));
    QCOMPARE(lessons().front().id, std::string("new-lesson"));
    keepScreenshot(*window_, "lesson-editor-02-lesson");

    addStep("read");
    QVERIFY2(!text("stepMissingParts").isEmpty(), "nothing to read yet");
    type("stepText", QStringLiteral("The liver lies below the ribs."));
    QVERIFY(waitUntil([this] { return text("stepMissingParts").isEmpty(); }));
    keepScreenshot(*window_, "lesson-editor-03-read");
    back();

    addStep("watch");
    keepScreenshot(*window_, "lesson-editor-04-watch");
    record(12);
    if (QTest::currentTestFailed()) return;
    const auto watch = std::get<WatchTask>(stepOf("watch").task);
    QVERIFY(QFile::exists(folder_ + QStringLiteral("/parts/lessons/") + QString::fromStdString(watch.recording)));
    QCOMPARE(watch.marks.size(), std::size_t(1));
    const auto recorded = readRecording(folder_.toStdString() + "/parts/lessons/" + watch.recording);
    QVERIFY(recorded);
    QVERIFY2(recorded->log.frameCount() >= 24, "every image");
    QCOMPARE(recorded->log.begin_s(), 0.0);
    QCOMPARE(recorded->caseId, std::string("window-test"));
    QCOMPARE(recorded->title, std::string("An upper abdomen"));
    type("markText_0", QStringLiteral("Here is the gall bladder."));
    auto* line = seen<QWidget>(QStringLiteral("timeLine"));
    QTest::mouseClick(line, Qt::LeftButton, Qt::NoModifier, QPoint(line->width() / 4, line->height() - 4));
    press("beginHere");
    QTest::mouseClick(line, Qt::LeftButton, Qt::NoModifier, QPoint(3 * line->width() / 4, line->height() - 4));
    QTest::keyClick(line, Qt::Key_BracketRight);
    const auto trimmed = std::get<WatchTask>(stepOf("watch").task);
    QVERIFY(trimmed.begin_s && trimmed.end_s);
    QVERIFY(*trimmed.begin_s > 0.0 && *trimmed.end_s > *trimmed.begin_s && *trimmed.end_s < recorded->log.end_s());
    QCOMPARE(trimmed.marks.front().text, std::string("Here is the gall bladder."));
    press("markMoment");
    QCOMPARE(std::get<WatchTask>(stepOf("watch").task).marks.size(), std::size_t(2));
    press("removeMark_1");
    QCOMPARE(std::get<WatchTask>(stepOf("watch").task).marks.size(), std::size_t(1));
    press("playTake");
    QVERIFY(waitUntil([this] { return seen<QPushButton>(QStringLiteral("playTake"))->text() == QStringLiteral("Pause"); }));
    QVERIFY(waitUntil([this] { return seen<QPushButton>(QStringLiteral("playTake"))->text() == QStringLiteral("Play"); }));
    keepScreenshot(*window_, "lesson-editor-06-recorded");
    back();

    addStep("plane");
    QVERIFY(!text("stepMissingParts").isEmpty());
    type("stepText", QStringLiteral("Show the liver lengthwise."));
    choose("stepTarget", QStringLiteral("liver lengthwise"));
    set("planeAngle", 20.0);
    QCOMPARE(std::get<PlaneTask>(stepOf("plane").task).angleTolerance_deg, std::optional<double>(20.0));
    QVERIFY(!std::get<PlaneTask>(stepOf("plane").task).positionTolerance_mm);
    seen<QCheckBox>(QStringLiteral("aid_compass"))->click();
    QVERIFY(stepOf("plane").aids.compass);
    type("stepHints", QStringLiteral("Look below the ribs."));
    set("stepTime", 90.0);
    set("stepPass", 80.0);
    QCOMPARE(stepOf("plane").passLevel, 0.8);
    keepScreenshot(*window_, "lesson-editor-07-plane");
    back();

    addStep("sweep");
    type("stepText", QStringLiteral("Pass through the whole liver."));
    choose("stepTarget", QStringLiteral("liver"));
    set("sweepShare", 60.0);
    keepScreenshot(*window_, "lesson-editor-08-sweep");
    back();
    addStep("measure");
    type("stepText", QStringLiteral("Measure the aorta across."));
    choose("stepTarget", QStringLiteral("aorta, across"));
    keepScreenshot(*window_, "lesson-editor-09-measure");
    back();
    addStep("point");
    type("stepText", QStringLiteral("Point at the liver."));
    choose("stepTarget", QStringLiteral("liver"));
    back();
    addStep("settings");
    type("stepText", QStringLiteral("Set the machine for a deep look."));
    press("takeSettings");
    const auto settings = std::get<SettingsTask>(stepOf("settings").task);
    QCOMPARE(settings.probes, std::vector<std::string>{"convex-3.5"});
    QCOMPARE(settings.bands.size(), std::size_t(4));
    keepScreenshot(*window_, "lesson-editor-10-settings");
    back();
    addStep("answer");
    type("stepText", QStringLiteral("What lies behind the liver?"));
    choose("answerKind", QStringLiteral("a number"));
    choose("answerKind", QStringLiteral("choosing"));
    type("optionText_0", QStringLiteral("The right kidney"));
    type("optionWhy_0", QStringLiteral("It touches the lower right lobe."));
    type("optionText_1", QStringLiteral("The spleen"));
    QVERIFY2(!text("stepMissingParts").isEmpty(), "no answer is right yet");
    press("optionRight_0");
    QVERIFY(waitUntil([this] { return text("stepMissingParts").isEmpty(); }));
    keepScreenshot(*window_, "lesson-editor-11-answer");
    back();
    addStep("free");
    type("stepText", QStringLiteral("Scan on your own."));
    set("freeShortest", 30.0);
    press("freeTarget");
    keepScreenshot(*window_, "lesson-editor-12-free");
    back();
    keepScreenshot(*window_, "lesson-editor-13-steps");

    const std::vector<Lesson> made = lessons();
    QCOMPARE(made.front().steps.size(), std::size_t(9));
    QVERIFY2(problemsOf(made.front(), *window_->document().current(), {}).empty(), "the lesson is ready");
    press("backToLessons");
    keepScreenshot(*window_, "lesson-editor-14-lessons");
    QVERIFY(window_->document().save());
    window_.reset();
    showWindowWithCase(folder_);
    QVERIFY(lessons() == made);
  }

  void editsAreStepsOfUndoAndWhatIsRefusedChangesNothing() {
    QVERIFY(openAuthor(QStringLiteral("undone")));
    addLesson(1);  // with the usual steps
    const std::size_t steps = lessons().front().steps.size();
    QVERIFY(steps >= 6);
    auto* list = seen<QListWidget>(QStringLiteral("editedSteps"));
    QVERIFY(list);
    const std::string first = lessons().front().steps.front().id;
    list->setCurrentRow(0);
    QTest::keyClick(list, Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(lessons().front().steps[1].id, first);
    QCOMPARE(list->currentRow(), 1);
    press("stepUp");
    QCOMPARE(lessons().front().steps[0].id, first);
    QTest::keyClick(list, Qt::Key_Delete);
    QCOMPARE(lessons().front().steps.size(), steps - 1);
    undo();
    QCOMPARE(lessons().front().steps.size(), steps);

    type("lessonTitle", QStringLiteral("Kidneys"));  // typed letter by letter: one step of undo
    QCOMPARE(lessons().front().title, std::string("Kidneys"));
    undo();
    QCOMPARE(lessons().front().title, std::string("New lesson"));
    QCOMPARE(seen<QLineEdit>(QStringLiteral("lessonTitle"))->text(), QStringLiteral("New lesson"));

    auto* title = seen<QLineEdit>(QStringLiteral("lessonTitle"));
    title->selectAll();
    QTest::keyClick(title, Qt::Key_Backspace);
    QCOMPARE(lessons().front().title, std::string("New lesson"));
    QVERIFY2(!text("lessonTitle_problem").isEmpty(), "a lesson needs a title");
    undo();
    undo();
    while (!lessons().empty() && window_->document().history().canUndo()) undo();
    QVERIFY(waitUntil([this] { return seen<QPushButton>(QStringLiteral("addLesson")) != nullptr; }));
    QVERIFY2(lessons().empty(), "everything was taken back");
  }

  void aTargetThatIsGoneIsShownAsSuch() {
    QVERIFY(openAuthor(QStringLiteral("gone")));
    addLesson(0);
    addStep("plane");
    type("stepText", QStringLiteral("Show the liver lengthwise."));
    choose("stepTarget", QStringLiteral("liver lengthwise"));
    QVERIFY(text("stepMissingParts").isEmpty());
    Case changed = *window_->document().current();
    changed.targets.clear();
    QVERIFY(window_->document().edit(changed, "Remove the targets", ""));
    QVERIFY(text("stepMissingParts").contains(QStringLiteral("liver lengthwise")));
    QVERIFY(seen<QComboBox>(QStringLiteral("stepTarget"))->currentText().contains(QStringLiteral("not there any more")));
    keepScreenshot(*window_, "lesson-editor-15-target-gone");
  }

  void recordingAgainKeepsTheEarlierScanUntilItIsNotNeeded() {
    QVERIFY(openAuthor(QStringLiteral("again")));
    addLesson(0);
    addStep("watch");
    record(4);
    if (QTest::currentTestFailed()) return;
    const std::string before = std::get<WatchTask>(stepOf("watch").task).recording;
    QTest::qWait(30);
    record(5);
    const std::string after = std::get<WatchTask>(stepOf("watch").task).recording;
    QVERIFY(before != after);
    const QString part = folder_ + QStringLiteral("/parts/lessons/");
    QVERIFY(QFile::exists(part + QString::fromStdString(before)));
    undo();
    QCOMPARE(std::get<WatchTask>(stepOf("watch").task).recording, before);
    window_->document().redo();
    QVERIFY(window_->document().save());
    QCOMPARE(unusedLessonFiles(*window_->document().current()), std::vector<std::string>{before});
    press("backToSteps");
    press("backToLessons");
    QVERIFY(text("unusedLessonFiles").contains(QString::fromStdString(before)));
    keepScreenshot(*window_, "lesson-editor-16-unused");
  }

  void aRecordingThatCannotBeWrittenStaysUntilItCan() {
    QVERIFY(openAuthor(QStringLiteral("unwritable")));
    addLesson(0);
    addStep("watch");
    QVERIFY(window_->document().save());
    const QString scans = folder_ + QStringLiteral("/parts/lessons/scans");
    QDir().mkpath(folder_ + QStringLiteral("/parts/lessons"));
    QVERIFY(writeFileSafely(scans.toStdString(), "in the way").has_value());
    press("recordExpert");
    scan(3);
    press("stopRecording");
    QVERIFY(waitUntil([this] { return text("recording_problem").contains(QStringLiteral("still there")); }));
    QVERIFY(std::get<WatchTask>(stepOf("watch").task).recording.empty());
    QVERIFY2(text("takeLength").startsWith(QStringLiteral("Paused")), "nothing is lost");
    QVERIFY(QFile::remove(scans));
    press("stopRecording");
    QVERIFY(waitUntil([this] { return !std::get<WatchTask>(stepOf("watch").task).recording.empty(); }));
    QVERIFY2(seen<QPushButton>(QStringLiteral("stopRecording")) == nullptr, "it is kept, and gone from here");
  }

  void anotherCaseInTheMiddleOfARecordingPausesIt() {
    QVERIFY(openAuthor(QStringLiteral("paused")));
    addLesson(0);
    addStep("watch");
    QVERIFY(window_->document().save());
    press("recordExpert");
    scan(3);
    QVERIFY(openCase(files_.writeCase(QStringLiteral("other"))));
    QVERIFY(openCase(folder_));
    QVERIFY(waitUntil([this] { return text("takeLength").startsWith(QStringLiteral("Paused")); }));
    keepScreenshot(*window_, "lesson-editor-17-paused");
    press("pauseRecording");
    scan(3);
    press("stopRecording");
    QVERIFY(waitUntil([this] { return !std::get<WatchTask>(stepOf("watch").task).recording.empty(); }));
  }

  void aCaseThatIsSavedElsewhereTakesItsRecordingAlong() {
    QVERIFY(openAuthor(QStringLiteral("before the copy")));
    addLesson(0);
    addStep("watch");
    QVERIFY(window_->document().save());
    press("recordExpert");
    scan(3);
    const std::filesystem::path copy = files_.path(QStringLiteral("the copy")).toStdString();
    QVERIFY(window_->document().save(copy, {}, "the-copy"));
    QVERIFY2(waitUntil([this] { return text("takeLength").contains(QStringLiteral("Recording")); }), "it goes on, in the copy");
    scan(3);
    press("stopRecording");
    QVERIFY(waitUntil([this] { return !std::get<WatchTask>(stepOf("watch").task).recording.empty(); }));
    QVERIFY(std::filesystem::exists(copy / "parts/lessons" / std::get<WatchTask>(stepOf("watch").task).recording));
  }

  void aRecordingOfAnotherStepIsEndedWhereItIsInTheWay() {
    QVERIFY(openAuthor(QStringLiteral("two steps")));
    addLesson(0);
    addStep("watch");
    press("recordExpert");
    scan(3);
    back();
    addStep("watch");
    QVERIFY(text("recordingState").startsWith(QStringLiteral("Another step")));
    QVERIFY(seen<QPushButton>(QStringLiteral("discardRecording")) && !seen<QPushButton>(QStringLiteral("pauseRecording")));
    press("stopRecording");
    QVERIFY(waitUntil([this] { return !std::get<WatchTask>(lessons().front().steps.at(0).task).recording.empty(); }));
    QVERIFY(std::get<WatchTask>(lessons().front().steps.at(1).task).recording.empty());
    QVERIFY(seen<QPushButton>(QStringLiteral("stopRecording")) == nullptr);
    QVERIFY(seen<QPushButton>(QStringLiteral("recordExpert"))->isEnabled());
  }

  void aRecordingOfAnotherCaseIsSavedInAFileOrDiscarded() {
    QVERIFY(openAuthor(QStringLiteral("its own")));
    addLesson(0);
    addStep("watch");
    QVERIFY(window_->document().save());
    press("recordExpert");
    scan(3);
    QVERIFY(openCase(files_.writeCase(QStringLiteral("not its own"))));
    addLesson(0);
    addStep("watch");
    QVERIFY(window_->document().save());
    QVERIFY(text("recordingState").startsWith(QStringLiteral("A scan of another case")));
    const QString file = files_.path(QStringLiteral("taken.seq.mha"));
    {
      const Answers answers({{QStringLiteral("fileDialog"), testing::type(file)}});
      press("stopRecording");
      QVERIFY(waitUntil([this] { return seen<QPushButton>(QStringLiteral("recordExpert"))->isEnabled(); }));
      QCOMPARE(answers.asked, QStringList{QStringLiteral("fileDialog")});
    }
    QVERIFY(readRecording(file.toStdString()).has_value());
    QVERIFY(std::get<WatchTask>(stepOf("watch").task).recording.empty());

    press("recordExpert");
    scan(3);
    QVERIFY(openCase(files_.writeCase(QStringLiteral("a third"))));
    addLesson(0);
    addStep("watch");
    press("discardRecording");
    QVERIFY(seen<QPushButton>(QStringLiteral("stopRecording")) == nullptr);
    QVERIFY(seen<QPushButton>(QStringLiteral("recordExpert"))->isEnabled());
  }

  void aStepIsTriedAsATraineeSeesItAndNothingIsKept() {
    QVERIFY(openAuthor(QStringLiteral("tried")));
    addLesson(0);
    addStep("answer");
    type("stepText", QStringLiteral("What is it?"));
    press("optionRight_1");
    press("tryStep");
    if (QTest::currentTestFailed()) return;
    QVERIFY(waitUntil([this] { return seen<QPushButton>(QStringLiteral("stepDone")) != nullptr; }));
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    keepScreenshot(*window_, "lesson-editor-18-tried");
    const auto options = editor()->findChildren<QAbstractButton*>(QStringLiteral("answerOption"));
    options.back()->click();
    QVERIFY(waitUntil([this] { return seen<QPushButton>(QStringLiteral("stepDone"))->isEnabled(); }));
    press("stepDone");
    QVERIFY(text("outcomeHeading").startsWith(QStringLiteral("Passed")));
    press("endTry");
    QVERIFY2(seen<QLineEdit>(QStringLiteral("optionText_0")), "back at the step");
    QVERIFY2(listAttempts(libraryFolder() / "attempts").attempts.empty(), "nothing was kept");
  }

  void anImageIsKeptWithoutWhatIsWrittenInItsFile() {
    QVERIFY(openAuthor(QStringLiteral("pictured")));
    QImage photo(300, 200, QImage::Format_RGB32);
    photo.fill(Qt::darkCyan);
    photo.setText(QStringLiteral("Patient"), QStringLiteral("Somebody Real"));
    const QString file = files_.path(QStringLiteral("photo.png"));
    QVERIFY(photo.save(file));
    addLesson(0);
    addStep("read");
    auto* form = seen<QWidget>(QStringLiteral("taskForm"));
    QVERIFY(form);
    QVERIFY(QMetaObject::invokeMethod(form, "takeImage", Q_ARG(QString, file)));
    const std::string name = std::get<ReadingTask>(stepOf("read").task).image;
    QVERIFY(QString::fromStdString(name).startsWith(QStringLiteral("media/")));
    QFile kept(folder_ + QStringLiteral("/parts/lessons/") + QString::fromStdString(name));
    QVERIFY(kept.open(QIODevice::ReadOnly));
    const QByteArray bytes = kept.readAll();
    QVERIFY(!bytes.contains("Somebody"));
    const QImage read = QImage::fromData(bytes);
    QCOMPARE(read.size(), QSize(300, 200));
    QCOMPARE(read.pixelColor(10, 10), QColor(Qt::darkCyan));
    keepScreenshot(*window_, "lesson-editor-19-picture");
  }

  void textsWithoutTranslationAreListedAndTranslated() {
    QVERIFY(openAuthor(QStringLiteral("translated")));
    addLesson(0);
    type("lessonTitle", QStringLiteral("The liver"));
    press("backToLessons");
    press("lessonWords");
    auto* list = seen<QListWidget>(QStringLiteral("wordsTexts"));
    QVERIFY(list);
    const auto rows = list->findItems(QStringLiteral("The liver"), Qt::MatchExactly);
    QCOMPARE(rows.size(), 1);
    list->setCurrentItem(rows.front());
    type("wordsTranslation", QStringLiteral("Die Leber"));
    keepScreenshot(*window_, "lesson-editor-20-words");
    press("keepWords");
    QVERIFY(list->findItems(QStringLiteral("The liver"), Qt::MatchExactly).empty());
    QCOMPARE(wordsOf(folder_.toStdString(), "de_AT").of("The liver"), std::string("Die Leber"));
  }
};

}  // namespace ew::ui::testing

using ew::ui::testing::LessonEditorTest;
EW_WINDOW_TEST_MAIN(LessonEditorTest)
#include "lesson_editor_test.moc"
