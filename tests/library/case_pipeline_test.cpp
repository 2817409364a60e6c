#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <thread>
#include <vector>

#include "counted_stop.h"
#include "ew/acquisition/import.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/library/case_truth.h"
#include "ew/library/preparation.h"
#include "ew/phantom/truth.h"
#include "ew/phantom/virtual_sweep.h"
#include "library/pipeline_fixture.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::case_pipeline_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::CasePipeline;
using test::EnvironmentValue;
using test::makeSmallCase;
using test::opened;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

/// Counts reports and cancels at one of them.
class CancelAt final : public Progress {
 public:
  explicit CancelAt(int report = 1 << 30) : at_(report) {}
  void report(const Message& what, double fraction) override {
    const std::string said = what.english();
    steps.insert(said.substr(0, said.find(',')));
    backwards = backwards || fraction < furthest;
    furthest = fraction;
    ++reports;
  }
  [[nodiscard]] bool cancelRequested() const override { return reports >= at_; }
  /// How many pieces of work were still finished.
  [[nodiscard]] int reportsAfterwards() const { return std::max(0, reports - at_); }
  int reports = 0;
  double furthest = 0.0;
  bool backwards = false;
  std::set<std::string> steps;

 private:
  int at_;
};

TEST_F(CasePipeline, MakesAVolumeThatShowsThePatientWhereHeIs) {
  const Case small = opened(folder / "case");
  EXPECT_TRUE(caseNeedsPreparation(small));
  CancelAt watched;
  const auto echo = loadCaseVolume(small, watched, {.keepSweeps = folder / "sweeps"});
  ASSERT_TRUE(echo) << echo.error();
  EXPECT_TRUE(echo->notes.empty()) << echo->notes.front();
  EXPECT_FALSE(watched.backwards);
  for (const char* step : {"Recording the sweep 'upper'", "Recording the sweep 'lower'", "Reconstructing the sweep 'upper'", "Stitching"})
    EXPECT_TRUE(watched.steps.count(step)) << step;
  EXPECT_FALSE(caseNeedsPreparation(small));
  const auto meanAround = [&](const glm::dvec3& p_mm) {
    const auto p = glm::ivec3(glm::round((echo->volume.grid.worldToVoxel() * Point<frame::World>{p_mm}).at));
    double sum = 0.0, count = 0.0;
    for (int k = -3; k <= 3; ++k)
      for (int j = -3; j <= 3; ++j)
        for (int i = -3; i <= 3; ++i) {
          const std::size_t at = echo->volume.grid.indexOf(p.x + i, p.y + j, p.z + k);
          if (echo->volume.coverageAt(at) == Coverage::absent) continue;
          sum += echo->volume.echo[at];
          count += 1.0;
        }
    EXPECT_GT(count, 100.0);
    return sum / count;
  };
  const double cyst = meanAround({0, -20, 0});
  EXPECT_LT(cyst + 40.0, meanAround({-15, -35, 0}));
  EXPECT_LT(cyst + 40.0, meanAround({15, -35, 3}));
  ASSERT_TRUE(echo->labels);
  EXPECT_EQ(echo->labels->grid.spacing_mm.x, 2.0);
  const auto p = glm::ivec3(glm::round((echo->labels->grid.worldToVoxel() * Point<frame::World>{{0, -20, 0}}).at));
  EXPECT_EQ(echo->labels->echo[echo->labels->grid.indexOf(p.x, p.y, p.z)], 1);
  for (const char* name : {"upper.igs.mha", "lower.igs.mha", "upper.xml", "lower.xml"})
    EXPECT_TRUE(fs::exists(folder / "sweeps" / name)) << name;
  const auto recording = readSequence(folder / "sweeps/upper.igs.mha");
  ASSERT_TRUE(recording) << recording.error();
  EXPECT_EQ(recording->frames.size(), 10u);
}

