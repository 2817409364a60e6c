#include "echoes/reflecting_surfaces.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <utility>

#include "echoes/echo_levels.h"
#include "ew/core/contract.h"
#include "ew/core/parallel.h"

namespace ew::phantom {
namespace {

constexpr double kSurfaceReserve = 1.5;   // as in voxelise: how far a first-order distance may exceed the true one
constexpr double kSameSurface_mm = 0.05;  // surfaces nearer than this are one
constexpr double kSlopeStep_mm = 0.05;
constexpr double kSlopesReach_mm = 1.0;               // beyond what is looked for, where slopes are still exact
constexpr double kBeside_mm = 2.0 * kSameSurface_mm;  // of a foot: farther than this is another place
constexpr double kExact_mm = 0.15;
constexpr double kFaintestLevel = 60.0;  // of a boundary without border that is worth a surface
constexpr double kThickestWall_mm = 0.9;
constexpr double kThickestFront_mm = 0.8;
constexpr double kBoundary_mm = 0.8;
constexpr double kWallFall_deg = 12.0;  // of vessels: 12 dB at 20 degrees; the others: 20 dB
// Of bone, stone and gas, whose faces are rough at the scale of a wavelength: a rib that crosses the slice obliquely has its bright cap.
constexpr double kRoughFall_deg = 12.0;
constexpr double kRoughWall_db = -9.0;  // of capsules and walls
// Of fasciae and septa, which are felts of fibres.
constexpr double kSheetFall_deg = 15.0;
constexpr double kRoughSheet_db = -6.0;
constexpr double kRoughFront_db = -13.0;
constexpr double kRoughFrontFall_deg = 60.0;
constexpr std::uint16_t kBorderKey = 255;

// A voxel lies above a surface, and not beside its rim, when what leads to its foot leans from the normal by no more than the feet are
// apart, and more where the surface curves between them.
constexpr double kBesideInVoxels = 0.9;
constexpr double kBesidePerMm = 0.35;

// A sheet of less than about one and a half voxels is drawn once, along its middle.
constexpr double kThinnestSolid = 1.7;

constexpr int kSlices = 48;  // spread at once
constexpr int kMostKinds = 255;
constexpr std::size_t kMostOrgans = 256;  // of a patient: labels are bytes

}  // namespace

SurfaceFinder::SurfaceFinder(const Patient& patient, double reach_mm) : patient_(patient), reach_mm_(reach_mm) {}

double SurfaceFinder::asked_mm(double reach_mm) { return kSurfaceReserve * (reach_mm + 3.0 * kSameSurface_mm) + 2.0 * kSameSurface_mm; }

double SurfaceFinder::Near::reach_mm(double more_mm) const { return kSurfaceReserve * (away_mm + more_mm) + kSameSurface_mm; }

std::optional<SurfaceFoot> SurfaceFinder::nearest(const glm::dvec3& p_mm, double skin_mm, const std::vector<const Organ*>& near,
                                                  const std::vector<double>& distances_mm) const {
  // Those that seem near first: what lies farther than the nearest one found is not asked for its slope.
  std::array<std::size_t, kMostOrgans> order;
  std::size_t count = 0;
  for (std::size_t n = 0; n < distances_mm.size(); ++n) {
    if (std::abs(distances_mm[n]) > kSurfaceReserve * reach_mm_) continue;
    EW_EXPECTS(count < order.size());
    std::size_t at = count++;
    for (; at > 0 && std::abs(distances_mm[order[at - 1]]) > std::abs(distances_mm[n]); --at) order[at] = order[at - 1];
    order[at] = n;
  }
  const double far_mm = kSurfaceReserve * reach_mm_ + kSlopesReach_mm;
  std::optional<SurfaceFoot> found;
  for (std::size_t at = 0; at < count; ++at) {
    const std::size_t n = order[at];
    const double nearest_mm = found ? std::abs(static_cast<double>(found->distance_mm)) : reach_mm_;
    if (std::abs(distances_mm[n]) > kSurfaceReserve * nearest_mm) break;
    const Organ& organ = *near[n];
    // Both faces of a sheet that is thinner than the voxels face away from each other, and between them no distance would change its sign.
    const double thickness_mm = organ.shape->sheetThickness_mm();
    const bool isSheet = thickness_mm > 0.0 && thickness_mm < kThinnestSolid * reach_mm_;
    const auto distanceAt = [&](const glm::dvec3& at_mm) {
      return isSheet ? organ.shape->middle_mm(at_mm) : organ.shape->distanceUpTo_mm(at_mm, far_mm);
    };
    const double d = isSheet ? distanceAt(p_mm) : distances_mm[n];
    if (std::abs(d) > kSurfaceReserve * nearest_mm) continue;
    glm::dvec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = kSlopeStep_mm;
      slope[axis] = (distanceAt(p_mm + step) - d) / kSlopeStep_mm;
    }
    const double steep = glm::length(slope);
    if (!(steep > 0.0) || std::abs(d) > reach_mm_ * steep) continue;
    const glm::dvec3 normal = slope / steep;
    // A second step of Newton's: first-order distances of curved shapes are off by the square of the first, over their radius.
    double exact = d / steep;
    if (std::abs(exact) > kExact_mm) exact += distanceAt(p_mm - exact * normal) / steep;
    if (found && std::abs(exact) >= nearest_mm) continue;
    const glm::dvec3 foot = p_mm - exact * normal;
    if (isSheet && organ.shape->distanceUpTo_mm(foot, kBeside_mm) > kSameSurface_mm) continue;  // a gap
    const Near around{near, distances_mm, skin_mm, std::abs(exact)};
    if (isHidden(foot, n, around)) continue;
    const auto key = keyAt(foot, normal, organ, around);
    if (!key) continue;
    found = SurfaceFoot{.voxel = {}, .distance_mm = static_cast<float>(exact), .normal = glm::vec3(normal), .key = *key};
  }
  return found;
}

