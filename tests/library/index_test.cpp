#include "ew/library/index.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "files/sqlite.h"
#include "index/index_folders.h"
#include "index_library.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using test::gallStone;
using test::plainCase;
using test::titles;
using test::writeManifest;
using Titles = std::vector<std::string>;

struct LibraryIndexTest : testing::Test {
  test::TemporaryFolder folder;
  const fs::path file = folder / "cache/index/library.index";
  const std::vector<LibraryRoot> roots = {
      {folder / "shipped", LibraryKind::shipped}, {folder / "own", LibraryKind::own}, {folder / "published", LibraryKind::published}};

  [[nodiscard]] std::unique_ptr<LibraryIndex> open(const std::string& language = "en") const {
    auto opened = openIndex(file, language);
    EXPECT_TRUE(opened.has_value());
    return std::move(*opened);
  }
  std::unique_ptr<LibraryIndex> refreshed(const std::string& language = "en") const {
    auto index = open(language);
    EXPECT_TRUE(index->refresh(roots, noProgress()).has_value());
    return index;
  }
  /// As if all manifests had been written long ago.
  void settle() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      if (entry.path().filename() == "case.json") fs::last_write_time(entry, fs::file_time_type::clock::now() - std::chrono::hours(1));
  }
};

TEST_F(LibraryIndexTest, RowsHoldWhatACardShows) {
  writeManifest(folder / "shipped/stone", gallStone());
  const auto index = refreshed();
  CaseQuery query;
  query.forTrainees = false;
  const auto page = search(*index, query);
  ASSERT_TRUE(page && page->rows.size() == 1);
  const CaseRow& row = page->rows.front();
  EXPECT_EQ(row.id, "gall-stone");
  EXPECT_EQ(row.title, "Solitary gall stone");
  EXPECT_EQ(row.titleForTrainees, "Pain after meals");
  EXPECT_EQ(row.region, "upper abdomen");
  EXPECT_EQ(row.pathology, "Cholecystolithiasis\nOne stone with an acoustic shadow");
  EXPECT_EQ(row.folder, folder / "shipped/stone");
  EXPECT_EQ(row.kind, LibraryKind::shipped);
  EXPECT_EQ(row.level, 3);
  EXPECT_EQ(row.tags, (Titles{"biliary", "emergency"}));
  ASSERT_EQ(row.lessons.size(), 2u);
  EXPECT_EQ(row.lessons[0], (LessonRow{"look", "A first look", "Name the liver", 2, 15, 2}));
  EXPECT_EQ(row.lessons[1], (LessonRow{"measure", "Measuring", "", 4, 0, 0}));
}

TEST_F(LibraryIndexTest, EachWordIsTheBeginningOfAWordInAnyOrderAndCase) {
  writeManifest(folder / "own/stone", gallStone());
  writeManifest(folder / "own/other", plainCase("other", "Pains of growing"));
  const auto index = refreshed();
  EXPECT_EQ(titles(*index, "pain"), (Titles{"Pain after meals", "Pains of growing"}));
  EXPECT_EQ(titles(*index, "MEA pai"), Titles{"Pain after meals"});
  EXPECT_EQ(titles(*index, "pains"), Titles{"Pains of growing"});
  EXPECT_EQ(titles(*index, "eals"), Titles{});
  EXPECT_EQ(titles(*index, "first bili"), Titles{"Pain after meals"}) << "lessons and tags are searched, too";
}

TEST_F(LibraryIndexTest, AccentsAndSharpSDoNotMatter) {
  writeManifest(folder / "own/vessel", plainCase("vessel", "Große Gefäße, café"));
  writeManifest(folder / "own/stone", gallStone());
  const auto index = refreshed();
  for (const char* typed : {"gefa", "gefäß", "GEFASSE", "grosse cafe", "GROSS", "Café"})
    EXPECT_EQ(titles(*index, typed), Titles{"Große Gefäße, café"}) << typed;
  EXPECT_EQ(titles(*index, "ubelkeit"), Titles{"Pain after meals"});
}

