#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "ew/core/volume.h"

namespace ew::phantom {

/// Distance from a point to a box; 0 inside. A lower bound of the distance to whatever the box holds.
[[nodiscard]] double distanceToBox_mm(const glm::dvec3& p_mm, const Bounds& box);

/// The line along which a tube runs, as the polyline its surface is made about: place and radius at each point, mm.
struct CentreLine {
  std::vector<glm::dvec4> points_mm;
};

struct Ellipsoid;
struct VesselTree;

/// An implicit solid: signed distance in mm (negative inside) and a box that holds all of it.
/// Distances are exact for spheres, capsules, tubes and planes; ellipsoids and lofts give the first-order distance F / |grad F|,
/// which has the exact sign everywhere and the exact distance on the surface and on the axes.
class Shape {
 public:
  virtual ~Shape() = default;
  [[nodiscard]] virtual double distance_mm(const glm::dvec3& p_mm) const = 0;
  /// At most the distance (0 inside), and cheaper to have.
  [[nodiscard]] virtual double atLeast_mm(const glm::dvec3& p_mm) const { return distanceToBox_mm(p_mm, bounds_); }
  /// The distance where it is below `most_mm`; where it is not, a number from that on, much sooner. What is farther than `most_mm` from the
  /// box counts as that far, also where a first-order distance (of a flat ellipsoid beyond its rim) says less.
  [[nodiscard]] virtual double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const {
    const double atLeast = atLeast_mm(p_mm);
    return atLeast > 0.0 && atLeast >= most_mm ? atLeast : distance_mm(p_mm);
  }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  /// Of a tube, of a tube that is grown, and of blends whose first part is one; null for everything else.
  [[nodiscard]] virtual const CentreLine* centreLine() const { return nullptr; }
  /// Of an ellipsoid, in the world; null for everything else.
  [[nodiscard]] virtual const Ellipsoid* ellipsoid() const { return nullptr; }
  /// Of thin sheets, how thick they are: where voxels are wider no two faces can be told apart, and middle_mm stands for both. 0: a solid.
  [[nodiscard]] virtual double sheetThickness_mm() const { return 0.0; }
  /// Of thin sheets, the signed distance to the middle of the nearest one, which changes its sign across it and jumps half way to the next;
  /// where that has a gap it goes on. Of everything else the distance.
  [[nodiscard]] virtual double middle_mm(const glm::dvec3& p_mm) const { return distance_mm(p_mm); }
  /// Of a tree of vessels; null for everything else.
  [[nodiscard]] virtual const VesselTree* vessels() const { return nullptr; }
  /// Of a tree of vessels, the line of each branch, from its root to its end; null for everything else.
  [[nodiscard]] virtual const std::vector<CentreLine>* branchLines() const { return nullptr; }
  /// Solids that one call of distance_mm may ask, a shared one counted at every use: what a point costs.
  [[nodiscard]] double solids() const { return solids_; }
  /// Shapes inside one another on the longest way down, this one included: how deep distance_mm recurses.
  [[nodiscard]] int depth() const { return depth_; }

 protected:
  void countPart(const Shape& part) {
    solids_ += part.solids_;
    depth_ = std::max(depth_, part.depth_ + 1);
  }

