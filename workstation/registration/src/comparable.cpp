#include "comparable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "ew/core/parallel.h"
#include "streaks.h"

namespace ew::registration {
namespace {

constexpr int kPlanesPerTask = 8;
constexpr float kBelieved = 0.05F;           // a confidence above it
constexpr std::size_t kLeastBelieved = 200;  // one voxel of so many has to be, or the map says nothing

/// dst = max (or min) over 2 r + 1 neighbours along one axis; outside counts as `outside`.
template <class Pick>
void overNeighbours(std::vector<std::uint8_t>& data, const glm::ivec3& dims, int axis, int r, std::uint8_t outside, Progress& progress,
                    const Pick& pick) {
  if (r <= 0) return;
  const std::size_t nx = dims.x;
  const std::size_t ny = dims.y;
  const std::size_t nz = dims.z;
  const std::size_t row = axis == 0 ? 1 : axis == 1 ? nx : nx * ny;  // one step along the axis
  const int n = dims[axis];
  const std::size_t lanes = axis == 0 ? 1 : axis == 1 ? nx : nx * ny;
  const std::size_t slabs = axis == 0 ? ny * nz : axis == 1 ? nz : 1;
  std::vector<std::uint8_t> padded((n + 2 * r) * lanes, outside);
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    std::uint8_t* line = data.data() + slab * row * n;
    std::memcpy(padded.data() + r * lanes, line, n * lanes);
    for (int s = -r; s <= r; ++s) {
      if (n * lanes > 100000 && progress.cancelRequested()) return;
      const std::uint8_t* from = padded.data() + (r + s) * lanes;
      if (s == -r) {
        std::memcpy(line, from, n * lanes);
        continue;
      }
      for (std::size_t q = 0; q < n * lanes; ++q) line[q] = pick(line[q], from[q]);
    }
  }
}
void erode(std::vector<std::uint8_t>& data, const glm::ivec3& dims, const glm::ivec3& r, std::uint8_t outside, Progress& progress) {
  const auto least = [](std::uint8_t a, std::uint8_t b) { return std::min(a, b); };
  for (int axis = 0; axis < 3; ++axis) overNeighbours(data, dims, axis, r[axis], outside, progress, least);
}
void dilate(std::vector<std::uint8_t>& data, const glm::ivec3& dims, const glm::ivec3& r, Progress& progress) {
  const auto most = [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); };
  for (int axis = 0; axis < 3; ++axis) overNeighbours(data, dims, axis, r[axis], 0, progress, most);
}

/// Keeps of `area` (1 or 0) what is connected, over faces, to a voxel of `seeds`; those of `area` that are kept become 2.
void growFrom(std::vector<std::uint8_t>& area, const std::vector<std::uint8_t>& seeds, const Grid& grid, Progress& progress) {
  struct Run {
    int begin, end, j, k;
  };
  std::vector<Run> waiting;
  const auto take = [&](int i, int j, int k) {  // the whole run of area around i
    std::uint8_t* row = area.data() + grid.indexOf(0, j, k);
    int begin = i;
    int end = i + 1;
    while (begin > 0 && row[begin - 1] == 1) --begin;
    while (end < grid.dims.x && row[end] == 1) ++end;
    std::fill(row + begin, row + end, std::uint8_t{2});
    waiting.push_back({begin, end, j, k});
  };
  for (int k = 0; k < grid.dims.z; ++k) {
    for (int j = 0; j < grid.dims.y; ++j) {
      const std::size_t at = grid.indexOf(0, j, k);
      for (int i = 0; i < grid.dims.x; ++i) {
        if (seeds[at + i] != 0 && area[at + i] == 1) take(i, j, k);
      }
    }
  }
  std::size_t taken = 0;
  while (!waiting.empty()) {
    if ((++taken & 4095u) == 0 && progress.cancelRequested()) return;
    const Run run = waiting.back();
    waiting.pop_back();
    const std::array<glm::ivec2, 4> sides{{{run.j - 1, run.k}, {run.j + 1, run.k}, {run.j, run.k - 1}, {run.j, run.k + 1}}};
    for (const glm::ivec2& side : sides) {
      if (side.x < 0 || side.x >= grid.dims.y || side.y < 0 || side.y >= grid.dims.z) continue;
      const std::uint8_t* row = area.data() + grid.indexOf(0, side.x, side.y);
      for (int i = run.begin; i < run.end; ++i) {
        if (row[i] == 1) take(i, side.x, side.y);
      }
    }
  }
}

