// What the stitching panel must not lose, and must not say: unsaved work of several windows, files of others, verdicts that nobody proved.
#include <QCheckBox>
#include <QTabBar>

#include "gui/support/stitching_fixture.h"

namespace ew::ui::testing {

class StitchingCareTest : public StitchingFixture {
  Q_OBJECT

 private:
  [[nodiscard]] QString lineOf(int row) const { return find<QListWidget>("volumes")->item(row)->data(Qt::UserRole).toString(); }
  [[nodiscard]] QString signOfPair() const { return find<QLabel>("pairVerdict")->text(); }
  /// Clicks a button of a question that comes up while `act` runs. @return whether it was asked
  [[nodiscard]] bool answered(const char* question, const char* button, const std::function<void()>& act) const {
    bool asked = false;
    QTimer timer;
    connect(&timer, &QTimer::timeout, &timer, [&] {
      for (QWidget* each : QApplication::topLevelWidgets()) {
        auto* box = qobject_cast<QMessageBox*>(each);
        if (box == nullptr || !box->isVisible() || box->objectName() != QLatin1String(question)) continue;
        asked = true;
        auto* chosen = box->findChild<QPushButton*>(QLatin1String(button));
        QTest::mouseClick(chosen != nullptr ? chosen : static_cast<QPushButton*>(box->escapeButton()), Qt::LeftButton);
      }
    });
    timer.start(100);
    act();
    return asked;
  }
  void trigger(const char* action) const { window_->findChild<QAction*>(QLatin1String(action))->trigger(); }
  [[nodiscard]] static QString textOf(const QString& file) {
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? QString::fromUtf8(opened.readAll()) : QString();
  }

  /// A sweep whose frames say where the probe was, and not where the pixels lie on it.
  [[nodiscard]] QString writeUncalibrated(const QString& name) const {
    const Sequence sweep = test::evenSweep({40, 30, 24, "Probe", "Reference"}, [](int n, int p) { return 40 + (p * 7 + n * 13) % 150; });
    const QString file = files_.path(name);
    return writeSequence(sweep, file.toStdString()) ? file : QString();
  }

 private Q_SLOTS:
  void initTestCase() { cutPieces(); }
  void cleanup() { closeAndForget(); }

  void everyPanelIsReachedBesideTheStage() {
    openWindow(files_.writeCase(QStringLiteral("narrow case")));
    window_->resize(1366, 768);
    QTest::qWait(50);
    const QTabBar& bar = *tabs()->tabBar();
    const bool listsAll = tabs()->cornerWidget() != nullptr && tabs()->cornerWidget()->isVisible();
    for (int n = 0; n < bar.count(); ++n)
      if (bar.isTabVisible(n)) QVERIFY2(listsAll || bar.rect().contains(bar.tabRect(n)), qPrintable(bar.tabText(n)));
  }

  void aSecondSweepIsAddedWhileTheFirstIsRead() {
    openWindow(files_.writeCase(QStringLiteral("two sweeps case")));
    const Part a = writeSweep(QStringLiteral("first.igs.mha"), {36, 12, 40}, {48, 46, 36});
    const Part b = writeSweep(QStringLiteral("second.igs.mha"), {52, 16, 46}, {46, 46, 36});
    drop({a.file});
    drop({b.file});
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QCOMPARE(find<QListWidget>("volumes")->count(), 2);
  }

  void aSweepWithoutCalibrationStaysInTheListAndTakesOne() {
    openWindow(files_.writeCase(QStringLiteral("calibration case")));
    drop({writeUncalibrated(QStringLiteral("wires.igs.mha"))});
    QVERIFY(jobsEnd());
    QVERIFY2(problem().contains(QStringLiteral("device set")), qPrintable(problem()));
    QCOMPARE(find<QListWidget>("volumes")->count(), 1);
    QCOMPARE(lineOf(0), QStringLiteral("sweep, not yet a volume"));
    QVERIFY(find<QPushButton>("calibration")->isVisible());
    checkNoTextIsCut();
    keepImage("31-uncalibrated");
    const QString device = files_.path(QStringLiteral("device.xml"));
    QVERIFY(writeFileSafely(device.toStdString(),
                            "<PlusConfiguration><CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" "
                            "Matrix=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/></CoordinateDefinitions></PlusConfiguration>"));
    QMetaObject::invokeMethod(stitching(), "setCalibrationFile", Q_ARG(int, 0), Q_ARG(QString, device));
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY2(lineOf(0).contains(QStringLiteral("×")), qPrintable(lineOf(0)));
    QCOMPARE(project()["volumes"].toArray()[0].toObject()["calibration"].toString(), device);
    keepImage("32-calibrated");
  }

