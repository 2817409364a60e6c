#include <gtest/gtest.h>

#include <cmath>

#include "ew/io/image_file.h"
#include "ew/io/image_stack.h"
#include "ew/io/raw_volume.h"
#include "files.h"

namespace ew::raw_and_stack_test {
namespace {
using namespace test;

TEST(RawVolume, SamplesAreReadAsTheLayoutSays) {
  const TempFolder folder;
  const auto file = folder.put("a.raw", "HEAD" + ramp(24) + "tail");
  const auto layout = parseRawLayout("4x3x2:u8:0.5,0.25,1:4");
  ASSERT_TRUE(succeeded(layout));
  const auto read = readRawVolume(file, *layout);
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->volume.grid.dims, glm::ivec3(4, 3, 2));
  EXPECT_EQ(read->volume.grid.spacing_mm, glm::dvec3(0.5, 0.25, 1.0));
  EXPECT_EQ(read->volume.echo[read->volume.grid.indexOf(3, 2, 1)], 23);
  EXPECT_TRUE(contains(read->notes, "4x3x2:u8:0.5,0.25,1:4"));
  EXPECT_TRUE(contains(read->notes, "bytes after its samples"));
}

TEST(RawVolume, SamplesThatStillSwingSayAtOnceWhatTheyAre) {
  const TempFolder folder;
  const auto warned = [&](const std::vector<std::int16_t>& samples) {
    const auto read = readRawVolume(folder.put("a.raw", bytesOf(samples)), *parseRawLayout(std::to_string(samples.size()) + "x1x1:i16:1"));
    EXPECT_TRUE(succeeded(read));
    return read && contains(read->warnings, "(RF)") && contains(read->notes, "(RF)");
  };
  std::vector<std::int16_t> iq, brightness;
  for (int n = 0; n < 400; ++n) {
    iq.push_back(static_cast<std::int16_t>(900.0 * std::sin(1.3 * n)));
    brightness.push_back(static_cast<std::int16_t>(n % 50 - 5));
  }
  iq[50] = -5065;  // uneven ends, as one strong echo makes them
  iq[150] = 7969;
  EXPECT_TRUE(warned(iq));
  EXPECT_FALSE(warned(brightness)) << "a little below 0 is an offset";
  EXPECT_FALSE(warned(std::vector<std::int16_t>(400, 7)));
}

TEST(ImageStack, WhatAnImageStatesAndNobodyUsesIsTold) {
  const TempFolder folder;
  const GreyImage image(4, 3);
  ASSERT_TRUE(succeeded(writeImage(viewOf(image), 0.1, folder / "p1.png")));
  // Behind the signature and IHDR: 10000 pixels a metre.
  const std::string body("pHYs\0\0\x27\x10\0\0\x27\x10\x01", 13);
  const auto check = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()), 13));
  std::string png = bytesOfFile(folder / "p1.png");
  png.insert(33, std::string("\0\0\0\x09", 4) + body + bytesOf(std::vector<std::uint32_t>{check}, true));
  static_cast<void>(folder.put("p1.png", png));
  const auto read = readImageStack(folder / "p1.png", {.spacing_mm = glm::dvec3(0.5), .colour = ColourRule::keepGrey, .blank = {}});
  ASSERT_TRUE(succeeded(read));
  EXPECT_TRUE(contains(read->notes, "pHYs \"10000 x 10000 a metre\", which touches sizes"));
}

TEST(RawVolume, EveryTypeAndByteOrderGivesTheSameLevels) {
  const TempFolder folder;
  const auto levels = [&](const std::string& bytes, const std::string& type) {
    const auto read = readRawVolume(folder.put("a.raw", bytes), *parseRawLayout("2x2x1:" + type + ":1"));
    EXPECT_TRUE(succeeded(read)) << type;
    return read ? read->volume.echo : std::vector<std::uint8_t>();
  };
  const std::vector<std::uint8_t> expected{0, 255, 128, 64};
  for (const bool big : {false, true}) {
    const std::string order = big ? "be" : "le";
    EXPECT_EQ(levels(bytesOf(std::vector<std::int16_t>{-200, 200, 1, -100}, big), "i16" + order), expected);
    EXPECT_EQ(levels(bytesOf(std::vector<std::uint16_t>{100, 500, 301, 200}, big), "u16" + order), expected);
    EXPECT_EQ(levels(bytesOf(std::vector<float>{-1.F, 1.F, 0.005F, -0.5F}, big), "f32" + order), expected);
    EXPECT_EQ(levels(bytesOf(std::vector<double>{-1., 1., 0.005, -0.5}, big), "f64" + order), expected);
    EXPECT_EQ(levels(bytesOf(std::vector<std::int32_t>{-200000, 200000, 1000, -100000}, big), "i32" + order), expected);
  }
}

