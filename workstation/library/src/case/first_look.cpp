#include "ew/library/first_look.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ew {
namespace {

/// From the smallest to the largest coordinate along a direction.
struct Stretch {
  double lowest_mm = std::numeric_limits<double>::infinity();
  double highest_mm = -std::numeric_limits<double>::infinity();
  void add(double at_mm) {
    lowest_mm = std::min(lowest_mm, at_mm);
    highest_mm = std::max(highest_mm, at_mm);
  }
  [[nodiscard]] double length_mm() const { return std::max(0.0, highest_mm - lowest_mm); }
};

Stretch along(const std::vector<glm::dvec3>& points, const glm::dvec3& direction) {
  Stretch stretch;
  for (const glm::dvec3& p : points) stretch.add(glm::dot(p, direction));
  return stretch;
}

/// Wider below than at its face, as sectors are.
bool fansOut(const PlacingShape& shape) {
  constexpr double kWider = 1.3;
  return along(shape.inside_mm, shape.axes.lateral).length_mm() > kWider * along(shape.face_mm, shape.axes.lateral).length_mm();
}

/// How little a probe is like the one of a volume; 0: exactly.
double strangeness(const Probe& probe, double depth_mm, double face_mm, bool fans) {
  const auto off = [](double a, double b) { return std::abs(std::log(std::max(a, 1.0) / std::max(b, 1.0))); };
  constexpr double kFaceCounts = 0.5, kKindCounts = 0.5, kTooShallow = 3.0;
  return off(probe.defaultDepth_mm, depth_mm) + kFaceCounts * off(faceLength_mm(probe), face_mm) +
         (isSector(probe.kind) == fans ? 0.0 : kKindCounts) + (probe.maxDepth_mm < 0.8 * depth_mm ? kTooShallow : 0.0);
}

/// A place of the near face moved across the frames, into the plane of the nearest one: there the image is what was recorded.
glm::dvec3 inPlaneOfAFrame(const glm::dvec3& at_mm, const SweepAxes& axes, const Provenance& recorded) {
  const glm::dvec3 across = glm::cross(axes.lateral, axes.depth);
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const FrameProvenance& frame : recorded.frames) {
    const double off_mm = glm::dot(glm::dvec3(frame.imageToWorld.matrix[3]) - at_mm, across);
    if (std::abs(off_mm) < std::abs(nearest_mm)) nearest_mm = off_mm;
  }
  return std::isfinite(nearest_mm) ? at_mm + nearest_mm * across : at_mm;
}

}  // namespace

double depthOf_mm(const PlacingShape& shape) {
  Stretch depth = along(shape.face_mm, shape.axes.depth);
  for (const glm::dvec3& p : shape.inside_mm) depth.add(glm::dot(p, shape.axes.depth));
  return depth.length_mm();
}

bool showsWhole(const PlacingShape& shape, double depth_mm) {
  constexpr double kStamp = 0.4, kCut = 1.4;
  const double own_mm = depthOf_mm(shape);
  return own_mm >= kStamp * depth_mm && own_mm <= kCut * depth_mm;
}

std::optional<FirstLook> firstLookAt(const PlacingShape& shape, std::span<const Probe> probes) {
  const double depth_mm = depthOf_mm(shape), face_mm = along(shape.face_mm, shape.axes.lateral).length_mm();
  const bool fans = fansOut(shape);
  const Probe* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Probe& probe : probes) {
    if (probe.kind == ProbeKind::endocavity || probe.kind == ProbeKind::sweptSector) continue;
    const double strange = strangeness(probe, depth_mm, face_mm, fans);
    if (strange < least) {
      least = strange;
      nearest = &probe;
    }
  }
  if (nearest == nullptr || !(depth_mm > 0.0)) return std::nullopt;
  // A shape's points are few, and the deepest lies some way before the end of what was recorded.
  constexpr double kStep_mm = 5.0, kBeyond = 1.1;
  const double wanted_mm = kStep_mm * std::ceil(kBeyond * depth_mm / kStep_mm);
  return FirstLook{nearest->id, std::clamp(wanted_mm, nearest->minDepth_mm, nearest->maxDepth_mm)};
}

std::optional<FirstPlace> firstPlaceOf(const Volume& volume, const Provenance& recorded, const Skin& skin, const PlacingSite& site) {
  std::vector<TrackedFrame> frames;
  for (const FrameProvenance& each : recorded.frames) frames.push_back({{}, each.imageToWorld, {}});
  const auto axes = sweepAxesOf(frames);
  if (!axes) return std::nullopt;
  FirstPlace place{placingShapeOf(volume, *axes), {}, {}};
  if (place.shape.face_mm.empty()) return std::nullopt;
  place.fileToWorld = firstPlacement(place.shape, skin, site);
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : place.shape.face_mm) middle += p / static_cast<double>(place.shape.face_mm.size());
  middle = inPlaneOfAFrame(middle, *axes, recorded);
  const glm::dmat3 turned(place.fileToWorld.matrix);
  const glm::dvec3 lateral = turned * axes->lateral, depth = turned * axes->depth;
  glm::dmat4 probe(glm::dmat3(lateral, depth, glm::cross(lateral, depth)));
  probe[3] = glm::dvec4(carried(place.fileToWorld, middle), 1.0);
  place.start.probeToWorld.matrix = probe;
  return place;
}

}  // namespace ew
