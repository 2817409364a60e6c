#include <gtest/gtest.h>

#include "dicom_files.h"
#include "ew/io/cine_reader.h"
#include "ew/io/dicom.h"
#include "ew/io/dicom_stack.h"
#include "packed_images.h"

// DICOM as devices and gateways store it: lengths that contradict the header, numbers that are there and empty, bytes behind the data.

namespace ew::foreign_dicom_test {
namespace {
using namespace test;

CineOf smallCine() {
  CineOf cine;
  cine.pixels = ramp(3 * 48);
  return cine;
}

/// The same bytes with the value of an explicit little endian element of 16 bits taken away.
std::string emptied(std::string file, std::uint32_t tag, const char* kind) {
  DicomWriter head;
  const std::string mark = head.bytes(static_cast<std::uint16_t>(tag >> 16)) + head.bytes(static_cast<std::uint16_t>(tag & 0xFFFFu)) + kind;
  const auto at = file.find(mark);
  EXPECT_NE(at, std::string::npos);
  const auto length = static_cast<std::size_t>(static_cast<unsigned char>(file[at + 6]));
  file[at + 6] = '\0';
  return file.erase(at + 8, length);
}

/// Grey in colours, `full`: a colour for each pixel; else two neighbours share one.
std::string yccOf(const std::string& grey, bool full, bool planar = false) {
  std::string bytes;
  if (full && planar) return grey + std::string(2 * grey.size(), '\x80');
  for (std::size_t n = 0; n < grey.size(); n += full ? 1 : 2) {
    bytes += grey[n];
    if (!full) bytes += grey[n + 1];
    bytes += std::string(2, '\x80');
  }
  return bytes;
}

TEST(ForeignDicom, ColoursAreThinnedByTheLengthOfTheDataAndNotByTheirName) {
  const TempFolder folder;
  const std::string grey = ramp(48);
  for (const bool planar : {false, true}) {
    for (const int frames : {1, 2, 3}) {
      CineOf cine;
      cine.samples = 3;
      cine.frames = frames;
      cine.photometric = "YBR_FULL_422";
      cine.planar = planar ? 1 : 0;
      for (int n = 0; n < frames; ++n) cine.pixels += yccOf(grey, true, planar);
      const auto read = readDicomCine(folder.put("a.dcm", cineFile(cine)));
      ASSERT_TRUE(succeeded(read)) << frames << planar;
      EXPECT_EQ(read->colouredShare, 0.0);
      for (std::size_t n = 0; n < grey.size(); ++n) ASSERT_EQ(read->sequence.pixels[n], static_cast<std::uint8_t>(grey[n])) << n;
      EXPECT_TRUE(contains(read->notes, "named YBR_FULL_422, but each pixel has its own"));
    }
  }
  CineOf thinned;
  thinned.samples = 3;
  thinned.frames = 3;
  thinned.photometric = "YBR_FULL_422";
  for (int n = 0; n < 3; ++n) thinned.pixels += yccOf(grey, false);
  const auto right = readDicomCine(folder.put("b.dcm", cineFile(thinned)));
  ASSERT_TRUE(succeeded(right));
  EXPECT_EQ(right->sequence.pixels[5], static_cast<std::uint8_t>(grey[5]));
  EXPECT_FALSE(contains(right->notes, "by the length of the data"));
  thinned.photometric = "YBR_FULL";
  const auto other = readDicomCine(folder.put("c.dcm", cineFile(thinned)));
  ASSERT_TRUE(succeeded(other));
  EXPECT_EQ(other->sequence.pixels[5], static_cast<std::uint8_t>(grey[5]));
  EXPECT_EQ(other->colouredShare, 0.0);
}

TEST(ForeignDicom, ImagesBeyondTheNamedNumberAreTold) {
  const TempFolder folder;
  CineOf cine = smallCine();
  cine.frames = 2;
  const auto read = readDicomCine(folder.put("a.dcm", cineFile(cine)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->sequence.frames.size(), 2u);
  EXPECT_TRUE(contains(read->notes, "2 frames, which take 96 bytes, but 144 are stored"));
  EXPECT_FALSE(contains(readDicomCine(folder.put("b.dcm", cineFile(smallCine())))->notes, "are stored"));
}

TEST(ForeignDicom, ALengthOfAWholeMultipleContradictsTheLayout) {
  const TempFolder folder;
  CineOf cine = smallCine();
  cine.frames = 1;
  const auto read = readDicomCine(folder.put("a.dcm", cineFile(cine)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_TRUE(contains(read->notes, "exactly 3 times as many: the length and the layout disagree"));
  cine.frames = 2;
  EXPECT_FALSE(contains(readDicomCine(folder.put("b.dcm", cineFile(cine)))->notes, "disagree"));
}

TEST(ForeignDicom, BytesBehindThePixelsCostNothing) {
  const TempFolder folder;
  const std::string good = cineFile(smallCine());
  for (const std::string& tail : {std::string(1, '\0'), std::string("\r\n"), std::string(40, '\0'), std::string(64, '\xFF'),
                                  std::string("padding!", 8), std::string(2048 - good.size() % 2048, '\0')}) {
    const auto read = readDicomCine(folder.put("a.dcm", good + tail));
    ASSERT_TRUE(succeeded(read)) << tail.size();
    EXPECT_EQ(read->sequence.frames.size(), 3u);
    EXPECT_EQ(read->sequence.pixels[100], static_cast<std::uint8_t>(smallCine().pixels[100]));
    EXPECT_TRUE(contains(read->notes, "behind its pixels"));
  }
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("b.dcm", good.substr(0, good.size() - 4))), ErrorCode::truncated));
}

TEST(ForeignDicom, PackedImagesMayEndWithoutTheirMark) {
  const TempFolder folder;
  CineOf cine;
  cine.syntax = kRle;
  for (int n = 0; n < 3; ++n) cine.packed.push_back(rleOf({ramp(48)}));
  const std::string whole = cineFile(cine), unmarked = whole.substr(0, whole.size() - 8);
  for (const std::string& file :
       {unmarked, unmarked + std::string(8, '\0'), unmarked + std::string(100, '\0'), whole + std::string(33, '\0')}) {
    const auto read = readDicomCine(folder.put("a.dcm", file));
    ASSERT_TRUE(succeeded(read)) << file.size();
    EXPECT_EQ(read->sequence.frames.size(), 3u);
    EXPECT_EQ(read->sequence.pixels[143], static_cast<std::uint8_t>(ramp(48)[47]));
  }
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("b.dcm", unmarked.substr(0, unmarked.size() - 20))), ErrorCode::truncated));
}

