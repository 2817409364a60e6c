#include "band.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ew::stitching {
namespace {

/// Levels are added up as whole sixteenths: sums are exact, so neither order nor block can change them.
constexpr double kUnit = 16.0;
constexpr double kWindow_mm = 2.2;
/// Fewer voxels than this say nothing about a deviation.
constexpr double kFewest = 24.0;
/// What a view did not trust does not tell what its speckle is like. Deep tissue is trusted little long before its speckle is gone.
constexpr double kTrusted = 0.2;
constexpr double kMostStretch = 2.0;
/// Voxels so far apart are of different speckle, yet mostly of the same structure: their difference tells how speckle alone agrees.
constexpr double kSpeckle_mm = 0.8;

struct BandSums {
  double count = 0.0;
  double first = 0.0;
  double second = 0.0;
  double firstSquared = 0.0;
  double secondSquared = 0.0;
  double product = 0.0;
  void take(double a, double b) {
    count += 1.0;
    first += a;
    second += b;
    firstSquared += a * a;
    secondSquared += b * b;
    product += a * b;
  }
  void add(const BandSums& other) {
    count += other.count;
    first += other.first;
    second += other.second;
    firstSquared += other.firstSquared;
    secondSquared += other.secondSquared;
    product += other.product;
  }
};

/// 0 to 1; nothing where too few voxels or even ones were summed.
std::optional<double> speckleCorrelation(const BandSums& p) {
  if (p.count < kFewest) return std::nullopt;
  const double one = p.firstSquared - p.first * p.first / p.count;
  const double other = p.secondSquared - p.second * p.second / p.count;
  if (!(one > 0.0 && other > 0.0)) return std::nullopt;
  return std::clamp((p.product - p.first * p.second / p.count) / std::sqrt(one * other), 0.0, 1.0);
}

}  // namespace

glm::ivec3 Band::windowOf(const Grid& cells) {
  return glm::clamp(glm::ivec3(glm::round(kWindow_mm / cells.spacing_mm)), glm::ivec3(1), glm::ivec3(4));
}

std::uint64_t Band::bytesPerCell(std::uint64_t views) {
  const std::uint64_t pairs = views * (views - 1) / 2;
  return (views + pairs) * sizeof(BandSums) + views * (2 + sizeof(Moments)) + pairs * 4;
}

/// What moments are made from: which views are blended where, and sums over the voxels of every cell around.
/// resources/docs/author/stitching.md, "How views are joined", says why the blend is stretched by them.
struct Band::Gathered {
  const std::vector<ViewSampler>& samplers;
  const std::vector<std::size_t>& views;
  const CellBox& box;
  const Grid& cells;
  const glm::ivec3& ratio;
  const std::function<bool()>& stopped;
  std::size_t pairs = views.size() * (views.size() - 1) / 2;
  glm::ivec3 window = windowOf(cells);
  CellBox wide{glm::max(box.begin - window, glm::ivec3(0)), glm::min(box.end + window, cells.dims)};  // the box with its windows
  std::vector<std::uint8_t> around{};   // (cells of the box) x views: whether a view has a weight on the cell or on a neighbour
  std::vector<std::uint8_t> blended{};  // cells of the box: two views or more do
  std::vector<std::uint8_t> wanted{};   // (cells of the wide box) x views
  std::vector<BandSums> own{};          // likewise; `second` stays empty
  std::vector<BandSums> both{};         // (cells of the wide box) x pairs, of differences

  /// @return whether there is any blended cell
  bool findBlended(const std::vector<const float*>& weights);
  void markWanted();
  void sumVoxels();
  /// The cells of the window around one of the box.
  [[nodiscard]] CellBox windowAround(const glm::ivec3& cell) const {
    return {glm::max(cell - window, wide.begin), glm::min(cell + window + 1, wide.end)};
  }
  [[nodiscard]] BandSums sumOver(const CellBox& near, const std::vector<BandSums>& sums, std::size_t of, std::size_t each) const {
    BandSums all;
    for (int c = near.begin.z; c < near.end.z; ++c)
      for (int b = near.begin.y; b < near.end.y; ++b)
        for (int a = near.begin.x; a < near.end.x; ++a) all.add(sums[wide.indexOf(a, b, c) * each + of]);
    return all;
  }

 private:
  using LevelRow = std::vector<std::int32_t>;  // in sixteenths; below 0: not known
  [[nodiscard]] bool weighsAround(const float* weights, int i, int j, int k) const;
  void readRow(std::size_t n, int j, int k, const std::uint8_t* wantedHere, std::size_t lag, LevelRow& row) const;
  void addRow(const std::vector<LevelRow>& rows, std::size_t rowOfCells, std::size_t lag);
};

bool Band::Gathered::weighsAround(const float* weights, int i, int j, int k) const {
  for (int c = std::max(k - 1, box.begin.z); c < std::min(k + 2, box.end.z); ++c)
    for (int b = std::max(j - 1, box.begin.y); b < std::min(j + 2, box.end.y); ++b)
      for (int a = std::max(i - 1, box.begin.x); a < std::min(i + 2, box.end.x); ++a)
        if (weights[box.indexOf(a, b, c)] > 0.0F) return true;
  return false;
}

