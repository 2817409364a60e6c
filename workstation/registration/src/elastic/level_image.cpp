#include "elastic/level_image.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "comparable.h"
#include "ew/core/parallel.h"
#include "streaks.h"

namespace ew::registration {
namespace {

/// One axis of a resampling: out[i] = sum over n of weight[i][n] * in[first[i] + n].
struct Taps {
  int count = 1;
  std::vector<int> first;
  std::vector<float> weight;  // count per output
};

Taps tapsOf(int in, int out, double inPerOut, double sigma) {
  Taps taps;
  const int reach = std::max(1, static_cast<int>(std::ceil(2.6 * sigma)));
  taps.count = out == in ? 1 : std::min(in, 2 * reach + 2);
  taps.first.resize(static_cast<std::size_t>(out));
  taps.weight.resize(static_cast<std::size_t>(out) * static_cast<std::size_t>(taps.count));
  for (int i = 0; i < out; ++i) {
    const double centre = (i + 0.5) * inPerOut - 0.5;
    const int low = std::clamp(static_cast<int>(std::floor(centre)) - (taps.count - 1) / 2, 0, in - taps.count);
    taps.first[static_cast<std::size_t>(i)] = low;
    float* weight = taps.weight.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(taps.count);
    double sum = 0.0;
    for (int n = 0; n < taps.count; ++n) {
      // A Gaussian blur of the linear interpolation; without blur the interpolation alone.
      const double off = low + n - centre;
      const double value = sigma > 0.0 ? std::exp(-0.5 * off * off / (sigma * sigma + 1.0 / 12.0)) : std::max(0.0, 1.0 - std::abs(off));
      weight[n] = static_cast<float>(value);
      sum += value;
    }
    for (int n = 0; n < taps.count; ++n)
      weight[n] = sum > 0.0 ? weight[n] / static_cast<float>(sum) : 1.0F / static_cast<float>(taps.count);
  }
  return taps;
}

/// Values (and weights) of the input, resampled along x and y, one slice after the other.
struct Slices {
  std::vector<float> sum;     // of value times belief
  std::vector<float> weight;  // of belief; empty without belief
};

void addRow(float factor, const float* in, int count, float* out) {
  for (int i = 0; i < count; ++i) out[i] += factor * in[i];
}

/// How a volume is brought to a level: its size, and along each axis which voxels a sample is made of.
std::array<Taps, 3> layOutLevel(const Grid& grid, double voxel_mm, LevelImage& level) {
  std::array<Taps, 3> taps;
  for (int axis = 0; axis < 3; ++axis) {
    const double spacing = grid.spacing_mm[axis];
    const int in = grid.dims[axis];
    const int out = voxel_mm < 1.3 * spacing ? in : std::clamp(static_cast<int>(std::lround(in * spacing / voxel_mm)), 1, in);
    const double inPerOut = static_cast<double>(in) / out;
    taps[static_cast<std::size_t>(axis)] = tapsOf(in, out, inPerOut, out == in ? 0.0 : 0.5 * (inPerOut - 1.0) + 0.3);
    level.dims[axis] = out;
    level.spacing_mm[axis] = spacing * inPerOut;
    level.first_mm[axis] = 0.5 * (inPerOut - 1.0) * spacing;
  }
  level.stride = strideOf(level.dims.x);
  return taps;
}

/// Voxels as they are: the level has the volume's own grid.
bool copyVoxels(const Volume& volume, const std::vector<std::uint8_t>& belief, int threads, Progress& progress, LevelImage& level) {
  const auto width = static_cast<std::size_t>(level.dims.x);
  return forEachTask(level.dims.z, threads, progress, say<"Preparing the images">(), [&](int k) {
    for (int j = 0; j < level.dims.y; ++j) {
      const std::size_t in = volume.grid.indexOf(0, j, k), out = level.rowOf(j, k);
      for (std::size_t i = 0; i < width; ++i) level.values[out + i] = static_cast<float>(volume.echo[in + i]);
      if (!belief.empty()) {
        for (std::size_t i = 0; i < width; ++i) level.weights[out + i] = static_cast<float>(belief[in + i]) * (1.0F / 255.0F);
      }
    }
  });
}

void resampleRow(const Taps& x, const std::vector<float>& in, std::vector<float>& row) {
  if (x.count == 1) {
    std::copy(in.begin(), in.end(), row.begin());
    return;
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    const float* values = in.data() + x.first[i];
    const float* weight = x.weight.data() + i * static_cast<std::size_t>(x.count);
    float sum = 0.0F;
    for (int n = 0; n < x.count; ++n) sum += weight[n] * values[n];
    row[i] = sum;
  }
}

/// One slice along x and y. Rows of the input come one after the other; each is a part of `count` rows of the output at most.
/// @param source source(j, in) writes row j of the input
template <class Source>
void resampleSlice(const Taps& x, const Taps& y, const glm::ivec3& from, const glm::ivec3& to, const Source& source, float* slice) {
  const auto width = static_cast<std::size_t>(to.x);
  std::vector<float> in(static_cast<std::size_t>(from.x)), row(width);
  std::fill(slice, slice + width * static_cast<std::size_t>(to.y), 0.0F);
  int first = 0;
  for (int j = 0; j < from.y; ++j) {
    while (first < to.y && y.first[static_cast<std::size_t>(first)] + y.count <= j) ++first;
    if (first == to.y) break;
    if (y.first[static_cast<std::size_t>(first)] > j) continue;
    source(j, in);
    resampleRow(x, in, row);
    for (int out = first; out < to.y && y.first[static_cast<std::size_t>(out)] <= j; ++out) {
      const int tap = j - y.first[static_cast<std::size_t>(out)];
      if (tap >= y.count) continue;
      addRow(y.weight[static_cast<std::size_t>(out * y.count + tap)], row.data(), to.x, slice + static_cast<std::size_t>(out) * width);
    }
  }
}

bool resampleInPlane(const Volume& volume, const std::vector<std::uint8_t>& belief, const std::array<Taps, 3>& taps, const glm::ivec3& dims,
                     int threads, Progress& progress, Slices& slices) {
  const Grid& grid = volume.grid;
  const std::size_t perSlice = static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y);
  slices.sum.resize(perSlice * static_cast<std::size_t>(grid.dims.z));
  if (!belief.empty()) slices.weight.resize(slices.sum.size());
  return forEachTask(grid.dims.z, threads, progress, say<"Preparing the images">(), [&](int k) {
    const std::size_t at = static_cast<std::size_t>(k) * perSlice;
    const auto believedEcho = [&](int j, std::vector<float>& into) {
      const std::size_t from = grid.indexOf(0, j, k);
      for (std::size_t i = 0; i < into.size(); ++i) into[i] = static_cast<float>(volume.echo[from + i]);
      if (!belief.empty()) {
        for (std::size_t i = 0; i < into.size(); ++i) into[i] *= static_cast<float>(belief[from + i]) * (1.0F / 255.0F);
      }
    };
    resampleSlice(taps[0], taps[1], grid.dims, dims, believedEcho, slices.sum.data() + at);
    if (belief.empty()) return;
    const auto beliefAlone = [&](int j, std::vector<float>& into) {
      const std::size_t from = grid.indexOf(0, j, k);
      for (std::size_t i = 0; i < into.size(); ++i) into[i] = static_cast<float>(belief[from + i]) * (1.0F / 255.0F);
    };
    resampleSlice(taps[0], taps[1], grid.dims, dims, beliefAlone, slices.weight.data() + at);
  });
}

bool resampleAcross(const Slices& slices, const Taps& z, int threads, Progress& progress, LevelImage& level) {
  const auto width = static_cast<std::size_t>(level.dims.x), perSlice = width * static_cast<std::size_t>(level.dims.y);
  const bool weighted = !slices.weight.empty();
  return forEachTask(level.dims.z, threads, progress, say<"Preparing the images">(), [&](int k) {
    for (int j = 0; j < level.dims.y; ++j) {
      float* row = level.values.data() + level.rowOf(j, k);
      float* rowWeight = weighted ? level.weights.data() + level.rowOf(j, k) : nullptr;
      for (int n = 0; n < z.count; ++n) {
        const float factor = z.weight[static_cast<std::size_t>(k * z.count + n)];
        const std::size_t from =
            static_cast<std::size_t>(z.first[static_cast<std::size_t>(k)] + n) * perSlice + static_cast<std::size_t>(j) * width;
        addRow(factor, slices.sum.data() + from, level.dims.x, row);
        if (weighted) addRow(factor, slices.weight.data() + from, level.dims.x, rowWeight);
      }
      if (!weighted) continue;
      for (int i = 0; i < level.dims.x; ++i) {
        // Less than a tenth known: the value would be one of a few voxels at its edge.
        if (rowWeight[i] < 0.1F) {
          rowWeight[i] = row[i] = 0.0F;
        } else {
          row[i] /= rowWeight[i];
        }
      }
    }
  });
}

/// Gaussian blur of a small block image along one axis, in place.
void blur(std::vector<double>& image, const glm::ivec3& dims, int axis, double sigma) {
  const int n = dims[axis];
  if (n == 1 || sigma <= 0.0) return;
  std::vector<double> weight(static_cast<std::size_t>(n));
  const int reach = static_cast<int>(3.5 * sigma + 1.0);
  for (int i = 0; i < n; ++i) weight[static_cast<std::size_t>(i)] = i > 3.5 * sigma + 1.0 ? 0.0 : std::exp(-0.5 * i * i / (sigma * sigma));
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(dims.x),
                                          static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y)};
  const std::size_t step = stride[static_cast<std::size_t>(axis)];
  std::vector<double> line(static_cast<std::size_t>(n));
  for (std::size_t start = 0; start < image.size(); ++start) {
    if (start / step % static_cast<std::size_t>(n) != 0) continue;
    for (int i = 0; i < n; ++i) line[static_cast<std::size_t>(i)] = image[start + static_cast<std::size_t>(i) * step];
    for (int i = 0; i < n; ++i) {
      double sum = 0.0;
      for (int m = std::max(0, i - reach); m <= std::min(n - 1, i + reach); ++m)
        sum += weight[static_cast<std::size_t>(std::abs(i - m))] * line[static_cast<std::size_t>(m)];
      image[start + static_cast<std::size_t>(i) * step] = sum;
    }
  }
}

