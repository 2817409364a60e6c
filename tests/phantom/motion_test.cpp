#include "ew/phantom/motion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>
#include <vector>

#include "recipes.h"

namespace ew::motion_test {
namespace {

const Patient& beating() {
  static const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "spine", "tissue": "dark", "shape": {"capsule": {"from_mm": [0, 30, -60], "to_mm": [0, 30, 60], "from_radius_mm": 8, "to_radius_mm": 8}}},
         {"name": "vessel", "tissue": "dark", "shape": {"tube": {"points": [[4, 2, -50, 9], [0, 0, 0, 10], [3, -3, 50, 9]]}}})",
      R"("motion": {"breathing": {"displacement_mm": [0, -3, -14], "held_depth_mm": 5, "free_depth_mm": 30, "held_by": ["spine"]},
                    "pulse": {"beats_per_minute": 75, "variation": 0.1, "vessels": [{"of": "vessel", "diameter_growth_mm": 2, "reach_mm": 15}]}},)"));
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return **patient;
}

constexpr double kInward_mm = 5.0;
constexpr glm::dvec3 kChamber_mm(4.0, -6.0, 3.0);  ///< its middle

/// Two chambers side by side, the first in a frame of its own, and a vessel; "narrowed" is the first chamber as it should be at the height
/// of the beat.
std::shared_ptr<const Patient> heartWith(const std::string& chambers, const std::string& more = "") {
  auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "chamber", "tissue": "dark", "shape": {"frame": "askew", "ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [20, 14, 12]}}},
         {"name": "narrowed", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [4, -6, 3], "radii_mm": [15, 9, 7], "turned_deg": [20, 10, -30]}}},
         {"name": "other", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [-12, -20, -6], "radii_mm": [18, 9, 8]}}},
         {"name": "vessel", "tissue": "dark", "shape": {"tube": {"points": [[4, 26, -50, 9], [0, 24, 0, 10], [3, 24, 50, 9]]}}})",
      R"("frames": [{"name": "askew", "origin_mm": [4, -6, 3], "turned_deg": [20, 10, -30]}], "motion": {"pulse": {"chambers": [)" +
          chambers + "]" + more + "}},"));
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return *patient;
}

const Patient& oneChamber() {
  static const auto patient = heartWith(R"({"of": "chamber", "inward_mm": 5, "reach_mm": 20})");
  return *patient;
}

const Patient& wholeHeart() {
  static const auto patient = heartWith(R"({"of": "chamber", "inward_mm": 5, "reach_mm": 25}, {"of": "other", "inward_mm": 3})",
                                        R"(, "vessels": [{"of": "vessel", "diameter_growth_mm": 2, "reach_mm": 15}])");
  return *patient;
}

/// Directions all around.
std::vector<glm::dvec3> allAround() {
  std::vector<glm::dvec3> directions;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        if (x != 0 || y != 0 || z != 0) directions.push_back(glm::normalize(glm::dvec3(x, y, z)));
  return directions;
}

/// How far the chamber's wall lies from its middle.
double wallAlong_mm(const glm::dvec3& direction) {
  double low = 0.0, high = 40.0;
  while (high - low > 1e-10) {
    const double middle = 0.5 * (low + high);
    (signedDistance_mm(oneChamber(), "chamber", kChamber_mm + middle * direction).value() < 0.0 ? low : high) = middle;
  }
  return high;
}

glm::dvec3 placeIn(const Bounds& box) {
  glm::dvec3 place;
  for (int axis = 0; axis < 3; ++axis) {
    const double t = static_cast<double>(*rc::gen::inRange(0, 100001)) / 1e5;
    place[axis] = box.lowest_mm[axis] + t * (box.highest_mm[axis] - box.lowest_mm[axis]);
  }
  return place;
}

BodyState anyState() {
  return {static_cast<double>(*rc::gen::inRange(0, 101)) / 100.0, static_cast<double>(*rc::gen::inRange(0, 101)) / 100.0};
}

void expectInverse(const Deformation& motion, const glm::dvec3& p) {
  RC_ASSERT(glm::distance(motion.rest(motion.moved(p)), p) < 0.01);
  RC_ASSERT(glm::distance(motion.moved(motion.rest(p)), p) < 0.01);
  RC_ASSERT(glm::distance(motion.moved(p), p) <= motion.reach_mm() + 1e-9);
}

double jacobian(const Deformation& motion, const glm::dvec3& p) {
  constexpr double kStep_mm = 0.05;
  glm::dmat3 columns;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = kStep_mm;
    columns[axis] = (motion.moved(p + step) - motion.moved(p - step)) / (2.0 * kStep_mm);
  }
  return glm::determinant(columns);
}

