#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/measurement/expression.h"
#include "ew/measurement/package.h"

namespace ew::measurement {

// What packages and criteria read alike.

inline constexpr double kFarthest = 1e9;  ///< of any number of a file, either way
inline constexpr std::size_t kLongestText = 600;

[[nodiscard]] inline std::string labelIn(const JsonFields& fields, std::string_view key) {
  std::string label = fields.text(key);
  if (!isName(label)) fields.refuse(key, say<"a letter, then letters, digits and _">());
  return label;
}

[[nodiscard]] inline Unit unitIn(const JsonFields& fields, std::string_view key) {
  const auto unit = unitOf(fields.text(key));
  if (!unit)
    fields.refuse(key,
                  say<"a unit: 1, %, mm, cm, mm2, cm2, ml, g, kg, deg, s, ms, /min, mm/s, cm/s, cm/s2, ml/min, mmHg, weeks or days">());
  return unit.value_or(Unit::one);
}

[[nodiscard]] inline Limits limitsIn(const JsonFields& fields, std::string_view key) {
  const Message expected = say<"two rising numbers, the smallest and the largest value">();
  const auto both = fields.numbers(key, 2, 2, -kFarthest, kFarthest, true, expected);
  if (both.size() != 2) return {};
  if (!(both[0] < both[1])) fields.refuse(key, expected);
  return {both[0], both[1]};
}

/// Tests of an expression: a result that it does not give is refused.
inline void readTestVectors(const JsonFields& fields, const Expression& expression, std::vector<TestVector>& tests) {
  for (const JsonFields& each : fields.objects("tests", 1, 200)) {
    each.only({"inputs", "result", "digits"});
    const JsonFields inputs = each.object("inputs");
    TestVector test;
    for (const std::string& name : expression.inputs()) test.inputs.push_back(inputs.number(name, -kFarthest, kFarthest));
    inputs.only(expression.inputs());
    test.result = each.number("result", -kFarthest, kFarthest);
    test.digits = static_cast<int>(each.whole("digits", 0, 9));
    if (!each.good()) return;
    const double found = expression.evaluate(test.inputs);
    // A hair more than half of the last digit: the printed number may have been rounded from a number just beside the middle.
    if (!(std::abs(found - test.result) <= 0.5000001 * std::pow(10.0, -test.digits)))
      each.refuse("result", say<"%1, which the expression gives; correct the one that is wrong">(textOf(found)));
    tests.push_back(std::move(test));
  }
}

}  // namespace ew::measurement
