// One author's way in the real window, from the start page: a case out of a real sweep, put on the mannequin, its texts, what is to be
// found, a lesson with a step of each kind and the expert's scan, published and exported. EW_SCREENSHOTS=DIR keeps an image of every step.
#include <QCheckBox>
#include <QFile>
#include <QProgressBar>
#include <QTabWidget>
#include <QToolButton>

#include "ew/library/bundle.h"
#include "ew/library/case.h"
#include "ew/library/lesson_links.h"
#include "ew/library/new_case.h"
#include "ew/library/published.h"
#include "ew/library/publishing.h"
#include "ew/scanning/recording.h"
#include "ew/ui_test_door/scan.h"
#include "gui/support/answers.h"
#include "gui/support/case_aside.h"
#include "gui/support/panel_hand.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"
#include "places.h"

namespace ew::ui::testing {

class AuthorJourneyTest : public WindowFixture {
  Q_OBJECT

  [[nodiscard]] static QString sweepFile() {
    return QString::fromUtf8(EW_SOURCE_DIR) + QStringLiteral("/../shared/data/liver-sweep/liver_sweep.igs.mha");
  }
  [[nodiscard]] CaseDocument& document() const { return window_->document(); }
  [[nodiscard]] const Case& opened() const { return *document().current(); }
  [[nodiscard]] bool rests() const {
    return waitUntil([this] { return window_->isSettled(); });
  }
  [[nodiscard]] static QWidget* dialog(const char* name) {
    QWidget* found = nullptr;
    const bool came = waitUntil([&] {
      for (QWidget* each : QApplication::topLevelWidgets())
        if (each->objectName() == QLatin1String(name) && each->isVisible()) found = each;
      return found != nullptr;
    });
    return came ? found : nullptr;
  }
  /// Brings a panel of Author to the front.
  [[nodiscard]] PanelHand panel(const char* tab, const char* name) const {
    auto* tabs = find<QTabWidget>("authorPanel");
    if (tabs != nullptr) tabs->setCurrentWidget(find<QWidget>(tab));
    static_cast<void>(waitUntil([&] { return find<QWidget>(name) != nullptr && find<QWidget>(name)->isVisible(); }));
    return PanelHand(find<QWidget>(name));
  }
  [[nodiscard]] PickLayer& image() const { return *find<PickLayer>("pointing"); }
  [[nodiscard]] QPoint pixelAt(double x_mm, double y_mm) const {
    return (window_->scanView().positionOf({{x_mm, y_mm, 0.0}}) - QPointF(image().pos())).toPoint();
  }
  void paintFromTo(const glm::dvec2& from_mm, const glm::dvec2& to_mm) {
    QVERIFY(waitUntil([this] { return image().isPicking(); }));
    QTest::mousePress(&image(), Qt::LeftButton, Qt::NoModifier, pixelAt(from_mm.x, from_mm.y));
    for (int n = 1; n <= 6; ++n) {
      const glm::dvec2 at_mm = from_mm + (to_mm - from_mm) * (n / 6.0);
      const QPoint pixel = pixelAt(at_mm.x, at_mm.y);
      QMouseEvent move(QEvent::MouseMove, pixel, image().mapToGlobal(pixel), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QCoreApplication::sendEvent(&image(), &move);
    }
    QTest::mouseRelease(&image(), Qt::LeftButton, Qt::NoModifier, pixelAt(to_mm.x, to_mm.y));
    QVERIFY(rests());
  }
  /// The probe slides along the skin, an image at each place.
  void scan(int images, double elevational_mm) {
    for (int n = 0; n < images; ++n) {
      session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, elevational_mm));
      session().makeImageNow();
      QTest::qWait(20);
    }
  }

