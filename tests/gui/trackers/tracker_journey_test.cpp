// From an empty desk to a scan: print, choose the camera, measure its lens, hold the paper body, touch the mannequin, check, scan, cover
// the marker, come back. The camera is films of rendered paper.
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>

#include "ew/trackers/paper_body.h"
#include "ew/ui_test_door/trackers.h"
#include "gui/support/answers.h"
#include "gui/support/screenshots.h"
#include "gui/support/tracker_films.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class TrackerJourneyTest : public WindowFixture {
  Q_OBJECT

  std::unique_ptr<TrackerFilms> films_;
  std::string camera_;

  [[nodiscard]] Trackers& trackers() const { return window_->trackers(); }
  [[nodiscard]] TrackerWizard* wizard() const { return find<TrackerWizard>("trackerWizard"); }
  template <class Widget>
  [[nodiscard]] Widget* inStep(const char* name) const {
    return wizard()->current().findChild<Widget*>(QLatin1String(name));
  }
  void goOn() { wizard()->findChild<QPushButton*>(QStringLiteral("trackerNext"))->click(); }
  [[nodiscard]] std::string film(const char* name) const { return files_.path(QString::fromLatin1(name)).toStdString(); }
  void play(const std::string& file) { trackers().chooseCamera(camera_, file); }

  /// Held upright on the skin: the beam along the inward normal, the marker to the patient's right.
  [[nodiscard]] Transform<frame::World, frame::Probe> heldAt(const glm::dvec3& at_mm) const {
    const Skin::Contact contact = trackers().mannequin().skin()->nearest(at_mm);
    const glm::dvec3 y = -contact.outward;
    const glm::dvec3 x = glm::normalize(glm::dvec3(-1.0, 0.0, 0.0) - glm::dot(glm::dvec3(-1.0, 0.0, 0.0), y) * y);
    const glm::dvec3 z = glm::cross(x, y);
    return {glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(at_mm, 1.0))};
  }
  [[nodiscard]] glm::dvec3 landmark(const std::string& id) const {
    for (const BodyLandmark& each : trackers().mannequin().landmarks())
      if (each.id == id) return each.at_mm;
    return {};
  }
  [[nodiscard]] bool lookUntil(const char* what, const std::function<bool()>& ready) const {
    if (waitUntil(ready, 90000.0 * test::kSlowdown)) return true;
    qWarning("%s did not come: %s", what, qPrintable(QString::fromStdString(trackers().deviceStatus().sentence.english())));
    for (const QLabel* each : wizard() != nullptr ? wizard()->current().findChildren<QLabel*>() : QList<QLabel*>())
      if (!each->objectName().isEmpty()) qWarning("  %s: %s", qPrintable(each->objectName()), qPrintable(each->text()));
    return false;
  }

 private Q_SLOTS:
  void fromPaperToAScanAndThroughALoss() {
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
    QVERIFY(waitUntil([this] { return trackers().mannequin().skin() != nullptr && !trackers().papers().all().empty(); }));
    for (const TrackerSettings& each : trackers().all())
      if (std::holds_alternative<CameraSource>(each.source)) camera_ = each.id;
    QVERIFY(!camera_.empty());
    MarkerBody probe, board;
    for (const PaperBody& each : trackers().papers().all()) {
      if (each.id == "box-60") probe = foldedBody(each);
      if (each.kind == PaperKind::board) board = foldedBody(each);
    }
    films_ = std::make_unique<TrackerFilms>(probe, board, trackers().papers().charucoBoard());
    print();
    if (QTest::currentTestFailed()) return;
    calibrate();
    if (QTest::currentTestFailed()) return;
    hold();
    if (QTest::currentTestFailed()) return;
    align();
    if (QTest::currentTestFailed()) return;
    check();
    if (QTest::currentTestFailed()) return;
    scanThroughALoss();
  }

 private:
  void print() {
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text() == MainWindow::tr("&Tracker…")) each->trigger();
    auto* page = find<TrackerPage>("trackerPage");
    QVERIFY(page && page->isVisible());
    page->choose(camera_);
    keepScreenshot(*page, "journey-0-page");
    page->findChild<QPushButton*>(QStringLiteral("trackerSetUp"))->click();
    QVERIFY(wizard() && wizard()->isVisible());
    QCOMPARE(wizard()->step(), 0);
    auto* bodies = inStep<QComboBox>("trackerBodies");
    QVERIFY(bodies->count() > 0);
    bodies->setCurrentIndex(bodies->findData(QStringLiteral("box-60")));
    Q_EMIT bodies->activated(bodies->currentIndex());
    const QString sheet = files_.path(QStringLiteral("markers.pdf"));
    Answers answers({{QStringLiteral("fileDialog"), type(sheet)}});
    inStep<QPushButton>("trackerSaveSheet")->click();
    QVERIFY(QFile::exists(sheet) && QFileInfo(sheet).size() > 2000);
    inStep<QAbstractButton>("trackerPaperReady")->setChecked(true);
    QVERIFY(wizard()->current().isDone());
    keepScreenshot(*wizard(), "journey-1-print");
    goOn();
  }

  void calibrate() {
    QVERIFY(films_->writeChess(film("chess.avi")));
    play(film("chess.avi"));
    trackers().use(camera_);
    QVERIFY(lookUntil("the image", [this] { return inStep<TrackerCameraView>("trackerCamera")->hasImage(); }));
    QVERIFY(lookUntil("the camera step", [this] { return wizard()->current().isDone(); }));
    keepScreenshot(*wizard(), "journey-2-camera");
    goOn();
    QVERIFY(lookUntil("four kept images", [this] { return dynamic_cast<TrackerLensStep&>(wizard()->current()).views() >= 4; }));
    keepScreenshot(*wizard(), "journey-3-lens");
    QVERIFY(lookUntil("the lens", [this] { return wizard()->current().isDone(); }));
    keepScreenshot(*wizard(), "journey-3-lens-done");
    const CameraModel& found = *trackers().cameraOf(camera_)->model;
    QVERIFY2(std::abs(found.fx - films_->lens().fx) < 15.0, qPrintable(QString::number(found.fx)));
    QVERIFY2(found.rms_px < 0.5, qPrintable(QString::number(found.rms_px)));
    goOn();
  }

  void hold() {
    QVERIFY(films_->writePaper(film("hold.avi"), {heldAt(landmark("navel")), heldAt(landmark("navel") + glm::dvec3(20.0, -60.0, 20.0))}));
    play(film("hold.avi"));
    QVERIFY(lookUntil("the body", [this] { return wizard()->current().isDone(); }));
    QVERIFY(inStep<TrackerCameraView>("trackerCamera")->outlineCount() >= 2);
    keepScreenshot(*wizard(), "journey-4-hold");
    goOn();
  }

  void align() {
    auto& step = dynamic_cast<TrackerAlignStep&>(wizard()->current());
    QVERIFY(!step.next().empty());
    const std::string places[] = {"xiphoid", "navel", "iliac-spine-left", "costal-margin-right"};  // that this camera sees well
    for (std::size_t n = 0; n < 4; ++n) {
      const std::string& place = places[n];
      Q_EMIT inStep<TrackerBodyDrawing>("trackerBody")->chosen(QString::fromStdString(place));
      QCOMPARE(step.next(), place);
      const std::string file = film(qPrintable(QStringLiteral("touch%1.avi").arg(n)));
      QVERIFY(films_->writePaper(file, {heldAt(landmark(place))}));
      play(file);
      QVERIFY(lookUntil("a touch", [&] { return trackers().mannequin().touches(camera_).size() == n + 1; }));
      if (n == 1) keepScreenshot(*wizard(), "journey-5-align");
    }
    QVERIFY(step.isDone());
    QVERIFY(trackers().mannequin().alignment(camera_).wrong.empty());
    keepScreenshot(*wizard(), "journey-5-align-done");
    // The board is the tracker's frame: the truth is where the films have it.
    const glm::dmat4 found = trackers().calibrationOf(camera_).trackerToWorld.matrix;
    for (const std::string place : {"navel", "xiphoid"}) {
      const glm::dvec4 at = glm::inverse(films_->boardToWorld()) * glm::dvec4(landmark(place), 1.0);
      const double off_mm = glm::distance(glm::dvec3(found * at), landmark(place));
      QVERIFY2(off_mm < 3.0, qPrintable(QStringLiteral("%1: %2 mm").arg(QString::fromStdString(place)).arg(off_mm)));
    }
    goOn();
  }

  void check() {
    auto& step = dynamic_cast<TrackerCheckStep&>(wizard()->current());
    int n = 0;
    for (const char* place : {"costal-margin-left", "iliac-spine-right", "xiphoid"}) {
      const std::string file = film(qPrintable(QStringLiteral("check%1.avi").arg(n)));
      QVERIFY(films_->writePaper(file, {heldAt(landmark(place))}));
      play(file);
      ++n;
      QVERIFY(lookUntil("a check", [&] { return step.places() >= static_cast<std::size_t>(n); }));
    }
    keepScreenshot(*wizard(), "journey-6-check");
    QVERIFY(step.isDone());
    goOn();
    QVERIFY(waitUntil([this] { return wizard() == nullptr || !wizard()->isVisible(); }));
  }

  /// From an image's arrival at the program to the scan on the screen, with a film as the camera: what a camera itself takes is not in it.
  void sayLatency() {
    const auto& latency = session().frames().latency();
    QVERIFY(waitUntil([&] { return latency.count() >= 30; }));
    qInfo("from capture to image: camera to reading %.1f ms in the median; to the image %.1f, 95 %% %.1f ms, of %llu",
          trackers().cameraView().value_or(CameraView{}).latency_ms, 1e-3 * latency.quantile_us(0.5), 1e-3 * latency.quantile_us(0.95),
          static_cast<unsigned long long>(latency.count()));
  }

  void scanThroughALoss() {
    const glm::dvec3 from = landmark("xiphoid");
    const glm::dvec3 to = landmark("navel");
    std::vector<Transform<frame::World, frame::Probe>> way;
    for (int n = 0; n <= 4; ++n) way.push_back(heldAt(trackers().mannequin().skin()->nearest(glm::mix(from, to, n / 4.0)).point_mm));
    QVERIFY(films_->writePaper(film("scan.avi"), way));
    play(film("scan.avi"));
    const std::uint64_t frames = session().frames().framesMade();
    QVERIFY(waitUntil([&] { return trackers().report().state == TrackingState::live && session().frames().framesMade() > frames + 10; }));
    QVERIFY(session().probeControl().mover() == ProbeControl::Mover::tracker && !session().probeControl().isLost());
    const glm::dvec3 at = session().probeControl().pose().probeToWorld.matrix[3];
    QVERIFY2(std::abs(MannequinTouches::gap_mm(*trackers().mannequin().skin(), at)) < 8.0,
             qPrintable(QString::number(MannequinTouches::gap_mm(*trackers().mannequin().skin(), at))));
    const auto* said = find<QPushButton>("trackingState");
    QVERIFY(waitUntil([&] { return said->isVisible() && said->text() == lookOf(TrackingState::live).word; }));
    keepScreenshot(*window_, "journey-7-scan");
    sayLatency();
    QVERIFY(films_->writeEmpty(film("empty.avi")));
    play(film("empty.avi"));
    QVERIFY(waitUntil([this] { return session().probeControl().isLost(); }));
    QVERIFY(waitUntil([this] { return trackers().report().state == TrackingState::outOfView; }));
    QVERIFY(waitUntil([&] { return said->text() == lookOf(TrackingState::outOfView).word; }));
    keepScreenshot(*window_, "journey-8-lost");
    play(film("scan.avi"));
    QVERIFY(waitUntil([this] { return trackers().report().state == TrackingState::live && !session().probeControl().isLost(); }));
    keepScreenshot(*window_, "journey-9-back");
    trackers().useMouse();
    QVERIFY(session().probeControl().mover() == ProbeControl::Mover::hand);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::TrackerJourneyTest)
#include "tracker_journey_test.moc"
