#include <gtest/gtest.h>
#include <sys/stat.h>

#include "cli/cli_world.h"
#include "ew/library/attempt.h"
#include "ew/library/case.h"
#include "ew/library/lesson.h"
#include "ew/library/lesson_links.h"
#include "library/small_case.h"
#include "places.h"
#include "records/record_server.h"
#include "records/record_world.h"

namespace ew::test::records_command_test {
namespace {

class RecordsCommand : public ::testing::Test {
 protected:
  RecordsCommand() {
    auto kept = AttemptFolder::begin(folder_.path() / "library/attempts", someAttempt());
    EXPECT_TRUE(kept) << kept.error();
  }
  Outcome records(std::vector<std::string> words) {
    words.insert(words.begin(), "records");
    const std::string command = words[1];
    words.insert(words.end(), {"--report", folder_ / "report.json"});
    if (command != "settings") words.insert(words.end(), {"--library", folder_ / "library"});
    if (command != "list") words.insert(words.end(), {"--settings", folder_ / "settings", "--no-keyring"});
    return run(words);
  }
  void setUp(const std::string& endpoint) {
    writeText(folder_ / "password", "secret-word\n");
    const auto set = records({"settings", "--endpoint", endpoint, "--user", "mona", "--secret-from", folder_ / "password"});
    ASSERT_EQ(set.status, 0) << set.err;
  }
  EnvironmentValue resources_{"ECHOWEAVE_RESOURCES", std::string(EW_SOURCE_DIR) + "/resources"};
  EnvironmentValue cases_{"ECHOWEAVE_CASES", std::string(EW_SOURCE_DIR) + "/cases"};
  const TemporaryFolder folder_;
  EnvironmentValue library_{"ECHOWEAVE_LIBRARY", folder_ / "library"};
  RecordServer server_;
};

TEST_F(RecordsCommand, BringsAnAttemptToARecordStoreOnce) {
  server_.authorization = "Basic bW9uYTpzZWNyZXQtd29yZA==";
  setUp(server_.endpoint());
  const auto added = records({"add"});
  ASSERT_EQ(added.status, 0) << added.err;
  EXPECT_NE(added.out.find("Took 8 statements of 1 attempt"), std::string::npos) << added.out;
  EXPECT_NE(records({"add"}).out.find("Took 0 statements of 1 attempt; 8 were in the outbox"), std::string::npos);
  EXPECT_NE(records({"list"}).out.find("8 statements to send, 0 refused, 0 sent"), std::string::npos);
  const auto sent = records({"send"});
  ASSERT_EQ(sent.status, 0) << sent.err;
  EXPECT_NE(sent.out.find("8 statements more"), std::string::npos) << sent.out;
  EXPECT_EQ(readJson(folder_ / "report.json")["quality"]["sent"], 8);
  EXPECT_EQ(server_.arrivals().size(), 8u);
  EXPECT_NE(records({"add"}).out.find("Took 0 statements"), std::string::npos);
  EXPECT_EQ(records({"send"}).status, 0);
  for (const auto& [id, count] : server_.arrivals()) EXPECT_EQ(count, 1) << id;
}

TEST_F(RecordsCommand, SaysNamesOnlyWhenAsked) {
  setUp(server_.endpoint());
  const auto plain = records({"add", "--dry-run"});
  ASSERT_EQ(plain.status, 0) << plain.err;
  EXPECT_EQ(plain.out.find("Lovelace"), std::string::npos);
  EXPECT_NE(plain.out.find("\"T-"), std::string::npos) << "the library's code stands for the person";
  EXPECT_NE(records({"add", "--dry-run", "--names"}).out.find("\"name\": \"Ada Lovelace\""), std::string::npos);
  EXPECT_NE(records({"list"}).out.find("0 statements to send"), std::string::npos) << "a dry run takes nothing";
}

TEST_F(RecordsCommand, KeepsThePasswordOutOfSettingsReportsAndWords) {
  setUp(server_.endpoint());
  const auto shown = records({"settings"});
  EXPECT_NE(shown.out.find("secret:            kept"), std::string::npos) << shown.out;
  for (const std::string& text :
       {shown.out, shown.err, readText(folder_ / "settings/record-store.json"), readText(folder_ / "report.json")})
    EXPECT_EQ(text.find("secret-word"), std::string::npos) << text;
  struct stat found {};
  ASSERT_EQ(::stat((folder_ / "settings/secrets/record-store").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777, 0600u);
  EXPECT_EQ(records({"settings", "--forget-secret"}).status, 0);
  const auto without = records({"send"});
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.err.find("no secret"), std::string::npos) << without.err;
}

TEST_F(RecordsCommand, AsksTheRecordStoreAndSaysWhatItAnswers) {
  server_.authorization = "Basic bW9uYTpzZWNyZXQtd29yZA==";
  setUp(server_.endpoint());
  EXPECT_EQ(records({"settings", "--ask"}).status, 0);
  const auto wrong = records({"settings", "--user", "lisa", "--ask"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("does not accept user and password (401)"), std::string::npos) << wrong.err;
}

TEST_F(RecordsCommand, SaysWhatIsMissingAndWhatToDo) {
  const auto unset = records({"add"});
  EXPECT_EQ(unset.status, 1);
  EXPECT_NE(unset.err.find("records settings --endpoint"), std::string::npos) << unset.err;
  EXPECT_NE(records({"settings", "--endpoint", "http://records.example/"}).err.find("use https"), std::string::npos);
  setUp(server_.endpoint());
  EXPECT_NE(records({"add", folder_ / "nowhere"}).err.find("There is no attempt"), std::string::npos);
  EXPECT_EQ(run({"records"}).status, 2);
}

TEST_F(RecordsCommand, WhatIsRefusedIsSaidAndTriedAgainOnlyWhenAsked) {
  setUp(server_.endpoint());
  ASSERT_EQ(records({"add"}).status, 0);
  const auto all = statementsOf(someAttempt(), [] {
    XapiOptions options = someOptions();
    return options;
  }());
  server_.bad = {(*all)[1]["id"].get<std::string>()};
  const auto sent = records({"send"});
  EXPECT_EQ(sent.status, 1);
  EXPECT_NE(sent.err.find("is not known here"), std::string::npos) << sent.err;
  EXPECT_NE(sent.err.find("--retry"), std::string::npos) << sent.err;
  EXPECT_NE(records({"list"}).out.find("1 refused, 7 sent"), std::string::npos);
  server_.bad = std::set<std::string>();
  EXPECT_EQ(records({"send", "--retry"}).status, 0);
  EXPECT_EQ(server_.arrivals().size(), 8u);
}

TEST_F(RecordsCommand, TellsAnAttemptToTheSystemThatLaunchedIt) {
  int fetched = 0;
  std::string lesson = "school/first-movements";
  Attempt made = someAttempt();
  made.caseId = "school";
  made.id = "20261126-110000-4f2a91c9";
  ASSERT_TRUE(AttemptFolder::begin(folder_.path() / "library/attempts", made));
  Lesson known = someLesson();
  known.steps[2].task = AnswerTask{{{"a", true, ""}, {"b", false, ""}}, {}, 0.0, ""};
  const EnvironmentValue own("ECHOWEAVE_CASES", folder_ / "own");
  makeSmallCase(folder_ / "own/school");
  auto manifest = readJson(folder_ / "own/school/case.json");
  manifest["id"] = "school";
  manifest["parts"]["lessons"] = jsonOf(std::vector<Lesson>{known});
  writeText(folder_ / "own/school/case.json", manifest.dump());
  const auto school = loadCase(folder_ / "own/school");
  ASSERT_TRUE(school) << school.error();
  const auto taught = lessonsOf(*school);
  ASSERT_TRUE(taught) << taught.error();
  server_.authorization = "Basic dG9rZW4tMTc=";
  server_.other = [&](const ServerQuestion& question) -> std::optional<ServerAnswer> {
    if (question.target == "/fetch")
      return ++fetched == 1 ? ServerAnswer{200, R"({"auth-token": "dG9rZW4tMTc="})", {}}
                            : ServerAnswer{200, R"({"error-code": "1", "error-text": "given already"})", {}};
    if (question.target.starts_with("/xapi/activities/state"))
      return ServerAnswer{
          200,
          R"({"contextTemplate": {"extensions": {"urn:s": "42"}}, "launchMode": "Normal", "moveOn": "Passed", "masteryScore": 0.2,
              "launchParameters": ")" +
              lesson + R"("})",
          {}};
    if (question.target.starts_with("/xapi/agents/profile")) return ServerAnswer{404, "", {}};
    return std::nullopt;
  };
  const std::string url =
      "echoweave-cmi5:?endpoint=" + server_.endpoint() + "&fetch=http://127.0.0.1:" + std::to_string(server_.port()) +
      "/fetch&actor=%7B%22account%22%3A%7B%22homePage%22%3A%22https%3A%2F%2Flms.example%2F%22%2C%22name%22%3A%22l%22%7D%7D"
      "&registration=886313e1-3b8a-5372-9b90-0c9aee199e5d&activityId=https://lms.example/au/1";
  const std::string attempt = folder_ / ("library/attempts/" + made.id);
  const auto others = run({"records", "launch", url, attempt, "--rounds", "1"});
  EXPECT_EQ(others.status, 2);
  EXPECT_NE(others.err.find("is by 'Ada Lovelace', and the launch is for 'l'"), std::string::npos) << others.err;
  EXPECT_EQ(fetched, 0) << "a launch that tells nothing can be used again";
  const auto told = run({"records", "launch", url, attempt, "--rounds", "1", "--person", "Ada Lovelace"});
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(told.out, "127.0.0.1 knows of the attempt now.\n");
  const auto order = server_.order();
  ASSERT_EQ(order.size(), 4u);
  std::vector<std::string> verbs;
  for (const std::string& id : order) verbs.push_back(server_.stored(id)["verb"]["display"]["en"]);
  EXPECT_EQ(verbs, (std::vector<std::string>{"initialized", "completed", "passed", "terminated"}));
  EXPECT_EQ(server_.stored(order[2])["result"]["score"]["scaled"], (0.75 + 0.0 + 0.0) / 3.0) << "above the mastery score of the course";
  EXPECT_NE(told.err.find("The learning system asks for 20 of 100 points: passed there. The lesson asks that it is finished and every step "
                          "that counts is passed: not passed."),
            std::string::npos)
      << told.err;
  EXPECT_EQ(server_.stored(order[1])["result"]["duration"], "PT2M55.92S");
  const auto again = run({"records", "launch", url, attempt, "--rounds", "1", "--person", "Ada Lovelace"});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.err.find("given already"), std::string::npos) << again.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "library/records")) << "nothing of a session stays";
}

