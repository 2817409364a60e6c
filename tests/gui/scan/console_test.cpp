#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QToolTip>
#include <QTranslator>
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

#include "ew/imaging/frame.h"
#include "ew/library/case.h"
#include "ew/ui_test_door/console.h"
#include "gui/support/case_aside.h"
#include "gui/support/console_fixture.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui::testing {

/// Every control of the console changes what it names, by hand and by its key, and nothing of it is clipped.
class ConsoleTest : public ConsoleFixture {
  Q_OBJECT

 private:
  void choose(const char* name, int index) const {
    auto* choice = find<QComboBox>(name);
    QVERIFY2(choice != nullptr && index < choice->count(), name);
    choice->setCurrentIndex(index);
    Q_EMIT choice->activated(index);
  }
  [[nodiscard]] static bool isThere(const QSlider* slider) { return slider != nullptr && !slider->parentWidget()->isHidden(); }
  /// A linear array that steers and fans out, beside the case's own probe.
  void chooseLinearProbe() const {
    Probe linear;
    linear.id = "test-linear";
    linear.name = "Test linear";
    linear.kind = ProbeKind::linear;
    linear.carriers_hz = {5e6, 7.5e6, 10e6};
    linear.carrier_hz = 7.5e6;
    linear.maxSteering_rad = glm::radians(20.0);
    linear.trapezoidHalfAngle_rad = glm::radians(10.0);
    std::vector<Probe> all = session().console().probes();
    all.push_back(linear);
    ScanSubject subject = *session().subject();
    for (const Probe& probe : all) subject.probes.push_back(probe.id);
    session().console().setProbes(all);
    session().show(subject);
    session().console().chooseProbe("test-linear");
    QCOMPARE(session().console().probe().id, std::string("test-linear"));
  }
  void checkNothingIsClipped() const {
    for (const QLabel* label : window_->findChildren<QLabel*>()) {
      if (!label->isVisible() || label->wordWrap()) continue;
      QVERIFY2(label->width() >= label->sizeHint().width() - 1, qPrintable(label->objectName() + QStringLiteral(": ") + label->text()));
    }
    for (const QScrollArea* page : window_->console().findChildren<QScrollArea*>()) {
      if (!page->isVisible() || page->widget()->width() <= page->viewport()->width()) continue;
      QStringList wide;
      for (const QWidget* each : page->widget()->findChildren<QWidget*>())
        if (each->isVisible())
          wide << QStringLiteral("%1 %2").arg(each->minimumSizeHint().width(), 4).arg(each->objectName() + each->accessibleName());
      std::sort(wide.begin(), wide.end(), std::greater<>());
      QFAIL(qPrintable(QStringLiteral("a page of %1 pixels is wider than the console with %2; widest: %3")
                           .arg(page->widget()->width())
                           .arg(page->viewport()->width())
                           .arg(wide.mid(0, 5).join(QStringLiteral(", ")))));
    }
    for (const QAbstractButton* button : window_->findChildren<QAbstractButton*>()) {
      if (!button->isVisible() || button->text().isEmpty()) continue;
      QVERIFY2(button->width() >= button->minimumSizeHint().width() - 1, qPrintable(button->text()));
    }
    QCOMPARE(window_->width(), 1280);
    QCOMPARE(window_->height(), 720);
  }
  void checkPages() const {
    auto* pages = find<QTabWidget>("consolePages");
    for (const char* mode : {"modeB", "modeBoth"}) {
      find<QPushButton>(mode)->click();
      for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        QTest::qWait(60);
        checkNothingIsClipped();
      }
    }
  }

 private Q_SLOTS:
  void initTestCase() { initTranslations(); }
  void init() { openConsole(); }
  void cleanup() { window_.reset(); }

  void everyKnobOfTheConsoleChangesTheKnobItNames() {
    everythingOn();
    const auto changes = [this](const char* what, const std::function<void()>& turn, const std::function<void(Knobs&)>& expected) {
      Knobs wanted = knobs();
      expected(wanted);
      QVERIFY2(!(wanted == knobs()), what);
      turn();
      QVERIFY2(wanted == knobs(), what);
    };
    changes(
        "gain", [&] { slide("gain", 140); }, [](Knobs& k) { k.gain = 1.4; });
    changes(
        "dgc3", [&] { slide("dgc3", 60); }, [](Knobs& k) { k.dgc[2] = 0.6; });
    changes(
        "dgc reset", [&] { press("dgcReset"); }, [](Knobs& k) { k.dgc = Knobs{}.dgc; });
    changes(
        "depth", [&] { slide("depth", 120); }, [](Knobs& k) { k.depth_mm = 120.0; });
    changes(
        "focus", [&] { slide("focus", 45); }, [](Knobs& k) { k.focus_mm = 45.0; });
    changes(
        "method", [&] { press("focusStretch"); }, [](Knobs& k) { k.focusMethod = FocusMethod::rowStretch; });
    changes(
        "range", [&] { slide("dynamicRange", 45); }, [](Knobs& k) { k.dynamicRange_db = 45.0; });
    changes(
        "range as recorded", [&] { slide("dynamicRange", 60); }, [](Knobs& k) { k.dynamicRange_db = 0.0; });
    changes(
        "grey map", [&] { press("greyContrast"); }, [](Knobs& k) { k.greyMap = GreyMap::contrast; });
    changes(
        "edges", [&] { slide("edges", 30); }, [](Knobs& k) { k.edgeEnhancement = 0.3; });
    changes(
        "persistence", [&] { slide("persistence", 50); }, [](Knobs& k) { k.persistence = 0.5; });
    changes(
        "zoom", [&] { slide("zoom", 25); }, [](Knobs& k) { k.zoom = 2.5; });
    changes(
        "weave", [&] { press("qualityWeave"); }, [](Knobs& k) { k.quality = Quality::weave; });
    changes(
        "cubic", [&] { press("qualityCubic"); }, [](Knobs& k) { k.quality = Quality::cubic; });
    changes(
        "planes", [&] { press("planes7"); }, [](Knobs& k) { k.elevationPlanes = 7; });
    changes(
        "both", [&] { press("modeBoth"); }, [](Knobs& k) { k.mode = DisplayMode::both; });
    changes(
        "M line", [&] { slide("mLine", 40); }, [](Knobs& k) { k.mLine = -0.4; });  // the marker, at +x, is at the left
    changes(
        "sweep", [&] { slide("sweep", 8); }, [](Knobs& k) { k.mSweep_s = 8.0; });
    changes(
        "M", [&] { press("modeM"); }, [](Knobs& k) { k.mode = DisplayMode::mMode; });
    changes(
        "B", [&] { press("modeB"); }, [](Knobs& k) { k.mode = DisplayMode::bMode; });
    changes(
        "flip", [&] { press("flip"); }, [](Knobs& k) { k.markerLeft = false; });
    changes(
        "turn", [&] { press("upsideDown"); }, [](Knobs& k) { k.upsideDown = true; });

    press("foci3");
    QCOMPARE(static_cast<int>(std::count_if(knobs().moreFoci_mm.begin(), knobs().moreFoci_mm.end(), [](double mm) { return mm > 0; })), 2);
    for (const double mm : knobs().moreFoci_mm) QVERIFY(mm >= 0.0 && mm < 120.0);
    press("foci1");
    QVERIFY(knobs().moreFoci_mm == Knobs{}.moreFoci_mm);

    QVERIFY(!session().frames().isAdaptive());  // the fixture switched it off
    press("adaptive");
    QVERIFY(session().frames().isAdaptive());
    press("adaptive");
    QVERIFY(!session().frames().isAdaptive());
    press("freeze");
    QVERIFY(session().isFrozen());
  }

  void gainAndTgcInDecibelsAreShownWhileHeldAndADoubleClickPutsThemBack() {
    auto* gain = find<QSlider>("gain");
    auto* fifth = find<QSlider>("dgc5");
    QVERIFY2(find<QPushButton>("gainFactors")->isChecked(), "a recorded volume");
    slide("dgc5", 150);
    press("gainDecibels");
    QCOMPARE(static_cast<int>(knobs().gainLaw), static_cast<int>(GainLaw::decibel));
    QCOMPARE(gain->minimum(), -60);
    QCOMPARE(gain->maximum(), 60);
    QCOMPARE(fifth->minimum(), -20);
    QCOMPARE(fifth->value(), 0);
    slide("gain", 7);
    slide("dgc5", -6);
    QCOMPARE(knobs().gain_db, 3.5);
    QCOMPARE(knobs().tgc_db[4], -6.0);
    QCOMPARE(knobs().dgc[4], 1.5);  // kept, and does nothing
    QVERIFY(find<QLabel>("gainValue")->text().startsWith(QStringLiteral("+3.5")));
    QVERIFY2(fifth->toolTip().endsWith(QStringLiteral("−6 dB")), qPrintable(fifth->toolTip()));
    fifth->setSliderDown(true);
    Q_EMIT fifth->sliderPressed();
    QVERIFY(QToolTip::text().endsWith(QStringLiteral("−6 dB")));
    slide("dgc5", 9);
    QVERIFY2(QToolTip::text().endsWith(QStringLiteral("+9 dB")), qPrintable(QToolTip::text()));
    fifth->setSliderDown(false);
    QTest::mouseDClick(fifth, Qt::LeftButton);
    QTest::mouseDClick(gain, Qt::LeftButton);
    QCOMPARE(knobs().tgc_db[4], 0.0);
    QCOMPARE(knobs().gain_db, 0.0);
    slide("dgc5", 3);
    press("dgcReset");
    QVERIFY(knobs().tgc_db == Knobs{}.tgc_db);
    QCOMPARE(knobs().dgc[4], 1.5);
    press("gainFactors");
    QVERIFY2(knobs().gainLaw == GainLaw::automatic, "the usual one of a recorded volume");
    QCOMPARE(fifth->value(), 150);
    QTest::mouseDClick(fifth, Qt::LeftButton);
    QCOMPARE(knobs().dgc[4], 1.0);
    press("greyClinical");
    QCOMPARE(static_cast<int>(knobs().greyMap), static_cast<int>(GreyMap::clinical));
    press("greyLinear");
    QCOMPARE(static_cast<int>(knobs().greyMap), static_cast<int>(GreyMap::automatic));
  }

  void aLinearArraySteersAndFansOutAndAnotherProbeDoesNotOfferIt() {
    QVERIFY(!isThere(find<QSlider>("steering")));
    QVERIFY(find<QCheckBox>("trapezoid")->isHidden());
    chooseLinearProbe();
    QVERIFY(isThere(find<QSlider>("steering")));
    slide("steering", -15);
    QVERIFY(std::abs(knobs().steering_rad - glm::radians(-15.0)) < 1e-12);
    QVERIFY(find<QSlider>("steering")->maximum() == 20);
    choose("frequency", 2);
    QCOMPARE(knobs().carrier_hz, 10e6);
    choose("frequency", 1);
    QCOMPARE(knobs().carrier_hz, 0.0);  // the probe's own
    session().makeImageNow();
    const auto steered = session().seen().spans();
    press("trapezoid");
    QVERIFY(knobs().trapezoid);
    QVERIFY2(!find<QSlider>("steering")->isEnabled(), "a trapezoid does not steer");
    session().makeImageNow();
    QVERIFY(session().seen().spans() != steered);
  }

  void liveEchoesOfARecordedVolumeBeginOnceItsLevelIsFound() {
    QVERIFY(!session().subject()->tissue);
    pressEffect("live_echoes");
    QTRY_VERIFY(scene().liveEchoes.has_value());
    QVERIFY(session().subject()->tissue && session().subject()->tissue->isRecorded);
    QVERIFY(find<QCheckBox>("effect_live_echoes")->isChecked());
    QVERIFY2(!find<QCheckBox>("harmonic")->isEnabled() && !find<QAbstractButton>("compound3")->isEnabled(), "its grain is one machine's");
    session().makeImageNow();
    const auto& steps = session().seen().plan().steps;
    QVERIFY(std::any_of(steps.begin(), steps.end(), [](const Step& step) { return step.kind == StepKind::scatterers; }));
    pressEffect("live_echoes");
    QVERIFY(!scene().liveEchoes);
  }

  void everyEffectIsSwitchedAndItsStrengthReachesTheScene() {
    const Scene none;
    QVERIFY(scene() == none);
    for (const EffectInfo& effect : sceneEffects()) {
      if (effect.strength) QVERIFY2(!find<QSlider>(strengthOf(effect.key).c_str())->isEnabled(), effect.key);
    }
    QVERIFY2(!find<QSlider>("focus")->isEnabled(), "a focus that does nothing must look off");
    QVERIFY(!find<QCheckBox>("effect_mirror")->isEnabled());
    everythingOn();
    QVERIFY(scene() == everything());
    slideEffect("focus", 150);
    slideEffect("slice_thickness", 25);
    slideEffect("attenuation", 20);
    slideEffect("reverberation", 8);
    pressEffect("mirror");
    slideEffect("noise", -70);
    slideEffect("contact", 10);
    pressEffect("gain_and_dgc");
    QCOMPARE(scene().focus->strength, 1.5);
    QCOMPARE(scene().sliceThickness->scale, 2.5);
    QCOMPARE(scene().attenuation->interface_dbPerMm, 10.0);
    QCOMPARE(scene().reverberation->loss_dbPerBounce, 8.0);
    QVERIFY(!scene().reverberation->mirror);
    QCOMPARE(scene().noise->atFace_db, -70.0);
    QCOMPARE(scene().contact->gel_mm, 5.0);
    QVERIFY(!scene().gainAndDgc && !find<QSlider>("gain")->isEnabled() && !find<QSlider>("dgc1")->isEnabled());
    pressEffect("noise");
    QVERIFY(!scene().noise);
    pressEffect("noise");
    QCOMPARE(scene().noise->atFace_db, -70.0);  // as strong as it was
  }

  void everyEffectChangesTheImage() {
    session().makeImageNow();
    for (const char* effect : {"focus", "slice_thickness", "noise"}) {
      const std::vector<std::uint8_t> before = pixelsOf(session());
      pressEffect(effect);
      session().makeImageNow();
      QVERIFY2(pixelsOf(session()) != before, effect);
      pressEffect(effect);
      session().makeImageNow();
      QVERIFY2(pixelsOf(session()) == before, effect);
    }
    // A probe held off the skin shows it only when the scene has contact.
    Hold lifted = session().probeControl().hold();
    lifted.press_mm = 0.0;
    session().probeControl().setHold(turned(lifted, 0.0, 0.6, 0.0));
    session().makeImageNow();
    const std::vector<std::uint8_t> touching = pixelsOf(session());
    pressEffect("contact");
    session().makeImageNow();
    QVERIFY(pixelsOf(session()) != touching);
  }

  void theScenesResetIsTakenBack() {
    pressEffect("attenuation");
    slideEffect("attenuation", 30);
    const Scene switched = scene();
    auto* reset = find<QPushButton>("sceneReset");
    const QString name = reset->text();
    reset->click();
    QVERIFY(scene() == session().subject()->scene);
    QVERIFY(reset->text() != name);
    reset->click();
    QVERIFY(scene() == switched);
    QCOMPARE(reset->text(), name);
  }

  void theKeysReachTheConsole() {
    QWidget* at = &window_->scanView();
    const auto key = [at](Qt::Key k, Qt::KeyboardModifiers with = Qt::NoModifier) { QTest::keyClick(at, k, with); };
    key(Qt::Key_3);
    QCOMPARE(static_cast<int>(knobs().quality), static_cast<int>(Quality::cubic));
    key(Qt::Key_F2);
    QVERIFY(scene().focus.has_value());
    key(Qt::Key_N);
    QVERIFY(knobs().moreFoci_mm[0] > 0.0);
    key(Qt::Key_F7);
    QVERIFY(scene().noise.has_value());
    key(Qt::Key_U);
    QVERIFY(knobs().upsideDown);
    key(Qt::Key_M);
    QCOMPARE(static_cast<int>(knobs().mode), static_cast<int>(DisplayMode::both));
    key(Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(knobs().mLine != 0.0);
    key(Qt::Key_G);
    QCOMPARE(static_cast<int>(knobs().greyMap), static_cast<int>(GreyMap::soft));
    key(Qt::Key_P);
    QCOMPARE(knobs().persistence, 0.1);
    key(Qt::Key_F10);
    QCOMPARE(find<QTabWidget>("consolePages")->currentIndex(), 1);
    key(Qt::Key_J);  // a convex probe does not steer
    QCOMPARE(knobs().steering_rad, 0.0);
  }

  void everyControlHasAnAccessibleNameAndATooltip() {
    chooseLinearProbe();
    QStringList silent;
    for (const QWidget* control : window_->console().findChildren<QWidget*>()) {
      if (qobject_cast<const QSlider*>(control) == nullptr && qobject_cast<const QAbstractButton*>(control) == nullptr &&
          qobject_cast<const QComboBox*>(control) == nullptr)
        continue;
      if (control->objectName().isEmpty() || control->objectName().startsWith(QLatin1String("qt_")) ||
          control->objectName() == QLatin1String("ScrollLeftButton") || control->objectName() == QLatin1String("ScrollRightButton"))
        continue;
      if (control->accessibleName().isEmpty() && qobject_cast<const QPushButton*>(control) == nullptr) silent << control->objectName();
      if (control->toolTip().isEmpty()) silent << control->objectName();
    }
    QVERIFY2(silent.isEmpty(), qPrintable(silent.join(QStringLiteral(", "))));
  }

  void draggingOnTheDepthScaleMovesTheNearestFocus() {
    pressEffect("focus");
    press("foci2");
    session().makeImageNow();
    auto* scale = find<QWidget>("focusScale");
    const double first_mm = knobs().focus_mm;
    const double second_mm = knobs().moreFoci_mm[0];
    const auto at = [&](double mm) { return QPoint(20, static_cast<int>(std::lround(window_->scanView().yOfDepth(mm))) - scale->y()); };
    QTest::mousePress(scale, Qt::LeftButton, Qt::NoModifier, at(second_mm));
    QMouseEvent move(QEvent::MouseMove, at(140.0), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(scale, &move);
    QTest::mouseRelease(scale, Qt::LeftButton, Qt::NoModifier, at(140.0));
    QCOMPARE(knobs().focus_mm, first_mm);
    QVERIFY(std::abs(knobs().moreFoci_mm[0] - 140.0) <= 1.0);
  }

  void theCostPanelMeasuresMarksAndApplies() {
    QTest::keyClick(&window_->scanView(), Qt::Key_K, Qt::ControlModifier);
    auto* panel = find<CostPanel>("costPanel");
    QVERIFY(panel != nullptr && panel->isVisible() && panel->isMeasuring());
    QVERIFY(waitUntil([panel] { return !panel->isMeasuring(); }));
    QVERIFY(panel->measured().has_value());
    auto* chart = panel->findChild<CostChart*>(QStringLiteral("costChart"));
    QCOMPARE(chart->points().size(), std::size_t{3});
    QVERIFY(chart->points()[1].inUse && !chart->points()[0].inUse);
    auto* wish = panel->findChild<QDoubleSpinBox*>(QStringLiteral("costWish"));
    wish->setValue(10.0);
    panel->findChild<QPushButton*>(QStringLiteral("costUse"))->click();
    const CostPoint* fastest = fastestWithin(panel->measured()->qualities, 10.0);
    QVERIFY(fastest != nullptr && knobs().quality == fastest->knobs.quality);
    wish->setValue(90.0);
    const Knobs before = knobs();
    panel->findChild<QPushButton*>(QStringLiteral("costUse"))->click();
    QVERIFY(knobs() == before);
    QVERIFY(!panel->findChild<QLabel*>(QStringLiteral("costAnswer"))->text().isEmpty());
  }

  void measuringIsCancelled() {
    QTest::keyClick(&window_->scanView(), Qt::Key_K, Qt::ControlModifier);
    auto* panel = find<CostPanel>("costPanel");
    QVERIFY(panel != nullptr && panel->isMeasuring());
    panel->findChild<QPushButton*>(QStringLiteral("costMeasure"))->click();
    QVERIFY(waitUntil([panel] { return !panel->isMeasuring(); }));
    QVERIFY2(!panel->measured().has_value(), "it went on to its end");
    QVERIFY(!window_->jobs().isRunning());
    panel->findChild<QPushButton*>(QStringLiteral("costMeasure"))->click();
    QVERIFY(panel->isMeasuring());
    panel->close();  // with its work still running
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
  }

  void theAuthorDeclaresAnEffectAndTheScanShowsItAtOnce() {
    window_->openPlugins();
    window_->setWorkspace(Workspace::author);
    QWidget* panel = window_->findChild<QWidget*>(QStringLiteral("casePanel"));
#ifdef EW_WITH_CASE_AUTHORING
    QVERIFY2(panel != nullptr, "the case authoring plugin is part of this build and brought no panel");
#else
    if (panel == nullptr) QSKIP("the case authoring plugin is not part of this build");
#endif
    auto* noise = panel->findChild<QCheckBox*>(QStringLiteral("scene_noise"));
    QVERIFY(noise != nullptr && !noise->isChecked());
    noise->click();
    QVERIFY(window_->document().current()->scene.noise.has_value());
    QVERIFY(scene().noise.has_value());
    window_->document().undo();
    QVERIFY(!noise->isChecked() && !scene().noise && !window_->document().hasUnsavedChanges());
    window_->document().redo();
    QVERIFY(noise->isChecked());
    QVERIFY(window_->document().save().has_value());
    const auto reopened = loadCaseAside(window_->document().current()->folder);
    QVERIFY(reopened.has_value() && reopened->scene.noise.has_value());
  }

  void everyEffectAndEveryStepHasGermanWords() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    const auto isThere = [&](const char* context, const char* text) { QVERIFY2(!german.translate(context, text).isEmpty(), text); };
    for (const EffectInfo& effect : sceneEffects()) {
      for (const char* text : {effect.name, effect.shortName, effect.tip}) isThere(kEffectTexts, text);
      if (effect.strength) {
        for (const char* text : {effect.strength->tip, effect.strength->pattern}) isThere(kEffectTexts, text);
      }
      if (effect.option) {
        for (const char* text : {effect.option->name, effect.option->shortName, effect.option->tip}) isThere(kEffectTexts, text);
      }
    }
    for (int kind = 0; kind <= static_cast<int>(StepKind::table); ++kind) isThere("ew::StepKind", labelOf(static_cast<StepKind>(kind)));
  }

  void noTextIsClippedOnAnyPage() {
    everythingOn();
    checkPages();
  }

  void noGermanTextIsClippedOnAnyPage() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QApplication::installTranslator(&german);
    cleanup();
    init();
    everythingOn();
    chooseLinearProbe();
    checkPages();
    QApplication::removeTranslator(&german);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::ConsoleTest)
#include "console_test.moc"
