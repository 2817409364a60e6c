#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "elastic/levels.h"
#include "elastic/residual_motion.h"
#include "registration/fields.h"
#include "registration/tissue.h"
#include "registration/warped_pairs.h"

/// The inside of the three-dimensional registration, through its own headers: levels, cost, prior, solver, folds, motion that is left.
namespace ew::elastic_parts_test {
namespace {

using namespace registration;
using test::imaged;
using test::Pair;
using test::Tissue;
using test::uprightGrid;
using test::warpedPair;

LevelImage levelOf(const Volume& volume, double voxel_mm) {
  LevelImage level;
  EXPECT_TRUE(makeLevel({&volume, {}}, {}, voxel_mm, 6.0, 1, noProgress(), level));
  return level;
}

TEST(ElasticLevel, HasTheSameValuesWhateverGainTheVolumeWasSeenWith) {
  const Grid grid = uprightGrid({40, 40, 40}, 1.0);
  const Tissue tissue(2, 5.0, 30.0);
  const Volume dark = imaged(grid, [&](const glm::dvec3& p) { return tissue.at(p); });
  const Volume bright = imaged(grid, [&](const glm::dvec3& p) { return tissue.at(p) + 20.0 + 0.8 * p.y; });
  const LevelImage a = levelOf(dark, 2.0), b = levelOf(bright, 2.0);
  double difference = 0.0, size = 0.0;
  for (int k = 2; k < 18; ++k) {
    for (int j = 2; j < 18; ++j) {
      for (int i = 2; i < 18; ++i) {
        const std::size_t at = a.rowOf(j, k) + static_cast<std::size_t>(i);
        difference += std::pow(static_cast<double>(a.values[at] - b.values[at]), 2);
        size += std::pow(static_cast<double>(a.values[at]), 2);
      }
    }
  }
  EXPECT_LT(std::sqrt(difference / size), 0.1);
}

TEST(ElasticLevel, TakesBlackThatReachesTheBorderForOutsideAndBlackWithinForTissue) {
  const Grid grid = uprightGrid({40, 40, 40}, 1.0);
  const Volume volume = imaged(grid, [](const glm::dvec3& p) {
    if (std::abs(p.x - 20.0) > 4.0 + 0.35 * p.y) return 0.0;                   // outside a sector
    return glm::distance(p, glm::dvec3(20.0, 26.0, 20.0)) < 7.0 ? 0.0 : 90.0;  // a vessel
  });
  const auto belief = beliefOf({&volume, {}});
  ASSERT_EQ(belief.size(), grid.voxelCount());
  EXPECT_EQ(belief[grid.indexOf(1, 5, 20)], 0);
  EXPECT_EQ(belief[grid.indexOf(38, 5, 20)], 0);
  EXPECT_EQ(belief[grid.indexOf(20, 26, 20)], 255);
  EXPECT_EQ(belief[grid.indexOf(20, 10, 20)], 255);
  EXPECT_TRUE(beliefOf({&volume, std::vector<float>()}).size() == grid.voxelCount());
}

TEST(ElasticLevel, CountsTheShadowOfOneViewLittleAndAllElseAsBefore) {
  const Grid grid = uprightGrid({64, 64, 64}, 1.0);
  const Tissue tissue(3, 5.0, 30.0);
  const auto inShadow = [](const glm::dvec3& p) { return std::hypot(p.x - 30.0, p.z - 34.0) < 5.0 && p.y > 20.0; };
  const Volume clear = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(p); }, 8.0, 1);
  // Another gain, and another depth gain, are no shadow.
  const Volume shadowed = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(p) + 15.0 + 10.0 * std::sin(p.y / 15.0) - (inShadow(p) ? 80.0 : 0.0); }, 8.0, 2);
  const LevelImage a = levelOf(clear, 2.0), b = levelOf(shadowed, 2.0);
  const NodeGrid nodes = nodesFor(grid, 8.0);
  const NodeValues nothing(4 * nodes.count(), 0.0F);
  for (const auto& [fixed, moving] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    LevelPair pair(*fixed, *moving, axesTransformOf(grid, grid, {}), nodes, 1);
    ASSERT_TRUE(pair.warp(nothing, noProgress()));
    ASSERT_TRUE(pair.doubtShadows(nothing, noProgress()));
    for (int warped = 0; warped < 2; ++warped) {  // the warp at hand, and those that follow
      double inside = 0.0, outside = 0.0, insideCount = 0.0, outsideCount = 0.0;
      for (int k = 0; k < 32; ++k) {
        for (int j = 0; j < 32; ++j) {
          for (int i = 0; i < 32; ++i) {
            const glm::dvec3 p(2.0 * i + 0.5, 2.0 * j + 0.5, 2.0 * k + 0.5);
            const double across = std::hypot(p.x - 30.0, p.z - 34.0),
                         weight = pair.movedWeights()[fixed->rowOf(j, k) + static_cast<std::size_t>(i)];
            if (across < 4.0 && p.y > 24.0) inside += weight, insideCount += 1.0;
            if (across > 10.0) outside += weight, outsideCount += 1.0;
          }
        }
      }
      EXPECT_LT(inside / insideCount, 0.35);
      EXPECT_GT(outside / outsideCount, 0.93);
      ASSERT_TRUE(pair.warp(nothing, noProgress()));
    }
  }
}

