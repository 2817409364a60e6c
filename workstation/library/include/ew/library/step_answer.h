#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ew/core/figure.h"

namespace ew {

// What a trainee enters in a step, by the step's kind: raw data that an attempt keeps, as JSON of the shape that each of them names.

/// To a question with options: {"chosen": [2]}.
struct OptionsAnswer {
  std::vector<std::size_t> chosen;  ///< by their place
  bool operator==(const OptionsAnswer&) const = default;
};

/// To a question for a number: {"number": 12.5}.
struct NumberAnswer {
  double number = 0.0;  ///< in the step's unit
  bool operator==(const NumberAnswer&) const = default;
};

/// After an expert's scan: {"watched": true}.
struct WatchAnswer {
  bool watched = false;  ///< to its end
  bool operator==(const WatchAnswer&) const = default;
};

/// What was pointed at: {"at_mm": [x, y, z]}.
struct PointAnswer {
  glm::dvec3 at_mm{0.0};  ///< in the world
  bool operator==(const PointAnswer&) const = default;
};

/// The measurement that fits what is asked for: {"value": 40.1, "unit": "mm", "caliper": "distance", "points_mm": [[x, y, z], …]}.
struct MeasurementAnswer {
  double value = 0.0;  ///< in `unit`
  std::string unit;
  std::optional<std::string> caliper;  ///< its kind; empty: nobody says
  std::vector<glm::dvec3> points_mm;   ///< the ends of a distance, in the world; no others are kept
  bool operator==(const MeasurementAnswer&) const = default;
};

/// What one caliper measured.
struct CaliperReading {
  std::string caliper;  ///< its kind: "distance", "ellipse" ...
  std::vector<Figure> figures;
  std::vector<glm::dvec3> points_mm;  ///< in the world
  bool operator==(const CaliperReading&) const = default;
};
/// All that was measured in the image of an examination, where nobody knows what would fit: {"measurements": [{"caliper": "distance",
/// "figures": [{"name": "length", "value": 40.1, "unit": "mm"}], "points_mm": [[x, y, z], …]}, …]}.
struct CalipersAnswer {
  std::vector<CaliperReading> measurements;  ///< in the order they were drawn
  bool operator==(const CalipersAnswer&) const = default;
};

/// std::monostate: nothing was entered, the step's kind asks for nothing, or nothing that fits was handed in.
using StepAnswer = std::variant<std::monostate, OptionsAnswer, NumberAnswer, WatchAnswer, PointAnswer, MeasurementAnswer, CalipersAnswer>;

/// Takes what it knows and leaves the rest: attempts may come from anywhere, and a list may hold anything. Nothing when it knows nothing.
[[nodiscard]] StepAnswer stepAnswerFromJson(const nlohmann::json& document);
/// stepAnswerFromJson(jsonOf(answer)) == answer; null for nothing.
[[nodiscard]] nlohmann::json jsonOf(const StepAnswer& answer);

}  // namespace ew
