#include "ew/measurement/worksheet_line.h"

#include <cmath>

#include "ew/core/figures.h"

namespace ew::measurement {
namespace {

Message verdictText(RangeVerdict verdict) {
  switch (verdict) {
    case RangeVerdict::below:
      return say<"low">();
    case RangeVerdict::within:
      return say<"usual">();
    case RangeVerdict::above:
      return say<"high">();
  }
  return {};
}

Message titleOf(const WorksheetRow& row, std::string_view language) {
  std::string title = row.title.in(language);
  if (row.side == "right") return say<"%1, right">(std::move(title));
  if (row.side == "left") return say<"%1, left">(std::move(title));
  return verbatim(std::move(title));
}

Message valueOf(const WorksheetRow& row, std::string_view language) {
  if (!row.choice.empty()) return verbatim(row.choiceTitle.in(language));
  if (!row.value) return verbatim("–");
  return quantityText({row.value->value, std::hypot(row.value->uncertainty, row.predictionError), row.value->unit});
}

std::vector<Message> originOf(const WorksheetRow& row) {
  std::vector<Message> all;
  if (row.measured.size() > 1) {
    std::vector<Message> each;
    for (const Quantity& quantity : row.measured) each.push_back(numeral(shownValue(quantity)));
    all.push_back(say<"mean of %1">(joined(std::move(each), "; ")));
  }
  if (!row.from.empty()) all.push_back(say<"by %1">(row.from));
  if (row.isFormula && row.value && !row.inputs.empty()) {
    std::vector<Message> from;
    for (const FormulaValue& used : row.inputs)
      from.push_back(joined({verbatim(used.of), quantityText({used.value.value, 0.0, used.value.unit})}));
    all.push_back(say<"from %1">(joined(std::move(from), ", ")));
  }
  all.insert(all.end(), row.remarks.begin(), row.remarks.end());
  return all;
}

std::vector<Message> againstOf(const WorksheetRow& row, std::string_view language) {
  std::vector<Message> all;
  for (const RangeReading& reading : row.ranges) {
    Message verdict = verdictText(reading.verdict), range = rangeText(reading.range);
    std::string whom = reading.range.applies.in(language);
    all.push_back(whom.empty() ? say<"%1 (usual: %2)">(std::move(verdict), std::move(range))
                               : say<"%1 (usual: %2; %3)">(std::move(verdict), std::move(range), std::move(whom)));
  }
  const auto percent = [](double percentile) { return numeral(fixedText(percentile, 0)); };
  for (const ChartReading& chart : row.charts)
    all.push_back(say<"percentile %1 (%2 to %3), %4">(percent(chart.percentile), percent(chart.lowPercentile),
                                                      percent(chart.highPercentile), chart.title.in(language)));
  return all;
}

}  // namespace

WorksheetLine lineOf(const WorksheetRow& row, std::string_view language) {
  return {titleOf(row, language), valueOf(row, language), originOf(row), againstOf(row, language)};
}

}  // namespace ew::measurement
