#include "body_signal.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "ew/core/numbers.h"
#include "ew/core/order_statistics.h"

namespace ew {
namespace {

/// One section in direct form: b and a with a0 = 1.
struct Section {
  double b0 = 0.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;
};

/// Butterworth of second order by the bilinear transform.
Section sectionOf(FilterKind kind, double corner_hz, double rate_hz) {
  const double k = std::tan(std::numbers::pi * corner_hz / rate_hz);
  const double norm = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  Section section;
  section.a1 = 2.0 * (k * k - 1.0) * norm;
  section.a2 = (1.0 - std::numbers::sqrt2 * k + k * k) * norm;
  section.b0 = kind == FilterKind::lowPass ? k * k * norm : norm;
  section.b1 = kind == FilterKind::lowPass ? 2.0 * section.b0 : -2.0 * section.b0;
  section.b2 = section.b0;
  return section;
}

/// Starts as if the first value had lasted for ever.
void run(const Section& s, FilterKind kind, std::vector<double>& values) {
  const double before = values.front();
  const double settled = kind == FilterKind::lowPass ? before : 0.0;
  double x1 = before, x2 = before, y1 = settled, y2 = settled;
  for (double& value : values) {
    const double y = s.b0 * value + s.b1 * x1 + s.b2 * x2 - s.a1 * y1 - s.a2 * y2;
    x2 = x1;
    x1 = value;
    y2 = y1;
    y1 = y;
    value = y;
  }
}

/// Median of the lengths around `n`, at most three to either side, itself left out.
double usualAround(std::span<const double> lengths, std::size_t n) {
  std::vector<double> around;
  for (std::size_t m = n >= 3 ? n - 3 : 0; m <= n + 3 && m < lengths.size(); ++m)
    if (m != n) around.push_back(lengths[m]);
  return around.empty() ? lengths[n] : medianOrZero(std::move(around));
}

std::vector<double> lengthsOf(std::span<const double> starts_s) {
  std::vector<double> lengths;
  for (std::size_t n = 1; n < starts_s.size(); ++n) lengths.push_back(starts_s[n] - starts_s[n - 1]);
  return lengths;
}

}  // namespace

Result<BodySignal> usable(const BodySignal& signal, const Message& name) {
  if (signal.time_s.size() != signal.value.size())
    return failure(ErrorCode::badField,
                   say<"The %1 has %2 times and %3 values; give one value for each time.">(name, signal.time_s.size(), signal.value.size()),
                   {{"field", name.english()}});
  BodySignal kept;
  for (std::size_t n = 0; n < signal.time_s.size(); ++n) {
    if (!std::isfinite(signal.time_s[n]) || !std::isfinite(signal.value[n])) continue;
    if (!kept.time_s.empty() && signal.time_s[n] < kept.time_s.back())
      return failure(ErrorCode::badField, say<"Time runs backwards in the %1 at sample %2; put the recording in order of time.">(name, n),
                     {{"field", name.english()}, {"sample", std::to_string(n)}});
    if (!kept.time_s.empty() && signal.time_s[n] == kept.time_s.back()) continue;
    kept.time_s.push_back(signal.time_s[n]);
    kept.value.push_back(signal.value[n]);
  }
  // Memory goes by this span, and one wrong time stretches it without end.
  constexpr double kLongest_s = 24.0 * 3600.0;
  if (kept.time_s.size() > 1 && !(kept.time_s.back() - kept.time_s.front() <= kLongest_s))
    return failure(ErrorCode::badField,
                   say<"The times of the %1 go from %2 s to %3 s, which is longer than a day; correct the recording's times.">(
                       name, textOf(kept.time_s.front()), textOf(kept.time_s.back())),
                   {{"field", name.english()}, {"found", textOf(kept.time_s.back() - kept.time_s.front())}});
  if (kept.time_s.size() < 4)
    return failure(ErrorCode::unsupported,
                   say<"The %1 has fewer than four samples at different times; gate by another signal or by the images.">(name),
                   {{"field", name.english()}});
  const auto [lowest, highest] = std::minmax_element(kept.value.begin(), kept.value.end());
  if (*lowest == *highest)
    return failure(
        ErrorCode::unsupported,
        say<"The %1 is the same throughout, as of an electrode or a belt that is not connected; gate by another signal or by the images.">(
            name),
        {{"field", name.english()}});
  return kept;
}

double medianOrZero(std::vector<double> values) { return values.empty() ? 0.0 : medianOf(std::move(values)); }

double medianStep_s(std::span<const double> time_s) { return medianOrZero(lengthsOf(time_s)); }

EvenSignal evenly(const BodySignal& signal, double step_s) {
  const double native_s = medianStep_s(signal.time_s);
  std::vector<double> smooth = signal.value;
  if (native_s > 0.0 && step_s > 1.5 * native_s)
    smooth = movingMean(signal.value, static_cast<std::size_t>(std::lround(step_s / native_s)));
  EvenSignal even{signal.time_s.front(), step_s, {}};
  const auto count = static_cast<std::size_t>(std::floor((signal.time_s.back() - even.start_s) / step_s)) + 1;
  even.value.reserve(count);
  std::size_t after = 1;
  for (std::size_t n = 0; n < count; ++n) {
    const double t_s = even.start_s + static_cast<double>(n) * step_s;
    while (after + 1 < signal.time_s.size() && signal.time_s[after] < t_s) ++after;
    const double from_s = signal.time_s[after - 1], to_s = signal.time_s[after];
    const double share = std::clamp((t_s - from_s) / (to_s - from_s), 0.0, 1.0);
    even.value.push_back(smooth[after - 1] + share * (smooth[after] - smooth[after - 1]));
  }
  return even;
}

std::vector<double> movingMean(std::span<const double> values, std::size_t samples) {
  const std::size_t half = samples / 2, count = values.size();
  std::vector<double> sums(count + 1, 0.0);
  for (std::size_t n = 0; n < count; ++n) sums[n + 1] = sums[n] + values[n];
  std::vector<double> means(count);
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t begin = n >= half ? n - half : 0, end = std::min(count, n + half + 1);
    means[n] = (sums[end] - sums[begin]) / static_cast<double>(end - begin);
  }
  return means;
}

