#include "ew/library/bundle.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <clocale>
#include <cstdio>
#include <vector>

#include "ew/library/case.h"
#include "ew/library/published.h"
#include "library/bundle_world.h"
#include "library/small_case.h"

namespace ew::test::bundle_test {
namespace {

namespace fs = std::filesystem;

/// Cancels as soon as anything was reported so often.
class StopAt final : public Progress {
 public:
  explicit StopAt(int reports) : left_(reports) {}
  void report(const Message&, double fraction) override {
    --left_;
    EXPECT_GE(fraction, last_) << "progress moved backwards";
    last_ = fraction;
  }
  [[nodiscard]] bool cancelRequested() const override { return left_ <= 0; }

 private:
  int left_;
  double last_ = 0.0;
};

TEST(Bundle, BringsACaseToAnotherLibraryFileByFile) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto exported = exportBundle(folder / "mine", folder / "knee.ewcase");
  ASSERT_TRUE(exported) << exported.error();
  EXPECT_EQ(exported->id, "knee");
  EXPECT_EQ(exported->revision, 0);
  EXPECT_EQ(exported->files.size(), 4u);
  const auto header = readBundleHeader(folder / "knee.ewcase");
  ASSERT_TRUE(header) << header.error();
  EXPECT_EQ(*header, *exported);
  ASSERT_TRUE(verifyBundle(folder / "knee.ewcase"));

  const auto imported = importBundle(folder / "knee.ewcase", folder / "library");
  ASSERT_TRUE(imported) << imported.error();
  EXPECT_EQ(imported->folder, folder / "library/published/knee/1");
  EXPECT_FALSE(imported->wasThere);
  for (const FileSum& each : exported->files)
    EXPECT_EQ(textOf(imported->folder / each.path), textOf(folder / "mine" / each.path)) << each.path;
  EXPECT_TRUE(loadCase(imported->folder));
  EXPECT_TRUE(isPublished(imported->folder));
  EXPECT_FALSE(isPublished(folder / "mine"));
  const auto check = verifyCase(imported->folder);
  ASSERT_TRUE(check);
  EXPECT_TRUE(check->hasSums);
  EXPECT_TRUE(check->problems.empty()) << check->problems.front();
}

TEST(Bundle, OfTheSameCaseIsTheSameByteByByteWhereverAndWheneverItIsMade) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "one", "knee");
  fs::copy(folder / "one", folder / "other", fs::copy_options::recursive);
  fs::last_write_time(folder / "other/case.json", fs::file_time_type::clock::now() - std::chrono::hours(1000));
  fs::permissions(folder / "other/scans/expert.txt", fs::perms::owner_all);
  ASSERT_TRUE(exportBundle(folder / "one", folder / "1.ewcase"));
  ASSERT_TRUE(exportBundle(folder / "other", folder / "2.ewcase"));
  EXPECT_EQ(textOf(folder / "1.ewcase"), textOf(folder / "2.ewcase"));
}

TEST(Bundle, KeepsNamesInAnyLanguageWhateverTheLocale) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const std::string deep = "media/" + std::string(90, 'd') + "/" + std::string(90, 'e') + "/größe 超音波.txt";
  writeText(folder / "mine" / deep, "deep");
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"C", "C.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, locale), nullptr);
    ASSERT_TRUE(exportBundle(folder / "mine", folder / (std::string(locale) + ".ewcase")));
    const auto imported = importBundle(folder / (std::string(locale) + ".ewcase"), folder / locale);
    ASSERT_TRUE(imported) << imported.error();
    EXPECT_EQ(textOf(imported->folder / deep), "deep");
    EXPECT_EQ(textOf(imported->folder / "media/übersicht.txt"), "An image of sorts.");
  }
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(textOf(folder / "C.ewcase"), textOf(folder / "C.UTF-8.ewcase"));
}

