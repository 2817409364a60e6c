#include "scan/zoom/wide_layer.h"

#include <QPainter>

#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "scan/scan_view.h"
#include "scan/session.h"
#include "scan/zoom/wide_scan.h"

namespace ew::ui {

WideLayer::WideLayer(Session& session, WideScan& wide, ScanView& scan) : QWidget(&scan), session_(session), wide_(wide), scan_(scan) {
  setObjectName(QStringLiteral("wideLayer"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
  connect(&wide_, &WideScan::changed, this, &WideLayer::follow);
  connect(&session_, &Session::imageChanged, this, &WideLayer::follow);
}

void WideLayer::follow() {
  setVisible(session_.wide() != nullptr);
  if (isHidden()) return;
  if (geometry() != scan_.imageRect()) setGeometry(scan_.imageRect());
  update();
}

QString WideLayer::text() const { return tr("Wide image, %1 cm across").arg(figure(wide_.growth().length_mm / 10.0, 1)); }

void WideLayer::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme theme = scanTheme();
  const bool isGrowing = wide_.state() == WideScan::State::growing;
  if (isGrowing && wide_.growth().fan_mm.size() > 2) {
    QPolygonF outline;
    for (const glm::dvec2& p_mm : wide_.growth().fan_mm) outline << scan_.positionOf({{p_mm.x, p_mm.y, 0.0}}) - QPointF(pos());
    painter.setPen(QPen(wide_.growth().latest == Woven::woven ? theme.accent : theme.danger, 1.5));
    painter.drawPolyline(outline);
  }
  painter.setFont(smallFont());
  const QString words = text();
  QRect box(0, 0, figuresWidth_px(painter.fontMetrics(), words) + 20, 24);
  box.moveTo((width() - box.width()) / 2, 4);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 170));
  painter.drawRoundedRect(box, 4.0, 4.0);
  painter.setPen(theme.text);
  drawFigures(painter, box.adjusted(10, 0, -10, 0), Qt::AlignLeft, words);
}

}  // namespace ew::ui
