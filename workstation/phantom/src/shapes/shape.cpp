#include "shapes/shape.h"

#include <cmath>
#include <limits>
#include <optional>

#include "ew/core/contract.h"

namespace ew::phantom {
namespace {

// Half spaces reach beyond any scene; a finite box keeps arithmetic on bounds free of infinities.
constexpr double kFar_mm = 1e5;

class EllipsoidShape final : public Shape {
 public:
  explicit EllipsoidShape(const Ellipsoid& e)
      : drawn_(e), toAxes_(glm::transpose(e.axes)), smallest_(glm::min(e.radii_mm.x, glm::min(e.radii_mm.y, e.radii_mm.z))) {
    inverse_ = 1.0 / e.radii_mm;
    glm::dvec3 half;
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 row(e.axes[0][axis] * e.radii_mm.x, e.axes[1][axis] * e.radii_mm.y, e.axes[2][axis] * e.radii_mm.z);
      half[axis] = glm::length(row);
    }
    bounds_ = {e.centre_mm - half, e.centre_mm + half};
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    const glm::dvec3 scaled = (toAxes_ * (p_mm - drawn_.centre_mm)) * inverse_;
    const double level = glm::length(scaled);
    if (level < 1e-9) return -smallest_;
    return level * (level - 1.0) / glm::length(scaled * inverse_);
  }
  const Ellipsoid* ellipsoid() const override { return &drawn_; }

 private:
  Ellipsoid drawn_;
  glm::dmat3 toAxes_;
  glm::dvec3 inverse_;
  double smallest_;
};

class HalfSpace final : public Shape {
 public:
  HalfSpace(const glm::dvec3& point_mm, const glm::dvec3& normal) : point_(point_mm), normal_(glm::normalize(normal)) {
    bounds_ = {glm::dvec3(-kFar_mm), glm::dvec3(kFar_mm)};
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(std::abs(normal_[axis]) - 1.0) > 1e-12) continue;
      (normal_[axis] > 0.0 ? bounds_.highest_mm : bounds_.lowest_mm)[axis] = point_[axis];
    }
  }
  double distance_mm(const glm::dvec3& p_mm) const override { return glm::dot(p_mm - point_, normal_); }

 private:
  glm::dvec3 point_;
  glm::dvec3 normal_;
};

class Shell final : public Shape {
 public:
  Shell(ShapePtr of, double from, double to) : of_(std::move(of)), from_(from), to_(to) {
    countPart(*of_);
    bounds_ = {of_->bounds().lowest_mm + glm::dvec3(std::min(from, 0.0)), of_->bounds().highest_mm - glm::dvec3(std::min(from, 0.0))};
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    const double d = of_->distance_mm(p_mm);
    return std::max(d + from_, -d - to_);
  }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    const double d = of_->distanceUpTo_mm(p_mm, most_mm - from_);
    return std::max(d + from_, -d - to_);
  }

 private:
  ShapePtr of_;
  double from_;
  double to_;
};

class Offset final : public Shape {
 public:
  Offset(ShapePtr of, double grow) : of_(std::move(of)), grow_(grow) {
    countPart(*of_);
    bounds_ = {of_->bounds().lowest_mm - glm::dvec3(std::max(grow, 0.0)), of_->bounds().highest_mm + glm::dvec3(std::max(grow, 0.0))};
    if (of_->centreLine()) {
      line_ = *of_->centreLine();
      for (glm::dvec4& point : line_.points_mm) point.w = std::max(0.0, point.w + grow);
    }
  }
  double distance_mm(const glm::dvec3& p_mm) const override { return of_->distance_mm(p_mm) - grow_; }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    return of_->distanceUpTo_mm(p_mm, most_mm + grow_) - grow_;
  }
  const CentreLine* centreLine() const override { return of_->centreLine() ? &line_ : nullptr; }

 private:
  ShapePtr of_;
  double grow_;
  CentreLine line_;
};

