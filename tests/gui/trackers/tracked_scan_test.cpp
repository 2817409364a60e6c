// A probe in a tracker, scripted here: who has the probe, what is shown while it is lost, and how it goes on.
#include <QComboBox>
#include <QImage>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "ew/scanning/replay.h"
#include "ew/trackers/igtl_client.h"
#include "ew/ui_test_door/body.h"
#include "ew/ui_test_door/cine.h"
#include "ew/ui_test_door/trackers.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"
#include "tracking/scripted_tracker.h"

namespace ew::ui::testing {

class TrackedScanTest final : public WindowFixture {
  Q_OBJECT

 private:
  std::shared_ptr<test::ScriptedTracker> device_;
  std::shared_ptr<TrackedProbe> probe_;
  std::unique_ptr<QTimer> readings_;
  TrackingState state_ = TrackingState::live;
  std::function<glm::dmat4(double)> path_;
  glm::dmat4 onSkin_{1.0};
  QElapsedTimer clock_;
  bool repeats_ = false;
  ToolReading last_;

  [[nodiscard]] glm::dmat4 moved(const glm::dvec3& by_probe_mm) const { return glm::translate(onSkin_, by_probe_mm); }

  /// 60 readings a second of a probe that slides to and fro on the belly, until somebody says otherwise.
  void startTracker() {
    onSkin_ = session().probeControl().pose().probeToWorld.matrix;
    path_ = [this](double t) { return moved({8.0 * std::sin(1.5 * t), 0.0, 5.0 * std::sin(0.7 * t)}); };
    state_ = TrackingState::live;
    repeats_ = false;
    device_ = std::make_shared<test::ScriptedTracker>();
    device_->onNews(session().probeControl().newsOfTracker());
    device_->start();
    probe_ =
        std::make_shared<TrackedProbe>(device_, TrackedProbeOptions{}, TrackerCalibration{}, session().probeControl().steadyMinusScan_s());
    readings_ = std::make_unique<QTimer>();
    readings_->setTimerType(Qt::PreciseTimer);
    connect(readings_.get(), &QTimer::timeout, this, &TrackedScanTest::read);
    clock_.start();
    readings_->start(16);
    session().probeControl().setTracked(probe_);
  }
  void read() {
    ToolReading reading;
    reading.tool = "probe";
    reading.state = state_;
    reading.toolToTracker = {path_(0.001 * static_cast<double>(clock_.elapsed()))};
    reading.device_s = reading.arrival_s = steadyNow_s();
    if (repeats_) {
      reading.toolToTracker = last_.toolToTracker;
      reading.device_s = last_.device_s;
    }
    last_ = reading;
    device_->read(reading);
  }
  /// Brings the tracker into a state as such trackers come into it.
  void bring(TrackingState state) {
    state_ = TrackingState::live;
    switch (state) {
      case TrackingState::stale:
        readings_->stop();
        break;
      case TrackingState::lost:
        device_->setLink(LinkState::connecting, say<"Waiting for '%1' to come back.">(std::string("localhost:18944")));
        break;
      case TrackingState::off:
        device_->setLink(LinkState::off);
        break;
      case TrackingState::duplicate:
        repeats_ = true;
        break;
      default:
        state_ = state;
    }
  }
  void bringBack() {
    state_ = TrackingState::live;
    repeats_ = false;
    device_->setLink(LinkState::connected);
    readings_->start(16);
  }
  [[nodiscard]] bool isLive() const {
    return session().probeControl().mover() == ProbeControl::Mover::tracker && !session().probeControl().isLost();
  }
  [[nodiscard]] bool goesOn() const {
    const auto before = session().frames().framesMade();
    return waitUntil([&] { return isLive() && session().frames().framesMade() > before + 3; });
  }
  [[nodiscard]] QImage viewed() const { return window_->scanView().grab().toImage().convertToFormat(QImage::Format_RGB32); }
  /// Mean grey of what is shown of the image, beside the words in its middle.
  [[nodiscard]] double light() const {
    const QImage image = viewed();
    const QRect box = window_->scanView().imageRect();
    const QRect part(box.left() + box.width() / 3, box.bottom() - box.height() / 4, box.width() / 3, box.height() / 6);
    double sum = 0.0;
    for (int y = part.top(); y < part.bottom(); ++y)
      for (int x = part.left(); x < part.right(); ++x) sum += qGray(image.pixel(x, y));
    return sum / (static_cast<double>(part.width()) * part.height());
  }
  [[nodiscard]] int pixelsOfColour(const QImage& image, const QColor& colour) const {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == colour.rgb() ? 1 : 0;
    return count;
  }

