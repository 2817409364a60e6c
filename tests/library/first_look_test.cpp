#include "ew/library/first_look.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../tracking/skins.h"
#include "ew/core/data_file.h"

namespace ew::test::first_look_test {
namespace {

std::vector<Probe> shippedProbes() {
  const auto probes = readProbes(resourceFolder().value() / "probes");
  EXPECT_TRUE(probes) << probes.error();
  return probes ? *probes : std::vector<Probe>();
}

PlacingShape boxOf(double width_mm, double depth_mm) {
  Grid grid;
  grid.dims = {41, 41, 21};
  grid.spacing_mm = {width_mm / 40.0, depth_mm / 40.0, 1.0};
  return placingShapeOf(grid, {});
}

const Probe& named(const std::vector<Probe>& probes, const std::string& id) {
  return *std::find_if(probes.begin(), probes.end(), [&](const Probe& each) { return each.id == id; });
}

TEST(FirstLook, FollowsTheVolume) {
  const std::vector<Probe> probes = shippedProbes();
  const auto shallow = firstLookAt(boxOf(40.0, 38.0), probes), deep = firstLookAt(boxOf(160.0, 170.0), probes);
  ASSERT_TRUE(shallow && deep);
  EXPECT_EQ(named(probes, shallow->probe).kind, ProbeKind::linear) << shallow->probe;
  EXPECT_GE(shallow->depth_mm, 38.0);
  EXPECT_LE(shallow->depth_mm, 45.0);
  EXPECT_EQ(deep->probe, "convex-3.5");
  EXPECT_GE(deep->depth_mm, 165.0);
  EXPECT_LE(deep->depth_mm, 190.0);
  EXPECT_FALSE(firstLookAt(PlacingShape{}, probes));
  EXPECT_FALSE(firstLookAt(boxOf(40.0, 38.0), {}));
  for (const double depth_mm : {15.0, 40.0, 60.0, 100.0, 150.0, 220.0}) {
    const auto look = firstLookAt(boxOf(60.0, depth_mm), probes);
    ASSERT_TRUE(look);
    EXPECT_TRUE(showsWhole(boxOf(60.0, depth_mm), look->depth_mm)) << depth_mm << " with " << look->probe << " at " << look->depth_mm;
  }
  EXPECT_FALSE(showsWhole(boxOf(40.0, 60.0), 160.0)) << "a stamp";
  EXPECT_FALSE(showsWhole(boxOf(160.0, 170.0), 35.0)) << "cut off";
}

TEST(FirstLook, PutsARecordingBeforeTheProbeAsItsOwnSawIt) {
  // Beams go along +x of the file, the marker points to +z: nothing of it lies as an image from the front would.
  Volume volume;
  volume.grid.dims = {60, 20, 40};
  volume.grid.spacing_mm = glm::dvec3(1.0);
  volume.grid.origin_mm = {300.0, -50.0, 700.0};
  volume.echo.assign(volume.grid.voxelCount(), 0);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 15; i < 60; ++i) volume.echo[volume.grid.indexOf(i, j, k)] = 100;  // 15 mm of nothing before the face
  Provenance recorded;
  for (int n = 0; n < 5; ++n) {
    FrameProvenance frame;
    frame.imageToWorld.matrix = glm::dmat4(0, 0, 0.5, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 315, -50 + n, 700, 1);
    recorded.frames.push_back(frame);
  }
  const SphereSkin skin(150.0);
  const PlacingSite site{.region = "front", .at_mm = {0.0, -150.0, 0.0}, .towards_mm = {0.0, 0.0, 0.0}};
  const auto place = firstPlaceOf(volume, recorded, skin, site);
  ASSERT_TRUE(place);
  EXPECT_NEAR(depthOf_mm(place->shape), 41.0, 4.0) << "of 44, and none of the 15 before the face";
  const glm::dmat4& start = place->start.probeToWorld.matrix;
  EXPECT_GT(glm::dot(glm::dvec3(start[1]), glm::dvec3(0.0, 1.0, 0.0)), 0.95) << "the beams look into the body";
  EXPECT_LT(glm::distance(glm::dvec3(start[3]), glm::dvec3(0.0, -150.0, 0.0)), 12.0) << "the face lies on the skin";
  const glm::dvec3 deep = carried(place->fileToWorld, {355.0, -40.0, 720.0});
  EXPECT_LT(glm::length(deep), 125.0) << "and what is deep lies in the body";
}

}  // namespace
}  // namespace ew::test::first_look_test