constexpr double kGreyFloor = 12.0;  // grey levels of deviation that noise alone may have: flat areas are not blown up to structure

constexpr double kBrightness_mm = 2.0;  // smooth enough for speckle to count little, fine enough for a shadow of a few millimetres

/// Sums over blocks of weight, weight times value and weight times value squared.
using Moments = std::array<std::vector<double>, 3>;
bool momentsOf(const LevelImage& level, const BlockMap& map, int threads, Progress& progress, Moments& moments) {
  const glm::ivec3 size = map.size, blocks = map.blocks;
  for (auto& moment : moments) moment.assign(map.count(), 0.0);
  return forEachTask(blocks.z, threads, progress, say<"Preparing the images">(), [&](int slab) {
    const int last = std::min(level.dims.z, (slab + 1) * size.z);
    for (int k = slab * size.z; k < last; ++k) {
      for (int j = 0; j < level.dims.y; ++j) {
        const float* value = level.values.data() + level.rowOf(j, k);
        const float* weight = level.weights.empty() ? nullptr : level.weights.data() + level.rowOf(j, k);
        for (int b = 0; b < blocks.x; ++b) {
          float sums[3] = {0.0F, 0.0F, 0.0F};
          const int end = std::min(level.dims.x, (b + 1) * size.x);
          for (int i = b * size.x; i < end; ++i) {
            const float w = weight != nullptr ? weight[i] : 1.0F;
            sums[0] += w;
            sums[1] += w * value[i];
            sums[2] += w * value[i] * value[i];
          }
          const std::size_t at = map.indexOf(b, j / size.y, slab);
          for (std::size_t m = 0; m < 3; ++m) moments[m][at] += static_cast<double>(sums[m]);
        }
      }
    }
  });
}

