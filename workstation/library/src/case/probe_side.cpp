#include "ew/library/probe_side.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ew/core/contract.h"
#include "ew/core/word_table.h"

namespace ew {
namespace {

constexpr double kClear = 0.7;  // a side that is twice as bright or half as wide leaves no doubt

/// Where beams go that come from a side of a patient in LPS.
glm::dvec3 inwardFrom(VolumeSide side) {
  switch (side) {
    case VolumeSide::front:
      return {0.0, 1.0, 0.0};
    case VolumeSide::back:
      return {0.0, -1.0, 0.0};
    case VolumeSide::left:
      return {-1.0, 0.0, 0.0};
    case VolumeSide::right:
      return {1.0, 0.0, 0.0};
    case VolumeSide::upper:
      return {0.0, 0.0, -1.0};
    case VolumeSide::lower:
      return {0.0, 0.0, 1.0};
  }
  return {0.0, 1.0, 0.0};
}

/// What the slabs of voxels across each axis hold.
struct Slabs {
  std::array<std::vector<double>, 3> grey;   // sum over the voxels with data
  std::array<std::vector<double>, 3> count;  // of these
};

Slabs slabsOf(const Volume& volume) {
  const glm::ivec3 dims = volume.grid.dims;
  Slabs slabs;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto length = static_cast<std::size_t>(dims[static_cast<int>(axis)]);
    slabs.grey[axis].assign(length, 0.0);
    slabs.count[axis].assign(length, 0.0);
  }
  const bool isCovered = !volume.coverage.empty();
  std::size_t voxel = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dims.z); ++k)
    for (std::size_t j = 0; j < static_cast<std::size_t>(dims.y); ++j)
      for (std::size_t i = 0; i < static_cast<std::size_t>(dims.x); ++i, ++voxel) {
        if (isCovered ? volume.coverage[voxel] == 0 : volume.echo[voxel] == 0) continue;
        const double grey = volume.echo[voxel];
        slabs.grey[0][i] += grey, slabs.grey[1][j] += grey, slabs.grey[2][k] += grey;
        slabs.count[0][i] += 1.0, slabs.count[1][j] += 1.0, slabs.count[2][k] += 1.0;
      }
  return slabs;
}

/// How much speaks for the probe having stood where the slabs begin; below 0: where they end.
double forTheirBegin(const std::vector<double>& grey, const std::vector<double>& count) {
  const auto hasData = [](double n) { return n > 0.0; };
  const auto first = std::find_if(count.begin(), count.end(), hasData);
  if (first == count.end()) return 0.0;
  const auto last = std::find_if(count.rbegin(), count.rend(), hasData).base();
  const auto slabs = last - first;
  const auto quarter = slabs / 4;
  if (quarter < 1) return 0.0;
  const auto offset = first - count.begin();
  const auto sum = [&](const std::vector<double>& of, std::ptrdiff_t from) {
    double all = 0.0;
    for (std::ptrdiff_t n = 0; n < quarter; ++n) all += of[static_cast<std::size_t>(offset + from + n)];
    return all;
  };
  const double nearCount = sum(count, 0), farCount = sum(count, slabs - quarter);
  const double nearGrey = sum(grey, 0) / nearCount, farGrey = sum(grey, slabs - quarter) / farCount;
  return std::log((nearGrey + 1.0) / (farGrey + 1.0)) + std::log(farCount / nearCount);
}

int axisAlong(const Grid& own, const glm::dvec3& direction) {
  int best = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(glm::dot(own.directions[axis], direction)) > std::abs(glm::dot(own.directions[best], direction))) best = axis;
  return best;
}

constexpr WordTable<VolumeSide, 6> kVolumeSideWords{{{"front", VolumeSide::front},
                                                     {"back", VolumeSide::back},
                                                     {"left", VolumeSide::left},
                                                     {"right", VolumeSide::right},
                                                     {"upper", VolumeSide::upper},
                                                     {"lower", VolumeSide::lower}}};

}  // namespace

glm::dvec3 inwardOf(const Grid& own, std::size_t side) {
  return (side % 2 == 0 ? 1.0 : -1.0) * glm::normalize(own.directions[static_cast<int>(side / 2)]);
}

std::array<SweepAxes, 6> axesOfFaces(const Grid& own, const glm::dvec3& lateral) {
  std::array<SweepAxes, 6> all;
  for (std::size_t face = 0; face < all.size(); ++face) {
    all[face].depth = inwardOf(own, face);
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == static_cast<int>(face / 2)) continue;
      const glm::dvec3 direction = glm::normalize(own.directions[axis]);
      const double along = glm::dot(direction, lateral);
      if (std::abs(along) <= most) continue;
      most = std::abs(along);
      all[face].lateral = along < 0.0 ? -direction : direction;
    }
  }
  return all;
}

