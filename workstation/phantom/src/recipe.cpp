#include "recipe.h"

#include <cmath>
#include <fstream>
#include <system_error>

#include "ew/core/nesting.h"
#include "ew/core/numbers.h"

namespace ew::phantom {
namespace {

constexpr std::uintmax_t kLargestRecipe_bytes = 8u << 20;
constexpr std::size_t kLongestName = 200;
constexpr std::size_t kLongestText = 10000;

/// Sentences and places are put together from names and texts: one of megabytes would be copied for every field below it.
void refuseLongTexts(FieldReader& reader, const nlohmann::json& value, const std::string& field) {
  if (reader.problem()) return;
  if (value.is_string() && value.get_ref<const std::string&>().size() > kLongestText)
    return reader.refuse(field, "a text of " + std::to_string(value.get_ref<const std::string&>().size()) + " characters",
                         "at most " + std::to_string(kLongestText));
  if (value.is_object()) {
    for (const auto& [name, inner] : value.items()) {
      if (name.size() > kLongestName)
        return reader.refuse(name.substr(0, 57) + "...", "a name of " + std::to_string(name.size()) + " characters",
                             "at most " + std::to_string(kLongestName));
      refuseLongTexts(reader, inner, name);
    }
  } else if (value.is_array()) {
    for (const auto& inner : value) refuseLongTexts(reader, inner, field);
  }
}

}  // namespace

std::string shown(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

void FieldReader::refuse(const std::string& place, const std::string& found, const std::string& expected) {
  if (problem_) return;
  problem_ = Error{ErrorCode::badField,
                   "In " + file_ + " the field " + place + " is " + found + "; expected " + expected + ".",
                   {{"file", file_}, {"field", place}, {"found", found}, {"expected", expected}}};
}

void FieldReader::allow(const nlohmann::json& object, const std::string& place, const std::set<std::string>& names) {
  if (!object.is_object()) return refuse(place, shown(object), "an object");
  for (const auto& [name, value] : object.items()) {
    if (name == "name" || name == "note" || name == "source") {
      if (!value.is_string()) refuse(place + "." + name, shown(value), "a text");
      continue;
    }
    if (names.count(name) > 0) continue;
    std::string known;
    for (const std::string& each : names) known += (known.empty() ? "" : ", ") + each;
    return refuse(place + "." + name, "not known here", "one of " + known);
  }
}

double FieldReader::number(const nlohmann::json& object, const std::string& place, const std::string& name, double lowest, double highest,
                           std::optional<double> fallback) {
  const double safe = fallback.value_or(lowest);
  if (problem_) return safe;
  const auto found = object.find(name);
  const std::string range = "a number from " + textOf(lowest) + " to " + textOf(highest);
  if (found == object.end()) {
    if (!fallback) refuse(place + "." + name, "missing", range);
    return safe;
  }
  if (!found->is_number()) {
    refuse(place + "." + name, shown(*found), range);
    return safe;
  }
  const double value = found->get<double>();
  if (!(value >= lowest && value <= highest)) {
    refuse(place + "." + name, shown(*found), range);
    return safe;
  }
  return value;
}

glm::dvec3 FieldReader::vectorIn(const nlohmann::json& value, const std::string& place) {
  glm::dvec3 result(0.0);
  if (problem_) return result;
  bool good = value.is_array() && value.size() == 3;
  for (std::size_t axis = 0; good && axis < 3; ++axis) {
    good = value[axis].is_number();
    if (good) result[static_cast<int>(axis)] = value[axis].get<double>();
    good = good && std::abs(result[static_cast<int>(axis)]) <= 1e5;
  }
  if (good) return result;
  refuse(place, shown(value), "three numbers between -100000 and 100000");
  return glm::dvec3(0.0);
}

glm::dvec3 FieldReader::vector(const nlohmann::json& object, const std::string& place, const std::string& name,
                               std::optional<glm::dvec3> fallback) {
  if (problem_) return fallback.value_or(glm::dvec3(0.0));
  const auto found = object.find(name);
  if (found != object.end()) return vectorIn(*found, place + "." + name);
  if (!fallback) refuse(place + "." + name, "missing", "three numbers");
  return fallback.value_or(glm::dvec3(0.0));
}

std::string FieldReader::text(const nlohmann::json& object, const std::string& place, const std::string& name,
                              std::optional<std::string> fallback) {
  if (problem_) return fallback.value_or("");
  const auto found = object.find(name);
  if (found == object.end()) {
    if (!fallback) refuse(place + "." + name, "missing", "a text");
    return fallback.value_or("");
  }
  if (found->is_string() && !found->get_ref<const std::string&>().empty() && found->get_ref<const std::string&>().size() <= kLongestName)
    return found->get<std::string>();
  refuse(place + "." + name, shown(*found), "a text of 1 to " + std::to_string(kLongestName) + " characters");
  return fallback.value_or("");
}

bool FieldReader::flag(const nlohmann::json& object, const std::string& place, const std::string& name, bool fallback) {
  if (problem_) return fallback;
  const auto found = object.find(name);
  if (found == object.end()) return fallback;
  if (found->is_boolean()) return found->get<bool>();
  refuse(place + "." + name, shown(*found), "true or false");
  return fallback;
}

const nlohmann::json& FieldReader::list(const nlohmann::json& object, const std::string& place, const std::string& name,
                                        std::size_t atLeast, std::size_t atMost) {
  static const nlohmann::json kNothing = nlohmann::json::array();
  if (problem_) return kNothing;
  const auto found = object.find(name);
  const std::string expected = "a list of " + std::to_string(atLeast) + " to " + std::to_string(atMost) + " entries";
  if (found == object.end()) {
    refuse(place + "." + name, "missing", expected);
    return kNothing;
  }
  if (!found->is_array() || found->size() < atLeast || found->size() > atMost) {
    refuse(place + "." + name, found->is_array() ? "a list of " + std::to_string(found->size()) + " entries" : shown(*found), expected);
    return kNothing;
  }
  return *found;
}

Result<nlohmann::json> readRecipe(const std::filesystem::path& file, const std::string& kind) {
  const std::string name = file.string();
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    return failure(ErrorCode::notFound, "There is no " + kind + " at " + name + "; check the path.", {{"file", name}});
  const auto size = std::filesystem::file_size(file, failed);
  if (failed || size > kLargestRecipe_bytes)
    return failure(ErrorCode::tooLarge, name + " is larger than a " + kind + " can be (8 MiB); check that it is the right file.",
                   {{"file", name}});
  std::ifstream in(file, std::ios::binary);
  if (!in) return failure(ErrorCode::notReadable, name + " cannot be opened; check its permissions.", {{"file", name}});
  std::string text(static_cast<std::size_t>(size), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  nlohmann::json recipe = nestsDeeperThan(text) ? nlohmann::json() : nlohmann::json::parse(text, nullptr, false);
  if (recipe.is_discarded() || !recipe.is_object())
    return failure(ErrorCode::badHeader,
                   name + " is not a " + kind + ": it does not hold one JSON object, or nests too deeply; check that it is the right file.",
                   {{"file", name}});
  FieldReader reader(name);
  refuseLongTexts(reader, recipe, "");
  if (reader.problem()) return passOn(*reader.problem());
  const auto format = recipe.find("format");
  if (format == recipe.end() || !format->is_number_integer() || format->get<long long>() < 1)
    return failure(ErrorCode::badField,
                   "In " + name + " the field format is " + (format == recipe.end() ? "missing" : shown(*format)) + "; expected 1.",
                   {{"file", name}, {"field", "format"}});
  if (format->get<long long>() > 1)
    return failure(ErrorCode::newerFormat,
                   name + " has format " + shown(*format) + ", this program reads up to format 1; open it with a newer EchoWeave.",
                   {{"file", name}, {"format", shown(*format)}, {"supported", "1"}});
  return recipe;
}

}  // namespace ew::phantom
