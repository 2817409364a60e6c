#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ew/core/frames.h"
#include "ew/registration/rigid.h"
#include "registration/ellipsoids.h"

namespace ew::registration {
namespace {

using test::apart_mm;
using test::centred;
using test::pose;
using test::seen;
using test::Tissue;
using test::tissue;

bool mentions(const std::string& reason, const std::string& words) { return reason.find(words) != std::string::npos; }

const Grid kGrid = centred(glm::ivec3(40), 1.5);
const glm::dmat4 kTruth = pose({8.0, -6.0, 4.0}, {8.0, 6.0, -5.0});
const glm::dmat4 kStart = kTruth * pose({2.0, -2.0, 1.5}, {2.0, 3.0, -2.0});

Volume fixedView() { return seen(tissue(21, 110.0), kGrid, glm::dmat4(1.0), 1); }
Volume movingView() { return seen(tissue(21, 110.0), kGrid, glm::inverse(kTruth), 2); }

void expectCannotTell(const Volume& fixed, const Volume& moving, const std::string& words) {
  const auto matched = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(matched);
  EXPECT_EQ(matched->best.verdict, Verdict::cannotTell) << matched->best.reason;
  EXPECT_TRUE(mentions(matched->best.reason, words)) << matched->best.reason;
  const auto refined = refineRigid({&fixed}, {&moving}, glm::dmat4(1.0), {}, noProgress());
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->verdict, Verdict::cannotTell) << refined->reason;
  EXPECT_TRUE(mentions(refined->reason, words)) << refined->reason;
  EXPECT_EQ(refined->fixedToMoving, glm::dmat4(1.0)) << "the start stays";
}

TEST(RigidHardCases, AConstantImageSaysThatItShowsNoStructure) {
  Volume flat = movingView();
  std::fill(flat.echo.begin(), flat.echo.end(), std::uint8_t{120});
  expectCannotTell(fixedView(), flat, "no structure");
  expectCannotTell(flat, fixedView(), "no structure");
}

TEST(RigidHardCases, ASaturatedImageSaysThatItShowsNoStructure) {
  Volume white = movingView();
  std::fill(white.echo.begin(), white.echo.end(), std::uint8_t{255});
  expectCannotTell(fixedView(), white, "no structure");
}

TEST(RigidHardCases, ABlackImageHoldsNoEcho) {
  Volume black = movingView();
  std::fill(black.echo.begin(), black.echo.end(), std::uint8_t{0});
  expectCannotTell(fixedView(), black, "holds no echo");
}

TEST(RigidHardCases, OneVoxelOfThicknessIsTooThin) {
  const Volume thin = seen(tissue(21, 110.0), centred({40, 40, 1}, 1.5), glm::dmat4(1.0), 2);
  expectCannotTell(fixedView(), thin, "too thin");
  expectCannotTell(thin, fixedView(), "too thin");
}

TEST(RigidHardCases, AreasSaturatedByGainDoNotMoveThePose) {
  const Volume moving = seen(tissue(21, 110.0), kGrid, glm::inverse(kTruth), 2, 18.0, 1.9, 10.0);
  EXPECT_GT(std::count(moving.echo.begin(), moving.echo.end(), 255), static_cast<std::ptrdiff_t>(moving.echo.size() / 10));
  const Volume fixed = fixedView();
  const auto found = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->best.verdict, Verdict::aligned) << found->best.reason;
  EXPECT_LT(apart_mm(found->best.fixedToMoving, kTruth, kGrid), 1.0);
}

TEST(RigidHardCases, PureSpeckleIsNotAligned) {
  const Tissue plain;
  const Volume fixed = seen(plain, kGrid, glm::dmat4(1.0), 1, 25.0);
  const Volume moving = seen(plain, kGrid, glm::dmat4(1.0), 2, 25.0);
  const auto matched = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(matched);
  EXPECT_NE(matched->best.verdict, Verdict::aligned) << matched->best.reason;
  EXPECT_TRUE(mentions(matched->best.reason, "unrelated tissue") || mentions(matched->best.reason, "chance")) << matched->best.reason;
  const auto refined = refineRigid({&fixed}, {&moving}, glm::dmat4(1.0), {}, noProgress());
  ASSERT_TRUE(refined);
  EXPECT_NE(refined->verdict, Verdict::aligned) << refined->reason;
}

