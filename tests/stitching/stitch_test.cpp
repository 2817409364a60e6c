#include "ew/stitching/join.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <atomic>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "ew/stitching/distance.h"

namespace ew::stitching::stitch_test {
namespace {

Grid gridOf(glm::ivec3 dims, glm::dvec3 origin_mm = glm::dvec3(0.0), double spacing_mm = 1.0) {
  Grid grid;
  grid.dims = dims;
  grid.spacing_mm = glm::dvec3(spacing_mm);
  grid.origin_mm = origin_mm;
  return grid;
}

/// Echo from a function of the world position (the volume's own file coordinates).
template <class Level>
Volume volumeOf(const Grid& grid, Level level) {
  Volume volume{grid, std::vector<std::uint8_t>(grid.voxelCount()), {}};
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        volume.echo[grid.indexOf(i, j, k)] =
            static_cast<std::uint8_t>(level((grid.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at));
  return volume;
}
Volume constant(const Grid& grid, int level) {
  return volumeOf(grid, [level](const glm::dvec3&) { return level; });
}

struct PlacedVolume {
  Volume volume;
  Transform<frame::World, frame::View> toWorld = {};
  std::string name;
};
PlacedVolume at(Volume volume, const std::string& name = "a", const glm::dmat4& toWorld = glm::dmat4(1.0)) {
  return {std::move(volume), {toWorld}, name};
}
glm::dmat4 moved(double x, double y, double z) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z)); }

std::vector<GridPlacement> gridsOf(std::span<const PlacedVolume> inputs) {
  std::vector<GridPlacement> grids;
  for (const PlacedVolume& input : inputs) grids.push_back({input.volume.grid, input.toWorld, input.name});
  return grids;
}

/// Feathered on the common grid.
Result<JoinResult> stitch(std::span<const PlacedVolume> inputs, const StitchOptions& options, Progress& progress) {
  const auto forecast = forecastStitch(gridsOf(inputs), options);
  if (!forecast) return passOn(forecast.error());
  std::vector<View> views;
  for (const PlacedVolume& input : inputs) {
    views.emplace_back();
    views.back().volume = &input.volume;
    views.back().toWorld = input.toWorld;
    views.back().name = input.name;
  }
  JoinOptions how;
  how.grid = options;
  how.seam.method = SeamMethod::feather;
  return join(views, {}, forecast->grid, how, progress);
}

JoinResult stitched(const std::vector<PlacedVolume>& inputs, const StitchOptions& options = {}) {
  auto result = stitch(inputs, options, noProgress());
  EXPECT_TRUE(result) << (result ? "" : result.error().sentence());
  return result ? std::move(*result) : JoinResult{};
}

std::uint8_t echoAt(const JoinResult& result, const glm::dvec3& p_world_mm) {
  const Grid& grid = result.volume.grid;
  const glm::ivec3 ijk(glm::round((grid.worldToVoxel() * Point<frame::World>{p_world_mm}).at));
  EXPECT_TRUE(grid.contains(ijk));
  return grid.contains(ijk) ? result.volume.echo[grid.indexOf(ijk.x, ijk.y, ijk.z)] : std::uint8_t{0};
}

class CancelAtOnce final : public Progress {
 public:
  void report(const Message&, double) override {}
  bool cancelRequested() const override { return true; }
};

/// Checks what Progress promises: from 0 to 1 and never backwards.
class WatchedProgress final : public Progress {
 public:
  void report(const Message&, double fraction) override {
    if (fraction < last || fraction > 1.0 + 1e-12) ok = false;
    last = fraction;
  }
  bool cancelRequested() const override { return false; }
  double last = 0.0;
  bool ok = true;
};

TEST(Stitch, PassesOneVolumeUnchangedOnItsOwnGrid) {
  Grid grid = gridOf({7, 5, 4}, {3.3, -2.2, 1.1});
  grid.spacing_mm = {0.3, 0.7, 1.9};
  grid.directions = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, 3))));
  grid.directions[2] = -grid.directions[2];  // left-handed
  Volume volume{grid, {}, {}};
  for (std::size_t i = 0; i < grid.voxelCount(); ++i) {
    volume.echo.push_back(static_cast<std::uint8_t>((i * 37) % 251 + 1));
    volume.coverage.push_back(static_cast<std::uint8_t>(i % 3));
    if (volume.coverage.back() == 0) volume.echo.back() = 0;
  }
  const auto result = stitched({at(volume)});
  EXPECT_EQ(result.volume.grid.dims, grid.dims);
  EXPECT_EQ(result.volume.grid.spacing_mm, grid.spacing_mm);
  EXPECT_LT(glm::length(result.volume.grid.origin_mm - grid.origin_mm), 1e-12);
  EXPECT_EQ(result.volume.echo, volume.echo);
  EXPECT_EQ(result.volume.coverage, volume.coverage);
}

