#include "chain/overlap.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "chain/pair_match.h"

namespace ew::stitching::overlap_test {
namespace {

Volume block(const glm::ivec3& dims, double spacing_mm) {
  Volume volume;
  volume.grid.dims = dims;
  volume.grid.spacing_mm = glm::dvec3(spacing_mm);
  volume.grid.origin_mm = {-4.0, 3.0, 7.0};
  volume.echo.resize(volume.grid.voxelCount());
  std::mt19937 random(3);
  for (auto& each : volume.echo) each = static_cast<std::uint8_t>(random() % 250);
  volume.coverage.assign(volume.echo.size(), static_cast<std::uint8_t>(Coverage::measured));
  return volume;
}

TEST(Overlap, HoldsEveryVoxelThatBothCover) {
  Volume fixed = block({60, 50, 40}, 1.0), moving = block({45, 64, 30}, 0.8);
  // A corner of one is not covered.
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 20; ++i) fixed.coverage[fixed.grid.indexOf(i, j, k)] = 0;
  const Transform<frame::Moving, frame::Fixed> place{
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(-21.0, 6.0, 2.0)), 0.3, glm::dvec3(0.2, 1.0, 0.4))};
  const auto overlap = overlapOf(fixed, moving, place);
  ASSERT_TRUE(overlap);
  const auto [inFixed, inMoving] = sharedBoxes(fixed.grid, moving.grid, place, 0.0);
  const auto there = moving.grid.toVoxel<frame::Moving>() * place * fixed.grid.voxelTo<frame::Fixed>();
  std::size_t shared = 0;
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 60; ++i) {
        const glm::ivec3 own(i, j, k), other(glm::floor(carried(there, {i, j, k}) + 0.5));
        if (fixed.coverage[fixed.grid.indexOf(i, j, k)] == 0 || !moving.grid.contains(other)) continue;
        ++shared;
        const auto holds = [](const VoxelBox& box, const glm::ivec3& p) {
          return glm::all(glm::greaterThanEqual(p, box.begin)) && glm::all(glm::lessThan(p, box.end));
        };
        ASSERT_TRUE(holds(overlap->fixed, own)) << i << " " << j << " " << k;
        ASSERT_TRUE(holds(overlap->moving, other)) << i << " " << j << " " << k;
        ASSERT_TRUE(holds(inFixed, own) && holds(inMoving, other));
      }
  EXPECT_GT(shared, 5000u);
  EXPECT_GE(overlap->fixed.begin.x, 17);
  EXPECT_FALSE(overlapOf(fixed, moving, {glm::translate(glm::dmat4(1.0), glm::dvec3(500.0, 0.0, 0.0))}));
}

TEST(Overlap, APartKeepsItsVoxelsAndTheirPlaces) {
  ViewData view;
  view.volume = std::make_shared<const Volume>(block({20, 18, 16}, 0.7));
  view.confidence.resize(view.volume->echo.size());
  for (std::size_t n = 0; n < view.confidence.size(); ++n) view.confidence[n] = static_cast<std::uint8_t>(n % 256);
  view.beams = Beams{{0.0, 1.0, 0.0}};
  const VoxelBox box{{3, 5, 2}, {15, 17, 9}};
  const PartOfView part = partOf(view, box);
  const Grid &whole = view.volume->grid, &own = part.volume.grid;
  EXPECT_EQ(own.dims, box.size());
  for (int k = 0; k < own.dims.z; ++k)
    for (int j = 0; j < own.dims.y; ++j)
      for (int i = 0; i < own.dims.x; ++i) {
        const std::size_t from = whole.indexOf(i + 3, j + 5, k + 2), to = own.indexOf(i, j, k);
        ASSERT_EQ(part.volume.echo[to], view.volume->echo[from]);
        ASSERT_EQ(part.volume.coverage[to], view.volume->coverage[from]);
        ASSERT_FLOAT_EQ(part.confidence[to], static_cast<float>(view.confidence[from]) / 255.0F);
      }
  const glm::dvec4 corner(0.0, 0.0, 0.0, 1.0), same(3.0, 5.0, 2.0, 1.0);
  EXPECT_NEAR(glm::distance(own.voxelToWorld().matrix * corner, whole.voxelToWorld().matrix * same), 0.0, 1e-12);
  EXPECT_EQ(part.input().beams, view.beams);
}

}  // namespace
}  // namespace ew::stitching::overlap_test
