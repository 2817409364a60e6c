#include "row_sampler.h"

#include <algorithm>

#include "bricks.h"

namespace ew::detail {
namespace {

/// First n of [begin, end) with reached(n), which is false up to some n and true from there on; `guess` is near it.
template <class Reached>
int firstWhere(int begin, int end, double guess, Reached reached) {
  int n = begin;
  if (guess > static_cast<double>(begin)) n = guess < static_cast<double>(end) ? static_cast<int>(guess) : end;
  while (n < end && !reached(n)) ++n;
  while (n > begin && reached(n - 1)) --n;
  return n;
}

/// The samples of `within` whose position along every axis lies in [lowest, highest]. Positions along a block are monotone, so they are
/// one run; an empty one begins and ends at within.begin.
RowSpan clip(const TemplateLine& line, const FixedPosition& base, RowSpan within, const FixedPosition& lowest,
             const FixedPosition& highest) {
  const RowSpan none{within.begin, within.begin};
  for (std::size_t axis = 0; axis < 3 && within.begin < within.end; ++axis) {
    const std::int64_t low = lowest[axis] - base[axis], high = highest[axis] - base[axis];
    const std::int64_t first = line.at(axis, within.begin), last = line.at(axis, within.end - 1);
    if (low > high || std::max(first, last) < low || std::min(first, last) > high) return none;
    if (std::min(first, last) >= low && std::max(first, last) <= high) continue;
    const double toLow = static_cast<double>(low) * line.samplesPerUnit[axis];
    const double toHigh = static_cast<double>(high) * line.samplesPerUnit[axis];
    if (first < last) {
      within.begin = firstWhere(within.begin, within.end, toLow, [&](int n) { return line.at(axis, n) >= low; });
      within.end = firstWhere(within.begin, within.end, toHigh, [&](int n) { return line.at(axis, n) > high; });
    } else {
      within.begin = firstWhere(within.begin, within.end, toHigh, [&](int n) { return line.at(axis, n) <= high; });
      within.end = firstWhere(within.begin, within.end, toLow, [&](int n) { return line.at(axis, n) < low; });
    }
  }
  return within.begin < within.end ? within : none;
}

/// Bytes from the first voxel (or brick) to voxel index n along an axis.
std::uint64_t offsetAlong(const TemplateLine& line, std::size_t axis, std::int64_t n) {
  if (line.layout == VoxelLayout::linear) return static_cast<std::uint64_t>(n) * line.stride[axis];
  return Bricks::offsetAlong(axis, n, line.stride);
}

/// Copies the neighbours of a sample, four along each axis or two, into a block of four a row, i fastest. The position is clamped to the
/// outermost voxel centres, and the neighbours to the volume.
struct Neighbours {
  std::array<std::array<std::uint64_t, 4>, 3> offset;
  std::array<std::uint32_t, 3> part;
};
Neighbours findNeighbours(const TemplateLine& line, const FixedPosition& base, int n, int count) {
  Neighbours found;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t last = line.dims[static_cast<int>(a)] - 1;
    const std::int64_t position = std::clamp(base[a] + line.at(a, n), std::int64_t{0}, last * kOneVoxel);
    const std::int64_t first = (position >> kFractionBits) - (count == 4 ? 1 : 0);
    const auto part = static_cast<std::uint32_t>((position & static_cast<std::int64_t>(kFractionMask)) >> (kFractionBits - kPartBits));
    found.part[a] = part | part << 16;
    for (int m = 0; m < count; ++m)
      found.offset[a][static_cast<std::size_t>(m)] = offsetAlong(line, a, std::clamp(first + m, std::int64_t{0}, last));
  }
  return found;
}

}  // namespace

