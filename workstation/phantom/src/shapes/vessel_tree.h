#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "shapes/shape.h"

namespace ew::phantom {

/// A vessel from where its parent ends to where it forks or ends itself.
struct VesselBranch {
  glm::dvec3 from_mm{0.0};
  glm::dvec3 to_mm{0.0};
  double radius_mm = 1.0;
  int parent = -1;     ///< its place among the branches, before this one; -1: a root
  bool drawn = false;  ///< part of a trunk: it lies where it was drawn
  bool operator==(const VesselBranch&) const = default;
};

struct VesselTree {
  std::vector<VesselBranch> branches;  ///< parents before their children
  bool operator==(const VesselTree&) const = default;
};

/// What a tree is grown from and within.
struct VesselGrowth {
  ShapePtr within;                              ///< the organ it supplies; trunks may begin outside
  std::vector<std::vector<glm::dvec3>> trunks;  ///< polylines from root to tip; one that begins near an earlier one leaves it there
  int ends = 100;                               ///< thinnest branches, those of trunks counted
  double endRadius_mm = 0.7;
  double margin_mm = 3.0;       ///< ends stay this far below the organ's surface, all branches a third of it
  std::vector<ShapePtr> avoid;  ///< other trees
  double clearance_mm = 2.0;    ///< from their surfaces, and between branches of this one
  std::uint64_t seed = 1;
};

/// Radius of a vessel that feeds so many ends: Murray's law, r0^3 = r1^3 + r2^3 at every fork.
[[nodiscard]] double radiusFeeding_mm(int ends, double endRadius_mm);

/// A tree that supplies an organ evenly. The same growth gives the same tree. Fewer ends than asked for when the organ is full.
/// Source: constrained constructive optimisation, Schreiner and Buxbaum, IEEE Trans. Biomed. Eng. 40(5), 1993: ends at random places,
/// each joined where the tree's volume grows least. Ours differs: flows only count ends, radii follow by Murray (Proc. Natl. Acad. Sci.
/// 12, 1926); trunks are given; the angle between two branches of a fork that is not drawn lies between 30 and 80 degrees.
[[nodiscard]] VesselTree growVesselTree(const VesselGrowth& growth);

/// The vessels as a solid: every branch a tube that leaves its parent smoothly and curves a little. A branch without parent and children
/// is exactly a capsule.
[[nodiscard]] ShapePtr makeVesselTree(VesselTree tree, std::uint64_t seed);

/// A vessel that runs beside the branches of another tree.
struct VesselsBeside {
  double ratio = 0.4;               ///< of its radius to that of the vessel it accompanies
  double leastRadius_mm = 1.5;      ///< of the vessels that have company
  double gap_mm = 0.4;              ///< between the two surfaces
  glm::dvec3 side{0.0, -1.0, 0.0};  ///< where it lies, seen from the roots; carried along the branches
};
/// @return empty when no branch is wide enough
[[nodiscard]] VesselTree vesselsBeside(const VesselTree& tree, const VesselsBeside& beside);

}  // namespace ew::phantom