class Placed final : public Shape {
 public:
  Placed(ShapePtr of, const DrawingFrame& frame) : of_(std::move(of)), frame_(frame) {
    countPart(*of_);
    const Bounds& drawn = of_->bounds();
    for (int corner = 0; corner < 8; ++corner) {
      const auto pick = [&](int axis) { return ((corner >> axis) & 1) != 0 ? drawn.highest_mm[axis] : drawn.lowest_mm[axis]; };
      const glm::dvec3 placed = frame_.toWorld({pick(0), pick(1), pick(2)});
      bounds_.lowest_mm = corner == 0 ? placed : glm::min(bounds_.lowest_mm, placed);
      bounds_.highest_mm = corner == 0 ? placed : glm::max(bounds_.highest_mm, placed);
    }
    if (const CentreLine* drawnLine = of_->centreLine())
      for (const glm::dvec4& point : drawnLine->points_mm) line_.points_mm.emplace_back(frame_.toWorld(glm::dvec3(point)), point.w);
    if (const Ellipsoid* ellipsoid = of_->ellipsoid())
      placed_ = Ellipsoid{frame_.toWorld(ellipsoid->centre_mm), ellipsoid->radii_mm, frame_.axes * ellipsoid->axes};
  }
  double distance_mm(const glm::dvec3& p_mm) const override { return of_->distance_mm(frame_.fromWorld(p_mm)); }
  double atLeast_mm(const glm::dvec3& p_mm) const override { return of_->atLeast_mm(frame_.fromWorld(p_mm)); }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    return of_->distanceUpTo_mm(frame_.fromWorld(p_mm), most_mm);
  }
  const CentreLine* centreLine() const override { return line_.points_mm.empty() ? nullptr : &line_; }
  const Ellipsoid* ellipsoid() const override { return placed_ ? &*placed_ : nullptr; }

 private:
  ShapePtr of_;
  DrawingFrame frame_;
  CentreLine line_;
  std::optional<Ellipsoid> placed_;
};

class Mirrored final : public Shape {
 public:
  Mirrored(ShapePtr of, double smoothing) : of_(std::move(of)), squared_(smoothing * smoothing) {
    countPart(*of_);
    bounds_ = of_->bounds();
    const double reach = std::max(std::abs(bounds_.lowest_mm.x), std::abs(bounds_.highest_mm.x));
    bounds_.lowest_mm.x = -reach;
    bounds_.highest_mm.x = reach;
  }
  double distance_mm(const glm::dvec3& p_mm) const override { return of_->distance_mm(folded(p_mm)); }
  double atLeast_mm(const glm::dvec3& p_mm) const override { return of_->atLeast_mm(folded(p_mm)); }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override { return of_->distanceUpTo_mm(folded(p_mm), most_mm); }

 private:
  [[nodiscard]] glm::dvec3 folded(const glm::dvec3& p_mm) const { return {std::sqrt(p_mm.x * p_mm.x + squared_), p_mm.y, p_mm.z}; }

  ShapePtr of_;
  double squared_;
};

class Union final : public Shape {
 public:
  explicit Union(std::vector<BlendPart> parts) : parts_(std::move(parts)) {
    bounds_ = parts_.front().shape->bounds();
    double blend = 0.0;
    for (const BlendPart& part : parts_) {
      countPart(*part.shape);
      bounds_.lowest_mm = glm::min(bounds_.lowest_mm, part.shape->bounds().lowest_mm);
      bounds_.highest_mm = glm::max(bounds_.highest_mm, part.shape->bounds().highest_mm);
      blend = std::max(blend, part.blend_mm);
    }
    widest_mm_ = blend;
    bounds_.lowest_mm -= glm::dvec3(0.25 * blend);  // how far a blend can bulge beyond what it joins
    bounds_.highest_mm += glm::dvec3(0.25 * blend);
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    return joined(p_mm, [&](const BlendPart& part) { return part.shape->distance_mm(p_mm); });
  }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    // What lies a blend beyond neither counts nor brings what it is blended with below `most_mm`.
    return joined(p_mm, [&](const BlendPart& part) { return part.shape->distanceUpTo_mm(p_mm, most_mm + widest_mm_); });
  }
  const CentreLine* centreLine() const override { return parts_.front().shape->centreLine(); }

 private:
  template <class Distance>
  [[nodiscard]] double joined(const glm::dvec3& p_mm, const Distance& distanceTo) const {
    double joined = std::numeric_limits<double>::infinity();
    for (const BlendPart& part : parts_) {
      // A part whose box alone is farther than the result plus the blend cannot change it.
      const double atLeast = part.shape->atLeast_mm(p_mm);
      if (atLeast > 0.0 && atLeast > joined + part.blend_mm) continue;
      const double d = distanceTo(part);
      joined = std::isinf(joined) ? d : smoothMin(joined, d, part.blend_mm);
    }
    return joined;
  }

  std::vector<BlendPart> parts_;
  double widest_mm_ = 0.0;  ///< of the blends
};

