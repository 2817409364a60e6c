#include "logic/edits.h"

#include <algorithm>
#include <array>

#include "ew/core/frames.h"

namespace ew::case_authoring {
namespace {

constexpr const char* kGainPath = "scene.gain_and_dgc";

std::pair<std::string, std::string> split(const std::string& path) {
  const auto dot = path.find('.');
  return dot == std::string::npos ? std::pair{path, std::string()} : std::pair{path.substr(0, dot), path.substr(dot + 1)};
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

Result<glm::dmat4> placeOf(const nlohmann::json& manifest) {
  const auto value = fieldOf(manifest, "volume.file_to_world");
  if (value.is_null()) return glm::dmat4(1.0);
  if (!value.is_array() || value.size() != 16 || !std::all_of(value.begin(), value.end(), [](const auto& n) { return n.is_number(); }))
    return failure(ErrorCode::badField, "The volume's place is not 16 numbers, row by row; correct 'volume.file_to_world' in case.json.",
                   {{"field", "volume.file_to_world"}});
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = value[i].get<double>();
  return matrixFromRows(rows);
}

nlohmann::json withPlace(nlohmann::json manifest, const glm::dmat4& fileToWorld) {
  return withField(std::move(manifest), "volume.file_to_world", nlohmann::json(rowsOf(fileToWorld)));
}

std::string fieldOf(const Error& problem) {
  for (const auto& [name, value] : problem.context)
    if (name == "field") return value.substr(0, value.find('['));
  return {};
}

}  // namespace ew::case_authoring
