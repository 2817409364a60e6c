#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "ew/library/case.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::test {

inline Case opened(const std::filesystem::path& folder) {
  auto found = loadCase(folder);
  EXPECT_TRUE(found) << found.error();
  return found ? *found : Case{};
}

/// The small case, with a cache of its own.
class CasePipeline : public testing::Test {
 protected:
  void SetUp() override { makeSmallCase(folder / "case"); }
  TemporaryFolder folder;
  EnvironmentValue cache{"ECHOWEAVE_CACHE", folder / "cache"};
};

}  // namespace ew::test