TEST(Stitch, BlendsLinearlyAcrossTheFeatherOfTwoOverlappingVolumes) {
  // Two bars of 20 voxels that overlap in 10. With the feather as wide as the overlap both weights are ramps: at overlap voxel n the left
  // bar is 10 - n voxels from its border (the first absent voxel), the right one n + 1.
  const auto left = constant(gridOf({20, 25, 25}), 100);
  const auto right = constant(gridOf({20, 25, 25}, {10, 0, 0}), 210);
  const auto result = stitched({at(left, "left"), at(right, "right")}, {.featherWidth_mm = 11.0});
  EXPECT_EQ(result.volume.grid.dims, glm::ivec3(30, 25, 25));
  for (int n = 0; n < 10; ++n) {
    const double wl = 10.0 - n, wr = n + 1.0;
    const double expected = (wl * 100.0 + wr * 210.0) / (wl + wr);
    EXPECT_EQ(echoAt(result, {10.0 + n, 12, 12}), static_cast<int>(std::floor(expected + 0.5))) << n;
  }
  EXPECT_EQ(echoAt(result, {9, 12, 12}), 100);
  EXPECT_EQ(echoAt(result, {20, 12, 12}), 210);
  EXPECT_NEAR(result.report.overlapShare, 1.0 / 3.0, 1e-12);
}

TEST(Stitch, KeepsARampThatBothVolumesShowExactly) {
  const auto ramp = [](const glm::dvec3& p) { return 3 * p.x + 2 * p.y + p.z; };
  const Grid a = gridOf({20, 12, 10});
  const Grid b = gridOf({18, 14, 9}, {11, 3, 2});
  const auto result = stitched({at(volumeOf(a, ramp)), at(volumeOf(b, ramp), "b")});
  const Grid& grid = result.volume.grid;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        if (result.volume.coverage[grid.indexOf(i, j, k)] != 0) {
          ASSERT_EQ(result.volume.echo[grid.indexOf(i, j, k)], ramp(glm::dvec3(i, j, k))) << i << ' ' << j << ' ' << k;
        }
  EXPECT_EQ(result.report.disagreementRms, 0.0);
}

TEST(Stitch, SamplesARampLinearlyBetweenTheVoxels) {
  // Level 4 x on a 2 mm grid: on the 1 mm grid every voxel between two centres must hold exactly their mean.
  const auto result =
      stitched({at(volumeOf(gridOf({16, 4, 4}, glm::dvec3(0.0), 2.0), [](const glm::dvec3& p) { return 4 * p.x; }))}, {.spacing_mm = 1.0});
  EXPECT_EQ(result.volume.grid.dims, glm::ivec3(31, 7, 7));
  for (int x = 0; x <= 30; ++x) EXPECT_EQ(echoAt(result, {x, 3, 3}), 4 * x);
}

TEST(Stitch, KeepsTheGapsOfAVolumeAndFillsThemOnlyFromAnother) {
  Volume holed = constant(gridOf({9, 9, 9}), 200);
  holed.coverage.assign(holed.echo.size(), 2);
  const std::size_t hole = holed.grid.indexOf(4, 4, 4);
  holed.coverage[hole] = 0;
  holed.echo[hole] = 0;
  const auto alone = stitched({at(holed)});
  EXPECT_EQ(alone.volume.coverage[hole], 0);
  EXPECT_EQ(alone.volume.echo[hole], 0);
  EXPECT_EQ(alone.source[hole], 0);
  EXPECT_EQ(alone.volume.echo[hole + 1], 200) << "the absent neighbour's 0 must not bleed into the covered voxel";

  const auto filled = stitched({at(holed, "holed"), at(constant(holed.grid, 50), "whole")});
  EXPECT_EQ(filled.volume.echo[hole], 50);
  EXPECT_EQ(filled.source[hole], 2);
}

