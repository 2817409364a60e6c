#include "ew/measurement/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "ew/core/contract.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"

namespace ew::measurement {
namespace {

enum class Dimension { ratio, length, area, volume, mass, angle, time, rate, speed, acceleration, flow, pressure };

struct UnitInfo {
  Unit unit;
  std::string_view symbol;
  Dimension dimension;
  double inBase;  // of the first unit of the dimension
  int usualDecimals;
};

constexpr double kDay_s = 86400.0;

constexpr std::array kUnits{UnitInfo{Unit::one, "1", Dimension::ratio, 1.0, 3},
                            UnitInfo{Unit::percent, "%", Dimension::ratio, 0.01, 1},
                            UnitInfo{Unit::mm, "mm", Dimension::length, 1.0, 1},
                            UnitInfo{Unit::cm, "cm", Dimension::length, 10.0, 2},
                            UnitInfo{Unit::mm2, "mm2", Dimension::area, 1.0, 0},
                            UnitInfo{Unit::cm2, "cm2", Dimension::area, 100.0, 2},
                            UnitInfo{Unit::ml, "ml", Dimension::volume, 1.0, 1},
                            UnitInfo{Unit::g, "g", Dimension::mass, 1.0, 0},
                            UnitInfo{Unit::kg, "kg", Dimension::mass, 1000.0, 3},
                            UnitInfo{Unit::degree, "deg", Dimension::angle, 1.0, 1},
                            UnitInfo{Unit::s, "s", Dimension::time, 1.0, 3},
                            UnitInfo{Unit::ms, "ms", Dimension::time, 0.001, 0},
                            UnitInfo{Unit::perMinute, "/min", Dimension::rate, 1.0, 0},
                            UnitInfo{Unit::mmPerS, "mm/s", Dimension::speed, 1.0, 1},
                            UnitInfo{Unit::cmPerS, "cm/s", Dimension::speed, 10.0, 1},
                            UnitInfo{Unit::cmPerS2, "cm/s2", Dimension::acceleration, 1.0, 0},
                            UnitInfo{Unit::mlPerMinute, "ml/min", Dimension::flow, 1.0, 0},
                            UnitInfo{Unit::mmHg, "mmHg", Dimension::pressure, 1.0, 1},
                            UnitInfo{Unit::weeks, "weeks", Dimension::time, 7.0 * kDay_s, 2},
                            UnitInfo{Unit::days, "days", Dimension::time, kDay_s, 1}};

constexpr std::array<std::pair<std::string_view, Unit>, 13> kOtherSpellings{{{"", Unit::one},
                                                                             {"percent", Unit::percent},
                                                                             {"mm²", Unit::mm2},
                                                                             {"cm²", Unit::cm2},
                                                                             {"cm3", Unit::ml},
                                                                             {"cm³", Unit::ml},
                                                                             {"°", Unit::degree},
                                                                             {"bpm", Unit::perMinute},
                                                                             {"cm/s²", Unit::cmPerS2},
                                                                             {"w", Unit::weeks},
                                                                             {"wk", Unit::weeks},
                                                                             {"d", Unit::days},
                                                                             {"day", Unit::days}}};

const UnitInfo& infoOf(Unit unit) {
  const auto found = std::find_if(kUnits.begin(), kUnits.end(), [&](const UnitInfo& info) { return info.unit == unit; });
  EW_EXPECTS(found != kUnits.end());
  return *found;
}

int decimalsOf(const Quantity& quantity) {
  if (!(quantity.uncertainty > 0.0) || !std::isfinite(quantity.uncertainty)) return infoOf(quantity.unit).usualDecimals;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(quantity.uncertainty))), 0, 4);
}

}  // namespace

std::string_view symbolOf(Unit unit) { return infoOf(unit).symbol; }

std::optional<Unit> unitOf(std::string_view symbol) {
  for (const UnitInfo& info : kUnits)
    if (info.symbol == symbol) return info.unit;
  for (const auto& [spelling, unit] : kOtherSpellings)
    if (spelling == symbol) return unit;
  return std::nullopt;
}

bool areComparable(Unit a, Unit b) { return infoOf(a).dimension == infoOf(b).dimension; }

double converted(double value, Unit from, Unit to) {
  EW_EXPECTS(areComparable(from, to));
  if (from == to) return value;
  const double a = infoOf(from).inBase, b = infoOf(to).inBase;
  // By a whole factor, one way or the other, so that 82 mm are 8.2 cm and not nearly so.
  return a >= b ? value * (a / b) : value / (b / a);
}

