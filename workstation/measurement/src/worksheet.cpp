#include "ew/measurement/worksheet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "value_text.h"

namespace ew::measurement {
namespace {

using Key = std::pair<std::string, std::string>;  // label, side

/// A value and what it owes to each measurement: its derivative times that measurement's standard uncertainty.
struct Known {
  Quantity value;
  std::map<std::string, double> contributions;
  std::string from;
};

double totalOf(const std::map<std::string, double>& contributions) {
  double sum = 0.0;
  for (const auto& [name, part] : contributions) sum += part * part;
  return std::sqrt(sum);
}

std::string labelList(const Package& package) {
  std::string all;
  for (const PackageItem& item : package.items) all += (all.empty() ? "" : ", ") + item.label;
  return all;
}

/// Label and side, as commands and sentences write it: "KIDNEY/right".
std::string named(const std::string& label, const std::string& side) { return side.empty() ? label : label + "/" + side; }

std::vector<RangeReading> rangesOf(const Package& package, const std::string& label, const Quantity& value) {
  std::vector<RangeReading> readings;
  for (const ReferenceRange& range : package.ranges) {
    if (range.of != label) continue;
    const double here = converted(value.value, value.unit, range.unit);
    const auto verdict = range.low && here < *range.low     ? RangeVerdict::below
                         : range.high && here > *range.high ? RangeVerdict::above
                                                            : RangeVerdict::within;
    readings.push_back({range, verdict});
  }
  return readings;
}

/// Fills one worksheet: entries, then formulas in the order of the package, then the layout.
class Filling {
 public:
  Filling(const Package& package, const WorksheetInput& input) : package_(package), input_(input) {}

  Result<void> takeEntries() {
    if (input_.gestation_weeks) known_[{std::string(kByDates), ""}] = {{*input_.gestation_weeks, 0.0, Unit::weeks}, {}, {}};
    for (const WorksheetEntry& entry : input_.entries)
      if (auto taken = takeEntry(entry); !taken) return taken;
    for (auto& [key, entries] : entries_) countEntries(key, entries);
    return {};
  }

  void compute() {
    for (const PackageFormula& formula : package_.formulas) {
      if (!isSided(formula))
        computeFormula(formula, "");
      else
        for (const char* side : {"right", "left"}) computeFormula(formula, side);
    }
  }

  Worksheet laidOut() const {
    Worksheet sheet;
    sheet.package = package_.id;
    sheet.packageVersion = package_.version;
    sheet.title = package_.title;
    sheet.source = package_.source;
    sheet.several = input_.several;
    sheet.gestation_weeks = input_.gestation_weeks;
    for (const WorksheetSection& section : package_.worksheet) {
      SectionValues filled{section.title, {}};
      for (const std::string& label : section.rows)
        for (const char* side : {"", "right", "left"})
          if (const auto row = rows_.find({label, side}); row != rows_.end()) filled.rows.push_back(row->second);
      if (!filled.rows.empty()) sheet.sections.push_back(std::move(filled));
    }
    sheet.redating = redating();
    for (const ChoiceSummary& summary : package_.summaries)
      if (auto reading = summarised(summary)) sheet.summaries.push_back(std::move(*reading));
    return sheet;
  }

