#include "logic/step_scene.h"

namespace ew::lessons {

std::vector<MeasurementSubmission> handedOf(const std::vector<sdk::ScanMeasurement>& measured) {
  std::vector<MeasurementSubmission> handed;
  for (const sdk::ScanMeasurement& each : measured) handed.push_back({each.kind, each.points, each.figures});
  return handed;
}

}  // namespace ew::lessons
