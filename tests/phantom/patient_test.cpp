#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "recipes.h"

namespace ew::patient_test {
namespace {

using testing::patientOf;
using testing::patientRecipe;
using testing::shipped;

double distanceTo(const std::string& organ, const glm::dvec3& p) {
  const auto d = signedDistance_mm(shipped(), organ, p);
  EXPECT_TRUE(d) << d.error();
  return d.value_or(1e9);
}

int labelOf(const Patient& patient, const std::string& organ) {
  for (const OrganName& each : organsOf(patient)) {
    if (each.name == organ) return each.label;
  }
  ADD_FAILURE() << "no organ " << organ;
  return -1;
}

/// The shipped patient at 2 mm: labels only matter, so one seed serves all tests.
const VoxelPatient& shippedVoxels() {
  static const auto made = voxelise(shipped(), {.spacing_mm = 2.0, .threads = 2}, noProgress());
  if (!made) {
    ADD_FAILURE() << made.error();
    std::abort();
  }
  return *made;
}

template <class Visit>
void forVoxelsOf(const std::string& organ, const Visit& visit) {
  const Grid& grid = shippedVoxels().volume.grid;
  const int label = labelOf(shipped(), organ);
  std::size_t count = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        if (shippedVoxels().labels[grid.indexOf(i, j, k)] == label) {
          visit(grid.origin_mm + grid.spacing_mm * glm::dvec3(i, j, k));
          ++count;
        }
  EXPECT_GT(count, 0u) << organ << " has no voxel";
}

double millilitres(const std::string& organ) {
  std::size_t count = 0;
  forVoxelsOf(organ, [&](const glm::dvec3&) { ++count; });
  return static_cast<double>(count) * 8.0 / 1000.0;
}

TEST(ShippedPatient, HasEveryOrganOfTheUpperAbdomen) {
  for (const char* organ : {"skin", "subcutaneous fat", "liver", "gall bladder lumen", "gall bladder wall", "gall stone", "portal vein",
                            "hepatic veins", "inferior vena cava", "aorta", "right kidney", "right kidney sinus", "left kidney", "spleen",
                            "pancreas", "stomach wall", "diaphragm", "ribs 8", "vertebral body 3"})
    EXPECT_GT(millilitres(organ), 0.1) << organ;
}

TEST(ShippedPatient, HasOrgansOfTheSizesItsSourcesState) {
  EXPECT_NEAR(millilitres("liver"), 1450.0, 250.0);
  // A kidney is an ellipsoid of 110 x 55 x 45 mm less nothing: cortex, pyramids and sinus fill it, its own vessels take a little.
  const double kidney = millilitres("right kidney") + millilitres("right kidney sinus") + millilitres("right kidney pyramids");
  EXPECT_NEAR(kidney, 4.0 / 3.0 * std::numbers::pi * 55.0 * 27.5 * 22.5 / 1000.0, 5.0);
  EXPECT_NEAR(millilitres("gall stone"), 4.0 / 3.0 * std::numbers::pi * 6.0 * 5.4 * 5.6 / 1000.0, 0.1);
  double low = 1e9, high = -1e9;
  forVoxelsOf("liver", [&](const glm::dvec3& p) {
    if (std::abs(p.x + 85.0) > 3.0) return;
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  });
  EXPECT_NEAR(high - low, 150.0, 15.0) << "liver in the midclavicular line";
  // Lumen widths on a line from side to side through the vessel.
  const auto width = [](const std::string& organ, const glm::dvec3& centre) {
    double sum = 0.0;
    for (const double side : {-1.0, 1.0}) {
      double reach = 0.0;
      while (distanceTo(organ, centre + glm::dvec3(side * reach, 0, 0)) < 0.0) reach += 0.05;
      sum += reach;
    }
    return sum;
  };
  EXPECT_NEAR(width("aorta", {13, 25, -50}), 20.0, 0.5);
  EXPECT_NEAR(width("inferior vena cava", {-22, 25, -50}), 23.0, 0.5);
}

TEST(ShippedPatient, HasAGallBladderOf80By30MillimetresLyingAgainstTheLiver) {
  double longest = 0.0;
  const glm::dvec3 axis = glm::normalize(glm::dvec3(-21, -45, -31));
  double low = 1e9, high = -1e9;
  forVoxelsOf("gall bladder lumen", [&](const glm::dvec3& p) {
    low = std::min(low, glm::dot(p, axis));
    high = std::max(high, glm::dot(p, axis));
    longest = std::max(longest, -distanceTo("gall bladder lumen", p));
  });
  EXPECT_NEAR(high - low, 80.0, 4.0);
  EXPECT_NEAR(2.0 * longest, 30.0, 2.0);
  std::size_t touching = 0, wall = 0;
  forVoxelsOf("gall bladder wall", [&](const glm::dvec3& p) {
    ++wall;
    touching += distanceTo("liver", p) < 2.5;
  });
  EXPECT_GT(static_cast<double>(touching), 0.25 * static_cast<double>(wall)) << "the gall bladder lies in its bed";
}

TEST(ShippedPatient, HoldsTheWholeStoneInsideTheGallBladderOnItsLowerWall) {
  double lowest = -1e9;
  forVoxelsOf("gall stone", [&](const glm::dvec3& p) {
    EXPECT_LT(distanceTo("gall bladder lumen", p), 0.0);
    lowest = std::max(lowest, distanceTo("gall bladder lumen", p));
  });
  EXPECT_GT(lowest, -2.0) << "a stone rests on the wall, it does not float";
}

TEST(ShippedPatient, KeepsItsOrgansInsideTheBodyWall) {
  for (const char* organ : {"liver", "right kidney", "left kidney", "spleen", "gall bladder lumen", "pancreas", "aorta"})
    forVoxelsOf(organ, [&](const glm::dvec3& p) { EXPECT_LT(distanceTo("skin surface", p), -20.0) << organ; });
}

TEST(ShippedPatient, PairsTheAortaLeftWithTheVenaCavaRightInFrontOfTheSpine) {
  for (double z = -130; z <= 20; z += 10) {
    double aorta = 0, cava = 0, nAorta = 0, nCava = 0, spineFront = 1e9, aortaBack = -1e9;
    const Grid& grid = shippedVoxels().volume.grid;
    const int k = static_cast<int>(std::lround((z - grid.origin_mm.z) / 2.0));
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const int label = shippedVoxels().labels[grid.indexOf(i, j, k)];
        const double x = grid.origin_mm.x + 2.0 * i, y = grid.origin_mm.y + 2.0 * j;
        if (label == labelOf(shipped(), "aorta")) aorta += x, ++nAorta, aortaBack = std::max(aortaBack, y);
        if (label == labelOf(shipped(), "inferior vena cava")) cava += x, ++nCava;
        if (label == labelOf(shipped(), "intervertebral discs")) spineFront = std::min(spineFront, y);
      }
    ASSERT_GT(nAorta, 0) << z;
    ASSERT_GT(nCava, 0) << z;
    EXPECT_GT(aorta / nAorta, 0.0) << "left is x > 0";
    EXPECT_LT(cava / nCava, 0.0);
    if (spineFront < 1e8) {
      EXPECT_LT(aortaBack, spineFront + 8.0) << z;
    }
  }
}

TEST(ShippedPatient, WithoutFindingsDiffersOnlyByTheStone) {
  const auto normal = readPatient(testing::shippedPatient("upper-abdomen-normal"));
  ASSERT_TRUE(normal) << normal.error();
  EXPECT_EQ(organsOf(**normal).size() + 1, organsOf(shipped()).size());
  EXPECT_FALSE(signedDistance_mm(**normal, "gall stone", {0, 0, 0}));
}

TEST(Labels, SayExactlyWhichOrganContainsAPoint) {
  const auto patient = patientOf(patientRecipe(R"(
    {"name": "egg", "tissue": "smooth", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [20, 10, 15]}}},
    {"name": "ball", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [15, 0, 0], "radii_mm": [12, 12, 12]}}})"));
  ASSERT_TRUE(patient) << patient.error();
  const auto made = voxelise(**patient, {.spacing_mm = 1.0}, noProgress());
  ASSERT_TRUE(made) << made.error();
  const Grid& grid = made->volume.grid;
  ASSERT_EQ(grid.dims, glm::ivec3(81));
  std::size_t wrong = 0;
  for (int k = 0; k < 81; ++k)
    for (int j = 0; j < 81; ++j)
      for (int i = 0; i < 81; ++i) {
        const glm::dvec3 p(i - 40, j - 40, k - 40);
        const glm::dvec3 s = p / glm::dvec3(20, 10, 15);
        const double egg = glm::dot(s, s), ball = glm::distance(p, glm::dvec3(15, 0, 0));
        if (std::abs(egg - 1.0) < 1e-9 || std::abs(ball - 12.0) < 1e-9 || std::abs(glm::length(p) - 60.0) < 0.2) continue;
        const int expected = glm::length(p) >= 60.0 ? 0 : egg < 1.0 ? 1 : ball < 12.0 ? 2 : 0;
        wrong += made->labels[grid.indexOf(i, j, k)] != expected;
        wrong += labelAt(**patient, p) != expected;
      }
  EXPECT_EQ(wrong, 0u);
}

