// A plugin that knows nothing but the installed SDK, in the real window: a workspace and a section of the case of its own, drawings that
// follow the probe, a path that moves the probe and gives it back, its own German.
#include <QAction>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ew/imaging/display_image.h"
#include "ew/library/schema.h"
#include "ew/ui_test_door/images.h"
#include "ew/widgets/words.h"
#include "gui/support/answers.h"
#include "gui/support/window_fixture.h"
#include "places.h"

namespace ew::ui {
namespace {

const std::string kBuilt = std::string(EW_BINARY_DIR) + "/tests/guided_sweep/build/lib/plugins";

class GuidedSweepTest final : public testing::WindowFixture {
  Q_OBJECT

 private:
  QString folder_;

  void openWindow() {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1500, 860);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    session().frames().setAdaptive(false);
    QVERIFY(testing::waitUntil([this] { return !window_->jobs().isRunning(); }));
    window_->openPlugins();
    QVERIFY(openCase(folder_));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
  }
  void showGuide() const { QTest::mouseClick(find<QPushButton>("workspaceGuide"), Qt::LeftButton); }
  void press(const char* name) const {
    auto* button = find<QPushButton>(name);
    QVERIFY2(button != nullptr && button->isEnabled(), name);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  /// Slides the probe along the skin, and waits for its image.
  void slide(double right_mm, double up_mm) const {
    Hold hold = session().probeControl().hold();
    hold.contact = session().probeControl().skin()->nearest(hold.contact.point_mm + glm::dvec3(-right_mm, 0.0, up_mm));
    session().probeControl().setHold(hold);
    waitForImage();
  }
  void waitForImage() const {
    session().frames().ask();
    session().makeImageNow();
    QTest::qWait(0);
  }
  /// A sweep of a second, 40 mm long, between two poses of the hand; the hand stays at its end.
  void keepSweep() const {
    press("guideStart");
    slide(25.0, 30.0);
    press("guideEnd");
    find<QDoubleSpinBox>("guideDuration")->setValue(1.0);
  }
  [[nodiscard]] nlohmann::json section() const {
    const nlohmann::json others = window_->document().current()->otherFields;
    return others.contains("parts") ? others["parts"].value("guided_sweep", nlohmann::json()) : nlohmann::json();
  }
  [[nodiscard]] static double apart_mm(const Pose& a, const Pose& b) {
    return glm::distance(glm::dvec3(a.probeToWorld.matrix[3]), glm::dvec3(b.probeToWorld.matrix[3]));
  }
  /// Whether the view shows the accent's colour within two pixels of a point of the image plane.
  [[nodiscard]] bool isDrawnAt(const glm::dvec2& at_mm) const {
    const QImage shown = window_->scanView().grab().toImage();
    const QPointF at = window_->scanView().positionOf({{at_mm.x, at_mm.y, 0.0}}) * shown.devicePixelRatio();
    const QColor accent = scanTheme().accent;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const QPoint pixel(static_cast<int>(std::lround(at.x())) + dx, static_cast<int>(std::lround(at.y())) + dy);
        if (!shown.rect().contains(pixel)) continue;
        const QColor found = shown.pixelColor(pixel);
        const int difference =
            std::abs(found.red() - accent.red()) + std::abs(found.green() - accent.green()) + std::abs(found.blue() - accent.blue());
        if (difference < 60) return true;
      }
    return false;
  }
  /// Whether words in the accent's colour stand at the right of the ring about a point.
  [[nodiscard]] bool isLabelled(const glm::dvec2& middle_mm) const {
    const double right = session().geometry().markerLeft ? -1.0 : 1.0;
    const double perPixel_mm = window_->scanView().mmPerWidgetPixel();
    int drawn = 0;
    for (double x_px = 18.0; x_px < 60.0; x_px += 3.0)
      drawn += isDrawnAt(middle_mm + glm::dvec2(right * (10.0 + x_px * perPixel_mm), 0.0)) ? 1 : 0;
    return drawn >= 4;
  }
  /// The target is a ring of 10 mm about the point 60 mm below the sweep's end; somewhere on it, for it may be dashed.
  [[nodiscard]] bool isRingDrawnAbout(const glm::dvec2& middle_mm) const {
    int drawn = 0;
    for (int n = 0; n < 16; ++n) {
      const double angle_rad = 0.1 + n * 6.283185307 / 16;
      drawn += isDrawnAt(middle_mm + 10.0 * glm::dvec2(std::cos(angle_rad), std::sin(angle_rad))) ? 1 : 0;
    }
    return drawn >= 6;
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY2(QFile::exists(QString::fromStdString(kBuilt) + QStringLiteral("/guided_sweep/guided_sweep.so")),
             "ctest builds it first, as the test GuidedSweepBuild");
  }
  void init() {
    QLocale::setDefault(QLocale(QLocale::English));
    qputenv("ECHOWEAVE_PLUGINS", kBuilt.c_str());
    folder_ = files_.writeCase(QLatin1String(QTest::currentTestFunction()));  // of its own: nobody asks about edits of the test before
    QVERIFY(!folder_.isEmpty());
  }
  void cleanup() { window_.reset(); }

