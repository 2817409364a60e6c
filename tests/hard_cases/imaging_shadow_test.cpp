// Hard cases of attenuation, reverberation, noise and contact; each test's name is the documented outcome.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/imaging/effects/attenuation.h"
#include "ew/imaging/effects/contact.h"
#include "ew/imaging/effects/noise.h"
#include "ew/imaging/effects/reverberation.h"

namespace ew::imaging_shadow_test {
namespace {

constexpr double kGreyPerDb = 255.0 / 60.0;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

bool isFinite(const BeamImage& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](float level) { return std::isfinite(level); });
}

/// Everything in the order of a frame, with strong settings.
BeamImage everything(BeamImage echoes, const GreyImage& labels, const std::vector<float>& gaps_mm) {
  Scene scene;
  scene.attenuation = AttenuationEffect{};
  scene.tissues = {{.label = 1, .name = "lung", .attenuation_dbPerCmMhz = 40.0, .reflection_db = 40.0},
                   {.label = 2, .name = "water", .attenuation_dbPerCmMhz = 0.0}};
  std::vector<float> scratch;
  std::vector<float> contact(static_cast<std::size_t>(echoes.width));
  contactOfLines({}, gaps_mm, 60.0, 20.0, contact);
  loseContact({}, contact, kGreyPerDb, 0.2, viewOf(echoes), scratch);
  attenuate(*scene.attenuation, makeTissueLosses(scene, 15e6, 0.2), viewOf(labels), kGreyPerDb, 15e6, 0.2, viewOf(echoes), scratch);
  ReverberationScratch lines;
  reverberate({}, kGreyPerDb, 10, viewOf(echoes), lines);
  addNoise(std::vector<float>(static_cast<std::size_t>(echoes.height), 80.0F), kGreyPerDb, ~std::uint64_t{0}, 0, viewOf(echoes));
  return echoes;
}

TEST(HardBeams, AllBlackAllWhiteOneLineOrTwoSamplesStayFinite) {
  for (const float level : {0.0F, 255.0F})
    for (const auto& [lines, samples] : {std::pair{1, 2}, {1, 750}, {192, 2}, {33, 300}})
      for (const int tissue : {-1, 0, 1, 2}) {
        const GreyImage labels = tissue < 0 ? GreyImage() : GreyImage(lines, samples, static_cast<std::uint8_t>(tissue));
        for (const std::vector<float>& gaps_mm : {std::vector<float>{}, {0.0F, 9.0F}, {99.0F, 99.0F}})
          EXPECT_TRUE(isFinite(everything(BeamImage(lines, samples, level), labels, gaps_mm)))
              << level << ", " << lines << " x " << samples << ", tissue " << tissue;
      }
}

TEST(HardBeams, LossFarBeyondTheRangeIsBlackAndNothingElse) {
  Scene scene;
  scene.attenuation = AttenuationEffect{};
  scene.tissues = {{.label = 1, .name = "lead", .attenuation_dbPerCmMhz = 1000.0, .reflection_db = 1000.0}};
  BeamImage echoes(3, 4000, 255.0F);
  std::vector<float> scratch;
  const GreyImage labels(3, 4000, 1);
  attenuate(*scene.attenuation, makeTissueLosses(scene, 50e6, 1.0), viewOf(labels), kGreyPerDb, 50e6, 1.0, viewOf(echoes), scratch);
  EXPECT_TRUE(isFinite(echoes));
  EXPECT_LT(echoes.pixels.back(), 0.0F);
}

TEST(HardBeams, AllWhiteHasItsInterfaceAtOnceAndNothingBehindIt) {
  BeamImage echoes(20, 100, 255.0F);
  const BeamImage before = echoes;
  ReverberationScratch scratch;
  EXPECT_EQ(reverberate({}, kGreyPerDb, 10, viewOf(echoes), scratch), 20);
  EXPECT_EQ(echoes, before);
}

TEST(HardBeams, NearFieldDeeperThanTheImageHasNoInterface) {
  BeamImage echoes(20, 100, 255.0F);
  ReverberationScratch scratch;
  EXPECT_EQ(reverberate({}, kGreyPerDb, 1000, viewOf(echoes), scratch), 0);
  EXPECT_EQ(reverberate({}, kGreyPerDb, -5, viewOf(echoes), scratch), 20);
}

TEST(HardBeams, GapsThatAreNoNumbersDoNotTouch) {
  std::vector<float> contact(9);
  contactOfLines({}, std::vector<float>{kNan, kNan}, 60.0, 20.0, contact);
  for (const float share : contact) EXPECT_EQ(share, 0.0F);
  contactOfLines({}, std::vector<float>{0.0F, std::numeric_limits<float>::infinity()}, 60.0, 0.0, contact);
  EXPECT_EQ(contact.front(), 1.0F - contact.back());
  EXPECT_GT(contact.front(), 0.99F);
  std::vector<float> one(1);
  contactOfLines({}, std::vector<float>{0.0F, kNan}, 60.0, 200.0, one);
  EXPECT_NEAR(one[0], 0.5F, 1e-6F);
}

TEST(HardBeams, ContactThatIsNoNumberIsNone) {
  BeamImage lost(2, 100, 255.0F), none(2, 100, 255.0F);
  std::vector<float> scratch;
  loseContact({}, std::vector<float>{kNan, -3.0F}, kGreyPerDb, 0.2, viewOf(lost), scratch);
  loseContact({}, std::vector<float>{0.0F, 0.0F}, kGreyPerDb, 0.2, viewOf(none), scratch);
  EXPECT_EQ(lost, none);
}

}  // namespace
}  // namespace ew::imaging_shadow_test
