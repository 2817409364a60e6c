#include "ew/library/schema.h"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "ew/core/json_fields.h"
#include "files/schema_text.h"
#include "files/value_rules.h"

namespace ew {

Message expectation(const std::string& description) {
  if (description.empty()) return {};
  static std::mutex guard;
  static auto& texts = *new std::map<std::string, const MessageText*>;
  const std::lock_guard lock(guard);
  const auto [at, isNew] = texts.try_emplace(description, nullptr);
  if (isNew) at->second = new MessageText(at->first.c_str());
  return MessageMaker::of(at->second->text, {});
}

namespace {

struct SchemaRules {
  nlohmann::json document;
  valijson::Schema rules;
};

void enterExpectations(const nlohmann::json& schema) {
  if (!schema.is_structured()) return;
  if (schema.is_object() && schema.contains("description") && schema["description"].is_string())
    static_cast<void>(expectation(schema["description"].get<std::string>()));
  for (const auto& inner : schema) enterExpectations(inner);
}

void compile(SchemaRules& schema) {
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema.document), schema.rules);
  enterExpectations(schema.document);
}

const SchemaRules& loadedSchema(SchemaName name) {
  const auto load = [](const char* text, SchemaRules& into, bool asksForFields) {
    into.document = nlohmann::json::parse(text);
    if (!asksForFields) into.document.erase("required");
    compile(into);
    return true;
  };
  switch (name) {
    case SchemaName::caseManifest: {
      static SchemaRules caseSchema;
      static const bool ready = load(kCaseSchemaText, caseSchema, true);
      static_cast<void>(ready);
      return caseSchema;
    }
    case SchemaName::caseOtherFields: {
      static SchemaRules otherFieldsSchema;
      static const bool ready = load(kCaseSchemaText, otherFieldsSchema, false);
      static_cast<void>(ready);
      return otherFieldsSchema;
    }
    case SchemaName::pluginManifest:
      break;
  }
  static SchemaRules pluginSchema;
  static const bool ready = load(kPluginSchemaText, pluginSchema, true);
  static_cast<void>(ready);
  return pluginSchema;
}

/// One step into a document: a property's name or an index.
using Path = std::vector<std::string>;

/// valijson writes a place as "<root>", "[patient]", "[3]".
Path pathOf(const std::vector<std::string>& context) {
  Path path;
  for (std::size_t i = 1; i < context.size(); ++i) {
    const std::string& step = context[i];
    path.push_back(step.size() >= 2 && step.front() == '[' && step.back() == ']' ? step.substr(1, step.size() - 2) : step);
  }
  return path;
}

