// A wide image grows while the probe slides, is kept by a freeze, measured, magnified and saved.
#include <QAction>
#include <QImage>
#include <cmath>
#include <numbers>

#include "ew/ui_test_door/annotate.h"
#include "ew/ui_test_door/cine.h"
#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/zoom.h"
#include "gui/support/console_fixture.h"
#include "gui/support/screenshots.h"

namespace ew::ui::testing {

class WideImageTest : public ConsoleFixture {
  Q_OBJECT

  [[nodiscard]] WideScan& wide() const { return window_->wideScan(); }
  [[nodiscard]] QString said() const { return window_->scanView().said(); }
  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(&window_->scanView(), key, modifiers);
  }
  /// Across the patient, looking in from the front.
  void holdAt(double x_mm, double tilt_rad = 0.0, double z_mm = -20.0) const {
    Transform<frame::World, frame::Probe> probeToWorld;
    const double c = std::cos(tilt_rad), s = std::sin(tilt_rad);
    probeToWorld.matrix[1] = {0.0, c, s, 0.0};
    probeToWorld.matrix[2] = {0.0, -s, c, 0.0};
    probeToWorld.matrix[3] = {x_mm, -100.0, z_mm, 1.0};
    session().probeControl().follow(std::make_shared<PosePath>(std::vector<PoseSample>{{0.0, {probeToWorld, PoseStatus::ok}}}));
    session().makeImageNow();
    QVERIFY(waitUntil([this] { return wide().isSettled(); }));
  }
  void begin() const {
    holdAt(0.0);
    pressKey(Qt::Key_W, Qt::ControlModifier);
    QCOMPARE(wide().state(), WideScan::State::growing);
    session().makeImageNow();
    QVERIFY(waitUntil([this] { return wide().isSettled() && wide().growth().images == 1; }));
  }
  /// To the left and over the middle to the right.
  void sweep() const {
    for (double x = 5.0; x <= 50.0; x += 5.0) holdAt(x);
    for (double x = 45.0; x >= -50.0; x -= 5.0) holdAt(x);
  }
  void keep() const {
    pressKey(Qt::Key_F);
    QVERIFY(session().isFrozen());
    QVERIFY(waitUntil([this] { return wide().isSettled(); }));
    QCOMPARE(wide().state(), WideScan::State::kept);
    QVERIFY(session().wide() != nullptr);
  }
  /// Mean level of 5 x 5 mm about a point of the image plane, of what is shown.
  [[nodiscard]] double levelAt(const glm::dvec2& at_mm) const {
    const DisplayGeometry& shown = session().geometry();
    const ImageView<const std::uint8_t> grey = session().image().grey;
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < grey.height; ++y)
      for (int x = 0; x < grey.width; ++x) {
        const glm::dvec2 by_mm = glm::abs(shown.probePoint_mm(x, y) - at_mm);
        if (by_mm.x > 2.5 || by_mm.y > 2.5) continue;
        sum += grey.at(x, y);
        ++count;
      }
    return count > 0 ? sum / count : -1.0;
  }

 private Q_SLOTS:
  void init() {
    openConsole();
    window_->bodyMark().setShown(false);
    session().makeImageNow();
  }
  void cleanup() { window_.reset(); }

  void itGrowsInBothDirectionsAndShowsWhatEachImageShowed() {
    std::vector<std::pair<double, double>> single;
    for (const double x : {-50.0, -20.0, 0.0, 35.0, 50.0}) {
      holdAt(x);
      single.emplace_back(x, levelAt({0.0, 60.0}));
    }
    begin();
    const double first_mm = wide().growth().length_mm;
    for (double x = 5.0; x <= 50.0; x += 5.0) holdAt(x);
    QVERIFY(std::abs(wide().growth().length_mm - first_mm - 50.0) < 1.0);
    for (double x = 45.0; x >= -50.0; x -= 5.0) holdAt(x);
    QVERIFY(std::abs(wide().growth().length_mm - first_mm - 100.0) < 1.0);
    QCOMPARE(wide().growth().images, std::size_t{31});
    QVERIFY2(window_->findChild<WideLayer*>()->isVisible(), "where the probe is");
    keep();
    for (const auto& [x, level] : single)
      QVERIFY2(std::abs(levelAt({x, 60.0}) - level) < 4.0,
               qPrintable(QStringLiteral("%1: %2, not %3").arg(x).arg(levelAt({x, 60.0})).arg(level)));
    // The body's view shows the probe's own image.
    QVERIFY(session().fanGeometry().pixel_mm < session().geometry().pixel_mm);
    pressKey(Qt::Key_F);
    QVERIFY(!session().isFrozen() && session().wide() == nullptr && wide().state() == WideScan::State::off);
  }

  void aLengthOverTheWholeSweepIsTrueAndStaysSoMagnified() {
    begin();
    sweep();
    keep();
    Calipers& calipers = window_->calipers();
    calipers.take(measurement::CaliperKind::distance);
    QVERIFY(session().wide() != nullptr);
    auto& layer = *window_->findChild<CaliperLayer*>(QStringLiteral("caliperLayer"));
    const double pixel_mm = window_->scanView().mmPerWidgetPixel();
    const auto click = [&](const glm::dvec2& at_mm) {
      const QPointF at = layer.placeOf(at_mm);
      QTest::mouseClick(&layer, Qt::LeftButton, Qt::NoModifier,
                        {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))});
    };
    click({-72.0, 60.0});
    click({72.0, 60.0});
    QCOMPARE(calipers.lines().size(), std::size_t{1});
    const double length_mm = calipers.lines()[0].measured.figures[0].quantity.value;
    QVERIFY2(std::abs(length_mm - 144.0) < pixel_mm, qPrintable(QString::number(length_mm)));
    calipers.take(measurement::CaliperKind::distance);  // put down
    session().console().setDetail(3.0, {20.0, 0.0});
    QVERIFY(waitUntil([this] { return wide().isSettled(); }));
    QVERIFY(std::abs(session().console().detail().zoom - 3.0) < 1e-9 && window_->scanView().mmPerWidgetPixel() < pixel_mm / 2.9);
    QCOMPARE(knobs().zoom, 3.0);
    QVERIFY(window_->findChild<ZoomOverview*>()->isVisible());
    QCOMPARE(calipers.lines().size(), std::size_t{1});
    QCOMPARE(calipers.lines()[0].measured.figures[0].quantity.value, length_mm);
    // No farther than there is something.
    session().console().setDetail(3.0, {1e6, 0.0});
    QVERIFY(waitUntil([this] { return wide().isSettled(); }));
    QVERIFY(session().console().detail().pan.lateral_mm < 0.5 * wide().growth().length_mm);
    // The frozen image has its own calipers; the wide one's are there again when it is.
    pressKey(Qt::Key_Backspace, Qt::ControlModifier);
    window_->wideScan().toggle();
    QVERIFY(session().wide() == nullptr && session().isFrozen() && calipers.lines().empty());
    window_->wideScan().toggle();
    QVERIFY(waitUntil([this] { return wide().isSettled(); }));
    QVERIFY(session().wide() != nullptr);
    QCOMPARE(calipers.lines().size(), std::size_t{1});
  }

  void itIsSavedAsAnImageWithItsWords() {
    begin();
    sweep();
    keep();
    const QString file = files_.path(QStringLiteral("wide.png"));
    QVERIFY(writeShownImages({{&session(), &window_->calipers(), {}}}, 1, QDateTime::currentDateTime(), file.toStdString()));
    const QImage saved(file);
    QVERIFY(saved.width() >= session().image().width() && saved.height() > session().image().height());
  }

  void imagesThatLeaveThePlaneAreNamedAndNotWoven() {
    begin();
    const double degree = std::numbers::pi / 180.0;
    holdAt(4.0, 14.0 * degree);
    QVERIFY2(said().contains(QLatin1String("Tilted")), qPrintable(said()));
    holdAt(4.0);
    holdAt(4.0, 0.0, -30.0);
    QVERIFY2(said().contains(QLatin1String("Beside")), qPrintable(said()));
    holdAt(4.0);
    holdAt(80.0);
    QVERIFY2(said().contains(QLatin1String("Too fast")), qPrintable(said()));
    QCOMPARE(wide().growth().images, std::size_t{3});
    QCOMPARE(wide().growth().leftOut, std::size_t{3});
  }

  void escapeGivesItUpAndAnotherLoopImageHidesIt() {
    begin();
    sweep();
    pressKey(Qt::Key_Escape);
    QVERIFY(wide().state() == WideScan::State::off && session().wide() == nullptr && !session().isFrozen());
    begin();
    holdAt(10.0);
    keep();
    QVERIFY(session().cineLoop().ring().frameCount() > 3);
    window_->cineBar().step(-1);
    QCOMPARE(wide().state(), WideScan::State::hidden);
    QVERIFY(session().wide() == nullptr);
    pressKey(Qt::Key_W, Qt::ControlModifier);
    QCOMPARE(wide().state(), WideScan::State::kept);
    // Settings are refused with a word; the probe does not move.
    pressKey(Qt::Key_G);
    QVERIFY2(said().contains(QLatin1String("wide image")), qPrintable(said()));
  }

  void mModeHasNone() {
    press("modeM");
    session().makeImageNow();
    pressKey(Qt::Key_W, Qt::ControlModifier);
    QCOMPARE(wide().state(), WideScan::State::off);
    QVERIFY(!said().isEmpty());
  }

  void anotherSizeOfTheWindowShowsTheSameWidth() {
    begin();
    sweep();
    keep();
    window_->resize(1400, 800);
    QVERIFY(waitUntil([this] { return wide().isSettled() && session().geometry().width == session().imageSize_px().x; }));
    QCOMPARE(session().geometry().width, session().imageSize_px().x);
    QVERIFY(session().wide() != nullptr);
  }

  void itLooksAsItShould() {
    begin();
    sweep();
    keepScreenshot(*window_, "wide_growing");
    keep();
    keepScreenshot(*window_, "wide_kept");
    session().console().setDetail(3.0, {30.0, 0.0});
    QVERIFY(waitUntil([this] { return wide().isSettled(); }));
    keepScreenshot(*window_, "wide_zoomed");
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::WideImageTest)

#include "wide_image_test.moc"
