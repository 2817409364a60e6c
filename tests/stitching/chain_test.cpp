#include "ew/stitching/chain.h"
#include "ew/imaging/tissue_level.h"
#include "ew/stitching/places.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <numbers>
#include <thread>

#include "chain/pair_match.h"
#include "counted_stop.h"
#include "ew/core/memory_watch.h"
#include "ew/io/step_store.h"
#include "stitching/chain_world.h"

namespace ew::stitching::chain_test {
namespace {

namespace fs = std::filesystem;
using test::ChainWorld;
using test::textOf;

std::vector<std::string> redone(const ChainState& state) {
  std::vector<std::string> names;
  for (const auto& step : state.steps)
    if (step.done && !step.reused) names.emplace_back(nameOf(step.step));
  return names;
}

TEST(Chain, RunAgainRedoesNothing) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  const auto first = world.run(into);
  ASSERT_TRUE(first) << first.error();
  EXPECT_EQ(redone(*first).size(), kSteps.size());
  ASSERT_TRUE(first->graph);
  ASSERT_TRUE(first->report);
  EXPECT_EQ(first->volumes.size(), 3u);
  EXPECT_TRUE(first->leftOut.empty()) << first->reason;
  const auto bytes = ChainWorld::resultIn(into);
  const auto entries = ChainWorld::entriesIn(into);
  const auto second = world.run(into);
  ASSERT_TRUE(second) << second.error();
  EXPECT_EQ(redone(*second), std::vector<std::string>{});
  EXPECT_EQ(ChainWorld::resultIn(into), bytes);
  EXPECT_EQ(ChainWorld::entriesIn(into), entries);
  EXPECT_EQ(second->graph->toWorld, first->graph->toWorld);
  EXPECT_EQ(second->warps, first->warps);
  EXPECT_EQ(second->seams, first->seams);
  EXPECT_EQ(second->corrections, first->corrections);
  EXPECT_EQ(second->reason, first->reason);
  EXPECT_EQ(second->pairs.size(), first->pairs.size());
}

TEST(Chain, AChangedSettingRedoesOnlyWhatDependsOnIt) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  ASSERT_TRUE(world.run(into));
  struct Change {
    const char* what;
    std::function<void(StitchProject&)> make;
    std::vector<std::string> redone;
  };
  const Change changes[] = {
      {"distance weight", [](StitchProject& p) { p.settings.join.seam.distanceWeight = 0.3; }, {"seam", "volume"}},
      {"fall off", [](StitchProject& p) { p.settings.fallOff_mm = 20.0; }, {"elastic", "seam", "volume"}},
      {"equalise", [](StitchProject& p) { p.settings.equalise = false; }, {"equalise", "seam", "volume"}},
      {"tracker", [](StitchProject& p) { p.settings.trackerError_mm = 5.0; }, {"rigid", "graph", "equalise", "elastic", "seam", "volume"}},
      {"a name", [](StitchProject& p) { p.volumes[1].name = "middle"; }, {"graph", "volume"}},
  };
  for (const Change& change : changes) {
    ChainWorld other;
    StitchProject project = world.project;
    change.make(project);
    std::swap(world.project, project);
    const auto state = world.run(into);
    std::swap(world.project, project);
    ASSERT_TRUE(state) << state.error();
    EXPECT_EQ(redone(*state), change.redone) << change.what;
  }
}

