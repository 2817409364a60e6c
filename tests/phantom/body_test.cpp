#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <queue>
#include <string>

#include "recipes.h"

namespace ew::body_test {
namespace {

const BodyShape& adult() {
  static const auto body = readBodyShape(testing::shippedMannequin());
  if (!body) {
    ADD_FAILURE() << body.error();
    std::abort();
  }
  return **body;
}

Grid gridAround(const BodyShape& body, double spacing_mm) {
  Grid grid;
  grid.spacing_mm = glm::dvec3(spacing_mm);
  grid.origin_mm = body.bounds().lowest_mm - 1.5 * spacing_mm;
  grid.dims = glm::ivec3(glm::ceil((body.bounds().highest_mm - body.bounds().lowest_mm) / spacing_mm)) + 4;
  return grid;
}

const std::vector<float>& sampledAt12mm() {
  static const std::vector<float> distances = [] {
    std::vector<float> found;
    const auto done = sampleDistance(adult(), gridAround(adult(), 12.0), found, 2, noProgress());
    EXPECT_TRUE(done) << done.error();
    return found;
  }();
  return distances;
}

double surfaceAlong(const glm::dvec3& from_mm, const glm::dvec3& direction) {
  double outside = 0.0;
  while (adult().signedDistance_mm(from_mm + outside * direction) < 0.0) outside += 1.0;
  double inside = outside - 1.0;
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (inside + outside);
    (adult().signedDistance_mm(from_mm + middle * direction) < 0.0 ? inside : outside) = middle;
  }
  return inside;
}

TEST(Mannequin, HasTheSizeOfAnAdultOf175CmStandingInTheWorldFrame) {
  EXPECT_NEAR(surfaceAlong({0, 0, 400}, {0, 0, 1}) + 400.0, 470.0, 3.0) << "crown";
  EXPECT_NEAR(-900.0 - surfaceAlong({101, 10, -900}, {0, 0, -1}), -1280.0, 3.0) << "sole";
  EXPECT_NEAR(surfaceAlong({0, 0, 0}, {0, -1, 0}), 105.0, 3.0) << "front skin at the xiphoid";
  EXPECT_NEAR(surfaceAlong({0, 0, 0}, {0, 1, 0}), 101.0, 3.0) << "back skin at the xiphoid, in the furrow of the spine";
  EXPECT_NEAR(surfaceAlong({0, 0, 0}, {1, 0, 0}), 150.0, 4.0) << "flank";
}

TEST(Mannequin, IsTheSameLeftAndRight) {
  for (double z = -1270; z < 480; z += 61.7)
    for (double y = -110; y < 120; y += 37.3)
      for (double x = 0; x < 400; x += 28.9)
        EXPECT_EQ(adult().signedDistance_mm({x, y, z}), adult().signedDistance_mm({-x, y, z})) << x << ' ' << y << ' ' << z;
}

TEST(Mannequin, HasNoCreaseAtTheMidlineOfChestBellyAndBack) {
  const double h = 0.05;
  for (double z = -300; z < 180; z += 15.0) {
    for (const double side : {-1.0, 1.0}) {
      const glm::dvec3 on(0.0, side * surfaceAlong({0, 0, z}, {0, side, 0}), z);
      const double slope = adult().signedDistance_mm(on + glm::dvec3(h, 0, 0)) - adult().signedDistance_mm(on);
      EXPECT_LT(std::abs(slope) / h, 0.02) << "z = " << z << ", side " << side;
    }
  }
}

/// Expects one piece without holes or handles that ends inside the grid.
void expectClosedSolid(const Grid& grid, const std::vector<float>& d) {
  const auto inside = [&](int i, int j, int k) { return grid.contains({i, j, k}) && d[grid.indexOf(i, j, k)] < 0.0F; };
  // Euler characteristic of the union of closed voxels: corners - edges + faces - voxels; 1 for a ball, less for a handle, more for
  // a second piece.
  long long euler = 0;
  for (int k = 0; k <= grid.dims.z; ++k)
    for (int j = 0; j <= grid.dims.y; ++j)
      for (int i = 0; i <= grid.dims.x; ++i) {
        const auto any = [&](int di, int dj, int dk) {
          for (int c = 0; c <= dk; ++c)
            for (int b = 0; b <= dj; ++b)
              for (int a = 0; a <= di; ++a)
                if (inside(i - a, j - b, k - c)) return true;
          return false;
        };
        euler += any(1, 1, 1) - any(0, 1, 1) - any(1, 0, 1) - any(1, 1, 0) + any(0, 0, 1) + any(0, 1, 0) + any(1, 0, 0) - any(0, 0, 0);
      }
  EXPECT_EQ(euler, 1);
  for (int j = 0; j < grid.dims.y; ++j)
    for (int i = 0; i < grid.dims.x; ++i) {
      EXPECT_FALSE(inside(i, j, 0));
      EXPECT_FALSE(inside(i, j, grid.dims.z - 1));
    }
}

/// At the size of cells that its image is made with, so that fingers stay apart.
void expectClosedSolid(const BodyShape& body) {
  std::vector<float> distances;
  const Grid grid = gridAround(body, 7.0);
  ASSERT_TRUE(sampleDistance(body, grid, distances, 0, noProgress()));
  expectClosedSolid(grid, distances);
}

TEST(Mannequin, IsOneClosedSolidWithoutHolesOrHandles) { expectClosedSolid(adult()); }

/// Where the skin lies in front of or behind a point, along y.
double skinAlongY(const BodyShape& body, double x, double z, double side) {
  double outside = 200.0, inside = 0.0;
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (inside + outside);
    (body.signedDistance_mm({x, side * middle, z}) < 0.0 ? inside : outside) = middle;
  }
  return side * inside;
}
/// The figure without ridges and furrows on its trunk.
const BodyShape& plainAdult() {
  static const auto body = [] {
    nlohmann::json recipe = nlohmann::json::parse(std::ifstream(testing::shippedMannequin()));
    recipe["body"].erase("relief");
    const testing::Folder folder;
    return readBodyShape(folder.write("plain.json", recipe.dump()));
  }();
  if (!body) {
    ADD_FAILURE() << body.error();
    std::abort();
  }
  return **body;
}
double frontAt(double x, double z) { return skinAlongY(adult(), x, z, -1.0); }