TEST_F(CasePipeline, KeepsTheLevelOfWhatWasRecordedAndFindsItForAVolumeThatWasJoinedBefore) {
  const Case small = opened(folder / "case");
  const auto first = loadCaseVolume(small, noProgress());
  ASSERT_TRUE(first) << first.error();
  ASSERT_TRUE(first->tissue);
  EXPECT_TRUE(first->tissue->isRecorded);
  EXPECT_EQ(first->tissue->grid, first->volume.grid);
  const auto expected = levelOf(first->volume);
  ASSERT_TRUE(expected);
  EXPECT_EQ(first->tissue->level, *expected);
  const auto again = loadCaseVolume(small, noProgress());
  ASSERT_TRUE(again && again->tissue);
  EXPECT_EQ(*again->tissue, *first->tissue);

  fs::remove_all(cacheFolder() / "steps" / "maps");
  EXPECT_TRUE(caseNeedsPreparation(small));
  CancelAt watched;
  const auto found = loadCaseVolume(small, watched);
  ASSERT_TRUE(found && found->tissue);
  EXPECT_EQ(*found->tissue, *first->tissue);
  EXPECT_FALSE(watched.steps.count("Recording the sweep 'upper'"));
  EXPECT_FALSE(caseNeedsPreparation(small));
}

TEST_F(CasePipeline, GivesTheSameVolumeWhateverStoppedItAndWhenever) {
  const Case small = opened(folder / "case");
  const auto whole = loadCaseVolume(small, noProgress());
  ASSERT_TRUE(whole) << whole.error();
  CancelAt counting;
  {
    const EnvironmentValue other("ECHOWEAVE_CACHE", folder / "counting");
    ASSERT_TRUE(loadCaseVolume(small, counting));
  }
  ASSERT_GT(counting.reports, 20);
  const EnvironmentValue other("ECHOWEAVE_CACHE", folder / "interrupted");
  int cancelled = 0;
  int longest = 0;
  for (int report = 1; report < counting.reports; report += std::max(1, counting.reports / 12)) {
    CancelAt cancel(report);
    const auto stopped = loadCaseVolume(small, cancel);
    if (stopped) break;  // so much was kept that there was less left to do than this
    ASSERT_EQ(stopped.error().code, ErrorCode::cancelled) << stopped.error();
    longest = std::max(longest, cancel.reportsAfterwards());
    ++cancelled;
  }
  EXPECT_GE(cancelled, 3);
  EXPECT_LE(longest, test::kMostReportsAfter) << "it went on after it was asked to stop";
  const auto resumed = loadCaseVolume(small, noProgress());
  ASSERT_TRUE(resumed) << resumed.error();
  EXPECT_EQ(resumed->volume, whole->volume);
  EXPECT_EQ(resumed->labels->echo, whole->labels->echo);
  EXPECT_TRUE(resumed->notes.empty()) << resumed->notes.front();
}

TEST_F(CasePipeline, GoesOnWhereAKilledProgramWas) {
  const Case small = opened(folder / "case");
  CancelAt counting;
  const auto whole = loadCaseVolume(small, counting);
  ASSERT_TRUE(whole) << whole.error();
  const EnvironmentValue other("ECHOWEAVE_CACHE", folder / "killed");
  int killed = 0;
  for (int n = 1; n <= 6; ++n) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      /// Dies in the middle, without a chance to tidy up.
      class KillAt final : public Progress {
       public:
        explicit KillAt(int report) : left_(report) {}
        void report(const Message&, double) override {
          if (--left_ <= 0) ::kill(::getpid(), SIGKILL);
        }
        [[nodiscard]] bool cancelRequested() const override { return false; }

       private:
        std::atomic<int> left_;
      } kill(n * counting.reports / 7);
      const auto made = loadCaseVolume(small, kill);
      ::_exit(made ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    if (WIFSIGNALED(status)) ++killed;
  }
  EXPECT_GE(killed, 2);
  CancelAt watched;
  const auto resumed = loadCaseVolume(small, watched);
  ASSERT_TRUE(resumed) << resumed.error();
  EXPECT_EQ(resumed->volume, whole->volume);
  EXPECT_EQ(resumed->labels->echo, whole->labels->echo);
}

