#include "ew/library/published.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ew/library/case.h"
#include "ew/library/checksums.h"
#include "ew/library/content_name.h"
#include "library/bundle_world.h"

namespace ew::test::published_test {
namespace {

namespace fs = std::filesystem;

ino_t numberOf(const fs::path& file) {
  struct stat found {};
  return ::stat(file.c_str(), &found) == 0 ? found.st_ino : 0;
}

std::vector<std::string> filesOf(const CaseCheck& check) {
  std::vector<std::string> files;
  for (const Error& problem : check.problems)
    for (const auto& [key, value] : problem.context)
      if (key == "file") files.push_back(value);
  return files;
}

TEST(PublishCase, MakesRevisionsThatHoldWhatTheCaseWas) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const std::string first = textOf(folder / "mine/case.json");
  const auto one = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(one) << one.error();
  EXPECT_EQ(one->revision, 1);
  writeText(folder / "mine/case.json", manifestOfVolumeCase("knee", "Another title").dump());
  const auto two = publishCase(folder / "mine/case.json", folder / "library");
  ASSERT_TRUE(two) << two.error();
  EXPECT_EQ(two->revision, 2);
  EXPECT_EQ(textOf(one->folder / "case.json"), first) << "byte for byte";
  EXPECT_EQ(loadCase(two->folder)->title, "Another title");
  for (const auto& each : {*one, *two}) EXPECT_TRUE(verifyCase(each.folder)->problems.empty());
  EXPECT_EQ(publishedRevisions(folder / "library", "knee").size(), 2u);
  const auto listed = listPublished(folder / "library");
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(listed.front(), *two);
}

TEST(PublishCase, OfAnUnchangedCaseDoesNothing) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  ASSERT_TRUE(publishCase(folder / "mine", folder / "library"));
  const auto before = treeOf(folder / "library");
  const auto again = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->wasThere);
  EXPECT_EQ(treeOf(folder / "library"), before);
}

TEST(PublishedAsItIs, IsTheLatestRevisionUntilTheCaseIsEdited) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto asItIs = [&] { return publishedAsItIs(folder / "mine", folder / "library"); };
  ASSERT_TRUE(asItIs());
  EXPECT_FALSE(*asItIs());
  const auto one = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(one && asItIs() && *asItIs());
  EXPECT_EQ((*asItIs())->folder, one->folder);
  const std::string first = textOf(folder / "mine/scans/expert.txt");
  writeText(folder / "mine/scans/expert.txt", "changed");
  EXPECT_FALSE(*asItIs());
  ASSERT_TRUE(publishCase(folder / "mine", folder / "library"));
  writeText(folder / "mine/scans/expert.txt", first);
  EXPECT_FALSE(*asItIs()) << "as an earlier one had it, but trainees see the latest";
}

TEST(PublishCase, SharesUnchangedVolumesWithTheRevisionBeforeAndNeverWithTheAuthor) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto one = publishCase(folder / "mine", folder / "library");
  writeText(folder / "mine/scans/expert.txt", "changed");
  const auto two = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(one && two);
  EXPECT_EQ(numberOf(one->folder / "volumes/v.mha"), numberOf(two->folder / "volumes/v.mha"));
  EXPECT_NE(numberOf(folder / "mine/volumes/v.mha"), numberOf(two->folder / "volumes/v.mha"));
  EXPECT_NE(numberOf(one->folder / "scans/expert.txt"), numberOf(two->folder / "scans/expert.txt"));
}

TEST(PublishCase, DoesNotHandTheDamageOfARevisionOn) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto one = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(one);
  std::string damaged = textOf(one->folder / "volumes/v.mha");
  damaged.back() = static_cast<char>(damaged.back() ^ 1);
  writeText(one->folder / "volumes/v.mha", damaged);
  writeText(folder / "mine/scans/expert.txt", "changed");
  const auto two = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(two) << two.error();
  EXPECT_TRUE(verifyCase(two->folder)->problems.empty());
  EXPECT_EQ(filesOf(*verifyCase(one->folder)), std::vector<std::string>{"volumes/v.mha"});
}

TEST(PublishedRevision, ThatIsDamagedIsNotHandedOn) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto one = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(one);
  ASSERT_TRUE(exportBundle(one->folder, folder / "good.ewcase"));
  std::string damaged = textOf(one->folder / "volumes/v.mha");
  damaged.back() = static_cast<char>(damaged.back() ^ 1);
  writeText(one->folder / "volumes/v.mha", damaged);
  const auto exported = exportBundle(one->folder, folder / "bad.ewcase");
  ASSERT_FALSE(exported);
  EXPECT_EQ(exported.error().code, ErrorCode::badField);
  EXPECT_EQ(exported.error().sentence().find("The published revision '"), 0u) << exported.error();
  EXPECT_NE(exported.error().sentence().find(
                "published/knee/1' is damaged and is not handed on: \"volumes/v.mha\" is not what was kept: its content has changed; put "
                "the kept file back, or import or publish the case again."),
            std::string::npos)
      << exported.error();
  EXPECT_FALSE(fs::exists(folder / "bad.ewcase"));
  EXPECT_FALSE(publishCase(one->folder, folder / "another library"));
  writeText(one->folder / "more.txt", "more");
  const auto twice = exportBundle(one->folder, folder / "bad.ewcase");
  ASSERT_FALSE(twice);
  EXPECT_NE(twice.error().sentence().find("is damaged in 2 files and is not handed on. The first: \"volumes/v.mha\""), std::string::npos)
      << twice.error();
}

