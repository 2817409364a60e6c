#include "ew/export/dicom_image.h"

#include <gdcmImageReader.h>

#include <cmath>
#include <numeric>

#include "ew/imaging/caption.h"
#include "ew/io/dicom.h"
#include "ew/scanning/scanner.h"
#include "export_world.h"
#include "scanning/small_scan.h"

namespace ew::dicom_image_test {
namespace {
using namespace test;
namespace fs = std::filesystem;

constexpr glm::ivec2 kSize_px(161, 121);  // odd: the pixels of one image have an odd number of bytes

GreyImage pattern(glm::ivec2 size_px = kSize_px, int seed = 1) {
  GreyImage image(size_px.x, size_px.y);
  for (std::size_t n = 0; n < image.pixels.size(); ++n)
    image.pixels[n] = static_cast<std::uint8_t>((n * 37 + n / 161 * 11) % 251 + static_cast<std::size_t>(seed) % 5);
  return image;
}

RgbImage colours(glm::ivec2 size_px = kSize_px) {
  RgbImage image(size_px.x, size_px.y);
  for (std::size_t n = 0; n < image.pixels.size(); ++n) image.pixels[n] = Rgb(n * 7 % 256, n * 13 % 256, n * 29 % 256);
  return image;
}

template <class ImageType>
ImageType withWords(ImageType image) {
  burnCaption(viewOf(image), kNotForDiagnosis);
  return image;
}

DisplayGeometry someGeometry() {
  DisplayGeometry geometry;
  geometry.width = kSize_px.x;
  geometry.height = kSize_px.y;
  geometry.pixel_mm = 0.4375;
  geometry.face_px = {80.0, -3.3};
  geometry.depth_mm = 50.0;
  return geometry;
}

Still greyStill() { return {pattern(), {regionOf(someGeometry())}}; }

DicomImageOptions someOptions(std::uint64_t uid = 9) {
  DicomImageOptions options = imageOptions(smallProbe(), {}, someGeometry(), 3, someStudy().begun);
  options.instanceUid = dicomUidOf(2, uid);
  return options;
}

std::vector<char> pixelsByGdcm(const fs::path& file, std::string& photometric) {
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) return {};
  std::vector<char> bytes(reader.GetImage().GetBufferLength());
  photometric = reader.GetImage().GetPhotometricInterpretation().GetString();
  return reader.GetImage().GetBuffer(bytes.data()) ? bytes : std::vector<char>{};
}

template <class ImageType>
std::vector<char> bytesOf(const ImageType& image) {
  const auto* const begin = reinterpret_cast<const char*>(image.pixels.data());
  return {begin, begin + image.pixels.size() * sizeof(image.pixels.front())};
}

/// What dciodvfy and dcmdump have to say against a file; empty: nothing, or they are not installed.
std::string faultsIn(const fs::path& file) {
  std::string faults;
  if (hasProgram("dciodvfy")) {
    std::istringstream lines(said("dciodvfy " + file.string()).text);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("Error")) faults += line + "\n";
  }
  if (hasProgram("dcmdump")) {
    const Said dump = said("dcmdump +E " + file.string());
    std::istringstream lines(dump.text);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("W:") || line.starts_with("E:")) faults += line + "\n";
    if (dump.status != 0) faults += "dcmdump failed\n";
  }
  return faults;
}

TEST(DicomImage, GreyPixelsComeBackWithTheWordsAndTheSizeOfAPixel) {
  const TemporaryFolder folder;
  const auto written = writeDicomImage(greyStill(), someOptions(), someStudy(), folder / "a.dcm");
  ASSERT_TRUE(succeeded(written));
  EXPECT_EQ(*written, (DicomReference{kUsImageClass, dicomUidOf(2, 9)}));
  const auto cine = readDicomCine(folder / "a.dcm");
  ASSERT_TRUE(succeeded(cine));
  EXPECT_EQ(cine->sequence.pixels, withWords(pattern()).pixels);
  EXPECT_EQ(cine->sequence.width, kSize_px.x);
  EXPECT_EQ(cine->sequence.height, kSize_px.y);
  EXPECT_DOUBLE_EQ(cine->pixel_mm.x, 0.4375);
  EXPECT_DOUBLE_EQ(cine->pixel_mm.y, 0.4375);
  EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"a.dcm"});
}

