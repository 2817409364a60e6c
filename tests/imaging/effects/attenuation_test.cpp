#include "ew/imaging/effects/attenuation.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ew::attenuation_test {
namespace {

constexpr double kCarrier_hz = 3.5e6;
constexpr double kSpacing_mm = 0.2;
constexpr double kGreyPerDb = 255.0 / 60.0;
constexpr double kPath_cmMhz = 2.0 * 3.5 * 0.1 * kSpacing_mm;  // there and back, of one sample

constexpr std::uint8_t kLiver = 1;
constexpr std::uint8_t kStone = 2;
constexpr std::uint8_t kBile = 3;

Scene abdomen() {
  Scene scene;
  scene.attenuation = AttenuationEffect{};
  scene.tissues = {{.label = kLiver, .name = "liver", .attenuation_dbPerCmMhz = 0.5},
                   {.label = kStone, .name = "stone", .attenuation_dbPerCmMhz = 0.5, .reflection_db = 20.0},
                   {.label = kBile, .name = "bile", .attenuation_dbPerCmMhz = 0.0}};
  return scene;
}

BeamImage attenuated(const Scene& scene, const GreyImage& labels, BeamImage echoes) {
  std::vector<float> scratch;
  attenuate(*scene.attenuation, makeTissueLosses(scene, kCarrier_hz, kSpacing_mm), viewOf(labels), kGreyPerDb, kCarrier_hz, kSpacing_mm,
            viewOf(echoes), scratch);
  return echoes;
}

double at(const BeamImage& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)];
}

TEST(Attenuation, OfAHomogeneousLayerIsTwiceTheExcessTimesFrequencyAndDepth) {
  EXPECT_TRUE(rc::check("2 (a - expected) f d", [] {
    Scene scene = abdomen();
    scene.attenuation->largestEnhancement_db = 40.0;
    scene.tissues[0].attenuation_dbPerCmMhz = *rc::gen::inRange(0, 300) / 100.0;
    const int lines = *rc::gen::inRange(1, 40);
    const BeamImage shown = attenuated(scene, GreyImage(lines, 300, kLiver), BeamImage(lines, 300, 150.0F));
    for (int y = 0; y < 300; ++y) {
      const double loss_db = (scene.tissues[0].attenuation_dbPerCmMhz - 0.5) * kPath_cmMhz * y;
      for (int x = 0; x < lines; ++x) RC_ASSERT(std::abs(at(shown, x, y) - (150.0 - kGreyPerDb * loss_db)) < 0.02);
    }
  }));
}

TEST(Attenuation, ThatTheMachineExpectsChangesNothing) {
  const BeamImage echoes(19, 200, 100.0F);
  EXPECT_EQ(attenuated(abdomen(), GreyImage(19, 200, kLiver), echoes), echoes);
}

TEST(Attenuation, OfAReflectorIsAShadowOfItsReflectionBehindABrightFace) {
  GreyImage labels(8, 200, kLiver);
  for (int y = 60; y < 80; ++y)
    for (int x = 2; x < 5; ++x) labels.pixels[static_cast<std::size_t>(8 * y + x)] = kStone;
  const BeamImage shown = attenuated(abdomen(), labels, BeamImage(8, 200, 200.0F));
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(at(shown, x, 60), 200.0F) << "the face of the stone is as bright as ever";
    const double shadow = x >= 2 && x < 5 ? 20.0 * 255.0 / 60.0 : 0.0;
    for (int y = 100; y < 200; ++y) EXPECT_NEAR(at(shown, x, y), 200.0 - shadow, 0.05);
  }
}

TEST(Attenuation, OfTwoReflectorsOneBehindTheOtherAddsUp) {
  GreyImage labels(1, 300, kLiver);
  for (int y = 60; y < 80; ++y) labels.pixels[static_cast<std::size_t>(y)] = labels.pixels[static_cast<std::size_t>(y + 80)] = kStone;
  EXPECT_NEAR(at(attenuated(abdomen(), labels, BeamImage(1, 300, 250.0F)), 0, 299), 250.0 - 2.0 * 20.0 * kGreyPerDb, 0.05);
}

TEST(Attenuation, OfReflectorsThatSoundAlikeAndTouchIsThatOfOne) {
  constexpr std::uint8_t kOtherStone = 200;
  Scene scene = abdomen();
  const auto stone = std::find_if(scene.tissues.begin(), scene.tissues.end(), [](const auto& each) { return each.label == kStone; });
  ASSERT_NE(stone, scene.tissues.end());
  TissueAcoustics alike = *stone;
  alike.label = kOtherStone;
  alike.name = "another stone";
  scene.tissues.push_back(alike);
  GreyImage one(19, 300, kLiver);
  for (int y = 60; y < 100; ++y)
    for (int x = 2; x < 17; ++x) one.pixels[static_cast<std::size_t>(19 * y + x)] = kStone;
  GreyImage two = one;
  for (int y = 80; y < 100; ++y)
    for (int x = 2; x < 17; ++x) two.pixels[static_cast<std::size_t>(19 * y + x)] = kOtherStone;
  const BeamImage echoes(19, 300, 250.0F);
  EXPECT_EQ(attenuated(scene, two, echoes), attenuated(scene, one, echoes));
  scene.tissues.back().reflection_db += 1.0;
  EXPECT_NE(attenuated(scene, two, echoes), attenuated(scene, one, echoes)) << "from one that reflects otherwise it is entered";
}

