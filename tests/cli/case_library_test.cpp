#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "cli/cli_world.h"
#include "ew/io/volume_file.h"
#include "ew/library/instructor_log.h"

namespace ew::test::case_library_test {
namespace {

namespace fs = std::filesystem;

void makeCase(const std::string& place, const std::string& id) {
  fs::create_directories(fs::path(place) / "volumes");
  ASSERT_TRUE(writeVolume(rampVolume({6, 5, 4}), (fs::path(place) / "volumes/v.mha")));
  const nlohmann::json manifest = {{"format", 1},
                                   {"id", id},
                                   {"title", "Knee"},
                                   {"title_for_trainees", "A joint"},
                                   {"region", "knee"},
                                   {"indication", "Pain after a fall. Fluid?"},
                                   {"findings", {"No fluid."}},
                                   {"diagnosis", "A sound knee."},
                                   {"start_pose", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
                                   {"volume",
                                    {{"file", "volumes/v.mha"},
                                     {"attribution", "made for a test"},
                                     {"licence", "CC0"},
                                     {"file_to_world", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}}};
  writeText((fs::path(place) / "case.json").string(), manifest.dump(2));
}

TEST(CaseLibrary, ExportsACaseAndImportsItIntoAnotherLibrary) {
  const TemporaryFolder folder;
  makeCase(folder / "mine", "knee");
  const auto exported = run({"case", "export", folder / "mine", "-o", folder / "knee.ewcase", "--report", folder / "r.json"});
  ASSERT_EQ(exported.status, 0) << exported.err;
  EXPECT_NE(exported.out.find("Exported knee (2 files"), std::string::npos) << exported.out;
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["files"], 2);
  EXPECT_EQ(readJson(folder / "r.json")["outputs"][0], folder / "knee.ewcase");
  const auto imported = run({"case", "import", folder / "knee.ewcase", "--library", folder / "library", "--report", folder / "i.json"});
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_NE(imported.out.find("Imported knee, revision 1"), std::string::npos) << imported.out;
  EXPECT_EQ(readJson(folder / "i.json")["case"]["revision"], 1);
  EXPECT_EQ(run({"case", "validate", folder / "library/published/knee/1"}).status, 0);
  const auto again = run({"case", "import", folder / "knee.ewcase", "--library", folder / "library"});
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.out.find("nothing was done"), std::string::npos) << again.out;
}

TEST(CaseLibrary, PublishesIntoTheUsersLibraryFromWhereTheIdIsKnown) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  makeCase(folder / "mine", "knee");
  for (int revision = 1; revision <= 2; ++revision) {
    writeText(folder / "mine/notes.txt", std::to_string(revision));
    const auto published = run({"case", "publish", folder / "mine"});
    ASSERT_EQ(published.status, 0) << published.err;
    EXPECT_NE(published.out.find("revision " + std::to_string(revision)), std::string::npos) << published.out;
  }
  const auto exported = run({"case", "export", "knee", "-o", folder / "knee.ewcase"});
  ASSERT_EQ(exported.status, 0) << exported.err;
  EXPECT_NE(exported.out.find("knee, revision 2"), std::string::npos) << exported.out;
  EXPECT_EQ(run({"case", "verify", "knee", folder / "knee.ewcase"}).status, 0);
}

TEST(CaseLibrary, VerifyNamesEveryFileThatIsWrongAndFails) {
  const TemporaryFolder folder;
  makeCase(folder / "mine", "knee");
  ASSERT_EQ(run({"case", "publish", folder / "mine", "--library", folder / "library"}).status, 0);
  const std::string revision = folder / "library/published/knee/1";
  const auto good = run({"case", "verify", revision, folder / "mine"});
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_NE(good.out.find("all as they were kept"), std::string::npos) << good.out;
  EXPECT_NE(good.err.find("was not published"), std::string::npos) << good.err;
  fs::remove(revision + "/volumes/v.mha");
  writeText(revision + "/more.txt", "more");
  ASSERT_EQ(run({"case", "export", folder / "mine", "-o", folder / "knee.ewcase"}).status, 0);
  const std::string whole = readText(folder / "knee.ewcase");
  writeText(folder / "short.ewcase", whole.substr(0, whole.size() / 2));
  const auto checked = run({"case", "verify", revision, folder / "short.ewcase", folder / "knee.ewcase", "--report", folder / "r.json"});
  EXPECT_EQ(checked.status, 1);
  for (const char* part : {"volumes/v.mha", "more.txt", "short.ewcase", "ends too early"})
    EXPECT_NE(checked.out.find(part), std::string::npos) << part << "\n" << checked.out;
  const auto report = readJson(folder / "r.json");
  ASSERT_EQ(report["cases"].size(), 3u) << report;
  EXPECT_GE(report["cases"][0]["problems"].size(), 2u);
  EXPECT_EQ(report["cases"][2]["problems"].size(), 0u);
}

TEST(CaseLibrary, VerifyReadsEveryRevisionOfAnId) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  makeCase(folder / "mine", "knee");
  for (int revision = 1; revision <= 2; ++revision) {
    writeText(folder / "mine/notes.txt", std::to_string(revision));
    ASSERT_EQ(run({"case", "publish", folder / "mine"}).status, 0);
  }
  const auto good = run({"case", "verify", "knee"});
  EXPECT_EQ(good.status, 0) << good.err;
  for (const char* part : {"knee, revision 1: ", "knee, revision 2: "}) EXPECT_NE(good.out.find(part), std::string::npos) << good.out;
  const std::string volume = folder / "library/published/knee/2/volumes/v.mha";
  fs::permissions(volume, fs::perms::owner_all);
  const std::string whole = readText(volume);
  fs::remove(volume);  // the revisions share it by a hard link
  writeText(volume, whole + "x");
  const auto damaged = run({"case", "verify", "knee"});
  EXPECT_EQ(damaged.status, 1) << damaged.out;
  EXPECT_NE(damaged.out.find("knee, revision 2: "), std::string::npos) << damaged.out;
  EXPECT_NE(damaged.out.find("volumes/v.mha"), std::string::npos) << damaged.out;
  EXPECT_NE(damaged.out.find("knee, revision 1: 3 files, all as they were kept"), std::string::npos) << damaged.out;
  const auto exported = run({"case", "export", "knee", "-o", folder / "k.ewcase"});
  EXPECT_EQ(exported.status, 0) << exported.err;
  EXPECT_NE(exported.err.find("Revision 2 of 'knee' is not complete, so revision 1 is taken"), std::string::npos) << exported.err;
}

