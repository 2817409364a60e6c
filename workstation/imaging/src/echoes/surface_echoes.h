#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "byte_map.h"
#include "ew/imaging/tissue_maps.h"

namespace ew::detail {

/// Reflecting surfaces in amplitudes, number by number.
struct SurfaceStrengths {
  std::vector<float> mirror, rough;
  /// They fall as 2^(-fall sin^2 b) with the incidence b.
  std::vector<float> mirrorFall, roughFall;
  std::vector<float> sheetGap_mm;
  std::vector<std::int32_t> sheets, frontOnly;

  /// @param gain_db of echoes
  void take(const std::vector<ReflectingSurface>& surfaces, double gain_db);
};

/// Crossings of lines and surfaces, number by number, so that a vector takes them one after another.
struct SurfaceCrossings {
  std::vector<std::int32_t> line;
  std::vector<float> range_mm;
  std::vector<float> entering;           ///< 1, leaving: -1
  std::array<std::vector<float>, 3> at;  ///< in voxels
  /// Slope of the distance in the plane of the slice where tissue that gives way has turned the surface; not a number elsewhere.
  std::array<std::vector<float>, 2> turned;

  /// Room for so many, whole vectors of them: those beyond lie nowhere.
  void resize(std::size_t count);
};

/// What turns crossings into echoes on the fine grid.
struct SurfaceEchoTask {
  ByteMap distances, kinds;  ///< TissueMaps::surfaceDistance, surfaceKind
  const SurfaceStrengths& strengths;
  glm::vec3 spacing_mm;                 ///< of voxels
  glm::mat3 slopeToProbe;               ///< takes a slope over voxels to one over mm of the probe frame
  const std::vector<glm::vec4>& lines;  ///< origin and direction
  float weight = 1.0F;
  /// Where the middle of the slice alone is walked, each crossing stands for three: as far as the surface is flat it is met this far beside
  /// the middle too, `sideShare` of its strength on either side.
  float sideSigmas = 0.0F;  ///< standard deviations of the elevational beam; 0: it stands for itself
  float sideShare = 0.0F;
  const float* sigma_mm = nullptr;  ///< by whole mm of depth

  int rowsPerLine = 1, rowPadding = 0, rows = 0;
  float spacingAtFace_mm = 0.0F, spacingPerMm = 0.0F;  ///< of rows
  float firstColumn = 0.0F, columnsPerMm = 1.0F;
  int columns = 0;
  const float* scale = nullptr;  ///< by column: of an amplitude, to what is added to each row
  std::int32_t* field = nullptr;
  std::int32_t stride = 0;
};

/// Adds the echoes of crossings; two that are not of one line never share a row. Single precision: an amplitude is off by 1e-5 of itself.
/// The same bits on every instruction set.
void addSurfaceEchoes(const SurfaceEchoTask& task, const SurfaceCrossings& met);

/// Of the sheets of a surface.
inline constexpr int kMostSheets = 4;

}  // namespace ew::detail
