#include "ew/imaging/effects/reverberation.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <random>

namespace ew::reverberation_test {
namespace {

constexpr double kGreyPerDb = 255.0 / 60.0;

float& at(BeamImage& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)];
}

BeamImage reverberated(const ReverberationEffect& effect, BeamImage echoes) {
  ReverberationScratch scratch;
  reverberate(effect, kGreyPerDb, 5, viewOf(echoes), scratch);
  return echoes;
}

/// Two powers together, in grey levels.
double together(double a, double b) {
  const double tenth = 10.0 * kGreyPerDb;
  return tenth * std::log10(std::pow(10.0, a / tenth) + std::pow(10.0, b / tenth));
}

TEST(Reverberation, OfABrightPlaneRepeatsItAtMultiplesOfItsDepthABounceWeakerEachTime) {
  ReverberationEffect effect;
  effect.mirror = false;
  effect.bounces = 3;
  BeamImage echoes(37, 500, -400.0F);
  for (int x = 0; x < 37; ++x) at(echoes, x, 90) = 250.0F;
  BeamImage shown = reverberated(effect, echoes);
  for (int x = 0; x < 37; ++x)
    for (int y = 0; y < 500; ++y) {
      double expected = -400.0;
      if (y == 90) expected = 250.0;
      if (y == 180 || y == 270 || y == 360) expected = 250.0 - (y / 90 - 1) * 14.0 * kGreyPerDb;
      if (y > 90 && y <= 360) {
        const int times = (y - 1) / 90;
        expected = y % 90 == 0 ? 250.0 - times * 14.0 * kGreyPerDb : together(-400.0, -400.0 - times * 14.0 * kGreyPerDb);
      }
      ASSERT_NEAR(at(shown, x, y), expected, 0.01) << x << ", " << y;
    }
}

TEST(Reverberation, RepeatsWhatLiesBeforeTheInterfaceAddedAsPower) {
  ReverberationEffect effect;
  effect.mirror = false;
  effect.bounces = 1;
  BeamImage echoes(5, 300, 60.0F);
  for (int x = 0; x < 5; ++x) {
    at(echoes, x, 100) = 240.0F;
    at(echoes, x, 40) = 150.0F;
  }
  BeamImage shown = reverberated(effect, echoes);
  EXPECT_NEAR(at(shown, 2, 140), together(60.0, 150.0 - 14.0 * kGreyPerDb), 0.01);
  EXPECT_NEAR(at(shown, 2, 150), together(60.0, 60.0 - 14.0 * kGreyPerDb), 0.01);
  EXPECT_EQ(at(shown, 2, 201), 60.0F) << "one bounce reaches to twice the depth";
}

TEST(Reverberation, MirrorsTheTissueBeforeASmoothInterfaceBehindIt) {
  ReverberationEffect effect;
  effect.bounces = 1;
  effect.loss_dbPerBounce = 100.0;
  BeamImage echoes(16, 300, -300.0F);
  for (int x = 0; x < 16; ++x) {
    for (int y = 5; y < 100; ++y) at(echoes, x, y) = static_cast<float>(40 + y);
    at(echoes, x, 100) = 240.0F;
  }
  BeamImage shown = reverberated(effect, echoes);
  for (int x = 0; x < 16; ++x)
    for (int d = 1; d <= 95; ++d)
      EXPECT_NEAR(at(shown, x, 100 + d), static_cast<double>(at(echoes, x, 100 - d)) - 12.0 * kGreyPerDb, 0.02) << d;
}

TEST(Reverberation, DoesNotMirrorAtARoughInterface) {
  ReverberationEffect effect;
  effect.bounces = 1;
  effect.loss_dbPerBounce = 1000.0;
  BeamImage echoes(16, 300, 100.0F);
  for (int x = 0; x < 16; ++x) at(echoes, x, 100 + 20 * (x % 2)) = 240.0F;
  EXPECT_EQ(reverberated(effect, echoes), echoes);
}

TEST(Reverberation, OfMirroredLinesIsTheMirroredReverberation) {
  // Strong parts with weaker ones between them, bright enough to be followed from either side to another depth.
  std::mt19937 random(3);
  std::uniform_real_distribution<float> level(0.0F, 255.0F);
  int changed = 0;
  for (int round = 0; round < 40; ++round) {
    BeamImage echoes(64, 120, 40.0F);
    for (int x = 0; x < 64; ++x)
      for (int y = 50; y < 66; ++y) at(echoes, x, y) = level(random);
    BeamImage mirrored(64, 120);
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 64; ++x) at(mirrored, x, y) = at(echoes, 63 - x, y);
    const BeamImage before = echoes;
    echoes = reverberated({}, echoes);
    mirrored = reverberated({}, mirrored);
    changed += echoes == before ? 0 : 1;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 64; ++x) ASSERT_EQ(at(mirrored, x, y), at(echoes, 63 - x, y)) << "round " << round << " at " << x << ", " << y;
  }
  EXPECT_GT(changed, 5);
}