bool isIndex(const std::string& step) {
  return !step.empty() && step.size() < 10 && std::all_of(step.begin(), step.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string fieldName(const Path& path) {
  std::string name;
  for (const auto& step : path) {
    if (isIndex(step))
      name += "[" + step + "]";
    else
      name += (name.empty() ? "" : ".") + step;
  }
  return name;
}

const nlohmann::json* valueAt(const nlohmann::json& document, const Path& path) {
  const nlohmann::json* at = &document;
  for (const auto& step : path) {
    if (at->is_object() && at->contains(step))
      at = &(*at)[step];
    else if (at->is_array() && isIndex(step) && std::stoul(step) < at->size())
      at = &(*at)[std::stoul(step)];
    else
      return nullptr;
  }
  return at;
}

Message expectedAt(const nlohmann::json& schema, const Path& path) {
  const nlohmann::json* at = &schema;
  for (const auto& step : path) {
    if (at->contains("properties") && (*at)["properties"].contains(step))
      at = &(*at)["properties"][step];
    else if (at->contains("items"))
      at = &(*at)["items"];
    else
      return {};
  }
  return expectation(at->value("description", std::string()));
}

std::optional<std::string> missingProperty(const std::string& description) {
  constexpr std::string_view opening = "Missing required property '";
  if (!description.starts_with(opening) || !description.ends_with("'.")) return std::nullopt;
  return description.substr(opening.size(), description.size() - opening.size() - 2);
}

/// valijson reports the failure of a child once more at each of its parents; those say nothing new.
bool onlyRepeatsAChild(const std::string& description) {
  constexpr std::array<std::string_view, 4> repeats = {"Failed to validate against schema associated with property name",
                                                       "Failed to validate item #", "Failed to validate against child schema #",
                                                       "Failed to validate against additional"};
  return std::any_of(repeats.begin(), repeats.end(), [&](std::string_view r) { return description.starts_with(r); });
}

/// @param place of `document` in the one that is named; empty: it is that one
Error problemAt(const nlohmann::json& document, const nlohmann::json& schema, const Path& path, const std::string& place,
                const Message& documentName) {
  const nlohmann::json* found = valueAt(document, path);
  const std::string inside = fieldName(path);
  const std::string field = place.empty() || inside.empty() ? place + inside : place + (inside.front() == '[' ? "" : ".") + inside;
  const Message expected = expectedAt(schema, path);
  const Message foundThere = found == nullptr ? say<"missing">() : shown(*found);
  if (expected.empty())
    return {ErrorCode::badField,
            field.empty() ? say<"%1 is %2, which cannot be used.">(documentName, foundThere)
                          : say<"'%1' in %2 is %3, which cannot be used.">(field, documentName, foundThere),
            {{"field", field}, {"found", foundThere.english()}, {"in", documentName.english()}}};
  return fieldError(documentName, field, foundThere, expected);
}

/// Texts that are too long for their pattern. std::regex recurses once per character, so these must never reach it.
std::vector<Error> overlongPatterns(const nlohmann::json& document, const nlohmann::json& schema, const Message& documentName) {
  std::vector<Error> problems;
  if (!document.is_object()) return problems;
  for (const auto& [name, rule] : schema["properties"].items()) {
    if (!rule.contains("pattern") || !document.contains(name) || !document[name].is_string()) continue;
    if (document[name].get_ref<const std::string&>().size() > rule["maxLength"].get<std::size_t>())
      problems.push_back(problemAt(document, schema, {name}, {}, documentName));
  }
  return problems;
}

std::vector<Error> problemsOf(const nlohmann::json& document, const SchemaRules& schema, const std::string& place,
                              const Message& documentName) {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  valijson::ValidationResults results;
  if (validator.validate(schema.rules, valijson::adapters::NlohmannJsonAdapter(document), &results)) return {};

  std::vector<Error> problems;
  const auto add = [&](Error problem) {
    // A value that breaks two rules (type and range) is one problem to its author.
    if (std::none_of(problems.begin(), problems.end(), [&](const Error& p) { return p.context.front() == problem.context.front(); }))
      problems.push_back(std::move(problem));
  };
  valijson::ValidationResults::Error error;
  std::vector<valijson::ValidationResults::Error> all;
  while (results.popError(error)) all.push_back(error);
  for (const auto& each : all) {
    Path path = pathOf(each.context);
    if (const auto missing = missingProperty(each.description)) {
      // The branches of a oneOf report their own requirements; only the oneOf as a whole is a sentence worth saying.
      const nlohmann::json* owner = &schema.document;
      for (const auto& step : path)
        if (owner->contains("properties") && (*owner)["properties"].contains(step)) owner = &(*owner)["properties"][step];
      const auto required = owner->value("required", nlohmann::json::array());
      if (std::find(required.begin(), required.end(), *missing) == required.end()) continue;
      path.push_back(*missing);
    } else if (onlyRepeatsAChild(each.description)) {
      continue;
    }
    add(problemAt(document, schema.document, path, place, documentName));
  }
  // Whatever valijson found must never be lost by the filters above.
  if (problems.empty())
    add(problemAt(document, schema.document, pathOf(all.empty() ? std::vector<std::string>{} : all.front().context), place, documentName));
  return problems;
}

std::size_t longestText(const nlohmann::json& value) {
  if (value.is_string()) return value.get_ref<const std::string&>().size();
  std::size_t longest = 0;
  if (value.is_structured())
    for (const auto& each : value) longest = std::max(longest, longestText(each));
  return longest;
}

constexpr std::size_t kLongestForPatterns = 2000;

}  // namespace

const nlohmann::json& caseRules() { return loadedSchema(SchemaName::caseManifest).document; }

std::vector<Error> schemaProblems(const nlohmann::json& document, SchemaName name, const Message& documentName) {
  const SchemaRules& schema = loadedSchema(name);
  if (auto overlong = overlongPatterns(document, schema.document, documentName); !overlong.empty()) return overlong;
  return problemsOf(document, schema, {}, documentName);
}

struct PartSchema::Loaded {
  SchemaRules schema;
  bool hasPatterns = false;
};

Result<PartSchema> PartSchema::of(const std::string& text, const Message& documentName) {
  auto parsed = parseJson(text, documentName);
  if (!parsed) return passOn(parsed.error());
  auto loaded = std::make_shared<Loaded>();
  loaded->schema.document = std::move(*parsed);
  loaded->hasPatterns = text.find("\"pattern") != std::string::npos;
  try {
    compile(loaded->schema);
  } catch (const std::exception& problem) {
    return failure(ErrorCode::badHeader,
                   say<"%1 is no JSON Schema that can be used; correct it (%2).">(documentName, verbatim(problem.what())),
                   {{"file", documentName.english()}, {"reason", problem.what()}});
  }
  PartSchema made;
  made.loaded_ = std::move(loaded);
  return made;
}

std::vector<Error> PartSchema::problems(const nlohmann::json& part, const std::string& place, const Message& documentName) const {
  const auto problem = [&](Message message) {
    return std::vector<Error>{
        {ErrorCode::badField, std::move(message), {{"field", place}, {"found", shown(part).english()}, {"expected", ""}}}};
  };
  // The library's patterns are std::regex, which recurses once per character.
  if (loaded_->hasPatterns && longestText(part) > kLongestForPatterns)
    return problem(
        say<"A text of '%1' in %2 is too long to be checked; shorten it to at most %3 bytes.">(place, documentName, kLongestForPatterns));
  try {
    return problemsOf(part, loaded_->schema, place, documentName);
  } catch (const std::exception& thrown) {
    return problem(
        say<"'%1' in %2 cannot be checked (%3); the schema of its plugin is wrong.">(place, documentName, verbatim(thrown.what())));
  }
}

}  // namespace ew
