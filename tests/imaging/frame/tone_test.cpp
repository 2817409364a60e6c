#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "ew/imaging/effects/gain.h"
#include "ew/imaging/frame.h"
#include "imaging/support/support.h"

namespace ew::tone_test {
namespace {

using Sliders = std::array<double, kDgcSliders>;
constexpr Sliders kOnes{1, 1, 1, 1, 1, 1, 1, 1};
constexpr std::array kMaps = {GreyMap::linear, GreyMap::soft, GreyMap::contrast, GreyMap::bright, GreyMap::clinical};

std::vector<std::uint8_t> tableOf(double gain, const Sliders& dgc, const Tone& tone, const std::vector<double>& rows) {
  std::vector<std::uint8_t> table;
  buildGainTable(gain, dgc, tone, rows, table);
  return table;
}

Tone anyTone() {
  return {.recordedDynamicRange_db = static_cast<double>(*rc::gen::inRange(20, 121)),
          .dynamicRange_db = static_cast<double>(*rc::gen::inRange(20, 121)),
          .map = *rc::gen::elementOf(kMaps),
          .middleLevel = static_cast<double>(*rc::gen::inRange(0, 256))};
}

Sliders anySliders() {
  Sliders sliders{};
  const bool extreme = *rc::gen::arbitrary<bool>();
  for (std::size_t k = 0; k < sliders.size(); ++k) sliders[k] = extreme ? (k % 2 ? 1e4 : 0.0) : *rc::gen::inRange(0, 400) / 100.0;
  return sliders;
}

TEST(Tone, OfTheRecordedRangeAndTheLinearMapIsNeutralAndGivesThePlainTable) {
  EXPECT_TRUE(Tone{}.isNeutral());
  EXPECT_FALSE((Tone{.dynamicRange_db = 50.0}.isNeutral()));
  EXPECT_FALSE((Tone{.map = GreyMap::soft}.isNeutral()));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> factor(0.0, 4.0);
  for (int trial = 0; trial < 50; ++trial) {
    Sliders dgc{};
    for (double& slider : dgc) slider = factor(random);
    const double gain = factor(random);
    const std::vector<double> rows = {0.0, 0.2, 0.33, 0.71, 1.0};
    std::vector<std::uint8_t> plain;
    buildGainTable(gain, dgc, rows, plain);
    ASSERT_EQ(tableOf(gain, dgc, {}, rows), plain);
    ASSERT_EQ(tableOf(gain, dgc, {.recordedDynamicRange_db = 47.0, .dynamicRange_db = 47.0}, rows), plain);
  }
}

TEST(Tone, ShowsALevelThatIsNotFaintAtItsDistanceFromTheMiddleInDecibels) {
  EXPECT_TRUE(rc::check("levels", [] {
    const Tone tone{.recordedDynamicRange_db = static_cast<double>(*rc::gen::inRange(20, 121)),
                    .dynamicRange_db = static_cast<double>(*rc::gen::inRange(20, 121)),
                    .middleLevel = static_cast<double>(*rc::gen::inRange(0, 256))};
    const double level = *rc::gen::inRange(1600, 25501) / 100.0;
    const double above_db = (level - tone.middleLevel) / 255.0 * tone.recordedDynamicRange_db;
    RC_ASSERT(std::abs(shownLevel(tone, level) - std::clamp(tone.middleLevel + 255.0 * above_db / tone.dynamicRange_db, 0.0, 255.0)) <
              1e-9);
  }));
}

TEST(Tone, NarrowerThanRecordedAddsContrastAboutTheMiddleAndWiderLeavesBlackBlack) {
  for (const double range_db : {20.0, 40.0, 60.0, 90.0, 120.0})
    for (const double middle : {45.0, 101.5}) {
      const Tone tone{.dynamicRange_db = range_db, .middleLevel = middle};
      EXPECT_NEAR(shownLevel(tone, middle), middle, 1e-9) << "the middle stays";
      EXPECT_NEAR(shownLevel(tone, middle + 8.0) - shownLevel(tone, middle - 8.0), 16.0 * 60.0 / range_db, 1e-9) << range_db;
    }
  EXPECT_NEAR(shownLevel({.dynamicRange_db = 40.0}, 15.0), 0.0, 1e-9) << "30 levels below the middle of 45, half as much again";
  EXPECT_EQ(shownLevel({.dynamicRange_db = 40.0}, 12.0), 0.0);
  EXPECT_EQ(shownLevel({.dynamicRange_db = 40.0}, 185.0), 255.0) << "140 above it";
  EXPECT_NEAR(shownLevel({.dynamicRange_db = 90.0}, 51.0), 49.0, 1e-9);
  for (const double range_db : {61.0, 90.0, 120.0}) {
    EXPECT_NEAR(shownLevel({.dynamicRange_db = range_db}, 0.0), 0.0, 1e-9) << "outside stays outside";
    for (int n = 1; n <= 400; ++n)
      ASSERT_GT(shownLevel({.dynamicRange_db = range_db}, n / 10.0), shownLevel({.dynamicRange_db = range_db}, (n - 1) / 10.0));
  }
  for (const double range_db : {20.0, 40.0, 60.0}) EXPECT_EQ(shownLevel({.dynamicRange_db = range_db}, 255.0), 255.0);
}

TEST(GreyMaps, KeepBlackWhiteAndTheOrder) {
  for (const GreyMap map : kMaps) {
    const Tone tone{.map = map};
    EXPECT_EQ(shownLevel(tone, 0.0), 0.0);
    EXPECT_NEAR(shownLevel(tone, 255.0), 255.0, 1e-9);
    for (int n = 1; n <= 2550; ++n) ASSERT_GE(shownLevel(tone, n / 10.0), shownLevel(tone, (n - 1) / 10.0)) << n;
  }
}

TEST(GreyMaps, ClinicalGoesThroughWhatWasMeasuredAndRejectsTheWeakest) {
  const Tone clinical{.map = GreyMap::clinical};
  EXPECT_FALSE(clinical.isNeutral());
  constexpr std::array kMeasured = {std::pair{80, 24},  std::pair{90, 32},  std::pair{100, 43},  std::pair{110, 55},
                                    std::pair{120, 68}, std::pair{130, 85}, std::pair{150, 126}, std::pair{170, 183}};
  for (const auto& [ours, shown] : kMeasured) EXPECT_NEAR(shownLevel(clinical, ours), shown, 1e-9);
  for (double below_db = 52.0; below_db <= 60.0; below_db += 0.5) EXPECT_EQ(shownLevel(clinical, 255.0 * (1.0 - below_db / 60.0)), 0.0);
  EXPECT_GT(shownLevel(clinical, 255.0 * (1.0 - 49.0 / 60.0)), 0.5);
  EXPECT_NEAR(shownLevel({.dynamicRange_db = 40.0, .map = GreyMap::clinical, .middleLevel = 100.0}, 120.0), shownLevel(clinical, 130.0),
              1e-9)
      << "the curve is of the range that is shown";
}

RC_GTEST_PROP(GreyMaps, RiseWithoutAJump, ()) {
  const Tone tone{.map = *rc::gen::elementOf(kMaps)};
  const double level = *rc::gen::inRange(0, 255000) / 1000.0;
  const double rise = shownLevel(tone, level + 0.001) - shownLevel(tone, level);
  RC_ASSERT(rise >= -1e-12 && rise < 0.0035);
}

TEST(GreyMaps, AreTheCurvesTheyPromise) {
  const auto slope = [](GreyMap map, double level) {
    return (shownLevel({.map = map}, level + 0.01) - shownLevel({.map = map}, level - 0.01)) / 0.02;
  };
  EXPECT_NEAR(slope(GreyMap::soft, 127.5), 0.5, 1e-3);
  EXPECT_NEAR(slope(GreyMap::contrast, 127.5), 1.5, 1e-3);
  EXPECT_NEAR(slope(GreyMap::linear, 127.5), 1.0, 1e-9);
  for (const GreyMap map : {GreyMap::linear, GreyMap::soft, GreyMap::contrast})
    EXPECT_NEAR(shownLevel({.map = map}, 127.5), 127.5, 1e-9) << "the middle stays";
  EXPECT_NEAR(shownLevel({.map = GreyMap::bright}, 127.5), 1.35 * 127.5, 1e-9);
  EXPECT_NEAR(shownLevel({.map = GreyMap::soft}, 100.0) + shownLevel({.map = GreyMap::contrast}, 100.0), 200.0, 1e-9)
      << "what one adds the other takes";
}

RC_GTEST_PROP(ToneTable, IsEquationFiveWithTheToneBehindItRoundedOnce, ()) {
  const Sliders dgc = anySliders();
  const Tone tone = anyTone();
  const double gain = *rc::gen::inRange(0, 1000) / 100.0;
  const std::vector<double> rows = {0.0, 0.11, 0.5, 0.77, 1.0};
  const std::vector<std::uint8_t> table = tableOf(gain, dgc, tone, rows);
  RC_ASSERT(table.size() == 256U * rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t v = 0; v < 256; ++v) {
      const double amplified = std::min(gain * std::min(dgcAt(dgc, rows[row]) * static_cast<double>(v), 255.0), 255.0);
      RC_ASSERT(std::abs(table[256 * row + v] - shownLevel(tone, amplified)) <= 0.5 + 1e-9);
    }
}

RC_GTEST_PROP(ToneTable, StaysMonotoneInGreyForSlidersAlternatingBetweenExtremes, ()) {
  Sliders dgc{};
  const double far = *rc::gen::elementOf(std::array{4.0, 1e4, 1e-17, 1e300});
  for (std::size_t k = 0; k < dgc.size(); ++k) dgc[k] = k % 2 ? far : 0.0;
  const double gain = *rc::gen::elementOf(std::array{0.0, 1e-12, 0.3, 1.0, 7.0, 1e4});
  const std::vector<double> rows = {0.0, 0.1, 0.13, 0.2, 0.4, 0.45, 0.8, 1.0};
  const std::vector<std::uint8_t> table = tableOf(gain, dgc, anyTone(), rows);
  for (std::size_t n = 1; n < table.size(); ++n)
    if (n % 256 != 0) RC_ASSERT(table[n] >= table[n - 1]);
}

TEST(ToneTable, OfRangesThatAreNoNumbersIsThatOfTheRecordedRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> rows = {0.5};
  const std::vector<std::uint8_t> neutral = tableOf(1.3, kOnes, {}, rows);
  for (const double none : {nan, 0.0, -40.0}) {
    EXPECT_EQ(tableOf(1.3, kOnes, {.dynamicRange_db = none}, rows), neutral);
    EXPECT_EQ(tableOf(1.3, kOnes, {.recordedDynamicRange_db = none}, rows), neutral);
  }
  EXPECT_EQ(tableOf(1.3, kOnes, {.dynamicRange_db = infinity}, rows), tableOf(1.3, kOnes, {.dynamicRange_db = 120.0}, rows));
  EXPECT_EQ(tableOf(1.3, kOnes, {.dynamicRange_db = 1e-9}, rows), tableOf(1.3, kOnes, {.dynamicRange_db = 20.0}, rows));
  EXPECT_EQ(shownLevel({.dynamicRange_db = 90.0}, nan), shownLevel({.dynamicRange_db = 90.0}, 0.0));
}

/// An image with a convex fan's kind of runs: none, one or two in a row, of any lengths.
struct FannedImage {
  GreyImage image;
  Spans spans;
};
FannedImage anyFannedImage(std::mt19937& random, int width, int height) {
  FannedImage made{GreyImage(width, height), Spans(static_cast<std::size_t>(height))};
  for (std::uint8_t& pixel : made.image.pixels) pixel = static_cast<std::uint8_t>(random());
  for (auto& row : made.spans) {
    int x = static_cast<int>(random() % 20);
    for (unsigned runs = random() % 3; runs > 0 && x < width; --runs) {
      const int end = std::min(width, x + 1 + static_cast<int>(random() % static_cast<unsigned>(width)));
      row.push_back({x, end});
      x = end + 1 + static_cast<int>(random() % 9);
    }
  }
  return made;
}

TEST(ToneTable, IsAppliedToEveryPixelOfTheSpansAndToNoOther) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const int width = 1 + static_cast<int>(random() % 300), height = 1 + static_cast<int>(random() % 5);
    FannedImage fanned = anyFannedImage(random, width, height);
    std::vector<std::uint8_t> table(256 * static_cast<std::size_t>(height));
    for (std::uint8_t& entry : table) entry = static_cast<std::uint8_t>(random());
    GreyImage expected = fanned.image;
    for (int y = 0; y < height; ++y)
      for (const RowSpan& span : fanned.spans[static_cast<std::size_t>(y)])
        for (int x = span.begin; x < span.end; ++x) {
          std::uint8_t& pixel = expected.pixels[static_cast<std::size_t>(y * width + x)];
          pixel = table[static_cast<std::size_t>(256 * y) + pixel];
        }
    applyGainTable(viewOf(fanned.image), fanned.spans, table);
    ASSERT_EQ(fanned.image, expected) << "trial " << trial;
  }
}

