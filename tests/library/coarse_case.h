#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/library/case.h"
#include "library/temporary_folder.h"

namespace ew::test {

/// A case with a coarse volume of its recipe, without sweeps; a case of a file as it is.
inline void copyCoarse(const std::filesystem::path& from, const std::filesystem::path& to, double spacing_mm) {
  std::filesystem::copy(from, to, std::filesystem::copy_options::recursive);
  nlohmann::json manifest = nlohmann::json::parse(textOf(to / "case.json"));
  if (!manifest["volume"].contains("recipe")) return;
  manifest["volume"].erase("sweeps");
  manifest["volume"].erase("reconstruct");
  manifest["volume"]["recipe_spacing_mm"] = spacing_mm;
  writeText(to / "case.json", manifest.dump());
}

/// Folders of the shipped cases.
inline std::vector<std::string> shippedIds() {
  std::vector<std::string> ids;
  for (const Case& each : listCases(*shippedCasesFolder()).cases) ids.push_back(each.folder.filename().string());
  return ids;
}

/// How a test calls one of them.
inline std::string nameOfCase(const ::testing::TestParamInfo<std::string>& given) {
  std::string name = given.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace ew::test