TEST(Bundle, OfTheSameContentIsTakenInOnceAndOfAnotherAsTheNextRevision) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "1.ewcase"));
  ASSERT_TRUE(importBundle(folder / "1.ewcase", folder / "library"));
  const auto before = treeOf(folder / "library");
  const auto again = importBundle(folder / "1.ewcase", folder / "library");
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->wasThere);
  EXPECT_EQ(again->revision, 1);
  EXPECT_EQ(treeOf(folder / "library"), before);

  writeText(folder / "mine/scans/expert.txt", "another path");
  ASSERT_TRUE(publishCase(folder / "mine", folder / "author"));
  ASSERT_TRUE(exportBundle(folder / "author/published/knee/1", folder / "2.ewcase"));
  EXPECT_EQ(readBundleHeader(folder / "2.ewcase")->revision, 1) << "the author's first revision";
  const auto next = importBundle(folder / "2.ewcase", folder / "library");
  ASSERT_TRUE(next) << next.error();
  EXPECT_EQ(next->revision, 2) << "1 is another content here";
  EXPECT_EQ(latestPublished(folder / "library", "knee")->revision, 2);
}

TEST(Bundle, ThatManyTakeInAtOnceIsOneRevision) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "knee.ewcase"));
  constexpr int kTakers = 6;
  // Programs of their own, which begin together: whoever reads the pipe goes on when it is closed.
  int gate[2];
  ASSERT_EQ(::pipe(gate), 0);
  std::vector<pid_t> takers;
  for (int n = 0; n < kTakers; ++n) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(gate[1]);
      char nothing = 0;
      static_cast<void>(::read(gate[0], &nothing, 1));
      const auto imported = importBundle(folder / "knee.ewcase", folder / "library");
      if (!imported) std::fprintf(stderr, "a taker: %s\n", imported.error().sentence().c_str());  // of a process of its own
      ::_exit(!imported ? 2 : imported->wasThere ? 1 : 0);
    }
    takers.push_back(child);
  }
  ::close(gate[0]);
  ::close(gate[1]);
  int made = 0, found = 0;
  for (const pid_t taker : takers) {
    int status = 0;
    ASSERT_EQ(::waitpid(taker, &status, 0), taker);
    ASSERT_TRUE(WIFEXITED(status));
    made += WEXITSTATUS(status) == 0 ? 1 : 0;
    found += WEXITSTATUS(status) == 1 ? 1 : 0;
  }
  EXPECT_EQ(made, 1);
  EXPECT_EQ(found, kTakers - 1);
  EXPECT_EQ(publishedRevisions(folder / "library", "knee").size(), 1u);
  EXPECT_EQ(takenPublished(folder / "library", "knee").size(), 1u);
}

TEST(Bundle, KeepsTheRevisionThatItWasPublishedAsWhereThatIsFree) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  for (int n = 1; n <= 3; ++n) {
    writeText(folder / "mine/scans/expert.txt", std::to_string(n));
    ASSERT_TRUE(publishCase(folder / "mine", folder / "author"));
  }
  ASSERT_TRUE(exportBundle(folder / "author/published/knee/3", folder / "3.ewcase"));
  ASSERT_TRUE(exportBundle(folder / "author/published/knee/2", folder / "2.ewcase"));
  EXPECT_EQ(importBundle(folder / "3.ewcase", folder / "library")->revision, 3);
  EXPECT_EQ(importBundle(folder / "2.ewcase", folder / "library")->revision, 2);
  EXPECT_EQ(latestPublished(folder / "library", "knee")->revision, 3) << "an older one that came late is not the latest";
}

TEST(Bundle, CarriesAVirtualPatientAsItsRecipe) {
  const TemporaryFolder folder;
  makeSmallCase(folder / "mine");
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "small.ewcase"));
  const auto imported = importBundle(folder / "small.ewcase", folder / "library");
  ASSERT_TRUE(imported) << imported.error();
  EXPECT_TRUE(validateCase(imported->folder).empty());
}

TEST(Bundle, LeavesOutWhatIsHiddenAndTheLibrarysOwnSums) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "bare.ewcase"));
  writeText(folder / "mine/.drafts/case.json", "{}");
  writeText(folder / "mine/.ew-lease-3", "{}");
  writeText(folder / "mine/volumes/.v.mha.part", "half");
  writeText(folder / "mine/sums.json", "{}");
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "full.ewcase"));
  EXPECT_EQ(textOf(folder / "bare.ewcase"), textOf(folder / "full.ewcase"));
}