TEST_F(CasePipeline, MakesAgainOnlyWhatDependsOnAChangedSweep) {
  ASSERT_TRUE(loadCaseVolume(opened(folder / "case"), noProgress()));
  json sweep = json::parse(textOf(folder / "case/sweeps/lower.json"));
  sweep["frames"] = 11;
  writeText(folder / "case/sweeps/lower.json", sweep.dump());
  const Case changed = opened(folder / "case");
  EXPECT_TRUE(caseNeedsPreparation(changed));
  CancelAt watched;
  ASSERT_TRUE(loadCaseVolume(changed, watched));
  EXPECT_FALSE(watched.steps.count("Recording the sweep 'upper'"));
  EXPECT_FALSE(watched.steps.count("Reconstructing the sweep 'upper'"));
  EXPECT_TRUE(watched.steps.count("Recording the sweep 'lower'"));

  json manifest = json::parse(textOf(folder / "case/case.json"));
  manifest["volume"]["reconstruct"]["feather_mm"] = 3;
  writeText(folder / "case/case.json", manifest.dump());
  CancelAt again;
  ASSERT_TRUE(loadCaseVolume(opened(folder / "case"), again));
  EXPECT_FALSE(again.steps.count("Recording the sweep 'lower'")) << "another seam needs no other recording";
  EXPECT_TRUE(again.steps.count("Stitching"));
  manifest["history"] = "Something else.";
  writeText(folder / "case/case.json", manifest.dump());
  EXPECT_FALSE(caseNeedsPreparation(opened(folder / "case"))) << "words shape no voxel";
}

TEST_F(CasePipeline, LeavesWhatTheCaseDoesNotSayToTheRecordingAsWindowAndCommandsDo) {
  json manifest = json::parse(textOf(folder / "case/case.json"));
  for (const char* open : {"spacing_mm", "interpolation", "compounding", "fill_reach_mm"}) manifest["volume"]["reconstruct"].erase(open);
  writeText(folder / "case/case.json", manifest.dump());
  const auto made = loadCaseVolume(opened(folder / "case"), noProgress(), {.keepSweeps = folder / "sweeps"});
  ASSERT_TRUE(made) << made.error();
  double finest_mm = 1e9;
  for (const std::string name : {"upper", "lower"}) {
    SweepImportOptions options;
    options.calibrations = {folder / "sweeps" / (name + ".xml")};
    options.usual = {.spacing = true, .interpolation = true, .compounding = true, .fillReach = true};
    const auto sweep = openSweep(folder / "sweeps" / (name + ".igs.mha"), options, noProgress());
    ASSERT_TRUE(sweep) << sweep.error();
    finest_mm = std::min(finest_mm, sweep->plan.reconstruct.spacing_mm);
  }
  EXPECT_NEAR(made->volume.grid.spacing_mm.x, finest_mm, 1e-9);
}

TEST_F(CasePipeline, FeathersSweepsUnlessTheCaseAsksForASeam) {
  const auto feathered = loadCaseVolume(opened(folder / "case"), noProgress());
  ASSERT_TRUE(feathered) << feathered.error();
  json manifest = json::parse(textOf(folder / "case/case.json"));
  manifest["volume"]["reconstruct"]["seam"] = "graph cut";
  writeText(folder / "case/case.json", manifest.dump());
  EXPECT_EQ(opened(folder / "case").volume.reconstruct.seam, stitching::SeamMethod::graphCut);
  EXPECT_EQ(manifestOf(opened(folder / "case"))["volume"]["reconstruct"]["seam"], "graph cut");
  CancelAt watched;
  const auto cut = loadCaseVolume(opened(folder / "case"), watched);
  ASSERT_TRUE(cut) << cut.error();
  EXPECT_FALSE(watched.steps.count("Reconstructing the sweep 'upper'")) << "the sweeps stay";
  EXPECT_EQ(cut->volume.grid, feathered->volume.grid);
  EXPECT_NE(cut->volume.echo, feathered->volume.echo);
  EXPECT_FALSE(fs::exists(folder / "cache/joins") && !fs::is_empty(folder / "cache/joins"))
      << "the chain's own steps have done their service";
  manifest["volume"]["reconstruct"]["seam"] = "glue";
  writeText(folder / "case/case.json", manifest.dump());
  EXPECT_EQ(loadCase(folder / "case").error().code, ErrorCode::badField);
}