TEST(CaseLibrary, OwnPublishedAndShippedCasesAreListedAndKnownByTheirIds) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  makeCase(folder / "mine", "knee");
  makeCase(folder / "library/cases/own-elbow", "own-elbow");
  ASSERT_EQ(run({"case", "export", folder / "mine", "-o", folder / "k.ewcase"}).status, 0);
  ASSERT_EQ(run({"case", "import", folder / "k.ewcase"}).status, 0);
  const auto listed = run({"case", "list"});
  ASSERT_EQ(listed.status, 0) << listed.err;
  std::map<std::string, std::string> lines;
  std::istringstream in(listed.out);
  for (std::string line; std::getline(in, line);) lines[line.substr(0, line.find(' '))] = line;
  EXPECT_TRUE(lines["own-elbow"].ends_with("  own")) << listed.out;
  EXPECT_TRUE(lines["knee"].ends_with("  published, revision 1")) << listed.out;
  EXPECT_NE(lines["liver-sweep-recorded"].find("  shipped"), std::string::npos) << listed.out;
  for (const char* id : {"knee", "own-elbow"}) {
    for (const char* command : {"show", "validate"}) EXPECT_EQ(run({"case", command, id}).status, 0) << command << " " << id;
    for (const char* command : {"list", "check"}) EXPECT_EQ(run({"lesson", command, id}).status, 0) << command << " " << id;
  }
  const auto unknown = run({"case", "show", "nothing"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_NE(unknown.err.find("There is no case 'nothing'"), std::string::npos) << unknown.err;
}

TEST(CaseLibrary, AnIdMeansTheAuthorsOwnCaseBeforeThePublishedOne) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  makeCase(folder / "library/cases/knee", "knee");
  ASSERT_EQ(run({"case", "publish", "knee"}).status, 0);
  const auto same = run({"case", "publish", "knee"});
  EXPECT_NE(same.out.find("Nothing has changed since"), std::string::npos) << same.out;
  writeText(folder / "library/cases/knee/notes.txt", "edited");
  const auto edited = run({"case", "publish", "knee"});
  ASSERT_EQ(edited.status, 0) << edited.err;
  EXPECT_NE(edited.out.find("Published knee, revision 2"), std::string::npos) << edited.out;
  EXPECT_TRUE(fs::exists(folder / "library/published/knee/2/notes.txt"));

  writeText(folder / "library/cases/knee/more.txt", "edited again");
  const auto exported = run({"case", "export", "knee", "-o", folder / "own.ewcase"});
  ASSERT_EQ(exported.status, 0) << exported.err;
  EXPECT_NE(exported.out.find("Exported knee (4 files"), std::string::npos) << exported.out;
  for (const char* part : {"your own case", "revision 2", "library/published/knee/2'"})
    EXPECT_NE(exported.err.find(part), std::string::npos) << exported.err;
  const auto revision = run({"case", "export", folder / "library/published/knee/2", "-o", folder / "published.ewcase"});
  EXPECT_NE(revision.out.find("Exported knee, revision 2 (3 files"), std::string::npos) << revision.out;
  EXPECT_EQ(revision.err.find("your own case"), std::string::npos) << revision.err;

  writeText(folder / "library/cases/knee/case.json", "{");
  const auto broken = run({"case", "publish", "knee"});
  EXPECT_EQ(broken.status, 1) << broken.out << "it cannot be opened, which does not make it the published one";
}

