#pragma once

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::ui {

/// The lock for trainees on an account that they share with instructors: what the window shows while it is closed.
class AccessLock final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addActions(QMenu& file);
  void refresh() override;
  /// Whether a file may be opened: not while it is in somebody else's attempt and the library is locked. Says why not.
  [[nodiscard]] bool mayOpen(const QString& path);

 private:
  void lock();
  void unlock();
  void remove();
  void changed();

  QAction* lock_ = nullptr;
  QAction* unlock_ = nullptr;
  QAction* remove_ = nullptr;
};

}  // namespace ew::ui