TEST_F(LibraryIndexTest, ASearchOfATraineeGivesNoAnswerAway) {
  writeManifest(folder / "own/stone", gallStone());
  const auto index = refreshed();
  for (const char* answer : {"solitary", "gall", "stone", "cholecysto", "shadow", "polyp"}) {
    EXPECT_EQ(titles(*index, answer), Titles{}) << answer;
    EXPECT_EQ(titles(*index, std::string("pain ") + answer), Titles{}) << answer;
    EXPECT_EQ(titles(*index, answer, false), Titles{"Solitary gall stone"}) << answer;
  }
  const auto page = search(*index, {});
  ASSERT_TRUE(page && page->rows.size() == 1);
  const CaseRow& row = page->rows.front();
  EXPECT_EQ(row.title, "Pain after meals");
  EXPECT_EQ(row.pathology, "");
  // Nor may somebody who knows the store's language of queries ask for the closed column.
  for (const char* odd :
       {"closed:stone", "closed : stone", "{closed}: stone", "\") OR closed : (\"stone", "pain OR stone", "NEAR(pain stone)"})
    EXPECT_EQ(titles(*index, odd), Titles{}) << odd;
}

TEST_F(LibraryIndexTest, TheOrderOfAListGivesNoAnswerAwayEither) {
  auto first = plainCase("a", "Aneurysm");
  first["title_for_trainees"] = "Z for trainees";
  writeManifest(folder / "own/1", first);
  writeManifest(folder / "own/2", plainCase("b", "ärger"));
  writeManifest(folder / "own/3", plainCase("c", "Bauch"));
  const auto index = refreshed();
  EXPECT_EQ(titles(*index, ""), (Titles{"ärger", "Bauch", "Z for trainees"}));
  EXPECT_EQ(titles(*index, "", false), (Titles{"Aneurysm", "ärger", "Bauch"}));
}

TEST_F(LibraryIndexTest, FiltersNarrowTogetherAndTellWhatCanBeChosen) {
  writeManifest(folder / "shipped/stone", gallStone());
  auto neck = plainCase("neck", "Neck");
  neck["region"] = "neck";
  neck["tags"] = {"emergency"};
  neck["difficulty"] = 1;
  writeManifest(folder / "own/neck", neck);
  const auto index = refreshed();
  EXPECT_EQ(titles(*index, CaseQuery{.region = "neck"}), Titles{"Neck"});
  EXPECT_EQ(titles(*index, CaseQuery{.tags = {"emergency"}}), (Titles{"Pain after meals", "Neck"}));
  EXPECT_EQ(titles(*index, CaseQuery{.tags = {"emergency", "biliary"}}), Titles{"Pain after meals"});
  EXPECT_EQ(titles(*index, CaseQuery{.level = 1}), Titles{"Neck"});
  EXPECT_EQ(titles(*index, CaseQuery{.kind = LibraryKind::shipped}), Titles{"Pain after meals"});
  EXPECT_EQ(titles(*index, CaseQuery{.lessonsOnly = true}), Titles{"Pain after meals"});
  EXPECT_EQ(titles(*index, CaseQuery{.words = "neck", .tags = {"biliary"}}), Titles{});
  const auto choices = index->choices();
  ASSERT_TRUE(choices.has_value());
  EXPECT_EQ(*choices, (CaseChoices{{"neck", "upper abdomen"}, {"biliary", "emergency"}, {1, 3}, {LibraryKind::shipped, LibraryKind::own}}));
}

TEST_F(LibraryIndexTest, APageKnowsHowManyMatch) {
  for (int n = 0; n < 30; ++n)
    writeManifest(folder / ("own/" + std::to_string(n)), plainCase("c" + std::to_string(n), "Case " + std::to_string(100 + n)));
  const auto index = refreshed();
  const auto page = search(*index, {}, 25, 10);
  ASSERT_TRUE(page.has_value());
  EXPECT_EQ(page->total, 30u);
  ASSERT_EQ(page->rows.size(), 5u);
  EXPECT_EQ(page->rows.front().title, "Case 125");
  EXPECT_EQ(search(*index, {}, 40, 10)->rows.size(), 0u);
}