  void makeCase() {
    for (auto* each : find<QWidget>("startPage")->findChildren<QPushButton*>(QStringLiteral("startBeginning")))
      if (each->isVisible()) {
        each->click();
        break;
      }
    QWidget* shown = dialog("newCaseDialog");
    QVERIFY(shown != nullptr);
    const PanelHand hand(shown);
    hand.type("sourceFile", sweepFile());
    hand.set("sourceSpacing", 1.5);
    keepScreenshot(*shown, "author-02-source");
    QVERIFY(waitUntil([&] { return hand.seen<QPushButton>("newCaseNext")->isEnabled(); }));
    hand.press("newCaseNext");
    hand.type("newCaseTitle", QStringLiteral("A healthy liver, swept once"));
    hand.type("newCaseTraineeTitle", QStringLiteral("Right upper abdomen"));
    auto* templates = hand.seen<QComboBox>("newCaseTemplate");
    templates->setCurrentIndex(templates->findData(QStringLiteral("right-upper-quadrant")));
    hand.type("sourceAttribution", QStringLiteral("ImFusion GmbH, public-ultrasound-demos"));
    hand.type("sourceLicence", QStringLiteral("CC BY 4.0"));
    keepScreenshot(*shown, "author-03-about");
    hand.press("newCaseNext");
    QVERIFY(waitUntil([&] { return hand.seen<QPushButton>("newCaseNext")->isEnabled(); }));
    QVERIFY2(hand.text("newCasePlan").contains(QStringLiteral("Memory")), qPrintable(hand.text("newCasePlan")));
    keepScreenshot(*shown, "author-04-plan");
    hand.press("newCaseNext");
    QVERIFY(waitUntil([this] { return document().current() && window_->isSettled(); }));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QVERIFY(!hasNoVolume(opened()));
    QVERIFY(session().subject().has_value());
    QVERIFY(waitUntil([this] { return find<QWidget>("casePanel") != nullptr && find<QWidget>("casePanel")->isVisible(); }));
    keepScreenshot(*window_, "author-05-opened");
  }

  void placeIt() {
    const PanelHand hand = panel("panel_placing", "placePanel");
    View3D& view = window_->view3d();
    QVERIFY(waitUntil([&] { return view.skin() != nullptr && !hand.text("contactVerdict").isEmpty(); }));
    view.showFrom(bridge::CameraPreset::overview);
    view.renderNow();
    keepScreenshot(*window_, "author-06-first-place");
    const auto before = opened().volume.fileToWorld;
    hand.press("placeOnSkin");
    const auto belly = view.skin()->hit({-60.0, -900.0, -90.0}, {0.0, 1.0, 0.0});
    QVERIFY(belly.has_value());
    QTest::mouseClick(view.canvas(), Qt::LeftButton, Qt::NoModifier, view.pixelOf(belly->point_mm).toPoint());
    QVERIFY(!(opened().volume.fileToWorld == before));
    session().probeControl().setHold(movedTo(session().probeControl().hold(), *belly));  // where the recording is now
    session().makeImageNow();
    QTest::qWait(500);
    keepScreenshot(*window_, "author-07-placed");
    QVERIFY2(hand.seen<QProgressBar>("contactShare")->value() >= 20, qPrintable(hand.text("contactFigures")));
  }

  void writeTexts() {
    const PanelHand hand = panel("panel_case_authoring", "casePanel");
    for (auto* head : find<QWidget>("casePanel")->findChildren<QToolButton*>())
      if (head->objectName().startsWith(QStringLiteral("head_")) && !head->isChecked()) head->click();
    hand.press("inventName");
    hand.type("complaint", QStringLiteral("I was asked to come for a check."));
    hand.type("history", QStringLiteral("Never seriously ill."));
    hand.type("indication", QStringLiteral("Liver: size, structure, vessels?"));
    hand.type("findings", QStringLiteral("The liver is of even structure."));
    hand.type("diagnosis", QStringLiteral("Healthy liver."));
    auto* difficulty = hand.seen<QComboBox>("difficulty");
    QVERIFY(difficulty);
    difficulty->setCurrentIndex(2);
    hand.press("addMeasurement");
    hand.type("measurement_0_name", QStringLiteral("hepatic vein, across"));
    hand.choose("measurement_0_kind", QStringLiteral("distance"));
    QVERIFY(waitUntil([&] { return hand.seen<QDoubleSpinBox>("measurement_0_value") != nullptr; }));
    hand.set("measurement_0_value", 9.0);
    hand.set("measurement_0_tolerance", 2.0);
    hand.press("takeStartPose");
    keepScreenshot(*window_, "author-08-texts");
    QCOMPARE(opened().measurements.size(), std::size_t(1));
    QVERIFY(!opened().patient.name.empty());
  }

