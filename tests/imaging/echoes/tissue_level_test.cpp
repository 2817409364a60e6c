#include "ew/imaging/tissue_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "ew/imaging/effects/gain.h"

namespace ew::tissue_level_test {
namespace {

constexpr double kGreyPerDb = 255.0 / 60.0;

/// Decibels are grey as they are, and nothing is added: what is in the volume is the level.
LevelOptions plain() {
  LevelOptions options;
  options.shownWith = GreyMap::linear;
  options.gain_db = 0.0;
  return options;
}

Volume volumeOf(const glm::ivec3& dims, double spacing_mm) {
  Volume volume;
  volume.grid.dims = dims;
  volume.grid.spacing_mm = glm::dvec3(spacing_mm);
  volume.echo.assign(volume.grid.voxelCount(), 0);
  return volume;
}

/// Fully developed speckle, independent from voxel to voxel: decibels of an exponential power, whose mean is `level` as grey.
/// @param looks whose grey is averaged
std::uint8_t speckle(double level, std::mt19937& random, int looks = 1) {
  std::exponential_distribution<double> power;
  double grey = 0.0;
  for (int n = 0; n < looks; ++n) grey += (level + kGreyPerDb * (10.0 * std::log10(power(random)) + 2.507)) / looks;
  return static_cast<std::uint8_t>(std::lround(std::clamp(grey, 1.0, 255.0)));
}

std::vector<std::uint8_t> madeOf(const Volume& volume, const LevelOptions& options = plain()) {
  auto made = levelOf(volume, options);
  EXPECT_TRUE(made) << (made ? "" : made.error().message.english());
  return made ? *made : std::vector<std::uint8_t>(volume.grid.voxelCount(), 0);
}

double meanOf(const std::vector<std::uint8_t>& values) {
  double sum = 0.0;
  for (const auto value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(TissueLevel, IsTheMeanOfSpeckleHoweverMuchOfItWasAveraged) {
  for (const int looks : {1, 3, 12}) {
    std::mt19937 random(7);
    Volume volume = volumeOf({40, 40, 40}, 0.5);
    for (auto& voxel : volume.echo) voxel = speckle(150.0, random, looks);
    const auto level = madeOf(volume);
    EXPECT_NEAR(meanOf(level), 150.0, 0.3 * kGreyPerDb) << looks;
    const auto [least, most] = std::minmax_element(level.begin(), level.end());
    EXPECT_LT(*most - *least, 5.0 * kGreyPerDb) << looks;  // speckle is gone: its own decibels span forty
  }
}

TEST(TissueLevel, KeepsAStepEdgeWhereItIsAndAsSteepAsHalfTheSigma) {
  std::mt19937 random(3);
  constexpr double kDark = 90.0, kBright = 150.0;
  Volume volume = volumeOf({64, 40, 40}, 0.4);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 64; ++i) volume.echo[volume.grid.indexOf(i, j, k)] = speckle(i < 32 ? kDark : kBright, random, 3);
  const auto level = madeOf(volume);
  std::vector<double> across(64, 0.0);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 64; ++i) across[static_cast<std::size_t>(i)] += level[volume.grid.indexOf(i, j, k)] / 1600.0;
  const auto crossing_mm = [&](double grey) {
    std::size_t n = 0;
    while (across[n + 1] < grey) ++n;
    return 0.4 * (static_cast<double>(n) + (grey - across[n]) / (across[n + 1] - across[n]) - 31.5);
  };
  EXPECT_NEAR(crossing_mm(0.5 * (kDark + kBright)), 0.0, 0.25);
  EXPECT_LT(crossing_mm(kDark + 0.9 * (kBright - kDark)) - crossing_mm(kDark + 0.1 * (kBright - kDark)),
            2.4);  // of a Gaussian of 1.2 mm: 3.1
  EXPECT_NEAR(across[5], kDark, 0.5 * kGreyPerDb);
  EXPECT_NEAR(across[58], kBright, 0.5 * kGreyPerDb);
}

TEST(TissueLevel, KeepsAVesselDark) {
  std::mt19937 random(5);
  Volume volume = volumeOf({48, 48, 24}, 0.5);
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 48; ++j)
      for (int i = 0; i < 48; ++i) {
        const bool isLumen = std::hypot(i - 23.5, j - 23.5) * 0.5 < 2.0;
        volume.echo[volume.grid.indexOf(i, j, k)] = speckle(isLumen ? 50.0 : 130.0, random, 3);
      }
  const auto level = madeOf(volume);
  EXPECT_LT(level[volume.grid.indexOf(23, 23, 12)], 50.0 + 3.0 * kGreyPerDb);
  EXPECT_NEAR(level[volume.grid.indexOf(23, 40, 12)], 130.0, 2.0 * kGreyPerDb);
}

TEST(TissueLevel, IsNothingWhereNothingWasRecordedAndTheRimIsAsBrightAsTheInside) {
  std::mt19937 random(11);
  Volume volume = volumeOf({40, 40, 40}, 0.5);
  volume.coverage.assign(volume.grid.voxelCount(), 0);
  for (std::size_t n = 0; n < volume.echo.size(); ++n) {
    if (n % 40 < 15) continue;
    volume.coverage[n] = static_cast<std::uint8_t>(n % 40 < 20 ? Coverage::interpolated : Coverage::measured);
    volume.echo[n] = speckle(140.0, random);
  }
  Volume unknown = volume;  // nobody knows what was covered: black is
  unknown.coverage.clear();
  for (const Volume& each : {volume, unknown}) {
    const auto level = madeOf(each);
    double rim = 0.0;
    for (std::size_t n = 0; n < level.size(); ++n) {
      ASSERT_EQ(level[n] > 0, n % 40 >= 15) << n % 40;
      if (n % 40 == 15) rim += level[n] / 1600.0;
    }
    EXPECT_NEAR(rim, 140.0, 0.4 * kGreyPerDb);
  }
}

TEST(TissueLevel, FillsTheBlackDotsOfSpeckleAndLeavesMeasuredBlackBlack) {
  Volume volume = volumeOf({30, 30, 30}, 0.5);
  std::fill(volume.echo.begin(), volume.echo.end(), std::uint8_t{120});
  volume.echo[volume.grid.indexOf(15, 15, 15)] = 0;
  EXPECT_NEAR(madeOf(volume)[volume.grid.indexOf(15, 15, 15)], 120.0, 1.0);
  std::fill(volume.echo.begin(), volume.echo.end(), std::uint8_t{0});
  volume.coverage.assign(volume.grid.voxelCount(), static_cast<std::uint8_t>(Coverage::measured));
  EXPECT_EQ(madeOf(volume)[volume.grid.indexOf(15, 15, 15)], 1);  // recorded, and as dark as can be
}

TEST(TissueLevel, IsTheSameForEveryNumberOfThreadsAndEverySizeOfBlocks) {
  std::mt19937 random(13);
  Volume volume = volumeOf({53, 37, 29}, 0.6);
  volume.grid.spacing_mm.z = 1.1;
  for (int k = 0; k < 29; ++k)
    for (int j = 0; j < 37; ++j)
      for (int i = 0; i < 53; ++i)  // edges everywhere
        volume.echo[volume.grid.indexOf(i, j, k)] = speckle((i / 5 + j / 7 + k / 3) % 2 == 0 ? 60.0 : 170.0, random, 3);
  for (std::size_t n = 0; n < volume.echo.size(); n += 7) volume.echo[n] = 0;
  LevelOptions options;
  options.threads = 1;
  options.block_voxels = 256;
  const auto whole = madeOf(volume, options);
  for (const int threads : {1, 2, 8})
    for (const int edge : {8, 13, 64}) {
      options.threads = threads;
      options.block_voxels = edge;
      EXPECT_TRUE(madeOf(volume, options) == whole) << threads << " threads, blocks of " << edge;
    }
}

TEST(TissueLevel, CostsByTheNumberOfVoxelsHoweverFineTheyAre) {
  LevelOptions options = plain();
  options.threads = 1;
  for (const double spacing_mm : {0.3, 0.1, 0.04, 0.013})
    EXPECT_LT(levelForecast_bytes(volumeOf({92, 92, 92}, spacing_mm).grid, options), 64u << 20) << spacing_mm;
  EXPECT_LT(levelForecast_bytes(volumeOf({92, 92, 92}, 0.013).grid, options), 4u << 20);

  // A step between two tissues 3 mm wide each, in voxels of 0.05 mm: where it is and as bright as they are.
  std::mt19937 random(5);
  constexpr double kDark = 90.0, kBright = 150.0;
  Volume volume = volumeOf({121, 24, 24}, 0.05);
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 24; ++j)
      for (int i = 0; i < 121; ++i) volume.echo[volume.grid.indexOf(i, j, k)] = speckle(i < 60 ? kDark : kBright, random, 3);
  const auto level = madeOf(volume);
  std::vector<double> across(121, 0.0);
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 24; ++j)
      for (int i = 0; i < 121; ++i) across[static_cast<std::size_t>(i)] += level[volume.grid.indexOf(i, j, k)] / (24.0 * 24.0);
  EXPECT_NEAR(across[3], kDark, 0.7 * kGreyPerDb);
  EXPECT_NEAR(across[117], kBright, 0.7 * kGreyPerDb);
  const auto crossing = std::find_if(across.begin(), across.end(), [](double grey) { return grey > 0.5 * (kDark + kBright); });
  EXPECT_NEAR(0.05 * static_cast<double>(crossing - across.begin()), 3.0, 0.25);
  LevelOptions parts = plain();
  parts.block_voxels = 43;  // blocks that begin between voxels that count
  EXPECT_TRUE(madeOf(volume, parts) == level);
}

