#include <gtest/gtest.h>
#include <sys/resource.h>

#include <glm/gtc/matrix_transform.hpp>

#include "ew/core/memory.h"
#include "ew/io/image_file.h"
#include "ew/io/sweep.h"
#include "io/files.h"

namespace ew::io_test {
namespace {
using namespace test;

long peakMemory_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// A sweep of `frames` frames with a direct Image to Reference.
Sequence sweep(std::size_t frames) {
  Sequence sequence;
  sequence.width = 4;
  sequence.height = 3;
  sequence.frames.resize(frames);
  sequence.pixels.assign(12 * frames, 7);
  for (std::size_t i = 0; i < frames; ++i) {
    sequence.frames[i].time_s = static_cast<double>(i);
    sequence.frames[i].transforms.push_back(
        {"Image", "Reference", glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, static_cast<double>(i))), glm::dvec3(0.3)),
         PoseStatus::ok});
  }
  return sequence;
}

TEST(HardFiles, AHeaderThatPromisesTenToTheTwelveBytesIsRefusedAtOnceWithoutTakingMemory) {
  const TempFolder folder;
  const std::string mha = "ObjectType = Image\nNDims = 3\nDimSize = 10000 10000 10000\nElementType = MET_UCHAR\n";
  std::string nifti(352, '\0');
  const auto set = [&](std::size_t offset, const std::string& raw) { nifti.replace(offset, raw.size(), raw); };
  set(0, bytesOf(std::vector<std::int32_t>{348}));
  set(40, bytesOf(std::vector<std::int16_t>{3, 10000, 10000, 10000}));
  set(70, bytesOf(std::vector<std::int16_t>{2, 8}));
  set(76, bytesOf(std::vector<float>{1, 1, 1, 1, 1, 1, 1, 1, 352}));
  set(344, std::string("n+1\0", 4));
  const std::vector<std::filesystem::path> files{
      folder.put("raw.mha", mha + "ElementDataFile = LOCAL\nx"),
      folder.put("packed.mha", mha + "CompressedData = True\nElementDataFile = LOCAL\n" + deflated(ramp(64))),
      folder.put("text.mha", mha + "BinaryData = False\nElementDataFile = LOCAL\n1 2 3"),
      folder.put("raw.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 10000 10000 10000\nencoding: raw\n\nx"),
      folder.put("packed.nrrd",
                 "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 10000 10000 10000\nencoding: gzip\n\n" + deflated(ramp(64), true)),
      folder.put("a.nii", nifti + "x"),
      folder.put("a.nii.gz", deflated(nifti + "x", true))};
  const long before_kib = peakMemory_kib();
  for (const auto& file : files) {
    const auto volume = readVolume(file);
    EXPECT_TRUE(failedWith(volume, ErrorCode::tooLarge)) << file;
    EXPECT_TRUE(says(volume, "1000000000000")) << file;
    EXPECT_TRUE(says(volume, std::to_string(kLargestVolume_bytes))) << file;
    if (file.extension() == ".mha" || file.extension() == ".nrrd") {
      const auto sequence = readSequence(file);
      EXPECT_TRUE(failedWith(sequence, ErrorCode::tooLarge)) << file;
      EXPECT_TRUE(says(sequence, "1000000000000")) << file;
    }
  }
  EXPECT_LT(peakMemory_kib() - before_kib, 64 * 1024);
}

TEST(HardFiles, SizesWhoseProductOverflowsAreRefused) {
  const TempFolder folder;
  for (const char* sizes : {"4294967296 4294967296 4294967296", "1000000000 1000000000 1000000000", "9223372036854775807 2 1",
                            "18446744073709551617 1 1", "1073741824 1073741824 16", "2147483649 0 1"}) {
    const auto file = folder.put("a.mha", std::string("ObjectType = Image\nNDims = 3\nDimSize = ") + sizes +
                                              "\nElementType = MET_DOUBLE\nElementDataFile = LOCAL\nx");
    EXPECT_FALSE(readVolume(file).has_value()) << sizes;
    EXPECT_FALSE(readSequence(file).has_value()) << sizes;
  }
}