  void showWhatIsToBeFound() {
    const PanelHand hand = panel("panel_targets", "targetsPanel");
    session().makeImageNow();
    hand.press("addPlane");
    hand.type("targetName", QStringLiteral("across the liver"));
    hand.press("addPoint");
    hand.type("targetName", QStringLiteral("middle of the liver"));
    hand.press("addStructure");
    QVERIFY(rests());
    hand.type("targetName", QStringLiteral("right lobe"));
    hand.press("toolPaint");
    hand.set("paintRadius", 12.0);
    paintFromTo({-15.0, 70.0}, {15.0, 70.0});
    keepScreenshot(*window_, "author-09-painted");
    hand.press("paintKeep");
    QVERIFY2(waitUntil([&] { return window_->isSettled() && hand.text("paintState").startsWith(QStringLiteral("The case holds")); }),
             qPrintable(hand.text("targetsProblem")));
    QCOMPARE(opened().targets.size(), std::size_t(3));
    hand.press("toolPaint");  // put away
  }

  void recordTheExpert(const PanelHand& hand) {
    hand.press("recordExpert");
    scan(12, 0.5);
    hand.press("markWhileRecording");
    scan(12, -0.5);
    keepScreenshot(*window_, "author-12-recording");
    hand.press("stopRecording");
    QVERIFY(waitUntil([&] { return hand.seen<QWidget>("timeLine") != nullptr && window_->isSettled(); }));
    hand.type("markText_0", QStringLiteral("Here the hepatic veins meet."));
    auto* line = hand.seen<QWidget>("timeLine");
    QTest::mouseClick(line, Qt::LeftButton, Qt::NoModifier, QPoint(line->width() / 8, line->height() - 4));
    hand.press("beginHere");
    keepScreenshot(*window_, "author-13-recorded");
  }

  void writeLesson() {
    const PanelHand hand = panel("panel_lesson_editor", "lessonEditor");
    keepScreenshot(*window_, "author-10-outline");
    hand.press("removeLesson");  // the template's outline: this author begins anew
    QVERIFY(waitUntil([&] { return lessonsOf(opened())->empty(); }));
    auto* add = hand.seen<QPushButton>("addLesson");
    QVERIFY(add && add->menu());
    Q_EMIT add->menu()->aboutToShow();
    add->menu()->actions().front()->trigger();
    hand.type("lessonTitle", QStringLiteral("A first look at the liver"));
    hand.type("lessonAim", QStringLiteral("You show the liver and say what belongs to it."));
    const auto step = [&](const char* kind, const std::function<void()>& fill) {
      hand.pick("addStep", QStringLiteral("addStep_") + QLatin1String(kind));
      QVERIFY(waitUntil([&] { return hand.seen<QLineEdit>("stepTitle") != nullptr; }));
      fill();
      if (QTest::currentTestFailed()) return;
      QVERIFY2(waitUntil([&] { return hand.text("stepMissingParts").isEmpty(); }), qPrintable(hand.text("stepMissingParts")));
      keepScreenshot(*window_, (std::string("author-11-") + kind).c_str());
      hand.press("backToSteps");
    };
    step("read", [&] { hand.type("stepText", QStringLiteral("The liver lies below the right ribs.")); });
    step("watch", [&] { recordTheExpert(hand); });
    step("plane", [&] {
      hand.type("stepText", QStringLiteral("Show the liver across."));
      hand.choose("stepTarget", QStringLiteral("across the liver"));
    });
    step("sweep", [&] {
      hand.type("stepText", QStringLiteral("Pass through the whole right lobe."));
      hand.choose("stepTarget", QStringLiteral("right lobe"));
    });
    step("measure", [&] {
      hand.type("stepText", QStringLiteral("Measure the hepatic vein across."));
      hand.choose("stepTarget", QStringLiteral("hepatic vein, across"));
    });
    step("point", [&] {
      hand.type("stepText", QStringLiteral("Point at the middle of the liver."));
      hand.choose("stepTarget", QStringLiteral("middle of the liver"));
    });
    step("settings", [&] {
      hand.type("stepText", QStringLiteral("Set the machine for the liver."));
      hand.press("takeSettings");
    });
    step("answer", [&] {
      hand.type("stepText", QStringLiteral("What bounds the liver above?"));
      hand.type("optionText_0", QStringLiteral("The diaphragm"));
      hand.type("optionText_1", QStringLiteral("The stomach"));
      hand.press("optionRight_0");
    });
    step("free", [&] {
      hand.type("stepText", QStringLiteral("Scan the liver on your own."));
      hand.set("freeShortest", 20.0);
    });
    if (QTest::currentTestFailed()) return;
    const auto lessons = lessonsOf(opened());
    QVERIFY(lessons && lessons->size() == 1);
    QCOMPARE(lessons->front().steps.size(), std::size_t(9));
    QVERIFY(problemsOf(lessons->front(), opened(), {}).empty());
    keepScreenshot(*window_, "author-14-lesson");
    hand.press("backToLessons");
    keepScreenshot(*window_, "author-15-lessons");
  }

