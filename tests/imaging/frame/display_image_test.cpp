#include "ew/imaging/display_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ew/imaging/settings_json.h"
#include "places.h"

namespace ew::display_image_test {

TEST(DisplayImage, ColoursLieOverGreyByTheirAlphaRoundedToTheNearestLevel) {
  for (int below = 0; below < 256; below += 5)
    for (int above = 0; above < 256; above += 5)
      for (int alpha = 0; alpha < 256; alpha += 3) {
        const Rgb seen = over(Rgba(above, 255 - above, 0, alpha), Rgb(below));
        const double share = alpha / 255.0;
        ASSERT_EQ(seen.r, std::lround(above * share + below * (1.0 - share))) << below << ' ' << above << ' ' << alpha;
        ASSERT_EQ(seen.g, std::lround((255 - above) * share + below * (1.0 - share)));
      }
  EXPECT_EQ(over({1, 2, 3, 0}, Rgb(77)), Rgb(77));
  EXPECT_EQ(over({1, 2, 3, 255}, Rgb(77)), Rgb(1, 2, 3));
}

TEST(DisplayImage, WithoutColoursIsGreyInEveryChannel) {
  GreyImage grey(3, 2);
  for (std::size_t n = 0; n < 6; ++n) grey.pixels[n] = static_cast<std::uint8_t>(40 * n);
  const RgbImage flat = composed({viewOf(std::as_const(grey))});
  for (std::size_t n = 0; n < 6; ++n) EXPECT_EQ(flat.pixels[n], Rgb(grey.pixels[n]));
}

TEST(DisplayImage, WithColoursShowsThemWhereTheyAre) {
  const GreyImage grey(2, 1, 100);
  Image<Rgba> colour(2, 1, Rgba(0));
  colour.pixels[1] = {255, 0, 0, 255};
  const RgbImage flat = composed({viewOf(grey), viewOf(std::as_const(colour))});
  EXPECT_EQ(flat.pixels[0], Rgb(100));
  EXPECT_EQ(flat.pixels[1], Rgb(255, 0, 0));
}

TEST(ProbeJson, EveryShippedProbeComesBackAsItWasRead) {
  const auto probes = readProbes(std::filesystem::path(EW_SOURCE_DIR) / "resources/probes");
  ASSERT_TRUE(probes) << probes.error();
  ASSERT_GE(probes->size(), 4U);
  for (const Probe& probe : *probes) {
    const auto again = probeFromJson(nlohmann::json::parse(toJson(probe).dump()), probe.id, verbatim("a test"));
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(*again, probe) << probe.id;
  }
}

}  // namespace ew::display_image_test