TEST(Chain, AnEditedPairIsRegisteredAgainAlone) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  ChainOptions until;
  until.until = Step::graph;
  ASSERT_TRUE(world.run(into, noProgress(), until));
  const auto pairsIn = [&] {
    std::vector<std::string> names;
    for (const auto& each : fs::directory_iterator(into / "steps/pairs")) names.push_back(each.path().filename().string());
    return names;
  };
  const std::size_t before = pairsIn().size();
  EXPECT_EQ(before, 2u) << "a with b and b with c; a and c lie apart";
  ProjectPair pair;
  pair.fixed = 0;
  pair.moving = 1;
  pair.method = PairMethod::byHand;
  pair.start = test::shiftedBy<frame::Moving, frame::Fixed>({-21.0, 0.5, 0.0});
  world.project.pairs = {pair};
  const auto edited = world.run(into, noProgress(), until);
  ASSERT_TRUE(edited) << edited.error();
  EXPECT_EQ(pairsIn().size(), before + 1);
  EXPECT_EQ(edited->pairs.at(0).used, PairMethod::byHand);
  EXPECT_EQ(edited->pairs.at(0).rigid.fixedToMoving, *pair.start);
  world.project.pairs[0].decision = Decision::rejected;
  const auto rejected = world.run(into, noProgress(), until);
  ASSERT_TRUE(rejected) << rejected.error();
  EXPECT_EQ(rejected->graph->edges.size() + 1, edited->graph->edges.size());
  world.project.pairs.clear();
  const auto undone = world.run(into, noProgress(), until);
  ASSERT_TRUE(undone) << undone.error();
  EXPECT_EQ(redone(*undone), std::vector<std::string>{}) << "an edit taken back finds the old answer";
}

/// Where b would be if the tracker had it turned by 14 degrees and 12 mm off: its views overlap by 14 mm.
Transform<frame::World, frame::View> farOff(const Transform<frame::World, frame::View>& place, double by_mm) {
  const double turn = 14.0 * std::numbers::pi / 180.0;
  glm::dmat4 off(1.0);
  off[0] = glm::dvec4(std::cos(turn), std::sin(turn), 0.0, 0.0);
  off[1] = glm::dvec4(-std::sin(turn), std::cos(turn), 0.0, 0.0);
  off[3] = glm::dvec4(0.0, by_mm, 0.0, 1.0);
  return place * Transform<frame::View, frame::View>{off};
}

bool wasSearched(const PairOutcome& pair) {
  return std::any_of(pair.rigid.remarks.begin(), pair.rigid.remarks.end(),
                     [](const registration::Remark& remark) { return remark.what == registration::RemarkCode::foundAboutTheStart; });
}

TEST(Chain, SearchesAboutAPlaceFromWhichRefiningDoesNotEndAligned) {
  ChainWorld world;
  ChainOptions until;
  until.until = Step::rigid;
  const auto b = world.project.volumes[1].toWorld * test::shiftedBy<frame::View, frame::View>({-0.8, 0.0, 0.0});
  const auto truth = fixedToMovingOf(world.project.volumes[0].toWorld, b);
  const auto near = world.run(world.folder / "near", noProgress(), until);
  ASSERT_TRUE(near) << near.error();
  EXPECT_FALSE(wasSearched(near->pairs.at(0))) << "what descending finds is not searched for";

  const auto recorded = world.project.volumes[1].toWorld;
  world.project.volumes[1].toWorld = farOff(recorded, 12.0);
  const auto found = world.run(world.folder / "far", noProgress(), until);
  ASSERT_TRUE(found) << found.error();
  const PairOutcome& pair = found->pairs.at(0);
  EXPECT_EQ(pair.used, PairMethod::refine);
  EXPECT_TRUE(wasSearched(pair)) << pair.rigid.reason;
  EXPECT_EQ(pair.rigid.verdict, registration::Verdict::aligned) << pair.rigid.reason;
  const glm::dvec3 middle(28.0, 16.0, 14.0);
  EXPECT_LT(glm::distance(carried(pair.rigid.fixedToMoving, middle), carried(truth, middle)), 0.5);

  // Nobody believes a place that is further off than the tracker could have been.
  world.project.volumes[1].toWorld = farOff(recorded, 45.0);
  ProjectPair refined;
  refined.fixed = 0;
  refined.moving = 1;
  refined.method = PairMethod::refine;
  world.project.pairs = {refined};
  const auto tooFar = world.run(world.folder / "too far", noProgress(), until);
  ASSERT_TRUE(tooFar) << tooFar.error();
  EXPECT_NE(tooFar->pairs.at(0).rigid.verdict, registration::Verdict::aligned) << tooFar->pairs.at(0).rigid.reason;
  world.project.settings.trackerError_mm = 20.0;
  world.project.settings.trackerError_deg = 8.0;
  const auto believed = world.run(world.folder / "too far", noProgress(), until);
  ASSERT_TRUE(believed) << believed.error();
  EXPECT_EQ(believed->pairs.at(0).rigid.verdict, registration::Verdict::aligned) << believed->pairs.at(0).rigid.reason;
}

