// The 3D view and the hand on it, driven through real mouse, wheel and key events.

#include "ew/ui_test_door/body.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <QApplication>
#include <QOpenGLContext>
#include <QSignalSpy>
#include <QSurfaceFormat>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>
#include <chrono>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "gui/support/body_gate.h"
#include "places.h"

using namespace ew;

namespace {

constexpr QSize kSize(700, 760);
constexpr int kPatience_ms = static_cast<int>(test::kPatience_ms);

Probe convex() {
  Probe probe;
  probe.id = "convex";
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = glm::radians(35.0);
  probe.defaultDepth_mm = 160.0;
  probe.maxDepth_mm = 240.0;
  return probe;
}

int countPixels(const QImage& image, const std::function<bool(QColor)>& matches) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += matches(image.pixelColor(x, y)) ? 1 : 0;
  return count;
}

bool isAccent(const QColor& c) { return c.green() > 130 && c.blue() > 140 && c.red() < 120; }

void wheel(QWidget* target, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  const QPointF at(100, 100);
  QWheelEvent event(at, target->mapToGlobal(at.toPoint()), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, modifiers, Qt::NoScrollPhase,
                    false);
  QCoreApplication::sendEvent(target, &event);
}

void drag(QWidget* target, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton, int steps = 12) {
  QTest::mousePress(target, button, Qt::NoModifier, from);
  for (int i = 1; i <= steps; ++i) {
    const QPoint at = from + (to - from) * i / steps;
    QMouseEvent move(QEvent::MouseMove, at, target->mapToGlobal(at), Qt::NoButton, button, Qt::NoModifier);
    QCoreApplication::sendEvent(target, &move);
  }
  QTest::mouseRelease(target, button, Qt::NoModifier, to);
}

}  // namespace

