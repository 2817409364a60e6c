#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "assessment/assessed_world.h"
#include "ew/assessment/attempt_result.h"
#include "ew/assessment/pseudonym.h"
#include "ew/cli/run_command.h"
#include "ew/library/step_answer.h"
#include "records/record_server.h"

// One attempt has one result: the same score, verdict, code and times wherever it is told.
namespace ew::test::one_result_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr auto kBegun = std::chrono::sys_days(std::chrono::year(2026) / 11 / 26) + std::chrono::hours(9) + std::chrono::minutes(30);

struct Expected {
  double score = 0.0;
  bool passed = false;
  int stepsPassed = 0, stepsJudged = 0;
};

class OneResult : public ::testing::Test {
 protected:
  OneResult() {
    Lesson lesson;
    lesson.id = "about-balls";
    lesson.title = "About balls";
    const AnswerTask question{{{"a", true, ""}, {"b", false, ""}}, {}, 0.0, ""};
    for (const auto& [id, task] : {std::pair<const char*, LessonTask>{"read", ReadingTask{}},
                                   {"first", question},
                                   {"measure", MeasureTask{"ball, across", {}}},
                                   {"second", question}}) {
      LessonStep step;
      step.id = id;
      step.title = std::string("Step ") + id;
      step.text = "Do it.";
      step.task = task;
      lesson.steps.push_back(std::move(step));
    }
    world_.teach(std::move(lesson));
    writeText(outputs_ / "password", "secret-word\n");
    std::string words;
    said({"records", "settings", "--endpoint", "https://records.example/xapi/", "--user", "mona", "--secret-from",
          (outputs_ / "password").string(), "--settings", (outputs_ / "settings").string(), "--no-keyring"},
         &words);
    server_.authorization = "Basic dG9rZW4tMTc=";
    server_.other = [](const ServerQuestion& asked) -> std::optional<ServerAnswer> {
      if (asked.target == "/fetch") return ServerAnswer{200, R"({"auth-token": "dG9rZW4tMTc="})", {}};
      if (asked.target.starts_with("/xapi/activities/state"))
        return ServerAnswer{
            200,
            R"({"contextTemplate": {"extensions": {"urn:s": "42"}}, "launchMode": "Normal", "launchParameters": "ball/about-balls"})",
            {}};
      if (asked.target.starts_with("/xapi/agents/profile")) return ServerAnswer{404, "", {}};
      return std::nullopt;
    };
  }

  /// Read, one right answer, a measurement half way to its tolerance (0.85), and a wrong answer after a try that was wrong, too.
  [[nodiscard]] fs::path attempt() const {
    Attempt made;
    made.id = "20261126-093000-aaaaaaaa";
    made.caseId = "ball";
    made.lessonId = "about-balls";
    made.lessonTitle = "About balls";
    made.lessonContent = contentOf(world_.lesson());
    made.person = "Anna";
    made.startedAt = kBegun;
    auto kept = AttemptFolder::begin(attemptsFolder(world_.library()), made);
    EXPECT_TRUE(kept) << kept.error();
    const auto end = [&](const char* step, double score, StepAnswer answer, int at_s) {
      StepOutcome outcome;
      outcome.stepId = step;
      outcome.score = score;
      outcome.verdict = score >= 0.7 ? StepVerdict::passed : StepVerdict::failed;
      outcome.answer = std::move(answer);
      outcome.seconds = 20.0;
      outcome.at = kBegun + std::chrono::seconds(at_s);
      EXPECT_TRUE(kept->endStep(outcome));
    };
    end("read", 1.0, {}, 20);
    end("first", 1.0, OptionsAnswer{{0}}, 40);
    end("measure", 0.85, MeasurementAnswer{41.0, "mm", "distance", {}}, 60);
    end("second", 0.0, OptionsAnswer{{1}}, 80);
    end("second", 0.0, OptionsAnswer{{1}}, 100);
    EXPECT_TRUE(kept->finish(kBegun + std::chrono::seconds(100)));
    return kept->folder();
  }

