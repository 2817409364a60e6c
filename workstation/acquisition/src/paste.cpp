#include "paste.h"

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

#include "ew/core/parallel.h"
#include "paste_modes.h"

namespace ew {
namespace {

using paste::kBlock;
using paste::kFractionBits;
using paste::kOneVoxel;

/// Voxels [low, high) along each axis.
struct Brick {
  glm::ivec3 low{0};
  glm::ivec3 high{0};
};

/// How the grid is cut. It depends on the grid and the kind of sum alone, never on the number of threads.
struct BrickPlan {
  glm::ivec3 dims{0};
  glm::ivec3 size{1};
  glm::ivec3 count{0};
  std::size_t cellsPerBrick = 0;
  std::ptrdiff_t rowStride = 0;
  std::ptrdiff_t layerStride = 0;

  [[nodiscard]] std::int64_t bricks() const { return std::int64_t{count.x} * count.y * count.z; }
  [[nodiscard]] Brick at(std::int64_t index) const {
    const glm::ivec3 ijk(static_cast<int>(index % count.x), static_cast<int>(index / count.x % count.y),
                         static_cast<int>(index / count.x / count.y));
    return {ijk * size, glm::min((ijk + 1) * size, dims)};
  }
};

BrickPlan planFor(const Grid& grid, std::size_t cellBytes, int guard) {
  // Sums that stay in the caches of one core: with 16 MB instead of 1.5 MB the liver sweep took 2.5 times as long at 0.5 mm.
  constexpr double kCellBytes = 3 << 19;
  constexpr int kLongestRow = 1024;
  BrickPlan plan;
  plan.dims = grid.dims;
  plan.size.x = std::min(grid.dims.x, kLongestRow);
  const int side = static_cast<int>(std::sqrt(kCellBytes / static_cast<double>(cellBytes) / plan.size.x));
  plan.size.y = plan.size.z = std::clamp(side, 8, 64);
  plan.size = glm::min(plan.size, grid.dims);
  plan.count = (grid.dims + plan.size - 1) / plan.size;
  plan.rowStride = std::ptrdiff_t{plan.size.x + 2 * guard + kBlock - 1} / kBlock * kBlock;
  plan.layerStride = plan.rowStride * (plan.size.y + 2 * guard);
  plan.cellsPerBrick = static_cast<std::size_t>(plan.layerStride) * static_cast<std::size_t>(plan.size.z + 2 * guard);
  return plan;
}

/// From pixels to voxels of the grid. The fixed-point part counts columns from the clip's first one and rounds as the mode wants it.
struct FrameMap {
  ImageView<const std::uint8_t> pixels;
  ImageView<const std::uint8_t> weights;
  glm::dvec3 firstPixel_voxel{0.0};
  glm::dvec3 perColumn_voxel{0.0};
  glm::dvec3 perRow_voxel{0.0};
  glm::dvec3 lowest_voxel{0.0};  ///< of the clip rectangle
  glm::dvec3 highest_voxel{0.0};
  glm::dvec3 normal{0.0};
  std::array<std::int64_t, 3> first{};
  std::array<std::int64_t, 3> perColumn{};
  std::array<std::int64_t, 3> perRow{};
};

std::int64_t fixedPoint(double voxels) { return static_cast<std::int64_t>(std::llrint(std::ldexp(voxels, kFractionBits))); }

FrameMap mapOf(const TrackedFrame& frame, const ClipSpans& clip, const Grid& grid, double rounding_voxel) {
  const glm::dmat4& m = frame.imageToWorld.matrix;
  FrameMap map;
  map.pixels = frame.pixels;
  map.weights = frame.weights;
  map.firstPixel_voxel = (glm::dvec3(m[3]) - grid.origin_mm) / grid.spacing_mm;
  map.perColumn_voxel = glm::dvec3(m[0]) / grid.spacing_mm;
  map.perRow_voxel = glm::dvec3(m[1]) / grid.spacing_mm;
  map.lowest_voxel = glm::dvec3(std::numeric_limits<double>::infinity());
  map.highest_voxel = -map.lowest_voxel;
  const ClipRectangle& r = clip.rectangle();
  for (const double x : {r.left, r.right})
    for (const double y : {r.top, r.bottom}) {
      const glm::dvec3 corner = map.firstPixel_voxel + map.perColumn_voxel * x + map.perRow_voxel * y;
      map.lowest_voxel = glm::min(map.lowest_voxel, corner);
      map.highest_voxel = glm::max(map.highest_voxel, corner);
    }
  map.normal = glm::normalize(glm::cross(map.perColumn_voxel, map.perRow_voxel));
  // The clip's first pixel lies in the grid; the image's need not, and might not fit the fixed point.
  const glm::dvec3 first_voxel = map.firstPixel_voxel + map.perColumn_voxel * static_cast<double>(clip.firstColumn()) +
                                 map.perRow_voxel * static_cast<double>(clip.firstRow()) + rounding_voxel;
  for (int axis = 0; axis < 3; ++axis) {
    map.first[static_cast<std::size_t>(axis)] = fixedPoint(first_voxel[axis]);
    map.perColumn[static_cast<std::size_t>(axis)] = fixedPoint(map.perColumn_voxel[axis]);
    map.perRow[static_cast<std::size_t>(axis)] = fixedPoint(map.perRow_voxel[axis]);
  }
  return map;
}

/// False when no pixel of the frame can reach the brick; a margin of 2 voxels covers guard, rounding and splat.
bool mayTouch(const FrameMap& frame, const Brick& brick) {
  const glm::dvec3 low = glm::dvec3(brick.low) - 2.0, high = glm::dvec3(brick.high) + 1.0;
  for (int axis = 0; axis < 3; ++axis)
    if (frame.highest_voxel[axis] < low[axis] || frame.lowest_voxel[axis] > high[axis]) return false;
  const double distance = glm::dot(frame.normal, (low + high) * 0.5 - frame.firstPixel_voxel);
  return std::abs(distance) <= glm::dot(glm::abs(frame.normal), (high - low) * 0.5);
}

/// Rows of the frame that can reach the brick at all, each axis for itself; two rows of margin cover guard, rounding and splat.
Span rowsReaching(const FrameMap& frame, const Brick& brick, const ClipSpans& clip) {
  double begin = clip.firstRow(), end = clip.lastRow() + 1.0;
  const double lastColumn = clip.rectangle().right;
  for (int axis = 0; axis < 3; ++axis) {
    const double perRow = frame.perRow_voxel[axis];
    const double sweep = frame.perColumn_voxel[axis] * lastColumn;
    const double low = brick.low[axis] - 2.0 - frame.firstPixel_voxel[axis] - std::max(sweep, 0.0);
    const double high = brick.high[axis] + 1.0 - frame.firstPixel_voxel[axis] - std::min(sweep, 0.0);
    if (std::abs(perRow) < 1e-9) continue;
    begin = std::max(begin, std::min(low / perRow, high / perRow) - 2.0);
    end = std::min(end, std::max(low / perRow, high / perRow) + 2.0);
  }
  if (!(begin < end)) return {};
  return {static_cast<int>(begin), static_cast<int>(std::ceil(end))};
}

std::int64_t ceilDiv(std::int64_t a, std::int64_t positive) {
  const std::int64_t quotient = a / positive;
  return quotient + (a % positive > 0 ? 1 : 0);
}
std::int64_t floorDiv(std::int64_t a, std::int64_t positive) {
  const std::int64_t quotient = a / positive;
  return quotient - (a % positive < 0 ? 1 : 0);
}

/// Narrows [begin, end) to the n with 0 <= at + n * step < size.
void narrow(std::int64_t at, std::int64_t step, std::int64_t size, std::int64_t& begin, std::int64_t& end) {
  if (begin >= end) return;
  const std::int64_t first = at + begin * step, last = at + (end - 1) * step;
  if (first >= 0 && first < size && last >= 0 && last < size) return;
  if ((first < 0 && last < 0) || (first >= size && last >= size)) {
    end = begin;
  } else if (step > 0) {
    begin = std::max(begin, ceilDiv(-at, step));
    end = std::min(end, ceilDiv(size - at, step));
  } else {
    begin = std::max(begin, floorDiv(at - size, -step) + 1);
    end = std::min(end, floorDiv(at, -step) + 1);
  }
}

template <class Mode>
class Paster {
  using Cell = typename Mode::Cell;

