#include "logic/placing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "logic/landmark_pairs.h"
#include "tracking/skins.h"

namespace ew::case_authoring::placing_test {
namespace {

using test::PlaneSkin;

/// Of the whole range from the first try on, whatever the size.
double between(double low, double high) { return low + (high - low) * (*rc::gen::resize(100, rc::gen::inRange(0, 1'000'001))) / 1e6; }

glm::dvec3 anyDirection() {
  glm::dvec3 p(between(-1, 1), between(-1, 1), between(-1, 1));
  if (glm::length(p) < 1e-2) p = {0.3, -0.8, 0.5};
  return glm::normalize(p);
}

glm::dmat4 anyRigid() {
  const glm::dmat4 shift = glm::translate(glm::dmat4(1.0), glm::dvec3(between(-300, 300), between(-300, 300), between(-300, 300)));
  return glm::rotate(shift, between(-3.1, 3.1), anyDirection());
}

/// Oblique, with three different sizes and spacings.
Grid anyGrid() {
  Grid grid;
  grid.dims = {24, 30, 18};
  grid.spacing_mm = {2.0, 1.5, 3.0};
  return placed(grid, FilePlace{anyRigid()});
}

double largestDifference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0.0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
  return largest;
}

/// 60 x 80 x 50 mm about the origin of its file.
Grid smallGrid() {
  Grid grid;
  grid.dims = {30, 40, 25};
  grid.spacing_mm = glm::dvec3(2.0);
  grid.origin_mm = {-29.0, -39.0, -24.0};
  return grid;
}

RC_GTEST_PROP(FacesOfAGrid, AreSixThatLookInwardsAndAreFoundAgain, ()) {
  const Grid grid = anyGrid();
  const auto faces = axesOfFaces(grid, anyDirection());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    RC_ASSERT(faceOf(grid, faces[face]) == std::optional(face));
    RC_ASSERT(std::abs(glm::dot(faces[face].depth, faces[face].lateral)) < 1e-9);
    RC_ASSERT(std::abs(glm::length(faces[face].lateral) - 1.0) < 1e-9);
    // From the middle of that side inwards.
    const auto corners = nearSideOf(grid, faces[face], FilePlace{});
    const glm::dvec3 side_mm = 0.25 * (corners[0].at + corners[1].at + corners[2].at + corners[3].at);
    RC_ASSERT(glm::dot(middleOf(grid) - side_mm, faces[face].depth) > 20.0);
    RC_ASSERT(glm::length(glm::cross(middleOf(grid) - side_mm, faces[face].depth)) < 1e-6);
  }
}

TEST(FacesOfAGrid, AreNoneForBeamsThatEnterObliquely) {
  EXPECT_FALSE(faceOf(smallGrid(), {glm::normalize(glm::dvec3(0.2, 1.0, 0.0)), {0, 0, 1}}).has_value());
  EXPECT_EQ(faceOf(smallGrid(), {{0, -1, 0}, {1, 0, 0}}), std::optional<std::size_t>(3)) << "from the last row to the first";
}

RC_GTEST_PROP(AxesOfACase, AreReadAsTheyWereWritten, ()) {
  const SweepAxes axes = axesOfFaces(anyGrid(), anyDirection())[static_cast<std::size_t>(*rc::gen::inRange(0, 6))];
  Case made;
  made.volume.file = "a.mha";
  RC_ASSERT(!sweepAxesOf(made).has_value());
  const auto read = sweepAxesOf(withSweepAxes(made, axes));
  RC_ASSERT(read.has_value());
  RC_ASSERT(glm::distance(read->depth, axes.depth) < 1e-5);
  RC_ASSERT(glm::distance(read->lateral, axes.lateral) < 1e-5);
}