  void itsWorkspaceStandsBesideExploreAndAuthorAndKeepsTheViews() {
    openWindow();
    auto* button = find<QPushButton>("workspaceGuide");
    QVERIFY(button != nullptr && button->isVisible());
    QCOMPARE(button->text(), QStringLiteral("Guide"));
    QVERIFY(!button->icon().isNull());
    showGuide();
    QVERIFY(button->isChecked());
    QVERIFY(find<QWidget>("panel_guided_sweep")->isVisible());
    QVERIFY(window_->scanView().isVisible() && window_->view3d().isVisible());
    window_->setWorkspace(Workspace::author);
    QVERIFY(!find<QWidget>("panel_guided_sweep")->isVisible());
    QTest::keyClick(window_.get(), Qt::Key_3, Qt::ControlModifier);
    QVERIFY(find<QWidget>("panel_guided_sweep")->isVisible());
    window_->setWorkspace(Workspace::explore);
    QVERIFY(!find<QWidget>("panel_guided_sweep")->isVisible());
    QVERIFY(!button->isChecked());
  }

  void itsSectionOfTheCaseIsUndoneSavedAndKeptWithoutIt() {
    openWindow();
    showGuide();
    QVERIFY(section().is_null());
    keepSweep();
    QVERIFY(section().contains("start") && section().contains("end"));
    QCOMPARE(section()["duration_s"].get<double>(), 1.0);
    CaseDocument& document = window_->document();
    QCOMPARE(document.history().steps(), std::size_t{3});
    QCOMPARE(document.history().undoName(), std::string("Duration of the sweep"));
    document.undo();
    document.undo();
    QVERIFY(section().contains("start") && !section().contains("end"));
    QCOMPARE(find<QLabel>("guideState")->text(), QStringLiteral("The sweep has no end yet."));
    document.redo();
    document.redo();
    const nlohmann::json kept = section();
    QVERIFY(window_->document().save().has_value());

    const testing::Answers answers({{QStringLiteral("keptEditsQuestion"), testing::press("discardKept")}});
    qputenv("ECHOWEAVE_PLUGINS", files_.path(QStringLiteral("none")).toUtf8());
    window_.reset();
    openWindow();
    QVERIFY(find<QPushButton>("workspaceGuide") == nullptr);
    Case edited = *window_->document().current();
    edited.title = "Edited without the plugin";
    QVERIFY(window_->document().edit(edited, "Title", "").has_value());
    QVERIFY(window_->document().save().has_value());
    window_.reset();
    qputenv("ECHOWEAVE_PLUGINS", kBuilt.c_str());
    openWindow();
    QVERIFY(section() == kept);
  }

  void itsDrawingsFollowTheProbeThroughZoomAndInversionAndStayOutOfSavedImages() {
    openWindow();
    showGuide();
    QVERIFY(!isRingDrawnAbout({0.0, 60.0}));
    const QDateTime at(QDate(2026, 1, 2), QTime(3, 4));
    const QImage saved = savedImage(session(), at);
    press("guideEnd");
    QVERIFY(isRingDrawnAbout({0.0, 60.0}));
    QVERIFY(isLabelled({0.0, 60.0}));
    QCOMPARE(savedImage(session(), at), saved);
    const Hold there = session().probeControl().hold();
    slide(20.0, 0.0);
    const auto target =
        inverse(session().imagePose().probeToWorld) * (poseOf(section()["end"]).probeToWorld * Point<frame::Probe>{{0.0, 60.0, 0.0}});
    QVERIFY(std::abs(target.at.x) > 5.0);
    QVERIFY(isRingDrawnAbout({target.at.x, target.at.y}));
    QVERIFY(!isRingDrawnAbout({target.at.x + 30.0, target.at.y}));
    session().probeControl().setHold(there);
    Knobs knobs = session().console().knobs();
    knobs.zoom = 1.5;
    knobs.markerLeft = !knobs.markerLeft;
    knobs.upsideDown = true;
    session().console().setKnobs(knobs);
    waitForImage();
    QVERIFY(isRingDrawnAbout({0.0, 60.0}));
    QVERIFY(isLabelled({0.0, 60.0}));
    window_->document().undo();
    QVERIFY(!isRingDrawnAbout({0.0, 60.0}));
  }

