#include <cmath>

#include "recipes.h"

namespace ew::frames_test {
namespace {

double distanceOf(const Result<std::shared_ptr<const Patient>>& patient, const std::string& organ, const glm::dvec3& p_mm) {
  EXPECT_TRUE(patient) << patient.error();
  return patient ? signedDistance_mm(**patient, organ, p_mm).value() : std::nan("");
}

// "outer" is turned by 90 degrees about z (its x is the world's y, its y the world's -x); "inner" lies 10 mm along outer x.
const std::string kFrames = R"("frames": [{"name": "outer", "origin_mm": [1, 2, 3], "turned_deg": [0, 0, 90]},
  {"name": "inner", "origin_mm": [10, 0, 0], "turned_deg": [90, 0, 0], "within": "outer"}],)";

TEST(DrawingFrame, PlacesAndTurnsWhatIsDrawnInIt) {
  const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "egg", "tissue": "dark", "shape": {"frame": "outer", "ellipsoid": {"centre_mm": [5, 0, 0], "radii_mm": [8, 3, 2]}}})",
      kFrames));
  EXPECT_NEAR(distanceOf(patient, "egg", {1, 2 + 5 + 8 + 4, 3}), 4.0, 1e-9) << "the long radius lies along the world's y";
  EXPECT_NEAR(distanceOf(patient, "egg", {1 - 3 - 4, 2 + 5, 3}), 4.0, 1e-9);
  EXPECT_NEAR(distanceOf(patient, "egg", {1, 2 + 5, 3 + 2 - 1}), -1.0, 1e-9);
}

TEST(DrawingFrame, WithinAnotherMovesWithIt) {
  const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "rod", "tissue": "dark", "shape": {"frame": "inner",
          "capsule": {"from_mm": [0, 0, 0], "to_mm": [0, 12, 0], "from_radius_mm": 2, "to_radius_mm": 2}}})",
      kFrames));
  // Inner y is outer z is the world's z; inner's origin is (1, 2 + 10, 3).
  EXPECT_NEAR(distanceOf(patient, "rod", {1, 12, 3 + 12 + 2}), 0.0, 1e-9);
  EXPECT_NEAR(distanceOf(patient, "rod", {1, 12, 3 - 2}), 0.0, 1e-9);
  EXPECT_NEAR(distanceOf(patient, "rod", {4, 12, 9}), 1.0, 1e-9);
}

TEST(DrawingFrame, MirrorsAtItsOwnMidline) {
  const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "eyes", "tissue": "dark", "shape": {"frame": "outer", "mirrored": true,
          "union": [{"ellipsoid": {"centre_mm": [7, 1, 0], "radii_mm": [3, 3, 3]}}]}})",
      kFrames));
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(distanceOf(patient, "eyes", {1 - 1, 2 + side * 7, 3}), -3.0, 1e-9) << side;
    EXPECT_NEAR(distanceOf(patient, "eyes", {1 - 1, 2 + side * 12, 3}), 2.0, 1e-9) << side;
  }
}

TEST(DrawingFrame, LeavesShapesThatAreNamedWhereTheyAre) {
  const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "yolk", "tissue": "dark", "shape": {"frame": "outer", "ellipsoid": {"centre_mm": [5, 0, 0], "radii_mm": [2, 2, 2]}}},
         {"name": "egg", "tissue": "smooth", "shape": {"frame": "outer", "union": [{"grown": {"of": "yolk", "by_mm": 3}}]}})",
      kFrames));
  EXPECT_NEAR(distanceOf(patient, "egg", {1, 7, 3}), -5.0, 1e-9);
}

TEST(DrawingFrame, ThatIsMissingIsNamed) {
  const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "egg", "tissue": "dark", "shape": {"frame": "nowhere", "ellipsoid": {"centre_mm": [5, 0, 0], "radii_mm": [8, 3, 2]}}})",
      kFrames));
  ASSERT_FALSE(patient);
  EXPECT_EQ(patient.error().code, ErrorCode::badField);
  EXPECT_NE(patient.error().sentence().find("nowhere"), std::string::npos) << patient.error();
  EXPECT_NE(patient.error().sentence().find("inner, outer"), std::string::npos) << patient.error();
}

}  // namespace
}  // namespace ew::frames_test