/// Of the middle of a grid's cell, where a field knows least: the mean of its eight nodes.
glm::dvec3 betweenNodes(const TissueMotion::Mode& mode, const glm::ivec3& lowest) {
  glm::dvec3 sum(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 node = lowest + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    sum += glm::dvec3(mode.shift_mm[mode.grid.indexOf(node.x, node.y, node.z)]);
  }
  return 0.125 * sum;
}

TEST(TissueMotion, IsTheBodysMotionOnGrids) {
  const auto made = tissueMotionOf(beating(), 2, noProgress());
  ASSERT_TRUE(made && *made);
  const TissueMotion& motion = **made;
  ASSERT_EQ(motion.modes.size(), 2U);
  EXPECT_EQ(motion.rhythms, rhythmsOf(beating()));
  for (double time_s = 0.0; time_s < 6.0; time_s += 0.37) EXPECT_EQ(bodyAt(motion.rhythms, time_s), stateAt(beating(), time_s));
  for (const TissueMotion::Mode& mode : motion.modes) {
    const bool isBreath = mode.kind == TissueMotion::Kind::breath;
    const auto body = bodyMotion(beating(), isBreath ? BodyState{.breath = 1.0} : BodyState{.pulse = 1.0});
    const auto half = bodyMotion(beating(), isBreath ? BodyState{.breath = 0.5} : BodyState{.pulse = 0.5});
    double largest_mm = 0.0, furthest_mm = 0.0, bent_mm = 0.0;
    // Halfway between nodes, where a field knows least.
    for (int k = 0; k + 1 < mode.grid.dims.z; ++k)
      for (int j = 0; j + 1 < mode.grid.dims.y; ++j)
        for (int i = 0; i + 1 < mode.grid.dims.x; ++i) {
          const glm::dvec3 between = betweenNodes(mode, {i, j, k});
          const glm::dvec3 p = carried(mode.grid.voxelToWorld(), glm::dvec3(i, j, k) + 0.5), shift = body->moved(p) - p;
          largest_mm = std::max(largest_mm, glm::distance(between, shift));
          furthest_mm = std::max(furthest_mm, glm::length(shift));
          bent_mm = std::max(bent_mm, glm::distance(0.5 * shift, half->moved(p) - p));
        }
    EXPECT_GT(furthest_mm, isBreath ? 10.0 : 0.9);
    EXPECT_LT(largest_mm, isBreath ? 0.01 : 0.14) << isBreath;  // the share is kept on the same nodes; the wall is a kink
    EXPECT_LT(bent_mm, 1e-9) << "half the amplitude, half the way";
  }
}

TEST(TissueMotion, OfABodyThatDoesNotMoveIsNone) {
  const auto still = testing::patientOf(testing::patientRecipe(
      R"({"name": "ball", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [9, 9, 9]}}})", ""));
  ASSERT_TRUE(still) << still.error();
  const auto made = tissueMotionOf(**still, 1, noProgress());
  ASSERT_TRUE(made);
  EXPECT_EQ(*made, nullptr);
}

TEST(TissueMotion, OfTheGutSwaysWithinItsOrgansAlone) {
  const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "gut", "tissue": "dark", "shape": {"tube": {"points": [[-40, 0, 0, 14], [40, 0, 0, 14]]}}})",
      R"("motion": {"bowel": {"organs": ["gut"], "sway_mm": 2, "wavelength_mm": 60, "fade_mm": 6, "period_s": 8}},)"));
  ASSERT_TRUE(patient) << patient.error();
  EXPECT_TRUE(moves(**patient));
  const auto made = tissueMotionOf(**patient, 1, noProgress());
  ASSERT_TRUE(made && *made);
  ASSERT_EQ((*made)->modes.size(), 2U);
  double most_mm = 0.0;
  for (const TissueMotion::Mode& mode : (*made)->modes)
    for (int k = 0; k < mode.grid.dims.z; ++k)
      for (int j = 0; j < mode.grid.dims.y; ++j)
        for (int i = 0; i < mode.grid.dims.x; ++i) {
          const glm::dvec3 p = carried(mode.grid.voxelToWorld(), glm::dvec3(i, j, k));
          const glm::vec3& shift = mode.shift_mm[mode.grid.indexOf(i, j, k)];
          most_mm = std::max(most_mm, static_cast<double>(std::abs(shift.y)));
          if (signedDistance_mm(**patient, "gut", p).value() >= 0.0) {
            EXPECT_EQ(shift, glm::vec3(0.0F));
          }
        }
  EXPECT_NEAR(most_mm, 1.0, 0.1);
  EXPECT_NEAR(stateAt(**patient, 2.0).bowel, 0.25, 1e-12);
}

