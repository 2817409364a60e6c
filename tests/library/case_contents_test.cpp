#include "ew/library/case_contents.h"

#include <gtest/gtest.h>

#include "ew/library/bundle.h"
#include "ew/library/checksums.h"
#include "ew/library/folder_lease.h"
#include "ew/library/published.h"
#include "library/bundle_world.h"

namespace ew::test::case_contents_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// "its volume, the lesson 'First'" of a file; "nothing", or "not there".
std::string useOf(const Case& opened, const std::string& path) {
  const auto files = fileUsesOf(opened);
  EXPECT_TRUE(files) << files.error();
  if (files)
    for (const CaseFileUse& each : *files)
      if (each.path == path) return each.usedBy.empty() ? "nothing" : joined(each.usedBy, ", ").english();
  return "not there";
}

class ContentsOfACase : public ::testing::Test {
 protected:
  void SetUp() override {
    makeVolumeCase(folder_ / "knee", "knee");
    ASSERT_TRUE(writeVolume(noisyVolume({6, 6, 6}, 5), folder_ / "knee/volumes/other.mha"));
    for (const char* each : {"media/übersicht.txt", "scans/expert.txt"}) fs::remove(folder_ / "knee" / each);
    writeText(folder_ / "knee/README.md", "A knee.");
  }
  [[nodiscard]] fs::path knee() const { return folder_ / "knee"; }
  [[nodiscard]] Case opened() const {
    auto read = loadCase(knee());
    EXPECT_TRUE(read) << read.error();
    return read ? *read : Case();
  }
  void change(const std::function<void(json&)>& edit) const {
    json manifest = json::parse(textOf(knee() / "case.json"));
    edit(manifest);
    writeText(knee() / "case.json", manifest.dump());
  }
  const TemporaryFolder folder_;
};

TEST_F(ContentsOfACase, AreSaidWithWhatUsesThem) {
  writeText(knee() / "media/lump.png", "picture");
  writeText(knee() / "media/odd.bin", "bytes");
  writeText(knee() / "parts/placing/pairs.bin", "pairs");
  change([](json& manifest) {
    manifest["previous_examinations"] = {
        {{"when", "then"}, {"kind", "ultrasound"}, {"findings", "A lump."}, {"pictures", {"media/lump.png"}}}};
    manifest["a_field_of_tomorrow"] = {{"file", "media/odd.bin"}};
  });
  const Case knee = opened();
  EXPECT_EQ(useOf(knee, "case.json"), "the case itself");
  EXPECT_EQ(useOf(knee, "volumes/v.mha"), "its volume");
  EXPECT_EQ(useOf(knee, "media/lump.png"), "an earlier examination");
  EXPECT_EQ(useOf(knee, "media/odd.bin"), "case.json, which names it");
  EXPECT_EQ(useOf(knee, "parts/placing/pairs.bin"), "the part 'placing'");
  EXPECT_EQ(useOf(knee, "README.md"), "readers, as words or a document");
  EXPECT_EQ(useOf(knee, "volumes/other.mha"), "nothing");
  EXPECT_EQ(unusedFiles(knee), std::vector<std::string>{"volumes/other.mha"});
}

TEST_F(ContentsOfACase, HoldSamplesBesideTheirHeaderAndWhatALinkLeadsTo) {
  ASSERT_TRUE(writeVolume(noisyVolume({20, 20, 20}, 1), knee() / "volumes/w.mhd"));
  ASSERT_TRUE(fs::exists(knee() / "volumes/w.raw"));
  change([](json& manifest) { manifest["volume"]["file"] = "volumes/w.mhd"; });
  EXPECT_EQ(useOf(opened(), "volumes/w.raw"), "its volume");
  fs::create_symlink("v.mha", knee() / "volumes/link.mha");
  change([](json& manifest) { manifest["volume"]["file"] = "volumes/link.mha"; });
  EXPECT_EQ(useOf(opened(), "volumes/v.mha"), "its volume");
  EXPECT_EQ(useOf(opened(), "volumes/w.raw"), "nothing");
  change([](json& manifest) { manifest["volume"]["file"] = "./volumes/v.mha"; });
  EXPECT_EQ(useOf(opened(), "volumes/v.mha"), "its volume");
}

TEST_F(ContentsOfACase, AreDocumentsWhenTheirNameSaysSo) {
  for (const char* path : {"LICENSE", "media/LICENCE.txt", "source-of-images.md", "ATTRIBUTION.TXT", "words/notes.txt"}) {
    writeText(knee() / path, "text");
    EXPECT_EQ(useOf(opened(), path), "readers, as words or a document") << path;
  }
  for (const char* path : {"report-of-another-patient.txt", "media/notes.md", "sources.png", "readme.mha"}) {
    writeText(knee() / path, "text");
    EXPECT_EQ(useOf(opened(), path), "nothing") << path;
  }
  EXPECT_TRUE(withdrawFiles(opened(), {"report-of-another-patient.txt"}, CaseEditor::nobody));
}

