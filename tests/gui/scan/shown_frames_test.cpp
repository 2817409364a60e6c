#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ew/ui_test_door/scan.h"
#include "gui/support/console_fixture.h"
#include "scanning/small_scan.h"

namespace ew::ui::testing {

/// Which frames the window makes and shows: the same pixels however the volume lies in memory, coarser ones only while the probe moves
/// fast, none that nobody sees; and what is drawn around the image follows the image.
class ShownFramesTest : public ConsoleFixture {
  Q_OBJECT

 private:
  /// Every frame of a probe that moves at all counts as slow, whatever the machine.
  [[nodiscard]] static AdaptiveQuality::Options strict() {
    AdaptiveQuality::Options options;
    options.budget_ms = 0.0;
    options.fast_mmPerS = 0.01;
    return options;
  }
  /// Whether no more frames come: those that were due may come late.
  [[nodiscard]] bool comesToRest() const {
    std::uint64_t frames = session().frames().framesMade();
    return waitUntil([&] {
      QTest::qWait(200);
      return std::exchange(frames, session().frames().framesMade()) == frames;
    });
  }

 private Q_SLOTS:
  void init() { openConsole(); }
  void cleanup() { window_.reset(); }

  void theBricksOfAVolumeShowTheVolumesOwnPixels() {
    const ScanSubject plain = *session().subject();
    QVERIFY2(plain.voxels.bricks() == nullptr, "a small volume is sliced as it lies");
    auto made = ScanVoxels::inBricks(plain.voxels.volume(), 1);
    QVERIFY(made.has_value());
    ScanSubject bricked = plain;
    bricked.voxels = *made;
    for (const char* quality : {"qualityWeave", "qualityLinear", "qualityCubic"}) {
      if (!find<QPushButton>(quality)->isChecked()) press(quality);
      session().show(bricked);
      session().makeImageNow();
      const std::vector<std::uint8_t> ofBricks = pixelsOf(session());
      session().show(plain);
      session().makeImageNow();
      QVERIFY2(pixelsOf(session()) == ofBricks, quality);
    }
  }

  void zoomingOutReadsACoarserLevelUnlessTheQualityIsWeave() {
    const ScanSubject plain = *session().subject();
    auto made = ScanVoxels::inBricks(plain.voxels.volume(), 4);
    QVERIFY(made.has_value());
    ScanSubject bricked = plain;
    bricked.voxels = *made;
    const auto shown = [this](const ScanSubject& subject, const char* quality, int width, int height) {
      if (!find<QPushButton>(quality)->isChecked()) press(quality);
      session().show(subject);
      session().setImageSize(width, height);
      session().makeImageNow();
      return pixelsOf(session());
    };
    for (const char* quality : {"qualityWeave", "qualityLinear", "qualityCubic"}) {
      QVERIFY2(shown(bricked, quality, 600, 500) == shown(plain, quality, 600, 500), quality);
      const bool same = shown(bricked, quality, 24, 20) == shown(plain, quality, 24, 20);
      QVERIFY2(same == (quality == std::string("qualityWeave")), quality);
    }
  }

