#include "ew/io/dicom.h"

#include <gdcmImageReader.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "dicom_files.h"
#include "packed_images.h"
#include "recordings.h"

namespace ew::dicom_test {
namespace {
using namespace test;

std::string ramps(std::size_t count) {
  std::string bytes(count, '\0');
  for (std::size_t n = 0; n < count; ++n) bytes[n] = static_cast<char>(n * 7 % 251);
  return bytes;
}

std::vector<std::uint8_t> levels(const std::string& bytes) { return {bytes.begin(), bytes.end()}; }

CineOf greyCine() {
  CineOf cine;
  cine.pixels = ramps(8 * 6 * 3);
  return cine;
}

class DicomSyntax : public ::testing::TestWithParam<const char*> {};

TEST_P(DicomSyntax, UncompressedImagesComeThroughUnchanged) {
  const TempFolder folder;
  CineOf of = greyCine();
  of.syntax = GetParam();
  for (const bool undefined : {false, true}) {
    of.undefinedLengths = undefined;
    const auto cine = readDicomCine(folder.put("a.dcm", cineFile(of)));
    ASSERT_TRUE(succeeded(cine));
    EXPECT_EQ(cine->sequence.pixels, levels(of.pixels));
    EXPECT_EQ(cine->sequence.width, 8);
    EXPECT_EQ(cine->sequence.height, 6);
    ASSERT_EQ(cine->sequence.frames.size(), 3u);
    EXPECT_DOUBLE_EQ(*cine->sequence.frames[2].time_s, 0.08);
    EXPECT_NEAR(cine->pixel_mm.x, 0.2, 1e-12);
    EXPECT_NEAR(cine->pixel_mm.y, 0.3, 1e-12);
    EXPECT_EQ(cine->colouredShare, 0.0);
  }
}
INSTANTIATE_TEST_SUITE_P(Syntaxes, DicomSyntax, ::testing::Values(kImplicitLittle, kExplicitLittle, kExplicitBig, kDeflated));

TEST(DicomCine, TheGdcmReaderSeesTheSamePixelsInTheFilesTheTestsWrite) {
  const TempFolder folder;
  const CineOf of = greyCine();
  const auto file = folder.put("a.dcm", cineFile(of));
  gdcm::ImageReader peer;
  peer.SetFileName(file.c_str());
  ASSERT_TRUE(peer.Read());
  std::vector<char> buffer(peer.GetImage().GetBufferLength());
  ASSERT_TRUE(peer.GetImage().GetBuffer(buffer.data()));
  EXPECT_EQ(std::string(buffer.begin(), buffer.end()), of.pixels);
}

TEST(DicomCine, LosslessCodecsGiveBackEveryGreyLevel) {
  const TempFolder folder;
  struct Way {
    const char* syntax;
    std::string (*pack)(const std::string&, std::uint16_t, std::uint16_t, int, int, bool);
  };
  for (const auto& [syntax, pack] : {Way{kJpegLossless, packedBy<gdcm::JPEGCodec>}, Way{kJpegLs, packedBy<gdcm::JPEGLSCodec>},
                                     Way{kJpeg2000, packedBy<gdcm::JPEG2000Codec>}}) {
    CineOf of;
    of.syntax = syntax;
    of.columns = 40;
    of.rows = 32;
    of.frames = 2;
    of.regions = {{0, 0, 39, 31}};
    const std::string first = ramps(40 * 32), second(40 * 32, '\x55');
    of.packed = {pack(first, 40, 32, 1, 8, true), pack(second, 40, 32, 1, 8, true)};
    const auto cine = readDicomCine(folder.put("a.dcm", cineFile(of)));
    ASSERT_TRUE(succeeded(cine)) << syntax;
    EXPECT_EQ(cine->sequence.pixels, levels(first + second)) << syntax;
  }
}

TEST(DicomCine, RunLengthsAreUnpackedInEightAndSixteenBits) {
  const TempFolder folder;
  CineOf of;
  of.syntax = kRle;
  of.frames = 2;
  const std::string first = ramps(48), second = std::string(40, '\7') + ramps(8);
  of.packed = {rleOf({first}), rleOf({second})};
  const auto cine = readDicomCine(folder.put("a.dcm", cineFile(of)));
  ASSERT_TRUE(succeeded(cine));
  EXPECT_EQ(cine->sequence.pixels, levels(first + second));
  of.bits = of.stored = 16;
  of.packed = {rleOf({std::string(48, '\1'), first}), rleOf({std::string(48, '\1'), first})};
  const auto wide = readDicomCine(folder.put("b.dcm", cineFile(of)));
  ASSERT_TRUE(succeeded(wide));
  const auto [low, high] = std::minmax_element(
      first.begin(), first.end(), [](char a, char b) { return static_cast<unsigned char>(a) < static_cast<unsigned char>(b); });
  EXPECT_EQ(wide->sequence.pixels[static_cast<std::size_t>(low - first.begin())], 0);
  EXPECT_EQ(wide->sequence.pixels[static_cast<std::size_t>(high - first.begin())], 255);
  EXPECT_TRUE(contains(wide->notes, "16 bits"));
}

TEST(DicomCine, SixteenBitGreyIsSpreadFromItsSmallestToItsLargestValueAndSignsAreKept) {
  const TempFolder folder;
  CineOf of;
  of.columns = 2;
  of.rows = 2;
  of.frames = 1;
  of.regions = {{0, 0, 1, 1}};
  of.bits = of.stored = 16;
  of.sign = 1;
  of.pixels = bytesOf(std::vector<std::int16_t>{-1000, 1000, 0, -1000});
  const auto cine = readDicomCine(folder.put("a.dcm", cineFile(of)));
  ASSERT_TRUE(succeeded(cine));
  EXPECT_EQ(cine->sequence.pixels, (std::vector<std::uint8_t>{0, 255, 128, 0}));
  of.photometric = "MONOCHROME1";
  const auto turned = readDicomCine(folder.put("b.dcm", cineFile(of)));
  ASSERT_TRUE(succeeded(turned));
  EXPECT_EQ(turned->sequence.pixels, (std::vector<std::uint8_t>{255, 0, 127, 255}));
}

TEST(DicomCine, ColoursBecomeLuminanceByPixelOrByPlane) {
  const TempFolder folder;
  CineOf of;
  of.columns = 2;
  of.rows = 1;
  of.frames = 1;
  of.regions = {};
  of.samples = 3;
  of.photometric = "RGB";
  const CineOptions keep{.region = 0, .pixel_mm = glm::dvec2(0.1), .colour = ColourRule::keepGrey, .blank = {}, .keepText = false};
  of.pixels = std::string("\xff\x00\x00\x0a\x0b\x0c", 6);
  const auto byPixel = readDicomCine(folder.put("a.dcm", cineFile(of)), keep);
  ASSERT_TRUE(succeeded(byPixel));
  EXPECT_EQ(byPixel->sequence.pixels, (std::vector<std::uint8_t>{76, 11}));
  EXPECT_EQ(byPixel->coloured, (std::vector<std::uint8_t>{1, 0}));
  of.planar = 1;
  of.pixels = std::string("\xff\x0a\x00\x0b\x00\x0c", 6);
  const auto byPlane = readDicomCine(folder.put("b.dcm", cineFile(of)), keep);
  ASSERT_TRUE(succeeded(byPlane));
  EXPECT_EQ(byPlane->sequence.pixels, byPixel->sequence.pixels);
  // Uncompressed YBR_FULL_422: two luminances share their colours.
  of.planar = 0;
  of.photometric = "YBR_FULL_422";
  of.pixels = std::string("\x40\x50\x80\x80", 4);
  const auto thinned = readDicomCine(folder.put("c.dcm", cineFile(of)), keep);
  ASSERT_TRUE(succeeded(thinned));
  EXPECT_EQ(thinned->sequence.pixels, (std::vector<std::uint8_t>{0x40, 0x50}));
  EXPECT_TRUE(thinned->coloured.empty());
  of.photometric = "YBR_FULL";
  of.pixels = std::string("\x40\x80\x80\x50\x80\xf0", 6);
  const auto full = readDicomCine(folder.put("d.dcm", cineFile(of)), keep);
  ASSERT_TRUE(succeeded(full));
  EXPECT_EQ(full->sequence.pixels, (std::vector<std::uint8_t>{0x40, 0x50}));
  EXPECT_EQ(full->coloured, (std::vector<std::uint8_t>{0, 1}));
}

TEST(DicomCine, JpegColoursAreReadWithinTheCodecsError) {
  const TempFolder folder;
  CineOf of;
  of.syntax = kJpegBaseline;
  of.columns = of.rows = 32;
  of.frames = 1;
  of.regions = {{0, 0, 31, 31}};
  of.samples = 3;
  of.photometric = "YBR_FULL_422";
  std::string rgb;
  for (int n = 0; n < 32 * 32; ++n) rgb += std::string(3, static_cast<char>(40 + n / 32 * 5));
  of.packed = {packedBy<gdcm::JPEGCodec>(rgb, 32, 32, 3, 8, false)};
  const auto cine = readDicomCine(folder.put("a.dcm", cineFile(of)));
  ASSERT_TRUE(succeeded(cine));
  for (int n = 0; n < 32 * 32; ++n) ASSERT_NEAR(cine->sequence.pixels[static_cast<std::size_t>(n)], 40 + n / 32 * 5, 3) << n;
  EXPECT_EQ(cine->colouredShare, 0.0);
}

TEST(DicomCine, Jpeg2000ColoursAreTurnedBackByTheDecoder) {
  const TempFolder folder;
  CineOf of;
  of.syntax = kJpeg2000;
  of.columns = of.rows = 32;
  of.frames = 1;
  of.regions = {{0, 0, 31, 31}};
  of.samples = 3;
  of.photometric = "YBR_RCT";
  std::string rgb;
  for (int n = 0; n < 32 * 32; ++n) rgb += std::string("\xc8\x64", 2) + static_cast<char>(n % 32);
  of.packed = {packedBy<gdcm::JPEG2000Codec>(rgb, 32, 32, 3, 8)};
  const auto cine = readDicomCine(folder.put("a.dcm", cineFile(of)),
                                  {.region = {}, .pixel_mm = {}, .colour = ColourRule::keepGrey, .blank = {}, .keepText = false});
  ASSERT_TRUE(succeeded(cine));
  EXPECT_EQ(cine->sequence.pixels[3], std::lround(0.299 * 200 + 0.587 * 100 + 0.114 * 3));
  EXPECT_EQ(cine->colouredShare, 1.0);
}

TEST(DicomCine, PalettesAreUnfoldedInSegmentsAndInFull) {
  const TempFolder folder;
  CineOf of;
  of.columns = 4;
  of.rows = 1;
  of.frames = 1;
  of.regions = {{0, 0, 3, 0}};
  of.regions = {};
  of.photometric = "PALETTE COLOR";
  of.pixels = std::string("\0\1\2\3", 4);
  const CineOptions whole{.region = 0, .pixel_mm = glm::dvec2(0.1), .colour = ColourRule::ask, .blank = {}, .keepText = false};
  const auto words = [](const std::vector<std::uint16_t>& values) { return bytesOf(values); };
  const auto with = [&](std::uint32_t first, const std::string& table) {
    DicomWriter extra;
    for (std::uint32_t c = 0; c < 3; ++c) extra.raw(0x00281101u + c, "US", words({4, 0, 16}));
    for (std::uint32_t c = 0; c < 3; ++c) extra.raw(first + c, "OW", table);
    of.extra = extra.bytes();
    return readDicomCine(folder.put("p.dcm", cineFile(of)), whole);
  };
  const auto plain = with(0x00281201u, words({0x1000, 0x2000, 0x3000, 0xFF00}));
  ASSERT_TRUE(succeeded(plain));
  EXPECT_EQ(plain->sequence.pixels, (std::vector<std::uint8_t>{0x10, 0x20, 0x30, 0xFF}));
  // A discrete segment of one entry, then a line of three to 0x4000.
  const auto segmented = with(0x00281221u, words({0, 1, 0x1000, 1, 3, 0x4000}));
  ASSERT_TRUE(succeeded(segmented));
  EXPECT_EQ(segmented->sequence.pixels, (std::vector<std::uint8_t>{0x10, 0x20, 0x30, 0x40}));
  EXPECT_TRUE(failedWith(with(0x00281221u, words({2, 1, 0, 0})), ErrorCode::badField)) << "a segment that points at itself";
}

TEST(DicomCine, TimesComeFromTheFieldThatTheFileNames) {
  const TempFolder folder;
  CineOf of = greyCine();
  of.frameTimes = "0\\30\\50";
  const auto cine = readDicomCine(folder.put("a.dcm", cineFile(of)));
  ASSERT_TRUE(succeeded(cine));
  EXPECT_DOUBLE_EQ(*cine->sequence.frames[1].time_s, 0.03);
  EXPECT_DOUBLE_EQ(*cine->sequence.frames[2].time_s, 0.08);
  of.frameTimes = "0\\30";
  const auto shorter = readDicomCine(folder.put("b.dcm", cineFile(of)));
  ASSERT_TRUE(succeeded(shorter));
  EXPECT_FALSE(shorter->sequence.frames[1].time_s.has_value());
  EXPECT_TRUE(contains(shorter->notes, "no usable times"));
}

TEST(DicomCine, OfSeveralRegionsOneIsAskedFor) {
  const TempFolder folder;
  CineOf of = greyCine();
  of.regions = {{0, 0, 3, 5}, {4, 0, 7, 5, 0.05, 0.05}, {0, 0, 7, 0, 0.0, 0.0, 0, 5, 14}};
  const auto file = folder.put("a.dcm", cineFile(of));
  const auto asked = readDicomCine(file);
  EXPECT_TRUE(failedWith(asked, ErrorCode::missingCalibration));
  EXPECT_TRUE(says(asked, "2 calibrated images"));
  const auto second = readDicomCine(file, {.region = 2, .pixel_mm = {}, .colour = ColourRule::ask, .blank = {}, .keepText = false});
  ASSERT_TRUE(succeeded(second));
  EXPECT_EQ(second->sequence.width, 4);
  EXPECT_NEAR(second->pixel_mm.x, 0.5, 1e-12);
  EXPECT_EQ(second->sequence.pixels[0], static_cast<std::uint8_t>(of.pixels[4]));
  EXPECT_EQ(second->sequence.pixels[4], static_cast<std::uint8_t>(of.pixels[12]));
  EXPECT_EQ(second->removed.pixelsPerFrame, 24u);
  EXPECT_TRUE(failedWith(readDicomCine(file, {.region = 4, .pixel_mm = {}, .colour = ColourRule::ask, .blank = {}, .keepText = false}),
                         ErrorCode::missingCalibration));
}

TEST(DicomCine, RegionsThatCannotBeTrueAreNeverUsed) {
  const TempFolder folder;
  CineOf of = greyCine();
  const auto refusal = [&](const RegionOf& region) {
    of.regions = {region};
    return readDicomCine(folder.put("a.dcm", cineFile(of)));
  };
  EXPECT_TRUE(says(refusal({0, 0, 15, 11}), "made for another size"));
  EXPECT_TRUE(says(refusal({0, 0, 7, 5, 0.0, 0.1}), "no size of a pixel"));
  EXPECT_TRUE(says(refusal({0, 0, 7, 5, 0.1, std::nan("")}), "no size of a pixel"));
  EXPECT_TRUE(says(refusal({0, 0, 7, 5, 0.1, 0.1, 4}), "not cm"));
  EXPECT_TRUE(says(refusal({5, 0, 5, 5}), "missing or crossed"));
  of.regions = {};
  EXPECT_TRUE(says(readDicomCine(folder.put("a.dcm", cineFile(of))), "no ultrasound regions"));
  // One stale region makes the others suspect: they are not taken unless named.
  of.regions = {{0, 0, 15, 11}, {0, 0, 7, 5}};
  const auto file = folder.put("a.dcm", cineFile(of));
  EXPECT_TRUE(failedWith(readDicomCine(file), ErrorCode::missingCalibration));
  EXPECT_TRUE(succeeded(readDicomCine(file, {.region = 2, .pixel_mm = {}, .colour = ColourRule::ask, .blank = {}, .keepText = false})));
  const auto given =
      readDicomCine(file, {.region = 0, .pixel_mm = glm::dvec2(0.4, 0.5), .colour = ColourRule::ask, .blank = {}, .keepText = false});
  ASSERT_TRUE(succeeded(given));
  EXPECT_EQ(given->pixel_mm, glm::dvec2(0.4, 0.5));
  EXPECT_EQ(given->sequence.width, 8);
}

TEST(DicomCine, DopplerIsNeverLostInSilence) {
  const TempFolder folder;
  CineOf of;
  of.samples = 3;
  of.photometric = "RGB";
  of.frames = 1;
  for (int n = 0; n < 48; ++n) of.pixels += n < 12 ? std::string("\xf0\x20\x20", 3) : std::string(3, '\x60');
  of.regions = {{0, 0, 7, 5}, {0, 0, 7, 1, 0.02, 0.03, 3, 1, 2}};
  const auto file = folder.put("a.dcm", cineFile(of));
  CineOptions options;
  options.region = 1;
  const auto asked = readDicomCine(file, options);
  EXPECT_TRUE(failedWith(asked, ErrorCode::unsupported));
  EXPECT_TRUE(says(asked, "25 % of the pixels are coloured, in a colour flow region"));
  options.colour = ColourRule::dropColour;
  const auto dropped = readDicomCine(file, options);
  ASSERT_TRUE(succeeded(dropped));
  EXPECT_EQ(dropped->sequence.pixels[0], 0);
  EXPECT_EQ(dropped->sequence.pixels[12], 0x60);
  EXPECT_EQ(std::accumulate(dropped->coloured.begin(), dropped->coloured.end(), 0), 12);
  options.colour = ColourRule::keepGrey;
  const auto kept = readDicomCine(file, options);
  ASSERT_TRUE(succeeded(kept));
  EXPECT_EQ(kept->sequence.pixels[0], std::lround(0.299 * 0xf0 + 0.701 * 0x20));
  EXPECT_EQ(kept->coloured, dropped->coloured);
  EXPECT_TRUE(contains(kept->notes, "25 %"));
}

TEST(DicomCine, PatientFieldsAreNamedInTheReportAndTheirValuesAreNowhere) {
  const TempFolder folder;
  const auto cine = readDicomCine(folder.put("a.dcm", cineFile(greyCine())));
  ASSERT_TRUE(succeeded(cine));
  EXPECT_TRUE(contains(cine->removed.fields, "(0010,0010) Patient's Name"));
  EXPECT_TRUE(contains(cine->removed.fields, "(0008,0080) Institution Name"));
  EXPECT_EQ(cine->removed.privateFields, 1u);
  std::string all;
  for (const auto& words : {cine->notes, cine->removed.fields, sentencesOf(cine->removed)})
    for (const Message& sentence : words) all += sentence.english();
  for (const auto& [name, value] : cine->sequence.otherFields) all += name + value;
  for (const char* secret : {"Doe", "4711", "Some Hospital", "private words"}) EXPECT_EQ(all.find(secret), std::string::npos) << secret;
}

TEST(DicomCine, BurnedInTextMustBeAnswered) {
  const TempFolder folder;
  CineOf of = greyCine();
  of.burnedIn = "YES";
  const auto file = folder.put("a.dcm", cineFile(of));
  CineOptions options;
  EXPECT_TRUE(succeeded(readDicomCine(file, options))) << "a region cuts the text away";
  options.region = 0;
  options.pixel_mm = glm::dvec2(0.1);
  EXPECT_TRUE(says(readDicomCine(file, options), "burned in"));
  options.blank = {{0, 0, 8, 2}, {7, 0, 100, 100}};
  const auto blanked = readDicomCine(file, options);
  ASSERT_TRUE(succeeded(blanked));
  for (int n = 0; n < 16; ++n) EXPECT_EQ(blanked->sequence.pixels[static_cast<std::size_t>(n)], 0);
  EXPECT_EQ(blanked->sequence.pixels[23], 0);
  EXPECT_EQ(blanked->sequence.pixels[22], static_cast<std::uint8_t>(of.pixels[22]));
  EXPECT_EQ(blanked->removed.pixelsPerFrame, 20u);
  options.blank.clear();
  options.keepText = true;
  const auto kept = readDicomCine(file, options);
  ASSERT_TRUE(succeeded(kept));
  EXPECT_TRUE(contains(kept->notes, "check that what is left names nobody"));
}

TEST(DicomCine, PromisesTheFileCannotKeepAreRefusedBeforeMemoryIsTaken) {
  const TempFolder folder;
  CineOf of = greyCine();
  of.frames = 4;
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("a.dcm", cineFile(of))), ErrorCode::truncated));
  of = greyCine();
  of.rows = of.columns = 60000;
  of.frames = 1 << 23;
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("a.dcm", cineFile(of))), ErrorCode::tooLarge));
  of = greyCine();
  of.syntax = kJpeg2000;
  of.frames = 1;
  of.packed = {packedBy<gdcm::JPEG2000Codec>(ramps(64 * 64), 64, 64, 1, 8)};
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("a.dcm", cineFile(of))), ErrorCode::badHeader)) << "the stream is of another size";
  of.syntax = "1.2.840.10008.1.2.4.100";
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("a.dcm", cineFile(of))), ErrorCode::unsupported));
  EXPECT_TRUE(
      failedWith(readDicomCine(folder.put("t.dcm", "a text, not an image, but long enough to be looked at")), ErrorCode::badHeader));
}

