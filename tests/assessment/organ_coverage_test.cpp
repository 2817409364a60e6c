#include "ew/assessment/organ_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace ew {
namespace {

constexpr int kLabel = 7;

/// 60 x 60 x 60 voxels of 1 mm about the origin, those with this label where `inside` says.
template <class Inside>
Volume labelled(const Inside& inside, double spacing_mm = 1.0) {
  Volume labels;
  const int side = static_cast<int>(60.0 / spacing_mm);
  labels.grid.dims = glm::ivec3(side);
  labels.grid.spacing_mm = glm::dvec3(spacing_mm);
  labels.grid.origin_mm = glm::dvec3(-0.5 * spacing_mm * (side - 1));
  labels.echo.assign(labels.grid.voxelCount(), 0);
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        if (inside(labels.grid.origin_mm + spacing_mm * glm::dvec3(i, j, k))) labels.echo[labels.grid.indexOf(i, j, k)] = kLabel;
  return labels;
}

Volume box(double half_mm) {
  return labelled([=](const glm::dvec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < half_mm; });
}
Volume ball(double radius_mm) {
  return labelled([=](const glm::dvec3& p) { return glm::length(p) < radius_mm; });
}

/// 40 mm wide, 60 mm deep.
Fan straightFan() {
  Fan fan;
  fan.probe.kind = ProbeKind::linear;
  fan.probe.width_mm = 40.0;
  fan.depth_mm = 60.0;
  return fan;
}

/// Above the origin, looking along +y, its plane at z.
Pose at(double z_mm, double x_mm = 0.0) {
  Pose pose;
  pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(x_mm, -30.0, z_mm));
  return pose;
}

std::shared_ptr<const OrganVoxels> organOf(const Volume& labels) { return std::make_shared<const OrganVoxels>(labels, kLabel); }

TEST(OrganVoxels, AreAllOfTheLabelInBlocks) {
  const OrganVoxels organ(box(10.0), kLabel);
  EXPECT_EQ(organ.count(), 8000U);
  EXPECT_LT(glm::length(organ.middle_mm()), 1e-6);
  std::size_t in = 0;
  for (const auto& block : organ.blocks()) {
    for (std::size_t n = block.first; n < block.end; ++n)
      EXPECT_LE(glm::distance(glm::dvec3(organ.centres_mm()[n]), block.middle_mm), block.radius_mm);
    in += block.end - block.first;
  }
  EXPECT_EQ(in, 8000U);
  EXPECT_TRUE(OrganVoxels(box(10.0), 3).empty());
}

