#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/tissue_motion.h"

namespace ew {

/// Where probe and body stood in the frame before: what moved since is seen by every Doppler.
struct FrameBefore {
  bool isKnown = false;
  Pose pose;
  BodyState body;
  double time_s = 0.0;
};

/// What a colour box remembers of the frame before: its sums for persistence.
struct ColourMemory {
  int lines = 0, gates = 0;
  std::vector<float> sums;  ///< by gate and line three numbers: R0, and R1's real and imaginary part; empty: persistence starts afresh
};

/// What a sample volume remembers: its spectra, and where its scatterers are.
struct SpectrumMemory;
/// What it takes, about: its spectra and strip, and its scatterers.
[[nodiscard]] std::size_t bytesOf(const SpectrumMemory& memory);

}  // namespace ew
