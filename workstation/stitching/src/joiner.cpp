#include "joiner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "band.h"
#include "ew/core/contract.h"

namespace ew::stitching {
namespace {

/// A view that would weigh less beside the others is left out: it could not change a grey level, and costs a sample.
constexpr double kLeastWeight = 1.0 / 256.0;
/// So many views meet in one tile at most, as a rule: what a forecast reckons with.
constexpr std::size_t kMostBlended = 4;
constexpr double kQuarterTurn = std::numbers::pi / 2.0;

/// What nobody trusts is still shown where there is nothing else.
double trustIn(const ViewSample& sample, const SeamOptions& options) {
  return std::max(1e-3, 1.0 - std::min(1.0, options.confidenceWeight) * (1.0 - sample.confidence));
}

}  // namespace

void Tally::add(const Tally& other) {
  covered += other.covered;
  overlapping += other.overlapping;
  blended += other.blended;
  squaredSpread += other.squaredSpread;
  for (const auto& [place, sum] : other.steps) {
    steps[place].count += sum.count;
    steps[place].difference += sum.difference;
  }
  for (std::size_t n = 0; n < other.contributions.size(); ++n) {
    contributions[n].voxels += other.contributions[n].voxels;
    contributions[n].dominantVoxels += other.contributions[n].dominantVoxels;
  }
}

Joiner::Joiner(std::span<const View> views, const SeamMap* seams, const Grid& result, const JoinOptions& options,
               const std::vector<std::vector<float>>& distances_mm)
    : views_(views), seams_(seams), result_(result), options_(options) {
  for (std::size_t n = 0; n < views.size(); ++n)
    samplers_.emplace_back(views[n], result, options.grid.interpolatedWeight, distances_mm.empty() ? nullptr : &distances_mm[n]);
  if (seams == nullptr) return;
  const auto ratio = ratioOf(seams->cells, result);
  EW_EXPECTS(ratio);
  ratio_ = *ratio;
  // Weights are drawn out linearly between cells, which widens the blend by half a cell.
  for (int axis = 0; axis < 3; ++axis) blend_cells_[axis] = std::max(0.0, options.seam.blend_mm / seams->cells.spacing_mm[axis] - 0.5);
}

/// Sums over a row of the result.
struct Joiner::Row {
  std::vector<double> weight;
  std::vector<double> mean;
  std::vector<double> spread;  ///< sum of weight times squared distance from the mean
  std::vector<double> heaviest;
  std::vector<int> inputs;
  std::vector<std::uint8_t> source;
  std::vector<std::uint8_t> measured;

