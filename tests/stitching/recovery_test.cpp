#include "logic/recovery.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "library/temporary_folder.h"

namespace ew::stitching::recovery_test {
namespace {

namespace fs = std::filesystem;

class RecoveryPlaceTest : public ::testing::Test {
 protected:
  static void leaveSomethingIn(const RecoveryPlace& place) { test::writeText(place.file(), "work of " + std::to_string(place.number())); }
  test::TemporaryFolder folder_;
};

TEST_F(RecoveryPlaceTest, TwoWindowsNeverHaveTheSamePlace) {
  const RecoveryPlace one(folder_.path()), two(folder_.path());
  EXPECT_NE(one.number(), two.number());
  EXPECT_NE(one.file(), two.file());
}

TEST_F(RecoveryPlaceTest, WhatALivingWindowKeepsIsNotOfferedAndWhatADeadOneLeftIs) {
  auto one = std::make_unique<RecoveryPlace>(folder_.path());
  leaveSomethingIn(*one);
  const int number = one->number();
  const RecoveryPlace two(folder_.path());
  EXPECT_TRUE(two.left().empty()) << "its window is at work";
  one.reset();
  EXPECT_EQ(two.left(), std::vector<int>{number});
}

TEST_F(RecoveryPlaceTest, ANewWindowNeverTakesAPlaceInWhichSomethingWasLeft) {
  std::vector<int> left(3);
  for (int n = 0; n < 3; ++n) {
    const RecoveryPlace place(folder_.path());
    leaveSomethingIn(place);
    // The latest is told first, however fast the windows ended.
    fs::last_write_time(place.file(), fs::file_time_type::clock::now() + std::chrono::seconds(n));
    left[static_cast<std::size_t>(2 - n)] = place.number();
  }
  const RecoveryPlace place(folder_.path());
  EXPECT_EQ(place.left(), left) << "several generations, the latest first";
  EXPECT_FALSE(fs::exists(place.file()));
  place.forget(left[1]);
  EXPECT_EQ(place.left(), (std::vector<int>{left[0], left[2]}));
}

TEST_F(RecoveryPlaceTest, OtherFilesAreNoWorkThatWasLeft) {
  for (const char* name : {"unsaved-.json", "unsaved-x.json", "unsaved-0.json", "unsaved--3.json", "unsaved-3.json.bak", "notes.json"})
    test::writeText(folder_ / name, "{}");
  const RecoveryPlace place(folder_.path());
  EXPECT_TRUE(place.left().empty());
}

TEST_F(RecoveryPlaceTest, AFolderThatCannotBeMadeIsAPlaceAllTheSame) {
  test::writeText(folder_ / "file", "no folder");
  const RecoveryPlace place(folder_ / "file");
  EXPECT_GE(place.number(), 1);
  EXPECT_TRUE(place.left().empty());
}

}  // namespace
}  // namespace ew::stitching::recovery_test