bool Band::Gathered::findBlended(const std::vector<const float*>& weights) {
  around.assign(box.count() * views.size(), 0);
  blended.assign(box.count(), 0);
  bool any = false;
  for (int k = box.begin.z; k < box.end.z; ++k)
    for (int j = box.begin.y; j < box.end.y; ++j)
      for (int i = box.begin.x; i < box.end.x; ++i) {
        const std::size_t cell = box.indexOf(i, j, k);
        int found = 0;
        for (std::size_t n = 0; n < views.size(); ++n) {
          const bool weighs = weighsAround(weights[n], i, j, k);
          around[cell * views.size() + n] = weighs ? 1 : 0;
          found += weighs ? 1 : 0;
        }
        blended[cell] = found > 1 ? 1 : 0;
        any = any || found > 1;
      }
  return any;
}

/// Cells that lie in the window of a blended one, for the views that are blended there.
void Band::Gathered::markWanted() {
  const std::size_t count = views.size();
  wanted.assign(wide.count() * count, 0);
  for (int k = box.begin.z; k < box.end.z; ++k)
    for (int j = box.begin.y; j < box.end.y; ++j)
      for (int i = box.begin.x; i < box.end.x; ++i) {
        const std::size_t cell = box.indexOf(i, j, k);
        if (blended[cell] == 0) continue;
        const CellBox near = windowAround({i, j, k});
        const std::uint8_t* const here = around.data() + cell * count;
        for (int c = near.begin.z; c < near.end.z; ++c)
          for (int b = near.begin.y; b < near.end.y; ++b) {
            std::uint8_t* to = wanted.data() + wide.indexOf(near.begin.x, b, c) * count;
            for (int a = near.begin.x; a < near.end.x; ++a, to += count)
              for (std::size_t n = 0; n < count; ++n) to[n] |= here[n];
          }
      }
}

void Band::Gathered::sumVoxels() {
  own.resize(wide.count() * views.size());
  both.resize(wide.count() * pairs);
  const auto lag = static_cast<std::size_t>(std::max(1L, std::lround(kSpeckle_mm * ratio.x / cells.spacing_mm.x)));
  const auto length = static_cast<std::size_t>(wide.size().x * ratio.x);
  const std::size_t perRow = static_cast<std::size_t>(wide.size().x) * views.size();
  std::vector<LevelRow> rows(views.size(), LevelRow(length + lag));
  for (int k = wide.begin.z * ratio.z; k < wide.end.z * ratio.z; ++k)
    for (int j = wide.begin.y * ratio.y; j < wide.end.y * ratio.y && !stopped(); ++j) {
      if (((j + k) & 1) != 0) continue;  // neighbouring rows show the same speckle: every other one tells as much
      const std::size_t rowOfCells = wide.indexOf(wide.begin.x, j / ratio.y, k / ratio.z);
      const std::uint8_t* const wantedHere = wanted.data() + rowOfCells * views.size();
      if (std::find(wantedHere, wantedHere + perRow, 1) == wantedHere + perRow) continue;
      for (std::size_t n = 0; n < views.size(); ++n) readRow(n, j, k, wantedHere, lag, rows[n]);
      addRow(rows, rowOfCells, lag);
    }
}

/// Levels of a view along a row of voxels, where they are wanted or the partner of one that is.
void Band::Gathered::readRow(std::size_t n, int j, int k, const std::uint8_t* wantedHere, std::size_t lag, LevelRow& row) const {
  std::fill(row.begin(), row.end(), -1);
  const ViewSampler& sampler = samplers[views[n]];
  const int first = wide.begin.x * ratio.x;
  const int last = wide.end.x * ratio.x;
  const std::size_t of = views.size();
  const auto isWanted = [&](int i) {
    return i >= first && i < last && wantedHere[static_cast<std::size_t>(i / ratio.x - wide.begin.x) * of + n] != 0;
  };
  sampler.alongRow(j, k, first, last + static_cast<int>(lag), [&](int i, const glm::dvec3& where) {
    if (!isWanted(i) && !isWanted(i - static_cast<int>(lag))) return;
    const ViewSample sample = sampler.at(where);
    if (sample.quality <= 0.0 || sample.confidence < kTrusted) return;
    row[static_cast<std::size_t>(i - first)] = static_cast<std::int32_t>(std::lround(kUnit * sample.level));
  });
}

