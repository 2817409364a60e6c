#include "ew/assessment/standings.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "ew/library/instructor_log.h"
#include "library/temporary_folder.h"

namespace ew::standings_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

TEST(Standings, AreKeptAndReadBack) {
  const TemporaryFolder library;
  const auto none = readStandings(library.path());
  ASSERT_TRUE(none) << none.error();
  EXPECT_TRUE(none->empty());
  ASSERT_TRUE(keepStanding(library.path(), "a", Standing::shouldPass));
  const auto kept = keepStanding(library.path(), "b", Standing::shouldFail);
  ASSERT_TRUE(kept) << kept.error();
  const StandingsByAttempt both = {{"a", Standing::shouldPass}, {"b", Standing::shouldFail}};
  EXPECT_EQ(*kept, both);
  EXPECT_EQ(*readStandings(library.path()), both);
  EXPECT_EQ(standingIn(both, "b"), Standing::shouldFail);
  EXPECT_EQ(standingIn(both, "c"), Standing::unknown);
  EXPECT_EQ(standingsFile(library.path()), library / "assessment" / "standings.json");
  EXPECT_EQ(json::parse(textOf(standingsFile(library.path()))),
            json({{"format", 1}, {"standings", {{"a", "should_pass"}, {"b", "should_fail"}}}}));
}

TEST(Standings, ChangeAndAreTakenBackAndEachChangeIsInTheInstructorsLog) {
  const TemporaryFolder library;
  ASSERT_TRUE(keepStanding(library.path(), "a", Standing::shouldPass, "Dr. Weiss"));
  ASSERT_TRUE(keepStanding(library.path(), "a", Standing::shouldPass, "Dr. Weiss"));
  ASSERT_TRUE(keepStanding(library.path(), "a", Standing::shouldFail, "Dr. Weiss"));
  EXPECT_EQ(standingIn(*readStandings(library.path()), "a"), Standing::shouldFail);
  const auto kept = keepStanding(library.path(), "a", Standing::unknown, "Dr. Weiss");
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_TRUE(kept->empty());
  EXPECT_TRUE(readStandings(library.path())->empty());
  const auto log = readInstructorLog(library.path());
  ASSERT_TRUE(log) << log.error();
  ASSERT_EQ(log->changes.size(), 3u) << "the same once more is no change";
  EXPECT_EQ(log->changes[0].what, "standing changed");
  EXPECT_EQ(log->changes[0].of, "a");
  EXPECT_NE(log->changes[0].who.find("Dr. Weiss"), std::string::npos);
  EXPECT_TRUE(log->changes[0].before.is_null());
  EXPECT_EQ(log->changes[1].before, json("should_pass"));
  EXPECT_EQ(log->changes[1].after, json("should_fail"));
  EXPECT_TRUE(log->changes[2].after.is_null());
}

TEST(Standings, KeepFieldsThatThisProgramDoesNotKnow) {
  const TemporaryFolder library;
  const fs::path file = standingsFile(library.path());
  writeText(file, R"({"format": 1, "standings": {"b": "should_fail"}, "note": ["by hand"]})");
  ASSERT_TRUE(keepStanding(library.path(), "a", Standing::shouldPass));
  const json document = json::parse(textOf(file));
  EXPECT_EQ(document.at("note"), json::array({"by hand"}));
  EXPECT_EQ(document.at("standings").size(), 2u);
}

TEST(Standings, OfADamagedOrNewerFileAreRefusedWithASentenceAndNotWrittenOver) {
  const TemporaryFolder library;
  const fs::path file = standingsFile(library.path());
  const auto expectRefused = [&](const std::string& text, ErrorCode code, const std::string& sentence) {
    writeText(file, text);
    const auto read = readStandings(library.path());
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().code, code) << text;
    EXPECT_NE(read.error().sentence().find(sentence), std::string::npos) << read.error();
    const auto kept = keepStanding(library.path(), "a", Standing::shouldPass);
    ASSERT_FALSE(kept) << text;
    EXPECT_EQ(kept.error(), read.error());
    EXPECT_EQ(textOf(file), text);
  };
  expectRefused("", ErrorCode::badHeader, "standings.json is not valid JSON");
  expectRefused(R"({"format": 1, "standings": {"a": "sho)", ErrorCode::badHeader, "standings.json is not valid JSON");
  expectRefused("[]", ErrorCode::badHeader, "standings.json does not hold one JSON object");
  expectRefused(R"({"standings": {}})", ErrorCode::badField, "'format' in standings.json is missing");
  expectRefused(R"({"format": 1, "standings": ["a"]})", ErrorCode::badField, "'standings' in standings.json");
  expectRefused(R"({"format": 1, "standings": {"b": "perhaps"}})", ErrorCode::badField,
                R"('standings.b' in standings.json is "perhaps"; it must be "should_pass" or "should_fail".)");
  expectRefused(R"({"format": 2, "standings": []})", ErrorCode::newerFormat, "standings.json has format 2, this program reads up to 1");
}

TEST(Standings, SayThatTheLibraryCannotBeWritten) {
  const TemporaryFolder library;
  writeText(library / "assessment", "a file");
  const auto kept = keepStanding(library.path(), "a", Standing::shouldPass);
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, ErrorCode::notWritable);
}

TEST(Standings, OfTwoWritersAtOnceAreAllKept) {
  const TemporaryFolder library;
  constexpr int kEach = 20, kTries = 100;
  const auto keepAll = [&library](const std::string& name) {
    for (int n = 0; n < kEach; ++n)
      for (int tries = 0; tries < kTries; ++tries)  // each waits for the other a while, and a busy machine takes longer
        if (keepStanding(library.path(), name + std::to_string(n), Standing::shouldPass)) break;
  };
  std::thread first(keepAll, "first-"), second(keepAll, "second-");
  first.join();
  second.join();
  const auto kept = readStandings(library.path());
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_EQ(kept->size(), 2u * kEach);
}

}  // namespace
}  // namespace ew::standings_test