TEST(Labels, FillTheClosedFormVolumeOfAnEllipsoid) {
  const auto patient = patientOf(patientRecipe(
      R"({"name": "egg", "tissue": "smooth", "shape": {"ellipsoid": {"centre_mm": [1.3, 0.2, -2.1], "radii_mm": [20, 10, 15]}}})"));
  ASSERT_TRUE(patient) << patient.error();
  const auto made = voxelise(**patient, {.spacing_mm = 0.5}, noProgress());
  ASSERT_TRUE(made);
  const auto voxels = static_cast<double>(std::count(made->labels.begin(), made->labels.end(), std::uint8_t{1}));
  const double closedForm = 4.0 / 3.0 * std::numbers::pi * 20.0 * 10.0 * 15.0;
  EXPECT_NEAR(voxels * 0.125 / closedForm, 1.0, 0.003);
}

TEST(ReadPatient, NamesTheFieldThatCannotBeUsed) {
  const std::string ball = R"("shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, 5]}})";
  const std::map<std::string, std::string> recipes{
      {"organs[0] (egg).shape.ellipsoid.radii_mm",
       patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 0, 5]}}})")},
      {"organs[0] (egg).shape.ellipsoid.centre_mm",
       patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, "a", 0], "radii_mm": [5, 5, 5]}}})")},
      {"organs[0] (egg).tissue", patientRecipe(R"({"name": "egg", "tissue": "glass", )" + ball + "}")},
      {"organs[0] (egg).shape", patientRecipe(R"({"name": "egg", "tissue": "dark"})")},
      {"organs[0] (egg).shape.of", patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"of": "egg"}})")},
      {"organs[0] (egg).border.shine",
       patientRecipe(R"({"name": "egg", "tissue": "dark", )" + ball + R"(, "border": {"echo_level": 9, "width_mm": 1, "shine": "x"}})")},
      {"organs[1] (egg).name",
       patientRecipe(R"({"name": "egg", "tissue": "dark", )" + ball + R"(}, {"name": "egg", "tissue": "dark", )" + ball + "}")},
      {"tissues[0].reflection_db",
       [] {
         std::string recipe = patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"of": "skin surface"}})");
         return recipe.replace(recipe.find(R"("speckle": 1})"), 13, R"("speckle": 1, "reflection_db": 61})");
       }()},
      {"organs[0].colour", patientRecipe(R"({"name": "egg", "tissue": "dark", "colour": 3, )" + ball + "}")},
      {"organs[0] (egg).shape.shell.to_depth_mm",
       patientRecipe(
           R"({"name": "egg", "tissue": "dark", "shape": {"shell": {"of": "skin surface", "from_depth_mm": 5, "to_depth_mm": 2}}})")},
      {"organs[0] (egg).shape.tube.points[1]",
       patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"tube": {"points": [[0, 0, 0, 1], [1, 2, 3]]}}})")},
      {"organs[0] (egg).shape.loft.sections[1].z_mm", patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"loft": {"sections": [
         {"z_mm": 5, "half_width_mm": 3, "front_mm": 3, "back_mm": 3}, {"z_mm": 5, "half_width_mm": 3, "front_mm": 3, "back_mm": 3}]}}})")}};
  for (const auto& [field, recipe] : recipes) {
    const auto patient = patientOf(recipe);
    ASSERT_FALSE(patient) << field;
    EXPECT_EQ(patient.error().code, ErrorCode::badField) << patient.error();
    EXPECT_NE(patient.error().sentence().find(field), std::string::npos) << patient.error().sentence() << "\ndoes not name " << field;
    EXPECT_NE(patient.error().sentence().find("it must be"), std::string::npos) << patient.error().sentence();
  }
}

