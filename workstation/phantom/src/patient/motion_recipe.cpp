#include "patient/motion_recipe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/numbers.h"
#include "ew/core/parallel.h"

namespace ew::phantom {
namespace {

constexpr double kShareSpacing_mm = 6.0;
constexpr double kShareMargin_mm = 30.0;  // around the box: probes and organs reach beyond it
constexpr double kLeastStretch = 0.15;    // of tissue, along any direction: below it neighbours would nearly meet

double smoothStep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

BodyRhythm readRhythm(const JsonFields& object, double period_s) {
  BodyRhythm rhythm;
  rhythm.period_s = period_s;
  rhythm.variation = object.number("variation", 0.0, 0.4, 0.0);
  return rhythm;
}

Breathing readBreathing(const JsonFields& object, const Bounds& box, const ShapePtr& skin, const ShapesByName& shapes, Progress& progress) {
  Breathing breathing;
  object.only({"period_s", "variation", "pause", "displacement_mm", "held_depth_mm", "free_depth_mm", "held_by", "free_distance_mm",
               "grows_along_z_mm", "tidal"});
  if (!object.good()) return breathing;
  breathing.rhythm = readRhythm(object, object.number("period_s", 1.0, 30.0, 4.0));
  breathing.pause = object.number("pause", 0.0, 0.9, 0.3);
  breathing.tidal = object.number("tidal", 0.05, 1.0, 1.0);
  breathing.displacement_mm = object.point("displacement_mm", kFarthest_mm);
  if (!(glm::length(breathing.displacement_mm) <= 60.0)) object.refuse("displacement_mm", say<"too long">(), say<"at most 60 mm">());
  const double held = object.number("held_depth_mm", 0.0, 500.0, 20.0);
  const double free = object.number("free_depth_mm", 0.0, 500.0, 40.0);
  if (!(free > held)) object.refuse("free_depth_mm", verbatim(textOf(free)), say<"a depth below held_depth_mm">());
  const double freeDistance = object.number("free_distance_mm", 1.0, 500.0, 25.0);
  std::vector<ShapePtr> holders;
  for (const std::string& name : object.texts("held_by", 0, 50)) {
    const auto found = shapes.find(name);
    if (found == shapes.end())
      object.refuse("held_by[" + std::to_string(holders.size()) + "]", verbatim('"' + name + '"'), say<"the name of a shape or organ">());
    else
      holders.push_back(found->second);
  }
  double still_z = -1e5, full_z = -1e5 + 1.0;
  if (const auto range = object.numbers("grows_along_z_mm", 2, 2, -1e4, 1e4, false); !range.empty()) {
    still_z = range[0];
    full_z = range[1];
    if (!(std::abs(full_z - still_z) >= 1.0)) object.refuse("grows_along_z_mm", say<"two heights at least 1 mm apart">());
  }
  if (!object.good()) return breathing;

  auto share = std::make_shared<ShareField>(Bounds{box.lowest_mm - kShareMargin_mm, box.highest_mm + kShareMargin_mm}, kShareSpacing_mm);
  const glm::ivec3 nodes = share->nodes();
  const bool finished = forEachTask(nodes.z, 0, progress, say<"Reading the patient">(), [&](int k, int /*worker*/, const auto& stopped) {
    for (int j = 0; j < nodes.y && !stopped(); ++j)
      for (int i = 0; i < nodes.x; ++i) {
        const glm::dvec3 p = share->placeOf({i, j, k});
        double value = smoothStep((p.z - still_z) / (full_z - still_z));
        if (value > 0.0) value *= smoothStep((-skin->distance_mm(p) - held) / (free - held));
        for (const ShapePtr& holder : holders)
          if (value > 0.0) value *= smoothStep(holder->distance_mm(p) / freeDistance);
        share->at({i, j, k}) = static_cast<float>(value);
      }
  });
  if (!finished) return breathing;
  // Along the displacement d the tissue stretches by 1 + d . grad share; where that reaches 0 two places would meet.
  const double stretch = 1.0 + share->steepestFall(breathing.displacement_mm);
  if (!(stretch >= kLeastStretch))
    object.refuse("displacement_mm", say<"so long that it would fold the tissue where it fades">(),
                  say<"a shorter one, or a wider way from held to free">());
  breathing.share = std::move(share);
  return breathing;
}

PulsingVessel readVessel(const JsonFields& object, const ShapesByName& shapes) {
  PulsingVessel vessel;
  object.only({"of", "diameter_growth_mm", "reach_mm", "fade_mm"});
  const std::string name = object.text("of");
  vessel.growth_mm = object.number("diameter_growth_mm", 0.0, 20.0);
  vessel.reach_mm = object.number("reach_mm", 1.0, 200.0, 20.0);
  vessel.fade_mm = object.number("fade_mm", 1.0, 200.0, 15.0);
  if (!object.good()) return vessel;
  const auto found = shapes.find(name);
  const CentreLine* line = found == shapes.end() ? nullptr : found->second->centreLine();
  if (line) vessel.line_mm = line->points_mm;
  if (vessel.line_mm.size() < 2) {
    object.refuse("of", verbatim('"' + name + '"'), say<"the name of a shape or organ that is a tube">());
    return vessel;
  }
  if (vessel.line_mm.front().z > vessel.line_mm.back().z) std::reverse(vessel.line_mm.begin(), vessel.line_mm.end());
  double thinnest = vessel.line_mm.front().w;
  for (std::size_t n = 1; n < vessel.line_mm.size(); ++n) {
    thinnest = std::min(thinnest, vessel.line_mm[n].w);
    if (!(vessel.line_mm[n].z - vessel.line_mm[n - 1].z > 1e-6)) {
      object.refuse("of", verbatim('"' + name + '"'), say<"a tube that runs up or down all along, never turning back or running level">());
      return vessel;
    }
  }
  // The wall's push falls off by 1 / radius from the ring it widens and by at most 1.6 / reach from its fading.
  if (!(0.5 * vessel.growth_mm * (1.0 / thinnest + 1.6 / vessel.reach_mm) <= 1.0 - kLeastStretch))
    object.refuse("diameter_growth_mm", verbatim(textOf(vessel.growth_mm)),
                  say<"less growth, or a longer reach, so that no tissue is folded">());
  return vessel;
}

BeatingChamber readChamber(const JsonFields& object, const ShapesByName& shapes) {
  BeatingChamber chamber;
  object.only({"of", "inward_mm", "reach_mm"});
  const std::string name = object.text("of");
  chamber.inward_mm = object.number("inward_mm", 0.0, 20.0);
  chamber.reach_mm = object.number("reach_mm", 1.0, 200.0, 25.0);
  if (!object.good()) return chamber;
  const auto found = shapes.find(name);
  const Ellipsoid* wall = found == shapes.end() ? nullptr : found->second->ellipsoid();
  if (!wall) {
    object.refuse("of", verbatim('"' + name + '"'), say<"the name of a shape or organ that is an ellipsoid">());
    return chamber;
  }
  chamber.wall = *wall;
  // Tissue is squeezed most across the shortest radius; around the wall it is drawn out towards it.
  const double shortest = std::min({wall->radii_mm.x, wall->radii_mm.y, wall->radii_mm.z});
  if (!(chamber.inward_mm <= (1.0 - kLeastStretch) * shortest))
    object.refuse("inward_mm", verbatim(textOf(chamber.inward_mm)), say<"less, so that the chamber is not folded">());
  return chamber;
}

Bowel readBowel(const JsonFields& object, const ShapesByName& shapes) {
  Bowel bowel;
  object.only({"period_s", "variation", "organs", "sway_mm", "wavelength_mm", "fade_mm"});
  if (!object.good()) return bowel;
  bowel.rhythm = readRhythm(object, object.number("period_s", 2.0, 60.0, 12.0));
  bowel.sway_mm = object.number("sway_mm", 0.0, 20.0, 2.0);
  bowel.wavelength_mm = object.number("wavelength_mm", 10.0, 500.0, 60.0);
  bowel.fade_mm = object.number("fade_mm", 1.0, 100.0, 6.0);
  for (const std::string& name : object.texts("organs", 1, 50)) {
    const auto found = shapes.find(name);
    if (found == shapes.end())
      object.refuse("organs[" + std::to_string(bowel.organs.size()) + "]", verbatim('"' + name + '"'),
                    say<"the name of a shape or organ">());
    else
      bowel.organs.push_back(found->second);
  }
  // The slopes of the fading and of the wave.
  if (!(bowel.sway_mm * (1.5 / bowel.fade_mm + std::numbers::pi / bowel.wavelength_mm) <= 1.0 - kLeastStretch))
    object.refuse("sway_mm", verbatim(textOf(bowel.sway_mm)),
                  say<"less sway, a longer fade_mm or a longer wave, so that no tissue is folded">());
  return bowel;
}

}  // namespace

ShareField::ShareField(const Bounds& box, double spacing_mm) : origin_(box.lowest_mm), spacing_(spacing_mm) {
  nodes_ = glm::max(glm::ivec3(glm::ceil((box.highest_mm - box.lowest_mm) / spacing_mm)), glm::ivec3(1)) + 1;
  row_ = static_cast<std::size_t>(nodes_.x);
  slice_ = row_ * static_cast<std::size_t>(nodes_.y);
  values_.assign(slice_ * static_cast<std::size_t>(nodes_.z), 0.0F);
}

double ShareField::operator()(const glm::dvec3& p_mm) const {
  const glm::dvec3 at = glm::clamp((p_mm - origin_) / spacing_, glm::dvec3(0.0), glm::dvec3(nodes_ - 1));
  const glm::dvec3 cell = glm::min(glm::floor(at), glm::dvec3(nodes_ - 2));
  const glm::dvec3 t = at - cell;
  const float* v = values_.data() + indexOf(glm::ivec3(cell));
  const auto along = [&](const float* from) {
    return static_cast<double>(from[0]) + t.x * (static_cast<double>(from[1]) - static_cast<double>(from[0]));
  };
  const double near0 = along(v), near1 = along(v + row_), far0 = along(v + slice_), far1 = along(v + slice_ + row_);
  const double nearer = near0 + t.y * (near1 - near0), farther = far0 + t.y * (far1 - far0);
  return nearer + t.z * (farther - nearer);
}

double ShareField::steepestFall(const glm::dvec3& direction) const {
  // Inside a cell each partial derivative is a mean of the differences along its four edges.
  double least = 0.0;
  for (int k = 0; k + 1 < nodes_.z; ++k)
    for (int j = 0; j + 1 < nodes_.y; ++j)
      for (int i = 0; i + 1 < nodes_.x; ++i) {
        double fall = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
          if (direction[axis] == 0.0) continue;
          double worst = 1e9;
          for (int edge = 0; edge < 4; ++edge) {
            glm::ivec3 from(i, j, k), step(0);
            from[(axis + 1) % 3] += edge & 1;
            from[(axis + 2) % 3] += edge >> 1;
            step[axis] = 1;
            worst = std::min(worst, direction[axis] * (at(from + step) - at(from)) / spacing_);
          }
          fall += worst;
        }
        least = std::min(least, fall);
      }
  return least;
}

