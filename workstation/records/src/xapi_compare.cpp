#include <algorithm>
#include <cmath>

#include "ew/records/xapi.h"

namespace ew {
namespace {

using nlohmann::json;

/// What lies along a path of names; null when it is not there.
const json& at(const json& value, std::initializer_list<const char*> path) {
  static const json kNothing;
  const json* here = &value;
  for (const char* name : path) {
    if (!here->is_object()) return kNothing;
    const auto next = here->find(name);
    if (next == here->end()) return kNothing;
    here = &*next;
  }
  return *here;
}

bool isEqual(const json& a, const json& b) {
  if (a.is_number() && b.is_number()) return std::abs(a.get<double>() - b.get<double>()) <= 1e-9 * (1.0 + std::abs(a.get<double>()));
  return a == b;
}

bool isSameUuid(const json& a, const json& b) {
  if (!a.is_string() || !b.is_string()) return a == b;
  const auto small = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
  };
  return small(a.get<std::string>()) == small(b.get<std::string>());
}

bool isSameMoment(const json& a, const json& b) {
  if (!a.is_string() || !b.is_string()) return true;  // a server may give a statement without one its own
  const auto one = momentOfTimestamp(a.get<std::string>()), other = momentOfTimestamp(b.get<std::string>());
  return !one || !other || *one == *other;
}

}  // namespace

bool saysTheSame(const json& a, const json& b) {
  for (const auto& path : {std::initializer_list<const char*>{"actor", "account"},
                           {"actor", "mbox"},
                           {"actor", "mbox_sha1sum"},
                           {"actor", "openid"},
                           {"verb", "id"},
                           {"object", "id"},
                           {"result", "success"},
                           {"result", "completion"},
                           {"result", "response"},
                           {"result", "score", "scaled"},
                           {"result", "score", "raw"}})
    if (!isEqual(at(a, path), at(b, path))) return false;
  return isSameUuid(at(a, {"id"}), at(b, {"id"})) && isSameUuid(at(a, {"context", "registration"}), at(b, {"context", "registration"})) &&
         isSameMoment(at(a, {"timestamp"}), at(b, {"timestamp"}));
}

}  // namespace ew
