#include "ew/phantom/truth.h"

#include <cmath>
#include <map>
#include <numbers>

#include "recipes.h"

namespace ew::truth_test {
namespace {

using testing::patientOf;
using testing::patientRecipe;

// A bent tube, an egg, a shell around it and a ball, in simple places.
const char* const kOrgans = R"(
  {"name": "pipe", "tissue": "dark", "shape": {"tube": {"points": [[-20, -20, -30, 4], [-20, -20, -10, 4], [-20, -20, 0, 6], [-20, -20, 10, 4], [-20, -20, 30, 4]]}}},
  {"name": "slanted pipe", "tissue": "dark", "shape": {"capsule": {"from_mm": [20, -30, -20], "to_mm": [20, -10, 20], "from_radius_mm": 5, "to_radius_mm": 5}}},
  {"name": "bent", "tissue": "dark", "shape": {"tube": {"points": [[20, 20, -30, 5], [20, 24, -10, 5], [20, 28, 10, 5], [20, 32, 30, 5]]}}},
  {"name": "yolk", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [12, 8, 10]}}},
  {"name": "egg", "tissue": "smooth", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [15, 10, 12]}}},
  {"name": "ball", "tissue": "smooth", "shape": {"ellipsoid": {"centre_mm": [-25, 20, 0], "radii_mm": [6, 6, 6]}}},
  {"name": "tilted egg", "tissue": "smooth", "shape": {"ellipsoid": {"centre_mm": [-20, 20, 25], "radii_mm": [10, 5, 5], "turned_deg": [0, 0, 30]}}})";

Result<std::vector<TrueMeasurement>> measured(const std::string& entry, const BodyState& state = {}, const std::string& extra = "") {
  const auto patient = patientOf(patientRecipe(kOrgans, R"("measurements": [{"name": "it", )" + entry + "}]," + extra));
  if (!patient) return tl::unexpected(patient.error());
  return measurementsOf(**patient, state);
}

double valueOf(const std::string& entry, const BodyState& state = {}, const std::string& extra = "") {
  const auto all = measured(entry, state, extra);
  if (!all) {
    ADD_FAILURE() << entry << all.error();
    return -1.0;
  }
  EXPECT_EQ(all->size(), 1u);
  if (all->front().points_mm.size() == 2 && all->front().kind != "extent") {
    EXPECT_NEAR(glm::distance(all->front().points_mm[0], all->front().points_mm[1]), all->front().value, 1e-9);
  }
  return all->front().value;
}

double ellipsePerimeter(double a, double b) {
  double sum = 0.0;
  constexpr int kSteps = 20000;
  for (int n = 0; n < kSteps; ++n) {
    const double t = 2.0 * std::numbers::pi * (n + 0.5) / kSteps;
    sum += std::hypot(a * std::sin(t), b * std::cos(t)) * 2.0 * std::numbers::pi / kSteps;
  }
  return sum;
}

TEST(Measurements, AreTheClosedFormsOfSimpleShapes) {
  const double tilted = 2.0 * std::sqrt(std::pow(10 * std::cos(std::numbers::pi / 6), 2) + std::pow(5 * std::sin(std::numbers::pi / 6), 2));
  const std::map<std::string, double> lengths{
      {R"("kind": "distance", "from_mm": [0, 0, 0], "to_mm": [3, 4, 12])", 13.0},
      {R"("kind": "distance", "of": "egg", "from_mm": [-30, 0, 0], "to_mm": [30, 0, 0])", 30.0},
      {R"("kind": "distance", "from_surface": "egg", "to_surface": "yolk", "from_mm": [0, -30, 0], "to_mm": [0, 30, 0])", 18.0},
      {R"("kind": "distance", "gap_between": ["ball", "tilted egg"], "from_mm": [-20, 20, 0], "to_mm": [-20, 20, 40])",
       20.0 - std::sqrt(11.0)},
      {R"("kind": "diameter", "of": "ball", "at_mm": [-25, 20, 0])", 12.0},
      {R"("kind": "diameter", "of": "pipe", "at_mm": [-17, -20, 20])", 8.0},
      {R"("kind": "diameter", "of": "pipe", "place": "largest")", 12.0},
      {R"("kind": "diameter", "of": "pipe", "place": "smallest", "from_mm": [-20, -20, -25], "to_mm": [-20, -20, 25])", 8.0},
      {R"("kind": "diameter", "of": "bent", "at_mm": [20, 26, 0])", 10.0},
      {R"("kind": "diameter", "of": "bent", "at_mm": [20, 26, 0], "direction": [1, 0, 0])", 10.0},
      {R"("kind": "extent", "of": "egg", "direction": [1, 0, 0])", 30.0},
      {R"("kind": "extent", "of": "egg", "direction": [0, 0, 2])", 24.0},
      {R"("kind": "extent", "of": "tilted egg", "direction": [1, 0, 0])", tilted},
      {R"("kind": "extent", "of": ["egg", "ball"], "direction": [1, 0, 0])", 46.0},
      {R"("kind": "circumference", "of": "egg", "at_mm": [1, 1, 0])", ellipsePerimeter(15, 10)},
      {R"("kind": "circumference", "of": "egg", "at_mm": [0, 0, 0], "normal": [1, 0, 0])", ellipsePerimeter(10, 12)}};
  for (const auto& [entry, value] : lengths) EXPECT_NEAR(valueOf(entry), value, 0.05) << entry;
}

