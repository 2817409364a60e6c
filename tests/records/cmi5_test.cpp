#include "ew/records/cmi5.h"

#include <gtest/gtest.h>

#include "library/temporary_folder.h"
#include "records/record_server.h"
#include "records/record_world.h"

namespace ew::test::cmi5_test {
namespace {

using nlohmann::json;
using Moment = Cmi5Session::Moment;

constexpr const char* kRegistration = "886313e1-3b8a-5372-9b90-0c9aee199e5d";
constexpr const char* kActivity = "https://lms.example/au/1";

Moment at(int seconds) { return Moment(std::chrono::seconds(1'795'685'400 + seconds)); }

json learner() { return {{"objectType", "Agent"}, {"account", {{"homePage", "https://lms.example/"}, {"name", "l-17"}}}}; }

/// Percent-encodes everything, which is always allowed.
std::string encodedFully(const std::string& text) {
  std::string made;
  for (const char letter : text) {
    char code[4];
    std::snprintf(code, sizeof code, "%%%02x", static_cast<unsigned>(static_cast<unsigned char>(letter)));
    made += code;
  }
  return made;
}

json someLaunchData() {
  return {{"contextTemplate",
           {{"contextActivities", {{"grouping", json::array({{{"id", "https://lms.example/publisher/1"}}})}}},
            {"extensions", {{"https://w3id.org/xapi/cmi5/context/extensions/sessionid", "s-42"}}}}},
          {"launchMode", "Normal"},
          {"moveOn", "CompletedAndPassed"},
          {"masteryScore", 0.8},
          {"launchParameters", "upper-abdomen-normal/first-movements"},
          {"returnURL", "https://lms.example/back"}};
}

/// A learning management system: a record store that gives a token once and has launch data.
class Cmi5 : public testing::Test {
 protected:
  Cmi5() {
    server_.other = [this](const ServerQuestion& question) { return answerTo(question); };
    server_.authorization = "Basic dG9rZW4tMTc=";
  }
  std::optional<ServerAnswer> answerTo(const ServerQuestion& question) {
    if (question.target == "/fetch?session=42") {
      if (question.method != "POST") return ServerAnswer{405, "", {}};
      if (fetchAnswer_) return fetchAnswer_;
      if (++fetched_ > 1) return ServerAnswer{200, R"({"error-code": "1", "error-text": "The token was given already."})", {}};
      return ServerAnswer{200, R"({"auth-token": "dG9rZW4tMTc="})", {}};
    }
    if (question.headers.contains("authorization") &&
        server_.authorization.with([&](const std::string& wanted) { return question.headers.at("authorization") != wanted; }))
      return std::nullopt;
    if (question.target.starts_with("/xapi/activities/state?stateId=LMS.LaunchData"))
      return launchData_.is_null() ? ServerAnswer{404, "none", {}} : ServerAnswer{200, launchData_.dump(), {}};
    if (question.target.starts_with("/xapi/agents/profile?profileId=cmi5LearnerPreferences"))
      return preferences_.is_null() ? ServerAnswer{404, "", {}} : ServerAnswer{200, preferences_.dump(), {}};
    return std::nullopt;
  }
  std::string url(const std::string& scheme = "echoweave-cmi5:") const {
    return scheme + "?endpoint=" + encodedFully(server_.endpoint()) +
           "&fetch=" + encodedFully("http://127.0.0.1:" + std::to_string(server_.port()) + "/fetch?session=42") +
           "&actor=" + encodedFully(learner().dump()) + "&registration=" + kRegistration + "&activityId=" + encodedFully(kActivity);
  }
  Cmi5Session begun() {
    auto launch = cmi5LaunchOf(url());
    EXPECT_TRUE(launch) << launch.error();
    auto session = Cmi5Session::begin(*launch);
    EXPECT_TRUE(session) << session.error();
    return std::move(*session);
  }
  std::string whyNot() {
    const auto session = Cmi5Session::begin(*cmi5LaunchOf(url()));
    return session ? "it began" : session.error().sentence();
  }

  RecordServer server_;
  json launchData_ = someLaunchData();
  json preferences_;
  std::optional<ServerAnswer> fetchAnswer_;
  int fetched_ = 0;
};

std::vector<std::string> categoriesOf(const json& statement) {
  std::vector<std::string> ids;
  for (const json& each : statement["context"]["contextActivities"]["category"]) {
    const std::string id = each["id"];
    ids.push_back(id.substr(id.rfind('/') + 1));
  }
  return ids;
}

TEST_F(Cmi5, ReadsALaunchHoweverItsAddressBegins) {
  for (const char* begin : {"echoweave-cmi5:", "echoweave-cmi5://launch", "https://any.where/page"}) {
    const auto launch = cmi5LaunchOf(url(begin));
    ASSERT_TRUE(launch) << launch.error();
    EXPECT_EQ(launch->endpoint, server_.endpoint());
    EXPECT_EQ(launch->actor, learner());
    EXPECT_EQ(launch->registration, kRegistration);
    EXPECT_EQ(launch->activityId, kActivity);
    EXPECT_EQ(launchHost(*launch), "127.0.0.1");
  }
}

TEST_F(Cmi5, SaysWhatIsMissingInALaunch) {
  for (const char* name : {"endpoint", "fetch", "actor", "registration", "activityId"}) {
    std::string broken = url();
    broken.replace(broken.find(std::string(name) + "="), std::strlen(name), "x");
    const auto launch = cmi5LaunchOf(broken);
    ASSERT_FALSE(launch) << name;
    EXPECT_NE(launch.error().sentence().find(name), std::string::npos) << launch.error();
  }
  const auto with = [&](const std::string& name, const std::string& value) {
    std::string changed = url();
    const auto begin = changed.find(name + "=") + name.size() + 1;
    changed.replace(begin, changed.find('&', begin) == std::string::npos ? std::string::npos : changed.find('&', begin) - begin,
                    encodedFully(value));
    return cmi5LaunchOf(changed);
  };
  EXPECT_TRUE(with("actor", json::array({learner()}).dump())) << "a list of one, as some systems send it";
  EXPECT_FALSE(with("actor", R"({"mbox": "mailto:a@b.c"})"));
  EXPECT_FALSE(with("actor", "{"));
  EXPECT_FALSE(with("registration", "17"));
  EXPECT_FALSE(with("activityId", "no address"));
  EXPECT_FALSE(with("endpoint", "http://evil.example/"));
  EXPECT_FALSE(with("fetch", "http://evil.example/"));
  EXPECT_FALSE(with("fetch", "file:///etc/passwd"));
  EXPECT_FALSE(cmi5LaunchOf("echoweave-cmi5:"));
  EXPECT_FALSE(cmi5LaunchOf("echoweave-cmi5:?endpoint=%2"));
  EXPECT_FALSE(cmi5LaunchOf("echoweave-cmi5:?" + std::string(1 << 20, 'x')));
}

TEST_F(Cmi5, BeginsWithTheTokenTheLaunchDataAndThePreferences) {
  preferences_ = {{"languagePreference", "de-DE,en"}, {"audioPreference", "off"}};
  const Cmi5Session session = begun();
  EXPECT_EQ(session.store().authorization, "Basic dG9rZW4tMTc=");
  EXPECT_EQ(session.data().mode, Cmi5Mode::normal);
  EXPECT_EQ(session.data().moveOn, Cmi5MoveOn::completedAndPassed);
  EXPECT_EQ(session.data().masteryScore, 0.8);
  EXPECT_EQ(session.data().launchParameters, "upper-abdomen-normal/first-movements");
  EXPECT_EQ(session.data().returnUrl, "https://lms.example/back");
  EXPECT_EQ(session.data().languagePreference, "de-DE,en");
  EXPECT_EQ(fetched_, 1);
}

TEST_F(Cmi5, DoesWithoutPreferences) { EXPECT_EQ(begun().data().languagePreference, ""); }

TEST_F(Cmi5, SaysWhyThereIsNoToken) {
  (void)begun();
  EXPECT_NE(whyNot().find("error 1, \"The token was given already\""), std::string::npos) << whyNot();
  fetchAnswer_ = {403, "<html>Not you</html>", {}};
  EXPECT_NE(whyNot().find("403 \"Not you\""), std::string::npos) << whyNot();
  fetchAnswer_ = {200, "{}", {}};
  EXPECT_NE(whyNot().find("no token"), std::string::npos);
  fetchAnswer_ = {200, "{\"auth-token\": \"a\\r\\nX: y\"}", {}};
  EXPECT_NE(whyNot().find("no token"), std::string::npos);
  fetchAnswer_ = {200, "{\"error-code\": 2}", {}};
  EXPECT_NE(whyNot().find("error 2"), std::string::npos) << whyNot();
}

TEST_F(Cmi5, SaysWhyThereIsNoLaunchData) {
  launchData_ = nullptr;
  EXPECT_NE(whyNot().find("no launch data (404 \"none\")"), std::string::npos) << whyNot();
}

TEST_F(Cmi5, SaysWhichFieldOfTheLaunchDataCannotBeUsed) {
  launchData_["launchMode"] = "Sideways";
  EXPECT_NE(whyNot().find("launchMode"), std::string::npos);
}

TEST_F(Cmi5, OddAnswersAreASentenceAndNothingElse) {
  fetchAnswer_ = ServerAnswer{200, R"({"error-code": 7, "error-text": 12})", {}};
  EXPECT_EQ(whyNot(),
            "The lesson cannot be begun for the learning management system: it gives no token (error 7, \"12\"). Start it there again.");
  fetchAnswer_ = ServerAnswer{200, R"({"error-code": {"a": 1}, "error-text": ["b"]})", {}};
  EXPECT_NE(whyNot().find("error {\"a\":1}"), std::string::npos) << whyNot();
  std::string deep;
  for (int n = 0; n < 150'000; ++n) deep += R"({"message":)";
  for (const int status : {200, 400, 401}) {
    fetchAnswer_ = ServerAnswer{status, deep, {}};
    EXPECT_NE(whyNot().find("no token"), std::string::npos) << whyNot();
  }
}

TEST_F(Cmi5, ATemplateThatStatementsCannotBePutIntoIsRefusedByName) {
  launchData_["contextTemplate"]["contextActivities"] = 5;
  EXPECT_EQ(whyNot(), "'contextTemplate.contextActivities' in LMS.LaunchData is 5; it must be an object.");
  fetched_ = 0;
  launchData_["contextTemplate"] = {{"extensions", "none"}};
  EXPECT_EQ(whyNot(), "'contextTemplate.extensions' in LMS.LaunchData is \"none\"; it must be an object.");
  fetched_ = 0;
  launchData_["contextTemplate"] = {{"contextActivities", {{"category", 5}, {"grouping", {{"id", "https://lms.example/1"}}}}},
                                    {"revision", 4}};
  Cmi5Session session = begun();
  const auto said = session.initialized(at(0));
  ASSERT_TRUE(said);
  EXPECT_EQ((*said)["context"]["contextActivities"]["category"].size(), 2u);
}

TEST_F(Cmi5, TellsASessionAsTheProfileWantsIt) {
  Cmi5Session session = begun();
  const json initialized = *session.initialized(at(0));
  const json completed = *session.completed(at(60));
  const json judged = *session.judged(0.85, false, at(61));
  const json terminated = *session.terminated(at(75));
  for (const json& each : {initialized, completed, judged, terminated}) {
    EXPECT_EQ(each["actor"], learner());
    EXPECT_EQ(each["object"]["id"], kActivity);
    EXPECT_EQ(each["context"]["registration"], kRegistration);
    EXPECT_EQ(each["context"]["extensions"]["https://w3id.org/xapi/cmi5/context/extensions/sessionid"], "s-42");
    EXPECT_EQ(each["context"]["contextActivities"]["grouping"][0]["id"], "https://lms.example/publisher/1");
    EXPECT_EQ(categoriesOf(each)[0], "cmi5");
  }
  EXPECT_EQ(initialized["verb"]["id"], "http://adlnet.gov/expapi/verbs/initialized");
  EXPECT_FALSE(initialized.contains("result"));
  EXPECT_EQ(completed["result"], json({{"completion", true}, {"duration", "PT1M"}}));
  EXPECT_EQ(categoriesOf(completed), (std::vector<std::string>{"cmi5", "moveon"}));
  EXPECT_EQ(judged["verb"]["id"], "http://adlnet.gov/expapi/verbs/passed") << "the mastery score decides";
  EXPECT_EQ(judged["result"]["success"], true);
  EXPECT_EQ(judged["result"]["score"]["scaled"], 0.85);
  EXPECT_EQ(judged["context"]["extensions"]["https://w3id.org/xapi/cmi5/context/extensions/masteryscore"], 0.8);
  EXPECT_EQ(categoriesOf(judged), (std::vector<std::string>{"cmi5", "moveon"}));
  EXPECT_EQ(terminated["result"], json({{"duration", "PT1M15S"}}));
  EXPECT_TRUE(session.movesOn());
  EXPECT_FALSE(session.isOpen());
}

TEST_F(Cmi5, SaysHowLongALessonTookThatWasWorkedOnBefore) {
  Cmi5Session session = begun();
  ASSERT_TRUE(session.initialized(at(0)));
  EXPECT_EQ((*session.completed(at(1), 754.0))["result"]["duration"], "PT12M34S");
  EXPECT_EQ((*session.judged(0.9, true, at(1), 754.0))["result"]["duration"], "PT12M34S");
  EXPECT_EQ((*session.terminated(at(2)))["result"]["duration"], "PT2S") << "the session took what it took";
}

TEST_F(Cmi5, ALastDigitBelowTheMasteryScoreReachesIt) {
  launchData_["masteryScore"] = 0.7;
  Cmi5Session session = begun();
  ASSERT_TRUE(session.initialized(at(0)));
  const double mean = (0.7 + 0.7 + 0.7) / 3.0;
  ASSERT_LT(mean, 0.7);
  const json judged = *session.judged(mean, true, at(1));
  EXPECT_EQ(judged["verb"]["id"], "http://adlnet.gov/expapi/verbs/passed");
  EXPECT_EQ(judged["result"]["score"]["scaled"], 0.7) << "a learning system refuses a pass below its mastery score";
}

TEST_F(Cmi5, KeepsTheOrder) {
  Cmi5Session session = begun();
  EXPECT_FALSE(session.completed(at(1)));
  EXPECT_FALSE(session.judged(1.0, true, at(1)));
  EXPECT_FALSE(session.terminated(at(1)));
  ASSERT_TRUE(session.initialized(at(1)));
  EXPECT_FALSE(session.initialized(at(2)));
  EXPECT_FALSE(session.judged(1.5, true, at(2)));
  ASSERT_TRUE(session.judged(0.5, true, at(2)));
  EXPECT_FALSE(session.judged(0.9, true, at(3))) << "passed or failed, once";
  ASSERT_TRUE(session.completed(at(3)));
  EXPECT_FALSE(session.completed(at(4)));
  EXPECT_FALSE(session.movesOn()) << "0.5 is below the mastery score";
  ASSERT_TRUE(session.terminated(at(5)));
  EXPECT_EQ(session.terminated(at(6)).error().code, ErrorCode::badUsage);
  EXPECT_FALSE(session.completed(at(6)));
}

TEST_F(Cmi5, IsNotJudgedWhereItOnlyLooks) {
  for (const char* mode : {"Browse", "Review"}) {
    launchData_["launchMode"] = mode;
    fetched_ = 0;
    Cmi5Session session = begun();
    ASSERT_TRUE(session.initialized(at(0)));
    EXPECT_FALSE(session.completed(at(1)));
    EXPECT_FALSE(session.judged(1.0, true, at(1)));
    EXPECT_TRUE(session.terminated(at(2)));
  }
}

TEST_F(Cmi5, MovesOnAsTheCourseWantsIt) {
  const auto movesOn = [&](const char* rule, bool isCompleted, std::optional<bool> passed) {
    launchData_["moveOn"] = rule;
    launchData_.erase("masteryScore");
    fetched_ = 0;
    Cmi5Session session = begun();
    EXPECT_TRUE(session.initialized(at(0)));
    EXPECT_EQ(isCompleted, isCompleted && session.completed(at(1)).has_value());
    EXPECT_EQ(passed.has_value(), passed && session.judged({}, *passed, at(2)).has_value());
    return session.movesOn();
  };
  EXPECT_TRUE(movesOn("NotApplicable", false, {}));
  EXPECT_FALSE(movesOn("Passed", true, {}));
  EXPECT_TRUE(movesOn("Passed", false, true));
  EXPECT_FALSE(movesOn("Passed", false, false));
  EXPECT_TRUE(movesOn("Completed", true, false));
  EXPECT_FALSE(movesOn("CompletedAndPassed", true, false));
  EXPECT_TRUE(movesOn("CompletedOrPassed", false, true));
  EXPECT_FALSE(movesOn("CompletedOrPassed", false, {}));
}

TEST_F(Cmi5, ArrivesInOrderAlsoWhenTheNetworkIsAwayForAWhile) {
  Cmi5Session session = begun();
  const TemporaryFolder folder;
  auto outbox = StatementOutbox::open(folder / "session");
  ASSERT_TRUE(outbox);
  std::vector<std::string> ids;
  for (const json& each :
       {*session.initialized(at(0)), *session.completed(at(9)), *session.judged(0.9, true, at(9)), *session.terminated(at(10))}) {
    ids.push_back(each["id"]);
    ASSERT_EQ(outbox->add(each), true);
  }
  server_.fault = [n = 0](const ServerQuestion&) mutable { return ++n == 1 ? Fault::closeAfterTaking : Fault::none; };
  SendStatementsOptions options;
  options.wait = [](double) { return true; };
  const auto sent = sendStatements(*outbox, session.store(), options);
  ASSERT_TRUE(sent) << sent.error();
  EXPECT_EQ(sent->sent, 4u);
  EXPECT_EQ(server_.order(), ids);
}

}  // namespace
}  // namespace ew::test::cmi5_test
