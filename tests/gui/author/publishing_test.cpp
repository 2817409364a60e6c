// An author in the real window sees what is missing, publishes and exports; a trainee elsewhere imports it, and what somebody else edits is
// edited as a copy. EW_SCREENSHOTS=DIR keeps images of every step.
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>

#include "ew/io/safe_file.h"
#include "ew/library/bundle.h"
#include "ew/library/case.h"
#include "ew/library/folder_lease.h"
#include "ew/library/published.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/answers.h"
#include "gui/support/author_fixture.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"

namespace ew::ui::testing {

class PublishingTest : public AuthorFixture {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { window_.reset(); }

  void theListBeforePublishingLeadsToItsFieldsAndTheCaseIsPublishedExportedAndImported() {
    showWindow();
    const QString folder = files_.writeCase(QStringLiteral("published"));
    author(folder);
    QWidget* dialog = publishDialog();
    QVERIFY(dialog != nullptr);
    auto* now = dialog->findChild<QPushButton*>(QStringLiteral("publishNow"));
    QVERIFY(!now->isEnabled());
    keepScreenshot(*dialog, "publish-1-missing");
    QVERIFY(itemFor(*dialog, QStringLiteral("findings")) != nullptr);
    auto* head = inPanel<QToolButton>("head_findings");
    if (head->isChecked()) head->click();
    QVERIFY(!inPanel<QPlainTextEdit>("findings")->isVisible());
    itemFor(*dialog, QStringLiteral("findings"))->click();
    QVERIFY(waitUntil([this] { return inPanel<QPlainTextEdit>("findings")->isVisible(); }));
    // What is typed next is for the field, and not for a button of the list, which stays in sight: a space pressed Export.
    auto* findings = inPanel<QPlainTextEdit>("findings");
    QVERIFY2(waitUntil([&] { return QApplication::focusWidget() == findings; }),
             QApplication::focusWidget() != nullptr ? qPrintable(QApplication::focusWidget()->objectName()) : "nothing has the keys");
    QVERIFY(QApplication::activeWindow() == window_.get() && dialog->isVisible());
    {
      const Answers nothing({});
      QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("No stone."));
      QVERIFY2(nothing.asked.isEmpty(), qPrintable(nothing.asked.join(QLatin1Char(' '))));
    }
    QCOMPARE(findings->toPlainText(), QStringLiteral("No stone."));
    QVERIFY2(waitUntil([this] { return inPanel<QLabel>("missing_case")->text().contains(QStringLiteral("missing")); }),
             qPrintable(inPanel<QLabel>("missing_case")->text()));
    keepScreenshot(*window_, "publish-2-led");
    fill();
    QVERIFY(waitUntil([&] { return now->isEnabled(); }));
    keepScreenshot(*dialog, "publish-3-ready");
    now->click();
    auto* result = dialog->findChild<QLabel*>(QStringLiteral("publishResult"));
    QVERIFY(waitUntil([&] { return !result->isHidden(); }));
    QVERIFY2(result->text().startsWith(QStringLiteral("Published as revision 1")), qPrintable(result->text()));
    QVERIFY(!document().hasUnsavedChanges());
    const auto latest = latestPublished(libraryFolder(), document().current()->id);
    QVERIFY(latest.has_value());
    keepScreenshot(*dialog, "publish-4-done");
    now->click();
    QVERIFY(waitUntil([&] { return result->text().startsWith(QStringLiteral("Nothing has changed")); }));

    const QString bundle = files_.path(QStringLiteral("out.ewcase"));
    auto answers = std::make_unique<Answers>(std::map<QString, Answers::Answer>{{QStringLiteral("fileDialog"), type(bundle)}});
    dialog->findChild<QPushButton*>(QStringLiteral("exportCase"))->click();
    answers.reset();  // it would turn down the questions that follow
    QVERIFY(waitUntil([&] { return result->text().startsWith(QStringLiteral("Revision 1 was exported")); }));
    QVERIFY(aside([&] { return verifyBundle(bundle.toStdString()); }).has_value());
    // The name is completed before it is asked about: "final" is "final.ewcase", which somebody has already.
    const QString others = files_.path(QStringLiteral("final.ewcase"));
    QVERIFY(writeFileSafely(others.toStdString(), "precious"));
    {
      const Answers keep({{QStringLiteral("fileDialog"), type(files_.path(QStringLiteral("final")))},
                          {QStringLiteral("replaceQuestion"), press(QMessageBox::Cancel)}});
      dialog->findChild<QPushButton*>(QStringLiteral("exportCase"))->click();
      QCOMPARE(keep.asked, (QStringList{QStringLiteral("fileDialog"), QStringLiteral("replaceQuestion")}));
    }
    QFile still(others);
    QVERIFY(still.open(QIODevice::ReadOnly) && still.readAll() == "precious");
    dialog->close();
    window_.reset();

