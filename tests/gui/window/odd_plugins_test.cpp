// Plugins that throw, in the real window: it stays, says one sentence that names the plugin, and keeps nothing of one that could not start.
#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTimer>
#include <nlohmann/json.hpp>

#include "ew/door/door.h"
#include "ew/ui_test_door/window.h"
#include "gui/support/answers.h"
#include "gui/support/window_fixture.h"

namespace ew::ui {
namespace {

class OddPluginsTest final : public testing::WindowFixture {
  Q_OBJECT

 private:
  /// A window with the odd plugin alone.
  void openWindow() {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QVERIFY(testing::waitUntil([this] { return !window_->jobs().isRunning(); }));
    dismissAll();
    window_->openPlugins();
  }
  void openWindowWithCase() {
    openWindow();
    QVERIFY(openCase(folder_));
    window_->setWorkspace(Workspace::author);
  }
  void dismissAll() const {
    while (window_->messages().count() > 0) window_->messages().dismiss();
  }
  [[nodiscard]] QTabWidget& panels() const { return *find<QTabWidget>("authorPanel"); }
  void showPanel(const char* id) const {
    auto* panel = find<QWidget>((std::string("panel_") + id).c_str());
    QVERIFY2(panel != nullptr, id);
    panels().setCurrentWidget(panel);
  }
  /// Whether the window comes to say exactly one sentence, of the odd plugin and with `why` in it; the sentence is dismissed.
  [[nodiscard]] bool saysOnce(const QString& why) const {
    if (!testing::waitUntil([this] { return window_->messages().count() > 0 && !window_->jobs().isRunning(); })) return false;
    const QString said = window_->messages().text();
    const int count = window_->messages().count();
    dismissAll();
    if (count == 1 && said.contains(QStringLiteral("'Odd one'")) && said.contains(why)) return true;
    qWarning("%d sentences, the first: %s", count, qPrintable(said));
    return false;
  }
  void trigger(const QKeySequence& keys) const {
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->shortcuts().contains(keys)) return action->trigger();
    QFAIL(qPrintable(keys.toString()));
  }

  QString folder_;

 private Q_SLOTS:
  void initTestCase() {
    folder_ = files_.writeCase(QStringLiteral("case"));
    QVERIFY(!folder_.isEmpty());
    const QString plugins = files_.path(QStringLiteral("plugins"));
    QDir().mkpath(plugins + QStringLiteral("/odd"));
    QVERIFY(QFile::copy(QStringLiteral(EW_ODD_PLUGIN_DIR "/odd_window.so"), plugins + QStringLiteral("/odd/odd_window.so")));
    const nlohmann::json manifest = {
        {"name", "odd"}, {"title", "Odd one"}, {"version", "1.0.0"}, {"abi", sdk::kAbi}, {"library", "odd_window.so"}};
    QVERIFY(writeFileSafely(plugins.toStdString() + "/odd/plugin.json", manifest.dump()).has_value());
    qputenv("ECHOWEAVE_PLUGINS", plugins.toUtf8());
  }
  void init() {
    qunsetenv("ODD_WINDOW");
    qunsetenv("ODD_WINDOW_NUMBER");
    qunsetenv("ODD_WINDOW_UNSAVED");
  }
  void cleanup() { window_.reset(); }

  void whatAPluginThatCouldNotStartRegisteredIsTakenBack_data() {
    QTest::addColumn<bool>("number");
    QTest::newRow("exception") << false;
    QTest::newRow("number") << true;
  }
  void whatAPluginThatCouldNotStartRegisteredIsTakenBack() {
    QFETCH(bool, number);
    qputenv("ODD_WINDOW", "create");
    qputenv("ODD_WINDOW_NUMBER", number ? "yes" : "no");
    openWindow();
    QVERIFY(saysOnce(QStringLiteral("could not start")));
    for (const char* id : {"panel_odd_column", "panel_odd_stage"}) QVERIFY2(find<QWidget>(id) == nullptr, id);
    QVERIFY(openCase(folder_));  // nobody is told who is gone
    window_->setWorkspace(Workspace::author);
    QTest::qWait(50);
    QCOMPARE(window_->messages().count(), 0);
  }

