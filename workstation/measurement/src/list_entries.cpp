#include "ew/measurement/list_entries.h"

namespace ew::measurement {
namespace {

FigureKind figureKindOf(ItemMeasure measure) {
  switch (measure) {
    case ItemMeasure::circumference:
      return FigureKind::circumference;
    case ItemMeasure::area:
      return FigureKind::area;
    case ItemMeasure::volume:
      return FigureKind::volume;
    case ItemMeasure::angle:
      return FigureKind::angle;
    case ItemMeasure::ratio:
      return FigureKind::ratio;
    case ItemMeasure::slope:
      return FigureKind::slope;
    case ItemMeasure::heartRate:
      return FigureKind::heartRate;
    case ItemMeasure::duration:
      return FigureKind::duration;
    case ItemMeasure::distance:
    case ItemMeasure::velocity:
    case ItemMeasure::number:
    case ItemMeasure::choice:
      break;
  }
  return FigureKind::length;
}

}  // namespace

const CaliperFigure* figureFor(ItemMeasure measure, const Measured& measured) {
  // No caliper of an image or of its strip reads a spectrum.
  if (measure == ItemMeasure::choice || measure == ItemMeasure::velocity || measured.figures.empty()) return nullptr;
  if (measure == ItemMeasure::number) return &measured.figures.front();
  return measured.figure(figureKindOf(measure));
}

Result<std::optional<WorksheetEntry>> entryOf(const Measurement& measurement, const Package& package, const UncertaintyAt& at) {
  const PackageItem* item = package.item(measurement.item);
  if (item == nullptr) return std::nullopt;
  const auto measured = measure(measurement.caliper, at);
  if (!measured) return std::nullopt;
  const CaliperFigure* figure = figureFor(item->measure, *measured);
  if (figure == nullptr)
    return failure(ErrorCode::badField, say<"Measurement %1 was made for %2, but gives no %3; measure it with another caliper.">(
                                            measurement.number, item->label, std::string(wordOf(item->measure))));
  return WorksheetEntry{item->label, measurement.side, figure->quantity, {}, false};
}

}  // namespace ew::measurement
