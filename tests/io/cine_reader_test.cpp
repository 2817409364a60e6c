#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>

#include "counted_stop.h"
#include "dicom_files.h"
#include "ew/io/cine_reader.h"
#include "ew/io/clip_file.h"
#include "ew/io/image_file.h"
#include "ew/io/sequence.h"
#include "files.h"
#include "memory_in_use.h"

namespace ew::test::cine_reader_test {
namespace {
namespace fs = std::filesystem;

/// An image with a bright bar that tells its number: its left edge lies at 8 n. @param hue tints the lower half
RgbImage barAt(int n, int width, int height, bool hue = false) {
  RgbImage image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool in = x >= 8 * n && x < 8 * n + 16;
      viewOf(image).at(x, y) = !in ? Rgb(20) : hue && y > height / 2 ? Rgb(250, 40, 30) : Rgb(220);
    }
  return image;
}

void writeFilm(const fs::path& file, int frames, double rate_hz = 20.0, bool hue = false) {
  auto clip = ClipWriter::open(file, 320, 160, rate_hz);
  ASSERT_TRUE(clip) << clip.error();
  for (int n = 0; n < frames; ++n) ASSERT_TRUE(clip->add(barAt(n % 30, 320, 160, hue)));
  ASSERT_TRUE(clip->finish());
}

/// The number that an image's bar tells.
int numberOf(const CineFrame& frame) {
  const auto view = viewOf(frame.level);
  int first = 0;
  while (first < frame.level.width && view.at(first, 20) < 120) ++first;
  return (first + 4) / 8;
}

std::string little16(int value) { return {static_cast<char>(value & 0xFF), static_cast<char>(value >> 8 & 0xFF)}; }
std::string little32(std::size_t value) { return little16(static_cast<int>(value & 0xFFFF)) + little16(static_cast<int>(value >> 16)); }

/// An uncompressed grey TIFF of several pages, all pixels of page n being 10 + 20 n.
std::string tiffOf(int pages, int width, int height) {
  std::string file = "II" + little16(42) + little32(8);
  const std::size_t directory = 2 + 9 * 12 + 4, pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (int n = 0; n < pages; ++n) {
    const std::size_t at = file.size(), data = at + directory;
    file += little16(9);
    const auto entry = [&](int tag, int type, std::size_t value) {
      file +=
          little16(tag) + little16(type) + little32(1) + (type == 3 ? little16(static_cast<int>(value)) + little16(0) : little32(value));
    };
    entry(256, 3, static_cast<std::size_t>(width));
    entry(257, 3, static_cast<std::size_t>(height));
    entry(258, 3, 8);
    entry(259, 3, 1);
    entry(262, 3, 1);
    entry(273, 4, data);
    entry(277, 3, 1);
    entry(278, 3, static_cast<std::size_t>(height));
    entry(279, 4, pixels);
    file += little32(n + 1 < pages ? data + pixels : 0);
    file += std::string(pixels, static_cast<char>(10 + 20 * n));
  }
  return file;
}

TEST(CineReader, FilmsGiveTheirFramesInOrderWithTimes) {
  const TempFolder folder;
  for (const char* name : {"bar.avi", "bar.mp4"}) {
    writeFilm(folder / name, 25);
    EXPECT_TRUE(isFilm(folder / name));
    auto reader = CineReader::open(folder / name);
    ASSERT_TRUE(reader) << reader.error();
    EXPECT_EQ(reader->info().kind, CineKind::film);
    EXPECT_EQ(reader->info().width_px, 320);
    EXPECT_EQ(reader->info().height_px, 160);
    EXPECT_NEAR(reader->info().rate_hz, 20.0, 0.1) << name;
    for (int round = 0; round < 2; ++round) {
      CineFrame frame;
      for (int n = 0; n < 25; ++n) {
        const auto got = reader->next(frame);
        ASSERT_TRUE(got) << got.error();
        ASSERT_TRUE(*got) << name << n;
        EXPECT_EQ(numberOf(frame), n) << name;
        EXPECT_NEAR(frame.time_s, 0.05 * n, 0.002) << name;
        EXPECT_TRUE(frame.coloured.empty()) << "grey stays grey";
      }
      EXPECT_FALSE(*reader->next(frame)) << name;
      EXPECT_FALSE(reader->brokenOff()) << reader->brokenOff()->sentence();
      ASSERT_TRUE(reader->rewind());
    }
  }
}

TEST(CineReader, ColourIsKeptWhereItIs) {
  const TempFolder folder;
  writeFilm(folder / "hue.avi", 3, 20.0, true);
  auto reader = CineReader::open(folder / "hue.avi");
  ASSERT_TRUE(reader);
  CineFrame frame;
  ASSERT_TRUE(*reader->next(frame));
  ASSERT_FALSE(frame.coloured.empty());
  const std::size_t upper = 40 * 320 + 8, lower = 120 * 320 + 8, dark = 120 * 320 + 200;
  EXPECT_EQ(frame.coloured[upper], 0);
  EXPECT_EQ(frame.coloured[lower], 1);
  EXPECT_EQ(frame.coloured[dark], 0);
  EXPECT_NEAR(frame.colour.pixels[lower].r, 250, 12);
  EXPECT_NEAR(frame.colour.pixels[lower].b, 30, 20);
}

TEST(CineReader, ATruncatedFilmGivesWhatComesBeforeAndSaysSo) {
  const TempFolder folder;
  writeFilm(folder / "whole.avi", 30);
  const std::string bytes = bytesOfFile(folder / "whole.avi");
  const auto half = folder.put("half.avi", bytes.substr(0, bytes.size() / 2));
  auto reader = CineReader::open(half);
  ASSERT_TRUE(reader) << reader.error();
  CineFrame frame;
  int count = 0;
  while (true) {
    const auto got = reader->next(frame);
    ASSERT_TRUE(got) << got.error();
    if (!*got) break;
    EXPECT_EQ(numberOf(frame), count);
    ++count;
  }
  EXPECT_GT(count, 8);
  EXPECT_LT(count, 30);
  if (reader->info().frames > static_cast<std::uint64_t>(count) + 2) {
    ASSERT_TRUE(reader->brokenOff());
    EXPECT_NE(reader->brokenOff()->sentence().find(std::to_string(count)), std::string::npos) << reader->brokenOff()->sentence();
  }
}

TEST(CineReader, BrokenFilesAreOneSentence) {
  const TempFolder folder;
  writeFilm(folder / "whole.mp4", 10);
  const std::string bytes = bytesOfFile(folder / "whole.mp4");
  std::string noise = bytes;
  for (std::size_t n = 40; n < noise.size(); ++n) noise[n] = static_cast<char>(n * 2654435761u >> 13);
  for (const auto& [name, content] : {std::pair("noise.mp4", noise), std::pair("short.mp4", bytes.substr(0, bytes.size() / 3)),
                                      std::pair("text.mp4", std::string("#EXTM3U\nother.mp4\n")), std::pair("empty.avi", std::string()),
                                      std::pair("short.tif", tiffOf(1, 16, 8).substr(0, 40))}) {
    const auto file = folder.put(name, content);
    auto reader = CineReader::open(file);
    if (reader) {  // a header that survived: then it gives no frame, or fewer, and never a false one
      CineFrame frame;
      while (true) {
        const auto got = reader->next(frame);
        if (!got || !*got) break;
      }
      continue;
    }
    const std::string sentence = reader.error().sentence();
    EXPECT_NE(sentence.find(name), std::string::npos) << sentence;
    EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 0);
    EXPECT_TRUE(sentence.ends_with('.')) << sentence;
  }
  EXPECT_EQ(CineReader::open(folder / "none.mp4").error().code, ErrorCode::notFound);
}

