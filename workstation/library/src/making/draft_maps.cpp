#include "making/draft_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ew/core/contract.h"
#include "ew/core/large_pages.h"
#include "ew/core/parallel.h"

namespace ew {
namespace {

/// Where the voxels of one axis of the finer grid lie between those of the coarser one.
struct Between {
  int first = 0;
  float share = 0.0F;  ///< of the next
};

std::vector<Between> alongAxis(const Grid& coarse, const Grid& fine, int axis) {
  std::vector<Between> places(static_cast<std::size_t>(fine.dims[axis]));
  const double from = glm::dot(fine.origin_mm - coarse.origin_mm, glm::dvec3(coarse.directions[axis]));
  for (std::size_t n = 0; n < places.size(); ++n) {
    const double at = (from + fine.spacing_mm[axis] * static_cast<double>(n)) / coarse.spacing_mm[axis];
    const double within = std::clamp(at, 0.0, static_cast<double>(coarse.dims[axis] - 1));
    places[n].first = std::min(static_cast<int>(within), std::max(0, coarse.dims[axis] - 2));
    places[n].share = static_cast<float>(within - places[n].first);
  }
  return places;
}

/// Distances of the coarser maps in mm, and one voxel farther than they reach: cells of voxels so wide have corners that know no surface
/// although it crosses them. There the distance goes on as it does from the last but one voxel to the last.
struct Reaching {
  std::vector<float> distance_mm;
  std::vector<std::uint8_t> kind;