Motion readMotion(const JsonFields& motion, const Bounds& box, const ShapePtr& skin, const ShapesByName& shapes, Progress& progress) {
  Motion read;
  motion.only({"breathing", "pulse", "bowel"});
  if (!motion.good()) return read;
  if (motion.has("breathing")) read.breathing = readBreathing(motion.object("breathing"), box, skin, shapes, progress);
  if (motion.has("pulse")) {
    const JsonFields object = motion.object("pulse");
    object.only({"beats_per_minute", "variation", "vessels", "chambers"});
    Pulse pulse;
    pulse.rhythm = readRhythm(object, 60.0 / object.number("beats_per_minute", 20.0, 240.0, 66.0));
    const bool hasChambers = object.has("chambers");
    if (hasChambers)
      for (const JsonFields& chamber : object.objects("chambers", 1, 50)) pulse.chambers.push_back(readChamber(chamber, shapes));
    if (!hasChambers || object.has("vessels"))
      for (const JsonFields& vessel : object.objects("vessels", 1, 50)) pulse.vessels.push_back(readVessel(vessel, shapes));
    read.pulse = std::move(pulse);
  }
  if (motion.has("bowel")) read.bowel = readBowel(motion.object("bowel"), shapes);
  return read;
}

}  // namespace ew::phantom
