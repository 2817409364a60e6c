#pragma once

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ew::cli {

/// Durations of one step that ran once or often.
struct StepSummary {
  std::size_t count = 0;
  double median_us = 0.0;
  double p99_us = 0.0;  ///< nearest rank
  double max_us = 0.0;
};
[[nodiscard]] StepSummary summarise(std::vector<double> durations_us);

/// A row of "steps": {"name", "count", "median_us", "p99_us", "max_us"}.
[[nodiscard]] nlohmann::ordered_json stepRow(const std::string& name, std::vector<double> durations_us);

/// What `--report` writes: the contract of the command line.
class Report {
 public:
  std::string command;
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  nlohmann::json options = nlohmann::json::object();
  nlohmann::json quality = nlohmann::json::object();  ///< figures by name, unit in the name
  std::optional<std::string> verdict;
  std::optional<std::uint64_t> seed;
  nlohmann::json details = nlohmann::json::object();  ///< further keys of one command

  nlohmann::json summarisedSteps = nlohmann::json::array();  ///< steps a command measured and summarised itself

  void addStep(const std::string& name, double duration_us);
  /// Median duration of a step so far; 0 when it never ran.
  [[nodiscard]] double median_us(const std::string& name) const;
  /// In the order of the contract, then what one command adds.
  [[nodiscard]] nlohmann::ordered_json toJson() const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<std::pair<std::string, std::vector<double>>> steps_;  // in the order they first ran
};

/// Times a block: `{ const StepClock clock(report, "read"); … }`.
class StepClock {
 public:
  StepClock(Report& report, std::string name) : report_(report), name_(std::move(name)) {}
  ~StepClock();
  StepClock(const StepClock&) = delete;
  StepClock& operator=(const StepClock&) = delete;

 private:
  Report& report_;
  std::string name_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ew::cli
