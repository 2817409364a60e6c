#include "elastic/level_pair.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "ew/core/contract.h"
#include "ew/core/order_statistics.h"
#include "ew/core/parallel.h"

namespace ew::registration {

AxesTransform axesTransformOf(const Grid& fixed, const Grid& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving) {
  const glm::dmat3 back = glm::inverse(moving.directions);
  AxesTransform result;
  result.turn = back * glm::dmat3(fixedToMoving.matrix) * fixed.directions;
  result.shift_mm = back * (carried(fixedToMoving, fixed.origin_mm) - moving.origin_mm);
  return result;
}

double PairSums::correlation() const {
  const double n = at[0];
  if (!(n > 0.0)) return 0.0;
  const double ff = at[4] - at[2] * at[2] / n, ww = at[5] - at[3] * at[3] / n, fw = at[6] - at[2] * at[3] / n;
  return ff > 1e-9 * n && ww > 1e-9 * n ? fw / std::sqrt(ff * ww) : 0.0;
}

double PairSums::residualVolume(const glm::ivec3& dims) const {
  double volume = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (dims[axis] == 1 || !(at[7] > 0.0)) continue;
    // A Gaussian of the same correlation at distance one: the sum of its correlations over all distances.
    const double next = std::clamp(at[static_cast<std::size_t>(8 + axis)] / at[7], 0.0, 0.95);
    double sum = 1.0;
    for (int n = 1; n < 12; ++n) sum += 2.0 * std::pow(next, n * n);
    volume *= sum;
  }
  return volume;
}

LevelPair::LevelPair(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& fixedToMoving, const NodeGrid& nodes,
                     int threads)
    : fixed_(&fixed), moving_(&moving), nodes_(nodes), threads_(threads) {
  const glm::dvec3 perSpacing = 1.0 / moving.spacing_mm;
  for (int column = 0; column < 3; ++column) perMm_[column] = fixedToMoving.turn[column] * perSpacing;
  firstIndex_ = perMm_ * fixed.first_mm + (fixedToMoving.shift_mm - moving.first_mm) * perSpacing;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const int cells = nodes.cells()[axis];
    begin_[a].assign(static_cast<std::size_t>(cells) + 1, fixed.dims[axis]);
    for (int i = fixed.dims[axis] - 1; i >= 0; --i) {
      const double at =
          nodes.dims[axis] == 1
              ? 0.0
              : std::clamp((fixed.first_mm[axis] + i * fixed.spacing_mm[axis] - nodes.first_mm[axis]) / nodes.spacing_mm[axis], 0.0,
                           static_cast<double>(cells));
      const int cell = std::min(static_cast<int>(at), cells - 1);
      cell_[a].push_back(cell);
      share_[a].push_back(static_cast<float>(at - cell));
      for (int c = cell; c >= 0 && begin_[a][static_cast<std::size_t>(c)] > i; --c) begin_[a][static_cast<std::size_t>(c)] = i;
    }
    std::reverse(cell_[a].begin(), cell_[a].end());
    std::reverse(share_[a].begin(), share_[a].end());
    // Cells before the first sample's begin where it stands; cells without samples end where they begin.
    begin_[a][0] = 0;
    for (std::size_t c = static_cast<std::size_t>(cells); c-- > 0;) begin_[a][c] = std::min(begin_[a][c], begin_[a][c + 1]);
  }
  const auto stride = static_cast<std::size_t>(fixed.stride) + kOverrun;
  along_.assign(5 * stride, 0.0F);
  for (std::size_t i = 0; i < share_[0].size(); ++i) {
    const float s = share_[0][i];
    along_[i] = (1.0F - s) * (1.0F - s);
    along_[stride + i] = s * (1.0F - s);
    along_[2 * stride + i] = s * s;
    along_[3 * stride + i] = 1.0F - s;
    along_[4 * stride + i] = s;
  }
  cell_[0].resize(stride, cell_[0].back());
  share_[0].resize(stride, 0.0F);
  moved_.assign(fixed.floats(), 0.0F);
  movedWeights_.assign(fixed.floats(), 0.0F);
}

