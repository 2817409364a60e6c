#pragma once

#include <QEvent>
#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <vector>

class QAbstractEventDispatcher;

namespace ew {

/// What holds the window's thread: measures how long each event is handled, without what was handled inside, and keeps who took longer
/// than a bound. An application lets every event through handle(); one that checks contracts does (SafeApplication). All of it on one
/// thread.
class HandlerWatch {
 public:
  /// Since some beginning: on the wall, and what this thread has worked. A machine that does other things too lets the first alone grow.
  struct Times {
    double wall_ms = 0.0;
    double worked_ms = 0.0;
  };
  /// One class, name and kind of event.
  struct Slow {
    QString name;
    std::size_t count = 0;
    Times total;
    Times worst;  ///< each by itself
  };

  /// @param bound_ms on the wall, above which handling is slow
  /// @param now      a clock that never goes back
  explicit HandlerWatch(double bound_ms = 2.0, std::function<Times()> now = threadNow);
  ~HandlerWatch();
  HandlerWatch(const HandlerWatch&) = delete;
  HandlerWatch& operator=(const HandlerWatch&) = delete;

  /// Lets `receiver` handle `event` by `handle`, which may delete both.
  template <class Handle>
  bool handle(const QObject& receiver, const QEvent& event, const Handle& handle) {
    const Entered entered(*this, {receiver.metaObject()->className(), receiver.objectName(), namedAbove(receiver), event.type()});
    return handle();
  }

  /// The thread waits for events from here on until wake(), but for those that are handled meanwhile: in a question's loop, or in the
  /// application's. What QAbstractEventDispatcher calls aboutToBlock and awake; an awake without the other changes nothing.
  void wait();
  void wake();
  /// Waits and wakes with a loop of this thread.
  void follow(const QAbstractEventDispatcher& loop);

  /// A part of a handler that answers for itself, such as the making of an image. Nothing happens where no watch runs.
  class Part {
   public:
    /// @param name that stays, and stands in logs: of what is done, never of whom or which file
    explicit Part(const char* name);
    ~Part();
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    HandlerWatch* watch_;
  };

  /// Slow ones, what took longest in all on the wall first.
  [[nodiscard]] std::vector<Slow> slow() const;
  /// Told of one that is slow for the first time, or took twice as long as ever before.
  std::function<void(const Slow&)> told;

 private:
  struct Handled {
    const char* className = nullptr;
    QString name;
    QString nameAbove;  ///< of the nearest parent that has one
    QEvent::Type type = QEvent::None;
    const char* part = nullptr;  ///< of a handler, in place of all that
    bool isWaiting = false;
    Times begun{};
    Times inside{};  ///< what was handled meanwhile
  };
  struct Entered {
    Entered(HandlerWatch& watch, Handled handled);
    ~Entered();
    Entered(const Entered&) = delete;
    Entered& operator=(const Entered&) = delete;
    HandlerWatch& watch;
  };
  static Times threadNow();
  static QString namedAbove(const QObject& receiver);
  static QString nameOf(const Handled& handled);
  void enter(Handled handled);
  void leave();

  double bound_ms_;
  std::function<Times()> now_;
  HandlerWatch* before_;  ///< that watched this thread when this one began
  QObject follower_;
  std::vector<Handled> open_;
  std::map<QString, Slow> slow_;
};

}  // namespace ew
