// From the hand to the image in the real window, a program and no test: a thread moves the mouse as a hand would, and every move is
// followed until the image that shows it has been handed to the screen.
//   bench_hand_to_image CASE [--moves 2000] [--every 30] [--size 1600x900] [--workspace explore] [--screenshot FILE]
#include <QApplication>
#include <QCommandLineParser>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <random>
#include <thread>
#include <vector>

#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

/// When a move was where, s on the scan's clock; 0: not yet.
struct Move {
  double posted_s = 0.0;   ///< by the hand
  double handled_s = 0.0;  ///< by the window, whose hold is another one from here on
  double begun_s = 0.0;    ///< the frame that shows it
  double made_s = 0.0;
  double told_s = 0.0;  ///< everybody knows of the image
  double paintBegun_s = 0.0;
  double painted_s = 0.0;    ///< by the scan view
  double shown_s = 0.0;      ///< handed to the screen, with all else that was painted with it
  bool changesHold = false;  ///< a hand that leaves the body moves nothing
  [[nodiscard]] bool counts() const { return changesHold && shown_s > 0.0; }
};

/// Follows moves, and every event of the window's thread.
class FollowingApplication final : public QApplication {
 public:
  using QApplication::QApplication;

  void follow(MainWindow& window, std::vector<Move>& moves) {
    window_ = &window;
    moves_ = &moves;
    connect(&window.session(), &Session::imageChanged, this, [this] { takeImage(); });
  }
  void stop() { window_ = nullptr; }

  bool notify(QObject* receiver, QEvent* event) override {
    if (window_ == nullptr) return QApplication::notify(receiver, event);
    const bool isMove = event->type() == QEvent::MouseMove && receiver == window_->view3d().canvas();
    const auto move = isMove ? static_cast<QMouseEvent*>(event)->timestamp() : 0;
    const bool isPaint = event->type() == QEvent::Paint && receiver == &window_->scanView();
    const bool isShowing = event->type() == QEvent::UpdateRequest && receiver == window_;
    const std::string name = depth_ == 0 ? nameOf(*receiver, *event) : std::string();
    const double begun_s = now_s();
    const bool isOfHand = move > 0 && move <= moves_->size();
    const Hold before = window_->session().probeControl().hold();
    if (isOfHand) (*moves_)[move - 1].handled_s = begun_s;
    if (isPaint) forShown([&](Move& shown) { shown.paintBegun_s = begun_s; });
    ++depth_;
    const bool handled = QApplication::notify(receiver, event);
    --depth_;
    if (window_ == nullptr) return handled;
    const double end_s = now_s();
    if (isOfHand) (*moves_)[move - 1].changesHold = !(window_->session().probeControl().hold() == before);
    if (isPaint) {
      forShown([&](Move& shown) { shown.painted_s = end_s; });
      isPainted_ = true;
    }
    if (isShowing && isPainted_) {
      forShown([&](Move& shown) { shown.shown_s = end_s; });
      firstUnshown_ = firstUnmade_;
      isPainted_ = false;
    }
    if (depth_ == 0) took_ms_[name].push_back(1e3 * (end_s - begun_s));
    return handled;
  }

  [[nodiscard]] const std::map<std::string, std::vector<double>>& took_ms() const { return took_ms_; }
  [[nodiscard]] std::uint64_t images() const { return images_; }

 private:
  [[nodiscard]] double now_s() const { return window_->session().frames().now_s(); }
  static std::string nameOf(const QObject& receiver, const QEvent& event) {
    return std::string(receiver.metaObject()->className()) + " " + qPrintable(receiver.objectName()) + ", event " +
           std::to_string(static_cast<int>(event.type()));
  }
  /// Moves whose image is made and not shown.
  template <class Do>
  void forShown(const Do& act) {
    for (std::size_t n = firstUnshown_; n < firstUnmade_; ++n) act((*moves_)[n]);
  }
  /// The last to be told: moves that were handled before the frame began are in it.
  void takeImage() {
    if (window_ == nullptr) return;
    ++images_;
    const Session& session = window_->session();
    const double begun_s = session.shownState().time_s;
    for (; firstUnmade_ < moves_->size(); ++firstUnmade_) {
      Move& move = (*moves_)[firstUnmade_];
      if (move.handled_s == 0.0 || move.handled_s > begun_s) break;
      move.begun_s = begun_s;
      move.made_s = begun_s + 1e-3 * session.frames().lastFrame_ms();
      move.told_s = now_s();
    }
  }

