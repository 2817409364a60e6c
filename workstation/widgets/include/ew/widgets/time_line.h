#pragma once

#include <QWidget>
#include <optional>
#include <vector>

namespace ew {

/// A recording's length as a line: where it stands, where it was frozen, and where something was marked. A click goes there, a drag goes
/// along; on the keyboard the arrows move by a second (Shift: five), Home and End to its ends.
class TimeLine final : public QWidget {
  Q_OBJECT

 public:
  struct Span {
    double begin_s = 0.0, end_s = 0.0;
  };
  explicit TimeLine(QWidget* parent = nullptr);

  void setLength(double length_s, std::vector<Span> frozen, std::vector<double> marks_s);
  void setPosition(double position_s);
  /// The part that runs, where its ends are marked.
  void setRange(std::optional<double> in_s, std::optional<double> out_s);
  [[nodiscard]] double position_s() const { return position_s_; }
  [[nodiscard]] double length_s() const { return length_s_; }
  void moveTo(double position_s) { goTo(position_s); }  ///< as a person would
  [[nodiscard]] QSize sizeHint() const override { return {320, 32}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {96, 32}; }

 Q_SIGNALS:
  void moved(double position_s);  ///< by a person

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void goTo(double position_s);
  [[nodiscard]] double xOf(double position_s) const;
  [[nodiscard]] double positionAt(double x) const;

  double length_s_ = 0.0, position_s_ = 0.0;
  std::vector<Span> frozen_;
  std::vector<double> marks_s_;
  std::optional<double> in_s_, out_s_;
};

}  // namespace ew
