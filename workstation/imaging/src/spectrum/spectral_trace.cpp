#include "ew/imaging/spectral_trace.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr int kSmoothBins = 1;  // on both sides

/// A spectrum unrolled so that it begins at the lowest velocity that is shown.
struct Unrolled {
  std::vector<double> power;
  double lowest;  ///< of the first bin, as a share of the Nyquist velocity
  [[nodiscard]] double velocityAt(double bin) const { return lowest + 2.0 * bin / static_cast<double>(power.size()); }
};

Unrolled unrolled(std::span<const float> powers, double baseline) {
  const auto bins = static_cast<std::int64_t>(powers.size());
  const auto shift = std::llround(0.5 * baseline * static_cast<double>(bins));
  Unrolled result{std::vector<double>(powers.size()), -1.0 + 2.0 * static_cast<double>(shift) / static_cast<double>(bins)};
  for (std::int64_t n = 0; n < bins; ++n) {
    double sum = 0.0, weights = 0.0;
    for (int aside = -kSmoothBins; aside <= kSmoothBins; ++aside) {
      if (n + aside < 0 || n + aside >= bins) continue;  // the scale's ends do not meet
      const double weight = aside == 0 ? 2.0 : 1.0;
      sum += weight * static_cast<double>(powers[static_cast<std::size_t>(((n + aside + shift) % bins + bins) % bins)]);
      weights += weight;
    }
    result.power[static_cast<std::size_t>(n)] = sum / weights;
  }
  return result;
}

/// The greatest velocity on one side: from the last bin of signal inwards, the level of the spectrum, and where the slope behind it
/// passes half of that.
/// @param at power by bins away from 0
double edgeOf(const std::vector<double>& at, double noise, double aboveNoise) {
  // Three in a row: a single bin is high by chance.
  std::int64_t end = -1;
  for (auto n = static_cast<std::int64_t>(at.size()) - 1; n >= 0 && end < 0; --n) {
    const auto isSignal = [&](std::int64_t bin) { return bin < 0 || at[static_cast<std::size_t>(bin)] > aboveNoise * noise; };
    if (isSignal(n) && isSignal(n - 1) && isSignal(n - 2)) end = n;
  }
  if (end < 0) return 0.0;
  double edge = static_cast<double>(end);
  // The level below the slope: over a third of what lies below, but of as many bins as a plug's line is wide at least.
  for (int pass = 0; pass < 4; ++pass) {
    const auto to = static_cast<std::int64_t>(std::floor(edge)), width = std::max<std::int64_t>(3, to / 3);
    const std::int64_t from = std::max<std::int64_t>(0, to - width);
    double level = 0.0;
    for (std::int64_t n = from; n <= to; ++n) level = std::max(level, at[static_cast<std::size_t>(n)]);
    double sum = 0.0;
    int count = 0;
    for (std::int64_t n = from; n <= to; ++n)
      if (at[static_cast<std::size_t>(n)] > 0.3 * level) {
        sum += at[static_cast<std::size_t>(n)];
        ++count;
      }
    const double half = noise + 0.5 * std::max(sum / std::max(count, 1) - noise, 0.0);
    std::int64_t n = std::min<std::int64_t>(end, static_cast<std::int64_t>(at.size()) - 2);
    while (n > 0 && at[static_cast<std::size_t>(n)] < half) --n;
    const double here = at[static_cast<std::size_t>(n)], next = at[static_cast<std::size_t>(n) + 1];
    const double found = static_cast<double>(n) + (here > next ? std::clamp((here - half) / (here - next), 0.0, 1.0) : 0.0);
    if (std::abs(found - edge) < 0.05) return found;
    edge = found;
  }
  return edge;
}

double percentile(std::vector<float> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return static_cast<double>(*at);
}

/// Value at a share of a rising list.
double meanOf(std::span<const double> values) {
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Share of a vessel's radius within which a share of a spectrum's power comes from, in steps.
class PowerWithin {
 public:
  explicit PowerWithin(double radiusOverSlice) {
    double sum = 0.0;
    for (int n = 0; n < kSteps; ++n) {
      const double r = (n + 0.5) / kSteps, q = 0.25 * r * r * radiusOverSlice * radiusOverSlice;
      sum += r * scaledBessel(q);
      within_.push_back(sum);
    }
    for (double& each : within_) each /= sum;
  }
  [[nodiscard]] double radiusOf(double share) const {
    const auto at = std::lower_bound(within_.begin(), within_.end(), share) - within_.begin();
    if (at >= kSteps) return 1.0;
    const double below = at > 0 ? within_[static_cast<std::size_t>(at) - 1] : 0.0, here = within_[static_cast<std::size_t>(at)];
    return (static_cast<double>(at) + (share - below) / (here - below)) / kSteps;
  }

 private:
  static constexpr int kSteps = 64;
  static double scaledBessel(double q) {
    return q < 600.0 ? std::exp(-q) * std::cyl_bessel_i(0.0, q) : 1.0 / std::sqrt(2.0 * 3.141592653589793 * q);
  }
  std::vector<double> within_;
};

}  // namespace

