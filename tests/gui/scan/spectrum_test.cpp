// Spectral Doppler in the window: its mode, the sample volume in the image, the strip with its values, its controls and its sound.
// EW_SCREENSHOTS=FOLDER keeps images of the window. The shipped neck is skipped where it is not prepared.
#include <QCheckBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTranslator>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ew/imaging/flow_field.h"
#include "ew/library/case_truth.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/spectrum.h"
#include "ew/widgets/apply_theme.h"
#include "gui/support/case_aside.h"
#include "gui/support/doppler_fixture.h"
#include "gui/support/screenshots.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

class SpectrumTest : public DopplerFixture {
  Q_OBJECT

 private:
  static constexpr double kBeat_s = 0.8, kVesselDepth_mm = 25.0;

  [[nodiscard]] SpectralDoppler spectral() const { return *knobs().spectral; }
  [[nodiscard]] SpectralGate gate() const { return spectralGateOf(session().console().probe(), knobs()); }
  [[nodiscard]] GateOutline outline() const { return outlineOfGate(scan(), session().console().probe(), knobs()); }
  [[nodiscard]] DopplerSpeaker& speaker() const { return *window_->findChild<DopplerSpeaker*>(); }
  [[nodiscard]] QString textOf(const char* label) const { return find<QLabel>(label)->text(); }
  void switchOn() const {
    press("modePw");
    QVERIFY(knobs().mode == DisplayMode::spectrum);
    session().makeImageNow();
  }
  /// A vessel in the image plane, at 60 degrees to lines straight down, through their middle at 25 mm; blood comes towards the probe.
  [[nodiscard]] FlowField pulsingVessel() const {
    const Transform<frame::World, frame::Probe> probeToWorld = session().probeControl().pose().probeToWorld;
    const auto place = [&](double along_mm) {
      const glm::dvec2 way(std::sin(glm::radians(60.0)), std::cos(glm::radians(60.0)));
      return glm::dvec3(probeToWorld.matrix * glm::dvec4(along_mm * way.x, kVesselDepth_mm + along_mm * way.y, 0.0, 1.0));
    };
    FlowStream stream;
    stream.name = "vessel";
    for (const double along_mm : {40.0, 0.0, -40.0}) stream.line.push_back({.place_mm = place(along_mm), .radius_mm = 3.0});
    stream.flow_mm3PerS = 5000.0;
    stream.bluntness = 6.0;
    stream.wave = waveThrough({0.5, 2.6, 2.2, 1.5, 1.1, 0.9, 1.0, 0.9, 0.8, 0.7, 0.65, 0.6, 0.58, 0.55, 0.52, 0.5}, 7);
    FlowField field;
    field.rhythms.pulse = BodyRhythm{.period_s = kBeat_s};
    field.streams = {stream};
    return field;
  }
  void showPulsingVessel() const {
    showFlowingBlood();  // the linear probe stands where it will
    ScanSubject subject = *session().subject();
    subject.flow = std::make_shared<const FlowSampler>(pulsingVessel());
    subject.scene.noise = NoiseEffect{};
    session().show(subject);
    session().makeImageNow();
  }
  /// What a trace without noise and without a window's width would read of the vessel, at the columns of a strip; in mm/s.
  [[nodiscard]] WaveformValues truth() const {
    const FlowField field = pulsingVessel();
    const FlowTruth truth(field);
    std::vector<double> times_s, envelope;
    constexpr double kColumn_s = 0.0075;
    for (double time_s = 0.0; time_s < 3.0 * kBeat_s; time_s += kColumn_s) {
      times_s.push_back(time_s);
      envelope.push_back(truth.sectionNear(0, field.streams.front().line[1].place_mm, time_s)->greatest_mmPerS());
    }
    return waveformOf(times_s, envelope, envelope).value_or(WaveformValues{});
  }
  /// Frames of a scan that goes on, as a recording of it has them: whatever the machine takes for them.
  void playFor(double seconds) const {
    ScanState state = session().shownState();
    state.knobs = knobs();
    constexpr double kStep_s = 0.04;
    for (double time_s = 0.0; time_s < seconds; time_s += kStep_s) {
      state.time_s += kStep_s;
      ++state.number;
      session().play(state);
      session().makeImageNow();
    }
  }
  [[nodiscard]] static std::vector<std::uint8_t> stripOf(const Session& session) {
    const ImageView<const std::uint8_t> strip = session.seen().strip();
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < strip.height; ++y) pixels.insert(pixels.end(), strip.row(y), strip.row(y) + strip.width);
    return pixels;
  }
  /// For a person to look at: sizes of window and text, themes, an angle that is too large.
  void keepInManyShapes() const {
    if (screenshotFolder().isEmpty()) return;
    window_->console().showPage(find<QCheckBox>("colour"));
    const auto keep = [this](const QString& name) {
      QTest::qWait(100);
      playFor(3.6);
      keepScreenshot(*window_, qPrintable(QStringLiteral("carotid-") + name));
    };
    for (const QSize& size : {QSize(1024, 640), QSize(1366, 768), QSize(1600, 900)})
      for (const int percent : {100, 200}) {
        window_->resize(size);
        setTextSize(percent);
        applyTheme(percent == 200 ? lightTheme() : darkTheme());
        keep(QStringLiteral("%1-%2").arg(size.width()).arg(percent));
      }
    setTextSize(100);
    applyTheme(lightTheme());
    session().play({});
    slide("spectralAngle", -68);
    press("colour");
    keep(QStringLiteral("beyond"));
    QTest::mouseMove(&scan(), outline().flowTo.toPoint());
  }
  void turnWheelAt(const QPointF& at, int notches) const {
    QWheelEvent event(at, scan().mapToGlobal(at.toPoint()), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&scan(), &event);
  }

 private Q_SLOTS:
  void initTestCase() {
    initTranslations();
    qputenv("SDL_AUDIODRIVER", "dummy");
  }
  void init() {
    openConsole();
    QSettings().setValue(QStringLiteral("fold/spectralAdvanced"), true);
  }
  void cleanup() { window_.reset(); }

  void theModeIsThereOnlyWhereBloodIsKnown() {
    QVERIFY(find<QPushButton>("modePw")->isHidden());
    QTest::keyClick(&scan(), Qt::Key_V, Qt::ShiftModifier);
    QVERIFY2(knobs().mode == DisplayMode::bMode, "a key does what no control does");
    const ScanSubject bloodless = *session().subject();
    showFlowingBlood();
    auto* mode = find<QPushButton>("modePw");
    QVERIFY(!mode->isHidden());
    QCOMPARE(mode->accessibleName(), QStringLiteral("Spectral Doppler"));
    QVERIFY2(!find<QSlider>("spectralGain")->isEnabled(), "the mode is another one");
    QTest::keyClick(&scan(), Qt::Key_V, Qt::ShiftModifier);
    session().makeImageNow();
    QVERIFY(knobs().mode == DisplayMode::spectrum);
    QVERIFY(std::abs(gate().depth_mm - 25.0) < 1e-9 && std::abs(gate().middle_mm.x) < 1e-9);
    QVERIFY(scan().stripRect().top() > scan().imageRect().bottom());
    QVERIFY(session().seen().strip().width > 0);
    QVERIFY2(find<QSlider>("mLine")->parentWidget()->isHidden(), "no M line is drawn");
    QVERIFY(!find<QSlider>("sweep")->parentWidget()->isHidden());
    QTest::keyClick(&scan(), Qt::Key_M);
    QVERIFY2(knobs().mode == DisplayMode::bMode, "behind the last mode is the first");
    QTest::keyClick(&scan(), Qt::Key_V, Qt::ShiftModifier);
    session().show(bloodless);
    session().makeImageNow();
    QVERIFY(knobs().mode == DisplayMode::bMode && mode->isHidden());
    QVERIFY(scan().stripRect().isEmpty());
    QTest::keyClick(&scan(), Qt::Key_M);
    QTest::keyClick(&scan(), Qt::Key_M);
    QTest::keyClick(&scan(), Qt::Key_M);
    QVERIFY2(knobs().mode == DisplayMode::bMode, "a mode that is not there has no turn");
  }

  void theSampleVolumeBeginsInTheColourBox() {
    showFlowingBlood();
    press("colour");
    Knobs moved = withColourBoxAt(session().console().probe(), knobs(), {8.0, 32.0});
    moved.colour->steering_rad = glm::radians(15.0);
    session().console().setKnobs(moved);
    const ColourBox box = colourBoxOf(session().console().probe(), knobs());
    switchOn();
    QVERIFY(std::abs(gate().depth_mm - 0.5 * (box.top_mm + box.bottom_mm)) < 1e-6);
    QVERIFY(std::abs(spectral().line - 0.5 * (box.left + box.right)) < 1e-6);
    QVERIFY(std::abs(spectral().steering_rad - box.steering_rad) < 1e-9);
  }

  void aDragOfTheVolumeMovesItAndNothingElse() {
    showFlowingBlood();
    press("colour");
    switchOn();
    slide("spectralGate", 16);
    const Hold hold = session().probeControl().hold();
    Knobs wanted = knobs();
    const SpectralGate before = gate();
    const QPoint from = outline().middle.toPoint();
    moveTo(from, Qt::NoButton);
    QCOMPARE(scan().cursor().shape(), Qt::OpenHandCursor);
    QVERIFY(!scan().dragHint().isEmpty());
    drag(from, from + QPoint(30, 20));
    const double by_mm = scan().mmPerWidgetPixel();
    QVERIFY2(std::abs(gate().middle_mm.x - (before.middle_mm.x - 30.0 * by_mm)) < 0.2, qPrintable(QString::number(gate().middle_mm.x)));
    QVERIFY(std::abs(gate().depth_mm - (before.depth_mm + 20.0 * by_mm)) < 0.2);
    QVERIFY(session().probeControl().hold() == hold);
    wanted.spectral->line = spectral().line;
    wanted.spectral->depth_mm = spectral().depth_mm;
    QVERIFY2(knobs() == wanted, "another setting was changed");
    QVERIFY(window_->calipers().lines().empty());
  }

  void itsEndsLengthenItAndTheFlowLineTurns() {
    showFlowingBlood();
    switchOn();
    slide("spectralGate", 16);
    const QPointF end = outline().middle + 0.5 * outline().length_px * outline().along;
    moveTo(end.toPoint(), Qt::NoButton);
    QCOMPARE(scan().cursor().shape(), Qt::SizeVerCursor);
    const double depth_mm = gate().depth_mm;
    drag(end.toPoint(), (outline().middle + 6.0 / scan().mmPerWidgetPixel() * outline().along).toPoint());
    QVERIFY2(std::abs(spectral().gate_mm - 12.0) <= 0.5, qPrintable(QString::number(spectral().gate_mm)));
    QVERIFY(std::abs(gate().depth_mm - depth_mm) < 1e-9);
    // +x is at the left of the image: a flow line that goes up to the right goes down to the left.
    const QPointF tip = outline().flowTo;
    drag(tip.toPoint(), (outline().middle + QPointF(-std::sin(glm::radians(50.0)), std::cos(glm::radians(50.0))) * 60.0).toPoint());
    QVERIFY2(std::abs(glm::degrees(spectral().angle_rad) - 50.0) <= 1.0, qPrintable(QString::number(glm::degrees(spectral().angle_rad))));
    const double before_deg = std::round(glm::degrees(spectral().angle_rad));
    turnWheelAt(outline().middle, 1);
    QVERIFY(std::abs(glm::degrees(spectral().angle_rad) - before_deg - 1.0) < 1e-6);
    QTest::keyClick(&scan(), Qt::Key_J, Qt::ShiftModifier);
    QVERIFY(std::abs(glm::degrees(spectral().angle_rad) - before_deg) < 1e-6);
    for (int n = 0; n < 100; ++n) turnWheelAt(outline().middle, 1);
    QVERIFY2(std::abs(glm::degrees(spectral().angle_rad) - 80.0) < 1e-6, "an angle ends at 80 degrees");
  }

  void theAngleChangesTheScaleOfVelocitiesAndWarnsBeyondSixtyDegrees() {
    showFlowingBlood();
    switchOn();
    press("angle0");
    const double along = gate().shown_mmPerS.second;
    const QString before = textOf("spectralScaleValue");
    press("angle60");
    QVERIFY(std::abs(gate().shown_mmPerS.second - 2.0 * along) < 1e-6 * along);
    // 1540 m/s x 5012 / s / (4 x 5 MHz) = 38.6 cm/s, doubled
    QVERIFY2(before.startsWith(QStringLiteral("38.6 ")), qPrintable(before));
    QVERIFY2(textOf("spectralScaleValue").startsWith(QStringLiteral("77.2 ")), qPrintable(textOf("spectralScaleValue")));
    QVERIFY(angleWarning(spectral().angle_rad).isEmpty());
    slide("spectralAngle", 70);
    // tan(70) x 3 degrees
    QVERIFY2(angleWarning(spectral().angle_rad).contains(QStringLiteral("14 %")), qPrintable(angleWarning(spectral().angle_rad)));
    const WaveformValues values{.peakSystolic = 0.5, .endDiastolic = 0.1, .timeAverageMaximum = 0.2, .heartPeriod_s = 0.8, .beats = 2};
    press("angle60");
    const QStringList read = spectralValues(values, session().console().probe(), knobs());
    QCOMPARE(read[0], QStringLiteral("PSV 39 ± 3 cm/s"));
    QCOMPARE(read[2], QStringLiteral("RI 0.80"));
    QCOMPARE(read[5], QStringLiteral("HR 75/min"));
  }

  void everyControlChangesWhatItNames() {
    showFlowingBlood();
    switchOn();
    const auto changes = [this](const char* what, const std::function<void()>& turn,
                                const std::function<void(SpectralDoppler&)>& expected) {
      Knobs wanted = knobs();
      expected(*wanted.spectral);
      QVERIFY2(!(wanted == knobs()), what);
      turn();
      QVERIFY2(wanted == knobs(), what);
    };
    changes(
        "gain", [&] { slide("spectralGain", 7); }, [](SpectralDoppler& s) { s.gain_db = 3.5; });
    changes(
        "range", [&] { slide("spectralRange", 55); }, [](SpectralDoppler& s) { s.dynamicRange_db = 55.0; });
    changes(
        "baseline", [&] { slide("spectralBaseline", -6); }, [](SpectralDoppler& s) { s.baseline = -0.6; });
    changes(
        "invert", [&] { press("spectralInvert"); }, [](SpectralDoppler& s) { s.invert = true; });
    changes(
        "filter", [&] { slide("spectralFilter", 9); }, [](SpectralDoppler& s) { s.wallFilter_hz = 200.0; });
    changes(
        "high PRF", [&] { press("spectralHighPrf"); }, [](SpectralDoppler& s) { s.highPrf = true; });
    changes(
        "broadening", [&] { press("spectralBroadens"); }, [](SpectralDoppler& s) { s.broadens = false; });
    changes(
        "length", [&] { slide("spectralGate", 9); }, [](SpectralDoppler& s) { s.gate_mm = 4.5; });
    auto* scale = find<QSlider>("spectralScale");
    scale->setValue(scale->maximum());
    QVERIFY2(!gate().alsoAt_mm.empty(), "other depths answer as well");
    press("spectralHighPrf");
    QVERIFY(gate().alsoAt_mm.empty());
    slide("spectralSteering", -15);
    QVERIFY(std::abs(spectral().steering_rad - glm::radians(-15.0)) < 1e-12);
    session().console().chooseProbe("convex-3.5");
    QVERIFY2(find<QSlider>("spectralSteering")->parentWidget()->isHidden(), "a convex probe does not steer");
    QVERIFY2(spectral().depth_mm == 0.0 && spectral().steering_rad == 0.0, "another probe, another place");
  }

  void freezingKeepsTheStripAndItsVolume() {
    showPulsingVessel();
    switchOn();
    QVERIFY(waitUntil([this] { return session().spectrumTrace().reading() != nullptr; }));
    QTest::mousePress(&scan(), Qt::LeftButton, Qt::NoModifier, outline().middle.toPoint());
    press("freeze");  // in the middle of a drag
    const std::vector<std::uint8_t> strip = stripOf(session());
    QVERIFY(std::any_of(strip.begin(), strip.end(), [](std::uint8_t grey) { return grey > 0; }));
    const Knobs frozen = knobs();
    const QPoint middle = outline().middle.toPoint();
    moveTo(middle + QPoint(30, 30), Qt::LeftButton);
    QTest::mouseRelease(&scan(), Qt::LeftButton, Qt::NoModifier, middle + QPoint(30, 30));
    QVERIFY(knobs() == frozen);
    drag(middle, middle + QPoint(20, 20));
    QVERIFY2(knobs() == frozen, "a frozen image keeps its sample volume");
    find<QSlider>("spectralGain")->setValue(12);
    QVERIFY(knobs() == frozen);
    QVERIFY(stripOf(session()) == strip);
    press("freeze");
    QVERIFY(knobs().mode == DisplayMode::spectrum);
  }

  void valuesAppearWithWholeBeatsAndAreNearTheTruth() {
    showPulsingVessel();
    const WaveformValues expected = truth();
    const double psv = std::abs(expected.peakSystolic), edv = std::abs(expected.endDiastolic);
    switchOn();
    press("angle60");
    slide("spectralGate", 12);
    press("spectralBroadens");
    playFor(0.5 * kBeat_s);
    const SpectrumReading* reading = session().spectrumTrace().reading();
    QVERIFY2(reading != nullptr && !reading->values, "no beat is whole yet");
    playFor(2.6 * kBeat_s);
    reading = session().spectrumTrace().reading();
    QVERIFY(reading != nullptr && reading->values);
    const double unit_mmPerS = gate().nyquist_mmPerS * gate().corrected;
    const WaveformValues& values = *reading->values;
    qInfo("PSV %.0f of %.0f, EDV %.0f of %.0f mm/s, RI %.2f of %.2f, period %.3f s", unit_mmPerS * values.peakSystolic, psv,
          unit_mmPerS * values.endDiastolic, edv, values.resistiveIndex(), expected.resistiveIndex(), values.heartPeriod_s);
    QVERIFY(std::abs(unit_mmPerS * values.peakSystolic - psv) < 0.1 * psv);
    QVERIFY(std::abs(values.resistiveIndex() - expected.resistiveIndex()) < 0.04);
    QVERIFY(std::abs(values.heartPeriod_s - kBeat_s) < 0.03);
    session().play({});
    session().makeImageNow();
    const SpectrumReading* anew = session().spectrumTrace().reading();
    QVERIFY2(anew == nullptr || !anew->values, "values of a spectrum that is gone");
  }

  void nothingOfTheStripIsMeasuredAsDepth() {
    showPulsingVessel();
    switchOn();
    QVERIFY(session().seen().strip().width > 0);
    QVERIFY(!window_->calipers().hasStrip());
    QVERIFY(find<QWidget>("stripTools")->isHidden());
    window_->calipers().take(measurement::CaliperKind::depthDistance);
    QVERIFY(!window_->calipers().drawing().tool());
    press("modeBoth");
    session().makeImageNow();
    QVERIFY(window_->calipers().hasStrip());
  }

  void theCaseIsClosedInTheMiddleOfADrag() {
    showPulsingVessel();
    switchOn();
    const QPoint from = outline().middle.toPoint();
    QTest::mousePress(&scan(), Qt::LeftButton, Qt::NoModifier, from);
    moveTo(from + QPoint(10, 0), Qt::LeftButton);
    session().makeImageNow();
    const ScanSubject next = *session().subject();
    session().clear();
    QCOMPARE(speaker().queued_s(), 0.0);
    const Knobs before = knobs();
    moveTo(from + QPoint(20, 0), Qt::LeftButton);
    scan().grab();
    QVERIFY(knobs() == before);
    session().show(next);
    session().makeImageNow();
    const Knobs fresh = knobs();
    moveTo(from + QPoint(30, 0), Qt::LeftButton);
    QTest::mouseRelease(&scan(), Qt::LeftButton, Qt::NoModifier, from + QPoint(30, 0));
    QVERIFY2(knobs() == fresh, "the next patient's sample volume hung on the pointer");
  }

  void bloodIsHeardWhileTheSpectrumRuns() {
    showPulsingVessel();
    QCOMPARE(speaker().queued_s(), 0.0);
    switchOn();
    QVERIFY(waitUntil([this] { return speaker().queued_s() > 0.0; }));
    QVERIFY(speaker().hasOutput() && find<QLabel>("noSound")->isHidden());
    for (int n = 0; n < 20; ++n) {
      session().frames().ask();
      session().makeImageNow();
      QVERIFY2(speaker().queued_s() <= 0.15 + 1e-6, qPrintable(QString::number(speaker().queued_s())));
    }
    press("freeze");
    QCOMPARE(speaker().queued_s(), 0.0);
    press("freeze");
    QVERIFY(waitUntil([this] { return speaker().queued_s() > 0.0; }));
    press("spectralMute");
    QCOMPARE(speaker().queued_s(), 0.0);
    QVERIFY(!find<QSlider>("spectralLoudness")->isEnabled());
    press("spectralMute");
    slide("spectralLoudness", 80);
    press("modeB");
    session().makeImageNow();
    QCOMPARE(speaker().queued_s(), 0.0);
    cleanup();
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
    QVERIFY2(std::abs(speaker().volume() - 0.8) < 1e-9, "the volume is remembered");
    for (const float loud : {0.1F, 3.0F, 1e6F}) QVERIFY(std::abs(limitedSound({loud, -loud}, 1.0).x) <= 1.0F);
  }

  void aComputerWithoutSoundSaysSoAndGoesOn() {
    qputenv("SDL_AUDIODRIVER", "there-is-none");
    showPulsingVessel();
    switchOn();
    QVERIFY(waitUntil([this] { return session().seen().spectrogram() != nullptr && !speaker().hasOutput(); }));
    qputenv("SDL_AUDIODRIVER", "dummy");
    QVERIFY(!find<QLabel>("noSound")->isHidden());
    QVERIFY(!find<QSlider>("spectralLoudness")->isEnabled());
    QVERIFY(waitUntil([this] { return session().spectrumTrace().reading() != nullptr; }));
  }

  void nothingOfThePageIsClippedInEitherLanguage() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    for (const bool isGerman : {false, true}) {
      if (isGerman) {
        QApplication::installTranslator(&german);
        cleanup();
        init();
      }
      showPulsingVessel();
      switchOn();
      press("angle60");
      window_->console().showPage(find<QCheckBox>("colour"));
      playFor(2.6 * kBeat_s);
      QTest::qWait(60);
      QVERIFY2(find<QCheckBox>("spectralInvert")->isVisible(), "the page shows what is on");
      checkNothingIsClipped();
      keepScreenshot(*window_, isGerman ? "spectrum-de" : "spectrum-en");
    }
    QApplication::removeTranslator(&german);
  }

  void theCommonCarotidOfTheShippedNeckHasItsResistance() {
    const auto folder = shippedCasesFolder();
    QVERIFY(folder.has_value());
    const auto cases = listCasesAside(*folder).cases;
    const auto neck = std::find_if(cases.begin(), cases.end(), [](const Case& each) { return each.id == "neck-carotid-thyroid"; });
    QVERIFY(neck != cases.end());
    if (caseNeedsPreparation(*neck)) QSKIP("the case is not prepared; run 'echoweave case prepare --all' first");
    const auto truth = loadCaseTruth(*neck, noProgress());
    QVERIFY(truth.has_value());
    window_->open(QString::fromStdString(neck->folder.string()));
    QVERIFY(waitUntil([&] { return window_->isSettled() && window_->document().current()->id == neck->id; }, 10.0 * test::kPatience_ms));
    QVERIFY(!find<QPushButton>("modePw")->isHidden());
    const auto plane =
        std::find_if(truth->planes.begin(), truth->planes.end(), [](const auto& p) { return p.name == "along the carotid fork"; });
    const auto lumen = std::find_if(truth->measurements.begin(), truth->measurements.end(),
                                    [](const auto& m) { return m.name == "right common carotid artery, lumen 10 mm below the fork"; });
    QVERIFY(plane != truth->planes.end() && lumen != truth->measurements.end());
    session().probeControl().follow(std::make_shared<PosePath>(std::vector<PoseSample>{{0.0, {plane->probeToWorld, PoseStatus::ok}}}));
    session().makeImageNow();
    switchOn();
    const glm::dvec3 middle_mm = 0.5 * (lumen->points_mm.front() + lumen->points_mm.back());
    const glm::dvec4 at_mm = glm::inverse(plane->probeToWorld.matrix) * glm::dvec4(middle_mm, 1.0);
    Knobs listening = knobs();
    listening.mSweep_s = 4.0;
    listening.spectral->steering_rad = glm::radians(-20.0);
    listening.spectral->angle_rad = glm::radians(-60.0);
    session().console().setKnobs(withSpectralGateAt(session().console().probe(), listening, {at_mm.x, at_mm.y}));
    keepScreenshot(*window_, "carotid-first");
    playFor(3.5);
    const SpectrumReading* reading = session().spectrumTrace().reading();
    QVERIFY(reading != nullptr && reading->values);
    for (const QString& value : spectralValues(*reading->values, session().console().probe(), knobs())) qInfo("%s", qPrintable(value));
    QVERIFY(reading->values->resistiveIndex() > 0.70 && reading->values->resistiveIndex() < 0.80);
    keepInManyShapes();
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::SpectrumTest)
#include "spectrum_test.moc"
