// Two and four images at once: each with its own console, cine loop, calipers and words; one in hand.
#include <QAction>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>
#include <cmath>

#include "ew/scanning/scanner.h"
#include "ew/ui_test_door/annotate.h"
#include "ew/ui_test_door/cine.h"
#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/worksheets.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

using measurement::FigureKind;

/// How often a widget and what lies in it is painted.
class Paints final : public QObject {
 public:
  explicit Paints(QWidget& of) : of_(of) {
    of_.installEventFilter(this);
    for (QWidget* each : of_.findChildren<QWidget*>()) each->installEventFilter(this);
  }
  int count = 0;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count;
    return QObject::eventFilter(watched, event);
  }

 private:
  QWidget& of_;
};

class ImagesTest : public WindowFixture {
  Q_OBJECT

  [[nodiscard]] ImageGrid& grid() const { return window_->images(); }
  [[nodiscard]] Calipers& calipers() const { return window_->calipers(); }
  [[nodiscard]] CaliperLayer& layer() const { return *window_->scanView().findChild<CaliperLayer*>(QStringLiteral("caliperLayer")); }
  [[nodiscard]] ImageTile& kept(int place) const { return *grid().kept(place); }
  void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(&window_->scanView(), key, modifiers);
  }
  void pressNext() const { pressKey(Qt::Key_L, Qt::ShiftModifier); }
  void clickOn(int place) const {
    QTest::mouseClick(&kept(place), Qt::LeftButton);
    QVERIFY(waitUntil([&] { return grid().active() == place; }));
  }
  void setDepth(double depth_mm) const {
    Knobs knobs = session().console().knobs();
    knobs.depth_mm = depth_mm;
    session().console().setKnobs(knobs);
    session().makeImageNow();
    QCOMPARE(session().geometry().depth_mm, depth_mm);
  }
  void setGain(double gain_db) const {
    Knobs knobs = session().console().knobs();
    knobs.gain_db = gain_db;
    session().console().setKnobs(knobs);
    session().makeImageNow();
  }
  /// By clicks on two pixels of the layer that lie `pixels` beside each other.
  void measure(int pixels) const {
    QApplication::setActiveWindow(window_.get());
    window_->scanView().setFocus();
    pressKey(Qt::Key_4);
    QVERIFY(calipers().drawing().tool().has_value());
    QVERIFY(layer().isVisible());
    const QPoint from(layer().width() / 2 - pixels / 2, layer().height() / 2);
    QTest::mouseClick(&layer(), Qt::LeftButton, Qt::NoModifier, from);
    QTest::mouseClick(&layer(), Qt::LeftButton, Qt::NoModifier, from + QPoint(pixels, 0));
    QTest::keyClick(&layer(), Qt::Key_Escape);
    QVERIFY(!calipers().drawing().tool());
  }
  [[nodiscard]] static double length_mm(const Calipers& of) {
    return of.lines().back().measured.figure(FigureKind::length)->quantity.value;
  }
  void comparesInPixels(const Calipers& of, const Session& on, int pixels) const {
    QCOMPARE(of.lines().size(), std::size_t{1});
    const double expected_mm = pixels * on.geometry().pixel_mm;
    QVERIFY2(std::abs(length_mm(of) - expected_mm) < 1e-9, qPrintable(QStringLiteral("%1, not %2").arg(length_mm(of)).arg(expected_mm)));
  }
  /// The image of a state as a maker of its own makes it.
  [[nodiscard]] static std::vector<std::uint8_t> madeAnew(const Session& of) {
    Scanner scanner;
    scanner.show(*of.subject());
    const ImageView<const std::uint8_t> image = scanner.make(of.shownState(), of.image().width(), of.image().height()).grey;
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < image.height; ++y) pixels.insert(pixels.end(), image.row(y), image.row(y) + image.width);
    return pixels;
  }
  void scanForAWhile(int frames) const {
    for (int n = 0; n < frames; ++n) {
      session().probeControl().setHold(turned(session().probeControl().hold(), 0.01, 0.0, 0.01));
      session().makeImageNow();
      QTest::qWait(2);
    }
  }
  /// Looks from the front of the trunk, this far to the patient's left.
  void lookAt(double left_mm) const {
    Transform<frame::World, frame::Probe> probeToWorld;
    probeToWorld.matrix =
        glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(left_mm, -100, 0, 1));
    session().probeControl().follow(std::make_shared<PosePath>(std::vector<PoseSample>{{0.0, {probeToWorld, PoseStatus::ok}}}));
    session().makeImageNow();
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
    window_->scanView().setFocus();
    window_->bodyMark().setShown(false);  // it lies where small images are clicked
  }
  void cleanup() { window_.reset(); }

  void severalImagesGiveTheirRoomToTheFans() {
    window_->resize(1600, 900);
    QTest::qWait(50);
    for (const int count : {2, 4}) {
      grid().setCount(count);
      QTest::qWait(50);
      session().makeImageNow();
      const ScanView& view = window_->scanView();
      int left = view.width(), right = 0, rows = 0;
      for (const auto& runs : session().seen().spans()) {
        if (runs.empty()) continue;
        left = std::min(left, static_cast<int>(runs[0].begin));
        right = std::max(right, static_cast<int>(runs[runs.size() - 1].end));
        ++rows;
      }
      // The fan is as wide as the cell or as high as the room between its lines of words.
      QVERIFY2(
          right - left > view.width() * 9 / 10 || rows > (view.height() - 96) * 95 / 100,
          qPrintable(QStringLiteral("%1: %2 of %3, %4 of %5").arg(count).arg(right - left).arg(view.width()).arg(rows).arg(view.height())));
      QVERIFY(!find<QSlider>("dgc1")->isVisible());
    }
    grid().setCount(1);
    QTest::qWait(20);
    QVERIFY(find<QSlider>("dgc1")->isVisible());
  }

  void keyAndButtonsGoToTwoAndFourAndBack() {
    const QSize alone = window_->scanView().size();
    QCOMPARE(grid().count(), 1);
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(grid().count(), 2);
    QVERIFY(window_->scanView().width() < alone.width());
    QVERIFY(kept(1).isEmpty());
    QVERIFY(kept(1).isVisible());
    QVERIFY(!kept(1).view().isVisible());
    QVERIFY(!session().isFrozen());
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(grid().count(), 4);
    QCOMPARE(window_->scanView().size(), kept(3).size());
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(grid().count(), 1);
    QCOMPARE(window_->scanView().size(), alone);
    QTest::mouseClick(find<QPushButton>("twoPictures"), Qt::LeftButton);
    QCOMPARE(grid().count(), 2);
    QVERIFY(find<QPushButton>("twoPictures")->isChecked());
    QTest::mouseClick(find<QPushButton>("twoPictures"), Qt::LeftButton);
    QVERIFY(find<QPushButton>("twoPictures")->isChecked());
    QTest::mouseClick(find<QPushButton>("onePicture"), Qt::LeftButton);
    QCOMPARE(window_->scanView().size(), alone);
    QVERIFY(!find<QPushButton>("nextPicture")->isVisible());
  }

  void eachImageKeepsItsConsoleItsCalipersAndItsUndo() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    setDepth(160.0);
    setGain(3.0);
    pressKey(Qt::Key_F);
    measure(100);
    comparesInPixels(calipers(), session(), 100);
    const std::vector<std::uint8_t> left = pixelsOf(session());
    const double leftLength_mm = length_mm(calipers());

    pressNext();  // where there is none yet: it runs
    QCOMPARE(grid().active(), 1);
    QVERIFY(!session().isFrozen());
    QVERIFY(kept(0).session().isFrozen());
    QVERIFY(pixelsOf(kept(0).session()) == left);
    QCOMPARE(calipers().lines().size(), std::size_t{0});
    comparesInPixels(kept(0).calipers(), kept(0).session(), 100);
    QCOMPARE(session().console().knobs().gain_db, 3.0);  // it begins with the console as it was
    setDepth(80.0);
    setGain(-6.0);
    QCOMPARE(kept(0).session().geometry().depth_mm, 160.0);
    pressKey(Qt::Key_F);
    measure(100);
    comparesInPixels(calipers(), session(), 100);
    const double rightLength_mm = length_mm(calipers());
    QVERIFY2(rightLength_mm < 0.7 * leftLength_mm, qPrintable(QString::number(rightLength_mm)));
    const std::vector<std::uint8_t> right = pixelsOf(session());

    clickOn(0);
    QVERIFY(session().isFrozen());
    QVERIFY(pixelsOf(session()) == left);
    QCOMPARE(session().console().knobs().depth_mm, 160.0);
    QCOMPARE(session().console().knobs().gain_db, 3.0);
    QCOMPARE(length_mm(calipers()), leftLength_mm);
    pressKey(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(calipers().lines().size(), std::size_t{0});
    QCOMPARE(length_mm(kept(1).calipers()), rightLength_mm);
    pressKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(length_mm(calipers()), leftLength_mm);

    pressNext();
    QCOMPARE(grid().active(), 1);
    QVERIFY(session().isFrozen());
    QVERIFY(pixelsOf(session()) == right);
    QCOMPARE(length_mm(calipers()), rightLength_mm);
    QCOMPARE(session().console().knobs().gain_db, -6.0);
    // Let run, it goes on with its own settings, and the other one stays.
    pressKey(Qt::Key_F);
    session().makeImageNow();
    QVERIFY(!session().isFrozen());
    QCOMPARE(session().geometry().depth_mm, 80.0);
    QCOMPARE(calipers().lines().size(), std::size_t{0});
    QCOMPARE(length_mm(kept(0).calipers()), leftLength_mm);
  }

  void aRunningScanGoesOnInTheNextImageWithItsOwnSettings() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    setDepth(160.0);
    pressNext();
    setDepth(90.0);
    pressNext();
    QVERIFY(!session().isFrozen());
    QVERIFY(kept(1).session().isFrozen());
    QCOMPARE(session().console().knobs().depth_mm, 160.0);
    session().makeImageNow();
    QCOMPARE(session().geometry().depth_mm, 160.0);
    QCOMPARE(kept(1).session().geometry().depth_mm, 90.0);
    // The mouse looks at the other one and lets nothing run.
    clickOn(1);
    QVERIFY(session().isFrozen());
    QVERIFY(kept(0).session().isFrozen());
  }

  void whatStandsBesideCostsNothingPerFrame() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    for (int n = 0; n < 3; ++n) pressNext();
    QCOMPARE(grid().active(), 3);
    QTest::qWait(50);
    const std::uint64_t made[] = {kept(0).session().frames().framesMade(), kept(1).session().frames().framesMade(),
                                  kept(2).session().frames().framesMade()};
    Paints first(kept(0)), second(kept(1)), third(kept(2));
    const auto paints = [&] { return first.count + second.count + third.count; };
    for (int before = -1; before != paints();) {  // what is still to be shown of them
      before = paints();
      QTest::qWait(200);
    }
    const int shown = paints();
    const std::uint64_t live = session().frames().framesMade();
    scanForAWhile(30);
    QVERIFY(session().frames().framesMade() >= live + 30);
    for (int place = 0; place < 3; ++place) QCOMPARE(kept(place).session().frames().framesMade(), made[place]);
    QCOMPARE(paints(), shown);
  }

  void anotherSizeIsFormedSharpFromTheState() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    scanForAWhile(3);
    pressNext();
    const QSize before(kept(0).session().image().width(), kept(0).session().image().height());
    window_->resize(1500, 860);
    QVERIFY(waitUntil([&] { return kept(0).session().image().width() > before.width(); }));
    QVERIFY(waitUntil([&] { return !kept(0).session().cineLoop().isForming(); }));
    QVERIFY(pixelsOf(kept(0).session()) == madeAnew(kept(0).session()));
  }

  void eachImageHasItsOwnCineLoop() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    Knobs knobs = session().console().knobs();
    knobs.persistence = 0.6;
    session().console().setKnobs(knobs);
    scanForAWhile(6);
    pressKey(Qt::Key_F);
    CineBar& bar = window_->cineBar();
    QVERIFY(bar.isOpen());
    pressKey(Qt::Key_Comma);
    pressKey(Qt::Key_Comma);
    QVERIFY(waitUntil([&] { return !session().cineLoop().isForming(); }));
    const std::size_t count = session().cineLoop().ring().frameCount(), at = *session().cineLoop().frame();
    QCOMPARE(at + 3, count);
    const std::vector<std::uint8_t> back = pixelsOf(session());

    pressNext();
    QVERIFY(!bar.isOpen());
    QVERIFY(pixelsOf(kept(0).session()) == back);
    scanForAWhile(3);
    pressKey(Qt::Key_F);
    QVERIFY(bar.isOpen());
    QVERIFY(session().cineLoop().ring().frameCount() < count);
    const std::size_t others = session().cineLoop().ring().frameCount();

    clickOn(0);
    QVERIFY(bar.isOpen());
    QCOMPARE(session().cineLoop().ring().frameCount(), count);
    QCOMPARE(bar.review().frame(), at);
    QVERIFY(pixelsOf(session()) == back);
    pressKey(Qt::Key_Period);
    QVERIFY(waitUntil([&] { return !session().cineLoop().isForming(); }));
    QCOMPARE(*session().cineLoop().frame(), at + 1);
    QVERIFY(pixelsOf(session()) != back);
    pressKey(Qt::Key_Comma);
    QVERIFY(waitUntil([&] { return !session().cineLoop().isForming(); }));
    QVERIFY(pixelsOf(session()) == back);
    pressNext();
    QCOMPARE(session().cineLoop().ring().frameCount(), others);
    QCOMPARE(*session().cineLoop().frame(), others - 1);
    QCOMPARE(bar.review().frame(), others - 1);
  }

  void calipersOfACineImageAreThereAgain() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    scanForAWhile(4);
    pressKey(Qt::Key_F);
    measure(60);
    pressKey(Qt::Key_Comma);
    QVERIFY(waitUntil([&] { return calipers().lines().empty(); }));
    pressNext();
    pressKey(Qt::Key_F);
    clickOn(0);
    QCOMPARE(calipers().lines().size(), std::size_t{0});
    pressKey(Qt::Key_Period);
    QVERIFY(waitUntil([&] { return calipers().lines().size() == 1; }));
    comparesInPixels(calipers(), session(), 60);
  }

  void wordsAndBodyMarkBelongToTheirImage() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    pressKey(Qt::Key_F);
    ImageAnnotations& annotated = window_->annotated();
    QVERIFY(annotated.hold());
    annotated.change([](annotation::AnnotationList& list) { list.addText({0.0, 30.0}, "LEFT"); });
    ImageBodyMark& mark = window_->bodyMark();
    mark.setShown(true);
    mark.putByHand(annotation::ProbeGlyph{{0.25, 0.75}, 1.0});
    pressNext();
    QVERIFY(annotated.all().empty());
    QVERIFY(!mark.choice().byHand);
    QCOMPARE(kept(0).annotated().all().size(), std::size_t{1});
    QVERIFY(kept(0).mark().choice().byHand == (annotation::ProbeGlyph{{0.25, 0.75}, 1.0}));
    QVERIFY(kept(0).mark().mark() != nullptr);
    pressKey(Qt::Key_F);
    measure(40);
    clickOn(0);
    QCOMPARE(annotated.all().size(), std::size_t{1});
    QVERIFY(mark.choice().byHand == (annotation::ProbeGlyph{{0.25, 0.75}, 1.0}));
    pressKey(Qt::Key_Z, Qt::ControlModifier);  // what was written here; the caliper lies on the other one
    QVERIFY(annotated.all().empty());
    QCOMPARE(kept(1).calipers().lines().size(), std::size_t{1});
  }

  void oneScaleForAll() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    setDepth(160.0);
    pressKey(Qt::Key_F);
    measure(50);
    const double length = length_mm(calipers());
    pressNext();
    setDepth(80.0);
    const double own_mm = session().geometry().pixel_mm, other_mm = kept(0).session().geometry().pixel_mm;
    QVERIFY(own_mm < 0.7 * other_mm);
    QTest::mouseClick(find<QPushButton>("sameScale"), Qt::LeftButton);
    session().makeImageNow();
    QCOMPARE(kept(0).session().geometry().pixel_mm, other_mm);
    const double now_mm = session().geometry().pixel_mm;
    QVERIFY2(std::abs(now_mm / other_mm - 1.0) < 0.01, qPrintable(QString::number(now_mm / other_mm)));
    QCOMPARE(session().geometry().depth_mm, 80.0);  // nothing but its size on the screen
    QCOMPARE(length_mm(kept(0).calipers()), length);
    pressKey(Qt::Key_F);
    measure(50);
    comparesInPixels(calipers(), session(), 50);
    QTest::mouseClick(find<QPushButton>("sameScale"), Qt::LeftButton);
    QVERIFY(waitUntil([&] { return session().geometry().pixel_mm == own_mm; }));
  }

  void namesSayTheSideOfThePatient() {
    lookAt(-50.0);
    QVERIFY(window_->scanView().label().isEmpty());
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(window_->scanView().label(), QStringLiteral("1 right"));
    pressKey(Qt::Key_F);
    measure(70);
    pressNext();
    lookAt(50.0);
    QCOMPARE(window_->scanView().label(), QStringLiteral("2 left"));
    QCOMPARE(kept(0).view().label(), QStringLiteral("1 right"));
    pressKey(Qt::Key_F);
    measure(30);
    // One list for both.
    QStringList names;
    QVERIFY(waitUntil([&] {  // what is added to a page is shown with the next turn of the event loop
      names.clear();
      for (const QLabel* each : window_->findChildren<QLabel*>(QStringLiteral("measuredPicture")))
        if (!each->isHidden()) names << each->text();
      return names.size() == 2;
    }));
    QCOMPARE(names, (QStringList{QStringLiteral("Image 2 left"), QStringLiteral("Image 1 right")}));
    QPushButton* elsewhere = nullptr;
    QVERIFY(waitUntil([&] {
      for (QPushButton* each : window_->findChildren<QPushButton*>(QStringLiteral("measuredElsewhere")))
        if (!each->isHidden()) elsewhere = each;
      return elsewhere != nullptr;
    }));
    elsewhere->click();
    QCOMPARE(grid().active(), 0);
    comparesInPixels(calipers(), session(), 70);
    QVERIFY(calipers().image() != kept(1).calipers().image());
    QCOMPARE(grid().nameOf(*calipers().image()), QStringLiteral("1 right"));
    session().probeControl().follow(nullptr);
  }

  void savedImageHasAllOfThem() {
    const QDateTime when(QDate(2026, 1, 2), QTime(3, 4));
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    pressKey(Qt::Key_F);
    measure(80);
    pressNext();
    setDepth(100.0);
    std::vector<SnapshotPart> parts;
    for (const ImageGrid::Shown& each : grid().shown())
      parts.push_back({each.session, {each.calipers, each.annotated, each.mark}, each.name, each.place == grid().active()});
    QCOMPARE(parts.size(), std::size_t{2});
    const QImage all = savedImages(parts, 2, when).image;
    const QImage left = savedImage(*parts[0].session, when, parts[0].on, parts[0].name).convertToFormat(all.format());
    const QImage right = savedImage(*parts[1].session, when, parts[1].on, parts[1].name).convertToFormat(all.format());
    QCOMPARE(all.size(), QSize(left.width() + right.width(), std::max(left.height(), right.height())));
    QCOMPARE(all.copy(QRect(QPoint(0, 0), left.size())), left);
    QCOMPARE(all.copy(QRect(QPoint(left.width(), 0), right.size())), right);
    const QString file = files_.path(QStringLiteral("two.png"));
    QVERIFY(writeShownImages(parts, 2, when, file.toStdString()).has_value());
    QVERIFY(QImage(file).width() == all.width());
  }

  void fourImagesGoWithTheirCase() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    for (int n = 0; n < 3; ++n) {
      pressKey(Qt::Key_F);
      measure(20 + 10 * n);
      pressNext();
    }
    pressKey(Qt::Key_F);
    measure(90);
    QCOMPARE(grid().shown().size(), std::size_t{4});
    for (int place = 0; place < 3; ++place) comparesInPixels(kept(place).calipers(), kept(place).session(), 20 + 10 * place);
    // What has no room is kept.
    const std::vector<std::uint8_t> third = pixelsOf(kept(2).session());
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(grid().count(), 1);
    comparesInPixels(calipers(), session(), 90);
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(grid().shown().size(), std::size_t{4});
    QVERIFY(waitUntil([&] { return !kept(2).session().cineLoop().isForming(); }));
    QVERIFY(pixelsOf(kept(2).session()) == third);
  }

  void anotherCaseBeginsWithOneImage() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    for (int n = 0; n < 3; ++n) pressNext();
    QVERIFY(openCase(files_.writeCase(QStringLiteral("second"))));
    QCOMPARE(grid().count(), 1);
    QVERIFY(!session().isFrozen());
    QCOMPARE(calipers().lines().size(), std::size_t{0});
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    QVERIFY(kept(1).isEmpty());
    pressNext();
    session().makeImageNow();
    QVERIFY(pixelsOf(session()) == madeAnew(session()));
    session().clear();
    QCOMPARE(grid().count(), 1);
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(grid().count(), 1);
  }

  void aVolumeThatIsMovedTakesTheOthersAway() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    pressNext();
    QVERIFY(!kept(0).isEmpty());
    Transform<frame::World, frame::World> moved;
    moved.matrix = glm::dmat4(1.0);
    moved.matrix[3] = glm::dvec4(5.0, 0.0, 0.0, 1.0);
    session().place(moved);
    QVERIFY(kept(0).isEmpty());
    QVERIFY(!window_->scanView().said().isEmpty());
  }

  void aRecordingIsOfOneImage() {
    pressKey(Qt::Key_M, Qt::ShiftModifier);
    pressNext();
    pressKey(Qt::Key_R, Qt::ControlModifier);
    QVERIFY(window_->recorder().isRecording());
    pressNext();
    QCOMPARE(grid().active(), 1);
    QVERIFY(window_->scanView().said().contains(QStringLiteral("Ctrl+R")));
    QVERIFY(!session().isFrozen());
    scanForAWhile(2);
    pressKey(Qt::Key_R, Qt::ControlModifier);
    QVERIFY(session().isPlaying());
    pressNext();  // a recording is shown: it has to be closed first
    QCOMPARE(grid().active(), 1);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::ImagesTest)
#include "images_test.moc"