TEST(Chain, CountsTheSearchThatMayFollowARefinement) {
  Grid grid;
  grid.dims = glm::ivec3(96);
  grid.spacing_mm = glm::dvec3(3.0);
  PairTask task{.placesKnown = true, .landmarks = {}, .finest_mm = 1.5};
  const std::uint64_t refined = forecastPair_bytes(grid, grid, task);
  task.method = PairMethod::search;
  task.maxRotation_deg = searchReach(task).rotation_deg;
  EXPECT_EQ(refined, forecastPair_bytes(grid, grid, task)) << "its search has the same reach";
  task.method = PairMethod::landmarks;
  EXPECT_LT(forecastPair_bytes(grid, grid, task), refined);
  PairTask narrow{.placesKnown = true, .landmarks = {}, .maxRotation_deg = 8.0},
      wide{.placesKnown = true, .landmarks = {}, .maxRotation_deg = 60.0};
  EXPECT_EQ(searchReach(narrow).rotation_deg, 8.0) << "never wider than was asked";
  EXPECT_EQ(searchReach(wide).rotation_deg, 20.0);
  wide.trackerError_mm = 20.0;
  EXPECT_EQ(searchReach(wide).rotation_deg, 60.0);
  EXPECT_EQ(searchReach(wide).shift_mm, 60.0);
}

TEST(Chain, WhatAPairCostsIsToldWithoutTheTimeThatOthersTook) {
  ChainWorld world;
  world.project.settings.trackerError_mm = 8.5;  // so that pairs are matched as well
  /// Takes the processor away from whoever works, as a busy machine does: for as long as it was worked since the last report.
  class Busy final : public Progress {
   public:
    void report(const Message&, double) override {
      const std::clock_t now = std::clock();  // one thread works
      std::this_thread::sleep_for(std::chrono::duration<double>(static_cast<double>(now - worked_) / CLOCKS_PER_SEC));
      worked_ = std::clock();
    }
    [[nodiscard]] bool cancelRequested() const override { return false; }

   private:
    std::clock_t worked_ = std::clock();
  } busy;
  ChainOptions until;
  until.until = Step::elastic;
  until.threads = 1;
  const fs::path into = world.folder / "out";
  const auto made = world.run(into, busy, until);
  ASSERT_TRUE(made) << made.error();
  ASSERT_FALSE(made->warpedPairs.empty());
  for (const PairDeformation& warped : made->warpedPairs) {
    EXPECT_GT(warped.processor_s, 0.0);
    EXPECT_LT(warped.processor_s, 0.7 * warped.seconds);
  }
  ASSERT_FALSE(made->pairs.empty());
  for (const PairOutcome& pair : made->pairs) {
    EXPECT_GT(pair.processor_s, 0.0);
    EXPECT_LT(pair.processor_s, 0.7 * pair.rigid.seconds);
  }
  // It is kept with the rest.
  const auto again = world.run(into, noProgress(), until);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->warpedPairs[0].processor_s, made->warpedPairs[0].processor_s);
  EXPECT_EQ(again->pairs[0].processor_s, made->pairs[0].processor_s);
}

