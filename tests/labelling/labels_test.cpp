#include "ew/labelling/labels.h"

#include <gtest/gtest.h>

#include "labelling/support.h"

namespace ew::labelling {
namespace {

using test::circle;
using test::emptyLabels;
using test::kPi;
using test::planeAt;

TEST(LabelGrid, CoversTheVolumeAsFineAsIsAllowed) {
  const Volume askew = emptyLabels({100, 80, 60}, {0.5, 0.5, 1.0}, 0.7);
  const Grid fine = labelGridFor(askew.grid);
  EXPECT_DOUBLE_EQ(fine.spacing_mm.x, 0.5);
  EXPECT_EQ(fine.dims, glm::ivec3(100, 80, 120));
  EXPECT_LT(glm::distance(middleOf(fine), middleOf(askew.grid)), 1e-9);
  EXPECT_EQ(fine.directions, askew.grid.directions);
  const Grid coarse = labelGridFor(askew.grid, 100'000);
  EXPECT_LE(coarse.voxelCount(), 100'000u);
  EXPECT_GE(coarse.voxelCount(), 80'000u);
  EXPECT_TRUE(checkGrid(coarse));
}

TEST(PaintBall, HasTheVolumeOfABallWithinTheVoxelsItCuts) {
  for (const double angle_rad : {0.0, 0.4}) {
    Volume labels = emptyLabels({70, 70, 70}, glm::dvec3(0.5), angle_rad);
    const glm::dvec3 middle(0.13, -0.21, 0.07);
    paintBall(labels, {&middle, 1}, 10.0, {.label = 7});
    // Only voxels that the surface cuts can be wrong; their errors have no sign, so far less remains.
    EXPECT_NEAR(volume_ml(labels, 7), 4.0 / 3.0 * kPi, 0.01 * 4.0) << angle_rad;
  }
}

TEST(PaintBall, TakesExactlyTheVoxelsWithinItsRadius) {
  Volume labels = emptyLabels({24, 20, 22}, {0.9, 1.1, 1.3}, 0.5);
  const glm::dvec3 path[] = {{-4.0, 1.0, 2.0}, {3.0, -2.0, 1.0}};
  const VoxelBox changed = paintBall(labels, path, 4.0, {.label = 3});
  const auto toFile = labels.grid.voxelTo<frame::File>();
  for (int k = 0; k < 22; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 24; ++i) {
        const glm::dvec3 p = carried(toFile, {i, j, k});
        const glm::dvec3 along = path[1] - path[0];
        const double at = std::clamp(glm::dot(p - path[0], along) / glm::dot(along, along), 0.0, 1.0);
        const bool isIn = glm::distance(p, path[0] + at * along) <= 4.0;
        EXPECT_EQ(labels.echo[labels.grid.indexOf(i, j, k)], isIn ? 3 : 0);
        if (!isIn) continue;
        const glm::ivec3 ijk(i, j, k);
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(ijk, changed.first)) && glm::all(glm::lessThan(ijk, changed.end)));
      }
  EXPECT_EQ(boxOf(labels, 3), changed);
}

TEST(PaintDisc, HasTheVolumeOfASlabOfItsThickness) {
  Volume labels = emptyLabels({90, 90, 90}, glm::dvec3(0.4), 0.3);
  const glm::dvec2 path[] = {{0.0, 0.0}};
  paintDisc(labels, planeAt({0.5, 0.2, -0.3}, 0.6, {1.0, 0.0, 0.0}), path, 8.0, 2.0, {.label = 1});
  EXPECT_NEAR(volume_ml(labels, 1), kPi * 64.0 * 4.0 * 1e-3, 0.02 * kPi * 64.0 * 4.0 * 1e-3);
}

TEST(FillContour, HasTheAreaOfThePolygonTimesItsThickness) {
  // An L: 12 x 12 mm without 6 x 6 mm.
  const std::vector<glm::dvec2> contour = {{-6, -6}, {6, -6}, {6, 0}, {0, 0}, {0, 6}, {-6, 6}};
  Volume labels = emptyLabels({80, 80, 80}, glm::dvec3(0.25), 0.35);
  fillContour(labels, planeAt({0.3, 0.1, 0.2}, 0.8, glm::normalize(glm::dvec3(1.0, 1.0, 0.2))), contour, 1.5, {.label = 2});
  EXPECT_NEAR(volume_ml(labels, 2), 108.0 * 3.0 * 1e-3, 0.02 * 108.0 * 3.0 * 1e-3);
}

TEST(FillContour, TakesExactlyTheVoxelsInsideOfABoxAlongTheGrid) {
  Volume labels = emptyLabels({21, 21, 21}, glm::dvec3(1.0));
  const std::vector<glm::dvec2> square = {{-3.4, -2.4}, {3.4, -2.4}, {3.4, 2.4}, {-3.4, 2.4}};
  const VoxelBox changed = fillContour(labels, planeAt({0.0, 0.0, 0.0}), square, 1.0, {.label = 9});
  EXPECT_EQ(voxelsOf(labels, 9), 7u * 5u * 3u);
  EXPECT_EQ(changed, (VoxelBox{{7, 8, 9}, {14, 13, 12}}));
}

TEST(Brush, ChangesOnlyWhatItIsAllowedTo) {
  Volume labels = emptyLabels({20, 20, 20}, glm::dvec3(1.0));
  const glm::dvec3 middle(0.0);
  paintBall(labels, {&middle, 1}, 6.0, {.label = 1});
  const std::size_t ones = voxelsOf(labels, 1);
  const glm::dvec3 beside(5.0, 0.0, 0.0);
  paintBall(labels, {&beside, 1}, 5.0, {.label = 2, .over = 0});
  EXPECT_EQ(voxelsOf(labels, 1), ones);
  EXPECT_GT(voxelsOf(labels, 2), 100u);
  paintBall(labels, {&beside, 1}, 30.0, {.label = 0, .over = 2});
  EXPECT_EQ(voxelsOf(labels, 2), 0u);
  EXPECT_EQ(voxelsOf(labels, 1), ones);
}

TEST(Painting, BeyondTheGridOrWithWildNumbersIsCutOff) {
  Volume labels = emptyLabels({10, 10, 10}, glm::dvec3(1.0));
  const glm::dvec3 far[] = {{1e12, 0.0, 0.0}};
  EXPECT_TRUE(paintBall(labels, far, 3.0, {}).empty());
  const std::vector<glm::dvec2> line = {{0.0, 0.0}, {5.0, 5.0}};
  EXPECT_TRUE(fillContour(labels, planeAt({0.0, 0.0, 0.0}), line, 2.0, {}).empty());
  const glm::dvec3 middle[] = {{0.0, 0.0, 0.0}};
  paintBall(labels, middle, 1e6, {.label = 4});
  EXPECT_EQ(voxelsOf(labels, 4), 1000u);
}

RC_GTEST_PROP(PaintBallProperty, DoesNotDependOnHowTheWorldIsTurned, ()) {
  const auto tenth = [](int n) { return 0.1 * n; };
  const double radius_mm = tenth(*rc::gen::inRange(10, 60));
  const glm::dvec3 at(tenth(*rc::gen::inRange(-50, 50)), tenth(*rc::gen::inRange(-50, 50)), tenth(*rc::gen::inRange(-50, 50)));
  const double angle_rad = tenth(*rc::gen::inRange(0, 60));
  Volume straight = emptyLabels({16, 18, 20}, {0.91, 1.03, 0.87});
  Volume askew = emptyLabels({16, 18, 20}, {0.91, 1.03, 0.87}, angle_rad);
  const glm::dvec3 turned = askew.grid.directions * at;
  paintBall(straight, {&at, 1}, radius_mm + 1.7e-5, {});
  paintBall(askew, {&turned, 1}, radius_mm + 1.7e-5, {});
  RC_ASSERT(straight.echo == askew.echo);
}

}  // namespace
}  // namespace ew::labelling