void RowSampler::sample(const TemplateLine& line, const glm::dvec3& start_voxel, RowSpan within, std::uint8_t* row) {
  if (line.empty || !isInRange(start_voxel)) {
    std::fill(row + within.begin, row + std::max(within.begin, within.end), std::uint8_t{0});
    return;
  }
  for (int block = within.begin / kBlock * kBlock; block < within.end; block += kBlock) {
    FixedPosition base = fixedPosition(start_voxel + static_cast<double>(block) * line.step_voxel);
    // Then the integer part is the nearest voxel, and the part that is weighed with the nearest one.
    for (std::int64_t& b : base) b += quality_ == Quality::weave ? kHalfVoxel : kHalfPart;
    sampleBlock(line, base, {std::max(within.begin - block, 0), std::min(within.end - block, kBlock)}, row + block);
  }
}

void RowSampler::sampleBlock(const TemplateLine& line, const FixedPosition& base, RowSpan within, std::uint8_t* block) {
  // Where something is shown, and where every voxel that a sample needs is there.
  FixedPosition outerLow{}, outerHigh{}, innerLow{}, innerHigh{};
  const bool bricked = line.layout == VoxelLayout::bricked;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t voxels = line.dims[static_cast<int>(a)];
    if (quality_ == Quality::weave) {
      outerLow[a] = 0;
      outerHigh[a] = voxels * kOneVoxel - 1;
      continue;
    }
    outerLow[a] = kHalfPart - kHalfVoxel;
    outerHigh[a] = voxels * kOneVoxel - kHalfVoxel + kHalfPart;
    if (quality_ == Quality::cubic) {
      innerLow[a] = kOneVoxel;
      innerHigh[a] = (voxels - 2) * kOneVoxel - 1;
    } else {
      innerLow[a] = 0;
      innerHigh[a] = (voxels - 1) * kOneVoxel - (bricked ? 0 : 1);  // beyond the last voxel bricks repeat it
    }
  }
  const RowSpan run = clip(line, base, within, outerLow, outerHigh);
  std::fill(block + within.begin, block + run.begin, std::uint8_t{0});
  if (quality_ == Quality::weave) {
    push(line, base, run, block);
  } else {
    const RowSpan interior = clip(line, base, run, innerLow, innerHigh);
    borderRun(line, base, {run.begin, interior.begin}, block);
    push(line, base, interior, block);
    borderRun(line, base, {interior.end, run.end}, block);
  }
  std::fill(block + run.end, block + within.end, std::uint8_t{0});
}

/// Samples within half a voxel outside the outermost voxel centres, or too near to a face for whole pieces. They are few a row, so they
/// wait until a piece is full, and the memory has answered.
void RowSampler::borderRun(const TemplateLine& line, const FixedPosition& base, RowSpan run, std::uint8_t* block) {
  const int count = quality_ == Quality::cubic ? 4 : 2;
  for (int n = run.begin; n < run.end; ++n) {
    const Neighbours found = findNeighbours(line, base, n, count);
    const auto at = static_cast<std::size_t>(border_.piece.count);
    BorderSample& waiting = border_.samples[at];
    waiting = {line.voxels, block + n, found.offset};
    for (std::size_t a = 0; a < 3; ++a) border_.piece.part[a][at] = found.part[a];
    for (const int k : {0, count - 1})
      for (const int j : {0, count - 1})
        prefetch(line.voxels + found.offset[0][0] + found.offset[1][static_cast<std::size_t>(j)] +
                 found.offset[2][static_cast<std::size_t>(k)]);
    if (++border_.piece.count == Border::kMost) sampleBorder();
  }
}

