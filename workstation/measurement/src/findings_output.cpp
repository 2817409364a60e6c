#include <nlohmann/json.hpp>

#include "csv.h"
#include "ew/core/numbers.h"
#include "ew/measurement/findings.h"
#include "quantity_json.h"

namespace ew::measurement {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view kSimulation = "simulation, not for diagnosis";

bool isStrip(std::uint64_t image) { return image >= kStripImage; }

ordered_json placeOf(const Findings& findings, std::uint64_t image, int number) {
  ordered_json made;
  if (isStrip(image))
    made["strip"] = true;
  else
    made["image"] = findings.ordinalOf(image);
  made["number"] = number;
  return made;
}

std::string line(const std::vector<std::string>& fields) {
  std::string made;
  for (std::size_t n = 0; n < fields.size(); ++n) made += (n == 0 ? "" : ",") + csvField(fields[n]);
  return made + "\r\n";
}

std::string placeText(const Findings& findings, std::uint64_t image) {
  return isStrip(image) ? std::string("strip") : "image " + std::to_string(findings.ordinalOf(image));
}

std::string madeFrom(const Findings& findings, const Combination& combination) {
  std::string made;
  for (const FigureRef& ref : combination.of)
    made += (made.empty() ? "" : "; ") + placeText(findings, ref.image) + " no. " + std::to_string(ref.number) + " " +
            std::string(wordOf(ref.figure));
  return made;
}

std::string uncertaintyText(const Quantity& quantity) { return quantity.uncertainty > 0.0 ? textOf(quantity.uncertainty) : std::string(); }

}  // namespace

ordered_json toJson(const Findings& findings, const std::string& title) {
  ordered_json measurements = ordered_json::array(), results = ordered_json::array();
  for (const Finding& each : findings.all()) {
    ordered_json one = placeOf(findings, each.image, each.measurement.number);
    one["kind"] = wordOf(each.measurement.caliper.kind);
    if (!each.measurement.name.empty()) one["name"] = each.measurement.name;
    if (!each.measurement.item.empty()) one["item"] = each.measurement.item;
    if (!each.measurement.side.empty()) one["side"] = each.measurement.side;
    if (each.measurement.caliper.kind == CaliperKind::heartRate) one["cycles"] = each.measurement.caliper.cycles;
    one["figures"] = ordered_json::array();
    for (const CaliperFigure& figure : each.measured.figures) {
      ordered_json made = {{"figure", wordOf(figure.kind)}};
      made.update(jsonOf(figure.quantity));
      one["figures"].push_back(std::move(made));
    }
    for (const Message& remark : each.measured.remarks) one["remarks"].push_back(remark.english());
    measurements.push_back(std::move(one));
  }
  for (const Combination& each : findings.combinations()) {
    ordered_json one = {{"number", each.number}, {"kind", wordOf(each.kind)}};
    for (const FigureRef& ref : each.of) {
      ordered_json from = placeOf(findings, ref.image, ref.number);
      from["figure"] = wordOf(ref.figure);
      one["of"].push_back(std::move(from));
    }
    if (const auto combined = findings.combine(each.kind, each.of)) {
      one.update(jsonOf(combined->quantity));
      one["correlation"] = combined->correlation;
      for (const Message& remark : combined->remarks) one["remarks"].push_back(remark.english());
    } else {
      one["remarks"].push_back(combined.error().message.english());
    }
    results.push_back(std::move(one));
  }
  return {{"format", kFindingsFormat},
          {"note", kSimulation},
          {"title", title},
          {"measurements", std::move(measurements)},
          {"results", std::move(results)}};
}

std::string toCsv(const Findings& findings, const std::string& title) {
  std::string made = line({"place", "number", "kind", "item", "side", "figure", "value", "uncertainty", "unit", "from", "note"});
  for (const Finding& each : findings.all())
    for (const CaliperFigure& figure : each.measured.figures)
      made += line(
          {placeText(findings, each.image), std::to_string(each.measurement.number), std::string(wordOf(each.measurement.caliper.kind)),
           each.measurement.item, each.measurement.side, std::string(wordOf(figure.kind)), textOf(figure.quantity.value),
           uncertaintyText(figure.quantity), std::string(symbolOf(figure.quantity.unit)),
           each.measurement.caliper.kind == CaliperKind::heartRate ? std::to_string(each.measurement.caliper.cycles) + " beats" : "",
           title + ": " + std::string(kSimulation)});
  for (const Combination& each : findings.combinations()) {
    const auto combined = findings.combine(each.kind, each.of);
    const Quantity quantity = combined ? combined->quantity : Quantity{};
    made += line({"result", std::to_string(each.number), std::string(wordOf(each.kind)), "", "", std::string(wordOf(each.kind)),
                  combined ? textOf(quantity.value) : "", combined ? uncertaintyText(quantity) : "",
                  combined ? std::string(symbolOf(quantity.unit)) : "", madeFrom(findings, each),
                  combined ? "correlation " + textOf(combined->correlation) : combined.error().message.english()});
  }
  return made;
}

}  // namespace ew::measurement
