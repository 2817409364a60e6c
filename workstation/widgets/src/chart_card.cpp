#include "ew/widgets/chart_card.h"

#include <QPainter>
#include <QWidget>

#include "ew/widgets/theme.h"

namespace ew {

void paintChartCard(QPainter& painter, const QWidget& on) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(currentTheme().ground);
  painter.drawRoundedRect(on.rect(), 4, 4);
  painter.setBrush(Qt::NoBrush);
  painter.setFont(smallFont());
}

void paintEmptyChart(QPainter& painter, const QWidget& on, const QString& sentence) {
  painter.setPen(currentTheme().quiet);
  painter.drawText(on.rect().adjusted(2 * kGrid_px, kGrid_px, -2 * kGrid_px, -kGrid_px), Qt::AlignCenter | Qt::TextWordWrap, sentence);
}

}  // namespace ew
