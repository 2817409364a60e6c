#include "ew/io/safe_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <stdexcept>

#include "ew/io/image_file.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"
#include "ew/io/volume_stream.h"
#include "files.h"

namespace ew::safe_file_test {
namespace {
using namespace test;
namespace fs = std::filesystem;

TEST(SafeFile, ReplacesAFileOnlyWhenTheNewOneIsComplete) {
  const TempFolder folder;
  const auto file = folder.put("a.txt", "before");
  const auto failed = writeFileSafely(file, [](std::ostream& out) -> Result<void> {
    out << "half";
    return failure(ErrorCode::cancelled, verbatim("Stopped."));
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
  const GreyImage image(2, 2, 7);
  EXPECT_TRUE(failedWith(writeVolume(volume, file / "v.mha"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeVolume(volume, file / "v.mhd"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeCoverage(volume, file / "v.mha"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeSequence(sequence, file / "s.igs.mha"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeImage(viewOf(image), 1.0, file / "p.png"), ErrorCode::notWritable));
  EXPECT_TRUE(failedWith(writeImage(viewOf(image), 1.0, file / "p.mha"), ErrorCode::notWritable));
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

/// For its lifetime no file grows beyond `bytes`: the system refuses the rest as a full medium does, wherever the test runs.
class SmallMedium {
 public:
  explicit SmallMedium(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallMedium() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  SmallMedium(const SmallMedium&) = delete;
  SmallMedium& operator=(const SmallMedium&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

TEST(SafeFile, AFullMediumIsAnErrorAndNotAShortFile) {
  const TempFolder folder;
  const auto kept = folder.put("kept.txt", "before");
  // 100 bytes fail when the stream is emptied at the end, 1 MB while it is written.
  for (const std::size_t bytes : {std::size_t{100}, std::size_t{1} << 20})
    for (const char* name : {"new.txt", "kept.txt"}) {
      const auto written = [&] {
        const SmallMedium medium(10);
        return writeFileSafely(folder / name, std::string(bytes, 'x'));
      }();
      EXPECT_TRUE(failedWith(written, ErrorCode::notWritable)) << bytes;
      if (bytes == 100) {
        EXPECT_TRUE(says(written, "File too large")) << "the system's own reason";
      }
    }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"kept.txt"});
  EXPECT_EQ(bytesOfFile(kept), "before");
}

TEST(SafeFile, EveryWriterLeavesTheFolderAsItWasOnAFullMedium) {
  const TempFolder folder;
  Volume volume;
  volume.grid.dims = {32, 32, 32};
  for (int n = 0; n < 32 * 32 * 32; ++n) volume.echo.push_back(static_cast<std::uint8_t>((n * 2654435761U) >> 24U));
  Sequence sequence;
  sequence.width = sequence.height = 32;
  sequence.frames.resize(32);
  sequence.pixels = volume.echo;
  const GreyImage image(256, 256, 7);
  for (const char* name : {"v.mha", "v.mhd", "v.raw", "s.igs.mha", "p.mha"}) ASSERT_FALSE(folder.put(name, "before").empty());
  {
    const SmallMedium medium(2000);  // room for every header
    EXPECT_TRUE(failedWith(writeVolume(volume, folder / "v.mha"), ErrorCode::notWritable));
    EXPECT_TRUE(failedWith(writeVolume(volume, folder / "v.mhd"), ErrorCode::notWritable));
    EXPECT_TRUE(failedWith(writeSequence(sequence, folder / "s.igs.mha"), ErrorCode::notWritable));
    EXPECT_TRUE(failedWith(writeImage(viewOf(image), 1.0, folder / "p.mha"), ErrorCode::notWritable));
    EXPECT_FALSE(VolumeStream::create(volume.grid, folder / "v.mha"));
  }
  EXPECT_EQ(folder.names().size(), 5u);
  for (const char* name : {"v.mha", "v.mhd", "v.raw", "s.igs.mha", "p.mha"}) EXPECT_EQ(bytesOfFile(folder / name), "before") << name;
}

TEST(SafeFile, APairIsReplacedTogetherAndItsHeaderNamesTheSamplesBesideIt) {
  const TempFolder folder;
  fs::create_directories(folder / "far");
  fs::create_symlink("far/v.mhd", folder / "link.mhd");
  Volume volume;
  volume.grid.dims = {2, 2, 2};
  for (const std::uint8_t level : {std::uint8_t{1}, std::uint8_t{2}}) {
    volume.echo.assign(8, level);
    ASSERT_TRUE(succeeded(writeVolume(volume, folder / "link.mhd")));
    const auto read = readVolume(folder / "far" / "v.mhd");
    ASSERT_TRUE(succeeded(read));
    EXPECT_EQ(read->volume.echo, volume.echo);
  }
  EXPECT_TRUE(fs::is_symlink(folder / "link.mhd"));
  EXPECT_EQ(folder.names().size(), 2u);
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
}  // namespace ew::safe_file_test