TEST(CaseLibrary, ListsFilesWithWhatUsesThemAndTakesOutWhatNothingUses) {
  const TemporaryFolder folder;
  makeCase(folder / "mine", "knee");
  writeText(folder / "mine/volumes/other.mha", "of another patient");
  const auto listed = run({"case", "files", folder / "mine"});
  ASSERT_EQ(listed.status, 0) << listed.err;
  for (const char* part : {"case.json", "the case itself", "volumes/v.mha", "its volume", "volumes/other.mha", "18 B  used by nothing"})
    EXPECT_NE(listed.out.find(part), std::string::npos) << part << "\n" << listed.out;
  const auto told = nlohmann::json::parse(run({"case", "files", folder / "mine", "--json"}).out);
  ASSERT_EQ(told["files"].size(), 3u) << told;
  EXPECT_EQ(told["files"][1], nlohmann::json({{"path", "volumes/other.mha"}, {"bytes", 18}, {"used_by", nlohmann::json::array()}}));
  const auto used = run({"case", "withdraw-file", folder / "mine", "volumes/other.mha", "volumes/v.mha"});
  EXPECT_EQ(used.status, 2);
  EXPECT_NE(used.err.find("'volumes/v.mha' is used by its volume, and stays."), std::string::npos) << used.err;
  EXPECT_TRUE(fs::exists(folder / "mine/volumes/other.mha")) << "all or none";
  const auto taken = run({"case", "withdraw-file", folder / "mine", "volumes/other.mha", "--report", folder / "r.json"});
  ASSERT_EQ(taken.status, 0) << taken.err;
  EXPECT_FALSE(fs::exists(folder / "mine/volumes/other.mha"));
  const std::string aside = readJson(folder / "r.json")["withdrawn"]["folder"];
  EXPECT_EQ(readText(aside + "/volumes/other.mha"), "of another patient");
  EXPECT_NE(taken.out.find("1 file of knee taken out, to " + aside), std::string::npos) << taken.out;
  EXPECT_NE(run({"case", "files", folder / "mine"}).err.find("1 file taken out before"), std::string::npos);
  ASSERT_EQ(run({"case", "export", folder / "mine", "-o", folder / "knee.ewcase", "--report", folder / "e.json"}).status, 0);
  EXPECT_EQ(readJson(folder / "e.json")["quality"]["files"], 2) << "it is not handed on";
  const auto shipped = run({"case", "withdraw-file", "liver-sweep-recorded", "SOURCE.md"});
  EXPECT_EQ(shipped.status, 1);
  EXPECT_NE(shipped.err.find("not your own"), std::string::npos) << shipped.err;
}

