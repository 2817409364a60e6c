#include "ew/io/rest_in_file.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <tuple>

#include "ew/io/medium.h"
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

namespace {

/// A device as the kernel lists it: its folder in the tree of devices, and a link to it by number.
std::filesystem::path listed(const std::filesystem::path& folder, const std::string& place, const std::string& number) {
  const auto device = folder / "devices" / place;
  std::filesystem::create_directories(device);
  std::filesystem::create_directories(folder / "dev/block");
  std::filesystem::create_directory_symlink(device, folder / "dev/block" / number);
  return folder / "dev/block" / number;
}

void write(const std::filesystem::path& file, const std::string& line) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << line << '\n';
}

}  // namespace

TEST(RestInFile, KnowsMediaThatCanBePulledOut) {
  const TempFolder folder;
  const auto devices = folder / "devices";
  const auto inside = listed(folder.path(), "pci0000:00/0000:00:17.0/ata1/host0/target0:0:0/0:0:0:0/block/sda/sda1", "8:1");
  write(devices / "pci0000:00/0000:00:17.0/ata1/host0/target0:0:0/0:0:0:0/block/sda/removable", "0");
  EXPECT_FALSE(canBePulledOut(inside));
  const auto nvme = listed(folder.path(), "pci0000:00/0000:00:1d.0/0000:01:00.0/nvme/nvme0/nvme0n1/nvme0n1p2", "259:2");
  EXPECT_FALSE(canBePulledOut(nvme));
  // Drives on a cable say that they are not removable.
  const auto onCable = listed(folder.path(), "pci0000:00/0000:00:14.0/usb2/2-1/2-1:1.0/host6/target6:0:0/6:0:0:0/block/sdb/sdb1", "8:17");
  write(devices / "pci0000:00/0000:00:14.0/usb2/2-1/2-1:1.0/host6/target6:0:0/6:0:0:0/block/sdb/removable", "0");
  EXPECT_TRUE(canBePulledOut(onCable));
  const auto disc = listed(folder.path(), "pci0000:00/0000:00:17.0/ata2/host1/target1:0:0/1:0:0:0/block/sr0", "11:0");
  write(devices / "pci0000:00/0000:00:17.0/ata2/host1/target1:0:0/1:0:0:0/block/sr0/removable", "1");
  EXPECT_TRUE(canBePulledOut(disc));
  // Cards and soldered memory hang on the same kind of socket; only the type tells.
  for (const auto& [type, number, loose] : {std::tuple{"SD", "179:1", true}, std::tuple{"MMC", "179:9", false}}) {
    const std::string disk = std::string("platform/mmc_host/mmc0/mmc0:") + type + "/block/mmcblk0";
    const auto card = listed(folder.path(), disk + "/mmcblk0p1", number);
    write(devices / disk / "removable", "0");
    write(devices / disk / "device/type", type);
    EXPECT_EQ(canBePulledOut(card), loose) << type;
  }
  EXPECT_FALSE(canBePulledOut(folder / "dev/block/0:37")) << "of a file system in memory there is no device";
}

}  // namespace ew::rest_in_file_test
