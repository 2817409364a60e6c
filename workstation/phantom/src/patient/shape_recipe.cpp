#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "ew/core/numbers.h"
#include "patient/grown_recipe.h"
#include "patient/recipe.h"

namespace ew::phantom {
namespace {

using nlohmann::json;

constexpr double kSmallest_mm = 0.01;
constexpr double kLargest_mm = 5000.0;
constexpr int kDeepestShape = 16;  // nesting of shapes: a recipe deeper than this is a mistake or an attack on the stack
constexpr std::size_t kMostParts = 500;
constexpr double kMostSolids = 20000.0;  // asked for one point, a shared one at every use; the shipped bodies have some hundreds
constexpr int kDeepestUse = 100;         // shapes that use one another: asking a point recurses once for each

constexpr std::size_t kMostReliefPoints = 500;  // each is put on the surface, which asks the shape some dozens of times
constexpr double kLargestRelief_mm = 100.0;
constexpr double kHighestRelief_mm = 10.0;  // higher than wide would fold the distance; such a thing is a part

double radian(double degree) { return degree * std::numbers::pi / 180.0; }

/// Turns about x, then y, then z of the world.
glm::dmat3 turned(const glm::dvec3& angles_deg) {
  glm::dmat4 turn(1.0);
  turn = glm::rotate(turn, radian(angles_deg.z), glm::dvec3(0, 0, 1));
  turn = glm::rotate(turn, radian(angles_deg.y), glm::dvec3(0, 1, 0));
  turn = glm::rotate(turn, radian(angles_deg.x), glm::dvec3(1, 0, 0));
  return glm::dmat3(turn);
}

ShapePtr readEllipsoid(const JsonFields& object) {
  object.only({"centre_mm", "radii_mm", "turned_deg"});
  Ellipsoid ellipsoid{object.point("centre_mm", kFarthest_mm), object.point("radii_mm", kFarthest_mm),
                      turned(object.point("turned_deg", kFarthest_mm, glm::dvec3(0.0)))};
  for (int axis = 0; axis < 3; ++axis) {
    if (!(ellipsoid.radii_mm[axis] >= kSmallest_mm))
      object.refuse("radii_mm", say<"not positive">(), say<"three radii of at least 0.01 mm">());
  }
  return !object.good() ? nullptr : makeEllipsoid(ellipsoid);
}

ShapePtr readCapsule(const JsonFields& object) {
  object.only({"from_mm", "to_mm", "from_radius_mm", "to_radius_mm"});
  const RoundCone cone{object.point("from_mm", kFarthest_mm), object.point("to_mm", kFarthest_mm),
                       object.number("from_radius_mm", kSmallest_mm, kLargest_mm),
                       object.number("to_radius_mm", kSmallest_mm, kLargest_mm)};
  return !object.good() ? nullptr : makeRoundCone(cone);
}

ShapePtr readTube(const JsonFields& object) {
  object.only({"points"});
  std::vector<glm::dvec3> points;
  std::vector<double> radii;
  const json& list = object.list("points", 2, kMostParts);
  for (std::size_t n = 0; n < list.size(); ++n) {
    std::array<double, 4> row{};
    bool fits = list[n].is_array() && list[n].size() == row.size();
    for (std::size_t axis = 0; fits && axis < row.size(); ++axis) {
      const auto number =
          axis < 3 ? numberWithin(list[n][axis], -kFarthest_mm, kFarthest_mm) : numberWithin(list[n][axis], kSmallest_mm, kLargest_mm);
      fits = number.has_value();
      row[axis] = number.value_or(0.0);
    }
    if (!fits) {
      object.refuse("points[" + std::to_string(n) + "]", shown(list[n]),
                    say<"four numbers, [x, y, z, radius] in mm, with a radius from %1 to %2">(textOf(kSmallest_mm), textOf(kLargest_mm)));
      break;
    }
    points.emplace_back(row[0], row[1], row[2]);
    radii.push_back(row[3]);
  }
  return !object.good() ? nullptr : makeTube(points, radii);
}

ShapePtr readLoft(const JsonFields& object) {
  object.only({"sections", "cap_rounding_mm"});
  std::vector<LoftSection> sections;
  for (const JsonFields& each : object.objects("sections", 2, kMostParts)) {
    each.only({"z_mm", "centre_x_mm", "centre_y_mm", "half_width_mm", "front_mm", "back_mm", "squareness"});
    if (!each.good()) break;
    LoftSection section;
    section.z_mm = each.number("z_mm", -kLargest_mm, kLargest_mm);
    section.centreX_mm = each.number("centre_x_mm", -kLargest_mm, kLargest_mm, 0.0);
    section.centreY_mm = each.number("centre_y_mm", -kLargest_mm, kLargest_mm, 0.0);
    section.halfWidth_mm = each.number("half_width_mm", kSmallest_mm, kLargest_mm);
    section.front_mm = each.number("front_mm", kSmallest_mm, kLargest_mm);
    section.back_mm = each.number("back_mm", kSmallest_mm, kLargest_mm);
    section.squareness = each.number("squareness", 0.0, 1.0, 0.0);
    if (!sections.empty() && !(section.z_mm - sections.back().z_mm >= kSmallest_mm))
      each.refuse("z_mm", say<"not above the section before it">(), say<"sections by rising z_mm">());
    sections.push_back(section);
  }
  const double rounding = object.number("cap_rounding_mm", 0.0, kLargest_mm, 0.0);
  return !object.good() ? nullptr : makeLoft(sections, rounding);
}

ShapePtr readHalfSpace(const JsonFields& object) {
  object.only({"point_mm", "outward"});
  const glm::dvec3 point = object.point("point_mm", kFarthest_mm);
  const glm::dvec3 outward = object.point("outward", kFarthest_mm);
  if (object.good() && !(glm::length(outward) > 1e-6)) object.refuse("outward", say<"zero">(), say<"a direction">());
  return !object.good() ? nullptr : makeHalfSpace(point, outward);
}

/// The entry of a table that a field names; null after a problem.
template <class Table>
const typename Table::mapped_type* entryNamed(const JsonFields& object, const std::string& field, const Table& known, const Message& what) {
  const std::string name = object.text(field);
  if (!object.good()) return nullptr;
  const auto found = known.find(name);
  if (found != known.end()) return &found->second;
  const std::string names = listed(known, [](const auto& each) { return each.first; });
  object.refuse(field, verbatim('"' + name + '"'), names.empty() ? what : say<"%1 (%2)">(what, names));
  return nullptr;
}

ShapePtr readShell(const JsonFields& object, const ShapesByName& known) {
  object.only({"of", "from_depth_mm", "to_depth_mm"});
  ShapePtr of = shapeNamed(object, "of", known);
  const double from = object.number("from_depth_mm", -kLargest_mm, kLargest_mm);
  const double to = object.number("to_depth_mm", -kLargest_mm, kLargest_mm);
  if (object.good() && !(from < to))
    object.refuse("to_depth_mm", say<"not below from_depth_mm">(), say<"a larger depth than from_depth_mm">());
  return !object.good() ? nullptr : makeShell(std::move(of), from, to);
}

ShapePtr readGrown(const JsonFields& object, const ShapesByName& known) {
  object.only({"of", "by_mm"});
  ShapePtr of = shapeNamed(object, "of", known);
  const double by = object.number("by_mm", -kLargest_mm, kLargest_mm);
  return !object.good() ? nullptr : makeOffset(std::move(of), by);
}

/// The ridges and furrows on a shape, drawn in a frame as the shape is.
std::vector<ReliefLine> readRelief(const JsonFields& object, const DrawingFrame* frame) {
  std::vector<ReliefLine> relief;
  std::size_t points = 0;
  for (const JsonFields& each : object.objects("relief", 0, kMostReliefPoints)) {
    each.only({"points", "half_width_mm", "height_mm", "mirrored"});
    ReliefLine ridge;
    ridge.halfWidth_mm = each.number("half_width_mm", 0.5, kLargestRelief_mm);
    ridge.height_mm = each.number("height_mm", -kHighestRelief_mm, kHighestRelief_mm);
    ridge.lines.resize(each.flag("mirrored", false) ? 2 : 1);
    const json& list = each.list("points", 1, kMostReliefPoints);
    for (std::size_t n = 0; n < list.size() && each.good(); ++n) {
      glm::dvec4 drawn(0.0, 0.0, 0.0, 1.0);
      bool fits = list[n].is_array() && (list[n].size() == 3 || list[n].size() == 4);
      for (std::size_t axis = 0; fits && axis < list[n].size(); ++axis) {
        const auto number = axis < 3 ? numberWithin(list[n][axis], -kFarthest_mm, kFarthest_mm) : numberWithin(list[n][axis], 0.0, 1.0);
        fits = number.has_value();
        drawn[static_cast<int>(axis)] = number.value_or(0.0);
      }
      if (!fits)
        each.refuse("points[" + std::to_string(n) + "]", shown(list[n]),
                    say<"[x, y, z] in mm, or [x, y, z, share] with a share of the height from 0 to 1">());
      for (std::size_t side = 0; side < ridge.lines.size(); ++side) {
        const glm::dvec3 here(side == 0 ? drawn.x : -drawn.x, drawn.y, drawn.z);
        ridge.lines[side].emplace_back(frame ? frame->toWorld(here) : here, drawn.w);
      }
    }
    points += list.size();
    if (points > kMostReliefPoints) object.refuse("relief", say<"lines of more than %1 points">(kMostReliefPoints), say<"fewer points">());
    if (!each.good()) break;
    relief.push_back(std::move(ridge));
  }
  return relief;
}

/// What a shape is read with: the shapes and frames it may name, the frame it is drawn in, how deep it is nested, and how many solids the
/// whole shape has so far.
struct Surroundings {
  const ShapesByName& known;
  const FramesByName& frames;
  double& solids;
  const DrawingFrame* frame = nullptr;
  int depth = 0;
};

ShapePtr shapeIn(const JsonFields& object, Surroundings around);

std::vector<BlendPart> readParts(const JsonFields& object, const std::string& field, Surroundings around) {
  std::vector<BlendPart> parts;
  ++around.depth;
  for (const JsonFields& each : object.objects(field, 1, kMostParts)) {
    BlendPart part{shapeIn(each, around), 0.0};
    if (each.good()) part.blend_mm = each.number("blend_mm", 0.0, kLargest_mm, 0.0);
    parts.push_back(std::move(part));
  }
  return parts;
}

ShapePtr placed(ShapePtr drawn, const DrawingFrame* frame) { return drawn && frame ? makePlaced(std::move(drawn), *frame) : drawn; }

/// The shape with its mirror image in x = 0 of the frame.
ShapePtr mirroredIn(ShapePtr shape, double smoothing_mm, const DrawingFrame* frame) {
  if (!frame) return makeMirrored(std::move(shape), smoothing_mm);
  const DrawingFrame worldInFrame{frame->fromWorld(glm::dvec3(0.0)), glm::transpose(frame->axes)};
  return makePlaced(makeMirrored(makePlaced(std::move(shape), worldInFrame), smoothing_mm), *frame);
}

/// Shapes are shared, so a few lines can describe one that no machine could evaluate: 36 unions of the one before with itself are 2^36.
void refuseCostly(const JsonFields& object) {
  object.refuseWhole(say<"made of too many solids, a shared one counted at every use, or of shapes that use one another too deeply">(),
                     say<"at most %1 solids and %2 shapes inside one another">(textOf(kMostSolids), kDeepestUse));
}

/// The one kind of shape that the object names at this depth; else it is refused.
std::string kindOf(const JsonFields& object, int depth) {
  static const std::array<std::string, 17> kKinds{"capsule", "difference", "ellipsoid", "grown",       "half_space",    "intersection",
                                                  "loft",    "of",         "patches",   "rough",       "septa",         "sheets",
                                                  "shell",   "tube",       "union",     "vessel_tree", "vessels_beside"};
  std::vector<std::string> known{"blend_mm", "frame", "mirrored", "mirror_smoothing_mm", "relief"};
  known.insert(known.end(), kKinds.begin(), kKinds.end());
  std::ranges::sort(known);
  object.only(known);
  if (depth > kDeepestShape) object.refuseWhole(say<"nested too deeply">(), say<"at most %1 shapes inside one another">(kDeepestShape));
  if (!object.good()) return {};
  std::string kind;
  for (const std::string& each : kKinds) {
    if (!object.has(each)) continue;
    if (!kind.empty()) object.refuseWhole(say<"both %1 and %2">(kind, each), say<"one shape">());
    kind = each;
  }
  if (kind.empty())
    object.refuseWhole(
        say<"without a shape">(),
        say<"one of capsule, difference, ellipsoid, grown, half_space, intersection, loft, of, patches, rough, septa, sheets, "
            "shell, tube, union, vessel_tree, vessels_beside">());
  return kind;
}

/// The shape of that kind as it is drawn, without what is done to it afterwards; its solids are counted in `around`.
ShapePtr drawnIn(const JsonFields& object, const std::string& kind, Surroundings around) {
  // A kind that is drawn has an object of its own; the others name a shape or list some.
  const bool drawn = kind != "of" && kind != "union" && kind != "intersection" && kind != "difference";
  const JsonFields inner = drawn ? object.object(kind) : object;
  ShapePtr shape;
  if (kind == "ellipsoid") shape = placed(readEllipsoid(inner), around.frame);
  if (kind == "capsule") shape = placed(readCapsule(inner), around.frame);
  if (kind == "tube") shape = placed(readTube(inner), around.frame);
  if (kind == "loft") shape = placed(readLoft(inner), around.frame);
  if (kind == "half_space") shape = placed(readHalfSpace(inner), around.frame);
  if (kind == "shell") shape = readShell(inner, around.known);
  if (kind == "grown") shape = readGrown(inner, around.known);
  if (kind == "rough") shape = readRough(inner, around.known);
  if (kind == "sheets") shape = readSheets(inner, around.known);
  if (kind == "septa") shape = readSepta(inner, around.known);
  if (kind == "patches") shape = readPatches(inner);
  if (kind == "vessel_tree") shape = readVesselTree(inner, around.known, around.frame);
  if (kind == "vessels_beside") shape = readVesselsBeside(inner, around.known);
  if (kind == "of") shape = shapeNamed(object, "of", around.known);
  if (kind == "union" || kind == "intersection" || kind == "difference") {
    std::vector<BlendPart> parts = readParts(object, kind, around);
    if (!object.good()) return nullptr;
    return kind == "union"          ? makeUnion(std::move(parts))
           : kind == "intersection" ? makeIntersection(std::move(parts))
                                    : makeDifference(std::move(parts));
  }
  if (shape) around.solids += shape->solids();
  return shape;
}

ShapePtr shapeIn(const JsonFields& object, Surroundings around) {
  const std::string kind = kindOf(object, around.depth);
  if (object.good() && object.has("frame"))
    around.frame = entryNamed(object, "frame", around.frames, say<"a frame described before this one">());
  if (!object.good()) return nullptr;
  ShapePtr shape = drawnIn(object, kind, around);
  if (!object.good()) return nullptr;
  if (around.solids > kMostSolids || shape->depth() > kDeepestUse) {
    refuseCostly(object);
    return nullptr;
  }
  if (object.has("relief")) {
    const std::vector<ReliefLine> relief = readRelief(object, around.frame);
    if (!object.good()) return nullptr;
    shape = makeRelief(std::move(shape), relief);
  }
  const bool mirrored = object.flag("mirrored", false);
  const double smoothing = object.number("mirror_smoothing_mm", 0.0, 100.0, 0.0);
  if (!object.good()) return nullptr;
  return mirrored ? mirroredIn(std::move(shape), smoothing, around.frame) : shape;
}

}  // namespace

ShapePtr shapeNamed(const JsonFields& object, const std::string& field, const ShapesByName& known) {
  const ShapePtr* found = entryNamed(object, field, known, say<"a shape described before this one">());
  return found ? *found : nullptr;
}

FramesByName readFrames(const JsonFields& recipe) {
  FramesByName frames;
  for (const JsonFields& entry : recipe.objects("frames", 0, 100)) {
    entry.only({"origin_mm", "turned_deg", "within"});
    const std::string name = entry.text("name");
    const JsonFields each = entry.called(entry.place() + " (" + name + ")");
    if (frames.count(name) > 0) each.refuse("name", say<"a name that is not taken yet">());
    DrawingFrame frame{each.point("origin_mm", kFarthest_mm), turned(each.point("turned_deg", kFarthest_mm, glm::dvec3(0.0)))};
    if (each.has("within")) {
      if (const DrawingFrame* outer = entryNamed(each, "within", frames, say<"a frame described before this one">()))
        frame = {outer->toWorld(frame.origin_mm), outer->axes * frame.axes};
    }
    if (!each.good()) return frames;
    frames.emplace(name, frame);
  }
  return frames;
}

ShapePtr readShape(const JsonFields& object, const ShapesByName& known, const FramesByName& frames) {
  double solids = 0.0;
  return shapeIn(object, {known, frames, solids});
}

}  // namespace ew::phantom
