#include <algorithm>
#include <cmath>

#include "body_signal.h"
#include "ew/core/numbers.h"

namespace ew {
namespace {

constexpr double kRate_hz = 250.0;
constexpr double kBand_hz[2] = {5.0, 15.0};
constexpr double kEnergyWindow_s = 0.15;
constexpr double kRefractory_s = 0.2;
constexpr double kTWave_s = 0.36;

std::size_t samplesOf(double time_s) { return static_cast<std::size_t>(std::lround(time_s * kRate_hz)); }

struct Energy {
  std::vector<double> mean;   ///< of the squared slope around each sample
  std::vector<double> slope;  ///< size of the slope at each sample
};

/// Slope over five samples (eq. 7 of the paper, centred), squared (eq. 10) and averaged (eq. 11).
Energy energyOf(const std::vector<double>& band) {
  std::vector<double> squared(band.size(), 0.0);
  Energy energy;
  energy.slope.assign(band.size(), 0.0);
  for (std::size_t n = 2; n + 2 < band.size(); ++n) {
    const double slope = (2.0 * band[n + 2] + band[n + 1] - band[n - 1] - 2.0 * band[n - 2]) / 8.0;
    energy.slope[n] = std::abs(slope);
    squared[n] = slope * slope;
  }
  energy.mean = movingMean(squared, samplesOf(kEnergyWindow_s));
  return energy;
}

std::vector<std::size_t> peaksOf(const std::vector<double>& values, std::size_t reach) {
  std::vector<std::size_t> peaks;
  for (std::size_t n = 1; n + 1 < values.size(); ++n) {
    if (!(values[n] > values[n - 1] && values[n] >= values[n + 1])) continue;
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(n >= reach ? n - reach : 0);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(values.size(), n + reach + 1));
    if (std::max_element(begin, end) == values.begin() + static_cast<std::ptrdiff_t>(n)) peaks.push_back(n);
  }
  return peaks;
}

/// The median over pieces of two seconds of the largest value: a beat of usual energy, whatever artefacts there are.
double usualBeat(const std::vector<double>& energy) {
  std::vector<double> largest;
  const std::size_t piece = std::min(samplesOf(2.0), energy.size());
  for (std::size_t begin = 0; begin + piece <= energy.size(); begin += piece)
    largest.push_back(*std::max_element(energy.begin() + static_cast<std::ptrdiff_t>(begin),
                                        energy.begin() + static_cast<std::ptrdiff_t>(begin + piece)));
  return medianOrZero(std::move(largest));
}

/// Decides for each peak of energy whether it is a beat.
std::vector<std::size_t> beatsOf(const Energy& energy) {
  const auto steepestAt = [&](std::size_t n) {
    const std::size_t reach = samplesOf(0.075);
    const auto begin = energy.slope.begin() + static_cast<std::ptrdiff_t>(n >= reach ? n - reach : 0);
    return *std::max_element(begin, energy.slope.begin() + static_cast<std::ptrdiff_t>(std::min(energy.slope.size(), n + reach + 1)));
  };
  double signal = usualBeat(energy.mean), noise = medianOrZero(energy.mean);
  noise = std::min(noise, 0.5 * signal);
  std::vector<std::size_t> beats, passedOver;
  for (const std::size_t peak : peaksOf(energy.mean, samplesOf(0.5 * kRefractory_s))) {
    const double height = energy.mean[peak], threshold = noise + 0.25 * (signal - noise);
    const bool early = !beats.empty() && peak - beats.back() < samplesOf(kRefractory_s);
    const bool tWave = !beats.empty() && peak - beats.back() < samplesOf(kTWave_s) && steepestAt(peak) < 0.5 * steepestAt(beats.back());
    if (height <= threshold || early || tWave) {
      noise += 0.125 * (std::min(height, threshold) - noise);
      if (!early && !tWave) passedOver.push_back(peak);
      continue;
    }
    // A beat is overdue after 1.66 usual ones: the largest peak in between counts when it reaches half of the threshold.
    if (beats.size() >= 3) {
      std::vector<double> lengths;
      for (std::size_t n = beats.size() > 8 ? beats.size() - 8 : 1; n < beats.size(); ++n)
        lengths.push_back(static_cast<double>(beats[n] - beats[n - 1]));
      if (static_cast<double>(peak - beats.back()) > 1.66 * medianOrZero(lengths)) {
        std::size_t best = 0;
        for (const std::size_t missed : passedOver)
          if (missed > beats.back() + samplesOf(kTWave_s) && peak > missed + samplesOf(kTWave_s) &&
              (best == 0 || energy.mean[missed] > energy.mean[best]))
            best = missed;
        if (best != 0 && energy.mean[best] > 0.5 * threshold) {
          signal += 0.25 * (energy.mean[best] - signal);
          beats.push_back(best);
        }
      }
    }
    passedOver.clear();
    signal += 0.125 * (std::min(height, 3.0 * signal) - signal);
    beats.push_back(peak);
  }
  return beats;
}

/// Index of the largest of sign * band around a beat.
std::size_t extremumAt(const std::vector<double>& band, std::size_t beat, double sign) {
  const std::size_t reach = samplesOf(0.09), begin = beat >= reach ? beat - reach : 0, end = std::min(band.size(), beat + reach + 1);
  std::size_t best = begin;
  for (std::size_t n = begin; n < end; ++n)
    if (sign * band[n] > sign * band[best]) best = n;
  return best;
}

double polarityOf(const std::vector<double>& band, const std::vector<std::size_t>& beats) {
  double up = 0.0, down = 0.0;
  for (const std::size_t beat : beats) {
    up += band[extremumAt(band, beat, 1.0)];
    down -= band[extremumAt(band, beat, -1.0)];
  }
  return up >= down ? 1.0 : -1.0;
}

/// Spread of what lies between the beats, by the median so that P and T waves hardly count.
double spreadBetween(const std::vector<double>& band, const std::vector<std::size_t>& beats) {
  std::vector<double> sizes;
  std::size_t next = 0;
  const std::size_t reach = samplesOf(0.1);
  for (std::size_t n = 0; n < band.size(); ++n) {
    while (next < beats.size() && beats[next] + reach < n) ++next;
    if (next < beats.size() && n + reach >= beats[next]) continue;
    sizes.push_back(std::abs(band[n]));
  }
  return 1.4826 * medianOrZero(std::move(sizes));
}

double shareAtTheRails(const std::vector<double>& values) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const auto rails =
      std::count_if(values.begin(), values.end(), [low = *lowest, high = *highest](double v) { return v == low || v == high; });
  return static_cast<double>(rails) / static_cast<double>(values.size());
}

}  // namespace