TEST(Chain, APairWithAnEffortOfItsOwnIsBentAgainAlone) {
  ChainWorld world;
  world.project.settings.trackerError_mm = world.project.settings.trackerError_deg = 0.0;  // nothing but the warps is at stake
  const fs::path into = world.folder / "out";
  ChainOptions until;
  until.until = Step::elastic;
  const auto first = world.run(into, noProgress(), until);
  ASSERT_TRUE(first) << first.error();
  ASSERT_EQ(first->warpedPairs.size(), 2u) << "a with b and b with c; a and c lie apart";
  EXPECT_EQ(std::pair(first->warpedPairs[1].fixed, first->warpedPairs[1].moving), std::pair(std::size_t{1}, std::size_t{2}));
  for (const PairDeformation& warped : first->warpedPairs) {
    EXPECT_EQ(warped.effort, registration::ElasticEffort::fast);
    EXPECT_FALSE(warped.levels.empty());
    EXPECT_FALSE(warped.reason.empty());
    EXPECT_GT(warped.seconds, 0.0);
    EXPECT_GT(warped.after.overlapShare, 0.0);
  }
  const auto warpsIn = [&] {
    std::size_t count = 0;
    for (const auto& each : fs::directory_iterator(into / "steps/bends"))
      count += each.path().extension() == ".json" && each.path().filename().string().find('-') == std::string::npos ? 1 : 0;
    return count;
  };
  EXPECT_EQ(warpsIn(), 2u);
  ProjectPair pair;
  pair.fixed = 1;
  pair.moving = 2;
  pair.effort = registration::ElasticEffort::accurate;
  world.project.pairs = {pair};
  const auto harder = world.run(into, noProgress(), until);
  ASSERT_TRUE(harder) << harder.error();
  EXPECT_EQ(redone(*harder), std::vector<std::string>{"elastic"});
  EXPECT_TRUE(harder->pairs.empty()) << "an effort asks for no matching";
  EXPECT_EQ(warpsIn(), 3u);
  ASSERT_EQ(harder->warpedPairs.size(), 2u);
  EXPECT_EQ(harder->warpedPairs[0].effort, registration::ElasticEffort::fast);
  EXPECT_EQ(harder->warpedPairs[1].effort, registration::ElasticEffort::accurate);
  EXPECT_LT(harder->warpedPairs[1].levels.back().node_mm, first->warpedPairs[1].levels.back().node_mm);
  const auto again = world.run(into, noProgress(), until);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(redone(*again), std::vector<std::string>{});
  ASSERT_EQ(again->warpedPairs.size(), 2u) << "what was found about each pair is read back";
  EXPECT_EQ(again->warpedPairs[1].effort, registration::ElasticEffort::accurate);
  EXPECT_EQ(again->warpedPairs[1].levels.size(), harder->warpedPairs[1].levels.size());
  EXPECT_EQ(again->warpedPairs[1].seconds, harder->warpedPairs[1].seconds);
  world.project.pairs[0].effort = registration::ElasticEffort::fast;
  const auto same = world.run(into, noProgress(), until);
  ASSERT_TRUE(same) << same.error();
  EXPECT_EQ(redone(*same), std::vector<std::string>{}) << "as much as all others is what was there before";
}

TEST(Chain, StopsAfterTheStepItWasAskedFor) {
  ChainWorld world;
  for (const Step step : kSteps) {
    ChainOptions options;
    options.until = step;
    const auto state = world.run(world.folder / "out", noProgress(), options);
    ASSERT_TRUE(state) << state.error();
    for (const auto& each : state->steps) EXPECT_EQ(each.done, each.step <= step) << nameOf(each.step);
    EXPECT_EQ(fs::exists(world.folder / "out/volume.mha"), step == Step::volume);
  }
}

TEST(Chain, GivesTheSameBytesWhateverTheThreadsAndHoweverOftenItIsStopped) {
  ChainWorld world;
  ASSERT_TRUE(world.run(world.folder / "out"));
  const auto expected = ChainWorld::resultIn(world.folder / "out");
  for (const int threads : {1, 2, 8}) {
    ChainOptions options;
    options.threads = threads;
    const fs::path into = world.folder / ("threads-" + std::to_string(threads));
    int stops = 0;
    for (int reports = 1;; reports += 7) {
      auto progress = ew::test::CountedStop::atReport(reports);
      const auto state = world.run(into, progress, options);
      if (state) break;
      ASSERT_EQ(state.error().code, ErrorCode::cancelled) << state.error();
      EXPECT_LE(progress.questionsAfter(), ew::test::kMostQuestionsAfter) << "after " << reports << " reports";
      EXPECT_LE(progress.reportsAfter(), ew::test::kMostReportsAfter) << "after " << reports << " reports";
      EXPECT_FALSE(fs::exists(into / "provenance.json"));
      ++stops;
    }
    EXPECT_GT(stops, 3);
    EXPECT_EQ(ChainWorld::resultIn(into), expected) << threads;
    EXPECT_EQ(ChainWorld::leftoversIn(into), std::vector<std::string>{});
  }
}