 private:
  Result<void> takeEntry(const WorksheetEntry& entry) {
    const PackageItem* item = package_.item(entry.label);
    if (item == nullptr)
      return failure(ErrorCode::badUsage,
                     say<"The package %1 has no item '%2'; it has %3.">(package_.id, entry.label, labelList(package_)));
    if (item->isSided && entry.side != "right" && entry.side != "left")
      return failure(ErrorCode::badUsage, say<"%1 is measured on the right and on the left; say which, as in %1/right.">(entry.label));
    if (!item->isSided && !entry.side.empty())
      return failure(ErrorCode::badUsage, say<"%1 has no sides; leave '%2' out.">(entry.label, entry.side));
    if (item->measure == ItemMeasure::choice) {
      const bool isWord =
          std::any_of(item->choices.begin(), item->choices.end(), [&](const auto& each) { return each.first == entry.choice; });
      if (!isWord) return failure(ErrorCode::badUsage, say<"%1 is answered by one of %2.">(entry.label, choiceList(item->choices)));
      entries_[{entry.label, entry.side}].push_back(&entry);
      return {};
    }
    const Quantity& quantity = entry.quantity;
    if (!areComparable(quantity.unit, item->unit))
      return failure(ErrorCode::badField, say<"%1 is measured in %2, not in '%3'.">(entry.label, std::string(symbolOf(item->unit)),
                                                                                    std::string(symbolOf(quantity.unit))));
    const double value = converted(quantity.value, quantity.unit, item->unit);
    if (!item->valid.hold(value) || !(quantity.uncertainty >= 0.0) || !std::isfinite(quantity.uncertainty))
      return failure(ErrorCode::badField,
                     say<"%1 of %2 cannot be right: it lies from %3 to %4; check the value and its unit.">(
                         entry.label, inUnit(quantity.value, quantity.unit), inUnit(item->valid.low, item->unit),
                         inUnit(item->valid.high, item->unit)),
                     {{"field", entry.label}, {"found", textOf(value)}});
    if (entry.angle_rad) {
      if (item->measure != ItemMeasure::velocity)
        return failure(ErrorCode::badField, say<"%1 is no velocity; leave its angle out.">(entry.label), {{"field", entry.label}});
      if (!(*entry.angle_rad >= 0.0 && *entry.angle_rad < 0.5 * std::numbers::pi))
        return failure(ErrorCode::badField, say<"The angle of %1 has to lie from 0 to below 90 degrees.">(entry.label),
                       {{"field", entry.label}});
    }
    entries_[{entry.label, entry.side}].push_back(&entry);
    return {};
  }

  /// Of a velocity, by the error of the angle it was corrected by.
  [[nodiscard]] double errorByAngle(const WorksheetEntry& entry, Unit unit) const {
    if (!entry.angle_rad) return 0.0;
    return converted(entry.quantity.value, entry.quantity.unit, unit) * relativeErrorOfAngle(*entry.angle_rad, input_.angleError_rad);
  }

  static void remarkOnAngles(const std::vector<const WorksheetEntry*>& entries, WorksheetRow& row) {
    double steepest_rad = 0.0;
    for (const WorksheetEntry* entry : entries) steepest_rad = std::max(steepest_rad, entry->angle_rad.value_or(0.0));
    constexpr double kRounding_rad = 1e-9;
    if (steepest_rad > kSteepest_rad + kRounding_rad)
      row.remarks.push_back(say<"%1 was read at %2 degrees; beyond 60 degrees a small error of the angle is a large one of the velocity.">(
          row.label, numeral(fixedText(steepest_rad * 180.0 / std::numbers::pi, 0))));
  }

  /// The entry that counts when one of several does.
  const WorksheetEntry& chosen(const std::vector<const WorksheetEntry*>& entries) const {
    if (input_.several == Several::selected)
      for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
        if ((*entry)->isSelected) return **entry;
    return *entries.back();
  }

