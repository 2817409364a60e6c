// The page of trackers: what is in its list, what it says, how it looks, and that it does not disturb the scan.
#include <QComboBox>
#include <QDialog>
#include <QListWidget>
#include <QMenu>
#include <QScreen>
#include <QTabWidget>

#include "ew/tracking/tracked_probe.h"
#include "ew/ui_test_door/trackers.h"
#include "gui/support/answers.h"
#include "gui/support/usability_fixture.h"

namespace ew::ui::testing {

class TrackerPageTest : public UsabilityFixture {
  Q_OBJECT

  /// No plugin is needed for this.
  void openWindow(const QString& language, int text_percent = 100) {
    speak(language);
    QSettings().setValue(QStringLiteral("textSize"), text_percent);
    if (case_.isEmpty()) case_ = files_.writeCase(QStringLiteral("case"));
    showWindowWithCase(case_);
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
  }
  [[nodiscard]] Trackers& trackers() const { return window_->trackers(); }
  [[nodiscard]] TrackerPage* page() const { return find<TrackerPage>("trackerPage"); }
  void showPage() {
    QAction* entry = action("&Tracker…");
    QVERIFY(entry);
    entry->trigger();
    QVERIFY(page() && page()->isVisible());
    QTest::qWait(150);
  }
  [[nodiscard]] std::string cameraTracker() const {
    for (const TrackerSettings& each : trackers().all())
      if (std::holds_alternative<CameraSource>(each.source)) return each.id;
    return {};
  }
  [[nodiscard]] QString textOf(const char* name) const { return page()->findChild<QLabel*>(QLatin1String(name))->text(); }
  std::string addRecording(const QString& file) {
    TrackerSettings made;
    made.name = "A sweep";
    made.source = SequenceSettings{file.toStdString(), 1.0, true};
    return trackers().add(made);
  }

 private Q_SLOTS:
  void initTestCase() { initUsabilityTranslations(); }
  void cleanup() {
    if (window_) trackers().useMouse();
    window_.reset();
    QFile::remove(QFileInfo(QSettings().fileName()).dir().filePath(QStringLiteral("trackers.json")));
    beSilent();
  }

  void theMouseIsThereFirstAndMovesTheProbe() {
    openWindow(QStringLiteral("en"));
    showPage();
    auto* list = page()->findChild<QListWidget*>(QStringLiteral("trackerList"));
    QVERIFY(list->count() >= 2);
    QCOMPARE(list->item(0)->text(), TrackerPage::tr("Mouse and keyboard"));
    QVERIFY(page()->chosen().empty() && trackers().used().empty());
    QCOMPARE(textOf("trackerState"), TrackerPage::tr("moves the probe"));
    QVERIFY(!textOf("trackerSentence").isEmpty());
    QVERIFY(!find<QPushButton>("trackingState")->isVisible());
  }

  void trackersAreAddedRenamedAndRemovedAndKept() {
    openWindow(QStringLiteral("en"));
    showPage();
    const std::size_t before = trackers().all().size();
    auto* menu = page()->findChild<QPushButton*>(QStringLiteral("trackerAdd"))->menu();
    QCOMPARE(menu->actions().size(), 5);
    {
      Answers answers({{QStringLiteral("fileDialog"), type(files_.writeSweep(QStringLiteral("kept.igs.mha")))}});
      for (QAction* each : menu->actions()) each->trigger();
      QCOMPARE(answers.asked, QStringList{QStringLiteral("fileDialog")});  // a recording is of a file
    }
    QCOMPARE(trackers().all().size(), before + 5);
    std::set<std::string> names;
    for (const TrackerSettings& each : trackers().all()) names.insert(each.name);
    QCOMPARE(names.size(), trackers().all().size());
    auto* list = page()->findChild<QListWidget*>(QStringLiteral("trackerList"));
    list->currentItem()->setText(QStringLiteral("  In the corner "));
    QCOMPARE(trackers().find(page()->chosen())->name, std::string("In the corner"));
    const std::string renamed = page()->chosen();
    page()->choose(trackers().all().front().id);
    const std::string first = page()->chosen();
    page()->findChild<QPushButton*>(QStringLiteral("trackerRemove"))->click();
    QVERIFY(trackers().find(first) == nullptr);
    window_.reset();
    showWindowWithCase(case_);
    QVERIFY(trackers().find(first) == nullptr);
    QVERIFY(trackers().find(renamed) != nullptr);
    QCOMPARE(trackers().find(renamed)->name, std::string("In the corner"));
  }

