#include "echo_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <numbers>
#include <optional>

#include "scatterers.h"

namespace ew::detail {

/// Distances to surfaces as voxels and as places in the probe frame.
struct SurfaceMap {
  const TissueMaps& maps;
  glm::dmat4 probeToVoxel;
  glm::dmat3 slopeToProbe;  ///< takes a slope over voxels to one over mm of the probe frame

  /// Nearest voxel; nothing outside.
  [[nodiscard]] std::optional<std::size_t> indexAt(const glm::dvec3& voxel) const {
    const glm::ivec3 nearest(glm::floor(voxel + 0.5));
    if (!maps.grid.contains(nearest)) return std::nullopt;
    return maps.grid.indexOf(nearest.x, nearest.y, nearest.z);
  }
  /// Between voxels, mm; nothing where one of them knows no surface.
  [[nodiscard]] std::optional<double> distanceAt(const glm::dvec3& voxel) const {
    const glm::dvec3 whole = glm::floor(voxel);
    const glm::ivec3 low(whole);
    if (low.x < 0 || low.y < 0 || low.z < 0 || !maps.grid.contains(low + 1)) return std::nullopt;
    const glm::dvec3 t = voxel - whole;
    const std::uint8_t* first = maps.surfaceDistance.data() + maps.grid.indexOf(low.x, low.y, low.z);
    const std::ptrdiff_t row = maps.grid.dims.x, plane = row * maps.grid.dims.y;
    std::array<double, 4> along;
    for (std::size_t n = 0; n < along.size(); ++n) {
      const std::uint8_t* at = first + (n & 1 ? row : 0) + (n & 2 ? plane : 0);
      if (at[0] == 0 || at[1] == 0) return std::nullopt;
      along[n] = at[0] + t.x * (at[1] - at[0]);
    }
    const double near = along[0] + t.y * (along[1] - along[0]), far = along[2] + t.y * (along[3] - along[2]);
    return (near + t.z * (far - near) - 128.0) / TissueMaps::kDistanceStepsPerMm;
  }
  /// Slope of the distance, in the probe frame; nothing beside the rim of a surface.
  [[nodiscard]] std::optional<glm::dvec3> slopeAt(const glm::dvec3& voxel) const {
    glm::dvec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = 0.7;
      const auto above = distanceAt(voxel + step), below = distanceAt(voxel - step);
      if (!above || !below) return std::nullopt;
      slope[axis] = (*above - *below) / 1.4;
    }
    return slopeToProbe * slope;
  }
};

namespace {

struct ElevationRay {
  double sigmas;
  double weight;
};
// exp(-x^2 / 2) at 0, 0.75 and 1.5 standard deviations; together 1.
constexpr std::array<ElevationRay, 5> kRays{{{0.0, 0.3223}, {-0.75, 0.2433}, {0.75, 0.2433}, {-1.5, 0.09555}, {1.5, 0.09555}}};

constexpr double kFine_mm = 0.3;     // steps near a surface
constexpr double kBlind_mm = 0.8;    // where no surface is known
constexpr double kNear_mm = 1.0;     // from here on the way is looked at closely
constexpr double kReserve_mm = 0.6;  // distances are first order, and between voxels
constexpr double kGrain_mm = 4.5;    // of unevenness
constexpr double kDecibelPerLevel = 60.0 / 255.0;

std::uint32_t hashOf(const glm::ivec3& at) {
  std::uint32_t x = static_cast<std::uint32_t>(at.x) * 0x9E3779B1U + static_cast<std::uint32_t>(at.y) * 0x85EBCA77U +
                    static_cast<std::uint32_t>(at.z) * 0xC2B2AE3DU;
  x = (x ^ (x >> 16)) * 0x21f0aaadU;
  x = (x ^ (x >> 15)) * 0x735a2d97U;
  return x ^ (x >> 15);
}

/// Between 0 and 1, smooth, fixed in the tissue.
double unevenAt(const glm::dvec3& mm) {
  const glm::dvec3 cell = mm / kGrain_mm, whole = glm::floor(cell);
  glm::dvec3 t = cell - whole;
  t = t * t * (3.0 - 2.0 * t);
  double sum = 0.0;
  for (int n = 0; n < 8; ++n) {
    const glm::ivec3 corner(n & 1, (n >> 1) & 1, n >> 2);
    const double weight = (corner.x ? t.x : 1.0 - t.x) * (corner.y ? t.y : 1.0 - t.y) * (corner.z ? t.z : 1.0 - t.z);
    sum += weight * (hashOf(glm::ivec3(whole) + corner) >> 8) * 0x1p-24;
  }
  return sum;
}

}  // namespace