  void countEntries(const Key& key, const std::vector<const WorksheetEntry*>& entries) {
    const PackageItem& item = *package_.item(key.first);
    WorksheetRow& row = rows_[key];
    row.label = key.first;
    row.side = key.second;
    row.title = item.title;
    row.convention = item.convention;
    if (item.measure == ItemMeasure::choice) {
      row.choice = chosen(entries).choice;
      row.choiceTitle =
          std::find_if(item.choices.begin(), item.choices.end(), [&](const auto& each) { return each.first == row.choice; })->second;
      return;
    }
    for (const WorksheetEntry* entry : entries) {
      Quantity one = converted(entry->quantity, item.unit);
      one.uncertainty = std::hypot(one.uncertainty, errorByAngle(*entry, item.unit));
      row.measured.push_back(one);
    }
    Quantity value = converted(chosen(entries).quantity, item.unit);
    double byAngle = errorByAngle(chosen(entries), item.unit);
    if (input_.several == Several::mean) {
      // Measurements one by one are independent of each other.
      const auto count = static_cast<double>(row.measured.size());
      double sum = 0.0, squares = 0.0, angleSquares = 0.0;
      for (const WorksheetEntry* entry : entries) {
        const Quantity one = converted(entry->quantity, item.unit);
        sum += one.value;
        squares += one.uncertainty * one.uncertainty;
        angleSquares += std::pow(errorByAngle(*entry, item.unit), 2);
      }
      value = {sum / count, std::sqrt(squares) / count, item.unit};
      byAngle = std::sqrt(angleSquares) / count;
    }
    std::map<std::string, double> contributions{{named(key.first, key.second), value.uncertainty}};
    if (byAngle != 0.0)  // with the sign of the velocity: what flows back is wrong the other way
      contributions["angle of " + named(item.spectrum.empty() ? key.first : item.spectrum, key.second)] =
          std::copysign(byAngle, value.value);
    value.uncertainty = totalOf(contributions);
    row.value = value;
    row.ranges = rangesOf(package_, key.first, value);
    remarkOnAngles(entries, row);
    known_[key] = {value, std::move(contributions), {}};
  }

  [[nodiscard]] bool isSided(const PackageFormula& formula) const {
    return std::any_of(formula.inputs.begin(), formula.inputs.end(),
                       [&](const FormulaInput& input) { return input.side.empty() && isSided(input.of); });
  }
  [[nodiscard]] bool isSided(const std::string& label) const {
    if (const PackageItem* item = package_.item(label)) return item->isSided;
    const PackageFormula* formula = package_.formula(label);
    return formula != nullptr && isSided(*formula);
  }
  /// Where an input of a formula that is computed for `side` is found.
  [[nodiscard]] Key keyOf(const FormulaInput& input, const std::string& side) const {
    return {input.of, !isSided(input.of) ? "" : input.side.empty() ? side : input.side};
  }

  void computeFormula(const PackageFormula& formula, const std::string& side) {
    std::vector<const Known*> inputs;
    for (const FormulaInput& input : formula.inputs) {
      const auto found = known_.find(keyOf(input, side));
      if (found != known_.end())
        inputs.push_back(&found->second);
      else if (input.of != kByDates)
        return;
    }
    WorksheetRow row;
    row.label = formula.label;
    row.side = side;
    row.title = formula.title;
    row.isFormula = true;
    row.expression = formula.expression.text();
    row.source = formula.source;
    if (inputs.size() < formula.inputs.size()) {
      row.remarks.push_back(say<"%1 needs the gestational age by dates.">(formula.label));
      rows_[{formula.label, side}] = std::move(row);
      return;
    }
    std::vector<double> values;
    for (std::size_t n = 0; n < inputs.size(); ++n) {
      const FormulaInput& input = formula.inputs[n];
      const Quantity value = converted(inputs[n]->value, input.unit);
      row.inputs.push_back({input.name, input.of, keyOf(input, side).second, value, inputs[n]->from});
      values.push_back(value.value);
      if (!input.valid.hold(value.value))
        row.remarks.push_back(say<"%1 is valid for %2 from %3 to %4; %5 lies outside, so nothing is computed.">(
            formula.label, input.name, inUnit(input.valid.low, input.unit), inUnit(input.valid.high, input.unit),
            inUnit(value.value, input.unit)));
    }
    if (row.remarks.empty()) computeValue(formula, values, inputs, row);
    rows_[{formula.label, side}] = std::move(row);
  }

