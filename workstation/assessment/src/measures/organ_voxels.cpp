#include "ew/assessment/organ_voxels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr int kBlock = 8;

/// The box around a fan in its plane.
struct Extent {
  double halfWidth_mm, top_mm, bottom_mm;
};

Extent extentOf(const Fan& fan) {
  if (!isSector(fan.probe.kind)) return {0.5 * fan.probe.width_mm, 0.0, fan.depth_mm};
  const double outer_mm = fan.probe.radius_mm + fan.depth_mm;
  const double wide = std::min(fan.probe.halfAngle_rad, 1.5707963267948966);
  return {outer_mm * std::sin(wide), -faceSagitta_mm(fan.probe), fan.depth_mm};
}

template <class See>
void overRaster(const Fan& fan, double step_mm, const See& see) {
  EW_EXPECTS(step_mm > 0.0);
  const Extent extent = extentOf(fan);
  const int columns = static_cast<int>(std::floor(extent.halfWidth_mm / step_mm));
  for (double y = extent.top_mm + 0.5 * step_mm; y < extent.bottom_mm; y += step_mm)
    for (int column = -columns; column <= columns; ++column) {
      const glm::dvec2 p_mm(column * step_mm, y);
      if (placeInFan(fan, p_mm)) see(p_mm);
    }
}

/// What is left of a section once its rim has been taken away, up to 3 mm of it and never all.
std::vector<glm::dvec2> wellInside(std::vector<glm::dvec2> section, const Extent& extent, double step_mm) {
  constexpr double kDeep_mm = 3.0;
  const int columns = 2 * static_cast<int>(std::ceil(extent.halfWidth_mm / step_mm)) + 3;
  const int rows = static_cast<int>(std::ceil((extent.bottom_mm - extent.top_mm) / step_mm)) + 3;
  const auto cellOf = [&](const glm::dvec2& p_mm) {
    const auto row = std::lround((p_mm.y - extent.top_mm) / step_mm - 0.5) + 1;
    return static_cast<std::size_t>(row * columns + std::lround(p_mm.x / step_mm) + columns / 2);
  };
  const auto wide = static_cast<std::size_t>(columns);
  std::vector<std::uint8_t> isIn(wide * static_cast<std::size_t>(rows), 0);
  for (const glm::dvec2& p_mm : section) isIn[cellOf(p_mm)] = 1;
  for (double depth_mm = step_mm; depth_mm <= kDeep_mm; depth_mm += step_mm) {
    std::vector<glm::dvec2> deeper;
    for (const glm::dvec2& p_mm : section) {
      const std::size_t cell = cellOf(p_mm);
      if (isIn[cell - 1] != 0 && isIn[cell + 1] != 0 && isIn[cell - wide] != 0 && isIn[cell + wide] != 0) deeper.push_back(p_mm);
    }
    if (deeper.empty()) break;
    section = std::move(deeper);
    std::fill(isIn.begin(), isIn.end(), 0);
    for (const glm::dvec2& p_mm : section) isIn[cellOf(p_mm)] = 1;
  }
  return section;
}

}  // namespace

std::optional<double> placeInFan(const Fan& fan, const glm::dvec2& p_mm) {
  const Probe& probe = fan.probe;
  if (!isSector(probe.kind)) {
    const double place = p_mm.x / (0.5 * probe.width_mm);
    if (p_mm.y < 0.0 || p_mm.y > fan.depth_mm || std::abs(place) > 1.0) return std::nullopt;
    return place;
  }
  const double behind_mm = p_mm.y + probe.radius_mm;
  const double range_mm = std::hypot(p_mm.x, behind_mm) - probe.radius_mm;
  if (range_mm < 0.0 || range_mm > fan.depth_mm) return std::nullopt;
  const double angle_rad = std::atan2(p_mm.x, behind_mm);
  if (std::abs(angle_rad) > probe.halfAngle_rad) return std::nullopt;
  return probe.halfAngle_rad > 0.0 ? angle_rad / probe.halfAngle_rad : 0.0;
}

