// Shapes that grow or are uneven by themselves: trees of vessels, rough surfaces, sheets, septa, patches.
#include <gtest/gtest.h>
// gtest before rapidcheck: its header relies on it
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "recipes.h"
#include "shapes/uneven_shapes.h"
#include "shapes/vessel_tree.h"

namespace ew::phantom::grown_shapes_test {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

VesselGrowth growthInAnEgg(std::uint64_t seed, int ends) {
  VesselGrowth growth;
  growth.within = makeEllipsoid({.centre_mm = {0, 0, 0}, .radii_mm = {60, 40, 50}});
  growth.trunks = {{{0, 50, 0}, {0, 20, 0}, {-20, 5, 0}, {-35, 0, 8}}, {{0, 20, 0}, {18, 5, -5}, {35, -5, -5}}};
  growth.ends = ends;
  growth.seed = seed;
  return growth;
}

std::vector<std::vector<std::size_t>> childrenOf(const VesselTree& tree) {
  std::vector<std::vector<std::size_t>> children(tree.branches.size());
  for (std::size_t n = 0; n < tree.branches.size(); ++n)
    if (tree.branches[n].parent >= 0) children[static_cast<std::size_t>(tree.branches[n].parent)].push_back(n);
  return children;
}

int endsOf(const VesselTree& tree) {
  const auto children = childrenOf(tree);
  return static_cast<int>(std::count_if(children.begin(), children.end(), [](const auto& each) { return each.empty(); }));
}

double angleBetween_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0)) / kDegree;
}