TEST_F(CasePipeline, RecordsASweepOnceForTwoCasesThatShareItAndArePreparedTogether) {
  makeSmallCase(folder / "other");
  json manifest = json::parse(textOf(folder / "other/case.json"));
  manifest["volume"]["reconstruct"]["feather_mm"] = 3;
  writeText(folder / "other/case.json", manifest.dump());
  CancelAt first, second;
  {
    std::jthread beside([&] { EXPECT_TRUE(prepareCase(opened(folder / "other"), {}, second)); });
    EXPECT_TRUE(prepareCase(opened(folder / "case"), {}, first));
  }
  for (const char* sweep : {"upper", "lower"}) {
    const std::string recording = std::string("Recording the sweep '") + sweep + "'";
    EXPECT_EQ(first.steps.count(recording) + second.steps.count(recording), 1u) << sweep;
  }
}

TEST_F(CasePipeline, MakesAgainAVolumeWhoseHeaderWasChangedToAnotherPlace) {
  const Case small = opened(folder / "case");
  const auto whole = loadCaseVolume(small, noProgress());
  ASSERT_TRUE(whole) << whole.error();
  int changed = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "cache/steps")) {
    if (entry.path().extension() != ".mha" || entry.path().parent_path().filename() == "sweeps") continue;
    std::string text = textOf(entry.path());
    const auto spacing = text.find("ElementSpacing = ");
    ASSERT_NE(spacing, std::string::npos);
    text[spacing + 17] = '7';
    writeText(entry.path(), text);
    ++changed;
  }
  EXPECT_GE(changed, 2);
  const auto again = loadCaseVolume(small, noProgress());
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->volume, whole->volume);
  EXPECT_EQ(again->labels->grid, whole->labels->grid);
}

TEST_F(CasePipeline, MakesAgainWhatWasDamagedInTheCache) {
  const Case small = opened(folder / "case");
  const auto first = loadCaseVolume(small, noProgress());
  ASSERT_TRUE(first) << first.error();
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "cache"))
    if (entry.is_regular_file() && entry.path().extension() != ".lock" && entry.path().filename() != ".lock" &&
        entry.path().filename() != "speed.json")
      files.push_back(entry.path());
  EXPECT_GE(files.size(), 10u) << "two sweeps, the volume, its labels and the truth";
  for (const auto& file : files) {
    const std::string kept = textOf(file);
    std::string flipped = kept;
    flipped[flipped.size() / 2 + flipped.size() / 3] = static_cast<char>(flipped[flipped.size() / 2 + flipped.size() / 3] ^ 1);
    writeText(file, flipped);
    const auto again = loadCaseVolume(small, noProgress());
    ASSERT_TRUE(again) << file << again.error();
    EXPECT_EQ(again->volume, first->volume) << file;
    EXPECT_EQ(again->labels->echo, first->labels->echo) << file;
    writeText(file, kept);
  }
}

TEST_F(CasePipeline, OpensTheCaseWhenTheCacheCannotBeWrittenAndSaysSoOnce) {
  writeText(folder / "file", "where the cache folder would have to be");
  const EnvironmentValue blocked("ECHOWEAVE_CACHE", folder / "file");
  const auto echo = loadCaseVolume(opened(folder / "case"), noProgress());
  ASSERT_TRUE(echo) << echo.error();
  EXPECT_GT(echo->volume.echo.size(), 0u);
  ASSERT_EQ(echo->notes.size(), 1u);
  EXPECT_NE(echo->notes[0].english().find("ECHOWEAVE_CACHE"), std::string::npos) << echo->notes[0];
}

