#include "ew/library/file_import.h"

#include <gtest/gtest.h>

#include "io/dicom_files.h"
#include "io/kretz_files.h"
#include "io/open_files_limit.h"

namespace ew::file_import_test {
namespace {
using namespace test;

TEST(ImportFile, EachKindIsKnownByItsContentAndAsksForWhatIsMissing) {
  const TempFolder folder;
  CineOf cine;
  cine.pixels = ramp(144);
  EnhancedOf enhanced;
  enhanced.pixels = ramp(60);
  KretzOf kretz;
  kretz.fill([](double, double, double) { return 50.0; });
  struct Case {
    const char* name;
    std::string bytes;
    FileKind kind;
    const char* asks;
  };
  cine.regions = {};
  const std::string unregioned = cineFile(cine);
  std::string withTiffBefore = unregioned;  // in the bytes that every DICOM file leaves free
  withTiffBefore.replace(0, 4, std::string("II*\0", 4));
  for (const auto& [name, bytes, kind, asks] :
       {Case{"both.dcm", withTiffBefore, FileKind::dicomImages, "pixel-mm"},
        Case{"film.raw", "RIFF" + ramp(4) + "AVI LIST" + ramp(100), FileKind::film, "screen"},
        Case{"stack.tif", std::string("II*\0", 4) + ramp(100), FileKind::film, "screen"},
        Case{"a.dcm", unregioned, FileKind::dicomImages, "pixel-mm"}, Case{"no-ending", enhancedFile(enhanced), FileKind::dicomVolume, ""},
        Case{"k.vol", kretzFile(kretz), FileKind::kretz, ""}, Case{"x.bin", ramp(100), FileKind::raw, "raw"},
        Case{"p1.pgm", "P5\n2 2\n255\n" + ramp(4), FileKind::images, "spacing"},
        Case{"v.mha", "ObjectType = Image\nNDims = 3\nDimSize = 2 2 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + ramp(4),
             FileKind::volume, "spacing"}}) {
    const auto file = folder.put(name, bytes);
    const auto found = kindOfFile(file);
    ASSERT_TRUE(succeeded(found)) << name;
    EXPECT_EQ(*found, kind) << name;
    const auto made = importFile(file, {});
    EXPECT_EQ(made.has_value(), std::string(asks).empty()) << name;
    if (made) {
      EXPECT_TRUE(!made->notes.empty()) << "every result names its convention";
    } else {
      EXPECT_EQ(askedFor(made.error()), asks) << made.error();
    }
  }
  EXPECT_TRUE(failedWith(kindOfFile(folder / "nowhere"), ErrorCode::notFound));
}

TEST(ImportFile, AFolderIsImagesOrDicomStillsAndHalfAVolumeSaysSo) {
  const TempFolder folder;
  CineOf still;
  still.frames = 1;
  still.pixels = ramp(48);
  static_cast<void>(folder.put("I0001", cineFile(still)));
  const auto kind = kindOfFile(folder.path());
  ASSERT_TRUE(succeeded(kind));
  EXPECT_EQ(*kind, FileKind::dicomStack);
  EXPECT_TRUE(says(importFile(folder.path(), {}), "do not say where they lie"));
  static_cast<void>(folder.put("p1.pgm", "P5\n2 2\n255\n" + ramp(4)));
  const auto both = kindOfFile(folder.path());
  EXPECT_TRUE(failedWith(both, ErrorCode::unsupported));
  EXPECT_TRUE(says(both, "images (.png, .jpg, .pgm: 1) and DICOM files (1)"));

  const TempFolder pair;
  const auto header = pair.put("brain.hdr", std::string("\x5C\x01\0\0", 4) + std::string(344, '\0'));
  const auto image = pair.put("brain.img", ramp(100));
  EXPECT_TRUE(says(kindOfFile(header), "two files of an Analyze or NIfTI volume"));
  EXPECT_TRUE(says(kindOfFile(image), "two files of an Analyze or NIfTI volume"));
  EXPECT_TRUE(succeeded(kindOfFile(pair.put("disk.img", ramp(64)))));
}

TEST(ImportFile, KindsOfOtherProgramsAndTextsAreNamedAndOnlySamplesAreAskedAbout) {
  const TempFolder folder;
  struct Case {
    const char* name;
    std::string bytes;
    std::vector<const char*> says;
  };
  const std::string samples = ramp(200);
  for (const auto& [name, bytes, words] :
       {Case{"brain.mgz", "\x1F\x8B" + samples, {"a volume of FreeSurfer", "mri_convert"}},
        Case{"brain.MGH", std::string("\0\0\0\1", 4) + samples, {"a volume of FreeSurfer"}},
        Case{"sweep.imf", samples, {"ImFusion", ".mha, .nii or DICOM"}}, Case{"a.mat", samples, {"MATLAB"}},
        Case{"a.dat", "MATLAB 5.0 MAT-file" + samples, {"MATLAB"}}, Case{"a.h5", "\x89HDF\r\n\x1A\n" + samples, {"HDF5"}},
        Case{"a.vtk", "# vtk DataFile Version 3.0\n" + samples, {"a file of VTK"}},
        Case{"a", "PK\x03\x04" + samples, {"a packed file", "unpack it"}}, Case{"a.bmp", "BM" + samples, {"an image", ".png"}},
        Case{"v.volume", "NRRD0004\ntype: uchar\n", {"under another ending", ".nrrd"}},
        Case{"notes.md", "# Notes\n\nof the scan, f\xC3\xBCr alle\n", {"a text file"}},
        Case{"poses.txt", "1 0 0 0\r\n0 1 0 0\r\n", {"a text file"}},
        Case{"device.xml", "<PlusConfiguration>\n</PlusConfiguration>\n", {"a text file"}}, Case{"empty.bin", "", {"is empty"}},
        Case{"tiny.bin", std::string("\0\1\2", 3), {"too small for a volume"}}}) {
    const auto file = folder.put(name, bytes);
    const auto read = importFile(file, {});
    ASSERT_FALSE(read.has_value()) << name;
    EXPECT_EQ(askedFor(read.error()), "") << read.error();
    EXPECT_TRUE(read.error().sentence().ends_with('.')) << read.error();
    for (const char* word : words) EXPECT_TRUE(says(read, word)) << name;
  }
  // A long text may end within a letter where the look at it ends; samples may be letters alone.
  EXPECT_TRUE(says(kindOfFile(folder.put("long.txt", "\n" + std::string(65534, 'a') + "\xC3\xBC more\n")), "a text file"));
  for (const std::string& bytes : {ramp(100), std::string(512, 'v'), "\n" + std::string(100, '\xFF'), std::string(70000, '\0')}) {
    const auto kind = kindOfFile(folder.put("samples.bin", bytes));
    ASSERT_TRUE(succeeded(kind)) << bytes.size();
    EXPECT_EQ(*kind, FileKind::raw);
  }
  // Whoever knows better says so.
  ImportAnswers given;
  given.raw = RawLayout{.dims = {10, 10, 2}, .spacing_mm = glm::dvec3(1.0)};
  EXPECT_TRUE(succeeded(importFile(folder.put("mine.imf", samples), given)));
}

TEST(ImportFile, AFileUnderAWrongEndingIsNamedWithTheRightOne) {
  const TempFolder folder;
  const std::string nrrd = "NRRD0004\ntype: uchar\n\n", meta = "ObjectType = Image\nNDims = 3\n";
  const std::string nifti = std::string("\x5C\1\0\0", 4) + std::string(340, '\0') + std::string("n+1\0", 4) + ramp(8);
  const std::string dicom = cineFile(CineOf{});
  const std::string film = std::string("\0\0\0\x18", 4) + "ftypisom" + ramp(300);
  const std::string packet = "\x47" + std::string(187, '\0'), packets = packet + packet + packet;
  struct Case {
    const char* name;
    std::string bytes;
    const char* says;
  };
  for (const auto& [name, bytes, words] :
       {Case{"a.mha", nrrd, "\"a.mha\" is a NRRD file under another ending; let its name end in .nrrd."},
        Case{"b.mha", nifti, "\"b.mha\" is a NIfTI volume under another ending; let its name end in .nii."},
        Case{"c.MHA", dicom, "\"c.MHA\" is a DICOM file under another ending; let its name end in .dcm."},
        Case{"d.mha", film, "\"d.mha\" is a film under another ending; let its name end in .mp4."},
        Case{"n.mha", std::string("\0\0\x2\0", 4) + "moov" + ramp(300),
             "\"n.mha\" is a film under another ending; let its name end in .mov."},
        Case{"o.png", std::string("\0\0\1\xBA", 4) + ramp(300), "\"o.png\" is a film under another ending; let its name end in .mpg."},
        Case{"p.nrrd", "\x30\x26\xB2\x75\x8E\x66\xCF\x11" + ramp(300),
             "\"p.nrrd\" is a film under another ending; let its name end in .wmv."},
        Case{"q.jpg", packets, "\"q.jpg\" is a film under another ending; let its name end in .ts."},
        Case{"e.nrrd", meta, "\"e.nrrd\" is a MetaImage under another ending; let its name end in .mha."},
        Case{"f.nii", meta, "\"f.nii\" is a MetaImage under another ending; let its name end in .mha."},
        Case{"g.nrrd", "\x1F\x8B" + ramp(300), "\"g.nrrd\" is a packed file (gzip) under another ending; let its name end in .nii.gz."},
        Case{"h.jpg", dicom, "\"h.jpg\" is a DICOM file under another ending; let its name end in .dcm."},
        Case{"i.png", "\xFF\xD8\xFF" + ramp(300), "\"i.png\" is a JPEG image under another ending; let its name end in .jpg."},
        Case{"j.mha", "", "\"j.mha\" is empty; get the file again."}, Case{"k.nrrd", "", "\"k.nrrd\" is empty; get the file again."},
        Case{"l.dat", nifti, "'l.dat' is a NIfTI volume under another ending, which is not read; let its name end in .nii."},
        Case{"m.dat", "\xFF\xD8\xFF" + ramp(300),
             "'m.dat' is a JPEG image under another ending, which is not read; let its name end in .jpg."}}) {
    const auto read = importFile(folder.put(name, bytes), {});
    ASSERT_FALSE(read.has_value()) << name;
    EXPECT_EQ(read.error().sentence(), words);
    std::filesystem::remove(folder / name);
  }
}

TEST(ImportFile, WithTooManyOpenFilesNoKindIsGuessed) {
  if (kSanitizerOpensFiles) GTEST_SKIP() << "the sanitizer needs files of its own";
  const TempFolder folder;
  const auto samples = folder.put("x.bin", ramp(100));
  const auto ofFile = [&] {
    const NoMoreOpenFiles none;
    return kindOfFile(samples);
  }();
  const auto ofFolder = [&] {
    const NoMoreOpenFiles none;
    return kindOfFile(folder.path());
  }();
  for (const auto& kind : {ofFile, ofFolder}) {
    EXPECT_TRUE(failedWith(kind, ErrorCode::notReadable));
    EXPECT_TRUE(says(kind, "too many files are open at the moment"));
  }
  EXPECT_TRUE(succeeded(kindOfFile(samples)));
}

TEST(ImportFile, VolumesWovenIntoEachOtherAndUnknownUnitsAreAskedAbout) {
  const TempFolder folder;
  const std::string start = "NRRD0005\ntype: uchar\nencoding: raw\n";
  const auto woven = folder.put("t.nrrd", start +
                                              "dimension: 4\nsizes: 3 2 2 1\nkinds: list domain domain domain\n"
                                              "space directions: none (0.5,0,0) (0,0.5,0) (0,0,0.5)\n\n" +
                                              ramp(12));
  const auto asked = importFile(woven, {});
  ASSERT_FALSE(asked.has_value());
  EXPECT_EQ(askedFor(asked.error()), "time-step");
  ImportAnswers third;
  third.timeStep = 3;
  const auto volume = importFile(woven, third);
  ASSERT_TRUE(succeeded(volume));
  EXPECT_EQ(volume->volume->echo, (std::vector<std::uint8_t>{2, 5, 8, 11}));
  const auto odd =
      importFile(folder.put("u.nrrd", start +
                                          "dimension: 3\nsizes: 2 2 1\nspace: LPS\nspace units: \"cubit\" \"cubit\" \"cubit\"\n"
                                          "space directions: (2,0,0) (0,2,0) (0,0,2)\n\n" +
                                          ramp(4)),
                 {});
  ASSERT_FALSE(odd.has_value());
  EXPECT_EQ(askedFor(odd.error()), "spacing");
  EXPECT_TRUE(says(odd, "\"cubit\""));
}

TEST(VolumeOf, AsksForTheSpacingByTheCauseThatImportingNames) {
  const TempFolder folder;
  const std::string meta = "ObjectType = Image\nNDims = 3\nDimSize = 2 2 1\n", data = "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  for (const auto& [file, cause] :
       {std::pair(folder.put("u.nrrd",
                             "NRRD0005\ntype: uchar\nencoding: raw\ndimension: 3\nsizes: 2 2 1\nspace: LPS\n"
                             "space units: \"cubit\" \"cubit\" \"cubit\"\nspace directions: (2,0,0) (0,2,0) (0,0,2)\n\n" +
                                 ramp(4)),
                  "\"cubit\""),
        std::pair(folder.put("u.mha", meta + "ElementSpacing = 2 2 2\nDistanceUnits = cubit\n" + data + ramp(4)), "\"cubit\""),
        std::pair(folder.put("v.mha", meta + data + ramp(4)), "says 1 x 1 x 1 mm")}) {
    const auto looked = volumeOf(file, {});
    ASSERT_FALSE(looked.has_value()) << file;
    EXPECT_EQ(askedFor(looked.error()), "spacing");
    EXPECT_TRUE(says(looked, cause));
    const auto imported = importFile(file, {});
    ASSERT_FALSE(imported.has_value()) << file;
    EXPECT_EQ(looked.error().sentence(), imported.error().sentence());
    ImportAnswers answers;
    answers.spacing_mm = glm::dvec3(0.5);
    EXPECT_TRUE(succeeded(volumeOf(file, answers))) << file;
  }
}

TEST(ImportFile, ASpacingThatIsNotStatedAlongAnAxisIsAskedFor) {
  const TempFolder folder;
  const std::string nrrd = "NRRD0005\ntype: uchar\nencoding: raw\ndimension: 3\nsizes: 2 2 2\n";
  const std::string meta = "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n", data = "ElementDataFile = LOCAL\n";
  for (const auto& [file, cause] :
       {std::pair(folder.put("a.nrrd", nrrd + "spacings: 0.5 0.5 nan\n\n" + ramp(8)), "no spacing along its axis 3"),
        std::pair(folder.put("b.nrrd", nrrd + "spacings: nan 0.5 nan\n\n" + ramp(8)), "no spacing along its axes 1 and 3"),
        std::pair(folder.put("c.nrrd", nrrd + "space: LPS\nspace directions: (0.5,0,0) (0,0.5,0) none\n\n" + ramp(8)),
                  "no spacing along its axis 3"),
        std::pair(folder.put("d.nrrd", nrrd + "space: LPS\nspace origin: (1,2,3)\n\n" + ramp(8)), "no spacing along any"),
        std::pair(folder.put("e.nrrd", nrrd + "axis mins: 1 2 3\n\n" + ramp(8)), "no spacing along any"),
        std::pair(folder.put("f.nrrd", nrrd + "thicknesses: nan nan 0.5\n\n" + ramp(8)), "says 1 x 1 x 1 mm"),
        std::pair(folder.put("g.mha", meta + "Offset = 1 2 3\n" + data + ramp(8)), "no spacing along any")}) {
    const auto asked = importFile(file, {});
    ASSERT_FALSE(asked.has_value()) << file;
    EXPECT_EQ(askedFor(asked.error()), "spacing") << file;
    EXPECT_TRUE(says(asked, cause)) << file;
    ImportAnswers answers;
    answers.spacing_mm = glm::dvec3(0.5, 0.5, 2.0);
    const auto given = importFile(file, answers);
    ASSERT_TRUE(succeeded(given)) << file;
    EXPECT_EQ(given->volume->grid.spacing_mm, glm::dvec3(0.5, 0.5, 2.0)) << file;
    EXPECT_FALSE(contains(given->notes, cause)) << file;
  }
  EXPECT_TRUE(succeeded(importFile(folder.put("h.nrrd", nrrd + "spacings: 0.5 0.5 1\n\n" + ramp(8)), {})));
}

TEST(ImportFile, AVoxelOfASizeThatCanHardlyBeMeantIsAskedAbout) {
  const TempFolder folder;
  const auto stating = [&](const std::string& spacing) {
    return folder.put("v.mha", "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = " + spacing +
                                   "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + ramp(8));
  };
  const std::string small =
      "A voxel of 'v.mha' is 0.0005 x 0.0005 x 0.001 mm: is its spacing in metres or centimetres? Spacings count millimetres; give the "
      "true "
      "spacing, or say that voxels so small are meant.";
  const std::string large =
      "A voxel of 'v.mha' is 500 x 500 x 1000 mm: is its spacing in micrometres? Spacings count millimetres; give the true spacing, or say "
      "that voxels so large are meant.";
  for (const auto& [spacing, sentence] : {std::pair("0.0005 0.0005 0.001", small), std::pair("500 500 1000", large)}) {
    const auto file = stating(spacing);
    const auto looked = volumeOf(file, {});
    const auto imported = importFile(file, {});
    ASSERT_FALSE(looked.has_value()) << spacing;
    ASSERT_FALSE(imported.has_value()) << spacing;
    EXPECT_EQ(looked.error().sentence(), sentence);
    EXPECT_EQ(imported.error().sentence(), sentence);
    EXPECT_EQ(askedFor(imported.error()), "accept-small");
    ImportAnswers accepted;
    accepted.acceptsSmall = true;
    EXPECT_TRUE(succeeded(volumeOf(file, accepted))) << spacing;
    EXPECT_TRUE(succeeded(importFile(file, accepted))) << spacing;
    ImportAnswers given;
    given.spacing_mm = glm::dvec3(0.5);
    EXPECT_TRUE(succeeded(importFile(file, given))) << spacing;
  }
  ImportAnswers given;
  given.spacing_mm = glm::dvec3(0.0005, 0.0005, 0.001);
  const auto asked = importFile(stating("1 1 2"), given);
  ASSERT_FALSE(asked.has_value());
  EXPECT_EQ(asked.error().sentence(), small) << "said by a person";
  for (const char* usual : {"0.006 0.006 0.006", "1 1 19"}) EXPECT_TRUE(succeeded(importFile(stating(usual), {}))) << usual;
}

TEST(ImportFile, AnswersAreTakenAsGivenAndToldInTheNotes) {
  const TempFolder folder;
  ImportAnswers answers;
  answers.spacing_mm = glm::dvec3(0.3, 0.4, 0.5);
  const auto file =
      folder.put("v.mha", "ObjectType = Image\nNDims = 3\nDimSize = 2 2 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + ramp(4));
  const auto volume = importFile(file, answers);
  ASSERT_TRUE(succeeded(volume));
  EXPECT_EQ(volume->volume->grid.spacing_mm, glm::dvec3(0.3, 0.4, 0.5));
  EXPECT_TRUE(contains(volume->notes, "was given"));
  EXPECT_FALSE(contains(volume->notes, "probably unknown"));
  answers = {};
  answers.raw = RawLayout{.dims = {5, 5, 4}, .spacing_mm = glm::dvec3(2.0)};
  const auto raw = importFile(folder.put("x.bin", ramp(100)), answers);
  ASSERT_TRUE(succeeded(raw));
  EXPECT_EQ(raw->kind, FileKind::raw);
  EXPECT_EQ(raw->volume->echo[99], 99);
  answers = {};
  answers.spacing_mm = glm::dvec3(0.0, 1.0, 1.0);
  EXPECT_TRUE(failedWith(importFile(file, answers), ErrorCode::badUsage));
}

TEST(PreviewImport, ShowsTheWholeFirstImageWhateverTheAnswersWillBe) {
  const TempFolder folder;
  CineOf of;
  of.pixels = ramp(144);
  of.burnedIn = "YES";
  of.regions = {{.x0 = 0, .y0 = 0, .x1 = 3, .y1 = 5}, {.x0 = 4, .y0 = 0, .x1 = 7, .y1 = 5}};
  const auto still = previewImport(folder.put("a.dcm", cineFile(of)), FileKind::dicomImages);
  ASSERT_TRUE(succeeded(still));
  EXPECT_EQ(still->image.width, 8);
  EXPECT_EQ(still->image.height, 6);
  const std::string first = of.pixels.substr(0, 48);
  EXPECT_EQ(still->image.pixels, std::vector<std::uint8_t>(first.begin(), first.end()));
  ASSERT_TRUE(still->dicom.has_value());
  EXPECT_EQ(still->dicom->regions.size(), 2u);
  EXPECT_EQ(still->dicom->frames, 3u);
  const auto stack = previewImport(folder.put("p1.pgm", "P5\n3 2\n255\n" + ramp(6)), FileKind::images);
  ASSERT_TRUE(succeeded(stack));
  EXPECT_EQ(stack->image.width, 3);
  EXPECT_EQ(stack->image.pixels, (std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5}));
}

TEST(PreviewImport, TellsHowManyVolumesAFileHoldsAndWhatSpacingItStates) {
  const TempFolder folder;
  const std::string head = "ObjectType = Image\nNDims = 3\nDimSize = 2 2 1\nElementType = MET_UCHAR\n";
  const auto known =
      previewImport(folder.put("v.mha", head + "ElementSpacing = 0.5 0.6 2\nElementDataFile = LOCAL\n" + ramp(4)), FileKind::volume);
  ASSERT_TRUE(succeeded(known));
  EXPECT_EQ(known->volumes, 1u);
  EXPECT_EQ(known->spacing_mm, glm::dvec3(0.5, 0.6, 2.0));
  const auto unknown = previewImport(folder.put("w.mha", head + "ElementDataFile = LOCAL\n" + ramp(4)), FileKind::volume);
  ASSERT_TRUE(succeeded(unknown));
  EXPECT_FALSE(unknown->spacing_mm.has_value());
  EXPECT_FALSE(previewImport(folder.put("x.mha", "ObjectType = Image\nNDims = 3\n"), FileKind::volume).has_value());
}

}  // namespace
}  // namespace ew::file_import_test