TEST(Chain, MakesTheSameVoxelsInBlocksAsInMemory) {
  ChainWorld world;
  ASSERT_TRUE(world.run(world.folder / "whole"));
  ChainOptions options;
  options.streamAbove_voxels = 0;
  world.project.settings.join.block = 16;
  const auto state = world.run(world.folder / "blocks", noProgress(), options);
  ASSERT_TRUE(state) << state.error();
  for (const char* name : {"volume.mha", "coverage.mha", "source.mha", "level.mha"}) {
    const auto whole = readVolume(world.folder / "whole" / name);
    const auto blocks = readVolume(world.folder / "blocks" / name);
    ASSERT_TRUE(whole && blocks);
    EXPECT_EQ(whole->volume, blocks->volume) << name;
  }
}

TEST(Chain, WritesTheLevelOfTheTissueBesideItsVolume) {
  ChainWorld world;
  const auto state = world.run(world.folder / "out");
  ASSERT_TRUE(state) << state.error();
  EXPECT_EQ(state->level, world.folder / "out/level.mha");
  const auto level = readLabelVolume(state->level);
  auto whole = readVolume(state->volume);
  ASSERT_TRUE(level && whole);
  ASSERT_TRUE(readCoverageInto(whole->volume, state->coverage));
  EXPECT_EQ(level->volume.grid, whole->volume.grid);
  const auto expected = levelOf(whole->volume);
  ASSERT_TRUE(expected);
  EXPECT_EQ(level->volume.echo, *expected);
}

TEST(Chain, RefusesAFolderInWhichAnotherRunIsAtWork) {
  ChainWorld world;
  fs::create_directories(world.folder / "out/steps");
  const int other = ::open((world.folder / "out/steps/.lock").c_str(), O_RDWR | O_CREAT, 0666);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  const auto refused = world.run(world.folder / "out");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::notWritable);
  EXPECT_NE(refused.error().sentence().find("Another run"), std::string::npos) << refused.error();
  ::close(other);
  EXPECT_TRUE(world.run(world.folder / "out"));
}

TEST(Chain, MakesAgainWhatWasDamagedBetweenRuns) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  ASSERT_TRUE(world.run(into));
  const auto expected = ChainWorld::resultIn(into);
  // A file of the result itself that holds something else is somebody else's (chain_folder_test.cpp).
  std::vector<fs::path> kept;
  for (const auto& each : fs::recursive_directory_iterator(into / "steps"))
    if (each.is_regular_file() && each.path().filename() != ".lock") kept.push_back(each.path());
  for (const fs::path& file : kept) {
    test::writeText(file, "{ \"key\": 3");
    const auto state = world.run(into);
    ASSERT_TRUE(state) << file << state.error();
    EXPECT_EQ(ChainWorld::resultIn(into), expected) << file;
  }
}

TEST(Chain, FindsSeamsAndWarpsAgain) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  const auto first = world.run(into);
  ASSERT_TRUE(first) << first.error();
  const auto second = world.run(into);
  ASSERT_TRUE(second) << second.error();
  EXPECT_EQ(redone(*second), std::vector<std::string>{});
  EXPECT_EQ(second->seams, first->seams);
  EXPECT_EQ(second->warps, first->warps);
}

