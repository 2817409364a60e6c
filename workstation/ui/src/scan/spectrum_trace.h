#pragma once

#include <QObject>
#include <optional>
#include <utility>
#include <vector>

#include "ew/imaging/knobs.h"
#include "ew/imaging/spectral_trace.h"

namespace ew::ui {

class FrameTimer;
struct ScanContents;

/// What is read off a spectrum; velocities along the line as shares of the Nyquist velocity, so that an angle changes none of them.
struct SpectrumReading {
  std::vector<TracePoint> points;
  std::vector<double> envelope;          ///< of each point the greatest velocity, as far as it is not around the scale's end
  std::optional<WaveformValues> values;  ///< none before a beat is whole
};
/// @param knobs with spectral
[[nodiscard]] SpectrumReading readingOf(const Spectrogram& spectrogram, const Knobs& knobs);
/// The same where a reading of earlier columns is known: only what came since is traced.
[[nodiscard]] SpectrumReading readingOf(const Spectrogram& spectrogram, const Knobs& knobs, const SpectrumReading& before);

/// The reading of the spectrum that is shown. All of it takes milliseconds, so that while the scan runs it grows, a few times a second.
class SpectrumTrace final : public QObject {
  Q_OBJECT

 public:
  /// @param scan,frames must live longer
  SpectrumTrace(const ScanContents& scan, const FrameTimer& frames) : scan_(scan), frames_(frames) {}

  /// Null without a spectrum.
  [[nodiscard]] const SpectrumReading* reading();
  /// Whether the envelope is drawn; remembered.
  [[nodiscard]] bool isShown() const;
  void setShown(bool isShown);

 Q_SIGNALS:
  void changed();

 private:
  /// What the reading was made of.
  struct Source {
    SpectrumSetting setting;
    double wallFilter_hz = 0.0;
    double first_s = 0.0, last_s = 0.0;
    int columns = 0;
    bool operator==(const Source&) const = default;
  };
  const ScanContents& scan_;
  const FrameTimer& frames_;
  SpectrumReading reading_;
  std::optional<Source> of_;
  double made_s_ = 0.0;
};

}  // namespace ew::ui