TEST(RawVolume, NothingIsGuessedWhenTheLayoutDoesNotFit) {
  const TempFolder folder;
  const auto file = folder.put("a.raw", ramp(24));
  EXPECT_TRUE(failedWith(readRawVolume(file, *parseRawLayout("4x3x3:u8:1")), ErrorCode::truncated));
  RawLayout unspaced;
  unspaced.dims = {4, 3, 2};
  EXPECT_TRUE(failedWith(readRawVolume(file, unspaced), ErrorCode::missingCalibration));
  for (const char* bad : {"", "4x3:u8:1", "4x3x2:u8", "4x3x2:u9:1", "0x3x2:u8:1", "4x3x2:u8:0", "4x3x2:u8:1,2", "4x3x2:u8:1:-3",
                          "4x3x2:u8:nan", "4x3x2:u8:1:2:3", "99999999999x1x1:u8:1"})
    EXPECT_TRUE(failedWith(parseRawLayout(bad), ErrorCode::badUsage)) << bad;
}

TEST(RawVolume, GuessesFitTheFileAndTheTrueLayoutIsAmongThem) {
  for (const auto& [dims, type, offset] : {std::tuple{glm::ivec3(256, 256, 180), RawType::u8, 0u},
                                           {glm::ivec3(200, 300, 160), RawType::u8, 512u},
                                           {glm::ivec3(128, 128, 100), RawType::u16, 0u}}) {
    const std::uint64_t bytes =
        static_cast<std::uint64_t>(dims.x) * static_cast<std::uint64_t>(dims.y) * static_cast<std::uint64_t>(dims.z) * bytesOf(type) +
        offset;
    bool found = false;
    for (const RawLayout& guess : guessRawLayouts(bytes, 200)) {
      const std::uint64_t fits = static_cast<std::uint64_t>(guess.dims.x) * static_cast<std::uint64_t>(guess.dims.y) *
                                     static_cast<std::uint64_t>(guess.dims.z) * bytesOf(guess.type) +
                                 guess.offset;
      ASSERT_EQ(fits, bytes);
      EXPECT_EQ(guess.spacing_mm, glm::dvec3(0.0)) << "a size is never guessed";
      found = found || (guess.dims == dims && guess.type == type && guess.offset == offset);
    }
    EXPECT_TRUE(found) << dims.x;
  }
  EXPECT_LE(guessRawLayouts(256 * 256 * 256).size(), 12u);
  EXPECT_EQ(guessRawLayouts(256 * 256 * 256).front().dims, glm::ivec3(256));
}

TEST(RawVolume, ThePreviewShowsTheThreeMiddleSlicesOfTheVolume) {
  const TempFolder folder;
  const auto file = folder.put("a.raw", "x" + ramp(60));
  const RawLayout layout = *parseRawLayout("5x4x3:u8:1:1");
  const auto preview = previewRawVolume(file, layout);
  const auto read = readRawVolume(file, layout);
  ASSERT_TRUE(preview && read);
  const Grid& grid = read->volume.grid;
  EXPECT_EQ(preview->xy[2 * 5 + 3], read->volume.echo[grid.indexOf(3, 2, 1)]);
  EXPECT_EQ(preview->xz[2 * 5 + 3], read->volume.echo[grid.indexOf(3, 2, 2)]);
  EXPECT_EQ(preview->yz[2 * 4 + 3], read->volume.echo[grid.indexOf(2, 3, 2)]);
  EXPECT_TRUE(failedWith(previewRawVolume(file, *parseRawLayout("5x4x4:u8:1")), ErrorCode::truncated));
  struct Impatient final : Progress {
    void report(const Message&, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return true; }
  } impatient;
  EXPECT_TRUE(failedWith(previewRawVolume(file, layout, impatient), ErrorCode::cancelled));
}