bool SurfaceFinder::isHidden(const glm::dvec3& foot_mm, std::size_t n, const Near& near) const {
  const double step = near.reach_mm(0.0);
  for (std::size_t m = 0; m < n; ++m) {
    if (near.distances_mm[m] > step) continue;
    if (near.distances_mm[m] < -step) return true;
    const double d = near.organs[m]->shape->distanceUpTo_mm(foot_mm, kBeside_mm);
    if (d < -kSameSurface_mm) return true;
    if (d <= kSameSurface_mm && (near.organs[m]->border || !near.organs[n]->border)) return true;
  }
  return near.skin_mm > -step && patient_.skin->distance_mm(foot_mm) > kSameSurface_mm;
}

std::optional<std::uint16_t> SurfaceFinder::keyAt(const glm::dvec3& foot_mm, const glm::dvec3& normal, const Organ& organ,
                                                  const Near& near) const {
  const auto key = static_cast<std::uint16_t>((&organ - patient_.organs.data()) << 8);
  if (organ.border) return static_cast<std::uint16_t>(key | kBorderKey);
  // Two organs that share a surface draw it once: with the border, whichever of them has it. Else its sides would change from voxel to
  // voxel.
  for (std::size_t m = 0; m < near.organs.size(); ++m) {
    const Organ& other = *near.organs[m];
    if (&other == &organ || !other.border) continue;
    if (m < near.distances_mm.size() && std::abs(near.distances_mm[m]) > near.reach_mm(kSameSurface_mm)) continue;
    if (std::abs(other.shape->distanceUpTo_mm(foot_mm, kBeside_mm)) <= kSameSurface_mm) return std::nullopt;
  }
  const double behind_mm = 2.0 * kSameSurface_mm;
  const auto outside = tissueAt(foot_mm + behind_mm * normal, behind_mm, near);
  if (!outside) return std::nullopt;
  const double mirrored = mirroredBetween(patient_.tissues[organ.tissue].impedance_mrayl, patient_.tissues[*outside].impedance_mrayl);
  if (!(mirrored > 0.0) || levelOf(mirrored) < kFaintestLevel) return std::nullopt;
  return static_cast<std::uint16_t>(key | *outside);
}

std::optional<std::size_t> SurfaceFinder::tissueAt(const glm::dvec3& p_mm, double behind_mm, const Near& near) const {
  const double step = near.reach_mm(behind_mm);
  if (near.skin_mm > -step && patient_.skin->distance_mm(p_mm) >= 0.0) return std::nullopt;
  for (std::size_t m = 0; m < near.organs.size(); ++m) {
    const bool isKnown = m < near.distances_mm.size();
    if (isKnown && near.distances_mm[m] > step) continue;
    if ((isKnown && near.distances_mm[m] < -step) || near.organs[m]->shape->distanceUpTo_mm(p_mm, kBeside_mm) < 0.0)
      return near.organs[m]->tissue;
  }
  return patient_.backgroundTissue;
}