TEST(Chain, TakesAwayWhatEarlierRunsLeftTheLongestUnusedFirst) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  const auto runWith = [&](double fallOff_mm, std::uint64_t keepBytes) {
    world.project.settings.fallOff_mm = fallOff_mm;
    ChainOptions options;
    options.keepBytes = keepBytes;
    auto state = world.run(into, noProgress(), options);
    EXPECT_TRUE(state);
    return state ? std::move(*state) : ChainState{};
  };
  const std::uint64_t all = ~std::uint64_t{0};
  runWith(15.0, all);
  const auto whole = ChainWorld::entriesIn(into);
  runWith(16.0, all);
  runWith(17.0, all);
  EXPECT_EQ(redone(runWith(15.0, all)), std::vector<std::string>{"volume"}) << "an edit taken back finds what was found";
  const auto entries = ChainWorld::entriesIn(into);

  EXPECT_EQ(entries.size(), whole.size() + 4) << "bends and seams of two other runs";
  EXPECT_EQ(runWith(15.0, all).pruned_bytes, 0u);

  // A byte too much: one result goes, of the run with 16, which is longer ago than that with 17.
  std::uint64_t unused = 0;
  for (const auto& each : fs::recursive_directory_iterator(into / "steps")) {
    if (!each.is_regular_file()) continue;
    const std::string key = each.path().filename().string().substr(0, 32);
    const std::string entry = "steps/" + each.path().parent_path().filename().string() + "/" + key + ".json";
    if (entries.contains(entry) && !whole.contains(entry)) unused += each.file_size();
  }
  EXPECT_EQ(runWith(15.0, unused).pruned_bytes, 0u);
  EXPECT_GT(runWith(15.0, unused - 1).pruned_bytes, 0u);
  EXPECT_EQ(ChainWorld::entriesIn(into).size() + 1, entries.size());
  EXPECT_EQ(redone(runWith(17.0, all)), std::vector<std::string>{"volume"});
  EXPECT_EQ(redone(runWith(16.0, all)), (std::vector<std::string>{"elastic", "volume"}));

  // Nothing but what is used: also what nothing has to read, as warps of pairs under the warps of all.
  runWith(15.0, all);
  EXPECT_GT(runWith(15.0, 0).pruned_bytes, 0u);
  const auto left = ChainWorld::entriesIn(into);
  EXPECT_EQ(left.size(), whole.size());
  for (const auto& [name, time] : whole) EXPECT_TRUE(left.contains(name)) << name;
  EXPECT_EQ(redone(runWith(15.0, 0)), std::vector<std::string>{});
  EXPECT_EQ(ChainWorld::leftoversIn(into), std::vector<std::string>{});
}

TEST(Chain, SaysWhatIsWrongWithItsInputs) {
  ChainWorld world;
  const auto refused = [&](const std::function<void(StitchProject&)>& spoil) {
    StitchProject project = world.project;
    spoil(project);
    std::swap(world.project, project);
    const auto state = world.run(world.folder / "out");
    std::swap(world.project, project);
    EXPECT_FALSE(state);
    return state ? Error{} : state.error();
  };
  const auto missing = refused([](StitchProject& p) { p.volumes[1].file += ".gone"; });
  EXPECT_EQ(missing.code, ErrorCode::notFound);
  EXPECT_NE(missing.sentence().find("b.mha.gone"), std::string::npos) << missing;
  test::writeText(world.folder / "text.mha", "no volume at all");
  const auto unreadable = refused([&](StitchProject& p) { p.volumes[2].file = world.folder / "text.mha"; });
  EXPECT_NE(unreadable.sentence().find("text.mha"), std::string::npos) << unreadable;
  Volume other;
  other.grid.dims = {3, 3, 3};
  other.echo.assign(27, 2);
  ASSERT_TRUE(writeVolume(other, world.folder / "other.mha"));
  const auto grid = refused([&](StitchProject& p) { p.volumes[0].coverage = world.folder / "other.mha"; });
  EXPECT_EQ(grid.code, ErrorCode::badField);
  EXPECT_NE(grid.sentence().find("another grid"), std::string::npos) << grid;
  const auto confidence = refused([&](StitchProject& p) { p.volumes[0].confidence = world.folder / "other.mha"; });
  EXPECT_NE(confidence.sentence().find("confidence"), std::string::npos) << confidence;
  EXPECT_EQ(refused([](StitchProject& p) { p.volumes.clear(); }).code, ErrorCode::emptyVolume);
  EXPECT_FALSE(fs::exists(world.folder / "out/volume.mha"));

  test::writeText(world.folder / "file", "not a folder");
  const auto blocked = world.run(world.folder / "file");
  ASSERT_FALSE(blocked);
  EXPECT_EQ(blocked.error().code, ErrorCode::notWritable) << blocked.error();
}

