// What may be changed of a frozen image, and a box that is magnified, live or frozen.
#include <QLabel>
#include <cmath>

#include "ew/ui_test_door/annotate.h"
#include "ew/ui_test_door/cine.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/zoom.h"
#include "gui/support/console_fixture.h"
#include "gui/support/screenshots.h"

namespace ew::ui::testing {

class FrozenImageTest : public ConsoleFixture {
  Q_OBJECT

  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(&window_->scanView(), key, modifiers);
  }
  void settle() const {
    QVERIFY(waitUntil([this] { return !session().cineLoop().isForming(); }));
    QTest::qWait(30);
  }
  void scanAndFreeze(int frames = 12) const {
    for (int n = 0; n < frames; ++n) {
      session().probeControl().setHold(turned(session().probeControl().hold(), 0.01, 0.0, 0.01));
      session().makeImageNow();
      QTest::qWait(2);
    }
    pressKey(Qt::Key_F);
    QVERIFY(session().isFrozen());
  }
  static void mouse(QWidget& at, QEvent::Type type, const QPoint& where) {
    const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, where, at.mapToGlobal(where), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
    QApplication::sendEvent(&at, &event);
  }
  static void drag(QWidget& at, const QPoint& from, const QPoint& to) {
    mouse(at, QEvent::MouseButtonPress, from);
    mouse(at, QEvent::MouseMove, (from + to) / 2);
    mouse(at, QEvent::MouseMove, to);
    mouse(at, QEvent::MouseButtonRelease, to);
  }
  [[nodiscard]] BoxZoom& box() const { return *window_->findChild<BoxZoom*>(); }
  [[nodiscard]] ZoomOverview& overview() const { return *window_->findChild<ZoomOverview*>(); }
  /// Of the middle half of the image in each direction, moved by `by`.
  [[nodiscard]] QRect middleBox(const QPoint& by = {}) const {
    QRect drawn(0, 0, box().width() / 2, box().height() / 2);
    drawn.moveCenter(box().rect().center() + by);
    return drawn;
  }

 private Q_SLOTS:
  void init() {
    openConsole();
    window_->bodyMark().setShown(false);
    session().makeImageNow();
  }
  void cleanup() { window_.reset(); }

  void howItIsShownIsChangedAndWhatNeedsEchoesIsRefused() {
    scanAndFreeze();
    const auto before = pixelsOf(session());
    const ScanState scanned = session().shownState();
    const Knobs live = knobs();
    press("greyContrast");
    settle();
    QVERIFY(pixelsOf(session()) != before && session().isFrozen());
    QCOMPARE(session().imageKnobs().greyMap, GreyMap::contrast);
    slide("dynamicRange", 40);
    pressKey(Qt::Key_X);
    pressKey(Qt::Key_U);
    slide("zoom", 20);
    settle();
    QVERIFY(!session().geometry().markerLeft && session().geometry().upsideDown);
    QCOMPARE(session().imageKnobs().zoom, 2.0);
    QVERIFY2(window_->scanView().said().isEmpty(), qPrintable(window_->scanView().said()));
    QVERIFY(session().shownState().pose == scanned.pose && session().shownState().number == scanned.number);
    // What needs new echoes is not there to be had.
    const auto shown = pixelsOf(session());
    for (const Qt::Key key : {Qt::Key_PageDown, Qt::Key_H, Qt::Key_Period, Qt::Key_B, Qt::Key_P, Qt::Key_M}) {
      const Knobs held = knobs();
      if (key == Qt::Key_Period) continue;  // steps the loop while frozen
      pressKey(key);
      QVERIFY2(knobs() == held, qPrintable(QKeySequence(key).toString()));
      if (key == Qt::Key_H) continue;  // a probe of one frequency has no next one
      QVERIFY(window_->scanView().said().contains(QLatin1String("new echoes")));
    }
    QCOMPARE(pixelsOf(session()), shown);
    // The scan that goes on has what it had.
    pressKey(Qt::Key_F);
    QVERIFY(!session().isFrozen() && knobs() == live);
    QVERIFY(!find<QAbstractButton>("greyContrast")->isChecked());
  }

  void itActsOnAllOfTheLoopAndTakenBackGivesTheSamePixels() {
    scanAndFreeze();
    CineBar& bar = window_->cineBar();
    bar.goTo(3);
    settle();
    const auto third = pixelsOf(session());
    bar.goTo(7);
    settle();
    const auto seventh = pixelsOf(session());
    const ScanState kept = session().cineLoop().ring().frame(7);
    const int map = static_cast<int>(knobs().greyMap);
    press("greyBright");
    pressKey(Qt::Key_X);
    settle();
    QVERIFY(pixelsOf(session()) != seventh);
    bar.goTo(3);
    settle();
    QVERIFY(pixelsOf(session()) != third && !session().geometry().markerLeft);
    QCOMPARE(session().imageKnobs().greyMap, GreyMap::bright);
    QVERIFY2(session().cineLoop().ring().frame(7) == kept, "the ring stays as it was scanned");
    pressKey(Qt::Key_X);
    Knobs back = knobs();
    back.greyMap = static_cast<GreyMap>(map);
    session().console().setKnobs(back);
    settle();
    QCOMPARE(pixelsOf(session()), third);
    bar.goTo(7);
    settle();
    QCOMPARE(pixelsOf(session()), seventh);
  }