TEST(RigidHardCases, RepeatedStructureCannotTellWhichOfItsPlacesItIs) {
  Tissue comb;  // the same ball again every 15 mm in every direction
  for (int z = -5; z <= 5; ++z) {
    for (int y = -5; y <= 5; ++y) {
      for (int x = -5; x <= 5; ++x) comb.blobs.push_back({15.0 * glm::dvec3(x, y, z), glm::dvec3(5.0), 60.0});
    }
  }
  const Volume fixed = seen(comb, kGrid, glm::dmat4(1.0), 1, 10.0);
  const Volume moving = seen(comb, kGrid, pose({4.0, 3.0, -2.0}, {}), 2, 10.0);
  const auto found = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->best.verdict, Verdict::cannotTell) << found->best.reason;
  EXPECT_TRUE(mentions(found->best.reason, "the structure repeats")) << found->best.reason;
  EXPECT_GE(found->hypotheses.size(), 2u);
}

TEST(RigidHardCases, DisjointImagesAreRefusedByMatchingAndByRefinement) {
  const auto all = tissue(31, 300.0, 0.3);
  const Volume fixed = seen(all, kGrid, glm::dmat4(1.0), 1);
  const Volume moving = seen(all, kGrid, pose({75.0, 0.0, 0.0}, {}), 2);  // 60 mm wide: no common tissue
  const auto matched = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(matched);
  EXPECT_NE(matched->best.verdict, Verdict::aligned) << matched->best.reason;
  const auto refined = refineRigid({&fixed}, {&moving}, pose({-75.0, 0.0, 0.0}, {}), {}, noProgress());
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->verdict, Verdict::cannotTell);
  EXPECT_EQ(refined->stop, StopReason::noOverlap);
  EXPECT_TRUE(mentions(refined->reason, "do not overlap")) << refined->reason;
}

TEST(RigidHardCases, FivePercentOverlapIsAlignedRightlyOrNotClaimed) {
  // Below the least overlap a search counts (8 %): found when asked for, never claimed wrongly.
  const auto all = tissue(31, 200.0, 0.4);
  const Grid grid = centred(glm::ivec3(56), 1.5);
  const Volume fixed = seen(all, grid, glm::dmat4(1.0), 1);
  const glm::dmat4 far = pose({-66.0, -63.0, 0.0}, {});  // 18 x 21 mm of 84 x 84: 5 %
  const Volume moving = seen(all, grid, glm::inverse(far), 2);
  for (const double least : {0.08, 0.03}) {
    PartialOptions options;
    options.leastOverlap = least;
    options.maxTurn_deg = 10.0;
    const auto found = matchPartial({&fixed}, {&moving}, options, noProgress());
    ASSERT_TRUE(found);
    if (found->best.verdict == Verdict::aligned) {
      EXPECT_LT(apart_mm(found->best.fixedToMoving, far, grid), 3.0) << found->best.reason;
    }
  }
}

TEST(RigidHardCases, ShadowOverHalfOfOneImageIsNeverClaimedWronglyAndConfidenceOvercomesIt) {
  const Grid grid = centred(glm::ivec3(52), 1.5);
  const auto all = tissue(21, 140.0);
  const Volume fixed = seen(all, grid, glm::dmat4(1.0), 1);
  Volume moving = seen(all, grid, glm::inverse(kTruth), 2);
  std::vector<float> confidence(moving.echo.size(), 1.0f);
  for (std::size_t q = 0; q < moving.echo.size(); ++q) {
    if (q % 52 >= 26) continue;
    moving.echo[q] = static_cast<std::uint8_t>(1 + q * 2654435761u % 7u);  // noise below a bright interface
    confidence[q] = 0.0f;
  }
  const auto unsaid = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(unsaid);
  if (unsaid->best.verdict == Verdict::aligned) {
    EXPECT_LT(apart_mm(unsaid->best.fixedToMoving, kTruth, grid), 1.5);
  }
  const auto said = matchPartial({&fixed}, {&moving, confidence}, {}, noProgress());
  ASSERT_TRUE(said);
  EXPECT_EQ(said->best.verdict, Verdict::aligned) << said->best.reason;
  EXPECT_LT(apart_mm(said->best.fixedToMoving, kTruth, grid), 1.0);
}

TEST(RigidHardCases, GainInvertedBetweenImagesIsNotClaimedToAgree) {
  const Volume fixed = fixedView();
  Volume moving = movingView();
  for (auto& grey : moving.echo) grey = static_cast<std::uint8_t>(256 - std::max<int>(grey, 1));
  const auto matched = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(matched);
  EXPECT_NE(matched->best.verdict, Verdict::aligned) << matched->best.reason;
  const auto refined = refineRigid({&fixed}, {&moving}, kTruth, {}, noProgress());
  ASSERT_TRUE(refined);
  EXPECT_NE(refined->verdict, Verdict::aligned) << refined->reason;
}

