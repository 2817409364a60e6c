#include "phantom/recipes.h"

#include <cmath>
#include <limits>

namespace ew::phantom_test {
namespace {

using testing::bodyOf;
using testing::bodyRecipe;
using testing::patientOf;
using testing::patientRecipe;

TEST(HardShapes, ABallThatHoldsTheOtherIsTheWholeCapsule) {
  const auto body = bodyOf(R"({"capsule": {"from_mm": [0, 0, 0], "to_mm": [5, 0, 0], "from_radius_mm": 20, "to_radius_mm": 3}})");
  EXPECT_NEAR(body->signedDistance_mm({0, 30, 0}), 10.0, 1e-9);
  EXPECT_NEAR(body->signedDistance_mm({30, 0, 0}), 10.0, 1e-9);
}

TEST(HardShapes, ATubeWhosePointsCoincideIsABall) {
  const auto body = bodyOf(R"({"tube": {"points": [[1, 2, 3, 4], [1, 2, 3, 4], [1, 2, 3, 4]]}})");
  EXPECT_NEAR(body->signedDistance_mm({1, 2, 13}), 6.0, 1e-9);
  EXPECT_NEAR(body->signedDistance_mm({1, 2, 3}), -4.0, 1e-9);
}

TEST(HardShapes, CentresAndAxesGiveFiniteDistances) {
  const auto egg = bodyOf(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [100, 0.02, 30]}})");
  EXPECT_NEAR(egg->signedDistance_mm({0, 0, 0}), -0.02, 1e-9);
  const auto loft = bodyOf(R"({"loft": {"sections": [{"z_mm": 0, "half_width_mm": 10, "front_mm": 5, "back_mm": 5},
    {"z_mm": 30, "half_width_mm": 10, "front_mm": 5, "back_mm": 5}]}})");
  EXPECT_NEAR(loft->signedDistance_mm({0, 0, 15}), -5.0, 1e-9);
  for (const double far : {1e6, -1e6, 1e9}) EXPECT_TRUE(std::isfinite(loft->signedDistance_mm({far, far, far})));
}

TEST(HardShapes, ALoftWhoseSplineWouldTurnInsideOutKeepsAPositiveWidth) {
  const auto loft = bodyOf(R"({"loft": {"sections": [{"z_mm": 0, "half_width_mm": 100, "front_mm": 100, "back_mm": 100},
    {"z_mm": 1, "half_width_mm": 1, "front_mm": 1, "back_mm": 1}, {"z_mm": 60, "half_width_mm": 1, "front_mm": 1, "back_mm": 1},
    {"z_mm": 61, "half_width_mm": 100, "front_mm": 100, "back_mm": 100}]}})");
  for (double z = 0.0; z < 61.0; z += 0.25) {
    const double d = loft->signedDistance_mm({50, 0, z});
    EXPECT_TRUE(std::isfinite(d)) << z;
    if (z > 5.0 && z < 56.0) {
      EXPECT_GT(d, 0.0) << z;
    }
  }
}

TEST(HardShapes, AnIntersectionOfPartsThatDoNotMeetIsEmpty) {
  const auto body = bodyOf(R"({"intersection": [{"ellipsoid": {"centre_mm": [-50, 0, 0], "radii_mm": [10, 10, 10]}},
    {"ellipsoid": {"centre_mm": [50, 0, 0], "radii_mm": [10, 10, 10]}}]})");
  for (double x = -70; x <= 70; x += 2.5) EXPECT_GT(body->signedDistance_mm({x, 0, 0}), 0.0);
}

TEST(HardShapes, ANestDeeperThanAllowedIsRefusedByName) {
  std::string shape = R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [1, 1, 1]}})";
  for (int n = 0; n < 40; ++n) shape = R"({"union": [)" + shape + "]}";
  const testing::Folder folder;
  const auto body = readBodyShape(folder.write("deep.json", bodyRecipe(shape)));
  ASSERT_FALSE(body);
  EXPECT_EQ(body.error().code, ErrorCode::badField);
  EXPECT_NE(body.error().sentence().find("nested too deeply"), std::string::npos) << body.error().sentence();
}