TEST(DicomImage, SaysThatWordsAreBurntIn) {
  const TemporaryFolder folder;
  ASSERT_TRUE(succeeded(writeDicomImage(greyStill(), someOptions(), someStudy(), folder / "a.dcm")));
  gdcm::Reader reader;
  reader.SetFileName((folder / "a.dcm").c_str());
  ASSERT_TRUE(reader.Read());
  const auto* said = reader.GetFile().GetDataSet().GetDataElement(gdcm::Tag(0x0028, 0x0301)).GetByteValue();
  ASSERT_NE(said, nullptr);
  EXPECT_EQ(std::string(said->GetPointer(), 3), "YES");
}

TEST(DicomImage, ARegionGivesTheMillimetresOfTheProbeForEveryPixel) {
  const TemporaryFolder folder;
  ASSERT_TRUE(succeeded(writeDicomImage(greyStill(), someOptions(), someStudy(), folder / "a.dcm")));
  const auto summary = inspectDicom(folder / "a.dcm");
  ASSERT_TRUE(succeeded(summary));
  ASSERT_EQ(summary->regions.size(), 1u);
  const UltrasoundRegion& region = summary->regions.front();
  EXPECT_TRUE(region.isBMode());
  EXPECT_TRUE(region.usable()) << region.problem;
  EXPECT_EQ(region.rect, (PixelRect{0, 0, kSize_px.x, kSize_px.y}));
  ASSERT_TRUE(region.referencePixel.has_value());
  const DisplayGeometry geometry = someGeometry();
  for (const glm::ivec2 p : {glm::ivec2(0, 0), glm::ivec2(160, 120), glm::ivec2(17, 93)}) {
    const glm::dvec2 found_mm = 10.0 * region.referenceValue + (glm::dvec2(p) - *region.referencePixel) * region.pixel_mm();
    const glm::dvec2 true_mm = geometry.probePoint_mm(p.x, p.y) * glm::dvec2(geometry.markerLeft ? -1.0 : 1.0, 1.0);
    EXPECT_NEAR(found_mm.x, true_mm.x, 1e-9);
    EXPECT_NEAR(found_mm.y, true_mm.y, 1e-9);
  }
}

TEST(DicomImage, ColoursComeBackAsTheyAre) {
  const TemporaryFolder folder;
  const Still still{colours(), {regionOf(someGeometry())}};
  ASSERT_TRUE(succeeded(writeDicomImage(still, someOptions(), someStudy(), folder / "a.dcm")));
  std::string photometric;
  EXPECT_EQ(pixelsByGdcm(folder / "a.dcm", photometric), bytesOf(withWords(colours())));
  EXPECT_EQ(photometric, "RGB ");
  EXPECT_EQ(faultsIn(folder / "a.dcm"), "");
}

TEST(DicomImage, OtherReadersSeeTheSameGreyPixelsAndFindNoFault) {
  const TemporaryFolder folder;
  ASSERT_TRUE(succeeded(writeDicomImage(greyStill(), someOptions(), someStudy(), folder / "a.dcm")));
  std::string photometric;
  EXPECT_EQ(pixelsByGdcm(folder / "a.dcm", photometric), bytesOf(withWords(pattern())));
  EXPECT_EQ(photometric, "MONOCHROME2 ");
  EXPECT_EQ(faultsIn(folder / "a.dcm"), "");
}