TEST(DicomCine, AStreamThatStopsTheDecoderCostsTheFrameAndNotTheProgram) {
  // Found by fuzzing: GDCM's assertion in its JPEG decoder ends the process on component ids it does not know.
  const TempFolder folder;
  CineOf of;
  of.syntax = kJpegLossless;
  of.columns = of.rows = 16;
  of.frames = 1;
  of.regions = {{0, 0, 15, 15}};
  of.samples = 3;
  of.photometric = "RGB";
  const std::string whole = packedBy<gdcm::JPEGCodec>(ramps(16 * 16 * 3), 16, 16, 3, 8);
  int refused = 0;
  for (std::size_t at = 2; at < whole.size(); at += 3) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
    of.packed = {damaged};
    const auto read = readDicomCine(folder.put("a.dcm", cineFile(of)),
                                    {.region = 1, .pixel_mm = {}, .colour = ColourRule::keepGrey, .blank = {}, .keepText = false});
    if (!read) ++refused;
  }
  EXPECT_GT(refused, 0);
}

TEST(DicomCine, TheCallerCanStopTheReading) {
  const TempFolder folder;
  StopAfter stop(1);
  EXPECT_TRUE(failedWith(readDicomCine(folder.put("a.dcm", cineFile(greyCine())), {}, stop), ErrorCode::cancelled));
}

