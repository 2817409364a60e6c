#include "ew/imaging/caption.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ew::caption_test {
namespace {

TEST(Caption, TouchesOnlyTheLowerEdge) {
  GreyImage image(320, 240, 77);
  burnCaption(viewOf(image), kNotForDiagnosis);
  const auto view = viewOf(image);
  std::size_t changed = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x)
      if (view.at(x, y) != 77) {
        ++changed;
        EXPECT_GE(y, 220) << x;
      }
  EXPECT_GT(changed, 300u);
}

TEST(Caption, CanBeReadOnBlackAndOnWhite) {
  for (const int ground : {0, 255}) {
    GreyImage image(320, 240, static_cast<std::uint8_t>(ground));
    burnCaption(viewOf(image), kNotForDiagnosis);
    const auto& pixels = image.pixels;
    const auto letters = std::count(pixels.begin(), pixels.end(), 150);
    EXPECT_GT(letters, 200) << ground;
    const auto dark = std::count_if(pixels.begin(), pixels.end(), [](auto v) { return v <= 16; });
    EXPECT_GT(dark, letters) << "the rim, on " << ground;
  }
}

TEST(Caption, KeepsEveryLetterOnANarrowImage) {
  GreyImage wide(640, 480), narrow(kCaptionMinWidth_px, kCaptionMinHeight_px);
  burnCaption(viewOf(wide), kNotForDiagnosis);
  burnCaption(viewOf(narrow), kNotForDiagnosis);
  const auto letterPixels = [](const GreyImage& image) { return std::count(image.pixels.begin(), image.pixels.end(), 150); };
  EXPECT_EQ(letterPixels(wide), letterPixels(narrow)) << "nothing is cut off, it is only wrapped";
}

TEST(Caption, StaysInsideAnImageThatIsFarTooSmall) {
  GreyImage tiny(3, 2);
  burnCaption(viewOf(tiny), kNotForDiagnosis);
  EXPECT_EQ(tiny.pixels.size(), 6u);
}

}  // namespace
}  // namespace ew::caption_test