TEST(ForeignDicom, AMissingByteOfPaddingAtTheEndCostsNothing) {
  const TempFolder folder;
  for (const char* syntax : {kExplicitLittle, kImplicitLittle}) {
    CineOf cine;
    cine.syntax = syntax;
    cine.columns = 7;
    cine.rows = 5;
    cine.regions = {{0, 0, 6, 4}};
    cine.pixels = ramp(105);
    const std::string whole = cineFile(cine);  // 105 samples and one byte more
    const auto read = readDicomCine(folder.put("a.dcm", whole.substr(0, whole.size() - 1)));
    ASSERT_TRUE(succeeded(read)) << syntax;
    EXPECT_EQ(read->sequence.frames.size(), 3u);
    EXPECT_EQ(read->sequence.pixels, std::vector<std::uint8_t>(cine.pixels.begin(), cine.pixels.end()));
    EXPECT_TRUE(contains(read->notes, "one byte shorter than it says"));
    EXPECT_FALSE(contains(readDicomCine(folder.put("b.dcm", whole))->notes, "shorter"));
    EXPECT_TRUE(failedWith(readDicomCine(folder.put("c.dcm", whole.substr(0, whole.size() - 2))), ErrorCode::truncated));
  }
  const std::string even = cineFile(smallCine());
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("d.dcm", even.substr(0, even.size() - 1))), ErrorCode::truncated)) << "it is a sample";
}

