#include "fill_sweep.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

#include "ew/core/parallel.h"

namespace ew {
namespace {

/// A frame seen from the voxels: column and row (pixels) and signed distance from its plane (mm), each affine in the voxel's indices.
struct FramePlane {
  ImageView<const std::uint8_t> pixels;
  ImageView<const std::uint8_t> weights;
  glm::dmat3 perVoxel{0.0};  ///< columns: change of (column, row, distance) with i, j, k
  glm::dvec3 atOrigin{0.0};  ///< (column, row, distance) of voxel (0, 0, 0)
  glm::dvec3 normal{0.0};    ///< in the world
  glm::dvec3 firstPixel_mm{0.0};
  glm::dvec3 perColumn_mm{0.0};
  glm::dvec3 perRow_mm{0.0};
  glm::dvec3 lowest_voxel{0.0};  ///< of the clip rectangle
  glm::dvec3 highest_voxel{0.0};
};

FramePlane planeOf(const TrackedFrame& frame, const ClipRectangle& clip, const Grid& grid) {
  const glm::dmat4& m = frame.imageToWorld.matrix;
  FramePlane plane;
  plane.pixels = frame.pixels;
  plane.weights = frame.weights;
  plane.firstPixel_mm = glm::dvec3(m[3]);
  plane.perColumn_mm = glm::dvec3(m[0]);
  plane.perRow_mm = glm::dvec3(m[1]);
  plane.normal = glm::normalize(glm::cross(plane.perColumn_mm, plane.perRow_mm));
  const glm::dmat3 toImage = glm::inverse(glm::dmat3(plane.perColumn_mm, plane.perRow_mm, plane.normal));
  for (int axis = 0; axis < 3; ++axis) plane.perVoxel[axis] = toImage[axis] * grid.spacing_mm[axis];
  plane.atOrigin = toImage * (grid.origin_mm - plane.firstPixel_mm);
  plane.lowest_voxel = glm::dvec3(std::numeric_limits<double>::infinity());
  plane.highest_voxel = -plane.lowest_voxel;
  for (const double x : {clip.left, clip.right})
    for (const double y : {clip.top, clip.bottom}) {
      const glm::dvec3 corner = (plane.firstPixel_mm + plane.perColumn_mm * x + plane.perRow_mm * y - grid.origin_mm) / grid.spacing_mm;
      plane.lowest_voxel = glm::min(plane.lowest_voxel, corner);
      plane.highest_voxel = glm::max(plane.highest_voxel, corner);
    }
  return plane;
}

/// Values of frames between their pixels: the mean over a box of whole pixels, then bilinear. Box and tent together blur as much as a
/// voxel: width^2 + 2 = (voxel / pixel)^2, the variances of box, tent (two boxes) and voxel in twelfths of a pixel. So fine pixels are
/// averaged, and coarse ones are left sharp: on the spine sweep, 6 pixels to the voxel, that is worth 0.3 of 11.1 grey levels.
class Sampler {
 public:
  Sampler(const ClipSpans& clip, const FramePlane& first, double spacing_mm)
      : width_(first.pixels.width),
        height_(first.pixels.height),
        box_(boxWidth(spacing_mm / glm::length(first.perColumn_mm)), boxWidth(spacing_mm / glm::length(first.perRow_mm))),
        state_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {
    for (int y = 0; y < height_; ++y)
      for (const Span& span : clip.row(y)) std::fill(state_.begin() + at(span.begin, y), state_.begin() + at(span.end - 1, y) + 1, kInClip);
    // A pixel from which all taps lie in the clip needs no tests.
    for (int y = 0; y + box_.y < height_; ++y)
      for (int x = 0; x + box_.x < width_; ++x) {
        bool all = true;
        for (int dy = 0; dy <= box_.y && all; ++dy)
          for (int dx = 0; dx <= box_.x && all; ++dx) all = (state_[static_cast<std::size_t>(at(x + dx, y + dy))] & kInClip) != 0;
        if (all) state_[static_cast<std::size_t>(at(x, y))] |= kTapsInClip;
      }
  }

  static std::uint64_t bytes(int width, int height) { return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height); }

