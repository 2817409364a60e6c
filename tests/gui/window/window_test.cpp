#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <QTabWidget>
#include <QTimer>
#include <QTranslator>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "ew/bridge/scene3d.h"
#include "ew/imaging/effects/gain.h"
#include "ew/library/case.h"
#include "ew/scanning/contact.h"
#include "ew/widgets/icons.h"
#include "gui/support/case_aside.h"
#include "gui/support/window_fixture.h"
#include "library/small_case.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

class WindowTest : public WindowFixture {
  Q_OBJECT

 private:
  void drop(const QString& file) const { drop(QStringList{file}); }
  void drop(const QStringList& files) const {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls << QUrl::fromLocalFile(file);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(100, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(100, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &event);
  }
  void checkNothingIsClipped() const {
    for (const QLabel* label : window_->findChildren<QLabel*>()) {
      if (!label->isVisible() || label->wordWrap()) continue;
      QVERIFY2(label->width() >= label->sizeHint().width() - 1, qPrintable(label->objectName() + QStringLiteral(": ") + label->text()));
    }
    for (const QPushButton* button : window_->findChildren<QPushButton*>()) {
      if (!button->isVisible()) continue;
      QVERIFY2(button->width() >= button->minimumSizeHint().width() - 1, qPrintable(button->text()));
      QVERIFY2(button->height() >= button->minimumSizeHint().height() - 1, qPrintable(button->text()));
    }
    QCOMPARE(window_->width(), 1280);
    QCOMPARE(window_->height(), 720);
  }

 private Q_SLOTS:
  void initTestCase() { initTranslations(); }
  void init() { showWindowWithCase(files_.writeCase(QStringLiteral("case"))); }
  void cleanup() { window_.reset(); }

  void gainAndDgcChangeTheImageAsEquation5Says() {
    const std::vector<std::uint8_t> before = pixelsOf(session());
    QVERIFY(std::count_if(before.begin(), before.end(), [](std::uint8_t v) { return v > 0; }) > 10000);
    find<QSlider>("gain")->setValue(130);
    find<QSlider>("dgc2")->setValue(40);
    find<QSlider>("dgc7")->setValue(180);
    session().makeImageNow();
    const std::vector<std::uint8_t> after = pixelsOf(session());
    const DisplayGeometry& geometry = session().geometry();
    const Knobs& knobs = session().console().knobs();
    QCOMPARE(knobs.gain, 1.3);
    for (int y = 0; y < geometry.height; ++y) {
      const double position = std::clamp((y - geometry.face_px.y) * geometry.pixel_mm / geometry.depth_mm, 0.0, 1.0);
      const double dgc = dgcAt(knobs.dgc, position);
      for (int x = 0; x < geometry.width; ++x) {
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(geometry.width) + static_cast<std::size_t>(x);
        const double expected = std::min(knobs.gain * std::min(dgc * before[at], 255.0), 255.0);
        if (std::abs(expected - after[at]) > 0.5 + 1e-9) QCOMPARE(static_cast<double>(after[at]), expected);
      }
    }
    // What the session holds is what the screen shows, pixel for pixel.
    const QImage shown = window_->scanView().grab().toImage();
    const QPoint corner = window_->scanView().imageRect().topLeft();
    const int middleX = geometry.width / 2;
    for (int y = geometry.height / 4; y < 3 * geometry.height / 4; ++y) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(geometry.width) + static_cast<std::size_t>(middleX);
      QCOMPARE(qRed(shown.pixel(corner + QPoint(middleX, y))), static_cast<int>(after[at]));
    }
    QTest::mouseClick(find<QPushButton>("dgcReset"), Qt::LeftButton);
    find<QSlider>("gain")->setValue(100);
    session().makeImageNow();
    QCOMPARE(pixelsOf(session()), before);
  }

