#include "ew/library/placing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "../tracking/skins.h"

namespace ew::test::placing_test {
namespace {

using Placement = Transform<frame::World, frame::File>;

Placement someRigid() {
  const auto number = [](int from, int to) { return 0.1 * *rc::gen::inRange(10 * from, 10 * to); };
  glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(number(-200, 200), number(-200, 200), number(-200, 200)));
  matrix = glm::rotate(matrix, number(-3, 3), glm::normalize(glm::dvec3(number(-5, 5), number(-5, 5), 1.0)));
  return {matrix};
}

glm::dvec3 somePoint() {
  const auto number = [] { return 0.1 * *rc::gen::inRange(-1500, 1500); };
  return {number(), number(), number()};
}

RC_GTEST_PROP(PlaceByLandmarks, FindsThePlacementThatMadeThePairs, ()) {
  const Placement truth = someRigid();
  std::vector<PlacingPair> pairs;
  for (const glm::dvec3& file : {glm::dvec3(0.0), glm::dvec3(90, 10, 0), glm::dvec3(-20, 80, 15), somePoint()})
    pairs.push_back({"", file, carried(truth, file)});
  const auto fit = placeByLandmarks(pairs);
  RC_ASSERT(fit.has_value());
  RC_ASSERT(!fit->wrong);
  RC_ASSERT(fit->rms_mm < 1e-6);
  for (int n = 0; n < 5; ++n) {
    const glm::dvec3 p = somePoint();
    RC_ASSERT(glm::distance(carried(fit->fileToWorld, p), carried(truth, p)) < 1e-6);
  }
}

std::vector<PlacingPair> fivePairs() {
  const Placement truth{glm::translate(glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(0, 0, 1)), glm::dvec3(5, 6, 7))};
  std::vector<PlacingPair> pairs;
  for (const glm::dvec3& file :
       {glm::dvec3(0, 0, 0), glm::dvec3(100, 0, 0), glm::dvec3(0, 90, 0), glm::dvec3(10, 20, 80), glm::dvec3(70, 60, 30)})
    pairs.push_back({"pair " + std::to_string(pairs.size()), file, carried(truth, file)});
  return pairs;
}

TEST(PlaceByLandmarks, NamesTheWrongPairAndFitsTheOthers) {
  for (std::size_t wrong = 0; wrong < 5; ++wrong) {
    auto pairs = fivePairs();
    const glm::dvec3 right = pairs[wrong].world_mm;
    pairs[wrong].world_mm += glm::dvec3(40, -20, 10);
    const auto fit = placeByLandmarks(pairs);
    ASSERT_TRUE(fit) << fit.error();
    ASSERT_TRUE(fit->wrong);
    EXPECT_EQ(*fit->wrong, wrong);
    ASSERT_EQ(fit->residuals_mm.size(), 5u);
    EXPECT_NEAR(fit->residuals_mm[wrong], glm::length(glm::dvec3(40, -20, 10)), 1e-6);
    EXPECT_NEAR(fit->rms_mm, 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(carried(fit->fileToWorld, pairs[wrong].file_mm), right), 0.0, 1e-6);
  }
}

TEST(PlaceByLandmarks, BlamesNoPairWhereAllAreInexact) {
  // Off by 8 mm each, to all sides: leaving any one out makes the others little better.
  const glm::dvec3 off[] = {{8, 0, 0}, {-4.6, 6.5, 0}, {0, -6.5, 4.6}, {4.6, 0, -6.5}, {-4, 2, 6.6}};
  auto pairs = fivePairs();
  for (std::size_t n = 0; n < pairs.size(); ++n) pairs[n].world_mm += off[n];
  const auto fit = placeByLandmarks(pairs);
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_FALSE(fit->wrong);
  EXPECT_GT(fit->rms_mm, 3.0);
  EXPECT_LT(fit->rms_mm, 8.0);
}

