#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>
#include <atomic>
#include <numeric>

#include <fstream>

#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "library/temporary_folder.h"

namespace ew::case_volume_test {
namespace {

using test::EnvironmentValue;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

class CancelAtOnce final : public Progress {
 public:
  void report(const Message&, double) override {}
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

/// What a volume is read from; locks, the truth for lessons and the machine's speed lie beside it.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, ignored))
    if (const std::string name = entry.path().filename().string();
        entry.is_regular_file() && name != "speed.json" && !name.ends_with(".lock") && entry.path().parent_path().filename() != "truths")
      files.push_back(entry.path());
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
  made.volume.fileToWorld = {glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {10, 20, 30, 1})};
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
  EXPECT_EQ(second->labels->echo, first->labels->echo);
  EXPECT_EQ(second->tissues, first->tissues);
  EXPECT_EQ(second->volume.grid.dims, first->volume.grid.dims);
  EXPECT_LT(glm::length(second->volume.grid.origin_mm - first->volume.grid.origin_mm), 1e-9);

  Case finer = made;
  finer.volume.recipeSpacing_mm = 8.0;
  EXPECT_TRUE(caseNeedsPreparation(finer)) << "another spacing is another volume";
  auto recipe = nlohmann::json::parse(textOf(folder / "case/patient.json"));
  recipe["tissues"] = nlohmann::json::array({{{"name", "skin"}, {"echo_level", 77}}});
  writeText(folder / "case/patient.json", recipe.dump());
  EXPECT_TRUE(caseNeedsPreparation(made)) << "another recipe is another volume";
}

bool isPieces(const std::filesystem::path& file) { return file.filename() == "pieces"; }

/// Stops a preparation once some of it lies in the cache, however fast the machine is.
class StopsOncePiecesAreKept final : public Progress {
 public:
  explicit StopsOncePiecesAreKept(std::filesystem::path cache) : cache_(std::move(cache)) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override {
    if (!stopped_)
      for (const auto& file : filesIn(cache_)) stopped_ = stopped_ || (isPieces(file) && std::filesystem::file_size(file) > 1000);
    return stopped_;
  }

 private:
  std::filesystem::path cache_;
  mutable std::atomic<bool> stopped_{false};
};

TEST(LoadCaseVolume, GoesOnWithARecipeWhereItWasStopped) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  const Case made = coarseCase(folder / "case");
  StopsOncePiecesAreKept stopped(folder / "cache");
  ASSERT_FALSE(loadCaseVolume(made, stopped));
  auto files = filesIn(folder / "cache");
  const auto pieces = std::find_if(files.begin(), files.end(), isPieces);
  ASSERT_NE(pieces, files.end());
  const auto size = std::filesystem::file_size(*pieces);
  ASSERT_GT(size, 1000u);
  std::filesystem::resize_file(*pieces, size - 7);  // as a program leaves it that is killed while it writes
  const auto wentOn = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(wentOn) << wentOn.error();
  files = filesIn(folder / "cache");
  EXPECT_TRUE(std::none_of(files.begin(), files.end(), isPieces)) << "they have done their service";

  const EnvironmentValue other("ECHOWEAVE_CACHE", folder / "other");
  const auto atOnce = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(atOnce);
  EXPECT_EQ(wentOn->volume.echo, atOnce->volume.echo);
  EXPECT_EQ(wentOn->labels->echo, atOnce->labels->echo);
}

/// Sees what becomes of a folder while a case is prepared.
class Watched final : public Progress {
 public:
  explicit Watched(std::filesystem::path folder) : folder_(std::move(folder)) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override {
    std::error_code gone;
    std::filesystem::recursive_directory_iterator at(folder_, gone);
    for (; !gone && at != std::filesystem::recursive_directory_iterator(); at.increment(gone)) {
      isUsed_ = true;
      std::error_code removed;
      const std::uintmax_t bytes = isPieces(at->path()) ? at->file_size(removed) : 0;
      if (!removed && bytes > pieces_bytes_) pieces_bytes_ = bytes;
    }
    return false;
  }
  [[nodiscard]] bool isUsed() const { return isUsed_; }
  [[nodiscard]] std::uintmax_t pieces_bytes() const { return pieces_bytes_; }

 private:
  std::filesystem::path folder_;
  mutable std::atomic<bool> isUsed_{false};
  mutable std::atomic<std::uintmax_t> pieces_bytes_{0};
};

