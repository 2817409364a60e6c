#pragma once

#include <string>

#include "ew/core/message.h"

namespace ew {

/// A number for people, in the C locale: at most so many significant digits and no zeros behind them ("0.4", not "0.3999999943166175"),
/// and no power of ten from 1e-4 to 1e15. textOf() of numbers.h is for files, which lose nothing.
/// @param digits 1 to 15
[[nodiscard]] std::string figureText(double value, int digits = 4);

/// With so many decimals and a point, whatever the locale. "-0.0" is "0.0"; not a number is "nan".
[[nodiscard]] std::string fixedText(double value, int decimals);
/// The same in a sentence, where the window sets its own point.
[[nodiscard]] Message fixedNumeral(double value, int decimals);
/// With so many decimals at most, and no zeros behind them.
[[nodiscard]] std::string roundedText(double value, int decimals = 0);

/// Memory that a limit is about, in whole MiB, rounded up: "512 MiB".
[[nodiscard]] std::string mebibytesText(double bytes);
/// Memory as people read it: "3.5 MiB", "512 MiB", "1.5 GiB".
struct MemoryFigure {
  double value = 0.0;
  int decimals = 0;
  bool isGibibytes = false;  ///< else MiB
};
[[nodiscard]] MemoryFigure memoryFigure(double bytes);

/// A time on a clock of minutes, seconds and tenths: "1:05.3", "-0:02.0".
[[nodiscard]] std::string minutesText(double time_s);

}  // namespace ew
