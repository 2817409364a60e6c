#include "ew/registration/quality.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "comparable.h"
#include "elastic/lattice.h"
#include "ew/core/order_statistics.h"
#include "ew/core/parallel.h"
#include "trilinear_cell.h"

namespace ew::registration {
namespace {

constexpr double kVoxel_mm = 1.5;          ///< of the images made comparable, where the volumes are large enough
constexpr std::size_t kLeastSamples = 27;  ///< of a window or block that says anything
constexpr std::size_t kPointsThereAndBack = 20000;

Error cancelledError() { return {ErrorCode::cancelled, say<"Assessing the registration was cancelled.">(), {}}; }

/// Fixed and moving at the places of the fixed side's comparable image.
struct Side {
  std::vector<float> moved;
  std::vector<float> weight;  ///< 0 where one of them has nothing
};

/// Trilinear; nothing where one of the corners has no weight.
void sample(const ComparableImage& image, const glm::dvec3& index, float& value, float& weight) {
  const auto cell = cellAt(image.grid, index);
  if (!cell) return;
  double v = 0.0, w = 0.0;
  const bool isWhole = cell->visit(image.grid, [&](std::size_t at, double part) {
    v += part * static_cast<double>(image.value[at]);
    w += part * static_cast<double>(image.weight[at]) / 255.0;
    return image.weight[at] != 0;
  });
  if (!isWhole) return;
  value = static_cast<float>(v);
  weight = static_cast<float>(w);
}

Result<Side> movedOnto(const ComparableImage& fixed, const ComparableImage& moving, const Deformation& fixedToMoving, int threads,
                       Progress& progress) {
  Side side{std::vector<float>(fixed.grid.voxelCount(), 0.0F), std::vector<float>(fixed.grid.voxelCount(), 0.0F)};
  const auto toFixed = fixed.grid.voxelTo<frame::Fixed>();
  const auto toIndex = moving.grid.toVoxel<frame::Moving>() * fixedToMoving.rigid;
  const bool warps = !fixedToMoving.control.displacement_mm.empty();
  const Lattice lattice(fixedToMoving.control);
  const bool finished = forEachTask(fixed.grid.dims.z, threads, progress, say<"Comparing">(), [&](int k) {
    for (int j = 0; j < fixed.grid.dims.y; ++j) {
      for (int i = 0; i < fixed.grid.dims.x; ++i) {
        const std::size_t n = fixed.grid.indexOf(i, j, k);
        if (fixed.weight[n] == 0) continue;
        glm::dvec3 p = (toFixed * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at;
        if (warps) p += lattice.displacementAt(p);
        sample(moving, carried(toIndex, p), side.moved[n], side.weight[n]);
        side.weight[n] *= static_cast<float>(fixed.weight[n]) / 255.0F;
      }
    }
  });
  if (!finished) return passOn(cancelledError());
  return side;
}

/// Weighted sums of one block, window or whole.
struct QualitySums {
  double w = 0.0, f = 0.0, m = 0.0, ff = 0.0, mm = 0.0, fm = 0.0;
  std::size_t count = 0;
  void add(double weight, double fixed, double moved) {
    w += weight;
    f += weight * fixed;
    m += weight * moved;
    ff += weight * fixed * fixed;
    mm += weight * moved * moved;
    fm += weight * fixed * moved;
    ++count;
  }
  [[nodiscard]] double correlation() const {
    if (!(w > 0.0)) return 0.0;
    const double varianceF = ff - f * f / w, varianceM = mm - m * m / w;
    if (!(varianceF > 1e-9 * w) || !(varianceM > 1e-9 * w)) return 0.0;
    return std::clamp((fm - f * m / w) / std::sqrt(varianceF * varianceM), -1.0, 1.0);
  }
};

QualitySums sumsOver(const ComparableImage& fixed, const Side& side, const glm::ivec3& low, const glm::ivec3& high) {
  QualitySums sums;
  for (int k = low.z; k < high.z; ++k)
    for (int j = low.y; j < high.y; ++j)
      for (int i = low.x; i < high.x; ++i) {
        const std::size_t n = fixed.grid.indexOf(i, j, k);
        if (side.weight[n] > 0.0F)
          sums.add(static_cast<double>(side.weight[n]), static_cast<double>(fixed.value[n]), static_cast<double>(side.moved[n]));
      }
  return sums;
}

/// How many voxels say the same as one: from the likeness of neighbours in both images.
double repetition(const ComparableImage& fixed, const Side& side) {
  const Grid& grid = fixed.grid;
  double all = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.dims[axis] < 2) continue;
    const std::size_t step = axis == 0 ? 1 : axis == 1 ? static_cast<std::size_t>(grid.dims.x) : grid.indexOf(0, 0, 1);
    double ff = 0.0, mm = 0.0, ffNext = 0.0, mmNext = 0.0;
    for (int k = 0; k + (axis == 2 ? 1 : 0) < grid.dims.z; ++k) {
      for (int j = 0; j + (axis == 1 ? 1 : 0) < grid.dims.y; ++j) {
        for (int i = 0; i + (axis == 0 ? 1 : 0) < grid.dims.x; ++i) {
          const std::size_t n = grid.indexOf(i, j, k);
          if (side.weight[n] <= 0.0F || side.weight[n + step] <= 0.0F) continue;
          ff += static_cast<double>(fixed.value[n] * fixed.value[n]);
          mm += static_cast<double>(side.moved[n] * side.moved[n]);
          ffNext += static_cast<double>(fixed.value[n] * fixed.value[n + step]);
          mmNext += static_cast<double>(side.moved[n] * side.moved[n + step]);
        }
      }
    }
    if (!(ff > 0.0) || !(mm > 0.0)) continue;
    const double likeness = std::clamp(ffNext / ff * mmNext / mm, 0.0, 0.98);
    all *= (1.0 + likeness) / (1.0 - likeness);
  }
  return all;
}

Agreement agreementOf(const ComparableImage& fixed, const ComparableImage& moving, const Side& side) {
  QualitySums sums;
  for (std::size_t n = 0; n < side.weight.size(); ++n)
    if (side.weight[n] > 0.0F)
      sums.add(static_cast<double>(side.weight[n]), static_cast<double>(fixed.value[n]), static_cast<double>(side.moved[n]));
  Agreement out;
  out.correlation = sums.correlation();
  const double voxel_mm3 = fixed.grid.spacing_mm.x * fixed.grid.spacing_mm.y * fixed.grid.spacing_mm.z;
  const double coverable = std::min(fixed.coveredVolume_mm3(), moving.coveredVolume_mm3());
  out.overlapShare = coverable > 0.0 ? std::min(1.0, static_cast<double>(sums.count) * voxel_mm3 / coverable) : 0.0;
  const double independent = static_cast<double>(sums.count) / repetition(fixed, side);
  out.chance = independent > 4.0 ? std::tanh(1.645 / std::sqrt(independent - 3.0)) : 1.0;
  return out;
}

/// Blocks of about `side_mm` that fill a grid evenly: no slivers at its end.
struct Blocks {
  glm::ivec3 dims;
  glm::ivec3 count;
  Blocks(const Grid& grid, double side_mm) : dims(grid.dims), count(1) {
    for (int axis = 0; axis < 3; ++axis)
      count[axis] = std::clamp(static_cast<int>(std::lround(std::min(1e6, dims[axis] * grid.spacing_mm[axis] / side_mm))), 1, dims[axis]);
  }
  [[nodiscard]] glm::ivec3 low(const glm::ivec3& block) const { return (dims * block) / count; }
  [[nodiscard]] glm::ivec3 high(const glm::ivec3& block) const { return (dims * (block + 1)) / count; }
};

/// Mean correlation over windows of side `window_mm` that hold enough of both.
double localCorrelation(const ComparableImage& fixed, const Side& side, double window_mm) {
  const Blocks blocks(fixed.grid, window_mm);
  double sum = 0.0;
  std::size_t count = 0;
  for (int c = 0; c < blocks.count.z; ++c) {
    for (int b = 0; b < blocks.count.y; ++b) {
      for (int a = 0; a < blocks.count.x; ++a) {
        const QualitySums sums = sumsOver(fixed, side, blocks.low({a, b, c}), blocks.high({a, b, c}));
        if (sums.count < kLeastSamples) continue;
        sum += sums.correlation();
        ++count;
      }
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

/// Central difference along an axis, per mm; false where a neighbour is missing.
bool slopes(const ComparableImage& fixed, const Side& side, const glm::ivec3& at, Eigen::Vector3d& ofFixed, Eigen::Vector3d& ofMoved) {
  const Grid& grid = fixed.grid;
  const std::size_t n = grid.indexOf(at.x, at.y, at.z);
  for (int axis = 0; axis < 3; ++axis) {
    ofFixed[axis] = ofMoved[axis] = 0.0;
    if (grid.dims[axis] == 1) continue;
    if (at[axis] == 0 || at[axis] + 1 == grid.dims[axis]) return false;
    const std::size_t step = axis == 0 ? 1 : axis == 1 ? static_cast<std::size_t>(grid.dims.x) : grid.indexOf(0, 0, 1);
    if (side.weight[n - step] <= 0.0F || side.weight[n + step] <= 0.0F) return false;
    const double per_mm = 0.5 / grid.spacing_mm[axis];
    ofFixed[axis] = per_mm * static_cast<double>(fixed.value[n + step] - fixed.value[n - step]);
    ofMoved[axis] = per_mm * static_cast<double>(side.moved[n + step] - side.moved[n - step]);
  }
  return true;
}

/// Expected error of a block's own shift: inverse(C) S inverse(C). C is what turns a score into a shift, the gradients both images have in
/// common, sum((gf gm^T + gm gf^T) / 2): grain that only one of them shows moves nothing. S is the covariance of the score sum(g r), taken
/// from its sums over cells of four voxels, within which neighbours repeat each other: the sandwich of robust statistics with clustered
/// data.
double uncertaintyOf(const ComparableImage& fixed, const Side& side, const glm::ivec3& low, const glm::ivec3& high) {
  constexpr int kCell = 4;
  Eigen::Matrix3d common = Eigen::Matrix3d::Zero(), score = Eigen::Matrix3d::Zero();
  std::size_t count = 0;
  Eigen::Vector3d f, m;
  for (int c = low.z; c < high.z; c += kCell) {
    for (int b = low.y; b < high.y; b += kCell) {
      for (int a = low.x; a < high.x; a += kCell) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int k = c; k < std::min(c + kCell, high.z); ++k) {
          for (int j = b; j < std::min(b + kCell, high.y); ++j) {
            for (int i = a; i < std::min(a + kCell, high.x); ++i) {
              const std::size_t n = fixed.grid.indexOf(i, j, k);
              if (side.weight[n] <= 0.0F || !slopes(fixed, side, {i, j, k}, f, m)) continue;
              const double w = static_cast<double>(side.weight[n]), r = static_cast<double>(fixed.value[n] - side.moved[n]);
              common += 0.5 * w * (f * m.transpose() + m * f.transpose());
              sum += 0.5 * w * r * (f + m);
              ++count;
            }
          }
        }
        score += sum * sum.transpose();
      }
    }
  }
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  if (count < kLeastSamples) return kOpen;
  // Axes of one voxel have no gradient and no shift to be found: they are left out.
  std::vector<int> axes;
  for (int axis = 0; axis < 3; ++axis)
    if (fixed.grid.dims[axis] > 1) axes.push_back(axis);
  const Eigen::Index size = static_cast<Eigen::Index>(axes.size());
  if (size == 0) return kOpen;
  Eigen::MatrixXd a(size, size), b(size, size);
  for (Eigen::Index p = 0; p < size; ++p) {
    for (Eigen::Index q = 0; q < size; ++q) {
      a(p, q) = common(axes[static_cast<std::size_t>(p)], axes[static_cast<std::size_t>(q)]);
      b(p, q) = score(axes[static_cast<std::size_t>(p)], axes[static_cast<std::size_t>(q)]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> shape(a);
  if (!(shape.eigenvalues()(0) > 1e-3 * shape.eigenvalues()(size - 1)) || !(shape.eigenvalues()(0) > 1e-6 * static_cast<double>(count)))
    return kOpen;  // flat: what is left is rounding
  const Eigen::MatrixXd inverse = a.inverse();
  return std::sqrt(std::max(0.0, (inverse * b * inverse).trace()));
}

Result<void> checkDeformations(const Transform<frame::Moving, frame::Fixed>& before, const Deformation& fixedToMoving,
                               const Deformation* backward) {
  if (auto rigid = checkRigid(before); !rigid) return passOn(rigid.error());
  if (auto rigid = checkRigid(fixedToMoving.rigid); !rigid) return passOn(rigid.error());
  if (backward != nullptr)
    if (auto rigid = checkRigid(backward->rigid); !rigid) return passOn(rigid.error());
  return {};
}

Result<void> checkQuality(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& before,
                          const Deformation& fixedToMoving, const Deformation* backward, const QualityOptions& options) {
  if (fixed.volume == nullptr || moving.volume == nullptr) return failure(ErrorCode::emptyVolume, say<"A volume is missing: name two.">());
  if (auto usable = checkInput(fixed, say<"fixed">()); !usable) return passOn(usable.error());
  if (auto usable = checkInput(moving, say<"moving">()); !usable) return passOn(usable.error());
  if (auto rigid = checkDeformations(before, fixedToMoving, backward); !rigid) return passOn(rigid.error());
  for (const auto& [value, name] : {std::pair{options.region_mm, "region_mm"}, std::pair{options.window_mm, "window_mm"}}) {
    if (!(value > 0.0) || !std::isfinite(value))
      return failure(ErrorCode::badField, say<"Regions and windows need a side above 0 mm.">(), {{"field", name}});
  }
  for (const Deformation* each : {&fixedToMoving, backward}) {
    if (each != nullptr && !each->control.displacement_mm.empty() &&
        each->control.displacement_mm.size() != each->control.nodes.voxelCount())
      return failure(ErrorCode::badField, say<"The deformation has another number of vectors than its lattice has nodes.">(),
                     {{"field", "control"}});
  }
  return {};
}

double shortestSide_mm(const Grid& grid) {
  double least = 1e300;
  for (int axis = 0; axis < 3; ++axis)
    if (grid.dims[axis] > 1) least = std::min(least, grid.dims[axis] * grid.spacing_mm[axis]);
  return least < 1e300 ? least : 1.0;
}

/// One assessment: its steps in the order in which they are done, and what they share.
class Assessment {
 public:
  Assessment(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& before,
             const Deformation& fixedToMoving, const QualityOptions& options, Progress& progress)
      : fixed_(fixed),
        moving_(moving),
        atStart_{before, {}},
        fixedToMoving_(fixedToMoving),
        options_(options),
        progress_(progress),
        grid_(fixed.volume->grid),
        movingToVoxel_(moving.volume->grid.toVoxel<frame::Moving>()),
        regions_(grid_, options.region_mm),
        covered_(numberOf(regions_.count - 1) + 1) {}

  /// Images free of gain.
  [[nodiscard]] Result<void> compareImages();
  /// Grey levels at the fixed volume's own voxels.
  [[nodiscard]] Result<void> compareGreys();
  [[nodiscard]] Result<void> lookAtRegions();
  [[nodiscard]] Result<void> goThereAndBack(const Deformation& backward);

  Quality quality;

 private:
  [[nodiscard]] Result<void> makeImages();
  void maskOutside();
  void compareGreysTo(const Volume& seen, bool after);
  [[nodiscard]] RegionQuality regionAt(const glm::ivec3& block) const;
  [[nodiscard]] std::optional<double> errorThereAndBack(std::size_t n, const Deformation& backward) const;
  [[nodiscard]] std::size_t numberOf(const glm::ivec3& block) const {
    return (static_cast<std::size_t>(block.z) * static_cast<std::size_t>(regions_.count.y) + static_cast<std::size_t>(block.y)) *
               static_cast<std::size_t>(regions_.count.x) +
           static_cast<std::size_t>(block.x);
  }

  const Input& fixed_;
  const Input& moving_;
  Deformation atStart_;
  const Deformation& fixedToMoving_;
  const QualityOptions& options_;
  Progress& progress_;
  const Grid& grid_;  ///< of the fixed volume
  Transform<frame::Voxel, frame::Moving> movingToVoxel_;
  ComparableImage fixedImage_;
  ComparableImage movingImage_;
  Side after_;
  std::vector<std::uint8_t> fixedMask_;
  Volume masked_;                         ///< the moving volume without what lies outside its beam, where it has no coverage
  const Volume* movingVolume_ = nullptr;  ///< that, or the input
  Blocks regions_;
  std::vector<std::size_t> covered_;  ///< voxels of each region that both sides cover
};

Result<void> Assessment::makeImages() {
  const double finest = std::min({grid_.spacing_mm.x, grid_.spacing_mm.y, grid_.spacing_mm.z});
  const double voxel_mm =
      std::max(finest, std::min({kVoxel_mm, shortestSide_mm(grid_) / 16.0, shortestSide_mm(moving_.volume->grid) / 16.0}));
  PartOfProgress preparing(progress_, 0.0, 0.4);
  const std::array<double, 1> sizes{voxel_mm};
  ComparableOptions comparable;
  comparable.threads = options_.threads;
  auto fixedImages = comparableImages(fixed_, sizes, comparable, preparing);
  if (!fixedImages) return passOn(fixedImages.error());
  auto movingImages = comparableImages(moving_, sizes, comparable, preparing);
  if (!movingImages) return passOn(movingImages.error());
  fixedImage_ = std::move(fixedImages->front());
  movingImage_ = std::move(movingImages->front());
  return {};
}

Result<void> Assessment::compareImages() {
  if (auto made = makeImages(); !made) return passOn(made.error());
  PartOfProgress comparing(progress_, 0.4, 0.6);
  auto before = movedOnto(fixedImage_, movingImage_, atStart_, options_.threads, comparing);
  if (!before) return passOn(before.error());
  auto after = movedOnto(fixedImage_, movingImage_, fixedToMoving_, options_.threads, comparing);
  if (!after) return passOn(after.error());
  after_ = std::move(*after);
  quality.before = agreementOf(fixedImage_, movingImage_, *before);
  quality.after = agreementOf(fixedImage_, movingImage_, after_);
  quality.localCorrelationBefore = localCorrelation(fixedImage_, *before, options_.window_mm);
  quality.localCorrelationAfter = localCorrelation(fixedImage_, after_, options_.window_mm);
  quality.jacobian = jacobianOf(fixedToMoving_.control);
  return {};
}

/// Where a volume has no coverage, black outside the sector must not count.
void Assessment::maskOutside() {
  fixedMask_ = coveredMask(*fixed_.volume);
  movingVolume_ = moving_.volume;
  if (!moving_.volume->coverage.empty()) return;
  masked_.grid = moving_.volume->grid;
  masked_.echo = moving_.volume->echo;
  masked_.coverage = coveredMask(*moving_.volume);
  for (std::uint8_t& c : masked_.coverage) c = static_cast<std::uint8_t>(c != 0 ? Coverage::measured : Coverage::absent);
  movingVolume_ = &masked_;
}

Result<void> Assessment::compareGreys() {
  maskOutside();
  PartOfProgress warping(progress_, 0.6, 0.9);
  for (const bool after : {false, true}) {
    PartOfProgress half(warping, after ? 0.5 : 0.0, after ? 1.0 : 0.5);
    const auto seen = warped(*movingVolume_, after ? fixedToMoving_ : atStart_, grid_, options_.threads, half);
    if (!seen) return passOn(seen.error());
    compareGreysTo(*seen, after);
  }
  return {};
}

/// @param seen  the moving volume on the fixed grid
/// @param after residuals and covered voxels are counted too
void Assessment::compareGreysTo(const Volume& seen, bool after) {
  QualitySums sums;
  double squares = 0.0;
  for (int k = 0; k < grid_.dims.z; ++k) {
    for (int j = 0; j < grid_.dims.y; ++j) {
      for (int i = 0; i < grid_.dims.x; ++i) {
        const std::size_t n = grid_.indexOf(i, j, k);
        if (fixedMask_[n] == 0 || seen.coverageAt(n) == Coverage::absent) continue;
        const int difference = static_cast<int>(fixed_.volume->echo[n]) - static_cast<int>(seen.echo[n]);
        sums.add(1.0, fixed_.volume->echo[n], seen.echo[n]);
        if (!after) continue;
        squares += static_cast<double>(difference) * difference;
        ++quality.residualHistogram[static_cast<std::size_t>(std::clamp((difference + 128) / 4, 0, 63))];
        ++covered_[numberOf((glm::ivec3(i, j, k) * regions_.count + regions_.count - 1) / regions_.dims)];
      }
    }
  }
  (after ? quality.greyCorrelationAfter : quality.greyCorrelationBefore) = sums.correlation();
  if (after && sums.count > 0) quality.residualRms_grey = std::sqrt(squares / static_cast<double>(sums.count));
}

Result<void> Assessment::lookAtRegions() {
  for (int c = 0; c < regions_.count.z; ++c) {
    if (progress_.cancelRequested()) return passOn(cancelledError());
    for (int b = 0; b < regions_.count.y; ++b) {
      for (int a = 0; a < regions_.count.x; ++a) {
        if (covered_[numberOf({a, b, c})] > 0) quality.regions.push_back(regionAt({a, b, c}));
      }
    }
  }
  return {};
}

RegionQuality Assessment::regionAt(const glm::ivec3& block) const {
  const glm::ivec3 low = regions_.low(block), high = regions_.high(block);
  RegionQuality region;
  region.centre_mm = (grid_.voxelToWorld() * Point<frame::Voxel>{0.5 * glm::dvec3(low + high - 1)}).at;
  region.voxels = covered_[numberOf(block)];
  // The block's voxels of the comparable image: those whose centres lie in it.
  const auto toImage = fixedImage_.grid.worldToVoxel() * grid_.voxelToWorld();
  const glm::dvec3 first = carried(toImage, glm::dvec3(low) - 0.5), last = carried(toImage, glm::dvec3(high) - 0.5);
  const glm::ivec3 from = glm::clamp(glm::ivec3(glm::ceil(first - 1e-9)), glm::ivec3(0), fixedImage_.grid.dims);
  const glm::ivec3 to = glm::clamp(glm::ivec3(glm::ceil(last - 1e-9)), glm::ivec3(0), fixedImage_.grid.dims);
  region.correlation = sumsOver(fixedImage_, after_, from, to).correlation();
  region.uncertainty_mm = uncertaintyOf(fixedImage_, after_, from, to);
  return region;
}

Result<void> Assessment::goThereAndBack(const Deformation& backward) {
  const std::size_t step = std::max<std::size_t>(1, grid_.voxelCount() / kPointsThereAndBack) | 1U;  // odd: walks through rows unevenly
  std::vector<double> errors;
  for (std::size_t n = 0; n < grid_.voxelCount(); n += step) {
    if (n % 1024 == 0 && progress_.cancelRequested()) return passOn(cancelledError());
    if (const auto error = errorThereAndBack(n, backward)) errors.push_back(*error);
  }
  if (!errors.empty()) {
    quality.inverseConsistencyMedian_mm = quantileOf(std::span(errors), 0.5);
    quality.inverseConsistency95_mm = quantileOf(std::span(errors), 0.95);
  }
  return {};
}

/// Nothing where a voxel, or its mate in the moving volume, is not covered.
std::optional<double> Assessment::errorThereAndBack(std::size_t n, const Deformation& backward) const {
  if (fixedMask_[n] == 0) return std::nullopt;
  const std::size_t nx = static_cast<std::size_t>(grid_.dims.x), ny = static_cast<std::size_t>(grid_.dims.y);
  const std::size_t i = n % nx, j = n / nx % ny, k = n / nx / ny;
  const glm::dvec3 voxel(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
  const glm::dvec3 p = (grid_.voxelToWorld() * Point<frame::Voxel>{voxel}).at;
  const glm::dvec3 there = movingPoint(fixedToMoving_, p);
  const Grid& movingGrid = moving_.volume->grid;
  const glm::ivec3 nearest(glm::round(carried(movingToVoxel_, there)));
  if (!movingGrid.contains(nearest)) return std::nullopt;
  if (movingVolume_->coverageAt(movingGrid.indexOf(nearest.x, nearest.y, nearest.z)) == Coverage::absent) return std::nullopt;
  return glm::length(movingPoint(backward, there) - p);
}

}  // namespace

Result<Quality> assessQuality(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& before,
                              const Deformation& fixedToMoving, const Deformation* backward, const QualityOptions& options,
                              Progress& progress) {
  if (auto usable = checkQuality(fixed, moving, before, fixedToMoving, backward, options); !usable) return passOn(usable.error());
  Assessment assessment(fixed, moving, before, fixedToMoving, options, progress);
  if (auto done = assessment.compareImages(); !done) return passOn(done.error());
  if (auto done = assessment.compareGreys(); !done) return passOn(done.error());
  if (auto done = assessment.lookAtRegions(); !done) return passOn(done.error());
  if (backward != nullptr)
    if (auto done = assessment.goThereAndBack(*backward); !done) return passOn(done.error());
  progress.report(say<"Comparing">(), 1.0);
  return std::move(assessment.quality);
}

}  // namespace ew::registration
