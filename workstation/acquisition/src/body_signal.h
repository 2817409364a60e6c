#pragma once

#include <span>
#include <string>
#include <vector>

#include "ew/acquisition/gating.h"

namespace ew {

/// Samples at start_s + n * step_s.
struct EvenSignal {
  double start_s = 0.0;
  double step_s = 1.0;
  std::vector<double> value;
};

/// The signal without values that are no numbers and without repeated times.
/// @param name in sentences: say<"ECG">()
/// @error badField (sizes that differ, time backwards), unsupported (fewer than four samples, constant)
[[nodiscard]] Result<BodySignal> usable(const BodySignal& signal, const Message& name);

/// Median time between samples.
[[nodiscard]] double medianStep_s(std::span<const double> time_s);
[[nodiscard]] double medianOrZero(std::vector<double> values);

/// Linear interpolation at even steps from the first to the last sample; where samples lie closer than the step they are averaged first.
[[nodiscard]] EvenSignal evenly(const BodySignal& signal, double step_s);

/// Means over `samples` (made odd) around each sample, cut at the ends.
[[nodiscard]] std::vector<double> movingMean(std::span<const double> values, std::size_t samples);

/// Butterworth filter of second order run forwards and backwards, so without delay. Corner below half the rate.
enum class FilterKind { lowPass, highPass };
[[nodiscard]] std::vector<double> filteredBothWays(std::span<const double> values, FilterKind kind, double corner_hz, double rate_hz);

/// Correlation of a signal of mean 0 with itself `lag` samples later, -1..1.
[[nodiscard]] double autocorrelation(std::span<const double> values, std::size_t lag);

/// The first lag in [lowest, highest] with a local maximum of at least 0.85 of the largest there, and its height; 0 when there is none.
struct Repeat {
  double lag = 0.0;
  double height = 0.0;
};
[[nodiscard]] Repeat firstRepeat(std::span<const double> heightOfLag, std::size_t lowest);

/// Times of the maxima of a signal of mean 0 and known period: one in about 0.7 periods, above 0.3 of the signal's spread.
[[nodiscard]] std::vector<double> maximaOf(const EvenSignal& signal, double period_s);

/// Judges the cycles between starts and bridges what was missed.
[[nodiscard]] Cycles cyclesFrom(std::vector<double> starts_s, double irregularShare, bool bridge);

}  // namespace ew
