#include "measure/calipers/caliper_origin.h"

#include <algorithm>
#include <glm/glm.hpp>

#include "ew/widgets/figures.h"
#include "measure/words/caliper_words.h"

namespace ew::ui {

using measurement::CaliperKind;

namespace {

struct Extremes {
  double least = 1e9, most = 0.0;
  void take(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

}  // namespace

QString howItCameAbout(const Calipers::Line& line) {
  const auto range = [](const Extremes& of, int decimals) {
    const QString low = figure(of.least, decimals), high = figure(of.most, decimals);
    return low == high ? low : CaliperWords::tr("%1 to %2", "from a smallest to a largest value").arg(low, high);
  };
  QString said;
  if (line.at) {
    Extremes pixel, row, axial, lateral;
    for (const auto& part : line.measurement.caliper.parts)
      for (const glm::dvec2& point : part.points) {
        const measurement::PointUncertainty there = line.at(part.image, point);
        pixel.take(there.pixel.x);
        row.take(there.pixel.y);
        axial.take(there.axial_mm);
        lateral.take(there.lateral_mm);
      }
    constexpr double kMs = 1000.0;
    if (line.where == Where::image) {
      said = CaliperWords::tr("± from the pixel (%1 mm), the resolution along the beam (%2 mm) and the width of the beam (%3 mm).")
                 .arg(range(pixel, 2), range(axial, 1), range(lateral, 1));
    } else {
      const Extremes pixel_ms{pixel.least * kMs, pixel.most * kMs};
      const QString time = CaliperWords::tr("the time of a column and between two beams (%1 ms)").arg(range(pixel_ms, 0));
      const QString depth =
          CaliperWords::tr("the pixel (%1 mm) and the resolution along the beam (%2 mm)").arg(range(row, 2), range(axial, 1));
      const auto kind = line.measurement.caliper.kind;
      const bool isOfDepth = kind == CaliperKind::depthDistance, isOfBoth = kind == CaliperKind::slope;
      said = isOfBoth ? CaliperWords::tr("± from %1, and from %2.", "what an uncertainty comes from").arg(time, depth)
                      : CaliperWords::tr("± from %1.", "what an uncertainty comes from").arg(isOfDepth ? depth : time);
      if (kind == CaliperKind::heartRate)
        said = CaliperWords::tr("Heart beats between the cursors: %1.").arg(line.measurement.caliper.cycles) + QLatin1Char(' ') + said;
    }
  }
  if (line.where == Where::strip && line.hasLeft)
    said += (said.isEmpty() ? QString() : QStringLiteral(" ")) +
            CaliperWords::tr(
                "The strip has gone on and does not show its echoes any more; the value stays, and the cine loop brings them back.");
  return said;
}

}  // namespace ew::ui