  json said(const std::vector<std::string>& args, std::string* words = nullptr) {
    std::ostringstream out, err;
    EXPECT_EQ(cli::runCommand(args, {out, err}), 0) << args[0] << ": " << err.str();
    if (words != nullptr) *words = out.str();
    return json::parse(out.str(), nullptr, false);
  }

  void expectOfStatement(const json& statement, const Expected& expected) {
    EXPECT_NEAR(statement["result"]["score"]["scaled"].get<double>(), expected.score, 1e-12);
    EXPECT_EQ(statement["result"]["success"], expected.passed);
    EXPECT_EQ(statement["result"]["duration"], "PT1M40S");
    EXPECT_EQ(statement["verb"]["display"]["en"], expected.passed ? "passed" : "failed");
  }
  void expectOfRecords(const fs::path& folder, const Expected& expected) {
    const json all = said({"records", "add", folder.string(), "--dry-run", "--settings", (outputs_ / "settings").string(), "--no-keyring"});
    ASSERT_TRUE(all.is_array());
    expectOfStatement(all.back(), expected);
    EXPECT_EQ(all.back()["actor"]["account"]["name"], code());
    EXPECT_EQ(all.back()["timestamp"], "2026-11-26T09:31:40.000Z");
    EXPECT_EQ(all.front()["timestamp"], "2026-11-26T09:30:00.000Z");
  }
  [[nodiscard]] static AssessmentPlan planFrom(double passLevel) {
    AssessmentPlan plan;
    plan.caseId = "ball";
    plan.lessonId = "about-balls";
    plan.passLevel = passLevel;
    return plan;
  }
  [[nodiscard]] std::string address() {
    return "echoweave-cmi5:?endpoint=" + server_.endpoint() + "&fetch=http://127.0.0.1:" + std::to_string(server_.port()) +
           "/fetch&actor=%7B%22account%22%3A%7B%22homePage%22%3A%22https%3A%2F%2Flms.example%2F%22%2C%22name%22%3A%22Anna%22%7D%7D"
           "&registration=886313e1-3b8a-5372-9b90-0c9aee199e5d&activityId=https://lms.example/au/1";
  }
  void expectOfLearningSystem(const fs::path& folder, const Expected& expected) {
    std::string words;
    said({"records", "launch", address(), folder.string(), "--rounds", "1"}, &words);
    const auto order = server_.order();
    ASSERT_GE(order.size(), 4u) << words;
    expectOfStatement(server_.stored(order[order.size() - 2]), expected);
  }
  void expectOfReports(const fs::path& folder, const Expected& expected) {
    const std::string percent = std::to_string(std::lround(100.0 * expected.score)) + " %";
    const std::string verdict = expected.passed ? "passed" : "not passed";
    const std::string steps = std::to_string(expected.stepsPassed) + " of " + std::to_string(expected.stepsJudged);
    std::string words;
    said({"assess", folder.string(), "--html", (outputs_ / "pages").string(), "--csv", (outputs_ / "t.csv").string(), "--dicom",
          (outputs_ / "dicom").string()},
         &words);
    EXPECT_NE(words.find(code() + "  " + percent + ", " + steps + " steps, " + verdict + ", 1 min 40 s"), std::string::npos) << words;
    const std::string page = textOf(outputs_ / "pages" / ("attempt-" + folder.filename().string() + ".html"));
    for (const std::string& part : {code(), percent, ">" + verdict + "<", steps, std::string("1 min 40 s"), std::string("09:31 UTC")})
      EXPECT_NE(page.find(part), std::string::npos) << part;
    std::istringstream table(textOf(outputs_ / "t.csv"));
    std::string heads, line;
    std::getline(table, heads);
    while (std::getline(table, line)) {
      EXPECT_NE(line.find(code()), std::string::npos) << line;
      EXPECT_NE(line.find(std::string(expected.passed ? ",yes," : ",no,") + verdict + "," + std::to_string(expected.stepsPassed) + "," +
                          std::to_string(expected.stepsJudged) + ",100,"),
                std::string::npos)
          << line;
      EXPECT_NE(line.find("2026-11-26T09:31:40Z"), std::string::npos) << line;
    }
    const std::string dicom = textOf(outputs_ / "dicom" / (folder.filename().string() + "-ball.dcm"));
    EXPECT_NE(dicom.find("Result: " + percent + ", " + verdict + ", " + steps + " steps passed"), std::string::npos);
    EXPECT_NE(dicom.find("Time on steps: 1 min 40 s"), std::string::npos);
    EXPECT_NE(dicom.find(code()), std::string::npos);
    for (const char* each : {"pages", "dicom"}) fs::remove_all(outputs_ / each);
  }
  /// The lessons panel and the start page ask for the first, Review for the second.
  void expectOfWindow(const fs::path& folder, const Expected& expected) {
    const auto standing =
        LearningProgress(listAttempts(folder.parent_path()), "Anna", attemptJudgeOf(world_.library())).of("ball", world_.lesson());
    EXPECT_EQ(standing.bestPassed, static_cast<std::size_t>(expected.stepsPassed));
    EXPECT_EQ(standing.judged, static_cast<std::size_t>(expected.stepsJudged));
    EXPECT_EQ(standing.isPassed(4), expected.passed);
    const AttemptResult result = AttemptResults(world_.library()).of(folder, AttemptFolder::open(folder)->attempt());
    EXPECT_NEAR(*result.score(), expected.score, 1e-12);
    EXPECT_EQ(result.passed(), expected.passed);
    EXPECT_EQ(result.worked_s, 100.0);
  }
  [[nodiscard]] std::string code() const { return Pseudonyms::ofLibrary(world_.library())->ofPerson("Anna"); }

