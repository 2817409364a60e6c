#include "import/screen_distances.h"

#include <algorithm>

#include "ew/widgets/figures.h"
#include "import/screen_dialog.h"
#include "measure/words/caliper_words.h"

namespace ew::ui {
namespace {

/// The points of a caliper in mm, where they are those of pixels.
measurement::Caliper inMillimetres(measurement::Caliper caliper, double pixel_mm) {
  for (auto& part : caliper.parts)
    for (glm::dvec2& point : part.points) point *= pixel_mm;
  return caliper;
}

}  // namespace

ScreenDistances distancesOf(const measurement::CaliperDrawing& drawn, const std::optional<double>& pixel_mm, double scale) {
  ScreenDistances now;
  // A point can be set no finer than a pixel of the recording, nor than one of the screen it is set on.
  const double within_px = std::max(1.0, 1.0 / scale);
  const auto labelOf = [&](const measurement::Measurement& measurement) {
    ScreenView::Label label{{measurement, {}}, {}, drawn.selected() == measurement.number};
    const double mm = pixel_mm.value_or(1.0);
    const measurement::UncertaintyAt at = [mm, within_px](int, const glm::dvec2&) {
      return measurement::PointUncertainty{.pixel = glm::dvec2(mm * within_px)};
    };
    if (auto measured = measurement::measure(inMillimetres(measurement.caliper, mm), at)) label.line.measured = *std::move(measured);
    if (pixel_mm)
      label.text = CaliperWords::mainResult(label.line.measured);
    else if (!label.line.measured.figures.empty())
      label.text = ScreenDialog::tr("%1 pixels").arg(figure(label.line.measured.figures.front().quantity.value, 1));
    return label;
  };
  for (const measurement::Measurement& each : drawn.shown().all) {
    now.labels.push_back(labelOf(each));
    now.lines << ScreenDialog::tr("%1: %2").arg(each.number).arg(now.labels.back().text);
  }
  if (const auto unfinished = drawn.unfinished()) {
    measurement::Measurement begun;
    begun.caliper = *unfinished;
    now.labels.push_back(labelOf(begun));
    now.labels.back().isChosen = true;
  }
  if (!pixel_mm && !now.lines.isEmpty()) now.lines << ScreenDialog::tr("State the depth to measure in mm.");
  return now;
}

}  // namespace ew::ui
