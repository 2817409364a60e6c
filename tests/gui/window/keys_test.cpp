// Keys and controls: the one table and the window agree, keys are changed, kept, shared and taken back, and knobs move settings.
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>

#include "ew/controls/keys_file.h"
#include "ew/ui_test_door/cine.h"
#include "ew/ui_test_door/keys.h"
#include "ew/widgets/words.h"
#include "gui/support/answers.h"
#include "gui/support/console_fixture.h"
#include "made_controls.h"

namespace ew::ui::testing {

class KeysTest : public ConsoleFixture {
  Q_OBJECT

 private:
  std::unique_ptr<test::MadeDesk> desk_;

  [[nodiscard]] KeysDialog* dialog() const { return find<KeysDialog>("keysDialog"); }
  template <class Widget>
  [[nodiscard]] Widget* of(const char* name) const {
    return dialog()->findChild<Widget*>(QLatin1String(name));
  }
  [[nodiscard]] QAction* actionCalled(const QString& text) const {
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text() == text) return each;
    return nullptr;
  }
  void openDialog() {
    QAction* edit = actionCalled(QStringLiteral("Keys and &controls…"));
    QVERIFY(edit != nullptr);
    edit->trigger();
    QVERIFY(dialog() != nullptr && dialog()->isVisible());
    QApplication::setActiveWindow(dialog());
  }
  void choose(const QString& action) const {
    auto* list = of<QTreeWidget>("keyList");
    const auto found = list->findItems(action, Qt::MatchExactly | Qt::MatchRecursive);
    QVERIFY2(found.size() == 1, qPrintable(action));
    list->setCurrentItem(found.front());
  }
  void pressInField(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    auto* field = of<KeyField>("keyField");
    field->setFocus();
    QTest::keyClick(field, static_cast<Qt::Key>(key), modifiers);
  }
  [[nodiscard]] QString said() const { return of<QLabel>("keySaid")->text(); }
  void closeDialog() {
    of<QPushButton>("closeKeysDialog")->click();
    QVERIFY(waitUntil([this] { return dialog() == nullptr; }));
    QApplication::setActiveWindow(window_.get());
  }
  void pressInScan(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    window_->scanView().setFocus();
    QTest::keyClick(&window_->scanView(), static_cast<Qt::Key>(key), modifiers);
  }
  [[nodiscard]] QString ownFile() const { return QFileInfo(QSettings().fileName()).path() + QStringLiteral("/keys.json"); }
  void startAgain() {
    window_.reset();
    showWindowWithCase(files_.path(QStringLiteral("case")));
  }
  [[nodiscard]] QStringList pageOfKeys() {
    QTest::keyClick(window_.get(), Qt::Key_F1);
    auto* page = window_->findChild<ShortcutsOverlay*>();
    if (page == nullptr) return {};
    QStringList texts;
    for (const QLabel* label : page->findChildren<QLabel*>()) texts << label->text();
    page->close();
    QTest::qWait(1);
    return texts;
  }
  void plugIn() {
    desk_ = std::make_unique<test::MadeDesk>();
    desk_->plugged = {{controls::Device::Bus::midi, "Desk", "Desk 20:0", 0, 0},
                      {controls::Device::Bus::hid, "Shuttle", "/dev/hidraw9", 0x0b33, 0x20}};
    window_->surface().setBackends(test::backendOf(*desk_));
  }
  void turn(int control, int value) {
    desk_->send("Desk 20:0", {0xB0, static_cast<std::uint8_t>(control), static_cast<std::uint8_t>(value)});
    QCoreApplication::processEvents();
  }
  void wantTarget(const QString& text) const {
    auto* targets = of<QComboBox>("controlTarget");
    const int index = targets->findText(text);
    QVERIFY2(index >= 0, qPrintable(text));
    targets->setCurrentIndex(index);
  }

 private Q_SLOTS:
  void init() {
    QFile::remove(ownFile());
    openConsole();
  }
  void cleanup() {
    window_.reset();
    desk_.reset();
  }