ReflectingSurface SurfaceFinder::surfaceOf(std::uint16_t key) const {
  const Organ& organ = patient_.organs[key >> 8];
  ReflectingSurface surface;
  surface.name = organ.name;
  surface.rough_db = kRoughWall_db;
  surface.frontOnly = organ.border && organ.border->shine == Shine::front;
  if (organ.shape->centreLine() && !surface.frontOnly) surface.fall_deg = kWallFall_deg;
  if (organ.shape->sheetThickness_mm() > 0.0) {
    surface.fall_deg = kSheetFall_deg;
    surface.rough_db = kRoughSheet_db;
  }
  if (surface.frontOnly) {
    surface.fall_deg = kRoughFall_deg;
    surface.rough_db = kRoughFront_db;
    surface.roughFall_deg = kRoughFrontFall_deg;
  }
  if (organ.border) {
    surface.echoLevel = organ.border->echoLevel;
    surface.sheets = organ.border->sheets;
    surface.sheetGap_mm = organ.border->sheetGap_mm;
    surface.fall_deg = organ.border->fall_deg.value_or(surface.fall_deg);
    surface.rough_db = organ.border->rough_db.value_or(surface.rough_db);
    surface.thickness_mm = std::min(organ.border->width_mm, surface.frontOnly ? kThickestFront_mm : kThickestWall_mm);
  } else {
    const Tissue& outside = patient_.tissues[key & 255u];
    surface.echoLevel = levelOf(mirroredBetween(patient_.tissues[organ.tissue].impedance_mrayl, outside.impedance_mrayl));
    surface.thickness_mm = kBoundary_mm;
  }
  return surface;
}

namespace {

/// Numbers of surfaces by key, 0: none. There is room for 255; the faintest go when there are more.
std::vector<std::uint8_t> numberSurfaces(const SurfaceFinder& finder, const std::vector<std::vector<SurfaceFoot>>& feet, TissueMaps& maps) {
  std::bitset<65536> used;
  for (const auto& part : feet)
    for (const SurfaceFoot& foot : part) used.set(foot.key);
  struct Kind {
    std::uint16_t key;
    ReflectingSurface surface;
  };
  std::vector<Kind> kinds;
  for (std::size_t key = 0; key < used.size(); ++key)
    if (used.test(key)) kinds.push_back({static_cast<std::uint16_t>(key), finder.surfaceOf(static_cast<std::uint16_t>(key))});
  if (kinds.size() > kMostKinds) {
    std::stable_sort(kinds.begin(), kinds.end(), [](const Kind& a, const Kind& b) { return a.surface.echoLevel > b.surface.echoLevel; });
    kinds.resize(kMostKinds);
    std::sort(kinds.begin(), kinds.end(), [](const Kind& a, const Kind& b) { return a.key < b.key; });
  }
  std::vector<std::uint8_t> numbers(used.size(), 0);
  maps.surfaces.clear();
  for (Kind& kind : kinds) {
    maps.surfaces.push_back(std::move(kind.surface));
    numbers[kind.key] = static_cast<std::uint8_t>(maps.surfaces.size());
  }
  return numbers;
}

/// Spreads feet through some slices of a volume and as many around them as surfaces reach. Every voxel asks its neighbours for a nearer
/// foot, once from the first voxel to the last and once back (vector distance transform: Danielsson, Computer Graphics and Image Processing
/// 14, 1980; with all 26 neighbours).
class Spreading {
 public:
  Spreading(TissueMaps& maps, const std::vector<std::uint8_t>& numbers) : maps_(maps), numbers_(numbers), grid_(maps.grid) {
    spacing_ = grid_.spacing_mm.x;
    halo_ = static_cast<int>(std::ceil(TissueMaps::kSurfaceReach_mm / spacing_));
    farthest_ = static_cast<float>(TissueMaps::kSurfaceReach_mm + 2.0 * spacing_);
    farthest_ *= farthest_;
    // Step by step, so that a voxel lies at the same place to the last bit wherever its row is entered.
    const auto step = static_cast<float>(spacing_);
    fromFirst_mm_.resize(static_cast<std::size_t>(grid_.dims.x));
    fromLast_mm_ = fromFirst_mm_;
    float there = 0.0F;
    for (float& each : fromFirst_mm_) each = std::exchange(there, there + step);
    there = step * static_cast<float>(grid_.dims.x - 1);
    for (std::size_t n = fromLast_mm_.size(); n-- > 0;) fromLast_mm_[n] = std::exchange(there, there - step);
  }
  [[nodiscard]] int halo() const { return halo_; }