  Bounds bounds_;
  double solids_ = 1.0;
  int depth_ = 1;
};
using ShapePtr = std::shared_ptr<const Shape>;

/// A rigid frame of its own to draw in: columns of `axes` are its directions in the world, orthonormal and right-handed.
struct DrawingFrame {
  glm::dvec3 origin_mm{0.0};
  glm::dmat3 axes{1.0};
  [[nodiscard]] glm::dvec3 toWorld(const glm::dvec3& p_mm) const { return origin_mm + axes * p_mm; }
  [[nodiscard]] glm::dvec3 fromWorld(const glm::dvec3& p_mm) const { return glm::transpose(axes) * (p_mm - origin_mm); }
};

/// Minimum of two distances with the crease rounded over `blend_mm` (quadratic, so the gradient is continuous); the plain minimum
/// where they differ by more than `blend_mm`. Never above the minimum, at most blend_mm / 4 below it.
[[nodiscard]] double smoothMin(double a_mm, double b_mm, double blend_mm);
[[nodiscard]] inline double smoothMax(double a_mm, double b_mm, double blend_mm) { return -smoothMin(-a_mm, -b_mm, blend_mm); }

struct Ellipsoid {
  glm::dvec3 centre_mm{0.0};
  glm::dvec3 radii_mm{1.0};
  glm::dmat3 axes{1.0};  ///< columns: directions of the three radii, orthonormal
};
struct RoundCone {
  glm::dvec3 from_mm{0.0};
  glm::dvec3 to_mm{0.0};
  double fromRadius_mm = 1.0;
  double toRadius_mm = 1.0;
};
/// A cross-section of a loft at height z: half an ellipse to the front (-y), half to the back, boxier with `squareness` 0..1.
struct LoftSection {
  double z_mm = 0.0;
  double centreX_mm = 0.0;
  double centreY_mm = 0.0;
  double halfWidth_mm = 1.0;
  double front_mm = 1.0;
  double back_mm = 1.0;
  double squareness = 0.0;
};

[[nodiscard]] ShapePtr makeEllipsoid(const Ellipsoid& ellipsoid);
[[nodiscard]] ShapePtr makeRoundCone(const RoundCone& cone);
/// A tube along the Catmull-Rom spline through the points (at least two), its radius interpolated with them.
[[nodiscard]] ShapePtr makeTube(const std::vector<glm::dvec3>& points_mm, const std::vector<double>& radii_mm);
/// Sections by rising z (at least two), joined by a cubic spline, capped at both ends with rims rounded by `capRounding_mm`.
[[nodiscard]] ShapePtr makeLoft(const std::vector<LoftSection>& sections, double capRounding_mm);
/// The half space behind the plane: inside where (p - point) . normal < 0.
[[nodiscard]] ShapePtr makeHalfSpace(const glm::dvec3& point_mm, const glm::dvec3& outwardNormal);
/// The part of `of` that lies between two depths below its surface.
[[nodiscard]] ShapePtr makeShell(ShapePtr of, double fromDepth_mm, double toDepth_mm);
/// `of` grown (or, below 0, shrunk) by a distance.
[[nodiscard]] ShapePtr makeOffset(ShapePtr of, double grow_mm);
/// `of`, drawn in `frame`, as it lies in the world.
[[nodiscard]] ShapePtr makePlaced(ShapePtr of, const DrawingFrame& frame);
/// `of` (drawn on the left side, x > 0) and its mirror image; |x| is rounded over `smoothing_mm` so that the midline has no crease.
[[nodiscard]] ShapePtr makeMirrored(ShapePtr of, double smoothing_mm);

/// Ridges (or, below 0, furrows) on a surface along lines and their mirror images.
struct ReliefLine {
  /// Each a spline through its points, or a dot; x, y, z in mm and the share of the height, 0..1. Put on the surface before use.
  std::vector<std::vector<glm::dvec4>> lines;
  double halfWidth_mm = 10.0;  ///< > 0; to where nothing is raised any more
  double height_mm = 0.0;      ///< on the line where its share is 1; falls off as (1 - (r / halfWidth)^2)^2
};
/// `of`, its surface raised by the sum of the lines' heights and nowhere by more. Points farther than 30 mm from the surface are as before.
[[nodiscard]] ShapePtr makeRelief(ShapePtr of, const std::vector<ReliefLine>& lines);

/// Parts joined one after the other, each with its own blend.
struct BlendPart {
  ShapePtr shape;
  double blend_mm = 0.0;
};
[[nodiscard]] ShapePtr makeUnion(std::vector<BlendPart> parts);
[[nodiscard]] ShapePtr makeIntersection(std::vector<BlendPart> parts);
/// The first part without the others.
[[nodiscard]] ShapePtr makeDifference(std::vector<BlendPart> parts);

}  // namespace ew::phantom