  /// Where to read around (column, row), the same for every frame; false when the nearest pixel is not in the clip.
  struct Taps {
    int x = 0, y = 0;  ///< first pixel
    int nearX = 0, nearY = 0;
    double fx = 0.0, fy = 0.0;
    bool plain = false;  ///< all in the clip
  };
  [[nodiscard]] bool locate(double column, double row, Taps& taps) const {
    if (!(column > -0.5 && row > -0.5 && column < width_ - 0.5 && row < height_ - 0.5)) return false;
    taps.nearX = static_cast<int>(column + 0.5);
    taps.nearY = static_cast<int>(row + 0.5);
    if ((state_[static_cast<std::size_t>(at(taps.nearX, taps.nearY))] & kInClip) == 0) return false;
    const double x = column - 0.5 * (box_.x - 1), y = row - 0.5 * (box_.y - 1);
    taps.x = floorOf(x);
    taps.y = floorOf(y);
    taps.fx = x - taps.x;
    taps.fy = y - taps.y;
    taps.plain = taps.x >= 0 && taps.y >= 0 && (state_[static_cast<std::size_t>(at(taps.x, taps.y))] & kTapsInClip) != 0;
    return true;
  }

  [[nodiscard]] double sample(const ImageView<const std::uint8_t>& pixels, const Taps& taps) const {
    if (!taps.plain) return sampleInClip(pixels, taps);
    const std::uint8_t* row = pixels.data + taps.y * pixels.stride + taps.x;
    if (box_.x == 1 && box_.y == 1) {
      const std::uint8_t* next = row + pixels.stride;
      const double upper = row[0] + taps.fx * (row[1] - row[0]);
      const double lower = next[0] + taps.fx * (next[1] - next[0]);
      return upper + taps.fy * (lower - upper);
    }
    double total = 0.0;
    for (int dy = 0; dy <= box_.y; ++dy, row += pixels.stride) {
      int inner = 0;
      for (int dx = 1; dx < box_.x; ++dx) inner += row[dx];
      total += share(dy, box_.y, taps.fy) * (inner + (1.0 - taps.fx) * row[0] + taps.fx * row[box_.x]);
    }
    return total / (box_.x * box_.y);
  }

 private:
  static constexpr std::uint8_t kInClip = 1, kTapsInClip = 2;

  static int boxWidth(double pixelsPerVoxel) {
    constexpr double kWidest = 64.0;
    return std::max(1, static_cast<int>(std::lround(std::min(std::sqrt(std::max(pixelsPerVoxel * pixelsPerVoxel - 2.0, 0.0)), kWidest))));
  }
  /// Without the call that std::floor is on a plain x86-64.
  static int floorOf(double value) {
    const int whole = static_cast<int>(value);
    return whole - (value < whole ? 1 : 0);
  }
  /// Weight of tap n of 0..width: a box of `width` pixels moved by a fraction.
  static double share(int n, int width, double fraction) { return n == 0 ? 1.0 - fraction : n == width ? fraction : 1.0; }
  [[nodiscard]] std::ptrdiff_t at(int x, int y) const { return std::ptrdiff_t{y} * width_ + x; }

  /// At the clip's border: the mean over those taps that lie in the clip.
  [[nodiscard]] double sampleInClip(const ImageView<const std::uint8_t>& pixels, const Taps& taps) const {
    double total = 0.0, weight = 0.0;
    for (int dy = 0; dy <= box_.y; ++dy)
      for (int dx = 0; dx <= box_.x; ++dx) {
        const int x = taps.x + dx, y = taps.y + dy;
        if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
        if ((state_[static_cast<std::size_t>(at(x, y))] & kInClip) == 0) continue;
        const double w = share(dx, box_.x, taps.fx) * share(dy, box_.y, taps.fy);
        total += w * pixels.data[y * pixels.stride + x];
        weight += w;
      }
    return weight > 0.0 ? total / weight : pixels.data[taps.nearY * pixels.stride + taps.nearX];
  }