  void upsideDownMovesScaleSlidersAndMarkerWithTheImage() {
    session().makeImageNow();
    QTest::qWait(30);
    const auto y = [this](const char* name) { return find<QSlider>(name)->mapTo(&window_->scanView(), QPoint(0, 10)).y(); };
    ScanView& view = window_->scanView();
    QVERIFY(y("dgc1") < y("dgc8") && view.yOfDepth(0.0) < view.yOfDepth(100.0));
    const std::vector<std::uint8_t> upright = pixelsOf(session());
    press("upsideDown");
    session().makeImageNow();
    QTest::qWait(30);
    QVERIFY(y("dgc1") > y("dgc8") && view.yOfDepth(0.0) > view.yOfDepth(100.0));
    QVERIFY(std::abs(view.depthAt_mm(view.yOfDepth(70.0)) - 70.0) < 1e-9);
    for (int i = 1; i <= 8; ++i) {
      const double depth_mm = session().geometry().depth_mm * (i - 0.5) / 8.0;
      QVERIFY(std::abs(y(qPrintable(QStringLiteral("dgc%1").arg(i))) - view.yOfDepth(depth_mm)) <= 1.5);
    }
    const std::vector<std::uint8_t> turnedOver = pixelsOf(session());
    const auto width = static_cast<std::size_t>(session().geometry().width);
    const auto height = static_cast<std::size_t>(session().geometry().height);
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t x = 0; x < width; ++x) {
        QVERIFY(std::abs(upright[row * width + x] - turnedOver[(height - 1 - row) * width + x]) <= 1);
      }
    }
  }

  void slowFramesLowerTheQualityOfAMovingProbeAndRestBringsItBack() {
    press("qualityCubic");
    session().frames().setAdaptive(true);
    session().frames().setAdaptiveOptions(strict());
    session().makeImageNow();
    // A lowered quality may be back before the next look, so each frame is looked at.
    bool fell = false;
    const auto looking = connect(&session(), &Session::imageChanged, this, [&] {
      fell = fell || (session().frames().isLowered() && session().shownState().knobs.quality != Quality::cubic);
    });
    for (int n = 0; n < 1000 && !fell; ++n) {
      Hold moved = session().probeControl().hold();
      moved.contact.point_mm.x += n % 2 == 0 ? 6.0 : -6.0;
      session().probeControl().setHold(moved);
      QTest::qWait(15);
    }
    disconnect(looking);
    QVERIFY2(fell, "the quality did not fall");
    QVERIFY(knobs().quality == Quality::cubic);
    QVERIFY2(waitUntil([this] { return !session().frames().isLowered(); }), "the quality did not come back at rest");
    QVERIFY(session().shownState().knobs.quality == Quality::cubic);
    const std::vector<std::uint8_t> refined = pixelsOf(session());
    session().frames().setAdaptive(false);
    session().makeImageNow();
    QCOMPARE(pixelsOf(session()), refined);
  }

  void aFrozenImageIsMadeInFullAndStaysAsItIs() {
    press("qualityCubic");
    pressEffect("noise");
    session().frames().setAdaptive(true);
    session().frames().setAdaptiveOptions(strict());
    for (int n = 0; n < 12; ++n) {
      Hold moved = session().probeControl().hold();
      moved.contact.point_mm.x += 6.0;
      session().probeControl().setHold(moved);
      QTest::qWait(10);
    }
    session().setFrozen(true);
    QVERIFY(session().shownState().knobs == session().imageKnobs());
    const std::vector<std::uint8_t> held = pixelsOf(session());
    const std::uint64_t frames = session().frames().framesMade();
    pressEffect("attenuation");
    QTest::qWait(200);
    QCOMPARE(pixelsOf(session()), held);
    QVERIFY2(session().frames().framesMade() == frames, "a frozen image makes no frames");
    // Another size and back gives the same pixels: the same noise, the same scene.
    const DisplayGeometry was = session().geometry();
    session().setImageSize(was.width / 2, was.height / 2);
    session().makeImageNow();
    session().setImageSize(was.width, was.height);
    session().makeImageNow();
    QCOMPARE(pixelsOf(session()), held);
  }

  void framesComeByThemselvesOnlyWhileSomethingChangesByItself() {
    QVERIFY(comesToRest());
    pressEffect("noise");
    const std::uint64_t frames = session().frames().framesMade();
    QVERIFY(waitUntil([&] { return session().frames().framesMade() > frames; }));
    const std::vector<std::uint8_t> before = pixelsOf(session());
    QVERIFY(waitUntil([&] { return session().frames().framesMade() >= frames + 4; }));
    QVERIFY2(pixelsOf(session()) != before, "noise does not move");
    pressEffect("noise");
    slide("persistence", 50);
    session().probeControl().setHold(turned(session().probeControl().hold(), 0.2, 0.0, 0.0));
    session().makeImageNow();
    QVERIFY(session().changesByItself());
    QVERIFY(waitUntil([this] { return !session().changesByItself(); }));
    QVERIFY(comesToRest());
    press("modeBoth");
    QTest::qWait(50);
    QVERIFY(session().changesByItself());
    window_->showStartPage();
    QVERIFY2(comesToRest(), "nobody watches");
  }

  void aPatientBreathesUntilAskedToHoldTheBreath() {
    ScanSubject subject = test::livingSubject();
    auto motion = std::make_shared<TissueMotion>(*subject.motion);
    motion->rhythms.pulse.reset();
    motion->rhythms.breathing->rhythm.period_s = 1.0;
    subject.motion = motion;
    subject.scene.liveEchoes.emplace();
    subject.scene.motion.emplace();
    session().show(subject);
    Hold hold;
    hold.contact.point_mm = {0.0, -29.0, 0.0};
    hold.contact.outward = {0.0, -1.0, 0.0};
    session().probeControl().setHold(hold);
    session().makeImageNow();
    const auto changes = [this] {
      const std::vector<std::uint8_t> before = pixelsOf(session());
      return waitUntil([&] { return pixelsOf(session()) != before; });
    };
    QVERIFY2(changes() && changes(), "nobody touches anything, and the patient breathes");
    QTest::keyClick(&window_->scanView(), Qt::Key_C, Qt::ShiftModifier);
    QVERIFY(session().breath().asked() == BreathingRequest::breatheInAndHold);
    QVERIFY2(comesToRest(), "who holds the breath stands still");
    QCOMPARE(session().shownState().body.breath, 1.0);
    const std::vector<std::uint8_t> breathedIn = pixelsOf(session());
    QTest::keyClick(&window_->scanView(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(session().breath().asked() == BreathingRequest::breatheOutAndHold && comesToRest());
    QCOMPARE(session().shownState().body, BodyState{});
    QVERIFY(pixelsOf(session()) != breathedIn);
    QTest::keyClick(&window_->scanView(), Qt::Key_C);
    QVERIFY(session().breath().asked() == BreathingRequest::free && changes());
    // Frozen, the body stands in the image and goes on breathing behind it.
    session().setFrozen(true);
    const std::vector<std::uint8_t> frozen = pixelsOf(session());
    const std::uint64_t frames = session().frames().framesMade();
    QTest::qWait(300);
    QVERIFY(session().frames().framesMade() == frames && pixelsOf(session()) == frozen);
    session().setFrozen(false);
    QVERIFY(changes());
    pressEffect("motion");
    QVERIFY(comesToRest());
    QCOMPARE(session().shownState().body, BodyState{});
    QVERIFY(session().breath().whyItIsNotSeen() != nullptr);
  }

  /// What is said of a breath that does not show is what the program knows: nobody said how the patient was recorded.
  void ofARecordedCaseThatSaysNothingNoBreathIsInvented() {
    QVERIFY2(!session().subject()->motion, "the case names a volume, and no word about breath");
    press("modeBoth");
    QVERIFY(waitUntil([this] { return session().seen().strip().width > 0; }));
    QVERIFY2(!window_->messages().text().contains(QStringLiteral("breath")), qPrintable(window_->messages().text()));
    for (const auto& modifiers : {Qt::KeyboardModifiers(Qt::ShiftModifier), Qt::ControlModifier | Qt::ShiftModifier}) {
      QTest::keyClick(&window_->scanView(), Qt::Key_C, modifiers);
      QCOMPARE(window_->messages().text(),
               QStringLiteral("Nothing that is scanned here moves with the breath, so the image stays as it is."));
      QVERIFY(session().breath().asked() == BreathingRequest::free);
    }
  }

  void theMModeStripFillsAndItsLineFollowsTheKnob() {
    press("modeBoth");
    QVERIFY(waitUntil([this] { return session().seen().strip().width > 0; }));
    QVERIFY(waitUntil([this] {
      const ImageView<const std::uint8_t> strip = session().seen().strip();
      for (int y = 0; y < strip.height; ++y) {
        if (std::any_of(strip.row(y), strip.row(y) + strip.width, [](std::uint8_t grey) { return grey > 0; })) return true;
      }
      return false;
    }));
    const QRect image = window_->scanView().imageRect();
    const QRect strip = window_->scanView().stripRect();
    QCOMPARE(strip.size(), image.size());
    QVERIFY(strip.top() > image.bottom());
    const int cursor = session().seen().stripCursor();
    QVERIFY(waitUntil([&] { return session().seen().stripCursor() != cursor; }));
    QVERIFY(session().frames().latency().count() < 1000);
    press("modeM");
    QTest::qWait(100);
    QCOMPARE(window_->scanView().stripRect(), window_->scanView().imageRect());
    press("modeB");
    session().makeImageNow();
    QVERIFY(window_->scanView().stripRect().isEmpty());
    QCOMPARE(session().seen().strip().width, 0);
  }

  void theStatusLineTellsThePlanAndHowLongImagesTook() {
    everythingOn();
    for (int n = 0; n < 3; ++n) {
      session().probeControl().setHold(turned(session().probeControl().hold(), 0.05, 0.0, 0.0));
      QTest::qWait(30);
    }
    QVERIFY(waitUntil([this] { return session().frames().latency().count() >= 3; }));
    QVERIFY(waitUntil([this] { return find<QLabel>("plan")->toolTip().contains(QStringLiteral("99 %")); }));
    // The line is written a moment after the image, so it may still tell the plan before.
    for (const Step& step : session().seen().plan().steps)
      QVERIFY2(waitUntil([&] { return find<QLabel>("plan")->toolTip().contains(nameOfStep(step.kind)); }), nameOf(step.kind));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::ShownFramesTest)
#include "shown_frames_test.moc"
