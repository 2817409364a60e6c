#include "ew/imaging/tissue_level.h"

#include <algorithm>
#include <cmath>
#include <functional>
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

/// Values of a block and its neighbourhood, i fastest.
using Field = std::vector<float>;
/// Whether somebody cancelled: what is left then is not looked at.
using Stopped = std::function<bool()>;

/// One axis of a Gaussian: sums run over the same neighbours in the same order wherever a voxel lies in its block.
void smoothAlong(std::size_t axis, const std::vector<float>& kernel, const glm::ivec3& size, const Stopped& stopped, const Field& in,
                 Field& out) {
  const std::ptrdiff_t row = size.x, slice = row * size.y;
  const int reach = static_cast<int>(kernel.size()) - 1;
  const int length = size[static_cast<int>(axis)];
  const std::ptrdiff_t step = axis == 0 ? 1 : axis == 1 ? row : slice;
  for (int k = 0; k < size.z && !stopped(); ++k)
    for (int j = 0; j < size.y; ++j) {
      const std::ptrdiff_t first = k * slice + j * row;
      float* to = out.data() + first;
      std::fill(to, to + row, 0.0F);
      const int at = axis == 1 ? j : k;
      for (int t = -reach; t <= reach; ++t) {
        const float weight = kernel[static_cast<std::size_t>(std::abs(t))];
        int begin = 0, end = size.x;
        if (axis == 0) {
          begin = std::max(0, -t);
          end = std::min(size.x, size.x - t);
        } else if (at + t < 0 || at + t >= length) {
          continue;
        }
        const float* from = in.data() + first + t * step;
        for (int i = begin; i < end; ++i) to[i] += weight * from[i];
      }
    }
}

/// What one thread needs for a block.
struct Scratch {
  Field weight, power, decibels;              ///< of the voxels with data: 1, power, decibels below full white
  Field wideWeight, widePower, wideDecibels;  ///< their Gaussian sums
  Field narrowWeight, narrowDecibels;
  Field narrow, square, rest;           ///< the narrow mean, its square, and what a voxel differs from it, squared
  Field narrowSum, squareSum, restSum;  ///< their wide sums
  Field between;
  Field seen;  ///< the level of voxels that count; below 0 where nothing is near
  std::vector<std::uint8_t> level;

  static constexpr std::uint64_t kFields = 16;
  void resize(std::size_t voxels) {
    for (Field* each : {&weight, &power, &decibels, &wideWeight, &widePower, &wideDecibels, &narrowWeight, &narrowDecibels, &narrow,
                        &square, &rest, &narrowSum, &squareSum, &restSum, &between, &seen})
      each->resize(voxels);
  }
};

class Leveller {
 public:
  Leveller(const VolumeView<const std::uint8_t>& echo, std::span<const std::uint8_t> coverage, const LevelOptions& options)
      : echo_(echo),
        coverage_(coverage),
        gain_db_(options.gain_db),
        stride_(strideOf(echo.grid, options.sigma_mm)),
        wide_(kernelsOf(echo.grid, options.sigma_mm, stride_)),
        narrow_(kernelsOf(echo.grid, kNarrow * options.sigma_mm, stride_)),
        halo_(reachOf(wide_) + reachOf(narrow_)) {
    const std::array<float, 256> shown = levelsShownAs(options.shownWith);
    for (std::size_t grey = 0; grey < 256; ++grey) {
      const double below_db = (static_cast<double>(shown[grey]) / 255.0 - 1.0) * options.recordedDynamicRange_db;
      decibels_[grey] = static_cast<float>(below_db);
      power_[grey] = static_cast<float>(std::pow(10.0, 0.1 * below_db));
    }
  }

  /// Leaves the level of a block in `mine`, unless it was stopped.
  void make(const glm::ivec3& corner, const glm::ivec3& size, const Stopped& stopped, Scratch& mine) const {
    // Voxels that count lie at multiples of the stride, whatever block is made, and reach around the block.
    const glm::ivec3 first = corner / stride_, last = (corner + size - 1 + stride_ - 1) / stride_;
    const glm::ivec3 from = first - halo_, padded = last - first + 1 + 2 * halo_;
    mine.resize(samplesIn(padded));
    take(from, padded, mine);
    const auto sum = [&](const Kernels& kernels, const Field& in, Field& out) {
      smoothAlong(0, kernels[0], padded, stopped, in, out);
      smoothAlong(1, kernels[1], padded, stopped, out, mine.between);
      smoothAlong(2, kernels[2], padded, stopped, mine.between, out);
    };
    sum(wide_, mine.weight, mine.wideWeight);
    sum(wide_, mine.power, mine.widePower);
    sum(wide_, mine.decibels, mine.wideDecibels);
    sum(narrow_, mine.weight, mine.narrowWeight);
    sum(narrow_, mine.decibels, mine.narrowDecibels);
    if (stopped()) return;
    for (std::size_t n = 0; n < mine.weight.size(); ++n) {
      mine.narrow[n] = mine.weight[n] > 0.0F ? mine.narrowDecibels[n] / mine.narrowWeight[n] : 0.0F;
      mine.square[n] = mine.narrow[n] * mine.narrow[n];
      const float off = mine.decibels[n] - mine.narrow[n];
      mine.rest[n] = off * off;
    }
    sum(wide_, mine.narrow, mine.narrowSum);
    sum(wide_, mine.square, mine.squareSum);
    sum(wide_, mine.rest, mine.restSum);
    if (stopped()) return;
    write(corner, size, from, padded, mine);
  }