TEST_F(LibraryIndexTest, OddWordsAreSearchedForAndNeverFail) {
  writeManifest(folder / "own/stone", gallStone());
  const auto index = refreshed();
  const std::vector<std::string> nothing = {"", " ", "\"", "***", "()", "-", std::string("\0", 1), "\xff\xfe", "':;<>"};
  for (const std::string& odd : nothing) EXPECT_EQ(titles(*index, odd), Titles{"Pain after meals"}) << odd;
  const std::vector<std::string> pain = {"\"pain",
                                         "pain*",
                                         "pain-after",
                                         "(pain)",
                                         std::string("pain\0after", 10),
                                         "pain\xff",
                                         "^pain",
                                         "'pain'",
                                         std::string(10000, '"') + "pain",
                                         std::string(5000, ' ') + "meals"};
  for (const std::string& odd : pain) EXPECT_EQ(titles(*index, odd), Titles{"Pain after meals"}) << odd;
  std::string long_words;
  while (long_words.size() < 10240) long_words += "pain \xc3 \xf0\x9f\x98 NEAR/2 AND OR NOT \"";
  EXPECT_EQ(titles(*index, long_words), Titles{});
  EXPECT_EQ(titles(*index, std::string(10240, 'x')), Titles{});
  EXPECT_EQ(titles(*index, "pain OR meals"), Titles{}) << "words, not operators: no word begins with 'or'";
}

TEST_F(LibraryIndexTest, OnlyTheHighestRevisionOfAPublishedCaseCounts) {
  writeManifest(folder / "published/liver/2", plainCase("liver", "Second"));
  writeManifest(folder / "published/liver/10", plainCase("liver", "Tenth"));
  writeManifest(folder / "published/liver/draft", plainCase("liver", "Draft"));
  fs::create_directories(folder / "published/liver/11");  // without a case.json: not complete
  const auto index = refreshed();
  EXPECT_EQ(titles(*index, ""), Titles{"Tenth"});
  EXPECT_EQ(search(*index, {})->rows.front().revision, 10);
  writeManifest(folder / "published/liver/11", plainCase("liver", "Eleventh"));
  const auto report = index->refresh(roots, noProgress());
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(titles(*index, ""), Titles{"Eleventh"});
  EXPECT_EQ(report->removed, 1u);
}

TEST_F(LibraryIndexTest, OnlyWhatChangedIsReadAgain) {
  for (int n = 0; n < 20; ++n)
    writeManifest(folder / ("own/" + std::to_string(n)), plainCase("c" + std::to_string(n), "Case " + std::to_string(n)));
  settle();
  const auto index = open();
  EXPECT_EQ(index->refresh(roots, noProgress())->read, 20u);
  EXPECT_EQ(index->refresh(roots, noProgress())->read, 0u);
  writeManifest(folder / "own/7", plainCase("c7", "Changed"));
  writeManifest(folder / "own/new", plainCase("new", "New"));
  fs::remove_all(folder / "own/8");
  const auto report = index->refresh(roots, noProgress());
  EXPECT_EQ(report->read, 2u);
  EXPECT_EQ(report->removed, 1u);
  EXPECT_EQ(report->seen, 20u);
  EXPECT_EQ(titles(*index, "changed"), Titles{"Changed"});
  EXPECT_EQ(titles(*index, "8"), Titles{});
}

