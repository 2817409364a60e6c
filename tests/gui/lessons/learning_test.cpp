// A learner in the real window: how far one has got on the start page, going on from there, and exercises that the program makes of a case.
#include <QApplication>
#include <QCheckBox>
#include <QLineEdit>
#include <QProgressBar>
#include <QToolButton>

#include "ew/assessment/repetition_record.h"
#include "ew/widgets/theme.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/taught_case.h"

namespace ew::ui::testing {

class LearningTest final : public LearnerFixture {
  Q_OBJECT

  const std::string resources_ = qEnvironmentVariable("ECHOWEAVE_RESOURCES").toStdString();

  /// An attempt as if the trainee had made it.
  static void keepAttempt(const std::string& lesson, const std::vector<std::pair<const char*, StepVerdict>>& steps, bool finished,
                          const std::string& person = {}) {
    Attempt attempt;
    attempt.startedAt = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    attempt.id = idOfAttempt(attempt.startedAt);
    attempt.caseId = "ball-case";
    attempt.lessonId = lesson;
    attempt.lessonTitle = "Lesson " + lesson;
    attempt.person = person;
    auto kept = AttemptFolder::begin(attemptsFolder(libraryFolder()), attempt);
    QVERIFY(kept);
    for (const auto& [step, verdict] : steps) {
      StepOutcome outcome;
      outcome.stepId = step;
      outcome.verdict = verdict;
      outcome.at = attempt.startedAt;
      QVERIFY(kept->endStep(outcome));
    }
    if (finished) QVERIFY(kept->finish(attempt.startedAt));
  }
  static void passFirst() { keepAttempt("first", {{"read", StepVerdict::passed}, {"answer", StepVerdict::passed}}, true); }

  /// A program with no cases but a course through the lessons of the user's own.
  void writeProgram() {
    const QString program = files_.path(QStringLiteral("program"));
    QDir().mkpath(program + QStringLiteral("/cases"));
    const auto resources = resourceFolder();
    QVERIFY(resources);
    QFile::link(QString::fromStdString(resources->string()), program + QStringLiteral("/resources"));
    QFile course(program + QStringLiteral("/cases/course.json"));
    QVERIFY(course.open(QIODevice::WriteOnly));
    course.write(R"({"format": 1, "id": "c", "title": {"en": "All about balls", "de": "Alles über Bälle"},
      "text": {"en": "From ball to ball.", "de": "Von Ball zu Ball."}, "lessons": [{"case": "ball-case", "lesson": "first"},
      {"case": "ball-case", "lesson": "second"}, {"case": "elsewhere", "lesson": "lost"}, {"case": "ball-case", "lesson": "third"}]})");
    qputenv("ECHOWEAVE_RESOURCES", (program + QStringLiteral("/resources")).toUtf8());
  }

  [[nodiscard]] QString writeTaught(const std::vector<Lesson>& lessons = threeLessons()) {
    const QString folder = files_.writeCase(QStringLiteral("own cases/ball-case"));
    return teach(folder, "ball-case", "The ball", lessons) ? folder : QString();
  }

  /// With two planes that are found from the skin: where the probe stands at the start, and 30 mm beside it.
  [[nodiscard]] QString writeExercises() {
    const QString folder = writeTaught();
    showWindowWithCase(folder);
    const Hold start = session().probeControl().hold();
    planes_ = {start, slid(start, *session().probeControl().skin(), 0.0, 30.0)};
    window_.reset();
    auto opened = loadCaseAside(folder.toStdString());
    if (!opened) return {};
    for (std::size_t n = 0; n < 2; ++n)
      opened->targets.push_back({.kind = CaseTarget::Kind::plane,
                                 .name = n == 0 ? "near plane" : "far plane",
                                 .probeToFile = Transform<frame::File, frame::Probe>{poseOf(planes_[n]).probeToWorld.matrix},
                                 .positionTolerance_mm = 5.0,
                                 .angleTolerance_deg = 10.0});
    return saveCase(*opened, folder.toStdString()) ? folder : QString();
  }
  std::array<Hold, 2> planes_;

