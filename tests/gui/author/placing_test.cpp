// Placing the volume of a case in the mannequin: handles, numbers, a place on the skin, pairs of places; and what is said of it.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTranslator>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ew/bridge/handles.h"
#include "ew/library/case.h"
#include "ew/library/placing.h"
#include "ew/widgets/apply_theme.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"

namespace ew::ui {
namespace {

using namespace testing;
using FilePlace = Transform<frame::World, frame::File>;

double largestDifference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0.0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
  return largest;
}

class PlacingTest : public WindowFixture {
  Q_OBJECT

  QString folder_;

  /// A block of 60 x 80 x 60 mm that the probe looked into from the front, 40 mm off the belly.
  [[nodiscard]] QString writeBlock(const QString& name) const {
    const QString folder = files_.writeCase(name);
    Volume volume;
    volume.grid.dims = {40, 54, 40};
    volume.grid.spacing_mm = glm::dvec3(1.5);
    volume.grid.origin_mm = {-29.25, 0.0, -29.25};
    volume.echo.resize(volume.grid.voxelCount());
    for (std::size_t n = 0; n < volume.echo.size(); ++n) volume.echo[n] = static_cast<std::uint8_t>(40 + (n * 7) % 150);
    if (!writeVolume(volume, folder.toStdString() + "/volume.mha")) return {};
    auto opened = loadCaseAside(folder.toStdString());
    if (!opened) return {};
    opened->region = "right upper quadrant";
    opened->volume.fileToWorld.matrix[3] = {0.0, -150.0, -60.0, 1.0};
    return saveCase(*opened, folder.toStdString()) ? folder : QString();
  }

  [[nodiscard]] QWidget& panel() const { return *find<QWidget>("placePanel"); }
  template <class Widget = QPushButton>
  [[nodiscard]] Widget& in(const char* name) const {
    auto* found = panel().findChild<Widget*>(QLatin1String(name));
    if (found == nullptr) qFatal("there is no widget '%s'", name);
    return *found;
  }
  void press(const char* name) {
    QVERIFY2(waitUntil([&] { return in(name).isEnabled(); }), name);
    in(name).click();
  }
  [[nodiscard]] CaseDocument& document() const { return window_->document(); }
  [[nodiscard]] FilePlace place() const { return document().current()->volume.fileToWorld; }
  [[nodiscard]] View3D& view() const { return window_->view3d(); }
  [[nodiscard]] QWidget& canvas() const { return *view().canvas(); }
  [[nodiscard]] bridge::HandlesPlace handles() const { return view().scene().handles().value_or(bridge::HandlesPlace{}); }
  [[nodiscard]] QPoint pixelOf(const glm::dvec3& at_mm) const { return view().pixelOf(at_mm).toPoint(); }
  [[nodiscard]] glm::dvec3 onArrow(int axis, double share) const {
    return carried(handles().toWorld, share * handles().reach_mm * glm::dvec3(axis == 0, axis == 1, axis == 2));
  }
  [[nodiscard]] int steps() const { return static_cast<int>(document().history().steps()); }

