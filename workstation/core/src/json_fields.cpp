#include "ew/core/json_fields.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ew/core/frames.h"
#include "ew/core/nesting.h"
#include "ew/core/numbers.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestShown = 60;
constexpr std::size_t kMostNamesShown = 32;
constexpr std::size_t kLongestName = 200;
constexpr long long kLargestWhole = 1LL << 53;

const json kNoObject = json::object();
const json kNoList = json::array();

template <class Names>
std::string listedNames(const Names& names) {
  std::string all;
  std::size_t count = 0;
  for (const auto& name : names) {
    if (++count > kMostNamesShown) return all + ", ...";
    all += (all.empty() ? "" : ", ") + std::string(name);
  }
  return all;
}

/// A name out of the document in a sentence: whatever its length.
std::string shortName(const std::string& name) {
  return name.size() <= kLongestShown ? name : "a name of " + std::to_string(name.size()) + " bytes";
}

Message countText(std::size_t atLeast, std::size_t atMost) {
  return atLeast == atMost ? verbatim(std::to_string(atLeast)) : say<"%1 to %2">(atLeast, atMost);
}

template <class Names>
void refuseOthers(const JsonFields& fields, const Names& known) {
  for (const auto& [name, value] : fields.value().items()) {
    if (!fields.good()) return;
    const auto& welcome = fields.reading().welcome();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    if (std::find(welcome.begin(), welcome.end(), name) == welcome.end())
      fields.refuse(shortName(name), say<"not known here">(), say<"one of %1">(listedNames(known)));
    else if (!value.is_string())
      fields.refuse(name, say<"a text">());
  }
}

}  // namespace

Message shown(const json& value) {
  const auto isShort = [](std::size_t size) { return size <= kLongestShown; };
  if (value.is_string() && !isShort(value.get_ref<const std::string&>().size()))
    return say<"a text of %1 bytes">(value.get_ref<const std::string&>().size());
  if (!value.is_structured() || isShort(value.size())) {
    std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (isShort(text.size())) return verbatim(std::move(text));
  }
  if (value.is_object()) return say<"an object with %1 fields">(value.size());
  if (value.is_array()) return say<"a list of %1">(value.size());
  return say<"a text of %1 bytes">(value.get_ref<const std::string&>().size());
}

Error fieldError(const Message& where, const std::string& field, const Message& found, const Message& expected) {
  return {ErrorCode::badField,
          field.empty() ? say<"%1 is %2; it must be %3.">(where, found, expected)
                        : say<"'%1' in %2 is %3; it must be %4.">(field, where, found, expected),
          {{"field", field}, {"found", found.english()}, {"expected", expected.english()}, {"in", where.english()}}};
}

std::optional<Error> rigidProblem(const glm::dmat4& matrix, const std::string& field, const Message& where) {
  auto checked = checkRigid(matrix);
  if (checked) return std::nullopt;
  Error problem = std::move(checked.error());
  problem.message = say<"'%1' in %2 cannot be used. %3">(field, where, std::move(problem.message));
  problem.context.insert(problem.context.begin(), {"field", field});
  return problem;
}

Message rangeText(double lowest, double highest) { return say<"a number from %1 to %2">(textOf(lowest), textOf(highest)); }

Message wholeRangeText(long long lowest, long long highest) { return say<"a whole number from %1 to %2">(lowest, highest); }

Message wordsText(std::span<const std::string_view> words) {
  const auto quoted = [](std::string_view word) { return '"' + std::string(word) + '"'; };
  if (words.empty()) return {};
  if (words.size() == 1) return verbatim(quoted(words.front()));
  std::string first;
  for (const std::string_view word : words.first(words.size() - 1)) first += (first.empty() ? "" : ", ") + quoted(word);
  return say<"%1 or %2">(first, quoted(words.back()));
}

