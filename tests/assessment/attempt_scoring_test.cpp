#include "ew/assessment/attempt_scoring.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <set>

#include "assessment/assessed_world.h"
#include "ew/assessment/attempt_result.h"
#include "ew/library/step_answer.h"
#include "memory_in_use.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::AssessedWorld;
using test::heldAt;
using test::scanAlong;

ScanLog stayedAt(double z_mm) {
  return scanAlong([=](double t) { return heldAt(std::max(z_mm, z_mm + 20.0 - 4.0 * t)); }, 8.0);
}

std::vector<AssessedWorld::Tried> goodTries() {
  return {{.step = "read", .verdict = StepVerdict::passed, .score = 1.0},
          {.step = "plane", .scan = stayedAt(1.0)},
          {.step = "sweep", .scan = scanAlong([](double t) { return heldAt(-25.0 + 2.5 * t); }, 20.0)},
          {.step = "measure", .scan = stayedAt(0.0), .answer = MeasurementAnswer{40.5, "mm", "distance", {{-20, 0, 0}, {20.5, 0, 0}}}},
          {.step = "point", .scan = stayedAt(0.0), .answer = PointAnswer{{1.0, 0.0, 0.0}}},
          {.step = "answer", .answer = OptionsAnswer{{0}}},
          {.step = "free", .scan = scanAlong([](double t) { return heldAt(-25.0 + 2.5 * t); }, 20.0)}};
}

AttemptScore scored(const AssessedWorld& world, const fs::path& folder) {
  const auto all = assess({folder}, world.library());
  EXPECT_EQ(all.size(), 1u);
  EXPECT_FALSE(all[0].problem) << *all[0].problem;
  return all[0].score.value_or(AttemptScore{});
}