TEST(CineReader, AFolderOfDicomStillsSaysWhatReadsIt) {
  const TempFolder folder;
  EXPECT_NE(CineReader::open(folder.path()).error().sentence().find("holds no images"), std::string::npos);
  CineOf still;
  still.frames = 1;
  still.pixels = ramp(48);
  static_cast<void>(folder.put("I0001", cineFile(still)));
  const auto refused = CineReader::open(folder.path());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_NE(refused.error().sentence().find("is a folder of DICOM stills"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().sentence().find("echoweave import"), std::string::npos) << refused.error();
}

TEST(CineReader, PagesOfATiffAreFrames) {
  const TempFolder folder;
  const std::string bytes = tiffOf(5, 16, 8);
  auto reader = CineReader::open(folder.put("stack.tif", bytes));
  ASSERT_TRUE(reader) << reader.error();
  EXPECT_EQ(reader->info().kind, CineKind::pages);
  EXPECT_EQ(reader->info().frames, 5u);
  EXPECT_FALSE(reader->info().timesKnown);
  CineFrame frame;
  for (int n = 0; n < 5; ++n) {
    ASSERT_TRUE(*reader->next(frame)) << n;
    EXPECT_EQ(frame.level.pixels, std::vector<std::uint8_t>(128, static_cast<std::uint8_t>(10 + 20 * n)));
  }
  EXPECT_FALSE(*reader->next(frame));
  EXPECT_FALSE(reader->brokenOff());

  auto broken = CineReader::open(folder.put("cut.tif", bytes.substr(0, bytes.size() - 60)));
  ASSERT_TRUE(broken) << broken.error();
  int count = 0;
  while (*broken->next(frame)) ++count;
  EXPECT_EQ(count, 4);
  ASSERT_TRUE(broken->brokenOff());
  EXPECT_EQ(broken->brokenOff()->code, ErrorCode::truncated);
}

TEST(CineReader, AFilmInsideDicomHasItsTimesAndNoFieldOfAPatient) {
  const TempFolder folder;
  writeFilm(folder / "film.mp4", 12);
  const std::string film = bytesOfFile(folder / "film.mp4");
  CineOf cine;
  cine.syntax = "1.2.840.10008.1.2.4.102";
  cine.columns = 320;
  cine.rows = 160;
  cine.frames = 12;
  cine.photometric = "YBR_PARTIAL_420";
  cine.samples = 3;
  cine.packed = {film.substr(0, film.size() / 2 / 2 * 2), film.substr(film.size() / 2 / 2 * 2)};
  cine.frameTime = "31.5";
  auto reader = CineReader::open(folder.put("cine.dcm", cineFile(cine)));
  ASSERT_TRUE(reader) << reader.error();
  EXPECT_EQ(reader->info().kind, CineKind::dicomFilm);
  EXPECT_TRUE(reader->info().timesKnown);
  CineFrame frame;
  for (int n = 0; n < 12; ++n) {
    const auto got = reader->next(frame);
    ASSERT_TRUE(got && *got) << n;
    EXPECT_EQ(numberOf(frame), n);
    EXPECT_NEAR(frame.time_s, 0.0315 * n, 1e-9);
  }
  EXPECT_FALSE(*reader->next(frame));
}

TEST(CineReader, DicomCinesAndSequencesComeThroughTheSameReader) {
  const TempFolder folder;
  CineOf cine;
  cine.regions.front().deltaY = cine.regions.front().deltaX;  // square pixels, which stay as they are
  for (int n = 0; n < 3 * 8 * 6; ++n) cine.pixels += static_cast<char>(n);
  auto dicom = CineReader::open(folder.put("cine.dcm", cineFile(cine)));
  ASSERT_TRUE(dicom) << dicom.error();
  Sequence sequence;
  sequence.width = 8;
  sequence.height = 6;
  CineFrame frame;
  for (int n = 0; n < 3; ++n) {
    ASSERT_TRUE(*dicom->next(frame));
    EXPECT_EQ(frame.level.pixels.front(), 48 * n);
    EXPECT_NEAR(frame.time_s, 0.04 * n, 1e-9);
    SequenceFrame said;
    said.time_s = frame.time_s;
    sequence.frames.push_back(said);
    sequence.pixels.insert(sequence.pixels.end(), frame.level.pixels.begin(), frame.level.pixels.end());
  }
  EXPECT_FALSE(*dicom->next(frame));
  ASSERT_TRUE(writeSequence(sequence, folder / "cine.igs.mha"));
  auto again = CineReader::open(folder / "cine.igs.mha");
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->info().kind, CineKind::sequence);
  for (int n = 0; n < 3; ++n) {
    ASSERT_TRUE(*again->next(frame));
    EXPECT_EQ(frame.level.pixels.back(), static_cast<std::uint8_t>(48 * n + 47));
    EXPECT_NEAR(frame.time_s, 0.04 * n, 1e-9);
  }
}

