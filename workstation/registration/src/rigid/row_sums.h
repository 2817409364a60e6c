#pragma once

#include <cstddef>
#include <cstdint>

namespace ew::registration {

/// A stretch of one row of fixed voxels and where its mates lie. Private to the passes over pairs.
struct PoseRow {
  const float* fixedValue = nullptr;          ///< of voxel i = 0 of the row
  const std::uint8_t* fixedWeight = nullptr;  ///< likewise; > 0 only where all neighbours exist
  int fixedRow = 0;                           ///< floats to the next row and plane
  int fixedPlane = 0;
  std::ptrdiff_t room = 0;  ///< voxels of the image from i = 0 of the row on
  int begin = 0;
  int end = 0;
  const float* moving = nullptr;  ///< packed
  int movingDims[3]{};
  float at[3]{};          ///< moving voxel of i = 0
  float step[3]{};        ///< per fixed voxel
  float turn[9]{};        ///< fixed axis a takes turn[3 a + b] of the moving derivative along b
  float perLoss2 = 0.0F;  ///< 1 / lossScale^2
  float middle = 0.0F;    ///< powers of (i - middle) * perMiddle
  float perMiddle = 1.0F;
  bool derivatives = true;
};

/// What is summed over a stretch of a row as over a whole pair.
struct PairSums {
  double count = 0.0;   ///< fixed voxels whose mate is covered
  double weight = 0.0;  ///< of confidence, without the robust loss
  double f = 0.0;       ///< weighted sums of fixed and moving values and their products
  double m = 0.0;
  double ff = 0.0;
  double mm = 0.0;
  double fm = 0.0;
  double residual = 0.0;  ///< of squared residuals, with the robust weights
  double robustWeight = 0.0;
  double bothGradients = 0.0;  ///< of fixed times moving gradients, and of the squares of each, with the robust weights
  double fixedGradient = 0.0;
  double movingGradient = 0.0;

  void add(const PairSums& other);
};

/// Sums over the stretch: those of a pair (from `residual` on with derivatives alone), then gradient moments for powers 0, 1, 2 of the
/// place along the row (xx xy xz yy yz zz), then gradient times residual for powers 0 and 1.
struct PoseRowSums : PairSums {
  double moment[3][6]{};
  double right[2][3]{};
};

void sumPoseRow(const PoseRow& job, PoseRowSums& sums);

}  // namespace ew::registration
