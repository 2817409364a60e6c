#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <string>
#include <vector>

#include "ew/stitching/join.h"

/// Small volumes for tests of joining.
namespace ew::stitching {

inline Grid gridOf(glm::ivec3 dims, glm::dvec3 origin_mm = glm::dvec3(0.0), double spacing_mm = 1.0) {
  Grid grid;
  grid.dims = dims;
  grid.spacing_mm = glm::dvec3(spacing_mm);
  grid.origin_mm = origin_mm;
  return grid;
}

/// Echo from a function of the position in the volume's own file.
template <class Level>
Volume volumeOf(const Grid& grid, Level level) {
  Volume volume{grid, std::vector<std::uint8_t>(grid.voxelCount()), {}};
  const auto toFile = grid.voxelToWorld();
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        volume.echo[grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(level((toFile * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at));
  return volume;
}
inline Volume constant(const Grid& grid, int level) {
  return volumeOf(grid, [level](const glm::dvec3&) { return level; });
}
/// White noise around mid-grey.
inline Volume speckled(const Grid& grid, unsigned seed) {
  std::mt19937 random(seed);
  return volumeOf(grid, [&](const glm::dvec3&) { return 40u + random() % 150u; });
}

inline glm::dmat4 moved(double x, double y, double z) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z)); }

/// The volume must outlive the view.
inline View viewOf(const Volume& volume, const std::string& name, const glm::dmat4& toWorld = glm::dmat4(1.0)) {
  View view;
  view.volume = &volume;
  view.toWorld = {toWorld};
  view.name = name;
  return view;
}

inline Grid gridFor(const std::vector<View>& views, const StitchOptions& options) {
  std::vector<GridPlacement> grids;
  for (const View& view : views) grids.push_back({view.volume->grid, view.toWorld, view.name});
  const auto forecast = forecastStitch(grids, options);
  return forecast ? forecast->grid : Grid{};
}

}  // namespace ew::stitching
