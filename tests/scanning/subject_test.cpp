#include "ew/scanning/scanner.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "ew/io/volume_file.h"
#include "ew/tracking/hand.h"
#include "scanning/small_scan.h"

namespace ew::subject_test {

nlohmann::json tableOf(const LayoutTimes& times) {
  nlohmann::json table = {{"format", 3}};
  for (const LayoutPair& pair : times.ofClass) {
    table["rows_us"].push_back(pair.rows_us);
    table["bricks_us"].push_back(pair.bricks_us);
  }
  return table;
}

/// Keeps what volumes are timed for in a folder of its own.
class LayoutsKept : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(setenv("ECHOWEAVE_CACHE", cache_.c_str(), 1), 0); }
  void TearDown() override {
    ASSERT_EQ(unsetenv("ECHOWEAVE_CACHE"), 0);
    std::filesystem::remove_all(cache_);
  }
  [[nodiscard]] nlohmann::json kept() const { return nlohmann::json::parse(std::ifstream(cache_ / "layouts.json")); }
  void keep(const nlohmann::json& times) const {
    nlohmann::json all = kept();
    for (auto& [key, entry] : all.items()) entry = times;
    std::ofstream(cache_ / "layouts.json") << all;
  }
  /// Whether every entry of the file has these times.
  [[nodiscard]] bool holds(const LayoutTimes& times) const {
    const nlohmann::json all = kept(), table = tableOf(times);
    return !all.empty() && std::all_of(all.begin(), all.end(), [&table](const nlohmann::json& entry) { return entry == table; });
  }
  const std::filesystem::path cache_ = std::filesystem::temp_directory_path() / ("echoweave_layouts_" + std::to_string(getpid()));
};

/// Bricks are faster where `choice` says.
LayoutTimes timesFor(const LayoutChoice& choice) {
  LayoutTimes times;
  for (std::size_t n = 0; n < SliceClass::kCount; ++n) times.ofClass[n] = {100.0, choice.test(n) ? 62.5 : 125.0};
  return times;
}

TEST_F(LayoutsKept, AreTimedOnceForVolumesOfAboutASizeUnlessTheyAreSmall) {
  const auto small = ScanVoxels::of(test::waves());
  ASSERT_TRUE(small);
  EXPECT_EQ(small->bricks(), nullptr);
  EXPECT_FALSE(small->layoutTimes());

  const auto large = ScanVoxels::of(test::waves(130));
  ASSERT_TRUE(large);
  ASSERT_TRUE(large->layoutTimes());
  EXPECT_EQ(large->bricks() != nullptr, large->layoutTimes()->choice().any());
  const auto again = ScanVoxels::of(test::waves(140));  // between the same powers of two
  ASSERT_TRUE(again);
  EXPECT_EQ(again->layoutTimes(), large->layoutTimes()) << "the file gives back what was kept";
  EXPECT_TRUE(holds(*large->layoutTimes()));
}

TEST_F(LayoutsKept, DecideForEachClassOfSlices) {
  ASSERT_TRUE(ScanVoxels::of(test::waves(130)));
  for (const char* bits : {"000000000000000000", "111111111111111111", "101100111000110101"}) {
    const LayoutChoice choice{std::string(bits)};
    keep(tableOf(timesFor(choice)));
    const auto chosen = ScanVoxels::of(test::waves(130));
    ASSERT_TRUE(chosen);
    EXPECT_EQ(*chosen->layoutTimes(), timesFor(choice));
    EXPECT_EQ(chosen->bricks() != nullptr, choice.any()) << "bricks that nothing reads are not made";
    const SliceSource source = chosen->source(chosen->grid(), 0.0);
    for (std::size_t n = 0; n < SliceClass::kCount; ++n)
      EXPECT_EQ(source.inLayoutFor(SliceClass::at(n)).layout, choice.test(n) ? VoxelLayout::bricked : VoxelLayout::linear) << bits << n;
    if (chosen->bricks()) {
      EXPECT_EQ(chosen->source(chosen->grid(), 1e3).inLayoutFor({}).layout, VoxelLayout::linear) << "zoomed out, a coarser level";
    }
  }
}

