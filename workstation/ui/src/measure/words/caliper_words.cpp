#include "measure/words/caliper_words.h"

#include <QKeySequence>
#include <QStringList>

#include "ew/widgets/words.h"

namespace ew::ui {

using measurement::CaliperKind;
using measurement::FigureKind;

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
    case CaliperKind::discs:
      return tr("Volume by discs");
    case CaliperKind::interval:
      return tr("Time");
    case CaliperKind::heartRate:
      return tr("Heart rate");
    case CaliperKind::slope:
      return tr("Slope");
    case CaliperKind::depthDistance:
      return tr("Depth");
    case CaliperKind::ratio:
      return tr("Ratio");
    case CaliperKind::ellipsoid:
      return tr("Volume, ellipsoid");
    case CaliperKind::biplane:
      return tr("Volume, discs of two planes");
  }
  return QString::fromStdString(std::string(wordOf(kind)));
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
    case FigureKind::volume:
      return tr("volume");
    case FigureKind::duration:
      return tr("time");
    case FigureKind::slope:
      return tr("slope");
    case FigureKind::heartRate:
      return tr("heart rate");
    case FigureKind::ratio:
      return tr("ratio");
  }
  return QString::fromStdString(std::string(wordOf(kind)));
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
    case CaliperKind::discs:
      return tr("Volume by discs: click both ends of the long axis, then around the outline; end where the outline began, or by Enter.");
    case CaliperKind::interval:
      return tr("Time: click both moments in the strip.");
    case CaliperKind::heartRate:
      return tr("Heart rate: click the same moment of two beats in the strip.");
    case CaliperKind::slope:
      return tr("Slope: click both ends along the moving echo in the strip.");
    case CaliperKind::depthDistance:
      return tr("Depth: click both depths in the strip.");
    case CaliperKind::ratio:
    case CaliperKind::ellipsoid:
    case CaliperKind::biplane:
      break;  // of several measurements, none of which is drawn for it
  }
  return {};
}

QString CaliperWords::iconOf(CaliperKind kind) {
  QString word = QString::fromStdString(std::string(wordOf(kind)));
  return QStringLiteral("caliper-") + word.replace(QLatin1Char('_'), QLatin1Char('-'));
}

QString CaliperWords::textOf(const measurement::Quantity& quantity) { return words(quantityText(quantity)); }

QString CaliperWords::mainResult(const measurement::Measured& measured) {
  return measured.figures.empty() ? QString() : textOf(measured.figures.front().quantity);
}

QString CaliperWords::otherResults(const measurement::Measured& measured, const QString& between) {
  QStringList all;
  for (std::size_t n = 1; n < measured.figures.size(); ++n)
    all << tr("%1 %2", "a result's name and its value").arg(nameOf(measured.figures[n].kind), textOf(measured.figures[n].quantity));
  return all.join(between);
}

QString CaliperWords::numberOf(Where where, int number) {
  switch (where) {
    case Where::image:
      return QString::number(number);
    case Where::strip:
      return tr("M%1", "number of a measurement in the M-mode").arg(number);
  }
  return {};
}

QString CaliperWords::snapWord(const measurement::SnapTarget& target, bool isInStrip) {
  switch (target.kind) {
    case measurement::SnapKind::point:
      return tr("cross %1").arg(numberOf(isInStrip ? Where::strip : Where::image, target.number));
    case measurement::SnapKind::edge:
      return tr("edge");
    case measurement::SnapKind::horizontal:
      return isInStrip ? tr("same depth") : tr("horizontal");
    case measurement::SnapKind::vertical:
      return isInStrip ? tr("same moment") : tr("vertical");
    case measurement::SnapKind::none:
      break;
  }
  return {};
}

}  // namespace ew::ui
