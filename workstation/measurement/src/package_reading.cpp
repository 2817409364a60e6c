#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/measurement/package.h"
#include "reading_fields.h"

namespace ew::measurement {
namespace {

using nlohmann::json;

constexpr std::size_t kMostEntries = 200;

constexpr WordTable<ItemMeasure, 12> kMeasures{{{"distance", ItemMeasure::distance},
                                                {"circumference", ItemMeasure::circumference},
                                                {"area", ItemMeasure::area},
                                                {"volume", ItemMeasure::volume},
                                                {"angle", ItemMeasure::angle},
                                                {"ratio", ItemMeasure::ratio},
                                                {"slope", ItemMeasure::slope},
                                                {"heart_rate", ItemMeasure::heartRate},
                                                {"duration", ItemMeasure::duration},
                                                {"velocity", ItemMeasure::velocity},
                                                {"number", ItemMeasure::number},
                                                {"choice", ItemMeasure::choice}}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kSides{{{"right", "right"}, {"left", "left"}}};

std::string longText(const JsonFields& fields, std::string_view key, std::optional<std::string> fallback = {}) {
  return fields.text(key, std::move(fallback), 1, kLongestText);
}

Expression expressionIn(const JsonFields& fields, std::string_view key, std::vector<std::string> inputs) {
  const std::string text = longText(fields, key);
  if (!fields.good()) return {};
  auto made = Expression::of(text, std::move(inputs));
  if (!made) {
    Error problem = std::move(made.error());
    problem.message = say<"'%1' in %2 cannot be used. %3">(fields.placeOf(key), fields.reading().where(), std::move(problem.message));
    problem.context.insert(problem.context.begin(), {"field", fields.placeOf(key)});
    fields.reading().refuse(std::move(problem));
    return {};
  }
  return std::move(*made);
}

PackageItem itemIn(const JsonFields& fields) {
  PackageItem item;
  fields.only({"label", "title", "measure", "unit", "convention", "plane", "sided", "valid", "choices", "spectrum"});
  item.label = labelIn(fields, "label");
  item.title = wordsIn(fields, "title");
  item.measure = fields.word("measure", kMeasures);
  item.isSided = fields.flag("sided", false);
  item.convention = wordsIn(fields, "convention");
  item.plane = wordsIn(fields, "plane");
  if (!fields.good()) return item;
  if (item.measure == ItemMeasure::choice) {
    for (const char* other : {"unit", "valid", "spectrum"})
      if (fields.has(other)) fields.refuse(other, say<"left out of a choice">());
    for (const JsonFields& choice : fields.objects("choices", 2, 20)) {
      choice.only({"word", "title"});
      item.choices.emplace_back(labelIn(choice, "word"), wordsIn(choice, "title"));
    }
    item.unit = Unit::one;
    return item;
  }
  if (fields.has("choices")) fields.refuse("choices", say<"left out, unless the measure is \"choice\"">());
  item.unit = unitIn(fields, "unit");
  item.valid = limitsIn(fields, "valid");
  if (item.measure == ItemMeasure::velocity && !areComparable(item.unit, Unit::cmPerS)) fields.refuse("unit", say<"mm/s or cm/s">());
  if (fields.has("spectrum")) {
    item.spectrum = labelIn(fields, "spectrum");
    if (item.measure != ItemMeasure::velocity) fields.refuse("spectrum", say<"left out, unless the measure is \"velocity\"">());
  }
  return item;
}

/// Reads one package; what stands later in the document refers to what was read before.
struct PackageReader {
  Package package;

  [[nodiscard]] std::optional<Unit> unitOfLabel(const std::string& label) const {
    if (const auto* item = package.item(label)) return item->measure == ItemMeasure::choice ? std::nullopt : std::optional(item->unit);
    if (const auto* formula = package.formula(label)) return formula->unit;
    return std::nullopt;
  }
  [[nodiscard]] bool knows(const std::string& label) const { return package.item(label) != nullptr || package.formula(label) != nullptr; }
  /// An item's or a formula's.
  void refuseKnown(const JsonFields& fields, const std::string& label) const {
    if (knows(label) || label == kByDates) fields.refuse("label", say<"a label that no other entry has">());
  }

  void readItems(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("items", 1, kMostEntries)) {
      PackageItem item = itemIn(each);
      refuseKnown(each, item.label);
      package.items.push_back(std::move(item));
    }
  }

  FormulaInput inputIn(const JsonFields& fields) const {
    FormulaInput input;
    fields.only({"name", "of", "side", "unit", "valid"});
    input.name = labelIn(fields, "name");
    input.of = fields.text("of", input.name);
    if (fields.has("side")) input.side = fields.word("side", kSides);
    input.unit = unitIn(fields, "unit");
    input.valid = limitsIn(fields, "valid");
    const auto unit = input.of == kByDates ? std::optional(Unit::weeks) : unitOfLabel(input.of);
    const auto name = fields.has("of") ? "of" : "name";
    if (!unit)
      fields.refuse(name, say<"the label of an item with a unit or of an earlier formula">());
    else if (!areComparable(*unit, input.unit))
      fields.refuse("unit", say<"a unit that %1 can be converted to">(input.of));
    return input;
  }

  static FormulaError errorIn(const JsonFields& fields) {
    if (!fields.has("error")) return {};
    const JsonFields error = fields.object("error");
    error.only({"percent", "absolute"});
    const FormulaError made{error.number("percent", 0.0, 100.0, 0.0), error.number("absolute", 0.0, kFarthest, 0.0)};
    if (error.has("percent") == error.has("absolute")) fields.refuse("error", say<"an object with either \"percent\" or \"absolute\"">());
    return made;
  }

  void readFormulas(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("formulas", 0, kMostEntries)) {
      PackageFormula formula;
      each.only({"label", "title", "expression", "inputs", "unit", "valid", "provides", "source", "status", "error", "tests"});
      formula.label = labelIn(each, "label");
      refuseKnown(each, formula.label);
      formula.title = wordsIn(each, "title");
      std::vector<std::string> names;
      for (const JsonFields& input : each.objects("inputs", 1, 12)) {
        formula.inputs.push_back(inputIn(input));
        names.push_back(formula.inputs.back().name);
      }
      formula.expression = expressionIn(each, "expression", std::move(names));
      formula.unit = unitIn(each, "unit");
      formula.valid = limitsIn(each, "valid");
      formula.source = longText(each, "source");
      formula.status = longText(each, "status", "");
      formula.error = errorIn(each);
      if (each.has("provides")) {
        formula.provides = each.text("provides");
        const PackageItem* item = package.item(formula.provides);
        if (item == nullptr || item->measure == ItemMeasure::choice || !areComparable(item->unit, formula.unit))
          each.refuse("provides", say<"the label of an item whose unit the result can be converted to">());
      }
      readTestVectors(each, formula.expression, formula.tests);
      if (!each.good()) return;
      package.formulas.push_back(std::move(formula));
    }
  }

