#include "ew/core/guarded.h"

#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <stdexcept>

namespace ew::guarded_test {
namespace {

Error named(const Thrown& thrown) { return {thrown.noMemory ? ErrorCode::tooLarge : ErrorCode::internal, thrown.reason, {}}; }

struct Silent final : std::exception {
  const char* what() const noexcept override { return nullptr; }
};

TEST(Guarded, WhatIsReturnedComesThroughAndAResultStaysOne) {
  EXPECT_EQ(guarded([] { return 7; }, named), Result<int>(7));
  EXPECT_EQ(guarded([]() -> Result<int> { return 7; }, named), Result<int>(7));
  const auto refused = guarded([]() -> Result<int> { return failure(ErrorCode::notFound, verbatim("Not here.")); }, named);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::notFound);
  bool called = false;
  EXPECT_TRUE(guarded([&] { called = true; }, named));
  EXPECT_TRUE(called);
  const auto moved = guarded([] { return std::make_unique<int>(3); }, named);
  ASSERT_TRUE(moved);
  EXPECT_EQ(**moved, 3);
}

TEST(Guarded, WhateverIsThrownBecomesAnErrorWithItsReason) {
  const auto reasonOf = [](auto work) { return guarded(work, named).error(); };
  EXPECT_EQ(reasonOf([] { throw std::runtime_error("out of cheese"); }).sentence(), "out of cheese");
  EXPECT_EQ(reasonOf([] { throw 42; }).sentence(), "no reason was given");
  EXPECT_EQ(reasonOf([] { throw Silent(); }).sentence(), "no reason was given");
  EXPECT_EQ(reasonOf([] { throw std::runtime_error(""); }).sentence(), "no reason was given");
  EXPECT_EQ(reasonOf([] { throw 42; }).code, ErrorCode::internal);
  EXPECT_EQ(reasonOf([] { throw std::bad_alloc(); }).code, ErrorCode::tooLarge);
}

TEST(Guarded, AReasonIsOneLineAndNotALongOne) {
  const auto reasonOf = [](const std::string& what) { return guarded([&] { throw std::runtime_error(what); }, named).error().sentence(); };
  EXPECT_EQ(reasonOf("two\nlines.\n"), "two lines");
  EXPECT_EQ(reasonOf(std::string(1000, 'x')).size(), 300u);
  std::string wide = "x";
  for (int n = 0; n < 300; ++n) wide += "\u00fc";  // two bytes each, the limit falls between them
  EXPECT_EQ(reasonOf(wide).size(), 299u);
}

}  // namespace
}  // namespace ew::guarded_test
