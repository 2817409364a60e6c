#include "ew/imaging/effects/contact.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ew::contact_test {
namespace {

constexpr double kGreyPerDb = 255.0 / 60.0;
constexpr double kSpacing_mm = 0.2;

std::vector<float> contactOf(const std::vector<float>& gaps_mm, int lines, double aperture_mm = 20.0) {
  std::vector<float> contact(static_cast<std::size_t>(lines), -1.0F);
  contactOfLines({}, gaps_mm, 60.0, aperture_mm, contact);
  return contact;
}

float at(const BeamImage& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)];
}

BeamImage withContact(const std::vector<float>& contact, BeamImage echoes) {
  std::vector<float> scratch;
  loseContact({}, contact, kGreyPerDb, kSpacing_mm, viewOf(echoes), scratch);
  return echoes;
}

TEST(Contact, IsFullWithoutGapsWhenPressedInAndWithinTheGel) {
  for (const std::vector<float>& gaps_mm : {std::vector<float>{}, {-2.0F, -1.0F}, {0.0F, 3.0F, 2.9F}})
    for (const float share : contactOf(gaps_mm, 33)) EXPECT_EQ(share, 1.0F);
}

TEST(Contact, IsNoneInAir) {
  for (const float share : contactOf({50.0F, 50.0F}, 17)) EXPECT_EQ(share, 0.0F);
}

TEST(Contact, IsTheShareOfTheApertureThatTouches) {
  // 61 points, 1 mm apart; the +x half is in the air, the step between points 30 and 31 is linear.
  std::vector<float> gaps_mm(61, 0.0F);
  for (std::size_t n = 31; n < gaps_mm.size(); ++n) gaps_mm[n] = 50.0F;
  const std::vector<float> contact = contactOf(gaps_mm, 121, 20.0);
  for (int line = 0; line < 121; ++line) {
    const double x_mm = 0.5 * line;
    const double left = std::max(x_mm - 10.0, 0.0), right = std::min(x_mm + 10.0, 60.0);
    const auto upTo = [](double x) { return x <= 30.0 ? x : x >= 31.0 ? 30.5 : 30.0 + (x - 30.0) - 0.5 * (x - 30.0) * (x - 30.0); };
    EXPECT_NEAR(static_cast<double>(contact[static_cast<std::size_t>(line)]), (upTo(right) - upTo(left)) / (right - left), 1e-5) << line;
  }
}

TEST(Contact, FallsOffSoftlyAndStaysBetweenNoneAndFull) {
  EXPECT_TRUE(rc::check("soft", [] {
    std::vector<float> gaps_mm;
    const int points = *rc::gen::inRange(2, 40);
    for (int n = 0; n < points; ++n) gaps_mm.push_back(static_cast<float>(*rc::gen::inRange(-50, 100)) / 10.0F);
    const std::vector<float> contact = contactOf(gaps_mm, 128, 20.0);
    for (std::size_t n = 0; n < contact.size(); ++n) {
      RC_ASSERT(contact[n] >= 0.0F && contact[n] <= 1.0F);
      // Half an aperture of 10 mm and lines 60/127 mm apart: a neighbour's share differs by two of their distances over half of it at most.
      if (n > 0) RC_ASSERT(std::abs(contact[n] - contact[n - 1]) <= 2.0F * 60.0F / 127.0F / 10.0F);
    }
  }));
}

TEST(Contact, ThatIsFullLeavesEchoesUntouchedToTheBit) {
  BeamImage echoes(40, 200);
  for (std::size_t n = 0; n < echoes.pixels.size(); ++n) echoes.pixels[n] = static_cast<float>(n % 257) * 1.01F;
  EXPECT_EQ(withContact(std::vector<float>(40, 1.0F), echoes), echoes);
  std::vector<float> contact(40, 1.0F);
  for (std::size_t n = 20; n < 40; ++n) contact[n] = 0.0F;
  const BeamImage shown = withContact(contact, echoes);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 20; ++x) ASSERT_EQ(at(shown, x, y), at(echoes, x, y));
}

TEST(Contact, ThatIsPartialTakesTheShareOfAmplitudeOnceEachWay) {
  const BeamImage shown = withContact(std::vector<float>(5, 0.5F), BeamImage(5, 200, 200.0F));
  for (int y = 100; y < 200; ++y) EXPECT_NEAR(at(shown, 2, y), 200.0 - kGreyPerDb * 40.0 * std::log10(2.0), 1e-3);
}

TEST(Contact, ThatIsLostIsDarkBelowBarsThatFadeAtEqualDistances) {
  const BeamImage shown = withContact(std::vector<float>(9, 0.0F), BeamImage(9, 300, 255.0F));
  for (int y = 61; y < 300; ++y) EXPECT_LT(at(shown, 4, y), 0.0F) << "behind the ring-down";
  std::vector<int> bars;
  for (int y = 1; y < 60; ++y)
    if (at(shown, 4, y) > at(shown, 4, y - 1) && at(shown, 4, y) >= at(shown, 4, y + 1)) bars.push_back(y);
  ASSERT_GE(bars.size(), 5U);
  for (std::size_t n = 1; n < bars.size(); ++n) {
    EXPECT_NEAR(bars[n] - bars[n - 1], 7.5, 0.51) << "1.5 mm";
    EXPECT_LT(at(shown, 4, bars[n]), at(shown, 4, bars[n - 1]));
  }
  EXPECT_GT(at(shown, 4, 0), 240.0F);
}

}  // namespace
}  // namespace ew::contact_test
