#include "ew/stitching/join.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <atomic>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "memory_in_use.h"
#include "stitching/views.h"

namespace ew::stitching::join_test {
namespace {

JoinResult joined(const std::vector<View>& views, const JoinOptions& options, Progress& progress = noProgress()) {
  const Grid grid = gridFor(views, options.grid);
  auto seams = findSeams(views, grid, options.seam, progress);
  EXPECT_TRUE(seams) << (seams ? "" : seams.error().sentence());
  if (!seams) return {};
  auto result = join(views, *seams, grid, options, progress);
  EXPECT_TRUE(result) << (result ? "" : result.error().sentence());
  return result ? std::move(*result) : JoinResult{};
}

/// Writes blocks where they belong, and counts voxels so that one written twice shows.
class CheckingSink final : public BlockSink {
 public:
  explicit CheckingSink(const Grid& whole)
      : grid(whole), echo(whole.voxelCount()), coverage(echo.size()), source(echo.size()), times(echo.size()) {}
  Result<void> put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> e, std::span<const std::uint8_t> c,
                   std::span<const std::uint8_t> s) override {
    std::size_t from = 0;
    for (int k = 0; k < size.z; ++k)
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i, ++from) {
          const std::size_t to = grid.indexOf(corner.x + i, corner.y + j, corner.z + k);
          echo[to] = e[from];
          coverage[to] = c[from];
          source[to] = s[from];
          ++times[to];
        }
    return {};
  }
  Grid grid;
  std::vector<std::uint8_t> echo, coverage, source, times;
};

/// Takes what comes and keeps nothing.
class CountingSink final : public BlockSink {
 public:
  Result<void> put(const glm::ivec3&, const glm::ivec3&, std::span<const std::uint8_t> e, std::span<const std::uint8_t>,
                   std::span<const std::uint8_t>) override {
    voxels += e.size();
    return {};
  }
  std::size_t voxels = 0;
};

class FullSink final : public BlockSink {
 public:
  Result<void> put(const glm::ivec3&, const glm::ivec3&, std::span<const std::uint8_t>, std::span<const std::uint8_t>,
                   std::span<const std::uint8_t>) override {
    return failure(ErrorCode::notWritable, verbatim("The disk is full."));
  }
};

/// Three speckled views, turned, warped and corrected, one with holes: nothing about them is symmetric.
struct Crooked {
  Volume a = speckled(gridOf({46, 40, 36}), 1);
  Volume b = speckled(gridOf({40, 44, 30}, {3.0, -2.0, 1.0}, 1.1), 2);
  Volume c = speckled(gridOf({30, 30, 44}, {1.0, 0.0, -4.0}, 0.9), 3);
  std::vector<std::uint8_t> confidence;
  registration::ControlGrid warp;
  std::vector<View> views;

  Crooked() {
    b.coverage.assign(b.echo.size(), 2);
    for (std::size_t v = 0; v < b.echo.size(); v += 7) b.coverage[v] = static_cast<std::uint8_t>(v % 3);
    for (std::size_t v = 0; v < a.echo.size(); ++v) confidence.push_back(static_cast<std::uint8_t>(v * 31 % 256));
    warp.nodes = gridOf({7, 6, 5}, {-20, -15, -12}, 14.0);
    for (std::size_t n = 0; n < warp.nodes.voxelCount(); ++n)
      warp.displacement_mm.emplace_back(2.0 * std::sin(1.0 * static_cast<double>(n)), 1.5 * std::cos(2.0 * static_cast<double>(n)),
                                        std::sin(3.0 * static_cast<double>(n)));
    views = {viewOf(a, "a"), viewOf(b, "b", moved(19.3, 7.1, -2.7) * glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(0, 0.6, 0.8))),
             viewOf(c, "c", moved(9.0, 22.0, 5.0) * glm::rotate(glm::dmat4(1.0), -0.3, glm::dvec3(1, 0, 0)))};
    views[0].confidence = confidence;
    views[1].warp = &warp;
    views[2].correction = {Beams{{0.0, 0.0, 1.0}}, -5.0, 10.0, {-12.0, 3.0, 20.0}};
  }
};

