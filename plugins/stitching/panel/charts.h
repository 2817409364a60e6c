#pragma once

#include <QPointF>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "ew/core/chart_axis.h"
#include "ew/registration/elastic.h"
#include "ew/registration/rigid.h"
#include "ew/stitching/cost_estimate.h"

namespace ew::stitching {

class StitchLook;
class StitchRuns;
class StitchSession;

/// Correlation before and after each level, from the coarse to the fine, of matching and then of bending; grows while it runs.
class LevelChart final : public QWidget {
  Q_OBJECT

 public:
  explicit LevelChart(StitchSession& session, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override { return {240, 104}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  using Levels = std::vector<registration::Level>;
  /// Levels side by side, correlation upwards.
  struct LevelPlot {
    QRectF box;
    double last;  ///< number of the last level
    ChartAxis correlation;

    LevelPlot(const Levels& levels, const QRectF& in);
    [[nodiscard]] QPointF at(double level, double value) const;
  };
  void paintGrid(QPainter& painter, const LevelPlot& plot) const;
  void paintDivide(QPainter& painter, const LevelPlot& plot, std::size_t matched) const;
  void paintSteps(QPainter& painter, const LevelPlot& plot, const Levels& levels) const;
  void paintCurve(QPainter& painter, const LevelPlot& plot, const Levels& levels, std::size_t begin, std::size_t end) const;

  const StitchLook& look_;
  const StitchRuns& runs_;
};

/// Time against error at each effort of bending: what is expected, what is in use, and what it took. A click on a point chooses its effort
/// for the pair.
class CostChart final : public QWidget {
  Q_OBJECT

 public:
  explicit CostChart(QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override { return {240, 120}; }
  void show(const std::array<CostEstimate, 3>& costs, registration::ElasticEffort inUse, std::optional<double> measured_s);
  void clear();
  Q_INVOKABLE QPointF pointOfEffort(int effort) const;

 Q_SIGNALS:
  void chosen(int effort);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QRectF box() const;
  [[nodiscard]] QPointF at(double seconds, double error_mm) const;
  [[nodiscard]] int under(const QPointF& at) const;  ///< effort; -1: none
  std::optional<std::array<CostEstimate, 3>> costs_;
  registration::ElasticEffort inUse_ = registration::ElasticEffort::balanced;
  std::optional<double> measured_s_;
  ChartAxis time_s_;
  ChartAxis error_mm_;
};

[[nodiscard]] QString nameOfEffort(registration::ElasticEffort effort);  ///< in the language of the window

}  // namespace ew::stitching
