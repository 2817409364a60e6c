#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ew/imaging/frame.h"

/// Tissue of known levels, a convex probe, and images of live echoes without what a machine adds to them.
namespace ew::testing::live {

inline constexpr double kGreyPerDb = 255.0 / 60.0;

inline Probe convex() {
  Probe probe;
  probe.id = "convex";
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = 0.45;
  probe.lines = 128;
  probe.carrier_hz = 3.5e6;
  probe.carriers_hz = {2.5e6, 3.5e6, 5e6};
  probe.aperture_mm = 28.0;
  probe.elevationalThickness_mm = 3.0;
  probe.elevationalFocus_mm = 70.0;
  probe.elevationalAperture_mm = 10.0;
  probe.maxDepth_mm = 200.0;
  probe.defaultDepth_mm = 120.0;
  return probe;
}

/// Tissue of one level, or as a function of the place in mm; the probe stands at the middle of its upper face (y = 0) and looks along +y.
template <class Level>
TissueMaps tissueOf(const Level& level, double spacing_mm = 1.0) {
  TissueMaps maps;
  maps.grid.dims = glm::ivec3(glm::dvec3(180.0, 150.0, 44.0) / spacing_mm);
  maps.grid.spacing_mm = glm::dvec3(spacing_mm);
  maps.grid.origin_mm = {-90.0, -12.0, -22.0};
  maps.level.resize(maps.grid.voxelCount());
  for (int k = 0; k < maps.grid.dims.z; ++k)
    for (int j = 0; j < maps.grid.dims.y; ++j)
      for (int i = 0; i < maps.grid.dims.x; ++i) {
        const glm::dvec3 mm = maps.grid.origin_mm + spacing_mm * glm::dvec3(i, j, k);
        maps.level[maps.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(std::lround(level(mm)));
      }
  return maps;
}

/// Scatterers alone: nothing that a sonographer would add to them.
inline Scene plainScene() {
  Scene scene;
  LiveEchoesEffect effect;
  effect.looks = 1;
  effect.gain_db = effect.texture_db = effect.fragmentsPerCm3 = effect.lineAverage = 0.0;
  effect.speckleReduction = 0.0;
  effect.haze_db = -80.0;
  scene.liveEchoes = effect;
  scene.sliceThickness = SliceThicknessEffect{};
  scene.focus = FocusEffect{};
  return scene;
}

struct Shot {
  Probe probe = convex();
  Knobs knobs;
  Scene scene = plainScene();
  glm::dmat4 probeToWorld{1.0};
  int threads = 1;
  const Volume* labels = nullptr;
};

/// These maps as tissue, and their level as the volume that is not sliced.
inline FrameInput inputOf(const TissueMaps& maps) {
  FrameInput input;
  input.tissue = &maps;
  input.tissueGrid = maps.grid;
  input.echo = VolumeView<const std::uint8_t>{maps.level.data(), maps.grid};
  return input;
}

inline GreyImage imageOf(const TissueMaps& maps, const Shot& shot) {
  FrameMaker maker(shot.threads);
  Knobs knobs = shot.knobs;
  knobs.greyMap = GreyMap::linear;
  maker.configure(shot.probe, knobs, shot.scene, maps.grid, 640, 512, {.labels = shot.labels != nullptr, .tissue = true});
  FrameInput input = inputOf(maps);
  if (shot.labels != nullptr) input.labels = shot.labels->view();
  input.pose.probeToWorld.matrix = shot.probeToWorld;
  const DisplayImage made = maker.make(input);
  GreyImage copy(made.width(), made.height());
  for (int y = 0; y < copy.height; ++y) std::copy_n(made.grey.row(y), copy.width, viewOf(copy).row(y));
  return copy;
}

/// Levels of the middle lines between two depths, mm: those of the image's columns next to the axis.
inline std::vector<double> levelsBetween(const GreyImage& image, const Shot& shot, double from_mm, double to_mm, double half_mm = 14.0) {
  const DisplayGeometry geometry = fitDisplay(shot.probe, shot.knobs, image.width, image.height, {});
  std::vector<double> levels;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::dvec2 p = geometry.probePoint_mm(x, y);
      if (p.y >= from_mm && p.y < to_mm && std::abs(p.x) < half_mm)
        levels.push_back(image.pixels[static_cast<std::size_t>(y * image.width + x)]);
    }
  return levels;
}

inline double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

inline double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double ma = meanOf(a), mb = meanOf(b);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    ab += (a[n] - ma) * (b[n] - mb);
    aa += (a[n] - ma) * (a[n] - ma);
    bb += (b[n] - mb) * (b[n] - mb);
  }
  return ab / std::sqrt(aa * bb);
}

/// A reflecting surface through the maps, where a signed distance of a place in mm is 0.
template <class Distance>
void addSurface(TissueMaps& maps, const ReflectingSurface& surface, const Distance& distanceOf) {
  maps.surfaces.push_back(surface);
  maps.surfaceDistance.resize(maps.level.size(), 0);
  maps.surfaceKind.resize(maps.level.size(), 0);
  for (int k = 0; k < maps.grid.dims.z; ++k)
    for (int j = 0; j < maps.grid.dims.y; ++j)
      for (int i = 0; i < maps.grid.dims.x; ++i) {
        const double distance_mm = distanceOf(maps.grid.origin_mm + maps.grid.spacing_mm * glm::dvec3(i, j, k));
        if (std::abs(distance_mm) > TissueMaps::kSurfaceReach_mm) continue;
        const std::size_t n = maps.grid.indexOf(i, j, k);
        maps.surfaceDistance[n] = static_cast<std::uint8_t>(std::lround(128.0 + TissueMaps::kDistanceStepsPerMm * distance_mm));
        maps.surfaceKind[n] = static_cast<std::uint8_t>(maps.surfaces.size());
      }
}

/// A plane, at a depth and leaning about the z axis, mm.
inline void addPlane(TissueMaps& maps, const ReflectingSurface& surface, double depth_mm, double lean_rad = 0.0) {
  addSurface(maps, surface, [=](const glm::dvec3& p) { return (depth_mm - p.y) * std::cos(lean_rad) + p.x * std::sin(lean_rad); });
}

/// Label 1 everywhere, 2 from a depth on.
inline Volume layersOf(const TissueMaps& maps, double depth_mm) {
  Volume labels;
  labels.grid = maps.grid;
  labels.echo.assign(maps.level.size(), 1);
  for (int k = 0; k < labels.grid.dims.z; ++k)
    for (int j = 0; j < labels.grid.dims.y; ++j)
      for (int i = 0; i < labels.grid.dims.x; ++i)
        if (labels.grid.origin_mm.y + labels.grid.spacing_mm.y * j > depth_mm) labels.echo[labels.grid.indexOf(i, j, k)] = 2;
  return labels;
}

}  // namespace ew::testing::live