  void beginExercises() {
    makeWindow();
    QVERIFY(openCase(files_.path(QStringLiteral("own cases/ball-case"))));
    press("startExercises");
    QVERIFY2(waitUntil([this] { return !text("stepTitle").isEmpty(); }), qPrintable(text("lessonProblem")));
  }
  /// Of the exercise that is shown.
  [[nodiscard]] std::size_t askedPlane() const { return text("stepTitle").contains(QStringLiteral("near")) ? 0 : 1; }
  void solve() {
    session().probeControl().setHold(planes_[askedPlane()]);
    session().makeImageNow();
    press("stepDone");
  }
  void failIt() {
    session().probeControl().setHold(slid(planes_[askedPlane()], *session().probeControl().skin(), 0.0, -40.0));
    session().makeImageNow();
    press("stepDone");
  }
  [[nodiscard]] static std::vector<RepetitionState> states(const std::string& person = {}) {
    const auto kept = readRepetition(repetitionFile(libraryFolder(), person));
    return kept ? kept->states : std::vector<RepetitionState>();
  }

 private Q_SLOTS:
  void init() { QSettings().clear(); }
  void cleanup() {
    window_.reset();
    for (const char* name : {"own cases", "library", "program", "cache"}) QDir(files_.path(QLatin1String(name))).removeRecursively();
    if (resources_.empty())
      qunsetenv("ECHOWEAVE_RESOURCES");
    else
      qputenv("ECHOWEAVE_RESOURCES", QByteArray::fromStdString(resources_));
  }

