#pragma once

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::ui {

/// Undo and redo of what is worked on: writing on the image, calipers, a panel's document or the case.
class Undo final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addMenu(QMenu& edit);
  void connectParts() override;
  void refresh() override;

 private:
  /// Whether undo and redo mean the calipers: an author's case has edits of its own, so there the calipers must have the keys.
  [[nodiscard]] bool editsCalipers() const;
  /// ... or the texts and arrows, by the same rule.
  [[nodiscard]] bool editsAnnotations() const;
  void undo();
  void redo();

  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
};

}  // namespace ew::ui
