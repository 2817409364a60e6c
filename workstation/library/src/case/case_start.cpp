#include "ew/library/case_start.h"

#include <filesystem>
#include <utility>

namespace ew {
namespace {

constexpr const char* kPresets = "presets";
constexpr const char* kBodyMarks = "body_marks";

std::vector<std::string> idsIn(const Case& opened, const char* field) {
  std::vector<std::string> ids;
  if (!opened.otherFields.is_object() || !opened.otherFields.contains(field)) return ids;
  for (const auto& each : opened.otherFields[field])
    if (each.is_string()) ids.push_back(each.get<std::string>());
  return ids;
}

Case withIds(Case edited, const char* field, const std::vector<std::string>& ids) {
  if (ids.empty())
    edited.otherFields.erase(field);
  else
    edited.otherFields[field] = ids;
  return edited;
}

}  // namespace

std::vector<std::string> presetsOf(const Case& opened) { return idsIn(opened, kPresets); }
std::vector<std::string> shippedPresetsOf(const Case& opened) {
  std::vector<std::string> ids = presetsOf(opened);
  const auto resources = resourceFolder();
  if (!resources) return {};
  std::error_code ignored;
  std::erase_if(ids, [&](const std::string& id) {
    return id.find('/') != std::string::npos || !std::filesystem::is_regular_file(*resources / "presets" / (id + ".json"), ignored);
  });
  return ids;
}

std::vector<std::string> bodyMarksOf(const Case& opened) { return idsIn(opened, kBodyMarks); }

Case withPresets(Case edited, const std::vector<std::string>& ids) { return withIds(std::move(edited), kPresets, ids); }
Case withBodyMarks(Case edited, const std::vector<std::string>& ids) { return withIds(std::move(edited), kBodyMarks, ids); }

}  // namespace ew
