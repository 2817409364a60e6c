// The canvas of the body on a screen of 125 %: it is drawn on a thread of its own, which nobody waits for. Run a second time as where
// OpenGL knows one thread only.
#include <QApplication>
#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QScopeGuard>
#include <QScreen>
#include <QSignalSpy>
#include <QWindow>
#include <QtTest>
#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>

#include "ew/body/body_canvas.h"
#include "gui/support/body_gate.h"
#include "time_limit.h"

namespace ew {
namespace {

bool waitUntil(const std::function<bool()>& ready) {
  QElapsedTimer clock;
  clock.start();
  while (!ready()) {
    if (static_cast<double>(clock.elapsed()) > test::kPatience_ms) return false;
    QTest::qWait(10);
  }
  return true;
}

constexpr const char* kScreenFactor = "_q_scaleFactor";  ///< where Qt 5 keeps what QT_SCREEN_SCALE_FACTORS said
constexpr auto kQuick = bridge::Scene3D::Edges::quick;

}  // namespace

class BodyCanvasTest final : public QObject {
  Q_OBJECT

  std::unique_ptr<QWidget> window_;
  BodyCanvas* canvas_ = nullptr;

  [[nodiscard]] QImage seen() const { return canvas_->grab().toImage(); }
  void lookFrom(bridge::CameraPreset preset) {
    canvas_->change([preset](bridge::Scene3D& scene) { scene.showFrom(preset); });
  }
  [[nodiscard]] static bool isThreaded() { return QOpenGLContext::supportsThreadedOpenGL(); }
  /// Something is drawn, and held: by the gate, or on one thread by what the test does before its next turn.
  [[nodiscard]] bool begins(const test::BodyGate& gate) {
    canvas_->draw(kQuick);
    return !isThreaded() || waitUntil([&] { return gate.passed() == 1; });
  }

 private Q_SLOTS:
  void init() {
    window_ = std::make_unique<QWidget>();
    window_->resize(600, 500);
    QPalette magenta;
    magenta.setColor(QPalette::Window, Qt::magenta);
    window_->setPalette(magenta);
    canvas_ = new BodyCanvas(window_.get());
    canvas_->setPalette(QPalette(Qt::darkGray));
    canvas_->setGeometry(10, 20, 501, 403);  // 12.5 and 626.25 pixels of the screen
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QVERIFY(canvas_->isValid());
    canvas_->drawNow(kQuick);
  }
  void cleanup() { window_.reset(); }

  void whoAsksForADrawingDoesNotWaitForIt() {
    const QImage before = seen();
    test::BodyGate gate(*canvas_);
    QSignalSpy drawn(canvas_, &BodyCanvas::drawn);
    canvas_->changeLooks([](bridge::Scene3D& scene) { scene.setColours(bridge::lightColours()); });
    QVERIFY(begins(gate));
    QVERIFY(canvas_->isDrawing());
    QCOMPARE(drawn.count(), 0);
    QCOMPARE(seen(), before);  // painted all the same
    gate.letGo();
    QVERIFY(waitUntil([&] { return drawn.count() == 1; }));
    QVERIFY(seen() != before);
  }

  void ofSeveralThatAreAskedForMeanwhileTheLastAloneIsDrawn() {
    test::BodyGate gate(*canvas_);
    QSignalSpy drawn(canvas_, &BodyCanvas::drawn);
    QVERIFY(begins(gate));
    for (int n = 0; n < 20; ++n) {
      canvas_->change([](bridge::Scene3D& scene) { scene.orbit(0.05, 0.0); });
      canvas_->draw(kQuick);
    }
    gate.letGo();
    QVERIFY(waitUntil([&] { return !canvas_->isDrawing(); }));
    QTest::qWait(50);
    QCOMPARE(gate.passed(), isThreaded() ? 2 : 1);
    QVERIFY(drawn.count() >= 1 && drawn.count() <= gate.passed());  // one that ends before another is taken is not told of by itself
  }