TEST_F(CasePipeline, TwoProgramsAtOnceMakeItOnceAndTheSame) {
  const Case small = opened(folder / "case");
  std::vector<pid_t> children;
  for (int n = 0; n < 2; ++n) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      CancelAt watched;
      const auto made = loadCaseVolume(small, watched);
      ::_exit(!made || !made->notes.empty() ? 3 : watched.steps.count("Stitching") != 0 ? 1 : 2);
    }
    children.push_back(child);
  }
  std::multiset<int> outcomes;
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    outcomes.insert(WIFEXITED(status) ? WEXITSTATUS(status) : -1);
  }
  EXPECT_EQ(outcomes, (std::multiset<int>{1, 2})) << "one makes it, the other waits and reads";
}

TEST_F(CasePipeline, DoesNotDependOnTheNumberOfThreads) {
  const Case small = opened(folder / "case");
  const auto two = loadCaseVolume(small, noProgress(), {.threads = 2});
  ASSERT_TRUE(two) << two.error();
  const EnvironmentValue other("ECHOWEAVE_CACHE", folder / "one");
  const auto one = loadCaseVolume(small, noProgress(), {.threads = 1});
  ASSERT_TRUE(one) << one.error();
  EXPECT_EQ(one->volume, two->volume);
  EXPECT_EQ(one->labels->echo, two->labels->echo);
}

constexpr const char* kSteps[] = {"patient", "voxels", "recording", "reconstructing", "stitch"};

/// What earlier preparations are said to have taken on this machine: seconds for a unit of work, so that no test waits for a clock.
void pretendSpeed(const fs::path& cache, const std::string& step, double rate, double others) {
  json speed;
  for (const char* name : kSteps) speed[name] = name == step ? rate : others;
  writeText(cache / "speed.json", speed.dump());
}

/// Gives a sweep of the small case another number of frames, so that it is recorded again.
void setFrames(const fs::path& sweepFile, int frames) {
  json sweep = json::parse(textOf(sweepFile));
  sweep["frames"] = frames;
  writeText(sweepFile, sweep.dump());
}

TEST_F(CasePipeline, EstimatesTheTimeFromTheWorkThatIsLeftAndFromWhatEachStepTookHere) {
  EXPECT_FALSE(estimatePreparation(opened(folder / "case"))->measured) << "nothing was ever prepared here";
  ASSERT_TRUE(prepareCase(opened(folder / "case"), {}, noProgress()));
  EXPECT_EQ(estimatePreparation(opened(folder / "case"))->seconds, 0.0);
  const json kept = json::parse(textOf(folder / "cache/speed.json"));
  for (const char* step : {"patient", "recording", "reconstructing", "stitch"}) EXPECT_GT(kept.value(step, 0.0), 0.0) << step;

  const auto estimated = [&](int frames) {
    setFrames(folder / "case/sweeps/upper.json", frames);
    const auto estimate = estimatePreparation(opened(folder / "case"));
    EXPECT_TRUE(estimate);
    EXPECT_TRUE(estimate->measured);
    return estimate ? estimate->seconds : 0.0;
  };
  pretendSpeed(folder / "cache", "", 0.0, 2.0);
  const double twice = estimated(30);
  pretendSpeed(folder / "cache", "", 0.0, 1.0);
  const double once = estimated(30);
  EXPECT_GT(once, 0.0);
  EXPECT_NEAR(twice, 2.0 * once, 1e-9 * twice) << "a machine half as fast takes twice as long";
  double sum = 0.0;
  for (const char* step : kSteps) {
    pretendSpeed(folder / "cache", step, 1.0, 1e-12);
    sum += estimated(30);
  }
  EXPECT_NEAR(sum, once, 1e-6 * once) << "the steps one after another";
  pretendSpeed(folder / "cache", "recording", 1.0, 1e-12);
  const double thirty = estimated(30);
  EXPECT_NEAR(estimated(60), 2.0 * thirty, 0.1 * thirty) << "a recording takes as long as it has frames";
  pretendSpeed(folder / "cache", "voxels", 1.0, 1e-12);
  EXPECT_LT(estimated(60), 1e-6) << "nothing is voxelised here";
}

