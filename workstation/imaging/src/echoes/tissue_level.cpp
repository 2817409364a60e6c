#include "ew/imaging/tissue_level.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>
#include <utility>

#include "echo_layout.h"
#include "ew/core/contract.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "ew/imaging/effects/gain.h"

namespace ew {
namespace {

constexpr double kNarrow = 0.5;      // of sigma_mm, where an edge runs
constexpr double kReach = 3.0;       // standard deviations
constexpr float kCells = 6.0F;       // of speckle's resolution in a Gaussian of 0.6 mm: its mean varies by so much less
constexpr float kLeastShare = 0.5F;  // of data nearby, where nobody knows what was covered

/// Half of a Gaussian whose whole has the sum 1: by distance in voxels.
std::vector<float> kernelOf(double sigma_voxel) {
  std::vector<double> half(static_cast<std::size_t>(std::ceil(kReach * sigma_voxel)) + 1);
  double sum = 0.0;
  for (std::size_t n = 0; n < half.size(); ++n) {
    const double off = static_cast<double>(n) / sigma_voxel;
    half[n] = std::exp(-0.5 * off * off);
    sum += n == 0 ? half[n] : 2.0 * half[n];
  }
  std::vector<float> kernel;
  for (const double each : half) kernel.push_back(static_cast<float>(each / sum));
  return kernel;
}

/// Each so many voxels count, along i, j, k: a Gaussian of many voxels is as well known from some of them, and costs with the third power
/// of what it reaches over.
glm::ivec3 strideOf(const Grid& grid, double sigma_mm) {
  constexpr double kEnough = 6.0;  // voxels in a standard deviation
  return glm::max(glm::ivec3(1), glm::ivec3(glm::floor(sigma_mm / (kEnough * grid.spacing_mm))));
}

using Kernels = std::array<std::vector<float>, 3>;  // along i, j, k
Kernels kernelsOf(const Grid& grid, double sigma_mm, const glm::ivec3& stride) {
  const glm::dvec3 sigma = sigma_mm / (grid.spacing_mm * glm::dvec3(stride));
  return {kernelOf(sigma.x), kernelOf(sigma.y), kernelOf(sigma.z)};
}
glm::ivec3 reachOf(const Kernels& kernels) {
  return {static_cast<int>(kernels[0].size()) - 1, static_cast<int>(kernels[1].size()) - 1, static_cast<int>(kernels[2].size()) - 1};
}

/// Values of a box of voxels, i fastest.
using Field = std::vector<float>;
/// Whether somebody cancelled: what is left then is not looked at.
using Stopped = std::function<bool()>;

/// Of a voxel: its grey, or that it has no data.
using Code = std::uint16_t;
constexpr Code kNoData = 256;
using ValueOfCode = std::array<float, kNoData + 1>;

/// Three boxes within one another, in voxels that count: the block whose level is made, what its wide sums reach, and what the narrow sums
/// of that reach. A field is as large as the box it is asked for in.
struct Boxes {
  glm::ivec3 inner{0};   ///< sizes
  glm::ivec3 middle{0};  ///< the inner one and what the wide Gaussian reaches around it
  glm::ivec3 outer{0};   ///< the middle one and what the narrow Gaussian reaches around it
};

/// What one thread needs for a block.
struct Scratch {
  std::vector<Code> codes;                    ///< outer
  Field narrowWeight, narrowDecibels;         ///< middle: narrow sums of the voxels with data, 1 each and in decibels
  Field wideWeight, widePower, wideDecibels;  ///< inner: wide sums of the same, and of their power
  Field narrowSum, squareSum, restSum;        ///< inner: wide sums of the narrow mean, its square, what a voxel is off, squared
  Field seen;                                 ///< inner: the level of voxels that count; below 0 where nothing is near
  Field row, plane, planes;                   ///< of a sum on its way: a row, summed along i, and along j
  std::vector<std::uint8_t> level;
};

/// Bytes of all of it. @param block voxels whose level is made
std::uint64_t scratchBytes(const Boxes& boxes, const glm::ivec3& block) {
  const std::uint64_t inner = samplesIn(boxes.inner), middle = samplesIn(boxes.middle), outer = samplesIn(boxes.outer);
  const auto plane = static_cast<std::uint64_t>(boxes.middle.x) * static_cast<std::uint64_t>(boxes.outer.y);
  const std::uint64_t planes = samplesIn({boxes.middle.x, boxes.middle.y, boxes.outer.z});
  return outer * sizeof(Code) + (7 * inner + 2 * middle + planes + plane + static_cast<std::uint64_t>(boxes.outer.x)) * sizeof(float) +
         samplesIn(block);
}

/// Adds neighbours by their weights, in the same order wherever a voxel lies: out[i] is the sum over t of kernel * in[i + t * step].
/// @param in the farthest neighbour in front of the first value
void addNeighbours(const std::vector<float>& kernel, const float* in, std::ptrdiff_t step, int count, float* out) {
  const int reach = static_cast<int>(kernel.size()) - 1;
  std::fill_n(out, count, 0.0F);
  for (int t = -reach; t <= reach; ++t) {
    const float weight = kernel[static_cast<std::size_t>(std::abs(t))];
    const float* from = in + (t + reach) * step;
    for (int i = 0; i < count; ++i) out[i] += weight * from[i];
  }
}

/// A Gaussian sum of what `rowOf` has of a box, at the voxels of the box in it that the kernels reach around: along i, then j, then k.
/// @param rowOf (j, k, row) fills a row of the box of `size`
template <class RowOf>
void smooth(const Kernels& kernels, const glm::ivec3& size, const Stopped& stopped, const RowOf& rowOf, Scratch& mine, Field& out) {
  const glm::ivec3 reach = reachOf(kernels), made = size - 2 * reach;
  mine.row.resize(static_cast<std::size_t>(size.x));
  mine.plane.resize(samplesIn({made.x, size.y, 1}));
  mine.planes.resize(samplesIn({made.x, made.y, size.z}));
  out.resize(samplesIn(made));
  const std::ptrdiff_t row = made.x, slice = row * made.y;
  for (int k = 0; k < size.z && !stopped(); ++k) {
    for (int j = 0; j < size.y; ++j) {
      rowOf(j, k, mine.row.data());
      addNeighbours(kernels[0], mine.row.data(), 1, made.x, mine.plane.data() + j * row);
    }
    for (int j = 0; j < made.y; ++j)
      addNeighbours(kernels[1], mine.plane.data() + j * row, row, made.x, mine.planes.data() + k * slice + j * row);
  }
  for (int k = 0; k < made.z && !stopped(); ++k)
    for (int j = 0; j < made.y; ++j)
      addNeighbours(kernels[2], mine.planes.data() + k * slice + j * row, slice, made.x, out.data() + k * slice + j * row);
}

class Leveller {
 public:
  Leveller(const VolumeView<const std::uint8_t>& echo, std::span<const std::uint8_t> coverage, const LevelOptions& options)
      : echo_(echo),
        coverage_(coverage),
        gain_db_(options.gain_db),
        stride_(strideOf(echo.grid, options.sigma_mm)),
        wide_(kernelsOf(echo.grid, options.sigma_mm, stride_)),
        narrow_(kernelsOf(echo.grid, kNarrow * options.sigma_mm, stride_)) {
    const std::array<float, 256> shown = levelsShownAs(options.shownWith);
    weight_.fill(1.0F);
    for (std::size_t grey = 0; grey < 256; ++grey) {
      const double below_db = (static_cast<double>(shown[grey]) / 255.0 - 1.0) * options.recordedDynamicRange_db;
      decibels_[grey] = static_cast<float>(below_db);
      power_[grey] = static_cast<float>(std::pow(10.0, 0.1 * below_db));
    }
    weight_[kNoData] = decibels_[kNoData] = power_[kNoData] = 0.0F;
  }

