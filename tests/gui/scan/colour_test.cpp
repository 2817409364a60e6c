// Colour Doppler in the window: its page of the console, the box that is dragged in the image, and the bar beside it.
#include <QCheckBox>
#include <QDateTime>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTranslator>
#include <algorithm>
#include <cmath>

#include "ew/ui_test_door/colour.h"
#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/measure.h"
#include "gui/support/doppler_fixture.h"
#include "gui/support/screenshots.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

class ColourTest : public DopplerFixture {
  Q_OBJECT

 private:
  [[nodiscard]] const ColourDoppler& colour() const { return *knobs().colour; }
  [[nodiscard]] ColourBox box() const { return colourBoxOf(session().console().probe(), knobs()); }
  void switchOn() const {
    press("colour");
    QVERIFY(knobs().colour.has_value());
    session().makeImageNow();
  }
  /// Where the middle of the box, or a corner or an edge of it, is in the view. @param across,along -1..1 of the box
  [[nodiscard]] QPoint placeIn(double across, double along) const {
    const ColourBox now = box();
    const double x = std::lerp(now.left, now.right, 0.5 * (across + 1.0)) * faceHalfWidth_mm(session().console().probe());
    const double y = std::lerp(now.top_mm, now.bottom_mm, 0.5 * (along + 1.0));
    return scan().positionOf({{x, y, 0.0}}).toPoint();
  }
  void showColourPage() const {
    window_->console().showPage(find<QCheckBox>("colour"));
    QTest::qWait(60);
  }

 private Q_SLOTS:
  void initTestCase() { initTranslations(); }
  void init() {
    openConsole();
    QSettings().setValue(QStringLiteral("fold/colourAdvanced"), true);
  }
  void cleanup() { window_.reset(); }

  void aCaseThatDoesNotSayHowBloodFlowsHasASentenceAndNoControl() {
    auto* nothing = find<QLabel>("noColour");
    QVERIFY(!nothing->isHidden());
    QVERIFY(find<QCheckBox>("colour")->isHidden());
    QVERIFY(find<QSlider>("colourScale")->parentWidget()->isHidden());
    QTest::keyClick(&scan(), Qt::Key_F, Qt::ShiftModifier);
    QVERIFY2(!knobs().colour, "a key does what no control does");
    showFlowingBlood();
    QVERIFY(nothing->isHidden());
    QVERIFY(!find<QCheckBox>("colour")->isHidden());
    QVERIFY(!find<QSlider>("colourScale")->parentWidget()->isHidden());
    QVERIFY2(!find<QSlider>("colourScale")->isEnabled(), "colour is off");
  }

  void everyControlChangesWhatItNames() {
    showFlowingBlood();
    switchOn();
    const auto changes = [this](const char* what, const std::function<void()>& turn, const std::function<void(ColourDoppler&)>& expected) {
      Knobs wanted = knobs();
      expected(*wanted.colour);
      QVERIFY2(!(wanted == knobs()), what);
      turn();
      QVERIFY2(wanted == knobs(), what);
    };
    changes(
        "variance", [&] { press("colourVariance"); }, [](ColourDoppler& c) { c.shows = ColourShows::variance; });
    changes(
        "gain", [&] { slide("colourGain", 7); }, [](ColourDoppler& c) { c.gain_db = 3.5; });
    changes(
        "baseline", [&] { slide("colourBaseline", 5); }, [](ColourDoppler& c) { c.baseline = 0.5; });
    changes(
        "filter", [&] { press("wallHigh"); }, [](ColourDoppler& c) { c.wallFilter = WallFilterSetting::high; });
    changes(
        "invert", [&] { press("colourInvert"); }, [](ColourDoppler& c) { c.invert = true; });
    changes(
        "packet", [&] { slide("colourPacket", 16); }, [](ColourDoppler& c) { c.packet = 16; });
    changes(
        "lines", [&] { press("colourLines4"); }, [](ColourDoppler& c) { c.everyLine = 4; });
    changes(
        "smoothing", [&] { press("colourSmoothing3"); }, [](ColourDoppler& c) { c.smoothing = 3; });
    changes(
        "persistence", [&] { slide("colourPersistence", 80); }, [](ColourDoppler& c) { c.persistence = 0.8; });
    changes(
        "priority", [&] { slide("colourPriority", 70); }, [](ColourDoppler& c) { c.priority = 0.7; });
    changes(
        "reject", [&] { slide("colourReject", 10); }, [](ColourDoppler& c) { c.reject = 0.1; });
    changes(
        "frequency", [&] { slide("colourFrequency", 40); }, [](ColourDoppler& c) { c.carrier_hz = 4e6; });
    changes(
        "usual frequency", [&] { slide("colourFrequency", 50); }, [](ColourDoppler& c) { c.carrier_hz = 0.0; });
    slide("colourSteering", -15);
    QVERIFY(std::abs(colour().steering_rad - glm::radians(-15.0)) < 1e-12);
    QCOMPARE(find<QSlider>("colourSteering")->maximum(), 20);
    press("trapezoid");
    QVERIFY2(!find<QSlider>("colourSteering")->isEnabled(), "a trapezoid does not steer");
    press("colourPower");
    QVERIFY2(!find<QSlider>("colourBaseline")->isEnabled() && !find<QCheckBox>("colourInvert")->isEnabled(), "power has no direction");
    session().console().chooseProbe("convex-3.5");
    QVERIFY2(find<QSlider>("colourSteering")->parentWidget()->isHidden(), "a convex probe does not steer");
  }