void EchoSurfaces::configure(const EchoLayout& layout) {
  layout_ = &layout;
  mirrorScale_.resize(static_cast<std::size_t>(layout.columns));
  roughScale_.resize(static_cast<std::size_t>(layout.columns));
  for (int column = 0; column < layout.columns; ++column) {
    const int tile = column / kTileColumns;
    const std::vector<float>& weights = layout.lateral[static_cast<std::size_t>(tile)];
    double sum = 0.0, power = 0.0;
    for (int t = 0; t <= layout.reachOfTile[static_cast<std::size_t>(tile)]; ++t) {
      const double weight = static_cast<double>(weights[static_cast<std::size_t>(2 * (t * kTileColumns + column % kTileColumns))]);
      sum += (t == 0 ? 1.0 : 2.0) * weight;
      power += (t == 0 ? 1.0 : 2.0) * weight * weight;
    }
    const double rest = static_cast<double>(layout.pulse.front()) * layout.lookScale * kDepositUnit;
    mirrorScale_[static_cast<std::size_t>(column)] = static_cast<float>(1.0 / (sum * rest));
    roughScale_[static_cast<std::size_t>(column)] = static_cast<float>(1.0 / (std::sqrt(power) * rest));
  }
}

void EchoSurfaces::add(const TissueMaps& maps, const Transform<frame::Voxel, frame::Probe>& probeToVoxel, Bands& bands, std::int32_t* fine,
                       std::ptrdiff_t stride) const {
  const SurfaceMap map{maps, probeToVoxel.matrix, glm::transpose(glm::dmat3(probeToVoxel.matrix))};
  bands.run(static_cast<int>(layout_->grid.lines.size()), [&](int first, int count, int) {
    for (int line = first; line < first + count; ++line) addLine(line, map, fine, stride);
  });
}

