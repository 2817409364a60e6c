#include "patient/whole_recipe.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "ew/core/foreign_json.h"
#include "ew/core/numbers.h"
#include "patient/expression.h"

namespace ew::phantom {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestFamily = 8;
constexpr std::size_t kMostEntries = 1000;  // of a list or of the parameters: an anatomy has dozens
constexpr int kLongestChain = 20;           // of parameters that rest on one another: each is worked out inside the one before
constexpr double kLargestParameter = 1e5;
constexpr std::size_t kLongestNote = 10000;
const std::vector<std::string> kNamedLists{"frames", "measurements", "organs", "planes", "shapes", "tissues"};
const std::set<std::string> kWords{"name", "note", "source", "unit"};  // never expressions

/// Where in a list an entry of this name stands; its size when there is none.
std::size_t placeOf(const json& list, const std::string& name) {
  for (std::size_t n = 0; n < list.size(); ++n) {
    if (memberOf(list[n], "name") == name) return n;
  }
  return list.size();
}

/// Refuses lists and parameters that a recipe's child could not be merged into.
void checkMergeable(const JsonFields& recipe) {
  for (const std::string& list : kNamedLists) {
    if (recipe.has(list)) static_cast<void>(recipe.objects(list, 0, kMostEntries, say<"a list of at most %1 entries">(kMostEntries)));
  }
  const JsonFields flow = recipe.object("flow");
  for (const char* list : {"waves", "streams"}) {
    if (flow.has(list)) static_cast<void>(flow.objects(list, 0, kMostEntries));
  }
  const JsonFields parameters = recipe.object("parameters");
  if (parameters.value().size() > kMostEntries)
    recipe.refuse("parameters", say<"%1 entries">(parameters.value().size()),
                  say<"an object with one entry for each name, of at most %1 entries">(kMostEntries));
  if (recipe.has("extends")) return;  // there a plain number is the default of a parameter described further up
  for (const auto& [name, description] : parameters.value().items()) {
    if (!description.is_object()) parameters.refuse(name, say<"an object with default, lowest, highest and unit">());
  }
}

void removeNamed(const JsonFields& remove, const std::string& list, json& from) {
  for (const std::string& name : remove.texts(list, 0, 2 * kMostEntries)) {
    const std::size_t at = from.is_array() ? placeOf(from, name) : 0;
    if (!from.is_array() || at == from.size())
      return remove.refuse(list, shown(name), say<"names from the %1 of the recipe that this one extends">(list));
    from.erase(at);
  }
}

/// Whether an entry whose name is taken changes the fields it gives, or takes the other's place.
enum class Taken { changed, replaced };

void mergeList(const JsonFields& recipe, const std::string& field, Taken taken, json& into) {
  const std::vector<JsonFields> entries = recipe.objects(field, 0, kMostEntries);
  if (into.is_null()) into = json::array();
  if (into.size() + entries.size() > 2 * kMostEntries)
    return recipe.refuse(field, say<"with all it extends a list of more than %1 entries">(2 * kMostEntries), say<"a shorter one">());
  for (const JsonFields& given : entries) {
    const std::string name = given.text("name");
    const std::string before = given.text("before", ""), after = given.text("after", "");
    if (!before.empty() && !after.empty()) given.refuseWhole(say<"both before and after another">(), say<"one of them">());
    if (!given.good()) return;
    json entry = given.value();
    entry.erase("before");
    entry.erase("after");
    std::size_t at = placeOf(into, name);
    const bool known = at < into.size();
    if (known && taken == Taken::changed) {
      json changed = into[at];
      for (const auto& [key, value] : entry.items()) {
        if (value.is_null())
          changed.erase(key);
        else
          changed[key] = value;
      }
      entry = std::move(changed);
    }
    const std::string& anchor = before.empty() ? after : before;
    if (known && anchor.empty()) {
      into[at] = std::move(entry);
      continue;
    }
    if (known) into.erase(at);
    at = into.size();
    if (!anchor.empty()) {
      at = placeOf(into, anchor);
      if (at == into.size()) return given.refuse(before.empty() ? "after" : "before", say<"the name of another of the %1">(field));
      if (before.empty()) ++at;
    }
    into.insert(into.begin() + static_cast<json::difference_type>(at), std::move(entry));
  }
}

void mergeParameters(const JsonFields& given, json& into) {
  if (into.is_null()) into = json::object();
  for (const auto& [name, value] : given.value().items()) {
    if (value.is_object()) {
      if (!into.contains(name)) into[name] = json::object();
      into[name].update(value);
    } else if (into.contains(name)) {
      into[name]["default"] = value;
    } else {
      return given.refuse(name, say<"an object with default, lowest, highest and unit">());
    }
  }
}

void mergeFlow(const JsonFields& given, json& into) {
  if (into.is_null()) into = json::object();
  for (const auto& [field, value] : given.value().items()) {
    if (!given.good()) return;
    if (field == "waves" || field == "streams")
      mergeList(given, field, Taken::changed, into[field]);
    else if (value.is_null())
      into.erase(field);
    else
      into[field] = value;
  }
}

/// `child` on top of `base`.
json merged(json base, const JsonFields& child) {
  const JsonFields remove = child.object("remove");
  remove.only(kNamedLists);
  for (const std::string& list : kNamedLists) {
    if (remove.has(list)) removeNamed(remove, list, base[list]);
  }
  for (const auto& [field, value] : child.value().items()) {
    if (field == "remove" || field == "extends") continue;
    if (!child.good()) break;
    if (std::find(kNamedLists.begin(), kNamedLists.end(), field) != kNamedLists.end())
      mergeList(child, field, field == "shapes" ? Taken::replaced : Taken::changed, base[field]);
    else if (field == "parameters")
      mergeParameters(child.object(field), base[field]);
    else if (field == "motion")
      base[field].merge_patch(value);
    else if (field == "flow")
      mergeFlow(child.object(field), base[field]);
    else
      base[field] = value;
  }
  return base;
}

/// The recipe with all it extends merged into it.
Result<json> readFamily(const std::filesystem::path& file, const std::filesystem::path& anatomies) {
  std::vector<std::filesystem::path> files{file};
  std::vector<json> recipes;
  std::error_code ignored;
  while (true) {
    auto recipe = readRecipe(files.back(), say<"virtual patient">());
    if (!recipe) return passOn(recipe.error());
    recipes.push_back(std::move(*recipe));
    JsonReading reading = readingOf(files.back());
    const JsonFields fields(recipes.back(), reading);
    checkMergeable(fields);
    if (reading.problem()) return passOn(*reading.problem());
    if (!fields.has("extends")) break;
    const std::string name = fields.text("extends");
    if (std::filesystem::path(name).has_parent_path())
      fields.refuse("extends", say<"the name of a file beside this one or in resources/anatomy, without a folder">());
    if (files.size() == kLongestFamily) fields.refuse("extends", say<"left out, as at most %1 recipes extend one another">(kLongestFamily));
    if (reading.problem()) return passOn(*reading.problem());
    const auto next = findNamed(name, "anatomy", files.back(), anatomies);
    if (next.empty())
      return failure(ErrorCode::notFound,
                     say<"%1 extends %2, which is neither beside it nor in resources/anatomy; put it there.">(files.back().string(), name),
                     {{"file", files.back().string()}, {"extends", name}});
    for (const auto& earlier : files) {
      if (std::filesystem::equivalent(earlier, next, ignored)) {
        fields.refuse("extends", say<"a recipe that does not extend this one in turn">());
        return passOn(*reading.problem());
      }
    }
    files.push_back(next);
  }
  json whole = std::move(recipes.back());
  for (std::size_t n = recipes.size() - 1; n-- > 0;) {
    JsonReading reading = readingOf(files[n]);
    whole = merged(std::move(whole), JsonFields(recipes[n], reading));
    if (reading.problem()) return passOn(*reading.problem());
  }
  return whole;
}

/// The values of parameters, worked out as they are asked for: a default may be an expression of other parameters.
class Parameters {
 public:
  Parameters(const JsonFields& recipe, const ParameterValues& given) : described_(recipe.object("parameters")), given_(given) {
    for (const auto& [name, ignored] : described_.value().items()) {
      const JsonFields description = described_.object(name);
      description.only({"default", "lowest", "highest", "unit"});
      const bool usable =
          !name.empty() &&
          std::all_of(name.begin(), name.end(), [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }) &&
          !(name[0] >= '0' && name[0] <= '9') && name != "min" && name != "max";
      if (!usable) described_.refuse(name, say<"not a usable name">(), say<"small letters, digits and _, and neither min nor max">());
      if (!description.has("default")) description.refuse("default", say<"a number or an expression">());
    }
  }