  void theTableAndTheWindowAreOneList() {
    const KeyMap& keys = window_->keys();
    std::set<std::string> ids;
    for (const KeyCommand& each : keys.commands()) {
      QVERIFY2(ids.insert(each.id).second, each.id.c_str());
      QVERIFY2(!each.name().isEmpty(), each.id.c_str());
      QVERIFY2(!each.usual.contains(QKeySequence()), each.id.c_str());
      QVERIFY2(keys.keysOf(each.id) == each.usual, each.id.c_str());  // else two usual keys collide
    }
    // Every key of the window is one of the table's, and every action of the table is in the window with its text.
    QStringList texts;
    for (const QAction* action : window_->findChildren<QAction*>()) {
      texts << action->text();
      for (const QKeySequence& key : action->shortcuts()) {
        const auto& all = keys.commands();
        const bool isKnown =
            std::any_of(all.begin(), all.end(), [&](const KeyCommand& each) { return keys.keysOf(each.id).contains(key); });
        QVERIFY2(isKnown, qPrintable(action->text() + QLatin1Char(' ') + key.toString()));
      }
    }
    const QStringList otherTexts = {QStringLiteral("Text, on a frozen image"), QStringLiteral("Show the volume that was made")};
    for (const KeyCommand& each : keys.commands()) {
      if (!each.isAction || otherTexts.contains(each.text())) continue;
      QVERIFY2(texts.contains(each.text()), each.id.c_str());
    }
    // The views have the rest: each has a key that its view takes for it.
    for (const KeyCommand& each : keys.commands()) {
      if (each.isAction) continue;
      for (const QKeySequence& key : each.usual) {
        const QKeyEvent press(QEvent::KeyPress, key[0] & ~static_cast<int>(Qt::KeyboardModifierMask),
                              Qt::KeyboardModifiers(key[0] & static_cast<int>(Qt::KeyboardModifierMask)));
        unsigned state = 1;
        while ((each.when & state) == 0) state <<= 1;
        QCOMPARE(keys.meant(press, state), each.id);
      }
    }
  }

  void thePageOfKeysNamesEveryKey() {
    window_->setWorkspace(Workspace::author);
    const QString page = pageOfKeys().join(QLatin1Char('\n'));
    const QStringList byArrows = {QStringLiteral("Left"), QStringLiteral("Right"), QStringLiteral("Up"), QStringLiteral("Down")};
    for (const KeyCommand& each : window_->keys().commands())
      for (const QKeySequence& key : window_->keys().keysOf(each.id)) {
        const QString text = key.toString(QKeySequence::NativeText);
        if (!byArrows.contains(text)) QVERIFY2(page.contains(text), qPrintable(QString::fromStdString(each.id) + QLatin1Char(' ') + text));
      }
    QVERIFY(!page.contains(QStringLiteral("F13")));
    window_->keys().setKeys("cine.save", {QKeySequence(Qt::Key_F13)});  // had none: gets a line
    QVERIFY(pageOfKeys().contains(QStringLiteral("F13")));
  }

  void everyLineOfThePageOfKeysSaysWhatHappens() {
    for (const Workspace workspace : {Workspace::explore, Workspace::author}) {
      window_->setWorkspace(workspace);
      QTest::keyClick(window_.get(), Qt::Key_F1);
      auto* page = window_->findChild<ShortcutsOverlay*>();
      QVERIFY(page != nullptr);
      int lines = 0;
      for (const QGridLayout* grid : page->findChildren<QGridLayout*>()) {
        for (int row = 0; row < grid->rowCount(); ++row) {
          const auto textAt = [&](int column) {
            QLayoutItem* item = grid->itemAtPosition(row, column);
            const auto* label = item != nullptr ? qobject_cast<const QLabel*>(item->widget()) : nullptr;
            return label != nullptr ? label->text() : QString();
          };
          const QString keys = textAt(0), what = textAt(1);
          QVERIFY2(!keys.isEmpty(), qPrintable(what));
          QVERIFY2(!what.isEmpty(), qPrintable(keys));
          QVERIFY2(!what.at(0).isLower(), qPrintable(what));
          QVERIFY2(workspace == Workspace::author || !what.contains(QStringLiteral("handles"), Qt::CaseInsensitive), qPrintable(what));
          ++lines;
        }
      }
      QVERIFY2(lines > 50, qPrintable(QString::number(lines)));
      page->close();
      QTest::qWait(1);
    }
  }

  void aWorkspaceOfAPluginHasItsLine() {
    KeyCommand review;
    review.id = "workspace.review";
    review.source = "Review";
    review.usual = {QKeySequence(QStringLiteral("Ctrl+3"))};
    QVERIFY(window_->keys().add(review));
    const QStringList page = pageOfKeys();
    QVERIFY(page.contains(QStringLiteral("Ctrl+3")) && page.contains(QStringLiteral("Review")));
  }