ResidualMotion leftOf(const Volume& fixed, const Volume& moving, int threads = 1) {
  LevelImage f, m;
  EXPECT_TRUE(makeLevel({&fixed, {}}, {}, 1.0, 6.0, 1, noProgress(), f));
  EXPECT_TRUE(makeLevel({&moving, {}}, {}, 1.0, 6.0, 1, noProgress(), m));
  const NodeGrid nodes = nodesFor(fixed.grid, 8.0);
  LevelPair pair(f, m, axesTransformOf(fixed.grid, moving.grid, {}), nodes, 1);
  EXPECT_TRUE(pair.warp(NodeValues(4 * nodes.count(), 0.0F), noProgress()));
  ResidualMotion left;
  EXPECT_TRUE(lookForResidualMotion(pair, nodes, threads, noProgress(), left));
  return left;
}

TEST(ResidualMotion, IsNoneWhereNothingMovesAndTheShiftWhereAllDoes) {
  const Grid grid = uprightGrid({42, 40, 38}, 1.0);
  const Tissue tissue(5);
  const auto shifted = [&](const glm::dvec3& by, unsigned seed) {
    return imaged(
        grid, [&](const glm::dvec3& p) { return tissue.at(p + by); }, 8.0, seed);
  };
  const Volume fixed = shifted({0, 0, 0}, 1);
  const ResidualMotion still = leftOf(fixed, shifted({0.3, 0.2, -0.3}, 2));
  EXPECT_GT(still.blocks, 50.0);
  EXPECT_LT(still.share, 0.2);
  const ResidualMotion moved = leftOf(fixed, shifted({2.0, 0.0, 0.0}, 2));
  EXPECT_GT(moved.blocks, 50.0);
  EXPECT_GT(moved.share, 0.9);
  EXPECT_NEAR(moved.length_mm, 2.0, 0.2);
  const ResidualMotion further = leftOf(fixed, shifted({2.0, -4.0, 2.0}, 2));
  EXPECT_GT(further.share, 0.9);
  EXPECT_NEAR(further.length_mm, std::sqrt(24.0), 0.3);
  // Halves that know nothing agree by chance: once in 125 shifts, once in 25 of a single layer, which is taken off.
  const auto noise = [](const Grid& of, unsigned seed) {
    return imaged(
        of, [](const glm::dvec3&) { return 100.0; }, 35.0, seed);
  };
  EXPECT_LT(leftOf(noise(grid, 3), noise(grid, 4)).blocks, 0.1 * moved.blocks);
  const Grid layer = uprightGrid({240, 240, 1}, 1.0);
  const ResidualMotion chance = leftOf(noise(layer, 5), noise(layer, 6));
  EXPECT_LT(chance.share * chance.blocks, 0.02 * 800.0);  // every second of 1600 is looked at
}

TEST(ResidualMotion, IsTheSameForAnyNumberOfThreadsAndNamesWhereItIs) {
  const Grid grid = uprightGrid({60, 36, 36}, 1.0);
  const Tissue tissue(7);
  const Volume fixed = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(p.x < 30.0 ? p : p + glm::dvec3(0.0, 2.0, 2.0)); }, 8.0, 1);
  const Volume moving = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(p); }, 8.0, 2);
  const ResidualMotion one = leftOf(fixed, moving, 1), four = leftOf(fixed, moving, 4);
  EXPECT_EQ(one.nodeShare, four.nodeShare);
  EXPECT_EQ(one.share, four.share);
  const NodeGrid nodes = nodesFor(grid, 8.0);
  ASSERT_EQ(one.nodeShare.size(), nodes.count());
  for (int k = 1; k + 1 < nodes.dims.z; ++k) {
    for (int j = 1; j + 1 < nodes.dims.y; ++j) {
      EXPECT_LT(one.nodeShare[nodes.indexOf(1, j, k)], 0.4F);
      EXPECT_GT(one.nodeShare[nodes.indexOf(nodes.dims.x - 2, j, k)], 0.8F);
    }
  }
}

