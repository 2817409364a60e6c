#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ew/assessment/statistics.h"
#include "ew/core/result.h"

namespace ew {

/// Which metrics are shown without being asked for: those that told simulated novices from experts in the study of
/// resources/docs/science/log/metrics-study.md, by kind of step. The others are off until an instructor turns them on. It is no evidence
/// about people: it says which figures cannot even tell a model's levels apart.
class MetricDefaults {
 public:
  /// resources/assessment/default-metrics.json. @error notFound, notReadable, badHeader, badField, newerFormat
  [[nodiscard]] static Result<MetricDefaults> read(const std::filesystem::path& resources);

  /// False, too, for a metric of another version than the one that was studied, and for one that was not.
  /// @param stepKind taskWord; empty: in any kind of step
  [[nodiscard]] bool isOn(std::string_view metric, std::string_view stepKind = {}) const;
  /// The area under the curve of novices and experts, with its interval. Empty: it was not studied.
  [[nodiscard]] std::optional<Estimate> areaOf(std::string_view metric, std::string_view stepKind = {}) const;

 private:
  struct Entry {
    bool isOn = false;
    Estimate area;
  };
  [[nodiscard]] const Entry* of(std::string_view metric, std::string_view stepKind) const;
  std::map<std::pair<std::string, std::string>, Entry> entries_;  ///< by metric and kind of step; "" for all kinds
};

}  // namespace ew
