#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "ew/io/image_file.h"
#include "ew/io/volume_stream.h"
#include "ew/phantom/speckle_view.h"
#include "ew/stitching/equalise_views.h"
#include "memory_in_use.h"
#include "stitching/views.h"

/// Seams of views whose truth is known: what measure 20 says of them, and that it says so of those that are bad.
namespace ew::stitching::seam_test {
namespace {

/// Two views of one scene, side by side along x with an overlap, as pairs of recipe and view.
struct TwoViews {
  SpeckleView left, right;
  std::vector<View> views;

  TwoViews(SpeckleViewRecipe l, SpeckleViewRecipe r) : left(speckledView(l, 0)), right(speckledView(r, 0)) {
    views = {viewOf(left.volume, "left", l.toWorld.matrix), viewOf(right.volume, "right", r.toWorld.matrix)};
    views[0].confidence = left.confidence;
    views[1].confidence = right.confidence;
  }
};

SpeckleViewRecipe leftRecipe(bool scene) {
  SpeckleViewRecipe recipe;
  recipe.dims = {110, 110, 90};
  recipe.scene = scene;
  recipe.speckle = 1;
  return recipe;
}
SpeckleViewRecipe rightRecipe(bool scene) {
  SpeckleViewRecipe recipe = leftRecipe(scene);
  recipe.origin_mm.x = 30.0;  // an overlap of 25 mm
  recipe.speckle = 2;
  return recipe;
}

JoinResult joined(const std::vector<View>& views, const JoinOptions& options) {
  const Grid grid = gridFor(views, options.grid);
  auto seams = findSeams(views, grid, options.seam, noProgress());
  EXPECT_TRUE(seams) << (seams ? "" : seams.error().sentence());
  auto result = join(views, *seams, grid, options, noProgress());
  EXPECT_TRUE(result) << (result ? "" : result.error().sentence());
  return std::move(*result);
}

void keepImage(const JoinResult& result, const std::string& name) {
  const char* folder = std::getenv("EW_SEAM_PICTURES");
  if (folder == nullptr) return;
  const Grid& grid = result.volume.grid;
  for (const bool sources : {false, true}) {
    GreyImage image(grid.dims.x, grid.dims.y);
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const std::size_t at = grid.indexOf(i, j, grid.dims.z / 2);
        viewOf(image).at(i, j) = sources ? static_cast<std::uint8_t>(result.source[at] * 60) : result.volume.echo[at];
      }
    std::ignore =
        writeImage(viewOf(std::as_const(image)), 0.5, std::filesystem::path(folder) / (name + (sources ? "-source.png" : ".png")));
  }
}

bool within(const SeamVisibility& seen) {
  return std::abs(seen.derivativeRatio - 1.0) <= 0.05 && seen.speckleRatio >= 0.95 && seen.speckleRatio <= 1.05 && seen.meanStep_db <= 0.5;
}
std::string textOf(const SeamVisibility& seen) {
  return "derivative " + std::to_string(seen.derivativeRatio) + ", speckle " + std::to_string(seen.speckleRatio) + ", step " +
         std::to_string(seen.meanStep_db) + " dB, voxels " + std::to_string(seen.voxels);
}

TEST(SeamVisibility, FindsNoSeamWhereOneViewMeetsItself) {
  // The same speckle on both sides: a seam is there only by name.
  SpeckleViewRecipe same = rightRecipe(true);
  same.speckle = 1;
  for (const bool scene : {false, true}) {
    same.scene = scene;
    const TwoViews two(leftRecipe(scene), same);
    const auto result = joined(two.views, {});
    keepImage(result, scene ? "same-scene" : "same-even");
    EXPECT_GT(result.report.seam.voxels, 5000u);
    EXPECT_TRUE(within(result.report.seam)) << textOf(result.report.seam);
  }
}

TEST(SeamVisibility, FailsARigidPasteAndALinearBlendOfIndependentSpeckle) {
  const TwoViews two(leftRecipe(false), rightRecipe(false));
  const auto good = joined(two.views, {});
  Volume pasted = good.volume;
  Volume blended = good.volume;
  std::vector<std::uint8_t> source = good.source;
  const Grid& grid = pasted.grid;
  const Grid& l = two.left.volume.grid;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const std::size_t at = grid.indexOf(i, j, k);
        source[at] = i < 85 ? 1 : 2;
        const bool hasLeft = i < l.dims.x;
        const bool hasRight = i >= 60;
        const double a = hasLeft ? two.left.volume.echo[l.indexOf(i, j, k)] : 0.0;
        const double b = hasRight ? two.right.volume.echo[l.indexOf(i - 60, j, k)] : 0.0;
        pasted.echo[at] = static_cast<std::uint8_t>(i < 85 ? a : b);
        const double share = std::clamp((i - 84.5) / 10.0 + 0.5, 0.0, 1.0);
        blended.echo[at] = static_cast<std::uint8_t>((1.0 - share) * a + share * b + 0.5);
      }
  const auto paste = seamVisibility(pasted, source, 2.5);
  EXPECT_GT(paste.derivativeRatio, 1.05) << textOf(paste);
  const auto blend = seamVisibility(blended, source, 2.5);
  EXPECT_LT(blend.speckleRatio, 0.95) << textOf(blend);
  EXPECT_TRUE(within(good.report.seam)) << textOf(good.report.seam);

