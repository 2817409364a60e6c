// Targets of a case in the window: a point, a plane and structures, which are grown and painted in the scan; a painted stone that throws a
// shadow; all of it undone, saved, opened again and asked for by a lesson.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QTranslator>
#include <random>

#include "ew/labelling/labels.h"
#include "ew/library/case.h"
#include "ew/library/lesson.h"
#include "ew/ui_test_door/scan.h"
#include "ew/widgets/apply_theme.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class TargetsTest : public WindowFixture {
  Q_OBJECT

  static constexpr double kDepth_mm = 50.0;  // of the dark ball, below the probe at the start
  static constexpr double kRadius_mm = 12.0;
  QString folder_;

  /// Grey speckle with a dark ball before the probe, as bile in liver.
  [[nodiscard]] QString writeBall(const QString& name) {
    const QString folder = files_.writeCase(name);
    showWindowWithCase(folder);
    const glm::dvec3 middle_mm = (session().shownState().pose.probeToWorld * Point<frame::Probe>{{0.0, kDepth_mm, 0.0}}).at;
    window_.reset();
    auto volume = readVolume(folder.toStdString() + "/volume.mha");
    if (!volume) return {};
    std::mt19937 random(3);
    const Grid& grid = volume->volume.grid;
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i) {
          const double away_mm = glm::distance(carried(grid.voxelToWorld(), glm::dvec3(i, j, k)), middle_mm);
          volume->volume.echo[grid.indexOf(i, j, k)] = static_cast<std::uint8_t>((away_mm < kRadius_mm ? 22 : 105) + random() % 24);
        }
    QFile::remove(folder + QStringLiteral("/volume.mha"));
    return writeVolume(volume->volume, folder.toStdString() + "/volume.mha") ? folder : QString();
  }

  [[nodiscard]] QWidget& panel() const { return *find<QWidget>("targetsPanel"); }
  template <class Widget = QPushButton>
  [[nodiscard]] Widget& in(const char* name) const {
    auto* found = panel().findChild<Widget*>(QLatin1String(name));
    if (found == nullptr) qFatal("there is no widget '%s'", name);
    return *found;
  }
  template <class Button = QPushButton>
  void press(const char* name) {
    QVERIFY2(waitUntil([&] { return in<Button>(name).isEnabled() && in<Button>(name).isVisible(); }), name);
    in<Button>(name).click();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }
  void openPanel() {
    window_->openPlugins();
    window_->setWorkspace(Workspace::author);
    auto* tab = find<QWidget>("panel_targets");
    QVERIFY2(tab != nullptr, "the plugin of authors brings the panel");
    find<QTabWidget>("authorPanel")->setCurrentWidget(tab);
    QVERIFY(waitUntil([this] { return find<QWidget>("targetsPanel") != nullptr && panel().isVisible(); }));
    session().makeImageNow();
  }
  [[nodiscard]] const Case& opened() const { return *window_->document().current(); }
  [[nodiscard]] const CaseTarget& target(std::size_t n) const { return opened().targets.at(n); }
  [[nodiscard]] PickLayer& layer() const { return *find<PickLayer>("pointing"); }
  [[nodiscard]] QPoint pixelAt(double x_mm, double y_mm) const {
    return (window_->scanView().positionOf({{x_mm, y_mm, 0.0}}) - QPointF(layer().pos())).toPoint();
  }
  void clickAt(double x_mm, double y_mm) {
    QVERIFY(waitUntil([this] { return layer().isPicking(); }));
    QTest::mouseClick(&layer(), Qt::LeftButton, Qt::NoModifier, pixelAt(x_mm, y_mm));
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }
  void strokeTo(const std::vector<glm::dvec2>& way_mm) {
    QVERIFY(waitUntil([this] { return layer().isPicking(); }));
    QTest::mousePress(&layer(), Qt::LeftButton, Qt::NoModifier, pixelAt(way_mm.front().x, way_mm.front().y));
    for (const glm::dvec2& at : way_mm) {
      const QPoint pixel = pixelAt(at.x, at.y);
      QMouseEvent move(QEvent::MouseMove, pixel, layer().mapToGlobal(pixel), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QCoreApplication::sendEvent(&layer(), &move);
    }
    QTest::mouseRelease(&layer(), Qt::LeftButton, Qt::NoModifier, pixelAt(way_mm.back().x, way_mm.back().y));
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }
  void name(const char* text) {
    in<QLineEdit>("targetName").selectAll();
    QTest::keyClicks(&in<QLineEdit>("targetName"), QLatin1String(text));
  }
  /// Mean grey of a box of the image plane.
  [[nodiscard]] double meanEcho(double left_mm, double right_mm, double top_mm, double bottom_mm) const {
    session().makeImageNow();
    const ImageView<const std::uint8_t> grey = session().image().grey;
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < grey.height; ++y)
      for (int x = 0; x < grey.width; ++x) {
        const glm::dvec2 at_mm = session().geometry().probePoint_mm(x, y);
        if (at_mm.x < left_mm || at_mm.x > right_mm || at_mm.y < top_mm || at_mm.y > bottom_mm) continue;
        sum += grey.row(y)[x];
        ++count;
      }
    return count == 0 ? -1.0 : sum / count;
  }
  [[nodiscard]] double ml(int label) const {
    const auto& subject = session().subject();
    return subject && subject->labels ? labelling::volume_ml(*subject->labels, static_cast<std::uint8_t>(label)) : 0.0;
  }
  void choose(QComboBox& choice, const QString& text) {
    const int at = choice.findText(text);
    QVERIFY2(at >= 0, qPrintable(text));
    choice.setCurrentIndex(at);
    Q_EMIT choice.activated(at);
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }
  /// A stroke, and a file where what is painted would be kept aside. @return the file
  [[nodiscard]] QString paintWithoutRoomAside() {
    const QString aside = files_.path(QStringLiteral("data/echoweave/unsaved-labels"));
    QDir(aside).removeRecursively();
    QDir().mkpath(QFileInfo(aside).path());
    QFile inTheWay(aside);
    if (!inTheWay.open(QIODevice::WriteOnly)) return {};
    press("addStructure");
    if (!window_->document().save()) return {};
    press("toolPaint");
    strokeTo({{0.0, 40.0}});
    return aside;
  }
  void keep() {
    press("paintKeep");
    QVERIFY2(waitUntil([this] { return in<QLabel>("paintState").text().startsWith(QStringLiteral("The case holds")); }),
             qPrintable(in<QLabel>("targetsProblem").text()));
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }

 private Q_SLOTS:
  void init() {
    folder_ = writeBall(QStringLiteral("to be found"));
    QVERIFY(!folder_.isEmpty());
    showWindowWithCase(folder_);
    openPanel();
  }
  void cleanup() {
    window_.reset();
    QDir(folder_).removeRecursively();
  }

  void aPointIsClickedAndUndone() {
    keepScreenshot(*window_, "targets-01-empty");
    QVERIFY(in<QLabel>("targetsEmpty").isVisible());
    press("addPoint");
    QCOMPARE(opened().targets.size(), std::size_t(1));
    name("middle of the ball");
    press("pointClick");
    clickAt(3.0, 46.0);
    const glm::dvec3 clicked_mm = carried(inverse(session().shownState().pose.probeToWorld), *target(0).at_mm);
    QVERIFY2(glm::distance(clicked_mm, glm::dvec3(3.0, 46.0, 0.0)) < 0.6, "the identity places this case");
    in<QDoubleSpinBox>("pointTolerance").setValue(8.0);
    QCOMPARE(*target(0).tolerance_mm, 8.0);
    QCOMPARE(target(0).name, std::string("middle of the ball"));
    in<QCheckBox>("targetReveals").click();
    QVERIFY(target(0).revealsFinding);
    keepScreenshot(*window_, "targets-02-point");
    while (window_->document().history().canUndo()) window_->document().undo();
    QVERIFY(opened().targets.empty());
    QVERIFY(in<QLabel>("targetsEmpty").isVisible());
  }

  void aPlaneIsTakenLeftAndGoneBackTo() {
    press("addPlane");
    QVERIFY(in<QLabel>("planeAway").text().contains(QStringLiteral("within")));
    const auto taken = *target(0).probeToFile;
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, 15.0));
    session().makeImageNow();
    QVERIFY(waitUntil([this] { return !in<QLabel>("planeAway").text().contains(QStringLiteral("within")); }));
    QVERIFY2(in<QLabel>("planeAway").text().contains(QStringLiteral("mm")), qPrintable(in<QLabel>("planeAway").text()));
    keepScreenshot(*window_, "targets-03-plane");
    press("planeGo");
    session().makeImageNow();
    QVERIFY2(waitUntil([this] { return in<QLabel>("planeAway").text().contains(QStringLiteral("within")); }),
             qPrintable(in<QLabel>("planeAway").text()));
    session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, 15.0));
    session().makeImageNow();
    press("planeTake");
    QVERIFY(glm::distance(glm::dvec3(target(0).probeToFile->matrix[3]), glm::dvec3(taken.matrix[3])) > 10.0);
    window_->document().undo();
    QVERIFY(glm::distance(glm::dvec3(target(0).probeToFile->matrix[3]), glm::dvec3(taken.matrix[3])) < 1e-9);
  }

  void aStructureGrowsFromAClickIsKeptAndOpenedAgain() {
    press("addStructure");
    QCOMPARE(*target(0).label, 1);
    QVERIFY(!opened().volume.labels.empty());
    name("ball");
    in<QDoubleSpinBox>("growReach").setValue(30.0);
    press("toolGrow");
    clickAt(0.0, kDepth_mm);
    const double ball_ml = 4.0 / 3.0 * 3.14159265 * kRadius_mm * kRadius_mm * kRadius_mm * 1e-3;
    QVERIFY2(std::abs(ml(1) - ball_ml) < 0.15 * ball_ml, qPrintable(QString::number(ml(1))));
    keepScreenshot(*window_, "targets-04-grown");
    press("paintUndo");
    QCOMPARE(ml(1), 0.0);
    press("paintRedo");
    keep();
    const std::string kept = opened().volume.labels;
    const double kept_ml = ml(1);
    QVERIFY(std::abs(kept_ml - ball_ml) < 0.15 * ball_ml);
    window_->document().undo();
    QVERIFY(waitUntil([this] { return window_->isSettled() && ml(1) == 0.0; }));
    window_->document().redo();
    QVERIFY(waitUntil([&] { return window_->isSettled() && ml(1) == kept_ml; }));
    QVERIFY(window_->document().save());

    // A lesson may ask for it: its truth is the label that was grown.
    auto again = loadCaseAside(folder_.toStdString());
    QVERIFY(again);
    QCOMPARE(again->volume.labels, kept);
    auto echo = loadCaseVolume(*again, noProgress());
    QVERIFY(echo && echo->labels);
    QCOMPARE(labelling::volume_ml(*echo->labels, 1), kept_ml);
  }

  void aLessonAsksForTheStructureThatWasGrown() {
    press("addStructure");
    name("ball");
    press("toolGrow");
    clickAt(0.0, kDepth_mm);
    keep();
    LessonStep step;
    step.id = "point";
    step.title = "Point at the ball";
    step.text = "Click the ball.";
    step.task = PointTask{"ball"};
    Lesson lesson;
    lesson.id = "first";
    lesson.title = "The ball";
    lesson.steps = {step};
    Case taught = opened();
    taught.otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson});
    QVERIFY(window_->document().edit(taught, "Write a lesson", {}));
    QVERIFY(window_->document().save());
    QVERIFY(openCase(files_.writeCase(QStringLiteral("other"))));
    QVERIFY(openCase(folder_));
    window_->setWorkspace(Workspace::explore);
    QVERIFY(waitUntil([this] { return find<QWidget>("lessonPlayer") != nullptr && find<QWidget>("lessonPlayer")->isVisible(); }));
    const auto seen = [this](const char* button) -> QPushButton* {
      for (auto* each : find<QWidget>("lessonPlayer")->findChildren<QPushButton*>(QLatin1String(button)))
        if (each->isVisible() && each->isEnabled()) return each;
      return nullptr;
    };
    for (const char* button : {"startLesson", "pointAtIt"}) {
      QVERIFY2(waitUntil([&] { return seen(button) != nullptr; }), button);
      seen(button)->click();
    }
    session().makeImageNow();
    clickAt(0.0, kDepth_mm);
    keepScreenshot(*window_, "targets-08-asked-for");
    QVERIFY(waitUntil([&] { return seen("stepDone") != nullptr; }));
    seen("stepDone")->click();
    const auto heading = [this] {
      for (auto* each : find<QWidget>("lessonPlayer")->findChildren<QLabel*>(QStringLiteral("outcomeHeading")))
        if (each->isVisible()) return each->text();
      return QString();
    };
    QVERIFY2(waitUntil([&] { return heading().startsWith(QStringLiteral("Passed")); }), qPrintable(heading()));
  }

  void aPaintedStoneThrowsAShadow() {
    const double before = meanEcho(-3.0, 3.0, 62.0, 90.0), beside = meanEcho(22.0, 30.0, 62.0, 90.0);
    press("addStructure");
    name("stone");
    press("toolPaint");
    in<QDoubleSpinBox>("paintRadius").setValue(5.0);
    strokeTo({{-5.0, kDepth_mm}, {0.0, kDepth_mm}, {5.0, kDepth_mm}});
    QVERIFY(ml(1) > 0.5);
    // The image has another size by now, for the column beside it has grown.
    QVERIFY(std::abs(meanEcho(-3.0, 3.0, 62.0, 90.0) - before) < 0.02 * before);
    choose(in<QComboBox>("structureTissue"), QStringLiteral("Stone"));
    QVERIFY(opened().scene.attenuation.has_value());
    const double behind = meanEcho(-3.0, 3.0, 62.0, 90.0);
    QVERIFY2(behind < 0.5 * before, qPrintable(QStringLiteral("%1 after %2").arg(behind).arg(before)));
    QVERIFY(std::abs(meanEcho(22.0, 30.0, 62.0, 90.0) - beside) < 0.15 * beside);
    keepScreenshot(*window_, "targets-05-stone");
    QTest::keyClick(&layer(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY2(waitUntil([this] { return ml(1) == 0.0; }), "Ctrl+Z takes the stroke back first");
    QVERIFY(meanEcho(-3.0, 3.0, 62.0, 90.0) > 0.9 * before);
    QTest::keyClick(&layer(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    press("toolErase");
    strokeTo({{6.0, kDepth_mm - 6.0}, {6.0, kDepth_mm + 6.0}});
    press("largestPiece");
    press("smoothLabel");
    keep();
    QVERIFY(meanEcho(-3.0, 3.0, 62.0, 90.0) < 0.5 * before);
    press("removeTarget");
    QVERIFY(waitUntil([this] { return window_->isSettled() && opened().targets.empty() && ml(1) == 0.0; }));
    QVERIFY2(meanEcho(-3.0, 3.0, 62.0, 90.0) > 0.9 * before, "a stone that was removed throws no shadow");
    window_->document().undo();
    QVERIFY(waitUntil([this] { return window_->isSettled() && ml(1) > 0.0; }));
    QVERIFY(meanEcho(-3.0, 3.0, 62.0, 90.0) < 0.5 * before);
    QVERIFY(window_->document().save());
    const QString other = files_.writeCase(QStringLiteral("other"));
    QVERIFY(openCase(other));
    QVERIFY(openCase(folder_));
    session().makeImageNow();
    QVERIFY2(meanEcho(-3.0, 3.0, 62.0, 90.0) < 0.5 * before, "opened again it throws its shadow");
  }

  void outlinesOfSeveralPlanesBecomeOneShape() {
    press("addStructure");
    press("toolTrace");
    for (const double along_mm : {-8.0, 8.0, 8.0}) {
      session().probeControl().setHold(slid(session().probeControl().hold(), *session().probeControl().skin(), 0.0, along_mm));
      session().makeImageNow();
      strokeTo({{-10.0, 40.0}, {10.0, 40.0}, {10.0, 60.0}, {-10.0, 60.0}});
    }
    QVERIFY2(in("fillBetween").text().contains(QLatin1Char('3')), qPrintable(in("fillBetween").text()));
    const double traced_ml = ml(1);
    keepScreenshot(*window_, "targets-06-traced");
    press("fillBetween");
    QVERIFY2(in<QLabel>("targetsProblem").text().isEmpty(), qPrintable(in<QLabel>("targetsProblem").text()));
    QVERIFY2(ml(1) > 1.3 * traced_ml, qPrintable(QStringLiteral("%1 after %2").arg(ml(1)).arg(traced_ml)));
    press("paintDiscard");
    QVERIFY(waitUntil([this] { return ml(1) == 0.0; }));
  }

  void whatWasPaintedIsOfferedWhenTheCaseIsOpenedAgain() {
    press("addStructure");
    QVERIFY(window_->document().save());
    press("toolPaint");
    strokeTo({{0.0, 40.0}});
    const double painted_ml = ml(1);
    QVERIFY(painted_ml > 0.05);
    QVERIFY(openCase(files_.writeCase(QStringLiteral("other"))));
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    QVERIFY(openCase(folder_));
    QVERIFY(waitUntil([this] { return in<QWidget>("paintLeft").isVisible(); }));
    keepScreenshot(*window_, "targets-07-left");
    press("paintGoOn");
    QVERIFY(waitUntil([&] { return ml(1) == painted_ml; }));
    keep();
    QVERIFY(!in<QWidget>("paintLeft").isVisible());
  }

  void whatCannotBeKeptAsideIsKeptWhenItIsTriedAgain() {
    const QString inTheWay = paintWithoutRoomAside();
    const double painted_ml = ml(1);
    QVERIFY(painted_ml > 0.05);
    QVERIFY(openCase(files_.writeCase(QStringLiteral("other"))));
    QVERIFY(waitUntil([this] { return in<QWidget>("paintUnkept").isVisible(); }));
    QVERIFY2(window_->messages().text().contains(QStringLiteral("in this window alone")), qPrintable(window_->messages().text()));
    QVERIFY2(!window_->messages().text().contains(QStringLiteral("is offered")), "it was not kept");
    keepScreenshot(*window_, "targets-08-unkept");
    QVERIFY(QFile::remove(inTheWay));
    press("paintKeepElsewhere");
    QVERIFY(waitUntil([this] { return window_->messages().text().contains(QStringLiteral("is offered when")); }));
    QVERIFY(!in<QWidget>("paintUnkept").isVisible());
    QVERIFY(openCase(folder_));
    QVERIFY(waitUntil([this] { return in<QWidget>("paintLeft").isVisible(); }));
    press("paintGoOn");
    QVERIFY(waitUntil([&] { return ml(1) == painted_ml; }));
  }

  void whatCannotBeKeptAsideWaitsInTheWindowForItsCase() {
    const QString inTheWay = paintWithoutRoomAside();
    const double painted_ml = ml(1);
    QVERIFY(openCase(files_.writeCase(QStringLiteral("other"))));
    QVERIFY(waitUntil([this] { return in<QWidget>("paintUnkept").isVisible(); }));
    QVERIFY(openCase(folder_));
    QVERIFY(waitUntil([this] { return in<QWidget>("paintLeft").isVisible(); }));
    QVERIFY(!in<QWidget>("paintUnkept").isVisible());
    press("paintGoOn");
    QVERIFY(waitUntil([&] { return ml(1) == painted_ml; }));
    keep();
    QVERIFY(!in<QWidget>("paintLeft").isVisible());
    QVERIFY(QFile::remove(inTheWay));
  }

  void itLooksGoodInBothThemesInASmallWindowAndInGerman() {
    if (screenshotFolder().isEmpty()) QSKIP("images for a person to look at");
    const auto fill = [this] {
      press("addPoint");
      press("addPlane");
      press("addStructure");
      press("toolGrow");
      clickAt(0.0, kDepth_mm);
      press("toolPaint");
    };
    fill();
    for (const bool dark : {true, false}) {
      applyTheme(dark ? darkTheme() : lightTheme());
      window_->view3d().setDarkTheme(dark);
      window_->resize(1440, 900);
      QTest::qWait(2500);  // until the surface is made
      keepScreenshot(*window_, dark ? "targets-09-dark" : "targets-10-light");
    }
    window_->resize(1024, 640);
    keepScreenshot(*window_, "targets-11-small");
    window_.reset();
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QApplication::installTranslator(&german);
    const QLocale before;
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    showWindowWithCase(folder_);
    openPanel();
    fill();
    press("toolTrace");
    keepScreenshot(*window_, "targets-12-german");
    window_->resize(1024, 640);
    press("toolGrow");
    keepScreenshot(*window_, "targets-13-german-small");
    window_.reset();
    QApplication::removeTranslator(&german);
    QLocale::setDefault(before);
  }
};

}  // namespace ew::ui::testing

using ew::ui::testing::TargetsTest;
EW_WINDOW_TEST_MAIN(TargetsTest)
#include "targets_test.moc"
