#include "ew/scanning/display_image_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "ew/imaging/caption.h"
#include "ew/io/image_file.h"
#include "io/files.h"

namespace ew::display_image_file_test {
namespace {

class ImageFile : public ::testing::Test {
 protected:
  test::TempFolder folder;
  GreyImage grey = GreyImage(160, 120, 90);
  Image<Rgba> colour = Image<Rgba>(160, 120, Rgba(0));
};

}  // namespace

TEST_F(ImageFile, OfGreyLevelsCarriesTheWarningAndIsBareWhenItIsToBeMeasured) {
  ASSERT_TRUE(writeDisplayImage(DisplayImage{viewOf(std::as_const(grey))}, 0.5, folder / "a.png"));
  ASSERT_TRUE(writeDisplayImage(DisplayImage{viewOf(std::as_const(grey))}, 0.5, folder / "a.mha"));
  const auto seen = readImage(folder / "a.png"), bare = readImage(folder / "a.mha");
  ASSERT_TRUE(seen && bare);
  EXPECT_EQ(*bare, grey);
  GreyImage marked = grey;
  burnCaption(viewOf(marked), kNotForDiagnosis);
  EXPECT_EQ(*seen, marked);
  EXPECT_NE(*seen, grey);
}

TEST_F(ImageFile, OfColoursCarriesTheWarningOverTheColours) {
  for (Rgba& pixel : colour.pixels) pixel = {200, 0, 0, 255};
  const DisplayImage image{viewOf(std::as_const(grey)), viewOf(std::as_const(colour))};
  ASSERT_TRUE(writeDisplayImage(image, 0.5, folder / "c.png"));
  std::ifstream file(folder / "c.png", std::ios::binary);
  std::string head(26, '\0');
  file.read(head.data(), 26);
  EXPECT_EQ(head[25], 2) << "the colour type of a PNG: red, green, blue";
  RgbImage marked = composed(image);
  EXPECT_EQ(marked.pixels.front(), Rgb(200, 0, 0));
  burnCaption(viewOf(marked), kNotForDiagnosis);
  ASSERT_TRUE(writeImage(viewOf(std::as_const(marked)), 0.5, folder / "expected.png"));
  EXPECT_EQ(*readImage(folder / "c.png"), *readImage(folder / "expected.png"));
  ASSERT_TRUE(writeDisplayImage(image, 0.5, folder / "c.mha"));
  std::ifstream meta(folder / "c.mha", std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(meta)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find("ElementNumberOfChannels = 3"), std::string::npos);
  EXPECT_TRUE(text.ends_with(std::string("\xC8\0\0", 3)));
}

TEST_F(ImageFile, TooSmallForTheWordsIsRefusedUnlessItIsBare) {
  const GreyImage tiny(40, 30);
  const auto refused = writeDisplayImage(DisplayImage{viewOf(tiny)}, 0.5, folder / "t.png");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::badField);
  EXPECT_FALSE(std::filesystem::exists(folder / "t.png"));
  EXPECT_TRUE(writeDisplayImage(DisplayImage{viewOf(tiny)}, 0.5, folder / "t.mha"));
}

TEST_F(ImageFile, AFilmIsWrittenInBothForms) {
  for (const char* name : {"f.avi", "f.mp4"}) {
    auto clip = ImageClip::open(folder / name, 161, 121, 25.0);
    ASSERT_TRUE(clip) << clip.error();
    const GreyImage odd(161, 121, 77);
    for (int n = 0; n < 30; ++n) ASSERT_TRUE(clip->add(DisplayImage{viewOf(odd)}));
    ASSERT_TRUE(clip->finish());
    EXPECT_GT(std::filesystem::file_size(folder / name), 1000U);
  }
  std::ifstream avi(folder / "f.avi", std::ios::binary);
  std::string head(12, '\0');
  avi.read(head.data(), 12);
  EXPECT_EQ(head.substr(0, 4), "RIFF");
  EXPECT_EQ(head.substr(8), "AVI ");
}

TEST_F(ImageFile, AFilmThatCannotBeWrittenIsRefusedInASentence) {
  const auto form = ImageClip::open(folder / "f.wmv", 160, 120, 25.0);
  ASSERT_FALSE(form);
  EXPECT_EQ(form.error().code, ErrorCode::unsupported);
  const auto nowhere = ImageClip::open(folder / "no such folder" / "f.avi", 160, 120, 25.0);
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ErrorCode::notWritable);
  EXPECT_FALSE(ImageClip::open(folder / "f.avi", 20, 20, 25.0));
}

}  // namespace ew::display_image_file_test
