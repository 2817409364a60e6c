#include <gtest/gtest.h>
#include <openssl/evp.h>

#include <chrono>

#include "ew/records/statement_outbox.h"
#include "library/temporary_folder.h"
#include "records/record_server.h"
#include "records/record_world.h"

namespace ew::test::statement_sending_test {
namespace {

using std::chrono::steady_clock;

class StatementSending : public testing::Test {
 protected:
  StatementSending() {
    store_.endpoint = server_.endpoint();
    store_.timeout_s = 20.0;
    options_.wait = [this](double seconds) {
      waits_.push_back(seconds);
      return true;
    };
    auto opened = StatementOutbox::open(folder_ / "o");
    outbox_.emplace(std::move(*opened));
  }
  SendStatementsResult send() {
    const auto sent = sendStatements(*outbox_, store_, options_);
    EXPECT_TRUE(sent) << sent.error();
    return sent ? *sent : SendStatementsResult{};
  }
  void reopen() {
    outbox_.reset();
    auto opened = StatementOutbox::open(folder_ / "o");
    ASSERT_TRUE(opened);
    outbox_.emplace(std::move(*opened));
  }
  void expectEachOnce(int count, const std::string& series = "a") {
    const auto arrivals = server_.arrivals();
    EXPECT_EQ(arrivals.size(), static_cast<std::size_t>(count));
    for (int n = 0; n < count; ++n) {
      ASSERT_TRUE(arrivals.contains(idNumbered(n, series))) << n;
      EXPECT_EQ(arrivals.at(idNumbered(n, series)), 1) << n;
    }
  }
  /// The n-th question, from 1, goes wrong.
  void goesWrong(std::map<int, Fault> at) {
    server_.fault = [at, n = 0](const ServerQuestion&) mutable {
      const auto found = at.find(++n);
      return found == at.end() ? Fault::none : found->second;
    };
  }

