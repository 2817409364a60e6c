// What was done outlives a kill of the real program: this test starts itself as a window, kills it by its number, and looks at what the
// next one offers.
#include <QAction>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "ew/io/autosave.h"
#include "ew/scanning/recording_journal.h"
#include "ew/ui_test_door/cine.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/start.h"
#include "ew/ui_test_door/window.h"
#include "ew/ui_test_door/worksheets.h"
#include "gui/support/answers.h"
#include "gui/support/window_fixture.h"
#include "scanning/small_scan.h"

namespace ew::ui::testing {
namespace {

constexpr const char* kAsWindow = "EW_KEEPING_WINDOW";    ///< what to do in it; the process is the window then
constexpr const char* kCase = "EW_KEEPING_CASE";          ///< folder
constexpr const char* kSweep = "EW_KEEPING_SWEEP";        ///< file
constexpr const char* kSettings = "EW_KEEPING_SETTINGS";  ///< folder
constexpr int kFrames = 4;
constexpr const char* kPackage = "abdomen";

std::size_t left(const QString& data) {
  std::error_code ignored;
  std::size_t count = 0;
  for (std::filesystem::directory_iterator at(data.toStdString() + "/echoweave/unsaved-work", ignored);
       at != std::filesystem::directory_iterator(); at.increment(ignored))
    ++count;
  return count;
}

/// Images that lie in the kept recording by now.
int framesKept() {
  int frames = 0;
  std::error_code ignored;
  const std::filesystem::path root = qgetenv("XDG_DATA_HOME").toStdString() + "/echoweave/unsaved-work";
  for (std::filesystem::directory_iterator at(root, ignored); at != std::filesystem::directory_iterator(); at.increment(ignored)) {
    QFile file(QString::fromStdString((at->path() / "recording.jsonl").string()));
    if (file.open(QIODevice::ReadOnly)) frames += file.readAll().count("\"frame\"");
  }
  return frames;
}

void record(MainWindow& window) {
  window.session().setFrozen(false);
  window.recorder().start("window-test");
  waitUntil(
      [&] {
        window.session().frames().ask();
        window.session().makeImageNow();
        return framesKept() >= kFrames;
      },
      4.0 * test::kPatience_ms);
}

void measure(MainWindow& window) {
  window.worksheets().choose(kPackage);
  window.worksheets().measure("AORTA", "");
  window.calipers().changeIn(Where::image, [](measurement::CaliperDrawing& drawing) {
    for (const glm::dvec2 at : {glm::dvec2(-8.0, 50.0), glm::dvec2(9.0, 50.0)}) {
      drawing.press(at, 1.0);
      drawing.release(at, 1.0);
    }
  });
  QTest::qWait(600);  // it is kept a moment after the last change
}

void makeVolume(MainWindow& window) {
  window.open(qEnvironmentVariable(kSweep));
  QDialog* dialog = nullptr;
  waitUntil([&] { return (dialog = window.findChild<QDialog*>(QStringLiteral("importDialog"))) != nullptr && dialog->isVisible(); });
  auto* make = dialog->findChild<QPushButton*>(QStringLiteral("makeVolume"));
  waitUntil([&] { return make->isEnabled(); });
  make->click();
  waitUntil([&] { return window.isSettled() && !window.document().current(); });
}

/// NIfTI-1 of 32 x 32 x 32 voxels of 3 mm, twice: which of them is meant has to be asked.
std::string twoInOneFile() {
  constexpr std::int16_t kSide = 32;
  std::string bytes(352, '\0');
  const auto put = [&](std::size_t at, auto value) { std::memcpy(bytes.data() + at, &value, sizeof value); };
  put(0, std::int32_t{348});
  const std::array<std::int16_t, 5> dims{4, kSide, kSide, kSide, 2};
  for (std::size_t n = 0; n < dims.size(); ++n) put(40 + 2 * n, dims[n]);
  put(70, std::int16_t{2});
  put(72, std::int16_t{8});
  for (std::size_t n = 0; n < 8; ++n) put(76 + 4 * n, n >= 1 && n <= 3 ? 3.0F : 1.0F);
  put(108, 352.0F);
  put(254, std::int16_t{1});
  for (std::size_t n = 0; n < 3; ++n) put(280 + 20 * n, 3.0F);
  bytes.replace(344, 4, std::string("n+1\0", 4));
  for (int n = 0; n < 2 * kSide * kSide * kSide; ++n) bytes += static_cast<char>(n % 199);
  return bytes;
}

/// Says "ready" once everything is done, and waits to be killed.
int runAsWindow() {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, qEnvironmentVariable(kSettings));
  MainWindow window;
  window.resize(1280, 720);
  window.show();
  window.session().frames().setAdaptive(false);
  window.open(qEnvironmentVariable(kCase));
  if (!waitUntil([&] { return window.isSettled() && window.document().current(); })) return 1;
  const QByteArray what = qgetenv(kAsWindow);
  if (what == "record") record(window);
  if (what == "measure") measure(window);
  if (what == "volume") makeVolume(window);
  QTest::qWait(300);
  std::cout << "ready" << std::endl;
  return QApplication::exec();
}

}  // namespace