  void readCharts(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("charts", 0, kMostEntries)) {
      PackageChart chart;
      each.only({"label", "title", "of", "unit", "valid_weeks", "median", "spread_percent", "lms", "of_logarithm", "table", "source",
                 "status", "tests"});
      chart.label = labelIn(each, "label");
      chart.title = wordsIn(each, "title");
      chart.of = each.texts("of", 1, 20);
      chart.unit = unitIn(each, "unit");
      for (const std::string& label : chart.of) {
        const PackageFormula* formula = package.formula(label);
        if (formula == nullptr || !areComparable(formula->unit, chart.unit))
          each.refuse("of", say<"labels of formulas whose results can be converted to the chart's unit">());
      }
      chart.valid_weeks = limitsIn(each, "valid_weeks");
      chart.source = longText(each, "source");
      chart.status = longText(each, "status", "");
      chart.isLms = each.has("lms");
      if (each.has("table")) {
        readTable(each, chart);
      } else if (chart.isLms) {
        for (const char* other : {"median", "spread_percent"})
          if (each.has(other)) each.refuse(other, say<"left out of a chart with \"lms\"">());
        const JsonFields lms = each.object("lms");
        lms.only({"L", "M", "S"});
        chart.L = expressionIn(lms, "L", {"GA"});
        chart.M = expressionIn(lms, "M", {"GA"});
        chart.S = expressionIn(lms, "S", {"GA"});
        chart.ofLogarithm = each.flag("of_logarithm", false);
      } else {
        if (each.has("of_logarithm")) each.refuse("of_logarithm", say<"left out, unless the chart has \"lms\"">());
        chart.median = expressionIn(each, "median", {"GA"});
        chart.spread_percent = each.number("spread_percent", 0.1, 100.0);
      }
      readChartTests(each, chart);
      if (!each.good()) return;
      package.charts.push_back(std::move(chart));
    }
  }