bool LevelPair::warp(const NodeValues& values, Progress& progress) {
  EW_EXPECTS(values.size() == 4 * nodes_.count());
  const glm::ivec3 dims = fixed_->dims;
  return forEachTask(dims.z, threads_, progress, say<"Registering">(), [&](int k) {
    const auto lineFloats = static_cast<std::size_t>(nodes_.dims.x);
    std::vector<float> lines(8 * lineFloats);
    std::vector<float> row(static_cast<std::size_t>(fixed_->stride) + kOverrun), rowWeights(row.size()), rowTrust(row.size()), trustLine;
    RowField field;
    for (std::size_t c = 0; c < 4; ++c) {
      field.low[c] = lines.data() + c * lineFloats;
      field.rise[c] = lines.data() + (4 + c) * lineFloats;
    }
    field.cell = cell_[0].data();
    field.share = share_[0].data();
    RowSource source;
    source.values = moving_->values.data() + 1;
    source.weights = moving_->weights.empty() ? nullptr : moving_->weights.data() + 1;
    source.rowStride = moving_->stride;
    source.sliceStride = moving_->stride * moving_->dims.y;
    for (int axis = 0; axis < 3; ++axis) {
      source.dims[axis] = moving_->dims[axis];
      source.step[axis] = static_cast<float>(perMm_[0][axis] * fixed_->spacing_mm.x);
      for (int c = 0; c < 3; ++c) source.perMm[3 * axis + c] = static_cast<float>(perMm_[c][axis]);
    }
    const int z = cell_[2][static_cast<std::size_t>(k)], zNext = std::min(z + 1, nodes_.dims.z - 1);
    const float zShare = share_[2][static_cast<std::size_t>(k)];
    for (int j = 0; j < dims.y; ++j) {
      const int y = cell_[1][static_cast<std::size_t>(j)], yNext = std::min(y + 1, nodes_.dims.y - 1);
      const float yShare = share_[1][static_cast<std::size_t>(j)];
      for (int i = 0; i < nodes_.dims.x; ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
          const auto at = [&](int v, int w) { return values[4 * nodes_.indexOf(i, v, w) + c]; };
          const float low = at(y, z) + yShare * (at(yNext, z) - at(y, z)), high = at(y, zNext) + yShare * (at(yNext, zNext) - at(y, zNext));
          lines[c * lineFloats + static_cast<std::size_t>(i)] = low + zShare * (high - low);
        }
      }
      for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t i = 0; i + 1 < lineFloats; ++i)
          lines[(4 + c) * lineFloats + i] = lines[c * lineFloats + i + 1] - lines[c * lineFloats + i];
      }
      const glm::dvec3 first = firstIndex_ + perMm_ * glm::dvec3(0.0, j * fixed_->spacing_mm.y, k * fixed_->spacing_mm.z);
      for (int axis = 0; axis < 3; ++axis) source.first[axis] = static_cast<float>(first[axis]);
      sampleRow(field, source, dims.x, row.data(), rowWeights.data());
      const std::size_t at = fixed_->rowOf(j, k);
      float* to = moved_.data() + at;
      std::copy(row.begin(), row.begin() + dims.x, to);
      to[-1] = dims.x > 1 ? 2.0F * row[0] - row[1] : row[0];
      to[dims.x] = dims.x > 1 ? 2.0F * to[dims.x - 1] - to[dims.x - 2] : row[0];
      if (!trust_.values.empty()) {
        trust_.row(j, k, dims.x, trustLine, rowTrust.data());
        for (int i = 0; i < dims.x; ++i) rowWeights[static_cast<std::size_t>(i)] *= rowTrust[static_cast<std::size_t>(i)];
      }
      std::copy(rowWeights.begin(), rowWeights.begin() + dims.x, movedWeights_.begin() + static_cast<std::ptrdiff_t>(at));
    }
  });
}

