#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "library/temporary_folder.h"

namespace ew {
namespace {

using test::EnvironmentValue;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

class CancelAtOnce final : public Progress {
 public:
  void report(std::string_view, double) override {}
  bool cancelRequested() const override { return true; }
};

/// The recipe of a shipped case, voxelised so coarsely that it takes no time.
Case coarseCase(const std::filesystem::path& folder) {
  const auto shipped = shippedCasesFolder();
  EXPECT_TRUE(shipped);
  for (const auto& each : listCases(*shipped).cases)
    if (!each.volume.recipe.empty()) {
      writeText(folder / "patient.json", textOf(each.folder / each.volume.recipe));
      break;
    }
  Case made;
  made.id = "coarse";
  made.title = "Coarse";
  made.volume.recipe = "patient.json";
  made.volume.recipeSpacing_mm = 9.0;
  made.folder = folder;
  EXPECT_TRUE(saveCase(made, folder));
  return made;
}

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, ignored))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

TEST(LoadCaseVolume, PlacesTheVolumeOfAFile) {
  const TemporaryFolder folder;
  Volume volume;
  volume.grid.dims = {3, 4, 5};
  volume.echo.assign(60, 7);
  ASSERT_TRUE(writeVolume(volume, folder / "a.mha"));
  Case made;
  made.id = made.title = "x";
  made.volume.file = "a.mha";
  made.volume.fileToWorld = glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {10, 20, 30, 1});
  made.folder = folder.path();
  EXPECT_FALSE(caseNeedsPreparation(made));
  const auto echo = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(echo) << echo.error();
  EXPECT_EQ(echo->volume.echo, volume.echo);
  EXPECT_EQ(echo->volume.grid.origin_mm, glm::dvec3(10, 20, 30));
  EXPECT_EQ(echo->volume.grid.directions[0], glm::dvec3(0, 1, 0));
}

TEST(LoadCaseVolume, MakesARecipeOnceAndThenReadsItFromTheCache) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  const Case made = coarseCase(folder / "case");
  EXPECT_TRUE(caseNeedsPreparation(made));
  const auto first = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(first) << first.error();
  EXPECT_TRUE(first->notes.empty()) << first->notes.front();
  EXPECT_FALSE(caseNeedsPreparation(made));
  const auto second = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(second);
  EXPECT_EQ(second->volume.echo, first->volume.echo);
  EXPECT_EQ(second->volume.coverage, first->volume.coverage);
  EXPECT_EQ(second->volume.grid.dims, first->volume.grid.dims);
  EXPECT_LT(glm::length(second->volume.grid.origin_mm - first->volume.grid.origin_mm), 1e-9);

  Case finer = made;
  finer.volume.recipeSpacing_mm = 8.0;
  EXPECT_TRUE(caseNeedsPreparation(finer)) << "another spacing is another volume";
  auto recipe = nlohmann::json::parse(textOf(folder / "case/patient.json"));
  recipe["tissues"][0]["echo_level"] = 77;
  writeText(folder / "case/patient.json", recipe.dump());
  EXPECT_TRUE(caseNeedsPreparation(made)) << "another recipe is another volume";
}

TEST(LoadCaseVolume, MakesABrokenCacheFileAgain) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  const Case made = coarseCase(folder / "case");
  const auto first = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(first);
  const auto files = filesIn(folder / "cache");
  ASSERT_EQ(files.size(), 3u);
  for (const auto& file : files) {
    for (const int damage : {0, 1, 2}) {
      const std::string whole = textOf(file);
      if (damage == 0) writeText(file, whole.substr(0, whole.size() / 2));  // cut off
      if (damage == 1) writeText(file, "");
      if (damage == 2) {  // one bit, which no header betrays
        std::string flipped = whole;
        flipped[flipped.size() - 5] = static_cast<char>(flipped[flipped.size() - 5] ^ 1);
        writeText(file, flipped);
      }
      const auto again = loadCaseVolume(made, noProgress());
      ASSERT_TRUE(again) << file << again.error();
      EXPECT_EQ(again->volume.echo, first->volume.echo) << file << " damage " << damage;
      EXPECT_EQ(again->volume.coverage, first->volume.coverage) << file << " damage " << damage;
      EXPECT_EQ(again->notes.size(), 1u) << file << " damage " << damage;
      EXPECT_TRUE(loadCaseVolume(made, noProgress())->notes.empty()) << "mended";
    }
  }
}

TEST(LoadCaseVolume, TwoProcessesMayMakeTheSameVolumeAtOnce) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  const Case made = coarseCase(folder / "case");
  std::vector<pid_t> children;
  for (int n = 0; n < 3; ++n) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const auto echo = loadCaseVolume(made, noProgress());
      ::_exit(echo && echo->notes.empty() ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  const auto echo = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(echo);
  EXPECT_TRUE(echo->notes.empty());
  EXPECT_EQ(filesIn(folder / "cache").size(), 3u) << "nothing aside is left behind";
}

TEST(LoadCaseVolume, OpensTheCaseAlsoWhenTheCacheCannotBeWritten) {
  const TemporaryFolder folder;
  writeText(folder / "file", "where the cache folder would have to be");
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "file");
  const auto echo = loadCaseVolume(coarseCase(folder / "case"), noProgress());
  ASSERT_TRUE(echo) << echo.error();
  EXPECT_GT(echo->volume.echo.size(), 0u);
  EXPECT_EQ(echo->notes.size(), 1u);
}

TEST(LoadCaseVolume, LeavesNothingInTheCacheWhenItIsCancelled) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  CancelAtOnce cancel;
  const auto echo = loadCaseVolume(coarseCase(folder / "case"), cancel);
  ASSERT_FALSE(echo);
  EXPECT_EQ(echo.error().code, ErrorCode::cancelled);
  EXPECT_TRUE(filesIn(folder / "cache").empty());
}

}  // namespace
}  // namespace ew
