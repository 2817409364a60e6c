#include "ew/io/image_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ew/io/volume_file.h"
#include "files.h"

namespace ew {
namespace {
using namespace test;

RC_GTEST_PROP(ImageFile, EveryPictureComesBackPixelForPixel, ()) {
  const TempFolder folder;
  GreyImage picture(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40));
  picture.pixels = *rc::gen::container<std::vector<std::uint8_t>>(picture.pixels.size(), rc::gen::arbitrary<std::uint8_t>());
  const auto file = folder / (*rc::gen::arbitrary<bool>() ? "p.png" : "p.mha");
  RC_ASSERT(writeImage(viewOf(picture), 0.5, file).has_value());
  const auto again = readImage(file);
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == picture);
}

TEST(ImageFile, AWindowIntoALargerPictureIsWrittenAlone) {
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

TEST(ImageFile, WrongFilesAreRefusedInOneSentence) {
  const TempFolder folder;
  EXPECT_TRUE(failedWith(readImage(folder / "no.png"), ErrorCode::notFound));
  EXPECT_TRUE(failedWith(readImage(folder.put("a.png", "no picture")), ErrorCode::badHeader));
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
}  // namespace ew
