#include "logic/painting.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

#include "logic/keeping_aside.h"
#include "logic/painting_autosave.h"

namespace ew::case_authoring {
namespace {

namespace fs = std::filesystem;

Transform<frame::World, frame::File> somewhere() {
  return {glm::rotate(glm::translate(glm::dmat4(1.0), {30.0, -20.0, 10.0}), 0.9, glm::normalize(glm::dvec3(0.2, 1.0, -0.4)))};
}

sdk::Scanned scannedAt(const Transform<frame::World, frame::File>& fileToWorld) {
  auto voxels = std::make_shared<Volume>();
  voxels->grid.dims = {60, 60, 60};
  voxels->grid.origin_mm = glm::dvec3(-29.5);
  voxels->echo.assign(voxels->grid.voxelCount(), 100);
  for (int k = 0; k < 60; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i)
        if (glm::length(glm::dvec3(i, j, k) - 29.5) < 9.0) voxels->echo[voxels->grid.indexOf(i, j, k)] = 10;
  sdk::Scanned scanned;
  scanned.volume = placed(voxels->grid, fileToWorld);
  scanned.voxels = std::move(voxels);
  return scanned;
}

std::unique_ptr<Painting> begun(const Transform<frame::World, frame::File>& fileToWorld) {
  auto painting = Painting::begin(scannedAt(fileToWorld), fileToWorld);
  EXPECT_TRUE(painting);
  return std::move(*painting);
}

void ball(Painting& painting) {
  painting.strokeBegun({.radius_mm = 6.0}, 3, "Paint", Transform<frame::File, frame::Probe>{}, {0.0, 0.0});
  painting.strokeEnded();
}

TEST(Painting, IsInTheFileWhereverThatIsPlaced) {
  const auto here = begun({}), there = begun(somewhere());
  ball(*here);
  ball(*there);
  EXPECT_EQ(here->labels().echo, there->labels().echo);
  const Volume placedThere = there->inWorld(somewhere());
  EXPECT_LT(glm::distance(middleOf(placedThere.grid), carried(somewhere(), middleOf(there->labels().grid))), 1e-9);
  EXPECT_NEAR(labelling::volume_ml(here->labels(), 3), 4.0 / 3.0 * 3.14159265 * 0.216, 0.03);
}

TEST(Painting, GoesOnWithTheLabelsOfTheCase) {
  auto first = begun(somewhere());
  ball(*first);
  sdk::Scanned scanned = scannedAt(somewhere());
  Volume world = first->inWorld(somewhere());
  scanned.placedLabels = world.grid;
  scanned.labels = std::make_shared<const Volume>(std::move(world));
  const auto second = Painting::begin(scanned, somewhere());
  ASSERT_TRUE(second);
  EXPECT_EQ((*second)->labels().echo, first->labels().echo);
  EXPECT_FALSE((*second)->isChanged());
  EXPECT_LT(glm::distance((*second)->labels().grid.origin_mm, first->labels().grid.origin_mm), 1e-9);
}

TEST(Painting, TakesStrokesBackOneByOne) {
  const auto painting = begun({});
  ball(*painting);
  painting->strokeBegun({.tool = PaintTool::erase, .radius_mm = 20.0}, 3, "Erase", {}, {0.0, 0.0});
  painting->strokeMoved({4.0, 0.0});
  painting->strokeEnded();
  EXPECT_EQ(labelling::voxelsOf(painting->labels(), 3), 0u);
  painting->edits().undo();
  EXPECT_GT(labelling::voxelsOf(painting->labels(), 3), 800u);
  painting->edits().undo();
  EXPECT_EQ(labelling::voxelsOf(painting->labels(), 3), 0u);
  EXPECT_FALSE(painting->isChanged());
}

TEST(Painting, FillsBetweenTracedOutlines) {
  const auto painting = begun({});
  for (const double z : {-8.0, 8.0}) {
    const Transform<frame::File, frame::Probe> plane{glm::translate(glm::dmat4(1.0), {0.0, 0.0, z})};
    painting->strokeBegun({.tool = PaintTool::trace}, 2, "Trace", plane, {6.0, 6.0});
    for (const glm::dvec2& at : {glm::dvec2(-6.0, 6.0), glm::dvec2(-6.0, -6.0), glm::dvec2(6.0, -6.0)}) painting->strokeMoved(at);
    painting->strokeEnded();
  }
  ASSERT_EQ(painting->traced().size(), 2u);
  ASSERT_TRUE(painting->fillBetween(2, true, "Fill", noProgress()));
  EXPECT_TRUE(painting->traced().empty());
  // The outermost outlines reach half a diagonal of a voxel beyond their planes.
  EXPECT_NEAR(labelling::volume_ml(painting->labels(), 2), 12.0 * 12.0 * 18.0 * 1e-3, 1e-9);
}

TEST(Painting, GrowsBesideTheWindowAndKeepsWhatIsPaintedMeanwhile) {
  const auto painting = begun({});
  auto growing = painting->growing({0.0, 0.0, 0.0}, {.smoothing_mm = 0.0}, 5, true);
  painting->strokeBegun({.radius_mm = 3.0}, 3, "Paint", {}, {25.0, 25.0});
  painting->strokeEnded();
  auto grown = growing(noProgress());
  ASSERT_TRUE(grown);
  ASSERT_EQ(grown->result.stop, labelling::GrowStop::done);
  painting->take(std::move(*grown), "Grow");
  EXPECT_NEAR(labelling::volume_ml(painting->labels(), 5), 4.0 / 3.0 * 3.14159265 * 0.729, 0.3);
  EXPECT_GT(labelling::voxelsOf(painting->labels(), 3), 50u);
}

TEST(Painting, NeedsVoxelsInMemory) {
  sdk::Scanned scanned = scannedAt({});
  scanned.voxels.reset();
  EXPECT_EQ(Painting::begin(scanned, {}).error().code, ErrorCode::badUsage);
}

class KeptPaintingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "ew-kept-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    root_ = name;
  }
  void TearDown() override { fs::remove_all(root_); }
  fs::path root_;
};

