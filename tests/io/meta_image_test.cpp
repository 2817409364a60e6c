#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "ew/io/volume_file.h"
#include "files.h"

namespace ew::meta_image_test {
namespace {
using namespace test;

Volume oblique() {
  Volume volume;
  volume.grid.dims = {5, 4, 3};
  volume.grid.spacing_mm = {0.3, 0.70000000000000007, 1.1};
  volume.grid.origin_mm = {-74.5217, 165.573, 1e6 + 0.123456789};
  volume.grid.directions = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, 3))));
  for (int i = 0; i < 60; ++i) volume.echo.push_back(static_cast<std::uint8_t>(i * 37));
  return volume;
}

std::string header(const std::string& lines, const std::string& end = "ElementDataFile = LOCAL\n") {
  return "ObjectType = Image\n" + lines + end;
}

TEST(MetaImageVolume, ComesBackBitForBitInEveryForm) {
  const TempFolder folder;
  const Volume volume = oblique();
  for (const auto& [name, compress] : {std::pair("a.mha", true), std::pair("b.mha", false), std::pair("c.mhd", false)}) {
    ASSERT_TRUE(succeeded(writeVolume(volume, folder / name, noProgress(), {.compress = compress}))) << name;
    const auto loaded = readVolume(folder / name);
    ASSERT_TRUE(succeeded(loaded)) << name;
    EXPECT_EQ(loaded->volume, volume) << name;
  }
  EXPECT_EQ(folder.names().size(), 4u) << "a.mha, b.mha, c.mhd and c.raw, and nothing left over";
  EXPECT_EQ(std::filesystem::file_size(folder / "c.raw"), 60u);
}

RC_GTEST_PROP(MetaImageVolume, ComesBackWhateverItsGridIs, ()) {
  const TempFolder folder;
  Volume volume;
  volume.grid.dims = {*rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9)};
  const auto number = [](double scale) { return (*rc::gen::inRange(-1000000, 1000001) + 0.1) * scale / 1e6; };
  for (int axis = 0; axis < 3; ++axis) {
    volume.grid.spacing_mm[axis] = std::abs(number(3.0)) + 1e-4;
    volume.grid.origin_mm[axis] = number(*rc::gen::element(1.0, 500.0, 1e6));
  }
  const glm::dvec3 about(number(1.0), number(1.0), number(1.0) + 1.5);
  volume.grid.directions = glm::dmat3(glm::rotate(glm::dmat4(1.0), number(3.0), glm::normalize(about)));
  if (*rc::gen::arbitrary<bool>()) volume.grid.directions[2] *= -1.0;
  volume.echo = *rc::gen::container<std::vector<std::uint8_t>>(volume.grid.voxelCount(), rc::gen::arbitrary<std::uint8_t>());
  const auto file = folder / (*rc::gen::arbitrary<bool>() ? "v.mha" : "v.mhd");
  RC_ASSERT(writeVolume(volume, file, noProgress(), {.compress = *rc::gen::arbitrary<bool>()}).has_value());
  const auto loaded = readVolume(file);
  RC_ASSERT(loaded.has_value());
  RC_ASSERT(loaded->volume == volume);
}

TEST(MetaImageVolume, TransformMatrixHasOneAxisPerRow) {
  const TempFolder folder;
  const auto file = folder.put("a.mha", header("NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nElementSpacing = 2 3 4\n"
                                               "TransformMatrix = 0 1 0 0 0 1 1 0 0\nOffset = 10 20 30\n") +
                                            ramp(2));
  const auto loaded = readVolume(file);
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ((loaded->volume.grid.voxelToWorld() * Point<frame::Voxel>{{1, 0, 0}}).at, glm::dvec3(10, 22, 30));
  EXPECT_EQ((loaded->volume.grid.voxelToWorld() * Point<frame::Voxel>{{0, 1, 0}}).at, glm::dvec3(10, 20, 33));
  EXPECT_EQ((loaded->volume.grid.voxelToWorld() * Point<frame::Voxel>{{0, 0, 1}}).at, glm::dvec3(14, 20, 30));
}

