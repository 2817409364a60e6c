// What is opened in place of something else: what gave way, what is given up, and what an edit of the volume loads.
#include <QAbstractItemView>
#include <QSignalSpy>
#include <thread>

#include "ew/core/responsive_thread.h"
#include "ew/library/case.h"
#include "ew/ui_test_door/body.h"
#include "ew/ui_test_door/import.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/cases_fixture.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::ui::testing {

class OpeningTest : public CasesFixture {
  Q_OBJECT

 private Q_SLOTS:
  void init() { showFirstCase(); }
  void cleanup() { window_.reset(); }

  void noCaseIsReadOnTheThreadOfTheWindow() {
    QVERIFY2(isResponsiveThread(), "what reads cases expects not to run here");
    bool isWorkersResponsive = true;
    std::thread([&] { isWorkersResponsive = isResponsiveThread(); }).join();
    QVERIFY(!isWorkersResponsive);
    window_.reset();
    QVERIFY(!isResponsiveThread());
    QVERIFY(loadCase(folder_.toStdString()).has_value());
  }

  void aCasesOwnBodyStaysWhenItComesBeforeTheUsualOne() {
    auto manifest = nlohmann::json::parse(textOf(folder_ + QStringLiteral("/case.json")));
    manifest["mannequin"] = "ball.json";  // which takes no time, in place of a second
    test::writeText((folder_ + QStringLiteral("/case.json")).toStdString(), manifest.dump());
    test::writeText((folder_ + QStringLiteral("/ball.json")).toStdString(),
                    R"({"format": 1, "name": "ball", "body": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [80, 80, 80]}}})");
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY(openCase(folder_));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
    const glm::dvec3 skin_mm = window_->view3d().skin()->nearest({0.0, -100.0, 0.0}).point_mm;
    QVERIFY2(glm::distance(skin_mm, glm::dvec3(0.0, -80.0, 0.0)) < 1.0, qPrintable(QString::number(skin_mm.y)));
    QVERIFY(glm::distance(session().probeControl().hold().contact.point_mm, glm::dvec3(0.0)) < 81.0);
  }

  void whatGaveWayComesBackWhenWhatWasChosenInItsPlaceIsRefused() {
    const QString second = writeCaseCalled(QStringLiteral("second"));
    const QString broken = writeCaseCalled(QStringLiteral("broken"));
    test::writeText((broken + QStringLiteral("/case.json")).toStdString(), "{\"format\": 1}");
    window_->open(second);
    window_->open(broken);
    QVERIFY(waitUntil([this] { return openTitle() == QLatin1String("second"); }, kOpening_ms));
    QVERIFY(waitForRest());
    QVERIFY(shows(QStringLiteral("second")));
    QVERIFY2(window_->messages().isError(), "why the other did not come is still said");
    window_->open(folder_);
    window_->open(second);
    QVERIFY(waitForRest());
    QCOMPARE(openTitle(), QStringLiteral("second"));
  }

  void whatGaveWayStaysAwayWhenWhatWasChosenInItsPlaceIsCancelled() {
    const QString second = writeCaseCalled(QStringLiteral("second")), third = writeCaseCalled(QStringLiteral("third"));
    window_->open(second);
    window_->open(third);
    for (const Jobs::Seen& job : window_->jobs().seen()) window_->jobs().cancel(job.id);
    QVERIFY(waitForRest());
    QVERIFY2(openTitle() == QLatin1String("first") || openTitle() == QLatin1String("third"), "a job may be done before it is cancelled");
    QVERIFY(shows(openTitle()));
  }