Result<json> parseJson(std::string_view text, const Message& where) {
  if (nestsDeeperThan(text))
    return failure(
        ErrorCode::badHeader,
        say<"%1 nests deeper than %2 levels, which no file of this program does; check that it is the right file.">(where, kDeepestNesting),
        {{"file", where.english()}});
  try {
    return json::parse(text);
  } catch (const json::parse_error& problem) {
    const std::size_t end = std::min(problem.byte == 0 ? 0 : problem.byte - 1, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    const std::size_t lineStart = end == 0 ? std::string_view::npos : text.rfind('\n', end - 1);
    const std::size_t column = lineStart == std::string_view::npos ? end + 1 : end - lineStart;
    return failure(
        ErrorCode::badHeader,
        say<"%1 is not valid JSON: it breaks at line %2, column %3; correct it there or restore an earlier copy.">(where, line, column),
        {{"file", where.english()}, {"line", std::to_string(line)}, {"column", std::to_string(column)}});
  } catch (const std::exception& problem) {  // a number beyond what a double holds
    return failure(ErrorCode::badHeader, say<"%1 cannot be read as JSON; restore an earlier copy.">(where),
                   {{"file", where.english()}, {"reason", problem.what()}});
  }
}

Result<json> parseJsonObject(std::string_view text, const Message& where) {
  auto parsed = parseJson(text, where);
  if (parsed && !parsed->is_object())
    return failure(ErrorCode::badHeader, say<"%1 does not hold one JSON object; check that it is the right file.">(where),
                   {{"file", where.english()}});
  return parsed;
}

void JsonReading::refuse(const std::string& field, const Message& found, const Message& expected) {
  if (!problem_) problem_ = fieldError(where_, field, found, expected);
}

void JsonReading::refuse(Error problem) {
  if (!problem_) problem_ = std::move(problem);
}

JsonFields::JsonFields(const json& value, JsonReading& reading, std::string place)
    : object_(&value), reading_(&reading), place_(std::move(place)) {
  if (value.is_object()) return;
  object_ = &kNoObject;
  reading.refuse(place_, shown(value), say<"an object">());
}

std::string JsonFields::placeOf(std::string_view key) const { return place_.empty() ? std::string(key) : place_ + "." + std::string(key); }

const json* JsonFields::find(std::string_view key) const {
  const auto found = object_->find(std::string(key));
  return found == object_->end() ? nullptr : &*found;
}

void JsonFields::refuse(std::string_view key, const Message& found, const Message& expected) const {
  if (good()) reading_->refuse(placeOf(key), found, expected);
}

void JsonFields::refuse(std::string_view key, const Message& expected) const {
  if (!good()) return;
  const json* found = find(key);
  reading_->refuse(placeOf(key), found == nullptr ? say<"missing">() : shown(*found), expected);
}

void JsonFields::only(std::span<const std::string> known) const { refuseOthers(*this, known); }
void JsonFields::only(std::initializer_list<std::string_view> known) const { refuseOthers(*this, known); }

std::optional<double> numberWithin(const json& value, double lowest, double highest) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  if (!std::isfinite(number) || !(number >= lowest && number <= highest)) return std::nullopt;
  return number;
}

double JsonFields::number(std::string_view key, double lowest, double highest, std::optional<double> fallback,
                          const Message& expected) const {
  const json* found = good() ? find(key) : nullptr;
  if (found != nullptr)
    if (const auto value = numberWithin(*found, lowest, highest)) return *value;
  if (found != nullptr || !fallback) refuse(key, expected.empty() ? rangeText(lowest, highest) : expected);
  return fallback.value_or(lowest);
}

long long JsonFields::whole(std::string_view key, long long lowest, long long highest, std::optional<long long> fallback,
                            const Message& expected) const {
  const json* found = good() ? find(key) : nullptr;
  if (found != nullptr) {
    const auto value =
        numberWithin(*found, static_cast<double>(std::max(lowest, -kLargestWhole)), static_cast<double>(std::min(highest, kLargestWhole)));
    if (value && *value == std::floor(*value)) return static_cast<long long>(*value);
  }
  if (found != nullptr || !fallback) refuse(key, expected.empty() ? wholeRangeText(lowest, highest) : expected);
  return fallback.value_or(lowest);
}

std::vector<double> JsonFields::numbers(std::string_view key, std::size_t atLeast, std::size_t atMost, double lowest, double highest,
                                        bool needed, const Message& expected) const {
  const json* found = good() ? find(key) : nullptr;
  if (found == nullptr && !needed) return {};
  std::vector<double> values;
  bool fits = found != nullptr && found->is_array() && found->size() >= atLeast && found->size() <= atMost;
  for (std::size_t n = 0; fits && n < found->size(); ++n) {
    const auto value = numberWithin((*found)[n], lowest, highest);
    fits = value.has_value();
    values.push_back(value.value_or(0.0));
  }
  if (fits) return values;
  refuse(key, !expected.empty() ? expected
                                : say<"a list of %1 numbers from %2 to %3">(countText(atLeast, atMost), textOf(lowest), textOf(highest)));
  return {};
}

glm::dvec3 JsonFields::point(std::string_view key, double farthest, std::optional<glm::dvec3> fallback, const Message& expected) const {
  const Message three = say<"three numbers from %1 to %2">(textOf(-farthest), textOf(farthest));
  const auto values = numbers(key, 3, 3, -farthest, farthest, !fallback, expected.empty() ? three : expected);
  return values.size() == 3 ? glm::dvec3(values[0], values[1], values[2]) : fallback.value_or(glm::dvec3(0.0));
}

