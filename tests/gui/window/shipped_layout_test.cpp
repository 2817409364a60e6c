// Every case that is shipped, as a laptop shows it: whoever scans has gain, depth, freeze, probe and calipers at any size of window and
// text.
#include "gui/support/usability_fixture.h"
#include "places.h"

namespace ew::ui::testing {

class ShippedLayoutTest : public UsabilityFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { initUsabilityTranslations(); }
  void cleanup() { beSilent(); }

  void theConsoleIsReachedAtAnySizeInEveryCase_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<int>("text_percent");
    QTest::addColumn<QString>("folder");
    std::vector<std::filesystem::path> cases;
    for (const auto& each : std::filesystem::directory_iterator(std::filesystem::path(EW_SOURCE_DIR) / "cases"))
      if (std::filesystem::exists(each.path() / "case.json")) cases.push_back(each.path());
    std::sort(cases.begin(), cases.end());
    for (const std::filesystem::path& each : cases)
      addLanguagesAndSizes(QString::fromStdString(each.filename().string()) + QLatin1Char(' '),
                           [&](QTestData& row) { row << QString::fromStdString(each.string()); });
  }
  void theConsoleIsReachedAtAnySizeInEveryCase() {
    QFETCH(QString, language);
    QFETCH(int, text_percent);
    QFETCH(QString, folder);
    speak(language);
    QSettings().setValue(QStringLiteral("textSize"), text_percent);
    const std::filesystem::path shipped = folder.toStdString();
    showWindowWithCase(coarseCopyOf(shipped));
    window_->openPlugins();
    window_->setWorkspace(Workspace::explore);
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    const QStringList wrong = whatIsNotReachedBeforeAndInALesson(
        QStringLiteral("%1-%2-%3").arg(QString::fromStdString(shipped.filename().string()), language).arg(text_percent));
    for (const QString& each : wrong) fprintf(stderr, "  %s\n", qPrintable(each));
    QVERIFY2(wrong.isEmpty(), qPrintable(QString::number(wrong.size())));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::ShippedLayoutTest)
#include "shipped_layout_test.moc"
