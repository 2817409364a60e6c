#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "colour_support.h"
#include "ew/imaging/spectral_trace.h"
#include "spectrum/high_pass.h"

namespace ew::spectrum_test {
namespace {

using namespace ew::testing::colour;
using std::numbers::pi;
constexpr double kDepth_mm = TrialVessel{}.depth_mm;

Knobs spectralKnobs() {
  Knobs knobs;
  knobs.mode = DisplayMode::spectrum;
  knobs.mSweep_s = 2.0;
  SpectralDoppler spectral;
  spectral.depth_mm = kDepth_mm;
  spectral.carrier_hz = 5e6;
  spectral.prf_hz = 6000.0;
  spectral.gate_mm = 12.0;
  spectral.wallFilter_hz = 40.0;
  knobs.spectral = spectral;
  return knobs;
}

/// Runs frames of a shot for a while, as a window does.
struct Listening {
  ColourScan scan;
  explicit Listening(const Shot& shot, double seconds, double step_s = 0.04) : scan(shot) {
    scan.input().time_s = -0.05;
    for (int n = 0; n <= static_cast<int>(std::lround(seconds / step_s)); ++n) {
      scan.input().time_s = n * step_s - 0.05;  // next() adds it
      scan.next();
      const auto samples = scan.maker().dopplerSamples();
      all.insert(all.end(), samples.begin(), samples.end());
    }
  }
  [[nodiscard]] const Spectrogram& spectrogram() const { return *scan.maker().spectrogram(); }
  /// Mean power of all columns.
  [[nodiscard]] std::vector<float> mean() const {
    std::vector<double> sum(static_cast<std::size_t>(spectrogram().bins()));
    for (int column = 0; column < spectrogram().columns(); ++column) {
      const auto powers = spectrogram().powers(column);
      for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += static_cast<double>(powers[n]);
    }
    std::vector<float> mean;
    for (const double each : sum) mean.push_back(static_cast<float>(each / spectrogram().columns()));
    return mean;
  }
  std::vector<std::complex<float>> all;
};

Shot shotOf(const TrialVessel& vessel, double snr_db = 30.0) {
  Shot shot;
  shot.vessel = vessel;
  shot.vessel.tissueLevel = 0.0;
  shot.knobs = spectralKnobs();
  shot.scene = trialScene(snr_db);
  return shot;
}

double noiseOf(double snr_db) { return std::pow(10.0, 0.1 * (-78.0 - snr_db)); }

TEST(Spectrum, MakesASampleForEveryPulseHoweverFramesCome) {
  const Shot shot = shotOf({.angle_rad = 45.0 * pi / 180.0});
  const Listening fast(shot, 0.4, 0.02), slow(shot, 0.4, 0.04);
  const double prf_hz = spectralGateOf(shot.probe, shot.knobs).prf_hz;
  EXPECT_NEAR(static_cast<double>(fast.all.size()), 0.4 * prf_hz, 2.0);
  EXPECT_NEAR(static_cast<double>(slow.all.size()), 0.4 * prf_hz, 2.0);
  // The same pulses give the same, but for how velocities are held between frames: here nothing changes between them.
  double difference = 0.0, power = 0.0;
  for (std::size_t n = 0; n < 200; ++n) {
    difference += static_cast<double>(std::norm(fast.all[n] - slow.all[n]));
    power += static_cast<double>(std::norm(slow.all[n]));
  }
  EXPECT_LT(difference, 0.05 * power);
}

TEST(Spectrum, HasAParabolasGreatestVelocityWithinTwoPerCent) {
  for (const double angle_deg : {0.0, 45.0, 60.0}) {
    TrialVessel vessel{.angle_rad = angle_deg * pi / 180.0, .axis_mmPerS = 400.0};
    Shot shot = shotOf(vessel);
    // Transit would widen the slope on both sides alike; it is looked at on its own.
    shot.knobs.spectral->broadens = false;
    const Listening run(shot, 8.0);
    const SpectralGate gate = spectralGateOf(shot.probe, shot.knobs);
    const double truth = 400.0 * std::cos(angle_deg * pi / 180.0);
    const TracePoint found = traceOf(run.mean(), noiseOf(30.0), {});
    EXPECT_NEAR(found.forward * gate.nyquist_mmPerS, truth, 0.02 * truth) << angle_deg << " degrees";
    EXPECT_NEAR(found.backward, 0.0, 0.03) << angle_deg << " degrees";
  }
}

TEST(Spectrum, HasAPlugsVelocityWithinOneBin) {
  TrialVessel vessel{.angle_rad = 0.0 * pi / 180.0, .axis_mmPerS = 400.0, .bluntness = 80.0};
  Shot shot = shotOf(vessel);
  shot.knobs.spectral->gate_mm = 3.0;
  shot.knobs.spectral->broadens = false;
  const Listening run(shot, 6.0);
  const SpectralGate gate = spectralGateOf(shot.probe, shot.knobs);
  const double bin_mmPerS = 2.0 * gate.nyquist_mmPerS / run.spectrogram().window();
  const TracePoint found = traceOf(run.mean(), noiseOf(30.0), {});
  EXPECT_NEAR(found.forward * gate.nyquist_mmPerS, 400.0, bin_mmPerS);
  EXPECT_NEAR(found.mean * gate.nyquist_mmPerS, 400.0, bin_mmPerS);
}

TEST(Spectrum, IsAsWideAsTransitAndWindowMakeIt) {
  for (const double angle_deg : {45.0, 70.0}) {
    TrialVessel vessel{.angle_rad = angle_deg * pi / 180.0, .radius_mm = 4.0, .axis_mmPerS = 500.0, .bluntness = 80.0};
    Shot shot = shotOf(vessel);
    shot.knobs.spectral->gate_mm = 1.0;
    const Listening run(shot, 10.0);
    const SpectralGate gate = spectralGateOf(shot.probe, shot.knobs);
    const TrialCell cell = cellOf(vessel, trialKnobs(vessel), shot.scene);
    // Standard deviation in Hz: of a Gaussian beam by velocity over 2 pi sqrt(2) sigma; of Hann windows of N samples 0.577 prf / N for
    // the power of their transform.
    const double angle = angle_deg * pi / 180.0, across = 500.0 * std::sin(angle), along = 500.0 * std::cos(angle);
    const auto transit_hz = [](double velocity, double sigma_mm) { return velocity / (2.0 * pi * std::sqrt(2.0) * sigma_mm); };
    const double window_hz = 0.577 * gate.prf_hz / run.spectrogram().window();
    // A gate of 1 mm with ends of the pulse is a little longer than its pulse: what it adds is small and bounded by the pulse's own.
    const double least_hz = std::hypot(transit_hz(across, cell.lateral_mm), window_hz);
    const double most_hz = std::hypot(std::hypot(transit_hz(across, cell.lateral_mm), transit_hz(along, cell.axial_mm)), window_hz);
    const std::vector<float> mean = run.mean();
    const double noise = noiseOf(30.0), middle_hz = 2.0 * along * 5e6 / 1.54e6;
    double sum = 0.0, first = 0.0, second = 0.0;
    for (std::size_t n = 0; n < mean.size(); ++n) {
      const double hz = (static_cast<double>(n) / static_cast<double>(mean.size()) - 0.5) * gate.prf_hz;
      if (std::abs(hz - middle_hz) > 4.0 * most_hz) continue;
      const double power = static_cast<double>(mean[n]) - noise;
      sum += power;
      first += power * hz;
      second += power * hz * hz;
    }
    const double width_hz = std::sqrt(second / sum - first / sum * first / sum);
    EXPECT_NEAR(first / sum, middle_hz, 0.02 * middle_hz);
    EXPECT_GT(width_hz, 0.93 * least_hz) << angle_deg;
    EXPECT_LT(width_hz, 1.07 * most_hz) << angle_deg;
  }
}

TEST(Spectrum, WallFilterTakesOutWhatIsSlow) {
  detail::HighPass filter;
  const auto passed = [&](double hz) {
    filter.clear();
    filter.configure(100.0, 4000.0);
    double power = 0.0;
    for (int n = 0; n < 4000; ++n) {
      const auto out = filter.next(std::complex<float>(std::polar(1.0, 2.0 * pi * hz * n / 4000.0)));
      if (n >= 2000) power += static_cast<double>(std::norm(out)) / 2000.0;
    }
    return 10.0 * std::log10(power);
  };
  EXPECT_NEAR(passed(100.0), -6.0, 0.1);
  EXPECT_NEAR(passed(-100.0), -6.0, 0.1);
  EXPECT_NEAR(passed(1000.0), 0.0, 0.05);
  EXPECT_LT(passed(10.0), -70.0);
}

TEST(Spectrum, TurnsAroundAtTheScaleAndFollowsTheBaseline) {
  TrialVessel vessel{.angle_rad = 0.0 * pi / 180.0, .axis_mmPerS = 600.0, .bluntness = 80.0};  // 1.3 Nyquist velocities
  Shot shot = shotOf(vessel);
  const SpectralGate gate = spectralGateOf(shot.probe, shot.knobs);
  const double share = 600.0 / gate.nyquist_mmPerS;
  ASSERT_GT(share, 1.1);
  const TracePoint around = traceOf(Listening(shot, 3.0).mean(), noiseOf(30.0), {});
  EXPECT_NEAR(around.mean, share - 2.0, 0.03);
  const TracePoint moved = traceOf(Listening(shot, 3.0).mean(), noiseOf(30.0), {.baseline = 0.6});
  EXPECT_NEAR(moved.forward, share, 0.06);
}

TEST(Spectrum, FindsIndicesOfAPulse) {
  TrialVessel vessel{.angle_rad = 45.0 * pi / 180.0, .axis_mmPerS = 400.0};
  Shot shot = shotOf(vessel);
  shot.knobs.mSweep_s = 5.0;
  shot.knobs.spectral->prf_hz = 8000.0;
  FlowField field = fieldOf(vessel);
  field.rhythms.pulse = BodyRhythm{.period_s = 0.9};
  // A carotid's: from 0.3 to 1.6 of the mean.
  std::vector<double> wave;
  for (int n = 0; n < 64; ++n) {
    const double phase = n / 64.0, rise = phase < 0.12 ? phase / 0.12 : std::exp(-(phase - 0.12) / 0.25);
    wave.push_back(0.4 + 1.2 * rise);
  }
  field.streams[0].wave = waveThrough(wave, 14);
  field.streams[0].bluntness = 2.0;
  const FlowTruth truth(field);
  ColourScan scan(shot);
  const FlowSampler sampler(field);
  scan.input().flow = &sampler;
  std::vector<double> times_s, greatest;
  for (int n = 0; n < 110; ++n) {
    scan.next();
    const double time_s = scan.input().time_s;
    times_s.push_back(time_s);
    greatest.push_back(truth.sectionNear(0, {0.0, kDepth_mm, 0.0}, time_s)->forward_mmPerS);
  }
  const SpectralGate gate = spectralGateOf(shot.probe, shot.knobs);
  const double slice_mm = cellOf(vessel, trialKnobs(vessel), shot.scene).elevational_mm / std::sqrt(2.0);
  const auto points = tracedBy(*scan.maker().spectrogram(), {.noise = noiseOf(30.0), .radiusOverSlice = vessel.radius_mm / slice_mm});
  std::vector<double> at_s, envelope, mean;
  for (const TracePoint& point : points) {
    at_s.push_back(point.time_s);
    envelope.push_back(point.greatest() * gate.nyquist_mmPerS * std::sqrt(2.0));
    mean.push_back(point.sectionMean * gate.nyquist_mmPerS * std::sqrt(2.0));
  }
  const auto values = waveformOf(at_s, envelope, mean);
  ASSERT_TRUE(values);
  // Truth of a fine clock over one beat.
  std::vector<double> fine_s, fine, fineMean;
  for (double t = 0.0; t < 3.6; t += 0.004) {
    const auto section = truth.sectionNear(0, {0.0, kDepth_mm, 0.0}, t);
    fine_s.push_back(t);
    fine.push_back(section->forward_mmPerS);
    fineMean.push_back(section->mean_mmPerS);
  }
  const auto expected = waveformOf(fine_s, fine, fineMean);
  ASSERT_TRUE(expected);
  EXPECT_NEAR(values->resistiveIndex(), expected->resistiveIndex(), 0.03);
  EXPECT_NEAR(values->heartPeriod_s, 0.9, 0.02);
  EXPECT_NEAR(values->peakSystolic, expected->peakSystolic, 0.06 * expected->peakSystolic);
  EXPECT_NEAR(values->timeAverageMaximum, expected->timeAverageMaximum, 0.06 * expected->timeAverageMaximum);
  // Volume flow of a round vessel: the gate holds all of it.
  EXPECT_NEAR(values->timeAverageMean, expected->timeAverageMean, 0.10 * expected->timeAverageMean);
}

TEST(Waveform, HasTheIndicesOfTheTextbook) {
  const WaveformValues values{.peakSystolic = 80.0, .endDiastolic = 20.0, .least = 20.0, .timeAverageMaximum = 40.0};
  EXPECT_DOUBLE_EQ(values.resistiveIndex(), 0.75);
  EXPECT_DOUBLE_EQ(*values.systolicOverDiastolic(), 4.0);
  EXPECT_DOUBLE_EQ(*values.pulsatilityIndex(), 1.5);
  EXPECT_FALSE((WaveformValues{.peakSystolic = 80.0}.systolicOverDiastolic()));
  EXPECT_NEAR(angleUncertainty(pi / 3.0, 3.0 * pi / 180.0), 0.0907, 1e-4);
}

TEST(Waveform, IsNoneWithoutAPulse) {
  std::vector<double> times_s, envelope;
  for (int n = 0; n < 100; ++n) {
    times_s.push_back(0.01 * n);
    envelope.push_back(200.0 + n % 2);
  }
  EXPECT_FALSE(waveformOf(times_s, envelope, envelope));
}

TEST(SpectralGate, ListensAtOtherDepthsWithHighPulseRates) {
  const Probe probe = trialProbe();
  Knobs knobs = spectralKnobs();
  knobs.spectral->gate_mm = 2.0;
  knobs.spectral->prf_hz = 52000.0;
  EXPECT_NEAR(spectralGateOf(probe, knobs).prf_hz, 1.54e6 / 42.0, 1.0);
  EXPECT_TRUE(spectralGateOf(probe, knobs).alsoAt_mm.empty());
  knobs.spectral->highPrf = true;
  const SpectralGate gate = spectralGateOf(probe, knobs);
  EXPECT_DOUBLE_EQ(gate.prf_hz, 52000.0);
  const double apart_mm = 1.54e6 / 104000.0;
  ASSERT_EQ(gate.alsoAt_mm.size(), 2U);
  EXPECT_NEAR(gate.alsoAt_mm[0], kDepth_mm - apart_mm, 1e-9);
  EXPECT_NEAR(gate.alsoAt_mm[1], kDepth_mm + apart_mm, 1e-9);
}

TEST(SpectralGate, CorrectsForTheAngle) {
  const Probe probe = trialProbe();
  Knobs knobs = spectralKnobs();
  knobs.spectral->angle_rad = pi / 3.0;
  const SpectralGate gate = spectralGateOf(probe, knobs);
  EXPECT_NEAR(gate.corrected, 2.0, 1e-12);
  EXPECT_NEAR(gate.shown_mmPerS.second, 2.0 * gate.nyquist_mmPerS, 1e-9);
  EXPECT_NEAR(gate.flow.x, std::sin(pi / 3.0), 1e-12);
  const Knobs moved = withSpectralGateAt(probe, knobs, {10.0, 30.0});
  EXPECT_NEAR(spectralGateOf(probe, moved).middle_mm.x, 10.0, 1e-9);
  EXPECT_NEAR(spectralGateOf(probe, moved).middle_mm.y, 30.0, 1e-9);
}

TEST(Spectrum, GoesOnWhenItsGainIsTurned) {
  Spectrogram spectrogram;
  SpectrumSetting setting{.prf_hz = 4000.0, .black = 1.0};
  spectrogram.configure(setting, 400, 64, 2.0);
  std::vector<std::complex<float>> tone;
  for (int n = 0; n < 2000; ++n) tone.emplace_back(std::polar(30.0, 0.8 * n));
  spectrogram.add(tone, 0.0);
  const int before = spectrogram.columns();
  ASSERT_GT(before, 80);
  setting.black = 100.0;
  spectrogram.configure(setting, 400, 64, 2.0);
  EXPECT_EQ(spectrogram.columns(), before);
  spectrogram.add(tone, 0.5);
  EXPECT_GT(spectrogram.columns(), before + 80);
  // Lighter before than after, at the tone.
  const auto brightest = [&](int column) {
    int most = 0;
    for (int y = 0; y < 64; ++y) most = std::max<int>(most, spectrogram.strip().image().at(column, y));
    return most;
  };
  EXPECT_GT(brightest(40), brightest(before + 40));
  setting.baseline = 0.5;
  spectrogram.configure(setting, 400, 64, 2.0);
  EXPECT_EQ(spectrogram.columns(), 0);
}

TEST(Spectrum, TellsWhatItRemembersTakes) {
  ColourScan scan(shotOf({.angle_rad = 45.0 * pi / 180.0}));
  for (int n = 0; n < 5; ++n) scan.next();
  const FrameMemory memory = scan.maker().memory();
  ASSERT_NE(memory.spectrum, nullptr);
  // At least its strip, a float for each bin of each column, and 600 scatterers of 28 bytes or more.
  const auto columns = static_cast<std::size_t>(scan.maker().strip().width), rows = static_cast<std::size_t>(scan.maker().strip().height);
  const std::size_t least = columns * (rows + 4 * static_cast<std::size_t>(scan.maker().spectrogram()->bins())) + 600 * 28;
  EXPECT_GE(bytesOf(*memory.spectrum), least);
  EXPECT_LE(bytesOf(*memory.spectrum), 2 * least);
}

TEST(Spectrum, GoesOnFromWhatItRemembers) {
  const Shot shot = shotOf({.angle_rad = 45.0 * pi / 180.0});
  ColourScan scan(shot), other(shot);
  for (int n = 0; n < 10; ++n) scan.next();
  const FrameMemory memory = scan.maker().memory();
  scan.next();
  const GreyImage strip = copyOf(scan.maker().strip());
  other.next();
  other.maker().recall(memory);
  other.input() = scan.input();
  other.input().time_s -= 0.05;
  --other.input().number;
  other.next();
  EXPECT_EQ(copyOf(other.maker().strip()), strip);
}

}  // namespace
}  // namespace ew::spectrum_test
