#include "logic/measurements.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "ew/core/figure.h"

namespace ew::case_authoring {
namespace {

const MeasurementKind* kindOf(const Figure& figure) {
  const auto found = std::find_if(kMeasurementKinds.begin(), kMeasurementKinds.end(),
                                  [&](const MeasurementKind& each) { return each.figure == figure.name && each.unit == figure.unit; });
  return found == kMeasurementKinds.end() ? nullptr : &*found;
}

/// To the hundredth: calipers are not set finer.
double rounded(double value) { return std::round(value * 100.0) / 100.0; }

}  // namespace

Result<CaseMeasurement> withCaliper(CaseMeasurement expected, const std::vector<sdk::ScanMeasurement>& drawn,
                                    const Transform<frame::File, frame::Probe>& probeToFile) {
  const std::string wanted = expected.kind;
  for (auto measured = drawn.rbegin(); measured != drawn.rend(); ++measured) {
    for (const auto& figure : measured->figures) {
      const MeasurementKind* kind = kindOf(figure);
      if (kind == nullptr || (!wanted.empty() && wanted != kind->kind)) continue;
      expected.value = rounded(figure.value);
      expected.kind = kind->kind;
      expected.unit = kind->unit;
      expected.points_mm.clear();
      for (const Point<frame::Probe>& at : measured->points) {
        const glm::dvec3 at_mm = (probeToFile * at).at;
        expected.points_mm.emplace_back(rounded(at_mm.x), rounded(at_mm.y), rounded(at_mm.z));
      }
      return expected;
    }
  }
  if (drawn.empty())
    return failure(ErrorCode::badUsage, say<"Nothing is measured in the image; draw a caliper first (Scan, Measure), then take it.">());
  return failure(ErrorCode::badUsage,
                 say<"No caliper in the image measures this kind of figure; draw one that does, or choose another kind.">());
}

}  // namespace ew::case_authoring
