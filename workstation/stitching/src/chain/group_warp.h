#pragma once

#include <optional>
#include <span>
#include <vector>

#include "chain/pair_match.h"
#include "ew/registration/elastic.h"

namespace ew::stitching {

/// How two views at their places in the world still differ: what shows at the fixed view's world point P shows at P + U(P) in the moving
/// one.
struct PairWarp {
  std::size_t fixed = 0;
  std::size_t moving = 0;
  registration::Deformation fixedToMoving;  ///< between the volumes' own frames
  double trust = 1.0;                       ///< 0..1: less when the images did not confirm it
};

struct WarpOptions {
  double fallOff_mm = 25.0;     ///< outside an overlap the warp is gone after so much
  double node_mm = 5.0;         ///< of the lattices that are made
  double leastJacobian = 0.15;  ///< no cell of a warp falls below, > 0
  int threads = 0;
};

struct GroupWarps {
  std::vector<registration::ControlGrid> warps;  ///< one per view, in the world: world point p shows the view's world point p + u(p)
  std::vector<double> largest_mm;                ///< one per view
  double smallestJacobian = 1.0;
  /// What the pairs still disagree by when all are heard, over the nodes of their overlaps: 0 when every loop of pairs closes.
  double disagreementMedian_mm = 0.0;
  double disagreement95_mm = 0.0;
};

/// Memory at the peak for views on these grids at their places.
[[nodiscard]] std::uint64_t forecastWarps_bytes(std::span<const Grid> placedGrids, std::size_t pairs, const WarpOptions& options);

/// Warps of all views together: at each node of one lattice the displacements of least squares that explain what the pairs found there,
/// with a small weight on their own size, so that each pair's motion is shared and the middle of the group stays where it is. A pair counts
/// fully where both views cover the node, and less and less outside, to nothing at fallOff_mm. See resources/decisions (warps of a group).
/// @param toWorld one per view
/// @error cancelled
[[nodiscard]] Result<GroupWarps> warpGroup(std::span<const ViewData* const> views,
                                           std::span<const Transform<frame::World, frame::View>> toWorld, std::span<const PairWarp> pairs,
                                           const WarpOptions& options, Progress& progress);

}  // namespace ew::stitching
