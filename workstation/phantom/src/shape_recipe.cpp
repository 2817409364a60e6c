#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "ew/core/numbers.h"
#include "recipe.h"

namespace ew::phantom {
namespace {

using nlohmann::json;

constexpr double kSmallest_mm = 0.01;
constexpr double kLargest_mm = 5000.0;
constexpr int kDeepestShape = 16;  // nesting of shapes: a recipe deeper than this is a mistake or an attack on the stack
constexpr std::size_t kMostParts = 500;
constexpr double kMostSolids = 20000.0;  // asked for one point, a shared one at every use; the shipped bodies have some hundreds
constexpr int kDeepestUse = 100;         // shapes that use one another: asking a point recurses once for each

double radian(double degree) { return degree * std::numbers::pi / 180.0; }

/// Turns about x, then y, then z of the world.
glm::dmat3 turned(const glm::dvec3& angles_deg) {
  glm::dmat4 turn(1.0);
  turn = glm::rotate(turn, radian(angles_deg.z), glm::dvec3(0, 0, 1));
  turn = glm::rotate(turn, radian(angles_deg.y), glm::dvec3(0, 1, 0));
  turn = glm::rotate(turn, radian(angles_deg.x), glm::dvec3(1, 0, 0));
  return glm::dmat3(turn);
}

ShapePtr readEllipsoid(FieldReader& reader, const json& object, const std::string& place) {
  reader.allow(object, place, {"centre_mm", "radii_mm", "turned_deg"});
  Ellipsoid ellipsoid{reader.vector(object, place, "centre_mm"), reader.vector(object, place, "radii_mm"),
                      turned(reader.vector(object, place, "turned_deg", glm::dvec3(0.0)))};
  for (int axis = 0; axis < 3; ++axis) {
    if (!(ellipsoid.radii_mm[axis] >= kSmallest_mm)) reader.refuse(place + ".radii_mm", "not positive", "three radii of at least 0.01 mm");
  }
  return reader.problem() ? nullptr : makeEllipsoid(ellipsoid);
}

ShapePtr readCapsule(FieldReader& reader, const json& object, const std::string& place) {
  reader.allow(object, place, {"from_mm", "to_mm", "from_radius_mm", "to_radius_mm"});
  const RoundCone cone{reader.vector(object, place, "from_mm"), reader.vector(object, place, "to_mm"),
                       reader.number(object, place, "from_radius_mm", kSmallest_mm, kLargest_mm),
                       reader.number(object, place, "to_radius_mm", kSmallest_mm, kLargest_mm)};
  return reader.problem() ? nullptr : makeRoundCone(cone);
}

ShapePtr readTube(FieldReader& reader, const json& object, const std::string& place) {
  reader.allow(object, place, {"points"});
  std::vector<glm::dvec3> points;
  std::vector<double> radii;
  const json& list = reader.list(object, place, "points", 2, kMostParts);
  for (std::size_t n = 0; n < list.size(); ++n) {
    const std::string at = place + ".points[" + std::to_string(n) + "]";
    if (!list[n].is_array() || list[n].size() != 4) {
      reader.refuse(at, "not four numbers", "[x, y, z, radius] in mm");
      break;
    }
    points.push_back(reader.vectorIn(json::array({list[n][0], list[n][1], list[n][2]}), at));
    radii.push_back(reader.number(json{{"radius", list[n][3]}}, at, "radius", kSmallest_mm, kLargest_mm));
  }
  return reader.problem() ? nullptr : makeTube(points, radii);
}

ShapePtr readLoft(FieldReader& reader, const json& object, const std::string& place) {
  reader.allow(object, place, {"sections", "cap_rounding_mm"});
  std::vector<LoftSection> sections;
  const json& list = reader.list(object, place, "sections", 2, kMostParts);
  for (std::size_t n = 0; n < list.size(); ++n) {
    const std::string at = place + ".sections[" + std::to_string(n) + "]";
    reader.allow(list[n], at, {"z_mm", "centre_x_mm", "centre_y_mm", "half_width_mm", "front_mm", "back_mm", "squareness"});
    if (reader.problem()) break;
    LoftSection section;
    section.z_mm = reader.number(list[n], at, "z_mm", -kLargest_mm, kLargest_mm);
    section.centreX_mm = reader.number(list[n], at, "centre_x_mm", -kLargest_mm, kLargest_mm, 0.0);
    section.centreY_mm = reader.number(list[n], at, "centre_y_mm", -kLargest_mm, kLargest_mm, 0.0);
    section.halfWidth_mm = reader.number(list[n], at, "half_width_mm", kSmallest_mm, kLargest_mm);
    section.front_mm = reader.number(list[n], at, "front_mm", kSmallest_mm, kLargest_mm);
    section.back_mm = reader.number(list[n], at, "back_mm", kSmallest_mm, kLargest_mm);
    section.squareness = reader.number(list[n], at, "squareness", 0.0, 1.0, 0.0);
    if (!sections.empty() && !(section.z_mm - sections.back().z_mm >= kSmallest_mm))
      reader.refuse(at + ".z_mm", "not above the section before it", "sections by rising z_mm");
    sections.push_back(section);
  }
  const double rounding = reader.number(object, place, "cap_rounding_mm", 0.0, kLargest_mm, 0.0);
  return reader.problem() ? nullptr : makeLoft(sections, rounding);
}

ShapePtr readHalfSpace(FieldReader& reader, const json& object, const std::string& place) {
  reader.allow(object, place, {"point_mm", "outward"});
  const glm::dvec3 point = reader.vector(object, place, "point_mm");
  const glm::dvec3 outward = reader.vector(object, place, "outward");
  if (!reader.problem() && !(glm::length(outward) > 1e-6)) reader.refuse(place + ".outward", "zero", "a direction");
  return reader.problem() ? nullptr : makeHalfSpace(point, outward);
}

/// The entry of a table that a field names; null after a problem.
template <class Table>
const typename Table::mapped_type* entryNamed(FieldReader& reader, const json& object, const std::string& place, const std::string& field,
                                              const Table& known, const std::string& what) {
  const std::string name = reader.text(object, place, field);
  if (reader.problem()) return nullptr;
  const auto found = known.find(name);
  if (found != known.end()) return &found->second;
  const std::string names = listed(known, [](const auto& each) { return each.first; });
  reader.refuse(place + "." + field, '"' + name + '"', what + " described before this one" + (names.empty() ? "" : " (" + names + ")"));
  return nullptr;
}

ShapePtr named(FieldReader& reader, const json& object, const std::string& place, const std::string& field, const NamedShapes& known) {
  const ShapePtr* found = entryNamed(reader, object, place, field, known, "a shape");
  return found ? *found : nullptr;
}

ShapePtr readShell(FieldReader& reader, const json& object, const std::string& place, const NamedShapes& known) {
  reader.allow(object, place, {"of", "from_depth_mm", "to_depth_mm"});
  ShapePtr of = named(reader, object, place, "of", known);
  const double from = reader.number(object, place, "from_depth_mm", -kLargest_mm, kLargest_mm);
  const double to = reader.number(object, place, "to_depth_mm", -kLargest_mm, kLargest_mm);
  if (!reader.problem() && !(from < to))
    reader.refuse(place + ".to_depth_mm", "not below from_depth_mm", "a larger depth than from_depth_mm");
  return reader.problem() ? nullptr : makeShell(std::move(of), from, to);
}

ShapePtr readGrown(FieldReader& reader, const json& object, const std::string& place, const NamedShapes& known) {
  reader.allow(object, place, {"of", "by_mm"});
  ShapePtr of = named(reader, object, place, "of", known);
  const double by = reader.number(object, place, "by_mm", -kLargest_mm, kLargest_mm);
  return reader.problem() ? nullptr : makeOffset(std::move(of), by);
}

/// What a shape is read with: the shapes and frames it may name, the frame it is drawn in, how deep it is nested, and how many solids the
/// whole shape has so far.
struct Surroundings {
  const NamedShapes& known;
  const NamedFrames& frames;
  double& solids;
  const DrawingFrame* frame = nullptr;
  int depth = 0;
};

ShapePtr shapeIn(FieldReader& reader, const json& object, const std::string& place, Surroundings around);

std::vector<BlendedPart> readParts(FieldReader& reader, const json& object, const std::string& place, const std::string& field,
                                   Surroundings around) {
  std::vector<BlendedPart> parts;
  const json& list = reader.list(object, place, field, 1, kMostParts);
  ++around.depth;
  for (std::size_t n = 0; n < list.size() && !reader.problem(); ++n) {
    const std::string at = place + "." + field + "[" + std::to_string(n) + "]";
    BlendedPart part{shapeIn(reader, list[n], at, around), 0.0};
    if (!reader.problem()) part.blend_mm = reader.number(list[n], at, "blend_mm", 0.0, kLargest_mm, 0.0);
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
void refuseCostly(FieldReader& reader, const std::string& place) {
  reader.refuse(place, "made of too many solids, a shared one counted at every use, or of shapes that use one another too deeply",
                "at most " + textOf(kMostSolids) + " solids and " + std::to_string(kDeepestUse) + " shapes inside one another");
}

ShapePtr shapeIn(FieldReader& reader, const json& object, const std::string& place, Surroundings around) {
  static const std::array<std::string, 11> kKinds{"capsule", "difference", "ellipsoid", "grown", "half_space", "intersection",
                                                  "loft",    "of",         "shell",     "tube",  "union"};
  reader.allow(object, place,
               {"blend_mm", "capsule", "difference", "ellipsoid", "frame", "grown", "half_space", "intersection", "loft", "mirrored",
                "mirror_smoothing_mm", "of", "shell", "tube", "union"});
  if (reader.problem()) return nullptr;
  if (around.depth > kDeepestShape) {
    reader.refuse(place, "nested too deeply", "at most " + std::to_string(kDeepestShape) + " shapes inside one another");
    return nullptr;
  }
  std::string kind;
  for (const std::string& each : kKinds) {
    if (!object.contains(each)) continue;
    if (!kind.empty()) reader.refuse(place, "both " + kind + " and " + each, "one shape");
    kind = each;
  }
  if (kind.empty())
    reader.refuse(place, "without a shape",
                  "one of capsule, difference, ellipsoid, grown, half_space, intersection, loft, of, shell, tube, union");
  if (reader.problem()) return nullptr;

  if (object.contains("frame")) around.frame = entryNamed(reader, object, place, "frame", around.frames, "a frame");
  if (reader.problem()) return nullptr;

  const std::string at = place + "." + kind;
  const json& inner = object[kind];
  ShapePtr shape;
  if (kind == "ellipsoid") shape = placed(readEllipsoid(reader, inner, at), around.frame);
  if (kind == "capsule") shape = placed(readCapsule(reader, inner, at), around.frame);
  if (kind == "tube") shape = placed(readTube(reader, inner, at), around.frame);
  if (kind == "loft") shape = placed(readLoft(reader, inner, at), around.frame);
  if (kind == "half_space") shape = placed(readHalfSpace(reader, inner, at), around.frame);
  if (kind == "shell") shape = readShell(reader, inner, at, around.known);
  if (kind == "grown") shape = readGrown(reader, inner, at, around.known);
  if (kind == "of") shape = named(reader, object, place, "of", around.known);
  if (kind == "union" || kind == "intersection" || kind == "difference") {
    std::vector<BlendedPart> parts = readParts(reader, object, place, kind, around);
    if (reader.problem()) return nullptr;
    shape = kind == "union"          ? makeUnion(std::move(parts))
            : kind == "intersection" ? makeIntersection(std::move(parts))
                                     : makeDifference(std::move(parts));
  } else if (shape) {
    around.solids += shape->solids();
  }
  if (reader.problem()) return nullptr;
  if (around.solids > kMostSolids || shape->depth() > kDeepestUse) {
    refuseCostly(reader, place);
    return nullptr;
  }
  const bool mirrored = reader.flag(object, place, "mirrored", false);
  const double smoothing = reader.number(object, place, "mirror_smoothing_mm", 0.0, 100.0, 0.0);
  if (reader.problem()) return nullptr;
  return mirrored ? mirroredIn(std::move(shape), smoothing, around.frame) : shape;
}

}  // namespace

NamedFrames readFrames(FieldReader& reader, const json& recipe) {
  NamedFrames frames;
  if (!recipe.contains("frames")) return frames;
  const json& list = reader.list(recipe, "patient", "frames", 0, 100);
  for (std::size_t n = 0; n < list.size() && !reader.problem(); ++n) {
    std::string at = "frames[" + std::to_string(n) + "]";
    reader.allow(list[n], at, {"origin_mm", "turned_deg", "within"});
    if (reader.problem()) return frames;
    const std::string name = reader.text(list[n], at, "name");
    at += " (" + name + ")";
    if (frames.count(name) > 0) reader.refuse(at + ".name", '"' + name + '"', "a name that is not taken yet");
    DrawingFrame frame{reader.vector(list[n], at, "origin_mm"), turned(reader.vector(list[n], at, "turned_deg", glm::dvec3(0.0)))};
    if (list[n].contains("within")) {
      if (const DrawingFrame* outer = entryNamed(reader, list[n], at, "within", frames, "a frame"))
        frame = {outer->toWorld(frame.origin_mm), outer->axes * frame.axes};
    }
    frames.emplace(name, frame);
  }
  return frames;
}

ShapePtr readShape(FieldReader& reader, const json& object, const std::string& place, const NamedShapes& known, const NamedFrames& frames) {
  double solids = 0.0;
  return shapeIn(reader, object, place, {known, frames, solids});
}

}  // namespace ew::phantom