  /// @param feet of the slices from firstSlice - halo() to lastSlice + halo()
  template <class Stopped>
  void fill(int firstSlice, int lastSlice, const std::vector<const SurfaceFoot*>& feet, const Stopped& stopped) {
    begin_ = std::max(0, firstSlice - halo_);
    end_ = std::min(grid_.dims.z, lastSlice + halo_);
    known_.assign(1, {});
    if (!layRoom(feet)) return;
    for (const SurfaceFoot* foot : feet) {
      const std::uint8_t number = numbers_[foot->key];
      if (number == 0) continue;
      const glm::vec3 at = static_cast<float>(spacing_) * glm::vec3(foot->voxel - glm::ivec3(0, 0, begin_));
      nearest_[indexOf(foot->voxel.x, foot->voxel.y, foot->voxel.z - begin_)] = static_cast<std::uint32_t>(known_.size());
      rowHasFeet(foot->voxel.y, foot->voxel.z - begin_) = 1;
      known_.push_back({at - foot->distance_mm * foot->normal, foot->normal, number});
    }
    for (int k = 0; k < end_ - begin_; ++k)
      for (int j = low_.y; j < high_.y && !stopped(); ++j) spreadRow(j, k, +1);
    for (int k = end_ - begin_ - 1; k >= 0; --k)
      for (int j = high_.y - 1; j >= low_.y && !stopped(); --j) spreadRow(j, k, -1);
    for (int k = firstSlice; k < lastSlice; ++k)
      for (int j = low_.y; j < high_.y && !stopped(); ++j) keepRow(j, k);
  }

 private:
  struct Known {
    glm::vec3 place;  ///< mm from the first voxel of slice begin_
    glm::vec3 normal;
    std::uint8_t number = 0;
  };

