#include <gtest/gtest.h>

#include <algorithm>

#include "cli/cli_world.h"
#include "ew/cli/run_command.h"
#include "ew/io/image_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "library/small_case.h"

namespace ew::test::outputs_test {
namespace {

namespace fs = std::filesystem;

/// A command that was refused left everything: no file is new, and these are as they were.
void expectRefused(const std::vector<std::string>& words, int status, const TemporaryFolder& folder, const std::vector<std::string>& kept) {
  const auto names = folder.names();
  std::vector<std::string> before;
  for (const auto& name : kept) before.push_back(readText(folder / name));
  const auto outcome = run(words);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(folder.names(), names);
  for (std::size_t n = 0; n < kept.size(); ++n) EXPECT_EQ(readText(folder / kept[n]), before[n]) << kept[n];
}

TEST(CommandOutputs, AFailingCommandLeavesTheRawFileBesideAHeaderThatItWouldHaveMade) {
  const TemporaryFolder folder;
  writeText(folder / "scan.raw", std::string(512, 'v'));
  writeText(folder / "liver.raw", "my only copy");
  expectRefused({"import", folder / "scan.raw", "-o", folder / "scan.mhd"}, 2, folder, {"scan.raw"});
  expectRefused({"import", folder / "none.raw", "-o", folder / "other.mhd"}, 1, folder, {"scan.raw", "liver.raw"});
  expectRefused({"reconstruct", folder / "nothing.igs.mha", "-o", folder / "liver.mhd"}, 2, folder, {"liver.raw"});
}

TEST(CommandOutputs, TheRawFileOfAHeaderIsAnOutputToo) {
  const TemporaryFolder folder;
  writeText(folder / "scan.raw", std::string(1024, 'v'));
  writeText(folder / "liver.raw", "my only copy");
  const std::vector<std::string> layout{"--raw", "8x8x8:u16:0.5"};
  const auto import = [&](const std::string& output) {
    return std::vector<std::string>{"import", folder / "scan.raw", "--raw", "8x8x8:u16:0.5", "-o", folder / output};
  };
  expectRefused(import("scan.mhd"), 2, folder, {"scan.raw"});
  expectRefused(import("liver.mhd"), 2, folder, {"liver.raw"});
  ASSERT_EQ(run(import("new.mhd")).status, 0);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"liver.raw", "new.mhd", "new.raw", "scan.raw"}));
  EXPECT_EQ(run(import("new.mhd")).status, 0) << "a pair of its own is replaced";
  EXPECT_TRUE(readVolume(folder / "new.mhd"));
}

TEST(CommandOutputs, NoReportIsWrittenOverAnythingThatIsRead) {
  const TemporaryFolder folder;
  const auto refuses = [&](std::vector<std::string> words, const std::string& file) {
    words.insert(words.end(), {"--report", folder / file});
    SCOPED_TRACE(words.front() + " over " + file);
    expectRefused(words, 2, folder, {file});
  };
  makeSmallCase(folder.path());
  writeText(folder / "pose.txt", kIdentityPose + "\n");
  writeText(folder / "s.raw", std::string(512, 'v'));
  writeText(folder / "p.json", readText((*resourceFolder() / "probes" / "linear-12.json").string()));
  ASSERT_TRUE(writeVolume(rampVolume({8, 8, 8}), folder / "v.mhd"));
  fs::rename(folder / "v.raw", folder / "samples.bin");
  auto header = readText(folder / "v.mhd");
  header.replace(header.find("v.raw"), 5, "samples.bin");
  writeText(folder / "v.mhd", header);
  fs::create_directory(folder / "pictures");
  ASSERT_TRUE(writeImage(viewOf(GreyImage(8, 8, 1)), 1.0, folder / "pictures/1.png"));

  refuses({"case", "validate", folder / "case.json"}, "case.json");
  fs::create_directories(folder / "many/a");
  writeText(folder / "many/a/case.json", "{");
  refuses({"case", "list", folder / "many"}, "many/a/case.json");
  for (const char* file : {"case.json", "patient.json", "ball.json", "sweeps/upper.json"})
    refuses({"case", "validate", folder.path().string()}, file);
  refuses({"import", folder / "s.raw", "--raw", "8x8x8:u8:1", "-o", folder / "s.mha"}, "s.raw");
  refuses({"import", folder / "pictures", "--spacing", "1", "-o", folder / "o.mha"}, "pictures/1.png");
  refuses({"slice", folder / "v.mhd", "--pose", folder / "pose.txt", "-o", folder / "o.png"}, "pose.txt");
  refuses({"slice", folder / "v.mhd", "--pose", kIdentityPose, "-o", folder / "o.png"}, "samples.bin");
  refuses({"scan", folder / "v.mhd", "--probe", folder / "p.json", "--pose", kIdentityPose, "-o", folder / "o.mha"}, "p.json");
  refuses({"phantom", folder / "patient.json", "--truth", folder / "t.json"}, "ball.json");
#ifdef EW_WITH_STITCHING
  writeText(folder / "project.json", R"({"volumes": [{"file": "v.mhd"}]})");
  refuses({"stitch", folder / "project.json", "-o", folder / "out"}, "project.json");
  refuses({"stitch", folder / "project.json", "-o", folder / "out"}, "samples.bin");
#endif
}

