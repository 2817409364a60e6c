#include "ew/measurement/expression.h"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cmath>

namespace ew::measurement::expression_test {
namespace {

std::string sentence(const std::string& text, std::vector<std::string> inputs) {
  const auto made = Expression::of(text, std::move(inputs));
  return made ? "fine" : made.error().sentence();
}

TEST(Expression, EvaluatesInDoublePrecision) {
  const auto made = Expression::of("10^(1.5 + a) * ln(b) / sqrt(2) + pi", {"a", "b"});
  ASSERT_TRUE(made) << made.error();
  EXPECT_DOUBLE_EQ(made->evaluate(std::array{0.25, 3.0}), std::pow(10.0, 1.75) * std::log(3.0) / std::sqrt(2.0) + 3.141592653589793);
  EXPECT_DOUBLE_EQ(Expression::of("2^3^2 - -x", {"x"})->evaluate(std::array{1.0}), 513.0);
  EXPECT_DOUBLE_EQ(Expression::of("1.5e-3*x", {"x"})->evaluate(std::array{2.0}), 0.003);
}

TEST(Expression, IsNotANumberWhereItCannotBeComputed) {
  EXPECT_TRUE(std::isnan(Expression::of("ln(x)", {"x"})->evaluate(std::array{-1.0})));
  EXPECT_TRUE(std::isnan(Expression::of("1/x", {"x"})->evaluate(std::array{0.0})));
}

TEST(Expression, HasTheDerivativesOfItsFormula) {
  const auto made = Expression::of("a^3*exp(b)", {"a", "b"});
  ASSERT_TRUE(made);
  const auto slopes = made->derivatives(std::array{2.0, 0.5});
  EXPECT_NEAR(slopes[0], 12.0 * std::exp(0.5), 1e-7);
  EXPECT_NEAR(slopes[1], 8.0 * std::exp(0.5), 1e-7);
}

TEST(Expression, SaysWhatIsWrongWithIt) {
  EXPECT_EQ(sentence("a + q", {"a"}), "The expression uses 'q', which is neither an input nor a function known here.");
  EXPECT_EQ(sentence("a", {"a", "b"}), "The expression does not use its input 'b'.");
  EXPECT_EQ(sentence("a = 3", {"a"}), "The expression has a character at 3 that has no place in a formula.");
  EXPECT_EQ(sentence("", {}), "An expression has 1 to 500 bytes, this one has 0.");
  EXPECT_EQ(sentence("rnd() + a", {"a"}), "The expression uses 'rnd', which is neither an input nor a function known here.");
  EXPECT_EQ(sentence("exp(1)", {"exp"}), "'exp' cannot be the name of an input: it needs a letter, then letters, digits and _.");
  EXPECT_TRUE(sentence("a + (3", {"a"}).starts_with("The expression cannot be read: ")) << sentence("a + (3", {"a"});
  EXPECT_TRUE(sentence("a a", {"a"}).starts_with("The expression cannot be read: "));
}

TEST(Expression, DoesNotFollowTheUsersLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr && std::setlocale(LC_ALL, "C.UTF-8") == nullptr)
    GTEST_SKIP() << "for want of a locale";
  EXPECT_DOUBLE_EQ(Expression::of("1.5*x", {"x"})->evaluate(std::array{2.0}), 3.0);
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace ew::measurement::expression_test
