#include "ew/imaging/latency.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/core/contract.h"

namespace ew {
namespace {

using Edges = std::array<double, LatencyHistogram::kBuckets>;

constexpr Edges makeEdges() {
  constexpr std::array<double, 4> kQuarterDoublings = {1.0, 1.189207115002721, 1.4142135623730951, 1.681792830507429};
  Edges edges{};
  double doubled = 16.0;
  for (std::size_t n = 0; n < edges.size(); ++n) {
    edges[n] = doubled * kQuarterDoublings[n % 4];
    if (n % 4 == 3) doubled *= 2.0;
  }
  edges.back() = std::numeric_limits<double>::infinity();
  return edges;
}

constexpr Edges kEdges_us = makeEdges();

}  // namespace

void LatencyHistogram::add(double us) {
  if (!std::isfinite(us)) return;
  const double usable_us = std::max(us, 0.0);
  ++buckets_[static_cast<std::size_t>(std::lower_bound(kEdges_us.begin(), kEdges_us.end(), usable_us) - kEdges_us.begin())];
  ++count_;
  max_us_ = std::max(max_us_, usable_us);
}

double LatencyHistogram::edge_us(int bucket) {
  EW_EXPECTS(bucket >= 0 && bucket < kBuckets);
  return kEdges_us[static_cast<std::size_t>(bucket)];
}

double LatencyHistogram::quantile_us(double share) const {
  if (count_ == 0) return 0.0;
  // NaN compares false.
  const double usable = share > 0.0 ? std::min(share, 1.0) : 0.0;
  const auto wanted = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(usable * static_cast<double>(count_))));
  std::uint64_t within = 0;
  for (int bucket = 0; bucket < kBuckets; ++bucket) {
    within += inBucket(bucket);
    if (within >= wanted) return std::min(edge_us(bucket), max_us_);
  }
  return max_us_;
}

}  // namespace ew
