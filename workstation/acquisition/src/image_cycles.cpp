#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "body_signal.h"
#include "ew/core/numbers.h"
#include "ew/core/parallel.h"

namespace ew {
namespace {

constexpr int kCycleCells = 24;
constexpr std::size_t kComponents = 4;
constexpr double kWindow_periods = 6.0;
constexpr double kPiece_periods = 12.0;  ///< of the slowest rhythm, for the spectrum

/// (moments x cells), row after row.
struct CycleCells {
  std::size_t moments = 0;
  std::size_t cells = 0;
  std::vector<double> value;
  [[nodiscard]] const double* row(std::size_t moment) const { return value.data() + moment * cells; }
  [[nodiscard]] double* row(std::size_t moment) { return value.data() + moment * cells; }
};

void reduce(const ImageView<const std::uint8_t>& image, int across, int down, double* cells) {
  for (int cy = 0; cy < down; ++cy) {
    const int top = cy * image.height / down, bottom = (cy + 1) * image.height / down;
    for (int cx = 0; cx < across; ++cx) {
      const int left = cx * image.width / across, right = (cx + 1) * image.width / across;
      std::uint64_t sum = 0;
      for (int y = top; y < bottom; ++y) {
        const std::uint8_t* const row = image.row(y);
        for (int x = left; x < right; ++x) sum += row[x];
      }
      cells[cy * across + cx] = static_cast<double>(sum) / ((bottom - top) * (right - left));
    }
  }
}

/// Every cell at even moments.
CycleCells evenCells(const CycleCells& raw, std::span<const double> time_s, double step_s) {
  BodySignal signal{{time_s.begin(), time_s.end()}, std::vector<double>(raw.moments)};
  CycleCells even;
  for (std::size_t cell = 0; cell < raw.cells; ++cell) {
    for (std::size_t n = 0; n < raw.moments; ++n) signal.value[n] = raw.row(n)[cell];
    const EvenSignal one = evenly(signal, step_s);
    if (even.value.empty()) {
      even = {one.value.size(), raw.cells, {}};
      even.value.resize(even.moments * even.cells);
    }
    for (std::size_t n = 0; n < even.moments; ++n) even.row(n)[cell] = one.value[n];
  }
  return even;
}

/// Every cell's band over time: what is slower than two periods is taken away twice, flicker is smoothed.
CycleCells bandOf(CycleCells even, double step_s, double period_s) {
  const auto slow = static_cast<std::size_t>(std::lround(period_s / step_s));
  const auto fast = static_cast<std::size_t>(std::lround(0.2 * period_s / step_s));
  std::vector<double> values(even.moments);
  for (std::size_t cell = 0; cell < even.cells; ++cell) {
    for (std::size_t n = 0; n < even.moments; ++n) values[n] = even.row(n)[cell];
    for (int time = 0; time < 2; ++time) {
      const auto trend = movingMean(values, slow);
      for (std::size_t n = 0; n < trend.size(); ++n) values[n] -= trend[n];
    }
    if (fast > 1) values = movingMean(values, fast);
    for (std::size_t n = 0; n < even.moments; ++n) even.row(n)[cell] = values[n];
  }
  return even;
}

/// Power over frequency of all cells together, in overlapping pieces with a straight line taken away.
struct Spectrum {
  double first_hz = 0.0;
  double step_hz = 0.0;
  double resolution_hz = 0.0;  ///< width of a pure tone
  std::vector<double> power;
};

Spectrum spectrumOf(const CycleCells& even, double step_s, double piece_s, double highest_hz, int threads, Progress& progress) {
  const std::size_t length = std::min(even.moments, static_cast<std::size_t>(piece_s / step_s));
  const double span_s = static_cast<double>(length) * step_s;
  Spectrum spectrum{1.0 / span_s, 0.5 / span_s, 2.0 / span_s, {}};
  const auto tones = static_cast<std::size_t>(std::max(0.0, (highest_hz - spectrum.first_hz) / spectrum.step_hz)) + 1;
  std::vector<double> window(length);
  for (std::size_t n = 0; n < length; ++n) {
    const double along = (static_cast<double>(n) + 0.5) / static_cast<double>(length);
    window[n] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * along);
  }
  // (tones x moments) cosines and sines
  std::vector<double> cosine(tones * length), sine(tones * length);
  for (std::size_t tone = 0; tone < tones; ++tone)
    for (std::size_t n = 0; n < length; ++n) {
      const double angle_rad =
          2.0 * std::numbers::pi * (spectrum.first_hz + static_cast<double>(tone) * spectrum.step_hz) * static_cast<double>(n) * step_s;
      cosine[tone * length + n] = window[n] * std::cos(angle_rad);
      sine[tone * length + n] = window[n] * std::sin(angle_rad);
    }
  std::vector<std::vector<double>> ofCell(even.cells);
  const auto measure = [&](int task) {
    const auto cell = static_cast<std::size_t>(task);
    auto& power = ofCell[cell];
    power.assign(tones, 0.0);
    std::vector<double> piece(length);
    const std::size_t hop = std::max<std::size_t>(1, length / 2);
    for (std::size_t begin = 0; begin + length <= even.moments; begin += hop) {
      double mean = 0.0, slope = 0.0, lever = 0.0;
      const double middle = 0.5 * (static_cast<double>(length) - 1.0);
      for (std::size_t n = 0; n < length; ++n) {
        piece[n] = even.row(begin + n)[cell];
        mean += piece[n] / static_cast<double>(length);
        slope += (static_cast<double>(n) - middle) * piece[n];
        lever += (static_cast<double>(n) - middle) * (static_cast<double>(n) - middle);
      }
      for (std::size_t n = 0; n < length; ++n) piece[n] -= mean + slope / lever * (static_cast<double>(n) - middle);
      for (std::size_t tone = 0; tone < tones; ++tone) {
        const double real = std::inner_product(piece.begin(), piece.end(), &cosine[tone * length], 0.0);
        const double imaginary = std::inner_product(piece.begin(), piece.end(), &sine[tone * length], 0.0);
        power[tone] += real * real + imaginary * imaginary;
      }
    }
  };
  if (!forEachTask(static_cast<int>(even.cells), threads, progress, say<"Looking for a rhythm in the images">(), measure)) return {};
  spectrum.power.assign(tones, 0.0);
  for (const auto& power : ofCell)
    for (std::size_t tone = 0; tone < tones; ++tone) spectrum.power[tone] += power[tone];
  return spectrum;
}

/// The tone in [lowest, highest] that stands out most of its neighbours, up to a factor of 1.8 below and above. A moved probe makes a
/// broad spectrum that falls with frequency; the median of the logarithms keeps to it.
struct Tone {
  double frequency_hz = 0.0;
  double ratio = 0.0;  ///< its power over that of its neighbours
};
Tone strongestTone(const Spectrum& spectrum, double lowest_hz, double highest_hz) {
  const auto frequencyOf = [&](std::size_t tone) { return spectrum.first_hz + static_cast<double>(tone) * spectrum.step_hz; };
  std::vector<double> ratios(spectrum.power.size(), 0.0);
  for (std::size_t tone = 0; tone < ratios.size(); ++tone) {
    const double f_hz = frequencyOf(tone);
    if (f_hz < lowest_hz || f_hz > highest_hz || spectrum.power[tone] <= 0.0) continue;
    std::vector<double> below, above;
    for (std::size_t other = 0; other < ratios.size(); ++other) {
      const double g_hz = frequencyOf(other);
      if (std::abs(g_hz - f_hz) < 0.9 * spectrum.resolution_hz || spectrum.power[other] <= 0.0) continue;
      if (g_hz < f_hz && g_hz >= f_hz / 1.8) below.push_back(std::log(spectrum.power[other]));
      if (g_hz > f_hz && g_hz <= f_hz * 1.8) above.push_back(std::log(spectrum.power[other]));
    }
    // Where the record is too short for neighbours below, those above would make any falling spectrum a peak.
    if (below.empty() || above.empty()) continue;
    ratios[tone] = spectrum.power[tone] / std::exp(0.5 * (medianOrZero(below) + medianOrZero(above)));
  }
  Tone best;
  double largest = 0.0;
  for (std::size_t tone = 1; tone + 1 < ratios.size(); ++tone) {
    // Overtones of a pulse may stand out more than the pulse itself, but hold less power.
    const bool peak = spectrum.power[tone] > spectrum.power[tone - 1] && spectrum.power[tone] >= spectrum.power[tone + 1];
    if (!peak || ratios[tone] < 2.0 || spectrum.power[tone] * (1.0 - 1.0 / ratios[tone]) <= largest) continue;
    largest = spectrum.power[tone] * (1.0 - 1.0 / ratios[tone]);
    best = {frequencyOf(tone), ratios[tone]};
  }
  return best;
}

struct Window {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::array<std::vector<double>, kComponents> components;  ///< over time, of unit length
  std::array<double, kComponents> size{};                   ///< spread of each, as a share of the first one's
};

/// The first principal components over time of a window, by subspace iteration from a fixed start.
void findComponents(const CycleCells& band, Window& window) {
  const std::size_t count = window.end - window.begin;
  std::vector<double> gram(count * count);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a; b < count; ++b) {
      const double* const first = band.row(window.begin + a);
      const double* const second = band.row(window.begin + b);
      gram[a * count + b] = gram[b * count + a] = std::inner_product(first, first + band.cells, second, 0.0);
    }
  auto& found = window.components;
  for (std::size_t c = 0; c < kComponents; ++c) {
    found[c].resize(count);
    for (std::size_t n = 0; n < count; ++n) found[c][n] = std::cos(0.37 + 1.7 * static_cast<double>(c + 1) * static_cast<double>(n));
  }
  std::vector<double> next(count);
  for (int round = 0; round < 40; ++round)
    for (std::size_t c = 0; c < kComponents; ++c) {
      for (std::size_t a = 0; a < count; ++a) next[a] = std::inner_product(found[c].begin(), found[c].end(), &gram[a * count], 0.0);
      for (std::size_t d = 0; d < c; ++d) {
        const double along = std::inner_product(next.begin(), next.end(), found[d].begin(), 0.0);
        for (std::size_t n = 0; n < count; ++n) next[n] -= along * found[d][n];
      }
      const double length = std::sqrt(std::inner_product(next.begin(), next.end(), next.begin(), 0.0));
      for (std::size_t n = 0; n < count; ++n) found[c][n] = length > 0.0 ? next[n] / length : 0.0;
      window.size[c] = length;  // the eigenvalue, a variance
    }
  for (std::size_t c = kComponents; c-- > 0;) window.size[c] = window.size[0] > 0.0 ? std::sqrt(window.size[c] / window.size[0]) : 0.0;
}