 private Q_SLOTS:
  void init() { showWindowWithCase(files_.writeCase(QStringLiteral("case"))); }
  void cleanup() {
    if (session().probeControl().tracked()) session().probeControl().setTracked(nullptr);
    readings_.reset();
    probe_.reset();
    device_.reset();
    window_.reset();
  }

  void theProbeFollowsTheTrackerAndTheMouseRests() {
    startTracker();
    QVERIFY(goesOn());
    const auto isThere = [&] {
      const Pose shown = session().shownState().pose;
      const double t = 0.001 * static_cast<double>(clock_.elapsed());
      return shown.status == PoseStatus::ok && glm::distance(shown.probeToWorld.matrix[3], glm::dvec4(path_(t)[3])) < 2.0;
    };
    QVERIFY(waitUntil(isThere));
    auto* hand = window_->findChild<HandInput*>();
    QVERIFY(hand == nullptr || !hand->isEnabled());
    QVERIFY(session().probeControl().handRests());
    const Hold before = session().probeControl().hold();
    session().probeControl().setHold(turned(before, 0.5, 0.0, 0.0));
    QVERIFY(goesOn());
    QCOMPARE(session().probeControl().mover(), ProbeControl::Mover::tracker);
    QVERIFY2(session().frames().latency().count() > 3, "images of readings are timed");
    qInfo("from measurement to image: median %.1f ms, 95 %% %.1f ms, of %llu", 1e-3 * session().frames().latency().quantile_us(0.5),
          1e-3 * session().frames().latency().quantile_us(0.95), static_cast<unsigned long long>(session().frames().latency().count()));
    // Without a tracker the hand goes on where it was last.
    const glm::dvec4 there = session().shownState().pose.probeToWorld.matrix[3];
    session().probeControl().setTracked(nullptr);
    QVERIFY(glm::distance(glm::dvec3(session().probeControl().pose().probeToWorld.matrix[3]), glm::dvec3(there)) < 15.0);
    QVERIFY(!session().probeControl().handRests());
  }

  void everyStateHasAnImageOfItsOwnAndNoneLooksLive() {
    startTracker();
    QVERIFY(goesOn());
    const double live = light();
    std::vector<QImage> seen{viewed()};
    for (const TrackingState state : {TrackingState::outOfView, TrackingState::outOfRange, TrackingState::invalid, TrackingState::duplicate,
                                      TrackingState::stale, TrackingState::lost, TrackingState::off}) {
      bring(state);
      QVERIFY2(waitUntil([&] { return session().probeControl().isLost() && session().probeControl().tracking().state == state; }),
               qPrintable(QString::number(static_cast<int>(state))));
      const auto made = session().frames().framesMade();
      const std::uint64_t cine = session().cineLoop().ring().frameCount();
      QTest::qWait(200);
      QVERIFY2(light() < 0.55 * live, "it is pale");
      const QImage here = viewed();
      QVERIFY2(pixelsOfColour(here, lossColour(state)) > 100, "its border has its colour");
      for (const QImage& other : seen) QVERIFY(here != other);
      seen.push_back(here);
      QVERIFY2(session().frames().framesMade() == made && session().cineLoop().ring().frameCount() == cine,
               "nothing is made of a pose that nobody knows");
      keepScreenshot(*window_, qPrintable(QStringLiteral("tracked-%1").arg(static_cast<int>(state))));
      bringBack();
      QVERIFY2(goesOn(), "it goes on by itself");
      QVERIFY(std::abs(light() - live) < 0.3 * live);
    }
    session().setFrozen(true);
    const QImage frozen = viewed();
    for (const QImage& other : seen) QVERIFY(frozen != other);
    keepScreenshot(*window_, "tracked-frozen");
    QVERIFY2(light() > 0.7 * live, "a frozen image keeps its light");
  }