TEST(DicomImage, SaysWhoTheInventedPatientIsAndThatItIsASimulation) {
  EW_NEEDS_PROGRAM("dcmdump");
  const TemporaryFolder folder;
  ASSERT_TRUE(succeeded(writeDicomImage(greyStill(), someOptions(), someStudy(), folder / "a.dcm")));
  const std::string dump = said("dcmdump +U8 " + (folder / "a.dcm").string()).text;
  for (const char* part :
       {"(0010,0010) PN [Ödland^Änne von der]", "(0010,0020) LO [EWSIM-test]", "(0010,0040) CS [F]", "(0010,1010) AS [029Y]",
        "(0008,0005) CS [ISO_IR 192]", "(0020,4000) LT [Simulation, not for diagnosis.", "(0010,4000) LT [Invented patient",
        "(0028,0300) CS [YES]", "(0028,0301) CS [YES]", "(0008,2111) ST [Simulated", "(0008,0020) DA [20261125]", "(0008,0030) TM [070005]",
        "(0018,6031) CS [LINEAR]", "(0018,5050) IS [50]", "(0020,0013) IS [3]"})
    EXPECT_NE(dump.find(part), std::string::npos) << part << "\n" << dump;
}

TEST(DicomImage, OfMModeHasASecondRegionInSecondsAndCentimetres) {
  const TemporaryFolder folder;
  const GreyImage below = pattern(kSize_px, 3);
  const GreyImage image = pattern();
  const DisplayGeometry geometry = someGeometry();
  Knobs knobs;
  knobs.mode = DisplayMode::both;
  knobs.mSweep_s = 3.22;
  const Still still = stillOf({.grey = viewOf(image)}, viewOf(below), geometry, {}, knobs);
  EXPECT_EQ(still.size_px(), glm::ivec2(161, 242));
  ASSERT_TRUE(succeeded(writeDicomImage(still, someOptions(), someStudy(), folder / "a.dcm")));
  EXPECT_EQ(faultsIn(folder / "a.dcm"), "");
  const auto summary = inspectDicom(folder / "a.dcm");
  ASSERT_TRUE(succeeded(summary));
  ASSERT_EQ(summary->regions.size(), 2u);
  const UltrasoundRegion& strip = summary->regions[1];
  EXPECT_EQ(strip.spatialFormat, 2);
  EXPECT_EQ(strip.unitsX, 4);
  EXPECT_EQ(strip.unitsY, 3);
  EXPECT_EQ(strip.rect, (PixelRect{0, 121, 161, 121}));
  EXPECT_NEAR(strip.deltaX * 161.0, 3.22, 1e-12);
  EXPECT_NEAR(strip.deltaY * 121.0, 5.0, 1e-12);
  EXPECT_NEAR(strip.referenceValue.y, 0.5 * 5.0 / 121.0, 1e-12);
  // The image alone is what our reader takes: the one calibrated region of two axes in cm.
  const auto cine = readDicomCine(folder / "a.dcm");
  ASSERT_TRUE(succeeded(cine));
  EXPECT_EQ(cine->sequence.pixels, image.pixels);

  knobs.mode = DisplayMode::mMode;
  const Still alone = stillOf({.grey = viewOf(image)}, viewOf(below), geometry, {}, knobs);
  EXPECT_EQ(std::get<GreyImage>(alone.pixels), below);
  ASSERT_EQ(alone.regions.size(), 1u);
  EXPECT_EQ(alone.regions.front().kind, RegionCalibration::Kind::strip);
  knobs.mode = DisplayMode::bMode;
  EXPECT_EQ(std::get<GreyImage>(stillOf({.grey = viewOf(image)}, viewOf(below), geometry, {}, knobs).pixels), image);
}

