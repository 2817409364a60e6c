#pragma once

#include <QWidget>
#include <optional>
#include <vector>

namespace ew {

/// A recording as a line: where it stands, where it was frozen, which part of it counts, and where something was marked. A click goes
/// there, a drag goes along; on the keyboard the arrows move by a second (Shift: five), Home and End to its ends. Where it is edited, the
/// ends of the part and the marks can be dragged: it asks for that, and shows what it is told.
class TimeLine final : public QWidget {
  Q_OBJECT

 public:
  struct Span {
    double begin_s = 0.0, end_s = 0.0;
  };
  enum class Use {
    played,
    edited,  ///< arrows move by half a second, Home and End to the ends of the part; '[' lets it begin and ']' lets it end here
  };
  explicit TimeLine(Use use = Use::played, QWidget* parent = nullptr);

  /// Another recording, from 0, which stands at its beginning.
  void setLength(double length_s, std::vector<Span> frozen, std::vector<double> marks_s);
  /// The same recording, where its clock does not begin at 0.
  void setSpan(double first_s, double last_s);
  void setMarks(std::vector<double> marks_s);
  void setPosition(double position_s);
  /// The part that counts, where its ends are marked.
  void setRange(std::optional<double> in_s, std::optional<double> out_s);
  [[nodiscard]] double position_s() const { return position_s_; }
  [[nodiscard]] double first_s() const { return first_s_; }
  [[nodiscard]] double last_s() const { return last_s_; }
  void moveTo(double position_s) { goTo(position_s); }  ///< as a person would
  [[nodiscard]] QSize sizeHint() const override { return {320, 32}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {96, 32}; }

 Q_SIGNALS:
  void moved(double position_s);               ///< by a person
  void rangeAsked(double in_s, double out_s);  ///< the part is to be this one
  void markAsked(int number, double time_s);   ///< the mark is to be moved there
  void released();                             ///< an end or a mark was let go

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Held { place, begin, end, mark };
  void goTo(double position_s);
  void takeHold(const QPointF& at);
  void dragTo(double x);
  [[nodiscard]] double in() const { return in_s_.value_or(first_s_); }
  [[nodiscard]] double out() const { return out_s_.value_or(last_s_); }
  [[nodiscard]] double xOf(double position_s) const;
  [[nodiscard]] double positionAt(double x) const;

  Use use_;
  double first_s_ = 0.0, last_s_ = 0.0, position_s_ = 0.0;
  std::vector<Span> frozen_;
  std::vector<double> marks_s_;
  std::optional<double> in_s_, out_s_;
  Held held_ = Held::place;
  int heldMark_ = -1;
};

}  // namespace ew
