#include "caliper_words.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>

#include "figures.h"

namespace ew::ui {

using measurement::CaliperKind;
using measurement::FigureKind;
using measurement::Unit;

QString CaliperWords::nameOf(CaliperKind kind) {
  switch (kind) {
    case CaliperKind::distance:
      return tr("Distance");
    case CaliperKind::polyLine:
      return tr("Poly-line");
    case CaliperKind::trace:
      return tr("Outline");
    case CaliperKind::ellipse:
      return tr("Ellipse");
    case CaliperKind::fittedEllipse:
      return tr("Fitted ellipse");
    case CaliperKind::angle:
      return tr("Angle");
    default:
      return QString::fromStdString(std::string(wordOf(kind)));
  }
}

QString CaliperWords::nameOf(FigureKind kind) {
  switch (kind) {
    case FigureKind::length:
      return tr("length");
    case FigureKind::circumference:
      return tr("circumference");
    case FigureKind::area:
      return tr("area");
    case FigureKind::longAxis:
      return tr("long axis");
    case FigureKind::shortAxis:
      return tr("short axis");
    case FigureKind::angle:
      return tr("angle");
    default:
      return QString::fromStdString(std::string(wordOf(kind)));
  }
}

QString CaliperWords::titleOf(const measurement::Measurement& measurement) {
  if (measurement.item.empty()) return nameOf(measurement.caliper.kind);
  QString item = QString::fromStdString(measurement.item).replace(QLatin1Char('_'), QLatin1Char(' '));
  if (measurement.side == "right") item += tr(" R", "right side, behind what was measured");
  if (measurement.side == "left") item += tr(" L", "left side, behind what was measured");
  return item;
}

QString CaliperWords::hintOf(CaliperKind kind) {
  switch (kind) {
    case CaliperKind::distance:
      return tr("Distance: click both ends, or drag from one to the other.");
    case CaliperKind::polyLine:
      return tr("Poly-line: click its points, the last one twice, or Enter.");
    case CaliperKind::trace:
      return tr("Outline: click around it or draw it; end where it began, or by Enter.");
    case CaliperKind::ellipse:
      return tr("Ellipse: click both ends of one axis, then how far it opens.");
    case CaliperKind::fittedEllipse:
      return tr("Fitted ellipse: click five or more points of the outline, the last one twice, or Enter.");
    case CaliperKind::angle:
      return tr("Angle: click a point, the vertex, a point.");
    default:
      return {};
  }
}

QString CaliperWords::iconOf(CaliperKind kind) {
  QString word = QString::fromStdString(std::string(wordOf(kind)));
  return QStringLiteral("caliper-") + word.replace(QLatin1Char('_'), QLatin1Char('-'));
}

QString CaliperWords::textOf(const measurement::Quantity& quantity) {
  QString text = QString::fromStdString(shown(quantity.unit == Unit::mm2 ? converted(quantity, Unit::cm2) : quantity));
  text.replace(QLatin1Char('.'), QLocale().decimalPoint());
  if (text.endsWith(QLatin1String("cm2"))) text.replace(text.size() - 1, 1, QStringLiteral("²"));
  if (text.endsWith(QLatin1String(" deg"))) text.replace(text.size() - 4, 4, QStringLiteral("°"));
  return text;
}

QString CaliperWords::mainResult(const measurement::Measured& measured) {
  return measured.figures.empty() ? QString() : textOf(measured.figures.front().quantity);
}

QString CaliperWords::otherResults(const measurement::Measured& measured, const QString& between) {
  QStringList all;
  for (std::size_t n = 1; n < measured.figures.size(); ++n)
    all << tr("%1 %2", "a result's name and its value").arg(nameOf(measured.figures[n].kind), textOf(measured.figures[n].quantity));
  return all.join(between);
}

QString CaliperWords::howItCameAbout(const measurement::Caliper& caliper, const measurement::UncertaintyAt& at) {
  if (!at) return {};
  double pixel_mm = 0.0, axial_mm = 0.0, narrowest_mm = 1e9, widest_mm = 0.0;
  for (const auto& part : caliper.parts)
    for (const glm::dvec2& point : part.points) {
      const measurement::PointUncertainty there = at(part.picture, point);
      pixel_mm = there.pixel.x;
      axial_mm = there.axial_mm;
      narrowest_mm = std::min(narrowest_mm, there.lateral_mm);
      widest_mm = std::max(widest_mm, there.lateral_mm);
    }
  const QString low = figure(narrowest_mm, 1), high = figure(widest_mm, 1);
  return tr("± from the pixel (%1 mm), the resolution along the beam (%2 mm) and the width of the beam (%3 mm).")
      .arg(figure(pixel_mm, 2), figure(axial_mm, 1),
           low == high ? low : tr("%1 to %2", "from a smallest to a largest value").arg(low, high));
}

}  // namespace ew::ui