TEST(HardFiles, PromisesBelowTheLimitAreStillHeldAgainstTheFile) {
  const TempFolder folder;
  // 8 GB would be allowed, but neither 5 raw bytes nor 72 packed ones can hold them: nothing may be taken to find that out.
  const std::string head = "ObjectType = Image\nNDims = 3\nDimSize = 2000 2000 2000\nElementType = MET_UCHAR\n";
  const long before_kib = peakMemory_kib();
  const auto raw = readVolume(folder.put("a.mha", head + "ElementDataFile = LOCAL\n12345"));
  EXPECT_TRUE(failedWith(raw, ErrorCode::truncated));
  EXPECT_TRUE(says(raw, "8000000000 bytes of samples, the file has 5"));
  const auto packed = readVolume(folder.put("b.mha", head + "CompressedData = True\nElementDataFile = LOCAL\n" + deflated(ramp(64))));
  EXPECT_TRUE(failedWith(packed, ErrorCode::truncated));
  EXPECT_TRUE(says(packed, "8000000000"));
  EXPECT_LT(peakMemory_kib() - before_kib, 64 * 1024);
}

TEST(HardFiles, ABombThatUnpacksToMoreThanPromisedIsStopped) {
  const TempFolder folder;
  const std::string bomb = deflated(std::string(40u << 20, '\0'));
  const auto head = [](int slices) {
    return "ObjectType = Image\nNDims = 3\nDimSize = 1024 1024 " + std::to_string(slices) +
           "\nElementType = MET_UCHAR\nCompressedData = True\nElementDataFile = LOCAL\n";
  };
  const auto more = readVolume(folder.put("a.mha", head(1) + bomb));
  EXPECT_TRUE(failedWith(more, ErrorCode::badHeader));
  EXPECT_TRUE(says(more, "promises 1048576 bytes of samples, but 41943040 are there"));
  std::string speckle((1u << 20) + 256, '\0');
  for (std::uint32_t i = 0, state = 1; i < speckle.size(); ++i)
    speckle[i] = static_cast<char>((state = state * 1664525u + 1013904223u) >> 24);
  const auto less = readVolume(folder.put("b.mha", head(2) + deflated(speckle)));
  EXPECT_TRUE(failedWith(less, ErrorCode::truncated));
  EXPECT_TRUE(says(less, "promises 2097152 bytes of samples, the file has 1048832"));
  const auto thin = readVolume(folder.put("c.mha", head(400) + bomb));
  EXPECT_TRUE(failedWith(thin, ErrorCode::truncated));
  EXPECT_TRUE(says(thin, "which cannot hold them"));
}

TEST(HardFiles, ADamagedCheckSumIsNotOverlooked) {
  const TempFolder folder;
  std::string packed = deflated(ramp(64));
  packed.back() = static_cast<char>(packed.back() ^ 1);
  const auto loaded = readVolume(folder.put(
      "a.mha",
      "ObjectType = Image\nNDims = 3\nDimSize = 64 1 1\nElementType = MET_UCHAR\nCompressedData = True\nElementDataFile = LOCAL\n" +
          packed));
  EXPECT_TRUE(failedWith(loaded, ErrorCode::notReadable));
  EXPECT_TRUE(says(loaded, "damaged"));
}

TEST(HardFiles, AMillionPosesWithoutImagesThatAreNotDescribedAreRefused) {
  const TempFolder folder;
  const auto read = readSequence(folder.put("a.mha",
                                            "ObjectType = Image\nNDims = 3\nDimSize = 0 0 1000000\nElementType = MET_OTHER\nKinds = domain "
                                            "domain list\nElementDataFile = LOCAL\n"));
  EXPECT_TRUE(failedWith(read, ErrorCode::badHeader));
  EXPECT_TRUE(says(read, "1000000 frames"));
}