/// What each output place takes of the input places along one axis.
struct Taps {
  std::vector<int> first;
  std::vector<float> weight;  ///< count per output place
  int count = 0;
};
Taps tentTaps(int from, double from_mm, int to, double to_mm) {
  Taps taps;
  const double ratio = to_mm / from_mm;
  const double reach = std::max(ratio, 1.0);
  taps.count = std::min(from, 2 * static_cast<int>(std::ceil(reach)) + 1);
  taps.first.resize(to);
  taps.weight.assign(static_cast<std::size_t>(to) * taps.count, 0.0F);
  const double middle = 0.5 * (from - 1);
  for (int o = 0; o < to; ++o) {
    const double at = middle + (o - 0.5 * (to - 1)) * ratio;
    const int first = std::clamp(static_cast<int>(std::ceil(at - reach)), 0, from - taps.count);
    taps.first[o] = first;
    double sum = 0.0;
    for (int t = 0; t < taps.count; ++t) {
      const double w = std::max(0.0, 1.0 - std::abs(first + t - at) / reach);
      taps.weight[static_cast<std::size_t>(o) * taps.count + t] = static_cast<float>(w);
      sum += w;
    }
    for (int t = 0; t < taps.count; ++t) {
      auto& w = taps.weight[static_cast<std::size_t>(o) * taps.count + t];
      w = sum > 0.0 ? static_cast<float>(static_cast<double>(w) / sum) : (t == 0 ? 1.0F : 0.0F);
    }
  }
  return taps;
}

/// An image on its way to another voxel size: echo times weight, and weight, both float.
struct Weighted {
  Grid grid;
  std::vector<float> sum;
  std::vector<float> weight;
};

/// One axis at a time, z first so that the big passes run along whole planes.
bool resampleAxis(std::vector<float>& data, glm::ivec3& dims, int axis, const Taps& taps, int to, int threads, Progress& progress) {
  glm::ivec3 out = dims;
  out[axis] = to;
  std::vector<float> result(static_cast<std::size_t>(out.x) * out.y * out.z);
  const std::size_t plane = static_cast<std::size_t>(dims.x) * dims.y;
  const std::size_t outPlane = static_cast<std::size_t>(out.x) * out.y;
  const bool done = forEachTask(out.z, threads, progress, say<"Preparing images">(), [&](int k) {
    float* target = result.data() + k * outPlane;
    if (axis == 2) {
      const float* w = taps.weight.data() + static_cast<std::size_t>(k) * taps.count;
      std::fill(target, target + outPlane, 0.0F);
      for (int t = 0; t < taps.count; ++t) {
        if (w[t] == 0.0F) continue;
        const float* source = data.data() + (taps.first[k] + t) * plane;
        for (std::size_t q = 0; q < outPlane; ++q) target[q] += w[t] * source[q];
      }
      return;
    }
    const float* source = data.data() + k * plane;
    if (axis == 1) {
      for (int j = 0; j < to; ++j) {
        float* row = target + static_cast<std::size_t>(j) * out.x;
        std::fill(row, row + out.x, 0.0F);
        const float* w = taps.weight.data() + static_cast<std::size_t>(j) * taps.count;
        for (int t = 0; t < taps.count; ++t) {
          if (w[t] == 0.0F) continue;
          const float* from = source + static_cast<std::size_t>(taps.first[j] + t) * dims.x;
          for (int i = 0; i < out.x; ++i) row[i] += w[t] * from[i];
        }
      }
      return;
    }
    for (int j = 0; j < dims.y; ++j) {
      const float* from = source + static_cast<std::size_t>(j) * dims.x;
      float* row = target + static_cast<std::size_t>(j) * to;
      for (int i = 0; i < to; ++i) {
        const float* w = taps.weight.data() + static_cast<std::size_t>(i) * taps.count;
        float sum = 0.0F;
        for (int t = 0; t < taps.count; ++t) sum += w[t] * from[taps.first[i] + t];
        row[i] = sum;
      }
    }
  });
  if (!done) return false;
  data = std::move(result);
  dims = out;
  return true;
}

/// All axes of one channel of `from` onto `to`.
bool resample(std::vector<float>& data, const Grid& from, const Grid& to, int threads, Progress& progress) {
  glm::ivec3 dims = from.dims;
  for (int axis = 2; axis >= 0; --axis) {
    if (from.dims[axis] == to.dims[axis] && from.spacing_mm[axis] == to.spacing_mm[axis]) continue;
    const Taps taps = tentTaps(from.dims[axis], from.spacing_mm[axis], to.dims[axis], to.spacing_mm[axis]);
    if (!resampleAxis(data, dims, axis, taps, to.dims[axis], threads, progress)) return false;
  }
  return true;
}