  /// Only as far as feet are spread: a few of them leave most of a slice alone. @return false: there are none
  [[nodiscard]] bool layRoom(const std::vector<const SurfaceFoot*>& feet) {
    low_ = glm::ivec2(grid_.dims);
    high_ = glm::ivec2(0);
    for (const SurfaceFoot* foot : feet) {
      if (numbers_[foot->key] == 0) continue;
      low_ = glm::min(low_, glm::ivec2(foot->voxel));
      high_ = glm::max(high_, glm::ivec2(foot->voxel) + 1);
    }
    if (glm::any(glm::greaterThanEqual(low_, high_))) return false;
    const int reach = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(farthest_)) / spacing_)) + 1;
    low_ = glm::max(low_ - reach, glm::ivec2(0));
    high_ = glm::min(high_ + reach, glm::ivec2(grid_.dims));
    row_ = static_cast<std::size_t>(high_.x - low_.x) + 2;
    slice_ = row_ * (static_cast<std::size_t>(high_.y - low_.y) + 2);
    const auto slices = static_cast<std::size_t>(end_ - begin_ + 2);
    nearest_.assign(slice_ * slices, 0);
    hasFeet_.assign(slices * static_cast<std::size_t>(high_.y - low_.y + 2), 0);
    return true;
  }

  /// With a margin of one voxel without feet all round.
  [[nodiscard]] std::size_t indexOf(int i, int j, int k) const {
    return static_cast<std::size_t>(k + 1) * slice_ + static_cast<std::size_t>(j - low_.y + 1) * row_ +
           static_cast<std::size_t>(i - low_.x + 1);
  }
  [[nodiscard]] std::uint8_t& rowHasFeet(int j, int k) {
    return hasFeet_[static_cast<std::size_t>((k + 1) * (high_.y - low_.y + 2) + j - low_.y + 1)];
  }

  /// @param way +1: asks those that come before, from the first; -1: those that come after, from the last
  void spreadRow(int j, int k, int way) {
    std::array<std::ptrdiff_t, 13> asked{};
    std::size_t count = 0;
    bool any = rowHasFeet(j, k) != 0;
    for (const auto& [dj, dk] : {std::pair{-1, 0}, std::pair{-1, -1}, std::pair{0, -1}, std::pair{1, -1}}) {
      if (rowHasFeet(j + way * dj, k + way * dk) == 0) continue;
      any = true;
      const auto row = way * (static_cast<std::ptrdiff_t>(dk) * static_cast<std::ptrdiff_t>(slice_) +
                              static_cast<std::ptrdiff_t>(dj) * static_cast<std::ptrdiff_t>(row_));
      for (const std::ptrdiff_t di : {-1, 0, 1}) asked[count++] = row + di;
    }
    if (!any) return;
    asked[count++] = -way;
    const int first = way > 0 ? low_.x : high_.x - 1;
    std::uint32_t* cell = nearest_.data() + indexOf(first, j, k);
    const std::vector<float>& across_mm = way > 0 ? fromFirst_mm_ : fromLast_mm_;
    glm::vec3 p = static_cast<float>(spacing_) * glm::vec3(0, j, k);
    bool found = false;
    for (int i = first; i >= low_.x && i < high_.x; i += way, cell += way) {
      p.x = across_mm[static_cast<std::size_t>(i)];
      std::uint32_t best = *cell;
      float least = best != 0 ? squared(p - known_[best].place) : farthest_;
      for (std::size_t m = 0; m < count; ++m) {
        const std::uint32_t other = cell[asked[m]];
        if (other == 0 || other == best) continue;
        const float distance = squared(p - known_[other].place);
        // Of two as near, the earlier in the volume: the same whichever way they came.
        if (distance < least || (distance == least && best != 0 && other < best)) {
          least = distance;
          best = other;
        }
      }
      *cell = best;
      found = found || best != 0;
    }
    if (found) rowHasFeet(j, k) = 1;
  }

  void keepRow(int j, int k) {
    if (rowHasFeet(j, k - begin_) == 0) return;
    const std::uint32_t* cell = nearest_.data() + indexOf(low_.x, j, k - begin_);
    for (int i = low_.x; i < high_.x; ++i, ++cell) {
      if (*cell == 0) continue;
      const Known& foot = known_[*cell];
      const glm::vec3 to = static_cast<float>(spacing_) * glm::vec3(i, j, k - begin_) - foot.place;
      const float distance = glm::dot(to, foot.normal);
      if (std::abs(distance) > static_cast<float>(TissueMaps::kSurfaceReach_mm)) continue;
      const float beside = std::sqrt(std::max(0.0F, squared(to) - distance * distance));
      if (beside > static_cast<float>(kBesideInVoxels * spacing_) + static_cast<float>(kBesidePerMm) * std::abs(distance)) continue;
      const std::size_t at = grid_.indexOf(i, j, k);
      const double step = 128.0 + TissueMaps::kDistanceStepsPerMm * static_cast<double>(distance);
      maps_.surfaceDistance[at] = static_cast<std::uint8_t>(std::clamp(step + 0.5, 1.0, 255.0));
      maps_.surfaceKind[at] = foot.number;
    }
  }

  static float squared(const glm::vec3& v) { return glm::dot(v, v); }

  TissueMaps& maps_;
  const std::vector<std::uint8_t>& numbers_;
  const Grid& grid_;
  double spacing_ = 1.0;
  int halo_ = 0;
  std::vector<float> fromFirst_mm_, fromLast_mm_;  ///< of voxels along a row, as they are met from either end
  glm::ivec2 low_{0}, high_{0};                    ///< voxels of a slice that feet may reach
  std::size_t row_ = 0, slice_ = 0;
  float farthest_ = 0.0F;
  int begin_ = 0, end_ = 0;             ///< slices at hand
  std::vector<std::uint32_t> nearest_;  ///< numbers in known_, 0: none
  std::vector<Known> known_;
  std::vector<std::uint8_t> hasFeet_;  ///< rows
};

}  // namespace

double spreadForecast_bytes(const Grid& grid, int threads) {
  const double slice = static_cast<double>(grid.dims.x + 2) * (grid.dims.y + 2);
  const double slices = kSlices + 2.0 * std::ceil(TissueMaps::kSurfaceReach_mm / grid.spacing_mm.x) + 2.0;
  return slice * std::min(slices, grid.dims.z + 2.0) * 12.0 * threadCount(threads);
}

bool spreadSurfaces(const SurfaceFinder& finder, const std::vector<std::vector<SurfaceFoot>>& feet, int threads, Progress& progress,
                    TissueMaps& maps) {
  const std::vector<std::uint8_t> numbers = numberSurfaces(finder, feet, maps);
  const int slabs = (maps.grid.dims.z + kSlices - 1) / kSlices;
  const int halo = Spreading(maps, numbers).halo();
  return forEachTask(slabs, threads, progress, say<"Finding the surfaces">(), [&](int slab, int /*worker*/, const auto& stopped) {
    const int first = slab * kSlices, last = std::min(first + kSlices, maps.grid.dims.z);
    std::vector<const SurfaceFoot*> here;
    for (const auto& part : feet) {
      if (stopped()) return;
      for (const SurfaceFoot& foot : part)
        if (foot.voxel.z >= first - halo && foot.voxel.z < last + halo) here.push_back(&foot);
    }
    Spreading(maps, numbers).fill(first, last, here, stopped);
  });
}

}  // namespace ew::phantom