 private:
  void take(const glm::ivec3& from, const glm::ivec3& size, Scratch& mine) const {
    const Grid& grid = echo_.grid;
    std::size_t to = 0;
    for (int k = 0; k < size.z; ++k)
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i, ++to) {
          const glm::ivec3 at = stride_ * (from + glm::ivec3(i, j, k));
          mine.weight[to] = mine.power[to] = mine.decibels[to] = 0.0F;
          if (!grid.contains(at)) continue;
          const std::size_t index = grid.indexOf(at.x, at.y, at.z);
          const std::uint8_t grey = echo_.data[index];
          const bool hasData = coverage_.empty() ? grey > 0 : coverage_[index] != static_cast<std::uint8_t>(Coverage::absent);
          if (!hasData) continue;
          mine.weight[to] = 1.0F;
          mine.power[to] = power_[grey];
          mine.decibels[to] = decibels_[grey];
        }
  }

  /// @param from, padded the voxels that count, of which `mine` knows the sums
  void write(const glm::ivec3& corner, const glm::ivec3& size, const glm::ivec3& from, const glm::ivec3& padded, Scratch& mine) const {
    mine.level.resize(samplesIn(size));
    const auto placeOf = [&](const glm::ivec3& at) { return sampleIndex(padded, at.x, at.y, at.z); };
    const bool isEach = stride_ == glm::ivec3(1);
    if (!isEach)
      for (std::size_t n = 0; n < mine.seen.size(); ++n)  // what only the wide Gaussian reaches is too far to tell
        mine.seen[n] = mine.wideWeight[n] > 0.0F && mine.narrowWeight[n] > 0.0F ? seenAt(n, mine) : -1.0F;
    std::size_t to = 0;
    for (int k = 0; k < size.z; ++k)
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i, ++to) {
          const glm::ivec3 voxel = corner + glm::ivec3(i, j, k), before = voxel / stride_ - from;
          const std::size_t n = placeOf(before);
          const bool isThere =
              isEach || !coverage_.empty() ? hasLevel(voxel, n, mine) : hasGrey(voxel) || mine.narrowWeight[n] >= kLeastShare;
          mine.level[to] = !isThere ? std::uint8_t{0} : isEach ? levelOfSeen(seenAt(n, mine)) : levelBetween(voxel, before, placeOf, mine);
        }
  }

  [[nodiscard]] bool hasGrey(const glm::ivec3& voxel) const { return echo_.data[echo_.grid.indexOf(voxel.x, voxel.y, voxel.z)] > 0; }
  [[nodiscard]] bool hasLevel(const glm::ivec3& voxel, std::size_t n, const Scratch& mine) const {
    return coverage_.empty() ? mine.weight[n] > 0.0F || mine.narrowWeight[n] >= kLeastShare
                             : coverage_[echo_.grid.indexOf(voxel.x, voxel.y, voxel.z)] != 0;
  }

  /// Of a voxel between those that count: the mean of its eight neighbours that know, by how near they are.
  template <class PlaceOf>
  [[nodiscard]] std::uint8_t levelBetween(const glm::ivec3& voxel, const glm::ivec3& before, const PlaceOf& placeOf,
                                          const Scratch& mine) const {
    const glm::vec3 off = glm::vec3(voxel % stride_) / glm::vec3(stride_);
    float sum = 0.0F, weights = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 next(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::vec3 share = glm::mix(1.0F - off, off, glm::vec3(next));
      const float weight = share.x * share.y * share.z;
      if (weight <= 0.0F) continue;
      const float seen = mine.seen[placeOf(before + next)];
      if (seen < 0.0F) continue;
      sum += weight * seen;
      weights += weight;
    }
    return weights > 0.0F ? levelOfSeen(sum / weights) : std::uint8_t{1};
  }

  [[nodiscard]] static std::uint8_t levelOfSeen(float seen) { return static_cast<std::uint8_t>(std::lround(seen)); }

  /// The level of a voxel that counts, 1 to 255; both Gaussians reach some with data.
  [[nodiscard]] float seenAt(std::size_t n, const Scratch& mine) const {
    const float wide = mine.wideDecibels[n] / mine.wideWeight[n], narrow = mine.narrowDecibels[n] / mine.narrowWeight[n];
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
  glm::ivec3 halo_;
  std::array<float, 256> decibels_{}, power_{};
};

glm::ivec3 blocksOf(const Grid& grid, int edge) { return (grid.dims + edge - 1) / edge; }

int edgeOf(const LevelOptions& options) { return std::clamp(options.block_voxels, 8, 256); }

std::uint64_t threadBytes(const Grid& grid, const LevelOptions& options) {
  const glm::ivec3 stride = strideOf(grid, options.sigma_mm);
  const glm::ivec3 halo = reachOf(kernelsOf(grid, options.sigma_mm, stride)) + reachOf(kernelsOf(grid, kNarrow * options.sigma_mm, stride));
  const glm::ivec3 block = glm::min(glm::ivec3(edgeOf(options)), grid.dims);
  const glm::ivec3 counted = glm::mix((block + stride - 1) / stride + 1, block, glm::equal(stride, glm::ivec3(1)));
  return samplesIn(counted + 2 * halo) * sizeof(float) * Scratch::kFields;
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