TEST(PlaceByLandmarks, RefusesWhatLeavesTheVolumeFreeToTurn) {
  EXPECT_EQ(placeByLandmarks(std::vector<PlacingPair>(2)).error().code, ErrorCode::badField);
  std::vector<PlacingPair> onALine;
  for (int n = 0; n < 5; ++n) onALine.push_back({"", glm::dvec3(10.0 * n, 5.0 * n, 0.0), glm::dvec3(10.0 * n, 5.0 * n, 0.0)});
  const auto refused = placeByLandmarks(onALine);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("one line"), std::string::npos) << refused.error();
  EXPECT_FALSE(placeByLandmarks(std::vector<PlacingPair>(4))) << "all at one place";
}

/// A box of data of 60 x 40 x 30 mm in a larger grid, its near face the plane j = 10.
Volume boxOfData() {
  Volume volume;
  volume.grid.dims = {80, 60, 50};
  volume.echo.resize(volume.grid.voxelCount(), 0);
  for (int k = 10; k < 40; ++k)
    for (int j = 10; j < 50; ++j)
      for (int i = 10; i < 70; ++i) volume.echo[volume.grid.indexOf(i, j, k)] = 100;
  return volume;
}

TEST(PlacingShape, TakesItsFaceFromTheDataAndNotFromTheGrid) {
  const PlacingShape shape = placingShapeOf(boxOfData(), {});
  ASSERT_GT(shape.face_mm.size(), 100u);
  ASSERT_LE(shape.face_mm.size(), 400u);
  for (const glm::dvec3& each : shape.face_mm) {
    EXPECT_NEAR(each.y, 10.0, 0.51);
    EXPECT_GT(each.x, 9.0);
    EXPECT_LT(each.x, 70.0);
  }
  for (const glm::dvec3& each : shape.inside_mm) EXPECT_GE(each.y, 10.0);
  Volume covered = boxOfData();
  covered.coverage.assign(covered.echo.size(), static_cast<std::uint8_t>(Coverage::measured));
  EXPECT_NEAR(placingShapeOf(covered, {}).face_mm.front().y, 0.0, 0.51) << "black voxels that were measured are data";
}

TEST(Contact, OfABoxOnAPlaneIsExact) {
  const PlaneSkin skin;  // z = 0, the body below it
  const PlacingShape shape = placingShapeOf(boxOfData(), {});
  // Depth (y of the file) goes to -z of the world; the face lies at the file's y = 10.
  const glm::dmat3 turned(glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0));
  const auto at = [&](double face_z) {
    Placement placement{glm::dmat4(turned)};
    placement.matrix[3] = glm::dvec4(0.0, 0.0, face_z + 10.0, 1.0);
    return contactOf(shape, placement, skin);
  };
  const Contact flush = at(0.0);
  EXPECT_DOUBLE_EQ(flush.faceShare, 1.0);
  EXPECT_NEAR(flush.deepestGap_mm, 0.0, 0.51);
  EXPECT_LT(flush.outsideShare, 0.05);
  const Contact above = at(8.0);
  EXPECT_DOUBLE_EQ(above.faceShare, 0.0);
  EXPECT_NEAR(above.deepestGap_mm, 8.0, 0.51);
  EXPECT_NEAR(above.outsideShare, 0.2, 0.08);
  const Contact below = at(-20.0);
  EXPECT_DOUBLE_EQ(below.faceShare, 0.0);
  EXPECT_NEAR(below.deepestIntrusion_mm, 20.0, 0.51);
  EXPECT_DOUBLE_EQ(below.deepestGap_mm, 0.0);
  EXPECT_DOUBLE_EQ(at(100.0).outsideShare, 1.0);
  EXPECT_EQ(contactOf({}, {}, skin), Contact{}) << "nothing is known of a shape without points";
}

TEST(FirstPlacement, LaysABoxFlushOnTheSkinWithItsBeamsPointingIn) {
  const PlaneSkin skin;
  const PlacingShape shape = placingShapeOf(boxOfData(), {});
  PlacingSite site;
  site.at_mm = {30.0, 40.0, 5.0};
  site.towards_mm = {30.0, 40.0, -100.0};
  const Placement placement = firstPlacement(shape, skin, site);
  ASSERT_TRUE(checkRigid(placement));
  const Contact contact = contactOf(shape, placement, skin);
  EXPECT_DOUBLE_EQ(contact.faceShare, 1.0);
  EXPECT_LT(contact.deepestGap_mm + contact.deepestIntrusion_mm, 1.1);
  const glm::dvec3 beam = (placement * Direction<frame::File>{shape.axes.depth}).along;
  EXPECT_NEAR(glm::distance(beam, glm::dvec3(0, 0, -1)), 0.0, 1e-9);
  const glm::dvec3 marker = (placement * Direction<frame::File>{shape.axes.lateral}).along;
  EXPECT_NEAR(glm::distance(marker, glm::dvec3(-1, 0, 0)), 0.0, 1e-9) << "to the patient's right";
}

