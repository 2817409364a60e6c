#pragma once

#include <QWidget>
#include <vector>

#include "ew/imaging/cost_of_accuracy.h"

namespace ew::ui {

/// Accuracy over time: one curve through the points, an axis of milliseconds, one of decibels with the grey levels they stand for, a line
/// at the accuracy that is asked for. Upwards is more exact, to the left is faster.
class CostChart final : public QWidget {
  Q_OBJECT

 public:
  struct Point {
    QString name;
    double frame_ms = 0.0;
    double psnr_db = 0.0;
    double rms_grey = 0.0;
    bool inUse = false;
    bool meetsWish = false;
  };
  explicit CostChart(QWidget* parent = nullptr);
  /// @param empty what is said while there are no points
  void show(std::vector<Point> points, double wished_db, const QString& empty);
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {440, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Point> points_;
  double wished_db_ = 0.0;
  QString empty_;
};

}  // namespace ew::ui