  TemporaryFolder folder_;
  RecordServer server_;
  RecordStore store_;
  SendStatementsOptions options_;
  std::optional<StatementOutbox> outbox_;
  std::vector<double> waits_;
};

TEST_F(StatementSending, SendsSeveralTogetherInTheirOrderWithVersionAndPassword) {
  server_.authorization = "Basic bW9uYTpzZWNyZXQ6MQ==";  // RFC 7617 of mona and secret:1
  store_.authorization = *basicAuthorization("mona", "secret:1");
  fill(*outbox_, 120);
  const auto sent = send();
  EXPECT_EQ(sent.sent, 120u);
  EXPECT_EQ(sent.left, 0u);
  EXPECT_EQ(sent.rounds, 1);
  EXPECT_TRUE(sent.problem.empty());
  EXPECT_TRUE(waits_.empty());
  expectEachOnce(120);
  const auto order = server_.order();
  for (int n = 0; n < 120; ++n) EXPECT_EQ(order[static_cast<std::size_t>(n)], idNumbered(n));
  ASSERT_EQ(server_.questions().size(), 3u);
  for (const ServerQuestion& each : server_.questions()) {
    EXPECT_EQ(each.method, "POST");
    EXPECT_EQ(each.target, "/xapi/statements");
    EXPECT_EQ(each.headers.at("x-experience-api-version"), "1.0.3");
    EXPECT_EQ(each.headers.at("content-type"), "application/json");
  }
  EXPECT_EQ(server_.stored(idNumbered(7)), statementNumbered(7));
  EXPECT_EQ(outbox_->count(OutboxStatus::arrived), 120u);
}

TEST_F(StatementSending, SendsATokenAsItIs) {
  server_.authorization = "Bearer abc.def";
  store_.authorization = *bearerAuthorization("abc.def");
  fill(*outbox_, 1);
  EXPECT_EQ(send().sent, 1u);
}

TEST_F(StatementSending, WaitsTwiceAsLongEachTimeAndStopsAfterItsRounds) {
  server_.fault = [](const ServerQuestion&) { return Fault::failBefore; };
  options_.mostRounds = 5;
  fill(*outbox_, 1);
  const auto sent = send();
  EXPECT_EQ(sent.rounds, 5);
  EXPECT_EQ(sent.left, 1u);
  EXPECT_EQ(waits_, (std::vector<double>{1.0, 2.0, 4.0, 8.0}));
  EXPECT_NE(sent.problem.english().find("busy or fails (500 oops)"), std::string::npos) << sent.problem;
}

TEST_F(StatementSending, DoesNotAskBeforeABusyServerWantsIt) {
  goesWrong({{1, Fault::busy429}, {2, Fault::busy503}});
  fill(*outbox_, 1);
  EXPECT_EQ(send().sent, 1u);
  EXPECT_EQ(waits_, (std::vector<double>{7.0, 7.0}));
}

TEST_F(StatementSending, UnderstandsADateToWaitForByTheServersOwnClock) {
  int n = 0;
  server_.other = [&n](const ServerQuestion&) -> std::optional<ServerAnswer> {
    if (++n > 1) return std::nullopt;
    return ServerAnswer{503, "", {"Date: Thu, 26 Nov 2026 09:30:00 GMT", "Retry-After: Thu, 26 Nov 2026 09:31:30 GMT"}};
  };
  fill(*outbox_, 1);
  EXPECT_EQ(send().sent, 1u);
  EXPECT_EQ(waits_, (std::vector<double>{90.0}));
}

TEST_F(StatementSending, LeavesAServerAloneThatWantsALongRest) {
  server_.retryAfter = "86400";
  server_.fault = [](const ServerQuestion&) { return Fault::busy503; };
  fill(*outbox_, 1);
  const auto sent = send();
  EXPECT_EQ(sent.rounds, 1);
  EXPECT_NE(sent.problem.english().find("86400 s"), std::string::npos) << sent.problem;
}

TEST_F(StatementSending, AsksForWhatItLostTheAnswerOfBeforeSendingItAgain) {
  for (const Fault fault : {Fault::closeAfterTaking, Fault::halfAnswer, Fault::failAfter, Fault::answerTwice, Fault::closeBeforeTaking}) {
    const std::string series = "f" + std::to_string(static_cast<int>(fault));
    fill(*outbox_, 3, series);
    goesWrong({{1, fault}});
    EXPECT_EQ(send().left, 0u);
    for (int n = 0; n < 3; ++n) EXPECT_EQ(server_.arrivals()[idNumbered(n, series)], 1) << series;
  }
}

TEST_F(StatementSending, NothingIsSentAgainBehindOurBackOverAConnectionThatWasKept) {
  server_.keepsConnections = true;
  options_.mostTogether = 1;
  goesWrong({{2, Fault::closeAfterTaking}});
  fill(*outbox_, 3);
  EXPECT_EQ(send().sent, 3u);
  expectEachOnce(3);
  EXPECT_EQ(server_.connections(), static_cast<int>(server_.questions().size()));
}

TEST_F(StatementSending, AServerThatIsSilentIsGivenUpAndAskedAgain) {
  store_.timeout_s = 0.2;
  goesWrong({{1, Fault::silence}});
  fill(*outbox_, 2);
  EXPECT_EQ(send().sent, 2u);
  expectEachOnce(2);
}

TEST_F(StatementSending, AServerThatGoesAwayAndComesBackGetsEverything) {
  goesWrong({{2, Fault::goAway}});
  options_.mostTogether = 2;
  options_.wait = [this](double) {
    if (waits_.size() == 2) server_.comeBack();
    waits_.push_back(0.0);
    return true;
  };
  fill(*outbox_, 6);
  EXPECT_EQ(send().sent, 6u);
  EXPECT_EQ(waits_.size(), 3u);
  expectEachOnce(6);
}

TEST_F(StatementSending, OneThatIsRefusedDoesNotHoldUpTheOthersAndTheServersWordsAreKept) {
  server_.bad = {idNumbered(3)};
  fill(*outbox_, 8);
  const auto sent = send();
  EXPECT_EQ(sent.sent, 7u);
  EXPECT_EQ(sent.refused, 1u);
  EXPECT_EQ(sent.left, 0u);
  reopen();
  ASSERT_EQ(outbox_->entries().size(), 1u);
  EXPECT_EQ(outbox_->entries()[0].id, idNumbered(3));
  EXPECT_EQ(outbox_->entries()[0].problem, "400 The verb of " + idNumbered(3) + " is not known here");
  EXPECT_EQ(send().sent, 0u) << "it is not tried again by itself";
  server_.bad = std::set<std::string>();
  ASSERT_TRUE(outbox_->retryRefused());
  EXPECT_EQ(send().sent, 1u);
  expectEachOnce(8);
}

TEST_F(StatementSending, OneOverWhichTheServerFailsDoesNotHoldUpTheOthers) {
  server_.poison = {idNumbered(1)};
  options_.mostRounds = 4;
  options_.mostTogether = 3;
  fill(*outbox_, 7);
  const auto sent = send();
  EXPECT_EQ(sent.sent, 6u);
  EXPECT_EQ(sent.left, 1u);
  EXPECT_EQ(sent.refused, 0u) << "a fault of the server is no word about the statement";
}

TEST_F(StatementSending, OneThatIsThereAlreadyCountsAsArrivedWhenItSaysTheSame) {
  server_.store(statementNumbered(1));
  auto other = statementNumbered(2);
  other["result"]["score"]["scaled"] = 0.9;
  server_.store(other);
  server_.refusesWhatIsThere = true;
  fill(*outbox_, 4);
  const auto sent = send();
  EXPECT_EQ(sent.sent, 3u);
  EXPECT_EQ(sent.refused, 1u);
  expectEachOnce(4);
  ASSERT_EQ(outbox_->entries().size(), 1u);
  EXPECT_EQ(outbox_->entries()[0].id, idNumbered(2));
  EXPECT_NE(outbox_->entries()[0].problem.find("another statement with this id"), std::string::npos);
}

TEST_F(StatementSending, OneThatWasVoidedThereCountsAsArrived) {
  server_.store(statementNumbered(0));
  server_.voidStatement(idNumbered(0));
  fill(*outbox_, 1);
  server_.refusesWhatIsThere = true;
  EXPECT_EQ(send().sent, 1u);
  expectEachOnce(1);
}

TEST_F(StatementSending, WhereItMayNotReadItRepeatsAndTrustsTheServerToKnowTheId) {
  server_.mayBeRead = false;
  server_.knowsIds = true;
  goesWrong({{1, Fault::closeAfterTaking}});
  fill(*outbox_, 2);
  EXPECT_EQ(send().sent, 2u);
  expectEachOnce(2);
}

TEST_F(StatementSending, DoesNotBelieveAYesThatNamesNothing) {
  server_.namesWhatItTook = false;
  fill(*outbox_, 2);
  EXPECT_EQ(send().sent, 2u) << "it was asked, and had them";
  expectEachOnce(2);
}

TEST_F(StatementSending, APageThatWantsALoginIsNoRecordStore) {
  server_.fault = [](const ServerQuestion&) { return Fault::otherPage; };
  fill(*outbox_, 2);
  for (const std::size_t together : {50u, 1u}) {
    options_.mostTogether = together;
    const auto sent = send();
    EXPECT_EQ(sent.left, 2u);
    EXPECT_EQ(sent.rounds, 1);
    EXPECT_NE(sent.problem.english().find("does not act like a record store"), std::string::npos) << sent.problem;
  }
  server_.fault = nullptr;
  EXPECT_EQ(send().sent, 2u);
  expectEachOnce(2);
}

TEST_F(StatementSending, AWrongPasswordEndsTheCallAndIsInNoSentence) {
  server_.other = [](const ServerQuestion& question) -> std::optional<ServerAnswer> {
    return ServerAnswer{401, "no: " + question.headers.at("authorization") + " secret-word", {}};
  };
  store_.authorization = *basicAuthorization("mona", "secret-word");
  fill(*outbox_, 2);
  const auto sent = send();
  EXPECT_EQ(sent.rounds, 1);
  EXPECT_EQ(sent.left, 2u);
  const std::string said = sent.problem.english();
  EXPECT_NE(said.find("does not accept user and password"), std::string::npos) << said;
  EXPECT_EQ(said.find("secret-word"), std::string::npos) << said;
  EXPECT_EQ(said.find(store_.authorization.substr(6)), std::string::npos) << said;
}

TEST_F(StatementSending, AVeryShortPasswordDoesNotSpoilWhatTheServerSays) {
  server_.other = [](const ServerQuestion&) -> std::optional<ServerAnswer> { return ServerAnswer{401, "this is not so", {}}; };
  store_.authorization = *basicAuthorization("mona", "s");
  fill(*outbox_, 1);
  EXPECT_NE(send().problem.english().find("this is not so"), std::string::npos);
}

TEST_F(StatementSending, PasswordsAreNotSentOnToAnotherServer) {
  RecordServer elsewhere;
  server_.other = [&](const ServerQuestion&) -> std::optional<ServerAnswer> {
    return ServerAnswer{307, "", {"Location: " + elsewhere.endpoint() + "statements"}};
  };
  store_.authorization = *basicAuthorization("mona", "secret");
  fill(*outbox_, 1);
  const auto sent = send();
  EXPECT_EQ(sent.left, 1u);
  EXPECT_NE(sent.problem.english().find("sends us elsewhere"), std::string::npos) << sent.problem;
  EXPECT_TRUE(elsewhere.questions().empty());
}

TEST_F(StatementSending, AnAnswerWithoutEndIsCutOff) {
  int n = 0;
  server_.other = [&n](const ServerQuestion&) -> std::optional<ServerAnswer> {
    if (++n > 1) return std::nullopt;
    return ServerAnswer{200, std::string(9u << 20, 'x'), {}};
  };
  fill(*outbox_, 1);
  EXPECT_EQ(send().sent, 1u);
  expectEachOnce(1);
}

TEST_F(StatementSending, AnAnswerThatNestsWithoutEndIsNoMoreThanAnOddAnswer) {
  fill(*outbox_, 2);
  std::string deep;
  for (int n = 0; n < 150'000; ++n) deep += R"({"message":)";
  for (const int status : {200, 400, 401, 503}) {
    server_.other = [&](const ServerQuestion&) { return ServerAnswer{status, deep, {}}; };
    options_.mostRounds = 1;
    static_cast<void>(send());
    ASSERT_TRUE(outbox_->retryRefused());
    EXPECT_FALSE(askRecordStore(store_)) << status;
  }
  server_.other = nullptr;
  EXPECT_EQ(send().sent, 2u);
  expectEachOnce(2);
}

TEST_F(StatementSending, ANoteOfARefusalThatCannotBeReadHoldsNothingUp) {
  fill(*outbox_, 2);
  writeText(folder_ / "o" / (idNumbered(0) + ".refused"), std::string(70'000, 'x'));
  reopen();
  EXPECT_EQ(outbox_->count(OutboxStatus::refused), 1u);
  EXPECT_EQ(send().sent, 1u);
}

TEST_F(StatementSending, WhereTheReceiptCannotBeWrittenNothingIsSentTwiceAfterwards) {
  fill(*outbox_, 4);
  const std::filesystem::path notes = folder_ / "o/notes", aside = folder_ / "aside";
  server_.other = [&](const ServerQuestion&) -> std::optional<ServerAnswer> {
    std::filesystem::rename(notes, aside);
    std::filesystem::create_directory(notes);
    return std::nullopt;
  };
  const auto sent = sendStatements(*outbox_, store_, options_);
  server_.other = nullptr;
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().code, ErrorCode::notWritable);
  std::filesystem::remove(notes);
  std::filesystem::rename(aside, notes);
  reopen();
  EXPECT_EQ(outbox_->entries().size(), 4u);
  EXPECT_EQ(outbox_->count(OutboxStatus::doubtful), 4u);
  EXPECT_EQ(send().sent, 4u);
  expectEachOnce(4);
}

TEST_F(StatementSending, ADoubtfulOneWhoseFileIsLostIsNotCalledAnother) {
  fill(*outbox_, 1);
  ASSERT_TRUE(outbox_->announce({idNumbered(0)}));
  std::filesystem::remove(outbox_->copyOf(outbox_->entries()[0]));
  server_.store(statementNumbered(0));
  reopen();
  EXPECT_EQ(send().refused, 1u);
  ASSERT_EQ(outbox_->entries().size(), 1u);
  EXPECT_EQ(outbox_->entries()[0].problem.find("another statement"), std::string::npos) << outbox_->entries()[0].problem;
  EXPECT_NE(outbox_->entries()[0].problem.find(idNumbered(0)), std::string::npos) << outbox_->entries()[0].problem;
}

TEST_F(StatementSending, ADamagedFileIsRefusedAndTheOthersGo) {
  fill(*outbox_, 3);
  for (const auto& each : std::filesystem::directory_iterator(folder_ / "o"))
    if (each.path().string().find(idNumbered(1)) != std::string::npos) writeText(each.path(), "{\"id\": ");
  const auto sent = send();
  EXPECT_EQ(sent.sent, 2u);
  EXPECT_EQ(sent.refused, 1u);
}

class CancelLater final : public Progress {
 public:
  explicit CancelLater(double seconds)
      : at_(steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(std::chrono::duration<double>(seconds))) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return steady_clock::now() >= at_; }

 private:
  steady_clock::time_point at_;
};

TEST_F(StatementSending, CanBeStoppedWhileTheServerIsSilentAndWhileItWaits) {
  fill(*outbox_, 1);
  server_.fault = [](const ServerQuestion&) { return Fault::silence; };
  CancelLater silent(0.1);
  auto begun = steady_clock::now();
  const auto stopped = sendStatements(*outbox_, store_, options_, silent);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
  // The silence would last 20 s; half a second is what is promised on a machine that does nothing else.
  EXPECT_LT(steady_clock::now() - begun, std::chrono::seconds(10));
  server_.fault = [](const ServerQuestion&) { return Fault::failBefore; };
  options_.wait = {};
  options_.firstWait_s = 30.0;
  CancelLater waiting(0.1);
  begun = steady_clock::now();
  EXPECT_EQ(sendStatements(*outbox_, store_, options_, waiting).error().code, ErrorCode::cancelled);
  EXPECT_LT(steady_clock::now() - begun, std::chrono::seconds(15));
  EXPECT_EQ(outbox_->entries().size(), 1u);
}

TEST_F(StatementSending, GoesOnWhereAStoppedCallEnded) {
  fill(*outbox_, 2);
  server_.fault = [](const ServerQuestion& question) { return question.writes() ? Fault::closeAfterTaking : Fault::failBefore; };
  options_.mostRounds = 1;
  EXPECT_EQ(send().left, 2u);
  reopen();
  EXPECT_EQ(outbox_->count(OutboxStatus::doubtful), 2u);
  server_.fault = nullptr;
  EXPECT_EQ(send().sent, 2u);
  expectEachOnce(2);
}

TEST_F(StatementSending, HttpIsForThisMachineAloneUnlessItIsAllowed) {
  store_.endpoint = "http://records.example/xapi";
  const auto sent = sendStatements(*outbox_, store_, options_);
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().code, ErrorCode::badField);
  EXPECT_NE(sent.error().sentence().find("use https"), std::string::npos);
  for (const char* address :
       {"", "records.example", "ftp://records.example/", "https://mona:secret@records.example/", "https://records.example/?a=b",
        "https://records.example/#a", "https://records example/", "file:///etc/passwd"}) {
    store_.endpoint = address;
    const auto refused = sendStatements(*outbox_, store_, options_);
    ASSERT_FALSE(refused) << address;
    EXPECT_EQ(refused.error().code, ErrorCode::badField);
    EXPECT_EQ(refused.error().sentence().find("secret"), std::string::npos);
  }
}

TEST_F(StatementSending, SaysWhetherARecordStoreLetsUsIn) {
  EXPECT_TRUE(askRecordStore(store_));
  server_.authorization = "Basic eDp5";
  const auto no = askRecordStore(store_);
  ASSERT_FALSE(no);
  EXPECT_NE(no.error().sentence().find("does not accept user and password (401)"), std::string::npos) << no.error();
  store_.endpoint = "http://127.0.0.1:" + std::to_string(server_.port()) + "/elsewhere/";
  store_.authorization = "Basic eDp5";
  EXPECT_NE(askRecordStore(store_).error().sentence().find("404"), std::string::npos);
  server_.goAway();
  EXPECT_FALSE(askRecordStore(store_));
}

}  // namespace
}  // namespace ew::test::statement_sending_test