void Band::Gathered::addRow(const std::vector<LevelRow>& rows, std::size_t rowOfCells, std::size_t lag) {
  const std::size_t count = views.size();
  const std::size_t length = rows.front().size() - lag;
  for (std::size_t at = 0; at < length; ++at) {
    const std::size_t cell = rowOfCells + at / static_cast<std::size_t>(ratio.x);
    for (std::size_t a = 0; a < count; ++a) {
      if (rows[a][at] < 0) continue;
      own[cell * count + a].take(rows[a][at], 0.0);
      const std::size_t next = at + lag;
      if (rows[a][next] < 0) continue;
      for (std::size_t b = 0; b < a; ++b)
        if (rows[b][at] >= 0 && rows[b][next] >= 0)
          both[cell * pairs + pairOf(a, b)].take(rows[a][next] - rows[a][at], rows[b][next] - rows[b][at]);
    }
  }
}

Band::Band(const std::vector<ViewSampler>& samplers, const std::vector<std::size_t>& views, const std::vector<const float*>& weights,
           const CellBox& box, const Grid& cells, const glm::ivec3& ratio, const std::function<bool()>& stopped)
    : box_(box), views_(views.size()) {
  if (views_ < 2) return;
  Gathered gathered{samplers, views, box, cells, ratio, stopped};
  if (!gathered.findBlended(weights)) return;
  gathered.markWanted();
  gathered.sumVoxels();
  moments_.resize(box.count() * views_);
  covariance_.resize(box.count() * gathered.pairs);
  for (int k = box.begin.z; k < box.end.z; ++k)
    for (int j = box.begin.y; j < box.end.y; ++j)
      for (int i = box.begin.x; i < box.end.x; ++i)
        if (gathered.blended[box.indexOf(i, j, k)] != 0 && !stopped()) takeMoments(gathered, {i, j, k});
}

/// Moments of one blended cell, over its window.
void Band::takeMoments(const Gathered& gathered, const glm::ivec3& at) {
  const std::size_t cell = box_.indexOf(at.x, at.y, at.z);
  const CellBox window = gathered.windowAround(at);
  for (std::size_t a = 0; a < views_; ++a) {
    if (gathered.around[cell * views_ + a] == 0) continue;
    const BandSums s = gathered.sumOver(window, gathered.own, a, views_);
    if (s.count < kFewest) continue;
    const double mean = s.first / s.count;
    Moments& mine = moments_[cell * views_ + a];
    mine = {static_cast<float>(mean / kUnit), static_cast<float>(std::max(0.0, s.firstSquared / s.count - mean * mean) / (kUnit * kUnit))};
    for (std::size_t b = 0; b < a; ++b) {
      const Moments& other = moments_[cell * views_ + b];
      if (other.variance < 0.0F) continue;
      // The correlation is that of the speckle both show, the deviations are each view's own.
      const auto correlation = speckleCorrelation(gathered.sumOver(window, gathered.both, pairOf(a, b), gathered.pairs));
      if (correlation)
        covariance_[cell * gathered.pairs + pairOf(a, b)] =
            static_cast<float>(*correlation * std::sqrt(static_cast<double>(mine.variance) * static_cast<double>(other.variance)));
    }
  }
}

double Band::blend(const BetweenCells& x, const BetweenCells& y, const BetweenCells& z, const double* weights, double plainMean) const {
  if (empty()) return plainMean;
  const std::size_t pairs = views_ * (views_ - 1) / 2;
  double total = 0.0;
  for (std::size_t n = 0; n < views_; ++n) total += weights[n];
  double known = 0.0;
  double mean = 0.0;
  double deviation = 0.0;
  double variance = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const double share = static_cast<double>((corner & 1) ? x.part : 1.0F - x.part) *
                         static_cast<double>((corner & 2) ? y.part : 1.0F - y.part) *
                         static_cast<double>((corner & 4) ? z.part : 1.0F - z.part);
    if (share <= 0.0) continue;
    const std::size_t cell = box_.indexOf(x.cell + (corner & 1), y.cell + ((corner >> 1) & 1), z.cell + (corner >> 2));
    double cellMean = 0.0;
    double cellDeviation = 0.0;
    double cellVariance = 0.0;
    bool all = true;
    for (std::size_t a = 0; a < views_ && all; ++a) {
      if (weights[a] <= 0.0) continue;
      const Moments& m = moments_[cell * views_ + a];
      all = m.variance >= 0.0F;
      const double w = weights[a] / total;
      const auto v = static_cast<double>(m.variance);
      cellMean += w * static_cast<double>(m.mean);
      cellDeviation += w * std::sqrt(std::max(0.0, v));
      cellVariance += w * w * v;
      for (std::size_t b = 0; b < a; ++b)
        if (weights[b] > 0.0) cellVariance += 2.0 * w * weights[b] / total * static_cast<double>(covariance_[cell * pairs + pairOf(a, b)]);
    }
    if (!all) continue;
    known += share;
    mean += share * cellMean;
    deviation += share * cellDeviation;
    variance += share * cellVariance;
  }
  if (!(known > 0.0 && variance > 0.0)) return plainMean;
  const double stretch = std::clamp(deviation / known / std::sqrt(variance / known), 1.0, kMostStretch);
  return mean / known + stretch * (plainMean - mean / known);
}

}  // namespace ew::stitching