  int width_;
  int height_;
  glm::ivec2 box_;
  std::vector<std::uint8_t> state_;
};

struct SweepBrick {
  glm::ivec3 low{0};
  glm::ivec3 high{0};
};

constexpr glm::ivec3 kBrickSize(256, 16, 16);

glm::ivec3 bricksOf(const Grid& grid) { return (grid.dims + kBrickSize - 1) / kBrickSize; }

// Between frames that are near, what changes across half a voxel is close to a straight line and worth reading; further apart the speckle
// is another one, and blending it only blurs. Frames left out and predicted, mean error in grey levels, without blending, up to 2.5 and up
// to 3 voxels: liver (every second left out) 1.548, 1.497, 1.49; spine (none left out, 3.2 voxels apart) 7.22, 7.29, 7.33.
constexpr double kBlendReach_voxels = 2.5;

struct SweepSums {
  double total = 0.0;
  double weight = 0.0;
};
struct BestSource {
  double weight = 0.0;
  std::uint16_t source = 0;
};

/// The least and largest of an affine function over the voxels of a brick.
struct Reach {
  double least = 0.0;
  double largest = 0.0;
};
Reach distancesOver(const FramePlane& plane, const SweepBrick& brick) {
  const glm::dvec3 perVoxel(plane.perVoxel[0].z, plane.perVoxel[1].z, plane.perVoxel[2].z);
  const glm::dvec3 low(brick.low), high(brick.high - 1);
  const double middle = plane.atOrigin.z + glm::dot(perVoxel, (low + high) * 0.5);
  const double half = glm::dot(glm::abs(perVoxel), (high - low) * 0.5);
  return {middle - half, middle + half};
}

bool boxTouches(const glm::dvec3& lowest, const glm::dvec3& highest, const SweepBrick& brick) {
  for (int axis = 0; axis < 3; ++axis)
    if (highest[axis] < brick.low[axis] - 1.0 || lowest[axis] > brick.high[axis]) return false;
  return true;
}

/// The voxels of [begin, end) around those where at + i * step lies in [least, largest], a hair wider.
Span where(double at, double step, double least, double largest, Span within) {
  if (std::abs(step) < 1e-12) return at >= least - 1e-9 && at <= largest + 1e-9 ? within : Span{};
  const double a = (least - at) / step, b = (largest - at) / step;
  const double first = std::max(std::floor(std::min(a, b)), static_cast<double>(within.begin));
  const double last = std::min(std::ceil(std::max(a, b)), within.end - 1.0);
  if (!(first <= last)) return {};
  return {static_cast<int>(first), static_cast<int>(last) + 1};
}

/// Work on bricks of voxels: visit() is called for each with the sums of its worker, take() for each voxel that got a weight.
class SweepWalker {
 public:
  SweepWalker(std::span<const TrackedFrame> frames, const ClipSpans& clip, const ReconstructOptions& options, const SweepTarget& target)
      : target_(target), options_(options) {
    planes_.reserve(frames.size());
    for (const TrackedFrame& frame : frames) planes_.push_back(planeOf(frame, clip.rectangle(), target.grid));
    sampler_.emplace(clip, planes_.front(), options.spacing_mm);
    const glm::ivec3 count = bricksOf(target.grid);
    tasks_ = count.x * count.y * count.z;
    workers_ = std::min(threadCount(options.threads), tasks_);
    scratch_.resize(static_cast<std::size_t>(workers_));
    const std::size_t cells = static_cast<std::size_t>(kBrickSize.x) * kBrickSize.y * kBrickSize.z;
    for (Scratch& scratch : scratch_) {
      scratch.sums.resize(cells);
      if (target.source != nullptr) scratch.best.resize(cells);
    }
  }

  Result<std::size_t> fill(Progress& progress) { return run(progress, say<"Filling holes along the sweep">(), &SweepWalker::fillBrick); }
  Result<std::size_t> centre(Progress& progress) { return run(progress, say<"Reading frames at the voxels">(), &SweepWalker::centreBrick); }

 private:
  struct Scratch {
    std::vector<SweepSums> sums;
    std::vector<BestSource> best;
    std::vector<std::uint8_t> blended;  ///< centring only: voxels that already have a blend of successive frames
  };

  Result<std::size_t> run(Progress& progress, const Message& what, bool (SweepWalker::*work)(const SweepBrick&, Scratch&)) {
    std::atomic<std::size_t> changed{0};
    const glm::ivec3 count = bricksOf(target_.grid);
    const bool done = forEachTask(tasks_, workers_, progress, what, [&](int task, int worker, const auto&) {
      const glm::ivec3 ijk(task % count.x, task / count.x % count.y, task / count.x / count.y);
      const SweepBrick brick{ijk * kBrickSize, glm::min((ijk + 1) * kBrickSize, target_.grid.dims)};
      Scratch& scratch = scratch_[static_cast<std::size_t>(worker)];
      if ((this->*work)(brick, scratch)) changed += finish(brick, scratch);
    });
    if (!done) return failure(ErrorCode::cancelled, say<"The reconstruction was stopped before it was complete.">());
    return changed.load();
  }

