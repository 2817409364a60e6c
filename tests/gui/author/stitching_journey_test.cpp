// From three subvolumes without places to a case: the way an author goes through the stitching panel, with the hand and the keys alone.
#include "gui/support/stitching_fixture.h"

namespace ew::ui::testing {

class StitchingJourneyTest : public StitchingFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { cutPieces(); }
  void cleanup() { closeAndForget(); }

  void fromThreeSubvolumesToACase() {
    const QString folder = files_.writeCase(QStringLiteral("journey case"));
    openWindow(folder);
    keepImage("1-empty");

    drop({parts_[0].file, parts_[1].file, parts_[2].file});
    QVERIFY(jobsEnd());
    QCOMPARE(find<QListWidget>("volumes")->count(), 3);
    keepImage("2-dropped");

    // Without a tracker.
    click("matchAll");
    QTest::qWait(700);
    keepImage("3-matching");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    checkNoTextIsCut();
    keepImage("4-matched");
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      QVERIFY2(verdict(a, b) == QLatin1String("aligned"), qPrintable(QStringLiteral("%1 %2: %3").arg(a).arg(b).arg(verdict(a, b))));
      QMetaObject::invokeMethod(stitching(), "chooseThePair", Q_ARG(int, a), Q_ARG(int, b));
      QVERIFY2(error_mm(a, b) < 1.0, qPrintable(QString::number(error_mm(a, b))));
    }

    // One is corrected by landmarks: places that both show, clicked in both.
    const QPointF edge = ask<QPointF>(view("pairGraph"), "middleOfPair", Q_ARG(int, 0), Q_ARG(int, 1));
    QTest::mouseClick(view("pairGraph"), Qt::LeftButton, Qt::NoModifier, edge.toPoint());
    QCOMPARE(find<QLabel>("pairTitle")->text(), QStringLiteral("Pair A to B"));
    clickInspector("pickLandmarks");
    for (const QPoint& off : {QPoint(-30, -20), QPoint(35, -15), QPoint(5, 40), QPoint(-15, 30)}) {
      const QPoint at = view("fixedView")->rect().center() + off;
      QTest::mouseClick(view("fixedView"), Qt::LeftButton, Qt::NoModifier, at);
      QTest::mouseClick(view("movingView"), Qt::LeftButton, Qt::NoModifier, at);
      QTest::keyClick(view("fixedView"), Qt::Key_Period, Qt::ShiftModifier);  // not all in one plane
    }
    QTest::keyClick(view("fixedView"), Qt::Key_P);
    QCOMPARE(find<QTableWidget>("landmarks")->rowCount(), 4);
    keepImage("5-landmarks");
    clickInspector("useLandmarks");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY2(verdict(0, 1) == QLatin1String("aligned"), qPrintable(verdict(0, 1)));
    QVERIFY2(error_mm(0, 1) < 1.5, qPrintable(QString::number(error_mm(0, 1))));

    click("elastic");
    QTest::qWait(600);
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY(ask<bool>(stitching(), "isElasticFound"));
    choose("fourthChoice", 1);
    keepImage("6-elastic");

    // One is rejected, and then matched again with other settings.
    QMetaObject::invokeMethod(stitching(), "chooseThePair", Q_ARG(int, 0), Q_ARG(int, 2));
    clickInspector("rejectPair");
    QVERIFY(ask<QString>(stitching(), "projectAsText").contains(QLatin1String("rejected")));
    keepImage("7-rejected");
    choose("pairMethod", 1);
    find<QDoubleSpinBox>("maxTurn")->setValue(15.0);
    clickInspector("redoPair");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY(!ask<QString>(stitching(), "projectAsText").contains(QLatin1String("rejected")));
    QVERIFY2(verdict(0, 2) == QLatin1String("aligned"), qPrintable(verdict(0, 2)));

    click("seams");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY(ask<int>(stitching(), "nodesOfResult") > 0);
    choose("fourthChoice", 2);
    keepImage("8-seam");

