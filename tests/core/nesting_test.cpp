#include "ew/core/nesting.h"

#include <gtest/gtest.h>

#include <string>

namespace ew::nesting_test {
namespace {

TEST(Nesting, CountsOpenBracesAndBracketsAtOnce) {
  EXPECT_FALSE(nestsDeeperThan(R"({"a": [[1], [2]], "b": {}})", 3));
  EXPECT_TRUE(nestsDeeperThan(R"({"a": [[1], [2]], "b": {}})", 2));
}

TEST(Nesting, LeavesBracketsInTextsAlone) {
  EXPECT_FALSE(nestsDeeperThan(R"({"a": "[[[[{{{{", "b": "quoted \" [[[["})", 1));
  EXPECT_FALSE(nestsDeeperThan(R"({"a": "ends with a backslash \\", "b": []})", 2));
}

TEST(Nesting, EndsWithBrokenTexts) {
  EXPECT_FALSE(nestsDeeperThan("", 1));
  EXPECT_FALSE(nestsDeeperThan("]]]]\"[\\", 1));
  EXPECT_TRUE(nestsDeeperThan(std::string(1000000, '[')));
}

}  // namespace
}  // namespace ew::nesting_test