bool LevelPair::believe(BlockMap map, Progress& progress) {
  // What was warped last is worth as much as what will be.
  if (!forEachTask(fixed_->dims.z, threads_, progress, say<"Registering">(), [&](int k) {
        std::vector<float> line, row(static_cast<std::size_t>(fixed_->dims.x));
        for (int j = 0; j < fixed_->dims.y; ++j) {
          map.row(j, k, fixed_->dims.x, line, row.data());
          float* weights = movedWeights_.data() + fixed_->rowOf(j, k);
          for (std::size_t i = 0; i < row.size(); ++i) weights[i] *= row[i];
        }
      }))
    return false;
  if (trust_.values.empty()) {
    trust_ = std::move(map);
    return true;
  }
  return forEachTask(trust_.blocks.z, threads_, progress, say<"Registering">(), [&](int k) {
    for (int j = 0; j < trust_.blocks.y; ++j) {
      for (int i = 0; i < trust_.blocks.x; ++i) trust_.values[trust_.indexOf(i, j, k)] *= map.at(trust_.centreOf(i, j, k));
    }
  });
}

glm::dvec3 LevelPair::displacementAt(const NodeValues& values, const glm::dvec3& sample) const {
  const glm::dvec3 at = glm::clamp((fixed_->first_mm + sample * fixed_->spacing_mm - nodes_.first_mm) / nodes_.spacing_mm, glm::dvec3(0.0),
                                   glm::dvec3(nodes_.dims - 1));
  const glm::ivec3 low(at);
  const glm::dvec3 share = at - glm::dvec3(low);
  glm::dvec3 sum(0.0);
  for (int n = 0; n < 8; ++n) {
    const glm::ivec3 up(n & 1, n >> 1 & 1, n >> 2 & 1), corner = glm::min(low + up, nodes_.dims - 1);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) weight *= up[axis] != 0 ? share[axis] : 1.0 - share[axis];
    const float* v = values.data() + 4 * nodes_.indexOf(corner.x, corner.y, corner.z);
    sum += weight * glm::dvec3(v[0], v[1], v[2]);
  }
  return sum;
}

bool LevelPair::doubtShadows(const NodeValues& values, Progress& progress) {
  constexpr double kTrend_mm = 12.0;   // wider than shadows, narrow enough to follow the depth gain
  constexpr float kUnusual = 3.0F;     // deviations at which a sample counts half
  constexpr float kLeast = 0.2F;       // what a sample always counts: most shadows still let some tissue through
  constexpr float kLeastScale = 4.0F;  // grey levels
  constexpr std::size_t kFewest = 64;
  BlockMap map = fixed_->brightness;
  constexpr float kUnknown = 1e9F;
  std::vector<float> darker(map.count(), kUnknown);  // by how much the moving image is
  if (!forEachTask(map.blocks.z, threads_, progress, say<"Registering">(), [&](int k) {
        for (int j = 0; j < map.blocks.y; ++j) {
          for (int i = 0; i < map.blocks.x; ++i) {
            const std::size_t at = map.indexOf(i, j, k);
            const glm::dvec3 sample = glm::min(map.centreOf(i, j, k), glm::dvec3(fixed_->dims - 1));
            const glm::dvec3 index = firstIndex_ + perMm_ * (sample * fixed_->spacing_mm + displacementAt(values, sample));
            if (map.values[at] < 0.0F || glm::any(glm::lessThan(index, glm::dvec3(-0.5))) ||
                glm::any(glm::greaterThan(index, glm::dvec3(moving_->dims) - 0.5)))
              continue;
            const float there = moving_->brightness.at(index);
            if (there >= 0.0F) darker[at] = map.values[at] - there;
          }
        }
      }))
    return false;
  std::vector<float> sorted;
  for (const float d : darker) {
    if (d < kUnknown) sorted.push_back(d);
  }
  if (sorted.size() < kFewest) return true;
  // How the images differ around: gains that change slowly. Blocks far from it count little, or a shadow would become the rule beneath it.
  const float usual = upperMedianOf(std::span(sorted));
  std::vector<float> around(map.count(), usual);
  float scale = kLeastScale;
  for (int round = 0; round < 4; ++round) {
    sorted.clear();
    for (std::size_t n = 0; n < darker.size(); ++n) {
      if (darker[n] < kUnknown) sorted.push_back(std::abs(darker[n] - around[n]));
    }
    scale = std::max(kLeastScale, 1.48F * upperMedianOf(std::span(sorted)));
    if (round == 3) break;
    BlockMap trend(*fixed_, kTrend_mm / 3.0);
    std::vector<double> sum(trend.count(), 0.0), weight(trend.count(), 0.0);
    for (int k = 0; k < map.blocks.z; ++k) {
      for (int j = 0; j < map.blocks.y; ++j) {
        for (int i = 0; i < map.blocks.x; ++i) {
          const std::size_t at = map.indexOf(i, j, k);
          if (darker[at] == kUnknown) continue;
          const glm::ivec3 in = glm::min(glm::ivec3(map.centreOf(i, j, k)) / trend.size, trend.blocks - 1);
          const std::size_t to = trend.indexOf(in.x, in.y, in.z);
          const float off = (darker[at] - around[at]) / (kUnusual * scale), w = 1.0F / ((1.0F + off * off) * (1.0F + off * off));
          sum[to] += static_cast<double>(w * (darker[at] - usual));
          weight[to] += static_cast<double>(w);
        }
      }
    }
    blurBlocks(sum, trend, fixed_->spacing_mm, kTrend_mm);
    blurBlocks(weight, trend, fixed_->spacing_mm, kTrend_mm);
    constexpr float kAbove = 1e4F;  // a block map takes negative values for unknown ones
    for (std::size_t n = 0; n < sum.size(); ++n)
      trend.values[n] = kAbove + (weight[n] > 1e-6 ? static_cast<float>(sum[n] / weight[n]) : 0.0F);
    if (!forEachTask(map.blocks.z, threads_, progress, say<"Registering">(), [&](int k) {
          for (int j = 0; j < map.blocks.y; ++j) {
            for (int i = 0; i < map.blocks.x; ++i) around[map.indexOf(i, j, k)] = usual + trend.at(map.centreOf(i, j, k)) - kAbove;
          }
        }))
      return false;
  }
  for (std::size_t n = 0; n < darker.size(); ++n) {
    const float off = darker[n] < kUnknown ? (darker[n] - around[n]) / (kUnusual * scale) : 0.0F;
    const float off2 = off * off, off4 = off2 * off2;
    map.values[n] = std::max(kLeast, 1.0F / (1.0F + off4 * off4));
  }
  return believe(std::move(map), progress);
}