TEST_F(LibraryIndexTest, AStampCountsOnceItsFileHasRestedForLongerThanAClockTicks) {
  writeManifest(folder / "own/one", plainCase("one", "Title"));
  struct ::stat seen {};
  ASSERT_EQ(::stat((folder / "own/one/case.json").c_str(), &seen), 0);
  const std::chrono::system_clock::time_point written(
      std::chrono::seconds(seen.st_mtim.tv_sec) +
      std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::nanoseconds(seen.st_mtim.tv_nsec)));
  using std::chrono::milliseconds;
  const auto settledAfter = [&](milliseconds age) { return isSettled(folder / "own/one", "en", written + age); };
  EXPECT_FALSE(settledAfter(milliseconds(0)));
  EXPECT_FALSE(settledAfter(milliseconds(20)));
  EXPECT_TRUE(settledAfter(milliseconds(100)));
  EXPECT_FALSE(settledAfter(milliseconds(-500))) << "clocks of two machines that differ a little";
  EXPECT_TRUE(settledAfter(milliseconds(-5000))) << "a file from the future is not read at every start";
}

TEST_F(LibraryIndexTest, AChangeWithinATickOfTheClockIsSeen) {
  for (int n = 0; n < 50; ++n) {
    writeManifest(folder / "own/one", plainCase("one", "Title " + std::to_string(n % 10)));  // in place and as long as before
    const auto index = refreshed();
    ASSERT_EQ(titles(*index, ""), Titles{"Title " + std::to_string(n % 10)});
  }
}

TEST_F(LibraryIndexTest, BrokenCasesAreToldOfAndNotListed) {
  test::writeText(folder / "own/broken/case.json", "{\"id\": ");
  auto newer = plainCase("newer", "Newer");
  newer["format"] = 99;
  writeManifest(folder / "own/newer", newer);
  writeManifest(folder / "own/nameless", {{"format", 2}, {"id", "x"}});
  writeManifest(folder / "own/good", plainCase("good", "Good"));
  const auto index = open();
  const auto report = index->refresh(roots, noProgress());
  ASSERT_EQ(report->problems.size(), 3u);
  EXPECT_NE(report->problems[0].message.english().find("broken"), std::string::npos) << report->problems[0].message.english();
  EXPECT_NE(report->problems[1].message.english().find("'title'"), std::string::npos);
  EXPECT_NE(report->problems[2].message.english().find("format 99"), std::string::npos);
  EXPECT_EQ(titles(*index, ""), Titles{"Good"});
  EXPECT_EQ(*open()->problems(), report->problems) << "kept with their sentences";
  writeManifest(folder / "own/broken", plainCase("mended", "Mended"));
  EXPECT_EQ(index->refresh(roots, noProgress())->problems.size(), 2u);
  EXPECT_EQ(titles(*index, ""), (Titles{"Good", "Mended"}));
}

TEST_F(LibraryIndexTest, FieldsOfWrongKindsCountAsNotThere) {
  writeManifest(folder / "own/odd", {{"format", 2},
                                     {"id", "odd"},
                                     {"title", "Odd"},
                                     {"region", 7},
                                     {"difficulty", "hard"},
                                     {"tags", "one"},
                                     {"findings", {{"a", 1}}},
                                     {"parts", {{"lessons", {{"lessons", {1, "two", {{"title", nullptr}}}}}}}}});
  const auto index = refreshed();
  const auto page = search(*index, {});
  ASSERT_TRUE(page && page->rows.size() == 1);
  EXPECT_EQ(page->rows.front().region, "");
  EXPECT_EQ(page->rows.front().lessons.size(), 1u);
  EXPECT_EQ(page->rows.front().level, 1) << "of its lesson, which says none";
}