class View3DTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<const bridge::Mannequin> body_;
  std::unique_ptr<ui::View3D> view_;
  HandOnSkin held_;
  std::unique_ptr<ui::HandInput> hand_;
  std::unique_ptr<QWidget> scan_;

  [[nodiscard]] QPoint contactPixel() const { return view_->pixelOf(hand_->hold().contact.point_mm).toPoint(); }
  [[nodiscard]] double offSkin_mm() const {
    const glm::dvec3 at = hand_->hold().contact.point_mm;
    return glm::distance(view_->skin()->nearest(at).point_mm, at);
  }
  void settle() {
    view_->renderNow();
    QTest::qWait(40);
  }

 private Q_SLOTS:
  void init() {
    view_ = std::make_unique<ui::View3D>();
    view_->resize(kSize);
    if (body_ == nullptr) {
      auto loaded = bridge::loadMannequin(std::filesystem::path(EW_SOURCE_DIR) / "resources/mannequin/adult.json");
      QVERIFY2(loaded.has_value(), loaded ? "" : loaded.error().sentence().c_str());
      body_ = std::make_shared<const bridge::Mannequin>(std::move(*loaded));
    }
    view_->setMannequin(body_);
    view_->setDarkTheme(true);
    held_ = {};
    hand_ = std::make_unique<ui::HandInput>(held_);
    scan_ = std::make_unique<QWidget>();
    hand_->watch(view_.get());
    hand_->watch(scan_.get(), [] { return 0.5; });
    view_->setProbe(convex(), 160.0);
    connect(hand_.get(), &ui::HandInput::moved, view_.get(), [this](const Hold& hold) {
      held_.setHold(hold);
      view_->setPose(poseOf(hold));
    });
    Hold hold;
    const auto front = view_->skin()->hit({0.0, -900.0, 0.0}, {0.0, 1.0, 0.0});
    QVERIFY(front.has_value());
    hold.contact = *front;
    held_.setHold(hold);
    hand_->setStartHold(hold);
    view_->setPose(poseOf(hold));
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get(), 240000));
    settle();
  }
  void cleanup() {
    hand_.reset();
    scan_.reset();
    view_.reset();
  }

  void aPixelAndItsPointAgree() {
    for (const QPoint at : {QPoint(350, 380), QPoint(330, 300), QPoint(400, 500)}) {
      const auto contact = view_->contactAt(at);
      QVERIFY(contact.has_value());
      const QPointF back = view_->pixelOf(contact->point_mm);
      QVERIFY(std::hypot(back.x() - at.x(), back.y() - at.y()) < 0.6);
    }
    QVERIFY(!view_->contactAt(QPoint(3, 3)).has_value());
  }

  void theFanHasTheCornersOfThePose() {
    Hold hold = turned(hand_->hold(), 0.7, 0.2, -0.4);
    held_.setHold(hold);
    view_->setPose(poseOf(hold));
    const auto outline_mm = fanOutline_mm(convex(), {}, 160.0);
    const auto corners_mm = view_->scene().fanCorners_mm();
    QVERIFY(corners_mm.size() + 1 >= outline_mm.size() && corners_mm.size() > 10);
    for (std::size_t i = 0; i < corners_mm.size(); ++i) {
      const glm::dvec3 expected = (poseOf(hold).probeToWorld * Point<frame::Probe>{{outline_mm[i], 0.0}}).at;
      QVERIFY(glm::distance(corners_mm[i], expected) < 1e-9);
    }
  }

  void theFanIsSeenInsideTheBodyAndHiddenWithTheProbe() {
    view_->showFrom(bridge::CameraPreset::overview);
    GreyImage white(300, 320, 255);
    Knobs knobs;
    knobs.depth_mm = 160.0;
    view_->setFanImage({viewOf(std::as_const(white))}, fitDisplay(convex(), knobs, 300, 320));
    settle();
    const QImage with = view_->grab().toImage();
    QVERIFY2(countPixels(with, isAccent) > 100, "the fan's edge in the accent colour");
    const auto isWhite = [](const QColor& c) { return c.red() > 245 && c.green() > 245 && c.blue() > 245; };
    QVERIFY2(countPixels(with, isWhite) > 2000, "the live image");
    const auto isSkin = [](const QColor& c) { return c.red() > c.green() + 10 && c.green() > c.blue() + 5 && c.red() > 90; };
    QVERIFY2(countPixels(with, isSkin) > 40000, "the body");
    Pose lost = poseOf(hand_->hold());
    lost.status = PoseStatus::invalid;
    view_->setPose(lost);
    settle();
    QCOMPARE(countPixels(view_->grab().toImage(), isAccent), 0);
    QVERIFY(view_->scene().fanCorners_mm().empty());
  }

  void aZoomedImageCoversItsOwnPartOfTheFanAndIsFramed() {
    view_->showFrom(bridge::CameraPreset::overview);
    GreyImage white(300, 320, 255);
    Knobs knobs;
    knobs.depth_mm = 160.0;
    const auto isWhite = [](const QColor& c) { return c.red() > 245 && c.green() > 245 && c.blue() > 245; };
    const auto shown = [&](double zoom) {
      knobs.zoom = zoom;
      view_->setFanImage({viewOf(std::as_const(white))}, fitDisplay(convex(), knobs, 300, 320));
      settle();
      return view_->grab().toImage();
    };
    const QImage whole = shown(1.0);
    const QImage zoomed = shown(4.0);
    const int wholePixels = countPixels(whole, isWhite);
    const int zoomedPixels = countPixels(zoomed, isWhite);
    // A sixteenth of the image's rectangle, of which the fan fills about half: never the whole fan, as pixels drawn on to its rim would.
    QVERIFY2(zoomedPixels > wholePixels / 40 && zoomedPixels < wholePixels / 4,
             qPrintable(QStringLiteral("%1 of %2").arg(zoomedPixels).arg(wholePixels)));
    QVERIFY2(countPixels(zoomed, isAccent) > countPixels(whole, isAccent), "the frame of the detail");
    // A point of the fan beside the detail shows no echo.
    const Pose pose = poseOf(hand_->hold());
    const glm::dvec3 beside_mm = glm::dvec3(pose.probeToWorld.matrix * glm::dvec4(0.0, 150.0, 0.0, 1.0));
    const QPoint at = view_->canvas()->mapTo(view_.get(), view_->pixelOf(beside_mm).toPoint());
    QVERIFY(view_->rect().contains(at));
    QVERIFY(isWhite(whole.pixelColor(at)));
    QVERIFY(!isWhite(zoomed.pixelColor(at)));
  }

  void theOverviewShowsTheFaceOfTheFanHoweverTheProbeIsRotated() {
    for (int degrees = -180; degrees < 180; degrees += 30) {
      Hold hold = hand_->hold();
      hold.rotation_rad = glm::radians(static_cast<double>(degrees));
      const Pose pose = poseOf(hold);
      view_->setPose(pose);
      view_->showFrom(bridge::CameraPreset::overview);
      const glm::dvec3 forward = glm::cross(view_->scene().cameraUp(), view_->scene().cameraRight());
      const double faced = std::abs(glm::dot(forward, glm::dvec3(pose.probeToWorld.matrix[2])));
      QVERIFY2(faced > 0.35, qPrintable(QStringLiteral("%1 at %2 degrees").arg(faced).arg(degrees)));
    }
  }

  void draggingTheContactMovesItOverTheSkinUnderThePointer() {
    view_->showFrom(bridge::CameraPreset::front);
    settle();
    QSignalSpy changed(hand_.get(), &ui::HandInput::moved);
    const QPoint from = contactPixel();
    const QPoint to = from + QPoint(45, 70);
    drag(view_->canvas(), from, to);
    QVERIFY(changed.count() > 5);
    const QPointF now = view_->pixelOf(hand_->hold().contact.point_mm);
    QVERIFY2(std::hypot(now.x() - to.x(), now.y() - to.y()) < 2.0, "the contact is under the pointer");
    QVERIFY(offSkin_mm() < 1e-6);
  }

  void draggingOffTheBodyKeepsContactWithoutAJump() {
    view_->showFrom(bridge::CameraPreset::front);
    settle();
    double largest_mm = 0.0;
    double farthestOff_mm = 0.0;
    glm::dvec3 last = hand_->hold().contact.point_mm;
    connect(hand_.get(), &ui::HandInput::moved, this, [&](const Hold& hold) {
      largest_mm = std::max(largest_mm, glm::distance(hold.contact.point_mm, last));
      farthestOff_mm = std::max(farthestOff_mm, offSkin_mm());
      last = hold.contact.point_mm;
    });
    drag(view_->canvas(), contactPixel(), QPoint(kSize.width() - 5, 30), Qt::LeftButton, 120);
    QVERIFY(largest_mm > 0.0);
    QVERIFY2(largest_mm < 60.0, qPrintable(QString::number(largest_mm)));
    QVERIFY(farthestOff_mm < 1e-6);
  }

  void aClickElsewhereOnTheSkinPutsTheProbeThere() {
    view_->showFrom(bridge::CameraPreset::front);
    settle();
    const QPoint at = contactPixel() + QPoint(-60, 120);
    const auto expected = view_->contactAt(at);
    QVERIFY(expected.has_value());
    QTest::mouseClick(view_->canvas(), Qt::LeftButton, Qt::NoModifier, at);
    QVERIFY(glm::distance(hand_->hold().contact.point_mm, expected->point_mm) < 1e-9);
  }

  void theWheelTiltsRocksAndRotatesInBothViews() {
    for (QWidget* target : {view_->canvas(), scan_.get()}) {
      Hold before = hand_->hold();
      wheel(target, 1);
      QVERIFY(std::abs(hand_->hold().tilt_rad - before.tilt_rad) > 0.01);
      QCOMPARE(hand_->hold().rock_rad, before.rock_rad);
      before = hand_->hold();
      wheel(target, 1, Qt::ShiftModifier);
      QVERIFY(std::abs(hand_->hold().rock_rad - before.rock_rad) > 0.01);
      QCOMPARE(hand_->hold().tilt_rad, before.tilt_rad);
      before = hand_->hold();
      wheel(target, -1, Qt::ControlModifier);
      QVERIFY(std::abs(hand_->hold().rotation_rad - before.rotation_rad) > 0.01);
    }
  }

  void keysSlideTurnAndComeHome() {
    view_->showFrom(bridge::CameraPreset::front);
    const Hold start = hand_->hold();
    QTest::keyClick(view_->canvas(), Qt::Key_Left);
    const double one_mm = glm::distance(hand_->hold().contact.point_mm, start.contact.point_mm);
    QVERIFY(std::abs(one_mm - 2.0) < 0.1);
    QVERIFY2(view_->pixelOf(hand_->hold().contact.point_mm).x() < view_->pixelOf(start.contact.point_mm).x(), "to the left on the screen");
    QTest::keyClick(view_->canvas(), Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(hand_->hold().contact.point_mm.z > start.contact.point_mm.z + 8.0);
    QTest::keyClick(view_->canvas(), Qt::Key_E);
    QTest::keyClick(view_->canvas(), Qt::Key_W);
    QTest::keyClick(view_->canvas(), Qt::Key_D);
    QVERIFY(hand_->hold().rotation_rad > 0.0 && hand_->hold().tilt_rad > 0.0 && hand_->hold().rock_rad > 0.0);
    QTest::keyClick(view_->canvas(), Qt::Key_Home);
    QCOMPARE(hand_->hold(), start);
  }

  void draggingTheScanSlidesAlongLateralAndElevational() {
    scan_->resize(300, 300);
    const Hold before = hand_->hold();
    const Pose upright = uprightPoseOf(before);
    drag(scan_.get(), {100, 100}, {124, 100});
    const glm::dvec3 moved = hand_->hold().contact.point_mm - before.contact.point_mm;
    QVERIFY(std::abs(glm::dot(moved, glm::dvec3(upright.probeToWorld.matrix[0])) - 12.0) < 0.5);
    QVERIFY(std::abs(glm::dot(moved, glm::dvec3(upright.probeToWorld.matrix[2]))) < 1.5);
    QVERIFY(offSkin_mm() < 1e-6);
  }

  void theRightButtonOrbitsWithoutMovingTheProbe() {
    const Hold before = hand_->hold();
    const glm::dvec3 right = view_->scene().cameraRight();
    drag(view_->canvas(), {300, 300}, {400, 330}, Qt::RightButton);
    QVERIFY(glm::distance(view_->scene().cameraRight(), right) > 0.1);
    QCOMPARE(hand_->hold(), before);
    const glm::dvec3 turnedRight = view_->scene().cameraRight();
    drag(view_->canvas(), {300, 300}, {330, 340}, Qt::MiddleButton);
    QCOMPARE(view_->scene().cameraRight(), turnedRight);
    QCOMPARE(hand_->hold(), before);
  }

  void aDisabledHandHoldsStillAndTheCameraMovesOn() {
    hand_->setEnabled(false);
    const Hold before = hand_->hold();
    wheel(view_->canvas(), 3);
    QTest::keyClick(view_->canvas(), Qt::Key_Left);
    drag(view_->canvas(), contactPixel(), contactPixel() + QPoint(40, 40));
    QCOMPARE(hand_->hold(), before);
    const glm::dvec3 right = view_->scene().cameraRight();
    drag(view_->canvas(), {300, 300}, {400, 300}, Qt::RightButton);
    QVERIFY(view_->scene().cameraRight() != right);
  }

  void aNarrowViewCutsNeitherButtonsNorHint() {
    for (const int width : {700, 420, 280, 250}) {
      view_->resize(width, 500);
      QTest::qWait(30);
      for (const char* name : {"viewButtons", "viewHints"}) {
        const auto* overlay = view_->findChild<QWidget*>(QString::fromLatin1(name));
        QVERIFY(overlay != nullptr);
        QVERIFY2(view_->rect().contains(overlay->geometry()), qPrintable(QStringLiteral("%1 at %2").arg(name).arg(width)));
      }
      for (const auto* button : view_->findChildren<QToolButton*>())
        QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(QStringLiteral("%1 at %2").arg(button->text()).arg(width)));
    }
  }

  void theButtonsOfTheCameraStandInAnEvenRowBesideTheBody() {
    for (const int width : {1000, 700, 420, 250}) {
      view_->resize(width, 500);
      QTest::qWait(30);
      const auto* bar = view_->findChild<QWidget*>(QStringLiteral("viewButtons"));
      const QString where = QString::number(width);
      QVERIFY2(!bar->geometry().intersects(view_->canvas()->geometry()), qPrintable(where));
      QVERIFY2(view_->canvas()->height() > 400, qPrintable(where));
      std::vector<QRect> shown;
      for (const auto* button : view_->findChildren<QToolButton*>())
        if (button->isVisible()) shown.push_back(button->geometry());
      QVERIFY(shown.size() >= 3);
      int narrowest = shown.front().width(), widest = narrowest;
      for (const QRect& each : shown) {
        QVERIFY2(each.top() == shown.front().top(), qPrintable(where));
        narrowest = std::min(narrowest, each.width());
        widest = std::max(widest, each.width());
      }
      if (width == 1000) QVERIFY2(widest - narrowest <= 1, qPrintable(QStringLiteral("%1 to %2").arg(narrowest).arg(widest)));
    }
  }

  void aKeptBodyIsNotDrawnAgainAndLooksAsIfItWere() {
    auto* canvas = static_cast<BodyCanvas*>(view_->canvas());
    vtkRenderer* lowest = canvas->renderWindow().GetRenderers()->GetFirstRenderer();
    QCOMPARE(lowest->GetLayer(), 0);
    int bodies = 0;
    vtkNew<vtkCallbackCommand> drawn;
    drawn->SetClientData(&bodies);
    drawn->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    lowest->AddObserver(vtkCommand::EndEvent, drawn);
    const auto look = [&] {
      bodies = 0;
      view_->renderNow();
      return canvas->grab().toImage();
    };
    const QImage first = look();
    view_->setPose(poseOf(turned(hand_->hold(), 0.7, 0.2, -0.4)));
    const QImage moved = look();
    QCOMPARE(bodies, 0);
    QVERIFY(moved != first);
    const std::vector<std::pair<const char*, std::function<void()>>> changes{
        {"nothing but the order to draw it", [this] { view_->setBodyOpacity(1.0); }},
        {"another place of the viewer", [this] { view_->change([](bridge::Scene3D& scene) { scene.orbit(0.2, 0.1); }); }},
        {"other colours", [this] { view_->setDarkTheme(false); }},
        {"a body to look through", [this] { view_->setBodyOpacity(0.5); }},
        {"skin with a tint",
         [this] { view_->setCoverage(std::vector<float>(static_cast<std::size_t>(body_->surface->GetNumberOfPoints()), 1.0F)); }},
        {"another size", [this] { view_->resize(kSize - QSize(60, 80)); }}};
    QImage before = moved;
    for (const auto& [what, change] : changes) {
      change();
      const QImage anew = look();
      QVERIFY2(bodies > 0, what);
      QVERIFY2((anew == before) == (what == changes.front().first), what);
      QVERIFY2(look() == anew && bodies == 0, what);
      before = anew;
    }
    lowest->RemoveObserver(drawn);
  }

  void whereOpenGLFailsASentenceSaysSo() {
    const auto* why = view_->findChild<QWidget*>(QStringLiteral("noBody"));
    QVERIFY(why != nullptr && !why->isVisible());
    QVERIFY(view_->renderNow());
    test::breakContext(*static_cast<BodyCanvas*>(view_->canvas()));
    QVERIFY(!view_->renderNow());
    QVERIFY(why->isVisible());
    QVERIFY(why->geometry() == view_->canvas()->geometry());
    QTest::mouseClick(view_->canvas(), Qt::LeftButton, Qt::NoModifier, contactPixel());  // and the hand goes on
  }

  /// Its pixels are brought before each drawing that is wished for.
  void manyChangesInOneTurnAreOneWish() {
    settle();
    int wishes = 0;
    view_->setBeforeDrawing([&] { ++wishes; });
    QSignalSpy drawn(view_->canvas(), SIGNAL(drawn()));
    for (int i = 0; i < 50; ++i) wheel(view_->canvas(), i % 2 == 0 ? 1 : -1);
    QCOMPARE(wishes, 0);
    QVERIFY(drawn.wait(kPatience_ms));
    QCOMPARE(wishes, 1);
    QVERIFY2(drawn.wait(kPatience_ms), "with smooth edges");
    QTest::qWait(400);
    QCOMPARE(wishes, 2);
    QCOMPARE(drawn.count(), 2);
    view_->setBeforeDrawing({});
  }

  /// However long it took: where a rest is counted from a wish, a slow machine has none.
  void itRestsFromTheEndOfADrawing() {
    if (!QOpenGLContext::supportsThreadedOpenGL()) QSKIP("the test holds a drawing, and OpenGL knows one thread only");
    settle();
    test::BodyGate gate(*static_cast<BodyCanvas*>(view_->canvas()));
    int wishes = 0;
    view_->setBeforeDrawing([&] { ++wishes; });
    wheel(view_->canvas(), 1);
    QTRY_COMPARE_WITH_TIMEOUT(gate.passed(), 1, kPatience_ms);
    for (int n = 0; n < 8; ++n) {
      wheel(view_->canvas(), 1);
      QTest::qWait(50);
    }
    QCOMPARE(wishes, 1);
    gate.letGo();
    QTRY_VERIFY_WITH_TIMEOUT(gate.passed() >= 2 && !gate.drawn().empty(), kPatience_ms);
    const std::chrono::duration<double, std::milli> rested = gate.begun()[1] - gate.drawn()[0];
    QVERIFY2(rested.count() > 95.0, qPrintable(QString::number(rested.count())));
    view_->setBeforeDrawing({});
  }
};

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication app(argc, argv);
  QApplication::setStyle(QStringLiteral("Fusion"));
  View3DTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "view3d_test.moc"
