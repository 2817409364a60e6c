#include "scanner/trajectory.h"

#include <gtest/gtest.h>
// gtest before rapidcheck: its header relies on it
#include <rapidcheck/gtest.h>

#include <numbers>

#include "scanner/tracker_errors.h"
#include "sweeps.h"

namespace ew::trajectory_test {
namespace {

using phantom::Trajectory;
using testing::ballPatient;
using testing::shippedProbe;

constexpr double kDegree_rad = std::numbers::pi / 180.0;

SweepRecipe onTheBall(SweepKind kind) {
  SweepRecipe recipe;
  recipe.kind = kind;
  recipe.frames = 21;
  recipe.framesPerSecond = 10.0;
  recipe.stations = {{.near_mm = {0, -75, 0}}};
  if (kind == SweepKind::parallel) recipe.extent_mm = 40;
  if (kind == SweepKind::fan || kind == SweepKind::rotational) recipe.extent_deg = 60;
  return recipe;
}

Trajectory trajectoryOf(const Patient& patient, const Probe& probe, const SweepRecipe& recipe) {
  auto trajectory = Trajectory::along(patient, probe, recipe);
  if (!trajectory) {
    ADD_FAILURE() << trajectory.error();
    std::abort();
  }
  return *trajectory;
}

glm::dvec3 inWorld(const Transform<frame::World, frame::Probe>& pose, const glm::dvec3& p_probe_mm) {
  return (pose * Point<frame::Probe>{p_probe_mm}).at;
}

/// How far the deepest point of the face is inside the body.
double depthOfFace_mm(const Patient& patient, const Probe& probe, const Transform<frame::World, frame::Probe>& pose) {
  double deepest = -1e9;
  for (const auto& point : facePoints_mm(probe, 65))
    deepest = std::max(deepest, -signedDistance_mm(patient, "skin surface", inWorld(pose, point)).value());
  return deepest;
}

// A patient's skin is kept on a grid; this is how far it is from the ball that was drawn.
constexpr double kKeptSkin_mm = 0.1;

TEST(Trajectory, PutsTheFaceOnTheSkinLookingStraightIn) {
  const auto patient = ballPatient();
  for (const char* id : {"linear-12", "convex-3.5", "phased-2.5", "endocavity-6.5"}) {
    auto recipe = onTheBall(SweepKind::freehand);
    recipe.stations[0].lateral = {1, 0.3, 0};  // made square to the beam
    const auto pose = trajectoryOf(*patient, shippedProbe(id), recipe).poseAt(0.0);
    EXPECT_TRUE(checkRigid(pose.matrix, 1e-9));
    EXPECT_NEAR(glm::distance(glm::dvec3(pose.matrix[3]), glm::dvec3(0, -60, 0)), 0.0, kKeptSkin_mm) << id << pose;
    EXPECT_NEAR(glm::distance(glm::dvec3(pose.matrix[1]), glm::dvec3(0, 1, 0)), 0.0, 1e-3) << id << pose;
    EXPECT_NEAR(glm::distance(glm::dvec3(pose.matrix[2]), glm::dvec3(0, 0, 1)), 0.0, 1e-3) << id << pose;
  }
}

TEST(Trajectory, ACurvedFaceThatLeansTouchesWithItsForemostPoint) {
  const auto patient = ballPatient();
  const Probe probe = shippedProbe("convex-3.5");
  auto recipe = onTheBall(SweepKind::freehand);
  recipe.stations[0].towards_mm = glm::dvec3(20, 0, 0);  // leans within the image plane
  const auto pose = trajectoryOf(*patient, probe, recipe).poseAt(0.0);
  // Two circles of equal radius touch half way between their centres; the arc's centre lies behind the skin by its radius.
  const glm::dvec3 centre = inWorld(pose, {0, -probe.radius_mm, 0});
  EXPECT_NEAR(glm::length(centre), 60.0 + probe.radius_mm, kKeptSkin_mm);
  EXPECT_LT(depthOfFace_mm(*patient, probe, pose), 0.01);
  recipe.indentation_mm = 3.0;
  const auto pressed = trajectoryOf(*patient, probe, recipe).poseAt(0.0);
  EXPECT_NEAR(glm::distance(glm::dvec3(pressed.matrix[3]), inWorld(pose, {0, 3.0, 0})), 0.0, 1e-9);
}

TEST(Trajectory, AHandKeepsTheFaceOnTheSkinAndMovesWithoutJumps) {
  const auto patient = ballPatient();
  for (const char* id : {"linear-12", "convex-3.5", "endocavity-6.5"}) {
    const Probe probe = shippedProbe(id);
    auto recipe = onTheBall(SweepKind::freehand);
    recipe.stations = {{.near_mm = {-20, -60, -25}},
                       {.near_mm = {0, -60, 0}, .lateral = {1, 0, 0.3}, .towards_mm = glm::dvec3(5, 0, 10)},
                       {.near_mm = {15, -60, 20}, .lateral = {1, 0, 0.6}}};
    recipe.unevenness = 1.0;
    recipe.frames = 101;
    const auto trajectory = trajectoryOf(*patient, probe, recipe);
    auto before = trajectory.poseAt(0.0);
    for (double time_s = 0.0; time_s <= trajectory.duration_s(); time_s += 0.004) {
      const auto pose = trajectory.poseAt(time_s);
      ASSERT_TRUE(checkRigid(pose.matrix, 1e-9));
      ASSERT_NEAR(depthOfFace_mm(*patient, probe, pose), 0.0, 0.05) << id << " at " << time_s;
      // 40 mm in 10 s by hand, with tremor of 10 Hz: below 100 mm/s and 100 degrees/s.
      ASSERT_LT(glm::distance(pose.matrix[3], before.matrix[3]), 0.4) << id << " at " << time_s;
      ASSERT_LT(glm::distance(pose.matrix[1], before.matrix[1]), 0.4 * kDegree_rad) << id << " at " << time_s;
      before = pose;
    }
  }
}

TEST(Trajectory, AnEvenHandPassesItsStationsAtAnEvenSpeed) {
  const auto patient = ballPatient();
  const Probe probe = shippedProbe("linear-12");
  auto recipe = onTheBall(SweepKind::freehand);
  const auto at = [](double angle_deg) {
    return glm::dvec3(0, -60 * std::cos(angle_deg * kDegree_rad), 60 * std::sin(angle_deg * kDegree_rad));
  };
  recipe.stations = {{.near_mm = at(-30)}, {.near_mm = at(0)}, {.near_mm = at(30)}};
  const auto trajectory = trajectoryOf(*patient, probe, recipe);
  for (int n = 0; n <= 20; ++n) {
    const auto pose = trajectory.poseAt(n / 10.0);
    EXPECT_LT(glm::distance(glm::dvec3(pose.matrix[3]), at(-30.0 + 3.0 * n)), 0.6) << n;
    EXPECT_LT(glm::distance(glm::dvec3(pose.matrix[1]), -at(-30.0 + 3.0 * n) / 60.0), 0.01) << n;
  }
  EXPECT_LT(glm::distance(glm::dvec3(trajectory.poseAt(1.0).matrix[3]), at(0)), kKeptSkin_mm);
  recipe.unevenness = 1.0;
  const auto uneven = trajectoryOf(*patient, probe, recipe);
  double slowest = 1e9, fastest = 0.0;
  for (int n = 0; n < 20; ++n) {
    const double way = glm::distance(uneven.poseAt(n / 10.0).matrix[3], uneven.poseAt((n + 1) / 10.0).matrix[3]);
    slowest = std::min(slowest, way);
    fastest = std::max(fastest, way);
  }
  EXPECT_GT(fastest, 1.5 * slowest);
}

TEST(Trajectory, MotorsMoveAsTheyAreBuilt) {
  const auto patient = ballPatient();
  const Probe probe = shippedProbe("convex-3.5");
  const auto parallel = trajectoryOf(*patient, probe, onTheBall(SweepKind::parallel));
  const auto start = parallel.poseAt(0.0);
  EXPECT_NEAR(glm::distance(glm::dvec3(parallel.poseAt(0.5).matrix[3]), inWorld(start, {0, 0, 10})), 0.0, 1e-9);
  EXPECT_NEAR(parallel.motorAt(0.5), 10.0, 1e-12);
  EXPECT_EQ(glm::dmat3(parallel.poseAt(2.0).matrix), glm::dmat3(start.matrix));

  auto recipe = onTheBall(SweepKind::fan);
  recipe.axisBehindFace_mm = 15.0;
  const auto fan = trajectoryOf(*patient, probe, recipe);
  EXPECT_NEAR(fan.motorAt(0.0), -30.0, 1e-12);
  EXPECT_NEAR(fan.motorAt(2.0), 30.0, 1e-12);
  const glm::dvec3 axis = inWorld(fan.start(), {7, -15, 0});
  for (const double time_s : {0.0, 0.7, 2.0}) {
    const auto pose = fan.poseAt(time_s);
    EXPECT_NEAR(glm::distance(inWorld(pose, {7, -15, 0}), axis), 0.0, 1e-9) << "the axis stands still";
    const double angle = fan.motorAt(time_s) * kDegree_rad;  // positive: towards the probe's z
    EXPECT_NEAR(glm::distance(inWorld(pose, {0, 85, 0}), inWorld(fan.start(), {0, 100 * std::cos(angle) - 15, 100 * std::sin(angle)})), 0.0,
                1e-9);
  }

  const auto rotational = trajectoryOf(*patient, probe, onTheBall(SweepKind::rotational));
  EXPECT_EQ(rotational.motorAt(0.0), 0.0);
  EXPECT_NEAR(rotational.motorAt(2.0), 60.0, 1e-12);
  const auto turned = rotational.poseAt(2.0);
  EXPECT_NEAR(glm::distance(inWorld(turned, {0, 50, 0}), inWorld(rotational.start(), {0, 50, 0})), 0.0, 1e-9)
      << "the central beam stands still";
  EXPECT_NEAR(glm::distance(inWorld(turned, {1, 0, 0}), inWorld(rotational.start(), {0.5, 0, -std::sqrt(0.75)})), 0.0, 1e-9);
}

TEST(Trajectory, StaysWhereItIsBeforeTheBeginningAndAfterTheEnd) {
  const auto patient = ballPatient();
  for (const auto kind : {SweepKind::freehand, SweepKind::parallel, SweepKind::fan, SweepKind::rotational}) {
    auto recipe = onTheBall(kind);
    if (kind == SweepKind::freehand) recipe.stations.push_back({.near_mm = {20, -60, 0}});
    const auto trajectory = trajectoryOf(*patient, shippedProbe("linear-12"), recipe);
    EXPECT_EQ(trajectory.poseAt(-1.0), trajectory.poseAt(0.0));
    EXPECT_EQ(trajectory.poseAt(5.0), trajectory.poseAt(2.0));
    EXPECT_FALSE(trajectory.poseAt(2.0) == trajectory.poseAt(0.0));
  }
}

TEST(Trajectory, OffTheSkinTheFaceIsWhereTheStationSays) {
  const auto patient = ballPatient();
  auto recipe = onTheBall(SweepKind::freehand);
  recipe.onSkin = false;
  recipe.stations = {{.near_mm = {1, 2, 3}, .towards_mm = glm::dvec3(1, 2, 53)},
                     {.near_mm = {11, 2, 3}, .towards_mm = glm::dvec3(11, 2, 53)}};
  const auto trajectory = trajectoryOf(*patient, shippedProbe("endocavity-6.5"), recipe);
  EXPECT_NEAR(glm::distance(inWorld(trajectory.poseAt(0.0), {0, 5, 0}), glm::dvec3(1, 2, 8)), 0.0, 1e-9);
  EXPECT_NEAR(glm::distance(inWorld(trajectory.poseAt(1.0), {0, 0, 0}), glm::dvec3(6, 2, 3)), 0.0, 1e-6);
  EXPECT_NEAR(glm::distance(glm::dvec3(trajectory.poseAt(1.0).matrix[0]), glm::dvec3(1, 0, 0)), 0.0, 1e-9);
}

TEST(Trajectory, NamesTheStationThatCannotBeUsed) {
  const auto patient = ballPatient();
  const auto refusal = [&](const std::function<void(SweepRecipe&)>& change, SweepKind kind = SweepKind::freehand) {
    auto recipe = onTheBall(kind);
    change(recipe);
    const auto trajectory = Trajectory::along(*patient, shippedProbe("convex-3.5"), recipe);
    return trajectory ? std::string("was taken") : trajectory.error().sentence();
  };
  const auto expect = [](const std::string& sentence, const std::string& part) {
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  };
  expect(refusal([](auto& r) { r.stations.clear(); }), "no station");
  expect(refusal([](auto& r) { r.stations[0].near_mm = {0, -150, 0}; }), "no skin within 80 mm");
  expect(refusal([](auto& r) { r.stations[0].towards_mm = glm::dvec3(0, -200, 0); }), "out of the body");
  expect(refusal([](auto& r) { r.stations[0].lateral = {0, 1, 0}; }), "along its beam");
  expect(refusal([](auto& r) { r.stations.push_back({.near_mm = {5, -60, 0}, .lateral = {-1, 0, 0}}); }), "stations[1] turns");
  expect(refusal([](auto& r) { r.stations.push_back({.near_mm = {5, -60, 0}}); }, SweepKind::fan), "starts from one");
  expect(refusal([](auto& r) { r.indentation_mm = 50; }), "at most");
  expect(refusal([](auto& r) { r.onSkin = false; }), "where it looks");
  expect(refusal([](auto& r) {
           r.onSkin = false;
           r.stations[0] = {.near_mm = {0, 0, 90}, .towards_mm = glm::dvec3(0)};
         }),
         "outside the patient's box");
}

TEST(Tracker, WithoutErrorsSeesTheProbeWhereItIs) {
  const auto patient = ballPatient();
  auto recipe = onTheBall(SweepKind::fan);
  const auto trajectory = trajectoryOf(*patient, shippedProbe("linear-12"), recipe);
  const auto tracked = track(trajectory, recipe, 2, noProgress()).value();
  for (int n = 0; n < recipe.frames; ++n) {
    const auto& pose = tracked.poses[static_cast<std::size_t>(n)];
    EXPECT_EQ(pose.status, PoseStatus::ok);
    EXPECT_DOUBLE_EQ(pose.time_s, n / 10.0);
    EXPECT_DOUBLE_EQ(tracked.unfilteredTime_s[static_cast<std::size_t>(n)], n / 10.0);
    EXPECT_LT(glm::distance(pose.probeToWorld.matrix[3], trajectory.poseAt(n / 10.0).matrix[3]), 1e-12);
  }
}

TEST(Tracker, LagsByExactlyItsLatency) {
  const auto patient = ballPatient();
  auto recipe = onTheBall(SweepKind::parallel);
  recipe.tracker.latency_s = 0.13;
  const auto trajectory = trajectoryOf(*patient, shippedProbe("linear-12"), recipe);
  const auto tracked = track(trajectory, recipe, 2, noProgress()).value();
  for (int n = 0; n < recipe.frames; ++n)
    EXPECT_EQ(tracked.poses[static_cast<std::size_t>(n)].probeToWorld, trajectory.poseAt(n / 10.0 - 0.13)) << n;
}

TEST(Tracker, ErrsByTheStatedAmounts) {
  const auto patient = ballPatient();
  auto recipe = onTheBall(SweepKind::freehand);
  recipe.frames = 4000;
  recipe.tracker = {.noise_mm = 0.4, .noise_deg = 0.7, .jitter_s = 0.01, .dropOutShare = 0.2, .seed = 3};
  const auto trajectory = trajectoryOf(*patient, shippedProbe("linear-12"), recipe);
  const auto truth = trajectory.poseAt(0.0);
  const auto tracked = track(trajectory, recipe, 2, noProgress()).value();
  glm::dvec3 shift(0.0), shift2(0.0), turn2(0.0);
  double jitter2 = 0.0;
  int good = 0, lost = 0, runs = 0;
  for (std::size_t n = 0; n < tracked.poses.size(); ++n) {
    const auto& pose = tracked.poses[n];
    jitter2 += std::pow(tracked.unfilteredTime_s[n] - pose.time_s, 2);
    EXPECT_TRUE(checkRigid(pose.probeToWorld.matrix)) << "an INVALID pose has plausible numbers, too";
    if (pose.status == PoseStatus::invalid) {
      ++lost;
      runs += n == 0 || tracked.poses[n - 1].status == PoseStatus::ok ? 1 : 0;
      continue;
    }
    ++good;
    const glm::dvec3 by = glm::dvec3(pose.probeToWorld.matrix[3] - truth.matrix[3]);
    const glm::dmat3 turned = glm::transpose(glm::dmat3(truth.matrix)) * glm::dmat3(pose.probeToWorld.matrix);
    const glm::dvec3 angle = glm::dvec3(turned[1][2], turned[2][0], turned[0][1]) / kDegree_rad;
    shift += by, shift2 += by * by, turn2 += angle * angle;
  }
  EXPECT_EQ(lost, 800);
  EXPECT_GT(runs, 80);
  EXPECT_LT(runs, 400) << "losses come in runs";
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(shift[axis] / good, 0.0, 0.03);
    EXPECT_NEAR(std::sqrt(shift2[axis] / good), 0.4, 0.02);
    EXPECT_NEAR(std::sqrt(turn2[axis] / good), 0.7, 0.03);
  }
  EXPECT_NEAR(std::sqrt(jitter2 / 4000.0), 0.01, 0.0005);
  EXPECT_EQ(track(trajectory, recipe, 1, noProgress())->poses, tracked.poses);
  recipe.tracker.seed = 4;
  EXPECT_NE(track(trajectory, recipe, 1, noProgress())->poses, tracked.poses);
}

}  // namespace
}  // namespace ew::trajectory_test