bool smoothWith(std::vector<float>& data, const glm::ivec3& size, const std::vector<float>& kernel, int threads, Progress& progress) {
  const int reach = static_cast<int>(kernel.size()) / 2;
  glm::ivec3 dims = size;
  for (int axis = 2; axis >= 0; --axis) {
    const int n = dims[axis];
    Taps taps;  // zero outside: what is missing there is missing in the weight too
    taps.count = std::min(n, 2 * reach + 1);
    taps.first.resize(n);
    taps.weight.assign(static_cast<std::size_t>(n) * taps.count, 0.0F);
    for (int o = 0; o < n; ++o) {
      taps.first[o] = std::clamp(o - reach, 0, n - taps.count);
      for (int t = 0; t < taps.count; ++t) {
        const int d = taps.first[o] + t - o;
        if (std::abs(d) <= reach) taps.weight[static_cast<std::size_t>(o) * taps.count + t] = kernel[d + reach];
      }
    }
    if (!resampleAxis(data, dims, axis, taps, n, threads, progress)) return false;
  }
  return true;
}

std::vector<float> gaussian(double sigma) {
  const int reach = std::max(1, static_cast<int>(std::ceil(2.5 * sigma)));
  std::vector<float> kernel(2 * reach + 1);
  double sum = 0.0;
  for (int d = -reach; d <= reach; ++d) sum += std::exp(-0.5 * d * d / (sigma * sigma));
  for (int d = -reach; d <= reach; ++d) kernel[d + reach] = static_cast<float>(std::exp(-0.5 * d * d / (sigma * sigma)) / sum);
  return kernel;
}

/// Where a fine place lies between coarse ones, for linear interpolation along one axis.
struct Between {
  std::vector<int> low;
  std::vector<float> share;  ///< of the next one
};
Between between(int fine, double fine_mm, int coarse, double coarse_mm) {
  Between b{std::vector<int>(fine), std::vector<float>(fine)};
  for (int o = 0; o < fine; ++o) {
    const double at = std::clamp(0.5 * (coarse - 1) + (o - 0.5 * (fine - 1)) * fine_mm / coarse_mm, 0.0, coarse - 1.0);
    b.low[o] = std::clamp(static_cast<int>(at), 0, std::max(0, coarse - 2));
    b.share[o] = static_cast<float>(at - b.low[o]);
  }
  return b;
}

