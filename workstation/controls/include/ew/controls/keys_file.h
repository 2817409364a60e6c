#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ew/controls/binding.h"
#include "ew/core/result.h"

namespace ew::controls {

inline constexpr int kKeysFormat = 1;  ///< `format` of the file; one with a larger number is refused with newerFormat

/// What the user changed: resources/schemas/keys.schema.json.
struct KeysAndControls {
  std::map<std::string, std::vector<std::string>> keys;  ///< action: its keys ("Ctrl+F13"), all of them; none: it has no key
  std::vector<Binding> controls;
  bool operator==(const KeysAndControls&) const = default;
};

/// @param where how sentences name the document @error badField, newerFormat
[[nodiscard]] Result<KeysAndControls> keysFromJson(const nlohmann::json& document, const Message& where);
/// keysFromJson(toJson(k), where) == k
[[nodiscard]] nlohmann::json toJson(const KeysAndControls& keys);
/// @error notFound, notReadable, tooLarge (above 4 MiB), badHeader (not JSON), otherwise as keysFromJson
[[nodiscard]] Result<KeysAndControls> readKeys(const std::filesystem::path& file);
/// Whole or not at all. @error notWritable
[[nodiscard]] Result<void> writeKeys(const KeysAndControls& keys, const std::filesystem::path& file);

}  // namespace ew::controls
