#pragma once

#include <QDialog>

#include "ew/sdk/host.h"

class QLabel;
class QPushButton;

namespace ew::case_authoring {

class RightsForm;
class SourceField;

/// Gives the open case a volume, or another one. The volume goes into the folder as a job; then the case is edited, as one step that can be
/// undone.
class GiveVolumeDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit GiveVolumeDialog(sdk::Host& host, QWidget* parent = nullptr);

 private:
  void look();
  void give();

  sdk::Host& host_;
  SourceField* source_ = nullptr;
  RightsForm* rights_ = nullptr;
  QLabel* problem_ = nullptr;
  QPushButton* give_ = nullptr;
};

}  // namespace ew::case_authoring