TEST(MetaImageVolume, OriginPositionAndElementSizeAreOtherNamesOfTheSame) {
  const TempFolder folder;
  for (const char* name : {"Offset", "Position", "Origin"}) {
    const auto file = folder.put(
        "a.mha",
        header(std::string("NDims = 3\nDimSize = 1 1 2\nElementType = MET_UCHAR\nElementSize = 1 1 2.5\n") + name + " = 1 2 3.25\n") +
            ramp(2));
    const auto loaded = readVolume(file);
    ASSERT_TRUE(succeeded(loaded)) << name;
    EXPECT_EQ(loaded->volume.grid.origin_mm, glm::dvec3(1, 2, 3.25)) << name;
    EXPECT_EQ(loaded->volume.grid.spacing_mm, glm::dvec3(1, 1, 2.5));
  }
}

template <class T>
void expectMapped(const char* type, const std::vector<T>& samples, bool bigEndian, const std::vector<std::uint8_t>& expected) {
  const TempFolder folder;
  const auto file = folder.put(
      "a.mha", header("NDims = 3\nDimSize = " + std::to_string(samples.size()) + " 1 1\nElementSpacing = 2 2 2\nElementType = " + type +
                      "\nBinaryDataByteOrderMSB = " + (bigEndian ? "True\n" : "False\n")) +
                   bytesOf(samples, bigEndian));
  const auto loaded = readVolume(file);
  ASSERT_TRUE(succeeded(loaded)) << type;
  EXPECT_EQ(loaded->volume.echo, expected) << type;
  EXPECT_TRUE(contains(loaded->notes, "were mapped to 0 to 255")) << type;
}

TEST(MetaImageVolume, EveryTypeIsMappedFromItsSmallestToItsLargestValueInBothByteOrders) {
  for (const bool big : {false, true}) {
    expectMapped<std::int8_t>("MET_CHAR", {-128, 127, 0, -1}, big, {0, 255, 128, 127});
    expectMapped<std::uint16_t>("MET_USHORT", {0, 65535, 257, 514}, big, {0, 255, 1, 2});
    expectMapped<std::int16_t>("MET_SHORT", {-1000, 1000, 0}, big, {0, 255, 128});
    expectMapped<std::uint32_t>("MET_UINT", {0, 4294967295u, 2147483648u}, big, {0, 255, 128});
    expectMapped<std::int32_t>("MET_INT", {-2147483647 - 1, 2147483647, 0}, big, {0, 255, 128});
    expectMapped<std::int32_t>("MET_LONG", {-5, 5, -3}, big, {0, 255, 51});
    expectMapped<std::uint64_t>("MET_ULONG_LONG", {0, ~0ull, 1ull << 63}, big, {0, 255, 128});
    expectMapped<std::int64_t>("MET_LONG_LONG", {-10, 10, -6}, big, {0, 255, 51});
    expectMapped<float>("MET_FLOAT", {-0.5F, 0.5F, -0.25F}, big, {0, 255, 64});
    expectMapped<double>("MET_DOUBLE", {-1.7e308, 1.7e308, 0.0}, big, {0, 255, 128});
  }
}

TEST(MetaImageVolume, SamplesThatAreNoNumbersBecomeBlackAndAreCounted) {
  const TempFolder folder;
  const std::vector<float> samples{1.0F, std::numeric_limits<float>::quiet_NaN(), 3.0F, std::numeric_limits<float>::infinity(), 2.0F};
  const auto loaded = readVolume(folder.put("a.mha", header("NDims = 3\nDimSize = 5 1 1\nElementType = MET_FLOAT\n") + bytesOf(samples)));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{0, 0, 255, 0, 128}));
  EXPECT_TRUE(contains(loaded->notes, "2 samples are not finite"));
}

TEST(MetaImageVolume, ColoursBecomeLuminanceAndOtherChannelsAreRefused) {
  const TempFolder folder;
  const std::string colours("\xff\x00\x00\x00\xff\x00\x00\x00\xff\xff\xff\xff", 12);
  const auto text = [&](int channels) {
    return header("NDims = 3\nDimSize = 4 1 1\nElementType = MET_UCHAR\nElementNumberOfChannels = " + std::to_string(channels) + "\n");
  };
  const auto loaded = readVolume(folder.put("rgb.mha", text(3) + colours));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{76, 150, 29, 255}));
  EXPECT_TRUE(contains(loaded->notes, "luminance"));
  const auto two = readVolume(folder.put("two.mha", text(2) + ramp(8)));
  EXPECT_TRUE(failedWith(two, ErrorCode::unsupported));
  EXPECT_TRUE(says(two, "2 values per sample"));
}

