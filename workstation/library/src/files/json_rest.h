#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace ew {

/// What an object holds besides the fields of these names: what another program put there is kept.
template <class Names>
nlohmann::json without(nlohmann::json object, const Names& names) {
  for (const auto name : names) object.erase(std::string(name));
  return object;
}

}  // namespace ew
