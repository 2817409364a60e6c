#pragma once

#include <span>
#include <vector>

#include "ew/core/result.h"
#include "rigid_fit.h"

namespace ew {

struct TurnAndPlace {
  Eigen::Matrix3d turn;
  Eigen::Vector3d place;
};

/// @error noValidPose: fewer than 20 of them
[[nodiscard]] Result<std::vector<TurnAndPlace>> liveReadings(std::span<const ToolReading> readings);

}  // namespace ew