TEST_F(ContentsOfACase, AreUsedByALinkOfTheFolderUnlessItIsTakenOutWithThem) {
  writeText(knee() / "media/old.png", "picture");
  fs::create_symlink("media/old.png", knee() / "link-in");
  fs::create_symlink("link-in", knee() / "link-to-link");
  EXPECT_EQ(useOf(opened(), "media/old.png"), "the link 'link-in', the link 'link-to-link'");
  EXPECT_EQ(useOf(opened(), "link-in"), "the link 'link-to-link'");
  EXPECT_EQ(useOf(opened(), "link-to-link"), "nothing");
  EXPECT_EQ(unusedFiles(opened()), (std::vector<std::string>{"link-to-link", "volumes/other.mha"}));
  const auto before = treeOf(knee());
  const auto held = withdrawFiles(opened(), {"media/old.png", "link-in"}, CaseEditor::nobody);
  ASSERT_FALSE(held);
  EXPECT_EQ(held.error().sentence(), "'media/old.png' is used by the link 'link-in', the link 'link-to-link', and stays.");
  EXPECT_EQ(treeOf(knee()), before);
  EXPECT_TRUE(filesOfCase(knee()));
  const auto taken = withdrawFiles(opened(), {"media/old.png", "link-in", "link-to-link"}, CaseEditor::nobody);
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_TRUE(filesOfCase(knee())) << "no link leads to nothing";
  ASSERT_TRUE(putBack(*taken));
  EXPECT_EQ(treeOf(knee()), before);
}

TEST_F(ContentsOfACase, AreNotLedElsewhereByALink) {
  fs::create_directories(folder_ / "outside");
  fs::create_directory_symlink(folder_ / "outside", knee() / kWithdrawnFiles);
  const auto before = treeOf(knee());
  const auto taken = withdrawFiles(opened(), {"volumes/other.mha"}, CaseEditor::nobody);
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, ErrorCode::notWritable);
  EXPECT_NE(taken.error().sentence().find("is a link or a file, and what is taken out lies in a folder of that name; move it away."),
            std::string::npos)
      << taken.error();
  EXPECT_EQ(treeOf(knee()), before);
  EXPECT_TRUE(fs::is_empty(folder_ / "outside"));
}

TEST_F(ContentsOfACase, AreSaidToBePublishedWhenARevisionHoldsThem) {
  ASSERT_TRUE(publishCase(knee(), folder_ / "library"));
  writeText(knee() / "media/later.png", "picture");
  const auto taken = withdrawFiles(opened(), {"volumes/other.mha", "media/later.png"}, CaseEditor::nobody);
  ASSERT_TRUE(taken) << taken.error();
  const std::vector<std::pair<int, std::vector<std::string>>> held{{1, {"volumes/other.mha"}}};
  EXPECT_EQ(stillPublished(*taken, "knee", folder_ / "library"), held);
  EXPECT_TRUE(stillPublished(*taken, "elbow", folder_ / "library").empty());
}

TEST_F(ContentsOfACase, AreUsedByTheCaseAsItWasSavedToo) {
  Case edited = opened();
  edited.volume.file = "volumes/other.mha";
  EXPECT_EQ(useOf(edited, "volumes/other.mha"), "its volume");
  EXPECT_EQ(useOf(edited, "volumes/v.mha"), "the case as it was saved last");
  EXPECT_EQ(unusedFiles(edited), std::vector<std::string>{"volumes/v.mha"}) << "it would be handed on once that is saved";
  EXPECT_FALSE(withdrawFiles(edited, {"volumes/v.mha"}, CaseEditor::caller));
  ASSERT_TRUE(saveCase(edited, knee()));
  EXPECT_EQ(useOf(edited, "volumes/v.mha"), "nothing");
}

TEST_F(ContentsOfACase, OfLessonsThatCannotBeReadAreUsed) {
  writeText(knee() / "parts/lessons/scans/sweep.seq.mha", "scan");
  EXPECT_EQ(useOf(opened(), "parts/lessons/scans/sweep.seq.mha"), "nothing");
  change([](json& manifest) { manifest["parts"]["lessons"] = {{"format", 1}, {"lessons", "none of them"}}; });
  EXPECT_EQ(useOf(opened(), "parts/lessons/scans/sweep.seq.mha"), "lessons that cannot be read");
}