TEST(TissueMotion, OfTheGutThatWouldFoldIsRefused) {
  const auto patient = testing::patientOf(
      testing::patientRecipe(R"({"name": "gut", "tissue": "dark", "shape": {"tube": {"points": [[-40, 0, 0, 14], [40, 0, 0, 14]]}}})",
                             R"("motion": {"bowel": {"organs": ["gut"], "sway_mm": 8, "fade_mm": 6}},)"));
  ASSERT_FALSE(patient);
  EXPECT_EQ(patient.error().code, ErrorCode::badField);
  EXPECT_NE(patient.error().message.english().find("sway_mm"), std::string::npos) << patient.error();
}

RC_GTEST_PROP(BodyMotion, HasAnInverseWithinAHundredthOfAMillimetre, ()) {
  expectInverse(*bodyMotion(beating(), anyState()), placeIn({glm::dvec3(-70), glm::dvec3(70)}));
}

RC_GTEST_PROP(BodyMotion, NeverFoldsTissue, ()) {
  RC_ASSERT(jacobian(*bodyMotion(beating(), anyState()), placeIn({glm::dvec3(-70), glm::dvec3(70)})) > 0.1);
}

RC_GTEST_PROP(ShippedMotion, HasAnInverseAndNeverFolds, ()) {
  const auto motion = bodyMotion(testing::shipped(), anyState());
  const glm::dvec3 p = placeIn(boxOf(testing::shipped()));
  expectInverse(*motion, p);
  RC_ASSERT(jacobian(*motion, p) > 0.1);
}

RC_GTEST_PROP(BodyMotion, MovesNeighboursAlike, ()) {
  const auto motion = bodyMotion(beating(), anyState());
  const glm::dvec3 p = placeIn({glm::dvec3(-70), glm::dvec3(70)});
  const glm::dvec3 step = 0.01 * glm::normalize(placeIn({glm::dvec3(-1), glm::dvec3(1)}) + glm::dvec3(0, 0, 1e-6));
  RC_ASSERT(glm::distance(motion->moved(p + step), motion->moved(p)) < 0.05);
}

TEST(BodyMotion, IsNoneAtRest) {
  const auto motion = bodyMotion(beating(), {});
  EXPECT_EQ(motion->reach_mm(), 0.0);
  for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), glm::dvec3(9, -20, 13)}) {
    EXPECT_EQ(motion->moved(p), p);
    EXPECT_EQ(motion->rest(p), p);
  }
}

TEST(BodyMotion, WidensAVesselByExactlyWhatTheRecipeSays) {
  for (const double pulse : {0.5, 1.0}) {
    const auto motion = bodyMotion(beating(), {0.0, pulse});
    const double left = motion->moved({10, 0, 0}).x, right = motion->moved({-10, 0, 0}).x;
    EXPECT_NEAR(left - right, 20.0 + 2.0 * pulse, 1e-9);
    EXPECT_EQ(motion->moved({0, 0, 0}), glm::dvec3(0));
    const glm::dvec3 far(25.5, 0, 0);
    EXPECT_EQ(motion->moved(far), far) << "beyond its reach nothing is pushed";
    EXPECT_GT(motion->moved({15, 0, 0}).x, 15.0);
    EXPECT_LT(motion->moved({15, 0, 0}).x - 15.0, left - 10.0) << "less with distance";
  }
}

TEST(BodyMotion, BringsEveryPlaceOfAChambersWallInwardsByExactlyWhatTheRecipeSays) {
  for (const double pulse : {0.25, 1.0}) {
    const auto motion = bodyMotion(oneChamber(), {0.0, pulse});
    EXPECT_EQ(motion->reach_mm(), kInward_mm * pulse);
    EXPECT_LT(glm::distance(motion->moved(kChamber_mm), kChamber_mm), 1e-12);
    for (const glm::dvec3& direction : allAround()) {
      const glm::dvec3 wall = kChamber_mm + wallAlong_mm(direction) * direction, moved = motion->moved(wall);
      EXPECT_NEAR(glm::distance(moved, wall), kInward_mm * pulse, 1e-6);
      EXPECT_GT(glm::dot(wall - moved, direction), 0.7 * kInward_mm * pulse) << "towards the middle";
      if (pulse == 1.0) {
        EXPECT_NEAR(signedDistance_mm(oneChamber(), "narrowed", moved).value(), 0.0, 1e-6);
      }
    }
  }
}