  void aCaseWhoseVolumeIsExchangedIsLoadedAgainAndUndoLoadsTheFormerOne() {
    Volume other;
    other.grid.dims = {30, 40, 50};
    other.grid.spacing_mm = glm::dvec3(3.0);
    other.grid.origin_mm = {-40.0, -110.0, -70.0};
    other.echo.assign(other.grid.voxelCount(), 77);
    QVERIFY(writeVolume(other, folder_.toStdString() + "/other.mha").has_value());
    const auto before = session().subject()->voxels.volume();
    Case changed = *document().current();
    changed.volume.file = "other.mha";
    changed.volume.fileToWorld.matrix[3][0] = 9.0;
    QVERIFY(document().edit(changed, "Take over a volume", "").has_value());
    editTitle("moved on");  // meanwhile
    QVERIFY(
        waitUntil([&] { return session().subject() && session().subject()->voxels.volume()->grid.dims == other.grid.dims; }, kOpening_ms));
    QVERIFY(waitForRest());
    QVERIFY(session().subject()->voxels.volume()->echo == other.echo);
    QCOMPARE(session().subject()->placedGrid.origin_mm.x, -31.0);
    QVERIFY(shows(QStringLiteral("moved on")));
    QVERIFY(session().subject()->scene.gainAndDgc);
    changed = *document().current();
    changed.volume.fileToWorld.matrix[3][0] = 4.0;
    QVERIFY(document().edit(changed, "Move the volume", "x").has_value());
    QCOMPARE(session().subject()->placedGrid.origin_mm.x, -36.0);
    while (document().history().canUndo()) document().undo();
    QVERIFY(waitUntil([&] { return session().subject() && session().subject()->voxels.volume()->echo == before->echo; }, kOpening_ms));
    QVERIFY(waitForRest());
    QVERIFY(shows(QStringLiteral("first")));
    QVERIFY(session().subject()->placedGrid == before->grid);
  }

  void anOpeningThatIsGivenUpForAnotherEndsSoThatPreparingGoesOn() {
    const QString unprepared = files_.path(QStringLiteral("unprepared %1").arg(made_));
    test::makeSmallCase(unprepared.toStdString());
    qputenv("ECHOWEAVE_CACHE", files_.path(QStringLiteral("cache %1").arg(made_)).toUtf8());
    auto* opener = window_->findChild<Opener*>();
    QVERIFY(opener != nullptr);
    const QString instead = files_.writeSweep(QStringLiteral("instead.igs.mha"));
    const QSignalSpy preparing(opener, &Opener::preparing), ended(opener, &Opener::ended), sweep(opener, &Opener::sweepChosen);
    int endedBefore = -1, endedAfter = -1;
    QObject whileItIsPrepared;
    connect(opener, &Opener::preparing, &whileItIsPrepared, [&] {
      endedBefore = ended.count();
      window_->open(instead);
      endedAfter = ended.count();
    });
    window_->open(unprepared);
    QCOMPARE(preparing.count(), 0);  // it is read by the job, not by the window
    QVERIFY(waitUntil([&] { return sweep.count() == 1; }, kOpening_ms));
    QCOMPARE(preparing.count(), 1);
    QCOMPARE(endedBefore, 0);
    QCOMPARE(endedAfter, 1);
    QCOMPARE(ended.count(), 2);
    QVERIFY(waitForRest());
  }

  void anOpeningThatIsGivenUpBeforeItsCaseIsReadTellsNothingOfIt() {
    const QString unprepared = files_.path(QStringLiteral("given up %1").arg(made_));
    test::makeSmallCase(unprepared.toStdString());
    qputenv("ECHOWEAVE_CACHE", files_.path(QStringLiteral("cache of given up %1").arg(made_)).toUtf8());
    auto* opener = window_->findChild<Opener*>();
    QVERIFY(opener != nullptr);
    const QString instead = files_.writeSweep(QStringLiteral("at once.igs.mha"));
    const QSignalSpy preparing(opener, &Opener::preparing), ended(opener, &Opener::ended), sweep(opener, &Opener::sweepChosen);
    window_->open(unprepared);
    window_->open(instead);
    QVERIFY(waitUntil([&] { return sweep.count() == 1; }, kOpening_ms));
    QVERIFY(waitForRest());
    QCOMPARE(preparing.count(), 0);
    QCOMPARE(ended.count(), 2);
  }

  void theStartPageIsFilledHoweverItIsReached() {
    window_ = std::make_unique<MainWindow>();
    window_->show();
    const QString wrong = files_.path(QStringLiteral("wrong at start.mha"));
    QVERIFY(writeFileSafely(wrong.toStdString(), "this is not a MetaImage\n").has_value());
    window_->open(wrong);
    QVERIFY(waitUntil([this] { return window_->messages().isError(); }, kOpening_ms));
    window_->setWorkspace(Workspace::explore);
    QVERIFY(find<StartPage>("startPage")->isVisible());
    QVERIFY(waitUntil([this] { return find<QAbstractItemView>("caseCards")->model()->rowCount() > 0; }));
    QVERIFY(waitForRest());
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::OpeningTest)
#include "opening_test.moc"