  OrExpected<std::optional<double>> valueOf(const std::string& name) {
    if (const auto known = values_.find(name); known != values_.end()) {
      restsOn_ = std::max(restsOn_, known->second.chain);
      return std::optional<double>(known->second.value);
    }
    if (!described_.has(name)) return std::optional<double>();
    const JsonFields description = described_.object(name);
    const auto tooLong = [] { return tl::unexpected(say<"parameters of which at most %1 rest on one another in a row">(kLongestChain)); };
    if (beingWorkedOut_.count(name) > 0)
      return tl::unexpected(say<"parameters that do not depend on one another in a circle, as %1 does">(name));
    if (beingWorkedOut_.size() == kLongestChain) return tooLong();
    beingWorkedOut_.insert(name);
    const int beside = std::exchange(restsOn_, 0);
    if (!description.has("default")) return std::optional<double>();  // refused already
    json number = *description.find("default");
    if (const auto given = given_.find(name); given != given_.end()) {
      number = given->second;
    } else if (number.is_string()) {
      auto value = ofText(number.get<std::string>());
      if (!value) return tl::unexpected(value.error());
      number = *value;
    }
    const auto [lowest, highest] = rangeOf(description);
    const auto within = numberWithin(number, lowest, highest);
    if (!within) described_.refuse(name + ".value", shown(number), rangeText(lowest, highest));
    const double value = within.value_or(lowest);
    beingWorkedOut_.erase(name);
    // By the whole chain, not by what is left of it to be worked out: which parameter is asked for first must not decide.
    const int chain = restsOn_ + 1;
    if (chain > kLongestChain) return tooLong();
    restsOn_ = std::max(beside, chain);
    values_[name] = {value, chain};
    return std::optional<double>(value);
  }