 public:
  Paster(std::span<const TrackedFrame> frames, const ClipSpans& clip, const ReconstructOptions& options, const PasteTarget& target)
      : clip_(clip),
        target_(target),
        plan_(planFor(target.grid, sizeof(Cell), Mode::kGuard)),
        workers_(static_cast<int>(std::min<std::int64_t>(threadCount(options.threads), plan_.bricks()))) {
    frames_.reserve(frames.size());
    for (const TrackedFrame& frame : frames) frames_.push_back(mapOf(frame, clip, target.grid, Mode::kGuard == 0 ? 0.5 : 0.0));
    scratch_.resize(static_cast<std::size_t>(workers_));
    for (Scratch& scratch : scratch_) {
      scratch.cells.resize(plan_.cellsPerBrick);
      scratch.touched.resize(plan_.cellsPerBrick / kBlock);
    }
  }

  Result<std::size_t> run(Progress& progress) {
    const bool finished = forEachTask(static_cast<int>(plan_.bricks()), workers_, progress, say<"Pasting frames">(),
                                      [this](int task, int worker, const auto& stopped) {
                                        pasteBrick(plan_.at(task), scratch_[static_cast<std::size_t>(worker)], stopped);
                                      });
    if (!finished) return failure(ErrorCode::cancelled, say<"The reconstruction was stopped before it was complete.">());
    if (overflow_)
      return failure(ErrorCode::tooLarge, say<"More than 268 million pixels fall into one voxel; reconstruct with a finer spacing.">());
    return measured_.load();
  }

