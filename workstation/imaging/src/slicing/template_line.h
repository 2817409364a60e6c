#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "ew/imaging/slicing.h"

namespace ew::detail {

inline constexpr int kFractionBits = 31;
inline constexpr std::int64_t kOneVoxel = std::int64_t{1} << kFractionBits;
inline constexpr std::int64_t kHalfVoxel = kOneVoxel / 2;
inline constexpr std::uint32_t kFractionMask = 0x7fffffffU;
inline constexpr int kPartBits = 15;  ///< of the fractions that linear and cubic sampling weigh with
inline constexpr std::int64_t kHalfPart = std::int64_t{1} << (kFractionBits - kPartBits - 1);
inline constexpr float kPerFraction = 1.0F / static_cast<float>(kOneVoxel);

/// Samples that one template serves. A longer row begins afresh from its own position every kBlock samples, at the same columns whatever
/// part of the row is asked for, so that a pixel does not depend on the spans around it.
inline constexpr int kBlock = 512;
inline constexpr int kLanesAtMost = 64;

/// Voxel coordinates as fixed point numbers along i, j, k.
using FixedPosition = std::array<std::int64_t, 3>;

/// The template of rows that share a step: T_n = n * step of Eq. 1 for one block, its integer part and its fraction apart, and the voxels
/// it is laid over. Every entry is the rounded product, so nothing adds up along a row.
struct TemplateLine {
  const std::uint8_t* voxels = nullptr;
  glm::ivec3 dims{0};
  VoxelLayout layout = VoxelLayout::linear;
  std::array<std::uint64_t, 3> stride{};  ///< bytes from a voxel to the next, or from a brick to the next
  glm::dvec3 step_voxel{0.0};
  std::array<double, 3> samplesPerUnit{};  ///< 1 / step in fixed point units
  std::array<const std::uint32_t*, 3> whole{}, fraction{};
  const std::uint32_t* offset = nullptr;  ///< dT of Eq. 1 modulo 2^32; rows alone
  bool empty = true;                      ///< nothing can be sampled: no voxels, or a step out of range

  /// T_n along an axis.
  [[nodiscard]] std::int64_t at(std::size_t axis, int n) const {
    return static_cast<std::int64_t>(static_cast<std::int32_t>(whole[axis][n])) * kOneVoxel + fraction[axis][n];
  }
};

/// @param width samples of the longest row, for the check of its reach
TemplateLine layTemplate(const SliceSource& source, const glm::dvec3& step_voxel, int width, SliceScratch& scratch);

/// Whether a position is finite and within 2^30 voxels: then three such terms stay below 2^63 in fixed point.
bool isInRange(const glm::dvec3& p_voxel);
FixedPosition fixedPosition(const glm::dvec3& p_voxel);

}  // namespace ew::detail