  bool fillBrick(const SweepBrick& brick, Scratch& scratch) {
    return blendPairs({Coverage::absent, options_.fillReach_mm}, brick, scratch);
  }

  /// Which voxels take a blend of successive frames: those of one coverage, where the two are at most so far apart.
  struct Blended {
    Coverage coverage = Coverage::absent;
    double reach_mm = 0.0;
  };

  bool blendPairs(const Blended& blended, const SweepBrick& brick, Scratch& scratch) const {
    bool any = false;
    for (std::size_t n = 0; n + 1 < planes_.size(); ++n) {
      const FramePlane &a = planes_[n], &b = planes_[n + 1];
      if (glm::dot(a.normal, b.normal) <= 0.0) continue;  // more than a right angle between them: no way from one to the other
      if (!boxTouches(glm::min(a.lowest_voxel, b.lowest_voxel), glm::max(a.highest_voxel, b.highest_voxel), brick)) continue;
      const Reach toA = distancesOver(a, brick), toB = distancesOver(b, brick);
      if ((toA.least > 0.0 && toB.least > 0.0) || (toA.largest < 0.0 && toB.largest < 0.0)) continue;
      any = blendPair(n, blended, brick, scratch) || any;
    }
    return any;
  }

  bool blendPair(std::size_t n, const Blended& blended, const SweepBrick& brick, Scratch& scratch) const {
    const FramePlane &a = planes_[n], &b = planes_[n + 1];
    const double stepA = a.perVoxel[0].z, stepB = b.perVoxel[0].z;
    bool any = false;
    for (int k = brick.low.z; k < brick.high.z; ++k)
      for (int j = brick.low.y; j < brick.high.y; ++j) {
        const glm::dvec3 rowA = a.atOrigin + a.perVoxel[1] * static_cast<double>(j) + a.perVoxel[2] * static_cast<double>(k);
        const glm::dvec3 rowB = b.atOrigin + b.perVoxel[1] * static_cast<double>(j) + b.perVoxel[2] * static_cast<double>(k);
        const Span all{brick.low.x, brick.high.x};
        if (stepA * stepB > 0.0) {
          // Between the two places where the row crosses the planes.
          const double crossA = -rowA.z / stepA, crossB = -rowB.z / stepB;
          const double from = std::max(std::floor(std::min(crossA, crossB)), static_cast<double>(all.begin));
          const double to = std::min(std::ceil(std::max(crossA, crossB)), all.end - 1.0);
          if (from <= to)
            any = blendRow(n, blended, rowA, rowB, {static_cast<int>(from), static_cast<int>(to) + 1}, brick, j, k, scratch) || any;
          continue;
        }
        // The row runs along the planes or through the place where they meet.
        const double firstA = rowA.z + stepA * all.begin, lastA = rowA.z + stepA * (all.end - 1);
        const double firstB = rowB.z + stepB * all.begin, lastB = rowB.z + stepB * (all.end - 1);
        if ((std::min(firstA, lastA) > 0.0 && std::min(firstB, lastB) > 0.0) ||
            (std::max(firstA, lastA) < 0.0 && std::max(firstB, lastB) < 0.0))
          continue;
        any = blendRow(n, blended, rowA, rowB, all, brick, j, k, scratch) || any;
      }
    return any;
  }

