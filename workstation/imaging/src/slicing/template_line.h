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

/// Voxel coordinates as fixed point numbers along i, j, k.
using FixedPosition = std::array<std::int64_t, 3>;

/// The template line of a plane, prepared in `scratch` for `width` pixels, and what a row needs to place it.
struct TemplateLine {
  const std::uint8_t* voxels = nullptr;
  glm::ivec3 dims{0};
  std::array<std::uint64_t, 3> stride{};  ///< of i, j, k; 0 along an axis of one voxel
  glm::dvec3 origin_voxel{0.0};           ///< of pixel (0, 0)
  glm::dvec3 acrossRows_voxel{0.0};       ///< from a row to the next
  glm::dvec3 alongRow_voxel{0.0};         ///< from a pixel to the next
  bool needsLongOffsets = false;
  bool empty = true;  ///< nothing can be sampled: no voxels, or a matrix out of range

  /// Position of pixel 0 of row y.
  [[nodiscard]] FixedPosition base(int y) const;
};

TemplateLine layTemplate(const SliceSource& source, const glm::dvec3& origin_voxel, const glm::dvec3& alongRow_voxel,
                         const glm::dvec3& acrossRows_voxel, int width, int height, SliceScratch& scratch);

/// The pixels of `within` whose position along every axis lies in [lowest, highest]; positions along a row are monotone, so they are
/// one run.
RowSpan clipRow(const TemplateLine& line, const SliceScratch& scratch, const FixedPosition& base, RowSpan within,
                const FixedPosition& lowest, const FixedPosition& highest);

/// The spans of row y, or the whole row when no spans were given.
struct Clipping {
  std::span<const std::vector<RowSpan>> spans;
  RowSpan wholeRow;
  [[nodiscard]] std::span<const RowSpan> of(int y) const {
    if (spans.empty()) return {&wholeRow, 1};
    return spans[static_cast<std::size_t>(y)];
  }
};

/// Samples out.height rows from row `firstRow` of the plane on, within the spans of `clipping`; writes 0 where a row is outside the volume.
void weaveRows(const TemplateLine& line, const SliceScratch& scratch, int firstRow, const Clipping& clipping, ImageView<std::uint8_t> out);
void linearRows(const TemplateLine& line, const SliceScratch& scratch, int firstRow, const Clipping& clipping, ImageView<std::uint8_t> out);
void cubicRows(const TemplateLine& line, const SliceScratch& scratch, int firstRow, const Clipping& clipping, ImageView<std::uint8_t> out);

}  // namespace ew::detail