TEST_F(RecordsCommand, TellsNothingOfAnAttemptAtAnotherLesson) {
  server_.authorization = "Basic dG9rZW4tMTc=";
  server_.other = [&](const ServerQuestion& question) -> std::optional<ServerAnswer> {
    if (question.target == "/fetch") return ServerAnswer{200, R"({"auth-token": "dG9rZW4tMTc="})", {}};
    if (question.target.starts_with("/xapi/activities/state"))
      return ServerAnswer{
          200, R"({"contextTemplate": {"a": {}}, "launchMode": "Normal", "launchParameters": "fetal-biometry/three-standard-planes"})", {}};
    return ServerAnswer{404, "", {}};
  };
  const std::string url =
      "echoweave-cmi5:?endpoint=" + server_.endpoint() + "&fetch=http://127.0.0.1:" + std::to_string(server_.port()) +
      "/fetch&actor=%7B%22name%22%3A%22Lovelace%2C%20Ada%22%2C%22account%22%3A%7B%22homePage%22%3A%22https%3A%2F%2Flms.example%2F%22%2C"
      "%22name%22%3A%22l%22%7D%7D&registration=886313e1-3b8a-5372-9b90-0c9aee199e5d&activityId=https://lms.example/au/1";
  const auto told = run({"records", "launch", url, folder_ / ("library/attempts/" + someAttempt().id), "--rounds", "1"});
  EXPECT_EQ(told.status, 2);
  EXPECT_NE(told.err.find("starts the lesson fetal-biometry/three-standard-planes, and the attempt is at "
                          "upper-abdomen-normal/first-movements"),
            std::string::npos)
      << told.err;
  EXPECT_TRUE(server_.order().empty());
}

