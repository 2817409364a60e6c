// A scan is recorded, played, saved and opened again, and asked about when it would be lost.
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QPushButton>
#include <QSignalSpy>

#include "ew/library/case.h"
#include "ew/scanning/replay.h"
#include "ew/ui_test_door/cine.h"
#include "ew/widgets/time_line.h"
#include "gui/support/answers.h"
#include "gui/support/case_aside.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class RecordingTest : public WindowFixture {
  Q_OBJECT

 private:
  QString folder_;

  [[nodiscard]] ReplayBar& bar() const { return window_->replayBar(); }
  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const { QTest::keyClick(window_.get(), key, modifiers); }
  void toggleRecording() const { pressKey(Qt::Key_R, Qt::ControlModifier); }

  /// The first Escape takes away what the window says, the next one closes the recording.
  void closeByEscape() const {
    while (window_->messages().count() > 0) pressKey(Qt::Key_Escape);
    pressKey(Qt::Key_Escape);
  }

  struct Seen {
    QSize size;
    std::vector<std::vector<std::uint8_t>> images;
  };
  /// Slides, changes the gain, the persistence and the probe's tilt; what was seen, image by image.
  Seen scanForAWhile() const {
    Seen seen;
    const auto look = connect(&session(), &Session::imageChanged, this, [&] {
      if (session().isFrozen() || !window_->recorder().isRecording()) return;
      seen.size = {session().image().width(), session().image().height()};
      seen.images.push_back(pixelsOf(session()));
    });
    for (int n = 0; n < 24; ++n) {
      session().probeControl().setHold(turned(session().probeControl().hold(), 0.01, 0.0, n % 2 == 0 ? 0.02 : 0.01));
      Knobs knobs = session().console().knobs();
      if (n % 5 == 0) knobs.gain = 0.8 + 0.05 * n;
      if (n == 8) knobs.persistence = 0.5;
      session().console().setKnobs(knobs);
      session().makeImageNow();
    }
    disconnect(look);
    return seen;
  }
  /// What a scan of a while leaves: a recording in the bar.
  Seen record() const {
    toggleRecording();
    const Seen seen = scanForAWhile();
    toggleRecording();
    return seen;
  }

 private Q_SLOTS:
  void init() {
    folder_ = files_.writeCase(QStringLiteral("case"));
    showWindowWithCase(folder_);
  }
  void cleanup() {
    const Answers discard({{QStringLiteral("unsavedRecordingQuestion"), press(QMessageBox::Discard)}});
    window_.reset();
  }

  void whatWasSeenIsRecordedAndComesAgainPixelForPixel() {
    toggleRecording();
    QVERIFY(window_->recorder().isRecording());
    const Seen seen = scanForAWhile();
    QVERIFY(seen.images.size() >= 24);
    pressKey(Qt::Key_K);
    toggleRecording();
    QVERIFY(!window_->recorder().isRecording());
    QVERIFY(bar().isVisible());
    const auto recording = bar().recording();
    QCOMPARE(recording->caseId, std::string("window-test"));
    QCOMPARE(recording->log.frameCount(), seen.images.size());
    QVERIFY(std::holds_alternative<Note>(recording->log.events().back().what));
    Replay replay(recording->log, *session().subject(), 2);
    for (std::size_t n = 0; n < seen.images.size(); ++n) {
      const ImageView<const std::uint8_t> again = replay.make(n, seen.size.width(), seen.size.height()).grey;
      for (int y = 0; y < again.height; ++y)
        QVERIFY2(std::equal(again.row(y), again.row(y) + again.width, seen.images[n].data() + std::ptrdiff_t{y} * again.width),
                 qPrintable(QStringLiteral("image %1, row %2").arg(n).arg(y)));
    }
  }

  void aRecordingIsPlayedWhileHandAndConsoleRest() {
    toggleRecording();
    scanForAWhile();
    const Hold after = session().probeControl().hold();
    const Knobs knobsAfter = session().console().knobs();
    toggleRecording();
    QVERIFY(session().isPlaying() && !bar().isPlaying());
    // At rest on the first image: the console shows what was set then, and the probe stands where it stood.
    session().makeImageNow();
    QCOMPARE(session().console().knobs().persistence, 0.0);
    QVERIFY(session().imagePose() == bar().recording()->log.frame(0).pose);
    QVERIFY(!window_->console().isEnabled());
    pressKey(Qt::Key_Left);
    QVERIFY(session().probeControl().hold() == after);
    QVERIFY(!window_->scanView().said().isEmpty());

    find<QComboBox>("replaySpeed")->setCurrentIndex(4);
    pressKey(Qt::Key_Space);
    QVERIFY(bar().isPlaying());
    QVERIFY(waitUntil([this] { return !bar().isPlaying(); }));
    QCOMPARE(bar().position_s(), bar().length_s());
    session().makeImageNow();
    QVERIFY(session().imagePose() == bar().recording()->log.frame(bar().recording()->log.frameCount() - 1).pose);
    QCOMPARE(session().console().knobs().persistence, 0.5);

    find<QPushButton>("replayLoop")->setChecked(true);
    pressKey(Qt::Key_Space);
    bool began = false;
    QVERIFY(waitUntil([&] {
      began = began || bar().position_s() < 0.5 * bar().length_s();
      return began && bar().position_s() > 0.0;
    }));
    QVERIFY(bar().isPlaying());
    pressKey(Qt::Key_Space);

    const Answers discard({{QStringLiteral("unsavedRecordingQuestion"), press(QMessageBox::Discard)}});
    closeByEscape();
    QVERIFY(bar().recording() == nullptr);
    QVERIFY(!bar().isVisible() && !session().isPlaying());
    QVERIFY2(session().probeControl().hold() == after && session().console().knobs() == knobsAfter, "as they were before it was played");
    QVERIFY(window_->console().isEnabled());
    pressKey(Qt::Key_Left);
    QVERIFY(!(session().probeControl().hold() == after));
  }

  void theTimeLineGoesWhereItIsClicked() {
    record();
    auto* line = find<TimeLine>("replayLine");
    QTest::mouseClick(line, Qt::LeftButton, Qt::NoModifier, QPoint(line->width() / 2, line->height() / 2));
    QVERIFY(std::abs(bar().position_s() - 0.5 * bar().length_s()) < 0.02 * bar().length_s());
    const ScanLog& log = bar().recording()->log;
    const ScanState shown = log.frame(log.frameAt(log.frameTime_s(0) + bar().position_s()));
    session().makeImageNow();
    QVERIFY(session().shownState() == shown);
    QTest::keyClick(line, Qt::Key_End);
    QCOMPARE(bar().position_s(), bar().length_s());
    QTest::keyClick(line, Qt::Key_Home);
    QCOMPARE(bar().position_s(), 0.0);
  }

  void aNameIsProposedWhereTheLastOneOfItsKindWasSaved() {
    record();
    const QString title = QString::fromStdString(bar().recording()->title);
    const auto proposed = [this](const QString& typed) {
      QString name, folder;
      const Answers look({{QStringLiteral("fileDialog"), [&](QWidget& dialog) {
                             auto& files = dynamic_cast<QFileDialog&>(dialog);
                             name = files.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->text();
                             folder = files.directory().absolutePath();
                             if (typed.isEmpty()) return files.reject();
                             type(typed)(dialog);
                           }}});
      find<QPushButton>("replaySave")->click();
      return std::pair(name, folder);
    };
    const auto first = proposed(QString());
    QVERIFY2(first.first.startsWith(title + QLatin1Char(' ') + QDate::currentDate().toString(QStringLiteral("yyyy-"))),
             qPrintable(first.first));
    QVERIFY2(first.second != QDir::currentPath(), "where the program was started says nothing");
    const QString file = files_.path(QStringLiteral("proposed.seq.mha"));
    proposed(file);
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning() && QFile::exists(file); }));
    closeByEscape();
    record();
    QCOMPARE(proposed(QString()).second, QFileInfo(file).absolutePath());
  }

  void aSavedRecordingIsOpenedAgainAndItsCaseWithIt() {
    record();
    const auto recorded = bar().recording();
    const QString file = files_.path(QStringLiteral("mine.seq.mha"));
    {
      const Answers save({{QStringLiteral("fileDialog"), type(file)}});
      find<QPushButton>("replaySave")->click();
    }
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning() && QFile::exists(file); }));
    QVERIFY2(!find<QPushButton>("replaySave")->isEnabled(), "there is nothing left to save");
    closeByEscape();
    QVERIFY(bar().recording() == nullptr);
    window_->open(file);
    QVERIFY(waitUntil([this] { return bar().recording() != nullptr && window_->isSettled(); }));
    QVERIFY(bar().recording()->log.events() == recorded->log.events());
    QVERIFY(!window_->messages().isError());
  }

  void aRecordingOfAnotherCaseOfTheLibraryOpensThatAndPlays() {
    const QString place = files_.writeCase(QStringLiteral("own cases/another"));
    auto another = loadCaseAside(place.toStdString());
    QVERIFY(another.has_value());
    another->id = "another-case";
    QVERIFY(saveCase(*another, place.toStdString()).has_value());
    ScanRecording other;
    other.caseId = "another-case";
    other.title = "Another case";
    other.log.addFrame(session().shownState());
    const QString file = files_.path(QStringLiteral("another.seq.mha"));
    QVERIFY(writeRecording(other, file.toStdString()).has_value());
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    window_->open(file);
    QVERIFY(waitUntil([this] { return window_->document().current()->id == "another-case" && window_->isSettled(); }));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QVERIFY(bar().recording() != nullptr);
    QCOMPARE(bar().recording()->caseId, std::string("another-case"));
    QVERIFY(QDir(place).removeRecursively());  // the other tests have the library for themselves
  }

  void aRecordingOfSomethingElseSaysWhatToOpenFirst() {
    ScanRecording other;
    other.caseId = "unknown-case";
    other.title = "Another case";
    other.log.addFrame(session().shownState());
    const QString file = files_.path(QStringLiteral("other.seq.mha"));
    QVERIFY(writeRecording(other, file.toStdString()).has_value());
    window_->open(file);
    QVERIFY(waitUntil([this] { return window_->messages().isError(); }));
    QVERIFY2(window_->messages().text().contains(QLatin1String("Another case")), qPrintable(window_->messages().text()));
    QVERIFY(bar().recording() == nullptr && session().subject());
  }

  void itIsAskedAboutWhenItWouldBeLost() {
    record();
    const auto kept = bar().recording();
    for (const bool closes : {true, false}) {
      const Answers stay({{QStringLiteral("unsavedRecordingQuestion"), press(QMessageBox::Cancel)}});
      if (closes) {
        QVERIFY(!window_->close());
      } else {
        QApplication::setActiveWindow(window_.get());  // the test screen has no window manager that gives it back after a question
        toggleRecording();
      }
      QVERIFY2(stay.asked == QStringList{QStringLiteral("unsavedRecordingQuestion")}, closes ? "when closing" : "when beginning another");
      QVERIFY(bar().recording() == kept && !window_->recorder().isRecording());
    }
    const QString next = files_.writeCase(QStringLiteral("next"));
    Answers discard({{QStringLiteral("unsavedRecordingQuestion"), press(QMessageBox::Discard)}});
    window_->open(next);
    QVERIFY(waitUntil([&] { return !discard.asked.isEmpty() && window_->isSettled(); }));
    QVERIFY(bar().recording() == nullptr);
  }

  void freezingIsAPartOfTheRecording() {
    toggleRecording();
    scanForAWhile();
    pressKey(Qt::Key_Space);
    QVERIFY(session().isFrozen());
    const double frozen_s = session().frames().now_s();
    QTest::qWait(50);
    pressKey(Qt::Key_Space);
    QVERIFY(!session().isFrozen());
    session().makeImageNow();
    toggleRecording();
    QVERIFY(bar().recording()->log.isFrozenAt(frozen_s + 0.02));
    QVERIFY(!bar().recording()->log.isFrozenAt(bar().recording()->log.end_s()));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::RecordingTest)

#include "recording_test.moc"
