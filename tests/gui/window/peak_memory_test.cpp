// What the window takes: empty, with each shipped case, after ten of them one after another, and with Review beside. A measurement and no
// test: it prints a table and is left out unless EW_MEASURE_MEMORY=1. Cases are those that are prepared in ECHOWEAVE_CACHE.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#include "ew/library/case.h"
#include "ew/tracking/hand.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class PeakMemoryTest final : public WindowFixture {
  Q_OBJECT

  static constexpr int kPatience_ms = 600000;
  static constexpr std::size_t kOneAfterAnother = 10;

  std::vector<Case> cases_;

  static double ofStatus_mib(const std::string& what) {
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);)
      if (line.starts_with(what + ":")) return std::stod(line.substr(what.size() + 1)) / 1024.0;
    return 0.0;
  }
  /// Since the line before. The peak begins anew.
  static void print(const std::string& when) {
    std::printf("%-44s peak %7.1f MiB  now %7.1f: own %7.1f, of files %7.1f\n", when.c_str(), ofStatus_mib("VmHWM"), ofStatus_mib("VmRSS"),
                ofStatus_mib("RssAnon"), ofStatus_mib("RssFile"));
    std::fflush(stdout);
    std::ofstream("/proc/self/clear_refs") << "5";
  }
  void settle() {
    QVERIFY(waitUntil([this] { return window_->isSettled() && !window_->jobs().isRunning(); }, kPatience_ms));
    QTest::qWait(1000);
  }
  /// As somebody looks at it: the probe slides over the skin.
  void scan(const Case& opened) {
    window_->open(QString::fromStdString(opened.folder.string()));
    QVERIFY(waitUntil(
        [&] {
          const auto& now = window_->document().current();
          return window_->isSettled() && now && now->id == opened.id;
        },
        kPatience_ms));
    settle();
    const Hold begun = session().probeControl().hold();
    for (int step = -10; step <= 10; ++step) {
      session().probeControl().setHold(slid(begun, *session().probeControl().skin(), 0.0, 4.0 * step));
      session().makeImageNow();
      QCoreApplication::processEvents();
    }
  }

 private Q_SLOTS:
  void initTestCase() {
    if (qEnvironmentVariableIntValue("EW_MEASURE_MEMORY") == 0) QSKIP("a measurement: run it with EW_MEASURE_MEMORY=1");
    const auto folder = shippedCasesFolder();
    QVERIFY(folder.has_value());
    for (const Case& each : listCases(*folder).cases)
      if (!caseNeedsPreparation(each)) cases_.push_back(each);
    QVERIFY2(!cases_.empty(), "no case is prepared; run 'echoweave case prepare --all' first");
  }
  void cleanup() { window_.reset(); }

  void window() {
    print("before the window");
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), kPatience_ms));
    window_->openPlugins();
    window_->showStartPage();
    QTest::qWait(3000);
    settle();
    print("window, its start page");
    for (std::size_t n = 0; n < std::max(kOneAfterAnother, cases_.size()); ++n) {
      const Case& each = cases_[n % cases_.size()];
      scan(each);
      if (QTest::currentTestFailed()) return;
      print(std::to_string(n + 1) + ": " + each.id);
    }
    window_->showWorkspace("review");
    settle();
    QTest::qWait(3000);
    settle();
    print("Review beside it");
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::PeakMemoryTest)
#include "peak_memory_test.moc"
