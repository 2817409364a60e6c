#pragma once

#include <array>
#include <cstdint>

namespace ew {

/// How long images took from pose to pixels: a histogram of fixed size, so that keeping it costs a frame nothing.
class LatencyHistogram {
 public:
  static constexpr int kBuckets = 64;  ///< logarithmic, four to a doubling from 16 us on
  /// A time below 0 counts as 0; one that is not finite is not counted.
  void add(double us);
  void clear() { *this = {}; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Upper edge of a bucket, us: 16 * 2^(bucket / 4), which the bucket includes; the last bucket holds all longer times and has the edge
  /// infinity.
  /// @param bucket 0..kBuckets - 1
  [[nodiscard]] static double edge_us(int bucket);
  [[nodiscard]] std::uint64_t inBucket(int bucket) const { return buckets_[static_cast<std::size_t>(bucket)]; }
  /// The smallest edge that `share` (0..1) of the images do not exceed, or the longest time there was when that is less; 0 when there are
  /// none. Good to a bucket (19 %).
  [[nodiscard]] double quantile_us(double share) const;
  [[nodiscard]] double max_us() const { return max_us_; }

 private:
  std::array<std::uint64_t, kBuckets> buckets_{};
  std::uint64_t count_ = 0;
  double max_us_ = 0.0;
};

}  // namespace ew