TEST(ScoreOfAnAttempt, IsWorkedOutFromTheRawDataAlone) {
  const AssessedWorld world;
  const AttemptScore score = scored(world, world.keep("20261101-100000-aaaaaaaa", goodTries()));
  ASSERT_EQ(score.steps.size(), 7u);
  for (const StepScore& step : score.steps) EXPECT_EQ(step.verdict, StepVerdict::passed) << step.stepId << " " << step.score;
  EXPECT_NEAR(score.of("plane")->task, 1.0 - 0.3 * (1.0 / 5.0), 1e-6) << "1 mm of 5 mm tolerance, though the lesson had said 0";
  EXPECT_NEAR(*valueOf(score.of("measure")->metrics, "measurement_error"), 1.25, 1e-9);
  EXPECT_NEAR(*valueOf(score.of("point")->metrics, "landmark_distance"), 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(*valueOf(score.of("answer")->metrics, "answer_error"), 0.0);
  EXPECT_DOUBLE_EQ(score.of("read")->weight, 0.0) << "what is only read says nothing of a skill";
  EXPECT_TRUE(score.passed);
  EXPECT_TRUE(score.of("sweep")->isJudgedAnew);
}

TEST(ScoreOfAnAttempt, CountsStepsThatWereNeverEndedAsNothing) {
  const AssessedWorld world;
  const AttemptScore score = scored(world, world.keep("20261101-100000-aaaaaaab", {{.step = "plane", .scan = stayedAt(0.0)}}));
  EXPECT_EQ(score.of("sweep")->verdict, StepVerdict::skipped);
  EXPECT_FALSE(score.passed);
  EXPECT_NEAR(score.score, 1.0 / 6.0, 1e-9);
}

TEST(ScoreOfAnAttempt, KeepsTheVerdictWhereTheRawDataAreGone) {
  const AssessedWorld world;
  auto tries = goodTries();
  tries[1].score = 0.9;
  tries[1].verdict = StepVerdict::passed;
  const fs::path folder = world.keep("20261101-100000-aaaaaaac", tries);
  const auto kept = AttemptFolder::open(folder);
  ASSERT_TRUE(kept);
  std::ofstream(folder / kept->attempt().outcomeOf("plane")->recording) << "torn";
  const AttemptScore score = scored(world, folder);
  EXPECT_FALSE(score.of("plane")->isJudgedAnew);
  EXPECT_DOUBLE_EQ(score.of("plane")->task, 0.9);
  ASSERT_FALSE(score.notes.empty());
  EXPECT_NE(score.notes[0].english().find("plane"), std::string::npos);
}

TEST(ScoreOfAnAttempt, IsTheSameOnOneAndTwoThreadsAndFromAnotherFolder) {
  const AssessedWorld world;
  std::vector<fs::path> folders;
  for (int n = 0; n < 6; ++n) folders.push_back(world.keep("20261101-10000" + std::to_string(n) + "-bbbbbbbb", goodTries()));
  const auto one = assess(folders, world.library(), {.threads = 1});
  const auto two = assess(folders, world.library(), {.threads = 2, .again = true});
  const test::TemporaryFolder elsewhere;
  fs::copy(folders[0], elsewhere / "carried", fs::copy_options::recursive);
  fs::remove_all(elsewhere / "carried" / "scores");
  for (std::size_t n = 0; n < folders.size(); ++n) {
    ASSERT_TRUE(one[n].score && two[n].score);
    EXPECT_TRUE(two[n].wasUpToDate) << "made again, it came out the same";
    EXPECT_EQ(*one[n].score, *two[n].score);
  }
  AttemptScore carried = scored(world, elsewhere / "carried");
  carried.madeAt = one[0].score->madeAt;
  EXPECT_EQ(carried, *one[0].score);
}

TEST(ScoreOfAnAttempt, IsKeptBesideEarlierOnesWhenAnythingChanges) {
  const AssessedWorld world;
  const fs::path folder = world.keep("20261101-100000-cccccccc", goodTries());
  const AttemptScore first = scored(world, folder);
  EXPECT_EQ(scored(world, folder), first) << "nothing changed, nothing is added";
  EXPECT_EQ(scoresOf(folder).size(), 1u);

  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  plan.at("plane").passLevel = 0.99;
  ASSERT_TRUE(keepPlan(world.library(), plan));
  const AttemptScore stricter = scored(world, folder);
  EXPECT_EQ(stricter.of("plane")->verdict, StepVerdict::failed);
  EXPECT_FALSE(stricter.passed);
  EXPECT_EQ(stricter.planRevision, 1);
  const auto all = scoresOf(folder);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0], first) << "the earlier score is as it was";
  EXPECT_EQ(all[1], stricter);
  EXPECT_EQ(*latestScore(folder), stricter);
}

TEST(ScoreOfAnAttempt, WeighsMetricsAsTheInstructorSays) {
  const AssessedWorld world;
  const fs::path folder = world.keep("20261101-100000-dddddddd", goodTries());
  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  StepPlan& step = plan.at("sweep");
  step.taskWeight = 1.0;
  step.metrics = {{"path_length", 3.0, 100.0, 0.0}};  // the sweep is 50 mm long: half
  ASSERT_TRUE(keepPlan(world.library(), plan));
  const AttemptScore score = scored(world, folder);
  EXPECT_NEAR(*valueOf(score.of("sweep")->metrics, "path_length"), 50.0, 0.1);
  EXPECT_NEAR(score.of("sweep")->score, (1.0 * 1.0 + 3.0 * 0.5) / 4.0, 2e-3);
  EXPECT_EQ(score.of("sweep")->verdict, StepVerdict::failed);
}

TEST(ScoreOfAnAttempt, IsComparedWithTheExpertsAttempt) {
  const AssessedWorld world;
  const fs::path expert = world.keep("20261101-090000-eeeeeeee", goodTries());
  auto tries = goodTries();
  tries[2].scan = scanAlong([](double t) { return heldAt(-25.0 + 2.5 * t, 0.0, 6.0); }, 20.0);
  const fs::path folder = world.keep("20261101-100000-ffffffff", tries);
  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  plan.expertAttempt = expert.filename().string();
  ASSERT_TRUE(keepPlan(world.library(), plan));
  const AttemptScore score = scored(world, folder);
  EXPECT_NEAR(*valueOf(score.of("sweep")->metrics, "expert_distance"), 6.0, 0.1);
  EXPECT_EQ(score.expertAttempt, plan.expertAttempt);
  EXPECT_FALSE(valueOf(scored(world, expert).of("sweep")->metrics, "expert_distance")) << "nobody is compared with themselves";
}

