#pragma once

#include <array>
#include <cstdint>

#include "row_kernels.h"
#include "template_line.h"

namespace ew::detail {

/// Samples rows one after another. Each row is clipped once; its pieces run through three loops: lay the offsets of a piece (Eq. 1 with
/// the carry), announce its voxels to the memory, and only when kAhead more pieces have been announced, sample it. This goes on over the
/// ends of rows, so that the memory never idles between them.
class RowSampler {
 public:
  explicit RowSampler(Quality quality) : quality_(quality) {}

  /// Columns within.begin .. within.end - 1 of the row whose column 0 lies at `start_voxel`; 0 outside the volume. Nothing else is
  /// written. `row` must stay until finish(); the row ends at most where layTemplate was told.
  void sample(const TemplateLine& line, const glm::dvec3& start_voxel, RowSpan within, std::uint8_t* row);
  void finish();

 private:
  void sampleBlock(const TemplateLine& line, const FixedPosition& base, RowSpan within, std::uint8_t* block);
  void borderRun(const TemplateLine& line, const FixedPosition& base, RowSpan run, std::uint8_t* block);
  void sampleBorder();
  void push(const TemplateLine& line, const FixedPosition& base, RowSpan run, std::uint8_t* block);

  Quality quality_;
  /// Pieces between announcing and sampling. In bricks a piece is sampled in about 0.1 us, which is less than the memory takes to answer.
  static constexpr std::size_t kAhead = 4;
  void sampleOldest(const Piece* ahead);

  std::array<Piece, kAhead + 1> pieces_;
  std::array<PieceKind, kAhead + 1> kinds_{};
  std::size_t next_ = 0;

  /// A sample near the volume's faces: offsets of its neighbours along each axis, clamped.
  struct BorderSample {
    const std::uint8_t* voxels;
    std::uint8_t* out;
    std::array<std::array<std::uint64_t, 4>, 3> offset;  ///< linear uses two
  };
  struct Border {
    static constexpr int kMost = 64;
    std::array<BorderSample, kMost> samples;
    Piece piece;  ///< where the parts of its samples are kept
  };
  Border border_;
};

}  // namespace ew::detail
