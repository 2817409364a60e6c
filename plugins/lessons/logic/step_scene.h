#pragma once

#include <memory>
#include <vector>

#include "ew/assessment/step_work.h"
#include "ew/sdk/scan.h"

namespace ew::lessons {

/// What a step works on: the case's truth, in the world, and what is scanned. Cheap to copy.
struct StepScene {
  std::shared_ptr<const CaseTruth> truth;
  sdk::Scanned scanned;
  bool isSealed = false;  ///< of an examination: nobody here knows what is right, and steps are handed in
  /// What its work is judged against.
  [[nodiscard]] std::shared_ptr<const CaseGround> ground() const {
    return std::make_shared<const CaseGround>(truth, scanned.labels, scanned.placedLabels);
  }
};

/// Measurements of the scan as they are handed in.
[[nodiscard]] std::vector<MeasurementSubmission> handedOf(const std::vector<sdk::ScanMeasurement>& measured);

}  // namespace ew::lessons