  void computeValue(const PackageFormula& formula, const std::vector<double>& values, const std::vector<const Known*>& inputs,
                    WorksheetRow& row) {
    const double result = formula.expression.evaluate(values);
    if (std::isnan(result)) {
      row.remarks.push_back(say<"%1 has no result for these values.">(formula.label));
      return;
    }
    if (!formula.valid.hold(result)) {
      row.remarks.push_back(say<"%1 is valid for results from %2 to %3; these values give %4, so it says nothing.">(
          formula.label, inUnit(formula.valid.low, formula.unit), inUnit(formula.valid.high, formula.unit),
          inUnit(numeral(shownValue({result, 0.0, formula.unit})), formula.unit)));
      return;
    }
    Known made{{result, 0.0, formula.unit}, {}, formula.label};
    const auto slopes = formula.expression.derivatives(values);
    std::map<std::string, double> sizes;
    for (std::size_t n = 0; n < inputs.size(); ++n)
      for (const auto& [name, part] : inputs[n]->contributions) {
        const double share = slopes[n] * converted(part, inputs[n]->value.unit, formula.inputs[n].unit);
        made.contributions[name] += share;
        sizes[name] += std::abs(share);
      }
    // Shares that cancel, of the angle in an index, leave what differences of the slopes are wrong by.
    for (auto& [name, part] : made.contributions)
      if (std::abs(part) < 1e-7 * sizes[name]) part = 0.0;
    made.value.uncertainty = totalOf(made.contributions);
    row.value = made.value;
    row.predictionError = formula.error.of(result);
    row.ranges = rangesOf(package_, formula.label, made.value);
    readCharts(formula, row);
    provide(formula, row.side, made);
    known_[{formula.label, row.side}] = std::move(made);
  }

  /// An item that was not measured has the first result that stands for it.
  void provide(const PackageFormula& formula, const std::string& side, const Known& made) {
    const PackageItem* item = package_.item(formula.provides);
    if (item == nullptr || known_.contains({item->label, side})) return;
    Known given{converted(made.value, item->unit), {}, formula.label};
    if (!item->valid.hold(given.value.value)) return;
    for (const auto& [name, part] : made.contributions) given.contributions[name] = converted(part, made.value.unit, item->unit);
    if (const double error = formula.error.of(made.value.value); error > 0.0)
      given.contributions["by " + named(formula.label, side)] = converted(error, made.value.unit, item->unit);
    given.value.uncertainty = totalOf(given.contributions);
    WorksheetRow row;
    row.label = item->label;
    row.side = side;
    row.title = item->title;
    row.convention = item->convention;
    row.value = given.value;
    row.from = formula.label;
    row.ranges = rangesOf(package_, item->label, given.value);
    rows_[{item->label, side}] = std::move(row);
    known_[{item->label, side}] = std::move(given);
  }

  void readCharts(const PackageFormula& formula, WorksheetRow& row) const {
    for (const PackageChart& chart : package_.charts) {
      if (std::find(chart.of.begin(), chart.of.end(), formula.label) == chart.of.end()) continue;
      if (!input_.gestation_weeks) {
        row.remarks.push_back(say<"The chart %1 needs the gestational age by dates.">(chart.label));
        continue;
      }
      const double weeks = *input_.gestation_weeks;
      if (!chart.valid_weeks.hold(weeks)) {
        row.remarks.push_back(say<"The chart %1 is valid from %2 to %3 weeks; %4 lies outside.">(
            chart.label, numeral(textOf(chart.valid_weeks.low)), numeral(textOf(chart.valid_weeks.high)), gestationText(weeks)));
        continue;
      }
      const Quantity value = converted(*row.value, chart.unit);
      const auto z = [&](double there) { return there > 0.0 ? zScore(chart, weeks, there) : -40.0; };
      ChartReading reading{chart.label, chart.title, z(value.value), 0.0, 0.0, 0.0, chart.source};
      reading.percentile = percentileOf(reading.z);
      reading.lowPercentile = percentileOf(z(value.value - value.uncertainty));
      reading.highPercentile = percentileOf(z(value.value + value.uncertainty));
      row.charts.push_back(std::move(reading));
    }
  }