/// Takes local mean and deviation out of `image` (echo times weight on entry) and fills what a ComparableImage holds.
bool normalise(Weighted image, const ComparableOptions& options, ComparableImage& out, Progress& progress) {
  const Grid& grid = image.grid;
  const std::size_t n = grid.voxelCount();
  const double momentVoxel_mm = std::max(grid.spacing_mm.x, std::min(3.0, options.window_mm / 2.5));
  const Grid coarse = levelGrid(grid, momentVoxel_mm);
  std::vector<float> value(n);
  for (std::size_t q = 0; q < n; ++q) value[q] = image.weight[q] > 0.0F ? image.sum[q] / image.weight[q] : 0.0F;

  std::vector<float> second(n);
  for (std::size_t q = 0; q < n; ++q) second[q] = image.sum[q] * value[q];
  std::vector<float> zeroth = image.weight;
  std::vector<float> first = std::move(image.sum);
  for (auto* moment : {&second, &first, &zeroth}) {
    if (!resample(*moment, grid, coarse, options.threads, progress)) return false;
    if (!smoothWith(*moment, coarse.dims, gaussian(options.window_mm / momentVoxel_mm), options.threads, progress)) return false;
  }
  // Mean and reciprocal deviation, in place of the first two moments.
  for (std::size_t q = 0; q < zeroth.size(); ++q) {
    const double w = std::max(1e-4, static_cast<double>(zeroth[q]));
    const double mean = static_cast<double>(first[q]) / w;
    const double deviation = std::sqrt(std::max(0.0, static_cast<double>(second[q]) / w - mean * mean));
    first[q] = static_cast<float>(mean);
    second[q] = static_cast<float>(1.0 / (deviation + options.softness));
  }
  const Between bx = between(grid.dims.x, grid.spacing_mm.x, coarse.dims.x, momentVoxel_mm);
  const Between by = between(grid.dims.y, grid.spacing_mm.y, coarse.dims.y, momentVoxel_mm);
  const Between bz = between(grid.dims.z, grid.spacing_mm.z, coarse.dims.z, momentVoxel_mm);
  out.grid = grid;
  out.weight.resize(n);
  const int planes = grid.dims.z;
  const bool done =
      forEachTask((planes + kPlanesPerTask - 1) / kPlanesPerTask, options.threads, progress, say<"Preparing images">(), [&](int task) {
        std::vector<float> mean(coarse.dims.x + 1);
        std::vector<float> scale(coarse.dims.x + 1);
        for (int k = task * kPlanesPerTask; k < std::min(planes, (task + 1) * kPlanesPerTask); ++k) {
          for (int j = 0; j < grid.dims.y; ++j) {
            const int j1 = std::min(by.low[j] + 1, coarse.dims.y - 1);
            const int k1 = std::min(bz.low[k] + 1, coarse.dims.z - 1);
            const float fy = by.share[j];
            const float fz = bz.share[k];
            const std::array<std::size_t, 4> rows{coarse.indexOf(0, by.low[j], bz.low[k]), coarse.indexOf(0, j1, bz.low[k]),
                                                  coarse.indexOf(0, by.low[j], k1), coarse.indexOf(0, j1, k1)};
            const std::array<float, 4> w{(1 - fy) * (1 - fz), fy * (1 - fz), (1 - fy) * fz, fy * fz};
            for (int i = 0; i < coarse.dims.x; ++i) {
              mean[i] = w[0] * first[rows[0] + i] + w[1] * first[rows[1] + i] + w[2] * first[rows[2] + i] + w[3] * first[rows[3] + i];
              scale[i] = w[0] * second[rows[0] + i] + w[1] * second[rows[1] + i] + w[2] * second[rows[2] + i] + w[3] * second[rows[3] + i];
            }
            mean[coarse.dims.x] = mean[coarse.dims.x - 1];
            scale[coarse.dims.x] = scale[coarse.dims.x - 1];
            const std::size_t at = grid.indexOf(0, j, k);
            for (int i = 0; i < grid.dims.x; ++i) {
              const int low = bx.low[i];
              const float share = bx.share[i];
              const float m = mean[low] + share * (mean[low + 1] - mean[low]);
              const float s = scale[low] + share * (scale[low + 1] - scale[low]);
              const float weight = image.weight[at + i];
              const bool inside = weight > 0.5F / 255.0F;
              out.weight[at + i] = inside ? static_cast<std::uint8_t>(std::min(255.0F, weight * 255.0F + 0.5F)) : std::uint8_t{0};
              value[at + i] = inside ? std::clamp((value[at + i] - m) * s, -4.0F, 4.0F) : 0.0F;
            }
          }
        }
      });
  if (!done) return false;
  out.value = std::move(value);
  out.inner = out.weight;
  for (auto& w : out.inner) w = w != 0 ? 1 : 0;
  erode(out.inner, grid.dims, glm::ivec3(1), 0, progress);
  if (progress.cancelRequested()) return false;
  for (std::size_t q = 0; q < n; ++q) out.inner[q] = out.inner[q] != 0 ? out.weight[q] : std::uint8_t{0};
  return true;
}

}  // namespace

Grid levelGrid(const Grid& grid, double voxel_mm) {
  Grid out = grid;
  glm::dvec3 shift(0.0);
  for (int a = 0; a < 3; ++a) {
    const double extent = grid.dims[a] * grid.spacing_mm[a];
    out.dims[a] = std::max(1, static_cast<int>(std::lround(extent / voxel_mm)));
    out.spacing_mm[a] = voxel_mm;
    shift[a] = 0.5 * ((grid.dims[a] - 1) * grid.spacing_mm[a] - (out.dims[a] - 1) * voxel_mm);
  }
  out.origin_mm = grid.origin_mm + grid.directions * shift;
  return out;
}

double ComparableImage::coveredVolume_mm3() const {
  double sum = 0.0;
  for (const auto w : weight) sum += w != 0 ? 1.0 : 0.0;
  return sum * grid.spacing_mm.x * grid.spacing_mm.y * grid.spacing_mm.z;
}

