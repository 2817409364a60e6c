#include "logic/edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "ew/core/frames.h"

namespace ew::case_authoring {
namespace {

constexpr const char* kGainPath = "scene.gain_and_dgc";

std::pair<std::string, std::string> split(const std::string& path) {
  const auto dot = path.find('.');
  return dot == std::string::npos ? std::pair{path, std::string()} : std::pair{path.substr(0, dot), path.substr(dot + 1)};
}

/// 16 numbers, row by row, as a transform; empty when it is anything else.
template <class To, class From>
std::optional<Transform<To, From>> transformIn(const nlohmann::json& value) {
  if (!value.is_array() || value.size() != 16 || !std::all_of(value.begin(), value.end(), [](const auto& n) { return n.is_number(); }))
    return std::nullopt;
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = value[i].get<double>();
  return Transform<To, From>{matrixFromRows(rows)};
}

}  // namespace

nlohmann::json fieldOf(const nlohmann::json& manifest, const std::string& path) {
  const auto [head, rest] = split(path);
  if (!manifest.is_object() || !manifest.contains(head)) return nullptr;
  return rest.empty() ? manifest[head] : fieldOf(manifest[head], rest);
}

nlohmann::json withField(nlohmann::json manifest, const std::string& path, const std::optional<nlohmann::json>& value) {
  const auto [head, rest] = split(path);
  if (!manifest.is_object()) manifest = nlohmann::json::object();
  if (rest.empty()) {
    if (value)
      manifest[head] = *value;
    else
      manifest.erase(head);
    return manifest;
  }
  auto inner = withField(manifest.contains(head) ? manifest[head] : nlohmann::json::object(), rest, value);
  if (inner.empty())
    manifest.erase(head);
  else
    manifest[head] = std::move(inner);
  return manifest;
}

nlohmann::json withText(nlohmann::json manifest, const std::string& path, const std::string& text) {
  const bool required = path == "id" || path == "title";
  if (text.empty() && !required) return withField(std::move(manifest), path, std::nullopt);
  return withField(std::move(manifest), path, text);
}

std::string textOf(const nlohmann::json& manifest, const std::string& path) {
  const auto value = fieldOf(manifest, path);
  return value.is_string() ? value.get<std::string>() : std::string();
}

bool hasEffect(const nlohmann::json& manifest, const std::string& path) {
  const auto value = fieldOf(manifest, path);
  if (value.is_boolean()) return value.get<bool>();
  return value.is_object() || (value.is_null() && path == kGainPath);
}

nlohmann::json withEffect(nlohmann::json manifest, const std::string& path, bool on) {
  if (hasEffect(manifest, path) == on) return manifest;
  // Gain and DGC are on when nothing is said, the others are off.
  if (!on && path != kGainPath) return withField(std::move(manifest), path, std::nullopt);
  return withField(std::move(manifest), path, on);
}

Result<Transform<frame::World, frame::File>> placeOf(const nlohmann::json& manifest) {
  const auto value = fieldOf(manifest, "volume.file_to_world");
  if (value.is_null()) return Transform<frame::World, frame::File>{};
  if (const auto fileToWorld = transformIn<frame::World, frame::File>(value)) return *fileToWorld;
  return failure(ErrorCode::badField,
                 say<"The volume's place is not 16 numbers, row by row; correct 'volume.file_to_world' in case.json.">(),
                 {{"field", "volume.file_to_world"}});
}

nlohmann::json withPlace(nlohmann::json manifest, const Transform<frame::World, frame::File>& fileToWorld) {
  return withField(std::move(manifest), "volume.file_to_world", nlohmann::json(rowsOf(fileToWorld)));
}

std::vector<std::string> probesOf(const nlohmann::json& manifest) {
  std::vector<std::string> ids;
  const auto listed = fieldOf(manifest, "probes");
  if (listed.is_array())
    for (const auto& id : listed)
      if (id.is_string()) ids.push_back(id.get<std::string>());
  return ids;
}

bool listsProbe(const nlohmann::json& manifest, const std::string& id) {
  const auto ids = probesOf(manifest);
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

nlohmann::json withProbe(nlohmann::json manifest, const std::string& id, bool listed) {
  auto ids = probesOf(manifest);
  std::erase(ids, id);
  if (listed == listsProbe(manifest, id)) return manifest;
  if (listed) ids.push_back(id);
  return withField(std::move(manifest), "probes", ids.empty() ? std::nullopt : std::optional<nlohmann::json>(ids));
}

std::string linesOf(const nlohmann::json& manifest, const std::string& path) {
  std::string lines;
  const auto list = fieldOf(manifest, path);
  if (list.is_array())
    for (const auto& one : list)
      if (one.is_string()) lines += (lines.empty() ? "" : "\n") + one.get<std::string>();
  return lines;
}

nlohmann::json withLines(nlohmann::json manifest, const std::string& path, const std::string& lines) {
  nlohmann::json list = nlohmann::json::array();
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) list.push_back(line);
  return withField(std::move(manifest), path, list.empty() ? std::nullopt : std::optional<nlohmann::json>(list));
}

std::optional<Transform<frame::World, frame::Probe>> startPoseOf(const nlohmann::json& manifest) {
  return transformIn<frame::World, frame::Probe>(fieldOf(manifest, "start_pose"));
}

nlohmann::json withStartPose(nlohmann::json manifest, const std::optional<Transform<frame::World, frame::Probe>>& probeToWorld) {
  return withField(std::move(manifest), "start_pose", probeToWorld ? std::optional<nlohmann::json>(rowsOf(*probeToWorld)) : std::nullopt);
}

bool seesVolume(const sdk::Cases::Scan& scan, const Transform<frame::World, frame::Probe>& probeToWorld) {
  constexpr double kDepthStep_mm = 4.0;
  constexpr int kLines = 17;
  const auto probeToVoxel = scan.volume.worldToVoxel() * probeToWorld;
  const bool isFan = scan.halfWidth_rad > 0.0;
  // Lines of a fan meet this far behind the face.
  const double radius_mm = isFan ? scan.halfFace_mm / std::sin(scan.halfWidth_rad) : 0.0;
  for (int line = 0; line < kLines; ++line) {
    const double across = 2.0 * line / (kLines - 1) - 1.0;
    const double angle_rad = across * scan.halfWidth_rad;
    for (double depth_mm = 0.0; depth_mm <= scan.depth_mm; depth_mm += kDepthStep_mm) {
      const glm::dvec3 p_probe =
          isFan ? glm::dvec3((radius_mm + depth_mm) * std::sin(angle_rad), (radius_mm + depth_mm) * std::cos(angle_rad) - radius_mm, 0.0)
                : glm::dvec3(across * scan.halfFace_mm, depth_mm, 0.0);
      const glm::dvec3 p_voxel = carried(probeToVoxel, p_probe);
      if (glm::all(glm::greaterThanEqual(p_voxel, glm::dvec3(-0.5))) &&
          glm::all(glm::lessThan(p_voxel, glm::dvec3(scan.volume.dims) - 0.5)))
        return true;
    }
  }
  return false;
}

std::string fieldOf(const Error& problem) {
  for (const auto& [name, value] : problem.context)
    if (name == "field") return value.substr(0, value.find('['));
  return {};
}

}  // namespace ew::case_authoring
