#include "chain/group_warp.h"

#include <gtest/gtest.h>

#include "ew/stitching/places.h"
#include "stitching/chain_world.h"

namespace ew::stitching::group_warp_test {
namespace {

/// Views of one size in a row along x, half of each over the next, and what their pairs say.
struct Row {
  explicit Row(int count, int size = 40) {
    for (int n = 0; n < count; ++n) {
      ViewData view;
      Volume volume;
      volume.grid.dims = glm::ivec3(size);
      volume.echo.assign(volume.grid.voxelCount(), 100);
      view.volume = std::make_shared<const Volume>(std::move(volume));
      held.push_back(std::move(view));
      poses.push_back(test::shiftedBy<frame::World, frame::View>({0.5 * size * n, 0.0, 0.0}));
    }
    for (const auto& view : held) views.push_back(&view);
  }
  /// What the fixed view shows at P, the moving one shows at P + motion.
  void pair(std::size_t fixed, std::size_t moving, const glm::dvec3& motion) {
    PairWarp warp;
    warp.fixed = fixed;
    warp.moving = moving;
    warp.fixedToMoving.rigid = fixedToMovingOf(poses[fixed], poses[moving]);
    warp.fixedToMoving.control.nodes.dims = {2, 2, 2};
    warp.fixedToMoving.control.nodes.spacing_mm = glm::dvec3(60.0);
    warp.fixedToMoving.control.displacement_mm.assign(8, glm::vec3(motion));
    pairs.push_back(warp);
  }
  std::vector<ViewData> held;
  std::vector<const ViewData*> views;
  std::vector<Transform<frame::World, frame::View>> poses;
  std::vector<PairWarp> pairs;
};

TEST(WarpGroup, SharesAPairsMotionBetweenBothAndLetsItFallOffOutside) {
  Row row(2);
  const glm::dvec3 motion(0.0, 3.0, -1.0);
  row.pair(0, 1, motion);
  const auto group = warpGroup(row.views, row.poses, row.pairs, {.fallOff_mm = 25.0}, noProgress());
  ASSERT_TRUE(group) << group.error();
  const glm::dvec3 inside(30.0, 20.0, 20.0);  // the overlap lies at x = 20 to 39
  EXPECT_LT(glm::distance(registration::displacementAt(group->warps[0], inside), -0.5 * motion), 0.02);
  EXPECT_LT(glm::distance(registration::displacementAt(group->warps[1], inside), 0.5 * motion), 0.02);
  double before = 10.0;
  for (const double x : {18.0, 12.0, 6.0, 0.0}) {
    const double size = glm::length(registration::displacementAt(group->warps[0], {x, 20.0, 20.0}));
    EXPECT_LT(size, before) << x;
    before = size;
  }
  EXPECT_LT(glm::length(registration::displacementAt(group->warps[0], {-7.0, 20.0, 20.0})), 1e-6);
  EXPECT_GT(group->smallestJacobian, 0.15);
  EXPECT_LT(group->disagreement95_mm, 0.02);
}

TEST(WarpGroup, GivesViewsThatAgreeInALoopTheMotionsThatAllPairsAskFor) {
  Row row(3, 60);
  row.poses[2] = row.poses[1] = test::shiftedBy<frame::World, frame::View>({20.0, 0.0, 0.0});
  row.poses[2].matrix[3].y = 15.0;
  const glm::dvec3 own[] = {{0.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, -3.0}};
  for (std::size_t f = 0; f < 3; ++f)
    for (std::size_t m = f + 1; m < 3; ++m) row.pair(f, m, own[m] - own[f]);
  const auto group = warpGroup(row.views, row.poses, row.pairs, {}, noProgress());
  ASSERT_TRUE(group) << group.error();
  const glm::dvec3 inside(40.0, 35.0, 30.0);
  const glm::dvec3 mean = (own[0] + own[1] + own[2]) / 3.0;
  for (std::size_t v = 0; v < 3; ++v)
    EXPECT_LT(glm::distance(registration::displacementAt(group->warps[v], inside), own[v] - mean), 0.03) << v;
  EXPECT_LT(group->disagreement95_mm, 0.05);
}

TEST(WarpGroup, NeverFoldsHoweverFarAPairWantsToGo) {
  Row row(2);
  row.pair(0, 1, {60.0, 0.0, 0.0});
  const auto group = warpGroup(row.views, row.poses, row.pairs, {.fallOff_mm = 10.0}, noProgress());
  ASSERT_TRUE(group) << group.error();
  EXPECT_GE(group->smallestJacobian, 0.15);
  for (const auto& warp : group->warps) EXPECT_EQ(registration::jacobianOf(warp).folded, 0u);
}

TEST(WarpGroup, LeavesViewsWithoutPairsAlone) {
  Row row(3);
  row.pair(0, 1, {1.0, 0.0, 0.0});
  const auto group = warpGroup(row.views, row.poses, row.pairs, {}, noProgress());
  ASSERT_TRUE(group) << group.error();
  EXPECT_TRUE(group->warps[2].displacement_mm.empty());
}

TEST(WarpGroup, IsTheSameOnAnyNumberOfThreads) {
  Row row(3);
  row.pair(0, 1, {1.0, 2.0, 0.0});
  row.pair(1, 2, {0.0, -2.0, 1.0});
  const auto one = warpGroup(row.views, row.poses, row.pairs, {.threads = 1}, noProgress());
  for (const int threads : {2, 8}) {
    const auto many = warpGroup(row.views, row.poses, row.pairs, {.threads = threads}, noProgress());
    ASSERT_TRUE(one && many);
    EXPECT_EQ(one->warps, many->warps);
  }
}

}  // namespace
}  // namespace ew::stitching::group_warp_test
