#include "ew/assessment/scannable_region.h"

#include "ew/assessment/random_numbers.h"

namespace ew {
namespace {

using assessment::RandomNumbers;

constexpr int kMostTries = 20000;
constexpr double kShell_mm = 12.0;  // a try is kept this near the skin, so that curved skin is met about as often as flat one
constexpr double kRim_mm = 2.0;     // the skin may lie this far outside of the data

bool isInside(const Grid& grid, const glm::dvec3& p_mm, double margin_mm) {
  const glm::dvec3 voxel = carried(grid.worldToVoxel(), p_mm);
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = margin_mm / grid.spacing_mm[axis];
    if (voxel[axis] < -0.5 - margin || voxel[axis] > grid.dims[axis] - 0.5 + margin) return false;
  }
  return true;
}

void holdFreely(Hold& hold, RandomNumbers& random, const RandomHold& freely) {
  const double rotation_rad = random.between(-freely.rotation_rad, freely.rotation_rad);
  const double rock_rad = random.between(-freely.tip_rad, freely.tip_rad);
  const double tilt_rad = random.between(-freely.tip_rad, freely.tip_rad);
  hold = turned(hold, rotation_rad, rock_rad, tilt_rad);
}

}  // namespace

bool isScannable(const ScannableRegion& region, const Skin::Contact& contact) {
  return isInside(region.placedGrid, contact.point_mm, kRim_mm) &&
         isInside(region.placedGrid, contact.point_mm - region.below_mm * contact.outward, 0.0);
}

std::optional<Hold> randomHold(const ScannableRegion& region, const Skin& skin, std::uint64_t seed, const RandomHold& freely) {
  RandomNumbers random(seed);
  const Grid& grid = region.placedGrid;
  const auto voxelToWorld = grid.voxelToWorld();
  for (int n = 0; n < kMostTries; ++n) {
    glm::dvec3 voxel;
    for (int axis = 0; axis < 3; ++axis) voxel[axis] = random.between(-0.5, grid.dims[axis] - 0.5);
    const glm::dvec3 tried_mm = carried(voxelToWorld, voxel);
    const Skin::Contact contact = skin.nearest(tried_mm);
    if (glm::distance(contact.point_mm, tried_mm) > kShell_mm || !isScannable(region, contact)) continue;
    Hold hold;
    hold.contact = contact;
    hold.press_mm = freely.press_mm;
    holdFreely(hold, random, freely);
    return hold;
  }
  return std::nullopt;
}

std::optional<Hold> randomHoldNear(const ScannableRegion& region, const Skin& skin, const Hold& around, double reach_mm, std::uint64_t seed,
                                   const RandomHold& freely) {
  RandomNumbers random(seed);
  for (int n = 0; n < kMostTries / 10; ++n) {
    const glm::dvec2 way_mm = random.inDisc(reach_mm);
    Hold hold = slid(around, skin, way_mm.x, way_mm.y);
    if (!isScannable(region, hold.contact)) continue;
    hold.press_mm = freely.press_mm;
    holdFreely(hold, random, freely);
    return hold;
  }
  return std::nullopt;
}

}  // namespace ew