  explicit Reaching(const TissueMaps& maps) : distance_mm(maps.surfaceKind.size(), 0.0F), kind(maps.surfaceKind) {
    const Grid& grid = maps.grid;
    const auto known = [&](std::size_t at) {
      return static_cast<float>((maps.surfaceDistance[at] - 128.0) / TissueMaps::kDistanceStepsPerMm);
    };
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i) {
          const std::size_t at = grid.indexOf(i, j, k);
          if (kind[at] != 0) {
            distance_mm[at] = known(at);
            continue;
          }
          float sum = 0.0F;
          int count = 0;
          std::uint8_t found = 0;
          for (int axis = 0; axis < 3; ++axis)
            for (const int way : {-1, 1}) {
              glm::ivec3 next(i, j, k), last(i, j, k);
              next[axis] += way;
              last[axis] += 2 * way;
              if (!grid.contains(last)) continue;
              const std::size_t first = grid.indexOf(next.x, next.y, next.z), second = grid.indexOf(last.x, last.y, last.z);
              const std::uint8_t there = maps.surfaceKind[first];
              if (there == 0 || maps.surfaceKind[second] != there || (found != 0 && found != there)) continue;
              found = there;
              sum += 2.0F * known(first) - known(second);
              ++count;
            }
          if (count == 0) continue;
          kind[at] = found;
          distance_mm[at] = sum / static_cast<float>(count);
        }
  }
};

class Spreading {
 public:
  Spreading(const TissueMaps& coarse, TissueMaps& fine)
      : coarse_(coarse), fine_(fine), hasSurfaces_(!coarse.surfaceKind.empty()), reaching_(coarse) {
    for (int axis = 0; axis < 3; ++axis) places_[static_cast<std::size_t>(axis)] = alongAxis(coarse.grid, fine.grid, axis);
    for (int corner = 0; corner < 8; ++corner)
      offsets_[static_cast<std::size_t>(corner)] = coarse.grid.indexOf(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
  }

  /// What the voxels of one coarse line, between four, share with a row of the fine grid.
  struct Line {
    std::vector<float> sum, weight;  ///< of levels
    std::vector<char> hasSurface;
  };

  void row(int j, int k, Line& line) const {
    const Between y = places_[1][static_cast<std::size_t>(j)], z = places_[2][static_cast<std::size_t>(k)];
    const std::array<float, 4> across{(1.0F - y.share) * (1.0F - z.share), y.share * (1.0F - z.share), (1.0F - y.share) * z.share,
                                      y.share * z.share};
    const auto count = static_cast<std::size_t>(coarse_.grid.dims.x);
    const std::size_t start = coarse_.grid.indexOf(0, y.first, z.first);
    line.sum.assign(count, 0.0F);
    line.weight.assign(count, 0.0F);
    line.hasSurface.assign(count, 0);
    for (std::size_t pair = 0; pair < 4; ++pair) {
      const std::uint8_t* level = coarse_.level.data() + start + offsets_[2 * pair];
      for (std::size_t n = 0; n < count; ++n) {
        line.sum[n] += across[pair] * static_cast<float>(level[n]);
        line.weight[n] += level[n] != 0 ? across[pair] : 0.0F;
      }
      if (!hasSurfaces_) continue;
      const std::uint8_t* kind = reaching_.kind.data() + start + offsets_[2 * pair];
      for (std::size_t n = 0; n < count; ++n) line.hasSurface[n] = line.hasSurface[n] != 0 || kind[n] != 0;
    }
    std::size_t at = fine_.grid.indexOf(0, j, k);
    for (const Between& x : places_[0]) {
      const auto n = static_cast<std::size_t>(x.first);
      // Of the voxels that hold anything; nothing where these are the smaller half.
      const float weight = line.weight[n] + x.share * (line.weight[n + 1] - line.weight[n]);
      const float sum = line.sum[n] + x.share * (line.sum[n + 1] - line.sum[n]);
      fine_.level[at] = weight >= 0.5F ? static_cast<std::uint8_t>(sum / weight + 0.5F) : std::uint8_t{0};
      if (line.hasSurface[n] != 0 || line.hasSurface[n + 1] != 0) surface(at, start + n, x.share, across);
      ++at;
    }
  }

 private:
  void surface(std::size_t at, std::size_t from, float share, const std::array<float, 4>& across) const {
    std::array<float, 8> weights{};
    for (std::size_t pair = 0; pair < 4; ++pair) {
      weights[2 * pair] = across[pair] * (1.0F - share);
      weights[2 * pair + 1] = across[pair] * share;
    }
    std::size_t nearest = 0;
    for (std::size_t corner = 1; corner < 8; ++corner)
      if (weights[corner] > weights[nearest]) nearest = corner;
    const std::uint8_t kind = reaching_.kind[from + offsets_[nearest]];
    if (kind == 0) return;
    float sum = 0.0F, weight = 0.0F;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const std::size_t there = from + offsets_[corner];
      if (reaching_.kind[there] != kind) continue;
      sum += weights[corner] * reaching_.distance_mm[there];
      weight += weights[corner];
    }
    // What lies beyond the rim of the surface, or nearer to another one, would be a guess.
    const double distance_mm = static_cast<double>(sum / std::max(weight, 0.5F));
    if (weight < 0.5F || std::abs(distance_mm) > TissueMaps::kSurfaceReach_mm) return;
    fine_.surfaceKind[at] = kind;
    fine_.surfaceDistance[at] =
        static_cast<std::uint8_t>(std::clamp(128.0 + TissueMaps::kDistanceStepsPerMm * distance_mm + 0.5, 1.0, 255.0));
  }

  const TissueMaps& coarse_;
  TissueMaps& fine_;
  bool hasSurfaces_;
  Reaching reaching_;
  std::array<std::vector<Between>, 3> places_{};
  std::array<std::size_t, 8> offsets_{};
};

}  // namespace

std::optional<TissueMaps> spreadOn(const TissueMaps& coarse, const Grid& fine, int threads, Progress& progress) {
  EW_EXPECTS(glm::all(glm::greaterThan(coarse.grid.dims, glm::ivec3(1))));
  TissueMaps made;
  made.grid = fine;
  made.surfaces = coarse.surfaces;
  made.isRecorded = coarse.isRecorded;
  std::vector<std::vector<std::uint8_t>*> taken{&made.level};
  if (!coarse.surfaceKind.empty()) taken.insert(taken.end(), {&made.surfaceDistance, &made.surfaceKind});
  for (std::vector<std::uint8_t>* values : taken)
    if (!growInLargePages(*values, fine.voxelCount(), progress)) return std::nullopt;
  const Spreading spreading(coarse, made);
  const bool isWhole = forEachTask(fine.dims.z, threads, progress, say<"Showing the virtual patient">(), [&](int k) {
    Spreading::Line line;
    for (int j = 0; j < fine.dims.y; ++j) spreading.row(j, k, line);
  });
  if (!isWhole) return std::nullopt;
  return made;
}

}  // namespace ew