TEST_F(LayoutsKept, LeaveBricksToWhoeverReadsSlices) {
  ASSERT_TRUE(ScanVoxels::of(test::waves(130)));
  keep(tableOf(timesFor(LayoutChoice().set())));
  const auto volume = test::waves(130);
  const auto voxels = ScanVoxels::of(volume, noProgress(), ScanVoxels::Bricks::whenRead);
  ASSERT_TRUE(voxels);
  EXPECT_TRUE(voxels->readsBricks());
  EXPECT_EQ(voxels->bricks(), nullptr) << "nobody reads slices";
  std::weak_ptr<const BrickVolume> made;
  {
    const ScanVoxels one = voxels->withBricks(), other = ScanVoxels(*voxels).withBricks();
    made = one.bricks();
    ASSERT_FALSE(made.expired());
    EXPECT_EQ(one.bricks(), other.bricks()) << "one copy for all who read them";
    EXPECT_EQ(one.source(one.grid(), 0.0).inLayoutFor({}).layout, VoxelLayout::bricked);
  }
  EXPECT_TRUE(made.expired()) << "given back by the last who read them";

  // A scanner holds them as long as its images are slices, and shows what one shows that has them always.
  ScanSubject subject = test::livingSubject();
  const Grid placed = volume->grid;
  subject.voxels = *voxels;
  subject.placedGrid = placed;
  ScanSubject withAlways = subject;
  withAlways.voxels = ScanVoxels::of(volume).value();
  ASSERT_NE(withAlways.voxels.bricks(), nullptr);
  Scanner scanner, always;
  scanner.show(subject);
  always.show(withAlways);
  const auto held = [&] { return voxels->withBricks().bricks().use_count() > 1; };
  ScanState state = test::movingState(60);
  for (const bool formsEchoes : {true, false, true}) {
    state.scene.liveEchoes.reset();
    if (formsEchoes) state.scene.liveEchoes.emplace();
    for (const double depth_mm : {30.0, 60.0}) {
      state.knobs.depth_mm = depth_mm;
      const DisplayImage a = scanner.make(state, 200, 160), b = always.make(state, 200, 160);
      for (int y = 0; y < 160; ++y) ASSERT_TRUE(std::equal(a.grey.row(y), a.grey.row(y) + 200, b.grey.row(y))) << y;
      EXPECT_EQ(held(), !formsEchoes);
    }
  }
  state.scene.liveEchoes.reset();
  static_cast<void>(scanner.make(state, 200, 160));
  EXPECT_TRUE(held());
  scanner.clear();
  EXPECT_FALSE(held()) << "what is no longer scanned holds nothing";
}

TEST_F(LayoutsKept, AreTimedAgainWhenTheFileIsDamagedOrOld) {
  const nlohmann::json good = tableOf(timesFor(LayoutChoice()));
  const auto isTimedAgain = [&] {
    const auto voxels = ScanVoxels::of(test::waves(130));
    return voxels && voxels->layoutTimes() && *voxels->layoutTimes() != timesFor(LayoutChoice()) && holds(*voxels->layoutTimes());
  };
  ASSERT_TRUE(isTimedAgain()) << "no file";
  keep(good);
  EXPECT_FALSE(isTimedAgain());
  keep({{"rows_us", 100.0}, {"bricks_us", 50.0}});
  EXPECT_TRUE(isTimedAgain()) << "one pair for all slices, as formerly";
  for (const char* patch :
       {R"({"format": 1})", R"({"format": null})", R"({"rows_us": 100.0})", R"({"bricks_us": [1.0, 2.0]})",
        R"({"rows_us": [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,-1]})", R"({"bricks_us": [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,"1"]})"}) {
    nlohmann::json damaged = good;
    damaged.merge_patch(nlohmann::json::parse(patch));
    keep(damaged);
    EXPECT_TRUE(isTimedAgain()) << patch;
  }
  for (const char* damaged : {"[", "[]", "{\"x\": 1}"}) {
    std::ofstream(cache_ / "layouts.json") << damaged;
    EXPECT_TRUE(ScanVoxels::of(test::waves(130))->layoutTimes()) << damaged;
  }
}

