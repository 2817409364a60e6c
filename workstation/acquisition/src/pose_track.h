#pragma once

#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <vector>

#include "ew/acquisition/temporal_offset.h"

namespace ew {

/// Poses over time. Between two, a given point of what moves goes along a line, and what moves turns by the shortest way (slerp); never
/// across a pose that is not there, nor between poses further apart than `longestGap_s`, nor beyond the ends.
class PoseTrack {
 public:
  /// @param time_s  one per pose, not running backwards; of equal times the first counts
  /// @param centre  the point whose way is a line, in what moves
  PoseTrack(std::span<const double> time_s, const FramePoses& poses, const glm::dvec2& centre, double longestGap_s);

  /// A time that is one of the given ones has its pose unchanged.
  [[nodiscard]] std::optional<Transform<frame::World, frame::Image>> at(double t_s) const;

 private:
  glm::dvec3 centre_;
  std::vector<double> time_s_;
  FramePoses poses_;
  std::vector<std::optional<glm::dquat>> turns_;  ///< from pose n to n + 1, where one may go between them
};

/// The longest gap that poses are read across: as asked for, else three times the median of the steps in time.
[[nodiscard]] double longestGapOf(double asked_s, std::span<const double> time_s);

}  // namespace ew
