#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace ew::test {

/// A ball of skin of 60 mm with a ball of 20 mm in it, swept twice with few frames and a coarse volume: a whole preparation in a second.
inline void makeSmallCase(const std::filesystem::path& folder) {
  using nlohmann::json;
  const auto writeText = [](const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  };
  writeText(folder / "ball.json",
            R"({"format": 1, "name": "ball", "body": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}}})");
  writeText(folder / "patient.json", R"({"format": 1, "name": "ball", "mannequin": "ball.json",
    "box": {"lowest_mm": [-70, -70, -70], "highest_mm": [70, 70, 70]},
    "tissues": [{"name": "even", "echo_level": 110, "speckle": 1}, {"name": "dark", "echo_level": 20, "speckle": 0.2}],
    "background": "even",
    "organs": [{"name": "cyst", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, -20, 0], "radii_mm": [12, 12, 12]}}}],
    "planes": [{"name": "across", "near_mm": [0, -60, 0], "towards_mm": [0, 0, 0], "lateral": [-1, 0, 0], "shows": ["cyst"]}],
    "measurements": [{"name": "cyst, across", "kind": "extent", "of": "cyst", "direction": [1, 0, 0], "plane": "across"}]})");
  for (const auto& [name, z] : {std::pair{"upper", 1.0}, std::pair{"lower", -1.0}}) {
    const json sweep = {{"format", 1},
                        {"name", name},
                        {"probe", "linear-7.5"},
                        {"kind", "freehand"},
                        {"frames", 10},
                        {"machine", {{"depth_mm", 45}}},
                        {"stations",
                         {{{"near_mm", {0, -60, 10 * z}}, {"lateral", {-1, 0, 0}}, {"towards_mm", {0, 0, 10 * z}}},
                          {{"near_mm", {0, -60, -4 * z}}, {"lateral", {-1, 0, 0}}, {"towards_mm", {0, 0, -4 * z}}}}},
                        {"pixel_mm", 0.5}};
    writeText(folder / "sweeps" / (std::string(name) + ".json"), sweep.dump(2));
  }
  const json manifest = {
      {"format", 1},
      {"id", "small"},
      {"title", "Small"},
      {"volume",
       {{"recipe", "patient.json"},
        {"sweeps", {"sweeps/upper.json", "sweeps/lower.json"}},
        {"reconstruct", {{"spacing_mm", 1.0}, {"fill_reach_mm", 4}, {"feather_mm", 6}, {"labels_spacing_mm", 2}}}}},
      {"targets", {{{"kind", "plane"}, {"name", "across"}}, {{"kind", "structure"}, {"name", "the cyst"}, {"organ", "cyst"}}}},
      {"measurements", {{{"name", "cyst, across"}, {"tolerance", 2}}}}};
  writeText(folder / "case.json", manifest.dump(2));
}

}  // namespace ew::test