TEST(HardFiles, AnImageThatPromisesTooManyPixelsIsRefused) {
  const TempFolder folder;
  ASSERT_TRUE(succeeded(writeImage(viewOf(GreyImage(2, 2, 9)), 1.0, folder / "p.png")));
  std::string bytes = bytesOfFile(folder / "p.png");
  bytes.replace(16, 8, std::string("\x00\x01\x86\xa0\x00\x01\x86\xa0", 8));  // 100000 x 100000
  const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + 12), 17);
  for (int i = 0; i < 4; ++i) bytes[29 + static_cast<std::size_t>(i)] = static_cast<char>(checksum >> (24 - 8 * i));
  const auto read = readImage(folder.put("q.png", bytes));
  EXPECT_TRUE(failedWith(read, ErrorCode::tooLarge));
  EXPECT_TRUE(says(read, "10000000000 pixels"));
}

TEST(HardSequences, OneValidPoseIsEnough) {
  Sequence sequence = sweep(5);
  for (const std::size_t i : {0u, 1u, 3u, 4u}) sequence.frames[i].transforms[0].status = PoseStatus::invalid;
  const auto poses = sweepPoses(sequence);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->usable, 1u);
  EXPECT_TRUE(poses->imageToWorld[2].has_value());
}

TEST(HardSequences, NoValidPoseIsSaidWithItsCounts) {
  Sequence sequence = sweep(4);
  for (auto& frame : sequence.frames) frame.transforms[0].status = PoseStatus::invalid;
  sequence.frames[3].transforms.clear();
  const auto poses = sweepPoses(sequence);
  EXPECT_TRUE(failedWith(poses, ErrorCode::noValidPose));
  EXPECT_TRUE(says(poses, "3 are INVALID and 1 missing"));
}

TEST(HardSequences, EqualTimesAndTimeRunningBackwardsAreNotedAndChangeNoPose) {
  Sequence sequence = sweep(5);
  sequence.frames[2].time_s = 1.0;
  sequence.frames[4].time_s = -3.0;
  const auto poses = sweepPoses(sequence);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->usable, 5u);
  EXPECT_TRUE(contains(poses->notes, "1 frame carries the same time"));
  EXPECT_TRUE(contains(poses->notes, "backwards at 1"));
}

TEST(HardSequences, ScaleInTheCalibrationIsKeptExactly) {
  Sequence sequence = sweep(2);
  glm::dmat4 matrix = sequence.frames[1].transforms[0].matrix;
  matrix[0] *= 1e-3;
  matrix[1] *= 50.0;
  sequence.frames[1].transforms[0].matrix = matrix;
  const auto poses = sweepPoses(sequence);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->imageToWorld[1]->matrix, matrix);
}

TEST(HardSequences, PosesThatAreNoPosesCountAsInvalid) {
  Sequence sequence = sweep(5);
  sequence.frames[0].transforms[0].matrix = glm::dmat4(0.0);
  sequence.frames[1].transforms[0].matrix[3][2] = std::numeric_limits<double>::quiet_NaN();
  sequence.frames[2].transforms[0].matrix[1] = sequence.frames[2].transforms[0].matrix[0];
  sequence.frames[3].transforms[0].matrix[0][3] = 0.25;
  const auto poses = sweepPoses(sequence);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->usable, 1u);
  EXPECT_EQ(poses->invalid, 4u);
}

TEST(HardSequences, OneColumnImagesSurviveTheRoundTrip) {
  const TempFolder folder;
  Sequence sequence = sweep(3);
  sequence.width = 1;
  sequence.height = 4;
  sequence.pixels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  ASSERT_TRUE(succeeded(writeSequence(sequence, folder / "s.igs.mha")));
  const auto read = readSequence(folder / "s.igs.mha");
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->width, 1);
  EXPECT_EQ(read->pixels, sequence.pixels);
}

// A reader that looks through all frames for each frame would need hours for these: it would be ended by ctest, on a fast machine too.
TEST(HardSequences, TwoHundredThousandFramesAreRead) {
  const TempFolder folder;
  const Sequence sequence = sweep(200000);
  ASSERT_TRUE(succeeded(writeSequence(sequence, folder / "s.igs.mha")));
  const auto read = readSequence(folder / "s.igs.mha");
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->frames.size(), sequence.frames.size());
  EXPECT_TRUE(read->frames.back() == sequence.frames.back());
  const auto poses = sweepPoses(*read);
  ASSERT_TRUE(succeeded(poses));
}

}  // namespace
}  // namespace ew::io_test
