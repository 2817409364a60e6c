// Images that are stored in an examination, and their way to files and to a real archive.
#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/ui_test_door/cine.h"
#include "ew/ui_test_door/images.h"
#include "ew/ui_test_door/measure.h"
#include "ew/ui_test_door/plugins.h"
#include "ew/ui_test_door/worksheets.h"
#include "export/orthanc.h"
#include "gui/support/answers.h"
#include "gui/support/window_fixture.h"
#include "library/temporary_folder.h"

namespace ew::ui::testing {

class StoringTest : public WindowFixture {
  Q_OBJECT

  void type(int key, Qt::KeyboardModifiers modifiers) const { QTest::keyClick(window_.get(), static_cast<Qt::Key>(key), modifiers); }
  void storeImage() const {
    QApplication::setActiveWindow(window_.get());  // back from a dialog
    type(Qt::Key_Insert, Qt::NoModifier);
  }
  [[nodiscard]] ExaminationDialog* dialog() const {
    QApplication::setActiveWindow(window_.get());  // back from a question
    type(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    return window_->findChild<ExaminationDialog*>();
  }
  template <class Widget>
  [[nodiscard]] static Widget* in(ExaminationDialog* dialog, const char* name) {
    return dialog->findChild<Widget*>(QLatin1String(name));
  }
  static void name(ExaminationDialog* dialog, const DicomArchive& archive) {
    in<QLineEdit>(dialog, "archiveHost")->setText(QString::fromStdString(archive.host));
    in<QSpinBox>(dialog, "archivePort")->setValue(archive.port);
    in<QLineEdit>(dialog, "archiveTitle")->setText(QString::fromStdString(archive.aeTitle));
  }
  void send(ExaminationDialog* dialog) const {
    auto* button = in<QPushButton>(dialog, "sendExamination");
    QVERIFY(button->isEnabled());
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(!button->isEnabled());
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }, 4.0 * test::kPatience_ms));
  }
  [[nodiscard]] QString stored() const { return files_.path(QStringLiteral("library/stored-images")); }
  /// From now on the library cannot keep images: what is stored would be lost.
  [[nodiscard]] bool keepsNothing() const {
    return QDir().mkpath(files_.path(QStringLiteral("library"))) && writeFileSafely(stored().toStdString(), "in the way").has_value();
  }
  /// A case of another patient.
  [[nodiscard]] QString writeSecondCase() const {
    const QString folder = files_.writeCase(QStringLiteral("second"));
    auto manifest = nlohmann::json::parse(test::textOf((folder + QStringLiteral("/case.json")).toStdString()));
    manifest["id"] = "second";
    manifest["title"] = "Second";
    test::writeText((folder + QStringLiteral("/case.json")).toStdString(), manifest.dump());
    return folder;
  }
  [[nodiscard]] QString outbox() const { return files_.path(QStringLiteral("outbox")); }
  void saveAsCopy() const {
    QDir(files_.path(QStringLiteral("own cases"))).removeRecursively();
    QAction* saveAs = nullptr;
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text().startsWith(QStringLiteral("Save case &as"))) saveAs = each;
    QVERIFY(saveAs != nullptr);
    Answers answers({{QStringLiteral("caseFolderDialog"), press("saveCaseFolder")}});
    const auto before = window_->document().current()->folder;
    saveAs->trigger();
    QCOMPARE(answers.asked, QStringList{QStringLiteral("caseFolderDialog")});
    QVERIFY(window_->document().current()->folder != before);
  }
  /// Whether a case that is opened by another start has so many images.
  [[nodiscard]] bool hasImagesAtItsNextStart(const QString& folder, std::size_t count) {
    window_.reset();
    showWindowWithCase(folder);
    return waitUntil([&] { return window_->stored().items().size() == count; });
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    QDir(outbox()).removeRecursively();
    QDir(stored()).removeRecursively();
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
    QVERIFY(waitUntil([&] { return window_->isSettled(); }));
  }
  void cleanup() {
    window_.reset();
    QFile::remove(stored());
  }

  void aStoredImageIsTheImageThatWasShown() {
    session().setFrozen(true);
    storeImage();
    QVERIFY2(window_->scanView().said().contains(QLatin1String("stored")), qPrintable(window_->scanView().said()));
    ExaminationDialog* shown = dialog();
    QVERIFY(shown != nullptr);
    auto* images = in<QListWidget>(shown, "storedImages");
    QCOMPARE(images->count(), 1);
    QVERIFY(!in<QLabel>(shown, "noStoredImages")->isVisible());
    QVERIFY(!in<QPushButton>(shown, "sendExamination")->isEnabled());  // no archive is named
    QVERIFY(in<QPushButton>(shown, "saveExamination")->isEnabled());
    storeImage();
    QCOMPARE(images->count(), 2);
    images->setCurrentRow(0);
    QTest::mouseClick(in<QPushButton>(shown, "removeStored"), Qt::LeftButton);
    QCOMPARE(images->count(), 1);
  }

  void savedAsFilesItHasItsScaleAndItsWords() {
    session().setFrozen(true);
    storeImage();
    const std::vector<SnapshotPart> shown{{&session(), {}, {}, true}};
    const Still expected = storedStill(shown, savedImages(shown, 1, QDateTime::currentDateTime()), 1, {}).still;
    const QString folder = files_.path(QStringLiteral("saved"));
    QDir(folder).removeRecursively();
    QDir().mkpath(folder);
    Answers answers({{QStringLiteral("fileDialog"), testing::type(folder)}});
    QTest::mouseClick(in<QPushButton>(dialog(), "saveExamination"), Qt::LeftButton);
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
    const QStringList made = QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    QCOMPARE(made.size(), 1);
    const auto summary = inspectDicom((folder + QLatin1Char('/') + made[0] + QStringLiteral("/picture_001.dcm")).toStdString());
    QVERIFY(summary);
    QCOMPARE(summary->regions.size(), std::size_t{1});
    QVERIFY(std::abs(summary->regions[0].pixel_mm().x - session().geometry().pixel_mm) < 1e-9);
    QCOMPARE(summary->regions[0].rect.x, expected.regions[0].rect.x);
    QCOMPARE(summary->columns, expected.size_px().x);
  }

  void anArchiveThatIsAwayLosesNothingAndGetsNothingTwice() {
    if (!test::hasOrthanc()) QSKIP("for want of a program: orthanc is not installed");
    const QTemporaryDir place;
    test::Orthanc archive(place.path().toStdString());
    session().setFrozen(true);
    storeImage();
    storeImage();
    ExaminationDialog* shown = dialog();
    name(shown, archive.address());
    send(shown);
    QVERIFY(window_->messages().isError());
    QVERIFY2(in<QLabel>(shown, "outboxState")->text().contains(QLatin1String(": 2.")),
             qPrintable(in<QLabel>(shown, "outboxState")->text()));
    QVERIFY2(archive.start(), archive.said().c_str());
    QTest::mouseClick(in<QPushButton>(shown, "testArchive"), Qt::LeftButton);
    QVERIFY(waitUntil([&] { return in<QLabel>(shown, "archiveAnswer")->text().contains(QLatin1String("answers")); }));
    send(shown);
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QCOMPARE(archive.kept().size(), std::size_t{2});
    storeImage();
    send(shown);
    QCOMPARE(archive.kept().size(), std::size_t{3});
    send(shown);  // nothing new
    QCOMPARE(archive.kept().size(), std::size_t{3});
  }

  void imagesStayWithTheirPatientAndTheNextBeginsEmpty() {
    session().setFrozen(true);
    storeImage();
    storeImage();
    auto* images = in<QListWidget>(dialog(), "storedImages");
    QCOMPARE(images->count(), 2);
    const QString first = images->item(0)->toolTip();
    Answers answers({});
    QVERIFY(openCase(writeSecondCase()));
    QVERIFY(waitUntil([&] { return window_->isSettled(); }));
    QVERIFY2(answers.asked.isEmpty(), "they are in the library: nothing is lost");
    images = in<QListWidget>(dialog(), "storedImages");
    QCOMPARE(images->count(), 0);
    session().setFrozen(true);
    storeImage();
    QVERIFY(openCase(files_.path(QStringLiteral("case"))));
    QVERIFY(waitUntil([&] { return in<QListWidget>(dialog(), "storedImages")->count() == 2; }));
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->item(0)->toolTip(), first);
    QVERIFY(answers.asked.isEmpty());
    // ... and there again after a restart, the same objects; one that was taken away stays away.
    in<QListWidget>(dialog(), "storedImages")->setCurrentRow(0);
    QTest::mouseClick(in<QPushButton>(dialog(), "removeStored"), Qt::LeftButton);
    QVERIFY(window_->close());
    QVERIFY(answers.asked.isEmpty());
    window_.reset();
    showWindowWithCase(files_.path(QStringLiteral("case")));
    QVERIFY(waitUntil([&] { return in<QListWidget>(dialog(), "storedImages")->count() == 1; }));
    session().setFrozen(true);
    storeImage();
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 2);
    for (const QFileInfo& file : QDir(stored()).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot))
      QCOMPARE(file.permissions() & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
  }

  void imagesGoAlongWhenTheCaseIsSavedAsACopy() {
    const QString original = files_.path(QStringLiteral("case"));
    session().setFrozen(true);
    storeImage();
    storeImage();
    saveAsCopy();
    const QString copy = QString::fromStdString(window_->document().current()->folder.string());
    QCOMPARE(window_->stored().items().size(), std::size_t{2});
    storeImage();
    QCOMPARE(window_->stored().items().size(), std::size_t{3});  // the same patient, and the same examination
    QCOMPARE(window_->stored().items().back().still.options.number, 3);
    QCOMPARE(window_->stored().files(DicomStudy(), QDateTime::currentDateTime()).images.size(), std::size_t{3});
    QCOMPARE(QSettings().value(QStringLiteral("open/last")).toString(), copy);
    QVERIFY(hasImagesAtItsNextStart(copy, 3));
    QVERIFY2(hasImagesAtItsNextStart(original, 2), "those that were taken of it");
  }

  void imagesThatNothingKeepsStayWhenTheCaseIsSavedAsACopy() {
    QVERIFY(keepsNothing());
    session().setFrozen(true);
    storeImage();
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 1; }));
    saveAsCopy();
    Answers nobody({});
    storeImage();
    QCOMPARE(window_->stored().items().size(), std::size_t{2});
    QVERIFY(nobody.asked.isEmpty());
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 2; }));
  }

  void imagesStayTogetherWhileTheScanStaysAndTheCaseHoldsAnotherVolume() {
    QVERIFY(keepsNothing());
    const QString folder = QString::fromStdString(window_->document().current()->folder.string());
    QVERIFY(QFile::exists(folder + QStringLiteral("/second.mha")) ||
            QFile::copy(folder + QStringLiteral("/volume.mha"), folder + QStringLiteral("/second.mha")));
    session().setFrozen(true);
    storeImage();
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 1; }));
    {
      Answers stay({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Cancel)}});
      Case changed = *window_->document().current();
      changed.volume.file = "second.mha";
      QVERIFY(window_->document().edit(changed, "Change the volume", {}).has_value());
      QCoreApplication::processEvents();
      QVERIFY(waitUntil([&] { return window_->isSettled(); }));
      QCOMPARE(stay.asked, QStringList{QStringLiteral("unsavedStoredQuestion")});
    }
    Answers nobody({});
    session().setFrozen(true);
    storeImage();
    QCOMPARE(window_->stored().items().size(), std::size_t{2});
    QVERIFY(nobody.asked.isEmpty());
  }

  void whoBeginsToLearnHereIsAskedAboutImagesThatNothingKeeps() {
    QVERIFY(keepsNothing());
    session().setFrozen(true);
    storeImage();
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 1; }));
    const auto first = window_->stored().items().front().revision;
    QSettings().setValue(QStringLiteral("learning/person"), QStringLiteral("Somebody else"));
    {
      Answers stay({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Cancel)}});
      storeImage();
      QCOMPARE(stay.asked, QStringList{QStringLiteral("unsavedStoredQuestion")});
      QCOMPARE(window_->stored().items().size(), std::size_t{1});
      QCOMPARE(window_->stored().items().front().revision, first);
    }
    Answers discard({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Discard)}});
    storeImage();
    QCOMPARE(discard.asked, QStringList{QStringLiteral("unsavedStoredQuestion")});
    QCOMPARE(window_->stored().items().size(), std::size_t{1});
    QVERIFY(window_->stored().items().front().revision != first);
  }

  void anImageThatTheLibraryCannotKeepIsAskedAbout() {
    QVERIFY(keepsNothing());
    session().setFrozen(true);
    storeImage();
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 1; }));
    QVERIFY(waitUntil([&] { return window_->messages().isError(); }));
    Answers answers({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Discard)}});
    QVERIFY(openCase(writeSecondCase()));
    QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedStoredQuestion")});
    QFile::remove(stored());
  }

  void anImageThatIsStoredWhileTheOthersAreSavedIsNotSaved() {
    QVERIFY(keepsNothing());
    session().setFrozen(true);
    storeImage();
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 1; }));
    const QString folder = files_.path(QStringLiteral("saved meanwhile"));
    QDir().mkpath(folder);
    Answers answers(
        {{QStringLiteral("fileDialog"), testing::type(folder)}, {QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Cancel)}});
    QTest::mouseClick(in<QPushButton>(dialog(), "saveExamination"), Qt::LeftButton);
    storeImage();  // the job that saves has begun; its end is an event that has not been seen yet
    QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
    QCOMPARE(QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
    QCOMPARE(window_->stored().unsavedCount(), std::size_t{1});  // the other one is safe
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 1; }));
    QVERIFY(!window_->close());
    QVERIFY(answers.asked.contains(QStringLiteral("unsavedStoredQuestion")));
    QVERIFY2(answers.texts.last().endsWith(QStringLiteral(" 1.")), qPrintable(answers.texts.last()));
  }

  void imagesStayWithTheirPatientWhenTheCaseGivesItAnotherBody() {
    session().setFrozen(true);
    storeImage();
    window_->worksheets().choose("abdomen");
    window_->worksheets().measure("AORTA", "");
    window_->calipers().changeIn(Where::image, [](measurement::CaliperDrawing& drawing) {
      for (const glm::dvec2 at : {glm::dvec2(-17.0, 50.0), glm::dvec2(16.0, 50.0)}) {
        drawing.press(at, 1.0);
        drawing.release(at, 1.0);
      }
    });
    QCOMPARE(window_->calipers().findings().all().size(), std::size_t{1});
    const measurement::Examination sheet = *window_->worksheets().current();
    QVERIFY(!sheet.isEmpty());
    Answers answers({});
    const auto give = [&](const char* mannequin) {
      Case changed = *window_->document().current();
      changed.mannequin = mannequin;
      QVERIFY(window_->document().edit(changed, "Change the body", {}).has_value());
      QVERIFY(waitUntil([&] { return window_->isSettled(); }, 4.0 * test::kPatience_ms));
    };
    give("gravid.json");
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 1);
    QCOMPARE(window_->calipers().findings().all().size(), std::size_t{1});
    QVERIFY(*window_->worksheets().current() == sheet);
    window_->document().undo();
    QVERIFY(waitUntil([&] { return window_->isSettled(); }, 4.0 * test::kPatience_ms));
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 1);
    QVERIFY2(answers.asked.isEmpty(), "nothing was lost, so nothing is asked");
  }

  void anotherVolumeOfTheCaseAsksForTheImagesOfTheOneBefore() {
    QVERIFY(keepsNothing());
    const QString folder = QString::fromStdString(window_->document().current()->folder.string());
    QVERIFY(QFile::exists(folder + QStringLiteral("/second.mha")) ||
            QFile::copy(folder + QStringLiteral("/volume.mha"), folder + QStringLiteral("/second.mha")));
    session().setFrozen(true);
    storeImage();
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 1; }));
    const auto shown = session().subject()->voxels.volume();
    const auto settles = [&] {
      QCoreApplication::processEvents();
      QVERIFY(waitUntil([&] { return window_->isSettled(); }));
    };
    {
      Answers stay({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Cancel)}});
      Case changed = *window_->document().current();
      changed.volume.file = "second.mha";
      QVERIFY(window_->document().edit(changed, "Change the volume", {}).has_value());
      settles();
      QCOMPARE(stay.asked, QStringList{QStringLiteral("unsavedStoredQuestion")});
      QVERIFY(session().subject()->voxels.volume() == shown);
    }
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 1);
    {
      Answers nobody({});
      window_->document().undo();  // the volume is that of the case again
      settles();
      QVERIFY(nobody.asked.isEmpty());
    }
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 1);
    Answers discard({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Discard)}});
    window_->document().redo();
    settles();
    QCOMPARE(discard.asked, QStringList{QStringLiteral("unsavedStoredQuestion")});
    QVERIFY(session().subject()->voxels.volume() != shown);
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 0);
  }

  void imagesOfACaseAreThereWhateverItsVolumeBecomes() {
    const QString folder = QString::fromStdString(window_->document().current()->folder.string());
    QVERIFY(QFile::exists(folder + QStringLiteral("/second.mha")) ||
            QFile::copy(folder + QStringLiteral("/volume.mha"), folder + QStringLiteral("/second.mha")));
    session().setFrozen(true);
    storeImage();
    const auto shown = session().subject()->voxels.volume();
    Answers nobody({});
    Case changed = *window_->document().current();
    changed.volume.file = "second.mha";
    QVERIFY(window_->document().edit(changed, "Change the volume", {}).has_value());
    QVERIFY(waitUntil([&] { return window_->isSettled() && session().subject()->voxels.volume() != shown; }));
    QVERIFY(waitUntil([&] { return in<QListWidget>(dialog(), "storedImages")->count() == 1; }));
    QVERIFY2(nobody.asked.isEmpty(), "the library has it: nothing is lost");
  }

  void goingBackToTheVolumeOfTheCaseAsksForWhatWasStoredOfAnother() {
    QVERIFY(keepsNothing());
    Volume volume;
    volume.grid.dims = {20, 20, 20};
    volume.echo.assign(volume.grid.voxelCount(), 90);
    auto* host = window_->findChild<WorkstationHost*>();
    host->volumes().show(volume, "made by a plugin");
    QVERIFY(waitUntil([&] { return window_->isSettled() && session().subject()->title == "made by a plugin"; }));
    session().setFrozen(true);
    storeImage();
    QVERIFY(waitUntil([&] { return window_->stored().atRiskCount() == 1; }));
    QAction* back = nullptr;
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text().contains(QStringLiteral("case's volume"))) back = each;
    QVERIFY(back != nullptr);
    {
      Answers stay({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Cancel)}});
      back->trigger();
      QCOMPARE(stay.asked, QStringList{QStringLiteral("unsavedStoredQuestion")});
      QCOMPARE(session().subject()->title, std::string("made by a plugin"));
    }
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 1);
    Answers discard({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Discard)}});
    back->trigger();
    QCOMPARE(session().subject()->title, std::string("Window test"));
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 0);
  }

  void anEndingInCapitalsIsThatEnding() {
    const auto begins = [](const QString& file, const QByteArray& how) {
      QFile made(file);
      return made.open(QIODevice::ReadOnly) && made.read(how.size()) == how;
    };
    const auto measurements = files_.path(QStringLiteral("list.CSV"));
    QVERIFY(writeMeasurements(window_->calipers().findings(), QStringLiteral("t"), measurements.toStdString()));
    QVERIFY(!begins(measurements, "{"));
    const auto sheet = files_.path(QStringLiteral("sheet.JSON"));
    QVERIFY(writeWorksheet({}, QStringLiteral("t"), QDateTime::currentDateTime(), sheet.toStdString()));
    QVERIFY(begins(sheet, "{"));
    for (const char* name : {"picture.DCM", "picture.PNG", "picture.MHA"}) {
      const QString file = files_.path(QLatin1String(name));
      Answers answers({{QStringLiteral("fileDialog"), testing::type(file)}});
      for (QAction* each : window_->findChildren<QAction*>())
        if (each->text().startsWith(QStringLiteral("Save &image as"))) each->trigger();
      QVERIFY2(QFile::exists(file), name);
      const QByteArray start = QByteArray(name).endsWith("DCM")   ? QByteArray(128, '\0') + "DICM"
                               : QByteArray(name).endsWith("PNG") ? QByteArray("\x89PNG")
                                                                  : QByteArray("ObjectType");
      QVERIFY2(begins(file, start), name);
    }
  }

  void aClipLeavesAsFilmAndAsDicom() {
    for (int n = 0; n < 5; ++n) {
      session().frames().ask();
      session().makeImageNow();
      QTest::qWait(20);
    }
    session().setFrozen(true);
    QVERIFY(window_->cineBar().isOpen());
    for (const char* ending : {".avi", ".dcm"}) {
      const QString file = files_.path(QStringLiteral("clip") + QLatin1String(ending));
      Answers answers({{QStringLiteral("fileDialog"), testing::type(file)}});
      Q_EMIT window_->cineBar().saveAsked();
      QVERIFY(waitUntil([&] { return !window_->jobs().isRunning(); }));
      QVERIFY2(QFileInfo(file).size() > 5000, ending);
    }
  }

  void aReportHasTheStoredImages() {
    session().setFrozen(true);
    storeImage();
    measurement::Worksheet sheet;
    sheet.title.english = "Sheet";
    const QImage image = withWarning(savedImage(session(), QDateTime::currentDateTime()));
    QVERIFY(image != savedImage(session(), QDateTime::currentDateTime()));
    const auto size = [&](const char* name, const std::vector<WorksheetImage>& images) {
      const QString file = files_.path(QLatin1String(name));
      return writeWorksheet(sheet, QStringLiteral("Case"), QDateTime::currentDateTime(), file.toStdString(), images)
                 ? QFileInfo(file).size()
                 : qint64{0};
    };
    QVERIFY(size("with.pdf", {{image, QStringLiteral("one")}, {image, QStringLiteral("two")}}) > size("without.pdf", {}) + 20000);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::StoringTest)
#include "storing_test.moc"
