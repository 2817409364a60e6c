#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "../comparable.h"
#include "ew/core/progress.h"
#include "row_sums.h"

namespace ew::registration {

/// A moving image as the kernel reads it: values with the weight in the eight lowest bits of each.
struct KernelImage {
  Grid grid;
  std::vector<float> value;
};
[[nodiscard]] KernelImage packed(const ComparableImage& image);

/// What one pass over the overlap of a pair sums up. Rotations are about `centre` of the pass, in the fixed frame.
struct PoseSums : PairSums {
  std::array<double, 36> normal{};  ///< J J^T of the mean of both gradients
  std::array<double, 6> right{};    ///< J (fixed - moving)
  glm::dvec3 lowest{1e300};         ///< corners of the overlap in voxels of the fixed image
  glm::dvec3 highest{-1e300};

  void add(const PoseSums& other);
  [[nodiscard]] double correlation() const;
  [[nodiscard]] double residualRms() const;
  /// How much stiffer the normal equations are than the agreement they stand for: the mean of both gradients holds the speckle that the two
  /// sides do not share, which a shift cannot bring together. 1 where all is shared.
  [[nodiscard]] double stiffness() const;
};

struct PassOptions {
  double lossScale = 0.0;   ///< residual at which the robust weight is a half; 0: all weights 1
  int blockVoxels = 0;      ///< > 0: the overlap is cut into cubes of this side
  int half = -1;            ///< 0 or 1: only the cubes of one colour of the checkerboard
  bool perBlock = false;    ///< sums of each cube go to blockSums
  bool derivatives = true;  ///< false: only the sums of values
};

/// @param fixedToMoving rigid; centre in the fixed frame, mm
/// @param blockSums     one per cube, filled when perBlock
/// @return false when cancelled
bool sumOverPair(const ComparableImage& fixed, const KernelImage& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                 const glm::dvec3& centre_mm, const PassOptions& options, int threads, Progress& progress, PoseSums& sums,
                 std::vector<PoseSums>* blockSums = nullptr);

}  // namespace ew::registration