  void aRecordingIsFollowedWhileTheScanGoesOnAndTheMouseTakesOver() {
    openWindow(QStringLiteral("en"));
    const std::string id = addRecording(files_.writeSweep(QStringLiteral("tracked.igs.mha")));
    showPage();
    page()->choose(id);
    QCOMPARE(textOf("trackerState"), TrackerPage::tr("not in use"));
    const std::uint64_t frames = session().frames().framesMade();
    page()->findChild<QPushButton*>(QStringLiteral("trackerUse"))->click();
    QCOMPARE(trackers().used(), id);
    QVERIFY(waitUntil([this] { return trackers().report().state == TrackingState::live; }));
    QVERIFY(waitUntil([&] { return session().frames().framesMade() > frames + 3; }));
    QVERIFY(session().probeControl().mover() == ProbeControl::Mover::tracker);
    QVERIFY(waitUntil([this] { return find<QPushButton>("trackingState")->isVisible(); }));
    auto* tools = page()->findChild<QComboBox*>(QStringLiteral("trackerTool"));
    QVERIFY(waitUntil([tools] { return tools->count() > 1; }));
    QVERIFY(waitUntil([this] { return trackers().report().rate_hz > 1.0; }));
    keepScreenshot(*page(), "tracker-page-live");
    keepScreenshot(*window_, "tracker-window-live");
    page()->findChild<QPushButton*>(QStringLiteral("trackerUse"))->click();
    QVERIFY(trackers().used().empty());
    QVERIFY(session().probeControl().mover() == ProbeControl::Mover::hand);
    QVERIFY(!find<QPushButton>("trackingState")->isVisible());
  }

  void theTrackerInUseGoesOnAtTheNextStart() {
    openWindow(QStringLiteral("en"));
    const std::string id = addRecording(files_.writeSweep(QStringLiteral("again.igs.mha")));
    trackers().use(id);
    QVERIFY(waitUntil([this] { return trackers().report().state == TrackingState::live; }));
    window_.reset();
    showWindowWithCase(case_);
    QCOMPARE(trackers().used(), id);
    QVERIFY(waitUntil([this] { return trackers().report().state == TrackingState::live; }));
  }

  void aMissingCameraIsASentenceAndTheWindowGoesOn() {
    openWindow(QStringLiteral("en"));
    showPage();
    const std::string id = cameraTracker();
    QVERIFY(!id.empty());
    trackers().chooseCamera(id, files_.path(QStringLiteral("no film.avi")).toStdString());
    page()->choose(id);
    trackers().use(id);
    QVERIFY(waitUntil([this] { return !trackers().deviceStatus().sentence.empty(); }));
    QVERIFY(waitUntil([this] { return textOf("trackerSentence").contains(QStringLiteral("no film.avi")); }));
    QVERIFY(trackers().report().state != TrackingState::live);
    keepScreenshot(*page(), "tracker-page-missing");
  }

  void everyPageFitsAndIsNamed_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("text_percent");
    QTest::newRow("English, dark") << QStringLiteral("en") << true << 100;
    QTest::newRow("German, light") << QStringLiteral("de") << false << 100;
    QTest::newRow("German, large type") << QStringLiteral("de") << true << 200;
  }
  void everyPageFitsAndIsNamed() {
    QFETCH(QString, language);
    QFETCH(bool, dark);
    QFETCH(int, text_percent);
    openWindow(language, text_percent);
    window_->setDarkTheme(dark);
    showPage();
    QStringList wrong;
    const auto look = [&](QWidget& root, const QString& name) {
      QTest::qWait(150);
      const QSize room = root.screen()->availableSize();
      if (root.height() > room.height() || root.width() > room.width())
        wrong << QStringLiteral("%1: %2 x %3").arg(name).arg(root.width()).arg(root.height());
      for (const QString& each : cutTexts(root) + namelessControls(root)) wrong << name + QStringLiteral(": ") + each;
      keepScreenshot(root, qPrintable(QStringLiteral("tracker-%1-%2-%3").arg(language).arg(text_percent).arg(name)));
    };
    auto* tabs = page()->findChild<QTabWidget*>(QStringLiteral("trackerTabs"));
    auto* menu = page()->findChild<QPushButton*>(QStringLiteral("trackerAdd"))->menu();
    Answers answers({{QStringLiteral("fileDialog"), type(files_.writeSweep(QStringLiteral("shown.igs.mha")))}});
    for (int kind = 0; kind < menu->actions().size(); ++kind) {
      menu->actions()[kind]->trigger();
      for (int tab = 0; tab < tabs->count(); ++tab) {
        if (!tabs->isTabEnabled(tab)) continue;
        tabs->setCurrentIndex(tab);
        look(*page(), QStringLiteral("kind%1-tab%2").arg(kind).arg(tab));
      }
    }
    page()->choose(cameraTracker());
    page()->findChild<QPushButton*>(QStringLiteral("trackerSetUp"))->click();
    auto* wizard = find<TrackerWizard>("trackerWizard");
    QVERIFY(wizard && wizard->isVisible());
    wizard->resize(wizard->size().boundedTo(QSize(scaled(940), scaled(640))));
    for (int step = 0; step < wizard->stepCount(); ++step) {
      wizard->showStep(step);
      look(*wizard, QStringLiteral("step%1").arg(step + 1));
    }
    wizard->close();
    for (const QString& each : wrong) fprintf(stderr, "  %s\n", qPrintable(each));
    QVERIFY2(wrong.isEmpty(), qPrintable(QString::number(wrong.size())));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::TrackerPageTest)
#include "tracker_page_test.moc"