  explicit Row(int length) {
    const auto n = static_cast<std::size_t>(length);
    for (auto* sums : {&weight, &mean, &spread, &heaviest}) sums->resize(n);
    inputs.resize(n);
    source.resize(n);
    measured.resize(n);
  }
  void clear() {
    for (auto* sums : {&weight, &mean, &spread, &heaviest}) std::fill(sums->begin(), sums->end(), 0.0);
    std::fill(inputs.begin(), inputs.end(), 0);
    for (auto* marks : {&source, &measured}) std::fill(marks->begin(), marks->end(), std::uint8_t{0});
  }
  void take(std::size_t at, std::size_t view, const ViewSample& sample, double w, Tally& tally) {
    // West's running mean: a sum of squares would lose the spread of inputs that nearly agree.
    weight[at] += w;
    const double beside = sample.level - mean[at];
    mean[at] += beside * (w / weight[at]);  // the first share is exactly 1
    spread[at] += w * beside * (sample.level - mean[at]);
    ++inputs[at];
    if (sample.measured) measured[at] = 1;
    ++tally.contributions[view].voxels;
    if (w > heaviest[at]) {
      heaviest[at] = w;
      source[at] = static_cast<std::uint8_t>(view + 1);
    }
  }
  void put(const BlockArrays& block, int begin, int j, int k, Tally& tally) const {
    const std::size_t first = block.indexOf(begin, j, k);
    for (std::size_t at = 0; at < inputs.size(); ++at) {
      if (inputs[at] == 0) continue;
      block.echo[first + at] = greyOf(mean[at]);
      block.coverage[first + at] = static_cast<std::uint8_t>(measured[at] != 0 ? Coverage::measured : Coverage::interpolated);
      block.source[first + at] = source[at];
      ++tally.contributions[source[at] - 1u].dominantVoxels;
      if (inputs[at] < 2) continue;
      ++tally.blended;
      tally.squaredSpread += std::max(0.0, spread[at] / weight[at]);
    }
  }
};

void Joiner::make(const glm::ivec3& begin, const glm::ivec3& end, const BlockArrays& block, Tally& tally, const Stopped& stopped) const {
  tally.contributions.resize(views_.size());
  if (seams_ == nullptr)
    feather(begin, end, block, tally, stopped);
  else
    alongSeams(begin, end, block, tally, stopped);
}

void Joiner::feather(const glm::ivec3& begin, const glm::ivec3& end, const BlockArrays& block, Tally& tally, const Stopped& stopped) const {
  std::vector<std::size_t> reaching;
  for (std::size_t n = 0; n < views_.size(); ++n)
    if (samplers_[n].mayReach(begin, end - 1)) reaching.push_back(n);
  const double width_mm = options_.grid.featherWidth_mm;
  Row row(end.x - begin.x);
  for (int k = begin.z; k < end.z; ++k)
    for (int j = begin.y; j < end.y && !stopped(); ++j) {
      row.clear();
      for (const std::size_t n : reaching)
        samplers_[n].alongRow(j, k, begin.x, end.x, [&](int i, const glm::dvec3& where) {
          const ViewSample sample = samplers_[n].at(where);
          double weight = sample.quality;
          if (width_mm > 0.0) weight *= std::min(1.0, sample.distance / width_mm);
          // What nobody trusts is still shown where there is nothing else.
          weight *= trustIn(sample, options_.seam);
          if (weight > 0.0) row.take(static_cast<std::size_t>(i - begin.x), n, sample, weight, tally);
        });
      row.put(block, begin.x, j, k, tally);
      for (const int inputs : row.inputs) {
        tally.covered += inputs > 0 ? 1 : 0;
        tally.overlapping += inputs > 1 ? 1 : 0;
      }
    }
}

/// How much a view weighs, on cells.
struct Joiner::Weights {
  std::size_t view = 0;
  std::vector<float> cells;
  std::vector<float> added;  ///< to its grey levels; empty: nothing anywhere
};

std::vector<Joiner::Weights> Joiner::weightsOf(const std::vector<std::size_t>& reaching, const CellBox& cells) const {
  const glm::ivec3 halo(glm::ceil(blend_cells_) + 1.0);
  const CellBox wide{glm::max(cells.begin - halo, glm::ivec3(0)), glm::min(cells.end + halo, seams_->cells.dims)};
  std::vector<std::uint8_t> labels;
  labels.reserve(wide.count());
  for (int k = wide.begin.z; k < wide.end.z; ++k)
    for (int j = wide.begin.y; j < wide.end.y; ++j) {
      const auto row = seams_->view.begin() + static_cast<std::ptrdiff_t>(seams_->cells.indexOf(wide.begin.x, j, k));
      labels.insert(labels.end(), row, row + wide.size().x);
    }
  std::vector<Weights> found;
  for (const std::size_t n : reaching)
    if (std::find(labels.begin(), labels.end(), static_cast<std::uint8_t>(n + 1)) != labels.end()) found.push_back({n, {}, {}});
  if (found.empty()) return found;

  std::vector<float> all(wide.count(), 1.0f);
  std::vector<float> scratch;
  boxSum(all, wide, blend_cells_, scratch);
  std::vector<CellLook> looks(static_cast<std::size_t>(wide.size().x));
  std::vector<float> own(wide.count());
  std::vector<float> covered(wide.count());
  for (Weights& weights : found) {
    for (std::size_t c = 0; c < labels.size(); ++c) own[c] = labels[c] == weights.view + 1 ? 1.0f : 0.0f;
    boxSum(own, wide, blend_cells_, scratch);
    if (found.size() > 1)
      for (int k = wide.begin.z; k < wide.end.z; ++k)
        for (int j = wide.begin.y; j < wide.end.y; ++j) {
          lookAlongCells(samplers_[weights.view], ratio_, j, k, wide.begin.x, wide.end.x, looks.data());
          float* row = covered.data() + wide.indexOf(wide.begin.x, j, k);
          for (std::size_t c = 0; c < looks.size(); ++c) row[c] = looks[c].share;
        }
    if (found.size() > 1) boxSum(covered, wide, blend_cells_, scratch);
    weights.cells.resize(cells.count());
    std::size_t to = 0;
    for (int k = cells.begin.z; k < cells.end.z; ++k)
      for (int j = cells.begin.y; j < cells.end.y; ++j)
        for (int i = cells.begin.x; i < cells.end.x; ++i, ++to) {
          const std::size_t c = wide.indexOf(i, j, k);
          // A view fades out towards its own border, so that no step is left where the seam keeps close to it.
          const float inside = found.size() > 1 ? std::clamp(2.0f * covered[c] / all[c] - 1.0f, 1e-3f, 1.0f) : 1.0f;
          weights.cells[to] = own[c] / all[c] * inside;
        }
    if (weights.view >= seams_->levels.size() || seams_->levels[weights.view].offset.empty()) continue;
    const SeamMap::Levels& levels = seams_->levels[weights.view];
    const CellBox box{levels.begin, levels.begin + levels.size};
    to = 0;
    for (int k = cells.begin.z; k < cells.end.z; ++k)
      for (int j = cells.begin.y; j < cells.end.y; ++j)
        for (int i = cells.begin.x; i < cells.end.x; ++i, ++to) {
          const glm::ivec3 at = glm::clamp(glm::ivec3(i, j, k), box.begin, box.end - 1);
          const std::int16_t offset = levels.offset[box.indexOf(at.x, at.y, at.z)];
          if (offset == 0) continue;
          if (weights.added.empty()) weights.added.assign(cells.count(), 0.0f);
          weights.added[to] = static_cast<float>(offset * SeamMap::kOffsetUnit);
        }
  }
  return found;
}

void Joiner::countOverlap(const std::vector<std::size_t>& reaching, const glm::ivec3& begin, const glm::ivec3& end, Tally& tally) const {
  // One look per cell, at its middle voxel: a share of cells, not worth a sample of every view at every voxel.
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(end.x - begin.x));
  const glm::ivec3 middle = (ratio_ - 1) / 2;
  for (int k = begin.z; k < end.z; ++k) {
    if (k % ratio_.z != middle.z) continue;
    for (int j = begin.y; j < end.y; ++j) {
      if (j % ratio_.y != middle.y) continue;
      std::fill(seen.begin(), seen.end(), std::uint8_t{0});
      for (const std::size_t n : reaching)
        samplers_[n].alongRow(j, k, begin.x, end.x, [&](int i, const glm::dvec3& where) {
          if (i % ratio_.x == middle.x && samplers_[n].nearestTo(where).quality > 0.0) ++seen[static_cast<std::size_t>(i - begin.x)];
        });
      for (const std::uint8_t views : seen) {
        tally.covered += views > 0 ? 1 : 0;
        tally.overlapping += views > 1 ? 1 : 0;
      }
    }
  }
}