TEST(LabelTissues, AreThoseOfTheOrgansInTheOrderOfTheirLabels) {
  const auto tissues = readLabelTissues(testing::shippedPatient());
  ASSERT_TRUE(tissues) << tissues.error();
  const auto organs = organsOf(shipped());
  ASSERT_EQ(tissues->size(), organs.size() + 1);
  EXPECT_EQ((*tissues)[0].tissue.name, "mesentery") << "label 0 is the background";
  for (std::size_t n = 0; n < organs.size(); ++n) {
    EXPECT_EQ((*tissues)[n + 1].label, organs[n].label);
    EXPECT_EQ((*tissues)[n + 1].organ, organs[n].name);
  }
  for (const auto& each : *tissues)
    EXPECT_EQ(each.tissue.reflection_db >= 20.0, (std::set<std::string>{"bone", "stone", "bowel gas", "lung"}.count(each.tissue.name) > 0))
        << each.organ;
}

TEST(ReadPatient, SaysWhatIsWrongWithAFileAsAWhole) {
  EXPECT_EQ(readPatient("/nowhere/patient.json").error().code, ErrorCode::notFound);
  EXPECT_EQ(patientOf("liver, kidney, spleen").error().code, ErrorCode::badHeader);
  EXPECT_EQ(patientOf("[1, 2]").error().code, ErrorCode::badHeader);
  EXPECT_EQ(patientOf(R"({"format": 2})").error().code, ErrorCode::newerFormat);
  EXPECT_EQ(patientOf(R"({"format": "one"})").error().code, ErrorCode::badField);
  std::string recipe = patientRecipe(R"({"name": "egg", "tissue": "dark", "shape": {"of": "skin surface"}})");
  recipe.replace(recipe.find("ball.json"), 9, "none.json");
  const auto without = patientOf(recipe);
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().code, ErrorCode::notFound);
  EXPECT_NE(without.error().sentence().find("none.json"), std::string::npos);
}

TEST(Fingerprint, ChangesWithTheRecipeAndWithItsMannequin) {
  const testing::Folder folder;
  const std::string organ = R"({"name": "egg", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [5, 5, 5]}}})";
  const auto file = folder.write("patient.json", patientRecipe(organ));
  const auto mannequinOf = [&](int radius) {
    const std::string r = std::to_string(radius);
    folder.write("ball.json",
                 testing::bodyRecipe(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [)" + r + "," + r + "," + r + "]}}"));
  };
  mannequinOf(60);
  const auto first = fingerprintOfPatient(file);
  ASSERT_TRUE(first) << first.error();
  EXPECT_EQ(*fingerprintOfPatient(file), *first);
  mannequinOf(61);
  EXPECT_NE(*fingerprintOfPatient(file), *first);
  mannequinOf(60);
  folder.write("patient.json", patientRecipe(organ, R"("beam_axis_mm": [0, 90],)"));
  EXPECT_NE(*fingerprintOfPatient(file), *first);
}

}  // namespace
}  // namespace ew::patient_test