TEST(ScoreOfAnAttempt, IsNotPassedBeforeTheAttemptIsFinished) {
  const AssessedWorld world;
  const fs::path folder = world.keep("20261101-100000-a1a1a1a1", goodTries());
  auto document = json::parse(test::textOf(folder / "attempt.json"));
  document.erase("finished_at");
  test::writeText(folder / "attempt.json", document.dump());
  EXPECT_FALSE(scored(world, folder).passed);
}

TEST(ScoreOfAnAttempt, IsMadeAnewWhenARecordingIsAnotherOne) {
  const AssessedWorld world;
  const fs::path folder = world.keep("20261101-100000-a2a2a2a2", goodTries());
  const AttemptScore before = scored(world, folder);
  const auto kept = AttemptFolder::open(folder);
  ASSERT_TRUE(kept);
  const fs::path file = folder / kept->attempt().outcomeOf("plane")->recording;
  ASSERT_TRUE(writeRecording({"ball", "Ball", {640, 480}, stayedAt(4.0), {}}, file));
  const AttemptScore after = scored(world, folder);
  EXPECT_NE(after.key, before.key);
  EXPECT_NEAR(after.of("plane")->task, 1.0 - 0.3 * 0.8, 1e-6);
}

TEST(ScoreOfAnAttempt, TakesNoMeasurementInAnotherUnitAndNothingThatWasNotWatched) {
  AssessedWorld world;
  Lesson lesson = world.lesson();
  LessonStep watch;
  watch.id = "watch";
  watch.title = "Watch";
  watch.task = WatchTask{"scans/expert.seq.mha", {}, {}, {}};
  lesson.steps.push_back(watch);
  fs::create_directories(world.caseFolder() / "parts" / "lessons" / "scans");
  ASSERT_TRUE(writeRecording({"ball", "Ball", {640, 480}, stayedAt(0.0), {}},
                             world.caseFolder() / "parts" / "lessons" / "scans" / "expert.seq.mha"));
  world.teach(lesson);
  auto tries = goodTries();
  std::get<MeasurementAnswer>(tries[3].answer).unit = "cm";
  tries.push_back({.step = "watch", .answer = WatchAnswer{false}, .verdict = StepVerdict::passed, .score = 1.0});
  const AttemptScore score = scored(world, world.keep("20261101-100000-a3a3a3a3", tries));
  EXPECT_DOUBLE_EQ(score.of("measure")->task, 0.0);
  EXPECT_DOUBLE_EQ(score.of("watch")->task, 0.0);
  tries.back().answer = {};  // as attempts were kept before answers were kept in full
  const AttemptScore older = scored(world, world.keep("20261101-100000-a4a4a4a4", tries));
  EXPECT_DOUBLE_EQ(older.of("watch")->task, 1.0);
  EXPECT_FALSE(older.of("watch")->isJudgedAnew);
}