 private:
  struct Scratch {
    std::vector<Cell> cells;
    std::vector<std::uint8_t> touched;
  };

  template <class Stopped>
  void pasteBrick(const Brick& brick, Scratch& scratch, const Stopped& stopped) {
    std::uint64_t pasted = 0;
    for (std::size_t n = 0; n < frames_.size(); ++n) {
      if (stopped()) return;
      if (mayTouch(frames_[n], brick)) pasted += pasteFrame(n, brick, scratch);
    }
    if (pasted > 0) finish(brick, scratch, pasted);
  }

  std::uint64_t pasteFrame(std::size_t number, const Brick& brick, Scratch& scratch) {
    const FrameMap& frame = frames_[number];
    const paste::Cells<Cell> cells{scratch.cells.data(), scratch.touched.data(), plan_.rowStride, plan_.layerStride};
    std::uint64_t pasted = 0;
    paste::Walk walk{};
    walk.source = static_cast<std::uint16_t>(number + 1);
    std::array<std::int64_t, 3> limit{}, toBrick{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int a = static_cast<int>(axis);
      walk.step[axis] = frame.perColumn[axis];
      limit[axis] = (brick.high[a] - brick.low[a] + Mode::kGuard) * kOneVoxel;
      toBrick[axis] = frame.first[axis] - (brick.low[a] - Mode::kGuard) * kOneVoxel;
    }
    const int firstColumn = clip_.firstColumn();
    const Span rows = rowsReaching(frame, brick, clip_);
    for (int y = rows.begin; y < rows.end; ++y) {
      std::array<std::int64_t, 3> at{};
      for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = toBrick[axis] + (y - clip_.firstRow()) * frame.perRow[axis];
      const auto spans = clip_.row(y);
      for (const Span& span : spans) {
        std::int64_t begin = span.begin - firstColumn, end = span.end - firstColumn;
        for (std::size_t axis = 0; axis < 3; ++axis) narrow(at[axis], walk.step[axis], limit[axis], begin, end);
        if (begin >= end) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) walk.at[axis] = at[axis] + begin * walk.step[axis];
        walk.pixels = frame.pixels.row(y) + firstColumn + begin;
        walk.weights = frame.weights.data == nullptr ? nullptr : frame.weights.row(y) + firstColumn + begin;
        walk.count = static_cast<int>(end - begin);
        Mode::walk(walk, cells);
        pasted += static_cast<std::uint64_t>(walk.count);
      }
    }
    return pasted;
  }

