#include <gtest/gtest.h>

#include "dicom_files.h"
#include "ew/io/cine_reader.h"
#include "ew/io/dicom.h"

// DICOM as devices and gateways store it: scales and times in other elements than the usual.

namespace ew::foreign_dicom_scale_test {
namespace {
using namespace test;

CineOf smallCine() {
  CineOf cine;
  cine.pixels = ramp(3 * 48);
  return cine;
}

CineOf unscaled(const std::string& extra) {
  CineOf cine = smallCine();
  cine.regions = {};
  cine.extra = extra;
  return cine;
}

TEST(ForeignDicom, PixelSpacingIsUsedWhereNoRegionSaysAnything) {
  const TempFolder folder;
  const auto spaced = [&](const std::string& spacing) {
    return readDicomCine(folder.put("a.dcm", cineFile(unscaled(DicomWriter().text(0x00280030u, "DS", spacing).bytes()))));
  };
  const auto read = spaced("0.4\\0.2");
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->pixel_mm, glm::dvec2(0.2, 0.4)) << "rows first";
  EXPECT_TRUE(contains(read->notes, "that of its Pixel Spacing"));
  const auto commas = spaced("0,4\\0,2");
  ASSERT_TRUE(succeeded(commas));
  EXPECT_EQ(commas->pixel_mm, glm::dvec2(0.2, 0.4));
  EXPECT_TRUE(contains(commas->notes, "written with commas"));
  EXPECT_TRUE(says(spaced("0\\0"), "Pixel Spacing 0\\0"));
  CineOf both = unscaled(DicomWriter().text(0x00280030u, "DS", "9\\9").bytes());
  both.regions = {{}};
  const auto regional = readDicomCine(folder.put("b.dcm", cineFile(both)));
  ASSERT_TRUE(succeeded(regional));
  EXPECT_NEAR(regional->pixel_mm.x, 0.2, 1e-12);
  EXPECT_TRUE(contains(regional->notes, "Pixel Spacing \"9\\9\", which touches sizes"));
}

TEST(ForeignDicom, PixelsAsHighAsWideAreNotOneTimesSo) {
  const TempFolder folder;
  const auto asked = [&](const char* ratio) {
    return readDicomCine(folder.put("a.dcm", cineFile(unscaled(DicomWriter().text(0x00280034u, "IS", ratio).bytes()))));
  };
  EXPECT_TRUE(says(asked("1\\1"), "they are as high as wide"));
  EXPECT_FALSE(says(asked("1\\1"), "1 times"));
  EXPECT_TRUE(says(asked("3\\2"), "they are 1.5 times as high as wide"));
}

TEST(ForeignDicom, HowSeveralImagesLieIsSaidAsItIs) {
  const TempFolder folder;
  const auto asked = [&](const RegionOf& first, const RegionOf& second) {
    CineOf of = smallCine();
    of.regions = {first, second};
    return readDicomCine(folder.put("a.dcm", cineFile(of)));
  };
  EXPECT_TRUE(says(asked({0, 0, 3, 5}, {4, 0, 7, 5, 0.05, 0.05}), "2 calibrated images side by side"));
  EXPECT_TRUE(says(asked({0, 0, 7, 5}, {2, 1, 5, 4, 0.05, 0.05}), "2 calibrated images one inside the other"));
  EXPECT_TRUE(says(asked({0, 0, 7, 2}, {0, 3, 7, 5, 0.05, 0.05}), "2 calibrated images one above the other"));
  EXPECT_TRUE(says(asked({0, 0, 4, 5}, {3, 0, 7, 5, 0.05, 0.05}), "2 calibrated images that overlap"));
}

TEST(ForeignDicom, AnAspectRatioIsNeverLostInSilence) {
  const TempFolder folder;
  const auto file = folder.put("a.dcm", cineFile(unscaled(DicomWriter().text(0x00280034u, "IS", "2\\1").bytes())));
  EXPECT_TRUE(says(readDicomCine(file), "2 times as high as wide"));
  CineOptions square;
  square.pixel_mm = glm::dvec2(0.2);
  const auto given = readDicomCine(file, square);
  ASSERT_TRUE(succeeded(given));
  EXPECT_TRUE(contains(given->notes, "2 times as high as wide; check it"));
  square.pixel_mm = glm::dvec2(0.2, 0.4);
  const auto right = readDicomCine(file, square);
  ASSERT_TRUE(succeeded(right));
  EXPECT_FALSE(contains(right->notes, "as high as wide"));
}

TEST(ForeignDicom, TheSameRegionTwiceIsOne) {
  const TempFolder folder;
  CineOf cine = smallCine();
  cine.regions = {{}, {}};
  const auto read = readDicomCine(folder.put("a.dcm", cineFile(cine)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_NEAR(read->pixel_mm.y, 0.3, 1e-12);
}

TEST(ForeignDicom, ARegionOfAFewPixelsIsAskedAbout) {
  const TempFolder folder;
  CineOf cine = smallCine();
  cine.regions = {{0, 0, 1, 1}};
  const auto file = folder.put("a.dcm", cineFile(cine));
  const auto asked = readDicomCine(file);
  EXPECT_TRUE(failedWith(asked, ErrorCode::unsupported));
  EXPECT_TRUE(says(asked, "Only 8.3 % of the pixels"));
  CineOptions yes;
  yes.acceptsSmall = true;
  EXPECT_TRUE(succeeded(readDicomCine(file, yes)));
}

TEST(ForeignDicom, TimesAreTakenFromWhicheverElementHasThem) {
  const TempFolder folder;
  const auto timed = [&](const DicomWriter& fields) {
    CineOf cine = smallCine();
    cine.frameTime = "";
    std::string set = dataSetOf(cine);
    // In the order of tags: group 8 before the modality's text, group 18 before the regions.
    DicomWriter regions;
    const std::string mark = regions.bytes(std::uint16_t{0x0018}) + regions.bytes(std::uint16_t{0x6011}) + "SQ";
    set.insert(set.find(mark), fields.bytes());
    return readDicomCine(folder.put("a.dcm", dicomFile(kExplicitLittle, set)));
  };
  const auto expectTimes = [&](const Result<Cine>& cine, double second_s, double third_s, const char* name) {
    ASSERT_TRUE(succeeded(cine)) << name;
    ASSERT_TRUE(cine->sequence.frames[2].time_s.has_value()) << name;
    EXPECT_NEAR(*cine->sequence.frames[1].time_s, second_s, 1e-12) << name;
    EXPECT_NEAR(*cine->sequence.frames[2].time_s, third_s, 1e-12) << name;
    EXPECT_TRUE(contains(cine->notes, name)) << name;
  };
  expectTimes(timed(DicomWriter().text(0x00180040u, "IS", "25")), 0.04, 0.08, "Cine Rate");
  expectTimes(timed(DicomWriter().text(0x00082144u, "IS", "25")), 0.04, 0.08, "Recommended Display Frame Rate");
  expectTimes(timed(DicomWriter().text(0x00181242u, "IS", "40")), 0.04, 0.08, "Actual Frame Duration");
  expectTimes(timed(DicomWriter().text(0x00180072u, "DS", "0.12")), 0.04, 0.08, "Effective Duration");
  expectTimes(timed(DicomWriter().text(0x00181065u, "DS", "40\\50")), 0.04, 0.09, "one entry less");
  const auto nothing = timed(DicomWriter().text(0x00180040u, "IS", "0"));
  ASSERT_TRUE(succeeded(nothing));
  EXPECT_FALSE(nothing->sequence.frames[1].time_s.has_value());
  EXPECT_TRUE(contains(nothing->notes, "Cine Rate \"0\"")) << "what was found is shown";
}

TEST(ForeignDicom, FrameTimesOfAnotherUnitAreAskedAbout) {
  const TempFolder folder;
  const auto notes = [&](const char* frameTime) {
    CineOf cine = smallCine();
    cine.frameTime = frameTime;
    const auto read = readDicomCine(folder.put("a.dcm", cineFile(cine)));
    EXPECT_TRUE(succeeded(read)) << frameTime;
    return read ? read->notes : std::vector<Message>();
  };
  EXPECT_TRUE(contains(notes("0.04"),
                       "By Frame Time \"0.04\" the frames are 0.04 ms apart, which is hardly meant; is it given in the unit "
                       "that DICOM has for it?"));
  EXPECT_TRUE(contains(notes("40000"), "the frames are 40000 ms apart, which is hardly meant"));
  for (const char* usual : {"0.5", "40", "10000"}) EXPECT_FALSE(contains(notes(usual), "hardly meant")) << usual;
}

TEST(ForeignDicom, ARateThatContradictsTheTimesIsTold) {
  const TempFolder folder;
  const auto notes = [&](const char* frameTime, const char* rate) {
    CineOf cine = smallCine();
    cine.frameTime = frameTime;
    std::string set = dataSetOf(cine);
    DicomWriter tag;
    const std::string mark = tag.bytes(std::uint16_t{0x0018}) + tag.bytes(std::uint16_t{0x1063}) + "DS";
    set.insert(set.find(mark), DicomWriter().text(0x00180040u, "IS", rate).bytes());
    const auto read = readDicomCine(folder.put("a.dcm", dicomFile(kExplicitLittle, set)));
    EXPECT_TRUE(succeeded(read));
    return read ? read->notes : std::vector<Message>();
  };
  EXPECT_TRUE(contains(notes("40", "50"), "are those of Frame Time \"40\"; another rate is that of Cine Rate \"50\""));
  EXPECT_FALSE(contains(notes("33.33", "30"), "another rate"));
  EXPECT_FALSE(contains(notes("34", "29"), "another rate")) << "rates are whole numbers";
}

TEST(ForeignDicom, TheDurationOfTheAcquisitionGivesTheTimesWhereNothingElseDoes) {
  const TempFolder folder;
  for (const char* syntax : {kExplicitLittle, kImplicitLittle, kExplicitBig}) {
    const auto read = [&](const char* frameTime, double duration_s) {
      CineOf cine = smallCine();
      cine.syntax = syntax;
      cine.frameTime = frameTime;
      cine.extra = DicomWriter(cine.syntax != kImplicitLittle, cine.syntax == kExplicitBig).fd(0x00189073u, {duration_s}).bytes();
      return readDicomCine(folder.put("a.dcm", cineFile(cine)));
    };
    const auto alone = read("", 0.12);
    ASSERT_TRUE(succeeded(alone)) << syntax;
    ASSERT_TRUE(alone->sequence.frames[2].time_s.has_value()) << syntax;
    EXPECT_NEAR(*alone->sequence.frames[1].time_s, 0.04, 1e-12);
    EXPECT_NEAR(*alone->sequence.frames[2].time_s, 0.08, 1e-12);
    EXPECT_TRUE(contains(alone->notes, "The times of the frames are those of Acquisition Duration \"0.12\"."));
    const auto contradicted = read("40", 0.3);
    ASSERT_TRUE(succeeded(contradicted));
    EXPECT_NEAR(*contradicted->sequence.frames[2].time_s, 0.08, 1e-12);
    EXPECT_TRUE(contains(contradicted->notes, "those of Frame Time \"40\"; another rate is that of Acquisition Duration \"0.3\""));
    for (const double near_s : {0.12, 0.125, 0.08}) {  // three frames, or the two steps between them
      const auto agreeing = read("40", near_s);
      ASSERT_TRUE(succeeded(agreeing));
      EXPECT_FALSE(contains(agreeing->notes, "another rate")) << near_s;
    }
    const auto nothing = read("", 0.0);
    ASSERT_TRUE(succeeded(nothing));
    EXPECT_FALSE(nothing->sequence.frames[1].time_s.has_value());
    EXPECT_TRUE(contains(nothing->notes, "Acquisition Duration \"0\"")) << "what was found is shown";
    EXPECT_FALSE(contains(nothing->notes, "commas"));
  }
}

TEST(ForeignDicom, ACommaInAFrameTimeIsAPointAndARateCanBeGiven) {
  const TempFolder folder;
  CineOf cine = smallCine();
  cine.frameTime = "40,5";
  const auto commas = readDicomCine(folder.put("a.dcm", cineFile(cine)));
  ASSERT_TRUE(succeeded(commas));
  EXPECT_NEAR(*commas->sequence.frames[2].time_s, 0.081, 1e-12);
  EXPECT_TRUE(contains(commas->notes, "written with commas"));
  CineOptions rate;
  rate.rate_hz = 50.0;
  const auto given = readDicomCine(folder / "a.dcm", rate);
  ASSERT_TRUE(succeeded(given));
  EXPECT_NEAR(*given->sequence.frames[2].time_s, 0.04, 1e-12);
  EXPECT_TRUE(contains(given->notes, "instead of the 0.081 s"));
}

TEST(ForeignDicom, WhatIsStatedAndNotUsedIsToldAndWhatIsNeutralIsNot) {
  const TempFolder folder;
  CineOf cine = smallCine();
  cine.extra = DicomWriter()
                   .text(0x00281050u, "DS", "60")
                   .text(0x00281051u, "DS", "40")
                   .text(0x00281052u, "DS", "0")
                   .text(0x00281053u, "DS", "2")
                   .bytes();
  const auto told = readDicomCine(folder.put("a.dcm", cineFile(cine)));
  ASSERT_TRUE(succeeded(told));
  EXPECT_TRUE(contains(told->notes, "Window Center \"60\", Window Width \"40\", Rescale Slope \"2\", which touches the grey levels"));
  cine.extra = DicomWriter().text(0x00281050u, "DS", "127.5").text(0x00281051u, "DS", "255").text(0x00281053u, "DS", "1").bytes();
  EXPECT_FALSE(contains(readDicomCine(folder.put("b.dcm", cineFile(cine)))->notes, "touches"));
}

TEST(ForeignDicom, ARecordedScreenTakesTheScaleThatAnImportTakes) {
  const TempFolder folder;
  CineOf cine = smallCine();  // 8 x 6 pixels
  cine.regions = {{0, 0, 7, 5, 0.02, 0.04}};
  const auto file = folder.put("a.dcm", cineFile(cine));
  auto reader = CineReader::open(file);
  ASSERT_TRUE(succeeded(reader));
  EXPECT_NEAR(reader->info().pixelAspect, 0.5, 1e-12);
  ASSERT_EQ(reader->info().scales.size(), 1u);
  EXPECT_EQ(reader->info().scales[0].rect, (PixelRect{0, 0, 8, 12})) << "of square pixels";
  EXPECT_NEAR(reader->info().scales[0].pixel_mm.y, 0.2, 1e-12);
  EXPECT_EQ(reader->info().height_px, 12);
  CineFrame frame;
  ASSERT_TRUE(*reader->next(frame));
  EXPECT_EQ(frame.level.height, 12);
  const auto imported = readDicomCine(file);
  ASSERT_TRUE(succeeded(imported));
  EXPECT_NEAR(imported->pixel_mm.x, reader->info().scales[0].pixel_mm.x, 1e-12);

  auto spaced = CineReader::open(folder.put("b.dcm", cineFile(unscaled(DicomWriter().text(0x00280030u, "DS", "0.3\\0.3").bytes()))));
  ASSERT_TRUE(succeeded(spaced));
  ASSERT_EQ(spaced->info().scales.size(), 1u);
  EXPECT_EQ(spaced->info().scales[0].rect, (PixelRect{0, 0, 8, 6}));
  auto shaped = CineReader::open(folder.put("c.dcm", cineFile(unscaled(DicomWriter().text(0x00280034u, "IS", "1\\2").bytes()))));
  ASSERT_TRUE(succeeded(shaped));
  EXPECT_TRUE(shaped->info().scales.empty());
  EXPECT_EQ(shaped->info().width_px, 16) << "twice as wide as high";
  cine.regions = {{0, 0, 15, 11, 0.02, 0.04}};
  auto stale = CineReader::open(folder.put("d.dcm", cineFile(cine)));
  ASSERT_TRUE(succeeded(stale));
  EXPECT_TRUE(stale->info().scales.empty()) << "made for another size";
}

TEST(ForeignDicom, ATraceIsNamedAsNoScaleWhereItStandsAlone) {
  const TempFolder folder;
  CineOf cine = smallCine();
  const std::string sentence = "Region 1: M-mode, 8 x 6 pixels at (0, 0) (it is no two-dimensional image) was not used for the scale.";
  const RegionOf trace{.units = 4, .format = 2}, scan;
  const auto saysSo = [&](const std::vector<RegionOf>& regions) {
    cine.regions = regions;
    const auto reader = CineReader::open(folder.put("m.dcm", cineFile(cine)));
    EXPECT_TRUE(succeeded(reader));
    return reader && contains(reader->info().notes, sentence.c_str());
  };
  EXPECT_TRUE(saysSo({trace}));
  EXPECT_FALSE(saysSo({trace, scan})) << "it has no scale of a scan to lose";
}

/// One slice of a volume of stills.
}  // namespace
}  // namespace ew::foreign_dicom_scale_test
