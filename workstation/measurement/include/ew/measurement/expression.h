#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/result.h"

namespace ew::measurement {

/// Whether a text can name an input of an expression or an entry of a package: an ASCII letter, then letters, digits and _.
[[nodiscard]] bool isName(std::string_view text);

/// A formula's right side as text, evaluated by muParser (libmuparser, BSD-2): + - * / ^, parentheses, numbers, names of inputs, the
/// constant `pi`, and ln, log10, exp, sqrt, abs, min, max, sin, cos, tan, asin, acos, atan. Checked when it is made; a value that can be
/// copied.
class Expression {
 public:
  Expression() = default;  ///< nothing; evaluates to not a number

  /// @param text   1 to 500 bytes
  /// @param inputs names it may use, each at least once: a letter, then letters, digits and _
  /// @error badField; its sentence says what is wrong with the text, for whoever names the field
  [[nodiscard]] static Result<Expression> of(const std::string& text, std::vector<std::string> inputs);

  /// In double precision, whatever the locale. @param values one for each input, in their order
  /// Not a number when the text cannot be computed for them (a logarithm of a negative number). Cost: the text is read anew each
  /// time, so that several threads may ask; for worksheets, not for frames.
  [[nodiscard]] double evaluate(std::span<const double> values) const;

  /// Derivative by each input, by central differences with a step of 1e-5 of the input (of 1e-5 at 0): about 1e-9 relative for the smooth
  /// formulas of clinics.
  [[nodiscard]] std::vector<double> derivatives(std::span<const double> values) const;

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::vector<std::string>& inputs() const { return inputs_; }
  bool operator==(const Expression&) const = default;

 private:
  std::string text_;
  std::vector<std::string> inputs_;
};

}  // namespace ew::measurement
