#include "ew/imaging/resolved.h"

namespace ew {

bool formsEchoes(const Scene& scene) { return scene.liveEchoes.has_value(); }

GainLaw usualGainLaw(bool formsEchoes) { return formsEchoes ? GainLaw::decibel : GainLaw::paper; }
GreyMap usualGreyMap(bool formsEchoes) { return formsEchoes ? GreyMap::clinical : GreyMap::linear; }

double middleLevel(bool formsEchoes) {
  // Where the clinical curve is kMiddleGrey: a number, so that a frame whose range nobody turned runs nothing of the grey maps.
  constexpr double kFormed = 101.7262;
  return formsEchoes ? kFormed : kMiddleGrey;
}

GainLaw resolvedGainLaw(const Knobs& knobs, const Scene& scene) {
  return knobs.gainLaw == GainLaw::automatic ? usualGainLaw(formsEchoes(scene)) : knobs.gainLaw;
}

GreyMap resolvedGreyMap(const Knobs& knobs, const Scene& scene) {
  return knobs.greyMap == GreyMap::automatic ? usualGreyMap(formsEchoes(scene)) : knobs.greyMap;
}

}  // namespace ew