  static void readTable(const JsonFields& fields, PackageChart& chart) {
    for (const char* other : {"lms", "median", "spread_percent", "of_logarithm"})
      if (fields.has(other)) fields.refuse(other, say<"left out of a chart with \"table\"">());
    const JsonFields table = fields.object("table");
    table.only({"low_percentile", "rows"});
    chart.lowPercentile = table.number("low_percentile", 0.1, 49.0);
    const Message expected = say<"weeks that rise, each with three rising values: low, median and high">();
    for (const JsonFields& each : table.objects("rows", 2, kMostEntries)) {
      each.only({"weeks", "low", "median", "high"});
      const PackageChart::Row row{each.number("weeks", 0.0, 50.0), each.number("low", 0.0, kFarthest),
                                  each.number("median", 0.0, kFarthest), each.number("high", 0.0, kFarthest)};
      const bool rises = chart.rows.empty() || row.weeks > chart.rows.back().weeks;
      if (!rises || !(row.low < row.median && row.median < row.high)) table.refuse("rows", expected);
      chart.rows.push_back(row);
    }
    if (fields.good() && (chart.valid_weeks.low < chart.rows.front().weeks || chart.valid_weeks.high > chart.rows.back().weeks))
      fields.refuse("valid_weeks", say<"within the weeks of the table">());
  }

  static void readChartTests(const JsonFields& fields, PackageChart& chart) {
    for (const JsonFields& each : fields.objects("tests", 1, kMostEntries)) {
      each.only({"weeks", "percentile", "value", "digits"});
      PackageChart::Test test;
      test.weeks = each.number("weeks", chart.valid_weeks.low, chart.valid_weeks.high);
      test.percentile = each.number("percentile", 0.1, 99.9, 50.0);
      test.value = each.number("value", 1e-9, kFarthest);
      test.digits = static_cast<int>(each.whole("digits", 0, 9));
      if (!each.good()) return;
      const double found = valueAt(chart, test.weeks, zOfPercentile(test.percentile));
      if (!(std::abs(found - test.value) <= 0.5000001 * std::pow(10.0, -test.digits)))
        each.refuse("value", say<"%1, which the chart gives; correct the one that is wrong">(textOf(found)));
      chart.tests.push_back(test);
    }
  }

