#pragma once

#include <cstdint>
#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/display.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"
#include "ew/imaging/tissue_motion.h"

namespace ew {

/// Everything that decides one image of a subject but the images before it (persistence and M-mode remember those): the same subject,
/// state and history give the same pixels, on every machine and with every number of threads.
struct ScanState {
  Probe probe;
  Knobs knobs;
  Pan pan;                          ///< which part of the fan a zoomed image shows
  Scene scene;                      ///< effects that run
  Pose pose;                        ///< probe in the world
  std::vector<float> gaps_mm = {};  ///< skin to face, from the face's -x end to its +x end; empty: everything touches
  double time_s = 0.0;              ///< on the scan's clock
  std::uint64_t number = 0;         ///< of the image: decides its noise
  BodyState body = {};              ///< where breath, pulse and bowel stand; at rest where nobody says
  bool operator==(const ScanState&) const = default;
};

}  // namespace ew
