#include "ew/io/rest_in_file.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "ew/io/volume_file.h"
#include "files.h"

namespace ew::rest_in_file_test {
namespace {
using namespace test;

constexpr std::size_t kPage = 4096;

/// Values that begin so many bytes into a page, whatever the allocator does.
class Placed {
 public:
  Placed(const std::vector<std::uint8_t>& values, std::size_t intoPage) : room_(values.size() + 2 * kPage) {
    const std::size_t at = reinterpret_cast<std::uintptr_t>(room_.data()) % kPage;
    span = std::span(room_).subspan((kPage + intoPage - at) % kPage, values.size());
    std::copy(values.begin(), values.end(), span.begin());
  }
  [[nodiscard]] bool holds(const std::vector<std::uint8_t>& values) const { return std::equal(span.begin(), span.end(), values.begin()); }

  std::span<std::uint8_t> span;

 private:
  std::vector<std::uint8_t> room_;
};

Volume filled() {
  Volume volume;
  volume.grid.dims = {211, 173, 151};  // 5 MiB and no whole number of pages
  volume.echo.resize(volume.grid.voxelCount());
  for (std::size_t n = 0; n < volume.echo.size(); ++n) volume.echo[n] = static_cast<std::uint8_t>((n * 2654435761U) >> 13U);
  return volume;
}

/// Whether the system takes a page of the program from a file of this name.
bool isTakenFrom(const std::filesystem::path& file, const std::uint8_t* page) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%zx-%zx", &begin, &end) != 2) continue;
    const auto at = reinterpret_cast<std::uintptr_t>(page);
    if (begin <= at && at < end) return line.find(file.filename().string()) != std::string::npos;
  }
  return false;
}

}  // namespace

TEST(RestInFile, LeavesValuesAsTheyAreAndTheirPagesInTheFile) {
  const TempFolder folder;
  const Volume volume = filled();
  const auto file = folder / "plain.mha";
  ASSERT_TRUE(writeVolume(volume, file, noProgress(), {.compress = false}));
  Placed values(volume.echo, kBlockBegin_bytes);
  const std::uint64_t resting = restInVolumeFile(values.span, file);
  EXPECT_GE(resting, volume.echo.size() - 2 * kPage) << "all whole pages";
  EXPECT_LE(resting, volume.echo.size());
  EXPECT_TRUE(isTakenFrom(file, values.span.data() + 3 * kPage));
  EXPECT_TRUE(values.holds(volume.echo));
  EXPECT_EQ(restInVolumeFile(values.span, file), resting) << "asked twice nothing changes";
  EXPECT_TRUE(values.holds(volume.echo));

  std::vector<std::uint8_t> changed = volume.echo;
  for (const std::size_t at : {std::size_t{0}, 5 * kPage + 7, changed.size() - 1}) values.span[at] = changed[at] = 255 - changed[at];
  EXPECT_TRUE(values.holds(changed)) << "they may be written to";
  const auto read = readVolume(file);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->volume.echo, volume.echo) << "and the file stays as it is";
  std::filesystem::remove(file);
  EXPECT_TRUE(values.holds(changed)) << "a file without a name still holds them";
}

TEST(RestInFile, LeavesTheHeadersLinesAsShortAsOthersReadThem) {
  const TempFolder folder;
  for (int more = 0; more < 3; ++more) {
    Volume volume;
    volume.grid.dims = {128 + 100 * more, 128, 128};
    volume.grid.origin_mm.x = more == 1 ? 1.0 / 3.0 : 0.0;
    volume.echo.assign(volume.grid.voxelCount(), 9);
    const auto file = folder / "plain.mha";
    ASSERT_TRUE(writeVolume(volume, file, noProgress(), {.compress = false}));
    std::ifstream in(file, std::ios::binary);
    std::uint64_t begin_bytes = 0;
    for (std::string line; begin_bytes == 0 && std::getline(in, line);) {
      EXPECT_LT(line.size(), 500u) << line;
      if (line == "ElementDataFile = LOCAL") begin_bytes = static_cast<std::uint64_t>(in.tellg());
    }
    EXPECT_EQ(begin_bytes % kPage, kBlockBegin_bytes);
  }
}

TEST(RestInFile, KeepsInMemoryWhatTheFileDoesNotHold) {
  const TempFolder folder;
  const Volume volume = filled();
  const auto file = folder / "plain.mha";
  ASSERT_TRUE(writeVolume(volume, file, noProgress(), {.compress = false}));
  std::vector<std::uint8_t> other = volume.echo;
  other[5 << 20] ^= 1;  // in the second piece
  Placed different(other, kBlockBegin_bytes);
  EXPECT_EQ(restInVolumeFile(different.span, file), 4u << 20) << "only what is the same";
  EXPECT_TRUE(different.holds(other));

  Placed shifted(volume.echo, kBlockBegin_bytes + 1);
  EXPECT_EQ(restInVolumeFile(shifted.span, file), 0u);
  EXPECT_TRUE(shifted.holds(volume.echo));
  Placed values(volume.echo, kBlockBegin_bytes);
  EXPECT_EQ(restInVolumeFile(values.span.first(1000), file), 0u) << "not worth it";
  EXPECT_EQ(restInVolumeFile(values.span, folder / "none.mha"), 0u);
  ASSERT_TRUE(writeVolume(volume, folder / "packed.mha"));
  EXPECT_EQ(restInVolumeFile(values.span, folder / "packed.mha"), 0u);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  EXPECT_EQ(restInVolumeFile(values.span, file), 0u) << "cut short";
  EXPECT_TRUE(values.holds(volume.echo));
}

}  // namespace ew::rest_in_file_test
