#include "chain/chain_json.h"
#include "chain/chain_memory.h"
#include "chain/steps/steps.h"
#include "ew/io/safe_file.h"

namespace ew::stitching {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kCells = "cells.bin";  ///< empty where nothing is cut
/// Of one of the views that go into the result.
std::string levelsName(std::size_t view) { return "levels-" + std::to_string(view) + ".bin"; }

ordered_json jsonOfMap(const SeamMap& map) {
  ordered_json data = {
      {"cells", jsonOf(map.cells)}, {"cut_cost", map.cutCost}, {"seam_faces", map.seamFaces}, {"levels", ordered_json::array()}};
  for (const auto& [begin, size, offset] : map.levels)
    data["levels"].push_back({{"begin", {begin.x, begin.y, begin.z}}, {"size", {size.x, size.y, size.z}}});
  return data;
}

/// All but what lies in files.
SeamMap mapFrom(const json& data) {
  SeamMap map;
  map.cells = gridFrom(data.at("cells"));
  map.cutCost = data.at("cut_cost").get<double>();
  map.seamFaces = data.at("seam_faces").get<std::size_t>();
  for (const auto& box : data.at("levels")) {
    const auto begin = box.at("begin").get<std::array<int, 3>>(), size = box.at("size").get<std::array<int, 3>>();
    map.levels.push_back({{begin[0], begin[1], begin[2]}, {size[0], size[1], size[2]}, {}});
  }
  return map;
}

std::optional<SeamMap> keptMap(const ChainRun& run, const std::string& key) {
  const char* step = nameOf(Step::seam);
  auto map = readBack<SeamMap>(run.store.find(step, key), mapFrom);
  if (!map) return std::nullopt;
  if (run.store.bytesOf(step, key, kCells) != 0 && !run.store.readValues(step, key, kCells, map->cells.voxelCount(), map->view))
    return std::nullopt;
  for (std::size_t n = 0; n < map->levels.size(); ++n) {
    auto& levels = map->levels[n];
    const auto count =
        static_cast<std::size_t>(levels.size.x) * static_cast<std::size_t>(levels.size.y) * static_cast<std::size_t>(levels.size.z);
    if (!run.store.readValues(step, key, levelsName(n), count, levels.offset)) return std::nullopt;
  }
  return map;
}

Result<void> keepMap(const ChainRun& run, const std::string& key, const SeamMap& map) {
  const char* step = nameOf(Step::seam);
  if (auto room = run.store.prepare(step); !room) return room;
  std::vector<std::string> names;
  const auto write = [&](const std::string& name, const std::string& bytes) {
    names.push_back(name);
    return writeFileSafely(run.store.fileOf(step, key, name), bytes);
  };
  if (auto w = write(kCells, std::string(map.view.begin(), map.view.end())); !w) return w;
  for (std::size_t n = 0; n < map.levels.size(); ++n) {
    const auto& offset = map.levels[n].offset;
    const std::string bytes(reinterpret_cast<const char*>(offset.data()), offset.size() * sizeof(std::int16_t));
    if (auto w = write(levelsName(n), bytes); !w) return w;
  }
  return run.store.keep(step, key, jsonOfMap(map), names);
}

/// Inside, views are counted among those that go into the result; outside, by their numbers in the project.
void takeSeams(ChainRun& run, SeamMap map) {
  run.seams = std::move(map);
  SeamMap outside = run.seams;
  for (auto& view : outside.view)
    if (view > 0) view = static_cast<std::uint8_t>(run.included[view - 1u] + 1);
  if (!outside.levels.empty()) {
    outside.levels.assign(run.inputs.size(), {});
    for (std::size_t n = 0; n < run.included.size(); ++n) outside.levels[run.included[n]] = run.seams.levels[n];
  }
  run.state.seams = std::move(outside);
}

}  // namespace

Result<void> seamStep(ChainRun& run, Progress& progress) {
  if (auto fits = checkMemory(run, Step::seam); !fits) return fits;
  const std::string& key = run.keys[Step::seam];
  if (auto kept = keptMap(run, key)) {
    run.outcomeOf(Step::seam).reused = true;
    takeSeams(run, std::move(*kept));
    return {};
  }
  auto views = run.views(progress);
  if (!views) return passOn(views.error());
  auto grid = run.resultGrid();
  if (!grid) return passOn(grid.error());
  auto map = findSeams(*views, *grid, run.joinOptions().seam, progress);
  if (!map) return passOn(map.error());
  if (auto kept = keepMap(run, key, *map); !kept) return kept;
  takeSeams(run, std::move(*map));
  return {};
}

}  // namespace ew::stitching
