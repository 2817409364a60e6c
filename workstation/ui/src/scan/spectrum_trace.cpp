#include "scan/spectrum_trace.h"

#include <QSettings>
#include <algorithm>
#include <cmath>

#include "scan/frame_timer.h"
#include "scan/scan_contents.h"

namespace ew::ui {
namespace {

constexpr double kEvery_s = 0.25;
constexpr double kUnsure_s = 0.05;  // longer than what a trace averages on either side
constexpr double kAtEnd = 0.9;      // of the scale
const auto kShownSetting = QStringLiteral("spectrumEnvelope");

/// Where blood that is too fast comes back at the other end, that end is no velocity: most of the flow says which it is.
std::vector<double> envelopeOf(const std::vector<TracePoint>& points, double baseline) {
  double sum = 0.0;
  for (const TracePoint& point : points) sum += point.mean;
  const double sign = sum < 0.0 ? -1.0 : 1.0, otherEnd = 1.0 - sign * baseline;
  std::vector<double> envelope;
  for (const TracePoint& point : points) {
    const double own = sign > 0.0 ? point.forward : -point.backward, other = sign > 0.0 ? -point.backward : point.forward;
    envelope.push_back(sign * (other > own && other < kAtEnd * otherEnd ? -other : own));
  }
  return envelope;
}

}  // namespace

SpectrumReading readingOf(const Spectrogram& spectrogram, const Knobs& knobs) { return readingOf(spectrogram, knobs, {}); }

SpectrumReading readingOf(const Spectrogram& spectrogram, const Knobs& knobs, const SpectrumReading& before) {
  if (spectrogram.columns() == 0) return {};
  const SpectrumSetting& setting = spectrogram.setting();
  // Of the range of shifts, PRF wide, the filter takes its edge on both sides of 0.
  const TraceRule rule{.baseline = setting.baseline, .filtered = 2.0 * knobs.spectral->wallFilter_hz / setting.prf_hz};
  SpectrumReading reading;
  double from_s = spectrogram.timeOf(0);
  if (!before.points.empty()) {
    // The last columns had no neighbours on one side.
    const double sure_s = std::max(from_s, before.points.back().time_s - kUnsure_s);
    for (const TracePoint& point : before.points)
      if (point.time_s >= from_s && point.time_s < sure_s) reading.points.push_back(point);
    from_s = sure_s;
  }
  for (const TracePoint& point : tracedBy(spectrogram, rule, from_s - kUnsure_s))
    if (point.time_s >= from_s) reading.points.push_back(point);
  reading.envelope = envelopeOf(reading.points, setting.baseline);
  std::vector<double> times_s, mean;
  for (const TracePoint& point : reading.points) {
    times_s.push_back(point.time_s);
    mean.push_back(point.mean);
  }
  reading.values = waveformOf(times_s, reading.envelope, mean);
  return reading;
}

const SpectrumReading* SpectrumTrace::reading() {
  const Spectrogram* spectrogram = scan_.subject() ? scan_.seen().spectrogram() : nullptr;
  if (spectrogram == nullptr || spectrogram->columns() == 0) {
    of_.reset();
    return nullptr;
  }
  Knobs knobs = scan_.settings().knobs;
  if (!knobs.spectral) knobs.spectral.emplace();
  const Source now{spectrogram->setting(), knobs.spectral->wallFilter_hz, spectrogram->timeOf(0),
                   spectrogram->timeOf(spectrogram->columns() - 1), spectrogram->columns()};
  // Another scale or another image is another spectrum; the same that goes on can wait.
  const bool goesOn = of_ && scan_.isLive() && of_->setting == now.setting && of_->wallFilter_hz == now.wallFilter_hz &&
                      now.first_s >= of_->first_s && now.last_s >= of_->last_s;
  const double now_s = frames_.now_s();
  if (of_ != now && (!goesOn || now_s - made_s_ >= kEvery_s)) {
    reading_ = goesOn ? readingOf(*spectrogram, knobs, reading_) : readingOf(*spectrogram, knobs);
    made_s_ = now_s;
    of_ = now;
  }
  return &reading_;
}

bool SpectrumTrace::isShown() const { return QSettings().value(kShownSetting, true).toBool(); }

void SpectrumTrace::setShown(bool isShown) {
  if (isShown == this->isShown()) return;
  QSettings().setValue(kShownSetting, isShown);
  Q_EMIT changed();
}

}  // namespace ew::ui
