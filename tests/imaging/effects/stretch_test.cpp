#include "ew/imaging/effects/stretch.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ew::stretch_test {
namespace {

using Greys = std::vector<std::uint8_t>;

double exactAt(const Greys& in, std::size_t x, std::size_t n) {
  if (n == 1 || in.size() == 1) return in.front();
  const double position = static_cast<double>(x) * static_cast<double>(in.size() - 1) / static_cast<double>(n - 1);
  const auto left = std::min(static_cast<std::size_t>(position), in.size() - 2);
  const double w = position - static_cast<double>(left);
  return (1.0 - w) * in[left] + w * in[left + 1];
}

TEST(Stretch, EqualsLinearInterpolationWithinOneRoundingForAnyLengths) {
  EXPECT_TRUE(rc::check("stretch", [] {
    const Greys in = *rc::gen::container<Greys>(static_cast<std::size_t>(*rc::gen::inRange(1, 300)), rc::gen::arbitrary<std::uint8_t>());
    Greys out(static_cast<std::size_t>(*rc::gen::inRange(1, 1000)));
    stretch(in, out);
    for (std::size_t x = 0; x < out.size(); ++x) RC_ASSERT(std::abs(out[x] - exactAt(in, x, out.size())) < 0.501);
    RC_ASSERT(out.front() == in.front());
    if (out.size() > 1) RC_ASSERT(out.back() == in.back());
  }));
}

TEST(Stretch, OfMirroredValuesIsTheMirroredStretch) {
  EXPECT_TRUE(rc::check("mirrored", [] {
    Greys in = *rc::gen::container<Greys>(static_cast<std::size_t>(*rc::gen::inRange(1, 300)), rc::gen::arbitrary<std::uint8_t>());
    Greys out(static_cast<std::size_t>(*rc::gen::inRange(1, 1000)));
    stretch(in, out);
    std::reverse(in.begin(), in.end());
    Greys mirrored(out.size());
    stretch(in, mirrored);
    if (out.size() == 1) return;  // the first value alone
    std::reverse(mirrored.begin(), mirrored.end());
    RC_ASSERT(mirrored == out);
  }));
}

TEST(Stretch, ToTheSameLengthIsACopy) {
  Greys in(257);
  for (std::size_t x = 0; x < in.size(); ++x) in[x] = static_cast<std::uint8_t>(x * 37);
  Greys out(in.size());
  stretch(in, out);
  EXPECT_EQ(out, in);
}

}  // namespace
}  // namespace ew::stretch_test
