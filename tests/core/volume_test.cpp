#include "ew/core/volume.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace ew::volume_test {
namespace {

Grid oblique() {
  Grid grid;
  grid.dims = {4, 5, 6};
  grid.spacing_mm = {0.5, 1.0, 2.0};
  grid.origin_mm = {10, 20, 30};
  grid.directions = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, 3))));
  return grid;
}

TEST(Grid, TakesVoxelsToTheWorldAndBack) {
  const Grid grid = oblique();
  const auto p_world = grid.voxelToWorld() * Point<frame::Voxel>{{1, 2, 3}};
  const glm::dvec3 expected = grid.origin_mm + grid.directions * glm::dvec3(0.5, 2.0, 6.0);
  EXPECT_LT(glm::length(p_world.at - expected), 1e-12);
  EXPECT_LT(glm::length((grid.worldToVoxel() * p_world).at - glm::dvec3(1, 2, 3)), 1e-12);
  EXPECT_EQ(grid.indexOf(1, 2, 3), 1u + 4u * (2u + 5u * 3u));
}

TEST(Grid, PlacedAndBoundedTogether) {
  const Transform<frame::World, frame::File> move{glm::translate(glm::dmat4(1.0), glm::dvec3(1, 2, 3)) *
                                                  glm::rotate(glm::dmat4(1.0), 0.3, glm::dvec3(0, 0, 1))};
  const Grid grid = oblique();
  const Grid moved = placed(grid, move);
  const Point<frame::Voxel> corner{{3, 4, 5}};
  const glm::dvec3 expected = carried(move, (grid.voxelTo<frame::File>() * corner).at);
  EXPECT_LT(glm::length((moved.voxelToWorld() * corner).at - expected), 1e-12);
  const Bounds bounds = boundsOf(moved);
  EXPECT_TRUE(glm::all(glm::lessThanEqual(bounds.lowest_mm, expected + 1e-9)));
  EXPECT_TRUE(glm::all(glm::greaterThanEqual(bounds.highest_mm, expected - 1e-9)));
}

TEST(Grid, IsRefusedWhenItCannotBeUsed) {
  EXPECT_TRUE(checkGrid(oblique()));
  Grid grid = oblique();
  grid.dims.y = 0;
  EXPECT_EQ(checkGrid(grid).error().code, ErrorCode::emptyVolume);
  grid = oblique();
  grid.spacing_mm.z = 0.0;
  EXPECT_EQ(checkGrid(grid).error().code, ErrorCode::badField);
  grid = oblique();
  grid.directions[2] = grid.directions[1];
  EXPECT_EQ(checkGrid(grid).error().code, ErrorCode::badField);
  grid = oblique();
  grid.dims = glm::ivec3(1 << 20);
  EXPECT_EQ(checkGrid(grid).error().code, ErrorCode::tooLarge);
}

}  // namespace
}  // namespace ew::volume_test
