#include "ew/measurement/expression.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "ew/core/contract.h"

namespace ew::measurement {
namespace {

constexpr std::size_t kLongest = 500;
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view kDigits = "0123456789";
// What muParser offers beyond these (log by two meanings, random numbers, assignment) is no part of a formula.
constexpr std::array<std::string_view, 14> kFunctions{"ln",  "log10", "exp", "sqrt", "abs",  "min",  "max",
                                                      "sin", "cos",   "tan", "asin", "acos", "atan", "pi"};

/// The names in a text, in the order they stand; the e of 1.5e-3 is none.
std::vector<std::string> namesIn(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at < text.size();) {
    if (kDigits.find(text[at]) != std::string_view::npos || text[at] == '.') {
      while (at < text.size() && (kDigits.find(text[at]) != std::string_view::npos || text[at] == '.')) ++at;
      if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
      }
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && (text[end] == '_' || kLetters.find(text[end]) != std::string_view::npos ||
                                 (end > at && kDigits.find(text[end]) != std::string_view::npos)))
      ++end;
    if (end > at) names.emplace_back(text.substr(at, end - at));
    at = std::max(end, at + 1);
  }
  return names;
}

/// @error badField
Result<void> checkNames(const std::string& text, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs)
    if (!isName(input) || std::find(kFunctions.begin(), kFunctions.end(), input) != kFunctions.end())
      return failure(ErrorCode::badField,
                     say<"'%1' cannot be the name of an input: it needs a letter, then letters, digits and _.">(input));
  const auto used = namesIn(text);
  for (const std::string& name : used)
    if (std::find(inputs.begin(), inputs.end(), name) == inputs.end() &&
        std::find(kFunctions.begin(), kFunctions.end(), name) == kFunctions.end())
      return failure(ErrorCode::badField, say<"The expression uses '%1', which is neither an input nor a function known here.">(name));
  for (const std::string& input : inputs)
    if (std::find(used.begin(), used.end(), input) == used.end())
      return failure(ErrorCode::badField, say<"The expression does not use its input '%1'.">(input));
  return {};
}

double evaluated(const std::string& text, const std::vector<std::string>& names, std::vector<double> values) {
  mu::Parser parser;
  parser.DefineConst("pi", std::numbers::pi);
  for (std::size_t n = 0; n < names.size(); ++n) parser.DefineVar(names[n], &values[n]);
  parser.SetExpr(text);
  return parser.Eval();
}

}  // namespace

bool isName(std::string_view text) {
  if (text.empty() || kLetters.find(text.front()) == std::string_view::npos) return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return c == '_' || kLetters.find(c) != std::string_view::npos || kDigits.find(c) != std::string_view::npos;
  });
}

Result<Expression> Expression::of(const std::string& text, std::vector<std::string> inputs) {
  if (text.empty() || text.size() > kLongest)
    return failure(ErrorCode::badField, say<"An expression has 1 to %1 bytes, this one has %2.">(kLongest, text.size()));
  const std::string allowed = std::string(kLetters) + std::string(kDigits) + "_ .+-*/^(),";
  if (const auto other = text.find_first_not_of(allowed); other != std::string::npos)
    return failure(ErrorCode::badField, say<"The expression has a character at %1 that has no place in a formula.">(other + 1));
  if (auto named = checkNames(text, inputs); !named) return passOn(named.error());
  try {
    (void)evaluated(text, inputs, std::vector<double>(inputs.size(), 1.0));
  } catch (const mu::Parser::exception_type& problem) {
    return failure(ErrorCode::badField, say<"The expression cannot be read: %1">(std::string(problem.GetMsg())));
  }
  Expression made;
  made.text_ = text;
  made.inputs_ = std::move(inputs);
  return made;
}

double Expression::evaluate(std::span<const double> values) const {
  EW_EXPECTS(values.size() == inputs_.size());
  if (text_.empty()) return std::numeric_limits<double>::quiet_NaN();
  try {
    const double value = evaluated(text_, inputs_, {values.begin(), values.end()});
    return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
  } catch (const mu::Parser::exception_type&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

std::vector<double> Expression::derivatives(std::span<const double> values) const {
  constexpr double kStep = 1e-5;
  std::vector<double> found(values.size());
  std::vector<double> moved(values.begin(), values.end());
  for (std::size_t n = 0; n < values.size(); ++n) {
    const double step = kStep * (values[n] == 0.0 ? 1.0 : std::abs(values[n]));
    moved[n] = values[n] + step;
    const double above = evaluate(moved);
    moved[n] = values[n] - step;
    const double below = evaluate(moved);
    moved[n] = values[n];
    found[n] = (above - below) / (2.0 * step);
  }
  return found;
}

}  // namespace ew::measurement
