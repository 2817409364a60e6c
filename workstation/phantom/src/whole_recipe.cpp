#include "whole_recipe.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "ew/core/numbers.h"
#include "expression.h"

namespace ew::phantom {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestFamily = 8;
constexpr std::size_t kMostEntries = 1000;  // of a list or of the parameters: an anatomy has dozens
constexpr int kLongestChain = 20;           // of parameters that rest on one another: each is worked out inside the one before
constexpr double kLargestParameter = 1e5;
const std::set<std::string> kNamedLists{"frames", "measurements", "organs", "planes", "shapes", "tissues"};
const std::set<std::string> kWords{"name", "note", "source", "unit"};  // never expressions

/// Where in a list an entry of this name stands; its size when there is none.
std::size_t placeOf(const json& list, const std::string& name) {
  for (std::size_t n = 0; n < list.size(); ++n) {
    if (list[n].is_object() && list[n].value("name", json()) == name) return n;
  }
  return list.size();
}

/// Refuses lists and parameters that a recipe's child could not be merged into.
void checkMergeable(FieldReader& reader, const json& recipe) {
  const std::string most = " of at most " + std::to_string(kMostEntries) + " entries";
  for (const std::string& list : kNamedLists) {
    const auto found = recipe.find(list);
    if (found == recipe.end()) continue;
    if (!found->is_array() || found->size() > kMostEntries)
      return reader.refuse(list, found->is_array() ? "a list of " + std::to_string(found->size()) + " entries" : shown(*found),
                           "a list" + most);
    for (std::size_t n = 0; n < found->size(); ++n) {
      if (!(*found)[n].is_object()) return reader.refuse(list + "[" + std::to_string(n) + "]", shown((*found)[n]), "an object with a name");
    }
  }
  const auto parameters = recipe.find("parameters");
  if (parameters == recipe.end()) return;
  if (!parameters->is_object() || parameters->size() > kMostEntries)
    return reader.refuse("parameters", parameters->is_object() ? std::to_string(parameters->size()) + " entries" : shown(*parameters),
                         "an object with one entry for each name," + most);
  if (recipe.contains("extends")) return;  // there a plain number is the default of a parameter described further up
  for (const auto& [name, description] : parameters->items()) {
    if (!description.is_object())
      return reader.refuse("parameters." + name, shown(description), "an object with default, lowest, highest and unit");
  }
}

void removeNamed(FieldReader& reader, const json& remove, json& into) {
  reader.allow(remove, "remove", kNamedLists);
  if (reader.problem()) return;
  for (const auto& [list, names] : remove.items()) {
    if (kNamedLists.count(list) == 0) continue;
    if (!names.is_array()) return reader.refuse("remove." + list, shown(names), "a list of names");
    for (const json& name : names) {
      const std::size_t at = into.contains(list) && name.is_string() ? placeOf(into[list], name.get<std::string>()) : 0;
      if (!name.is_string() || !into.contains(list) || at == into[list].size())
        return reader.refuse("remove." + list, shown(name), "names from the " + list + " of the recipe that this one extends");
      into[list].erase(at);
    }
  }
}

void mergeList(FieldReader& reader, const std::string& field, const json& entries, json& into) {
  if (into.is_null()) into = json::array();
  if (into.size() + entries.size() > 2 * kMostEntries)
    return reader.refuse(field, "with all it extends more than " + std::to_string(2 * kMostEntries) + " entries", "fewer of them");
  for (std::size_t n = 0; n < entries.size(); ++n) {
    const std::string place = field + "[" + std::to_string(n) + "]";
    json entry = entries[n];
    const std::string name = reader.text(entry, place, "name");
    const std::string before = reader.text(entry, place, "before", ""), after = reader.text(entry, place, "after", "");
    if (!before.empty() && !after.empty()) reader.refuse(place, "both before and after another", "one of them");
    if (reader.problem()) return;
    entry.erase("before");
    entry.erase("after");
    std::size_t at = placeOf(into, name);
    const bool known = at < into.size();
    if (known && field != "shapes") {
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
      if (at == into.size())
        return reader.refuse(place + (before.empty() ? ".after" : ".before"), '"' + anchor + '"', "the name of another of the " + field);
      if (before.empty()) ++at;
    }
    into.insert(into.begin() + static_cast<json::difference_type>(at), std::move(entry));
  }
}

void mergeParameters(FieldReader& reader, const json& given, json& into) {
  if (into.is_null()) into = json::object();
  for (const auto& [name, value] : given.items()) {
    if (value.is_object()) {
      if (!into.contains(name)) into[name] = json::object();
      into[name].update(value);
    } else if (into.contains(name)) {
      into[name]["default"] = value;
    } else {
      return reader.refuse("parameters." + name, shown(value), "an object with default, lowest, highest and unit");
    }
  }
}

/// `child` on top of `base`.
json merged(FieldReader& reader, json base, const json& child) {
  if (child.contains("remove")) removeNamed(reader, child["remove"], base);
  for (const auto& [field, value] : child.items()) {
    if (field == "remove" || field == "extends") continue;
    if (reader.problem()) break;
    if (kNamedLists.count(field) > 0)
      mergeList(reader, field, value, base[field]);
    else if (field == "parameters")
      mergeParameters(reader, value, base[field]);
    else if (field == "motion")
      base[field].merge_patch(value);
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
    auto recipe = readRecipe(files.back(), "virtual patient");
    if (!recipe) return passOn(recipe.error());
    recipes.push_back(std::move(*recipe));
    FieldReader reader(files.back().string());
    checkMergeable(reader, recipes.back());
    if (reader.problem()) return passOn(*reader.problem());
    if (!recipes.back().contains("extends")) break;
    const std::string name = reader.text(recipes.back(), "patient", "extends");
    if (!reader.problem() && std::filesystem::path(name).has_parent_path())
      reader.refuse("extends", '"' + name + '"', "the name of a file beside this one or in resources/anatomy, without a folder");
    if (!reader.problem() && files.size() == kLongestFamily)
      reader.refuse("extends", '"' + name + '"', "at most " + std::to_string(kLongestFamily) + " recipes that extend one another");
    if (reader.problem()) return passOn(*reader.problem());
    const auto next = findNamed(name, "anatomy", files.back(), anatomies);
    if (next.empty())
      return failure(ErrorCode::notFound,
                     files.back().string() + " extends " + name + ", which is neither beside it nor in resources/anatomy; put it there.",
                     {{"file", files.back().string()}, {"extends", name}});
    for (const auto& earlier : files) {
      if (std::filesystem::equivalent(earlier, next, ignored)) {
        reader.refuse("extends", '"' + name + '"', "a recipe that does not extend this one in turn");
        return passOn(*reader.problem());
      }
    }
    files.push_back(next);
  }
  json whole = std::move(recipes.back());
  for (std::size_t n = recipes.size() - 1; n-- > 0;) {
    FieldReader reader(files[n].string());
    whole = merged(reader, std::move(whole), recipes[n]);
    if (reader.problem()) return passOn(*reader.problem());
  }
  return whole;
}

/// The values of parameters, worked out as they are asked for: a default may be an expression of other parameters.
class Parameters {
 public:
  Parameters(FieldReader& reader, const json& recipe, const ParameterValues& given) : reader_(reader), given_(given) {
    const auto found = recipe.find("parameters");
    if (found == recipe.end()) return;
    if (found->is_object())
      described_ = *found;
    else
      reader.refuse("parameters", shown(*found), "an object with one entry for each name");
    for (const auto& [name, description] : described_.items()) {
      const std::string place = "parameters." + name;
      reader.allow(description, place, {"default", "lowest", "highest", "unit"});
      const bool usable =
          !name.empty() &&
          std::all_of(name.begin(), name.end(), [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }) &&
          !(name[0] >= '0' && name[0] <= '9') && name != "min" && name != "max";
      if (!usable) reader.refuse(place, "not a usable name", "small letters, digits and _, and neither min nor max");
      if (!reader.problem() && !description.contains("default")) reader.refuse(place + ".default", "missing", "a number or an expression");
    }
  }