/// A cine of 3 frames, and what its file says of the time between them.
CineOf timedBy(const std::string& frameTime) {
  CineOf cine;
  cine.regions.front().deltaY = cine.regions.front().deltaX;
  cine.pixels = std::string(3 * 8 * 6, '\x40');
  cine.frameTime = frameTime;
  return cine;
}

TEST(CineReader, ARateThatNobodyStatedIsSaidToBeAssumed) {
  const TempFolder folder;
  for (int n = 0; n < 3; ++n) ASSERT_TRUE(writeImage(viewOf(GreyImage(6, 4, 90)), 1.0, folder / ("p" + std::to_string(n) + ".png")));
  const auto pages = folder.put("stack.tif", tiffOf(3, 16, 8));
  std::string bytes = cineFile(timedBy("40"));
  const std::string frameTime("\x18\0\x63\x10", 4);
  ASSERT_NE(bytes.find(frameTime), std::string::npos);
  ++bytes[bytes.find(frameTime) + 2];  // another field
  const auto silent = folder.put("a.dcm", bytes), wrong = folder.put("b.dcm", cineFile(timedBy("soon")));
  for (const auto& file : {pages, silent, wrong, folder / "p0.png"}) {
    auto reader = CineReader::open(file);
    ASSERT_TRUE(reader) << reader.error();
    EXPECT_EQ(reader->info().assumedRate_hz, 25.0) << file;
    EXPECT_TRUE(contains(reader->info().notes, "25 a second were assumed")) << file;
    EXPECT_FALSE(contains(reader->info().notes, "they have none")) << file;
    EXPECT_EQ(contains(reader->info().notes, "\"soon\""), file == wrong);
    auto stated = CineReader::open(file, noProgress(), {}, {}, 10.0);
    ASSERT_TRUE(stated) << stated.error();
    EXPECT_TRUE(stated->info().timesKnown);
    EXPECT_FALSE(contains(stated->info().notes, "assumed"));
    CineFrame frame;
    for (int n = 0; n < 3; ++n) {
      ASSERT_TRUE(*stated->next(frame));
      EXPECT_NEAR(frame.time_s, 0.1 * n, 1e-12) << file;
    }
  }
  const auto timed = folder.put("c.dcm", cineFile(timedBy("40")));
  EXPECT_FALSE(contains(CineReader::open(timed)->info().notes, "assumed"));
  EXPECT_TRUE(contains(CineReader::open(timed, noProgress(), {}, {}, 10.0)->info().notes, "The rate of the images was stated, 10"));
}

