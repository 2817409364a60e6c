#pragma once

#include <array>

#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"

namespace ew::detail {

inline constexpr double kLateralSigmas = 3.0;  ///< how far beside the outermost lines, in standard deviations, tissue is seen

/// The two-way point spread function of a probe with its settings: Gaussian in every direction, amplitude exp(-x^2 / 2 sigma^2). With z the
/// depth, L the wavelength, D the aperture, F a transmit focus and s = 1.4 L / 2.355 (width of an apodised aperture's focus a F-number):
///   transmit   t = s N sqrt(1 + ((z - F) / Z)^2), N = max(2, F / D), Z = 2 pi (s N)^2 / L; each depth from the focus that is narrowest
///   receive    r = s max(N_r, z / D): focused at every depth, N_r the effect's F-number
///   lateral    t r / sqrt(t^2 + r^2), times the width of the line filter (machines add up neighbouring lines)
///   elevation  w sqrt(1 + ((z - F_e) / Z_e)^2): a lens, opened to the elements' height at the face
/// A beam carries the same energy wherever it is focused, so that tissue is brighter where it is narrow: intensity r / sqrt(t^2 + r^2).
/// The machine's own depth compensation is set for the usual focus (half the depth), which therefore shows tissue as it is.
/// Harmonics: L is twice as long on transmission, and what is received grew as the square of what was sent, so its beam is narrower by
/// sqrt(2) than that of the wave that was sent; side lobes, whose squares are small, fall by half as many decibels again (haze). It has to
/// grow: amplitude z / (z + 57 L), 25 mm at 3.5 MHz, shown as tissue is at half the depth, so that layers near the face and their copies
/// further down are faint. Losses are those of the carrier: half of it, squared, on the way in, itself on the way out (attenuation is
/// linear in frequency). Source: quasi-linear second harmonic, Hamilton & Blackstock, Nonlinear Acoustics (1998), ch. 3 (source term,
/// attenuated plane waves); the 57 wavelengths, where growth by distance gives way to spreading, are ours (distances grow with 1 /
/// frequency). Source: Gaussian beams as in Cobbold, Foundations of Biomedical Ultrasound (2007), ch. 3. Ours departs: no side lobes (the
/// haze of echo_lines.h stands for them), one carrier at every depth.
struct EchoBeams {
  double wavelength_mm = 0.44;
  double axialSigma_mm = 0.2;  ///< of each look
  int looks = 1;
  double pulseSigma_mm = 0.2;  ///< of the whole pulse, with one look

  struct Transmit {
    double focus_mm = 80.0;
    double waist_mm = 1.0;
    double range_mm = 40.0;
    bool operator==(const Transmit&) const = default;
    [[nodiscard]] double sigma_mm(double depth_mm, bool widens) const;
  };
  std::array<Transmit, kMostFoci> transmits{};
  int foci = 1;
  Transmit usual{};     ///< where the machine focuses when nobody says where
  bool focuses = true;  ///< else as narrow everywhere as at the focus
  double receivePerDepth = 0.01;
  double receiveLeast_mm = 0.2;
  double lateralScale = 1.0;
  double focusStrength = 1.0;  ///< of what the focus does to the brightness, 0..1
  bool isHarmonic = false;
  double shownAsIs_mm = 80.0;  ///< where harmonics are as bright as the carrier's own echoes

  bool isSlice = true;  ///< the elevational beam is as thick as the probe's; else as thin everywhere as at its focus
  double lensFocus_mm = 80.0;
  double lensWaist_mm = 1.0;
  double lensNearRange_mm = 20.0;
  double lensFarRange_mm = 40.0;
  bool operator==(const EchoBeams&) const = default;

  [[nodiscard]] double lateralSigma_mm(double depth_mm) const;
  /// The same with the usual focus.
  [[nodiscard]] double usualLateralSigma_mm(double depth_mm) const;
  [[nodiscard]] double elevationalSigma_mm(double depth_mm) const;
  /// How much brighter focus and harmonics make echoes. The foci, than the usual one does: 0 when it is the usual one, within
  /// kMostFocusGain_db both ways.
  [[nodiscard]] double beamGain_db(double depth_mm) const;
  /// Looks are taken at wave numbers (both ways) this far apart: intensities of neighbours correlate by 1/e^2.
  [[nodiscard]] double lookStep_radPerMm() const { return 2.0 / axialSigma_mm; }

 private:
  [[nodiscard]] double focusGain_db(double depth_mm) const;
  [[nodiscard]] double transmitSigma_mm(double depth_mm) const;
  [[nodiscard]] double twoWaySigma_mm(double transmit_mm, double depth_mm) const;
};

/// @param knobs within limits, with a carrier the probe has
[[nodiscard]] EchoBeams echoBeamsOf(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm);

/// What a machine's compensation leaves of the focus at most (ours: a beam of Gaussians would say more far from a shallow focus).
inline constexpr double kMostFocusGain_db = 6.0;

/// Full width at half maximum over the standard deviation of a Gaussian.
inline constexpr double kFwhmOfSigma = 2.3548200450309493;

}  // namespace ew::detail