/// What runs along the beams, out of `level`, whose values are grey levels.
bool takeOut(const Beams& along, const Grid& volume, int threads, Progress& progress, LevelImage& level) {
  Grid grid = volume;
  grid.dims = level.dims;
  grid.spacing_mm = level.spacing_mm;
  grid.origin_mm = volume.origin_mm + volume.directions * level.first_mm;
  const auto weigh = [&](bool undo) {
    for (std::size_t n = 0; n < level.weights.size(); ++n) {
      const float w = level.weights[n];
      level.values[n] = undo ? (w > 0.0F ? level.values[n] / w : 0.0F) : level.values[n] * w;
    }
  };
  weigh(false);
  if (!takeOutAlong(grid, {static_cast<std::size_t>(level.stride), level.rowOf(0, 0)}, along, kAlongBeam_mm, level.weights, level.values,
                    threads, progress))
    return false;
  weigh(true);
  return true;
}

/// Takes local mean and deviation out of `level`, whose values are grey levels. Both are smooth, so blocks of about 3 mm suffice.
bool normalise(const Grid& volume, const Beams* along, double window_mm, int threads, Progress& progress, LevelImage& level) {
  BlockMap mean(level, 0.4 * window_mm);
  Moments moments;
  if (!momentsOf(level, mean, threads, progress, moments)) return false;
  level.brightness = mean;
  std::array<std::vector<double>, 2> near{moments[0], moments[1]};
  if (along != nullptr && (!takeOut(*along, volume, threads, progress, level) || !momentsOf(level, mean, threads, progress, moments)))
    return false;
  // One task per image to be smoothed: each is added up in one order.
  if (!forEachTask(5, threads, progress, say<"Preparing the images">(), [&](int task) {
        const auto n = static_cast<std::size_t>(task);
        blurBlocks(n < 3 ? moments[n] : near[n - 3], mean, level.spacing_mm, n < 3 ? window_mm : kBrightness_mm);
      }))
    return false;
  for (std::size_t n = 0; n < mean.values.size(); ++n)
    level.brightness.values[n] = near[0][n] > 1e-6 ? static_cast<float>(near[1][n] / near[0][n]) : -1.0F;
  BlockMap gain = mean;
  for (std::size_t n = 0; n < mean.values.size(); ++n) {
    const double weight = moments[0][n];
    if (weight < 1e-6) continue;
    const double m = moments[1][n] / weight;
    mean.values[n] = static_cast<float>(m);
    gain.values[n] = static_cast<float>(1.0 / (std::sqrt(std::max(0.0, moments[2][n] / weight - m * m)) + kGreyFloor));
  }
  return forEachTask(level.dims.z, threads, progress, say<"Preparing the images">(), [&](int k) {
    std::vector<float> line, rowMean(static_cast<std::size_t>(level.dims.x)), rowGain(rowMean.size());
    for (int j = 0; j < level.dims.y; ++j) {
      mean.row(j, k, level.dims.x, line, rowMean.data());
      gain.row(j, k, level.dims.x, line, rowGain.data());
      float* row = level.values.data() + level.rowOf(j, k);
      for (int i = 0; i < level.dims.x; ++i)
        row[i] = (row[i] - rowMean[static_cast<std::size_t>(i)]) * rowGain[static_cast<std::size_t>(i)];
      if (!level.weights.empty()) {
        const float* weight = level.weights.data() + level.rowOf(j, k);
        for (int i = 0; i < level.dims.x; ++i) {
          if (weight[i] <= 0.0F) row[i] = 0.0F;
        }
      }
      const int last = level.dims.x - 1;
      row[-1] = last > 0 ? 2.0F * row[0] - row[1] : row[0];
      row[last + 1] = last > 0 ? 2.0F * row[last] - row[last - 1] : row[0];
    }
  });
}

