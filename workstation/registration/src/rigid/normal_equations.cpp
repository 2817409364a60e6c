#include "normal_equations.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ew/core/parallel.h"

namespace ew::registration {
namespace {

constexpr int kPlanesPerTask = 4;

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// rows of A = [1; [p]x], 6 x 3, so that J = A g
struct Lever {
  std::array<std::array<double, 3>, 6> rows;
};
Lever leverOf(const glm::dvec3& p, double unit) {
  return {{{{unit, 0, 0}, {0, unit, 0}, {0, 0, unit}, {0, -p.z, p.y}, {p.z, 0, -p.x}, {-p.y, p.x, 0}}}};
}

/// normal += scale * (A M B^T), and its transpose too when A and B differ
void addProduct(std::array<double, 36>& normal, const Lever& a, const Matrix3& m, const Lever& b, bool symmetric) {
  for (int r = 0; r < 6; ++r) {
    std::array<double, 3> am{};
    for (int s = 0; s < 3; ++s) am[s] = a.rows[r][0] * m[0][s] + a.rows[r][1] * m[1][s] + a.rows[r][2] * m[2][s];
    for (int c = 0; c < 6; ++c) {
      const double v = am[0] * b.rows[c][0] + am[1] * b.rows[c][1] + am[2] * b.rows[c][2];
      normal[6 * r + c] += v;
      if (!symmetric) normal[6 * c + r] += v;
    }
  }
}

Matrix3 toWorld(const double (&moment)[6], const glm::dmat3& axes) {
  const glm::dmat3 lattice(glm::dvec3(moment[0], moment[1], moment[2]), glm::dvec3(moment[1], moment[3], moment[4]),
                           glm::dvec3(moment[2], moment[4], moment[5]));
  const glm::dmat3 world = axes * lattice * glm::transpose(axes);
  Matrix3 out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out[r][c] = world[c][r];
  }
  return out;
}

/// One pass over a pair: where the rows of the fixed image lie in the moving one, and whither their sums go.
class PairPass {
 public:
  PairPass(const ComparableImage& fixed, const KernelImage& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
           const glm::dvec3& centre_mm, const PassOptions& options, const glm::ivec3& cubes, std::vector<PoseSums>* blockSums);

  /// @param mine where sums of this plane go when cubes have none of their own
  void addPlane(int k, PoseSums& mine) const;

 private:
  /// Voxels of a row whose mates lie in the moving image.
  struct Stretch {
    int begin = 0;
    int end = 0;
  };
  [[nodiscard]] Stretch insideOf(const glm::dvec3& start) const;
  void addRow(int j, int k, PoseSums& mine) const;
  void addDerivatives(const PoseRowSums& row, int j, int k, PoseSums& into) const;

