#include "ew/core/find_entry.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ew {
namespace {

struct Step {
  std::string name;
  int number = 0;
};

TEST(FindEntry, GivesTheFirstEntryThatHasTheValue) {
  const std::vector<Step> steps = {{"read", 1}, {"watch", 2}, {"read", 2}};
  EXPECT_EQ(entryWith(steps, &Step::number, 2), &steps[1]);
  EXPECT_EQ(entryNamed(steps, "read"), &steps[0]);
  EXPECT_EQ(entryWith(steps, &Step::number, 3), nullptr);
  EXPECT_EQ(entryNamed(steps, "Read"), nullptr);
  EXPECT_EQ(entryNamed(std::as_const(steps), ""), nullptr);
}

TEST(FindEntry, LeavesWhatMayBeChangedSo) {
  std::vector<Step> steps = {{"read", 1}};
  static_assert(std::is_same_v<decltype(entryNamed(steps, "")), Step*>);
  entryNamed(steps, "read")->number = 7;
  EXPECT_EQ(steps[0].number, 7);
  steps.clear();
  EXPECT_EQ(entryNamed(steps, "read"), nullptr);
}

}  // namespace
}  // namespace ew