/// As a piece of a volume of their own, in which every sample has a block of 4 x 4 x 4 voxels to itself.
void RowSampler::sampleBorder() {
  constexpr std::size_t kSide = 4, kBlockBytes = kSide * kSide * kSide;
  std::array<std::uint8_t, Border::kMost * kBlockBytes> blocks{};
  std::array<std::uint8_t, Border::kMost> greys;
  const std::size_t neighbours = quality_ == Quality::cubic ? 4 : 2;
  const auto count = static_cast<std::size_t>(border_.piece.count);
  for (std::size_t n = 0; n < count; ++n) {
    const BorderSample& sample = border_.samples[n];
    std::uint8_t* block = blocks.data() + n * kBlockBytes;
    for (std::size_t k = 0; k < neighbours; ++k)
      for (std::size_t j = 0; j < neighbours; ++j)
        for (std::size_t i = 0; i < neighbours; ++i)
          block[i + kSide * (j + kSide * k)] = sample.voxels[sample.offset[0][i] + sample.offset[1][j] + sample.offset[2][k]];
    border_.piece.offset[n] = static_cast<std::uint32_t>(n * kBlockBytes);
  }
  border_.piece.voxels = blocks.data();
  border_.piece.stride = {1, kSide, kSide * kSide};
  border_.piece.out = greys.data();
  samplePiece({quality_, VoxelLayout::linear}, border_.piece, nullptr);
  for (std::size_t n = 0; n < count; ++n) *border_.samples[n].out = greys[n];
  border_.piece.count = 0;
}

void RowSampler::push(const TemplateLine& line, const FixedPosition& base, RowSpan run, std::uint8_t* block) {
  // The lowest voxel a sample reads lies this far below the integer part of its position.
  const std::int64_t below = quality_ == Quality::cubic ? 1 : 0;
  for (int n = run.begin; n < run.end;) {
    int count = std::min(Piece::kMost, run.end - n);
    FixedPosition lowest{};
    for (;; count /= 2) {
      std::uint64_t span = 0, cells = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const std::int64_t first = (base[a] + line.at(a, n)) >> kFractionBits,
                           last = (base[a] + line.at(a, n + count - 1)) >> kFractionBits;
        lowest[a] = std::min(first, last) - below;
        if (line.layout == VoxelLayout::bricked) lowest[a] = Bricks::brickBegin(a, lowest[a]);
        span += offsetAlong(line, a, std::max(first, last)) - offsetAlong(line, a, std::min(first, last));
        if (a == 0) cells = static_cast<std::uint64_t>(std::max(first, last) - lowest[a]);
      }
      // Far apart only in volumes of gigabytes; one sample always fits.
      if (count == 1 || (span < (std::uint64_t{1} << 30) && cells < Piece::kCellsAtMost)) break;
    }
    Piece& piece = pieces_[next_];
    std::uint64_t corner = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      corner += offsetAlong(line, a, lowest[a]);
      piece.startWhole[a] = static_cast<std::uint32_t>((base[a] >> kFractionBits) - lowest[a]);
      if (quality_ == Quality::cubic) piece.startWhole[a] -= 1U;
      piece.startFraction[a] = static_cast<std::uint32_t>(static_cast<std::uint64_t>(base[a]) & kFractionMask);
      piece.templateWhole[a] = line.whole[a] + n;
      piece.templateFraction[a] = line.fraction[a] + n;
    }
    if (line.layout == VoxelLayout::linear) {
      piece.templateOffset = line.offset + n;
      piece.startOffset = 0;
      for (std::size_t a = 0; a < 3; ++a) piece.startOffset += piece.startWhole[a] * static_cast<std::uint32_t>(line.stride[a]);
    }
    piece.count = count;
    piece.out = block + n;
    piece.voxels = line.voxels + corner;
    piece.stride = line.stride;
    const PieceKind kind{quality_, line.layout};
    kinds_[next_] = kind;
    layPiece(kind, piece);
    sampleOldest(&piece);
    n += count;
  }
}

void RowSampler::sampleOldest(const Piece* ahead) {
  next_ = next_ == kAhead ? 0 : next_ + 1;
  samplePiece(kinds_[next_], pieces_[next_], ahead);
  pieces_[next_].count = 0;
}

void RowSampler::finish() {
  for (std::size_t n = 0; n <= kAhead; ++n) sampleOldest(nullptr);
  if (border_.piece.count > 0) sampleBorder();
}

}  // namespace ew::detail