TEST(DicomImage, OfDopplerHasRegionsOfColourAndSpectrumBehindTheTissue) {
  const TemporaryFolder folder;
  Probe probe = smallProbe();
  Knobs knobs;
  knobs.mode = DisplayMode::spectrum;
  knobs.mSweep_s = 3.22;
  knobs.colour = ColourDoppler{.boxMiddle = 0.2, .boxWidth = 0.4};
  knobs.spectral = SpectralDoppler{.angle_rad = 1.0471975511965976, .prf_hz = 4000.0, .baseline = 0.3};
  const DisplayGeometry geometry = fitDisplay(probe, knobs, kSize_px.x, kSize_px.y);
  const GreyImage image = pattern(), below = pattern(kSize_px, 3);
  Image<Rgba> colours(kSize_px.x, kSize_px.y, Rgba(0));
  viewOf(colours).at(80, 60) = {200, 20, 0, 255};
  const Still still = stillOf({viewOf(image), viewOf(std::as_const(colours))}, viewOf(below), geometry, probe, knobs);
  ASSERT_EQ(still.regions.size(), 3u);
  EXPECT_EQ(still.regions[0].kind, RegionCalibration::Kind::image);
  ASSERT_TRUE(succeeded(writeDicomImage(still, imageOptions(probe, knobs, geometry, 1, someStudy().begun), someStudy(), folder / "a.dcm")));
  EXPECT_EQ(faultsIn(folder / "a.dcm"), "");
  const auto summary = inspectDicom(folder / "a.dcm");
  ASSERT_TRUE(succeeded(summary));
  ASSERT_EQ(summary->regions.size(), 3u);
  const UltrasoundRegion &colour = summary->regions[1], &spectrum = summary->regions[2];
  EXPECT_EQ(colour.spatialFormat, 1);
  EXPECT_EQ(colour.dataType, 2);
  EXPECT_EQ(colour.unitsX, 3);
  EXPECT_EQ(colour.unitsY, 3);
  // A pixel of the box lies where the image says it does.
  const glm::dvec2 inBox_mm = 10.0 * colour.referenceValue - *colour.referencePixel * colour.pixel_mm();
  const glm::dvec2 true_mm = geometry.probePoint_mm(colour.rect.x, colour.rect.y) * glm::dvec2(geometry.markerLeft ? -1.0 : 1.0, 1.0);
  EXPECT_NEAR(inBox_mm.x, true_mm.x, 1e-9);
  EXPECT_NEAR(inBox_mm.y, true_mm.y, 1e-9);
  EXPECT_EQ(spectrum.spatialFormat, 3);
  EXPECT_EQ(spectrum.dataType, 3);
  EXPECT_EQ(spectrum.unitsX, 4);
  EXPECT_EQ(spectrum.unitsY, 7);
  EXPECT_EQ(spectrum.rect, (PixelRect{0, kSize_px.y, kSize_px.x, kSize_px.y}));
  EXPECT_NEAR(spectrum.deltaX * kSize_px.x, 3.22, 1e-12);
  // Twice the velocity along the line, since the angle is 60 degrees; velocities rise up the rows, which our reader of lengths does not
  // say.
  const SpectralGate gate = spectralGateOf(probe, knobs);
  const RegionCalibration& written = still.regions[2];
  EXPECT_LT(written.delta.y, 0.0);
  EXPECT_NEAR(written.referenceValue.y + (-0.5 - written.reference_px.y) * written.delta.y, 1.3 * 2.0 * gate.nyquist_mmPerS / 10.0, 1e-9);
  EXPECT_NEAR(std::abs(spectrum.deltaY) * kSize_px.y, 2.0 * 2.0 * gate.nyquist_mmPerS / 10.0, 1e-9);
  // A second program reads the units and how Doppler was set.
  EW_NEEDS_PROGRAM("dcmdump");
  const std::string dump = said("dcmdump " + (folder / "a.dcm").string()).text;
  for (const char* part : {"(0018,6024) US 4", "(0018,6026) US 7", "(0018,6012) US 3", "(0018,6032) UL 4000", "(0018,6034) FD 59.99",
                           "(0018,602e) FD -", "(0008,0008) CS [DERIVED\\PRIMARY\\\\0019]"})
    EXPECT_NE(dump.find(part), std::string::npos) << part << "\n" << dump;
}