Result<std::vector<std::uint8_t>> coveredMask(const Volume& volume, Progress& progress) {
  const std::size_t n = volume.grid.voxelCount();
  std::vector<std::uint8_t> mask(n, 255);
  if (!volume.coverage.empty()) {
    for (std::size_t q = 0; q < n; ++q) mask[q] = volume.coverage[q] == static_cast<std::uint8_t>(Coverage::absent) ? 0 : 255;
    return mask;
  }
  std::size_t zeros = 0;
  for (std::size_t q = 0; q < n; ++q) zeros += volume.echo[q] == 0 ? 1 : 0;
  if (zeros == 0) return mask;
  const glm::ivec3 dims = volume.grid.dims;
  // Black that a box of three voxels fits into, and black that one of 10 mm fits into; beyond the border everything counts as black.
  std::vector<std::uint8_t> opened(n);
  for (std::size_t q = 0; q < n; ++q) opened[q] = volume.echo[q] == 0 ? 1 : 0;
  std::vector<std::uint8_t> thick = opened;
  const glm::ivec3 small(1);
  glm::ivec3 large(0);
  for (int a = 0; a < 3; ++a) large[a] = std::min(static_cast<int>(5.0 / volume.grid.spacing_mm[a]), 64);
  erode(opened, dims, small, 1, progress);
  dilate(opened, dims, small, progress);
  erode(thick, dims, large, 1, progress);
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Registration was cancelled.">());
  // A part is outside when it holds such a thick place on the border itself.
  for (int k = 1; k < dims.z - 1; ++k) {
    for (int j = 1; j < dims.y - 1; ++j) {
      const std::size_t at = volume.grid.indexOf(0, j, k);
      if (dims.x > 2)
        std::fill(thick.begin() + static_cast<std::ptrdiff_t>(at) + 1, thick.begin() + static_cast<std::ptrdiff_t>(at) + dims.x - 1,
                  std::uint8_t{0});
    }
  }
  for (std::size_t q = 0; q < n; ++q) opened[q] = opened[q] != 0 && volume.echo[q] == 0 ? 1 : 0;
  growFrom(opened, thick, volume.grid, progress);
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Registration was cancelled.">());
  for (std::size_t q = 0; q < n; ++q) mask[q] = opened[q] == 2 ? 0 : 255;
  return mask;
}

std::vector<double> levelVoxels_mm(const Grid& fixed, const Grid& moving, double coarsest_mm, double finest_mm) {
  const auto least = [](const glm::dvec3& s) { return std::min({s.x, s.y, s.z}); };
  const double finest = std::max(finest_mm, std::min(least(fixed.spacing_mm), least(moving.spacing_mm)));
  std::vector<double> levels{finest};
  while (levels.back() * 2.0 <= coarsest_mm * 1.01) levels.push_back(levels.back() * 2.0);
  std::reverse(levels.begin(), levels.end());
  return levels;
}

Result<void> checkInput(const Input& input, const Message& side) {
  const Volume& volume = *input.volume;
  if (auto checked = checkGrid(volume.grid); !checked) return passOn(checked.error());
  const std::size_t n = volume.grid.voxelCount();
  if (volume.echo.size() != n) {
    return failure(ErrorCode::badField, say<"The %1 volume has %2 echo values for %3 voxels.">(side, volume.echo.size(), n));
  }
  if (!volume.coverage.empty() && volume.coverage.size() != n) {
    return failure(ErrorCode::badField, say<"The coverage of the %1 volume has %2 values for %3 voxels.">(side, volume.coverage.size(), n));
  }
  if (input.beams) {
    const double length = glm::length(input.beams->direction);
    if (!(length > 1e-6 && length < 1e6))
      return failure(ErrorCode::badField, say<"The direction of the beam of the %1 volume is no direction.">(side));
    if (const auto& fan = input.beams->fan) {
      const double farthest = std::max(glm::length(fan->from_mm), glm::length(fan->to_mm));
      if (!(farthest < 1e6)) return failure(ErrorCode::badField, say<"The apex of the beams of the %1 volume is no place.">(side));
    }
  }
  if (!input.confidence.empty()) {
    if (input.confidence.size() != n) {
      return failure(ErrorCode::badField,
                     say<"The confidence of the %1 volume has %2 values for %3 voxels.">(side, input.confidence.size(), n));
    }
    for (const float c : input.confidence) {
      if (!(c >= 0.0F && c <= 1.0F)) {
        return failure(ErrorCode::badField, say<"The confidence of the %1 volume has values outside 0 to 1.">(side));
      }
    }
  }
  if (!volume.coverage.empty() && std::all_of(volume.coverage.begin(), volume.coverage.end(), [](std::uint8_t c) { return c == 0; })) {
    return failure(ErrorCode::emptyVolume, say<"No voxel of the %1 volume was measured; choose a volume that holds an echo.">(side));
  }
  return {};
}

