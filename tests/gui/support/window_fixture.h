#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <QAbstractEventDispatcher>
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTest>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "even_sweep.h"
#include "ew/core/volume.h"
#include "ew/io/safe_file.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"
#include "ew/ui/main_window.h"
#include "ew/ui_test_door/body.h"
#include "ew/ui_test_door/case_document.h"
#include "ew/ui_test_door/console.h"
#include "ew/ui_test_door/jobs.h"
#include "ew/ui_test_door/messages.h"
#include "ew/ui_test_door/scan.h"
#include "ew/widgets/handler_watch.h"
#include "ew/widgets/theme.h"
#include "time_limit.h"

namespace ew::ui::testing {

/// What the window's tests share: settings, kept work and a library of cases of their own, and files that they write themselves.
class Files {
 public:
  Files() {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path() + QStringLiteral("/settings"));
    qputenv("XDG_DATA_HOME", path(QStringLiteral("data")).toUtf8());
    qputenv("ECHOWEAVE_LIBRARY", path(QStringLiteral("library")).toUtf8());
    qputenv("ECHOWEAVE_CASES", path(QStringLiteral("own cases")).toUtf8());
  }

  /// Where settings lie, for a program that is started from here.
  [[nodiscard]] QString settings() const { return path(QStringLiteral("settings")); }
  [[nodiscard]] QString path(const QString& name) const { return folder_.path() + QLatin1Char('/') + name; }

  /// A case whose volume is a field of many grey levels without any symmetry, at the front of the trunk.
  [[nodiscard]] QString writeCase(const QString& name) const {
    const QString folder = path(name);
    QDir().mkpath(folder);
    Volume volume;
    volume.grid.dims = {96, 80, 88};
    volume.grid.spacing_mm = glm::dvec3(2.0);
    volume.grid.origin_mm = {-95.0, -110.0, -100.0};
    volume.echo.resize(volume.grid.voxelCount());
    for (int k = 0; k < 88; ++k) {
      for (int j = 0; j < 80; ++j) {
        for (int i = 0; i < 96; ++i)
          volume.echo[volume.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(20 + (2 * i + j + (i * k) / 24) % 200);
      }
    }
    if (!writeVolume(volume, folder.toStdString() + "/volume.mha")) return {};
    const std::string manifest = R"({
      "format": 1, "id": "window-test", "title": "Window test", "region": "upper abdomen",
      "patient": {"name": "Test Person", "sex": "female", "age_years": 40},
      "history": "None.", "indication": "To be looked at.", "diagnosis": "Healthy.",
      "volume": {"file": "volume.mha", "file_to_world": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]},
      "probes": ["convex-3.5"], "scene": {"gain_and_dgc": true}})";
    if (!writeFileSafely(folder.toStdString() + "/case.json", manifest)) return {};
    return folder;
  }

  /// A sweep of 24 frames of 40 x 30 pixels, 1 mm each, 1 mm apart, with one grey level a frame.
  [[nodiscard]] QString writeSweep(const QString& name) const {
    const Sequence sweep = test::evenSweep({40, 30, 24, "Image", "Reference"}, [](int n, int) { return 40 + 8 * n; });
    const QString file = path(name);
    return writeSequence(sweep, file.toStdString()) ? file : QString();
  }

 private:
  QTemporaryDir folder_;
};

/// Runs the event loop until `ready`, or until it seems to hang.
inline bool waitUntil(const std::function<bool()>& ready, double patience_ms = test::kPatience_ms) {
  QElapsedTimer clock;
  clock.start();
  while (!ready()) {
    if (static_cast<double>(clock.elapsed()) > patience_ms) return false;
    QTest::qWait(10);
  }
  return true;
}

inline std::vector<std::uint8_t> pixelsOf(const Session& session) {
  const ImageView<const std::uint8_t> image = session.image().grey;
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < image.height; ++y) pixels.insert(pixels.end(), image.row(y), image.row(y) + image.width);
  return pixels;
}

inline QSurfaceFormat windowFormat() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  return format;
}

/// With EW_WATCH set it says in the end who held the window's thread during the test.
class TestApplication final : public QApplication {
 public:
  TestApplication(int& argc, char** argv) : QApplication(argc, argv) {
    if (!qEnvironmentVariableIsSet("EW_WATCH")) return;
    watch_ = std::make_unique<HandlerWatch>();
    watch_->follow(*QAbstractEventDispatcher::instance());
  }
  ~TestApplication() override {
    if (!watch_) return;
    for (const HandlerWatch::Slow& each : watch_->slow())
      qInfo("%6zu times, %8.1f ms in all (worked %8.1f), %7.1f at most (%7.1f): %s", each.count, each.total.wall_ms, each.total.worked_ms,
            each.worst.wall_ms, each.worst.worked_ms, qPrintable(each.name));
  }
  bool notify(QObject* receiver, QEvent* event) override {
    if (!watch_ || receiver->thread() != thread()) return QApplication::notify(receiver, event);
    return watch_->handle(*receiver, *event, [&] { return QApplication::notify(receiver, event); });
  }

 private:
  std::unique_ptr<HandlerWatch> watch_;
};

/// A test with one window of 1280 x 720, made anew for every test function.
class WindowFixture : public QObject {
 protected:
  Files files_;
  std::unique_ptr<MainWindow> window_;

  [[nodiscard]] Session& session() const { return window_->session(); }
  template <class Widget>
  [[nodiscard]] Widget* find(const char* name) const {
    return window_->findChild<Widget*>(QLatin1String(name));
  }
  [[nodiscard]] bool openCase(const QString& folder) const {
    window_->open(folder);
    return waitUntil([this] { return window_->isSettled() && window_->document().current(); });
  }
  void showWindowWithCase(const QString& folder) {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());  // the test screen has no window manager that would do it
    session().frames().setAdaptive(false);         // how fast frames are made here must not choose the images that are compared
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
    QVERIFY(openCase(folder));
    QVERIFY2(!window_->messages().isError(), qPrintable(window_->messages().text()));
  }
};

}  // namespace ew::ui::testing

/// A main that prepares what the workstation's own start prepares.
#define EW_WINDOW_TEST_MAIN(Test)                                        \
  int main(int argc, char** argv) {                                      \
    QSurfaceFormat::setDefaultFormat(ew::ui::testing::windowFormat());   \
    ew::ui::testing::TestApplication app(argc, argv);                    \
    QApplication::setOrganizationName(QStringLiteral("EchoWeave"));      \
    QApplication::setApplicationName(QStringLiteral("EchoWeave tests")); \
    Test test;                                                           \
    return QTest::qExec(&test, argc, argv);                              \
  }