TEST(CineReader, RegionsThatGiveNoScaleAreNamed) {
  const TempFolder folder;
  CineOf cine = timedBy("40");
  cine.regions = {{0, 0, 3, 5, 0.02, 0.02}, {4, 0, 7, 5, 0.03, 0.03, 0}};
  auto reader = CineReader::open(folder.put("a.dcm", cineFile(cine)));
  ASSERT_TRUE(reader) << reader.error();
  EXPECT_EQ(reader->info().scales.size(), 1u);
  EXPECT_TRUE(contains(reader->info().notes, "Region 2: tissue"));
  EXPECT_TRUE(contains(reader->info().notes, "(its units are not cm) was not used for the scale"));
  cine.regions[1] = {4, 0, 15, 5, 0.03, 0.03};
  auto beyond = CineReader::open(folder.put("b.dcm", cineFile(cine)));
  ASSERT_TRUE(beyond) << beyond.error();
  EXPECT_TRUE(beyond->info().scales.empty());
  EXPECT_TRUE(contains(beyond->info().notes, "it reaches beyond the image of 8 x 6 pixels"));
  EXPECT_TRUE(contains(beyond->info().notes, "so none was used"));
}

TEST(CineReader, ImagesWhosePixelsAreNotSquareBecomeSquare) {
  const TempFolder folder;
  ASSERT_TRUE(writeImage(viewOf(GreyImage(8, 6, 90)), 1.0, folder / "p1.png"));
  const std::string png = bytesOfFile(folder / "p1.png");
  // Behind the signature and IHDR: 2000 x 4000 pixels a metre, a pixel being twice as wide as high.
  const std::string body("pHYs\0\0\x07\xD0\0\0\x0F\xA0\x01", 13);
  const auto check = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()), 13));
  std::string chunk("\0\0\0\x09", 4);
  chunk += body;
  for (const int shift : {24, 16, 8, 0}) chunk += static_cast<char>(check >> shift & 0xFF);
  static_cast<void>(folder.put("p1.png", png.substr(0, 33) + chunk + png.substr(33)));
  auto reader = CineReader::open(folder / "p1.png");
  ASSERT_TRUE(reader) << reader.error();
  EXPECT_EQ(reader->info().width_px, 16);
  EXPECT_EQ(reader->info().height_px, 6);
  EXPECT_TRUE(contains(reader->info().notes, "its pixels are 2 times as wide as high"));
  CineFrame frame;
  ASSERT_TRUE(*reader->next(frame));
  EXPECT_EQ(frame.level.pixels, std::vector<std::uint8_t>(96, 90));
}

