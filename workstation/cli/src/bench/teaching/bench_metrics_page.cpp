#include <algorithm>
#include <cmath>

#include "bench/teaching/bench_metrics.h"
#include "run/arguments.h"

namespace ew {
namespace {

using cli::rounded;
using nlohmann::json;

constexpr const char* kBegin = "<!-- bench metrics: begin -->";
constexpr const char* kEnd = "<!-- bench metrics: end -->";
constexpr const char* kKinds[] = {"plane", "sweep", "measure", "point", "settings", "answer", "free"};

std::string text(const json& row, const char* key) { return row[key].get<std::string>(); }

std::string number(const json& estimate, int digits = 2) {
  return estimate.is_null() ? std::string("-") : rounded(estimate["value"].get<double>(), digits);
}
std::string withInterval(const json& estimate, int digits = 2) {
  if (estimate.is_null()) return "-";
  return number(estimate, digits) + " (" + rounded(estimate["low"].get<double>(), digits) + " to " +
         rounded(estimate["high"].get<double>(), digits) + ")";
}

std::vector<json> rowsOfScope(const json& measured, const std::string& scope) {
  std::vector<json> rows;
  for (const json& row : measured["rows"])
    if (text(row, "scope") == scope) rows.push_back(row);
  return rows;
}

std::string overview(const json& measured) {
  std::string page = "| metric | all steps |";
  for (const char* kind : kKinds) page += std::string(" ") + kind + " |";
  page += "\n|---|---|";
  for (std::size_t n = 0; n < std::size(kKinds); ++n) page += "---|";
  page += "\n";
  const auto byKind = rowsOfScope(measured, "kind");
  for (const json& row : rowsOfScope(measured, "all")) {
    page += "| " + text(row, "metric") + " | " + withInterval(row["auc"]) + (row["on"].get<bool>() ? "" : ", off") + " |";
    for (const char* kind : kKinds) {
      const auto at = std::find_if(byKind.begin(), byKind.end(), [&](const json& each) {
        return text(each, "metric") == text(row, "metric") && text(each, "name") == kind;
      });
      page += at == byKind.end() ? " |" : " " + number((*at)["auc"]) + ((*at)["on"].get<bool>() ? "" : ", off") + " |";
    }
    page += "\n";
  }
  return page;
}

std::string details(const json& measured, const std::string& scope, const char* nameColumn) {
  std::string page = std::string("| ") + nameColumn +
                     " | metric | steps | n | g, novice and expert | AUC, novice and expert | AUC, novice and intermediate | AUC, "
                     "intermediate and expert | default |\n|---|---|---|---|---|---|---|---|---|\n";
  auto rows = rowsOfScope(measured, scope);
  std::stable_sort(rows.begin(), rows.end(), [](const json& a, const json& b) { return text(a, "name") < text(b, "name"); });
  for (const json& row : rows)
    page += "| " + text(row, "name") + " | " + text(row, "metric") + " | " + std::to_string(row["steps"].get<int>()) + " | " +
            std::to_string(row["n"].get<int>()) + " | " + withInterval(row["g"]) + " | " + withInterval(row["auc"]) + " | " +
            withInterval(row["auc_novice_intermediate"]) + " | " + withInterval(row["auc_intermediate_expert"]) + " | " +
            (row["on"].get<bool>() ? "on" : "off") + " |\n";
  return page;
}

}  // namespace

std::string metricsSection(const json& measured) {
  const int people = measured["people"].get<int>();
  std::string page = "`echoweave bench metrics --people " + std::to_string(people) + " --seed " +
                     std::to_string(measured["seed"].get<std::uint64_t>()) + "`, EchoWeave " + text(measured, "program") + ", kernels on " +
                     text(measured, "simd") + ": " + std::to_string(people) + " people of each level at each of " +
                     std::to_string(measured["lessons"].size()) + " lessons, " + std::to_string(measured["attempts"].get<int>()) +
                     " attempts; intervals of 95 % from " + std::to_string(measured["draws"].get<int>()) + " draws of the people.\n\n";
  page += "### Which metrics tell novices from experts\n\nArea under the curve, mean over the steps of a kind; off: below 0.7.\n\n" +
          overview(measured);
  page += "\n### By kind of step\n\n" + details(measured, "kind", "kind of step");
  page += "\n### By lesson\n\n" + details(measured, "lesson", "lesson");
  return page;
}

std::string withMetricsSection(const std::string& page, const std::string& section) {
  const std::string part = std::string(kBegin) + "\n" + section + kEnd;
  const auto begin = page.find(kBegin), end = page.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    return (page.empty() ? std::string("# Which metrics tell simulated levels apart\n\n") : page + "\n") + part + "\n";
  return page.substr(0, begin) + part + page.substr(end + std::string(kEnd).size());
}

json defaultMetrics(const json& measured) {
  const auto places = [](const json& value) { return std::round(1000.0 * value.get<double>()) / 1000.0; };
  const auto entry = [&](const json& row) {
    const json& area = row["auc"];
    return json{{"on", row["on"]}, {"auc", places(area["value"])}, {"low", places(area["low"])}, {"high", places(area["high"])}};
  };
  json metrics = json::object();
  for (const json& row : measured["rows"]) {
    const std::string id = text(row, "metric"), scope = text(row, "scope");
    if (id == "task_score" || scope == "lesson" || row["auc"].is_null()) continue;
    json& metric = metrics[id];
    if (scope == "kind") {
      metric["kinds"][text(row, "name")] = entry(row);
    } else {
      metric.update(entry(row));
      metric["version"] = row["version"];
    }
  }
  return {
      {"format", 1},
      {"note",
       "Made by 'echoweave bench metrics' from simulated people: it tells which metrics cannot even separate a model, and nothing about "
       "people. See resources/docs/science/log/metrics-study.md."},
      {"study",
       {{"people", measured["people"]},
        {"seed", measured["seed"]},
        {"draws", measured["draws"]},
        {"program", measured["program"]},
        {"lessons", measured["lessons"].size()},
        {"least_auc", kLeastArea}}},
      {"metrics", metrics}};
}

}  // namespace ew