TEST(LoadCaseVolume, OfARecipeThatCannotBeKeptIsPaintedOnceAndOpensAllTheSame) {
  const TemporaryFolder folder;
  const Case made = coarseCase(folder / "case");
  std::filesystem::create_directories(folder / "temporary");
  const EnvironmentValue temporary("TMPDIR", folder / "temporary");
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  writeText(folder / "cache/steps/maps", "where the folder of the maps would have to be");
  Watched aside(folder / "temporary");
  const auto echo = loadCaseVolume(made, aside);
  ASSERT_TRUE(echo) << echo.error();
  EXPECT_FALSE(aside.isUsed()) << "it was painted again in a folder of its own";
  ASSERT_EQ(echo->notes.size(), 1u);
  EXPECT_NE(echo->notes[0].english().find("ECHOWEAVE_CACHE"), std::string::npos) << echo->notes[0];
  const auto files = filesIn(folder / "cache");
  EXPECT_TRUE(std::none_of(files.begin(), files.end(), isPieces)) << "they would take the room of the next start";
  const EnvironmentValue other("ECHOWEAVE_CACHE", folder / "other");
  const auto kept = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_EQ(echo->volume, kept->volume);
  EXPECT_EQ(*echo->tissue, *kept->tissue);
}

TEST(LoadCaseVolume, OfARecipeWithoutACacheKeepsNoPieces) {
  const TemporaryFolder folder;
  const Case made = coarseCase(folder / "case");
  std::filesystem::create_directories(folder / "temporary");
  const EnvironmentValue temporary("TMPDIR", folder / "temporary");
  writeText(folder / "file", "where the cache would have to be");
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "file");
  Watched aside(folder / "temporary");
  const auto echo = loadCaseVolume(made, aside);
  ASSERT_TRUE(echo) << echo.error();
  EXPECT_EQ(echo->notes.size(), 1u);
  EXPECT_TRUE(aside.isUsed());
  EXPECT_EQ(aside.pieces_bytes(), 0u) << "nobody would go on with them";
}

/// Mounts a medium of so many bytes that this process alone sees. @return false where nobody may
bool mountMedium(const std::filesystem::path& at, std::uintmax_t bytes) {
  const auto user = ::geteuid();
  const auto group = ::getegid();
  if (::unshare(CLONE_NEWNS) != 0) {
    if (::unshare(CLONE_NEWNS | CLONE_NEWUSER) != 0) return false;
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
  }
  return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         ::mount("tmpfs", at.c_str(), "tmpfs", 0, ("size=" + std::to_string(bytes)).c_str()) == 0;
}

TEST(LoadCaseVolume, OfARecipeIsKeptWhereThereIsRoomForItOnce) {
  const TemporaryFolder folder;
  Case made = coarseCase(folder / "case");
  made.volume.recipeSpacing_mm = 6.0;
  std::uintmax_t bytes = 0;
  {
    const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
    Watched watched(folder / "cache");
    ASSERT_TRUE(loadCaseVolume(made, watched));
    constexpr std::uintmax_t kPage = 4096;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "cache"))
      if (entry.is_regular_file()) bytes += (entry.file_size() + kPage - 1) / kPage * kPage;
    ASSERT_GT(watched.pieces_bytes(), 256u << 10) << "else there is nothing to be seen here";
    bytes += watched.pieces_bytes() / 2;
  }
  std::filesystem::create_directories(folder / "medium");
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "medium");
  constexpr int kKept = 0, kNot = 1, kNoMedium = 77;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (!mountMedium(folder / "medium", bytes)) ::_exit(kNoMedium);
    const auto echo = loadCaseVolume(made, noProgress());
    ::_exit(echo && echo->notes.empty() && !caseNeedsPreparation(made) ? kKept : kNot);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kNoMedium) GTEST_SKIP() << "no medium can be mounted here";
  EXPECT_EQ(WEXITSTATUS(status), kKept);
}