  [[nodiscard]] std::uint64_t bytesFor(const glm::ivec3& block) const {
    // A block that begins between voxels that count meets one more of them.
    const glm::ivec3 inner = glm::mix((block + stride_ - 1) / stride_ + 1, block, glm::equal(stride_, glm::ivec3(1)));
    return scratchBytes(boxesAround(inner), block);
  }

  /// Leaves the level of a block in `mine`, unless it was stopped.
  void make(const glm::ivec3& corner, const glm::ivec3& size, const Stopped& stopped, Scratch& mine) const {
    // Voxels that count lie at multiples of the stride, whatever block is made, and reach around the block.
    const glm::ivec3 first = corner / stride_, last = (corner + size - 1 + stride_ - 1) / stride_;
    const Boxes boxes = boxesAround(last - first + 1);
    take(first - reachOf(wide_) - reachOf(narrow_), boxes.outer, mine);
    sumNarrowly(boxes, stopped, mine);
    if (stopped()) return;
    sumWidely(boxes, stopped, mine);
    if (stopped()) return;
    write(corner, size, first, boxes, mine);
  }

 private:
  [[nodiscard]] Boxes boxesAround(const glm::ivec3& inner) const {
    const glm::ivec3 middle = inner + 2 * reachOf(wide_);
    return {inner, middle, middle + 2 * reachOf(narrow_)};
  }

