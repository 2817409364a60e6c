#pragma once

#include <QPointer>

#include "window/frame/feature.h"

class QAction;
class QMenu;
class QPoint;

namespace ew::ui {

class CostPanel;
class SourceDialog;

/// Where a point of the image came from, and what an image costs.
class Inspecting final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;
  ~Inspecting() override;

  void addSourceAction(QMenu& scan);
  void addCostAction(QMenu& scan);
  void connectParts() override;
  void refresh() override;

 private:
  void showCost();
  void showSource(const QPoint& pixel);

  QPointer<CostPanel> cost_;
  QPointer<SourceDialog> dialog_;
  QAction* source_ = nullptr;
};

}  // namespace ew::ui
