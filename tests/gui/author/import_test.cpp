#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <cmath>
#include <cstring>

#include "even_sweep.h"
#include "ew/io/safe_file.h"
#include "ew/io/sequence.h"
#include "ew/ui_test_door/import.h"
#include "ew/ui_test_door/jobs.h"
#include "ew/ui_test_door/messages.h"
#include "ew/widgets/image_chooser.h"
#include "gui/support/answers.h"
#include "io/dicom_files.h"
#include "time_limit.h"

namespace ew::ui {
namespace {

/// A still of 64 x 48 pixels, half of it in colour, with two calibrated parts and a text that may name somebody.
std::string twoPartStill() {
  test::CineOf cine;
  cine.columns = 64;
  cine.rows = 48;
  cine.frames = 1;
  cine.samples = 3;
  cine.photometric = "RGB";
  for (int n = 0; n < 64 * 48; ++n) {
    cine.pixels += static_cast<char>(n % 200);
    cine.pixels += static_cast<char>(n % 64 < 32 ? n % 200 : 0);
    cine.pixels += static_cast<char>(n % 200);
  }
  cine.regions = {{.x0 = 2, .y0 = 4, .x1 = 29, .y1 = 43}, {.x0 = 34, .y0 = 4, .x1 = 61, .y1 = 43}};
  return test::cineFile(cine);
}

/// NIfTI-1 of 4 x 3 x 2 voxels of 0.7 mm, `volumes` one after the other.
std::string niftiSeries(std::int16_t volumes) {
  std::string bytes(352, '\0');
  const auto put = [&](std::size_t at, auto value) { std::memcpy(bytes.data() + at, &value, sizeof value); };
  put(0, std::int32_t{348});
  const std::array<std::int16_t, 5> dims{4, 4, 3, 2, volumes};
  for (std::size_t n = 0; n < dims.size(); ++n) put(40 + 2 * n, dims[n]);
  put(70, std::int16_t{2});
  put(72, std::int16_t{8});
  for (std::size_t n = 0; n < 8; ++n) put(76 + 4 * n, n >= 1 && n <= 3 ? 0.7F : 1.0F);
  put(108, 352.0F);
  put(254, std::int16_t{1});
  for (std::size_t n = 0; n < 3; ++n) put(280 + 20 * n, 0.7F);
  bytes.replace(344, 4, std::string("n+1\0", 4));
  return bytes + test::ramp(static_cast<std::size_t>(24 * volumes));
}

/// Every shown label, field, box and button of the dialog has the room it asks for, and none lies on another of its own parent.
QString crampedIn(const QDialog& dialog) {
  for (const QWidget* widget : dialog.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->parentWidget() == nullptr) continue;
    const bool counts = qobject_cast<const QLabel*>(widget) != nullptr || qobject_cast<const QLineEdit*>(widget) != nullptr ||
                        qobject_cast<const QAbstractSpinBox*>(widget) != nullptr || qobject_cast<const QComboBox*>(widget) != nullptr ||
                        qobject_cast<const QAbstractButton*>(widget) != nullptr;
    if (!counts || qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) != nullptr) continue;
    const QString name = QString::fromLatin1(widget->metaObject()->className()) + QLatin1Char(' ') + widget->objectName();
    const int needed_px = widget->hasHeightForWidth() ? widget->heightForWidth(widget->width()) : widget->minimumSizeHint().height();
    if (widget->height() < needed_px) return name + QStringLiteral(" is %1 high and needs %2").arg(widget->height()).arg(needed_px);
    for (const QObject* child : widget->parentWidget()->children()) {
      const auto* other = qobject_cast<const QWidget*>(child);
      if (other == nullptr || other == widget || !other->isVisible()) continue;
      if (other->geometry().intersects(widget->geometry()))
        return name + QStringLiteral(" lies on ") + QString::fromLatin1(other->metaObject()->className()) + other->objectName();
    }
  }
  return {};
}