EnhancedOf smallVolume() {
  EnhancedOf of;
  of.pixels = ramps(5 * 4 * 3);
  return of;
}

TEST(EnhancedUsVolume, PlanesBecomeAVolumeWhereTheFileSays) {
  const TempFolder folder;
  EnhancedOf of = smallVolume();
  const auto read = readDicomVolume(folder.put("a.dcm", enhancedFile(of)));
  ASSERT_TRUE(succeeded(read));
  const Grid& grid = read->volume.grid;
  EXPECT_EQ(grid.dims, glm::ivec3(5, 4, 3));
  EXPECT_EQ(grid.spacing_mm, glm::dvec3(0.25, 0.5, 2.0)) << "rows stand first in the file";
  EXPECT_EQ(grid.origin_mm, glm::dvec3(1, 2, 3));
  EXPECT_EQ(read->volume.echo, levels(of.pixels));
  EXPECT_TRUE(contains(read->notes, "volume frame of reference"));
  EXPECT_TRUE(contains(read->removed.fields, "Patient's Name"));
  // The same planes in another order, turned about x: down is z, so that the planes run along -y.
  std::swap(of.positions[0], of.positions[2]);
  of.pixels = of.pixels.substr(40, 20) + of.pixels.substr(20, 20) + of.pixels.substr(0, 20);
  const auto turnedOrder = readDicomVolume(folder.put("b.dcm", enhancedFile(of)));
  ASSERT_TRUE(succeeded(turnedOrder));
  EXPECT_EQ(turnedOrder->volume, read->volume);
}