  AssessedWorld world_;
  const TemporaryFolder outputs_;
  RecordServer server_;
};

TEST_F(OneResult, IsTheSameOnEverySurfaceWithoutAPlan) {
  const fs::path folder = attempt();
  const Expected byDefault{(1.0 + 0.85 + 0.0) / 3.0, false, 2, 3};
  expectOfWindow(folder, byDefault);  // nobody has scored it yet
  expectOfRecords(folder, byDefault);
  expectOfLearningSystem(folder, byDefault);
  expectOfReports(folder, byDefault);  // scores it
  expectOfWindow(folder, byDefault);
  expectOfRecords(folder, byDefault);
  expectOfLearningSystem(folder, byDefault);
}

TEST_F(OneResult, IsThatOfThePlanOnEverySurface) {
  const fs::path folder = attempt();
  AssessmentPlan plan = planFrom(0.6);
  plan.at("second").weight = 0.5;
  plan.at("measure").metrics = {{"measurement_error", 1.0, 10.0, 0.0}};  // 2.5 % are worth 0.75
  ASSERT_TRUE(keepPlan(world_.library(), plan));
  const Expected byPlan{(1.0 + 0.5 * (0.85 + 0.75) + 0.0) / 2.5, true, 2, 3};
  expectOfRecords(folder, byPlan);  // nobody has scored it yet: it is scored for this
  EXPECT_FALSE(latestScore(folder)) << "showing keeps nothing";
  expectOfLearningSystem(folder, byPlan);
  expectOfWindow(folder, byPlan);
  expectOfReports(folder, byPlan);
  // A plan that comes later counts at once, also for what was scored before.
  plan.passLevel = 0.8;
  ASSERT_TRUE(keepPlan(world_.library(), plan));
  const Expected stricter{byPlan.score, false, 2, 3};
  expectOfRecords(folder, stricter);
  expectOfLearningSystem(folder, stricter);
  expectOfReports(folder, stricter);
  expectOfWindow(folder, stricter);
}