  /// The value of a text that begins with "=".
  OrExpected<double> ofText(const std::string& text) {
    if (text.empty() || text[0] != '=') return tl::unexpected(say<"a number or an expression that begins with =">());
    return phantom::valueOf(std::string_view(text).substr(1), [this](const std::string& name) { return valueOf(name); });
  }

  std::vector<PatientParameter> all() {
    std::vector<PatientParameter> list;
    for (const auto& [name, ignored] : described_.value().items()) {
      const JsonFields description = described_.object(name);
      const auto value = valueOf(name);
      if (!value) description.refuse("default", value.error());
      if (!described_.good()) return list;
      const auto [lowest, highest] = rangeOf(description);
      list.push_back({name, **value, lowest, highest, description.text("unit"), description.text("note", "", 0, kLongestNote)});
    }
    for (const auto& [name, value] : given_) {
      if (described_.has(name)) continue;
      const std::string names = listed(list, [](const PatientParameter& each) { return each.name; });
      described_.refuse(name, say<"set but not there">(),
                        names.empty() ? say<"no parameter at all: this recipe has none">() : say<"one of %1">(names));
    }
    return list;
  }

 private:
  static std::pair<double, double> rangeOf(const JsonFields& description) {
    return {description.number("lowest", -kLargestParameter, kLargestParameter),
            description.number("highest", -kLargestParameter, kLargestParameter)};
  }

  JsonFields described_;
  const ParameterValues& given_;
  struct Known {
    double value = 0.0;
    int chain = 1;  ///< parameters that rest on one another, this one included
  };
  std::map<std::string, Known> values_;
  int restsOn_ = 0;  ///< the longest chain of those asked for while one is worked out
  std::set<std::string> beingWorkedOut_;
};

/// Replaces the expressions below `value` by their numbers.
/// @param place of the value; as long as before when this returns
void workOut(JsonReading& reading, Parameters& parameters, std::string& place, json& value) {
  if (!reading.good()) return;
  const std::size_t here = place.size();
  if (value.is_object()) {
    for (auto& [field, inner] : value.items()) {
      if (kWords.count(field) > 0) continue;
      place += (place.empty() ? "" : ".") + field;
      workOut(reading, parameters, place, inner);
      place.resize(here);
    }
  } else if (value.is_array()) {
    for (std::size_t n = 0; n < value.size(); ++n) {
      place += "[" + std::to_string(n) + "]";
      if (value[n].is_object() && value[n].contains("name") && value[n]["name"].is_string())
        place += " (" + value[n]["name"].get_ref<const std::string&>().substr(0, 60) + ")";
      workOut(reading, parameters, place, value[n]);
      place.resize(here);
    }
  } else if (value.is_string() && value.get_ref<const std::string&>().rfind('=', 0) == 0) {
    const auto number = parameters.ofText(value.get<std::string>());
    if (!number) return reading.refuse(place, shown(value), number.error());
    value = *number;
  }
}

}  // namespace

