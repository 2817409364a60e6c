#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "ew/assessment/organ_voxels.h"

namespace ew {

struct CoverageOptions {
  double thickness_mm = 3.0;   ///< of the slab about the image plane that a frame passes through; at least a voxel's diagonal is taken
  double contactReach = 0.15;  ///< how far from a touching point of the face, in half faces, its lines still hear
};

/// The share of an organ that frames have passed through, frame by frame. A voxel is passed when its centre lies within half of the
/// thickness from the image plane, inside the fan, and below a part of the face that touches the skin. Shadows are not looked at: what
/// stands behind bone counts as passed. Between two frames nothing is assumed: a sweep faster than its thickness per frame leaves gaps.
/// A frame costs a test for each block of 8 x 8 x 8 voxels, a few vector instructions for each layer of the blocks that slab and fan meet
/// and that are not done, and an exact test for each voxel that is found there; no allocation.
class OrganCoverage {
 public:
  /// @param organ not null; shared, for a step that is begun again
  explicit OrganCoverage(std::shared_ptr<const OrganVoxels> organ, const CoverageOptions& options = {});

  /// @param gaps_mm of the face (gapsToSkin_mm), from its -x end to its +x end; empty: all of it touches
  /// @return voxels that are new; 0 for a pose that is not ok
  std::size_t add(const Fan& fan, const Pose& pose, const std::vector<float>& gaps_mm = {});

  /// 0..1; 1 of an organ without voxels.
  [[nodiscard]] double share() const;
  [[nodiscard]] std::size_t passed() const { return passed_; }
  [[nodiscard]] std::size_t of() const { return organ_->count(); }
  /// Whether voxel n of the organ (centres_mm) was passed.
  [[nodiscard]] bool isPassed(std::size_t n) const { return ((bits_[n / 64] >> (n % 64)) & 1U) != 0; }
  void clear();

 private:
  std::shared_ptr<const OrganVoxels> organ_;
  double halfThickness_mm_ = 0.0;
  double contactReach_ = 0.0;
  struct Frame;
  /// Passes those of a block's voxels (OrganVoxels::BlockMask::layers) that lie within the frame.
  void passThrough(std::size_t b, const std::array<std::uint64_t, 8>& voxels, const Frame& frame);

  std::vector<std::uint64_t> bits_;
  std::vector<std::uint32_t> left_;                       ///< voxels of each block not passed yet
  std::vector<std::array<std::uint64_t, 8>> layersLeft_;  ///< which they are (OrganVoxels::BlockMask::layers)
  std::size_t passed_ = 0;
};

}  // namespace ew
