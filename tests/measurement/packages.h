#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/measurement/package.h"
#include "places.h"

namespace ew::measurement::test {

inline const std::filesystem::path kPackages = std::filesystem::path(EW_SOURCE_DIR) / "resources" / "measurements";

inline nlohmann::json document(const std::string& id) { return nlohmann::json::parse(std::ifstream(kPackages / (id + ".json"))); }

inline Package shipped(const std::string& id) {
  auto package = readPackage(kPackages / (id + ".json"));
  EXPECT_TRUE(package) << package.error();
  return package ? std::move(*package) : Package{};
}

}  // namespace ew::measurement::test