TEST(ScanVoxels, BricksShowTheSamePixelsUnlessTheyZoomOut) {
  const auto volume = test::waves(80);
  const auto bricked = ScanVoxels::inBricks(volume, 1);
  ASSERT_TRUE(bricked);
  for (const Quality quality : {Quality::weave, Quality::linear, Quality::cubic}) {
    ScanState state = test::movingState(60);
    state.knobs.quality = quality;
    Scanner plain, fromBricks;
    plain.show(subjectOf(ScanVoxels::asStored(volume), "plain"));
    fromBricks.show(subjectOf(*bricked, "bricks"));
    const DisplayImage a = plain.make(state, 200, 160), b = fromBricks.make(state, 200, 160);
    for (int y = 0; y < 160; ++y) ASSERT_TRUE(std::equal(a.grey.row(y), a.grey.row(y) + 200, b.grey.row(y))) << y;
  }
}

TEST(ScanSubject, MovingTheVolumeAndTheProbeTogetherChangesNothing) {
  ScanSubject subject = test::waveSubject();
  subject.labels = subject.voxels.volume();
  subject.placedLabels = subject.placedGrid;
  auto tissue = std::make_shared<TissueMaps>();
  tissue->grid = subject.placedGrid;
  subject.tissue = tissue;
  subject.placedTissue = tissue->grid;
  ScanState state = test::movingState(60);
  state.scene.noise.reset();
  Scanner scanner;
  scanner.show(subject);
  GreyImage before(120, 90);
  const DisplayImage first = scanner.make(state, 120, 90);
  for (int y = 0; y < 90; ++y) std::copy_n(first.grey.row(y), 120, viewOf(before).row(y));
  const Transform<frame::World, frame::World> away{glm::translate(glm::dmat4(1.0), {128.0, -64.0, 32.0})};
  scanner.place(away);
  EXPECT_EQ(scanner.subject()->placedLabels, scanner.subject()->placedGrid);
  EXPECT_EQ(scanner.subject()->placedTissue, scanner.subject()->placedGrid);
  state.pose.probeToWorld = away * state.pose.probeToWorld;
  const DisplayImage moved = scanner.make(state, 120, 90);
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) ASSERT_NEAR(moved.grey.row(y)[x], viewOf(before).row(y)[x], 1) << x << ' ' << y;
  EXPECT_TRUE(scanner.seesVolume(state.pose));
  state.pose.probeToWorld.matrix[3].x += 500.0;
  EXPECT_FALSE(scanner.seesVolume(state.pose));
  state.pose.status = PoseStatus::invalid;
  EXPECT_FALSE(scanner.seesVolume(state.pose));
}

TEST(ScanSubject, ChangesWithTheBodyAndWithBloodWithinAColourBox) {
  ScanSubject subject = test::livingSubject();
  Knobs plain, colour;
  colour.colour.emplace();
  Scene still, moving;
  moving.liveEchoes.emplace();
  moving.motion.emplace();
  EXPECT_TRUE(subject.changesIn(moving, plain));
  EXPECT_FALSE(subject.changesIn(still, plain));
  EXPECT_FALSE(subject.changesIn(still, colour)) << "nobody knows how its blood flows";
  FlowField flow;
  flow.streams = {{.name = "a", .line = {{.place_mm = {-9, 0, 0}, .radius_mm = 3.0}, {.place_mm = {9, 0, 0}, .radius_mm = 3.0}}}};
  subject.flow = std::make_shared<const FlowSampler>(flow);
  EXPECT_TRUE(subject.changesIn(still, colour));
  EXPECT_FALSE(subject.changesIn(still, plain));
  subject.tissue = nullptr;
  EXPECT_FALSE(subject.changesIn(still, colour));
}