TEST(Attenuation, LessThanExpectedEnhancesWhatLiesBehindUpToTheCap) {
  for (const int thickness : {20, 60, 200}) {
    GreyImage labels(5, 400, kLiver);
    for (int y = 50; y < 50 + thickness; ++y)
      for (int x = 0; x < 3; ++x) labels.pixels[static_cast<std::size_t>(5 * y + x)] = kBile;
    const BeamImage shown = attenuated(abdomen(), labels, BeamImage(5, 400, 90.0F));
    const double gain_db = std::min(0.5 * kPath_cmMhz * thickness, 9.0);
    for (int y = 300; y < 400; ++y) {
      EXPECT_NEAR(at(shown, 1, y), 90.0 + kGreyPerDb * gain_db, 0.02);
      EXPECT_NEAR(at(shown, 4, y), 90.0, 1e-4);
    }
  }
}

TEST(Attenuation, LeavesBlackFluidBlack) {
  const BeamImage shown = attenuated(abdomen(), GreyImage(4, 300, kBile), BeamImage(4, 300, 0.0F));
  for (const float level : shown.pixels) EXPECT_EQ(level, 0.0F);
}

TEST(Attenuation, WithoutLabelsTakesFromBrightInterfacesByTheirThickness) {
  AttenuationEffect effect;
  effect.interface_dbPerMm = 6.0;
  BeamImage echoes(3, 200, 100.0F);
  for (int y = 50; y < 60; ++y) echoes.pixels[static_cast<std::size_t>(3 * y + 1)] = 240.0F;
  std::vector<float> scratch;
  attenuate(effect, {}, {}, kGreyPerDb, kCarrier_hz, kSpacing_mm, viewOf(echoes), scratch);
  for (int y = 60; y < 200; ++y) {
    EXPECT_EQ(at(echoes, 0, y), 100.0F);
    EXPECT_NEAR(at(echoes, 1, y), 100.0 - kGreyPerDb * 6.0 * 10 * kSpacing_mm, 0.01);
  }
  EXPECT_NEAR(at(echoes, 1, 50), 240.0, 0.5 * kGreyPerDb * 6.0 * kSpacing_mm + 1e-3) << "half of its own loss at most";
}

TEST(Attenuation, WithoutLabelsEnhancesBehindFluidButNotBehindWhatWasNeverTissue) {
  const AttenuationEffect effect;
  BeamImage echoes(2, 400, 100.0F);
  for (int y = 0; y < 150; ++y) echoes.pixels[static_cast<std::size_t>(2 * y)] = 0.0F;        // no data before tissue
  for (int y = 100; y < 250; ++y) echoes.pixels[static_cast<std::size_t>(2 * y + 1)] = 0.0F;  // a cyst of 30 mm
  std::vector<float> scratch;
  attenuate(effect, {}, {}, kGreyPerDb, kCarrier_hz, kSpacing_mm, viewOf(echoes), scratch);
  EXPECT_EQ(at(echoes, 0, 399), 100.0F);
  EXPECT_EQ(at(echoes, 1, 200), 0.0F);
  // The averaged level needs 5 mm to follow into the cyst and 0.2 mm to follow out again.
  const double gain = kGreyPerDb * 0.5 * 2.0 * 3.5 * 3.0;
  EXPECT_LT(at(echoes, 1, 399), 100.0 + gain);
  EXPECT_GT(at(echoes, 1, 399), 100.0 + 0.75 * gain);
}

TEST(Attenuation, AsksTheGreyLevelWhereALabelIsUnknown) {
  Scene scene = abdomen();
  const GreyImage labels(21, 200, 77);
  BeamImage echoes(21, 200, 100.0F);
  for (int y = 50; y < 60; ++y)
    for (int x = 3; x < 21; ++x) echoes.pixels[static_cast<std::size_t>(21 * y + x)] = 240.0F;
  BeamImage unlabelled = echoes;
  std::vector<float> scratch;
  attenuate(*scene.attenuation, {}, {}, kGreyPerDb, kCarrier_hz, kSpacing_mm, viewOf(unlabelled), scratch);
  EXPECT_EQ(attenuated(scene, labels, echoes), unlabelled);
}

