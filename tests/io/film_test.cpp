#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>

#include "dicom_files.h"
#include "ew/io/cine_reader.h"
#include "ew/io/clip_file.h"
#include "ew/io/image_stack.h"
#include "ew/io/live_video.h"
#include "ew/io/orientation.h"
#include "files.h"
#include "made_films.h"
#include "packed_images.h"

namespace ew::test::film_test {
namespace {
namespace fs = std::filesystem;

/// No turn and no mirror leaves this image as it is.
std::uint8_t uneven(int x, int y) { return static_cast<std::uint8_t>(20 + 3 * x + 5 * y); }

GreyImage unevenImage(int width, int height) {
  GreyImage image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) viewOf(image).at(x, y) = uneven(x, y);
  return image;
}

GreyImage turnedClockwise(const GreyImage& image) {
  GreyImage turned(image.height, image.width);
  for (int y = 0; y < turned.height; ++y)
    for (int x = 0; x < turned.width; ++x) viewOf(turned).at(x, y) = viewOf(image).at(y, image.height - 1 - x);
  return turned;
}
GreyImage mirrored(const GreyImage& image) {
  GreyImage other = image;
  for (int y = 0; y < image.height; ++y) std::reverse(viewOf(other).row(y), viewOf(other).row(y) + image.width);
  return other;
}
/// One step after the other: what turning and mirroring mean.
GreyImage upright(GreyImage image, const Orientation& orientation) {
  for (int n = 0; n < orientation.quarterTurns; ++n) image = turnedClockwise(image);
  return orientation.mirrored ? mirrored(image) : image;
}

constexpr std::array kAll{Orientation{0, false}, Orientation{0, true},  Orientation{2, false}, Orientation{2, true},
                          Orientation{1, true},  Orientation{1, false}, Orientation{3, true},  Orientation{3, false}};  // tags 1 to 8

GreyImage firstOf(Result<CineReader>& reader) {
  EXPECT_TRUE(reader) << reader.error();
  CineFrame frame;
  if (!reader) return {};
  const auto got = reader->next(frame);
  EXPECT_TRUE(got && *got);
  EXPECT_EQ(frame.level.width, reader->info().width_px);
  EXPECT_EQ(frame.level.height, reader->info().height_px);
  return frame.level;
}

std::string little(std::size_t value, int bytes) {
  std::string text;
  for (int n = 0; n < bytes; ++n) text += static_cast<char>(value >> (8 * n) & 0xFF);
  return text;
}

/// A grey TIFF of one page. @param more entries (12 bytes each) with tags above 279
std::string tiffOf(const GreyImage& image, int orientation) {
  std::string file = "II" + little(42, 2) + little(8, 4) + little(10, 2);
  const std::size_t data = 8 + 2 + 10 * 12 + 4, pixels = image.pixels.size();
  const auto entry = [&](int tag, int type, std::size_t value) {
    file += little(static_cast<std::size_t>(tag), 2) + little(static_cast<std::size_t>(type), 2) + little(1, 4) + little(value, 4);
  };
  entry(256, 3, static_cast<std::size_t>(image.width));
  entry(257, 3, static_cast<std::size_t>(image.height));
  entry(258, 3, 8);
  entry(259, 3, 1);
  entry(262, 3, 1);
  entry(273, 4, data);
  entry(274, 3, static_cast<std::size_t>(orientation));
  entry(277, 3, 1);
  entry(278, 3, static_cast<std::size_t>(image.height));
  entry(279, 4, pixels);
  return file + little(0, 4) + std::string(image.pixels.begin(), image.pixels.end());
}

/// A JPEG with Exif data of one entry between its start and the rest.
std::string withExif(const std::string& jpeg, int orientation, bool isBig) {
  std::string tiff = little(42, 2) + little(8, 4) + little(1, 2) + little(274, 2) + little(3, 2) + little(1, 4) +
                     little(static_cast<std::size_t>(orientation), 2) + little(0, 2) + little(0, 4);
  if (isBig) {  // every number the other way round
    std::size_t at = 0;
    for (const std::size_t size : {2, 4, 2, 2, 2, 4, 2, 2, 4}) {
      std::reverse(tiff.begin() + static_cast<std::ptrdiff_t>(at), tiff.begin() + static_cast<std::ptrdiff_t>(at + size));
      at += size;
    }
  }
  const std::string segment = std::string("Exif\0\0", 6) + (isBig ? "MM" : "II") + tiff;
  std::string length = little(segment.size() + 2, 2);
  std::reverse(length.begin(), length.end());
  return jpeg.substr(0, 2) + "\xFF\xE1" + length + segment + jpeg.substr(2);
}

TEST(Orientations, FollowOneAnotherAndAreReadFromTags) {
  const GreyImage image = unevenImage(7, 4);
  for (std::size_t tag = 1; tag <= 8; ++tag) {
    EXPECT_EQ(orientationOfTag(static_cast<int>(tag)), kAll[tag - 1]);
    std::vector<std::uint8_t> pixels;
    putUpright(image.pixels, 7, 4, kAll[tag - 1], pixels);
    EXPECT_EQ(pixels, upright(image, kAll[tag - 1]).pixels) << tag;
    for (const Orientation& second : kAll)
      EXPECT_EQ(upright(upright(image, kAll[tag - 1]), second), upright(image, then(kAll[tag - 1], second))) << tag;
  }
  EXPECT_FALSE(orientationOfTag(0));
  EXPECT_FALSE(orientationOfTag(9));
  EXPECT_FALSE(orientationOfMatrix(0.7, 0.7, -0.7, 0.7)) << "an eighth of a turn";
  EXPECT_FALSE(orientationOfMatrix(0.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(orientationOfMatrix(0.0, 2.0, -1.0, 0.0), (Orientation{1, false})) << "with a pixel that is not square";
}

TEST(Films, AreGivenUprightAsTheMatrixOfTheirTrackSays) {
  const TempFolder folder;
  // x' = a x + c y, y' = b x + d y; in the order of the tags of TIFF.
  constexpr std::array<std::array<int, 4>, 8> matrices{
      {{1, 0, 0, 1}, {-1, 0, 0, 1}, {-1, 0, 0, -1}, {1, 0, 0, -1}, {0, 1, 1, 0}, {0, 1, -1, 0}, {0, -1, -1, 0}, {0, -1, 1, 0}}};
  for (std::size_t n = 0; n < matrices.size(); ++n) {
    FilmOf film{.codec = AV_CODEC_ID_PNG, .container = "mov", .width = 40, .height = 16, .matrix = matrices[n]};
    film.level = [](int, int x, int y) { return uneven(x, y); };
    writeFilm(folder / "film.mov", film);
    auto reader = CineReader::open(folder / "film.mov");
    EXPECT_EQ(firstOf(reader), upright(unevenImage(40, 16), kAll[n])) << n;
    EXPECT_EQ(reader->info().orientation, kAll[n]) << n;
    EXPECT_EQ(reader->info().notes.size(), n == 0 ? 0u : 1u) << "what was done is said";
    ASSERT_TRUE(reader->rewind());
    EXPECT_EQ(firstOf(reader), upright(unevenImage(40, 16), kAll[n])) << "again " << n;
    auto asked = CineReader::open(folder / "film.mov", noProgress(), {}, {1, true});
    EXPECT_EQ(firstOf(asked), upright(unevenImage(40, 16), then(kAll[n], {1, true}))) << n;
  }
}

TEST(Films, PagesOfATiffAreUprightAsItsTagSays) {
  const TempFolder folder;
  for (int tag = 1; tag <= 8; ++tag) {
    auto reader = CineReader::open(folder.put("page.tif", tiffOf(unevenImage(24, 10), tag)));
    EXPECT_EQ(firstOf(reader), upright(unevenImage(24, 10), kAll[static_cast<std::size_t>(tag) - 1])) << tag;
  }
}

TEST(Films, APhotographIsUprightAsItsExifDataSay) {
  const TempFolder folder;
  const GreyImage stored = unevenImage(24, 16);
  const std::string jpeg = packedBy<gdcm::JPEGCodec>({stored.pixels.begin(), stored.pixels.end()}, 24, 16, 1, 8, false);
  const auto plain = readFirstOfStack(folder.put("plain.jpg", jpeg));
  ASSERT_TRUE(plain) << plain.error();
  for (int tag = 1; tag <= 8; ++tag)
    for (const bool isBig : {false, true}) {
      const GreyImage expected = upright(plain->level, kAll[static_cast<std::size_t>(tag) - 1]);
      const auto file = folder.put("photo.jpg", withExif(jpeg, tag, isBig));
      const auto image = readFirstOfStack(file);
      ASSERT_TRUE(image) << image.error();
      EXPECT_EQ(image->level, expected) << tag;
      auto reader = CineReader::open(file);
      EXPECT_EQ(firstOf(reader), expected) << tag;
    }
  // Whatever stands there, it is no fault of the image.
  const std::string exif = withExif(jpeg, 6, false);
  for (std::size_t cut = 2; cut < 38; ++cut) {
    const std::string bytes = exif.substr(0, cut);
    EXPECT_TRUE(orientationOfImage({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}).isUpright()) << cut;
  }
}

TEST(Films, PixelsThatAreNotSquareBecomeSquare) {
  const TempFolder folder;
  struct Shape {
    AVRational aspect;
    int width, height;
  };
  for (const auto& [aspect, width, height] :
       {Shape{{16, 15}, 96, 60}, Shape{{8, 9}, 90, 68}, Shape{{4, 3}, 120, 60}, Shape{{1, 1}, 90, 60}}) {
    FilmOf film{.width = 90, .height = 60, .aspect = aspect, .isFull = true};
    film.level = [](int, int x, int y) { return static_cast<std::uint8_t>(x >= 30 && x < 60 && y >= 20 && y < 40 ? 200 : 20); };
    writeFilm(folder / "film.mkv", film);
    auto reader = CineReader::open(folder / "film.mkv");
    const GreyImage image = firstOf(reader);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(reader->info().notes.empty(), aspect.num == aspect.den);
    // A third of the width and a third of the height, whatever they are.
    const auto bright = std::count_if(image.pixels.begin(), image.pixels.end(), [](std::uint8_t level) { return level > 110; });
    EXPECT_NEAR(static_cast<double>(bright), width * height / 9.0, width + height) << aspect.num;
    EXPECT_GT(viewOf(image).at(width / 2, height / 2), 195);
    EXPECT_LT(viewOf(image).at(width / 3 - 2, height / 2), 25);
  }
}

TEST(Films, LevelsAreThoseThatAreStored) {
  const TempFolder folder;
  for (const AVCodecID codec : {AV_CODEC_ID_FFV1, AV_CODEC_ID_VP9}) {
    if (!canWrite(codec)) continue;
    for (const bool isFull : {true, false}) {
      FilmOf film{.codec = codec, .width = 256, .height = 64, .isFull = isFull};
      film.level = [](int, int x, int) { return static_cast<std::uint8_t>(x / 16 * 16); };
      writeFilm(folder / "film.mkv", film);
      auto reader = CineReader::open(folder / "film.mkv");
      const GreyImage image = firstOf(reader);
      for (int x = 8; x < 256; x += 16) {
        const double stored = x / 16 * 16;
        const double expected = isFull ? stored : std::clamp((stored - 16.0) * 255.0 / 219.0, 0.0, 255.0);
        EXPECT_NEAR(viewOf(image).at(x, 32), expected, codec == AV_CODEC_ID_FFV1 ? 1.0 : 4.0) << codec << isFull;
      }
    }
  }
}

TEST(Films, AFilmOfVaryingRateIsWholeWhenItsLastTimeIsReached) {
  const TempFolder folder;
  FilmOf film;
  film.times_s.clear();
  for (int n = 0; n < 26; ++n) film.times_s.push_back(n < 20 ? 0.02 * n : 0.4 + 0.3 * (n - 20));  // dense, then sparse
  writeFilm(folder / "film.mkv", film);
  auto reader = CineReader::open(folder / "film.mkv");
  ASSERT_TRUE(reader) << reader.error();
  CineFrame frame;
  for (std::size_t n = 0; n < film.times_s.size(); ++n) {
    const auto got = reader->next(frame);
    ASSERT_TRUE(got && *got) << n;
    EXPECT_NEAR(frame.time_s, film.times_s[n], 0.0011);
  }
  EXPECT_FALSE(*reader->next(frame));
  EXPECT_FALSE(reader->brokenOff()) << reader->brokenOff()->sentence();

  const std::string bytes = bytesOfFile(folder / "film.mkv");
  film.times_s.clear();
  for (int n = 0; n < 100; ++n) film.times_s.push_back(0.04 * n);
  writeFilm(folder / "long.mkv", film);
  const std::string whole = bytesOfFile(folder / "long.mkv");
  auto half = CineReader::open(folder.put("half.mkv", whole.substr(0, whole.size() / 2)));
  ASSERT_TRUE(half) << half.error();
  std::size_t given = 0;
  while (true) {
    const auto got = half->next(frame);
    ASSERT_TRUE(got) << got.error();
    if (!*got) break;
    ++given;
  }
  EXPECT_GT(given, 30u);
  EXPECT_LT(given, 70u);
  ASSERT_TRUE(half->brokenOff());
  EXPECT_NE(half->brokenOff()->sentence().find(std::to_string(given) + " frames"), std::string::npos) << half->brokenOff()->sentence();
}

/// Images that come before the end of what is there of a film.
std::size_t countOf(CineReader& reader) {
  CineFrame frame;
  std::size_t count = 0;
  while (true) {
    const auto got = reader.next(frame);
    EXPECT_TRUE(got) << got.error();
    if (!got || !*got) return count;
    ++count;
  }
}

TEST(Films, ThatAreShortAndMissImagesSayHowManyWereRead) {
  const TempFolder folder;
  FilmOf film;
  film.times_s.clear();
  for (int n = 0; n < 8; ++n) film.times_s.push_back(0.04 * n);
  film.level = [](int n, int x, int y) { return static_cast<std::uint8_t>(16 + (x * 7 + y * 13 + x * y * (n + 3)) % 200); };
  writeFilm(folder / "whole.mkv", film);
  auto whole = CineReader::open(folder / "whole.mkv");
  ASSERT_TRUE(whole) << whole.error();
  EXPECT_EQ(countOf(*whole), 8u);
  EXPECT_FALSE(whole->brokenOff()) << whole->brokenOff()->sentence();
  const std::string bytes = bytesOfFile(folder / "whole.mkv");
  auto half = CineReader::open(folder.put("half.mkv", bytes.substr(0, bytes.size() / 2)));
  ASSERT_TRUE(half) << half.error();
  const std::size_t given = countOf(*half);
  EXPECT_GE(given, 2u);
  EXPECT_LE(given, 4u);
  ASSERT_TRUE(half->brokenOff()) << given;
  EXPECT_NE(half->brokenOff()->sentence().find(std::to_string(given) + " frames"), std::string::npos) << half->brokenOff()->sentence();
}

/// Of a MOV whose images are of different lengths: one sample loses its bytes to the next.
std::string withoutSample(std::string mov, std::size_t sample) {
  const std::size_t table = mov.find("stsz") + 16;  // behind type, version, size and count
  const auto lengthAt = [&](std::size_t n) {
    std::uint32_t length = 0;
    for (std::size_t at = table + 4 * n; at < table + 4 * n + 4; ++at) length = length << 8 | static_cast<std::uint8_t>(mov[at]);
    return length;
  };
  const auto setLength = [&](std::size_t n, std::uint32_t length) {
    for (std::size_t byte = 0; byte < 4; ++byte) mov[table + 4 * n + byte] = static_cast<char>(length >> (24 - 8 * byte) & 0xFF);
  };
  setLength(sample + 1, lengthAt(sample) + lengthAt(sample + 1));
  setLength(sample, 0);
  return mov;
}

TEST(Films, AFrameThatWasDroppedInRecordingIsNoDamage) {
  const TempFolder folder;
  FilmOf film{.codec = AV_CODEC_ID_PNG, .container = "mov"};
  film.times_s.clear();
  for (int n = 0; n < 10; ++n) film.times_s.push_back(0.04 * n);
  film.level = [](int n, int x, int y) { return static_cast<std::uint8_t>(x < 4 * n ? x * y : 20 * n); };
  writeFilm(folder / "film.mov", film);
  constexpr std::size_t dropped = 4;
  auto reader = CineReader::open(folder.put("gap.mov", withoutSample(bytesOfFile(folder / "film.mov"), dropped)));
  ASSERT_TRUE(reader) << reader.error();
  CineFrame frame;
  for (std::size_t n = 0; n < film.times_s.size(); ++n) {
    if (n == dropped) continue;
    const auto got = reader->next(frame);
    ASSERT_TRUE(got && *got) << n;
    EXPECT_NEAR(frame.time_s, film.times_s[n], 1e-6);
  }
  EXPECT_FALSE(*reader->next(frame));
  EXPECT_FALSE(reader->brokenOff()) << reader->brokenOff()->sentence();
}

TEST(Films, BeginAtZeroWhereTheFirstFrameHasNoTime) {
  // A bare MPEG-2 stream whose first image has no time.
  constexpr auto kStream = std::to_array<unsigned char>(
      {0x00, 0x00, 0x01, 0xb3, 0x01, 0x00, 0x10, 0x23, 0xff, 0xff, 0xe1, 0x18, 0x00, 0x00, 0x01, 0xb5, 0x14, 0x8a, 0x00, 0x01, 0x00,
       0x00, 0x00, 0x00, 0x01, 0xb8, 0x00, 0x08, 0x00, 0x40, 0x00, 0x00, 0x01, 0x00, 0x00, 0x0f, 0xff, 0xf8, 0x00, 0x00, 0x01, 0xb5,
       0x8f, 0xff, 0xf3, 0x41, 0x80, 0x00, 0x00, 0x01, 0x01, 0x13, 0xf8, 0xb0, 0x68, 0x6d, 0xa0, 0x34, 0x36, 0x81, 0xa1, 0xb6, 0x80,
       0xd0, 0xd8, 0x88, 0x00, 0x00, 0x01, 0x00, 0x00, 0x57, 0xff, 0xfb, 0x80, 0x00, 0x00, 0x01, 0xb5, 0x81, 0x1f, 0xf3, 0x41, 0x80,
       0x00, 0x00, 0x00, 0x01, 0x2a, 0x81, 0x1f, 0xf3, 0x41, 0x80, 0x00, 0x00, 0x01, 0x01, 0x12, 0xf4, 0x48, 0x91, 0x22});
  const TempFolder folder;
  auto reader = CineReader::open(folder.put("bare.mpg", std::string(kStream.begin(), kStream.end())));
  ASSERT_TRUE(reader) << reader.error();
  CineFrame frame;
  const auto got = reader->next(frame);
  ASSERT_TRUE(got && *got);
  EXPECT_EQ(frame.time_s, 0.0);
}

TEST(Films, SayWhetherTheirFramesAreCounted) {
  const TempFolder folder;
  writeFilm(folder / "film.mkv", {});
  writeFilm(folder / "film.mov", {.codec = AV_CODEC_ID_PNG, .container = "mov"});
  for (const auto& [name, guessed] : {std::pair("film.mkv", true), std::pair("film.mov", false)}) {
    const auto reader = CineReader::open(folder / name);
    ASSERT_TRUE(reader) << reader.error();
    EXPECT_EQ(reader->info().frames, 3u) << name;
    EXPECT_EQ(reader->info().framesGuessed, guessed) << name;
  }
}

TEST(Films, AnotherOneUnderTheSameNameIsNotReadOn) {
  const TempFolder folder;
  const fs::path file = folder / "film.mkv";
  writeFilm(file, {});
  const std::string bytes = bytesOfFile(file);
  auto reader = CineReader::open(file);
  const GreyImage image = firstOf(reader);
  FilmOf longer;
  longer.times_s.push_back(1.0);
  for (const FilmOf& other : {FilmOf{.width = 512, .height = 384}, FilmOf{.width = 32, .height = 24}, FilmOf{.aspect = {4, 3}}, longer}) {
    writeFilm(file, other);
    CineFrame frame;
    const auto again = reader->rewind();
    EXPECT_TRUE(failedWith(again, ErrorCode::notReadable) && says(again, "was changed while it was in use"));
    EXPECT_TRUE(failedWith(reader->next(frame), ErrorCode::notReadable));
  }
  fs::remove(file);
  CineFrame frame;
  EXPECT_FALSE(reader->rewind());
  EXPECT_TRUE(failedWith(reader->next(frame), ErrorCode::notReadable));
  static_cast<void>(folder.put("film.mkv", bytes));
  EXPECT_TRUE(succeeded(reader->rewind())) << "it is the one that was opened";
  EXPECT_EQ(firstOf(reader), image);
}

CineOf filmInDicom(const std::string& syntax, const std::string& film, int frames) {
  CineOf cine;
  cine.syntax = syntax;
  cine.columns = 64;
  cine.rows = 48;
  cine.frames = frames;
  cine.photometric = "YBR_PARTIAL_420";
  cine.samples = 3;
  cine.packed = {film};
  return cine;
}

constexpr const char* kMpeg2 = "1.2.840.10008.1.2.4.100";
constexpr const char* kH264 = "1.2.840.10008.1.2.4.102";
constexpr const char* kHevc = "1.2.840.10008.1.2.4.107";

TEST(FilmsInDicom, AreOpenedAsTheirTransferSyntaxSays) {
  const TempFolder folder;
  FilmOf film{.codec = AV_CODEC_ID_MPEG2VIDEO};
  film.times_s.clear();
  for (int n = 0; n < 8; ++n) film.times_s.push_back(0.04 * n);
  film.level = [](int n, int, int) { return static_cast<std::uint8_t>(40 + 20 * n); };
  for (const char* container : {"mpeg2video", "mpeg", "mpegts"}) {
    film.container = container;
    writeFilm(folder / "film", film);
    auto reader = CineReader::open(folder.put("film.dcm", cineFile(filmInDicom(kMpeg2, bytesOfFile(folder / "film"), 8))));
    ASSERT_TRUE(reader) << container << reader.error();
    CineFrame frame;
    for (int n = 0; n < 8; ++n) {
      const auto got = reader->next(frame);
      ASSERT_TRUE(got && *got) << container << n;
      EXPECT_NEAR(frame.level.pixels[1000], (24.0 + 20.0 * n) * 255.0 / 219.0, 4.0) << container << n;
      EXPECT_NEAR(frame.time_s, 0.04 * n, 1e-9);
    }
    EXPECT_FALSE(*reader->next(frame));
    EXPECT_FALSE(reader->brokenOff()) << container << reader->brokenOff()->sentence();
  }
}

TEST(FilmsInDicom, MoreFramesThanTheStreamCanHaveAreNotBelieved) {
  const TempFolder folder;
  writeFilm(folder / "film", {.codec = AV_CODEC_ID_MPEG2VIDEO, .container = "mpeg2video"});
  const std::string stream = bytesOfFile(folder / "film");
  for (const int stated : {static_cast<int>(stream.size()) + 2, (1 << 24) + 1, 999999999}) {
    auto reader = CineReader::open(folder.put("film.dcm", cineFile(filmInDicom(kMpeg2, stream, stated))));
    ASSERT_TRUE(reader) << reader.error();
    EXPECT_EQ(reader->info().frames, 0u) << stated;
    EXPECT_TRUE(contains(reader->info().notes, "more than its film can have"));
    CineFrame frame;
    for (int n = 0; n < 3; ++n) {
      const auto got = reader->next(frame);
      ASSERT_TRUE(got && *got) << n;
      EXPECT_NEAR(frame.time_s, 0.04 * n, 1e-9);
    }
    EXPECT_FALSE(*reader->next(frame));
    EXPECT_FALSE(reader->brokenOff()) << reader->brokenOff()->sentence();
  }
}

TEST(FilmsInDicom, PixelsAreAsTheStreamSaysWhereTheDataSetSaysNothing) {
  const TempFolder folder;
  FilmOf film{.codec = AV_CODEC_ID_MPEG2VIDEO, .container = "mpeg2video", .width = 96, .height = 48, .aspect = {2, 3}};
  writeFilm(folder / "film", film);
  CineOf cine = filmInDicom(kMpeg2, bytesOfFile(folder / "film"), 3);
  cine.columns = 96;
  cine.regions.clear();
  auto reader = CineReader::open(folder.put("film.dcm", cineFile(cine)));
  ASSERT_TRUE(reader) << reader.error();
  // MPEG-2 states the shape of the whole image, of which it knows 4:3, 16:9 and 2.21:1.
  EXPECT_EQ(reader->info().width_px, 96);
  EXPECT_EQ(reader->info().height_px, 72);
}

TEST(FilmsInDicom, AStreamOfAnotherKindThanAnnouncedIsRefused) {
  const TempFolder folder;
  {
    auto clip = ClipWriter::open(folder / "film.avi", 64, 48, 20.0);
    ASSERT_TRUE(clip) << clip.error();
    for (int n = 0; n < 4; ++n) ASSERT_TRUE(clip->add(RgbImage(64, 48, Rgb(90))));
    ASSERT_TRUE(clip->finish());
  }
  FilmOf mpeg{.codec = AV_CODEC_ID_MPEG2VIDEO, .container = "mpegts"};
  writeFilm(folder / "mpeg.ts", mpeg);
  writeFilm(folder / "film.mkv", {});
  const std::string avi = bytesOfFile(folder / "film.avi"), ts = bytesOfFile(folder / "mpeg.ts"), mkv = bytesOfFile(folder / "film.mkv");
  const std::string list = "#EXTM3U\n#EXTINF:1,\nfilm.avi\n", concat = "ffconcat version 1.0\nfile film.avi\n";
  ::testing::internal::CaptureStderr();
  for (const auto& [syntax, bytes, says] :
       {std::tuple(kMpeg2, avi, "MPEG-2"), std::tuple(kH264, avi, "H.264"), std::tuple(kHevc, mkv, "HEVC"),
        std::tuple(kMpeg2, mkv, "MPEG-2"), std::tuple(kH264, ts, "H.264"), std::tuple(kMpeg2, list, "MPEG-2"),
        std::tuple(kH264, concat, "H.264"), std::tuple(kMpeg2, std::string("noise"), "MPEG-2")}) {
    const auto reader = CineReader::open(folder.put("odd.dcm", cineFile(filmInDicom(syntax, bytes, 4))));
    ASSERT_FALSE(reader) << syntax;
    const std::string sentence = reader.error().sentence();
    EXPECT_NE(sentence.find(says), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("odd.dcm"), std::string::npos) << sentence;
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "what the libraries have to say stays with them";
}

TEST(Films, OfATrackerAreKnownByTheirContentToo) {
  const TempFolder folder;
  {
    auto clip = ClipWriter::open(folder / "film.avi", 64, 48, 20.0);
    ASSERT_TRUE(clip) << clip.error();
    ASSERT_TRUE(clip->add(RgbImage(64, 48, Rgb(90))));
    ASSERT_TRUE(clip->finish());
  }
  const auto opened = [](const fs::path& file) {
    const auto video = LiveVideo::open({.file = file.string(), .isFilm = true});
    return video && *video != nullptr;
  };
  EXPECT_TRUE(opened(folder / "film.avi"));
  EXPECT_FALSE(opened(folder.put("list.avi", "#EXTM3U\n#EXTINF:1,\nfilm.avi\n")));
  EXPECT_FALSE(opened(folder.put("list.mp4", "ffconcat version 1.0\nfile film.avi\n")));
  EXPECT_FALSE(opened(folder / "none.avi"));
}

TEST(Clips, PlayInBrowsersAndKeepOddSizes) {
  const TempFolder folder;
  for (const char* name : {"odd.mp4", "odd.avi"}) {
    RgbImage image(33, 25, Rgb(60));
    for (int y = 0; y < 25; ++y) viewOf(image).at(31, y) = viewOf(image).at(32, y) = Rgb(230);
    auto clip = ClipWriter::open(folder / name, 33, 25, 20.0);
    ASSERT_TRUE(clip) << clip.error();
    for (int n = 0; n < 4; ++n) ASSERT_TRUE(clip->add(image));
    ASSERT_TRUE(clip->finish());
    auto reader = CineReader::open(folder / name);
    const GreyImage read = firstOf(reader);
    EXPECT_EQ(read.width, 34) << name;
    EXPECT_EQ(read.height, 26) << name;
    EXPECT_GT(viewOf(read).at(33, 25), 190) << name << ": the last column and row are repeated";
    EXPECT_LT(viewOf(read).at(20, 25), 80) << name;
  }
  if (canWrite(AV_CODEC_ID_H264)) {
    EXPECT_NE(bytesOfFile(folder / "odd.mp4").find("avc1"), std::string::npos) << "H.264, which browsers play";
  }
}

/// No file grows beyond this while it lives, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(std::uintmax_t most_bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &usual_);
    rlimit tight = usual_;
    tight.rlim_cur = most_bytes;
    ::setrlimit(RLIMIT_FSIZE, &tight);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &usual_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit usual_{};
  void (*handler_)(int);
};

/// Ten images of noise.
Result<void> writeNoise(const fs::path& file) {
  auto clip = ClipWriter::open(file, 64, 48, 20.0);
  if (!clip) return passOn(clip.error());
  std::uint32_t random = 1;
  for (int n = 0; n < 10; ++n) {
    RgbImage image(64, 48);
    for (Rgb& pixel : image.pixels) pixel = Rgb(static_cast<std::uint8_t>((random = random * 1664525u + 1013904223u) >> 24));
    if (auto added = clip->add(image); !added) return added;
  }
  return clip->finish();
}

TEST(Clips, ThatDoNotFitOnTheDiskAreNotReportedAsWritten) {
  const TempFolder folder;
  for (const char* name : {"film.mp4", "film.avi"}) {
    ASSERT_TRUE(succeeded(writeNoise(folder / name)));
    const std::uintmax_t whole_bytes = fs::file_size(folder / name);
    for (const std::uintmax_t room_bytes : {whole_bytes - 1, whole_bytes - 60, whole_bytes / 2, whole_bytes / 10, std::uintmax_t{100}}) {
      Result<void> written;
      {
        const FullDisk disk(room_bytes);
        written = writeNoise(folder / name);
      }
      EXPECT_TRUE(failedWith(written, ErrorCode::notWritable) && says(written, name)) << room_bytes << " of " << whole_bytes;
      if (written) continue;
      EXPECT_EQ(written.error().sentence().find(": ;"), std::string::npos) << "a reason is given: " << written.error();
    }
    EXPECT_TRUE(succeeded(writeNoise(folder / name))) << "with room again";
  }
}

}  // namespace
}  // namespace ew::test::film_test