TEST(Bundle, OfACaseThatNeedsAHiddenFileIsRefused) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  fs::rename(folder / "mine/volumes/v.mha", folder / "mine/volumes/.v.mha");
  auto manifest = manifestOfVolumeCase("knee");
  manifest["volume"]["file"] = "volumes/.v.mha";
  writeText(folder / "mine/case.json", manifest.dump());
  ASSERT_TRUE(loadCase(folder / "mine"));
  const auto refused = exportBundle(folder / "mine", folder / "x.ewcase");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("volumes/.v.mha"), std::string::npos) << refused.error();
  EXPECT_FALSE(fs::exists(folder / "x.ewcase"));
}

TEST(Bundle, NeverFollowsALinkOutOfTheCaseFolder) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  writeText(folder / "secret/key.txt", "secret");
  const auto refuses = [&](const fs::path& link) {
    const auto refused = exportBundle(folder / "mine", folder / "x.ewcase");
    ASSERT_FALSE(refused) << link;
    EXPECT_NE(refused.error().sentence().find(link.filename().string()), std::string::npos) << refused.error();
    EXPECT_NE(refused.error().sentence().find("link"), std::string::npos) << refused.error();
    EXPECT_FALSE(fs::exists(folder / "x.ewcase"));
    fs::remove(link);
  };
  fs::create_symlink(folder / "secret/key.txt", folder / "mine/notes.txt");
  refuses(folder / "mine/notes.txt");
  fs::create_directory_symlink(folder / "secret", folder / "mine/more");
  refuses(folder / "mine/more");
  fs::create_symlink("nowhere", folder / "mine/broken.txt");
  refuses(folder / "mine/broken.txt");
  fs::create_symlink("scans/expert.txt", folder / "mine/inside.txt");
  const auto exported = exportBundle(folder / "mine", folder / "x.ewcase");
  ASSERT_TRUE(exported) << exported.error();
  const auto imported = importBundle(folder / "x.ewcase", folder / "library");
  ASSERT_TRUE(imported);
  EXPECT_FALSE(fs::is_symlink(imported->folder / "inside.txt"));
  EXPECT_EQ(textOf(imported->folder / "inside.txt"), std::string(3000, 'p')) << "a link within the folder stands for its file";
}

TEST(Bundle, ThatIsStoppedLeavesNothingBehind) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee", {200, 200, 100});
  fs::create_directory(folder / "out");
  int stops = 0;
  for (const int reports : {1, 2, 3, 5, 8, 12}) {
    StopAt stop(reports);
    const auto exported = exportBundle(folder / "mine", folder / "out/x.ewcase", stop);
    if (exported) break;
    ++stops;
    EXPECT_EQ(exported.error().code, ErrorCode::cancelled) << exported.error();
    EXPECT_EQ(treeOf(folder / "out").size(), 1u);
  }
  EXPECT_GE(stops, 3);
  ASSERT_TRUE(exportBundle(folder / "mine", folder / "x.ewcase"));
  stops = 0;
  for (const int reports : {1, 2, 3, 4}) {
    StopAt stop(reports);
    const auto imported = importBundle(folder / "x.ewcase", folder / "library", {}, stop);
    if (imported) break;
    ++stops;
    EXPECT_EQ(imported.error().code, ErrorCode::cancelled) << imported.error();
    EXPECT_FALSE(fs::exists(folder / "library"));
  }
  EXPECT_GE(stops, 3);
}

TEST(Bundle, ReplacesAnEarlierOneOnlyWhenTheNewOneIsComplete) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  writeText(folder / "x.ewcase", "the earlier one");
  writeText(folder / "mine/case.json", "{");
  EXPECT_FALSE(exportBundle(folder / "mine", folder / "x.ewcase"));
  EXPECT_EQ(textOf(folder / "x.ewcase"), "the earlier one");
  writeText(folder / "mine/case.json", manifestOfVolumeCase("knee").dump());
  EXPECT_EQ(exportBundle(folder / "mine", folder / "x.tar").error().code, ErrorCode::badUsage);
  EXPECT_TRUE(exportBundle(folder / "mine", folder / "x.ewcase"));
  EXPECT_TRUE(verifyBundle(folder / "x.ewcase"));
}

}  // namespace
}  // namespace ew::test::bundle_test