  void aCallbackThatThrowsIsOneSentenceAndTheWindowGoesOn_data() { whatAPluginThatCouldNotStartRegisteredIsTakenBack_data(); }
  void aCallbackThatThrowsIsOneSentenceAndTheWindowGoesOn() {
    QFETCH(bool, number);
    qputenv("ODD_WINDOW_NUMBER", number ? "yes" : "no");
    openWindow();
    QCOMPARE(window_->messages().count(), 0);
    QVERIFY(openCase(folder_));
    QVERIFY(saysOnce(QStringLiteral("change of the case")));
    window_->setWorkspace(Workspace::author);

    showPanel("odd_column");
    QVERIFY(saysOnce(QStringLiteral("'Odd column'")));
    QVERIFY(find<QWidget>("halfMade") == nullptr);
    QVERIFY(find<QLabel>("panelProblem") != nullptr && find<QLabel>("panelProblem")->isVisible());

    showPanel("odd_stage");
    QVERIFY(saysOnce(QStringLiteral("could not say what its panel holds")));  // the note for the status line
    trigger(QKeySequence::Undo);
    QVERIFY(saysOnce(QStringLiteral("could not undo")));
    trigger(QKeySequence::Redo);
    QVERIFY(saysOnce(QStringLiteral("could not redo")));
    trigger(QKeySequence::Save);
    QVERIFY(saysOnce(QStringLiteral("could not save")));
    trigger(QKeySequence::Save);
    QCOMPARE(window_->messages().count(), 0);  // a kind is told once

    const auto press = [this](const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); };
    press("failInWork");
    QVERIFY(saysOnce(QStringLiteral("'Odd work'")));
    press("failInDone");
    QVERIFY(saysOnce(QStringLiteral("'Odd ending'")));
    press("failAtOnce");
    QVERIFY(saysOnce(QStringLiteral("did not foresee")));
    press("failAtOnce");
    QCOMPARE(window_->messages().count(), 0);

    window_->setWorkspace(Workspace::explore);
    QVERIFY(testing::waitUntil([this] { return window_->isSettled(); }));
    QVERIFY(openCase(folder_));  // the window still does what it is for
    QCOMPARE(window_->messages().count(), 0);
  }

  void aDocumentThatIsNotSavedIsAskedAboutBeforeTheWindowCloses() {
    qputenv("ODD_WINDOW_UNSAVED", "yes");
    openWindow();
    const QString question = QStringLiteral("unsavedPluginQuestion");
    {
      const testing::Answers answers({{question, testing::press(QMessageBox::Save)}});
      QVERIFY(!window_->close());  // its document cannot be saved, so nothing is lost by closing
      QCOMPARE(answers.asked, QStringList{question});
      QCOMPARE(answers.texts, QStringList{QStringLiteral("The odd project is not saved.")});
    }
    QVERIFY(saysOnce(QStringLiteral("could not save")));
    const testing::Answers answers({{question, testing::press(QMessageBox::Discard)}});
    QVERIFY(window_->close());
    QCOMPARE(answers.asked, QStringList{question});
  }

  void whatAHandlerOfTheWindowThrowsIsASentenceAndUnsavedWorkStays() {
    openWindowWithCase();
    dismissAll();
    Case changed = *window_->document().current();
    changed.title = "Edited";
    QVERIFY(window_->document().edit(changed, "Title", "").has_value());
    dismissAll();
    QTimer::singleShot(0, window_.get(), [] { throw std::runtime_error("out of cheese"); });
    QVERIFY(testing::waitUntil([this] { return window_->messages().count() > 0; }));
    QVERIFY2(window_->messages().text().contains(QStringLiteral("out of cheese")), qPrintable(window_->messages().text()));
    dismissAll();
    QTimer::singleShot(0, window_.get(), [] { throw 42; });
    QVERIFY(testing::waitUntil([this] { return window_->messages().count() > 0; }));
    QVERIFY(window_->document().hasUnsavedChanges());
    QCOMPARE(window_->document().current()->title, std::string("Edited"));
    QVERIFY(window_->document().save().has_value());
  }

  void theResultOfAJobThatCannotBeTakenOverIsASentence() {
    openWindow();
    window_->jobs().start(
        QStringLiteral("Counting"), [](Progress&) { return Result<void>(); }, [](const Result<void>&) { throw 42; });
    window_->jobs().cancelAllAndWait();  // as when the window closes, where nobody above could stop it
    QVERIFY2(window_->messages().text().contains(QStringLiteral("'Counting'")), qPrintable(window_->messages().text()));
  }
};

}  // namespace
}  // namespace ew::ui

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(ew::ui::testing::windowFormat());
  ew::ui::SafeApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("EchoWeave"));
  QApplication::setApplicationName(QStringLiteral("EchoWeave tests"));
  ew::ui::OddPluginsTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "odd_plugins_test.moc"