  void whatIsAskedForInOneTurnIsDrawnOnceAfterIt() {
    test::BodyGate gate(*canvas_);
    gate.letGo();
    for (int n = 0; n < 20; ++n) {
      canvas_->change([](bridge::Scene3D& scene) { scene.orbit(0.05, 0.0); });
      canvas_->draw(kQuick);
      static_cast<void>(seen());
    }
    if (!isThreaded()) QCOMPARE(gate.passed(), 0);
    QVERIFY(canvas_->isDrawing());
    QVERIFY(waitUntil([&] { return !canvas_->isDrawing(); }));
    if (!isThreaded()) QCOMPARE(gate.passed(), 1);
    QVERIFY(QOpenGLContext::currentContext() == nullptr);
    // And the last of it is seen: nothing is left for another drawing.
    const QImage drawn = seen();
    QVERIFY(canvas_->drawNow(kQuick));
    QCOMPARE(seen(), drawn);
  }

  /// Where a click goes is asked of one scene, and what is seen was drawn from the other: both look from the same place.
  void whatIsDrawnIsSeenFromWhereQuestionsAreAnswered() {
    test::BodyGate gate(*canvas_);
    QVERIFY(begins(gate));
    lookFrom(bridge::CameraPreset::left);
    canvas_->change([](bridge::Scene3D& scene) { scene.pan({40.0, 25.0}); });
    canvas_->resize(300, 460);
    canvas_->change([](bridge::Scene3D& scene) {
      scene.zoom(1.7);
      scene.pan({-15.0, 60.0});
      scene.orbit(0.3, -0.2);
    });
    glm::dvec2 drawn(0.0);
    canvas_->changeLooks([&drawn](bridge::Scene3D& scene) { drawn = scene.pixelOf({30.0, -90.0, 120.0}); });
    gate.letGo();
    canvas_->drawNow(kQuick);
    QCOMPARE(drawn, canvas_->scene().pixelOf({30.0, -90.0, 120.0}));
    QVERIFY(drawn.x > 0.0 && drawn.y > 0.0);
  }

  void whatLiesOverTheBodyMovesWithItsImage() {
    const glm::dvec3 somewhere(30.0, -90.0, 120.0);
    const auto painted = [&] { return canvas_->sight().pixelOf(somewhere); };
    const auto asked = [&] { return canvas_->scene().pixelOf(somewhere) / canvas_->devicePixelRatioF(); };
    QVERIFY(glm::distance(painted(), asked()) < 1e-9);
    const glm::dvec2 before = painted();
    canvas_->change([](bridge::Scene3D& scene) { scene.orbit(0.3, -0.2); });
    QVERIFY(glm::distance(asked(), before) > 2.0);
    QCOMPARE(painted(), before);
    QVERIFY(canvas_->drawNow(kQuick));
    QVERIFY(glm::distance(painted(), asked()) < 1e-9);
    const glm::dvec2 drawn = painted();
    canvas_->resize(2 * canvas_->size());
    QVERIFY2(glm::distance(painted(), 2.0 * drawn) < 2.0, "stretched with it");
  }

  void aChangeThatFailsIsLeftOutAlone() {
    const QImage before = seen();
    test::BodyGate gate(*canvas_);
    QVERIFY(begins(gate));
    canvas_->changeLooks([](bridge::Scene3D&) { throw std::runtime_error("no memory for a test"); });
    canvas_->changeLooks([](bridge::Scene3D& scene) { scene.setColours(bridge::lightColours()); });
    gate.letGo();
    canvas_->drawNow(kQuick);
    QCOMPARE(gate.passed(), isThreaded() ? 2 : 1);
    QVERIFY(seen() != before);
  }

  void whereOpenGLFailsItIsToldAndTheLastImageStays() {
    test::breakContext(*canvas_);
    const QImage before = seen();
    QSignalSpy drawn(canvas_, &BodyCanvas::drawn);
    QSignalSpy notDrawn(canvas_, &BodyCanvas::notDrawn);
    QVERIFY(canvas_->isValid());
    lookFrom(bridge::CameraPreset::left);
    QVERIFY(!canvas_->drawNow(kQuick));
    QCOMPARE(notDrawn.count(), 1);
    QCOMPARE(drawn.count(), 0);
    QVERIFY(!canvas_->isValid() && !canvas_->isDrawing());
    lookFrom(bridge::CameraPreset::top);
    QCOMPARE(seen(), before);
  }

  void itIsClosedInTheMiddleOfADrawing() {
    if (!isThreaded()) QSKIP("on one thread nothing happens in the middle");
    auto canvas = std::make_unique<BodyCanvas>(nullptr);
    canvas->resize(200, 200);
    canvas->show();
    QVERIFY(canvas->isValid());
    QVERIFY(canvas->drawNow(kQuick));
    test::BodyGate gate(*canvas);
    canvas->draw(kQuick);
    QVERIFY(waitUntil([&] { return gate.passed() == 1; }));
    canvas->draw(kQuick);  // nobody waits for this one
    std::thread later([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      gate.letGo();
    });
    canvas.reset();
    const int ended = gate.ended();
    later.join();
    QCOMPARE(ended, 1);
    QCOMPARE(gate.passed(), 1);
  }