TEST(PublishCase, OfACaseThatCannotBeOpenedLeavesTheLibraryAsItWas) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  fs::remove(folder / "mine/volumes/v.mha");
  EXPECT_FALSE(publishCase(folder / "mine", folder / "library"));
  EXPECT_FALSE(fs::exists(folder / "library"));
  makeVolumeCase(folder / "mine", "knee");
  ASSERT_EQ(::mkfifo((folder / "mine/pipe").c_str(), 0600), 0);
  const auto refused = publishCase(folder / "mine", folder / "library");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("pipe"), std::string::npos) << refused.error();
  EXPECT_FALSE(fs::exists(folder / "library"));
}

TEST(PublishedRevisions, AreTheCompleteOnesAlone) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  for (int n = 1; n <= 4; ++n) {
    writeText(folder / "mine/scans/expert.txt", std::to_string(n));
    ASSERT_TRUE(publishCase(folder / "mine", folder / "library"));
  }
  const fs::path published = folder / "library/published/knee";
  fs::remove(published / "4/volumes/v.mha");           // as a copying that was broken off leaves it
  fs::resize_file(published / "3/volumes/v.mha", 10);  // (which shortens the others' too: they share it)
  fs::create_directories(published / "9");             // no sums at all
  fs::create_directories(published / "01");            // no number
  writeText(folder / "library/published/stray.txt", "stray");
  EXPECT_FALSE(latestPublished(folder / "library", "knee"));
  fs::copy_file(folder / "mine/volumes/v.mha", published / "2/new.mha");
  fs::rename(published / "2/new.mha", published / "2/volumes/v.mha");
  EXPECT_EQ(latestPublished(folder / "library", "knee")->revision, 2);
  writeText(folder / "mine/scans/expert.txt", "5");
  EXPECT_EQ(publishCase(folder / "mine", folder / "library")->revision, 10) << "no number is given twice";
  EXPECT_FALSE(latestPublished(folder / "library", "../knee"));
}

TEST(IsPublished, KnowsARevisionOfAnyLibraryAlsoThroughALink) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto one = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(one);
  EXPECT_TRUE(isPublished(one->folder / "volumes"));
  fs::create_directory_symlink(one->folder, folder / "link");
  EXPECT_TRUE(isPublished(folder / "link"));
  EXPECT_FALSE(isPublished(folder / "mine"));
  EXPECT_FALSE(isPublished(folder / "library/published/knee/7"));
}

TEST(SaveCase, ElsewhereLeavesTheLibrarysSumsAndLeasesBehind) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto one = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(one);
  writeText(one->folder / ".ew-lease-1", "{}");
  auto opened = loadCase(one->folder);
  ASSERT_TRUE(opened);
  ASSERT_TRUE(saveCase(*opened, folder / "copy"));
  EXPECT_FALSE(fs::exists(folder / "copy/sums.json"));
  EXPECT_FALSE(fs::exists(folder / "copy/.ew-lease-1"));
  EXPECT_TRUE(fs::exists(folder / "copy/volumes/v.mha"));
  EXPECT_FALSE(verifyCase(folder / "copy")->hasSums);
}

TEST(VerifyCase, NamesWhatIsMissingChangedAndMore) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto one = publishCase(folder / "mine", folder / "library");
  ASSERT_TRUE(one);
  fs::remove(one->folder / "scans/expert.txt");
  writeText(one->folder / "media/übersicht.txt", "An image of SORTS.");
  writeText(one->folder / "more.txt", "more");
  writeText(one->folder / ".hidden", "not part of it");
  const auto check = verifyCase(one->folder);
  ASSERT_TRUE(check);
  EXPECT_EQ(filesOf(*check), (std::vector<std::string>{"media/übersicht.txt", "scans/expert.txt", "more.txt"}));
  ASSERT_EQ(check->problems.size(), 3u);
  EXPECT_NE(check->problems[0].sentence().find("has changed"), std::string::npos);
  EXPECT_NE(check->problems[1].sentence().find("missing"), std::string::npos);
  EXPECT_NE(check->problems[2].sentence().find("does not belong"), std::string::npos);
}

TEST(VerifyCase, OfAnAuthorsCaseSaysWhatCanBeSaidWithoutSums) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  auto check = verifyCase(folder / "mine");
  ASSERT_TRUE(check);
  EXPECT_FALSE(check->hasSums);
  EXPECT_TRUE(check->problems.empty());
  const auto name = addVolume(noisyVolume({5, 5, 5}, 4), folder / "mine");
  ASSERT_TRUE(name);
  EXPECT_TRUE(verifyCase(folder / "mine")->problems.empty());
  writeText(folder / "mine" / *name, "something else");
  check = verifyCase(folder / "mine");
  ASSERT_EQ(check->problems.size(), 1u);
  EXPECT_NE(check->problems[0].sentence().find(*name), std::string::npos);
  EXPECT_EQ(verifyCase(folder / "nowhere").error().code, ErrorCode::notFound);
}

}  // namespace
}  // namespace ew::test::published_test
