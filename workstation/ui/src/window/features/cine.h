#pragma once

#include <vector>

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::ui {

/// Freezing, and the loop of the last images.
class Cine final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addFreezeAction(QMenu& scan);
  void addMenu(QMenu& cine);
  void connectParts() override;
  /// Its keys are those of the loop while that is open.
  void giveWay(QAction* action) { ofRunningScan_.push_back(action); }

 private:
  void showState();
  void saveClip();  ///< what runs in the loop of a frozen scan: as states, film or DICOM
  void sayWhyRefused();

  QAction* freeze_ = nullptr;
  std::vector<QAction*> ofLoop_;  ///< while there is a loop to look through
  std::vector<QAction*> ofRunningScan_;
};

}  // namespace ew::ui
