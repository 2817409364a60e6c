#include "logic/step_scene.h"

namespace ew::lessons {

std::vector<HandedMeasurement> handedOf(const std::vector<sdk::ScanMeasurement>& measured) {
  std::vector<HandedMeasurement> handed;
  for (const sdk::ScanMeasurement& each : measured) {
    HandedMeasurement made{each.kind, each.points, {}};
    for (const auto& figure : each.figures) made.figures.push_back({figure.name, figure.value, figure.unit});
    handed.push_back(std::move(made));
  }
  return handed;
}

}  // namespace ew::lessons