RC_GTEST_PROP(Handles, CarryTheVolumeWithThem, ()) {
  const Grid grid = anyGrid();
  const SweepAxes axes = axesOfFaces(grid, anyDirection())[2];
  const FilePlace before{anyRigid()};
  const auto handles = handlesOf(grid, axes, before);
  RC_ASSERT(checkRigid(handles.toWorld, 1e-9).has_value());
  RC_ASSERT(glm::distance(glm::dvec3(handles.toWorld.matrix[3]), middleOf(placed(grid, before))) < 1e-9);
  RC_ASSERT(glm::distance(glm::dvec3(handles.toWorld.matrix[1]), (before * Direction<frame::File>{axes.depth}).along) < 1e-9);
  const HandlesPose now{anyRigid()};
  const FilePlace after = movedWith(before, handles.toWorld, now);
  RC_ASSERT(largestDifference(handlesOf(grid, axes, after).toWorld.matrix, now.matrix) < 1e-8);
  RC_ASSERT(movedWith(before, handles.toWorld, handles.toWorld) == before);
}

RC_GTEST_PROP(TurningAboutTheBeam, LeavesTheMiddleOfTheFaceAndTheBeamsAndComesRound, ()) {
  const Grid grid = anyGrid();
  const SweepAxes axes = axesOfFaces(grid, anyDirection())[4];
  const FilePlace before{anyRigid()};
  const auto middleOfFace = [&](const FilePlace& at) {
    const auto corners = nearSideOf(grid, axes, at);
    return 0.5 * (corners[0].at + corners[2].at);
  };
  const FilePlace half = turnedAboutBeam(grid, axes, before, glm::pi<double>());
  RC_ASSERT(glm::distance(middleOfFace(half), middleOfFace(before)) < 1e-8);
  const auto along = [&](const FilePlace& at, const glm::dvec3& d) { return (at * Direction<frame::File>{d}).along; };
  RC_ASSERT(glm::distance(along(half, axes.depth), along(before, axes.depth)) < 1e-9);
  RC_ASSERT(glm::distance(along(half, axes.lateral), -along(before, axes.lateral)) < 1e-9);  // exchanged
  FilePlace round = before;
  for (int n = 0; n < 4; ++n) round = turnedAboutBeam(grid, axes, round, glm::half_pi<double>());
  RC_ASSERT(largestDifference(round.matrix, before.matrix) < 1e-9);
}

RC_GTEST_PROP(PuttingOnTheSkin, LaysTheFaceFlushWithTheBeamsStraightIn, ()) {
  const Grid grid = anyGrid();
  const SweepAxes axes = axesOfFaces(grid, anyDirection())[static_cast<std::size_t>(*rc::gen::inRange(0, 6))];
  const PlacingShape shape = placingShapeOf(grid, axes);
  const PlaneSkin skin;
  const Point<frame::World> at{{between(-100, 100), between(-100, 100), 0.0}};
  const FilePlace put = putOnSkin(shape, FilePlace{anyRigid()}, skin, at);
  const Contact contact = contactOf(shape, put, skin);
  RC_ASSERT(contact.faceShare == 1.0);
  RC_ASSERT(contact.deepestGap_mm < 0.2);
  RC_ASSERT(glm::distance((put * Direction<frame::File>{axes.depth}).along, glm::dvec3(0, 0, -1)) < 1e-9);
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& each : shape.face_mm) sum += carried(put, each);
  RC_ASSERT(glm::distance(sum / static_cast<double>(shape.face_mm.size()), at.at) < 0.2);
}

TEST(NearFace, IsTheOneAtTheSkinThatLooksInAndWhereTheProbeIsAtTheStart) {
  const PlaneSkin skin;
  FilePlace low;  // 10 mm below the skin of the plane z = 0: the greatest k lies next to it
  low.matrix[3] = {0.0, 0.0, -35.0, 1.0};
  EXPECT_EQ(likelyFace(smallGrid(), low, skin, std::nullopt), 5u);
  FilePlace turned{glm::rotate(low.matrix, glm::half_pi<double>(), glm::dvec3(1.0, 0.0, 0.0))};  // j looks up
  EXPECT_EQ(likelyFace(smallGrid(), turned, skin, std::nullopt), 3u);
  // A slab from skin to skin of a body of its own thickness: nobody can tell but by the start.
  const test::SphereSkin body(40.0);
  EXPECT_EQ(likelyFace(smallGrid(), {}, body, std::nullopt), 2u) << "from the front";
  EXPECT_EQ(likelyFace(smallGrid(), {}, body, glm::dvec3(0.0, -1.0, 0.0)), 3u) << "from the back";
  EXPECT_EQ(likelyFace(smallGrid(), {}, body, glm::dvec3(-1.0, 0.0, 0.0)), 1u) << "from the side";
}