TEST(ElasticCost, HasTheDerivativeThatDifferencesShow) {
  const Grid grid = uprightGrid({30, 26, 28}, 1.0);
  const Pair pair = warpedPair(grid, 1.5, 0.0);
  const LevelImage fixed = levelOf(pair.fixed, 1.0), moving = levelOf(pair.moving, 1.0);
  const NodeGrid nodes = nodesFor(grid, 9.0);
  LevelPair level(fixed, moving, axesTransformOf(grid, grid, {}), nodes, 1);
  NodeValues values(4 * nodes.count(), 0.0F);
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = 0.2F * std::sin(static_cast<float>(n));
  CostOptions options;
  options.scale = 0.8;
  options.ofFixed = 0.0;
  const auto costAt = [&](const NodeValues& at) {
    PairSums sums;
    EXPECT_TRUE(level.warp(at, noProgress()) && level.assemble(options, nullptr, sums, noProgress()));
    return 0.5 * sums.at[1];
  };
  ASSERT_TRUE(level.warp(values, noProgress()));
  NodeSystem system(nodes);
  PairSums sums;
  ASSERT_TRUE(level.assemble(options, &system, sums, noProgress()));
  double agree = 0.0, own = 0.0, shown = 0.0;
  for (std::size_t n = 0; n < nodes.count(); ++n) {
    // Nodes within: at the border samples come and go.
    const auto at = static_cast<int>(n);
    const glm::ivec3 place(at % nodes.dims.x, at / nodes.dims.x % nodes.dims.y, at / (nodes.dims.x * nodes.dims.y));
    if (glm::any(glm::equal(place, glm::ivec3(0))) || glm::any(glm::equal(place, nodes.dims - 1))) continue;
    for (std::size_t c = 0; c < 4; ++c) {
      NodeValues up = values, down = values;
      up[4 * n + c] += 0.15F;
      down[4 * n + c] -= 0.15F;
      const double difference = (costAt(up) - costAt(down)) / 0.3, derivative = -static_cast<double>(system.right[4 * n + c]);
      agree += difference * derivative;
      own += derivative * derivative;
      shown += difference * difference;
    }
  }
  EXPECT_GT(agree / std::sqrt(own * shown), 0.995);
  EXPECT_NEAR(std::sqrt(own / shown), 1.0, 0.05);
}

TEST(ElasticCost, HasTheMatrixOfItsGradients) {
  // With r = 0 everywhere the matrix is the second derivative of the cost: shifting one node by e costs e^2 / 2 of its diagonal.
  const Grid grid = uprightGrid({26, 26, 26}, 1.0);
  const Tissue tissue(6, 6.0);
  const Volume volume = imaged(grid, [&](const glm::dvec3& p) { return tissue.at(p); });
  const LevelImage image = levelOf(volume, 1.0);
  const NodeGrid nodes = nodesFor(grid, 8.7);
  LevelPair level(image, image, axesTransformOf(grid, grid, {}), nodes, 1);
  NodeValues values(4 * nodes.count(), 0.0F);
  CostOptions options;
  options.scale = 100.0;
  ASSERT_TRUE(level.warp(values, noProgress()));
  NodeSystem system(nodes);
  PairSums sums;
  ASSERT_TRUE(level.assemble(options, &system, sums, noProgress()));
  EXPECT_NEAR(sums.correlation(), 1.0, 1e-6);
  const std::size_t node = nodes.indexOf(1, 2, 1);
  for (std::size_t c = 0; c < 3; ++c) {
    for (float& v : values) v = 0.0F;
    values[4 * node + c] = 0.3F;
    PairSums moved;
    ASSERT_TRUE(level.warp(values, noProgress()) && level.assemble(options, nullptr, moved, noProgress()));
    for (std::size_t n = system.first[node]; n < system.first[node + 1]; ++n) {
      if (system.neighbour[n] != node) continue;
      EXPECT_NEAR(moved.at[1] / (0.09 * static_cast<double>(system.blocks[16 * n + 5 * c])), 1.0, 0.1);
    }
  }
}

