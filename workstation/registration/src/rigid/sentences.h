#pragma once

#include <string>

#include "refine.h"

namespace ew::registration {

[[nodiscard]] std::string millimetres(double mm);  ///< "1.3 mm"
[[nodiscard]] std::string percent(double share);   ///< "12 %"
[[nodiscard]] std::string withDigits(double value, int digits);
/// "correlation 0.82 over 12 % overlap, 33 deviations above chance"
[[nodiscard]] std::string agreementFigures(const Evidence& evidence);
/// What a good agreement (correlation 0.7) over as many samples would reach.
[[nodiscard]] double mostSignificance(const Evidence& evidence);

[[nodiscard]] std::string onlyStreaks(const WithoutStreaks& fare, double sure);  ///< the reason not to tell
/// "Shadows and other streaks were taken out, which drew the volumes 9 mm and 13 degrees elsewhere. "
[[nodiscard]] std::string withoutStreaks(const PoseDifference& moved);

}  // namespace ew::registration
