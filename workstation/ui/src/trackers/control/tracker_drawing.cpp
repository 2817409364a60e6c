#include "trackers/control/tracker_drawing.h"

#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

#include "ew/widgets/theme.h"

namespace ew::ui {

TrackerDrawing::TrackerDrawing(const QString& name, const QString& said, QWidget* parent) : QWidget(parent) {
  QFile file(QStringLiteral(":/ew/icons/%1.svg").arg(name));
  if (file.open(QIODevice::ReadOnly)) svg_ = file.readAll();
  setAccessibleName(said);
  setToolTip(said);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize TrackerDrawing::sizeHint() const { return {scaled(560), scaled(220)}; }
QSize TrackerDrawing::minimumSizeHint() const { return {scaled(280), scaled(110)}; }

void TrackerDrawing::paintEvent(QPaintEvent*) {
  QByteArray coloured = svg_;
  coloured.replace("currentColor", currentTheme().quiet.name().toLatin1());
  coloured.replace("#00ffff", currentTheme().accent.name().toLatin1());
  QSvgRenderer renderer(coloured);
  if (!renderer.isValid()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QSizeF size = QSizeF(renderer.defaultSize()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  renderer.render(&painter, QRectF((width() - size.width()) / 2.0, (height() - size.height()) / 2.0, size.width(), size.height()));
}

}  // namespace ew::ui
