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

/// Which blocks of a grid's voxels are asked for.
class BlockMarks {
 public:
  /// @param beyond_mm how much farther than the capsules
  BlockMarks(const Grid& grid, double beyond_mm)
      : grid_(grid),
        count_((grid.dims + kInnerBlock - 1) / kInnerBlock),
        spacing_mm_(grid.spacing_mm.x),
        beyond_mm_(beyond_mm + phantom::blockRadius_mm(kInnerBlock, spacing_mm_)),
        isAsked_(samplesIn(count_), 0) {}

  [[nodiscard]] double share() const { return static_cast<double>(asked_) / static_cast<double>(isAsked_.size()); }

  void add(const Capsule& capsule) {
    const double reach_mm = capsule.radius_mm + beyond_mm_;
    const glm::dvec3 lowest = glm::max(blockAt(glm::min(capsule.from_mm, capsule.to_mm) - reach_mm), glm::dvec3(0.0));
    const glm::dvec3 highest = glm::min(blockAt(glm::max(capsule.from_mm, capsule.to_mm) + reach_mm), glm::dvec3(count_ - 1));
    if (!glm::all(glm::lessThanEqual(lowest, highest))) return;
    for (int k = static_cast<int>(lowest.z); k <= static_cast<int>(highest.z); ++k)
      for (int j = static_cast<int>(lowest.y); j <= static_cast<int>(highest.y); ++j)
        for (int i = static_cast<int>(lowest.x); i <= static_cast<int>(highest.x); ++i) {
          std::uint8_t& block = isAsked_[sampleIndex(count_, i, j, k)];
          if (block != 0) continue;
          const glm::dvec3 centre_mm = phantom::blockCentre_mm(grid_, kInnerBlock * glm::ivec3(i, j, k), kInnerBlock);
          if (distanceToLine_mm(capsule, centre_mm) > reach_mm) continue;
          block = 1;
          ++asked_;
        }
  }
  [[nodiscard]] std::vector<glm::ivec3> firstVoxels() const {
    std::vector<glm::ivec3> first;
    first.reserve(asked_);
    for (int k = 0; k < count_.z; ++k)
      for (int j = 0; j < count_.y; ++j)
        for (int i = 0; i < count_.x; ++i)
          if (isAsked_[sampleIndex(count_, i, j, k)] != 0) first.push_back(kInnerBlock * glm::ivec3(i, j, k));
    return first;
  }

 private:
  [[nodiscard]] glm::dvec3 blockAt(const glm::dvec3& p_mm) const {
    return glm::floor((p_mm - grid_.origin_mm) / (kInnerBlock * spacing_mm_) + 0.5 / kInnerBlock);
  }

  const Grid& grid_;
  glm::ivec3 count_;
  double spacing_mm_;
  double beyond_mm_;
  std::vector<std::uint8_t> isAsked_;
  std::size_t asked_ = 0;
};

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

/// Of what tissueWithin holds at once.
double partForecast_bytes(const VoxelBlocks& blocks) {
  constexpr double kPerVoxel = 5.0;  // echoes, labels and maps
  const double painted = static_cast<double>(blocks.first.size()) * kInnerBlock * kInnerBlock * kInnerBlock;
  return kPerVoxel * static_cast<double>(blocks.grid.voxelCount()) + painted * phantom::kSurfaceBytesPerVoxel +
         phantom::spreadForecast_bytes(blocks.grid, 0);
}

class PartPainter {
 public:
  PartPainter(const Patient& patient, VoxelPatient& made)
      : patient_(patient),
        made_(made),
        grid_(made.volume.grid),
        spacing_mm_(grid_.spacing_mm.x),
        finder_(patient, spacing_mm_),
        painter_(patient, spacing_mm_) {}

  [[nodiscard]] const phantom::SurfaceFinder& surfaces() const { return painter_.surfaces(); }

  /// @param feet of surfaces beside the block's voxels are appended
  template <class Stopped>
  void paint(const glm::ivec3& first, const Stopped& stopped, std::vector<phantom::SurfaceFoot>& feet) {
    const glm::ivec3 last = glm::min(first + kInnerBlock, grid_.dims);
    const glm::dvec3 centre_mm = phantom::blockCentre_mm(grid_, first, kInnerBlock);
    if (finder_.isOutside(centre_mm, kInnerBlock, true)) return;
    std::vector<const Organ*> near;
    std::vector<double> distances_mm;
    finder_.select(centre_mm, kInnerBlock, near);
    for (int k = first.z; k < last.z; ++k)
      for (int j = first.y; j < last.y && !stopped(); ++j)
        for (int i = first.x; i < last.x; ++i) {
          const glm::dvec3 p_mm = grid_.origin_mm + spacing_mm_ * glm::dvec3(i, j, k);
          const double skin_mm = patient_.skin->distance_mm(p_mm);
          if (skin_mm >= 0.0 && !(painter_.bodyPart(skin_mm) > 0.0)) continue;
          const int label = finder_.distancesAt(p_mm, near, distances_mm);
          const std::size_t at = grid_.indexOf(i, j, k);
          made_.maps->level[at] = painter_.levelAt(p_mm, skin_mm, near, distances_mm);
          if (skin_mm < 0.0) made_.labels[at] = static_cast<std::uint8_t>(label);
          if (auto foot = painter_.surfaces().nearest(p_mm, skin_mm, near, distances_mm)) {
            foot->voxel = {i, j, k};
            feet.push_back(*foot);
          }
        }
  }