TEST(MetaImageVolume, FlatFilesAreOneSliceAndLongerOnesGiveTheirFirstVolume) {
  const TempFolder folder;
  const auto flat = readVolume(folder.put("flat.mha", header("NDims = 2\nDimSize = 3 2\nElementSpacing = 0.5 0.25\nOffset = 1 2\n"
                                                             "TransformMatrix = 0 1 -1 0\nElementType = MET_UCHAR\n") +
                                                          ramp(6)));
  ASSERT_TRUE(succeeded(flat));
  EXPECT_EQ(flat->volume.grid.dims, glm::ivec3(3, 2, 1));
  EXPECT_EQ(flat->volume.grid.directions[0], glm::dvec3(0, 1, 0));
  EXPECT_EQ(flat->volume.grid.directions[2], glm::dvec3(0, 0, 1));
  const auto four = readVolume(
      folder.put("four.mha", header("NDims = 4\nDimSize = 2 2 2 3\nElementSpacing = 1 2 3 4\nElementType = MET_UCHAR\n") + ramp(24)));
  ASSERT_TRUE(succeeded(four));
  EXPECT_EQ(four->volume.echo.size(), 8u);
  EXPECT_EQ(four->volume.echo[7], 7);
  EXPECT_TRUE(contains(four->notes, "3 volumes"));
}

TEST(MetaImageVolume, TextSamplesAreRead) {
  const TempFolder folder;
  const auto file = folder.put("a.mha", header("NDims = 3\nBinaryData = False\nDimSize = 3 1 1\nElementType = MET_UCHAR\n") + "7 8\n 255");
  const auto loaded = readVolume(file);
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{7, 8, 255}));
  const auto beyond =
      readVolume(folder.put("b.mha", header("NDims = 3\nBinaryData = False\nDimSize = 3 1 1\nElementType = MET_UCHAR\n") + "7 8 256"));
  EXPECT_TRUE(failedWith(beyond, ErrorCode::badField));
}

TEST(MetaImageVolume, SaysWhenTheSpacingIsProbablyUnknown) {
  const TempFolder folder;
  const auto dummy = readVolume(folder.put("a.mha", header("NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\n") + ramp(2)));
  ASSERT_TRUE(succeeded(dummy));
  EXPECT_TRUE(contains(dummy->notes, "spacing is probably unknown"));
  const auto placed =
      readVolume(folder.put("b.mha", header("NDims = 3\nDimSize = 2 1 1\nOffset = 0 0 1\nElementType = MET_UCHAR\n") + ramp(2)));
  ASSERT_TRUE(succeeded(placed));
  EXPECT_FALSE(placed->spacingKnown) << "a place says nothing of the spacing";
  EXPECT_TRUE(contains(placed->notes, "no spacing"));
  const auto stated = readVolume(folder.put(
      "c.mha", header("NDims = 3\nDimSize = 2 1 1\nOffset = 0 0 1\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n") + ramp(2)));
  ASSERT_TRUE(succeeded(stated));
  EXPECT_TRUE(stated->spacingKnown);
  EXPECT_TRUE(stated->notes.empty());
}

TEST(MetaImageVolume, KnownHeaderSizesAndTrailingSamplesAreHonoured) {
  const TempFolder folder;
  ASSERT_FALSE(folder.put("a.raw", "junk" + ramp(4)).empty());
  const std::string text = "NDims = 3\nDimSize = 4 1 1\nElementType = MET_UCHAR\n";
  for (const char* size : {"4", "-1"}) {
    const auto loaded = readVolume(folder.put("a.mhd", header(text + "HeaderSize = " + size + "\n", "ElementDataFile = a.raw")));
    ASSERT_TRUE(succeeded(loaded)) << size;
    EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{0, 1, 2, 3})) << size;
  }
}

