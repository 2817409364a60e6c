#include "ew/phantom/label_grid.h"

#include <algorithm>
#include <new>

#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "patient/anatomy.h"

namespace ew {
namespace {

constexpr int kLabelBlock = 8;
// As in voxelise: how far a first-order distance may exceed the true one before a block is wrongly left out.
constexpr double kLabelReserve = 1.5;
constexpr double kInside_mm = 0.1;  // how far outside distances are told from one another: not at all

/// The organs that can own a point within `radius_mm` of the centre, by priority.
void select(const Patient& patient, const glm::dvec3& centre_mm, double radius_mm, std::vector<std::size_t>& near) {
  near.clear();
  for (std::size_t n = 0; n < patient.organs.size(); ++n) {
    const phantom::Shape& shape = *patient.organs[n].shape;
    if (shape.atLeast_mm(centre_mm) > radius_mm) continue;
    const double d = shape.distanceUpTo_mm(centre_mm, kLabelReserve * radius_mm);
    if (d >= kLabelReserve * radius_mm) continue;
    near.push_back(n);
    if (d < -kLabelReserve * radius_mm) return;  // whatever comes later is hidden by this one
  }
}

std::uint8_t labelAmong(const Patient& patient, const std::vector<std::size_t>& near, const glm::dvec3& p_mm) {
  for (const std::size_t n : near)
    if (patient.organs[n].shape->distanceUpTo_mm(p_mm, kInside_mm) < 0.0) return static_cast<std::uint8_t>(n + 1);
  return 0;
}

}  // namespace

Result<std::vector<std::uint8_t>> labelsOn(const Patient& patient, const Grid& grid, int threads, Progress& progress,
                                           std::uint64_t maxBytes) {
  if (const auto usable = checkGrid(grid); !usable) return passOn(usable.error());
  const auto tooLarge = [&] {
    return failure(ErrorCode::tooLarge, say<"The labels of %1 voxels need more memory than is allowed; choose a coarser spacing.">(
                                            textOf(static_cast<double>(grid.voxelCount()))));
  };
  if (grid.voxelCount() > maxBytes) return tooLarge();
  std::vector<std::uint8_t> labels;
  try {
    labels.resize(grid.voxelCount(), 0);
  } catch (const std::bad_alloc&) {
    return tooLarge();
  }
  const auto voxelToWorld = grid.voxelToWorld();
  const auto worldOf = [&](const glm::dvec3& ijk) { return (voxelToWorld * Point<frame::Voxel>{ijk}).at; };
  const double radius_mm = 0.5 * (kLabelBlock - 1) * glm::length(grid.spacing_mm);
  const glm::ivec3 blocks = (grid.dims + kLabelBlock - 1) / kLabelBlock;
  const auto labelRow = [&](int task, int /*worker*/, const auto& isStopped) {
    std::vector<std::size_t> near;
    near.reserve(patient.organs.size());
    const glm::ivec2 at(task % blocks.y, task / blocks.y);
    for (int i = 0; i < blocks.x && !isStopped(); ++i) {
      const glm::ivec3 first(i * kLabelBlock, at.x * kLabelBlock, at.y * kLabelBlock);
      const glm::ivec3 last = glm::min(first + kLabelBlock, grid.dims);
      const glm::dvec3 centre_mm = worldOf(glm::dvec3(first) + 0.5 * (kLabelBlock - 1));
      const double skin_mm = patient.skin->distance_mm(centre_mm);
      if (skin_mm > kLabelReserve * radius_mm) continue;
      const bool allInside = skin_mm < -kLabelReserve * radius_mm;
      select(patient, centre_mm, radius_mm, near);
      if (near.empty()) continue;
      for (int k = first.z; k < last.z; ++k)
        for (int j = first.y; j < last.y && !isStopped(); ++j)
          for (int x = first.x; x < last.x; ++x) {
            const glm::dvec3 p_mm = worldOf(glm::dvec3(x, j, k));
            if (!allInside && patient.skin->distance_mm(p_mm) >= 0.0) continue;
            labels[grid.indexOf(x, j, k)] = labelAmong(patient, near, p_mm);
          }
    }
  };
  const bool finished = forEachTask(blocks.y * blocks.z, threads, progress, say<"Labelling the tissues">(), labelRow);
  if (!finished) return failure(ErrorCode::cancelled, say<"Labelling the tissues was stopped.">());
  return labels;
}

}  // namespace ew