  void theChosenLineIsSeenAndTheButtonsBelowAreForIt() {
    openWindow(files_.writeCase(QStringLiteral("two sweeps case")));
    drop({writeUncalibrated(QStringLiteral("first.igs.mha")), writeUncalibrated(QStringLiteral("second.igs.mha"))});
    QVERIFY(jobsEnd());
    auto* list = find<QListWidget>("volumes");
    QCOMPARE(list->count(), 2);
    const auto edgeOf = [list](int row) {
      const QRect box = list->visualItemRect(list->item(row));
      return list->viewport()->grab().toImage().pixelColor(box.left() + 3, box.center().y());
    };
    for (const int row : {0, 1, 0}) {
      QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(list->item(row)).center());
      QTest::qWait(20);
      QCOMPARE(list->currentRow(), row);
      const QColor chosen = edgeOf(row), other = edgeOf(1 - row);
      const int apart =
          std::abs(chosen.red() - other.red()) + std::abs(chosen.green() - other.green()) + std::abs(chosen.blue() - other.blue());
      QVERIFY2(apart > 100, "a shade of the ground is seen by nobody");
    }
    QVERIFY(find<QPushButton>("calibration")->isVisible());
    const QString stays = list->item(1)->text();
    QTest::mouseClick(panel()->findChild<QPushButton*>(QStringLiteral("remove")), Qt::LeftButton);
    QTest::qWait(20);
    QCOMPARE(list->count(), 1);
    QCOMPARE(list->item(0)->text(), stays);
  }

  void aSweepOfWhichLittleIsKeptIsTakenOnceThatIsMeant() {
    openWindow(files_.writeCase(QStringLiteral("little case")));
    drop({writeUncalibrated(QStringLiteral("strip.igs.mha"))});
    QVERIFY(jobsEnd());
    QVERIFY(!find<QCheckBox>("acceptsSmall")->isVisible());
    const QString device = files_.path(QStringLiteral("strip.xml"));
    QVERIFY(writeFileSafely(device.toStdString(),
                            "<PlusConfiguration><CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" "
                            "Matrix=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/></CoordinateDefinitions>"
                            "<VolumeReconstruction ClipRectangleOrigin=\"4 0\" ClipRectangleSize=\"2 30\"/></PlusConfiguration>"));
    QMetaObject::invokeMethod(stitching(), "setCalibrationFile", Q_ARG(int, 0), Q_ARG(QString, device));
    QVERIFY(jobsEnd());
    QVERIFY2(problem().startsWith(QStringLiteral("Only 7.5 % of the pixels")), qPrintable(problem()));
    QVERIFY2(!problem().contains(QStringLiteral("accept_small")), qPrintable(problem()));
    QCOMPARE(lineOf(0), QStringLiteral("sweep, not yet a volume"));
    QVERIFY(find<QCheckBox>("acceptsSmall")->isVisible());
    checkNoTextIsCut();
    keepImage("34-little");
    QTest::mouseClick(find<QCheckBox>("acceptsSmall"), Qt::LeftButton, {}, QPoint(8, find<QCheckBox>("acceptsSmall")->height() / 2));
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY2(lineOf(0).contains(QStringLiteral("×")), qPrintable(lineOf(0)));
    QCOMPARE(project()["volumes"].toArray()[0].toObject()["accept_small"].toBool(), true);
    QVERIFY2(find<QCheckBox>("acceptsSmall")->isVisible(), "it can be taken back");
  }