TEST(ToneTable, AppliedInBandsOfRowsGivesTheSameImage) {
  std::mt19937 random(12);
  FannedImage whole = anyFannedImage(random, 211, 23);
  std::vector<double> rows;
  for (int y = 0; y < 23; ++y) rows.push_back(y / 22.0);
  const std::vector<std::uint8_t> table =
      tableOf(1.3, {0.2, 2, 0.5, 3, 1, 1, 0, 4}, {.dynamicRange_db = 45.0, .map = GreyMap::contrast}, rows);
  GreyImage banded = whole.image;
  applyGainTable(viewOf(whole.image), whole.spans, table);
  const std::span<const std::vector<RowSpan>> spans(whole.spans);
  for (const auto& [first, count] : {std::pair{0, 7}, std::pair{7, 1}, std::pair{8, 15}}) {
    const ImageView<std::uint8_t> all = viewOf(banded);
    applyGainTable({all.row(first), all.width, count, all.stride},
                   spans.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count)),
                   std::span(table).subspan(256 * static_cast<std::size_t>(first)));
  }
  EXPECT_EQ(banded, whole.image);
}

TEST(ToneTable, BehindAnImageIsEquationFiveAndTheToneAtEveryPixelOfTheFanAndBlackStaysAroundIt) {
  const Volume volume = testing::volumeOf(
      {120, 160, 100}, [](int i, int j, int k) { return i + j + (k % 7); }, glm::dvec3(1.4));
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 50.0;
  probe.halfAngle_rad = 0.5;
  probe.minDepth_mm = 40.0;
  probe.maxDepth_mm = 200.0;
  probe.defaultDepth_mm = 120.0;
  FrameMaker maker;
  maker.configure(probe, {}, {}, volume.grid, 240, 260);
  Pose pose;
  pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), {80.0, 20.0, 70.0});
  const auto echo = maker.make(volume.view(), pose).grey;

  const Sliders dgc = {0.4, 0.6, 1.2, 2.0, 1.0, 0.3, 0.8, 1.5};
  for (const GreyMap map : kMaps) {
    const Tone tone{.dynamicRange_db = map == GreyMap::soft ? 80.0 : 45.0, .map = map};
    std::vector<double> depth;
    for (int y = 0; y < echo.height; ++y)
      depth.push_back(
          std::clamp((maker.geometry().imageToProbe() * Point<frame::Image>{{0, y, 0}}).at.y / maker.geometry().depth_mm, 0.0, 1.0));
    GreyImage shown(echo.width, echo.height);
    std::copy(echo.data, echo.data + shown.pixels.size(), shown.pixels.begin());
    applyGainTable(viewOf(shown), maker.spans(), tableOf(1.4, dgc, tone, depth));
    int different = 0;
    for (int y = 0; y < echo.height; ++y) {
      std::vector<bool> inFan(static_cast<std::size_t>(echo.width), false);
      for (const RowSpan& span : maker.spans()[static_cast<std::size_t>(y)])
        std::fill(inFan.begin() + span.begin, inFan.begin() + span.end, true);
      const double factor = dgcAt(dgc, depth[static_cast<std::size_t>(y)]);
      for (int x = 0; x < echo.width; ++x) {
        const double amplified = std::min(1.4 * std::min(factor * echo.at(x, y), 255.0), 255.0);
        const double expected = inFan[static_cast<std::size_t>(x)] ? shownLevel(tone, amplified) : 0.0;
        ASSERT_NEAR(viewOf(shown).at(x, y), expected, 0.5 + 1e-9) << x << ", " << y;
        different += viewOf(shown).at(x, y) != echo.at(x, y);
      }
    }
    EXPECT_GT(different, 5000);
  }
}

}  // namespace
}  // namespace ew::tone_test
