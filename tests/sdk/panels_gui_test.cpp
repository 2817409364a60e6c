// The panels of both plugins, opened through the door as the workstation opens them, and driven as a user drives them.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QUrl>
#include <QtTest>

#include "ew/door/door.h"
#include "ew/io/volume_file.h"
#include "library/temporary_folder.h"
#include "places.h"
#include "sdk/panel_host.h"

using namespace ew;

class PanelsTest final : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QWidget> open(test::PanelHost& host, const std::string& id) {
    std::unique_ptr<QWidget> panel(host.made.at(id)(nullptr));
    panel->resize(400, 760);
    panel->show();
    [[maybe_unused]] const bool exposed = QTest::qWaitForWindowExposed(panel.get(), 240000);
    return panel;
  }
  template <class Widget>
  static Widget* child(const std::unique_ptr<QWidget>& panel, const char* name) {
    auto* found = panel->findChild<Widget*>(QLatin1String(name));
    if (found == nullptr) qFatal("there is no widget '%s'", name);
    return found;
  }
  static void drop(const std::unique_ptr<QWidget>& panel, const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(panel.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(panel.get(), &event);
  }
  static Case caseCalled(const std::string& title) {
    Case made;
    made.id = "x";
    made.title = title;
    made.volume.file = "a.mha";
    return made;
  }
  static void keepImage(const std::unique_ptr<QWidget>& panel, const char* name) {
    const QString folder = qEnvironmentVariable("ECHOWEAVE_TEST_PICTURES");
    if (!folder.isEmpty()) panel->grab().save(folder + QLatin1Char('/') + QLatin1String(name));
  }

  test::PanelHost host_;
  std::unique_ptr<door::PluginList> plugins_;

 private Q_SLOTS:
  void initTestCase() {
    plugins_ = std::make_unique<door::PluginList>(std::vector<std::filesystem::path>{std::filesystem::path(EW_BINARY_DIR) / "lib/plugins"});
    plugins_->openAll(host_);
    for (const auto& plugin : plugins_->states()) QVERIFY2(plugin.message.empty(), plugin.sentence().c_str());
    QVERIFY(host_.made.count("stitching") == 1 && host_.made.count("case_authoring") == 1);
  }

  void withoutACaseTheFormSaysWhatToDo() {
    host_.theCase.opened.reset();
    const auto panel = open(host_, "case_authoring");
    QVERIFY(!child<QLineEdit>(panel, "title")->isVisible());
    keepImage(panel, "case-empty.png");
  }

  void typingIsOneUndoableStepAField() {
    host_.theCase.opened = caseCalled("One");
    host_.theCase.opened->otherFields["lesson"] = 4;
    const auto panel = open(host_, "case_authoring");
    auto* title = child<QLineEdit>(panel, "title");
    QCOMPARE(title->text(), QStringLiteral("One"));
    title->setFocus();
    title->end(false);
    QTest::keyClicks(title, QStringLiteral(" more"));
    QTest::keyClicks(child<QPlainTextEdit>(panel, "history"), QStringLiteral("pain"));
    const Case& edited = *host_.theCase.opened;
    QCOMPARE(edited.title, std::string("One more"));
    QCOMPARE(edited.history, std::string("pain"));
    QCOMPARE(edited.otherFields["lesson"].get<int>(), 4);
    QCOMPARE(host_.theCase.before.size(), std::size_t(2));
    QVERIFY(child<QLabel>(panel, "savedMark")->text().contains(QStringLiteral("unsaved changes")));
    host_.theCase.undo();
    host_.theCase.undo();
    QCOMPARE(title->text(), QStringLiteral("One"));
    QCOMPARE(child<QPlainTextEdit>(panel, "history")->toPlainText(), QString());
  }

  void whatTheSchemaRefusesIsSaidBesideTheFieldAndChangesNothing() {
    const auto panel = open(host_, "case_authoring");
    const auto before = host_.theCase.opened;
    auto* age = child<QSpinBox>(panel, "patient_age_years");
    age->setValue(400);
    auto* problem = child<QLabel>(panel, "patient_age_years_problem");
    QVERIFY(problem->isVisible());
    QVERIFY2(problem->text().contains(QStringLiteral("130")), qPrintable(problem->text()));
    QVERIFY(host_.theCase.opened == before);
    const int saves = host_.theCase.saves;
    QTest::mouseClick(child<QPushButton>(panel, "save"), Qt::LeftButton);
    QCOMPARE(host_.theCase.saves, saves);
    keepImage(panel, "case-refused.png");
    age->setValue(46);
    QVERIFY(!problem->isVisible());
    QCOMPARE(host_.theCase.opened->patient.age_years.value(), 46);
    QTest::mouseClick(child<QPushButton>(panel, "save"), Qt::LeftButton);
    QCOMPARE(host_.theCase.saves, saves + 1);
    QVERIFY(!child<QLabel>(panel, "savedMark")->text().contains(QStringLiteral("not")));
  }

  void theDigitsOnTheWayToARefusedNumberDoNotStayInTheCase() {
    const auto panel = open(host_, "case_authoring");
    const auto before = host_.theCase.opened;
    auto* age = child<QSpinBox>(panel, "patient_age_years");
    age->setFocus();
    age->selectAll();
    QTest::keyClicks(age, QStringLiteral("999"));
    QCOMPARE(age->value(), 999);
    QVERIFY(child<QLabel>(panel, "patient_age_years_problem")->isVisible());
    QVERIFY2(host_.theCase.opened == before, manifestOf(*host_.theCase.opened).dump().c_str());
    auto* title = child<QLineEdit>(panel, "title");
    title->setFocus();
    while (!title->text().isEmpty()) QTest::keyClick(title, Qt::Key_Backspace);
    QVERIFY(child<QLabel>(panel, "title_problem")->isVisible());
    QVERIFY2(host_.theCase.opened == before, manifestOf(*host_.theCase.opened).dump().c_str());
  }

  void undoInAFieldIsTheCasesOwn() {
    const auto panel = open(host_, "case_authoring");
    const auto place = open(host_, "placing");
    auto* title = child<QLineEdit>(panel, "title");
    title->setFocus();
    QTest::keyClicks(title, QStringLiteral("abc"));
    for (QWidget* field : {static_cast<QWidget*>(title), static_cast<QWidget*>(child<QSpinBox>(panel, "patient_age_years")),
                           static_cast<QWidget*>(child<QDoubleSpinBox>(place, "placement_x"))}) {
      for (const int key : {Qt::Key_Z, Qt::Key_C}) {
        QKeyEvent claim(QEvent::ShortcutOverride, key, Qt::ControlModifier);
        claim.ignore();
        QApplication::sendEvent(field, &claim);
        if (key == Qt::Key_Z) QVERIFY2(!claim.isAccepted(), qPrintable(field->objectName()));
        if (key == Qt::Key_C) QVERIFY2(claim.isAccepted(), qPrintable(field->objectName()));
      }
    }
  }

  void thePlaceOfTheVolumeIsEditedAsSixNumbers() {
    const auto panel = open(host_, "placing");
    child<QDoubleSpinBox>(panel, "placement_x")->setValue(12.5);
    child<QDoubleSpinBox>(panel, "placement_rz")->setValue(90);
    const std::vector<double> expected = {0, -1, 0, 12.5, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const auto rows = rowsOf(host_.theCase.opened->volume.fileToWorld);
    QVERIFY(std::equal(rows.begin(), rows.end(), expected.begin(), expected.end()));
    keepImage(panel, "place-form.png");
  }

  void theStartPoseIsTakenFromTheScanAndSaidWhenItSeesNothing() {
    host_.theCase.opened = caseCalled("One");
    host_.theCase.present.reset();
    const auto panel = open(host_, "case_authoring");
    auto* take = child<QPushButton>(panel, "takeStartPose");
    auto* remark = child<QLabel>(panel, "startRemark");
    take->click();
    QVERIFY(child<QLabel>(panel, "problem")->isVisible());  // nothing is scanned: there is nothing to take
    QVERIFY(!host_.theCase.opened->startPose);
    // 100 mm cube at the origin, the probe on its upper face, looking along +y.
    sdk::Cases::Scan scan;
    scan.probe = "linear-12";
    scan.probeToWorld.matrix[3] = glm::dvec4(50.0, 0.0, 50.0, 1.0);
    scan.depth_mm = 60.0;
    scan.halfFace_mm = 20.0;
    scan.volume.dims = {101, 101, 101};
    host_.theCase.present = scan;
    take->click();
    QCOMPARE(host_.theCase.opened->startPose.value().probeToWorld.matrix[3][0], 50.0);
    QVERIFY(!remark->isVisible());
    const std::size_t steps = host_.theCase.before.size();
    scan.volume.origin_mm = {500.0, 0.0, 0.0};  // the volume was moved away
    host_.theCase.present = scan;
    host_.theCase.tell();
    QVERIFY(remark->isVisible());
    QVERIFY(!child<QLabel>(panel, "start_pose")->text().isEmpty());
    const int saves = host_.theCase.saves;
    QTest::mouseClick(child<QPushButton>(panel, "save"), Qt::LeftButton);
    QCOMPARE(host_.theCase.saves, saves + 1);  // a remark forbids nothing
    child<QPushButton>(panel, "removeStartPose")->click();
    QVERIFY(!host_.theCase.opened->startPose);
    QVERIFY(!remark->isVisible());
    QCOMPARE(host_.theCase.before.size(), steps + 1);
    host_.theCase.undo();
    QVERIFY(host_.theCase.opened->startPose.has_value());
    host_.theCase.present.reset();
  }

  void probesMannequinAndWhatWasFoundBeforeAreEdited() {
    Case shown = caseCalled("One");
    shown.probes = {"linear-12"};
    shown.previousExaminations = {{"in May", "ultrasound", "a stone", {}, {{"by", 7}}}};
    host_.theCase.opened = shown;
    const auto panel = open(host_, "case_authoring");
    const Case& edited = *host_.theCase.opened;
    QVERIFY(child<QCheckBox>(panel, "probe_linear-12")->isChecked());
    child<QCheckBox>(panel, "probe_convex-3.5")->click();
    QVERIFY((edited.probes == std::vector<std::string>{"linear-12", "convex-3.5"}));  // the first stays the one at the start
    child<QComboBox>(panel, "mannequin")->setCurrentIndex(2);
    QCOMPARE(edited.mannequin, std::string("gravid.json"));
    QTest::keyClicks(child<QPlainTextEdit>(panel, "findings"), QStringLiteral("One stone."));
    QVERIFY(edited.findings == std::vector<std::string>{"One stone."});
    QTest::keyClicks(child<QLineEdit>(panel, "examination_0_when"), QStringLiteral(" 2020"));
    QCOMPARE(edited.previousExaminations[0].when, std::string("in May 2020"));
    QCOMPARE(edited.previousExaminations[0].otherFields["by"].get<int>(), 7);
    child<QPushButton>(panel, "addExamination")->click();
    QTest::keyClicks(child<QLineEdit>(panel, "examination_1_kind"), QStringLiteral("x-ray"));
    QCOMPARE(edited.previousExaminations[1].kind, std::string("x-ray"));
    child<QPushButton>(panel, "examination_0_remove")->click();
    QCOMPARE(edited.previousExaminations.size(), std::size_t(1));
    QTest::keyClicks(child<QLineEdit>(panel, "volume_licence"), QStringLiteral("CC BY 4.0"));
    QCOMPARE(edited.otherFields["volume"]["licence"].get<std::string>(), std::string("CC BY 4.0"));
    keepImage(panel, "case-lists.png");
  }

  void aCheckNamesProbesThatNobodyHasAndSaysWhenAllIsWell() {
    host_.theCase.opened = caseCalled("One");
    host_.theCase.opened->probes = {"nosuch", "linear-12"};
    const auto panel = open(host_, "case_authoring");
    child<QPushButton>(panel, "checkCase")->click();
    QVERIFY2(child<QLabel>(panel, "problem")->text().contains(QStringLiteral("nosuch")),
             qPrintable(child<QLabel>(panel, "problem")->text()));
    QVERIFY(!child<QLabel>(panel, "checked")->isVisible());
    child<QCheckBox>(panel, "probe_nosuch")->click();
    child<QPushButton>(panel, "checkCase")->click();
    QVERIFY(child<QLabel>(panel, "checked")->isVisible());
    QVERIFY(!child<QLabel>(panel, "problem")->isVisible());
  }

  void droppedVolumesAreListedWithWhatTheWholeWillTake() {
    const test::TemporaryFolder folder;
    Volume volume;
    volume.grid.dims = {30, 20, 10};
    volume.grid.spacing_mm = glm::dvec3(0.5);
    volume.echo.assign(6000, 90);
    QVERIFY(writeVolume(volume, folder / "right lobe.mha").has_value());
    volume.grid.origin_mm = {5, 0, 0};
    QVERIFY(writeVolume(volume, folder / "left lobe.mha").has_value());

    const auto panel = open(host_, "stitching");
    keepImage(panel, "stitch-empty.png");
    drop(panel, {QUrl::fromLocalFile(QString::fromStdString((folder / "right lobe.mha").string())),
                 QUrl::fromLocalFile(QString::fromStdString((folder / "left lobe.mha").string()))});
    QCOMPARE(child<QListWidget>(panel, "volumes")->count(), 2);
    QVERIFY2(child<QLabel>(panel, "forecast")->text().contains(QStringLiteral("40 × 20 × 10")),
             qPrintable(child<QLabel>(panel, "forecast")->text()));
    QVERIFY(!child<QPushButton>(panel, "saveResult")->isVisible());
    keepImage(panel, "stitch-two.png");
    // A name that another volume has is refused beside the list, and nothing changes.
    auto* list = child<QListWidget>(panel, "volumes");
    list->item(1)->setText(QStringLiteral("right lobe"));
    QVERIFY(child<QLabel>(panel, "problem")->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(list->item(1)->text(), QStringLiteral("left lobe"), 240000);
    list->setCurrentRow(1);
    QTest::keyClick(list, Qt::Key_Delete);
    QTest::keyClick(list, Qt::Key_Delete);
    QCOMPARE(list->count(), 0);
  }

  void aVolumeThatCannotBeReadIsASentenceInThePanel() {
    const test::TemporaryFolder folder;
    test::writeText(folder / "bad.mha", "no volume");
    test::writeText(folder / "bad.json", "{\"volumes\": 3}");
    const auto panel = open(host_, "stitching");
    for (const char* name : {"bad.mha", "bad.json"}) {
      drop(panel, {QUrl::fromLocalFile(QString::fromStdString((folder / name).string()))});
      QVERIFY(child<QLabel>(panel, "problem")->isVisible());
    }
    QCOMPARE(child<QListWidget>(panel, "volumes")->count(), 0);
  }
};

int main(int argc, char** argv) {
  const test::TemporaryFolder data;  // where a panel keeps what is not saved yet
  qputenv("XDG_DATA_HOME", QByteArray::fromStdString(data.path().string()));
  QApplication app(argc, argv);
  PanelsTest panels;
  return QTest::qExec(&panels, argc, argv);
}
#include "panels_gui_test.moc"