  void readRanges(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("ranges", 0, kMostEntries)) {
      ReferenceRange range;
      each.only({"of", "unit", "low", "high", "applies", "source"});
      range.of = each.text("of");
      range.unit = unitIn(each, "unit");
      const auto unit = unitOfLabel(range.of);
      if (!unit)
        each.refuse("of", say<"the label of an item with a unit or of a formula">());
      else if (!areComparable(*unit, range.unit))
        each.refuse("unit", say<"a unit that %1 can be converted to">(range.of));
      if (each.has("low")) range.low = each.number("low", -kFarthest, kFarthest);
      if (each.has("high")) range.high = each.number("high", range.low.value_or(-kFarthest), kFarthest);
      if (!range.low && !range.high) each.refuse("high", say<"a number, when there is no \"low\"">());
      range.applies = wordsIn(each, "applies", kLongestText, false);
      range.source = longText(each, "source");
      package.ranges.push_back(std::move(range));
    }
  }

  void readRedating(const JsonFields& fields) {
    if (!fields.has("redating")) return;
    const JsonFields object = fields.object("redating");
    object.only({"source", "steps"});
    Redating made;
    made.source = longText(object, "source");
    double below_weeks = 0.0;
    for (const JsonFields& each : object.objects("steps", 1, 20)) {
      each.only({"below_weeks", "more_than_days", "by"});
      RedatingStep step{each.number("below_weeks", below_weeks, 50.0), each.number("more_than_days", 0.0, 60.0), each.texts("by", 1, 40)};
      for (const std::string& label : step.by)
        if (const auto* formula = package.formula(label); formula == nullptr || !areComparable(formula->unit, Unit::weeks))
          each.refuse("by", say<"labels of formulas that give a gestational age">());
      below_weeks = step.below_weeks;
      made.steps.push_back(std::move(step));
    }
    package.redating = std::move(made);
  }

  void readSummaries(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("summaries", 0, 20)) {
      ChoiceSummary summary;
      each.only({"title", "items", "unanswered", "rules"});
      summary.title = wordsIn(each, "title");
      summary.items = each.texts("items", 1, kMostEntries);
      std::set<std::string> words;
      for (const std::string& label : summary.items) {
        const PackageItem* item = package.item(label);
        if (item == nullptr || item->measure != ItemMeasure::choice)
          each.refuse("items", say<"labels of choices">());
        else
          for (const auto& [word, title] : item->choices) words.insert(word);
      }
      summary.unanswered = each.text("unanswered");
      if (!words.contains(summary.unanswered)) each.refuse("unanswered", say<"a word of the choices">());
      for (const JsonFields& rule : each.objects("rules", 1, 20)) {
        rule.only({"choice", "all", "says"});
        ChoiceRule made{rule.text("choice", "", 0), rule.flag("all", false), wordsIn(rule, "says")};
        if (!made.choice.empty() && !words.contains(made.choice)) rule.refuse("choice", say<"a word of the choices">());
        summary.rules.push_back(std::move(made));
      }
      package.summaries.push_back(std::move(summary));
    }
  }

  void readWorksheet(const JsonFields& fields) {
    for (const JsonFields& each : fields.objects("worksheet", 1, 50)) {
      each.only({"title", "rows"});
      WorksheetSection section{wordsIn(each, "title"), each.texts("rows", 1, kMostEntries)};
      for (std::size_t n = 0; n < section.rows.size(); ++n)
        if (!knows(section.rows[n]))
          each.refuse("rows[" + std::to_string(n) + "]", verbatim('"' + section.rows[n] + '"'), say<"the label of an item or a formula">());
      package.worksheet.push_back(std::move(section));
    }
  }
};

}  // namespace

std::string_view wordOf(ItemMeasure measure) { return wordIn(kMeasures, measure); }

Result<Package> packageFromJson(const json& document, const std::string& id, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields fields(document, reading);
  requireFormat(fields, kPackageFormat);
  fields.only({"format", "version", "title", "source", "items", "formulas", "charts", "ranges", "redating", "summaries", "worksheet"});
  PackageReader reader;
  reader.package.id = id;
  reader.package.version = static_cast<int>(fields.whole("version", 1, 1000000));
  reader.package.title = wordsIn(fields, "title");
  reader.package.source = longText(fields, "source");
  reader.readItems(fields);
  reader.readFormulas(fields);
  reader.readCharts(fields);
  reader.readRanges(fields);
  reader.readRedating(fields);
  reader.readSummaries(fields);
  reader.readWorksheet(fields);
  if (reading.problem()) return passOn(*reading.problem());
  return std::move(reader.package);
}

}  // namespace ew::measurement