TEST(BodyMotion, DrawsWhatLiesAroundAChamberAlongLessWithDistance) {
  const auto motion = bodyMotion(oneChamber(), {0.0, 1.0});
  for (const glm::dvec3& direction : allAround()) {
    const double wall_mm = wallAlong_mm(direction);
    double before_mm = 0.0;
    for (double range_mm = 0.0; range_mm < wall_mm + 40.0; range_mm += 0.25) {
      const glm::dvec3 p = kChamber_mm + range_mm * direction;
      const double drawn_mm = glm::distance(motion->moved(p), p);
      EXPECT_LT(std::abs(drawn_mm - before_mm), 0.25) << "smoothly, at " << range_mm;
      if (range_mm < wall_mm) {
        EXPECT_GE(drawn_mm, before_mm - 1e-9) << "within, more towards the wall, at " << range_mm;
      } else if (before_mm < kInward_mm - 0.25) {
        EXPECT_LE(drawn_mm, before_mm + 1e-9) << "around, less with distance, at " << range_mm;
      }
      before_mm = drawn_mm;
    }
    EXPECT_EQ(before_mm, 0.0) << "far away nothing moves";
    // A wall of 8 mm thickens as the chamber empties.
    const glm::dvec3 outside = kChamber_mm + (wall_mm + 8.0) * direction;
    EXPECT_LT(glm::distance(motion->moved(outside), outside), 0.6 * kInward_mm);
  }
}

RC_GTEST_PROP(BeatingHeart, HasAnInverseAndNeverFolds, ()) {
  const auto motion = bodyMotion(wholeHeart(), anyState());
  const glm::dvec3 p = placeIn({glm::dvec3(-60), glm::dvec3(60)});
  expectInverse(*motion, p);
  RC_ASSERT(jacobian(*motion, p) > 0.1);
}

TEST(BeatingHeart, IsAFieldOnAGridForEachChamber) {
  const auto made = tissueMotionOf(oneChamber(), 1, noProgress());
  ASSERT_TRUE(made && *made);
  ASSERT_EQ((*made)->modes.size(), 1U);
  const TissueMotion::Mode& mode = (*made)->modes.front();
  EXPECT_EQ(mode.kind, TissueMotion::Kind::pulse);
  const auto body = bodyMotion(oneChamber(), {.pulse = 1.0}), half = bodyMotion(oneChamber(), {.pulse = 0.5});
  double largest_mm = 0.0, furthest_mm = 0.0, bent_mm = 0.0, edge_mm = 0.0;
  for (int k = 0; k + 1 < mode.grid.dims.z; ++k)
    for (int j = 0; j + 1 < mode.grid.dims.y; ++j)
      for (int i = 0; i + 1 < mode.grid.dims.x; ++i) {
        const glm::dvec3 between = betweenNodes(mode, {i, j, k});
        const glm::dvec3 p = carried(mode.grid.voxelToWorld(), glm::dvec3(i, j, k) + 0.5), shift = body->moved(p) - p;
        largest_mm = std::max(largest_mm, glm::distance(between, shift));
        furthest_mm = std::max(furthest_mm, glm::length(shift));
        bent_mm = std::max(bent_mm, glm::distance(0.5 * shift, half->moved(p) - p));
        if (i == 0 || j == 0 || k == 0)
          edge_mm = std::max(edge_mm, static_cast<double>(glm::length(mode.shift_mm[mode.grid.indexOf(i, j, k)])));
      }
  EXPECT_GT(furthest_mm, 0.9 * kInward_mm);
  EXPECT_LT(largest_mm, 0.07 * kInward_mm);
  EXPECT_LT(bent_mm, 1e-6) << "half the amplitude, half the way";
  EXPECT_LT(edge_mm, 1e-6) << "the grid holds all that moves";
}

TEST(BeatingHeart, ThatCannotBeIsRefusedWithASentence) {
  struct Wrong {
    const char *chamber, *says;
  };
  for (const auto& [chamber, says] :
       {Wrong{R"({"of": "nothing", "inward_mm": 1})", "an ellipsoid"}, Wrong{R"({"of": "pipe", "inward_mm": 1})", "an ellipsoid"},
        Wrong{R"({"of": "egg", "inward_mm": 7})", "folded"}, Wrong{R"({"of": "egg"})", "inward_mm"},
        Wrong{R"({"of": "egg", "inward_mm": 1, "diameter_growth_mm": 1})", "diameter_growth_mm"}, Wrong{"", "chambers"}}) {
    const auto patient = testing::patientOf(testing::patientRecipe(
        R"({"name": "egg", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [20, 9, 8]}}},
           {"name": "pipe", "tissue": "dark", "shape": {"tube": {"points": [[0, 20, -40, 5], [0, 20, 40, 5]]}}})",
        R"("motion": {"pulse": {"chambers": [)" + std::string(chamber) + "]}},"));
    ASSERT_FALSE(patient) << chamber;
    EXPECT_EQ(patient.error().code, ErrorCode::badField) << chamber;
    EXPECT_NE(patient.error().message.english().find(says), std::string::npos) << patient.error();
  }
}