  const ComparableImage& fixed_;
  const PassOptions& options_;
  glm::ivec3 dims_;
  glm::ivec3 movingDims_;
  glm::ivec3 cubes_;
  std::vector<PoseSums>* blockSums_;  ///< null: all cubes go into one sum
  glm::dmat4 toMovingVoxel_;
  glm::dmat4 toWorld_;  ///< from fixed voxels
  glm::dvec3 centre_mm_;
  glm::dmat3 axes_;      ///< of the fixed lattice, per mm
  glm::dvec3 alongRow_;  ///< mm per unit of the place along a row
  PoseRow common_;
};

PairPass::PairPass(const ComparableImage& fixed, const KernelImage& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                   const glm::dvec3& centre_mm, const PassOptions& options, const glm::ivec3& cubes, std::vector<PoseSums>* blockSums)
    : fixed_(fixed),
      options_(options),
      dims_(fixed.grid.dims),
      movingDims_(moving.grid.dims),
      cubes_(cubes),
      blockSums_(options.perBlock ? blockSums : nullptr),
      toMovingVoxel_((moving.grid.toVoxel<frame::Moving>() * fixedToMoving * fixed.grid.voxelTo<frame::Fixed>()).matrix),
      toWorld_(fixed.grid.voxelToWorld().matrix),
      centre_mm_(centre_mm),
      axes_(fixed.grid.directions * (1.0 / fixed.grid.spacing_mm.x)) {
  common_.fixedRow = dims_.x;
  common_.fixedPlane = dims_.x * dims_.y;
  common_.moving = moving.value.data();
  for (int a = 0; a < 3; ++a) {
    common_.movingDims[a] = movingDims_[a];
    common_.step[a] = static_cast<float>(toMovingVoxel_[0][a]);
    for (int b = 0; b < 3; ++b) common_.turn[3 * a + b] = static_cast<float>(toMovingVoxel_[a][b]);
  }
  common_.perLoss2 = options.lossScale > 0.0 ? static_cast<float>(1.0 / (options.lossScale * options.lossScale)) : 0.0F;
  common_.middle = static_cast<float>(0.5 * dims_.x);
  common_.perMiddle = static_cast<float>(2.0 / dims_.x);
  common_.derivatives = options.derivatives;
  alongRow_ = fixed.grid.directions[0] * (fixed.grid.spacing_mm.x / static_cast<double>(common_.perMiddle));
}

void PairPass::addPlane(int k, PoseSums& mine) const {
  for (int j = 1; j < dims_.y - 1; ++j) addRow(j, k, mine);
}

/// @param start the mate of voxel 0, in voxels of the moving image
PairPass::Stretch PairPass::insideOf(const glm::dvec3& start) const {
  double low = 1.0;
  double high = dims_.x - 1.0;
  for (int a = 0; a < 3; ++a) {
    const double step = toMovingVoxel_[0][a];
    const double top = movingDims_[a] - 1.001;
    if (std::abs(step) < 1e-9) {
      if (start[a] < 0.0 || start[a] > top) return {};
      continue;
    }
    const double to0 = (0.001 - start[a]) / step;
    const double toTop = (top - start[a]) / step;
    low = std::max(low, std::min(to0, toTop));
    high = std::min(high, std::max(to0, toTop));
  }
  if (!(low < high)) return {};
  const int begin = std::clamp(static_cast<int>(std::ceil(low)), 1, dims_.x - 1);
  return {begin, std::clamp(static_cast<int>(std::floor(high)) + 1, begin, dims_.x - 1)};
}

void PairPass::addRow(int j, int k, PoseSums& mine) const {
  const glm::dvec3 start(toMovingVoxel_ * glm::dvec4(0.0, j, k, 1.0));
  const Stretch inside = insideOf(start);
  if (inside.begin >= inside.end) return;
  PoseRow job = common_;
  const std::size_t at = fixed_.grid.indexOf(0, j, k);
  job.fixedValue = fixed_.value.data() + at;
  job.fixedWeight = fixed_.inner.data() + at;
  job.room = static_cast<std::ptrdiff_t>(fixed_.value.size() - at);
  for (int a = 0; a < 3; ++a) job.at[a] = static_cast<float>(start[a]);
  const int stretch = options_.blockVoxels > 0 ? options_.blockVoxels : dims_.x;
  for (int from = inside.begin / stretch * stretch; from < inside.end; from += stretch) {
    job.begin = std::max(inside.begin, from);
    job.end = std::min(inside.end, from + stretch);
    glm::ivec3 cube(0);
    if (options_.blockVoxels > 0) {
      cube = glm::ivec3(from, j, k) / options_.blockVoxels;
      if (options_.half >= 0 && ((cube.x + cube.y + cube.z) & 1) != options_.half) continue;
    }
    PoseRowSums row;
    sumPoseRow(job, row);
    if (row.count == 0.0) continue;
    PoseSums& into =
        blockSums_ != nullptr ? (*blockSums_)[(static_cast<std::size_t>(cube.z) * cubes_.y + cube.y) * cubes_.x + cube.x] : mine;
    into.PairSums::add(row);
    into.lowest = glm::min(into.lowest, glm::dvec3(job.begin, j, k));
    into.highest = glm::max(into.highest, glm::dvec3(job.end - 1, j, k));
    if (options_.derivatives) addDerivatives(row, j, k, into);
  }
}

/// The row's moments under its levers: the lever of a voxel is that of the row's middle plus the place along the row times that of
/// `alongRow_`, so that J J^T is a sum of three products.
void PairPass::addDerivatives(const PoseRowSums& row, int j, int k, PoseSums& into) const {
  const glm::dvec3 p(toWorld_ * glm::dvec4(0.5 * dims_.x, j, k, 1.0) - glm::dvec4(centre_mm_, 0.0));
  const Lever zeroth = leverOf(p, 1.0);
  const Lever first = leverOf(alongRow_, 0.0);
  addProduct(into.normal, zeroth, toWorld(row.moment[0], axes_), zeroth, true);
  addProduct(into.normal, zeroth, toWorld(row.moment[1], axes_), first, false);
  addProduct(into.normal, first, toWorld(row.moment[2], axes_), first, true);
  const glm::dvec3 right0 = axes_ * glm::dvec3(row.right[0][0], row.right[0][1], row.right[0][2]);
  const glm::dvec3 right1 = axes_ * glm::dvec3(row.right[1][0], row.right[1][1], row.right[1][2]);
  for (int q = 0; q < 6; ++q) {
    for (int s = 0; s < 3; ++s) into.right[q] += zeroth.rows[q][s] * right0[s] + first.rows[q][s] * right1[s];
  }
}

}  // namespace