TEST(MetaImageVolume, WrongFieldsAreNamedWithWhatWasFoundAndExpected) {
  const TempFolder folder;
  struct Case {
    const char* lines;
    const char* field;
  };
  for (const auto& [lines, field] :
       {Case{"NDims = 3\nDimSize = 2 1\nElementType = MET_UCHAR\n", "DimSize"},
        Case{"NDims = 3\nDimSize = 2 1 -1\nElementType = MET_UCHAR\n", "DimSize"},
        Case{"NDims = 3\nDimSize = two 1 1\nElementType = MET_UCHAR\n", "DimSize"},
        Case{"NDims = 3\nDimSize = 2 1 1\nElementType = MET_STRING\n", "ElementType"}, Case{"NDims = 3\nDimSize = 2 1 1\n", "ElementType"},
        Case{"NDims = 3\nElementType = MET_UCHAR\n", "DimSize"},
        Case{"NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nOffset = 0 0\n", "Offset"},
        Case{"NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nOffset = 0 0 nan\n", "Offset"},
        Case{"NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nTransformMatrix = 1 0 0 1\n", "TransformMatrix"},
        Case{"NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nElementSpacing = 1,5 1 1\n", "ElementSpacing"},
        Case{"NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nCompressedData = perhaps\n", "CompressedData"},
        Case{"NDims = 99\nDimSize = 2 1 1\nElementType = MET_UCHAR\n", "NDims"},
        Case{"NDims = 3\nDimSize = 2 1 1\nElementType = MET_OTHER\n", "ElementType"}}) {
    const auto loaded = readVolume(folder.put("a.mha", header(lines) + ramp(2)));
    EXPECT_TRUE(failedWith(loaded, ErrorCode::badField)) << lines;
    EXPECT_TRUE(says(loaded, field)) << lines;
  }
  const auto negative =
      readVolume(folder.put("a.mha", header("NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nElementSpacing = 1 0 1\n") + ramp(2)));
  EXPECT_TRUE(failedWith(negative, ErrorCode::badField));
  const auto flat = readVolume(
      folder.put("a.mha", header("NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nTransformMatrix = 1 0 0 1 0 0 0 0 1\n") + ramp(2)));
  EXPECT_TRUE(failedWith(flat, ErrorCode::badField));
}

TEST(MetaImageVolume, WhatIsNotThereOrNoFileIsSaidPlainly) {
  const TempFolder folder;
  EXPECT_TRUE(failedWith(readVolume(folder / "no.mha"), ErrorCode::notFound));
  EXPECT_TRUE(failedWith(readVolume(folder.path()), ErrorCode::notReadable));
  EXPECT_TRUE(failedWith(readVolume(folder.put("a.txt", "hello")), ErrorCode::unsupported));
  EXPECT_TRUE(failedWith(readVolume(folder.put("a.mha", "hello")), ErrorCode::badHeader));
  EXPECT_TRUE(failedWith(readVolume(folder.put("b.mha", std::string(5000, '\0'))), ErrorCode::badHeader));
  EXPECT_TRUE(failedWith(readVolume(folder.put("c.mha", "")), ErrorCode::badHeader));
  const auto detached =
      readVolume(folder.put("d.mhd", header("NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\n", "ElementDataFile = gone.raw")));
  EXPECT_TRUE(failedWith(detached, ErrorCode::notFound));
  EXPECT_TRUE(says(detached, "gone.raw"));
  for (const char* name : {"LIST", "slice%03d.raw 1 9 1"}) {
    const auto many = readVolume(
        folder.put("e.mhd", header("NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\n", std::string("ElementDataFile = ") + name)));
    EXPECT_TRUE(failedWith(many, ErrorCode::unsupported)) << name;
  }
}

TEST(MetaImageVolume, ACancelledReadOrWriteLeavesNothing) {
  const TempFolder folder;
  Volume volume;
  volume.grid.dims = {128, 128, 256};
  volume.echo.assign(volume.grid.voxelCount(), 9);
  for (const char* name : {"a.mha", "a.mhd"}) {
    StopAfter soon(1);
    EXPECT_TRUE(failedWith(writeVolume(volume, folder / name, soon), ErrorCode::cancelled));
  }
  EXPECT_TRUE(folder.names().empty());
  ASSERT_TRUE(succeeded(writeVolume(volume, folder / "a.mha")));
  StopAfter later(2);
  EXPECT_TRUE(failedWith(readVolume(folder / "a.mha", later), ErrorCode::cancelled));
  StopAfter never(1 << 30);
  EXPECT_TRUE(succeeded(readVolume(folder / "a.mha", never)));
}

TEST(MetaImageVolume, AnEmptyOrCrookedVolumeIsNotWritten) {
  const TempFolder folder;
  EXPECT_TRUE(failedWith(writeVolume(Volume{}, folder / "a.mha"), ErrorCode::emptyVolume));
  EXPECT_TRUE(failedWith(writeVolume(oblique(), folder / "a.nii"), ErrorCode::unsupported));
  EXPECT_TRUE(folder.names().empty());
  const auto empty = readVolume(folder.put("e.mha", header("NDims = 3\nDimSize = 0 4 4\nElementType = MET_UCHAR\n")));
  EXPECT_TRUE(failedWith(empty, ErrorCode::emptyVolume));
}

}  // namespace
}  // namespace ew::meta_image_test