Result<Cycles> findHeartBeats(const BodySignal& ecg, const EcgOptions& options) {
  const auto signal = usable(ecg, say<"ECG">());
  if (!signal) return passOn(signal.error());
  const auto refuse = [](const Message& why) {
    return failure(ErrorCode::unsupported, say<"The ECG cannot gate: %1; gate by the images.">(why), {{"field", "ECG"}});
  };
  const double samplesPerSecond = 1.0 / medianStep_s(signal->time_s);
  if (samplesPerSecond < options.leastSamplesPerSecond)
    return refuse(say<"with %1 samples a second R peaks fall between them">(textOf(std::round(10.0 * samplesPerSecond) / 10.0)));
  if (signal->time_s.back() - signal->time_s.front() < 60.0 / options.highest_perMin)
    return refuse(say<"it is shorter than one heart beat">());
  const EvenSignal even = evenly(*signal, 1.0 / kRate_hz);
  const auto band = filteredBothWays(filteredBothWays(even.value, FilterKind::highPass, kBand_hz[0], kRate_hz), FilterKind::lowPass,
                                     kBand_hz[1], kRate_hz);
  auto beats = beatsOf(energyOf(band));
  if (beats.empty()) return refuse(say<"it has no R peak">());
  const double sign = polarityOf(band, beats);
  std::vector<double> starts_s, heights;
  for (std::size_t& beat : beats) {
    beat = extremumAt(band, beat, sign);
    if (!starts_s.empty() && even.start_s + static_cast<double>(beat) / kRate_hz - starts_s.back() < 60.0 / options.highest_perMin)
      continue;
    double shift = 0.0;
    if (beat > 0 && beat + 1 < band.size()) {
      const double curvature = band[beat - 1] - 2.0 * band[beat] + band[beat + 1];
      if (sign * curvature < 0.0) shift = std::clamp(0.5 * (band[beat - 1] - band[beat + 1]) / curvature, -0.5, 0.5);
    }
    starts_s.push_back(even.start_s + (static_cast<double>(beat) + shift) / kRate_hz);
    heights.push_back(sign * band[beat]);
  }
  if (starts_s.size() < 2) return refuse(say<"it has a single R peak, which does not say how long a beat lasts">());
  const double spread = spreadBetween(band, beats);
  const double signalToNoise = spread > 0.0 ? medianOrZero(heights) / spread : 1e6;
  if (signalToNoise < options.leastSignalToNoise)
    return refuse(say<"no R peaks stand out of the noise (%1 times its spread, %2 are needed)">(
        textOf(std::round(10.0 * signalToNoise) / 10.0), textOf(options.leastSignalToNoise)));

  Cycles cycles = cyclesFrom(std::move(starts_s), options.irregularShare, options.bridgeMissedBeats);
  cycles.inverted = sign < 0.0;
  const double regularShare = 1.0 - static_cast<double>(cycles.irregular) / static_cast<double>(cycles.regular.size());
  cycles.confidence = std::clamp((signalToNoise - 3.0) / 6.0, 0.0, 1.0) * (0.5 + 0.5 * regularShare);
  if (cycles.rate_perMin < options.lowest_perMin)
    return refuse(say<"its beats are %1 s apart, too far for a heart">(textOf(std::round(600.0 / cycles.rate_perMin) / 10.0)));
  if (cycles.inverted) cycles.notes.push_back(say<"The ECG is inverted: its R peaks point downwards.">());
  if (const double share = shareAtTheRails(signal->value); share > 0.02)
    cycles.notes.push_back(
        say<"The ECG is saturated: %1 % of it lie at its highest or lowest value; R peaks are timed by the middle of their tops.">(
            textOf(std::round(share * 100.0))));
  if (samplesPerSecond < 60.0)
    cycles.notes.push_back(say<"With %1 samples a second R peaks are timed to about %2 ms.">(textOf(std::round(samplesPerSecond)),
                                                                                             textOf(std::round(500.0 / samplesPerSecond))));
  return cycles;
}

