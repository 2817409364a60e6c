#include "echoes/tissue_painter.h"

#include <cmath>

namespace ew::phantom {
namespace {

// As in sampleDistance: how far a first-order distance may exceed the true one before a block is wrongly left out.
constexpr double kReserve = 1.5;
constexpr double kWithinVoxel = 0.9;  // half a voxel's diagonal is 0.87

}  // namespace

Grid voxelGridOver(const Bounds& box, double spacing_mm) {
  Grid grid;
  grid.spacing_mm = glm::dvec3(spacing_mm);
  grid.origin_mm = box.lowest_mm;
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = std::floor((box.highest_mm[axis] - box.lowest_mm[axis]) / spacing_mm + 1e-9);
    grid.dims[axis] = static_cast<int>(std::min(steps, 1e6)) + 1;
  }
  return grid;
}

double blockRadius_mm(int voxels, double spacing_mm) { return 0.5 * std::sqrt(3.0) * (voxels - 1) * spacing_mm; }

glm::dvec3 blockCentre_mm(const Grid& grid, const glm::ivec3& first, int voxels) {
  return grid.origin_mm + grid.spacing_mm.x * (glm::dvec3(first) + 0.5 * (voxels - 1));
}

OrganFinder::OrganFinder(const Patient& patient, double spacing_mm)
    : patient_(patient), spacing_mm_(spacing_mm), asked_mm_(SurfaceFinder::asked_mm(kWithinVoxel * spacing_mm)) {
  for (const Organ& organ : patient.organs) all_.push_back(&organ);
}

bool OrganFinder::isOutside(const glm::dvec3& centre_mm, int voxels, bool asksForPart) const {
  return patient_.skin->distance_mm(centre_mm) > kReserve * (blockRadius_mm(voxels, spacing_mm_) + (asksForPart ? 0.5 * spacing_mm_ : 0.0));
}

void OrganFinder::select(const glm::dvec3& centre_mm, int voxels, std::vector<const Organ*>& near) const {
  near.clear();
  const double radius_mm = blockRadius_mm(voxels, spacing_mm_);
  for (const Organ* organ : all_) {
    // As far as anything is asked of an organ at a voxel. Feet of surfaces beside voxels ask a little farther, which blocks of a whole
    // leave out: at its corner a foot may miss an organ that only touches its neighbourhood.
    const double margin = std::max({organ->border ? organ->border->width_mm : 0.0, spacing_mm_, voxels < kPaintedBlock ? asked_mm_ : 0.0});
    if (organ->shape->atLeast_mm(centre_mm) > radius_mm + margin) continue;
    const double far_mm = kReserve * (radius_mm + margin), d = organ->shape->distanceUpTo_mm(centre_mm, far_mm);
    if (d >= far_mm) continue;
    near.push_back(organ);
    if (d < -far_mm) break;  // whatever comes later is hidden by this one
  }
}

int OrganFinder::distancesAt(const glm::dvec3& p_mm, const std::vector<const Organ*>& near, std::vector<double>& distances_mm) const {
  distances_mm.clear();
  int label = 0;
  double remaining = 1.0;
  for (const Organ* organ : near) {
    const double d = organ->shape->distanceUpTo_mm(p_mm, organ->border ? std::max(asked_mm_, organ->border->width_mm) : asked_mm_);
    distances_mm.push_back(d);
    if (d < 0.0 && label == 0) label = static_cast<int>(organ - patient_.organs.data()) + 1;
    remaining *= 1.0 - partInside(d, spacing_mm_);
    if (remaining < kNothingLeft) break;
  }
  return label;
}

TissuePainter::TissuePainter(const Patient& patient, double spacing_mm)
    : patient_(patient), spacing_mm_(spacing_mm), surfaces_(patient, kWithinVoxel * spacing_mm) {}

std::uint8_t TissuePainter::levelAt(const glm::dvec3& p_mm, double skin_mm, const std::vector<const Organ*>& near,
                                    const std::vector<double>& distances_mm) const {
  double remaining = bodyPart(skin_mm), power = 0.0;
  if (const std::optional<std::size_t> only = onlyTissue(remaining, near, distances_mm)) {
    const Tissue& tissue = patient_.tissues[*only];
    if (!(tissue.speckle > 0.0)) return 0;
    return static_cast<std::uint8_t>(std::clamp(tissueLevelAt(tissue, *only, p_mm, skin_mm) + 0.5, 0.0, 255.0));
  }
  const auto add = [&](std::size_t number, double weight) {
    const Tissue& tissue = patient_.tissues[number];
    if (tissue.speckle > 0.0) power += weight * power_.of(tissueLevelAt(tissue, number, p_mm, skin_mm));
  };
  for (std::size_t n = 0; n < distances_mm.size() && remaining >= kNothingLeft; ++n) {
    const double part = partInside(distances_mm[n], spacing_mm_);
    if (part <= 0.0) continue;
    add(near[n]->tissue, remaining * part);
    remaining *= 1.0 - part;
  }
  if (remaining >= kNothingLeft) add(patient_.backgroundTissue, remaining);
  return static_cast<std::uint8_t>(power_.level(power));
}

std::optional<std::size_t> TissuePainter::onlyTissue(double bodyPart, const std::vector<const Organ*>& near,
                                                     const std::vector<double>& distances_mm) const {
  if (bodyPart < 1.0) return std::nullopt;
  for (std::size_t n = 0; n < distances_mm.size(); ++n) {
    if (distances_mm[n] >= 0.5 * spacing_mm_) continue;
    return distances_mm[n] <= -0.5 * spacing_mm_ ? std::optional(near[n]->tissue) : std::nullopt;
  }
  return patient_.backgroundTissue;
}

}  // namespace ew::phantom
