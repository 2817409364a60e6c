// A frozen scan is looked through: back and on, in a loop, between marks, and what runs is saved.
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QThread>
#include <QWheelEvent>
#include <set>

#include "ew/ui_test_door/cine.h"
#include "ew/widgets/time_line.h"
#include "gui/support/answers.h"
#include "gui/support/console_fixture.h"

namespace ew::ui::testing {

class CineTest : public ConsoleFixture {
  Q_OBJECT

 private:
  struct Seen {
    std::vector<std::uint8_t> pixels;
    ScanState state;
  };
  std::vector<Seen> seen_;  ///< live, image by image
  QMetaObject::Connection look_;

  [[nodiscard]] CineBar& bar() const { return window_->cineBar(); }
  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(&window_->scanView(), key, modifiers);
  }
  void watchLive() {
    seen_.clear();
    look_ = connect(&session(), &Session::imageChanged, this, [this] {
      if (!session().isFrozen() && !session().isPlaying()) seen_.push_back({everythingSeen(), session().shownState()});
    });
  }
  /// Image and, where there is one, strip.
  [[nodiscard]] std::vector<std::uint8_t> everythingSeen() const {
    std::vector<std::uint8_t> pixels = pixelsOf(session());
    const ImageView<const std::uint8_t> strip = session().seen().strip();
    for (int y = 0; y < strip.height; ++y) pixels.insert(pixels.end(), strip.row(y), strip.row(y) + strip.width);
    return pixels;
  }
  /// Slides and tilts, with noise.
  void scanForAWhile(int frames) const {
    for (int n = 0; n < frames; ++n) {
      session().probeControl().setHold(turned(session().probeControl().hold(), 0.01, 0.0, n % 2 == 0 ? 0.02 : 0.01));
      session().makeImageNow();
      QTest::qWait(2);
    }
  }
  void scanAndFreeze(int frames) {
    session().setFrozen(true);
    session().setFrozen(false);
    watchLive();
    scanForAWhile(frames);
    pressKey(Qt::Key_F);
    QVERIFY(session().isFrozen() && bar().isOpen());
    QCOMPARE(session().cineLoop().ring().frameCount(), seen_.size());
  }
  /// What was seen live when the n-th image of the ring was.
  [[nodiscard]] const Seen& seenAt(std::size_t n) const { return seen_[seen_.size() - session().cineLoop().ring().frameCount() + n]; }
  void comparesWithWhatWasSeen() const {
    QVERIFY(waitUntil([this] { return !session().cineLoop().isForming(); }));
    const Seen& was = seenAt(bar().review().frame());
    QVERIFY(session().shownState() == was.state);
    QVERIFY2(everythingSeen() == was.pixels, qPrintable(QStringLiteral("image %1").arg(bar().review().frame())));
  }

 private Q_SLOTS:
  void init() {
    openConsole();
    pressEffect("noise");
    session().makeImageNow();
  }
  void cleanup() {
    disconnect(look_);
    const Answers discard({{QStringLiteral("unsavedRecordingQuestion"), ew::ui::testing::press(QMessageBox::Discard)}});
    window_.reset();
  }

