#include "ew/imaging/resolved.h"

#include "ew/imaging/tissue_level.h"

namespace ew {

bool formsEchoes(const Scene& scene) { return scene.liveEchoes.has_value(); }

GainLaw usualGainLaw(bool formsEchoes) { return formsEchoes ? GainLaw::decibel : GainLaw::paper; }
GreyMap usualGreyMap(bool formsEchoes) { return formsEchoes ? GreyMap::clinical : GreyMap::linear; }

double middleLevel(bool formsEchoes) {
  static const double formed = static_cast<double>(levelsShownAs(usualGreyMap(true))[static_cast<std::size_t>(kMiddleGrey)]);
  return formsEchoes ? formed : kMiddleGrey;
}

GainLaw resolvedGainLaw(const Knobs& knobs, const Scene& scene) {
  return knobs.gainLaw == GainLaw::automatic ? usualGainLaw(formsEchoes(scene)) : knobs.gainLaw;
}

GreyMap resolvedGreyMap(const Knobs& knobs, const Scene& scene) {
  return knobs.greyMap == GreyMap::automatic ? usualGreyMap(formsEchoes(scene)) : knobs.greyMap;
}

}  // namespace ew
