// Calipers on the scan: measured by scripted clicks, as a person measures.
#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTranslator>
#include <algorithm>
#include <cmath>

#include "ew/core/progress.h"
#include "ew/library/case_truth.h"
#include "ew/ui_test_door/cine.h"
#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/worksheets.h"
#include "gui/support/answers.h"
#include "gui/support/case_aside.h"
#include "gui/support/window_fixture.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

using measurement::CaliperKind;
using measurement::FigureKind;

class CalipersTest : public WindowFixture {
  Q_OBJECT

  [[nodiscard]] Calipers& calipers() const { return window_->calipers(); }
  [[nodiscard]] CaliperLayer& layer() const { return *window_->findChild<CaliperLayer*>(QStringLiteral("caliperLayer")); }
  [[nodiscard]] double pixel_mm() const { return session().geometry().pixel_mm; }
  [[nodiscard]] std::size_t count() const { return calipers().lines().size(); }
  [[nodiscard]] const Calipers::Line& last() const { return calipers().lines().back(); }
  [[nodiscard]] const std::vector<glm::dvec2>& pointsOf(std::size_t index) const {
    return calipers().lines()[index].measurement.caliper.parts[0].points;
  }
  [[nodiscard]] double value(FigureKind kind) const { return last().measured.figure(kind)->quantity.value; }

  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window_->scanView(), key, modifiers);
  }
  /// The pixel of the layer that shows a point: what a person clicks who aims as well as pixels allow.
  [[nodiscard]] QPoint pixelOf(const glm::dvec2& at_mm) const {
    const QPointF at = layer().placeOf(at_mm);
    return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  }
  void click(const glm::dvec2& at_mm) const { QTest::mouseClick(&layer(), Qt::LeftButton, Qt::NoModifier, pixelOf(at_mm)); }
  /// With the button held, at once: a pointer that is moved on the screen comes when the screen has time.
  void dragTo(const glm::dvec2& at_mm) const {
    QMouseEvent move(QEvent::MouseMove, pixelOf(at_mm), layer().mapToGlobal(pixelOf(at_mm)), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&layer(), &move);
  }
  void take(Qt::Key key) const {
    QApplication::setActiveWindow(window_.get());
    window_->scanView().setFocus();
    pressKey(key);
    QVERIFY(calipers().drawing().tool().has_value());
    QVERIFY(layer().isVisible());
  }

  /// The plane of four or two points, their middle at the given depth; not turned, the first two lie along the rows of the image.
  struct Placed {
    Transform<frame::World, frame::Probe> probeToWorld;
    std::vector<glm::dvec2> points_mm;  ///< in the plane
  };
  [[nodiscard]] static Placed placed(const std::vector<glm::dvec3>& points_mm, double depth_mm, double turn) {
    const glm::dvec3 along = glm::normalize(points_mm[1] - points_mm[0]);
    glm::dvec3 across = points_mm.size() == 4 ? points_mm[3] - points_mm[2] : glm::dvec3(0.3, -0.2, 0.9);
    across = glm::normalize(across - glm::dot(across, along) * along);
    const glm::dvec3 x = std::cos(turn) * along + std::sin(turn) * across, y = std::cos(turn) * across - std::sin(turn) * along;
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& point : points_mm) middle += point / static_cast<double>(points_mm.size());
    Placed placed;
    placed.probeToWorld.matrix =
        glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(glm::cross(x, y), 0.0), glm::dvec4(middle - depth_mm * y, 1.0));
    for (const glm::dvec3& point : points_mm)
      placed.points_mm.emplace_back(glm::dot(point - middle, x), depth_mm + glm::dot(point - middle, y));
    return placed;
  }

  /// @param mostPixels that both ends of a line can be off along it, each on the middle of the pixel nearest to its place
  void measureExpected(const ReferenceMeasurement& expected, const Placed& at, double mostPixels) const {
    session().setFrozen(false);
    session().probeControl().follow(std::make_shared<PosePath>(std::vector<PoseSample>{{0.0, {at.probeToWorld, PoseStatus::ok}}}));
    session().makeImageNow();
    const bool isEllipse = at.points_mm.size() == 4;
    take(isEllipse ? Qt::Key_7 : Qt::Key_4);
    QVERIFY(session().isFrozen());
    for (std::size_t n = 0; n < (isEllipse ? 3U : 2U); ++n) click(at.points_mm[n]);
    QCOMPARE(count(), std::size_t{1});
    const double read_mm = value(isEllipse ? FigureKind::circumference : FigureKind::length);
    // A circumference is pi times the mean of two diameters.
    const double allowed_mm = (isEllipse ? 3.15 : 1.0) * mostPixels * pixel_mm();
    const QString said = QStringLiteral("%1: read %2, truth %3, a pixel is %4 mm")
                             .arg(QString::fromStdString(expected.name))
                             .arg(read_mm)
                             .arg(expected.value)
                             .arg(pixel_mm());
    QVERIFY2(std::abs(read_mm - expected.value) <= allowed_mm, qPrintable(said));
    QVERIFY(last().measured.figures.front().quantity.uncertainty > 0.0);
    qInfo("%s", qPrintable(said));
  }

 private Q_SLOTS:
  void initTestCase() { initTranslations(); }
  void init() {
    QSettings().clear();
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
  }
  void cleanup() { window_.reset(); }

  void everyToolHasItsWordBesideItsIcon() {
    for (const CaliperKind kind : measurement::drawnKinds()) {
      const auto* button = window_->findChild<QPushButton*>(CaliperWords::iconOf(kind));
      QVERIFY(button != nullptr);
      QCOMPARE(button->text(), CaliperWords::nameOf(kind));
      QVERIFY(!button->icon().isNull());
    }
  }

  void theirListFitsIntoItsPageInGermanToo() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QApplication::installTranslator(&german);
    cleanup();
    init();
    window_->resize(1024, 640);
    QWidget* page = find<QWidget>("measurePage");
    window_->findChild<ConsolePanel*>()->showPage(page);
    take(Qt::Key_4);
    click({-8.0, 50.0});
    click({9.0, 50.0});
    QCOMPARE(count(), std::size_t{1});
    QVERIFY(page->isVisible());
    const QScrollArea* scroll = nullptr;
    for (QWidget* above = page; above != nullptr && scroll == nullptr; above = above->parentWidget())
      scroll = qobject_cast<QScrollArea*>(above);
    QVERIFY(scroll != nullptr);
    QVERIFY(waitUntil([&] { return scroll->horizontalScrollBar()->maximum() == 0; }));
    for (const char* name : {"removeCaliper", "clearCalipers", "combineMeasurements", "saveMeasurements"}) {
      const auto* button = find<QPushButton>(name);
      QVERIFY2(button->width() >= button->minimumSizeHint().width() && button->parentWidget()->rect().contains(button->geometry()), name);
    }
    QApplication::removeTranslator(&german);
  }

  void theirIconsAreSeenInEitherTheme() {
    for (const bool dark : {false, true}) {
      window_->setDarkTheme(dark);
      for (const CaliperKind kind : measurement::drawnKinds()) {
        const QImage painted = window_->findChild<QPushButton*>(CaliperWords::iconOf(kind))->icon().pixmap(24, 24).toImage();
        int seen = 0;
        for (int y = 0; y < painted.height(); ++y)
          for (int x = 0; x < painted.width(); ++x)
            seen += qAlpha(painted.pixel(x, y)) > 200 && (qGray(painted.pixel(x, y)) > 128) == dark ? 1 : 0;
        QVERIFY2(seen > 4, qPrintable(CaliperWords::nameOf(kind)));
      }
    }
  }

  void toolsShareALineWhereTheirWordsHaveRoom() {
    using Lines = std::vector<int>;
    QCOMPARE(buttonsOnLines({50, 60, 70}, 204, 4), (Lines{2, 1}));
    QCOMPARE(buttonsOnLines({100, 100}, 204, 4), (Lines{2}));
    QCOMPARE(buttonsOnLines({100, 101, 50, 50}, 204, 4), (Lines{1, 1, 2}));
    QCOMPARE(buttonsOnLines({150, 20, 20}, 204, 4), (Lines{1, 2}));
    QCOMPARE(buttonsOnLines({20, 20}, 0, 4), (Lines{1, 1}));
    QVERIFY(buttonsOnLines({}, 204, 4).empty());
  }

  void targetsOfShippedCasesReadWithinAPixelOfTheTruth() {
    const auto folder = shippedCasesFolder();
    QVERIFY(folder.has_value());
    int measured = 0;
    for (const Case& shipped : listCasesAside(*folder).cases) {
      if (shipped.measurements.empty()) continue;
      const auto truth = loadCaseTruth(shipped, noProgress());
      QVERIFY2(truth.has_value(), shipped.id.c_str());
      for (const ReferenceMeasurement& expected : truth->measurements) {
        if (expected.points_mm.size() != 2 && expected.points_mm.size() != 4) continue;  // volumes
        for (const double turn : {0.0, 0.5}) {
          measureExpected(expected, placed(expected.points_mm, 75.0, turn), std::abs(std::cos(turn)) + std::abs(std::sin(turn)));
          if (QTest::currentTestFailed()) return;
        }
        ++measured;
      }
    }
    session().probeControl().follow(nullptr);
    QVERIFY2(measured >= 18, qPrintable(QString::number(measured)));
  }

  void toolKeyFreezesAndALiveImageTakesTheCalipersAway() {
    QVERIFY(!session().isFrozen());
    take(Qt::Key_4);
    QVERIFY(session().isFrozen());
    click({-20.0, 60.0});
    click({20.0, 60.0});
    QCOMPARE(count(), std::size_t{1});
    QVERIFY(std::abs(value(FigureKind::length) - 40.0) <= pixel_mm());
    // The same tool once more puts it down; what is measured stays.
    pressKey(Qt::Key_4);
    QVERIFY(!calipers().drawing().tool());
    QVERIFY(layer().isVisible());
    pressKey(Qt::Key_Space);
    QVERIFY(!session().isFrozen());
    QCOMPARE(count(), std::size_t{0});
    QVERIFY(!layer().isVisible());
  }

  void calipersStayAtTheirTissueWhenTheWindowChanges() {
    take(Qt::Key_4);
    click({-20.0, 60.0});
    click({20.0, 90.0});
    const auto before = pointsOf(0);
    const QPoint pixelBefore = pixelOf(before[1]);
    const double uncertainty = last().measured.figures[0].quantity.uncertainty, pixelWas_mm = pixel_mm();
    window_->resize(1040, 660);
    QVERIFY(waitUntil([&] { return std::abs(pixel_mm() - pixelWas_mm) > 1e-3 && layer().geometry() == window_->scanView().imageRect(); }));
    QCOMPARE(pointsOf(0), before);
    QVERIFY(pixelOf(before[1]) != pixelBefore);
    const Point<frame::Probe> there = window_->scanView().pointAt(window_->scanView().positionOf({{20.0, 90.0, 0.0}}));
    QVERIFY(glm::distance(there.at, glm::dvec3(20.0, 90.0, 0.0)) < 1e-9);
    QVERIFY(last().measured.figures[0].quantity.uncertainty != uncertainty);  // other pixels
  }

  void handlesAreDraggedAndEveryStepGoesBack() {
    take(Qt::Key_4);
    click({-20.0, 60.0});
    click({20.0, 60.0});
    QTest::mousePress(&layer(), Qt::LeftButton, Qt::NoModifier, pixelOf(pointsOf(0)[1]));
    for (const double x : {22.0, 25.0, 30.0}) dragTo({x, 60.0});
    QTest::mouseRelease(&layer(), Qt::LeftButton, Qt::NoModifier, pixelOf({30.0, 60.0}));
    QVERIFY(std::abs(value(FigureKind::length) - 50.0) <= pixel_mm());
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(std::abs(value(FigureKind::length) - 40.0) <= pixel_mm());
    pressKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(std::abs(value(FigureKind::length) - 50.0) <= pixel_mm());
    pressKey(Qt::Key_Backspace);
    QCOMPARE(count(), std::size_t{0});
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t{1});
    QVERIFY(!window_->document().hasUnsavedChanges());
    QTest::mouseClick(find<QPushButton>("clearCalipers"), Qt::LeftButton);
    QCOMPARE(count(), std::size_t{0});
    QTest::mouseClick(find<QPushButton>("undoCaliper"), Qt::LeftButton);
    QCOMPARE(count(), std::size_t{1});
  }

  void eachImageOfTheCineLoopKeepsItsOwn() {
    for (int n = 0; n < 6; ++n) {
      session().probeControl().setHold(turned(session().probeControl().hold(), 0.0, 0.0, 0.02));
      session().makeImageNow();
    }
    take(Qt::Key_4);
    click({-20.0, 60.0});
    click({20.0, 60.0});
    const auto first = pointsOf(0);
    pressKey(Qt::Key_Comma);
    QCOMPARE(count(), std::size_t{0});
    QCOMPARE(calipers().drawing().tool(), std::optional(CaliperKind::distance));
    click({-10.0, 60.0});
    click({20.0, 60.0});
    QVERIFY(std::abs(value(FigureKind::length) - 30.0) <= pixel_mm());
    pressKey(Qt::Key_Period);
    QCOMPARE(count(), std::size_t{1});
    QCOMPARE(pointsOf(0), first);
    pressKey(Qt::Key_Z, Qt::ControlModifier);  // of this image
    QCOMPARE(count(), std::size_t{0});
    pressKey(Qt::Key_Comma);
    QCOMPARE(count(), std::size_t{1});
    // Playing goes past images; a click pauses it and sets the point.
    pressKey(Qt::Key_C);
    QVERIFY(window_->cineBar().isPlaying());
    click({-5.0, 50.0});
    QVERIFY(!window_->cineBar().isPlaying());
    QCOMPARE(calipers().drawing().points().size(), std::size_t{1});
    pressKey(Qt::Key_Space);
    QCOMPARE(count(), std::size_t{0});
  }

  void anOutlineFollowsTheEdgeWhileTheWindowGoesOn() {
    take(Qt::Key_6);
    pressKey(Qt::Key_0);
    const std::vector<glm::dvec2> clicks{{-20.0, 50.0}, {20.0, 50.0}, {20.0, 90.0}, {-20.0, 90.0}};
    for (const glm::dvec2& at : clicks) click(at);
    click(clicks[0]);
    QCOMPARE(count(), std::size_t{1});
    QCOMPARE(pointsOf(0).size(), clicks.size());
    QVERIFY(waitUntil([&] { return pointsOf(0).size() > clicks.size() || !window_->scanView().said().isEmpty(); }));
    QVERIFY2(pointsOf(0).size() > 20, qPrintable(window_->scanView().said()));
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(pointsOf(0).size(), clicks.size());
    // What was taken away meanwhile stays away.
    click({-25.0, 40.0});
    pressKey(Qt::Key_Return);
    pressKey(Qt::Key_Delete, Qt::ControlModifier);
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
    QCOMPARE(count(), std::size_t{0});
  }

  void severalToolsListTheirResults() {
    take(Qt::Key_5);
    for (const glm::dvec2 at : {glm::dvec2(-30.0, 40.0), glm::dvec2(-30.0, 60.0), glm::dvec2(-10.0, 60.0)}) click(at);
    pressKey(Qt::Key_Return);
    QVERIFY(std::abs(value(FigureKind::length) - 40.0) <= 2.0 * pixel_mm());
    take(Qt::Key_6);
    for (const glm::dvec2 at : {glm::dvec2(0.0, 70.0), glm::dvec2(20.0, 70.0), glm::dvec2(20.0, 90.0), glm::dvec2(0.0, 90.0)}) click(at);
    click({0.0, 70.0});
    QVERIFY(std::abs(value(FigureKind::area) - 400.0) <= 40.0 * pixel_mm());
    take(Qt::Key_8);
    for (int n = 0; n < 6; ++n) click({-20.0 + 15.0 * std::cos(n), 100.0 + 10.0 * std::sin(n)});
    pressKey(Qt::Key_Return);
    QVERIFY(std::abs(value(FigureKind::longAxis) - 30.0) <= 3.0 * pixel_mm());
    take(Qt::Key_9);
    for (const glm::dvec2 at : {glm::dvec2(30.0, 40.0), glm::dvec2(30.0, 60.0), glm::dvec2(50.0, 60.0)}) click(at);
    QVERIFY(std::abs(value(FigureKind::angle) - 90.0) <= 2.0);
    QCOMPARE(count(), std::size_t{4});
    const auto lines = window_->findChildren<QPushButton*>(QStringLiteral("measuredLine"));
    QCOMPARE(lines.size(), 4);
    QStringList values;
    for (const QPushButton* line : lines) {
      const QString beside = line->findChild<QLabel*>(QStringLiteral("measuredValue"))->text();
      values << beside + line->findChild<QLabel*>(QStringLiteral("measuredBelow"))->text();
      for (const QLabel* each : line->findChildren<QLabel*>())
        QVERIFY2(!each->isVisible() || each->width() >= each->sizeHint().width() - 1, qPrintable(each->text()));
    }
    QVERIFY2(std::all_of(values.begin(), values.end(), [](const QString& text) { return text.contains(QStringLiteral(" ± ")); }),
             qPrintable(values.join(QStringLiteral("; "))));
    // A line of the list chooses its caliper, and says where the uncertainty comes from.
    QTest::mouseClick(lines[1], Qt::LeftButton);
    QCOMPARE(calipers().drawing().selected(), 2);
    QVERIFY(find<QLabel>("measuredHow")->text().contains(QLatin1String("beam")));
    QTest::mouseClick(find<QPushButton>("removeCaliper"), Qt::LeftButton);
    QCOMPARE(count(), std::size_t{3});
    QCOMPARE(calipers().lines()[1].measurement.number, 3);
  }

  void everythingGoesByKeysAlone() {
    take(Qt::Key_4);
    pressKey(Qt::Key_Left);  // the cross comes in the middle of the image and moves
    pressKey(Qt::Key_Return);
    QCOMPARE(calipers().drawing().points().size(), std::size_t{1});
    for (int n = 0; n < 3; ++n) pressKey(Qt::Key_Right, Qt::ShiftModifier);
    pressKey(Qt::Key_Right);
    pressKey(Qt::Key_Left, Qt::ControlModifier);
    pressKey(Qt::Key_Return);
    QCOMPARE(count(), std::size_t{1});
    QVERIFY(std::abs(value(FigureKind::length) - 99.0 * pixel_mm()) < 1e-9);
    // Enter takes the handle below the cross, arrows carry it, Enter puts it down.
    pressKey(Qt::Key_Return);
    QVERIFY(calipers().drawing().isDragging());
    pressKey(Qt::Key_Right, Qt::ControlModifier);
    pressKey(Qt::Key_Return);
    QVERIFY(!calipers().drawing().isDragging());
    QVERIFY(std::abs(value(FigureKind::length) - 100.0 * pixel_mm()) < 1e-9);
    pressKey(Qt::Key_Escape);  // the tool
    QVERIFY(!calipers().drawing().tool());
    QCOMPARE(count(), std::size_t{1});
    pressKey(Qt::Key_Delete, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t{0});
  }

  void savedImageCarriesTheCalipersAndTheirResults() {
    take(Qt::Key_4);
    const QDateTime at(QDate(2026, 1, 2), QTime(3, 4));
    const QImage bare = savedImage(session(), at, &calipers());
    QCOMPARE(bare, savedImage(session(), at));
    click({-20.0, 60.0});
    click({20.0, 60.0});
    const QImage saved = savedImage(session(), at, &calipers());
    QVERIFY(saved.height() > bare.height());
    // White where the ends are crossed, right of the margin that centres the image.
    const int left = (saved.width() - 56 - session().geometry().width) / 2, top = 58;
    const glm::dvec2 end = pointsOf(0)[1];
    const QPoint pixel = pixelOf(end) + QPoint(left, top);
    QVERIFY2(qGray(saved.pixel(pixel)) > 230, qPrintable(QString::number(qGray(saved.pixel(pixel)))));
    const QString file = files_.path(QStringLiteral("measured.png"));
    QVERIFY(writeShownImages({{&session(), &calipers(), {}}}, 1, at, file.toStdString()).has_value());
    QVERIFY(QImage(file).size() == saved.size());
  }

  void theQuestionCountsWhatWasMeasuredForNoItemAndIsNotSaved() {
    const auto draw = [this](double depth_mm) {
      click({-20.0, depth_mm});
      click({20.0, depth_mm});
    };
    const auto unsaved = [this] { return calipers().unsavedCount(); };
    take(Qt::Key_4);
    draw(40.0);
    draw(50.0);
    QCOMPARE(count(), std::size_t{2});
    QCOMPARE(unsaved(), std::size_t{2});
    const auto image = *calipers().image();
    calipers().combine(measurement::CombinationKind::ratio, {{image, calipers().lines()[0].measurement.number, FigureKind::length},
                                                             {image, calipers().lines()[1].measurement.number, FigureKind::length}});
    QCOMPARE(unsaved(), std::size_t{3});
    {
      const Answers answers({{QStringLiteral("fileDialog"), testing::type(files_.path(QStringLiteral("measured.csv")))}});
      for (QAction* each : window_->findChildren<QAction*>())
        if (each->text().startsWith(QStringLiteral("&Save measurements"))) each->trigger();
      QCOMPARE(answers.asked, QStringList{QStringLiteral("fileDialog")});
    }
    QCOMPARE(unsaved(), std::size_t{0});
    // What stands in a worksheet is the worksheet's.
    window_->worksheets().choose("abdomen");
    window_->worksheets().measure("AORTA", "");
    QApplication::setActiveWindow(window_.get());
    draw(60.0);
    QCOMPARE(count(), std::size_t{3});
    QCOMPARE(unsaved(), std::size_t{0});
    QVERIFY(window_->worksheets().unsaved() != nullptr);
    calipers().changeIn(Where::image, [](measurement::CaliperDrawing& drawing) { drawing.take(CaliperKind::distance, {}); });
    draw(70.0);
    QCOMPARE(count(), std::size_t{4});
    QCOMPARE(unsaved(), std::size_t{1});
    const Answers answers({{QStringLiteral("unsavedWorksheetQuestion"), press(QMessageBox::Discard)},
                           {QStringLiteral("unsavedMeasurementsQuestion"), press(QMessageBox::Cancel)}});
    QVERIFY(!window_->close());
    QCOMPARE(answers.asked, (QStringList{QStringLiteral("unsavedWorksheetQuestion"), QStringLiteral("unsavedMeasurementsQuestion")}));
    QVERIFY2(answers.texts.last().endsWith(QStringLiteral(" 1.")), qPrintable(answers.texts.last()));
  }

  void whereOnlyTheStripIsShownADistanceIsOneOfDepthAndTheRestIsRefusedWithAWord() {
    Knobs knobs = session().console().knobs();
    knobs.mode = DisplayMode::mMode;
    session().console().setKnobs(knobs);
    session().makeImageNow();
    pressKey(Qt::Key_4);
    QCOMPARE(calipers().drawing().tool(), std::optional(CaliperKind::depthDistance));
    pressKey(Qt::Key_9);
    QCOMPARE(calipers().drawing().tool(), std::optional(CaliperKind::depthDistance));
    QVERIFY(window_->scanView().said().contains(QLatin1String("M-mode")));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::CalipersTest)
#include "calipers_test.moc"
