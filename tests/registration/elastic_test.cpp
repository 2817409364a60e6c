#include "ew/registration/elastic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "counted_stop.h"
#include "registration/fields.h"
#include "registration/rising_progress.h"
#include "registration/shadows.h"
#include "registration/tissue.h"
#include "registration/warped_pairs.h"

namespace ew::elastic_test {
namespace {

using namespace registration;
using test::imaged;
using test::kTurn;
using test::Pair;
using test::shadowed;
using test::Tissue;
using test::uprightGrid;
using test::warp;
using test::warpedPair;

struct Errors {
  double mean = 0.0;
  double p95 = 0.0;
};
/// Over voxels whose true mate lies in the moving volume.
Errors errorsOf(const Deformation& found, const Grid& fixed, const Grid& moving,
                const std::function<glm::dvec3(const glm::dvec3&)>& truth) {
  std::vector<double> errors;
  const auto toWorld = fixed.voxelToWorld();
  const auto toMoving = moving.worldToVoxel();
  for (int k = 0; k < fixed.dims.z; k += 2) {
    for (int j = 0; j < fixed.dims.y; j += 2) {
      for (int i = 0; i < fixed.dims.x; i += 2) {
        const glm::dvec3 p = (toWorld * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at, mate = truth(p);
        const glm::dvec3 index = (toMoving * Point<frame::World>{mate}).at;
        if (glm::any(glm::lessThan(index, glm::dvec3(0.0))) || glm::any(glm::greaterThan(index, glm::dvec3(moving.dims - 1)))) continue;
        errors.push_back(glm::distance(movingPoint(found, p), mate));
      }
    }
  }
  std::sort(errors.begin(), errors.end());
  Errors result;
  for (const double e : errors) result.mean += e / static_cast<double>(errors.size());
  result.p95 = errors[errors.size() * 95 / 100];
  return result;
}

TEST(RegisterElastic, RecoversAKnownBendAndSaysThatTheVolumesAgree) {
  const Grid grid = uprightGrid({48, 48, 48}, 1.0);
  const Pair pair = warpedPair(grid, 4.0, 6.0);
  int levels = 0;
  const auto found = registerElastic({&pair.fixed, {}}, {&pair.moving, {}}, {}, {}, noProgress(), [&](const Level&) { ++levels; });
  ASSERT_TRUE(found) << found.error();
  const Errors errors = errorsOf(found->fixedToMoving, grid, grid, [](const glm::dvec3& p) { return p + warp(p, 4.0); });
  EXPECT_LT(errors.mean, 0.35);  // 2.6 with nothing done
  EXPECT_LT(errors.p95, 0.9);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_GT(found->after.correlation, found->before.correlation + 0.2);
  EXPECT_EQ(static_cast<std::size_t>(levels), found->levels.size());
  EXPECT_GE(found->jacobian.smallest, 0.15);
  EXPECT_EQ(found->uncertainty.size(), found->fixedToMoving.control.nodes.voxelCount());
  EXPECT_LT(*std::min_element(found->uncertainty.begin(), found->uncertainty.end()), 0.3F);
}

TEST(RegisterElastic, FollowsAWaveThatTurnsWithinTheVolume) {
  const Grid grid = uprightGrid({64, 64, 64}, 1.0);
  const Tissue tissue(3);
  const auto truth = [](const glm::dvec3& p) {
    return p + 2.7 * glm::dvec3(std::sin(kTurn * p.y / 45.0), std::cos(kTurn * (p.z + 10.0) / 45.0), std::sin(kTurn * (p.x + p.z) / 45.0));
  };
  const Volume fixed = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 8.0, 11);
  const Volume moving = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(p); }, 8.0, 12);
  const auto found = registerElastic({&fixed, {}}, {&moving, {}}, {}, {}, noProgress());
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(found->verdict, Verdict::aligned);
  EXPECT_LT(errorsOf(found->fixedToMoving, grid, grid, truth).mean, 0.6);  // 3.3 with nothing done
}

