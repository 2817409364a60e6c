#include "ew/assessment/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace ew {
namespace {

constexpr double kPi = std::numbers::pi;

using Path = std::function<glm::dmat4(double time_s)>;

std::vector<Pose> sampled(const Path& path, double seconds, double rate_hz) {
  std::vector<Pose> poses;
  const auto count = static_cast<int>(std::lround(seconds * rate_hz));
  for (int n = 0; n <= count; ++n) {
    const double t = n / rate_hz;
    poses.push_back({{path(t)}, PoseStatus::ok, t});
  }
  return poses;
}

MotionFigures figuresFor(const std::vector<Pose>& poses) { return figuresOf(motionOf(poses)); }

glm::dmat4 at(const glm::dvec3& place_mm) { return glm::translate(glm::dmat4(1.0), place_mm); }

/// Along x, at rest before and behind.
Path minimumJerk(double length_mm, double begin_s, double seconds) {
  return [=](double t) {
    const double u = std::clamp((t - begin_s) / seconds, 0.0, 1.0);
    return at({length_mm * u * u * u * (10.0 - 15.0 * u + 6.0 * u * u), 0.0, 0.0});
  };
}

/// A hand that wanders, turns and trembles a little, with nothing above 3 Hz.
glm::dmat4 wandering(double t) {
  const glm::dvec3 place(40.0 * std::sin(0.7 * t) + 3.0 * std::sin(5.1 * t), 25.0 * std::cos(0.5 * t + 0.3) + 2.0 * std::sin(7.3 * t),
                         6.0 * std::sin(1.9 * t) + 0.4 * std::sin(18.0 * t));
  glm::dmat4 pose = at(place);
  pose = glm::rotate(pose, 0.5 * std::sin(0.9 * t), glm::dvec3(0.0, 1.0, 0.0));
  return glm::rotate(pose, 0.3 * std::sin(1.7 * t + 1.0), glm::dvec3(1.0, 0.0, 0.0));
}

TEST(Motion, OfACircleIsItsArcAndItsTurn) {
  for (const double rate_hz : {20.0, 50.0, 100.0}) {
    const auto figures = figuresFor(sampled(
        [](double t) {
          const double angle = 2.0 * kPi * t / 10.0;
          return glm::rotate(at({40.0 * std::cos(angle), 40.0 * std::sin(angle), 7.0}), angle, glm::dvec3(0.0, 0.0, 1.0));
        },
        25.0, rate_hz));
    EXPECT_NEAR(figures.path_mm, 2.0 * kPi * 40.0 * 2.5, 1e-3 * 2.0 * kPi * 40.0 * 2.5) << rate_hz;
    EXPECT_NEAR(figures.angularPath_deg, 900.0, 0.9) << rate_hz;
    EXPECT_DOUBLE_EQ(figures.validShare, 1.0);
    EXPECT_NEAR(figures.known_s, 25.0, 1e-9);
    EXPECT_DOUBLE_EQ(figures.idleShare, 0.0);
  }
}

TEST(Motion, OfALineIsItsLengthAndTurnsNothing) {
  const auto figures = figuresFor(sampled([](double t) { return at({12.0 * t, -9.0 * t, 20.0 * t}); }, 4.0, 30.0));
  EXPECT_NEAR(figures.path_mm, 100.0, 0.1);
  EXPECT_NEAR(figures.angularPath_deg, 0.0, 1e-6);
}

TEST(Motion, OfAConstantTurnAboutAnyAxisIsItsAngle) {
  const auto figures = figuresFor(
      sampled([](double t) { return glm::rotate(glm::dmat4(1.0), glm::radians(50.0) * t, glm::normalize(glm::dvec3(1.0, 2.0, -0.5))); },
              8.0, 20.0));
  EXPECT_NEAR(figures.angularPath_deg, 400.0, 0.4);
  EXPECT_NEAR(figures.path_mm, 0.0, 1e-6);
}

TEST(Motion, OfMinimumJerkHasTheJerkOfTheTheory) {
  for (const auto& [length_mm, seconds] : {std::pair(100.0, 2.0), std::pair(15.0, 0.8)}) {
    const Motion motion = motionOf(sampled(minimumJerk(length_mm, 0.0, seconds), seconds, 100.0), {.step_s = 0.005});
    ASSERT_EQ(motion.stretches.size(), 1u);
    const auto jerk = logDimensionlessJerk(motion.stretches[0].moments, motion.stretches[0].step_s);
    ASSERT_TRUE(jerk);
    EXPECT_NEAR(*jerk, -std::log(204.8), 1e-3 * std::log(204.8)) << seconds;
    EXPECT_NEAR(figuresOf(motion).path_mm, length_mm, 1e-3 * length_mm);
  }
}

TEST(Motion, IsSmootherWithoutStopsAndDoesNotDependOnSizeOrSpeed) {
  const auto arcOf = [](const Path& path, double seconds) { return figuresFor(sampled(path, seconds, 100.0)).spectralArcLength; };
  const auto one = arcOf(minimumJerk(100.0, 0.0, 2.0), 2.0), larger = arcOf(minimumJerk(300.0, 0.0, 2.0), 2.0),
             slower = arcOf(minimumJerk(100.0, 0.0, 4.0), 4.0);
  const Path first = minimumJerk(50.0, 0.0, 1.0), second = minimumJerk(50.0, 1.5, 1.0);
  const auto halting = arcOf([&](double t) { return first(t) * second(t); }, 2.5);
  ASSERT_TRUE(one && larger && slower && halting);
  EXPECT_NEAR(*one, *larger, 1e-9);
  EXPECT_NEAR(*one, *slower, 0.02);
  EXPECT_LT(*halting, *one - 0.3);
}

/// Its spectrum by numbers of its own: the integral of the speed of minimum jerk with a wave.
TEST(SpectralArcLength, OfMinimumJerkIsThatOfItsSpectrum) {
  constexpr double kStep_s = 0.01;
  std::vector<double> speed;
  for (int n = 0; n <= 200; ++n) {
    const double u = n / 200.0;
    speed.push_back(30.0 * u * u * (1.0 - u) * (1.0 - u));
  }
  const auto amplitude = [](double frequency_hz) {
    double cosine = 0.0, sine = 0.0;
    for (int n = 0; n < 4000; ++n) {
      const double u = (n + 0.5) / 4000.0, v = 30.0 * u * u * (1.0 - u) * (1.0 - u), phase = 2.0 * kPi * frequency_hz * 2.0 * u;
      cosine += v * std::cos(phase) / 4000.0;
      sine += v * std::sin(phase) / 4000.0;
    }
    return std::hypot(cosine, sine);
  };
  const double between_hz = 1.0 / (kStep_s * 4096.0);  // 201 values, to 256, padded by 16
  std::vector<double> curve;
  std::size_t last = 0;
  for (int n = 0; n * between_hz <= 10.0; ++n) {
    curve.push_back(amplitude(n * between_hz));
    if (curve.back() >= 0.05) last = curve.size() - 1;
  }
  double length = 0.0;
  for (std::size_t n = 0; n < last; ++n) length += std::hypot(1.0 / static_cast<double>(last), curve[n + 1] - curve[n]);
  const auto found = spectralArcLength(speed, kStep_s);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, -length, 1e-3 * length);
}

