#include "case/kept_maps.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "ew/core/message.h"
#include "ew/io/rest_in_file.h"
#include "ew/io/volume_file.h"

namespace ew {
namespace {

using nlohmann::json;

/// The maps and their files.
template <class Maps>
auto filesOf(Maps& maps) {
  return std::array{std::pair{std::string("level"), &maps.level}, std::pair{std::string("surface-distance"), &maps.surfaceDistance},
                    std::pair{std::string("surface-kind"), &maps.surfaceKind}};
}
std::string fileFor(const std::string& map) { return map + ".mha"; }

/// @param most that a value may be
/// @param into left as it is unless true is returned
/// @return whether the map is there as it was kept
bool readMap(const StepStore& store, const char* step, const std::string& key, const std::string& map, std::size_t count, std::size_t most,
             std::vector<std::uint8_t>& into) {
  if (!store.isSound(step, key, fileFor(map))) return false;
  const auto file = store.fileOf(step, key, fileFor(map));
  auto read = readLabelVolume(file);
  if (!read || read->volume.echo.size() != count) return false;
  if (std::any_of(read->volume.echo.begin(), read->volume.echo.end(), [most](std::uint8_t value) { return value > most; })) return false;
  into = std::move(read->volume.echo);
  restInVolumeFile(into, file);  // before the next one is read
  return true;
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
    const auto file = store.fileOf(step, key, names.emplace_back(fileFor(name)));
    if (auto written = writeConfidence(maps.grid, *values, file, noProgress(), {.compress = false}); !written) return written;
  }
  nlohmann::ordered_json surfaces = nlohmann::ordered_json::array();
  for (const ReflectingSurface& surface : maps.surfaces) surfaces.push_back(keptJsonOf(surface));
  return store.keep(step, key, {{"surfaces", std::move(surfaces)}, {"recorded", maps.isRecorded}}, names);
}

void restWhereKept(const StepStore& store, const char* step, const std::string& key, TissueMaps& maps) {
  for (const auto& [name, values] : filesOf(maps))
    if (!values->empty()) restInVolumeFile(*values, store.fileOf(step, key, fileFor(name)));
}

std::shared_ptr<TissueMaps> readKeptMaps(const StepStore& store, const char* step, const std::string& key, const Grid& grid) {
  const auto data = store.find(step, key);
  if (!data) return nullptr;
  auto maps = std::make_shared<TissueMaps>();
  maps->grid = grid;
  maps->isRecorded = data->is_object() && data->value("recorded", false);
  try {
    for (const json& each : data->at("surfaces")) maps->surfaces.push_back(surfaceOf(each));
  } catch (const json::exception&) {
    return nullptr;
  }
  for (const auto& [name, values] : filesOf(*maps)) {
    if (maps->isRecorded && values != &maps->level) continue;
    const std::size_t most = values == &maps->surfaceKind ? maps->surfaces.size() : 255;
    if (!readMap(store, step, key, name, grid.voxelCount(), most, *values)) return nullptr;
  }
  return maps;
}

}  // namespace ew
