// Image formation where a frame has little or nothing to show.
#include <cmath>

#include "../phantom/formation.h"

namespace ew::testing::phantom_scanner_test {
namespace {

TEST(HardScanner, AProbeInTheAirSeesItsRingingAndItsNoise) {
  FormationOptions options;
  options.depth_mm = 40.0;
  options.tgc = {{0.0, 0.0}};
  options.noise_db = -60.0;
  const auto scanner = scannerOf(blockOfTissue(), shippedProbe("linear-7.5"), options);
  const Image<float> frame = envelopeOf(*scanner, held(0.0, 0.0, {0, -500, 0}));
  EXPECT_NEAR(meanPower_db(band(*scanner, frame, 10.0, 38.0)), -60.0, 0.5);
  EXPECT_GT(meanPower_db(band(*scanner, frame, 0.0, 0.3)), -25.0);
}

TEST(HardScanner, AFaceThatHangsTenMillimetresOverTheSkinHasNoContact) {
  FormationOptions options;
  options.depth_mm = 40.0;
  options.noise_db = -300.0;
  const auto scanner = scannerOf(blockOfTissue(), shippedProbe("linear-7.5"), options);
  const double lifted = meanPower_db(band(*scanner, envelopeOf(*scanner, held(0.0, 0.0, {0, -10, 0})), 20.0, 35.0));
  const double inGel = meanPower_db(band(*scanner, envelopeOf(*scanner, held(0.0, 0.0, {0, -2, 0})), 20.0, 35.0));
  EXPECT_LT(lifted, inGel - 50.0);
}

TEST(HardScanner, AProbeInsideWhatLetsNothingThroughGivesNumbersThatFadeIntoNoise) {
  const auto patient = blockOfTissue(
      R"({"name": "bone", "tissue": "bone", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})",
      R"({"name": "bone", "echo_level": 255, "speckle": 1, "attenuation_db_per_cm_mhz": 100, "reflection_db": 60})");
  FormationOptions options;
  options.depth_mm = 100.0;
  options.tgc = {{0.0, 0.0}};
  const auto scanner = scannerOf(patient, shippedProbe("linear-7.5"), options);
  const Image<float> frame = envelopeOf(*scanner);
  for (const float value : frame.pixels) ASSERT_TRUE(std::isfinite(value));
  EXPECT_NEAR(meanPower_db(band(*scanner, frame, 50.0, 95.0)), options.noise_db, 1.0);
}

}  // namespace
}  // namespace ew::testing::phantom_scanner_test