TEST(LoadCaseVolume, GivesWithARecipeTheTissueOfEveryVoxel) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  auto shipped = loadCase(*shippedCasesFolder() / "upper-abdomen-gall-stone");
  ASSERT_TRUE(shipped) << shipped.error();
  shipped->volume.recipeSpacing_mm = 4.0;
  shipped->volume.sweeps.clear();  // as the anatomy is drawn
  for (const bool fromCache : {false, true}) {
    const auto echo = loadCaseVolume(*shipped, noProgress());
    ASSERT_TRUE(echo) << echo.error();
    ASSERT_TRUE(echo->labels.has_value());
    const Grid& grid = echo->labels->grid;
    EXPECT_EQ(grid, echo->volume.grid);
    const auto tissueAt = [&](const glm::dvec3& p_world) {
      const auto p = glm::ivec3(glm::round(glm::dvec3(grid.worldToVoxel().matrix * glm::dvec4(p_world, 1.0))));
      const int label = echo->labels->echo[grid.indexOf(p.x, p.y, p.z)];
      for (const auto& tissue : echo->tissues)
        if (tissue.label == label) return tissue;
      ADD_FAILURE() << "label " << label << " has no tissue";
      return TissueAcoustics{};
    };
    const auto stone = tissueAt({-51.4, -24.4, -55.2});
    EXPECT_EQ(stone.name, "gall stone") << fromCache;
    EXPECT_GE(stone.reflection_db, 20.0);
    EXPECT_GE(stone.attenuation_dbPerCmMhz, 5.0);
    const auto bile = tissueAt({-59, -47, -66});
    EXPECT_EQ(bile.name, "gall bladder lumen") << fromCache;
    EXPECT_LT(bile.attenuation_dbPerCmMhz, 0.05) << "fluid takes nothing: what lies behind it is enhanced";
    EXPECT_EQ(bile.reflection_db, 0.0);
    EXPECT_LT(tissueAt({13, 25, -50}).attenuation_dbPerCmMhz, 0.25) << "blood of the aorta";
    EXPECT_GE(tissueAt({-20, -55, -122}).reflection_db, 20.0) << "gas in the colon";
  }
}

TEST(LoadCaseVolume, PlacesALabelFileOnItsOwnGridBesideTheEcho) {
  const TemporaryFolder folder;
  Volume echo{{.dims = {3, 4, 5}}, std::vector<std::uint8_t>(60, 7), {}};
  Volume labels{{.dims = {2, 2, 2}, .spacing_mm = {2, 2, 2}, .origin_mm = {1, 0, 0}}, {0, 1, 2, 3, 4, 5, 6, 255}, {}};
  ASSERT_TRUE(writeVolume(echo, folder / "a.mha"));
  ASSERT_TRUE(writeVolume(labels, folder / "l.mha"));
  Case made;
  made.id = made.title = "x";
  made.volume.file = "a.mha";
  made.volume.labels = "l.mha";
  made.volume.fileToWorld = {glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {10, 20, 30, 1})};
  ASSERT_TRUE(saveCase(made, folder.path()));
  const auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(opened->volume.labels, "l.mha");
  const auto found = loadCaseVolume(*opened, noProgress());
  ASSERT_TRUE(found) << found.error();
  ASSERT_TRUE(found->labels.has_value());
  EXPECT_EQ(found->labels->echo, labels.echo);
  EXPECT_EQ(found->labels->grid, placed(labels.grid, made.volume.fileToWorld));
  EXPECT_TRUE(found->tissues.empty()) << "what a label file means is the scene's to say";
}

TEST(LoadCaseVolume, RefusesLabelsThatWouldNotMeanWhatTheyWere) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume({{.dims = {3, 4, 5}}, std::vector<std::uint8_t>(60, 7), {}}, folder / "a.mha"));
  writeText(folder / "l.mha",
            "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_USHORT\nElementDataFile = LOCAL\n" + std::string(16, '\1'));
  Case made;
  made.id = made.title = "x";
  made.volume.file = "a.mha";
  made.volume.labels = "l.mha";
  made.folder = folder.path();
  const auto found = loadCaseVolume(made, noProgress());
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::unsupported);
  EXPECT_NE(found.error().sentence().find("16 bit unsigned"), std::string::npos) << found.error();
  made.volume.labels = "none.mha";
  EXPECT_EQ(loadCaseVolume(made, noProgress()).error().code, ErrorCode::notFound);
}

TEST(CaseManifest, TakesALabelFileUnderTheRulesOfAVolumeFile) {
  const TemporaryFolder folder;
  for (const char* name : {"a.mha", "l.mha", "patient.json"}) writeText(folder / name, "x");
  const auto problemsOf = [&](const nlohmann::json& volume) {
    return checkManifest({{"format", 1}, {"id", "x"}, {"title", "x"}, {"volume", volume}}, folder.path());
  };
  EXPECT_TRUE(problemsOf({{"file", "a.mha"}, {"labels", "l.mha"}}).empty());
  const nlohmann::json refused[] = {{{"file", "a.mha"}, {"labels", "../l.mha"}},
                                    {{"file", "a.mha"}, {"labels", "none.mha"}},
                                    {{"file", "a.mha"}, {"labels", 3}},
                                    {{"recipe", "patient.json"}, {"labels", "l.mha"}}};
  for (const auto& volume : refused) {
    const auto problems = problemsOf(volume);
    ASSERT_EQ(problems.size(), 1u) << volume;
    EXPECT_NE(problems.front().sentence().find("volume.labels"), std::string::npos) << problems.front();
  }
}

