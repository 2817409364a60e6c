#include "ew/phantom/tissue_within.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>

#include "echoes/tissue_painter.h"
#include "echoes/voxelise_problems.h"
#include "ew/core/large_pages.h"
#include "ew/core/parallel.h"

namespace ew {
namespace {

using phantom::kInnerBlock;
using phantom::Organ;

constexpr int kBlocksOfTask = 128;

/// Blocks of a grid's voxels, in their order in the volume, that lie within `beyond_mm` of the capsules.
std::vector<glm::ivec3> blocksWithin(const Grid& grid, std::span<const Capsule> capsules, double beyond_mm) {
  const glm::ivec3 count = (grid.dims + kInnerBlock - 1) / kInnerBlock;
  const double spacing_mm = grid.spacing_mm.x, radius_mm = phantom::blockRadius_mm(kInnerBlock, spacing_mm);
  std::vector<std::uint8_t> isAsked(samplesIn(count), 0);
  for (const Capsule& capsule : capsules) {
    const double reach_mm = capsule.radius_mm + beyond_mm + radius_mm;
    const auto blockAt = [&](const glm::dvec3& p_mm) {
      return glm::floor((p_mm - grid.origin_mm) / (kInnerBlock * spacing_mm) + 0.5 / kInnerBlock);
    };
    const glm::dvec3 lowest = glm::max(blockAt(glm::min(capsule.from_mm, capsule.to_mm) - reach_mm), glm::dvec3(0.0));
    const glm::dvec3 highest = glm::min(blockAt(glm::max(capsule.from_mm, capsule.to_mm) + reach_mm), glm::dvec3(count - 1));
    if (!glm::all(glm::lessThanEqual(lowest, highest))) continue;
    for (int k = static_cast<int>(lowest.z); k <= static_cast<int>(highest.z); ++k)
      for (int j = static_cast<int>(lowest.y); j <= static_cast<int>(highest.y); ++j)
        for (int i = static_cast<int>(lowest.x); i <= static_cast<int>(highest.x); ++i) {
          std::uint8_t& block = isAsked[sampleIndex(count, i, j, k)];
          if (block != 0) continue;
          const glm::dvec3 centre_mm = phantom::blockCentre_mm(grid, kInnerBlock * glm::ivec3(i, j, k), kInnerBlock);
          block = distanceToLine_mm(capsule, centre_mm) <= reach_mm ? 1 : 0;
        }
  }
  std::vector<glm::ivec3> blocks;
  for (int k = 0; k < count.z; ++k)
    for (int j = 0; j < count.y; ++j)
      for (int i = 0; i < count.x; ++i)
        if (isAsked[sampleIndex(count, i, j, k)] != 0) blocks.push_back(kInnerBlock * glm::ivec3(i, j, k));
  return blocks;
}

/// As voxelise meets them, so that of two feet as near the same is taken.
void sortAsInWhole(std::vector<phantom::SurfaceFoot>& feet) {
  const auto keyOf = [](const phantom::SurfaceFoot& foot) {
    const glm::ivec3 &at = foot.voxel, block = at / phantom::kPaintedBlock;
    return std::array{block.z, block.y, block.x, at.z, at.y, at.x};
  };
  std::sort(feet.begin(), feet.end(), [&](const auto& a, const auto& b) { return keyOf(a) < keyOf(b); });
}

/// A surface is known as far from its foot, and is found with the feet as far around.
double surfacesReach_mm(double spacing_mm) { return TissueMaps::kSurfaceReach_mm + 2.0 * spacing_mm; }

class PartPainter {
 public:
  PartPainter(const Patient& patient, TissuePart& made)
      : patient_(patient),
        made_(made),
        grid_(made.maps.grid),
        spacing_mm_(grid_.spacing_mm.x),
        finder_(patient, spacing_mm_),
        painter_(patient, spacing_mm_) {}

  [[nodiscard]] const phantom::SurfaceFinder& surfaces() const { return painter_.surfaces(); }