TEST(ScoreOfAnAttempt, TakesTheSettingsOfTheExpertsAttemptBeforeThoseOfTheLessonsScan) {
  AssessedWorld world;
  const auto scanWith = [](double gain_db) {
    ScanState image = test::imageAt(heldAt());
    image.knobs.gain_db = gain_db;
    ScanLog log;
    log.addFrame(image);
    return log;
  };
  Lesson lesson = world.lesson();
  LessonStep watch;
  watch.id = "watch";
  watch.title = "Watch";
  watch.task = WatchTask{"scans/expert.seq.mha", {}, {}, {}};
  lesson.steps.push_back(watch);
  fs::create_directories(world.caseFolder() / "parts" / "lessons" / "scans");
  ASSERT_TRUE(writeRecording({"ball", "Ball", {640, 480}, scanWith(3.0), {}},
                             world.caseFolder() / "parts" / "lessons" / "scans" / "expert.seq.mha"));
  world.teach(lesson);
  const fs::path folder = world.keep("20261101-100000-a5a5a5a5", {{.step = "plane", .scan = scanWith(0.0)}});
  EXPECT_NEAR(*valueOf(scored(world, folder).of("plane")->metrics, "gain_difference"), 3.0, 1e-9);
  const fs::path expert = world.keep("20261101-090000-a6a6a6a6", {{.step = "plane", .scan = scanWith(-5.0)}});
  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  plan.expertAttempt = expert.filename().string();
  ASSERT_TRUE(keepPlan(world.library(), plan));
  EXPECT_NEAR(*valueOf(scored(world, folder).of("plane")->metrics, "gain_difference"), 5.0, 1e-9);
}

TEST(ScoreOfAnAttempt, SaysWhenTheLessonHasChangedSince) {
  AssessedWorld world;
  const fs::path folder = world.keep("20261101-100000-abababab", goodTries());
  Lesson changed = world.lesson();
  changed.steps[1].text = "Do it well.";
  world.teach(changed);
  const AttemptScore score = scored(world, folder);
  ASSERT_FALSE(score.notes.empty());
  EXPECT_NE(score.notes[0].english().find("has changed"), std::string::npos);
}

TEST(Assess, SaysOfEachFolderWhyItHasNoScore) {
  const AssessedWorld world;
  const fs::path good = world.keep("20261101-100000-acacacac", goodTries());
  const fs::path other = world.keep("20261101-100001-acacacac", goodTries());
  auto text = test::textOf(other / "attempt.json");
  text.replace(text.find("\"ball\""), 6, "\"cube\"");
  test::writeText(other / "attempt.json", text);
  const auto all = assess({good, other, world.library() / "none"}, world.library());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].score);
  ASSERT_TRUE(all[1].problem);
  EXPECT_EQ(all[1].problem->code, ErrorCode::notFound);
  EXPECT_NE(all[1].problem->sentence().find("cube"), std::string::npos);
  ASSERT_TRUE(all[2].problem);
}

/// Wants to stop after so many questions.
class StopsLater final : public Progress {
 public:
  explicit StopsLater(int questions) : left_(questions) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return left_.fetch_sub(1) <= 0; }

 private:
  mutable std::atomic<int> left_;
};

TEST(Assess, GoesOnWhereItWasStopped) {
  const AssessedWorld world;
  std::vector<fs::path> folders;
  for (int n = 0; n < 5; ++n) folders.push_back(world.keep("20261101-10000" + std::to_string(n) + "-adadadad", goodTries()));
  std::size_t before = 0;
  for (int questions = 1; questions < 4000 && before < folders.size(); questions *= 2) {
    StopsLater stops(questions);
    const auto all = assess(folders, world.library(), {.threads = 2}, stops);
    std::size_t done = 0;
    for (const AttemptAssessment& each : all) {
      done += each.score ? 1 : 0;
      if (!each.score) {
        EXPECT_EQ(each.problem->code, ErrorCode::cancelled);
      }
    }
    for (const fs::path& folder : folders) EXPECT_LE(scoresOf(folder).size(), 1u);
    before = done;
  }
  const auto all = assess(folders, world.library());
  for (const AttemptAssessment& each : all) EXPECT_TRUE(each.score);
  for (const fs::path& folder : folders) EXPECT_EQ(scoresOf(folder).size(), 1u) << "nothing is scored twice";
}