  [[nodiscard]] std::optional<RedatingReading> redating() const {
    if (!package_.redating || !input_.gestation_weeks) return std::nullopt;
    const double dates_weeks = *input_.gestation_weeks;
    for (const RedatingStep& step : package_.redating->steps) {
      if (!(dates_weeks < step.below_weeks)) continue;
      for (const std::string& label : step.by) {
        const auto found = known_.find({label, ""});
        if (found == known_.end()) continue;
        const double scan_weeks = converted(found->second.value.value, found->second.value.unit, Unit::weeks);
        const long long difference_days = std::llround(7.0 * (scan_weeks - dates_weeks));
        const bool redate = static_cast<double>(std::abs(difference_days)) > step.moreThan_days;
        return RedatingReading{label, dates_weeks, scan_weeks, difference_days, step.moreThan_days, redate, package_.redating->source};
      }
      return std::nullopt;
    }
    return std::nullopt;
  }

  /// Nothing, when nothing of it was answered.
  [[nodiscard]] std::optional<SummaryReading> summarised(const ChoiceSummary& summary) const {
    std::vector<std::string> answers;
    bool isAnswered = false;
    for (const std::string& label : summary.items) {
      const bool isTwo = package_.item(label)->isSided;
      for (const char* side : {"", "right", "left"}) {
        if (isTwo == (*side == '\0')) continue;
        const auto row = rows_.find({label, side});
        isAnswered = isAnswered || row != rows_.end();
        answers.push_back(row == rows_.end() ? summary.unanswered : row->second.choice);
      }
    }
    if (!isAnswered) return std::nullopt;
    for (const ChoiceRule& rule : summary.rules) {
      const auto has = [&](const std::string& answer) { return rule.choice.empty() || answer == rule.choice; };
      const bool holds = rule.all ? std::all_of(answers.begin(), answers.end(), has) : std::any_of(answers.begin(), answers.end(), has);
      if (holds) return SummaryReading{summary.title, rule.says};
    }
    return std::nullopt;
  }

  const Package& package_;
  const WorksheetInput& input_;
  std::map<Key, std::vector<const WorksheetEntry*>> entries_;
  std::map<Key, Known> known_;
  std::map<Key, WorksheetRow> rows_;
};

}  // namespace

const WorksheetRow* Worksheet::row(std::string_view label, std::string_view side) const {
  for (const SectionValues& section : sections)
    for (const WorksheetRow& each : section.rows)
      if (each.label == label && each.side == side) return &each;
  return nullptr;
}

double relativeErrorOfAngle(double angle_rad, double angleError_rad) { return std::tan(angle_rad) * angleError_rad; }

Message sentenceOf(const RedatingReading& reading) {
  const Message days = numeral(textOf(reading.moreThan_days));
  if (reading.redate)
    return say<"The scan says %1, dates say %2: %3 days apart, more than %4, so the dates are to be replaced by the scan.">(
        gestationText(reading.scan_weeks), gestationText(reading.dates_weeks), std::abs(reading.difference_days), days);
  if (std::abs(reading.difference_days) == 1)
    return say<"The scan says %1, dates say %2: one day apart, not more than %3, so the dates stay.">(
        gestationText(reading.scan_weeks), gestationText(reading.dates_weeks), days);
  return say<"The scan says %1, dates say %2: %3 days apart, not more than %4, so the dates stay.">(
      gestationText(reading.scan_weeks), gestationText(reading.dates_weeks), std::abs(reading.difference_days), days);
}

Result<Worksheet> fillWorksheet(const Package& package, const WorksheetInput& input) {
  Filling filling(package, input);
  if (auto taken = filling.takeEntries(); !taken) return passOn(taken.error());
  filling.compute();
  return filling.laidOut();
}

}  // namespace ew::measurement
