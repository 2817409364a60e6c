#pragma once

#include <string>

namespace ew {

/// A number with its name and unit, as something was measured or judged by: "angle", 4.2, "deg".
struct Figure {
  std::string name;  ///< "length", "circumference", "angle", "coverage" ...
  double value = 0.0;
  std::string unit;          ///< "mm", "cm2", "deg", "s", "%", or empty for a ratio
  double uncertainty = 0.0;  ///< standard deviation, in `unit`; 0: not known. Attempts keep none
  bool operator==(const Figure&) const = default;
};

}  // namespace ew