TEST(FirstPlacement, TipsTheBeamsNoFurtherThanAProbeCan) {
  const PlaneSkin skin;
  PlacingSite site;
  site.towards_mm = {500.0, 0.0, -1.0};
  const PlacingShape shape = placingShapeOf(boxOfData(), {});
  const glm::dvec3 beam = (firstPlacement(shape, skin, site) * Direction<frame::File>{shape.axes.depth}).along;
  EXPECT_NEAR(std::acos(-beam.z) * 180.0 / std::numbers::pi, 35.0, 1e-6);
  EXPECT_GT(beam.x, 0.0);
}

TEST(SweepAxes, AreKeptInACase) {
  Case placed;
  EXPECT_FALSE(sweepAxesOf(placed));
  const SweepAxes axes{glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0.8, 0)};
  const auto kept = sweepAxesOf(withSweepAxes(placed, axes));
  ASSERT_TRUE(kept);
  EXPECT_NEAR(glm::distance(kept->depth, axes.depth), 0.0, 1e-6);
  EXPECT_NEAR(glm::distance(kept->lateral, axes.lateral), 0.0, 1e-6);
}

class Landmarks : public testing::TestWithParam<const char*> {};

TEST_P(Landmarks, LieOnTheMannequinsSkinAndEverySiteFindsIt) {
  const auto known = landmarksOf(GetParam());
  ASSERT_TRUE(known) << known.error();
  const auto skin = skinOfMannequin(GetParam());
  ASSERT_TRUE(skin) << skin.error();
  EXPECT_GE(known->landmarks.size(), 14u);
  for (const BodyLandmark& each : known->landmarks) {
    const auto contact = (*skin)->nearest(each.at_mm);
    EXPECT_LT(glm::distance(contact.point_mm, each.at_mm), 2.5)
        << each.id << ": the skin is at " << contact.point_mm.x << ", " << contact.point_mm.y << ", " << contact.point_mm.z;
    EXPECT_FALSE(each.name.german.empty());
  }
  const PlacingShape shape = placingShapeOf(boxOfData(), {});
  for (const PlacingSite& each : known->sites) {
    EXPECT_LT(glm::distance((*skin)->nearest(each.at_mm).point_mm, each.at_mm), 12.0) << each.region;
    const Contact contact = contactOf(shape, firstPlacement(shape, **skin, each), **skin);
    EXPECT_GT(contact.faceShare, 0.25) << each.region;
    EXPECT_LT(contact.outsideShare, 0.25) << each.region;
    EXPECT_EQ(siteFor(*known, each.region)->region, each.region);
  }
  EXPECT_EQ(siteFor(*known, "Right upper quadrant, in deep breath")->region, "right upper quadrant");
  EXPECT_EQ(siteFor(*known, "elbow")->region, known->sites.front().region);
  for (const char* region : {"heart", "chest", "lung", "breast", "pelvis", "thigh", "knee", "calf"})
    EXPECT_EQ(siteFor(*known, region)->region, region);
  for (const char* region : {"limb", "shoulder", "elbow"}) EXPECT_FALSE(knowsRegion(*known, region)) << region;
}
INSTANTIATE_TEST_SUITE_P(OfEveryMannequin, Landmarks,
                         testing::Values("adult.json", "adult-arms-up.json", "gravid.json", "neck-extended.json"));

TEST(Landmarks, OfAnUnknownMannequinAreMissed) { EXPECT_EQ(landmarksOf("nobody.json").error().code, ErrorCode::notFound); }

}  // namespace
}  // namespace ew::test::placing_test