TEST(ImageStack, NumbersDecideTheOrderAndTheSpacingIsAskedFor) {
  const TempFolder folder;
  for (const int n : {10, 2, 1}) {
    GreyImage image(3, 2, static_cast<std::uint8_t>(n));
    image.pixels[5] = 99;
    ASSERT_TRUE(succeeded(writeImage(viewOf(image), 1.0, folder / ("slice" + std::to_string(n) + ".png"))));
  }
  static_cast<void>(folder.put("slice3.pgm", std::string("P5\n3 2\n255\n") + std::string(6, '\3')));
  static_cast<void>(folder.put("note.txt", "not an image"));
  const auto asked = readImageStack(folder.path(), {});
  EXPECT_TRUE(failedWith(asked, ErrorCode::missingCalibration));
  StackOptions options;
  options.spacing_mm = glm::dvec3(0.1, 0.2, 0.7);
  const auto all = readImageStack(folder.path(), options);
  ASSERT_TRUE(succeeded(all));
  EXPECT_EQ(all->volume.grid.dims, glm::ivec3(3, 2, 4));
  EXPECT_EQ(all->volume.grid.spacing_mm, glm::dvec3(0.1, 0.2, 0.7));
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(all->volume.echo[all->volume.grid.indexOf(0, 0, k)], (std::array{1, 2, 3, 10}[static_cast<std::size_t>(k)]));
  EXPECT_EQ(all->volume.echo[5], 99);
  const auto beside = readImageStack(folder / "slice2.png", options);
  ASSERT_TRUE(succeeded(beside));
  EXPECT_EQ(beside->volume.grid.dims.z, 3) << "the .pgm has another ending";
  options.blank = {{2, 1, 1, 1}};
  EXPECT_EQ(readImageStack(folder.path(), options)->volume.echo[5], 0);
}

TEST(ImageStack, ImagesThatDoNotBelongTogetherAreRefused) {
  const TempFolder folder;
  StackOptions options;
  options.spacing_mm = glm::dvec3(1.0);
  EXPECT_TRUE(failedWith(readImageStack(folder.path(), options), ErrorCode::unsupported));
  static_cast<void>(folder.put("a1.pgm", std::string("P5\n3 2\n255\n") + ramp(6)));
  static_cast<void>(folder.put("a2.pgm", std::string("P5\n2 3\n255\n") + ramp(6)));
  EXPECT_TRUE(failedWith(readImageStack(folder.path(), options), ErrorCode::badField));
  static_cast<void>(folder.put("a2.pgm", std::string("P5\n3 2\n255\n") + ramp(5)));
  EXPECT_TRUE(failedWith(readImageStack(folder.path(), options), ErrorCode::badHeader));
  static_cast<void>(folder.put("a2.jpg", "no jpeg at all"));
  EXPECT_FALSE(readImageStack(folder.path(), options).has_value());
  EXPECT_TRUE(failedWith(readImageStack(folder / "nowhere", options), ErrorCode::notFound));
}

TEST(PixelRects, AreReadFromFourNumbersAndBlackenOnlyWhatTheyCover) {
  EXPECT_EQ(*parsePixelRect("1,2,3,4"), (PixelRect{1, 2, 3, 4}));
  for (const char* bad : {"", "1,2,3", "1,2,0,4", "-1,2,3,4", "a,b,c,d"})
    EXPECT_TRUE(failedWith(parsePixelRect(bad), ErrorCode::badUsage)) << bad;
  std::vector<std::uint8_t> pixels(2 * 12, 7);
  const std::vector<PixelRect> rects{{1, 1, 2, 9}, {2, 1, 9, 1}};
  EXPECT_EQ(blank(pixels, 4, 3, rects), 5u);
  EXPECT_EQ(pixels, (std::vector<std::uint8_t>{7, 7, 7, 7, 7, 0, 0, 0, 7, 0, 0, 7, 7, 7, 7, 7, 7, 0, 0, 0, 7, 0, 0, 7}));
}

}  // namespace
}  // namespace ew::raw_and_stack_test
