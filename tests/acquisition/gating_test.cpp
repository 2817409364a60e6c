#include "ew/acquisition/gating.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "acquisition/pulse.h"
#include "ew/core/numbers.h"
#include "ew/io/gating_fields.h"

namespace ew::gating_test {
namespace {

using pulse::beats;
using pulse::ecg;
using pulse::Tube;

/// The largest distance of a true beat to the nearest found one, and the other way round.
double worst_s(const std::vector<double>& truth_s, const std::vector<double>& found_s) {
  const auto furthest = [](const std::vector<double>& from, const std::vector<double>& to) {
    double worst = 0.0;
    for (const double a : from) {
      double nearest = 1e9;
      for (const double b : to) nearest = std::min(nearest, std::abs(a - b));
      worst = std::max(worst, nearest);
    }
    return worst;
  };
  return std::max(furthest(truth_s, found_s), furthest(found_s, truth_s));
}

void addNoise(BodySignal& signal, double spread, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, spread);
  for (double& value : signal.value) value += noise(random);
}

TEST(HeartBeats, EveryRPeakOfACleanEcgIsFoundToTwoMilliseconds) {
  for (const double rate_hz : {100.0, 250.0, 360.0, 1000.0}) {
    const auto truth_s = beats(30.0, 0.85, 0.08, 3);
    const auto found = findHeartBeats(ecg(truth_s, 30.0, rate_hz));
    ASSERT_TRUE(found.has_value()) << found.error();
    EXPECT_EQ(found->starts_s.size(), truth_s.size());
    EXPECT_LT(worst_s(truth_s, found->starts_s), 0.002) << rate_hz;
    EXPECT_NEAR(found->rate_perMin, 60.0 / 0.85, 3.0);
    EXPECT_GT(found->confidence, 0.95);
    EXPECT_EQ(found->irregular, 0u);
    EXPECT_FALSE(found->inverted);
  }
}

TEST(HeartBeats, NoiseDriftMainsAndAnInvertedElectrodeAreLivedWith) {
  const auto truth_s = beats(40.0, 0.9, 0.05, 11);
  for (const double sign : {1.0, -1.0}) {
    BodySignal signal = ecg(truth_s, 40.0, 250.0);
    for (std::size_t n = 0; n < signal.value.size(); ++n) {
      const double t = signal.time_s[n];
      signal.value[n] = sign * signal.value[n] + 1.5 * std::sin(2.0 * std::numbers::pi * 0.25 * t) + 0.2 * t +
                        0.15 * std::sin(2.0 * std::numbers::pi * 50.0 * t);
    }
    addNoise(signal, 0.15, 5);
    const auto found = findHeartBeats(signal);
    ASSERT_TRUE(found.has_value()) << found.error();
    EXPECT_EQ(found->starts_s.size(), truth_s.size());
    EXPECT_LT(worst_s(truth_s, found->starts_s), 0.02);
    EXPECT_EQ(found->inverted, sign < 0.0);
  }
}

TEST(HeartBeats, OneArtefactTenTimesAsHighAsABeatHidesNoOther) {
  const auto truth_s = beats(20.0, 0.8, 0.03, 2);
  BodySignal signal = ecg(truth_s, 20.0, 250.0);
  for (std::size_t n = 0; n < signal.value.size(); ++n) signal.value[n] += 10.0 * pulse::bell(signal.time_s[n] - 6.37, 0.02);
  const auto found = findHeartBeats(signal);
  ASSERT_TRUE(found.has_value()) << found.error();
  for (const double beat_s : truth_s) {
    if (std::abs(beat_s - 6.37) < 0.3) continue;
    const bool there = std::any_of(found->starts_s.begin(), found->starts_s.end(), [&](double s) { return std::abs(s - beat_s) < 0.02; });
    EXPECT_TRUE(there) << beat_s;
  }
}

TEST(HeartBeats, AMissedBeatIsBridgedAndAnExtraOneMakesItsCyclesIrregular) {
  auto truth_s = beats(20.0, 0.8, 0.02, 7);
  auto gappy_s = truth_s;
  gappy_s.erase(gappy_s.begin() + 10);
  const auto bridged = findHeartBeats(ecg(gappy_s, 20.0, 250.0));
  ASSERT_TRUE(bridged.has_value()) << bridged.error();
  EXPECT_EQ(bridged->bridged, 1u);
  EXPECT_EQ(bridged->starts_s.size(), truth_s.size());
  EXPECT_LT(worst_s(truth_s, bridged->starts_s), 0.03);
  EcgOptions strict;
  strict.bridgeMissedBeats = false;
  const auto open = findHeartBeats(ecg(gappy_s, 20.0, 250.0), strict);
  ASSERT_TRUE(open.has_value());
  EXPECT_EQ(open->irregular, 1u);
  EXPECT_FALSE(open->regular[9]);

  truth_s.insert(truth_s.begin() + 11, truth_s[10] + 0.45 * (truth_s[11] - truth_s[10]));
  const auto extra = findHeartBeats(ecg(truth_s, 20.0, 250.0));
  ASSERT_TRUE(extra.has_value()) << extra.error();
  EXPECT_EQ(extra->irregular, 2u);
  EXPECT_FALSE(extra->regular[10] || extra->regular[11]);
}

RC_GTEST_PROP(HeartBeats, DoNotDependOnScaleSignOffsetOrTheClocksZero, ()) {
  const auto length_s = static_cast<double>(*rc::gen::inRange(35, 140)) / 100.0;
  const auto scale = std::pow(10.0, static_cast<double>(*rc::gen::inRange(-3, 4)));
  const auto offset = static_cast<double>(*rc::gen::inRange(-50, 50));
  const auto zero_s = static_cast<double>(*rc::gen::inRange(0, 1000000));
  const double sign = *rc::gen::arbitrary<bool>() ? 1.0 : -1.0;
  const auto truth_s = beats(15.0, length_s, 0.05, 4);
  BodySignal signal = ecg(truth_s, 15.0, 250.0);
  for (double& value : signal.value) value = sign * scale * value + offset * scale;
  for (double& t : signal.time_s) t += zero_s;
  const auto found = findHeartBeats(signal);
  RC_ASSERT(found.has_value());
  auto shifted_s = truth_s;
  for (double& t : shifted_s) t += zero_s;
  RC_ASSERT(found->starts_s.size() == shifted_s.size());
  RC_ASSERT(worst_s(shifted_s, found->starts_s) < 0.004);
  RC_ASSERT(found->inverted == (sign < 0.0));
}

TEST(Breaths, BeginAtFullInspirationWhateverTheDrift) {
  BodySignal signal;
  std::vector<double> truth_s;
  for (double t = 2.0; t < 60.0; t += 4.0) truth_s.push_back(t);
  for (int n = 0; n < 600; ++n) {
    const double t = 0.1 * n;
    signal.time_s.push_back(t);
    signal.value.push_back(std::pow(std::sin(std::numbers::pi * t / 4.0), 4.0) + 0.05 * t);
  }
  addNoise(signal, 0.05, 3);
  const auto found = findBreaths(signal);
  ASSERT_TRUE(found.has_value()) << found.error();
  EXPECT_EQ(found->starts_s.size(), truth_s.size());
  EXPECT_LT(worst_s(truth_s, found->starts_s), 0.15);
  EXPECT_NEAR(found->rate_perMin, 15.0, 0.4);
  EXPECT_GT(found->confidence, 0.7);
  for (double& value : signal.value) value = -value;
  BreathOptions options;
  options.fallsWithInspiration = true;
  const auto turned = findBreaths(signal, options);
  ASSERT_TRUE(turned.has_value());
  EXPECT_EQ(turned->starts_s, found->starts_s);
}

TEST(FramePhases, SayWhereInItsCycleAFrameLies) {
  Cycles cycles;
  cycles.starts_s = {1.0, 2.0, 4.0, 5.0};
  cycles.regular = {true, false, true};
  const std::vector<double> times_s{0.5, 1.0, 1.75, 3.0, 4.5, 5.0, std::nan("")};
  const auto phases = phasesOf(cycles, times_s);
  EXPECT_EQ(phases[0].verdict, FrameVerdict::outside);
  EXPECT_EQ(phases[1], (FramePhase{0.0, 0, FrameVerdict::accepted}));
  EXPECT_EQ(phases[2], (FramePhase{0.75, 0, FrameVerdict::accepted}));
  EXPECT_EQ(phases[3], (FramePhase{0.5, 1, FrameVerdict::irregular}));
  EXPECT_EQ(phases[4], (FramePhase{0.5, 2, FrameVerdict::accepted}));
  EXPECT_EQ(phases[5].verdict, FrameVerdict::outside);
  EXPECT_EQ(phases[6].verdict, FrameVerdict::noTime);
  const auto lists = framesOfPhase(phases, 2);
  ASSERT_TRUE(lists.has_value());
  EXPECT_EQ(*lists, (std::vector<std::vector<std::size_t>>{{1}, {2, 4}}));
}

TEST(RecordedSignal, IsReadFromTheFramesFieldsOneOrSeveralAFrame) {
  Sequence sequence;
  for (int n = 0; n < 3; ++n) {
    SequenceFrame frame;
    frame.time_s = 10.0 + 0.1 * n;
    frame.otherFields = {{std::string(fields::kEcg), n == 1 ? "1 2" : textOf(n)}};
    sequence.frames.push_back(frame);
  }
  const auto signal = recordedSignal(sequence, fields::kEcg);
  ASSERT_TRUE(signal.has_value()) << signal.error();
  EXPECT_EQ(signal->value, (std::vector<double>{0, 1, 2, 2}));
  EXPECT_NEAR(signal->time_s[1], 10.05, 1e-12);
  EXPECT_NEAR(signal->time_s[2], 10.1, 1e-12);
  EXPECT_FALSE(recordedSignal(sequence, fields::kRespiration).has_value());
  sequence.frames[2].otherFields[0].second = "high";
  EXPECT_EQ(recordedSignal(sequence, fields::kEcg).error().code, ErrorCode::badField);
}

struct Seen {
  sweeps::Sweep sweep;
  std::vector<ImageView<const std::uint8_t>> images;
  std::vector<double> times_s;
};

Seen seen(const Tube& tube, int frames) {
  Seen all{pulse::imaged(tube, frames), {}, {}};
  for (int n = 0; n < frames; ++n) {
    all.images.push_back(all.sweep.frames[static_cast<std::size_t>(n)].pixels);
    all.times_s.push_back(n / tube.fps);
  }
  return all;
}

/// Spread (share of a cycle) of found against true phase about the mean difference, over accepted frames.
double phaseSpread(const std::vector<FramePhase>& phases, const Tube& tube, const std::vector<double>& times_s) {
  glm::dvec2 sum(0.0);
  int count = 0;
  for (std::size_t n = 0; n < phases.size(); ++n) {
    if (phases[n].verdict != FrameVerdict::accepted) continue;
    const double angle_rad = 2.0 * std::numbers::pi * (phases[n].phase - tube.phaseAt(times_s[n]));
    sum += glm::dvec2(std::cos(angle_rad), std::sin(angle_rad));
    ++count;
  }
  return std::sqrt(-2.0 * std::log(glm::length(sum) / count)) / (2.0 * std::numbers::pi);
}

TEST(ImageGating, FollowsAPulseWhileTheProbeMovesOn) {
  for (const double speed_mmPerS : {0.0, 2.0, 5.0}) {
    Tube tube;
    tube.pixel_mm = 1.0;
    tube.speed_mmPerS = speed_mmPerS;
    const Seen all = seen(tube, 250);
    const auto cycles = findCyclesInImages(all.images, all.times_s, {}, noProgress());
    ASSERT_TRUE(cycles.has_value()) << speed_mmPerS << ": " << cycles.error();
    EXPECT_NEAR(cycles->rate_perMin, 75.0, 2.0) << speed_mmPerS;
    const auto phases = phasesOf(*cycles, all.times_s);
    EXPECT_LT(phaseSpread(phases, tube, all.times_s), 0.05) << speed_mmPerS;
    const auto accepted = std::count_if(phases.begin(), phases.end(), [](const auto& p) { return p.verdict == FrameVerdict::accepted; });
    EXPECT_GT(accepted, 200) << speed_mmPerS;
  }
}

TEST(ImageGating, RefusesATubeThatDoesNotPulsate) {
  for (const double speed_mmPerS : {1.0, 3.0, 10.0}) {
    Tube tube;
    tube.pixel_mm = 1.0;
    tube.pulsates = false;
    tube.speed_mmPerS = speed_mmPerS;
    const Seen all = seen(tube, 250);
    const auto cycles = findCyclesInImages(all.images, all.times_s, {}, noProgress());
    ASSERT_FALSE(cycles.has_value()) << speed_mmPerS << " mm/s: " << cycles->rate_perMin << " with " << cycles->confidence;
    EXPECT_EQ(cycles.error().code, ErrorCode::unsupported);
  }
}

TEST(ImageGating, DoesNotDependOnTheNumberOfThreads) {
  Tube tube;
  tube.pixel_mm = 1.0;
  const Seen all = seen(tube, 160);
  ImageGateOptions options;
  std::vector<std::vector<double>> starts;
  for (const int threads : {1, 2, 8}) {
    options.threads = threads;
    const auto cycles = findCyclesInImages(all.images, all.times_s, options, noProgress());
    ASSERT_TRUE(cycles.has_value()) << cycles.error();
    starts.push_back(cycles->starts_s);
  }
  EXPECT_EQ(starts[0], starts[1]);
  EXPECT_EQ(starts[0], starts[2]);
}

TEST(PhaseVolumes, KeepTheDiameterOfABeatingTubeWhereUngatedOnesLoseIt) {
  Tube tube;
  tube.speed_mmPerS = 1.5;
  const Seen all = seen(tube, 400);
  std::vector<double> rPeaks_s;
  for (double t = 0.0; t < 17.0; t += tube.length_s) rPeaks_s.push_back(t);
  const auto byEcg = findHeartBeats(ecg(rPeaks_s, 16.0, 250.0));
  ASSERT_TRUE(byEcg.has_value()) << byEcg.error();
  constexpr int kPhases = 5;
  const auto lists = framesOfPhase(phasesOf(*byEcg, all.times_s), kPhases);
  ASSERT_TRUE(lists.has_value()) << lists.error();
  const ReconstructOptions options{.spacing_mm = 0.5, .fillReach_mm = 3.0};
  std::vector<double> diameters_mm;
  std::vector<Grid> grids;
  const auto grid = reconstructPhases(
      all.sweep.frames, *lists, options,
      [&](std::size_t, ReconstructResult made) -> Result<void> {
        diameters_mm.push_back(pulse::diameterIn(made.volume));
        grids.push_back(made.volume.grid);
        return {};
      },
      noProgress());
  ASSERT_TRUE(grid.has_value()) << grid.error();
  ASSERT_EQ(diameters_mm.size(), 5u);
  const auto ungated = reconstruct(all.sweep.frames, options, noProgress());
  ASSERT_TRUE(ungated.has_value());
  const double blurred_mm = pulse::diameterIn(ungated->volume);
  double worstUngated_mm = 0.0;
  for (std::size_t k = 0; k < kPhases; ++k) {
    EXPECT_EQ(grids[k], *grid);
    double truth_mm = 0.0;
    for (const std::size_t n : (*lists)[k])
      truth_mm += 2.0 * tube.radiusAt(tube.phaseAt(all.times_s[n])) / static_cast<double>((*lists)[k].size());
    EXPECT_NEAR(diameters_mm[k], truth_mm, 0.5) << "phase " << k;
    worstUngated_mm = std::max(worstUngated_mm, std::abs(blurred_mm - truth_mm));
  }
  EXPECT_GT(worstUngated_mm, 1.0);
}

}  // namespace
}  // namespace ew::gating_test