TEST(BodyMotion, HoldsSkinAndSpineWhileOrgansGoDown) {
  const auto motion = bodyMotion(beating(), {1.0, 0.0});
  for (const glm::dvec3& p : {glm::dvec3(0, -58, 0), glm::dvec3(57, 0, 0), glm::dvec3(0, 30, 10)})
    EXPECT_LT(glm::distance(motion->moved(p), p), 0.05) << p.x << " " << p.y;
  EXPECT_NEAR(motion->moved({0, -10, 0}).z, -14.0, 0.5);
}

TEST(ShippedMotion, MovesTheLiverDownAndLeavesRibsAndSpineAlone) {
  const auto motion = bodyMotion(testing::shipped(), {1.0, 1.0});
  EXPECT_TRUE(moves(testing::shipped()));
  EXPECT_NEAR(motion->moved({-60, 0, 0}).z, -15.0, 0.2);
  const glm::dvec3 kidney(-66, 40, -76), body(0, 55, -34);
  EXPECT_LT(motion->moved(kidney).z - kidney.z, -8.0);
  EXPECT_LT(glm::distance(motion->moved(body), body), 0.6) << "the aorta in front of it pushes a little";
}

TEST(Rhythms, RestAtTheBeginningAndGiveTheSameStateAtTheSameTime) {
  EXPECT_EQ(stateAt(beating(), 3.3), stateAt(beating(), 3.3));
  for (double t = -9.0; t < 9.0; t += 0.01) {
    const BodyState state = stateAt(beating(), t), next = stateAt(beating(), t + 0.001);
    EXPECT_TRUE(state.breath >= 0.0 && state.breath <= 1.0 && state.pulse >= 0.0 && state.pulse <= 1.0);
    EXPECT_LT(std::abs(next.breath - state.breath), 0.003) << t;
    EXPECT_LT(std::abs(next.pulse - state.pulse), 0.03) << t;
  }
}

TEST(Rhythms, BreatheEveryFourSecondsWithAPauseOfThreeTenths) {
  constexpr double kQuiet = 0.4;  // of a full breath
  int resting = 0, full = 0;
  for (int n = 0; n < 4000; ++n) {
    const double breath = stateAt(testing::shipped(), 0.004 * n).breath / kQuiet;
    resting += breath < 1e-3;
    full += breath > 0.999;
    EXPECT_NEAR(breath, stateAt(testing::shipped(), 0.004 * n + 4.0).breath / kQuiet, 1e-9);
  }
  EXPECT_NEAR(resting / 4000.0, 0.3 + 0.7 * 0.02, 0.01);
  EXPECT_GT(full, 0);
}

TEST(Electrocardiogram, HasAnRPeakOfOneMillivoltAtEachBeat) {
  int peaks = 0;
  double before = ecgAt_mv(beating(), -0.002), now = ecgAt_mv(beating(), -0.001), last_s = -1.0;
  for (int n = 0; n < 16000; ++n) {
    const double after = ecgAt_mv(beating(), 0.001 * n);
    if (now > 0.5 && now > before && now >= after) {
      ++peaks;
      EXPECT_NEAR(now, 1.0, 0.01);
      const double at_s = 0.001 * (n - 1);
      if (last_s >= 0.0) {
        EXPECT_NEAR(at_s - last_s, 0.8, 0.8 * 0.1 + 0.002);
      }
      last_s = at_s;
      EXPECT_EQ(stateAt(beating(), at_s).pulse < 0.02, true) << "the vessel widens after the R peak";
    }
    before = now;
    now = after;
  }
  EXPECT_NEAR(peaks, 20, 1);
}

TEST(Electrocardiogram, IsFlatWithoutAPulse) {
  const auto patient = testing::patientOf(testing::patientRecipe(R"({"name": "all", "tissue": "dark", "shape": {"of": "skin surface"}})"));
  ASSERT_TRUE(patient);
  EXPECT_FALSE(moves(**patient));
  for (double t = 0.0; t < 2.0; t += 0.05) EXPECT_EQ(ecgAt_mv(**patient, t), 0.0);
}

}  // namespace
}  // namespace ew::motion_test