/// The dialogs that ask what a file leaves open, without the window around them.
class ImportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rawSamplesShowTheirSlicesAndNeedTheirSpacing() {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("samples.raw"));
    std::string bytes;
    for (int n = 0; n < 64 * 64 * 64; ++n) bytes += static_cast<char>(n % 64 * 3);
    QVERIFY(writeFileSafely(file.toStdString(), bytes).has_value());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    QPointer<FileImportDialog> dialog = new FileImportDialog(file, FileKind::raw, QString(), jobs, messages, &parent);
    std::shared_ptr<const Volume> made;
    connect(dialog, &FileImportDialog::imported, [&](const ew::ScanVoxels& voxels, const QString&) { made = voxels.volume(); });
    dialog->show();
    QCOMPARE(dialog->findChild<QSpinBox*>(QStringLiteral("rawDim0"))->value(), 1);  // nothing is filled in beforehand
    auto* guess = dialog->findChild<QComboBox*>(QStringLiteral("rawGuess"));
    QVERIFY(guess->count() > 1);
    guess->setCurrentIndex(1);
    Q_EMIT guess->activated(1);
    QCOMPARE(dialog->findChild<QSpinBox*>(QStringLiteral("rawDim2"))->value(), 64);
    auto* slice = dialog->findChild<QLabel*>(QStringLiteral("rawPreview"));
    const auto isShown = [slice](int width, int height) {
      const QPixmap shown = slice->pixmap(Qt::ReturnByValue);
      return !shown.isNull() && shown.width() * height == shown.height() * width;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isShown(64, 64), 300000);
    // Typed in haste: the window goes on, and what is shown in the end is the last layout.
    auto* dims = dialog->findChild<QSpinBox*>(QStringLiteral("rawDim0"));
    for (const int width : {16, 8, 32}) dims->setValue(width);
    QVERIFY2(isShown(64, 64), "the slices are read by a job, not by the key");
    QTRY_VERIFY_WITH_TIMEOUT(isShown(32, 64), 300000);
    QTRY_VERIFY_WITH_TIMEOUT(!jobs.isRunning(), 300000);
    QVERIFY(isShown(32, 64));
    dims->setValue(64);
    QTRY_VERIFY_WITH_TIMEOUT(isShown(64, 64), 300000);
    auto* import = dialog->findChild<QPushButton*>(QStringLiteral("importFile"));
    auto* question = dialog->findChild<QLabel*>(QStringLiteral("importQuestion"));
    import->click();
    QTRY_VERIFY_WITH_TIMEOUT(question->text().contains(QStringLiteral("spacing")), static_cast<int>(ew::test::kPatience_ms));
    QVERIFY(!made);
    for (const char axis : {'X', 'Y', 'Z'})
      dialog->findChild<QDoubleSpinBox*>(QStringLiteral("spacing") + QLatin1Char(axis))->setValue(0.5);
    import->click();
    QTRY_VERIFY_WITH_TIMEOUT(made != nullptr, static_cast<int>(ew::test::kPatience_ms));
    QCOMPARE(made->grid.dims.x, 64);
    QCOMPARE(made->grid.spacing_mm.z, 0.5);
    QCOMPARE(static_cast<int>(made->echo[5]), 15);
  }

  void theDialogOfImagesShowsThemAndHasRoomForItsRows() {
    const test::TempFolder folder;
    const QString file = QString::fromStdString(folder.put("still.dcm", twoPartStill()).string());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    QPointer<FileImportDialog> dialog =
        new FileImportDialog(file, FileKind::dicomImages,
                             QStringLiteral("Two calibrated images lie side by side; choose one of the regions."), jobs, messages, &parent);
    dialog->show();
    auto* region = dialog->findChild<QComboBox*>(QStringLiteral("region"));
    auto* image = dialog->findChild<ImageChooser*>(QStringLiteral("pictureChooser"));
    QVERIFY(image != nullptr);
    QTRY_COMPARE_WITH_TIMEOUT(region->count(), 4, static_cast<int>(ew::test::kPatience_ms));
    QTRY_VERIFY_WITH_TIMEOUT(crampedIn(*dialog).isEmpty(), static_cast<int>(ew::test::kPatience_ms));
    // A screen may be smaller than the dialog would like: then its rows scroll.
    dialog->resize(dialog->minimumSizeHint());
    QTRY_VERIFY2_WITH_TIMEOUT(crampedIn(*dialog).isEmpty(), qPrintable(crampedIn(*dialog)), static_cast<int>(ew::test::kPatience_ms));
    QVERIFY2(dialog->minimumSizeHint().height() < 560, qPrintable(QString::number(dialog->minimumSizeHint().height())));
    QVERIFY2(dialog->minimumSizeHint().width() < 960, qPrintable(QString::number(dialog->minimumSizeHint().width())));
  }

  void aPartIsChosenAndARectangleIsMadeBlackOnTheImage() {
    const test::TempFolder folder;
    const QString file = QString::fromStdString(folder.put("still.dcm", twoPartStill()).string());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    QPointer<FileImportDialog> dialog = new FileImportDialog(file, FileKind::dicomImages, {}, jobs, messages, &parent);
    dialog->show();
    QVERIFY(QTest::qWaitForWindowExposed(dialog));
    auto* region = dialog->findChild<QComboBox*>(QStringLiteral("region"));
    auto* blank = dialog->findChild<QLineEdit*>(QStringLiteral("blank"));
    auto* image = dialog->findChild<ImageChooser*>(QStringLiteral("pictureChooser"));
    QVERIFY(image != nullptr);
    QTRY_COMPARE_WITH_TIMEOUT(region->count(), 4, static_cast<int>(ew::test::kPatience_ms));
    const auto at = [&](int x, int y) { return image->placeOf({x, y, 0, 0}).topLeft().toPoint(); };
    QTest::mouseClick(image, Qt::LeftButton, {}, at(48, 20));
    QCOMPARE(region->currentData().toInt(), 2);
    QTest::mousePress(image, Qt::LeftButton, {}, at(40, 8));
    QTest::mouseMove(image, at(44, 10));
    QTest::mouseRelease(image, Qt::LeftButton, {}, at(50, 14));
    QCOMPARE(blank->text(), QStringLiteral("40,8,10,6"));
    QCOMPARE(region->currentData().toInt(), 2);
    blank->setText(blank->text() + QStringLiteral(" 0,0,5,5"));
    QTest::mouseClick(image, Qt::RightButton, {}, at(45, 11));
    QCOMPARE(blank->text(), QStringLiteral("0,0,5,5"));
  }

  void aPartOfAlmostNothingIsAskedAbout() {
    const test::TempFolder folder;
    test::CineOf cine;
    cine.columns = 64;
    cine.rows = 48;
    cine.frames = 1;
    cine.pixels = test::ramp(64 * 48);
    cine.regions = {{.x0 = 2, .y0 = 4, .x1 = 9, .y1 = 11}};
    const QString file = QString::fromStdString(folder.put("still.dcm", test::cineFile(cine)).string());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    QPointer<FileImportDialog> dialog = new FileImportDialog(file, FileKind::dicomImages, QString(), jobs, messages, &parent);
    dialog->show();
    auto* import = dialog->findChild<QPushButton*>(QStringLiteral("importFile"));
    {
      testing::Answers back({});  // an unknown question is answered with Back
      import->click();
      QTRY_VERIFY_WITH_TIMEOUT(back.asked.contains(QStringLiteral("smallResultQuestion")), static_cast<int>(ew::test::kPatience_ms));
      QVERIFY(back.texts.join(QString()).contains(QStringLiteral("Only 2.1 % of the pixels")));
      QTRY_VERIFY_WITH_TIMEOUT(!jobs.isRunning(), static_cast<int>(ew::test::kPatience_ms));
      QVERIFY(!back.asked.contains(QStringLiteral("fileDialog")));
    }
    testing::Answers yes({{QStringLiteral("smallResultQuestion"),
                           [](QWidget& question) { question.findChild<QPushButton*>(QStringLiteral("acceptSmall"))->click(); }}});
    import->click();
    QTRY_VERIFY_WITH_TIMEOUT(yes.asked.contains(QStringLiteral("fileDialog")), static_cast<int>(ew::test::kPatience_ms));
  }

  void aSeriesSaysHowManyVolumesAndWhatSpacingItHolds() {
    const test::TempFolder folder;
    const QString file = QString::fromStdString(folder.put("series.nii", niftiSeries(7)).string());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    QPointer<FileImportDialog> dialog = new FileImportDialog(file, FileKind::volume, {}, jobs, messages, &parent);
    std::shared_ptr<const Volume> made;
    connect(dialog, &FileImportDialog::imported, [&](const ew::ScanVoxels& voxels, const QString&) { made = voxels.volume(); });
    dialog->show();
    auto* number = dialog->findChild<QSpinBox*>(QStringLiteral("timeStep"));
    QTRY_COMPARE_WITH_TIMEOUT(number->maximum(), 7, static_cast<int>(ew::test::kPatience_ms));
    QVERIFY2(number->text().contains(QLatin1Char('7')), qPrintable(number->text()));
    const QString spacing = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("spacingX"))->text();
    QVERIFY2(spacing.contains(QStringLiteral("0.7")), qPrintable(spacing));
    number->setValue(3);
    dialog->findChild<QPushButton*>(QStringLiteral("importFile"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(made != nullptr, static_cast<int>(ew::test::kPatience_ms));
    QCOMPARE(static_cast<int>(made->echo[0]), 48);
    QVERIFY2(messages.count() <= 1, qPrintable(messages.text()));  // one import is one message
  }

  void anImportedCineBecomesAVolumeWhenAPersonSaysHowTheProbeMoved() {
    const test::TempFolder folder;
    Sequence cine;
    cine.width = 20;
    cine.height = 16;
    cine.orientation = "MF";
    cine.imageType = "BRIGHTNESS";
    for (int n = 0; n < 6; ++n) {
      SequenceFrame frame;
      frame.transforms.push_back({"Image", "Picture", glm::dmat4(1.0), PoseStatus::ok});
      cine.frames.push_back(frame);
      cine.pixels.insert(cine.pixels.end(), 20 * 16, static_cast<std::uint8_t>(40 * n));
    }
    const auto file = folder / "cine.igs.mha";
    QVERIFY(writeSequence(cine, file).has_value());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    QPointer<ImportDialog> dialog = new ImportDialog(QString::fromStdString(file.string()), {}, jobs, messages, &parent);
    std::shared_ptr<const Volume> made;
    connect(dialog, &ImportDialog::imported,
            [&](const ew::ScanVoxels& voxels, const QString&, const std::shared_ptr<const ew::Provenance>&) { made = voxels.volume(); });
    dialog->show();
    auto* make = dialog->findChild<QPushButton*>(QStringLiteral("makeVolume"));
    auto* notes = dialog->findChild<QLabel*>(QStringLiteral("importNotes"));
    QTRY_VERIFY_WITH_TIMEOUT(notes->text().contains(QStringLiteral("how it moved")), static_cast<int>(ew::test::kPatience_ms));
    QVERIFY2(!notes->text().contains(QStringLiteral("as the target")), qPrintable(notes->text()));
    QVERIFY(!make->isEnabled());
    auto* moved = dialog->findChild<QComboBox*>(QStringLiteral("moved"));
    moved->setCurrentIndex(3);
    QVERIFY(dialog->findChild<QDoubleSpinBox*>(QStringLiteral("motorStep"))->isVisible());
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("motorStep"))->setValue(2.0);
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("spacing"))->setValue(1.0);
    QTRY_VERIFY2_WITH_TIMEOUT(make->isEnabled(), qPrintable(notes->text()), static_cast<int>(ew::test::kPatience_ms));
    QTRY_VERIFY2_WITH_TIMEOUT(crampedIn(*dialog).isEmpty(), qPrintable(crampedIn(*dialog)), static_cast<int>(ew::test::kPatience_ms));
    // Of the frames the right half alone.
    dialog->findChild<QLineEdit*>(QStringLiteral("clip"))->setText(QStringLiteral("10,0,10,16"));
    QTRY_VERIFY_WITH_TIMEOUT(
        make->isEnabled() && dialog->findChild<QLabel*>(QStringLiteral("importSize"))->text().startsWith(QStringLiteral("10 x 16 x 11")),
        static_cast<int>(ew::test::kPatience_ms));
    make->click();
    QTRY_VERIFY_WITH_TIMEOUT(made != nullptr, static_cast<int>(ew::test::kPatience_ms));
    QCOMPARE(made->grid.dims.x, 10);
    QCOMPARE(made->grid.dims.z, 11);
    QCOMPARE(static_cast<int>(made->echo[made->grid.indexOf(4, 8, 4)]), 80);
  }

  void imagesTakeTheirPosesFromAFileOfTheirOwn() {
    const test::TempFolder folder;
    Sequence sweep = test::evenSweep({}, [](int n, int) { return 60 * n; });
    for (SequenceFrame& frame : sweep.frames) frame.transforms.clear();
    QVERIFY(writeSequence(sweep, folder / "images.igs.mha").has_value());
    DeviceSet device;
    device.transforms = {{"Image", "Probe", glm::dmat4(1.0), PoseStatus::ok}};
    QVERIFY(writeDeviceSet(device, folder / "device.xml").has_value());
    std::string table = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
    for (int n = 0; n < 8; ++n) table += std::to_string(0.1 * n) + ",0,0," + std::to_string(2 * n) + ",1,0,0,0\n";
    const QString poses = QString::fromStdString(folder.put("poses.csv", table).string());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    QPointer<ImportDialog> dialog = new ImportDialog(QString::fromStdString((folder / "images.igs.mha").string()),
                                                     {QString::fromStdString((folder / "device.xml").string())}, jobs, messages, &parent);
    std::shared_ptr<const Volume> made;
    connect(dialog, &ImportDialog::imported,
            [&](const ew::ScanVoxels& voxels, const QString&, const std::shared_ptr<const ew::Provenance>&) { made = voxels.volume(); });
    dialog->show();
    auto* make = dialog->findChild<QPushButton*>(QStringLiteral("makeVolume"));
    auto* notes = dialog->findChild<QLabel*>(QStringLiteral("importNotes"));
    auto* file = dialog->findChild<QLineEdit*>(QStringLiteral("posesFile"));
    QTRY_VERIFY2_WITH_TIMEOUT(notes->text().contains(QStringLiteral("no tracked poses")), qPrintable(notes->text()),
                              static_cast<int>(ew::test::kPatience_ms));
    QVERIFY(!file->isVisible());
    auto* moved = dialog->findChild<QComboBox*>(QStringLiteral("moved"));
    moved->setCurrentIndex(moved->findText(ImportDialog::tr("as a file of poses says")));
    QVERIFY(file->isVisible());
    file->setText(poses);
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("spacing"))->setValue(1.0);
    QTRY_VERIFY2_WITH_TIMEOUT(make->isEnabled(), qPrintable(notes->text()), static_cast<int>(ew::test::kPatience_ms));
    QTRY_VERIFY2_WITH_TIMEOUT(notes->text().contains(QStringLiteral("poses.csv")), qPrintable(notes->text()),
                              static_cast<int>(ew::test::kPatience_ms));
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("timeOffset"))->setValue(0.3);
    QTRY_VERIFY2_WITH_TIMEOUT(make->isEnabled() && notes->text().contains(QStringLiteral("t + 0.3 s")), qPrintable(notes->text()),
                              static_cast<int>(ew::test::kPatience_ms));
    make->click();
    QTRY_VERIFY_WITH_TIMEOUT(made != nullptr, static_cast<int>(ew::test::kPatience_ms));
    QCOMPARE(made->grid.dims.z, 7);
    QVERIFY(std::abs(made->grid.origin_mm.z - 6.0) < 1e-6);
  }

  void theFramesThatCanBeReachedAreOfferedWhenTheSuggestedOneCannot() {
    const test::TempFolder folder;
    const Sequence sweep = test::evenSweep({.from = "Image", .to = "Bed"}, [](int, int) { return 90; });
    const auto file = folder / "bed.igs.mha";
    QVERIFY(writeSequence(sweep, file).has_value());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    QPointer<ImportDialog> dialog = new ImportDialog(QString::fromStdString(file.string()), {}, jobs, messages, &parent);
    dialog->show();
    auto* frame = dialog->findChild<QComboBox*>(QStringLiteral("frame"));
    QTRY_COMPARE_WITH_TIMEOUT(frame->findData(QStringLiteral("Bed")), 1, static_cast<int>(ew::test::kPatience_ms));
    frame->setCurrentIndex(1);
    Q_EMIT frame->activated(1);
    QTRY_VERIFY_WITH_TIMEOUT(dialog->findChild<QPushButton*>(QStringLiteral("makeVolume"))->isEnabled(),
                             static_cast<int>(ew::test::kPatience_ms));
  }

  void whatTheDeviceSetSaysStandsInTheDialogUntilAPersonSaysOtherwise() {
    const test::TempFolder folder;
    const Sequence sweep = test::evenSweep({}, [](int n, int) { return 60 * n; });
    QVERIFY(writeSequence(sweep, folder / "sweep.igs.mha").has_value());
    DeviceSet device;
    device.transforms = {{"Image", "Probe", glm::dmat4(1.0), PoseStatus::ok}};
    device.outputSpacing_mm = glm::dvec3(0.8);
    device.interpolation = "NEAREST_NEIGHBOR";
    device.compounding = "MAXIMUM";
    QVERIFY(writeDeviceSet(device, folder / "device.xml").has_value());
    QWidget parent;
    Jobs jobs;
    MessageBar messages(&parent);
    ImportDialog dialog(QString::fromStdString((folder / "sweep.igs.mha").string()), {}, jobs, messages, &parent);
    dialog.show();
    auto* spacing = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("spacing"));
    auto* interpolation = dialog.findChild<QComboBox*>(QStringLiteral("interpolation"));
    auto* compounding = dialog.findChild<QComboBox*>(QStringLiteral("compounding"));
    auto* calibration = dialog.findChild<QLineEdit*>(QStringLiteral("calibration"));
    calibration->setText(QString::fromStdString((folder / "device.xml").string()));
    const auto chosen = [](const QComboBox* box) { return box->currentData().toInt(); };
    QTRY_COMPARE_WITH_TIMEOUT(chosen(compounding), static_cast<int>(Compounding::maximum), static_cast<int>(ew::test::kPatience_ms));
    QCOMPARE(chosen(interpolation), static_cast<int>(Interpolation::nearest));
    QCOMPARE(spacing->value(), 0.8);
    std::filesystem::remove(folder / "sweep.igs.mha");  // it was read; another calibration needs its poses alone
    compounding->setCurrentIndex(compounding->findData(static_cast<int>(Compounding::latest)));
    Q_EMIT compounding->activated(compounding->currentIndex());
    device.outputSpacing_mm = glm::dvec3(0.6);
    QVERIFY(writeDeviceSet(device, folder / "second.xml").has_value());
    calibration->setText(QString::fromStdString((folder / "second.xml").string()));
    QTRY_COMPARE_WITH_TIMEOUT(spacing->value(), 0.6, static_cast<int>(ew::test::kPatience_ms));
    QCOMPARE(chosen(compounding), static_cast<int>(Compounding::latest));
  }
};

}  // namespace
}  // namespace ew::ui

QTEST_MAIN(ew::ui::ImportTest)
#include "import_test.moc"