TEST(HardShapes, AMillionOpenBracketsAreRefusedBeforeTheStackIsUsedUp) {
  const testing::Folder folder;
  const auto file = folder.write("deep.json", bodyRecipe(std::string(1000000, '[') + std::string(1000000, ']')));
  EXPECT_EQ(readBodyShape(file).error().code, ErrorCode::badHeader);
  EXPECT_EQ(fingerprintOfPatient(file).error().code, ErrorCode::badHeader);
}

TEST(HardShapes, NumbersThatAreNoSizesAreRefused) {
  const testing::Folder folder;
  for (const char* radius : {"1e999", "-3", "null", "\"5\"", "1e6"}) {
    const auto body = readBodyShape(
        folder.write("body.json", bodyRecipe(std::string(R"({"capsule": {"from_mm": [0, 0, 0], "to_mm": [1, 0, 0], "from_radius_mm": )") +
                                             radius + R"(, "to_radius_mm": 1}})")));
    ASSERT_FALSE(body) << radius;
    EXPECT_TRUE(body.error().code == ErrorCode::badField || body.error().code == ErrorCode::badHeader) << body.error();
  }
}

TEST(HardPatients, ARecipeOfHundredsOfMegabytesIsRefusedBeforeItIsRead) {
  const testing::Folder folder;
  const auto file = folder.write("patient.json", "{}");
  std::filesystem::resize_file(file, 300ull << 20);
  const auto patient = readPatient(file);
  ASSERT_FALSE(patient);
  EXPECT_EQ(patient.error().code, ErrorCode::tooLarge);
}

TEST(HardPatients, AMannequinIsNeverReadFromAnotherFolder) {
  std::string recipe = patientRecipe(R"({"name": "all", "tissue": "dark", "shape": {"of": "skin surface"}})");
  recipe.replace(recipe.find("ball.json"), 9, "../../ball.json");
  const auto patient = patientOf(recipe);
  ASSERT_FALSE(patient);
  EXPECT_EQ(patient.error().code, ErrorCode::badField);
  EXPECT_NE(patient.error().sentence().find("mannequin"), std::string::npos);
}

TEST(HardPatients, ASpacingCoarserThanTheBoxGivesOneVoxel) {
  const auto patient = patientOf(patientRecipe(R"({"name": "all", "tissue": "smooth", "shape": {"of": "skin surface"}})"));
  ASSERT_TRUE(patient) << patient.error();
  const auto made = voxelise(**patient, {.spacing_mm = 500.0}, noProgress());
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(made->volume.grid.dims, glm::ivec3(1));
}

TEST(HardPatients, ASpacingThatIsNoLengthIsRefused) {
  const auto patient = patientOf(patientRecipe(R"({"name": "all", "tissue": "smooth", "shape": {"of": "skin surface"}})"));
  ASSERT_TRUE(patient) << patient.error();
  for (const double spacing : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto made = voxelise(**patient, {.spacing_mm = spacing}, noProgress());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::badField);
  }
}

TEST(HardPatients, AnOrganThinnerThanAVoxelKeepsItsLabelWhereAVoxelCentreLiesInIt) {
  const auto patient = patientOf(patientRecipe(
      R"({"name": "hair", "tissue": "smooth", "shape": {"capsule": {"from_mm": [-30, 0, 0], "to_mm": [30, 0, 0], "from_radius_mm": 0.05, "to_radius_mm": 0.05}}})"));
  ASSERT_TRUE(patient) << patient.error();
  const auto made = voxelise(**patient, {.spacing_mm = 1.0}, noProgress());
  ASSERT_TRUE(made);
  EXPECT_EQ(std::count(made->labels.begin(), made->labels.end(), std::uint8_t{1}), 61);
}

}  // namespace
}  // namespace ew::phantom_test