 private:
  const Patient& patient_;
  VoxelPatient& made_;
  const Grid& grid_;
  double spacing_mm_;
  phantom::OrganFinder finder_;
  phantom::TissuePainter painter_;
};

/// @return false when cancelled
bool paintBlocks(const Patient& patient, const std::vector<glm::ivec3>& blocks, int threads, Progress& progress, VoxelPatient& made) {
  PartPainter painter(patient, made);
  PartOfProgress painting(progress, 0.0, 0.9), spreading(progress, 0.9, 1.0);
  const int tasks = (static_cast<int>(blocks.size()) + kBlocksOfTask - 1) / kBlocksOfTask;
  std::vector<std::vector<phantom::SurfaceFoot>> feet(static_cast<std::size_t>(tasks));
  const auto paintTask = [&](int task, int /*worker*/, const auto& stopped) {
    const auto first = static_cast<std::size_t>(task) * kBlocksOfTask, last = std::min(first + kBlocksOfTask, blocks.size());
    for (std::size_t n = first; n < last && !stopped(); ++n) painter.paint(blocks[n], stopped, feet[static_cast<std::size_t>(task)]);
  };
  if (!forEachTask(tasks, threads, painting, say<"Building what the image shows">(), paintTask)) return false;
  std::vector<std::vector<phantom::SurfaceFoot>> all(1);
  for (const auto& each : feet) all.front().insert(all.front().end(), each.begin(), each.end());
  sortAsInWhole(all.front());
  return phantom::spreadSurfaces(painter.surfaces(), all, threads, spreading, *made.maps);
}

}  // namespace

Result<std::optional<VoxelBlocks>> voxelBlocksAt(const ViewPlaces& seen, const Bounds& box, double spacing_mm, double mostShare,
                                                 Progress& progress) {
  if (auto usable = phantom::checkVoxelSpacing(spacing_mm); !usable) return passOn(usable.error());
  VoxelBlocks blocks{phantom::voxelGridOver(box, spacing_mm)};
  if (const auto usable = checkGrid(blocks.grid); !usable) return passOn(usable.error());
  BlockMarks asked(blocks.grid, surfacesReach_mm(spacing_mm));
  for (std::size_t n = 0; n < seen.toPatient.size(); ++n) {
    if (progress.cancelRequested()) return phantom::stoppedByUser();
    progress.report(say<"Looking what the images show">(), static_cast<double>(n) / static_cast<double>(seen.toPatient.size()));
    const glm::dmat4& place = seen.toPatient[n];
    if (n > 0 && place == seen.toPatient[n - 1]) continue;  // lines of a strip
    const auto at = [&](const glm::dvec3& p_mm) { return glm::dvec3(place * glm::dvec4(p_mm, 1.0)); };
    for (const Capsule& each : seen.capsules) asked.add({at(each.from_mm), at(each.to_mm), each.radius_mm});
    if (asked.share() > mostShare) return std::nullopt;
  }
  blocks.first = asked.firstVoxels();
  blocks.share = asked.share();
  return blocks;
}

Result<VoxelPatient> tissueWithin(const Patient& patient, const VoxelBlocks& blocks, const TissuePartOptions& options, Progress& progress) {
  if (const auto usable = checkGrid(blocks.grid); !usable) return passOn(usable.error());
  const double spacing_mm = blocks.grid.spacing_mm.x;
  const double forecast_bytes = partForecast_bytes(blocks);
  const auto tooLarge = [&] { return phantom::tooLargeAt(spacing_mm, options.maxBytes, forecast_bytes); };
  if (forecast_bytes > static_cast<double>(options.maxBytes)) return tooLarge();
  VoxelPatient made;
  made.volume.grid = blocks.grid;
  made.maps.emplace().grid = blocks.grid;
  try {
    for (std::vector<std::uint8_t>* values :
         {&made.volume.echo, &made.labels, &made.maps->level, &made.maps->surfaceDistance, &made.maps->surfaceKind})
      if (!growInLargePages(*values, blocks.grid.voxelCount(), progress)) return phantom::stoppedByUser();
    if (!paintBlocks(patient, blocks.first, options.threads, progress, made)) return phantom::stoppedByUser();
  } catch (const std::bad_alloc&) {
    return tooLarge();
  } catch (const std::length_error&) {
    return tooLarge();
  }
  return made;
}

}  // namespace ew