  void moveTo(const QPoint& at, Qt::MouseButtons held, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QMouseEvent move(QEvent::MouseMove, at, canvas().mapToGlobal(at), Qt::NoButton, held, modifiers);
    QCoreApplication::sendEvent(&canvas(), &move);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = Qt::NoModifier, bool releases = true) {
    moveTo(from, Qt::NoButton);
    QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from);
    for (int n = 1; n <= 8; ++n) moveTo(from + (to - from) * n / 8, Qt::LeftButton, modifiers);
    if (releases) QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, to);
  }
  void waitForContact() {
    QVERIFY(waitUntil([this] { return !in<QLabel>("contactVerdict").text().isEmpty() && in<QLabel>("contactVerdict").isVisible(); }));
    QTest::qWait(400);  // longer than the panel lets the hand go before it
  }
  void openPanel() {
    window_->openPlugins();
    window_->setWorkspace(Workspace::author);
    auto* tab = find<QWidget>("panel_placing");
    QVERIFY2(tab != nullptr, "the plugin of authors brings the panel");
    find<QTabWidget>("authorPanel")->setCurrentWidget(tab);
    QVERIFY(waitUntil([this] { return find<QWidget>("placePanel") != nullptr && panel().isVisible(); }));
    view().showFrom(bridge::CameraPreset::overview);
    view().renderNow();
    waitForContact();
  }
  /// A place of the belly that is seen, and nothing lies over.
  [[nodiscard]] glm::dvec3 onTheBelly() const { return view().skin()->hit({-60.0, -900.0, -90.0}, {0.0, 1.0, 0.0})->point_mm; }

 private Q_SLOTS:
  void init() {
    folder_ = writeBlock(QStringLiteral("placed case"));
    QVERIFY(!folder_.isEmpty());
    showWindowWithCase(folder_);
    QVERIFY(waitUntil([this] { return view().scene().mannequin() != nullptr; }));
    openPanel();
  }
  void cleanup() {
    window_.reset();
    QDir(folder_).removeRecursively();
  }

  void whatStandsOffTheSkinIsSaidAndWhatIsPutOnItToo() {
    QVERIFY2(in<QLabel>("contactVerdict").text().contains(QStringLiteral("stands off the skin")),
             qPrintable(in<QLabel>("contactVerdict").text()));
    QCOMPARE(in<QProgressBar>("contactShare").value(), 0);
    keepScreenshot(*window_, "placing-01-off-the-skin");
    const auto before = pixelsOf(session());
    press("placeOnSkin");
    QVERIFY(in("placeOnSkin").isChecked());
    moveTo(pixelOf(onTheBelly()), Qt::NoButton);
    keepScreenshot(*window_, "placing-02-asked-for-the-skin");
    const Hold held = session().probeControl().hold();
    QTest::mouseClick(&canvas(), Qt::LeftButton, Qt::NoModifier, pixelOf(onTheBelly()));
    QVERIFY2(session().probeControl().hold() == held, "the click is no slide of the probe");
    QCOMPARE(steps(), 1);
    QVERIFY(!in("placeOnSkin").isChecked());
    waitForContact();
    QVERIFY2(in<QProgressBar>("contactShare").value() >= 50, qPrintable(in<QLabel>("contactFigures").text()));
    const glm::dvec3 front_mm = carried(place(), glm::dvec3(0.0, -0.75, 0.0));
    QVERIFY(glm::distance(front_mm, onTheBelly()) < 6.0);
    const glm::dvec3 beam = glm::dvec3(place().matrix[1]);
    QVERIFY(glm::dot(beam, view().skin()->nearest(onTheBelly()).outward) < -0.95);
    QVERIFY2(waitUntil([&] { return pixelsOf(session()) != before; }), "the scan follows");
    keepScreenshot(*window_, "placing-03-on-the-skin");
    press("placeOnSkin");
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QVERIFY2(!in("placeOnSkin").isChecked(), "Escape ends the question");
    QCOMPARE(steps(), 1);
  }

  void anArrowIsDraggedAndOneDragIsOneStep() {
    press("placeHandles");
    QVERIFY(waitUntil([this] { return view().scene().handles().has_value(); }));
    view().renderNow();
    const FilePlace before = place();
    const auto pixels = pixelsOf(session());
    const QPoint from = pixelOf(onArrow(0, 0.7)), tip = pixelOf(onArrow(0, 1.0));
    moveTo(from, Qt::NoButton);
    keepScreenshot(*window_, "placing-04-handles");
    const QPoint to = from + 2 * (tip - from);
    const glm::dvec3 axis = glm::dvec3(handles().toWorld.matrix[0]), grabbed_mm = onArrow(0, 0.7);
    drag(from, to);
    QCOMPARE(steps(), 1);
    const glm::dvec3 by_mm = glm::dvec3(place().matrix[3] - before.matrix[3]);
    QVERIFY2(glm::length(by_mm) > 5.0, "it moved");
    QVERIFY2(glm::length(glm::cross(by_mm, axis)) < 1e-6, "along the arrow alone");
    QVERIFY(largestDifference(glm::dmat4(glm::dmat3(place().matrix)), glm::dmat4(glm::dmat3(before.matrix))) < 1e-12);
    const QPoint now = pixelOf(grabbed_mm + by_mm) - to;
    QVERIFY2(std::hypot(now.x(), now.y()) < 3.0, "what was taken is under the pointer");
    QVERIFY(std::abs(in<QDoubleSpinBox>("placement_x").value() - place().matrix[3].x) < 1e-3);
    QVERIFY2(waitUntil([&] { return pixelsOf(session()) != pixels; }), "the scan follows");
    QVERIFY(glm::distance(glm::dvec3(handles().toWorld.matrix[3]), middleOf(session().subject()->placedGrid)) < 1e-6);
    document().undo();
    QCOMPARE(largestDifference(place().matrix, before.matrix), 0.0);
    QVERIFY(glm::distance(glm::dvec3(handles().toWorld.matrix[3]), middleOf(session().subject()->placedGrid)) < 1e-6);
    QVERIFY(waitUntil([&] { return pixelsOf(session()) == pixels; }));
    QVERIFY(!document().hasUnsavedChanges());
  }

  void aRingTurnsInWholeDegreesAndEscapeGivesBack() {
    press("placeHandles");
    QVERIFY(waitUntil([this] { return view().scene().handles().has_value(); }));
    view().renderNow();
    const FilePlace before = place();
    const auto onRing = [this](double angle_rad) {
      return carried(handles().toWorld,
                     bridge::kRingShare * handles().reach_mm * glm::dvec3(std::sin(angle_rad), 0.0, std::cos(angle_rad)));
    };
    const QPoint from = pixelOf(onRing(0.8)), to = pixelOf(onRing(1.3));
    drag(from, to, Qt::ShiftModifier);
    QCOMPARE(steps(), 1);
    const glm::dmat3 turned = glm::dmat3(place().matrix) * glm::transpose(glm::dmat3(before.matrix));
    const double angle_deg = glm::degrees(std::acos(std::clamp(0.5 * (turned[0][0] + turned[1][1] + turned[2][2] - 1.0), -1.0, 1.0)));
    QVERIFY2(std::abs(angle_deg - std::round(angle_deg)) < 1e-6, qPrintable(QString::number(angle_deg)));
    QVERIFY2(angle_deg > 20.0 && angle_deg < 38.0, qPrintable(QString::number(angle_deg)));
    const Grid own = session().subject()->voxels.grid();
    QVERIFY(glm::distance(middleOf(session().subject()->placedGrid),
                          carried(before, middleOf(placed(own, FilePlace{inverse(before).matrix})))) < 1e-6);
    document().undo();

    drag(pixelOf(onArrow(0, 0.7)), pixelOf(onArrow(0, 0.7)) + QPoint(40, 0), Qt::NoModifier, false);
    QVERIFY(largestDifference(place().matrix, before.matrix) > 3.0);
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QCOMPARE(largestDifference(place().matrix, before.matrix), 0.0);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, Qt::NoModifier, pixelOf(onArrow(0, 0.7)));
    QCOMPARE(steps(), 0);
    QVERIFY2(!document().hasUnsavedChanges(), "what was given back is no edit");
  }

  void keysMoveByAMillimetreAndTurnByADegree() {
    press("placeHandles");
    QVERIFY(waitUntil([this] { return view().scene().handles().has_value(); }));
    view().showFrom(bridge::CameraPreset::front);
    view().renderNow();
    canvas().setFocus();
    const FilePlace before = place();
    const Hold held = session().probeControl().hold();
    QTest::keyClick(&canvas(), Qt::Key_Right);  // from the front: towards the patient's left
    QVERIFY(glm::distance(glm::dvec3(place().matrix[3] - before.matrix[3]), glm::dvec3(1, 0, 0)) < 1e-9);
    QTest::keyClick(&canvas(), Qt::Key_PageDown);  // away: into the body
    QVERIFY(glm::distance(glm::dvec3(place().matrix[3] - before.matrix[3]), glm::dvec3(1, 1, 0)) < 1e-9);
    QTest::keyClick(&canvas(), Qt::Key_Up);
    QVERIFY(glm::distance(glm::dvec3(place().matrix[3] - before.matrix[3]), glm::dvec3(1, 1, 1)) < 1e-9);
    QCOMPARE(steps(), 3);
    QTest::keyClick(&canvas(), Qt::Key_Right, Qt::AltModifier);
    const double turned_rad = std::atan2(place().matrix[0].y, place().matrix[0].x);
    QVERIFY2(std::abs(turned_rad - glm::radians(1.0)) < 1e-9, "what faces the viewer goes to the right");
    QVERIFY2(session().probeControl().hold() == held, "the probe rests");
    const double depth_mm = session().console().depth_mm();
    QCOMPARE(session().console().depth_mm(), depth_mm);
    press("placeHandles");
    canvas().setFocus();
    QTest::keyClick(&canvas(), Qt::Key_Right);
    QVERIFY2(!(session().probeControl().hold() == held), "without handles the keys are the probe's again");
  }

  void numbersButtonsAndTheFaceAreStepsOfTheirOwn() {
    in<QDoubleSpinBox>("placement_z").setValue(-80.0);
    QCOMPARE(steps(), 1);
    QCOMPARE(place().matrix[3].z, -80.0);
    const FilePlace before = place();
    press("placeFlip");
    QVERIFY(glm::distance(glm::dvec3(place().matrix[1]), glm::dvec3(before.matrix[1])) < 1e-12);
    QVERIFY(glm::distance(glm::dvec3(place().matrix[0]), -glm::dvec3(before.matrix[0])) < 1e-12);
    press("placeTurnOn");
    press("placeTurnOn");
    QVERIFY(largestDifference(place().matrix, before.matrix) < 1e-9);
    press("placeTurnBack");
    QCOMPARE(steps(), 5);
    press("placeUsual");
    waitForContact();
    // The beams are tipped up under the ribs there, so the flat face of a block touches in its middle.
    const int usual = in<QProgressBar>("contactShare").value();
    QVERIFY2(usual > 10, qPrintable(in<QLabel>("contactFigures").text()));
    const auto known = landmarksOf({});
    QVERIFY(known && siteFor(*known, "right upper quadrant") != nullptr);
    QVERIFY(glm::distance(carried(place(), glm::dvec3(0.0, -0.75, 0.0)), siteFor(*known, "right upper quadrant")->at_mm) < 12.0);
    auto& face = in<QComboBox>("nearFace");
    QCOMPARE(face.count(), 6);
    const int guessed = face.currentIndex();
    QTest::keyClick(&face, guessed == 5 ? Qt::Key_Up : Qt::Key_Down);
    QVERIFY(sweepAxesOf(*document().current()).has_value());
    waitForContact();
    QVERIFY2(in<QProgressBar>("contactShare").value() < usual, "another face is not on the skin");
    while (document().history().canUndo()) document().undo();
    QCOMPARE(place().matrix[3].z, -60.0);
    QCOMPARE(in<QDoubleSpinBox>("placement_z").value(), -60.0);
  }

  void placesAreKeptTheWrongOneIsNamedAndTheVolumePlacedByThem() {
    for (int n = 0; n < 2; ++n) press("addPair");
    QVERIFY2(in<QLabel>("pairsFit").text().contains(QStringLiteral("three")), qPrintable(in<QLabel>("pairsFit").text()));
    QVERIFY(!in("placeByPairs").isEnabled());
    // The first by hand: in the image, and by its name on the body.
    in<QPushButton>("pair_0_inImage").click();
    auto* pointing = find<QWidget>("pointing");
    QVERIFY(waitUntil([&] { return pointing->isVisible(); }));
    keepScreenshot(*window_, "placing-05-asked-for-the-image");
    const QPoint pixel(pointing->width() / 2 + 20, pointing->height() / 2 - 10);
    QTest::mouseClick(pointing, Qt::LeftButton, Qt::NoModifier, pixel);
    QVERIFY(!pointing->isVisible());
    const auto part = [this] { return nlohmann::json(document().current()->otherFields)["parts"]["placing"]["pairs"]; };
    const auto file = part()[0]["file_mm"].get<std::vector<double>>();
    const glm::dvec2 at_mm = session().geometry().probePoint_mm(pixel.x(), pixel.y());
    const glm::dvec3 expected =
        carried(rigidInverse(place()), (session().shownState().pose.probeToWorld * Point<frame::Probe>{{at_mm.x, at_mm.y, 0.0}}).at);
    QVERIFY(glm::distance(glm::dvec3(file[0], file[1], file[2]), expected) < 1e-6);
    auto& body = in<QComboBox>("pair_0_onBody");
    const int xiphoid = body.findText(QStringLiteral("xiphoid"), Qt::MatchContains);
    QVERIFY2(xiphoid > 2, "the mannequin's places are offered by name");
    body.setCurrentIndex(xiphoid);
    Q_EMIT body.activated(xiphoid);
    QCOMPARE(part()[0]["landmark"].get<std::string>(), std::string("xiphoid"));
    // The second is clicked on the skin.
    Q_EMIT in<QComboBox>("pair_1_onBody").activated(1);
    QTest::mouseClick(&canvas(), Qt::LeftButton, Qt::NoModifier, pixelOf(onTheBelly()));
    const auto world = part()[1]["world_mm"].get<std::vector<double>>();
    QVERIFY(glm::distance(glm::dvec3(world[0], world[1], world[2]), onTheBelly()) < 3.0);

    // Five that agree, but for one.
    FilePlace truth{glm::rotate(glm::translate(glm::dmat4(1.0), {-40.0, -98.0, -70.0}), 0.3, {0.0, 0.0, 1.0})};
    nlohmann::json pairs = nlohmann::json::array();
    for (const glm::dvec3& at :
         {glm::dvec3(-25, 5, 20), glm::dvec3(25, 10, 22), glm::dvec3(0, 60, -25), glm::dvec3(20, 40, 10), glm::dvec3(-20, 30, -20)}) {
      const glm::dvec3 there = carried(truth, at) + (pairs.size() == 2 ? glm::dvec3(0, 45, 0) : glm::dvec3(0.0));
      pairs.push_back({{"name", pairs.size() == 2 ? "gall bladder" : "place"},
                       {"file_mm", {at.x, at.y, at.z}},
                       {"world_mm", {there.x, there.y, there.z}}});
    }
    Case changed = *document().current();
    changed.otherFields["parts"]["placing"]["pairs"] = pairs;
    QVERIFY(document().edit(changed, "Places", {}));
    const QString words = in<QLabel>("pairsFit").text();
    QVERIFY2(words.contains(QStringLiteral("gall bladder")) && words.contains(QStringLiteral("does not fit")), qPrintable(words));
    QVERIFY2(in<QLabel>("pair_2_residual").text().contains(QStringLiteral("⚠ 45.0 mm")), qPrintable(in<QLabel>("pair_2_residual").text()));
    QVERIFY(!in<QLabel>("pair_1_residual").text().contains(QStringLiteral("⚠")));
    keepScreenshot(*window_, "placing-06-a-wrong-place");
    const int before = steps();
    press("placeByPairs");
    QCOMPARE(steps(), before + 1);
    QVERIFY(largestDifference(place().matrix, truth.matrix) < 1e-6);

    const auto saved = document().save();
    QVERIFY2(saved, saved ? "" : saved.error().sentence().c_str());
    window_.reset();
    showWindowWithCase(folder_);
    openPanel();
    QVERIFY(largestDifference(place().matrix, truth.matrix) < 1e-9);
    QCOMPARE(in<QPushButton>("pair_4_inImage").text(), QStringLiteral("In the image ✓"));
    QVERIFY(in<QLabel>("pairsFit").text().contains(QStringLiteral("gall bladder")));
    in<QPushButton>("pair_2_remove").click();
    QVERIFY2(in<QLabel>("pairsFit").text().contains(QStringLiteral("0.0 mm")), qPrintable(in<QLabel>("pairsFit").text()));
  }

  void whatIsShownForPlacingGoesWithThePanel() {
    press("placeHandles");
    QVERIFY(waitUntil([this] { return view().scene().handles().has_value(); }));
    find<QTabWidget>("authorPanel")->setCurrentIndex(0);
    QVERIFY(!view().scene().handles().has_value());
    find<QTabWidget>("authorPanel")->setCurrentWidget(find<QWidget>("panel_placing"));
    QVERIFY2(view().scene().handles().has_value(), "the button is still pressed");
    window_->setWorkspace(Workspace::explore);
    QVERIFY(!view().scene().handles().has_value());
  }

  void itLooksGoodInBothThemesInASmallWindowAndInGerman() {
    if (screenshotFolder().isEmpty()) QSKIP("images for a person to look at");
    press("placeUsual");
    press("placeHandles");
    waitForContact();
    for (int n = 0; n < 3; ++n) press("addPair");
    for (const bool dark : {true, false}) {
      applyTheme(dark ? darkTheme() : lightTheme());
      view().setDarkTheme(dark);
      window_->resize(1440, 900);
      QTest::qWait(200);
      waitForContact();
      keepScreenshot(*window_, dark ? "placing-07-dark" : "placing-08-light");
    }
    window_->resize(1024, 640);
    waitForContact();
    keepScreenshot(*window_, "placing-09-small");
    window_.reset();
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QApplication::installTranslator(&german);
    const QLocale before;
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    showWindowWithCase(folder_);
    openPanel();
    press("addPair");
    press("placeHandles");
    press("placeOnSkin");
    moveTo(pixelOf(onTheBelly()), Qt::NoButton);
    keepScreenshot(*window_, "placing-10-german");
    window_.reset();
    QApplication::removeTranslator(&german);
    QLocale::setDefault(before);
  }
};

}  // namespace
}  // namespace ew::ui

EW_WINDOW_TEST_MAIN(ew::ui::PlacingTest)
#include "placing_test.moc"
