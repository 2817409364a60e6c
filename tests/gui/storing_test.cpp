// Images that are stored in an examination, and their way to files and to a real archive.
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <algorithm>

#include "answers.h"
#include "caliper_layer.h"
#include "calipers.h"
#include "cine_bar.h"
#include "examination_dialog.h"
#include "export/orthanc.h"
#include "saved_picture.h"
#include "stored_examination.h"
#include "window_fixture.h"
#include "worksheet_file.h"
#include "worksheets.h"

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
  [[nodiscard]] QString outbox() const { return files_.path(QStringLiteral("outbox")); }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    QDir(outbox()).removeRecursively();
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
    QVERIFY(waitUntil([&] { return window_->isSettled(); }));
  }
  void cleanup() { window_.reset(); }

  void aStoredImageIsThePictureThatWasShown() {
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
    const std::vector<SavedPart> shown{{&session(), {}, {}, true}};
    const Still expected = storedStill(shown, savedPictures(shown, 1, QDateTime::currentDateTime()), 1, {}).still;
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

  void aPatientWhoLeavesIsAskedAboutAndTheNextBeginsEmpty() {
    session().setFrozen(true);
    storeImage();
    const QString second = files_.writeCase(QStringLiteral("second"));
    Answers answers({{QStringLiteral("unsavedStoredQuestion"), press(QMessageBox::Discard)}});
    QVERIFY(openCase(second));
    QVERIFY(waitUntil([&] { return window_->isSettled(); }));
    QCOMPARE(answers.asked, QStringList{QStringLiteral("unsavedStoredQuestion")});
    QCOMPARE(in<QListWidget>(dialog(), "storedImages")->count(), 0);
  }

  void aClipLeavesAsFilmAndAsDicom() {
    for (int n = 0; n < 5; ++n) {
      session().refresh();
      session().makePictureNow();
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
    const QImage picture = withWarning(savedPicture(session(), QDateTime::currentDateTime()));
    QVERIFY(picture != savedPicture(session(), QDateTime::currentDateTime()));
    const auto size = [&](const char* name, const std::vector<ReportPicture>& pictures) {
      const QString file = files_.path(QLatin1String(name));
      return writeWorksheet(sheet, QStringLiteral("Case"), QDateTime::currentDateTime(), file.toStdString(), pictures)
                 ? QFileInfo(file).size()
                 : qint64{0};
    };
    QVERIFY(size("with.pdf", {{picture, QStringLiteral("one")}, {picture, QStringLiteral("two")}}) > size("without.pdf", {}) + 20000);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::StoringTest)
#include "storing_test.moc"
