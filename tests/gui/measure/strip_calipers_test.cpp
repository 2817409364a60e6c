// Calipers in the strip of the M-mode, results over several images, and what points snap to: by scripted clicks, as a person measures.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/worksheets.h"
#include "gui/support/window_fixture.h"
#include "scanning/small_scan.h"

namespace ew::ui::testing {

using measurement::CaliperKind;
using measurement::CombinationKind;
using measurement::FigureKind;

class StripCalipersTest : public WindowFixture {
  Q_OBJECT

  static constexpr double kBeat_s = 0.8;

  [[nodiscard]] Calipers& calipers() const { return window_->calipers(); }
  [[nodiscard]] CaliperLayer& layer(const char* name) const { return *find<CaliperLayer>(name); }
  [[nodiscard]] CaliperLayer& image() const { return layer("caliperLayer"); }
  [[nodiscard]] CaliperLayer& strip() const { return layer("stripCaliperLayer"); }
  [[nodiscard]] const Calipers::Line& last() const { return calipers().lines().back(); }
  [[nodiscard]] double value(FigureKind kind) const { return last().measured.figure(kind)->quantity.value; }
  [[nodiscard]] double uncertainty(FigureKind kind) const { return last().measured.figure(kind)->quantity.uncertainty; }

  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window_->scanView(), key, modifiers);
  }
  void click(CaliperLayer& on, const QPoint& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::mouseClick(&on, Qt::LeftButton, modifiers, at);
  }
  void clickImage(const glm::dvec2& at_mm) const {
    const QPointF at = image().placeOf(at_mm);
    click(image(), {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))});
  }
  void move(CaliperLayer& over, const QPoint& to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QMouseEvent event(QEvent::MouseMove, QPointF(to), QPointF(over.mapToGlobal(to)), Qt::NoButton, Qt::NoButton, modifiers);
    QApplication::sendEvent(&over, &event);
  }

  /// A patient whose tissue below the probe pulses by up to 6 mm, once in 0.8 s: 75 a minute.
  void showPulse() const {
    ScanSubject subject = test::livingSubject();
    auto motion = std::make_shared<TissueMotion>(*subject.motion);
    motion->rhythms.breathing.reset();
    motion->rhythms.pulse = BodyRhythm{kBeat_s, 0.0};
    for (TissueMotion::Mode& mode : motion->modes)
      if (mode.kind == TissueMotion::Kind::pulse)
        for (glm::vec3& shift : mode.shift_mm) shift *= 10.0F;
    subject.motion = motion;
    subject.scene.liveEchoes.emplace();
    subject.scene.motion.emplace();
    session().show(subject);
    Hold hold;
    hold.contact.point_mm = {0.0, -29.0, 0.0};
    hold.contact.outward = {0.0, -1.0, 0.0};
    session().probeControl().setHold(hold);
    Knobs knobs = session().console().knobs();
    knobs.mode = DisplayMode::both;
    knobs.depth_mm = 60.0;
    session().console().setKnobs(knobs);
    session().makeImageNow();
    QVERIFY(calipers().hasStrip());
  }
  /// Until the strip shows so much. @return the columns drawn since
  void scanFor(double seconds) const {
    QVERIFY(waitUntil([&] {
      const MModeStrip& drawn = session().seen().mMode();
      const int newest =
          (session().seen().stripCursor() + session().seen().strip().width - 1) % std::max(1, session().seen().strip().width);
      const auto now = drawn.timeOf(newest);
      return now && drawn.columnOf(*now - seconds).has_value();
    }));
  }
  /// How much two columns differ, grey levels.
  [[nodiscard]] double difference(int a, int b) const {
    const ImageView<const std::uint8_t> drawn = session().seen().strip();
    double sum = 0.0;
    for (int y = 0; y < drawn.height; ++y) sum += std::abs(drawn.at(a, y) - drawn.at(b, y));
    return sum / drawn.height;
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
  }
  void cleanup() { window_.reset(); }

  void heartRateReadFromTheEchoesIsThatOfThePatient() {
    showPulse();
    scanFor(3.3);
    pressKey(Qt::Key_7, Qt::AltModifier);
    QCOMPARE(calipers().drawing().tool(), std::optional(CaliperKind::heartRate));
    QVERIFY2(!session().isFrozen(), "a tool of the strip lets the image run");
    find<QSpinBox>("heartBeats")->setValue(3);
    session().setFrozen(true);
    // From any column on: where do three beats later the echoes look the same?
    const int width = session().seen().strip().width, newest = (session().seen().stripCursor() + width - 1) % width;
    const double column_s = session().seen().mMode().columnTime_s();
    const auto before = [&](int columns) { return (newest - columns + width) % width; };
    const int first = static_cast<int>(3.2 / column_s);
    int best = 0;
    double least = 1e9;
    for (int beats = static_cast<int>(2.1 / column_s); beats <= static_cast<int>(2.7 / column_s); ++beats) {
      double sum = 0.0;
      for (int n = 0; n < static_cast<int>(0.5 / column_s); ++n) sum += difference(before(first - n), before(first - n - beats));
      if (sum < least) {
        least = sum;
        best = beats;
      }
    }
    // Half a beat earlier the wall may be as wide as it falls; within half a second it is not all the time.
    double moved = 0.0;
    for (int n = 0; n < static_cast<int>(0.5 / column_s); ++n)
      moved = std::max(moved, difference(before(first - n), before(first - n - best / 6)));
    QVERIFY2(moved > 4.0, "the pulse moves the echoes");
    click(strip(), {before(first), 40});
    click(strip(), {before(first - best), 60});
    QCOMPARE(calipers().lines().size(), std::size_t{1});
    const double rate = value(FigureKind::heartRate), truth = 60.0 / kBeat_s;
    const QString said = QStringLiteral("read %1 +- %2 a minute, truth %3").arg(rate).arg(uncertainty(FigureKind::heartRate)).arg(truth);
    qInfo("%s", qPrintable(said));
    QVERIFY2(uncertainty(FigureKind::heartRate) > 0.0, qPrintable(said));
    QVERIFY2(std::abs(rate - truth) <= 3.0 * uncertainty(FigureKind::heartRate) + 0.01 * truth, qPrintable(said));
    QVERIFY(std::abs(value(FigureKind::duration) - best * column_s) < 1e-9);
    // Listed with its own number, and what its uncertainty comes from.
    const auto lines = window_->findChildren<QPushButton*>(QStringLiteral("measuredLine"));
    QCOMPARE(lines.size(), 1);
    QVERIFY(lines[0]->accessibleName().startsWith(QLatin1String("M1 ")));
    QVERIFY2(find<QLabel>("measuredHow")->text().contains(QLatin1String("between two beams")),
             qPrintable(find<QLabel>("measuredHow")->text()));
    // Another number of beats is a step that goes back.
    find<QSpinBox>("heartBeats")->setValue(1);
    QVERIFY(std::abs(value(FigureKind::heartRate) - rate / 3.0) < 1e-9);
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(std::abs(value(FigureKind::heartRate) - rate) < 1e-9);
    // The image that is saved shows image, strip, and the results below them.
    const QDateTime at(QDate(2026, 1, 2), QTime(3, 4));
    QVERIFY(savedImage(session(), at, &calipers()).height() > 2 * session().seen().strip().height + 40);
  }

  void timeSlopeAndDepthAreThoseOfTheClicks() {
    showPulse();
    scanFor(2.0);
    session().setFrozen(true);
    const int width = session().seen().strip().width, newest = (session().seen().stripCursor() + width - 1) % width;
    const int right = newest > 150 ? newest - 20 : width - 20, left = right - 100;  // no seam between them
    const QPoint a(left, 30), b(right, 90);
    const double time_s = 100.0 * session().seen().mMode().columnTime_s();
    const double depth_mm = 60.0 * session().geometry().depth_mm / (session().seen().strip().height - 1);
    QVERIFY(session().seen().mMode().timeOf(left) && session().seen().mMode().timeOf(right));
    const auto measure = [&](Qt::Key key) {
      pressKey(key, Qt::AltModifier);
      click(strip(), a);
      click(strip(), b);
      pressKey(key, Qt::AltModifier);  // down again
    };
    measure(Qt::Key_6);
    QVERIFY(std::abs(value(FigureKind::duration) - time_s) < 1e-9);
    pressKey(Qt::Key_Delete, Qt::ControlModifier);
    measure(Qt::Key_8);
    QVERIFY(std::abs(value(FigureKind::slope) - depth_mm / time_s) < 1e-6 * depth_mm / time_s);
    pressKey(Qt::Key_Delete, Qt::ControlModifier);
    measure(Qt::Key_9);
    QVERIFY(std::abs(value(FigureKind::length) - depth_mm) < 1e-9);
    // A handle is dragged, and the step goes back.
    QTest::mousePress(&strip(), Qt::LeftButton, Qt::NoModifier, b);
    for (const int y : {95, 110, 120}) {
      QMouseEvent event(QEvent::MouseMove, QPointF(right, y), QPointF(strip().mapToGlobal(QPoint(right, y))), Qt::NoButton, Qt::LeftButton,
                        Qt::NoModifier);
      QApplication::sendEvent(&strip(), &event);
    }
    QTest::mouseRelease(&strip(), Qt::LeftButton, Qt::NoModifier, {right, 120});
    QVERIFY(std::abs(value(FigureKind::length) - 1.5 * depth_mm) < 1e-9);
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(std::abs(value(FigureKind::length) - depth_mm) < 1e-9);
  }

  void aDistanceMeasuresMillimetresInTheImageAndDepthInTheStrip() {
    showPulse();
    scanFor(1.0);
    pressKey(Qt::Key_4);
    QVERIFY(session().isFrozen());
    clickImage({-10.0, 30.0});
    clickImage({10.0, 30.0});
    QVERIFY(std::abs(value(FigureKind::length) - 20.0) <= session().geometry().pixel_mm);
    QVERIFY(last().where == Where::image);
    const int newest = (session().seen().stripCursor() + session().seen().strip().width - 1) % session().seen().strip().width;
    click(strip(), {newest - 10, 20});
    click(strip(), {newest - 5, 80});
    QCOMPARE(calipers().lines().size(), std::size_t{2});
    QVERIFY(last().where == Where::strip && last().measurement.caliper.kind == CaliperKind::depthDistance);
    // Tools that have no sense there say so, and where they have.
    pressKey(Qt::Key_9);
    click(strip(), {newest - 60, 50});  // away from the crosses
    QVERIFY2(window_->scanView().said().contains(QLatin1String("in the image")), qPrintable(window_->scanView().said()));
    pressKey(Qt::Key_7, Qt::AltModifier);
    clickImage({0.0, 20.0});
    QVERIFY2(window_->scanView().said().contains(QLatin1String("in the strip")), qPrintable(window_->scanView().said()));
    QCOMPARE(calipers().lines().size(), std::size_t{2});
    // Nothing is drawn in the seam.
    click(strip(), {newest + 3, 20});
    QVERIFY2(window_->scanView().said().contains(QLatin1String("Nothing is drawn there")), qPrintable(window_->scanView().said()));
  }

  void aLiveCaliperStaysWithItsEchoesAndInTheListWhenTheyHaveLeft() {
    showPulse();
    Knobs knobs = session().console().knobs();
    knobs.mSweep_s = 1.0;
    session().console().setKnobs(knobs);
    scanFor(0.4);
    pressKey(Qt::Key_6, Qt::AltModifier);
    const int newest = (session().seen().stripCursor() + session().seen().strip().width - 1) % session().seen().strip().width;
    click(strip(), {std::max(0, newest - 40), 20});
    click(strip(), {std::max(10, newest - 8), 20});
    QVERIFY(!session().isFrozen());
    QCOMPARE(calipers().lines().size(), std::size_t{1});
    const double duration_s = value(FigureKind::duration);
    const glm::dvec2 point = last().measurement.caliper.parts[0].points[0];
    const QPointF place = strip().placeOf(point);
    session().frames().ask();
    session().makeImageNow();
    if (!last().hasLeft) QCOMPARE(strip().placeOf(point), place);
    QVERIFY(waitUntil([this] { return last().hasLeft; }));
    QCOMPARE(value(FigureKind::duration), duration_s);
    QVERIFY(
        find<QPushButton>("measuredLine")->findChild<QLabel*>(QStringLiteral("measuredOthers"))->text().contains(QLatin1String("left")));
    QVERIFY2(find<QLabel>("measuredHow")->text().contains(QLatin1String("gone on")), qPrintable(find<QLabel>("measuredHow")->text()));
    // Frozen, the cine loop brings them back.
    session().setFrozen(true);
    const std::size_t then = session().cineLoop().ring().frameAt(point.x + 0.3);
    session().cineLoop().show(then);
    QVERIFY(waitUntil([this] { return !session().cineLoop().isForming(); }));
    QVERIFY(!last().hasLeft);
    // Another patient takes them away.
    session().show(test::livingSubject());
    QCOMPARE(calipers().lines().size(), std::size_t{0});
    QVERIFY(calipers().findings().isEmpty());
  }

  void ratioAndVolumeAreOfMeasurementsOfSeveralImages() {
    pressKey(Qt::Key_4);
    clickImage({-15.0, 60.0});
    clickImage({15.0, 60.0});
    clickImage({-30.0, 90.0});
    clickImage({30.0, 90.0});
    pressKey(Qt::Key_Space);  // on to another plane; its calipers go, what was measured stays
    session().probeControl().setHold(turned(session().probeControl().hold(), 0.0, 0.0, 0.05));
    session().makeImageNow();
    QCOMPARE(calipers().lines().size(), std::size_t{0});
    pressKey(Qt::Key_4);
    clickImage({0.0, 50.0});
    clickImage({0.0, 90.0});
    pressKey(Qt::Key_E, Qt::ControlModifier);
    auto* dialog = find<CombineDialog>("combineDialog");
    QVERIFY(dialog != nullptr && dialog->isVisible());
    auto* kind = dialog->findChild<QComboBox*>(QStringLiteral("combineKind"));
    const auto choose = [&](CombinationKind wanted, std::vector<int> inputs) {
      const int index = kind->findData(static_cast<int>(wanted));
      kind->setCurrentIndex(index);
      Q_EMIT kind->activated(index);
      for (std::size_t n = 0; n < inputs.size(); ++n) {
        auto* choice = dialog->findChild<QComboBox*>(QStringLiteral("combineInput%1").arg(n + 1));
        choice->setCurrentIndex(inputs[n]);
        Q_EMIT choice->activated(inputs[n]);
      }
    };
    const auto& findings = calipers().findings();
    QCOMPARE(findings.all().size(), std::size_t{3});
    const auto length = [&](std::size_t n) { return findings.all()[n].measured.figures[0].quantity.value; };
    choose(CombinationKind::reduction, {0, 1});
    QVERIFY(dialog->findChild<QLabel*>(QStringLiteral("combinedHow"))->text().contains(QLatin1String("correlation 0")));
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("combineAdd")), Qt::LeftButton);
    choose(CombinationKind::ellipsoid, {0, 1, 2});
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("combineAdd")), Qt::LeftButton);
    QCOMPARE(findings.combinations().size(), std::size_t{2});
    const auto result = [&](std::size_t n) { return findings.combine(findings.combinations()[n].kind, findings.combinations()[n].of); };
    QVERIFY(std::abs(result(0)->quantity.value - 100.0 * (1.0 - length(0) / length(1))) < 1e-9);
    QVERIFY(std::abs(result(1)->quantity.value - 3.14159265358979 / 6.0 * length(0) * length(1) * length(2) * 1e-3) < 1e-9);
    QVERIFY(result(1)->quantity.uncertainty > 0.0);
    const auto lines = window_->findChildren<QPushButton*>(QStringLiteral("resultLine"));
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines[0]->accessibleName().startsWith(QLatin1String("R1 ")) && lines[0]->accessibleName().contains(QLatin1Char('%')));
    // It follows the caliper that is moved.
    const double before = result(1)->quantity.value;
    const QPointF from = image().placeOf({0.0, 90.0});
    QTest::mousePress(&image(), Qt::LeftButton, Qt::NoModifier, from.toPoint());
    QMouseEvent moved(QEvent::MouseMove, from + QPointF(0, 20), QPointF(image().mapToGlobal((from + QPointF(0, 20)).toPoint())),
                      Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&image(), &moved);
    QTest::mouseRelease(&image(), Qt::LeftButton, Qt::NoModifier, (from + QPointF(0, 20)).toPoint());
    QVERIFY(result(1)->quantity.value > before);
    // All of it is written.
    const QString file = files_.path(QStringLiteral("measured.csv"));
    QVERIFY(writeMeasurements(findings, QStringLiteral("Test"), file.toStdString()).has_value());
    QFile csv(file);
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QByteArray text = csv.readAll();
    QVERIFY2(text.contains("result,2,ellipsoid") && text.contains("image 2,1,distance"), text.constData());
    // A result is chosen and deleted.
    QTest::mouseClick(lines[0], Qt::LeftButton);
    QVERIFY(find<QLabel>("resultHow")->isVisibleTo(window_.get()));
    QTest::mouseClick(find<QPushButton>("removeResult"), Qt::LeftButton);
    QCOMPARE(findings.combinations().size(), std::size_t{1});
    // A ratio of two kinds of quantities says why there is none.
    QApplication::setActiveWindow(window_.get());
    window_->scanView().setFocus();
    pressKey(Qt::Key_9);
    for (const glm::dvec2 at : {glm::dvec2(20.0, 40.0), glm::dvec2(20.0, 60.0), glm::dvec2(40.0, 60.0)}) clickImage(at);
    choose(CombinationKind::ratio, {0, 3});
    QVERIFY2(dialog->findChild<QLabel*>(QStringLiteral("combinedHow"))->text().contains(QLatin1String("one kind")),
             qPrintable(dialog->findChild<QLabel*>(QStringLiteral("combinedHow"))->text()));
    QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("combineAdd"))->isEnabled());
  }

  void aVolumeByDiscsIsAnAxisAndAnOutline() {
    pressKey(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(calipers().drawing().tool(), std::optional(CaliperKind::discs));
    for (const glm::dvec2 at : {glm::dvec2(-30.0, 70.0), glm::dvec2(30.0, 70.0), glm::dvec2(-30.0, 60.0), glm::dvec2(30.0, 60.0),
                                glm::dvec2(30.0, 80.0), glm::dvec2(-30.0, 80.0)})
      clickImage(at);
    clickImage({-30.0, 60.0});
    QCOMPARE(calipers().lines().size(), std::size_t{1});
    const double truth_ml = 3.14159265 * 100.0 * 60.0 * 1e-3;
    QVERIFY2(std::abs(value(FigureKind::volume) - truth_ml) <= 0.08 * truth_ml, qPrintable(QString::number(value(FigureKind::volume))));
    QVERIFY(uncertainty(FigureKind::volume) > 0.0);
  }

  void snappingShowsWhatItSnapsToBeforeTheClickAndIsRemembered() {
    auto* box = find<QCheckBox>("snapPoints");
    QVERIFY(!box->isChecked());
    pressKey(Qt::Key_4);
    clickImage({-20.0, 60.0});
    clickImage({20.0, 70.0});
    pressKey(Qt::Key_M, Qt::ControlModifier);
    QVERIFY(box->isChecked() && calipers().snaps());
    const QPoint cross = image().placeOf({20.0, 70.0}).toPoint();
    const QImage without = image().grab().toImage();
    move(image(), cross + QPoint(5, 3));
    QVERIFY(image().snap().kind == measurement::SnapKind::point);
    QCOMPARE(image().snap().number, 1);
    QVERIFY2(image().grab().toImage() != without, "a mark and a word");
    const glm::dvec2 end = calipers().lines()[0].measurement.caliper.parts[0].points[1];
    QCOMPARE(image().snap().at, end);
    // The first point is level with nothing; the second may be with the first. Ctrl: for once not.
    clickImage({-40.0, 100.0});
    const glm::dvec2 first = calipers().drawing().points().front();
    const QPoint level = image().placeOf({first.x + 35.0, first.y}).toPoint() + QPoint(0, 1);
    move(image(), level);
    if (image().snap().kind != measurement::SnapKind::edge) QVERIFY(image().snap().kind == measurement::SnapKind::horizontal);
    const glm::dvec2 shown = image().snap().at;
    move(image(), level, Qt::ControlModifier);
    QVERIFY(image().snap().kind == measurement::SnapKind::none);
    click(image(), level);
    QCOMPARE(last().measurement.caliper.parts[0].points[1], shown);
    pressKey(Qt::Key_M, Qt::ControlModifier);
    QVERIFY(!calipers().snaps());
    move(image(), cross + QPoint(5, 3));
    QVERIFY(image().snap().kind == measurement::SnapKind::none);
    box->click();
    QVERIFY(QSettings().value(QStringLiteral("calipersSnap")).toBool());
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::StripCalipersTest)
#include "strip_calipers_test.moc"
