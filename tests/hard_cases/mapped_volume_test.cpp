#include "ew/io/mapped_volume.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "ew/core/image.h"
#include "ew/imaging/slicing.h"
#include "io/files.h"
#include "time_limit.h"

namespace ew::mapped_volume_test {
namespace {
using namespace test;

/// A volume file of holes: it takes no room on the disk, and its pages take memory as any do once they are read.
class SparseVolume {
 public:
  explicit SparseVolume(const glm::ivec3& dims) : dims_(dims) {
    header_ = folder_.put("a.mhd", "ObjectType = Image\nNDims = 3\nDimSize = " + std::to_string(dims.x) + " " + std::to_string(dims.y) +
                                       " " + std::to_string(dims.z) + "\nElementType = MET_UCHAR\nElementDataFile = a.raw\n");
    file_ = ::open((folder_ / "a.raw").c_str(), O_RDWR | O_CREAT, 0600);
    whole_ = file_ >= 0 && ::ftruncate(file_, static_cast<off_t>(grid().voxelCount())) == 0;
  }
  ~SparseVolume() { ::close(file_); }
  SparseVolume(const SparseVolume&) = delete;
  SparseVolume& operator=(const SparseVolume&) = delete;

  [[nodiscard]] bool whole() const { return whole_; }
  [[nodiscard]] const std::filesystem::path& header() const { return header_; }
  [[nodiscard]] Grid grid() const { return {.dims = dims_}; }
  void set(int i, int j, int k, std::uint8_t value) {
    EXPECT_EQ(::pwrite(file_, &value, 1, static_cast<off_t>(grid().indexOf(i, j, k))), 1);
  }

 private:
  TempFolder folder_;
  glm::ivec3 dims_;
  std::filesystem::path header_;
  int file_ = -1;
  bool whole_ = false;
};

Transform<frame::Voxel, frame::Image> plane(const glm::dvec3& perX, const glm::dvec3& perY, const glm::dvec3& start) {
  Transform<frame::Voxel, frame::Image> matrix;
  matrix.matrix = glm::dmat4(glm::dvec4(perX, 0), glm::dvec4(perY, 0), glm::dvec4(glm::cross(perX, perY), 0), glm::dvec4(start, 1));
  return matrix;
}

std::uint64_t statusKib(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(field)) return std::stoull(line.substr(field.size()));
  return 0;
}

TEST(HardMappedVolume, MoreThanTwoToThe32VoxelsAreReachedToTheLastOne) {
  SparseVolume volume({1700, 1700, 1600});  // 4.62e9 voxels
  if (!volume.whole()) GTEST_SKIP() << "the file system takes no sparse file of 4.6 GB";
  const glm::ivec3 last = volume.grid().dims - 1;
  volume.set(0, 0, 0, 200);
  volume.set(last.x, last.y, last.z, 201);
  volume.set(last.x - 3, last.y - 2, last.z, 120);
  const auto mapped = mapVolume(volume.header());
  ASSERT_TRUE(mapped) << mapped.error();
  ASSERT_GT(mapped->view().grid.voxelCount(), std::uint64_t{1} << 32);
  GreyImage image(8, 8);
  SliceScratch scratch;
  for (const Quality quality : {Quality::weave, Quality::linear}) {
    slice(quality, mapped->view(), plane({1, 0, 0}, {0, 1, 0}, glm::dvec3(last) - glm::dvec3(7, 7, 0)), viewOf(image), scratch);
    EXPECT_EQ(image.pixels[63], 201) << "the last voxel";
    EXPECT_EQ(image.pixels[5 * 8 + 4], 120);
    EXPECT_EQ(image.pixels[0], 0);
    slice(quality, mapped->view(), plane({1, 0, 0}, {0, 0, 1}, glm::dvec3(0.0)), viewOf(image), scratch);
    EXPECT_EQ(image.pixels[0], 200) << "the first voxel";
  }
}

TEST(HardMappedVolume, FourGibibytesSweptFromAllSidesAreGivenBackUntilLessThanOneIsResident) {
  SparseVolume volume({1024, 2048, 2048});
  if (!volume.whole()) GTEST_SKIP() << "the file system takes no sparse file of 4 GiB";
  const auto mapped = mapVolume(volume.header());
  ASSERT_TRUE(mapped) << mapped.error();
  GreyImage image(1024, 768);
  SliceScratch scratch;
  std::uint64_t highest_kib = 0;
  // How soon the watcher gets the processor is the machine's affair; that it then gives pages back, without being told, is not.
  const auto sliceAndRest = [&](const glm::dvec3& perX, const glm::dvec3& perY, const glm::dvec3& start) {
    slice(Quality::linear, mapped->view(), plane(perX, perY, start), viewOf(image), scratch);
    highest_kib = std::max(highest_kib, statusKib("VmRSS:"));
    const auto patience_end = std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(test::kPatience_ms);
    while (statusKib("VmRSS:") >= 1u << 20 && std::chrono::steady_clock::now() < patience_end)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_LT(statusKib("VmRSS:"), 1u << 20);
  };
  // Slices across the rows of the volume take a page for each pixel: together they touch all of the file.
  for (int n = 0; n < 8; ++n) sliceAndRest({0, 2, 0}, {0, 0, 2.6}, {127.0 * n, 0, 0});
  for (int n = 0; n < 8; ++n) sliceAndRest({1, 0, 0}, {0, 0, 2.6}, {0, 255.0 * n, 0});
  for (int n = 0; n < 8; ++n) sliceAndRest({0.6, 0.8, 0.9}, {0.3, -0.9, 2.4}, {100, 600 + 8.0 * n, 40.0 * n});
  RecordProperty("highest_mib", static_cast<int>(highest_kib / 1024));
  std::cout << "highest resident memory after a slice " << highest_kib / 1024 << " MiB\n";
  EXPECT_GT(highest_kib, 64u << 10) << "the sweep took up pages at all";
}

}  // namespace
}  // namespace ew::mapped_volume_test