  void take(const glm::ivec3& from, const glm::ivec3& size, Scratch& mine) const {
    const Grid& grid = echo_.grid;
    mine.codes.resize(samplesIn(size));
    std::size_t to = 0;
    for (int k = 0; k < size.z; ++k)
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i, ++to) {
          const glm::ivec3 at = stride_ * (from + glm::ivec3(i, j, k));
          mine.codes[to] = kNoData;
          if (!grid.contains(at)) continue;
          const std::size_t index = grid.indexOf(at.x, at.y, at.z);
          const std::uint8_t grey = echo_.data[index];
          const bool hasData = coverage_.empty() ? grey > 0 : coverage_[index] != static_cast<std::uint8_t>(Coverage::absent);
          if (hasData) mine.codes[to] = grey;
        }
  }

  void sumNarrowly(const Boxes& boxes, const Stopped& stopped, Scratch& mine) const {
    const auto sum = [&](const ValueOfCode& values, Field& out) {
      const auto rowOf = [&](int j, int k, float* row) {
        const Code* from = mine.codes.data() + sampleIndex(boxes.outer, 0, j, k);
        for (int i = 0; i < boxes.outer.x; ++i) row[i] = values[from[i]];
      };
      smooth(narrow_, boxes.outer, stopped, rowOf, mine, out);
    };
    sum(weight_, mine.narrowWeight);
    sum(decibels_, mine.narrowDecibels);
  }

  void sumWidely(const Boxes& boxes, const Stopped& stopped, Scratch& mine) const {
    const glm::ivec3 margin = reachOf(narrow_);
    // Fills a row of the middle box with a value of each voxel, of its code and its narrow mean.
    const auto sum = [&](const auto& valueOf, Field& out) {
      const auto rowOf = [&](int j, int k, float* row) {
        const Code* codes = mine.codes.data() + sampleIndex(boxes.outer, margin.x, j + margin.y, k + margin.z);
        const std::size_t at = sampleIndex(boxes.middle, 0, j, k);
        for (int i = 0; i < boxes.middle.x; ++i) row[i] = valueOf(codes[i], at + static_cast<std::size_t>(i));
      };
      smooth(wide_, boxes.middle, stopped, rowOf, mine, out);
    };
    const auto meanAt = [&](Code code, std::size_t n) { return code != kNoData ? mine.narrowDecibels[n] / mine.narrowWeight[n] : 0.0F; };
    sum([&](Code code, std::size_t) { return weight_[code]; }, mine.wideWeight);
    sum([&](Code code, std::size_t) { return power_[code]; }, mine.widePower);
    sum([&](Code code, std::size_t) { return decibels_[code]; }, mine.wideDecibels);
    sum(meanAt, mine.narrowSum);
    sum(
        [&](Code code, std::size_t n) {
          const float mean = meanAt(code, n);
          return mean * mean;
        },
        mine.squareSum);
    sum(
        [&](Code code, std::size_t n) {
          const float off = decibels_[code] - meanAt(code, n);
          return off * off;
        },
        mine.restSum);
  }