TEST(LoadCaseVolume, FormsEchoesOfARecordedVolumeFromTheLevelItsManifestNames) {
  const TemporaryFolder folder;
  const Volume echo{{.dims = {3, 4, 5}}, std::vector<std::uint8_t>(60, 7), {}};
  Volume level = echo;
  std::iota(level.echo.begin(), level.echo.end(), std::uint8_t{0});
  ASSERT_TRUE(writeVolume(echo, folder / "a.mha"));
  ASSERT_TRUE(writeVolume(level, folder / "level.mha"));
  Case made;
  made.id = made.title = "x";
  made.volume.file = "a.mha";
  made.volume.level = "level.mha";
  made.volume.fileToWorld = {glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {10, 20, 30, 1})};
  ASSERT_TRUE(saveCase(made, folder.path()));
  const auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(opened->volume, made.volume);
  const auto found = loadCaseVolume(*opened, noProgress());
  ASSERT_TRUE(found) << found.error();
  ASSERT_TRUE(found->tissue);
  EXPECT_TRUE(found->tissue->isRecorded);
  EXPECT_EQ(found->tissue->level, level.echo);
  EXPECT_EQ(found->tissue->grid, placed(level.grid, made.volume.fileToWorld));
  EXPECT_TRUE(found->tissue->surfaces.empty());
  made.volume.level.clear();
  made.folder = folder.path();
  EXPECT_FALSE(loadCaseVolume(made, noProgress())->tissue) << "without a level it is sliced";
}

TEST(CaseManifest, TakesALevelBesideAFileAlone) {
  const TemporaryFolder folder;
  for (const char* name : {"a.mha", "l.mha", "patient.json"}) writeText(folder / name, "x");
  const auto problemsOf = [&](const nlohmann::json& volume) {
    return checkManifest({{"format", 1}, {"id", "x"}, {"title", "x"}, {"volume", volume}}, folder.path());
  };
  EXPECT_TRUE(problemsOf({{"file", "a.mha"}, {"level", "l.mha"}}).empty());
  const nlohmann::json refused[] = {{{"file", "a.mha"}, {"level", "../l.mha"}},
                                    {{"file", "a.mha"}, {"level", "none.mha"}},
                                    {{"recipe", "patient.json"}, {"level", "l.mha"}}};
  for (const auto& volume : refused) {
    const auto problems = problemsOf(volume);
    ASSERT_EQ(problems.size(), 1u) << volume;
    EXPECT_NE(problems.front().sentence().find("volume.level"), std::string::npos) << problems.front();
  }
}

TEST(SceneWithTissues, PrefersTheManifestsTissueOfALabel) {
  Scene manifest;
  manifest.tissues = {{.label = 2, .name = "softer stone", .attenuation_dbPerCmMhz = 3.0, .reflection_db = 8.0}};
  const std::vector<TissueAcoustics> recipe = {{.label = 0, .name = "fat"}, {.label = 2, .name = "stone"}, {.label = 3, .name = "bile"}};
  const Scene scene = sceneWithTissues(manifest, recipe);
  ASSERT_EQ(scene.tissues.size(), 3u);
  EXPECT_EQ(scene.tissues[0].name, "fat");
  EXPECT_EQ(scene.tissues[1], manifest.tissues[0]);
  EXPECT_EQ(scene.tissues[2].name, "bile");
}

TEST(LoadCaseVolume, MakesABrokenCacheFileAgain) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  const Case made = coarseCase(folder / "case");
  const auto first = loadCaseVolume(made, noProgress());
  ASSERT_TRUE(first);
  const auto files = filesIn(folder / "cache");
  ASSERT_EQ(files.size(), 15u)
      << "echo, coverage, labels and what they are; three maps of tissue and their surfaces; six fields of motion and what they are";
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
      EXPECT_EQ(again->labels->echo, first->labels->echo) << file << " damage " << damage;
      EXPECT_EQ(*again->tissue, *first->tissue) << file << " damage " << damage;
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
  EXPECT_EQ(filesIn(folder / "cache").size(), 15u) << "nothing aside is left behind";
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
}  // namespace ew::case_volume_test