TEST(ForeignDicom, AMissingByteOfPaddingOfTheLastPackedImageCostsNothing) {
  const TempFolder folder;
  CineOf rle;
  rle.syntax = kRle;
  rle.columns = 7;
  rle.rows = 7;
  rle.regions = {{0, 0, 6, 6}};
  for (int n = 0; n < 3; ++n) rle.packed.push_back(rleOf({ramp(49)}));  // of an odd number of bytes, and one more
  const std::string packed = cineFile(rle);
  const auto read = readDicomCine(folder.put("a.dcm", packed.substr(0, packed.size() - 9)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->sequence.pixels[146], static_cast<std::uint8_t>(48));
  EXPECT_TRUE(contains(read->notes, "one byte shorter than it says"));
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("b.dcm", packed.substr(0, packed.size() - 10))), ErrorCode::truncated));

  CineOf jpegLs;
  jpegLs.syntax = kJpegLs;
  jpegLs.columns = 40;
  jpegLs.rows = 32;
  jpegLs.frames = 1;
  jpegLs.regions = {{0, 0, 39, 31}};
  bool hadOdd = false, hadEven = false;
  for (int seed = 2; seed < 40 && !(hadOdd && hadEven); ++seed) {
    std::string grey;
    for (int p = 0; p < 40 * 32; ++p) grey += static_cast<char>((p * seed) % 251);
    std::string stream = packedBy<gdcm::JPEGLSCodec>(grey, 40, 32, 1, 8);
    if (stream.back() == '\0') stream.pop_back();
    const bool odd = stream.size() % 2 != 0;
    if (odd ? hadOdd : hadEven) continue;
    (odd ? hadOdd : hadEven) = true;
    jpegLs.packed = {stream};
    const std::string file = cineFile(jpegLs);
    const auto cut = readDicomCine(folder.put("c.dcm", file.substr(0, file.size() - 9)));
    if (odd) {
      ASSERT_TRUE(succeeded(cut)) << seed;
      EXPECT_EQ(cut->sequence.pixels, std::vector<std::uint8_t>(grey.begin(), grey.end()));
    } else {
      EXPECT_TRUE(failedWith(cut, ErrorCode::truncated)) << "a byte of the stream is missing";
    }
  }
  EXPECT_TRUE(hadOdd);
  EXPECT_TRUE(hadEven);
}

TEST(ForeignDicom, ADataSetWithoutThePreambleIsReadWithANote) {
  const TempFolder folder;
  for (const char* syntax : {kImplicitLittle, kExplicitLittle}) {
    CineOf cine = smallCine();
    cine.syntax = syntax;
    for (const bool withMeta : {false, true}) {
      const auto file = folder.put("a.dcm", withMeta ? cineFile(cine).substr(132) : dataSetOf(cine));
      EXPECT_TRUE(isDicom(file)) << syntax << withMeta;
      const auto read = readDicomCine(file);
      ASSERT_TRUE(succeeded(read)) << syntax << withMeta;
      EXPECT_EQ(read->sequence.pixels, std::vector<std::uint8_t>(cine.pixels.begin(), cine.pixels.end()));
      EXPECT_TRUE(contains(read->notes, "not the beginning of a DICOM file"));
      EXPECT_TRUE(succeeded(CineReader::open(file)));
    }
    EXPECT_FALSE(contains(readDicomCine(folder.put("b.dcm", cineFile(cine)))->notes, "beginning of a DICOM file"));
  }
}

TEST(ForeignDicom, SamplesAndTextsThatBeginWithSmallNumbersAreNoDataSet) {
  const TempFolder folder;
  const auto samples = [](std::vector<std::uint16_t> values) {
    values.resize(400, 7);
    return bytesOf(values);
  };
  for (const std::string& bytes : {samples({8, 5, 10, 0, 4, 4, 4, 4}), samples({8, 8, 8, 8}), samples({2, 0, 4, 0, 1, 0, 0, 0}),
                                   samples({2, 2, 2, 2}), std::string("\x08\0\x05\0XX\x04\0abcd", 12) + ramp(100), std::string(300, '\0'),
                                   std::string("\x02\0\0\0UL\x02\0ab", 10) + ramp(100)})
    EXPECT_FALSE(isDicom(folder.put("x.bin", bytes))) << bytes.size();
}

/// The packed images of a file cut into fragments, with an offset table or without.
std::string inFragments(const CineOf& cine, const std::vector<std::vector<std::string>>& images, bool withTable) {
  CineOf one = cine;
  one.packed = {"x"};
  std::string file = cineFile(one);
  file.resize(file.size() - (8 + 2 + 8) - 8);  // the one fragment with its end, and the empty table
  const DicomWriter bytes;
  const auto item = [&](const std::string& value) {
    return bytes.bytes(std::uint16_t{0xFFFE}) + bytes.bytes(std::uint16_t{0xE000}) + bytes.bytes(static_cast<std::uint32_t>(value.size())) +
           value;
  };
  std::string table, all;
  for (const auto& image : images) {
    table += bytes.bytes(static_cast<std::uint32_t>(all.size()));
    for (const std::string& part : image) all += item(part);
  }
  return file + item(withTable ? table : std::string()) + all + bytes.bytes(std::uint16_t{0xFFFE}) + bytes.bytes(std::uint16_t{0xE0DD}) +
         bytes.bytes(std::uint32_t{0});
}