TEST_F(RecordsCommand, LeavesOutADamagedAttemptAndNamesIt) {
  setUp(server_.endpoint());
  for (const char* id : {"20261126-093000-damaged1", "20261126-093000-damaged2"}) {
    std::filesystem::create_directories(folder_ / ("library/attempts/" + std::string(id)));
    writeText(folder_ / ("library/attempts/" + std::string(id) + "/attempt.json"), R"({"format": 1, "id": 5, "case": 5})");
  }
  const auto shown = records({"add", "--dry-run"});
  EXPECT_EQ(shown.status, 1);
  EXPECT_EQ(nlohmann::json::parse(shown.out).size(), 8u) << "the sound one is shown";
  const auto added = records({"add"});
  EXPECT_EQ(added.status, 1);
  EXPECT_NE(added.out.find("Took 8 statements of 1 attempt"), std::string::npos) << added.out;
  for (const char* part : {"20261126-093000-damaged1", "20261126-093000-damaged2", "Left out: 2 of 3 attempts"})
    EXPECT_NE(added.err.find(part), std::string::npos) << added.err;
  EXPECT_NE(records({"list"}).out.find("8 statements to send"), std::string::npos);
}

TEST_F(RecordsCommand, CallsACaseAsTraineesMayReadIt) {
  Attempt attempt = someAttempt();
  attempt.id = "20261126-100000-4f2a91c8";
  attempt.caseId = "upper-abdomen-gall-stone";
  attempt.lessonId = "right-upper-quadrant";
  const auto opened = loadCase(std::string(EW_SOURCE_DIR) + "/cases/upper-abdomen-gall-stone");
  ASSERT_TRUE(opened) << opened.error();
  ASSERT_NE(titleForTrainees(*opened), opened->title);
  ASSERT_TRUE(AttemptFolder::begin(folder_.path() / "library/attempts", attempt));
  setUp(server_.endpoint());
  const auto shown = records({"add", folder_ / ("library/attempts/" + attempt.id), "--dry-run"});
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_NE(shown.out.find(titleForTrainees(*opened)), std::string::npos) << shown.out;
  EXPECT_EQ(shown.out.find(opened->title), std::string::npos) << shown.out;
}