/// A difference across the edge of what is known is none of tissue: weights become the least of a voxel and its six neighbours.
void shrinkWeights(LevelImage& level) {
  const std::vector<float> before = level.weights;
  for (int k = 0; k < level.dims.z; ++k) {
    for (int j = 0; j < level.dims.y; ++j) {
      for (int i = 0; i < level.dims.x; ++i) {
        float least = before[level.rowOf(j, k) + static_cast<std::size_t>(i)];
        const auto look = [&](int x, int y, int z) {
          if (x >= 0 && y >= 0 && z >= 0 && x < level.dims.x && y < level.dims.y && z < level.dims.z)
            least = std::min(least, before[level.rowOf(y, z) + static_cast<std::size_t>(x)]);
        };
        look(i - 1, j, k), look(i + 1, j, k), look(i, j - 1, k), look(i, j + 1, k), look(i, j, k - 1), look(i, j, k + 1);
        level.weights[level.rowOf(j, k) + static_cast<std::size_t>(i)] = least;
      }
    }
  }
}

}  // namespace

BlockMap::BlockMap(const LevelImage& image, double block_mm) {
  for (int axis = 0; axis < 3; ++axis) {
    size[axis] = std::max(1, static_cast<int>(std::lround(block_mm / image.spacing_mm[axis])));
    blocks[axis] = (image.dims[axis] + size[axis] - 1) / size[axis];
  }
  values.assign(count(), 0.0F);
}

