#pragma once

#include <QApplication>
#include <QPointer>
#include <functional>

#include "ew/core/guarded.h"
#ifdef EW_CHECK_CONTRACTS
#include "ew/widgets/handler_watch.h"
#endif

namespace ew::ui {

/// The application of the window. An exception that a handler let through would end the program, and unsaved work with it; here it ends the
/// handling of that one event and is told. A window that was being closed stays open. A build that checks contracts watches how long
/// events are handled, and its log names who holds the window's thread for more than 2 ms.
class SafeApplication final : public QApplication {
  Q_OBJECT

 public:
  SafeApplication(int& argc, char** argv);
  ~SafeApplication() override;

  bool notify(QObject* receiver, QEvent* event) override;
  /// The same for what runs before or outside of the event loop. @return whether it came to its end
  bool attempt(const std::function<void()>& work);

 Q_SIGNALS:
  /// @param receiver that handled the event; null when it is gone, or when there was none
  void thrown(QObject* receiver, const ew::Thrown& what);

 private:
  bool handle(QObject* receiver, QEvent* event);
  void tell(const QPointer<QObject>& receiver, const Thrown& what);
#ifdef EW_CHECK_CONTRACTS
  HandlerWatch watch_;
#endif
};

}  // namespace ew::ui