TEST(Join, MakesTheSameVoxelsInBlocksOfAnySizeAsInOnePiece) {
  const Crooked crooked;
  for (const SeamMethod method : {SeamMethod::feather, SeamMethod::nearest, SeamMethod::graphCut})
    for (const double blend_mm : {0.0, 2.5}) {
      JoinOptions options;
      options.grid.spacing_mm = 0.8;
      options.seam.method = method;
      options.seam.blend_mm = blend_mm;
      options.block = 1000;
      const Grid grid = gridFor(crooked.views, options.grid);
      const auto seams = findSeams(crooked.views, grid, options.seam, noProgress());
      ASSERT_TRUE(seams);
      const auto whole = join(crooked.views, *seams, grid, options, noProgress());
      ASSERT_TRUE(whole);
      for (const int block : {11, 33}) {
        options.block = block;
        CheckingSink sink(grid);
        const auto report = join(crooked.views, *seams, grid, options, sink, noProgress());
        ASSERT_TRUE(report);
        EXPECT_EQ(sink.echo, whole->volume.echo) << static_cast<int>(method) << ' ' << block;
        EXPECT_EQ(sink.coverage, whole->volume.coverage);
        EXPECT_EQ(sink.source, whole->source);
        EXPECT_EQ(sink.times, std::vector<std::uint8_t>(grid.voxelCount(), 1));
        EXPECT_EQ(report->contributions, whole->report.contributions);
        EXPECT_EQ(report->overlapShare, whole->report.overlapShare);
      }
    }
}

TEST(Join, GivesTheSameVoxelsOnAnyNumberOfThreads) {
  const Crooked crooked;
  JoinOptions options;
  options.seam.threads = options.grid.threads = 1;
  const auto one = joined(crooked.views, options);
  for (const int threads : {2, 8}) {
    options.seam.threads = options.grid.threads = threads;
    const auto many = joined(crooked.views, options);
    EXPECT_EQ(many.volume, one.volume);
    EXPECT_EQ(many.source, one.source);
    EXPECT_EQ(many.report.disagreementRms, one.report.disagreementRms);
    EXPECT_EQ(many.report.seam.derivativeRatio, one.report.seam.derivativeRatio);
  }
}

TEST(Join, PassesOneViewUnchangedOnItsOwnGrid) {
  Volume volume = speckled(gridOf({21, 17, 13}, {3.3, -2.2, 1.1}, 0.7), 5);
  volume.coverage.assign(volume.echo.size(), 2);
  for (std::size_t v = 0; v < volume.echo.size(); v += 5) volume.coverage[v] = static_cast<std::uint8_t>(v % 3);
  for (std::size_t v = 0; v < volume.echo.size(); ++v)
    if (volume.coverage[v] == 0) volume.echo[v] = 0;
  for (const SeamMethod method : {SeamMethod::feather, SeamMethod::nearest, SeamMethod::graphCut}) {
    JoinOptions options;
    options.seam.method = method;
    const auto result = joined({viewOf(volume, "a")}, options);
    EXPECT_EQ(result.volume.echo, volume.echo);
    EXPECT_EQ(result.volume.coverage, volume.coverage);
  }
}

TEST(Join, BendsAViewAsItsControlGridSays) {
  // The view is a ramp of 2 levels a mm along x; the warp asks, at world point p, for the view's point p + u(p).
  const Volume ramp = volumeOf(gridOf({60, 20, 20}), [](const glm::dvec3& p) { return 2.0 * p.x; });
  registration::ControlGrid warp;
  warp.nodes = gridOf({4, 3, 3}, {0, 0, 0}, 20.0);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i) warp.displacement_mm.emplace_back(1.5 * i - 2.0 * j + 1.0, 0.0F, 0.0F);
  View view = viewOf(ramp, "a");
  view.warp = &warp;
  JoinOptions options;
  options.seam.method = SeamMethod::nearest;
  const auto result = joined({view}, options);
  int compared = 0;
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 8; i < 52; ++i) {
        const double x = i + 1.5 * i / 20.0 - 2.0 * j / 20.0 + 1.0;
        const std::size_t at = result.volume.grid.indexOf(i, j, k);
        if (x < 0.0 || x > 59.0) continue;
        // Half a level of rounding; displacements are kept as float.
        EXPECT_NEAR(result.volume.echo[at], 2.0 * x, 0.5 + 1e-4);
        ++compared;
      }
  EXPECT_GT(compared, 15000);
}

TEST(Join, AddsTheCorrectionOfAViewAtItsDepth) {
  const Volume flat = constant(gridOf({10, 10, 41}), 100);
  View view = viewOf(flat, "a", moved(50, 0, 0) * glm::rotate(glm::dmat4(1.0), 1.0, glm::dvec3(0, 1, 0)));  // depth stays the view's own
  view.correction = {Beams{{0.0, 0.0, 1.0}}, 10.0, 10.0, {5.0, -5.0, 25.0}};
  JoinOptions options;
  options.seam.method = SeamMethod::nearest;
  const auto result = joined({view}, options);
  for (int k = 0; k <= 40; ++k) {
    const double expected = k <= 10 ? 105 : k <= 20 ? 105 - (k - 10) : k <= 30 ? 95 + 3 * (k - 20) : 125;
    EXPECT_NEAR(view.correction.at({3, 4, k}), expected - 100.0, 1e-12);
    EXPECT_EQ(result.volume.echo[result.volume.grid.indexOf(5, 5, k)], expected) << k;
  }
}

