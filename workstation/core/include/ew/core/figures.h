#pragma once

#include <string>

namespace ew {

/// A number for people, in the C locale: at most so many significant digits and no zeros behind them ("0.4", not "0.3999999943166175"),
/// and no power of ten from 1e-4 to 1e15. textOf() of numbers.h is for files, which lose nothing.
/// @param digits 1 to 15
[[nodiscard]] std::string figureText(double value, int digits = 4);

}  // namespace ew
