#include <nlohmann/json.hpp>

#include "csv.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/measurement/worksheet.h"
#include "quantity_json.h"

namespace ew::measurement {
namespace {

using nlohmann::ordered_json;

constexpr int kWorksheetFormat = 1;

constexpr WordTable<Several, 3> kSeveralWords{{{"mean", Several::mean}, {"last", Several::last}, {"selected", Several::selected}}};
const char* wordOf(Several several) { return wordIn(kSeveralWords, several); }

ordered_json jsonOf(const WorksheetRow& row, std::string_view language) {
  ordered_json made = {{"label", row.label}};
  if (!row.side.empty()) made["side"] = row.side;
  made["title"] = row.title.in(language);
  made["kind"] = row.isFormula ? "formula" : "item";
  if (row.value) made.update(jsonOf(*row.value));
  if (!row.choice.empty()) made.update(ordered_json{{"choice", row.choice}, {"choice_title", row.choiceTitle.in(language)}});
  if (row.predictionError > 0.0) made["prediction_error"] = row.predictionError;
  if (row.measured.size() > 1)
    for (const Quantity& one : row.measured) made["measured"].push_back(jsonOf(one));
  if (!row.convention.in(language).empty()) made["convention"] = row.convention.in(language);
  made["how"] = howItCameAbout(row);
  if (!row.expression.empty()) made["expression"] = row.expression;
  if (!row.source.empty()) made["source"] = row.source;
  for (const RangeReading& reading : row.ranges) {
    ordered_json range = {
        {"range", rangeText(reading.range).english()}, {"verdict", wordOf(reading.verdict)}, {"source", reading.range.source}};
    if (!reading.range.applies.in(language).empty()) range["applies"] = reading.range.applies.in(language);
    made["usual"].push_back(std::move(range));
  }
  for (const ChartReading& chart : row.charts)
    made["charts"].push_back({{"label", chart.label},
                              {"title", chart.title.in(language)},
                              {"percentile", chart.percentile},
                              {"percentile_of_less_uncertainty", chart.lowPercentile},
                              {"percentile_of_more_uncertainty", chart.highPercentile},
                              {"z", chart.z},
                              {"source", chart.source}});
  for (const Message& remark : row.remarks) made["remarks"].push_back(remark.english());
  return made;
}

template <class Parts, class Text>
std::string listed(const Parts& parts, Text text) {
  std::string all;
  for (const auto& part : parts) all += (all.empty() ? "" : "; ") + text(part);
  return all;
}

constexpr WordTable<RangeVerdict, 3> kRangeVerdictWords{
    {{"below", RangeVerdict::below}, {"within", RangeVerdict::within}, {"above", RangeVerdict::above}}};

}  // namespace

std::string_view wordOf(RangeVerdict verdict) { return wordIn(kRangeVerdictWords, verdict); }

Message rangeText(const ReferenceRange& range) {
  const std::string unit = range.unit == Unit::one ? "" : " " + std::string(symbolOf(range.unit));
  const auto number = [](double value) { return numeral(textOf(value)); };
  if (range.low && range.high) return say<"%1 to %2%3">(number(*range.low), number(*range.high), unit);
  return range.high ? say<"up to %1%2">(number(*range.high), unit) : say<"from %1%2">(number(*range.low), unit);
}

std::string howItCameAbout(const WorksheetRow& row) {
  std::string text;
  for (const FormulaValue& used : row.inputs) {
    text += (text.empty() ? "from " : ", ") + used.of + (used.side.empty() ? "" : "/" + used.side) + " " + shown(used.value);
    if (!used.from.empty() && used.from != used.of) text += " (by " + used.from + ")";
  }
  if (!text.empty()) return text;
  if (!row.from.empty()) return "by " + row.from;
  if (!row.choice.empty()) return "answered";
  return row.measured.size() > 1 ? "measured " + std::to_string(row.measured.size()) + " times" : "measured";
}

ordered_json toJson(const Worksheet& worksheet, std::string_view language) {
  ordered_json made = {{"format", kWorksheetFormat},
                       {"package", worksheet.package},
                       {"package_version", worksheet.packageVersion},
                       {"title", worksheet.title.in(language)},
                       {"source", worksheet.source},
                       {"notice", kTrainingOnly},
                       {"several", wordOf(worksheet.several)}};
  if (worksheet.gestation_weeks) made["gestation_by_dates"] = gestationText(*worksheet.gestation_weeks);
  made["sections"] = ordered_json::array();
  for (const SectionValues& section : worksheet.sections) {
    ordered_json rows = ordered_json::array();
    for (const WorksheetRow& row : section.rows) rows.push_back(jsonOf(row, language));
    made["sections"].push_back({{"title", section.title.in(language)}, {"rows", std::move(rows)}});
  }
  if (worksheet.redating) {
    const RedatingReading& reading = *worksheet.redating;
    made["redating"] = {{"by", reading.formula},
                        {"scan", gestationText(reading.scan_weeks)},
                        {"difference_days", reading.difference_days},
                        {"more_than_days", reading.moreThan_days},
                        {"redate", reading.redate},
                        {"says", sentenceOf(reading).english()},
                        {"source", reading.source}};
  }
  for (const SummaryReading& summary : worksheet.summaries)
    made["summaries"].push_back({{"title", summary.title.in(language)}, {"says", summary.says.in(language)}});
  return made;
}

std::string toCsv(const Worksheet& worksheet, std::string_view language) {
  std::string csv = "section,label,side,title,value,uncertainty,unit,prediction_error,usual,verdict,percentile,how,source,remarks,notice\n";
  const auto number = [](double value) { return textOf(value); };
  const auto add = [&](const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) csv += csvField(cell) + ",";
    csv += csvField(kTrainingOnly) + "\n";
  };
  for (const SectionValues& section : worksheet.sections)
    for (const WorksheetRow& row : section.rows)
      add({section.title.in(language), row.label, row.side, row.title.in(language), row.value ? number(row.value->value) : row.choice,
           row.value && row.value->uncertainty > 0.0 ? number(row.value->uncertainty) : "",
           row.value ? std::string(symbolOf(row.value->unit)) : "", row.predictionError > 0.0 ? number(row.predictionError) : "",
           listed(row.ranges,
                  [&](const RangeReading& reading) {
                    const std::string& whom = reading.range.applies.in(language);
                    return rangeText(reading.range).english() + (whom.empty() ? "" : " (" + whom + ")");
                  }),
           listed(row.ranges, [](const RangeReading& reading) { return std::string(wordOf(reading.verdict)); }),
           listed(row.charts, [&](const ChartReading& chart) { return chart.label + " " + number(chart.percentile); }), howItCameAbout(row),
           row.source, listed(row.remarks, [](const Message& remark) { return remark.english(); })});
  if (worksheet.redating)
    add({"", "redating", "", "", worksheet.redating->redate ? "yes" : "no", "", "", "", "", "", "",
         sentenceOf(*worksheet.redating).english(), worksheet.redating->source, ""});
  for (const SummaryReading& summary : worksheet.summaries)
    add({"", "summary", "", summary.title.in(language), summary.says.in(language), "", "", "", "", "", "", "", "", ""});
  return csv;
}

}  // namespace ew::measurement
