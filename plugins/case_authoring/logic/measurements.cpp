#include "logic/measurements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ew/core/figure.h"
#include "ew/core/foreign_json.h"

namespace ew::case_authoring {
namespace {

/// What calipers call a figure, what a case calls it, and the unit in which a case keeps it.
struct FigureKind {
  std::string_view figure;
  std::string_view kind;
  std::string_view unit;
};
constexpr std::array<FigureKind, 4> kFigureKinds = {
    FigureKind{"length", "distance", "mm"},
    {"circumference", "circumference", "mm"},
    {"area", "area", "cm2"},
    {"angle", "angle", "deg"},
};

const FigureKind* kindOf(const Figure& figure) {
  const auto found = std::find_if(kFigureKinds.begin(), kFigureKinds.end(),
                                  [&](const FigureKind& each) { return each.figure == figure.name && each.unit == figure.unit; });
  return found == kFigureKinds.end() ? nullptr : &*found;
}

/// To the hundredth: calipers are not set finer.
double rounded(double value) { return std::round(value * 100.0) / 100.0; }

}  // namespace

Result<nlohmann::json> withCaliper(nlohmann::json expected, const std::vector<sdk::ScanMeasurement>& drawn,
                                   const Transform<frame::File, frame::Probe>& probeToFile) {
  const std::string wanted = textAt(expected, "kind");
  for (auto measured = drawn.rbegin(); measured != drawn.rend(); ++measured) {
    for (const auto& figure : measured->figures) {
      const FigureKind* kind = kindOf(figure);
      if (kind == nullptr || (!wanted.empty() && wanted != kind->kind)) continue;
      expected["value"] = rounded(figure.value);
      expected["kind"] = kind->kind;
      expected["unit"] = kind->unit;
      nlohmann::json points = nlohmann::json::array();
      for (const Point<frame::Probe>& at : measured->points) {
        const Point<frame::File> p_file = probeToFile * at;
        points.push_back({rounded(p_file.at.x), rounded(p_file.at.y), rounded(p_file.at.z)});
      }
      expected["points_mm"] = std::move(points);
      return expected;
    }
  }
  if (drawn.empty())
    return failure(ErrorCode::badUsage, say<"Nothing is measured in the image; draw a caliper first (Scan, Measure), then take it.">());
  return failure(ErrorCode::badUsage,
                 say<"No caliper in the image measures this kind of figure; draw one that does, or choose another kind.">());
}

bool hasValue(const nlohmann::json& expected) { return expected.is_object() && expected.contains("value"); }

}  // namespace ew::case_authoring
