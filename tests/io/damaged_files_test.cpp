#include <gtest/gtest.h>

#include <random>

#include "ew/io/image_file.h"
#include "ew/io/sweep.h"
#include "files.h"

namespace ew::damaged_files_test {
namespace {
using namespace test;

constexpr ReaderLimits kSmall{.maxBytes = 1u << 20};

Sequence smallSequence() {
  Sequence sequence;
  sequence.width = 7;
  sequence.height = 5;
  for (int i = 0; i < 3; ++i) {
    SequenceFrame frame;
    frame.time_s = i;
    frame.imageStatus = PoseStatus::ok;
    frame.transforms.push_back({"Image", "Reference", glm::dmat4(1.0 + i), PoseStatus::ok});
    frame.transforms.back().matrix[3][3] = 1.0;
    frame.otherFields.emplace_back("ProbePosition", "7");
    sequence.frames.push_back(frame);
  }
  for (int i = 0; i < 7 * 5 * 3; ++i) sequence.pixels.push_back(static_cast<std::uint8_t>(i * 91));
  return sequence;
}

std::string smallNifti() {
  std::string bytes(352, '\0');
  const auto set = [&](std::size_t offset, const std::string& raw) { bytes.replace(offset, raw.size(), raw); };
  set(0, bytesOf(std::vector<std::int32_t>{348}));
  set(40, bytesOf(std::vector<std::int16_t>{3, 3, 2, 2, 1, 1, 1, 1}));
  set(70, bytesOf(std::vector<std::int16_t>{4, 16}));
  set(76, bytesOf(std::vector<float>{1, 0.5, 0.5, 2, 1, 1, 1, 1, 352}));
  set(344, std::string("n+1\0", 4));
  return bytes + ramp(24);
}

struct Seed {
  const char* name;
  std::string bytes;
};

/// One small file of each format, as our own writers and the formats' rules make them.
std::vector<Seed> seeds(const TempFolder& folder) {
  Volume volume;
  volume.grid.dims = {6, 5, 4};
  volume.grid.spacing_mm = {0.5, 0.5, 0.5};
  for (int i = 0; i < 120; ++i) volume.echo.push_back(static_cast<std::uint8_t>(i * 7));
  EXPECT_TRUE(succeeded(writeVolume(volume, folder / "v.mha")));
  EXPECT_TRUE(succeeded(writeVolume(volume, folder / "r.mha", noProgress(), {.compress = false})));
  EXPECT_TRUE(succeeded(writeSequence(smallSequence(), folder / "s.igs.mha")));
  const std::string nrrd =
      "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 2 2\nspace: left-posterior-superior\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n"
      "space origin: (1,2,3)\nkinds: domain domain list\nendian: little\nencoding: gzip\nSeq_Frame0000_Status:=OK\n"
      "Seq_Frame0001_ImageToReferenceTransform:=1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n\n";
  return {{"v.mha", bytesOfFile(folder / "v.mha")},
          {"r.mha", bytesOfFile(folder / "r.mha")},
          {"s.igs.mha", bytesOfFile(folder / "s.igs.mha")},
          {"n.nrrd", nrrd + deflated(ramp(24), true)},
          {"n.nii", smallNifti()},
          {"n.nii.gz", deflated(smallNifti(), true)}};
}

/// Reads in every way the program could try, and checks that what comes out is whole.
void readEverything(const std::filesystem::path& file) {
  if (const auto volume = readVolume(file, noProgress(), kSmall)) {
    ASSERT_EQ(volume->volume.echo.size(), volume->volume.grid.voxelCount());
    ASSERT_TRUE(checkGrid(volume->volume.grid).has_value());
  } else {
    ASSERT_TRUE(volume.error().sentence().ends_with('.')) << volume.error();
    ASSERT_NE(volume.error().code, ErrorCode::internal) << volume.error();
  }
  if (const auto sequence = readSequence(file, noProgress(), kSmall)) {
    const auto pixels = static_cast<std::size_t>(sequence->width) * static_cast<std::size_t>(sequence->height) * sequence->frames.size();
    ASSERT_EQ(sequence->pixels.size(), pixels);
    ASSERT_FALSE(sequence->frames.empty());
    static_cast<void>(sweepPoses(*sequence));
  } else {
    ASSERT_TRUE(sequence.error().sentence().ends_with('.')) << sequence.error();
    ASSERT_NE(sequence.error().code, ErrorCode::internal) << sequence.error();
  }
  static_cast<void>(isSequence(file));
  static_cast<void>(readImage(file));
}

TEST(DamagedFiles, CutAtAnyByteTheyAreRefused) {
  const TempFolder folder;
  for (const auto& [name, bytes] : seeds(folder)) {
    readEverything(folder / name);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const auto file = folder.put(name, bytes.substr(0, length));
      ASSERT_FALSE(readVolume(file, noProgress(), kSmall).has_value()) << name << " cut after " << length << " of " << bytes.size();
      ASSERT_FALSE(readSequence(file, noProgress(), kSmall).has_value()) << name << " cut after " << length << " of " << bytes.size();
    }
  }
}

TEST(DamagedFiles, WithRandomBytesChangedTheyNeverDoHarm) {
  const TempFolder folder;
  std::mt19937 random(20261120);
  for (const auto& [name, bytes] : seeds(folder)) {
    for (int round = 0; round < 700; ++round) {
      std::string damaged = bytes;
      const std::size_t changes = 1 + random() % 4;
      for (std::size_t change = 0; change < changes; ++change) {
        // Half of the hits go to the beginning, where headers decide about sizes.
        const std::size_t reach = random() % 2 == 0 ? std::min<std::size_t>(damaged.size(), 400) : damaged.size();
        const std::size_t at = random() % reach;
        switch (random() % 4) {
          case 0:
            damaged[at] = static_cast<char>(random());
            break;
          case 1:
            damaged[at] = static_cast<char>('0' + random() % 10);
            break;
          case 2:
            damaged.insert(at, 1 + random() % 12, static_cast<char>('0' + random() % 10));
            break;
          default:
            damaged.erase(at, 1 + random() % 6);
            break;
        }
        if (damaged.empty()) damaged = "x";
      }
      SCOPED_TRACE(std::string(name) + " round " + std::to_string(round));
      readEverything(folder.put(name, damaged));
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace ew::damaged_files_test