TEST(Mannequin, HasAFaceInFrontAndEarsAtItsSides) {
  EXPECT_LT(frontAt(0, 320), frontAt(0, 365) - 10.0) << "the tip of the nose against its root";
  EXPECT_LT(frontAt(0, 320), frontAt(24, 320) - 15.0) << "and against the cheek beside it";
  EXPECT_GT(frontAt(31, 356), frontAt(31, 378) + 5.0) << "eyes lie below their brows";
  EXPECT_GT(frontAt(0, 286), frontAt(0, 279) + 0.5) << "between the lips";
  EXPECT_GT(frontAt(0, 286), frontAt(0, 292) + 0.5);
  EXPECT_GT(skinAlongY(adult(), 0, 320, 1.0), 60.0);
  EXPECT_NEAR(skinAlongY(adult(), 0, 345, 1.0), skinAlongY(adult(), 12, 345, 1.0), 3.0) << "smooth behind";
  EXPECT_LT(adult().signedDistance_mm({79, 18, 350}), 0.0) << "an ear";
  EXPECT_GT(adult().signedDistance_mm({79, -30, 350}), 4.0) << "nothing in front of it";
}

TEST(Mannequin, HasTheLandmarksThatAProbeIsPlacedBy) {
  EXPECT_GT(frontAt(0, -152), frontAt(0, -134) + 4.0) << "the navel is a dent";
  const auto raised = [](double x, double z) { return skinAlongY(plainAdult(), x, z, -1.0) - frontAt(x, z); };
  EXPECT_LT(raised(0, 172), -2.0) << "the notch above the breast bone";
  EXPECT_GT(raised(60, 175), 1.5) << "a collar bone";
  EXPECT_LT(frontAt(92, 66), frontAt(92, 54) - 1.0) << "a nipple";
  EXPECT_LT(skinAlongY(adult(), 0, -60, 1.0), skinAlongY(adult(), 34, -60, 1.0) - 1.0) << "the furrow along the spine";
  double ribs = 0.0;
  for (double z = -90; z < 20; z += 1.0) ribs += std::abs(frontAt(122, z - 1.0) - 2.0 * frontAt(122, z) + frontAt(122, z + 1.0));
  EXPECT_GT(ribs, 0.5) << "ribs, under a finger that slides down";
}

