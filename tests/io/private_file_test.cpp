#include "ew/io/private_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "files.h"

namespace ew::test {
namespace {

namespace fs = std::filesystem;

mode_t modeOf(const fs::path& file) {
  struct stat found {};
  EXPECT_EQ(::lstat(file.c_str(), &found), 0) << file;
  return found.st_mode & 0777;
}

class PrivateFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "ew-private-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  void TearDown() override {
    ::umask(022);
    fs::remove_all(folder_);
  }
  fs::path folder_;
};

TEST_F(PrivateFile, IsForItsOwnerAloneWhateverTheUmask) {
  for (const mode_t mask : {0, 022, 077, 0277}) {
    ::umask(mask);
    const fs::path inside = folder_ / ("a" + std::to_string(mask)) / "b";
    ASSERT_TRUE(makePrivateFolder(inside));
    ASSERT_TRUE(writePrivateFile(inside / "f", "secret"));
    ASSERT_TRUE(appendPrivateLine(inside / "log", "one"));
    EXPECT_EQ(modeOf(inside), 0700u) << mask;
    EXPECT_EQ(modeOf(inside.parent_path()), 0700u) << mask;
    EXPECT_EQ(modeOf(inside / "f"), 0600u) << mask;
    EXPECT_EQ(modeOf(inside / "log"), 0600u) << mask;
  }
}

TEST_F(PrivateFile, ComesBackAsItWasWritten) {
  const std::string text("a\0b\xff\n", 5);
  ASSERT_TRUE(writePrivateFile(folder_ / "f", "before"));
  ASSERT_TRUE(writePrivateFile(folder_ / "f", text));
  EXPECT_EQ(readPrivateFile(folder_ / "f"), text);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1) << "nothing is left aside";
}

TEST_F(PrivateFile, IsRefusedWhenOthersMayReadOrChangeIt) {
  ASSERT_TRUE(writePrivateFile(folder_ / "f", "secret"));
  for (const mode_t wide : {0640, 0604, 0620, 0602, 0666}) {
    ::chmod((folder_ / "f").c_str(), wide);
    const auto read = readPrivateFile(folder_ / "f");
    ASSERT_FALSE(read) << wide;
    EXPECT_NE(read.error().sentence().find("chmod 600"), std::string::npos) << read.error();
  }
}

TEST_F(PrivateFile, IsNeitherReadNorWrittenThroughALink) {
  ASSERT_TRUE(writePrivateFile(folder_ / "own", "secret"));
  fs::create_symlink(folder_ / "own", folder_ / "link");
  EXPECT_FALSE(readPrivateFile(folder_ / "link"));
  EXPECT_FALSE(appendPrivateLine(folder_ / "link", "more"));
  ASSERT_TRUE(writePrivateFile(folder_ / "link", "other"));
  EXPECT_EQ(readPrivateFile(folder_ / "own"), "secret") << "the link was replaced, not what it led to";
  fs::create_directory(folder_ / "real");
  fs::create_symlink(folder_ / "real", folder_ / "folder");
  EXPECT_FALSE(makePrivateFolder(folder_ / "folder"));
}

TEST_F(PrivateFile, IsRefusedWhenItIsAPipeAFolderOrTooLarge) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_FALSE(readPrivateFile(folder_ / "pipe"));
  EXPECT_FALSE(readPrivateFile(folder_));
  EXPECT_EQ(readPrivateFile(folder_ / "none").error().code, ErrorCode::notFound);
  ASSERT_TRUE(writePrivateFile(folder_ / "f", std::string(100, 'x')));
  EXPECT_EQ(readPrivateFile(folder_ / "f", 99).error().code, ErrorCode::tooLarge);
}

TEST_F(PrivateFile, OfAnotherAccountIsRefused) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make a file of another account";
  ASSERT_TRUE(writePrivateFile(folder_ / "f", "secret"));
  ASSERT_EQ(::chown((folder_ / "f").c_str(), 65534, 65534), 0);
  const auto read = readPrivateFile(folder_ / "f");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().sentence().find("another account"), std::string::npos);
  EXPECT_FALSE(appendPrivateLine(folder_ / "f", "more"));
}

TEST_F(PrivateFile, GetsWholeLinesFromManyProgramsAtOnce) {
  constexpr int kPrograms = 6, kLines = 40;
  std::vector<pid_t> children;
  for (int n = 0; n < kPrograms; ++n) {
    const pid_t child = ::fork();
    if (child == 0) {
      bool good = true;
      for (int k = 0; k < kLines; ++k)
        good = good && appendPrivateLine(folder_ / "log", std::string(200, static_cast<char>('a' + n))).has_value();
      ::_exit(good ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const auto text = readPrivateFile(folder_ / "log");
  ASSERT_TRUE(text);
  ASSERT_EQ(text->size(), static_cast<std::size_t>(kPrograms * kLines * 201));
  for (std::size_t at = 0; at < text->size(); at += 201) EXPECT_EQ(text->substr(at, 201), std::string(200, (*text)[at]) + "\n") << at;
}

TEST_F(PrivateFile, EndsALineThatWasTornBeforeItAppends) {
  ASSERT_TRUE(writePrivateFile(folder_ / "log", "one\ntor"));
  ASSERT_TRUE(appendPrivateLine(folder_ / "log", "two"));
  EXPECT_EQ(readPrivateFile(folder_ / "log"), "one\ntor\ntwo\n");
}

TEST_F(PrivateFile, ClosesWhatIsThereAlready) {
  ::umask(0);
  fs::create_directories(folder_ / "a/b");
  std::ofstream(folder_ / "a/b/f") << "x";
  std::ofstream(folder_ / "outside") << "x";
  fs::permissions(folder_ / "outside", fs::perms(0644));
  fs::create_symlink(folder_ / "outside", folder_ / "a/link");
  ASSERT_TRUE(closeToOthers(folder_ / "a"));
  EXPECT_EQ(modeOf(folder_ / "a"), 0700u);
  EXPECT_EQ(modeOf(folder_ / "a/b"), 0700u);
  EXPECT_EQ(modeOf(folder_ / "a/b/f"), 0600u);
  EXPECT_EQ(modeOf(folder_ / "outside"), 0644u) << "a link was followed";
}

}  // namespace
}  // namespace ew::test
