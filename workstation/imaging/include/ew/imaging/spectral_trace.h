#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "ew/imaging/spectrogram.h"

namespace ew {

/// Of one column of a spectrum, velocities along the line as shares of the Nyquist velocity, towards the probe positive; beyond 1 where the
/// baseline was moved and the spectrum goes on around the scale's end.
struct TracePoint {
  double time_s = 0.0;
  double forward = 0.0;      ///< the greatest velocity towards the probe, >= 0
  double backward = 0.0;     ///< away from it, <= 0
  double mean = 0.0;         ///< weighted by power
  double sectionMean = 0.0;  ///< over the vessel's section (TraceRule::radiusOverSlice); as `mean` where that is not known
  [[nodiscard]] double greatest() const { return forward >= -backward ? forward : backward; }
};

/// What an automatic trace goes by.
struct TraceRule {
  double noise = 0.0;       ///< power of a bin without signal; 0: the tenth percentile of all says it
  double aboveNoise = 8.0;  ///< a bin counts as signal from (1 + this / sqrt(n)) times the noise on, n columns being averaged
  double smooth_s = 0.012;  ///< columns on both sides whose powers are averaged, before anything is found in them
  double baseline = 0.0;    ///< SpectralDoppler::baseline: where the spectrum goes around
  /// Radius of the vessel, across the slice, over the standard deviation of the slice's power; 0: not known. A slice thinner than the
  /// vessel sees its fast middle more than its slow rim, so that the mean of a spectrum is up to a third above the section's.
  double radiusOverSlice = 0.0;
  double filtered = 0.0;  ///< share of the Nyquist velocity below which the wall filter took everything
};

/// The envelope of every column that a spectrogram keeps. The greatest velocity is where power has fallen to half of its level below: right
/// for a parabola, whose spectrum is even up to there (Vilkomerson, Ricci, Tortoli, IEEE IUS 2011), and within a bin for a plug, whose
/// spectrum is one line. What smoothing, window and speckle widen is in both halves of the slope.
/// @param from_s columns before are passed over; each takes some 5 us
[[nodiscard]] std::vector<TracePoint> tracedBy(const Spectrogram& spectrogram, const TraceRule& rule,
                                               double from_s = -std::numeric_limits<double>::infinity());

/// Of one averaged spectrum. The section's mean takes velocities as falling from the axis to the wall: the fastest share of the power then
/// comes from within a radius, by how much of it a slice with a Gaussian of power sees, r exp(-q) I0(q) with q = r^2 / 4 sigma^2; in a gate
/// as long as the vessel is wide. Ours. @param powers by bin, as Spectrogram::powers
[[nodiscard]] TracePoint traceOf(std::span<const float> powers, double noise, const TraceRule& rule);

/// What is measured of an envelope over whole beats; in the unit of the values.
struct WaveformValues {
  double peakSystolic = 0.0;        ///< PSV: of every beat the farthest from 0, on average
  double endDiastolic = 0.0;        ///< EDV: just before the upstroke
  double least = 0.0;               ///< against the direction of the peak, or the least with it
  double timeAverageMaximum = 0.0;  ///< TAMX, with the sign of what flows back
  double timeAverageMean = 0.0;     ///< TAMEAN, of the means
  double acceleration_s = 0.0;      ///< from the foot of the upstroke to the peak
  double heartPeriod_s = 0.0;
  int beats = 0;
  [[nodiscard]] double resistiveIndex() const;                        ///< (PSV - EDV) / PSV
  [[nodiscard]] std::optional<double> pulsatilityIndex() const;       ///< (PSV - EDV or, where flow reverses, least) / TAMX
  [[nodiscard]] std::optional<double> systolicOverDiastolic() const;  ///< none without diastolic flow
  [[nodiscard]] double accelerationIndex() const;                     ///< (PSV - EDV) / acceleration time, per s
};
/// One beat is enough; nothing where none is whole, or where the envelope does not pulse (by less than a sixth of its peak).
/// @param times_s rising @param envelope, mean as many
[[nodiscard]] std::optional<WaveformValues> waveformOf(std::span<const double> times_s, std::span<const double> envelope,
                                                       std::span<const double> mean);

}  // namespace ew
