#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "ew/ui_test_door/messages.h"

namespace ew::ui {
namespace {

QString text(const char* words) { return QString::fromLatin1(words); }

/// The bar that says what happened, without the window around it.
class MessagesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theNewestErrorStandsInFrontOfWhatWasSaidBefore() {
    QWidget parent;
    MessageBar bar(&parent);
    for (int n = 0; n < 11; ++n) bar.showNote(text("An old note %1.").arg(n));
    bar.showError(text("The first file cannot be read."));
    bar.showError(text("The second file cannot be read."));
    bar.showNote(text("Saved."));
    QVERIFY(bar.isError());
    QCOMPARE(bar.text(), text("The second file cannot be read."));
    QCOMPARE(bar.count(), 14);
    bar.dismiss();
    QCOMPARE(bar.text(), text("The first file cannot be read."));
    bar.dismiss();
    QVERIFY(!bar.isError());
    QCOMPARE(bar.text(), text("Saved."));
    bar.dismiss();
    QCOMPARE(bar.text(), text("An old note 10."));
  }

  void theSameActionDoneAgainTakesThePlaceOfItsFirstMessage() {
    QWidget parent;
    MessageBar bar(&parent);
    bar.showNote(text("Something else."), text("open"));
    bar.showError(text("a.mha cannot be written."), text("save a.mha"));
    bar.showError(text("b.mha cannot be written."), text("save b.mha"));
    bar.showNote(text("Saved to a.mha."), text("save a.mha"));
    QCOMPARE(bar.text(), text("b.mha cannot be written."));
    QCOMPARE(bar.count(), 3);
    bar.forget(text("save b.mha"));
    QVERIFY(!bar.isError());
    QCOMPARE(bar.text(), text("Saved to a.mha."));
  }

  void theSameSentenceIsCountedOnce() {
    QWidget parent;
    MessageBar bar(&parent);
    bar.showError(text("No such file."));
    bar.showNote(text("Saved."));
    bar.showError(text("No such file."));
    QCOMPARE(bar.count(), 2);
  }

  void aNotePassesOnceItWasInSightAndAnErrorStays() {
    QWidget parent;
    MessageBar bar(&parent);
    const auto* passes = bar.findChild<QTimer*>(text("notePasses"));
    QVERIFY(passes != nullptr && !passes->isActive());
    bar.showNote(text("Said."));
    QVERIFY(passes->isActive());
    bar.showError(text("It went wrong."));
    QVERIFY2(!passes->isActive(), "nobody sees the note, and an error is for a person to dismiss");
    bar.dismiss();
    QVERIFY(passes->isActive());
    bar.showNotes(text("Several."), {verbatim("One."), verbatim("Two.")});
    bar.findChild<QPushButton*>(text("unfoldMessage"))->setChecked(true);
    QVERIFY2(!passes->isActive(), "it is being read");
    bar.findChild<QPushButton*>(text("unfoldMessage"))->setChecked(false);
    bar.setNotesPassAfter(1);
    QTRY_COMPARE(bar.count(), 0);
  }

  void whatAnImportHasToSayIsOneMessageWithAFold() {
    QWidget parent;
    parent.resize(800, 400);
    MessageBar bar(&parent);
    bar.resize(800, 200);
    parent.show();
    bar.showNotes(text("a.dcm was imported; 3 notes."), {verbatim("One."), verbatim("Two."), verbatim("Three.")}, text("open"));
    QCOMPARE(bar.count(), 1);
    QCOMPARE(bar.text(), text("a.dcm was imported; 3 notes."));
    auto* unfold = bar.findChild<QPushButton*>(text("unfoldMessage"));
    auto* details = bar.findChild<QLabel*>(text("messageDetails"));
    QVERIFY(unfold->isVisible());
    QVERIFY(!details->isVisible());
    unfold->click();
    QVERIFY(details->isVisible());
    QCOMPARE(details->text(), text("One.\nTwo.\nThree."));
    bar.showNotes(text("1 note."), {verbatim("A single one says itself.")}, text("open"));
    QCOMPARE(bar.count(), 1);
    QCOMPARE(bar.text(), text("A single one says itself."));
    QVERIFY(!unfold->isVisible());
    QVERIFY(!details->isVisible());
    bar.showNotes(text("none"), {}, text("open"));
    QCOMPARE(bar.count(), 0);
    QVERIFY(!bar.isVisible());
  }

  void whoPressesMeansTheMessageThatWasInSight() {
    QWidget parent;
    parent.resize(800, 400);
    MessageBar bar(&parent);
    bar.resize(800, 200);
    parent.show();
    auto* dismiss = bar.findChild<QPushButton*>(text("dismissMessage"));
    bar.showNote(text("Saved."));
    QTest::mousePress(dismiss, Qt::LeftButton);
    bar.showError(text("The disk is full."));
    QTest::mouseRelease(dismiss, Qt::LeftButton);
    QCOMPARE(bar.text(), text("The disk is full."));
    QCOMPARE(bar.count(), 1);
    // Said again it is the same, also to whoever is just dismissing it; said otherwise it is not.
    QTest::mousePress(dismiss, Qt::LeftButton);
    bar.showError(text("The disk is full."));
    QTest::mouseRelease(dismiss, Qt::LeftButton);
    QCOMPARE(bar.count(), 0);
    bar.showError(text("a.mha cannot be written."), text("save"));
    QTest::mousePress(dismiss, Qt::LeftButton);
    bar.showError(text("b.mha cannot be written."), text("save"));
    QTest::mouseRelease(dismiss, Qt::LeftButton);
    QCOMPARE(bar.text(), text("b.mha cannot be written."));
    dismiss->click();
    QCOMPARE(bar.count(), 0);
  }

  void whoTakesAnOfferTakesTheOneThatWasInSight() {
    QWidget parent;
    parent.resize(800, 400);
    MessageBar bar(&parent);
    bar.resize(800, 200);
    parent.show();
    QStringList taken;
    const auto offer = [&](const char* name, const char* topic) {
      bar.showOffer(
          text("%1 is ready.").arg(text(name)), text("Open"), [&taken, name] { taken << text(name); }, text(topic));
    };
    auto* open = bar.findChild<QPushButton*>(text("takeOffer"));
    offer("A", "a");
    QTest::mousePress(open, Qt::LeftButton);
    offer("B", "b");
    QTest::mouseRelease(open, Qt::LeftButton);
    QCOMPARE(taken, QStringList{text("A")});
    QCOMPARE(bar.text(), text("B is ready."));
    QTest::mousePress(open, Qt::LeftButton);
    offer("C", "b");  // in its place
    QTest::mouseRelease(open, Qt::LeftButton);
    QCOMPARE(taken, QStringList{text("A")});
    open->click();
    QCOMPARE(taken, (QStringList{text("A"), text("C")}));
    QCOMPARE(bar.count(), 0);
  }

  void onlyWhatConcernsTheProgramIsLeftWhenSomethingElseIsOpen() {
    QWidget parent;
    MessageBar bar(&parent);
    bar.showError(text("A plugin cannot be loaded."));
    bar.showError(text("old.mha is truncated."), text("open"));
    bar.showNote(text("Spacing is unknown."), text("open"));
    bar.showNote(text("Saved."), text("save x"));
    bar.forgetWhatIsPast();
    QCOMPARE(bar.count(), 1);
    QCOMPARE(bar.text(), text("A plugin cannot be loaded."));
  }
};

}  // namespace
}  // namespace ew::ui

QTEST_MAIN(ew::ui::MessagesTest)
#include "messages_test.moc"