TracePoint traceOf(std::span<const float> powers, double noise, const TraceRule& rule) {
  EW_EXPECTS(powers.size() >= 8);
  const Unrolled spectrum = unrolled(powers, rule.baseline);
  const double perBin = 2.0 / static_cast<double>(powers.size());
  const auto zero = std::clamp(static_cast<std::int64_t>(std::llround(-spectrum.lowest / perBin)), std::int64_t{0},
                               static_cast<std::int64_t>(powers.size()) - 1);
  const auto kept = static_cast<std::int64_t>(std::ceil(rule.filtered / perBin));
  std::vector<double> forward, backward;
  for (auto n = zero; n < static_cast<std::int64_t>(powers.size()); ++n) forward.push_back(spectrum.power[static_cast<std::size_t>(n)]);
  for (auto n = zero; n >= 0; --n) backward.push_back(spectrum.power[static_cast<std::size_t>(n)]);
  TracePoint point;
  if (forward.size() > 3) point.forward = std::max(0.0, edgeOf(forward, noise, rule.aboveNoise)) * perBin;
  if (backward.size() > 3) point.backward = -std::max(0.0, edgeOf(backward, noise, rule.aboveNoise)) * perBin;
  if (point.forward <= static_cast<double>(kept) * perBin) point.forward = 0.0;
  if (-point.backward <= static_cast<double>(kept) * perBin) point.backward = 0.0;
  double sum = 0.0, weighted = 0.0;
  for (std::size_t n = 0; n < spectrum.power.size(); ++n) {
    const double signal = spectrum.power[n] - noise, velocity = spectrum.velocityAt(static_cast<double>(n));
    if (velocity > point.forward + 2.0 * perBin || velocity < point.backward - 2.0 * perBin) continue;
    sum += signal;
    weighted += signal * velocity;
  }
  point.mean = sum > 0.0 ? std::clamp(weighted / sum, point.backward, point.forward) : 0.0;
  point.sectionMean = point.mean;
  if (rule.radiusOverSlice > 0.0 && sum > 0.0) {
    // From the fastest to what flows back most, or the other way around.
    const PowerWithin within(rule.radiusOverSlice);
    const bool isForward = point.forward >= -point.backward;
    double done = 0.0, area = 0.0, mean = 0.0;
    for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
      const std::size_t n = isForward ? spectrum.power.size() - 1 - k : k;
      const double velocity = spectrum.velocityAt(static_cast<double>(n));
      if (velocity > point.forward + 2.0 * perBin || velocity < point.backward - 2.0 * perBin) continue;
      done = std::clamp(done + (spectrum.power[n] - noise) / sum, done, 1.0);
      const double radius = within.radiusOf(done), next = radius * radius;
      mean += (next - area) * velocity;
      area = next;
    }
    if (area > 0.0) point.sectionMean = std::clamp(mean / area, point.backward, point.forward);
  }
  return point;
}

std::vector<TracePoint> tracedBy(const Spectrogram& spectrogram, const TraceRule& rule, double from_s) {
  std::vector<TracePoint> points;
  const int columns = spectrogram.columns();
  if (columns == 0) return points;
  double noise = rule.noise;
  if (!(noise > 0.0)) {
    // Of periodograms, single powers are exponential: a tenth lies below 0.105 of the mean.
    std::vector<float> some;
    for (int column = 0; column < columns; column += std::max(1, columns / 64)) {
      const auto powers = spectrogram.powers(column);
      some.insert(some.end(), powers.begin(), powers.end());
    }
    noise = percentile(std::move(some), 0.1) / 0.105;
  }
  std::vector<float> mean(static_cast<std::size_t>(spectrogram.bins()));
  for (int column = 0; column < columns; ++column) {
    const double time_s = spectrogram.timeOf(column);
    if (time_s < from_s) continue;
    std::fill(mean.begin(), mean.end(), 0.0F);
    int count = 0;
    const auto add = [&](int from) {
      const auto powers = spectrogram.powers(from);
      for (std::size_t n = 0; n < mean.size(); ++n) mean[n] += powers[n];
      ++count;
    };
    add(column);
    for (int n = column - 1; n >= 0 && time_s - spectrogram.timeOf(n) <= rule.smooth_s; --n) add(n);
    for (int n = column + 1; n < columns && spectrogram.timeOf(n) - time_s <= rule.smooth_s; ++n) add(n);
    for (float& power : mean) power /= static_cast<float>(count);
    // Powers of a periodogram are exponential: the fewer are averaged, the farther off is chance.
    TraceRule ofMean = rule;
    ofMean.aboveNoise = 1.0 + rule.aboveNoise / std::sqrt(static_cast<double>(count));
    points.push_back(traceOf(mean, noise, ofMean));
    points.back().time_s = time_s;
  }
  // Of three neighbours the middle one: what a single column says against both of them is chance.
  std::vector<TracePoint> steady = points;
  const auto middle = [](double a, double b, double c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); };
  for (std::size_t n = 1; n + 1 < points.size(); ++n) {
    steady[n].forward = middle(points[n - 1].forward, points[n].forward, points[n + 1].forward);
    steady[n].backward = middle(points[n - 1].backward, points[n].backward, points[n + 1].backward);
    steady[n].mean = std::clamp(points[n].mean, steady[n].backward, steady[n].forward);
  }
  return steady;
}