/// A learning management system that launches a lesson, and a program in place of the window.
class LessonLaunch : public RecordsCommand {
 protected:
  LessonLaunch() {
    server_.authorization = "Basic dG9rZW4tMTc=";
    server_.other = [this](const ServerQuestion& question) -> std::optional<ServerAnswer> {
      if (question.target == "/fetch") {
        ++fetched_;
        return ServerAnswer{200, R"({"auth-token": "dG9rZW4tMTc="})", {}};
      }
      if (question.target.starts_with("/xapi/activities/state"))
        return ServerAnswer{
            200,
            R"({"contextTemplate": {"extensions": {"urn:s": "42"}}, "launchMode": "Normal", "moveOn": "Passed", "launchParameters": ")" +
                parameters_ + R"(")" + (masteryScore_.empty() ? "" : ", \"masteryScore\": " + masteryScore_) + "}",
            {}};
      if (question.target.starts_with("/xapi/agents/profile")) return ServerAnswer{404, "", {}};
      return std::nullopt;
    };
  }
  [[nodiscard]] std::string address() {
    return "echoweave-cmi5:?endpoint=" + server_.endpoint() + "&fetch=http://127.0.0.1:" + std::to_string(server_.port()) +
           "/fetch&actor=%7B%22account%22%3A%7B%22homePage%22%3A%22https%3A%2F%2Flms.example%2F%22%2C%22name%22%3A%22l%22%7D%7D"
           "&registration=886313e1-3b8a-5372-9b90-0c9aee199e5d&activityId=https://lms.example/au/1";
  }
  /// @param asked exit status of the question; @param works a line of shell in place of the lesson
  std::string windowThat(int asked, const std::string& works) {
    const std::string file = folder_ / "window";
    writeText(file, "#!/bin/sh\necho \"$@\" >> '" + (folder_ / "words") + "'\ncase $1 in --launched-by) exit " + std::to_string(asked) +
                        ";; esac\n" + works + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }
  [[nodiscard]] std::vector<std::string> verbs() {
    std::vector<std::string> said;
    for (const std::string& id : server_.order()) said.push_back(server_.stored(id)["verb"]["display"]["en"]);
    return said;
  }
  /// An attempt that was finished just now, beside the library; the line of shell puts it there. @param launch that began it; the
  /// window's own where it says so
  std::string finishesALesson(const std::string& launch = "THIS-LAUNCH", const std::string& id = "20991231-000000-aaaaaaaa",
                              const std::string& person = "Ada Lovelace", int after_s = 0) {
    Attempt attempt = someAttempt();
    attempt.person = person;
    attempt.startedAt += std::chrono::seconds(after_s);
    attempt.caseId = "fetal-biometry";
    attempt.lessonId = "three-standard-planes";
    attempt.id = id;
    attempt.launch = launch;
    attempt.finishedAt = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()) + std::chrono::hours(1);
    EXPECT_TRUE(AttemptFolder::begin(folder_.path() / "aside", attempt));
    return "sed -i \"s/THIS-LAUNCH/$ECHOWEAVE_LAUNCH/\" '" + (folder_ / ("aside/" + attempt.id + "/attempt.json")) + "'; mv '" +
           (folder_ / ("aside/" + attempt.id)) + "' '" + (folder_ / "library/attempts/") + "'";
  }
  std::string parameters_ = "fetal-biometry/three-standard-planes";
  std::string masteryScore_;  ///< as JSON; empty: none
  int fetched_ = 0;
};