TEST(TissueLevel, OfThinIslandsBetweenVoxelsThatCountIsNeverNothing) {
  // Of voxels of 0.05 mm every fourth counts. No island has one; the slab beside them is near enough for the wide Gaussian of some, and
  // for the narrow one of fewer.
  Volume volume = volumeOf({121, 24, 24}, 0.05);
  volume.coverage.assign(volume.grid.voxelCount(), 0);
  const auto cover = [&](int i, int step) {
    for (int k = 0; k < 24; k += step)
      for (int j = 0; j < 24; j += step) {
        volume.coverage[volume.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(Coverage::measured);
        volume.echo[volume.grid.indexOf(i, j, k)] = 120;
      }
  };
  for (int i = 0; i < 8; ++i) cover(i, 1);
  for (int i = 10; i < 121; i += 4) cover(i, i % 3 == 0 ? 1 : 5);
  const auto level = madeOf(volume);
  for (std::size_t n = 0; n < level.size(); ++n) ASSERT_EQ(level[n] > 0, volume.coverage[n] != 0) << n % 121;
  EXPECT_NEAR(level[volume.grid.indexOf(6, 12, 12)], 120.0, 1.0);
}

TEST(TissueLevel, ShowsTheGreyOfTheRecordingThroughTheCurveItWasShownWith) {
  const std::array<float, 256> levels = levelsShownAs(GreyMap::clinical);
  const Tone tone{.map = GreyMap::clinical};
  for (int grey = 0; grey < 256; ++grey)
    EXPECT_NEAR(shownLevel(tone, static_cast<double>(levels[static_cast<std::size_t>(grey)])), grey, 0.01) << grey;
  EXPECT_TRUE(std::is_sorted(levels.begin(), levels.end()));
  // Even grey 34, as a liver is shown: live echoes add their gain to its level, and the clinical map makes it 34 again.
  Volume volume = volumeOf({20, 20, 20}, 1.0);
  std::fill(volume.echo.begin(), volume.echo.end(), std::uint8_t{34});
  const double level = meanOf(madeOf(volume, LevelOptions{}));
  EXPECT_NEAR(shownLevel(tone, level + kGreyPerDb * kLevelGain_db), 34.0, 1.0);
}

TEST(TissueLevel, SaysWhatItNeedsAndStopsWhenAsked) {
  Volume volume = volumeOf({60, 60, 60}, 0.5);
  LevelOptions options = plain();
  options.threads = 64;
  const auto forecast = levelForecast_bytes(volume.grid, options);
  options.maxBytes = forecast / 2;
  EXPECT_LE(levelForecast_bytes(volume.grid, options), std::max(options.maxBytes, forecast));
  options.maxBytes = 1000;
  EXPECT_EQ(levelOf(volume, options).error().code, ErrorCode::tooLarge);
  options = plain();
  options.sigma_mm = 0.0;
  EXPECT_EQ(levelOf(volume, options).error().code, ErrorCode::badField);

  struct Stop final : Progress {
    void report(const Message&, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return true; }
  } stop;
  EXPECT_EQ(levelOf(volume, plain(), stop).error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace ew::tissue_level_test
