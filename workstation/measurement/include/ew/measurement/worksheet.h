#pragma once

#include <nlohmann/json_fwd.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/message.h"
#include "ew/core/result.h"
#include "ew/measurement/package.h"
#include "ew/measurement/quantity.h"

namespace ew::measurement {

/// What counts when an item was measured more than once.
enum class Several { mean, last, selected };

/// One measurement, or one answer, of an item.
struct WorksheetEntry {
  std::string label;        ///< of the item
  std::string side;         ///< "right" or "left" of a sided item; else empty
  Quantity quantity;        ///< in any unit that the item's can be converted to
  std::string choice;       ///< of a choice: one of its words
  bool isSelected = false;  ///< counts with Several::selected; of none or several of an item the last such one, or the last one
  std::optional<double> angle_rad = std::nullopt;  ///< of a velocity: the angle it was corrected by, from 0 to below a right one
  bool operator==(const WorksheetEntry&) const = default;
};

inline constexpr double kSteepest_rad = std::numbers::pi / 3.0;  ///< a velocity read at more carries a remark

/// What an angle that is wrong by `angleError_rad` does to a velocity that was corrected by `angle_rad`, relative to it: tan(angle) times
/// the error, 9 % at 60 and 3 degrees.
[[nodiscard]] double relativeErrorOfAngle(double angle_rad, double angleError_rad);

struct WorksheetInput {
  std::vector<WorksheetEntry> entries;  ///< in the order they were made
  Several several = Several::mean;
  std::optional<double> gestation_weeks = std::nullopt;  ///< by dates, 0 to 45; charts, redating and some formulas need it
  double angleError_rad = std::numbers::pi / 60.0;       ///< standard uncertainty of a set angle: 3 degrees
};

/// How a value stands to a usual range.
enum class RangeVerdict { within, below, above };
[[nodiscard]] std::string_view wordOf(RangeVerdict verdict);  ///< "within"
struct RangeReading {
  ReferenceRange range;
  RangeVerdict verdict = RangeVerdict::within;
  bool operator==(const RangeReading&) const = default;
};

/// Where a value lies on a chart.
struct ChartReading {
  std::string label;
  Words title;
  double z = 0.0;
  double percentile = 50.0;                            ///< 0 to 100
  double lowPercentile = 50.0, highPercentile = 50.0;  ///< of the value less and plus its uncertainty
  std::string source;
  bool operator==(const ChartReading&) const = default;
};

/// A value that a formula used.
struct FormulaValue {
  std::string name;  ///< in the expression
  std::string of;    ///< label of the item or formula
  std::string side;
  Quantity value;    ///< in the formula's unit
  std::string from;  ///< the formula that gave it; empty: measured
  bool operator==(const FormulaValue&) const = default;
};

/// A line of a worksheet: an item that was measured, answered or follows from others, or a result.
struct WorksheetRow {
  std::string label;
  std::string side;
  Words title;
  bool isFormula = false;
  std::optional<Quantity> value;   ///< in the unit of item or formula, uncertain by what was measured; empty: see `remarks`
  double predictionError = 0.0;    ///< of a formula: one standard deviation of what it predicts, in the value's unit; 0: not stated
  std::vector<Quantity> measured;  ///< of an item: each measurement, in its unit
  std::string choice;              ///< of a choice: its word
  Words choiceTitle;
  std::string from;                  ///< of an item that was not measured: the formula that gave it
  std::vector<FormulaValue> inputs;  ///< of a formula
  std::string expression;            ///< of a formula
  std::string source;                ///< of a formula
  Words convention;                  ///< of an item: where its calipers go
  std::vector<RangeReading> ranges;
  std::vector<ChartReading> charts;
  std::vector<Message> remarks;  ///< why there is no value, or no percentile; what makes a value doubtful
  bool operator==(const WorksheetRow&) const = default;
};

struct SectionValues {
  Words title;
  std::vector<WorksheetRow> rows;
  bool operator==(const SectionValues&) const = default;
};

/// Dates against the scan.
struct RedatingReading {
  std::string formula;
  double dates_weeks = 0.0;
  double scan_weeks = 0.0;
  long long difference_days = 0;  ///< scan - dates, to the nearest day
  double moreThan_days = 0.0;
  bool redate = false;
  std::string source;
  bool operator==(const RedatingReading&) const = default;
};
[[nodiscard]] Message sentenceOf(const RedatingReading& reading);

struct SummaryReading {
  Words title;
  Words says;
  bool operator==(const SummaryReading&) const = default;
};

/// What a package says of measurements. Training only: every output says so.
struct Worksheet {
  std::string package;
  int packageVersion = 1;
  Words title;
  std::string source;
  Several several = Several::mean;
  std::optional<double> gestation_weeks;
  std::vector<SectionValues> sections;  ///< as the package lays them out; rows that nothing is known of are left out, and empty sections
  std::optional<RedatingReading> redating;
  std::vector<SummaryReading> summaries;
  bool operator==(const Worksheet&) const = default;

  /// A row that has a value, an answer or remarks; null when there is none.
  [[nodiscard]] const WorksheetRow* row(std::string_view label, std::string_view side = {}) const;
};

inline constexpr const char* kTrainingOnly = "Simulation, training only: not for diagnosis.";

/// Fills a package's worksheet. Formulas run in the order of the package; one whose inputs are not all known is left out, one that an input
/// or its own result is out of range for says so and gives no number. Uncertainties are propagated through all formulas down to what was
/// measured, so that a measurement which enters twice counts once, with its sign; so does the angle of a spectrum, which ratios within it
/// do not depend on.
/// @error badUsage (no such item, or side or answer; the list of those there are), badField (a unit that is none of the item's, a value
/// outside of what can be true, with the range, an angle of what is no velocity or of a right one or more)
[[nodiscard]] Result<Worksheet> fillWorksheet(const Package& package, const WorksheetInput& input);

/// `format` 1. @param language of titles: "en", "de"; remarks are English, as in reports of commands
[[nodiscard]] nlohmann::ordered_json toJson(const Worksheet& worksheet, std::string_view language = "en");
/// A line of names, then one line a row, comma separated, quoted where needed (RFC 4180), numbers in the C locale; the last column says
/// that it is for training only.
[[nodiscard]] std::string toCsv(const Worksheet& worksheet, std::string_view language = "en");
/// "9 to 13 cm", "up to 6 mm" or "from 3 mm".
[[nodiscard]] Message rangeText(const ReferenceRange& range);
/// One line: "from BPD 8.20 cm, HC 30.00 cm (by HC_DIAMETERS)"; of an item: "measured twice"... in English.
[[nodiscard]] std::string howItCameAbout(const WorksheetRow& row);

}  // namespace ew::measurement