Result<Cycles> findBreaths(const BodySignal& respiration, const BreathOptions& options) {
  const auto signal = usable(respiration, say<"respiration signal">());
  if (!signal) return passOn(signal.error());
  const auto refuse = [](const Message& why) {
    return failure(ErrorCode::unsupported, say<"The respiration signal cannot gate: %1; gate by the images.">(why),
                   {{"field", "respiration"}});
  };
  constexpr double kStep_s = 0.05;
  const double shortest_s = 60.0 / options.highest_perMin, duration_s = signal->time_s.back() - signal->time_s.front();
  if (1.0 / medianStep_s(signal->time_s) < 3.0 / shortest_s) return refuse(say<"it has too few samples a second">());
  if (duration_s < 2.0 * shortest_s) return refuse(say<"it is shorter than two breaths">());
  EvenSignal even = evenly(*signal, kStep_s);
  even.value = filteredBothWays(even.value, FilterKind::lowPass, 1.5 / shortest_s, 1.0 / kStep_s);
  if (options.fallsWithInspiration)
    for (double& value : even.value) value = -value;

  // A straight line is taken away first, so that drift does not look like a long period.
  const auto count = static_cast<double>(even.value.size());
  double mean = 0.0, slope = 0.0, lever = 0.0;
  for (const double value : even.value) mean += value / count;
  for (std::size_t n = 0; n < even.value.size(); ++n) {
    const double arm = static_cast<double>(n) - 0.5 * (count - 1.0);
    slope += arm * even.value[n];
    lever += arm * arm;
  }
  std::vector<double> level = even.value;
  for (std::size_t n = 0; n < level.size(); ++n) level[n] -= mean + slope / lever * (static_cast<double>(n) - 0.5 * (count - 1.0));
  const auto lowest = static_cast<std::size_t>(shortest_s / kStep_s) - 1;
  const auto highest = static_cast<std::size_t>(std::min(60.0 / options.lowest_perMin, 0.6 * duration_s) / kStep_s) + 1;
  std::vector<double> heights;
  for (std::size_t lag = lowest; lag <= highest; ++lag) heights.push_back(autocorrelation(level, lag));
  const Repeat repeat = firstRepeat(heights, lowest);
  if (repeat.height < options.leastConfidence)
    return refuse(say<"nothing in it repeats (correlation %1 after one period, %2 is needed)">(
        textOf(std::round(100.0 * repeat.height) / 100.0), textOf(options.leastConfidence)));
  const double period_s = repeat.lag * kStep_s;
  const auto drift = movingMean(even.value, static_cast<std::size_t>(std::lround(repeat.lag)));
  for (std::size_t n = 0; n < drift.size(); ++n) even.value[n] -= drift[n];
  Cycles cycles = cyclesFrom(maximaOf(even, period_s), options.irregularShare, false);
  if (cycles.starts_s.size() < 2) return refuse(say<"it holds fewer than two full inspirations">());
  cycles.confidence = std::min(1.0, repeat.height);
  return cycles;
}

}  // namespace ew
