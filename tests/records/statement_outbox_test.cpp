#include "ew/records/statement_outbox.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "library/temporary_folder.h"
#include "records/record_world.h"

namespace ew::test::statement_outbox_test {
namespace {

namespace fs = std::filesystem;

StatementOutbox opened(const fs::path& folder) {
  auto outbox = StatementOutbox::open(folder);
  EXPECT_TRUE(outbox) << outbox.error();
  return std::move(*outbox);
}

int filesIn(const fs::path& folder) {
  int count = 0;
  for (const auto& each : fs::directory_iterator(folder)) count += each.path().extension() == ".json" ? 1 : 0;
  return count;
}

TEST(StatementOutbox, KeepsWhatItWasGivenInTheOrderItWasGiven) {
  const TemporaryFolder folder;
  {
    StatementOutbox outbox = opened(folder / "o");
    fill(outbox, 12);
  }
  const StatementOutbox again = opened(folder / "o");
  ASSERT_EQ(again.entries().size(), 12u);
  for (int n = 0; n < 12; ++n) {
    EXPECT_EQ(again.entries()[static_cast<std::size_t>(n)].id, idNumbered(n));
    EXPECT_EQ(nlohmann::json::parse(*again.textOf(idNumbered(n))), statementNumbered(n));
  }
}

TEST(StatementOutbox, DoesNotTakeAnIdTwiceNeitherWhileItWaitsNorAfterItWasSent) {
  const TemporaryFolder folder;
  StatementOutbox outbox = opened(folder / "o");
  EXPECT_EQ(outbox.add(statementNumbered(1)), true);
  auto other = statementNumbered(1);
  other["result"]["success"] = false;
  EXPECT_EQ(outbox.add(other), false);
  EXPECT_EQ(nlohmann::json::parse(*outbox.textOf(idNumbered(1))), statementNumbered(1)) << "the first word stands";
  ASSERT_TRUE(outbox.keepSent({idNumbered(1)}));
  EXPECT_EQ(outbox.add(statementNumbered(1)), false);
  auto shouted = statementNumbered(1);
  for (char& letter : shouted["id"].get_ref<std::string&>()) letter = static_cast<char>(std::toupper(letter));
  EXPECT_EQ(outbox.add(shouted), false) << "an id is the same in capitals";
  EXPECT_EQ(filesIn(folder / "o"), 0);
}

TEST(StatementOutbox, RemembersWhatWasSentInTheNextRun) {
  const TemporaryFolder folder;
  {
    StatementOutbox outbox = opened(folder / "o");
    fill(outbox, 3);
    ASSERT_TRUE(outbox.keepSent({idNumbered(0), idNumbered(2)}));
  }
  StatementOutbox again = opened(folder / "o");
  EXPECT_EQ(again.count(OutboxStatus::arrived), 2u);
  ASSERT_EQ(again.entries().size(), 1u);
  EXPECT_EQ(again.add(statementNumbered(0)), false);
}

TEST(StatementOutbox, OvercomesALineOfSentThatACrashCutOff) {
  const TemporaryFolder folder;
  {
    StatementOutbox outbox = opened(folder / "o");
    fill(outbox, 3);
    ASSERT_TRUE(outbox.keepSent({idNumbered(0)}));
  }
  const std::string whole = textOf(folder / "o/notes");
  std::ofstream(folder / "o/notes", std::ios::app) << "{\"id\":\"" + idNumbered(1).substr(0, 20);
  StatementOutbox again = opened(folder / "o");
  EXPECT_EQ(again.count(OutboxStatus::arrived), 1u);
  EXPECT_EQ(again.entries().size(), 2u) << "what is not known to have arrived is still here";
  ASSERT_TRUE(again.keepSent({idNumbered(1), idNumbered(2)}));
  const auto line = [](int n) { return "{\"id\":\"" + idNumbered(n) + "\",\"status\":\"arrived\"}\n"; };
  EXPECT_EQ(textOf(folder / "o/notes"), whole + line(1) + line(2));
}

TEST(StatementOutbox, RemovesWhatACrashLeftBetweenTheLineAndTheRemoval) {
  const TemporaryFolder folder;
  std::string text, name;
  {
    StatementOutbox outbox = opened(folder / "o");
    fill(outbox, 1);
    for (const auto& each : fs::directory_iterator(folder / "o"))
      if (each.path().extension() == ".json") name = each.path().string();
    text = textOf(name);
    ASSERT_TRUE(outbox.keepSent({idNumbered(0)}));
  }
  writeText(name, text);
  EXPECT_TRUE(opened(folder / "o").entries().empty());
  EXPECT_EQ(filesIn(folder / "o"), 0);
}

TEST(StatementOutbox, OfAnEarlierVersionGoesOnWhereItStood) {
  const TemporaryFolder folder;
  const auto copyNumbered = [&](int n) { return folder / ("o/000000000" + std::to_string(n) + "-" + idNumbered(n) + ".json"); };
  for (int n = 1; n <= 5; ++n) writeText(copyNumbered(n), statementNumbered(n).dump());
  writeText(folder / "o/sent", idNumbered(0) + "\n" + idNumbered(1) + "\n" + idNumbered(4).substr(0, 20));  // cut off by a crash
  writeText(folder / "o/sending", idNumbered(1) + "\n" + idNumbered(2) + "\n");
  writeText(folder / ("o/" + idNumbered(3) + ".refused"), "400 The verb\nis not known here.\n");
  for (int runs = 0; runs < 2; ++runs) {
    StatementOutbox outbox = opened(folder / "o");
    EXPECT_EQ(outbox.count(OutboxStatus::arrived), 2u);
    EXPECT_EQ(outbox.add(statementNumbered(0)), false);
    ASSERT_EQ(outbox.entries().size(), 4u);
    EXPECT_EQ(outbox.entries()[0], (OutboxEntry{.id = idNumbered(2), .status = OutboxStatus::doubtful}));
    EXPECT_EQ(outbox.entries()[1],
              (OutboxEntry{.id = idNumbered(3), .status = OutboxStatus::refused, .problem = "400 The verb is not known here"}));
    EXPECT_EQ(outbox.entries()[2], OutboxEntry{.id = idNumbered(4)});
    EXPECT_EQ(outbox.entries()[3], OutboxEntry{.id = idNumbered(5)});
    EXPECT_EQ(outbox.textOf(idNumbered(5)), statementNumbered(5).dump());
    EXPECT_FALSE(fs::exists(copyNumbered(1))) << "stopped between the line and the removal";
    for (const std::string& name : {std::string("sent"), std::string("sending"), idNumbered(3) + ".refused"})
      EXPECT_FALSE(fs::exists(folder / "o" / name)) << name;
  }
}

TEST(StatementOutbox, OfAnEarlierVersionThatWasTakenOverInPartKnowsWhatArrived) {
  const TemporaryFolder folder;
  writeText(folder / "o/sent", idNumbered(1) + "\n");
  writeText(folder / "o/sending", idNumbered(1) + "\n");
  { ASSERT_TRUE(opened(folder / "o").entries().empty()); }
  writeText(folder / "o/sending", idNumbered(1) + "\n");  // stopped between the removal of one list and of the other
  const StatementOutbox outbox = opened(folder / "o");
  EXPECT_TRUE(outbox.entries().empty()) << "nobody has to be asked for it";
  EXPECT_EQ(outbox.count(OutboxStatus::arrived), 1u);
}

TEST(StatementOutbox, KnowsAfterACrashWhatWasBeingSent) {
  const TemporaryFolder folder;
  {
    StatementOutbox outbox = opened(folder / "o");
    fill(outbox, 3);
    ASSERT_TRUE(outbox.announce({idNumbered(1)}));
  }
  StatementOutbox again = opened(folder / "o");
  EXPECT_EQ(again.count(OutboxStatus::doubtful), 1u);
  EXPECT_EQ(again.entries()[1].status, OutboxStatus::doubtful);
  again.withdraw({idNumbered(1)});
  EXPECT_EQ(again.count(OutboxStatus::waiting), 3u);
}

TEST(StatementOutbox, KeepsWhyOneWasRefusedUntilItIsTriedAgain) {
  const TemporaryFolder folder;
  {
    StatementOutbox outbox = opened(folder / "o");
    fill(outbox, 2);
    ASSERT_TRUE(outbox.keepRefused(idNumbered(0), "400 The verb\nis not known here."));
  }
  StatementOutbox again = opened(folder / "o");
  EXPECT_EQ(again.entries()[0].status, OutboxStatus::refused);
  EXPECT_EQ(again.entries()[0].problem, "400 The verb is not known here");
  ASSERT_TRUE(again.retryRefused());
  EXPECT_EQ(again.count(OutboxStatus::waiting), 2u);
}

TEST(StatementOutbox, IsOneProgramsAtATimeAndOnlyItsOwnersToRead) {
  const TemporaryFolder folder;
  const StatementOutbox outbox = opened(folder / "o");
  const auto second = StatementOutbox::open(folder / "o");
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::notWritable);
  EXPECT_NE(second.error().sentence().find("wait until it has finished"), std::string::npos) << second.error();
  struct stat found {};
  ASSERT_EQ(::stat((folder / "o").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777, 0700u);
}

TEST(StatementOutbox, RefusesWhatIsNoStatement) {
  const TemporaryFolder folder;
  StatementOutbox outbox = opened(folder / "o");
  for (const char* part : {"id", "actor", "verb", "object"}) {
    auto broken = statementNumbered(1);
    broken.erase(part);
    const auto added = outbox.add(broken);
    ASSERT_FALSE(added) << part;
    EXPECT_NE(added.error().sentence().find(std::string("'") + part + "'"), std::string::npos) << added.error();
  }
  auto odd = statementNumbered(1);
  odd["id"] = "../../etc/passwd";
  EXPECT_FALSE(outbox.add(odd));
  odd = statementNumbered(1);
  odd["object"]["id"] = "\xff\xfe";
  EXPECT_FALSE(outbox.add(odd));
  odd = statementNumbered(1);
  odd["object"]["id"] = std::string(1 << 20, 'x');
  EXPECT_EQ(outbox.add(odd).error().code, ErrorCode::tooLarge);
  EXPECT_FALSE(outbox.add(nlohmann::json::array()));
  EXPECT_EQ(filesIn(folder / "o"), 0);
}

}  // namespace
}  // namespace ew::test::statement_outbox_test
