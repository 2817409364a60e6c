// A trainee in the real window: chooses a lesson of the open case, works through a step of each kind, fails one and tries it again, leaves
// in the middle and goes on.
#include <QAbstractButton>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <cmath>
#include <filesystem>

#include "ew/library/attempt.h"
#include "ew/library/case.h"
#include "ew/library/lesson.h"
#include "ew/scanning/recording.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/scan.h"
#include "gui/support/answers.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::ui::testing {

class LessonsTest : public WindowFixture {
  Q_OBJECT

  static LessonStep step(const char* id, LessonTask task) {
    LessonStep made;
    made.id = id;
    made.title = std::string("Title of ") + id;
    made.text = "What to do in this step.";
    made.task = std::move(task);
    return made;
  }

  /// Whether a file of a step's work is kept where a crash does not take it.
  [[nodiscard]] bool isKept(const char* item) const {
    std::error_code ignored;
    for (std::filesystem::directory_iterator at(keptFolder(), ignored); !ignored && at != std::filesystem::directory_iterator();
         at.increment(ignored))
      if (std::filesystem::exists(at->path() / item, ignored)) return true;
    return false;
  }
  [[nodiscard]] std::filesystem::path keptFolder() const {
    return files_.path(QStringLiteral("data/echoweave/unsaved-work")).toStdString();
  }
  /// Waits until the scan of the step that runs is kept.
  [[nodiscard]] bool isScanKept() {
    return waitUntil([this] {
      session().frames().ask();
      session().makeImageNow();
      return isKept("step.jsonl");
    });
  }
  /// As a kill leaves it: the files of now, and nobody who holds them.
  void kill() {
    namespace fs = std::filesystem;
    const fs::path kept = keptFolder(), attempts = files_.path(QStringLiteral("library/attempts")).toStdString(),
                   aside = files_.path(QStringLiteral("as it was")).toStdString();
    fs::remove_all(aside);
    fs::create_directories(aside);
    fs::copy(kept, aside / "kept", fs::copy_options::recursive);
    fs::copy(attempts, aside / "attempts", fs::copy_options::recursive);
    window_.reset();
    QVERIFY2(!fs::exists(kept) || fs::is_empty(kept), "a window that ends in order leaves nothing");
    fs::remove_all(kept);
    fs::remove_all(attempts);
    fs::rename(aside / "kept", kept);
    fs::rename(aside / "attempts", attempts);
  }
  /// The next start, in which somebody goes on with what the kill has left.
  void startAndGoOn(const char* step) {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    window_->openPlugins();
    Answers answers({{QStringLiteral("unsavedWorkQuestion"), testing::press("goOnUnsaved")}});
    window_->openWhereOneWas();
    window_->offerUnsavedWork();
    QVERIFY(waitUntil([&] { return !answers.asked.isEmpty() && player() != nullptr; }));
    QVERIFY(waitUntil([this] { return window_->messages().text().contains(QLatin1String("goes on where it stood")); }));
    waitForStep(step);
    QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedWorkQuestion")});
  }