TEST(CineReader, ALongFilmTakesTheMemoryOfOneFrameAndStopsWhenAsked) {
  const TempFolder folder;
  writeFilm(folder / "long.avi", 400);
  auto reader = CineReader::open(folder / "long.avi");
  ASSERT_TRUE(reader);
  CineFrame frame;
  for (int n = 0; n < 20; ++n) ASSERT_TRUE(*reader->next(frame));
  const auto before = memoryInUse_bytes();
  std::uint64_t most = 0;
  for (int n = 20; n < 380; ++n) {
    ASSERT_TRUE(*reader->next(frame));
    most = std::max(most, memoryInUse_bytes());
  }
  EXPECT_LT(most, before + (8u << 20));
  const CountedStop stop = CountedStop::atQuestion(1);
  const auto got = reader->next(frame, stop);
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().code, ErrorCode::cancelled);
}

TEST(SequenceWriter, FramesGivenOneByOneMakeTheSameSequence) {
  const TempFolder folder;
  Sequence sequence;
  sequence.width = 5;
  sequence.height = 4;
  sequence.imageType = "BRIGHTNESS";
  for (int n = 0; n < 3; ++n) {
    SequenceFrame frame;
    frame.time_s = 0.25 * n;
    sequence.frames.push_back(frame);
    for (int p = 0; p < 20; ++p) sequence.pixels.push_back(static_cast<std::uint8_t>(40 * n + p));
  }
  Sequence header = sequence;
  header.pixels.clear();
  std::size_t n = 0;
  const auto next = [&]() -> Result<std::span<const std::uint8_t>> { return sequence.framePixels(n++); };
  ASSERT_TRUE(writeSequence(header, next, folder / "one.igs.mha"));
  ASSERT_TRUE(writeSequence(sequence, folder / "whole.igs.mha"));
  const auto one = readSequence(folder / "one.igs.mha"), whole = readSequence(folder / "whole.igs.mha");
  ASSERT_TRUE(one && whole);
  EXPECT_EQ(one->pixels, whole->pixels);
  EXPECT_EQ(one->frames, whole->frames);

  const auto early = [&]() -> Result<std::span<const std::uint8_t>> { return std::span<const std::uint8_t>(); };
  const auto refused = writeSequence(header, early, folder / "early.igs.mha");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::truncated);
  EXPECT_FALSE(fs::exists(folder / "early.igs.mha"));
}

}  // namespace
}  // namespace ew::test::cine_reader_test
