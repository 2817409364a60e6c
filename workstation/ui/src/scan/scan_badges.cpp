#include "scan/scan_badges.h"

#include <QPainter>

#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/theme.h"

namespace ew::ui {

int badgeHeight_px() { return scaled(26); }

void paintFrozenBadge(QPainter& painter, int width, const QString& word) {
  const Theme theme = scanTheme();
  painter.setFont(bold(textFont()));
  const int flake_px = scaled(16);
  const int width_px = painter.fontMetrics().horizontalAdvance(word) + 24 + flake_px + 6;
  const QRect badge(width - 16 - width_px, 8, width_px, badgeHeight_px());
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.accent);
  painter.drawRoundedRect(badge, 4.0, 4.0);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(theme.onAccent);
  icon(QStringLiteral("freeze"), theme.onAccent)
      .paint(&painter, QRect(badge.left() + 12, badge.center().y() - flake_px / 2, flake_px, flake_px));
  painter.drawText(badge.adjusted(flake_px + 6, 0, 0, 0), Qt::AlignCenter, word);
}

void paintRecordingTime(QPainter& painter, int right, int top, double length_s) {
  const Theme theme = scanTheme();
  painter.setFont(smallFont());
  const int whole_s = static_cast<int>(length_s);
  const QString length = QStringLiteral("%1:%2").arg(whole_s / 60).arg(whole_s % 60, 2, 10, QLatin1Char('0'));
  const int length_px = figuresWidth_px(painter.fontMetrics(), length);
  const int left = right - length_px;
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.danger);
  painter.drawEllipse(QPointF(left - 14.0, top + scaled(12.0)), 6.0, 6.0);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(theme.text);
  drawFigures(painter, QRect(left, top, length_px + 8, scaled(24)), Qt::AlignLeft, length);
}

}  // namespace ew::ui
