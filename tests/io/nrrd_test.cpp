#include <gtest/gtest.h>

#include "ew/io/volume_file.h"
#include "files.h"

namespace ew::nrrd_test {
namespace {
using namespace test;

const std::string kStart = "NRRD0005\n";
const std::string kPlain = "type: uchar\ndimension: 3\nsizes: 2 3 2\nencoding: raw\n";

TEST(NrrdVolume, RawGzipAndTextHoldTheSame) {
  const TempFolder folder;
  const std::string geometry =
      "space: left-posterior-superior\nspace directions: (0.5,0,0) (0,0,2) (0,-3,0)\nspace origin: (1.25,-2,3e1)\nkinds: domain domain "
      "domain\n";
  std::string numbers;
  for (int i = 0; i < 12; ++i) numbers += std::to_string(i) + (i % 3 == 2 ? "\n" : " ");
  const std::string sizes = "type: unsigned char\ndimension: 3\nsizes: 2 3 2\n";
  const auto raw = folder.put("a.nrrd", kStart + sizes + geometry + "encoding: raw\n\n" + ramp(12));
  const auto gzip = folder.put("b.nrrd", kStart + sizes + geometry + "encoding: gzip\n\n" + deflated(ramp(12), true));
  const auto text = folder.put("c.nrrd", kStart + sizes + geometry + "encoding: ascii\n\n" + numbers);
  ASSERT_FALSE(folder.put("d.bin", "skip me" + ramp(12)).empty());
  const auto detached = folder.put("d.nhdr", kStart + sizes + geometry + "encoding: raw\nbyte skip: 7\ndata file: d.bin");
  const auto atEnd = folder.put("e.nhdr", kStart + sizes + geometry + "encoding: raw\nbyte skip: -1\ndata file: d.bin\n");
  for (const auto& file : {raw, gzip, text, detached, atEnd}) {
    const auto loaded = readVolume(file);
    ASSERT_TRUE(succeeded(loaded)) << file;
    EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})) << file;
    const Grid& grid = loaded->volume.grid;
    EXPECT_EQ(grid.dims, glm::ivec3(2, 3, 2));
    EXPECT_EQ(grid.spacing_mm, glm::dvec3(0.5, 2, 3));
    EXPECT_EQ(grid.origin_mm, glm::dvec3(1.25, -2, 30));
    EXPECT_EQ(grid.directions, glm::dmat3(1, 0, 0, 0, 0, 1, 0, -1, 0));
    EXPECT_TRUE(loaded->notes.empty()) << file;
  }
}

TEST(NrrdVolume, TheNamedSpaceDecidesTheSigns) {
  const TempFolder folder;
  const auto read = [&](const std::string& space) {
    return readVolume(
        folder.put("a.nrrd", kStart + kPlain + space + "space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (1,2,3)\n\n" + ramp(12)));
  };
  const auto at = [](const Result<VolumeReadResult>& loaded) {
    return (loaded->volume.grid.voxelToWorld() * Point<frame::Voxel>{{1, 1, 1}}).at;
  };
  EXPECT_EQ(at(read("space: left-posterior-superior\n")), glm::dvec3(3, 4, 5));
  EXPECT_EQ(at(read("space: right-anterior-superior\n")), glm::dvec3(-3, -4, 5));
  EXPECT_EQ(at(read("space: RAS\n")), glm::dvec3(-3, -4, 5));
  EXPECT_EQ(at(read("space: left-anterior-superior\n")), glm::dvec3(3, -4, 5));
  const auto unnamed = read("space dimension: 3\n");
  EXPECT_EQ(at(unnamed), glm::dvec3(3, 4, 5));
  EXPECT_TRUE(contains(unnamed->notes, "not named"));
  const auto scanner = read("space: scanner-xyz\n");
  EXPECT_EQ(at(scanner), glm::dvec3(3, 4, 5));
  EXPECT_TRUE(contains(scanner->notes, "scanner-xyz"));
}

TEST(NrrdVolume, BareSpacingsAreEnough) {
  const TempFolder folder;
  const auto loaded = readVolume(folder.put("a.nrrd", kStart + kPlain + "spacings: 0.5 0.25 2\n\n" + ramp(12)));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ(loaded->volume.grid.spacing_mm, glm::dvec3(0.5, 0.25, 2));
}

