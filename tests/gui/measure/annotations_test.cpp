// Texts, arrows, body mark and presets in the window, as a person uses them.
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCursor>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QSvgRenderer>
#include <QTranslator>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/library/case.h"
#include "ew/phantom/body_shape.h"
#include "ew/scanning/preset.h"
#include "ew/ui_test_door/annotate.h"
#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/measure.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

using annotation::AnnotationKind;

class AnnotationsTest : public WindowFixture {
  Q_OBJECT

  [[nodiscard]] ImageAnnotations& annotated() const { return window_->annotated(); }
  [[nodiscard]] AnnotationLayer& layer() const { return *window_->findChild<AnnotationLayer*>(); }
  [[nodiscard]] ImageBodyMark& mark() const { return window_->bodyMark(); }
  [[nodiscard]] ScanView& scan() const { return window_->scanView(); }

  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &scan(), key, modifiers);
  }
  void freeze() const {
    scan().setFocus();
    session().setFrozen(true);
    session().makeImageNow();
  }
  /// Where a point of the image's plane is, on the scan view.
  [[nodiscard]] QPoint at(const glm::dvec2& at_mm) const {
    return (layer().placeOf(at_mm) + QPointF(scan().imageRect().topLeft())).toPoint();
  }
  void drag(const QPoint& from, const QPoint& to, QWidget* on = nullptr) const {
    QWidget* widget = on != nullptr ? on : &scan();
    const QPoint offset = widget->mapTo(&scan(), QPoint(0, 0));
    QTest::mousePress(widget, Qt::LeftButton, Qt::NoModifier, from - offset);
    for (int n = 1; n <= 4; ++n) QTest::mouseMove(widget, from - offset + (to - from) * n / 4);
    QTest::mouseRelease(widget, Qt::LeftButton, Qt::NoModifier, to - offset);
  }
  void write(const glm::dvec2& at_mm, const std::string& text) const {
    QVERIFY(annotated().hold());
    annotated().change([&](annotation::AnnotationList& list) { list.addText(at_mm, text); });
  }
  [[nodiscard]] static bool isNear(const glm::dvec2& a, const glm::dvec2& b, double within_mm) { return glm::length(a - b) <= within_mm; }

  [[nodiscard]] QAction* preset(const QString& id) const {
    auto* menu = window_->findChild<QMenu*>(QStringLiteral("presetMenu"));
    Q_EMIT menu->aboutToShow();
    QList<QAction*> actions = menu->actions();
    for (const QMenu* inner : menu->findChildren<QMenu*>()) actions += inner->actions();
    const auto found = std::find_if(actions.begin(), actions.end(), [&](const QAction* each) { return each->data().toString() == id; });
    return found != actions.end() ? *found : nullptr;
  }

  /// A probe across the body, the marker to the patient's right, turned by `angle_rad` about its beam.
  void scanFrom(const glm::dvec3& at_mm, double angle_rad) const {
    const glm::dvec3 marker(-std::cos(angle_rad), 0.0, std::sin(angle_rad)), beam(0.0, 1.0, 0.0);
    const Transform<frame::World, frame::Probe> probeToWorld{
        {glm::dvec4(marker, 0.0), glm::dvec4(beam, 0.0), glm::dvec4(glm::cross(marker, beam), 0.0), glm::dvec4(at_mm, 1.0)}};
    session().probeControl().follow(std::make_shared<PosePath>(std::vector<PoseSample>{{0.0, {probeToWorld, PoseStatus::ok}}}));
    session().makeImageNow();
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    qputenv("ECHOWEAVE_PRESETS", files_.path(QStringLiteral("presets")).toUtf8());
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
    scan().setFocus();
    QCursor::setPos(window_->mapToGlobal(QPoint(2, 2)));  // a text begins at the pointer when that is over the image
    QVERIFY(waitUntil([this] { return !scan().underMouse(); }));
  }
  void cleanup() { window_.reset(); }

  void textIsTypedAtHomeWithTheWordsOfTheRegion() {
    freeze();
    pressKey(Qt::Key_T);
    QVERIFY(layer().isWriting());
    QCOMPARE(QApplication::focusWidget(), &layer().field());
    QTest::keyClicks(&layer().field(), QStringLiteral("rt kid"));
    pressKey(Qt::Key_Tab);
    QCOMPARE(layer().field().text(), QStringLiteral("RT KIDNEY"));
    QTest::keyClicks(&layer().field(), QStringLiteral(" long"));
    pressKey(Qt::Key_Return);
    QVERIFY(!layer().isWriting());
    QCOMPARE(annotated().all().size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(annotated().all()[0].text), QStringLiteral("RT KIDNEY long"));
    const QRect image = scan().imageRect();
    const glm::dvec2 share = annotated().home().share;
    const QPointF home = QPointF(image.topLeft()) + QPointF(share.x * image.width(), share.y * image.height());
    const QPointF there = layer().placeOf(annotated().all()[0].at_mm) + QPointF(image.topLeft());
    QVERIFY(std::hypot(there.x() - home.x(), there.y() - home.y()) < 1.5);
    QVERIFY(layer().isVisible());
  }

  void aTextBeginsAtThePointerOverTheImage() {
    freeze();
    const QPoint there = scan().imageRect().center() + QPoint(30, 40);
    QCursor::setPos(scan().mapToGlobal(there));
    QVERIFY(waitUntil([this] { return scan().underMouse(); }));
    pressKey(Qt::Key_T);
    QTest::keyClicks(&layer().field(), QStringLiteral("CYST"));
    pressKey(Qt::Key_Return);
    const QPointF placed = layer().placeOf(annotated().all().at(0).at_mm) + QPointF(scan().imageRect().topLeft());
    QVERIFY(std::hypot(placed.x() - there.x(), placed.y() - there.y()) < 2.5);
  }

  void aWordOfTheListThatIsOfferedIsTakenByKeys() {
    freeze();
    pressKey(Qt::Key_T);
    QTest::keyClicks(&layer().field(), QStringLiteral("port"));
    auto* popup = qobject_cast<QAbstractItemView*>(QApplication::activePopupWidget());
    QVERIFY(popup != nullptr);
    QCOMPARE(popup->model()->index(0, 0).data().toString(), QStringLiteral("PORTAL VEIN"));
    QTest::keyClick(popup, Qt::Key_Down);
    QTest::keyClick(popup, Qt::Key_Down);
    QTest::keyClick(popup, Qt::Key_Return);
    QCOMPARE(layer().field().text(), QStringLiteral("PORTA HEPATIS"));
    QVERIFY(layer().isWriting());
    pressKey(Qt::Key_Return);
    QCOMPARE(QString::fromStdString(annotated().all().at(0).text), QStringLiteral("PORTA HEPATIS"));
  }

  void theKeyTakesTheTransducerWhileTheImageRunsAndWritesOnceItStands() {
    QVERIFY(!session().isFrozen());
    pressKey(Qt::Key_T);
    QVERIFY(!layer().isWriting());
    QVERIFY(!session().isFrozen());
    pressKey(Qt::Key_T, Qt::ControlModifier);
    QVERIFY(session().isFrozen());
    QVERIFY(layer().isWriting());
    pressKey(Qt::Key_Escape);
    QVERIFY(!layer().isWriting());
    QVERIFY(annotated().all().empty());
  }

  void aTextThatIsBegunPutsTheCaliperDownAndAClickSaysWhereItStands() {
    freeze();
    window_->calipers().take(measurement::CaliperKind::distance);
    QVERIFY(window_->calipers().drawing().tool().has_value());
    pressKey(Qt::Key_T);
    QVERIFY(layer().isWriting());
    QVERIFY(!window_->calipers().drawing().tool().has_value());
    QTest::mouseClick(&scan(), Qt::LeftButton, Qt::NoModifier, at({5.0, 60.0}));
    QVERIFY2(layer().isWriting(), "the click says where the text stands");
    QVERIFY(window_->calipers().drawing().points().empty());
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("odd"));
    pressKey(Qt::Key_Return);
    QCOMPARE(annotated().all().size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(annotated().all()[0].text), QStringLiteral("odd"));
    QVERIFY(isNear(annotated().all()[0].at_mm, {5.0, 60.0}, 1.0));
  }

  void lettersThatAreKeysElsewhereAreTyped() {
    freeze();
    const Knobs before = session().console().knobs();
    pressKey(Qt::Key_T);
    QTest::keyClicks(&layer().field(), QStringLiteral("tfgn 4, z"));
    QCOMPARE(layer().field().text(), QStringLiteral("tfgn 4, z"));
    QVERIFY(session().isFrozen());
    QVERIFY(session().console().knobs() == before);
  }

  void arrowIsDrawnMovedByItsEndsAndTakenBack() {
    pressKey(Qt::Key_T, Qt::ShiftModifier);
    QVERIFY(session().isFrozen());
    QVERIFY(annotated().isArrowAtHand());
    drag(at({-20.0, 50.0}), at({10.0, 70.0}));
    QVERIFY(!annotated().isArrowAtHand());
    QCOMPARE(annotated().all().size(), std::size_t{1});
    const double pixel = 1.5 * session().geometry().pixel_mm;
    QVERIFY(annotated().all()[0].kind == AnnotationKind::arrow);
    QVERIFY(isNear(annotated().all()[0].tail_mm, {-20.0, 50.0}, pixel));
    QVERIFY(isNear(annotated().all()[0].at_mm, {10.0, 70.0}, pixel));
    drag(at({10.0, 70.0}), at({20.0, 60.0}));
    QVERIFY(isNear(annotated().all()[0].at_mm, {20.0, 60.0}, 2.0 * pixel));
    QVERIFY(isNear(annotated().all()[0].tail_mm, {-20.0, 50.0}, pixel));
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(isNear(annotated().all()[0].at_mm, {10.0, 70.0}, pixel));
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(annotated().all().empty());
    pressKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(annotated().all().size(), std::size_t{1});
  }

  void aTextIsMovedWrittenAnewAndDeleted() {
    freeze();
    write({20.0, 60.0}, "LIVER");
    QVERIFY(layer().isVisible());
    // It is written to the right of its place, which is towards -x where the marker is at the left.
    const QPoint on = at({18.0, 60.0});
    drag(on, on + QPoint(0, 40));
    const double moved_mm = 40.0 * scan().mmPerWidgetPixel();
    QVERIFY(isNear(annotated().all()[0].at_mm, {20.0, 60.0 + moved_mm}, 0.6));
    QCOMPARE(annotated().selected(), annotated().all()[0].number);
    QTest::mouseDClick(&scan(), Qt::LeftButton, Qt::NoModifier, on + QPoint(0, 40));
    QVERIFY(layer().isWriting());
    QCOMPARE(layer().field().text(), QStringLiteral("LIVER"));
    layer().field().setText(QStringLiteral("RT LOBE"));
    pressKey(Qt::Key_Return);
    QCOMPARE(QString::fromStdString(annotated().all()[0].text), QStringLiteral("RT LOBE"));
    QTest::mouseClick(&scan(), Qt::LeftButton, Qt::NoModifier, on + QPoint(0, 40));
    QVERIFY(annotated().selected() != 0);
    pressKey(Qt::Key_Backspace);
    QCOMPARE(QString::fromStdString(annotated().all()[0].text), QStringLiteral("RT"));
    pressKey(Qt::Key_Delete);
    QVERIFY(annotated().all().empty());
  }

  void aRunningImageTakesThemAway() {
    freeze();
    write({0.0, 50.0}, "LIVER");
    pressKey(Qt::Key_Space);
    QVERIFY(!session().isFrozen());
    QVERIFY(annotated().all().empty());
    QVERIFY(!layer().isVisible());
  }

  void calipersAndTextsAreEachTakenByTheirPlaceAndUndoneInTheirOrder() {
    freeze();
    write({30.0, 40.0}, "LIVER");
    pressKey(Qt::Key_4);
    auto* calipers = window_->findChild<CaliperLayer*>(QStringLiteral("caliperLayer"));
    const auto click = [&](const glm::dvec2& at_mm) {
      QTest::mouseClick(calipers, Qt::LeftButton, Qt::NoModifier, at(at_mm) - calipers->mapTo(&scan(), QPoint(0, 0)));
    };
    click({-20.0, 60.0});
    click({20.0, 60.0});
    QCOMPARE(window_->calipers().lines().size(), std::size_t{1});
    pressKey(Qt::Key_4);  // the tool is put down
    const auto before = window_->calipers().lines()[0].measurement;
    drag(at({28.0, 40.0}), at({28.0, 40.0}) + QPoint(0, 30), calipers);
    QVERIFY(annotated().all()[0].at_mm.y > 45.0);
    QVERIFY(window_->calipers().lines()[0].measurement == before);
    const double textAt = annotated().all()[0].at_mm.y;
    drag(at({20.0, 60.0}), at({25.0, 60.0}), calipers);
    QVERIFY(!(window_->calipers().lines()[0].measurement == before));
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window_->calipers().lines()[0].measurement == before);
    QCOMPARE(annotated().all()[0].at_mm.y, textAt);
  }

  void theHomePositionIsKept() {
    freeze();
    write({10.0, 70.0}, "LIVER");
    annotated().select(annotated().all()[0].number);
    layer().setHomeHere();
    const QRect image = scan().imageRect();
    const QPointF there = layer().placeOf({10.0, 70.0});
    QVERIFY(std::abs(annotated().home().share.x - there.x() / image.width()) < 0.01);
    QVERIFY(std::abs(annotated().home().share.y - there.y() / image.height()) < 0.01);
    ImageAnnotations later(session());
    QVERIFY(later.home() == annotated().home());
  }

  void theBodyMarkFollowsTheProbe() {
    auto* view = find<BodyMarkView>("bodyMark");
    QVERIFY(view != nullptr);
    QVERIFY(view->isVisible());
    for (const double angle : {0.0, 0.6, std::numbers::pi / 2.0}) {
      scanFrom({-40.0, -95.0, -60.0}, angle);
      QVERIFY(mark().mark() != nullptr);
      QCOMPARE(QString::fromStdString(mark().mark()->id), QStringLiteral("abdomen"));
      QVERIFY(mark().glyph().has_value());
      QVERIFY(mark().glyph()->place.x < 0.45);  // the patient's right is at the left of the drawing
      // Across it points to the left; turned from the patient's right to the head it points up.
      QVERIFY(std::abs(std::remainder(mark().glyph()->angle_rad - (std::numbers::pi + angle), 2.0 * std::numbers::pi)) < 1e-9);
    }
    session().probeControl().follow(nullptr);
  }

  void theMarkLeavesResultsToBeRead() {
    auto* view = find<BodyMarkView>("bodyMark");
    scanFrom({0.0, -95.0, -60.0}, 0.0);
    freeze();
    view->placeIn(0);
    QVERIFY(scan().resultsRect().isEmpty());
    window_->calipers().changeIn(Where::image, [](measurement::CaliperDrawing& drawing) {
      drawing.take(measurement::CaliperKind::distance, {});
      for (const glm::dvec2 at : {glm::dvec2(-8.0, 50.0), glm::dvec2(9.0, 50.0)}) {
        drawing.press(at, 1.0);
        drawing.release(at, 1.0);
      }
    });
    const QRect results = scan().resultsRect();
    QVERIFY(!results.isEmpty());
    QVERIFY(scan().rect().contains(results));
    for (const int corner : {0, 1, 2, 3}) {
      view->placeIn(corner);
      QVERIFY2(!view->geometry().intersects(results), qPrintable(QString::number(corner)));
    }
    session().probeControl().follow(nullptr);
  }

  void theMarkIsMovedHiddenAndPutByHandOnAFrozenImage() {
    auto* view = find<BodyMarkView>("bodyMark");
    scanFrom({0.0, -95.0, -60.0}, 0.0);
    const QPoint glyph(static_cast<int>(mark().glyph()->place.x * view->width()),
                       static_cast<int>(mark().glyph()->place.y * view->height()));
    const auto followed = *mark().glyph();
    // While the image runs a drag on the probe moves the whole mark: up, into the upper left corner.
    QCOMPARE(view->corner(), 2);
    drag(view->mapTo(&scan(), glyph), view->mapTo(&scan(), glyph) - QPoint(0, 400), view);
    QVERIFY(*mark().glyph() == followed);
    QCOMPARE(view->corner(), 0);
    freeze();
    QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, glyph);
    QTest::mouseMove(view, glyph + QPoint(20, 10));
    QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, glyph + QPoint(20, 10));
    QVERIFY(mark().choice().byHand.has_value());
    QVERIFY(mark().glyph()->place.x > followed.place.x + 0.1);
    QTest::mouseDClick(view, Qt::LeftButton, Qt::NoModifier, QPoint(4, 4));
    QVERIFY(*mark().glyph() == followed);
    pressKey(Qt::Key_B, Qt::ControlModifier);
    QVERIFY(!view->isVisible());
    pressKey(Qt::Key_B, Qt::ControlModifier);
    QVERIFY(view->isVisible());
    session().probeControl().follow(nullptr);
  }

  void savedImageCarriesTextsArrowsAndMark() {
    scanFrom({0.0, -95.0, -60.0}, 0.0);
    freeze();
    const QDateTime when(QDate(2026, 1, 2), QTime(3, 4));
    const QImage bare = savedImage(session(), when);
    const auto changedIn = [&](const QImage& image, const QRect& where) {
      int changed = 0;
      for (int y = where.top(); y <= where.bottom(); ++y)
        for (int x = where.left(); x <= where.right(); ++x) changed += image.pixel(x, y) != bare.pixel(x, y) ? 1 : 0;
      return changed;
    };
    const QImage marked = savedImage(session(), when, {nullptr, nullptr, &mark()});
    QCOMPARE(marked.size(), bare.size());
    QVERIFY(changedIn(marked, marked.rect()) > 500);
    QCOMPARE(changedIn(marked, QRect(0, 0, marked.width(), marked.height() / 2)), 0);  // it lies in the lower left corner
    write({0.0, 40.0}, "LIVER");
    annotated().change([](annotation::AnnotationList& list) { list.addArrow({-30.0, 60.0}, {-10.0, 50.0}); });
    const QImage written = savedImage(session(), when, {nullptr, &annotated(), nullptr});
    QCOMPARE(written.size(), bare.size());
    QVERIFY(changedIn(written, written.rect()) > 300);
    QVERIFY(savedImage(session(), when, {nullptr, &annotated(), &mark()}) != written);
    session().probeControl().follow(nullptr);
  }

  void aPresetSetsConsoleWordsAndMark() {
    QAction* aorta = preset(QStringLiteral("aorta-convex-3.5"));
    QVERIFY(aorta != nullptr);
    QVERIFY(aorta->isEnabled());
    Knobs knobs = session().console().knobs();
    knobs.quality = Quality::cubic;
    session().console().setKnobs(knobs);
    aorta->trigger();
    const auto expected = readPreset(resourceFolder().value() / "presets" / "aorta-convex-3.5.json");
    QVERIFY(expected.has_value());
    QVERIFY(session().console().knobs() == applied(*expected, knobs));
    QCOMPARE(session().console().depth_mm(), 140.0);
    QVERIFY(session().console().knobs().quality == Quality::cubic);
    QCOMPARE(QString::fromStdString(annotated().wordList()->id), QStringLiteral("vessels"));
    session().makeImageNow();
    QCOMPARE(QString::fromStdString(mark().mark()->id), QStringLiteral("aorta"));
    // A machine refuses settings while its image stands.
    session().setFrozen(true);
    preset(QStringLiteral("abdomen-convex-3.5"))->trigger();
    QCOMPARE(session().console().depth_mm(), 140.0);
    QVERIFY(!scan().said().isEmpty());
  }

  void ownPresetsAreOfferedBesideTheShippedOnes() {
    Knobs knobs = session().console().knobs();
    knobs.depth_mm = 195.0;
    QVERIFY(saveOwnPreset(presetOf("Mine & yours", session().console().probe(), knobs), ownPresetsFolder()).has_value());
    QAction* mine = preset(QStringLiteral("mine-yours-convex-3-5"));
    QVERIFY(mine != nullptr);
    QCOMPARE(mine->text(), QStringLiteral("Mine && yours"));
    mine->trigger();
    QCOMPARE(session().console().depth_mm(), 195.0);
  }

  /// Every drawing can be read at the smallest size it is shown in.
  void everyDrawingIsLegibleFrom64To128Pixels() {
    const auto marks = annotation::readBodyMarks(resourceFolder().value() / "body_marks");
    QVERIFY(marks.has_value());
    std::vector<std::filesystem::path> drawings;
    for (const annotation::BodyMark& each : *marks) {
      drawings.push_back(each.drawing);
      for (const annotation::MarkVariant& variant : each.variants) drawings.push_back(variant.drawing);
    }
    QVERIFY(drawings.size() >= 13);
    for (const auto& drawing : drawings) {
      QSvgRenderer renderer(QString::fromStdString(drawing.string()));
      QVERIFY2(renderer.isValid(), drawing.c_str());
      QCOMPARE(renderer.viewBox(), QRect(0, 0, 128, 128));
      for (const int side : {64, 96, 128}) {
        QImage image(side, side, QImage::Format_Grayscale8);
        image.fill(Qt::black);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        renderer.render(&painter, QRectF(0, 0, side, side));
        painter.end();
        int bright = 0;
        for (int y = 0; y < side; ++y)
          bright +=
              static_cast<int>(std::count_if(image.constScanLine(y), image.constScanLine(y) + side, [](uchar grey) { return grey > 90; }));
        QVERIFY2(2 * bright >= 3 * side, qPrintable(QString::fromStdString(drawing.string()) + QString::number(bright)));
        QVERIFY2(bright <= side * side / 4, qPrintable(QString::fromStdString(drawing.string()) + QString::number(bright)));
      }
    }
  }

  /// The outline of a drawing is that of the mannequin it was drawn after, so that the probe lies where it lies on the body.
  void outlinesAreThoseOfTheMannequins_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("mannequin");
    QTest::addColumn<double>("highest_mm");
    QTest::addColumn<double>("lowest_mm");
    QTest::newRow("abdomen") << "abdomen"
                             << "adult" << -20.0 << -380.0;
    QTest::newRow("trunk") << "trunk"
                           << "adult-arms-up" << 0.0 << -380.0;
    QTest::newRow("womb") << "womb"
                          << "gravid" << -70.0 << -400.0;
    QTest::newRow("flank-right") << "flank-right"
                                 << "adult-arms-up" << 40.0 << -280.0;
    QTest::newRow("flank-left") << "flank-left"
                                << "adult-arms-up" << 40.0 << -280.0;
    QTest::newRow("neck-front") << "neck-front"
                                << "neck-extended" << 300.0 << 220.0;
    QTest::newRow("neck-right") << "neck-right"
                                << "neck-extended" << 290.0 << 210.0;
    QTest::newRow("neck-left") << "neck-left"
                               << "neck-extended" << 290.0 << 210.0;
  }
  void outlinesAreThoseOfTheMannequins() {
    QFETCH(QString, id);
    QFETCH(QString, mannequin);
    QFETCH(double, highest_mm);
    QFETCH(double, lowest_mm);
    const auto resources = resourceFolder().value();
    const auto read = annotation::readBodyMark(resources / "body_marks" / (id.toStdString() + ".json"));
    QVERIFY(read.has_value());
    const auto shape = readBodyShape(resources / "mannequin" / (mannequin.toStdString() + ".json"));
    QVERIFY(shape.has_value());
    constexpr int kSide = 512;
    QImage image(kSide, kSide, QImage::Format_Grayscale8);
    image.fill(Qt::black);
    QPainter painter(&image);
    QSvgRenderer(QString::fromStdString(read->drawing.string())).render(&painter, QRectF(0, 0, kSide, kSide));
    painter.end();
    const bool isFront = read->view == annotation::MarkView::front;
    double worst_mm = 0.0;
    QStringList rows;
    for (double z = highest_mm; z >= lowest_mm; z -= 40.0) {
      // What of the body is seen in this row: from the middle outwards, so that arms count no more than in the drawing.
      const auto isBody = [&](double along_mm) {
        for (double depth_mm = isFront ? -160.0 : 0.0; depth_mm <= 160.0; depth_mm += 8.0) {
          const glm::dvec3 p = isFront ? glm::dvec3(along_mm, depth_mm, z) : glm::dvec3(depth_mm, along_mm, z);
          if ((*shape)->signedDistance_mm(p) < 0.0) return true;
        }
        return false;
      };
      double low_mm = isFront ? 0.0 : 20.0, high_mm = low_mm;
      while (isBody(low_mm - 2.0)) low_mm -= 2.0;
      while (isBody(high_mm + 2.0)) high_mm += 2.0;
      const auto placeOfEdge = [&](double along_mm) {
        return placeOn(*read, {isFront ? glm::dvec3(along_mm, 0.0, z) : glm::dvec3(0.0, along_mm, z)});
      };
      double left = placeOfEdge(low_mm).x, right = placeOfEdge(high_mm).x;
      if (left > right) std::swap(left, right);
      const uchar* row = image.constScanLine(static_cast<int>(placeOfEdge(0.0).y * kSide));
      const auto isLine = [](uchar grey) { return grey > 190; };
      const auto first = static_cast<double>(std::find_if(row, row + kSide, isLine) - row);
      double last = kSide - 1;
      while (last > 0.0 && !isLine(row[static_cast<int>(last)])) --last;
      const double half = 0.5 * 2.0 / 128.0;  // the middle of the line
      const double off_mm = read->side_mm * std::max(std::abs(first / kSide + half - left), std::abs((last + 1.0) / kSide - half - right));
      rows << QStringLiteral("z %1: drawn %2 to %3, body %4 to %5")
                  .arg(z)
                  .arg(first / kSide + half)
                  .arg((last + 1.0) / kSide - half)
                  .arg(left)
                  .arg(right);
      worst_mm = std::max(worst_mm, off_mm);
    }
    QVERIFY2(worst_mm <= 0.025 * read->side_mm, qPrintable(QStringLiteral("%1 mm\n").arg(worst_mm) + rows.join(QLatin1Char('\n'))));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::AnnotationsTest)
#include "annotations_test.moc"