TEST(RegisterElastic, ReachesMotionLargerThanItsStructuresByTheWideSearch) {
  const Grid grid = uprightGrid({44, 44, 44}, 1.25);
  const Tissue tissue(8, 3.0);
  const glm::dvec3 shift(15.0, -6.0, 4.0);
  const auto truth = [&](const glm::dvec3& p) { return p + shift + warp(p, 2.0); };
  const Volume fixed = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 8.0, 1);
  const Volume moving = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(p); }, 8.0, 2);
  ElasticOptions options;
  options.largestMotion_mm = 18.0;
  const auto wide = registerElastic({&fixed, {}}, {&moving, {}}, {}, options, noProgress());
  ASSERT_TRUE(wide) << wide.error();
  EXPECT_LT(errorsOf(wide->fixedToMoving, grid, grid, truth).mean, 0.3);
  options.largestMotion_mm = 0.0;
  const auto local = registerElastic({&fixed, {}}, {&moving, {}}, {}, options, noProgress());
  ASSERT_TRUE(local) << local.error();
  EXPECT_GT(errorsOf(local->fixedToMoving, grid, grid, truth).mean, 1.0);
}

TEST(RegisterElastic, FollowsARigidStartBetweenObliqueAndLeftHandedGrids) {
  Grid fixedGrid = test::obliqueGrid({44, 38, 52}, 1.0);
  fixedGrid.origin_mm = {5.0, -3.0, 60.0};
  const Grid movingGrid = uprightGrid({64, 70, 60}, 1.0);
  const Tissue tissue(5);
  Transform<frame::Moving, frame::Fixed> start;
  const double angle = 0.4;
  start.matrix[0] = glm::dvec4(std::cos(angle), 0.0, -std::sin(angle), 0.0);
  start.matrix[2] = glm::dvec4(std::sin(angle), 0.0, std::cos(angle), 0.0);
  // The middle of the fixed volume goes to that of the moving one.
  const glm::dvec3 middle = (fixedGrid.voxelToWorld() * Point<frame::Voxel>{0.5 * glm::dvec3(fixedGrid.dims)}).at;
  start.matrix[3] = glm::dvec4(glm::dvec3(32.0, 35.0, 30.0) - glm::dmat3(start.matrix) * middle, 1.0);
  const auto truth = [&](const glm::dvec3& p) { return carried(start, p + warp(p, 3.0)); };
  const Volume fixed = imaged(
      fixedGrid, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 8.0, 1);
  const Volume moving = imaged(
      movingGrid, [&](const glm::dvec3& p) { return tissue.at(p); }, 8.0, 2);
  const auto found = registerElastic({&fixed, {}}, {&moving, {}}, start, {}, noProgress());
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(found->verdict, Verdict::aligned);
  EXPECT_LT(errorsOf(found->fixedToMoving, fixedGrid, movingGrid, truth).mean, 0.4);
  EXPECT_GT(errorsOf({start, {}}, fixedGrid, movingGrid, truth).mean, 1.2);
}

TEST(RegisterElastic, IsBitEqualForOneTwoAndEightThreads) {
  const Grid grid = uprightGrid({40, 36, 44}, 1.0);
  const Pair pair = warpedPair(grid, 3.0, 15.0);
  ElasticOptions options;
  options.threads = 1;
  const auto one = registerElastic({&pair.fixed, {}}, {&pair.moving, {}}, {}, options, noProgress());
  ASSERT_TRUE(one);
  for (options.threads = 2; options.threads <= 8; options.threads *= 4) {
    const auto other = registerElastic({&pair.fixed, {}}, {&pair.moving, {}}, {}, options, noProgress());
    ASSERT_TRUE(other);
    EXPECT_EQ(other->fixedToMoving.control, one->fixedToMoving.control);
    EXPECT_EQ(other->uncertainty, one->uncertainty);
    EXPECT_EQ(other->after, one->after);
  }
}

TEST(RegisterElastic, IsStifferTheNoisierTheImages) {
  const Grid grid = uprightGrid({40, 40, 40}, 1.0);
  double before = 0.0;
  for (const double noise : {4.0, 40.0}) {
    const Pair pair = warpedPair(grid, 2.0, noise);
    const auto found = registerElastic({&pair.fixed, {}}, {&pair.moving, {}}, {}, {}, noProgress());
    ASSERT_TRUE(found);
    // Noise lets the images decide less: every node is more of a guess.
    double uncertain = 0.0;
    for (const float u : found->uncertainty) uncertain += static_cast<double>(u);
    EXPECT_GT(uncertain, before);
    before = uncertain;
    const Errors errors = errorsOf(found->fixedToMoving, grid, grid, [](const glm::dvec3& p) { return p + warp(p, 2.0); });
    EXPECT_LT(errors.mean, noise > 10.0 ? 0.9 : 0.3);
  }
}