TEST(NrrdVolume, ByteOrderAndTypeNamesAreHonoured) {
  const TempFolder folder;
  const std::vector<std::uint16_t> samples{0, 256, 255 * 256, 128 * 256};
  for (const bool big : {false, true})
    for (const char* type : {"ushort", "uint16_t", "unsigned short int"}) {
      const auto loaded =
          readVolume(folder.put("a.nrrd", kStart + "type: " + type + "\ndimension: 3\nsizes: 4 1 1\nencoding: raw\nendian: " +
                                              (big ? "big" : "little") + "\n\n" + bytesOf(samples, big)));
      ASSERT_TRUE(succeeded(loaded));
      EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{0, 1, 255, 128}));
    }
  const auto silent =
      readVolume(folder.put("a.nrrd", kStart + "type: short\ndimension: 3\nsizes: 4 1 1\nencoding: raw\n\n" + bytesOf(samples)));
  EXPECT_TRUE(failedWith(silent, ErrorCode::badField));
  EXPECT_TRUE(says(silent, "endian"));
}

TEST(NrrdVolume, ColourAxesBecomeLuminance) {
  const TempFolder folder;
  const auto loaded =
      readVolume(folder.put("a.nrrd", kStart +
                                          "type: uchar\ndimension: 4\nsizes: 3 2 1 1\nspace: LPS\nkinds: RGB-color domain domain domain\n"
                                          "space directions: none (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\n\n" +
                                          std::string("\xff\xff\xff\x00\x00\xff", 6)));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ(loaded->volume.grid.dims, glm::ivec3(2, 1, 1));
  EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{255, 29}));
}

TEST(NrrdVolume, WrongHeadersAreRefusedInOneSentence) {
  const TempFolder folder;
  const auto code = [&](const std::string& text) {
    const auto loaded = readVolume(folder.put("a.nrrd", text));
    EXPECT_FALSE(loaded.has_value()) << text;
    return loaded ? ErrorCode::internal : loaded.error().code;
  };
  EXPECT_EQ(code("hello\n"), ErrorCode::badHeader);
  EXPECT_EQ(code(std::string(100, '\0')), ErrorCode::badHeader);
  EXPECT_EQ(code(kStart + kPlain), ErrorCode::truncated);
  EXPECT_EQ(code(kStart + "type: block\ndimension: 3\nsizes: 2 3 2\nencoding: raw\n\n" + ramp(12)), ErrorCode::badField);
  EXPECT_EQ(code(kStart + "type: uchar\ndimension: 2\nsizes: 2 3 2\nencoding: raw\n\n" + ramp(12)), ErrorCode::badField);
  EXPECT_EQ(code(kStart + "type: uchar\ndimension: 3\nsizes: 2 3 2\nencoding: bzip2\n\n" + ramp(12)), ErrorCode::unsupported);
  EXPECT_EQ(code(kStart + kPlain + "data file: slice%03d.raw 1 2 1\n\n"), ErrorCode::unsupported);
  EXPECT_EQ(code(kStart + kPlain + "data file: LIST\na.raw\n"), ErrorCode::badHeader);
  EXPECT_EQ(code(kStart + kPlain + "space directions: (1,0,0) (0,1,0)\n\n" + ramp(12)), ErrorCode::badField);
  EXPECT_EQ(code(kStart + kPlain + "space directions: (1,0,0) (0,0,0) (0,0,1)\n\n" + ramp(12)), ErrorCode::badField);
  EXPECT_EQ(code(kStart + kPlain + "space directions: 1,0,0\n\n" + ramp(12)), ErrorCode::badField);
  EXPECT_EQ(code(kStart + kPlain + "kinds: domain domain\n\n" + ramp(12)), ErrorCode::badField);
  EXPECT_EQ(code(kStart + kPlain + "spacings: 1 -1 1\n\n" + ramp(12)), ErrorCode::badField);
  EXPECT_EQ(code(kStart + kPlain + "\n" + ramp(11)), ErrorCode::truncated);
  EXPECT_EQ(code(kStart + "type: uchar\ndimension: 3\nsizes: 2 3 2\nencoding: gzip\n\n" + deflated(ramp(13), true)), ErrorCode::badHeader);
  EXPECT_EQ(code(kStart + "type: uchar\ndimension: 3\nsizes: 2 3 2\nencoding: gzip\n\n" + deflated(ramp(11), true)), ErrorCode::truncated);
}

}  // namespace
}  // namespace ew::nrrd_test