TEST(ElasticPrior, KnowsNoShiftAndItsBendingNoAffineField) {
  const NodeGrid nodes{{5, 4, 6}, {8.0, 7.0, 9.0}, {0.0, 0.0, 0.0}};
  NodeValues shift(4 * nodes.count()), affine(shift.size()), out;
  for (int k = 0; k < 6; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 5; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          shift[4 * nodes.indexOf(i, j, k) + c] = 3.0F;
          affine[4 * nodes.indexOf(i, j, k) + c] =
              0.5F * static_cast<float>(i) - 0.25F * static_cast<float>(j) + 0.125F * static_cast<float>(k);
        }
      }
    }
  }
  applyPrior(nodes, {1.0, 1.0, 1.0, 0.0}, shift, out);
  for (const float v : out) EXPECT_NEAR(v, 0.0F, 1e-4F);
  applyPrior(nodes, {0.0, 1.0, 0.0, 0.0}, affine, out);
  for (const float v : out) EXPECT_NEAR(v, 0.0F, 1e-4F);
  applyPrior(nodes, {1.0, 0.0, 0.0, 0.0}, affine, out);
  EXPECT_GT(*std::max_element(out.begin(), out.end()), 1.0F);
}

/// The prior's forces from its energy as node_system.h writes it, difference by difference.
NodeValues forcesByDifferences(const NodeGrid& grid, const Prior& prior, const NodeValues& values) {
  std::vector<double> forces(values.size(), 0.0);
  const auto add = [&](const std::vector<std::pair<glm::ivec3, double>>& nodes, std::size_t c, double weight) {
    double difference = 0.0;
    for (const auto& [at, factor] : nodes) {
      if (glm::any(glm::greaterThanEqual(at, grid.dims))) return;
      difference += factor * static_cast<double>(values[4 * grid.indexOf(at.x, at.y, at.z) + c]);
    }
    for (const auto& [at, factor] : nodes) forces[4 * grid.indexOf(at.x, at.y, at.z) + c] += weight * factor * difference;
  };
  const double volume = grid.cellVolume_mm3();
  for (int n = 0; n < static_cast<int>(grid.count()); ++n) {
    const glm::ivec3 at(n % grid.dims.x, n / grid.dims.x % grid.dims.y, n / grid.dims.x / grid.dims.y);
    for (std::size_t c = 0; c < 4; ++c) {
      for (int a = 0; a < 3; ++a) {
        glm::ivec3 along(0);
        along[a] = 1;
        const double perSpacing2 = std::pow(grid.spacing_mm[a], -2.0);
        add({{at, -1.0}, {at + along, 1.0}}, c, volume * perSpacing2 * (c == 3 ? prior.brightnessMembrane : prior.membrane));
        if (c == 3) continue;
        add({{at, 1.0}, {at + along, -2.0}, {at + 2 * along, 1.0}}, c, volume * prior.bending * perSpacing2 * perSpacing2);
        for (int b = a + 1; b < 3; ++b) {
          glm::ivec3 across(0);
          across[b] = 1;
          add({{at, 1.0}, {at + along, -1.0}, {at + across, -1.0}, {at + along + across, 1.0}}, c,
              2.0 * volume * prior.bending * perSpacing2 * std::pow(grid.spacing_mm[b], -2.0));
        }
      }
      if (c == 3) add({{at, 1.0}}, c, volume * prior.brightness);
    }
  }
  return {forces.begin(), forces.end()};
}

TEST(Prior, ForcesAreThoseOfItsDifferencesOnGridsOfEveryShape) {
  std::minstd_rand random(5);
  std::uniform_real_distribution<float> level(-2.0F, 2.0F);
  for (const glm::ivec3 dims : {glm::ivec3(6, 4, 3), glm::ivec3(1, 3, 2), glm::ivec3(2, 2, 1), glm::ivec3(3, 1, 6), glm::ivec3(1, 1, 1)}) {
    const NodeGrid grid{dims, {2.0, 3.0, 1.5}, {}};
    NodeValues values(4 * grid.count()), out;
    for (float& v : values) v = level(random);
    for (const Prior& prior :
         {Prior{0.7, 0.0, 0.0, 0.0}, Prior{0.0, 1.3, 0.0, 0.0}, Prior{0.0, 0.0, 0.4, 0.9}, Prior{0.7, 1.3, 0.4, 0.9}}) {
      applyPrior(grid, prior, values, out);
      const NodeValues expected = forcesByDifferences(grid, prior, values);
      for (std::size_t n = 0; n < out.size(); ++n) ASSERT_NEAR(out[n], expected[n], 2e-4F) << n << " of " << dims.x << dims.y << dims.z;
    }
  }
}

