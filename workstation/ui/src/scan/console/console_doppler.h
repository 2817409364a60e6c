#pragma once

#include "scan/console/console_panel.h"

namespace ew::ui {

/// What the console's parts of colour and of spectral Doppler share.
class ConsolePanel::DopplerPart {
 public:
  explicit DopplerPart(ConsolePanel& panel) : panel_(panel), session_(panel.session_) {}
  virtual ~DopplerPart() = default;
  DopplerPart(const DopplerPart&) = delete;
  DopplerPart& operator=(const DopplerPart&) = delete;

 protected:
  /// The case says how blood flows.
  [[nodiscard]] bool isKnown() const { return session_.subject() && session_.subject()->showsColour(); }
  [[nodiscard]] virtual bool isOn() const = 0;
  /// @param wholeName what a reader of the screen says: elsewhere it stands beside those of the image
  QSlider* addSlider(QBoxLayout* rows, SliderParts parts, const QString& wholeName);
  /// Whole degrees that a probe steers Doppler.
  [[nodiscard]] int mostSteering_deg() const;

  ConsolePanel& panel_;
  Session& session_;
};

/// A scale in steps of the same share of itself, for veins as for a stenosis.
inline constexpr double kLowestPrf_hz = 100.0;
[[nodiscard]] double prfAt_hz(int step);
[[nodiscard]] double stepsToPrf(double prf_hz);
[[nodiscard]] QString speedText(double velocity_mmPerS);
/// Where a spectrum begins: in the middle of the colour box, where there is one and the eye is already, else of the image, with a scale for
/// arteries.
[[nodiscard]] SpectralDoppler firstSpectrum(const Probe& probe, const Knobs& knobs);

}  // namespace ew::ui