TEST(CaseLibrary, SaysThatABundleIsImportedBeforeItIsACase) {
  const TemporaryFolder folder;
  makeCase(folder / "mine", "knee");
  ASSERT_EQ(run({"case", "export", folder / "mine", "-o", folder / "knee.ewcase"}).status, 0);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"case", "files", folder / "knee.ewcase"},
                                                {"case", "show", folder / "knee.ewcase"},
                                                {"case", "export", folder / "knee.ewcase", "-o", folder / "again.ewcase"}}) {
    const auto outcome = run(words);
    EXPECT_EQ(outcome.status, 2) << words[1];
    EXPECT_NE(outcome.err.find("'" + (folder / "knee.ewcase") +
                               "' is a bundle, in which a case is handed on; take it into the library with 'echoweave case import', and "
                               "name the case by its id then."),
              std::string::npos)
        << outcome.err;
  }
}

TEST(CaseLibrary, SaysWhichRevisionHoldsAFileThatIsTakenOut) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  makeCase(folder / "mine", "knee");
  writeText(folder / "mine/report.txt", "of another patient");
  ASSERT_EQ(run({"case", "publish", folder / "mine"}).status, 0);
  const auto taken = run({"case", "withdraw-file", folder / "mine", "report.txt"});
  ASSERT_EQ(taken.status, 0) << taken.err;
  EXPECT_NE(taken.err.find("Revision 1 of 'knee', which was published before, holds 'report.txt' all the same."), std::string::npos)
      << taken.err;
}

TEST(CaseLibrary, WithdrawsAnOwnCaseByItsId) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  makeCase(folder / "library/cases/first try", "knee");
  const auto taken = run({"case", "withdraw", "knee", "--report", folder / "r.json"});
  ASSERT_EQ(taken.status, 0) << taken.err;
  EXPECT_FALSE(fs::exists(folder / "library/cases/first try"));
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["case"]["id"], "knee");
  EXPECT_TRUE(fs::exists(report["case"]["folder"].get<std::string>() + "/case.json"));
  const auto log = readInstructorLog(folder / "library");
  ASSERT_TRUE(log && log->changes.size() == 1);
  EXPECT_EQ(log->changes[0].what, "case withdrawn");
  EXPECT_EQ(log->changes[0].of, "knee");
  EXPECT_EQ(run({"case", "withdraw", "knee"}).status, 1) << "there is none any more";
  const auto shipped = run({"case", "withdraw", "liver-sweep-recorded"});
  EXPECT_EQ(shipped.status, 2);
  EXPECT_NE(shipped.err.find("comes with the program"), std::string::npos) << shipped.err;
}

TEST(CaseLibrary, WithdrawsAPublishedCaseByItsIdAndItComesBackAsItSays) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  makeCase(folder / "mine", "knee");
  ASSERT_EQ(run({"case", "publish", folder / "mine"}).status, 0);
  const auto taken = run({"case", "withdraw", "knee", "--report", folder / "r.json"});
  ASSERT_EQ(taken.status, 0) << taken.err;
  const auto log = readInstructorLog(folder / "library");
  ASSERT_TRUE(log && log->changes.size() == 1) << "and not twice";
  EXPECT_EQ(log->changes[0].of, "knee");
  EXPECT_EQ(run({"case", "show", "knee"}).status, 1);
  writeText(folder / "mine/notes.txt", "edited");
  const auto again = run({"case", "publish", folder / "mine"});
  EXPECT_NE(again.out.find("Published knee, revision 2"), std::string::npos) << again.out;
  const auto verified = run({"case", "verify", "knee"});
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  EXPECT_EQ(verified.out.find("revision 1"), std::string::npos) << verified.out;
  ASSERT_EQ(run({"case", "withdraw", folder / "library/published/knee/"}).status, 0);
  EXPECT_EQ(readInstructorLog(folder / "library")->changes.back().of, "knee");

  const auto report = readJson(folder / "r.json");
  const std::string from = report["case"]["from"];
  EXPECT_NE(taken.out.find("Moved back to " + from), std::string::npos) << taken.out;
  ASSERT_FALSE(fs::exists(from)) << "else `mv` puts the case into it";
  fs::rename(report["case"]["folder"].get<std::string>(), from);
  EXPECT_EQ(run({"case", "show", "knee"}).status, 0);
  EXPECT_EQ(run({"case", "verify", "knee"}).status, 0);
}

