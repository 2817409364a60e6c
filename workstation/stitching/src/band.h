#pragma once

#include <functional>

#include "cells.h"

namespace ew::stitching {

/// Where a voxel lies among cells, along one axis.
struct BetweenCells {
  int cell = 0;  ///< the lower of its two
  float part = 0.0F;
};

/// Keeps the speckle's deviation where views are blended. The mean of two views whose speckle is independent has a deviation up to sqrt(2)
/// lower than either, which shows as a smooth band. So the blend's departure from the local mean is stretched by
///   g = sum_n w_n s_n / sqrt(sum_ab w_a w_b c_ab),
/// with the weights w (their sum 1), the local deviations s of the views and their local covariances c. Views whose speckle agrees have
/// c_ab = s_a s_b, so g = 1 and the plain blend stays; g is never below 1.
/// The correlation within c_ab is that of differences over 0.8 mm, so that structure both views show does not pass for speckle they share.
/// Moments are those of the voxels within about 2.2 mm of a cell; between cells they are linear.
class Band {
 public:
  /// @param weights per view in `views` its weight on the cells of `box`; cells where only one view weighs are not looked at
  Band(const std::vector<ViewSampler>& samplers, const std::vector<std::size_t>& views, const std::vector<const float*>& weights,
       const CellBox& box, const Grid& cells, const glm::ivec3& ratio, const std::function<bool()>& stopped);

  [[nodiscard]] bool empty() const { return moments_.empty(); }

  /// The blend of some views at a voxel.
  /// @param weights one per view; 0: not part of it
  /// @param plainMean their weighted mean
  [[nodiscard]] double blend(const BetweenCells& x, const BetweenCells& y, const BetweenCells& z, const double* weights,
                             double plainMean) const;

  [[nodiscard]] static glm::ivec3 windowOf(const Grid& cells);
  /// Of the box and its window, while so many views are looked at.
  [[nodiscard]] static std::uint64_t bytesPerCell(std::uint64_t views);

 private:
  struct Moments {
    float mean = 0.0F;
    float variance = -1.0F;  ///< below 0: not known
  };
  struct Gathered;
  void takeMoments(const Gathered& gathered, const glm::ivec3& at);
  [[nodiscard]] static std::size_t pairOf(std::size_t a, std::size_t b) { return a * (a - 1) / 2 + b; }  // a > b

  CellBox box_;
  std::size_t views_ = 0;
  std::vector<Moments> moments_;   ///< (cells of the box) x views
  std::vector<float> covariance_;  ///< (cells of the box) x pairs
};

}  // namespace ew::stitching
