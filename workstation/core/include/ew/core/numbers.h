#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ew {

/// A number in the C locale whatever the user's locale is, with `1e-05` and `8.4e-005` alike; empty when `text` is anything else.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

/// Numbers separated by any white space; empty when one piece is not a number or there is none.
[[nodiscard]] std::optional<std::vector<double>> parseNumbers(std::string_view text);

/// Whole numbers that fit 64 bits, separated by any white space; empty when one piece is anything else or there is none.
[[nodiscard]] std::optional<std::vector<long long>> parseIntegers(std::string_view text);

/// The shortest text that parses back to the same double, in the C locale.
[[nodiscard]] std::string textOf(double value);

/// The decimal number that a float was written for, as a double: 0.0005 of the float beside it, not 0.0005000000237487257. Read back as a
/// float it is the same.
[[nodiscard]] double decimalOf(float value);

/// The number that times `factor` gives exactly `product`, if there is one close by, else the quotient: an angle that was read in degrees
/// is written as the degrees that give it again.
[[nodiscard]] double factorGiving(double product, double factor);

}  // namespace ew
