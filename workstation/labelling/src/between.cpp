#include "ew/labelling/between.h"

#include <numeric>

#include "contour.h"
#include "voxel_boxes.h"

namespace ew::labelling {
namespace {

glm::dvec3 middleOfContour(const ContourTrace& traced) {
  glm::dvec2 sum(0.0);
  for (const glm::dvec2& p : traced.points) sum += p;
  return carried(traced.planeToFile, {sum / static_cast<double>(traced.points.size()), 0.0});
}

/// Contours in the order in which they follow one another along the structure.
std::vector<const ContourTrace*> inOrder(std::span<const ContourTrace> contours) {
  std::vector<glm::dvec3> middles;
  for (const ContourTrace& each : contours) middles.push_back(middleOfContour(each));
  glm::dvec3 along(0.0);
  for (const glm::dvec3& a : middles)
    for (const glm::dvec3& b : middles)
      if (glm::dot(b - a, b - a) > glm::dot(along, along)) along = b - a;
  std::vector<std::size_t> order(contours.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return glm::dot(middles[a], along) < glm::dot(middles[b], along); });
  std::vector<const ContourTrace*> sorted;
  for (const std::size_t n : order) sorted.push_back(&contours[n]);
  return sorted;
}

/// Two neighbours, the planes' normals turned so that each sees the other before it.
struct Slab {
  const ContourTrace* contours[2];
  Transform<frame::Probe, frame::File> toPlane[2];
  double ahead[2];  ///< sign of z towards the other

  Slab(const ContourTrace& a, const ContourTrace& b)
      : contours{&a, &b}, toPlane{rigidInverse(a.planeToFile), rigidInverse(b.planeToFile)}, ahead{} {
    for (int side = 0; side < 2; ++side) ahead[side] = carried(toPlane[side], middleOfContour(*contours[1 - side])).z < 0.0 ? -1.0 : 1.0;
  }

  /// Whether no contour reaches behind the other's plane.
  [[nodiscard]] bool isApart() const {
    for (int side = 0; side < 2; ++side)
      for (const glm::dvec2& p : contours[1 - side]->points)
        if (ahead[side] * carried(toPlane[side], carried(contours[1 - side]->planeToFile, {p, 0.0})).z < 1e-6) return false;
    return true;
  }

  [[nodiscard]] bool holds(const glm::dvec3& at_mm) const {
    double z[2], d[2];
    glm::dvec3 p[2];
    for (int side = 0; side < 2; ++side) {
      p[side] = carried(toPlane[side], at_mm);
      z[side] = ahead[side] * p[side].z;
      if (z[side] < -1e-9) return false;
    }
    for (int side = 0; side < 2; ++side) d[side] = signedDistance_mm(contours[side]->points, glm::dvec2(p[side]));
    return z[1] * d[0] + z[0] * d[1] <= 0.0;
  }
};

}  // namespace

Result<VoxelBox> fillBetween(Volume& labels, std::span<const ContourTrace> contours, const Brush& brush, Progress& progress) {
  const bool isEnough =
      contours.size() >= 2 && std::all_of(contours.begin(), contours.end(), [](const auto& each) { return each.points.size() >= 3; });
  if (!isEnough)
    return failure(ErrorCode::badUsage,
                   say<"A shape between outlines needs two of them at least; trace another one in another image plane.">());
  const auto sorted = inOrder(contours);
  std::vector<Slab> slabs;
  for (std::size_t n = 0; n + 1 < sorted.size(); ++n) {
    slabs.emplace_back(*sorted[n], *sorted[n + 1]);
    if (!slabs.back().isApart())
      return failure(
          ErrorCode::badUsage,
          say<"Two of the traced planes cross within the outlines, so there is no shape between them; trace planes that lie side by "
              "side.">());
  }
  Volume made = labels;  // nothing is changed by what is cancelled
  const auto toVoxel = labels.grid.toVoxel<frame::File>();
  VoxelBox changed;
  for (std::size_t n = 0; n < slabs.size(); ++n) {
    std::vector<glm::dvec3> corners;
    for (const ContourTrace* each : slabs[n].contours)
      for (const glm::dvec2& p : each->points) corners.push_back(carried(toVoxel, carried(each->planeToFile, {p, 0.0})));
    const VoxelBox box = boxAround(corners, glm::dvec3(1.0), labels.grid);
    for (int k = box.first.z; k < box.end.z; ++k) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Cancelled.">());
      progress.report(
          say<"Filling between outlines">(),
          (static_cast<double>(n) + static_cast<double>(k - box.first.z) / (box.end.z - box.first.z)) / static_cast<double>(slabs.size()));
      const VoxelBox layer{{box.first.x, box.first.y, k}, {box.end.x, box.end.y, k + 1}};
      changed = joined(changed, put(made, layer, brush, [&](const glm::dvec3& at_mm) { return slabs[n].holds(at_mm); }));
    }
  }
  labels.echo = std::move(made.echo);
  return changed;
}

}  // namespace ew::labelling
