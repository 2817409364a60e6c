#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "elastic/level_image.h"
#include "elastic/node_system.h"
#include "elastic/rows.h"
#include "ew/core/progress.h"
#include "ew/core/volume.h"

namespace ew::registration {

/// From mm along the fixed volume's axes to the moving volume's index space (mm along its axes), rigid part only.
struct AxesTransform {
  glm::dmat3 turn{1.0};
  glm::dvec3 shift_mm{0.0};
};
[[nodiscard]] AxesTransform axesTransformOf(const Grid& fixed, const Grid& moving,
                                            const Transform<frame::Moving, frame::Fixed>& fixedToMoving);

/// How cost and normal equations are formed.
struct CostOptions {
  double scale = 1.5;        ///< c of the robust cost r^2 / (1 + r^2 / c^2)
  double ofFixed = 0.5;      ///< share of the fixed image's gradient; 0: the exact gradient of the cost
  double leastCommon = 1.0;  ///< displacement components of the matrix are scaled by the common share of the gradients, no lower than this
};

/// Sums over the samples both sides cover, see Sums in elastic/rows.h.
struct PairSums {
  std::array<double, kSums> at{};
  [[nodiscard]] double weight() const { return at[0]; }
  [[nodiscard]] double meanCost() const { return at[0] > 0.0 ? at[1] / at[0] : 0.0; }
  [[nodiscard]] double correlation() const;
  /// Samples that tell the same: how far residuals of neighbours are alike, as the volume (in samples) of one independent residual.
  [[nodiscard]] double residualVolume(const glm::ivec3& dims) const;
  /// Share of the gradients' energy that both images have in common, at most 1.
  [[nodiscard]] double commonGradient() const { return at[12] > 0.0 ? at[11] / at[12] : 0.0; }
};

/// Two images of one level, and the moving one as it looks on the fixed grid.
class LevelPair {
 public:
  LevelPair(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& fixedToMoving, const NodeGrid& nodes, int threads);

  /// @return false when cancelled; so are the others
  [[nodiscard]] bool warp(const NodeValues& values, Progress& progress);
  /// Of what was warped last. @param system null: sums alone
  [[nodiscard]] bool assemble(const CostOptions& options, NodeSystem* system, PairSums& sums, Progress& progress) const;

  /// From now on samples count little where one image is much darker than the other, compared with how they differ elsewhere around: in the
  /// shadow of bone or gas, whose edges would pull at the tissue of the other image.
  /// @param values at which it was warped last
  [[nodiscard]] bool doubtShadows(const NodeValues& values, Progress& progress);

  /// From now on samples count by how well what was warped last agrees around them: the local correlation (window of standard deviation
  /// `window_mm`) over that of all, between `least` and 1. In a shadow only noise is left, which would pull as hard as tissue does.
  [[nodiscard]] bool trustAgreement(double window_mm, double least, double power, Progress& progress);

  [[nodiscard]] const LevelImage& fixed() const { return *fixed_; }
  [[nodiscard]] const std::vector<float>& moved() const { return moved_; }
  [[nodiscard]] const std::vector<float>& movedWeights() const { return movedWeights_; }

 private:
  /// Makes samples count by `map` too, those of the last warp included.
  [[nodiscard]] bool believe(BlockMap map, Progress& progress);
  void pointAt(int j, int k, RowPair& pair) const;
  void sumLine(std::size_t cy, std::size_t cz, const CostOptions& options, float* moments, std::array<double, kSums>& part) const;
  [[nodiscard]] glm::dvec3 displacementAt(const NodeValues& values, const glm::dvec3& sample) const;  // mm, at a fixed sample

  const LevelImage* fixed_;
  const LevelImage* moving_;
  NodeGrid nodes_;
  int threads_;
  glm::dmat3 perMm_{1.0};       // moving index per mm along the fixed axes
  glm::dvec3 firstIndex_{0.0};  // moving index of fixed sample (0, 0, 0)
  std::array<std::vector<int>, 3> cell_;
  std::array<std::vector<float>, 3> share_;
  std::array<std::vector<int>, 3> begin_;  // per cell, and one more: its first sample
  std::vector<float> along_;               // see gatherCell
  BlockMap trust_;                         // without blocks: 1 everywhere
  std::vector<float> moved_;
  std::vector<float> movedWeights_;
};

}  // namespace ew::registration