    // Elsewhere: another home, a trainee.
    qputenv("ECHOWEAVE_LIBRARY", files_.path(QStringLiteral("elsewhere")).toUtf8());
    qputenv("ECHOWEAVE_CASES", files_.path(QStringLiteral("elsewhere/cases")).toUtf8());
    showWindow();
    window_->open(bundle);
    QVERIFY(waitUntil([this] { return latestPublished(libraryFolder(), "window-test").has_value() && window_->isSettled(); }));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
    QVERIFY2(window_->messages().text().contains(QStringLiteral("revision 1")), qPrintable(window_->messages().text()));
    QVERIFY(!window_->messages().text().contains(QStringLiteral("Window test")));  // a trainee reads the title for trainees
    auto* cards = find<QWidget>("caseCards");
    QVERIFY(cards != nullptr && cards->isVisible());
    auto* list = qobject_cast<CardView*>(cards);
    QVERIFY(waitUntil([&] { return list->currentIndex().isValid(); }));
    QCOMPARE(list->currentIndex().data().toString(), QStringLiteral("Upper abdomen, routine"));
    keepScreenshot(*window_, "imported");
    window_->open(bundle);
    QVERIFY(waitUntil([this] { return window_->messages().text().contains(QStringLiteral("already")); }));

    // Published cases are saved as one's own.
    QVERIFY(openCase(QString::fromStdString(latestPublished(libraryFolder(), "window-test")->folder.string())));
    window_->setWorkspace(Workspace::author);
    QTest::qWait(50);
    inPanel<QLineEdit>("title")->setText(QString());
    QTest::keyClicks(inPanel<QLineEdit>("title"), QStringLiteral("Mine"));
    const auto refused = document().save();
    QVERIFY(!refused && refused.error().sentence().find("Published cases") != std::string::npos);
    Answers asked({{QStringLiteral("caseFolderDialog"), [](QWidget& shown) {
                      keepScreenshot(shown, "published-copy");
                      shown.findChild<QLineEdit*>(QStringLiteral("caseFolderName"))->setText(QStringLiteral("mine"));
                      shown.findChild<QPushButton*>(QStringLiteral("saveCaseFolder"))->click();
                    }}});
    inPanel<QPushButton>("save")->click();
    QVERIFY(asked.asked.contains(QStringLiteral("caseFolderDialog")));
    QCOMPARE(loadCaseAside(ownCasesFolder() / "mine")->title, std::string("Mine"));
    QVERIFY(aside([&] { return verifyBundle(bundle.toStdString()); }).has_value());
    qputenv("ECHOWEAVE_LIBRARY", files_.path(QStringLiteral("library")).toUtf8());
    qputenv("ECHOWEAVE_CASES", files_.path(QStringLiteral("own cases")).toUtf8());
  }

  void aDamagedBundleIsRefusedInASentenceAndTheLibraryStays() {
    const QString bundle = files_.path(QStringLiteral("broken.ewcase"));
    QVERIFY(writeFileSafely(bundle.toStdString(), "this is no bundle").has_value());
    showWindow();
    const auto before = listPublished(libraryFolder());
    window_->open(bundle);
    QVERIFY(waitUntil([this] { return window_->messages().isError(); }));
    QVERIFY(window_->messages().text().contains(QStringLiteral("broken.ewcase")));
    QVERIFY(listPublished(libraryFolder()) == before);
  }

  void whatSomebodyElseEditsIsNotEditedHereButACopyIs() {
    const QString folder = files_.writeCase(QStringLiteral("theirs"));
    showWindow();
    author(folder);
    auto theirs = FolderLease::take(folder.toStdString());
    QVERIFY(theirs.has_value());
    auto* title = inPanel<QLineEdit>("title");
    title->setFocus();
    title->end(false);
    QTest::keyClicks(title, QStringLiteral("!"));
    QCOMPARE(document().current()->title, std::string("Window test"));
    QCOMPARE(title->text(), QStringLiteral("Window test"));
    auto* row = inPanel<QWidget>("takenRow");
    QVERIFY(row->isVisible());
    QVERIFY(inPanel<QLabel>("takenWhy")->text().contains(QStringLiteral("being edited by")));
    keepScreenshot(*window_, "taken");
    Answers answers({{QStringLiteral("caseFolderDialog"), [](QWidget& shown) {
                        shown.findChild<QLineEdit*>(QStringLiteral("caseFolderName"))->setText(QStringLiteral("a copy"));
                        shown.findChild<QPushButton*>(QStringLiteral("saveCaseFolder"))->click();
                      }}});
    inPanel<QPushButton>("openCopy")->click();
    QVERIFY(answers.asked.contains(QStringLiteral("caseFolderDialog")));
    QVERIFY(!row->isVisible());
    title->end(false);
    QTest::keyClicks(title, QStringLiteral("!"));
    QCOMPARE(document().current()->title, std::string("Window test!"));
    QVERIFY(document().save().has_value());
    QCOMPARE(loadCaseAside(folder.toStdString())->title, std::string("Window test"));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::PublishingTest)
#include "publishing_test.moc"
