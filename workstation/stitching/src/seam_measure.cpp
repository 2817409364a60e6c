#include "seam_measure.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ew/core/contract.h"

namespace ew::stitching {
namespace {

constexpr int kBeside = 5;  // parallel surfaces on either side
constexpr double kCube_mm = 6.0;
constexpr double kPatch_mm = 24.0;  // the mean may step up here and down there: steps are taken patch by patch
constexpr double kFewestCubes = 5.0;
constexpr double kSlab_mm = 2.5;
constexpr double kLag_mm = 2.0;  // farther apart than speckle is correlated
constexpr double kFewestFaces = 20.0;

/// Levels are whole numbers: the median lies within the middle one as far as those below it leave room. Medians, because edges of tissue
/// make few but large differences.
std::optional<double> medianOf(const std::array<std::size_t, 256>& counts) {
  std::size_t all = 0;
  for (const std::size_t count : counts) all += count;
  if (all == 0) return std::nullopt;
  double below = 0.0;
  for (std::size_t level = 0; level < counts.size(); ++level) {
    const auto here = static_cast<double>(counts[level]);
    const double half = 0.5 * static_cast<double>(all);
    // Differences that round to 0 come from one side only.
    if (below + here >= half) return level == 0 ? 0.5 * half / here : static_cast<double>(level) - 0.5 + (half - below) / here;
    below += here;
  }
  return std::nullopt;
}

}  // namespace

void CommonPart::add(const std::array<int, 3>& key, const glm::dvec3& p_mm, double difference, double weight) {
  const glm::ivec3 patch(p_mm / kPatch_mm);
  Sums& sums = patches_[{key[0], key[1], key[2], patch.x, patch.y, patch.z}];
  sums.count += 1.0;
  sums.weight += weight;
  sums.first += difference;
  sums.second += difference * difference;
}

double CommonPart::rms() const {
  double sum = 0.0;
  double weight = 0.0;
  for (const auto& [place, sums] : patches_) {
    if (sums.count < kFewestCubes) continue;
    const double mean = sums.first / sums.count;
    const double scatter = (sums.second / sums.count - mean * mean) / (sums.count - 1.0);  // of the mean
    sum += sums.weight * (mean * mean - scatter);
    weight += sums.weight;
  }
  return weight > 0.0 ? std::sqrt(std::max(0.0, sum / weight)) : 0.0;
}

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
          const int farthest = 2 * reach.blend + reach.slab;
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
                  ++(n < reach.blend ? inside_ : outside_)[static_cast<std::size_t>(std::abs(grey(p) - grey(q)))];
                }
            }
          if (both < farthest) continue;
          const auto layer = [&](int from, std::ptrdiff_t face, std::ptrdiff_t towards) {
            int sum = 0;
            for (int n = from; n < from + reach.slab; ++n) sum += grey(face + n * towards);
            return static_cast<double>(sum) / reach.slab;
          };
          const glm::ivec3 place((glm::dvec3(corner + at) * spacing_mm_) / kCube_mm);
          Patch& patch = patches_[{axis, first, second, place.x, place.y, place.z}];
          patch.count += 1.0;
          patch.step += layer(reach.blend, index + step, step) - layer(reach.blend, index, -step);
        }
      }
  }
}

SeamVisibility SeamMeasure::result() const {
  SeamVisibility seen;
  seen.voxels = 2 * faces_;
  if (beside_ > 0.0) seen.derivativeRatio = across_ / beside_;
  const auto in = medianOf(inside_);
  const auto out = medianOf(outside_);
  if (in && out && *out > 0.0) seen.speckleRatio = *in / *out;
  CommonPart steps;
  for (const auto& [place, patch] : patches_)
    if (patch.count >= kFewestFaces)
      steps.add({place[0], place[1], place[2]}, kCube_mm * (glm::dvec3(place[3], place[4], place[5]) + 0.5), patch.step / patch.count,
                patch.count);
  seen.meanStep_db = kDbPerGrey * steps.rms();
  return seen;
}

SeamVisibility seamVisibility(const Volume& joined, std::span<const std::uint8_t> source, double blend_mm) {
  EW_EXPECTS(joined.echo.size() == joined.grid.voxelCount() && source.size() == joined.echo.size());
  SeamMeasure measure(joined.grid.spacing_mm, blend_mm);
  measure.look(glm::ivec3(0), joined.grid.dims, joined.echo, source, [] { return false; });
  return measure.result();
}

}  // namespace ew::stitching
