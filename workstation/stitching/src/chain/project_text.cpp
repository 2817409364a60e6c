#include <nlohmann/json.hpp>

#include "ew/stitching/project.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Empty: it lies elsewhere.
fs::path belowFolder(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_relative(folder);
  return !folder.empty() && !relative.empty() && *relative.begin() != ".." ? relative : fs::path();
}

std::string relativeText(const fs::path& file, const fs::path& folder) {
  const fs::path below = belowFolder(file, folder);
  return (below.empty() ? file : below).generic_string();
}

nlohmann::ordered_json pointOf(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

nlohmann::ordered_json entryOf(const ProjectVolume& volume, const fs::path& folder) {
  nlohmann::ordered_json entry;
  entry["name"] = volume.name;
  entry["file"] = relativeText(volume.file, folder);
  if (!volume.coverage.empty()) entry["coverage"] = relativeText(volume.coverage, folder);
  if (!volume.confidence.empty()) entry["confidence"] = relativeText(volume.confidence, folder);
  if (!volume.calibration.empty()) entry["calibration"] = relativeText(volume.calibration, folder);
  if (volume.spacing_mm != 0.0) entry["spacing_mm"] = volume.spacing_mm;
  if (volume.acceptsSmall) entry["accept_small"] = true;
  entry["placement"] = nameOf(volume.placement);
  entry["to_world"] = rowsOf(volume.toWorld);
  return entry;
}

nlohmann::ordered_json entryOf(const ProjectPair& pair, const std::vector<ProjectVolume>& volumes) {
  nlohmann::ordered_json entry;
  entry["fixed"] = volumes.at(pair.fixed).name;
  entry["moving"] = volumes.at(pair.moving).name;
  entry["method"] = nameOf(pair.method);
  entry["decision"] = nameOf(pair.decision);
  if (pair.start) entry["start"] = rowsOf(*pair.start);
  for (const auto& landmark : pair.landmarks)
    entry["landmarks"].push_back(
        {{"name", landmark.name}, {"fixed_mm", pointOf(landmark.fixed_mm)}, {"moving_mm", pointOf(landmark.moving_mm)}});
  if (pair.maxRotation_deg) entry["max_turn_deg"] = *pair.maxRotation_deg;
  if (pair.effort) entry["effort"] = nameOf(*pair.effort);
  return entry;
}

}  // namespace

std::vector<fs::path> filesElsewhere(const StitchProject& project, const fs::path& folder) {
  std::vector<fs::path> elsewhere;
  for (const ProjectVolume& volume : project.volumes)
    for (const fs::path& file : {volume.file, volume.coverage, volume.confidence, volume.calibration})
      if (!file.empty() && belowFolder(file, folder).empty()) elsewhere.push_back(file);
  return elsewhere;
}

std::string projectText(const StitchProject& project, const fs::path& folder) {
  nlohmann::ordered_json document;
  document["format"] = kProjectFormat;
  document["volumes"] = nlohmann::ordered_json::array();
  for (const auto& volume : project.volumes) document["volumes"].push_back(entryOf(volume, folder));
  document["pairs"] = nlohmann::ordered_json::array();
  for (const auto& pair : project.pairs) document["pairs"].push_back(entryOf(pair, project.volumes));
  const ProjectSettings& settings = project.settings;
  document["settings"] = {{"max_turn_deg", settings.maxRotation_deg},
                          {"tracker_error_mm", settings.trackerError_mm},
                          {"tracker_error_deg", settings.trackerError_deg},
                          {"equalise", settings.equalise},
                          {"elastic", settings.elastic},
                          {"effort", nameOf(settings.effort)},
                          {"fall_off_mm", settings.fallOff_mm}};
  const StitchOptions& grid = settings.join.grid;
  document["result"] = {{"spacing_mm", grid.spacing_mm},
                        {"feather_mm", grid.featherWidth_mm},
                        {"interpolated_weight", grid.interpolatedWeight},
                        {"axes", nameOf(grid.axes)}};
  const SeamOptions& seam = settings.join.seam;
  document["seam"] = {{"method", nameOf(seam.method)},
                      {"cell_mm", seam.cell_mm},
                      {"blend_mm", seam.blend_mm},
                      {"confidence_weight", seam.confidenceWeight},
                      {"distance_weight", seam.distanceWeight},
                      {"strokes", nlohmann::ordered_json::array()}};
  for (const auto& stroke : seam.strokes)
    document["seam"]["strokes"].push_back(
        {{"view", project.volumes.at(stroke.view).name}, {"at_mm", pointOf(stroke.at_mm)}, {"radius_mm", stroke.radius_mm}});
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace ew::stitching
