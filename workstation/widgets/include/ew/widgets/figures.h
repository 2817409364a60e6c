#pragma once

#include <QLabel>
#include <QPainter>
#include <QString>

namespace ew {

/// A number with so many decimals, as the window's language writes it: 3.5, in German 3,5.
[[nodiscard]] QString figure(double value, int decimals);

/// The same with its sign: +3.5, −3.5 and, when nothing but zeros is left of it, 0.0.
[[nodiscard]] QString signedFigure(double value, int decimals);

/// A time as "1:05.2", in German "1:05,2"; before the beginning "-0:01.0".
[[nodiscard]] QString clockText(double time_s);
/// The same without the tenths: "1:05".
[[nodiscard]] QString clockSeconds(double time_s);
/// A duration as "0.3 s", "2 min 5 s".
[[nodiscard]] QString inSeconds(double seconds);
/// Memory as "3.5 MiB", "512 MiB", "1.5 GiB".
[[nodiscard]] QString memoryText(double bytes);
/// A share of 0.67 as "67 %".
[[nodiscard]] QString percent(double share);

/// Width of `text` when every digit takes the width of the widest one, so that a changing number does not move its neighbours. Qt 5
/// cannot ask a font for its tabular figures, so the digits are placed one by one.
[[nodiscard]] int figuresWidth_px(const QFontMetrics& metrics, const QString& text);

/// Draws `text` in `box` with tabular digits. @param alignment Qt::AlignLeft, AlignRight or AlignHCenter; vertically centred
void drawFigures(QPainter& painter, const QRect& box, Qt::Alignment alignment, const QString& text);

/// A label whose digits stand in columns; it asks for room for `widest` at once and so never changes its size.
class FigureLabel final : public QLabel {
  Q_OBJECT

 public:
  explicit FigureLabel(const QString& widest = {}, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString widest_;
};

}  // namespace ew