const char* nameOf(VolumeSide side) { return wordIn(kVolumeSideWords, side); }

std::optional<VolumeSide> volumeSideOf(std::string_view name) { return meaningIn(kVolumeSideWords, name); }

VolumeSide volumeSideOf(const SweepAxes& axes) {
  const auto most = std::max_element(kVolumeSideWords.begin(), kVolumeSideWords.end(), [&](const auto& a, const auto& b) {
    return glm::dot(inwardFrom(a.second), axes.depth) < glm::dot(inwardFrom(b.second), axes.depth);
  });
  return most->second;
}

SweepAxes axesFrom(const Grid& own, VolumeSide side) {
  const bool isFlank = side == VolumeSide::left || side == VolumeSide::right;
  const auto all = axesOfFaces(own, isFlank ? glm::dvec3(0.0, 0.0, 1.0) : SweepAxes{}.lateral);
  const glm::dvec3 inward = inwardFrom(side);
  return *std::max_element(all.begin(), all.end(),
                           [&](const SweepAxes& a, const SweepAxes& b) { return glm::dot(a.depth, inward) < glm::dot(b.depth, inward); });
}

ProbeSide proposedProbeSide(const Volume& volume) {
  ProbeSide found{axesFrom(volume.grid, VolumeSide::front), 0.0};
  if (volume.echo.empty()) return found;
  const Slabs slabs = slabsOf(volume);
  std::size_t side = 0;
  double most = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double speaks = forTheirBegin(slabs.grey[axis], slabs.count[axis]);
    if (std::abs(speaks) <= most) continue;
    most = std::abs(speaks);
    side = 2 * axis + (speaks < 0.0 ? 1 : 0);
  }
  found.certainty = std::min(1.0, most / kClear);
  // What noise alone makes of equal sides proposes nothing.
  if (found.certainty < 0.1) return found;
  found.axes = axesFrom(volume.grid, volumeSideOf(SweepAxes{inwardOf(volume.grid, side), {}}));
  return found;
}

GreyImage middleImage(const Volume& volume, const SweepAxes& axes, int longest_px) {
  EW_EXPECTS(longest_px > 0);
  const Grid& grid = volume.grid;
  const int down = axisAlong(grid, axes.depth), across = axisAlong(grid, axes.lateral);
  const auto length_mm = [&](int axis) { return grid.dims[axis] * grid.spacing_mm[axis]; };
  const double pixel_mm = std::max(length_mm(down), length_mm(across)) / longest_px;
  const auto pixels = [&](int axis) { return std::clamp(static_cast<int>(std::lround(length_mm(axis) / pixel_mm)), 1, longest_px); };
  GreyImage image(pixels(across), pixels(down));
  const bool fromEnd = glm::dot(grid.directions[down], axes.depth) < 0.0;
  const bool toBegin = glm::dot(grid.directions[across], axes.lateral) < 0.0;
  const auto voxelAt = [&](int axis, int pixel, int of, bool isTurned) {
    const int n = std::min(grid.dims[axis] - 1, static_cast<int>((pixel + 0.5) * grid.dims[axis] / of));
    return isTurned ? grid.dims[axis] - 1 - n : n;
  };
  glm::ivec3 at = grid.dims / 2;
  for (int y = 0; y < image.height; ++y) {
    at[down] = voxelAt(down, y, image.height, fromEnd);
    for (int x = 0; x < image.width; ++x) {
      at[across] = voxelAt(across, x, image.width, toBegin);
      image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)] =
          volume.echo[grid.indexOf(at.x, at.y, at.z)];
    }
  }
  return image;
}

Volume thinned(const Volume& volume, int most) {
  EW_EXPECTS(most > 0);
  const Grid& grid = volume.grid;
  glm::ivec3 step(1);
  for (int axis = 0; axis < 3; ++axis) step[axis] = std::max(1, (grid.dims[axis] + most - 1) / most);
  Volume thin;
  thin.grid = grid;
  thin.grid.dims = (grid.dims + step - 1) / step;
  thin.grid.spacing_mm = grid.spacing_mm * glm::dvec3(step);
  thin.echo.reserve(thin.grid.voxelCount());
  for (int k = 0; k < grid.dims.z; k += step.z)
    for (int j = 0; j < grid.dims.y; j += step.y)
      for (int i = 0; i < grid.dims.x; i += step.x) thin.echo.push_back(volume.echo[grid.indexOf(i, j, k)]);
  return thin;
}

}  // namespace ew