  OrExpected<std::optional<double>> valueOf(const std::string& name) {
    if (const auto known = values_.find(name); known != values_.end()) {
      restsOn_ = std::max(restsOn_, known->second.chain);
      return std::optional<double>(known->second.value);
    }
    const auto description = described_.find(name);
    if (description == described_.end()) return std::optional<double>();
    const auto tooLong = [] {
      return tl::unexpected("parameters of which at most " + std::to_string(kLongestChain) + " rest on one another in a row");
    };
    if (beingWorkedOut_.count(name) > 0)
      return tl::unexpected("parameters that do not depend on one another in a circle, as " + name + " does");
    if (beingWorkedOut_.size() == kLongestChain) return tooLong();
    beingWorkedOut_.insert(name);
    const int beside = std::exchange(restsOn_, 0);
    const std::string place = "parameters." + name;
    json number = (*description)["default"];
    if (const auto given = given_.find(name); given != given_.end()) {
      number = given->second;
    } else if (number.is_string()) {
      auto value = ofText(number.get<std::string>());
      if (!value) return tl::unexpected(value.error());
      number = *value;
    }
    const double lowest = reader_.number(*description, place, "lowest", -kLargestParameter, kLargestParameter);
    const double highest = reader_.number(*description, place, "highest", -kLargestParameter, kLargestParameter);
    const double value = reader_.number(json{{"value", number}}, place, "value", lowest, highest);
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
    if (text.empty() || text[0] != '=') return tl::unexpected(std::string("a number or an expression that begins with ="));
    return phantom::valueOf(std::string_view(text).substr(1), [this](const std::string& name) { return valueOf(name); });
  }