TEST(ForeignDicom, ImagesInSeveralFragmentsAreWholeWithAndWithoutAnOffsetTable) {
  const TempFolder folder;
  CineOf cine;
  cine.syntax = kJpegLs;
  cine.columns = 40;
  cine.rows = 32;
  cine.frames = 2;
  cine.regions = {{0, 0, 39, 31}};
  std::vector<std::vector<std::string>> images;
  std::string expected;
  for (int n = 0; n < 2; ++n) {
    std::string grey;
    for (int p = 0; p < 40 * 32; ++p) grey += static_cast<char>((p * (n + 3)) % 251);
    expected += grey;
    std::string packed = packedBy<gdcm::JPEGLSCodec>(grey, 40, 32, 1, 8);
    if (packed.size() % 2 != 0) packed += '\0';
    const std::size_t third = packed.size() / 3 / 2 * 2;
    images.push_back({packed.substr(0, third), packed.substr(third, third), packed.substr(2 * third)});
  }
  for (const bool withTable : {false, true}) {
    const auto read = readDicomCine(folder.put("a.dcm", inFragments(cine, images, withTable)));
    ASSERT_TRUE(succeeded(read)) << withTable;
    EXPECT_EQ(read->sequence.pixels, std::vector<std::uint8_t>(expected.begin(), expected.end()));
  }
  cine.frames = 1;  // the second image is behind what the header promises
  const auto first = readDicomCine(folder.put("b.dcm", inFragments(cine, images, true)));
  ASSERT_TRUE(succeeded(first));
  EXPECT_EQ(first->sequence.pixels, std::vector<std::uint8_t>(expected.begin(), expected.begin() + 40 * 32));
  EXPECT_TRUE(contains(first->notes, "1 frame, but 2 images are stored"));
}

TEST(ForeignDicom, NumbersThatAreThereAndEmptyFollowFromTheRest) {
  const TempFolder folder;
  const std::string good = cineFile(smallCine());
  struct Field {
    std::uint32_t tag;
    const char* kind;
    const char* name;
  };
  for (const Field& field : {Field{0x00280101u, "US", "Bits Stored"}, Field{0x00280102u, "US", "High Bit"},
                             Field{0x00280103u, "US", "Pixel Representation"}, Field{0x00280002u, "US", "Samples per Pixel"}}) {
    const auto read = readDicomCine(folder.put("a.dcm", emptied(good, field.tag, field.kind)));
    ASSERT_TRUE(succeeded(read)) << field.name;
    EXPECT_EQ(read->sequence.frames.size(), 3u);
    EXPECT_TRUE(contains(read->notes, std::string(field.name) + " is there and empty")) << field.name;
  }
  EXPECT_TRUE(says(readDicomCine(folder.put("b.dcm", emptied(good, 0x00280010u, "US"))), "Rows is \"nothing\""));
}

TEST(ForeignDicom, AnEmptyNumberOfFramesMeansWhatIsStored) {
  const TempFolder folder;
  CineOf still = smallCine();
  still.frames = 1;
  still.pixels = ramp(48);
  const auto one = readDicomCine(folder.put("a.dcm", emptied(cineFile(still), 0x00280008u, "IS")));
  ASSERT_TRUE(succeeded(one));
  EXPECT_EQ(one->sequence.frames.size(), 1u);
  still.frames = 0;
  const auto zero = readDicomCine(folder.put("b.dcm", cineFile(still)));
  ASSERT_TRUE(succeeded(zero));
  EXPECT_EQ(zero->sequence.frames.size(), 1u);
  const auto three = readDicomCine(folder.put("c.dcm", emptied(cineFile(smallCine()), 0x00280008u, "IS")));
  ASSERT_TRUE(succeeded(three));
  EXPECT_EQ(three->sequence.frames.size(), 3u);
  EXPECT_TRUE(contains(three->notes, "3 are stored in it"));
}

std::string stillAt(double z, int level, const std::string& series = "2.25.7", const std::string& position = "") {
  DicomWriter set;
  set.text(0x00080016u, "UI", "1.2.840.10008.5.1.4.1.1.6.1").text(0x00080060u, "CS", "US").text(0x00100010u, "PN", "Doe^Jane");
  set.text(0x0020000Eu, "UI", series);
  if (position != "none")
    set.text(0x00200032u, "DS", position.empty() ? "10\\20\\" + std::to_string(z) : position).text(0x00200037u, "DS", "1\\0\\0\\0\\1\\0");
  set.us(0x00280002u, 1).text(0x00280004u, "CS", "MONOCHROME2").us(0x00280010u, 2).us(0x00280011u, 3).text(0x00280030u, "DS", "0.5\\0.25");
  set.us(0x00280100u, 8).us(0x00280101u, 8).us(0x00280102u, 7).us(0x00280103u, 0);
  set.raw(0x7FE00010u, "OW", std::string(6, static_cast<char>(level)));
  return dicomFile(kExplicitLittle, set.bytes());
}