TEST_F(CasePipeline, ReportsTheShareOfTheTimeExpectedAndWhatIsLeftOfIt) {
  class Said final : public Progress {
   public:
    void report(const Message& what, double fraction) override { all.emplace_back(what.english(), fraction); }
    [[nodiscard]] bool cancelRequested() const override { return false; }
    std::vector<std::pair<std::string, double>> all;
  } said;
  // Stitching is said to take weeks: next to that nothing has passed before it begins, however slow the machine is.
  pretendSpeed(folder / "cache", "stitch", 1e9, 1e-9);
  ASSERT_TRUE(prepareCase(opened(folder / "case"), {}, said));
  bool stitches = false;
  for (const auto& [what, fraction] : said.all) {
    stitches = stitches || what.starts_with("Stitching");
    if (stitches) continue;
    EXPECT_LT(fraction, 0.05) << what;
    EXPECT_TRUE(what.ends_with(" min left")) << what;
  }
  EXPECT_TRUE(stitches);
  EXPECT_GT(said.all.back().second, 0.9) << "its own speed counts once it is under way";
}

TEST_F(CasePipeline, NamesTheSweepOrProbeThatCannotBeUsed) {
  json sweep = json::parse(textOf(folder / "case/sweeps/lower.json"));
  sweep["probe"] = "no-such-probe";
  writeText(folder / "case/sweeps/lower.json", sweep.dump());
  const auto refused = loadCaseVolume(opened(folder / "case"), noProgress());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::badField);
  EXPECT_NE(refused.error().sentence().find("no-such-probe"), std::string::npos) << refused.error();
  sweep["probe"] = "linear-7.5";
  sweep["kind"] = "wobble";
  writeText(folder / "case/sweeps/lower.json", sweep.dump());
  EXPECT_FALSE(loadCaseVolume(opened(folder / "case"), noProgress()));
  EXPECT_FALSE(fs::exists(folder / "cache")) << "nothing is begun";
}

TEST_F(CasePipeline, KnowsTheTruthOfItsTargetsAndMeasurements) {
  json manifest = json::parse(textOf(folder / "case/case.json"));
  const std::vector<double> place = {0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1};
  manifest["volume"]["file_to_world"] = place;
  writeText(folder / "case/case.json", manifest.dump());
  const Case small = opened(folder / "case");
  for (const bool fromCache : {false, true}) {
    const auto truth = loadCaseTruth(small, noProgress());
    ASSERT_TRUE(truth) << truth.error();
    ASSERT_EQ(truth->measurements.size(), 1u) << fromCache;
    EXPECT_NEAR(truth->measurements[0].value, 24.0, 0.1);
    EXPECT_EQ(truth->measurements[0].unit, "mm");
    EXPECT_EQ(truth->measurements[0].tolerance, 2.0);
    ASSERT_EQ(truth->planes.size(), 1u);
    EXPECT_LT(glm::length(glm::dvec3(truth->planes[0].probeToWorld.matrix[3]) - glm::dvec3(70, 20, 30)), 0.5) << "placed with the case";
    ASSERT_EQ(truth->structures.size(), 1u);
    EXPECT_EQ(truth->structures[0].label, 1);
  }
  // A copy in the cache that says something else, as long as before.
  for (const auto& entry : fs::directory_iterator(folder / "cache/steps/truths")) {
    if (entry.path().extension() != ".json") continue;
    std::string text = textOf(entry.path());
    const auto value = text.find("\"value\": 2");
    ASSERT_NE(value, std::string::npos) << text;
    text[value + 9] = '7';
    writeText(entry.path(), text);
  }
  const auto again = loadCaseTruth(small, noProgress());
  ASSERT_TRUE(again) << again.error();
  EXPECT_NEAR(again->measurements[0].value, 24.0, 0.1);
  manifest["measurements"][0]["name"] = "spleen";
  writeText(folder / "case/case.json", manifest.dump());
  const auto unknown = loadCaseTruth(opened(folder / "case"), noProgress());
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::badField);
  EXPECT_NE(unknown.error().sentence().find("cyst, across"), std::string::npos) << "says which there are: " << unknown.error();
}

}  // namespace
}  // namespace ew::case_pipeline_test
