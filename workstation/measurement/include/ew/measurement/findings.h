#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/result.h"
#include "ew/measurement/caliper.h"
#include "ew/measurement/measurement_list.h"

namespace ew::measurement {

/// A measurement with all that a result over several ones needs of it, whatever becomes of its image.
struct Finding {
  std::uint64_t image = 0;  ///< never the same for two images; kStripImage or above: a strip
  Measurement measurement;
  Measured measured;
  UncertaintyAt at;  ///< as it was measured with
};
inline constexpr std::uint64_t kStripImage = std::uint64_t{1} << 40;

/// Covariance of a figure of one measurement and a figure of another, in the product of their units. Points are independent of each other,
/// but for those that lie on each other in one image (the cross of one was put on that of another): they are one point of the tissue. Of
/// one measurement with itself as measure() has it, so that a figure's covariance with itself is its uncertainty squared.
[[nodiscard]] double covariance(const Finding& a, const CaliperFigure& ofA, const Finding& b, const CaliperFigure& ofB);

/// What several measurements give together.
enum class CombinationKind {
  ratio,      ///< A / B
  percent,    ///< 100 A / B
  reduction,  ///< 100 (1 - A / B): a stenosis, with A where it is narrowest and B where it is normal
  ellipsoid,  ///< pi / 6 times three lengths, the third usually of another image
  biplane,    ///< discs of two planes at right angles (Simpson)
};
[[nodiscard]] std::string_view wordOf(CombinationKind kind);  ///< "ratio", "percent", "reduction", "ellipsoid", "biplane"
[[nodiscard]] std::size_t inputCount(CombinationKind kind);

/// A figure of a measurement of an image.
struct FigureRef {
  std::uint64_t image = 0;
  int number = 0;
  FigureKind figure = FigureKind::length;
  bool operator==(const FigureRef&) const = default;
};

struct Combination {
  int number = 0;  ///< 1, 2, ...; never given again
  CombinationKind kind = CombinationKind::ratio;
  std::vector<FigureRef> of;
  bool operator==(const Combination&) const = default;
};

struct Combined {
  Quantity quantity;
  double correlation = 0.0;  ///< of the first two inputs; of more the one farthest from 0
  std::vector<Message> remarks;
};

/// Everything that was measured in the images of one scan, and results over several of them. An image may go; what was measured in it
/// stays. Not for several threads at once.
class Findings {
 public:
  /// What the calipers of an image give now takes the place of what they gave before.
  void measuredIn(std::uint64_t image, std::vector<Finding> now);
  /// By image in the order they were first measured, and in each in the order of its list.
  [[nodiscard]] const std::vector<Finding>& all() const { return all_; }
  [[nodiscard]] const Finding* find(std::uint64_t image, int number) const;  ///< null when there is none
  /// 1, 2, ... in the order images were first measured; strips are not counted.
  [[nodiscard]] int ordinalOf(std::uint64_t image) const;

  /// @error badField: a measurement that is gone or does not give that figure, different kinds of quantities, nothing to divide by
  [[nodiscard]] Result<Combined> combine(CombinationKind kind, const std::vector<FigureRef>& of) const;

  /// Returns its number. It follows its measurements as they are moved.
  int add(CombinationKind kind, std::vector<FigureRef> of);
  bool remove(int number);
  [[nodiscard]] const std::vector<Combination>& combinations() const { return combinations_; }
  void clear();
  [[nodiscard]] bool isEmpty() const { return all_.empty() && combinations_.empty(); }

 private:
  std::vector<Finding> all_;
  std::vector<std::uint64_t> images_;  ///< in the order they were first measured
  std::vector<Combination> combinations_;
  int next_ = 1;
};

inline constexpr int kFindingsFormat = 1;

/// {"format": 1, "simulation": true, "title", "measurements": [{"image" or "strip": true, "number", "kind", "item", "side", "figures":
/// [{"figure", "value", "uncertainty", "unit"}], "cycles", "remarks"}], "results": [{"number", "kind", "of", "value", ...}]}
[[nodiscard]] nlohmann::ordered_json toJson(const Findings& findings, const std::string& title);
/// One line for each figure and each result, with a line of titles; quoted as RFC 4180 has it.
[[nodiscard]] std::string toCsv(const Findings& findings, const std::string& title);

}  // namespace ew::measurement