  void anotherKeyFreezesAndTheFormerOneDoesNot() {
    openDialog();
    choose(QStringLiteral("Freeze"));
    pressInField(Qt::Key_F13);
    QCOMPARE(said(), QStringLiteral("F13 does 'Freeze' from now on."));
    const auto taken = dialog()->findChildren<QPushButton*>(QStringLiteral("takeKey"));
    for (QPushButton* each : taken)
      if (each->text().startsWith(QStringLiteral("Space"))) each->click();
    closeDialog();
    pressInScan(Qt::Key_F13);
    QVERIFY(session().isFrozen());
    pressInScan(Qt::Key_F13);
    QVERIFY(!session().isFrozen());
    pressInScan(Qt::Key_F);
    QVERIFY(session().isFrozen());
    session().setFrozen(false);
    pressInScan(Qt::Key_Space);
    QVERIFY(!session().isFrozen());
    // Menu, tip and page say so.
    QCOMPARE(actionCalled(QStringLiteral("&Freeze"))->shortcuts(),
             (QList<QKeySequence>{QKeySequence(Qt::Key_F), QKeySequence(Qt::Key_F13)}));
    QVERIFY2(find<QPushButton>("freeze")->toolTip().endsWith(QStringLiteral("(F, F13)")),
             qPrintable(find<QPushButton>("freeze")->toolTip()));
    QVERIFY(pageOfKeys().contains(QStringLiteral("F, F13")));
  }

  void aTakenKeyIsToldAndTakenAwayOnlyWhenAsked() {
    openDialog();
    choose(QStringLiteral("Freeze"));
    pressInField(Qt::Key_G);
    QCOMPARE(said(), QStringLiteral("G now does 'Next grey map'. Take it away there?"));
    of<QPushButton>("keyNo")->click();
    QCOMPARE(window_->keys().words("greyMap.next"), QStringLiteral("G"));
    pressInField(Qt::Key_G);
    of<QPushButton>("keyYes")->click();
    QCOMPARE(window_->keys().words("freeze"), QStringLiteral("Space, F, G"));
    QCOMPARE(window_->keys().words("greyMap.next"), QString());
    // Given back with one press, and then it is free again.
    choose(QStringLiteral("Next grey map"));
    of<QPushButton>("resetKey")->click();
    QVERIFY(said().contains(QStringLiteral("Freeze")));
    of<QPushButton>("keyYes")->click();
    QCOMPARE(window_->keys().words("greyMap.next"), QStringLiteral("G"));
    QCOMPARE(window_->keys().words("freeze"), QStringLiteral("Space, F"));
    // Escape is nobody's to give; what a state has of its own does not collide.
    choose(QStringLiteral("Freeze"));
    pressInField(Qt::Key_Tab);
    QCOMPARE(said(), QStringLiteral("Tab does 'Freeze' from now on."));
    of<QPushButton>("resetAllKeys")->click();
    of<QPushButton>("keyYes")->click();
    QVERIFY(window_->keys().own().empty());
  }

  void oneKeyMayMeanTwoThingsInTwoStates() {
    openDialog();
    choose(QStringLiteral("First image"));
    pressInField(Qt::Key_Q);  // rotates the probe while the image runs
    QCOMPARE(said(), QStringLiteral("Q does 'First image' from now on."));
    choose(QStringLiteral("Rock to the left"));
    pressInField(Qt::Key_E);
    QCOMPARE(said(), QStringLiteral("E now does 'Rotate to the right (while the image runs)'. Take it away there?"));
    pressInField(Qt::Key_Q, Qt::ShiftModifier);  // Shift with such a key changes how far it goes
    QCOMPARE(said(), QStringLiteral("Shift+Q now does 'Rotate to the left (while the image runs)'. Take it away there?"));
    closeDialog();
    for (int n = 0; n < 4; ++n) {
      session().probeControl().setHold(turned(session().probeControl().hold(), 0.02, 0.0, 0.0));
      session().makeImageNow();
    }
    const Hold before = session().probeControl().hold();
    pressInScan(Qt::Key_Q);
    QVERIFY(!(session().probeControl().hold() == before));
    session().makeImageNow();
    pressInScan(Qt::Key_F);
    QVERIFY(window_->cineBar().isOpen());
    QVERIFY(window_->cineBar().review().frame() > 0);
    pressInScan(Qt::Key_Q);
    QCOMPARE(window_->cineBar().review().frame(), std::size_t{0});
    QCOMPARE(window_->keys().words("text.writeStill | probe.next"), QStringLiteral("T, T"));
  }