TEST(FaceMarks, TellContactGapAndBelowApart) {
  const PlaneSkin skin;
  const SweepAxes axes = axesOfFaces(smallGrid(), {1, 0, 0})[5];
  const PlacingShape shape = placingShapeOf(smallGrid(), axes);
  const FilePlace flush = putOnSkin(shape, {}, skin, {{0, 0, 0}});
  const auto kinds = [&](double up_mm) {
    FilePlace moved = flush;
    moved.matrix[3].z += up_mm;
    std::set<FaceMark::Kind> all;
    const auto marks = faceMarksOf(shape, moved, skin, 50);
    EXPECT_EQ(marks.size(), 49u) << "one of each cell of 7 by 7";
    for (const FaceMark& each : marks) all.insert(each.kind);
    return all;
  };
  EXPECT_EQ(kinds(2.0), std::set{FaceMark::Kind::touching});
  EXPECT_EQ(kinds(4.0), std::set{FaceMark::Kind::above});
  EXPECT_EQ(kinds(-4.0), std::set{FaceMark::Kind::below});
}

TEST(ShapeOfVoxels, IsTheSameWhereverTheyWereRead) {
  Volume voxels;
  voxels.grid = smallGrid();
  voxels.echo.assign(voxels.grid.voxelCount(), 0);
  for (int k = 4; k < 20; ++k)
    for (int j = 6; j < 40; ++j)
      for (int i = 8; i < 26; ++i) voxels.echo[voxels.grid.indexOf(i, j, k)] = 90;
  const SweepAxes axes = axesOfFaces(voxels.grid, {-1, 0, 0})[2];
  const PlacingShape expected = placingShapeOf(voxels, axes);
  ASSERT_FALSE(expected.face_mm.empty());
  Volume elsewhere = voxels;
  elsewhere.grid =
      placed(voxels.grid, FilePlace{glm::rotate(glm::translate(glm::dmat4(1.0), {10, -70, 33}), 0.7, glm::dvec3(0.6, 0.0, 0.8))});
  const PlacingShape found = shapeOf(elsewhere, voxels.grid, axes);
  ASSERT_EQ(found.face_mm.size(), expected.face_mm.size());
  ASSERT_EQ(found.inside_mm.size(), expected.inside_mm.size());
  double farthest_mm = 0.0;
  for (std::size_t n = 0; n < found.face_mm.size(); ++n)
    farthest_mm = std::max(farthest_mm, glm::distance(found.face_mm[n], expected.face_mm[n]));
  EXPECT_LT(farthest_mm, 2.1) << "a voxel more or less where rounding decides";
}

TEST(ContactVerdict, SaysWhatIsToBeDone) {
  const auto verdict = [](double share, double gap_mm, double below_mm, double outside) {
    return verdictOf({.faceShare = share, .deepestGap_mm = gap_mm, .deepestIntrusion_mm = below_mm, .outsideShare = outside});
  };
  EXPECT_EQ(verdict(0.8, 4.0, 2.0, 0.0), ContactVerdict::good);
  EXPECT_EQ(verdict(0.7, 12.0, 12.0, 0.05), ContactVerdict::good) << "the corners of a large face may leave the skin";
  EXPECT_EQ(verdict(0.2, 30.0, 0.0, 0.05), ContactVerdict::standsOff);
  EXPECT_EQ(verdict(0.0, 49.0, 0.0, 0.6), ContactVerdict::standsOff) << "not turned round, but far off";
  EXPECT_EQ(verdict(0.0, 0.0, 40.0, 0.0), ContactVerdict::liesBelow);
  EXPECT_EQ(verdict(0.2, 23.0, 21.0, 0.08), ContactVerdict::tipped);
  EXPECT_EQ(verdict(0.9, 2.0, 2.0, 0.95), ContactVerdict::outside) << "the beams look away";
}