class Intersection final : public Shape {
 public:
  explicit Intersection(std::vector<BlendPart> parts) : parts_(std::move(parts)) {
    bounds_ = parts_.front().shape->bounds();
    for (const BlendPart& part : parts_) {
      countPart(*part.shape);
      bounds_.lowest_mm = glm::max(bounds_.lowest_mm, part.shape->bounds().lowest_mm);
      bounds_.highest_mm = glm::min(bounds_.highest_mm, part.shape->bounds().highest_mm);
    }
    bounds_.highest_mm = glm::max(bounds_.highest_mm, bounds_.lowest_mm);  // parts that do not meet: an empty box, not an inverted one
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    double joined = parts_.front().shape->distance_mm(p_mm);
    for (std::size_t n = 1; n < parts_.size(); ++n) joined = smoothMax(joined, parts_[n].shape->distance_mm(p_mm), parts_[n].blend_mm);
    return joined;
  }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    double joined = parts_.front().shape->distanceUpTo_mm(p_mm, most_mm);
    for (std::size_t n = 1; n < parts_.size() && joined < most_mm; ++n)
      joined = smoothMax(joined, parts_[n].shape->distanceUpTo_mm(p_mm, most_mm), parts_[n].blend_mm);
    return joined;
  }
  const CentreLine* centreLine() const override { return parts_.front().shape->centreLine(); }

 private:
  std::vector<BlendPart> parts_;
};

class Difference final : public Shape {
 public:
  explicit Difference(std::vector<BlendPart> parts) : parts_(std::move(parts)) {
    for (const BlendPart& part : parts_) countPart(*part.shape);
    bounds_ = parts_.front().shape->bounds();
  }
  double distance_mm(const glm::dvec3& p_mm) const override { return without(p_mm, parts_.front().shape->distance_mm(p_mm)); }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    const double first = parts_.front().shape->distanceUpTo_mm(p_mm, most_mm);
    return first < most_mm ? without(p_mm, first) : first;
  }
  const CentreLine* centreLine() const override { return parts_.front().shape->centreLine(); }

 private:
  [[nodiscard]] double without(const glm::dvec3& p_mm, double joined) const {
    for (std::size_t n = 1; n < parts_.size(); ++n) {
      const double atLeast = parts_[n].shape->atLeast_mm(p_mm);
      if (atLeast > 0.0 && -atLeast < joined - parts_[n].blend_mm) continue;
      joined = smoothMax(joined, -parts_[n].shape->distance_mm(p_mm), parts_[n].blend_mm);
    }
    return joined;
  }

  std::vector<BlendPart> parts_;
};

}  // namespace

double distanceToBox_mm(const glm::dvec3& p_mm, const Bounds& box) {
  const glm::dvec3 outside = glm::max(glm::max(box.lowest_mm - p_mm, p_mm - box.highest_mm), glm::dvec3(0.0));
  return glm::length(outside);
}

double smoothMin(double a_mm, double b_mm, double blend_mm) {
  const double smaller = std::min(a_mm, b_mm);
  const double overlap = blend_mm - std::abs(a_mm - b_mm);
  return overlap > 0.0 ? smaller - overlap * overlap / (4.0 * blend_mm) : smaller;
}

ShapePtr makeEllipsoid(const Ellipsoid& ellipsoid) {
  EW_EXPECTS(ellipsoid.radii_mm.x > 0.0 && ellipsoid.radii_mm.y > 0.0 && ellipsoid.radii_mm.z > 0.0);
  return std::make_shared<EllipsoidShape>(ellipsoid);
}
ShapePtr makeHalfSpace(const glm::dvec3& point_mm, const glm::dvec3& outwardNormal) {
  EW_EXPECTS(glm::length(outwardNormal) > 0.0);
  return std::make_shared<HalfSpace>(point_mm, outwardNormal);
}
ShapePtr makeShell(ShapePtr of, double fromDepth_mm, double toDepth_mm) {
  EW_EXPECTS(of && fromDepth_mm < toDepth_mm);
  return std::make_shared<Shell>(std::move(of), fromDepth_mm, toDepth_mm);
}
ShapePtr makeOffset(ShapePtr of, double grow_mm) {
  EW_EXPECTS(of);
  return std::make_shared<Offset>(std::move(of), grow_mm);
}
ShapePtr makePlaced(ShapePtr of, const DrawingFrame& frame) {
  EW_EXPECTS(of);
  return std::make_shared<Placed>(std::move(of), frame);
}
ShapePtr makeMirrored(ShapePtr of, double smoothing_mm) {
  EW_EXPECTS(of && smoothing_mm >= 0.0);
  return std::make_shared<Mirrored>(std::move(of), smoothing_mm);
}
ShapePtr makeUnion(std::vector<BlendPart> parts) {
  EW_EXPECTS(!parts.empty());
  return std::make_shared<Union>(std::move(parts));
}
ShapePtr makeIntersection(std::vector<BlendPart> parts) {
  EW_EXPECTS(!parts.empty());
  return std::make_shared<Intersection>(std::move(parts));
}
ShapePtr makeDifference(std::vector<BlendPart> parts) {
  EW_EXPECTS(!parts.empty());
  return std::make_shared<Difference>(std::move(parts));
}

}  // namespace ew::phantom
