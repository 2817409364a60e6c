#pragma once

#include "ew/core/memory.h"
#include "ew/core/surface_mesh.h"
#include "ew/labelling/labels.h"

namespace ew::labelling {

/// How surfaces are made from labels.
struct LabelSurfaceOptions {
  /// Waves of the surface along an axis of the grid that are halved; shorter ones, the stairs of the voxels, vanish, longer ones stay. 4 to
  /// 32, or 0: nothing is smoothed. Time grows with it.
  double shortestWave_voxel = 8.0;
  int threads = 0;  ///< as threadCount(); the surfaces do not depend on it
  std::uint64_t maxBytes = kLargestVolume_bytes;
};

/// The labels on the two sides of a triangle.
struct LabelSides {
  std::uint8_t front = 0;  ///< where its normal points to
  std::uint8_t back = 0;
  bool operator==(const LabelSides&) const = default;
};

/// The surfaces of all labels as one mesh: where two labels touch there is one sheet of triangles, which both share, and along a line where
/// three meet their sheets share its points. Label 0 is the outside: it bounds others and has no surface of its own.
/// A window keeps this, asks meshesOf for the labels it fades and colours one by one, and cuts all of them by one plane without gaps.
struct LabelSurfaces {
  std::vector<glm::vec3> points_mm;   ///< in the frame of the labels' grid
  std::vector<glm::ivec3> triangles;  ///< three points each, counterclockwise seen from the front
  std::vector<LabelSides> sides;      ///< of each triangle; never the same label twice
  std::vector<std::uint8_t> labels;   ///< that have a surface, ascending, without 0
  bool operator==(const LabelSurfaces&) const = default;
};

/// Memory that labelSurfaces takes for these labels at most, the surfaces included. Cost: one pass over the voxels.
[[nodiscard]] std::uint64_t labelSurfacesForecast_bytes(const VolumeView<const std::uint8_t>& labels, int threads = 0);

/// Smooth surfaces between the labels of a volume: closed, joint, and without crossings. What lies outside of the volume has label 0, so
/// that surfaces close at its border.
///
/// A cell is the cube between the centres of 2 x 2 x 2 voxels. Each that holds more than one label has one point, at first its middle; each
/// pair of neighbouring voxels of two labels has a face between the points of the four cells around it. Points are smoothed by a low-pass
/// filter over the net, exp(-ln 2 (k / kHalf)^3) of a wave with the number k, so that what is large beside the waves does not shrink: at
/// the default a ball of 4 voxels' radius and more keeps its volume within 1 %, one of 3 loses 4 %, one of 2 a third. Points where three
/// labels meet have neighbours along the line of three labels alone. No point leaves its cell: none is farther than the cell's half
/// diagonal from a place where the labels change. Source: Gibson, Constrained elastic surface nets, MICCAI 1998 (cells, faces, the
/// constraint); Taubin, Zhang and Golub, Optimal surface smoothing as filter design, ECCV 1996 (the filter as Chebyshev polynomials). Ours
/// takes any number of labels.
///
/// Why nothing crosses: two voxels e0, e1 and each two neighbouring of the four points around them, a and b, span a tetrahedron; the
/// segment from a to b passes through the square between their cells, because two neighbouring cells together are convex, so tetrahedra of
/// all faces overlap nowhere. A face cut into two triangles stays in its four tetrahedra when both triangles' planes meet the line from e0
/// to e1 between the two; the shorter diagonal for which that holds is taken, and where it holds for none the face is four triangles around
/// a point of that line. Source: Ju and Udeshi, Intersection-free contouring on an octree grid, Pacific Graphics 2006, which have a point
/// on every such line and square; ours need one for few faces and none for squares.
///
/// The boundary of every label uses each of its edges as often in one direction as in the other. Where voxels of a label touch by an edge
/// or a corner alone, its surface touches itself there.
/// @param labels any grid, oblique and left-handed ones too
/// @error as checkGrid; badField (shortestWave_voxel), tooLarge (maxBytes, or more than 2^30 triangles), cancelled (within 0.1 s)
[[nodiscard]] Result<LabelSurfaces> labelSurfaces(const VolumeView<const std::uint8_t>& labels, const LabelSurfaceOptions& options,
                                                  Progress& progress);

/// The closed surface of one label, its triangles' fronts outwards, with normals that are the mean of those of the triangles around a
/// point, weighted by area. Empty when the label has none.
[[nodiscard]] SurfaceMesh meshOf(const LabelSurfaces& surfaces, std::uint8_t label);

/// The same of every label, in the order of surfaces.labels.
/// @error cancelled
[[nodiscard]] Result<std::vector<SurfaceMesh>> meshesOf(const LabelSurfaces& surfaces, int threads, Progress& progress);

}  // namespace ew::labelling