  void itMovesTheProbeAlongAPathAndGivesItBack() {
    openWindow();
    showGuide();
    const Pose begin = session().probeControl().pose();
    keepSweep();
    const Pose end = session().probeControl().pose();
    slide(-10.0, -60.0);
    const Pose hand = session().probeControl().pose();
    std::vector<Pose> seen;
    bool isOver = false;
    const auto connection = connect(&session(), &Session::imageChanged, this, [&] {
      if (isOver || (seen.empty() && !session().probeControl().isFollowing())) return;
      seen.push_back(session().shownState().pose);
      isOver = !session().probeControl().isFollowing();  // the plugin gave the probe back at this image
    });
    press("guideRun");
    QVERIFY(session().probeControl().isFollowing());
    QVERIFY(!window_->hand().isEnabled());
    QCOMPARE(find<QPushButton>("guideRun")->text(), QStringLiteral("Give the probe back"));
    QVERIFY(testing::waitUntil([this] { return !session().probeControl().isFollowing(); }));
    disconnect(connection);
    QVERIFY(!seen.empty());
    for (std::size_t n = 0; n < seen.size(); ++n) {
      QVERIFY(apart_mm(begin, seen[n]) + apart_mm(seen[n], end) < apart_mm(begin, end) + 1e-6);
      if (n > 0) QVERIFY(apart_mm(seen[n], end) <= apart_mm(seen[n - 1], end) + 1e-9);
    }
    QVERIFY(apart_mm(seen.back(), end) < 1e-6);
    QVERIFY(apart_mm(session().probeControl().pose(), hand) < 1e-9);
    QVERIFY(window_->hand().isEnabled());
    QCOMPARE(find<QPushButton>("guideRun")->text(), QStringLiteral("Show the sweep"));
  }

  void theUserTakesTheProbeBackAtAnyTime() {
    openWindow();
    showGuide();
    keepSweep();
    find<QDoubleSpinBox>("guideDuration")->setValue(60.0);
    const Pose hand = session().probeControl().pose();
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->shortcuts().contains(QKeySequence(QStringLiteral("Ctrl+G")))) action->trigger();
    QVERIFY(session().probeControl().isFollowing());
    testing::Answers answers({{QStringLiteral("unsavedQuestion"), testing::press(QMessageBox::Discard)},
                              {QStringLiteral("unsavedPluginQuestion"), testing::press(QMessageBox::Cancel)}});
    QVERIFY(!window_->close());
    QVERIFY2(answers.texts.contains(QStringLiteral("The guided sweep is still going on.")),
             qPrintable(answers.texts.join(QLatin1Char('|'))));
    QVERIFY(session().probeControl().isFollowing());
    QTest::keyClick(&window_->scanView(), Qt::Key_Escape);
    QVERIFY(!session().probeControl().isFollowing());
    QVERIFY(apart_mm(session().probeControl().pose(), hand) < 1e-9);
    QCOMPARE(find<QPushButton>("guideRun")->text(), QStringLiteral("Show the sweep"));
  }

  void anotherCaseGivesTheProbeBack() {
    const QString other = files_.writeCase(QStringLiteral("another"));
    openWindow();
    showGuide();
    keepSweep();
    find<QDoubleSpinBox>("guideDuration")->setValue(60.0);
    QVERIFY(window_->document().save().has_value());
    press("guideRun");
    QVERIFY(session().probeControl().isFollowing());
    window_->open(other);
    QVERIFY(testing::waitUntil([&] { return window_->isSettled() && window_->document().current()->folder == other.toStdString(); }));
    QVERIFY(!session().probeControl().isFollowing());
    QVERIFY(section().is_null());
    QVERIFY(!isRingDrawnAbout({0.0, 60.0}));
  }

  void itSpeaksItsOwnGerman() {
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    openWindow();
    QCOMPARE(find<QPushButton>("workspaceGuide")->text(), QStringLiteral("Führen"));
    showGuide();
    QCOMPARE(find<QPushButton>("guideStart")->text(), QStringLiteral("Anfang hier"));
    press("guideStart");
    QCOMPARE(window_->document().history().undoName(), std::string("Anfang des Schwenks"));
    window_->document().undo();
    QCOMPARE(words(say<"Nothing is scanned; open a case first.">()), QStringLiteral("Es wird nichts geschallt; zuerst einen Fall öffnen."));
    const auto schema = PartSchema::of(R"({"description": "a number from 1 to 60", "maximum": 60})", verbatim("the plugin's own"));
    QVERIFY(schema.has_value());
    const QString refused = words(schema->problems(600, "parts.guided_sweep.duration_s", verbatim("case.json")).front());
    QVERIFY2(refused.contains(QStringLiteral("eine Zahl von 1 bis 60")), qPrintable(refused));
  }

 private:
  [[nodiscard]] static Pose poseOf(const nlohmann::json& sixteen) {
    Pose pose;
    pose.probeToWorld.matrix = matrixFromRows(sixteen.get<std::array<double, 16>>());
    return pose;
  }
};

}  // namespace
}  // namespace ew::ui

EW_WINDOW_TEST_MAIN(ew::ui::GuidedSweepTest)
#include "guided_sweep_test.moc"
