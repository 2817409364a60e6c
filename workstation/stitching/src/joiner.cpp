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

  std::vector<float> all(wide.count(), 1.0F);
  std::vector<float> scratch;
  boxSum(all, wide, blend_cells_, scratch);
  std::vector<CellLook> looks(static_cast<std::size_t>(wide.size().x));
  std::vector<float> own(wide.count());
  std::vector<float> covered(wide.count());
  for (Weights& weights : found) {
    for (std::size_t c = 0; c < labels.size(); ++c) own[c] = labels[c] == weights.view + 1 ? 1.0F : 0.0F;
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
          const float inside = found.size() > 1 ? std::clamp(2.0F * covered[c] / all[c] - 1.0F, 1e-3F, 1.0F) : 1.0F;
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
          if (weights.added.empty()) weights.added.assign(cells.count(), 0.0F);
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
  if (sharp) return {voxel / ratio, 0.0F};
  const double along = std::clamp((voxel - 0.5 * (ratio - 1)) / ratio, 0.0, cells - 1.0);
  const int cell = std::min(static_cast<int>(along), std::max(cells - 2, 0));
  return {cell, static_cast<float>(along - cell)};
}

}  // namespace

/// A box of the result along the seams: the views' weights on its cells, the band between them, and one row of voxels after the other.
struct Joiner::SeamBox {
  SeamBox(const Joiner& joiner, const std::vector<std::size_t>& reaching, const glm::ivec3& begin, const glm::ivec3& end, Tally& tally,
          const Stopped& stopped);

  void make(int j, int k, const BlockArrays& block);

 private:
  [[nodiscard]] CellBox cellsOf(const glm::ivec3& end) const;
  [[nodiscard]] Band bandOf(const Stopped& stopped) const;
  void drawWeights(const BetweenCells& y, const BetweenCells& z);
  void drawRow(const BetweenCells& y, const BetweenCells& z, const std::vector<float>& ofCells, std::vector<float>& ofRow);
  void sampleViews(int j, int k);
  [[nodiscard]] bool weigh(std::size_t at);
  void blend(std::size_t at, int j, int k, const BetweenCells& y, const BetweenCells& z);
  void addSteps(std::size_t at, int j, int k);
  void level(std::size_t at);
  void fillLeftOut(int j, int k);
  [[nodiscard]] double added(std::size_t n, std::size_t at) const { return levelled_ ? static_cast<double>(rowAdded_[n][at]) : 0.0; }

  const Joiner& joiner_;
  const std::vector<std::size_t>& reaching_;
  glm::ivec3 begin_;
  int end_;  ///< along x
  Tally& tally_;
  bool sharp_;
  bool levelled_;
  glm::ivec3 dims_;  ///< of all cells
  CellBox cells_;
  std::vector<Weights> weights_;
  std::size_t views_;
  Band band_;
  Row row_;
  std::vector<BetweenCells> along_;
  std::vector<float> line_;
  std::vector<std::vector<float>> rowWeights_;
  std::vector<std::vector<float>> rowAdded_;
  std::vector<ViewSample> samples_;  ///< voxels x views; empty between rows
  std::vector<double> taken_;        ///< by a voxel, of each view
};

Joiner::SeamBox::SeamBox(const Joiner& joiner, const std::vector<std::size_t>& reaching, const glm::ivec3& begin, const glm::ivec3& end,
                         Tally& tally, const Stopped& stopped)
    : joiner_(joiner),
      reaching_(reaching),
      begin_(begin),
      end_(end.x),
      tally_(tally),
      sharp_(joiner.options_.seam.blend_mm <= 0.0),
      levelled_(!joiner.seams_->levels.empty()),
      dims_(joiner.seams_->cells.dims),
      cells_(cellsOf(end)),
      weights_(joiner.weightsOf(reaching, cells_)),
      views_(weights_.size()),
      band_(bandOf(stopped)),
      row_(end.x - begin.x),
      line_(static_cast<std::size_t>(cells_.size().x)),
      taken_(views_) {
  for (int i = begin.x; i < end.x; ++i) along_.push_back(betweenCells(i, joiner.ratio_.x, dims_.x, sharp_));
  rowWeights_.assign(views_, std::vector<float>(along_.size(), 1.0F));
  rowAdded_.assign(levelled_ ? views_ : 0, std::vector<float>(along_.size(), 0.0F));
  samples_.resize(along_.size() * views_);
}

