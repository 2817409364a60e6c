#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/history.h"
#include "ew/core/result.h"
#include "ew/measurement/caliper.h"

namespace ew::measurement {

/// One line of the list beside the image.
struct Measurement {
  int number = 0;    ///< 1, 2, ... as it stands at its calipers; never given again in one list
  std::string name;  ///< what the user called it; empty: its kind
  std::string item;  ///< label of the package's item it was made for; empty: for none
  std::string side;  ///< "right", "left" or empty
  Caliper caliper;
  bool operator==(const Measurement&) const = default;
};

/// All measurements of an image at one moment: a value that never changes.
struct Measurements {
  std::vector<Measurement> all;  ///< in the order they were made
  int nextNumber = 1;
  [[nodiscard]] const Measurement* find(int number) const;  ///< null when there is none
  bool operator==(const Measurements&) const = default;
};

inline constexpr int kMeasurementsFormat = 1;  ///< `format` of the JSON below; a larger one is refused with newerFormat

/// {"format": 1, "next_number": 3, "measurements": [{"number", "name", "item", "side", "kind", "cycles", "parts": [{"picture", "points":
/// [[x, y]]}]}]}
[[nodiscard]] nlohmann::json toJson(const Measurements& measurements);
/// @param where how sentences name the document @error badField (one sentence for each bad field), newerFormat
[[nodiscard]] Result<Measurements> measurementsFromJson(const nlohmann::json& document, const Message& where);

/// A point of a caliper that can be moved.
struct Handle {
  std::size_t part = 0;
  std::size_t point = 0;
  bool operator==(const Handle&) const = default;
};

using ew::Change;

/// The measurements of an image with undo and redo (core/history.h). Not for several threads at once; the states are.
class MeasurementList : public EntryHistory<Measurements> {
 public:
  using EntryHistory::EntryHistory;

  /// Returns its number. @param caliper as measure() takes it, or with points still to come
  int add(Caliper caliper, std::string name = {}, std::string item = {}, std::string side = {});
  /// The caliper as a whole: points that are added or taken away.
  bool setCaliper(int number, Caliper caliper, Change change = Change::begins);
  bool rename(int number, std::string name);
  bool assign(int number, std::string item, std::string side = {});
};

/// The handle nearest to a point of an image within reach, and whose it is. @param scale of differences of x and y before they are
/// distances
struct HandleFound {
  int number = 0;
  Handle handle;
  double distance_mm = 0.0;
};
[[nodiscard]] std::optional<HandleFound> handleNear(const Measurements& measurements, int image, glm::dvec2 p, double reach_mm,
                                                    glm::dvec2 scale = glm::dvec2(1.0));

}  // namespace ew::measurement