std::vector<Window> windowsOf(std::size_t moments, std::size_t length) {
  std::vector<Window> windows;
  length = std::min(length, moments);
  const std::size_t hop = std::max<std::size_t>(1, length / 2);
  for (std::size_t begin = 0;; begin += hop) {
    if (begin + length >= moments) {
      windows.push_back({moments - length, moments, {}});
      return windows;
    }
    windows.push_back({begin, begin + length, {}});
  }
}

/// Joins the windows' signals: each has the sign that fits what stands before it, and they fade into one another.
/// @return the signal and the smallest correlation in an overlap
std::pair<std::vector<double>, double> joined(const std::vector<Window>& windows, const std::vector<std::size_t>& chosen,
                                              std::size_t moments) {
  std::vector<double> sum(moments, 0.0), weight(moments, 0.0);
  double weakest = 1.0;
  for (std::size_t w = 0; w < windows.size(); ++w) {
    const auto& part = windows[w].components[chosen[w]];
    const std::size_t begin = windows[w].begin;
    double both = 0.0, before = 0.0, own = 0.0;
    for (std::size_t n = 0; n < part.size(); ++n) {
      if (weight[begin + n] <= 0.0) continue;
      const double there = sum[begin + n] / weight[begin + n];
      both += there * part[n];
      before += there * there;
      own += part[n] * part[n];
    }
    if (w > 0) weakest = std::min(weakest, before * own > 0.0 ? std::abs(both) / std::sqrt(before * own) : 0.0);
    const double scale = (both < 0.0 ? -1.0 : 1.0) * std::sqrt(static_cast<double>(part.size()));
    for (std::size_t n = 0; n < part.size(); ++n) {
      const double fade = static_cast<double>(std::min(n, part.size() - 1 - n) + 1);
      sum[begin + n] += fade * scale * part[n];
      weight[begin + n] += fade;
    }
  }
  for (std::size_t n = 0; n < moments; ++n) sum[n] /= weight[n];
  return {std::move(sum), weakest};
}