  bool blendRow(std::size_t n, const Blended& blended, const glm::dvec3& rowA, const glm::dvec3& rowB, Span span, const SweepBrick& brick,
                int j, int k, Scratch& scratch) const {
    const FramePlane &a = planes_[n], &b = planes_[n + 1];
    const std::uint8_t* coverage = target_.coverage + target_.grid.indexOf(0, j, k);
    const std::size_t firstCell = cellOf(brick, j, k);
    const glm::dvec3 first_mm = b.firstPixel_mm - a.firstPixel_mm;
    const glm::dvec3 perColumn_mm = b.perColumn_mm - a.perColumn_mm, perRow_mm = b.perRow_mm - a.perRow_mm;
    const double reach2 = blended.reach_mm * blended.reach_mm * (1.0 + 1e-9);
    const double least = 1e-6 * options_.spacing_mm * options_.spacing_mm;
    bool any = false;
    for (int i = span.begin; i < span.end; ++i) {
      if (coverage[i] != static_cast<std::uint8_t>(blended.coverage)) continue;
      const glm::dvec3 atA = rowA + a.perVoxel[0] * static_cast<double>(i), atB = rowB + b.perVoxel[0] * static_cast<double>(i);
      if (atA.z * atB.z > 0.0) continue;
      const double toA = std::abs(atA.z), toB = std::abs(atB.z);
      const double t = toA + toB > 0.0 ? toA / (toA + toB) : 0.5;
      const double column = atA.x + t * (atB.x - atA.x), row = atA.y + t * (atB.y - atA.y);
      Sampler::Taps taps;
      if (!sampler_->locate(column, row, taps)) continue;
      const glm::dvec3 apart_mm = first_mm + perColumn_mm * column + perRow_mm * row;
      const double apart2 = glm::dot(apart_mm, apart_mm);
      if (apart2 > reach2) continue;
      const double trustA = trustOf(a, taps), trustB = trustOf(b, taps);
      if (!(trustA > 0.0 && trustB > 0.0)) continue;
      const double valueA = sampler_->sample(a.pixels, taps), valueB = sampler_->sample(b.pixels, taps);
      // A filled voxel has no better ground than its distance; a measured one was to count each frame as far as it is trusted.
      const double ofB = blended.coverage == Coverage::absent ? t : t * trustB / ((1.0 - t) * trustA + t * trustB);
      add(scratch, firstCell + static_cast<std::size_t>(i - brick.low.x), valueA + ofB * (valueB - valueA), 1.0 / std::max(apart2, least),
          t <= 0.5 ? n : n + 1);
      any = true;
    }
    return any;
  }

  bool centreBrick(const SweepBrick& brick, Scratch& scratch) {
    bool any = blendPairs({Coverage::measured, kBlendReach_voxels * options_.spacing_mm}, brick, scratch);
    scratch.blended.assign(scratch.sums.size(), 0);
    if (any)
      for (std::size_t cell = 0; cell < scratch.sums.size(); ++cell) scratch.blended[cell] = scratch.sums[cell].weight > 0.0 ? 1 : 0;
    for (std::size_t n = 0; n < planes_.size(); ++n) {
      const FramePlane& plane = planes_[n];
      if (!boxTouches(plane.lowest_voxel, plane.highest_voxel, brick)) continue;
      // The plane passes through a voxel when it is nearer to its centre than half the voxel's extent along the normal.
      const double half = 0.5 * options_.spacing_mm * (std::abs(plane.normal.x) + std::abs(plane.normal.y) + std::abs(plane.normal.z));
      const Reach reach = distancesOver(plane, brick);
      if (reach.least > half || reach.largest < -half) continue;
      for (int k = brick.low.z; k < brick.high.z; ++k)
        for (int j = brick.low.y; j < brick.high.y; ++j) {
          const glm::dvec3 row = plane.atOrigin + plane.perVoxel[1] * static_cast<double>(j) + plane.perVoxel[2] * static_cast<double>(k);
          const Span span = where(row.z, plane.perVoxel[0].z, -half, half, {brick.low.x, brick.high.x});
          const std::uint8_t* coverage = target_.coverage + target_.grid.indexOf(0, j, k);
          const std::size_t firstCell = cellOf(brick, j, k);
          for (int i = span.begin; i < span.end; ++i) {
            const std::size_t cell = firstCell + static_cast<std::size_t>(i - brick.low.x);
            if (coverage[i] != static_cast<std::uint8_t>(Coverage::measured) || scratch.blended[cell] != 0) continue;
            const glm::dvec3 at = row + plane.perVoxel[0] * static_cast<double>(i);
            const double nearness = 1.0 - std::abs(at.z) / half;
            Sampler::Taps taps;
            if (!(nearness > 0.0) || !sampler_->locate(at.x, at.y, taps)) continue;
            const double trust = trustOf(plane, taps);
            if (!(trust > 0.0)) continue;
            add(scratch, cell, sampler_->sample(plane.pixels, taps), nearness * trust, n);
            any = true;
          }
        }
    }
    return any;
  }