TEST(Mannequin, HasRibsTooLowToChangeWhatIsScanned) {
  for (double z = -140; z < 50; z += 7.3)
    for (double x = 8; x < 150; x += 5.9) {
      if (glm::distance(glm::dvec2(x, z), glm::dvec2(0, -152)) < 12.0 || glm::distance(glm::dvec2(x, z), glm::dvec2(92, 66)) < 20.0)
        continue;
      const glm::dvec3 on(x, skinAlongY(plainAdult(), x, z, -1.0), z);
      EXPECT_LE(std::abs(adult().signedDistance_mm(on) - plainAdult().signedDistance_mm(on)), 0.5) << "x = " << x << ", z = " << z;
    }
}

TEST(Mannequin, HasFourFingersAndAThumbInFrontOfThem) {
  int fingers = 0;
  bool inside = false;
  for (double y = -115; y < 20; y += 0.5) {
    const bool here = adult().signedDistance_mm({379, y, -566}) < 0.0;
    fingers += here && !inside ? 1 : 0;
    inside = here;
  }
  EXPECT_EQ(fingers, 4);
  EXPECT_LT(adult().signedDistance_mm({355, -93, -535}), 0.0) << "the thumb";
}

TEST(ArmsUpMannequin, IsTheAdultWithItsFlanksFree) {
  const auto lifted = readBodyShape(testing::shippedMannequin().parent_path() / "adult-arms-up.json");
  ASSERT_TRUE(lifted) << lifted.error();
  EXPECT_LT(adult().signedDistance_mm({252, 14, -60}), 0.0);
  for (double z = -300; z < 40; z += 20.0) EXPECT_GT((*lifted)->signedDistance_mm({200, 14, z}), 25.0) << "z = " << z;
  EXPECT_LT((*lifted)->signedDistance_mm({318, 20, 326}), 0.0) << "the arm";
  EXPECT_LE((*lifted)->bounds().highest_mm.z, adult().bounds().highest_mm.z + 20.0) << "as tall as it was";
  for (double z = -300; z < -30; z += 13.0)
    for (double x = -140; x <= 140; x += 20.0) {
      const glm::dvec3 on(x, skinAlongY(adult(), x, z, -1.0), z);
      EXPECT_NEAR((*lifted)->signedDistance_mm(on), adult().signedDistance_mm(on), 0.1) << "x = " << x << ", z = " << z;
    }
}

TEST(GravidMannequin, HasABellyThatStandsOutBelowAWaist) {
  const auto gravid = readBodyShape(testing::shippedMannequin().parent_path() / "gravid.json");
  ASSERT_TRUE(gravid) << gravid.error();
  const double belly = skinAlongY(**gravid, 0, -285, -1.0);
  EXPECT_LT(belly, skinAlongY(**gravid, 0, -120, -1.0) - 20.0) << "above it";
  EXPECT_LT(belly, skinAlongY(**gravid, 0, -400, -1.0) - 20.0) << "below it";
  EXPECT_LT(belly, skinAlongY(**gravid, 100, -285, -1.0) - 15.0) << "beside it";
}

TEST(MannequinThatExtendsAnother, ReplacesAddsAndRemovesPartsByName) {
  const testing::Folder folder;
  const auto ball = [](const std::string& name, double x, double radius_mm) {
    const std::string radius = std::to_string(radius_mm);
    return R"({"name": ")" + name + R"(", "ellipsoid": {"centre_mm": [)" + std::to_string(x) + ", 0, 0], \"radii_mm\": [" + radius + ", " +
           radius + ", " + radius + "]}}";
  };
  folder.write("base.json", testing::bodyRecipe(R"({"union": [)" + ball("left", 100, 20) + ", " + ball("middle", 0, 20) + ", " +
                                                ball("right", -100, 20) + "]}"));
  const auto read = [&](const std::string& fields) {
    return readBodyShape(folder.write("child.json", R"({"format": 1, "name": "child", "extends": "base.json", )" + fields + "}"));
  };
  const auto body = read(R"("remove": {"parts": ["right"]}, "parts": [)" + ball("middle", 0, 30) + ", " + ball("far", 300, 10) + "]");
  ASSERT_TRUE(body) << body.error();
  EXPECT_NEAR((*body)->signedDistance_mm({0, 40, 0}), 10.0, 1e-9);
  EXPECT_NEAR((*body)->signedDistance_mm({100, 30, 0}), 10.0, 1e-9);
  EXPECT_NEAR((*body)->signedDistance_mm({300, 15, 0}), 5.0, 1e-9);
  EXPECT_GT((*body)->signedDistance_mm({-100, 0, 0}), 60.0);

  EXPECT_NE(read(R"("remove": {"parts": ["tail"]})").error().sentence().find("tail"), std::string::npos);
  EXPECT_FALSE(read(R"("body": {})"));
  EXPECT_FALSE(readBodyShape(folder.write("third.json", R"({"format": 1, "name": "third", "extends": "child.json"})")))
      << "one that extends cannot be extended";
  EXPECT_EQ(readBodyShape(folder.write("lost.json", R"({"format": 1, "name": "lost", "extends": "nobody.json"})")).error().code,
            ErrorCode::notFound);
}

