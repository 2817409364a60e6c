#pragma once

namespace ew {

/// What the vector code of reverberate() needs; the arrays have one entry a line.
struct ReverberationLines {
  const int* interfaces = nullptr;  ///< sample of the interface, -1: none
  const int* ends = nullptr;        ///< last sample of its echo
  const int* bounces = nullptr;     ///< how often it comes back from the face: 0 where it is tilted
  int firstSample = 1;
  bool mirror = true;
  float bounceLoss = 0.0F;  ///< grey levels
  float mirrorLoss = 0.0F;
  float perDoubling = 0.0F;
};

}  // namespace ew
