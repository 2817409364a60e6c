#include "ew/core/pose.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace ew::pose_test {
namespace {

TEST(Poses, AreSixteenNumbersALine) {
  const auto poses = parsePoses("# a comment\n\n1 0 0 10 0 1 0 20 0 0 1 30 0 0 0 1\n0 -1 0 0 1 0 0 0 0 0 1 0 0 0 0 1\r\n");
  ASSERT_TRUE(poses) << poses.error();
  ASSERT_EQ(poses->size(), 2u);
  EXPECT_EQ((*poses)[0].probeToWorld.matrix[3], glm::dvec4(10, 20, 30, 1));
  EXPECT_EQ((*poses)[1].probeToWorld.matrix[0], glm::dvec4(0, 1, 0, 0)) << "x of the probe is the first column";
}

TEST(Poses, AreRefusedWithTheLine) {
  const auto tooFew = parsePoses("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n1 2 3\n");
  ASSERT_FALSE(tooFew);
  EXPECT_EQ(tooFew.error().code, ErrorCode::badField);
  EXPECT_NE(tooFew.error().sentence().find("Line 2"), std::string::npos);
  const auto mirrored = parsePoses("1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1");
  ASSERT_FALSE(mirrored);
  EXPECT_EQ(mirrored.error().code, ErrorCode::notRigid);
  EXPECT_FALSE(parsePoses(""));
}

TEST(Poses, ComeFromTheArgumentOrFromAFile) {
  EXPECT_TRUE(posesFromArgument("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"));
  const auto file = std::filesystem::temp_directory_path() / "ew_pose_test.txt";
  std::ofstream(file) << "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n";
  EXPECT_EQ(posesFromArgument(file.string())->size(), 1u);
  std::filesystem::remove(file);
  const auto missing = posesFromArgument(file.string());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::notFound);
}

TEST(Poses, AreNotLookedForInAFolderOrADevice) {
  const auto folder = posesFromArgument(std::filesystem::temp_directory_path().string());
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().code, ErrorCode::notReadable);
  const auto endless = posesFromArgument("/dev/zero");
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().code, ErrorCode::notReadable);
}

TEST(Poses, AreNotWaitedForAtAPipeThatNobodyWritesInto) {
  const auto pipe = std::filesystem::temp_directory_path() / ("ew_pose_pipe_" + std::to_string(::getpid()));
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto poses = posesFromArgument(pipe.string());
  std::filesystem::remove(pipe);
  ASSERT_FALSE(poses);
  EXPECT_EQ(poses.error().code, ErrorCode::notReadable);
}

}  // namespace
}  // namespace ew::pose_test