  void colourIsAsItWasWhenItIsSwitchedOnAgain() {
    showFlowingBlood();
    switchOn();
    slide("colourGain", -8);
    press("wallLow");
    const ColourDoppler before = colour();
    press("colour");
    QVERIFY(!knobs().colour);
    QCOMPARE(find<QSlider>("colourGain")->value(), -8);
    QTest::keyClick(&scan(), Qt::Key_F, Qt::ShiftModifier);
    QVERIFY(knobs().colour.has_value() && colour() == before);
  }

  void theScaleIsTheNyquistVelocityAndEndsWhereTheLowerEdgeLetsNoEchoBack() {
    showFlowingBlood();
    switchOn();
    auto* scale = find<QSlider>("colourScale");
    slide("colourScale", 20);
    QCOMPARE(colour().prf_hz, 1000.0);
    // 1540 m/s x 1000 / s / (4 x 5 MHz) = 7.7 cm/s
    QVERIFY2(find<QLabel>("colourScaleValue")->text().startsWith(QStringLiteral("7.7 ")),
             qPrintable(find<QLabel>("colourScaleValue")->text()));
    scale->setValue(scale->maximum());
    const double most_hz = 1540e3 / 2.0 / box().bottom_mm;
    QVERIFY2(std::abs(box().prf_hz - std::min(most_hz, 20000.0)) < 1.0, qPrintable(QString::number(box().prf_hz)));
    QCOMPARE(scale->value(), scale->maximum());
    const int before = scale->maximum();
    slide("depth", 100);
    session().makeImageNow();
    drag(placeIn(0.0, 1.0), scan().positionOf({{0.0, 95.0, 0.0}}).toPoint());
    QVERIFY(box().bottom_mm > 85.0);
    QVERIFY2(scale->maximum() < before, "from deeper down echoes come later");
    QTest::keyClick(&scan(), Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(scale->value() < scale->maximum());
  }

  void aDragWithinTheBoxMovesItAndNothingElse() {
    showFlowingBlood();
    switchOn();
    for (const double zoom : {1.0, 1.5}) {
      Knobs zoomed = knobs();
      zoomed.zoom = zoom;
      session().console().setKnobs(zoomed);
      session().makeImageNow();
      const Hold hold = session().probeControl().hold();
      const Pan pan = session().console().pan();
      Knobs wanted = knobs();
      const ColourBox before = box();
      const QPoint from = placeIn(0.1, 0.1);
      moveTo(from, Qt::NoButton);
      QCOMPARE(scan().cursor().shape(), Qt::OpenHandCursor);
      QVERIFY(!scan().dragHint().isEmpty());
      drag(from, from + QPoint(24, -18));
      const double by_mm = scan().mmPerWidgetPixel();
      QVERIFY2(std::abs(box().top_mm - (before.top_mm - 18.0 * by_mm)) < 0.5 * by_mm, qPrintable(QString::number(box().top_mm)));
      const double across = -24.0 * by_mm / faceHalfWidth_mm(session().console().probe());  // the marker, at +x, is at the left
      QVERIFY2(std::abs(box().left - before.left - across) < 0.01, qPrintable(QString::number(box().left - before.left)));
      QVERIFY(std::abs((box().right - box().left) - (before.right - before.left)) < 1e-9);
      QVERIFY(session().probeControl().hold() == hold);
      QVERIFY(session().console().pan() == pan);
      wanted.colour = knobs().colour;
      QVERIFY2(knobs() == wanted, "another setting was changed");
      QVERIFY(window_->calipers().lines().empty());
    }
    Knobs whole = knobs();
    whole.zoom = 1.0;
    session().console().setKnobs(whole);
    session().makeImageNow();
    const Hold hold = session().probeControl().hold();
    const ColourDoppler before = colour();
    const QPoint outside = placeIn(0.0, -1.0) - QPoint(0, 40);
    moveTo(outside, Qt::NoButton);
    QVERIFY(scan().dragHint().isEmpty());
    QCOMPARE(scan().cursor().shape(), Qt::SizeAllCursor);
    drag(outside, outside + QPoint(30, 0));
    QVERIFY2(!(session().probeControl().hold() == hold), "beside the box the hand has the probe");
    QVERIFY(colour() == before);
  }

  void edgesAndCornersResizeTheBox() {
    showFlowingBlood();
    switchOn();
    const ColourBox before = box();
    moveTo(placeIn(0.0, 1.0), Qt::NoButton);
    QCOMPARE(scan().cursor().shape(), Qt::SizeVerCursor);
    drag(placeIn(0.0, 1.0), placeIn(0.0, 1.0) + QPoint(0, 30));
    QVERIFY(std::abs(box().bottom_mm - before.bottom_mm - 30.0 * scan().mmPerWidgetPixel()) < 0.3);
    QVERIFY(std::abs(box().top_mm - before.top_mm) < 1e-6 && std::abs(box().left - before.left) < 1e-9);
    moveTo(placeIn(1.0, 0.0), Qt::NoButton);
    QCOMPARE(scan().cursor().shape(), Qt::SizeHorCursor);
    // +x lies at the left of the image, so this is its upper left corner.
    moveTo(placeIn(1.0, -1.0), Qt::NoButton);
    QCOMPARE(scan().cursor().shape(), Qt::SizeFDiagCursor);
    const ColourBox wider = box();
    drag(placeIn(1.0, -1.0), placeIn(1.0, -1.0) - QPoint(20, 10));
    QVERIFY(box().right > wider.right + 0.02 && box().top_mm < wider.top_mm - 0.3);
    QVERIFY(std::abs(box().left - wider.left) < 1e-9 && std::abs(box().bottom_mm - wider.bottom_mm) < 1e-6);
    drag(placeIn(0.0, -1.0), placeIn(0.0, 1.0) + QPoint(0, 60));  // beyond the other edge
    QVERIFY(box().bottom_mm - box().top_mm >= 5.0 - 1e-9);
    QVERIFY(std::abs(box().bottom_mm - wider.bottom_mm) < 1e-6);
  }

  void whatStandsStillKeepsItsBox() {
    showFlowingBlood();
    switchOn();
    QTest::mousePress(&scan(), Qt::LeftButton, Qt::NoModifier, placeIn(0.0, 0.0));
    moveTo(placeIn(0.0, 0.0) + QPoint(10, 0), Qt::LeftButton);
    session().makeImageNow();
    press("freeze");  // in the middle of a drag
    const Knobs frozen = knobs();
    const Hold hold = session().probeControl().hold();
    moveTo(placeIn(0.0, 0.0) + QPoint(40, 40), Qt::LeftButton);
    QTest::mouseRelease(&scan(), Qt::LeftButton, Qt::NoModifier, placeIn(0.0, 0.0) + QPoint(40, 40));
    QVERIFY(knobs() == frozen);
    moveTo(placeIn(0.2, 0.2), Qt::NoButton);
    QCOMPARE(scan().cursor().shape(), Qt::ArrowCursor);
    drag(placeIn(0.2, 0.2), placeIn(0.2, 0.2) + QPoint(20, 20));
    QVERIFY(knobs() == frozen && session().probeControl().hold() == hold);
    for (const char* control : {"colourGain", "colourScale", "colourPacket"}) {
      find<QSlider>(control)->setValue(find<QSlider>(control)->value() + 2);
      QVERIFY2(knobs() == frozen, control);
    }
    find<QCheckBox>("colour")->click();
    QVERIFY2(knobs() == frozen && find<QCheckBox>("colour")->isChecked(), "new echoes would be needed");
    QVERIFY2(!scan().colourBarRect().isNull(), "a frozen image has its bar");
    press("freeze");
    drag(placeIn(0.2, 0.2), placeIn(0.2, 0.2) + QPoint(20, 20));
    QVERIFY(!(knobs() == frozen));
  }

  void theCaseIsClosedInTheMiddleOfADrag() {
    showFlowingBlood();
    switchOn();
    const QPoint from = placeIn(0.0, 0.0);
    QTest::mousePress(&scan(), Qt::LeftButton, Qt::NoModifier, from);
    moveTo(from + QPoint(10, 0), Qt::LeftButton);
    const ScanSubject next = *session().subject();
    session().clear();
    const Knobs before = knobs();
    moveTo(from + QPoint(20, 0), Qt::LeftButton);
    QVERIFY(knobs() == before);
    session().show(next);
    session().makeImageNow();
    QVERIFY(knobs().colour.has_value());
    const Knobs fresh = knobs();
    moveTo(from + QPoint(30, 0), Qt::LeftButton);
    QTest::mouseRelease(&scan(), Qt::LeftButton, Qt::NoModifier, from + QPoint(30, 0));
    QVERIFY2(knobs() == fresh, "the next patient's box hung on the pointer");
  }

  void theBarLiesBesideTheFanAndIsThereForColourAlone() {
    showFlowingBlood();
    QVERIFY(scan().colourBarRect().isNull());
    switchOn();
    for (const char* probe : {"test-linear", "convex-3.5"}) {
      session().console().chooseProbe(probe);
      for (const int width : {1024, 1280, 1600}) {
        window_->resize(width, 720);
        QTest::qWait(60);
        session().makeImageNow();
        const QRect bar = scan().colourBarRect();
        QVERIFY(!bar.isNull() && scan().rect().contains(bar));
        for (const QRect& fan : scan().fanRects()) QVERIFY2(!fan.intersects(bar), probe);
        QVERIFY(!find<QWidget>("focusScale")->geometry().intersects(bar));
        for (int n = 1; n <= kDgcSliders; ++n) {
          const auto* slider = find<QSlider>(qPrintable(QStringLiteral("dgc%1").arg(n)));
          QVERIFY(!QRect(slider->mapTo(&scan(), QPoint()), slider->size()).intersects(bar));
        }
      }
    }
    press("modeM");
    session().makeImageNow();
    QVERIFY(scan().colourBarRect().isNull());
    press("modeB");
    press("colour");
    session().makeImageNow();
    QVERIFY(scan().colourBarRect().isNull());
  }

  void aSavedImageHasTheBar() {
    showFlowingBlood();
    session().console().chooseProbe("convex-3.5");
    session().makeImageNow();
    const auto colouredPixels = [this] {
      const QImage saved = savedImage(session(), QDateTime::currentDateTime(), {}, {});
      int count = 0;
      for (int y = 0; y < saved.height(); ++y)
        for (int x = 0; x < saved.width(); ++x) {
          const QRgb pixel = saved.pixel(x, y);
          count += std::abs(qRed(pixel) - qBlue(pixel)) > 40 ? 1 : 0;
        }
      return count;
    };
    QCOMPARE(colouredPixels(), 0);
    switchOn();
    const int count = colouredPixels();
    QVERIFY2(count > 500, qPrintable(QString::number(count)));
  }

  void aChangeOfColourIsOneOfThePreset() {
    showFlowingBlood();
    switchOn();
    window_->console().showPreset(QStringLiteral("Mine"));
    QVERIFY(find<QPushButton>("presets")->text().contains(QStringLiteral("Mine")));
    slide("colourGain", 4);
    QVERIFY(!find<QPushButton>("presets")->text().contains(QStringLiteral("Mine")));
  }

  void nothingOfThePageIsClippedInEitherLanguage() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    for (const bool isGerman : {false, true}) {
      if (isGerman) {
        QApplication::installTranslator(&german);
        cleanup();
        init();
      }
      showFlowingBlood();
      switchOn();
      showColourPage();
      checkNothingIsClipped();
      const auto* pages = find<QTabWidget>("consolePages");
      const auto* page = find<QCheckBox>("colour")->parentWidget();
      QVERIFY2(page->width() <= pages->width(), qPrintable(QString::number(page->width())));
      keepScreenshot(*window_, isGerman ? "colour-de" : "colour-en");
    }
    QApplication::removeTranslator(&german);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::ColourTest)
#include "colour_test.moc"
