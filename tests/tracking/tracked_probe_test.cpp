#include "ew/tracking/tracked_probe.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <thread>

#include "ew/tracking/tracking_words.h"
#include "told_tracker.h"

namespace ew::tracked_probe_test {
namespace {

using test::faceAt;
using test::FacePose;
using test::HandPath;
using test::onPath;
using test::PoseNoise;
using test::readingOf;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kSteadyMinusScan_s = 4000.0;  // the scan's clock began later than this computer's

/// A probe on a tracker of the test, and the time of both: nothing waits.
struct Simulation {
  std::shared_ptr<test::ToldTracker> tracker = std::make_shared<test::ToldTracker>();
  double steady_s = 5000.0;
  double deviceMinusSteady_s = -1234.5;
  double delay_s = 0.01;
  double period_s = 1.0 / 30;
  PoseNoise noise{0.2, 0.002, 4};
  TrackedProbe probe;

  explicit Simulation(const TrackedProbeOptions& options = {.tool = "Probe"}, const TrackerCalibration& calibration = {})
      : probe(tracker, options, calibration, kSteadyMinusScan_s) {
    tracker->start();
  }
  [[nodiscard]] double scan_s() const { return steady_s - kSteadyMinusScan_s; }
  [[nodiscard]] Pose pose() const { return probe.poseAt(scan_s()); }
  [[nodiscard]] TrackingState state() const { return probe.report(scan_s()).state; }

