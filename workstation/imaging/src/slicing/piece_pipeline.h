#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "template_line.h"

namespace ew::detail {

/// Pixels of a row that are laid, announced and sampled together. 256 pixels hold the memory busy from their announcement to their
/// sampling: 64 take half as long again on volumes beyond the cache.
template <class Offset>
struct Piece {
  static constexpr std::size_t kMost = 256;
  std::size_t count = 0;
  std::uint8_t* out = nullptr;
  std::array<Offset, kMost> offset;                             ///< of the voxel of Eq. 1 from the volume's first
  std::array<std::array<std::uint32_t, kMost>, 3> positionSum;  ///< fractions of base plus template; the top bit is the carry
};

/// Asks the memory for a byte that is read one piece later; a hint without effect on any value. Into the second-level cache, which
/// keeps far more requests under way than the first: half the time of a slice against a request into the first (measured on 256 and 512
/// cubed).
inline void prefetch(const std::uint8_t* at) {
#if defined(__GNUC__)
  __builtin_prefetch(at, 0, 2);
#else
  static_cast<void>(at);
#endif
}

/// Runs the pieces of a slice through three plain loops: lay the offsets of a piece (Eq. 1 with the carry; consecutive values, so the
/// compiler makes it vector code), announce its voxels, and only after the next piece has been announced too, sample it. The pipeline
/// goes on over the ends of rows, so that the memory never idles between them.
/// Sampler: static constexpr bool kBlends; static void announce(line, piece); static void sample(line, piece).
template <class Offset, class Sampler>
class PiecePipeline {
 public:
  PiecePipeline(const TemplateLine& line, const SliceScratch& scratch, const std::vector<Offset>& templateOffset)
      : line_(line), scratch_(scratch), templateOffset_(templateOffset.data()) {}

  /// Pixels run.begin .. run.end - 1 of the row that begins at `base`, whose voxels all lie within the volume. `row` must stay until
  /// finish().
  void push(const FixedPosition& base, RowSpan run, std::uint8_t* row) {
    constexpr int kMost = static_cast<int>(Piece<Offset>::kMost);
    for (int x = run.begin; x < run.end; x += kMost) {
      lay(base, x, std::min(kMost, run.end - x));
      next_->out = row + x;
      Sampler::announce(line_, *next_);
      Sampler::sample(line_, *now_);
      std::swap(now_, next_);
    }
  }

  void finish() {
    Sampler::sample(line_, *now_);
    now_->count = 0;
  }

 private:
  void lay(const FixedPosition& base, int x, int count) {
    std::uint64_t baseOffset = 0;
    std::array<std::uint32_t, 3> baseFraction{};
    for (std::size_t a = 0; a < 3; ++a) {
      baseOffset += static_cast<std::uint64_t>(base[a] >> kFractionBits) * line_.stride[a];
      baseFraction[a] = static_cast<std::uint32_t>(static_cast<std::uint64_t>(base[a]) & kFractionMask);
    }
    const auto start = static_cast<Offset>(baseOffset);
    const auto strideI = static_cast<Offset>(line_.stride[0]);
    const auto strideJ = static_cast<Offset>(line_.stride[1]);
    const auto strideK = static_cast<Offset>(line_.stride[2]);
    const auto [baseI, baseJ, baseK] = baseFraction;
    const Offset* dT = templateOffset_ + x;
    const std::int32_t* fractionI = scratch_.templateFraction[0].data() + x;
    const std::int32_t* fractionJ = scratch_.templateFraction[1].data() + x;
    const std::int32_t* fractionK = scratch_.templateFraction[2].data() + x;
    Piece<Offset>& piece = *next_;
    piece.count = static_cast<std::size_t>(count);
    for (std::size_t n = 0; n < piece.count; ++n) {
      // The top bit of a sum of two 31 bit fractions says that they reach a whole voxel.
      const std::uint32_t sumI = static_cast<std::uint32_t>(fractionI[n]) + baseI;
      const std::uint32_t sumJ = static_cast<std::uint32_t>(fractionJ[n]) + baseJ;
      const std::uint32_t sumK = static_cast<std::uint32_t>(fractionK[n]) + baseK;
      const Offset carryI = static_cast<Offset>(0) - (sumI >> kFractionBits);
      const Offset carryJ = static_cast<Offset>(0) - (sumJ >> kFractionBits);
      const Offset carryK = static_cast<Offset>(0) - (sumK >> kFractionBits);
      piece.offset[n] = start + dT[n] + (carryI & strideI) + (carryJ & strideJ) + (carryK & strideK);
      if constexpr (Sampler::kBlends) {
        piece.positionSum[0][n] = sumI;
        piece.positionSum[1][n] = sumJ;
        piece.positionSum[2][n] = sumK;
      }
    }
  }

  const TemplateLine& line_;
  const SliceScratch& scratch_;
  const Offset* templateOffset_;
  std::array<Piece<Offset>, 2> pieces_;
  Piece<Offset>* now_ = &pieces_[0];
  Piece<Offset>* next_ = &pieces_[1];
};

}  // namespace ew::detail
