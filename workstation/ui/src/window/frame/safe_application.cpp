#include "window/frame/safe_application.h"

#include <spdlog/spdlog.h>

#include <QEvent>

namespace ew::ui {

bool SafeApplication::notify(QObject* receiver, QEvent* event) {
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
