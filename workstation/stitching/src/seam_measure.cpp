#include "seam_measure.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"

namespace ew::stitching {
namespace {

constexpr int kBeside = 5;          // parallel surfaces on either side
constexpr double kPatch_mm = 12.0;  // the mean may step up here and down there: steps are taken patch by patch
constexpr double kSlab_mm = 2.5;
constexpr double kLag_mm = 3.0;  // farther apart than speckle is correlated
constexpr double kFewestFaces = 30.0;
constexpr double kDbPerGrey = 60.0 / 255.0;

}  // namespace

SeamMeasure::SeamMeasure(const glm::dvec3& spacing_mm, double blend_mm) : spacing_mm_(spacing_mm) {
  for (int axis = 0; axis < 3; ++axis) {
    Reach& reach = reach_[static_cast<std::size_t>(axis)];
    reach.blend = std::max(1, static_cast<int>(std::lround(blend_mm / spacing_mm[axis])));
    reach.slab = std::max(2, static_cast<int>(std::lround(kSlab_mm / spacing_mm[axis])));
    for (int a = 0; a < 3; ++a)
      reach.lag[static_cast<std::size_t>(a)] = a == axis ? 0 : std::max(1, static_cast<int>(std::lround(kLag_mm / spacing_mm[a])));
  }
}

void SeamMeasure::look(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> echo,
                       std::span<const std::uint8_t> source, const std::function<bool()>& stopped) {
  const std::ptrdiff_t strides[3] = {1, size.x, static_cast<std::ptrdiff_t>(size.x) * size.y};
  for (int k = 0; k < size.z; ++k) {
    if (stopped()) return;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        const glm::ivec3 at(i, j, k);
        const std::ptrdiff_t index = i + j * strides[1] + k * strides[2];
        const std::uint8_t first = source[static_cast<std::size_t>(index)];
        if (first == 0) continue;
        for (int axis = 0; axis < 3; ++axis) {
          const std::ptrdiff_t step = strides[axis];
          if (at[axis] + 1 >= size[axis]) continue;
          const std::uint8_t second = source[static_cast<std::size_t>(index + step)];
          if (second == 0 || second == first) continue;
          // How far each view runs on from the face, in voxels, as far as anyone asks.
          const Reach& reach = reach_[static_cast<std::size_t>(axis)];
          const int farthest = 3 * reach.blend + 2 * reach.slab;
          const auto run = [&](std::ptrdiff_t from, std::ptrdiff_t towards, std::uint8_t own, int room) {
            int length = 0;
            for (std::ptrdiff_t p = from; length < std::min(room, farthest) && source[static_cast<std::size_t>(p)] == own; p += towards)
              ++length;
            return length;
          };
          const int back = run(index, -step, first, at[axis] + 1);
          const int on = run(index + step, step, second, size[axis] - at[axis] - 1);
          const int both = std::min(back, on);
          const auto grey = [&](std::ptrdiff_t p) { return static_cast<int>(echo[static_cast<std::size_t>(p)]); };
          if (both >= kBeside + 1) {
            ++faces_;
            across_ += std::abs(grey(index + step) - grey(index));
            int sum = 0;
            for (int n = 1; n <= kBeside; ++n)
              sum += std::abs(grey(index + (n + 1) * step) - grey(index + n * step)) +
                     std::abs(grey(index - (n - 1) * step) - grey(index - n * step));
            beside_ += sum / (2.0 * kBeside);
          }
          // Deviation of speckle layer by layer: differences within a layer know nothing of a slope across the seam.
          const int outer = 2 * reach.blend + reach.slab;
          if (both >= outer)
            for (int n = 0; n < outer; ++n) {
              if (n >= reach.blend && n < 2 * reach.blend) continue;  // the foot of the blend is neither
              for (const std::ptrdiff_t p : {index - n * step, index + (n + 1) * step})
                for (int a = 0; a < 3; ++a) {
                  const int lag = reach.lag[static_cast<std::size_t>(a)];
                  if (a == axis || at[a] + lag >= size[a]) continue;
                  const std::ptrdiff_t q = p + lag * strides[a];
                  if (source[static_cast<std::size_t>(q)] != source[static_cast<std::size_t>(p)]) continue;
                  const double difference = std::abs(grey(p) - grey(q));
                  (n < reach.blend ? inside_ : outside_) += difference;
                  ++(n < reach.blend ? insideCount_ : outsideCount_);
                }
            }
          if (both < farthest) continue;
          const auto layer = [&](int from, std::ptrdiff_t face, std::ptrdiff_t towards) {
            int sum = 0;
            for (int n = from; n < from + reach.slab; ++n) sum += grey(face + n * towards);
            return static_cast<double>(sum) / reach.slab;
          };
          const glm::ivec3 place((glm::dvec3(corner + at) * spacing_mm_) / kPatch_mm);
          Patch& patch = patches_[{axis, first, second, place.x, place.y, place.z}];
          patch.count += 1.0;
          patch.nearFirst += layer(reach.blend, index, -step);
          patch.nearSecond += layer(reach.blend, index + step, step);
          patch.farFirst += layer(3 * reach.blend + reach.slab, index, -step);
          patch.farSecond += layer(3 * reach.blend + reach.slab, index + step, step);
        }
      }
  }
}

SeamVisibility SeamMeasure::result() const {
  SeamVisibility seen;
  seen.voxels = 2 * faces_;
  if (beside_ > 0.0) seen.derivativeRatio = across_ / beside_;
  if (insideCount_ > 0 && outsideCount_ > 0 && outside_ > 0.0)
    seen.speckleRatio = inside_ / static_cast<double>(insideCount_) / (outside_ / static_cast<double>(outsideCount_));
  double excess = 0.0;
  double faces = 0.0;
  for (const auto& [place, patch] : patches_) {
    if (patch.count < kFewestFaces) continue;
    // Tissue changes from layer to layer as well; what it does between layers of one view, equally far apart, is taken off.
    const double step = (patch.nearSecond - patch.nearFirst) / patch.count;
    const double one = (patch.farSecond - patch.nearSecond) / patch.count;
    const double other = (patch.nearFirst - patch.farFirst) / patch.count;
    excess += patch.count * (step * step - 0.5 * (one * one + other * other));
    faces += patch.count;
  }
  if (faces > 0.0) seen.meanStep_db = kDbPerGrey * std::sqrt(std::max(0.0, excess / faces));
  return seen;
}

SeamVisibility seamVisibility(const Volume& joined, std::span<const std::uint8_t> source, double blend_mm) {
  EW_EXPECTS(joined.echo.size() == joined.grid.voxelCount() && source.size() == joined.echo.size());
  SeamMeasure measure(joined.grid.spacing_mm, blend_mm);
  measure.look(glm::ivec3(0), joined.grid.dims, joined.echo, source, [] { return false; });
  return measure.result();
}

}  // namespace ew::stitching
