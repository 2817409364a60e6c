#pragma once

#include <array>
#include <functional>
#include <map>

#include "cells.h"

namespace ew::stitching {

[[nodiscard]] inline tl::unexpected<Error> stitchingCancelled() {
  return failure(ErrorCode::cancelled, say<"The stitching was cancelled.">());
}

/// What every way to join asks of its views. @error emptyVolume, unsupported (too many), badField, notRigid, each naming the view
[[nodiscard]] Result<void> checkViews(std::span<const View> views);
[[nodiscard]] Result<void> checkSeamOptions(const SeamOptions& options, std::size_t views);

/// Where a tile's voxels go: arrays over a block of the result.
struct BlockArrays {
  glm::ivec3 corner{0};
  glm::ivec3 size{0};
  std::uint8_t* echo = nullptr;
  std::uint8_t* coverage = nullptr;
  std::uint8_t* source = nullptr;
  [[nodiscard]] std::size_t indexOf(int i, int j, int k) const { return sampleIndex(size, i - corner.x, j - corner.y, k - corner.z); }
};

/// How much two views differ in a cube of the blend.
struct StepSum {
  double count = 0.0;
  double difference = 0.0;
};
inline constexpr double kStepCube_mm = 6.0;
/// The two views, and the cube's place along i, j, k.
using StepPlace = std::array<int, 5>;

/// Sums over a tile; added up in the order of the tiles, so that no thread count changes them.
struct Tally {
  std::size_t covered = 0;      ///< voxels (cells, where there are seams)
  std::size_t overlapping = 0;  ///< of these, seen by two views or more
  std::size_t blended = 0;      ///< voxels made of two views or more
  double squaredSpread = 0.0;
  std::vector<Contribution> contributions;
  std::map<StepPlace, StepSum> steps;
  void add(const Tally& other);
};

/// Makes boxes of a result. A voxel depends on its place alone: not on the box, the order or the threads.
class Joiner {
 public:
  /// @param seams null for a feathered mean. Views, seams and distances outlive this.
  Joiner(std::span<const View> views, const SeamMap* seams, const Grid& result, const JoinOptions& options,
         const std::vector<std::vector<float>>& distances_mm);

  using Stopped = std::function<bool()>;
  /// Fills the voxels [begin, end), which lie in the block; its arrays hold zeros there.
  void make(const glm::ivec3& begin, const glm::ivec3& end, const BlockArrays& block, Tally& tally, const Stopped& stopped) const;

  /// Memory that one thread takes for a box of these voxels.
  [[nodiscard]] static std::uint64_t scratchBytes(const glm::ivec3& size, std::size_t views, const Grid& cells, const glm::ivec3& ratio);

 private:
  struct Row;
  struct Weights;
  struct SeamBox;
  void feather(const glm::ivec3& begin, const glm::ivec3& end, const BlockArrays& block, Tally& tally, const Stopped& stopped) const;
  void alongSeams(const glm::ivec3& begin, const glm::ivec3& end, const BlockArrays& block, Tally& tally, const Stopped& stopped) const;
  void countOverlap(const std::vector<std::size_t>& reaching, const glm::ivec3& begin, const glm::ivec3& end, Tally& tally) const;
  [[nodiscard]] std::vector<Weights> weightsOf(const std::vector<std::size_t>& reaching, const CellBox& cells) const;

  std::span<const View> views_;
  const SeamMap* seams_;
  const Grid& result_;
  const JoinOptions& options_;
  glm::ivec3 ratio_{1};
  glm::dvec3 blend_cells_{0.0};
  std::vector<ViewSampler> samplers_;
};

}  // namespace ew::stitching
