// A trainee with a home of their own takes a bundle into the library, passes one lesson, fails another, stops in the middle of a third when
// the program is killed, and goes on at that step. The first half runs in a process of its own, which is really killed.
#include <QProcess>
#include <csignal>

#include "ew/library/attempt.h"
#include "ew/library/bundle.h"
#include "ew/library/published.h"
#include "gui/support/screenshots.h"
#include "gui/support/taught_case.h"

namespace ew::ui::testing {
namespace {

constexpr const char* kBundle = "EW_TEST_BUNDLE";  // in the environment of the process that is killed
constexpr const char* kReady = "EW_TEST_READY";
constexpr const char* kHome[] = {"ECHOWEAVE_LIBRARY", "ECHOWEAVE_CASES", "ECHOWEAVE_CACHE", "XDG_DATA_HOME"};

const QString kTitle = QStringLiteral("A ball for you");

}  // namespace

/// What the trainee does until the program is killed.
class TraineeAtWork final : public LearnerFixture {
  Q_OBJECT

 public:
  /// The fixture makes a home of its own; the trainee's is the one that was handed in.
  explicit TraineeAtWork(const std::map<std::string, QByteArray>& home) {
    for (const auto& [name, value] : home) qputenv(name.c_str(), value);
  }

 private Q_SLOTS:
  void worksUntilKilled() {
    makeWindow();
    keepScreenshot(*window_, "bundle-01-empty-library");
    window_->open(qEnvironmentVariable(kBundle));
    QVERIFY(waitUntil([this] { return window_->isSettled() && cardOf(kTitle).isValid(); }));
    keepScreenshot(*window_, "bundle-02-imported");

    startFromCard(kTitle, 0);
    waitForStep("read");
    keepScreenshot(*window_, "bundle-03-first-step");
    press("stepDone");
    waitForStep("answer");
    answer(0);
    waitForOutcome(QStringLiteral("Passed"));
    press("nextStep");
    waitForOutcome(QStringLiteral("Lesson passed"));
    QVERIFY2(text("outcomeToSystem").isEmpty(), "no learning system asks for anything");
    keepScreenshot(*window_, "bundle-04-lesson-passed");
    press("nextStep");

    window_->showStartPage();
    QVERIFY(waitUntil([this] { return spokenOf(kTitle).contains(QStringLiteral("1 of 3 lessons passed")); }));
    qputenv(kLaunchVariable, "0a5f-17.4");  // as if a learning system had started it, which is content with 0 points
    qputenv(kMasteryVariable, "0");
    startFromCard(kTitle, 1);
    waitForStep("read");
    qunsetenv(kLaunchVariable);
    qunsetenv(kMasteryVariable);
    press("stepDone");
    waitForStep("answer");
    answer(1);
    waitForOutcome(QStringLiteral("Not passed yet"));
    keepScreenshot(*window_, "bundle-05-failed");
    press("nextStep");
    waitForOutcome(QStringLiteral("Lesson finished"));
    QVERIFY2(text("outcomeToSystem").startsWith(QStringLiteral("The learning system asks for 0 of 100 points: passed there.")),
             qPrintable(text("outcomeToSystem")));
    press("nextStep");

    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    startFromCard(kTitle, 2);
    waitForStep("read");
    press("stepDone");
    waitForStep("answer");  // it runs, and is what will be lost
    QFile ready(qEnvironmentVariable(kReady));
    QVERIFY(ready.open(QIODevice::WriteOnly));
    ready.close();
    QTest::qWait(10 * 60 * 1000);
    QFAIL("nobody killed it");
  }
};

class TraineeBundleTest final : public LearnerFixture {
  Q_OBJECT

  /// The bundle of an author elsewhere.
  [[nodiscard]] QString makeBundle() {
    const QString folder = files_.writeCase(QStringLiteral("author/ball"));
    const QString bundle = files_.path(QStringLiteral("ball.ewcase"));
    if (!teach(folder, "ball-for-you", kTitle.toStdString(), threeLessons())) return {};
    return exportBundle(folder.toStdString(), bundle.toStdString()) ? bundle : QString();
  }

  /// Runs the first half and kills it in the middle of a step.
  void workAndDie(const QString& bundle) {
    const QString ready = files_.path(QStringLiteral("ready"));
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QLatin1String(kBundle), bundle);
    environment.insert(QLatin1String(kReady), ready);
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--trainee")});
    QVERIFY(process.waitForStarted());
    QVERIFY2(waitUntil([&] { return QFile::exists(ready) || process.state() == QProcess::NotRunning; }, 2 * test::kPatience_ms),
             "too slow");
    QVERIFY2(process.state() == QProcess::Running, process.readAll().constData());
    process.kill();  // SIGKILL: it can save nothing any more
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);
  }

 private Q_SLOTS:
  void cleanup() { window_.reset(); }

  void aTraineeWhoIsInterruptedGoesOnAtTheStepAndIsToldWhatWasLost() {
    const QString bundle = makeBundle();
    QVERIFY(!bundle.isEmpty());
    for (const char* name : kHome) qputenv(name, (files_.path(QStringLiteral("trainee/")) + QLatin1String(name)).toUtf8());
    workAndDie(bundle);

    const AttemptList left = listAttempts(attemptsFolder(libraryFolder()));
    QVERIFY(left.problems.empty());
    QCOMPARE(left.attempts.size(), std::size_t(3));
    QCOMPARE(left.attempts.front().second.runningStep, std::string("answer"));
    const auto published = latestPublished(libraryFolder(), "ball-for-you");
    QVERIFY(published);
    const auto verified = verifyCase(published->folder);
    QVERIFY(verified && verified->problems.empty());

    makeWindow();
    QVERIFY(spokenOf(kTitle).contains(QStringLiteral("1 of 3 lessons passed")));
    QCOMPARE(find<QLabel>("stoppedLesson")->text(), QStringLiteral("You stopped in step 2 of 3 of the lesson “Lesson third”."));
    keepScreenshot(*window_, "bundle-06-after-the-kill");
    press("goOnWithStopped");
    waitForStep("answer");
    QCOMPARE(text("stepNumber"), QStringLiteral("Step 2 of 3"));
    QVERIFY(said("begins anew"));
    keepScreenshot(*window_, "bundle-07-gone-on");
    answer(0);
    waitForOutcome(QStringLiteral("Passed"));
    press("nextStep");
    waitForStep("last");
    press("stepDone");
    waitForOutcome(QStringLiteral("Lesson passed"));
    press("nextStep");
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return spokenOf(kTitle).contains(QStringLiteral("2 of 3 lessons passed")); }));
    QVERIFY(!find<QLabel>("stoppedLesson")->isVisible());
    keepScreenshot(*window_, "bundle-08-end");
    QCOMPARE(listAttempts(attemptsFolder(libraryFolder())).attempts.size(), std::size_t(3));
  }
};

}  // namespace ew::ui::testing

int main(int argc, char** argv) {
  using namespace ew::ui::testing;
  QSurfaceFormat::setDefaultFormat(windowFormat());
  QApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("EchoWeave"));
  QApplication::setApplicationName(QStringLiteral("EchoWeave tests"));
  if (argc > 1 && std::string_view(argv[1]) == "--trainee") {
    std::map<std::string, QByteArray> home;
    for (const char* name : kHome) home[name] = qgetenv(name);
    TraineeAtWork trainee(home);
    return QTest::qExec(&trainee, 1, argv);
  }
  TraineeBundleTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "trainee_bundle_test.moc"
