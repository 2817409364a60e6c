// The same motion in the hand, read by trackers of several rates: what assessment says of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "assessment/assessed_world.h"
#include "ew/assessment/step_metrics.h"
#include "scanning/tracked_scan.h"

namespace ew {
namespace {

using test::heldAt;
using test::imageAt;
using test::scanTracked;
using test::TrackedScan;

constexpr double kBefore_s = 3.0;  // a tracker runs before a step begins: its clock and its noise are known by then
constexpr double kBegin_s = 100.0 + kBefore_s;

/// Begins and ends at rest, as hands do: 0.5 s of rest, a second of starting, and the same at the end.
double wayAlong(double t) {
  const auto begun = [](double s) {
    const double u = std::clamp(s, 0.0, 1.0);
    return u * u * u * u * (2.5 + u * (-3.0 + u)) + std::max(0.0, s - 1.0);
  };
  return begun(t - 0.5) - begun(t - 18.5);
}

Transform<frame::World, frame::Probe> sweeping(double t) {
  const double way = wayAlong(t);
  return heldAt(20.0 * std::sin(0.9 * way), 10.0 * std::sin(1.3 * way), 15.0 * std::cos(0.6 * way));
}

/// Twenty seconds of a step.
ScanLog logOf(TrackedScan scan) {
  ScanLog log;
  std::uint64_t number = 0;
  scan.seconds = kBefore_s + 20.0;
  scan.stateAt = [during = scan.stateAt](double t) { return during(t - kBefore_s); };
  const auto path = [](double t) { return sweeping(t - kBefore_s); };
  scanTracked(scan, path, [&](double time_s, const Pose& pose) {
    if (time_s < kBegin_s) return;
    ScanState image = imageAt(pose.probeToWorld, time_s);
    image.pose = pose;
    image.number = number++;
    log.addFrame(image);
  });
  return log;
}

class TrackedRates : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<MetricValue> sweepOf(const ScanLog& scan) const {
    const ScanLog expert = test::scanAlong([](double t) { return heldAt(2.0 * t - 20.0); }, 20.0, 25.0);
    StepOutcome outcome;
    outcome.seconds = 20.0;
    for (const LessonStep& step : world_.lesson().steps) {
      if (step.id != "sweep") continue;
      const auto ground = world_.ground();
      const auto found = metricsOf({step, outcome, &scan}, *ground->caseOf(step), {&expert, {}});
      EXPECT_TRUE(found) << found.error();
      return found ? *found : std::vector<MetricValue>{};
    }
    return {};
  }
  /// The tolerances of resources/docs/science/teaching-measures.md.
  static void expectAlike(const std::vector<MetricValue>& one, const std::vector<MetricValue>& other, const std::string& what,
                          const std::set<std::string>& without = {}) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t n = 0; n < one.size(); ++n) {
      ASSERT_EQ(one[n].id, other[n].id);
      if (without.contains(one[n].id)) continue;
      const double bound = one[n].id == "coverage" || one[n].id == "plane_overlap" ? 0.05 : 0.02;
      EXPECT_NEAR(one[n].value, other[n].value, std::max(0.1, bound * std::abs(other[n].value))) << one[n].id << ", " << what;
    }
  }
  test::AssessedWorld world_;
};

TEST_F(TrackedRates, GiveTheFiguresOfTheMotionItself) {
  const auto truth = sweepOf(test::scanAlong(sweeping, 20.0, 50.0, kBegin_s));
  for (const double rate_hz : {30.0, 60.0, 100.0}) {
    const ScanLog log = logOf({.rate_hz = rate_hz});
    EXPECT_GT(log.frameCount(), 500u) << rate_hz;
    EXPECT_EQ(validShareOf(log), 1.0) << rate_hz;
    expectAlike(sweepOf(log), truth, std::to_string(rate_hz));
  }
}

TEST_F(TrackedRates, GiveTheSameFiguresOfANoisyTracker) {
  const auto usual = sweepOf(logOf({.rate_hz = 60.0, .noise_mm = 0.1}));
  // The third derivative of a noise is all that is left of a hand's jerk: that figure is the tracker's, at every rate. And what rests by a
  // hair more or less is a tenth of a second in twenty.
  for (const double rate_hz : {30.0, 100.0}) {
    const auto figures = sweepOf(logOf({.rate_hz = rate_hz, .noise_mm = 0.1}));
    expectAlike(figures, usual, std::to_string(rate_hz), {"log_dimensionless_jerk", "idle_share"});
    EXPECT_NEAR(*valueOf(figures, "idle_share"), *valueOf(usual, "idle_share"), 1.0) << rate_hz;
  }
}

TEST_F(TrackedRates, GiveTheSameFiguresWhereTheProbeWasOutOfViewForAWhile) {
  const auto stateAt = [](double t) {
    return (t > 6.0 && t < 7.5) || (t > 13.0 && t < 13.8) ? TrackingState::outOfView : TrackingState::live;
  };
  const ScanLog usual = logOf({.rate_hz = 60.0, .stateAt = stateAt});
  EXPECT_NEAR(validShareOf(usual), 1.0 - 2.3 / 20.0, 0.02);
  const auto figures = sweepOf(usual);
  const Motion motion = motionOf(heldPosesOf(usual));
  EXPECT_EQ(motion.stretches.size(), 3u) << "a gap is one to assessment, too";
  for (const double rate_hz : {30.0, 100.0}) {
    const ScanLog log = logOf({.rate_hz = rate_hz, .stateAt = stateAt});
    EXPECT_NEAR(validShareOf(log), validShareOf(usual), 0.02) << rate_hz;
    // A movement that a gap cuts begins and ends where the tracker's rate says so, and the jerk of a cut is that of the moment.
    expectAlike(sweepOf(log), figures, std::to_string(rate_hz), {"log_dimensionless_jerk"});
  }
}

}  // namespace
}  // namespace ew