TEST(DicomImage, OfAScanGivesTheSameMillimetresAsTheScanner) {
  const TemporaryFolder folder;
  Scanner scanner;
  scanner.show(waveSubject());
  for (const bool markerLeft : {true, false})
    for (const double zoom : {1.0, 2.5}) {
      ScanState state;
      state.probe = smallProbe();
      state.knobs.markerLeft = markerLeft;
      state.knobs.zoom = zoom;
      const DisplayImage image = scanner.make(state, 320, 240);
      const DisplayGeometry& geometry = scanner.geometry();
      const Still still = stillOf(image, scanner.strip(), geometry, state.probe, state.knobs);
      ASSERT_TRUE(succeeded(
          writeDicomImage(still, imageOptions(state.probe, state.knobs, geometry, 1, someStudy().begun), someStudy(), folder / "a.dcm")));
      const auto cine = readDicomCine(folder / "a.dcm");
      ASSERT_TRUE(succeeded(cine));
      EXPECT_EQ(cine->sequence.pixels, withWords(copyOf(image.grey)).pixels);
      // Two pixels lie as far apart in the file as in the plane of the probe.
      const glm::dvec2 found_mm = glm::dvec2(200 - 31, 190 - 12) * cine->pixel_mm;
      EXPECT_NEAR(glm::length(found_mm), glm::distance(geometry.probePoint_mm(31, 12), geometry.probePoint_mm(200, 190)), 1e-9);
    }
}

TEST(DicomClip, HasTheTimeOfEachFrameToTheMicrosecondAndEveryPixel) {
  const TemporaryFolder folder;
  DicomClip clip;
  clip.size_px = kSize_px;
  clip.regions = {regionOf(someGeometry())};
  for (int n = 0; n < 30; ++n) clip.times_s.push_back(1000.0 + n / 29.97 + 0.001 * std::sin(n));
  clip.still = [](std::size_t n) -> Result<Still> { return Still{pattern(kSize_px, static_cast<int>(n)), {}}; };
  const auto written = writeDicomClip(clip, someOptions(), someStudy(), folder / "a.dcm");
  ASSERT_TRUE(succeeded(written));
  EXPECT_EQ(written->classUid, kUsMultiframeClass);
  EXPECT_EQ(faultsIn(folder / "a.dcm"), "");
  const auto cine = readDicomCine(folder / "a.dcm");
  ASSERT_TRUE(succeeded(cine));
  ASSERT_EQ(cine->sequence.frames.size(), 30u);
  std::vector<std::uint8_t> all;
  for (std::size_t n = 0; n < 30; ++n) {
    EXPECT_NEAR(*cine->sequence.frames[n].time_s - *cine->sequence.frames[0].time_s, clip.times_s[n] - clip.times_s[0], 0.51e-6) << n;
    const GreyImage marked = withWords(pattern(kSize_px, static_cast<int>(n)));
    all.insert(all.end(), marked.pixels.begin(), marked.pixels.end());
  }
  EXPECT_EQ(cine->sequence.pixels, all);
  EXPECT_DOUBLE_EQ(cine->pixel_mm.x, 0.4375);
}

TEST(DicomClip, OfColoursTakesGreyStillsToo) {
  const TemporaryFolder folder;
  DicomClip clip;
  clip.size_px = kSize_px;
  clip.isColour = true;
  clip.times_s = {0.0, 0.04};
  clip.still = [](std::size_t n) -> Result<Still> {
    return n == 0 ? Still{colours(), {}} : Still{GreyImage(kSize_px.x, kSize_px.y, 77), {}};
  };
  ASSERT_TRUE(succeeded(writeDicomClip(clip, someOptions(), someStudy(), folder / "a.dcm")));
  std::vector<char> expected = bytesOf(withWords(colours()));
  const std::vector<char> second = bytesOf(withWords(RgbImage(kSize_px.x, kSize_px.y, Rgb(77))));
  expected.insert(expected.end(), second.begin(), second.end());
  std::string photometric;
  EXPECT_EQ(pixelsByGdcm(folder / "a.dcm", photometric), expected);
  EXPECT_EQ(faultsIn(folder / "a.dcm"), "");
}

