#include "ew/io/file_lock.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "library/temporary_folder.h"

namespace ew::file_lock_test {
namespace {

namespace fs = std::filesystem;

TEST(FileLock, OfAFileThatIsThereIsHeldByOneAlone) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(FileLock::tryTakeExisting(folder / "lock")) << "nothing is made";
  EXPECT_FALSE(fs::exists(folder / "lock"));
  test::writeText(folder / "lock", "");
  auto held = FileLock::tryTakeExisting(folder / "lock");
  ASSERT_TRUE(held);
  EXPECT_FALSE(FileLock::tryTakeExisting(folder / "lock"));
  held.reset();
  EXPECT_TRUE(FileLock::tryTakeExisting(folder / "lock"));
}

TEST(FileLock, IsNotTakenThroughALink) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "lock", "");
  fs::create_symlink(folder / "lock", folder / "link");
  EXPECT_FALSE(FileLock::tryTakeExisting(folder / "link"));
}

TEST(FileLock, OfAFolderLeavesNothingBehindAndIsWaitedFor) {
  const test::TemporaryFolder folder;
  std::atomic<bool> isHeld = false;
  std::thread second;
  {
    const FileLock first = FileLock::takeFolder(folder.path());
    second = std::thread([&] {
      const FileLock lock = FileLock::takeFolder(folder.path());
      isHeld = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(isHeld);
  }
  second.join();
  EXPECT_TRUE(isHeld);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FileLock, OfAnOpenFileGoesWithIt) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "file", "");
  const int opened = ::open((folder / "file").c_str(), O_RDWR | O_CLOEXEC);
  EXPECT_TRUE(FileLock::holdOpen(opened));
  EXPECT_FALSE(FileLock::tryTakeExisting(folder / "file"));
  ::close(opened);
  EXPECT_TRUE(FileLock::tryTakeExisting(folder / "file"));
  EXPECT_FALSE(FileLock::holdOpen(opened)) << "it is closed";
}

}  // namespace
}  // namespace ew::file_lock_test