TEST(Measurements, OfVolumesAreThoseAnOrganOwns) {
  const double egg = 4.0 / 3.0 * std::numbers::pi * 15 * 10 * 12 / 1000.0, yolk = 4.0 / 3.0 * std::numbers::pi * 12 * 8 * 10 / 1000.0;
  EXPECT_NEAR(valueOf(R"("kind": "volume", "of": "yolk")"), yolk, 0.01 * yolk);
  EXPECT_NEAR(valueOf(R"("kind": "volume", "of": "egg")"), egg - yolk, 0.01 * egg) << "the yolk comes first";
  EXPECT_NEAR(valueOf(R"("kind": "volume", "of": ["egg", "yolk"])"), egg, 0.01 * egg);
}

TEST(Measurements, FollowBreathAndPulse) {
  const std::string moving = R"("motion": {"pulse": {"vessels": [{"of": "bent", "diameter_growth_mm": 2, "reach_mm": 10}]},
    "breathing": {"displacement_mm": [0, 0, -4], "held_depth_mm": 1, "free_depth_mm": 12}},)";
  // The pulse widens within the horizontal plane, the diameter is square to the line: 10 mm across, whichever way the line leans.
  EXPECT_NEAR(valueOf(R"("kind": "diameter", "of": "bent", "at_mm": [20, 26, 0], "direction": [1, 0, 0])", {0.0, 1.0}, moving), 12.0, 0.1);
  EXPECT_NEAR(valueOf(R"("kind": "diameter", "of": "bent", "at_mm": [20, 26, 0], "direction": [1, 0, 0])", {1.0, 1.0}, moving), 12.0, 0.1);
  const auto resting = measured(R"("kind": "diameter", "of": "ball", "at_mm": [-25, 20, 0])", {}, moving);
  const auto breathing = measured(R"("kind": "diameter", "of": "ball", "at_mm": [-25, 20, 0])", {1.0, 0.0}, moving);
  ASSERT_TRUE(resting && breathing);
  EXPECT_NEAR(breathing->front().points_mm[0].z, resting->front().points_mm[0].z - 4.0, 0.1);
  EXPECT_NEAR(breathing->front().value, 12.0, 0.05);
}

TEST(Measurements, ThatCannotBeTakenSayWhy) {
  const std::map<std::string, std::string> wrong{
      {R"("kind": "distance", "of": "egg", "from_mm": [-30, 50, 0], "to_mm": [30, 50, 0])", "does not cross"},
      {R"("kind": "diameter", "of": "ball", "at_mm": [0, 0, 0])", "does not lie inside"},
      {R"("kind": "circumference", "of": "ball", "at_mm": [0, 0, 0])", "does not lie inside"},
      {R"("kind": "diameter", "of": "bent", "at_mm": [20, 26, 0], "direction": [0, 4, 20])", "along the direction"},
      {R"("kind": "distance", "gap_between": ["ball", "egg"], "from_mm": [-20, 20, 0], "to_mm": [-20, 20, 40])", "does not enter egg"},
      {R"("kind": "diameter", "of": "liver", "at_mm": [0, 0, 0])", "the name of a shape or organ"},
      {R"("kind": "diameter", "of": "egg", "place": "largest")", "a tube"},
      {R"("kind": "angle", "of": "egg")", "\"distance\", \"diameter\""},
      {R"("kind": "volume")", "the name of a shape"},
      {R"("kind": "distance", "from_mm": [0, 0, 0])", "two places"},
      {R"("kind": "volume", "of": "egg", "plane": "none")", "one of the planes"}};
  for (const auto& [entry, why] : wrong) {
    const auto all = measured(entry);
    ASSERT_FALSE(all) << entry;
    EXPECT_NE(all.error().sentence().find(why), std::string::npos) << all.error().sentence();
  }
}