TEST(Stitch, NeverMixesAbsentVoxelsIntoASampleBetweenVoxels) {
  Volume half = constant(gridOf({10, 4, 4}), 120);
  half.coverage.assign(half.echo.size(), 2);
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 5; i < 10; ++i) {
        half.coverage[half.grid.indexOf(i, j, k)] = 0;
        half.echo[half.grid.indexOf(i, j, k)] = 0;
      }
  const auto result = stitched({at(half)}, {.spacing_mm = 0.25});
  for (std::size_t i = 0; i < result.volume.echo.size(); ++i) ASSERT_EQ(result.volume.echo[i], result.volume.coverage[i] != 0 ? 120 : 0);
}

TEST(Stitch, WeighsInterpolatedVoxelsLessThanMeasuredOnes) {
  const Grid grid = gridOf({5, 5, 5});
  Volume measured = constant(grid, 200);
  Volume guessed = constant(grid, 100);
  guessed.coverage.assign(guessed.echo.size(), 1);
  const auto result = stitched({at(measured), at(guessed, "b")}, {.interpolatedWeight = 0.25});
  EXPECT_EQ(result.volume.echo.front(), 180);  // (200 + 100 / 4) / (1 + 1 / 4)
  EXPECT_EQ(result.volume.coverage.front(), 2);
  const auto onlyGuessed = stitched({at(guessed)});
  EXPECT_EQ(onlyGuessed.volume.echo.front(), 100);
  EXPECT_EQ(onlyGuessed.volume.coverage.front(), 1);
}

TEST(Stitch, KeepsBothOfTwoVolumesThatDoNotTouch) {
  const auto result = stitched({at(constant(gridOf({4, 4, 4}), 60), "a"), at(constant(gridOf({4, 4, 4}, {20, 0, 0}), 90), "b")});
  EXPECT_EQ(result.volume.grid.dims, glm::ivec3(24, 4, 4));
  EXPECT_EQ(result.report.contributions[0].voxels, 64u);
  EXPECT_EQ(result.report.contributions[1].voxels, 64u);
  EXPECT_EQ(result.report.overlapShare, 0.0);
  EXPECT_EQ(echoAt(result, {1, 1, 1}), 60);
  EXPECT_EQ(echoAt(result, {21, 1, 1}), 90);
  EXPECT_EQ(echoAt(result, {10, 1, 1}), 0);
  ASSERT_EQ(result.report.notes.size(), 1u);
}

TEST(Stitch, SaysWhenBlackVoxelsCountAsMeasuredForWantOfCoverage) {
  Volume dark = constant(gridOf({4, 4, 4}), 0);
  const auto warned = stitched({at(dark, "dark"), at(constant(gridOf({4, 4, 4}), 90), "bright")});
  ASSERT_EQ(warned.report.notes.size(), 1u);
  EXPECT_NE(warned.report.notes.front().english().find("'dark'"), std::string::npos);
  dark.coverage.assign(dark.echo.size(), 2);
  EXPECT_TRUE(stitched({at(dark, "dark"), at(constant(gridOf({4, 4, 4}), 90), "bright")}).report.notes.empty());
}

TEST(Stitch, PlacesAVolumeWithItsMatrix) {
  // A quarter turn about z takes the file's x to the world's y.
  const glm::dmat4 turn = moved(100, 0, 0) * glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
  const auto result =
      stitched({at(volumeOf(gridOf({10, 3, 3}), [](const glm::dvec3& p) { return 10 + 5 * p.x; }), "a", turn)}, {.axes = GridAxes::world});
  for (int x = 0; x < 10; ++x) EXPECT_EQ(echoAt(result, {99, x, 1}), 10 + 5 * x);
}

TEST(Stitch, GivesTheSameVoxelsOnAnyNumberOfThreads) {
  const auto level = [](const glm::dvec3& p) { return static_cast<int>(std::fmod(std::abs(p.x * 17 + p.y * 31 + p.z * 7), 256.0)); };
  const std::vector<PlacedVolume> inputs = {
      at(volumeOf(gridOf({30, 20, 15}), level), "a"),
      at(volumeOf(gridOf({25, 22, 18}), level), "b", moved(9.3, 4.1, -2.7) * glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(0, 0.6, 0.8)))};
  const auto one = stitched(inputs, {.threads = 1});
  for (const int threads : {2, 8}) {
    const auto many = stitched(inputs, {.threads = threads});
    EXPECT_EQ(many.volume, one.volume);
    EXPECT_EQ(many.source, one.source);
    EXPECT_EQ(many.report.disagreementRms, one.report.disagreementRms);
  }
}

TEST(Stitch, StopsWhenAskedTo) {
  CancelAtOnce cancel;
  const std::vector<PlacedVolume> inputs = {at(constant(gridOf({40, 40, 40}), 1))};
  const auto result = stitch(inputs, {}, cancel);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::cancelled);
}