  void aFrozenScanIsSteppedThroughPixelForPixel() {
    QVERIFY(!bar().isOpen() && !bar().isVisible());
    const QSize before(session().image().width(), session().image().height());
    scanAndFreeze(30);
    QVERIFY(bar().isVisible() && !find<QLabel>("position")->isVisible());
    QTest::qWait(50);
    QCOMPARE(QSize(session().image().width(), session().image().height()), before);
    const std::size_t last = session().cineLoop().ring().frameCount() - 1;
    QCOMPARE(bar().review().frame(), last);
    QCOMPARE(everythingSeen(), seenAt(last).pixels);
    for (int n = 0; n < 12; ++n) {
      pressKey(n % 2 == 0 ? Qt::Key_Left : Qt::Key_Comma);
      QCOMPARE(bar().review().frame(), last - 1 - static_cast<std::size_t>(n));
      comparesWithWhatWasSeen();
    }
    QVERIFY2(session().imagePose() == session().shownState().pose, "the body shows where the probe was");
    pressKey(Qt::Key_Right);
    pressKey(Qt::Key_Period);
    QCOMPARE(bar().review().frame(), last - 10);
    comparesWithWhatWasSeen();
    pressKey(Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(bar().review().frame(), last - 20);
    comparesWithWhatWasSeen();
    pressKey(Qt::Key_Home);
    QCOMPARE(bar().review().frame(), std::size_t{0});
    comparesWithWhatWasSeen();
    pressKey(Qt::Key_End);
    QCOMPARE(bar().review().frame(), last);
    comparesWithWhatWasSeen();
    find<QPushButton>("cineBack")->click();
    QCOMPARE(bar().review().frame(), last - 1);
    comparesWithWhatWasSeen();
  }

  void persistenceAndMModeShowWhatTheyShowed() {
    slide("persistence", 80);
    press("modeBoth");
    session().makeImageNow();
    QTest::qWait(50);
    scanAndFreeze(40);
    const std::size_t last = session().cineLoop().ring().frameCount() - 1;
    for (const std::size_t frame : {last - 1, last - 2, last - 30, last - 29, last - 5, last}) {
      bar().goTo(frame);
      comparesWithWhatWasSeen();
    }
  }

  void theWheelAndTheTimeLineGoThroughTheImages() {
    scanAndFreeze(30);
    const std::size_t last = session().cineLoop().ring().frameCount() - 1;
    const auto wheel = [this](int notches) {
      const QPointF middle(window_->scanView().rect().center());
      QWheelEvent event(middle, window_->scanView().mapToGlobal(middle.toPoint()), {}, {0, notches * 120}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&window_->scanView(), &event);
    };
    const Hold before = session().probeControl().hold();
    wheel(3);
    QCOMPARE(bar().review().frame(), last - 3);
    wheel(-1);
    QCOMPARE(bar().review().frame(), last - 2);
    QVERIFY2(session().probeControl().hold() == before, "the probe rests");
    comparesWithWhatWasSeen();
    auto* line = find<TimeLine>("cineLine");
    QTest::mouseClick(line, Qt::LeftButton, Qt::NoModifier, QPoint(line->width() / 2, line->height() / 2));
    const double middle_s = session().cineLoop().ring().frameTime_s(0) + 0.5 * session().cineLoop().ring().length_s();
    QVERIFY(std::abs(session().shownState().time_s - middle_s) < 0.1 * session().cineLoop().ring().length_s());
    comparesWithWhatWasSeen();
    const std::size_t here = bar().review().frame();
    QTest::keyClick(line, Qt::Key_Left);
    QCOMPARE(bar().review().frame(), here - 1);
  }

  void itPlaysInALoopBetweenTheMarks() {
    scanAndFreeze(30);
    const std::size_t last = session().cineLoop().ring().frameCount() - 1;
    pressKey(Qt::Key_Left, Qt::ShiftModifier);
    pressKey(Qt::Key_O, Qt::ShiftModifier);
    pressKey(Qt::Key_Left, Qt::ShiftModifier);
    pressKey(Qt::Key_I, Qt::ShiftModifier);
    QCOMPARE(bar().review().in(), last - 20);
    QCOMPARE(bar().review().out(), last - 10);
    find<QComboBox>("cineSpeed")->setCurrentIndex(3);
    std::set<std::size_t> shown;
    bool began = false;
    std::size_t before = bar().review().frame();
    pressKey(Qt::Key_C);
    QVERIFY(bar().isPlaying());
    QVERIFY(waitUntil([&] {
      const std::size_t now = bar().review().frame();
      shown.insert(now);
      began = began || now < before;
      before = now;
      return began && shown.size() > 2;
    }));
    QVERIFY(*shown.begin() >= last - 20 && *shown.rbegin() <= last - 10);
    pressKey(Qt::Key_C);
    QVERIFY(!bar().isPlaying());
    comparesWithWhatWasSeen();
    // Frozen, C plays; running, it lets the patient breathe.
    pressKey(Qt::Key_C);
    pressKey(Qt::Key_Space);
    QVERIFY(!session().isFrozen() && !bar().isPlaying() && !bar().isOpen());
    pressKey(Qt::Key_C);
    QVERIFY(!bar().isPlaying());
  }

  void whatRunsIsSavedAndPlaysAgain() {
    scanAndFreeze(30);
    const std::size_t last = session().cineLoop().ring().frameCount() - 1;
    bar().goTo(last - 4);
    find<QPushButton>("cineOut")->click();
    bar().goTo(last - 14);
    find<QPushButton>("cineIn")->click();
    const QString file = files_.path(QStringLiteral("clip.seq.mha"));
    {
      const Answers save({{QStringLiteral("fileDialog"), type(file)}});
      find<QPushButton>("cineSave")->click();
    }
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning() && QFile::exists(file); }));
    QVERIFY(session().isFrozen() && bar().isOpen());
    const auto saved = readRecording(file.toStdString());
    QVERIFY(saved.has_value());
    QCOMPARE(saved->caseId, std::string("window-test"));
    QCOMPARE(saved->log.frameCount(), std::size_t{11});
    QVERIFY(saved->log.frame(0) == seenAt(last - 14).state);
    const std::vector<std::uint8_t> first = seenAt(last - 14).pixels;
    const double scanned_s = session().frames().now_s();
    window_->open(file);
    QVERIFY(waitUntil([this] { return window_->replayBar().recording() != nullptr && window_->isSettled(); }));
    QVERIFY2(!bar().isOpen() && !session().isFrozen(), "a recording takes the place of the frozen scan");
    window_->replayBar().unload();
    session().makeImageNow();
    pressKey(Qt::Key_F);
    QVERIFY2(session().cineLoop().ring().frameTime_s(0) > scanned_s, "the scan before the recording is another one");
  }

  void letRunItBeginsAnewAndSoDoesAnotherCase() {
    scanAndFreeze(20);
    bar().goTo(3);
    pressKey(Qt::Key_F);
    QVERIFY(!session().isFrozen() && !bar().isOpen());
    QVERIFY(find<QLabel>("position")->isVisible());
    session().makeImageNow();
    QVERIFY2(session().imagePose() == session().probeControl().pose(), "the scan runs where the hand is");
    seen_.clear();
    scanForAWhile(8);
    pressKey(Qt::Key_F);
    QVERIFY(bar().isOpen());
    QCOMPARE(session().cineLoop().ring().frameCount(), seen_.size() + 1);
    bar().goTo(session().cineLoop().ring().frameCount() - 5);
    comparesWithWhatWasSeen();
    const double before_s = session().frames().now_s();
    QVERIFY(openCase(files_.writeCase(QStringLiteral("next"))));
    QVERIFY(!session().isFrozen() && !bar().isOpen());
    session().makeImageNow();
    QVERIFY(session().cineLoop().ring().frameTime_s(0) > before_s);
  }

  void whatWasScannedStaysWhereItWasWhenTheVolumeIsMoved() {
    scanAndFreeze(20);
    bar().goTo(5);
    const std::vector<std::uint8_t> held = everythingSeen();
    Transform<frame::World, frame::World> moved;
    moved.matrix[3] = {5.0, 0.0, 0.0, 1.0};
    session().place(moved);
    QTest::qWait(30);
    QVERIFY2(session().isFrozen() && !bar().isOpen(), "there is nothing to look through any more");
    QCOMPARE(everythingSeen(), held);
    pressKey(Qt::Key_Left);
    QVERIFY(window_->scanView().said().contains(QLatin1String("frozen")));
  }

  void settingsAreRefusedWithAWordWhileFrozen() {
    scanAndFreeze(10);
    const Knobs held = knobs();
    const Scene heldScene = scene();
    auto* depth = find<QSlider>("depth");
    const int was = depth->value();
    QVERIFY(window_->scanView().said().isEmpty());
    pressKey(Qt::Key_PageDown);
    QVERIFY(knobs() == held);
    QCOMPARE(depth->value(), was);
    QVERIFY2(window_->scanView().said().contains(QLatin1String("frozen")), qPrintable(window_->scanView().said()));
    pressEffect("noise");
    QVERIFY(scene() == heldScene);
    QVERIFY(find<QAbstractButton>(qPrintable(ConsolePanel::switchOf("noise")))->isChecked());
    find<QSlider>("dgc3")->setValue(150);
    QVERIFY(knobs() == held);
    QCOMPARE(find<QSlider>("dgc3")->value(), 100);
    pressKey(Qt::Key_F);
    pressKey(Qt::Key_PageDown);
    QVERIFY(depth->value() > was);
  }

  void anotherSizeOfTheWindowShowsTheSameImage() {
    scanAndFreeze(20);
    bar().goTo(7);
    comparesWithWhatWasSeen();
    const Seen was = seenAt(7);
    window_->resize(1100, 680);
    QTest::qWait(50);
    QVERIFY(session().shownState() == was.state);
    QVERIFY(everythingSeen().size() != was.pixels.size());
    window_->resize(1280, 720);
    QVERIFY(waitUntil([&] { return everythingSeen().size() == was.pixels.size(); }));
    QCOMPARE(everythingSeen(), was.pixels);
  }

  void aSmallWindowStaysSmallWhileSomethingIsAtWorkBehindIt() {
    for (int n = 0; n < 2; ++n)
      window_->jobs().start(QStringLiteral("Counting what is there"),
                            [](Progress& progress) -> Result<void> {
                              while (!progress.cancelRequested()) QThread::msleep(1);
                              return failure(ErrorCode::cancelled, verbatim("It was stopped."));
                            },
                            {});
    const QSize small(1024, 640);
    window_->resize(small);
    QVERIFY(waitUntil([this] { return find<QWidget>("jobsLine")->isVisible(); }));
    QCOMPARE(window_->size(), small);
    scanAndFreeze(20);
    QVERIFY(bar().isVisible());
    QCoreApplication::processEvents();
    QCOMPARE(window_->size(), small);
    window_->jobs().cancelAllAndWait();
    window_->resize(1280, 720);
  }

  void itLooksAsItShould() {
    scanAndFreeze(40);
    pressKey(Qt::Key_Left, Qt::ShiftModifier);
    bar().markOut();
    pressKey(Qt::Key_Left, Qt::ShiftModifier);
    pressKey(Qt::Key_Left, Qt::ShiftModifier);
    bar().markIn();
    bar().step(8);
    for (const QSize size : {QSize(1280, 720), QSize(1024, 640)}) {
      window_->resize(size);
      QTest::qWait(50);
      for (const bool dark : {true, false}) {
        window_->setDarkTheme(dark);
        QTest::qWait(20);
        const QRect mine = bar().rect();
        for (const QWidget* each : bar().findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
          QVERIFY2(mine.contains(each->geometry()), qPrintable(each->objectName()));
          QVERIFY2(each->width() >= each->minimumSizeHint().width(), qPrintable(each->objectName()));
        }
        QVERIFY(find<TimeLine>("cineLine")->width() > 160);
        if (qEnvironmentVariableIsSet("EW_CINE_PICTURES"))
          window_->grab().save(QStringLiteral("%1/cine-%2-%3.png")
                                   .arg(qEnvironmentVariable("EW_CINE_PICTURES"))
                                   .arg(size.width())
                                   .arg(dark ? QStringLiteral("dark") : QStringLiteral("light")));
      }
    }
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::CineTest)

#include "cine_test.moc"
