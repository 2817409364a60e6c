#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "shape.h"

namespace ew::phantom {

/// A value as a sentence shows it: at most 60 characters.
[[nodiscard]] std::string shown(const nlohmann::json& value);

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

/// Reads fields of a JSON file and remembers the first that cannot be used, with its place, what was found and what was expected.
/// After a problem every call returns its fallback, so a reader reads on to its end and asks once.
class FieldReader {
 public:
  explicit FieldReader(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  void refuse(const std::string& place, const std::string& found, const std::string& expected);

  /// Refuses names that mean nothing here; "name", "note" and "source" are welcome everywhere.
  void allow(const nlohmann::json& object, const std::string& place, const std::set<std::string>& names);

  double number(const nlohmann::json& object, const std::string& place, const std::string& name, double lowest, double highest,
                std::optional<double> fallback = std::nullopt);
  glm::dvec3 vector(const nlohmann::json& object, const std::string& place, const std::string& name,
                    std::optional<glm::dvec3> fallback = std::nullopt);
  glm::dvec3 vectorIn(const nlohmann::json& value, const std::string& place);
  /// Names and words: 1 to 200 characters.
  std::string text(const nlohmann::json& object, const std::string& place, const std::string& name,
                   std::optional<std::string> fallback = std::nullopt);
  bool flag(const nlohmann::json& object, const std::string& place, const std::string& name, bool fallback);
  /// A list of at least `atLeast` and at most `atMost` entries; an empty list after a problem.
  const nlohmann::json& list(const nlohmann::json& object, const std::string& place, const std::string& name, std::size_t atLeast,
                             std::size_t atMost);

 private:
  std::string file_;
  std::optional<Error> problem_;
};

/// The JSON object in a file that says "format": 1.
/// @error notFound, tooLarge (above 8 MiB), badHeader (not JSON, or not an object), newerFormat,
///        badField (format; names of fields above 200 characters, texts above 10000)
[[nodiscard]] Result<nlohmann::json> readRecipe(const std::filesystem::path& file, const std::string& kind);

/// Shapes that a recipe can refer to by name.
using NamedShapes = std::map<std::string, ShapePtr>;

/// Frames that a recipe can draw shapes in, by name.
using NamedFrames = std::map<std::string, DrawingFrame>;

/// The recipe's "frames": each with a name, an origin and turns about x, then y, then z, given in the world or in the earlier frame
/// it names with "within". Empty when the recipe has none.
[[nodiscard]] NamedFrames readFrames(FieldReader& reader, const nlohmann::json& recipe);

/// The shape that a JSON object describes: exactly one of ellipsoid, capsule, tube, loft, half_space, shell, grown, union,
/// intersection, difference, or "of" with the name of an earlier shape; with "mirrored": true also its mirror image in x = 0.
/// With "frame" what it draws, its parts and its mirror image are in that frame; shapes it names stay where they are.
/// A shape of more than 20000 solids, a shared one counted at every use, or of more than 100 shapes inside one another is refused: it
/// could not be evaluated. Null after a problem. See the schemas of patients and mannequins for the fields.
[[nodiscard]] ShapePtr readShape(FieldReader& reader, const nlohmann::json& object, const std::string& place, const NamedShapes& known,
                                 const NamedFrames& frames = {});

}  // namespace ew::phantom
