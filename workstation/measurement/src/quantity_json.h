#pragma once

#include <nlohmann/json.hpp>

#include "ew/measurement/quantity.h"

namespace ew::measurement {

/// Value, uncertainty where there is one, and unit, as the outputs of measurements and worksheets have them.
[[nodiscard]] inline nlohmann::ordered_json jsonOf(const Quantity& quantity) {
  nlohmann::ordered_json made = {{"value", quantity.value}};
  if (quantity.uncertainty > 0.0) made["uncertainty"] = quantity.uncertainty;
  made["unit"] = symbolOf(quantity.unit);
  return made;
}

}  // namespace ew::measurement