TEST(Stitch, ReportsProgressThatNeverRunsBackwards) {
  WatchedProgress watched;
  const std::vector<PlacedVolume> inputs = {at(constant(gridOf({20, 20, 20}), 1)), at(constant(gridOf({20, 20, 20}, {5, 5, 5}), 3), "b")};
  ASSERT_TRUE(stitch(inputs, {}, watched));
  EXPECT_TRUE(watched.ok);
}

TEST(Stitch, RefusesWhatItCannotDoWithASentenceThatNamesTheVolume) {
  EXPECT_EQ(stitch(std::span<const PlacedVolume>(), {}, noProgress()).error().code, ErrorCode::emptyVolume);
  glm::dmat4 scaled(1.0);
  scaled[0][0] = 2.0;
  const std::vector<PlacedVolume> stretched = {at(constant(gridOf({4, 4, 4}), 1), "left lobe", scaled)};
  const auto notRigid = stitch(stretched, {}, noProgress());
  ASSERT_FALSE(notRigid);
  EXPECT_EQ(notRigid.error().code, ErrorCode::notRigid);
  EXPECT_NE(notRigid.error().sentence().find("left lobe"), std::string::npos);

  const std::vector<PlacedVolume> fine = {at(constant(gridOf({4, 4, 4}), 1))};
  for (const auto& wrong : {StitchOptions{.spacing_mm = -1.0}, StitchOptions{.spacing_mm = std::nan("")},
                            StitchOptions{.featherWidth_mm = -0.1}, StitchOptions{.interpolatedWeight = 0.0}})
    EXPECT_EQ(stitch(fine, wrong, noProgress()).error().code, ErrorCode::badField);
}

TEST(Stitch, ForecastsMemoryAndRefusesBeforeTakingIt) {
  const std::vector<PlacedVolume> far = {at(constant(gridOf({4, 4, 4}), 1)), at(constant(gridOf({4, 4, 4}, {1e5, 1e5, 1e5}), 1), "b")};
  const auto refused = stitch(far, {}, noProgress());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  const std::vector<PlacedVolume> endless = {at(constant(gridOf({4, 4, 4}), 1)), at(constant(gridOf({4, 4, 4}, {1e300, 0, 0}), 1), "b")};
  EXPECT_EQ(stitch(endless, {}, noProgress()).error().code, ErrorCode::tooLarge);

  const std::vector<PlacedVolume> small = {at(constant(gridOf({10, 10, 10}), 1))};
  const auto forecast = forecastStitch(gridsOf(small), {});
  ASSERT_TRUE(forecast);
  EXPECT_EQ(forecast->bytes, 1000u * 3u + 1000u * 4u);
}

TEST(Stitch, ForecastsTheGridItThenMakes) {
  const std::vector<PlacedVolume> inputs = {at(constant(gridOf({10, 8, 6}), 9)),
                                            at(constant(gridOf({7, 7, 7}, glm::dvec3(0.0), 0.5), 9), "b",
                                               moved(3.7, -2.2, 8.8) * glm::rotate(glm::dmat4(1.0), 1.1, glm::dvec3(1, 0, 0)))};
  const auto forecast = forecastStitch(gridsOf(inputs), {});
  ASSERT_TRUE(forecast);
  EXPECT_EQ(stitched(inputs).volume.grid, forecast->grid);
}

RC_GTEST_PROP(Stitch, KeepsConstantsExactlyInAnyPlacement, ()) {
  const int level = *rc::gen::inRange(0, 256);
  std::vector<PlacedVolume> inputs;
  for (int n = *rc::gen::inRange(1, 4); n > 0; --n) {
    const auto angle = *rc::gen::inRange(0, 628) * 0.01;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(*rc::gen::inRange(1, 9), *rc::gen::inRange(-9, 9), *rc::gen::inRange(-9, 9)));
    const auto shift = moved(*rc::gen::inRange(-80, 80) * 0.1, *rc::gen::inRange(-80, 80) * 0.1, *rc::gen::inRange(-80, 80) * 0.1);
    const glm::ivec3 dims(*rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9));
    inputs.push_back(at(constant(gridOf(dims, glm::dvec3(0.0), *rc::gen::inRange(5, 20) * 0.1), level), "n",
                        shift * glm::rotate(glm::dmat4(1.0), angle, axis)));
  }
  const auto result = stitch(inputs, {.spacing_mm = 0.8}, noProgress());
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(result->report.contributions.front().voxels > 0u);
  for (std::size_t i = 0; i < result->volume.echo.size(); ++i)
    RC_ASSERT(result->volume.echo[i] == (result->volume.coverage[i] != 0 ? level : 0));
}