TEST(ElasticSolver, SolvesItsSystemAndNamesOneWithoutStiffness) {
  const Grid grid = uprightGrid({40, 40, 40}, 1.0);
  const Pair pair = warpedPair(grid, 2.0, 5.0);
  const LevelImage fixed = levelOf(pair.fixed, 2.0), moving = levelOf(pair.moving, 2.0);
  const NodeGrid nodes = nodesFor(grid, 8.0);
  LevelPair level(fixed, moving, axesTransformOf(grid, grid, {}), nodes, 1);
  NodeSystem system(nodes);
  PairSums sums;
  ASSERT_TRUE(level.warp(NodeValues(4 * nodes.count(), 0.0F), noProgress()) && level.assemble({}, &system, sums, noProgress()));
  const Prior prior{1e-3, 1.0, 1e-2, 1e-3};
  const Solution solution = solve(system, 0.5, prior, system.right, 1e-5, 300);
  EXPECT_FALSE(solution.singular);
  NodeValues data(system.right.size()), stiff;
  multiplyData(system, 0.5, solution.values, data);
  applyPrior(nodes, prior, solution.values, stiff);
  double off = 0.0, size = 0.0;
  for (std::size_t n = 0; n < data.size(); ++n) {
    off += std::pow(static_cast<double>(data[n] + stiff[n] - system.right[n]), 2);
    size += std::pow(static_cast<double>(system.right[n]), 2);
  }
  EXPECT_LT(std::sqrt(off / size), 1e-3);
  EXPECT_LT(solution.iterations, 60);

  const NodeSystem nothing(nodes);
  EXPECT_TRUE(solve(nothing, 1.0, prior, system.right, 1e-3, 50).singular);
}

TEST(ElasticSolver, GivesTheSameBitsOnEveryNumberOfThreads) {
  // Large enough for several threads, and of odd sizes: columns of four floats are left beside the wide ones.
  const NodeGrid nodes{{19, 17, 15}, {6.0, 5.0, 7.0}, {0.0, 0.0, 0.0}};
  NodeSystem system(nodes);
  std::mt19937 random(11);
  std::uniform_real_distribution<float> level(-1.0F, 1.0F);
  for (std::size_t n = 0; n < nodes.count(); ++n)
    for (std::size_t block = system.first[n]; block < system.first[n + 1]; ++block)
      if (system.neighbour[block] == n)
        for (std::size_t c = 0; c < 4; ++c) system.blocks[16 * block + 5 * c] = 2.0F + level(random);
  for (float& value : system.right) value = level(random);
  const Prior prior{1e-2, 1.0, 1e-2, 1e-3};
  const Solution one = solve(system, 0.5, prior, system.right, 1e-6, 60, 1);
  EXPECT_GT(one.iterations, 3);
  for (const int threads : {2, 3, 8}) {
    const Solution several = solve(system, 0.5, prior, system.right, 1e-6, 60, threads);
    EXPECT_EQ(several.values, one.values) << threads;
    EXPECT_EQ(several.iterations, one.iterations);
  }
}

TEST(Unfold, BringsEveryCellAboveTheLeastJacobianAndLeavesTheRestAlone) {
  const NodeGrid nodes{{8, 8, 8}, {6.0, 6.0, 6.0}, {0.0, 0.0, 0.0}};
  NodeValues values(4 * nodes.count(), 0.0F);
  values[4 * nodes.indexOf(3, 3, 3)] = 9.0F;
  ASSERT_LT(leastJacobianOf(nodes, values), 0.0);
  EXPECT_TRUE(unfold(nodes, 0.15, values));
  EXPECT_GE(leastJacobianOf(nodes, values), 0.15);
  EXPECT_GT(values[4 * nodes.indexOf(3, 3, 3)], 1.0F);
  EXPECT_EQ(values[4 * nodes.indexOf(7, 7, 7)], 0.0F);
}

}  // namespace
}  // namespace ew::elastic_parts_test
