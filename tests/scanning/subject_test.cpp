#include "ew/scanning/scanner.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "scanning/small_scan.h"

namespace ew::subject_test {

TEST(ScanVoxels, AreScannedInTheLayoutThatWasTimedToBeFasterOnce) {
  const std::filesystem::path cache = std::filesystem::temp_directory_path() / ("echoweave_layouts_" + std::to_string(getpid()));
  ASSERT_EQ(setenv("ECHOWEAVE_CACHE", cache.c_str(), 1), 0);
  const auto small = ScanVoxels::of(test::waves());
  ASSERT_TRUE(small);
  EXPECT_EQ(small->bricks(), nullptr);
  EXPECT_FALSE(small->layoutTimes());

  const auto large = ScanVoxels::of(test::waves(130));
  ASSERT_TRUE(large);
  ASSERT_TRUE(large->layoutTimes());
  EXPECT_EQ(large->bricks() != nullptr, large->layoutTimes()->bricksAreFaster());
  const auto again = ScanVoxels::of(test::waves(140));  // between the same powers of two
  ASSERT_TRUE(again);
  EXPECT_EQ(again->layoutTimes()->rows_us, large->layoutTimes()->rows_us);

  for (const bool bricks : {true, false}) {
    auto kept = nlohmann::json::parse(std::ifstream(cache / "layouts.json"));
    for (auto& [key, times] : kept.items()) times = {{"rows_us", 100.0}, {"bricks_us", bricks ? 50.0 : 200.0}};
    std::ofstream(cache / "layouts.json") << kept;
    const auto chosen = ScanVoxels::of(test::waves(130));
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->bricks() != nullptr, bricks);
  }
  for (const char* damaged : {"[", "[]", "{\"x\": 1}"}) {
    std::ofstream(cache / "layouts.json") << damaged;
    EXPECT_TRUE(ScanVoxels::of(test::waves(130))->layoutTimes()) << damaged;
  }
  ASSERT_EQ(unsetenv("ECHOWEAVE_CACHE"), 0);
  std::filesystem::remove_all(cache);
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
    const Picture a = plain.make(state, 200, 160), b = fromBricks.make(state, 200, 160);
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
  const Picture first = scanner.make(state, 120, 90);
  for (int y = 0; y < 90; ++y) std::copy_n(first.grey.row(y), 120, viewOf(before).row(y));
  const Transform<frame::World, frame::World> away{glm::translate(glm::dmat4(1.0), {128.0, -64.0, 32.0})};
  scanner.place(away);
  EXPECT_EQ(scanner.subject()->placedLabels, scanner.subject()->placedGrid);
  EXPECT_EQ(scanner.subject()->placedTissue, scanner.subject()->placedGrid);
  state.pose.probeToWorld = away * state.pose.probeToWorld;
  const Picture moved = scanner.make(state, 120, 90);
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) ASSERT_NEAR(moved.grey.row(y)[x], viewOf(before).row(y)[x], 1) << x << ' ' << y;
  EXPECT_TRUE(scanner.seesVolume(state.pose));
  state.pose.probeToWorld.matrix[3].x += 500.0;
  EXPECT_FALSE(scanner.seesVolume(state.pose));
  state.pose.status = PoseStatus::invalid;
  EXPECT_FALSE(scanner.seesVolume(state.pose));
}

TEST(ScanSubject, TheFirstStateIsTheCasesProbeAtItsStart) {
  ScanSubject subject = test::waveSubject();
  const Probe other = test::smallProbe();
  Probe wanted = other;
  wanted.id = "wanted";
  auto state = firstState(subject, {other, wanted});
  ASSERT_TRUE(state);
  EXPECT_EQ(state->probe.id, "small") << "any probe";
  EXPECT_EQ(glm::dvec3(state->pose.probeToWorld.matrix[3]).y, boundsOf(subject.placedGrid).lowest_mm.y + Hold().press_mm);
  subject.probes = {"wanted", "small"};
  subject.startPose = test::movingState(3).pose;
  subject.scene.focus.emplace();
  state = firstState(subject, {other, wanted});
  ASSERT_TRUE(state);
  EXPECT_EQ(state->probe.id, "wanted");
  EXPECT_EQ(state->pose, *subject.startPose);
  EXPECT_EQ(state->scene, subject.scene);
  EXPECT_EQ(state->knobs, Knobs());
  subject.probes = {"none"};
  EXPECT_FALSE(firstState(subject, {other, wanted}));
}

}  // namespace ew::subject_test