TEST_F(KeptPaintingTest, IsOfferedAfterACrashAndNotBefore) {
  const auto painting = begun({});
  ball(*painting);
  const pid_t child = ::fork();
  if (child == 0) {
    PaintingAutosave kept(root_);
    const bool isKept = kept.keep(painting->labels(), "/cases/knee", "volumes/before.mha", noProgress()).has_value();
    ::_exit(isKept ? 7 : 1);  // without any destructor, as a crash ends
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(WEXITSTATUS(status), 7);
  const PaintingAutosave next(root_);
  EXPECT_FALSE(next.leftFor("/cases/other"));
  const auto left = next.leftFor("/cases/knee");
  ASSERT_TRUE(left);
  EXPECT_EQ(left->before, "volumes/before.mha");
  const auto labels = PaintingAutosave::read(*left, noProgress());
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->echo, painting->labels().echo);
  PaintingAutosave::remove(*left);
  EXPECT_FALSE(next.leftFor("/cases/knee"));
  EXPECT_TRUE(fs::is_empty(root_));
}

TEST_F(KeptPaintingTest, IsTheOldOneOrTheNewOneWheneverTheProgramIsKilled) {
  const auto painting = begun({});
  std::vector<std::vector<std::uint8_t>> states;
  for (int n = 0; n < 4; ++n) {
    painting->strokeBegun({.radius_mm = 5.0}, 3, "Paint", {}, {6.0 * n - 9.0, 0.0});
    painting->strokeEnded();
    states.push_back(painting->labels().echo);
  }
  Volume labels = painting->labels();
  for (int kill = 0; kill < 50; ++kill) {
    const pid_t child = ::fork();
    if (child == 0) {
      PaintingAutosave kept(root_);
      for (int n = 0;; ++n) {
        labels.echo = states[static_cast<std::size_t>(n) % states.size()];
        if (!kept.keep(labels, "/cases/knee", "", noProgress())) ::_exit(1);
      }
    }
    ::usleep(static_cast<useconds_t>(3000 + 1700 * kill));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const PaintingAutosave next(root_);
    const auto left = next.leftFor("/cases/knee");
    if (!left) continue;  // killed before anything was complete
    const auto read = PaintingAutosave::read(*left, noProgress());
    ASSERT_TRUE(read) << kill;
    EXPECT_NE(std::find(states.begin(), states.end(), read->echo), states.end()) << kill;
    fs::remove_all(left->kept);
  }
}