TEST(Reverberation, WithoutAStrongInterfaceWritesNothing) {
  ReverberationEffect effect;
  BeamImage echoes(33, 200, 199.0F);
  for (int x = 0; x < 33; ++x) at(echoes, x, 3) = 255.0F;  // the near field
  const BeamImage before = echoes;
  ReverberationScratch scratch;
  EXPECT_EQ(reverberate(effect, kGreyPerDb, 5, viewOf(echoes), scratch), 0);
  EXPECT_EQ(echoes, before);
}

TEST(Reverberation, NeedsAnInterfaceThatNineLinesSideBySideSee) {
  ReverberationScratch scratch;
  for (const int seen : {1, 8, 9, 20}) {
    BeamImage echoes(64, 200, 80.0F);
    for (int x = 30; x < 30 + seen; ++x) at(echoes, x, 50 + x) = 230.0F;
    const BeamImage before = echoes;
    EXPECT_EQ(reverberate({}, kGreyPerDb, 5, viewOf(echoes), scratch), seen < 9 ? 0 : seen);
    EXPECT_EQ(echoes == before, seen < 9);
  }
}

TEST(Reverberation, FollowsAnInterfaceIntoItsWeakerParts) {
  BeamImage echoes(64, 200, 80.0F);
  for (int x = 10; x < 50; ++x) at(echoes, x, 90 + x / 2) = x % 10 == 0 ? 201.0F : 155.0F;
  ReverberationScratch scratch;
  EXPECT_EQ(reverberate({}, kGreyPerDb, 5, viewOf(echoes), scratch), 40);
  for (std::size_t n = 0; n < 64; ++n)
    EXPECT_EQ(scratch.interfaces[n], n >= 10 && n < 50 ? 90 + static_cast<int>(n) / 2 : -1) << "line " << n;
}

TEST(Reverberation, OfATiltedInterfaceMissesTheFace) {
  ReverberationEffect effect;
  effect.mirror = false;
  for (const int tilt : {0, 1, 2}) {
    BeamImage echoes(40, 300, 80.0F);
    for (int x = 0; x < 40; ++x) at(echoes, x, 50 + tilt * x) = 230.0F;
    EXPECT_EQ(reverberated(effect, echoes) == echoes, tilt > 1) << tilt;
  }
}

TEST(Reverberation, LeavesOutASmallBodyThatBulgesTowardsTheProbe) {
  ReverberationEffect effect;
  for (const int bulge : {-1, 0, 1}) {
    BeamImage echoes(64, 200, 80.0F);
    for (int x = 20; x < 40; ++x) at(echoes, x, 100 + bulge * (x - 30) * (x - 30) / 5) = 230.0F;
    ReverberationScratch scratch;
    EXPECT_EQ(reverberate(effect, kGreyPerDb, 5, viewOf(echoes), scratch), bulge > 0 ? 0 : 20) << bulge;
  }
}

TEST(Reverberation, NeverDarkensAndLeavesOtherLinesAndWhatLiesBeforeUntouched) {
  EXPECT_TRUE(rc::check("lines", [] {
    ReverberationEffect effect;
    effect.bounces = *rc::gen::inRange(1, 7);
    const int lines = *rc::gen::inRange(1, 90);
    BeamImage echoes(lines, 150, 80.0F);
    for (int begin = 0; begin < lines;) {
      const int end = std::min(begin + *rc::gen::inRange(1, 30), lines);
      const bool bright = *rc::gen::arbitrary<bool>();
      const int depth = *rc::gen::inRange(5, 140);
      for (int x = begin; x < end && bright; ++x) at(echoes, x, depth) = 230.0F;
      begin = end;
    }
    ReverberationScratch scratch;
    BeamImage shown = echoes;
    const int found = reverberate(effect, kGreyPerDb, 5, viewOf(shown), scratch);
    int expected = 0;
    for (int x = 0; x < lines; ++x) {
      const int interface = scratch.interfaces[static_cast<std::size_t>(x)];
      expected += interface >= 0 ? 1 : 0;
      if (interface >= 0) RC_ASSERT(at(echoes, x, interface) == 230.0F);
      for (int y = 0; y < 150; ++y) {
        if (interface < 0 || y <= interface)
          RC_ASSERT(at(shown, x, y) == at(echoes, x, y));
        else
          RC_ASSERT(at(shown, x, y) >= at(echoes, x, y));
      }
    }
    RC_ASSERT(found == expected);
  }));
}

}  // namespace
}  // namespace ew::reverberation_test