  void say(const std::string& tool, const FacePose& pose, TrackingState state = TrackingState::live) {
    tracker->say(readingOf(tool, pose, steady_s - delay_s + deviceMinusSteady_s, steady_s, state));
  }
  /// A period goes by, and the tool is read at its end.
  void tick(const FacePose& pose, TrackingState state = TrackingState::live) {
    steady_s += period_s;
    say("Probe", noise.on(pose), state);
  }
  void rest(double length_s) {
    for (double end_s = steady_s + length_s; steady_s < end_s;) tick(faceAt({10.0, 20.0, 300.0}, glm::dvec3(0.0)));
  }
  /// Time goes by without a reading; looked at every 10 ms as a window does. How long until the state was seen.
  double until(TrackingState wanted, const std::function<void()>& every, double most_s = 3.0) {
    const double begin_s = steady_s;
    double next_s = steady_s;
    while (steady_s - begin_s < most_s) {
      if (state() == wanted) return steady_s - begin_s;
      steady_s += 0.01;
      if (steady_s >= next_s + period_s) {
        next_s += period_s;
        every();
      }
    }
    return most_s;
  }
};

double apart_mm(const Pose& pose, const glm::dvec3& place_mm) { return glm::distance(glm::dvec3(pose.probeToWorld.matrix[3]), place_mm); }

}  // namespace

TEST(TrackedProbe, PutsToolReferenceAndCalibrationTogether) {
  TrackerCalibration calibration;
  calibration.probeToTool.matrix = faceAt({0.0, 0.0, 120.0}, {0.4, 0.0, 0.0}).matrix;
  calibration.trackerToWorld.matrix = faceAt({5.0, -90.0, 1000.0}, {0.0, 0.0, 1.1}).matrix;
  Simulation s({.tool = "Probe", .reference = "Body", .filter = FilterKind::none}, calibration);
  const FacePose tool = faceAt({30.0, 40.0, 500.0}, {0.2, 0.5, -0.3}), body = faceAt({-100.0, 60.0, 700.0}, {0.7, -0.2, 0.9});
  for (int n = 0; n < 20; ++n) {
    s.steady_s += s.period_s;
    s.say("Probe", tool);
    s.say("Body", body);
  }
  const glm::dmat4 expected = calibration.trackerToWorld.matrix * glm::inverse(body.matrix) * tool.matrix * calibration.probeToTool.matrix;
  const Pose pose = s.pose();
  EXPECT_EQ(pose.status, PoseStatus::ok);
  for (int c = 0; c < 4; ++c) EXPECT_LT(glm::length(pose.probeToWorld.matrix[c] - expected[c]), 1e-9);
}

TEST(TrackedProbe, TakesTheReferenceOfTheReadingsOwnMoment) {
  // Camera and mannequin shake together: against each other nothing moves, whatever order their messages come in.
  for (const bool referenceFirst : {true, false}) {
    Simulation s({.tool = "Probe", .reference = "Body", .filter = FilterKind::none});
    for (int n = 0; n < 60; ++n) {
      s.steady_s += s.period_s;
      const FacePose shake = faceAt({50.0 * std::sin(0.7 * n), 30.0 * std::cos(1.1 * n), 0.0}, {0.0, 0.3 * std::sin(0.9 * n), 0.0});
      const FacePose tool{shake.matrix * faceAt({0.0, 0.0, 200.0}, glm::dvec3(0.0)).matrix};
      s.say(referenceFirst ? "Body" : "Probe", referenceFirst ? shake : tool);
      s.say(referenceFirst ? "Probe" : "Body", referenceFirst ? tool : shake);
      ASSERT_LT(apart_mm(s.pose(), {0.0, 0.0, 200.0}), 1e-6) << n;
    }
  }
}

TEST(TrackedProbe, FollowsTheFirstToolThatIsHeardOfWhereNoneIsChosen) {
  Simulation s(TrackedProbeOptions{.reference = "Body"});
  s.steady_s += 0.1;
  s.say("Body", faceAt(glm::dvec3(0.0), glm::dvec3(0.0)));
  s.say("Stylus", faceAt({1.0, 0.0, 0.0}, glm::dvec3(0.0)), TrackingState::outOfView);
  s.say("Wand", faceAt({2.0, 0.0, 0.0}, glm::dvec3(0.0)));
  s.say("Stylus", faceAt({1.0, 0.0, 0.0}, glm::dvec3(0.0)));
  EXPECT_EQ(s.state(), TrackingState::live);
  EXPECT_EQ(s.probe.report(s.scan_s()).tool, "Wand");
  EXPECT_NEAR(s.pose().probeToWorld.matrix[3].x, 2.0, 1e-9);
}

TEST(TrackedProbe, EveryStateIsEnteredWithinSixTenthsOfASecondAndLeftWithTheNextGoodReading) {
  const FacePose place = faceAt({10.0, 20.0, 300.0}, glm::dvec3(0.0));
  struct Case {
    TrackingState state;
    PoseStatus status;
    std::function<void(Simulation&)> every;  ///< instead of a good reading
    std::function<void(Simulation&)> begin = [](Simulation&) {};
    std::function<void(Simulation&)> end = [](Simulation&) {};
  };
  const std::vector<Case> cases{
      {TrackingState::stale, PoseStatus::missing, [](Simulation&) {}},
      {TrackingState::outOfView, PoseStatus::missing, [&](Simulation& s) { s.say("Probe", place, TrackingState::outOfView); }},
      {TrackingState::outOfView, PoseStatus::missing, [&](Simulation& s) { s.say("Another", place); }},
      {TrackingState::invalid, PoseStatus::invalid, [&](Simulation& s) { s.say("Probe", place, TrackingState::invalid); }},
      {TrackingState::outOfRange, PoseStatus::invalid, [&](Simulation& s) { s.say("Probe", place, TrackingState::outOfRange); }},
      {TrackingState::outOfRange, PoseStatus::invalid,
       [&](Simulation& s) {
         ToolReading vague = readingOf("Probe", place, s.steady_s + s.deviceMinusSteady_s, s.steady_s);
         vague.spread_mm = 12.0;
         s.tracker->say(vague);
       }},
      {TrackingState::duplicate, PoseStatus::invalid, [&](Simulation& s) { s.tracker->say(readingOf("Probe", place, 17.0, s.steady_s)); },
       [&](Simulation& s) { s.tracker->say(readingOf("Probe", place, 17.0, s.steady_s)); }},
      {TrackingState::lost, PoseStatus::missing, [](Simulation&) {},
       [](Simulation& s) { s.tracker->link(LinkState::connecting, verbatim("No answer.")); },
       [](Simulation& s) { s.tracker->link(LinkState::connected); }},
      {TrackingState::lost, PoseStatus::missing, [](Simulation&) {},
       [](Simulation& s) { s.tracker->link(LinkState::ended, verbatim("Over.")); },
       [](Simulation& s) { s.tracker->link(LinkState::connected); }},
      {TrackingState::off, PoseStatus::missing, [](Simulation&) {}, [](Simulation& s) { s.tracker->stop(); },
       [](Simulation& s) { s.tracker->start(); }}};
  for (const Case& each : cases) {
    Simulation s;
    s.rest(4.0);
    ASSERT_EQ(s.state(), TrackingState::live);
    const Pose good = s.pose();
    each.begin(s);
    const double seen_s = s.until(each.state, [&] { each.every(s); });
    EXPECT_LE(seen_s, 0.6) << stateWord(each.state);
    const Pose bad = s.pose();
    EXPECT_EQ(bad.status, each.status) << stateWord(each.state);
    EXPECT_LT(apart_mm(bad, glm::dvec3(good.probeToWorld.matrix[3])), 1.0) << "the last good place";
    EXPECT_FALSE(s.probe.report(s.scan_s()).sentence.empty());
    each.end(s);
    s.tick(place);
    EXPECT_EQ(s.state(), TrackingState::live) << stateWord(each.state);
    EXPECT_EQ(s.pose().status, PoseStatus::ok);
    EXPECT_LT(apart_mm(s.pose(), {10.0, 20.0, 300.0}), 2.0);
  }
}

TEST(TrackedProbe, BridgesASingleReadingThatIsMissingAndShowsTwo) {
  for (const TrackingState state : {TrackingState::outOfView, TrackingState::invalid}) {
    Simulation s;
    const auto moving = [&](int n) { return faceAt({90.0 * n * s.period_s, 0.0, 0.0}, glm::dvec3(0.0)); };
    for (int n = 0; n < 300; ++n) {
      s.tick(moving(n), n % 30 == 29 ? state : TrackingState::live);
      if (n < 10) continue;
      for (int look = 0; look < 3; ++look) ASSERT_EQ(s.state(), TrackingState::live) << n;
      ASSERT_EQ(s.pose().status, PoseStatus::ok);
      ASSERT_LT(std::abs(s.pose().probeToWorld.matrix[3].x - moving(n).matrix[3].x), 2.0) << "carried on by a period";
    }
    s.tick(moving(300), state);
    s.tick(moving(301), state);
    s.steady_s += 0.6 * s.period_s;
    EXPECT_EQ(s.state(), state);
  }
}

TEST(TrackedProbe, AHandOverTheReferenceForAMomentIsNoLossAndForLongerIsOne) {
  Simulation s({.tool = "Probe", .reference = "Body"});
  const auto tick = [&](bool isSeen) {
    s.tick(faceAt({0.0, 0.0, 100.0}, glm::dvec3(0.0)));
    s.say("Body", faceAt(glm::dvec3(0.0), glm::dvec3(0.0)), isSeen ? TrackingState::live : TrackingState::outOfView);
  };
  for (int n = 0; n < 60; ++n) tick(true);
  for (int n = 0; n < 12; ++n) {
    tick(false);
    ASSERT_EQ(s.state(), TrackingState::live) << n;
  }
  for (int n = 0; n < 12; ++n) tick(false);
  EXPECT_EQ(s.state(), TrackingState::outOfView);
  EXPECT_EQ(s.probe.report(s.scan_s()).sentence, stateSentence(TrackingState::outOfView, "Body"));
  tick(true);
  EXPECT_EQ(s.state(), TrackingState::live);
}

TEST(TrackedProbe, APerfectlyStillSourceIsNotFrozenAndANoisyOneThatRepeatsItselfIs) {
  // A recording or a simulated tracker moves, then stands without any noise: its stamps go on.
  Simulation still;
  still.noise = PoseNoise(0.0, 0.0, 1);
  for (int n = 0; n < 200; ++n) still.tick(onPath(HandPath::sweeps, n * still.period_s));
  for (int n = 0; n < 200; ++n) {
    still.tick(onPath(HandPath::sweeps, 200 * still.period_s));
    ASSERT_EQ(still.state(), TrackingState::live) << n;
  }
  // An optical tracker never reads the same twice; its driver hangs and repeats the last reading under new stamps.
  Simulation frozen;
  for (int n = 0; n < 300; ++n) frozen.tick(onPath(HandPath::sweeps, n * frozen.period_s));
  frozen.rest(4.0);
  frozen.noise = PoseNoise(0.0, 0.0, 1);
  const FacePose place = faceAt({10.0, 20.0, 300.0}, glm::dvec3(0.0));
  EXPECT_LE(frozen.until(TrackingState::duplicate, [&] { frozen.say("Probe", place); }), 0.6);
  EXPECT_EQ(frozen.pose().status, PoseStatus::invalid);
}

TEST(TrackedProbe, ATrackerThatRoundsIsNotFrozenWhereItRests) {
  Simulation s;
  s.noise = PoseNoise(0.02, 0.0, 6);
  int frozen = 0;
  for (int n = 0; n < 20'000; ++n) {
    s.steady_s += s.period_s;
    FacePose pose = s.noise.on(faceAt({10.02, 20.01, 300.04}, glm::dvec3(0.0)));
    // To a tenth of a millimetre, as some protocols write numbers: it repeats itself most of the time.
    for (int i = 0; i < 3; ++i) pose.matrix[3][i] = std::round(10.0 * pose.matrix[3][i]) / 10.0;
    s.say("Probe", pose);
    if (s.state() == TrackingState::duplicate) ++frozen;
  }
  EXPECT_EQ(frozen, 0);
}

TEST(TrackedProbe, AServerThatSendsFasterThanItMeasuresIsLive) {
  Simulation s;
  for (int n = 0; n < 600; ++n) {
    s.steady_s += 0.01;
    // Measured every fifth time, under the stamp of the measurement.
    const int measured = n / 5;
    s.tracker->say(readingOf("Probe", onPath(HandPath::sweeps, 0.05 * measured), 0.05 * measured, s.steady_s));
    if (n <= 20) continue;
    ASSERT_EQ(s.state(), TrackingState::live) << n;
  }
  EXPECT_NEAR(s.probe.report(s.scan_s()).rate_hz, 20.0, 1.0) << "what counts is what was measured";
}

TEST(TrackedProbe, ReportsRateDelayJitterNoiseAndDrift) {
  Simulation s;
  s.period_s = 1.0 / 60;
  s.noise = PoseNoise(0.4, 0.003, 2);
  std::mt19937_64 random(3);
  std::exponential_distribution<double> late(1.0 / 0.004);
  double device_s = 100.0, arrival_s = 0.0;
  for (int n = 0; n < 60 * 30; ++n) {
    s.steady_s += s.period_s;
    device_s += s.period_s * (1.0 + 80e-6);
    arrival_s = std::max(arrival_s, s.steady_s + late(random));
    s.tracker->say(readingOf("Probe", s.noise.on(onPath(HandPath::rests, n * s.period_s)), device_s, arrival_s));
    static_cast<void>(s.pose());
  }
  const TrackingReport report = s.probe.report(s.scan_s());
  EXPECT_EQ(report.state, TrackingState::live);
  EXPECT_NEAR(report.rate_hz, 60.0, 1.0);
  EXPECT_NEAR(report.delay_s, 0.004 * std::log(2.0), 0.001) << "the median of what comes on top of the shortest delay";
  EXPECT_NEAR(report.jitterTime_s, 0.004 * std::sqrt(2.0), 0.0025);
  EXPECT_NEAR(report.noise_mm, 0.4, 0.1);
  EXPECT_LT(report.left_mm, 0.3);
  EXPECT_NEAR(report.drift_ppm, 80.0, 25.0);
  EXPECT_EQ(report.filter, FilterKind::kalman);
  EXPECT_GT(report.since_s, 29.0);
}

TEST(TrackedProbe, SaysNothingOfADelayWhereTheTrackerStampsNothing) {
  Simulation s;
  for (int n = 0; n < 100; ++n) {
    s.steady_s += s.period_s;
    s.tracker->say(readingOf("Probe", s.noise.on(FacePose{}), kNone, s.steady_s));
  }
  EXPECT_EQ(s.state(), TrackingState::live);
  EXPECT_TRUE(std::isnan(s.probe.report(s.scan_s()).delay_s));
}

TEST(TrackedProbe, NamesTheToolsThereAreWhereTheChosenOneIsNone) {
  Simulation s({.tool = "ProbeToTracker"});
  for (int n = 0; n < 40; ++n) {
    s.steady_s += s.period_s;
    s.say("StylusToTracker", FacePose{});
    s.say("NeedleToTracker", FacePose{});
  }
  EXPECT_EQ(s.state(), TrackingState::outOfView);
  EXPECT_EQ(
      s.probe.report(s.scan_s()).sentence.english(),
      "The tracker does not send 'ProbeToTracker', but 'StylusToTracker', 'NeedleToTracker'; choose which of them carries the probe.");
}

TEST(TrackedProbe, ChangesToolAndCalibrationWhileItIsFollowed) {
  Simulation s;
  s.rest(1.0);
  TrackerCalibration calibration;
  calibration.trackerToWorld.matrix[3] = {0.0, 0.0, -300.0, 1.0};
  s.probe.setCalibration(calibration);
  EXPECT_EQ(s.pose().status, PoseStatus::ok);
  EXPECT_LT(apart_mm(s.pose(), {10.0, 20.0, 0.0}), 2.0);
  s.probe.setOptions({.tool = "Other"});
  EXPECT_NE(s.pose().status, PoseStatus::ok) << "nothing was heard of it";
  s.steady_s += s.period_s;
  s.say("Other", faceAt({1.0, 2.0, 3.0}, glm::dvec3(0.0)));
  EXPECT_LT(apart_mm(s.pose(), {1.0, 2.0, -297.0}), 1e-6);
}

TEST(TrackedProbe, APosesTimeIsWhenItWasMeasured) {
  Simulation s;
  s.deviceMinusSteady_s = 0.0;  // a camera that stamps by this computer's clock
  s.delay_s = 0.04;
  s.rest(2.0);
  EXPECT_NEAR(s.pose().time_s, s.scan_s() - 0.04, 1e-6);
  EXPECT_NEAR(s.probe.report(s.scan_s()).delay_s, 0.04, 1e-6);
  EXPECT_NEAR(s.probe.report(s.scan_s()).predicted_s, s.period_s, 1e-3) << "never further than a period";
}

TEST(TrackedProbe, GivesReadingsToCalibrateWithAsTheyWereReadAndWhatStateTheyAreIn) {
  Simulation s({.tool = "Probe", .reference = "Body"});
  EXPECT_FALSE(s.probe.reading(s.scan_s()).has_value());
  s.steady_s += s.period_s;
  s.say("Body", faceAt({0.0, 0.0, 100.0}, glm::dvec3(0.0)));
  s.say("Probe", faceAt({0.0, 5.0, 130.0}, glm::dvec3(0.0)));
  const auto read = s.probe.reading(s.scan_s());
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(glm::dvec3(read->toolToTracker.matrix[3]), glm::dvec3(0.0, 5.0, 30.0)) << "in the reference";
  EXPECT_EQ(read->state, TrackingState::live);
  s.steady_s += 2.0;
  EXPECT_EQ(s.probe.reading(s.scan_s())->state, TrackingState::stale);
}

TEST(TrackedProbe, LivesThroughEightHoursOfDropOutsRestartsAndJumps) {
  Simulation s;
  s.period_s = 1.0 / 60;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::map<TrackingState, int> seen;
  TrackingState before = TrackingState::off;
  int backs = 0;
  double until_s = 0.0;  // a fault goes on until then
  int fault = 0;
  const double end_s = s.steady_s + 8.0 * 3600.0;
  double shown_s = 0.0, worst_mm = 0.0;
  while (s.steady_s < end_s) {
    if (s.steady_s >= until_s) {
      if (fault == 4) s.tracker->link(LinkState::connected);
      fault = 0;
      if (share(random) < 1.0 / (60.0 * 20.0)) {
        fault = 1 + static_cast<int>(6.0 * share(random));
        until_s = s.steady_s + 0.05 + 4.0 * share(random);
        if (fault == 4) s.tracker->link(LinkState::connecting);
        if (fault == 5) s.deviceMinusSteady_s += 1000.0 * (share(random) - 0.5);
      }
    }
    const FacePose truth = onPath(HandPath::sweeps, std::fmod(s.steady_s, 20.0));
    if (fault == 0 || fault == 5) s.tick(truth);
    if (fault == 1 || fault == 4) s.steady_s += s.period_s;
    if (fault == 2) s.tick(truth, TrackingState::outOfView);
    if (fault == 3) s.tick(truth, TrackingState::invalid);
    if (fault == 6) {
      s.steady_s += s.period_s;
      s.tracker->say(readingOf("Probe", truth, 3.0, s.steady_s));
    }
    if (s.steady_s < shown_s) continue;
    shown_s = s.steady_s + 0.2;
    const Pose pose = s.pose();
    const TrackingState now = s.state();
    if (now != before) ++seen[now];
    if (now == TrackingState::live && before != TrackingState::live) ++backs;
    before = now;
    if (pose.status == PoseStatus::ok && fault == 0) worst_mm = std::max(worst_mm, apart_mm(pose, glm::dvec3(truth.matrix[3])));
  }
  for (const TrackingState state : {TrackingState::live, TrackingState::stale, TrackingState::outOfView, TrackingState::invalid,
                                    TrackingState::duplicate, TrackingState::lost})
    EXPECT_GT(seen[state], 20) << stateWord(state);
  EXPECT_GT(backs, 500);
  EXPECT_LT(worst_mm, 12.0) << "a path of at most 95 mm/s, measured with 0.2 mm";
}

TEST(TrackedProbe, IsReadFromSeveralThreadsAtOnce) {
  Simulation s;
  std::atomic<bool> ends = false;
  std::vector<std::thread> readers;
  for (int n = 0; n < 3; ++n)
    readers.emplace_back([&s, &ends] {
      while (!ends) {
        static_cast<void>(s.probe.poseAt(1000.0));
        static_cast<void>(s.probe.report(1000.0));
        static_cast<void>(s.probe.reading(1000.0));
      }
    });
  for (int n = 0; n < 3000; ++n) {
    s.tick(onPath(HandPath::sweeps, n / 30.0));
    if (n % 500 == 0) s.probe.setOptions({.tool = "Probe", .filter = n % 1000 == 0 ? FilterKind::oneEuro : FilterKind::kalman});
  }
  ends = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(s.state(), TrackingState::live);
}

TEST(TrackingWords, EveryStateHasAWordAndASentenceOfItsOwn) {
  std::set<std::string> words, sentences;
  for (int n = 0; n <= static_cast<int>(TrackingState::off); ++n) {
    const auto state = static_cast<TrackingState>(n);
    EXPECT_TRUE(words.insert(stateWord(state).english()).second);
    for (const char* tool : {"", "Probe"}) {
      const std::string sentence = stateSentence(state, tool).english();
      EXPECT_TRUE(sentence.ends_with(".")) << sentence;
      sentences.insert(sentence);
    }
  }
  EXPECT_EQ(sentences.size(), 14u) << "lost and off do not name the tool";
}

}  // namespace ew::tracked_probe_test