std::filesystem::path findNamed(const std::string& name, const std::string& kind, const std::filesystem::path& file,
                                const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> candidates{file.parent_path() / name};
  if (!folder.empty()) candidates.push_back(folder / name);
  std::error_code failed;
  std::filesystem::path above = std::filesystem::absolute(file, failed).parent_path();
  for (int level = 0; level < 4 && above.has_relative_path(); ++level) {
    above = above.parent_path();
    candidates.push_back(above / "resources" / kind / name);
  }
  if (const char* resources = std::getenv("ECHOWEAVE_RESOURCES")) candidates.push_back(std::filesystem::path(resources) / kind / name);
  for (const auto& candidate : candidates) {
    if (std::filesystem::is_regular_file(candidate, failed)) return candidate;
  }
  return {};
}

Result<json> readWholeMannequin(const std::filesystem::path& file) {
  const Message kind = say<"mannequin recipe">();
  auto recipe = readRecipe(file, kind);
  if (!recipe || !recipe->contains("extends")) return recipe;
  JsonReading reading = readingOf(file);
  const JsonFields fields(*recipe, reading);
  fields.only({"format", "height_mm", "extends", "frames", "parts", "relief", "remove"});
  const std::string name = fields.text("extends");
  if (std::filesystem::path(name).has_parent_path())
    fields.refuse("extends", say<"the name of a file beside this one or in resources/mannequin, without a folder">());
  if (reading.problem()) return passOn(*reading.problem());
  const auto extended = findNamed(name, "mannequin", file, {});
  if (extended.empty())
    return failure(ErrorCode::notFound,
                   say<"%1 extends %2, which is neither beside it nor in resources/mannequin; put it there.">(file.string(), name),
                   {{"file", file.string()}, {"extends", name}});
  auto base = readRecipe(extended, kind);
  if (!base) return base;
  JsonReading baseReading = readingOf(extended);
  const JsonFields baseFields(*base, baseReading);
  if (baseFields.has("extends")) baseFields.refuse("extends", say<"left out in a recipe that another extends">());
  const JsonFields body = baseFields.object("body");
  static_cast<void>(body.objects("union", 1, kMostEntries));
  static_cast<void>(body.objects("relief", 0, kMostEntries));
  static_cast<void>(baseFields.objects("frames", 0, kMostEntries));
  if (baseReading.problem()) return passOn(*baseReading.problem());

  const JsonFields remove = fields.object("remove");
  remove.only({"parts", "relief"});
  json& parts = (*base)["body"]["union"];
  json& relief = (*base)["body"]["relief"];
  removeNamed(remove, "parts", parts);
  removeNamed(remove, "relief", relief);
  mergeList(fields, "frames", Taken::changed, (*base)["frames"]);
  mergeList(fields, "parts", Taken::replaced, parts);
  mergeList(fields, "relief", Taken::changed, relief);
  if (reading.problem()) return passOn(*reading.problem());
  for (const auto& [field, value] : recipe->items()) {
    if (field == "name" || field == "note" || field == "source" || field == "height_mm") (*base)[field] = value;
  }
  return base;
}

Result<WholeRecipe> readWholeRecipe(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                                    const ParameterValues& values) {
  const auto recipe = readFamily(file, mannequins.empty() ? mannequins : mannequins.parent_path() / "anatomy");
  if (!recipe) return passOn(recipe.error());
  JsonReading reading = readingOf(file);
  const JsonFields fields(*recipe, reading);
  if (fields.has("remove")) fields.refuse("remove", say<"here">(), say<"only in a recipe that extends another">());
  Parameters parameters(fields, values);
  WholeRecipe whole;
  whole.parameters = parameters.all();
  if (reading.problem()) return passOn(*reading.problem());
  whole.json = *recipe;
  whole.json.erase("parameters");
  std::string place;
  workOut(reading, parameters, place, whole.json);
  if (reading.problem()) return passOn(*reading.problem());
  return whole;
}

}  // namespace ew::phantom
