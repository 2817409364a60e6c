#pragma once

#include <QDialog>
#include <vector>

#include "ew/measurement/findings.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace ew::ui {

class Calipers;

/// Results over several measurements, of one image or of several: which, of what, and what they give now. Stays open beside the scan
/// while further images are measured.
class CombineDialog final : public QDialog {
  Q_OBJECT

 public:
  CombineDialog(Calipers& calipers, QWidget* parent);

 private:
  void showInputs();
  void showResult();
  [[nodiscard]] measurement::CombinationKind kind() const;
  [[nodiscard]] std::vector<measurement::FigureRef> chosen() const;

  Calipers& calipers_;
  QComboBox* kind_ = nullptr;
  struct Row {
    QLabel* label = nullptr;
    QComboBox* choice = nullptr;
  };
  std::vector<Row> rows_;
  std::vector<measurement::FigureRef> offered_;  ///< as the rows' choices have them
  QLabel* result_ = nullptr;
  QLabel* how_ = nullptr;
  QPushButton* add_ = nullptr;
};

}  // namespace ew::ui
