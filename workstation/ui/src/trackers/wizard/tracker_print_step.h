#pragma once

#include <string>

#include "trackers/wizard/tracker_step.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace ew::ui {

class Trackers;

/// The paper: which body, the sheet as a file to print, and what the printer made of its scale.
class TrackerPrintStep final : public TrackerStep {
  Q_OBJECT

 public:
  TrackerPrintStep(Trackers& trackers, std::string tracker, QWidget* parent = nullptr);
  [[nodiscard]] bool isDone() const override;
  [[nodiscard]] bool mayGoOn() const override { return true; }
  void enter() override;

 private:
  void save();
  void chooseBody();

  Trackers& trackers_;
  std::string tracker_;
  QComboBox *bodies_ = nullptr, *papers_ = nullptr;
  QDoubleSpinBox* scale_ = nullptr;
  QCheckBox* ready_ = nullptr;
  QLabel* answer_ = nullptr;
};

/// Asks where, and writes the sheet of a body with its board and the chess board. @return what to tell; empty: nothing was written
QString saveTrackerSheet(Trackers& trackers, const std::string& body, bool isLetter, QWidget* parent, bool* isProblem);

}  // namespace ew::ui
