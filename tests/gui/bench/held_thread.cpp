// Who holds the window's thread for more than 2 ms while cases are opened, the probe moves, and a lesson, Review and the author's panels
// come: in wall time, and in what the thread worked.
//   bench_held_thread CASE... [--rounds 1] [--lesson ID] [--size 1600x900] [--screenshots FOLDER]
#include <QCommandLineParser>
#include <QMouseEvent>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

class WatchedApplication final : public QApplication {
 public:
  using QApplication::QApplication;

  /// What is handled while `act` runs, and what of it took long.
  void watch(const QString& what, const std::function<void()>& act) {
    HandlerWatch watch;
    watch.follow(*QAbstractEventDispatcher::instance());
    watch_ = &watch;
    act();
    watch_ = nullptr;
    std::printf("%s\n%8s %10s %10s %10s %10s\n", qPrintable(what), "times", "ms in all", "(worked)", "at most", "(worked)");
    for (const HandlerWatch::Slow& each : watch.slow())
      std::printf("%8zu %10.1f %10.1f %10.1f %10.1f  %s\n", each.count, each.total.wall_ms, each.total.worked_ms, each.worst.wall_ms,
                  each.worst.worked_ms, qPrintable(each.name));
    std::fflush(stdout);
  }
  bool notify(QObject* receiver, QEvent* event) override {
    if (watch_ == nullptr || receiver->thread() != thread()) return QApplication::notify(receiver, event);
    return watch_->handle(*receiver, *event, [&] { return QApplication::notify(receiver, event); });
  }

 private:
  HandlerWatch* watch_ = nullptr;
};

class HeldThread {
 public:
  HeldThread(WatchedApplication& app, QString screenshots) : app_(app), screenshots_(std::move(screenshots)) {}

  bool run(const QStringList& cases, int rounds, const QString& lesson, const QSize& size_px) {
    app_.watch(QStringLiteral("the window comes"), [&] {
      window_.resize(size_px);
      window_.show();
      window_.openPlugins();
      isGood_ = waitUntil([this] { return !window_.jobs().isRunning(); });
    });
    for (int round = 0; round < rounds; ++round)
      for (const QString& each : cases) {
        app_.watch(QStringLiteral("opening %1").arg(each), [&] {
          window_.open(each);
          isGood_ = isGood_ && settle() && window_.document().current();
        });
        keep(QStringLiteral("case-%1").arg(QDir(each).dirName()));
      }
    if (!isGood_) return false;
    app_.watch(QStringLiteral("moving the probe"), [&] { moveProbe(); });
    if (!lesson.isEmpty()) show(QStringLiteral("lesson"), [&] { window_.openLesson(cases.back(), lesson); });
    show(QStringLiteral("review"), [&] { window_.showWorkspace("review"); });
    show(QStringLiteral("author"), [&] { window_.showWorkspace("author"); });
    show(QStringLiteral("explore"), [&] { window_.showWorkspace("explore"); });
    return isGood_;
  }
  [[nodiscard]] QString problem() { return window_.messages().text(); }

 private:
  WatchedApplication& app_;
  QString screenshots_;
  MainWindow window_;
  bool isGood_ = true;

  bool settle() {
    const bool isSettled = waitUntil([this] { return window_.isSettled(); }, 1.8e6);
    QTest::qWait(1500);  // what comes behind it: finer volumes, smooth edges, cards
    return isSettled;
  }
  void show(const QString& what, const std::function<void()>& act) {
    app_.watch(what, [&] {
      act();
      isGood_ = settle() && isGood_;
    });
    keep(what);
  }
  void keep(const QString& name) {
    if (!screenshots_.isEmpty()) window_.grab().save(screenshots_ + QLatin1Char('/') + name + QStringLiteral(".png"));
  }
  void moveProbe() {
    QWidget& canvas = *window_.view3d().canvas();
    const QPointF middle = window_.view3d().pixelOf(window_.session().probeControl().hold().contact.point_mm);
    const auto send = [&](QEvent::Type type, const QPointF& at) {
      QMouseEvent event(type, at, QPointF(canvas.mapToGlobal(at.toPoint())), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                        type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
      QCoreApplication::sendEvent(&canvas, &event);
    };
    send(QEvent::MouseButtonPress, middle);
    for (int n = 0; n < 200; ++n) {
      send(QEvent::MouseMove, middle + QPointF(50.0 * std::sin(0.06 * n), 12.0 * std::sin(0.14 * n)));
      QTest::qWait(30);
    }
    send(QEvent::MouseButtonRelease, middle);
    QTest::qWait(1000);
  }
};

}  // namespace ew::ui::testing

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(ew::ui::testing::windowFormat());
  ew::ui::testing::WatchedApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("EchoWeave"));
  QApplication::setApplicationName(QStringLiteral("EchoWeave benches"));
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCommandLineParser asked;
  asked.addHelpOption();
  asked.addPositionalArgument(QStringLiteral("case..."), QStringLiteral("folders of cases"));
  asked.addOption({QStringLiteral("rounds"), QStringLiteral("how often all are opened"), QStringLiteral("n"), QStringLiteral("1")});
  asked.addOption({QStringLiteral("lesson"), QStringLiteral("of the last case"), QStringLiteral("id")});
  asked.addOption({QStringLiteral("size"), QStringLiteral("of the window"), QStringLiteral("size"), QStringLiteral("1600x900")});
  asked.addOption({QStringLiteral("screenshots"), QStringLiteral("where they go"), QStringLiteral("folder")});
  asked.process(app);
  if (asked.positionalArguments().isEmpty()) asked.showHelp(2);
  const QStringList size = asked.value(QStringLiteral("size")).split(QLatin1Char('x'));
  ew::ui::testing::HeldThread bench(app, asked.value(QStringLiteral("screenshots")));
  if (bench.run(asked.positionalArguments(), asked.value(QStringLiteral("rounds")).toInt(), asked.value(QStringLiteral("lesson")),
                {size.value(0).toInt(), size.value(1).toInt()}))
    return 0;
  std::cerr << "bench_held_thread: " << qPrintable(bench.problem()) << "\n";
  return 1;
}
