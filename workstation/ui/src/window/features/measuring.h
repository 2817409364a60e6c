#pragma once

#include <QPointer>
#include <vector>

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::ui {

class CombineDialog;
class WorksheetDialog;

/// Calipers on the scan and the worksheets they fill.
class Measuring final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;
  ~Measuring() override;

  void addMenu(QMenu& measure);
  void connectParts() override;
  void holdUnsavedWork(UnsavedWork& list) override;

 private:
  void showTools();
  void showWorksheet();
  void showCombine();
  bool saveMeasurements();
  bool saveWorksheet();
  [[nodiscard]] bool mayLeaveWorksheet(const QString& next);
  [[nodiscard]] bool mayLeaveMeasurements(const QString& next);

  QPointer<WorksheetDialog> worksheet_;
  QPointer<CombineDialog> combine_;
  std::vector<QAction*> tools_;  ///< as measurement::drawnKinds(), then stripKinds()
  QAction* followEdges_ = nullptr;
  QAction* snap_ = nullptr;
};

}  // namespace ew::ui