RC_GTEST_PROP(Stitch, DoesNotDependOnTheOrderOfTheVolumes, ()) {
  // World axes and a common spacing leave the order nothing to say but the lattice, which whole-mm shifts keep.
  std::vector<PlacedVolume> inputs;
  for (int n = 0; n < 3; ++n) {
    const Grid grid = gridOf({6, 5, 4}, {*rc::gen::inRange(-4, 5), *rc::gen::inRange(-4, 5), *rc::gen::inRange(-4, 5)});
    Volume volume{grid, *rc::gen::container<std::vector<std::uint8_t>>(grid.voxelCount(), rc::gen::arbitrary<std::uint8_t>()),
                  *rc::gen::container<std::vector<std::uint8_t>>(grid.voxelCount(), rc::gen::inRange<std::uint8_t>(0, 3))};
    inputs.push_back(at(std::move(volume), std::to_string(n)));
  }
  const StitchOptions options{.spacing_mm = 1.0, .featherWidth_mm = 2.5, .axes = GridAxes::world};
  const auto forward = stitch(inputs, options, noProgress());
  std::reverse(inputs.begin(), inputs.end());
  const auto backward = stitch(inputs, options, noProgress());
  RC_ASSERT(forward && backward);
  RC_ASSERT(forward->volume == backward->volume);
  RC_ASSERT(std::abs(forward->report.overlapShare - backward->report.overlapShare) < 1e-15);
}

RC_GTEST_PROP(Stitch, StaysBetweenTheDarkestAndTheBrightestInput, ()) {
  std::vector<PlacedVolume> inputs;
  int lowest = 255;
  int highest = 0;
  for (int n = 0; n < 2; ++n) {
    const Grid grid = gridOf({6, 6, 6});
    auto echo = *rc::gen::container<std::vector<std::uint8_t>>(grid.voxelCount(), rc::gen::inRange<std::uint8_t>(20, 230));
    for (const auto e : echo) {
      lowest = std::min<int>(lowest, e);
      highest = std::max<int>(highest, e);
    }
    inputs.push_back(
        at({grid, echo, {}}, "n", moved(0.37 * n, -0.61 * n, 0.2) * glm::rotate(glm::dmat4(1.0), 0.3 * n, glm::dvec3(0, 1, 0))));
  }
  const auto result = stitch(inputs, {.spacing_mm = 0.7}, noProgress());
  RC_ASSERT(static_cast<bool>(result));
  for (std::size_t i = 0; i < result->volume.echo.size(); ++i)
    if (result->volume.coverage[i] != 0) RC_ASSERT(result->volume.echo[i] >= lowest && result->volume.echo[i] <= highest);
}

RC_GTEST_PROP(DistanceFromBorder, IsTheDistanceToTheNearestAbsentVoxel, ()) {
  Grid grid = gridOf({*rc::gen::inRange(1, 8), *rc::gen::inRange(1, 8), *rc::gen::inRange(1, 8)});
  grid.spacing_mm = {*rc::gen::inRange(1, 30) * 0.1, *rc::gen::inRange(1, 30) * 0.1, *rc::gen::inRange(1, 30) * 0.1};
  Volume volume{
      grid, std::vector<std::uint8_t>(grid.voxelCount(), 9),
      *rc::gen::container<std::vector<std::uint8_t>>(grid.voxelCount(), rc::gen::weightedElement<std::uint8_t>({{1, 0}, {6, 2}}))};
  const double limit = *rc::gen::inRange(5, 60) * 0.1;
  const auto distance = distanceFromBorder_mm(volume, limit, 2, noProgress());
  RC_ASSERT(static_cast<bool>(distance));
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        double nearest = limit;
        for (int c = -1; c <= grid.dims.z; ++c)
          for (int b = -1; b <= grid.dims.y; ++b)
            for (int a = -1; a <= grid.dims.x; ++a)
              if (!grid.contains({a, b, c}) || volume.coverage[grid.indexOf(a, b, c)] == 0)
                nearest = std::min(nearest, glm::length(glm::dvec3(a - i, b - j, c - k) * grid.spacing_mm));
        RC_ASSERT(std::abs(static_cast<double>((*distance)[grid.indexOf(i, j, k)]) - nearest) < 1e-5);
      }
}

}  // namespace
}  // namespace ew::stitching::stitch_test
