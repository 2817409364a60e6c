#pragma once

#include <vector>

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::ui {

struct SnapshotPart;

/// One, two and four images at once, and how they are saved.
class Images final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addMenu(QMenu& images);
  void addSaveAction(QMenu& file);
  void connectParts() override;
  void refresh() override;

  [[nodiscard]] std::vector<SnapshotPart> shownParts() const;  ///< all images, as they are saved
  [[nodiscard]] int columns() const;

 private:
  void show();  ///< how many there are, and what was measured on each
  void save();

  std::vector<QAction*> counts_;  ///< 1, 2, 4
  QAction* next_ = nullptr;
  QAction* sameScale_ = nullptr;
  QAction* save_ = nullptr;
};

}  // namespace ew::ui
