#include "echo_beams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "probes/sound.h"

namespace ew::detail {
namespace {

constexpr double kApodisedWidth = 1.4;
constexpr double kFNumber = 2.0;             // of transmission, at least
constexpr double kNoRange_mm = 1e6;          // of a beam that does not widen
constexpr double kGrows_wavelengths = 57.0;  // way in which a harmonic reaches half of what it becomes
constexpr double kNearest_mm = 1.0;          // where it has something

double rayleighRange_mm(double oneWaySigma_mm, double wavelength_mm) {
  return 2.0 * std::numbers::pi * oneWaySigma_mm * oneWaySigma_mm / wavelength_mm;
}

}  // namespace

double EchoBeams::Transmit::sigma_mm(double depth_mm, bool widens) const {
  const double off = widens ? (depth_mm - focus_mm) / range_mm : 0.0;
  return waist_mm * std::sqrt(1.0 + off * off);
}

double EchoBeams::transmitSigma_mm(double depth_mm) const {
  double transmit = std::numeric_limits<double>::infinity();
  for (int n = 0; n < foci; ++n) transmit = std::min(transmit, transmits[static_cast<std::size_t>(n)].sigma_mm(depth_mm, focuses));
  return transmit;
}

double EchoBeams::twoWaySigma_mm(double transmit_mm, double depth_mm) const {
  const double receive = std::max(receiveLeast_mm, receivePerDepth * depth_mm);
  return lateralScale * transmit_mm * receive / std::sqrt(transmit_mm * transmit_mm + receive * receive);
}

double EchoBeams::lateralSigma_mm(double depth_mm) const { return twoWaySigma_mm(transmitSigma_mm(depth_mm), depth_mm); }
double EchoBeams::usualLateralSigma_mm(double depth_mm) const { return twoWaySigma_mm(usual.sigma_mm(depth_mm, focuses), depth_mm); }

double EchoBeams::focusGain_db(double depth_mm) const {
  if (!focuses || (foci == 1 && transmits[0] == usual)) return 0.0;
  const double receive = std::max(receiveLeast_mm, receivePerDepth * depth_mm);
  const double set = std::hypot(transmitSigma_mm(depth_mm), receive), with = std::hypot(usual.sigma_mm(depth_mm, true), receive);
  return focusStrength * kMostFocusGain_db * std::tanh(10.0 * std::log10(with / set) / kMostFocusGain_db);
}

double EchoBeams::beamGain_db(double depth_mm) const {
  if (!isHarmonic) return focusGain_db(depth_mm);
  const auto grown = [this](double way_mm) { return way_mm / (way_mm + kGrows_wavelengths * wavelength_mm); };
  return focusGain_db(depth_mm) + 20.0 * std::log10(grown(std::max(depth_mm, kNearest_mm)) / grown(shownAsIs_mm));
}

double EchoBeams::elevationalSigma_mm(double depth_mm) const {
  if (!isSlice) return lensWaist_mm;
  const double off = (depth_mm - lensFocus_mm) / (depth_mm < lensFocus_mm ? lensNearRange_mm : lensFarRange_mm);
  return lensWaist_mm * std::sqrt(1.0 + off * off);
}

EchoBeams echoBeamsOf(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm) {
  const LiveEchoesEffect effect = scene.liveEchoes.value_or(LiveEchoesEffect{});
  EchoBeams beams;
  beams.wavelength_mm = kSpeedOfSound_mmPerS / knobs.carrier_hz;
  beams.looks = effect.looks;
  beams.axialSigma_mm = 0.25 * (beams.looks + 1) * effect.pulseCycles * beams.wavelength_mm / kFwhmOfSigma;
  beams.pulseSigma_mm = 0.5 * effect.pulseCycles * beams.wavelength_mm / kFwhmOfSigma;

  const double width = kApodisedWidth * beams.wavelength_mm / kFwhmOfSigma;
  const double aperture_mm = effect.apertureShare * probe.aperture_mm;
  beams.foci = 0;
  beams.isHarmonic = knobs.harmonic;
  beams.shownAsIs_mm = 0.5 * depth_mm;
  const double sent = knobs.harmonic ? 2.0 : 1.0;  // wavelengths
  const auto focusedAt = [&](double focus_mm) -> EchoBeams::Transmit {
    const double waist = sent * width * std::max(kFNumber, focus_mm / aperture_mm);
    return {focus_mm, waist / std::sqrt(sent), rayleighRange_mm(waist, sent * beams.wavelength_mm)};
  };
  const auto addFocus = [&](double focus_mm) { beams.transmits[static_cast<std::size_t>(beams.foci++)] = focusedAt(focus_mm); };
  const double usual_mm = probe.kind == ProbeKind::sweptSector ? probe.elevationalFocus_mm : 0.5 * depth_mm;
  beams.usual = focusedAt(usual_mm);
  addFocus(probe.kind != ProbeKind::sweptSector && knobs.focus_mm > 0.0 ? knobs.focus_mm : usual_mm);
  if (probe.kind != ProbeKind::sweptSector) {
    for (const double more_mm : knobs.moreFoci_mm) {
      if (more_mm > 0.0) addFocus(more_mm);
    }
  }
  beams.focuses = scene.focus.has_value() && scene.focus->strength > 0.0;
  beams.receivePerDepth = width / aperture_mm;
  beams.receiveLeast_mm = width * effect.receiveFNumber;
  beams.focusStrength = beams.focuses ? std::min(1.0, scene.focus->strength) : 0.0;
  beams.lateralScale = effect.lineFilterWidth * (beams.focuses ? scene.focus->strength : 1.0);

  const double thickness_mm = probe.elevationalThickness_mm * (scene.sliceThickness ? scene.sliceThickness->scale : 1.0);
  beams.isSlice = scene.sliceThickness.has_value();
  beams.lensFocus_mm = probe.elevationalFocus_mm;
  beams.lensWaist_mm = thickness_mm / kFwhmOfSigma;
  const double opening = probe.elevationalAperture_mm / thickness_mm;
  beams.lensNearRange_mm = opening > 1.0 ? std::min(beams.lensFocus_mm / std::sqrt(opening * opening - 1.0), kNoRange_mm) : kNoRange_mm;
  beams.lensFarRange_mm = rayleighRange_mm(std::numbers::sqrt2 * beams.lensWaist_mm, beams.wavelength_mm);
  return beams;
}

}  // namespace ew::detail