TEST(DicomStack, StillsAreJoinedByTheirPositionsWhateverTheirNames) {
  const TempFolder folder;
  static_cast<void>(folder.put("c", stillAt(1.0, 10)));
  static_cast<void>(folder.put("a.dcm", stillAt(3.0, 30)));
  static_cast<void>(folder.put("b", stillAt(2.0, 20)));
  static_cast<void>(folder.put("notes.txt", "no image"));
  EXPECT_EQ(dicomFilesIn(folder.path()).size(), 3u);
  const auto read = readDicomStack(folder.path());
  ASSERT_TRUE(succeeded(read));
  const Grid& grid = read->volume.grid;
  EXPECT_EQ(grid.dims, glm::ivec3(3, 2, 3));
  EXPECT_EQ(grid.spacing_mm, glm::dvec3(0.25, 0.5, 1.0));
  EXPECT_EQ(grid.origin_mm, glm::dvec3(10, 20, 1));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(read->volume.echo[grid.indexOf(1, 1, k)], 10 * (k + 1));
  EXPECT_TRUE(contains(read->removed.fields, "Patient's Name"));
  EXPECT_FALSE(contains(read->notes, "is not used")) << "spacing, position and orientation are";
}

TEST(DicomStack, AStillThatIsMissingIsNotMadeUpUnasked) {
  const TempFolder folder;
  for (const int z : {1, 2, 4, 5}) static_cast<void>(folder.put("i" + std::to_string(z) + ".dcm", stillAt(z, 10 * z)));
  const std::string name = "\"" + folder.path().filename().string() + "\"";
  const auto unnamed = readDicomStack(folder.path());
  EXPECT_TRUE(failedWith(unnamed, ErrorCode::unsupported));
  EXPECT_TRUE(says(
      unnamed, "The DICOM stills of " + name +
                   " lie 1 mm apart; missing between them, and made up of those next to them: 1. Get the missing files, or accept that."));
  for (const std::string& broken : {std::string(), std::string(100, '\0')}) {
    static_cast<void>(folder.put("i3.dcm", broken));
    const auto refused = readDicomStack(folder.path());
    EXPECT_TRUE(says(refused, "Get the files anew that hold no DICOM data (\"i3.dcm\"), or accept that."));
    DicomStackOptions accepted;
    accepted.acceptsSmall = true;
    const auto made = readDicomStack(folder.path(), accepted);
    ASSERT_TRUE(succeeded(made));
    EXPECT_EQ(made->volume.grid.dims.z, 5);
    EXPECT_TRUE(contains(made->notes, "Left out of " + name + ", because they hold no DICOM data: \"i3.dcm\"."));
  }
  static_cast<void>(folder.put("i3.dcm", stillAt(3, 30)));
  static_cast<void>(folder.put("empty", ""));
  static_cast<void>(folder.put("notes.txt", "no image"));
  const auto whole = readDicomStack(folder.path());
  ASSERT_TRUE(succeeded(whole)) << "at an end, or beside it, nothing is missed";
  EXPECT_TRUE(contains(whole->notes, "because they hold no DICOM data: \"empty\"."));
}

TEST(DicomStack, WhatIsNoVolumeIsSaid) {
  const auto joined = [](std::initializer_list<std::string> stills) {
    const TempFolder folder;
    int n = 0;
    for (const std::string& still : stills) static_cast<void>(folder.put("s" + std::to_string(n++), still));
    return readDicomStack(folder.path());
  };
  EXPECT_TRUE(says(joined({stillAt(1, 1), stillAt(2, 2, "2.25.8")}), "stills of 2 series"));
  EXPECT_TRUE(says(joined({stillAt(1, 1), stillAt(2, 2, "2.25.7", "none")}), "1 of the 2 DICOM stills"));
  EXPECT_TRUE(says(joined({stillAt(1, 1), stillAt(2, 2), cineFile(smallCine())}), "a cine of 3 frames"));
  EXPECT_TRUE(says(joined({stillAt(1, 1), stillAt(1, 2)}), "in one plane"));
  EXPECT_TRUE(says(joined({stillAt(1, 1), stillAt(2, 2), stillAt(3, 3, "2.25.7", "15\\20\\3")}), "parallel and in line"));
}

}  // namespace
}  // namespace ew::foreign_dicom_test
