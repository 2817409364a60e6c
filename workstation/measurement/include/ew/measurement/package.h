#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/result.h"
#include "ew/measurement/expression.h"
#include "ew/measurement/quantity.h"

namespace ew::measurement {

inline constexpr int kPackageFormat = 1;  ///< `format` of a package; a file with a larger one is refused with newerFormat

/// From `low` to `high`, both included.
struct Limits {
  double low = 0.0;
  double high = 0.0;
  [[nodiscard]] bool hold(double value) const { return value >= low && value <= high; }
  bool operator==(const Limits&) const = default;
};

/// What of a caliper an item takes.
enum class ItemMeasure { distance, circumference, area, volume, angle, ratio, slope, heartRate, duration, velocity, number, choice };
[[nodiscard]] std::string_view wordOf(ItemMeasure measure);  ///< in files: "distance", "heart_rate"

/// Something a worksheet asks for: a length between two calipers, or an answer out of several.
struct PackageItem {
  std::string label;  ///< "BPD": unique in the package; letters, digits, _
  Words title;
  ItemMeasure measure = ItemMeasure::distance;
  Unit unit = Unit::mm;  ///< of `valid` and of results
  Words convention;      ///< where the calipers go
  Words plane;           ///< in which plane
  bool isSided = false;  ///< measured on the right and on the left
  Limits valid;          ///< what cannot be true is refused (a length typed in mm where cm belong); not of choices
  std::vector<std::pair<std::string, Words>> choices;  ///< of ItemMeasure::choice: word and text
  std::string spectrum;  ///< of a velocity: items of one spectrum ("ICA") have one angle correction, and one error of it; or empty
  bool operator==(const PackageItem&) const = default;
};

/// The gestational age by dates, as inputs of formulas and expressions of charts name it; no entry of a package has this label.
inline constexpr std::string_view kByDates = "GA";

/// An input of a formula: the value of an item or of an earlier formula, in the unit the formula was published with.
struct FormulaInput {
  std::string name;  ///< in the expression
  std::string of;    ///< label of an item or of an earlier formula, or kByDates
  std::string side;  ///< "right" or "left" of a sided one; empty: the side the formula is computed for
  Unit unit = Unit::one;
  Limits valid;
  bool operator==(const FormulaInput&) const = default;
};

/// A result that a source prints or that was computed from its formula independently of this program.
struct TestVector {
  std::vector<double> inputs;  ///< in the order of the formula's inputs
  double result = 0.0;
  int digits = 0;  ///< after the point, as printed
  bool operator==(const TestVector&) const = default;
};

/// One standard deviation of a formula's prediction.
struct FormulaError {
  double percent = 0.0;   ///< of the result; 0: not stated so
  double absolute = 0.0;  ///< in the formula's unit; 0: not stated so
  [[nodiscard]] double of(double result) const;
  bool operator==(const FormulaError&) const = default;
};

struct PackageFormula {
  std::string label;
  Words title;  ///< with its source: "GA by BPD (Hadlock 1984)"
  Expression expression;
  std::vector<FormulaInput> inputs;
  Unit unit = Unit::one;
  Limits valid;          ///< of the result
  std::string provides;  ///< item that the result stands for when it was not measured; or empty
  std::string source;
  std::string status;  ///< how the coefficients were checked
  FormulaError error;
  std::vector<TestVector> tests;  ///< at least one
  bool operator==(const PackageFormula&) const = default;
};

/// Where the result of a formula lies among others of the same gestational age. Offered with the formulas it was built on alone.
struct PackageChart {
  /// What a table prints for a week: the values at a percentile below the median, at the median, and at as many above.
  struct Row {
    double weeks = 0.0;
    double low = 0.0, median = 0.0, high = 0.0;
    bool operator==(const Row&) const = default;
  };
  std::string label;
  Words title;
  std::vector<std::string> of;  ///< labels of formulas
  Unit unit = Unit::g;          ///< of the values it knows
  Limits valid_weeks;
  // A median with an even relative spread, or LMS, all of `GA` in weeks; or a table, with straight lines between its weeks, and on each
  // side of the median a normal spread that meets the printed percentile.
  bool isLms = false;
  Expression median;            ///< of a spread
  double spread_percent = 0.0;  ///< one standard deviation, of the median
  Expression L, M, S;           ///< Cole & Green 1992: z = ((y / M)^L - 1) / (L S)
  bool ofLogarithm = false;     ///< y is the natural logarithm of the value
  std::vector<Row> rows;        ///< of a table: two or more, by weeks that rise; empty: one of the others
  double lowPercentile = 5.0;   ///< of Row::low, below 50
  std::string source;
  std::string status;
  struct Test {
    double weeks = 0.0;
    double percentile = 50.0;
    double value = 0.0;
    int digits = 0;
    bool operator==(const Test&) const = default;
  };
  std::vector<Test> tests;  ///< at least one
  bool operator==(const PackageChart&) const = default;
};

/// z, and the share of others below, 0 to 100, of a value at a gestational age within valid_weeks. @param value > 0, in the chart's unit
[[nodiscard]] double zScore(const PackageChart& chart, double weeks, double value);
[[nodiscard]] double percentileOf(double z);
/// The value at a z-score: the median at 0.
[[nodiscard]] double valueAt(const PackageChart& chart, double weeks, double z);
/// The z-score of a percentile above 0 and below 100.
[[nodiscard]] double zOfPercentile(double percentile);

/// What is usual; an end that is not stated is open.
struct ReferenceRange {
  std::string of;  ///< label of an item or formula
  Unit unit = Unit::mm;
  std::optional<double> low;
  std::optional<double> high;
  Words applies;  ///< to whom: "women"; or empty
  std::string source;
  bool operator==(const ReferenceRange&) const = default;
};

/// When dates are replaced by a scan: a difference of more than `moreThan_days` at a gestational age by dates of less than `below_weeks`.
struct RedatingStep {
  double below_weeks = 0.0;
  double moreThan_days = 0.0;
  std::vector<std::string> by;  ///< formulas whose gestational age counts; the first one that there is
  bool operator==(const RedatingStep&) const = default;
};
struct Redating {
  std::string source;
  std::vector<RedatingStep> steps;  ///< rising
  bool operator==(const Redating&) const = default;
};

/// What choices together say: the first rule that holds. A rule with a `choice` holds when any of `items` (`all`: every one) has it.
struct ChoiceRule {
  std::string choice;  ///< empty: holds always
  bool all = false;
  Words says;
  bool operator==(const ChoiceRule&) const = default;
};
struct ChoiceSummary {
  Words title;
  std::vector<std::string> items;
  std::vector<ChoiceRule> rules;
  std::string unanswered;  ///< what an item without an answer counts as
  bool operator==(const ChoiceSummary&) const = default;
};

struct WorksheetSection {
  Words title;
  std::vector<std::string> rows;  ///< labels of items and formulas
  bool operator==(const WorksheetSection&) const = default;
};

/// A measurement package: resources/measurements/*.json, resources/schemas/measurement.schema.json. Everything in it is data.
struct Package {
  std::string id;   ///< file name without ending: "obstetric"
  int version = 1;  ///< rises when a number in it changes; results carry it
  Words title;
  std::string source;
  std::vector<PackageItem> items;
  std::vector<PackageFormula> formulas;  ///< an input's formula stands before it
  std::vector<PackageChart> charts;
  std::vector<ReferenceRange> ranges;
  std::optional<Redating> redating;
  std::vector<ChoiceSummary> summaries;
  std::vector<WorksheetSection> worksheet;
  bool operator==(const Package&) const = default;

  [[nodiscard]] const PackageItem* item(std::string_view label) const;        ///< null when there is none
  [[nodiscard]] const PackageFormula* formula(std::string_view label) const;  ///< null when there is none
};

/// @param where how sentences name the document: verbatim("obstetric.json")
/// A package whose formulas or charts do not give the results of their own test vectors is refused: a wrong digit must not reach a
/// worksheet.
/// @error badField, newerFormat
[[nodiscard]] Result<Package> packageFromJson(const nlohmann::json& document, const std::string& id, const Message& where);

/// @error notFound, notReadable, tooLarge (above 4 MiB), badHeader (not JSON), otherwise as packageFromJson
[[nodiscard]] Result<Package> readPackage(const std::filesystem::path& file);
/// Every package of a folder, by id; a file that cannot be read is an error, not a gap.
[[nodiscard]] Result<std::vector<Package>> readPackages(const std::filesystem::path& folder);

}  // namespace ew::measurement
