#include "contour.h"

#include <algorithm>
#include <limits>

#include "ew/labelling/between.h"
#include "voxel_boxes.h"

namespace ew::labelling {

bool isInside(std::span<const glm::dvec2> contour, const glm::dvec2& at) {
  bool inside = false;
  for (std::size_t n = 0, before = contour.size() - 1; n < contour.size(); before = n++) {
    const glm::dvec2 &a = contour[before], &b = contour[n];
    // Half open in y, so that a corner on the ray counts once.
    if ((a.y > at.y) == (b.y > at.y)) continue;
    if (at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

double toSegment_mm(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  return toSegment_mm(glm::dvec3(p, 0.0), glm::dvec3(a, 0.0), glm::dvec3(b, 0.0));
}

double signedDistance_mm(std::span<const glm::dvec2> contour, const glm::dvec2& at_mm) {
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0, before = contour.size() - 1; n < contour.size(); before = n++)
    nearest_mm = std::min(nearest_mm, toSegment_mm(at_mm, contour[before], contour[n]));
  return !contour.empty() && isInside(contour, at_mm) ? -nearest_mm : nearest_mm;
}

VoxelBox fillContour(Volume& labels, const Transform<frame::File, frame::Probe>& planeToFile, std::span<const glm::dvec2> contour,
                     double halfThickness_mm, const Brush& brush) {
  if (contour.size() < 3 || halfThickness_mm < 0.0) return {};
  const auto toVoxel = labels.grid.toVoxel<frame::File>() * planeToFile;
  std::vector<glm::dvec3> corners;
  for (const glm::dvec2& p : contour)
    for (const double z : {-halfThickness_mm, halfThickness_mm}) corners.push_back(carried(toVoxel, {p, z}));
  const auto toPlane = rigidInverse(planeToFile);
  return put(labels, boxAround(corners, glm::dvec3(0.0), labels.grid), brush, [&](const glm::dvec3& at_mm) {
    const glm::dvec3 p = carried(toPlane, at_mm);
    return std::abs(p.z) <= halfThickness_mm && isInside(contour, glm::dvec2(p));
  });
}

}  // namespace ew::labelling
