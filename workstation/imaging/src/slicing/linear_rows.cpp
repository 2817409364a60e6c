#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "piece_pipeline.h"

namespace ew::detail {
namespace {

constexpr float kPerFraction = 1.0F / static_cast<float>(kOneVoxel);

float blend(float a, float b, float weight) { return a + weight * (b - a); }

/// Two neighbours along i, the first in the low byte.
std::uint16_t pairAt(const std::uint8_t* at) {
  std::uint16_t pair = 0;
  std::memcpy(&pair, at, sizeof pair);
  if constexpr (std::endian::native == std::endian::big) pair = static_cast<std::uint16_t>((pair << 8) | (pair >> 8));
  return pair;
}

/// Samples whose eight voxels all exist: no bounds are looked at.
template <class Offset>
struct Trilinear {
  static constexpr bool kBlends = true;
  static void announce(const TemplateLine& line, const Piece<Offset>& piece) {
    for (std::size_t n = 0; n < piece.count; ++n) {
      const std::uint8_t* at = line.voxels + piece.offset[n];
      prefetch(at);
      prefetch(at + line.stride[1]);
      prefetch(at + line.stride[2]);
      prefetch(at + line.stride[1] + line.stride[2]);
    }
  }

  static void sample(const TemplateLine& line, const Piece<Offset>& piece) {
    // Loads apart from arithmetic, in parts that stay in the first-level cache: the arithmetic is then vector code.
    constexpr std::size_t kPart = 64;
    std::array<std::uint16_t, kPart> pair00, pair10, pair01, pair11;  // named by their steps along j and k
    for (std::size_t begin = 0; begin < piece.count; begin += kPart) {
      const std::size_t count = std::min(kPart, piece.count - begin);
      const Offset* offset = piece.offset.data() + begin;
      for (std::size_t n = 0; n < count; ++n) {
        const std::uint8_t* at = line.voxels + offset[n];
        pair00[n] = pairAt(at);
        pair10[n] = pairAt(at + line.stride[1]);
        pair01[n] = pairAt(at + line.stride[2]);
        pair11[n] = pairAt(at + line.stride[1] + line.stride[2]);
      }
      const std::uint32_t* sumI = piece.positionSum[0].data() + begin;
      const std::uint32_t* sumJ = piece.positionSum[1].data() + begin;
      const std::uint32_t* sumK = piece.positionSum[2].data() + begin;
      std::uint8_t* out = piece.out + begin;
      for (std::size_t n = 0; n < count; ++n) {
        const float weightI = weightOf(sumI[n]), weightJ = weightOf(sumJ[n]), weightK = weightOf(sumK[n]);
        const auto alongI = [&](std::uint16_t pair) {
          return blend(static_cast<float>(pair & 0xff), static_cast<float>(pair >> 8), weightI);
        };
        const float near = blend(alongI(pair00[n]), alongI(pair10[n]), weightJ);
        const float far = blend(alongI(pair01[n]), alongI(pair11[n]), weightJ);
        out[n] = static_cast<std::uint8_t>(static_cast<std::int32_t>(blend(near, far, weightK) + 0.5F));
      }
    }
  }

 private:
  static float weightOf(std::uint32_t sum) { return static_cast<float>(static_cast<std::int32_t>(sum & kFractionMask)) * kPerFraction; }
};

/// Samples within half a voxel of the volume's faces, and every sample of a volume that is one voxel thin: the position is clamped to
/// the outermost voxel centres, and the neighbour index to the volume.
void borderRun(const TemplateLine& line, const SliceScratch& scratch, const FixedPosition& base, RowSpan run, std::uint8_t* row) {
  for (int x = run.begin; x < run.end; ++x) {
    std::array<float, 3> weight{};
    std::array<std::uint64_t, 3> step{};
    std::uint64_t offset = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t last = static_cast<std::int64_t>(line.dims[static_cast<int>(a)] - 1) * kOneVoxel;
      const std::int64_t position = std::clamp(base[a] + scratch.templatePosition[a][static_cast<std::size_t>(x)], std::int64_t{0}, last);
      offset += static_cast<std::uint64_t>(position >> kFractionBits) * line.stride[a];
      weight[a] = static_cast<float>(position & static_cast<std::int64_t>(kFractionMask)) * kPerFraction;
      step[a] = position == last ? 0 : line.stride[a];
    }
    const std::uint8_t* at = line.voxels + offset;
    const auto alongI = [&](const std::uint8_t* from) {
      return blend(static_cast<float>(from[0]), static_cast<float>(from[step[0]]), weight[0]);
    };
    const float near = blend(alongI(at), alongI(at + step[1]), weight[1]);
    const float far = blend(alongI(at + step[2]), alongI(at + step[1] + step[2]), weight[1]);
    row[x] = static_cast<std::uint8_t>(static_cast<std::int32_t>(blend(near, far, weight[2]) + 0.5F));
  }
}

template <class Offset>
void linearRows(const TemplateLine& line, const SliceScratch& scratch, const std::vector<Offset>& templateOffset, int firstRow,
                const Clipping& clipping, ImageView<std::uint8_t> out) {
  FixedPosition outermost{}, interiorEnd{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t voxels = line.dims[static_cast<int>(a)];
    outermost[a] = voxels * kOneVoxel - kHalfVoxel;
    interiorEnd[a] = (voxels - 1) * kOneVoxel - 1;
  }
  PiecePipeline<Offset, Trilinear<Offset>> pipeline(line, scratch, templateOffset);
  for (int y = 0; y < out.height; ++y) {
    const FixedPosition base = line.base(firstRow + y);
    std::uint8_t* row = out.row(y);
    for (const RowSpan& within : clipping.of(y)) {
      RowSpan run = clipRow(line, scratch, base, within, {-kHalfVoxel, -kHalfVoxel, -kHalfVoxel}, outermost);
      if (run.begin == run.end) run = {within.begin, within.begin};
      RowSpan interior = clipRow(line, scratch, base, run, {0, 0, 0}, interiorEnd);
      if (interior.begin == interior.end) interior = {run.begin, run.begin};
      std::fill(row + within.begin, row + run.begin, std::uint8_t{0});
      borderRun(line, scratch, base, {run.begin, interior.begin}, row);
      pipeline.push(base, interior, row);
      borderRun(line, scratch, base, {interior.end, run.end}, row);
      std::fill(row + run.end, row + within.end, std::uint8_t{0});
    }
  }
  pipeline.finish();
}

}  // namespace

void linearRows(const TemplateLine& line, const SliceScratch& scratch, int firstRow, const Clipping& clipping,
                ImageView<std::uint8_t> out) {
  if (line.needsLongOffsets)
    linearRows(line, scratch, scratch.longTemplateOffset, firstRow, clipping, out);
  else
    linearRows(line, scratch, scratch.templateOffset, firstRow, clipping, out);
}

}  // namespace ew::detail
