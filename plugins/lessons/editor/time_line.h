#pragma once

#include <QWidget>
#include <optional>
#include <vector>

namespace ew::lessons {

/// A recording along its time: which part of it is shown, its marks, and where it is looked at. The ends of the part and the marks are
/// dragged; a click anywhere else looks there. On the keyboard the arrows look half a second on or back, Home and End go to the ends of the
/// part, '[' lets it begin and ']' lets it end here. It shows what it is told, and asks for the rest.
class TimeLine final : public QWidget {
  Q_OBJECT

 public:
  explicit TimeLine(QWidget* parent = nullptr);

  /// @param first_s, last_s of the recording
  void setRecording(double first_s, double last_s);
  void setPart(double begin_s, double end_s);
  void setMarks(const std::vector<double>& marks_s);
  void setAt(double time_s);
  [[nodiscard]] double at_s() const { return at_s_; }
  [[nodiscard]] QSize sizeHint() const override;
  /// Where a moment is, in pixels of the widget.
  [[nodiscard]] double xOf(double time_s) const;

 Q_SIGNALS:
  void lookAsked(double time_s);
  void partAsked(double begin_s, double end_s);
  void markAsked(int number, double time_s);  ///< the mark is to be moved there
  void released();                            ///< a drag has ended

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Held { nothing, begin, end, mark, place };
  [[nodiscard]] double timeAt(double x_px) const;
  void dragTo(double x_px);

  double first_s_ = 0.0, last_s_ = 1.0, begin_s_ = 0.0, end_s_ = 1.0, at_s_ = 0.0;
  std::vector<double> marks_s_;
  Held held_ = Held::nothing;
  int heldMark_ = -1;
};

}  // namespace ew::lessons