  /// @param first voxel that counts of the inner box
  void write(const glm::ivec3& corner, const glm::ivec3& size, const glm::ivec3& first, const Boxes& boxes, Scratch& mine) const {
    mine.level.resize(samplesIn(size));
    const glm::ivec3 toMiddle = reachOf(wide_), toOuter = toMiddle + reachOf(narrow_);
    const auto placeOf = [&](const glm::ivec3& at) {
      const glm::ivec3 middle = at + toMiddle, outer = at + toOuter;
      return Place{sampleIndex(boxes.inner, at.x, at.y, at.z), sampleIndex(boxes.middle, middle.x, middle.y, middle.z),
                   sampleIndex(boxes.outer, outer.x, outer.y, outer.z)};
    };
    const bool isEach = stride_ == glm::ivec3(1);
    if (!isEach) seeAll(boxes, placeOf, mine);
    std::size_t to = 0;
    for (int k = 0; k < size.z; ++k)
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i, ++to) {
          const glm::ivec3 voxel = corner + glm::ivec3(i, j, k), before = voxel / stride_ - first;
          const Place at = placeOf(before);
          const bool isThere =
              isEach || !coverage_.empty() ? hasLevel(voxel, at, mine) : hasGrey(voxel) || mine.narrowWeight[at.middle] >= kLeastShare;
          mine.level[to] = !isThere ? std::uint8_t{0}
                           : isEach ? levelOfSeen(seenAt(at, mine))
                                    : levelBetween(voxel, before, boxes.inner, mine);
        }
  }

  /// Of a voxel in the fields of each box.
  struct Place {
    std::size_t inner, middle, outer;
  };

  template <class PlaceOf>
  void seeAll(const Boxes& boxes, const PlaceOf& placeOf, Scratch& mine) const {
    mine.seen.resize(samplesIn(boxes.inner));
    for (int k = 0; k < boxes.inner.z; ++k)
      for (int j = 0; j < boxes.inner.y; ++j)
        for (int i = 0; i < boxes.inner.x; ++i) {
          const Place at = placeOf({i, j, k});
          // What only the wide Gaussian reaches is too far to tell.
          const bool isNear = mine.wideWeight[at.inner] > 0.0F && mine.narrowWeight[at.middle] > 0.0F;
          mine.seen[at.inner] = isNear ? seenAt(at, mine) : -1.0F;
        }
  }

  [[nodiscard]] bool hasGrey(const glm::ivec3& voxel) const { return echo_.data[echo_.grid.indexOf(voxel.x, voxel.y, voxel.z)] > 0; }
  [[nodiscard]] bool hasLevel(const glm::ivec3& voxel, const Place& at, const Scratch& mine) const {
    return coverage_.empty() ? mine.codes[at.outer] != kNoData || mine.narrowWeight[at.middle] >= kLeastShare
                             : coverage_[echo_.grid.indexOf(voxel.x, voxel.y, voxel.z)] != 0;
  }

  /// Of a voxel between those that count: the mean of its eight neighbours that know, by how near they are.
  /// @param before it, in the inner box of this size
  [[nodiscard]] std::uint8_t levelBetween(const glm::ivec3& voxel, const glm::ivec3& before, const glm::ivec3& inner,
                                          const Scratch& mine) const {
    const glm::vec3 off = glm::vec3(voxel % stride_) / glm::vec3(stride_);
    float sum = 0.0F, weights = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 next(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::vec3 share = glm::mix(1.0F - off, off, glm::vec3(next));
      const float weight = share.x * share.y * share.z;
      if (weight <= 0.0F) continue;
      const glm::ivec3 at = before + next;
      const float seen = mine.seen[sampleIndex(inner, at.x, at.y, at.z)];
      if (seen < 0.0F) continue;
      sum += weight * seen;
      weights += weight;
    }
    return weights > 0.0F ? levelOfSeen(sum / weights) : std::uint8_t{1};
  }

