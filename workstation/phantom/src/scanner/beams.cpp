#include "scanner/beams.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ew::phantom {
namespace {

// One-way width of the focus of an apodised aperture, in wavelengths times F-number; 1.21 without apodisation (Cobbold 2007, ch. 3).
constexpr double kApodisedWidth = 1.4;
constexpr double kReceiveFNumber = 1.5;
constexpr double kNoRange_mm = 1e6;  // of a beam that does not widen

/// Rayleigh range of a Gaussian beam whose one-way amplitude is exp(-x^2 / w^2), w^2 = 2 sigma^2 (Cobbold 2007, ch. 3).
double rayleighRange_mm(double oneWaySigma_mm, double wavelength_mm) {
  return 2.0 * std::numbers::pi * oneWaySigma_mm * oneWaySigma_mm / wavelength_mm;
}

}  // namespace

double Beams::lateralSigma_mm(double depth_mm) const {
  const double off = (depth_mm - transmitFocus_mm) / transmitRange_mm;
  const double transmit = transmitWaist_mm * std::sqrt(1.0 + off * off);
  const double receive = receivesAsItSends ? transmit : std::max(receiveLeast_mm, receiveSpreadPerDepth * depth_mm);
  return transmit * receive / std::sqrt(transmit * transmit + receive * receive);
}

double Beams::elevationalSigma_mm(double depth_mm) const {
  const double off = (depth_mm - lensFocus_mm) / (depth_mm < lensFocus_mm ? lensNearRange_mm : lensFarRange_mm);
  return lensWaist_mm * std::sqrt(1.0 + off * off);
}

double Beams::elevationalCurvature_perMm(double depth_mm) const {
  const double off = depth_mm - lensFocus_mm, range = depth_mm < lensFocus_mm ? lensNearRange_mm : lensFarRange_mm;
  return 0.5 * off / (off * off + range * range);
}

Beams beamsOf(const Probe& probe, const FormationOptions& options) {
  Beams beams;
  beams.wavelength_mm = options.assumedSpeed_mPerS * 1e3 / options.carrier_hz;
  beams.axialSigma_mm = 0.25 * (options.looks + 1) * options.pulseCycles * beams.wavelength_mm / kFwhmOfSigma;

  const double width = kApodisedWidth * beams.wavelength_mm / kFwhmOfSigma;
  beams.receivesAsItSends = probe.kind == ProbeKind::sweptSector;
  beams.transmitFocus_mm = beams.receivesAsItSends ? probe.elevationalFocus_mm : options.focus_mm;
  const double fNumber = std::max(kTransmitFNumber, beams.transmitFocus_mm / probe.aperture_mm);
  beams.transmitWaist_mm = width * fNumber;
  beams.transmitRange_mm = rayleighRange_mm(beams.transmitWaist_mm, beams.wavelength_mm);
  beams.receiveSpreadPerDepth = width / probe.aperture_mm;
  beams.receiveLeast_mm = width * kReceiveFNumber;

  beams.lensFocus_mm = probe.elevationalFocus_mm;
  beams.lensWaist_mm = probe.elevationalThickness_mm / kFwhmOfSigma;
  const double opening = probe.elevationalAperture_mm / probe.elevationalThickness_mm;
  beams.lensNearRange_mm = opening > 1.0 ? beams.lensFocus_mm / std::sqrt(opening * opening - 1.0) : kNoRange_mm;
  beams.lensNearRange_mm = std::min(beams.lensNearRange_mm, kNoRange_mm);
  beams.lensFarRange_mm = rayleighRange_mm(std::numbers::sqrt2 * beams.lensWaist_mm, beams.wavelength_mm);
  return beams;
}

}  // namespace ew::phantom
