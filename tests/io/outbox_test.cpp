#include "ew/io/outbox.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <ostream>

#include "library/temporary_folder.h"

namespace ew::io_outbox_test {
namespace {

namespace fs = std::filesystem;
using test::textOf;
using test::writeText;

bool isLetters(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char letter) { return letter >= 'a' && letter <= 'z'; });
}

const OutboxKind kInOrder{.ending = ".txt", .isNumbered = true, .isId = isLetters};
const OutboxKind kTold{.ending = ".txt", .isId = isLetters, .entryOf = [](const fs::path& copy) -> Result<OutboxEntry> {
                         const std::string text = textOf(copy);
                         if (text.empty()) return failure(ErrorCode::badHeader, verbatim(copy.filename().string() + " is empty."));
                         return OutboxEntry{.id = copy.stem().string(), .about = {{"text", text}}};
                       }};

Outbox opened(const fs::path& folder, const OutboxKind& kind = kInOrder) {
  auto outbox = Outbox::open(folder, kind);
  EXPECT_TRUE(outbox) << outbox.error();
  return std::move(*outbox);
}

Result<bool> put(Outbox& outbox, const std::string& id, const std::string& text = "something") {
  return outbox.add({.id = id}, [&](std::ostream& out) -> Result<void> {
    out << text;
    return {};
  });
}

std::vector<std::string> idsOf(const Outbox& outbox) {
  std::vector<std::string> ids;
  for (const OutboxEntry& entry : outbox.entries()) ids.push_back(entry.id);
  return ids;
}