TEST_F(OneResult, OfALessonThatIsNotInTheLibraryIsNeitherPassedNorFailed) {
  const fs::path folder = attempt();
  AssessmentPlan plan = planFrom(0.1);
  ASSERT_TRUE(keepPlan(world_.library(), plan)) << "it would make a pass of anything";
  fs::rename(world_.caseFolder(), outputs_ / "aside");
  const AttemptResult unknown = AttemptResults(world_.library()).of(folder, AttemptFolder::open(folder)->attempt());
  EXPECT_FALSE(unknown.isKnown);
  EXPECT_FALSE(unknown.score());
  EXPECT_FALSE(unknown.passed());
  EXPECT_EQ(verdictWord(unknown).english(), "not scored yet");
  const json all = said({"records", "add", folder.string(), "--dry-run", "--settings", (outputs_ / "settings").string(), "--no-keyring"});
  EXPECT_EQ(all.back()["verb"]["display"]["en"], "completed");
  std::string words;
  said({"records", "launch", address(), folder.string(), "--rounds", "1"}, &words);
  const auto order = server_.order();
  ASSERT_EQ(order.size(), 3u) << words;
  EXPECT_EQ(server_.stored(order[1])["verb"]["display"]["en"], "completed");
  // With the case it is judged.
  fs::rename(outputs_ / "aside", world_.caseFolder());
  EXPECT_EQ(AttemptResults(world_.library()).of(folder, AttemptFolder::open(folder)->attempt()).passed(), true);
}
TEST_F(OneResult, IsThatOfThePlanAlsoWhereItsScoreCannotBeKept) {
  const fs::path folder = attempt();
  AssessmentPlan plan = planFrom(0.6);
  plan.at("second").weight = 0.5;
  ASSERT_TRUE(keepPlan(world_.library(), plan));
  writeText(folder / "scores", "a file where the folder would be");
  expectOfLearningSystem(folder, {(1.0 + 0.85 + 0.0) / 2.5, true, 2, 3});
  EXPECT_EQ(textOf(folder / "scores"), "a file where the folder would be");
}
TEST_F(OneResult, OfAPlanThatCannotBeReadIsNotTold) {
  const fs::path folder = attempt();
  AssessmentPlan plan = planFrom(0.9);
  ASSERT_TRUE(keepPlan(world_.library(), plan));
  const fs::path file = planFolder(world_.library(), "ball", "about-balls") / "0001.json";
  ASSERT_TRUE(fs::exists(file));
  writeText(file, "{ damaged");
  std::ostringstream out, err;
  const std::vector<std::string> shown = {
      "records", "add", folder.string(), "--dry-run", "--settings", (outputs_ / "settings").string(), "--no-keyring"};
  EXPECT_EQ(cli::runCommand(shown, {out, err}), 1);
  EXPECT_EQ(out.str(), "[]\n");
  EXPECT_NE(err.str().find("0001.json"), std::string::npos) << err.str();
}
TEST_F(OneResult, OfAnAttemptThatWentOnAfterItWasScoredIsOfItsEnd) {
  const fs::path folder = attempt();
  std::string words;
  said({"assess", folder.string()}, &words);
  auto kept = AttemptFolder::open(folder);
  StepOutcome better = *kept->attempt().outcomeOf("second");
  better.score = 1.0;
  better.verdict = StepVerdict::passed;
  better.answer = OptionsAnswer{{0}};
  better.seconds = 0.0;
  ASSERT_TRUE(kept->endStep(better));
  const Expected now{(1.0 + 0.85 + 1.0) / 3.0, true, 3, 3};
  expectOfWindow(folder, now);
  expectOfRecords(folder, now);
  expectOfLearningSystem(folder, now);
  expectOfReports(folder, now);
}

}  // namespace
}  // namespace ew::test::one_result_test