TEST(Assess, HandsOverInOrderAndHoldsNoMoreHoweverManyThereAre) {
  const AssessedWorld world;
  std::vector<fs::path> folders;
  for (int n = 0; n < 3; ++n) folders.push_back(world.keep("20261101-10000" + std::to_string(n) + "-aeaeaeae", {{.step = "answer"}}));
  constexpr std::size_t kMany = 1200;
  for (std::size_t n = folders.size(); n + 1 < kMany; ++n) folders.push_back(folders[n % 3]);
  const fs::path last = world.keep("20261101-100009-aeaeaeae", {{.step = "answer"}});
  folders.push_back(last);
  std::size_t taken = 0;
  std::uint64_t early_bytes = 0, late_bytes = 0;
  std::optional<Error> ofLast;
  assess(folders, world.library(), {.threads = 1}, noProgress(), [&](const AttemptAssessment& one) {
    ASSERT_LT(taken, kMany);
    EXPECT_EQ(one.folder, folders[taken]);
    if (++taken == kMany) {
      ofLast = one.problem;
      return;
    }
    ASSERT_FALSE(one.problem) << *one.problem;
    if (taken == kMany - 100) late_bytes = test::memoryInUse_bytes();
    if (taken != 100) return;
    early_bytes = test::memoryInUse_bytes();
    fs::remove_all(last);
  });
  EXPECT_EQ(taken, kMany);
  EXPECT_TRUE(ofLast) << "it was scored before its turn came, with all others in memory";
  // Were each kept that was handed over, it would be four times as much at least.
  constexpr std::uint64_t kLeastAttempt_bytes = sizeof(AttemptAssessment);
  EXPECT_LT(late_bytes, early_bytes + (kMany - 200) * kLeastAttempt_bytes / 4) << "a thousand attempts later";
}

TEST(AttemptScores, ComeBackFromTheirFile) {
  const AssessedWorld world;
  const AttemptScore score = scored(world, world.keep("20261101-100000-aeaeaeae", goodTries()));
  auto again = scoreFromJson(json::parse(jsonOf(score).dump()));
  ASSERT_TRUE(again) << again.error();
  again->number = score.number;
  EXPECT_EQ(*again, score);
}

TEST(AttemptScores, RefuseWhatCannotBe) {
  const AssessedWorld world;
  const json good = jsonOf(scored(world, world.keep("20261101-100000-afafafaf", goodTries())));
  for (const auto& [path, value] : std::vector<std::pair<std::string, json>>{{"/score", 1.5},
                                                                             {"/format", 99},
                                                                             {"/steps/0/verdict", "fine"},
                                                                             {"/steps/1/metrics/0/value", "far"},
                                                                             {"/made_at", "yesterday"},
                                                                             {"/key", 3}}) {
    json bad = good;
    bad[json::json_pointer(path)] = value;
    EXPECT_FALSE(scoreFromJson(bad)) << path;
  }
}

TEST(AttemptScores, AreNotReadFromAFileThatAKilledProgramLeftEmpty) {
  const AssessedWorld world;
  const fs::path folder = world.keep("20261101-100000-babababa", goodTries());
  const AttemptScore first = scored(world, folder);
  std::ofstream(folder / "scores" / "0002.json");
  EXPECT_EQ(*latestScore(folder), first);
  EXPECT_EQ(scoresOf(folder).size(), 1u);
  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  plan.passLevel = 0.5;
  ASSERT_TRUE(keepPlan(world.library(), plan));
  EXPECT_EQ(scored(world, folder).number, 3) << "and its number is not used again";
}

TEST(AssessmentPlans, ComeBackAndKeepEveryRevision) {
  const AssessedWorld world;
  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  EXPECT_EQ(plan.revision, 0);
  plan.at("plane").passLevel = 0.8;
  plan.at("plane").metrics = {{"time", 0.5, 60.0, 10.0}};
  plan.changedBy = "An instructor";
  const auto kept = keepPlan(world.library(), plan);
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_EQ(kept->revision, 1);
  EXPECT_EQ(keepPlan(world.library(), *kept)->revision, 1) << "the same decisions are not kept again";
  AssessmentPlan next = *readPlan(world.library(), "ball", "about-balls");
  EXPECT_EQ(next, *kept);
  next.passLevel = 0.6;
  EXPECT_EQ(keepPlan(world.library(), next)->revision, 2);
  EXPECT_TRUE(fs::exists(planFolder(world.library(), "ball", "about-balls") / "0001.json"));
}