std::optional<glm::dmat4> JsonFields::rigid(std::string_view key, const Message& expected) const {
  const json* found = good() ? find(key) : nullptr;
  if (found == nullptr) return std::nullopt;
  std::array<double, 16> rows{};
  bool fits = found->is_array() && found->size() == rows.size();
  for (std::size_t n = 0; fits && n < rows.size(); ++n) {
    fits = (*found)[n].is_number();
    if (fits) rows[n] = (*found)[n].get<double>();
  }
  if (!fits) return refuse(key, expected.empty() ? say<"16 numbers, row by row">() : expected), std::nullopt;
  const glm::dmat4 matrix = matrixFromRows(rows);
  if (auto problem = rigidProblem(matrix, placeOf(key), reading_->where())) {
    reading_->refuse(std::move(*problem));
    return std::nullopt;
  }
  return matrix;
}

bool JsonFields::flag(std::string_view key, std::optional<bool> fallback) const {
  const json* found = good() ? find(key) : nullptr;
  if (found != nullptr && found->is_boolean()) return found->get<bool>();
  if (found != nullptr || !fallback) refuse(key, say<"true or false">());
  return fallback.value_or(false);
}

std::string JsonFields::text(std::string_view key, std::optional<std::string> fallback, std::size_t atLeast, std::size_t atMost,
                             const Message& expected) const {
  const json* found = good() ? find(key) : nullptr;
  if (found != nullptr && found->is_string()) {
    const auto& text = found->get_ref<const std::string&>();
    if (text.size() >= atLeast && text.size() <= atMost) return text;
  }
  if (found != nullptr || !fallback) refuse(key, !expected.empty() ? expected : say<"a text of %1 bytes">(countText(atLeast, atMost)));
  return std::move(fallback).value_or(std::string());
}

std::vector<std::string> JsonFields::texts(std::string_view key, std::size_t atLeast, std::size_t atMost, const Message& expected) const {
  std::vector<std::string> all;
  const json& entries = list(key, atLeast, atMost, expected);
  for (std::size_t n = 0; n < entries.size(); ++n) {
    const bool fits = entries[n].is_string() && !entries[n].get_ref<const std::string&>().empty() &&
                      entries[n].get_ref<const std::string&>().size() <= kLongestName;
    if (!fits) {
      refuse(std::string(key) + "[" + std::to_string(n) + "]", shown(entries[n]), say<"a text of %1 bytes">(countText(1, kLongestName)));
      return {};
    }
    all.push_back(entries[n].get<std::string>());
  }
  return all;
}

std::optional<std::size_t> JsonFields::wordAmong(std::string_view key, std::span<const std::string_view> words, bool needed) const {
  const json* found = good() ? find(key) : nullptr;
  if (found == nullptr && !needed) return std::nullopt;
  if (found != nullptr && found->is_string()) {
    const auto at = std::find(words.begin(), words.end(), found->get_ref<const std::string&>());
    if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
  }
  refuse(key, wordsText(words));
  return std::nullopt;
}

JsonFields JsonFields::object(std::string_view key) const {
  const json* found = good() ? find(key) : nullptr;
  return {found == nullptr ? kNoObject : *found, *reading_, placeOf(key)};
}

const json& JsonFields::list(std::string_view key, std::size_t atLeast, std::size_t atMost, const Message& expected) const {
  const json* found = good() ? find(key) : nullptr;
  if (found != nullptr && found->is_array() && found->size() >= atLeast && found->size() <= atMost) return *found;
  if (found == nullptr && atLeast == 0) return kNoList;
  refuse(key,
         found != nullptr && found->is_array() ? say<"a list of %1">(found->size())
         : found == nullptr                    ? say<"missing">()
                                               : shown(*found),
         expected.empty() ? say<"a list of %1 entries">(countText(atLeast, atMost)) : expected);
  return kNoList;
}

std::vector<JsonFields> JsonFields::objects(std::string_view key, std::size_t atLeast, std::size_t atMost, const Message& expected) const {
  std::vector<JsonFields> all;
  const json& entries = list(key, atLeast, atMost, expected);
  all.reserve(entries.size());
  for (std::size_t n = 0; n < entries.size() && good(); ++n)
    all.emplace_back(entries[n], *reading_, placeOf(key) + "[" + std::to_string(n) + "]");
  return all;
}

}  // namespace ew