KernelImage packed(const ComparableImage& image) {
  KernelImage out{image.grid, std::vector<float>(image.value.size())};
  for (std::size_t q = 0; q < image.value.size(); ++q) {
    const std::uint32_t weight = image.weight[q];
    float value = image.value[q];
    // A value of nothing with a weight would be a denormal number, which is slow.
    if (weight != 0 && std::abs(value) < 1e-6F) value = 1e-6F;
    out.value[q] = std::bit_cast<float>((std::bit_cast<std::uint32_t>(value) & ~255u) | weight);
  }
  return out;
}

void PairSums::add(const PairSums& other) {
  count += other.count;
  weight += other.weight;
  f += other.f;
  m += other.m;
  ff += other.ff;
  mm += other.mm;
  fm += other.fm;
  residual += other.residual;
  robustWeight += other.robustWeight;
  bothGradients += other.bothGradients;
  fixedGradient += other.fixedGradient;
  movingGradient += other.movingGradient;
}

void PoseSums::add(const PoseSums& other) {
  PairSums::add(other);
  for (int q = 0; q < 36; ++q) normal[q] += other.normal[q];
  for (int q = 0; q < 6; ++q) right[q] += other.right[q];
  lowest = glm::min(lowest, other.lowest);
  highest = glm::max(highest, other.highest);
}

double PoseSums::correlation() const {
  if (weight <= 0.0) return 0.0;
  const double vf = ff - f * f / weight;
  const double vm = mm - m * m / weight;
  if (!(vf > 1e-9 * weight) || !(vm > 1e-9 * weight)) return 0.0;
  return std::clamp((fm - f * m / weight) / std::sqrt(vf * vm), -1.0, 1.0);
}

double PoseSums::stiffness() const {
  const double mean = 0.25 * (fixedGradient + 2.0 * bothGradients + movingGradient);
  return bothGradients > 0.05 * mean ? std::max(1.0, mean / bothGradients) : 20.0;
}

double PoseSums::residualRms() const { return robustWeight > 0.0 ? std::sqrt(residual / robustWeight) : 0.0; }

bool sumOverPair(const ComparableImage& fixed, const KernelImage& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                 const glm::dvec3& centre_mm, const PassOptions& options, int threads, Progress& progress, PoseSums& sums,
                 std::vector<PoseSums>* blockSums) {
  sums = {};
  const glm::ivec3 dims = fixed.grid.dims;
  const glm::ivec3 cubes = options.blockVoxels > 0 ? (dims + options.blockVoxels - 1) / options.blockVoxels : glm::ivec3(1);
  if (options.perBlock && blockSums != nullptr) {
    blockSums->assign(static_cast<std::size_t>(cubes.x) * cubes.y * cubes.z, {});
  }
  const glm::ivec3 movingDims = moving.grid.dims;
  if (std::min({dims.x, dims.y, dims.z}) < 3 || std::min({movingDims.x, movingDims.y, movingDims.z}) < 2) return true;

  const PairPass pass(fixed, moving, fixedToMoving, centre_mm, options, cubes, blockSums);
  // Whole layers of cubes go to one task, so that no two tasks add to the same cube.
  const int planes = options.perBlock ? options.blockVoxels : kPlanesPerTask;
  const int tasks = (dims.z + planes - 1) / planes;
  std::vector<PoseSums> partial(tasks);
  const bool done = forEachTask(tasks, threads, progress, say<"Comparing images">(), [&](int task) {
    for (int k = std::max(1, task * planes); k < std::min(dims.z - 1, (task + 1) * planes); ++k) pass.addPlane(k, partial[task]);
  });
  if (!done) return false;
  for (const PoseSums& part : partial) sums.add(part);
  if (options.perBlock && blockSums != nullptr) {
    for (const PoseSums& part : *blockSums) sums.add(part);
  }
  return true;
}

}  // namespace ew::registration