std::vector<double> filteredBothWays(std::span<const double> values, FilterKind kind, double corner_hz, double rate_hz) {
  const Section section = sectionOf(kind, corner_hz, rate_hz);
  // Turned over at both ends, so that the filter has settled when the signal begins.
  const std::size_t pad = std::min(values.size() - 1, static_cast<std::size_t>(3.0 * rate_hz / corner_hz));
  std::vector<double> padded;
  padded.reserve(values.size() + 2 * pad);
  for (std::size_t n = pad; n > 0; --n) padded.push_back(2.0 * values.front() - values[n]);
  padded.insert(padded.end(), values.begin(), values.end());
  for (std::size_t n = 1; n <= pad; ++n) padded.push_back(2.0 * values.back() - values[values.size() - 1 - n]);
  for (int way = 0; way < 2; ++way) {
    run(section, kind, padded);
    std::reverse(padded.begin(), padded.end());
  }
  return {padded.begin() + static_cast<std::ptrdiff_t>(pad), padded.end() - static_cast<std::ptrdiff_t>(pad)};
}

double autocorrelation(std::span<const double> values, std::size_t lag) {
  double both = 0.0, first = 0.0, second = 0.0;
  for (std::size_t n = 0; n + lag < values.size(); ++n) {
    both += values[n] * values[n + lag];
    first += values[n] * values[n];
    second += values[n + lag] * values[n + lag];
  }
  const double power = std::sqrt(first * second);
  return power > 0.0 ? both / power : 0.0;
}

