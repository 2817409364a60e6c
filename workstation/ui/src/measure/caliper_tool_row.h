#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "ew/measurement/caliper.h"

class QGridLayout;
class QPushButton;

namespace ew::ui {

class Calipers;

/// Which of a row of buttons stand two on a line, and which alone: two that follow each other share a line when each fits into half of it.
/// @param widths_px that the buttons need @param room_px of a line @param gap_px between two on a line
/// @return how many stand on each line, 1 or 2
[[nodiscard]] std::vector<int> buttonsOnLines(const std::vector<int>& widths_px, int room_px, int gap_px);

/// Buttons with icon and word, each of which takes a tool for calipers; the one that is held is checked. Two stand on a line where their
/// words have room.
class CaliperToolRow final : public QWidget {
  Q_OBJECT

 public:
  /// @param nameOf of a tool, as its tip begins
  CaliperToolRow(Calipers& calipers, std::vector<measurement::CaliperKind> kinds,
                 const std::function<QString(measurement::CaliperKind)>& nameOf, QWidget* parent = nullptr);
  /// Icons in the colours of the theme that is shown.
  void refreshIcons();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void showHeld();
  void arrange();

  Calipers& calipers_;
  std::vector<measurement::CaliperKind> kinds_;
  std::vector<QPushButton*> buttons_;
  QGridLayout* lines_ = nullptr;
  std::vector<int> onLines_;                      ///< as they stand
  std::optional<measurement::CaliperKind> held_;  ///< as the icons show it
};

}  // namespace ew::ui
