#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "ew/core/frames.h"

namespace ew {

/// Whether a pose may be used. It is never encoded in the matrix: trackers report loss with identity, zeros or the last good pose.
enum class PoseStatus { ok, invalid, missing };

/// Where the probe is, and whether and when that was known.
struct Pose {
  Transform<frame::World, frame::Probe> probeToWorld;
  PoseStatus status = PoseStatus::ok;
  double time_s = 0.0;
  bool operator==(const Pose&) const = default;
};

/// Poses from text: 16 numbers a line (row major, probe to world, mm, LPS), blank lines and lines starting with # skipped.
/// @error badField with the line and what is wrong with it; notRigid when checkRigid refuses one
[[nodiscard]] Result<std::vector<Pose>> parsePoses(std::string_view text);

/// The `--pose` argument: 16 numbers, or the name of a file (up to 64 MiB) with one pose a line.
[[nodiscard]] Result<std::vector<Pose>> posesFromArgument(const std::string& argument);

}  // namespace ew