void EchoSurfaces::addLine(int line, const SurfaceMap& map, std::int32_t* fine, std::ptrdiff_t stride) const {
  const BeamGrid::Line& way = layout_->grid.lines[static_cast<std::size_t>(line)];
  const glm::dvec3 along(way.direction, 0.0);
  const glm::dvec3 across(way.direction.y, -way.direction.x, 0.0);
  for (const ElevationRay& ray : kRays) {
    const auto voxelAt = [&](double range_mm) {
      const double aside_mm = ray.sigmas * layout_->beams.elevationalSigma_mm(range_mm);
      return glm::dvec3(map.probeToVoxel * glm::dvec4(way.origin_mm + range_mm * way.direction, aside_mm, 1.0));
    };
    std::optional<double> before;
    for (double range_mm = 0.0, step_mm = 0.0; range_mm < layout_->depth_mm; range_mm += step_mm) {
      const glm::dvec3 voxel = voxelAt(range_mm);
      const auto index = map.indexAt(voxel);
      const std::uint8_t stored = index ? map.maps.surfaceDistance[*index] : std::uint8_t{0};
      const double coarse_mm = stored == 0 ? 0.0 : std::abs(stored - 128.0) / TissueMaps::kDistanceStepsPerMm;
      if (stored == 0 || coarse_mm > kNear_mm) {
        step_mm = stored == 0 ? kBlind_mm : coarse_mm - kReserve_mm;
        before.reset();
        continue;
      }
      step_mm = kFine_mm;
      const auto here = map.distanceAt(voxel);
      const auto last = std::exchange(before, here);
      if (!here || !last || (*here < 0.0) == (*last < 0.0) || std::abs(*here - *last) > 1.4 * kFine_mm) continue;
      const double crossing_mm = range_mm - kFine_mm * *here / (*here - *last);
      const glm::dvec3 at = voxelAt(crossing_mm);
      const auto found = map.indexAt(at);
      const std::uint8_t kind = found ? map.maps.surfaceKind[*found] : std::uint8_t{0};
      if (kind == 0 || kind > map.maps.surfaces.size()) continue;
      const ReflectingSurface& surface = map.maps.surfaces[kind - 1U];
      if (surface.frontOnly && *here > *last) continue;
      const auto slope = map.slopeAt(at);
      if (!slope) continue;
      const double steep = glm::length(*slope), cosine = std::abs(glm::dot(*slope, along)) / std::max(steep, 1e-9);
      const double sine2 = std::max(0.0, 1.0 - cosine * cosine), fall = std::sin(surface.fall_deg * std::numbers::pi / 180.0);
      const glm::dvec3 mm = at * map.maps.grid.spacing_mm;
      const double uneven = std::clamp(2.4 * unevenAt(mm) - 0.35, 0.12, 1.0);
      const double amplitude = std::pow(10.0, 0.05 * (surface.echoLevel - 255.0) * kDecibelPerLevel) * ray.weight;
      // Neighbouring rows meet the surface a little earlier or later; where it lies along the line that says nothing.
      const double lean = std::clamp(
          -glm::dot(*slope, across) / std::copysign(std::max(std::abs(glm::dot(*slope, along)), 0.2), glm::dot(*slope, along)), -3.0, 3.0);
      deposit(line, crossing_mm, lean, amplitude * uneven * std::exp(-0.5 * sine2 / (fall * fall)),
              amplitude * std::pow(10.0, 0.05 * surface.rough_db), hashOf(glm::ivec3(glm::floor(mm / 0.3))), fine, stride);
    }
  }
}

void EchoSurfaces::deposit(int line, double range_mm, double lean, double amplitude, double rough, std::uint32_t hash, std::int32_t* fine,
                           std::ptrdiff_t stride) const {
  const double spacing_mm = layout_->rowSpacing_mm(range_mm);
  for (int n = 0; n < layout_->rowsPerLine; ++n) {
    const double offset = n - 0.5 * (layout_->rowsPerLine - 1);
    const double column = layout_->columnPadding + (range_mm + lean * offset * spacing_mm) / layout_->grid.sampleSpacing_mm;
    if (!(column >= 0.0 && column < layout_->columns - 1)) continue;
    const int whole = static_cast<int>(column);
    const double part = column - whole;
    const auto c = static_cast<std::size_t>(whole);
    const double mirror = amplitude * static_cast<double>(mirrorScale_[c]);
    const double scattered = rough * static_cast<double>(roughScale_[c]);
    hash = hash * 0x9E3779B1U + 0x85EBCA77U;
    const double re = mirror + (hash & 0x10000U ? scattered : -scattered), im = hash & 0x20000U ? scattered : -scattered;
    std::int32_t* at = fine + (layout_->rowPadding + line * layout_->rowsPerLine + n - layout_->rowsPerLine / 2) * stride + 2 * whole;
    at[0] += static_cast<std::int32_t>(std::lround((1.0 - part) * re));
    at[1] += static_cast<std::int32_t>(std::lround((1.0 - part) * im));
    at[2] += static_cast<std::int32_t>(std::lround(part * re));
    at[3] += static_cast<std::int32_t>(std::lround(part * im));
  }
}

}  // namespace ew::detail