TEST(SpectralArcLength, OfNothingIsNothing) {
  EXPECT_FALSE(spectralArcLength({}, 0.01));
  EXPECT_FALSE(spectralArcLength(std::vector<double>{1.0, 2.0, 1.0}, 0.01));
  EXPECT_FALSE(spectralArcLength(std::vector<double>(100, 0.0), 0.01));
}

TEST(Motion, IsTheSameFromTwentyAndFromAHundredPosesASecond) {
  const MotionFigures few = figuresFor(sampled(wandering, 30.0, 20.0)), many = figuresFor(sampled(wandering, 30.0, 100.0));
  EXPECT_NEAR(few.path_mm, many.path_mm, 0.01 * many.path_mm);
  EXPECT_NEAR(few.angularPath_deg, many.angularPath_deg, 0.01 * many.angularPath_deg);
  EXPECT_NEAR(*few.spectralArcLength, *many.spectralArcLength, 0.02 * std::abs(*many.spectralArcLength));
  EXPECT_NEAR(*few.logDimensionlessJerk, *many.logDimensionlessJerk, 0.02 * std::abs(*many.logDimensionlessJerk));
}

TEST(Motion, DoesNotDependOnWhereTheWorldIsNorOnTheWayThroughTime) {
  const auto poses = sampled(wandering, 12.0, 40.0);
  const MotionFigures figures = figuresFor(poses);
  glm::dmat4 elsewhere = glm::rotate(at({300.0, -20.0, 8.0}), 1.1, glm::normalize(glm::dvec3(1.0, -1.0, 3.0)));
  std::vector<Pose> moved = poses, backwards(poses.rbegin(), poses.rend());
  for (Pose& each : moved) each.probeToWorld = {elsewhere * each.probeToWorld.matrix};
  for (Pose& each : backwards) each.time_s = 12.0 - each.time_s;
  for (const MotionFigures& other : {figuresFor(moved), figuresFor(backwards)}) {
    EXPECT_NEAR(other.path_mm, figures.path_mm, 1e-6 * figures.path_mm);
    EXPECT_NEAR(other.angularPath_deg, figures.angularPath_deg, 1e-6 * figures.angularPath_deg);
    EXPECT_NEAR(*other.spectralArcLength, *figures.spectralArcLength, 1e-6);
    EXPECT_NEAR(*other.logDimensionlessJerk, *figures.logDimensionlessJerk, 1e-6);
  }
}