/// Sum of the cubed slopes: above 0 when rises are steeper than falls.
double riseAgainstFall(std::span<const double> values) {
  double sum = 0.0;
  for (std::size_t n = 1; n < values.size(); ++n) sum += std::pow(values[n] - values[n - 1], 3.0);
  return sum;
}

tl::unexpected<Error> refuse(const Message& why) {
  return failure(ErrorCode::unsupported, say<"The images cannot gate: %1; use a recorded signal or do without gating.">(why),
                 {{"field", "images"}});
}

/// Times a minute.
struct RhythmRange {
  double lowest_perMin;
  double highest_perMin;
};

RhythmRange rangeOf(const ImageGateOptions& options) {
  const bool heart = options.rhythm == Rhythm::heart;
  return {.lowest_perMin = options.lowest_perMin > 0.0 ? options.lowest_perMin
                           : heart                     ? 40.0
                                                       : 5.0,
          .highest_perMin = options.highest_perMin > 0.0 ? options.highest_perMin
                            : heart                      ? 180.0
                                                         : 40.0};
}

/// Frames at different times, in their order.
struct FrameTimes {
  std::vector<double> times_s;
  std::vector<std::size_t> kept;
};

Result<FrameTimes> timedFrames(std::span<const ImageView<const std::uint8_t>> frames, std::span<const double> time_s) {
  if (frames.size() != time_s.size())
    return failure(ErrorCode::badField,
                   say<"There are %1 frames and %2 times; give one time for each frame.">(frames.size(), time_s.size()),
                   {{"field", "time"}});
  FrameTimes timed;
  auto& [times_s, kept] = timed;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    if (frames[n].width != frames[0].width || frames[n].height != frames[0].height || frames[n].width < 1 || frames[n].height < 1)
      return failure(ErrorCode::badField, say<"Frame %1 has another size than frame 0; gate frames of one size.">(n),
                     {{"field", "pixels"}});
    if (!std::isfinite(time_s[n]))
      return failure(ErrorCode::badField, say<"Frame %1 has no time; gate a recording whose frames all have one.">(n), {{"field", "time"}});
    if (!times_s.empty() && time_s[n] < times_s.back())
      return failure(ErrorCode::badField, say<"Time runs backwards at frame %1; put the recording in order of time.">(n),
                     {{"field", "time"}});
    if (!times_s.empty() && time_s[n] == times_s.back()) continue;
    times_s.push_back(time_s[n]);
    kept.push_back(n);
  }
  if (times_s.size() < 8) return refuse(say<"there are fewer than eight frames at different times">());
  return timed;
}