TEST(RigidHardCases, HalfATurnIsFoundWhenAskedForAndNotClaimedWhenNot) {
  const auto all = tissue(41, 110.0);
  const Grid grid = centred(glm::ivec3(24), 2.5);
  const glm::dmat4 truth = pose({5.0, -3.0, 4.0}, {0.0, 180.0, 0.0});
  const Volume fixed = seen(all, grid, glm::dmat4(1.0), 1, 10.0);
  const Volume moving = seen(all, grid, glm::inverse(truth), 2, 10.0);
  PartialOptions options;
  const auto narrow = matchPartial({&fixed}, {&moving}, options, noProgress());
  ASSERT_TRUE(narrow);
  EXPECT_NE(narrow->best.verdict, Verdict::aligned) << narrow->best.reason;
  options.maxTurn_deg = 180.0;
  options.stepTurn_deg = 20.0;
  options.cell_mm = 5.0;
  options.hypotheses = 16;
  const auto wide = matchPartial({&fixed}, {&moving}, options, noProgress());
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->best.verdict, Verdict::aligned) << wide->best.reason;
  EXPECT_LT(apart_mm(wide->best.fixedToMoving, truth, grid), 1.5);
  // Refinement alone, started half a turn off, does not claim to have found it.
  const auto refined = refineRigid({&fixed}, {&moving}, pose({5.0, -3.0, 4.0}, {}), {}, noProgress());
  ASSERT_TRUE(refined);
  EXPECT_NE(refined->verdict, Verdict::aligned) << refined->reason;
}

TEST(RigidHardCases, AnOriginAMillionMillimetresAwayCostsNoAccuracy) {
  const Volume fixed = fixedView();
  Volume moving = movingView();
  const glm::dvec3 far(1e6, -1e6, 1e6);
  moving.grid.origin_mm += far;
  glm::dmat4 shift(1.0);
  shift[3] = glm::dvec4(far, 1.0);
  const auto found = refineRigid({&fixed}, {&moving}, shift * kStart, {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(apart_mm(found->fixedToMoving, shift * kTruth, kGrid), 0.5);
}

TEST(RigidHardCases, NoiseAtTheEdgeOfASectorAloneNeverAligns) {
  // The same sector shape, unrelated tissue: black outside must not lock the edges onto each other.
  const auto cut = [](Volume volume) {
    for (int k = 0; k < volume.grid.dims.z; ++k) {
      for (int j = 0; j < volume.grid.dims.y; ++j) {
        for (int i = 0; i < volume.grid.dims.x; ++i) {
          if (std::abs(i - 19.5) > 4.0 + 0.45 * j) volume.echo[volume.grid.indexOf(i, j, k)] = 0;
        }
      }
    }
    return volume;
  };
  const Volume fixed = cut(fixedView());
  const Volume moving = cut(seen(tissue(77, 110.0), kGrid, glm::dmat4(1.0), 2));
  const auto found = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(found);
  EXPECT_NE(found->best.verdict, Verdict::aligned) << found->best.reason;
}

TEST(RigidHardCases, ShadowsAloneThatTurnWithTheProbeNeverAlign) {
  // Unrelated tissue below the same shadows: they agree wonderfully, and say nothing.
  const auto shadowed = [](Volume volume) {
    for (std::size_t q = 0; q < volume.echo.size(); ++q) {
      const double x = static_cast<double>(q % 40) * 1.5;
      const double y = static_cast<double>(q / 40 % 40) * 1.5;
      const double dark = std::sin(0.31 * x + 0.9 * std::sin(0.17 * y)) * std::cos(0.27 * y + 0.8 * std::sin(0.13 * x));
      volume.echo[q] = static_cast<std::uint8_t>(std::clamp(volume.echo[q] * (1.0 + 0.8 * dark), 1.0, 255.0));
    }
    return volume;
  };
  const Volume fixed = shadowed(fixedView());
  const Volume moving = shadowed(seen(tissue(77, 110.0), kGrid, glm::dmat4(1.0), 2));
  const auto matched = matchPartial({&fixed}, {&moving}, {}, noProgress());
  ASSERT_TRUE(matched);
  EXPECT_EQ(matched->best.verdict, Verdict::cannotTell) << matched->best.reason;
  const auto refined = refineRigid({&fixed}, {&moving}, glm::dmat4(1.0), {}, noProgress());
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->verdict, Verdict::cannotTell) << refined->reason;
  EXPECT_TRUE(mentions(refined->reason, "shadows")) << refined->reason;
}

}  // namespace
}  // namespace ew::registration