double WaveformValues::resistiveIndex() const { return peakSystolic != 0.0 ? (peakSystolic - endDiastolic) / peakSystolic : 0.0; }

std::optional<double> WaveformValues::pulsatilityIndex() const {
  if (!(std::abs(timeAverageMaximum) > 0.05 * std::abs(peakSystolic))) return std::nullopt;
  const bool reverses = peakSystolic * least < 0.0;
  return (peakSystolic - (reverses ? least : endDiastolic)) / timeAverageMaximum;
}

std::optional<double> WaveformValues::systolicOverDiastolic() const {
  if (!(std::abs(endDiastolic) > 0.02 * std::abs(peakSystolic))) return std::nullopt;
  return peakSystolic / endDiastolic;
}

double WaveformValues::accelerationIndex() const { return acceleration_s > 0.0 ? (peakSystolic - endDiastolic) / acceleration_s : 0.0; }

std::optional<WaveformValues> waveformOf(std::span<const double> times_s, std::span<const double> envelope, std::span<const double> mean) {
  EW_EXPECTS(times_s.size() == envelope.size() && mean.size() == envelope.size());
  if (times_s.size() < 8) return std::nullopt;
  const auto [lowest, highest] = std::minmax_element(envelope.begin(), envelope.end());
  // What flows back most counts as forward here, so that veins and vessels seen from behind are measured alike.
  const double sign = *highest >= -*lowest ? 1.0 : -1.0;
  std::vector<double> wave;
  for (const double value : envelope) wave.push_back(sign * value);
  const double top = *std::max_element(wave.begin(), wave.end()), bottom = *std::min_element(wave.begin(), wave.end());
  if (!(top > 0.0) || top - bottom < top / 6.0) return std::nullopt;

  // Upstrokes: from a quarter of the way up to three quarters, without falling below a quarter between.
  const double low = bottom + 0.35 * (top - bottom), high = bottom + 0.7 * (top - bottom);
  std::vector<std::size_t> rises;
  bool isLow = false;
  for (std::size_t n = 0; n < wave.size(); ++n) {
    if (wave[n] < low) isLow = true;
    if (isLow && wave[n] > high) {
      rises.push_back(n);
      isLow = false;
    }
  }
  if (rises.size() < 2) return std::nullopt;
  struct Beat {
    std::size_t foot, peak;
  };
  std::vector<Beat> beats;
  for (std::size_t beat = 0; beat < rises.size(); ++beat) {
    // Down from the rise to where it began, and up to the first top that stands.
    std::size_t foot = rises[beat];
    const std::size_t earliest = beat > 0 ? rises[beat - 1] : 0;
    while (foot > earliest && (wave[foot - 1] < wave[foot] || wave[foot] > low)) --foot;
    const std::size_t end = beat + 1 < rises.size() ? rises[beat + 1] : wave.size();
    std::size_t peak = rises[beat];
    for (std::size_t n = rises[beat]; n < end; ++n)
      if (wave[n] > wave[peak]) peak = n;
    beats.push_back({foot, peak});
  }
  WaveformValues values;
  std::vector<double> peaks, ends, rise_s;
  for (std::size_t beat = 0; beat + 1 < beats.size(); ++beat) {
    peaks.push_back(wave[beats[beat].peak]);
    // Just before the next upstroke: the mean of a little before its foot.
    const std::size_t foot = beats[beat + 1].foot, from = std::max(beats[beat].peak, foot > 4 ? foot - 4 : 0);
    ends.push_back(meanOf(std::span(wave).subspan(from, foot - from + 1)));
    rise_s.push_back(times_s[beats[beat].peak] - times_s[beats[beat].foot]);
  }
  const std::size_t begin = beats.front().foot, end = beats.back().foot;
  if (end <= begin + 2) return std::nullopt;
  const auto whole = [&](std::span<const double> all) { return all.subspan(begin, end - begin); };
  values.beats = static_cast<int>(beats.size()) - 1;
  values.peakSystolic = sign * meanOf(peaks);
  values.endDiastolic = sign * meanOf(ends);
  values.least =
      sign * *std::min_element(wave.begin() + static_cast<std::ptrdiff_t>(begin), wave.begin() + static_cast<std::ptrdiff_t>(end));
  values.timeAverageMaximum = meanOf(whole(envelope));
  values.timeAverageMean = meanOf(whole(mean));
  values.acceleration_s = meanOf(rise_s);
  values.heartPeriod_s = (times_s[end] - times_s[begin]) / values.beats;
  return values;
}

}  // namespace ew