TEST(OrganVoxels, KnowTheirDistanceToAPoint) {
  const OrganVoxels organ(box(10.0), kLabel);
  EXPECT_EQ(distanceTo_mm(organ, {0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(distanceTo_mm(organ, {9.9, -9.9, 9.9}), 0.0);
  EXPECT_NEAR(distanceTo_mm(organ, {13.0, 0.2, 0.1}), 3.0, 1e-4);
  EXPECT_NEAR(distanceTo_mm(organ, {13.0, 14.0, 0.1}), 5.0, 1e-4);
  EXPECT_TRUE(std::isinf(distanceTo_mm(OrganVoxels(), {0.0, 0.0, 0.0})));
}

TEST(Fan, HoldsWhatItsLinesReach) {
  EXPECT_EQ(placeInFan(straightFan(), {0.0, 30.0}), 0.0);
  EXPECT_EQ(placeInFan(straightFan(), {-20.0, 0.0}), -1.0);
  EXPECT_FALSE(placeInFan(straightFan(), {20.1, 30.0}));
  EXPECT_FALSE(placeInFan(straightFan(), {0.0, 60.1}));
  EXPECT_FALSE(placeInFan(straightFan(), {0.0, -0.1}));
  Fan curved;
  curved.probe.kind = ProbeKind::convex;
  curved.probe.radius_mm = 60.0;
  curved.probe.halfAngle_rad = 0.5;
  curved.depth_mm = 100.0;
  EXPECT_TRUE(placeInFan(curved, {160.0 * std::sin(0.4999), 160.0 * std::cos(0.4999) - 60.0 - 1e-9}));
  EXPECT_FALSE(placeInFan(curved, {100.0 * std::sin(0.51), 100.0 * std::cos(0.51) - 60.0}));
  EXPECT_TRUE(placeInFan(curved, {60.001 * std::sin(0.4), 60.001 * std::cos(0.4) - 60.0})) << "behind the foremost point of the face";
  EXPECT_NEAR(*placeInFan(curved, {100.0 * std::sin(0.25), 100.0 * std::cos(0.25) - 60.0}), 0.5, 1e-12);
  // The area of a ring's sector: half angle times the difference of squared radii.
  EXPECT_NEAR(areaOf_mm2(curved, 0.5), 0.5 * (160.0 * 160.0 - 60.0 * 60.0), 60.0);
}

TEST(OrganCoverage, OfABoxIsTheSlicesThatFramesPassedThrough) {
  OrganCoverage coverage(organOf(box(10.0)), {2.0});
  EXPECT_EQ(coverage.share(), 0.0);
  // Voxel centres lie at halves of mm: a slab of 2 mm about z = 0 holds those at -0.5 and 0.5.
  EXPECT_EQ(coverage.add(straightFan(), at(0.0)), 800U);
  EXPECT_DOUBLE_EQ(coverage.share(), 0.1);
  EXPECT_EQ(coverage.add(straightFan(), at(0.0)), 0U) << "nothing new";
  for (int z = -10; z <= 10; z += 2) static_cast<void>(coverage.add(straightFan(), at(z)));
  EXPECT_EQ(coverage.share(), 1.0);
  coverage.clear();
  EXPECT_EQ(coverage.share(), 0.0);
}

TEST(OrganCoverage, OfABallGrowsWithItsCaps) {
  const auto organ = organOf(ball(20.0));
  OrganCoverage coverage(organ, {2.0});
  for (double z = -19.0; z < 0.0; z += 2.0) static_cast<void>(coverage.add(straightFan(), at(z)));
  EXPECT_NEAR(coverage.share(), 0.5, 1e-9) << "half a ball, the grid being symmetric";
}

TEST(OrganCoverage, EndsWithTheDepthAndTheWidth) {
  OrganCoverage coverage(organOf(box(10.0)), {2.0});
  Fan shallow = straightFan();
  shallow.depth_mm = 30.0;  // to y = 0, the middle of the box
  EXPECT_EQ(coverage.add(shallow, at(0.0)), 400U);
  coverage.clear();
  EXPECT_EQ(coverage.add(straightFan(), at(0.0, 20.0)), 400U) << "the left half of the fan's edge lies on x = 0";
}

TEST(OrganCoverage, CountsNothingWithoutContactOrPose) {
  OrganCoverage coverage(organOf(box(10.0)), {2.0, 0.0});
  EXPECT_EQ(coverage.add(straightFan(), at(0.0), std::vector<float>(17, 5.0F)), 0U);
  Pose lost = at(0.0);
  lost.status = PoseStatus::missing;
  EXPECT_EQ(coverage.add(straightFan(), lost), 0U);
  // Only the half of the face at -x touches: points 0 to 7 of 17, up to 2.5 mm before its middle; without reach the lines of the points.
  std::vector<float> half(17, 5.0F);
  std::fill(half.begin(), half.begin() + 9, 1.0F);
  OrganCoverage reaching(organOf(box(10.0)), {2.0, 0.0625});
  EXPECT_EQ(reaching.add(straightFan(), at(0.0), half), 2U * 20U * 11U) << "x from -10 to 1.25: eleven columns of centres";
}

TEST(OrganCoverage, IsTheSameAsAskingEveryVoxel) {
  const auto organ = organOf(ball(17.0));
  OrganCoverage coverage(organ, {3.0});
  std::vector<bool> passed(organ->count(), false);
  for (int n = 0; n < 12; ++n) {
    Pose pose = at(0.0);
    pose.probeToWorld.matrix = pose.probeToWorld.matrix * glm::rotate(glm::dmat4(1.0), 0.3 * n, glm::dvec3(0.0, 1.0, 0.0)) *
                               glm::rotate(glm::dmat4(1.0), 0.05 * n - 0.3, glm::dvec3(1.0, 0.0, 0.0));
    static_cast<void>(coverage.add(straightFan(), pose));
    for (std::size_t v = 0; v < organ->count(); ++v) {
      const glm::dvec3 p = carried(rigidInverse(pose.probeToWorld), glm::dvec3(organ->centres_mm()[v]));
      if (std::abs(p.z) <= 1.5 && placeInFan(straightFan(), glm::dvec2(p))) passed[v] = true;
    }
  }
  for (std::size_t v = 0; v < organ->count(); ++v) ASSERT_EQ(coverage.isPassed(v), passed[v]);
  EXPECT_EQ(coverage.passed(), static_cast<std::size_t>(std::count(passed.begin(), passed.end(), true)));
}

/// Which voxels a frame passes through, each asked by the definition alone.
std::vector<bool> passedOneByOne(const OrganVoxels& organ, const CoverageOptions& options, const Fan& fan, const Pose& pose,
                                 const std::vector<float>& gaps_mm) {
  const double half_mm = 0.5 * std::max(options.thickness_mm, glm::length(organ.grid().spacing_mm));
  const auto hears = [&](double place) {
    if (gaps_mm.size() < 2) return gaps_mm.empty() || gaps_mm.front() <= 3.0F;
    for (std::size_t n = 0; n < gaps_mm.size(); ++n) {
      const double at = 2.0 * static_cast<double>(n) / static_cast<double>(gaps_mm.size() - 1) - 1.0;
      if (gaps_mm[n] <= 3.0F && std::abs(place - at) <= options.contactReach + 1e-9) return true;
    }
    return false;
  };
  std::vector<bool> passed(organ.count(), false);
  for (std::size_t v = 0; v < organ.count(); ++v) {
    const glm::dvec3 p = carried(rigidInverse(pose.probeToWorld), glm::dvec3(organ.centres_mm()[v]));
    const auto place = placeInFan(fan, glm::dvec2(p));
    passed[v] = std::abs(p.z) <= half_mm && place && hears(*place);
  }
  return passed;
}

Fan fanOf(ProbeKind kind, double radius_mm, double halfAngle_rad) {
  Fan fan = straightFan();
  fan.probe.kind = kind;
  fan.probe.radius_mm = radius_mm;
  fan.probe.halfAngle_rad = halfAngle_rad;
  return fan;
}

/// What is left of the face's contact: all, none said, a part, two parts, nothing.
std::vector<std::vector<float>> contacts() {
  std::vector<float> all(17, 1.0F), part(17, 5.0F), ends(17, 1.0F), none(17, 5.0F);
  std::fill(part.begin() + 4, part.begin() + 9, 3.0F);
  std::fill(ends.begin() + 3, ends.end() - 2, 4.0F);
  return {{}, all, part, ends, none, {2.0F}, {9.0F}};
}

TEST(OrganCoverage, OfEveryKindOfFanIsTheSameAsAskingEveryVoxel) {
  Volume labels = ball(19.0);
  Grid oblique = labels.grid;
  oblique.spacing_mm = {0.9, 1.3, 1.6};
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1.0, -2.0, 0.5)));
  oblique.directions = glm::dmat3(-turned[0], turned[1], turned[2]);  // left-handed
  oblique.origin_mm = glm::dvec3(900.0, -300.0, -1200.0) - oblique.directions * (29.5 * oblique.spacing_mm);
  int some = 0;
  for (const Grid& placed : {labels.grid, oblique}) {
    const auto organ = std::make_shared<const OrganVoxels>(labels, placed, kLabel);
    for (const Fan& fan : {straightFan(), fanOf(ProbeKind::convex, 30.0, 0.5), fanOf(ProbeKind::phased, 0.0, 0.7),
                           fanOf(ProbeKind::convex, 10.0, 1.3), fanOf(ProbeKind::convex, 10.0, 1.7)})
      for (const auto& gaps_mm : contacts())
        for (int n = 0; n < 8; ++n) {
          glm::dmat4 pose = glm::translate(glm::dmat4(1.0), organ->middle_mm());
          pose = pose * glm::rotate(glm::dmat4(1.0), 0.8 * n, glm::dvec3(0.0, 1.0, 0.3 * n)) *
                 glm::rotate(glm::dmat4(1.0), 0.37 * n, glm::dvec3(1.0, 0.0, 0.0));
          Pose held;
          held.probeToWorld.matrix = pose * glm::translate(glm::dmat4(1.0), glm::dvec3(3.0 * (n % 3) - 4.0, -6.0 * n, 0.5 * n));
          OrganCoverage coverage(organ, {2.0});
          const std::vector<bool> expected = passedOneByOne(*organ, {2.0}, fan, held, gaps_mm);
          const auto count = static_cast<std::size_t>(std::count(expected.begin(), expected.end(), true));
          some += count > 0 ? 1 : 0;
          ASSERT_EQ(coverage.add(fan, held, gaps_mm), count);
          for (std::size_t v = 0; v < organ->count(); ++v) ASSERT_EQ(coverage.isPassed(v), expected[v]) << v;
          ASSERT_EQ(coverage.add(fan, held, gaps_mm), 0U);
        }
  }
  EXPECT_GT(some, 200) << "of 560 frames";
}

TEST(OrganSection, IsTheAreaInTheImageAndAPointInside) {
  const Volume labels = ball(15.0);
  const OrganSection section = sectionOf(labels, kLabel, straightFan(), at(0.0), 0.5);
  EXPECT_NEAR(section.area_mm2, 3.14159 * 15.0 * 15.0, 15.0);
  EXPECT_NEAR(section.inside_mm.x, 0.0, 0.6);
  EXPECT_NEAR(section.inside_mm.y, 30.0, 0.6);
  EXPECT_EQ(sectionOf(labels, kLabel, straightFan(), at(16.0)).area_mm2, 0.0);
}

TEST(OrganSection, OfARingIsPointedAtInTheRing) {
  const Volume ring = labelled([](const glm::dvec3& p) { return std::abs(std::hypot(p.x, p.y) - 12.0) < 2.0; });
  const OrganSection section = sectionOf(ring, kLabel, straightFan(), at(0.0), 0.5);
  EXPECT_NEAR(std::hypot(section.inside_mm.x, section.inside_mm.y - 30.0), 12.0, 1.0) << "neither in its empty middle nor on its rim";
}

}  // namespace
}  // namespace ew