bool LevelPair::trustAgreement(double window_mm, double least, double power, Progress& progress) {
  BlockMap map(*fixed_, 0.5 * window_mm);
  std::array<std::vector<double>, 6> moments;  // weight, f, w, ff, ww, fw
  for (auto& moment : moments) moment.assign(map.count(), 0.0);
  if (!forEachTask(map.blocks.z, threads_, progress, say<"Registering">(), [&](int slab) {
        const int last = std::min(fixed_->dims.z, (slab + 1) * map.size.z);
        for (int k = slab * map.size.z; k < last; ++k) {
          for (int j = 0; j < fixed_->dims.y; ++j) {
            const std::size_t row = fixed_->rowOf(j, k);
            for (int b = 0; b < map.blocks.x; ++b) {
              float sums[6] = {};
              const int end = std::min(fixed_->dims.x, (b + 1) * map.size.x);
              for (int i = b * map.size.x; i < end; ++i) {
                const std::size_t at = row + static_cast<std::size_t>(i);
                const float f = fixed_->values[at], w = moved_[at];
                const float both = movedWeights_[at] * (fixed_->weights.empty() ? 1.0F : fixed_->weights[at]);
                sums[0] += both;
                sums[1] += both * f;
                sums[2] += both * w;
                sums[3] += both * f * f;
                sums[4] += both * w * w;
                sums[5] += both * f * w;
              }
              const std::size_t at = map.indexOf(b, j / map.size.y, slab);
              for (std::size_t m = 0; m < 6; ++m) moments[m][at] += static_cast<double>(sums[m]);
            }
          }
        }
      }))
    return false;
  const auto correlationOf = [](const std::array<double, 6>& m) {
    if (!(m[0] > 0.0)) return 0.0;
    const double ff = m[3] - m[1] * m[1] / m[0], ww = m[4] - m[2] * m[2] / m[0], fw = m[5] - m[1] * m[2] / m[0];
    return ff > 1e-9 * m[0] && ww > 1e-9 * m[0] ? fw / std::sqrt(ff * ww) : 0.0;
  };
  std::array<double, 6> all{};
  for (std::size_t m = 0; m < 6; ++m) {
    for (const double v : moments[m]) all[m] += v;
    blurBlocks(moments[m], map, fixed_->spacing_mm, window_mm);
  }
  const double overall = correlationOf(all);
  if (overall < 0.05) return true;  // nothing to measure by
  for (std::size_t n = 0; n < map.values.size(); ++n) {
    std::array<double, 6> here{};
    for (std::size_t m = 0; m < 6; ++m) here[m] = moments[m][n];
    map.values[n] = static_cast<float>(std::pow(std::clamp(correlationOf(here) / overall, least, 1.0), power));
  }
  return believe(std::move(map), progress);
}