CellBox Joiner::SeamBox::cellsOf(const glm::ivec3& end) const {
  CellBox cells;
  for (int axis = 0; axis < 3; ++axis) {
    cells.begin[axis] = betweenCells(begin_[axis], joiner_.ratio_[axis], dims_[axis], sharp_).cell;
    cells.end[axis] = std::min(betweenCells(end[axis] - 1, joiner_.ratio_[axis], dims_[axis], sharp_).cell + 2, dims_[axis]);
  }
  return cells;
}

Band Joiner::SeamBox::bandOf(const Stopped& stopped) const {
  std::vector<std::size_t> blended;
  std::vector<const float*> cellWeights;
  for (const Weights& each : weights_) {
    if (!sharp_) blended.push_back(each.view);
    cellWeights.push_back(each.cells.data());
  }
  return {joiner_.samplers_, blended, cellWeights, cells_, joiner_.seams_->cells, joiner_.ratio_, stopped};
}

void Joiner::SeamBox::make(int j, int k, const BlockArrays& block) {
  row_.clear();
  const BetweenCells y = betweenCells(j, joiner_.ratio_.y, dims_.y, sharp_);
  const BetweenCells z = betweenCells(k, joiner_.ratio_.z, dims_.z, sharp_);
  drawWeights(y, z);
  sampleViews(j, k);
  for (std::size_t at = 0; at < along_.size() && views_ > 0; ++at)
    if (weigh(at)) blend(at, j, k, y, z);
  fillLeftOut(j, k);
  row_.put(block, begin_.x, j, k, tally_);
}

void Joiner::SeamBox::drawWeights(const BetweenCells& y, const BetweenCells& z) {
  for (std::size_t n = 0; n < views_; ++n) {
    drawRow(y, z, weights_[n].cells, rowWeights_[n]);
    if (!weights_[n].added.empty()) drawRow(y, z, weights_[n].added, rowAdded_[n]);
  }
}

/// Linear between cells.
void Joiner::SeamBox::drawRow(const BetweenCells& y, const BetweenCells& z, const std::vector<float>& ofCells, std::vector<float>& ofRow) {
  std::fill(line_.begin(), line_.end(), 0.0F);
  for (int corner = 0; corner < 4; ++corner) {
    const float share = ((corner & 1) ? y.part : 1.0F - y.part) * ((corner & 2) ? z.part : 1.0F - z.part);
    if (share <= 0.0F) continue;
    const float* from = ofCells.data() + cells_.indexOf(cells_.begin.x, y.cell + (corner & 1), z.cell + (corner >> 1));
    for (std::size_t c = 0; c < line_.size(); ++c) line_[c] += share * from[c];
  }
  for (std::size_t at = 0; at < along_.size(); ++at) {
    const auto c = static_cast<std::size_t>(along_[at].cell - cells_.begin.x);
    ofRow[at] = along_[at].part > 0.0F ? line_[c] + along_[at].part * (line_[c + 1] - line_[c]) : line_[c];
  }
}

void Joiner::SeamBox::sampleViews(int j, int k) {
  for (std::size_t n = 0; n < views_; ++n) {
    const ViewSampler& sampler = joiner_.samplers_[weights_[n].view];
    sampler.alongRow(j, k, begin_.x, end_, [&](int i, const glm::dvec3& where) {
      const auto at = static_cast<std::size_t>(i - begin_.x);
      if (rowWeights_[n][at] > 0.0F) samples_[at * views_ + n] = sampler.at(where);
    });
  }
}

