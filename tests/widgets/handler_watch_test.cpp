// Who held the window's thread, by clocks that stand still but for what handlers say they took.

#include "ew/widgets/handler_watch.h"

#include <QTimer>
#include <QtTest>
#include <algorithm>
#include <functional>
#include <thread>
#include <vector>

using ew::HandlerWatch;

class HandlerWatchTest final : public QObject {
  Q_OBJECT

 private:
  double now_ms_ = 0.0, worked_ms_ = 0.0;
  HandlerWatch watch_{2.0, [this] { return HandlerWatch::Times{now_ms_, worked_ms_}; }};
  QObject window_, panel_;
  QTimer timer_{&panel_};

  /// Lets `receiver` take so long for an event, and do something in the middle of it.
  void take(
      const QObject& receiver, QEvent::Type type, double took_ms, const std::function<void()>& inside = [] {}) {
    watch_.handle(receiver, QEvent(type), [&] {
      now_ms_ += took_ms;
      inside();
      return true;
    });
  }
  [[nodiscard]] QStringList names() const {
    QStringList all;
    for (const HandlerWatch::Slow& each : watch_.slow()) all << each.name;
    return all;
  }

 private Q_SLOTS:
  void initTestCase() {
    window_.setObjectName(QStringLiteral("window"));
    panel_.setObjectName(QStringLiteral("panel"));
  }

  void namesWhoTookLongAndNobodyElse() {
    take(window_, QEvent::UpdateRequest, 1.5, [&] {
      take(panel_, QEvent::Paint, 7.0);
      take(timer_, QEvent::Timer, 3.0);
      take(window_, QEvent::Paint, 2.0);
    });
    QCOMPARE(names(), QStringList({QStringLiteral("QObject 'panel', Paint"), QStringLiteral("QTimer in 'panel', Timer")}));
    QCOMPARE(watch_.slow().front().worst.wall_ms, 7.0);
  }

  void whatItWorkedStandsBesideWhatItTook() {
    take(window_, QEvent::Wheel, 1.0, [&] {
      worked_ms_ += 0.5;
      take(panel_, QEvent::Wheel, 30.0, [&] { worked_ms_ += 4.0; });  // other programs had the machine
    });
    take(panel_, QEvent::Wheel, 5.0, [&] { worked_ms_ += 4.5; });
    const auto all = watch_.slow();
    const auto found =
        std::find_if(all.begin(), all.end(), [](const auto& each) { return each.name == QStringLiteral("QObject 'panel', Wheel"); });
    QVERIFY(found != all.end());
    QCOMPARE(found->count, std::size_t{2});
    QCOMPARE(found->total.wall_ms, 35.0);
    QCOMPARE(found->total.worked_ms, 8.5);
    QCOMPARE(found->worst.wall_ms, 30.0);
    QCOMPARE(found->worst.worked_ms, 4.5);
    QVERIFY(!names().contains(QStringLiteral("QObject 'window', Wheel")));
  }

  void aPartOfAHandlerAnswersForItself() {
    take(window_, QEvent::MetaCall, 1.0, [&] {
      const HandlerWatch::Part part("the image");
      now_ms_ += 20.0;
    });
    QVERIFY(names().contains(QStringLiteral("the image")));
    QVERIFY(!names().contains(QStringLiteral("QObject 'window', MetaCall")));
  }

  void whoWaitsForAnAnswerHoldsNobody() {
    take(window_, QEvent::MouseButtonRelease, 1.0, [&] {
      for (int n = 0; n < 3; ++n) {
        watch_.wait();
        now_ms_ += 1000.0;
        take(panel_, QEvent::KeyPress, 9.0);
        watch_.wake();
        watch_.wake();  // as loops do that did not wait
      }
    });
    QVERIFY(names().contains(QStringLiteral("QObject 'panel', KeyPress")));
    QVERIFY(!names().contains(QStringLiteral("QObject 'window', MouseButtonRelease")));
  }

  void tellsAtFirstAndWhenItGetsTwiceAsLong() {
    std::vector<double> told_ms;
    watch_.told = [&](const HandlerWatch::Slow& slow) { told_ms.push_back(slow.worst.wall_ms); };
    for (const double took_ms : {3.0, 4.0, 5.0, 11.0, 12.0}) take(window_, QEvent::Resize, took_ms);
    QCOMPARE(told_ms, std::vector<double>({3.0, 11.0}));
  }

  void nothingHappensWhereNoWatchRuns() {
    std::thread([] { const HandlerWatch::Part part("on another thread"); }).join();
    QVERIFY(!names().contains(QStringLiteral("on another thread")));
  }
};

QTEST_GUILESS_MAIN(HandlerWatchTest)
#include "handler_watch_test.moc"
