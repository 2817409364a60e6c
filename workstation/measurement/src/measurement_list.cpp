#include "ew/measurement/measurement_list.h"

#include "ew/core/find_entry.h"

namespace ew::measurement {

const Measurement* Measurements::find(int number) const { return entryWith(all, &Measurement::number, number); }

int MeasurementList::add(Caliper caliper, std::string name, std::string item, std::string side) {
  return EntryHistory::add(Measurement{0, std::move(name), std::move(item), std::move(side), std::move(caliper)});
}

bool MeasurementList::setCaliper(int number, Caliper caliper, Change change) {
  return edit(number, change, [&](Measurement& measurement) { return measurement.caliper = std::move(caliper), true; });
}

bool MeasurementList::rename(int number, std::string name) {
  return edit(number, Change::begins, [&](Measurement& measurement) { return measurement.name = std::move(name), true; });
}

bool MeasurementList::assign(int number, std::string item, std::string side) {
  return edit(number, Change::begins, [&](Measurement& measurement) {
    measurement.item = std::move(item);
    measurement.side = std::move(side);
    return true;
  });
}

std::optional<HandleFound> handleNear(const Measurements& measurements, int image, glm::dvec2 p, double reach_mm, glm::dvec2 scale) {
  std::optional<HandleFound> nearest;
  for (const Measurement& measurement : measurements.all)
    for (std::size_t part = 0; part < measurement.caliper.parts.size(); ++part) {
      const CaliperPart& points = measurement.caliper.parts[part];
      if (points.image != image) continue;
      for (std::size_t point = 0; point < points.points.size(); ++point) {
        const double distance_mm = glm::length(scale * (points.points[point] - p));
        // Of two on each other the newer one, which is drawn on top.
        if (distance_mm <= reach_mm && (!nearest || distance_mm <= nearest->distance_mm))
          nearest = HandleFound{measurement.number, {part, point}, distance_mm};
      }
    }
  return nearest;
}

}  // namespace ew::measurement
