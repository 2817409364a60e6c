#include "patient/grown_recipe.h"

#include "ew/core/numbers.h"
#include "shapes/uneven_shapes.h"
#include "shapes/vessel_tree.h"

namespace ew::phantom {
namespace {

using nlohmann::json;

constexpr long long kMostEnds = 1000;
constexpr std::size_t kMostTrunks = 50;
constexpr std::size_t kMostTrunkPoints = 100;
constexpr double kMostQuestions = 5e5;        // ends times the solids that each place is asked of: some seconds
constexpr std::size_t kMostBranches = 10000;  // of all trees of a recipe
constexpr long long kLargestSeed = 1000000000;

std::vector<glm::dvec3> readTrunk(const JsonFields& object, const DrawingFrame* frame) {
  object.only({"points"});
  std::vector<glm::dvec3> points;
  const json& list = object.list("points", 2, kMostTrunkPoints);
  for (std::size_t n = 0; n < list.size() && object.good(); ++n) {
    glm::dvec3 point(0.0);
    bool fits = list[n].is_array() && list[n].size() == 3;
    for (int axis = 0; fits && axis < 3; ++axis) {
      const auto number = numberWithin(list[n][static_cast<std::size_t>(axis)], -kFarthest_mm, kFarthest_mm);
      fits = number.has_value();
      point[axis] = number.value_or(0.0);
    }
    if (!fits) object.refuse("points[" + std::to_string(n) + "]", shown(list[n]), say<"three numbers, [x, y, z] in mm">());
    points.push_back(frame ? frame->toWorld(point) : point);
  }
  if (object.good() && glm::distance(points.front(), points[1]) < 0.01)
    object.refuse("points[1]", shown(list[1]), say<"a point at least 0.01 mm from the one before">());
  return points;
}

/// Growing asks its organ and what it avoids for each place it tries: a recipe of a few lines must not take minutes.
void refuseSlowGrowth(const JsonFields& object, const VesselGrowth& growth, const ShapesByName& known) {
  double solids = growth.within->solids();
  for (const ShapePtr& other : growth.avoid) solids += other->solids();
  if (solids * growth.ends > kMostQuestions)
    object.refuse("ends", say<"too many for an organ of so many solids">(), say<"fewer ends, or an organ of fewer solids">());
  std::size_t branches = 2 * static_cast<std::size_t>(growth.ends);
  for (const auto& [name, shape] : known)
    if (const VesselTree* tree = shape->vessels()) branches += tree->branches.size();
  if (branches > kMostBranches)
    object.refuseWhole(say<"too many branches of vessels">(), say<"at most %1 of all trees together">(kMostBranches));
}

}  // namespace

ShapePtr readVesselTree(const JsonFields& object, const ShapesByName& known, const DrawingFrame* frame) {
  object.only({"within", "trunks", "ends", "end_radius_mm", "margin_mm", "avoid", "clearance_mm", "seed"});
  VesselGrowth growth;
  growth.within = shapeNamed(object, "within", known);
  for (const JsonFields& each : object.objects("trunks", 1, kMostTrunks)) growth.trunks.push_back(readTrunk(each, frame));
  growth.ends = static_cast<int>(object.whole("ends", 1, kMostEnds));
  growth.endRadius_mm = object.number("end_radius_mm", 0.05, 50.0, growth.endRadius_mm);
  growth.margin_mm = object.number("margin_mm", 0.0, 100.0, growth.margin_mm);
  growth.clearance_mm = object.number("clearance_mm", 0.0, 100.0, growth.clearance_mm);
  growth.seed = static_cast<std::uint64_t>(object.whole("seed", 0, kLargestSeed, 1));
  const std::vector<std::string> names = object.texts("avoid", 0, kMostTrunks);
  for (std::size_t n = 0; n < names.size() && object.good(); ++n) {
    const auto found = known.find(names[n]);
    if (found == known.end())
      object.refuse("avoid[" + std::to_string(n) + "]", verbatim('"' + names[n] + '"'), say<"a shape described before this one">());
    else
      growth.avoid.push_back(found->second);
  }
  if (!object.good()) return nullptr;
  refuseSlowGrowth(object, growth, known);
  return !object.good() ? nullptr : makeVesselTree(growVesselTree(growth), growth.seed);
}

ShapePtr readVesselsBeside(const JsonFields& object, const ShapesByName& known) {
  object.only({"of", "ratio", "least_radius_mm", "gap_mm", "side"});
  const ShapePtr of = shapeNamed(object, "of", known);
  VesselsBeside beside;
  beside.ratio = object.number("ratio", 0.05, 2.0, beside.ratio);
  beside.leastRadius_mm = object.number("least_radius_mm", 0.0, 100.0, beside.leastRadius_mm);
  beside.gap_mm = object.number("gap_mm", 0.0, 50.0, beside.gap_mm);
  beside.side = object.point("side", kFarthest_mm, beside.side);
  const VesselTree* along = of ? of->vessels() : nullptr;
  if (object.good() && !along) object.refuse("of", say<"the name of a vessel_tree">());
  if (object.good() && !(glm::length(beside.side) > 1e-6)) object.refuse("side", say<"zero">(), say<"a direction">());
  if (!object.good() || !along) return nullptr;
  VesselTree tree = vesselsBeside(*along, beside);
  if (tree.branches.empty()) object.refuse("least_radius_mm", say<"a radius that some of the vessels have">());
  return !object.good() ? nullptr : makeVesselTree(std::move(tree), 1);
}

ShapePtr readRough(const JsonFields& object, const ShapesByName& known) {
  object.only({"of", "amplitude_mm", "length_mm", "seed"});
  ShapePtr of = shapeNamed(object, "of", known);
  Roughness rough;
  rough.length_mm = object.number("length_mm", 0.1, 1000.0);
  rough.amplitude_mm = object.number("amplitude_mm", 0.001, 0.5 * rough.length_mm, {}, say<"a number from 0.001 to half of length_mm">());
  rough.seed = static_cast<std::uint64_t>(object.whole("seed", 0, kLargestSeed, 1));
  return !object.good() ? nullptr : makeRough(std::move(of), rough);
}

ShapePtr readSheets(const JsonFields& object, const ShapesByName& known) {
  object.only({"of", "from_depth_mm", "to_depth_mm", "spacing_mm", "thickness_mm", "undulation_mm", "length_mm", "missing", "seed"});
  ShapePtr of = shapeNamed(object, "of", known);
  Sheets sheets;
  sheets.fromDepth_mm = object.number("from_depth_mm", -1000.0, 1000.0);
  sheets.toDepth_mm = object.number("to_depth_mm", -1000.0, 1000.0);
  sheets.spacing_mm = object.number("spacing_mm", 0.2, 100.0, sheets.spacing_mm);
  sheets.thickness_mm = object.number("thickness_mm", 0.05, 20.0, sheets.thickness_mm);
  sheets.length_mm = object.number("length_mm", 0.5, 1000.0, sheets.length_mm);
  sheets.undulation_mm = object.number("undulation_mm", 0.0, 0.2 * sheets.length_mm, std::min(sheets.undulation_mm, 0.2 * sheets.length_mm),
                                       say<"a number from 0 to a fifth of length_mm">());
  sheets.missing = object.number("missing", 0.0, 0.9, sheets.missing);
  sheets.seed = static_cast<std::uint64_t>(object.whole("seed", 0, kLargestSeed, 1));
  if (object.good() && !(sheets.fromDepth_mm < sheets.toDepth_mm))
    object.refuse("to_depth_mm", say<"not below from_depth_mm">(), say<"a larger depth than from_depth_mm">());
  return !object.good() ? nullptr : makeSheets(std::move(of), sheets);
}

ShapePtr readSepta(const JsonFields& object, const ShapesByName& known) {
  object.only({"of", "from_depth_mm", "to_depth_mm", "lobule_mm", "thickness_mm", "seed"});
  ShapePtr of = shapeNamed(object, "of", known);
  Septa septa;
  septa.fromDepth_mm = object.number("from_depth_mm", -1000.0, 1000.0);
  septa.toDepth_mm = object.number("to_depth_mm", -1000.0, 1000.0);
  septa.lobule_mm = object.point("lobule_mm", 1000.0, septa.lobule_mm);
  septa.thickness_mm = object.number("thickness_mm", 0.05, 20.0, septa.thickness_mm);
  septa.seed = static_cast<std::uint64_t>(object.whole("seed", 0, kLargestSeed, 1));
  for (int axis = 0; axis < 3; ++axis)
    if (object.good() && !(septa.lobule_mm[axis] >= 0.2)) object.refuse("lobule_mm", say<"three sizes of at least 0.2 mm">());
  if (object.good() && !(septa.fromDepth_mm < septa.toDepth_mm))
    object.refuse("to_depth_mm", say<"not below from_depth_mm">(), say<"a larger depth than from_depth_mm">());
  return !object.good() ? nullptr : makeSepta(std::move(of), septa);
}

ShapePtr readPatches(const JsonFields& object) {
  object.only({"size_mm", "share", "seed"});
  Patches patches;
  patches.size_mm = object.point("size_mm", 1000.0);
  patches.share = object.number("share", 0.02, 0.98, patches.share);
  patches.seed = static_cast<std::uint64_t>(object.whole("seed", 0, kLargestSeed, 1));
  for (int axis = 0; axis < 3; ++axis)
    if (object.good() && !(patches.size_mm[axis] >= 0.2)) object.refuse("size_mm", say<"three sizes of at least 0.2 mm">());
  return !object.good() ? nullptr : makePatches(patches);
}

}  // namespace ew::phantom