  [[nodiscard]] static std::uint8_t levelOfSeen(float seen) { return static_cast<std::uint8_t>(std::lround(seen)); }

  /// The level of a voxel that counts, 1 to 255; both Gaussians reach some with data.
  [[nodiscard]] float seenAt(const Place& at, const Scratch& mine) const {
    const std::size_t n = at.inner;
    const float wide = mine.wideDecibels[n] / mine.wideWeight[n], narrow = mine.narrowDecibels[at.middle] / mine.narrowWeight[at.middle];
    // Speckle of this power has its decibels so far lower; where more of it was averaged the mean of the decibels tells.
    const float ofPower = 10.0F * std::log10(std::max(mine.widePower[n] / mine.wideWeight[n], 1e-30F));
    const float more = std::max(ofPower - static_cast<float>(detail::kMeanOfLog_db) - wide, 0.0F);
    const float mean = mine.narrowSum[n] / mine.wideWeight[n], variance = mine.squareSum[n] / mine.wideWeight[n] - mean * mean;
    const float ofSpeckle = mine.restSum[n] / (kCells * mine.wideWeight[n]);
    const float edge = variance > ofSpeckle ? 1.0F - ofSpeckle / variance : 0.0F;
    const float seen_db = wide + edge * (narrow - wide) + (1.0F - edge) * (1.0F - edge) * more;
    const double level_db = static_cast<double>(seen_db) - gain_db_;
    return static_cast<float>(std::clamp(255.0 * (1.0 + level_db / detail::kLevelRange_db), 1.0, 255.0));
  }

  VolumeView<const std::uint8_t> echo_;
  std::span<const std::uint8_t> coverage_;
  double gain_db_;
  glm::ivec3 stride_;
  Kernels wide_, narrow_;
  ValueOfCode weight_{}, decibels_{}, power_{};
};

glm::ivec3 blocksOf(const Grid& grid, int edge) { return (grid.dims + edge - 1) / edge; }

int edgeOf(const LevelOptions& options) { return std::clamp(options.block_voxels, 8, 256); }

std::uint64_t threadBytes(const Grid& grid, const LevelOptions& options) {
  return Leveller({nullptr, grid}, {}, options).bytesFor(glm::min(glm::ivec3(edgeOf(options)), grid.dims));
}

/// As many as there are blocks and room for, but one at least.
int threadsOf(const Grid& grid, const LevelOptions& options) {
  const std::uint64_t blocks = samplesIn(blocksOf(grid, edgeOf(options))), room = options.maxBytes / threadBytes(grid, options);
  const auto asked = static_cast<std::uint64_t>(threadCount(options.threads));
  return static_cast<int>(std::max<std::uint64_t>(std::min({asked, blocks, room}), 1));
}

tl::unexpected<Error> needsMore(std::uint64_t bytes, const LevelOptions& options) {
  return failure(ErrorCode::tooLarge,
                 say<"The level of this volume needs %1 of memory, %2 are allowed; allow more, or choose a smaller sigma.">(
                     mebibytesText(static_cast<double>(bytes)), mebibytesText(static_cast<double>(options.maxBytes))),
                 {{"forecast_bytes", std::to_string(bytes)}});
}

Result<void> checkLevelOptions(const LevelOptions& options) {
  constexpr double kLeast_mm = 0.2, kMost_mm = 5.0;
  if (!(options.sigma_mm >= kLeast_mm && options.sigma_mm <= kMost_mm))
    return failure(ErrorCode::badField,
                   say<"The level is averaged over %1 mm, expected is a number from 0.2 to 5.">(textOf(options.sigma_mm)),
                   {{"field", "sigma_mm"}, {"found", textOf(options.sigma_mm)}, {"expected", "0.2 to 5"}});
  return {};
}

}  // namespace