TEST_F(LibraryIndexTest, WordsOfTheLanguageAreShownAndBothAreSearched) {
  writeManifest(folder / "own/stone", gallStone());
  test::writeText(folder / "own/stone/words/de.json",
                  R"({"format": 1, "words": {"Pain after meals": "Schmerzen nach dem Essen", "upper abdomen": "Oberbauch"}})");
  const auto index = refreshed("de_AT");
  EXPECT_EQ(titles(*index, "schmerz"), Titles{"Schmerzen nach dem Essen"});
  EXPECT_EQ(titles(*index, "pain"), Titles{"Schmerzen nach dem Essen"});
  EXPECT_EQ(index->choices()->regions, Titles{"Oberbauch"});
  test::writeText(folder / "own/stone/words/de.json", R"({"format": 1, "words": {"Pain after meals": "Bauchweh"}})");
  EXPECT_TRUE(index->refresh(roots, noProgress()).has_value());
  EXPECT_EQ(titles(*index, ""), Titles{"Bauchweh"});
}

TEST_F(LibraryIndexTest, WhatWasIndexedIsThereAtTheNextStart) {
  writeManifest(folder / "own/stone", gallStone());
  refreshed();
  const auto again = open();
  EXPECT_EQ(titles(*again, "pain"), Titles{"Pain after meals"});
  EXPECT_TRUE(again->takeNotes().empty());
}

TEST_F(LibraryIndexTest, ADamagedIndexIsMadeAnewAndSaid) {
  writeManifest(folder / "own/stone", gallStone());
  for (const std::string& content : {std::string("this is no data base, whatever its name says"), std::string(8192, '\0')}) {
    refreshed();
    std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
    fs::remove(file.string() + "-wal");
    fs::remove(file.string() + "-shm");
    const auto index = refreshed();
    EXPECT_EQ(titles(*index, ""), Titles{"Pain after meals"});
    const auto again = open();
    EXPECT_TRUE(again->takeNotes().empty()) << "the new one is on the disk";
    EXPECT_EQ(titles(*again, ""), Titles{"Pain after meals"});
  }
  refreshed();
  std::ofstream(file, std::ios::binary | std::ios::trunc) << "this is no data base, whatever its name says";
  EXPECT_EQ(open()->takeNotes().size(), 1u);
}

TEST_F(LibraryIndexTest, APageThatIsDamagedInTheMiddleIsFoundAtTheNextRefresh) {
  for (int n = 0; n < 300; ++n)
    writeManifest(folder / ("own/" + std::to_string(n)), plainCase("c" + std::to_string(n), "Case " + std::to_string(n)));
  refreshed();
  {
    std::fstream raw(file, std::ios::binary | std::ios::in | std::ios::out);
    for (int page = 1; page < 30; ++page) {
      raw.seekp(page * 4096);
      raw << std::string(2000, '\xA5');
    }
  }
  auto index = openIndex(file);
  ASSERT_TRUE(index.has_value());
  const auto report = (*index)->refresh(roots, noProgress());
  ASSERT_TRUE(report.has_value()) << report.error();
  EXPECT_EQ(titles(**index, "").size(), 300u);
  EXPECT_EQ((*index)->takeNotes().size(), 1u);
}

TEST_F(LibraryIndexTest, AnIndexOfANewerProgramIsMadeAnewAndSaid) {
  writeManifest(folder / "own/stone", gallStone());
  refreshed();
  sqlite::Database(file).run("UPDATE schema_info SET version = 1000");
  const auto index = open();
  ASSERT_EQ(index->takeNotes().size(), 1u);
  EXPECT_EQ(titles(*index, ""), Titles{}) << "empty until it is refreshed";
  EXPECT_EQ(index->refresh(roots, noProgress())->read, 1u);
  EXPECT_EQ(titles(*index, ""), Titles{"Pain after meals"});
}

TEST_F(LibraryIndexTest, WhereNothingCanBeWrittenTheIndexIsKeptInMemory) {
  writeManifest(folder / "own/stone", gallStone());
  test::writeText(folder / "cache", "a file where a folder should be");
  const auto index = refreshed();
  const auto notes = index->takeNotes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes.front().english().find("ECHOWEAVE_CACHE"), std::string::npos);
  EXPECT_EQ(titles(*index, "pain"), Titles{"Pain after meals"});
  EXPECT_EQ(index->refresh(roots, noProgress())->seen, 1u);
}

