#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPixmap>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "ew/io/safe_file.h"
#include "file_import_dialog.h"
#include "jobs.h"
#include "message_bar.h"
#include "time_limit.h"

namespace ew::ui {
namespace {

/// The dialog that asks what a file leaves open, without the window around it.
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
    connect(dialog, &FileImportDialog::imported, [&](const std::shared_ptr<const ew::Volume>& volume, const QString&) { made = volume; });
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
};

}  // namespace
}  // namespace ew::ui

QTEST_MAIN(ew::ui::ImportTest)
#include "import_test.moc"
