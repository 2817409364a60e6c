#pragma once

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::ui {

/// Box zoom and the wide image.
class ZoomAndWide final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addActions(QMenu& console);
  void connectParts() override;

 private:
  void showState();

  QAction* boxZoom_ = nullptr;
  QAction* wide_ = nullptr;
};

}  // namespace ew::ui