Repeat firstRepeat(std::span<const double> heightOfLag, std::size_t lowest) {
  double largest = 0.0;
  const auto isPeak = [&](std::size_t n) { return heightOfLag[n] >= heightOfLag[n - 1] && heightOfLag[n] > heightOfLag[n + 1]; };
  for (std::size_t n = 1; n + 1 < heightOfLag.size(); ++n)
    if (isPeak(n)) largest = std::max(largest, heightOfLag[n]);
  for (std::size_t n = 1; n + 1 < heightOfLag.size(); ++n) {
    if (!isPeak(n) || heightOfLag[n] < 0.85 * largest || largest <= 0.0) continue;
    const double before = heightOfLag[n - 1], at = heightOfLag[n], after = heightOfLag[n + 1];
    const double curvature = before - 2.0 * at + after;
    const double shift = curvature < 0.0 ? 0.5 * (before - after) / curvature : 0.0;
    return {static_cast<double>(lowest + n) + shift, at};
  }
  return {};
}

std::vector<double> maximaOf(const EvenSignal& signal, double period_s) {
  const auto& x = signal.value;
  const auto reach = std::max<std::ptrdiff_t>(1, std::lround(0.35 * period_s / signal.step_s));
  const auto count = static_cast<std::ptrdiff_t>(x.size());
  const double spread = std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0) / static_cast<double>(count));
  std::vector<double> times_s;
  for (std::ptrdiff_t n = 1; n + 1 < count; ++n) {
    const auto at = static_cast<std::size_t>(n);
    if (x[at] < 0.3 * spread) continue;
    const auto begin = x.begin() + std::max<std::ptrdiff_t>(0, n - reach), end = x.begin() + std::min(count, n + reach + 1);
    if (std::max_element(begin, end) != x.begin() + n) continue;
    const double curvature = x[at - 1] - 2.0 * x[at] + x[at + 1];
    const double shift = curvature < 0.0 ? std::clamp(0.5 * (x[at - 1] - x[at + 1]) / curvature, -0.5, 0.5) : 0.0;
    times_s.push_back(signal.start_s + (static_cast<double>(n) + shift) * signal.step_s);
  }
  return times_s;
}

Cycles cyclesFrom(std::vector<double> starts_s, double irregularShare, bool bridge) {
  Cycles cycles;
  const auto found = lengthsOf(starts_s);
  if (!starts_s.empty()) cycles.starts_s.push_back(starts_s.front());
  for (std::size_t n = 0; n < found.size(); ++n) {
    const double usual_s = usualAround(found, n);
    const double times = std::round(found[n] / usual_s);
    if (bridge && found.size() >= 3 && times >= 2.0 && times <= 4.0 && std::abs(found[n] / times - usual_s) <= 0.12 * usual_s)
      for (double step = 1.0; step < times; step += 1.0) {
        cycles.starts_s.push_back(starts_s[n] + found[n] * step / times);
        ++cycles.bridged;
      }
    cycles.starts_s.push_back(starts_s[n + 1]);
  }
  const auto lengths = lengthsOf(cycles.starts_s);
  std::vector<double> regular_s;
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    const double usual_s = usualAround(lengths, n);
    cycles.regular.push_back(std::abs(lengths[n] - usual_s) <= irregularShare * usual_s);
    if (cycles.regular.back()) regular_s.push_back(lengths[n]);
  }
  cycles.irregular = lengths.size() - regular_s.size();
  const double median_s = medianOrZero(regular_s.empty() ? lengths : regular_s);
  cycles.rate_perMin = median_s > 0.0 ? 60.0 / median_s : 0.0;
  if (cycles.bridged > 0)
    cycles.notes.push_back(cycles.bridged == 1 ? say<"1 missed beat was put in evenly between those around.">()
                                               : say<"%1 missed beats were put in evenly between those around.">(cycles.bridged));
  if (cycles.irregular > 0)
    cycles.notes.push_back(say<"%1 of %2 cycles are irregular; their frames are not used.">(cycles.irregular, lengths.size()));
  return cycles;
}

}  // namespace ew
