#include "run/report.h"

#include <algorithm>
#include <cmath>

#include "ew/core/elapsed.h"
#include "ew/core/memory_watch.h"
#include "ew/core/simd.h"
#include "ew/core/version.h"

namespace ew::cli {

StepSummary summarise(std::vector<double> durations_us) {
  StepSummary summary;
  summary.count = durations_us.size();
  if (durations_us.empty()) return summary;
  std::sort(durations_us.begin(), durations_us.end());
  const std::size_t n = durations_us.size();
  summary.median_us = n % 2 == 1 ? durations_us[n / 2] : 0.5 * (durations_us[n / 2 - 1] + durations_us[n / 2]);
  const auto rank = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(n)));
  summary.p99_us = durations_us[std::min(rank, n) - 1];
  summary.max_us = durations_us.back();
  return summary;
}

nlohmann::ordered_json stepRow(const std::string& name, std::vector<double> durations_us) {
  const StepSummary summary = summarise(std::move(durations_us));
  return {
      {"name", name}, {"count", summary.count}, {"median_us", summary.median_us}, {"p99_us", summary.p99_us}, {"max_us", summary.max_us}};
}

void Report::addStep(const std::string& name, double duration_us) {
  auto found = std::find_if(steps_.begin(), steps_.end(), [&](const auto& step) { return step.first == name; });
  if (found == steps_.end()) found = steps_.insert(steps_.end(), {name, {}});
  found->second.push_back(duration_us);
}

double Report::median_us(const std::string& name) const {
  for (const auto& [stepName, durations_us] : steps_)
    if (stepName == name) return summarise(durations_us).median_us;
  return 0.0;
}

nlohmann::ordered_json Report::toJson() const {
  nlohmann::ordered_json json;
  json["command"] = command;
  json["version"] = kVersion;
  json["simd"] = simdInUse();
  json["inputs"] = inputs;
  json["outputs"] = outputs;
  json["options"] = options;
  json["seconds"] = secondsSince(start_);
  auto steps = nlohmann::ordered_json(summarisedSteps);
  for (const auto& [name, durations_us] : steps_) steps.push_back(stepRow(name, durations_us));
  json["steps"] = std::move(steps);
  json["quality"] = quality;
  json["memory_mib"] = peakMemory_mib();
  if (verdict) json["verdict"] = *verdict;
  if (seed) json["seed"] = *seed;
  for (const auto& [key, value] : details.items()) json[key] = value;
  return json;
}

StepClock::~StepClock() {
  report_.addStep(name_, std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start_).count());
}

}  // namespace ew::cli
