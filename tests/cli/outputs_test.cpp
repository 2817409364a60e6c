#include "outputs.h"

#include <gtest/gtest.h>

#include "cli/cli_world.h"

namespace ew::cli {
namespace {

using test::TemporaryFolder;
using Names = std::vector<std::string>;

TEST(Outputs, AppearTogetherWhenCommittedAndNotBefore) {
  const TemporaryFolder folder;
  Outputs outputs;
  ASSERT_TRUE(outputs.announce(folder / "a.mha", ".mha .mhd"));
  ASSERT_TRUE(outputs.announce(folder / "b.png", ".png .mha"));
  EXPECT_EQ(std::filesystem::path(outputs.staged(folder / "a.mha")).extension(), ".mha") << "writers choose the format by the ending";
  test::writeText(outputs.staged(folder / "a.mha").string(), "A");
  test::writeText(outputs.staged(folder / "b.png").string(), "B");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.mha"));
  ASSERT_TRUE(outputs.commit());
  EXPECT_EQ(folder.names(), (Names{"a.mha", "b.png"}));
  EXPECT_EQ(test::readText(folder / "a.mha"), "A");
}

TEST(Outputs, WhatWasNotCommittedLeavesTheFolderAsItWas) {
  const TemporaryFolder folder;
  test::writeText(folder / "a.mha", "old");
  {
    Outputs outputs;
    ASSERT_TRUE(outputs.announce(folder / "a.mha"));
    ASSERT_TRUE(outputs.announce(folder / "b.mhd"));
    test::writeText(outputs.staged(folder / "a.mha").string(), "new");
    test::writeText(outputs.staged(folder / "b.mhd").string(), "header");
    test::writeText(folder / "b.raw", "pixels");
  }
  EXPECT_EQ(folder.names(), Names{"a.mha"});
  EXPECT_EQ(test::readText(folder / "a.mha"), "old");
}

TEST(Outputs, RefuseWhatCannotBeWrittenBeforeAnyWork) {
  const TemporaryFolder folder;
  test::writeText(folder / "in.mha", "input");
  test::writeText(folder / "file", "no folder");
  std::filesystem::create_directory(folder / "sub.mha");
  Outputs outputs;
  outputs.protect(folder / "in.mha");
  const auto codeOf = [&](const std::string& file, std::string_view endings = ".mha .mhd") {
    const auto announced = outputs.announce(file, endings);
    return announced ? std::optional<ErrorCode>() : announced.error().code;
  };
  EXPECT_EQ(codeOf(folder / "in.mha"), ErrorCode::badUsage) << "an input is never written over";
  EXPECT_EQ(codeOf((folder / "sub.mha") + "/../in.mha"), ErrorCode::badUsage) << "by no other name either";
  EXPECT_EQ(codeOf(folder / "o.nrrd"), ErrorCode::badUsage) << "ending";
  EXPECT_EQ(codeOf(folder / "o"), ErrorCode::badUsage) << "no ending";
  EXPECT_EQ(codeOf(""), ErrorCode::badUsage);
  EXPECT_EQ(codeOf(folder / "sub.mha"), ErrorCode::notWritable) << "a folder";
  EXPECT_EQ(codeOf(folder / "file/o.mha"), ErrorCode::notWritable) << "below a file";
  EXPECT_EQ(codeOf(folder / "none/o.mha"), ErrorCode::notWritable) << "no such folder";
  EXPECT_EQ(codeOf("/proc/o.mha"), ErrorCode::notWritable) << "nothing can be made there, not even by root";
  EXPECT_EQ(codeOf("/dev/null", ""), ErrorCode::notWritable) << "a device would be replaced by a file";
  EXPECT_EQ(codeOf(folder / "o.MHA"), std::nullopt);
  EXPECT_EQ(codeOf(folder / "o.MHA"), ErrorCode::badUsage) << "twice";
  EXPECT_EQ(folder.names(), (Names{"file", "in.mha", "sub.mha"}));
}

TEST(Outputs, AreCalledByTheirGivenNamesWhateverAWriterCallsThem) {
  const TemporaryFolder folder;
  Outputs outputs;
  ASSERT_TRUE(outputs.announce(folder / "a.mha"));
  const auto staged = outputs.staged(folder / "a.mha");
  EXPECT_EQ(outputs.inGivenNames("Writing " + staged.string() + " or " + staged.filename().string() + " failed."),
            "Writing " + (folder / "a.mha") + " or a.mha failed.");
}

TEST(Outputs, ASymbolicLinkStaysALink) {
  const TemporaryFolder folder;
  test::writeText(folder / "real.mha", "old");
  std::filesystem::create_symlink("real.mha", folder / "link.mha");
  Outputs outputs;
  ASSERT_TRUE(outputs.announce(folder / "link.mha"));
  test::writeText(outputs.staged(folder / "link.mha").string(), "new");
  ASSERT_TRUE(outputs.commit());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.mha"));
  EXPECT_EQ(test::readText(folder / "real.mha"), "new");
}

TEST(Outputs, AFolderMadeForThemIsGoneWhenNothingCameOfIt) {
  const TemporaryFolder folder;
  {
    Outputs outputs;
    ASSERT_TRUE(outputs.announceFolder(folder / "new/deep"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "new/deep"));
}

}  // namespace
}  // namespace ew::cli
