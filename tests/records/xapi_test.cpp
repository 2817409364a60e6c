#include "ew/records/xapi.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <set>

#include "library/temporary_folder.h"
#include "places.h"
#include "records/record_world.h"

namespace ew::test::xapi_test {
namespace {

using nlohmann::json;

std::vector<json> statements(const Attempt& attempt, const XapiOptions& options) {
  auto made = statementsOf(attempt, options);
  EXPECT_TRUE(made) << made.error();
  return made ? *made : std::vector<json>{};
}

XapiOptions withLesson() {
  XapiOptions options = someOptions();
  options.lesson = someLesson();
  return options;
}

std::vector<std::string> verbsOf(const std::vector<json>& all) {
  std::vector<std::string> verbs;
  for (const json& each : all) {
    const std::string id = each["verb"]["id"];
    verbs.push_back(id.substr(id.rfind('/') + 1));
  }
  return verbs;
}

TEST(NameUuid, IsThatOfRfc4122) {
  EXPECT_EQ(uuidOfName("6ba7b810-9dad-11d1-80b4-00c04fd430c8", "www.example.com"), "2ed6657d-e927-568b-95e1-2665a8aea6a2");
  EXPECT_EQ(uuidOfName("6BA7B810-9DAD-11D1-80B4-00C04FD430C8", "python.org"), "886313e1-3b8a-5372-9b90-0c9aee199e5d");
  EXPECT_TRUE(isUuid("886313e1-3b8a-5372-9B90-0c9aee199e5d"));
  for (const char* text :
       {"", "886313e1-3b8a-5372-9b90-0c9aee199e5", "886313e1-3b8a-5372-9b90-0c9aee199e5g", "886313e13b8a-5372-9b90-0c9aee199e5dd-"})
    EXPECT_FALSE(isUuid(text)) << text;
}

TEST(DurationText, IsIso8601ToTheHundredth) {
  const std::vector<std::pair<double, std::string>> cases = {{0, "PT0S"},      {83.42, "PT1M23.42S"}, {0.05, "PT0.05S"},
                                                             {60, "PT1M"},     {3600, "PT1H"},        {3661, "PT1H1M1S"},
                                                             {59.999, "PT1M"}, {1e6, "PT277H46M40S"}, {-1, "PT0S"}};
  for (const auto& [seconds, text] : cases) EXPECT_EQ(isoDuration(seconds), text);
}

TEST(TimestampText, RoundTripsAndReadsOffsets) {
  const auto moment = momentOfTimestamp("2026-11-26T09:30:00.250Z");
  ASSERT_TRUE(moment);
  EXPECT_EQ(timestampText(*moment), "2026-11-26T09:30:00.250Z");
  EXPECT_EQ(momentOfTimestamp("2026-11-26T11:30:00.250+02:00"), moment);
  EXPECT_EQ(momentOfTimestamp("2026-11-26T04:00:00.250-0530"), moment);
  EXPECT_EQ(momentOfTimestamp("2026-11-26T09:30:00.250123Z"), moment);
  for (const char* text : {"", "yesterday", "2026-13-26T09:30:00Z", "2026-11-26T09:30:00", "2026-11-26T09:30:00+"})
    EXPECT_FALSE(momentOfTimestamp(text)) << text;
}

TEST(XapiStatements, TellAnAttemptInTheOrderInWhichItHappened) {
  const auto all = statements(someAttempt(), withLesson());
  EXPECT_EQ(verbsOf(all),
            (std::vector<std::string>{"attempted", "completed", "failed", "passed", "answered", "skipped", "completed", "failed"}));
  EXPECT_EQ(all[0]["timestamp"], "2026-11-26T09:30:00.000Z");
  EXPECT_EQ(all[2]["timestamp"], "2026-11-26T09:31:50.000Z");
  EXPECT_EQ(all[7]["timestamp"], "2026-11-26T09:34:00.000Z");
  for (std::size_t n = 1; n < all.size(); ++n) EXPECT_LE(all[n - 1]["timestamp"], all[n]["timestamp"]);
}

TEST(XapiStatements, SayOfAnOutcomeWhatItIs) {
  const auto all = statements(someAttempt(), withLesson());
  const json& failed = all[2];
  EXPECT_EQ(failed["object"]["id"], "urn:echoweave:step/upper-abdomen-normal/first-movements/plane");
  EXPECT_EQ(failed["object"]["definition"]["name"]["en"], "Find the portal vein");
  EXPECT_EQ(failed["object"]["definition"]["type"], "http://adlnet.gov/expapi/activities/performance");
  EXPECT_EQ(failed["result"]["score"], json({{"scaled", 0.25}, {"raw", 25.0}, {"min", 0}, {"max", 100}}));
  EXPECT_EQ(failed["result"]["success"], false);
  EXPECT_EQ(failed["result"]["completion"], true);
  EXPECT_EQ(failed["result"]["duration"], "PT1M23.42S");
  EXPECT_EQ(failed["result"]["extensions"]["urn:echoweave:extension/hints"], 2);
  EXPECT_EQ(failed["result"]["extensions"]["urn:echoweave:extension/figures"][0],
            json({{"name", "angle"}, {"value", 14.5}, {"unit", "deg"}}));
  EXPECT_EQ(failed["context"]["contextActivities"]["parent"][0]["id"], "urn:echoweave:lesson/upper-abdomen-normal/first-movements");
  EXPECT_EQ(failed["context"]["platform"], "EchoWeave");
  EXPECT_EQ(failed["context"]["revision"], "4711abcd");
  EXPECT_EQ(all[4]["result"]["response"], "[1,2]");
  EXPECT_EQ(all[4]["object"]["definition"]["type"], "http://adlnet.gov/expapi/activities/question");
  EXPECT_FALSE(all[5]["result"].contains("score"));
  EXPECT_EQ(all[5]["result"]["completion"], false);
  for (const json& each : all) EXPECT_EQ(each.dump().find("a remark"), std::string::npos);
}

TEST(XapiStatements, JudgeTheAttemptByTheLatestOutcomeOfEachStepOfTheLesson) {
  const auto all = statements(someAttempt(), withLesson());
  const json& last = all.back();
  EXPECT_DOUBLE_EQ(last["result"]["score"]["scaled"], (0.75 + 0.0 + 0.0) / 3.0) << "what is only read does not count";
  EXPECT_EQ(last["result"]["success"], false);
  EXPECT_EQ(last["result"]["duration"], "PT2M55.92S") << "of all outcomes, also of those that were repeated";
  EXPECT_EQ(last["object"]["id"], "urn:echoweave:lesson/upper-abdomen-normal/first-movements");

  Attempt good = someAttempt();
  good.outcomes.erase(good.outcomes.begin() + 3, good.outcomes.end());
  XapiOptions known = withLesson();
  known.lesson->steps.resize(2);
  EXPECT_EQ(verbsOf(statements(good, known)).back(), "passed");
  EXPECT_EQ(verbsOf(statements(good, someOptions())).back(), "completed") << "nobody knows which steps count";
  EXPECT_EQ(verbsOf(statements(good, withLesson())).back(), "failed") << "two steps of the lesson were never tried";
}

TEST(XapiStatements, OfAnAttemptThatWasStoppedSayNothingOfItsEnd) {
  Attempt attempt = someAttempt();
  attempt.finishedAt.reset();
  EXPECT_EQ(statements(attempt, someOptions()).size(), 6u);
  attempt.outcomes.clear();
  EXPECT_EQ(verbsOf(statements(attempt, someOptions())), std::vector<std::string>{"attempted"});
}

TEST(XapiStatements, OfAnExaminationSayFirstThatItWasHandedInAndLaterHowItWasJudged) {
  Attempt examination = someAttempt();
  for (StepOutcome& outcome : examination.outcomes) outcome.verdict = StepVerdict::handedIn;
  const auto handedIn = statements(examination, withLesson());
  EXPECT_EQ(verbsOf(handedIn),
            (std::vector<std::string>{"attempted", "completed", "completed", "completed", "answered", "completed", "completed"}));
  for (const json& each : handedIn) {
    EXPECT_FALSE(each.contains("/result/score"_json_pointer)) << each;
    EXPECT_FALSE(each.contains("/result/success"_json_pointer)) << each;
  }
  std::set<std::string> told;
  for (const json& each : handedIn) told.insert(each["id"]);
  std::size_t isNew = 0;
  for (const json& each : statements(someAttempt(), withLesson())) isNew += told.contains(each["id"]) ? 0 : 1;
  EXPECT_EQ(isNew, 6u) << "five judgements of outcomes and that of the attempt";
}

TEST(XapiStatements, HaveIdsThatAreTheSameWhereverAndHoweverTheyAreTold) {
  const auto one = statements(someAttempt(), withLesson());
  XapiOptions other = someOptions();
  other.names = true;
  other.homePage = "https://other.example/";
  other.language = "de";
  const auto two = statements(someAttempt(), other);
  ASSERT_EQ(one.size(), two.size() + 1) << "without the lesson nobody judges the attempt";
  for (std::size_t n = 0; n < two.size(); ++n) {
    EXPECT_EQ(one[n]["id"], two[n]["id"]);
    EXPECT_EQ(one[n]["context"]["registration"], two[n]["context"]["registration"]);
  }
  std::set<std::string> ids;
  for (const json& each : one) ids.insert(each["id"]);
  EXPECT_EQ(ids.size(), one.size());
  // Written down: whoever changes how ids are made sends everything a second time.
  EXPECT_EQ(one[0]["id"], uuidOfName("6a1b0c52-4f5b-5d0e-9f0e-3a7c5f8e2d41",
                                     "20261126-093000-4f2a91c7\nupper-abdomen-normal\nfirst-movements\nattempted"));
  Attempt later = someAttempt();
  later.id = "20261126-093000-4f2a91c8";
  EXPECT_NE(statements(later, withLesson())[0]["id"], one[0]["id"]);
  Attempt longer = someAttempt();
  longer.finishedAt.reset();
  longer.outcomes.resize(3);
  const auto begun = statements(longer, withLesson());
  for (std::size_t n = 0; n < begun.size(); ++n) EXPECT_EQ(begun[n]["id"], one[n]["id"]) << "an attempt that goes on keeps its first words";
}

TEST(XapiStatements, HoldNoNameUnlessItIsAskedFor) {
  const auto plain = statements(someAttempt(), withLesson());
  for (const json& each : plain) {
    EXPECT_EQ(each.dump().find("Lovelace"), std::string::npos);
    EXPECT_EQ(each["actor"]["account"]["name"], "T-9DC4-XB0M");
    EXPECT_EQ(each["actor"]["account"]["homePage"], "https://school.example/");
  }
  XapiOptions named = withLesson();
  named.names = true;
  EXPECT_EQ(statements(someAttempt(), named)[0]["actor"]["name"], "Ada Lovelace");
}

TEST(XapiStatements, CarryMetricsWithTheirVersion) {
  XapiOptions options = withLesson();
  options.metrics = {{"path-length", 2, 812.5, "mm", "plane"}, {"idle-share", 1, 0.25, "", ""}};
  options.courseId = "basics";
  options.caseTitle = "A normal upper abdomen";
  const auto all = statements(someAttempt(), options);
  EXPECT_EQ(all[2]["result"]["extensions"]["urn:echoweave:extension/metrics"][0],
            json({{"id", "path-length"}, {"version", 2}, {"value", 812.5}, {"unit", "mm"}}));
  EXPECT_EQ(all[7]["result"]["extensions"]["urn:echoweave:extension/metrics"][0],
            json({{"id", "idle-share"}, {"version", 1}, {"value", 0.25}}));
  EXPECT_FALSE(all[1]["result"]["extensions"].contains("urn:echoweave:extension/metrics"));
  EXPECT_EQ(all[1]["context"]["contextActivities"]["grouping"][1]["id"], "urn:echoweave:course/basics");
  EXPECT_EQ(all[1]["context"]["contextActivities"]["grouping"][0]["definition"]["name"]["en"], "A normal upper abdomen");
}

TEST(XapiStatements, RefuseWhatCannotBeSaid) {
  const auto refuses = [](const Attempt& attempt, const XapiOptions& options, const char* word) {
    const auto made = statementsOf(attempt, options);
    ASSERT_FALSE(made) << word;
    EXPECT_EQ(made.error().code, ErrorCode::badField);
    EXPECT_NE(made.error().sentence().find(word), std::string::npos) << made.error();
  };
  XapiOptions options = someOptions();
  options.homePage = "school";
  refuses(someAttempt(), options, "home_page");
  options = someOptions();
  options.pseudonym.clear();
  refuses(someAttempt(), options, "pseudonym");
  options = someOptions();
  options.activityBase = "no base";
  refuses(someAttempt(), options, "activity_base");
  options = someOptions();
  options.registration = "r";
  refuses(someAttempt(), options, "registration");
  options = someOptions();
  options.language = "e n";
  refuses(someAttempt(), options, "language");
  options = someOptions();
  options.metrics = {{"path-length", 1, std::numeric_limits<double>::quiet_NaN(), "mm", ""}};
  refuses(someAttempt(), options, "path-length");
  Attempt odd = someAttempt();
  odd.lessonTitle = "\xff";
  refuses(odd, someOptions(), "UTF-8");
}

TEST(XapiStatements, EncodeIdsSoThatTheyStayAddresses) {
  Attempt attempt = someAttempt();
  attempt.outcomes.resize(1);
  attempt.outcomes[0].stepId = "Größe & \"so\"/weiter";
  const auto all = statements(attempt, someOptions());
  EXPECT_EQ(all[1]["object"]["id"], "urn:echoweave:step/upper-abdomen-normal/first-movements/Gr%C3%B6%C3%9Fe%20%26%20%22so%22%2Fweiter");
}

TEST(SaysTheSame, LeavesOutWhatServersAddAndSeesWhatTheyDoNot) {
  const json ours = statements(someAttempt(), withLesson())[2];
  json theirs = ours;
  theirs["stored"] = "2026-11-27T00:00:00Z";
  theirs["authority"] = {{"mbox", "mailto:a@b.c"}};
  theirs["timestamp"] = "2026-11-26T10:31:50+01:00";
  theirs["result"]["score"]["raw"] = 25;
  theirs["verb"].erase("display");
  EXPECT_TRUE(saysTheSame(ours, theirs));
  const auto differs = [&](const json::json_pointer& at, const json& value) {
    json changed = theirs;
    changed[at] = value;
    EXPECT_FALSE(saysTheSame(ours, changed)) << at;
  };
  differs("/actor/account/name"_json_pointer, "somebody");
  differs("/verb/id"_json_pointer, "http://adlnet.gov/expapi/verbs/passed");
  differs("/object/id"_json_pointer, "urn:x:y");
  differs("/result/success"_json_pointer, true);
  differs("/result/score/scaled"_json_pointer, 0.26);
  differs("/context/registration"_json_pointer, "886313e1-3b8a-5372-9b90-0c9aee199e5d");
  differs("/timestamp"_json_pointer, "2026-11-26T09:31:51Z");
  EXPECT_FALSE(saysTheSame(ours, json()));
}

json everyKindOfStatement() {
  XapiOptions options = withLesson();
  options.metrics = {{"path-length", 2, 812.5, "mm", "plane"}, {"idle-share", 1, 0.25, "", ""}};
  options.courseId = "basics";
  options.names = true;
  json all = json::array();
  for (const json& each : statements(someAttempt(), options)) all.push_back(each);
  Attempt stopped = someAttempt();
  stopped.id += "b";
  stopped.person.clear();
  stopped.lessonTitle = "Über Größe";
  stopped.finishedAt.reset();
  XapiOptions bare = someOptions();
  bare.language = "de-AT";
  bare.activityBase = "https://school.example/echoweave/";
  for (const json& each : statements(stopped, bare)) all.push_back(each);
  return all;
}

TEST(XapiStatements, HaveThePublishedStructure) {
  const TemporaryFolder folder;
  writeText(folder / "s.json", everyKindOfStatement().dump());
  const std::string command = std::string("/usr/bin/python3 '") + std::string(EW_SOURCE_DIR) + "/tests/records/xapi_schema/validate.py' '" +
                              (folder / "s.json").string() + "' --required > '" + (folder / "said").string() + "' 2>&1";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127) GTEST_SKIP() << "python3-jsonschema is not installed";
  EXPECT_EQ(WEXITSTATUS(status), 0) << textOf(folder / "said");
}

TEST(XapiStatements, AreAcceptedByTheValidatorOfARecordStore) {
  const TemporaryFolder folder;
  writeText(folder / "s.json", everyKindOfStatement().dump());
  writeText(
      folder / "judge.js",
      "const judge = require('@learninglocker/xapi-validation').default;\n"
      "const all = JSON.parse(require('fs').readFileSync(process.argv[2]));\n"
      "let problems = 0;\n"
      "for (const one of all) for (const each of judge(one, [one.id])) { ++problems; console.log(String(each), JSON.stringify(each)); }\n"
      "const broken = JSON.parse(JSON.stringify(all[0])); delete broken.actor; broken.timestamp = 'yesterday';\n"
      "if (judge(broken, ['x']).length < 2) { ++problems; console.log('it notices nothing'); }\n"
      "console.log(all.length + ' statements, ' + problems + ' problems');\n"
      "process.exit(problems ? 1 : 0);\n");
  const std::string within = "cd '" + folder.path().string() + "' && ";
  const std::string fetch =
      "npm install --no-audit --no-fund --ignore-scripts --fetch-retries 0 --fetch-timeout 20000 @learninglocker/xapi-validation@3.0.0";
  if (std::system((within + fetch + " > fetched 2>&1").c_str()) != 0)
    GTEST_SKIP() << "the validator @learninglocker/xapi-validation cannot be fetched here";
  const int status = std::system((within + "node judge.js s.json > said 2>&1").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 0) << textOf(folder / "said");
}

}  // namespace
}  // namespace ew::test::xapi_test