  // A gain that nobody took off.
  Volume stepped = good.volume;
  for (std::size_t v = 0; v < stepped.echo.size(); ++v)
    if (good.source[v] == 2) stepped.echo[v] = static_cast<std::uint8_t>(std::min(255, stepped.echo[v] + 6));
  const auto step = seamVisibility(stepped, good.source, 2.5);
  EXPECT_NEAR(step.meanStep_db, 6.0 * 60.0 / 255.0, 0.3) << textOf(step);
}

TEST(SeamVisibility, IsMetByTheCutInAStructuredScene) {
  const TwoViews two(leftRecipe(true), rightRecipe(true));
  for (const SeamMethod method : {SeamMethod::feather, SeamMethod::nearest, SeamMethod::graphCut}) {
    JoinOptions options;
    options.seam.method = method;
    const auto result = joined(two.views, options);
    keepImage(result, "scene-" + std::to_string(static_cast<int>(method)));
    if (method == SeamMethod::feather)
      EXPECT_FALSE(within(result.report.seam)) << textOf(result.report.seam);
    else
      EXPECT_TRUE(within(result.report.seam)) << textOf(result.report.seam);
  }
}

TEST(Join, FillsAShadowFromTheOtherViewAtItsOwnLevel) {
  SpeckleViewRecipe shadowed = leftRecipe(true);
  shadowed.shadow = SpeckleViewRecipe::Shadow{38.0, 47.0, 15.0, 30.0};
  SpeckleViewRecipe other = rightRecipe(true);
  other.gain_db = 4.0;
  other.depthGain_db = 3.0;
  TwoViews two(shadowed, other);
  for (View& view : two.views) view.correction.beams = Beams{{0.0, 1.0, 0.0}};
  const auto before = joined(two.views, {});
  keepImage(before, "shadow-uncorrected");

  const auto equalised = equaliseViews(two.views, {}, noProgress());
  ASSERT_TRUE(equalised);
  EXPECT_EQ(equalised->groups, 1);
  EXPECT_GT(equalised->disagreementBefore_db, 3.0);
  EXPECT_LT(equalised->disagreementAfter_db, 1.3);  // of cells of 4 mm: speckle leaves so much
  for (std::size_t n = 0; n < 2; ++n) two.views[n].correction = equalised->corrections[n];
  // The gain between the views: -1 to 7 dB from the first row to the last.
  for (const double depth_mm : {5.0, 15.0, 30.0, 45.0, 52.0}) {
    const double found_db = (two.views[0].correction.at({0, depth_mm, 0}) - two.views[1].correction.at({0, depth_mm, 0})) * 60.0 / 255.0;
    EXPECT_NEAR(found_db, 4.0 + 3.0 * (2.0 * depth_mm / 54.5 - 1.0), 0.8) << depth_mm;
  }

  const auto result = joined(two.views, {});
  keepImage(result, "shadow-filled");
  EXPECT_TRUE(within(result.report.seam)) << textOf(result.report.seam);
  // Inside the shadow, away from its edges, the voxels are the other view's, at the level of the tissue.
  const Grid& grid = result.volume.grid;
  double sum = 0.0, truth = 0.0, other_ = 0.0, voxels = 0.0;
  for (int k = 5; k < grid.dims.z - 5; ++k)
    for (int j = 40; j < grid.dims.y - 5; ++j)
      for (int i = 84; i < 88; ++i) {
        const std::size_t at = grid.indexOf(i, j, k);
        other_ += result.source[at] == 2 ? 1.0 : 0.0;
        const double adds_db = two.views[1].correction.at(0.5 * glm::dvec3(i, j, k)) * 60.0 / 255.0;
        sum += result.volume.echo[at] * 60.0 / 255.0 - 60.0 - adds_db;
        truth += speckledScene_db(0.5 * glm::dvec3(i, j, k)) - 2.5 + 4.0 + 3.0 * (2.0 * j / 109.0 - 1.0);
        voxels += 1.0;
      }
  EXPECT_EQ(other_, voxels);
  EXPECT_NEAR(sum / voxels, truth / voxels, 0.4);
  // The nearest view would show the shadow.
  JoinOptions nearest;
  nearest.seam.method = SeamMethod::nearest;
  const auto dark = joined(two.views, nearest);
  keepImage(dark, "shadow-nearest");
  EXPECT_GT(dark.report.seam.meanStep_db, 3.0);
}