    // The seam is edited: two strokes, each a step; both are taken back and one is made again.
    click("paintSeam");
    const QPoint middle = view("fourthView")->rect().center();
    QTest::mouseClick(view("fourthView"), Qt::LeftButton, Qt::NoModifier, middle);
    QTest::mouseClick(view("fourthView"), Qt::LeftButton, Qt::NoModifier, middle + QPoint(40, 10));
    QCOMPARE(strokes(), 2);
    keepImage("9-painted");
    const QJsonObject painted = project();
    QTest::keyClick(view("fourthView"), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(view("fourthView"), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(strokes(), 0);
    QTest::keyClick(view("fourthView"), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::keyClick(view("fourthView"), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(project() == painted);
    click("seams");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    choose("fourthChoice", 3);
    choose("overlayKind", 3);
    keepImage("10-result");

    // Saved, closed, opened again.
    const QString file = files_.path(QStringLiteral("abdomen.json"));
    QVERIFY(ask<bool>(stitching(), "saveProjectAs", Q_ARG(QString, file)));
    window_.reset();
    openWindow(folder);
    QVERIFY(!view("recoveryOffer")->isVisible());
    QVERIFY(ask<bool>(stitching(), "openProjectFile", Q_ARG(QString, file)));
    QVERIFY(jobsEnd());
    QVERIFY(project() == painted);
    // What was found before is there again, without a run that anybody asked for.
    QCOMPARE(verdict(0, 1), QStringLiteral("aligned"));
    QCOMPARE(ask<QString>(stitching(), "effortOfWarp"), QStringLiteral("balanced"));
    QVERIFY(ask<int>(stitching(), "nodesOfResult") > 0);
    QVERIFY(!view("resultIsOld")->isVisible());
    click("seams");  // and nothing is left to do
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY(ask<int>(stitching(), "nodesOfResult") > 0);

    click("handToCase");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QCOMPARE(QString::fromStdString(window_->document().current()->volume.file), QStringLiteral("volumes/stitched.mha"));
    QVERIFY(QFileInfo::exists(folder + QStringLiteral("/volumes/stitched.mha")));
    QVERIFY(!window_->document().hasUnsavedChanges());
    for (const char* ending : {"-coverage.mha", "-source.mha", "-level.mha", "-provenance.json"})
      QVERIFY2(QFileInfo::exists(folder + QStringLiteral("/volumes/stitched") + QLatin1String(ending)), ending);
    // What is scanned from now on is this volume, as the case's own.
    const auto stitched = readVolume((folder + QStringLiteral("/volumes/stitched.mha")).toStdString());
    QVERIFY(stitched.has_value());
    const auto scansIt = [&] {
      const auto& subject = session().subject();
      return subject && subject->voxels.volume() && subject->voxels.volume()->echo == stitched->volume.echo;
    };
    QTRY_VERIFY_WITH_TIMEOUT(scansIt(), 60000);
    window_->setWorkspace(Workspace::explore);
    const std::uint64_t frames = session().frames().framesMade();
    session().probeControl().setHold(session().probeControl().hold());
    QTRY_VERIFY_WITH_TIMEOUT(session().frames().framesMade() > frames, 60000);
    window_->setWorkspace(Workspace::author);
    keepImage("11-in-the-case");
  }

  void nudgesAreOneStepAndUndoIsTheProjectsOwn() {
    openWindow(files_.writeCase(QStringLiteral("nudge case")));
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    const QJsonObject before = project();
    view("fixedView")->setFocus();
    for (int n = 0; n < 4; ++n) QTest::keyClick(view("fixedView"), Qt::Key_Right);
    QVERIFY2(find<QLabel>("lastEdit")->text().contains(QStringLiteral("nudge B by 2 mm")), qPrintable(find<QLabel>("lastEdit")->text()));
    QTest::keyClick(view("fixedView"), Qt::Key_E);
    QVERIFY2(find<QLabel>("lastEdit")->text().contains(QStringLiteral("rotate B by 1°")), qPrintable(find<QLabel>("lastEdit")->text()));
    QVERIFY(!window_->document().hasUnsavedChanges());
    QTest::keyClick(view("fixedView"), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(view("fixedView"), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(project() == before);
    // A box is dragged: 40 pixels are one step, and the other box stays.
    auto* placement = view("placementView");
    const QPoint at = ask<QPointF>(placement, "pixelOfPoint", Q_ARG(double, 46.0), Q_ARG(double, 46.0), Q_ARG(double, 40.0)).toPoint();
    QTest::mousePress(placement, Qt::LeftButton, Qt::NoModifier, at);
    for (int n = 1; n <= 8; ++n) {
      QMouseEvent move(QEvent::MouseMove, at + QPoint(5 * n, 0), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(placement, &move);
    }
    QTest::mouseRelease(placement, Qt::LeftButton, Qt::NoModifier, at + QPoint(40, 0));
    QVERIFY2(find<QLabel>("lastEdit")->text().contains(QStringLiteral("move ")), qPrintable(find<QLabel>("lastEdit")->text()));
    QTest::keyClick(view("fixedView"), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(project() == before);
    keepImage("12-two");
    window_->resize(1920, 1080);
    QTest::qWait(100);
    keepImage("13-large");
    window_->resize(3840, 2160);
    QTest::qWait(100);
    keepImage("13-largest");
    window_->resize(1920, 1080);
    QTest::qWait(100);
    window_->setDarkTheme(false);
    keepImage("14-light");
    window_->setDarkTheme(true);
    QTest::keyClick(view("fixedView"), Qt::Key_F1);
    keepImage("15-keys");
  }

  void sweepsAreReconstructedAndMatchedLikeVolumes() {
    openWindow(files_.writeCase(QStringLiteral("sweep case")));
    const Part a = writeSweep(QStringLiteral("left.igs.mha"), {36, 12, 40}, {48, 46, 36});
    const Part b = writeSweep(QStringLiteral("right.igs.mha"), {52, 16, 46}, {46, 46, 36});
    drop({a.file, b.file});
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QCOMPARE(find<QListWidget>("volumes")->count(), 2);
    click("matchAll");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY2(verdict(0, 1) == QLatin1String("aligned"), qPrintable(find<QLabel>("pairReason")->text()));
    // What was reconstructed for reading is not reconstructed again for matching: both folders have the same files.
    namespace fs = std::filesystem;
    const fs::path made = fs::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) / "stitching" /
                          "work" / "untitled-1" / "steps" / "reconstruct";
    int volumes = 0;
    for (const auto& file : fs::directory_iterator(made)) {
      if (file.path().filename().string().find("-volume.mha") == std::string::npos) continue;
      ++volumes;
      QCOMPARE(static_cast<int>(fs::hard_link_count(file)), 2);
    }
    QCOMPARE(volumes, 2);
    // A reconstructed sweep keeps the tracker's coordinates, which here are those of the piece.
    QVERIFY2(errorBetween_mm(a, b) < 1.0, qPrintable(QString::number(errorBetween_mm(a, b))));
    checkNoTextIsCut();
    keepImage("18-sweeps");
  }

  void aJobIsCancelledFromItsCardAndLeavesEverythingAsItWas() {
    openWindow(files_.writeCase(QStringLiteral("cancel case")));
    drop({parts_[0].file, parts_[1].file, parts_[2].file});
    QVERIFY(jobsEnd());
    click("matchAll");
    const QJsonObject asked = project();
    QVERIFY(!find<QPushButton>("elastic")->isEnabled());
    QVERIFY(waitUntil([this] {
      const auto* cancel = find<QPushButton>("cancelJob");
      return cancel != nullptr && cancel->isVisible();
    }));
    keepImage("19-job-card");
    click("cancelJob");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QVERIFY(project() == asked);
    QVERIFY(find<QPushButton>("elastic")->isEnabled());
    click("matchAll");  // takes up what was finished
    QVERIFY(jobsEnd());
    QCOMPARE(verdict(0, 1), QStringLiteral("aligned"));
    QCOMPARE(verdict(1, 2), QStringLiteral("aligned"));
  }

  void theListIsPutIntoAnotherOrderAndWhatWasFoundStays() {
    openWindow(files_.writeCase(QStringLiteral("order case")));
    drop({parts_[0].file, parts_[1].file, parts_[2].file});
    QVERIFY(jobsEnd());
    click("matchAll");
    QVERIFY(jobsEnd());
    const QJsonObject before = project();
    auto* list = find<QListWidget>("volumes");
    list->setCurrentRow(2);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(list->item(1)->text(), QStringLiteral("midline"));
    QCOMPARE(list->currentRow(), 1);
    QVERIFY2(find<QLabel>("lastEdit")->text().contains(QStringLiteral("move C")), qPrintable(find<QLabel>("lastEdit")->text()));
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
      QVERIFY2(verdict(a, b) == QLatin1String("aligned"), qPrintable(QStringLiteral("%1 %2: %3").arg(a).arg(b).arg(verdict(a, b))));
    QMetaObject::invokeMethod(stitching(), "chooseThePair", Q_ARG(int, 1), Q_ARG(int, 2));
    QVERIFY2(errorBetween_mm(parts_[2], parts_[1]) < 1.0, qPrintable(QString::number(errorBetween_mm(parts_[2], parts_[1]))));
    // The hand that drags a row does the same.
    QVERIFY(list->model()->moveRow({}, 2, {}, 0));
    QVERIFY(waitUntil(
        [&] { return project()["volumes"].toArray()[0].toObject()["name"].toString().startsWith(QLatin1String("right oblique")); }));
    QCOMPARE(list->item(0)->text(), QStringLiteral("right oblique with a rather long name"));
    QTest::keyClick(view("fixedView"), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(view("fixedView"), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(project() == before);
    QCOMPARE(list->item(2)->text(), QStringLiteral("midline"));
  }

  /// Two pieces of which one was pressed: a rigid pose cannot bring them together, and the warp does. On the way one pair is warped with
  /// another effort, and a stroke is drawn along the seam.
  void piecesThatWerePressedAreWarpedTogether() {
    openWindow(files_.writeCase(QStringLiteral("bent case")));
    const Part a = writePart(QStringLiteral("at rest.mha"), {36, 12, 40}, {50, 48, 44});
    const Part b = writeWarpedPart(QStringLiteral("pressed.mha"), {48, 14, 44}, {50, 48, 44});
    drop({a.file, b.file});
    QVERIFY(jobsEnd());
    QVERIFY2(find<QLabel>("expectedCost")->text().contains(QStringLiteral("mm in")), qPrintable(find<QLabel>("expectedCost")->text()));
    QCOMPARE(find<QLabel>("measuredCost")->text(), QStringLiteral("-"));
    click("matchAll");
    QVERIFY(jobsEnd());
    QVERIFY2(verdict(0, 1) == QLatin1String("aligned"), qPrintable(find<QLabel>("pairReason")->text()));
    const auto errors = [&](bool warped) {
      std::vector<double> lengths;
      for (double x = 34.0; x <= 90.0; x += 14.0)
        for (double y = 16.0; y <= 80.0; y += 16.0)
          for (double z = 18.0; z <= 78.0; z += 15.0) {
            const auto mates =
                ask<QList<double>>(stitching(), "matesAt", Q_ARG(double, x), Q_ARG(double, y), Q_ARG(double, z), Q_ARG(bool, warped));
            // What the moving volume shows at m lay in the patient at q + push(q).
            const glm::dvec3 q = glm::dvec3(mates[3], mates[4], mates[5]) + b.at_mm;
            lengths.push_back(glm::length(q + push(q) - (glm::dvec3(mates[0], mates[1], mates[2]) + a.at_mm)));
          }
      std::sort(lengths.begin(), lengths.end());
      return lengths[lengths.size() / 2];
    };
    const double rigid_mm = errors(false);
    choose("pairEffort", 0);
    QCOMPARE(project()["pairs"].toArray()[0].toObject()["effort"].toString(), QStringLiteral("fast"));
    const QString fast = find<QLabel>("expectedCost")->text();
    click("elastic");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QCOMPARE(ask<QString>(stitching(), "effortOfWarp"), QStringLiteral("fast"));
    QVERIFY2(find<QLabel>("measuredCost")->text().endsWith(QLatin1String(" s")), qPrintable(find<QLabel>("measuredCost")->text()));
    const double fast_mm = errors(true);
    QVERIFY2(rigid_mm > 1.2, qPrintable(QString::number(rigid_mm)));
    QVERIFY2(fast_mm < 0.5 * rigid_mm, qPrintable(QStringLiteral("%1 to %2 mm").arg(rigid_mm).arg(fast_mm)));
    QVERIFY(ask<double>(stitching(), "largestWarp_mm") > 1.0);

    // The same pair with another effort: chosen in the curve, and warped again.
    QVERIFY(!find<QPushButton>("bendAgain")->isEnabled());
    auto* curve = view("costChart");
    for (QWidget* above = curve->parentWidget(); above != nullptr; above = above->parentWidget())
      if (auto* scroll = qobject_cast<QScrollArea*>(above)) scroll->ensureWidgetVisible(curve);
    QTest::mouseClick(curve, Qt::LeftButton, Qt::NoModifier, ask<QPointF>(curve, "pointOfEffort", Q_ARG(int, 2)).toPoint());
    QCOMPARE(project()["pairs"].toArray()[0].toObject()["effort"].toString(), QStringLiteral("accurate"));
    QVERIFY(find<QLabel>("expectedCost")->text() != fast);
    QVERIFY2(find<QLabel>("measuredCost")->text().contains(QStringLiteral("fast")), qPrintable(find<QLabel>("measuredCost")->text()));
    keepImage("20-effort-changed");
    clickInspector("bendAgain");
    QVERIFY(jobsEnd());
    QCOMPARE(ask<QString>(stitching(), "effortOfWarp"), QStringLiteral("accurate"));
    const double accurate_mm = errors(true);
    QVERIFY2(accurate_mm < 0.5 * rigid_mm, qPrintable(QStringLiteral("%1 to %2 mm").arg(rigid_mm).arg(accurate_mm)));
    choose("fourthChoice", 1);
    checkNoTextIsCut();
    keepImage("21-bent");

    // A stroke that is drawn, not clicked: many dabs, one step.
    click("seams");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    choose("fourthChoice", 2);
    click("paintSeam");
    auto* seam = view("fourthView");
    const QPoint from = seam->rect().center() - QPoint(60, 20);
    QTest::mousePress(seam, Qt::LeftButton, Qt::NoModifier, from);
    for (int n = 1; n <= 12; ++n) {
      const QPoint at = from + QPoint(8 * n, 3 * n);
      QMouseEvent move(QEvent::MouseMove, at, seam->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(seam, &move);
    }
    QTest::mouseRelease(seam, Qt::LeftButton, Qt::NoModifier, from + QPoint(96, 36));
    QVERIFY2(strokes() >= 4, qPrintable(QString::number(strokes())));
    QVERIFY(view("resultIsOld")->isVisible());
    keepImage("22-drawn");
    click("seams");
    QVERIFY(jobsEnd());
    QVERIFY(!view("resultIsOld")->isVisible());
    QTest::keyClick(seam, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(strokes(), 0);
  }

  void whatIsNoVolumeIsASentenceAndNoLine() {
    openWindow(files_.writeCase(QStringLiteral("bad case")));
    const QString bad = files_.path(QStringLiteral("bad.mha"));
    QVERIFY(writeFileSafely(bad.toStdString(), "no volume"));
    drop({bad, parts_[0].file});
    QVERIFY(jobsEnd());
    QCOMPARE(find<QListWidget>("volumes")->count(), 1);
    QVERIFY2(problem().contains(QStringLiteral("bad.mha")), qPrintable(problem()));
    keepImage("16-problem");
    // Of several the first is explained and the others are counted.
    const QString worse = files_.path(QStringLiteral("worse.mha"));
    QVERIFY(writeFileSafely(worse.toStdString(), "no volume either"));
    drop({bad, worse});
    QVERIFY(jobsEnd());
    QVERIFY2(problem().contains(QStringLiteral("bad.mha")) && problem().contains(QStringLiteral("1 more")), qPrintable(problem()));
  }

  /// Work of others runs while the panel is used: it is told of in the status line, which covers nothing.
  void runningWorkCoversNothingOfThePanel() {
    openWindow(files_.writeCase(QStringLiteral("covered case")));
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    const auto idle = [](Progress& progress) -> Result<void> {
      while (!progress.cancelRequested()) QThread::msleep(10);
      return {};
    };
    window_->jobs().start(QStringLiteral("Something else"), idle, {}, Jobs::Kind::background);
    window_->jobs().start(QStringLiteral("And something more"), idle, {}, Jobs::Kind::background);
    auto* line = find<QWidget>("jobsLine");
    QVERIFY(waitUntil([&] { return line->isVisible() && find<QPushButton>("moreJobs")->isVisible(); }));
    const QString bad = files_.path(QStringLiteral("covered.mha"));
    QVERIFY(writeFileSafely(bad.toStdString(), "no volume"));
    drop({bad});
    QVERIFY(waitUntil([this] { return !problem().isEmpty(); }));
    QTest::qWait(100);
    keepImage("28-cards");
    const auto onScreen = [](const QWidget* widget) { return QRect(widget->mapToGlobal(QPoint(0, 0)), widget->size()); };
    QScrollArea* scroll = nullptr;
    for (QWidget* above = panel(); above != nullptr && scroll == nullptr; above = above->parentWidget())
      scroll = qobject_cast<QScrollArea*>(above->parentWidget());
    QVERIFY(scroll != nullptr);
    const QRect seen = onScreen(scroll->viewport());
    QVERIFY2(!seen.intersects(onScreen(line)), "the running work lies on the panel");
    const auto* sentence = panel()->findChild<QLabel*>(QStringLiteral("problem"));
    QVERIFY2(seen.contains(onScreen(sentence)), "the sentence about what went wrong is not seen");
    window_->jobs().cancelAllAndWait();
    QVERIFY(waitUntil([&] { return !line->isVisible(); }));
    QCOMPARE(onScreen(scroll->viewport()), seen);
  }

  /// One button leads on; what comes of it is shown; the keyboard stays where it was.
  void theNextStepLeadsAndItsResultIsShown() {
    openWindow(files_.writeCase(QStringLiteral("lead case")));
    const auto leads = [this](const char* name) { return find<QPushButton>(name)->property("primary").toBool(); };
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    QVERIFY2(leads("refine") && !leads("matchAll") && !leads("seams"), "places are recorded");
    find<QPushButton>("matchAll")->setFocus();
    click("matchAll");
    QCOMPARE(QApplication::focusWidget(), panel());  // the button is off; whatever is next in the window must not take the keys
    QVERIFY(jobsEnd());
    QCOMPARE(QApplication::focusWidget(), find<QPushButton>("matchAll"));
    QVERIFY2(leads("seams") && !leads("matchAll") && !leads("refine"), "the places are found");
    click("seams");
    QVERIFY(jobsEnd());
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QCOMPARE(find<QComboBox>("fourthChoice")->currentData().toInt(), 3);
    QVERIFY(leads("handToCase") && !leads("seams"));
    // What came later was not matched, and nobody says that all is well.
    drop({parts_[2].file});
    QVERIFY(jobsEnd());
    QCOMPARE(find<QLabel>("pairWord")->text(), QStringLiteral("2 of 3 pairs not matched"));
    QVERIFY(leads("matchAll") && !leads("handToCase"));
    // The row that takes the place of one that went is chosen as one sees.
    auto* list = find<QListWidget>("volumes");
    list->setCurrentRow(2);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Delete);
    QCOMPARE(list->currentRow(), 1);
    QVERIFY(list->item(1)->isSelected());
  }

  /// A project that was not saved is not thrown away by beginning another one.
  void anUnsavedProjectIsAskedAbout() {
    openWindow(files_.writeCase(QStringLiteral("asked case")));
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    int asked = 0;
    const auto beginAnew = [&](QMessageBox::StandardButton answer) {
      QTimer::singleShot(200, window_.get(), [&asked, answer, this] {
        auto* question = window_->findChild<QMessageBox*>(QStringLiteral("unsavedProjectQuestion"));
        if (question == nullptr) return;
        ++asked;
        QTest::mouseClick(question->button(answer), Qt::LeftButton);
      });
      window_->findChild<QAction*>(QStringLiteral("newProject"))->trigger();
    };
    beginAnew(QMessageBox::Cancel);
    QCOMPARE(asked, 1);
    QCOMPARE(find<QListWidget>("volumes")->count(), 2);
    beginAnew(QMessageBox::Discard);
    QCOMPARE(asked, 2);
    QCOMPARE(find<QListWidget>("volumes")->count(), 0);
    QVERIFY(find<QPushButton>("addFirst")->isVisible());
    // Saved, it may go.
    drop({parts_[0].file, parts_[1].file});
    QVERIFY(jobsEnd());
    QVERIFY(ask<bool>(stitching(), "saveProjectAs", Q_ARG(QString, files_.path(QStringLiteral("kept.json")))));
    beginAnew(QMessageBox::Cancel);
    QTest::qWait(300);
    QCOMPARE(asked, 2);
    QCOMPARE(find<QListWidget>("volumes")->count(), 0);
  }

  void whatGoesWrongWhileAStepRunsHarmsNothing() {
    openWindow(files_.writeCase(QStringLiteral("clumsy case")));
    const QString noProject = files_.path(QStringLiteral("no project.json"));
    QVERIFY(writeFileSafely(noProject.toStdString(), R"({"volumes": "none"})"));
    drop({noProject});
    QVERIFY(jobsEnd());
    QVERIFY2(problem().contains(QStringLiteral("volumes")), qPrintable(problem()));
    drop({QFileInfo(noProject).absolutePath()});  // a folder
    QVERIFY(jobsEnd());
    QVERIFY(!problem().isEmpty());
    QVERIFY(view("recoveryOffer")->isHidden());
    drop({parts_[0].file, parts_[1].file, parts_[0].file});  // one of them twice
    QVERIFY(jobsEnd());
    QCOMPARE(find<QListWidget>("volumes")->count(), 2);
    drop({parts_[1].file});
    QVERIFY2(problem().contains(QStringLiteral("in the list already")), qPrintable(problem()));
    drop({writeStranger(QStringLiteral("stranger.mha"))});
    QVERIFY(jobsEnd());
    QCOMPARE(find<QListWidget>("volumes")->count(), 3);
    click("matchAll");
    QTest::qWait(100);
    // A file comes, one that takes part in the run goes, and another step is asked for.
    drop({parts_[2].file});
    auto* list = find<QListWidget>("volumes");
    list->setCurrentRow(2);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Delete);
    QMetaObject::invokeMethod(stitching(), "chooseThePair", Q_ARG(int, 0), Q_ARG(int, 1));
    clickInspector("redoPair");
    QVERIFY2(problem().contains(QStringLiteral("still running")), qPrintable(problem()));
    QVERIFY(jobsEnd());
    QCOMPARE(list->count(), 3);
    QCOMPARE(verdict(0, 1), QStringLiteral("aligned"));
    QVERIFY(verdict(0, 2).isEmpty());  // came later, and was not matched
    // Another project is opened in the middle of a run: what the run finds is not told about it.
    const QString other = files_.path(QStringLiteral("other.json"));
    QVERIFY(writeFileSafely(other.toStdString(), "{\"format\": 2, \"volumes\": [{\"file\": \"" + parts_[2].file.toStdString() + "\"}]}"));
    click("seams");
    QTest::qWait(100);
    QVERIFY(ask<bool>(stitching(), "openProjectFile", Q_ARG(QString, other)));
    QVERIFY(jobsEnd());
    QCOMPARE(list->count(), 1);
    QCOMPARE(ask<int>(stitching(), "nodesOfResult"), 0);
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
  }

  /// Verdicts come from the libraries as codes with figures; the window says them in its own language.
  void aRefusedPairIsExplainedInTheWindowsLanguage() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QApplication::installTranslator(&german);
    openWindow(files_.writeCase(QStringLiteral("german case")));
    keepImage("23-german-empty");
    drop({parts_[0].file, parts_[1].file, writeStranger(QStringLiteral("ein Fremder mit einem sehr langen und umständlichen Namen.mha"))});
    QVERIFY(jobsEnd());
    const QString bad = files_.path(QStringLiteral("kein Volumen.mha"));
    QVERIFY(writeFileSafely(bad.toStdString(), "no volume"));
    drop({bad});
    QVERIFY(jobsEnd());
    QVERIFY2(problem().contains(QStringLiteral("„kein Volumen.mha“ ist kein MetaImage")), qPrintable(problem()));
    click("matchAll");
    QVERIFY2(waitUntil([this] {
               const auto seen = window_->jobs().seen();
               return std::any_of(seen.begin(), seen.end(), [](const auto& job) {
                 return job.step.contains(QLatin1String("zugeordnet")) || job.step.contains(QLatin1String("verglichen"));
               });
             }),
             "no step of the run is named in German");
    QTest::qWait(900);
    keepImage("24-german-running");
    QVERIFY(jobsEnd());
    QMetaObject::invokeMethod(stitching(), "chooseThePair", Q_ARG(int, 0), Q_ARG(int, 2));
    const QString reason = find<QLabel>("pairReason")->text();
    const QString whole = find<QLabel>("outcome")->text();
    checkNoTextIsCut();
    keepImage("25-german-refused");
    window_->resize(1280, 800);
    QTest::qWait(100);
    keepImage("26-german-small");
    window_->resize(1920, 1080);
    QTest::qWait(100);
    keepImage("27-german-large");
    QApplication::removeTranslator(&german);
    QVERIFY2(verdict(0, 2) != QLatin1String("aligned"), qPrintable(verdict(0, 2)));
    for (const QString& text : {reason, whole}) {
      QVERIFY(!text.isEmpty());
      for (const char* word : {" the ", " and ", "overlap ", "Nothing", "The "})
        QVERIFY2(!text.contains(QLatin1String(word)), qPrintable(text));
    }
    QVERIFY2(reason.contains(QStringLiteral("Gewebe")) || reason.contains(QStringLiteral("berlappung")), qPrintable(reason));
    QVERIFY2(whole.contains(QStringLiteral("verbindet nichts")), qPrintable(whole));
  }

  void closingInTheMiddleOfAJobLosesNothing() {
    const QString folder = files_.writeCase(QStringLiteral("closed case"));
    openWindow(folder);
    drop({parts_[0].file, parts_[1].file, parts_[2].file});
    QVERIFY(jobsEnd());
    click("matchAll");
    QTest::qWait(150);
    const QJsonObject before = project();
    window_->close();
    window_.reset();
    openWindow(folder);
    QVERIFY(view("recoveryOffer")->isVisible());
    keepImage("17-offer");
    click("reopenLeft");
    QVERIFY(jobsEnd());
    QVERIFY(project() == before);
    QCOMPARE(find<QListWidget>("volumes")->count(), 3);
  }
};

}  // namespace ew::ui::testing

EW_STITCHING_TEST_MAIN(ew::ui::testing::StitchingJourneyTest)
#include "stitching_journey_test.moc"