  void keysAreKeptUntilTheNextStartAndSharedAsAFile() {
    openDialog();
    choose(QStringLiteral("Freeze"));
    pressInField(Qt::Key_MediaPlay);
    QCOMPARE(said(), QStringLiteral("Media Play does 'Freeze' from now on."));
    const auto kept = controls::readKeys(ownFile().toStdString());
    QVERIFY(kept.has_value());
    QCOMPARE(kept->keys.size(), std::size_t{1});
    startAgain();
    QCOMPARE(window_->keys().words("freeze"), QStringLiteral("Space, F, Media Play"));
    pressInScan(Qt::Key_MediaPlay);
    QVERIFY(session().isFrozen());
    session().setFrozen(false);

    const QString file = files_.path(QStringLiteral("theirs.json"));
    QVERIFY(controls::writeKeys({{{"freeze", {"F14"}}, {"gain.more", {"F14", "Nonsense"}}, {"tool.Somewhere else", {"Alt+F9"}}}, {}},
                                file.toStdString())
                .has_value());
    openDialog();
    const Answers answers({{QStringLiteral("replaceKeysQuestion"), [](QWidget& question) {
                              for (QAbstractButton* each : static_cast<QMessageBox&>(question).buttons())
                                if (each->text() == QStringLiteral("Take them over")) each->click();
                            }}});
    dialog()->takeFile(file);
    QCOMPARE(window_->keys().words("freeze"), QStringLiteral("F14"));
    QVERIFY2(of<QLabel>("keysFileSaid")->text().contains(QStringLiteral("'F14' is given to 'More gain' and to another action")),
             qPrintable(of<QLabel>("keysFileSaid")->text()));
    QVERIFY(of<QLabel>("keysFileSaid")->text().contains(QStringLiteral("'Nonsense' is the name of no key")));
    QCOMPARE(controls::readKeys(ownFile().toStdString())->keys.count("tool.Somewhere else"),
             std::size_t{1});  // of a plugin that is not here
  }

  void aFileThatIsNoneChangesNothingAndIsNotLost() {
    window_.reset();
    QDir().mkpath(QFileInfo(ownFile()).path());
    QFile broken(ownFile());
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("{ \"format\": 1, \"keys\": { \"freeze\": [");
    broken.close();
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY2(window_->messages().text().contains(QStringLiteral("keys")), qPrintable(window_->messages().text()));
    QCOMPARE(window_->keys().words("freeze"), QStringLiteral("Space, F"));
    openDialog();
    choose(QStringLiteral("Freeze"));
    pressInField(Qt::Key_F15);
    QFile aside(QFileInfo(ownFile()).path() + QStringLiteral("/keys-unreadable-1.json"));
    QVERIFY(aside.open(QIODevice::ReadOnly));
    QVERIFY(aside.readAll().startsWith("{ \"format\": 1, \"keys\""));
    aside.remove();
    QVERIFY(controls::readKeys(ownFile().toStdString()).has_value());
    dialog()->takeFile(files_.path(QStringLiteral("none.json")));
    QVERIFY(of<QLabel>("keysFileSaid")->text().endsWith(QStringLiteral("Your keys stay as they are.")));
    QCOMPARE(window_->keys().words("freeze"), QStringLiteral("Space, F, F15"));
  }

  void theListIsFiltered() {
    openDialog();
    auto* list = of<QTreeWidget>("keyList");
    const auto seen = [&] {
      int count = 0;
      for (QTreeWidgetItemIterator each(list, QTreeWidgetItemIterator::NotHidden | QTreeWidgetItemIterator::NoChildren); *each != nullptr;
           ++each)
        if ((*each)->parent() != nullptr && !(*each)->parent()->isHidden()) ++count;
      return count;
    };
    QCOMPARE(seen(), static_cast<int>(window_->keys().commands().size()));
    of<QLineEdit>("findKey")->setText(QStringLiteral("3d front"));
    QCOMPARE(seen(), 1);
    of<QLineEdit>("findKey")->setText(QStringLiteral("Ctrl+Shift+C"));
    QCOMPARE(seen(), 1);
    of<QLineEdit>("findKey")->setText(QStringLiteral("nothing at all"));
    QCOMPARE(seen(), 0);
  }