  static double trustOf(const FramePlane& plane, const Sampler::Taps& taps) {
    return plane.weights.data == nullptr ? 1.0 : plane.weights.at(taps.nearX, taps.nearY) / 255.0;
  }

  static std::size_t cellOf(const SweepBrick& brick, int j, int k) {
    return (static_cast<std::size_t>(k - brick.low.z) * kBrickSize.y + static_cast<std::size_t>(j - brick.low.y)) * kBrickSize.x;
  }

  static void add(Scratch& scratch, std::size_t cell, double value, double weight, std::size_t frame) {
    scratch.sums[cell].total += weight * value;
    scratch.sums[cell].weight += weight;
    if (!scratch.best.empty() && weight > scratch.best[cell].weight) scratch.best[cell] = {weight, static_cast<std::uint16_t>(frame + 1)};
  }

  /// Writes what the sums say and leaves them zero. The coverage tells which of the two was done.
  std::size_t finish(const SweepBrick& brick, Scratch& scratch) const {
    std::size_t changed = 0;
    for (int k = brick.low.z; k < brick.high.z; ++k)
      for (int j = brick.low.y; j < brick.high.y; ++j) {
        const std::size_t firstCell = cellOf(brick, j, k), first = target_.grid.indexOf(brick.low.x, j, k);
        for (std::size_t n = 0; n < static_cast<std::size_t>(brick.high.x - brick.low.x); ++n) {
          SweepSums& sums = scratch.sums[firstCell + n];
          if (!(sums.weight > 0.0)) continue;
          target_.echo[first + n] = static_cast<std::uint8_t>(std::min(sums.total / sums.weight + 0.5, 255.0));
          std::uint8_t& coverage = target_.coverage[first + n];
          if (coverage == static_cast<std::uint8_t>(Coverage::absent)) {
            coverage = static_cast<std::uint8_t>(Coverage::interpolated);
            if (target_.source != nullptr) target_.source[first + n] = scratch.best[firstCell + n].source;
          }
          if (!scratch.best.empty()) scratch.best[firstCell + n] = {};
          sums = {};
          ++changed;
        }
      }
    return changed;
  }

  SweepTarget target_;
  ReconstructOptions options_;
  std::vector<FramePlane> planes_;
  std::optional<Sampler> sampler_;
  int tasks_ = 0;
  int workers_ = 1;
  std::vector<Scratch> scratch_;
};

tl::unexpected<Error> noMemory() {
  return failure(ErrorCode::tooLarge,
                 say<"There is not enough memory to read frames at the voxels; use fewer threads or a coarser spacing.">());
}

}  // namespace

Result<std::size_t> fillBetweenFrames(std::span<const TrackedFrame> frames, const ClipSpans& clip, const ReconstructOptions& options,
                                      const SweepTarget& target, Progress& progress) {
  try {
    return SweepWalker(frames, clip, options, target).fill(progress);
  } catch (const std::bad_alloc&) {
    return noMemory();
  }
}

Result<void> centreMeasured(std::span<const TrackedFrame> frames, const ClipSpans& clip, const ReconstructOptions& options,
                            const SweepTarget& target, Progress& progress) {
  try {
    if (const auto centred = SweepWalker(frames, clip, options, target).centre(progress); !centred) return passOn(centred.error());
    return {};
  } catch (const std::bad_alloc&) {
    return noMemory();
  }
}

std::uint64_t forecastSweepBytes(const Grid& grid, const ReconstructOptions& options) {
  const glm::ivec3 count = bricksOf(grid);
  const auto bricks = static_cast<std::int64_t>(count.x) * count.y * count.z;
  const std::uint64_t cells = static_cast<std::uint64_t>(kBrickSize.x) * kBrickSize.y * kBrickSize.z;
  return cells * (sizeof(SweepSums) + 1 + (options.keepSource ? sizeof(BestSource) : 0)) *
         static_cast<std::uint64_t>(std::min<std::int64_t>(threadCount(options.threads), bricks));
}

}  // namespace ew
