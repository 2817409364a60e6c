#include <atomic>
#include <cmath>
#include <queue>

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
  EXPECT_NEAR(surfaceAlong({0, 0, 0}, {0, 1, 0}), 105.0, 3.0) << "back skin at the xiphoid";
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

TEST(Mannequin, IsOneClosedSolidWithoutHolesOrHandles) { expectClosedSolid(gridAround(adult(), 12.0), sampledAt12mm()); }

TEST(GravidMannequin, IsTheAdultWithABellyAndStillOneClosedSolid) {
  const auto gravid = readBodyShape(testing::shippedMannequin().parent_path() / "gravid.json");
  ASSERT_TRUE(gravid) << gravid.error();
  std::vector<float> distances;
  ASSERT_TRUE(sampleDistance(**gravid, gridAround(**gravid, 12.0), distances, 2, noProgress()));
  expectClosedSolid(gridAround(**gravid, 12.0), distances);
  EXPECT_LT((*gravid)->signedDistance_mm({0, -112, -290}), 0.0) << "the belly at the navel";
  EXPECT_GT(adult().signedDistance_mm({0, -112, -290}), 5.0);
  for (const glm::dvec3& elsewhere :
       {glm::dvec3(0, 0, 460), glm::dvec3(0, 110, -50), glm::dvec3(101, 10, -1270), glm::dvec3(380, -40, -560)})
    EXPECT_EQ((*gravid)->signedDistance_mm(elsewhere), adult().signedDistance_mm(elsewhere));
}

TEST(NeckMannequin, IsTheAdultWithItsChinUpAndStillOneClosedSolid) {
  const auto stretched = readBodyShape(testing::shippedMannequin().parent_path() / "neck-extended.json");
  ASSERT_TRUE(stretched) << stretched.error();
  std::vector<float> distances;
  ASSERT_TRUE(sampleDistance(**stretched, gridAround(**stretched, 12.0), distances, 2, noProgress()));
  expectClosedSolid(gridAround(**stretched, 12.0), distances);
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
  EXPECT_LT(glm::distance(outwardNormal(adult(), {0, -105, 0}), glm::dvec3(0, -1, 0)), 0.25);
}

}  // namespace
}  // namespace ew::body_test