namespace {

constexpr std::size_t kCellProducts = 27 * std::size_t{kProducts}, kCellRight = 32, kCellMoments = kCellProducts + kCellRight;

/// What rows of one line of cells (one y, one z of cells) add up to, sample by sample along x.
struct LineScratch {
  std::vector<float> floats;
  RowSums rows;

  /// @param width floats of a row; 0: no products are wanted
  explicit LineScratch(std::size_t width) : floats((3 * kProducts + 8) * width, 0.0F) {
    rows.products = floats.data();
    rows.right = floats.data() + 3 * std::size_t{kProducts} * width;
    rows.stride = static_cast<int>(width);
  }
};

/// Adds one layer of samples to a cell's moments: its rows' sums between the cell's ends in x, spread over its ends in z.
/// @param t the layer's place between the nodes below and above it
void addToCell(const RowSums& rows, const float* along, int begin, int end, float t, float* cell) {
  const float between[3] = {(1.0F - t) * (1.0F - t), t * (1.0F - t), t * t}, ends[2] = {1.0F - t, t};
  float products[9 * kProducts], right[16];
  gatherCell(rows, along, begin, end, products, right);
  for (std::size_t xy = 0; xy < 9; ++xy) {
    for (std::size_t z = 0; z < 3; ++z) {
      for (std::size_t q = 0; q < kProducts; ++q) cell[(xy * 3 + z) * kProducts + q] += between[z] * products[xy * kProducts + q];
    }
  }
  for (std::size_t xy = 0; xy < 4; ++xy) {
    for (std::size_t z = 0; z < 2; ++z) {
      for (std::size_t q = 0; q < 4; ++q) cell[kCellProducts + (xy * 2 + z) * 4 + q] += ends[z] * right[xy * 4 + q];
    }
  }
}

}  // namespace

/// The row (j, k) of both images with its neighbours.
void LevelPair::pointAt(int j, int k, RowPair& pair) const {
  const glm::ivec3 dims = fixed_->dims;
  const std::size_t at = fixed_->rowOf(j, k);
  const int above = std::max(j - 1, 0), below = std::min(j + 1, dims.y - 1), before = std::max(k - 1, 0),
            behind = std::min(k + 1, dims.z - 1);
  const std::array<std::size_t, 4> near{fixed_->rowOf(above, k), fixed_->rowOf(below, k), fixed_->rowOf(j, before),
                                        fixed_->rowOf(j, behind)};
  pair.fixed = fixed_->values.data() + at;
  pair.moved = moved_.data() + at;
  for (std::size_t n = 0; n < 4; ++n) {
    pair.fixedNear[n] = fixed_->values.data() + near[n];
    pair.movedNear[n] = moved_.data() + near[n];
  }
  pair.fixedWeights = fixed_->weights.empty() ? nullptr : fixed_->weights.data() + at;
  pair.movedWeights = movedWeights_.data() + at;
  pair.slope[0] = dims.x > 1 ? static_cast<float>(0.5 / fixed_->spacing_mm.x) : 0.0F;
  pair.slope[1] = below > above ? static_cast<float>(1.0 / ((below - above) * fixed_->spacing_mm.y)) : 0.0F;
  pair.slope[2] = behind > before ? static_cast<float>(1.0 / ((behind - before) * fixed_->spacing_mm.z)) : 0.0F;
  pair.share = share_[1][static_cast<std::size_t>(j)];
}

