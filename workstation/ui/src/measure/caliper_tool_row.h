#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "ew/measurement/caliper.h"

class QPushButton;

namespace ew::ui {

class Calipers;

/// A row of buttons, each of which takes a tool for calipers; the one that is held is checked.
class CaliperToolRow final : public QWidget {
  Q_OBJECT

 public:
  /// @param nameOf of a tool, as its tip begins
  CaliperToolRow(Calipers& calipers, std::vector<measurement::CaliperKind> kinds,
                 const std::function<QString(measurement::CaliperKind)>& nameOf, QWidget* parent = nullptr);
  /// Icons in the colours of the theme that is shown.
  void refreshIcons();

 private:
  void showHeld();

  Calipers& calipers_;
  std::vector<measurement::CaliperKind> kinds_;
  std::vector<QPushButton*> buttons_;
  std::optional<measurement::CaliperKind> held_;  ///< as the icons show it
};

}  // namespace ew::ui
