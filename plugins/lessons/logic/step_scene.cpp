#include "logic/step_scene.h"

namespace ew::lessons {

std::vector<HandedMeasurement> handedOf(const std::vector<sdk::ScanMeasurement>& measured) {
  std::vector<HandedMeasurement> handed;
  for (const sdk::ScanMeasurement& each : measured) handed.push_back({each.kind, each.points, each.figures});
  return handed;
}

}  // namespace ew::lessons
