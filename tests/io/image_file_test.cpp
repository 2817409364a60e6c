#include "ew/io/image_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <zlib.h>

#include "ew/io/image_stack.h"
#include "ew/io/volume_file.h"
#include "files.h"

namespace ew::image_file_test {
namespace {
using namespace test;

RC_GTEST_PROP(ImageFile, EveryImageComesBackPixelForPixel, ()) {
  const TempFolder folder;
  GreyImage image(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40));
  image.pixels = *rc::gen::container<std::vector<std::uint8_t>>(image.pixels.size(), rc::gen::arbitrary<std::uint8_t>());
  const auto file = folder / (*rc::gen::arbitrary<bool>() ? "p.png" : "p.mha");
  RC_ASSERT(writeImage(viewOf(image), 0.5, file).has_value());
  const auto again = readImage(file);
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == image);
}

TEST(ImageFile, AWindowIntoALargerImageIsWrittenAlone) {
  const TempFolder folder;
  GreyImage whole(5, 4);
  for (std::size_t i = 0; i < whole.pixels.size(); ++i) whole.pixels[i] = static_cast<std::uint8_t>(i);
  const ImageView<const std::uint8_t> window{whole.pixels.data() + 6, 3, 2, 5};
  for (const char* name : {"p.png", "p.mha"}) {
    ASSERT_TRUE(succeeded(writeImage(window, 1.0, folder / name)));
    const auto again = readImage(folder / name);
    ASSERT_TRUE(succeeded(again));
    EXPECT_EQ(again->pixels, (std::vector<std::uint8_t>{6, 7, 8, 11, 12, 13})) << name;
  }
}

TEST(ImageFile, AMetaImageIsFlatAndCarriesItsPixelSize) {
  const TempFolder folder;
  ASSERT_TRUE(succeeded(writeImage(viewOf(GreyImage(3, 2, 9)), 0.25, folder / "p.mha")));
  const std::string text = bytesOfFile(folder / "p.mha");
  EXPECT_NE(text.find("NDims = 2\n"), std::string::npos);
  EXPECT_NE(text.find("DimSize = 3 2\n"), std::string::npos);
  EXPECT_NE(text.find("ElementSpacing = 0.25 0.25\n"), std::string::npos);
  const auto volume = readVolume(folder / "p.mha");
  ASSERT_TRUE(succeeded(volume));
  EXPECT_EQ(volume->volume.grid.dims, glm::ivec3(3, 2, 1));
}

/// A grey PNG of one row, as libpng's low-level writer makes it; `chunks` stand before the samples.
std::string pngOf(const std::vector<std::uint16_t>& levels, int bits, const std::string& chunks = "") {
  const auto chunk = [](const std::string& type, const std::string& data) {
    const std::string body = type + data;
    const auto big = [](unsigned long value) { return bytesOf(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)}, true); };
    return big(data.size()) + body + big(crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
  };
  std::string head = bytesOf(std::vector<std::uint32_t>{static_cast<std::uint32_t>(levels.size()), 1}, true);
  head += std::string{static_cast<char>(bits), 0, 0, 0, 0};
  std::string row(1, '\0');
  for (const std::uint16_t level : levels) {
    if (bits == 16) row.push_back(static_cast<char>(level >> 8));
    row.push_back(static_cast<char>(level & 0xFF));
  }
  std::string extra;
  if (chunks == "gAMA") extra = chunk("gAMA", bytesOf(std::vector<std::uint32_t>{100000}, true));
  if (chunks == "sRGB") extra = chunk("sRGB", std::string(1, '\0'));
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + extra + chunk("IDAT", deflated(row)) + chunk("IEND", "");
}

TEST(ImageFile, StoredNumbersAreEchoLevelsWhateverAScreenWouldMakeOfThem) {
  const TempFolder folder;
  std::vector<std::uint16_t> eight, sixteen;
  std::vector<std::uint8_t> expected;
  for (int level = 0; level < 256; ++level) {
    eight.push_back(static_cast<std::uint16_t>(level));
    sixteen.push_back(static_cast<std::uint16_t>(level * 257));
    expected.push_back(static_cast<std::uint8_t>(level));
  }
  StackOptions options;
  options.spacing_mm = glm::dvec3(1.0);
  for (const char* chunk : {"", "gAMA", "sRGB"}) {
    for (const auto& [levels, bits] : {std::pair{eight, 8}, std::pair{sixteen, 16}}) {
      const auto file = folder.put("p.png", pngOf(levels, bits, chunk));
      const auto image = readImage(file);
      ASSERT_TRUE(succeeded(image)) << chunk << bits;
      EXPECT_EQ(image->pixels, expected) << chunk << " " << bits;
      const auto stack = readImageStack(file, options);
      ASSERT_TRUE(succeeded(stack)) << chunk << bits;
      EXPECT_EQ(stack->volume.echo, expected) << chunk << " " << bits;
    }
  }
}

TEST(ImageFile, WrongFilesAreRefusedInOneSentence) {
  const TempFolder folder;
  EXPECT_TRUE(failedWith(readImage(folder / "no.png"), ErrorCode::notFound));
  EXPECT_TRUE(failedWith(readImage(folder.put("a.png", "no image")), ErrorCode::badHeader));
  EXPECT_TRUE(failedWith(writeImage(viewOf(GreyImage(1, 1)), 1.0, folder / "p.bmp"), ErrorCode::unsupported));
  ASSERT_TRUE(succeeded(writeImage(viewOf(GreyImage(40, 40, 9)), 1.0, folder / "p.png")));
  const std::string whole = bytesOfFile(folder / "p.png");
  for (std::size_t bytes = 0; bytes < whole.size() - 12; ++bytes)
    EXPECT_TRUE(failedWith(readImage(folder.put("cut.png", whole.substr(0, bytes))), ErrorCode::badHeader)) << bytes;
  Volume volume;
  volume.grid.dims = {2, 2, 2};
  volume.echo.assign(8, 1);
  ASSERT_TRUE(succeeded(writeVolume(volume, folder / "v.mha")));
  EXPECT_TRUE(failedWith(readImage(folder / "v.mha"), ErrorCode::unsupported));
}

}  // namespace
}  // namespace ew::image_file_test
