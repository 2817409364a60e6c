#include "truth_recipe.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ew/core/numbers.h"

namespace ew::phantom {
namespace {

using nlohmann::json;

constexpr std::size_t kMostTruthEntries = 200;
constexpr double kFarthestSkin_mm = 1000.0;
constexpr double kLongestLine_mm = 5000.0;  // it is walked in small steps

bool shapeKnown(FieldReader& reader, const json& name, const std::string& place, const NamedShapes& shapes) {
  if (name.is_string() && shapes.count(name.get<std::string>()) > 0) return true;
  reader.refuse(place, name.dump(-1, ' ', false, json::error_handler_t::replace), "the name of a shape or organ");
  return false;
}

std::vector<std::string> readNames(FieldReader& reader, const json& object, const std::string& place, const std::string& field,
                                   const NamedShapes& shapes) {
  std::vector<std::string> names;
  const auto found = object.find(field);
  if (found == object.end()) return names;
  if (found->is_string()) {
    if (shapeKnown(reader, *found, place + "." + field, shapes)) names.push_back(found->get<std::string>());
    return names;
  }
  const json& list = reader.list(object, place, field, 1, 50);
  for (std::size_t n = 0; n < list.size(); ++n) {
    if (shapeKnown(reader, list[n], place + "." + field + "[" + std::to_string(n) + "]", shapes))
      names.push_back(list[n].get<std::string>());
  }
  return names;
}

glm::dvec3 readDirection(FieldReader& reader, const json& object, const std::string& place, const std::string& field,
                         const glm::dvec3& fallback) {
  const glm::dvec3 read = reader.vector(object, place, field, fallback);
  const double length = glm::length(read);
  if (!(length > 1e-6)) reader.refuse(place + "." + field, "zero", "a direction");
  return length > 1e-6 ? read / length : fallback;
}

MeasurementRequest readMeasurement(FieldReader& reader, const json& object, const std::string& place, const NamedShapes& shapes) {
  static const std::map<std::string, MeasurementKind> kKinds{{"circumference", MeasurementKind::circumference},
                                                             {"diameter", MeasurementKind::diameter},
                                                             {"distance", MeasurementKind::distance},
                                                             {"extent", MeasurementKind::extent},
                                                             {"volume", MeasurementKind::volume}};
  MeasurementRequest read;
  reader.allow(
      object, place,
      {"kind", "plane", "of", "from_surface", "to_surface", "gap_between", "at_mm", "from_mm", "to_mm", "direction", "normal", "place"});
  if (reader.problem()) return read;
  read.name = reader.text(object, place, "name");
  const std::string kind = reader.text(object, place, "kind");
  const auto known = kKinds.find(kind);
  if (known == kKinds.end()) {
    reader.refuse(place + ".kind", '"' + kind + '"', "distance, diameter, extent, circumference or volume");
    return read;
  }
  read.kind = known->second;
  read.plane = reader.text(object, place, "plane", "");
  read.of = readNames(reader, object, place, "of", shapes);
  read.gap = readNames(reader, object, place, "gap_between", shapes);
  for (const auto& [field, target] : {std::pair{"from_surface", &read.fromSurface}, std::pair{"to_surface", &read.toSurface}}) {
    if (object.contains(field) && shapeKnown(reader, object[field], place + "." + field, shapes))
      *target = object[field].get<std::string>();
  }
  for (const auto& [field, target] :
       {std::pair{"at_mm", &read.at_mm}, std::pair{"from_mm", &read.from_mm}, std::pair{"to_mm", &read.to_mm}}) {
    if (object.contains(field)) *target = reader.vector(object, place, field);
  }
  const bool section = read.kind == MeasurementKind::circumference;
  read.direction =
      readDirection(reader, object, place, section ? "normal" : "direction", section ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
  const std::string where = reader.text(object, place, "place", "given");
  if (where == "largest") read.place = TubePlace::largest;
  if (where == "smallest") read.place = TubePlace::smallest;
  if (where != "largest" && where != "smallest" && where != "given")
    reader.refuse(place + ".place", '"' + where + '"', "\"largest\", \"smallest\" or \"given\"");
  if (reader.problem()) return read;

  const bool line = read.from_mm && read.to_mm;
  if (read.kind == MeasurementKind::distance) {
    if (!line || glm::distance(*read.from_mm, *read.to_mm) < 0.01)
      reader.refuse(place, "a distance without a line", "from_mm and to_mm, two places");
    if (line && !(glm::distance(*read.from_mm, *read.to_mm) <= kLongestLine_mm))
      reader.refuse(place, "a distance along a line of " + textOf(glm::distance(*read.from_mm, *read.to_mm)) + " mm",
                    "two places at most " + textOf(kLongestLine_mm) + " mm apart");
    if ((!read.gap.empty() && read.gap.size() != 2) || read.fromSurface.empty() != read.toSurface.empty())
      reader.refuse(place, "one surface without the other", "two surfaces");
    return read;
  }
  if (read.of.empty()) reader.refuse(place + ".of", "missing", "the name of a shape or organ");
  if (reader.problem()) return read;
  const bool tube = shapes.at(read.of.front())->centreLine() != nullptr;
  if (read.kind == MeasurementKind::diameter && read.place == TubePlace::given && !read.at_mm)
    reader.refuse(place + ".at_mm", "missing", "a place, or \"place\": \"largest\" or \"smallest\" of a tube");
  if (read.kind == MeasurementKind::diameter && read.place != TubePlace::given && !tube)
    reader.refuse(place + ".of", '"' + read.of.front() + '"', "a tube, or at_mm in place of " + where);
  if (section && !read.at_mm) reader.refuse(place + ".at_mm", "missing", "a place inside the section");
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

std::vector<MeasurementRequest> readMeasurements(FieldReader& reader, const json& recipe, const NamedShapes& shapes,
                                                 const std::vector<StandardPlane>& planes) {
  std::vector<MeasurementRequest> read;
  if (!recipe.contains("measurements")) return read;
  std::set<std::string> names;
  const json& list = reader.list(recipe, "patient", "measurements", 0, kMostTruthEntries);
  for (std::size_t n = 0; n < list.size() && !reader.problem(); ++n) {
    const std::string place = "measurements[" + std::to_string(n) + "]";
    read.push_back(readMeasurement(reader, list[n], place, shapes));
    const MeasurementRequest& last = read.back();
    if (!reader.problem() && !names.insert(last.name).second)
      reader.refuse(place + ".name", '"' + last.name + '"', "a name that is not taken yet");
    if (!reader.problem() && !last.plane.empty() &&
        std::none_of(planes.begin(), planes.end(), [&](const StandardPlane& plane) { return plane.name == last.plane; }))
      reader.refuse(place + ".plane", '"' + last.plane + '"', "the name of one of the planes");
  }
  return read;
}

std::vector<StandardPlane> readPlanes(FieldReader& reader, const json& recipe, const ShapePtr& skin, const NamedShapes& shapes,
                                      Progress& progress) {
  std::vector<StandardPlane> read;
  if (!recipe.contains("planes")) return read;
  std::set<std::string> names;
  const json& list = reader.list(recipe, "patient", "planes", 0, kMostTruthEntries);
  for (std::size_t n = 0; n < list.size() && !reader.problem() && !progress.cancelRequested(); ++n) {
    const json& object = list[n];
    const std::string place = "planes[" + std::to_string(n) + "]";
    reader.allow(object, place, {"near_mm", "towards_mm", "lateral", "position_tolerance_mm", "angle_tolerance_deg", "shows"});
    if (reader.problem()) break;
    StandardPlane plane;
    plane.name = reader.text(object, place, "name");
    const glm::dvec3 near = reader.vector(object, place, "near_mm");
    const glm::dvec3 lateral = readDirection(reader, object, place, "lateral", glm::dvec3(1, 0, 0));
    plane.positionTolerance_mm = reader.number(object, place, "position_tolerance_mm", 0.0, 1000.0, plane.positionTolerance_mm);
    plane.angleTolerance_deg = reader.number(object, place, "angle_tolerance_deg", 0.0, 180.0, plane.angleTolerance_deg);
    plane.shows = readNames(reader, object, place, "shows", shapes);
    if (!reader.problem() && !names.insert(plane.name).second)
      reader.refuse(place + ".name", '"' + plane.name + '"', "a name that is not taken yet");
    glm::dvec3 into = inwards(skin, near);
    if (object.contains("towards_mm")) {
      const glm::dvec3 way = reader.vector(object, place, "towards_mm") - near;
      if (!(glm::length(way) > 1.0)) reader.refuse(place + ".towards_mm", "at near_mm", "a place at least 1 mm away from it");
      into = glm::normalize(way);
    }
    if (reader.problem()) break;
    const auto face = skinBehind(skin, near, into);
    if (!face) reader.refuse(place + ".near_mm", "away from the body", "a place near the skin");
    const glm::dvec3 across = lateral - into * glm::dot(lateral, into);
    if (!(glm::length(across) > 1e-3)) reader.refuse(place + ".lateral", "along the beam", "a direction across the beam");
    if (reader.problem()) break;
    const glm::dvec3 x = glm::normalize(across);
    plane.probeToWorld.matrix =
        glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(into, 0.0), glm::dvec4(glm::cross(x, into), 0.0), glm::dvec4(*face, 1.0));
    read.push_back(std::move(plane));
  }
  return read;
}

}  // namespace ew::phantom
