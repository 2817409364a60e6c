#include "ew/widgets/figures.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ew/core/figures.h"

namespace ew {
namespace {

int digitWidth_px(const QFontMetrics& metrics) {
  int widest = 0;
  for (char digit = '0'; digit <= '9'; ++digit) widest = std::max(widest, metrics.horizontalAdvance(QLatin1Char(digit)));
  return widest;
}

/// Words that are read from the right hang together; they cannot be set letter by letter.
bool isFromTheRight(const QString& text) {
  return std::any_of(text.begin(), text.end(), [](QChar c) {
    return c.direction() == QChar::DirR || c.direction() == QChar::DirAL || c.direction() == QChar::DirRLE ||
           c.direction() == QChar::DirRLO;
  });
}

bool isFigure(QChar c) { return c >= QLatin1Char('0') && c <= QLatin1Char('9'); }

}  // namespace

QString figure(double value, int decimals) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(value, 'f', decimals);
}

QString signedFigure(double value, int decimals) {
  QString plain = figure(std::abs(value), decimals);
  if (plain == figure(0.0, decimals)) return plain;
  return (value < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) + plain;
}

QString clockText(double time_s) {
  return QString::fromStdString(minutesText(time_s)).replace(QLatin1Char('.'), QString(QLocale().decimalPoint()));
}

QString clockSeconds(double time_s) { return QString::fromStdString(minutesText(time_s)).section(QLatin1Char('.'), 0, 0); }

QString memoryText(double bytes) {
  const auto [value, decimals, isGibibytes] = memoryFigure(bytes);
  return (isGibibytes ? QStringLiteral("%1 GiB") : QStringLiteral("%1 MiB")).arg(figure(value, decimals));
}

QString inSeconds(double seconds) {
  if (seconds < 99.5)
    return QCoreApplication::translate("ew::figures", "%1 s").arg(figure(seconds, seconds < 0.095 ? 2 : seconds < 9.95 ? 1 : 0));
  const int whole = static_cast<int>(std::lround(seconds));
  return QCoreApplication::translate("ew::figures", "%1 min %2 s").arg(whole / 60).arg(whole % 60);
}

QString percent(double share) { return QLocale().toString(100.0 * share, 'f', 0) + QStringLiteral(" %"); }

int figuresWidth_px(const QFontMetrics& metrics, const QString& text) {
  if (isFromTheRight(text)) return metrics.horizontalAdvance(text);
  const int digit = digitWidth_px(metrics);
  int width = 0;
  for (const QChar c : text) width += isFigure(c) ? digit : metrics.horizontalAdvance(c);
  return width;
}

void drawFigures(QPainter& painter, const QRect& box, Qt::Alignment alignment, const QString& text) {
  const QFontMetrics metrics = painter.fontMetrics();
  const int digit = digitWidth_px(metrics);
  const int width = figuresWidth_px(metrics, text);
  int x = box.left();
  if (alignment & Qt::AlignRight) x = box.right() + 1 - width;
  if (alignment & Qt::AlignHCenter) x = box.left() + (box.width() - width) / 2;
  const int baseline = box.top() + (box.height() + metrics.ascent() - metrics.descent()) / 2;
  if (isFromTheRight(text)) return painter.drawText(x, baseline, text);
  for (const QChar c : text) {
    const int advance = metrics.horizontalAdvance(c);
    const int cell = isFigure(c) ? digit : advance;
    painter.drawText(x + (cell - advance) / 2, baseline, QString(c));
    x += cell;
  }
}

FigureLabel::FigureLabel(const QString& widest, QWidget* parent) : QLabel(parent), widest_(widest) {
  setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

QSize FigureLabel::sizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  const QMargins margins = contentsMargins();
  const int width = std::max(figuresWidth_px(metrics, widest_), figuresWidth_px(metrics, text()));
  return {width + margins.left() + margins.right(), metrics.height() + margins.top() + margins.bottom()};
}

void FigureLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(font());
  painter.setPen(palette().color(foregroundRole()));
  drawFigures(painter, contentsRect(), alignment(), text());
}

}  // namespace ew