TEST(StandardPlanes, HaveTheFaceOnTheSkinLookingWhereTheRecipeSays) {
  const auto patient = patientOf(patientRecipe(kOrgans, R"("planes": [
    {"name": "aimed", "near_mm": [5, -50, 3], "towards_mm": [0, 0, 0], "lateral": [0, 0, 1], "shows": ["egg"]},
    {"name": "straight", "near_mm": [0, 70, 0], "angle_tolerance_deg": 5}],)"));
  ASSERT_TRUE(patient) << patient.error();
  const auto planes = planesOf(**patient);
  ASSERT_EQ(planes.size(), 2u);
  for (const StandardPlane& plane : planes) {
    const glm::dmat4& pose = plane.probeToWorld.matrix;
    EXPECT_TRUE(checkRigid(pose)) << plane.name;
    EXPECT_NEAR(signedDistance_mm(**patient, "skin surface", glm::dvec3(pose[3])).value(), 0.0, 1e-3);
  }
  const glm::dmat4& aimed = planes[0].probeToWorld.matrix;
  EXPECT_LT(glm::distance(glm::dvec3(aimed[1]), -glm::normalize(glm::dvec3(5, -50, 3))), 1e-9);
  EXPECT_GT(aimed[0].z, 0.99);
  EXPECT_LT(glm::distance(glm::dvec3(planes[1].probeToWorld.matrix[1]), glm::dvec3(0, -1, 0)), 0.02);
  EXPECT_EQ(planes[1].angleTolerance_deg, 5.0);
  for (const char* wrong : {R"({"name": "far", "near_mm": [0, -2000, 0], "towards_mm": [0, -3000, 0]})",
                            R"({"name": "along", "near_mm": [0, -60, 0], "towards_mm": [0, 0, 0], "lateral": [0, 1, 0]})",
                            R"({"name": "shows", "near_mm": [0, -60, 0], "shows": ["liver"]})"})
    EXPECT_FALSE(patientOf(patientRecipe(kOrgans, R"("planes": [)" + std::string(wrong) + "],"))) << wrong;
}

class Surfaces : public ::testing::TestWithParam<std::string> {};

TEST_P(Surfaces, AreClosedLookOutwardsAndLieOnTheShape) {
  const auto patient = patientOf(patientRecipe(kOrgans));
  ASSERT_TRUE(patient) << patient.error();
  const auto mesh = surfaceOf(**patient, GetParam(), 1.3, noProgress());
  ASSERT_TRUE(mesh) << mesh.error();
  ASSERT_GT(mesh->triangles.size(), 100u);
  std::map<std::pair<int, int>, int> edges;
  double volume = 0.0;
  for (const glm::ivec3& t : mesh->triangles) {
    for (int n = 0; n < 3; ++n) ++edges[{t[n], t[(n + 1) % 3]}];
    const auto at = [&](int n) { return glm::dvec3(mesh->points_mm[static_cast<std::size_t>(n)]); };
    volume += glm::dot(at(t.x), glm::cross(at(t.y), at(t.z))) / 6.0;
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << "each edge is run through once in each direction";
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  const auto euler =
      static_cast<long>(mesh->points_mm.size()) - static_cast<long>(edges.size() / 2) + static_cast<long>(mesh->triangles.size());
  EXPECT_EQ(euler, 2) << "a ball has no handles";
  EXPECT_GT(volume, 0.0);
  for (std::size_t n = 0; n < mesh->points_mm.size(); ++n) {
    EXPECT_NEAR(signedDistance_mm(**patient, GetParam(), glm::dvec3(mesh->points_mm[n])).value(), 0.0, 1e-3);
    EXPECT_NEAR(glm::length(mesh->normals[n]), 1.0F, 1e-4F);
  }
  if (GetParam() == "egg") {
    EXPECT_NEAR(volume, 4.0 / 3.0 * std::numbers::pi * 15 * 10 * 12, 0.01 * 7540);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Surfaces, ::testing::Values("egg", "ball", "bent", "pipe", "tilted egg"), [](const auto& found) {
  std::string name = found.param;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(Surfaces, ThatCannotBeMadeSayWhy) {
  const auto patient = patientOf(patientRecipe(kOrgans));
  ASSERT_TRUE(patient);
  EXPECT_EQ(surfaceOf(**patient, "liver", 1.0, noProgress()).error().code, ErrorCode::badField);
  EXPECT_EQ(surfaceOf(**patient, "egg", std::nan(""), noProgress()).error().code, ErrorCode::badField);
  EXPECT_EQ(surfaceOf(**patient, "skin surface", 0.01, noProgress()).error().code, ErrorCode::tooLarge);
}

}  // namespace
}  // namespace ew::truth_test
