#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/library/case.h"
#include "library/temporary_folder.h"

namespace ew::test {

inline nlohmann::json smallest() {
  return {{"format", kCaseFormat}, {"id", "one"}, {"title", "One"}, {"volume", {{"file", "volumes/a.mha"}}}};
}

/// A case folder with the files a manifest may name.
inline void makeCase(const std::filesystem::path& folder, const nlohmann::json& manifest) {
  writeText(folder / "case.json", manifest.dump(2));
  writeText(folder / "volumes/a.mha", "no volume, but a file");
  writeText(folder / "patient.json", "{}");
}

/// What the context of an error says under that name; empty: nothing.
inline std::string context(const Error& error, const std::string& name) {
  for (const auto& [key, value] : error.context)
    if (key == name) return value;
  return {};
}

}  // namespace ew::test
