#include "band.h"

#include <algorithm>
#include <cmath>

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

struct Sums {
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
  void add(const Sums& other) {
    count += other.count;
    first += other.first;
    second += other.second;
    firstSquared += other.firstSquared;
    secondSquared += other.secondSquared;
    product += other.product;
  }
};

}  // namespace

glm::ivec3 Band::windowOf(const Grid& cells) {
  return glm::clamp(glm::ivec3(glm::round(kWindow_mm / cells.spacing_mm)), glm::ivec3(1), glm::ivec3(4));
}

std::uint64_t Band::bytesPerCell(std::uint64_t views) {
  const std::uint64_t pairs = views * (views - 1) / 2;
  return (views + pairs) * sizeof(Sums) + views * (2 + sizeof(Moments)) + pairs * 4;
}

Band::Band(const std::vector<ViewSampler>& samplers, const std::vector<std::size_t>& views, const std::vector<const float*>& weights,
           const CellBox& box, const Grid& cells, const glm::ivec3& ratio, const std::function<bool()>& stopped)
    : box_(box), views_(views.size()) {
  if (views_ < 2) return;
  // Which views are blended around a cell: those with a weight on it or on one of its 26 neighbours.
  std::vector<std::uint8_t> around(box.count() * views_, 0);
  std::vector<std::uint8_t> blended(box.count(), 0);
  bool any = false;
  for (int k = box.begin.z; k < box.end.z; ++k)
    for (int j = box.begin.y; j < box.end.y; ++j)
      for (int i = box.begin.x; i < box.end.x; ++i) {
        const std::size_t cell = box.indexOf(i, j, k);
        int found = 0;
        for (std::size_t n = 0; n < views_; ++n) {
          bool weighs = false;
          for (int c = std::max(k - 1, box.begin.z); c < std::min(k + 2, box.end.z) && !weighs; ++c)
            for (int b = std::max(j - 1, box.begin.y); b < std::min(j + 2, box.end.y) && !weighs; ++b)
              for (int a = std::max(i - 1, box.begin.x); a < std::min(i + 2, box.end.x) && !weighs; ++a)
                weighs = weights[n][box.indexOf(a, b, c)] > 0.0f;
          around[cell * views_ + n] = weighs ? 1 : 0;
          found += weighs ? 1 : 0;
        }
        blended[cell] = found > 1 ? 1 : 0;
        any = any || found > 1;
      }
  if (!any) return;

  // Sums over the voxels of every cell that lies in the window of a blended one.
  const glm::ivec3 window = windowOf(cells);
  const CellBox wide{glm::max(box.begin - window, glm::ivec3(0)), glm::min(box.end + window, cells.dims)};
  std::vector<std::uint8_t> wanted(wide.count() * views_, 0);
  for (int k = box.begin.z; k < box.end.z; ++k)
    for (int j = box.begin.y; j < box.end.y; ++j)
      for (int i = box.begin.x; i < box.end.x; ++i) {
        const std::size_t cell = box.indexOf(i, j, k);
        if (blended[cell] == 0) continue;
        const glm::ivec3 low = glm::max(glm::ivec3(i, j, k) - window, wide.begin);
        const glm::ivec3 high = glm::min(glm::ivec3(i, j, k) + window + 1, wide.end);
        for (int c = low.z; c < high.z; ++c)
          for (int b = low.y; b < high.y; ++b)
            for (int a = low.x; a < high.x; ++a)
              for (std::size_t n = 0; n < views_; ++n) wanted[wide.indexOf(a, b, c) * views_ + n] |= around[cell * views_ + n];
      }
  const std::size_t pairs = views_ * (views_ - 1) / 2;
  std::vector<Sums> own(wide.count() * views_);  // `second` stays empty
  std::vector<Sums> both(wide.count() * pairs);  // of differences
  const int first = wide.begin.x * ratio.x;
  const int last = wide.end.x * ratio.x;
  const auto length = static_cast<std::size_t>(last - first);
  const auto lag = static_cast<std::size_t>(std::max(1L, std::lround(kSpeckle_mm * ratio.x / cells.spacing_mm.x)));
  std::vector<std::vector<std::int32_t>> rows(views_, std::vector<std::int32_t>(length + lag));
  for (int k = wide.begin.z * ratio.z; k < wide.end.z * ratio.z; ++k)
    for (int j = wide.begin.y * ratio.y; j < wide.end.y * ratio.y && !stopped(); ++j) {
      if (((j + k) & 1) != 0) continue;  // neighbouring rows show the same speckle: every other one tells as much
      const std::size_t rowOfCells = wide.indexOf(wide.begin.x, j / ratio.y, k / ratio.z);
      const auto* const wantedHere = wanted.data() + rowOfCells * views_;
      if (std::find(wantedHere, wantedHere + static_cast<std::size_t>(wide.size().x) * views_, 1) ==
          wantedHere + static_cast<std::size_t>(wide.size().x) * views_)
        continue;
      for (std::size_t n = 0; n < views_; ++n) {
        std::fill(rows[n].begin(), rows[n].end(), -1);
        const ViewSampler& sampler = samplers[views[n]];
        const auto isWanted = [&](int i) {
          return i >= first && i < last && wantedHere[static_cast<std::size_t>(i / ratio.x - wide.begin.x) * views_ + n] != 0;
        };
        sampler.alongRow(j, k, first, last + static_cast<int>(lag), [&](int i, const glm::dvec3& where) {
          if (!isWanted(i) && !isWanted(i - static_cast<int>(lag))) return;  // a voxel or the partner of one
          const ViewSample sample = sampler.at(where);
          if (sample.quality <= 0.0 || sample.confidence < kTrusted) return;
          rows[n][static_cast<std::size_t>(i - first)] = static_cast<std::int32_t>(std::lround(kUnit * sample.level));
        });
      }
      for (std::size_t at = 0; at < length; ++at) {
        const std::size_t cell = rowOfCells + at / static_cast<std::size_t>(ratio.x);
        for (std::size_t a = 0; a < views_; ++a) {
          if (rows[a][at] < 0) continue;
          own[cell * views_ + a].take(rows[a][at], 0.0);
          const std::size_t next = at + lag;
          if (rows[a][next] < 0) continue;
          for (std::size_t b = 0; b < a; ++b)
            if (rows[b][at] >= 0 && rows[b][next] >= 0)
              both[cell * pairs + pairOf(a, b)].take(rows[a][next] - rows[a][at], rows[b][next] - rows[b][at]);
        }
      }
    }

  moments_.resize(box.count() * views_);
  covariance_.resize(box.count() * pairs);
  for (int k = box.begin.z; k < box.end.z; ++k)
    for (int j = box.begin.y; j < box.end.y; ++j)
      for (int i = box.begin.x; i < box.end.x; ++i) {
        const std::size_t cell = box.indexOf(i, j, k);
        if (blended[cell] == 0 || stopped()) continue;
        const glm::ivec3 low = glm::max(glm::ivec3(i, j, k) - window, wide.begin);
        const glm::ivec3 high = glm::min(glm::ivec3(i, j, k) + window + 1, wide.end);
        const auto sumOver = [&](const std::vector<Sums>& sums, std::size_t of, std::size_t each) {
          Sums all;
          for (int c = low.z; c < high.z; ++c)
            for (int b = low.y; b < high.y; ++b)
              for (int a = low.x; a < high.x; ++a) all.add(sums[wide.indexOf(a, b, c) * each + of]);
          return all;
        };
        for (std::size_t a = 0; a < views_; ++a) {
          if (around[cell * views_ + a] == 0) continue;
          const Sums s = sumOver(own, a, views_);
          if (s.count < kFewest) continue;
          const double mean = s.first / s.count;
          moments_[cell * views_ + a] = {static_cast<float>(mean / kUnit),
                                         static_cast<float>(std::max(0.0, s.firstSquared / s.count - mean * mean) / (kUnit * kUnit))};
          for (std::size_t b = 0; b < a; ++b) {
            if (moments_[cell * views_ + b].variance < 0.0f) continue;
            const Sums p = sumOver(both, pairOf(a, b), pairs);
            if (p.count < kFewest) continue;
            // The correlation is that of the speckle both show, the deviations are each view's own.
            const double one = p.firstSquared - p.first * p.first / p.count;
            const double other = p.secondSquared - p.second * p.second / p.count;
            if (!(one > 0.0 && other > 0.0)) continue;
            const double correlation = std::clamp((p.product - p.first * p.second / p.count) / std::sqrt(one * other), 0.0, 1.0);
            covariance_[cell * pairs + pairOf(a, b)] =
                static_cast<float>(correlation * std::sqrt(static_cast<double>(moments_[cell * views_ + a].variance) *
                                                           static_cast<double>(moments_[cell * views_ + b].variance)));
          }
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
    const double share = static_cast<double>((corner & 1) ? x.part : 1.0f - x.part) *
                         static_cast<double>((corner & 2) ? y.part : 1.0f - y.part) *
                         static_cast<double>((corner & 4) ? z.part : 1.0f - z.part);
    if (share <= 0.0) continue;
    const std::size_t cell = box_.indexOf(x.cell + (corner & 1), y.cell + ((corner >> 1) & 1), z.cell + (corner >> 2));
    double cellMean = 0.0;
    double cellDeviation = 0.0;
    double cellVariance = 0.0;
    bool all = true;
    for (std::size_t a = 0; a < views_ && all; ++a) {
      if (weights[a] <= 0.0) continue;
      const Moments& m = moments_[cell * views_ + a];
      all = m.variance >= 0.0f;
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
