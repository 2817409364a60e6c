#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "ew/tracking/pose_filter.h"
#include "hand_paths.h"

namespace ew::filter_test {
namespace {

using test::apart_mm;
using test::apart_rad;
using test::faceAt;
using test::FacePose;
using test::HandPath;
using test::onPath;
using test::PoseNoise;

/// Root mean square and largest error of a filter against the truth, asked at each reading and between it and the next.
struct PathErrors {
  double rms_mm = 0.0, rms_rad = 0.0, worst_mm = 0.0, worst_rad = 0.0;
  PoseFilterReport report;
};

PathErrors errorsOn(HandPath path, FilterKind kind, double rate_hz, double noise_mm, double noise_rad, bool predict = true) {
  PoseFilter filter({.kind = kind, .predict = predict});
  PoseNoise noise(noise_mm, noise_rad, 5);
  PathErrors errors;
  int count = 0;
  for (int n = 0; n < static_cast<int>(20.0 * rate_hz); ++n) {
    const double time_s = n / rate_hz;
    filter.add(time_s, noise.on(onPath(path, time_s)));
    if (time_s < 3.0) continue;
    for (const double asked_s : {time_s, time_s + 0.7 / rate_hz}) {
      const double off_mm = apart_mm(filter.at(asked_s), onPath(path, asked_s));
      const double off_rad = apart_rad(filter.at(asked_s), onPath(path, asked_s));
      errors.rms_mm += off_mm * off_mm;
      errors.rms_rad += off_rad * off_rad;
      errors.worst_mm = std::max(errors.worst_mm, off_mm);
      errors.worst_rad = std::max(errors.worst_rad, off_rad);
      ++count;
    }
  }
  errors.rms_mm = std::sqrt(errors.rms_mm / count);
  errors.rms_rad = std::sqrt(errors.rms_rad / count);
  errors.report = filter.report();
  return errors;
}

constexpr std::pair<HandPath, const char*> kPaths[] = {{HandPath::fixed, "fixed"},   {HandPath::rests, "hand rests"},
                                                       {HandPath::sweeps, "sweeps"}, {HandPath::startsAndStops, "starts, stops"},
                                                       {HandPath::fans, "fans"},     {HandPath::turnsQuickly, "turns quickly"}};

bool isRotation(const FacePose& pose) { return checkRigid(pose, 1e-9).has_value(); }

}  // namespace

// The figures of resources/docs/technician/trackers.md: EW_FIGURES=1 prints the table.
TEST(PoseFilter, KalmanIsTheBestOrNearlySoOnEveryPathOfAHandThatIsReadWithNoise) {
  for (const double noise_mm : {0.5, 0.15}) {
    for (const double rate_hz : {30.0, 60.0, 100.0}) {
      for (const auto& [path, name] : kPaths) {
        const auto plain = errorsOn(path, FilterKind::none, rate_hz, noise_mm, 0.01 * noise_mm);
        const auto euro = errorsOn(path, FilterKind::oneEuro, rate_hz, noise_mm, 0.01 * noise_mm);
        const auto kalman = errorsOn(path, FilterKind::kalman, rate_hz, noise_mm, 0.01 * noise_mm);
        if (std::getenv("EW_FIGURES") != nullptr)
          std::printf("%.2f mm %3.0f Hz %-14s none %.2f mm %.2f deg | One Euro %.2f mm %.2f deg | Kalman %.2f mm %.2f deg\n", noise_mm,
                      rate_hz, name, plain.rms_mm, 57.3 * plain.rms_rad, euro.rms_mm, 57.3 * euro.rms_rad, kalman.rms_mm,
                      57.3 * kalman.rms_rad);
        EXPECT_LT(kalman.rms_mm, 1.4 * euro.rms_mm) << name << " at " << rate_hz;
        const bool isStill = path == HandPath::fixed || path == HandPath::rests;
        EXPECT_LT(kalman.rms_mm, (isStill ? 0.85 : 1.12) * plain.rms_mm) << name << " at " << rate_hz;
      }
    }
  }
}

TEST(PoseFilter, KalmanTakesAwayTwoThirdsOfTheJitterOfAProbeThatRests) {
  const auto plain = errorsOn(HandPath::fixed, FilterKind::none, 60.0, 0.5, 0.005);
  const auto kalman = errorsOn(HandPath::fixed, FilterKind::kalman, 60.0, 0.5, 0.005);
  EXPECT_LT(kalman.rms_mm, plain.rms_mm / 3.0);
  EXPECT_LT(kalman.rms_rad, plain.rms_rad / 2.5);
}

TEST(PoseFilter, KalmanFollowsASteadySlideWithoutDelayAndOneEuroWithTheDelayItReports) {
  const double speed_mmPerS = 80.0;
  PoseFilter kalman({.kind = FilterKind::kalman, .predict = false}), euro({.kind = FilterKind::oneEuro, .predict = false});
  for (int n = 0; n <= 300; ++n) {
    const FacePose truth = faceAt({speed_mmPerS * n / 60.0, 0.0, 0.0}, glm::dvec3(0.0));
    kalman.add(n / 60.0, truth);
    euro.add(n / 60.0, truth);
  }
  const FacePose truth = faceAt({speed_mmPerS * 5.0, 0.0, 0.0}, glm::dvec3(0.0));
  EXPECT_LT(apart_mm(kalman.at(5.0), truth), 0.01);
  EXPECT_EQ(kalman.report().delay_s, 0.0);
  EXPECT_GT(euro.report().delay_s, 0.004);
  EXPECT_NEAR(apart_mm(euro.at(5.0), truth) / speed_mmPerS, euro.report().delay_s, 5e-4);
}

TEST(PoseFilter, MeasuresTheNoiseOfReadingsWhetherTheProbeRestsOrMoves) {
  for (const HandPath path : {HandPath::fixed, HandPath::rests, HandPath::sweeps, HandPath::startsAndStops}) {
    const auto found = errorsOn(path, FilterKind::automatic, 60.0, 0.4, 0.003).report;
    EXPECT_NEAR(found.noise_mm, 0.4, 0.08);
    EXPECT_NEAR(found.noise_rad, 0.003, 0.0007);
    EXPECT_NEAR(found.period_s, 1.0 / 60, 1e-9);
    EXPECT_EQ(found.used, FilterKind::kalman);
    EXPECT_LT(found.left_mm, 0.4);
  }
}

TEST(PoseFilter, LeavesAQuietTrackerAsItIs) {
  const auto found = errorsOn(HandPath::sweeps, FilterKind::automatic, 60.0, 0.02, 0.0002);
  EXPECT_EQ(found.report.used, FilterKind::none);
  EXPECT_EQ(found.report.delay_s, 0.0);
  EXPECT_LT(found.rms_mm, 0.2) << "a fraction of a period ahead";
}

TEST(PoseFilter, CarriesAPoseAheadByAtMostOnePeriod) {
  for (const FilterKind kind : {FilterKind::none, FilterKind::kalman, FilterKind::oneEuro}) {
    PoseFilter filter({.kind = kind});
    for (int n = 0; n <= 120; ++n) filter.add(n / 60.0, faceAt({120.0 * n / 60.0, 0.0, 0.0}, {0.0, 0.0, 0.5 * n / 60.0}));
    EXPECT_NEAR(apart_mm(filter.at(2.0 + 1.0 / 60), filter.at(2.0)), 2.0, 0.05);
    EXPECT_NEAR(apart_rad(filter.at(2.0 + 1.0 / 60), filter.at(2.0)), 0.5 / 60, 5e-4);
    EXPECT_LT(apart_mm(filter.at(2.1), filter.at(2.0 + 1.0 / 60)), 1e-6);
    EXPECT_EQ(filter.at(1e6), filter.at(2.1));
    EXPECT_NEAR(filter.ahead_s(1e6), 1.0 / 60, 1e-9);
    filter.setOptions({.kind = kind, .predict = false});
    EXPECT_EQ(filter.at(1e6), filter.at(2.0));
  }
}

TEST(PoseFilter, BeginsAnewAfterAGapWithoutASpeedFromBefore) {
  PoseFilter filter({.kind = FilterKind::kalman});
  for (int n = 0; n <= 60; ++n) filter.add(n / 60.0, faceAt({300.0 * n / 60.0, 0.0, 0.0}, {0.0, 3.0 * n / 60.0, 0.0}));
  const FacePose elsewhere = faceAt({-50.0, 20.0, 0.0}, {0.3, 0.0, 0.0});
  EXPECT_EQ(filter.add(3.0, elsewhere), PoseFilter::Taken::used);
  EXPECT_EQ(filter.report().beginnings, 2u);
  EXPECT_LT(apart_mm(filter.at(3.0), elsewhere), 1e-9);
  EXPECT_LT(apart_mm(filter.at(3.02), elsewhere), 1e-9);
  filter.add(3.0 + 1.0 / 60, elsewhere);
  EXPECT_LT(apart_mm(filter.at(3.05), elsewhere), 1e-6);
}

TEST(PoseFilter, DoesNotShowASingleReadingThatIsElsewhereAndFollowsOnesThatStay) {
  for (const FilterKind kind : {FilterKind::none, FilterKind::kalman, FilterKind::oneEuro}) {
    PoseFilter filter({.kind = kind});
    PoseNoise noise(0.2, 0.002, 3);
    const FacePose here = faceAt({0.0, 0.0, 400.0}, {0.1, 0.0, 0.0}), flipped = faceAt({0.0, 0.0, 400.0}, {1.3, 0.0, 0.0});
    for (int n = 0; n < 100; ++n) filter.add(n / 60.0, noise.on(here));
    EXPECT_EQ(filter.add(100 / 60.0, flipped), PoseFilter::Taken::heldBack);
    EXPECT_LT(apart_rad(filter.at(100 / 60.0), here), 0.03);
    EXPECT_EQ(filter.add(101 / 60.0, noise.on(here)), PoseFilter::Taken::used);
    EXPECT_EQ(filter.report().outliers, 1u);
    EXPECT_EQ(filter.add(102 / 60.0, flipped), PoseFilter::Taken::heldBack);
    EXPECT_EQ(filter.add(103 / 60.0, flipped), PoseFilter::Taken::used) << "two that agree are no mistake";
    EXPECT_LT(apart_rad(filter.at(103 / 60.0), flipped), 1e-9);
  }
}

TEST(PoseFilter, InterpolatesBetweenTheReadingsOfTheLastHalfSecond) {
  PoseFilter filter({.kind = FilterKind::none});
  for (int n = 0; n <= 60; ++n) filter.add(n / 60.0, faceAt({1.0 * n, 0.0, 0.0}, {0.0, 0.0, 0.01 * n}));
  EXPECT_LT(apart_mm(filter.at(50.25 / 60), faceAt({50.25, 0.0, 0.0}, glm::dvec3(0.0))), 1e-9);
  EXPECT_LT(apart_rad(filter.at(50.25 / 60), faceAt(glm::dvec3(0.0), {0.0, 0.0, 0.5025})), 1e-9);
  EXPECT_LT(apart_mm(filter.at(-9.0), faceAt({30.0, 0.0, 0.0}, glm::dvec3(0.0))), 1.0 + 1e-9) << "before them, the first of these";
}

TEST(PoseFilter, RefusesWhatIsNoPoseAndWhatIsOlder) {
  PoseFilter filter;
  const double none = std::numeric_limits<double>::quiet_NaN();
  FacePose broken;
  broken.matrix[1][2] = none;
  EXPECT_EQ(filter.add(0.0, broken), PoseFilter::Taken::refused);
  EXPECT_EQ(filter.add(none, FacePose{}), PoseFilter::Taken::refused);
  EXPECT_TRUE(filter.empty());
  EXPECT_EQ(filter.add(1.0, FacePose{}), PoseFilter::Taken::used);
  EXPECT_EQ(filter.add(0.9, FacePose{}), PoseFilter::Taken::refused);
  FacePose far;
  far.matrix[3].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(filter.add(1.1, far), PoseFilter::Taken::refused);
  EXPECT_EQ(filter.latest_s(), 1.0);
  EXPECT_EQ(filter.at(1.0), FacePose{});
}

TEST(PoseFilter, TwoReadingsOfOneMomentAreTwoMeasurementsOfIt) {
  PoseFilter filter({.kind = FilterKind::kalman, .predict = false});
  for (int n = 0; n < 200; ++n) {
    EXPECT_EQ(filter.add(n / 100.0, faceAt({0.2, 0.0, 0.0}, glm::dvec3(0.0))), PoseFilter::Taken::used);
    EXPECT_EQ(filter.add(n / 100.0, faceAt({-0.2, 0.0, 0.0}, glm::dvec3(0.0))), PoseFilter::Taken::used);
  }
  EXPECT_LT(apart_mm(filter.at(9.0), FacePose{}), 0.1);
}

TEST(PoseFilter, StaysARotationThroughHalfTurnsMicrosecondsAndAMillionReadings) {
  for (const FilterKind kind : {FilterKind::none, FilterKind::kalman, FilterKind::oneEuro}) {
    PoseFilter filter({.kind = kind});
    PoseNoise noise(0.3, 0.003, 9);
    double time_s = 1e6;
    for (int n = 0; n < 350'000; ++n) {
      // Half turns about changing axes between neighbours, the same moment again, a microsecond and a long way to the next.
      const double pi = 3.141592653589793;
      const glm::dvec3 turn = n % 50 == 0 ? pi * glm::normalize(noise.any()) : glm::dvec3(0.0, 0.0, 0.001 * (n % 3000));
      filter.add(time_s, noise.on(faceAt({0.01 * (n % 1000), 0.0, 500.0}, turn)));
      const double steps_s[] = {0.001, 0.0, 1e-6, 0.01, 0.02, n % 1000 == 0 ? 5.0 : 0.004, 1e-9};
      time_s += steps_s[n % 7];
      if (n % 101 != 0) continue;
      for (const double ahead_s : {-0.01, 0.0, 0.005, 1.0}) {
        const FacePose pose = filter.at(time_s + ahead_s);
        ASSERT_TRUE(isRotation(pose)) << n;
        ASSERT_LT(glm::distance(glm::dvec3(pose.matrix[3]), glm::dvec3(5.0, 0.0, 500.0)), 60.0) << n;
      }
    }
    const auto report = filter.report();
    EXPECT_TRUE(std::isfinite(report.noise_mm + report.noise_rad + report.left_mm + report.left_rad + report.delay_s));
  }
}

RC_GTEST_PROP(PoseFilter, NeverRunsAwayFromWhatWasReadWhateverTheTimesAre, ()) {
  const auto kind = *rc::gen::element(FilterKind::automatic, FilterKind::none, FilterKind::kalman, FilterKind::oneEuro);
  PoseFilter filter({.kind = kind});
  PoseNoise noise(1.0, 0.01, *rc::gen::arbitrary<unsigned>());
  double time_s = 0.0;
  for (int n = 0; n < 200; ++n) {
    time_s += *rc::gen::element(0.0, 1e-9, 1e-6, 1e-3, 0.01, 0.033, 0.1, 0.3, 100.0);
    filter.add(time_s, noise.on(faceAt(glm::dvec3(10.0, 20.0, 30.0), glm::dvec3(0.2, 0.1, 0.0))));
    const FacePose pose = filter.at(time_s + *rc::gen::element(0.0, 1e-6, 0.01, 1.0, 1e9));
    RC_ASSERT(isRotation(pose));
    // Noise of a millimetre along each axis, and at worst a hand's highest speed for the longest prediction.
    RC_ASSERT(glm::distance(glm::dvec3(pose.matrix[3]), glm::dvec3(10.0, 20.0, 30.0)) < 6.0 + 1500.0 * 0.05);
  }
}

}  // namespace ew::filter_test