std::vector<DraftPair> truePairs(const FilePlace& place) {
  std::vector<DraftPair> pairs;
  for (const glm::dvec3& at :
       {glm::dvec3(-60, 10, 20), glm::dvec3(70, -5, 30), glm::dvec3(0, 40, -80), glm::dvec3(20, -30, 60), glm::dvec3(-30, 0, -40)})
    pairs.push_back({"place " + std::to_string(pairs.size() + 1), at, carried(place, at)});
  return pairs;
}

RC_GTEST_PROP(Pairs, PlaceTheVolumeAndNameTheWrongOneAmongIncompleteOnes, ()) {
  const FilePlace place{anyRigid()};
  auto pairs = truePairs(place);
  pairs.insert(pairs.begin() + 2, DraftPair{"half", glm::dvec3(1, 2, 3)});
  auto found = fitOf(pairs);
  RC_ASSERT(found.fit.has_value());
  RC_ASSERT(found.complete == 5u);
  RC_ASSERT(largestDifference(found.fit->fileToWorld.matrix, place.matrix) < 1e-6);
  RC_ASSERT(!found.residuals_mm[2].has_value());
  RC_ASSERT(!found.wrong.has_value());
  *pairs[4].world_mm += 60.0 * anyDirection();
  found = fitOf(pairs);
  RC_ASSERT(found.wrong == std::optional<std::size_t>(4));
  RC_ASSERT(found.worst == found.wrong);
  RC_ASSERT(std::abs(*found.residuals_mm[4] - 60.0) < 1e-3);
  RC_ASSERT(largestDifference(found.fit->fileToWorld.matrix, place.matrix) < 1e-6);
}

TEST(Pairs, TooFewOrOnALineAreASentence) {
  auto pairs = truePairs({});
  pairs[2].world_mm.reset();
  pairs.resize(3);
  EXPECT_FALSE(fitOf(pairs).fit.has_value());
  EXPECT_EQ(fitOf(pairs).complete, 2u);
  std::vector<DraftPair> line;
  for (const double x : {0.0, 30.0, 70.0}) line.push_back({"", glm::dvec3(x, 0, 0), glm::dvec3(x, 10, 0)});
  const auto found = fitOf(line);
  ASSERT_FALSE(found.fit.has_value());
  EXPECT_NE(found.fit.error().sentence().find("line"), std::string::npos) << found.fit.error().sentence();
}

TEST(Pairs, AreKeptInTheirSectionBesideWhatElseIsThere) {
  auto pairs = truePairs({});
  pairs[1].world_mm.reset();
  pairs[2].landmark = "xiphoid";
  pairs[3].name.clear();
  const auto section = withPairs(nlohmann::json{{"other", 4}}, pairs);
  ASSERT_TRUE(section.has_value());
  EXPECT_EQ((*section)["other"], 4);
  EXPECT_EQ(pairsIn(section), pairs);
  EXPECT_FALSE(withPairs(std::nullopt, {}).has_value());
  EXPECT_EQ(withPairs(section, {}), (nlohmann::json{{"other", 4}}));
  EXPECT_TRUE(pairsIn(nlohmann::json{{"pairs", "none"}}).empty());
  EXPECT_EQ(pairsIn(nlohmann::json{{"pairs", {1, nlohmann::json{{"file_mm", {1, "two", 3}}}}}}).size(), 1u);
  EXPECT_FALSE(nlohmann::json::parse(placingSchema(), nullptr, false).is_discarded());
}

}  // namespace
}  // namespace ew::case_authoring::placing_test
