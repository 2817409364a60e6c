#include "case/kept_maps.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "ew/core/message.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

using nlohmann::json;

/// The maps and their files.
template <class Maps>
auto filesOf(Maps& maps) {
  return std::array{std::pair{"level.bin", &maps.level}, std::pair{"surface-distance.bin", &maps.surfaceDistance},
                    std::pair{"surface-kind.bin", &maps.surfaceKind}};
}

ReflectingSurface surfaceOf(const json& kept) {
  ReflectingSurface surface;
  kept.at("name").get_to(surface.name);
  kept.at("echo_level").get_to(surface.echoLevel);
  kept.at("thickness_mm").get_to(surface.thickness_mm);
  kept.at("fall_deg").get_to(surface.fall_deg);
  kept.at("rough_db").get_to(surface.rough_db);
  kept.at("rough_fall_deg").get_to(surface.roughFall_deg);
  kept.at("sheets").get_to(surface.sheets);
  kept.at("sheet_gap_mm").get_to(surface.sheetGap_mm);
  kept.at("front_only").get_to(surface.frontOnly);
  return surface;
}

}  // namespace

nlohmann::ordered_json keptJsonOf(const ReflectingSurface& surface) {
  return {{"name", surface.name},         {"echo_level", surface.echoLevel},     {"thickness_mm", surface.thickness_mm},
          {"fall_deg", surface.fall_deg}, {"rough_db", surface.rough_db},        {"rough_fall_deg", surface.roughFall_deg},
          {"sheets", surface.sheets},     {"sheet_gap_mm", surface.sheetGap_mm}, {"front_only", surface.frontOnly}};
}

Result<void> keepMaps(const StepStore& store, const char* step, const std::string& key, const TissueMaps& maps) {
  if (auto room = store.prepare(step); !room) return room;
  std::vector<std::string> names;
  for (const auto& [name, values] : filesOf(maps)) {
    if (values->empty()) continue;  // a level alone
    const std::string_view bytes(reinterpret_cast<const char*>(values->data()), values->size());
    if (auto written = writeFileSafely(store.fileOf(step, key, names.emplace_back(name)), bytes); !written) return written;
  }
  nlohmann::ordered_json surfaces = nlohmann::ordered_json::array();
  for (const ReflectingSurface& surface : maps.surfaces) surfaces.push_back(keptJsonOf(surface));
  return store.keep(step, key, {{"surfaces", std::move(surfaces)}, {"recorded", maps.isRecorded}}, names);
}

std::shared_ptr<TissueMaps> readKeptMaps(const StepStore& store, const char* step, const std::string& key, const Grid& grid) {
  const auto data = store.find(step, key);
  if (!data) return nullptr;
  auto maps = std::make_shared<TissueMaps>();
  maps->grid = grid;
  maps->isRecorded = data->is_object() && data->value("recorded", false);
  for (const auto& [name, values] : filesOf(*maps)) {
    if (maps->isRecorded && values != &maps->level) continue;
    if (!store.readValues(step, key, name, grid.voxelCount(), *values)) return nullptr;
  }
  try {
    for (const json& each : data->at("surfaces")) maps->surfaces.push_back(surfaceOf(each));
  } catch (const json::exception&) {
    return nullptr;
  }
  const auto beyond = [&](std::uint8_t kind) { return kind > maps->surfaces.size(); };
  if (std::any_of(maps->surfaceKind.begin(), maps->surfaceKind.end(), beyond)) return nullptr;
  return maps;
}

}  // namespace ew