namespace {

BetweenCells betweenCells(int voxel, int ratio, int cells, bool sharp) {
  if (sharp) return {voxel / ratio, 0.0f};
  const double along = std::clamp((voxel - 0.5 * (ratio - 1)) / ratio, 0.0, cells - 1.0);
  const int cell = std::min(static_cast<int>(along), std::max(cells - 2, 0));
  return {cell, static_cast<float>(along - cell)};
}

}  // namespace

void Joiner::alongSeams(const glm::ivec3& begin, const glm::ivec3& end, const BlockArrays& block, Tally& tally,
                        const Stopped& stopped) const {
  std::vector<std::size_t> reaching;
  for (std::size_t n = 0; n < views_.size(); ++n)
    if (samplers_[n].mayReach(begin, end - 1)) reaching.push_back(n);
  if (reaching.empty()) return;
  countOverlap(reaching, begin, end, tally);

  const bool sharp = options_.seam.blend_mm <= 0.0;
  const glm::ivec3 dims = seams_->cells.dims;
  CellBox cells;
  for (int axis = 0; axis < 3; ++axis) {
    cells.begin[axis] = betweenCells(begin[axis], ratio_[axis], dims[axis], sharp).cell;
    cells.end[axis] = std::min(betweenCells(end[axis] - 1, ratio_[axis], dims[axis], sharp).cell + 2, dims[axis]);
  }
  const std::vector<Weights> weights = weightsOf(reaching, cells);
  std::vector<std::size_t> blended;
  std::vector<const float*> cellWeights;
  const bool levelled = !seams_->levels.empty();
  for (const Weights& each : weights) {
    blended.push_back(each.view);
    cellWeights.push_back(each.cells.data());
  }
  if (sharp) blended.clear();
  const Band band(samplers_, blended, cellWeights, cells, seams_->cells, ratio_, stopped);

  const int length = end.x - begin.x;
  Row row(length);
  std::vector<BetweenCells> along;
  for (int i = begin.x; i < end.x; ++i) along.push_back(betweenCells(i, ratio_.x, dims.x, sharp));
  std::vector<float> line(static_cast<std::size_t>(cells.size().x));
  std::vector<std::vector<float>> rowWeights(weights.size(), std::vector<float>(static_cast<std::size_t>(length), 1.0f));
  const std::size_t views = weights.size();
  std::vector<std::vector<float>> rowAdded(levelled ? views : 0, std::vector<float>(static_cast<std::size_t>(length), 0.0f));
  std::vector<ViewSample> samples(static_cast<std::size_t>(length) * views);  // empty between rows
  std::vector<double> taken(views);
  for (int k = begin.z; k < end.z; ++k)
    for (int j = begin.y; j < end.y && !stopped(); ++j) {
      row.clear();
      const BetweenCells y = betweenCells(j, ratio_.y, dims.y, sharp);
      const BetweenCells z = betweenCells(k, ratio_.z, dims.z, sharp);
      const auto betweenCellsOfRow = [&](const std::vector<float>& values, std::vector<float>& row_) {
        std::fill(line.begin(), line.end(), 0.0f);
        for (int corner = 0; corner < 4; ++corner) {
          const float share = ((corner & 1) ? y.part : 1.0f - y.part) * ((corner & 2) ? z.part : 1.0f - z.part);
          if (share <= 0.0f) continue;
          const float* from = values.data() + cells.indexOf(cells.begin.x, y.cell + (corner & 1), z.cell + (corner >> 1));
          for (std::size_t c = 0; c < line.size(); ++c) line[c] += share * from[c];
        }
        for (std::size_t at = 0; at < along.size(); ++at) {
          const auto c = static_cast<std::size_t>(along[at].cell - cells.begin.x);
          row_[at] = along[at].part > 0.0f ? line[c] + along[at].part * (line[c + 1] - line[c]) : line[c];
        }
      };
      for (std::size_t n = 0; n < weights.size(); ++n) {
        betweenCellsOfRow(weights[n].cells, rowWeights[n]);
        if (!weights[n].added.empty()) betweenCellsOfRow(weights[n].added, rowAdded[n]);
      }
      for (std::size_t n = 0; n < views; ++n) {
        const ViewSampler& sampler = samplers_[weights[n].view];
        sampler.alongRow(j, k, begin.x, end.x, [&](int i, const glm::dvec3& where) {
          const auto at = static_cast<std::size_t>(i - begin.x);
          if (rowWeights[n][at] > 0.0f) samples[at * views + n] = sampler.at(where);
        });
      }
      for (std::size_t at = 0; at < along.size() && views > 0; ++at) {
        ViewSample* const shown = samples.data() + at * views;
        double total = 0.0;
        for (std::size_t n = 0; n < views; ++n) {
          taken[n] = static_cast<double>(rowWeights[n][at]) * shown[n].quality * trustIn(shown[n], options_.seam);
          total += taken[n];
        }
        if (total <= 0.0) continue;
        for (std::size_t n = 0; n < views; ++n) {
          // Independent speckle a sin(t) + b cos(t) changes evenly with t: the blend then has no layer where it changes fastest.
          const double share = taken[n] / total;
          taken[n] = share < kLeastWeight ? 0.0 : share < 1.0 ? std::sin(kQuarterTurn * share) : 1.0;
          if (taken[n] > 0.0) row.take(at, weights[n].view, shown[n], taken[n], tally);
        }
        const auto added = [&](std::size_t n) { return levelled ? static_cast<double>(rowAdded[n][at]) : 0.0; };
        if (row.inputs[at] > 1) {
          if (!band.empty()) row.mean[at] = band.blend(along[at], y, z, taken.data(), row.mean[at]);
          const glm::ivec3 cube(glm::dvec3(begin.x + static_cast<int>(at), j, k) * result_.spacing_mm / kStepCube_mm);
          for (std::size_t a = 1; a < views; ++a)
            for (std::size_t b = 0; b < a && taken[a] > 0.0; ++b) {
              if (taken[b] <= 0.0) continue;
              StepSum& sum = tally.steps[{static_cast<int>(weights[a].view), static_cast<int>(weights[b].view), cube.x, cube.y, cube.z}];
              // What hardly weighs is hardly seen.
              const double seen = 4.0 * taken[a] * taken[b] / ((taken[a] + taken[b]) * (taken[a] + taken[b]));
              sum.count += seen;
              sum.difference += seen * (shown[a].level + added(a) - shown[b].level - added(b));
            }
        }
        if (levelled && row.mean[at] > 0.0) {
          double sum = 0.0, weight = 0.0;
          for (std::size_t n = 0; n < views; ++n) {
            sum += taken[n] * added(n);
            weight += taken[n];
          }
          // What shows an echo goes on showing one.
          if (weight > 0.0 && sum != 0.0) row.mean[at] = std::clamp(row.mean[at] + sum / weight, std::min(1.0, row.mean[at]), 255.0);
        }
        std::fill(shown, shown + views, ViewSample{});
      }
      // Where the view that was chosen shows nothing after all (the border runs through the cell), the first that does.
      if (std::find(row.inputs.begin(), row.inputs.end(), 0) != row.inputs.end())
        for (const std::size_t n : reaching)
          samplers_[n].alongRow(j, k, begin.x, end.x, [&](int i, const glm::dvec3& where) {
            const auto at = static_cast<std::size_t>(i - begin.x);
            if (row.inputs[at] > 0) return;
            const ViewSample sample = samplers_[n].at(where);
            if (sample.quality > 0.0) row.take(at, n, sample, sample.quality, tally);
          });
      row.put(block, begin.x, j, k, tally);
    }
}

std::uint64_t Joiner::scratchBytes(const glm::ivec3& size, std::size_t views, const Grid& cells, const glm::ivec3& ratio) {
  const auto length = static_cast<std::uint64_t>(size.x);
  const std::uint64_t blended = std::min<std::size_t>(views, kMostBlended);
  const std::uint64_t rows = length * (4 * 8 + 4 + 2 + 8 + blended * (4 + sizeof(ViewSample)));
  if (views < 2) return rows;
  const glm::ivec3 halo = glm::ivec3(8) + 2 * Band::windowOf(cells);
  const glm::dvec3 box(glm::min(size / ratio + halo, cells.dims));
  const auto count = static_cast<std::uint64_t>(box.x * box.y * box.z);
  return rows + length * blended * 4 + count * (14 * blended + 16 + Band::bytesPerCell(blended));
}

}  // namespace ew::stitching
