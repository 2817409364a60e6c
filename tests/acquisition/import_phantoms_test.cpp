#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "acquisition/import_sweep.h"
#include "ew/acquisition/sweep_geometry.h"
#include "ew/acquisition/sweep_volume.h"
#include "ew/io/volume_file.h"
#include "recordings.h"

namespace ew::import_phantoms_test {
namespace {

using namespace test;

/// How a reconstruction compares with a reference on the voxels both know and the sweep covers well.
struct Likeness {
  double correlation = 0.0;
  double bias = 0.0;  ///< ours minus theirs, grey levels
  double withinTen = 0.0;
  std::size_t voxels = 0;
};

Likeness likenessOf(const ReconstructResult& ours, const Volume& theirs) {
  const Grid& a = ours.volume.grid;
  const glm::ivec3 common = glm::min(a.dims, theirs.grid.dims);
  double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0, near = 0;
  for (int k = 0; k < common.z; ++k)
    for (int j = 0; j < common.y; ++j)
      for (int i = 0; i < common.x; ++i) {
        const std::size_t voxel = a.indexOf(i, j, k);
        const double x = ours.volume.echo[voxel], y = theirs.echo[theirs.grid.indexOf(i, j, k)];
        if (ours.weights[voxel] <= 0.5F || x == 0.0 || y == 0.0) continue;
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        syy += y * y;
        sxy += x * y;
        near += std::abs(x - y) <= 10.0 ? 1 : 0;
      }
  return {(n * sxy - sx * sy) / std::sqrt((n * sxx - sx * sx) * (n * syy - sy * sy)), (sx - sy) / n, near / n, static_cast<std::size_t>(n)};
}

/// The references were made by another program whose nearest-neighbour mean is too dark by a known amount (its 8-bit running mean).
TEST(ImportSpinePhantom, AgreesWithTheThreeReferencesOfAnotherProgram) {
  EW_NEEDS_RECORDING("spine-phantom-sweep");
  const fs::path data = test::recording("spine-phantom-sweep");
  struct Case {
    const char* device;
    const char* reference;
    double leastBias, largestBias, withinTen;
    bool sameDims;
  };
  for (const Case& c : {Case{"PlusDeviceSet_VolumeReconstructionOnly_SpinePhantom_NN_MEAN.xml",
                             "vtkVolumeReconstructorTestNNMEANvolumeRef.mha", 4.0, 6.0, 0.90, true},
                        Case{"PlusDeviceSet_VolumeReconstructionOnly_SonixRP_TRUS_D70mm_LN_MEAN.xml",
                             "vtkVolumeReconstructorTestLNMEANvolumeRef.mha", -1.5, 1.5, 0.99, true},
                        Case{"PlusDeviceSet_SpinePhantomFreehandReconstructionOnly.xml", "SpinePhantomFreehandReconstructed.mha", -1.5, 1.5,
                             0.99, false}}) {
    SweepImportOptions options;
    options.calibrations = {data / c.device};
    options.usual.spacing = true;
    options.usual.interpolation = true;
    options.usual.compounding = true;
    options.reconstruct.keepWeights = true;
    const auto imported = importFile(data / "SpinePhantomFreehand.igs.mha", options, noProgress());
    ASSERT_TRUE(imported.has_value()) << imported.error();
    const auto reference = readVolume(data / c.reference);
    ASSERT_TRUE(reference.has_value()) << reference.error();
    const Grid& ours = imported->reconstruction.volume.grid;
    const Grid& theirs = reference->volume.grid;
    EXPECT_LT(glm::length(ours.origin_mm - theirs.origin_mm), 0.001) << c.reference << ours << theirs;
    EXPECT_EQ(ours.dims, theirs.dims + glm::ivec3(0, 0, c.sameDims ? 0 : 1));  // the third was made with an older, truncating size rule
    const Likeness found = likenessOf(imported->reconstruction, reference->volume);
    EXPECT_GT(found.voxels, 10000u);
    EXPECT_GE(found.correlation, 0.997) << c.reference;
    EXPECT_GE(found.bias, c.leastBias) << c.reference;
    EXPECT_LE(found.bias, c.largestBias) << c.reference;
    EXPECT_GE(found.withinTen, c.withinTen) << c.reference;
    std::printf("%s: correlation %.5f, bias %+.2f, within 10 %.2f %%, %zu voxels\n", c.reference, found.correlation, found.bias,
                100.0 * found.withinTen, found.voxels);
  }
}

struct Wire {
  glm::dvec3 from_mm;
  glm::dvec3 to_mm;
};

double distance_mm(const Wire& wire, const glm::dvec3& p_mm) {
  const glm::dvec3 along = wire.to_mm - wire.from_mm;
  const double t = std::clamp(glm::dot(p_mm - wire.from_mm, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(p_mm - wire.from_mm - t * along);
}

/// The nine wires are stretched between the phantom's walls as its device set says; the recordings show them and little else.
TEST(ImportWirePhantom, PutsBrightVoxelsOnTheKnownWires) {
  EW_NEEDS_RECORDING("wire-phantom-pair");
  const fs::path data = test::recording("wire-phantom-pair");
  const std::vector<Wire> wires = {{{30, 0, 20}, {30, 40, 20}}, {{55, 0, 20}, {35, 40, 20}}, {{60, 0, 20}, {60, 40, 20}},
                                   {{30, 0, 10}, {30, 40, 10}}, {{35, 0, 10}, {55, 40, 10}}, {{60, 0, 10}, {60, 40, 10}},
                                   {{35, 0, 0}, {35, 40, 0}},   {{55, 0, 0}, {40, 40, 0}},   {{60, 0, 0}, {60, 40, 0}}};
  constexpr int kHalfOfWhite = 128;
  for (const char* recording : {"fCal_Test_Calibration_3NWires_fCal2.0.igs.mha", "fCal_Test_Validation_3NWires_fCal2.0.igs.mha"}) {
    SweepImportOptions options;
    options.calibrations = {data / "FreehandCalibration3NWires_fCal2.0.results.xml",
                            data / "PlusDeviceSet_fCal_Sim_SpatialCalibration_2.0.xml"};
    options.toFrame = "Phantom";
    options.reconstruct.spacing_mm = 0.4;
    options.reconstruct.interpolation = Interpolation::nearest;
    const auto imported = importFile(data / recording, options, noProgress());
    ASSERT_TRUE(imported.has_value()) << imported.error();
    const Volume& volume = imported->reconstruction.volume;
    std::vector<double> distances_mm;
    const auto voxelToPhantom = volume.grid.voxelToWorld();
    for (int k = 0; k < volume.grid.dims.z; ++k)
      for (int j = 0; j < volume.grid.dims.y; ++j)
        for (int i = 0; i < volume.grid.dims.x; ++i) {
          if (volume.echo[volume.grid.indexOf(i, j, k)] < kHalfOfWhite) continue;
          const glm::dvec3 p_mm = (voxelToPhantom * Point<frame::Voxel>{{i, j, k}}).at;
          double least_mm = 1e9;
          for (const Wire& wire : wires) least_mm = std::min(least_mm, distance_mm(wire, p_mm));
          distances_mm.push_back(least_mm);
        }
    ASSERT_FALSE(distances_mm.empty());
    std::sort(distances_mm.begin(), distances_mm.end());
    const double median_mm = distances_mm[distances_mm.size() / 2];
    std::printf("%s: median %.3f mm, 90 %% below %.3f mm, %zu voxels\n", recording, median_mm, distances_mm[distances_mm.size() * 9 / 10],
                distances_mm.size());
    EXPECT_GT(distances_mm.size(), 1000u);
    EXPECT_LE(median_mm, 0.55) << recording;
  }
}

}  // namespace
}  // namespace ew::import_phantoms_test