  /// Rounds the sums of a brick into the volume and leaves the scratch zero for the next one.
  void finish(const Brick& brick, Scratch& scratch, std::uint64_t pasted) {
    const glm::ivec3 cells = brick.high - brick.low + 2 * Mode::kGuard;
    const std::ptrdiff_t blocksPerRow = plan_.rowStride / kBlock;
    std::size_t measured = 0;
    std::uint64_t counted = 0;
    for (int k = 0; k < cells.z; ++k)
      for (int j = 0; j < cells.y; ++j)
        for (int block = 0; block < blocksPerRow; ++block) {
          const std::ptrdiff_t row = k * plan_.layerStride + j * plan_.rowStride;
          if (!reached(scratch, row / kBlock + block, block, j, k)) continue;
          Cell* const first = scratch.cells.data() + row + block * kBlock;
          const int jGrid = brick.low.y + j - Mode::kGuard, kGrid = brick.low.z + k - Mode::kGuard;
          const int iGrid = brick.low.x + block * kBlock - Mode::kGuard;
          if (jGrid >= brick.low.y && jGrid < brick.high.y && kGrid >= brick.low.z && kGrid < brick.high.z) {
            const int begin = std::max(brick.low.x - iGrid, 0), end = std::min(brick.high.x - iGrid, kBlock);
            if constexpr (std::is_same_v<Mode, paste::NearestFewMean>) {
              const std::size_t index = target_.grid.indexOf(iGrid, jGrid, kGrid);
              measured += paste::roundSums(first, end, static_cast<std::uint8_t>(Coverage::measured), target_.echo + index,
                                           target_.coverage + index);
              if (target_.weights != nullptr)
                for (int n = 0; n < end; ++n)
                  target_.weights[index + static_cast<std::size_t>(n)] = static_cast<float>(first[n] >> paste::kSmallSumBits);
              std::fill(first, first + kBlock, Cell{});
              continue;
            }
            for (int n = begin; n < end; ++n) {
              const std::size_t index = target_.grid.indexOf(iGrid + n, jGrid, kGrid);
              if constexpr (std::is_same_v<Mode, paste::NearestSource>) {
                if (target_.coverage[index] != 0) target_.source[index] = first[n].source;
              } else {
                const paste::Voxel voxel = Mode::voxelOf(first[n]);
                if (!voxel.measured) continue;
                target_.echo[index] = voxel.echo;
                target_.coverage[index] = static_cast<std::uint8_t>(Coverage::measured);
                if (target_.weights != nullptr) target_.weights[index] = static_cast<float>(voxel.weight);
                ++measured;
                counted += static_cast<std::uint64_t>(voxel.weight);
              }
            }
          }
          std::fill(first, first + kBlock, Cell{});
        }
    std::fill(scratch.touched.begin(), scratch.touched.end(), std::uint8_t{0});
    measured_ += measured;
    // A count that ran over its 28 bits lost 2^28 of them, which shows in the sum of all counts.
    if constexpr (std::is_same_v<Mode, paste::NearestMean>) {
      if (counted != pasted) overflow_ = true;
    }
  }

  /// Whether a pixel reached this block: its own flag, and with a guard those of the cells before it along each axis.
  bool reached(const Scratch& scratch, std::ptrdiff_t flag, int block, int j, int k) const {
    const std::vector<std::uint8_t>& touched = scratch.touched;
    if constexpr (std::is_same_v<Mode, paste::NearestFewMean>) {
      return paste::anySum(scratch.cells.data() + flag * kBlock, kBlock);
    } else if constexpr (Mode::kGuard == 0) {
      return touched[static_cast<std::size_t>(flag)] != 0;
    } else {
      for (int dk = 0; dk <= std::min(k, 1); ++dk)
        for (int dj = 0; dj <= std::min(j, 1); ++dj)
          for (int db = 0; db <= std::min(block, 1); ++db)
            if (touched[static_cast<std::size_t>(flag - (dk * plan_.layerStride + dj * plan_.rowStride) / kBlock - db)] != 0) return true;
      return false;
    }
  }