TEST_F(ContentsOfACase, LeaveItWholeAndComeBackAsTheyWere) {
  writeText(knee() / "media/old.png", "picture");
  const auto before = treeOf(knee());
  const auto taken = withdrawFiles(opened(), {"volumes/other.mha", "media/old.png", "media/old.png"}, CaseEditor::nobody);
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_EQ(taken->paths, (std::vector<std::string>{"media/old.png", "volumes/other.mha"}));
  EXPECT_FALSE(fs::exists(knee() / "media/old.png"));
  EXPECT_EQ(textOf(taken->folder / "media/old.png"), "picture");
  EXPECT_EQ(unusedFiles(opened()), std::vector<std::string>{});
  const auto left = filesOfCase(knee());
  ASSERT_TRUE(left) << left.error();
  for (const FileSum& each : *left) EXPECT_EQ(each.path.find("withdrawn"), std::string::npos) << "they are not handed on";
  const auto aside = withdrawnFilesOf(knee());
  ASSERT_EQ(aside.size(), 1u);
  EXPECT_EQ(aside.front().paths, taken->paths);
  EXPECT_EQ(aside.front().folder, taken->folder);
  ASSERT_TRUE(putBack(aside.front()));
  EXPECT_EQ(treeOf(knee()), before) << "nothing is left of it";
}

TEST_F(ContentsOfACase, StayWhenOneOfThemIsInUseOrNotThere) {
  const auto before = treeOf(knee());
  const auto used = withdrawFiles(opened(), {"volumes/other.mha", "volumes/v.mha"}, CaseEditor::nobody);
  ASSERT_FALSE(used);
  EXPECT_EQ(used.error().code, ErrorCode::badUsage);
  EXPECT_EQ(used.error().sentence(), "'volumes/v.mha' is used by its volume, and stays.");
  writeText(folder_ / "outside.mha", "not of the case");
  for (const std::string& path : {std::string("../outside.mha"), (folder_ / "outside.mha").string(), std::string("volumes"), std::string(),
                                  std::string("volumes/../volumes/other.mha")})
    EXPECT_EQ(withdrawFiles(opened(), {"volumes/other.mha", path}, CaseEditor::nobody).error().code, ErrorCode::notFound) << path;
  EXPECT_EQ(treeOf(knee()), before);
}

TEST_F(ContentsOfACase, StayWhereSomebodyElseAnswersForThem) {
  {
    const auto lease = FolderLease::take(knee());
    ASSERT_TRUE(lease);
    const auto held = withdrawFiles(opened(), {"volumes/other.mha"}, CaseEditor::nobody);
    ASSERT_FALSE(held);
    EXPECT_NE(held.error().sentence().find("is editing the case"), std::string::npos) << held.error();
    EXPECT_TRUE(withdrawFiles(opened(), {"volumes/other.mha"}, CaseEditor::caller));
    ASSERT_TRUE(putBack(withdrawnFilesOf(knee()).front()));
  }
  const auto published = publishCase(knee(), folder_ / "library");
  ASSERT_TRUE(published) << published.error();
  const auto theirs = loadCase(published->folder);
  ASSERT_TRUE(theirs);
  EXPECT_EQ(withdrawFiles(*theirs, {"volumes/other.mha"}, CaseEditor::nobody).error().code, ErrorCode::notWritable);
  Case examination = opened();
  examination.sealed = SealReference{"answers.sealed", std::string(64, '0')};
  const auto sealed = withdrawFiles(examination, {"volumes/other.mha"}, CaseEditor::nobody);
  ASSERT_FALSE(sealed);
  EXPECT_NE(sealed.error().sentence().find("examination"), std::string::npos) << sealed.error();
  EXPECT_TRUE(fs::exists(published->folder / "volumes/other.mha"));
  EXPECT_TRUE(fs::exists(knee() / "volumes/other.mha"));
}

TEST_F(ContentsOfACase, ArePutBackOverNothing) {
  const auto taken = withdrawFiles(opened(), {"volumes/other.mha"}, CaseEditor::nobody);
  ASSERT_TRUE(taken) << taken.error();
  writeText(knee() / "volumes/other.mha", "made meanwhile");
  const auto back = putBack(*taken);
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().code, ErrorCode::notWritable);
  EXPECT_EQ(textOf(knee() / "volumes/other.mha"), "made meanwhile");
  EXPECT_TRUE(fs::exists(taken->folder / "volumes/other.mha"));
}

TEST_F(ContentsOfACase, ThatWereTakenOutDoNotComeWithACopy) {
  ASSERT_TRUE(withdrawFiles(opened(), {"volumes/other.mha"}, CaseEditor::nobody));
  ASSERT_TRUE(saveCase(opened(), folder_ / "copy"));
  EXPECT_TRUE(fs::exists(folder_ / "copy/volumes/v.mha"));
  EXPECT_FALSE(fs::exists(folder_ / ("copy/" + std::string(kWithdrawnFiles))));
  EXPECT_TRUE(fs::exists(knee() / kWithdrawnFiles)) << "those of the case itself stay";
}

}  // namespace
}  // namespace ew::test::case_contents_test
