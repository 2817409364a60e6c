#include "echo_beams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "probes/sound.h"

namespace ew::detail {
namespace {

constexpr double kApodisedWidth = 1.4;
constexpr double kFNumber = 2.0;     // of transmission, at least
constexpr double kNoRange_mm = 1e6;  // of a beam that does not widen

double rayleighRange_mm(double oneWaySigma_mm, double wavelength_mm) {
  return 2.0 * std::numbers::pi * oneWaySigma_mm * oneWaySigma_mm / wavelength_mm;
}

}  // namespace

double EchoBeams::lateralSigma_mm(double depth_mm) const {
  double transmit = std::numeric_limits<double>::infinity();
  for (int n = 0; n < foci; ++n) {
    const Transmit& each = transmits[static_cast<std::size_t>(n)];
    const double off = focuses ? (depth_mm - each.focus_mm) / each.range_mm : 0.0;
    transmit = std::min(transmit, each.waist_mm * std::sqrt(1.0 + off * off));
  }
  const double receive = std::max(receiveLeast_mm, receivePerDepth * depth_mm);
  return lateralScale * transmit * receive / std::sqrt(transmit * transmit + receive * receive);
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
  const auto addFocus = [&](double focus_mm) {
    const double waist = width * std::max(kFNumber, focus_mm / aperture_mm);
    beams.transmits[static_cast<std::size_t>(beams.foci++)] = {focus_mm, waist, rayleighRange_mm(waist, beams.wavelength_mm)};
  };
  addFocus(probe.kind == ProbeKind::sweptSector ? probe.elevationalFocus_mm : knobs.focus_mm > 0.0 ? knobs.focus_mm : 0.5 * depth_mm);
  if (probe.kind != ProbeKind::sweptSector) {
    for (const double more_mm : knobs.moreFoci_mm) {
      if (more_mm > 0.0) addFocus(more_mm);
    }
  }
  beams.focuses = scene.focus.has_value() && scene.focus->strength > 0.0;
  beams.receivePerDepth = width / aperture_mm;
  beams.receiveLeast_mm = width * effect.receiveFNumber;
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
