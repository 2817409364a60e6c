#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "ew/core/message.h"

namespace ew::measurement {

/// The units that measurements, formulas and worksheets have.
enum class Unit {
  one,
  percent,
  mm,
  cm,
  mm2,
  cm2,
  ml,
  g,
  kg,
  degree,
  s,
  ms,
  perMinute,
  mmPerS,
  cmPerS,
  cmPerS2,
  mlPerMinute,
  mmHg,
  weeks,
  days
};

/// As files and commands write it: "mm", "cm2", "ml", "deg", "/min", "mm/s", "cm/s2", "ml/min", "mmHg", "weeks", "%"; "1" of a plain ratio.
[[nodiscard]] std::string_view symbolOf(Unit unit);
/// Of a symbol, or of another spelling in use ("cm²", "cm3", "percent", "w", "d", "bpm"); empty when there is no such unit.
[[nodiscard]] std::optional<Unit> unitOf(std::string_view symbol);

/// Whether both measure the same kind of thing: mm and cm do, mm and ml do not.
[[nodiscard]] bool areComparable(Unit a, Unit b);
/// `value` of one unit in another one, which is comparable.
[[nodiscard]] double converted(double value, Unit from, Unit to);

/// A value with its standard uncertainty (one standard deviation), both in `unit`.
struct Quantity {
  double value = 0.0;
  double uncertainty = 0.0;  ///< 0: not known
  Unit unit = Unit::one;
  bool operator==(const Quantity&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Quantity& quantity);  ///< shown()

[[nodiscard]] Quantity converted(const Quantity& quantity, Unit to);

/// With as many decimals as the uncertainty deserves (two figures of it, at most four decimals), in the C locale: "82.0 ± 0.9 mm". Without
/// an uncertainty as many as the unit usually has.
[[nodiscard]] std::string shown(const Quantity& quantity);
/// The value alone, as shown() writes it.
[[nodiscard]] std::string shownValue(const Quantity& quantity);

/// A number, perhaps its uncertainty, and a unit: "82mm", "8.2 +- 0.1 cm", "200±10cm/s"; without a unit a plain ratio. Empty when it is
/// anything else.
[[nodiscard]] std::optional<Quantity> quantityOf(std::string_view text);

/// A gestational age as a clinic writes it, "32w1d", "32+1", "32w" or "32.5w"; in weeks. Empty when it is anything else or not from 0 to 45
/// weeks.
[[nodiscard]] std::optional<double> gestationOf(std::string_view text);
/// "32w1d": to the nearest day. @param weeks >= 0
[[nodiscard]] std::string gestationText(double weeks);

/// As people read it: "82.0 ± 0.9 mm", areas in "cm²", angles in "°", gestational ages (weeks, >= 0) as "32w1d ± 5 d".
[[nodiscard]] Message quantityText(const Quantity& quantity);

}  // namespace ew::measurement
