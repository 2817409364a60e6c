#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "ew/core/message.h"

namespace ew::phantom {

/// A value, or what was expected instead ("a divisor that is not 0 at character 7").
template <class T>
using OrExpected = tl::expected<T, Message>;

/// The value of a name, or nothing when there is no such name. It may fail for reasons of its own.
using ValueByName = std::function<OrExpected<std::optional<double>>(const std::string& name)>;

/// The value of a small arithmetic expression: numbers, names, + - * / and parentheses, min(a, b, ...) and max(a, b, ...).
/// @param text at most 1000 characters, nested at most 50 deep
/// Division by zero, a result that is not finite and a name that is not known are refused.
[[nodiscard]] OrExpected<double> valueOf(std::string_view text, const ValueByName& named);

}  // namespace ew::phantom