TEST(CaseLibrary, WithdrawsNeitherOfTwoCasesWithTheId) {
  const TemporaryFolder folder;
  const EnvironmentValue library("ECHOWEAVE_LIBRARY", folder / "library");
  makeCase(folder / "library/cases/mine", "knee");
  ASSERT_EQ(run({"case", "publish", "knee"}).status, 0);
  const auto refused = run({"case", "withdraw", "knee"});
  EXPECT_EQ(refused.status, 2);
  for (const char* each : {"library/cases/mine", "library/published/knee"})
    EXPECT_NE(refused.err.find("'" + (folder / each) + "'"), std::string::npos) << refused.err;
  EXPECT_TRUE(fs::exists(folder / "library/cases/mine/case.json"));
  EXPECT_TRUE(fs::exists(folder / "library/published/knee/1/case.json"));
  EXPECT_EQ(run({"case", "withdraw", folder / "library/cases/mine/case.json"}).status, 0);
  EXPECT_FALSE(fs::exists(folder / "library/cases/mine"));
  EXPECT_EQ(run({"case", "withdraw", folder / "library/published/knee"}).status, 0);
  EXPECT_FALSE(fs::exists(folder / "library/published/knee"));
}

TEST(CaseLibrary, WhatATitleHoldsCannotSteerTheTerminalNorPretendToBeALine) {
  const TemporaryFolder folder;
  makeCase(folder / "cases/knee", "knee");
  nlohmann::json manifest = readJson(folder / "cases/knee/case.json");
  const std::string evil =
      "Knee\x1b[2J\x1b]0;pwned\x07\xc2\x9b"
      "31m\r\b\nroot: all is well";
  for (const char* field : {"title", "region", "diagnosis"}) manifest[field] = evil;
  writeText(folder / "cases/knee/case.json", manifest.dump());
  for (const auto& words : std::vector<std::vector<std::string>>{{"case", "list", folder / "cases"},
                                                                 {"case", "show", folder / "cases/knee"},
                                                                 {"case", "show", folder / "cases/knee", "--json"},
                                                                 {"lesson", "list", folder / "cases/knee"},
                                                                 {"case", "show", evil},
                                                                 {"case", "publish", folder / "cases/knee", "--library", folder / "l"}}) {
    const auto said = run(words);
    for (const std::string& stream : {said.out, said.err}) {
      for (const char letter : stream)
        EXPECT_TRUE(letter == '\n' || static_cast<unsigned char>(letter) >= 0x20) << words[1] << ": " << stream;
      EXPECT_EQ(stream.find("\xc2\x9b"), std::string::npos) << words[1] << ": " << stream;
      EXPECT_FALSE(stream.starts_with("root:")) << stream;
      EXPECT_EQ(stream.find("\nroot:"), std::string::npos) << words[1] << ": " << stream;
    }
  }
}

TEST(CaseLibrary, RefusedCommandsWriteNothing) {
  const TemporaryFolder folder;
  makeCase(folder / "mine", "knee");
  const auto names = folder.names();
  const auto refuses = [&](const std::vector<std::string>& words, int status) {
    const auto outcome = run(words);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(folder.names(), names);
  };
  refuses({"case", "export", folder / "mine"}, 2);
  refuses({"case", "export", folder / "mine", "-o", folder / "knee.zip"}, 2);
  refuses({"case", "export", folder / "mine", "-o", folder / "k.ewcase", "--report", folder / "mine/case.json"}, 2);
  refuses({"case", "export", folder / "mine", "-o", folder / "k.ewcase", "--report", folder / "mine/volumes/v.mha"}, 2);
  refuses({"case", "export", folder / "nothing", "-o", folder / "k.ewcase"}, 1);
  refuses({"case", "import", folder / "mine/case.json", "--library", folder / "library"}, 1);
  refuses({"case", "import", folder / "nothing.ewcase", "--library", folder / "library"}, 1);
  refuses({"case", "publish"}, 2);
  refuses({"case", "verify"}, 2);
  std::atomic<bool> cancel{true};
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"case", "export", folder / "mine", "-o", folder / "k.ewcase"},
        std::vector<std::string>{"case", "publish", folder / "mine", "--library", folder / "library"}}) {
    const auto stopped = run(words, &cancel);
    EXPECT_EQ(stopped.status, 1);
    EXPECT_NE(stopped.err.find("nothing was written"), std::string::npos) << stopped.err;
    EXPECT_EQ(folder.names(), names);
  }
}

}  // namespace
}  // namespace ew::test::case_library_test
