#pragma once

#include <QWidget>
#include <vector>

#include "ew/measurement/findings.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ew::ui {

class Calipers;

/// Keeps the height that a wrapped text needs at a width: a layout that asks its minimum alone gives it one line, and squeezes its
/// neighbours.
void holdHeight(QLabel& text, int width_px);

/// On the page of measurements: results over several of them, and what is done with all that was measured. A click on a line says how it
/// came about.
class ResultsList final : public QWidget {
  Q_OBJECT

 public:
  explicit ResultsList(Calipers& calipers, QWidget* parent = nullptr);

 Q_SIGNALS:
  void combineAsked();
  void saveAsked();

 private:
  void showAll();

  Calipers& calipers_;
  QPushButton *combine_ = nullptr, *save_ = nullptr;
  QVBoxLayout* list_ = nullptr;
  struct Line {
    QPushButton* button = nullptr;
    QLabel* name = nullptr;
    QLabel* value = nullptr;
    int number = 0;
  };
  std::vector<Line> lines_;
  QLabel* how_ = nullptr;
  QPushButton* remove_ = nullptr;
  int chosen_ = 0;
};

}  // namespace ew::ui
