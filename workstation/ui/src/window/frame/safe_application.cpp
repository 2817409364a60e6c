#include "window/frame/safe_application.h"

#include <spdlog/spdlog.h>

#include <QAbstractEventDispatcher>
#include <QEvent>
#include <algorithm>

namespace ew::ui {

#ifdef EW_CHECK_CONTRACTS
SafeApplication::SafeApplication(int& argc, char** argv) : QApplication(argc, argv) {
  watch_.follow(*QAbstractEventDispatcher::instance());
  watch_.told = [](const HandlerWatch::Slow& slow) {
    spdlog::warn("Held the window's thread for {:.1f} ms, and worked for {:.1f}: {}", slow.worst.wall_ms, slow.worst.worked_ms,
                 slow.name.toStdString());
  };
}

SafeApplication::~SafeApplication() {
  constexpr std::size_t kWorthSaying = 12;
  const std::vector<HandlerWatch::Slow> all = watch_.slow();
  for (std::size_t n = 0; n < std::min(kWorthSaying, all.size()); ++n)
    spdlog::info("Held the window's thread {} times, {:.0f} ms in all (worked for {:.0f}), {:.1f} ms at most ({:.1f}): {}", all[n].count,
                 all[n].total.wall_ms, all[n].total.worked_ms, all[n].worst.wall_ms, all[n].worst.worked_ms, all[n].name.toStdString());
}

bool SafeApplication::notify(QObject* receiver, QEvent* event) {
  if (receiver->thread() != thread()) return handle(receiver, event);
  return watch_.handle(*receiver, *event, [&] { return handle(receiver, event); });
}
#else
SafeApplication::SafeApplication(int& argc, char** argv) : QApplication(argc, argv) {}
SafeApplication::~SafeApplication() = default;
bool SafeApplication::notify(QObject* receiver, QEvent* event) { return handle(receiver, event); }
#endif

bool SafeApplication::handle(QObject* receiver, QEvent* event) {
  const QPointer<QObject> watched(receiver);  // a handler may delete its object before it throws
  const bool closing = event->type() == QEvent::Close;
  const auto handled = guarded([&] { return QApplication::notify(receiver, event); },
                               [&](const Thrown& what) {
                                 if (closing) event->ignore();  // nobody was asked about unsaved work
                                 tell(watched, what);
                                 return Error{ErrorCode::internal, what.reason, {}};
                               });
  return handled.value_or(closing);
}

bool SafeApplication::attempt(const std::function<void()>& work) {
  return guarded(work,
                 [&](const Thrown& what) {
                   tell({}, what);
                   return Error{ErrorCode::internal, what.reason, {}};
                 })
      .has_value();
}

void SafeApplication::tell(const QPointer<QObject>& receiver, const Thrown& what) {
  // What cannot even be told must not end the program either.
  static_cast<void>(guarded(
      [&] {
        spdlog::error("A handler of the window failed: {}", what.reason.english());
        Q_EMIT thrown(receiver, what);
      },
      [](const Thrown&) { return Error{}; }));
}

}  // namespace ew::ui
