#include "chain/group_warp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/core/order_statistics.h"
#include "ew/core/parallel.h"

namespace ew::stitching {
namespace {

constexpr double kRidge = 0.002;    ///< share of a pair's motion that is given up inside its overlap, so that nodes have one answer
constexpr int kRounds = 6;          ///< of looking up a pair's motion where the fixed view's own warp has moved it
constexpr double kStill_mm = 1e-3;  ///< a lattice that moves no more is none
constexpr std::uint64_t kMostNodes = 4u << 20;

Grid latticeOver(std::span<const Grid> placedGrids, double margin_mm, double node_mm) {
  Bounds box{glm::dvec3(std::numeric_limits<double>::max()), glm::dvec3(std::numeric_limits<double>::lowest())};
  for (const Grid& grid : placedGrids) {
    const Bounds each = boundsOf(grid);
    box.lowest_mm = glm::min(box.lowest_mm, each.lowest_mm);
    box.highest_mm = glm::max(box.highest_mm, each.highest_mm);
  }
  Grid lattice;
  for (;;) {
    lattice.spacing_mm = glm::dvec3(node_mm);
    // On whole multiples of the spacing, so that a volume more at one side does not move the nodes.
    const glm::dvec3 first = glm::floor((box.lowest_mm - margin_mm) / node_mm);
    lattice.origin_mm = first * node_mm;
    lattice.dims = glm::ivec3(glm::ceil((box.highest_mm + margin_mm) / node_mm) - first) + 1;
    if (lattice.voxelCount() <= kMostNodes) return lattice;
    node_mm *= 1.25;
  }
}

/// Squared distance to the nearest node where `inside`, exact, one axis after the other.
std::vector<float> distanceTo_mm(const Grid& lattice, const std::vector<bool>& inside) {
  constexpr float kFar = 1e12F;
  std::vector<float> squared(inside.size());
  for (std::size_t n = 0; n < inside.size(); ++n) squared[n] = inside[n] ? 0.0F : kFar;
  const auto h2 = static_cast<float>(lattice.spacing_mm.x * lattice.spacing_mm.x);
  std::vector<float> line, best;
  const glm::ivec3 dims = lattice.dims;
  for (int axis = 0; axis < 3; ++axis) {
    const int other = (axis + 1) % 3, third = (axis + 2) % 3;
    const auto length = static_cast<std::size_t>(dims[axis]);
    line.resize(length);
    best.resize(length);
    glm::ivec3 at(0);
    for (at[third] = 0; at[third] < dims[third]; ++at[third])
      for (at[other] = 0; at[other] < dims[other]; ++at[other]) {
        bool any = false;
        for (at[axis] = 0; at[axis] < dims[axis]; ++at[axis]) {
          line[static_cast<std::size_t>(at[axis])] = squared[lattice.indexOf(at.x, at.y, at.z)];
          any = any || line[static_cast<std::size_t>(at[axis])] < kFar;
        }
        if (!any) continue;
        for (std::size_t to = 0; to < length; ++to) {
          best[to] = kFar;
          for (std::size_t from = 0; from < length; ++from) {
            const float apart = static_cast<float>(to) - static_cast<float>(from);
            best[to] = std::min(best[to], line[from] + h2 * apart * apart);
          }
        }
        for (at[axis] = 0; at[axis] < dims[axis]; ++at[axis])
          squared[lattice.indexOf(at.x, at.y, at.z)] = best[static_cast<std::size_t>(at[axis])];
      }
  }
  for (float& each : squared) each = std::sqrt(each);
  return squared;
}

/// 1 inside the overlap, falling smoothly to 0 at `fallOff_mm`.
double shareAt(double distance_mm, double fallOff_mm) {
  const double t = std::clamp(distance_mm / fallOff_mm, 0.0, 1.0);
  return 1.0 - t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

/// Symmetric positive definite, size x size, three right sides at once; both are overwritten.
void solve(std::vector<double>& matrix, std::vector<glm::dvec3>& right, std::size_t size) {
  for (std::size_t pivot = 0; pivot < size; ++pivot) {
    const double inverse = 1.0 / matrix[pivot * size + pivot];
    for (std::size_t row = pivot + 1; row < size; ++row) {
      const double factor = matrix[row * size + pivot] * inverse;
      if (factor == 0.0) continue;
      for (std::size_t column = pivot; column < size; ++column) matrix[row * size + column] -= factor * matrix[pivot * size + column];
      right[row] -= factor * right[pivot];
    }
  }
  for (std::size_t row = size; row-- > 0;) {
    for (std::size_t column = row + 1; column < size; ++column) right[row] -= matrix[row * size + column] * right[column];
    right[row] /= matrix[row * size + row];
  }
}

/// One pair on the lattice.
struct Meeting {
  const PairWarp* pair = nullptr;
  Transform<frame::Fixed, frame::World> worldToFixed;
  Transform<frame::World, frame::Moving> movingToWorld;
  std::vector<float> distance_mm;
  [[nodiscard]] glm::dvec3 motionAt(const glm::dvec3& p_world) const {
    return carried(movingToWorld, registration::movingPoint(pair->fixedToMoving, carried(worldToFixed, p_world))) - p_world;
  }
};

bool covers(const Volume& volume, const Transform<frame::Voxel, frame::World>& worldToVoxel, const glm::dvec3& p_world) {
  const glm::ivec3 voxel(glm::floor(carried(worldToVoxel, p_world) + 0.5));
  return volume.grid.contains(voxel) && volume.coverageAt(volume.grid.indexOf(voxel.x, voxel.y, voxel.z)) != Coverage::absent;
}

/// Takes the folds out of a lattice: smoothed where that helps, and made smaller where it does not.
void unfold(registration::ControlGrid& warp, double leastJacobian) {
  constexpr int kSmoothings = 12;
  const Grid& nodes = warp.nodes;
  for (int round = 0; registration::jacobianOf(warp).smallest < leastJacobian; ++round) {
    if (round >= kSmoothings) {
      for (auto& each : warp.displacement_mm) each *= 0.85F;
      continue;
    }
    const auto before = warp.displacement_mm;
    for (int k = 0; k < nodes.dims.z; ++k)
      for (int j = 0; j < nodes.dims.y; ++j)
        for (int i = 0; i < nodes.dims.x; ++i) {
          glm::vec3 sum(0.0F);
          for (int side = 0; side < 6; ++side) {
            glm::ivec3 at(i, j, k);
            at[side / 2] = std::clamp(at[side / 2] + (side % 2 == 0 ? -1 : 1), 0, nodes.dims[side / 2] - 1);
            sum += before[nodes.indexOf(at.x, at.y, at.z)];
          }
          const std::size_t n = nodes.indexOf(i, j, k);
          warp.displacement_mm[n] = 0.5F * before[n] + sum / 12.0F;
        }
  }
}

/// What the nodes of one slice take while they are solved, so that they allocate nothing.
struct NodeScratch {
  std::vector<double> matrix;
  std::vector<glm::dvec3> right, warp;                  ///< one per member
  std::vector<std::size_t> members, place;              ///< views that meet at the node, and where each stands among them
  std::vector<std::pair<const Meeting*, double>> here;  ///< with their weights
};

/// Views that warp together, on one lattice.
class BendingGroup {
 public:
  BendingGroup(std::span<const ViewData* const> views, std::span<const Transform<frame::World, frame::View>> toWorld,
               std::span<const PairWarp> pairs, const WarpOptions& options)
      : views_(views), toWorld_(toWorld), pairs_(pairs), options_(options) {
    std::vector<Grid> grids;
    for (std::size_t v = 0; v < views.size(); ++v) grids.push_back(placed(views[v]->volume->grid, toWorld[v]));
    lattice_ = latticeOver(grids, options.fallOff_mm, options.node_mm);
    nodeToWorld_ = lattice_.voxelToWorld();
    group.warps.assign(views.size(), {lattice_, std::vector<glm::vec3>(lattice_.voxelCount(), glm::vec3(0.0F))});
    group.largest_mm.assign(views.size(), 0.0);
  }

  /// Each returns false when it was cancelled.
  bool lookAtOverlaps(Progress& progress);
  bool shareWarps(Progress& progress);
  bool unfoldAll(Progress& progress);

  GroupWarps group;

 private:
  [[nodiscard]] Meeting meetingOf(const PairWarp& pair, const Progress& progress) const;
  [[nodiscard]] bool gather(std::size_t node, NodeScratch& at) const;
  void solveNode(const glm::dvec3& p, NodeScratch& at) const;
  void shareSlice(int k, const Progress& progress, std::vector<double>& disagreements);

  std::span<const ViewData* const> views_;
  std::span<const Transform<frame::World, frame::View>> toWorld_;
  std::span<const PairWarp> pairs_;
  const WarpOptions& options_;
  Grid lattice_;
  Transform<frame::World, frame::Voxel> nodeToWorld_;
  std::vector<Meeting> meetings_;
};

Meeting BendingGroup::meetingOf(const PairWarp& pair, const Progress& progress) const {
  const auto worldToFixed = rigidInverse(renamed<frame::World, frame::Fixed>(toWorld_[pair.fixed]));
  const auto movingToWorld = renamed<frame::World, frame::Moving>(toWorld_[pair.moving]);
  Meeting meeting{&pair, worldToFixed, movingToWorld, {}};
  const Volume &fixed = *views_[pair.fixed]->volume, &moving = *views_[pair.moving]->volume;
  const auto fixedVoxel = fixed.grid.toVoxel<frame::Fixed>() * worldToFixed;
  const auto movingVoxel = moving.grid.toVoxel<frame::Moving>() * rigidInverse(movingToWorld);
  std::vector<bool> inside(lattice_.voxelCount());
  std::size_t node = 0;
  for (int k = 0; k < lattice_.dims.z; ++k)
    for (int j = 0; j < lattice_.dims.y; ++j)
      for (int i = 0; i < lattice_.dims.x; ++i, ++node) {
        const glm::dvec3 p = carried(nodeToWorld_, glm::dvec3(i, j, k));
        inside[node] = covers(fixed, fixedVoxel, p) && covers(moving, movingVoxel, p);
      }
  if (!progress.cancelRequested()) meeting.distance_mm = distanceTo_mm(lattice_, inside);
  return meeting;
}

bool BendingGroup::lookAtOverlaps(Progress& progress) {
  meetings_.resize(pairs_.size());
  const bool looked = forEachTask(static_cast<int>(pairs_.size()), options_.threads, progress, say<"Looking at overlaps">(), [&](int task) {
    const auto n = static_cast<std::size_t>(task);
    meetings_[n] = meetingOf(pairs_[n], progress);
  });
  return looked && !progress.cancelRequested();
}

/// The pairs that speak of a node, and the views they are of. @return whether there are any
bool BendingGroup::gather(std::size_t node, NodeScratch& at) const {
  at.here.clear();
  at.members.clear();
  for (const Meeting& meeting : meetings_) {
    const double share = shareAt(static_cast<double>(meeting.distance_mm[node]), options_.fallOff_mm);
    if (share <= 0.0) continue;
    // With one pair alone each side gets half of its motion times `share`.
    at.here.emplace_back(&meeting, meeting.pair->trust * 0.5 * share / (1.0 - share + kRidge));
    at.members.push_back(meeting.pair->fixed);
    at.members.push_back(meeting.pair->moving);
  }
  std::sort(at.members.begin(), at.members.end());
  at.members.erase(std::unique(at.members.begin(), at.members.end()), at.members.end());
  for (std::size_t m = 0; m < at.members.size(); ++m) at.place[at.members[m]] = m;
  return !at.here.empty();
}

/// The displacements of least squares of the members at a node, into at.warp.
void BendingGroup::solveNode(const glm::dvec3& p, NodeScratch& at) const {
  const std::size_t size = at.members.size();
  at.warp.assign(size, glm::dvec3(0.0));
  for (int round = 0; round < kRounds; ++round) {
    at.matrix.assign(size * size, 0.0);
    at.right.assign(size, glm::dvec3(0.0));
    for (std::size_t m = 0; m < size; ++m) at.matrix[m * size + m] = 1.0;
    for (const auto& [meeting, weight] : at.here) {
      const std::size_t f = at.place[meeting->pair->fixed], m = at.place[meeting->pair->moving];
      // The fixed view shows at p what lies at p + warp there, so that is where the pair has to be asked.
      const glm::dvec3 pull = weight * meeting->motionAt(p + at.warp[f]);
      at.matrix[f * size + f] += weight;
      at.matrix[m * size + m] += weight;
      at.matrix[f * size + m] -= weight;
      at.matrix[m * size + f] -= weight;
      at.right[m] += pull;
      at.right[f] -= pull;
    }
    solve(at.matrix, at.right, size);
    at.warp = at.right;
  }
}

void BendingGroup::shareSlice(int k, const Progress& progress, std::vector<double>& disagreements) {
  NodeScratch at;
  at.place.resize(views_.size());
  for (int j = 0; j < lattice_.dims.y; ++j) {
    if (progress.cancelRequested()) return;
    for (int i = 0; i < lattice_.dims.x; ++i) {
      const std::size_t node = lattice_.indexOf(i, j, k);
      if (!gather(node, at)) continue;
      const glm::dvec3 p = carried(nodeToWorld_, glm::dvec3(i, j, k));
      solveNode(p, at);
      for (std::size_t m = 0; m < at.members.size(); ++m) group.warps[at.members[m]].displacement_mm[node] = glm::vec3(at.warp[m]);
      for (const auto& [meeting, weight] : at.here) {
        if (meeting->distance_mm[node] > 0.0F || meeting->pair->trust < 0.5) continue;
        const glm::dvec3 fixed = at.warp[at.place[meeting->pair->fixed]], moving = at.warp[at.place[meeting->pair->moving]];
        disagreements.push_back(glm::distance(moving - fixed, meeting->motionAt(p + fixed)));
      }
    }
  }
}

bool BendingGroup::shareWarps(Progress& progress) {
  std::vector<std::vector<double>> slices(static_cast<std::size_t>(lattice_.dims.z));
  const bool shared = forEachTask(lattice_.dims.z, options_.threads, progress, say<"Combining deformations">(),
                                  [&](int k) { shareSlice(k, progress, slices[static_cast<std::size_t>(k)]); });
  if (!shared || progress.cancelRequested()) return false;
  std::vector<double> disagreements;
  for (const auto& slice : slices) disagreements.insert(disagreements.end(), slice.begin(), slice.end());
  group.disagreementMedian_mm = disagreements.empty() ? 0.0 : quantileOf(std::span(disagreements), 0.5);
  group.disagreement95_mm = disagreements.empty() ? 0.0 : quantileOf(std::span(disagreements), 0.95);
  return true;
}

bool BendingGroup::unfoldAll(Progress& progress) {
  std::vector<double> jacobians(views_.size(), 1.0);
  const bool unfolded = forEachTask(static_cast<int>(views_.size()), options_.threads, progress, say<"Unfolding">(), [&](int task) {
    const auto v = static_cast<std::size_t>(task);
    registration::ControlGrid& warp = group.warps[v];
    for (const glm::vec3& each : warp.displacement_mm)
      group.largest_mm[v] = std::max(group.largest_mm[v], static_cast<double>(glm::length(each)));
    if (group.largest_mm[v] < kStill_mm) {
      warp = {};
      group.largest_mm[v] = 0.0;
      return;
    }
    unfold(warp, options_.leastJacobian);
    jacobians[v] = registration::jacobianOf(warp).smallest;
  });
  if (!unfolded || progress.cancelRequested()) return false;
  group.smallestJacobian = *std::min_element(jacobians.begin(), jacobians.end());
  return true;
}

}  // namespace

std::uint64_t forecastWarps_bytes(std::span<const Grid> placedGrids, std::size_t pairs, const WarpOptions& options) {
  const std::uint64_t nodes = latticeOver(placedGrids, options.fallOff_mm, options.node_mm).voxelCount();
  return nodes * (sizeof(glm::vec3) * (placedGrids.size() + 1) + sizeof(float) * (pairs + 1));
}

Result<GroupWarps> warpGroup(std::span<const ViewData* const> views, std::span<const Transform<frame::World, frame::View>> toWorld,
                             std::span<const PairWarp> pairs, const WarpOptions& options, Progress& progress) {
  PartOfProgress looking(progress, 0.0, 0.3), solving(progress, 0.3, 0.9), unfolding(progress, 0.9, 1.0);
  BendingGroup bending(views, toWorld, pairs, options);
  if (!bending.lookAtOverlaps(looking) || !bending.shareWarps(solving) || !bending.unfoldAll(unfolding))
    return failure(ErrorCode::cancelled, say<"The stitching was cancelled.">());
  return std::move(bending.group);
}

}  // namespace ew::stitching