TEST_F(LibraryIndexTest, AFullDiskWhileReadingMovesTheIndexIntoMemory) {
  for (int n = 0; n < 200; ++n)
    writeManifest(folder / ("own/" + std::to_string(n)), plainCase("c" + std::to_string(n), "Case " + std::to_string(n)));
  // Another handle that holds the file to its present size, as a full disk does, cannot be had from outside; a link to a device that is
  // always full can.
  fs::create_directories(file.parent_path());
  fs::create_symlink("/dev/full", file);
  const auto index = refreshed();
  EXPECT_EQ(index->takeNotes().size(), 1u);
  EXPECT_EQ(titles(*index, "").size(), 200u);
}

struct StopAfter final : Progress {
  explicit StopAfter(double after) : share(after) {}
  void report(const Message&, double fraction) override { stop = stop || fraction > share; }
  [[nodiscard]] bool cancelRequested() const override { return stop; }
  double share;
  bool stop = false;
};

TEST_F(LibraryIndexTest, WhatWasReadBeforeACancelIsKept) {
  for (int n = 0; n < 300; ++n)
    writeManifest(folder / ("own/" + std::to_string(n)), plainCase("c" + std::to_string(n), "Case " + std::to_string(n)));
  settle();
  const auto index = open();
  StopAfter stop(0.2);
  const auto stopped = index->refresh(roots, stop);
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
  const std::size_t kept = titles(*index, "").size();
  EXPECT_GT(kept, 0u);
  EXPECT_EQ(index->refresh(roots, noProgress())->read, 300 - kept);
}

TEST_F(LibraryIndexTest, TwoProcessesRefreshAtOnceAndSeeEachOther) {
  for (int n = 0; n < 400; ++n)
    writeManifest(folder / ("own/" + std::to_string(n)), plainCase("c" + std::to_string(n), "Case " + std::to_string(n)));
  std::vector<pid_t> children;
  for (int each = 0; each < 3; ++each) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    auto index = openIndex(file);
    const bool good = index && (*index)->refresh(roots, noProgress()) && (*index)->find({}) && (*index)->find({})->size() == 400 &&
                      (*index)->takeNotes().empty();
    ::_exit(good ? 0 : 1);
  }
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  const auto here = open();
  EXPECT_EQ(titles(*here, "").size(), 400u);
  // One that is open sees what another has refreshed.
  writeManifest(folder / "own/late", plainCase("late", "Late"));
  const pid_t child = ::fork();
  if (child == 0) {
    auto index = openIndex(file);
    ::_exit(index && (*index)->refresh(roots, noProgress()) ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(titles(*here, "late"), Titles{"Late"});
}

TEST_F(LibraryIndexTest, ACaseIsFoundByItsIdTheUsersOwnFirst) {
  writeManifest(folder / "shipped/a", plainCase("same", "A"));
  writeManifest(folder / "published/b/1", plainCase("same", "B"));
  writeManifest(folder / "own/c", plainCase("same", "C"));
  const auto index = refreshed();
  EXPECT_EQ(*index->foldersOf("same"), (std::vector<fs::path>{folder / "own/c", folder / "published/b/1", folder / "shipped/a"}));
  EXPECT_TRUE(index->foldersOf("other")->empty());
}

TEST_F(LibraryIndexTest, EachSetOfRootsAndEachLanguageHasItsOwnFile) {
  const test::EnvironmentValue cache("ECHOWEAVE_CACHE", (folder / "cache").string());
  EXPECT_EQ(indexFile(roots, "en").parent_path(), folder / "cache/index");
  EXPECT_EQ(indexFile(roots, "en"), indexFile(roots, "en"));
  EXPECT_NE(indexFile(roots, "en"), indexFile(roots, "de"));
  EXPECT_NE(indexFile(roots, "en"), indexFile({roots[0], roots[1]}, "en"));
}

}  // namespace
}  // namespace ew