TEST(Motion, SaysNothingOfGapsAndCountsThem) {
  auto poses = sampled([](double t) { return at({10.0 * t, 0.0, 0.0}); }, 10.0, 50.0);
  for (Pose& each : poses)
    if (each.time_s > 3.999 && each.time_s < 6.001) {
      each.status = PoseStatus::invalid;
      each.probeToWorld = {at({1e6, 0.0, 0.0})};  // trackers say anything
    }
  const MotionFigures figures = figuresFor(poses);
  EXPECT_NEAR(figures.seconds, 10.0, 1e-9);
  EXPECT_NEAR(figures.known_s, 7.96, 1e-9);
  EXPECT_NEAR(figures.path_mm, 79.6, 0.08);
  EXPECT_NEAR(figures.validShare, 400.0 / 501.0, 1e-12);
}

TEST(Motion, KnowsRestFromMotion) {
  const auto figures = figuresFor(sampled(minimumJerk(200.0, 3.0, 4.0), 12.0, 50.0));
  EXPECT_NEAR(figures.idleShare, 8.0 / 12.0, 0.04);
  EXPECT_TRUE(figures.logDimensionlessJerk);
  const auto still = figuresFor(sampled([](double) { return at({1.0, 2.0, 3.0}); }, 5.0, 50.0));
  EXPECT_DOUBLE_EQ(still.idleShare, 1.0);
  EXPECT_FALSE(still.logDimensionlessJerk);
}

TEST(Motion, OfFewOrEqualPosesSaysWhatCanBeSaid) {
  EXPECT_TRUE(motionOf({}).stretches.empty());
  std::vector<Pose> poses = {{{at({0.0, 0.0, 0.0})}, PoseStatus::ok, 1.0}};
  EXPECT_TRUE(motionOf(poses).stretches.empty());
  poses.push_back({{at({0.0, 0.0, 9.0})}, PoseStatus::ok, 1.0});  // of the same moment
  EXPECT_TRUE(motionOf(poses).stretches.empty());
  poses.push_back({{at({3.0, 4.0, 0.0})}, PoseStatus::ok, 1.2});
  EXPECT_NEAR(figuresFor(poses).path_mm, 5.0, 1e-6);
}

TEST(PosesOf, AreThoseOfTheImagesInTheTimeAskedFor) {
  ScanLog log;
  for (int n = 0; n < 10; ++n) {
    ScanState state;
    state.time_s = n;
    state.pose.probeToWorld = {at({double(n), 0.0, 0.0})};
    state.pose.status = n == 4 ? PoseStatus::invalid : PoseStatus::ok;
    state.pose.time_s = 100.0 + n;  // the tracker's clock
    log.addFrame(state);
  }
  const auto poses = posesOf(log, 3.0, 6.0);
  ASSERT_EQ(poses.size(), 4u);
  EXPECT_DOUBLE_EQ(poses[0].time_s, 3.0);
  EXPECT_DOUBLE_EQ(poses[3].probeToWorld.matrix[3].x, 6.0);
  EXPECT_EQ(poses[1].status, PoseStatus::invalid);
}

}  // namespace
}  // namespace ew
