#pragma once

#include <string>
#include <string_view>

#include "ew/core/json_fields.h"

namespace ew::assessment {

inline constexpr int kHighestFormVersion = 1'000'000;
inline constexpr std::size_t kLongestRatingId = 60;  // bytes; file names hold ids of forms

[[nodiscard]] inline bool isRatingId(std::string_view text) {
  return !text.empty() && text.size() <= kLongestRatingId && text.front() != '-' &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos;
}

/// Of a form, an item or a pass level. @param needed false: empty when it is not there
[[nodiscard]] inline std::string idIn(const JsonFields& fields, std::string_view key, bool needed = true) {
  if (!needed && !fields.has(key)) return {};
  const Message expected = say<"1 to %1 small letters, digits and hyphens, the first no hyphen">(kLongestRatingId);
  std::string id = fields.text(key, {}, 1, kLongestRatingId, expected);
  if (fields.good() && !isRatingId(id)) fields.refuse(key, expected);
  return id;
}

}  // namespace ew::assessment
