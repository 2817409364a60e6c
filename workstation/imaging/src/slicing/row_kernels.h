#pragma once

#include <array>
#include <cstdint>

#include "ew/imaging/knobs.h"
#include "template_line.h"

namespace ew::detail {

/// Samples of a row that are laid, announced and sampled together. 256 hold the memory busy from their announcement to their sampling: 64
/// take half as long again on volumes beyond the cache. Offsets count from `voxels`, which lies at the piece's lowest corner, so that 32
/// bits do for volumes of any size.
struct Piece {
  static constexpr int kMost = 256;
  static constexpr std::uint64_t kCellsAtMost =
      6500;  ///< voxels along i that a piece spans in bricks, so that 16 bits do for their division
  using Values = std::array<std::uint32_t, kMost + kLanesAtMost>;

  int count = 0;
  std::uint8_t* out = nullptr;
  const std::uint8_t* voxels = nullptr;
  std::array<std::uint32_t, 3> startWhole{}, startFraction{};               ///< of the base, from the lowest corner
  std::array<const std::uint32_t*, 3> templateWhole{}, templateFraction{};  ///< of the piece's first sample
  const std::uint32_t* templateOffset = nullptr;                            ///< rows: dT of Eq. 1, modulo 2^32, as startOffset
  std::uint32_t startOffset = 0;
  std::array<std::uint64_t, 3> stride{};  ///< as in TemplateLine

  Values offset;               ///< of the voxel of Eq. 1 (weave, linear) or the first of four along each axis (cubic)
  Values toRow, toSlice;       ///< bricks, not weave: bytes from there to the same place in the next row and slice
  std::array<Values, 3> part;  ///< not weave: the fraction of base plus template, kPartBits of it, in both halves of 32 bits
};

/// Pairs of voxels loaded for a few samples: what stands between the memory and the arithmetic.
struct Loaded {
  static constexpr int kMost = 64;
  std::uint16_t pairs[4][kMost + kLanesAtMost];  ///< neighbours along i, the rows named by their steps along j and k: 00, 10, 01, 11
};

/// Asks for the line of a byte that is read later; a hint without effect on any value. Into the second-level cache, which keeps far more
/// requests under way than the first: half the time of a slice against a request into the first (measured on 256 and 512 cubed, volumes i
/// fastest). Always inlined: GCC 12 takes a function that only prefetches for one without effect, and drops its calls.
#if defined(__GNUC__)
#define EW_REQUESTS [[gnu::always_inline]] inline
EW_REQUESTS void prefetch(const std::uint8_t* at) { __builtin_prefetch(at, 0, 2); }
#else
#define EW_REQUESTS inline
EW_REQUESTS void prefetch(const std::uint8_t*) {}
#endif

struct PieceKind {
  Quality quality = Quality::linear;
  VoxelLayout layout = VoxelLayout::linear;
};

/// Eq. 1 with the carry, a vector of samples at a time; compiled for each instruction set and chosen at run time. Arithmetic is in
/// integers, so every instruction set gives the same pixels.
void layPiece(PieceKind kind, Piece& piece);
/// Samples a piece, and asks the memory for what a later one will read (`ahead`; null: nothing). An empty piece only asks. Linear: three
/// times a + (b - a) x in numbers of 16 bits, 7 of them below a grey level, so that a pixel lies within 0.5 + 3 (255 / 2^16 + 2^-8) = 0.524
/// grey levels of exact arithmetic.
void samplePiece(PieceKind kind, const Piece& piece, const Piece* ahead);

/// Requests for what a piece reads; hints without effect on any value. A request that finds its line costs as little as a load, so every
/// sample makes its own.
class Announcer {
 public:
  Announcer(PieceKind kind, const Piece* piece) : onlyNearest_(kind.quality == Quality::weave) {
    if (piece == nullptr) return;
    count_ = piece->count;
    offset_ = piece->offset.data();
    // The corners of what a sample reads: what lies between them was a corner of samples before. In bricks the corner may be the same
    // again.
    const bool cubic = kind.quality == Quality::cubic, bricked = kind.layout == VoxelLayout::bricked;
    const std::uint64_t steps = bricked ? (cubic ? 2 : 1) : (cubic ? 3 : 1);
    const std::uint8_t *first = piece->voxels, *above = first + steps * piece->stride[2];
    corner_ = {first, first + steps * piece->stride[1], above, above + steps * piece->stride[1]};
  }
  [[nodiscard]] int count() const { return count_; }
  EW_REQUESTS void ask(int n) const {
    for (const std::uint8_t* corner : corner_) prefetch(corner + offset_[n]);
  }
  /// What samples n and following read.
  EW_REQUESTS void askFrom(int n) const {
    if (onlyNearest_) {
      const std::uint8_t* const first = corner_[0];
      const std::uint32_t* const offset = offset_;
#pragma GCC unroll 8
      for (const int count = count_; n < count; ++n) prefetch(first + offset[n]);
      return;
    }
    for (; n < count_; ++n) ask(n);
  }

 private:
  bool onlyNearest_;
  int count_ = 0;
  const std::uint32_t* offset_ = nullptr;
  std::array<const std::uint8_t*, 4> corner_{};
};

/// samplePiece of Quality::cubic: weights of 14 bits, which add less than 0.1 grey levels to the rounding on noise.
void sampleCubicPiece(VoxelLayout layout, const Piece& piece, const Announcer& next);

/// Levels between `count` <= Loaded::kMost times eight neighbours, not rounded, of those alone that are covered: at least one of each eight
/// that weighs anything. Reads and writes up to kLanesAtMost beyond the last.
/// @param coverage values of Coverage, loaded like the echoes; null: all covered
void blendLoadedLevels(const Loaded& echo, const Loaded* coverage, const std::array<const std::uint32_t*, 3>& fraction, int count,
                       float* out);

/// T_n = round(n * step) for n = 0 .. count - 1, step = (high * 2^16 + low) / 2^47 voxels.
void fillTemplate(std::int64_t high, std::int32_t low, int count, std::uint32_t* whole, std::uint32_t* fraction);

/// dT of Eq. 1 in voxels that lie row after row, modulo 2^32.
void fillOffsets(const std::array<const std::uint32_t*, 3>& whole, const std::array<std::uint64_t, 3>& stride, int count,
                 std::uint32_t* offset);

}  // namespace ew::detail
