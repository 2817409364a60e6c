#include <gtest/gtest.h>

#include "labelling/support.h"

namespace ew::labelling {
namespace {

using test::emptyLabels;

TEST(KeepLargest, LeavesTheLargestPieceAlone) {
  Volume labels = emptyLabels({40, 30, 30}, glm::dvec3(1.0));
  const glm::dvec3 large(-8, 0, 0), small(10, 0, 0), other(2, 10, 10);
  paintBall(labels, {&large, 1}, 6.0, {.label = 1});
  const std::size_t most = voxelsOf(labels, 1);
  paintBall(labels, {&small, 1}, 4.0, {.label = 1});
  paintBall(labels, {&other, 1}, 2.0, {.label = 2});
  const std::size_t others = voxelsOf(labels, 2);
  ASSERT_TRUE(keepLargest(labels, 1, noProgress()));
  EXPECT_EQ(voxelsOf(labels, 1), most);
  EXPECT_EQ(voxelsOf(labels, 2), others);
}

TEST(Smooth, KeepsAFlatSideAndTakesWhiskersAway) {
  Volume labels = emptyLabels({40, 40, 40}, glm::dvec3(1.0));
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 20; ++i) labels.echo[labels.grid.indexOf(i, j, k)] = 1;
  Volume whiskers = labels;
  for (int i = 20; i < 30; ++i) whiskers.echo[labels.grid.indexOf(i, 20, 20)] = 1;
  whiskers.echo[labels.grid.indexOf(10, 20, 20)] = 0;
  ASSERT_TRUE(smooth(whiskers, 1, 1.5, noProgress()));
  EXPECT_EQ(whiskers.echo, labels.echo);
}

TEST(Smooth, NeverGrowsOverOtherLabels) {
  Volume labels = emptyLabels({30, 30, 30}, glm::dvec3(1.0));
  const glm::dvec3 left(-4, 0, 0), right(4, 0, 0);
  paintBall(labels, {&left, 1}, 5.0, {.label = 1});
  paintBall(labels, {&right, 1}, 5.0, {.label = 2});
  const Volume before = labels;
  ASSERT_TRUE(smooth(labels, 1, 2.0, noProgress()));
  for (std::size_t n = 0; n < labels.echo.size(); ++n)
    if (before.echo[n] == 2) {
      EXPECT_EQ(labels.echo[n], 2);
    }
}

}  // namespace
}  // namespace ew::labelling
