#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/probe.h"
#include "ew/tracking/hand.h"

namespace ew {

/// The distance from a skin on a grid of 2 mm, worked out block by block where it is first asked for: for thousands of scans over the same
/// skin, of which Skin::nearest alone would take nearly all the time. Between nodes it is linear; over a body that is h^2 / 8 by the least
/// radius, 0.02 mm at 25 mm. Reading is safe from several threads, and does not depend on who asked first.
class SkinDistance {
 public:
  explicit SkinDistance(std::shared_ptr<const Skin> skin) : skin_(std::move(skin)) {}
  /// Above 0 outside, as gapsToSkin_mm measures it.
  [[nodiscard]] double at_mm(const glm::dvec3& p_mm) const;
  /// gapsToSkin_mm off the grid.
  [[nodiscard]] std::vector<float> gaps_mm(const Probe& probe, const Pose& pose) const;

 private:
  static constexpr int kCells = 8;  ///< along an edge of a block
  static constexpr std::size_t kNodes = kCells + 1;
  static constexpr double kNode_mm = 2.0;
  using Block = std::array<float, kNodes * kNodes * kNodes>;
  [[nodiscard]] const Block& blockOf(const glm::ivec3& place) const;

  std::shared_ptr<const Skin> skin_;
  mutable std::shared_mutex guard_;
  mutable std::unordered_map<std::uint64_t, std::unique_ptr<const Block>> blocks_;
};

}  // namespace ew