TEST(EnhancedUsVolume, ObliqueEvenPlanesKeepTheirSlantedAxis) {
  const TempFolder folder;
  EnhancedOf of = smallVolume();
  of.positions = {{0, 0, 0}, {1, 0, 2}, {2, 0, 4}};
  const auto read = readDicomVolume(folder.put("a.dcm", enhancedFile(of)));
  ASSERT_TRUE(succeeded(read));
  const glm::dvec3 last = (read->volume.grid.voxelToWorld() * Point<frame::Voxel>{{0, 0, 2}}).at;
  EXPECT_NEAR(glm::length(last - glm::dvec3(2, 0, 4)), 0.0, 1e-9);
  EXPECT_TRUE(contains(read->notes, "not at right angles"));
}

TEST(EnhancedUsVolume, UnevenPlanesAreResampledAlongTheirNormalAndARampStaysOne) {
  const TempFolder folder;
  EnhancedOf of;
  of.positions = {{0, 0, 0}, {0, 0, 1}, {0, 0, 3}, {0, 0, 6}};
  for (const int level : {0, 20, 60, 120}) of.pixels += std::string(20, static_cast<char>(level));
  const auto read = readDicomVolume(folder.put("a.dcm", enhancedFile(of)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->volume.grid.dims.z, 7);
  EXPECT_NEAR(read->volume.grid.spacing_mm.z, 1.0, 1e-9);
  for (int k = 0; k < 7; ++k) EXPECT_EQ(read->volume.echo[read->volume.grid.indexOf(2, 2, k)], 20 * k);
  EXPECT_TRUE(contains(read->notes, "unevenly"));
}

TEST(EnhancedUsVolume, PlanesThatFanOutAreRefusedAsAGridAndGivenOneByOne) {
  const TempFolder folder;
  EnhancedOf of = smallVolume();
  const double s = std::sin(0.1), c = std::cos(0.1);
  of.orientations = {{1, 0, 0, 0, 1, 0}, {1, 0, 0, 0, c, s}, {1, 0, 0, 0, c, -s}};
  const auto file = folder.put("a.dcm", enhancedFile(of));
  EXPECT_TRUE(failedWith(readDicomVolume(file), ErrorCode::unsupported));
  EXPECT_TRUE(says(readDicomVolume(file), "not parallel"));
  const auto planes = readDicomPlanes(file);
  ASSERT_TRUE(succeeded(planes));
  ASSERT_EQ(planes->sequence.frames.size(), 3u);
  const glm::dvec4 corner = planes->sequence.frames[1].transforms[0].matrix * glm::dvec4(4, 3, 0, 1);
  EXPECT_NEAR(corner.x, 1 + 4 * 0.25, 1e-9);
  EXPECT_NEAR(corner.y, 2 + 3 * 0.5 * c, 1e-9);
  EXPECT_NEAR(corner.z, 5 + 3 * 0.5 * s, 1e-9);
}

TEST(EnhancedUsVolume, SeveralVolumesAndFlowPlanesAreTold) {
  const TempFolder folder;
  EnhancedOf of;
  of.positions = {{0, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 1}};
  of.times = {0.0, 0.0, 0.5, 0.5};
  of.pixels = ramps(80);
  const auto file = folder.put("a.dcm", enhancedFile(of));
  EXPECT_TRUE(failedWith(readDicomVolume(file), ErrorCode::missingCalibration));
  const auto second = readDicomVolume(file, {.timeStep = 2});
  ASSERT_TRUE(succeeded(second));
  EXPECT_EQ(second->volume.echo, levels(of.pixels.substr(40)));
  EXPECT_EQ(inspectDicom(file)->timeSteps_s, (std::vector<double>{0.0, 0.5}));
  of.times = {};
  of.types = {"TISSUE_INTENSITY", "TISSUE_INTENSITY", "FLOW_VELOCITY", "FLOW_VELOCITY"};
  const auto tissue = readDicomVolume(folder.put("b.dcm", enhancedFile(of)));
  ASSERT_TRUE(succeeded(tissue));
  EXPECT_EQ(tissue->volume.echo, levels(of.pixels.substr(0, 40)));
  EXPECT_TRUE(contains(tissue->notes, "2 planes hold flow"));
}

TEST(EnhancedUsVolume, GeometryThatIsMissingOrImpossibleIsRefused) {
  const TempFolder folder;
  EnhancedOf of = smallVolume();
  of.spacing = "0\\0.5";
  EXPECT_TRUE(failedWith(readDicomVolume(folder.put("a.dcm", enhancedFile(of))), ErrorCode::badField));
  of = smallVolume();
  of.positions[1] = {1, 2, 3};
  EXPECT_TRUE(failedWith(readDicomVolume(folder.put("a.dcm", enhancedFile(of))), ErrorCode::badField));
  of = smallVolume();
  of.positions[1] = {1, std::nan(""), 3};
  EXPECT_TRUE(failedWith(readDicomVolume(folder.put("a.dcm", enhancedFile(of))), ErrorCode::badField));
  of = smallVolume();
  of.orientations = {{1, 0, 0, 0.5, 1, 0}};
  EXPECT_TRUE(failedWith(readDicomVolume(folder.put("a.dcm", enhancedFile(of))), ErrorCode::badField));
  EXPECT_TRUE(failedWith(readDicomVolume(folder.put("a.dcm", cineFile(greyCine()))), ErrorCode::unsupported));
}

class RealDicom : public ::testing::Test {
 protected:
  void SetUp() override { EW_NEEDS_RECORDING("dicom-us"); }
  const std::filesystem::path data = test::recording("dicom-us");
};

TEST_F(RealDicom, TheHalvedCineIsRefusedForItsStaleRegionAndReadWhenThePixelIsGiven) {
  const auto file = data / "examples_ybr_color.dcm";
  const auto summary = inspectDicom(file);
  ASSERT_TRUE(succeeded(summary));
  EXPECT_EQ(summary->frames, 30u);
  EXPECT_EQ(summary->codec, "JPEG");
  ASSERT_EQ(summary->regions.size(), 1u);
  EXPECT_TRUE(says(readDicomCine(file), "made for another size"));
  CineOptions options;
  options.region = 0;
  options.pixel_mm = glm::dvec2(1.021);
  options.colour = ColourRule::keepGrey;
  const auto cine = readDicomCine(file, options);
  ASSERT_TRUE(succeeded(cine));
  EXPECT_EQ(cine->sequence.pixels.size(), 30u * 320u * 240u);
  EXPECT_NEAR(*cine->sequence.frames[29].time_s, 29 * 0.033333, 1e-9);
  EXPECT_GT(std::count_if(cine->sequence.pixels.begin(), cine->sequence.pixels.end(), [](std::uint8_t v) { return v > 40; }), 100000);
}

TEST_F(RealDicom, TheAlokaStillOffersItsTwoImagesByNumber) {
  const auto file = data / "gdcm-US-ALOKA-16.dcm";
  const auto summary = inspectDicom(file);
  ASSERT_TRUE(succeeded(summary));
  EXPECT_EQ(summary->photometric, "PALETTE COLOR");
  ASSERT_EQ(summary->regions.size(), 3u);
  EXPECT_TRUE(says(readDicomCine(file), "2 calibrated images"));
  CineOptions options;
  for (std::size_t n = 0; n < 3; ++n)
    if (summary->regions[n].usable() && summary->regions[n].isBMode()) {
      options.region = static_cast<int>(n) + 1;
      options.colour = ColourRule::keepGrey;
      const auto image = readDicomCine(file, options);
      ASSERT_TRUE(succeeded(image));
      EXPECT_EQ(image->sequence.width, summary->regions[n].rect.width);
      // The height of the region is the depth that the image's description gives.
      EXPECT_GT(image->pixel_mm.y * image->sequence.height, 100.0);
      EXPECT_LT(image->pixel_mm.y * image->sequence.height, 180.0);
    }
}

TEST_F(RealDicom, ThePowerDopplerStillAsksAboutItsColours) {
  const auto file = data / "examples_rgb_color.dcm";
  EXPECT_TRUE(says(readDicomCine(file), "no ultrasound regions"));
  CineOptions options;
  options.region = 0;
  options.pixel_mm = glm::dvec2(0.2);
  EXPECT_TRUE(says(readDicomCine(file, options), "coloured"));
  options.colour = ColourRule::dropColour;
  const auto dropped = readDicomCine(file, options);
  ASSERT_TRUE(succeeded(dropped));
  EXPECT_GT(dropped->colouredShare, 0.005);
  EXPECT_LT(dropped->colouredShare, 0.5);
}

}  // namespace
}  // namespace ew::dicom_test