Quantity converted(const Quantity& quantity, Unit to) {
  return {converted(quantity.value, quantity.unit, to), converted(quantity.uncertainty, quantity.unit, to), to};
}

std::string shownValue(const Quantity& quantity) { return fixedText(quantity.value, decimalsOf(quantity)); }

std::string shown(const Quantity& quantity) {
  std::string text = shownValue(quantity);
  if (quantity.uncertainty > 0.0) text += " ± " + fixedText(quantity.uncertainty, decimalsOf(quantity));
  return quantity.unit == Unit::one ? text : text + " " + std::string(symbolOf(quantity.unit));
}

std::ostream& operator<<(std::ostream& out, const Quantity& quantity) { return out << shown(quantity); }

std::optional<Quantity> quantityOf(std::string_view text) {
  // Digits and signs are ASCII, so the number ends where none follows.
  const auto takeNumber = [&text]() -> std::optional<double> {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    std::size_t end = std::min(text.find_first_not_of("0123456789.+-eE"), text.size());
    end = std::min(end, text.find("+-"));
    while (end > 0) {  // the e of a unit is none of a number
      if (const auto value = parseNumber(text.substr(0, end))) {
        text.remove_prefix(end);
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        return value;
      }
      --end;
    }
    return std::nullopt;
  };
  Quantity quantity;
  const auto value = takeNumber();
  if (!value) return std::nullopt;
  quantity.value = *value;
  for (const std::string_view sign : {"+-", "±"})
    if (text.starts_with(sign)) {
      text.remove_prefix(sign.size());
      const auto uncertainty = takeNumber();
      if (!uncertainty || !(*uncertainty >= 0.0)) return std::nullopt;
      quantity.uncertainty = *uncertainty;
      break;
    }
  while (text.ends_with(' ')) text.remove_suffix(1);
  const auto unit = unitOf(text);
  if (!unit) return std::nullopt;
  quantity.unit = *unit;
  return quantity;
}

std::optional<double> gestationOf(std::string_view text) {
  constexpr double kLongest_weeks = 45.0;
  if (const auto plus = text.find('+'); plus != std::string_view::npos) {  // "32+1", as in most of Europe
    const auto weeks = parseIntegers(text.substr(0, plus)), days = parseIntegers(text.substr(plus + 1));
    if (text.find_first_of("+-", plus + 1) != std::string_view::npos || !weeks || !days || weeks->size() != 1 || days->size() != 1)
      return {};
    if (weeks->front() < 0 || days->front() < 0 || days->front() > 6) return std::nullopt;
    const double total = static_cast<double>(weeks->front()) + static_cast<double>(days->front()) / 7.0;
    return total <= kLongest_weeks ? std::optional(total) : std::nullopt;
  }
  const auto w = text.find('w');
  if (w == std::string_view::npos) return std::nullopt;
  const auto weeks = parseNumber(text.substr(0, w));
  if (!weeks || !(*weeks >= 0.0) || text.find_first_of(" \t") != std::string_view::npos) return std::nullopt;
  double total = *weeks;
  if (std::string_view rest = text.substr(w + 1); !rest.empty()) {
    if (!rest.ends_with('d') || *weeks != std::floor(*weeks)) return std::nullopt;
    const auto days = parseIntegers(rest.substr(0, rest.size() - 1));
    if (!days || days->size() != 1 || days->front() < 0 || days->front() > 6) return std::nullopt;
    total += static_cast<double>(days->front()) / 7.0;
  }
  return total <= kLongest_weeks ? std::optional(total) : std::nullopt;
}

std::string gestationText(double weeks) {
  EW_EXPECTS(weeks >= 0.0);
  const long long days = std::llround(weeks * 7.0);
  return std::to_string(days / 7) + "w" + std::to_string(days % 7) + "d";
}

Message quantityText(const Quantity& quantity) {
  if (quantity.unit == Unit::weeks) {
    Message age = verbatim(gestationText(quantity.value));
    if (!(quantity.uncertainty > 0.0)) return age;
    const double days = converted(quantity.uncertainty, Unit::weeks, Unit::days);
    // Nothing is known to 0 days.
    return say<"%1 ± %2 d">(std::move(age), numeral(days < 0.95 ? fixedText(std::max(days, 0.1), 1) : fixedText(days, 0)));
  }
  std::string text = shown(quantity.unit == Unit::mm2 ? converted(quantity, Unit::cm2) : quantity);
  if (text.ends_with("cm2") || text.ends_with("cm/s2")) text.replace(text.size() - 1, 1, "²");
  if (text.ends_with(" deg")) text.replace(text.size() - 4, 4, "°");
  return numeral(std::move(text));
}

}  // namespace ew::measurement