  void aLossCanBeFrozenAndRunsOn() {
    startTracker();
    QVERIFY(goesOn());
    bring(TrackingState::outOfView);
    QVERIFY(waitUntil([&] { return session().probeControl().isLost(); }));
    const Pose last = session().shownState().pose;
    const auto pixels = pixelsOf(session());
    session().setFrozen(true);
    QVERIFY(session().isFrozen() && !session().probeControl().isLost());
    QVERIFY2(session().imagePose() == last, "frozen is what was seen last, with its pose");
    QCOMPARE(pixelsOf(session()), pixels);
    session().setFrozen(false);
    QVERIFY2(waitUntil([&] { return session().probeControl().isLost(); }), "it is still lost");
    // A window of another size still shows the image from before, as pale.
    window_->resize(1400, 800);
    QVERIFY(waitUntil([&] { return session().probeControl().isLost() && session().image().width() == session().imageSize_px().x; }));
    QVERIFY(session().shownState().pose == last);
    bringBack();
    QVERIFY(goesOn());
  }

  void theMouseTakesOverWhatIsLostAndTheTrackerTakesItBack() {
    startTracker();
    QVERIFY(goesOn());
    bring(TrackingState::outOfView);
    QVERIFY(waitUntil([&] { return session().probeControl().isLost(); }));
    const Pose last = session().shownState().pose;
    QVERIFY2(waitUntil([&] { return !session().probeControl().handRests(); }), "after a second the hand may move");
    const glm::dvec3 ready(poseOf(session().probeControl().hold()).probeToWorld.matrix[3]);
    QVERIFY2(glm::distance(ready, glm::dvec3(last.probeToWorld.matrix[3])) < 15.0, "from where it was tracked last");
    QTest::qWait(200);
    keepScreenshot(*window_, "tracked-mouse-may");
    const auto before = session().frames().framesMade();
    // A drag in the image.
    ScanView& scan = window_->scanView();
    const QPoint middle = scan.imageRect().center();
    QTest::mousePress(&scan, Qt::LeftButton, {}, middle);
    QMouseEvent drag(QEvent::MouseMove, middle + QPoint(30, 0), Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(&scan, &drag);
    QTest::mouseRelease(&scan, Qt::LeftButton, {}, middle + QPoint(30, 0));
    QCOMPARE(session().probeControl().mover(), ProbeControl::Mover::handMeanwhile);
    QVERIFY(waitUntil([&] { return session().frames().framesMade() > before; }));
    QVERIFY(!session().probeControl().isLost());
    QVERIFY(session().shownState().pose.status == PoseStatus::ok);
    keepScreenshot(*window_, "tracked-mouse");
    bringBack();
    QVERIFY2(waitUntil([&] { return isLive(); }), "the tracker takes its probe again");
    QVERIFY(session().probeControl().handRests());

    session().probeControl().chooseMouse(true);
    QCOMPARE(session().probeControl().mover(), ProbeControl::Mover::hand);
    QTest::qWait(400);
    QVERIFY2(session().probeControl().mover() == ProbeControl::Mover::hand && !session().probeControl().handRests(),
             "who chose the mouse keeps it");
    session().probeControl().chooseMouse(false);
    QVERIFY(goesOn());
  }

  void aPluginGoesFirstAndGivesTheProbeBackToTheTracker() {
    startTracker();
    QVERIFY(goesOn());
    const Pose elsewhere{.probeToWorld = {moved({30.0, 0.0, 0.0})}};
    session().probeControl().follow(std::make_shared<PosePath>(std::vector<PoseSample>{{0.0, elsewhere}}));
    QCOMPARE(session().probeControl().mover(), ProbeControl::Mover::plugin);
    QVERIFY(waitUntil([&] { return session().shownState().pose == elsewhere; }));
    bring(TrackingState::outOfView);
    QTest::qWait(300);
    QVERIFY2(!session().probeControl().isLost(), "what the tracker sees is not asked meanwhile");
    session().probeControl().follow(nullptr);
    QVERIFY(waitUntil([&] { return session().probeControl().isLost(); }));
    bringBack();
    QVERIFY(goesOn());
  }

  void aCaseThatOpensWithoutATrackerIsScannedWithTheMouse() {
    startTracker();
    QVERIFY(goesOn());
    bring(TrackingState::lost);
    QVERIFY(openCase(files_.writeCase(QStringLiteral("another"))));
    QVERIFY(
        waitUntil([&] { return session().probeControl().mover() == ProbeControl::Mover::handMeanwhile && !session().image().isEmpty(); }));
    QVERIFY2(!session().probeControl().isLost() && !session().probeControl().handRests(),
             "there was no image of this case that could be shown as lost");
    bringBack();
    QVERIFY(goesOn());
  }

  void whatIsRecordedComesAgainPixelForPixelThroughALoss() {
    startTracker();
    Knobs knobs = session().console().knobs();
    knobs.persistence = 0.5;
    session().console().setKnobs(knobs);
    QVERIFY(goesOn());
    Recorder& recorder = window_->recorder();
    recorder.start("window-test");
    std::vector<std::vector<std::uint8_t>> seen;
    const auto look = connect(&session(), &Session::imageChanged, this, [&] {
      if (!session().probeControl().isLost() && !session().isFrozen()) seen.push_back(pixelsOf(session()));
    });
    QVERIFY(waitUntil([&] { return seen.size() > 12; }));
    bring(TrackingState::outOfView);
    QVERIFY(waitUntil([&] { return session().probeControl().isLost(); }));
    QTest::qWait(400);
    const std::size_t before = seen.size();
    bringBack();
    QVERIFY(waitUntil([&] { return seen.size() > before + 12; }));
    const glm::ivec2 size(session().image().width(), session().image().height());
    disconnect(look);
    const auto recording = recorder.stop();
    QVERIFY(recording != nullptr);
    Replay replay(recording->log, *session().subject(), 2);
    std::size_t shown = 0, missed = 0;
    for (std::size_t n = 0; n < recording->log.frameCount(); ++n) {
      const ImageView<const std::uint8_t> again = replay.make(n, size.x, size.y).grey;
      if (recording->log.frame(n).pose.status != PoseStatus::ok) {
        ++missed;
        continue;
      }
      QVERIFY(shown < seen.size());
      for (int y = 0; y < again.height; ++y)
        QVERIFY2(std::equal(again.row(y), again.row(y) + again.width, seen[shown].data() + std::ptrdiff_t{y} * again.width),
                 qPrintable(QStringLiteral("image %1, row %2").arg(shown).arg(y)));
      ++shown;
    }
    QCOMPARE(shown, seen.size());
    QVERIFY2(missed >= 3, "the gap is in the recording");
    std::vector<std::string> told;
    for (const ScanEvent& event : recording->log.events())
      if (const auto* note = std::get_if<Note>(&event.what); note != nullptr && note->kind == "tracking")
        told.push_back(note->what["state"]);
    QVERIFY2(std::count(told.begin(), told.end(), "out of view") == 1 && told.back() == "live", "and why it is there");
  }

  void aFreePoseIsInTheAirAndSaysSo() {
    startTracker();
    QVERIFY(goesOn());
    const double live = light();
    path_ = [this](double) { return moved({0.0, -60.0, 0.0}); };
    QVERIFY(waitUntil([&] {
      return session().probeControl().face() && session().probeControl().face()->how == FaceOnSkin::inAir &&
             session().probeControl().face()->away_mm > 40.0;
    }));
    QTest::qWait(100);
    QVERIFY2(light() < 0.1 * live, "the image is dark below the near field");
    keepScreenshot(*window_, "tracked-air");
    path_ = [this](double) { return glm::rotate(moved({0.0, 2.0, 0.0}), 3.1, glm::dvec3(0.0, 0.0, 1.0)); };
    QVERIFY(waitUntil([&] { return session().probeControl().face() && session().probeControl().face()->how == FaceOnSkin::looksAway; }));
    QTest::qWait(100);
    QVERIFY2(light() < 0.1 * live, "upside down near the skin is in the air as well");
    keepScreenshot(*window_, "tracked-upside-down");
    path_ = [this](double) { return moved({0.0, 45.0, 0.0}); };
    QVERIFY(waitUntil([&] { return session().probeControl().face() && session().probeControl().face()->how == FaceOnSkin::tooDeep; }));
    keepScreenshot(*window_, "tracked-deep");
    path_ = [this](double) { return glm::rotate(moved({0.0, -14.0, 0.0}), 0.52, glm::dvec3(0.0, 0.0, 1.0)); };
    QVERIFY(waitUntil([&] { return session().probeControl().face() && session().probeControl().face()->how == FaceOnSkin::partly; }));
    keepScreenshot(*window_, "tracked-slanted");
  }

  void aProbeAtRestIsSeenByOurOwnClientAndTheServerSaysWhoIsThere() {
    showWindowWithCase(files_.writeCase(QStringLiteral("resting")));
    session().setFrozen(false);
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    ScanServer server(session());
    const QSignalSpy said(&server, &ScanServer::clientsChanged);
    IgtlServerOptions options;
    options.port = 0;
    const auto port = server.start(options);
    QVERIFY(port.has_value());
    const auto client = makeIgtlClient({"localhost", *port, true});
    client->start();
    std::vector<ToolReading> heard;
    const auto hear = [&] {
      for (ToolReading& each : client->take())
        if (each.tool == options.poseName) heard.push_back(std::move(each));
      return heard.size();
    };
    QVERIFY(waitUntil([&] { return hear() > 0; }));
    QVERIFY(waitUntil([&] { return said.count() == 1; }));
    const std::uint64_t images = session().frames().framesMade();
    QVERIFY(waitUntil([&] { return hear() >= 6; }));  // without a change of the image there was one alone
    QCOMPARE(session().frames().framesMade(), images);
    for (const ToolReading& each : heard) QCOMPARE(each.state, TrackingState::live);
    client->stop();
    QVERIFY(waitUntil([&] { return said.count() == 2 && server.status().clients == 0; }));
  }

  void othersSeeTheScanAndThatItIsLost() {
    startTracker();
    QVERIFY(goesOn());
    ScanServer server(session());
    IgtlServerOptions options;
    options.port = 0;
    const auto port = server.start(options);
    QVERIFY(port.has_value());
    const auto client = makeIgtlClient({"localhost", *port, true});
    client->start();
    std::optional<ToolReading> pose;
    const auto hear = [&] {
      for (ToolReading& each : client->take())
        if (each.tool == options.poseName && each.state == TrackingState::live) pose = std::move(each);
      return pose.has_value();
    };
    QVERIFY(waitUntil(hear));
    QCOMPARE(server.status().clients, 1);
    // Slicer's world looks to the right and to the front.
    const glm::dvec3 lps = glm::dvec3(pose->toolToTracker.matrix[3]) * glm::dvec3(-1.0, -1.0, 1.0);
    QVERIFY(glm::distance(lps, glm::dvec3(onSkin_[3])) < 20.0);
    bring(TrackingState::outOfView);
    QVERIFY(waitUntil([&] { return session().probeControl().isLost(); }));
    QTest::qWait(300);
    static_cast<void>(client->take());
    pose.reset();
    QTest::qWait(400);
    QVERIFY2(!hear(), "no pose is sent that nobody knows");
    bringBack();
    QVERIFY(waitUntil(hear));
    client->stop();
    server.stop();
    QVERIFY(!server.isRunning());
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::TrackedScanTest)
#include "tracked_scan_test.moc"