/// A lesson and an attempt at it that passed every step with 0.8.
std::pair<Lesson, Attempt> triedAll(const std::vector<LessonTask>& tasks) {
  std::pair<Lesson, Attempt> made;
  for (const LessonTask& task : tasks) {
    LessonStep& step = made.first.steps.emplace_back();
    step.id = "s" + std::to_string(made.first.steps.size());
    step.task = task;
    StepOutcome& outcome = made.second.outcomes.emplace_back();
    outcome.stepId = step.id;
    outcome.verdict = StepVerdict::passed;
    outcome.score = 0.8;
    outcome.seconds = 10.0;
  }
  made.second.finishedAt = std::chrono::sys_seconds{};
  return made;
}

TEST(AttemptResult, CountsNoStepThatIsOnlyReadUnlessNothingElseIsThere) {
  const auto [mixed, tried] = triedAll({ReadingTask{}, AnswerTask{}, WatchTask{}});
  const AttemptResult result = attemptResultOf(tried, &mixed, {}, {});
  EXPECT_EQ(result.stepsJudged, 1u);
  EXPECT_EQ(result.stepsPassed, 1u);
  EXPECT_DOUBLE_EQ(*result.score(), 0.8);
  EXPECT_EQ(result.passed(), true);
  EXPECT_EQ(result.worked_s, 30.0);
  EXPECT_FALSE(result.isScored);
  const auto [read, both] = triedAll({ReadingTask{}, ReadingTask{}});
  const AttemptResult ofReading = attemptResultOf(both, &read, {}, {});
  EXPECT_EQ(ofReading.stepsJudged, 2u);
  EXPECT_DOUBLE_EQ(*ofReading.score(), 0.8) << "not 0 and passed";
  EXPECT_EQ(ofReading.passed(), true);
  Attempt stopped = tried;
  stopped.finishedAt.reset();
  EXPECT_EQ(attemptResultOf(stopped, &mixed, {}, {}).passed(), false);
  EXPECT_FALSE(attemptResultOf(tried, nullptr, {}, {}).isKnown);
}

TEST(AttemptResult, OfWhatWasHandedInWaits) {
  auto [lesson, tried] = triedAll({ReadingTask{}, AnswerTask{}});
  tried.outcomes[1].verdict = StepVerdict::handedIn;
  const AttemptResult result = attemptResultOf(tried, &lesson, {}, {});
  EXPECT_FALSE(result.score());
  EXPECT_FALSE(result.passed());
  EXPECT_EQ(verdictWord(result).english(), "handed in");
}

TEST(AttemptResult, SaysSoWhereALearningSystemAsksForMoreOrLessThanTheLesson) {
  auto [lesson, tried] = triedAll({AnswerTask{}, AnswerTask{}});
  tried.outcomes[0].score = 0.4;
  tried.outcomes[0].verdict = StepVerdict::failed;
  const auto said = [&, &lesson = lesson, &tried = tried](std::optional<double> level, std::optional<double> masteryScore) {
    AssessmentPlan plan;
    plan.passLevel = level;
    return systemVerdictRemark(attemptResultOf(tried, &lesson, plan, {}), masteryScore).english();
  };
  ASSERT_EQ(attemptResultOf(tried, &lesson, {}, {}).passed(), false);
  ASSERT_NEAR(*attemptResultOf(tried, &lesson, {}, {}).score(), 0.6, 1e-12);
  EXPECT_EQ(said(0.7, 0.5), "The learning system asks for 50 of 100 points: passed there. The lesson asks for 70: not passed.");
  EXPECT_EQ(said(0.5, 2.0 / 3.0), "The learning system asks for 66.7 of 100 points: not passed there. The lesson asks for 50: passed.");
  EXPECT_EQ(said({}, 0.5),
            "The learning system asks for 50 of 100 points: passed there. The lesson asks that it is finished and every step that counts "
            "is passed: not passed.");
  for (const auto& [level, masteryScore] : std::vector<std::pair<std::optional<double>, std::optional<double>>>{
           {0.7, 0.8}, {0.5, 0.6}, {0.6, 0.6}, {0.7, std::nullopt}, {std::nullopt, 0.9}})
    EXPECT_EQ(said(level, masteryScore), "") << "one verdict";
  tried.masteryScore = 0.5;
  EXPECT_EQ(attemptResultOf(tried, &lesson, {}, {}).masteryScore, 0.5);
  tried.outcomes[1].verdict = StepVerdict::handedIn;
  EXPECT_EQ(said(0.7, 0.5), "") << "nobody has judged it yet";
}