  std::vector<PatientParameter> all() {
    std::vector<PatientParameter> list;
    for (const auto& [name, description] : described_.items()) {
      const auto value = valueOf(name);
      if (!value) reader_.refuse("parameters." + name + ".default", shown(description["default"]), value.error());
      if (reader_.problem()) return list;
      const std::string place = "parameters." + name;
      list.push_back({name, **value, reader_.number(description, place, "lowest", -kLargestParameter, kLargestParameter),
                      reader_.number(description, place, "highest", -kLargestParameter, kLargestParameter),
                      reader_.text(description, place, "unit"), description.value("note", std::string())});
    }
    for (const auto& [name, value] : given_) {
      if (described_.contains(name)) continue;
      const std::string names = listed(list, [](const PatientParameter& each) { return each.name; });
      reader_.refuse("parameters." + name, "set but not there",
                     names.empty() ? "no parameter at all: this recipe has none" : "one of " + names);
    }
    return list;
  }

 private:
  FieldReader& reader_;
  const ParameterValues& given_;
  json described_ = json::object();
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
void workOut(FieldReader& reader, Parameters& parameters, std::string& place, json& value) {
  if (reader.problem()) return;
  const std::size_t here = place.size();
  if (value.is_object()) {
    for (auto& [field, inner] : value.items()) {
      if (kWords.count(field) > 0) continue;
      place += (place.empty() ? "" : ".") + field;
      workOut(reader, parameters, place, inner);
      place.resize(here);
    }
  } else if (value.is_array()) {
    for (std::size_t n = 0; n < value.size(); ++n) {
      place += "[" + std::to_string(n) + "]";
      if (value[n].is_object() && value[n].contains("name") && value[n]["name"].is_string())
        place += " (" + value[n]["name"].get_ref<const std::string&>().substr(0, 60) + ")";
      workOut(reader, parameters, place, value[n]);
      place.resize(here);
    }
  } else if (value.is_string() && value.get_ref<const std::string&>().rfind('=', 0) == 0) {
    const auto number = parameters.ofText(value.get<std::string>());
    if (!number) return reader.refuse(place, shown(value), number.error());
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

Result<WholeRecipe> readWholeRecipe(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                                    const ParameterValues& values) {
  auto recipe = readFamily(file, mannequins.empty() ? mannequins : mannequins.parent_path() / "anatomy");
  if (!recipe) return passOn(recipe.error());
  FieldReader reader(file.string());
  if (recipe->contains("remove")) reader.refuse("remove", "here", "it only in a recipe that extends another");
  Parameters parameters(reader, *recipe, values);
  if (reader.problem()) return passOn(*reader.problem());
  WholeRecipe whole;
  whole.parameters = parameters.all();
  if (reader.problem()) return passOn(*reader.problem());
  recipe->erase("parameters");
  std::string place;
  workOut(reader, parameters, place, *recipe);
  if (reader.problem()) return passOn(*reader.problem());
  whole.json = std::move(*recipe);
  return whole;
}

}  // namespace ew::phantom
