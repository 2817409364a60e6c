#pragma once

#include <cstddef>
#include <vector>

#include "ew/acquisition/gating.h"
#include "ew/acquisition/import.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

enum class GateBy {
  automatic,  ///< the recording's ECG; where it has none or it cannot gate, its respiration; else the images
  ecg,
  respiration,
  images
};

struct GateOptions {
  GateBy by = GateBy::automatic;
  Rhythm rhythm = Rhythm::heart;  ///< what to look for in images
  int threads = 0;                ///< 0: all cores; the result does not depend on it
};

/// The phases of a sweep's frames.
struct SweepGate {
  GateBy by = GateBy::automatic;  ///< what was used
  Cycles cycles;
  std::vector<FramePhase> frames;  ///< of the frames with a pose, in the order of posedFrames
  std::size_t accepted = 0;
  std::size_t outside = 0;  ///< before the first or after the last full cycle
  std::size_t irregular = 0;
  std::vector<Message> notes;  ///< why a signal was passed over, and what the cycles say
};

/// Finds the cycles of a recording, all of its frames used, and the phases of those with a pose.
/// @error as recordedSignal, findHeartBeats, findBreaths or findCyclesInImages of the signal asked for; of the images with automatic
[[nodiscard]] Result<SweepGate> gateSweep(const SweepInput& opened, const GateOptions& options, Progress& progress);

/// Reconstructs one volume per phase, all on the plan's grid, and hands each to `keep`.
/// @error as framesOfPhase and reconstructPhases; tooLarge when the plan does not fit
[[nodiscard]] Result<Grid> importPhases(const SweepInput& opened, const SweepGate& gate, int phases, const KeepPhase& keep,
                                        Progress& progress);

}  // namespace ew
