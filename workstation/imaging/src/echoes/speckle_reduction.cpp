#include "speckle_reduction.h"

#include <algorithm>
#include <cmath>

namespace ew::detail {
namespace {

constexpr double kMean_mm = 2.0;  // one standard deviation
constexpr double kCell_mm = 1.0;
constexpr int kWidest = 10;  // lines or cells to each side
constexpr float kBlackest = -20.0F;
constexpr double kFlat_db = 8.0;     // speckle, up to here
constexpr double kDetail_db = 14.0;  // no speckle, from here on

/// Of a Gaussian, by distance; both sides together 1.
std::vector<float> weightsOf(double sigma) {
  const int reach = std::clamp(static_cast<int>(std::ceil(2.5 * sigma)), 0, kWidest);
  std::vector<float> weights;
  double sum = 0.0;
  for (int n = 0; n <= reach; ++n) {
    const double weight = std::exp(-0.5 * n * n / std::max(sigma * sigma, 1e-6));
    sum += n == 0 ? weight : 2.0 * weight;
    weights.push_back(static_cast<float>(weight));
  }
  for (float& weight : weights) weight = static_cast<float>(static_cast<double>(weight) / sum);
  return weights;
}

}  // namespace

void SpeckleReduction::configure(const EchoLayout& layout) {
  reduction_ = layout.effect.speckleReduction;
  if (!(reduction_ > 0.0)) return;
  lines_ = static_cast<int>(layout.grid.lines.size());
  samples_ = layout.grid.samples;
  samplesPerCell_ = std::max(1, static_cast<int>(std::lround(kCell_mm / layout.grid.sampleSpacing_mm)));
  cells_ = (samples_ + samplesPerCell_ - 1) / samplesPerCell_;
  const double cell_mm = samplesPerCell_ * layout.grid.sampleSpacing_mm;
  axial_ = weightsOf(kMean_mm / cell_mm);
  lateral_.clear();
  for (int cell = 0; cell < cells_; ++cell)
    lateral_.push_back(weightsOf(kMean_mm / std::max(layout.grid.lineSpacing_mm((cell + 0.5) * cell_mm), 1e-3)));
  averages_.resize(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(lines_));
  means_.resize(averages_.size());
}

void SpeckleReduction::run(double greyPerDb, Bands& bands, ImageView<float> levels) {
  if (!(reduction_ > 0.0)) return;
  rows_.resize(static_cast<std::size_t>(bands.threads()));
  bands.run(cells_, [&](int first, int count, int) {
    averageCells(first, count, {levels.data, levels.width, levels.height, levels.stride});
  });
  bands.run(cells_, [&](int first, int count, int slot) { smoothCells(first, count, rows_[static_cast<std::size_t>(slot)]); });
  bands.run(samples_, [&](int first, int count, int) { flatten(first, count, greyPerDb, levels); });
}

void SpeckleReduction::averageCells(int first, int count, ImageView<const float> levels) {
  for (int cell = first; cell < first + count; ++cell) {
    float* sum = averages_.data() + static_cast<std::ptrdiff_t>(cell) * lines_;
    std::fill(sum, sum + lines_, 0.0F);
    const int begin = cell * samplesPerCell_, end = std::min(begin + samplesPerCell_, samples_);
    for (int s = begin; s < end; ++s) {
      const float* row = levels.row(s);
      for (int line = 0; line < lines_; ++line) sum[line] += std::max(row[line], kBlackest);
    }
    const float share = 1.0F / static_cast<float>(end - begin);
    for (int line = 0; line < lines_; ++line) sum[line] *= share;
  }
}

void SpeckleReduction::smoothCells(int first, int count, std::vector<float>& row) {
  const auto margin = static_cast<std::size_t>(kWidest);
  row.resize(static_cast<std::size_t>(lines_) + 2 * margin);
  for (int cell = first; cell < first + count; ++cell) {
    float* along = row.data() + margin;
    const auto averagesAt = [&](int at) { return averages_.data() + static_cast<std::ptrdiff_t>(std::clamp(at, 0, cells_ - 1)) * lines_; };
    const float* own = averagesAt(cell);
    for (int line = 0; line < lines_; ++line) along[line] = axial_[0] * own[line];
    for (int n = 1; n < static_cast<int>(axial_.size()); ++n) {
      const float weight = axial_[static_cast<std::size_t>(n)];
      const float *above = averagesAt(cell - n), *below = averagesAt(cell + n);
      for (int line = 0; line < lines_; ++line) along[line] += weight * (above[line] + below[line]);
    }
    std::fill(row.begin(), row.begin() + kWidest, along[0]);
    std::fill(row.end() - kWidest, row.end(), along[lines_ - 1]);
    const std::vector<float>& lateral = lateral_[static_cast<std::size_t>(cell)];
    float* mean = means_.data() + static_cast<std::ptrdiff_t>(cell) * lines_;
    for (int line = 0; line < lines_; ++line) mean[line] = lateral[0] * along[line];
    for (int n = 1; n < static_cast<int>(lateral.size()); ++n) {
      const float weight = lateral[static_cast<std::size_t>(n)];
      for (int line = 0; line < lines_; ++line) mean[line] += weight * (along[line - n] + along[line + n]);
    }
  }
}

void SpeckleReduction::flatten(int first, int count, double greyPerDb, ImageView<float> levels) const {
  const auto reduction = static_cast<float>(reduction_), flat = static_cast<float>(kFlat_db * greyPerDb);
  const auto perLevel = static_cast<float>(1.0 / ((kDetail_db - kFlat_db) * greyPerDb));
  for (int s = first; s < first + count; ++s) {
    const float place =
        std::clamp((static_cast<float>(s) + 0.5F) / static_cast<float>(samplesPerCell_) - 0.5F, 0.0F, static_cast<float>(cells_ - 1));
    const int cell = std::min(static_cast<int>(place), std::max(cells_ - 2, 0));
    const float t = place - static_cast<float>(cell);
    const float* above = means_.data() + static_cast<std::ptrdiff_t>(cell) * lines_;
    const float* below = means_.data() + static_cast<std::ptrdiff_t>(std::min(cell + 1, cells_ - 1)) * lines_;
    float* row = levels.row(s);
    for (int line = 0; line < lines_; ++line) {
      const float mean = above[line] + t * (below[line] - above[line]);
      const float off = row[line] - mean;
      const float detail = std::min(std::max((std::abs(off) - flat) * perLevel, 0.0F), 1.0F);
      row[line] -= off * reduction * (1.0F - detail);
    }
  }
}

}  // namespace ew::detail
