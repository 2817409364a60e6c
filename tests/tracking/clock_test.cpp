#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "ew/tracking/tracker_clock.h"

namespace ew::clock_test {
namespace {

/// A tracker with a clock of its own, messages on a way that takes its time, and the truth.
class SimulatedTracker {
 public:
  struct Ways {
    double offset_s = -1.7e9;  ///< of its clock against ours: since 1970
    double drift_ppm = 0.0;    ///< it runs faster by
    double shortest_s = 0.0;   ///< delay of the quickest message
    double usual_s = 0.001;    ///< mean of what comes on top, exponentially distributed
    double stalls = 0.01;      ///< share of messages that take up to a fifth of a second more
    double period_s = 1.0 / 60;
  };
  SimulatedTracker(const Ways& ways, unsigned seed) : ways_(ways), random_(seed) {}

  struct Message {
    double measured_s, device_s, arrival_s;
  };
  Message next() {
    time_s_ += ways_.period_s;
    std::exponential_distribution<double> delay(1.0 / ways_.usual_s);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    double late_s = delay(random_);
    if (share(random_) < ways_.stalls) late_s += 0.2 * share(random_);
    // Messages of one connection do not overtake each other.
    arrival_s_ = std::max(arrival_s_, time_s_ + ways_.shortest_s + late_s);
    return {time_s_, stampOf(time_s_), arrival_s_};
  }
  void jump(double by_s) { jumped_s_ += by_s; }
  [[nodiscard]] double stampOf(double time_s) const {
    return -ways_.offset_s + jumped_s_ + (time_s - kStart_s) * (1.0 + 1e-6 * ways_.drift_ppm);
  }