TEST(Join, AddsTheCorrectionOfAFanAlongItsBeams) {
  const Volume flat = constant(gridOf({61, 41, 10}), 100);
  View view = viewOf(flat, "a");
  view.correction = {
      Beams{{0.0, 1.0, 0.0}, Beams::Fan{{30.0, -20.0, 0.0}, {30.0, -20.0, 9.0}}}, 20.0, 10.0, {0.0, 10.0, 20.0, 30.0, 40.0, 50.0}};
  JoinOptions options;
  options.seam.method = SeamMethod::nearest;
  const auto result = joined({view}, options);
  for (const glm::ivec3 at : {glm::ivec3(30, 10, 4), glm::ivec3(60, 20, 4), glm::ivec3(0, 20, 9), glm::ivec3(12, 4, 0)}) {
    const double depth = glm::distance(glm::dvec2(at), glm::dvec2(30.0, -20.0));
    EXPECT_NEAR(result.volume.echo[result.volume.grid.indexOf(at.x, at.y, at.z)], 100.0 + depth - 20.0, 0.51) << at.x;
  }
}

TEST(Join, LeavesWhatWasNotReceivedBlackWhateverTheCorrection) {
  const Volume black = constant(gridOf({6, 6, 6}), 0);
  View view = viewOf(black, "a");
  view.correction.grey = {40.0};
  JoinOptions options;
  options.seam.method = SeamMethod::nearest;
  for (const std::uint8_t echo : joined({view}, options).volume.echo) EXPECT_EQ(echo, 0);
}

TEST(Join, PassesOnWhatTheSinkSays) {
  const Volume one = constant(gridOf({20, 20, 20}), 9);
  const std::vector<View> views = {viewOf(one, "a")};
  const Grid grid = gridFor(views, {});
  const auto seams = findSeams(views, grid, {}, noProgress());
  ASSERT_TRUE(seams);
  FullSink sink;
  const auto result = join(views, *seams, grid, {}, sink, noProgress());
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, verbatim("The disk is full."));
}

TEST(Join, RefusesSeamsThatBelongToAnotherGrid) {
  const Volume one = constant(gridOf({20, 20, 20}), 9);
  const std::vector<View> views = {viewOf(one, "a")};
  const Grid grid = gridFor(views, {});
  auto seams = findSeams(views, grid, {}, noProgress());
  ASSERT_TRUE(seams);
  Grid other = grid;
  other.origin_mm.x += 0.7;
  EXPECT_EQ(join(views, *seams, other, {}, noProgress()).error().code, ErrorCode::badField);
  seams->view.front() = 2;
  EXPECT_EQ(join(views, *seams, grid, {}, noProgress()).error().code, ErrorCode::badField);
}

TEST(Join, TakesEachVoxelFromTheViewInWhichItLiesDeepest) {
  const Volume left = constant(gridOf({40, 30, 30}), 100);
  const Volume right = constant(gridOf({40, 30, 30}), 200);
  JoinOptions options;
  options.seam.method = SeamMethod::nearest;
  options.seam.cell_mm = 1.0;
  options.seam.blend_mm = 0.0;
  const auto result = joined({viewOf(left, "left"), viewOf(right, "right", moved(20, 0, 0))}, options);
  const Grid& grid = result.volume.grid;
  EXPECT_EQ(grid.dims, glm::ivec3(60, 30, 30));
  for (int i = 0; i < 60; ++i) EXPECT_EQ(result.volume.echo[grid.indexOf(i, 15, 15)], i < 30 ? 100 : 200) << i;
  EXPECT_NEAR(result.report.overlapShare, 1.0 / 3.0, 1e-12);
}

TEST(Join, BlendsOverTheWidthAskedForAndNoWider) {
  const Volume left = constant(gridOf({80, 60, 60}, {}, 0.5), 100);
  const Volume right = constant(gridOf({80, 60, 60}, {}, 0.5), 180);
  JoinOptions options;
  options.seam.method = SeamMethod::nearest;
  options.seam.blend_mm = 2.5;
  const auto result = joined({viewOf(left, "left"), viewOf(right, "right", moved(20, 0, 0))}, options);
  const Grid& grid = result.volume.grid;
  // The overlap runs from 20 to 39.5 mm; its middle is the seam.
  for (int i = 0; i < grid.dims.x; ++i) {
    const double across_mm = 0.5 * i - 29.75;
    const double expected = std::clamp(140.0 + 40.0 * across_mm / 2.5, 100.0, 180.0);
    EXPECT_NEAR(result.volume.echo[grid.indexOf(i, 30, 30)], expected, 8.0) << across_mm;
    if (std::abs(across_mm) > 3.3) {
      EXPECT_EQ(result.volume.echo[grid.indexOf(i, 30, 30)], across_mm < 0 ? 100 : 180) << across_mm;
    }
  }
}

