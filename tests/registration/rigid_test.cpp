#include "ew/registration/rigid.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <thread>

#include "comparable.h"
#include "counted_stop.h"
#include "registration/ellipsoids.h"
#include "registration/shadows.h"
#include "rigid/normal_equations.h"
#include "rigid/pose_search.h"
#include "rigid/refine.h"
#include "rigid/translations.h"

namespace {

// What the program holds of memory from operator new, and the most it held since the last reset.
std::atomic<std::int64_t> held{0};
std::atomic<std::int64_t> mostHeld{0};

// Inlined, GCC 12 takes what is freed below for something else.
[[gnu::noinline]] void* take(std::size_t size) noexcept {
  void* block = std::malloc(size + 16);
  if (block == nullptr) return nullptr;
  *static_cast<std::size_t*>(block) = size;
  const std::int64_t now = held += static_cast<std::int64_t>(size);
  std::int64_t most = mostHeld.load();
  while (most < now && !mostHeld.compare_exchange_weak(most, now)) {
  }
  return static_cast<char*>(block) + 16;
}
[[gnu::noinline]] void giveBack(void* place) noexcept {
  if (place == nullptr) return;
  void* block = static_cast<char*>(place) - 16;
  held -= static_cast<std::int64_t>(*static_cast<std::size_t*>(block));
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
  if (void* place = take(size)) return place;
  throw std::bad_alloc();
}
// The sanitizers' own does not come by the one above, and what it gives would end in the delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return take(size); }
void operator delete(void* place) noexcept { giveBack(place); }
void operator delete(void* place, std::size_t) noexcept { giveBack(place); }

namespace ew::registration::rigid_test {
namespace {

using ew::test::shadowed;
using test::apart_mm;
using test::centred;
using test::motion;
using test::pose;
using test::seen;
using test::tissue;

struct Pair {
  Volume fixed;
  Volume moving;
  Transform<frame::Moving, frame::Fixed> truth;
};
Pair pairOf(const Transform<frame::Moving, frame::Fixed>& truth, unsigned seed = 1, int side = 44, double voxel_mm = 1.5,
            double speckle = 18.0) {
  const auto all = tissue(seed, 1.8 * side * voxel_mm);
  const Grid grid = centred(glm::ivec3(side), voxel_mm);
  return {seen(all, grid, {}, 100 + seed, speckle), seen(all, grid, inverse(truth), 200 + seed, speckle, 0.8, 20.0), truth};
}

TEST(NormalEquations, AreThoseOfAPlainSumOverVoxels) {
  const Pair pair = pairOf(pose({2.0, -1.0, 1.5}, {4.0, -3.0, 5.0}), 4, 20, 2.0);
  const std::vector<double> voxels{2.0};
  const auto f = comparableImages({&pair.fixed}, voxels, {}, noProgress());
  const auto m = comparableImages({&pair.moving}, voxels, {}, noProgress());
  ASSERT_TRUE(f && m);
  const ComparableImage& fixed = (*f)[0];
  const KernelImage moving = packed((*m)[0]);
  const glm::dvec3 centre(3.0, -2.0, 1.0);
  const double loss = 1.5;
  PoseSums sums;
  ASSERT_TRUE(sumOverPair(fixed, moving, pair.truth, centre, {loss, 0, -1, false, true}, 1, noProgress(), sums));

  const glm::dmat4 toVoxel = (moving.grid.toVoxel<frame::Moving>() * pair.truth * fixed.grid.voxelTo<frame::Fixed>()).matrix;
  const auto valueAt = [&](const glm::dvec3& p, bool& covered) {
    const glm::ivec3 q(glm::floor(p));
    covered = false;
    for (int a = 0; a < 3; ++a) {
      if (q[a] < 0 || q[a] > moving.grid.dims[a] - 2 || p[a] < 0.001 || p[a] > moving.grid.dims[a] - 1.001) return 0.0;
    }
    const glm::dvec3 t = p - glm::dvec3(q);
    double sum = 0.0;
    covered = true;
    for (int c = 0; c < 8; ++c) {
      const glm::ivec3 at = q + glm::ivec3(c & 1, c >> 1 & 1, c >> 2);
      const std::size_t index = moving.grid.indexOf(at.x, at.y, at.z);
      covered = covered && (*m)[0].weight[index] != 0;
      sum += static_cast<double>((*m)[0].value[index]) * ((c & 1) != 0 ? t.x : 1.0 - t.x) * ((c & 2) != 0 ? t.y : 1.0 - t.y) *
             ((c & 4) != 0 ? t.z : 1.0 - t.z);
    }
    return sum;
  };
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  double count = 0.0;
  const glm::ivec3 dims = fixed.grid.dims;
  for (int k = 1; k < dims.z - 1; ++k) {
    for (int j = 1; j < dims.y - 1; ++j) {
      for (int i = 1; i < dims.x - 1; ++i) {
        const std::size_t at = fixed.grid.indexOf(i, j, k);
        if (fixed.inner[at] == 0) continue;
        const glm::dvec4 voxel(i, j, k, 1.0);
        const glm::dvec3 p(toVoxel * voxel);
        bool covered = false;
        const double value = valueAt(p, covered);
        if (!covered) continue;
        ++count;
        // Derivatives by differences, both taken in voxels of the fixed image.
        glm::dvec3 gradient(0.0);
        const std::size_t step[3]{1, static_cast<std::size_t>(dims.x), static_cast<std::size_t>(dims.x) * dims.y};
        for (int a = 0; a < 3; ++a) {
          glm::dvec3 moved(0.0);  // inside one cell the interpolant is smooth: its derivative along moving axes, by differences within it
          for (int b = 0; b < 3; ++b) {
            const double low = std::floor(p[b]);
            glm::dvec3 q0 = p;
            glm::dvec3 q1 = p;
            q0[b] = low + 0.25;
            q1[b] = low + 0.75;
            bool ignored = false;
            moved[b] = 2.0 * (valueAt(q1, ignored) - valueAt(q0, ignored));
          }
          gradient[a] = 0.25 * static_cast<double>(fixed.value[at + step[a]] - fixed.value[at - step[a]]) +
                        0.5 * glm::dot(moved, glm::dvec3(toVoxel[a]));
        }
        const glm::dvec3 g = fixed.grid.directions * gradient / fixed.grid.spacing_mm.x;
        const glm::dvec3 lever = glm::dvec3(fixed.grid.voxelToWorld().matrix * voxel) - centre;
        const glm::dvec3 turn = glm::cross(lever, g);
        Eigen::Matrix<double, 6, 1> row;
        row << g.x, g.y, g.z, turn.x, turn.y, turn.z;
        const double residual = static_cast<double>(fixed.value[at]) - value;
        const double weight = 1.0 / (1.0 + residual * residual / (loss * loss));
        normal += weight * row * row.transpose();
        right += weight * residual * row;
      }
    }
  }
  EXPECT_EQ(sums.count, count);
  ASSERT_GT(count, 1000.0);
  for (int r = 0; r < 6; ++r) {
    EXPECT_NEAR(sums.right[r], right[r], 2e-3 * std::sqrt(normal(r, r) * count));
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(sums.normal[6 * r + c], normal(r, c), 2e-3 * std::sqrt(normal(r, r) * normal(c, c))) << r << c;
  }
}

TEST(Turns, EveryTurnWithinReachHasANeighbourOnTheLattice) {
  for (const double most_deg : {30.0, 180.0}) {
    const double step_deg = most_deg > 90.0 ? 20.0 : 10.0;
    const auto turns = rotationLattice(most_deg * 0.0174532925, step_deg * 0.0174532925);
    EXPECT_EQ(turns.front(), glm::dvec3(0.0));
    std::mt19937 random(5);
    double worst = 0.0;
    for (int trial = 0; trial < 300; ++trial) {
      glm::dvec3 axis;
      do {
        for (int a = 0; a < 3; ++a) axis[a] = static_cast<double>(random()) / 2147483648.0 - 1.0;
      } while (glm::length(axis) > 1.0 || glm::length(axis) < 0.1);
      const Transform<frame::Moving, frame::Fixed> wanted{
          glm::dmat4(rotationBy(glm::normalize(axis) * most_deg * 0.0174532925 * (static_cast<double>(random()) / 4294967296.0)))};
      double nearest = 1e9;
      for (const auto& turn : turns) nearest = std::min(nearest, rotationBetween_rad(wanted, {glm::dmat4(rotationBy(turn))}));
      worst = std::max(worst, nearest);
    }
    EXPECT_LT(worst * 57.2957795, 0.95 * step_deg) << most_deg;
  }
}

TEST(Translations, AgreeWithAPlainSumOverEveryShift) {
  const Pair pair = pairOf(pose({9.0, -6.0, 3.0}, {}), 6, 12, 3.0, 5.0);
  const std::vector<double> voxels{3.0};
  const auto f = comparableImages({&pair.fixed}, voxels, {}, noProgress());
  const auto m = comparableImages({&pair.moving}, voxels, {}, noProgress());
  ASSERT_TRUE(f && m);
  const ComparableImage& fixed = (*f)[0];
  const ComparableImage& moving = (*m)[0];
  const auto peaks = correlateOverTranslations(fixed, moving, {glm::dvec3(0.0)}, {0.1, 1, 1}, noProgress());
  ASSERT_EQ(peaks.size(), 1u);
  double best = -1e9;
  glm::ivec3 bestShift(0);
  double bestCells = 0.0;
  for (int dz = -11; dz <= 11; ++dz) {
    for (int dy = -11; dy <= 11; ++dy) {
      for (int dx = -11; dx <= 11; ++dx) {
        double sum = 0.0;
        double cells = 0.0;
        for (int k = std::max(0, -dz); k < std::min(12, 12 - dz); ++k) {
          for (int j = std::max(0, -dy); j < std::min(12, 12 - dy); ++j) {
            for (int i = std::max(0, -dx); i < std::min(12, 12 - dx); ++i) {
              sum +=
                  static_cast<double>(fixed.value[fixed.grid.indexOf(i, j, k)] * moving.value[moving.grid.indexOf(i + dx, j + dy, k + dz)]);
              cells += 1.0;
            }
          }
        }
        if (cells < 172.8 || sum / std::sqrt(cells) <= best) continue;
        best = sum / std::sqrt(cells);
        bestShift = {dx, dy, dz};
        bestCells = cells;
      }
    }
  }
  EXPECT_NEAR(peaks[0].overlapCells, bestCells, 0.01);
  EXPECT_LT(glm::length(glm::dvec3(peaks[0].fixedToMoving.matrix[3]) - 3.0 * glm::dvec3(bestShift)), 1e-6);
  EXPECT_LT(glm::length(glm::dvec3(pair.truth.matrix[3]) - 3.0 * glm::dvec3(bestShift)), 1e-6) << "the phantom is too plain";
}

TEST(RefineRigid, FindsAKnownPoseFromFiveMillimetresAndEightDegreesOff) {
  const Pair pair = pairOf(pose({6.0, -4.0, 3.0}, {5.0, 8.0, -3.0}));
  int levels = 0;
  const auto found = refineRigid({&pair.fixed}, {&pair.moving}, pair.truth * motion({3.0, 3.0, -2.5}, {5.0, -5.0, 4.0}), {}, noProgress(),
                                 [&](const Level&) { ++levels; });
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(apart_mm(found->fixedToMoving, pair.truth, pair.fixed.grid), 0.35);
  EXPECT_EQ(levels, static_cast<int>(found->levels.size()));
  EXPECT_GT(found->after.correlation, found->before.correlation + 0.2);
  EXPECT_GT(found->after.correlation, found->after.chance);
  EXPECT_TRUE(checkRigid(found->fixedToMoving, 1e-9));
}

TEST(RefineRigid, GivesTheSamePoseOnLeftHandedObliqueAndAnisotropicGrids) {
  const auto all = tissue(8, 110.0);
  Grid odd = centred({44, 44, 30}, 1.5);
  odd.spacing_mm = {1.5, 1.2, 2.2};
  const glm::dmat3 turn(pose({}, {40.0, -20.0, 60.0}).matrix);
  odd.directions = glm::dmat3(turn[1], turn[0], turn[2]);
  odd.origin_mm = -(odd.directions * (0.5 * odd.spacing_mm * glm::dvec3(odd.dims - 1)));
  const auto truth = pose({5.0, 2.0, -4.0}, {6.0, -4.0, 5.0});
  const Volume fixed = seen(all, centred(glm::ivec3(44), 1.5), {}, 1);
  const Volume moving = seen(all, odd, inverse(truth), 2);
  const auto found = refineRigid({&fixed}, {&moving}, truth * motion({2.0, -2.0, 1.0}, {3.0, 2.0, -3.0}), {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(apart_mm(found->fixedToMoving, truth, fixed.grid), 0.5);
}

TEST(RefineRigid, StatesAnErrorThatMatchesTheSpreadOverTwelveSeeds) {
  double normalised = 0.0;
  int seeds = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const Pair pair = pairOf(pose({4.0, -3.0, 2.0}, {3.0, 4.0, -5.0}), seed, 36);
    const auto found = refineRigid({&pair.fixed}, {&pair.moving}, pair.truth, {}, noProgress());
    ASSERT_TRUE(found);
    ASSERT_TRUE(found->covariance) << found->reason;
    // found = truth * exp(error) about the centre, as the covariance says it.
    const glm::dmat4 error = (inverse(pair.truth) * found->fixedToMoving).matrix;
    const glm::dvec3 centre = found->centre_mm;
    const glm::dvec3 shift = glm::dvec3(error * glm::dvec4(centre, 1.0)) - centre;
    const glm::dvec3 turn = 0.5 * glm::dvec3(error[1][2] - error[2][1], error[2][0] - error[0][2], error[0][1] - error[1][0]);
    Eigen::Matrix<double, 6, 1> e;
    e << shift.x, shift.y, shift.z, turn.x, turn.y, turn.z;
    const Eigen::Map<const Eigen::Matrix<double, 6, 6>> covariance(found->covariance->data());
    normalised += e.dot(covariance.ldlt().solve(e)) / 6.0;
    ++seeds;
  }
  normalised /= seeds;
  EXPECT_GT(normalised, 0.4) << "stated errors are too large";
  EXPECT_LT(normalised, 2.5) << "stated errors are too small";
}

TEST(RefineRigid, StatesALargerErrorWhereItGoesBackToTheStart) {
  // Without a stated error an aligned pair would be lost to the graph.
  const auto start = pose({4.0, -3.0, 2.0}, {30.0, 4.0, -50.0});
  const glm::dvec3 shift(0.3, -0.2, 0.1);
  const glm::dvec3 turn(0.01, -0.03, 0.02);
  RigidResult result;
  result.centre_mm = {20.0, -10.0, 5.0};
  result.fixedToMoving = start * motionAbout(result.centre_mm, shift, turn);
  PoseCovariance stated{};
  for (std::size_t k = 0; k < 36; ++k) stated[k] = k % 7 == 0 ? 0.04 : 0.001;
  result.covariance = stated;
  keepInstead(start, result);
  EXPECT_EQ(result.fixedToMoving, start);
  EXPECT_EQ(result.stop, StopReason::noImprovement);
  ASSERT_TRUE(result.covariance);
  const std::array<double, 6> error{shift.x, shift.y, shift.z, turn.x, turn.y, turn.z};
  for (std::size_t r = 0; r < 6; ++r)
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR((*result.covariance)[6 * r + c], stated[6 * r + c] + error[r] * error[c], 1e-12);
  result.covariance.reset();
  keepInstead(start, result);
  EXPECT_FALSE(result.covariance);
}

TEST(RefineRigid, SearchesAboutAStartFromWhichDescendingLeadsNowhere) {
  const Pair pair = pairOf(pose({6.0, -4.0, 3.0}, {5.0, 8.0, -3.0}), 4);
  const auto start = pair.truth * motion({11.0, -12.0, 9.0}, {10.0, -11.0, 9.0});
  const auto descended = refineRigid({&pair.fixed}, {&pair.moving}, start, {}, noProgress());
  ASSERT_TRUE(descended);
  EXPECT_NE(descended->verdict, Verdict::aligned) << "the start is too easy: " << descended->reason;
  const auto searched = refineRigid({&pair.fixed}, {&pair.moving}, start, {.searchRotation_deg = 20.0}, noProgress());
  ASSERT_TRUE(searched);
  EXPECT_EQ(searched->verdict, Verdict::aligned) << searched->reason;
  EXPECT_LT(apart_mm(searched->fixedToMoving, pair.truth, pair.fixed.grid), 0.5);
  EXPECT_NE(searched->reason.english().find("search about it"), std::string::npos) << searched->reason;
  EXPECT_EQ(searched->before, descended->before);
  // A start that is believed to a few millimetres rules that pose out.
  const auto narrow = refineRigid({&pair.fixed}, {&pair.moving}, start, {.searchRotation_deg = 20.0, .searchShift_mm = 5.0}, noProgress());
  ASSERT_TRUE(narrow);
  EXPECT_EQ(narrow->verdict, descended->verdict);
  EXPECT_EQ(narrow->reason, descended->reason);
}

TEST(RefineRigid, SearchingAboutAStartAlignsNoUnrelatedTissue) {
  const Grid grid = centred(glm::ivec3(44), 1.5);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Volume fixed = seen(tissue(10 * seed + 1, 110.0), grid, {}, 1);
    const Volume moving = seen(tissue(10 * seed + 2, 110.0), grid, {}, 2);
    const auto found = refineRigid({&fixed}, {&moving}, pose({3.0, 0.0, 2.0}, {4.0, 0.0, 0.0}), {.searchRotation_deg = 20.0}, noProgress());
    ASSERT_TRUE(found);
    EXPECT_NE(found->verdict, Verdict::aligned) << found->reason;
  }
}

TEST(RefineRigid, LeavesOutWhatConfidenceDistrusts) {
  Pair pair = pairOf(pose({3.0, 1.0, -2.0}, {2.0, 3.0, 1.0}), 9);
  // Half of the moving view shows another tissue, and is said to.
  const auto other = tissue(99, 120.0);
  const Volume wrong = seen(other, pair.moving.grid, {}, 5);
  std::vector<float> confidence(pair.moving.echo.size(), 1.0F);
  for (std::size_t q = 0; q < pair.moving.echo.size(); ++q) {
    if (q % 44 < 20) {
      pair.moving.echo[q] = wrong.echo[q];
      confidence[q] = 0.0F;
    }
  }
  const auto start = pair.truth * motion({2.0, 1.0, -1.0}, {2.0, -2.0, 1.0});
  const auto weighted = refineRigid({&pair.fixed}, {&pair.moving, confidence}, start, {}, noProgress());
  ASSERT_TRUE(weighted);
  EXPECT_EQ(weighted->verdict, Verdict::aligned) << weighted->reason;
  EXPECT_LT(apart_mm(weighted->fixedToMoving, pair.truth, pair.fixed.grid), 0.5);
  EXPECT_LT(weighted->after.overlapShare, 0.95);
}

TEST(MatchPartial, FindsThirtyPercentOverlapTurnedByTwentyDegreesWithoutAStart) {
  const Pair pair = pairOf(pose({-24.0, 26.0, 3.0}, {12.0, -8.0, 14.0}), 3, 52);
  const auto found = matchPartial({&pair.fixed}, {&pair.moving}, {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->best.verdict, Verdict::aligned) << found->best.reason;
  EXPECT_LT(apart_mm(found->best.fixedToMoving, pair.truth, pair.fixed.grid), 0.8);
  EXPECT_LT(found->best.after.overlapShare, 0.45);
  EXPECT_GT(found->margin, 1.8);
  ASSERT_FALSE(found->hypotheses.empty());
  for (std::size_t h = 1; h < found->hypotheses.size(); ++h) {
    EXPECT_LE(found->hypotheses[h].significance, found->hypotheses[h - 1].significance);
  }
}

TEST(MatchPartial, RefusesTissueOfTwoDifferentPatients) {
  const Grid grid = centred(glm::ivec3(48), 1.5);
  const Volume fixed = seen(tissue(11, 110.0), grid, {}, 1);
  const Volume moving = seen(tissue(12, 110.0), grid, {}, 2);
  const auto found = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->best.verdict, Verdict::notAligned) << found->best.reason;
}

TEST(MatchPartial, AndRefinementAreBitEqualForOneTwoAndEightThreads) {
  const Pair pair = pairOf(pose({10.0, -8.0, 4.0}, {6.0, -8.0, 5.0}), 5, 36);
  PartialOptions options;
  options.threads = 1;
  const auto one = matchPartial({&pair.fixed}, {&pair.moving}, options, noProgress());
  ASSERT_TRUE(one);
  for (const int threads : {2, 8}) {
    options.threads = threads;
    const auto many = matchPartial({&pair.fixed}, {&pair.moving}, options, noProgress());
    ASSERT_TRUE(many);
    EXPECT_EQ(one->best.fixedToMoving, many->best.fixedToMoving);
    EXPECT_EQ(one->best.covariance, many->best.covariance);
    EXPECT_EQ(one->margin, many->margin);
    EXPECT_EQ(one->best.halvesDisagree_mm, many->best.halvesDisagree_mm);
  }
}

TEST(MatchPartial, StopsAtItsNextQuestionWhereverItIs) {
  const Pair pair = pairOf(pose({10.0, -8.0, 4.0}, {6.0, -8.0, 5.0}), 5, 64);
  PartialOptions options;
  options.maxRotation_deg = 10.0;
  for (const double after : {0.01, 0.1, 0.3, 0.6, 0.72, 0.9}) {
    auto progress = ew::test::CountedStop::atFraction(after);
    const auto found = matchPartial({&pair.fixed}, {&pair.moving}, options, progress);
    ASSERT_FALSE(found) << after;
    EXPECT_EQ(found.error().code, ErrorCode::cancelled);
    EXPECT_LE(progress.questionsAfter(), ew::test::kMostQuestionsAfter) << after;
    EXPECT_LE(progress.reportsAfter(), ew::test::kMostReportsAfter) << after;
    RecordProperty("questions", static_cast<int>(progress.questions()));
  }
}

TEST(MatchPartial, ForecastsTheMemoryItTakes) {
  for (const int side : {40, 96}) {
    Volume volume = seen(tissue(2, 60.0, 0.1), centred({side, side, side / 2}, 0.8), {}, 3);
    PartialOptions options;
    options.maxRotation_deg = 5.0;
    options.threads = 1;
    const std::int64_t before = held;
    mostHeld = before;
    const auto found = matchPartial({&volume}, {&volume}, options, noProgress());
    ASSERT_TRUE(found);
    const auto took = static_cast<double>(mostHeld - before);
    const auto said = static_cast<double>(forecastPartial_bytes(volume.grid, volume.grid, options));
    EXPECT_LT(took, 1.02 * said + 1e5) << side;
    EXPECT_GT(took, 0.5 * said - 1e6) << side;
  }
}

TEST(RefineRigid, AndMatchPartialAreNotDrawnAwayByShadowsThatTurnWithTheProbe) {
  // The same tissue from two directions, the same shadows along each view's own beams: brought beam to beam they agree best.
  const glm::dvec3 beam(0.0, 0.0, 1.0);
  Pair pair = pairOf(pose({2.0, -4.0, 3.0}, {13.0, 0.0, 0.0}), 3, 48);
  pair.fixed = shadowed(std::move(pair.fixed), beam, 0.75);
  pair.moving = shadowed(std::move(pair.moving), beam, 0.75);
  for (const bool given : {false, true}) {
    const Input fixed{&pair.fixed, {}, given ? std::optional(Beams{beam}) : std::nullopt};
    const Input moving{&pair.moving, {}, given ? std::optional(Beams{beam}) : std::nullopt};
    const auto refined = refineRigid(fixed, moving, pair.truth, {}, noProgress());
    ASSERT_TRUE(refined);
    EXPECT_EQ(refined->verdict, Verdict::aligned) << refined->reason;
    EXPECT_LT(apart_mm(refined->fixedToMoving, pair.truth, pair.fixed.grid), 1.0) << refined->reason;
    RefineOptions threaded;
    threaded.threads = 8;
    const auto same = refineRigid(fixed, moving, pair.truth, threaded, noProgress());
    ASSERT_TRUE(same);
    EXPECT_EQ(refined->fixedToMoving, same->fixedToMoving);
    const auto matched = matchPartial(fixed, moving, {}, noProgress());
    ASSERT_TRUE(matched);
    EXPECT_EQ(matched->best.verdict, Verdict::aligned) << matched->best.reason;
    EXPECT_LT(apart_mm(matched->best.fixedToMoving, pair.truth, pair.fixed.grid), 1.0) << matched->best.reason;
    EXPECT_EQ(matched->best.reason.english().find("streaks were taken out") != std::string::npos, !given) << matched->best.reason;
  }
}

TEST(RefineRigid, RefusesWhatItCannotUseInASentence) {
  Pair pair = pairOf({}, 1, 16, 3.0);
  const auto code = [&](const Input& f, const Input& m, const Transform<frame::Moving, frame::Fixed>& start,
                        const RefineOptions& options = {}) {
    const auto found = refineRigid(f, m, start, options, noProgress());
    return found ? ErrorCode::internal : found.error().code;
  };
  const Transform<frame::Moving, frame::Fixed> one;
  std::vector<float> few(7, 1.0F);
  EXPECT_EQ(code({&pair.fixed, few}, {&pair.moving}, one), ErrorCode::badField);
  std::vector<float> wild(pair.fixed.echo.size(), 1.5F);
  EXPECT_EQ(code({&pair.fixed, wild}, {&pair.moving}, one), ErrorCode::badField);
  EXPECT_EQ(code({&pair.fixed}, {&pair.moving}, {2.0 * one.matrix}), ErrorCode::notRigid);
  EXPECT_EQ(code({&pair.fixed}, {&pair.moving}, one, {.finest_mm = -1.0}), ErrorCode::badField);
  EXPECT_EQ(code({&pair.fixed, {}, Beams{}}, {&pair.moving}, one), ErrorCode::badField);
  EXPECT_EQ(code({&pair.fixed}, {&pair.moving, {}, Beams{{NAN, 0.0, 1.0}}}, one), ErrorCode::badField);
  EXPECT_EQ(code({&pair.fixed, {}, Beams{{0.0, 1.0, 0.0}, Beams::Fan{{NAN, 0.0, 0.0}, {}}}}, {&pair.moving}, one), ErrorCode::badField);
  Volume none;
  EXPECT_EQ(code({&none}, {&pair.moving}, one), ErrorCode::emptyVolume);
  Volume unseen = pair.fixed;
  unseen.coverage.assign(unseen.echo.size(), 0);
  EXPECT_EQ(code({&unseen}, {&pair.moving}, one), ErrorCode::emptyVolume);
  PartialOptions partial;
  partial.maxRotation_deg = 200.0;
  const auto found = matchPartial({&pair.fixed}, {&pair.moving}, partial, noProgress());
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::badField);
  EXPECT_NE(found.error().sentence().find("maxRotation_deg"), std::string::npos);
}

}  // namespace
}  // namespace ew::registration::rigid_test
