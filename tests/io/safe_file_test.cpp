#include "ew/io/safe_file.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "ew/io/image_file.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"
#include "files.h"

namespace ew {
namespace {
using namespace test;
namespace fs = std::filesystem;

TEST(SafeFile, ReplacesAFileOnlyWhenTheNewOneIsComplete) {
  const TempFolder folder;
  const auto file = folder.put("a.txt", "before");
  const auto failed = writeFileSafely(file, [](std::ostream& out) -> Result<void> {
    out << "half";
    return failure(ErrorCode::cancelled, "Stopped.");
  });
  EXPECT_TRUE(failedWith(failed, ErrorCode::cancelled));
  EXPECT_EQ(bytesOfFile(file), "before");
  const auto thrown = writeFileSafely(file, [](std::ostream&) -> Result<void> { throw std::runtime_error("library"); });
  EXPECT_TRUE(failedWith(thrown, ErrorCode::internal));
  EXPECT_EQ(bytesOfFile(file), "before");
  EXPECT_TRUE(succeeded(writeFileSafely(file, "after")));
  EXPECT_EQ(bytesOfFile(file), "after");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(SafeFile, KeepsThePermissionsAndTheLinkOfWhatItReplaces) {
  const TempFolder folder;
  const auto file = folder.put("a.txt", "before");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.txt", folder / "link.txt");
  ASSERT_TRUE(succeeded(writeFileSafely(folder / "link.txt", "after")));
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(bytesOfFile(file), "after");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(SafeFile, AnUnwritablePlaceIsNamedAndLeftAsItWas) {
  const TempFolder folder;
  const auto file = folder.put("a.txt", "before");
  // Below a file, in a folder that is not there, over a folder, over a device and where the kernel refuses: root may not either.
  for (const fs::path& place :
       {file / "b.txt", folder / "no" / "b.txt", folder.path(), fs::path("/dev/null"), fs::path("/proc/ew-b.txt")}) {
    const auto written = writeFileSafely(place, "text");
    EXPECT_TRUE(failedWith(written, ErrorCode::notWritable)) << place;
    EXPECT_TRUE(says(written, place.string())) << place;
  }
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(bytesOfFile(file), "before");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(SafeFile, EveryWriterRefusesAnUnwritablePlace) {
  const TempFolder folder;
  const auto file = folder.put("a", "before");
  Volume volume;
  volume.grid.dims = {2, 2, 2};
  volume.echo.assign(8, 1);
  Sequence sequence;
  sequence.frames.resize(1);
  const GreyImage picture(2, 2, 7);
  EXPECT_TRUE(failedWith(writeVolume(volume, file / "v.mha"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeVolume(volume, file / "v.mhd"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeCoverage(volume, file / "v.mha"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeSequence(sequence, file / "s.igs.mha"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeImage(viewOf(picture), 1.0, file / "p.png"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeImage(viewOf(picture), 1.0, file / "p.mha"), ErrorCode::notWritable));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
  EXPECT_EQ(bytesOfFile(file), "before");
}

TEST(SafeFile, APairKeepsItsOldSamplesWhenItsHeaderCannotBeWritten) {
  const TempFolder folder;
  fs::create_directories(folder / "v.mhd");  // a folder where the header should go
  ASSERT_FALSE(folder.put("v.raw", "old samples").empty());
  Volume volume;
  volume.grid.dims = {2, 2, 2};
  volume.echo.assign(8, 1);
  EXPECT_TRUE(failedWith(writeVolume(volume, folder / "v.mhd"), ErrorCode::notWritable));
  EXPECT_EQ(bytesOfFile(folder / "v.raw"), "old samples");
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST(SafeFile, AFullMediumIsAnErrorAndNotAShortFile) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const TempFolder folder;
  const auto written = writeFileSafely(folder / "a.bin", [](std::ostream& out) -> Result<void> {
    out.setstate(std::ios::badbit);  // what a stream reports when the medium takes no more
    return {};
  });
  EXPECT_TRUE(failedWith(written, ErrorCode::notWritable));
  EXPECT_TRUE(folder.names().empty());
}

TEST(TextFile, IsReadUpToItsLimit) {
  const TempFolder folder;
  const auto file = folder.put("a.txt", std::string(1000, 'x'));
  const auto text = readTextFile(file);
  ASSERT_TRUE(succeeded(text));
  EXPECT_EQ(text->size(), 1000u);
  EXPECT_TRUE(succeeded(readTextFile(file, 1000)));
  EXPECT_TRUE(failedWith(readTextFile(file, 999), ErrorCode::tooLarge));
  EXPECT_TRUE(failedWith(readTextFile(folder / "no.txt"), ErrorCode::notFound));
  EXPECT_TRUE(failedWith(readTextFile(folder.path()), ErrorCode::notReadable));
}

}  // namespace
}  // namespace ew