  void calipersStayAtTheirTissueWhileItIsShownOtherwise() {
    scanAndFreeze();
    Calipers& calipers = window_->calipers();
    calipers.take(measurement::CaliperKind::distance);
    calipers.change([](measurement::CaliperDrawing& drawing) {
      drawing.press({-20.0, 40.0}, 1.0);
      drawing.release({-20.0, 40.0}, 1.0);
      drawing.press({25.0, 70.0}, 1.0);
      drawing.release({25.0, 70.0}, 1.0);
    });
    QCOMPARE(calipers.lines().size(), std::size_t{1});
    const double length_mm = calipers.lines()[0].measured.figures[0].quantity.value;
    QVERIFY(std::abs(length_mm - std::hypot(45.0, 30.0)) < 1e-9);
    pressKey(Qt::Key_X);
    session().console().setDetail(3.0, {5.0, -10.0});
    settle();
    QCOMPARE(calipers.lines().size(), std::size_t{1});
    QCOMPARE(calipers.lines()[0].measured.figures[0].quantity.value, length_mm);
    QVERIFY((calipers.lines()[0].measurement.caliper.parts[0].points[1] == glm::dvec2(25.0, 70.0)));
    // And the image says the same of the place.
    const ScanView& scan = window_->scanView();
    const Point<frame::Probe> there = scan.pointAt(scan.positionOf({{25.0, 70.0, 0.0}}));
    QVERIFY(glm::distance(there.at, glm::dvec3(25.0, 70.0, 0.0)) < 1e-9);
    QVERIFY(std::abs(scan.depthAt_mm(scan.yOfDepth(70.0)) - 70.0) < 1e-9);
  }

  void aBoxFillsTheImageLiveAndFrozen() {
    for (const bool isFrozen : {false, true}) {
      if (isFrozen) scanAndFreeze();
      const DisplayGeometry whole = session().geometry();
      const auto framesBefore = session().frames().framesMade();
      pressKey(Qt::Key_O);
      QVERIFY(box().isDrawing() && box().isVisible());
      const QRect drawn = middleBox({-30, 25});
      const ScanView& scan = window_->scanView();
      const Point<frame::Probe> middle = scan.pointAt(QPointF(scan.imageRect().topLeft()) + QRectF(drawn).center());
      drag(box(), drawn.topLeft(), drawn.bottomRight() + QPoint(1, 1));
      QVERIFY(!box().isDrawing());
      session().makeImageNow();
      settle();
      QVERIFY(session().frames().framesMade() > framesBefore);
      QVERIFY2(std::abs(session().console().detail().zoom - 2.0) < 0.02, qPrintable(QString::number(session().console().detail().zoom)));
      QVERIFY(std::abs(session().geometry().pixel_mm - whole.pixel_mm / session().console().detail().zoom) < 1e-6);
      const QPointF at = scan.positionOf(middle) - QPointF(scan.imageRect().topLeft());
      QVERIFY2(std::hypot(at.x() - box().width() / 2.0, at.y() - box().height() / 2.0) < 2.5,
               qPrintable(QStringLiteral("%1 %2").arg(at.x()).arg(at.y())));
      QVERIFY(overview().isVisible());
      QVERIFY(waitUntil([this] { return overview().isUpToDate() && !overview().image().isNull(); }));
      const QRectF part = overview().box();
      QVERIFY2(std::abs(part.width() - overview().width() / session().console().detail().zoom) < 1.5,
               qPrintable(QString::number(part.width())));
      // A drag in the overview moves the detail there.
      const Pan before = session().console().detail().pan;
      drag(overview(), part.center().toPoint(), part.center().toPoint() + QPoint(8, 6));
      session().makeImageNow();
      settle();
      QVERIFY(!(session().console().detail().pan == before));
      QVERIFY2(
          std::abs(overview().box().center().x() - part.center().x() - 8.0) < 2.0,
          qPrintable(QStringLiteral("%1 from %2 of %3").arg(overview().box().center().x()).arg(part.center().x()).arg(overview().width())));
      // So does one in the image.
      const Pan there = session().console().detail().pan;
      drag(window_->scanView(), scan.imageRect().center(), scan.imageRect().center() + QPoint(20, 10));
      session().makeImageNow();
      settle();
      QVERIFY(!(session().console().detail().pan == there));
      pressKey(Qt::Key_Backspace, Qt::ControlModifier);
      session().makeImageNow();
      settle();
      QCOMPARE(session().console().detail().zoom, 1.0);
      QVERIFY(session().geometry() == whole && !overview().isVisible());
    }
  }

  void aClickIsNoBoxAndEscapeLeavesTheImage() {
    const DisplayGeometry whole = session().geometry();
    press("boxZoomButton");
    QVERIFY(box().isDrawing());
    drag(box(), {100, 100}, {104, 103});
    QVERIFY(box().isDrawing() && !window_->scanView().said().isEmpty());
    QTest::keyClick(&box(), Qt::Key_Escape);
    QVERIFY(!box().isDrawing());
    session().makeImageNow();
    QVERIFY(session().geometry() == whole);
    QVERIFY(!find<QAbstractButton>("wholeImage")->isEnabled());
  }

  void itLooksAsItShould() {
    scanAndFreeze();
    pressKey(Qt::Key_O);
    mouse(box(), QEvent::MouseButtonPress, middleBox().topLeft());
    mouse(box(), QEvent::MouseMove, middleBox().bottomRight());
    keepScreenshot(*window_, "box_drawing");
    mouse(box(), QEvent::MouseButtonRelease, middleBox().bottomRight());
    settle();
    QVERIFY(waitUntil([this] { return overview().isUpToDate() && !overview().image().isNull(); }));
    keepScreenshot(*window_, "box_zoomed");
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::FrozenImageTest)

#include "frozen_image_test.moc"
