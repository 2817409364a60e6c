#include "ew/imaging/point_levels.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "ew/core/contract.h"
#include "row_kernels.h"

namespace ew {
namespace {

using detail::kLanesAtMost;
using detail::Loaded;

/// A rounding error at a face must not lose the outermost layer of centres, nor a volume of a single layer.
constexpr double kOnFace_voxel = 1e-6;

/// The eight neighbours of a point; along an axis of one voxel the two are that voxel.
struct Cell {
  std::size_t corner = 0;   ///< index of the lowest one
  std::size_t nearest = 0;  ///< index of the nearest one
  std::array<std::uint32_t, 3> fraction{};
};

/// Points seen that wait until a vector's worth of them is there, and the memory has answered.
class WaitingPoints {
 public:
  WaitingPoints(const Volume& volume, std::span<float> level) : echo_(volume.echo.data()), level_(level) {
    if (!volume.coverage.empty()) coverage_ = volume.coverage.data();
    const glm::ivec3& dims = volume.grid.dims;
    stride_ = {1, static_cast<std::size_t>(dims.x), static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y)};
    for (std::size_t a = 0; a < 3; ++a) {
      const int voxels = dims[static_cast<int>(a)];
      last_[a] = voxels - 1;
      lastCell_[a] = std::max(voxels - 2, 0);
      step_[a] = voxels > 1 ? stride_[a] : 0;
    }
  }

  void take(const glm::dvec3& p_voxel, std::size_t index) {
    Cell cell;
    if (!find(p_voxel, cell) || (coverage_ != nullptr && coverage_[cell.nearest] == 0)) return;
    const auto n = static_cast<std::size_t>(count_);
    announce(cell.corner);
    corner_[n] = cell.corner;
    index_[n] = index;
    for (std::size_t a = 0; a < 3; ++a) fraction_[a][n] = cell.fraction[a];
    if (++count_ == Loaded::kMost) finish();
  }

  void finish() {
    load(echo_, echoLoaded_);
    if (coverage_ != nullptr) load(coverage_, coverageLoaded_);
    std::array<float, Loaded::kMost + kLanesAtMost> found;
    detail::blendLoadedLevels(echoLoaded_, coverage_ != nullptr ? &coverageLoaded_ : nullptr,
                              {fraction_[0].data(), fraction_[1].data(), fraction_[2].data()}, count_, found.data());
    for (std::size_t n = 0; n < static_cast<std::size_t>(count_); ++n) level_[index_[n]] = found[n];
    count_ = 0;
  }

 private:
  [[nodiscard]] bool find(const glm::dvec3& p_voxel, Cell& cell) const {
    std::size_t toNearest = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double p = p_voxel[static_cast<int>(a)];
      if (!(p >= -kOnFace_voxel && p <= last_[a] + kOnFace_voxel)) return false;
      const auto position = static_cast<std::int64_t>(std::clamp(p, 0.0, last_[a]) * static_cast<double>(detail::kOneVoxel) + 0.5);
      const std::int64_t low = std::min(position >> detail::kFractionBits, lastCell_[a]);
      // On the last centre a whole voxel is one unit too much for 31 bits.
      const std::int64_t fraction = std::min(position - low * detail::kOneVoxel, std::int64_t{detail::kFractionMask});
      cell.fraction[a] = static_cast<std::uint32_t>(fraction);
      cell.corner += static_cast<std::size_t>(low) * stride_[a];
      if (fraction >= detail::kHalfVoxel) toNearest += step_[a];
    }
    cell.nearest = cell.corner + toNearest;
    return true;
  }

  /// Neighbours in a plane mostly lie on the lines of the memory that the one before asked for.
  void announce(std::size_t corner) {
    if (corner >> 6U == announced_) return;
    announced_ = corner >> 6U;
    for (const std::uint8_t* from : {echo_, coverage_}) {
      if (from == nullptr) continue;
      for (const std::size_t row : {std::size_t{0}, step_[1], step_[2], step_[1] + step_[2]}) detail::prefetch(from + corner + row);
    }
  }

  void load(const std::uint8_t* from, Loaded& loaded) const {
    const std::array<std::size_t, 4> rows{0, step_[1], step_[2], step_[1] + step_[2]};
    const bool single = step_[0] == 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(count_); ++n) {
      for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::uint8_t* first = from + corner_[n] + rows[row];
        const std::array<std::uint8_t, 2> pair{first[0], first[single ? 0 : 1]};
        std::memcpy(&loaded.pairs[row][n], pair.data(), pair.size());
      }
    }
  }

  const std::uint8_t* echo_;
  const std::uint8_t* coverage_ = nullptr;
  std::array<double, 3> last_{};
  std::array<std::int64_t, 3> lastCell_{};
  std::array<std::size_t, 3> stride_{};
  std::array<std::size_t, 3> step_{};  ///< to the other neighbour
  std::size_t announced_ = ~std::size_t{0};
  std::span<float> level_;
  int count_ = 0;
  std::array<std::size_t, Loaded::kMost> corner_;
  std::array<std::size_t, Loaded::kMost> index_;
  std::array<std::array<std::uint32_t, Loaded::kMost + kLanesAtMost>, 3> fraction_;  // vectors read, and forget, what lies beyond the last
  Loaded echoLoaded_;
  Loaded coverageLoaded_;
};

}  // namespace

void levelsAt(const Volume& volume, std::span<const glm::dvec3> points_voxel, std::span<float> level) {
  EW_EXPECTS(points_voxel.size() == level.size());
  EW_EXPECTS(volume.echo.size() == volume.grid.voxelCount());
  EW_EXPECTS(volume.coverage.empty() || volume.coverage.size() == volume.echo.size());
  std::fill(level.begin(), level.end(), kNothingSeen);
  if (volume.echo.empty()) return;
  WaitingPoints waiting(volume, level);
  for (std::size_t n = 0; n < points_voxel.size(); ++n) waiting.take(points_voxel[n], n);
  waiting.finish();
}

}  // namespace ew