 private:
  static constexpr double kStart_s = 5000.0;
  Ways ways_;
  std::mt19937_64 random_;
  double time_s_ = kStart_s, arrival_s_ = 0.0, jumped_s_ = 0.0;
};

/// Largest error against the truth from `from_s` to `to_s` after the start; the shortest delay, which nobody can know, is allowed for.
double worst_s(TrackerClock& clock, SimulatedTracker& tracker, const SimulatedTracker::Ways& ways, double from_s, double to_s) {
  double worst = 0.0;
  const int count = static_cast<int>(to_s / ways.period_s);
  for (int n = 0; n < count; ++n) {
    const auto message = tracker.next();
    const double mapped_s = clock.steadyOf(message.device_s, message.arrival_s);
    EXPECT_LE(mapped_s, message.arrival_s);
    if (n * ways.period_s >= from_s) worst = std::max(worst, std::abs(mapped_s - message.measured_s - ways.shortest_s));
  }
  return worst;
}

}  // namespace

TEST(TrackerClock, TakesTheArrivalOfATrackerThatStampsNothing) {
  TrackerClock clock;
  EXPECT_EQ(clock.steadyOf(std::numeric_limits<double>::quiet_NaN(), 12.5), 12.5);
  EXPECT_FALSE(clock.isStamped());
}

TEST(TrackerClock, IsExactWhereNothingIsDelayedAndNothingDrifts) {
  TrackerClock clock;
  for (int n = 0; n < 10'000; ++n) {
    const double time_s = 100.0 + n / 128.0;
    ASSERT_EQ(clock.steadyOf(time_s + 4096.0, time_s), time_s);
  }
  EXPECT_EQ(clock.drift_ppm(), 0.0);
  EXPECT_EQ(clock.jumps(), 0u);
}

RC_GTEST_PROP(TrackerClock, KnowsOffsetAndDriftWithinTwoMillisecondsAfterFiveSeconds, ()) {
  SimulatedTracker::Ways ways;
  ways.offset_s = 1e3 * *rc::gen::inRange(-1'700'000, 1'700'000) + 77.7;
  ways.drift_ppm = *rc::gen::inRange(-200, 201);
  ways.shortest_s = 1e-3 * *rc::gen::inRange(0, 30);
  ways.usual_s = 1e-4 * *rc::gen::inRange(1, 40);
  ways.stalls = 0.01 * *rc::gen::inRange(0, 6);
  ways.period_s = 1.0 / *rc::gen::element(30, 60, 100, 250);
  SimulatedTracker tracker(ways, *rc::gen::arbitrary<unsigned>());
  TrackerClock clock;
  RC_ASSERT(worst_s(clock, tracker, ways, 5.0, 90.0) < 2e-3);
  RC_ASSERT(std::abs(clock.drift_ppm() - ways.drift_ppm) < 25.0);
  RC_ASSERT(clock.jumps() == 0u);
}

RC_GTEST_PROP(TrackerClock, FindsARestartAndBeginsAnew, ()) {
  SimulatedTracker::Ways ways;
  ways.drift_ppm = *rc::gen::inRange(-100, 101);
  SimulatedTracker tracker(ways, *rc::gen::arbitrary<unsigned>());
  TrackerClock clock;
  RC_ASSERT(worst_s(clock, tracker, ways, 5.0, 20.0) < 2e-3);
  tracker.jump(*rc::gen::element(-1.7e9, -3600.0, -1.5, -0.3, -0.1, 0.03, 0.06, 0.3, 1.5, 3600.0));
  RC_ASSERT(worst_s(clock, tracker, ways, 5.0, 20.0) < 2e-3);
  RC_ASSERT(clock.jumps() >= 1u);
  RC_ASSERT(clock.jumps() <= 3u);
}

TEST(TrackerClock, LetsMessagesThatOvertakeEachOtherBe) {
  TrackerClock clock;
  SimulatedTracker::Ways ways;
  SimulatedTracker tracker(ways, 3);
  for (int n = 0; n < 3000; ++n) {
    const auto first = tracker.next(), second = tracker.next();
    // The second comes first: the other's stamp falls.
    const double later_s = clock.steadyOf(second.device_s, first.arrival_s + ways.period_s);
    const double earlier_s = clock.steadyOf(first.device_s, second.arrival_s + ways.period_s);
    if (n < 300) continue;
    ASSERT_NEAR(later_s - earlier_s, second.measured_s - first.measured_s, 1e-4);
  }
  EXPECT_EQ(clock.jumps(), 0u);
}

TEST(TrackerClock, SitsOutAStallAndTheBurstAfterIt) {
  TrackerClock clock;
  SimulatedTracker::Ways ways;
  ways.stalls = 0.0;
  SimulatedTracker tracker(ways, 8);
  EXPECT_LT(worst_s(clock, tracker, ways, 5.0, 10.0), 2e-3);
  // Three seconds of messages come at once: the first is three seconds old, the last is new.
  std::vector<SimulatedTracker::Message> held;
  for (int n = 0; n < 180; ++n) held.push_back(tracker.next());
  for (const auto& message : held) ASSERT_NEAR(clock.steadyOf(message.device_s, held.back().arrival_s), message.measured_s, 2e-3);
  EXPECT_EQ(clock.jumps(), 0u);
}

TEST(TrackerClock, KnowsTheClockOfThisComputerAndThenTheWholeDelay) {
  TrackerClock clock;
  for (int n = 0; n < 600; ++n) {
    const double measured_s = 5000.0 + n / 30.0;
    ASSERT_EQ(clock.steadyOf(measured_s, measured_s + 0.040 + 0.002 * (n % 5)), measured_s) << "a camera that stamps by our clock";
  }
  EXPECT_TRUE(clock.isOurs());
}

TEST(TrackerClock, ForgetsADriftThatChangedWithinAMinute) {
  TrackerClock clock;
  double device_s = 0.0, time_s = 100.0;
  const auto run = [&](double drift_ppm, double length_s) {
    double worst = 0.0;
    for (int n = 0; n < static_cast<int>(60.0 * length_s); ++n) {
      time_s += 1.0 / 60;
      device_s += (1.0 + 1e-6 * drift_ppm) / 60;
      const double mapped_s = clock.steadyOf(device_s, time_s + 1e-4 * (n % 7));
      if (n > 60.0 * 65.0) worst = std::max(worst, std::abs(mapped_s - time_s));
    }
    return worst;
  };
  EXPECT_LT(run(150.0, 100.0), 2e-3);
  EXPECT_LT(run(-150.0, 100.0), 2e-3) << "it warmed up";
  EXPECT_NEAR(clock.drift_ppm(), -150.0, 5.0);
}

TEST(TrackerClock, StaysExactAndSmallOverADay) {
  TrackerClock clock;
  SimulatedTracker::Ways ways;
  ways.drift_ppm = 40.0;
  ways.period_s = 1.0 / 20;
  SimulatedTracker tracker(ways, 5);
  EXPECT_LT(worst_s(clock, tracker, ways, 5.0, 86'400.0), 2e-3);
  EXPECT_EQ(clock.jumps(), 0u);
}

}  // namespace ew::clock_test