TEST(AttemptResult, IsPassedForALearningSystemByItsOwnLevel) {
  EXPECT_TRUE(passedForSystem(0.6, false, 0.5));
  EXPECT_FALSE(passedForSystem(0.6, true, 0.7));
  EXPECT_TRUE(passedForSystem((0.7 + 0.7 + 0.7) / 3.0, false, 0.7)) << "to the last digit of a mean";
  EXPECT_TRUE(passedForSystem(0.6, true, {})) << "it asks for none";
  EXPECT_FALSE(passedForSystem(0.6, false, {}));
  EXPECT_TRUE(passedForSystem({}, true, 0.7)) << "nothing to compare";
}

TEST(AttemptResult, IsOfThePlanThatCountsNow) {
  const auto [lesson, tried] = triedAll({AnswerTask{}, AnswerTask{}});
  AssessmentPlan plan;
  plan.revision = 2;
  plan.at("s1").passLevel = 0.9;
  AttemptScore kept;
  kept.planRevision = 1;
  kept.score = 0.3;
  EXPECT_FALSE(attemptResultOf(tried, &lesson, plan, kept).isScored) << "an earlier plan's";
  EXPECT_EQ(attemptResultOf(tried, &lesson, plan, kept).stepsPassed, 1u) << "0.9 are asked for";
  kept.planRevision = 2;
  kept.outcomes = 2;
  kept.wasFinished = true;
  EXPECT_EQ(attemptResultOf(tried, &lesson, plan, kept).score(), 0.3);
  kept.outcomes = 1;
  EXPECT_FALSE(attemptResultOf(tried, &lesson, plan, kept).isScored) << "the attempt has gone on since";
}

TEST(Verdicts, HaveOneWordEach) {
  std::set<std::string> words;
  for (const StepVerdict verdict : {StepVerdict::passed, StepVerdict::failed, StepVerdict::skipped, StepVerdict::handedIn})
    words.insert(verdictWord(verdict).english());
  EXPECT_EQ(words, (std::set<std::string>{"passed", "not passed", "skipped", "handed in"}));
}

TEST(AssessmentPlans, RefuseWhatCannotBe) {
  AssessmentPlan plan;
  plan.caseId = "ball";
  plan.lessonId = "about-balls";
  plan.at("plane").metrics = {{"path_length", 1.0, 100.0, 0.0}};
  const json good = jsonOf(plan);
  ASSERT_TRUE(planFromJson(good));
  for (const auto& [path, value] : std::vector<std::pair<std::string, json>>{{"/steps/0/metrics/0/metric", "beauty"},
                                                                             {"/steps/0/metrics/0/best", 100.0},
                                                                             {"/steps/0/pass_level", 1.2},
                                                                             {"/steps/0/weight", -1.0},
                                                                             {"/format", 7}}) {
    json bad = good;
    bad[json::json_pointer(path)] = value;
    const auto read = planFromJson(bad);
    ASSERT_FALSE(read) << path;
    EXPECT_FALSE(read.error().sentence().empty());
  }
  json twice = good;
  twice["steps"].push_back(twice["steps"][0]);
  EXPECT_FALSE(planFromJson(twice));
}

}  // namespace
}  // namespace ew