  void itIsClosedBeforeAnythingIsDrawn() {
    for (const bool isAsked : {false, true}) {
      BodyCanvas canvas(nullptr);
      canvas.show();
      QVERIFY(canvas.isValid());
      if (isAsked) canvas.draw(kQuick);
    }
  }

  void aLargerPlaceIsFilledUntilItIsDrawn() {
    const auto isGap = [](QRgb pixel) { return pixel == qRgb(0, 0, 0) || pixel == QColor(Qt::magenta).rgb(); };
    test::BodyGate gate(*canvas_);
    canvas_->resize(560, 470);
    const QImage stretched = seen();
    int gaps = 0;
    for (int y = 0; y < stretched.height(); ++y)
      for (int x = 0; x < stretched.width(); ++x) gaps += isGap(stretched.pixel(x, y)) ? 1 : 0;
    QCOMPARE(gaps, 0);
    gate.letGo();
    canvas_->drawNow(kQuick);
    QCOMPARE(seen().size(), QSize(700, 588));
  }

  void onAScreenOfOtherPixelsAnotherDrawingIsAskedFor() {
    QScreen* screen = window_->windowHandle()->screen();
    const glm::dvec3 somewhere(30.0, -90.0, 120.0);
    const double mmPerPixel = canvas_->scene().mmPerPixelAt(somewhere);
    screen->setProperty(kScreenFactor, 2.0);
    const QScopeGuard back([&] { screen->setProperty(kScreenFactor, 1.25); });
    QCOMPARE(canvas_->devicePixelRatioF(), 2.0);
    test::BodyGate gate(*canvas_);
    gate.letGo();
    QSignalSpy changed(canvas_, &BodyCanvas::pixelsChanged);
    QEvent moved(QEvent::ScreenChangeInternal);
    QCoreApplication::sendEvent(canvas_, &moved);
    QCOMPARE(changed.count(), 1);
    QVERIFY2(canvas_->scene().mmPerPixelAt(somewhere) < 0.7 * mmPerPixel, "and is asked by its new pixels");
    static_cast<void>(seen());
    QVERIFY2(!canvas_->isDrawing() && gate.passed() == 0, "who paints draws nothing");
    QCoreApplication::sendEvent(canvas_, &moved);
    QCOMPARE(changed.count(), 1);
    QVERIFY(canvas_->drawNow(kQuick));
    QCOMPARE(seen().size(), QSize(1002, 806));
  }

  void nothingOfBeforeIsLeftAtAnEdgeWithinAPixel() {
    const double ratio = canvas_->devicePixelRatioF();
    QCOMPARE(ratio, 1.25);
    for (int n = 0; n < 8; ++n) {
      canvas_->setGeometry(8 + n, 20 + n / 2, 40 + n / 3, 33 + n % 4);
      canvas_->drawNow(kQuick);
      QImage screen((QSizeF(window_->size()) * ratio).toSize(), QImage::Format_RGB32);
      screen.setDevicePixelRatio(ratio);
      screen.fill(Qt::magenta);
      window_->render(&screen);
      // Of these the middle lies in the canvas; on its edge it may be anybody's.
      const QRectF place = QRectF(QPointF(canvas_->pos()) * ratio, QSizeF(canvas_->size()) * ratio).adjusted(0.01, 0.01, -0.01, -0.01);
      int left = 0;
      for (int y = 0; y < screen.height(); ++y)
        for (int x = 0; x < screen.width(); ++x)
          left += place.contains(QPointF(x + 0.5, y + 0.5)) && screen.pixel(x, y) == QColor(Qt::magenta).rgb() ? 1 : 0;
      QVERIFY2(left == 0, qPrintable(QStringLiteral("%1 of geometry %2").arg(left).arg(n)));
    }
  }
};

}  // namespace ew

int main(int argc, char** argv) {
  qputenv("QT_SCREEN_SCALE_FACTORS", "1.25");
  QApplication app(argc, argv);
  ew::BodyCanvasTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "body_canvas_test.moc"
