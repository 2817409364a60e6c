#pragma once

#include <cstdint>

#include "ew/assessment/compass.h"

namespace ew {

/// A hand as clumsy as people's, that does what it is told and nothing else.
struct SimulatedHand {
  double reactionTime_s = 0.3;  ///< between an advice and the hand that follows it
  double fastestSlide_mmPerS = 40.0;
  double fastestTurn_degPerS = 30.0;
  double executionError = 0.1;  ///< standard deviation of the share by which each movement goes too far or not far enough
  double tremor_mm = 0.3;       ///< standard deviation about where the hand means to be, along either direction of the skin
  double tremor_deg = 0.5;      ///< the same of each angle
  double step_s = 0.05;         ///< between two looks at the compass
  double stillFor_s = 0.5;      ///< that the plane has to be held to count as reached
  double patience_s = 180.0;    ///< then the hand gives up
};

struct HandRun {
  bool reached = false;     ///< held within tolerance, the marker the right way
  double time_s = 0.0;      ///< until it was, or until the hand gave up
  int changesOfAdvice = 0;  ///< how often another movement, or another direction of it, was advised
  PlaneError error;         ///< at the end
  Hold end;
};

/// Follows nextMovement's advice alone: neither the target nor an error is seen. The same for the same seed.
[[nodiscard]] HandRun followCompass(const CompassTarget& target, const Hold& start, const Skin& skin, std::uint64_t seed,
                                    const SimulatedHand& hand = {});

}  // namespace ew