  void aCardSaysHowFarOneHasGotAndNothingBefore() {
    writeProgram();
    QVERIFY(!writeTaught().isEmpty());
    makeWindow();
    QVERIFY(!spokenOf(QStringLiteral("The ball")).contains(QStringLiteral("passed")));
    keepScreenshot(*window_, "learning-01-new");
    passFirst();
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return spokenOf(QStringLiteral("The ball")).contains(QStringLiteral("1 of 3 lessons passed")); }));
    keepScreenshot(*window_, "learning-02-one-passed");
  }

  void theCourseSaysWhatComesNextAndBeginsIt() {
    writeProgram();
    QVERIFY(!writeTaught().isEmpty());
    passFirst();
    makeWindow();
    QVERIFY(find<QLabel>("courseTitle")->text().contains(QStringLiteral("All about balls")));
    QVERIFY2(find<QLabel>("courseProgress")->text().startsWith(QStringLiteral("1 of 4 lessons passed. Next: Lesson second")),
             qPrintable(find<QLabel>("courseProgress")->text()));
    QCOMPARE(find<QProgressBar>("courseBar")->value(), 1);
    QTest::mouseClick(find<QToolButton>("allLessons"), Qt::LeftButton);
    QStringList listed;
    for (const auto* each : window_->findChildren<QLabel*>(QStringLiteral("courseLessonState"))) listed << each->text();
    QCOMPARE(listed.size(), 4);
    QVERIFY(listed[0].endsWith(QStringLiteral("Passed")));
    QVERIFY(listed[2].contains(QStringLiteral("not in the library")));
    keepScreenshot(*window_, "learning-03-course");
    press("goOnWithCourse");
    waitForStep("read");
    QCOMPARE(listAttempts(attemptsFolder(libraryFolder())).attempts.front().second.lessonId, std::string("second"));
    keepScreenshot(*window_, "learning-04-begun-from-the-course");
  }

  void whatWasStoppedIsGoneOnWithAtItsStep() {
    writeProgram();
    QVERIFY(!writeTaught().isEmpty());
    keepAttempt("third", {{"read", StepVerdict::passed}}, false);
    makeWindow();
    QCOMPARE(find<QLabel>("stoppedLesson")->text(), QStringLiteral("You stopped in step 2 of 3 of the lesson “Lesson third”."));
    keepScreenshot(*window_, "learning-05-stopped");
    press("goOnWithStopped");
    waitForStep("answer");
    QCOMPARE(text("stepNumber"), QStringLiteral("Step 2 of 3"));
    QCOMPARE(listAttempts(attemptsFolder(libraryFolder())).attempts.size(), std::size_t(1));
  }

  void aLessonOfAnOpenCaseIsBegunWithoutOpeningItAgain() {
    QVERIFY(!writeTaught().isEmpty());
    makeWindow();
    startFromCard(QStringLiteral("The ball"), 0);
    waitForStep("read");
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    startFromCard(QStringLiteral("The ball"), 1);
    QVERIFY(waitUntil([] {
      const AttemptList kept = listAttempts(attemptsFolder(libraryFolder()));
      return kept.attempts.size() == 2;
    }));
    waitForStep("read");
  }

  void aCardListsItsLessonsAndEscapeClosesThem() {
    QVERIFY(!writeTaught().isEmpty());
    passFirst();
    keepAttempt("third", {{"read", StepVerdict::passed}}, false);
    makeWindow();
    QWidget* lessons = openLessonsOf(QStringLiteral("The ball"));
    QVERIFY(lessons);
    QStringList buttons, listed;
    for (const auto* each : lessons->findChildren<QPushButton*>(QStringLiteral("startLessonOfCase"))) buttons << each->text();
    QCOMPARE(buttons, (QStringList{QStringLiteral("Once more"), QStringLiteral("Start"), QStringLiteral("Go on")}));
    if (!screenshotFolder().isEmpty()) {
      QTest::qWait(300);
      lessons->grab().save(screenshotFolder() + QStringLiteral("/learning-06-card-lessons.png"));
    }
    QTest::keyClick(lessons, Qt::Key_Escape);
    QVERIFY(waitUntil([this] { return lessonsShown() == nullptr; }));
    cards()->setFocus(Qt::TabFocusReason);
    QTest::keyClick(cards(), Qt::Key_Return, Qt::ShiftModifier);
    QVERIFY2(waitUntil([this] { return lessonsShown() != nullptr; }), "the keyboard opens them as well");
  }

  void aCaseThatTeachesNothingLeavesItsRoomToTheScan() {
    const QString plain = files_.writeCase(QStringLiteral("own cases/plain"));
    QVERIFY(!writeTaught().isEmpty());
    makeWindow();
    QVERIFY(openCase(plain));
    QVERIFY(waitUntil([this] { return !find<QWidget>("authorColumn")->isVisible(); }));
    keepScreenshot(*window_, "learning-07-no-lessons");
    QVERIFY(openCase(files_.path(QStringLiteral("own cases/ball-case"))));
    QVERIFY(waitUntil([this] { return find<QWidget>("authorColumn")->isVisible() && seen("startLesson") != nullptr; }));
    keepScreenshot(*window_, "learning-08-lessons");
  }

  void anExerciseThatWasFailedComesBackAndOneThatWasRightIsDueLater() {
    QVERIFY(!writeExercises().isEmpty());
    beginExercises();
    QCOMPARE(text("stepNumber"), QStringLiteral("Level 1 of 5"));
    const QString first = text("stepTitle");
    keepScreenshot(*window_, "learning-09-exercise");
    failIt();
    waitForOutcome(QStringLiteral("Not right yet"));
    QVERIFY(text("comesAgain").startsWith(QStringLiteral("It comes again in a few minutes")));
    QVERIFY(!text("remarkMissed").isEmpty());
    keepScreenshot(*window_, "learning-10-wrong");
    press("nextStep");
    QVERIFY(waitUntil([&] { return !text("stepTitle").isEmpty(); }));
    QVERIFY2(text("stepTitle") != first, "the one that was tried last does not come at once while there is another");
    solve();
    waitForOutcome(QStringLiteral("Right"));
    QVERIFY(text("comesAgain").startsWith(QStringLiteral("It comes again tomorrow")));
    keepScreenshot(*window_, "learning-11-right");
    press("nextStep");
    QVERIFY(waitUntil([&] { return !text("stepTitle").isEmpty(); }));
    QCOMPARE(text("stepTitle"), first);
    solve();
    waitForOutcome(QStringLiteral("Right"));
    press("tryAgain");  // which stops
    QVERIFY(waitUntil([this] { return text("exerciseState").startsWith(QStringLiteral("Of 2 exercises tried, none is due")); }));
    keepScreenshot(*window_, "learning-12-overview");
    const auto kept = states();
    QCOMPARE(kept.size(), std::size_t(2));
    int tries = 0, lapses = 0;
    for (const RepetitionState& each : kept) {
      tries += each.tries;
      lapses += each.lapses;
    }
    QCOMPARE(tries, 3);
    QCOMPARE(lapses, 1);
  }

  void anExerciseNeverBeginsSolvedAndTheHandGoesOnFromItsStart() {
    QVERIFY(!writeExercises().isEmpty());
    beginExercises();
    const Hold start = session().probeControl().hold();
    QVERIFY(!(start == planes_[0]) && !(start == planes_[1]));
    QTest::mouseClick(seen("stepDone"), Qt::LeftButton);
    QVERIFY2(text("outcomeHeading").isEmpty(), "nothing was done yet");
    session().setFrozen(true);
    press("stepDone");
    waitForOutcome(QStringLiteral("Not right yet"));
    QCOMPARE(session().probeControl().hold(), start);
  }

  void aDamagedFileOfExercisesIsPutAsideAndNamed() {
    QVERIFY(!writeExercises().isEmpty());
    const auto file = repetitionFile(libraryFolder(), {});
    std::filesystem::create_directories(file.parent_path());
    QVERIFY(writeFileSafely(file, std::string("{ broken")));
    beginExercises();
    QVERIFY(said("repetition-unreadable.json"));
    keepScreenshot(*window_, "learning-13-damaged");
    failIt();
    waitForOutcome(QStringLiteral("Not right yet"));
    QCOMPARE(states().size(), std::size_t(1));
    QCOMPARE(*readTextFile(file.parent_path() / "repetition-unreadable.json"), std::string("{ broken"));
  }

  void aFileOfANewerProgramStaysAndExercisesGoOnWithoutIt() {
    QVERIFY(!writeExercises().isEmpty());
    const auto file = repetitionFile(libraryFolder(), {});
    std::filesystem::create_directories(file.parent_path());
    const std::string newer = R"({"format": 99})";
    QVERIFY(writeFileSafely(file, newer));
    beginExercises();
    QVERIFY(text("lessonProblem").contains(QStringLiteral("99")));
    failIt();
    waitForOutcome(QStringLiteral("Not right yet"));
    QCOMPARE(*readTextFile(file), newer);
  }

  void attemptsAndTriesBearTheNameOfWhoLearns() {
    QVERIFY(!writeExercises().isEmpty());
    passFirst();                                                                                             // by nobody in particular
    keepAttempt("second", {{"read", StepVerdict::passed}, {"answer", StepVerdict::passed}}, true, "Grace");  // by somebody else
    makeWindow();
    QVERIFY(openCase(files_.path(QStringLiteral("own cases/ball-case"))));
    QVERIFY(waitUntil([this] { return seen<QLineEdit>("personWhoLearns") != nullptr; }));
    QTest::keyClicks(seen<QLineEdit>("personWhoLearns"), QStringLiteral("Ada"));
    QTest::keyClick(seen<QLineEdit>("personWhoLearns"), Qt::Key_Return);
    QVERIFY(waitUntil([this] { return text("lessonProgress").startsWith(QStringLiteral("1 of 1")); }));
    keepScreenshot(*window_, "learning-14-name");
    press("startExercises");
    QVERIFY(waitUntil([this] { return !text("stepTitle").isEmpty(); }));
    failIt();
    waitForOutcome(QStringLiteral("Not right yet"));
    QCOMPARE(states("Ada").size(), std::size_t(1));
    QVERIFY(states().empty());
    press("tryAgain");
    press("startLesson");
    waitForStep("read");
    QCOMPARE(listAttempts(attemptsFolder(libraryFolder())).attempts.front().second.person, std::string("Ada"));
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return spokenOf(QStringLiteral("The ball")).contains(QStringLiteral("1 of 3 lessons passed")); }));
  }
};

}  // namespace ew::ui::testing

using ew::ui::testing::LearningTest;
EW_WINDOW_TEST_MAIN(LearningTest)
#include "learning_test.moc"