TEST(RegisterElastic, FillsAHoleFromItsSurroundingsAndMarksIt) {
  const Grid grid = uprightGrid({64, 64, 64}, 1.0);
  Pair pair = warpedPair(grid, 3.0, 8.0);
  std::vector<float> confidence(grid.voxelCount(), 1.0F);
  const glm::dvec3 middle(32.0);
  std::mt19937 random(1);
  for (int k = 0; k < 64; ++k) {
    for (int j = 0; j < 64; ++j) {
      for (int i = 0; i < 64; ++i) {
        if (glm::distance(glm::dvec3(i, j, k), middle) > 20.0) continue;
        confidence[grid.indexOf(i, j, k)] = 0.0F;
        pair.fixed.echo[grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(random() & 255U);
      }
    }
  }
  const auto found = registerElastic({&pair.fixed, confidence}, {&pair.moving, {}}, {}, {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_LT(glm::distance(movingPoint(found->fixedToMoving, middle), middle + warp(middle, 3.0)), 0.8);
  const Grid& nodes = found->fixedToMoving.control.nodes;
  const glm::ivec3 centre(glm::round((nodes.worldToVoxel() * Point<frame::World>{middle}).at));
  EXPECT_GT(found->uncertainty[nodes.indexOf(centre.x, centre.y, centre.z)], 0.5F);
  EXPECT_LT(found->uncertainty[nodes.indexOf(centre.x, 1, 1)], 0.5F);
}

TEST(RegisterElastic, FollowsTissueAndNotTheShadowsThatTurnWithTheProbe) {
  // Soft tissue at rest and warped, each view with shadows along its own beams: 1.8 mm off at rest and 1.4 mm warped when they are left in.
  const Grid grid = uprightGrid({64, 64, 64}, 1.2);
  const glm::dvec3 beamFixed(0.05, 1.0, -0.1), beamMoving(0.0, 1.0, 0.25);
  struct Case {
    double structure_mm, amplitude_mm, mean_mm, p95_mm;
  };
  for (const auto& [structure_mm, amplitude_mm, mean_mm, p95_mm] : {Case{9.0, 0.0, 0.4, 0.7}, Case{5.0, 4.0, 1.0, 2.0}}) {
    const Tissue tissue(8, structure_mm, 60.0);
    const auto truth = [amplitude = amplitude_mm](const glm::dvec3& p) { return p + warp(p, amplitude); };
    const Volume fixed = shadowed(imaged(
                                      grid, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 10.0, 1),
                                  beamFixed, 0.5);
    const Volume moving = shadowed(imaged(
                                       grid, [&](const glm::dvec3& p) { return tissue.at(p); }, 10.0, 2),
                                   beamMoving, 0.5);
    for (const bool known : {false, true}) {
      Input f{&fixed}, m{&moving};
      if (known) f.beams = Beams{beamFixed}, m.beams = Beams{beamMoving};
      const auto found = registerElastic(f, m, {}, {.threads = 1}, noProgress());
      ASSERT_TRUE(found) << (found ? "" : found.error().sentence());
      const Errors errors = errorsOf(found->fixedToMoving, grid, grid, truth);
      EXPECT_LT(errors.mean, mean_mm) << known << ' ' << amplitude_mm;
      EXPECT_LT(errors.p95, p95_mm) << known << ' ' << amplitude_mm;
      EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
    }
  }
}

TEST(RegisterElastic, KeepsTheStartForUnrelatedTissueAndSaysNotAligned) {
  const Grid grid = uprightGrid({56, 56, 56}, 1.0);
  const Tissue one(3), other(4);
  const Volume fixed = imaged(
      grid, [&](const glm::dvec3& p) { return one.at(p); }, 10.0, 1);
  const Volume moving = imaged(
      grid, [&](const glm::dvec3& p) { return other.at(p); }, 10.0, 2);
  const auto found = registerElastic({&fixed, {}}, {&moving, {}}, {}, {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_NE(found->verdict, Verdict::aligned) << found->reason << " chance " << found->before.chance << " then " << found->after.chance;
  EXPECT_EQ(found->largestMotion_mm, 0.0);
}

TEST(RegisterElastic, StopsInTimeAndReturnsWhatItHas) {
  const Grid grid = uprightGrid({64, 64, 64}, 0.75);
  const Pair pair = warpedPair(grid, 3.0, 10.0);
  ElasticOptions options;
  options.maxTime_s = 1e-6;
  const auto found = registerElastic({&pair.fixed, {}}, {&pair.moving, {}}, {}, options, noProgress());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->stop, StopReason::timeLimit);
}

TEST(RegisterElastic, IsCancelledAtItsNextQuestionWhereverItIs) {
  const Grid grid = uprightGrid({80, 80, 80}, 0.6);
  const Pair pair = warpedPair(grid, 3.0, 10.0);
  for (const int question : {1, 40, 200, 1000, 2500}) {
    auto progress = test::CountedStop::atQuestion(question);
    ElasticOptions options;
    options.threads = 2;
    const auto found = registerElastic({&pair.fixed, {}}, {&pair.moving, {}}, {}, options, progress);
    ASSERT_FALSE(found) << question;
    EXPECT_EQ(found.error().code, ErrorCode::cancelled);
    EXPECT_LE(progress.questionsAfter(), test::kMostQuestionsAfter) << question;
    EXPECT_LE(progress.reportsAfter(), test::kMostReportsAfter) << question;
  }
}

TEST(RegisterElastic, ReportsProgressThatNeverMovesBackwardsAndEndsAtTheWhole) {
  const Grid grid = uprightGrid({40, 40, 40}, 1.0);
  const Pair pair = warpedPair(grid, 3.0, 8.0);
  for (const int threads : {1, 2}) {
    test::RisingProgress progress;
    ElasticOptions options;
    options.threads = threads;
    const auto found = registerElastic({&pair.fixed, {}}, {&pair.moving, {}}, {}, options, progress);
    ASSERT_TRUE(found);
    EXPECT_EQ(progress.backwards(), 0);
    EXPECT_GT(progress.reports(), 10);
    EXPECT_EQ(progress.last(), 1.0);
  }
}

TEST(RegisterElastic, NamesWhatIsWrongWithItsArguments) {
  const Grid grid = uprightGrid({16, 16, 16}, 1.0);
  const Pair pair = warpedPair(grid, 1.0, 0.0);
  const auto errorOf = [&](const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start,
                           const ElasticOptions& options) {
    const auto found = registerElastic(fixed, moving, start, options, noProgress());
    return found ? Error{} : found.error();
  };
  const Input fixed{&pair.fixed, {}}, moving{&pair.moving, {}};
  const std::vector<float> few(7, 1.0F);
  EXPECT_EQ(errorOf({&pair.fixed, few}, moving, {}, {}).code, ErrorCode::badField);
  std::vector<float> wrong(grid.voxelCount(), 1.0F);
  wrong[9] = std::nanf("");
  EXPECT_EQ(errorOf(fixed, {&pair.moving, wrong}, {}, {}).code, ErrorCode::badField);
  EXPECT_EQ(errorOf(fixed, moving, {glm::dmat4(2.0)}, {}).code, ErrorCode::notRigid);
  Volume uncovered = pair.fixed;
  uncovered.coverage.assign(uncovered.echo.size(), 0);
  EXPECT_EQ(errorOf({&uncovered, {}}, moving, {}, {}).code, ErrorCode::emptyVolume);
  Volume none;
  EXPECT_EQ(errorOf({&none, {}}, moving, {}, {}).code, ErrorCode::emptyVolume);
  ElasticOptions options;
  options.leastJacobian = 0.0;
  EXPECT_EQ(errorOf(fixed, moving, {}, options).code, ErrorCode::badField);
  EXPECT_NE(errorOf(fixed, moving, {}, options).sentence().find("leastJacobian"), std::string::npos);
  options = {};
  options.stiffness = -1.0;
  EXPECT_EQ(errorOf(fixed, moving, {}, options).code, ErrorCode::badField);
}

TEST(ForecastElastic, GrowsWithTheVolumeAndShrinksWithTheEffort) {
  const Grid small = uprightGrid({64, 64, 64}, 0.5), large = uprightGrid({128, 128, 128}, 0.5);
  ElasticOptions fast;
  fast.effort = ElasticEffort::fast;
  EXPECT_GT(forecastElastic_bytes(large, large, {}), 4 * forecastElastic_bytes(small, small, {}));
  EXPECT_LT(forecastElastic_bytes(large, large, fast), forecastElastic_bytes(large, large, {}));
  EXPECT_LT(forecastElastic_bytes(large, large, {}), std::uint64_t{150} << 20);
}

}  // namespace
}  // namespace ew::elastic_test
