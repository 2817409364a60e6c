#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "calipers.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ew::ui {

/// A line of the list: number, what it is and its main result, and below it the others. A click chooses it.
class MeasuredLine;
class Worksheets;

/// The console's page of measurements: the tools, and the list of what they measured with its uncertainty.
class MeasurePage final : public QWidget {
  Q_OBJECT

 public:
  MeasurePage(Calipers& calipers, Worksheets& worksheets, QWidget* parent = nullptr);
  ~MeasurePage() override;
  void refreshIcons();

 Q_SIGNALS:
  void worksheetAsked();

 private:
  void addTools(QVBoxLayout* rows);
  void addEdits(QVBoxLayout* rows);
  void showIcons();
  void showAll();

  Calipers& calipers_;
  std::vector<QPushButton*> tools_;
  std::optional<measurement::CaliperKind> held_;  ///< as the icons show it
  QCheckBox* follows_ = nullptr;
  QLabel* empty_ = nullptr;
  QVBoxLayout* list_ = nullptr;
  std::vector<MeasuredLine*> lines_;
  QLabel* explanation_ = nullptr;
  QWidget* edits_ = nullptr;
  QPushButton *undo_ = nullptr, *redo_ = nullptr, *remove_ = nullptr, *clear_ = nullptr;
};

}  // namespace ew::ui