TEST(CommandOutputs, ThatWereThereStayWhenALaterOneCannotBeWritten) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeSequence(parallelSweep(6, 5, 4), folder / "s.igs.mha"));
  const std::vector<std::string> words{"reconstruct", folder / "s.igs.mha", "--spacing", "1", "-o", folder / "v.mhd", "--threads", "1"};
  ASSERT_EQ(run(words).status, 0);
  writeText(folder / "v.mhd", readText(folder / "v.mhd") + "Comment = the earlier one\n");
  fs::create_directory(folder / "c.mha");
  auto failing = words;
  failing.insert(failing.end(), {"--coverage", folder / "c.mha"});
  expectRefused(failing, 1, folder, {"v.mhd", "v.raw"});
  std::atomic<bool> cancel{true};
  const auto before = readText(folder / "v.mhd");
  const auto stopped = run(words, &cancel);
  EXPECT_EQ(stopped.status, 1);
  EXPECT_NE(stopped.err.find("nothing was written"), std::string::npos) << stopped.err;
  EXPECT_EQ(readText(folder / "v.mhd"), before);
}

TEST(CommandOutputs, ANameAsLongAsAFileMayHaveIsWritten) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(rampVolume({8, 8, 8}), folder / "v.mha"));
  const std::string longest = std::string(251, 'n') + ".png", tooLong = std::string(252, 'n') + ".png";
  EXPECT_EQ(run({"slice", folder / "v.mha", "--pose", kIdentityPose, "-o", folder / longest}).status, 0);
  EXPECT_TRUE(fs::exists(folder / longest));
  const auto refused = run({"slice", folder / "v.mha", "--pose", kIdentityPose, "-o", folder / tooLong});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("too long"), std::string::npos) << refused.err;
}

TEST(CommandOutputs, AnInvalidCaseIsReportedToo) {
  const TemporaryFolder folder;
  writeText(folder / "case.json", R"({"format": 1, "id": "a", "title": 3, "volume": {}})");
  const auto outcome = run({"case", "validate", folder / "case.json", "--report", folder / "r.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("correct what is listed"), std::string::npos) << outcome.err;
  const auto report = readJson(folder / "r.json");
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report["problems"].size(), report["quality"]["problems"]);
  EXPECT_FALSE(report["problems"].empty());
}

TEST(CommandOutputs, OptionsOutsideWhatAMethodTakesAreRefusedBeforeAnythingIsRead) {
  for (const auto& [option, value] : {std::pair{"--step-turn", "1"}, std::pair{"--step-turn", "1.99"}, std::pair{"--least-overlap", "1"},
                                      std::pair{"--node", "0.5"}, std::pair{"--max-motion", "60"}}) {
    const bool elastic = std::string(option) == "--node" || std::string(option) == "--max-motion";
    const auto outcome =
        run({"register", "none.mha", "none.mha", "--method", elastic ? "elastic3d" : "partial", "-o", "t.txt", option, value});
    EXPECT_EQ(outcome.status, 2) << option << outcome.err;
    EXPECT_NE(outcome.err.find(option), std::string::npos) << outcome.err;
  }
}

TEST(CommandOutputs, RecordingsOfSeveralCasesLieInAFolderOfEach) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  for (const char* name : {"one", "two"}) {
    makeSmallCase(folder.path() / name);
    auto manifest = readJson(folder / (std::string(name) + "/case.json"));
    manifest["volume"]["sweeps"] = {"sweeps/upper.json"};
    writeText(folder / (std::string(name) + "/case.json"), manifest.dump());
  }
  auto sweep = readJson(folder / "two/sweeps/upper.json");  // another recording of the same name
  sweep["frames"] = 5;
  writeText(folder / "two/sweeps/upper.json", sweep.dump());
  fs::create_directories(folder / "kept/two");
  writeText(folder / "kept/two/upper.xml", "mine");
  const std::vector<std::string> words{"case", "prepare", folder / "one", folder / "two", "--keep-sweeps", folder / "kept"};
  EXPECT_EQ(run(words).status, 1) << "something is there already";
  EXPECT_EQ(readText(folder / "kept/two/upper.xml"), "mine");
  EXPECT_FALSE(fs::exists(folder / "kept/one"));
  fs::remove_all(folder / "kept/two");
  const auto prepared = run(words);
  ASSERT_EQ(prepared.status, 0) << prepared.err;
  const auto first = readSequence(folder / "kept/one/upper.igs.mha"), second = readSequence(folder / "kept/two/upper.igs.mha");
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_EQ(first->frames.size(), 10u);
  EXPECT_EQ(second->frames.size(), 5u);
  EXPECT_TRUE(fs::exists(folder / "kept/one/upper.xml"));
}

#ifdef EW_WITH_STITCHING
TEST(CommandOutputs, AStoppedStitchSaysItselfWhatItKept) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(rampVolume({8, 8, 8}), folder / "v.mha"));
  writeText(folder / "project.json", R"({"volumes": [{"file": "v.mha"}, {"file": "v.mha"}]})");
  const std::atomic<bool> cancel{true};
  const auto outcome = run({"stitch", folder / "project.json", "-o", folder / "out"}, &cancel);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err.find("nothing was written"), std::string::npos) << outcome.err;
}
#endif

}  // namespace
}  // namespace ew::test::outputs_test
