#include "panel/review_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <cmath>

#include "ew/assessment/judging.h"
#include "ew/widgets/figures.h"

namespace ew::review {
QColor colourOf(Who who, bool onDark) {
  if (who == Who::expert) return onDark ? QColor(110, 165, 245) : QColor(25, 95, 190);
  return onDark ? QColor(240, 160, 70) : QColor(185, 90, 0);
}

const char* workspaceIcon() {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" width="24" height="24" viewBox="0 0 24 24" fill="none" stroke="currentColor" stroke-width="1.75" stroke-linecap="round" stroke-linejoin="round"><path d="M7 4.5 3.5 14h7zM17 4.5 13.5 14h7zM3.5 19h17M9 17.5v3"/></svg>)";
}

QString percentBeside(double share, double level) {
  const bool isHidden = !reachesLevel(share, level) && std::round(100.0 * share) >= std::round(100.0 * level);
  return isHidden ? QLocale().toString(std::floor(1000.0 * share) / 10.0, 'f', 1) + QStringLiteral(" %") : percent(share);
}

QString titleOf(TrackKind kind) {
  const auto in = [](const char* text) { return QCoreApplication::translate("ew::review", text); };
  switch (kind) {
    case TrackKind::pose:
      return in(QT_TRANSLATE_NOOP("ew::review", "Valid pose"));
    case TrackKind::contact:
      return in(QT_TRANSLATE_NOOP("ew::review", "Contact"));
    case TrackKind::settings:
      return in(QT_TRANSLATE_NOOP("ew::review", "Settings"));
    case TrackKind::freeze:
      return in(QT_TRANSLATE_NOOP("ew::review", "Freeze"));
    case TrackKind::measurement:
      return in(QT_TRANSLATE_NOOP("ew::review", "Measurements"));
    case TrackKind::answer:
      return in(QT_TRANSLATE_NOOP("ew::review", "Answers"));
    case TrackKind::mark:
      return in(QT_TRANSLATE_NOOP("ew::review", "Marks"));
    case TrackKind::comment:
      return in(QT_TRANSLATE_NOOP("ew::review", "Comments"));
  }
  return {};
}

QString wordOf(Who who) {
  switch (who) {
    case Who::trainee:
      return QCoreApplication::translate("ew::review", "Trainee");
    case Who::expert:
      return QCoreApplication::translate("ew::review", "Expert");
  }
  return {};
}

void drawMarkOf(QPainter& painter, Who who, const QPointF& at, double radius_px) {
  if (who == Who::trainee) {
    painter.drawEllipse(at, radius_px, radius_px);
    return;
  }
  const double r = 1.3 * radius_px;
  painter.drawPolygon(QPolygonF({at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)}));
}

}  // namespace ew::review