  MainWindow* window_ = nullptr;
  std::vector<Move>* moves_ = nullptr;
  std::size_t firstUnmade_ = 0, firstUnshown_ = 0;
  bool isPainted_ = false;
  int depth_ = 0;
  std::uint64_t images_ = 0;
  std::map<std::string, std::vector<double>> took_ms_;  ///< of every event that came by itself
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  return values[at];
}

/// There and back, 50 pixels to each side and a little up and down, no two places alike one after the other.
QPointF placeOf(std::size_t n, const QPointF& middle) {
  const double turn = 0.06 * static_cast<double>(n);
  return middle + QPointF(50.0 * std::sin(turn), 12.0 * std::sin(2.3 * turn));
}

void moveAsAHand(QWidget& canvas, const QPointF& middle, double every_ms, const FrameTimer& clock, std::vector<Move>& moves,
                 std::atomic<bool>& isDone) {
  const QPointF toScreen = QPointF(canvas.mapToGlobal(QPoint(0, 0)));
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> early(-0.25, 0.25);
  const auto begun = std::chrono::steady_clock::now();
  for (std::size_t n = 0; n < moves.size(); ++n) {
    const double at_ms = every_ms * (static_cast<double>(n) + early(chance));  // no two clocks of a machine run in step
    std::this_thread::sleep_until(begun +
                                  std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double, std::milli>(at_ms)));
    const QPointF at = placeOf(n + 1, middle);
    auto* event = new QMouseEvent(QEvent::MouseMove, at, at + toScreen, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    event->setTimestamp(static_cast<ulong>(n + 1));
    moves[n].posted_s = clock.now_s();
    QCoreApplication::postEvent(&canvas, event);
  }
  isDone = true;
}

void print(const char* what, const std::vector<Move>& moves, double Move::*from, double Move::*to) {
  std::vector<double> took_ms;
  for (const Move& move : moves)
    if (move.counts()) took_ms.push_back(1e3 * (move.*to - move.*from));
  std::printf("%-44s %8.2f %8.2f %8.2f %8.2f\n", what, quantile(took_ms, 0.5), quantile(took_ms, 0.95), quantile(took_ms, 0.99),
              quantile(took_ms, 1.0));
}

void report(const std::vector<Move>& moves, const FollowingApplication& app, double lasted_s) {
  const auto shown = std::count_if(moves.begin(), moves.end(), [](const Move& move) { return move.counts(); });
  const auto inTime =
      std::count_if(moves.begin(), moves.end(), [](const Move& move) { return move.counts() && move.shown_s - move.posted_s <= 0.016; });
  std::printf("%zu moves, %zu shown, %.1f %% within 16 ms; %llu images in %.1f s\n", moves.size(), static_cast<std::size_t>(shown),
              100.0 * static_cast<double>(inTime) / static_cast<double>(std::max<std::ptrdiff_t>(1, shown)),
              static_cast<unsigned long long>(app.images()), lasted_s);
  std::printf("%-44s %8s %8s %8s %8s\n", "ms", "median", "95 %", "99 %", "worst");
  print("hand to image", moves, &Move::posted_s, &Move::shown_s);
  print("  waits for the window's thread", moves, &Move::posted_s, &Move::handled_s);
  print("  from the event to the frame", moves, &Move::handled_s, &Move::begun_s);
  print("  frame", moves, &Move::begun_s, &Move::made_s);
  print("  telling everybody", moves, &Move::made_s, &Move::told_s);
  print("  waits to be painted", moves, &Move::told_s, &Move::paintBegun_s);
  print("  painting the scan", moves, &Move::paintBegun_s, &Move::painted_s);
  print("  the rest of the window, to the screen", moves, &Move::painted_s, &Move::shown_s);
  std::printf("what else had the window's thread, above 2 ms:\n%-72s %6s %8s %8s %8s\n", "", "times", "median", "99 %", "worst");
  for (const auto& [name, took_ms] : app.took_ms()) {
    std::vector<double> above;
    for (const double each : took_ms)
      if (each > 2.0) above.push_back(each);
    if (above.size() > took_ms.size() / 100 || above.size() > 3)
      std::printf("%-72s %6zu %8.2f %8.2f %8.2f\n", name.c_str(), above.size(), quantile(above, 0.5), quantile(above, 0.99),
                  quantile(above, 1.0));
  }
}