TEST(Attenuation, OfSomeLinesAloneIsThatOfAllLines) {
  EXPECT_TRUE(rc::check("bands", [] {
    const int lines = *rc::gen::inRange(2, 70);
    const int cut = *rc::gen::inRange(1, lines);
    GreyImage labels(lines, 120);
    BeamImage echoes(lines, 120);
    const auto seed = *rc::gen::arbitrary<unsigned>();
    for (std::size_t n = 0; n < labels.pixels.size(); ++n) {
      const unsigned bits = (static_cast<unsigned>(n / 7) + seed) * 2654435761U;
      labels.pixels[n] = static_cast<std::uint8_t>(bits >> 30);
      echoes.pixels[n] = static_cast<float>((bits >> 8) & 255U);
    }
    const Scene scene = abdomen();
    const BeamImage whole = attenuated(scene, labels, echoes);
    const TissueLosses losses = makeTissueLosses(scene, kCarrier_hz, kSpacing_mm);
    std::vector<float> scratch;
    for (const auto& [begin, end] : {std::pair{0, cut}, std::pair{cut, lines}})
      attenuate(*scene.attenuation, losses, {labels.pixels.data() + begin, end - begin, 120, lines}, kGreyPerDb, kCarrier_hz, kSpacing_mm,
                {echoes.pixels.data() + begin, end - begin, 120, lines}, scratch);
    RC_ASSERT(echoes == whole);
  }));
}

/// A convex fan over a stone sphere in the plane of the probe, turned by `rotation_rad` about the middle of its face: the lines it shadows.
struct FanOverStone {
  static constexpr int kLines = 128;
  static constexpr double kRadius_mm = 60.0;
  static constexpr double kHalfAngle_rad = 0.5;
  glm::dvec2 stone_mm{12.0, 55.0};
  double stoneRadius_mm = 6.0;
  double rotation_rad = 0.0;

  struct Ray {
    glm::dvec2 origin_mm;
    glm::dvec2 direction;
  };
  [[nodiscard]] Ray ray(int line) const {
    const double angle_rad = kHalfAngle_rad * (2.0 * line / (kLines - 1) - 1.0);
    const glm::dvec2 direction(std::sin(angle_rad), std::cos(angle_rad));
    const glm::dvec2 origin_mm = kRadius_mm * direction - glm::dvec2(0.0, kRadius_mm);
    const double c = std::cos(rotation_rad), s = std::sin(rotation_rad);
    const auto turned = [&](glm::dvec2 p) { return glm::dvec2(c * p.x - s * p.y, s * p.x + c * p.y); };
    return {turned(origin_mm), turned(direction)};
  }
  [[nodiscard]] double missDistance_mm(int line) const {
    const Ray r = ray(line);
    const glm::dvec2 to_mm = stone_mm - r.origin_mm;
    return std::abs(to_mm.x * r.direction.y - to_mm.y * r.direction.x);
  }
  [[nodiscard]] std::vector<bool> shadowed() const {
    GreyImage labels(kLines, 700, kLiver);
    for (int s = 0; s < 700; ++s)
      for (int line = 0; line < kLines; ++line) {
        const Ray r = ray(line);
        const glm::dvec2 p_mm = r.origin_mm + s * kSpacing_mm * r.direction;
        if (glm::length(p_mm - stone_mm) < stoneRadius_mm) labels.pixels[static_cast<std::size_t>(kLines * s + line)] = kStone;
      }
    const BeamImage shown = attenuated(abdomen(), labels, BeamImage(kLines, 700, 200.0F));
    std::vector<bool> dark;
    for (int line = 0; line < kLines; ++line) {
      const double level = at(shown, line, 699);
      EXPECT_TRUE(level == 200.0 || std::abs(level - (200.0 - 20.0 * kGreyPerDb)) < 0.05) << line << ": " << level;
      dark.push_back(level < 150.0);
    }
    return dark;
  }
};

TEST(Shadow, LiesOnExactlyTheLinesOfThePresentViewThatMeetTheObstacle) {
  std::vector<std::vector<bool>> views;
  for (const double rotation_rad : {0.0, 0.25, -0.2}) {
    FanOverStone view;
    view.rotation_rad = rotation_rad;
    const std::vector<bool> dark = view.shadowed();
    int shadowedLines = 0;
    for (int line = 0; line < FanOverStone::kLines; ++line) {
      const double miss_mm = view.missDistance_mm(line);
      // A chord shorter than a sample may fall between two samples.
      if (std::abs(miss_mm - view.stoneRadius_mm) < 2e-3) continue;
      EXPECT_EQ(dark[static_cast<std::size_t>(line)], miss_mm < view.stoneRadius_mm) << "turn " << rotation_rad << ", line " << line;
      shadowedLines += dark[static_cast<std::size_t>(line)] ? 1 : 0;
    }
    EXPECT_GT(shadowedLines, 5);
    views.push_back(dark);
  }
  EXPECT_NE(views[0], views[1]);
  EXPECT_NE(views[0], views[2]);
}

}  // namespace
}  // namespace ew::attenuation_test