double distanceToCapsule_mm(const glm::dvec3& p, const VesselBranch& branch) {
  const glm::dvec3 along = branch.to_mm - branch.from_mm;
  const double t = std::clamp(glm::dot(p - branch.from_mm, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(p, branch.from_mm + t * along) - branch.radius_mm;
}

glm::dvec3 anyPoint(double reach_mm) {
  const auto number = [&] { return *rc::gen::inRange(-1000, 1000) * reach_mm / 1000.0; };
  return {number(), number(), number()};
}

ShapePtr ballAt(const glm::dvec3& centre_mm, double radius_mm) {
  return makeEllipsoid({.centre_mm = centre_mm, .radii_mm = glm::dvec3(radius_mm)});
}

/// One of each kind whose distances are exact, or no farther than they say.
std::vector<std::pair<const char*, ShapePtr>> shapesOfEveryKind() {
  const VesselGrowth growth = growthInAnEgg(5, 24);
  const ShapePtr tree = makeVesselTree(growVesselTree(growth), growth.seed);
  const ShapePtr tube = makeTube({{-40, 0, 0}, {-10, 20, 5}, {10, -20, -5}, {30, 10, 20}, {45, 0, -20}}, {3, 5, 4, 6, 2});
  const ShapePtr cone = makeRoundCone({.from_mm = {-20, 5, 0}, .to_mm = {30, -10, 8}, .fromRadius_mm = 14, .toRadius_mm = 5});
  DrawingFrame frame;
  frame.origin_mm = {5, -8, 3};
  frame.axes = {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  return {{"tree", tree},
          {"tube", tube},
          {"cone", cone},
          {"placed tube", makePlaced(tube, frame)},
          {"mirrored ball", makeMirrored(ballAt({25, 0, 0}, 12), 4.0)},
          {"grown tree", makeOffset(tree, 1.5)},
          {"shrunk ball", makeOffset(ballAt({3, 2, 1}, 30), -6.0)},
          {"shell", makeShell(ballAt({0, 0, 0}, 35), 2.0, 6.0)},
          {"union", makeUnion({{tube, 0.0}, {ballAt({-20, 10, 0}, 12), 6.0}, {ballAt({40, 10, 5}, 8), 3.0}})},
          {"intersection", makeIntersection({{ballAt({0, 0, 0}, 30), 0.0}, {ballAt({20, 0, 0}, 30), 4.0}})},
          {"difference", makeDifference({{ballAt({0, 0, 0}, 30), 0.0}, {tube, 3.0}, {cone, 0.0}})},
          {"rough tube", makeRough(tube, {.amplitude_mm = 1.5, .length_mm = 9.0, .seed = 3})}};
}

RC_GTEST_PROP(Shapes, KnowTheirDistanceUpToWhatIsAskedAndNoLessBeyond, ()) {
  static const auto shapes = shapesOfEveryKind();
  const glm::dvec3 p = anyPoint(80.0);
  const double most_mm = *rc::gen::inRange(1, 400) / 20.0;
  for (const auto& [name, shape] : shapes) {
    const double whole = shape->distance_mm(p), found = shape->distanceUpTo_mm(p, most_mm);
    if (whole < most_mm)
      RC_ASSERT(found == whole);
    else
      RC_ASSERT(found >= most_mm - 1e-9);
  }
}

TEST(VesselTree, OfOneStraightTrunkIsExactlyACapsule) {
  VesselGrowth growth = growthInAnEgg(1, 1);
  growth.trunks = {{{-20, 1, 2}, {22, 1, 2}}};
  growth.endRadius_mm = 2.5;
  const ShapePtr shape = makeVesselTree(growVesselTree(growth), growth.seed);
  for (const glm::dvec3 p : {glm::dvec3(0, 1, 2), glm::dvec3(3, 9, -4), glm::dvec3(-40, 1, 2), glm::dvec3(30, 30, 30)})
    EXPECT_NEAR(shape->distance_mm(p), distanceToCapsule_mm(p, {{-20, 1, 2}, {22, 1, 2}, 2.5}), 1e-9);
}

RC_GTEST_PROP(VesselTree, FindsTheNearestOfManyBranchesExactly, ()) {
  VesselTree tree;
  const int count = *rc::gen::inRange(1, 60);
  for (int n = 0; n < count; ++n) {
    const glm::dvec3 from = anyPoint(50);
    tree.branches.push_back({from, from + anyPoint(10) + glm::dvec3(0, 0, 20), 0.5 + 0.1 * n});
  }
  const ShapePtr shape = makeVesselTree(tree, 3);
  for (int asked = 0; asked < 20; ++asked) {
    const glm::dvec3 p = anyPoint(120);
    double nearest = std::numeric_limits<double>::infinity();
    for (const VesselBranch& branch : tree.branches) nearest = std::min(nearest, distanceToCapsule_mm(p, branch));
    RC_ASSERT(std::abs(shape->distance_mm(p) - nearest) < 1e-9);
    RC_ASSERT(shape->atLeast_mm(p) <= std::max(0.0, nearest) + 1e-9);
  }
}

RC_GTEST_PROP(VesselTree, HoldsMurraysLawAndItsAnglesAtEveryForkWithinItsOrgan, ()) {
  const VesselGrowth growth = growthInAnEgg(*rc::gen::inRange<std::uint64_t>(0, 1000000), *rc::gen::inRange(3, 120));
  const VesselTree tree = growVesselTree(growth);
  RC_ASSERT((tree == growVesselTree(growth)));
  RC_ASSERT(endsOf(tree) == growth.ends);
  const auto children = childrenOf(tree);
  for (std::size_t n = 0; n < tree.branches.size(); ++n) {
    const VesselBranch& branch = tree.branches[n];
    double cubes = 0.0;
    for (const std::size_t child : children[n]) {
      cubes += std::pow(tree.branches[child].radius_mm, 3);
      RC_ASSERT(tree.branches[child].from_mm == branch.to_mm);
    }
    RC_ASSERT(std::abs(branch.radius_mm - (children[n].empty() ? growth.endRadius_mm : std::cbrt(cubes))) < 1e-6);
    if (children[n].size() == 2) {
      const VesselBranch &a = tree.branches[children[n][0]], &b = tree.branches[children[n][1]];
      const double angle = angleBetween_deg(a.to_mm - a.from_mm, b.to_mm - b.from_mm);
      RC_ASSERT((a.drawn && b.drawn) || (angle > 29.9 && angle < 80.1));
    }
    RC_ASSERT(branch.drawn || growth.within->distance_mm(branch.to_mm) < 0.0);
  }
}

TEST(VesselTree, GrowsAroundAnotherOneAndLeavesNoPartOfItsOrganWithoutABranch) {
  VesselGrowth growth = growthInAnEgg(5, 150);
  const ShapePtr first = makeVesselTree(growVesselTree(growth), growth.seed);
  VesselGrowth second = growthInAnEgg(6, 100);
  second.trunks = {{{0, -2, 60}, {0, -2, 30}, {-12, -8, 20}}};
  second.avoid = {first};
  const VesselTree between = growVesselTree(second);
  EXPECT_EQ(endsOf(between), 100);
  for (const VesselBranch& branch : between.branches)
    if (!branch.drawn) {
      EXPECT_GT(first->distance_mm(branch.to_mm), branch.radius_mm) << "what was clear stays clear as it widens";
    }
  // No place deeper than the margin is farther from the first tree than a few times the distance of evenly spread ends.
  double farthest = 0.0;
  for (double x = -60; x <= 60; x += 4)
    for (double y = -40; y <= 40; y += 4)
      for (double z = -50; z <= 50; z += 4)
        if (growth.within->distance_mm({x, y, z}) < -growth.margin_mm) farthest = std::max(farthest, first->distance_mm({x, y, z}));
  EXPECT_LT(farthest, 22.0);
}

TEST(VesselTree, HasFewerEndsWhereItsOrganHasNoRoomForMore) {
  VesselGrowth growth = growthInAnEgg(3, 1000);
  growth.clearance_mm = 40.0;
  growth.avoid = {makeRoundCone({.from_mm = {60, 0, 0}, .to_mm = {60, 1, 0}, .fromRadius_mm = 1.0, .toRadius_mm = 1.0})};
  const VesselTree crowded = growVesselTree(growth);
  EXPECT_GE(endsOf(crowded), 2) << "those of the trunks";
  EXPECT_LT(endsOf(crowded), 200);
  growth.within = makeEllipsoid({.centre_mm = {500, 0, 0}, .radii_mm = {2, 2, 2}});
  EXPECT_EQ(endsOf(growVesselTree(growth)), 2) << "an organ elsewhere: only the trunks";
}

TEST(VesselTree, IsFiniteEverywhereAndItsSurfaceHasNoHolesAtForks) {
  const VesselTree tree = growVesselTree(growthInAnEgg(9, 200));
  const ShapePtr shape = makeVesselTree(tree, 9);
  for (const VesselBranch& branch : tree.branches) {
    EXPECT_LT(shape->distance_mm(branch.from_mm), 0.0);
    EXPECT_LT(shape->distance_mm(branch.to_mm), 0.0);
  }
  for (double x = -90; x <= 90; x += 7)
    for (double z = -90; z <= 90; z += 7) EXPECT_TRUE(std::isfinite(shape->distance_mm({x, 0.3 * x, z})));
}

TEST(VesselsBeside, RunAlongWideBranchesOnlyAndOutsideThem) {
  const VesselTree tree = growVesselTree(growthInAnEgg(2, 200));
  const VesselsBeside beside{.ratio = 0.4, .leastRadius_mm = 1.5, .gap_mm = 0.3, .side = {0, 0, 1}};
  const VesselTree company = vesselsBeside(tree, beside);
  const auto wide = std::count_if(tree.branches.begin(), tree.branches.end(), [](const auto& each) { return each.radius_mm >= 1.5; });
  EXPECT_EQ(static_cast<std::ptrdiff_t>(company.branches.size()), wide);
  std::map<double, int> radii;
  for (const VesselBranch& branch : tree.branches) ++radii[branch.radius_mm];
  for (const VesselBranch& branch : company.branches) {
    EXPECT_TRUE(
        std::any_of(radii.begin(), radii.end(), [&](const auto& of) { return std::abs(branch.radius_mm - 0.4 * of.first) < 1e-12; }));
    EXPECT_GE(branch.radius_mm, 0.4 * 1.5);
  }
}

RC_GTEST_PROP(Rough, MovesTheSurfaceByItsAmplitudeAtMost, ()) {
  static const ShapePtr ball = makeEllipsoid({.centre_mm = {0, 0, 0}, .radii_mm = {30, 30, 30}});
  static const ShapePtr rough = makeRough(ball, {.amplitude_mm = 2.0, .length_mm = 8.0, .seed = 4});
  const glm::dvec3 p = anyPoint(60);
  const double d = ball->distance_mm(p), moved = rough->distance_mm(p);
  RC_ASSERT(std::isfinite(moved));
  RC_ASSERT(d < 2.0 || moved > 0.0);
  RC_ASSERT(d > -2.0 || moved < 0.0);
  RC_ASSERT(rough->atLeast_mm(p) <= std::max(0.0, moved) + 1e-9);
}

TEST(Rough, ChangesTheSurfaceBothWaysByAboutWhatItSays) {
  const ShapePtr flat = makeHalfSpace({0, 0, 0}, {0, 0, 1});
  const ShapePtr rough = makeRough(flat, {.amplitude_mm = 1.0, .length_mm = 6.0, .seed = 4});
  double lowest = 0.0, highest = 0.0;
  for (double x = 0; x < 200; x += 3.1) {
    double z = 1.5;
    while (z > -1.5 && rough->distance_mm({x, 0.7 * x, z}) > 0.0) z -= 0.01;
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
  }
  EXPECT_GT(highest, 0.5);
  EXPECT_LE(highest, 1.01);
  EXPECT_LT(lowest, -0.5);
  EXPECT_GE(lowest, -1.02);
}

/// Depths at which a line into a flat body meets sheets or septa.
std::vector<double> metAlong(const Shape& shape, double x, double z, double to_mm) {
  std::vector<double> met;
  bool inside = false;
  for (double depth = 0.0; depth < to_mm; depth += 0.02) {
    const bool now = shape.distance_mm({x, depth, z}) < 0.0;
    if (now && !inside) met.push_back(depth);
    inside = now;
  }
  return met;
}

TEST(Sheets, LieBetweenTheirDepthsAtTheirMeanSpacingAndUndulate) {
  const ShapePtr skin = makeHalfSpace({0, 0, 0}, {0, -1, 0});
  const Sheets flat{
      .fromDepth_mm = 5, .toDepth_mm = 205, .spacing_mm = 2.5, .thickness_mm = 0.4, .undulation_mm = 0.0, .missing = 0.0, .seed = 3};
  const auto met = metAlong(*makeSheets(skin, flat), 0, 0, 220);
  ASSERT_GT(met.size(), 20u);
  EXPECT_NEAR(met.front(), 4.8, 0.03);
  EXPECT_NEAR((met.back() - met.front()) / static_cast<double>(met.size() - 1), 2.5, 0.35);
  Sheets one = flat;
  one.toDepth_mm = 5.1;
  one.undulation_mm = 0.6;
  const ShapePtr undulating = makeSheets(skin, one);
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (double x = 0; x < 3000; x += 37) {
    const auto depths = metAlong(*undulating, x, 0.31 * x, 12);
    ASSERT_EQ(depths.size(), 1u) << x;
    sum += depths[0];
    squares += depths[0] * depths[0];
    ++count;
  }
  EXPECT_NEAR(std::sqrt(squares / count - std::pow(sum / count, 2)), 0.6, 0.2);
}

TEST(Sheets, MissWhatTheyAreToldTo) {
  const ShapePtr skin = makeHalfSpace({0, 0, 0}, {0, -1, 0});
  for (const double missing : {0.0, 0.25, 0.5}) {
    const ShapePtr sheet = makeSheets(skin, {.fromDepth_mm = 5, .toDepth_mm = 5.1, .undulation_mm = 0.0, .missing = missing, .seed = 8});
    int there = 0, asked = 0;
    for (double x = 0; x < 3000; x += 11)
      for (double z = 0; z < 300; z += 29, ++asked) there += sheet->distance_mm({x, 5, z}) < 0.0;
    EXPECT_NEAR(1.0 - static_cast<double>(there) / asked, missing, 0.08);
  }
}

TEST(Septa, CloseLobulesOfTheSizeAskedFor) {
  const ShapePtr skin = makeHalfSpace({0, -110, 0}, {0, -1, 0});
  const ShapePtr septa = makeSepta(skin, {.fromDepth_mm = 2, .toDepth_mm = 60, .lobule_mm = {14, 5, 14}, .thickness_mm = 0.5, .seed = 2});
  // Along z a wall every two thirds of a lobule or so: a line cuts many of them off centre.
  int walls = 0;
  bool inside = false;
  for (double z = 0; z < 2000; z += 0.1) {
    const bool now = septa->distance_mm({0, -90, z}) < 0.0;
    walls += now && !inside;
    inside = now;
  }
  EXPECT_NEAR(2000.0 / walls, 10.0, 3.5);
  EXPECT_GT(septa->distance_mm({0, -109, 0}), 0.9) << "none above them";
  EXPECT_GT(septa->distance_mm({0, -40, 0}), 0.9) << "none below";
}

TEST(Patches, FillTheirShare) {
  for (const double share : {0.2, 0.5, 0.8}) {
    const ShapePtr patches = makePatches({.size_mm = glm::dvec3(5.0), .share = share, .seed = 6});
    int in = 0, asked = 0;
    for (double x = 0; x < 200; x += 3.3)
      for (double y = 0; y < 200; y += 3.3)
        for (double z = 0; z < 60; z += 3.3, ++asked) in += patches->distance_mm({x, y, z}) < 0.0;
    EXPECT_NEAR(static_cast<double>(in) / asked, share, 0.06);
  }
}

std::string organOf(const std::string& shape) {
  return R"({"name": "egg", "tissue": "smooth", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [30, 30, 30]}}},
    {"name": "it", "tissue": "dark", "shape": )" +
         shape + "}";
}

TEST(GrownShapes, AreReadFromRecipes) {
  for (const char* shape :
       {R"({"vessel_tree": {"within": "egg", "trunks": [{"points": [[0, 0, -35], [0, 0, 0]]}], "ends": 20, "seed": 4}})",
        R"({"rough": {"of": "egg", "amplitude_mm": 1, "length_mm": 9}})",
        R"({"sheets": {"of": "skin surface", "from_depth_mm": 2, "to_depth_mm": 12, "spacing_mm": 2.5}})",
        R"({"septa": {"of": "skin surface", "from_depth_mm": 2, "to_depth_mm": 12, "lobule_mm": [12, 5, 12]}})",
        R"({"patches": {"size_mm": [6, 6, 6], "share": 0.4}})"}) {
    const auto patient = testing::patientOf(testing::patientRecipe(organOf(shape)));
    ASSERT_TRUE(patient) << patient.error();
    EXPECT_TRUE(std::isfinite(signedDistance_mm(**patient, "it", {1, 2, 3}).value()));
  }
}

TEST(GrownShapes, AreRefusedWithASentenceWhereTheyCannotBeMade) {
  const std::map<std::string, std::string> recipes{
      {"organs[1] (it).shape.vessel_tree.ends",
       R"({"vessel_tree": {"within": "egg", "trunks": [{"points": [[0, 0, -35], [0, 0, 0]]}], "ends": 5000}})"},
      {"organs[1] (it).shape.vessel_tree.trunks[0].points[1]",
       R"({"vessel_tree": {"within": "egg", "trunks": [{"points": [[0, 0, -35], [0, 0, -35]]}], "ends": 5}})"},
      {"organs[1] (it).shape.vessel_tree.avoid[0]",
       R"({"vessel_tree": {"within": "egg", "avoid": ["x"], "trunks": [{"points": [[0, 0, -35], [0, 0, 0]]}], "ends": 5}})"},
      {"organs[1] (it).shape.vessels_beside.of", R"({"vessels_beside": {"of": "egg"}})"},
      {"organs[1] (it).shape.rough.amplitude_mm", R"({"rough": {"of": "egg", "amplitude_mm": 5, "length_mm": 9}})"},
      {"organs[1] (it).shape.sheets.to_depth_mm", R"({"sheets": {"of": "egg", "from_depth_mm": 5, "to_depth_mm": 5}})"},
      {"organs[1] (it).shape.septa.lobule_mm", R"({"septa": {"of": "egg", "from_depth_mm": 1, "to_depth_mm": 5, "lobule_mm": [1, 0, 1]}})"},
      {"organs[1] (it).shape.patches.size_mm", R"({"patches": {"size_mm": [1, 1, 0]}})"}};
  for (const auto& [field, shape] : recipes) {
    const auto patient = testing::patientOf(testing::patientRecipe(organOf(shape)));
    ASSERT_FALSE(patient) << field;
    EXPECT_NE(patient.error().sentence().find(field), std::string::npos) << patient.error();
  }
}

}  // namespace
}  // namespace ew::phantom::grown_shapes_test
