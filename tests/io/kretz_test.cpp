#include "ew/io/kretz.h"

#include <gtest/gtest.h>

#include "dicom_files.h"
#include "ew/io/dicom.h"
#include "kretz_files.h"

namespace ew::kretz_test {
namespace {
using namespace test;

TEST(Kretz, PointsOfKnownPlaceLandWithinHalfAVoxel) {
  const TempFolder folder;
  for (const auto& [i, j, k] : {std::array{3, 4, 3}, {20, 15, 10}, {36, 25, 16}, {30, 3, 15}}) {
    KretzOf of;
    of.fill([](double, double, double) { return 0.0; });
    of.data[of.index(i, j, k)] = static_cast<char>(250);
    const auto read = readKretz(folder.put("a.vol", kretzFile(of)), {.spacing_mm = 0.5, .mirrored = false, .timeStep = {}, .threads = 1});
    ASSERT_TRUE(succeeded(read));
    const Volume& volume = read->volume;
    glm::dvec3 centre(0.0);
    double weight = 0.0;
    for (int z = 0; z < volume.grid.dims.z; ++z)
      for (int y = 0; y < volume.grid.dims.y; ++y)
        for (int x = 0; x < volume.grid.dims.x; ++x) {
          const double level = volume.echo[volume.grid.indexOf(x, y, z)];
          centre += level * (volume.grid.voxelToWorld() * Point<frame::Voxel>{{x, y, z}}).at;
          weight += level;
        }
    ASSERT_GT(weight, 0.0);
    const auto [x, y, z] = of.place(i, j, k);
    EXPECT_LT(glm::length(centre / weight - glm::dvec3(x, y, z)), 0.25) << i << " " << j << " " << k;
  }
}

TEST(Kretz, ASinglePlaneOrBeamThatLooksAsideIsLaidStraightAheadAndIsNotBlack) {
  const TempFolder folder;
  for (const double aside_rad : {0.0, 1e-9, 0.2}) {
    for (const bool plane : {true, false}) {
      KretzOf of;
      (plane ? of.planes : of.beams) = 1;
      of.fill([](double, double, double) { return 90.0; });
      of.aside_rad = aside_rad;
      const auto read = readKretz(folder.put("a.vol", kretzFile(of)), {.spacing_mm = 0.5, .mirrored = false, .timeStep = {}, .threads = 1});
      ASSERT_TRUE(succeeded(read)) << aside_rad << plane;
      EXPECT_GT(std::count(read->volume.echo.begin(), read->volume.echo.end(), 90), 20) << aside_rad << plane;
      if (aside_rad > 0.1) {
        EXPECT_TRUE(contains(read->notes, "laid straight ahead"));
      }
    }
  }
}

TEST(Kretz, ARampInSpaceStaysOneAndOutsideTheRegionNothingIsInvented) {
  const TempFolder folder;
  KretzOf of;
  const auto level = [](double x, double y, double z) { return 100.0 + x + 0.5 * y - 1.5 * z; };
  of.fill(level);
  for (const bool mirrored : {false, true}) {
    const auto read =
        readKretz(folder.put("a.vol", kretzFile(of)), {.spacing_mm = 0.7, .mirrored = mirrored, .timeStep = {}, .threads = 2});
    ASSERT_TRUE(succeeded(read));
    const Volume& volume = read->volume;
    std::size_t measured = 0;
    for (int k = 0; k < volume.grid.dims.z; ++k)
      for (int j = 0; j < volume.grid.dims.y; ++j)
        for (int i = 0; i < volume.grid.dims.x; ++i) {
          const std::size_t n = volume.grid.indexOf(i, j, k);
          const glm::dvec3 p = volume.grid.origin_mm + 0.7 * glm::dvec3(i, j, k);
          if (volume.coverageAt(n) == Coverage::absent) {
            ASSERT_EQ(volume.echo[n], 0);
            continue;
          }
          ++measured;
          ASSERT_NEAR(volume.echo[n], level(p.x, p.y, mirrored ? -p.z : p.z), 1.6) << p.x << " " << p.y << " " << p.z;
        }
    EXPECT_GT(measured, volume.echo.size() / 3);
    EXPECT_LT(measured, volume.echo.size());
    EXPECT_TRUE(contains(read->notes, "disagree about the side"));
  }
}

TEST(Kretz, TheVoxelsDoNotDependOnTheThreads) {
  const TempFolder folder;
  KretzOf of;
  of.fill([](double x, double y, double z) { return 120 + 40 * std::sin(x) + 30 * std::cos(y + z); });
  const auto file = folder.put("a.vol", kretzFile(of));
  const auto one = readKretz(file, {.spacing_mm = 1.0, .mirrored = false, .timeStep = {}, .threads = 1});
  for (const int threads : {2, 8}) {
    const auto more = readKretz(file, {.spacing_mm = 1.0, .mirrored = false, .timeStep = {}, .threads = threads});
    ASSERT_TRUE(one && more);
    EXPECT_EQ(more->volume, one->volume);
  }
}

TEST(Kretz, PatientTextIsReportedByNameAlone) {
  const TempFolder folder;
  KretzOf of;
  of.fill([](double, double, double) { return 9.0; });
  const auto read = readKretz(folder.put("a.vol", kretzFile(of)), {.spacing_mm = 2.0, .mirrored = false, .timeStep = {}, .threads = 1});
  ASSERT_TRUE(succeeded(read));
  EXPECT_TRUE(contains(read->removed.fields, "(0110,0002) patient text"));
  for (const auto& note : read->notes) EXPECT_EQ(note.english().find("DOE"), std::string::npos);
}

TEST(Kretz, OneInsideADicomFileIsFound) {
  const TempFolder folder;
  KretzOf of;
  of.fill([](double x, double, double) { return 100.0 + x; });
  DicomWriter set;
  set.text(0x00080016u, "UI", "1.2.840.10008.5.1.4.1.1.3.1").text(0x00100010u, "PN", "Doe^Jane");
  set.raw(0x7FE10011u, "LO", "KRETZ_US").raw(0x7FE11101u, "OB", kretzFile(of));
  const auto file = folder.put("a.dcm", dicomFile(kExplicitLittle, set.bytes()));
  const KretzOptions options{.spacing_mm = 1.0, .mirrored = false, .timeStep = {}, .threads = 1};
  const auto inside = readKretz(file, options), plain = readKretz(folder.put("a.vol", kretzFile(of)), options);
  ASSERT_TRUE(succeeded(inside));
  EXPECT_EQ(inside->volume, plain->volume);
  EXPECT_TRUE(contains(inside->removed.fields, "Patient's Name"));
  EXPECT_EQ(inspectDicom(file)->kind, DicomKind::kretz);
}

TEST(Kretz, CartesianVolumesAndSeveralVolumesAreTold) {
  const TempFolder folder;
  KretzOf of;
  of.samples = 4;
  of.beams = 3;
  of.planes = 2;
  of.data = ramp(24);
  of.cartesian = true;
  const auto cartesian = readKretz(folder.put("a.vol", kretzFile(of)));
  ASSERT_TRUE(succeeded(cartesian));
  EXPECT_EQ(cartesian->volume.grid.spacing_mm, glm::dvec3(0.5));
  EXPECT_EQ(cartesian->volume.echo[23], 23);
  of.data.clear();
  of.several = ramp(48);
  const auto file = folder.put("b.vol", kretzFile(of));
  EXPECT_TRUE(failedWith(readKretz(file), ErrorCode::missingCalibration));
  const auto second = readKretz(file, {.spacing_mm = 0.0, .mirrored = false, .timeStep = 2, .threads = 1});
  ASSERT_TRUE(succeeded(second));
  EXPECT_EQ(second->volume.echo[0], 24);
}

TEST(Kretz, WhatCannotBeReadIsRefusedByName) {
  const TempFolder folder;
  KretzOf of;
  of.fill([](double, double, double) { return 9.0; });
  KretzOf packed = of;
  packed.extra = kretzItem(0x0002, 0x1000, "wavelets");
  EXPECT_TRUE(says(readKretz(folder.put("a.vol", kretzFile(packed))), "wavelet compression"));
  KretzOf counts = of;
  counts.angles = 29;
  EXPECT_TRUE(says(readKretz(folder.put("a.vol", kretzFile(counts))), "29 angles"));
  KretzOf shorter = of;
  shorter.data.pop_back();
  EXPECT_TRUE(failedWith(readKretz(folder.put("a.vol", kretzFile(shorter))), ErrorCode::truncated));
  KretzOf axis = of;
  axis.axisDepth_mm = 31.0;
  EXPECT_TRUE(failedWith(readKretz(folder.put("a.vol", kretzFile(axis))), ErrorCode::badField));
  EXPECT_TRUE(
      failedWith(readKretz(folder.put("a.vol", kretzFile(of)), {.spacing_mm = 0.01, .mirrored = false, .timeStep = {}, .threads = 1},
                           noProgress(), ReaderLimits{1u << 20}),
                 ErrorCode::tooLarge));
  EXPECT_TRUE(failedWith(readKretz(folder.put("t.vol", "no volume")), ErrorCode::badHeader));
  StopAfter stop(3);
  EXPECT_TRUE(
      failedWith(readKretz(folder.put("a.vol", kretzFile(of)), {.spacing_mm = 0.5, .mirrored = false, .timeStep = {}, .threads = 1}, stop),
                 ErrorCode::cancelled));
}

}  // namespace
}  // namespace ew::kretz_test
