#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/volume.h"

namespace ew::registration {

/// Nodes along the axes of the fixed volume, in mm from the centre of its voxel (0, 0, 0).
struct NodeGrid {
  glm::ivec3 dims{1};
  glm::dvec3 spacing_mm{1.0};
  glm::dvec3 first_mm{0.0};

  [[nodiscard]] std::size_t count() const { return samplesIn(dims); }
  [[nodiscard]] std::size_t indexOf(int i, int j, int k) const { return sampleIndex(dims, i, j, k); }
  [[nodiscard]] glm::ivec3 cells() const { return glm::max(dims - 1, glm::ivec3(1)); }
  [[nodiscard]] double cellVolume_mm3() const { return spacing_mm.x * spacing_mm.y * spacing_mm.z; }
};

/// Per node: displacement along the fixed axes in mm (x, y, z) and brightness of the moving image, interleaved.
using NodeValues = std::vector<float>;

/// The energy of smoothness, 1/2 of
///   integral of membrane |grad u|^2 + bending |grad grad u|^2 + brightnessMembrane |grad b|^2 + brightness b^2,
/// in finite differences of the nodes. Neither term knows a constant displacement, the bending term no linear one.
struct Prior {
  double membrane = 0.0;            ///< per mm
  double bending = 0.0;             ///< mm
  double brightnessMembrane = 0.0;  ///< per mm
  double brightness = 0.0;          ///< per mm^3
};
void applyPrior(const NodeGrid& grid, const Prior& prior, const NodeValues& values, NodeValues& out);

/// What images say about the nodes: cells' sums, and the blocks they add up to.
struct NodeSystem {
  NodeGrid grid;
  std::vector<std::size_t> first;      ///< per node, and one more: where its blocks begin
  std::vector<std::size_t> neighbour;  ///< per block: the other node
  std::vector<float> blocks;           ///< 16 per block, column after column; symmetric
  NodeValues right;

  explicit NodeSystem(const NodeGrid& nodes);
  void clear();  ///< back to zeros
  /// Adds a cell's moments: `products` 3 x 3 x 3 x 10 (x slowest) and `right` 2 x 2 x 2 x 4, see elastic/rows.h.
  /// @param scale of displacement components in the matrix (not in the right-hand side)
  void addCell(const glm::ivec3& cell, const float* products, const float* right, float scale);
};

/// weight * system * in.
/// @param out as many as `in`
void multiplyData(const NodeSystem& system, double weight, const NodeValues& in, NodeValues& out);

struct Solution {
  NodeValues values;
  int iterations = 0;
  double residual = 0.0;  ///< over that of zero
  bool singular = false;  ///< a direction without any stiffness was met
};

/// Solves (dataWeight * system + prior) x = right by conjugate gradients, preconditioned by the exact inverse of the prior plus the mean
/// of the data (cosine transforms along the axes).
/// @param threads of a large system; the solution does not depend on them
[[nodiscard]] Solution solve(const NodeSystem& system, double dataWeight, const Prior& prior, const NodeValues& right, double tolerance,
                             int atMost, int threads = 1);

}  // namespace ew::registration
