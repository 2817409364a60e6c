#include "ew/core/foreign_json.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "ew/core/json_fields.h"

namespace ew {

namespace {
using Json = nlohmann::json;
}  // namespace

Result<Json> parseJson(std::string_view text, const Message& where, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    return failure(ErrorCode::tooLarge,
                   say<"%1 is longer than %2 bytes, which no such document is; check that it is the right one.">(where, limits.bytes),
                   {{"file", where.english()}});
  if (limits.depth != kDeepestNesting && nestsDeeperThan(text, limits.depth))
    return failure(ErrorCode::badHeader,
                   say<"%1 nests deeper than %2 levels, which no such document does; check that it is the right one.">(where, limits.depth),
                   {{"file", where.english()}});
  return parseJson(text, where);
}

Json jsonOrNull(std::string_view text, const JsonLimits& limits) {
  auto read = parseJson(text, {}, limits);
  return read ? std::move(*read) : Json();
}

const Json& memberOf(const Json& of, std::string_view key) {
  static const Json kNone;
  if (!of.is_object()) return kNone;
  const auto found = of.find(key);
  return found == of.end() ? kNone : *found;
}

std::string textAt(const Json& of, std::string_view key, std::string fallback) {
  const Json& found = memberOf(of, key);
  return found.is_string() ? found.get<std::string>() : std::move(fallback);
}

std::string wordsAt(const Json& of, std::string_view key) {
  const Json& found = memberOf(of, key);
  if (found.is_null()) return {};
  return found.is_string() ? found.get<std::string>() : found.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<double> numberAt(const Json& of, std::string_view key) {
  const Json& found = memberOf(of, key);
  if (!found.is_number() || !std::isfinite(found.get<double>())) return std::nullopt;
  return found.get<double>();
}

std::optional<long long> wholeAt(const Json& of, std::string_view key) {
  const Json& found = memberOf(of, key);
  if (!found.is_number_integer()) return std::nullopt;
  if (found.is_number_unsigned() && found.get<unsigned long long>() > std::numeric_limits<long long>::max()) return std::nullopt;
  return found.get<long long>();
}

bool flagAt(const Json& of, std::string_view key, bool fallback) {
  const Json& found = memberOf(of, key);
  return found.is_boolean() ? found.get<bool>() : fallback;
}

std::vector<std::string> textsAt(const Json& of, std::string_view key) {
  std::vector<std::string> texts;
  for (const Json& each : listAt(of, key))
    if (each.is_string()) texts.push_back(each.get<std::string>());
  return texts;
}

const Json& listAt(const Json& of, std::string_view key) {
  static const Json kEmpty = Json::array();
  const Json& found = memberOf(of, key);
  return found.is_array() ? found : kEmpty;
}

}  // namespace ew