/// One line of cells. A sample adds the products of its gradient to the 8 x 8 couplings of its cell's nodes, each weighted by two of the
/// trilinear weights. Those are products over the axes, so that samples are first summed along y in each column (accumulateRows), then
/// along x in each cell (gatherCell), then along z: 27 sums of 10 products a cell instead of 64 blocks a sample. addCell unfolds them.
/// resources/docs/science/registration.md, "Elastic, three-dimensional".
/// @param moments of the line's cells; null: sums alone
void LevelPair::sumLine(std::size_t cy, std::size_t cz, const CostOptions& options, float* moments, std::array<double, kSums>& part) const {
  LineScratch scratch(moments != nullptr ? static_cast<std::size_t>(fixed_->stride) + kOverrun : 0);
  std::vector<RowPair> pairs(static_cast<std::size_t>(begin_[1][cy + 1] - begin_[1][cy]));
  for (RowPair& pair : pairs) {
    pair.perScale2 = static_cast<float>(1.0 / (options.scale * options.scale));
    pair.ofFixed = static_cast<float>(options.ofFixed);
  }
  for (int k = begin_[2][cz]; k < begin_[2][cz + 1]; ++k) {
    Sums rowSums{};
    for (std::size_t n = 0; n < pairs.size(); ++n) pointAt(begin_[1][cy] + static_cast<int>(n), k, pairs[n]);
    if (moments != nullptr) {
      accumulateRows(pairs, fixed_->dims.x, scratch.rows, rowSums);
    } else {
      sumRows(pairs, fixed_->dims.x, rowSums);
    }
    for (std::size_t s = 0; s < kSums; ++s) part[s] += static_cast<double>(rowSums[s]);
    if (moments == nullptr) continue;
    for (std::size_t cx = 0; cx + 1 < begin_[0].size(); ++cx)
      addToCell(scratch.rows, along_.data(), begin_[0][cx], begin_[0][cx + 1], share_[2][static_cast<std::size_t>(k)],
                moments + kCellMoments * cx);
  }
}

bool LevelPair::assemble(const CostOptions& options, NodeSystem* system, PairSums& sums, Progress& progress) const {
  const glm::ivec3 cells = nodes_.cells();
  const int tasks = cells.y * cells.z;
  const auto cellsAlong = static_cast<std::size_t>(cells.x);
  std::vector<float> moments(system != nullptr ? kCellMoments * cellsAlong * static_cast<std::size_t>(tasks) : 0, 0.0F);
  std::vector<std::array<double, kSums>> parts(static_cast<std::size_t>(tasks));
  if (!forEachTask(tasks, threads_, progress, say<"Registering">(), [&](int task) {
        const auto line = static_cast<std::size_t>(task);
        sumLine(static_cast<std::size_t>(task % cells.y), static_cast<std::size_t>(task / cells.y), options,
                system != nullptr ? moments.data() + kCellMoments * cellsAlong * line : nullptr, parts[line]);
      }))
    return false;
  sums = {};
  for (const auto& part : parts) {
    for (std::size_t s = 0; s < kSums; ++s) sums.at[s] += part[s];
  }
  if (system == nullptr) return true;
  // Noise that only one image has stiffens the matrix without pulling anywhere.
  const auto scale = static_cast<float>(std::clamp(sums.commonGradient(), options.leastCommon, 1.0));
  // Layers of cells two apart share no node: either round may run in any order.
  for (int round = 0; round < 2 && round < cells.z; ++round) {
    if (!forEachTask((cells.z - round + 1) / 2, threads_, progress, say<"Registering">(), [&](int layer) {
          const int z = round + 2 * layer;
          for (int y = 0; y < cells.y; ++y) {
            for (int x = 0; x < cells.x; ++x) {
              const auto at = static_cast<std::size_t>(z * cells.y + y) * cellsAlong + static_cast<std::size_t>(x);
              const float* cell = moments.data() + kCellMoments * at;
              system->addCell({x, y, z}, cell, cell + kCellProducts, scale);
            }
          }
        }))
      return false;
  }
  return true;
}

}  // namespace ew::registration