TEST(Chain, IsRefusedBeforeItTakesMoreMemoryThanAllowed) {
  ChainWorld world;
  ChainOptions options;
  options.maxBytes = 10000;
  const auto state = world.run(world.folder / "out", noProgress(), options);
  ASSERT_FALSE(state);
  EXPECT_EQ(state.error().code, ErrorCode::tooLarge) << state.error();
  EXPECT_NE(state.error().sentence().find("MiB"), std::string::npos);
}

TEST(Chain, TakesNoMoreInAnyStepThanItsForecast) {
  ChainWorld small(36);
  ASSERT_TRUE(small.run(small.folder / "out"));  // what a program needs once is there afterwards
  ChainWorld world(120);
  ChainOptions options;
  options.threads = 2;
  options.keepVolumes = false;
  MemoryWatch memory;
  if (!memory.isKnown()) GTEST_SKIP() << "nobody says here what a process takes";
  double held_mib = 0.0;  // the inputs alone
  options.onStep = [&](const StepOutcome& step) {
    const double forecast_mib = static_cast<double>(step.forecast_bytes) / (1024.0 * 1024.0);
    EXPECT_LE(memory.peak_mib(), forecast_mib) << nameOf(step.step) << ", afterwards " << memory.now_mib();
    if (step.step == Step::graph) held_mib = forecast_mib;
    if (step.step > Step::graph) {
      EXPECT_LE(memory.now_mib(), held_mib) << nameOf(step.step) << " gave back what it freed";
    }
    memory.forgetPeak();
  };
  const auto state = world.run(world.folder / "out", noProgress(), options);
  ASSERT_TRUE(state) << state.error();
}

TEST(Chain, ForecastsWhatIsLeftToDoAndNeed) {
  ChainWorld world;
  const auto fresh = forecastChain(world.project, world.folder / "out", {});
  ASSERT_TRUE(fresh) << fresh.error();
  EXPECT_GT(fresh->peak_bytes, 3u * 36u * 32u * 28u);
  for (const auto& step : fresh->steps) EXPECT_FALSE(step.done);
  EXPECT_FALSE(fs::exists(world.folder / "out")) << "a forecast leaves nothing";
  ASSERT_TRUE(world.run(world.folder / "out"));
  const auto later = forecastChain(world.project, world.folder / "out", {});
  ASSERT_TRUE(later) << later.error();
  for (const auto& step : later->steps) EXPECT_TRUE(step.done) << nameOf(step.step);
  world.project.settings.fallOff_mm = 33.0;
  const auto changed = forecastChain(world.project, world.folder / "out", {});
  ASSERT_TRUE(changed);
  for (const auto& step : changed->steps) EXPECT_EQ(step.done, step.step < Step::elastic) << nameOf(step.step);
}

TEST(Chain, LeavesOutWhatNothingHoldsToTheOthers) {
  ChainWorld world;
  ProjectPair apart;
  apart.fixed = 1;
  apart.moving = 2;
  apart.decision = Decision::rejected;
  ProjectPair other = apart;
  other.fixed = 0;
  world.project.pairs = {other, apart};
  ProjectPair together;
  together.fixed = 0;
  together.moving = 1;
  together.method = PairMethod::byHand;
  together.start = fixedToMovingOf(world.project.volumes[0].toWorld, world.project.volumes[1].toWorld);
  world.project.pairs.push_back(together);
  for (auto& volume : world.project.volumes) volume.placement = Placement::unknown;
  world.project.settings.elastic = false;
  const auto state = world.run(world.folder / "out");
  ASSERT_TRUE(state) << state.error();
  EXPECT_EQ(state->leftOut, std::vector<std::size_t>{2});
  EXPECT_NE(state->verdict, registration::Verdict::aligned);
  EXPECT_NE(state->reason.english().find("c.mha"), std::string::npos) << state->reason;
  const auto source = readVolume(world.folder / "out/source.mha");
  ASSERT_TRUE(source);
  EXPECT_EQ(std::count(source->volume.echo.begin(), source->volume.echo.end(), 3), 0);
  ASSERT_TRUE(state->report);
  EXPECT_NE(state->report->notes.back().english().find("c.mha"), std::string::npos);
}

}  // namespace
}  // namespace ew::stitching::chain_test