/// What a voxel takes of each view.
/// @return false where none shows anything
bool Joiner::SeamBox::weigh(std::size_t at) {
  const ViewSample* const shown = samples_.data() + at * views_;
  double total = 0.0;
  for (std::size_t n = 0; n < views_; ++n) {
    taken_[n] = static_cast<double>(rowWeights_[n][at]) * shown[n].quality * trustIn(shown[n], joiner_.options_.seam);
    total += taken_[n];
  }
  if (total <= 0.0) return false;
  for (std::size_t n = 0; n < views_; ++n) {
    // Independent speckle a sin(t) + b cos(t) changes evenly with t: the blend then has no layer where it changes fastest.
    const double share = taken_[n] / total;
    taken_[n] = share < kLeastWeight ? 0.0 : share < 1.0 ? std::sin(kQuarterTurn * share) : 1.0;
    if (taken_[n] > 0.0) row_.take(at, weights_[n].view, shown[n], taken_[n], tally_);
  }
  return true;
}

void Joiner::SeamBox::blend(std::size_t at, int j, int k, const BetweenCells& y, const BetweenCells& z) {
  if (row_.inputs[at] > 1) {
    if (!band_.empty()) row_.mean[at] = band_.blend(along_[at], y, z, taken_.data(), row_.mean[at]);
    addSteps(at, j, k);
  }
  if (levelled_ && row_.mean[at] > 0.0) level(at);
  std::fill_n(samples_.data() + at * views_, views_, ViewSample{});
}

/// How much the views that were blended differ there.
void Joiner::SeamBox::addSteps(std::size_t at, int j, int k) {
  const ViewSample* const shown = samples_.data() + at * views_;
  const glm::ivec3 cube(glm::dvec3(begin_.x + static_cast<int>(at), j, k) * joiner_.result_.spacing_mm / kStepCube_mm);
  for (std::size_t a = 1; a < views_; ++a)
    for (std::size_t b = 0; b < a && taken_[a] > 0.0; ++b) {
      if (taken_[b] <= 0.0) continue;
      StepSum& sum = tally_.steps[{static_cast<int>(weights_[a].view), static_cast<int>(weights_[b].view), cube.x, cube.y, cube.z}];
      // What hardly weighs is hardly seen.
      const double seen = 4.0 * taken_[a] * taken_[b] / ((taken_[a] + taken_[b]) * (taken_[a] + taken_[b]));
      sum.count += seen;
      sum.difference += seen * (shown[a].level + added(a, at) - shown[b].level - added(b, at));
    }
}

/// Adds what levels the views along the seams.
void Joiner::SeamBox::level(std::size_t at) {
  double sum = 0.0, weight = 0.0;
  for (std::size_t n = 0; n < views_; ++n) {
    sum += taken_[n] * added(n, at);
    weight += taken_[n];
  }
  // What shows an echo goes on showing one.
  if (weight > 0.0 && sum != 0.0) row_.mean[at] = std::clamp(row_.mean[at] + sum / weight, std::min(1.0, row_.mean[at]), 255.0);
}

/// Where the view that was chosen shows nothing after all (the border runs through the cell), the first that does.
void Joiner::SeamBox::fillLeftOut(int j, int k) {
  if (std::find(row_.inputs.begin(), row_.inputs.end(), 0) == row_.inputs.end()) return;
  for (const std::size_t n : reaching_)
    joiner_.samplers_[n].alongRow(j, k, begin_.x, end_, [&](int i, const glm::dvec3& where) {
      const auto at = static_cast<std::size_t>(i - begin_.x);
      if (row_.inputs[at] > 0) return;
      const ViewSample sample = joiner_.samplers_[n].at(where);
      if (sample.quality > 0.0) row_.take(at, n, sample, sample.quality, tally_);
    });
}

void Joiner::alongSeams(const glm::ivec3& begin, const glm::ivec3& end, const BlockArrays& block, Tally& tally,
                        const Stopped& stopped) const {
  std::vector<std::size_t> reaching;
  for (std::size_t n = 0; n < views_.size(); ++n)
    if (samplers_[n].mayReach(begin, end - 1)) reaching.push_back(n);
  if (reaching.empty()) return;
  countOverlap(reaching, begin, end, tally);
  SeamBox box(*this, reaching, begin, end, tally, stopped);
  for (int k = begin.z; k < end.z; ++k)
    for (int j = begin.y; j < end.y && !stopped(); ++j) box.make(j, k, block);
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
