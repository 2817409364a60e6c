#include "ew/library/probe_side.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ew::test::probe_side_test {
namespace {

/// A grid whose axes are those of LPS, permuted and turned over.
Grid turnedGrid(const glm::ivec3& dims, int shift, bool isTurned) {
  Grid grid;
  grid.dims = dims;
  grid.spacing_mm = {0.5, 0.7, 0.9};
  for (int axis = 0; axis < 3; ++axis) {
    grid.directions[axis] = glm::dvec3(0.0);
    grid.directions[axis][(axis + shift) % 3] = isTurned ? -1.0 : 1.0;
  }
  return grid;
}

template <class Grey>
Volume made(const Grid& grid, Grey grey) {
  Volume volume;
  volume.grid = grid;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) volume.echo.push_back(static_cast<std::uint8_t>(grey(glm::ivec3(i, j, k))));
  return volume;
}

constexpr glm::ivec3 kDims{24, 20, 16};

TEST(ProbeSide, IsThatFromWhichEchoesGrowFainter) {
  for (int shift = 0; shift < 3; ++shift)
    for (const bool isTurned : {false, true}) {
      const Grid grid = turnedGrid(kDims, shift, isTurned);
      for (std::size_t side = 0; side < 6; ++side) {
        const int axis = static_cast<int>(side / 2);
        const Volume volume = made(grid, [&](const glm::ivec3& at) {
          const int depth = side % 2 == 0 ? at[axis] : kDims[axis] - 1 - at[axis];
          return std::lround(200.0 * std::exp(-1.5 * depth / kDims[axis]));
        });
        const ProbeSide found = proposedProbeSide(volume);
        EXPECT_EQ(found.axes.depth, inwardOf(grid, side)) << shift << isTurned << side;
        EXPECT_GT(found.certainty, 0.9);
        EXPECT_NEAR(glm::dot(found.axes.depth, found.axes.lateral), 0.0, 1e-12);
      }
    }
}

TEST(ProbeSide, IsThatFromWhichAFanOpens) {
  const Grid grid = turnedGrid({40, 40, 9}, 0, false);
  for (const std::size_t side : {0u, 1u, 2u, 3u}) {
    const int axis = static_cast<int>(side / 2), across = 1 - axis;
    const Volume volume = made(grid, [&](const glm::ivec3& at) {
      const int depth = side % 2 == 0 ? at[axis] : 39 - at[axis];
      return std::abs(at[across] - 20) <= 4 + depth / 3 ? 90 : 0;
    });
    const ProbeSide found = proposedProbeSide(volume);
    EXPECT_EQ(found.axes.depth, inwardOf(grid, side)) << side;
    EXPECT_GT(found.certainty, 0.5);
  }
}

TEST(ProbeSide, OfAnEvenVolumeNothingIsProposed) {
  const ProbeSide found = proposedProbeSide(made(turnedGrid(kDims, 0, false), [](const glm::ivec3&) { return 100; }));
  EXPECT_EQ(found.certainty, 0.0);
  EXPECT_EQ(volumeSideOf(found.axes), VolumeSide::front);
  EXPECT_EQ(proposedProbeSide(made(turnedGrid(kDims, 0, false), [](const glm::ivec3&) { return 0; })).certainty, 0.0);
}

TEST(ProbeSide, IsNamedAsInAPatient) {
  const Grid grid = turnedGrid(kDims, 0, false);
  for (const VolumeSide side :
       {VolumeSide::front, VolumeSide::back, VolumeSide::left, VolumeSide::right, VolumeSide::upper, VolumeSide::lower}) {
    EXPECT_EQ(volumeSideOf(axesFrom(grid, side)), side);
    EXPECT_EQ(volumeSideOf(nameOf(side)), side);
  }
  EXPECT_EQ(axesFrom(grid, VolumeSide::left).depth, glm::dvec3(-1, 0, 0)) << "from the patient's left, where x is greatest";
  EXPECT_EQ(axesFrom(grid, VolumeSide::front), SweepAxes{});
  EXPECT_FALSE(volumeSideOf("top"));
}

TEST(ProbeSide, ItsImageHasTheFaceAtTheTopAndTheMarkerAtTheRight) {
  const Grid grid = turnedGrid({8, 6, 4}, 0, false);
  const Volume volume = made(grid, [](const glm::ivec3& at) { return 10 * at.x + at.y; });
  const GreyImage front = middleImage(volume, SweepAxes{{0, 1, 0}, {-1, 0, 0}}, 400);
  const auto at = [](const GreyImage& image, double x, double y) {
    return static_cast<int>(image.pixels[static_cast<std::size_t>(y * (image.height - 1)) * static_cast<std::size_t>(image.width) +
                                         static_cast<std::size_t>(x * (image.width - 1))]);
  };
  EXPECT_EQ(at(front, 0, 0), 70) << "j = 0 at the top; i falls towards the marker";
  EXPECT_EQ(at(front, 1, 1), 5);
  const GreyImage back = middleImage(volume, SweepAxes{{0, -1, 0}, {1, 0, 0}}, 400);
  EXPECT_EQ(at(back, 0, 0), 5);
  EXPECT_EQ(at(back, 1, 1), 70);
  EXPECT_NEAR(static_cast<double>(front.width) / front.height, 8 * 0.5 / (6 * 0.7), 0.01) << "true to scale";
}

TEST(ProbeSide, AThinnedVolumeKeepsItsExtent) {
  const Volume volume = made(turnedGrid({10, 7, 3}, 0, false), [](const glm::ivec3& at) { return at.x; });
  const Volume thin = thinned(volume, 4);
  EXPECT_EQ(thin.grid.dims, glm::ivec3(4, 4, 3));
  EXPECT_EQ(thin.grid.spacing_mm, glm::dvec3(1.5, 1.4, 0.9));
  ASSERT_EQ(thin.echo.size(), thin.grid.voxelCount());
  EXPECT_EQ(thin.echo[3], 9);
}

}  // namespace
}  // namespace ew::test::probe_side_test
