#pragma once

#include "ew/imaging/probe.h"
#include "ew/phantom/virtual_scanner.h"

namespace ew::phantom {

inline constexpr double kTransmitFNumber = 2.0;  ///< how far an aperture opens with depth before it is as wide as the probe allows

/// The two-way point spread function of a probe with its settings: Gaussian in every direction, amplitude exp(-x^2 / 2 sigma^2).
/// See resources/docs/science/forward-model.md for the equations.
struct Beams {
  double wavelength_mm = 0.5;  ///< at the assumed speed
  double axialSigma_mm = 0.2;  ///< of each look
  /// Looks are taken at wave numbers (both ways) this far apart: fields of neighbours correlate by 1/e, intensities by 1/e^2.
  [[nodiscard]] double lookStep_radPerMm() const { return 2.0 / axialSigma_mm; }

  // Lateral: a transmit beam with one focus times a receive beam focused at every depth.
  double transmitFocus_mm = 80.0;
  double transmitWaist_mm = 1.0;        ///< standard deviation of the one-way amplitude at the focus
  double transmitRange_mm = 40.0;       ///< Rayleigh range of that waist
  double receiveSpreadPerDepth = 0.01;  ///< one-way standard deviation per depth where the aperture is fully open
  double receiveLeast_mm = 0.2;         ///< where the aperture opens with depth (constant F-number)
  bool receivesAsItSends = false;       ///< one element: the transmit beam counts twice

  // Elevational: a lens.
  double lensFocus_mm = 80.0;
  double lensWaist_mm = 1.0;       ///< two-way standard deviation at the focus
  double lensNearRange_mm = 20.0;  ///< how fast it widens from the focus to the face
  double lensFarRange_mm = 40.0;   ///< and beyond the focus

  [[nodiscard]] double lateralSigma_mm(double depth_mm) const;
  [[nodiscard]] double elevationalSigma_mm(double depth_mm) const;
  /// The echo of a point off the plane by z arrives as if it lay z^2 times this deeper, 1 / mm.
  [[nodiscard]] double elevationalCurvature_perMm(double depth_mm) const;
};

/// @param options with every 0 replaced
[[nodiscard]] Beams beamsOf(const Probe& probe, const FormationOptions& options);

/// Full width at half maximum over the standard deviation of a Gaussian.
inline constexpr double kFwhmOfSigma = 2.3548200450309493;

}  // namespace ew::phantom