TEST_F(LessonLaunch, IsOpenedInTheWindowAndItsResultTold) {
  const auto told = run({"records", "launch", address(), "--window", windowThat(0, finishesALesson()), "--rounds", "1"});
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(verbs(), (std::vector<std::string>{"initialized", "completed", "failed", "terminated"}));
  const std::string words = readText(folder_ / "words");
  EXPECT_TRUE(words.starts_with("--launched-by 127.0.0.1\n")) << words;
  EXPECT_NE(words.find("fetal-biometry --lesson three-standard-planes\n"), std::string::npos) << words;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "library/records")) << "nothing of a session stays";
}

TEST_F(LessonLaunch, SaysWhatScoreTheSystemAsksForToTheWindow) {
  const std::string asks = "echo \"asks for ${ECHOWEAVE_MASTERY_SCORE-none}\" >> '" + (folder_ / "words") + "'";
  const EnvironmentValue stale("ECHOWEAVE_MASTERY_SCORE", "0.9");
  ASSERT_EQ(run({"records", "launch", address(), "--wanted", "--window", windowThat(0, asks), "--rounds", "1"}).status, 0);
  EXPECT_NE(readText(folder_ / "words").find("asks for none\n"), std::string::npos) << "another launch's is not passed on";
  masteryScore_ = "0.65";
  ASSERT_EQ(run({"records", "launch", address(), "--wanted", "--window", windowThat(0, asks), "--rounds", "1"}).status, 0);
  EXPECT_NE(readText(folder_ / "words").find("asks for 0.65\n"), std::string::npos) << readText(folder_ / "words");
}

TEST_F(LessonLaunch, IsToldByTheSystemsLevelAndSaysWhereTheLessonsDiffers) {
  masteryScore_ = "0";
  const auto told = run({"records", "launch", address(), "--wanted", "--window", windowThat(0, finishesALesson()), "--rounds", "1"});
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(verbs(), (std::vector<std::string>{"initialized", "completed", "passed", "terminated"}));
  EXPECT_NE(told.err.find("The learning system asks for 0 of 100 points: passed there."), std::string::npos) << told.err;
  EXPECT_NE(told.err.find("not passed."), std::string::npos) << told.err;
}

TEST_F(LessonLaunch, OfTwoLearnersOnOneLibraryTellsEachTheirOwn) {
  // Another seat finishes the lesson meanwhile, launched or not, while this learner closes the window in the middle.
  const std::string window =
      windowThat(0, finishesALesson("", "20991231-000000-bbbbbbbb") + "; " + finishesALesson("0a5f.17-4", "20991231-000000-cccccccc"));
  const auto told = run({"records", "launch", address(), "--wanted", "--window", window, "--rounds", "1"});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(verbs(), (std::vector<std::string>{"initialized", "terminated"})) << "nothing of the other's";
  EXPECT_NE(told.err.find("is not told"), std::string::npos) << told.err;
  // This learner finishes it as well, and the other once more afterwards.
  const std::string both = windowThat(
      0, finishesALesson("THIS-LAUNCH", "20991231-000000-dddddddd") + "; " + finishesALesson("0a5f.17-5", "20991231-000000-eeeeeeee"));
  ASSERT_EQ(run({"records", "launch", address(), "--wanted", "--window", both, "--rounds", "1"}).status, 0);
  const auto order = server_.order();
  ASSERT_EQ(order.size(), 6u);
  EXPECT_EQ(verbs()[4], "failed");
  // Nor is another learner's attempt told to this one by its folder.
  const auto others =
      run({"records", "launch", address(), folder_ / "library/attempts/20991231-000000-eeeeeeee", "--person", "Ada Lovelace"});
  EXPECT_EQ(others.status, 2);
  EXPECT_NE(others.err.find("somebody else's launch"), std::string::npos) << others.err;
  const auto own = run({"records", "launch", address(), folder_ / "library/attempts/20991231-000000-dddddddd", "--rounds", "1"});
  EXPECT_EQ(own.status, 0) << own.err;
}