/// Narrows the range to what the frames' distance allows to be seen.
Result<void> fitRange(const std::vector<double>& times_s, double step_s, RhythmRange& range) {
  const double duration_s = times_s.back() - times_s.front();
  range.highest_perMin = std::min(range.highest_perMin, 60.0 / (3.0 * step_s));
  if (range.highest_perMin <= 1.2 * range.lowest_perMin)
    return refuse(say<"with %1 frames a second the rhythm falls between them">(textOf(std::round(10.0 / step_s) / 10.0)));
  if (duration_s < 3.0 * 60.0 / range.highest_perMin || duration_s / step_s > 1e6)
    return refuse(say<"the recording is shorter than three cycles or has gaps of many times its length">());
  return {};
}

tl::unexpected<Error> gatingStopped() { return failure(ErrorCode::cancelled, say<"The gating was stopped before it was complete.">()); }

Result<CycleCells> reducedFrames(std::span<const ImageView<const std::uint8_t>> frames, const std::vector<std::size_t>& kept, int threads,
                                 Progress& progress) {
  const int across = std::min(kCycleCells, frames[0].width), down = std::min(kCycleCells, frames[0].height);
  CycleCells raw{kept.size(), static_cast<std::size_t>(across * down), {}};
  raw.value.resize(raw.moments * raw.cells);
  if (!forEachTask(static_cast<int>(kept.size()), threads, progress, say<"Looking for a rhythm in the images">(), [&](int task) {
        const auto n = static_cast<std::size_t>(task);
        reduce(frames[kept[n]], across, down, raw.row(n));
      }))
    return gatingStopped();
  bool changes = false;
  for (std::size_t n = 1; n < raw.moments && !changes; ++n) changes = !std::equal(raw.row(n), raw.row(n) + raw.cells, raw.row(0));
  if (!changes) return refuse(say<"they do not change">());
  return raw;
}