int bench(FollowingApplication& app, const QCommandLineParser& asked) {
  const QStringList size = asked.value(QStringLiteral("size")).split(QLatin1Char('x'));
  std::vector<Move> moves(static_cast<std::size_t>(std::max(1, asked.value(QStringLiteral("moves")).toInt())));
  MainWindow window;
  window.resize(size.value(0).toInt(), size.value(1).toInt());
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return 1;
  window.open(asked.positionalArguments().value(0));
  if (!waitUntil([&] { return window.isSettled() && window.document().current(); }, 1.8e6)) {
    std::cerr << "bench_hand_to_image: " << qPrintable(window.messages().text()) << "\n";
    return 1;
  }
  if (const QString workspace = asked.value(QStringLiteral("workspace")); !workspace.isEmpty())
    window.showWorkspace(workspace.toStdString());
  QTest::qWait(2000);
  QWidget& canvas = *window.view3d().canvas();
  const QPointF middle = window.view3d().pixelOf(window.session().probeControl().hold().contact.point_mm);
  std::printf("%s, window %d x %d, image %d x %d, body %d x %d%s\n", qPrintable(asked.positionalArguments().value(0)), window.width(),
              window.height(), window.session().imageSize_px().x, window.session().imageSize_px().y, canvas.width(), canvas.height(),
              canvas.isVisible() ? "" : " (hidden)");
  QMouseEvent press(QEvent::MouseButtonPress, middle, QPointF(canvas.mapToGlobal(middle.toPoint())), Qt::LeftButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&canvas, &press);
  QTest::qWait(500);
  app.follow(window, moves);
  std::atomic<bool> isDone = false;
  const double begun_s = window.session().frames().now_s();
  std::thread hand(
      [&] { moveAsAHand(canvas, middle, asked.value(QStringLiteral("every")).toDouble(), window.session().frames(), moves, isDone); });
  while (!isDone) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
  hand.join();
  const double lasted_s = window.session().frames().now_s() - begun_s;
  QTest::qWait(300);
  app.stop();
  report(moves, app, lasted_s);
  if (const QString file = asked.value(QStringLiteral("screenshot")); !file.isEmpty() && !window.grab().save(file, "PNG")) return 1;
  return 0;
}

}  // namespace ew::ui::testing

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(ew::ui::testing::windowFormat());
  ew::ui::testing::FollowingApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("EchoWeave"));
  QApplication::setApplicationName(QStringLiteral("EchoWeave benches"));
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCommandLineParser asked;
  asked.addHelpOption();
  asked.addPositionalArgument(QStringLiteral("case"), QStringLiteral("folder of a case"));
  asked.addOption({QStringLiteral("moves"), QStringLiteral("how many"), QStringLiteral("n"), QStringLiteral("2000")});
  asked.addOption({QStringLiteral("every"), QStringLiteral("ms between two moves"), QStringLiteral("ms"), QStringLiteral("30")});
  asked.addOption({QStringLiteral("size"), QStringLiteral("of the window"), QStringLiteral("size"), QStringLiteral("1600x900")});
  asked.addOption({QStringLiteral("workspace"), QStringLiteral("the window's work"), QStringLiteral("id")});
  asked.addOption({QStringLiteral("screenshot"), QStringLiteral("of the window afterwards"), QStringLiteral("file")});
  asked.process(app);
  if (asked.positionalArguments().isEmpty()) asked.showHelp(2);
  return ew::ui::testing::bench(app, asked);
}