TEST(FindSeams, GivesWhatAStrokeCoversToTheViewItNamesWhereThatCovers) {
  const Volume left = constant(gridOf({40, 30, 30}), 100);
  const Volume right = constant(gridOf({40, 30, 30}), 200);
  const std::vector<View> views = {viewOf(left, "left"), viewOf(right, "right", moved(20, 0, 0))};
  const Grid grid = gridFor(views, {});
  for (const SeamMethod method : {SeamMethod::nearest, SeamMethod::graphCut}) {
    SeamOptions options;
    options.method = method;
    options.cell_mm = 1.0;
    options.strokes = {{0, {36, 15, 15}, 4.5}, {1, {10, 15, 15}, 6.0}};
    const auto map = findSeams(views, grid, options, noProgress());
    ASSERT_TRUE(map);
    for (int k = 0; k < 30; ++k)
      for (int j = 0; j < 30; ++j)
        for (int i = 0; i < 60; ++i) {
          const std::uint8_t own = map->view[map->cells.indexOf(i, j, k)];
          const glm::dvec3 p(i, j, k);
          if (i < 20) {
            EXPECT_EQ(own, 1) << "the right view covers nothing there, stroke or not";
          }
          if (i >= 40) {
            EXPECT_EQ(own, 2);
          }
          if (i < 40 && glm::distance(p, glm::dvec3(36, 15, 15)) < 4.0) {
            EXPECT_EQ(own, 1);
          }
        }
  }
}

/// Samples the memory in use whenever it is asked.
class WatchedMemory final : public Progress {
 public:
  void report(const Message&, double) override { look(); }
  bool cancelRequested() const override {
    look();
    return false;
  }
  [[nodiscard]] std::uint64_t most() const { return most_ - atFirst_; }

 private:
  void look() const {
    const std::uint64_t now = test::memoryInUse_bytes();
    std::uint64_t known = most_;
    while (known < now && !most_.compare_exchange_weak(known, now)) {
    }
  }
  std::uint64_t atFirst_ = test::memoryInUse_bytes();
  mutable std::atomic<std::uint64_t> most_{atFirst_};
};

TEST(ForecastJoin, IsWhatIsTakenAtThePeak) {
  const Volume a = speckled(gridOf({140, 130, 120}, {}, 0.5), 1);
  const Volume b = speckled(gridOf({140, 130, 120}, {}, 0.5), 2);
  const std::vector<View> views = {viewOf(a, "a"),
                                   viewOf(b, "b", moved(30, 3, 2) * glm::rotate(glm::dmat4(1.0), 0.1, glm::dvec3(0, 0, 1)))};
  std::vector<GridPlacement> grids;
  for (const View& view : views) grids.push_back({view.volume->grid, view.toWorld, view.name});
  for (const SeamMethod method : {SeamMethod::feather, SeamMethod::graphCut}) {
    JoinOptions options;
    options.seam.method = method;
    options.grid.threads = options.seam.threads = 2;
    const auto forecast = forecastJoin(grids, options);
    ASSERT_TRUE(forecast);
    WatchedMemory memory;
    const auto seams = findSeams(views, forecast->grid, options.seam, memory);
    ASSERT_TRUE(seams);
    CountingSink sink;
    ASSERT_TRUE(join(views, *seams, forecast->grid, options, sink, memory));
    EXPECT_LE(memory.most(), forecast->bytes * 11 / 10) << static_cast<int>(method);
    EXPECT_GE(memory.most(), forecast->bytes / 3) << static_cast<int>(method);
  }
}

TEST(ForecastJoin, KnowsTheGridAndCountsBlocksNotTheWhole) {
  std::vector<GridPlacement> far;
  for (int n = 0; n < 2; ++n) {
    Grid grid = gridOf({1000, 1000, 500}, {}, 0.5);
    far.push_back({grid, moved(400.0 * n, 0, 0), "v"});
  }
  JoinOptions options;
  options.block = 128;
  const auto forecast = forecastJoin(far, options);
  ASSERT_TRUE(forecast);
  EXPECT_EQ(forecast->grid.dims, glm::ivec3(1800, 1000, 500));
  EXPECT_LT(forecast->bytes, 600ull << 20) << "900 million voxels are not held";
  options.grid.maxBytes = 1 << 20;
  EXPECT_EQ(forecastJoin(far, options).error().code, ErrorCode::tooLarge);
}

}  // namespace
}  // namespace ew::stitching::join_test