void BlockMap::row(int j, int k, int width, std::vector<float>& line, float* out) const {
  const auto place = [&](int sample, int axis, int& low, int& high) {
    const double at = std::clamp((sample + 0.5) / size[axis] - 0.5, 0.0, static_cast<double>(blocks[axis] - 1));
    low = static_cast<int>(at);
    high = std::min(low + 1, blocks[axis] - 1);
    return static_cast<float>(at - low);
  };
  int y0, y1, z0, z1;
  const float ty = place(j, 1, y0, y1), tz = place(k, 2, z0, z1);
  line.resize(static_cast<std::size_t>(blocks.x));
  for (int b = 0; b < blocks.x; ++b) {
    const float low = values[indexOf(b, y0, z0)] + ty * (values[indexOf(b, y1, z0)] - values[indexOf(b, y0, z0)]);
    const float high = values[indexOf(b, y0, z1)] + ty * (values[indexOf(b, y1, z1)] - values[indexOf(b, y0, z1)]);
    line[static_cast<std::size_t>(b)] = low + tz * (high - low);
  }
  // Samples between the centres of blocks b and b + 1, one run after the other.
  const float perSize = 1.0F / static_cast<float>(size.x);
  for (int b = -1, i = 0; i < width; ++b) {
    const float low = line[static_cast<std::size_t>(std::clamp(b, 0, blocks.x - 1))];
    const float rise = line[static_cast<std::size_t>(std::clamp(b + 1, 0, blocks.x - 1))] - low;
    const int end = std::min(width, (2 * (b + 1) * size.x + size.x) / 2);  // the first sample at or beyond the centre of b + 1
    const float first = (static_cast<float>(i) + 0.5F) * perSize - 0.5F - static_cast<float>(b);
    const int start = i;
    for (; i < end; ++i) out[i] = low + rise * (first + static_cast<float>(i - start) * perSize);
  }
}

float BlockMap::at(const glm::dvec3& sample) const {
  const glm::dvec3 place = glm::clamp((sample + 0.5) / glm::dvec3(size) - 0.5, glm::dvec3(0.0), glm::dvec3(blocks - 1));
  const glm::ivec3 low(place);
  const glm::vec3 share(place - glm::dvec3(low));
  float sum = 0.0F, total = 0.0F;
  for (int n = 0; n < 8; ++n) {
    const glm::ivec3 up(n & 1, n >> 1 & 1, n >> 2 & 1), corner = glm::min(low + up, blocks - 1);
    const float value = values[indexOf(corner.x, corner.y, corner.z)];
    if (value < 0.0F) continue;
    float weight = 1.0F;
    for (int axis = 0; axis < 3; ++axis) weight *= up[axis] != 0 ? share[axis] : 1.0F - share[axis];
    sum += weight * value;
    total += weight;
  }
  return total > 0.5F ? sum / total : -1.0F;
}

void blurBlocks(std::vector<double>& values, const BlockMap& map, const glm::dvec3& spacing_mm, double sigma_mm) {
  for (int axis = 0; axis < 3; ++axis) {
    const double block_mm = map.size[axis] * spacing_mm[axis];
    blur(values, map.blocks, axis, std::sqrt(std::max(0.0, sigma_mm * sigma_mm - block_mm * block_mm / 12.0)) / block_mm);
  }
}

int strideOf(int width) { return (width + 2 + 15) / 16 * 16; }

std::size_t LevelImage::floats() const {
  return static_cast<std::size_t>(dims.z) * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(stride) + kOverrun;
}

std::vector<std::uint8_t> beliefOf(const Input& input) {
  std::vector<std::uint8_t> belief = coveredMask(*input.volume);
  if (const auto confidence = usedConfidence(input); !confidence.empty()) {
    for (std::size_t n = 0; n < belief.size(); ++n)
      belief[n] = static_cast<std::uint8_t>(std::lround(static_cast<float>(belief[n]) * std::clamp(confidence[n], 0.0F, 1.0F)));
  }
  if (std::all_of(belief.begin(), belief.end(), [](std::uint8_t b) { return b == 255; })) belief.clear();
  return belief;
}

bool makeLevel(const Input& input, const std::vector<std::uint8_t>& belief, double voxel_mm, double window_mm, int threads,
               Progress& progress, LevelImage& level, const Beams* along) {
  const Volume& volume = *input.volume;
  const std::array<Taps, 3> taps = layOutLevel(volume.grid, voxel_mm, level);
  level.values.assign(level.floats(), 0.0F);
  level.weights.clear();
  if (!belief.empty()) level.weights.assign(level.floats(), 0.0F);
  if (level.dims == volume.grid.dims) {
    if (!copyVoxels(volume, belief, threads, progress, level)) return false;
  } else {
    Slices slices;
    if (!resampleInPlane(volume, belief, taps, level.dims, threads, progress, slices) ||
        !resampleAcross(slices, taps[2], threads, progress, level))
      return false;
  }
  if (!normalise(volume.grid, along, window_mm, threads, progress, level)) return false;
  if (!belief.empty()) shrinkWeights(level);
  return true;
}

}  // namespace ew::registration
