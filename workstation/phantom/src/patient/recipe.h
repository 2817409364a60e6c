#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/core/json_fields.h"
#include "ew/core/result.h"
#include "shapes/shape.h"

namespace ew::phantom {

/// How far from the origin a place in a recipe may lie.
inline constexpr double kFarthest_mm = 1e5;

/// Names as a sentence lists them: "a, b, c"; from the thirteenth on "...".
template <class Range, class NameOf>
[[nodiscard]] std::string listed(const Range& entries, const NameOf& nameOf) {
  constexpr int kMost = 12;
  std::string names;
  int count = 0;
  for (const auto& entry : entries) {
    if (++count > kMost) return names + ", ...";
    names += (names.empty() ? "" : ", ") + std::string(nameOf(entry));
  }
  return names;
}

/// What reads a recipe: "name", "note" and "source" are welcome in every object of it.
[[nodiscard]] JsonReading readingOf(const std::filesystem::path& file);

/// The JSON object in a file that says "format": 1.
/// @param kind what sentences call it: say<"sweep file">()
/// @error notFound, tooLarge (above 8 MiB), badHeader (not JSON, or not an object), newerFormat,
///        badField (format; names of fields above 200 characters, texts above 10000)
[[nodiscard]] Result<nlohmann::json> readRecipe(const std::filesystem::path& file, const Message& kind);

/// Shapes that a recipe can refer to by name.
using ShapesByName = std::map<std::string, ShapePtr>;

/// The shape that a field names; null after a problem.
[[nodiscard]] ShapePtr shapeNamed(const JsonFields& object, const std::string& field, const ShapesByName& known);

/// Frames that a recipe can draw shapes in, by name.
using FramesByName = std::map<std::string, DrawingFrame>;

/// The recipe's "frames": each with a name, an origin and turns about x, then y, then z, given in the world or in the earlier frame
/// it names with "within". Empty when the recipe has none.
[[nodiscard]] FramesByName readFrames(const JsonFields& recipe);

/// The shape that a JSON object describes: exactly one of ellipsoid, capsule, tube, loft, half_space, shell, grown, rough,
/// sheets, septa, patches, vessel_tree, vessels_beside, union, intersection, difference, or "of" with the name of an earlier shape; with
/// "mirrored": true also its mirror image in x = 0. With "frame" what it draws, its parts and its mirror image are in that frame; shapes it
/// names stay where they are. A shape of more than 20000 solids, a shared one counted at every use, or of more than 100 shapes inside one
/// another is refused: it could not be evaluated. Null after a problem. See the schemas of patients and mannequins for the fields.
[[nodiscard]] ShapePtr readShape(const JsonFields& object, const ShapesByName& known, const FramesByName& frames = {});

}  // namespace ew::phantom