  /// @param feet of surfaces beside the block's voxels are appended
  template <class Stopped>
  void paint(const glm::ivec3& first, const Stopped& stopped, phantom::TextureAlong& textures, std::vector<phantom::SurfaceFoot>& feet) {
    const glm::ivec3 last = glm::min(first + kInnerBlock, grid_.dims);
    const glm::dvec3 centre_mm = phantom::blockCentre_mm(grid_, first, kInnerBlock);
    if (finder_.isOutside(centre_mm, kInnerBlock, true)) return;
    std::vector<const Organ*> near;
    std::vector<double> distances_mm;
    finder_.select(centre_mm, kInnerBlock, finder_.all(), near);
    for (int k = first.z; k < last.z; ++k)
      for (int j = first.y; j < last.y && !stopped(); ++j)
        for (int i = first.x; i < last.x; ++i) {
          const glm::dvec3 p_mm = grid_.origin_mm + spacing_mm_ * glm::dvec3(i, j, k);
          const double skin_mm = patient_.skin->distance_mm(p_mm);
          if (skin_mm >= 0.0 && !(painter_.bodyPart(skin_mm) > 0.0)) continue;
          const int label = finder_.distancesAt(p_mm, near, distances_mm);
          const std::size_t at = grid_.indexOf(i, j, k);
          made_.maps.level[at] = painter_.levelAt(p_mm, skin_mm, near, distances_mm, textures);
          if (skin_mm < 0.0) made_.labels[at] = static_cast<std::uint8_t>(label);
          if (auto foot = painter_.surfaces().nearest(p_mm, skin_mm, near, distances_mm)) {
            foot->voxel = {i, j, k};
            feet.push_back(*foot);
          }
        }
  }

 private:
  const Patient& patient_;
  TissuePart& made_;
  const Grid& grid_;
  double spacing_mm_;
  phantom::OrganFinder finder_;
  phantom::TissuePainter painter_;
};

/// @return false when cancelled
bool paintBlocks(const Patient& patient, const std::vector<glm::ivec3>& blocks, int threads, Progress& progress, TissuePart& made) {
  PartPainter painter(patient, made);
  PartOfProgress painting(progress, 0.0, 0.9), spreading(progress, 0.9, 1.0);
  const int tasks = (static_cast<int>(blocks.size()) + kBlocksOfTask - 1) / kBlocksOfTask;
  std::vector<std::vector<phantom::SurfaceFoot>> feet(static_cast<std::size_t>(tasks));
  const auto paintTask = [&](int task, int /*worker*/, const auto& stopped) {
    const auto first = static_cast<std::size_t>(task) * kBlocksOfTask, last = std::min(first + kBlocksOfTask, blocks.size());
    phantom::TextureAlong textures(patient.tissues.size());
    for (std::size_t n = first; n < last && !stopped(); ++n)
      painter.paint(blocks[n], stopped, textures, feet[static_cast<std::size_t>(task)]);
  };
  if (!forEachTask(tasks, threads, painting, say<"Building what the image shows">(), paintTask)) return false;
  std::vector<std::vector<phantom::SurfaceFoot>> all(1);
  for (const auto& each : feet) all.front().insert(all.front().end(), each.begin(), each.end());
  sortAsInWhole(all.front());
  return phantom::spreadSurfaces(painter.surfaces(), all, threads, spreading, made.maps);
}

}  // namespace

double shareWithin(const Bounds& box, double spacing_mm, std::span<const Capsule> capsules) {
  const Grid grid = phantom::voxelGridOver(box, spacing_mm);
  const auto all = static_cast<double>(samplesIn((grid.dims + kInnerBlock - 1) / kInnerBlock));
  return static_cast<double>(blocksWithin(grid, capsules, surfacesReach_mm(spacing_mm)).size()) / all;
}

Result<TissuePart> tissueWithin(const Patient& patient, std::span<const Capsule> capsules, const TissuePartOptions& options,
                                Progress& progress) {
  if (auto usable = phantom::checkVoxelSpacing(options.spacing_mm); !usable) return passOn(usable.error());
  const double forecast_bytes = voxeliseForecast_bytes(patient, options.spacing_mm, true);
  const auto tooLarge = [&] { return phantom::tooLargeAt(options.spacing_mm, options.maxBytes, forecast_bytes); };
  if (forecast_bytes > static_cast<double>(options.maxBytes)) return tooLarge();
  TissuePart made;
  made.maps.grid = voxelGridOf(patient, options.spacing_mm);
  if (const auto usable = checkGrid(made.maps.grid); !usable) return passOn(usable.error());
  try {
    for (std::vector<std::uint8_t>* values : {&made.labels, &made.maps.level, &made.maps.surfaceDistance, &made.maps.surfaceKind})
      if (!growInLargePages(*values, made.maps.grid.voxelCount(), progress)) return phantom::stoppedByUser();
    const std::vector<glm::ivec3> blocks = blocksWithin(made.maps.grid, capsules, surfacesReach_mm(options.spacing_mm));
    if (!paintBlocks(patient, blocks, options.threads, progress, made)) return phantom::stoppedByUser();
  } catch (const std::bad_alloc&) {
    return tooLarge();
  } catch (const std::length_error&) {
    return tooLarge();
  }
  return made;
}

}  // namespace ew