  const ClipSpans& clip_;
  PasteTarget target_;
  BrickPlan plan_;
  int workers_;
  std::vector<FrameMap> frames_;
  std::vector<Scratch> scratch_;
  std::atomic<std::size_t> measured_{0};
  std::atomic<bool> overflow_{false};
};

/// The most pixels of one frame that can fall into one voxel: those between the ends of a voxel along columns and rows, for in the plane
/// the pixel is a linear function of the place.
double mostPixelsInVoxel(const FrameMap& frame) {
  const glm::dmat3 toPixel = glm::inverse(glm::dmat3(frame.perColumn_voxel, frame.perRow_voxel, frame.normal));
  double most = 1.0;
  for (int row = 0; row < 2; ++row)
    most *= std::floor((std::abs(toPixel[0][row]) + std::abs(toPixel[1][row]) + std::abs(toPixel[2][row])) * (1.0 + 1e-6)) + 1.0;
  return most;
}

/// Whether no voxel of a brick can get more pixels than its cell can count.
bool fewInEveryVoxel(std::span<const TrackedFrame> frames, const ClipSpans& clip, const Grid& grid) {
  const BrickPlan plan = planFor(grid, sizeof(paste::SmallSum), 0);
  std::vector<FrameMap> maps;
  std::vector<double> most;
  double all = 0.0;
  for (const TrackedFrame& frame : frames) {
    maps.push_back(mapOf(frame, clip, grid, 0.5));
    most.push_back(mostPixelsInVoxel(maps.back()));
    if (!(most.back() <= paste::kMostSmallPixels)) return false;
    all += most.back();
  }
  if (all <= paste::kMostSmallPixels) return true;
  for (std::int64_t n = 0; n < plan.bricks(); ++n) {
    const Brick brick = plan.at(n);
    double pixels = 0.0;
    for (std::size_t frame = 0; frame < maps.size(); ++frame)
      if (mayTouch(maps[frame], brick)) pixels += most[frame];
    if (pixels > paste::kMostSmallPixels) return false;
  }
  return true;
}

/// Calls use(Mode{}) for the mode the options ask for.
template <class Use>
auto withMode(const ReconstructOptions& options, const Use& use) {
  const bool nearest = options.interpolation != Interpolation::linear;
  switch (options.compounding) {
    case Compounding::maximum:
      return nearest ? use(paste::NearestMaximum{}) : use(paste::LinearMaximum{});
    case Compounding::latest:
      return nearest ? use(paste::NearestLatest{}) : use(paste::LinearLatest{});
    case Compounding::weighted:
      return nearest ? use(paste::NearestWeighted{}) : use(paste::LinearWeighted{});
    case Compounding::mean:
      break;
  }
  return nearest ? use(paste::NearestMean{}) : use(paste::LinearMean{});
}

}  // namespace

Result<std::size_t> pasteFrames(std::span<const TrackedFrame> frames, const ClipSpans& clip, const ReconstructOptions& options,
                                const PasteTarget& target, Progress& progress) {
  const double pastedTo = target.source == nullptr ? 1.0 : 0.5;
  PartOfProgress pasting(progress, 0.0, pastedTo), tracing(progress, pastedTo, 1.0);
  try {
    const auto pasteBy = [&]<class Mode>(Mode) { return Paster<Mode>(frames, clip, options, target).run(pasting); };
    const bool nearestMean = options.interpolation != Interpolation::linear && options.compounding == Compounding::mean;
    auto measured =
        nearestMean && fewInEveryVoxel(frames, clip, target.grid) ? pasteBy(paste::NearestFewMean{}) : withMode(options, pasteBy);
    if (!measured || target.source == nullptr) return measured;
    if (const auto traced = Paster<paste::NearestSource>(frames, clip, options, target).run(tracing); !traced)
      return passOn(traced.error());
    return measured;
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge, say<"There is not enough memory for the sums of the reconstruction; use fewer threads.">());
  }
}

std::uint64_t pasteScratchBytes(const Grid& grid, const ReconstructOptions& options) {
  return withMode(options, [&]<class Mode>(Mode) {
    using Cell = typename Mode::Cell;
    const BrickPlan plan = planFor(grid, sizeof(Cell), Mode::kGuard);
    const std::uint64_t perWorker = plan.cellsPerBrick * sizeof(Cell) + plan.cellsPerBrick / kBlock;
    return perWorker * static_cast<std::uint64_t>(std::min<std::int64_t>(threadCount(options.threads), plan.bricks()));
  });
}

}  // namespace ew
