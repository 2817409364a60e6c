#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/numbers.h"
#include "ew/measurement/quantity.h"

namespace ew::measurement {

[[nodiscard]] inline Message inUnit(const Message& number, Unit unit) {
  return unit == Unit::one ? number : say<"%1 %2">(number, std::string(symbolOf(unit)));
}
[[nodiscard]] inline Message inUnit(double value, Unit unit) { return inUnit(numeral(textOf(value)), unit); }

/// The words of a choice, as sentences list them.
[[nodiscard]] inline std::string choiceList(const std::vector<std::pair<std::string, Words>>& choices) {
  std::string all;
  for (const auto& [word, title] : choices) all += (all.empty() ? "" : ", ") + word;
  return all;
}

}  // namespace ew::measurement
