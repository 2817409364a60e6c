#include "ew/assessment/metric_defaults.h"

#include "ew/assessment/metric.h"
#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"

namespace ew {
namespace {

constexpr int kMetricDefaultsFormat = 1;
constexpr std::size_t kLargestDefaults_bytes = 4u << 20;

}  // namespace

Result<MetricDefaults> MetricDefaults::read(const std::filesystem::path& resources) {
  const auto file = resources / "assessment" / "default-metrics.json";
  const Message where = verbatim(file.filename().string());
  const auto document = readJsonFile(file, where, kLargestDefaults_bytes);
  if (!document) return passOn(document.error());
  JsonReading reading(where, {"study"});
  const JsonFields fields(*document, reading);
  requireFormat(fields, kMetricDefaultsFormat);
  MetricDefaults defaults;
  const auto entryOf = [](const JsonFields& from) {
    return Entry{from.flag("on", false), {from.number("auc", 0.0, 1.0), from.number("low", 0.0, 1.0), from.number("high", 0.0, 1.0)}};
  };
  const JsonFields studied = fields.object("metrics");
  for (const auto& [id, value] : studied.value().items()) {
    const JsonFields each = studied.object(id);
    const Metric* metric = metricOf(id);
    const auto version = each.whole("version", 1, 1'000'000, 1);
    const Entry whole = entryOf(each);
    if (metric == nullptr || metric->version != version) continue;  // studied as it was, not as it is
    defaults.entries_[{id, ""}] = whole;
    const JsonFields kinds = each.object("kinds");
    for (const auto& [kind, ignored] : kinds.value().items()) defaults.entries_[{id, kind}] = entryOf(kinds.object(kind));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return defaults;
}

const MetricDefaults::Entry* MetricDefaults::of(std::string_view metric, std::string_view stepKind) const {
  const auto found = entries_.find({std::string(metric), std::string(stepKind)});
  return found == entries_.end() ? nullptr : &found->second;
}

bool MetricDefaults::isOn(std::string_view metric, std::string_view stepKind) const {
  const Entry* entry = of(metric, stepKind);
  return entry != nullptr && entry->isOn;
}

std::optional<Estimate> MetricDefaults::areaOf(std::string_view metric, std::string_view stepKind) const {
  const Entry* entry = of(metric, stepKind);
  return entry == nullptr ? std::nullopt : std::optional(entry->area);
}

}  // namespace ew