  void draggingTheProbeChangesTheSliceAndTheFanTogether() {
    const std::vector<std::uint8_t> before = pixelsOf(session());
    const Pose poseBefore = session().imagePose();
    View3D& view = window_->view3d();
    view.renderNow();
    const QPoint from = view.pixelOf(session().probeControl().hold().contact.point_mm).toPoint();
    const QPoint to = from + QPoint(24, -16);
    QWidget* canvas = view.canvas();
    QTest::mousePress(canvas, Qt::LeftButton, Qt::NoModifier, from);
    QMouseEvent move(QEvent::MouseMove, to, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
    QTest::mouseRelease(canvas, Qt::LeftButton, Qt::NoModifier, to);
    QVERIFY(waitUntil([&] {
      return glm::distance(glm::dvec3(session().imagePose().probeToWorld.matrix[3]), glm::dvec3(poseBefore.probeToWorld.matrix[3])) > 3.0;
    }));
    const Pose pose = session().imagePose();
    QVERIFY(waitUntil([&] { return pixelsOf(session()) != before; }));
    const std::vector<glm::dvec3> fan_mm = view.scene().fanCorners_mm();
    const std::vector<glm::dvec2> outline_mm =
        fanOutline_mm(session().console().probe(), session().console().knobs(), session().geometry().depth_mm);
    QVERIFY(!fan_mm.empty());
    const glm::dvec3 expected_mm = glm::dvec3(pose.probeToWorld.matrix * glm::dvec4(outline_mm.front(), 0.0, 1.0));
    QVERIFY2(glm::distance(fan_mm.front(), expected_mm) < 0.01, "the fan in 3D does not lie where the slice was taken");
  }

  void theMarkerStandsAtTheLeftUntilFlipped() {
    const auto dotIsAt = [this] {
      const QImage shown = window_->scanView().grab().toImage();
      const QRgb accent = scanTheme().accent.rgb();
      const QRect box = window_->scanView().imageRect();
      double sum = 0.0;
      int count = 0;
      for (int y = box.top() - 20; y < box.center().y(); ++y) {
        for (int x = box.left() + box.width() / 4; x < box.right() - box.width() / 4; ++x) {  // the body mark lies farther out
          if (shown.pixel(x, y) != accent) continue;
          sum += x;
          ++count;
        }
      }
      return count > 0 ? sum / count - box.center().x() : 0.0;
    };
    auto* flip = find<QPushButton>("flip");
    const std::vector<std::uint8_t> usual = pixelsOf(session());
    QVERIFY(session().geometry().markerLeft && !flip->isChecked());
    QVERIFY(dotIsAt() < -20.0);
    const QString tipBefore = flip->toolTip();
    QTest::keyClick(&window_->scanView(), Qt::Key_X);
    QVERIFY(waitUntil([flip] { return flip->isChecked(); }));
    session().makeImageNow();
    QVERIFY(!session().geometry().markerLeft && flip->isChecked());
    QVERIFY(flip->toolTip() != tipBefore);
    QVERIFY(dotIsAt() > 20.0);
    const DisplayGeometry& geometry = session().geometry();
    const std::vector<std::uint8_t> flipped = pixelsOf(session());
    const auto width = static_cast<std::size_t>(geometry.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(geometry.height); ++y) {
      for (std::size_t x = 0; x < width; ++x) QVERIFY(std::abs(usual[y * width + x] - flipped[y * width + width - 1 - x]) <= 1);
    }
    QTest::mouseClick(flip, Qt::LeftButton);
    session().makeImageNow();
    QCOMPARE(pixelsOf(session()), usual);
  }

  void theProbeIsPressedOnUntilItsFaceTouchesAndKeepsThePressWhileSliding() {
    const double usual_mm = usualPress_mm(session().console().probe());
    QVERIFY(usual_mm > 5.0);
    QCOMPARE(session().probeControl().hold().press_mm, usual_mm);
    const double pressed = *session().contact();
    QTest::keyClick(&window_->scanView(), Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(session().probeControl().hold().press_mm, usual_mm);
    QTest::keyClick(&window_->scanView(), Qt::Key_Home);
    Hold lifted = session().probeControl().hold();
    lifted.press_mm = 0.0;
    session().probeControl().setHold(lifted);
    QVERIFY2(*session().contact() < pressed - 0.2, "contact follows the press");
    QCOMPARE(window_->hand().hold(), lifted);
  }

  void aMovedVolumeIsSavedWhereTheAnswerSays() {
    CaseDocument& document = window_->document();
    Case changed = *document.current();
    changed.volume.fileToWorld.matrix[3][0] = 7.0;
    QVERIFY(document.edit(changed, "Move the volume", "place").has_value());
    QTest::qWait(20);
    const glm::dvec3 own_mm = session().subject()->voxels.volume()->grid.origin_mm;
    for (const bool inBody : {false, true}) {
      const QString file = files_.path(inBody ? QStringLiteral("body.mha") : QStringLiteral("own.mha"));
      QTimer answer;
      connect(&answer, &QTimer::timeout, this, [&] {
        QWidget* modal = QApplication::activeModalWidget();
        if (modal == nullptr) return;
        if (modal->objectName() == QLatin1String("volumePlace")) {
          modal->findChild<QPushButton*>(inBody ? QStringLiteral("bodyPlace") : QStringLiteral("ownPlace"))->click();
        } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
          dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
          QMetaObject::invokeMethod(dialog, "accept");
        }
      });
      answer.start(30);
      for (QAction* action : window_->findChildren<QAction*>()) {
        if (action->text() == QStringLiteral("Save &volume as…")) action->trigger();
      }
      answer.stop();
      QVERIFY(waitUntil([&] { return !window_->jobs().isRunning() && QFile::exists(file); }));
      const auto saved = readVolume(file.toStdString());
      QVERIFY(saved.has_value());
      const glm::dvec3 expected_mm = own_mm + glm::dvec3(inBody ? 7.0 : 0.0, 0.0, 0.0);
      QVERIFY(glm::distance(saved->volume.grid.origin_mm, expected_mm) < 1e-6);
      QVERIFY(saved->volume.echo == session().subject()->voxels.volume()->echo);
    }
    document.undo();
  }

  void freezeHoldsTheImageWhileTheHandMovesAndRefusesTheKnobs() {
    QTest::keyClick(&window_->scanView(), Qt::Key_F);
    QVERIFY(session().isFrozen());
    const std::vector<std::uint8_t> held = pixelsOf(session());
    const auto fan_mm = window_->view3d().scene().fanCorners_mm();
    session().probeControl().setHold(turned(session().probeControl().hold(), 0.3, 0.1, 0.2));
    const Knobs knobs = session().console().knobs();
    find<QSlider>("gain")->setValue(180);
    QVERIFY(session().console().knobs() == knobs);
    QTest::qWait(50);
    QCOMPARE(pixelsOf(session()), held);
    QVERIFY(window_->view3d().scene().fanCorners_mm() == fan_mm);
    QTest::keyClick(&window_->scanView(), Qt::Key_Space);
    QVERIFY(!session().isFrozen());
    QVERIFY(waitUntil([&] { return pixelsOf(session()) != held; }));
  }

  void aCaseIsEditedUndoneSavedAndReopened() {
    window_->openPlugins();
    window_->setWorkspace(Workspace::author);
    QTest::qWait(50);
    CaseDocument& document = window_->document();
    auto* title = find<QLineEdit>("title");
    QWidget* panel = window_->findChild<QWidget*>(QStringLiteral("casePanel"));
#ifdef EW_WITH_CASE_AUTHORING
    QVERIFY2(panel != nullptr, "the case authoring plugin is part of this build and brought no panel");
#else
    if (panel == nullptr) QSKIP("the case authoring plugin is not part of this build");
#endif
    title = panel->findChild<QLineEdit*>(QStringLiteral("title"));
    QVERIFY(title != nullptr);
    title->selectAll();
    QTest::keyClicks(title, QStringLiteral("Edited title"));
    QCOMPARE(QString::fromStdString(document.current()->title), QStringLiteral("Edited title"));
    QVERIFY(document.hasUnsavedChanges());
    while (document.history().canUndo()) document.undo();
    QCOMPARE(QString::fromStdString(document.current()->title), QStringLiteral("Window test"));
    QCOMPARE(title->text(), QStringLiteral("Window test"));
    QVERIFY(!document.hasUnsavedChanges());
    while (document.history().canRedo()) document.redo();
    const auto saved = document.save();
    QVERIFY2(saved, saved ? "" : saved.error().sentence().c_str());
    QVERIFY(!document.hasUnsavedChanges());
    const auto folder = document.current()->folder;
    const auto reopened = loadCaseAside(folder);
    QVERIFY(reopened.has_value());
    QCOMPARE(QString::fromStdString(reopened->title), QStringLiteral("Edited title"));
  }

  void editsOfOneSliderAreOneStepAndMovingTheVolumeMovesTheSlice() {
    CaseDocument& document = window_->document();
    const std::vector<std::uint8_t> before = pixelsOf(session());
    for (const double x_mm : {1.0, 2.0, 6.0}) {
      Case changed = *document.current();
      changed.volume.fileToWorld.matrix[3][0] = x_mm;
      const auto edited = document.edit(changed, "Move the volume", "place");
      QVERIFY2(edited, edited ? "" : edited.error().sentence().c_str());
    }
    QCOMPARE(document.history().steps(), std::size_t{1});
    QVERIFY(waitUntil([&] { return pixelsOf(session()) != before; }));
    document.undo();
    QVERIFY(waitUntil([&] { return pixelsOf(session()) == before; }));
    Case mirrored = *document.current();
    mirrored.volume.fileToWorld.matrix[0][0] = -1.0;
    QVERIFY(!document.edit(mirrored, "Mirror", ""));
    QVERIFY(!document.hasUnsavedChanges());
  }

  void eachFieldOfThePlacementIsAStepOfItsOwn() {
    window_->openPlugins();
    window_->setWorkspace(Workspace::author);
    QTest::qWait(50);
    if (auto* tab = find<QWidget>("panel_placing")) find<QTabWidget>("authorPanel")->setCurrentWidget(tab);
    QWidget* panel = window_->findChild<QWidget*>(QStringLiteral("placePanel"));
#ifdef EW_WITH_CASE_AUTHORING
    QVERIFY2(panel != nullptr, "the case authoring plugin is part of this build and brought no panel");
#else
    if (panel == nullptr) QSKIP("the case authoring plugin is not part of this build");
#endif
    CaseDocument& document = window_->document();
    const auto place = [&document] { return document.current()->volume.fileToWorld; };
    for (const auto& [name, value] : {std::pair{"placement_x", 3.0}, {"placement_x", 30.0}, {"placement_z", 7.0}, {"placement_rx", 20.0}})
      panel->findChild<QDoubleSpinBox*>(QLatin1String(name))->setValue(value);
    QCOMPARE(document.history().steps(), std::size_t{3});
    document.undo();
    QCOMPARE(place().matrix[3].x, 30.0);
    QCOMPARE(place().matrix[3].z, 7.0);
    QCOMPARE(place().matrix[1].z, 0.0);
    document.undo();
    QCOMPARE(place().matrix[3].z, 0.0);
    QCOMPARE(place().matrix[3].x, 30.0);
  }

  void aCalibrationIsForTheSweepItWasDroppedWithAndForNoOther() {
    const QString sweep = files_.writeSweep(QStringLiteral("calibrated.igs.mha"));
    const QString device = files_.path(QStringLiteral("device.xml")), bundle = files_.path(QStringLiteral("no bundle.ewcase"));
    for (const QString& file : {device, bundle}) QVERIFY(writeFileSafely(file.toStdString(), "<nothing/>\n").has_value());
    const auto calibrationAsked = [&](QString& calibration) {
      QDialog* dialog = nullptr;
      QVERIFY(waitUntil([&] { return (dialog = find<QDialog>("importDialog")) != nullptr && dialog->isVisible(); }));
      calibration = dialog->findChild<QLineEdit*>(QStringLiteral("calibration"))->text();
      dialog->reject();
      QVERIFY(waitUntil([&] { return find<QDialog>("importDialog") == nullptr; }));
    };
    QString calibration;
    window_->open(files_.writeCase(QStringLiteral("gives way")));  // an opening that ends when the sweep takes its place
    drop(QStringList{device, sweep});
    calibrationAsked(calibration);
    QCOMPARE(calibration, device);
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    drop(QStringList{bundle, device});
    QVERIFY(waitUntil([this] { return window_->isSettled() && window_->messages().isError(); }));
    window_->open(sweep);
    calibrationAsked(calibration);
    QCOMPARE(calibration, QString());
    window_->open(sweep);
    drop(QStringList{bundle, device});  // the sweep is being opened, without it
    calibrationAsked(calibration);
    QCOMPARE(calibration, QString());
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }

  void aSweepDroppedOnTheWindowBecomesAVolume() {
    const QString sweep = files_.writeSweep(QStringLiteral("dropped.igs.mha"));
    QVERIFY(!sweep.isEmpty());
    drop(sweep);
    QDialog* dialog = nullptr;
    QVERIFY(waitUntil([&] { return (dialog = find<QDialog>("importDialog")) != nullptr && dialog->isVisible(); }));
    auto* make = dialog->findChild<QPushButton*>(QStringLiteral("makeVolume"));
    QVERIFY2(waitUntil([&] { return make->isEnabled(); }), qPrintable(dialog->findChild<QLabel*>(QStringLiteral("importNotes"))->text()));
    QTest::mouseClick(make, Qt::LeftButton);
    QVERIFY(waitUntil([this] { return session().subject() && session().subject()->title == "dropped.igs.mha"; }));
    const Volume& volume = *session().subject()->voxels.volume();
    QCOMPARE(volume.grid.dims.x, 40);  // 39 mm in steps of 1 mm, as pixels and frames lie
    QCOMPARE(volume.grid.dims.z, 24);
    // On the plane of frame 12 lies frame 12's grey level.
    QCOMPARE(static_cast<int>(volume.echo[volume.grid.indexOf(20, 15, 12)]), 40 + 8 * 12);
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    const auto pixels = pixelsOf(session());
    QVERIFY2(std::any_of(pixels.begin(), pixels.end(), [](std::uint8_t v) { return v > 0; }), "the probe does not see the volume");
  }

  void aWrongFileDroppedGivesAMessageAndChangesNothing() {
    const auto title = session().subject()->title;
    const std::vector<std::uint8_t> before = pixelsOf(session());
    const QString wrong = files_.path(QStringLiteral("wrong.mha"));
    QVERIFY(writeFileSafely(wrong.toStdString(), "this is not a MetaImage\n").has_value());
    drop(wrong);
    QVERIFY(waitUntil([this] { return window_->messages().isError(); }));
    QVERIFY(window_->messages().text().endsWith(QLatin1Char('.')));
    QCOMPARE(session().subject()->title, title);
    QVERIFY(window_->document().current().has_value());
    // It lies on nobody's buttons.
    const auto placeOf = [](const QWidget& widget) { return QRect(widget.mapToGlobal(QPoint(0, 0)), widget.size()); };
    const QRect message = placeOf(window_->messages());
    for (const auto* button : window_->findChildren<QAbstractButton*>()) {
      if (!button->isVisible() || window_->messages().isAncestorOf(button)) continue;
      QVERIFY2(!placeOf(*button).intersects(message), qPrintable(button->objectName() + button->text()));
    }
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    QCOMPARE(window_->messages().count(), 0);
    // The image has the room of before again, and shows the same.
    QTRY_COMPARE_WITH_TIMEOUT(pixelsOf(session()), before, static_cast<int>(test::kPatience_ms));
  }

  void whatWasSaidOfAnEarlierFileGoesWhenAnotherIsOpen() {
    const QString wrong = files_.path(QStringLiteral("wrong.mha"));
    QVERIFY(writeFileSafely(wrong.toStdString(), "this is not a MetaImage\n").has_value());
    drop(wrong);
    QVERIFY(waitUntil([this] { return window_->messages().isError(); }));
    QVERIFY(openCase(files_.writeCase(QStringLiteral("next"))));
    QVERIFY2(waitUntil([this] { return window_->messages().count() == 0; }), qPrintable(window_->messages().text()));
  }

  /// Neither running work nor a message moves or covers what somebody is about to press.
  void runningWorkAndMessagesCoverNothingAndMoveNothing() {
    const auto onScreen = [](const QWidget* widget) { return QRect(widget->mapToGlobal(QPoint(0, 0)), widget->size()); };
    ScanView& scan = window_->scanView();
    const QRect scanBefore = onScreen(&scan), imageBefore = scan.imageRect(), freezeBefore = onScreen(find<QPushButton>("freeze"));
    const auto idle = [](Progress& progress) -> Result<void> {
      while (!progress.cancelRequested()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
      return failure(ErrorCode::cancelled, verbatim("Stopped."));
    };
    window_->jobs().start(QStringLiteral("Quietly, with a name that is longer than there is room for in a line of this window"), idle, {},
                          Jobs::Kind::background);
    window_->jobs().start(QStringLiteral("Awaited"), idle, {});
    auto* line = find<QWidget>("jobsLine");
    QVERIFY(waitUntil([&] { return line->isVisible() && find<QPushButton>("moreJobs")->isVisible(); }));
    QVERIFY(find<QWidget>("statusLine")->isAncestorOf(line));
    QCOMPARE(find<QLabel>("jobTitle")->text(), QStringLiteral("Awaited"));
    QVERIFY(onScreen(find<QWidget>("statusLine")).contains(onScreen(line)));
    window_->messages().showError(QStringLiteral("Something cannot be read; choose something else."));
    QTest::qWait(20);
    QCOMPARE(onScreen(&scan), scanBefore);
    QCOMPARE(scan.imageRect(), imageBefore);
    QCOMPARE(onScreen(find<QPushButton>("freeze")), freezeBefore);
    QVERIFY2(!onScreen(&window_->messages()).intersects(imageBefore.translated(scanBefore.topLeft())), "the message lies on the image");
    QVERIFY(!onScreen(&window_->messages()).intersects(onScreen(&window_->console())));
    // All of them are told of on request, and each is cancelled for itself.
    find<QPushButton>("moreJobs")->click();
    QVERIFY(find<QWidget>("jobList")->isVisible());
    QCOMPARE(find<QWidget>("jobList")->findChildren<QPushButton*>(QStringLiteral("cancelListedJob")).size(), 2);
    QTest::mouseClick(find<QPushButton>("cancelJob"), Qt::LeftButton);
    QVERIFY(waitUntil([this] { return window_->jobs().seen().size() == 1; }));
    QVERIFY(find<QLabel>("jobTitle")->text().startsWith(QStringLiteral("Quietly")));
    window_->jobs().cancelAllAndWait();
    QVERIFY(waitUntil([&] { return !line->isVisible(); }));
    window_->messages().dismiss();
  }

  void aCancelThatWasPressedForOneJobStopsNoOther() {
    const auto ends = std::make_shared<std::atomic<bool>>(false);
    const auto work = [ends](bool byItself) {
      return [ends, byItself](Progress& progress) -> Result<void> {
        while (!progress.cancelRequested() && !(byItself && *ends)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (progress.cancelRequested()) return failure(ErrorCode::cancelled, verbatim("Stopped."));
        return {};
      };
    };
    window_->jobs().start(QStringLiteral("Ends by itself"), work(true), {});
    window_->jobs().start(QStringLiteral("Goes on"), work(false), {});
    auto* cancel = find<QPushButton>("cancelJob");
    QVERIFY(waitUntil([&] { return cancel->isVisible() && find<QPushButton>("moreJobs")->isVisible(); }));
    QCOMPARE(find<QLabel>("jobTitle")->text(), QStringLiteral("Ends by itself"));
    QTest::mousePress(cancel, Qt::LeftButton);
    *ends = true;
    QVERIFY(waitUntil([&] { return window_->jobs().seen().size() == 1 && find<QLabel>("jobTitle")->text() == QLatin1String("Goes on"); }));
    QTest::mouseRelease(cancel, Qt::LeftButton);
    QCOMPARE(window_->jobs().seen().size(), std::size_t{1});
    QVERIFY2(!window_->jobs().seen().front().cancelling, "it was not in front when the button was pressed");
    cancel->click();
    QVERIFY(waitUntil([this] { return window_->jobs().seen().empty(); }));
  }

  /// A case that takes long to be prepared takes nothing away when it is ready: it is offered.
  void aCaseThatGetsReadyIsOfferedAndOpensWhenItIsTaken() {
    const QString open = QString::fromStdString(window_->document().current()->folder.string());
    const QString other = files_.path(QStringLiteral("takes long"));
    test::makeSmallCase(other.toStdString());
    qputenv("ECHOWEAVE_CACHE", files_.path(QStringLiteral("cache of offers")).toUtf8());
    // As on a machine that is a million times slower.
    QDir().mkpath(files_.path(QStringLiteral("cache of offers")));
    QVERIFY(writeFileSafely(files_.path(QStringLiteral("cache of offers/speed.json")).toStdString(), R"({"recording": 1e6})"));
    window_->open(other);
    QVERIFY2(!window_->messages().text().contains(QStringLiteral("being prepared")), "it is read by the job, not by the window");
    QVERIFY2(waitUntil([this] {
               const auto* offer = find<QPushButton>("takeOffer");
               return offer != nullptr && offer->isVisible();
             }),
             qPrintable(window_->messages().text()));
    QCOMPARE(QString::fromStdString(window_->document().current()->folder.string()), open);
    QVERIFY(window_->messages().text().contains(QStringLiteral("is ready")));
    find<QPushButton>("takeOffer")->click();
    QVERIFY(waitUntil([&] { return window_->isSettled() && window_->document().current()->folder == other.toStdString(); }));
    QVERIFY(!find<QPushButton>("takeOffer")->isVisible());
    qunsetenv("ECHOWEAVE_CACHE");
  }

  void aJobThatTakesAMomentShowsACardAndIsCancelledThere() {
    bool stopped = false;
    window_->jobs().start(
        QStringLiteral("Endless"),
        [](Progress& progress) -> Result<void> {
          while (!progress.cancelRequested()) {
            progress.report(verbatim("Turning"), 0.25);
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
          }
          return failure(ErrorCode::cancelled, verbatim("Stopped."));
        },
        [&stopped](const Result<void>& outcome) { stopped = !outcome && outcome.error().code == ErrorCode::cancelled; });
    QVERIFY(waitUntil([this] { return find<QPushButton>("cancelJob") != nullptr && find<QPushButton>("cancelJob")->isVisible(); }));
    QVERIFY2(window_->jobs().seen().front().age_s > 0.25, "a short job must not flash a card");
    QTest::mouseClick(find<QPushButton>("cancelJob"), Qt::LeftButton);
    QVERIFY(waitUntil([&stopped] { return stopped; }));
  }

  void closingInTheMiddleOfWorkStopsAndWaitsForIt() {
    std::atomic<bool> running{false};
    window_->jobs().start(QStringLiteral("Endless"),
                          [&running](Progress& progress) -> Result<void> {
                            running = true;
                            while (!progress.cancelRequested()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
                            running = false;
                            return failure(ErrorCode::cancelled, verbatim("Stopped."));
                          },
                          {});
    QVERIFY(waitUntil([&running] { return running.load(); }));
    QVERIFY(window_->close());
    QVERIFY(!running.load());
    QVERIFY(!window_->jobs().isRunning());
  }

  void bothThemesKeepTheScanBlackAndAreRemembered() {
    for (const bool dark : {false, true}) {
      window_->setDarkTheme(dark);
      QTest::qWait(50);
      const QImage scan = window_->scanView().grab().toImage();
      QCOMPARE(qRed(scan.pixel(4, scan.height() / 2)), 0);
      const QImage console = window_->console().grab().toImage();
      QCOMPARE(qGray(console.pixel(4, console.height() - 4)) < 128, dark);
      QCOMPARE(QSettings().value(QStringLiteral("theme")).toString(), dark ? QStringLiteral("dark") : QStringLiteral("light"));
    }
  }

  void anIconIsPaintedInTheThemeOfNow() {
    const QIcon made = ew::icon(QStringLiteral("undo"));
    for (const bool dark : {false, true}) {
      window_->setDarkTheme(dark);
      const QImage painted = made.pixmap(24, 24).toImage();
      int lightest = 0, darkest = 255;
      for (int y = 0; y < painted.height(); ++y)
        for (int x = 0; x < painted.width(); ++x)
          if (qAlpha(painted.pixel(x, y)) > 200) {
            lightest = std::max(lightest, qGray(painted.pixel(x, y)));
            darkest = std::min(darkest, qGray(painted.pixel(x, y)));
          }
      QVERIFY(lightest >= darkest);  // something was painted
      QCOMPARE(dark ? darkest > 128 : lightest < 128, true);
    }
  }

  void noTextIsClippedAt1280x720() {
    QTest::qWait(300);
    checkNothingIsClipped();
  }

  void noGermanTextIsClippedAt1280x720() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QApplication::installTranslator(&german);
    cleanup();
    init();
    QTest::qWait(300);
    QCOMPARE(find<QPushButton>("freeze")->text(), QStringLiteral("Einfrieren"));
    checkNothingIsClipped();
    QApplication::removeTranslator(&german);
  }

  void theKeysPageFitsTheSmallWindowAndAnyKeyClosesIt() {
    QTest::keyClick(&window_->scanView(), Qt::Key_F1);
    auto* page = find<QFrame>("overlay");
    QVERIFY(page != nullptr && page->isVisible());
    QVERIFY(page->parentWidget()->rect().contains(page->geometry()));
    for (const QLabel* label : page->findChildren<QLabel*>()) {
      QVERIFY2(label->width() >= label->sizeHint().width() - 1, qPrintable(label->text()));
    }
    QTest::keyClick(page, Qt::Key_A);
    QVERIFY(waitUntil([this] { return find<QFrame>("overlay") == nullptr; }));
  }

  void theStartPageOffersTheShippedCasesAndOpen() {
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    QVERIFY(find<QPushButton>("startOpen")->isVisible());
    QCOMPARE(static_cast<std::size_t>(find<QAbstractItemView>("caseCards")->model()->rowCount()),
             listCasesAside(*shippedCasesFolder()).cases.size());
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::WindowTest)
#include "window_test.moc"
