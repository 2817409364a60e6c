#include "ew/core/simd.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace ew::simd_test {
namespace {

class Simd : public ::testing::Test {
 protected:
  void TearDown() override { EXPECT_TRUE(useSimd("best")); }
};

TEST_F(Simd, IsTheBestOfTheProcessorUnlessAskedFor) {
  ASSERT_TRUE(useSimd(""));
  EXPECT_EQ(simdInUse(), bestSimd());
  ASSERT_TRUE(useSimd("scalar"));
  EXPECT_EQ(simdInUse(), "scalar");
  EXPECT_NE(bestSimd(), "");
  ASSERT_TRUE(useSimd("best"));
  EXPECT_EQ(simdInUse(), bestSimd());
}

TEST_F(Simd, IsRefusedWhereTheProcessorLacksItAndKeepsTheOneBefore) {
  ASSERT_TRUE(useSimd("scalar"));
  const auto unknown = useSimd("mmx");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::badUsage);
  EXPECT_NE(unknown.error().sentence().find("'mmx'"), std::string::npos);
  EXPECT_NE(unknown.error().sentence().find("scalar"), std::string::npos);
  EXPECT_EQ(simdInUse(), "scalar");
  for (const char* word : {"avx3", "avx2", "sse4"}) {
    const auto chosen = useSimd(word);
    if (chosen) {
      EXPECT_EQ(simdInUse(), word);
    } else {
      EXPECT_NE(chosen.error().sentence().find(word), std::string::npos);
    }
  }
}

TEST_F(Simd, MayBeAskedForByTheEnvironment) {
  ASSERT_EQ(setenv("ECHOWEAVE_SIMD", "scalar", 1), 0);
  EXPECT_EQ(simdOfEnvironment(), "scalar");
  ASSERT_EQ(unsetenv("ECHOWEAVE_SIMD"), 0);
  EXPECT_EQ(simdOfEnvironment(), "");
}

}  // namespace
}  // namespace ew::simd_test
