#include "flow/echo_powers.h"

#include <algorithm>

namespace ew::detail {

const std::array<float, 256>& tissuePowers() {
  static const std::array<float, 256> powers = [] {
    const auto at = [](double level) { return powerOf((level / 255.0 - 1.0) * kMapRange_db); };
    std::array<float, 256> found{};
    for (std::size_t level = 0; level < found.size(); ++level)
      found[level] = static_cast<float>(std::max(0.0, at(static_cast<double>(level)) - at(kFluidLevel)));
    return found;
  }();
  return powers;
}

}  // namespace ew::detail