TEST_F(KeptPaintingTest, IsNotOfferedWhileItsProgramRunsAndIsGoneWhenThatEnds) {
  const auto painting = begun({});
  ball(*painting);
  {
    PaintingAutosave kept(root_);
    ASSERT_TRUE(kept.keep(painting->labels(), "/cases/knee", "", noProgress()));
    EXPECT_FALSE(PaintingAutosave(root_).leftFor("/cases/knee"));
  }
  EXPECT_TRUE(fs::is_empty(root_));
}

TEST_F(KeptPaintingTest, LeavesTheLatestOfItsOwnCaseAloneHoweverSlowTheJobBeforeWas) {
  const auto painting = begun({});
  ball(*painting);
  const Volume older = painting->labels();
  painting->strokeBegun({.radius_mm = 3.0}, 3, "Paint", {}, {25.0, 25.0});
  painting->strokeEnded();
  struct Job {
    KeepingAside::Work work;
    KeepingAside::Done done;
  };
  std::vector<Job> jobs;
  auto aside = std::make_shared<KeepingAside>(root_, [&jobs](auto work, auto done) { jobs.push_back({std::move(work), std::move(done)}); });
  aside->keep({older, "/cases/knee", "volumes/knee.mha"}, {});
  // The case changes while the first job still runs.
  aside->keep({painting->labels(), "/cases/knee", "volumes/knee.mha"}, {});
  aside->leave();
  // Whatever has begun runs in the order that is worst: the last first.
  while (!jobs.empty()) {
    const Job last = jobs.back();
    jobs.pop_back();
    last.done(last.work(noProgress()));
  }
  aside.reset();
  const PaintingAutosave next(root_);
  EXPECT_EQ(std::distance(fs::directory_iterator(root_), fs::directory_iterator()), 1);
  const auto left = next.leftFor("/cases/knee");
  ASSERT_TRUE(left);
  EXPECT_EQ(left->before, "volumes/knee.mha");
  const auto read = PaintingAutosave::read(*left, noProgress());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->echo, painting->labels().echo);
}

TEST_F(KeptPaintingTest, ForgetsWhatIsStillBeingKeptAside) {
  const auto painting = begun({});
  ball(*painting);
  std::vector<std::function<void()>> jobs;
  auto aside = std::make_shared<KeepingAside>(root_, [&jobs](auto work, auto done) { jobs.push_back([=] { done(work(noProgress())); }); });
  aside->keep({painting->labels(), "/cases/knee", ""}, {});
  aside->forget();
  jobs.front()();
  EXPECT_TRUE(fs::is_empty(root_));
  EXPECT_EQ(jobs.size(), 1u);
}

TEST_F(KeptPaintingTest, NeverReadsWhatADamagedFileNamesElsewhere) {
  fs::create_directories(root_ / "x");
  std::ofstream(root_ / "x" / "painting.json") << R"({"case_folder": "/cases/knee", "labels": "../../../etc/passwd"})";
  EXPECT_FALSE(PaintingAutosave(root_).leftFor("/cases/knee"));
  std::ofstream(root_ / "x" / "painting.json") << "{";
  EXPECT_FALSE(PaintingAutosave(root_).leftFor("/cases/knee"));
}

}  // namespace
}  // namespace ew::case_authoring