class KeepingTest : public WindowFixture {
  Q_OBJECT

  QString case_;
  [[nodiscard]] QString data() const { return files_.path(QStringLiteral("data")); }

  /// Runs a window that does something, and kills it as `kill -9` does.
  void doAndBeKilled(const char* what) const {
    QProcess window;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QLatin1String(kAsWindow), QLatin1String(what));
    environment.insert(QLatin1String(kCase), case_);
    environment.insert(QLatin1String(kSweep), files_.path(QStringLiteral("made.igs.mha")));
    environment.insert(QLatin1String(kSettings), files_.settings());
    window.setProcessEnvironment(environment);
    window.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    window.start(QCoreApplication::applicationFilePath(), QStringList());
    QVERIFY(window.waitForStarted());
    QByteArray said;
    QVERIFY(waitUntil([&] { return window.state() != QProcess::Running || (said += window.readAllStandardOutput()).contains("ready"); },
                      4.0 * test::kPatience_ms));
    QVERIFY2(said.contains("ready"), said.constData());
    QCOMPARE(::kill(static_cast<pid_t>(window.processId()), SIGKILL), 0);
    QVERIFY(waitUntil([&] { return window.state() == QProcess::NotRunning; }));
  }
  void startWindow() {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    session().frames().setAdaptive(false);
    window_->openWhereOneWas();
    window_->offerUnsavedWork();
  }
  /// What a window left that was killed: a recording of so many frames. @param path of what it was made of; empty: that lies in no file
  void leaveRecording(const char* name, const QString& path, int frames, const std::shared_ptr<const Volume>& shown = nullptr) const {
    const QString folder = data() + QStringLiteral("/echoweave/unsaved-work/") + QLatin1String(name);
    QVERIFY(QDir().mkpath(folder));
    ScanRecording recording;
    recording.size_px = {320, 240};
    recording.title = name;
    for (int n = 0; n < frames; ++n) recording.log.addFrame(test::movingState(n));
    nlohmann::json about = {{"kind", "window"}, {"path", path.toStdString()}, {"title", name}, {"volumes", nlohmann::json::array()}};
    if (shown) {
      about["volumes"].push_back({{"path", "/made/of.igs.mha"}, {"title", name}, {"item", "volume-1.mha"}, {"shown", true}});
      QVERIFY(writeVolume(*shown, (folder + QStringLiteral("/volume-1.mha")).toStdString()).has_value());
    }
    const std::pair<const char*, std::string> items[] = {
        {"lock", {}}, {"about.json", about.dump()}, {"recording.jsonl", journalHead(recording) + journalLines(recording.log, 0)}};
    for (const auto& [item, text] : items)
      QVERIFY(writeFileSafely((folder + QLatin1Char('/') + QLatin1String(item)).toStdString(), text).has_value());
  }
  [[nodiscard]] bool isLeft(const char* name) const {
    return QFile::exists(data() + QStringLiteral("/echoweave/unsaved-work/") + QLatin1String(name));
  }
  [[nodiscard]] std::size_t framesHere() const {
    const auto recording = window_->replayBar().recording();
    return recording ? recording->log.frameCount() : 0;
  }
  /// Whether a sentence with these words is among the messages; all of them go.
  [[nodiscard]] bool wasSaid(const char* words) const {
    bool found = false;
    for (; window_->messages().count() > 0; window_->messages().dismiss())
      found = found || window_->messages().text().contains(QLatin1String(words));
    return found;
  }
  void closeWithoutSaving() {
    Answers answers({{QStringLiteral("unsavedRecordingQuestion"), press(QMessageBox::Discard)},
                     {QStringLiteral("unsavedVolumeQuestion"), press(QMessageBox::Discard)}});
    QVERIFY(window_->close());
    window_.reset();
  }
  void waitForRest() const {
    QVERIFY(waitUntil([this] { return window_->isSettled() && window_->jobs().seen().empty(); }));
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    QDir(data() + QStringLiteral("/echoweave/unsaved-work")).removeRecursively();
    case_ = files_.writeCase(QStringLiteral("case"));
  }
  void cleanup() { window_.reset(); }

  void aRecordingOutlivesAKillAndIsOfferedOnce() {
    doAndBeKilled("record");
    QCOMPARE(left(data()), std::size_t{1});
    {
      Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")}});
      startWindow();
      QVERIFY(waitUntil([this] { return window_->replayBar().recording() != nullptr; }));
      waitForRest();
      QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedWorkQuestion")});
    }
    QVERIFY2(window_->document().current(), "it goes on where one was");
    QCOMPARE(QString::fromStdString(window_->document().current()->folder.string()), case_);
    const auto recording = window_->replayBar().recording();
    QVERIFY2(recording->log.frameCount() >= static_cast<std::size_t>(kFrames), "all that had been kept by then");
    QVERIFY(session().isPlaying());
    {
      Answers answers({{QStringLiteral("unsavedRecordingQuestion"), press(QMessageBox::Discard)}});
      QVERIFY(window_->close());
      QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedRecordingQuestion")});
    }
    QCOMPARE(left(data()), std::size_t{0});
    Answers answers({});
    startWindow();
    waitForRest();
    QVERIFY2(answers.asked.isEmpty(), "never twice");
  }

  void whatWasMeasuredOutlivesAKillAndIsDiscardedWhenAsked() {
    doAndBeKilled("measure");
    {
      Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")}});
      startWindow();
      QVERIFY(waitUntil([this] { return !window_->worksheets().filled().empty(); }));
      waitForRest();
    }
    const auto filled = window_->worksheets().filled();
    QCOMPARE(filled.size(), std::size_t{1});
    QCOMPARE(filled[0]->package().id, std::string(kPackage));
    const auto values = filled[0]->of("AORTA", "");
    QCOMPARE(values.size(), std::size_t{1});
    QVERIFY(std::abs(values[0].value - 1.7) < 1e-9 || std::abs(values[0].value - 17.0) < 1e-9);
    QVERIFY(values[0].uncertainty > 0.0);
    QCOMPARE(window_->calipers().lines().size(), std::size_t{1});
    QVERIFY2(window_->calipers().drawingIn(Where::image).shown().all.size() == 1, "on its image");
    // Killed again without a decision, it would be offered again; discarded, it goes.
    {
      Answers answers({{QStringLiteral("unsavedWorksheetQuestion"), press(QMessageBox::Discard)},
                       {QStringLiteral("unsavedMeasurementsQuestion"), press(QMessageBox::Discard)}});
      QVERIFY(window_->close());
    }
    QCOMPARE(left(data()), std::size_t{0});
    doAndBeKilled("measure");
    {
      Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("discardUnsaved")}});
      startWindow();
      QVERIFY(waitUntil([&] { return !answers.asked.isEmpty(); }));
      waitForRest();
    }
    QVERIFY(window_->worksheets().filled().empty());
    QCOMPARE(left(data()), std::size_t{0});
  }

  void aVolumeThatWasMadeOutlivesAKill() {
    QVERIFY(!files_.writeSweep(QStringLiteral("made.igs.mha")).isEmpty());
    doAndBeKilled("volume");
    {
      Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")}});
      startWindow();
      QVERIFY(waitUntil([&] { return !answers.asked.isEmpty(); }));
      // The case is opened first, and then gives way to the volume.
      QVERIFY(waitUntil(
          [this] { return session().subject() && QString::fromStdString(session().subject()->title).startsWith(QLatin1String("made")); }));
      waitForRest();
      QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedWorkQuestion")});
    }
    QVERIFY(session().subject().has_value());
    QVERIFY2(QString::fromStdString(session().subject()->title).startsWith(QLatin1String("made")), session().subject()->title.c_str());
    Answers answers({{QStringLiteral("unsavedVolumeQuestion"), press(QMessageBox::Discard)}});
    QVERIFY(window_->close());
    QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedVolumeQuestion")});
    QCOMPARE(left(data()), std::size_t{0});
  }

  void whatWasOfAnotherPatientIsNotPutOnTheCaseThatIsOpen() {
    leaveRecording("stitched", {}, 6);
    QSettings().setValue(QStringLiteral("open/last"), case_);
    for (int start = 0; start < 2; ++start) {  // and is offered as often as somebody asks
      {
        Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")}});
        startWindow();
        QVERIFY(waitUntil([this] { return framesHere() > 0 || wasSaid("'stitched' lies in no file"); }));
        waitForRest();
      }
      QVERIFY(window_->document().current());
      QCOMPARE(framesHere(), std::size_t{0});
      QVERIFY(!session().isPlaying());
      closeWithoutSaving();
      QVERIFY(isLeft("stitched"));
    }
  }

  void whatLiesInNoFileCanStillBeSaved() {
    leaveRecording("stitched", {}, 6);
    QSettings().setValue(QStringLiteral("open/last"), case_);
    const QString file = files_.path(QStringLiteral("rescued.seq.mha"));
    Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")}, {QStringLiteral("fileDialog"), type(file)}});
    startWindow();
    const auto offered = [this]() -> QPushButton* {
      for (QPushButton* each : window_->messages().findChildren<QPushButton*>())
        if (each->isVisible() && each->text() == Resuming::tr("Save recording as…")) return each;
      return nullptr;
    };
    QVERIFY(waitUntil([&] { return offered() != nullptr; }));
    waitForRest();
    QVERIFY(offered());
    QTest::mouseClick(offered(), Qt::LeftButton);
    QVERIFY(waitUntil([&] { return QFile::exists(file) && !isLeft("stitched"); }));
    waitForRest();
    closeWithoutSaving();
  }

  void aRecordingComesBackWithItsOwnVolumeAlone() {
    leaveRecording("made", {}, 6, test::waves());
    leaveRecording("earlier", case_, 4);  // is gone on with first, so that the volume has to ask
    const std::filesystem::path folder = (data() + QStringLiteral("/echoweave/unsaved-work/made")).toStdString();
    for (const auto& item : std::filesystem::directory_iterator(folder))
      std::filesystem::last_write_time(item.path(), std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    QSettings().setValue(QStringLiteral("open/last"), case_);
    {
      Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")},
                       {QStringLiteral("unsavedRecordingQuestion"), press(QMessageBox::Cancel)}});
      startWindow();
      QVERIFY(waitUntil([&] { return answers.asked.contains(QStringLiteral("unsavedRecordingQuestion")); }));
      waitForRest();
      QTest::qWait(300);
    }
    QCOMPARE(framesHere(), std::size_t{4});
    QVERIFY(isLeft("made"));
    QVERIFY(wasSaid("comes back when it is shown"));
    {
      Answers answers({{QStringLiteral("unsavedRecordingQuestion"), press(QMessageBox::Discard)}});
      const auto actions = window_->findChildren<QAction*>();
      const auto show = std::find_if(actions.begin(), actions.end(), [](const QAction* each) {
        return each->text() == UnsavedVolumes::tr("Show the volume made from %1").arg(QStringLiteral("made"));
      });
      QVERIFY(show != actions.end());
      (*show)->trigger();
      QVERIFY(waitUntil([this] { return framesHere() == 6; }));
      QVERIFY(session().subject() && session().subject()->title == "made");
      QVERIFY(waitUntil([this] { return !isLeft("made"); }));
      waitForRest();
    }
    closeWithoutSaving();
  }

  void theSecondOfTwoRecordingsDoesNotTakeTheFirstOnesPlace() {
    leaveRecording("one", case_, 5);
    leaveRecording("two", case_, 7);
    QSettings().setValue(QStringLiteral("open/last"), case_);
    {
      Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")}});
      startWindow();
      QVERIFY(waitUntil([&] { return answers.asked.size() == 2; }));
      QVERIFY(waitUntil([this] { return framesHere() > 0 && isLeft("one") != isLeft("two"); }));
      waitForRest();
      QTest::qWait(300);
    }
    const std::size_t first = framesHere();
    QVERIFY2(isLeft(first == 5 ? "two" : "one") && !isLeft(first == 5 ? "one" : "two"), "what is here has gone there, and nothing else");
    QVERIFY(wasSaid(first == 5 ? "what was not saved of 'two' before is kept" : "what was not saved of 'one' before is kept"));
    closeWithoutSaving();
    {
      Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")}});
      startWindow();
      QVERIFY(waitUntil([&] { return framesHere() == 12 - first; }));
      waitForRest();
      QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedWorkQuestion")});
    }
    closeWithoutSaving();
    QCOMPARE(left(data()), std::size_t{0});
  }

  void aFileThatAsksIsGoneOnWithOnceItIsAnswered() {
    const QString file = files_.path(QStringLiteral("two.nii"));
    QVERIFY(writeFileSafely(file.toStdString(), twoInOneFile()).has_value());
    leaveRecording("asking", file, 6);
    QSettings().setValue(QStringLiteral("open/last"), QString());
    {
      Answers answers({{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")},
                       {QStringLiteral("fileImportDialog"), [](QWidget& dialog) { qobject_cast<QDialog*>(&dialog)->reject(); }}});
      startWindow();
      QVERIFY(waitUntil([&] { return answers.asked.contains(QStringLiteral("fileImportDialog")); }));
      waitForRest();
      QTest::qWait(300);
    }
    QVERIFY(wasSaid("two.nii' was not opened, so what was not saved of it is kept"));
    closeWithoutSaving();
    QVERIFY(isLeft("asking"));
    {
      Answers answers(
          {{QStringLiteral("unsavedWorkQuestion"), press("goOnUnsaved")}, {QStringLiteral("fileImportDialog"), [](QWidget&) {}}});
      startWindow();
      QVERIFY(waitUntil([&] { return answers.asked.contains(QStringLiteral("fileImportDialog")); }));
      auto* dialog = find<QDialog>("fileImportDialog");
      QVERIFY(dialog);
      auto* number = dialog->findChild<QSpinBox*>(QStringLiteral("timeStep"));
      QVERIFY(waitUntil([&] { return number->maximum() == 2; }));
      QTest::qWait(300);
      QVERIFY2(!wasSaid("is kept and offered at the next start"), "while the dialog stands there");
      number->setValue(2);
      dialog->findChild<QPushButton*>(QStringLiteral("importFile"))->click();
      QVERIFY(waitUntil([this] { return framesHere() == 6; }));
      QVERIFY(waitUntil([this] { return !isLeft("asking"); }));
      waitForRest();
      QVERIFY(!wasSaid("is kept and offered at the next start"));
    }
    closeWithoutSaving();
    QCOMPARE(left(data()), std::size_t{0});
  }

  void aStartGoesOnWhereOneWas() {
    showWindowWithCase(case_);
    QVERIFY(window_->close());
    window_.reset();
    startWindow();
    waitForRest();
    QVERIFY(window_->document().current());
    QCOMPARE(QString::fromStdString(window_->document().current()->folder.string()), case_);
    window_->showStartPage();
    QVERIFY(window_->close());
    window_.reset();
    startWindow();
    waitForRest();
    QVERIFY(!window_->document().current());
    QVERIFY(window_->findChild<StartPage*>()->isVisible());
    // What could not be opened, because the program died of it, is not tried again.
    QSettings().setValue(QStringLiteral("open/last"), case_);
    QSettings().setValue(QStringLiteral("open/opening"), case_);
    window_.reset();
    startWindow();
    waitForRest();
    QVERIFY(!window_->document().current());
  }
};

}  // namespace ew::ui::testing

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(ew::ui::testing::windowFormat());
  QApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("EchoWeave"));
  QApplication::setApplicationName(QStringLiteral("EchoWeave tests"));
  if (qEnvironmentVariableIsSet(ew::ui::testing::kAsWindow)) return ew::ui::testing::runAsWindow();
  ew::ui::testing::KeepingTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "keeping_test.moc"