  void aLearntKnobMovesTheGainOnceItHasComeToIt() {
    plugIn();
    openDialog();
    window_->surface().takeNow();
    QVERIFY2(of<QLabel>("controlDevices")->text().contains(QStringLiteral("Desk (MIDI), Shuttle (HID)")),
             qPrintable(of<QLabel>("controlDevices")->text()));
    wantTarget(QStringLiteral("Console: Gain"));
    of<QPushButton>("learnControl")->click();
    QVERIFY(of<QLabel>("learning")->text().startsWith(QStringLiteral("Turn the knob")));
    for (int value = 10; value < 16; ++value) turn(20, value);
    QCOMPARE(of<QLabel>("learning")->text(), QStringLiteral("Bound. It acts from now on."));
    QCOMPARE(of<QTreeWidget>("controlList")->topLevelItemCount(), 1);
    closeDialog();

    auto* gain = find<QSlider>("gain");
    gain->setValue((gain->minimum() + gain->maximum()) / 2);
    const int before = gain->value();
    turn(20, 20);
    QCOMPARE(gain->value(), before);  // nothing jumps
    turn(20, 40);
    QCOMPARE(gain->value(), before);
    turn(20, 80);  // past it
    QCOMPARE(gain->value(), gain->minimum() + static_cast<int>(std::lround(80.0 / 127.0 * (gain->maximum() - gain->minimum()))));
    turn(20, 127);
    QCOMPARE(gain->value(), gain->maximum());
    turn(20, 0);
    QCOMPARE(gain->value(), gain->minimum());
    const int middle = (gain->minimum() + gain->maximum()) / 2;
    gain->setValue(middle);  // by the mouse: the knob has to come to it again
    turn(20, 5);
    QCOMPARE(gain->value(), middle);

    startAgain();
    window_->surface().setBackends(test::backendOf(*desk_));
    window_->surface().takeNow();
    QCOMPARE(window_->surface().bindings().size(), std::size_t{1});
    find<QSlider>("gain")->setValue(find<QSlider>("gain")->minimum());
    turn(20, 0);
    turn(20, 64);
    QVERIFY(find<QSlider>("gain")->value() > find<QSlider>("gain")->minimum());
  }

  void aButtonFreezesAndAJogWheelTilts() {
    plugIn();
    openDialog();
    window_->surface().takeNow();
    wantTarget(QStringLiteral("Button: Image: Freeze"));
    of<QPushButton>("learnControl")->click();
    window_->surface().takeNow();
    const auto report = [this](int jog, int buttons) {
      desk_->send("/dev/hidraw9", {0, static_cast<std::uint8_t>(jog), 0, static_cast<std::uint8_t>(buttons), 0});
      QCoreApplication::processEvents();
    };
    report(250, 0);
    report(250, 0x10);
    report(250, 0);
    wantTarget(QStringLiteral("Probe: Tilt"));
    of<QPushButton>("learnControl")->click();
    for (int jog = 251; jog < 260; ++jog) report(jog & 255, 0);
    QCOMPARE(window_->surface().bindings().size(), std::size_t{2});
    QVERIFY(window_->surface().bindings()[1].encoding == controls::Encoding::counter);
    const Hold before = session().probeControl().hold();
    report(3, 0);
    report(8, 0);  // 5 steps, 1 degree each
    const Hold after = session().probeControl().hold();
    QVERIFY(!(before == after));
    QVERIFY(after == turned(before, 0.0, 0.0, glm::radians(5.0)));
    report(8, 0x10);
    QVERIFY(session().isFrozen());
    report(8, 0);
    report(8, 0x10);
    QVERIFY(!session().isFrozen());
    // Removed: it does nothing any more.
    auto* list = of<QTreeWidget>("controlList");
    list->setCurrentItem(list->topLevelItem(0));
    of<QPushButton>("removeControl")->click();
    report(8, 0);
    report(8, 0x10);
    QVERIFY(!session().isFrozen());
    QCOMPARE(controls::readKeys(ownFile().toStdString())->controls.size(), std::size_t{1});
  }

  void everyControlHasItsNameAndItsTip() {
    openDialog();
    for (const QWidget* each : dialog()->findChildren<QWidget*>()) {
      const bool isControl = qobject_cast<const QAbstractButton*>(each) != nullptr || qobject_cast<const QComboBox*>(each) != nullptr ||
                             qobject_cast<const QLineEdit*>(each) != nullptr;
      if (!isControl || each->objectName().isEmpty() || each->objectName().startsWith(QStringLiteral("qt_")) ||
          each->objectName().startsWith(QStringLiteral("Scroll")))
        continue;
      QVERIFY2(!each->toolTip().isEmpty(), qPrintable(each->objectName()));
      if (each->objectName() != QStringLiteral("keyYes")) QVERIFY2(!each->accessibleName().isEmpty(), qPrintable(each->objectName()));
    }
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::KeysTest)
#include "keys_test.moc"
