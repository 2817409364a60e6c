#include "making/old_results.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "ew/library/case.h"
#include "files/private_folder.h"
#include "library/temporary_folder.h"

namespace ew::old_results_test {
namespace {

namespace fs = std::filesystem;
using test::EnvironmentValue;
using test::TemporaryFolder;
using test::writeText;

const std::string kOld(32, 'a'), kNew(32, 'b');

std::set<std::string> namesIn(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

void age(const fs::path& file, std::chrono::hours by) { fs::last_write_time(file, fs::file_time_type::clock::now() - by); }

/// The number of a process that has ended.
std::string ended() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return std::to_string(child);
}

TEST(OldResults, OfProgramsThatHaveEndedGoAndNothingElseDoes) {
  const TemporaryFolder folder;
  const std::string dead = ended(), alive = std::to_string(getpid());
  const std::string gone = "." + kOld + ".igs.mha." + dead + "-3.part";
  const std::vector<std::string> stay = {"." + kOld + ".igs.mha." + alive + "-3.part",
                                         ".notes.txt." + dead + "-3.part",
                                         kOld + ".igs.mha." + dead + "-3.part",
                                         "." + kOld + ".igs.mha." + dead + "-.part",
                                         "." + kOld + ".igs.mha.-3.part",
                                         "." + kOld + ".odt." + dead + "-3.part",
                                         kOld + ".igs.mha",
                                         "holiday.jpg"};
  writeText(folder / gone, "x");
  writeText(folder / (".ew-" + dead + "-0") / (kOld + ".mha"), "x");
  writeText(folder / (".ew-" + alive + "-0") / (kOld + ".mha"), "x");
  for (const auto& name : stay) writeText(folder / name, "x");
  for (const auto& entry : fs::directory_iterator(folder.path())) age(entry.path(), std::chrono::hours(48));
  const std::string fresh = "." + kNew + ".mha." + dead + "-4.part";
  writeText(folder / fresh, "x");
  removeOldResults(folder.path());
  std::set<std::string> expected(stay.begin(), stay.end());
  expected.insert(fresh);
  expected.insert(".ew-" + alive + "-0");
  EXPECT_EQ(namesIn(folder.path()), expected);
}

TEST(OldResults, OfResultsThatNobodyUsedForLongGoWithAllThatBelongsToThem) {
  const TemporaryFolder folder;
  for (const std::string& key : {kOld, kNew})
    for (const char* ending : {".json", ".mha", ".coverage.mha", ".labels.mha", ".truth.json", ".lock"})
      writeText(folder / (key + ending), "x");
  for (const std::string& foreign : {kOld + ".odt", std::string("report.json"), kOld.substr(1) + ".json"}) writeText(folder / foreign, "x");
  for (const auto& entry : fs::directory_iterator(folder.path())) age(entry.path(), std::chrono::hours(24 * 400));
  age(folder / (kNew + ".json"), std::chrono::hours(24 * 10));
  removeOldResults(folder.path());
  EXPECT_EQ(namesIn(folder.path()),
            (std::set<std::string>{kNew + ".json", kNew + ".mha", kNew + ".coverage.mha", kNew + ".labels.mha", kNew + ".truth.json",
                                   kNew + ".lock", kOld + ".lock", kOld + ".odt", "report.json", kOld.substr(1) + ".json"}));
  removeOldResults(folder / "nowhere");
}

TEST(PrivateFolder, IsNewClosedToOthersAndGoneAtTheEnd) {
  fs::path path;
  {
    const auto first = PrivateFolder::make(), second = PrivateFolder::make();
    ASSERT_TRUE(first && second);
    EXPECT_NE(first->path(), second->path());
    path = first->path();
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
    writeText(path / "a", "x");
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(CacheFolder, WithoutAHomeIsThisUsersOwnAndNeverAPlantedLink) {
  const TemporaryFolder folder;
  const EnvironmentValue temporary("TMPDIR", folder.path()), home("HOME", ""), xdg("XDG_CACHE_HOME", ""), cache("ECHOWEAVE_CACHE", "");
  const fs::path own = cacheFolder();
  EXPECT_EQ(own.parent_path(), folder.path());
  EXPECT_EQ(fs::status(own).permissions(), fs::perms::owner_all);
  EXPECT_EQ(cacheFolder(), own) << "the same every time";
  fs::remove(own);
  fs::create_directories(folder / "victim");
  fs::create_directory_symlink(folder / "victim", own);
  EXPECT_NE(cacheFolder(), own);
  EXPECT_EQ(fs::symlink_status(cacheFolder()).type(), fs::file_type::directory);
}

}  // namespace
}  // namespace ew::old_results_test
