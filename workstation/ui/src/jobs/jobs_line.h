#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "jobs/jobs.h"

class QFrame;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ew {
class EllipsisLabel;
class FigureLabel;
}  // namespace ew

namespace ew::ui {

/// Running work in the status line: a name, how far it is, a thin bar, cancel. It covers nothing and takes nothing away. It is seen for
/// jobs that have run longer than half a second; with several it shows the one somebody waits for, and a button unfolds all of them.
class JobsLine final : public QWidget {
  Q_OBJECT

 public:
  explicit JobsLine(Jobs& jobs, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 private:
  void refresh();
  void fold(bool open);
  void fillList();
  void placeList();

  Jobs& jobs_;
  QTimer poll_;
  std::vector<Jobs::Seen> seen_;  ///< that are shown, the one in front first
  int shown_ = 0;                 ///< id of the one in front
  int pressed_ = 0;               ///< of the one that stood in front when the button was pressed
  EllipsisLabel* title_ = nullptr;
  FigureLabel* percent_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* more_ = nullptr;
  QProgressBar* bar_ = nullptr;
  struct Row {
    int id;
    QLabel* step;
    QProgressBar* bar;
    QPushButton* cancel;
  };
  QPointer<QFrame> list_;  ///< of all of them, while it is asked for
  std::vector<Row> rows_;
};

}  // namespace ew::ui