std::span<const float> usedConfidence(const Input& input) {
  const auto& coverage = input.volume->coverage;
  std::size_t covered = 0;
  std::size_t believed = 0;
  for (std::size_t q = 0; q < input.confidence.size(); ++q) {
    if (!coverage.empty() && coverage[q] == 0) continue;
    ++covered;
    believed += input.confidence[q] > kBelieved ? 1 : 0;
  }
  return believed < covered / kLeastBelieved ? std::span<const float>() : input.confidence;
}

Result<std::vector<ComparableImage>> comparableImages(const Input& input, std::span<const double> voxel_mm,
                                                      const ComparableOptions& options, Progress& progress) {
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"Registration was cancelled.">()); };
  const Volume& volume = *input.volume;
  const std::size_t n = volume.grid.voxelCount();
  const auto confidence = usedConfidence(input);
  Weighted image;
  image.grid = volume.grid;
  {
    const auto covered = coveredMask(volume, progress);
    if (!covered) return passOn(covered.error());
    const auto& mask = *covered;
    image.weight.resize(n);
    image.sum.resize(n);
    for (std::size_t q = 0; q < n; ++q) {
      const float w = mask[q] == 0 ? 0.0F : confidence.empty() ? 1.0F : confidence[q];
      image.weight[q] = w;
      image.sum[q] = w * volume.echo[q];
    }
  }
  std::vector<ComparableImage> levels(voxel_mm.size());
  for (std::size_t l = voxel_mm.size(); l-- > 0;) {
    const Grid grid = levelGrid(image.grid, voxel_mm[l]);
    if (!resample(image.sum, image.grid, grid, options.threads, progress)) return cancelled();
    if (!resample(image.weight, image.grid, grid, options.threads, progress)) return cancelled();
    image.grid = grid;
    Weighted level = image;
    if (voxel_mm[l] >= options.suppressFrom_mm) {
      const std::vector<float> binomial{0.25F, 0.5F, 0.25F};
      std::vector<float> soft = level.weight;
      if (!smoothWith(level.sum, grid.dims, binomial, options.threads, progress)) return cancelled();
      if (!smoothWith(soft, grid.dims, binomial, options.threads, progress)) return cancelled();
      // Smoothing fills from the neighbours but covers nothing that was not covered.
      for (std::size_t q = 0; q < soft.size(); ++q) {
        const float mean = soft[q] > 1e-6F ? level.sum[q] / soft[q] : 0.0F;
        if (level.weight[q] < 0.25F / 255.0F) level.weight[q] = 0.0F;
        level.sum[q] = mean * level.weight[q];
      }
    }
    // Voxels that straddle the rim of the covered area are mostly made of what lies beside it.
    if (confidence.empty()) {
      for (std::size_t q = 0; q < level.weight.size(); ++q) {
        const bool inside = level.weight[q] > 0.5F;
        level.sum[q] = inside ? level.sum[q] / level.weight[q] : 0.0F;
        level.weight[q] = inside ? 1.0F : 0.0F;
      }
    }
    const RowLayout rows{static_cast<std::size_t>(grid.dims.x)};
    if (input.beams && !takeOutAlong(grid, rows, *input.beams, kAlongBeam_mm, level.weight, level.sum, options.threads, progress))
      return cancelled();
    if (!normalise(std::move(level), options, levels[l], progress)) return cancelled();
  }
  return levels;
}

ComparableMemory forecastComparable(const Grid& grid, std::span<const double> voxel_mm) {
  ComparableMemory memory;
  std::uint64_t before = grid.voxelCount();
  Grid from = grid;
  for (std::size_t l = voxel_mm.size(); l-- > 0;) {
    from = levelGrid(from, voxel_mm[l]);
    const std::uint64_t n = from.voxelCount();
    // Two channels of the level, two of its copy, value, second moment and one pass's output on the way.
    memory.peak_bytes = std::max(memory.peak_bytes, memory.result_bytes + 8 * before + 4 * std::max(before, n));
    memory.peak_bytes = std::max(memory.peak_bytes, memory.result_bytes + 4 * n * 7);
    memory.result_bytes += n * 6;
    before = n;
  }
  memory.peak_bytes += memory.peak_bytes / 16 + (1u << 16);  // rows, taps and coarse moments
  return memory;
}

}  // namespace ew::registration
