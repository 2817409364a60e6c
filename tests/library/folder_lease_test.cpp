#include "ew/library/folder_lease.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "ew/core/machine_mark.h"
#include "ew/library/bundle.h"
#include "library/bundle_world.h"

namespace ew::test::folder_lease_test {
namespace {

namespace fs = std::filesystem;

std::string hostName() {
  char name[256] = {};
  ::gethostname(name, sizeof(name) - 1);
  return name;
}

/// A lease as another computer would have left it, so many seconds ago.
void leaveLease(const fs::path& folder, int number, int age_s, const std::string& host = "elsewhere", long long process = 1,
                const std::string& machine = {}) {
  const fs::path file = folder / (".ew-lease-" + std::to_string(number));
  writeText(file,
            nlohmann::json{
                {"user", "anna"}, {"host", host}, {"process", process}, {"since", 1'760'000'000}, {"free", false}, {"machine", machine}}
                .dump());
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  const timespec times[2] = {{now.tv_sec - age_s, 0}, {now.tv_sec - age_s, 0}};
  ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
}

TEST(FolderLease, IsHeldByOneAndFreeAgainAfterwards) {
  const TemporaryFolder folder;
  EXPECT_FALSE(FolderLease::holderOf(folder.path()));
  {
    auto lease = FolderLease::take(folder.path());
    ASSERT_TRUE(lease) << lease.error();
    EXPECT_TRUE(lease->refresh());
    const auto holder = FolderLease::holderOf(folder.path());
    ASSERT_TRUE(holder);
    EXPECT_EQ(holder->process, ::getpid());
    EXPECT_EQ(holder->host, hostName());
    const auto second = FolderLease::take(folder.path());
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ErrorCode::notWritable);
    const std::string sentence = second.error().sentence();
    EXPECT_NE(sentence.find(holder->user), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(holder->host), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("since 20"), std::string::npos) << sentence;
    const FolderLease moved = std::move(*lease);
    EXPECT_FALSE(FolderLease::take(folder.path()));
  }
  EXPECT_FALSE(FolderLease::holderOf(folder.path()));
  EXPECT_TRUE(FolderLease::take(folder.path()));
}

TEST(FolderLease, OfAnotherComputerCountsForTwoMinutesByTheFilesOwnClock) {
  const TemporaryFolder folder;
  leaveLease(folder.path(), 4, 60);
  const auto refused = FolderLease::take(folder.path());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("anna"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().sentence().find("elsewhere"), std::string::npos) << refused.error();
  leaveLease(folder.path(), 4, 125);
  EXPECT_TRUE(FolderLease::take(folder.path())) << "silent for two minutes";
}

TEST(FolderLease, OfAProcessOfThisComputerThatIsGoneIsTakenOverAtOnce) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    auto lease = FolderLease::take(folder.path());
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_FALSE(FolderLease::holderOf(folder.path()));
  EXPECT_TRUE(FolderLease::take(folder.path()));
  // A process of the same number that is another one: 1 is there on every computer.
  leaveLease(folder.path(), 90, 0, hostName(), 1);
  EXPECT_FALSE(FolderLease::take(folder.path())) << "it does not say when it began, and may be the holder";
}

TEST(FolderLease, OfAnotherMachineOfThisNameIsNotJudgedByTheProcessesHere) {
  const TemporaryFolder folder;
  constexpr long long kNobody = 99'999'999;  // no process here has this number
  leaveLease(folder.path(), 1, 0, hostName(), kNobody, "0badcafe");
  EXPECT_TRUE(FolderLease::holderOf(folder.path())) << "another machine, or a container, of the same name";
  EXPECT_FALSE(FolderLease::take(folder.path()));
  leaveLease(folder.path(), 2, 0, hostName(), kNobody, machineMark());
  EXPECT_TRUE(FolderLease::take(folder.path())) << "of this one, and gone";
}

TEST(FolderLease, OfSomebodyWhoWokeUpLateIsLostAndSaidToBe) {
  const TemporaryFolder folder;
  auto late = FolderLease::take(folder.path());
  ASSERT_TRUE(late);
  // As if it had been suspended: another computer takes over.
  leaveLease(folder.path(), 2, 0);
  const auto lost = late->refresh();
  ASSERT_FALSE(lost);
  EXPECT_NE(lost.error().sentence().find("anna"), std::string::npos) << lost.error();
  EXPECT_NE(lost.error().sentence().find("save your work as another case"), std::string::npos) << lost.error();
}

TEST(FolderLease, IsTakenOverByExactlyOneOfManyWhoFindItStale) {
  const TemporaryFolder folder;
  for (int round = 0; round < 40; ++round) {
    leaveLease(folder.path(), 1000 + round, 500);
    std::vector<std::optional<FolderLease>> taken(8);
    std::vector<std::thread> takers;
    std::atomic<bool> go{false};
    for (auto& mine : taken)
      takers.emplace_back([&folder, &mine, &go] {
        while (!go) std::this_thread::yield();
        if (auto lease = FolderLease::take(folder.path())) mine.emplace(std::move(*lease));
      });
    go = true;
    for (auto& taker : takers) taker.join();
    const auto holders = std::count_if(taken.begin(), taken.end(), [](const auto& each) { return each.has_value(); });
    EXPECT_EQ(holders, 1) << "round " << round;
    for (auto& each : taken)
      if (each) {
        EXPECT_TRUE(each->refresh());
      }
  }
}

TEST(FolderLease, WhoseFileIsHalfWrittenBelongsToSomebodyForAWhile) {
  const TemporaryFolder folder;
  leaveLease(folder.path(), 3, 0);
  std::filesystem::resize_file(folder / ".ew-lease-3", 5);
  EXPECT_FALSE(FolderLease::take(folder.path()));
  EXPECT_TRUE(FolderLease::take(folder.path(), {.staleAfter = std::chrono::seconds(-1)}));
}

TEST(FolderLease, LeavesOneSmallHiddenFileThatNoBundleCarries) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto before = filesOfCase(folder / "mine");
  for (int n = 0; n < 5; ++n) ASSERT_TRUE(FolderLease::take(folder / "mine"));
  EXPECT_EQ(*filesOfCase(folder / "mine"), *before);
  int leases = 0;
  for (const auto& each : fs::directory_iterator(folder / "mine"))
    if (isLeaseFile(each.path())) ++leases;
  EXPECT_EQ(leases, 1);
}

TEST(FolderLease, OfAFolderThatCannotBeWrittenIsRefusedWithWhatToDo) {
  const TemporaryFolder folder;
  const auto refused = FolderLease::take(folder / "nowhere");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("save the case elsewhere"), std::string::npos) << refused.error();
}

}  // namespace
}  // namespace ew::test::folder_lease_test