/// Blocks straight into files.
class FileSink final : public BlockSink {
 public:
  FileSink(VolumeStream echo, VolumeStream coverage, VolumeStream source)
      : echo_(std::move(echo)), coverage_(std::move(coverage)), source_(std::move(source)) {}
  Result<void> put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> echo,
                   std::span<const std::uint8_t> coverage, std::span<const std::uint8_t> source) override {
    echo_.put(corner, size, echo);
    coverage_.put(corner, size, coverage);
    source_.put(corner, size, source);
    most_bytes = std::max(most_bytes, test::memoryInUse_bytes());
    return {};
  }
  Result<void> finish() {
    for (VolumeStream* stream : {&echo_, &coverage_, &source_})
      if (auto done = stream->finish(); !done) return done;
    return {};
  }
  std::uint64_t most_bytes = 0;

 private:
  VolumeStream echo_, coverage_, source_;
};

/// The samples of an uncompressed .mha lie at its end.
std::vector<std::uint8_t> samplesOf(const std::filesystem::path& file, std::size_t voxels) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(-static_cast<std::streamoff>(voxels), std::ios::end);
  std::vector<std::uint8_t> samples(voxels);
  in.read(reinterpret_cast<char*>(samples.data()), static_cast<std::streamsize>(voxels));
  EXPECT_TRUE(in.good());
  return samples;
}

TEST(Join, MakesAWholeLargerThanItsMemoryIntoFiles) {
  SpeckleViewRecipe left = leftRecipe(true);
  SpeckleViewRecipe right = rightRecipe(true);
  left.dims = right.dims = {90, 80, 70};
  const TwoViews two(left, right);
  JoinOptions options;
  options.grid.spacing_mm = 0.3;
  options.block = 48;
  options.grid.threads = options.seam.threads = 2;
  const Grid grid = gridFor(two.views, options.grid);
  const auto seams = findSeams(two.views, grid, options.seam, noProgress());
  ASSERT_TRUE(seams);
  const auto folder = std::filesystem::temp_directory_path() / ("ew-join-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::vector<VolumeStream> streams;
  for (const char* name : {"echo.mha", "coverage.mha", "source.mha"}) {
    auto stream = VolumeStream::create(grid, folder / name);
    ASSERT_TRUE(stream) << (stream ? "" : stream.error().sentence());
    streams.push_back(std::move(*stream));
  }
  const std::uint64_t before_bytes = test::memoryInUse_bytes();
  FileSink sink(std::move(streams[0]), std::move(streams[1]), std::move(streams[2]));
  ASSERT_TRUE(join(two.views, *seams, grid, options, sink, noProgress()));
  ASSERT_TRUE(sink.finish());
  const std::uint64_t taken_bytes = sink.most_bytes - before_bytes;
  EXPECT_LT(taken_bytes, grid.voxelCount()) << "three bytes a voxel of " << grid.voxelCount() << " voxels are not to be held";

  const auto whole = join(two.views, *seams, grid, options, noProgress());
  ASSERT_TRUE(whole);
  EXPECT_TRUE(samplesOf(folder / "echo.mha", grid.voxelCount()) == whole->volume.echo);
  EXPECT_TRUE(samplesOf(folder / "coverage.mha", grid.voxelCount()) == whole->volume.coverage);
  EXPECT_TRUE(samplesOf(folder / "source.mha", grid.voxelCount()) == whole->source);
  std::filesystem::remove_all(folder);
}

TEST(Join, LevelsPassOverNearSeamsAndNowhereElse) {
  // Flat views of different grey, side by side: the steps are 20 levels wide and spread over 2 x 10 mm.
  const Volume left = constant(gridOf({70, 20, 20}), 100), right = constant(gridOf({70, 20, 20}), 120);
  const std::vector<View> views = {viewOf(left, "left"), viewOf(right, "right", moved(40, 0, 0))};
  JoinOptions options;
  options.seam.levelBlend_mm = 10.0;
  const auto result = joined(views, options);
  const Grid& grid = result.volume.grid;
  int largest = 0;
  for (int i = 0; i + 1 < grid.dims.x; ++i)
    largest = std::max(largest, std::abs(result.volume.echo[grid.indexOf(i + 1, 10, 10)] - result.volume.echo[grid.indexOf(i, 10, 10)]));
  EXPECT_LE(largest, 3);
  EXPECT_EQ(result.volume.echo[grid.indexOf(30, 10, 10)], 100);
  EXPECT_EQ(result.volume.echo[grid.indexOf(grid.dims.x - 31, 10, 10)], 120);
  EXPECT_EQ(joined(views, options).volume.echo, result.volume.echo);
}

TEST(EqualiseViews, GivesTheSameCurvesOnAnyNumberOfThreads) {
  SpeckleViewRecipe right = rightRecipe(true);
  right.gain_db = 5.0;
  TwoViews two(leftRecipe(true), right);
  EqualiseViewsOptions options;
  options.threads = 1;
  const auto one = equaliseViews(two.views, options, noProgress());
  ASSERT_TRUE(one);
  for (const int threads : {2, 8}) {
    options.threads = threads;
    const auto many = equaliseViews(two.views, options, noProgress());
    ASSERT_TRUE(many);
    EXPECT_EQ(many->corrections, one->corrections);
  }
}

}  // namespace
}  // namespace ew::stitching::seam_test