std::size_t linesIn(const fs::path& file) {
  const std::string text = textOf(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

using Ids = std::vector<std::string>;

TEST(OneOutbox, KeepsWhatItIsGivenOnceAndInItsOrder) {
  const test::TemporaryFolder folder;
  {
    Outbox outbox = opened(folder / "o");
    for (const char* id : {"pear", "apple", "fig"}) EXPECT_EQ(put(outbox, id, std::string("a ") + id), true);
    EXPECT_EQ(put(outbox, "fig", "another"), false);
  }
  Outbox again = opened(folder / "o");
  EXPECT_EQ(idsOf(again), (Ids{"pear", "apple", "fig"}));
  EXPECT_EQ(textOf(again.copyOf(*again.find("fig"))), "a fig") << "the first word stands";
  EXPECT_EQ(put(again, "fig"), false);
  EXPECT_EQ(put(again, "date"), true);
  EXPECT_EQ(idsOf(opened(folder / "other", kTold)), Ids{});
  EXPECT_EQ(again.count(OutboxStatus::waiting), 4u);
}

TEST(OneOutbox, WithoutNumbersIsInTheOrderOfTheIds) {
  const test::TemporaryFolder folder;
  Outbox outbox = opened(folder / "o", kTold);
  for (const char* id : {"pear", "apple", "fig"}) ASSERT_TRUE(put(outbox, id));
  EXPECT_EQ(idsOf(outbox), (Ids{"apple", "fig", "pear"}));
  EXPECT_EQ(outbox.find("pear")->id, "pear");
}

TEST(OneOutbox, RemembersWhereEachStandsAndWhatArrived) {
  const test::TemporaryFolder folder;
  OutboxEntry refused;
  {
    Outbox outbox = opened(folder / "o");
    for (const char* id : {"a", "b", "c", "d"}) ASSERT_TRUE(put(outbox, id));
    refused = *outbox.find("b");
    refused.status = OutboxStatus::refused;
    refused.attempts = 3;
    refused.problem = "no \xff room";
    ASSERT_TRUE(outbox.keep(refused));
    ASSERT_TRUE(outbox.keep({"a", "c"}, OutboxStatus::doubtful));
    const fs::path copy = outbox.copyOf(*outbox.find("a"));
    ASSERT_TRUE(outbox.keep(Ids{"a"}, OutboxStatus::arrived));
    EXPECT_FALSE(fs::exists(copy));
  }
  Outbox again = opened(folder / "o");
  EXPECT_EQ(idsOf(again), (Ids{"b", "c", "d"}));
  EXPECT_EQ(again.count(OutboxStatus::arrived), 1u);
  EXPECT_TRUE(again.knows("a"));
  EXPECT_EQ(put(again, "a"), false) << "sent before";
  EXPECT_EQ(again.find("a"), nullptr);
  EXPECT_EQ(again.find("b")->status, OutboxStatus::refused);
  EXPECT_EQ(again.find("b")->attempts, 3);
  EXPECT_EQ(again.find("b")->problem, "no \xEF\xBF\xBD room") << "what is no UTF-8 is marked";
  EXPECT_EQ(again.find("c")->status, OutboxStatus::doubtful);
  ASSERT_TRUE(again.retryRefused());
  EXPECT_EQ(again.find("b")->status, OutboxStatus::waiting);
  EXPECT_EQ(again.find("b")->problem, "");
}

TEST(OneOutbox, ALineThatACrashCutOffDoesNotCount) {
  const test::TemporaryFolder folder;
  {
    Outbox outbox = opened(folder / "o");
    for (const char* id : {"a", "b"}) ASSERT_TRUE(put(outbox, id));
    ASSERT_TRUE(outbox.keep(Ids{"a"}, OutboxStatus::arrived));
  }
  const std::string whole = textOf(folder / "o/notes");
  std::ofstream(folder / "o/notes", std::ios::app) << R"({"id":"b","status":"arr)";
  {
    Outbox outbox = opened(folder / "o");
    EXPECT_EQ(idsOf(outbox), Ids{"b"}) << "what is not known to have arrived is still here";
    ASSERT_TRUE(outbox.keep(Ids{"b"}, OutboxStatus::arrived));
  }
  EXPECT_EQ(textOf(folder / "o/notes"), whole + "{\"id\":\"b\",\"status\":\"arrived\"}\n");
  EXPECT_EQ(opened(folder / "o").count(OutboxStatus::arrived), 2u);
}

TEST(OneOutbox, GoesOnWhereItStoppedBetweenACopyAndItsNote) {
  const test::TemporaryFolder folder;
  fs::path copy;
  {
    Outbox outbox = opened(folder / "o", kTold);
    ASSERT_TRUE(put(outbox, "a"));
    copy = outbox.copyOf(outbox.entries().front());
    ASSERT_TRUE(outbox.keep(Ids{"a"}, OutboxStatus::verified));
    EXPECT_FALSE(fs::exists(copy));
  }
  writeText(copy, "stopped between the note and the removal");
  writeText(folder / "o/b.txt", "stopped before the note");
  writeText(folder / "o/c.txt", "");
  writeText(folder / "o/NOT-AN-ID.txt", "somebody else's");
  const Outbox outbox = opened(folder / "o", kTold);
  EXPECT_FALSE(fs::exists(copy));
  EXPECT_EQ(idsOf(outbox), (Ids{"a", "b"}));
  EXPECT_EQ(outbox.count(OutboxStatus::verified), 1u);
  EXPECT_EQ(aboutOf(*outbox.find("b"), "text"), "stopped before the note");
  EXPECT_EQ(aboutOf(*outbox.find("b"), "title"), "");
  ASSERT_EQ(outbox.unreadable().size(), 1u);
  EXPECT_EQ(outbox.unreadable().front().sentence(), "c.txt is empty.");
  EXPECT_TRUE(fs::exists(folder / "o/NOT-AN-ID.txt"));
}

TEST(OneOutbox, ACopyUnderTheNameOfAnotherIsNamedAndNotTakenTwice) {
  const test::TemporaryFolder folder;
  OutboxKind kind = kTold;
  kind.entryOf = [](const fs::path&) -> Result<OutboxEntry> { return OutboxEntry{.id = "a"}; };
  writeText(folder / "o/a.txt", "a");
  writeText(folder / "o/b.txt", "a");
  const Outbox outbox = opened(folder / "o", kind);
  EXPECT_EQ(idsOf(outbox), Ids{"a"});
  ASSERT_EQ(outbox.unreadable().size(), 1u);
  EXPECT_NE(outbox.unreadable().front().sentence().find("b.txt"), std::string::npos) << outbox.unreadable().front();
  EXPECT_TRUE(fs::exists(folder / "o/b.txt"));
}

TEST(OneOutbox, NotesDoNotGrowWithoutEnd) {
  const test::TemporaryFolder folder;
  {
    Outbox outbox = opened(folder / "o");
    for (const char* id : {"a", "b"}) ASSERT_TRUE(put(outbox, id));
    ASSERT_TRUE(outbox.keep(Ids{"a"}, OutboxStatus::arrived));
    for (int n = 0; n < 100; ++n) {
      ASSERT_TRUE(outbox.keep(Ids{"b"}, OutboxStatus::doubtful));
      ASSERT_TRUE(outbox.keep(Ids{"b"}, OutboxStatus::waiting));
    }
  }
  EXPECT_EQ(linesIn(folder / "o/notes"), 202u);
  Outbox outbox = opened(folder / "o");
  EXPECT_EQ(linesIn(folder / "o/notes"), 3u) << "its head, and one each";
  EXPECT_TRUE(outbox.knows("a"));
  ASSERT_TRUE(outbox.keep(Ids{"b"}, OutboxStatus::doubtful));
  EXPECT_EQ(linesIn(folder / "o/notes"), 4u);
}

TEST(OneOutbox, NotesOfANewerVersionAreLeftToIt) {
  const test::TemporaryFolder folder;
  writeText(folder / "o/notes", "{\"format\":2}\n");
  const auto outbox = Outbox::open(folder / "o", kInOrder);
  ASSERT_FALSE(outbox);
  EXPECT_EQ(outbox.error().code, ErrorCode::newerFormat);
  EXPECT_EQ(textOf(folder / "o/notes"), "{\"format\":2}\n");
}

TEST(OneOutbox, AFileOfSomebodyElseThatIsCalledNotesIsLeftAlone) {
  const test::TemporaryFolder folder;
  constexpr auto kForAll = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read;
  for (const char* text : {"buy gel\ncall the archive\n", "no line at all", "{\"format\":0}\n"}) {
    writeText(folder / "o/notes", text);
    fs::permissions(folder / "o/notes", kForAll);
    const auto outbox = Outbox::open(folder / "o", kInOrder);
    ASSERT_FALSE(outbox) << text;
    EXPECT_EQ(outbox.error().code, ErrorCode::notReadable);
    EXPECT_NE(outbox.error().sentence().find("move it away"), std::string::npos) << outbox.error();
    EXPECT_EQ(textOf(folder / "o/notes"), text);
    EXPECT_EQ(fs::status(folder / "o/notes").permissions(), kForAll);
  }
  writeText(folder / "o/notes", "");
  Outbox outbox = opened(folder / "o");
  ASSERT_TRUE(put(outbox, "a"));
}

TEST(OneOutbox, ThatCannotBeListedIsNotTakenForAnEmptyOne) {
  if (::geteuid() == 0) GTEST_SKIP() << "root lists every folder";
  const test::TemporaryFolder folder;
  { ASSERT_TRUE(opened(folder / "o", kTold).entries().empty()); }
  fs::permissions(folder / "o", fs::perms::owner_write | fs::perms::owner_exec);
  const auto outbox = Outbox::open(folder / "o", kTold);
  fs::permissions(folder / "o", fs::perms::owner_all);
  ASSERT_FALSE(outbox);
  EXPECT_EQ(outbox.error().code, ErrorCode::notWritable);
}

TEST(OneOutbox, LinesThatSayNothingHoldNothingUp) {
  const test::TemporaryFolder folder;
  writeText(folder / "o/0000000007-a.txt", "a");
  writeText(folder / "o/notes",
            "{\"format\":1}\n[[[\n{\"id\":7,\"status\":\"arrived\"}\n{\"id\":\"a\",\"status\":\"gone\"}\n"
            "{\"id\":\"../b\",\"status\":\"arrived\"}\n{\"id\":\"a\",\"status\":\"stored\",\"about\":[1],\"attempts\":-4}\n");
  Outbox outbox = opened(folder / "o");
  ASSERT_EQ(idsOf(outbox), Ids{"a"});
  EXPECT_EQ(outbox.entries().front(), (OutboxEntry{.id = "a", .status = OutboxStatus::stored}));
  ASSERT_TRUE(put(outbox, "b"));
  EXPECT_TRUE(fs::exists(folder / "o/0000000008-b.txt"));
}

TEST(OneOutbox, SaysOnceThatNotesAreDamagedAndKeepsTheirLines) {
  const test::TemporaryFolder folder;
  {
    Outbox outbox = opened(folder / "o");
    for (const char* id : {"a", "b", "c"}) ASSERT_TRUE(put(outbox, id));
    ASSERT_TRUE(outbox.keep(Ids{"a"}, OutboxStatus::arrived));
    ASSERT_TRUE(outbox.keep(Ids{"b"}, OutboxStatus::doubtful));
    EXPECT_EQ(outbox.damage(), std::nullopt);
  }
  const std::string damaged = "{\"id\":\"c\",\"sta\x01us\":\"arrived\"}\n\xff\xfe\n";
  std::ofstream(folder / "o/notes", std::ios::app) << damaged << "{\"id\":\"b\",\"status\":\"stored\"}\n";
  const auto isAllThere = [](const Outbox& outbox) {
    EXPECT_EQ(idsOf(outbox), (Ids{"b", "c"}));
    EXPECT_EQ(outbox.find("b")->status, OutboxStatus::stored);
    EXPECT_EQ(outbox.find("c")->status, OutboxStatus::waiting);
    EXPECT_TRUE(outbox.knows("a"));
  };
  {
    const Outbox outbox = opened(folder / "o");
    isAllThere(outbox);
    ASSERT_TRUE(outbox.damage());
    const std::string said = outbox.damage()->english();
    EXPECT_NE(said.find("(2)"), std::string::npos) << said;
    EXPECT_NE(said.find((folder / "o/notes-damaged").string()), std::string::npos) << said;
    EXPECT_TRUE(outbox.unreadable().empty());
  }
  EXPECT_EQ(textOf(folder / "o/notes-damaged"), damaged);
  const Outbox again = opened(folder / "o");
  isAllThere(again);
  EXPECT_EQ(again.damage(), std::nullopt) << "once is enough";
}

TEST(OneOutbox, LinesThatCannotBeMovedStayAndAreToldOfAgain) {
  const test::TemporaryFolder folder;
  const std::string notes = "{\"format\":1}\n[[[\n{\"id\":\"a\",\"status\":\"arrived\"}\n";
  writeText(folder / "o/notes", notes);
  fs::create_directories(folder / "o/notes-damaged/in the way");
  for (int time = 0; time < 2; ++time) {
    const Outbox outbox = opened(folder / "o");
    ASSERT_TRUE(outbox.damage());
    EXPECT_NE(outbox.damage()->english().find("cannot be moved"), std::string::npos);
    EXPECT_TRUE(outbox.knows("a"));
  }
  EXPECT_EQ(textOf(folder / "o/notes"), notes);
}

TEST(OneOutbox, WhatWasRefusedAndDeletedByHandIsGivenUp) {
  const test::TemporaryFolder folder;
  {
    Outbox outbox = opened(folder / "o");
    for (const char* id : {"a", "b", "c"}) ASSERT_TRUE(put(outbox, id));
    ASSERT_TRUE(outbox.keep(Ids{"a", "b"}, OutboxStatus::refused));
  }
  ASSERT_TRUE(fs::remove(folder / "o/0000000001-a.txt"));
  ASSERT_TRUE(fs::remove(folder / "o/0000000003-c.txt"));
  {
    Outbox outbox = opened(folder / "o");
    EXPECT_EQ(idsOf(outbox), Ids{"b"}) << "without a note and a copy nobody knows of c";
    EXPECT_EQ(outbox.count(OutboxStatus::refused), 1u);
    EXPECT_FALSE(outbox.knows("a"));
    ASSERT_TRUE(put(outbox, "a", "corrected"));
  }
  const Outbox again = opened(folder / "o");
  EXPECT_EQ(idsOf(again), (Ids{"b", "a"}));
  EXPECT_EQ(textOf(again.copyOf(*again.find("a"))), "corrected");
}

TEST(OneOutbox, ACopyThatIsMissingOfWhatWasNotRefusedIsStillToldOf) {
  const test::TemporaryFolder folder;
  {
    Outbox outbox = opened(folder / "o");
    for (const char* id : {"a", "b"}) ASSERT_TRUE(put(outbox, id));
    ASSERT_TRUE(outbox.keep(Ids{"a"}, OutboxStatus::doubtful));
  }
  ASSERT_TRUE(fs::remove(folder / "o/0000000001-a.txt"));
  const Outbox outbox = opened(folder / "o");
  ASSERT_NE(outbox.find("a"), nullptr);
  EXPECT_EQ(outbox.find("a")->status, OutboxStatus::doubtful);
}

TEST(OneOutbox, WhatEarlierVersionsNotedIsTakenOverOnce) {
  const test::TemporaryFolder folder;
  OutboxKind kind = kInOrder;
  kind.earlierNotes = [](const fs::path& at) -> Result<EarlierNotes> {
    EarlierNotes earlier;
    if (!fs::exists(at / "before")) return earlier;
    earlier.entries = {{.id = "a", .status = OutboxStatus::arrived}, {.id = "b", .status = OutboxStatus::refused, .problem = "why"}};
    earlier.unreadable.emplace("c", Error{ErrorCode::badField, verbatim("c.note says nothing."), {}});
    earlier.files = {at / "before"};
    return earlier;
  };
  for (const char* name : {"0000000001-a.txt", "0000000002-b.txt", "0000000003-c.txt"}) writeText(folder / "o" / name, "x");
  writeText(folder / "o/before", "");
  {
    Outbox outbox = opened(folder / "o", kind);
    EXPECT_EQ(idsOf(outbox), Ids{"b"});
    EXPECT_EQ(outbox.unreadable().size(), 1u);
    const auto refused = put(outbox, "c");
    ASSERT_FALSE(refused) << "whether it was sent nobody knows";
    EXPECT_EQ(refused.error().sentence(), "c.note says nothing.");
    EXPECT_FALSE(fs::exists(folder / "o/before"));
    EXPECT_FALSE(fs::exists(folder / "o/0000000001-a.txt"));
    EXPECT_TRUE(fs::exists(folder / "o/0000000003-c.txt"));
  }
  const Outbox again = opened(folder / "o", kind);
  EXPECT_TRUE(again.knows("a"));
  EXPECT_EQ(again.find("b")->problem, "why");
}

TEST(OneOutbox, WhatArrivedStaysSoWhateverAnEarlierVersionSays) {
  const test::TemporaryFolder folder;
  OutboxKind kind = kInOrder;
  kind.earlierNotes = [](const fs::path&) -> Result<EarlierNotes> {
    EarlierNotes earlier;
    earlier.entries = {{.id = "a", .status = OutboxStatus::doubtful}};
    return earlier;
  };
  writeText(folder / "o/notes", "{\"format\":1}\n{\"id\":\"a\",\"status\":\"arrived\"}\n");
  for (int runs = 0; runs < 2; ++runs) {
    const Outbox outbox = opened(folder / "o", kind);
    EXPECT_EQ(idsOf(outbox), Ids{});
    EXPECT_EQ(outbox.count(OutboxStatus::arrived), 1u);
  }
}

TEST(OneOutbox, WhereItCannotBeNotedNothingChanges) {
  const test::TemporaryFolder folder;
  Outbox outbox = opened(folder / "o");
  ASSERT_TRUE(put(outbox, "a"));
  ASSERT_TRUE(outbox.keep(Ids{"a"}, OutboxStatus::doubtful));
  fs::rename(folder / "o/notes", folder / "notes");
  fs::create_directory(folder / "o/notes");
  const auto kept = outbox.keep(Ids{"a"}, OutboxStatus::arrived);
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, ErrorCode::notWritable);
  EXPECT_EQ(outbox.find("a")->status, OutboxStatus::doubtful);
  EXPECT_TRUE(fs::exists(outbox.copyOf(*outbox.find("a"))));
}