  /// The usual test case with a labelled ball below where the probe stands at the start, a plane there, and a lesson with a step of each
  /// kind.
  [[nodiscard]] QString writeTaught() {
    const QString folder = files_.writeCase(QStringLiteral("taught"));
    showWindowWithCase(folder);
    const ScanState start = session().shownState();
    const auto& probeToWorld = start.pose.probeToWorld;
    const glm::dvec3 middle_mm = (probeToWorld * Point<frame::Probe>{{0.0, 50.0, 0.0}}).at;
    window_.reset();

    Volume labels;
    labels.grid.dims = {96, 80, 88};
    labels.grid.spacing_mm = glm::dvec3(2.0);
    labels.grid.origin_mm = {-95.0, -110.0, -100.0};
    labels.echo.assign(labels.grid.voxelCount(), 0);
    for (int k = 0; k < 88; ++k)
      for (int j = 0; j < 80; ++j)
        for (int i = 0; i < 96; ++i)
          if (glm::distance(labels.grid.origin_mm + 2.0 * glm::dvec3(i, j, k), middle_mm) < 16.0)
            labels.echo[labels.grid.indexOf(i, j, k)] = 3;
    if (!writeVolume(labels, folder.toStdString() + "/labels.mha")) return {};

    auto opened = loadCaseAside(folder.toStdString());
    if (!opened) return {};
    opened->volume.labels = "labels.mha";
    opened->targets = {{.kind = CaseTarget::Kind::plane,
                        .name = "start plane",
                        .probeToFile = Transform<frame::File, frame::Probe>{probeToWorld.matrix},
                        .positionTolerance_mm = 6.0,
                        .angleTolerance_deg = 10.0},
                       {.kind = CaseTarget::Kind::structure, .name = "ball", .label = 3}};
    opened->measurements = {{.name = "ball, across", .tolerance = 4.0, .value = 32.0, .kind = "distance", .unit = "mm"}};
    Lesson lesson;
    lesson.id = "first";
    lesson.title = "The ball";
    lesson.aim = "You find a ball and measure it.";
    lesson.steps = {step("read", ReadingTask{}),
                    step("watch", WatchTask{"scans/expert.seq.mha", {}, {}, {{0.4, "Here is the ball."}}}),
                    step("plane", PlaneTask{"start plane", {}, {}}),
                    step("sweep", SweepTask{"ball", 0.5}),
                    step("measure", MeasureTask{"ball, across", {}}),
                    step("point", PointTask{"ball"}),
                    step("settings", SettingsTask{{"convex-3.5"}, {{"depth_mm", 100.0, 130.0}}}),
                    step("answer", AnswerTask{{{"A ball", true, "It is round."}, {"A cube", false, "It has no corners."}}, {}, 0.0, ""}),
                    step("free", FreeTask{0.0, {"start plane"}})};
    for (LessonStep& each : lesson.steps) each.hints = {"Look below the probe.", "Freeze first."};
    lesson.steps[2].aids = {true, true, true, true, true, true, true};
    lesson.steps[5].aids.outline = true;
    opened->otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson});
    if (!saveCase(*opened, folder.toStdString())) return {};

    ScanRecording expert;
    expert.caseId = opened->id;
    for (int n = 0; n <= 10; ++n) {
      ScanState image = start;
      image.time_s = 0.1 * n;
      image.number = static_cast<std::uint64_t>(n + 1);
      image.pose.probeToWorld.matrix[3].z += n;
      expert.log.addFrame(image);
    }
    QDir().mkpath(folder + QStringLiteral("/parts/lessons/scans"));
    if (!writeRecording(expert, folder.toStdString() + "/parts/lessons/scans/expert.seq.mha")) return {};
    return folder;
  }

  [[nodiscard]] QWidget* player() const { return find<QWidget>("lessonPlayer"); }
  void openLessons() {
    auto* panel = find<QWidget>("panel_lessons");
    QVERIFY2(panel, "the plugin is there");
    for (QWidget* up = panel; up != nullptr; up = up->parentWidget())
      if (auto* tabs = qobject_cast<QTabWidget*>(up)) tabs->setCurrentWidget(panel);
    QVERIFY(waitUntil([this] { return player() != nullptr && player()->isVisible(); }));
  }
  [[nodiscard]] QString text(const char* name) const {
    for (const QLabel* label : player()->findChildren<QLabel*>(QLatin1String(name)))
      if (label->isVisible()) return label->text();
    return {};
  }
  template <class Widget = QPushButton>
  [[nodiscard]] Widget* seen(const char* name) const {
    for (Widget* each : player()->findChildren<Widget*>(QLatin1String(name)))
      if (each->isVisible()) return each;
    return nullptr;
  }
  void press(const char* name) {
    QVERIFY2(waitUntil([&] { return seen(name) != nullptr && seen(name)->isEnabled(); }), name);
    QTest::mouseClick(seen(name), Qt::LeftButton);
  }
  void waitForStep(const char* id) {
    QVERIFY2(waitUntil([&] { return text("stepTitle") == QStringLiteral("Title of ") + QLatin1String(id); }), id);
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }
  void begin() {
    showWindowWithCase(writeTaught());
    window_->openPlugins();
    openLessons();
    keepScreenshot(*window_, "lessons-01-list");
    press("startLesson");
    waitForStep("read");
  }
  /// The same case with a lesson of these steps.
  void beginWith(std::vector<LessonStep> steps) {
    const QString folder = writeTaught();
    auto opened = loadCaseAside(folder.toStdString());
    QVERIFY(opened.has_value());
    Lesson lesson;
    lesson.id = "first";
    lesson.title = "The ball";
    lesson.steps = std::move(steps);
    opened->otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson});
    QVERIFY(saveCase(*opened, folder.toStdString()).has_value());
    showWindowWithCase(folder);
    window_->openPlugins();
    openLessons();
    press("startLesson");
    waitForStep(lesson.steps.front().id.c_str());
  }
  void skipTo(const char* id) {
    for (const char* each : {"read", "watch", "plane", "sweep", "measure", "point", "settings", "answer", "free"}) {
      waitForStep(each);
      if (std::string_view(each) == id) return;
      press("skipStep");
    }
  }
  /// Whether the border of the ball is drawn in the expert's blue, all around: its voxels leave it within 3 mm of 16. What is scanned is
  /// grey.
  [[nodiscard]] bool isBallOutlined() const {
    const QImage shown = window_->scanView().grab().toImage();
    const auto isBlueAt = [&](const glm::dvec2& at_mm) {
      const QPoint pixel = (window_->scanView().positionOf({{at_mm, 0.0}}) * shown.devicePixelRatio()).toPoint();
      if (!shown.rect().contains(pixel)) return false;
      const QColor found = shown.pixelColor(pixel);
      return found.blue() - found.red() > 50;
    };
    int drawn = 0;
    for (int n = 0; n < 24; ++n) {
      const double angle_rad = n * 6.283185307 / 24;
      bool isDrawn = false;
      for (double radius_mm = 13.0; radius_mm <= 19.0 && !isDrawn; radius_mm += 0.1)
        isDrawn = isBlueAt(glm::dvec2(0.0, 50.0) + radius_mm * glm::dvec2(std::cos(angle_rad), std::sin(angle_rad)));
      drawn += isDrawn ? 1 : 0;
    }
    return drawn >= 18;
  }
  [[nodiscard]] AttemptList attempts() const { return listAttempts(libraryFolder() / "attempts"); }

 private Q_SLOTS:
  void cleanup() { window_.reset(); }

  void theLessonThatComesNextTellsItsStepsByTheirKind() {
    showWindowWithCase(writeTaught());
    window_->openPlugins();
    openLessons();
    QVERIFY(waitUntil([this] { return seen("startLesson") != nullptr; }));
    const QStringList steps = text("lessonSteps").split(QLatin1Char('\n'));
    QCOMPARE(steps.size(), 9);
    QCOMPARE(steps.front(), QStringLiteral("1.  Read"));
    QCOMPARE(steps.at(2), QStringLiteral("3.  Set a plane"));
    QVERIFY2(!text("lessonSteps").contains(QStringLiteral("Title of ")), "a title may give an answer away");
  }

  void everyKindOfStepIsWorkedThrough() {
    begin();
    QCOMPARE(text("stepNumber"), QStringLiteral("Step 1 of 9"));
    keepScreenshot(*window_, "lessons-02-read");
    QCOMPARE(seen("stepDone")->text(), QStringLiteral("Go on"));
    QVERIFY2(seen("pauseStep") == nullptr, "nothing runs that could rest");
    press("stepDone");  // what is read is read: the next step comes at once

    waitForStep("watch");
    QVERIFY(seen("pauseStep") != nullptr && seen("stepDone")->text() == QStringLiteral("Done"));
    QVERIFY2(!seen("stepDone")->isEnabled(), "the scan has to be watched first");
    press("playExpert");
    QVERIFY(waitUntil([this] { return text("expertMark") == QStringLiteral("Here is the ball."); }));
    keepScreenshot(*window_, "lessons-03-watch");
    press("playExpert");
    press("stepDone");  // waits until it has been shown to its end

    waitForStep("plane");
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, 25.0));
    QVERIFY(waitUntil([this] { return !text("stepLive").isEmpty(); }));
    press("showHint");
    QCOMPARE(text("stepHint"), QStringLiteral("Look below the probe."));
    keepScreenshot(*window_, "lessons-04-plane");
    press("stepDone");
    QVERIFY(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Not passed yet")); }));
    keepScreenshot(*window_, "lessons-05-not-passed");
    QVERIFY2(seen("tryAgain")->property("primary").toBool() && !seen("nextStep")->property("primary").toBool(), "what one would do next");
    press("tryAgain");
    waitForStep("plane");
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, -25.0));
    session().makeImageNow();
    press("stepDone");
    QVERIFY2(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Passed")); }), qPrintable(text("outcomeScore")));
    press("nextStep");

    waitForStep("sweep");
    QTest::mouseClick(seen("stepDone"), Qt::LeftButton);
    QVERIFY2(text("outcomeHeading").isEmpty() && text("stepMissing").startsWith(QStringLiteral("Nothing was done")),
             "a second click ends nothing");
    for (int n = -10; n <= 10; ++n) {
      session().probeControl().setHold(
          slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, n == -10 ? -20.0 : 2.0));
      session().makeImageNow();
    }
    press("stepDone");
    QVERIFY2(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Passed")); }), qPrintable(text("remarkMissed")));
    press("nextStep");

    waitForStep("measure");
    QVERIFY(!seen("stepDone")->isEnabled());
    session().setFrozen(true);
    window_->calipers().take(measurement::CaliperKind::distance);
    window_->calipers().changeIn(Where::image, [](measurement::CaliperDrawing& drawing) {
      static_cast<void>(drawing.press({-16.0, 50.0}, 0.0));
      static_cast<void>(drawing.press({16.0, 50.0}, 0.0));
    });
    keepScreenshot(*window_, "lessons-06-measure");
    press("stepDone");
    QVERIFY2(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Passed")); }), qPrintable(text("remarkMissed")));
    press("nextStep");

    waitForStep("point");
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, -20.0));
    session().makeImageNow();
    session().setFrozen(true);  // and no button is to be pressed
    auto* layer = find<PickLayer>("pointing");
    QVERIFY(waitUntil([&] { return layer->isPicking(); }));
    const QPointF at = window_->scanView().positionOf({{0.0, 50.0, 0.0}}) - QPointF(layer->pos());
    QTest::mouseClick(layer, Qt::LeftButton, Qt::NoModifier, at.toPoint());
    keepScreenshot(*window_, "lessons-07-point");
    press("stepDone");
    QVERIFY2(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Passed")); }), qPrintable(text("remarkMissed")));
    QVERIFY(!layer->isPicking());
    keepScreenshot(*window_, "lessons-07b-pointed");
    press("nextStep");

    waitForStep("settings");
    QVERIFY2(session().console().knobs().depth_mm < 100.0 || session().console().knobs().depth_mm > 130.0,
             "it begins with a setting that is wrong");
    QVERIFY(waitUntil([this] { return text("stepLive").contains(QStringLiteral("\u2022  Depth")); }));
    Knobs knobs = session().console().knobs();
    knobs.depth_mm = 120.0;
    session().console().setKnobs(knobs);
    session().makeImageNow();
    press("stepDone");
    QVERIFY(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Passed")); }));
    press("nextStep");

    waitForStep("answer");
    QVERIFY(!seen("stepDone")->isEnabled());
    QTest::mouseClick(seen<QAbstractButton>("answerOption"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    keepScreenshot(*window_, "lessons-08-answer");
    press("stepDone");
    QVERIFY(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Passed")); }));
    press("nextStep");

    waitForStep("free");
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, 2.0));
    press("stepDone");
    press("nextStep");
    QVERIFY(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Lesson")); }));
    keepScreenshot(*window_, "lessons-09-end");
    press("nextStep");
    QVERIFY(waitUntil([this] { return text("lessonProgress").startsWith(QLatin1String("7 of 7")); }));

    const AttemptList kept = attempts();
    QVERIFY(kept.problems.empty());
    const Attempt& attempt = kept.attempts.front().second;
    QVERIFY(attempt.finishedAt);
    QCOMPARE(attempt.outcomes.size(), std::size_t(10));  // the plane twice
    QVERIFY(attempt.outcomeOf("plane")->verdict == StepVerdict::passed);
    QVERIFY(QFile::exists(QString::fromStdString((kept.attempts.front().first / attempt.outcomeOf("plane")->images.front()).string())));
    QVERIFY(readRecording(kept.attempts.front().first / attempt.outcomeOf("sweep")->recording));
  }

  /// Whoever works through a step with the mouse goes on scanning with the keys, and the button that is marked is pressed with them.
  void keysReachTheScanAfterClicksInThePanelAndTheMarkedButton() {
    begin();
    skipTo("plane");
    session().setFrozen(true);
    press("stepDone");
    // The program put the focus on the button that leads on: Return presses it, and Space freezes nothing.
    QVERIFY(waitUntil([this] { return seen("nextStep") != nullptr && seen("nextStep")->hasFocus(); }));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    waitForStep("sweep");
    const auto slidesBy = [this](int key) {
      const Hold before = session().probeControl().hold();
      QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : window_.get(), static_cast<Qt::Key>(key));
      return !(session().probeControl().hold() == before);
    };
    for (QWidget* each : {static_cast<QWidget*>(seen("showHint")), static_cast<QWidget*>(seen<QLabel>("stepTitle")),
                          static_cast<QWidget*>(window_->findChild<QTabWidget*>(QStringLiteral("consolePages"))->tabBar()),
                          static_cast<QWidget*>(find<QSlider>("gain")), static_cast<QWidget*>(find<QPushButton>("workspaceExplore"))}) {
      QVERIFY(each);
      QTest::mouseClick(each, Qt::LeftButton);
      QTest::qWait(10);
      const int gain = find<QSlider>("gain")->value();
      QVERIFY2(slidesBy(Qt::Key_Left), qPrintable(each->objectName()));
      QVERIFY2(slidesBy(Qt::Key_Up), qPrintable(each->objectName()));
      QCOMPARE(find<QSlider>("gain")->value(), gain);
    }
    // A control that was reached with Tab has its own keys.
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    find<QSlider>("gain")->clearFocus();  // it was clicked above, and what has the focus is not reached anew
    find<QSlider>("gain")->setFocus(Qt::TabFocusReason);
    const int gain = find<QSlider>("gain")->value();
    QVERIFY(!slidesBy(Qt::Key_Right));
    QVERIFY(find<QSlider>("gain")->value() != gain);
  }

  void aClickedButtonThatGoesOutLeavesTheKeysToTheScan() {
    begin();
    skipTo("plane");
    QVERIFY(waitUntil([this] { return seen("showHint") != nullptr; }));
    for (int n = 0; n < 10 && seen("showHint")->isEnabled(); ++n) {
      QTest::mouseClick(seen("showHint"), Qt::LeftButton);
      QTest::qWait(50);
    }
    QVERIFY2(!seen("showHint")->isEnabled(), "there are no more hints, and one can be asked for");
    QVERIFY(QApplication::focusWidget() != nullptr);
    const auto* explore = find<QPushButton>("workspaceExplore");
    QVERIFY2(!explore->hasFocus(), "a button that nobody reached has the keys");
    QVERIFY(!session().isFrozen());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    QVERIFY2(session().isFrozen(), qPrintable(QApplication::focusWidget()->objectName()));
    const Hold before = session().probeControl().hold();
    session().setFrozen(false);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left);
    QVERIFY2(!(session().probeControl().hold() == before), qPrintable(QApplication::focusWidget()->objectName()));
  }

  /// Whoever pointed beside it sees where it was, and not before.
  void whatWasToBePointedAtIsOutlinedOnceItWasJudged() {
    beginWith({step("point", PointTask{"ball"})});
    session().makeImageNow();
    session().setFrozen(true);
    auto* layer = find<PickLayer>("pointing");
    QVERIFY(waitUntil([&] { return layer->isPicking(); }));
    const QPointF beside = window_->scanView().positionOf({{30.0, 50.0, 0.0}}) - QPointF(layer->pos());
    QTest::mouseClick(layer, Qt::LeftButton, Qt::NoModifier, beside.toPoint());
    QVERIFY2(!isBallOutlined(), "it would be the answer");
    press("stepDone");
    QVERIFY(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Not passed yet")); }));
    QVERIFY(waitUntil([this] { return isBallOutlined(); }));
    keepScreenshot(*window_, "lessons-07c-outlined");
    press("tryAgain");
    waitForStep("point");
    QVERIFY2(waitUntil([this] { return !isBallOutlined(); }), "the next try begins without the answer");
  }

  void whatIsSoughtElsewhereIsSaidInPlaceOfItsOutline() {
    LessonStep asked = step("point", PointTask{"ball"});
    asked.aids.outline = true;
    beginWith({asked});
    session().makeImageNow();
    QVERIFY(waitUntil([this] { return isBallOutlined(); }));
    QCOMPARE(text("outlineElsewhere"), QString());
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, 40.0));
    session().makeImageNow();
    QVERIFY(waitUntil([this] { return text("outlineElsewhere") == QStringLiteral("What is sought is not in this image."); }));
    QVERIFY(!isBallOutlined());
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, -40.0));
    session().makeImageNow();
    QVERIFY(waitUntil([this] { return text("outlineElsewhere").isEmpty(); }));
  }

  void aLessonThatWasLeftIsGoneOnWith() {
    begin();
    press("stepDone");
    waitForStep("watch");
    press("leaveLesson");
    QVERIFY(waitUntil([this] { return seen("goOnWithLesson") != nullptr; }));
    keepScreenshot(*window_, "lessons-10-interrupted");
    press("goOnWithLesson");
    waitForStep("watch");
  }

  void aStepThatAKillTookIsOfferedAndGoesOnWhereItStood() {
    begin();
    skipTo("sweep");
    QVERIFY2(isScanKept(), "what is scanned in the step is kept as it grows");
    kill();
    startAndGoOn("sweep");
    press("skipStep");
    waitForStep("measure");
  }

  void aLessonThatIsFinishedIsNotOfferedButForAStepThatIsTriedOnceMore() {
    beginWith({step("plane", PlaneTask{"start plane", {}, {}})});
    QVERIFY(waitUntil([this] { return isKept("about.json"); }));
    const std::size_t tried = attempts().attempts.size();
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, 25.0));
    QVERIFY(waitUntil([this] { return !text("stepLive").isEmpty(); }));
    press("stepDone");
    QVERIFY(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Not passed yet")); }));
    QVERIFY2(waitUntil([this] { return !isKept("about.json"); }), "the attempt is finished: a kill takes nothing any more");
    press("nextStep");
    press("repeatStep");
    waitForStep("plane");
    QVERIFY(isScanKept());
    kill();
    startAndGoOn("plane");
    QVERIFY2(attempts().attempts.size() == tried, "it goes on in its own attempt");
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, -5.0));
    session().makeImageNow();
    press("stepDone");
    press("nextStep");
    QVERIFY(waitUntil([this] { return text("outcomeHeading").startsWith(QStringLiteral("Lesson")); }));
    QVERIFY2(attempts().attempts.front().second.outcomes.size() == 2, "what was scanned before the kill counts");
    QVERIFY2(waitUntil([this] { return !isKept("about.json"); }), "and nothing is offered at the next start");
  }

  void whatIsReadIsNotPassed() {
    LessonStep read = step("read", ReadingTask{});
    read.after = "The box shows how far the recording reaches.";
    beginWith({read, step("next", ReadingTask{})});
    press("stepDone");
    QVERIFY(waitUntil([this] { return text("afterStep") == QStringLiteral("The box shows how far the recording reaches."); }));
    QCOMPARE(text("outcomeHeading"), QString::fromStdString(read.title));
    QVERIFY(text("outcomeScore").isEmpty());
    QCOMPARE(seen("tryAgain")->text(), QStringLiteral("Read again"));
    press("nextStep");
    waitForStep("next");
  }

  void aStepOfACaseThatIsNotPreparedOpensItByItself() {
    test::makeSmallCase(files_.path(QStringLiteral("own cases/small")).toStdString());
    const QString cache = files_.path(QStringLiteral("cache of steps"));
    const test::EnvironmentValue there("ECHOWEAVE_CACHE", cache.toStdString());
    // As on a machine that is a million times slower.
    QDir().mkpath(cache);
    QVERIFY(writeFileSafely((cache + QStringLiteral("/speed.json")).toStdString(), R"({"recording": 1e6})"));
    LessonStep elsewhere = step("elsewhere", ReadingTask{});
    elsewhere.caseId = "small";
    beginWith({step("read", ReadingTask{}), elsewhere});
    press("stepDone");
    waitForStep("elsewhere");
    QCOMPARE(QString::fromStdString(window_->document().current()->id), QStringLiteral("small"));
  }

  void aStepWhoseCaseDoesNotOpenCanBeLeft() {
    const QString broken = files_.writeCase(QStringLiteral("own cases/broken"));
    auto made = loadCaseAside(broken.toStdString());
    QVERIFY(made.has_value());
    made->id = "broken";
    QVERIFY(saveCase(*made, broken.toStdString()).has_value());
    QFile volume(broken + QStringLiteral("/volume.mha"));
    QVERIFY(volume.resize(volume.size() / 2));
    LessonStep elsewhere = step("elsewhere", ReadingTask{});
    elsewhere.caseId = "broken";
    beginWith({step("read", ReadingTask{}), elsewhere});
    press("stepDone");
    press("leaveWaiting");
    QVERIFY(waitUntil([this] { return seen("goOnWithLesson") != nullptr; }));
    QCOMPARE(attempts().attempts.front().second.outcomes.size(), std::size_t(1));
  }

  void anotherCaseInTheMiddleLosesNothing() {
    begin();
    skipTo("plane");
    const QString other = files_.writeCase(QStringLiteral("other"));
    QVERIFY(openCase(other));
    QVERIFY(attempts().attempts.front().second.outcomes.size() == 2);
    QVERIFY(waitUntil([this] { return !find<QWidget>("pointing")->isVisible(); }));
  }
};

}  // namespace ew::ui::testing

using ew::ui::testing::LessonsTest;
EW_WINDOW_TEST_MAIN(LessonsTest)
#include "lessons_test.moc"
