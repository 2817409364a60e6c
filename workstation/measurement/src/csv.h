#pragma once

#include <string>

namespace ew::measurement {

/// A field of a CSV file, in quotes where it needs them (RFC 4180).
[[nodiscard]] inline std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string made = "\"";
  for (const char c : text) {
    made += c;
    if (c == '"') made += c;
  }
  return made + '"';
}

}  // namespace ew::measurement
