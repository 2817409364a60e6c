#pragma once

class QPainter;
class QString;
class QWidget;

namespace ew {

/// The sunken card that a chart is painted on, as large as the widget; what follows is in the small font. Axes are core/chart_axis.h.
void paintChartCard(QPainter& painter, const QWidget& on);
/// Why there is nothing to be seen on it yet.
void paintEmptyChart(QPainter& painter, const QWidget& on, const QString& sentence);

}  // namespace ew
