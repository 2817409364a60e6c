#pragma once

#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/tissue_motion.h"

namespace ew {

/// What a colour box remembers of the frame before: its sums for persistence, and where probe and body stood, since what they move shows.
struct ColourMemory {
  int lines = 0, gates = 0;
  std::vector<float> sums;  ///< by gate and line three numbers: R0, and R1's real and imaginary part; empty: persistence starts afresh
  bool hasBefore = false;   ///< the frame before is known
  Pose pose;
  BodyState body;
  double time_s = 0.0;
};

}  // namespace ew