  void whatAHandPlacedIsNotSaidToBeProvedAndMatchingAllMatchesIt() {
    openWindow(files_.writeCase(QStringLiteral("hand case")));
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    click("matchAll");
    QVERIFY(jobsEnd());
    QCOMPARE(signOfPair(), QStringLiteral("aligned"));
    view("fixedView")->setFocus();
    for (int n = 0; n < 3; ++n) QTest::keyClick(view("fixedView"), Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(error_mm(0, 1) > 5.0);
    QCOMPARE(signOfPair(), QStringLiteral("manual, not checked"));
    click("elastic");
    QVERIFY(jobsEnd());
    QCOMPARE(signOfPair(), QStringLiteral("manual, not checked"));
    QCOMPARE(find<QLabel>("pairWord")->text(), QStringLiteral("1 of 1 pairs need review"));
    keepImage("33-by-hand");
    clickInspector("acceptPair");
    QCOMPARE(signOfPair(), QStringLiteral("manual, accepted"));
    // What was accepted stays, and that is said; what was not is matched.
    click("matchAll");
    QVERIFY(jobsEnd());
    QVERIFY(error_mm(0, 1) > 5.0);
    QVERIFY2(find<QLabel>("outcome")->text().contains(QStringLiteral("A to B")), qPrintable(find<QLabel>("outcome")->text()));
    clickInspector("acceptPair");
    click("matchAll");
    QVERIFY(jobsEnd());
    QCOMPARE(signOfPair(), QStringLiteral("aligned"));
    QVERIFY2(error_mm(0, 1) < 1.0, qPrintable(QString::number(error_mm(0, 1))));
    // Landmarks have a sign of their own.
    clickInspector("pickLandmarks");
    for (const QPoint& off : {QPoint(-30, -20), QPoint(35, -15), QPoint(5, 40), QPoint(-15, 30)}) {
      const QPoint at = view("fixedView")->rect().center() + off;
      QTest::mouseClick(view("fixedView"), Qt::LeftButton, Qt::NoModifier, at);
      QTest::mouseClick(view("movingView"), Qt::LeftButton, Qt::NoModifier, at);
      QTest::keyClick(view("fixedView"), Qt::Key_Period, Qt::ShiftModifier);
    }
    QTest::keyClick(view("fixedView"), Qt::Key_P);
    clickInspector("useLandmarks");
    QVERIFY(jobsEnd());
    QCOMPARE(signOfPair(), QStringLiteral("by landmarks"));
    const QString reason = find<QLabel>("pairReason")->text();
    QVERIFY2(reason.contains(QStringLiteral("agree within")) && reason.contains(QStringLiteral("to be expected")), qPrintable(reason));
    checkNoTextIsCut();
    keepImage("34-by-landmarks");
    window_->setDarkTheme(false);
    keepImage("35-by-landmarks-light");
    window_->setDarkTheme(true);
  }

  void keysOfTheConsoleDoNothingBehindTheStage() {
    openWindow(files_.writeCase(QStringLiteral("keys case")));
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    const auto knobs = window_->session().console().knobs();
    find<QPushButton>("matchAll")->setFocus();
    for (const Qt::Key key : {Qt::Key_G, Qt::Key_M, Qt::Key_R, Qt::Key_X, Qt::Key_2}) {
      QTest::keyClick(find<QPushButton>("matchAll"), key);
      QVERIFY2(window_->session().console().knobs() == knobs, qPrintable(QKeySequence(key).toString()));
    }
    window_->setWorkspace(Workspace::explore);
    QTest::keyClick(window_.get(), Qt::Key_G);
    QVERIFY2(!(window_->session().console().knobs() == knobs), "the scan is seen again");
  }

  void whatIsLeftUnsavedStaysUntilSomebodyDecides() {
    const QString folder = files_.writeCase(QStringLiteral("left case"));
    openWindow(folder);
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    const QJsonObject first = project();
    window_.reset();
    // Somebody works on something else, and saves that.
    openWindow(folder);
    QVERIFY(view("recoveryOffer")->isVisible());
    const QString other = files_.path(QStringLiteral("other project.json"));
    QVERIFY(writeFileSafely(other.toStdString(), "{\"format\": 2, \"volumes\": [{\"file\": \"" + parts_[2].file.toStdString() + "\"}]}"));
    QVERIFY(ask<bool>(stitching(), "openProjectFile", Q_ARG(QString, other)));
    QVERIFY(jobsEnd());
    QVERIFY(ask<bool>(stitching(), "saveProjectAs", Q_ARG(QString, other)));
    drop({parts_[0].file});
    QVERIFY(jobsEnd());
    const QJsonObject second = project();
    window_.reset();
    // Both are offered, the latest first.
    openWindow(folder);
    QVERIFY(view("recoveryOffer")->isVisible());
    checkNoTextIsCut();
    keepImage("36-two-offers");
    click("reopenLeft");
    QVERIFY(jobsEnd());
    QVERIFY(project() == second);
    QVERIFY(ask<bool>(stitching(), "saveProjectAs", Q_ARG(QString, other)));
    window_.reset();
    openWindow(folder);
    click("reopenLeft");
    QVERIFY(jobsEnd());
    QVERIFY(project() == first);
    QVERIFY(ask<bool>(stitching(), "saveProjectAs", Q_ARG(QString, other)));
    window_.reset();
    openWindow(folder);
    QVERIFY2(view("recoveryOffer")->isHidden(), "everything was decided");
  }

  void whatAnotherWindowKeepsIsNotOfferedAndNotWrittenOver() {
    const QString folder = files_.writeCase(QStringLiteral("two windows case"));
    openWindow(folder);
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    QTest::qWait(1500);  // it keeps what is unsaved
    const QJsonObject first = project();
    std::unique_ptr<MainWindow> other = std::move(window_);
    openWindow(folder);
    QVERIFY2(view("recoveryOffer")->isHidden(), "its window is at work on it");
    drop({parts_[2].file});
    QVERIFY(jobsEnd());
    window_.reset();
    other.reset();
    openWindow(folder);
    click("discardLeft");
    QVERIFY(view("recoveryOffer")->isVisible());
    click("reopenLeft");
    QVERIFY(jobsEnd());
    const bool isFirst = project() == first;
    QVERIFY2(isFirst || project()["volumes"].toArray().size() == 1, "one of both, whole");
  }

  void aProjectThatAnotherProgramWroteIsNotWrittenOverUnasked() {
    openWindow(files_.writeCase(QStringLiteral("disk case")));
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    const QString file = files_.path(QStringLiteral("shared project.json"));
    QVERIFY(ask<bool>(stitching(), "saveProjectAs", Q_ARG(QString, file)));
    const QString others = QStringLiteral("{\"format\": 2, \"volumes\": [{\"name\": \"theirs\", \"file\": \"%1\"}]}").arg(parts_[2].file);
    QVERIFY(writeFileSafely(file.toStdString(), others.toStdString()));
    QTest::keyClick(view("fixedView"), Qt::Key_Right);
    QVERIFY(answered("changedOnDiskQuestion", "nobody", [this] { trigger("saveProject"); }));
    QCOMPARE(textOf(file), others);
    QVERIFY(answered("changedOnDiskQuestion", "overwriteProject", [this] { trigger("saveProject"); }));
    QVERIFY(textOf(file) != others);
    QTest::keyClick(view("fixedView"), Qt::Key_Right);
    QVERIFY2(!answered("changedOnDiskQuestion", "nobody", [this] { trigger("saveProject"); }), "it is this window's own file again");
    QVERIFY(writeFileSafely(file.toStdString(), others.toStdString()));
    QTest::keyClick(view("fixedView"), Qt::Key_Right);
    QVERIFY(answered("changedOnDiskQuestion", "reloadProject", [this] { trigger("saveProject"); }));
    QVERIFY(jobsEnd());
    QCOMPARE(project()["volumes"].toArray()[0].toObject()["name"].toString(), QStringLiteral("theirs"));
    QCOMPARE(textOf(file), others);
  }

  void savingAVolumeAsksBeforeItReplacesWhatSomebodyElseMade() {
    openWindow(files_.writeCase(QStringLiteral("replace case")));
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    QCOMPARE(find<QPushButton>("handToCase")->isVisible(), false);
    click("seams");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    const QString folder = files_.path(QStringLiteral("results"));
    QDir().mkpath(folder);
    const QString mine = folder + QStringLiteral("/source.mha");
    QVERIFY(writeFileSafely(mine.toStdString(), "my only copy"));
    const auto save = [&] {
      QMetaObject::invokeMethod(stitching(), "saveResultIn", Q_ARG(QString, folder));
      QVERIFY(jobsEnd());
    };
    QVERIFY(answered("replaceQuestion", "nobody", save));
    QCOMPARE(textOf(mine), QStringLiteral("my only copy"));
    QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden).size(), 1);
    QVERIFY(answered("replaceQuestion", "replaceFiles", save));
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden).size(), 5);
    QVERIFY2(!answered("replaceQuestion", "nobody", save), "what was saved there by the program is no question");
    // A project begun anew has none of the errors of the one before.
    drop({files_.path(QStringLiteral("nothing there.mha"))});
    QVERIFY(jobsEnd());
    QVERIFY(!problem().isEmpty());
    QVERIFY(ask<bool>(stitching(), "saveProjectAs", Q_ARG(QString, files_.path(QStringLiteral("done.json")))));
    drop({files_.path(QStringLiteral("nothing there.mha"))});
    QVERIFY(jobsEnd());
    trigger("newProject");
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
  }
};

}  // namespace ew::ui::testing

EW_STITCHING_TEST_MAIN(ew::ui::testing::StitchingCareTest)
#include "stitching_care_test.moc"