TEST(ScanSubject, ARecordedVolumeIsSlicedUntilItsLevelIsKnownAndSomebodyAsks) {
  ScanSubject subject = test::waveSubject();
  ScanState state = test::movingState(60);
  state.scene = {};
  state.scene.liveEchoes.emplace();
  EXPECT_FALSE(subject.known(state.scene).liveEchoes);
  EXPECT_TRUE(subject.possible(state.scene).liveEchoes);
  subject.place({glm::translate(glm::dmat4(1.0), {5.0, 6.0, 7.0})});
  const auto has = [&](const Scanner& scanner, StepKind kind) {
    const auto& steps = scanner.plan().steps;
    return std::any_of(steps.begin(), steps.end(), [kind](const Step& step) { return step.kind == kind; });
  };
  Scanner scanner;
  scanner.show(subject);
  static_cast<void>(scanner.make(state, 120, 90));
  EXPECT_FALSE(has(scanner, StepKind::scatterers));

  const auto tissue = recordedTissueOf(subject.voxels, state.scene, 1, noProgress());
  ASSERT_TRUE(tissue) << tissue.error();
  scanner.know(*tissue);
  EXPECT_EQ(scanner.subject()->placedTissue, scanner.subject()->placedGrid);
  EXPECT_TRUE(scanner.subject()->known(state.scene).liveEchoes);
  static_cast<void>(scanner.make(state, 120, 90));
  EXPECT_TRUE(has(scanner, StepKind::scatterers) && has(scanner, StepKind::ownGrain));
  state.scene.liveEchoes.reset();
  static_cast<void>(scanner.make(state, 120, 90));
  EXPECT_FALSE(has(scanner, StepKind::scatterers)) << "the slice stays the default";

  const auto folder = std::filesystem::temp_directory_path() / ("echoweave_level_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  ASSERT_TRUE(writeVolume(*subject.voxels.volume(), folder / "v.mha", noProgress(), {.compress = false}));
  auto mapped = mapVolume(folder / "v.mha");
  ASSERT_TRUE(mapped) << mapped.error();
  const ScanVoxels inFile = ScanVoxels::of(std::make_shared<const MappedVolume>(std::move(*mapped)));
  EXPECT_EQ(recordedTissueOf(inFile, state.scene, 1, noProgress()).error().code, ErrorCode::unsupported);
  std::filesystem::remove_all(folder);
}

TEST(ScanSubject, TheFirstStateIsTheCasesProbeAtItsStart) {
  ScanSubject subject = test::waveSubject();
  const Probe other = test::smallProbe();
  Probe wanted = other;
  wanted.id = "wanted";
  std::vector<Preset> presets;
  auto state = firstState(subject, {other, wanted}, presets);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->probe.id, "small") << "any probe";
  EXPECT_EQ(glm::dvec3(state->pose.probeToWorld.matrix[3]).y, boundsOf(subject.placedGrid).lowest_mm.y + Hold().press_mm);
  subject.probes = {"wanted", "small"};
  subject.startPose = test::movingState(3).pose;
  subject.scene.focus.emplace();
  state = firstState(subject, {other, wanted}, presets);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->probe.id, "wanted");
  EXPECT_EQ(state->pose, *subject.startPose);
  EXPECT_EQ(state->scene, subject.scene);
  EXPECT_EQ(state->knobs, Knobs());
  subject.presets = {"lost", "of another", "too deep", "fits", "fits too"};
  const auto preset = [](const char* id, const std::string& probe, double depth_mm) {
    Preset made;
    made.id = id;
    made.probe = probe;
    made.knobs.depth_mm = depth_mm;
    made.knobs.gain_db = 4.0;
    return made;
  };
  const double depth_mm = other.minDepth_mm;
  presets = {preset("fits too", "wanted", depth_mm + 1.0), preset("of another", "nobody's", depth_mm),
             preset("too deep", "wanted", other.maxDepth_mm + 1.0), preset("fits", "small", depth_mm)};
  state = firstState(subject, {other, wanted}, presets);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->probe.id, "small") << "the preset's";
  EXPECT_EQ(state->knobs, applied(presets[3], Knobs()))
      << "the first of the subject's that is there, for one of its probes, and can be set";
  subject.probes = {"wanted"};
  state = firstState(subject, {other, wanted}, presets);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->knobs.depth_mm, depth_mm + 1.0) << "the other is for a probe that may not be used";
  subject.probes = {"none"};
  EXPECT_FALSE(firstState(subject, {other, wanted}, presets));
}

}  // namespace ew::subject_test