TEST(OneOutbox, BelongsToOneProgramAtATimeAndToItsOwner) {
  const test::TemporaryFolder folder;
  Outbox outbox = opened(folder / "o");
  ASSERT_TRUE(put(outbox, "a"));
  ASSERT_TRUE(outbox.keep(Ids{"a"}, OutboxStatus::doubtful));
  const auto second = Outbox::open(folder / "o", kInOrder);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::notWritable);
  EXPECT_EQ(fs::status(folder / "o").permissions(), fs::perms::owner_all);
  int files = 0;
  for (const auto& each : fs::directory_iterator(folder / "o")) {
    ++files;
    EXPECT_EQ(each.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << each.path();
  }
  EXPECT_EQ(files, 3) << "the lock, a copy and the notes";
}

TEST(RetryOptions, WaitTwiceAsLongEachTimeUpToTheLongest) {
  RetryOptions options;
  options.longestWait_s = 3.0;
  EXPECT_EQ(options.waitAfter_s(1), 1.0);
  EXPECT_EQ(options.waitAfter_s(2), 2.0);
  EXPECT_EQ(options.waitAfter_s(3), 3.0);
  EXPECT_EQ(options.waitAfter_s(1000), 3.0);
  options.wait = [](double seconds) { return seconds < 2.0; };
  EXPECT_TRUE(options.waitFor(1.0, noProgress()));
  EXPECT_FALSE(options.waitFor(2.0, noProgress()));
}

}  // namespace
}  // namespace ew::io_outbox_test