tl::unexpected<Error> tooWeak(double confidence, const RhythmRange& range, const ImageGateOptions& options) {
  return refuse(say<"nothing in them repeats at %1 to %2 times a minute (confidence %3, %4 is needed)">(
      textOf(range.lowest_perMin), textOf(std::round(range.highest_perMin)), textOf(std::round(100.0 * confidence) / 100.0),
      textOf(options.leastConfidence)));
}

/// One value a moment that rises and falls with the cycle.
struct CycleSignal {
  std::vector<double> values;
  double meanRepeat = 0.0;    ///< autocorrelation after one period, mean of the windows' own
  double weakestJoint = 1.0;  ///< correlation where windows meet
};

/// Of each window the component that repeats most, joined and turned so that rises are steeper than falls.
CycleSignal signalOf(const std::vector<Window>& windows, std::size_t moments, std::size_t lag) {
  CycleSignal signal;
  std::vector<std::size_t> chosen;
  for (const Window& window : windows) {
    const auto score = [&](std::size_t c) { return window.size[c] * autocorrelation(window.components[c], lag); };
    std::size_t best = 0;
    for (std::size_t c = 1; c < kComponents; ++c)
      if (score(c) > score(best)) best = c;
    chosen.push_back(best);
    signal.meanRepeat += autocorrelation(window.components[best], lag) / static_cast<double>(windows.size());
  }
  std::tie(signal.values, signal.weakestJoint) = joined(windows, chosen, moments);
  if (riseAgainstFall(signal.values) < 0.0)
    for (double& value : signal.values) value = -value;
  return signal;
}

}  // namespace

Result<Cycles> findCyclesInImages(std::span<const ImageView<const std::uint8_t>> frames, std::span<const double> time_s,
                                  const ImageGateOptions& options, Progress& progress) {
  const auto timed = timedFrames(frames, time_s);
  if (!timed) return passOn(timed.error());
  const double step_s = medianStep_s(timed->times_s);
  RhythmRange range = rangeOf(options);
  if (const auto fits = fitRange(timed->times_s, step_s, range); !fits) return passOn(fits.error());

  PartOfProgress reducing(progress, 0.0, 0.4), measuring(progress, 0.4, 0.7), finding(progress, 0.7, 1.0);
  const auto raw = reducedFrames(frames, timed->kept, options.threads, reducing);
  if (!raw) return passOn(raw.error());
  CycleCells even = evenCells(*raw, timed->times_s, step_s);
  const Spectrum spectrum = spectrumOf(even, step_s, kPiece_periods * 60.0 / range.lowest_perMin,
                                       std::min(0.48 / step_s, 2.0 * range.highest_perMin / 60.0), options.threads, measuring);
  if (spectrum.power.empty()) return gatingStopped();
  const Tone tone = strongestTone(spectrum, range.lowest_perMin / 60.0, range.highest_perMin / 60.0);
  if (tone.ratio <= 0.0) return tooWeak(0.0, range, options);
  const double standsOut = 1.0 - 1.0 / tone.ratio, period_s = 1.0 / tone.frequency_hz;
  if (standsOut < options.leastConfidence) return tooWeak(standsOut, range, options);

  const CycleCells band = bandOf(std::move(even), step_s, period_s);
  auto windows = windowsOf(band.moments, static_cast<std::size_t>(kWindow_periods * period_s / step_s));
  if (!forEachTask(static_cast<int>(windows.size()), options.threads, finding, say<"Looking for a rhythm in the images">(),
                   [&](int task) { findComponents(band, windows[static_cast<std::size_t>(task)]); }))
    return gatingStopped();
  const auto lag = static_cast<std::size_t>(std::lround(period_s / step_s));
  CycleSignal signal = signalOf(windows, band.moments, lag);
  const double confidence = std::min({standsOut, signal.meanRepeat, autocorrelation(signal.values, lag)});
  if (confidence < options.leastConfidence) return tooWeak(confidence, range, options);
  Cycles cycles = cyclesFrom(maximaOf({timed->times_s.front(), step_s, std::move(signal.values)}, period_s), options.irregularShare, false);
  if (cycles.starts_s.size() < 2) return refuse(say<"fewer than two cycles can be seen">());
  cycles.confidence = confidence;
  cycles.notes.emplace_back(say<"Phases were taken from the images: which moment phase 0 is, they do not say.">());
  if (signal.weakestJoint < 0.3)
    cycles.notes.emplace_back(
        say<"What moves changes along the sweep; the phase may slip where one part of it ends and the next begins.">());
  return cycles;
}

}  // namespace ew