std::array<float, 256> levelsShownAs(GreyMap shownWith) {
  const Tone tone{.map = shownWith};
  std::array<float, 256> levels{};
  for (int grey = 0; grey < 256; ++grey) {
    double low = 0.0, high = 255.0;  // shownLevel is at most grey at low
    for (int n = 0; n < 40; ++n) {
      const double middle = 0.5 * (low + high);
      (shownLevel(tone, middle) > grey ? high : low) = middle;
    }
    levels[static_cast<std::size_t>(grey)] = static_cast<float>(grey == 255 ? 255.0 : low);
  }
  return levels;
}

std::uint64_t levelForecast_bytes(const Grid& grid, const LevelOptions& options) {
  return static_cast<std::uint64_t>(threadsOf(grid, options)) * threadBytes(grid, options);
}

Result<void> levelInBlocks(const VolumeView<const std::uint8_t>& echo, std::span<const std::uint8_t> coverage, const LevelOptions& options,
                           const LevelSink& sink, Progress& progress) {
  EW_EXPECTS(coverage.empty() || coverage.size() == echo.grid.voxelCount());
  EW_EXPECTS(options.shownWith != GreyMap::automatic);
  if (auto usable = checkGrid(echo.grid); !usable) return usable;
  if (auto usable = checkLevelOptions(options); !usable) return usable;
  const std::uint64_t bytes = levelForecast_bytes(echo.grid, options);
  if (bytes > options.maxBytes) return needsMore(bytes, options);
  const int edge = edgeOf(options);
  const glm::ivec3 blocks = blocksOf(echo.grid, edge);
  const auto total = static_cast<int>(samplesIn(blocks));
  try {
    const Leveller leveller(echo, coverage, options);
    std::vector<Scratch> scratch(static_cast<std::size_t>(threadsOf(echo.grid, options)));
    std::mutex writing;
    const bool finished = forEachTask(total, static_cast<int>(scratch.size()), progress, say<"Finding the tissue's level">(),
                                      [&](int task, int worker, const auto& stopped) {
                                        const glm::ivec3 corner =
                                            edge * glm::ivec3(task % blocks.x, task / blocks.x % blocks.y, task / (blocks.x * blocks.y));
                                        const glm::ivec3 size = glm::min(glm::ivec3(edge), echo.grid.dims - corner);
                                        Scratch& mine = scratch[static_cast<std::size_t>(worker)];
                                        leveller.make(corner, size, stopped, mine);
                                        if (stopped()) return;
                                        const std::lock_guard lock(writing);
                                        sink(corner, size, mine.level);
                                      });
    if (!finished) return failure(ErrorCode::cancelled, say<"Finding the tissue's level was stopped.">());
  } catch (const std::bad_alloc&) {
    return needsMore(bytes, options);
  }
  return {};
}

Result<std::vector<std::uint8_t>> levelOf(const Volume& volume, const LevelOptions& options, Progress& progress) {
  std::vector<std::uint8_t> level;
  try {
    level.resize(volume.grid.voxelCount());
  } catch (const std::bad_alloc&) {
    return needsMore(volume.grid.voxelCount() + levelForecast_bytes(volume.grid, options), options);
  }
  const LevelSink sink = [&](const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> block) {
    auto from = block.begin();
    for (int k = 0; k < size.z; ++k)
      for (int j = 0; j < size.y; ++j, from += size.x)
        std::copy_n(from, size.x, level.begin() + static_cast<std::ptrdiff_t>(volume.grid.indexOf(corner.x, corner.y + j, corner.z + k)));
  };
  if (auto made = levelInBlocks(volume.view(), volume.coverage, options, sink, progress); !made) return passOn(made.error());
  return level;
}

TissueMaps recordedMaps(const Grid& grid, std::vector<std::uint8_t> level) {
  TissueMaps maps;
  maps.grid = grid;
  maps.level = std::move(level);
  maps.isRecorded = true;
  return maps;
}

Result<std::shared_ptr<const TissueMaps>> recordedMapsOf(const Volume& volume, Progress& progress, const LevelOptions& options) {
  auto level = levelOf(volume, options, progress);
  if (!level) return passOn(level.error());
  return std::make_shared<const TissueMaps>(recordedMaps(volume.grid, std::move(*level)));
}

}  // namespace ew
