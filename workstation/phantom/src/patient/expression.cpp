#include "patient/expression.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ew::phantom {
namespace {

constexpr std::size_t kLongest = 1000;
constexpr int kDeepest = 50;

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Recursive descent: sum, product, sign, atom. After a problem every rule returns 0 and nothing is read any more.
class Parser {
 public:
  Parser(std::string_view text, const ValueByName& named) : text_(text), named_(named) {}

  OrExpected<double> whole() {
    const double value = sum(0);
    if (!problem_ && peek() != '\0') refuse(say<"an operator in place of \"%1\"">(std::string(1, peek())));
    if (!problem_ && !std::isfinite(value)) refuse(say<"a result that is finite">());
    if (problem_) return tl::unexpected(*problem_);
    return value;
  }

 private:
  void refuse(const Message& expected) {
    if (!problem_) problem_ = say<"%1 at character %2 of the expression">(expected, at_ + 1);
  }
  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() && !problem_ ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  double sum(int depth) {
    if (depth > kDeepest) refuse(say<"at most %1 nested parentheses">(kDeepest));
    double value = product(depth);
    while (!problem_) {
      if (take('+'))
        value += product(depth);
      else if (take('-'))
        value -= product(depth);
      else
        break;
    }
    return value;
  }
  double product(int depth) {
    double value = signedAtom(depth);
    while (!problem_) {
      if (take('*')) {
        value *= signedAtom(depth);
      } else if (take('/')) {
        const double divisor = signedAtom(depth);
        if (divisor == 0.0) refuse(say<"a divisor that is not 0">());
        value = problem_ ? 0.0 : value / divisor;
      } else {
        break;
      }
    }
    return value;
  }
  double signedAtom(int depth) {
    bool negative = false;
    while (take('-')) negative = !negative;
    const double value = atom(depth);
    return negative ? -value : value;
  }
  double atom(int depth) {
    if (take('(')) {
      const double value = sum(depth + 1);
      if (!take(')')) refuse(say<"a closing parenthesis">());
      return value;
    }
    const char first = peek();
    if (isDigit(first) || first == '.') return number();
    if (isLetter(first)) return nameOrCall(depth);
    refuse(say<"a number, a name or an opening parenthesis">());
    return 0.0;
  }
  double number() {
    double value = 0.0;
    const auto [end, failed] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (failed != std::errc()) refuse(say<"a number">());
    at_ = static_cast<std::size_t>(end - text_.data());
    return problem_ ? 0.0 : value;
  }
  double nameOrCall(int depth) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
    const std::string name(text_.substr(begin, at_ - begin));
    if (peek() == '(' && (name == "min" || name == "max")) return extreme(name == "min", depth);
    auto found = named_(name);
    if (!found) {
      if (!problem_) problem_ = found.error();
      return 0.0;
    }
    if (!*found) {
      at_ = begin;
      refuse(say<"the name of a parameter in place of \"%1\"">(name));
      return 0.0;
    }
    return **found;
  }
  double extreme(bool smallest, int depth) {
    take('(');
    double value = sum(depth + 1);
    while (!problem_ && take(',')) {
      const double next = sum(depth + 1);
      value = smallest ? std::min(value, next) : std::max(value, next);
    }
    if (!take(')')) refuse(say<"a comma or a closing parenthesis">());
    return value;
  }

  std::string_view text_;
  const ValueByName& named_;
  std::size_t at_ = 0;
  std::optional<Message> problem_;
};

}  // namespace

OrExpected<double> valueOf(std::string_view text, const ValueByName& named) {
  if (text.size() > kLongest) return tl::unexpected(say<"an expression of at most %1 characters">(kLongest));
  return Parser(text, named).whole();
}

}  // namespace ew::phantom