OrganVoxels::OrganVoxels(const Volume& labels, const Grid& placed, int label) : grid_(placed) {
  EW_EXPECTS(labels.echo.size() == labels.grid.voxelCount() && placed.dims == labels.grid.dims);
  const auto voxelToWorld = grid_.voxelToWorld();
  const glm::ivec3 dims = grid_.dims;
  glm::dvec3 sum(0.0);
  for (int k0 = 0; k0 < dims.z; k0 += kBlock)
    for (int j0 = 0; j0 < dims.y; j0 += kBlock)
      for (int i0 = 0; i0 < dims.x; i0 += kBlock) {
        Block block;
        BlockMask mask;
        block.first = centres_mm_.size();
        for (int k = k0; k < std::min(k0 + kBlock, dims.z); ++k) {
          const auto layer = static_cast<std::size_t>(k - k0);
          mask.before[layer] = static_cast<std::uint16_t>(centres_mm_.size() - block.first);
          for (int j = j0; j < std::min(j0 + kBlock, dims.y); ++j) {
            const std::uint8_t* row = labels.echo.data() + grid_.indexOf(0, j, k);
            for (int i = i0; i < std::min(i0 + kBlock, dims.x); ++i) {
              if (row[i] != label) continue;
              const glm::dvec3 centre = carried(voxelToWorld, glm::dvec3(i, j, k));
              centres_mm_.emplace_back(centre);
              block.middle_mm += centre;
              mask.layers[layer] |= std::uint64_t{1} << (kBlock * (j - j0) + i - i0);
            }
          }
        }
        block.end = centres_mm_.size();
        if (block.end == block.first) continue;
        sum += block.middle_mm;
        block.middle_mm /= static_cast<double>(block.end - block.first);
        for (std::size_t n = block.first; n < block.end; ++n)
          block.radius_mm = std::max(block.radius_mm, glm::distance(block.middle_mm, glm::dvec3(centres_mm_[n])));
        block.radius_mm += 1e-3;  // centres are kept as float
        blocks_.push_back(block);
        mask.corner_mm = carried(voxelToWorld, glm::dvec3(i0, j0, k0));
        masks_.push_back(mask);
      }
  if (!centres_mm_.empty()) middle_mm_ = sum / static_cast<double>(centres_mm_.size());
}

double distanceTo_mm(const OrganVoxels& organ, const glm::dvec3& p_world_mm) {
  double nearest_mm = std::numeric_limits<double>::infinity();
  const glm::dvec3 half_mm = 0.5 * organ.grid().spacing_mm;
  const double corner_mm = glm::length(half_mm);
  const glm::dmat3 toAxes = glm::transpose(organ.grid().directions);
  for (const OrganVoxels::Block& block : organ.blocks()) {
    if (glm::distance(block.middle_mm, p_world_mm) - block.radius_mm - corner_mm > nearest_mm) continue;
    for (std::size_t n = block.first; n < block.end; ++n) {
      const glm::dvec3 away = glm::abs(toAxes * (p_world_mm - glm::dvec3(organ.centres_mm()[n])));
      nearest_mm = std::min(nearest_mm, glm::length(glm::max(away - half_mm, glm::dvec3(0.0))));
    }
  }
  // Centres are rounded to float: what lies on a voxel's face is inside.
  return nearest_mm < 1e-4 ? 0.0 : nearest_mm;
}

OrganSection sectionOf(const Volume& labels, int label, const Fan& fan, const Pose& pose, double step_mm) {
  std::vector<glm::dvec2> inside;
  const auto probeToVoxel = labels.grid.worldToVoxel() * pose.probeToWorld;
  overRaster(fan, step_mm, [&](const glm::dvec2& p_mm) {
    const glm::ivec3 voxel(glm::round(carried(probeToVoxel, glm::dvec3(p_mm, 0.0))));
    if (labels.grid.contains(voxel) && labels.echo[labels.grid.indexOf(voxel.x, voxel.y, voxel.z)] == label) inside.push_back(p_mm);
  });
  OrganSection section;
  if (inside.empty()) return section;
  section.area_mm2 = static_cast<double>(inside.size()) * step_mm * step_mm;
  glm::dvec2 middle(0.0);
  for (const glm::dvec2& p_mm : inside) middle += p_mm / static_cast<double>(inside.size());
  inside = wellInside(std::move(inside), extentOf(fan), step_mm);
  section.inside_mm = *std::min_element(inside.begin(), inside.end(), [&](const glm::dvec2& a, const glm::dvec2& b) {
    return glm::distance(a, middle) < glm::distance(b, middle);
  });
  return section;
}

double areaOf_mm2(const Fan& fan, double step_mm) {
  double area_mm2 = 0.0;
  overRaster(fan, step_mm, [&](const glm::dvec2&) { area_mm2 += step_mm * step_mm; });
  return area_mm2;
}

}  // namespace ew
