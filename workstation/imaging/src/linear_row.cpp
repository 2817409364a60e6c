#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "template_line.h"

namespace ew::detail {
namespace {

constexpr int kPiece = 64;
constexpr float kPerFraction = 1.0F / static_cast<float>(kOneVoxel);

float blend(float a, float b, float weight) { return a + weight * (b - a); }

/// Two neighbours along i, the first in the low byte.
std::uint16_t pairAt(const std::uint8_t* at) {
  std::uint16_t pair = 0;
  std::memcpy(&pair, at, sizeof pair);
  if constexpr (std::endian::native == std::endian::big) pair = static_cast<std::uint16_t>((pair << 8) | (pair >> 8));
  return pair;
}

/// Samples whose eight voxels all exist: no bounds are looked at. The same three steps as the weave (offsets, loads, arithmetic), each a
/// plain loop over a piece of the row, so that the first and the last become vector code.
template <class Offset>
void interiorRun(const TemplateLine& line, const SliceScratch& scratch, const Offset* templateOffset, const FixedPosition& base,
                 RowSpan run, std::uint8_t* row) {
  std::uint64_t baseOffset = 0;
  std::array<std::uint32_t, 3> baseFraction{};
  for (std::size_t a = 0; a < 3; ++a) {
    baseOffset += static_cast<std::uint64_t>(base[a] >> kFractionBits) * line.stride[a];
    baseFraction[a] = static_cast<std::uint32_t>(static_cast<std::uint64_t>(base[a]) & kFractionMask);
  }
  const auto start = static_cast<Offset>(baseOffset);
  const auto strideI = static_cast<Offset>(line.stride[0]);
  const auto strideJ = static_cast<Offset>(line.stride[1]);
  const auto strideK = static_cast<Offset>(line.stride[2]);
  const auto [baseI, baseJ, baseK] = baseFraction;
  std::array<Offset, kPiece> offset;
  std::array<float, kPiece> weightI, weightJ, weightK;
  std::array<std::uint16_t, kPiece> pair00, pair10, pair01, pair11;  // named by their steps along j and k
  for (int x = run.begin; x < run.end; x += kPiece) {
    const auto count = static_cast<std::size_t>(std::min(kPiece, run.end - x));
    const Offset* dT = templateOffset + x;
    const std::int32_t* fractionI = scratch.templateFraction[0].data() + x;
    const std::int32_t* fractionJ = scratch.templateFraction[1].data() + x;
    const std::int32_t* fractionK = scratch.templateFraction[2].data() + x;
    for (std::size_t n = 0; n < count; ++n) {
      const std::uint32_t sumI = static_cast<std::uint32_t>(fractionI[n]) + baseI;
      const std::uint32_t sumJ = static_cast<std::uint32_t>(fractionJ[n]) + baseJ;
      const std::uint32_t sumK = static_cast<std::uint32_t>(fractionK[n]) + baseK;
      const Offset carryI = static_cast<Offset>(0) - (sumI >> kFractionBits);
      const Offset carryJ = static_cast<Offset>(0) - (sumJ >> kFractionBits);
      const Offset carryK = static_cast<Offset>(0) - (sumK >> kFractionBits);
      offset[n] = start + dT[n] + (carryI & strideI) + (carryJ & strideJ) + (carryK & strideK);
      weightI[n] = static_cast<float>(static_cast<std::int32_t>(sumI & kFractionMask)) * kPerFraction;
      weightJ[n] = static_cast<float>(static_cast<std::int32_t>(sumJ & kFractionMask)) * kPerFraction;
      weightK[n] = static_cast<float>(static_cast<std::int32_t>(sumK & kFractionMask)) * kPerFraction;
    }
    // As in the weave: every line is announced before the first load.
    for (std::size_t n = 0; n < count; ++n) {
      const std::uint8_t* at = line.voxels + offset[n];
      prefetch(at);
      prefetch(at + line.stride[1]);
      prefetch(at + line.stride[2]);
      prefetch(at + line.stride[1] + line.stride[2]);
    }
    for (std::size_t n = 0; n < count; ++n) {
      const std::uint8_t* at = line.voxels + offset[n];
      pair00[n] = pairAt(at);
      pair10[n] = pairAt(at + line.stride[1]);
      pair01[n] = pairAt(at + line.stride[2]);
      pair11[n] = pairAt(at + line.stride[1] + line.stride[2]);
    }
    std::uint8_t* out = row + x;
    const auto alongI = [&](std::uint16_t pair, std::size_t n) {
      return blend(static_cast<float>(pair & 0xff), static_cast<float>(pair >> 8), weightI[n]);
    };
    for (std::size_t n = 0; n < count; ++n) {
      const float near = blend(alongI(pair00[n], n), alongI(pair10[n], n), weightJ[n]);
      const float far = blend(alongI(pair01[n], n), alongI(pair11[n], n), weightJ[n]);
      out[n] = static_cast<std::uint8_t>(static_cast<std::int32_t>(blend(near, far, weightK[n]) + 0.5F));
    }
  }
}

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

}  // namespace

void linearRow(const TemplateLine& line, const SliceScratch& scratch, int y, RowSpan within, std::uint8_t* row) {
  const FixedPosition base = line.base(y);
  FixedPosition outermost{}, interiorEnd{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t voxels = line.dims[static_cast<int>(a)];
    outermost[a] = voxels * kOneVoxel - kHalfVoxel;
    interiorEnd[a] = (voxels - 1) * kOneVoxel - 1;
  }
  const RowSpan run = clipRow(line, scratch, base, within, {-kHalfVoxel, -kHalfVoxel, -kHalfVoxel}, outermost);
  if (run.begin == run.end) {
    std::fill(row + within.begin, row + within.end, std::uint8_t{0});
    return;
  }
  RowSpan interior = clipRow(line, scratch, base, run, {0, 0, 0}, interiorEnd);
  if (interior.begin == interior.end) interior = {run.begin, run.begin};
  std::fill(row + within.begin, row + run.begin, std::uint8_t{0});
  borderRun(line, scratch, base, {run.begin, interior.begin}, row);
  if (line.needsLongOffsets)
    interiorRun(line, scratch, scratch.longTemplateOffset.data(), base, interior, row);
  else
    interiorRun(line, scratch, scratch.templateOffset.data(), base, interior, row);
  borderRun(line, scratch, base, {interior.end, run.end}, row);
  std::fill(row + run.end, row + within.end, std::uint8_t{0});
}

}  // namespace ew::detail
