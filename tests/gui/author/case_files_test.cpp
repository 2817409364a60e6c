// An author in the real window looks at the files of a case, takes one out that nothing uses, and puts it back.
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>

#include "ew/io/safe_file.h"
#include "gui/support/answers.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class CaseFilesTest : public WindowFixture {
  Q_OBJECT

  /// Opens a case in Author, with the Case panel in front.
  void author(const QString& folder) {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    session().frames().setAdaptive(false);
    window_->openPlugins();
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
    QVERIFY(openCase(folder));
    window_->setWorkspace(Workspace::author);
    QTest::qWait(50);
    QVERIFY(window_->findChild<QWidget*>(QStringLiteral("casePanel")) != nullptr);
  }
  [[nodiscard]] static QWidget* topLevel(const char* name) {
    for (QWidget* each : QApplication::topLevelWidgets())
      if (each->objectName() == QLatin1String(name) && each->isVisible()) return each;
    return nullptr;
  }
  [[nodiscard]] QWidget* publishDialog() {
    window_->findChild<QPushButton*>(QStringLiteral("publishCase"))->click();
    QWidget* dialog = nullptr;
    if (!waitUntil([&] { return (dialog = topLevel("publishDialog")) != nullptr; })) return nullptr;
    if (!waitUntil([&] { return lineOf(*dialog) != nullptr; })) return nullptr;
    return dialog;
  }
  /// The line of the list before publishing that is about files.
  [[nodiscard]] static QToolButton* lineOf(const QWidget& dialog) {
    for (auto* each : dialog.findChildren<QToolButton*>())
      if (each->property("field").toString() == QLatin1String("files")) return each;
    return nullptr;
  }

 private Q_SLOTS:
  void cleanup() { window_.reset(); }

  void filesThatNothingUsesAreTakenOutOfTheCaseAndPutBack() {
    const QString folder = files_.writeCase(QStringLiteral("with-files"));
    const QString other = folder + QStringLiteral("/other.mha");
    QVERIFY(writeFileSafely(other.toStdString(), "of another patient"));
    author(folder);
    QWidget* publish = publishDialog();
    QVERIFY(publish != nullptr);
    auto* line = lineOf(*publish);
    QVERIFY(line != nullptr && line->isEnabled());
    QVERIFY2(line->accessibleName().contains(QStringLiteral("other.mha")), qPrintable(line->accessibleName()));
    line->click();
    QWidget* dialog = nullptr;
    QVERIFY(waitUntil([&] { return (dialog = topLevel("filesDialog")) != nullptr; }));
    auto* list = dialog->findChild<QTreeWidget*>(QStringLiteral("caseFileList"));
    auto* out = dialog->findChild<QPushButton*>(QStringLiteral("takeFilesOut"));
    const auto row = [list](const char* file) -> QTreeWidgetItem* {
      const auto found = list->findItems(QLatin1String(file), Qt::MatchExactly, 0);
      return found.isEmpty() ? nullptr : found.front();
    };
    QVERIFY(waitUntil([&] { return row("other.mha") != nullptr && row("case.json") != nullptr; }));
    QCOMPARE(row("other.mha")->text(2), QStringLiteral("nothing"));
    QCOMPARE(row("case.json")->text(2), QStringLiteral("the case itself"));
    row("case.json")->setSelected(true);
    QVERIFY2(!out->isEnabled(), "what is in use stays");
    list->clearSelection();
    row("other.mha")->setSelected(true);
    QVERIFY(out->isEnabled());
    keepScreenshot(*dialog, "files-1");
    {
      const Answers no({});
      out->click();
      QCOMPARE(no.asked, QStringList{QStringLiteral("takeOutQuestion")});
    }
    QVERIFY(QFile::exists(other));
    {
      const Answers yes({{QStringLiteral("takeOutQuestion"), press("takeOutNow")}});
      out->click();
    }
    QVERIFY(waitUntil([&] { return !QFile::exists(other) && row("other.mha") == nullptr; }));
    QVERIFY2(waitUntil([&] {
               line = lineOf(*publish);
               return line != nullptr && !line->accessibleName().contains(QStringLiteral("other.mha"));
             }),
             "the list before publishing has heard of it");
    keepScreenshot(*dialog, "files-2-taken-out");
    auto* back = dialog->findChild<QPushButton*>(QStringLiteral("putFilesBack"));
    QVERIFY(waitUntil([&] { return back->isEnabled(); }));
    back->click();
    QVERIFY(waitUntil([&] { return QFile::exists(other) && row("other.mha") != nullptr; }));
    dialog->close();
    publish->close();
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::CaseFilesTest)
#include "case_files_test.moc"