TEST(GravidMannequin, IsTheAdultWithABellyAndStillOneClosedSolid) {
  const auto gravid = readBodyShape(testing::shippedMannequin().parent_path() / "gravid.json");
  ASSERT_TRUE(gravid) << gravid.error();
  expectClosedSolid(**gravid);
  EXPECT_LT((*gravid)->signedDistance_mm({0, -112, -290}), 0.0) << "the belly at the navel";
  EXPECT_GT(adult().signedDistance_mm({0, -112, -290}), 5.0);
  for (const glm::dvec3& elsewhere :
       {glm::dvec3(0, 0, 460), glm::dvec3(0, 110, -50), glm::dvec3(101, 10, -1270), glm::dvec3(380, -40, -560)})
    EXPECT_EQ((*gravid)->signedDistance_mm(elsewhere), adult().signedDistance_mm(elsewhere));
}

TEST(NeckMannequin, IsTheAdultWithItsChinUpAndStillOneClosedSolid) {
  const auto stretched = readBodyShape(testing::shippedMannequin().parent_path() / "neck-extended.json");
  ASSERT_TRUE(stretched) << stretched.error();
  expectClosedSolid(**stretched);
  EXPECT_GT((*stretched)->signedDistance_mm({0, -70, 290}), 5.0) << "below the chin";
  EXPECT_LT(adult().signedDistance_mm({0, -70, 290}), 0.0);
  for (const glm::dvec3& elsewhere : {glm::dvec3(0, -100, -100), glm::dvec3(101, 10, -1270), glm::dvec3(380, -40, -560)})
    EXPECT_NEAR((*stretched)->signedDistance_mm(elsewhere), adult().signedDistance_mm(elsewhere), 0.1);
}

TEST(SampleDistance, KeepsTheSignOfEveryVoxelWhereItSkipsBlocks) {
  const Grid grid = gridAround(adult(), 12.0);
  const std::vector<float>& d = sampledAt12mm();
  std::size_t wrong = 0, skipped = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const double exact = adult().signedDistance_mm(grid.origin_mm + 12.0 * glm::dvec3(i, j, k));
        wrong += (d[grid.indexOf(i, j, k)] < 0.0F) != (exact < 0.0);
        skipped += d[grid.indexOf(i, j, k)] != static_cast<float>(exact);
      }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(skipped, grid.voxelCount() / 3) << "skipping is what makes it fast";
}

TEST(SampleDistance, DoesNotDependOnTheNumberOfThreads) {
  const auto ball = testing::bodyOf(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [50, 30, 40]}})");
  std::vector<float> one, eight;
  ASSERT_TRUE(sampleDistance(*ball, gridAround(*ball, 3.0), one, 1, noProgress()));
  ASSERT_TRUE(sampleDistance(*ball, gridAround(*ball, 3.0), eight, 8, noProgress()));
  EXPECT_EQ(one, eight);
}

TEST(SampleDistance, StopsWhenAskedTo) {
  class Cancelled final : public Progress {
    void report(const Message&, double) override {}
    bool cancelRequested() const override { return true; }
  } cancelled;
  std::vector<float> distances;
  const auto done = sampleDistance(adult(), gridAround(adult(), 12.0), distances, 2, cancelled);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::cancelled);
}

TEST(OutwardNormal, IsTheDirectionInWhichTheDistanceGrows) {
  const auto ball = testing::bodyOf(R"({"ellipsoid": {"centre_mm": [1, 2, 3], "radii_mm": [40, 40, 40]}})");
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.8, 0.5));
  EXPECT_LT(glm::distance(outwardNormal(*ball, glm::dvec3(1, 2, 3) + 40.0 * direction), direction), 1e-4);
  EXPECT_LT(glm::distance(outwardNormal(adult(), {0, -105, -90}), glm::dvec3(0, -1, 0)), 0.25);
}

}  // namespace
}  // namespace ew::body_test