TEST(DicomClip, ThatCannotBeFinishedLeavesNothing) {
  const TemporaryFolder folder;
  DicomClip clip;
  clip.size_px = kSize_px;
  clip.times_s = {0.0, 0.04, 0.08};
  clip.still = [](std::size_t n) -> Result<Still> { return Still{pattern(n == 2 ? glm::ivec2(120, 121) : kSize_px), {}}; };
  const auto otherSize = writeDicomClip(clip, someOptions(), someStudy(), folder / "a.dcm");
  ASSERT_FALSE(otherSize);
  EXPECT_NE(otherSize.error().sentence().find("Image 3"), std::string::npos) << otherSize.error();
  clip.still = [](std::size_t n) -> Result<Still> {
    if (n == 1) return failure(ErrorCode::notReadable, say<"The recording ends here.">());
    return Still{pattern(), {}};
  };
  const auto broken = writeDicomClip(clip, someOptions(), someStudy(), folder / "a.dcm");
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().sentence(), "The recording ends here.");
  clip.still = [](std::size_t) -> Result<Still> { return Still{colours(), {}}; };
  EXPECT_FALSE(writeDicomClip(clip, someOptions(), someStudy(), folder / "a.dcm"));
  EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{});
}

TEST(DicomImage, ThatNobodyCouldUseIsRefusedWithASentence) {
  const TemporaryFolder folder;
  const auto refused = [&](const Still& still, const DicomImageOptions& options, const DicomStudy& study) {
    const auto written = writeDicomImage(still, options, study, folder / "a.dcm");
    return written ? std::string("written") : written.error().sentence();
  };
  EXPECT_NE(refused({GreyImage(60, 40), {}}, someOptions(), someStudy()).find("too small for the words"), std::string::npos);
  EXPECT_NE(refused({GreyImage(65536, 64), {}}, someOptions(), someStudy()).find("larger than DICOM allows"), std::string::npos);
  DicomImageOptions nameless = someOptions();
  nameless.instanceUid.clear();
  EXPECT_NE(refused(greyStill(), nameless, someStudy()).find("no unique identifier"), std::string::npos);
  DicomStudy without = someStudy();
  without.studyUid = "1..2";
  EXPECT_NE(refused(greyStill(), someOptions(), without).find("'1..2'"), std::string::npos);
  Still unsized = greyStill();
  unsized.regions.front().delta.x = 0.0;
  EXPECT_NE(refused(unsized, someOptions(), someStudy()).find("no size of a pixel"), std::string::npos);

  DicomClip clip;
  clip.size_px = kSize_px;
  clip.still = [](std::size_t) -> Result<Still> { return Still{pattern(), {}}; };
  const auto refusedClip = [&](std::vector<double> times_s) {
    clip.times_s = std::move(times_s);
    const auto written = writeDicomClip(clip, someOptions(), someStudy(), folder / "a.dcm");
    return written ? std::string("written") : written.error().sentence();
  };
  EXPECT_NE(refusedClip({}).find("without an image"), std::string::npos);
  EXPECT_NE(refusedClip({0.1, 0.0}).find("do not rise"), std::string::npos);
  EXPECT_NE(refusedClip({0.1, NAN}).find("do not rise"), std::string::npos);
  EXPECT_NE(refusedClip(std::vector<double>(8001, 0.0)).find("8001 images"), std::string::npos);
  EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{});
}

TEST(DicomImage, TextsThatDoNotFitAreCutAtWholeLetters) {
  const TemporaryFolder folder;
  DicomStudy study = someStudy();
  study.title = std::string(80, 'x') + "\\";
  for (int n = 0; n < 80; ++n) study.patient.id += "ü";
  study.patient.name = "A\\B\n^=" + std::string(90, 'n');
  ASSERT_TRUE(succeeded(writeDicomImage(greyStill(), someOptions(), study, folder / "a.dcm")));
  EXPECT_EQ(faultsIn(folder / "a.dcm"), "");
}

}  // namespace
}  // namespace ew::dicom_image_test
