#include "patient/truth_recipe.h"

#include <algorithm>
#include <set>

#include "ew/core/numbers.h"

namespace ew::phantom {
namespace {

constexpr std::size_t kMostTruthEntries = 200;
constexpr double kFarthestSkin_mm = 1000.0;
constexpr double kLongestLine_mm = 5000.0;  // it is walked in small steps

void refuseUnlessKnown(const JsonFields& object, const std::string& key, const std::string& name, const ShapesByName& shapes) {
  if (shapes.count(name) == 0) object.refuse(key, shown(name), say<"the name of a shape or organ">());
}

/// One name or a list of them.
std::vector<std::string> readNames(const JsonFields& object, const std::string& key, const ShapesByName& shapes) {
  if (!object.has(key)) return {};
  const bool single = object.find(key)->is_string();
  auto names = single ? std::vector<std::string>{object.text(key)} : object.texts(key, 1, 50);
  for (std::size_t n = 0; n < names.size(); ++n)
    refuseUnlessKnown(object, single ? key : key + "[" + std::to_string(n) + "]", names[n], shapes);
  return names;
}

constexpr WordTable<TubePlace, 3> kTubePlaces{
    {{"largest", TubePlace::largest}, {"smallest", TubePlace::smallest}, {"given", TubePlace::given}}};

glm::dvec3 readDirection(const JsonFields& object, const std::string& field, const glm::dvec3& fallback) {
  const glm::dvec3 read = object.point(field, kFarthest_mm, fallback);
  const double length = glm::length(read);
  if (!(length > 1e-6)) object.refuse(field, say<"a direction">());
  return length > 1e-6 ? read / length : fallback;
}

MeasurementRequest readMeasurement(const JsonFields& object, const ShapesByName& shapes) {
  MeasurementRequest read;
  object.only(
      {"kind", "plane", "of", "from_surface", "to_surface", "gap_between", "at_mm", "from_mm", "to_mm", "direction", "normal", "place"});
  if (!object.good()) return read;
  read.name = object.text("name");
  read.kind = object.word("kind", kMeasurementKindWords);
  read.plane = object.text("plane", "");
  read.of = readNames(object, "of", shapes);
  read.gap = readNames(object, "gap_between", shapes);
  for (const auto& [field, target] : {std::pair{"from_surface", &read.fromSurface}, std::pair{"to_surface", &read.toSurface}}) {
    if (!object.has(field)) continue;
    *target = object.text(field);
    refuseUnlessKnown(object, field, *target, shapes);
  }
  for (const auto& [field, target] :
       {std::pair{"at_mm", &read.at_mm}, std::pair{"from_mm", &read.from_mm}, std::pair{"to_mm", &read.to_mm}}) {
    if (object.has(field)) *target = object.point(field, kFarthest_mm);
  }
  const bool section = read.kind == MeasurementKind::circumference;
  read.direction = readDirection(object, section ? "normal" : "direction", section ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
  read.place = object.word("place", kTubePlaces, std::optional(TubePlace::given));
  if (!object.good()) return read;

  const bool line = read.from_mm && read.to_mm;
  if (read.kind == MeasurementKind::distance) {
    if (!line || glm::distance(*read.from_mm, *read.to_mm) < 0.01)
      object.refuseWhole(say<"a distance without a line">(), say<"from_mm and to_mm, two places">());
    if (line && !(glm::distance(*read.from_mm, *read.to_mm) <= kLongestLine_mm))
      object.refuseWhole(say<"a distance along a line of %1 mm">(textOf(glm::distance(*read.from_mm, *read.to_mm))),
                         say<"two places at most %1 mm apart">(textOf(kLongestLine_mm)));
    if ((!read.gap.empty() && read.gap.size() != 2) || read.fromSurface.empty() != read.toSurface.empty())
      object.refuseWhole(say<"one surface without the other">(), say<"two surfaces">());
    return read;
  }
  if (read.of.empty()) object.refuse("of", say<"missing">(), say<"the name of a shape or organ">());
  if (!object.good()) return read;
  const bool tube = shapes.at(read.of.front())->centreLine() != nullptr;
  if (read.kind == MeasurementKind::diameter && read.place == TubePlace::given && !read.at_mm)
    object.refuse("at_mm", say<"missing">(), say<"a place, or \"place\": \"largest\" or \"smallest\" of a tube">());
  if (read.kind == MeasurementKind::diameter && read.place != TubePlace::given && !tube)
    object.refuse("of", verbatim('"' + read.of.front() + '"'), say<"a tube, or at_mm in place of %1">(object.text("place")));
  if (section && !read.at_mm) object.refuse("at_mm", say<"missing">(), say<"a place inside the section">());
  return read;
}

/// Goes from `inside_mm` against `into` to the skin.
std::optional<glm::dvec3> skinBehind(const ShapePtr& skin, const glm::dvec3& from_mm, const glm::dvec3& into) {
  constexpr double kStep_mm = 2.0;
  const bool inside = skin->distance_mm(from_mm) < 0.0;
  const glm::dvec3 step = (inside ? -kStep_mm : kStep_mm) * into;
  glm::dvec3 at = from_mm;
  for (double gone = 0.0; gone < kFarthestSkin_mm; gone += kStep_mm, at += step) {
    if ((skin->distance_mm(at + step) < 0.0) == inside) continue;
    glm::dvec3 same = at, other = at + step;
    for (int n = 0; n < 30; ++n) {
      const glm::dvec3 middle = 0.5 * (same + other);
      ((skin->distance_mm(middle) < 0.0) == inside ? same : other) = middle;
    }
    return 0.5 * (same + other);
  }
  return std::nullopt;
}

glm::dvec3 inwards(const ShapePtr& skin, const glm::dvec3& p_mm) {
  constexpr double kStep_mm = 2.0;
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = kStep_mm;
    gradient[axis] = skin->distance_mm(p_mm + step) - skin->distance_mm(p_mm - step);
  }
  const double length = glm::length(gradient);
  return length > 0.0 ? -gradient / length : glm::dvec3(0, 1, 0);
}

}  // namespace

std::vector<MeasurementRequest> readMeasurements(const JsonFields& recipe, const ShapesByName& shapes,
                                                 const std::vector<StandardPlane>& planes) {
  std::vector<MeasurementRequest> read;
  std::set<std::string> names;
  for (const JsonFields& each : recipe.objects("measurements", 0, kMostTruthEntries)) {
    read.push_back(readMeasurement(each, shapes));
    const MeasurementRequest& last = read.back();
    if (each.good() && !names.insert(last.name).second) each.refuse("name", say<"a name that is not taken yet">());
    if (each.good() && !last.plane.empty() &&
        std::none_of(planes.begin(), planes.end(), [&](const StandardPlane& plane) { return plane.name == last.plane; }))
      each.refuse("plane", say<"the name of one of the planes">());
  }
  return read;
}

std::vector<StandardPlane> readPlanes(const JsonFields& recipe, const ShapePtr& skin, const ShapesByName& shapes, Progress& progress) {
  std::vector<StandardPlane> read;
  std::set<std::string> names;
  for (const JsonFields& object : recipe.objects("planes", 0, kMostTruthEntries)) {
    if (progress.cancelRequested()) break;
    object.only({"near_mm", "towards_mm", "lateral", "position_tolerance_mm", "angle_tolerance_deg", "shows"});
    if (!object.good()) break;
    StandardPlane plane;
    plane.name = object.text("name");
    const glm::dvec3 near = object.point("near_mm", kFarthest_mm);
    const glm::dvec3 lateral = readDirection(object, "lateral", glm::dvec3(1, 0, 0));
    plane.positionTolerance_mm = object.number("position_tolerance_mm", 0.0, 1000.0, plane.positionTolerance_mm);
    plane.angleTolerance_deg = object.number("angle_tolerance_deg", 0.0, 180.0, plane.angleTolerance_deg);
    plane.shows = readNames(object, "shows", shapes);
    if (object.good() && !names.insert(plane.name).second) object.refuse("name", say<"a name that is not taken yet">());
    glm::dvec3 into = inwards(skin, near);
    if (object.has("towards_mm")) {
      const glm::dvec3 way = object.point("towards_mm", kFarthest_mm) - near;
      if (!(glm::length(way) > 1.0)) object.refuse("towards_mm", say<"at near_mm">(), say<"a place at least 1 mm away from it">());
      into = glm::normalize(way);
    }
    if (!object.good()) break;
    const auto face = skinBehind(skin, near, into);
    if (!face) object.refuse("near_mm", say<"away from the body">(), say<"a place near the skin">());
    const glm::dvec3 across = lateral - into * glm::dot(lateral, into);
    if (!(glm::length(across) > 1e-3)) object.refuse("lateral", say<"along the beam">(), say<"a direction across the beam">());
    if (!object.good()) break;
    const glm::dvec3 x = glm::normalize(across);
    plane.probeToWorld.matrix =
        glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(into, 0.0), glm::dvec4(glm::cross(x, into), 0.0), glm::dvec4(*face, 1.0));
    read.push_back(std::move(plane));
  }
  return read;
}

}  // namespace ew::phantom