TEST_F(LessonLaunch, OfWhoeverSitsDownNextInTheSameWindowIsNotTold) {
  // The learner stops; the next one types another name into the window and finishes the lesson.
  const std::string window = windowThat(0, finishesALesson("THIS-LAUNCH", "20991231-000000-abababab", "Ada Lovelace") + "; " +
                                               finishesALesson("THIS-LAUNCH", "20991231-000000-cdcdcdcd", "Grace Hopper", 60));
  const auto told = run({"records", "launch", address(), "--wanted", "--window", window, "--rounds", "1"});
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_NE(told.err.find("'Grace Hopper' finished the lesson in the same window"), std::string::npos) << told.err;
  EXPECT_EQ(verbs(), (std::vector<std::string>{"initialized", "completed", "failed", "terminated"})) << "the learner's own";
  const auto others = run({"records", "launch", address(), folder_ / "library/attempts/20991231-000000-cdcdcdcd"});
  EXPECT_EQ(others.status, 2);
  EXPECT_NE(others.err.find("is by 'Grace Hopper'"), std::string::npos) << others.err;
}

TEST_F(LessonLaunch, IsNothingToAnybodyWhenTheLearnerDoesNotWantIt) {
  const auto told = run({"records", "launch", address(), "--window", windowThat(1, "exit 9")});
  EXPECT_EQ(told.status, 1);
  EXPECT_NE(told.err.find("127.0.0.1 was told nothing"), std::string::npos) << told.err;
  EXPECT_EQ(fetched_, 0) << "not even the token was fetched";
  EXPECT_TRUE(server_.order().empty());
}

TEST_F(LessonLaunch, ThatIsNotFinishedIsOverAndNeitherPassedNorFailed) {
  const auto told = run({"records", "launch", address(), "--wanted", "--window", windowThat(1, "true"), "--rounds", "1"});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_NE(told.err.find("was not finished"), std::string::npos) << told.err;
  EXPECT_EQ(verbs(), (std::vector<std::string>{"initialized", "terminated"}));
}

TEST_F(LessonLaunch, HasToBeNamedByTheCourse) {
  for (const char* parameters : {"", "fetal-biometry", "no-such-case/lesson"}) {
    parameters_ = parameters;
    const auto told = run({"records", "launch", address(), "--wanted", "--window", windowThat(0, "true")});
    EXPECT_EQ(told.status, 1) << parameters;
    EXPECT_TRUE(server_.order().empty()) << parameters;
  }
}

TEST_F(LessonLaunch, SaysSoWhenThereIsNoWindow) {
  const auto told = run({"records", "launch", address(), "--window", folder_ / "nothing"});
  EXPECT_EQ(told.status, 1);
  EXPECT_NE(told.err.find("cannot be started"), std::string::npos) << told.err;
  EXPECT_EQ(fetched_, 0);
}

TEST_F(RecordsCommand, WithoutANetworkEverythingWaits) {
  setUp(server_.endpoint());
  ASSERT_EQ(records({"add"}).status, 0);
  server_.goAway();
  const auto away = records({"send", "--rounds", "1"});
  EXPECT_EQ(away.status, 1);
  EXPECT_NE(away.err.find("safe in the outbox: 8"), std::string::npos) << away.err;
  server_.comeBack();
  EXPECT_EQ(records({"send"}).status, 0);
}

}  // namespace
}  // namespace ew::test::records_command_test