  void publishAndExport() {
    const PanelHand form = panel("panel_case_authoring", "casePanel");
    form.press("publishCase");
    QWidget* shown = dialog("publishDialog");
    QVERIFY(shown != nullptr);
    const PanelHand hand(shown);
    QVERIFY(waitUntil([&] { return hand.seen<QToolButton>("checkItem_0") != nullptr; }));
    keepScreenshot(*shown, "author-16-check-list");
    hand.press("publishNow");
    QVERIFY(waitUntil([&] { return hand.text("publishResult").startsWith(QStringLiteral("Published as revision 1")); }));
    keepScreenshot(*shown, "author-17-published");
    const QString bundle = files_.path(QStringLiteral("liver.ewcase"));
    Answers answers({{QStringLiteral("fileDialog"), type(bundle)}});
    hand.press("exportCase");
    QVERIFY(waitUntil([&] { return hand.text("publishResult").startsWith(QStringLiteral("Revision 1 was exported")); }));
    keepScreenshot(*shown, "author-18-exported");
    shown->close();
    const auto header = aside([&] { return verifyBundle(bundle.toStdString()); });
    QVERIFY2(header, header ? "" : header.error().sentence().c_str());
    QCOMPARE(header->id, opened().id);
    QCOMPARE(header->revision, 1);
  }

 private Q_SLOTS:
  void cleanup() { window_.reset(); }

  void fromASweepToAPublishedLesson() {
    if (!QFile::exists(sweepFile())) QSKIP("for want of recordings: ../shared/data/liver-sweep is not there");
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    session().frames().setAdaptive(false);
    window_->openPlugins();
    window_->setWorkspace(Workspace::author);
    window_->showStartPage();
    QVERIFY(rests());
    keepScreenshot(*window_, "author-01-start");
    for (const auto& part : std::initializer_list<std::function<void()>>{[this] { makeCase(); }, [this] { placeIt(); },
                                                                         [this] { writeTexts(); }, [this] { showWhatIsToBeFound(); },
                                                                         [this] { writeLesson(); }, [this] { publishAndExport(); }}) {
      part();
      if (QTest::currentTestFailed()) {
        keepScreenshot(*window_, "author-failed");
        return;
      }
    }
    const auto published = latestPublished(libraryFolder(), opened().id);
    QVERIFY(published.has_value());
    const auto again = loadCaseAside(published->folder);
    QVERIFY(again);
    const auto lessons = lessonsOf(*again);
    QVERIFY(lessons && lessons->size() == 1);
    QCOMPARE(lessons->front().steps.size(), std::size_t(9));
    const auto* watch = std::get_if<WatchTask>(&lessons->front().steps[1].task);
    QVERIFY(watch);
    const auto recorded = readRecording(published->folder / "parts" / "lessons" / watch->recording);
    QVERIFY2(recorded, recorded ? "" : recorded.error().sentence().c_str());
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::AuthorJourneyTest)
#include "author_journey_test.moc"
